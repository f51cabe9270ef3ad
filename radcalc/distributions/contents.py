"""What a file holds, read safely: regular files alone, of a size that is known to fit."""

import os
import stat
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from io import FileIO

from radcalc import stdio
from radcalc.errors import ConditionError, quote_path

BLOCK = 1 << 20  # bytes that are read at a time where nobody says how many there are


def read_bytes(path: str, largest: int, expected: str) -> tuple[str, bytes]:
    """Read all of a file.

    Parameters
    ----------
    path : str
        A regular file, or "-" for standard input.
    largest : int
        Bytes that it may have.
    expected : str
        What it should be, for the hint of a message.

    Returns
    -------
    name : str
        What messages call it.
    data : bytes
        What it holds.

    Raises
    ------
    ConditionError
        If it cannot be read, is no regular file or is too large.
    """
    if path == "-":
        return "stdin", _whole(stdio.read, BLOCK, largest, "stdin")
    with opened(path, largest, expected, "a file, or - for standard input") as file:
        return quote_path(path), whole(file, largest, path)


@contextmanager
def opened(path: str, largest: int, expected: str, instead: str = "a file") -> Iterator[FileIO]:
    """A regular file, open to be read; nothing else is waited for, or read without end.

    Raises what `read_bytes` raises, also for what goes wrong while it is read; `instead` is the
    hint where it is a pipe or a device.

    Examples
    --------
    >>> with opened("/dev/zero", 1000, "a text"):
    ...     pass
    Traceback (most recent call last):
    radcalc.errors.ConditionError: cannot read /dev/zero: a pipe or a device
    try: a file
    """
    name = quote_path(path)
    try:
        with FileIO(path, opener=_without_waiting) as file:
            about = os.fstat(file.fileno())
            if not stat.S_ISREG(about.st_mode):
                raise ConditionError(f"cannot read {name}: a pipe or a device", instead)
            if about.st_size > largest:
                raise _too_large(name, largest)
            yield file
    except OSError as error:
        raise ConditionError(f"cannot read {name}: {error.strerror}", expected) from None
    except ValueError:  # a null character
        raise ConditionError(f"cannot read {name}: no name of a file", expected) from None


def whole(file: FileIO, largest: int, path: str) -> bytes:
    """What is left of an open file: that much memory, and no copy."""
    size = os.fstat(file.fileno()).st_size
    return _whole(file.read, max(BLOCK, size + 1), largest, quote_path(path))


def _without_waiting(path: str, flags: int) -> int:
    """Open a file; a pipe that nobody writes to would else be waited for."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _whole(read: Callable[[int], bytes | None], block: int, largest: int, name: str) -> bytes:
    blocks, size = [], 0
    while found := read(block):
        blocks.append(found)
        size += len(found)
        if size > largest:
            raise _too_large(name, largest)
    return b"".join(blocks)


def _too_large(name: str, largest: int) -> ConditionError:
    return ConditionError(f"{name} has more than {largest >> 20} MiB", "a smaller file")
