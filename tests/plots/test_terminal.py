"""How pictures stand in characters: within the width, at their places, with colour or without."""

import math
import re
import sys
from types import SimpleNamespace

import pytest

from radcalc.plots.characters import Style, draw, style_of
from radcalc.plots.data import (
    LINES,
    REFERENCE,
    Axis,
    Chart,
    Disc,
    Field,
    Mark,
    Plane,
    Polar,
    Series,
)

CHART = Chart(
    "a line",
    Axis("distance d", "m"),
    Axis("illuminance E_v", "lx"),
    [
        Series("line", [0.0, 10.0], [0.0, 100.0]),
        Series("V(λ)", [0.0, 10.0], [100.0, 0.0], REFERENCE),
        Series("lines", [5.0], [50.0], LINES),
    ],
    [("here", 2.0)],
)
ANGLES = [float(a) for a in range(-180, 181)]
CIRCLE = Polar(
    "circle", Axis("luminous intensity I_v", "cd"), [Plane("every C plane", ANGLES, [10.0] * 361)]
)
LOWER = [max(math.cos(math.radians(a)), 0.0) if abs(a) < 90 else 0.0 for a in ANGLES]
HALF = Polar("lobe", Axis("relative intensity"), [Plane("every C plane", ANGLES, LOWER)])
SLOPE = Field(
    "slope",
    Axis("x", "m"),
    Axis("y", "m"),
    Axis("illuminance E_v", "lx"),
    [0.0, 1.0, 2.0, 3.0, 4.0],
    [0.0, 1.0, 2.0],
    [[0.0, 100.0, 200.0, 300.0, 400.0]] * 3,
    [Mark("lamp", 3.5, 1.0)],
)
PLACES = [k / 20 - 1 for k in range(41)]
DOME = Disc(
    "dome",
    Axis("luminance", "cd/m2"),
    [[1000 - 500 * math.hypot(x, y) for x in PLACES] for y in PLACES],
    [("0°", 0), ("90°", 90), ("180°", 180), ("270°", 270)],
    "zenith",
    [Mark("sun", 0.5, 0.0)],
)
EACH = [CHART, CIRCLE, HALF, SLOPE, DOME, DOME._replace(is_image=True)]
IDS = ["chart", "circle", "half", "field", "disc", "image"]
BRAILLE = re.compile("[\u2801-\u28ff]")


@pytest.mark.parametrize("width", [40, 60, 80, 120, 200])
@pytest.mark.parametrize("picture", EACH, ids=IDS)
def test_a_picture_is_no_wider_than_the_terminal_and_no_higher_than_one(picture, width):
    lines = draw(picture, Style(width)).splitlines()
    assert max(map(len, lines)) <= width
    assert len(lines) <= 38
    assert all(line == line.rstrip() for line in lines)


@pytest.mark.parametrize("picture", EACH, ids=IDS)
def test_a_picture_in_ascii_has_no_other_letters(picture):
    text = draw(picture, Style(80, ascii=True))
    assert text.isascii()
    assert picture.title in text


@pytest.mark.parametrize("picture", EACH, ids=IDS)
def test_colour_changes_nothing_but_the_colours(picture):
    plain, colored = (draw(picture, Style(80, color)) for color in (False, True))
    assert "\033" not in plain
    assert "\033[" in colored
    bare = re.sub("\033\\[[0-9;]*m", "", colored)
    assert [line.rstrip() for line in bare.splitlines()] == plain.splitlines()


@pytest.mark.parametrize("picture", EACH, ids=IDS)
def test_no_line_leaves_a_colour_on(picture):
    for line in draw(picture, Style(80, color=True)).splitlines():
        assert not re.search("\033\\[(?!0)[0-9;]*m(?!.*\033\\[0m)", line)


def test_an_axis_has_its_unit_and_round_numbers():
    lines = draw(CHART, Style(80)).splitlines()
    assert lines[0] == "a line"
    assert lines[1].strip() == "illuminance E_v [lx]"
    assert [line.split("┤")[0].strip() for line in lines if "┤" in line] == [
        "100",
        "80",
        "60",
        "40",
        "20",
        "0",
    ]
    assert lines[-3].split() == ["0", "2", "4", "6", "8", "10"]
    assert lines[-2].strip() == "distance d [m]"
    assert lines[-1] == "⠤⠤ line  ⠄⠄ V(λ)  ⢸⡇ lines"


def cells(text):
    """The places of dots: lines from the top, columns behind the axis."""
    rows = [line.partition("┤")[2] or line.partition("│")[2] for line in text.splitlines()]
    return {(r, c) for r, row in enumerate(rows) for c, x in enumerate(row) if BRAILLE.match(x)}


def test_a_line_from_corner_to_corner_is_one():
    text = draw(CHART._replace(series=CHART.series[:1], marks=()), Style(80))
    found = cells(text)
    rows, columns = zip(*found, strict=True)
    corners = (max(rows), min(columns)), (min(rows), max(columns))
    assert set(corners) <= found
    slope = (max(columns) - min(columns)) / (max(rows) - min(rows))
    assert all(abs((max(rows) - r) * slope - c) <= slope for r, c in found)


