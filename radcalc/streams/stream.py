"""Standard input converted line by line: one output line for every input line.

Everything is bytes, and only the numbers change.  A block in which every number is a plain decimal
is converted at once (`blocks.py`); any other is read line by line with the grammar.
"""

from collections.abc import Callable, Iterator
from io import BytesIO
from itertools import islice
from typing import Any

from radcalc.errors import LineError, NumberError, RadcalcError, UsageError, option
from radcalc.streams.fields import BLANKS, Cut, Fields, Span
from radcalc.streams.readers import Texts
from radcalc.terminal import ABORT, FAIL, IGNORE

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from radcalc.streams.header import Header

BLOCK = 1 << 16
FEW = 200  # bytes of the smallest part
MANY = 1000  # fields of a line converted at once
LONGEST = 1 << 24  # bytes of a line, against endless ones
BOM = b"\xef\xbb\xbf"

Read = Callable[[int], bytes]
Record = Callable[[int, int | None, Any, Any], str]  # line, field, and the value of the text


class Stream:
    """The texts to convert in every line, and their output."""

    def __init__(
        self,
        texts: Texts,
        cut: Cut | None = None,
        fields: Fields | None = None,
        lines: int = 0,
        header: "Header | None" = None,
        record: Record | None = None,
        adds: bool = False,
    ) -> None:
        """Take whole lines if `cut` is None; the first `lines` are a header.

        With `adds` the result is a field after the others.  With a `record` every number becomes a
        separate line, without other output.
        """
        self.texts, self.cut = texts, cut
        self.fields = fields or Fields()
        self.lines, self.header, self.record, self.adds = lines, header, record, adds
        self.units: int | None = None  # the field with the unit of each line
        self.width = 0  # fields of every line; 0 for any number
        # A number may have a comma: without a header, the first good line sets the number.
        self.is_counted = bool(cut and cut.delimiter == b"," and not lines)

    def head(self, line: bytes, above: bytes) -> bytes:
        """Read the last line of the header, after the line above; return its output."""
        if self.header is None:
            return line
        body = _body(line)
        title_line, self.width = self.header.read(body, self.fields, _body(above))
        self.texts = self.header.texts or self.texts
        self.fields = self.header.fields or self.fields
        self.units = self.header.units
        return title_line + line[len(body) :]

    def block(self, block: bytes, count: int = 1) -> bytes | None:
        """Convert a block of whole lines from line `count` on; return None if any is unusual."""
        self.texts.line = count
        if block[-1:] != b"\n" or len(block) > 2 * BLOCK:  # it has a very long line
            return None
        if self.units is not None:
            return None
        crlf = b"\r" in block
        if crlf:
            ends = block.count(b"\r\n")
            if not ends == block.count(b"\r") == block.count(b"\n"):
                return None
            block = block.replace(b"\r\n", b"\n")
        if self.is_counted and not self.width:
            return None  # the first lines are read one by one
        if self.cut:
            converted = self.cut.convert(block, self.fields, self.texts, self.width, self.adds)
        else:
            converted = self.texts.lines(block)
            if converted and self.adds:
                lines = zip(block.split(b"\n"), converted.split(b"\n"), strict=True)
                converted = b"\n".join([line and line + b"\t" + new for line, new in lines])
        return converted.replace(b"\n", b"\r\n") if converted and crlf else converted

    def line(self, line: bytes, count: int) -> bytes:
        """Convert one line with its end; raise LineError if that fails."""
        body = _body(line)
        text = body.lstrip(BLANKS)
        if not text or text[:1] == b"#":
            return b"" if self.record else line
        self.texts.line = count
        out, done, added = bytearray(), 0, b""
        field: int | None = None
        try:
            if self.units is not None:
                body = self._in_unit(body, self.units)
            places = self._places(body)
            while chunk := list(islice(places, MANY)):
                texts = [body[start:end] for _, (start, end) in chunk]
                at_once = len(chunk) == MANY and not self.record
                converted = self.texts.column(texts) if at_once else None
                for k, (field, (start, end)) in enumerate(chunk):
                    if converted:
                        new = converted[k]
                    else:
                        source, value = self.texts.read(texts[k])
                        if self.record:
                            out += self.record(count, field, source, value).encode()
                            continue
                        new = self.texts.show(source, value)
                    if self.adds:
                        added = self._joint(body) + new
                    else:
                        out += body[done:start] + new
                        done = end
        except RadcalcError as error:
            where = f"stdin, line {count}" + (f", field {field}" if field else "")
            raise LineError(f"{where}: {error.message}", error.hint) from None
        if self.is_counted and not self.width and self.cut:
            self.width = sum(1 for _ in self.cut.spans(body))
        if self.record:
            return bytes(out)
        return bytes(out + body[done:] + added + line[len(_body(line)) :])

    def _in_unit(self, body: bytes, field: int) -> bytes:
        """Check the unit in a field of its own, and replace it by that of the result."""
        assert self.cut is not None
        assert self.header is not None
        spans = list(self.cut.spans(body))
        self._check_width(len(spans))
        start, end = self.cut.inner(body, spans[field])
        self.header.check_unit(body[start:end])
        if self.adds or self.record:
            return body
        return body[:start] + self.header.target.text.encode() + body[end:]

    def passed(self, line: bytes) -> bytes:
        """Return the output for a line that cannot be converted; an added field is empty."""
        if self.record or not self.adds:
            return b"" if self.record else line
        body = _body(line)
        empty = b"-" if self.cut and not self.cut.delimiter else b""
        return body + self._joint(body) + empty + line[len(body) :]

    def _joint(self, body: bytes) -> bytes:
        return self.cut.joint(body) if self.cut else b"\t"

    def _check_width(self, count: int) -> None:
        if self.width and count != self.width:
            place = "the lines before have" if self.is_counted else "the header has"
            hint = "as many fields in every line"
            if self.cut and self.cut.delimiter == b",":
                hint += "; quotes around a field with a comma"
            elif self.cut and not self.cut.delimiter:
                hint += f"; {option('delimiter', 'X')} if a field may have blanks"
            problem = f"{count} field{'s' * (count != 1)}, but {place} {self.width}"
            raise NumberError(problem, hint)

    def _places(self, body: bytes) -> Iterator[tuple[int | None, Span]]:
        """Yield the number of the field, and the place, of each text to convert.

        A line may have millions of fields: they are counted first and not kept.
        """
        if self.cut is None:
            yield None, (len(body) - len(body.lstrip(BLANKS)), len(body.rstrip(BLANKS)))
            return
        count = sum(1 for _ in self.cut.spans(body))
        self._check_width(count)
        chosen = self.fields.of(count)
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
    """Convert the whole input; return whether every line was good, or errors are allowed.

    Output before a bad line is written before its error.
    """
    count, good, above = 0, True, b""
    stream.width = 0
    for block in _blocks(read):
        if block is None:
            problem = f"stdin, line {count + 1}: more than {LONGEST} bytes"
            raise LineError(problem, "shorter lines")
        if not count and block.startswith(BOM):
            if not stream.record:
                write(BOM)
            block = block[len(BOM) :]
        while block and count < stream.lines:
            line, block = _first(block)
            count += 1
            titles = stream.head(line, above) if count == stream.lines else line
            if not stream.record:
                write(titles)
            above = line
        if not block:
            continue
        lines: list[bytes] = []
        try:
            for converted, error in _converted(stream, block, count + 1):
                if error and invalid != IGNORE:
                    _write(write, lines)
                    if invalid == ABORT:
                        raise error
                    complain(error)
                    good = good and invalid != FAIL
                lines.append(converted)
        finally:  # also before a bug
            _write(write, lines)
        count += block.count(b"\n")
    if count < stream.lines and stream.header and stream.header.column:
        raise UsageError("the header of stdin is missing", "a line with the names of the columns")
    return good


