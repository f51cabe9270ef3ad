"""The light meter: exposure values, and what light they stand for.

- exposure of a lens: b = N^2 / t, with the f-number N and the time t [s]
- exposure value: EV = log2(b / 1 Hz)
- exposure value at ISO 100: EV100 = EV - log2(S / 100), with the ISO speed S
- reflected light: L = K 2^EV100 / 100, [cd/m2], with the meter's constant K
- incident light: E = C 2^EV100 / 100, [lx], with the meter's constant C
- `REFLECTANCE` of a scene that is not the meter's average one: L = rho E / (pi Omega0), which is
  rho = pi K / C on average
- saturation: L_sat = 1.2 cd/m2 2^EV100, where a sensor of saturation-based speed is full

For a lens focused far away, without a filter.  Marked values are rounded, so that what is given
twice may differ by `STEPS`.  Source: ISO 2720 (meters), ISO 12232 (saturation-based speed).
"""

from radcalc.laws.law import AnyLaw, law, relation
from radcalc.maths import log2
from radcalc.units.scales import ILLUMINANCE_EV, LUMINANCE_EV

SATURATION = 1.2  # saturation luminance [cd s/m2] at ISO 100, of ISO 2720 and 12232
STEPS = {"ev": 0.1, "ev100": 0.1}  # by which marked values differ from exact ones
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
LAWS: list[AnyLaw] = [
    law("exposure of a lens", "{light} = {f-number}^2 / {time}", "ISO 2720", unit="cycle"),
    relation(
        "exposure value",
        "{ev} = log2({light} / 1 Hz)",
        {"ev": lambda at: log2(at("light")), "light": lambda at: 2.0 ** at("ev")},
        "ISO 2720",
    ),
    relation(
        "exposure value at ISO 100",
        "{ev100} = {ev} - log2({iso} / 100)",
        {
            "ev100": lambda at: at("ev") - log2(at("iso") / 100),
            "ev": lambda at: at("ev100") + log2(at("iso") / 100),
            "iso": lambda at: 100 * 2.0 ** (at("ev") - at("ev100")),
        },
        "ISO 2720",
    ),
    REFLECTED,
    INCIDENT,
    relation(
        "saturation",
        "{saturation-luminance} = 1.2 cd/m2 2^{ev100}",
        {"saturation-luminance": lambda at: SATURATION * 2.0 ** at("ev100")},
        "ISO 12232, saturation-based speed",
    ),
]
