"""A sheet of characters to draw a picture on, with axes and texts around it.

Its dots are those of Braille characters, or whole characters in ASCII.  Each colour has its own
canvas of plotille, which only this module imports.
"""

from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

from plotille import Canvas

from radcalc.errors import printable
from radcalc.plots import LINES, POINTS, REFERENCE, Axis
from radcalc.terminal import RESET, columns_of, fold

PLAIN: Mapping[int, str] = MappingProxyType({})  # no colours of columns
EMPTY = 0x2800  # the Braille character without dots
DIM = "2"  # colour of grids and references
BEHIND = "."  # their character in ASCII
NARROWEST = 40  # least width of a picture [columns]
APART = 3  # distance of the dots in a dotted line
GAP = 2  # columns between two texts
Point = tuple[float, float]
Piece = tuple[Point, Point]


class Style(NamedTuple):
    """Greatest width of a picture; whether it may have colours; whether it must be ASCII.

    The height is that of the terminal [lines], or 0 if it is unknown.
    """

    width: int
    color: bool = False
    ascii: bool = False
    height: int = 0


class Layer(NamedTuple):
    """Dots of one colour, and their character in ASCII; `colors` are exceptions, by column."""

    canvas: Any
    color: str
    mark: str
    colors: Mapping[int, str]


class Sheet:
    """Layers of dots over a range of x and y, and texts over them."""

    def __init__(self, columns: int, rows: int, x: Point, y: Point) -> None:
        self.columns, self.rows, self.x, self.y = columns, rows, x, y
        self.layers: list[Layer] = []
        self.texts: dict[tuple[int, int], tuple[str, str]] = {}

    @classmethod
    def between(cls, columns: int, rows: int, x: Point, y: Point, edge: int = 0) -> "Sheet":
        """Return a sheet with the ends of x and y at its first and last dots, or `edge` inside."""
        ranges = []
        for (low, high), dots in ((x, 2 * columns), (y, 4 * rows)):
            dot = (high - low) / (dots - 1 - 2 * edge)
            ranges.append((low - edge * dot, high + (edge + 1) * dot))  # plotille excludes the end
        return cls(columns, rows, *ranges)

    def layer(self, color: str, mark: str, colors: Mapping[int, str] = PLAIN) -> Any:
        """Add a canvas on top of the others."""
        canvas = Canvas(self.columns, self.rows, self.x[0], self.y[0], self.x[1], self.y[1])
        self.layers.append(Layer(canvas, color, mark, colors))
        return canvas

    def write(self, column: int, row: int, text: str, color: str = "") -> None:
        """Write a text; what is outside is omitted.

        A mark is in the cell of its letter; the second cell of a wide letter is empty.
        """
        start, end = -1, column
        for letter in printable(text):
            size = columns_of(letter)
            if not size:
                if (start, row) in self.texts:
                    self.texts[start, row] = self.texts[start, row][0] + letter, color
                continue
            start, end = end, end + size
            if 0 <= row < self.rows and start >= 0 and end <= self.columns:
                for k in range(start, end):
                    self._clear(k, row)
                    self.texts[k, row] = letter if k == start else "", color

    def is_free(self, column: int, row: int, size: int, inside: bool = True) -> bool:
        """Return whether cells have no text, and are in the sheet if they must be `inside`."""
        is_inside = 0 <= row < self.rows and column >= 0 and column + size <= self.columns
        return (is_inside or not inside) and not any(
            (k, row) in self.texts for k in range(column, column + size)
        )

    def _clear(self, column: int, row: int) -> None:
        """Blank the other half of a wide letter before its half here is written over."""
        if self.texts.get((column, row), (" ",))[0] == "":
            self.texts[column - 1, row] = " ", ""
        if self.texts.get((column + 1, row), (" ",))[0] == "":
            self.texts[column + 1, row] = " ", ""

    def place(self, x: float, y: float) -> tuple[int, int]:
        """Return the column of a point, and its row from the top."""
        across = round(2 * self.columns * (x - self.x[0]) / (self.x[1] - self.x[0])) // 2
        up = round(4 * self.rows * (y - self.y[0]) / (self.y[1] - self.y[0])) // 4
        return (
            min(max(across, 0), self.columns - 1),
            min(max(self.rows - 1 - up, 0), self.rows - 1),
        )

    def row(self, y: float) -> int:
        return self.place(self.x[0], y)[1]

    def column(self, x: float) -> int:
        return self.place(x, self.y[0])[0]

    def lines(self, style: Style) -> list[str]:
        drawn = [layer.canvas.plot("\n").split("\n") for layer in self.layers]
        lines = []
        for row in range(self.rows):
            cells = []
            for column in range(self.columns):
                cells.append(
                    self.texts.get((column, row))
                    or self._dots([rows[row][column] for rows in drawn], column, style)
                )
            lines.append(_joined(cells, style))
        return lines

    def _dots(self, letters: Sequence[str], column: int, style: Style) -> tuple[str, str]:
        """Combine the dots of all layers, in the colour of the topmost."""
        dots, top = 0, None
        for letter, layer in zip(letters, self.layers, strict=True):
            if ord(letter) > EMPTY:
                dots |= ord(letter) - EMPTY
                top = layer
        if top is None:
            return " ", ""
        color = top.colors.get(column, top.color)
        return (top.mark if style.ascii else chr(EMPTY + dots)), color


