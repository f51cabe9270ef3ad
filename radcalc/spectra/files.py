"""Measured spectra from files: columns of numbers with any separator, and the files of meters.

Unambiguous files are read, with notes; anything else is an error with its line.
"""

import math
import re
from array import array
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from io import BytesIO
from itertools import chain, pairwise
from operator import lt
from typing import Any, NamedTuple

from radcalc.errors import ConditionError, Hint, UsageError, call, correct, listed, option, quote
from radcalc.files import Lines, Text, columns, reading, refusal, signatures
from radcalc.files.columns import SEARCHED, Head, first_lines, is_number
from radcalc.files.columns import Table as TextTable
from radcalc.quantities.column_titles import find
from radcalc.spectra import AXES, column_titles, contents, instruments
from radcalc.spectra.contents import NO_FIGURES, Contents, Figure
from radcalc.spectra.instruments import FORMATS, TABLE_MARK
from radcalc.spectra.observers import LIGHT, PLANCK
from radcalc.spectra.spectrum import LONGEST, SHORTEST, STRONGEST, VISIBLE, WEAKEST, Table

NOISE = 0.05  # of the peak, or of the total: smaller negative values are noise of a spectrometer
SMALL = 1e-4  # fraction of the total that needs no note
SAME = 1e-4  # relative difference of steps that count as the same
FEW = 0.1  # largest fraction of other steps if most are the same
MANY = 10_000  # with this number of rows, NumPy is loaded
MOST = 20_000_000  # rows
MOST_BEFORE = 1000  # lines before a table, and comments
MOST_OF_FORMAT = 1 << 24  # characters of a file that is not a plain table
COUNT = re.compile(r":\s*\d+\s*")  # the last line of SpectraWiz
INDICES = ("#", "pixel", "pixels", "index", "no", "no.", "nr", "nr.", "row", "line", "point")
DIGIT = re.compile(r"\d")
WORDS = 2  # after a number, between blanks, that make a line a sentence: 100 scans averaged
DENSE = 1 / 300  # steps of photons, as parts of their wavelength: their sums are within 2e-6
FINE = 1 / 2000  # steps between the points of a coarser table: within 5e-8
BETWEEN = 2000  # of them at most, from one point to the next
ENERGY = PLANCK * LIGHT * 1e9  # of a photon, times its wavelength in nm [J nm]


ONE_TABLE = "a file for each table"


def read_file(path: str, column: str = "", unit: str = "", axis: str = "") -> Table:
    """Read a spectrum from a file, or from standard input for the path '-'.

    `unit` is that of the values, `axis` that of the wavelengths; they win over those in the file.
    """
    with reading(path, "a file with a spectrum") as (name, read):
        typed = column_titles.typed(unit) if unit else None
        return _Reader(name, read, column, typed, path, axis).table()


def read_text(name: str, text: str, column: str = "", unit: str = "") -> Table:
    """Read a spectrum from the text of a table, as `read_file` reads it from a file."""
    typed = column_titles.typed(unit) if unit else None
    return _Reader(name, BytesIO(text.encode()).read, column, typed).table()


def is_spectrum(lines: Lines) -> bool:
    """Return whether the first lines of a file are those of a spectrum.

    It has the format of a meter, or a title of wavelengths over numbers.
    """
    if form := next((form for form in FORMATS if form.begins(lines)), None):
        is_root = (instruments.SPDX_ROOT in line.upper() for line in lines[:MOST_BEFORE])
        return form is not instruments.SPDX or any(is_root)
    if any(map(column_titles.STATED.match, map(columns.plain, lines[:MOST_BEFORE]))):
        return True
    rows = [*enumerate(lines, 1)][: 2 * MOST_BEFORE]
    try:
        head = SpectrumHead(partial(refusal, ""), rows)
    except ConditionError:  # of doubtful titles, which the reader reports
        cells = [(columns.cells_alone(line) or [""]) for _, line in rows]
        first = next((k for k, row in enumerate(cells) if is_number(row[0])), 0)
        return any(map(_has_wavelengths, lines[max(first - 2, 0) : first]))
    above = [*[line for _, line in head.preamble[-1:]], *head.comments]
    is_titled = any(map(_is_of_wavelengths, head.table.titles)) or any(map(_has_wavelengths, above))
    return head.table.width > 1 and is_titled


