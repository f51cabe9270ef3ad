"""Safe reading of the contents of regular files up to a given size, and writing of whole files."""

import errno
import os
import secrets
import stat
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager, suppress
from io import FileIO

from radcalc import terminal
from radcalc.errors import ConditionError, OutputError, correct, quote, quote_path
from radcalc.files.text import is_file_name, readable

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
