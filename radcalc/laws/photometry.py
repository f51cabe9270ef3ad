"""Photometry of cameras and of dim light: exposure values, and mesopic luminance.

The lens of a camera is focused at infinity.  K and C are the light meter's constants, and
rho = pi K / C is the reflectance of its average scene.  A filter of the density D has D / lg 2
stops.  At the saturation luminance a sensor of saturation-based speed is full.  Cameras are marked
in thirds of a stop with rounded numbers, for which `exact` returns the exact ones: 2^-7 s for
1/125, and the root of 2^7 for f/11.  So two values of a symbol may differ by `STEPS`.

Mesopic luminance is that between night and day, in the recommended system of CIE 191:2010 (MES2).
Luminances [cd/m2] are those of the adaptation field.  The mesopic luminance is found by bisection,
because the adaptation depends on it.
"""

import math
from collections.abc import Callable
from typing import Any

from radcalc.errors import ConditionError
from radcalc.laws import AnyLaw, At, law, relation
from radcalc.maths import Number, any_true, each, limit, log2, power, sqrt, square
from radcalc.quantities.symbols import SYMBOLS
from radcalc.units.scale_table import ILLUMINANCE_EV, LUMINANCE_EV

SATURATION = 1.2  # saturation luminance [cd s/m2] at ISO 100; ISO 2720 and 12232
# The marks of cameras, a third of a stop apart; scantips.com, Charts of Nominal, and Exact Precise
# Actual camera shutter speed, f/stop and ISO values.
F_NUMBERS = """
    1 1.1 1.2 1.4 1.6 1.8 2 2.2 2.5 2.8 3.2 3.5 4 4.5 5 5.6 6.3 7.1 8 9 10 11 13 14 16 18 20 22 25
    29 32 36 40 45 51 57 64
"""  # from 1, the roots of 2^(0/3), 2^(1/3) ...
FRACTIONS = """
    8000 6400 5000 4000 3200 2500 2000 1600 1250 1000 800 640 500 400 320 250 200 160 125 100 80 60
    50 40 30 25 20 15 13 10 8 6 5 4 3 2.5 2 1.6 1.3
"""  # 1/s, from 2^-13 s
LONG_TIMES = "1 1.3 1.6 2 2.5 3.2 4 5 6 8 10 13 15 20 25 30"  # s
DECIMALS = {"0.3": -5, "0.4": -4, "0.6": -2, "0.8": -1}  # s, other marks for these thirds
SPEEDS = """
    6 8 10 12 16 20 25 32 40 50 64 80 100 125 160 200 250 320 400 500 640 800 1000 1250 1600 2000
    2500 3200 4000 5000 6400 8000 10000 12800 16000 20000 25600
"""  # from 100 2^(-12/3)
_TIMES = {
    **{1 / float(mark): 2 ** (k / 3 - 13) for k, mark in enumerate(FRACTIONS.split())},
    **{float(mark): 2 ** (k / 3) for k, mark in enumerate(LONG_TIMES.split())},
    **{float(mark): 2 ** (k / 3) for mark, k in DECIMALS.items()},
}
MARKS = {  # exact values of the marks
    "time": _TIMES,
    "unfiltered-time": _TIMES,
    "f-number": {float(mark): 2 ** (k / 6) for k, mark in enumerate(F_NUMBERS.split())},
    "iso": {float(mark): 100 * 2 ** (k / 3 - 4) for k, mark in enumerate(SPEEDS.split())},
}
SAME_MARK = 1e-4  # relative difference of numbers typed for a mark: 0.0167 s for 1/60 s is not one
STEPS = {"ev": 0.1, "ev100": 0.1}  # [stops] largest difference of marked from exact values


def exact(name: str, value: float) -> float:
    """Return the exact value of a number as marked on cameras, or another number unchanged.

    Parameters
    ----------
    name : str
        The symbol: ``"time"``, ``"unfiltered-time"``, ``"f-number"`` or ``"iso"``.
    value : float
        A time [s], f-number [1] or film speed [1].

    Returns
    -------
    float
        The exact number of the mark, in the same unit.

    Examples
    --------
    >>> exact("time", 1 / 125) == 2**-7, exact("f-number", 5.7)
    (True, 5.7)
    """
    for mark, meant in MARKS.get(name, {}).items():
        if abs(value - mark) <= SAME_MARK * mark:
            return meant
    return value


