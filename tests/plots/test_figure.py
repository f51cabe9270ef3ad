"""Figures: files that can be read, that name their parts, and are the same every time."""

import math
import struct
import xml.etree.ElementTree as ElementTree
from itertools import combinations, product

import pytest
from conftest import process, python, run

from radcalc.plots import LINE, POINTS, Axis, Chart, Disc, Field, Mark, Plane, Polar, Series, figure
from radcalc.plots.curves import chromaticities
from radcalc.spectra.sources import spectrum

SVG = "{http://www.w3.org/2000/svg}"
CALLS = {
    "spectrum": ["spectrum", "LED-B3"],
    "photon": ["photon", "555nm"],
    "polar": ["point-source", "--flux", "800lm", "--half-angle", "30deg"],
    "fall-off": ["point-source", "--flux", "800lm", "--distance", "1m:10m:1m"],
    "sky": ["sky", "overcast", "--zenith-luminance", "9000cd/m2"],
    "environment": ["environment", "max(cos(theta), 0) cd/m2"],
    "integrand": ["integrate", "cos(theta)**2", "--hemisphere"],
}
LABELS = {
    "spectrum": ["wavelength λ [nm]", "relative spectral power", "V(λ) CIE 1924", "LED-B3"],
    "photon": ["wavelength λ [nm]", "555nm"],
    "polar": ["luminous intensity I [cd]", "0°", "90°"],
    "fall-off": ["distance d [m]", "illuminance $E_{\\mathrm{v}}$ [lx]", "flux 800lm"],
    "sky": ["luminance [cd/m²]", "0°", "90°", "180°", "270°"],
    "environment": ["luminance [cd/m²]"],
    "integrand": ["polar angle θ [deg]", "f(θ)", "f sin θ"],
}


@pytest.mark.parametrize("kind", CALLS)
def test_an_svg_is_xml_that_has_its_labels(tmp_path, kind):
    path = tmp_path / "a.svg"
    done = run(*CALLS[kind], "--plot", str(path))
    assert done.returncode == 0, done.stderr
    tree = ElementTree.parse(path)
    assert tree.getroot().tag == f"{SVG}svg"
    assert len(list(tree.iter(f"{SVG}path"))) > 5
    text = path.read_text(encoding="utf-8")
    assert [label for label in LABELS[kind] if f"<!-- {label} -->" not in text] == []
    assert done.stdout == run(*CALLS[kind]).stdout  # the numbers as without it
    assert [one.name for one in tmp_path.iterdir()] == ["a.svg"]


