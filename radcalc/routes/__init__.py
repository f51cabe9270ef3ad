"""Kinds of files: the command that each means, and the columns of tables."""

import os
import re
import sys
from collections.abc import Sequence
from contextlib import suppress
from math import fsum, inf
from typing import NamedTuple

from radcalc.distributions import contents
from radcalc.errors import ConditionError, LineError, RadcalcError, quote, quote_path
from radcalc.files import ENDINGS as OF_COLUMNS
from radcalc.files import Text, columns, signatures
from radcalc.files.columns import first_lines, is_number
from radcalc.quantities import read as read_light
from radcalc.quantities.column_titles import read_title, refuse_uncalibrated
from radcalc.spectra.files import is_spectrum
from radcalc.streams.log_layout import MISSING, FirstRows, LogHead, LogSettings, blocks_of
from radcalc.streams.samples import MARKED
from radcalc.units import Unit

LUMINAIRE, MAP, SPECTRUM, LOG, SCENE, TABLE = (
    "luminaire",
    "map",
    "spectrum",
    "log",
    "scene",
    "table",
)
HEAD = 1 << 20  # bytes that are examined
LEAST = -999.0  # marks of missing values, as in MARKED, are not greater
KNOWN = (
    "a luminaire (IES, EULUMDAT), a map (.hdr, .exr, .pfm), a spectrum, a log or another table "
    "of numbers"
)
ENDINGS = {
    **dict.fromkeys((".ies", ".ldt"), LUMINAIRE),
    **dict.fromkeys((".hdr", ".pic", ".exr", ".pfm"), MAP),
    ".spdx": SPECTRUM,
}
ALL_ENDINGS = (*OF_COLUMNS, *ENDINGS)
# The command for each kind, and its symbol for the file if that is not its operand.
COMMANDS = {
    LUMINAIRE: ("point-source", "distribution"),
    MAP: ("environment", ""),
    SPECTRUM: ("spectrum", ""),
    LOG: ("dose", ""),
    SCENE: ("scene", ""),
    TABLE: ("columns", ""),
}
NAMES = {
    LUMINAIRE: "a luminaire file",
    MAP: "a map of radiances",
    SPECTRUM: "a spectrum",
    LOG: "a log with times",
    SCENE: "a scene",
    TABLE: "a table",
}
OF_TEXT = set(b"\t\n\v\f\r\x1a")  # control characters
MOST_BEFORE = 100  # lines before the titles of a scene
X = re.compile(r"\s*x(?![^\W_])", re.IGNORECASE)


class Contents(NamedTuple):
    """The kind of a file, and the first rows of its table if it is one.

    The table of a public format of the sun is made of the file, not the file itself.
    """

    kind: str
    rows: FirstRows | None = None
    is_made: bool = False


def kind_of(path: str) -> str:
    """Return the kind of a regular file: luminaire, map, spectrum, log, scene or table.

    Raises
    ------
    ConditionError
        If the file cannot be read, or is not of a known kind.
    """
    return contents_of(path).kind


def contents_of(path: str) -> Contents:
    """Return the kind of a regular file, by its first bytes, and the first rows of a table."""
    with contents.opened(path, sys.maxsize, KNOWN) as file:
        head = file.read(HEAD)
        is_whole = len(head) < HEAD
    name = quote_path(path)
    if signatures.of_picture(head):
        return Contents(MAP)
    by_ending = ENDINGS.get(os.path.splitext(path)[1].lower(), "")
    found: Contents | None = None
    lines: list[str] = []
    if not signatures.foreign(head):
        with suppress(ConditionError):  # not text
            lines = _lines(head, is_whole, name)
        if is_made := bool(signatures.of_sun(lines)):
            with contents.opened(path, sys.maxsize, KNOWN) as file:
                blocks, _ = blocks_of(Text(name, file.read, "a time and a value", inf))
                lines = [line for _, block in blocks for line in block]
        with suppress(ConditionError):
            found = _of_text(lines, name)
            found = found and found._replace(is_made=is_made)
    if found and not (by_ending and found.kind == TABLE):
        return found
    if by_ending:
        return Contents(by_ending)
    signatures.refuse_foreign(head, name, KNOWN)
    try:
        FirstRows(name, first_lines([(1, lines)]), LogSettings())
    except LineError as error:
        if error.message.startswith(f"{name}, "):  # with the line that is no row or title
            raise
    raise ConditionError(f"{name} is not a file of light that radcalc knows", KNOWN)


