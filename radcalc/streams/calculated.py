"""The texts of a stream that are one input of a calculator: an answer to each.

A text is worked out as a call of its own would be, and what is done with its number is recorded
(`traces.py`).  Other numbers in that unit go through the record, many at a time; where one does
not keep within its bounds, it is worked out by itself and begins another record.
"""

from collections.abc import Callable, Sequence
from itertools import chain
from typing import NamedTuple

from radcalc.answer import Answer, Row
from radcalc.calculators.results import pick
from radcalc.errors import MissingUnit, NumberError, RadcalcError, UsageError, option, quote
from radcalc.given import Given, with_number
from radcalc.render.plain import DIGITS, number
from radcalc.stdio import remarks
from radcalc.streams import MARK, Source
from radcalc.streams.blocks import numbers
from radcalc.streams.readers import LONGEST_UNIT, MOST_UNITS, POINT, by_unit, decoded, pointed
from radcalc.streams.traces import REFUSALS, Recording, Trace, Unknown, Untraceable
from radcalc.units.numbers import parse_number

MOST_RECORDS = 12  # of one unit; a calculation of more ways is worked out text by text
JOINED = "%‰°"  # which stand behind a number without a blank, as letters do
MOST_ALONE = 10_000  # texts worked out by themselves that are remembered
SEVERAL = "{} answers fit '{}', and a line has one", "a call of its own for it"


class Found(NamedTuple):
    """The answer to a text, and the results of it that are wanted."""

    answer: Answer
    rows: list[Row]


class Calculated:
    """Texts that are an input, each of which becomes the results that are wanted.

    With a unit of its own the input's texts are bare numbers.  `work_out` answers to what was
    given; `hear` takes what is to be said of the answer to a line.
    """

    def __init__(
        self,
        source: Source,
        work_out: Callable[[Given], Answer],
        wanted: Sequence[str],
        hear: Callable[[Sequence[str], int], None],
        precision: int | None = None,
        mark: bytes = POINT,
    ) -> None:
        """Take the calculator, what is asked of it, and the decimal mark of the numbers."""
        self.line = 0  # at which the stream is
        self.source = source
        self.work_out = work_out
        self.wanted = tuple(wanted)
        self.hear = hear
        self.precision = precision
        self.mark = mark
        self.form = "\t".join([f"%.{precision or DIGITS}g"] * len(self.wanted)).encode()
        self.units: dict[bytes, _OfUnit] = {}

    def read(self, text: bytes) -> tuple[Given, Found]:
        """What a text gives, and the answer to it."""
        typed = self._typed(pointed(decoded(text), self.mark))
        try:
            given = self.source.read(typed)
        except MissingUnit as error:
            hint = option(self.source.name, "- UNIT") + " for bare numbers"
            raise UsageError(f"'{quote(typed)}' has no unit", hint) from error
        return given, self.find(given)

    def _typed(self, text: str) -> str:
        """A text as the option of a call of its own would have it."""
        unit = self.source.unit
        if not unit:
            return text
        try:
            parse_number(text)
        except NumberError as error:
            if any(map(str.isalpha, text)):
                hint = f"{option(self.source.name, '-')} for lines with their own unit"
                raise NumberError(error.message, hint) from None
            raise
        is_joined = text[-1:].isdigit() and (unit[0].isalpha() or unit[0] in JOINED)
        return f"{text}{unit}" if is_joined else f"{text} {unit}"

    def find(self, given: Given) -> Found:
        """The answer to what is given, and the results that are wanted, in the first's units."""
        answer = self.work_out(given)
        if answer.more:
            problem, hint = SEVERAL
            raise UsageError(problem.format(1 + len(answer.more), quote(given.text)), hint)
        rows = [pick(answer.values, name) for name in self.wanted]
        self.wanted = tuple([f"{row.name}:{row.unit}" for row in rows])
        return Found(answer, rows)

    def show(self, given: Given, found: Found) -> bytes:
        """What stands in the output for a text that was read."""
        self.hear(remarks_of(found.answer), self.line)
        shown = "\t".join([number(row.value, self.precision) for row in found.rows])
        return shown.encode().replace(POINT, self.mark)

    def lines(self, block: bytes) -> bytes | None:
        """Work out a block of lines, each of them one text; None where any is unusual."""
        texts = block.split(b"\n")
        texts.pop()
        shown = self._shown(texts)
        return None if shown is None else shown + b"\n"

    def column(self, texts: list[bytes]) -> list[bytes] | None:
        """Work out many texts; None where any is unusual."""
        shown = self._shown(texts)
        return None if shown is None else shown.split(b"\n")

    def _shown(self, texts: list[bytes]) -> bytes | None:
        if self.mark != POINT:
            block = b"\n".join(texts)
            if POINT in block:
                return None
            texts = block.replace(self.mark, POINT).split(b"\n")
        columns = self._columns(texts)
        if columns is None:
            return None
        flat = columns[0] if len(columns) == 1 else chain(*zip(*columns, strict=True))
        shown = b"\n".join([self.form] * len(texts)) % tuple(flat)
        return shown if self.mark == POINT else shown.replace(POINT, self.mark)

    def _columns(self, texts: list[bytes]) -> list[list[float]] | None:
        """The results that are wanted of each text, those of one unit at a time."""
        if self.source.unit:
            return self._of_unit(b"").columns(texts, texts, range(len(texts)))
        columns = [[0.0] * len(texts) for _ in self.wanted]
        for unit, having in by_unit(texts).items():
            own = [texts[place] for place in having]
            size = len(unit)
            found = self._of_unit(unit).columns(
                own, [text[:-size] for text in own] if size else own, having
            )
            if found is None:
                return None
            for column, part in zip(columns, found, strict=True):
                for place, value in zip(having, part, strict=True):
                    column[place] = value
        return columns

    def _of_unit(self, unit: bytes) -> "_OfUnit":
        if unit not in self.units:
            if len(self.units) >= MOST_UNITS:
                self.units.clear()
            self.units[unit] = _OfUnit(self, unit)
        return self.units[unit]


