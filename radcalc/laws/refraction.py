"""A plane surface between two transparent media, and a plane slab: Snell's and Fresnel's laws.

The index n is the refractive index after the surface over that before it; i and t are the angles
between the light and the normal, before and after:

- Snell: sin(i) = n sin(t)
- Fresnel: rho_s = ((cos i - n cos t) / (cos i + n cos t))^2, for a field perpendicular to the plane
  of incidence, and rho_p = ((n cos i - cos t) / (n cos i + cos t))^2, for one parallel to it
- unpolarised light: rho = (rho_s + rho_p) / 2, tau = 1 - rho
- slab with the first medium on both sides, with all reflections inside it, summed as powers:
  tau = ((1 - rho_s) / (1 + rho_s) + (1 - rho_p) / (1 + rho_p)) / 2
- Brewster: tan(B) = n, the incidence at which no light of parallel polarisation is reflected
- critical angle: sin(c) = min(n, 1/n), in the medium of greater index

Angles [rad]; all else is dimensionless.  The media are not magnetic and do not absorb.
"""

from typing import Any

from radcalc.errors import ConditionError
from radcalc.laws.law import AnyLaw, At, relation
from radcalc.maths import any_true, asin, atan, cos, sin, smaller, square, tan

FRESNEL = "Fresnel equations, for media that do not absorb"


def _refracted(at: At) -> Any:
    """Return the angle of refraction; refuse total reflection."""
    sine = sin(at("incidence")) / at("index")
    if any_true(sine > 1):
        raise ConditionError(
            "the light is totally reflected: it has no angle of refraction", "a smaller incidence"
        )
    return asin(sine)


def _incident(at: At) -> Any:
    """Return the angle of incidence from the angle of refraction."""
    sine = at("index") * sin(at("refraction-angle"))
    if any_true(sine > 1):
        raise ConditionError("no incidence gives that angle of refraction", "a smaller angle")
    return asin(smaller(sine, 1.0))


def _index(at: At) -> Any:
    """Return the index from the angles of incidence and refraction."""
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
    {"refraction-angle": _refracted, "incidence": _incident, "index": _index},
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
LAWS: list[AnyLaw] = [SNELL, PERPENDICULAR, PARALLEL, UNPOLARISED, TRANSMITTED, SLAB, BREWSTER]
TOTAL: list[AnyLaw] = [UNPOLARISED, TRANSMITTED, SLAB, BREWSTER]  # with a reflectance of 1
