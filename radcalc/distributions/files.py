"""Reading of photometric files; the contents determine the format.

An IES file has a line with its edition or with TILT=, an EULUMDAT file only numbers in its lines 2
to 7, a table has rows of numbers.  If the contents match none of them, the extension selects the
reader, which then reports the error.
"""

import os
from collections.abc import Sequence
from importlib import import_module
from itertools import islice
from typing import Any

from radcalc.distributions import contents
from radcalc.distributions.distribution import Photometry
from radcalc.errors import ConditionError, quote
from radcalc.files import columns, signatures

MOST_BYTES = 1 << 26  # of a file
ROWS = 3  # rows that identify a table
END_IN_DOS = "\x1a"  # end of a text
NO_TEXT = bytes({*range(32), 127} - set(b"\t\n\v\f\r\x1a"))  # bytes
UTF16 = (b"\xff\xfe", b"\xfe\xff")
READERS = {".ies": "ies", ".ldt": "eulumdat", ".csv": "tables"}  # modules, by extension
KNOWN = "an IES (LM-63) or EULUMDAT file, or a table with a column of angles"


def read_file(path: str) -> Photometry:
    """Read a photometric file or a table, of 64 MiB at most, or standard input (-).

    Raises
    ------
    ConditionError
        If it cannot be read, is not text, or has none of the three formats; also the errors of
        the format's reader, with the line.
    """
    name, lines = read_lines(path, KNOWN)
    reader = _by_content(lines) or READERS.get(os.path.splitext(path)[1].lower())
    if not reader:
        raise ConditionError(f"{name} is {_likeness(lines)}", KNOWN)
    # load only the module that is needed
    photometry: Photometry = import_module(f"radcalc.distributions.{reader}").read(lines, name)
    grid: Any = photometry.distribution
    return photometry._replace(
        notes=(*photometry.notes, *photometry.contradictions(), *grid.contradictions())
    )


def read_lines(path: str, expected: str) -> tuple[str, list[str]]:
    """Return the name of a text in messages, and its lines without line ends, in any encoding.

    At least one line is not blank.  Raise a ConditionError if it cannot be read, or is not text.
    """
    name, data = contents.read_bytes(path, MOST_BYTES, expected)
    return name, _lines(data, name, expected)


def _lines(data: bytes, name: str, expected: str) -> list[str]:
    """Return the lines of a text in UTF-8, or else in Latin-1, with any line ends."""
    if data.startswith(UTF16):
        raise ConditionError(f"{name} is text in UTF-16", "the same in UTF-8 (iconv converts it)")
    if len(data.translate(None, NO_TEXT)) < len(data):
        place = next(k for k, byte in enumerate(data) if byte in NO_TEXT)
        raise ConditionError(f"{name} is not text: byte {place} is {data[place]}", expected)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    stripped = text.rstrip()
    if stripped.endswith(END_IN_DOS):
        text = stripped.rstrip(END_IN_DOS)
    text = text.rstrip("\r\n")  # not tabs: the last line may end with blank cells
    if not text.strip():
        raise ConditionError(f"{name} is empty", expected)
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def _by_content(lines: Sequence[str]) -> str:
    """Return the module that can read the lines, or ""."""
    return signatures.of_luminaire(lines) or ("tables" if _has_rows(lines) else "")


def _has_rows(lines: Sequence[str]) -> bool:
    """Return whether rows of columns begin with a number, after up to two rows of titles."""
    texts = (line.strip() for line in lines)
    rows = list(islice((text for text in texts if _is_data(text)), ROWS))
    rows = rows[2:] or rows[1:] or rows  # after titles and units
    split = [(columns.cells(row, columns.dialect(row)[0]), columns.dialect(row)[1]) for row in rows]
    return bool(rows) and all(
        len(cells) > 1 and columns.is_number(cells[0], comma) for cells, comma in split
    )


def _is_data(text: str) -> bool:
    return bool(text) and not columns.is_comment(text)


def _likeness(lines: Sequence[str]) -> str:
    """Describe a text that has none of the formats."""
    first = next(line.strip() for line in lines if line.strip())
    if first.startswith(("<", "{")):
        return "XML or HTML" if first[0] == "<" else "JSON"
    return f"not a photometric file: it begins with '{quote(first)}'"
