"""Samples of light logs: the lines of a file or a stream as times and values, in blocks.

The first lines show the layout of a log (`log_layout.py`).
"""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import compress, groupby, islice
from math import inf, isnan, nan
from operator import lt
from typing import Any, NamedTuple

from radcalc import errors
from radcalc.answer import Answer, format_number
from radcalc.calculators import dose as page
from radcalc.calculators.dose_sums import MEANS, POINTS, Dose
from radcalc.errors import LineError, RadcalcError, add, leave_out, listed, option, quote
from radcalc.files import Text, columns, where
from radcalc.files.columns import first_lines
from radcalc.floats import divide
from radcalc.inputs import Inputs
from radcalc.quantities import describe
from radcalc.quantities.column_titles import refuse_linked, unit_of_meter
from radcalc.streams.clocks import ZONE, Calendar, Clock, Undecided
from radcalc.streams.log_layout import MISSING, LogHead, LogSettings, blocks_of
from radcalc.terminal import ABORT, FAIL, IGNORE
from radcalc.units import Unit
from radcalc.units.numbers import parse_number
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve

FEW = 32  # lines read one by one
MARKED = re.compile(r"-(?:9{3,}|6999)(?:\.[09]*)?")  # loggers mark missing values so: -9999.9
THOUSANDS = re.compile(r"[-+]?\d{1,3}(?:,\d{3})+(?:\.\d*)?")
ANY = "*"  # of a column that chooses rows
BLANK = frozenset(MISSING)
MOST_OTHERS = 10  # texts that are listed
MOST_AHEAD = 16  # blocks, of 1 MiB, that are read to find the order of day and month

# Above the illuminance and the irradiance that the sun gives, in coherent units, also by clouds.
BRIGHTEST = {resolve(text).dimension: limit for text, limit in (("lx", 200e3), ("W/m2", 2000.0))}

Samples = tuple[list[Any], list[float], Sequence[int]]  # times in ticks, values, and lines


class Sample(NamedTuple):
    """A sample with its line, and its time as written."""

    time: Any
    value: float
    number: int
    stamp: str


class Missing(LineError):
    """A value that the user's mark says is missing: its line is skipped."""


