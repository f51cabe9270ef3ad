"""Contents of luminaire files: what their bytes are, and the titles of tables of intensities."""

import errno
import os
import re
import secrets
import stat
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import lru_cache
from io import FileIO
from typing import NamedTuple

from radcalc import terminal
from radcalc.errors import ConditionError, OutputError, UnitError, correct, quote, quote_path
from radcalc.files import is_file_name, readable
from radcalc.files.columns import IN_BRACKETS, plain, units_in
from radcalc.quantities import NONE, describe, read
from radcalc.quantities.column_titles import Title, read_title, refuse_altered
from radcalc.units import NUMBER, Unit
from radcalc.units.dimensions import ANGLE
from radcalc.units.table import resolve, unit_of

BLOCK = 1 << 20  # bytes to read at a time if the size is unknown


def read_bytes(path: str, largest: int, expected: str) -> tuple[str, bytes]:
    """Return the name in messages, and all contents, of a regular file or of standard input (-).

    Raise a ConditionError if it cannot be read, or has more than `largest` bytes.
    """
    if path == "-":
        return "stdin", _whole(terminal.read, BLOCK, largest, "stdin")
    with opened(path, largest, expected, "a file, or - for standard input") as file:
        return quote_path(path), whole(file, largest, path)


@contextmanager
def opened(path: str, largest: int, expected: str, instead: str = "a file") -> Iterator[FileIO]:
    """Open a regular file for reading, without waiting for a pipe or a device.

    It raises the errors of `read_bytes`, also during reading; `instead` is the hint for a pipe.
    """
    with readable(path, expected) as name, FileIO(path, opener=_without_waiting) as file:
        status = os.fstat(file.fileno())
        if not stat.S_ISREG(status.st_mode):
            raise ConditionError(f"cannot read {name}: a pipe or a device", instead)
        if status.st_size > largest:
            raise _too_large(name, largest)
        yield file


def whole(file: FileIO, largest: int, path: str) -> bytes:
    """Return the rest of an open file, without a copy in memory."""
    size = os.fstat(file.fileno()).st_size
    return _whole(file.read, max(BLOCK, size + 1), largest, quote_path(path))


def check_place(path: str, extensions: Collection[str], thing: str, instead: str) -> str:
    """Return the extension of a file, after a check that the file can be written.

    Raises
    ------
    ConditionError
        If the extension is not accepted.
    OutputError
        If the file cannot be written, as far as that is known in advance.
    """
    extension = os.path.splitext(path)[1].lower()
    if extension not in extensions:
        what = f"as {quote(extension)}" if extension else "without an extension"
        better = correct(path, os.path.splitext(path)[0] + instead.partition(" ")[0])
        problem = f"{quote_path(path)}: {thing} cannot be written {what}"
        raise ConditionError(problem, instead, [better])
    if not is_file_name(path):
        raise _cannot_write(path, "not a file name")
    target = os.path.realpath(path)
    folder = os.path.dirname(target)
    if not os.path.isdir(folder):
        raise _cannot_write(path, f"the folder {quote_path(folder)} does not exist")
    if os.path.exists(target) and not os.path.isfile(target):
        raise _cannot_write(path, "a folder, a pipe or a device")
    if not all(os.access(place, os.W_OK) for place in (folder, target) if os.path.exists(place)):
        raise _cannot_write(path, os.strerror(errno.EACCES))
    return extension


@contextmanager
def written(path: str) -> Iterator[str]:
    """Create an empty file that replaces a path once it is written completely.

    On an error, the previous file stays unchanged.  Raise an OutputError if it cannot be written.
    """
    target = os.path.realpath(path)  # the target of a link, not the link
    # in the same folder: a file moved from elsewhere may arrive incomplete
    extension = os.path.splitext(path)[1].lower()
    temporary = os.path.join(os.path.dirname(target), f".radcalc-{secrets.token_hex(8)}{extension}")
    try:
        with open(temporary, "xb"):  # with the permissions of any new file
            pass
        yield temporary
        if os.path.exists(target):
            os.chmod(temporary, stat.S_IMODE(os.stat(target).st_mode))
        os.replace(temporary, target)
    except OSError as error:
        raise _cannot_write(path, error.strerror or str(error)) from None
    finally:
        with suppress(OSError):  # it exists only after an error
            os.remove(temporary)


def _cannot_write(path: str, why: str) -> OutputError:
    return OutputError(f"cannot write {quote_path(path)}: {why}", "another place for it")


