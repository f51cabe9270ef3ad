"""The lines of a file of numbers, in blocks, with any encoding and line ends."""

import codecs
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from itertools import chain

from radcalc import terminal
from radcalc.errors import ConditionError, Hint, quote_path

ENDINGS = (".csv", ".tsv", ".txt", ".dat")  # extensions of files of columns

BLOCK = 1 << 20  # bytes read at a time
LONGEST = 1 << 22  # bytes of a line
MOST_BYTES = 1 << 29  # of a file
MARKS = {codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE}

Lines = list[str]


def refusal(name: str, number: int, problem: str, hint: Hint) -> ConditionError:
    """Return the error of a file, with the line unless it is 0."""
    return ConditionError(f"{where(name, number)}: {problem}", hint)


def where(name: str, number: int, row: str = "line") -> str:
    """Return a place in a file, without a line if it is 0."""
    return f"{name}, {row} {number}" if number else name


def _lines(text: str) -> Lines:
    """Return the lines of a text; str.splitlines would also split at \\x85 in Latin-1."""
    if "\r" in text:
        text = text.replace("\r\n", "\n").replace("\r", "\n")
    lines = text.split("\n")
    if not lines[-1]:
        lines.pop()
    return lines


@contextmanager
def reading(path: str, expected: str) -> Iterator[tuple[str, Callable[[int], bytes]]]:
    """Yield the name of a file, a pipe or standard input (-), and a function that reads bytes.

    Raise a ConditionError if it cannot be read.
    """
    if path == "-":
        yield "stdin", terminal.read
        return
    with readable(path, expected) as name, open(path, "rb", buffering=0) as file:
        yield name, file.read


def is_file_name(path: str) -> bool:
    """Return whether the system can take a text as a name: it has no NUL and no lone surrogate."""
    try:
        return b"\0" not in os.fsencode(path)
    except UnicodeEncodeError:
        return False


@contextmanager
def readable(path: str, expected: str) -> Iterator[str]:
    """Yield the name of a file in messages; raise a ConditionError for an OSError meanwhile."""
    name = quote_path(path)
    if not is_file_name(path):
        raise ConditionError(f"cannot read {name}: not a file name", expected)
    try:
        yield name
    except OSError as error:
        raise ConditionError(f"cannot read {name}: {error.strerror}", expected) from None


class Text:
    """The text of a file: UTF-8, UTF-16 with a byte order mark, or otherwise Latin-1.

    `read` returns up to so many bytes, and b"" at the end; `row` is the expected content of a row,
    for messages; `largest` is the greatest size of the file [bytes], `first` the number of its
    first line.
    """

    def __init__(
        self,
        name: str,
        read: Callable[[int], bytes],
        row: str,
        largest: float = MOST_BYTES,
        first: int = 1,
    ) -> None:
        self.name, self.read, self.row, self.largest = name, read, row, largest
        self.first = first
        self.encoding = "utf-8-sig"
        self.note = ""

    def blocks(self) -> Iterator[tuple[int, Lines]]:
        """Yield the lines in blocks, with the number of the first line of each."""
        number, size, rest = self.first, 0, b""
        read = filter(None, self._in_utf8())
        while True:
            data = next(read, b"")
            size += len(data)
            if size > self.largest:
                raise refusal(
                    self.name, 0, f"the file has more than {self.largest} bytes", "fewer rows"
                )
            ends = data.replace(b"\r\n", b"\n\n") if b"\r" in data else data
            cut = max(ends.rfind(b"\n"), ends.rfind(b"\r", 0, -1)) + 1 if data else 0
            whole, rest = (rest + data[:cut], data[cut:]) if cut else (b"", rest + data)
            if not data:
                whole = rest
            elif len(rest) > LONGEST:
                problem = f"the line has more than {LONGEST} bytes"
                raise refusal(self.name, number, problem, f"{self.row} in every row")
            if whole:
                lines = _lines(self._decoded(whole))
                yield number, lines
                number += len(lines)
            if not data:
                return

    def _in_utf8(self) -> Iterator[bytes]:
        blocks = iter(partial(self.read, BLOCK), b"")
        first = next(blocks, b"")
        if first[:2] not in MARKS:
            yield first
            yield from blocks
            return
        try:
            for text in codecs.iterdecode(chain([first], blocks), "utf-16"):
                yield text.encode()
        except UnicodeDecodeError:
            problem = "the byte order mark is that of UTF-16, but the text is not UTF-16"
            raise refusal(self.name, 0, problem, "the whole file, or one in UTF-8") from None

    def _decoded(self, data: bytes) -> str:
        """Decode whole lines; after the first line that is not UTF-8, all are Latin-1."""
        try:
            text = data.decode(self.encoding)
        except UnicodeDecodeError:
            self.encoding = "latin-1"
            self.note = "the text is not UTF-8; it is read as Latin-1"
            return data.decode(self.encoding)
        if self.encoding == "utf-8-sig":
            self.encoding = "utf-8"
        return text
