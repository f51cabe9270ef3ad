"""Pictures in characters: Braille dots or ASCII, with axes and units."""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import Any

from radcalc import plots
from radcalc.answer import in_ascii
from radcalc.errors import printable
from radcalc.plots import levels, limits, log_ticks, rings, span, texts, ticks
from radcalc.plots.sheet import (
    APART,
    BEHIND,
    DIM,
    NARROWEST,
    PLAIN,
    Piece,
    Point,
    Sheet,
    Style,
    below,
    beside,
    blot,
    caption,
    dotted,
    heading,
    legend,
    line,
    sample,
)
from radcalc.terminal import can_show, columns_of, cut, fold

Scale = Callable[[float], float]  # from a value to its position on an axis
Cell = tuple[int, int]  # column and row of a character

BRAILLE = "\u28ff"  # a Braille character
IN_ASCII = str.maketrans(
    {"°": " deg", "\u2032": "'", "µ": "u", "μ": "u", "×": "x", "·": ".", "☉": "*", "∥": "||",
     "│": "|", "─": "-", "└": "+", "┬": "+", "┤": "+"}
)  # fmt: skip
COLORS = ("32", "35", "36", "31", "34", "33")  # green first: visible on light and on dark
MARKS = "*+o#x%@&"  # of curves, in ASCII
LEAST, MOST = 10, 24  # rows of a chart
FLATTEST = 4  # least rows of a plan
AROUND = 7  # lines around a picture that is as high as the terminal
SHARE = 5  # columns for each row of a chart
GRID = 4  # distance of the dots in circles and rays of a polar diagram
RIM, RIM_IN_ASCII = 6, 9  # columns on each side of a circle, for labels
SMALLEST, LARGEST = 22, 32  # most rows of a circle or a plan
ROUND = 360  # pieces of a circle
RAMP = [f"38;5;{n}" for n in (62, 67, 66, 65, 100, 136, 166, 160)]  # colours of ordered curves
# Relative luminances of the steps of red, green and blue in the palette, by the curve of sRGB, and
# those of colours with a contrast of at least 3 to black and to white (WCAG 2.1).
LUMINANCES = [0.0, 0.1144, 0.2423, 0.4287, 0.6795, 1.0]
DARKEST, LIGHTEST = 0.1, 0.3


def style_of(width: int = 80, height: int = 0, color: bool = False) -> Style:
    """Return the style for standard output: ASCII if its encoding has no Braille."""
    return Style(width, color, not can_show(BRAILLE), height)


def draw(picture: plots.Picture, style: Style) -> str:
    """Return a picture, not one of `IN_A_FILE`, as lines of text, no wider than the style."""
    ways: dict[type, Callable[[Any, Style], list[str]]] = {
        plots.Chart: _chart,
        plots.Polar: _polar,
        plots.Field: _field,
    }
    style = style._replace(width=max(style.width, NARROWEST))
    picture = _in_ascii(picture) if style.ascii else picture  # before it is laid out
    lines = ways[type(picture)](picture, style)
    text = "".join(f"{line.rstrip()}\n" for line in lines)
    return in_ascii(text.translate(IN_ASCII)) if style.ascii else text


def _in_ascii(item: Any) -> Any:
    """Return a picture, or a part of it, with its texts in ASCII."""
    if isinstance(item, str):
        text = in_ascii(item.translate(IN_ASCII))
        return text.encode("ascii", "backslashreplace").decode()
    if isinstance(item, tuple) and hasattr(item, "_fields"):
        return type(item)(*map(_in_ascii, item))
    if isinstance(item, (list, tuple)) and not (item and isinstance(item[0], (int, float))):
        return [*map(_in_ascii, item)]
    return item


# -- polar diagrams --------------------------------------------------------------------------------