class OtherSeries(LineError):
    """A row of another series: no line is skipped for that."""


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
        self.name, self.settings, self.say = name, settings, say
        self.notes: list[str] = []
        self.is_good = True
        self.left_out, self.first_left_out = 0, ""
        self.is_bright = False
        self.others: set[str] = set()  # texts of rows that are not chosen
        self.last: Any = None  # tick
        self.tick: Any = None  # of the line that is read, once it is known
        self.last_line = 0
        # Local times that occur twice wait for a later one; None for a skipped line.
        self.waiting: list[Sample | None] = []
        self.before: tuple[Any, int] = None, 0  # the last time before them, and its line
        self.text = Text(name, read, "a time and a value", inf, settings.first)
        blocks, of_sun = blocks_of(self.text)
        self.of_samples = of_sun.samples if of_sun else POINTS
        if of_sun:
            self.settings = settings = settings._replace(row="row", first=0, delimiter="\t")
            blocks = [(0, of_sun.lines)]
        self._blocks = iter(blocks)
        self._pending: list[tuple[int, list[str]]] = []
        lines = first_lines(self._blocks)
        head = LogHead(name, lines, settings, self._ahead())
        self.layout, self.assumptions = head.layout, head.assumptions
        if of_sun:
            self.assumptions.insert(0, of_sun.assumption)
        self._pending.insert(0, (head.begin, [text for k, text in lines if k >= head.begin]))
        self.dark = _dark(settings.dark, head.layout.unit) if settings.dark else 0.0
        self.least = min(-self.dark, of_sun.least if of_sun else 0.0)  # of noise below 0
        self.marks = {*map(_mark, settings.missing)}
        self.seen: dict[int, set[str]] = {place: set() for place in head.layout.series}

    def _ahead(self) -> Iterator[tuple[int, list[str]]]:
        """Yield the next blocks, which are kept for the samples."""
        for block in islice(self._blocks, MOST_AHEAD):
            self._pending.append(block)
            yield block

    @property
    def clock(self) -> Clock:
        return self.layout.clock

    def error(
        self, number: int, problem: str, hint: errors.Hint, kind: type[LineError] = LineError
    ) -> LineError:
        return kind(f"{where(self.name, number, self.settings.row)}: {problem}", hint)

    def samples(self) -> Iterator[Samples]:
        """Yield blocks of times, values and lines; a skipped line has no value."""
        for number, lines in self._pending:
            yield from self._of(lines, number)
        for number, lines in self._blocks:
            yield from self._of(lines, number)
        yield from _runs(self.waiting)
        if self.settings.where and self.last is None:
            wanted = listed([f"{name}={text}" for name, text in self.settings.where])
            others = listed(sorted(self.others)[:MOST_OTHERS])
            raise self.error(0, f"no row has {quote(wanted)}", f"one of its texts: {others}")
        self.layout.table.finish()
        if self.text.note:
            self.notes.append(self.text.note)
        if self.left_out:
            row = self.settings.row
            how_many = f"a {row} is" if self.left_out == 1 else f"{self.left_out} {row}s are"
            self.notes.append(f"{how_many} skipped; the first: {self.first_left_out}")
        self.assumptions += self.clock.assumptions

    def note_bright(self, peak: float, values: list[float], lines: Sequence[int]) -> None:
        """Note the first sample that is brighter than the sun makes it."""
        most = BRIGHTEST.get(self.layout.unit.dimension, inf) / float(self.layout.unit.factor)
        if peak <= most or self.is_bright:
            return
        self.is_bright = True
        k = next(k for k, value in enumerate(values) if value > most)
        unit = self.layout.unit.text
        limit = f"{format_number(most)} {unit}"
        mark = option("missing", f"{values[k]!r}")
        self.notes.append(
            f"{format_number(values[k])} {unit} in {self.settings.row} {lines[k]} is more than the "
            f"sun gives ({limit}); {mark}, if it marks a missing value"
        )

    def _of(self, lines: list[str], number: int) -> Iterator[Samples]:
        """Yield the samples of lines, all at once or in parts, down to single lines."""
        samples = self._at_once(lines, number)
        if samples:
            yield from [samples] if samples[0] else []
        elif len(lines) <= FEW:
            yield from self._one_by_one(lines, number)
        else:
            middle = len(lines) // 2
            yield from self._of(lines[:middle], number)
            yield from self._of(lines[middle:], number + middle)

    def _at_once(self, lines: list[str], number: int) -> Samples | None:
        """Return times and values of a block, None if one of its rows needs its own reading."""
        layout, table = self.layout, self.layout.table
        numbers: Sequence[int] = range(number, number + len(lines))
        try:
            cells = table.at_once(lines)
            for place, text in layout.where:
                if len(self.others) < MOST_OTHERS:
                    self.others |= {*cells[place][:MOST_OTHERS]}
                chosen = [text in (ANY, cell) for cell in cells[place]]
                cells = [[*compress(column, chosen)] for column in cells]
                numbers = [*compress(numbers, chosen)]
            if not numbers:
                return [], [], numbers
            values = self._values_of(cells, number)
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
        for place in layout.series:
            self.seen[place] = self._texts(place, cells[place])
        self.last, self.last_line = times[-1], numbers[-1]
        return times, values, numbers

    def _values_of(self, cells: list[list[str]], number: int) -> list[float]:
        """Return the values of many rows of one series and unit; raise ValueError for others."""
        layout = self.layout
        is_one = all(len(self._texts(place, cells[place])) < 2 for place in layout.series)
        if layout.units is not None:
            is_one = is_one and {*cells[layout.units]} == {layout.unit.text}
        values = columns.finite_numbers(layout.table.pointed(cells[layout.place], number))
        is_one = is_one and not self.settings.thousands  # 1.000 may be a thousand
        is_marked = bool(self.marks) and not self.marks.isdisjoint(values)
        if self.dark:
            values = [value - self.dark for value in values]
        if not is_one or is_marked or min(values) < self.least:
            raise ValueError
        return values

    def _one_by_one(self, lines: list[str], number: int) -> Iterator[Samples]:
        rows = [row for row in enumerate(lines, number) if not columns.is_remark(row[1])]
        yield from _runs(sample for row in rows for sample in self._of_line(*row))

    def _of_line(self, number: int, line: str) -> Iterator[Sample | None]:
        """Yield the sample of a line, after those that waited for its time.

        The value of a line that is skipped is NaN; None is yielded if it has no time, either.
        """
        self.tick = None
        try:
            cells = self.layout.table.cells(number, line)
            if not all(text in (ANY, cells[place]) for place, text in self.layout.where):
                if len(self.others) < MOST_OTHERS:
                    self.others |= {cells[place] for place, _ in self.layout.where}
                return
            try:
                sample = self._sample(cells, number)
            except Undecided:
                yield from self._leave_out_waiting()
                sample = self._sample(cells, number)
        except LineError as error:
            self._leave_out(error)
            is_later = self.tick is not None and (self.last is None or self.tick > self.last)
            yield from self._in_order([Sample(self.tick, nan, number, "") if is_later else None])
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
            if sample and sample.value == sample.value:
                why = self.clock.comes_twice(sample.stamp, sample.time)
                self._leave_out(self.error(sample.number, why.message, why.hint))
        self.last, self.last_line = self.before
        self.clock.last = self.last
        yield None

    def _leave_out(self, error: LineError) -> None:
        """Report the error of a line, or stop there."""
        is_missing = isinstance(error, Missing)
        if isinstance(error, OtherSeries) or (self.settings.invalid == ABORT and not is_missing):
            raise error
        self.first_left_out = self.first_left_out or error.message
        self.left_out += 1
        if not is_missing:
            self.is_good = self.is_good and self.settings.invalid != FAIL
            if self.settings.invalid != IGNORE:
                self.say(error)

    def _sample(self, cells: list[str], number: int) -> Sample:
        """Return the sample of one row; refuse a missing or malformed value with its line."""
        layout = self.layout
        for place in layout.series:
            self._check_series(place, cells[place], number)
        stamp = " ".join([cells[k] for k in layout.times])
        try:
            self.tick = time = layout.clock.one(stamp)
        except Undecided:
            raise
        except RadcalcError as error:
            raise self.error(number, error.message, error.hint) from None
        text = self._without_thousands(cells[layout.place], number)
        value = self._value(text, number)
        if layout.clock.has_numbers:
            layout.table.check_marks([stamp], number, are_values=False)
        layout.table.check_marks([text], number)
        if layout.units is not None:
            value *= self._factor(cells[layout.units], number)
        value -= self.dark
        if value < self.least:
            limit = "the noise of" if self.dark else "0 without"
            problem = f"light below {limit} {option('dark')}: '{quote(text)}'"
            raise self.error(number, problem, [add("missing", text), add("invalid", IGNORE)])
        return Sample(time, value, number, stamp)

    def _without_thousands(self, text: str, number: int) -> str:
        mark = self.settings.thousands
        if not mark or mark not in text:
            return text
        if not re.fullmatch(rf"[-+]?\d{{1,3}}(?:{re.escape(mark)}\d{{3}})+(?:[.,]\d*)?", text):
            problem = f"'{quote(text)}' has no groups of three digits"
            raise self.error(number, problem, leave_out("thousands"))
        return text.replace(mark, "")

    def _value(self, text: str, number: int) -> float:
        """Return the number of a cell; raise for one that is missing or malformed."""
        row = self.settings.row
        if text.lower() in MISSING or MARKED.fullmatch(text) or _mark(text) in self.marks:
            to_skip = errors.mention(f"{{invalid=ignore}}, to skip the {row}")
            kind = Missing if _mark(text) in self.marks else LineError
            raise self.error(number, f"a value is missing: '{quote(text)}'", to_skip, kind)
        value = columns.finite(text, True)
        if value is not None:
            return value
        try:
            parse_number(text)
        except errors.NumberError as error:
            hint: errors.Hint = add("thousands", ",") if THOUSANDS.fullmatch(text) else error.hint
            raise self.error(number, error.message, hint) from None
        raise self.error(number, f"'{quote(text)}' is not a number", "a number")

    def _texts(self, place: int, cells: Sequence[str]) -> set[str]:
        """Return the texts of a column so far, without blanks, and numbers but those of devices."""
        texts = {*cells} - BLANK - self.seen[place]
        if not self.layout.series[place]:
            texts = {text for text in texts if not columns.is_number(text)}
        return self.seen[place] | texts

    def _check_series(self, place: int, text: str, number: int) -> None:
        """Raise for a row of another series than those before."""
        seen = self._texts(place, [text])
        if len(seen) > 1:
            title = self.layout.table.names[place] if self.layout.table.names else str(place + 1)
            first, *_ = self.seen[place]
            problem = f"the column '{quote(title)}' has '{quote(first)}' and '{quote(text)}'"
            ways = [add("where", f"{title}={value}") for value in (first, text, ANY)]
            raise self.error(number, problem, ways, OtherSeries)
        self.seen[place] = seen

    def _factor(self, text: str, number: int) -> float:
        """Return the factor from the unit of a line to that of the log."""
        unit, own = unit_of_meter(text), self.layout.unit
        if unit is None or not _is_like(unit, own):
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


