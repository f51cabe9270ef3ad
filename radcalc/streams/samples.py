"""Samples of light logs: the lines of a file or a stream as times and values, in blocks.

The first lines show the layout of a log (`log_layout.py`).
"""

import re
from collections.abc import Callable, Iterable, Iterator
from math import inf
from operator import lt
from typing import Any, NamedTuple

from radcalc.answer import Answer
from radcalc.calculators import dose as page
from radcalc.calculators.dose_sums import POINTS, Dose
from radcalc.errors import (
    LineError,
    MissingInput,
    NumberError,
    RadcalcError,
    UsageError,
    add,
    leave_out,
    mention,
    option,
    quote,
)
from radcalc.files import columns
from radcalc.files.text import Text
from radcalc.floats import divide
from radcalc.inputs.given import Inputs
from radcalc.quantities.column_titles import unit_of_meter
from radcalc.quantities.light import describe
from radcalc.quantities.symbols import LINKS
from radcalc.streams import log_layout
from radcalc.streams.clocks import ZONE, Calendar, Clock, Undecided
from radcalc.streams.log_layout import MISSING, Head, LogSettings, is_remark
from radcalc.terminal import ABORT, FAIL, IGNORE
from radcalc.units import horticulture
from radcalc.units.numbers import parse_number

FEW = 32  # lines read one by one
MARKED = re.compile(r"-(?:9{3,}|6999)(?:\.[09]*)?")  # loggers mark missing values so: -9999.9
LEAST = -999.0  # such marks are not greater

Samples = tuple[list[Any], list[float]]  # times in ticks, and values


class Sample(NamedTuple):
    """A sample with its line, and its time as written."""

    time: Any
    value: float
    number: int
    stamp: str


