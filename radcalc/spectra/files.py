"""Measured spectra from files: two or more columns, whatever separates them.

What can be read in one way only is read, and said; everything else is an error with its line.
"""

import os
import re
from collections.abc import Iterator
from itertools import pairwise
from operator import lt
from typing import Any, NamedTuple

from radcalc import stdio
from radcalc.errors import ConditionError, RadcalcError, listed, option, quote
from radcalc.quantities.light import PER_WAVELENGTH, RADIANT, read
from radcalc.spectra.spectrum import Table
from radcalc.units.table import resolve

UNITS = {
    "nm": 1.0,
    "nanometre": 1.0,
    "nanometer": 1.0,
    "um": 1e3,
    "micron": 1e3,
    "micrometre": 1e3,
    "micrometer": 1e3,
    "angstrom": 0.1,
    "å": 0.1,
    "mm": 1e6,
    "m": 1e9,
}
# A wavelength with its unit: wavelength (nm), wavelength [nm], wavelength in nm, wavelength_nm.
DECLARED = re.compile(r"(?:wave ?length|lambda|\bwl)s?\W*(?:in )?[\s_(\[:,]*([a-zå]+)[\s)\]]*$")
BRACKETED = re.compile(r"[(\[]\s*([^)\]]*?)\s*[)\]]\s*$")
DELIMITERS = ("\t", ";", "|", ",")
LARGE = 1 << 18  # bytes from which a regular file is worth loading NumPy for
NOISE = 0.05  # of the peak: negative values within it are a spectrometer's noise
LARGEST = 1 << 29  # bytes
COMMENTS = ("#", "%", "//", ";;")


def read_file(path: str, column: str = "") -> Table:
    """Read a spectrum from a file, or from standard input where the path is '-'."""
    name = "stdin" if path == "-" else quote(path)
    try:
        if path == "-":
            raw = stdio.read_all(LARGEST)
        else:
            if os.path.getsize(path) > LARGE:
                table = _large(name, path, column)
                if table is not None:
                    return table
            with open(path, "rb") as file:
                raw = file.read(LARGEST)
                if file.read(1):
                    raise ConditionError(
                        f"{name} is too large to be explained", "a regular table of numbers"
                    )
    except OSError as error:
        raise ConditionError(
            f"cannot read {name}: {error.strerror}", "a file with a spectrum"
        ) from None
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        raise ConditionError(
            f"{name}, line {line}: not UTF-8 text", "the file in UTF-8 (iconv converts it)"
        ) from None
    return _Reader(name, text.splitlines(), column).table()


def _large(name: str, path: str, column: str) -> Table | None:
    """Read a large, regular file with NumPy; None leaves it to the reader that explains."""
    import numpy

    from radcalc.spectra.arrays import ArrayTable

    with open(path, "rb") as file:
        head = file.read(LARGE).decode("utf-8-sig", "replace").splitlines()[:-1]
    reader = _Reader(name, head, column)
    try:
        layout = reader.layout()
        if layout.comma:
            return None
        data = numpy.loadtxt(
            path,
            delimiter=layout.delimiter,
            skiprows=layout.first - 1,
            comments=None,
            ndmin=2,
            encoding="utf-8-sig",
        )
    except (ValueError, RadcalcError):
        return None
    grid, values = data[:, 0].copy(), data[:, layout.place].copy()
    regular = numpy.isfinite(grid).all() and numpy.isfinite(values).all()
    if not regular or not (numpy.diff(grid) > 0).all():
        return None
    return reader.finish(grid, values, layout, ArrayTable)


# The radiant quantity by the powers of 1/area and 1/solid angle.
QUANTITIES = {
    (0, 0): "flux",
    (0, 1): "intensity",
    (1, 0): "irradiance",
    (1, 1): "radiance",
}


class _Layout(NamedTuple):
    """Where the numbers of a file stand."""

    delimiter: str | None
    comma: bool
    header: list[str]
    first: int  # the line of the first row of data
    place: int  # the column of the values
    title: str


