"""Mesopic luminance, between night and day: the recommended system of CIE 191:2010 (MES2).

Luminances [cd/m2] are those of the adaptation field.  The mesopic luminance is found by bisection,
because the adaptation depends on it.
"""

import math
from typing import Any

from radcalc.errors import ConditionError
from radcalc.laws.law import AnyLaw, At, law, relation
from radcalc.maths import Number, any_true, each, limit
from radcalc.quantities.symbols import SYMBOLS

# m = A + B log10 L_mes, and V'(lambda0) = 683/1699 at 555 nm; CIE 191:2010.
A, B, SCOTOPIC_AT_555 = 0.7670, 0.3334, 683 / 1699
PHOTOPIC_FROM, SCOTOPIC_TO = 5.0, 0.005  # cd/m2
SOURCE = "CIE 191:2010"


def mixture(luminance: float, scotopic: float, m: float) -> float:
    """Return the mesopic luminance for a known adaptation.

    Parameters
    ----------
    luminance, scotopic : float [cd/m2]
        The photopic and the scotopic luminance.
    m : float [1]
        The adaptation coefficient, from 0 (night) to 1 (day).

    Returns
    -------
    float [cd/m2]
        Between the two luminances.

    Notes
    -----
    ::

        L_mes = (m L + (1 - m) V0 L') / (m + (1 - m) V0),  V0 = 683/1699

    References
    ----------
    CIE 191:2010.

    Examples
    --------
    >>> mixture(0.1, 0.2, 1.0), mixture(0.1, 0.2, 0.0)
    (0.1, 0.2)
    """
    night = (1 - m) * SCOTOPIC_AT_555
    return (m * luminance + night * scotopic) / (m + night)


def adaptation(mesopic: Number) -> Number:
    """Return the adaptation coefficient for a mesopic luminance.

    Parameters
    ----------
    mesopic : float or ndarray [cd/m2]
        More than 0.

    Returns
    -------
    float or ndarray [1]
        0 up to 0.005 cd/m2, 1 from 5 cd/m2 on.

    Notes
    -----
    ::

        m = 0.7670 + 0.3334 log10(L_mes m2/cd)

    References
    ----------
    CIE 191:2010.

    Examples
    --------
    >>> adaptation(0.001), round(adaptation(0.1), 4), adaptation(10.0)
    (0.0, 0.4336, 1.0)
    """
    return each(_adaptation, mesopic)


def _adaptation(mesopic: float) -> float:
    if mesopic >= PHOTOPIC_FROM:
        return 1.0
    if mesopic <= SCOTOPIC_TO:
        return 0.0
    return min(1.0, max(0.0, A + B * math.log10(mesopic)))


def solve(luminance: float, ratio: float) -> tuple[float, float]:
    """Return the mesopic luminance and the adaptation coefficient, which depend on each other.

    Parameters
    ----------
    luminance : float [cd/m2]
        The photopic luminance, more than 0.
    ratio : float [1]
        The light's ratio of scotopic to photopic luminance.

    Returns
    -------
    tuple of float [cd/m2], [1]
        The mesopic luminance, and m from 0 to 1.

    Notes
    -----
    The excess of m over the adaptation coefficient of its mesopic luminance changes sign once
    between 0 and 1, at a value that is found by bisection, to the last digit.

    References
    ----------
    CIE 191:2010.

    Examples
    --------
    >>> mesopic, m = solve(0.1, 2.0)
    >>> round(mesopic, 5), round(m, 5)
    (0.13096, 0.47266)
    """
    scotopic = ratio * luminance

    def excess(m: float) -> float:
        return m - _adaptation(mixture(luminance, scotopic, m))

    low, high = 0.0, 1.0
    if excess(low) >= 0:
        return mixture(luminance, scotopic, low), low
    if excess(high) <= 0:
        return mixture(luminance, scotopic, high), high
    m = limit(lambda m: excess(m) >= 0, low, high)
    return mixture(luminance, scotopic, m), m


def _photopic_luminance(at: At) -> Any:
    mesopic = at("mesopic-luminance")
    m = adaptation(mesopic)
    night = (1 - m) * SCOTOPIC_AT_555
    return mesopic * (m + night) / (m + night * at("sp-ratio"))


def _sp_ratio(at: At) -> Any:
    mesopic, luminance = at("mesopic-luminance"), at("luminance")
    m = adaptation(mesopic)
    night = (1 - m) * SCOTOPIC_AT_555
    if not any_true(night == 0):
        ratio = (mesopic * (m + night) / luminance - m) / night
        if not any_true((ratio <= 0) | (ratio > SYMBOLS["sp-ratio"].limits.high)):
            return ratio
    raise ConditionError(
        "the luminance and the mesopic luminance contradict each other: no S/P ratio fits both",
        "luminances nearer to each other, below 5 cd/m2",
    )


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
        "mesopic-luminance": lambda at: each(
            lambda luminance, ratio: solve(luminance, ratio)[0], at("luminance"), at("sp-ratio")
        ),
        "luminance": _photopic_luminance,
        "sp-ratio": _sp_ratio,
    },
    SOURCE,
)
LAWS: list[AnyLaw] = [MESOPIC, ADAPTATION, SCOTOPIC]