def _write(write: Callable[[bytes], object], lines: list[bytes]) -> None:
    """Write the lines so far, once."""
    data = b"".join(lines)
    lines.clear()
    write(data)


def _converted(
    stream: Stream, block: bytes, count: int
) -> Iterator[tuple[bytes, LineError | None]]:
    """Convert a block, from line `count` on: many lines, or one line with its error, if any."""
    for part, converted_part in _parts(stream, block, count):
        if converted_part is not None:
            yield converted_part, None
            count += part.count(b"\n")
            continue
        for line in BytesIO(part):  # unlike splitlines, only at newlines
            try:
                converted, problem = stream.line(line, count), None
            except LineError as error:
                converted, problem = stream.passed(line), error
            yield converted, problem
            count += 1


def _parts(stream: Stream, block: bytes, count: int) -> Iterator[tuple[bytes, bytes | None]]:
    """Divide a block, from line `count` on, until its parts are converted at once.

    A few lines, or lines for records, are yielded with None, for conversion one by one.
    """
    try:
        converted = None if stream.record else stream.block(block, count)
    except Exception:  # a bug, which one of the lines reports after those before it
        converted = None
    middle = block.find(b"\n", len(block) // 2) + 1
    if converted is not None or stream.record or len(block) < FEW or middle in (0, len(block)):
        yield block, converted
    else:
        yield from _parts(stream, block[:middle], count)
        yield from _parts(stream, block[middle:], count + block.count(b"\n", 0, middle))


def _blocks(read: Read) -> Iterator[bytes | None]:
    """Yield blocks of whole lines; the last may lack its end; None for a line too long."""
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
    line, end, rest = block.partition(b"\n")
    return line + end, rest


def _body(line: bytes) -> bytes:
    return line.removesuffix(b"\n").removesuffix(b"\r")