class _Recorded(NamedTuple):
    """A record, and what is to be said of its results, with MARK for numbers that vary."""

    record: Recording
    remarks: list[str]


class _OfUnit:
    """The texts of one unit, which is what stands behind their numbers."""

    def __init__(self, calculated: Calculated, unit: bytes) -> None:
        self.calculated = calculated
        self.unit = unit
        self.records: list[_Recorded] = []
        self.attempts = 0
        self.alone: dict[bytes, list[float]] = {}
        self.may_record = len(unit) <= LONGEST_UNIT and unit == unit.rstrip()

    def columns(
        self, texts: list[bytes], bare: list[bytes], places: Sequence[int]
    ) -> list[list[float]] | None:
        """The results of texts, of which the `bare` numbers are given; None where any is unusual.

        They are at some `places`, counted from the line at which the stream is.
        """
        values = numbers(bare)
        if values is None or not self.may_record:
            return None
        line = self.calculated.line
        waiting: Sequence[int] = range(len(values))
        found: list[tuple[Sequence[int], list[list[float]]]] = []
        tried = 0
        while waiting:
            for recorded in self.records[tried:]:
                asked = values if len(waiting) == len(values) else [values[k] for k in waiting]
                fits, columns = recorded.record.run(asked)
                if fits is None:
                    done, waiting = waiting, ()
                else:
                    done = [waiting[k] for k in fits]
                    rest = set(fits)
                    waiting = [one for k, one in enumerate(waiting) if k not in rest]
                if done:
                    self.calculated.hear(recorded.remarks, line + places[done[0]])
                    found.append((done, columns))
            tried = len(self.records)
            if waiting:
                first, *waiting = waiting
                results = self._alone(texts[first], values[first], line + places[first])
                if results is None:
                    return None
                found.append(([first], [[result] for result in results]))
        if len(found) == 1:
            return found[0][1]
        together = [[0.0] * len(values) for _ in self.calculated.wanted]
        for done, columns in found:
            for column, part in zip(together, columns, strict=True):
                for place, value in zip(done, part, strict=True):
                    column[place] = value
        return together

    def _alone(self, text: bytes, value: float, line: int) -> list[float] | None:
        """Work a text out by itself, and record how; None where it is refused.

        It is remembered, since a block in which a later one is refused comes again in parts.
        """
        calculated = self.calculated
        if text in self.alone:
            return self.alone[text]
        try:
            given, found = calculated.read(text.replace(POINT, calculated.mark))
        except RadcalcError:
            return None  # which is said when the line comes by itself
        calculated.hear(remarks_of(found.answer), line)
        is_own = not self.unit or given.unit_text == self.unit.decode().strip()
        if self.attempts < MOST_RECORDS and is_own and given.number == value:
            self.attempts += 1
            recorded = self._record(given, value, found)
            if recorded:
                self.records.append(recorded)
        if len(self.alone) >= MOST_ALONE:
            self.alone.clear()
        self.alone[text] = [row.value for row in found.rows]
        return self.alone[text]

    def _record(self, given: Given, value: float, found: Found) -> _Recorded | None:
        """Record what is done with a number, if that can be and gives what was found."""
        trace = Trace(value)
        try:
            again = self.calculated.find(with_number(given, trace.start, MARK, Unknown(trace)))
            record = trace.record([row.value for row in again.rows])
        except (TypeError, AttributeError, *REFUSALS, Untraceable):  # of what is no float
            return None
        if record.run([value]) != (None, [[row.value] for row in found.rows]):
            return None
        return _Recorded(record, remarks_of(again.answer))


def remarks_of(answer: Answer) -> list[str]:
    """What is assumed and noted, a line each."""
    return remarks(answer.assumptions, answer.notes)