class Log:
    """A log, read a block at a time."""

    def __init__(
        self,
        name: str,
        read: Callable[[int], bytes],
        settings: LogSettings,
        say: Callable[[LineError], object],
    ) -> None:
        """Read the first lines; `say` reports skipped lines."""
        self.name = name
        self.settings = settings
        self.say = say
        self.notes: list[str] = []
        self.is_good = True
        self.left_out, self.first_left_out = 0, ""
        self.last: Any = None  # tick
        self.last_line = 0
        # Local times that occur twice wait for a later one; None for a skipped line.
        self.waiting: list[Sample | None] = []
        self.before: tuple[Any, int] = None, 0  # the last time before them, and its line
        self.text = Text(name, read, "a time and a value", inf, settings.first)
        blocks, of_sun = log_layout.blocks_of(self.text)
        self.of_samples = of_sun.samples if of_sun else POINTS
        if of_sun:
            self.settings = settings._replace(row="row", first=0, delimiter="\t")
            blocks = [(0, of_sun.lines)]
        self._blocks = iter(blocks)
        lines = log_layout.first_lines(self._blocks)
        head = Head(name, lines, self.settings)
        self.layout, self.assumptions = head.layout, head.assumptions
        if of_sun:
            self.assumptions.insert(0, of_sun.assumption)
        self._pending = [(head.begin, [text for k, text in lines if k >= head.begin])]

    @property
    def clock(self) -> Clock:
        return self.layout.clock

    def error(self, number: int, problem: str, hint: str) -> LineError:
        return log_layout.error(self.name, number, problem, hint, self.settings.row)

    def samples(self) -> Iterator[Samples | None]:
        """Yield blocks of times and values; None for a skipped line."""
        for number, lines in self._pending:
            yield from self._of(lines, number)
        for number, lines in self._blocks:
            yield from self._of(lines, number)
        yield from _runs(self.waiting)
        self.layout.table.finish()
        if self.text.note:
            self.notes.append(self.text.note)
        if self.left_out:
            row = self.settings.row
            how_many = f"a {row} is" if self.left_out == 1 else f"{self.left_out} {row}s are"
            self.notes.append(f"{how_many} skipped; the first: {self.first_left_out}")
        self.assumptions += self.clock.assumptions

    def _of(self, lines: list[str], number: int) -> Iterator[Samples | None]:
        """Yield the samples of lines, all at once or in parts, down to single lines."""
        samples = self._at_once(lines, number)
        if samples:
            yield samples
        elif len(lines) <= FEW:
            yield from self._one_by_one(lines, number)
        else:
            middle = len(lines) // 2
            yield from self._of(lines[:middle], number)
            yield from self._of(lines[middle:], number + middle)

    def _at_once(self, lines: list[str], number: int) -> Samples | None:
        """Return times and values of a block, None if one of its rows needs its own reading."""
        layout, table = self.layout, self.layout.table
        try:
            cells = table.at_once(lines)
            if layout.units is not None and {*cells[layout.units]} != {layout.unit.text}:
                return None
            values = columns.finite_numbers(table.pointed(cells[layout.place], number))
            if min(values) <= LEAST:
                return None
            stamps = cells[layout.times[0]]
            if layout.clock.has_numbers:
                stamps = table.pointed(stamps, number, are_values=False)
            elif layout.times[1:]:
                stamps = list(map(" ".join, zip(*[cells[k] for k in layout.times], strict=True)))
            times: list[Any] = list(layout.clock.many(stamps))
        except (ValueError, TypeError, RadcalcError):
            return None
        if not all(map(lt, times, times[1:])) or (self.last is not None and times[0] <= self.last):
            return None
        self.last, self.last_line = times[-1], number + len(lines) - 1
        return times, values

    def _one_by_one(self, lines: list[str], number: int) -> Iterator[Samples | None]:
        rows = [row for row in enumerate(lines, number) if not is_remark(row[1])]
        yield from _runs(sample for row in rows for sample in self._of_line(*row))

    def _of_line(self, number: int, line: str) -> Iterator[Sample | None]:
        """Yield the sample of a line, after those that waited for its time."""
        try:
            try:
                sample = self._sample(line, number)
            except Undecided:
                yield from self._leave_out_waiting()
                sample = self._sample(line, number)
        except LineError as error:
            self._leave_out(error)
            yield from self._in_order([None])
            return
        try:
            self._check_order(sample.time, number)
        except LineError as error:
            self._leave_out(error)
            return
        if self.clock.doubtful and not any(self.waiting):
            self.before = self.last, self.last_line
        self.last, self.last_line = sample.time, number
        yield from self._in_order([sample])

    def _in_order(self, samples: list[Sample | None]) -> list[Sample | None]:
        """Return the samples with known times; some may have waited for a later one."""
        self.waiting += samples
        if self.clock.doubtful:
            return []
        samples, self.waiting = self.waiting, []
        return samples

    def _leave_out_waiting(self) -> Iterator[None]:
        """Skip the samples whose time occurs twice, unresolved by the order."""
        assert isinstance(self.clock, Calendar)
        waiting, self.waiting = self.waiting, []
        self.clock.doubtful = ""
        for sample in waiting:
            if sample:
                why = self.clock.comes_twice(sample.stamp, sample.time)
                self._leave_out(self.error(sample.number, why.message, why.hint))
        self.last, self.last_line = self.before
        self.clock.last = self.last
        yield None

    def _leave_out(self, error: LineError) -> None:
        """Report the error of a line, or stop there."""
        if self.settings.invalid == ABORT:
            raise error
        self.first_left_out = self.first_left_out or error.message
        self.left_out += 1
        self.is_good = self.is_good and self.settings.invalid != FAIL
        if self.settings.invalid != IGNORE:
            self.say(error)

    def _sample(self, line: str, number: int) -> Sample:
        """Return the sample of one row; refuse a missing or malformed value with its line."""
        layout = self.layout
        cells = layout.table.cells(number, line)
        stamp = " ".join([cells[k] for k in layout.times])
        try:
            time = layout.clock.one(stamp)
        except Undecided:
            raise
        except RadcalcError as error:
            raise self.error(number, error.message, error.hint) from None
        text = cells[layout.place]
        if text.lower() in MISSING or MARKED.fullmatch(text):
            hint = mention(f"{{invalid=ignore}}, to skip the {self.settings.row}")
            raise self.error(number, f"a value is missing: '{quote(text)}'", hint)
        value = columns.finite(text, True)
        if value is None:
            try:
                parse_number(text)
            except NumberError as error:
                raise self.error(number, error.message, error.hint) from None
            raise self.error(number, f"'{quote(text)}' is not a number", "a number")
        if layout.clock.has_numbers:
            layout.table.check_marks([stamp], number, are_values=False)
        layout.table.check_marks([text], number)
        if layout.units is not None:
            value *= self._factor(cells[layout.units], number)
        return Sample(time, value, number, stamp)

    def _factor(self, text: str, number: int) -> float:
        """Return the factor from the unit of a line to that of the log."""
        unit, own = unit_of_meter(text), self.layout.unit
        if unit is None or (unit.dimension, unit.is_exitance) != (own.dimension, own.is_exitance):
            problem = f"the unit '{quote(text)}' is not one of {describe(own)}"
            raise self.error(number, problem, f"{own.text}, or another column")
        return divide(unit.top * own.bottom, unit.bottom * own.top)

    def _check_order(self, time: Any, number: int) -> None:
        if self.last is None or time > self.last:
            return
        say, row = self.clock.say, self.settings.row
        if time == self.last:
            problem = f"the time {say(time)} is already in {row} {self.last_line}"
            raise self.error(number, problem, "each time once")
        problem = f"{say(time)} is before {say(self.last)} in {row} {self.last_line}"
        hint = f"{row}s in the order of their times"
        if isinstance(self.clock, Calendar) and not self.clock.has_offset:
            hint += f"; if clocks were put back, {ZONE}"
        raise self.error(number, problem, hint)


