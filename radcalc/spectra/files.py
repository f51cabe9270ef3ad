"""Measured spectra from files: two or more columns, whatever separates them.

What can be read in one way only is read, and said; everything else is an error with its line.
A file is read a block at a time, and its numbers alone are kept.
"""

from array import array
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from operator import lt
from typing import Any, NamedTuple

from radcalc import columns, stdio
from radcalc.errors import ConditionError, listed, nearest, option, quote, quote_path
from radcalc.spectra import titles
from radcalc.spectra.planck import LIGHT, PLANCK
from radcalc.spectra.spectrum import Table

NOISE = 0.05  # of the peak: negative values within it are a spectrometer's noise
BLOCK = 1 << 20  # bytes read at a time
LONGEST = 1 << 22  # bytes of a line
LARGEST = 1 << 29  # bytes of a file
MANY = 10_000  # rows from which NumPy is worth loading
MOST = 20_000_000  # rows
MOST_COMMENTS = 1000
SHOWN = 5  # columns that are named in a hint
ENERGY = PLANCK * LIGHT * 1e9  # of a photon, times its wavelength in nm [J nm]


def read_file(path: str, column: str = "") -> Table:
    """Read a spectrum from a file, or from standard input where the path is '-'."""
    if path == "-":
        return _Reader("stdin", stdio.read, column).table()
    name = quote_path(path)
    try:
        with open(path, "rb", buffering=0) as file:
            return _Reader(name, file.read, column).table()
    except OSError as error:
        raise ConditionError(
            f"cannot read {name}: {error.strerror}", "a file with a spectrum"
        ) from None


class _Layout(NamedTuple):
    """Where the numbers of a file stand."""

    delimiter: str | None
    header: list[str]
    width: int
    place: int  # the column of the values
    title: str


