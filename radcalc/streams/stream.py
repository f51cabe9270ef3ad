"""Standard input converted line by line: one line out for every line in.

Everything is bytes, and only the numbers change.  A block of lines in which every number is a
plain decimal is converted at once (`bulk.py`); any other goes line by line through the grammar.
"""

from collections.abc import Callable, Iterator
from io import BytesIO
from itertools import islice

from radcalc.conversion.plan import Plan
from radcalc.errors import LineError, RadcalcError, UsageError
from radcalc.streams import ABORT, FAIL, IGNORE
from radcalc.streams.fields import BLANKS, Cut, Fields, Span
from radcalc.streams.readers import Numbers, Quantities

BLOCK = 1 << 16
FEW = 200  # bytes that are not cut further
MANY = 1000  # fields of a line that are converted at once
LONGEST = 1 << 24  # bytes of a line; an endless one would fill the memory
BOM = b"\xef\xbb\xbf"

Read = Callable[[int], bytes]
Record = Callable[[int, int | None, Plan, float], str]  # line, field, plan, number given


class Stream:
    """What is done with every line: which texts of it are converted, and how they are shown."""

    def __init__(
        self,
        texts: Numbers | Quantities,
        cut: Cut | None = None,
        fields: Fields | None = None,
        name: str = "",
        header: int = 0,
        record: Record | None = None,
    ) -> None:
        """Take whole lines where `cut` is None; `name` is a column's in the header.

        With a `record` every number becomes a line of its own, and nothing else is shown.
        """
        self.texts = texts
        self.cut = cut
        self.fields = fields or Fields()
        self.name = name
        self.header = header
        self.record = record

    def head(self, line: bytes) -> None:
        """Find the column in the last line of the header."""
        if self.name and self.cut:
            self.fields = self.cut.find(_body(line), self.name)

    def block(self, block: bytes) -> bytes | None:
        """Convert a block of whole lines at once; None where any of them is unusual."""
        if block[-1:] != b"\n" or len(block) > 2 * BLOCK:  # which has a very long line
            return None
        crlf = b"\r" in block
        if crlf:
            ends = block.count(b"\r\n")
            if not ends == block.count(b"\r") == block.count(b"\n"):
                return None
            block = block.replace(b"\r\n", b"\n")
        if self.cut:
            shown = self.cut.convert(block, self.fields, self.texts.column)
        else:
            shown = self.texts.lines(block)
        return shown.replace(b"\n", b"\r\n") if shown and crlf else shown

    def line(self, line: bytes, count: int) -> bytes:
        """Convert one line, its end included; raise LineError where it cannot be."""
        body = _body(line)
        text = body.lstrip(BLANKS)
        if not text or text[:1] == b"#":
            return b"" if self.record else line
        out, done = bytearray(), 0
        field: int | None = None
        try:
            places = self._places(body)
            while some := list(islice(places, MANY)):
                texts = [body[start:end] for _, (start, end) in some]
                at_once = len(some) == MANY and not self.record
                shown = self.texts.column(texts) if at_once else None
                for k, (field, (start, end)) in enumerate(some):
                    if shown:
                        out += body[done:start] + shown[k]
                    else:
                        made, value = self.texts.read(texts[k])
                        if self.record:
                            out += self.record(count, field, made, value).encode()
                        else:
                            out += body[done:start] + self.texts.show(made, value)
                    done = end
        except RadcalcError as error:
            where = f"stdin, line {count}" + (f", field {field}" if field else "")
            raise LineError(f"{where}: {error.message}", error.hint) from None
        return bytes(out if self.record else out + line[done:])

    def _places(self, body: bytes) -> Iterator[tuple[int | None, Span]]:
        """The texts to be converted: the number of the field, and where it is.

        A line may have millions of fields: they are counted first and not kept.
        """
        if self.cut is None:
            yield None, (len(body) - len(body.lstrip(BLANKS)), len(body.rstrip(BLANKS)))
            return
        chosen = self.fields.of(sum(1 for _ in self.cut.spans(body)))
        wanted = next(chosen, None)
        for index, span in enumerate(self.cut.spans(body)):
            if index == wanted:
                yield index + 1, self.cut.inner(body, span)
                wanted = next(chosen, None)


def run(
    stream: Stream,
    read: Read,
    write: Callable[[bytes], object],
    invalid: str = ABORT,
    complain: Callable[[RadcalcError], object] = lambda error: None,
) -> bool:
    """Convert all that is read; whether every line could be, or it does not matter.

    What stands before a bad line is written before anything is said about it.
    """
    count, good = 0, True
    for block in _blocks(read):
        if block is None:
            problem = f"stdin, line {count + 1}: more than {LONGEST} bytes"
            raise LineError(problem, "shorter lines")
        if not count and block.startswith(BOM):
            if not stream.record:
                write(BOM)
            block = block[len(BOM) :]
        while block and count < stream.header:
            line, block = _first(block)
            count += 1
            if count == stream.header:
                stream.head(line)
            if not stream.record:
                write(line)
        if not block:
            continue
        lines: list[bytes] = []
        for part, shown in _parts(stream, block):
            if shown is not None:
                count += part.count(b"\n")
                lines.append(shown)
                continue
            for line in BytesIO(part):  # unlike splitlines, at newlines alone
                count += 1
                try:
                    lines.append(stream.line(line, count))
                except LineError as error:
                    if invalid != IGNORE:
                        write(b"".join(lines))
                        lines.clear()
                    if invalid == ABORT:
                        raise
                    if invalid != IGNORE:
                        complain(error)
                    good = good and invalid != FAIL
                    if not stream.record:
                        lines.append(line)
        write(b"".join(lines))
    if count < stream.header and stream.name:
        raise UsageError("stdin has no header", "a line with the names of the columns")
    return good


def _parts(stream: Stream, block: bytes) -> Iterator[tuple[bytes, bytes | None]]:
    """Cut a block until its parts are converted at once, or are a few lines, with None."""
    shown = None if stream.record else stream.block(block)
    middle = block.find(b"\n", len(block) // 2) + 1
    if shown is not None or stream.record or len(block) < FEW or middle in (0, len(block)):
        yield block, shown
    else:
        yield from _parts(stream, block[:middle])
        yield from _parts(stream, block[middle:])


def _blocks(read: Read) -> Iterator[bytes | None]:
    """Whole lines, as many as there are; the last may lack its end; None for one too long."""
    parts: list[bytes] = []
    size = 0
    while data := read(BLOCK):
        end = data.rfind(b"\n") + 1
        if end:
            yield b"".join([*parts, data[:end]])
            parts, size = [], 0
        rest = data[end:]
        if rest:
            parts.append(rest)
            size += len(rest)
        if size > LONGEST:
            yield None
            return
    if parts:
        yield b"".join(parts)


def _first(block: bytes) -> tuple[bytes, bytes]:
    """The first line and the rest."""
    line, end, rest = block.partition(b"\n")
    return line + end, rest


def _body(line: bytes) -> bytes:
    """A line without its end."""
    return line.removesuffix(b"\n").removesuffix(b"\r")
