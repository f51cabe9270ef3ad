"""Exposure or energy of samples of light over time.

Samples are points, with straight lines between them, or means over the steps that they begin or
end, or over a half of both.
A step that is longer than `max-gap`, or that lacks a sample, is a gap: it adds nothing, and a note
reports it.
"""

from collections.abc import Callable, Iterator
from math import ceil, floor, inf, log10
from typing import NamedTuple

from radcalc.answer import (
    Answer,
    Formula,
    Value,
    coherent_unit_of,
    format_number,
    format_value,
    letter_of,
)
from radcalc.calculators import dose_sums
from radcalc.calculators.dose_sums import MEANS, MEANS_BEFORE, MEANS_CENTRED, POINTS, Dose, Period
from radcalc.calculators.page import FILE, PERIODS, Operand, Page, choice, text
from radcalc.calculators.results import absent, value
from radcalc.calculators.solved import solve
from radcalc.calculators.worksheet import Placed, worksheet
from radcalc.errors import ConditionError, NumberError, Try, add, computed, mention, option, quote
from radcalc.files import ENDINGS
from radcalc.floats import divide
from radcalc.inputs import Inputs
from radcalc.laws import law
from radcalc.quantities import PHOTON, describe, light_dimension
from radcalc.quantities import read as read_light
from radcalc.quantities.symbols import LINKS, REFINEMENTS
from radcalc.terminal import ABORT, INVALID
from radcalc.units import Unit
from radcalc.units.table import resolve

FLUX, IRRADIANCE = (0, 0, 0), (0, 1, 0)  # geometries that have a dose
PPFD = light_dimension(PHOTON, IRRADIANCE, "")
DAY = 86400  # s
WHOLE = (3600, DAY)  # seconds of an hour, and of a day without a clock change
READINGS = {  # what samples are
    POINTS: "values between samples are interpolated linearly (trapezoidal rule)",
    MEANS: "each sample is the mean from its time to that of the next; the last one, or "
    "one before a gap, lasts as long as the step before it",
    MEANS_BEFORE: "each sample is the mean from the time of the one before to its own; the first "
    "one lasts as long as the step after it, one after a gap as long as the step before the gap",
    MEANS_CENTRED: "each sample is the mean around its time, from the middle of the step before "
    "it to that of the step after it; at the ends and at gaps both halves are alike",
}
SHORT = 3600  # s: a log that is shown in seconds, and not in hours
LONG = 10  # times the mean of the others: longer steps are noted
SLACK = 1e-9  # of a number of units

MEAN = {
    IRRADIANCE: law("mean irradiance", "{exposure} = {mean-irradiance} {covered-time}"),
    FLUX: law("mean flux", "{energy} = {mean-flux} {covered-time}"),
}
RECEIVED = law("received energy", "{energy} = {exposure} {receiver-area}", "ISO 80000-7")
TERMS = {  # of the sum, with E for an irradiance
    POINTS: "(E_i + E_i+1)/2 (t_i+1 - t_i)",
    MEANS: "E_i (t_i+1 - t_i)",
    MEANS_BEFORE: "E_i (t_i - t_i-1)",
    MEANS_CENTRED: "E_i (t_i+1 - t_i-1)/2",
}
OF = {IRRADIANCE: ("exposure", "maximum-irradiance"),
      FLUX: ("energy", "maximum-flux")}  # fmt: skip
AVERAGES, PEAKS = ("mean-irradiance", "mean-flux"), ("maximum-irradiance", "maximum-flux")
OF_SAMPLES = (*AVERAGES, *PEAKS)
# Problem and hint for a period without samples.
EMPTY = "no time is covered", mention("a longer {max-gap}, or all results (it is empty there)")
PAGE = Page(
    "a dose",
    ("receiver-area",),
    ("exposure", "energy", *AVERAGES, *PEAKS),
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
            text(
                "where",
                "COLUMN=VALUE",
                "Rows of one series: those with this text in a column (* is any; repeatable).",
                repeats=True,
            ),
            text(
                "missing",
                "VALUE",
                "Mark of a missing value, whose line is a gap (repeatable).",
                repeats=True,
            ),
            text("dark", "VALUE", "What the meter shows in the dark, subtracted from all values."),
            text("thousands", "X", "Separator of thousands in the values, as in 1,033.3."),
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
                "means: from each time to the next, from the time before to each, or centred on "
                "each.  A public format of the sun has its own default.",
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
    problem = f"the integral of {describe(unit)} over time is neither an exposure nor an energy"
    hint = "samples of an irradiance, illuminance, PPFD or flux: W/m2, lx, umol/m2/s, W, lm"
    raise ConditionError(problem, hint)


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
        """Refuse a log with too few samples, without covered time, or of noise alone."""
        dose = self.dose
        if dose.count < 2:
            problem = "one sample is not enough" if dose.count else "there is no sample"
            raise ConditionError(problem, "two samples or more")
        if not any(period.covered for period in dose.periods):
            longest = _duration_text(self.seconds(dose.widest.length))
            bridging = computed(add("max-gap", longest, "which bridges all of them"))
            raise ConditionError("every step is a gap, so there is nothing to add up", bridging)
        if sum(period.total + period.low for period in dose.periods) < 0:
            problem = "the samples add up to less than 0, so all of them are a meter's noise"
            raise ConditionError(problem, "samples with light")

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
                f"kept as a meter's noise in the dark: {count} below 0, down to "
                f"{format_number(dose.least)} {unit}, together {below} {unit} s"
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
            cut = option("max-gap", _duration_text(dose_sums.WITHIN * usual))
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

    def _describe(self, step: dose_sums.SampleStep) -> str:
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
                    notes = [f"{beginning} time-of-maximum is the time since its start", *notes]
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
        reading_of = self.dose.reading
        term = (
            TERMS[reading_of] if geometry == IRRADIANCE else TERMS[reading_of].replace("E", "Phi")
        )
        name = f"{amount} of {'means' if self.dose.of_means else 'samples'}"
        formula = Formula(name, f"{{{amount}}} = sum of {term}")
        placed.steps.append(formula.with_numbers(f"{letter_of(amount)} = {sum_text}"))
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
        lacking = () if covered else AVERAGES if period.count else (*AVERAGES, *PEAKS)
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
