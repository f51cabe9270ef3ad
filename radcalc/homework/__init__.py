"""Checks of a learner's answer: right or wrong, and the likeliest mistake.

This module has the verdict.
"""

import math
from collections.abc import Sequence
from itertools import repeat
from typing import TYPE_CHECKING, NamedTuple, cast

from radcalc.answer import Step, Value, format_number, with_unit
from radcalc.calculators.results import (
    fits,
    in_unit,
    name_in,
    of_eyes,
    of_kind,
    pick,
    results_meant,
    right_names,
    unit_for,
)
from radcalc.errors import ConditionError, RadcalcError, option, quote
from radcalc.homework import diagnosis
from radcalc.homework.question import (
    PRINTED,
    Claim,
    Diagnosis,
    Question,
    Tolerance,
    decimal,
    in_its_unit,
    is_rounded,
    read_claim,
    read_tolerance,
)
from radcalc.homework.wording import Translatable
from radcalc.inputs.quantities import DIFFERENCES, measured_in
from radcalc.quantities import describe
from radcalc.quantities.symbols import READINGS
from radcalc.units import NUMBER, WEIGHT_AT, Unit
from radcalc.units.scale_table import BY_SPELLING, Scale
from radcalc.units.values import ScaleUnit, degree

if TYPE_CHECKING:
    from radcalc.homework.question import Candidate


ROUNDED = "rounded"  # not a mistake
RELATIVE = "another-result"
TOLERANCE, ONE_PERCENT = "1%", 0.01
REMARKS = ("error",)  # results that are error estimates of others
# Approximations and relatives of results with the same unit, which count only if they are named.
RELATIVES = ("far-field-", "projected-", "scotopic-", "saturation-")
ASKED = {"sky": ("irradiance",)}  # by command: preferred among results with the same unit
WAYS = 4  # unambiguous answers in a hint


class Verdict(NamedTuple):
    """The verdict on an answer.

    `name` is that of the result in the kind of its unit, `result` that of the calculator, and
    `label` the quantity.  `value` is the right value; `ratio` is the answer divided by it, if it is
    not 0.  The standard uncertainties are those of the right value and of the answer.  `is_chosen`
    marks a result that the answer fits, of several with its dimension.  The notes are on the
    user's definitions, of an answer in Python.
    """

    right: bool
    name: str
    unit: str
    value: float
    claimed: float
    claimed_unit: str
    ratio: float | None
    tolerance: str
    diagnoses: tuple[Diagnosis, ...]
    steps: tuple[Step, ...]
    uncertainty: float = 0.0
    claimed_uncertainty: float = 0.0
    result: str = ""
    label: str = ""
    is_chosen: bool = False
    notes: tuple[str, ...] = ()


class Reading(NamedTuple):
    """A result in the unit of an answer; on a scale, `right` is its reading.

    `size` is the quantity in the `unit`, which a scale's reading stands for; that of a number that
    is a reading of a scale is not known, and 1.  `off` is the standard uncertainty of `right`.
    """

    target: Value
    text: str
    unit: Unit
    right: float
    size: float
    scale: Scale | None = None
    off: float = 0.0

    @property
    def is_number(self) -> bool:
        """Whether the result is a number: a reading of a scale, if it has one."""
        return self.scale is None or self.target.name in READINGS

    @property
    def whole(self) -> float:
        """The change of `right` over the relative change of the quantity, if both are small."""
        if self.scale is None or not self.scale.steps:
            return abs(self.right)
        return abs(self.scale.steps) / math.log(self.scale.base)

    @property
    def per_unit(self) -> float:
        """The change of `right` over the change of the number that the result is."""
        return 1.0 if self.is_number else self.whole / abs(self.size)

    def times(self, claimed: float, right: float) -> float:
        """Return the ratio of the quantities of two readings."""
        scale = cast("Scale", self.scale)
        if not scale.steps:
            return right / claimed if claimed else math.inf
        try:
            return float(scale.base ** ((claimed - right) / scale.steps))
        except OverflowError:
            return math.inf

    def is_near(self, claimed: float, allowed: Tolerance) -> bool:
        if self._is_of_numbers(allowed):
            return allowed.holds(claimed, self.right)
        return allowed.holds(self.size * self.times(claimed, self.right), self.size)

    def width(self, allowed: Tolerance) -> float:
        """Return the largest allowed difference of an answer."""
        if self._is_of_numbers(allowed):
            return allowed.width(self.right)
        return allowed.width(self.size) * self.whole / abs(self.size)

    def _is_of_numbers(self, allowed: Tolerance) -> bool:
        return self.scale is None or allowed.kind not in ("relative", "absolute")

    def slope(self, reading: float) -> float:
        """Return the derivative of the quantity over the reading; infinite if out of range."""
        try:
            return abs(float(cast("Scale", self.scale).slope(reading)))
        except ArithmeticError:
            return math.inf

    def spans(self, claim: Claim) -> bool:
        """Return whether the right value is within the uncertainty of an answer.

        An uncertainty that is larger than the answer, or a factor of 2, does not count.
        """
        value, off = claim.value, claim.uncertainty
        if not off or abs(decimal(value) - decimal(self.right)) > decimal(off):
            return False
        if self.scale is None or not self.scale.steps:
            return off < abs(value)
        return abs(off / self.scale.steps) * math.log2(self.scale.base) < 1 + 1e-9


