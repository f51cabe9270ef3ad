"""The light meter: exposure values, and what light they stand for.

- exposure of a lens: b = N^2 / t, with the f-number N and the time t [s]
- exposure value: EV = log2(b / 1 Hz)
- exposure value at ISO 100: EV100 = EV - log2(S / 100), with the ISO speed S
- reflected light: L = K 2^EV100 / 100, [cd/m2], with K = 12.5 cd s/m2 unless it is given
- incident light: E = C 2^EV100 / 100, [lx], with C = 250 lx s unless it is given
- `REFLECTANCE` of a scene that is not the meter's average one: L = rho E / (pi Omega0), which is
  rho = pi K / C on average
- saturation: L_sat = 1.2 cd/m2 2^EV100, where a sensor of saturation-based speed is full

For a lens focused far away, without a filter.  Marked values are rounded, so that what is given
twice may differ by `STEPS`.  Source: ISO 2720 (meters), ISO 12232 (saturation-based speed).
"""

from radcalc.laws.law import AnyLaw, law, relation
from radcalc.maths import log2

K, C = 12.5, 250.0  # cd s/m2 and lx s: what most makers of meters use
SATURATION = 1.2  # saturation luminance [cd s/m2] at ISO 100, of ISO 2720 and 12232
STEPS = {"ev": 0.1, "ev100": 0.1}  # by which marked values differ from exact ones
REFLECTED = relation(
    "reflected light",
    "{luminance} = {k} 2^{ev100} / 100",
    {
        "luminance": lambda at: at("k") / 100 * 2.0 ** at("ev100"),
        "ev100": lambda at: log2(at("luminance") * 100 / at("k")),
    },
    "ISO 2720",
)
INCIDENT = relation(
    "incident light",
    "{illuminance} = {c} 2^{ev100} / 100",
    {
        "illuminance": lambda at: at("c") / 100 * 2.0 ** at("ev100"),
        "ev100": lambda at: log2(at("illuminance") * 100 / at("c")),
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
