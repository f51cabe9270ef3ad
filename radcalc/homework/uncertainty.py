"""Answers where values are uncertain: how near is near enough, and whether their ± is right.

What people do with uncertainties in place of adding their squares is recognised.
"""

import math
from typing import Any

from radcalc.answer import Value
from radcalc.calculators.results import in_unit
from radcalc.derivation import format_number, with_unit
from radcalc.homework.answer import Claim, Diagnosis, Tolerance
from radcalc.homework.question import Question
from radcalc.units.unit import Unit

NEAR = 0.05  # of an uncertainty, which has two digits at most
WRONG = "uncertainty"  # the mistake that has no better name
EXACT = "the right value has none"
SQUARES = "independent uncertainties add as squares"
SLOPES = "each uncertainty counts with the slope of the result: of 1/d^2 twice the part of d"


def of_result(question: Question, target: Value, unit: Unit) -> Any:
    """A result with its uncertainty, of the `uncertainties` package, or a float without."""
    if question.uncertain is None:
        return 0.0
    values = zip(question.answer.values, question.uncertain.values, strict=True)
    return next(in_unit(other, unit) for value, other in values if value is target)


def tolerance(off: float, unit: str) -> Tolerance:
    """The standard uncertainty of the right value."""
    return Tolerance(f"within {_in(off, unit)}, the standard uncertainty", "absolute", off)


def judge(number: Any, claim: Claim, unit: str, allowed: float) -> tuple[Diagnosis, ...]:
    """What is wrong with the uncertainty that an answer claims; nothing where that is right.

    Of an exact result it may be as large as the answer was `allowed` to be off, in the `unit`.
    """
    off, claimed = getattr(number, "std_dev", 0.0), claim.uncertainty
    if not off:
        too_large = claimed > allowed
        return (Diagnosis(WRONG, "an uncertainty is claimed", EXACT),) if too_large else ()
    if not claimed or _is_near(claimed, off):
        return ()
    right = f"it is {_in(off, unit)}"
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
        ("uncertainty-expanded", 2 * off, "that is twice it, for k = 2", "k = 1 is asked for"),
        ("uncertainty-slope", without_slopes, "parts of the inputs were added as they are", SLOPES),
        *(
            ("uncertainty-left-out", part, "only one input's uncertainty was counted", SQUARES)
            for part in parts
            if len(parts) > 1
        ),
    ]
    for name, size, done, why in mistakes:
        if _is_near(claimed, size):
            return (Diagnosis(name, done, f"{why}: {right}"),)
    return (Diagnosis(WRONG, "the uncertainty is another one", right),)


def _in(size: float, unit: str) -> str:
    """An uncertainty with two digits in its unit: 0.28 fc, 100 lx."""
    return with_unit(format_number(float(f"{size:.2g}")), unit)


def _is_near(claimed: float, size: float) -> bool:
    """Whether an uncertainty is that one, or that one rounded to a digit."""
    return abs(claimed - size) <= NEAR * size or claimed == float(f"{size:.1g}")
