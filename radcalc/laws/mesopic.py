"""Mesopic luminance: the recommended system of CIE 191:2010 (MES2)."""

import math
from typing import Any

from radcalc.errors import ConditionError
from radcalc.laws.law import AnyLaw, At, law, relation

# m = A + B log10 L_mes, and V'(lambda0) = 683/1699 at 555 nm; CIE 191:2010.
A, B, SCOTOPIC_AT_555 = 0.7670, 0.3334, 683 / 1699
PHOTOPIC_FROM, SCOTOPIC_TO = 5.0, 0.005  # cd/m2
SOURCE = "CIE 191:2010"


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


def _luminance(at: At) -> Any:
    """The photopic luminance, from the mesopic one and the ratio."""
    mesopic = at("mesopic-luminance")
    m = adaptation(mesopic)
    night = (1 - m) * SCOTOPIC_AT_555
    return mesopic * (m + night) / (m + night * at("sp-ratio"))


def _ratio(at: At) -> Any:
    """The S/P ratio, from the mesopic luminance and the photopic one."""
    mesopic, luminance = at("mesopic-luminance"), at("luminance")
    m = adaptation(mesopic)
    night = (1 - m) * SCOTOPIC_AT_555
    ratio = (mesopic * (m + night) / luminance - m) / night if night else -1.0
    if ratio <= 0:
        raise ConditionError(
            "no S/P ratio leads from that luminance to that mesopic luminance",
            "luminances nearer to each other, below 5 cd/m2",
        )
    return ratio


SCOTOPIC = law("scotopic luminance", "{scotopic-luminance} = {sp-ratio} {luminance}")
ADAPTATION = relation(
    "adaptation of the eye",
    "{adaptation} = 0.7670 + 0.3334 log10({mesopic-luminance} m2/cd), from 0 to 1",
    {"adaptation": lambda at: adaptation(at("mesopic-luminance"))},
    SOURCE,
)
MESOPIC = relation(
    "mesopic luminance",
    "{mesopic-luminance} = (m {luminance} + (1 - m) {sp-ratio} {luminance} V0) / "
    "(m + (1 - m) V0), V0 = 683/1699",
    {
        "mesopic-luminance": lambda at: solve(at("luminance"), at("sp-ratio"))[0],
        "luminance": _luminance,
        "sp-ratio": _ratio,
    },
    SOURCE,
)
LAWS: list[AnyLaw] = [MESOPIC, ADAPTATION, SCOTOPIC]
