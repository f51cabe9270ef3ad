"""Checks of answers with uncertainties: the tolerance of the value, and the claimed ±."""

import math
from typing import Any

from radcalc.answer import Value
from radcalc.calculators.results import in_unit
from radcalc.derivation import format_number, with_unit
from radcalc.homework.answer import Claim, Diagnosis, Tolerance
from radcalc.homework.question import Question
from radcalc.homework.wording import Translatable
from radcalc.units.unit import Unit

NEAR = 0.05  # of an uncertainty, which has two digits at most
WRONG = "uncertainty"  # a mistake without a more specific name
EXACT = "the right value has no uncertainty"
SQUARES = "the squares of independent uncertainties add up"
SLOPES = "each uncertainty is multiplied by a slope: the relative one of 1/d^2 is twice that of d"


def of_result(question: Question, target: Value, unit: Unit) -> Any:
    """Return a result with its uncertainty (as `uncertainties` has it), or 0 without one."""
    if question.uncertain is None:
        return 0.0
    values = zip(question.answer.values, question.uncertain.values, strict=True)
    return next(in_unit(other, unit) for value, other in values if value is target)


def tolerance(off: float, unit: str) -> Tolerance:
    """Return a tolerance of one standard uncertainty."""
    text = Translatable("within {0}, the standard uncertainty", _in(off, unit))
    return Tolerance(text, "absolute", off)


def judge(number: Any, claim: Claim, unit: str, allowed: float) -> tuple[Diagnosis, ...]:
    """Return the mistake in a claimed uncertainty, or nothing if it is right.

    For an exact result it may be as large as the tolerance `allowed`, in the `unit`.
    """
    off, claimed = getattr(number, "std_dev", 0.0), claim.uncertainty
    if not off:
        too_large = claimed > allowed
        return (Diagnosis(WRONG, "an uncertainty is claimed", EXACT),) if too_large else ()
    if not claimed or _is_near(claimed, off):
        return ()
    right = Translatable("it is {0}", _in(off, unit))
    components = number.error_components()
    parts = [abs(size) for size in components.values()]
    sizes = [
        component.std_dev / component.nominal_value
        for component in components
        if component.nominal_value
    ]
    without_slopes = abs(number.nominal_value) * math.hypot(*sizes)
    mistakes = [
        ("uncertainties-added", sum(parts), "the uncertainties were added up", SQUARES),
        (
            "uncertainty-expanded",
            2 * off,
            "the expanded uncertainty (k = 2) was used",
            "the standard uncertainty (k = 1) is required",
        ),
        (
            "uncertainty-slope",
            without_slopes,
            "the relative uncertainties of the inputs were combined without their slopes",
            SLOPES,
        ),
        *(
            ("uncertainty-left-out", part, "only one input's uncertainty was counted", SQUARES)
            for part in parts
            if len(parts) > 1
        ),
    ]
    for name, size, done, why in mistakes:
        if _is_near(claimed, size):
            return (Diagnosis(name, done, Translatable("{0}: it is {1}", why, _in(off, unit))),)
    return (Diagnosis(WRONG, "the uncertainty is wrong", right),)


def _in(size: float, unit: str) -> str:
    """Format an uncertainty with two digits and its unit: 0.28 fc, 100 lx."""
    return with_unit(format_number(float(f"{size:.2g}")), unit)


def _is_near(claimed: float, size: float) -> bool:
    """Return whether an uncertainty is near another one, or equal to it rounded to one digit."""
    return abs(claimed - size) <= NEAR * size or claimed == float(f"{size:.1g}")
