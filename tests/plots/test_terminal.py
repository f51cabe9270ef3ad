"""Pictures in characters: within the width, at their places, with colour or without."""

import math
import re
import sys
from types import SimpleNamespace

import pytest
from helpers import terminal_of
from rich.cells import cell_len

from radcalc.plots import (
    LINES,
    POINTS,
    REFERENCE,
    Axis,
    Chart,
    Field,
    Mark,
    Plane,
    Polar,
    Series,
    characters,
)
from radcalc.plots.characters import Style, draw, style_of
from radcalc.plots.sheet import Sheet
from radcalc.terminal import columns_of, cut, fold

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
EACH = [CHART, CIRCLE, HALF, SLOPE]
IDS = ["chart", "circle", "half", "field"]
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
    assert draw(even, Style(80)).splitlines()[-1] == "illuminance E_v [lx], 5 everywhere"


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


def many(count):
    return [Series(f"flux {k}lm", [0.0, 1.0], [0.0, float(k)]) for k in range(1, count + 1)]


def test_of_too_many_curves_some_are_named_and_the_others_are_counted():
    lines = draw(Chart("", Axis("x"), Axis("y"), many(30)), Style(80)).splitlines()
    legend = " ".join(lines[-2:])
    # evenly spaced in 1 to 30: every 29/7, rounded down
    assert re.findall(r"(\d) ⠤⠤ flux (\d+)lm", legend) == [
        (str(k), str(flux)) for k, flux in enumerate((1, 5, 9, 13, 17, 21, 25, 30), start=1)
    ]
    assert legend.endswith("and 22 more, in this order")


