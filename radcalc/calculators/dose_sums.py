"""Sums of the readings of a log: the step between them, their periods, and what is missing."""

from bisect import bisect_left, bisect_right
from collections.abc import Callable
from math import fsum, inf
from operator import add, mul, sub
from typing import Any, NamedTuple

from radcalc.errors import TooMany, mention

HOLE, WITHIN = 1.8, 1.5  # times the usual step: longer ones lack samples; as long or as short ones
REGULAR = 2 / 3  # share of steps that are as long as the usual one
ENOUGH = 100  # steps that show the usual one
MOST = 100_000  # periods: 11 years of hours
ROUNDED = 1e-3  # of a gap's limit: times in a log are rounded, as 600.05 s for 10 min in days
Spans = Callable[[float], tuple[float, float, str]]  # a time's period: start, end and name
POINTS, MEANS, MEANS_BEFORE, MEANS_CENTRED = "points", "means", "means-before", "means-centred"
# Means over time, by the halves of the step before a sample that are in its mean.
HALVES = {MEANS: 0, MEANS_CENTRED: 1, MEANS_BEFORE: 2}


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
        reading: str = POINTS,
    ) -> None:
        """Take the longest step to bridge [ticks], and the periods.

        With `bridges`, a missing sample does not make a gap by itself; `reading` is what samples
        are.  A mean lasts from its `edge` to that of the next sample, which for means of the step
        after their time is that time itself.
        """
        self.reading = reading
        self.of_means = reading in HALVES
        self.halves = HALVES.get(reading, 0)
        self.edge: Any = None  # of the last sample; None before the first step
        self.usual: float = 0  # the last bridged step, a whole number of ticks of a date
        self.longest = longest * (1 + ROUNDED)
        self.bridges, self.spans = bridges, spans
        self.periods: list[Period] = []
        self.first: Any = None  # tick
        self.time: Any = None  # of the last sample
        self.value = 0.0
        self.is_broken = False
        self.skipped: tuple[Any, Any] | None = None  # first and last time since the last sample
        self.count = 0
        self.plain, self.first_value = 0.0, 0.0  # the sum of the samples, without their times
        self.peak, self.peak_at = -inf, 0.0
        self.gaps, self.gap_time, self.widest = 0, 0.0, NO_STEP
        self.step = NO_STEP  # the longest bridged step
        self.steps = Steps()
        self.negative, self.below, self.least, self.least_at = 0, 0.0, 0.0, 0.0

    def interrupt(self, time: Any = None) -> None:
        """Skip a sample, at its time if that is known: the means beside it end and start there."""
        self.is_broken = not self.bridges
        if time is not None:
            self.skipped = (self.skipped or (time, time))[0], time

    def add(self, times: list[Any], values: list[float]) -> None:
        """Add samples in order of time: sum up each run, and count the gaps between runs."""
        self._watch(times, values)
        counted = 0  # of the run, before
        if self.first is None:
            self.first, self.first_value = times[0], values[0]
        elif self.is_broken or times[0] - self.time > self.longest:
            self._gap(self.time, times[0], self.value)
        else:
            counted = int(not self.halves or self.edge is not None)
            times, values = [self.time, *times], [self.value, *values]
        self.time, self.value, self.is_broken = times[-1], values[-1], False
        self.skipped = None
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
            self.time += self.usual - self._before(self.usual)
            self._hold(self.value, self.edge, self.time)

    def _hold(self, value: float, start: Any, end: Any) -> Any:
        """Add a value that lasts from one time to another; return the latter."""
        while start < end:
            period = self._period(start)
            stop = min(end, period.end)
            period.take([start, stop], [value, value], [stop - start])
            start = stop
        return start

    def _before(self, step: Any) -> Any:
        """Return the part of a step that the mean at its end has."""
        size = step * self.halves
        return size // 2 if isinstance(size, int) else size / 2

    def _starts(self, times: list[Any], steps: list[Any]) -> list[Any]:
        """Return when the means of samples start; without a first step this is not known."""
        if self.edge is None and (steps or not self.halves):
            self.first = self.edge = times[0] - (self._before(steps[0]) if steps else 0)
        ends = zip(times[1:], steps, strict=True)
        starts = [self.edge, *[time - self._before(step) for time, step in ends]]
        self.edge = starts[-1]
        return starts

    def _gap(self, start: Any, end: Any, value: float) -> None:
        """Count a gap between two samples, without what their means have of it."""
        if self.of_means:
            if self.edge is None:  # a first sample without a step: how long it lasts is unknown
                self.edge = start
                self._run([start], [value], [], 0)
            before = self._before(self.usual)
            first, last = self.skipped or (end, start)
            stop = min(start + self.usual - before, first - self._before(first - start))
            begin = max(end - before, end - self._before(end - last))
            start = self._hold(value, self.edge, stop)
            self.edge = end = max(begin, start)
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
        if self.of_means:
            times = self._starts(times, steps)
            if self.edge is None:
                return
            steps = list(map(sub, times[1:], times))
        if steps:
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