def _runs(samples: Iterable[Sample | None]) -> Iterator[Samples]:
    """Yield samples as lists of times, values and lines; a skipped line has no value."""
    for is_good, group in groupby(samples, lambda one: one is not None and not isnan(one.value)):
        run = [*group]
        for some in [run] if is_good else [[one] for one in run]:
            known = [one for one in some if one]
            values = [one.value for one in known if is_good]
            yield [one.time for one in known], values, [one.number for one in known]


def _mark(text: str) -> str | float:
    """Return a mark of missing values as a number, or as a text without case."""
    value = columns.finite(text, True)
    return text.lower() if value is None else value


def _is_like(first: Unit, second: Unit) -> bool:
    return (first.dimension, first.is_exitance) == (second.dimension, second.is_exitance)


def _dark(text: str, unit: Unit) -> float:
    """Return what a meter shows in the dark, in the unit of its values."""
    value = columns.finite(text, False)
    if value is not None:
        return value
    amount = read_amount(text)
    own = amount.typed[1]
    if own is None or not _is_like(own, unit):
        problem = f"{option('dark', quote(text))} is not in {quote(unit.text)}"
        raise errors.UsageError(problem, add("dark", f"0.1{unit.text}", "0.1 as an example"))
    return amount.number * divide(own.top * unit.bottom, own.bottom * unit.top)


