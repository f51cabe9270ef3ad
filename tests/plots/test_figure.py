"""Figures: files that can be read, that say what is drawn, and are the same every time."""

import struct
import xml.etree.ElementTree as ElementTree

import pytest
from conftest import process, python, run

from radcalc.plots import figure
from radcalc.plots.data import Axis, Chart, Series

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
    for said in ("$x", "_hidden", "a\\x1bb", "光"):
        assert f"<!-- {said} -->" in text or f"<!-- {said.replace('$', chr(92) + '$')} -->" in text


def test_of_too_many_curves_the_first_and_the_last_are_named_in_colours_of_their_own():
    many = [Series(f"flux {k}lm", [0.0, 1.0], [0.0, float(k)]) for k in range(1, 31)]
    (axes,) = figure.figure(Chart("", Axis("x"), Axis("y"), many)).axes
    legend = axes.get_legend()
    assert [one.get_text() for one in legend.get_texts()] == ["flux 1lm", "flux 30lm"]
    assert legend.get_title().get_text() == "30 curves; the first and the last:"
    assert len({line.get_color() for line in axes.lines}) == 30