def test_a_figure_writes_its_file_and_nothing_else(tmp_path, monkeypatch):
    monkeypatch.delenv("MPLCONFIGDIR", raising=False)
    for name in ("HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "TMPDIR"):
        (tmp_path / name).mkdir()
        monkeypatch.setenv(name, str(tmp_path / name))
    done = process("spectrum", "D65", "--plot", str(tmp_path / "a.svg"), "-q")
    assert done.returncode == 0, done.stderr
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == ["a.svg"]
    assert len([*tmp_path.rglob("*")]) == 5


def test_a_png_is_one_of_a_readable_size(tmp_path):
    path = tmp_path / "a.PNG"
    assert run(*CALLS["polar"], "--plot", str(path)).returncode == 0
    data = path.read_bytes()
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    width, height = struct.unpack(">II", data[16:24])
    assert min(width, height) >= 600


@pytest.mark.parametrize("extension", figure.FORMATS)
def test_a_figure_is_the_same_every_time(extension):
    chart = Chart("t", Axis("x"), Axis("y"), [Series("s", [0.0, 1.0], [1.0, 2.0])])
    assert figure.data(chart, extension) == figure.data(chart, extension)


def test_a_figure_for_a_notebook_is_matplotlibs_and_leaves_its_settings_alone():
    import matplotlib

    before = dict(matplotlib.rcParams)
    made = figure.figure(
        Chart("t", Axis("x", "m"), Axis("y"), [Series("s", [0.0, 1.0], [1.0, 2.0])])
    )
    assert made.axes[0].get_xlabel() == "x [m]"
    assert made.axes[0].lines[0].get_ydata().tolist() == [1.0, 2.0]
    assert dict(matplotlib.rcParams) == before


def test_without_matplotlib_the_way_to_install_it_is_said(tmp_path):
    code = """
import sys
sys.modules["matplotlib"] = None
from radcalc.__main__ import run
sys.exit(run(sys.argv[1:]))
"""
    path = tmp_path / "a.svg"
    done = python(code, "spectrum", "D65", "--plot", str(path))
    assert (done.returncode, done.stdout) == (2, "")
    assert "figures need the package Matplotlib, which is missing" in done.stderr
    assert "pip install 'radcalc[plot]'" in done.stderr
    assert not path.exists()


@pytest.mark.parametrize(
    ("place", "said"),
    [
        ("a.pdf", "a figure cannot be written as .pdf"),
        ("none/a.svg", "does not exist"),
        ("folder.svg", "a folder, a pipe or a device"),
        ("folder/", "a figure cannot be written without an extension"),
    ],
)
def test_a_place_that_cannot_be_written_is_refused_before_anything_is_said(tmp_path, place, said):
    (tmp_path / "folder.svg").mkdir()
    (tmp_path / "folder").mkdir()
    done = run("spectrum", "D65", "--plot", f"{tmp_path}/{place}")
    assert (done.returncode, done.stdout) == (2, "")
    assert said in done.stderr
    assert "Traceback" not in done.stderr


def test_what_is_asked_for_wrongly_writes_no_file(tmp_path):
    path = tmp_path / "a.svg"
    done = run("spectrum", "D65", "-g", "speed", "--plot", str(path))
    assert (done.returncode, done.stdout, path.exists()) == (2, "", False)


def test_json_and_csv_stand_beside_a_figure(tmp_path):
    path = str(tmp_path / "a.svg")
    words = ["point-source", "--intensity", "100cd", "--distance", "1m,2m"]
    for form in ("json", "csv"):
        plain = run(*words, "--format", form)
        assert run(*words, "--format", form, "--plot", path).stdout == plain.stdout


def test_what_a_user_named_is_no_formula():
    names = ["$\\frac$", "_hidden", "a\x1bb", "光"]
    series = [Series(name, [0.0, 1.0], [0.0, float(k)]) for k, name in enumerate(names)]
    chart = Chart("$x", Axis("x"), Axis("y"), series)
    text = figure.data(chart, ".svg").decode()
    for said in ("$x", "_hidden", "a\\x1bb", "\\u5149"):  # the font has no 光
        assert f"<!-- {said} -->" in text or f"<!-- {said.replace('$', chr(92) + '$')} -->" in text


def chart_of(count):
    curves = [Series(f"flux {k}lm", [0.0, 1.0], [0.0, float(k)]) for k in range(1, count + 1)]
    return Chart("", Axis("x"), Axis("y"), curves)


def extents(drawing):
    """The edges of the figure, of its axes and of all its legends [pixels]."""
    drawing.draw_without_rendering()
    (axes,) = drawing.axes
    legends = [*drawing.legends, *filter(None, [axes.get_legend()])]
    return drawing.bbox, axes.get_window_extent(), [one.get_window_extent() for one in legends]


def test_of_too_many_curves_some_are_named_in_colours_of_their_own():
    (axes,) = figure.figure(chart_of(30)).axes
    texts = [one.get_text() for one in axes.get_legend().get_texts()]
    # evenly spaced in 1 to 30: every 29/7, rounded down
    assert texts == [f"flux {k}lm" for k in (1, 5, 9, 13, 17, 21, 25, 30)] + [
        "and 22 more, in this order"
    ]
    assert len({line.get_color() for line in axes.lines[:30]}) == 30


@pytest.mark.parametrize("count", [2, 10, 20, 30, 200])
def test_a_legend_is_inside_the_figure_and_leaves_the_chart_its_room(count):
    whole, axes, (legend,) = extents(figure.figure(chart_of(count)))
    assert whole.x0 <= legend.x0 < legend.x1 <= whole.x1
    assert whole.y0 <= legend.y0 < legend.y1 <= whole.y1
    assert axes.width > whole.width / 2


def test_curves_that_are_all_named_have_looks_of_their_own():
    (axes,) = figure.figure(chart_of(20)).axes
    looks = {
        (line.get_color(), line.get_linestyle(), str(line._dash_pattern)) for line in axes.lines
    }
    assert len(looks) == 20


def test_a_long_label_is_cut_and_does_not_take_the_room_of_the_chart():
    chart = chart_of(10)
    named = [one._replace(label=one.label * 20) for one in chart.series]
    whole, axes, (legend,) = extents(figure.figure(chart._replace(series=named)))
    assert whole.x0 <= legend.x0
    assert axes.width > whole.width / 3


@pytest.mark.parametrize("word", ["intensity 100cd, ", "a", "日本語", "$x_1$ "])
@pytest.mark.parametrize("count", [1, 5, 60])
def test_a_long_title_and_a_long_note_are_inside_the_figure(count, word):
    text = word * count
    fields = {"title": text, "note": text}
    xs = [0.0, 1.0, 2.0]
    rows = [[x + y for x in xs] for y in xs]
    value, length = Axis("E", "lx"), Axis("x", "m")
    for drawn in (
        chart_of(2),
        Polar("", value, [Plane("every C plane", [-90.0, 0.0, 90.0], xs)]),
        Field("", length, length, value, xs, xs, rows),
        Field("", length, length, value, xs, [0.0, 3.0, 6.0], rows),
        disc_of(lambda x, y: 1 + x * x),
    ):
        drawing = figure.figure(drawn._replace(**fields))
        drawing.draw_without_rendering()
        texts = [drawing._suptitle, drawing._supxlabel, drawing.axes[0]._left_title]
        boxes = [one.get_window_extent() for one in texts if one and one.get_text()]
        assert len(boxes) == 2
        for box in boxes:
            assert drawing.bbox.x0 <= box.x0 < box.x1 <= drawing.bbox.x1
            assert drawing.bbox.y0 <= box.y0 < box.y1 <= drawing.bbox.y1


@pytest.mark.parametrize("size", [(6, 9), (9, 6), (20, 4), (2, 18), (5, 5)])
def test_a_plan_is_to_scale_and_uses_the_figure(size):
    wide, high = size
    xs, ys = [0.0, wide / 2, float(wide)], [0.0, high / 2, float(high)]
    rows = [[x + y for x in xs] for y in ys]
    drawing = figure.figure(
        Field("t", Axis("x", "m"), Axis("y", "m"), Axis("E", "lx"), xs, ys, rows)
    )
    drawing.draw_without_rendering()
    box = drawing.axes[0].get_window_extent()
    assert box.width / box.height == pytest.approx(wide / high, rel=0.02)
    assert max(box.width / drawing.bbox.width, box.height / drawing.bbox.height) > 0.75


def test_a_band_is_filled_between_its_ends_and_a_bar_joins_them():
    x, y = [1.0, 2.0, 3.0], [1.0, 4.0, 9.0]
    band = [0.5, 3.5, 8.0], [1.5, 4.5, 10.0]
    curve, points = (Series(style, x, y, style, band) for style in (LINE, POINTS))
    chart = Chart("", Axis("x"), Axis("y"), [curve], note="band: k = 1")
    drawing = figure.figure(chart)
    (filled,) = drawing.axes[0].collections
    ends = {(round(px, 6), round(py, 6)) for px, py in filled.get_paths()[0].vertices}
    assert ends >= {*zip(x, band[0], strict=True), *zip(x, band[1], strict=True)}
    assert drawing.get_supxlabel() == "band: k = 1"
    assert drawing.axes[0].get_ylim()[1] >= 10
    (bars,) = figure.figure(chart._replace(series=[points])).axes[0].collections
    assert [bar.tolist() for bar in bars.get_segments()] == [
        [[px, low], [px, high]] for px, low, high in zip(x, *band, strict=True)
    ]


def test_numbers_of_an_axis_have_no_factor_above_it():
    chart = Chart("t", Axis("x"), Axis("y"), [Series("s", [0.0, 0.3], [0.0, 2e9])])
    drawing = figure.figure(chart)
    drawing.draw_without_rendering()
    (axes,) = drawing.axes
    assert axes.yaxis.get_offset_text().get_text() == ""
    assert axes.get_yticklabels()[-1].get_text() == "2e+09"
    assert [one.get_text() for one in axes.get_xticklabels()][1:4] == ["0", "0.05", "0.1"]


def disc_of(value):
    places = [k / 20 - 1 for k in range(41)]
    rows = [[value(x, y) for x in places] for y in places]
    return Disc("", Axis("luminance", "cd/m2"), rows, [("up", 0)], is_image=True, note="n")


def test_an_image_with_a_softbox_has_a_logarithmic_scale_up_to_its_peak():
    softbox = disc_of(lambda x, y: 200.0 if math.hypot(x - 0.5, y) < 0.06 else 1.0)
    _, bar = figure.figure(softbox).axes
    assert bar.get_ylabel() == "luminance [cd/m²], log scale"
    assert bar.get_ylim() == pytest.approx((1.0, 200.0))


def test_a_sun_is_beyond_the_scale_in_white_and_the_sky_keeps_its_contrast():
    sun = disc_of(lambda x, y: 1e9 if (x, y) == (0.5, 0.0) else 3000 + 1000 * x)
    drawn, bar = figure.figure(sun).axes
    mesh = drawn.collections[0]
    assert mesh.get_clim() == (pytest.approx(2000), pytest.approx(4000))
    assert mesh.cmap(mesh.norm(1e9)) == (1.0, 1.0, 1.0, 1.0)
    assert bar.get_ylabel() == "luminance [cd/m²], linear scale"


@pytest.mark.parametrize("value", [0.0, 5.0])
def test_an_even_image_states_its_value_without_a_scale(value):
    (axes,) = figure.figure(disc_of(lambda x, y: value)).axes
    assert f"luminance [cd/m²], {value:g} everywhere" in [one.get_text() for one in axes.texts]


LAMPS = ["D65", "LED-B3", "HPS", "FL2", "A", "FL4", "LED-B1", "LED-B2", "LED-B5", "FL3", "E"]


def boxes(drawn):
    """Return the boxes of the labels of marks, without the lines to their marks."""
    from matplotlib.text import Text

    axes, *_ = drawn.axes
    return {text.get_text(): Text.get_window_extent(text) for text in axes.texts}


def test_labels_of_lights_cover_neither_each_other_nor_the_legend():
    drawn = figure.figure(chromaticities([spectrum(name) for name in LAMPS]))
    (axes,) = drawn.axes
    found = boxes(drawn)
    assert {*LAMPS} < found.keys()
    every = [*found.values(), axes.get_legend().get_window_extent()]
    assert not any(a.overlaps(b) for a, b in combinations(every, 2))


def test_lamps_at_the_edge_are_named_inside_the_plan_or_listed_below():
    places = list(product(range(5), range(3)))
    lamps = [Mark(f"lamp-{x}-{y}", float(x), float(y)) for x, y in places]
    plan = Field(
        "plan", Axis("x", "m"), Axis("y", "m"), Axis("illuminance E_v", "lx"),
        [0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 1.0, 2.0],
        [[x * 10.0 + y for x in range(5)] for y in range(3)], lamps,
    )  # fmt: skip
    drawn = figure.figure(plan)
    named = {text: box for text, box in boxes(drawn).items() if text.startswith("lamp-")}
    inside = drawn.axes[0].bbox
    assert len(named) > len(lamps) // 2
    assert all(inside.contains(*box.min) and inside.contains(*box.max) for box in named.values())
    assert not any(a.overlaps(b) for a, b in combinations(named.values(), 2))
    listed = drawn._supxlabel.get_text() if len(named) < len(lamps) else ""
    assert listed.count("lamp-") == len(lamps) - len(named)