def _without_waiting(path: str, flags: int) -> int:
    """Open a file without waiting for a pipe that nobody writes to."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _whole(read: Callable[[int], bytes | None], block: int, largest: int, name: str) -> bytes:
    blocks, size = [], 0
    while block_read := read(block):
        blocks.append(block_read)
        size += len(block_read)
        if size > largest:
            raise _too_large(name, largest)
    return b"".join(blocks)


def _too_large(name: str, largest: int) -> ConditionError:
    return ConditionError(f"{name} has more than {largest >> 20} MiB", "a smaller file")


INTENSITY = (0, 0, 1)  # the powers of time, 1/area and 1/solid angle
SHORT = 6  # words of a comment that may be a title
ANGLE_WORDS = re.compile(r"gamma|theta|polar|angle|vertical|winkel|γ|θ|ϑ")
OF_ANGLE = re.compile(rf"(?<![a-z])a?(?:sin|cos|tan)|\d\s*(?:{ANGLE_WORDS.pattern})")
OTHER_ANGLES = re.compile(r"elevation|altitude|azimut|horizontal|phi|latitude|zenith")
DEGREES = r"([-+]?\d+(?:[.,]\d+)?)\s*(?:°|deg)?"
# A plane, and the opposite one: C0, C 22.5 deg, phi=45, 90, C0-C180, C0/180.
PLANE = re.compile(
    rf"(?P<letter>c|phi|φ|ϕ)?\s*=?\s*{DEGREES}(?:\s*[-–/]\s*c?\s*{DEGREES})?(?![\w.])",
    re.IGNORECASE,
)
OTHER_WORDS = re.compile(
    r"(?:il)?luminance|radiance"
    r"|(?<![a-z])(?:flux|lux|lumens?|exposure|d[b]m?|log|lg|ln|log10|squared|errors?|uncertainty"
    r"|stdev?|cumulative|exitance|wavelengths?|distance)(?![a-z])"
)
RELATIVE = re.compile(r"|%|-|1|rel\.?|relative|norm(?:ali[sz]ed|\.)?|arb.*|a\. ?u\.|au")
PER_FLUX = re.compile(r"cd\s*/\s*\(?\s*(?:k|1000\s*)?lm|cd\s+per\b")
# The unit in a comment: I (cd), unit: cd, intensities in cd, cd.
STATED = re.compile(r"(?:^|\bin |[:=/]|(?=[(\[]))\s*(\S+)$")
KNOWN = "an intensity in cd, mcd, W/sr, mW/sr or the like, or no unit for relative values"


class Column(NamedTuple):
    """C planes [deg] and unit in the title of a column of intensities, if it has them.

    `opposite` is the opposite plane of a title such as C0-C180.
    """

    plane: float | None
    opposite: float | None
    unit: Unit | None


def angles(title: str) -> Unit | None:
    """Return the unit of angle in the title of the first column, or None.

    Raise a ConditionError if the title is not that of polar angles.

    >>> angles("theta [rad]")
    Unit('rad')
    >>> angles("gamma")
    """
    text, unit = plain(title), _read(title.replace("º", "°"), resolve("deg")).unit
    has_other = unit.dimension != ANGLE if unit else bool(units_in(title)[0])
    if has_other or OF_ANGLE.search(text):
        problem = f"'{quote(title)}' in the first column is not an angle"
        raise ConditionError(problem, "polar angles in it")
    if OTHER_ANGLES.search(text) or not (unit or not text or ANGLE_WORDS.search(text)):
        raise ConditionError(
            f"'{quote(title)}' in the first column is not a polar angle from the source's axis",
            "a title such as gamma, theta or angle (deg)",
        )
    return unit


def column(title: str) -> Column:
    """Read the title of a column; raise a ConditionError if it is not that of intensities.

    >>> column("I (cd)")
    Column(plane=None, opposite=None, unit=Unit('cd'))
    """
    plane_match = PLANE.match(title)
    after_plane = title[plane_match.end() :].strip().lstrip("/ ") if plane_match else title
    is_bare = not after_plane or IN_BRACKETS.fullmatch(after_plane)
    if plane_match and not (
        is_bare or (plane_match["letter"] and unit_of(after_plane))
    ):  # not a plane, as in "2 m from the lamp"
        plane_match, after_plane = None, title
    plane, opposite = (
        (_number(plane_match[2]), _number(plane_match[3])) if plane_match else (None, None)
    )
    text = plain(after_plane)
    if PER_FLUX.search(text):
        raise ConditionError(
            f"'{quote(title)}' is relative to the flux of lamps, which the table does not have",
            "the values times that flux, in cd",
        )
    unit = _intensity(after_plane)
    if not unit and OTHER_WORDS.search(text):
        raise ConditionError(f"'{quote(title)}' is not an intensity", KNOWN)
    return Column(plane, opposite, unit)


def _number(text: str | None) -> float | None:
    return float(text.replace(",", ".")) if text else None


def in_comments(comments: Sequence[str]) -> Unit | None:
    """Return the unit of intensity in a short comment such as `# I (cd)`, or None.

    Raise a ConditionError if comments have different units.
    """
    units: dict[tuple[object, float], Unit] = {}
    for comment in comments:
        stated = STATED.search(comment)
        if len(comment.split()) > SHORT:
            continue
        try:
            _read(comment)
            unit = _intensity(stated[1] if stated else "")
        except ConditionError:  # a comment is free text
            continue
        if unit:
            units[unit.dimension, unit.factor] = unit
    if len(units) > 1:
        unit_texts = " and ".join(quote(unit.text) for unit in units.values())
        problem = f"the comments have different units: {unit_texts}"
        raise ConditionError(problem, "the unit in the titles of the columns")
    return next(iter(units.values()), None)


@lru_cache(16)
def _intensity(title: str) -> Unit | None:
    """Return the unit of intensity in a title, or None; raise an error for another unit."""
    unit = _read(title).unit
    if unit is None or unit.dimension == NUMBER:
        unknown_units = [text for text in units_in(title)[0] if not RELATIVE.fullmatch(plain(text))]
        if unknown_units:
            raise ConditionError(f"'{quote(unknown_units[0])}' is not a unit of intensity", KNOWN)
        return None
    facts = read(unit)
    if facts and facts.geometry == INTENSITY and facts.axis == NONE and not unit.is_scale:
        return unit
    raise ConditionError(f"the values are in {describe(unit)}", KNOWN)


def _read(title: str, like: Unit | None = None) -> Title:
    """Read a title; its numbers, if any, must belong to its unit."""
    try:
        parsed = read_title(title, like)
        if parsed.unit is None:
            refuse_altered(read_title(title.replace("%", " "), like))  # of the peak
    except UnitError as error:
        raise ConditionError(error.message, KNOWN if like is None else error.hint) from None
    return parsed
