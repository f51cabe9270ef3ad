"""Standard input converted line by line: one line out for every line in.

Everything is bytes, and only the numbers change.  A block of lines in which every number is a
plain decimal is converted at once (`bulk.py`); any other goes line by line through the grammar.
"""

from collections.abc import Callable, Iterator
from io import BytesIO

from radcalc.bulk import Bulk
from radcalc.columns import BLANKS, Cut, Fields, Span
from radcalc.conversion import Plan
from radcalc.errors import LineError, NumberError, RadcalcError, UsageError, quote
from radcalc.operands import read_quantity
from radcalc.render.plain import DIGITS, number
from radcalc.units.grammar import parse_number

ABORT, FAIL, WARN, IGNORE = "abort", "fail", "warn", "ignore"
INVALID = (ABORT, FAIL, WARN, IGNORE)
BLOCK = 1 << 16
LONGEST = 1 << 24  # bytes of a line; an endless one would fill the memory
MOST_UNITS = 1000  # that are remembered
BOM = b"\xef\xbb\xbf"
NUMBER = b"0123456789.+-"

Read = Callable[[int], bytes]
Record = Callable[[int, int | None, Plan, float], str]  # line, field, plan, number given


class Numbers:
    """Texts that are bare numbers, all of one unit."""

    example = "--field N for one of several fields, or radcalc convert - TARGET for 100 lx"

    def __init__(self, made: Plan, precision: int | None = None) -> None:
        """Take the plan for all of them."""
        self.made = made
        self.precision = precision
        self.bulk = Bulk(made, precision or DIGITS)

    def read(self, text: bytes) -> tuple[Plan, float]:
        """The plan and the number of one text."""
        try:
            return self.made, parse_number(_decoded(text))
        except NumberError as error:
            several = len(text.split()) > 1
            raise NumberError(error.message, self.example if several else error.hint) from None

    def show(self, made: Plan, value: float) -> bytes:
        """What stands in the output for a number that was read."""
        return number(made.apply(value), self.precision).encode()

    def lines(self, block: bytes) -> bytes | None:
        """Convert a block of lines, each of them one text; None where any is unusual."""
        return self.bulk.lines(block)

    def column(self, texts: list[bytes]) -> list[bytes] | None:
        """Convert many texts; None where any is unusual."""
        shown = self.bulk.lines(b"\n".join(texts) + b"\n")
        return None if shown is None else shown[:-1].split(b"\n")