REFLECTED = relation(
    "reflected light",
    "{luminance} = {k} 2^{ev100} / 100",
    {
        "luminance": lambda at: LUMINANCE_EV.of_meter(at("k")).quantity(at("ev100")),
        "ev100": lambda at: LUMINANCE_EV.of_meter(at("k")).reading(at("luminance")),
    },
    "ISO 2720",
)
INCIDENT = relation(
    "incident light",
    "{illuminance} = {c} 2^{ev100} / 100",
    {
        "illuminance": lambda at: ILLUMINANCE_EV.of_meter(at("c")).quantity(at("ev100")),
        "ev100": lambda at: ILLUMINANCE_EV.of_meter(at("c")).reading(at("illuminance")),
    },
    "ISO 2720",
)
REFLECTANCE = law(
    "reflectance of the scene",
    "{luminance} = {reflectance} {illuminance} / (pi Omega0)",
    "ISO 80000-7, reflectance",
)
EV100 = relation(
    "exposure value at ISO 100",
    "{ev100} = {ev} - log2({iso} / 100)",
    {
        "ev100": lambda at: at("ev") - log2(at("iso") / 100),
        "ev": lambda at: at("ev100") + log2(at("iso") / 100),
        "iso": lambda at: 100 * power(2.0, at("ev") - at("ev100")),
    },
    "ISO 2720",
)
EXPOSURE_LAWS: list[AnyLaw] = [
    law(
        "setting of the camera",
        "{exposure-setting} = {f-number}^2 / {time}",
        "ISO 2720",
        unit="cycle",
    ),
    relation(
        "exposure value",
        "{ev} = log2({exposure-setting} / 1 Hz)",
        {
            "ev": lambda at: log2(at("exposure-setting")),
            "exposure-setting": lambda at: power(2.0, at("ev")),
        },
        "ISO 2720",
    ),
    EV100,
    REFLECTED,
    INCIDENT,
    relation(
        "saturation",
        "{saturation-luminance} = 1.2 cd/m2 2^{ev100}",
        {"saturation-luminance": lambda at: SATURATION * power(2.0, at("ev100"))},
        "ISO 12232, saturation-based speed",
    ),
]

# With a neutral filter in front of the lens.
DENSITY = law(
    "stops of a filter", "{nd} = {stops} lg2", "ISO 5-2, transmittance density", math.log10(2)
)
FILTERED: list[AnyLaw] = [
    *(law for law in EXPOSURE_LAWS if law is not EV100),
    relation(
        "exposure value at ISO 100, behind a filter",
        "{ev100} = {ev} - log2({iso} / 100) + {stops}",
        {
            "ev100": lambda at: at("ev") - log2(at("iso") / 100) + at("stops"),
            "ev": lambda at: at("ev100") + log2(at("iso") / 100) - at("stops"),
            "iso": lambda at: 100 * power(2.0, at("ev") - at("ev100") + at("stops")),
            "stops": lambda at: at("ev100") - at("ev") + log2(at("iso") / 100),
        },
        "ISO 2720",
    ),
    DENSITY,
    relation(
        "time behind a filter",
        "{time} = {unfiltered-time} 2^{stops}",
        {
            "time": lambda at: at("unfiltered-time") * power(2.0, at("stops")),
            "unfiltered-time": lambda at: at("time") * power(2.0, -at("stops")),
            "stops": lambda at: log2(at("time") / at("unfiltered-time")),
        },
        "ISO 2720",
    ),
]
# For a filter of unknown density.
UNFILTERED = relation(
    "exposure without the filter",
    "{ev100} = log2({f-number}^2 / ({unfiltered-time} 1 Hz)) - log2({iso} / 100)",
    {
        "ev100": lambda at: (
            log2(square(at("f-number")) / at("unfiltered-time")) - log2(at("iso") / 100)
        ),
        "f-number": lambda at: sqrt(
            power(2.0, at("ev100")) * at("unfiltered-time") * (at("iso") / 100)
        ),
        "unfiltered-time": lambda at: (
            square(at("f-number")) / (power(2.0, at("ev100")) * (at("iso") / 100))
        ),
        "iso": lambda at: (
            100 * square(at("f-number")) / (power(2.0, at("ev100")) * at("unfiltered-time"))
        ),
    },
    "ISO 2720",
)


def _guide_number(name: str, template: str, filtered: bool) -> AnyLaw:
    """Return the law of guide number, distance, f-number and speed, with or without a filter."""

    def lost(at: At) -> Any:
        return power(2.0, at("stops") / 2) if filtered else 1.0

    solvers: dict[str, Callable[[At], Any]] = {
        "guide-number": lambda at: (
            10 * at("distance") * at("f-number") * lost(at) / sqrt(at("iso"))
        ),
        "distance": lambda at: (
            at("guide-number") * sqrt(at("iso")) / (10 * at("f-number") * lost(at))
        ),
        "f-number": lambda at: (
            at("guide-number") * sqrt(at("iso")) / (10 * at("distance") * lost(at))
        ),
        "iso": lambda at: square(
            10 * at("distance") * at("f-number") * lost(at) / at("guide-number")
        ),
    }
    if filtered:
        solvers["stops"] = lambda at: (
            2 * log2(at("guide-number") * sqrt(at("iso")) / (10 * at("distance") * at("f-number")))
        )
    return relation(name, template, solvers, "ISO 1230")


FLASH: list[AnyLaw] = [
    _guide_number("guide number", "{guide-number} = {distance} {f-number} sqrt(100 / {iso})", False)
]
FILTERED_FLASH: list[AnyLaw] = [
    _guide_number(
        "guide number, behind a filter",
        "{guide-number} = {distance} {f-number} sqrt(100 / {iso}) 2^({stops}/2)",
        True,
    ),
    DENSITY,
]


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


def mesopic_luminance(luminance: float, ratio: float) -> tuple[float, float]:
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
    >>> mesopic, m = mesopic_luminance(0.1, 2.0)
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
            lambda luminance, ratio: mesopic_luminance(luminance, ratio)[0],
            at("luminance"),
            at("sp-ratio"),
        ),
        "luminance": _photopic_luminance,
        "sp-ratio": _sp_ratio,
    },
    SOURCE,
)
MESOPIC_LAWS: list[AnyLaw] = [MESOPIC, ADAPTATION, SCOTOPIC]
