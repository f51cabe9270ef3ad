"""Texts of a stream as one input of a calculator, with an answer to each.

Plain numbers of one unit are an array that the calculator takes at once, `exactly`: each element
has the last bit of a single float.  A block with a bad number is divided into smaller ones, and a
few texts are calculated one by one.

Assumptions and notes are written once for all lines; remarks that differ only in their numbers are
one, with the range of each number.
"""

import re
from collections.abc import Callable, Sequence
from itertools import chain
from typing import NamedTuple

from radcalc.answer import Answer, Row
from radcalc.calculators.results import pick, said_of
from radcalc.errors import MissingUnit, NumberError, RadcalcError, UsageError, option, quote
from radcalc.inputs import DigitsMatter, Input
from radcalc.inputs.quantities import with_numbers
from radcalc.maths import exactly
from radcalc.render.plain import DIGITS, number
from radcalc.streams import Source, readers
from radcalc.streams.readers import POINT
from radcalc.terminal import remarks
from radcalc.units.numbers import parse_number

NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?:/[1-9]\d*)?"
SPAN = re.compile(f"({NUMBER})(?: to ({NUMBER}))?")
MARK = "\0"  # stands for a number or a range
FEW_LINES = 3  # most lines named one by one

Span = tuple[str, str]  # the least and the largest number, as written
# Texts in one calculation: the first block takes longer than loading NumPy.
FIRST, FEWEST = 256, 16
JOINED = "%‰°"  # written after a number without a blank, like letters
SEVERAL = "{} answers fit '{}', but a line has one", "a separate call for it"


class LineAnswer(NamedTuple):
    """The answer to a text, and its requested results."""

    answer: Answer
    rows: list[Row]


class Calculated:
    """Texts of an input, each replaced by the requested results.

    If the input has a unit, its texts are bare numbers.  `hear` takes the remarks on some lines.
    """

    def __init__(
        self,
        source: Source,
        work_out: Callable[[Input], Answer],
        wanted: Sequence[str],
        hear: Callable[[Sequence[str], Sequence[int]], None],
        precision: int | None = None,
        mark: bytes = POINT,
    ) -> None:
        self.line = 0  # the current line
        self.source, self.work_out = source, work_out
        self.wanted = tuple(wanted)
        self.hear, self.precision, self.mark = hear, precision, mark
        self.each = "\t".join([f"%.{precision or DIGITS}g"] * len(self.wanted)).encode()
        self.form = self.each if mark == POINT else b""
        self.units: dict[bytes, Input] = {}  # the first of each unit
        self.fewest = FIRST

    def read(self, text: bytes) -> tuple[Input, LineAnswer]:
        typed = self._typed(readers.pointed(readers.decoded(text), self.mark))
        try:
            given = self.source.read(typed)
        except MissingUnit as error:
            hint = option(self.source.name, "- UNIT") + " for bare numbers"
            raise UsageError(f"the unit of '{quote(typed)}' is missing", hint) from error
        return given, self.find(given)

    def _typed(self, text: str) -> str:
        """Return a text as the option of a single call."""
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

    def find(self, given: Input) -> LineAnswer:
        """Return the answer to an input, and the requested results in the units of the first."""
        answer = self.work_out(given)
        if answer.more:
            problem, hint = SEVERAL
            raise UsageError(problem.format(1 + len(answer.more), quote(given.text)), hint)
        rows = [pick(answer.values, name) for name in self.wanted]
        self.wanted = tuple([f"{row.name}:{row.unit}" for row in rows])
        return LineAnswer(answer, rows)

    def show(self, given: Input, result: LineAnswer) -> bytes:
        self.hear(remarks_of(result), range(self.line, self.line + 1))
        line = "\t".join([number(row.value, self.precision) for row in result.rows])
        return line.encode().replace(POINT, self.mark)

    def lines(self, block: bytes) -> bytes | None:
        converted = self._format(block.split(b"\n")[:-1])
        return None if converted is None else converted + b"\n"

    def column(self, texts: list[bytes]) -> list[bytes] | None:
        converted = self._format(texts)
        return None if converted is None else converted.split(b"\n")

    def _format(self, texts: list[bytes]) -> bytes | None:
        if self.mark != POINT:
            block = b"\n".join(texts)
            if POINT in block:
                return None
            texts = block.replace(self.mark, POINT).split(b"\n")
        values = self.values(texts)
        if values is None:
            return None
        lines = b"\n".join([self.each] * len(texts)) % tuple(values)
        return lines if self.mark == POINT else lines.replace(POINT, self.mark)

    def values(self, texts: list[bytes]) -> list[float] | None:
        columns = self._columns(texts)
        if columns is None:
            return None
        return columns[0] if len(columns) == 1 else [*chain(*zip(*columns, strict=True))]

    def _columns(self, texts: list[bytes]) -> "list[list[float]] | None":
        """Return the results of a block of values, None if one of them needs its own row."""
        if len(texts) < self.fewest:
            return None
        if self.source.unit:
            return self._of_unit(b"", texts, texts, range(self.line, self.line + len(texts)))
        columns = [[0.0] * len(texts) for _ in self.wanted]
        for unit, places in readers.by_unit(texts).items():
            of_unit = [texts[place] for place in places]
            size = len(unit)
            bare = [text[:-size] for text in of_unit] if size else of_unit
            lines = [self.line + place for place in places]
            results = self._of_unit(unit, of_unit, bare, lines)
            if results is None:
                return None
            for column, part in zip(columns, results, strict=True):
                for place, value in zip(places, part, strict=True):
                    column[place] = value
        return columns

    def _of_unit(
        self, unit: bytes, texts: list[bytes], bare: list[bytes], lines: Sequence[int]
    ) -> list[list[float]] | None:
        """Return the results of texts of one unit, with the numbers `bare`."""
        values = readers.numbers(bare)
        if values is None or len(unit) > readers.LONGEST_UNIT or unit != unit.rstrip():
            return None
        try:
            given = self._first(unit, texts[0], lines[0])
            if unit and given.unit_text != unit.decode().strip():
                return None
            import numpy

            self.fewest = FEWEST
            with exactly(), numpy.errstate(all="raise", under="ignore"):
                result = self.find(with_numbers(given, numpy.array(values)))
        except (ArithmeticError, ValueError, DigitsMatter, RadcalcError):
            return None  # smaller parts show which of them fail
        self.hear(remarks_of(result), lines)
        count = len(values)
        return [numpy.broadcast_to(row.value, count).tolist() for row in result.rows]

    def _first(self, unit: bytes, text: bytes, line: int) -> Input:
        if unit not in self.units:
            if len(self.units) >= readers.MOST_UNITS:
                self.units.clear()
            given, result = self.read(text.replace(POINT, self.mark))
            self.hear(remarks_of(result), range(line, line + 1))
            self.units[unit] = given
        return self.units[unit]