def _lines(head: bytes, is_whole: bool, name: str) -> list[str]:
    """Return the whole lines of the first bytes of a text; raise a ConditionError for others."""
    blocks = [head]
    text = Text(name, lambda _: blocks.pop() if blocks else b"", "a line")
    lines = [line for _, block in text.blocks() for line in block]
    controls = {ord(c) for line in lines for c in line if c < " " or c == "\x7f"}
    if controls - OF_TEXT:
        raise ConditionError(f"{name} is not text", KNOWN)
    return lines if is_whole else lines[:-1]


def _of_text(lines: list[str], name: str) -> Contents | None:
    if signatures.of_luminaire(lines):
        return Contents(LUMINAIRE)
    rows = _rows(lines, name)
    titles = rows.names if rows else []
    if rows and _are_of_angles(titles):
        return Contents(LUMINAIRE, rows)
    if _is_scene(lines):
        return Contents(SCENE, rows)
    is_log = _is_log(lines, name, rows)
    if is_spectrum(lines):
        return Contents(TABLE, rows) if is_log and rows else Contents(SPECTRUM, rows)
    if is_log:
        return Contents(LOG, rows)
    return Contents(TABLE, rows) if rows else None


def _is_scene(lines: Sequence[str]) -> bool:
    """Return whether one of the first lines has the titles of a scene, whose cells may be texts."""
    for line in lines[:MOST_BEFORE]:
        titles = columns.cells_alone(line)
        if any(map(X.match, titles)):
            from radcalc.calculators.scene_rows import is_scene  # which needs NumPy

            if is_scene(titles):
                return True
    return False


def _rows(lines: list[str], name: str) -> FirstRows | None:
    """Return the first rows of a table of numbers, with or without columns of text."""
    with suppress(RadcalcError):
        rows = FirstRows(name, first_lines([(1, lines)]), LogSettings())
        return rows if _is_table(rows) else None
    return None


def _is_table(rows: FirstRows) -> bool:
    """Return whether rows have titles, or nothing but numbers and times, and others are alike."""
    cells = [cell for cell in rows.cells if cell]
    are_numbers = all(columns.is_number(cell, True) or rows.is_start(cell) for cell in cells)
    if not are_numbers and not (rows.table.delimiter and len(cells) > 1):
        return False
    below, alike = rows.below, 0
    for number, line in below:
        with suppress(LineError):
            alike += bool(rows.table.cells(number, line))
    are_rows = are_numbers or bool(rows.names) or len(below) > 1
    return are_rows and 2 * alike >= len(below)


def _are_of_angles(titles: Sequence[str]) -> bool:
    """Return whether titles are those of polar angles and of intensities."""
    if len(titles) < 2 or not titles[0]:
        return False
    from radcalc.distributions.contents import angles, column

    try:
        return all((angles(titles[0]) or True, *map(column, titles[1:])))
    except ConditionError:
        return False


def _is_log(lines: list[str], name: str, rows: FirstRows | None) -> bool:
    """Return whether a table has times and a single column that may be light."""
    if rows is None or rows.has_texts or not (rows.times or rows.parts[0]):
        return False
    try:
        LogHead(name, first_lines([(1, lines)]), LogSettings())
    except RadcalcError:
        values = [k for k in range(len(rows.cells)) if k not in (*rows.times, *rows.parts[0])]
        units = [unit for k in values if (unit := unit_of(rows, k))]
        numbers = [k for k in values if columns.is_number(rows.cells[k], True)]
        of_light = [unit for unit in units if read_light(unit)]
        return len(of_light) == 1 or (not units and len(numbers) == 1)
    return True


def call_of_file(kind: str, path: str) -> tuple[str, ...]:
    """Return the command for a file of a kind, and the file as its operand or NAME=VALUE.

    The values of a map without a unit are relative.
    """
    command, symbol = COMMANDS[kind]
    if "=" in path and "/" not in path.partition("=")[0]:  # which is not NAME=VALUE
        path = f"./{path}"
    unit: tuple[str, ...] = ()
    with suppress(RadcalcError):  # of a damaged map, which its command reports
        unit = ("unit=1",) * (kind == MAP and is_relative(path))
    return command, f"{symbol}={path}" if symbol else path, *unit


