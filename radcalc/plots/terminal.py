"""Pictures in characters: dots of Braille letters, or ASCII, with axes and units.

Each curve has a canvas of its own, of which plotille sets the dots; here they are laid over each
other, with texts on top.  The only module that imports plotille.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import Any, NamedTuple

from plotille import Canvas

from radcalc.errors import printable
from radcalc.plots.data import (
    LINE,
    LINES,
    POINTS,
    REFERENCE,
    RIGHT,
    Axis,
    Chart,
    Disc,
    Field,
    Mark,
    Picture,
    Polar,
    Series,
    Values,
)
from radcalc.plots.ticks import levels, limits, log_ticks, rings, texts, ticks
from radcalc.stdio import fold

PLAIN: Mapping[int, str] = MappingProxyType({})  # no colours of columns
EMPTY = 0x2800  # the Braille letter without dots
ASCII = {
    "λ": "lambda", "θ": "theta", "φ": "phi", "γ": "gamma", "°": " deg", "\u2032": "'", "²": "2",
    "Φ": "Phi", "Ω": "Omega", "η": "eta", "ν": "nu", "μ": "u", "µ": "u", "│": "|", "─": "-",
    "└": "+", "┬": "+", "┤": "+", "×": "x", "·": ".", "☉": "*", "∥": "||",
}  # fmt: skip
COLORS = ("32", "35", "36", "31", "34", "33")  # green first: seen on light and on dark
DIM, RESET = "\033[2m", "\033[0m"
MARKS = "*+o#x%@&"  # of curves, in ASCII
FAINT = "."  # what is behind the curves, in ASCII
NARROWEST = 40  # columns: no narrower terminal is drawn for
LEAST, MOST = 10, 24  # rows of a chart
SHARE = 5  # columns for each row of a chart
APART = 3  # dots of a dotted line
GRID = 4  # dots of the circles and rays of a polar diagram
RIM = 6  # columns beside a circle, for what is written there
SMALLEST, LARGEST = 22, 32  # rows of a circle
ROUND = 360  # pieces of a circle
RAMP = [f"38;5;{n}" for n in (62, 68, 73, 71, 107, 143, 172, 167)]  # of contours
DARKEST, BRIGHTEST = 1, 4  # of the 5 steps of red, green and blue that a hue has
SPAN = 1000.0  # between the darkest and the brightest of what is shaded
CLIPPED = 0.99  # of all: what is brighter is as bright as that
BAYER = ((0, 8, 2, 10), (12, 4, 14, 6), (3, 11, 1, 9), (15, 7, 13, 5))  # order of dots
GAP = 2  # columns between two texts
Point = tuple[float, float]
Piece = tuple[Point, Point]


class Layer(NamedTuple):
    """Dots of one colour, and the character that stands for them in ASCII.

    Columns that have a colour of their own are in `colors`.
    """

    canvas: Any
    color: str
    mark: str
    colors: Mapping[int, str]


class Sheet:
    """Layers of dots over a range of x and y, and texts over them."""

    def __init__(
        self, columns: int, rows: int, x: tuple[float, float], y: tuple[float, float]
    ) -> None:
        self.columns, self.rows, self.x, self.y = columns, rows, x, y
        self.layers: list[Layer] = []
        self.texts: dict[tuple[int, int], tuple[str, str]] = {}

    def layer(self, color: str, mark: str, colors: Mapping[int, str] = PLAIN) -> Any:
        """A new canvas, on top of those that there are."""
        canvas = Canvas(self.columns, self.rows, self.x[0], self.y[0], self.x[1], self.y[1])
        self.layers.append(Layer(canvas, color, mark, colors))
        return canvas

    def write(self, column: int, row: int, text: str, color: str = "") -> None:
        """Write a text from a column on, rows from the top; what stands outside is left out."""
        for k, letter in enumerate(printable(text)):
            if 0 <= column + k < self.columns and 0 <= row < self.rows:
                self.texts[column + k, row] = letter, color

    def place(self, x: float, y: float) -> tuple[int, int]:
        """The column of a place, and its row from the top: where its dot is."""
        across = round(2 * self.columns * (x - self.x[0]) / (self.x[1] - self.x[0])) // 2
        up = round(4 * self.rows * (y - self.y[0]) / (self.y[1] - self.y[0])) // 4
        return (
            min(max(across, 0), self.columns - 1),
            min(max(self.rows - 1 - up, 0), self.rows - 1),
        )

    def lines(self, style: "Style") -> list[str]:
        """The rows as texts."""
        drawn = [one.canvas.plot("\n").split("\n") for one in self.layers]
        found = []
        for row in range(self.rows):
            cells = []
            for column in range(self.columns):
                letter, color = self.texts.get((column, row), ("", ""))
                if not letter:
                    letter, color = self._dots([rows[row][column] for rows in drawn], column, style)
                cells.append((letter, color))
            found.append(_joined(cells, style))
        return found

    def _dots(self, letters: Sequence[str], column: int, style: "Style") -> tuple[str, str]:
        """What layers have in one cell: all their dots, in the colour of the topmost."""
        dots, top = 0, None
        for letter, layer in zip(letters, self.layers, strict=True):
            if ord(letter) > EMPTY:
                dots |= ord(letter) - EMPTY
                top = layer
        if top is None:
            return " ", ""
        color = top.colors.get(column, top.color)
        return (top.mark if style.ascii else chr(EMPTY + dots)), color


class Style(NamedTuple):
    """How wide it may be, whether in colour, and whether in ASCII alone."""

    width: int = 80
    color: bool = False
    ascii: bool = False


def has_braille(encoding: str | None) -> bool:
    """Whether an encoding has the letters of Braille."""
    try:
        "\u28ff".encode(encoding or "ascii")
    except (UnicodeEncodeError, LookupError):
        return False
    return True


def draw(picture: Picture, style: Style) -> str:
    """A picture as lines of text, no wider than the style says."""
    ways: dict[type, Callable[[Any, Style], list[str]]] = {
        Chart: _chart,
        Polar: _polar,
        Field: _field,
        Disc: _disc,
    }
    style = style._replace(width=max(style.width, NARROWEST))
    lines = ways[type(picture)](picture, style)
    text = "".join(f"{line.rstrip()}\n" for line in lines)
    return _in_ascii(text) if style.ascii else text


def _in_ascii(text: str) -> str:
    return "".join(ASCII.get(letter, letter) for letter in text)


def _joined(cells: Iterable[tuple[str, str]], style: Style) -> str:
    """Letters with their colours, which are told where they change."""
    line, now = "", ""
    for letter, color in cells:
        if style.color and color != now and letter != " ":
            line += (RESET if now else "") + (f"\033[{color}m" if color else "")
            now = color
        line += letter
    return line + (RESET if now else "")


def _dim(text: str, style: Style) -> str:
    return f"{DIM}{text}{RESET}" if style.color and text.strip() else text


# -- polar diagrams --------------------------------------------------------------------------------


def _polar(polar: Polar, style: Style) -> list[str]:
    """The axis points down; only the lower half is drawn where there is nothing in the upper."""
    circles, is_half = rings(polar.most), polar.is_half
    names, outer = texts(circles), circles[-1]
    radius = min(style.width - 2 * RIM, (4 if is_half else 2) * (_tall(style) - 2))  # in dots
    columns, rows = radius + 2 * RIM, -(-radius // (4 if is_half else 2)) + 2
    dot = outer / (radius - 1)
    top = 5 if is_half else 2 * rows
    sheet = Sheet(
        columns,
        rows,
        (-columns * dot, columns * dot),
        ((top - 4 * rows) * dot, top * dot),
    )
    grid = sheet.layer(DIM[2:-1], FAINT)
    reach = RIGHT if is_half else 180.0
    for size in circles:
        circle = [_turned(size, angle) for angle in _degrees(-reach, reach)]
        _dotted(grid, pairwise(circle), GRID)
    for angle in range(-180, 180, 30):
        if abs(angle) <= reach:
            _dotted(grid, [((0.0, 0.0), _turned(outer, angle))], GRID)
            _write_at_rim(sheet, f"{abs(angle)}°", *_turned(outer, angle), dot)
    for size, name in zip(circles, names, strict=True):
        column, row = sheet.place(size, 0.0)
        if size != outer:
            sheet.write(column - len(name) // 2, row if not is_half else row - 1, name, "2")
    legend = []
    for k, plane in enumerate(polar.planes):
        color, mark = COLORS[k % len(COLORS)], MARKS[k % len(MARKS)]
        canvas = sheet.layer(color, mark)
        points = [_turned(v, a) for a, v in zip(plane.angles, plane.values, strict=True)]
        if k == 0:
            _line(canvas, pairwise(points))
        else:
            _dotted(canvas, pairwise(points))
        own = Series("", (), (), LINE if k == 0 else REFERENCE)
        legend.append((_sample(own, mark, style), color, plane.label))
    left = " " * ((style.width - columns) // 2)
    said = f"{polar.radius.title}, circles every {names[0]}"
    lines = [*_title(polar.title, style), *(left + line for line in sheet.lines(style))]
    return [
        *lines,
        *_caption(said, 0, style.width),
        *_legend(legend, style),
    ]


def _tall(style: Style) -> int:
    """The rows of a circle, in which most of a terminal is."""
    return min(max(style.width * 2 // 7, SMALLEST), LARGEST)


def _turned(size: float, angle: float) -> tuple[float, float]:
    """Where a value stands at an angle [deg] from straight down."""
    turn = math.radians(angle)
    return size * math.sin(turn), -size * math.cos(turn)


def _degrees(low: float, high: float) -> list[float]:
    return [low + (high - low) * k / ROUND for k in range(ROUND + 1)]


def _write_at_rim(sheet: Sheet, text: str, x: float, y: float, dot: float) -> None:
    """Write beside a place on a circle about the middle, outside of it."""
    size = math.hypot(x, y)
    column, row = sheet.place(x + 4 * dot * x / size, y + 4 * dot * y / size)
    if abs(x) < size / 100:
        column -= len(text) // 2
    elif x < 0:
        column -= len(text) - 1
    sheet.write(column, row, text)


# -- fields and discs ------------------------------------------------------------------------------


def _field(field: Field, style: Style) -> list[str]:
    """Contours over x and y, of lengths that are alike on both."""
    x_ends, y_ends = (field.xs[0], field.xs[-1]), (field.ys[0], field.ys[-1])
    wide, high = x_ends[1] - x_ends[0], y_ends[1] - y_ends[0]
    y_ticks = ticks(*y_ends, 6)
    names = texts(y_ticks)
    left = max(map(len, names)) + 2
    columns = style.width - left - 1
    rows = min(max(round(columns * high / wide / 2), 4), MOST)
    columns = min(columns, max(round(2 * rows * wide / high), LEAST))
    sheet = Sheet(
        columns,
        rows,
        (x_ends[0], _beyond(*x_ends, 2 * columns)),
        (y_ends[0], _beyond(*y_ends, 4 * rows)),
    )
    numbered = dict(zip([_row(sheet, y) for y in y_ticks], names, strict=True))
    drawn = field.xs, field.ys, field.rows
    _place_marks(sheet, field.marks)
    said = _contours(sheet, drawn, field.value, field.marks)
    lines = [*_title(field.title, style), *_upright_title(field.y, left, style)]
    for row, line in enumerate(sheet.lines(style)):
        name = numbered.get(row, "")
        lines.append(_dim(f"{name:>{left - 1}}{'┤' if name else '│'}", style) + line)
    x_ticks = ticks(*x_ends, max(columns // 10, 2))
    below = _below(field.x, sheet, x_ticks, float, left, style)
    return [*lines, *below, *fold(said, style.width)]


def _disc(disc: Disc, style: Style) -> list[str]:
    """A disc with its contours, or of dots where it is a picture of things."""
    radius = min(style.width - 2 * RIM, 2 * (_tall(style) - 2))  # in dots
    columns, rows = radius + 2 * RIM, radius // 2 + 2
    wide, high = columns / (radius - 1), 2 * rows / (radius - 1)
    sheet = Sheet(columns, rows, (-wide, wide), (-high, high))
    count = len(disc.rows)
    places = [2 * k / (count - 1) - 1 for k in range(count)]
    inside = [
        [v if x * x + y * y <= 1 else math.nan for x, v in zip(places, row, strict=True)]
        for y, row in zip(places, disc.rows, strict=True)
    ]
    grid = sheet.layer(DIM[2:-1], FAINT)
    rim = [_turned(1.0, angle) for angle in _degrees(-180, 180)]
    _line(grid, pairwise(rim))
    for label, angle in disc.rim:
        x, y = _turned(1.0, 180 - angle)
        _write_at_rim(sheet, label, x, y, 1 / radius)
    _place_marks(sheet, disc.marks)
    if disc.is_image:
        said = _shaded(sheet, places, inside, disc.value, style)
    else:
        taken = {sheet.place(*place) for place in rim}
        said = _contours(sheet, (places, places, inside), disc.value, disc.marks, taken)
    left = " " * max((style.width - columns) // 2, 0)
    lines = [*_title(disc.title, style), *(left + line for line in sheet.lines(style))]
    return [*lines, *_caption(said, 0, style.width)]


def _place_marks(sheet: Sheet, marks: Sequence[Mark]) -> None:
    """Small crosses with their names."""
    for mark in marks:
        column, row = sheet.place(mark.x, mark.y)
        sheet.write(column, row, "+")
        if column + 2 + len(mark.label) <= sheet.columns:
            sheet.write(column + 1, row, mark.label)
        else:
            sheet.write(column - len(mark.label), row, mark.label)


def _contours(
    sheet: Sheet,
    drawn: tuple[Values, Values, Sequence[Values]],
    value: Axis,
    marks: Sequence[Mark],
    taken: Iterable[tuple[int, int]] = (),
) -> str:
    """Draw contours with their numbers, away from what is taken, and tell what they are of."""
    every = [z for row in drawn[2] for z in row if z == z]
    found = levels(every)
    full = [*taken, *(sheet.place(mark.x, mark.y) for mark in marks)]
    for k, (level, name) in enumerate(zip(found, texts(found), strict=True)):
        color = RAMP[k * (len(RAMP) - 1) // max(len(found) - 1, 1)]
        canvas = sheet.layer(color, MARKS[k % len(MARKS)])
        places = []
        for start, end in _segments(*drawn, level):
            canvas.line(*start, *end)
            places.append(start)
        _name_contour(sheet, places, name, color, full)
    low, high = texts([float(f"{x:.4g}") for x in (min(every), max(every))])
    return f"{value.title}, from {low} to {high}"


def _name_contour(
    sheet: Sheet,
    places: list[tuple[float, float]],
    name: str,
    color: str,
    taken: list[tuple[int, int]],
) -> None:
    """Write a contour's number where it is farthest from those of others and from the edges."""
    half = len(name) // 2

    def is_free(cell: tuple[int, int]) -> bool:
        around = range(cell[0] - half - 1, cell[0] - half + len(name) + 1)
        inside = around[0] >= 0 and around[-1] < sheet.columns
        return inside and not any((column, cell[1]) in sheet.texts for column in around)

    def room(cell: tuple[int, int]) -> tuple[float, int, int]:
        apart = [abs(cell[0] - c) / len(name) + abs(cell[1] - r) for c, r in taken]
        return min(apart, default=0.0), *cell

    free = list(filter(is_free, {sheet.place(x, y) for x, y in places}))
    if free:
        column, row = max(free, key=room)
        taken.append((column, row))
        sheet.write(column - half, row, name, color)


