"""What is said of an answer: which result it is of, whether it is right, and what went wrong."""

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
from radcalc.units.scales import CONSTANTS, ScaleUnit
from radcalc.units.table import Unit

ROUNDED = "rounded"  # which is no mistake
TOLERANCE, ONE_PERCENT = "1%", 0.01
REMARKS = ("error",)  # results that say how good another is
ASKED = {"sky": ("irradiance",)}  # by a command's plane, before what has the same unit
# Results that cameras are marked with in rounded numbers, each by the scale that has them.
CAMERA_SCALES = {"time": "time", "unfiltered-time": "time", "f-number": "f-number"}
WAYS = 4  # to say an answer clearly, that are shown


class Verdict(NamedTuple):
    """What is said of an answer; `value` is the right one.

    The `ratio` is the answer over the right value, if that is not 0.  The standard
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

    Without a tolerance it is 1%, or the digits typed where these are at least two and leave more,
    or the standard uncertainty of the right value.  Where several answers fit what
    is given, one of them is right.
    """
    uncertain = question.uncertain
    others = (uncertain, *uncertain.more) if uncertain else repeat(None)
    verdicts = (
        _check(question._replace(answer=answer, uncertain=other), claim, tolerance)
        for answer, other in zip((question.answer, *question.answer.more), others, strict=False)
    )
    first = next(verdicts)
    return first if first.right else next((v for v in verdicts if v.right), first)


def _check(question: Question, claim: str, asked: str | None) -> Verdict:
    said, tolerance = read_claim(claim), asked or TOLERANCE
    target, unit_text, is_of_another = _target(question, said, tolerance)
    unit = measured_in(unit_text, target.name)
    if isinstance(unit, ScaleUnit):  # it is judged by what it stands for
        unit = unit.with_constants(
            {n: k.value for n, k in question.given.items() if n in CONSTANTS}
        )
        scale = unit.measures((*target.dimensions, *target.reach))
        if is_of_another:
            return _judged(question, said, target, scale.unit.text, True, tolerance, asked)
        meant = _stands_for(said, scale), target, scale.unit.text, False
        return _in_readings(_judged(question, *meant, tolerance, asked), said, scale)
    return _judged(question, said, target, unit_text, is_of_another, tolerance, asked)


def _judged(
    question: Question,
    said: Claim,
    target: Value,
    unit_text: str,
    is_of_another: bool,
    tolerance: str,
    asked: str | None,
) -> Verdict:
    """Judge an answer that is meant for one of the results, in a unit."""
    unit = measured_in(unit_text, target.name)
    right = in_unit(target, unit)
    if not isinstance(right, float):
        raise ConditionError(
            f"{option('check')} takes one answer, and there are several", "one value a call"
        )
    if target.name == "azimuth":  # whole turns make no difference
        turn = 2 * math.pi / unit.factor
        said = said._replace(value=said.value + turn * round((right - said.value) / turn))
    number = uncertainty.of_result(question, target, unit)
    off = getattr(number, "std_dev", 0.0)
    allowed = read_tolerance(tolerance, unit)
    if not asked and off > ONE_PERCENT * abs(right):
        allowed = uncertainty.tolerance(off, unit_text)
    is_near = allowed.holds(said.value, right)
    ratio = said.value / right if right else math.inf
    verdict = Verdict(
        is_near and not is_of_another,
        target.name,
        unit_text,
        right,
        said.value,
        said.unit or unit_text,
        ratio if math.isfinite(ratio) and not is_of_another else None,
        allowed.text,
        (),
        question.steps,
        off,
        said.uncertainty,
    )
    if verdict.right:
        found = uncertainty.judge(number, said, unit_text, allowed.width(right))
        return verdict._replace(right=not found, diagnoses=found)
    if is_of_another:
        return verdict._replace(diagnoses=(_wrong_unit(said, target, unit_text, is_near),))
    if marked := _marked(question, said, target, unit):
        if asked:
            return verdict._replace(diagnoses=(marked,))
        return verdict._replace(right=True, tolerance=marked.done, diagnoses=(marked,))
    if said.value and abs(right - said.value) <= max(said.half_unit, said.widest):
        rounded = _rounded(said, right)
        if asked or said.digits < LEAST_MEANT:
            return verdict._replace(diagnoses=(rounded,))
        return verdict._replace(right=True, tolerance=rounded.done, diagnoses=(rounded,))
    from radcalc.homework.diagnosis import diagnose  # which right answers do without

    scale = float(target.amount) / right if right else unit.factor
    found = diagnose(question, target, said, scale)
    if question.steps and found and verdict.ratio is not None:
        verdict = verdict._replace(steps=(*question.steps, _as_answered(verdict, found[0])))
    return verdict._replace(diagnoses=found)


def _stands_for(said: Claim, scale: ScaleUnit) -> Claim:
    """A reading as what it stands for; half a unit of its digits becomes a part of that."""
    slope = abs(scale.slope(said.value))
    return said._replace(
        value=scale.quantity(said.value),
        unit=scale.unit.text,
        uncertainty=said.uncertainty * slope,
        half_unit=said.half_unit * slope,
        widest=said.widest * slope,
    )