EXPECTED = "a file with a time and a value in each line"


class LogDose:
    """The dose of the samples of a log, for any light that the inputs describe."""

    def __init__(self, log: Log, given: Inputs, by: str = "", reading: str = "") -> None:
        """Read all samples, without bridging a step longer than `max-gap` of the inputs.

        `by` is a period, or '' for the whole log; `reading` is what samples are, by default what
        the format of the log says, or points.
        """
        clock = log.clock
        longest = given["max-gap"].value if "max-gap" in given else inf  # s
        page.check_unit(log.layout.unit)
        if reading and log.of_samples not in (POINTS, reading):
            log.assumptions.append(f"{option('samples', reading)} replaces the format's own")
        top, bottom = clock.tick
        is_daily = not reading and _is_daily(log)
        if is_daily:
            reading, longest = MEANS, min(longest, page.DAY)
            log.assumptions.append("each value is the sum of its day, as its unit is per day")
        dose = Dose(
            longest * bottom / top,
            longest < inf and not is_daily,
            (lambda time: clock.period(time, by)) if by else None,
            reading or log.of_samples,
        )
        dose.usual = page.DAY * bottom // top if is_daily else 0
        for times, values, lines in log.samples():
            if values:
                dose.add(times, values)
                log.note_bright(dose.peak, values, lines)
            else:
                dose.interrupt(*times)
        dose.finish()
        self.log, self.by = log, by
        self.summed = page.SummedLog(dose, log.layout.unit, clock.tick, clock.say)
        self.summed.check()

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
        """Return the inputs for the light of the samples, without those for the times."""
        refuse_linked(self.log.layout.title, self.log.layout.unit, given)
        return {name: condition for name, condition in given.items() if name != "max-gap"}

    def _with_remarks(self, answer: Answer) -> Answer:
        log = self.log
        return answer._replace(
            assumptions=(*log.assumptions, *answer.assumptions), notes=[*answer.notes, *log.notes]
        )


def _is_daily(log: Log) -> bool:
    """Return whether a log has a rate per day for each day, and so the sums of days."""
    clock = log.clock
    is_per_day = ("day", -1) in log.layout.unit.atoms
    if not (is_per_day and isinstance(clock, Calendar) and clock.is_of_days):
        return False
    if clock.zone:
        problem = f"{option('time-zone')} does not apply to the sums of days"
        raise errors.UsageError(problem, leave_out("time-zone"))
    return True