def test_the_ends_of_a_curve_of_a_thousand_points_are_in_the_picture():
    x = [k / 1000 for k in range(1001)]
    chart = Chart("", Axis("x"), Axis("y"), [Series("", x, [v * v for v in x])])
    assert max(c for _, c in cells(draw(chart, Style(80)))) == 80 - len("0.25┤") - 2 + 0


def test_a_logarithmic_axis_has_powers_of_ten():
    chart = Chart(
        "",
        Axis("d", "m", is_log=True),
        Axis("E", "lx", is_log=True),
        [Series("", [0.1, 10.0], [1e4, 1.0])],
    )
    text = draw(chart, Style(80))
    assert [line.split("┤")[0].strip() for line in text.splitlines() if "┤" in line] == [
        "10000",
        "1000",
        "100",
        "10",
        "1",
    ]


def test_a_polar_diagram_points_down_and_has_its_upper_half_where_there_is_light():
    circle, half = (draw(one, Style(80)) for one in (CIRCLE, HALF))
    assert "180°" in circle
    assert "180°" not in half
    assert "120°" not in half
    assert half.count("90°") == half.count("30°") == half.count("60°") == 2
    assert half.splitlines()[-3].strip() == "0°"
    assert "luminous intensity I_v [cd], circles every 2" in circle


def test_contours_have_their_numbers_and_marks_their_names():
    text = draw(SLOPE, Style(80))
    for level in ("50", "100", "150", "200", "250", "300", "350"):
        assert re.search(rf"(?<!\d){level}(?!\d)", text), level
    assert "+lamp" in text
    assert text.splitlines()[-1] == "illuminance E_v [lx], from 0 to 400"


def test_a_contour_is_where_the_value_is():
    """Of a plane that rises along x, each is upright at its own x."""
    rows = [
        line.partition("┤")[2] or line.partition("│")[2]
        for line in draw(SLOPE, Style(80)).splitlines()
    ]
    row = next(
        row for row in rows if row.startswith(" ") and not re.search("[0-9a-z]", row) and row
    )
    places = [c for c, letter in enumerate(row) if BRAILLE.match(letter)]
    step = (places[-1] - places[0]) / (len(places) - 1)
    assert len(places) == 7  # 50, 100 ... 350
    assert all(abs(place - places[0] - k * step) <= 1 for k, place in enumerate(places))


def test_what_rounding_leaves_of_0_is_told_as_0():
    """3000 cos 90 deg is 1.8e-13 in floats; 1e-6 of the greatest value is a value."""
    dark = SLOPE._replace(rows=[[3000 * math.cos(math.pi / 2), 10.0, 1000.0, 2000.0, 3000.0]] * 3)
    assert draw(dark, Style(80)).splitlines()[-1].endswith(", from 0 to 3000")
    dim = SLOPE._replace(rows=[[0.003, 10.0, 1000.0, 2000.0, 3000.0]] * 3)
    assert draw(dim, Style(80)).splitlines()[-1].endswith(", from 0.003 to 3000")


def test_an_even_field_has_no_contours():
    even = SLOPE._replace(rows=[[5.0] * 5] * 3)
    assert draw(even, Style(80)).splitlines()[-1] == "illuminance E_v [lx], from 5 to 5"


@pytest.mark.parametrize(
    ("encoding", "has"),
    [("utf-8", True), ("ascii", False), ("latin-1", False), (None, False), ("no such", False)],
)
def test_a_picture_is_of_braille_where_the_encoding_has_it(monkeypatch, encoding, has):
    monkeypatch.setattr(sys, "stdout", SimpleNamespace(encoding=encoding))
    assert style_of(80).ascii is not has


def test_what_a_user_named_does_not_steer_the_terminal():
    named = SLOPE._replace(title="a\033[31mb", marks=[Mark("\033]0;x\a", 1.0, 1.0)])
    text = draw(named, Style(80))
    assert "\033" not in text
    assert "a\\x1b[31mb" in text


def test_a_curve_far_beyond_the_axis_is_cut_and_takes_no_time():
    far = Chart("", Axis("x", limits=(0.0, 1.0)), Axis("y"), [Series("", [-1e9, 1e9], [0.0, 1.0])])
    rows = {r for r, _ in cells(draw(far, Style(80)))}
    assert len(rows) == 1  # level, in the middle


def test_of_too_many_curves_the_first_and_the_last_are_named():
    many = [Series(f"flux {k}lm", [0.0, 1.0], [0.0, float(k)]) for k in range(1, 31)]
    lines = draw(Chart("", Axis("x"), Axis("y"), many), Style(80)).splitlines()
    assert lines[-2] == "30 curves; the first and the last:"
    assert lines[-1].split("  ") == ["⠤⠤ flux 1lm", "⠤⠤ flux 30lm"]
    assert len(lines) < 30