def check(question: Question, claim: str, tolerance: str | None = None) -> Verdict:
    """Judge an answer `[NAME=]VALUE[UNIT]`, within a tolerance (1%, 0.5lx or 3sf).

    By default an answer is right if it deviates by at most 1 % or the standard uncertainty of the
    right value, is that value rounded, or has an uncertainty that includes it.  Any of several
    solutions is right.
    """
    uncertain = question.uncertain
    uncertain_answers = (uncertain, *uncertain.more) if uncertain else repeat(None)
    typed = read_claim(claim)
    verdicts = (
        _check(question._replace(answer=answer, uncertain=other), typed, tolerance)
        for answer, other in zip(
            (question.answer, *question.answer.more), uncertain_answers, strict=False
        )
    )
    first = next(verdicts)
    return first if first.right else next((v for v in verdicts if v.right), first)


def _check(question: Question, claim: Claim, asked_tolerance: str | None) -> Verdict:
    """Judge an answer to a question with one solution."""
    question = in_its_unit(question, claim.unit)
    readings = _readings(question, claim, asked_tolerance)
    if not readings:
        return _in_wrong_unit(question, claim, asked_tolerance)
    others = [] if claim.name else [r for r in readings if r.target.name.startswith(RELATIVES)]
    readings = [reading for reading in readings if reading not in others] or readings
    verdicts = []
    for reading in readings:
        verdicts.append(_judged(question, claim, reading, asked_tolerance))
        if verdicts[-1].right:
            several = len({reading.right for reading in readings}) > 1
            return verdicts[-1]._replace(is_chosen=several and not claim.name)
    for other in others:
        if other is not readings[0] and _judged(question, claim, other, asked_tolerance).right:
            return verdicts[0]._replace(diagnoses=(_relative(claim, other),))
    return _explained(question, claim, readings[0], verdicts[0], asked_tolerance)


def _judged(
    question: Question, claim: Claim, reading: Reading, asked_tolerance: str | None
) -> Verdict:
    """Return the verdict on an answer to one result, without the likely mistakes."""
    target, right, unit = reading.target, reading.right, reading.unit
    allowed = read_tolerance(asked_tolerance or TOLERANCE, unit, reading.scale)
    if not asked_tolerance and reading.off > ONE_PERCENT * reading.whole:
        allowed = diagnosis.tolerance(reading.off, reading.text)
    ratio = claim.value / right if right and reading.is_number else math.inf
    is_part = reading.scale is not None and allowed.kind == "relative"
    tolerance = Translatable("{0} of the quantity", allowed.text) if is_part else allowed.text
    verdict = Verdict(
        False,
        name_in(target, unit.dimension),
        reading.text,
        right,
        claim.value,
        claim.unit or reading.text,
        ratio if math.isfinite(ratio) else None,
        tolerance,
        (),
        question.steps,
        reading.off,
        claim.uncertainty,
        target.name,
        of_kind(target, unit)[0],
    )
    claim = _turned(claim, reading)
    if not asked_tolerance and not reading.off and reading.spans(claim):
        return verdict._replace(right=True, tolerance="within the uncertainty given")
    if reading.is_near(claim.value, allowed):
        number = diagnosis.of_result(question, target, unit)
        width, per_unit = reading.width(allowed), reading.per_unit
        diagnoses = diagnosis.judge(number, claim, reading.text, width, per_unit)
        return verdict._replace(right=not diagnoses, diagnoses=diagnoses)
    rounded = _rounded(question, claim, reading)
    if not rounded or asked_tolerance:
        return verdict._replace(diagnoses=rounded)
    return verdict._replace(right=True, tolerance=rounded[0].done, diagnoses=rounded)