def is_relative(path: str) -> bool:
    """Return whether a map of radiances has no unit, so that its values are relative."""
    from radcalc.distributions.maps.pictures import read_picture

    return not read_picture(path).unit


LARGEST = 1 << 26  # bytes of a file that are summed
BLOCK = 4096  # lines


class ColumnSummary:
    """What a column has: numbers with their sum and extremes, or the first and last text."""

    def __init__(self, place: int, title: str, unit: Unit | None, is_time: bool) -> None:
        self.place, self.title, self.unit, self.is_time = place, title, unit, is_time
        self.count = 0
        self.odd = ""  # a remark on a text among the numbers
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


def unit_of(rows: FirstRows, place: int) -> Unit | None:
    """Return the unit in the title of a column, or None."""
    with suppress(RadcalcError):
        title = read_title(rows.table.titles[place] if rows.table.titles else "")
        refuse_uncalibrated(title)
        return title.unit
    return None


class Listing:
    """The columns of a table, the number of its rows, and notes, up to 64 MiB of a file.

    Rows are read in blocks of lines or one by one.
    """

    def __init__(self, path: str, head: FirstRows) -> None:
        """Read a file whose first rows are known.

        Raises
        ------
        ConditionError, LineError
            If the file cannot be read, or its numbers have points and commas.
        """
        times = {*head.times, *head.parts[0]}
        titles = head.names or [""] * head.table.width
        self.table = head.table
        self.columns = [
            ColumnSummary(place, title, unit_of(head, place), place in times)
            for place, title in enumerate(titles)
        ]
        self.rows = self.skipped = 0
        self.first_skipped = ""
        # The place of a cell that shows that a row is one of data: its date, or its first number.
        self.place = next(iter(head.times), 0)
        kinds = (head.is_start, is_number)
        self.is_row = next((is_of for is_of in kinds if is_of(head.cells[self.place])), bool)
        with contents.opened(path, sys.maxsize, "a table") as file:
            text = Text(head.name, lambda size: file.read(size) or b"", "a value", inf)
            for number, lines in blocks_of(text)[0]:
                start = max(head.begin - number, 0)
                for k in range(start, len(lines), BLOCK):
                    self._add(lines[k : k + BLOCK], number + k)
                if file.tell() >= LARGEST:
                    break
            is_cut = bool(file.read(1))
        self.table.finish()
        self.notes = [text.note] if text.note else []
        if self.skipped:
            lines_text = "a line is" if self.skipped == 1 else f"{self.skipped} lines are"
            self.notes.append(f"{lines_text} no row of data; the first: {self.first_skipped}")
        self.notes += [column.odd for column in self.columns if column.count and column.odd]
        if is_cut:
            self.notes.append(f"only the first {LARGEST >> 20} MiB of the file are read")

    def _add(self, lines: list[str], number: int) -> None:
        try:
            self._add_at_once(lines, number)
        except ValueError:
            for line in enumerate(lines, number):
                if not columns.is_remark(line[1]):
                    self._add_line(*line)

    def _add_at_once(self, lines: list[str], number: int) -> None:
        """Add many lines; raise ValueError if any is unusual, before anything is added."""
        cells = self.table.at_once(lines)
        if not all(map(self.is_row, map(str.strip, cells[self.place]))):
            raise ValueError
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
        self.rows += len(lines)

    def _add_line(self, number: int, line: str) -> None:
        """Add the cells of a row to their columns; count a row that cannot be read."""
        try:
            cells = self.table.cells(number, line)
        except LineError:
            cells = []
        if not cells or not self.is_row(cells[self.place]):
            self.skipped += 1
            self.first_skipped = self.first_skipped or f"line {number}: '{quote(line.strip())}'"
            return
        self.rows += 1
        for column, cell in zip(self.columns, cells, strict=True):
            value = None if column.is_time else columns.finite(cell, True)
            if cell.lower() in MISSING or (value and value <= LEAST and MARKED.fullmatch(cell)):
                continue
            if value is None:
                column.see(cell, cell)
                if not column.is_time and not column.odd:
                    column.odd = f"'{quote(cell)}' in line {number} is no number of '{column.name}'"
            else:
                self.table.check_marks([cell], number)
                column.add([value])