class _Reader:
    """One file: its delimiter, its header, its columns."""

    def __init__(self, name: str, lines: list[str], column: str) -> None:
        self.name = name
        self.lines = lines
        self.column = column
        self.notes: list[str] = []
        self.comments: list[str] = []
        self.data: list[tuple[int, str]] = []

    def error(self, number: int, problem: str, hint: str) -> ConditionError:
        where = f", line {number}" if number else ""
        return ConditionError(f"{self.name}{where}: {problem}", hint)

    def rows(self) -> Iterator[tuple[int, str]]:
        """The lines with data, with their numbers; comments are kept apart."""
        for number, line in enumerate(self.lines, 1):
            if not line or line.isspace():
                continue
            if line.lstrip().startswith(COMMENTS):
                self.comments.append(line.lstrip("#%/; \t"))
            else:
                yield number, line

    def table(self) -> Table:
        """The whole file, one line at a time."""
        layout = self.layout()
        rows = [(number, line) for number, line in self.data if number >= layout.first]
        if len(rows) < 2:
            raise self.error(0, f"{len(rows)} row of data is no spectrum", "two rows or more")
        grid, values = self.numbers(rows, layout.delimiter, layout.comma, layout.place)
        grid, values = self.sorted(grid, values, rows)
        return self.finish(grid, values, layout, Table)

    def layout(self) -> _Layout:
        """The delimiter, the header and the columns, from the lines there are."""
        self.data = list(self.rows())
        if not self.data:
            raise self.error(0, "there is no data", "two columns: wavelength and value")
        typical = self.data[min(1, len(self.data) - 1)][1]  # no header, unless it is alone
        delimiter, comma = self.dialect(typical)
        header = self.cells(self.data[0][1], delimiter)
        rows = self.data
        if _is_number(header[0], comma):
            header = []
        else:
            rows = rows[1:]
        if not rows:
            raise self.error(0, "0 rows of data are no spectrum", "two rows or more")
        width = len(self.cells(rows[0][1], delimiter))
        self.check_titles(header)
        place, title = self.value_column(header, width, rows[0][0])
        return _Layout(delimiter, comma, header, rows[0][0], place, title)

    def check_titles(self, header: list[str]) -> None:
        """Refuse a first column that says it is something else than wavelengths."""
        titles = [_plain(title) for title in header]
        if any(DECLARED.match(title) or title.startswith("wavelength") for title in titles[1:]):
            raise self.error(0, "the wavelengths are not in the first column", "wavelengths first")
        if titles and any(word in titles[0] for word in ("freq", "energy", "wavenumber")):
            raise self.error(0, f"'{quote(header[0])}' is no wavelength", "wavelengths first")

    def finish(self, grid: Any, values: Any, layout: _Layout, kind: type[Table]) -> Table:
        """Give the numbers their units, and say what was repaired or is odd."""
        scale = self.wavelength_unit(layout.header, grid[0], grid[-1])
        low = values.min() if kind is not Table else min(values)
        if low < -NOISE * max(values):
            raise self.error(0, f"a value of {low:g}: too far below 0 for noise", "no dark light")
        if low < 0:
            count = int(sum(value < 0 for value in values))
            self.notes.append(f"{count} negative values (down to {low:g}) are kept as noise")
        if not any(values):
            raise self.error(0, "every value is 0", "a spectrum with light in it")
        absolute, factor = self.absolute(layout.title)
        if kind is Table:
            grid = grid if scale == 1 else [x * scale for x in grid]
            values = values if factor == 1 else [value * factor for value in values]
        else:
            grid, values = grid * scale, values * factor
        return kind(self.name, grid, values, notes=tuple(self.notes), absolute=absolute)

    def dialect(self, line: str) -> tuple[str | None, bool]:
        """The delimiter (None: blanks) and whether numbers have a decimal comma."""
        for delimiter in DELIMITERS[:3]:
            if delimiter in line:
                return delimiter, "," in line
        if "," in line:
            if len(line.split()) > 1 and all(_is_number(cell, True) for cell in line.split()):
                return None, True
            return ",", False
        return None, False

    def cells(self, line: str, delimiter: str | None) -> list[str]:
        return [cell.strip().strip('"').strip() for cell in line.split(delimiter)]

    def value_column(self, header: list[str], width: int, number: int) -> tuple[int, str]:
        """Which column has the values, and its title."""
        if width < 2:
            raise self.error(number, "one column only", "a wavelength and a value in every row")
        titles = header if len(header) == width else [""] * width
        named = listed([t or str(i) for i, t in enumerate(titles, 1) if i > 1])
        if not self.column:
            if width > 2:
                raise self.error(
                    number,
                    f"there are {width - 1} columns of values",
                    f"{self.name}:COLUMN (or {option('column')}) with one of: {named}",
                )
            return 1, titles[1]
        if self.column in titles[1:]:
            place = titles.index(self.column)
        elif self.column.isdecimal() and 2 <= int(self.column) <= width:
            place = int(self.column) - 1
        else:
            raise self.error(0, f"there is no column of values '{quote(self.column)}'", named)
        self.notes.append(f"values from column {place + 1} {quote(titles[place])}".strip())
        return place, titles[place]

    def numbers(
        self, rows: list[tuple[int, str]], delimiter: str | None, comma: bool, place: int
    ) -> tuple[list[float], list[float]]:
        """Both columns as numbers; the slow way only to say what is wrong, and where."""
        try:
            if comma or not all(line.isascii() and "_" not in line for _, line in rows):
                raise ValueError
            split = [line.split(delimiter) for _, line in rows]
            width = len(split[0])
            grid = [float(cells[0]) for cells in split]
            values = [float(cells[place]) for cells in split]
            regular = all(len(cells) == width for cells in split)
            total = sum(grid) + sum(values)
            if regular and total - total == 0:
                return grid, values
        except (ValueError, IndexError):
            pass
        grid, values = [], []
        width = len(self.cells(rows[0][1], delimiter))
        for number, line in rows:
            cells = self.cells(line, delimiter)
            if len(cells) != width:
                raise self.error(
                    number, f"{len(cells)} columns instead of {width}", "a value in every column"
                )
            for target, cell in ((grid, cells[0]), (values, cells[place])):
                target.append(self.number(cell, comma, number))
        return grid, values

    def number(self, cell: str, comma: bool, line: int) -> float:
        if not cell:
            raise self.error(line, "a value is missing", "a number, or the line left out")
        if not _is_number(cell, comma):
            raise self.error(
                line, f"'{quote(cell)}' is not a number", "a number, or # before a comment"
            )
        value = float(cell.replace(",", ".") if comma else cell)
        if value - value != 0:
            raise self.error(
                line, f"'{quote(cell)}' is not a number", "a number, or the line left out"
            )
        return value

    def wavelength_unit(self, header: list[str], low: float, high: float) -> float:
        """Nanometres per unit of the first column: declared, or plain from the numbers."""
        if low <= 0:
            raise self.error(0, f"a wavelength of {low:g}", "wavelengths above 0")
        titles = [_plain(title) for title in header]
        bare = titles[:1] if titles and titles[0].rstrip("s") in UNITS else []
        for text in titles[:1] + [_plain(comment) for comment in self.comments]:
            found = DECLARED.search(text)
            word = found.group(1) if found else ""
            if text in titles[:1]:
                bracket = BRACKETED.search(text)
                word = bracket.group(1) if bracket else text if bare else word
                if bracket and word.rstrip("s") not in UNITS:
                    problem = f"wavelengths in '{quote(word)}', which is no unit of length here"
                    raise self.error(0, problem, "nm, um, angstrom, mm or m")
            if word.rstrip("s") in UNITS and word != "":
                self.notes.append(f"the wavelengths are in {quote(word)}, as declared")
                return UNITS[word.rstrip("s")]
        if 100 <= low < 2000 and high <= 20000:
            self.notes.append("the wavelengths are taken as nanometres, from their size")
            return 1.0
        if 0.1 <= low < 2.5 and high <= 100:
            self.notes.append("the wavelengths are taken as micrometres, from their size")
            return 1e3
        if high < 1e-4:
            self.notes.append("the wavelengths are taken as metres, from their size")
            return 1e9
        raise self.error(
            0,
            f"wavelengths from {low:g} to {high:g} in a unit that is not declared",
            "a header such as: wavelength (nm), value",
        )

    def sorted(
        self, grid: list[float], values: list[float], rows: list[tuple[int, str]]
    ) -> tuple[list[float], list[float]]:
        """Rising wavelengths: a falling table is turned round, any other is sorted; both said."""
        if all(map(lt, grid, grid[1:])):
            return grid, values
        if all(map(lt, grid[1:], grid)):
            self.notes.append("the wavelengths fall; the rows are taken in reverse")
            return grid[::-1], values[::-1]
        order = sorted(range(len(grid)), key=grid.__getitem__)
        for before, after in pairwise(order):
            if grid[before] == grid[after]:
                first, second = sorted((rows[before][0], rows[after][0]))
                raise self.error(
                    second,
                    f"the wavelength {grid[after]:g} nm stands in line {first} already",
                    "each once",
                )
        self.notes.append("the wavelengths are not in order; the rows are sorted")
        return [grid[i] for i in order], [values[i] for i in order]

    def absolute(self, title: str) -> tuple[str, float]:
        """The radiant quantity and the scale to W/../nm, where the title has a unit."""
        for opening, closing in ("()", "[]"):
            if opening in title and closing in title:
                text = title[title.index(opening) + 1 : title.rindex(closing)]
                try:
                    unit = resolve(text)
                except RadcalcError:  # a title is free text: no unit, no absolute values
                    continue
                facts = read(unit)
                if facts is None or not unit.is_light:
                    continue  # a percentage, say: relative values
                if facts.kind == RADIANT and facts.axis == PER_WAVELENGTH and not facts.time:
                    return QUANTITIES[facts.area, facts.solid_angle], unit.factor * 1e-9
                raise self.error(
                    0,
                    f"values in {quote(text)} are no radiant power per wavelength",
                    "values in W/m2/nm or the like",
                )
        return "", 1.0


def _plain(text: str) -> str:
    """A title or a comment in small letters, with one kind of micro."""
    return text.strip().lower().replace("µ", "u").replace("μ", "u")


def _is_number(cell: str, comma: bool) -> bool:
    if not cell.isascii() or "_" in cell:  # float() would read 5_50 and other scripts' digits
        return False
    try:
        float(cell.replace(",", ".") if comma else cell)
    except ValueError:
        return False
    return True