class _Reader:
    """One file: its delimiter, its header, its columns; read a block at a time."""

    def __init__(self, name: str, read: Callable[[int], bytes], column: str) -> None:
        self.name = name
        self.read = read
        self.column = column
        self.notes: list[str] = []
        self.comments: list[str] = []
        self.decimals = columns.Decimals()
        self.grid, self.values = array("d"), array("d")
        self.lines = array("q")  # of the rows

    def error(self, number: int, problem: str, hint: str) -> ConditionError:
        where = f", line {number}" if number else ""
        return ConditionError(f"{self.name}{where}: {problem}", hint)

    def blocks(self) -> Iterator[tuple[int, list[str]]]:
        """The lines of the file, many at a time, and the number of the first of them."""
        number, size, rest = 1, 0, b""
        encoding = "utf-8-sig"
        while True:
            data = self.read(BLOCK)
            size += len(data)
            if size > LARGEST:
                raise self.error(0, f"more than {LARGEST} bytes", "fewer rows")
            ends = data.replace(b"\r\n", b"\n\n") if b"\r" in data else data
            cut = max(ends.rfind(b"\n"), ends.rfind(b"\r", 0, -1)) + 1 if data else 0
            whole, rest = (rest + data[:cut], data[cut:]) if cut else (b"", rest + data)
            if not data:
                whole = rest
            elif len(rest) > LONGEST:
                problem = f"a line of more than {LONGEST} bytes"
                raise self.error(number, problem, "a wavelength and a value in every row")
            try:
                lines = whole.decode(encoding).splitlines()
            except UnicodeDecodeError as error:
                number += whole[: error.start].count(b"\n")
                raise self.error(
                    number, "not UTF-8 text", "the file in UTF-8 (iconv converts it)"
                ) from None
            if whole:
                yield number, lines
                number += len(lines)
                encoding = "utf-8"
            if not data:
                return

    def rows(self, lines: list[str], number: int) -> Iterator[tuple[int, str]]:
        """The lines with data, with their numbers; comments are kept apart."""
        for number, line in enumerate(lines, number):  # noqa: B020
            if not line or line.isspace():
                continue
            if line.lstrip().startswith(columns.COMMENTS):
                if len(self.comments) < MOST_COMMENTS:
                    self.comments.append(line.lstrip("#%/; \t"))
            else:
                yield number, line

    def table(self) -> Table:
        """The whole file."""
        layout = None
        first: list[tuple[int, str]] = []  # the rows that show how the file is laid out
        for number, lines in self.blocks():
            if len(self.grid) > MOST:
                raise self.error(number, f"more than {MOST} rows", "fewer of them")
            if layout and self.take_plain(lines, number, layout):
                continue
            rows = self.rows(lines, number)
            if not layout:
                first += rows
                if len(first) < 3:
                    continue
                layout, rows = self.layout(first), iter(first)
            self.take(rows, layout)
        if not layout:
            layout = self.layout(first)
            self.take(iter(first), layout)
        if len(self.grid) < 2:
            count = len(self.grid)
            raise self.error(0, f"{count} row of data is no spectrum", "two rows or more")
        return self.finish(layout)

    def layout(self, rows: list[tuple[int, str]]) -> _Layout:
        """The delimiter, the header and the columns, from the first rows; the header is taken out.

        They are the table's, or all there is.
        """
        if not rows:
            raise self.error(0, "there is no data", "two columns: wavelength and value")
        typical = rows[min(1, len(rows) - 1)][1]  # no header, unless it is alone
        delimiter, _ = columns.dialect(typical)
        header = columns.cells(rows[0][1], delimiter)
        if columns.is_number(header[0], delimiter != ","):
            header = []
        else:
            del rows[0]
        if not rows:
            raise self.error(0, "0 rows of data are no spectrum", "two rows or more")
        width = len(columns.cells(rows[0][1], delimiter))
        self.check_titles(header)
        place, title = self.value_column(header or self.commented(width), width, rows[0][0])
        return _Layout(delimiter, header, width, place, title)

    def commented(self, width: int) -> list[str]:
        """The titles of columns, where a comment has them."""
        for comment in reversed(self.comments):
            cells = columns.cells(comment, columns.dialect(comment)[0])
            if len(cells) == width and not columns.is_number(cells[0], False):
                return cells
        return []

    def take_plain(self, lines: list[str], number: int, layout: _Layout) -> bool:
        """Take in rows that are numbers and nothing else; say whether they are."""
        marks = self.decimals
        if marks.comma or marks.doubtful:
            return False
        columns = _columns(lines, layout, len(self.grid) > MANY)
        if columns is None:
            return False
        if not marks.point:
            pointed = (n for n, line in enumerate(lines, number) if "." in line)
            marks.point = next(pointed, 0)
        self.grid.extend(columns[0])
        self.values.extend(columns[1])
        self.lines.extend(range(number, number + len(lines)))
        return True

    def take(self, rows: Iterator[tuple[int, str]], layout: _Layout) -> None:
        """Take in rows one by one, and say which of them is wrong."""
        for number, line in rows:
            cells = columns.cells(line, layout.delimiter)
            if len(cells) != layout.width:
                raise self.error(
                    number,
                    f"{len(cells)} columns instead of {layout.width}",
                    "a value in every column",
                )
            comma = layout.delimiter != ","
            self.grid.append(self.number(cells[0], comma, number))
            self.values.append(self.number(cells[layout.place], comma, number))
            self.lines.append(number)

    def check_titles(self, header: list[str]) -> None:
        """Refuse a first column that says it is something else than wavelengths."""
        plain = [columns.plain(title) for title in header]
        if any(map(titles.is_wavelength, plain[1:])):
            raise self.error(0, "the wavelengths are not in the first column", "wavelengths first")
        if plain and any(word in plain[0] for word in ("freq", "energy", "wavenumber")):
            raise self.error(0, f"'{quote(header[0])}' is no wavelength", "wavelengths first")

    def finish(self, layout: _Layout) -> Table:
        """Give the numbers their units, and say what was repaired or is odd."""
        if doubt := self.decimals.doubt():
            raise self.error(*doubt, columns.MARKS)
        grid, values = self.sorted()
        nanometres = self.wavelength_unit(layout.header, grid[0], grid[-1])
        low = min(values)
        if low < -NOISE * max(values):
            raise self.error(0, f"a value of {low:g}: too far below 0 for noise", "no dark light")
        if low < 0:
            count = sum(value < 0 for value in values)
            self.notes.append(f"{count} negative values (down to {low:g}) are kept as noise")
        if not any(values):
            raise self.error(0, "every value is 0", "a spectrum with light in it")
        try:
            meant = titles.values(layout.title)
        except ConditionError as error:
            raise self.error(0, error.message, error.hint) from None
        if len(grid) > MANY:
            found = _table_of_many(self.name, grid, values, nanometres, meant)
        else:
            xs, ys = [x * nanometres for x in grid], [y * meant.factor for y in values]
            if meant.are_photons:
                ys = [y * ENERGY / x for x, y in zip(xs, ys, strict=True)]
            found = Table(self.name, xs, ys, absolute=meant.absolute)
        found.notes = (*self.notes, *found.notes)
        found.reading = meant.said
        return found

    def value_column(self, header: list[str], width: int, number: int) -> tuple[int, str]:
        """Which column has the values, and its title."""
        if width < 2:
            raise self.error(number, "one column only", "a wavelength and a value in every row")
        if header and len(header) != width:
            problem = f"{len(header)} titles over {width} columns"
            raise self.error(number, problem, "a title for each column, or no titles")
        names = header or [""] * width
        if not self.column:
            if width > 2:
                chosen = f"{self.name}:COLUMN (or {option('column')})"
                raise self.error(
                    number,
                    f"there are {width - 1} columns of values",
                    f"{chosen} with one of: {_named(names)}",
                )
            return 1, names[1]
        if self.column in names[1:]:
            place = names.index(self.column)
        elif self.column.isdecimal() and 2 <= int(self.column) <= width:
            place = int(self.column) - 1
        else:
            near = nearest(self.column, [quote(name) for name in names[1:]], SHOWN)
            problem = f"there is no column of values '{quote(self.column)}'"
            raise self.error(0, problem, ", ".join(near) or _named(names))
        self.notes.append(f"values from column {place + 1} {quote(names[place])}".strip())
        return place, names[place]

    def number(self, cell: str, comma: bool, line: int) -> float:
        if not cell:
            raise self.error(line, "a value is missing", "a number, or the line left out")
        value = columns.finite(cell, comma)
        if value is None:
            raise self.error(
                line, f"'{quote(cell)}' is not a number", "a number, or # before a comment"
            )
        if comma and (problem := self.decimals.conflict(cell, line)):
            raise self.error(line, problem, columns.MARKS)
        return value

    def wavelength_unit(self, header: list[str], low: float, high: float) -> float:
        """Nanometres per unit of the first column: declared, or plain from the numbers."""
        if low <= 0:
            raise self.error(0, f"a wavelength of {low:g}", "wavelengths above 0")
        try:
            factor, note = titles.wavelengths(header[:1], self.comments, low, high)
        except ConditionError as error:
            raise self.error(0, error.message, error.hint) from None
        self.notes.append(note)
        return factor

    def sorted(self) -> tuple[Sequence[float], Sequence[float]]:
        """Rising wavelengths: a falling table is turned round, any other is sorted; both said."""
        grid, values, lines = self.grid, self.values, self.lines
        if all(map(lt, grid, grid[1:])):
            return grid, values
        if all(map(lt, grid[1:], grid)):
            self.notes.append("the wavelengths fall; the rows are taken in reverse")
            return grid[::-1], values[::-1]
        order = sorted(range(len(grid)), key=grid.__getitem__)
        for before, after in pairwise(order):
            if grid[before] == grid[after]:
                first, second = sorted((lines[before], lines[after]))
                raise self.error(
                    second,
                    f"the wavelength {grid[after]:g} nm stands in line {first} already",
                    "each once",
                )
        self.notes.append("the wavelengths are not in order; the rows are sorted")
        return array("d", [grid[i] for i in order]), array("d", [values[i] for i in order])