def remarks_of(result: LineAnswer) -> list[str]:
    """Return the assumptions and notes on the requested results, a line each."""
    return remarks(*said_of(result.answer, result.rows))


class Remark:
    """A remark on some of the lines so far."""

    def __init__(self, template: str, spans: list[Span], lines: Sequence[int]) -> None:
        self.template, self.spans = template, spans
        self.first_lines = [*lines[: FEW_LINES + 1]]
        self.last_line = lines[-1]
        self.is_unbroken = _are_unbroken(lines)
        self.is_shared = False  # by all lines
        self.shown_spans: list[Span] | None = None

    def widen(self, spans: list[Span], lines: Sequence[int]) -> None:
        touches = lines[0] - 1 <= self.last_line and self.first_lines[0] - 1 <= lines[-1]
        self.is_unbroken = self.is_unbroken and touches and _are_unbroken(lines)
        self.first_lines = sorted({*self.first_lines, *lines[: FEW_LINES + 1]})[: FEW_LINES + 1]
        self.last_line = max(self.last_line, lines[-1])
        pairs = zip(self.spans, spans, strict=True)
        self.spans = [old if old == new else _together(*old, *new) for old, new in pairs]

    @property
    def text(self) -> str:
        """Return the remark with its numbers, and with its lines if other lines lack it."""
        spans = iter(self.spans)
        text = re.sub(MARK, lambda _: " to ".join(dict.fromkeys(next(spans))), self.template)
        if self.is_shared:
            return text
        word, colon, rest = text.partition(": ")
        return f"{word}{colon}{self._where()}: {rest}"

    def _where(self) -> str:
        first, last = self.first_lines[0], self.last_line
        if first == last:
            return f"line {first}"
        if self.is_unbroken:
            return f"lines {first} to {last}"
        named = ", ".join(map(str, self.first_lines[:FEW_LINES]))
        others = f" and others up to {last}" if len(self.first_lines) > FEW_LINES else ""
        return f"lines {named}{others}"


def _are_unbroken(lines: Sequence[int]) -> bool:
    return lines[-1] - lines[0] + 1 == len(lines)


def _together(*numbers: str) -> Span:
    return min(numbers, key=_size), max(numbers, key=_size)


def _size(number: str) -> float:
    top, _, bottom = number.partition("/")
    return float(top) / float(bottom or 1)


class Remarks:
    """The remarks on the lines of a stream."""

    def __init__(self) -> None:
        self.remarks: dict[str, Remark] = {}  # by their templates
        self.shared: set[str] | None = None  # by all lines before any answer is written
        self.has_begun = False

    def hear(self, texts: Sequence[str], lines: Sequence[int]) -> None:
        templates = [SPAN.sub(MARK, text) for text in texts]
        if not self.has_begun:
            self.shared = {*templates} & ({*templates} if self.shared is None else self.shared)
        for template, text in zip(templates, texts, strict=True):
            spans = [(low, high or low) for low, high in SPAN.findall(text)]
            if template in self.remarks:
                self.remarks[template].widen(spans, lines)
            else:
                self.remarks[template] = Remark(template, spans, lines)

    def not_yet_said(self) -> list[str]:
        """Return the remarks not yet written, for output before the answers."""
        remarks = [item for item in self.remarks.values() if item.shown_spans is None]
        for remark in remarks:
            remark.is_shared = not self.has_begun and remark.template in (self.shared or ())
            remark.shown_spans = remark.spans
        self.has_begun = self.has_begun or self.shared is not None
        return [remark.text for remark in remarks]

    def changed(self) -> list[str]:
        """Return the remarks with numbers outside the range already written."""
        return [
            remark.text
            for remark in self.remarks.values()
            if remark.shown_spans not in (None, remark.spans)
        ]