def _joined(cells: Iterable[tuple[str, str]], style: Style) -> str:
    line, now = "", ""
    for letter, color in cells:
        if style.color and color != now and letter != " ":
            line += (RESET if now else "") + (_start(color) if color else "")
            now = color
        line += letter
    return line + (RESET if now else "")


def _start(color: str) -> str:
    return f"\033[{color}m"


def _painted(text: str, color: str, style: Style) -> str:
    return f"{_start(color)}{text}{RESET}" if style.color and color and text.strip() else text


def line(canvas: Any, pieces: Iterable[Piece]) -> None:
    """Draw the pieces of a line."""
    for start, end in pieces:
        canvas.line(*start, *end)


def dotted(canvas: Any, pieces: Iterable[Piece], apart: int = APART) -> None:
    """Draw dots along the pieces of a line."""
    due = 0
    for (x0, y0), (x1, y1) in pieces:
        steps = max(map(abs, canvas.dots_between(x0, y0, x1, y1)))
        while due < steps:
            canvas.point(x0 + (x1 - x0) * due / steps, y0 + (y1 - y0) * due / steps)
            due += apart
        due -= steps


def blot(canvas: Any, x: float, y: float, sheet: Sheet) -> None:
    """Draw a cross of 3 by 3 dots around a point, as far as it is inside."""
    across = (sheet.x[1] - sheet.x[0]) / (2 * sheet.columns)
    up = (sheet.y[1] - sheet.y[0]) / (4 * sheet.rows)
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            if not i or not j:
                canvas.point(x + i * across, y + j * up)


# -- around the sheet ------------------------------------------------------------------------------


def heading(title: str, style: Style) -> list[str]:
    """Return the title, folded between words."""
    return fold(printable(title), style.width) if title else []


def beside(
    axis: Axis, sheet: Sheet, numbers: Mapping[float, str], margin: int, style: Style
) -> list[str]:
    """Return the rows of a sheet with the y axis on the left, and its title above."""
    numbered = {sheet.row(place): text for place, text in numbers.items()}
    lines = [" " * (margin - 1) + part for part in fold(axis.title, style.width - margin)]
    for row, line in enumerate(sheet.lines(style)):
        text = numbered.get(row, "")
        rule = f"{text:>{margin - 1}}{'┤' if text else '│'}"
        lines.append(_painted(rule, DIM, style) + line)
    return lines


def below(
    axis: Axis, sheet: Sheet, numbers: Mapping[float, str], margin: int, style: Style
) -> list[str]:
    """Return the x axis, its numbers and its title."""
    rule, written = ["─"] * sheet.columns, [" "] * (margin + sheet.columns + 1)
    taken = 0
    for place, text in numbers.items():
        column = sheet.column(place)
        start = max(margin + column - len(text) // 2, 0)
        start = min(start, style.width - len(text))
        if start < taken:
            continue
        rule[column] = "┬"
        written[start : start + len(text)] = text
        taken = start + len(text) + 1
    return [
        _painted(f"{' ' * (margin - 1)}└{''.join(rule)}", DIM, style),
        _painted("".join(written), DIM, style),
        *caption(axis.title, margin, sheet.columns),
    ]


def caption(text: str, start: int, room: int) -> list[str]:
    """Centre a text in a width, folded if it is longer."""
    parts = fold(printable(text), max(room, NARROWEST // 2)) if text else []
    return [" " * (start + max(room - columns_of(part), 0) // 2) + part for part in parts]


def sample(how: str, mark: str, style: Style) -> str:
    """Return a sample of a curve's style, for the legend."""
    if style.ascii:
        return mark * 2
    return {REFERENCE: "\u2804\u2804", LINES: "\u28b8\u2847", POINTS: "\u2822\u2876"}.get(
        how, "\u2824\u2824"
    )


def legend(entries: Sequence[tuple[str, str, str]], style: Style) -> list[str]:
    """Return samples and names of the curves, as many in a line as fit."""
    lines, line, size = [], "", 0
    for look, color, label in entries:
        room = style.width - len(look) - 1
        label, *more_lines = fold(printable(label), room)
        text = f"{look} {label}".lstrip()
        if size and size + GAP + columns_of(text) > style.width:
            lines.append(line)
            line, size = "", 0
        if size:
            line, size = line + " " * GAP, size + GAP
        line += f"{_painted(look, color, style)} {label}".lstrip()
        size += columns_of(text)
        if more_lines:
            lines += [line, *(f"   {part}" for part in more_lines)]
            line, size = "", 0
    return [*lines, *([line] if line else [])]
