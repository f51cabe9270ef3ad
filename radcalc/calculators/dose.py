"""Exposure or energy of samples of light over time.

Samples are points, with straight lines between them, or means over the steps that they begin.
A step that is longer than `max-gap`, or that lacks a sample, is a gap: it adds nothing, and a note
reports it.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator
from math import ceil, floor, fsum, inf, log10
from operator import add, mul, sub
from typing import Any, NamedTuple

from radcalc.answer import Answer, Value
from radcalc.calculators.page import FILE, PERIODS, Operand, Page, choice, text
from radcalc.calculators.results import absent, value
from radcalc.calculators.solved import solve
from radcalc.calculators.worksheet import Placed, worksheet
from radcalc.derivation import Formula, coherent_unit_of, format_number, format_value, letter_of
from radcalc.errors import ConditionError, NumberError, TooMany, Try, mention, option, quote
from radcalc.files.text import ENDINGS
from radcalc.floats import divide
from radcalc.inputs.given import Inputs
from radcalc.laws.law import law
from radcalc.quantities.light import PHOTON, describe, light_dimension
from radcalc.quantities.light import read as read_light
from radcalc.quantities.symbols import LINKS, REFINEMENTS
from radcalc.terminal import ABORT, INVALID
from radcalc.units.table import resolve
from radcalc.units.unit import Unit

FLUX, IRRADIANCE = (0, 0, 0), (0, 1, 0)  # geometries that have a dose
PPFD = light_dimension(PHOTON, IRRADIANCE, "")
DAY = 86400  # s
WHOLE = (3600, DAY)  # seconds of an hour, and of a day without a clock change
NOISE = 0.05  # of the peak: smaller negative readings are a meter's offset
POINTS, MEANS_OF_STEPS = "points", "means"  # what samples are
READINGS = {
    POINTS: "values between samples are interpolated linearly (trapezoidal rule)",
    MEANS_OF_STEPS: "each sample is the mean from its time to that of the next; the last one, or "
    "one before a gap, lasts as long as the step before it",
}
SHORT = 3600  # s: a log that is shown in seconds, and not in hours
LONG = 10  # times the mean of the others: longer steps are noted
HOLE, WITHIN = 1.8, 1.5  # times the usual step: longer ones lack samples; as long or as short ones
REGULAR = 2 / 3  # share of steps that are as long as the usual one
ENOUGH = 100  # steps that show the usual one
MOST = 100_000  # periods: 11 years of hours
SLACK = 1e-9  # of a number of units
ROUNDED = 1e-3  # of a gap's limit: times in a log are rounded, as 600.05 s for 10 min in days

MEAN = {
    IRRADIANCE: law("mean irradiance", "{exposure} = {mean-irradiance} {covered-time}"),
    FLUX: law("mean flux", "{energy} = {mean-flux} {covered-time}"),
}
RECEIVED = law("received energy", "{energy} = {exposure} {receiver-area}", "ISO 80000-7")
SUM_OF_MEANS = {
    IRRADIANCE: Formula("exposure of means", "{exposure} = sum of E_i (t_i+1 - t_i)"),
    FLUX: Formula("energy of means", "{energy} = sum of Phi_i (t_i+1 - t_i)"),
}
SUM = {
    IRRADIANCE: Formula("exposure of samples", "{exposure} = sum of (E_i + E_i+1)/2 (t_i+1 - t_i)"),
    FLUX: Formula("energy of samples", "{energy} = sum of (Phi_i + Phi_i+1)/2 (t_i+1 - t_i)"),
}
OF = {IRRADIANCE: ("exposure", "maximum-irradiance"),
      FLUX: ("energy", "maximum-flux")}  # fmt: skip
MEANS, PEAKS = ("mean-irradiance", "mean-flux"), ("maximum-irradiance", "maximum-flux")
OF_SAMPLES = (*MEANS, *PEAKS)
# Problem and hint for a period without samples.
EMPTY = "no time is covered", mention("a longer {max-gap}, or all results (it is empty there)")
PAGE = Page(
    "a dose",
    ("receiver-area",),
    ("exposure", "energy", *MEANS, *PEAKS),
    about="Add up samples of light over time: exposure, energy, daily light integral.",
    operand=Operand("file", "FILE|-", FILE, ENDINGS),
    sections={
        "Columns": (
            text("column", "NAME", "Column with the values: its title or its number."),
            text("unit", "lx", "Unit of the values, if their title has none: lx, W/m2 ..."),
            text(
                "time-column",
                "NAME",
                "Column with the times: its title or its number (repeatable: date and time of "
                "day).",
                repeats=True,
            ),
            text("d delimiter", "X", "Field separator: one character, or tab (default: detected)."),
            choice(
                "invalid",
                INVALID,
                "Treatment of unreadable lines.  abort (default): stop at the first.  fail, warn, "
                "ignore: skip them, and fail at the end (status 2), warn (status 0) or say "
                "nothing (status 0).",
                default=ABORT,
            ),
        ),
        "Times": (
            text(
                "time-zone",
                "ZONE",
                "Time zone of local times and of days: Europe/Prague, +02:00, UTC.",
            ),
            text(
                "time-format",
                "FORMAT",
                "Format of dates and times, as in strptime: %d/%m/%Y %H:%M.",
            ),
            text(
                "time-unit",
                "s",
                "Unit of the times, if they are numbers that count from the start of the "
                "measurement.",
            ),
            choice(
                "samples",
                READINGS,
                "Samples at points in time, with straight lines between them (the default), or "
                "means from each time to the next.",
                default=POINTS,
            ),
            "max-gap",
            choice("by", PERIODS, "Give an answer for each local day or hour."),
        ),
        "Light": ("receiver-area", *LINKS, *REFINEMENTS),
    },
    takes_lines=False,
)
# Customary units of an exposure or an energy, by the coherent unit.
CUSTOMARY_UNITS = {
    "lx s": "lx h", "J/m2": "Wh/m2", "umol/m2": "mol/m2", "umol": "mol", "lm s": "lm h", "J": "Wh",
}  # fmt: skip

Spans = Callable[[float], tuple[float, float, str]]  # a time's period: start, end and name


def check_unit(unit: Unit) -> None:
    """Refuse samples whose integral over time is neither an exposure nor an energy."""
    reading = read_light(unit)
    if reading and not reading.axis and not reading.retinal:
        if reading.geometry in OF and not unit.is_scale:
            return
        if reading.time:
            problem = f"{describe(unit)} is already integrated over time"
            if reading.is_count:
                remark = f"if '{quote(unit.text)}' is short for it, as loggers write"
                meant = Try((("unit", "umol/m2/s"),), remark=remark)
                raise ConditionError(problem, meant)
            raise ConditionError(problem, "samples of an irradiance, illuminance, PPFD or flux")
    raise ConditionError(
        f"the integral of {describe(unit)} over time is neither an exposure nor an energy",
        "samples of an irradiance, illuminance, PPFD or flux: W/m2, lx, umol/m2/s, W, lm",
    )


class SampleStep(NamedTuple):
    """The length of the step from one sample to the next, and its ends [ticks]."""

    length: float
    start: float
    end: float


NO_STEP = SampleStep(0, 0, 0)


class Steps:
    """The number of bridged steps [ticks] that are as long as the usual one, or longer.

    The usual step is the median of the first steps.
    """

    def __init__(self) -> None:
        self.usual = 0.0
        self.count = self.alike = self.longer = 0
        self._first: list[Any] = []

    @property
    def has_holes(self) -> bool:
        """Return whether the steps are regular but for some longer ones."""
        return bool(self.longer) and self.alike >= REGULAR * self.count

    def take(self, steps: list[Any], longest: Any) -> None:
        if self.usual:
            self._count(steps, longest)
            return
        self._first += steps
        if len(self._first) >= ENOUGH:
            self.settle()

    def settle(self) -> None:
        """Find the usual step among those that were taken."""
        if not self.usual and self._first:
            self.usual = sorted(self._first)[(len(self._first) - 1) // 2]
            self._count(self._first, max(self._first))
            self._first = []

    def _count(self, steps: list[Any], longest: Any) -> None:
        self.count += len(steps)
        least, most = self.usual / WITHIN, self.usual * WITHIN
        if longest <= most and min(steps) >= least:  # the usual case
            self.alike += len(steps)
            return
        ordered = sorted(steps)
        self.alike += bisect_right(ordered, most) - bisect_left(ordered, least)
        self.longer += len(ordered) - bisect_right(ordered, self.usual * HOLE)


class Period:
    """The sums over the samples of a period, in their unit and in ticks.

    The sum is kept in two floats, so that ten million terms lose no digits.
    """

    __slots__ = (
        "count",
        "covered",
        "end",
        "is_in_gap",
        "label",
        "low",
        "peak",
        "start",
        "total",
        "when",
    )

    def __init__(self, start: float, end: float, label: str = "") -> None:
        self.start, self.end, self.label = start, end, label
        self.total = self.low = 0.0
        self.covered: float = 0
        self.count = 0
        self.is_in_gap = False  # also for a single sample between two gaps
        self.peak, self.when = -inf, start

    def take(
        self, times: list[Any], values: list[float], steps: list[Any], of_means: bool = False
    ) -> None:
        highest = max(values)
        if highest > self.peak:
            self.peak, self.when = highest, times[values.index(highest)]
        self.covered += times[-1] - times[0]
        part = _sum(values, values if of_means else values[1:], steps)
        total = self.total + part  # Neumaier's sum
        if abs(self.total) >= abs(part):
            self.low += (self.total - total) + part
        else:
            self.low += (part - total) + self.total
        self.total = total


class Dose:
    """Samples added up over the whole log or by period."""

    def __init__(
        self,
        longest: float = inf,
        bridges: bool = False,
        spans: Spans | None = None,
        of_means: bool = False,
    ) -> None:
        """Take the longest step to bridge [ticks], and the periods.

        With `bridges`, a missing sample does not make a gap by itself; with `of_means`, a sample is
        the mean from its time to that of the next one.
        """
        self.of_means = of_means
        self.usual = 0.0  # the last bridged step
        self.longest = longest * (1 + ROUNDED)
        self.bridges = bridges
        self.spans = spans
        self.periods: list[Period] = []
        self.first: Any = None  # tick
        self.time: Any = None  # of the last sample
        self.value = 0.0
        self.is_broken = False
        self.count = 0
        self.plain, self.first_value = 0.0, 0.0  # the sum of the samples, without their times
        self.peak, self.peak_at = -inf, 0.0
        self.gaps, self.gap_time, self.widest = 0, 0.0, NO_STEP
        self.step = NO_STEP  # the longest bridged step
        self.steps = Steps()
        self.negative, self.below, self.least, self.least_at = 0, 0.0, 0.0, 0.0

    def interrupt(self) -> None:
        self.is_broken = not self.bridges

    def add(self, times: list[Any], values: list[float]) -> None:
        """Add samples in order of time: sum up each run, and count the gaps between runs."""
        self._watch(times, values)
        counted = 0  # of the run, before
        if self.first is None:
            self.first, self.first_value = times[0], values[0]
        elif self.is_broken or times[0] - self.time > self.longest:
            self._gap(self.time, times[0], self.value)
        else:
            times, values, counted = [self.time, *times], [self.value, *values], 1
        self.time, self.value, self.is_broken = times[-1], values[-1], False
        steps = list(map(sub, times[1:], times))
        start = 0
        if self.longest < inf and steps and max(steps) > self.longest:
            for k, step in enumerate(steps, 1):
                if step > self.longest:
                    self._run(times[start:k], values[start:k], steps[start : k - 1], counted)
                    self._gap(times[k - 1], times[k], values[k - 1])
                    start, counted = k, 0
        self._run(times[start:], values[start:], steps[start:], counted)

    def _watch(self, times: list[Any], values: list[float]) -> None:
        self.count += len(times)
        self.plain += sum(values)
        high, low = max(values), min(values)
        if high > self.peak:
            self.peak, self.peak_at = high, times[values.index(high)]
        if low < 0:
            self.negative += sum(value < 0 for value in values)
            if low < self.least:
                self.least, self.least_at = low, times[values.index(low)]

    def finish(self) -> None:
        """End the last mean, and the search for the usual step."""
        self.steps.settle()
        if self.of_means and self.usual:
            self.time = self._hold(self.value, self.time, self.time + self.usual)

    def _hold(self, value: float, start: Any, end: Any) -> Any:
        """Add a value that lasts from one time to another; return the latter."""
        while start < end:
            period = self._period(start)
            stop = min(end, period.end)
            period.take([start, stop], [value, value], [stop - start])
            start = stop
        return start

    def _gap(self, start: Any, end: Any, value: float) -> None:
        if self.of_means:
            start = self._hold(value, start, min(start + self.usual, end))
        self.gaps += 1
        self.gap_time += end - start
        self.widest = max(self.widest, SampleStep(end - start, start, end))
        while self.spans:
            period = self.periods[-1]
            period.is_in_gap |= not period.covered
            if period.end >= end:
                break
            self._period(period.end)

    def _run(self, times: list[Any], values: list[float], steps: list[Any], counted: int) -> None:
        """Add samples without gaps, split at the ends of periods."""
        if steps:
            self.usual = steps[-1]
            longest = max(steps)
            self.steps.take(steps, longest)
            if longest > self.step.length:
                at = steps.index(longest)
                self.step = SampleStep(longest, times[at], times[at + 1])
            if min(values) < 0:
                ends = values if self.of_means else values[1:]
                self.below += fsum(map(_area_below, values, ends, steps))
        elif not counted:
            self._period(times[0]).is_in_gap = True
        while True:
            period = self._period(times[0])
            end = period.end
            cut = bisect_left(times, end)
            period.count += cut - counted
            if cut == len(times):
                period.take(times, values, steps, self.of_means)
                return
            step_to_end = end - times[cut - 1]
            value = values[cut]
            if self.of_means:
                value = values[cut - 1]
            elif times[cut] != end:  # on the straight line between two samples
                value = values[cut - 1] + (value - values[cut - 1]) * (step_to_end / steps[cut - 1])
            period.take(
                [*times[:cut], end],
                [*values[:cut], value],
                [*steps[: cut - 1], step_to_end],
                self.of_means,
            )
            counted = int(times[cut] != end)
            if counted:
                times, values = [end, *times[cut:]], [value, *values[cut:]]
                steps = [times[1] - end, *steps[cut:]]
            else:
                times, values, steps = times[cut:], values[cut:], steps[cut:]

    def _period(self, time: Any) -> Period:
        last = self.periods[-1] if self.periods else None
        if last and last.start <= time < last.end:
            return last
        start, end, label = self.spans(time) if self.spans else (time, inf, "")
        if last and start < last.end:
            start = last.end
        if len(self.periods) >= MOST:
            raise TooMany(
                f"there are more than {MOST} days or hours, up to {label}",
                mention("{by=day}; a time that is far from the others may be wrong"),
            )
        self.periods.append(Period(start, end, label))
        return self.periods[-1]


class SummedLog(NamedTuple):
    """A summed log: the unit of its samples, a tick as a ratio of seconds, a format of times."""

    dose: Dose
    unit: Unit
    tick: tuple[int, int]
    say: Callable[[float], str]

    def seconds(self, ticks: float) -> float:
        return _exact(ticks, self.tick)

    @property
    def duration(self) -> float:
        return self.seconds(self.dose.time - self.dose.first)

    @property
    def is_longer_than_a_day(self) -> bool:
        return self.duration > DAY * (1 + SLACK)

    def check(self) -> None:
        """Refuse a log with too few samples, without covered time, or with negative light."""
        dose, unit = self.dose, self.unit.text
        if dose.count < 2:
            problem = "one sample is not enough" if dose.count else "there is no sample"
            raise ConditionError(problem, "two samples or more")
        if not any(period.covered for period in dose.periods):
            longest = _duration_text(self.seconds(dose.widest.length))
            raise ConditionError(
                "every step is a gap, so there is nothing to add up",
                f"{option('max-gap', longest)}, which bridges all of them",
            )
        if dose.least < -NOISE * dose.peak:
            raise ConditionError(
                f"a sample of {format_number(dose.least)} {unit} at {self.say(dose.least_at)} is "
                f"too far below 0 for a meter's offset (the peak is {format_number(dose.peak)})",
                "a column of light, without marks such as -99 for missing values",
            )

    def refuse_dli(self, by: str, is_check: bool) -> None:
        """Refuse a DLI, which is the sum of one day, of each hour or of more than a day."""
        if by or self.is_longer_than_a_day:
            of = f"an {by}" if by else _duration(self.duration)
            by_day = Try((("by", "day"), *((("get", "DLI"),) * is_check)), ("check",) * is_check)
            raise ConditionError(f"a DLI is the sum of one day, not of {of}", by_day)

    def remarks(self) -> list[str]:
        """Return notes on the greatest sample, gaps, bridged steps and negative samples."""
        dose, unit = self.dose, self.unit.text
        notes = [
            f"the greatest sample, {format_number(dose.peak)} {unit}, is at "
            f"{self.say(dose.peak_at)}"
        ]
        if dose.gaps:
            longest = self._describe(dose.widest)
            gap_text = f"a gap of {longest}"
            if dose.gaps > 1:
                gap_time = _duration(self.seconds(dose.gap_time))
                gap_text = f"{dose.gaps} gaps of {gap_time} in all; the longest, {longest}"
            notes.append(f"not bridged: {gap_text}")
        if bridged := self._on_bridged():
            notes.append(f"{'one mean' if dose.of_means else 'interpolated linearly'}: {bridged}")
        if dose.negative:
            below = format_number(_exact(dose.below, self.tick))
            count = "a sample" if dose.negative == 1 else f"{dose.negative} samples"
            notes.append(
                f"kept as a meter's offset: {count} below 0, down to {format_number(dose.least)} "
                f"{unit}, together {below} {unit} s"
            )
        return notes

    def _on_bridged(self) -> str:
        """Return a remark on steps that lack samples, or on one that is much longer than others."""
        dose = self.dose
        longest = self._describe(dose.step)
        if dose.steps.has_holes:
            usual, count = self.seconds(dose.steps.usual), dose.steps.longer
            which = f"a step of {longest}"
            if count > 1:
                which = f"{count} long steps; the longest, {longest}"
            cut = option("max-gap", _duration_text(WITHIN * usual))
            them = "it" if count == 1 else "them"
            return f"{which}; the usual step has {_duration(usual)} ({cut} would leave {them} out)"
        others = dose.count - dose.gaps - 2
        if others <= 0:
            return ""
        mean = (dose.time - dose.first - dose.gap_time - dose.step.length) / others
        if dose.step.length <= LONG * mean:
            return ""
        mean = self.seconds(mean)
        between = option(
            "max-gap", _duration_text(mean**0.5 * self.seconds(dose.step.length) ** 0.5)
        )
        return (
            f"a step of {longest}; the others have {_duration(mean)} on average "
            f"({between} would leave it out)"
        )

    def _describe(self, step: SampleStep) -> str:
        length = _duration(self.seconds(step.length))
        return f"{length}, from {self.say(step.start)} to {self.say(step.end)}"

    def samples(self) -> dict[str, float]:
        """Return the first sample, the last, and the plain sum of all [SI]."""
        dose, factor = self.dose, self.unit.factor
        numbers = {"first": dose.first_value, "last": dose.value, "sum": dose.plain}
        return {name: number * factor for name, number in numbers.items()}

    def of_all(self, given: Inputs) -> Answer:
        """Return the answer for the whole log, with its gaps and the remarks on it."""
        dose = self.dose
        period = dose.periods[0]
        period.end = dose.time
        answer = self._answer(period, given)
        units = _times_in(self.seconds(period.end - period.start))
        gaps = [
            value("gaps", float(dose.gaps)),
            value("gap-time", self.seconds(dose.gap_time), *units),
            value("longest-gap", self.seconds(dose.widest.length), *units),
        ]
        notes = [*answer.notes, *self.remarks()]
        if self.unit.dimension == PPFD and self.is_longer_than_a_day:
            by_day = option("by", "day")
            notes.append(f"the exposure is of {_duration(self.duration)} ({by_day} for each day's)")
        return answer._replace(values=[*answer.values, *gaps], notes=notes)

    def of_periods(self, given: Inputs) -> Iterator[tuple[str, Answer]]:
        """Yield the dose of each day or hour, with its name; the first has the notes on all."""
        notes = self.remarks()
        for period in self.dose.periods:
            if period.covered or period.is_in_gap:
                answer = self._answer(period, given)
                seconds = self.seconds(period.end - period.start)
                covered, length = _duration(self.seconds(period.covered)), _duration(seconds)
                if period.count and not period.covered:
                    notes = [f"{period.label}: no time is covered", *notes]
                elif period.covered and covered != length:
                    notes = [f"{period.label}: {covered} of {length} are covered", *notes]
                if seconds not in WHOLE:
                    beginning = f"{period.label} has {length}: the clocks change, and"
                    notes = [
                        f"{beginning} time-of-maximum is the time since its start",
                        *notes,
                    ]
                yield period.label, answer._replace(notes=[*answer.notes, *notes])
                notes = []

    def _answer(self, period: Period, given: Inputs) -> Answer:
        """Return the answer for a period: its sum, mean, maximum, times and coverage."""
        reading = read_light(self.unit)
        assert reading is not None
        geometry = reading.geometry
        amount, peak = OF[geometry]
        factor = self.unit.top, self.unit.bottom
        total, covered = period.total + period.low, self.seconds(period.covered)
        sheet, placed = worksheet(PAGE, given, preferred=reading.kind), Placed()
        size = _exact(total, self.tick, factor)
        placed.add(amount, size)
        placed.add("covered-time", covered)
        if period.peak > -inf:
            placed.add(peak, _exact(period.peak, factor))
        unit = coherent_unit_of(amount, reading.kind)
        sum_text = f"{format_value(size, unit)}, of {period.count} samples"
        formulas, reading_of = (
            (SUM_OF_MEANS, MEANS_OF_STEPS) if self.dose.of_means else (SUM, POINTS)
        )
        placed.steps.append(formulas[geometry].with_numbers(f"{letter_of(amount)} = {sum_text}"))
        placed.assume(READINGS[reading_of])
        laws = [MEAN[geometry], RECEIVED] if covered else [RECEIVED]
        answer = solve(sheet, laws, placed).answer()
        duration = self.seconds(period.end - period.start)
        units = _times_in(duration)
        times = [
            value("time-of-maximum", self.seconds(period.when - period.start), *units)
            if period.peak > -inf
            else absent("time-of-maximum", *EMPTY),
            value("duration", duration, *units),
            value("covered-time", covered, *units),
            value("coverage", covered / duration, label="covered share of the time"),
            value("samples", float(period.count)),
        ]
        lacking = () if covered else MEANS if period.count else (*MEANS, *PEAKS)
        results = [
            absent(row.name, *EMPTY)._replace(also=row.also)
            if row.name in lacking
            else self._in_own_unit(row)
            if row.name in OF_SAMPLES
            else _customary(row, duration)
            for row in answer.values
        ]
        return answer._replace(values=[*results, *times])

    def _in_own_unit(self, result: Value) -> Value:
        """Return a result of the samples in the unit of the log too, as in mW."""
        is_own = self.unit.dimension in result.dimensions and result.given is None
        if not is_own or self.unit.factor == resolve(result.units[0]).factor:
            return result
        return result._replace(units=(self.unit.text,))


def _sum(starts: list[float], ends: list[float], steps: list[Any]) -> float:
    try:
        return fsum(map(mul, map(add, ends, starts), steps)) / 2
    except (OverflowError, ValueError):  # too large for a float, or infinities of both signs
        return inf


def _area_below(first: float, second: float, step: float) -> float:
    """Return the area below 0 under a straight line."""
    low, high = min(first, second), max(first, second)
    if low >= 0:
        return 0.0
    return (low + high) / 2 * step if high <= 0 else low * (low / (low - high)) / 2 * step


def _times_in(duration: float) -> tuple[str, ...]:
    """Return the unit of the times of a log or a period, if it is not that of their symbols."""
    return ("s",) if duration < SHORT else ()


def _customary(result: Value, duration: float) -> Value:
    if duration < SHORT:
        return result
    also = CUSTOMARY_UNITS.get(result.units[0]) if result.units else None
    return result._replace(units=(also, *result.units)) if also else result


def _exact(number: float, *ratios: tuple[int, int]) -> float:
    """Return a number times ratios, rounded once."""
    if number - number == 0:
        over, under = number.as_integer_ratio()
        for top, bottom in ratios:
            over *= top
            under *= bottom
        number = divide(over, under)
    if number - number:
        raise NumberError("the sum is too large for a number", "less extreme samples")
    return number


def _duration(seconds: float) -> str:
    size, unit = _unit_of_time(seconds)
    return f"{format_number(seconds / size)} {unit}"


def _duration_text(seconds: float) -> str:
    """Return a duration as typed, rounded up to two digits."""
    size, unit = _unit_of_time(seconds)
    number = seconds / size
    last = 10.0 ** (floor(log10(number)) - 1)
    return f"{format_number(ceil(number / last - SLACK) * last)}{unit}"


def _unit_of_time(seconds: float) -> tuple[int, str]:
    for least, size, unit in ((172800, 86400, "d"), (3600, 3600, "h"), (60, 60, "min")):
        if seconds >= least:
            return size, unit
    return 1, "s"
