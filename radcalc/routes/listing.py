"""The columns of a table or a log: their units, their extremes and means."""

import sys
from collections.abc import Callable, Sequence
from math import fsum, inf
from typing import NamedTuple

from radcalc.distributions import contents
from radcalc.errors import LineError, RadcalcError
from radcalc.files import columns
from radcalc.files.text import Text
from radcalc.quantities.column_titles import read_title
from radcalc.streams.log_layout import MISSING, FirstRows, is_remark
from radcalc.streams.samples import LEAST, MARKED
from radcalc.units.unit import Unit

LARGEST = 1 << 26  # bytes of a file that are summed
BLOCK = 4096  # lines


class ColumnSummary:
    """What a column has: numbers with their sum and extremes, or the first and last text."""

    def __init__(self, place: int, title: str, unit: Unit | None, is_time: bool) -> None:
        self.place, self.title, self.unit, self.is_time = place, title, unit, is_time
        self.count = 0
        self.first, self.last = "", ""
        self.least, self.greatest = inf, -inf
        self.sums: list[float] = []

    @property
    def name(self) -> str:
        """The title, or the number of a column without one."""
        return self.title or str(self.place + 1)

    @property
    def mean(self) -> float | None:
        return fsum(self.sums) / self.count if self.count and not self.is_time else None

    def see(self, first: str, last: str) -> None:
        """Take texts of the first and the last of several rows."""
        self.first, self.last = self.first or first, last

    def add(self, numbers: Sequence[float]) -> None:
        self.count += len(numbers)
        self.sums = [fsum((*self.sums, *numbers))]
        self.least = min(self.least, *numbers)
        self.greatest = max(self.greatest, *numbers)


class Listing(NamedTuple):
    """The columns of a table, the number of its rows, and notes."""

    columns: list[ColumnSummary]
    rows: int
    notes: tuple[str, ...] = ()


def unit_of(rows: FirstRows, place: int) -> Unit | None:
    """Return the unit in the titles of a column, or None."""
    for titles in rows.table.titles:
        try:
            unit = read_title(titles[place]).unit
        except RadcalcError:
            continue
        if unit:
            return unit
    return None


def listing(path: str, rows: FirstRows) -> Listing:
    """Return the columns of a table whose first rows are known, up to 64 MiB of it.

    Raises
    ------
    ConditionError, LineError
        If the file cannot be read, or its numbers have points and commas.
    """
    times = {*rows.times, *rows.parts}
    titles = rows.names or [""] * rows.table.width
    reader = _Reader(
        rows,
        [
            ColumnSummary(place, title, unit_of(rows, place), place in times)
            for place, title in enumerate(titles)
        ],
    )
    with contents.opened(path, sys.maxsize, "a table") as file:
        text = Text(rows.name, _bounded(file.read), "a value", inf)
        for number, lines in text.blocks():
            start = max(rows.begin - number, 0)
            for k in range(start, len(lines), BLOCK):
                reader.add(lines[k : k + BLOCK], number + k)
        is_cut = bool(file.read(1))
    rows.table.finish()
    notes = [text.note] if text.note else []
    if reader.skipped:
        plural = (
            "line with other columns is" if reader.skipped == 1 else "lines with other columns are"
        )
        notes.append(f"{reader.skipped} {plural} skipped")
    if is_cut:
        notes.append(f"only the first {LARGEST >> 20} MiB of the file are read")
    return Listing(reader.columns, reader.count, tuple(notes))


class _Reader:
    """The reader of the rows of a table, in blocks of lines or one by one."""

    def __init__(self, rows: FirstRows, found: list[ColumnSummary]) -> None:
        self.table, self.columns = rows.table, found
        self.count = self.skipped = 0

    def add(self, lines: list[str], number: int) -> None:
        try:
            self._add_at_once(lines, number)
        except ValueError:
            for line in enumerate(lines, number):
                if not is_remark(line[1]):
                    self._add_line(*line)

    def _add_at_once(self, lines: list[str], number: int) -> None:
        """Add many lines; raise ValueError if any is unusual, before anything is added."""
        cells = self.table.at_once(lines)
        numbers = {}
        for column, texts in zip(self.columns, cells, strict=True):
            if column.is_time or (column.first and not column.count):
                continue
            values = columns.finite_numbers(self.table.pointed(texts, number))
            if min(values) <= LEAST:
                raise ValueError
            numbers[column.place] = values
        for column, texts in zip(self.columns, cells, strict=True):
            if column.place in numbers:
                column.add(numbers[column.place])
            else:
                column.see(texts[0].strip(' "'), texts[-1].strip(' "'))
        self.count += len(lines)

    def _add_line(self, number: int, line: str) -> None:
        try:
            cells = self.table.cells(number, line)
        except LineError:
            self.skipped += 1
            return
        self.count += 1
        for column, cell in zip(self.columns, cells, strict=True):
            value = None if column.is_time else columns.finite(cell, True)
            if cell.lower() in MISSING or (value and value <= LEAST and MARKED.fullmatch(cell)):
                continue
            if value is None:
                column.see(cell, cell)
            else:
                self.table.check_marks([cell], number)
                column.add([value])


def _bounded(read: Callable[[int], bytes | None]) -> Callable[[int], bytes]:
    """Return a function that reads up to the limit."""
    left = LARGEST

    def bounded(size: int) -> bytes:
        nonlocal left
        data = read(min(size, left)) or b""
        left -= len(data)
        return data

    return bounded
