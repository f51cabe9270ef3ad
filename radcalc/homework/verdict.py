"""The verdict on an answer: its result, right or wrong, and the likeliest mistakes."""

import math
from collections.abc import Sequence
from itertools import repeat
from typing import NamedTuple

from radcalc.answer import Step, Value
from radcalc.calculators.results import in_unit, measured_in, pick
from radcalc.derivation import format_number, with_unit
from radcalc.errors import ConditionError, option, quote
from radcalc.homework import uncertainty
from radcalc.homework.answer import LEAST_MEANT, Claim, Diagnosis, read_claim, read_tolerance
from radcalc.homework.question import Question
from radcalc.quantities.light import describe
from radcalc.units.scale_table import CONSTANTS
from radcalc.units.scales import ScaleUnit
from radcalc.units.unit import Unit

ROUNDED = "rounded"  # not a mistake
TOLERANCE, ONE_PERCENT = "1%", 0.01
REMARKS = ("error",)  # results that are error estimates of others
ASKED = {"sky": ("irradiance",)}  # by command: preferred among results with the same unit
# Results that cameras mark in rounded numbers, with the scale of these numbers.
CAMERA_SCALES = {"time": "time", "unfiltered-time": "time", "f-number": "f-number"}
WAYS = 4  # unambiguous answers in a hint