def _turned(claim: Claim, reading: Reading) -> Claim:
    """Return the answer nearest to the right azimuth: whole turns make no difference."""
    if not reading.target.name.endswith("azimuth"):
        return claim
    turn, off = 2 * math.pi / reading.unit.factor, claim.value - reading.right
    if abs(off) <= turn / 2:
        return claim
    return claim._replace(value=reading.right + math.remainder(off, turn))


def _explained(
    question: Question,
    claim: Claim,
    reading: Reading,
    verdict: Verdict,
    asked_tolerance: str | None,
) -> Verdict:
    """Add the likely mistakes to the verdict on a wrong answer."""
    if verdict.diagnoses:
        return verdict
    from radcalc.homework.diagnosis import diagnose  # not needed for right answers

    target, results_meant = reading.target, _turned(claim, reading)
    right, scale = reading.right, reading.unit.factor
    if not reading.is_number:
        slope, right = reading.slope(claim.value), reading.size
        results_meant = claim._replace(
            value=right * reading.times(claim.value, reading.right),
            half_unit=claim.half_unit * slope,
            widest=claim.widest * slope,
        )
    if not math.isfinite(results_meant.value):
        return verdict
    scale = float(target.amount) / right if right else scale
    readings = [] if reading.is_number else _misread(reading, float(target.amount))
    diagnoses = diagnose(question, target, results_meant, scale, readings)
    if not diagnoses and not asked_tolerance and (zeros := _zeros(claim, reading)):
        return verdict._replace(diagnoses=(zeros,))
    if question.steps and diagnoses and verdict.ratio is not None:
        verdict = verdict._replace(steps=_as_answered(question.steps, verdict, diagnoses[0]))
    return verdict._replace(diagnoses=diagnoses)


def _misread(reading: Reading, amount: float) -> "list[Candidate]":
    """Return the wrong values of a result that is read on a scale [SI]."""
    from radcalc.homework.misread import misread, readings

    scale, right = cast("Scale", reading.scale), reading.right
    factors = list(readings())
    if not scale.steps:
        factors = [(("unit-upside-down",), size / right**2) for size in (1.0, 1e6)]
    candidates = [
        misread(names, amount * times)
        for names, factor in factors
        if math.isfinite(times := reading.times(right * factor, right))
    ]
    return [candidate for candidate in candidates if candidate]


def _as_answered(steps: Sequence[Step], verdict: Verdict, diagnosis: Diagnosis) -> tuple[Step, ...]:
    """Return the right steps, with the learner's where the ways part, or else at the end."""
    name = f"likely mistake: {diagnosis.done}"
    left, _, _ = diagnosis.yours.partition(" = ")
    for k, step in enumerate(steps):
        if left and step.numbers.startswith(f"{left} = "):
            return (*steps[: k + 1], Step(name, "", diagnosis.yours), *steps[k + 1 :])
    if diagnosis.yours:
        return (*steps, Step(name, "", diagnosis.yours))
    sizes = (verdict.value, verdict.ratio, verdict.claimed)
    right, ratio, claimed = map(format_number, sizes)
    numbers = f"{with_unit(right, verdict.unit)} * {ratio} = {with_unit(claimed, verdict.unit)}"
    return (*steps, Step(name, "", numbers))


def _rounded(question: Question, claim: Claim, reading: Reading) -> tuple[Diagnosis, ...]:
    """Return how an answer is rounded, if it is: as marked on cameras, or to the digits typed."""
    if claim.uncertainty:
        return ()
    if _is_marked(question, claim, reading):
        return (Diagnosis(ROUNDED, "as marked on cameras", "whole and third stops are exact"),)
    if not is_rounded(claim, reading.right):
        return ()
    done = Translatable("to the digit given")
    if claim.digits > 1:
        done = Translatable(
            "to the {0} digit given", claim.digits, plural="to the {0} digits given"
        )
    texts = [f"{reading.right:.{digits}g}" for digits in range(max(3, claim.digits + 1), PRINTED)]
    nearer = next((text for text in texts if float(text) != claim.value), claim.number)
    return (Diagnosis(ROUNDED, done, Translatable("{0} is nearer", nearer)),)