def _has_wavelengths(line: str) -> bool:
    """Return whether a line is a title of wavelengths, or has one."""
    cells = columns.cells_alone(line)
    return any(map(_is_of_wavelengths, (*cells, line)))


def _is_of_wavelengths(title: str) -> bool:
    plain = columns.plain(title)
    if len(plain) > column_titles.LONGEST or not plain:
        return False
    if plain in ("m", "mm"):  # a distance
        return False
    return column_titles.is_of_wavelengths(plain)


class Curve(NamedTuple):
    """A function of the wavelength [nm] in a file: its points, the title of its values, notes."""

    name: str
    grid: Sequence[float]
    values: Sequence[float]
    title: str
    notes: tuple[str, ...]


def read_curve(path: str, column: str = "") -> Curve:
    """Read a weight, a responsivity or a transmittance from a file; its values are 0 or more."""
    with reading(path, "a file with a weight") as (label, read):
        return _CurveReader(label, read, column, None, path).curve()


class SpectrumHead(Head):
    """The head of a table whose rows begin with a number, and are no sentences."""

    def __init__(
        self,
        refuse: Callable[[int, str, str], ConditionError],
        lines: Sequence[tuple[int, str]],
    ) -> None:
        self.refuse = refuse
        super().__init__([row for row in lines if not COUNT.fullmatch(row[1])])
        if self.preamble:
            self.assumptions.append(f"the table begins in line {self.begin}")

    def error(self, number: int, problem: str, hint: Hint) -> ConditionError:
        return self.refuse(number, problem, str(hint))

    def no_data(self, rows: Sequence[tuple[int, str]]) -> ConditionError:
        if not rows:
            return self.error(0, "there is no data", "two columns: wavelength and value")
        where = f" in its first {SEARCHED} lines" if len(rows) == SEARCHED else ""
        hint = "rows of a wavelength and a value, as text"
        return self.error(0, f"there is no row of numbers{where}", hint)

    def is_row(self, line: str, is_named: bool) -> bool:
        delimiter, _ = columns.dialect(line)
        first, *others = columns.cells(line, delimiter)
        words = (cell for cell in others if not is_number(cell))
        return is_number(first) and (bool(delimiter) or sum(1 for _ in words) < WORDS)

    def skipped(self, rows: Sequence[tuple[int, str]]) -> int:
        """Return where titles of wavelengths are below another table, as of a meter's results."""
        count = next((k for k, row in enumerate(rows) if self.is_row(row[1], False)), len(rows))

        def titles(k: int) -> list[str]:
            return columns.cells(rows[k][1], columns.dialect(rows[min(k + 1, len(rows) - 1)][1])[0])

        if not 0 < count < len(rows) or column_titles.is_of_wavelengths(
            columns.plain(titles(count - 1)[0])
        ):
            return 0
        places = range(count + 1, len(rows) - 1)
        later = next((k for k in places if len(titles(k)) > 1 and self.are_titles(titles(k))), 0)
        if later:
            problem = f"the table of wavelengths is read, not that of line {rows[count][0]}"
            self.assumptions.append(problem)
        return later

    def are_names(self, cells: Sequence[str]) -> bool:
        """Return whether cells may be titles, which may be numbers except the first."""
        return not is_number(cells[0]) and not self._is_of_row(cells)

    def is_bad(self, *lines: str) -> bool:
        above, cells = map(self.cells_of, (lines[0], lines[-1]))
        is_below = len(lines) > 1 and len(above) == len(cells) and self.are_titles(above)
        has_number = any(map(is_number, cells[1:])) and len(cells) == len(self.cells)
        return self._is_of_row(cells) or (is_below and has_number)

    def _is_of_row(self, cells: Sequence[str]) -> bool:
        """Return whether cells are those of a row whose wavelength is not a number: 38O,1."""
        first = columns.plain(cells[0])
        has_number = any(map(is_number, cells[1:])) and len(cells) == len(self.cells)
        return has_number and not column_titles.is_wavelength(first) and bool(DIGIT.search(first))

    def are_titles(self, cells: Sequence[str]) -> bool:
        """Return whether cells are plainly titles of wavelengths and of values.

        A preamble may have a line such as `wavelength range,380-780` or `wavelength unit,nm`.
        """
        return column_titles.is_wavelength(columns.plain(cells[0])) and not any(
            cell[:1].isdigit() or columns.plain(cell) in column_titles.NANOMETRES
            for cell in cells[1:]
        )

    def check_text(self, number: int, line: str) -> None:
        """Raise for a line before a table with too few or many titles, or of other data."""
        if line.startswith(TABLE_MARK):
            return
        text = columns.plain(line)
        is_sentence = self.delimiter is None and not column_titles.is_wavelength(text)
        if not is_sentence and sum(map(bool, self.cells_of(line))) > 1:
            raise self.unlike(number, line)
        if column_titles.NO_LIGHT.search(text) and ":" not in line:
            raise self.error(number, f"'{quote(line.strip())}' is not light", column_titles.KNOWN)