class Verdict(NamedTuple):
    """The verdict on an answer.

    `value` is the right value; `ratio` is the answer divided by it, if it is not 0.  The standard
    uncertainties are those of the right value and of the answer.
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


def check(question: Question, claim: str, tolerance: str | None = None) -> Verdict:
    """Judge an answer `[NAME=]VALUE[UNIT]`, within a tolerance (1%, 0.5lx or 3sf).

    The default tolerance is the largest of 1%, the rounding of the digits typed (if at least
    two), and the standard uncertainty of the right value.  Any of several solutions is right.
    """
    uncertain = question.uncertain
    uncertain_answers = (uncertain, *uncertain.more) if uncertain else repeat(None)
    verdicts = (
        _check(question._replace(answer=answer, uncertain=other), claim, tolerance)
        for answer, other in zip(
            (question.answer, *question.answer.more), uncertain_answers, strict=False
        )
    )
    first = next(verdicts)
    return first if first.right else next((v for v in verdicts if v.right), first)


def _check(question: Question, claim_text: str, asked_tolerance: str | None) -> Verdict:
    claim, tolerance = read_claim(claim_text), asked_tolerance or TOLERANCE
    target, unit_text, is_of_another = _target(question, claim, tolerance)
    unit = measured_in(unit_text, target.name)
    if isinstance(unit, ScaleUnit):  # readings are compared as quantities
        unit = unit.with_constants(
            {n: k.value for n, k in question.given.items() if n in CONSTANTS}
        )
        scale = unit.measures((*target.dimensions, *target.reach))
        if is_of_another:
            return _judged(
                question, claim, target, scale.unit.text, True, tolerance, asked_tolerance
            )
        arguments = _stands_for(claim, scale), target, scale.unit.text, False
        return _in_readings(_judged(question, *arguments, tolerance, asked_tolerance), claim, scale)
    return _judged(question, claim, target, unit_text, is_of_another, tolerance, asked_tolerance)


def _judged(
    question: Question,
    claim: Claim,
    target: Value,
    unit_text: str,
    is_of_another: bool,
    tolerance: str,
    asked_tolerance: str | None,
) -> Verdict:
    unit = measured_in(unit_text, target.name)
    right = in_unit(target, unit)
    if not isinstance(right, float):
        raise ConditionError(f"{option('check')} takes one answer, not several", "one value a call")
    if target.name == "azimuth":  # whole turns make no difference
        turn = 2 * math.pi / unit.factor
        claim = claim._replace(value=claim.value + turn * round((right - claim.value) / turn))
    number = uncertainty.of_result(question, target, unit)
    off = getattr(number, "std_dev", 0.0)
    allowed = read_tolerance(tolerance, unit)
    if not asked_tolerance and off > ONE_PERCENT * abs(right):
        allowed = uncertainty.tolerance(off, unit_text)
    is_near = allowed.holds(claim.value, right)
    ratio = claim.value / right if right else math.inf
    verdict = Verdict(
        is_near and not is_of_another,
        target.name,
        unit_text,
        right,
        claim.value,
        claim.unit or unit_text,
        ratio if math.isfinite(ratio) and not is_of_another else None,
        allowed.text,
        (),
        question.steps,
        off,
        claim.uncertainty,
    )
    if verdict.right:
        diagnoses = uncertainty.judge(number, claim, unit_text, allowed.width(right))
        return verdict._replace(right=not diagnoses, diagnoses=diagnoses)
    if is_of_another:
        return verdict._replace(diagnoses=(_wrong_unit(claim, target, unit_text, is_near),))
    return _explained(question, claim, target, unit, verdict, asked_tolerance)


def _explained(
    question: Question,
    claim: Claim,
    target: Value,
    unit: Unit,
    verdict: Verdict,
    asked_tolerance: str | None,
) -> Verdict:
    """Accept a rounded answer or a number as marked on cameras; diagnose any other.

    With an explicit tolerance neither is accepted.
    """
    right = verdict.value
    if marked := _marked(question, claim, target, unit):
        if asked_tolerance:
            return verdict._replace(diagnoses=(marked,))
        return verdict._replace(right=True, tolerance=marked.done, diagnoses=(marked,))
    if claim.value and abs(right - claim.value) <= max(claim.half_unit, claim.widest):
        rounded = _rounded(claim, right)
        if asked_tolerance or claim.digits < LEAST_MEANT:
            return verdict._replace(diagnoses=(rounded,))
        return verdict._replace(right=True, tolerance=rounded.done, diagnoses=(rounded,))
    from radcalc.homework.diagnosis import diagnose  # not needed for right answers

    scale = float(target.amount) / right if right else unit.factor
    diagnoses = diagnose(question, target, claim, scale)
    if question.steps and diagnoses and verdict.ratio is not None:
        verdict = verdict._replace(steps=(*question.steps, _as_answered(verdict, diagnoses[0])))
    return verdict._replace(diagnoses=diagnoses)


def _stands_for(claim: Claim, scale: ScaleUnit) -> Claim:
    slope = abs(scale.slope(claim.value))
    return claim._replace(
        value=scale.quantity(claim.value),
        unit=scale.unit.text,
        uncertainty=claim.uncertainty * slope,
        half_unit=claim.half_unit * slope,
        widest=claim.widest * slope,
    )


def _in_readings(verdict: Verdict, claim: Claim, scale: ScaleUnit) -> Verdict:
    """Convert the quantities of a verdict to readings; readings have no ratio."""
    right = scale.reading(verdict.value)
    tolerance = verdict.tolerance
    if tolerance.endswith("%"):
        tolerance += " of the quantity"
    diagnoses = tuple(
        _rounded(claim, right) if diagnosis.mistake == ROUNDED else diagnosis
        for diagnosis in verdict.diagnoses
    )
    return verdict._replace(
        value=right,
        unit=scale.text,
        claimed=claim.value,
        claimed_unit=scale.text,
        ratio=None,
        tolerance=tolerance,
        diagnoses=diagnoses,
        uncertainty=verdict.uncertainty / abs(scale.slope(right)),
        claimed_uncertainty=claim.uncertainty,
    )


def _as_answered(verdict: Verdict, diagnosis: Diagnosis) -> Step:
    sizes = (verdict.value, verdict.ratio, verdict.claimed)
    right, ratio, claimed = map(format_number, sizes)
    numbers = f"{with_unit(right, verdict.unit)} * {ratio} = {with_unit(claimed, verdict.unit)}"
    return Step(f"likely mistake: {diagnosis.done}", "", numbers)


def _rounded(claim: Claim, right: float) -> Diagnosis:
    digits = next(
        (n for n in range(1, claim.digits) if float(f"{right:.{n}g}") == claim.value), claim.digits
    )
    digits_given = "the digit" if digits == 1 else f"the {digits} digits"
    nearer = f"{right:.{max(3, digits + 1)}g}"
    return Diagnosis(ROUNDED, f"to {digits_given} given", f"{nearer} is nearer")


def _marked(question: Question, claim: Claim, target: Value, unit: Unit) -> Diagnosis | None:
    """Return the diagnosis of a number as marked on cameras, such as 1/125 for 1/128 s."""
    name = CAMERA_SCALES.get(target.name)
    if question.command != "ev" or name is None:
        return None
    from radcalc.laws.exposure import mark

    exact = mark(name, float(target.amount))
    if exact is None or not math.isclose(claim.value * unit.factor, exact, rel_tol=1e-9):
        return None
    return Diagnosis(ROUNDED, "as marked on cameras, in rounded numbers", "whole stops are exact")


def _wrong_unit(claim: Claim, target: Value, unit: str, is_near: bool) -> Diagnosis:
    number = "the number would be right" if is_near else "check both"
    return Diagnosis(
        "wrong-unit",
        f"{describe(measured_in(claim.unit, target.name))} is not {target.label}; {number}",
        f"{target.label} is in {unit}",
    )


def _target(question: Question, claim: Claim, tolerance: str) -> tuple[Value, str, bool]:
    """Return the result that is meant, the unit to compare in, and whether the unit is wrong.

    An answer without a name is for the first result with its unit; if the number fits only another
    result, the name is required.
    """
    typed = option("check", quote(claim.text))
    pool = _named(question, claim) if claim.name else _unnamed(question)
    if not claim.unit:
        if len({value.name for value in pool}) > 1 or len(set(pool[0].units)) != 1:
            ways = _ways(pool, claim)
            if claim.name:
                raise ConditionError(f"the unit of {typed} is missing", ways)
            raise ConditionError(f"{typed} is ambiguous: it may answer several results", ways)
        return pool[0], pool[0].units[0], False
    unit = measured_in(claim.unit, *(value.name for value in pool))
    fitting = [value for value in pool if claim.unit in value.units] or [
        value for value in pool if unit.dimension in (*value.dimensions, *value.reach)
    ]
    if fitting:
        holding = [value for value in fitting if _holds(value, unit, claim, tolerance)]
        if holding and fitting[0] not in holding:
            raise ConditionError(
                f"{typed} is ambiguous: it is right for {holding[0].name},"
                f" wrong for {fitting[0].name}",
                _ways([fitting[0], *holding], claim),
            )
        return fitting[0], claim.unit, False
    for value in pool:  # the first result that the number fits, if any
        for text in value.units:
            if _holds(value, measured_in(text, value.name), claim, tolerance):
                return value, text, True
    return pool[0], pool[0].units[0], True


def _named(question: Question, claim: Claim) -> list[Value]:
    named = [value for value in question.answer.values if claim.name in (value.name, value.also)]
    present = [value for value in named if not value.is_absent]
    if present:
        return present
    if named:
        pick(named, claim.name)  # its error names the missing input
    names = dict.fromkeys(v.name for v in question.answer.values if not v.is_absent)
    raise ConditionError(
        f"{option('check')}: unknown result '{quote(claim.name)}'", ", ".join(names)
    )


def _unnamed(question: Question) -> list[Value]:
    present = [v for v in question.answer.values if not v.is_absent and v.name not in REMARKS]
    if not present:
        raise ConditionError(f"{option('check')}: a result is missing", "less of it given")
    asked_names = ASKED.get(question.command, ())
    return sorted(
        present, key=lambda value: (value.given is not None, value.name not in asked_names)
    )


def _holds(value: Value, unit: Unit, claim: Claim, tolerance: str) -> bool:
    right = in_unit(value, unit)
    return isinstance(right, float) and read_tolerance(tolerance, unit).holds(claim.value, right)


def _ways(values: Sequence[Value], claim: Claim) -> str:
    """Return unambiguous answers, as a list for a hint."""
    clear_answers = [
        option("check", f"{value.name}={claim.number}{unit.replace(' ', '.').removeprefix('1')}")
        for value in values
        for unit in ([claim.unit] if claim.unit else value.units)
    ]
    return ", ".join([*dict.fromkeys(clear_answers)][:WAYS])
