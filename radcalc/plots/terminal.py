"""Pictures in characters: dots of Braille letters, or ASCII, with axes and units.

Each curve has a canvas of its own, of which plotille sets the dots; here they are laid over each
other, with texts on top.  The only module that imports plotille.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from plotille import Canvas

from radcalc.plots.data import LINES, REFERENCE, Chart, Picture, Series
from radcalc.plots.ticks import limits, log_ticks, texts, ticks
from radcalc.stdio import fold

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
LEAST, MOST = 10, 24  # rows of a chart
SHARE = 5  # columns for each row of a chart
APART = 3  # dots of a dotted line
GAP = 2  # columns between two texts


class Layer(NamedTuple):
    """Dots of one colour, and the character that stands for them in ASCII."""

    canvas: Any
    color: str
    mark: str


class Sheet:
    """Layers of dots over a range of x and y, and texts over them."""

    def __init__(
        self, columns: int, rows: int, x: tuple[float, float], y: tuple[float, float]
    ) -> None:
        self.columns, self.rows, self.x, self.y = columns, rows, x, y
        self.layers: list[Layer] = []
        self.texts: dict[tuple[int, int], tuple[str, str]] = {}

    def layer(self, color: str, mark: str) -> Any:
        """A new canvas, on top of those that there are."""
        canvas = Canvas(self.columns, self.rows, self.x[0], self.y[0], self.x[1], self.y[1])
        self.layers.append(Layer(canvas, color, mark))
        return canvas

    def write(self, column: int, row: int, text: str, color: str = "") -> None:
        """Write a text from a column on, rows from the top; what stands outside is left out."""
        for k, letter in enumerate(text):
            if 0 <= column + k < self.columns and 0 <= row < self.rows:
                self.texts[column + k, row] = letter, color

    def place(self, x: float, y: float) -> tuple[int, int]:
        """The column and the row of a place."""
        across = (x - self.x[0]) / (self.x[1] - self.x[0])
        up = (y - self.y[0]) / (self.y[1] - self.y[0])
        return (
            min(max(int(across * self.columns), 0), self.columns - 1),
            min(max(int((1 - up) * self.rows), 0), self.rows - 1),
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
                    letter, color = self._dots([rows[row][column] for rows in drawn], style)
                cells.append((letter, color))
            found.append(_joined(cells, style))
        return found

    def _dots(self, letters: Sequence[str], style: "Style") -> tuple[str, str]:
        """What layers have in one cell: all their dots, in the colour of the topmost."""
        dots, top = 0, None
        for letter, layer in zip(letters, self.layers, strict=True):
            if ord(letter) > EMPTY:
                dots |= ord(letter) - EMPTY
                top = layer
        if top is None:
            return " ", ""
        return (top.mark if style.ascii else chr(EMPTY + dots)), top.color


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
    ways: dict[type, Callable[[Any, Style], list[str]]] = {Chart: _chart}
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
    legend = []
    for k, one in enumerate(chart.series):
        color, mark = COLORS[k % len(COLORS)], MARKS[k % len(MARKS)]
        if one.style == REFERENCE:
            color, mark = DIM[2:-1], FAINT
        points = [(x_of(x), y_of(y)) for x, y in zip(one.x, one.y, strict=True)]
        _curve(sheet.layer(color, mark), points, one.style, sheet)
        if one.label:
            legend.append((_sample(one, mark, style), color, one.label))
    numbered = dict(zip([_row(sheet, y_of(y)) for y in y_ticks], names, strict=True))
    lines = [*_title(chart.title, style), f"{' ' * (left - 1)}{chart.y.title}"]
    for row, line in enumerate(sheet.lines(style)):
        name = numbered.get(row, "")
        lines.append(_dim(f"{name:>{left - 1}}{'┤' if name else '│'}", style) + line)
    return [*lines, *_below(chart, sheet, x_ticks, x_of, left, style), *_legend(legend, style)]


def _title(title: str, style: Style) -> list[str]:
    """The title, folded between its words."""
    return fold(title, style.width) if title else []


def _scale(is_log: bool) -> Callable[[float], float]:
    return math.log10 if is_log else lambda value: value


def _beyond(low: float, high: float, dots: int) -> float:
    """The end of a canvas whose last dot is `high`: plotille has the end itself outside."""
    return high + (high - low) / (dots - 1)


def _ends(
    axis: Any, values: list[float], most: int, is_round: bool = True
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
        _dotted(canvas, points)
        return
    if len(points) == 1:
        canvas.point(*points[0])
    for (x0, y0), (x1, y1) in pairwise(points):
        canvas.line(x0, y0, x1, y1)


def _dotted(canvas: Any, points: list[tuple[float, float]]) -> None:
    """Every third dot along a line."""
    due = 0
    for (x0, y0), (x1, y1) in pairwise(points):
        steps = max(map(abs, canvas.dots_between(x0, y0, x1, y1)))
        while due < steps:
            canvas.point(x0 + (x1 - x0) * due / steps, y0 + (y1 - y0) * due / steps)
            due += APART
        due -= steps


def _below(
    chart: Chart,
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
    title = chart.x.title
    return [
        _dim(f"{' ' * (left - 1)}└{''.join(rule)}", style),
        _dim("".join(numbers), style),
        f"{' ' * max(left + (sheet.columns - len(title)) // 2, 0)}{title}",
    ]


def _sample(one: Series, mark: str, style: Style) -> str:
    """How a curve looks, beside its name."""
    if style.ascii:
        return mark * 2
    return {REFERENCE: "\u2804\u2804", LINES: "\u28b8\u2847"}.get(one.style, "\u2824\u2824")


def _legend(entries: Sequence[tuple[str, str, str]], style: Style) -> list[str]:
    """Samples and names of the curves, as many in a line as there is room for."""
    if not entries:
        return []
    lines, line, size = [], "", 0
    for sample, color, label in entries:
        text = f"{sample} {label}"
        if size and size + GAP + len(text) > style.width:
            lines.append(line)
            line, size = "", 0
        if size:
            line, size = line + " " * GAP, size + GAP
        shown = f"\033[{color}m{sample}{RESET}" if style.color else sample
        line, size = f"{line}{shown} {label}", size + len(text)
    return [*lines, line]