class _Layout(NamedTuple):
    table: TextTable
    axis: int  # the column of the wavelengths
    place: int  # the column of the values
    title: str
    begin: int  # the line of the first row

    @property
    def header(self) -> list[str]:
        """The title of the wavelengths, if there are titles."""
        return [self.table.titles[self.axis]] if self.table.titles else []


class _Reader:
    """The reader of one file, in blocks."""

    def __init__(
        self,
        name: str,
        read: Callable[[int], bytes],
        column: str,
        typed: column_titles.Meaning | None,
        path: str = "",
        axis: str = "",
    ) -> None:
        self.name, self.path, self.axis = name, path, axis
        self.typed = typed
        self.text = Text(name, read, "a wavelength and a value")
        self.column = column
        self.notes: list[str] = []
        self.comments: list[str] = []
        self.preamble: list[str] = []
        self.count = 0  # of rows, according to the preamble
        self.is_marked = self.is_over = False  # start of the table; its end, if it is marked
        self.grid, self.values = array("d"), array("d")
        self.lines = array("q")  # of the rows

    def error(self, number: int, problem: str, hint: Hint) -> ConditionError:
        return refusal(self.name, number, problem, hint)

    def table(self) -> Table:
        blocks = self.text.blocks()
        first = next(blocks, (1, []))
        if signatures.of_luminaire(first[1]):
            problem = f"{self.name} is a luminaire file, not a spectrum"
            raise ConditionError(problem, call("point-source", distribution=self.path))
        for form in FORMATS:
            if form.begins(first[1]):
                return self.table_of(
                    form.read(self.all_lines(first, blocks), self.name, self.column)
                )
        return self.plain_table(chain([first], blocks))

    def all_lines(self, first: tuple[int, Lines], blocks: Iterable[tuple[int, Lines]]) -> Lines:
        collected = list(first[1])
        for _, lines in blocks:
            collected += lines
            if sum(map(len, collected)) > MOST_OF_FORMAT:
                raise self.error(0, f"more than {MOST_OF_FORMAT} characters", "fewer rows")
        return collected

    def table_of(self, contents: Contents) -> Table:
        self.notes += contents.notes
        table = TextTable(self.error, None if contents.has_commas else ",", 2)
        for number, place, value in contents.rows:
            self.grid.append(table.number(place, number, is_value=False))
            self.values.append(table.number(value, number) / contents.divisor)
            self.lines.append(number)
        table.finish()
        if self.typed:
            return self.finish(1.0, (self.typed,))
        return self.finish(1.0, contents.meanings, contents.figures)

    def rows(self, lines: Lines, number: int) -> Iterator[tuple[int, str]]:
        for number, line in enumerate(lines, number):  # noqa: B020
            if not line or line.isspace():
                continue
            if columns.is_comment(line) or COUNT.fullmatch(line):
                if len(self.comments) < MOST_BEFORE:
                    self.comments.append(columns.comment_text(line)[: column_titles.LONGEST])
            else:
                yield number, line

    def plain_table(self, blocks: Iterable[tuple[int, Lines]]) -> Table:
        return self.finish_columns(self.read_rows(blocks))

    def read_rows(self, blocks: Iterable[tuple[int, Lines]]) -> _Layout:
        """Read rows of numbers; the first lines determine the delimiter and the columns."""
        blocks = iter(blocks)
        lines = first_lines(blocks)
        layout = self.layout(lines)
        begin = layout.begin
        for number, block in chain([(begin, [line for k, line in lines if k >= begin])], blocks):
            if len(self.grid) > MOST:
                raise self.error(number, f"more than {MOST} rows", "fewer of them")
            if not self.take_plain(block, number, layout):
                self.take(self.rows(block, number), layout)
            if self.is_over:
                break
        layout.table.finish()
        count = len(self.grid)
        if self.count and count != self.count:
            problem = f"{count} rows, but its own count of pixels is {self.count}"
            raise self.error(self.lines[-1], problem, "the whole file")
        return layout

    def layout(self, lines: Sequence[tuple[int, str]]) -> _Layout:
        """Return the table and its columns, with the meaning of the lines before it."""
        head = SpectrumHead(self.error, lines)
        self.notes += head.assumptions
        self.preamble = [line[: column_titles.LONGEST] for _, line in head.preamble]
        self.comments = [text[: column_titles.LONGEST] for text in head.comments[:MOST_BEFORE]]
        self.is_marked = any(line.startswith(TABLE_MARK) for line in self.preamble)
        try:
            self.count = instruments.declared_rows(self.preamble)
            self.notes += instruments.notes_on_reference(self.preamble)
        except ConditionError as error:
            raise self.error(0, error.message, error.hint) from None
        table = head.table
        header = list(table.titles)
        axes = self.axes(header)
        place, title = self.value_column(header or [""] * table.width, axes, head.begin)
        axis = max((k for k in axes if k < place), default=axes[0])  # of several, the one before
        if axis:
            self.notes.append(f"the wavelengths are in column {axis + 1} {quote(header[axis])}")
        return _Layout(table, axis, place, title, head.begin)

    def take_plain(self, lines: list[str], number: int, layout: _Layout) -> bool:
        """Read rows of plain numbers; return whether they are."""
        marks = layout.table.decimals
        if marks.comma or marks.doubtful:
            return False
        try:
            cells = layout.table.at_once(lines)
            grid, values = (columns.finite_numbers(cells[k]) for k in (layout.axis, layout.place))
        except ValueError:
            return False
        if not marks.point:
            pointed = (n for n, line in enumerate(lines, number) if "." in line)
            marks.point = next(pointed, 0)
        if layout.table.delimiter != "," and not marks.is_sure:
            marks.watch(map(str.strip, cells[layout.place]), number)
        self.grid.extend(grid)
        self.values.extend(values)
        self.lines.extend(range(number, number + len(lines)))
        return True

    def take(self, rows: Iterator[tuple[int, str]], layout: _Layout) -> None:
        for number, line in rows:
            if self.is_marked and line.startswith(TABLE_MARK):
                self.is_over = True
                return
            try:
                cells = layout.table.cells(number, line)
                self.grid.append(layout.table.number(cells[layout.axis], number, is_value=False))
                self.values.append(layout.table.number(cells[layout.place], number))
            except ConditionError:
                self.refuse_second(number, line, next(rows, (0, ""))[1], layout.table)
                raise
            self.lines.append(number)

    def refuse_second(self, number: int, line: str, below: str, table: TextTable) -> None:
        """Raise for a line of text between rows of numbers, which begins a second table."""
        is_text = not _has_number(line, table.delimiter) and _has_number(below, table.delimiter)
        if is_text and self.values:
            count = len(self.values)
            problem = f"'{quote(line.strip())}' begins a second table, after {count} rows"
            raise self.error(number, problem, f"{ONE_TABLE}, or # before a comment")

    def refuse_several(self) -> None:
        """Raise for tables without titles, one below the other, that overlap."""
        grid, lines = self.grid, self.lines
        falls = grid[1] < grid[0]
        starts = [0]
        for k in range(1, len(grid)):
            if (grid[k] > grid[k - 1]) == falls and lines[k] - lines[k - 1] > 1:
                starts.append(k)
        parts = [grid[a:b] for a, b in pairwise([*starts, len(grid)])]
        overlap = any(max(a) >= min(b) and max(b) >= min(a) for a, b in pairwise(parts))
        if overlap and min(map(len, parts)) > 1:
            where = listed([str(lines[start]) for start in starts])
            raise self.error(0, f"{len(starts)} tables begin in the lines {where}", ONE_TABLE)

    def axes(self, header: list[str]) -> list[int]:
        """Return the columns of wavelengths: the first, or those with their title."""
        if (longest := max(map(len, header), default=0)) > column_titles.LONGEST:
            problem = f"a title of {longest} characters"
            raise self.error(0, problem, f"up to {column_titles.LONGEST}")
        plain = [columns.plain(title) for title in header]
        places = [k for k, title in enumerate(plain) if column_titles.is_of_wavelengths(title)]
        if len(places) > 1 and places[0] > 0:
            titles = listed([header[k] for k in places])
            raise self.error(0, f"there are {len(places)} columns of wavelengths", titles)
        return places or [0]

    def finish_columns(self, layout: _Layout) -> Table:
        low, high = min(self.grid), max(self.grid)
        nanometres = self.wavelength_unit(layout.header, low, high)
        try:
            meaning = self.meaning(layout.title)
        except ConditionError as error:
            raise self.error(0, error.message, error.hint) from None
        return self.finish(nanometres, (meaning,))

    def meaning(self, title: str) -> column_titles.Meaning:
        """Return the meaning of the values: from the user, the title or the lines before."""
        lines = [*self.preamble, *self.comments]
        meant = column_titles.values(title)
        if not meant.absolute:
            meant = column_titles.of_remark(lines) or meant
        if self.typed and meant.absolute and meant[1:] != self.typed[1:]:
            self.notes.append(f"the unit given differs from that of the title '{quote(title)}'")
        if self.typed or meant.absolute:
            return self.typed or meant
        meant = column_titles.in_preamble(lines, meant) or meant
        column_titles.refuse_counts(lines, meant, title)
        return meant

    def finish(
        self,
        nanometres: float,
        meanings: Sequence[column_titles.Meaning],
        figures: Mapping[str, Figure] = NO_FIGURES,
    ) -> Table:
        """Return the table of the numbers, with notes; a meter's figures decide its meaning."""
        if len(self.grid) < 2:
            count = len(self.grid)
            raise self.error(0, f"{count} row of data is not a spectrum", "two rows or more")
        grid, values = self.sorted()
        if grid[0] <= 0:
            raise self.error(0, f"a wavelength of {grid[0]:g}", "wavelengths above 0")
        if min(values) < 0:
            self.notes.append(self.noise(grid, values, nanometres))
        if not any(values):
            raise self.error(0, "every value is 0", "a spectrum with light in it")
        for place in (grid[0] * nanometres, grid[-1] * nanometres):
            if not SHORTEST <= place <= LONGEST:
                hint = f"wavelengths from {SHORTEST:g} to {LONGEST:g} nm"
                raise self.error(0, f"a wavelength of {place:g} nm", hint)
        if not WEAKEST <= max(values) <= STRONGEST:
            problem = f"a greatest value of {max(values):g}"
            raise self.error(0, problem, f"from {WEAKEST:g} to {STRONGEST:g}")
        if len(grid) <= MANY:
            self.notes += _gaps(grid)
        tables = [_table(self.name, grid, values, nanometres, meaning) for meaning in meanings]
        table, notes = contents.chosen(tables, figures)
        if self.text.note:
            notes = (self.text.note, *notes)
        table.notes = (*self.notes, *table.notes, *notes)
        return table

    def noise(self, grid: Sequence[float], values: Sequence[float], nanometres: float) -> str:
        """Return the note on negative values; raise if they are too large for noise.

        Outside the visible range, where a meter is insensitive, its noise may equal the light.
        """
        low, high = VISIBLE
        visible = [y for x, y in zip(grid, values, strict=True) if low <= x * nanometres <= high]
        below, above = (
            sum(abs(p + q) * (b - a) for (a, p), (b, q) in pairs if side * (p + q) > 0)
            for side in (-1, 1)
            for pairs in [pairwise(zip(grid, values, strict=True))]
        )
        hint = "the file without the rows that are noise"
        if (deepest := min(visible, default=0.0)) < -NOISE * max(values):
            raise self.error(0, f"a value of {deepest:g}: too far below 0 for noise", hint)
        share = below / above if above else 1.0
        if share > NOISE:
            problem = f"values below 0 are {100 * share:.3g} % of those above: too many for noise"
            raise self.error(0, problem, hint)
        count = sum(value < 0 for value in values)
        note = f"{count} negative values (down to {min(values):g}) are kept as noise"
        return note + (f": {100 * share:.2g} % of the watts" if share >= SMALL else "")

    def value_column(self, names: list[str], axes: list[int], number: int) -> tuple[int, str]:
        """Return the column of the values: the chosen one, or the only one of light."""
        others = [k for k in range(len(names)) if k not in axes]
        if not others:
            hint = "a wavelength and a value in every row"
            raise self.error(number, "there is only one column", hint)
        if self.column:
            place = self.named(["" if k in axes else name for k, name in enumerate(names)])
            if place in axes:
                problem = f"column {place + 1} has the wavelengths"
                raise self.error(0, problem, _named(names, others))
            self.notes.append(f"values from column {place + 1} {quote(names[place])}".strip())
            return place, names[place]
        if of_jaz := instruments.processed_column(names, self.preamble):
            return len(names) - 1, of_jaz
        candidates = [
            k
            for k in others  # an index has no title, or is a number of the row
            if columns.plain(names[k]) not in INDICES and (names[k] or k > axes[0])
        ]
        if len(candidates) > 1:
            candidates = column_titles.of_light(names, candidates)
        if len(candidates) != 1:
            count, chosen = len(candidates), f"{self.name}:COLUMN (or {option('column')})"
            problem = f"there {'are' if count else 'is'} {count or 'no'} column{'s' * (count != 0)}"
            hint = f"{chosen} with one of: {_named(names, candidates or others)}"
            raise self.error(number, f"{problem} of values", hint)
        if len(others) > 1:
            place = candidates[0]
            self.notes.append(f"values from column {place + 1} {quote(names[place])}".strip())
        return candidates[0], names[candidates[0]]

    def named(self, names: list[str]) -> int:
        """Return the chosen column; text in brackets may be an unknown unit."""
        try:
            return find(names, self.column, self.name)
        except UsageError:
            bare = [columns.IN_BRACKETS.sub("", name).strip() for name in names]
            if [name.casefold() for name in bare].count(self.column.strip().casefold()) != 1:
                raise
            return find(bare, self.column, self.name)

    def wavelength_unit(self, header: list[str], low: float, high: float) -> float:
        """Return the nanometres per unit of the first column, declared or from the numbers."""
        if low <= 0:
            raise self.error(0, f"a wavelength of {low:g}", "wavelengths above 0")
        remarks = [*self.comments, *self.preamble]
        try:
            factor, note = column_titles.wavelengths(header, remarks, low, high, self.axis)
        except ConditionError as error:
            raise self.error(0, error.message, error.hint) from None
        if not factor:
            ways = [correct(self.path, f"{unit}:{self.path}") for unit in AXES if self.path]
            raise self.error(0, note, ways or "wavelengths in nm, by a title or as a quantity")
        self.notes.append(note)
        return factor

    def sorted(self) -> tuple[Sequence[float], Sequence[float]]:
        """Return rising wavelengths: falling rows are reversed, others sorted, with a note."""
        grid, values, lines = self.grid, self.values, self.lines
        if all(map(lt, grid, grid[1:])):
            return grid, values
        if all(map(lt, grid[1:], grid)):
            self.notes.append("the wavelengths fall; the rows are taken in reverse")
            return grid[::-1], values[::-1]
        self.refuse_several()
        order = sorted(range(len(grid)), key=grid.__getitem__)
        for before, after in pairwise(order):
            if grid[before] == grid[after]:
                first, second = sorted((lines[before], lines[after]))
                problem = f"the wavelength {grid[after]:g} nm is also in line {first}"
                raise self.error(second, problem, "each wavelength once")
        self.notes.append("the wavelengths are not in order; the rows are sorted")
        return array("d", [grid[i] for i in order]), array("d", [values[i] for i in order])


