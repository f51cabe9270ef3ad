"""The light meter: exposure values, and the luminances and illuminances that they mean.

The lens is focused at infinity.  K and C are the meter's constants: rho = pi K / C is the
reflectance of its average scene.  A filter of the density D has D / lg 2 stops.  At the saturation
luminance a sensor of saturation-based speed is full.

Cameras are marked in whole stops with rounded numbers, which `mark` returns: 1/125 for 2^-7 s, and
f/11 for the root of 2^7.  So two values of a symbol may differ by `STEPS`.
"""

import math
from collections.abc import Callable
from typing import Any

from radcalc.laws.law import AnyLaw, At, law, relation
from radcalc.maths import log2, power, sqrt, square
from radcalc.units.scale_table import ILLUMINANCE_EV, LUMINANCE_EV

SATURATION = 1.2  # saturation luminance [cd s/m2] at ISO 100; ISO 2720 and 12232
# Marks for 2^-13 s to 2^5 s, and for f-numbers of 2^(0/2) to 2^(12/2); scantips.com, Charts of
# Nominal, and Exact Precise Actual camera shutter speed, f/stop and ISO values.
TIMES = (8000, 4000, 2000, 1000, 500, 250, 125, 60, 30, 15, 8, 4, 2)  # 1/s
LONG_TIMES = (1, 2, 4, 8, 15, 30)  # s
F_NUMBERS = (1, 1.4, 2, 2.8, 4, 5.6, 8, 11, 16, 22, 32, 45, 64)
MARKS = {
    "time": dict(enumerate((*(1 / t for t in TIMES), *LONG_TIMES), -len(TIMES))),
    "f-number": dict(enumerate(F_NUMBERS)),
}
STOPS = {"time": 1.0, "f-number": 2.0}  # stops that double the number
OFF_MARK = 0.05  # [stops] largest difference of a value from a whole number of stops
STEPS = {"ev": 0.1, "ev100": 0.1}  # [stops] largest difference of marked from exact values


def mark(name: str, value: float) -> float | None:
    """Return a camera's mark for a time or an f-number of whole stops.

    Parameters
    ----------
    name : str
        The symbol: ``"time"`` or ``"f-number"``.
    value : float
        The exact time [s] or f-number [1].

    Returns
    -------
    float or None
        The number of the mark, in the same unit; None if there is no mark.

    Examples
    --------
    >>> mark("f-number", 2**2.5)
    5.6
    """
    if name not in MARKS or value <= 0:
        return None
    stops = STOPS[name] * math.log2(value)
    return MARKS[name].get(round(stops)) if abs(stops - round(stops)) < OFF_MARK else None


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
LAWS: list[AnyLaw] = [
    law(
        "exposure of a lens", "{exposure-setting} = {f-number}^2 / {time}", "ISO 2720", unit="cycle"
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
    "stops of a filter", "{nd} = lg2 {stops}", "ISO 5-2, transmittance density", math.log10(2)
)
FILTERED: list[AnyLaw] = [
    *(law for law in LAWS if law is not EV100),
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


def _guide_number(name: str, template: str, filtered: bool) -> AnyLaw:
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