def _segments(xs: Values, ys: Values, rows: Sequence[Values], level: float) -> Iterator[Piece]:
    """The straight pieces of a contour, each across a triangle that is half of a cell."""
    for (y0, low), (y1, high) in pairwise(zip(ys, rows, strict=True)):
        for i in range(len(xs) - 1):
            z = low[i], low[i + 1], high[i], high[i + 1]
            if not min(z) <= level <= max(z) or any(map(math.isnan, z)):
                continue
            a, b = (xs[i], y0, z[0]), (xs[i + 1], y0, z[1])
            c, d = (xs[i], y1, z[2]), (xs[i + 1], y1, z[3])
            for corners in ((a, b, d), (a, c, d)):
                crossed = [
                    _between(one, other, level)
                    for one, other in pairwise((*corners, corners[0]))
                    if (one[2] < level) != (other[2] < level)
                ]
                if len(crossed) == 2:
                    yield crossed[0], crossed[1]


def _between(
    one: tuple[float, float, float], other: tuple[float, float, float], level: float
) -> tuple[float, float]:
    """Where a level is on the line between two places."""
    share = (level - one[2]) / (other[2] - one[2])
    return one[0] + share * (other[0] - one[0]), one[1] + share * (other[1] - one[1])


def _shaded(sheet: Sheet, places: Values, rows: Sequence[Values], value: Axis, style: Style) -> str:
    """Draw dots the denser the brighter, by the logarithm of what is above the least share."""
    every = sorted(z for row in rows for z in row if z == z)
    high = every[int(CLIPPED * (len(every) - 1))] or 1.0
    low = max(every[0], high / SPAN)
    canvas = sheet.layer("", "#")
    count = len(places)
    for row in range(4 * sheet.rows):
        y = sheet.y[0] + (sheet.y[1] - sheet.y[0]) * row / (4 * sheet.rows)
        for column in range(2 * sheet.columns):
            x = sheet.x[0] + (sheet.x[1] - sheet.x[0]) * column / (2 * sheet.columns)
            if x * x + y * y > 1:
                continue
            i, j = (round((place + 1) / 2 * (count - 1)) for place in (x, y))
            z = rows[j][i]
            share = math.log(max(z, low) / low) / math.log(high / low) if high > low else 1.0
            if z == z and share > (BAYER[row % 4][column % 4] + 0.5) / 16:
                canvas.point(x, y)
    ends = texts([float(f"{z:.3g}") for z in (low, high)])
    return f"{value.title}: all dots at {ends[1]} and more, none at {ends[0]} and less"