def _runs(samples: Iterable[Sample | None]) -> Iterator[Samples | None]:
    """Yield samples as lists of times and values, and None for a skipped line."""
    times: list[Any] = []
    values: list[float] = []
    for sample in samples:
        if sample is None:
            if times:
                yield times, values
                times, values = [], []
            yield None
        else:
            times.append(sample.time)
            values.append(sample.value)
    if times:
        yield times, values


EXPECTED = "a file with a time and a value in each line"


class LogDose:
    """The dose of the samples of a log, for any light that the inputs describe."""

    def __init__(self, log: Log, longest: float, by: str = "", reading: str = "") -> None:
        """Read all samples, without bridging a step longer than `longest` seconds.

        `by` is a period, or '' for the whole log; `reading` is what samples are, by default what
        the format of the log says, or points.
        """
        clock = log.clock
        page.check_unit(log.layout.unit)
        if reading and log.of_samples not in (POINTS, reading):
            log.assumptions.append(f"{option('samples', reading)} replaces the format's own")
        top, bottom = clock.tick
        dose = Dose(
            longest * bottom / top,
            longest < inf,
            (lambda time: clock.period(time, by)) if by else None,
            reading or log.of_samples,
        )
        for samples in log.samples():
            if samples:
                dose.add(*samples)
            else:
                dose.interrupt()
        dose.finish()
        self.log = log
        self.by = by
        self.summed = page.SummedLog(dose, log.layout.unit, clock.tick, clock.say)
        self.summed.check()

    @property
    def samples(self) -> dict[str, float]:
        """The facts of the log for the check of an answer."""
        return self.summed.samples()

    @property
    def is_of_several(self) -> bool:
        """Whether there are several periods."""
        return bool(self.by) and len(self.summed.dose.periods) > 1

    def answer(self, given: Inputs) -> Answer:
        """Return the answer for the whole log, or for its first period."""
        if self.by:
            return next(self.periods(given))[1]
        return self._with_remarks(self.summed.of_all(self._light(given)))

    def periods(self, given: Inputs) -> Iterator[tuple[str, Answer]]:
        """Yield the name of each period and its answer."""
        for label, answer in self.summed.of_periods(self._light(given)):
            yield label, self._with_remarks(answer)

    def _light(self, given: Inputs) -> Inputs:
        """Return the inputs for the light of the samples, without those for the times.

        A spectrum of PAR needs its range: the watts are those from 400 nm to 700 nm.
        """
        if self.log.layout.is_par and "spectrum" in given and "range" not in given:
            problem = "the values are PAR in watts, which are counted from 400 nm to 700 nm"
            raise MissingInput(problem, add("range", horticulture.PAR_RANGE))
        if (band := self.log.layout.band) and (links := [name for name in LINKS if name in given]):
            problem = f"the values are of another light by their title ({band})"
            problem = f"{problem}, which {option(links[0])} does not convert"
            raise UsageError(problem, leave_out(links[0]))
        return {name: condition for name, condition in given.items() if name != "max-gap"}

    def _with_remarks(self, answer: Answer) -> Answer:
        log = self.log
        return answer._replace(
            assumptions=(*log.assumptions, *answer.assumptions), notes=[*answer.notes, *log.notes]
        )


def longest_step(given: Inputs) -> float:
    """Return the longest step that is bridged [s]."""
    return given["max-gap"].value if "max-gap" in given else inf
