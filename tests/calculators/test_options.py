"""Every option of a calculator, added to every base: it is refused, or changes the answer."""

from typing import Any

from helpers import flagged, for_each

from radcalc import calorimeter, ev, lambertian, point_source
from radcalc.calculators import calorimeter as calorimeter_module
from radcalc.calculators import ev as ev_module
from radcalc.calculators import lambertian as lambertian_module
from radcalc.calculators import point_source as point_module
from radcalc.errors import RadcalcError
from radcalc.quantities.symbols import LINKS, REFINEMENTS, SYMBOLS

# A distribution may be given in addition to an option that implies it.
NAMED = ("distribution", "isotropic")
PLACED = [name for name in point_module.PAGE.takes if name not in NAMED]
POINT = (*PLACED, *LINKS, *REFINEMENTS)
SURFACES = (*lambertian_module.QUANTITIES, *lambertian_module.PAGE.takes, *LINKS, *REFINEMENTS)
CALORIMETER = (*calorimeter_module.QUANTITIES, *calorimeter_module.PAGE.takes)
EV = ev_module.PAGE.takes
EXAMPLE: dict[str, Any] = {
    "wavelength": "555nm", "spectrum": "D65", "efficacy": "93lm/W", "observer": "scotopic",
    "range": "400nm:700nm", "photon-range": "380nm:780nm", "k": "14cd.s/m2", "c": "320lx.s",
    "iso": "800", "absorptance": "0.9", "offset": "10cm", "offset-y": "10cm", "tilt": "10deg",
    "incidence": "10deg", "half-angle": "20deg", "apex-angle": "50deg", "hemisphere": True,
}  # fmt: skip
BASES: list[tuple[Any, tuple[str, ...], tuple[str, ...], dict[str, str]]] = [
    *(
        (point_source, (), POINT, base)
        for base in (
            {"flux": "800lm"},
            {"intensity": "100cd"},
            {"irradiance": "5lx"},
            {"exposure": "5lx.s"},
            {"energy": "5lm.s"},
            {"flux": "800lm", "distance": "2m"},
            {"irradiance": "5lx", "distance": "2m"},
            {"intensity": "100cd", "height": "6m"},
            {"intensity": "100cd", "height": "6m", "offset": "1m"},
            {"intensity": "100cd", "beam-angle": "30deg"},
            {"intensity": "100cd", "exponent": "3", "distance": "2m"},
            {"flux": "100lm", "half-angle": "30deg"},
            {"flux": "100lm", "half-angle": "30deg", "distance": "2m"},
            {"flux": "100lm", "spectrum": "D65"},
        )
    ),
    *((lambertian, ("patch",), SURFACES, base)
      for base in (
          {"radiance": "9cd/m2"}, {"irradiance": "9lx"}, {"exitance": "9lm/m2"},
          {"flux": "9lm"}, {"intensity": "9cd"}, {"energy": "9lm.s"},
          {"incident-irradiance": "9lx"}, {"radiance": "9cd/m2", "area": "1cm2"},
          {"radiance": "9cd/m2", "area": "1cm2", "distance": "1m"})),
    *((lambertian, (shape,), SURFACES, base)
      for shape in ("disc", "sphere")
      for base in (
          {"radiance": "9cd/m2"}, {"radiance": "9cd/m2", "radius": "1m"},
          {"radiance": "9cd/m2", "distance": "3m"},
          {"radiance": "9cd/m2", "radius": "1m", "distance": "3m"})),
    (lambertian, ("disc",), SURFACES, {"flux": "9lm", "radius": "1m", "height": "3m"}),
    *((lambertian, ("rectangle",), SURFACES, base)
      for base in (
          {"radiance": "9cd/m2"}, {"radiance": "9cd/m2", "width": "1m"},
          {"radiance": "9cd/m2", "width": "1m", "length": "2m", "height": "3m"})),
    (flagged, ("rectangle", "corner"), SURFACES,
     {"radiance": "9cd/m2", "width": "1m", "length": "2m", "height": "3m"}),
    (flagged, ("rectangle", "perpendicular"), SURFACES,
     {"radiance": "9cd/m2", "width": "1m", "length": "2m", "height": "3m", "offset-y": "30cm"}),
    *((lambertian, (shape,), SURFACES, {"radiance": "9cd/m2"})
      for shape in ("plane", "hemisphere")),
    *((ev, (), EV, base)
      for base in (
          {"ev100": "15"}, {"ev": "12"}, {"luminance": "99cd/m2"}, {"illuminance": "99lx"},
          {"f-number": "16"}, {"f-number": "16", "time": "1/100s"},
          {"ev": "12.0", "ev100": "10.0"})),
    *((calorimeter, (), CALORIMETER, base)
      for base in (
          {"flux": "5W"}, {"energy": "5J"}, {"irradiance": "5W/m2"},
          {"flux": "5W", "time": "2s"}, {"irradiance": "5W/m2", "receiver-area": "1cm2"},
          {"energy": "5J", "mass": "10g"}, {"energy": "5J", "mass": "10g",
                                            "specific-heat": "385J/kg/K"})),
]  # fmt: skip


def answer_of(call: Any, words: tuple[str, ...], values: dict[str, str]) -> dict[str, Any] | None:
    try:
        return call(*words, **{name.replace("-", "_"): text for name, text in values.items()})
    except RadcalcError:
        return None


def example_of(name: str) -> Any:
    return EXAMPLE.get(name) or SYMBOLS[name].example


@for_each(BASES)
def test_an_option_is_refused_or_changes_a_result(call, words, options, base):
    before = answer_of(call, words, base) or {}  # alone it may name a missing input
    given_names = {name.replace("-", "_") for name in base}
    accepted = []
    for name in options:
        if name in base:
            continue
        after = answer_of(call, words, {**base, name: example_of(name)})
        if after is None:
            continue
        told = {*given_names, name.replace("-", "_")}
        others = {n: str(q) for n, q in after.items() if n not in told}
        if others == {n: str(q) for n, q in before.items() if n not in told}:
            accepted.append(f"--{name} {example_of(name)}")
    assert not accepted