def _zeros(claim: Claim, reading: Reading) -> Diagnosis | None:
    """Return the diagnosis of an integer that is right if zeros at its end are not digits."""
    typed = claim.number.lstrip("-")
    if not typed.isdigit():
        return None
    for digits in range(len(typed.rstrip("0")), claim.digits):
        if is_rounded(claim._replace(digits=digits), reading.right):
            number, power = f"{claim.value:.{digits - 1}e}".split("e")
            rounded = Translatable("to {0} digit", digits, plural="to {0} digits")
            typed_with = "but typed with {0}"
            more = Translatable(typed_with, claim.digits, plural=typed_with)
            done = Translatable("{0}, {1}", rounded, more)
            return Diagnosis(ROUNDED, done, Translatable("write {0}", f"{number}e{int(power)}"))
    return None


def _is_marked(question: Question, claim: Claim, reading: Reading) -> bool:
    """Return whether an answer is right with the exact values of the numbers on cameras.

    These are rounded: 1/125 is 1/128 s, and f/5.6 is the root of 2^5.
    """
    if question.command != "ev" or reading.unit.is_scale:
        return False
    from radcalc.laws.photometry import exact

    factor = reading.unit.factor
    results_meant = exact(reading.target.name, claim.value * factor) / factor
    given = {
        name: item._replace(value=exact(name, item.value), is_exact=True)
        for name, item in question.given.items()
    }
    if results_meant == claim.value and all(
        item.value == question.given[name].value for name, item in given.items()
    ):
        return False
    try:
        values = question.work_out(given).values
        target = next(value for value in values if value.name == reading.target.name)
        right = _reading(question, target, reading.text)
    except RadcalcError:
        return False
    allowed = read_tolerance(TOLERANCE, right.unit)
    return right.is_near(results_meant, allowed) or is_rounded(claim, right.right)


def _relative(claim: Claim, other: Reading) -> Diagnosis:
    """Return the diagnosis of an answer that is right for an approximation or a relative."""
    label, _ = of_kind(other.target, other.unit)
    name = name_in(other.target, other.unit.dimension)
    named = f"{name}={claim.number}{claim.unit.replace(' ', '.')}"
    counts = Translatable("it counts only with its name: {0}", named)
    return Diagnosis(RELATIVE, Translatable("this is the {0}", label), counts)


def _in_wrong_unit(question: Question, claim: Claim, asked_tolerance: str | None) -> Verdict:
    """Return the verdict on an answer whose unit is that of no result."""
    pool = _named(question, claim) if claim.name else _unnamed(question)
    tolerance, is_near = asked_tolerance or TOLERANCE, False
    reading = _reading(question, pool[0], pool[0].units[0])
    for value in pool:  # the first result that the number fits, if any
        for text in value.units:
            other = _reading(question, value, text)
            if not is_near and other.is_near(
                claim.value, read_tolerance(tolerance, other.unit, other.scale)
            ):
                reading, is_near = other, True
    inputs = [v for v in question.answer.values if v.given is not None and not claim.name]
    if not is_near and (same := _fitting(question, inputs, claim.unit)):
        problem = f"{option('check', quote(claim.text))} has the unit of {same[0].name}, an input"
        raise ConditionError(problem, _ways(same, claim))
    wrong = _judged(question, claim, reading, asked_tolerance)
    diagnosis = _wrong_unit(claim, reading, is_near)
    return wrong._replace(right=False, ratio=None, diagnoses=(diagnosis,))


def _wrong_unit(claim: Claim, reading: Reading, is_near: bool) -> Diagnosis:
    number = "the number would be right" if is_near else "check both"
    target = reading.target
    given = describe(measured_in(claim.unit, target.name))
    done = Translatable("{0} is not {1}; {2}", given, target.label, number)
    return Diagnosis("wrong-unit", done, Translatable("{0} is in {1}", target.label, reading.text))


def _readings(question: Question, claim: Claim, asked_tolerance: str | None) -> list[Reading]:
    """Return the results with the dimension of an answer, those with its very unit first.

    An answer without a name is not for an input.  One without a unit needs a single result or is
    for results that are numbers.
    """
    typed = option("check", quote(claim.text))
    pool = _named(question, claim) if claim.name else _unnamed(question)
    if not claim.unit:
        if len({value.name for value in pool}) == 1 and len(set(pool[0].units)) == 1:
            return [_reading(question, pool[0], pool[0].units[0])]
        if claim.name:
            raise ConditionError(f"the unit of {typed} is missing", _ways(pool, claim))
        numbers = [_reading(question, v, "1") for v in pool if v.dimensions[0] == NUMBER]
        fitting = [r for r in numbers if _judged(question, claim, r, asked_tolerance).right]
        if not fitting:
            problem = f"{typed} is ambiguous: it may answer several results"
            raise ConditionError(problem, _ways(pool, claim))
        return fitting
    is_named = bool(claim.name)
    named = _fitting(question, pool, claim.unit, is_named)
    return [_reading(question, value, claim.unit, is_named) for value in named]