class _CurveReader(_Reader):
    """The reader of a file whose values are no light."""

    def curve(self) -> Curve:
        blocks = self.text.blocks()
        layout = self.read_rows(blocks)
        nanometres = self.wavelength_unit(layout.header, min(self.grid), max(self.grid))
        if len(self.grid) < 2:
            raise self.error(0, "1 row of data is not a curve", "two rows or more")
        grid, values = self.sorted()
        for value, line in zip(self.values, self.lines, strict=True):
            if value < 0:
                raise self.error(line, f"a value of {value:g} is below 0", "values of 0 or more")
        if not any(values):
            raise self.error(0, "every value is 0", "values above 0")
        points = [x * nanometres for x in grid]
        return Curve(self.name, points, list(values), layout.title, tuple(self.notes))


def _has_number(line: str, delimiter: str | None) -> bool:
    return any(columns.is_number(cell, True) for cell in columns.cells(line, delimiter))


def _gaps(grid: Sequence[float]) -> list[str]:
    """Return a note if nearly all steps are the same and some are at least twice as long."""
    steps = sorted(b - a for a, b in pairwise(grid))
    usual = steps[len(steps) // 2]
    others = [step for step in steps if abs(step - usual) > SAME * usual]
    longest = steps[-1]
    if not others or len(others) > FEW * len(steps) or longest < (2 - SAME) * usual:
        return []
    place = next(a for a, b in pairwise(grid) if b - a == longest)
    return [f"a step of {longest:g} at {place:g}, while most are {usual:g}: a row may be missing"]


def _table(
    name: str,
    grid: Sequence[float],
    values: Sequence[float],
    nanometres: float,
    meant: column_titles.Meaning,
) -> Table:
    """Return a spectrum in metres and watts: of photons, divided by their wavelengths."""
    points = grid
    if meant.are_photons:
        grid, values = _finer(grid, values)
    xs: Any = [x * nanometres for x in grid]
    ys: Any = [y * meant.factor for y in values]
    if meant.are_photons:
        ys = [y * ENERGY / x for x, y in zip(xs, ys, strict=True)]
    kind: type[Table] = Table
    if len(grid) > MANY:
        import numpy

        from radcalc.spectra.arrays import ArrayTable

        xs, ys, kind = numpy.array(xs), numpy.array(ys), ArrayTable
    table = kind(name, xs, ys, absolute=meant.absolute)
    table.reading = meant.said
    if meant.are_photons:
        table.measured = [x * nanometres for x in points]
    return table


def _finer(grid: Sequence[float], values: Sequence[float]) -> tuple[list[float], list[float]]:
    """Return photons with more points on the lines between those of a coarse table.

    Photons that lie on a line are watts on a curve, as each photon has h c/lambda.
    """
    xs, ys = [grid[0]], [values[0]]
    for (a, low), (b, high) in pairwise(zip(grid, values, strict=True)):
        step = (b - a) / a
        count = min(math.ceil(step / FINE), BETWEEN) if step > DENSE else 1
        shares = [k / count for k in range(1, count + 1)]
        xs += [(1 - share) * a + share * b for share in shares]
        ys += [(1 - share) * low + share * high for share in shares]
    return xs, ys


def _named(titles: Sequence[str], places: Sequence[int]) -> str:
    """Return columns by their titles, or else by their numbers."""
    return listed([titles[k] or str(k + 1) for k in places])
