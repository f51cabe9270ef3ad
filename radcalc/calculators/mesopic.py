"""Mesopic luminance: the recommended system of CIE 191:2010 (MES2)."""

import math

from radcalc.answer import Answer, Step, Value
from radcalc.errors import ConditionError
from radcalc.quantities.light import LUMINOUS, light_dimension
from radcalc.units.table import NUMBER

LUMINANCE = light_dimension(LUMINOUS, (0, 1, 1), "")
# m = A + B log10 L_mes, and V'(lambda0) = 683/1699 at 555 nm; CIE 191:2010.
A, B, SCOTOPIC_AT_555 = 0.7670, 0.3334, 683 / 1699
HIGHEST_RATIO = 73.0  # no wavelength of the tables has more
PHOTOPIC_FROM, SCOTOPIC_TO = 5.0, 0.005  # cd/m2


def mixture(luminance: float, scotopic: float, m: float) -> float:
    """Mesopic luminance [cd/m2] for an adaptation coefficient m from 0 to 1."""
    night = (1 - m) * SCOTOPIC_AT_555
    return (m * luminance + night * scotopic) / (m + night)


def adaptation(mesopic: float) -> float:
    """The adaptation coefficient that a mesopic luminance [cd/m2] goes with."""
    if mesopic >= PHOTOPIC_FROM:
        return 1.0
    if mesopic <= SCOTOPIC_TO:
        return 0.0
    return min(1.0, max(0.0, A + B * math.log10(mesopic)))


def solve(luminance: float, ratio: float) -> tuple[float, float]:
    """Mesopic luminance [cd/m2] and m, where each follows from the other.

    The excess of m over the adaptation that it leads to changes sign once between 0 and 1, so
    it is halved in until the two agree to the last digit.
    """
    scotopic = ratio * luminance

    def excess(m: float) -> float:
        return m - adaptation(mixture(luminance, scotopic, m))

    low, high = 0.0, 1.0
    if excess(low) >= 0:
        return mixture(luminance, scotopic, low), low
    if excess(high) <= 0:
        return mixture(luminance, scotopic, high), high
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    return mixture(luminance, scotopic, high), high


def mesopic(luminance: float, ratio: float) -> Answer:
    """Mesopic luminance from photopic luminance [cd/m2] and the S/P ratio of the light."""
    if not 0 < luminance <= 1e12:
        raise ConditionError("the luminance is not possible here", "more than 0, up to 1e12 cd/m2")
    if not 0 < ratio <= HIGHEST_RATIO:
        raise ConditionError(f"an S/P ratio of {ratio:g} is not possible", "more than 0, up to 73")
    seen, m = solve(luminance, ratio)
    values = [
        Value("mesopic-luminance", "mesopic luminance", "L_mes", seen, (LUMINANCE,), ("cd/m2",)),
        Value("adaptation", "adaptation coefficient", "m", m, (NUMBER,), ("1",)),
        Value("luminance", "luminance", "L_v", luminance, (LUMINANCE,), ("cd/m2",)),
        Value(
            "scotopic-luminance",
            "scotopic luminance",
            "L'",
            ratio * luminance,
            (LUMINANCE,),
            ("cd/m2",),
        ),
        Value("sp-ratio", "scotopic/photopic ratio", "S/P", ratio, (NUMBER,), ("1",)),
    ]
    notes = []
    if m == 1:
        notes.append("photopic vision: from 5 cd/m2 on, m is 1")
    if m == 0:
        notes.append("scotopic vision: up to 0.005 cd/m2, m is 0")
    step = Step(
        "mesopic luminance",
        "L_mes = (m L + (1 - m) L' V0) / (m + (1 - m) V0), m = 0.7670 + 0.3334 log10 L_mes",
        f"L_mes = {seen:.6g} cd/m2, m = {m:.6g}, with L = {luminance:.6g} cd/m2, "
        f"L' = {ratio * luminance:.6g} cd/m2, V0 = 683/1699",
        "CIE 191:2010",
    )
    return values, ["the recommended system of CIE 191:2010 (MES2)"], notes, [step]
