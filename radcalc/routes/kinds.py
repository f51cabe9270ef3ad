"""The kind of a file, by its contents, and the command for each kind.

A file is recognised by the signature of a format, or by the titles and the first rows of a table.
If nothing is recognised, the ending of its name selects the reader, which then reports the error.
"""

import os
import re
import sys
from collections.abc import Sequence
from contextlib import suppress
from typing import NamedTuple

from radcalc.distributions import contents
from radcalc.errors import ConditionError, RadcalcError, quote_path
from radcalc.files import columns, signatures
from radcalc.files.text import ENDINGS as OF_COLUMNS
from radcalc.files.text import Text
from radcalc.quantities.light import read as read_light
from radcalc.routes.listing import unit_of
from radcalc.spectra.files import is_spectrum
from radcalc.streams.log_layout import FirstRows, Head, LogSettings, first_lines, is_remark

LUMINAIRE, MAP, SPECTRUM, LOG, SCENE, TABLE = (
    "luminaire",
    "map",
    "spectrum",
    "log",
    "scene",
    "table",
)
HEAD = 1 << 20  # bytes that are examined
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


class LooseRows(FirstRows):
    """The first rows of a table with text in some of its columns."""

    def is_data(self, line: str, named: int | None) -> bool:
        cells = columns.cells(line, self.delimiter(line))
        return any(columns.is_number(cell, True) for cell in cells)


class Contents(NamedTuple):
    """The kind of a file, and the first rows of its table if it is one."""

    kind: str
    rows: FirstRows | None = None


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
    if not signatures.foreign(head):
        with suppress(ConditionError):  # not text
            found = _of_text(_lines(head, is_whole, name), name)
    if found and not (by_ending and found.kind == TABLE):
        return found
    if by_ending:
        return Contents(by_ending)
    signatures.refuse_foreign(head, name, KNOWN)
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
        titles = columns.cells(line, columns.dialect(line)[0])
        if any(map(X.match, titles)):
            from radcalc.calculators.scene_rows import is_scene  # which needs NumPy

            if is_scene(titles):
                return True
    return False


def _rows(lines: list[str], name: str) -> FirstRows | None:
    """Return the first rows of a table of numbers, with or without columns of text."""
    head = first_lines([(1, lines)])
    for kind in (FirstRows, LooseRows):
        with suppress(RadcalcError):
            rows = kind(name, head, LogSettings())
            return rows if _is_table(rows, head) else None
    return None


def _is_table(rows: FirstRows, head: Sequence[tuple[int, str]]) -> bool:
    """Return whether rows have titles, or nothing but numbers and times, and others are alike."""
    cells = [cell for cell in rows.cells if cell]
    are_numbers = all(columns.is_number(cell, True) or rows.is_stamp(cell) for cell in cells)
    if not are_numbers and not (rows.names and rows.table.delimiter):
        return False
    below = [line for number, line in head if number >= rows.begin and not is_remark(line)]
    widths = [len(columns.cells(line, rows.table.delimiter)) for line in below]
    return 2 * widths.count(rows.table.width) >= len(widths)


def _are_of_angles(titles: Sequence[str]) -> bool:
    """Return whether titles are those of polar angles and of intensities."""
    if len(titles) < 2 or not titles[0]:
        return False
    from radcalc.distributions.column_titles import angles, column

    try:
        return all((angles(titles[0]) or True, *map(column, titles[1:])))
    except ConditionError:
        return False


def _is_log(lines: list[str], name: str, rows: FirstRows | None) -> bool:
    """Return whether a table has times and a single column that may be light."""
    if rows is None or isinstance(rows, LooseRows) or not (rows.times or rows.parts):
        return False
    try:
        Head(name, first_lines([(1, lines)]), LogSettings())
    except RadcalcError:
        values = [k for k in range(len(rows.cells)) if k not in (*rows.times, *rows.parts)]
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