def _polar(polar: plots.Polar, style: Style) -> list[str]:
    """Draw the axis downwards, and only the lower half if the upper half is dark."""
    circles, is_half = rings(polar.most), polar.is_half
    names, outer = texts(circles), circles[-1]
    rim, degrees = (RIM_IN_ASCII, " deg") if style.ascii else (RIM, "\u00b0")
    radius = min(style.width - 2 * rim, (4 if is_half else 2) * (_tall(style) - 2))  # in dots
    columns, rows = radius + 2 * rim, -(-radius // (4 if is_half else 2)) + 2
    dot = outer / (radius - 1)
    top = 5 if is_half else 2 * rows
    sheet = Sheet(
        columns, rows, (-columns * dot, columns * dot), ((top - 4 * rows) * dot, top * dot)
    )
    grid = sheet.layer(DIM, BEHIND)
    reach = plots.RIGHT if is_half else 180.0
    for size in circles:
        circle = [_turned(size, angle) for angle in _degrees(-reach, reach)]
        dotted(grid, pairwise(circle), GRID)
    for angle in range(-180, 180, 30):
        if abs(angle) <= reach:
            dotted(grid, [((0.0, 0.0), _turned(outer, angle))], GRID)
            _write_at_rim(sheet, f"{abs(angle)}{degrees}", *_turned(outer, angle), dot)
    for size, name in [*zip(circles, names, strict=True)][-2::-1]:  # of the outer ones first
        column, row = sheet.place(size, 0.0)
        column, row = column - len(name) // 2, row - 1 if is_half else row
        if sheet.is_free(column - 1, row, len(name) + 2):
            sheet.write(column, row, name, "2")
    entries = _planes(polar, sheet, style)
    indent = " " * ((style.width - columns) // 2)
    caption_text = f"{polar.radius.title}, circles every {names[0]}"
    return [
        *heading(polar.title, style),
        *(indent + line for line in sheet.lines(style)),
        *caption(caption_text, 0, style.width),
        *legend(entries, style),
        *heading(polar.note, style),
    ]


def _planes(polar: plots.Polar, sheet: Sheet, style: Style) -> list[tuple[str, str, str]]:
    """Draw the planes of a polar diagram; return their entries in the legend."""
    entries = []
    for k, plane in enumerate(polar.planes):
        color, mark = COLORS[k % len(COLORS)], MARKS[k % len(MARKS)]
        canvas = sheet.layer(color, mark)
        points = [_turned(v, a) for a, v in zip(plane.angles, plane.values, strict=True)]
        for sizes in plane.band or ():
            ends = [_turned(v, a) for a, v in zip(plane.angles, sizes, strict=True)]
            dotted(canvas, pairwise(ends))
        if k == 0:
            line(canvas, pairwise(points))
        else:
            dotted(canvas, pairwise(points))
        look = sample(plots.LINE if k == 0 else plots.REFERENCE, mark, style)
        entries.append((look, color, plane.label))
    return entries


def _turned(size: float, angle: float) -> Point:
    """Return the position of a value at an angle [deg] from straight down."""
    turn = math.radians(angle)
    return size * math.sin(turn), -size * math.cos(turn)


def _degrees(low: float, high: float) -> list[float]:
    return [low + (high - low) * k / ROUND for k in range(ROUND + 1)]


def _write_at_rim(sheet: Sheet, text: str, x: float, y: float, dot: float) -> None:
    """Write next to a point of a circle about the origin, outside it."""
    size = math.hypot(x, y)
    column, row = sheet.place(x + 4 * dot * x / size, y + 4 * dot * y / size)
    if abs(x) < size / 100:
        column -= len(text) // 2
    elif x < 0:
        column -= len(text) - 1
    sheet.write(column, row, text)


def _tall(style: Style) -> int:
    """Return the most rows of a picture: as the terminal has, or by the width if unknown."""
    if style.height:
        return max(style.height - AROUND, SMALLEST)
    return min(max(style.width * 2 // 7, SMALLEST), LARGEST)


# -- plans ---------------------------------------------------------------------------------------


def _field(field: plots.Field, style: Style) -> list[str]:
    """Draw the contours of a plan, to scale."""
    (left, right), (bottom, top) = x_ends, y_ends = [(v[0], v[-1]) for v in (field.xs, field.ys)]
    y_ticks = ticks(*y_ends, 6)
    names = texts(y_ticks)
    margin = max(map(len, names)) + 2
    columns = style.width - margin - 1
    rows = round(columns * (top - bottom) / (right - left) / 2)
    rows = min(max(rows, FLATTEST), _tall(style))
    columns = min(columns, max(round(2 * rows * (right - left) / (top - bottom)), LEAST))
    sheet = Sheet.between(columns, rows, x_ends, y_ends)
    unnamed = _write_marks(sheet, field.marks)
    _contours(sheet, field)
    x_ticks = ticks(*x_ends, max(columns // 10, 2))
    value_span = span([value for row in field.rows for value in row])
    return [
        *heading(field.title, style),
        *beside(field.y, sheet, dict(zip(y_ticks, names, strict=True)), margin, style),
        *below(field.x, sheet, dict(zip(x_ticks, texts(x_ticks), strict=True)), margin, style),
        *fold(f"{field.value.title}, {value_span}", style.width),
        *heading(unnamed, style),
        *heading(field.note, style),
    ]


def _write_marks(sheet: Sheet, marks: Sequence[plots.Mark]) -> str:
    """Write each mark, and its label on its right or left; return a note of those without room."""
    places = [sheet.place(mark.x, mark.y) for mark in marks]
    for column, row in places:
        sheet.write(column, row, "+")
    unnamed = []
    for mark, (column, row) in zip(marks, places, strict=True):
        label = cut(printable(mark.label), sheet.columns - 1)
        size = columns_of(label)
        for start, outer in ((column + 1, column + 1 + size), (column - size, column - size - 1)):
            if sheet.is_free(start, row, size) and sheet.is_free(outer, row, 1, inside=False):
                sheet.write(start, row, label)
                break
        else:
            unnamed.append(mark.label)
    return plots.nameless(unnamed)


def _contours(sheet: Sheet, field: plots.Field) -> None:
    """Draw contours with their numbers, far from each other and from marks."""
    found = levels([value for row in field.rows for value in row])
    taken = [sheet.place(mark.x, mark.y) for mark in field.marks]
    for k, (level, name) in enumerate(zip(found, texts(found), strict=True)):
        color = _on_ramp(k, len(found))
        pieces = [*_segments(field.xs, field.ys, field.rows, level)]
        line(sheet.layer(color, MARKS[k % len(MARKS)]), pieces)
        _name_contour(sheet, {sheet.place(*start) for start, _ in pieces}, name, color, taken)


def _on_ramp(k: int, count: int) -> str:
    return RAMP[k * (len(RAMP) - 1) // max(count - 1, 1)]


def _name_contour(sheet: Sheet, cells: set[Cell], name: str, color: str, taken: list[Cell]) -> None:
    """Write a number in the cell of a contour that is farthest from the cells taken."""
    half = len(name) // 2

    def room(cell: Cell) -> tuple[float, int, int]:
        apart = [abs(cell[0] - c) / len(name) + abs(cell[1] - r) for c, r in taken]
        return min(apart, default=0.0), *cell

    free = [cell for cell in cells if sheet.is_free(cell[0] - half - 1, cell[1], len(name) + 2)]
    if free:
        column, row = max(free, key=room)
        taken.append((column, row))
        sheet.write(column - half, row, name, color)


def _segments(
    xs: plots.Values, ys: plots.Values, rows: Sequence[plots.Values], level: float
) -> Iterator[Piece]:
    """Yield the straight pieces of a contour, each across a triangle, half a cell."""
    for (y0, low), (y1, high) in pairwise(zip(ys, rows, strict=True)):
        for i in range(len(xs) - 1):
            z = low[i], low[i + 1], high[i], high[i + 1]
            if not min(z) <= level <= max(z):
                continue
            a, b = (xs[i], y0, z[0]), (xs[i + 1], y0, z[1])
            c, d = (xs[i], y1, z[2]), (xs[i + 1], y1, z[3])
            for corners in ((a, b, d), (a, c, d)):
                crossed = [
                    _between(start, end, level)
                    for start, end in pairwise((*corners, corners[0]))
                    if (start[2] < level) != (end[2] < level)
                ]
                if len(crossed) == 2:
                    yield crossed[0], crossed[1]


def _between(
    start: tuple[float, float, float], end: tuple[float, float, float], level: float
) -> Point:
    share = (level - start[2]) / (end[2] - start[2])
    return start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])


# -- charts ----------------------------------------------------------------------------------------


def _chart(chart: plots.Chart, style: Style) -> list[str]:
    """Draw curves, marks and bands between axes."""
    rows = min(max(style.width // SHARE, LEAST), MOST)
    x_of, y_of = _scale(chart.x.is_log), _scale(chart.y.is_log)
    values = [y for series in chart.series for y in series.heights]
    y_ends, y_ticks = _ends(chart.y, values, rows // 3 + 1)
    places = [x for series in chart.series for x in series.x]
    names = texts(y_ticks)
    margin = max(map(len, names)) + 2
    columns = style.width - margin - 1
    x_ends, x_ticks = _ends(chart.x, places, max(columns // 10, 2), is_round=False)
    size = (x_of(x_ends[0]), x_of(x_ends[1])), (y_of(y_ends[0]), y_of(y_ends[1]))
    has_points = any(series.style == plots.POINTS for series in chart.series)
    sheet = Sheet.between(columns, rows, *size, edge=1 if has_points else 0)
    for label, place in chart.marks:
        _upright(sheet, x_of(place), label)
    entries = _draw_series(chart, sheet, x_of, y_of, style)
    y_numbers = {y_of(y): name for y, name in zip(y_ticks, names, strict=True)}
    x_numbers = {x_of(x): name for x, name in zip(x_ticks, texts(x_ticks), strict=True)}
    return [
        *heading(chart.title, style),
        *beside(chart.y, sheet, y_numbers, margin, style),
        *below(chart.x, sheet, x_numbers, margin, style),
        *legend(entries, style),
        *heading(chart.note, style),
    ]


def _draw_series(
    chart: plots.Chart, sheet: Sheet, x_of: Scale, y_of: Scale, style: Style
) -> list[tuple[str, str, str]]:
    """Return the entries in the legend."""
    entries, drawn = [], []
    count = len(chart.curves)
    colors = _hues(chart, sheet) if count == 1 else PLAIN
    named = chart.named
    is_numbered = sum(chart.series[k].style in (plots.LINE, plots.POINTS) for k in named) > 1
    for k, series in enumerate(chart.series):
        color, mark = COLORS[k % len(COLORS)], MARKS[k % len(MARKS)]
        if chart.is_crowd:
            color = _on_ramp(k, count)
        if series.style == plots.REFERENCE:
            color, mark, colors = DIM, BEHIND, PLAIN
        elif colors:
            color = ""
        canvas = sheet.layer(color, mark, colors)
        points = [(x_of(x), y_of(y)) for x, y in zip(series.x, series.y, strict=True)]
        if series.band:
            low, high = (
                [(x_of(x), y_of(y)) for x, y in zip(series.x, values, strict=True)]
                for values in series.band
            )
            _band(canvas, low, high, series.style, sheet)
        _curve(canvas, points, series.style, sheet)
        if k in named:
            look = sample(series.style, mark, style)
            if series.style in (plots.LINE, plots.POINTS) and is_numbered:
                drawn.append((dict(sheet.place(*point) for point in points), color))
                look = f"{len(drawn)} {look}"
            entries.append((look, color, series.label))
    _number(sheet, drawn)
    return [*entries, ("", "", chart.more)] if chart.more else entries


def _upright(sheet: Sheet, x: float, label: str) -> None:
    """Draw a vertical line over the full height, with its name."""
    canvas = sheet.layer(DIM, "|")
    canvas.line(x, sheet.y[0], x, sheet.y[1])
    column = sheet.column(x)
    size = columns_of(label)
    is_left = column + 2 + size > sheet.columns and size < column
    sheet.write(column - 1 - size if is_left else column + 2, 0, label)


def _curve(canvas: Any, points: list[Point], style: str, sheet: Sheet) -> None:
    """Draw a line through points, dots, or vertical lines below them."""
    if style == plots.LINES:
        for x, y in points:
            canvas.line(x, sheet.y[0], x, y)
        return
    if style == plots.REFERENCE:
        dotted(canvas, _inside(points, sheet))
        return
    if style == plots.POINTS:
        for x, y in points:
            blot(canvas, x, y, sheet)
        return
    line(canvas, _inside(points, sheet))


def _band(canvas: Any, low: list[Point], high: list[Point], style: str, sheet: Sheet) -> None:
    """Draw the ends of uncertain values: dotted lines, or a bar through each point."""
    if style == plots.POINTS:
        for start, end in zip(low, high, strict=True):
            canvas.line(*start, *end)
        return
    for points in (low, high):
        dotted(canvas, _inside(points, sheet))


def _inside(points: list[Point], sheet: Sheet) -> Iterator[Piece]:
    """Yield the pieces of a line that runs to the right or vertically, cut at the ends of x."""
    low, high = sheet.x
    for (x0, y0), (x1, y1) in pairwise(points):
        if x0 <= high and x1 >= low:
            yield (
                _at(low, x0, y0, x1, y1) if x0 < low else (x0, y0),
                _at(high, x0, y0, x1, y1) if x1 > high else (x1, y1),
            )


def _at(x: float, x0: float, y0: float, x1: float, y1: float) -> Point:
    return x, y0 + (y1 - y0) * (x - x0) / (x1 - x0)


def _hues(chart: plots.Chart, sheet: Sheet) -> dict[int, str]:
    """Return the colours of columns."""
    colors = {}
    for hue in chart.hues:
        if sheet.x[0] <= hue.place <= sheet.x[1]:
            colors[sheet.column(hue.place)] = f"38;5;{_in_palette(*hue[1:])}"
    return colors


def _in_palette(*parts: float) -> int:
    """Return the number of a colour that is readable on a white and on a black background."""
    for low, high in ((0, 5), (0, 4), (0, 3), (0, 2), (1, 5), (1, 4), (1, 3), (1, 2)):
        steps = [round(low + (high - low) * part) for part in parts]
        red, green, blue = (LUMINANCES[step] for step in steps)
        if DARKEST <= 0.2126 * red + 0.7152 * green + 0.0722 * blue <= LIGHTEST:
            break
    return 16 + 36 * steps[0] + 6 * steps[1] + steps[2]


def _number(sheet: Sheet, drawn: Sequence[tuple[dict[int, int], str]]) -> None:
    """Write the number of each curve on it, where it is farthest from the others.

    A curve is given by its rows, by column.
    """
    for k, (places, color) in enumerate(drawn):
        other_curves = [rows for j, (rows, _) in enumerate(drawn) if j != k]

        def room(
            column: int, places: dict[int, int] = places, other_curves: Any = other_curves
        ) -> tuple[int, int]:
            apart = [abs(places[column] - rows.get(column, -APART)) for rows in other_curves]
            return min(APART, *apart), -places[column]

        name = str(k + 1)
        free = [c for c in places if sheet.is_free(c - 1, places[c], len(name) + 2, inside=False)]
        if free := free or [c for c in places if sheet.is_free(c, places[c], len(name))]:
            column = max(free, key=room)
            sheet.write(column, places[column], name, color)


def _scale(is_log: bool) -> Scale:
    return math.log10 if is_log else lambda value: value


def _ends(
    axis: plots.Axis, values: list[float], most: int, is_round: bool = True
) -> tuple[Point, list[float]]:
    if axis.is_log:
        low, high = axis.limits or (min(values), max(values))
        return (low, high), log_ticks(low, high, most)
    low, high = axis.limits or (limits(values, most) if is_round else (min(values), max(values)))
    if low == high:
        low, high = limits([low], most)
    return (low, high), ticks(low, high, most)