def _columns(lines: list[str], layout: _Layout, are_many: bool) -> Any:
    """Wavelengths and values of rows that are numbers and nothing else; None of others."""
    try:
        if are_many and lines[0].strip():
            import numpy

            rows = numpy.loadtxt(lines, delimiter=layout.delimiter, comments=None, ndmin=2)
            if rows.shape != (len(lines), layout.width) or not numpy.isfinite(rows).all():
                return None
            return rows[:, 0], rows[:, layout.place]
        split = [line.split(layout.delimiter) for line in lines]
        if [len(cells) for cells in split].count(layout.width) != len(split):
            return None
        texts = [cells[0] for cells in split], [cells[layout.place] for cells in split]
        for text in map(" ".join, texts):
            if not text.isascii() or "_" in text:  # float() would read 5_50, and other digits
                return None
        columns = [list(map(float, column)) for column in texts]
    except ValueError:
        return None
    total = sum(map(sum, columns))
    return columns if total - total == 0 else None


def _table_of_many(
    name: str,
    grid: Sequence[float],
    values: Sequence[float],
    nanometres: float,
    meant: titles.Meaning,
) -> Table:
    import numpy

    from radcalc.spectra.arrays import ArrayTable

    xs: Any
    ys: Any
    xs, ys = numpy.array(grid) * nanometres, numpy.array(values) * meant.factor
    if meant.are_photons:
        ys = ys * ENERGY / xs
    return ArrayTable(name, xs, ys, absolute=meant.absolute)


def _named(titles: Sequence[str]) -> str:
    """The columns of values by their titles, or else their numbers."""
    return listed([title or str(number) for number, title in enumerate(titles, 1) if number > 1])