@pytest.mark.parametrize("width", [60, 80, 120])
@pytest.mark.parametrize("count", [2, 10, 20, 21, 200])
def test_a_legend_of_many_curves_fits_below_the_chart(count, width):
    lines = draw(Chart("", Axis("x"), Axis("y"), many(count)), Style(width)).splitlines()
    assert max(map(len, lines)) <= width
    below = lines[next(k for k, line in enumerate(lines) if "└" in line) :]
    assert len(below) <= 3 + -(-count * 17 // (width - 17))
    named = "".join(lines).count("flux")
    assert named == (count if count <= 20 else 8)
    counted = re.search(r"and (\d+) more", below[-1])
    assert (int(counted[1]) if counted else 0) == count - named


def test_each_number_on_a_curve_is_that_of_the_legend():
    """Vertical lines have no number, also before the curves."""
    first = Series("lines", [0.5], [0.2], LINES)
    low, high = (Series(name, [0.0, 1.0], [y, y]) for name, y in (("low", 0.0), ("high", 1.0)))
    lines = draw(Chart("", Axis("x"), Axis("y"), [first, low, high]), Style(60)).splitlines()
    assert lines[-1] == "⢸⡇ lines  1 ⠤⠤ low  2 ⠤⠤ high"
    drawn = {name.strip(): row for name, _, row in (line.partition("┤") for line in lines)}
    assert ("2" in drawn["1"], "1" in drawn["0"]) == (True, True)


# -- uncertain values ------------------------------------------------------------------------------


def dots(text):
    """The places of dots: rows from the top, columns after the axis; four rows for a character."""
    bits = ((0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1), (3, 0), (3, 1))  # Unicode, Braille
    return {
        (4 * row + down, 2 * column + right)
        for row, column in cells(text)
        for k, (down, right) in enumerate(bits)
        if ord(rows_of(text)[row][column]) - 0x2800 >> k & 1
    }


def rows_of(text):
    return [line.partition("┤")[2] or line.partition("│")[2] for line in text.splitlines()]


def test_a_band_has_dots_at_both_ends_and_fewer_than_its_curve():
    y = [5.0] * 17
    level = Series("", [float(k) for k in range(17)], y, band=([2.5] * 17, [7.5] * 17))
    chart = Chart("", Axis("x"), Axis("y", limits=(0.0, 10.0)), [level])
    found = dots(draw(chart, Style(80)))
    by_row = {row: sum(r == row for r, _ in found) for row, _ in found}
    (top, upper), (middle, own), (bottom, lower) = sorted(by_row.items())
    steps = bottom - middle, middle - top
    assert steps == pytest.approx((0.25 * 64, 0.25 * 64), abs=1)  # 64 dots for 10
    assert upper == lower == pytest.approx(own / 3, rel=0.05)


def test_the_bar_of_a_point_is_as_long_as_its_uncertainty():
    point = Series("", [0.0, 1.0, 2.0], [5.0] * 3, POINTS, ([5.0, 2.5, 5.0], [5.0, 7.5, 5.0]))
    chart = Chart("", Axis("x"), Axis("y", limits=(0.0, 10.0)), [point], note="bar: k = 1")
    text = draw(chart, Style(80))
    columns = [column for _, column in dots(text)]
    longest = max(columns, key=columns.count)
    assert columns.count(longest) == pytest.approx(0.5 * 62, abs=2)  # 62 of 64 rows for 10
    assert text.splitlines()[-1] == "bar: k = 1"


def test_a_point_at_an_end_of_the_axes_is_whole():
    corner = Series("", [0.0, 1.0], [10.0, 0.0], POINTS)
    found = dots(draw(Chart("", Axis("x"), Axis("y"), [corner]), Style(80)))
    assert len(found) == 10  # two crosses of 5 dots


# -- plans -----------------------------------------------------------------------------------------


def plan(wide, high, steps=12):
    xs = [wide * k / steps for k in range(steps + 1)]
    ys = [high * k / steps for k in range(steps + 1)]
    # the greatest value is at x = 0, y = high: on the left at the back
    rows = [[y / high - x / wide for x in xs] for y in ys]
    marks = [Mark("lamp", 0.0, 0.9 * high)]
    return Field("plan", Axis("x", "m"), Axis("y", "m"), Axis("E", "lx"), xs, ys, rows, marks)


@pytest.mark.parametrize("width", [60, 80, 120])
@pytest.mark.parametrize("size", [(6, 9), (9, 6), (3, 9), (20, 4)])
def test_a_plan_is_to_scale(size, width):
    lines = draw(plan(*size), Style(width)).splitlines()
    rule = next(line for line in lines if "└" in line)
    columns = len(rule) - rule.index("└") - 1
    rows = sum("┤" in line or "│" in line for line in lines)
    assert columns > 0.85 * width or rows == min(max(22, width * 2 // 7), 32)
    assert rows == pytest.approx(columns * size[1] / size[0] / 2, abs=1)  # characters are 2:1


def test_a_high_terminal_has_a_higher_plan_and_a_larger_circle():
    for picture in (plan(6, 6), CIRCLE):
        unknown, small, large = (
            len(draw(picture, Style(120, height=height)).splitlines()) for height in (0, 24, 60)
        )
        assert small <= unknown < large <= 60


def test_a_label_without_room_on_the_right_is_on_the_left():
    near = SLOPE._replace(marks=[Mark(f"lamp{k}", 1.0 + 0.1 * k, 1.0) for k in range(2)])
    text = draw(near, Style(80))
    assert re.search(r"lamp0\+ *\S*\+lamp1", text)


def test_a_label_keeps_a_blank_from_others_and_marks_without_room_are_listed():
    crowd = SLOPE._replace(marks=[Mark(f"lamp{k}", 2.0 + 0.02 * k, 1.0) for k in range(12)])
    text = draw(crowd, Style(80))
    plan, found, listed = text.partition("without room for a name: ")
    assert found
    listed = listed.replace("\n", " ")
    for k in range(12):
        shown = re.search(rf"(?<!\w)lamp{k}(?!\w)", plan)
        assert bool(shown) != (f"lamp{k}" in re.split(r",? | and ", listed)), k


def test_radii_with_long_numbers_do_not_run_together():
    bright = [1.2e6 * value for value in LOWER]
    spot = Polar("spot", Axis("I", "cd"), [Plane("every C plane", ANGLES, bright)])
    for width in (50, 60, 80):
        numbers = draw(spot, Style(width)).splitlines()[1].split()
        assert {*numbers} <= {"250000", "500000", "750000", "1e+06"}


# -- wide letters ----------------------------------------------------------------------------------

WORDS = ["灯台の光", "조명 기구", "ｆｕｌｌ", "cafe\u0301", "ไฟส่อง", "e\u0301" * 5, "日本" * 60]


@pytest.mark.parametrize("word", [*WORDS, *"aé中ｱ가ก\u0301"])
def test_letters_are_as_wide_as_another_program_counts_them(word):
    assert columns_of(word) == cell_len(word)


@pytest.mark.parametrize("width", [40, 60, 80, 120])
@pytest.mark.parametrize("word", WORDS)
@pytest.mark.parametrize("picture", EACH, ids=IDS)
def test_wide_letters_stay_within_the_terminal(picture, word, width):
    named = picture._replace(title=word)
    if isinstance(picture, Chart):
        series = [one._replace(label=word) for one in picture.series]
        named = named._replace(series=series, marks=[(word, 2.0)], note=word)
    elif isinstance(picture, Polar):
        named = named._replace(planes=[one._replace(label=word) for one in picture.planes])
    else:
        named = named._replace(marks=[Mark(word, mark.x, mark.y) for mark in picture.marks])
    lines = draw(named, Style(width)).splitlines()
    assert max(map(cell_len, lines)) <= width
    assert word in "".join(line.strip() for line in lines) or " " in word
    plain = draw(picture, Style(width)).splitlines()
    if isinstance(picture, Field):  # each row of the plan keeps its width
        assert all(cell_len(line) <= width for line in lines[: len(plain)])


@pytest.mark.parametrize("encoding", ["ascii", "utf-8"])
def test_the_frame_of_a_plan_does_not_move_for_wide_letters(encoding):
    style = Style(80, ascii=encoding == "ascii")
    even = SLOPE._replace(rows=[[5.0] * 5] * 3)
    plain, wide = (
        draw(even._replace(marks=[Mark(name, 1.0, 1.0), Mark("end", 3.5, 1.0)]), style)
        for name in ("lamp", "灯e\u0301灯")
    )
    ends = [
        cell_len(line.partition("+end")[0])
        for text in (plain, wide)
        for line in text.splitlines()
        if "+end" in line
    ]
    assert ends[0] == ends[1]
    assert ("灯e\u0301灯" in wide) is (encoding == "utf-8")
    assert ("\\u706fe\\u0301\\u706f" in wide) is (encoding == "ascii")


def test_half_of_a_wide_letter_is_not_drawn():
    sheet = Sheet(10, 1, (0.0, 1.0), (0.0, 1.0))
    sheet.write(0, 0, "光光光光光")
    sheet.write(3, 0, "ab")
    sheet.write(9, 0, "光")
    (line,) = sheet.lines(Style(10))
    assert line == "光 ab 光光"
    assert cell_len(line) == 10


@pytest.mark.parametrize(
    ("text", "width", "expected"),
    [
        ("日本語の照明", 6, ["日本語", "の照明"]),
        ("a 日本語 b", 6, ["a", "日本語", "b"]),
        ("ab cd", 2, ["ab", "cd"]),
        ("日本", 1, ["日", "本"]),
    ],
)
def test_a_line_of_wide_letters_is_folded(text, width, expected):
    assert fold(text, width) == expected


@pytest.mark.parametrize(
    ("text", "width", "expected"),
    [("abcdef", 6, "abcdef"), ("abcdefg", 6, "abc..."), ("日本語の", 7, "日本...")],
)
def test_a_text_is_cut_at_whole_letters(text, width, expected):
    assert cut(text, width) == expected


def luminance(palette_number):
    """Return the relative luminance of a colour of the 6 x 6 x 6 cube (WCAG 2.1, xterm's steps)."""
    steps = (0, 95, 135, 175, 215, 255)
    number = palette_number - 16
    parts = [steps[k] / 255 for k in (number // 36, number // 6 % 6, number % 6)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return sum(w * c for w, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


@pytest.mark.parametrize("call", ["spectrum LED-B3 --plot", "spectrum E --plot"])
def test_colours_of_wavelengths_are_readable_on_white_and_on_black(call):
    """A contrast of 3 for graphics: WCAG 2.1, criterion 1.4.11."""
    numbers = {int(n) for n in re.findall(r"38;5;(\d+)m", terminal_of(*call.split()))}
    assert len(numbers) > 5
    ramp = {int(color.rpartition(";")[2]) for color in characters.RAMP}
    for number in numbers | ramp:
        assert 1.05 / (luminance(number) + 0.05) > 3, number
        assert (luminance(number) + 0.05) / 0.05 > 3, number