def _in_readings(verdict: Verdict, said: Claim, scale: ScaleUnit) -> Verdict:
    """A verdict with readings for what they stand for, which have no ratio."""
    right = scale.reading(verdict.value)
    tolerance = verdict.tolerance
    if tolerance.endswith("%"):
        tolerance += " of what it stands for"
    diagnoses = tuple(
        _rounded(said, right) if one.mistake == ROUNDED else one for one in verdict.diagnoses
    )
    return verdict._replace(
        value=right,
        unit=scale.text,
        claimed=said.value,
        claimed_unit=scale.text,
        ratio=None,
        tolerance=tolerance,
        diagnoses=diagnoses,
        uncertainty=verdict.uncertainty / abs(scale.slope(right)),
        claimed_uncertainty=said.uncertainty,
    )


def _as_answered(verdict: Verdict, found: Diagnosis) -> Step:
    """How the likeliest mistake leads from the right value to the answer."""
    sizes = (verdict.value, verdict.ratio, verdict.claimed)
    right, ratio, claimed = map(format_number, sizes)
    numbers = f"{with_unit(right, verdict.unit)} * {ratio} = {with_unit(claimed, verdict.unit)}"
    return Step(f"as it was answered: {found.done}", "", numbers)


def _rounded(said: Claim, right: float) -> Diagnosis:
    """The answer is the right one, in fewer digits than the tolerance asks for."""
    digits = next(
        (n for n in range(1, said.digits) if float(f"{right:.{n}g}") == said.value), said.digits
    )
    told = "the digit" if digits == 1 else f"the {digits} digits"
    nearer = f"{right:.{max(3, digits + 1)}g}"
    return Diagnosis(ROUNDED, f"to {told} given", f"{nearer} is nearer")


def _marked(question: Question, said: Claim, target: Value, unit: Unit) -> Diagnosis | None:
    """That the answer is what a camera is marked with for the right value, as 1/125 for 1/128 s."""
    name = CAMERA_SCALES.get(target.name)
    if question.command != "ev" or name is None:
        return None
    from radcalc.laws.exposure import mark

    exact = mark(name, float(target.amount))
    if exact is None or not math.isclose(said.value * unit.factor, exact, rel_tol=1e-9):
        return None
    return Diagnosis(ROUNDED, "as cameras are marked, in rounded numbers", "whole stops are exact")


def _wrong_unit(said: Claim, target: Value, unit: str, is_near: bool) -> Diagnosis:
    """The answer's unit measures something else than the result."""
    number = "the number would be right" if is_near else "check both"
    return Diagnosis(
        "wrong-unit",
        f"{describe(measured_in(said.unit, target.name))} is not {target.label}; {number}",
        f"{target.label} is in {unit}",
    )


def _target(question: Question, said: Claim, tolerance: str) -> tuple[Value, str, bool]:
    """The result that is meant, the unit to compare in, and whether the unit is of another.

    Without a name it is the first that has that unit; where the number fits only another one,
    nothing can be said before it is named.
    """
    told = option("check", quote(said.text))
    pool = _named(question, said) if said.name else _unnamed(question)
    if not said.unit:
        if len({value.name for value in pool}) > 1 or len(set(pool[0].units)) != 1:
            missing = "in which unit" if said.name else "which result is meant"
            raise ConditionError(f"{told}: say {missing}", _ways(pool, said))
        return pool[0], pool[0].units[0], False
    unit = measured_in(said.unit, *(value.name for value in pool))
    fitting = [value for value in pool if said.unit in value.units] or [
        value for value in pool if unit.dimension in (*value.dimensions, *value.reach)
    ]
    if fitting:
        holding = [value for value in fitting if _holds(value, unit, said, tolerance)]
        if holding and fitting[0] not in holding:
            raise ConditionError(
                f"{told} would be right for {holding[0].name}: say which result is meant",
                _ways([fitting[0], *holding], said),
            )
        return fitting[0], said.unit, False
    for value in pool:  # the one that the number fits, if any
        for text in value.units:
            if _holds(value, measured_in(text, value.name), said, tolerance):
                return value, text, True
    return pool[0], pool[0].units[0], True


def _named(question: Question, said: Claim) -> list[Value]:
    """The results of a name."""
    named = [value for value in question.answer.values if said.name in (value.name, value.also)]
    shown = [value for value in named if not value.is_absent]
    if shown:
        return shown
    if named:
        pick(named, said.name)  # which says what it lacks
    names = dict.fromkeys(v.name for v in question.answer.values if not v.is_absent)
    missing = f"{option('check')}: there is no result '{quote(said.name)}'"
    raise ConditionError(missing, ", ".join(names))


def _unnamed(question: Question) -> list[Value]:
    """The results that a number alone may mean: what follows, then what was given."""
    shown = [v for v in question.answer.values if not v.is_absent and v.name not in REMARKS]
    if not shown:
        raise ConditionError(f"{option('check')}: there is nothing to check", "less of it given")
    asked = ASKED.get(question.command, ())
    return sorted(shown, key=lambda value: (value.given is not None, value.name not in asked))


def _holds(value: Value, unit: Unit, said: Claim, tolerance: str) -> bool:
    right = in_unit(value, unit)
    return isinstance(right, float) and read_tolerance(tolerance, unit).holds(said.value, right)


def _ways(values: Sequence[Value], said: Claim) -> str:
    """How the answer can be said clearly."""
    ways = [
        option("check", f"{value.name}={said.number}{unit.replace(' ', '.').removeprefix('1')}")
        for value in values
        for unit in ([said.unit] if said.unit else value.units)
    ]
    return ", ".join([*dict.fromkeys(ways)][:WAYS])