# -- charts ----------------------------------------------------------------------------------------


def _chart(chart: Chart, style: Style) -> list[str]:
    rows = min(max(style.width // SHARE, LEAST), MOST)
    x_of, y_of = _scale(chart.x.is_log), _scale(chart.y.is_log)
    values = [y for one in chart.series for y in one.y]
    y_ends, y_ticks = _ends(chart.y, values, rows // 3 + 1)
    places = [x for one in chart.series for x in one.x]
    names = texts(y_ticks)
    left = max(map(len, names)) + 2
    columns = style.width - left - 1
    x_ends, x_ticks = _ends(chart.x, places, max(columns // 10, 2), is_round=False)
    sheet = Sheet(
        columns,
        rows,
        (x_of(x_ends[0]), _beyond(x_of(x_ends[0]), x_of(x_ends[1]), 2 * columns)),
        (y_of(y_ends[0]), _beyond(y_of(y_ends[0]), y_of(y_ends[1]), 4 * rows)),
    )
    for label, place in chart.marks:
        _upright(sheet, x_of(place), label)
    legend, drawn = [], []
    is_alone = len([one for one in chart.series if one.style != REFERENCE]) == 1
    colors = _hues(chart, sheet) if is_alone else PLAIN
    for k, one in enumerate(chart.series):
        color, mark = COLORS[k % len(COLORS)], MARKS[k % len(MARKS)]
        if one.style == REFERENCE:
            color, mark, colors = DIM[2:-1], FAINT, PLAIN
        elif colors:
            color = ""
        points = [(x_of(x), y_of(y)) for x, y in zip(one.x, one.y, strict=True)]
        _curve(sheet.layer(color, mark, colors), points, one.style, sheet)
        if one.style in (LINE, POINTS):
            drawn.append((dict(sheet.place(*point) for point in points), color))
        if one.label:
            legend.append((_sample(one, mark, style), color, one.label))
    if len(drawn) > 1:
        _number(sheet, drawn)
        legend = [
            (sample if k > len(drawn) else f"{k} {sample}", color, label)
            for k, (sample, color, label) in enumerate(legend, start=1)
        ]
    numbered = dict(zip([_row(sheet, y_of(y)) for y in y_ticks], names, strict=True))
    lines = [*_title(chart.title, style), *_upright_title(chart.y, left, style)]
    for row, line in enumerate(sheet.lines(style)):
        name = numbered.get(row, "")
        lines.append(_dim(f"{name:>{left - 1}}{'┤' if name else '│'}", style) + line)
    return [*lines, *_below(chart.x, sheet, x_ticks, x_of, left, style), *_legend(legend, style)]


def _title(title: str, style: Style) -> list[str]:
    """The title, folded between its words."""
    return fold(printable(title), style.width) if title else []


def _upright_title(axis: Axis, left: int, style: Style) -> list[str]:
    """The title of an axis that stands, over it."""
    return [" " * (left - 1) + part for part in fold(axis.title, style.width - left)]


def _hues(chart: Chart, sheet: Sheet) -> dict[int, str]:
    """The colours of columns, in the palette of 256: neither white nor black hides them."""
    found = {}
    for hue in chart.hues:
        if sheet.x[0] <= hue.place <= sheet.x[1]:
            red, green, blue = (round(DARKEST + (BRIGHTEST - DARKEST) * part) for part in hue[1:])
            column = sheet.place(hue.place, sheet.y[0])[0]
            found[column] = f"38;5;{16 + 36 * red + 6 * green + blue}"
    return found


def _number(sheet: Sheet, drawn: Sequence[tuple[dict[int, int], str]]) -> None:
    """Write the number of each curve on it, as high as it is apart from the others.

    A curve is its rows by its columns.
    """
    for k, (own, color) in enumerate(drawn):
        others = [rows for j, (rows, _) in enumerate(drawn) if j != k]

        def room(column: int, own: dict[int, int] = own, others: Any = others) -> tuple[int, int]:
            apart = [abs(own[column] - rows.get(column, -APART)) for rows in others]
            return min(APART, *apart), -own[column]

        free = [column for column in own if (column, own[column]) not in sheet.texts]
        if free:
            column = max(free, key=room)
            sheet.write(column, own[column], str(k + 1), color)


def _scale(is_log: bool) -> Callable[[float], float]:
    return math.log10 if is_log else lambda value: value


def _beyond(low: float, high: float, dots: int) -> float:
    """The end of a canvas whose last dot is `high`: plotille has the end itself outside."""
    return high + (high - low) / (dots - 1)


def _ends(
    axis: Axis, values: list[float], most: int, is_round: bool = True
) -> tuple[tuple[float, float], list[float]]:
    """The ends of an axis, and the round numbers on it."""
    if axis.is_log:
        low, high = axis.limits or (min(values), max(values))
        return (low, high), log_ticks(low, high, most)
    low, high = axis.limits or (limits(values, most) if is_round else (min(values), max(values)))
    if low == high:
        low, high = limits([low], most)
    return (low, high), ticks(low, high, most)


def _row(sheet: Sheet, y: float) -> int:
    return sheet.place(sheet.x[0], y)[1]


def _upright(sheet: Sheet, x: float, label: str) -> None:
    """A line from the bottom to the top, with its name beside it."""
    canvas = sheet.layer(DIM[2:-1], "|")
    canvas.line(x, sheet.y[0], x, sheet.y[1])
    column = sheet.place(x, sheet.y[0])[0]
    is_left = column + 2 + len(label) > sheet.columns
    sheet.write(column - 1 - len(label) if is_left else column + 2, 0, label)


def _curve(canvas: Any, points: list[tuple[float, float]], style: str, sheet: Sheet) -> None:
    """A line through points, dots along it, or uprights below them; outside nothing is drawn."""
    if style == LINES:
        for x, y in points:
            canvas.line(x, sheet.y[0], x, y)
        return
    if style == REFERENCE:
        _dotted(canvas, _inside(points, sheet))
        return
    if style == POINTS:
        for x, y in points:
            _blot(canvas, x, y, sheet)
        return
    _line(canvas, _inside(points, sheet))


def _line(canvas: Any, pieces: Iterable[Piece]) -> None:
    for start, end in pieces:
        canvas.line(*start, *end)


def _inside(points: list[tuple[float, float]], sheet: Sheet) -> Iterator[Piece]:
    """The pieces of a line that runs to the right or upright, cut at the ends of x."""
    low, high = sheet.x
    for (x0, y0), (x1, y1) in pairwise(points):
        if x0 <= high and x1 >= low:
            yield (
                _at(low, x0, y0, x1, y1) if x0 < low else (x0, y0),
                _at(high, x0, y0, x1, y1) if x1 > high else (x1, y1),
            )


def _at(x: float, x0: float, y0: float, x1: float, y1: float) -> tuple[float, float]:
    return x, y0 + (y1 - y0) * (x - x0) / (x1 - x0)


def _blot(canvas: Any, x: float, y: float, sheet: Sheet) -> None:
    """Three dots by three, as far as they are inside, about a point."""
    across = (sheet.x[1] - sheet.x[0]) / (2 * sheet.columns)
    up = (sheet.y[1] - sheet.y[0]) / (4 * sheet.rows)
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            if not i or not j:
                canvas.point(x + i * across, y + j * up)


def _dotted(
    canvas: Any,
    pieces: Iterable[Piece],
    apart: int = APART,
) -> None:
    """Dots along the pieces of a line."""
    due = 0
    for (x0, y0), (x1, y1) in pieces:
        steps = max(map(abs, canvas.dots_between(x0, y0, x1, y1)))
        while due < steps:
            canvas.point(x0 + (x1 - x0) * due / steps, y0 + (y1 - y0) * due / steps)
            due += apart
        due -= steps


def _below(
    axis: Axis,
    sheet: Sheet,
    x_ticks: list[float],
    x_of: Callable[[float], float],
    left: int,
    style: Style,
) -> list[str]:
    """The x axis, its numbers and its title."""
    rule, numbers = ["─"] * sheet.columns, [" "] * (left + sheet.columns + 1)
    taken = 0
    for place, text in zip(x_ticks, texts(x_ticks), strict=True):
        column = sheet.place(x_of(place), sheet.y[0])[0]
        start = max(left + column - len(text) // 2, 0)
        start = min(start, style.width - len(text))
        if start < taken:
            continue
        rule[column] = "┬"
        numbers[start : start + len(text)] = text
        taken = start + len(text) + 1
    return [
        _dim(f"{' ' * (left - 1)}└{''.join(rule)}", style),
        _dim("".join(numbers), style),
        *_caption(axis.title, left, sheet.columns),
    ]


def _caption(text: str, start: int, room: int) -> list[str]:
    """A text in the middle of a room, folded where it is longer."""
    text = printable(text)
    return [
        " " * (start + (room - len(part)) // 2) + part
        for part in fold(text, max(room, NARROWEST // 2))
    ]


def _sample(one: Series, mark: str, style: Style) -> str:
    """How a curve looks, beside its name."""
    if style.ascii:
        return mark * 2
    return {REFERENCE: "\u2804\u2804", LINES: "\u28b8\u2847", POINTS: "\u2822\u2876"}.get(
        one.style, "\u2824\u2824"
    )


def _legend(entries: Sequence[tuple[str, str, str]], style: Style) -> list[str]:
    """Samples and names of the curves, as many in a line as there is room for."""
    if not entries:
        return []
    lines, line, size = [], "", 0
    for sample, color, label in entries:
        label, *rest = fold(printable(label), style.width - len(sample) - 1)
        text = f"{sample} {label}"
        if size and size + GAP + len(text) > style.width:
            lines.append(line)
            line, size = "", 0
        if size:
            line, size = line + " " * GAP, size + GAP
        shown = f"\033[{color}m{sample}{RESET}" if style.color and color else sample
        line, size = f"{line}{shown} {label}", size + len(text)
        if rest:
            lines += [line, *(f"   {part}" for part in rest)]
            line, size = "", 0
    return [*lines, *([line] if line else [])]
