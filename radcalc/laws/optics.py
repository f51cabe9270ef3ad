"""Photons in vacuum, hot bodies, and plane surfaces between transparent media.

A photon has a frequency, a wavenumber and an energy by its wavelength.  The cycle and the photon
are dimensions here, so a joule per photon is not a joule.

A hot body has its exitance by Stefan and Boltzmann, its peak wavelength by Wien.  It emits like a
black body times an emissivity that is the same at all wavelengths and in all directions.

A plane surface follows Snell's and Fresnel's laws.  The index is the refractive index after the
surface over that before it.  The s field is perpendicular to the plane of incidence, the p field
parallel to it.  A slab has the first medium on both sides; all reflections inside it are summed as
powers.  The media do not absorb and are not magnetic.
"""

from typing import Any

from radcalc.errors import ConditionError
from radcalc.laws import AnyLaw, At, law, relation
from radcalc.maths import any_true, asin, atan, cos, sin, smaller, square, tan
from radcalc.spectra.observers import LIGHT, PLANCK, STEFAN_BOLTZMANN, WIEN

EXACT = "SI Brochure: exact h and c"
FREQUENCY = law(
    "frequency", "{frequency} = c / {wavelength}", EXACT, constant=LIGHT, unit="m cycle/s"
)
WAVENUMBER = law("wavenumber", "{wavenumber} = 1 / {wavelength}", unit="cycle")
PHOTON_ENERGY = law(
    "photon energy",
    "{photon-energy} = h c / {wavelength}",
    EXACT,
    constant=PLANCK * LIGHT,
    unit="J m/photon",
)
PHOTON_LAWS = [FREQUENCY, WAVENUMBER, PHOTON_ENERGY]


SIGMA = "sigma: CODATA 2022 (exact)"
EXITANCE = law(
    "Stefan-Boltzmann law",
    "{exitance} = {emissivity} sigma {temperature}^4",
    SIGMA,
    constant=STEFAN_BOLTZMANN,
    unit="W/(m2 K^4)",
)
PEAK = law(
    "Wien's displacement law",
    "{peak-wavelength} = b / {temperature}",
    "b: CODATA 2022 (exact), the peak per wavelength",
    constant=WIEN,
    unit="m K",
)


FRESNEL = "Fresnel equations, for media that do not absorb"


def _refraction_angle(at: At) -> Any:
    sine = sin(at("incidence")) / at("index")
    if any_true(sine > 1):
        raise ConditionError(
            "the light is totally reflected: it has no angle of refraction", "a smaller incidence"
        )
    return asin(sine)


def _incidence(at: At) -> Any:
    sine = at("index") * sin(at("refraction-angle"))
    if any_true(sine > 1):
        raise ConditionError("no incidence gives that angle of refraction", "a smaller angle")
    return asin(smaller(sine, 1.0))


def _index(at: At) -> Any:
    if any_true(at("refraction-angle") == 0):
        problem = "light along the normal does not determine the index"
        raise ConditionError(problem, "a larger angle")
    return sin(at("incidence")) / sin(at("refraction-angle"))


def _fresnel(before: Any, after: Any) -> Any:
    return square((before - after) / (before + after))


def _slab(reflectance: Any) -> Any:
    return (1 - reflectance) / (1 + reflectance)


SNELL = relation(
    "Snell's law",
    "sin({incidence}) = {index} sin({refraction-angle})",
    {"refraction-angle": _refraction_angle, "incidence": _incidence, "index": _index},
    FRESNEL,
)
BREWSTER = relation(
    "Brewster's angle",
    "{brewster-angle} = atan({index})",
    {
        "brewster-angle": lambda at: atan(at("index")),
        "index": lambda at: tan(at("brewster-angle")),
    },
    FRESNEL,
)
CRITICAL_INSIDE, CRITICAL_OUTSIDE = (
    relation(
        "critical angle",
        f"sin({{critical-angle}}) = {sine}",
        {
            "critical-angle": lambda at: asin(smaller(at("index"), 1 / at("index"))),
            "index": lambda at: 1 / sin(at("critical-angle")),
        },
        FRESNEL,
    )
    for sine in ("1 / {index}", "{index}")  # the denser medium is that after the surface, before it
)
PERPENDICULAR = relation(
    "Fresnel's reflectance, perpendicular",
    "{reflectance-s} = ((cos({incidence}) - {index} cos({refraction-angle})) / "
    "(cos({incidence}) + {index} cos({refraction-angle})))^2",
    {
        "reflectance-s": lambda at: _fresnel(
            cos(at("incidence")), at("index") * cos(at("refraction-angle"))
        )
    },
    FRESNEL,
)
PARALLEL = relation(
    "Fresnel's reflectance, parallel",
    "{reflectance-p} = (({index} cos({incidence}) - cos({refraction-angle})) / "
    "({index} cos({incidence}) + cos({refraction-angle})))^2",
    {
        "reflectance-p": lambda at: _fresnel(
            at("index") * cos(at("incidence")), cos(at("refraction-angle"))
        )
    },
    FRESNEL,
)
UNPOLARISED = relation(
    "unpolarised light",
    "{reflectance} = ({reflectance-s} + {reflectance-p}) / 2",
    {"reflectance": lambda at: (at("reflectance-s") + at("reflectance-p")) / 2},
    FRESNEL,
)
TRANSMITTED = relation(
    "energy at the surface",
    "{transmittance} = 1 - {reflectance}",
    {"transmittance": lambda at: 1 - at("reflectance")},
    FRESNEL,
)
SLAB = relation(
    "slab without absorption",
    "{slab-transmittance} = ((1 - {reflectance-s}) / (1 + {reflectance-s}) + "
    "(1 - {reflectance-p}) / (1 + {reflectance-p})) / 2",
    {
        "slab-transmittance": lambda at: (
            (_slab(at("reflectance-s")) + _slab(at("reflectance-p"))) / 2
        )
    },
    FRESNEL,
)
REFRACTION_LAWS: list[AnyLaw] = [
    SNELL,
    PERPENDICULAR,
    PARALLEL,
    UNPOLARISED,
    TRANSMITTED,
    SLAB,
    BREWSTER,
]
TOTAL: list[AnyLaw] = [UNPOLARISED, TRANSMITTED, SLAB, BREWSTER]  # with a reflectance of 1