def _fitting(
    question: Question, values: Sequence[Value], text: str, is_named: bool = True
) -> list[Value]:
    """Return the results that can be in a unit, those that are shown in it first."""
    differences = [v for v in values if v.name in DIFFERENCES] if degree(text) else []
    found = [(value, _unit_for(question, value, text, is_named)) for value in differences or values]
    fitting = [(value, unit) for value, unit in found if fits(value, unit)]
    fitting.sort(key=lambda f: (text not in f[0].units, f[1].dimension not in f[0].dimensions))
    return [value for value, _ in fitting]


def _unit_for(question: Question, value: Value, text: str, is_named: bool) -> Unit:
    """Return the unit of an answer: lumens are an observer's if the call or the answer names it."""
    unit = unit_for(value, text, {name: given.value for name, given in question.given.items()})
    return of_eyes(value, unit) if is_named or "observer" in question.given else unit


def _reading(question: Question, target: Value, text: str, is_named: bool = True) -> Reading:
    """Return a result in a unit, or its reading on a scale."""
    unit = _unit_for(question, target, text, is_named)
    scale = unit if isinstance(unit, ScaleUnit) else None
    text = unit.text if unit.dimension[WEIGHT_AT] else text
    unit = scale.unit if scale else unit
    size = in_unit(target, unit)
    if not isinstance(size, float):
        raise ConditionError(f"{option('check')} takes one answer, not several", "one value a call")
    reading = Reading(target, text, unit, size, size)
    if scale:
        reading = reading._replace(right=scale.reading(size), scale=scale.scale)
    elif steps := READINGS.get(target.name):
        own = text if text in steps else next(iter(steps))
        reading = reading._replace(size=1.0, scale=BY_SPELLING[own][0])
    number = diagnosis.of_result(question, target, unit)
    return reading._replace(off=getattr(number, "std_dev", 0.0) * reading.per_unit)


def _named(question: Question, claim: Claim) -> list[Value]:
    """Return the results that have the name in an answer; refuse an unknown one."""
    named = [value for value in question.answer.values if claim.name in (value.name, value.also)]
    present = [value for value in named if not value.is_absent]
    typed = [value for value in present if value.name == claim.name]
    if present:
        return present if claim.unit else typed or present  # a unit decides between kinds
    if named:
        pick(named, claim.name)  # its error names the missing input
    present = [v for v in question.answer.values if not v.is_absent]
    other, _ = results_meant(claim.name, present, claim.unit)
    if other:
        return _named(question, claim._replace(name=other))
    right = [name.partition(":")[0] for name in right_names(claim.name, present)]
    alike = [v for v in present if v.name in right] or (present if claim.unit else [])
    fitting = _fitting(question, alike, claim.unit) if claim.unit else alike
    hint = _ways(fitting, claim) or ", ".join(dict.fromkeys(v.name for v in present))
    raise ConditionError(f"{option('check')}: unknown result '{quote(claim.name)}'", hint)


def _unnamed(question: Question) -> list[Value]:
    """Return the results that an answer without a name may be for: not inputs, if possible."""
    present = [v for v in question.answer.values if not v.is_absent and v.name not in REMARKS]
    if not present:
        raise ConditionError(f"{option('check')}: a result is missing", "less of it given")
    results = [value for value in present if value.given is None] or present
    asked_names = ASKED.get(question.command, ())
    return sorted(results, key=lambda value: value.name not in asked_names)


def _ways(values: Sequence[Value], claim: Claim) -> str:
    """Return unambiguous answers, as a list for a hint; of a bare number the nearest first."""
    ways = [(v, unit) for v in values for unit in ([claim.unit] if claim.unit else v.units)]
    if not claim.unit:
        ways.sort(key=lambda way: _far_off(way[0], way[1], claim.value))
    clear_answers = [
        option("check", f"{name}={claim.number}{unit.replace(' ', '.').removeprefix('1')}")
        for value, unit in ways
        for name in [name_in(value, measured_in(unit, value.name).dimension)]
    ]
    return ", ".join([*dict.fromkeys(clear_answers)][:WAYS])


def _far_off(value: Value, unit: str, number: float) -> float:
    """Return how far a result in a unit is from a number, as the logarithm of their ratio."""
    try:
        return abs(math.log(float(in_unit(value, measured_in(unit, value.name))) / number))
    except (RadcalcError, ArithmeticError, TypeError, ValueError):
        return math.inf