class Quantities:
    """Texts that carry their own units: a plan for each that comes."""

    def __init__(
        self, plans: Callable[[str], Plan], unit: bytes, precision: int | None = None
    ) -> None:
        """Take what makes a plan from a unit, and what follows each answer."""
        self.plans = plans
        self.unit = unit
        self.precision = precision
        self.known: dict[str, Plan | RadcalcError] = {}
        self.bulks: dict[bytes, Bulk | None] = {}

    def read(self, text: bytes) -> tuple[Plan, float]:
        """The plan and the number of one text."""
        value, unit = read_quantity(_decoded(text))
        if not unit:
            raise UsageError(
                f"'{quote(text.decode())}' has no unit",
                "radcalc convert - UNIT TARGET for bare numbers",
            )
        return self._plan(unit), value

    def _plan(self, unit: str) -> Plan:
        made = self.known.get(unit)
        if made is None:
            if len(self.known) >= MOST_UNITS:
                self.known.clear()
            try:
                made = self.plans(unit)
            except RadcalcError as error:
                made = error
            self.known[unit] = made
        if isinstance(made, RadcalcError):
            raise made
        return made

    def show(self, made: Plan, value: float) -> bytes:
        """What stands in the output for a quantity that was read."""
        return number(made.apply(value), self.precision).encode() + self.unit

    def lines(self, block: bytes) -> bytes | None:
        """Convert a block of lines, each of them one text; None where any is unusual."""
        texts = block.split(b"\n")
        texts.pop()
        shown = self.column(texts)
        return None if shown is None else b"\n".join(shown) + b"\n"

    def column(self, texts: list[bytes]) -> list[bytes] | None:
        """Convert many texts, those of one unit at a time; None where any is unusual."""
        units = [text.lstrip(NUMBER) for text in texts]
        places: dict[bytes, list[int]] = {}
        for place, unit in enumerate(units):
            if unit in places:
                places[unit].append(place)
            else:
                places[unit] = [place]
        shown = texts[:]
        for unit, having in places.items():
            bulk = self._bulk(unit, texts[having[0]])
            if bulk is None:
                return None
            size = len(unit)
            numbers = bulk.lines(b"\n".join([texts[place][:-size] for place in having]) + b"\n")
            if numbers is None:
                return None
            for place, value in zip(having, numbers.split(b"\n"), strict=False):
                shown[place] = value + self.unit
        return shown

    def _bulk(self, unit: bytes, text: bytes) -> Bulk | None:
        """What converts numbers with this text of a unit behind them.

        The grammar must agree that this is where the unit begins, and blanks behind it are none
        of it.
        """
        if unit not in self.bulks:
            if len(self.bulks) >= MOST_UNITS:
                self.bulks.clear()
            bulk = None
            if unit and unit == unit.rstrip():
                try:
                    made, _ = self.read(text)
                    agreed = made.source.text == unit.decode().strip()
                    bulk = Bulk(made, self.precision or DIGITS) if agreed else None
                except RadcalcError:
                    pass
            self.bulks[unit] = bulk
        return self.bulks[unit]


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
        if self.record or block[-1:] != b"\n":
            return None
        crlf = b"\r" in block
        if crlf:
            ends = block.count(b"\r\n")
            if not ends == block.count(b"\r") == block.count(b"\n"):
                return None
            block = block.replace(b"\r\n", b"\n")
        if self.cut:
            shown = self.cut.table(block, self.fields, self.texts.column)
        else:
            shown = self.texts.lines(block)
        return shown.replace(b"\n", b"\r\n") if shown and crlf else shown

    def line(self, line: bytes, count: int) -> bytes:
        """Convert one line, its end included; raise LineError where it cannot be."""
        body = _body(line)
        text = body.lstrip(BLANKS)
        if not text or text[:1] == b"#":
            return b"" if self.record else line
        parts: list[bytes] = []
        done, field = 0, None
        try:
            for field, (start, end) in self._spans(body):
                made, value = self.texts.read(body[start:end])
                if self.record:
                    parts.append(self.record(count, field, made, value).encode())
                else:
                    parts += [body[done:start], self.texts.show(made, value)]
                done = end
        except RadcalcError as error:
            where = f"stdin, line {count}" + (f", field {field}" if field else "")
            raise LineError(f"{where}: {error.message}", error.hint) from None
        return b"".join(parts if self.record else [*parts, line[done:]])

    def _spans(self, body: bytes) -> list[tuple[int | None, Span]]:
        """The texts to be converted: the number of the field, and where it is."""
        if self.cut is None:
            start = len(body) - len(body.lstrip(BLANKS))
            return [(None, (start, len(body.rstrip(BLANKS))))]
        spans = self.cut.spans(body)
        return [(i + 1, self.cut.inner(body, spans[i])) for i in self.fields.of(len(spans))]


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
        shown = stream.block(block)
        if shown is not None:
            count += block.count(b"\n")
            write(shown)
            continue
        lines: list[bytes] = []
        for line in BytesIO(block):  # unlike splitlines, at newlines alone
            count += 1
            try:
                lines.append(stream.line(line, count))
            except LineError as error:
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


def _blocks(read: Read) -> Iterator[bytes]:
    """Whole lines, as many as there are; the last may lack its end."""
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
            raise LineError(f"stdin has a line of more than {LONGEST} bytes", "shorter lines")
    if parts:
        yield b"".join(parts)


def _first(block: bytes) -> tuple[bytes, bytes]:
    """The first line and the rest."""
    line, end, rest = block.partition(b"\n")
    return line + end, rest


def _body(line: bytes) -> bytes:
    """A line without its end."""
    return line.removesuffix(b"\n").removesuffix(b"\r")


def _decoded(text: bytes) -> str:
    """The text of a number or a unit, which is UTF-8."""
    try:
        return text.decode()
    except UnicodeDecodeError:
        shown = quote(text.decode(errors="backslashreplace"))
        raise NumberError(f"'{shown}' is not text in UTF-8", "UTF-8") from None
