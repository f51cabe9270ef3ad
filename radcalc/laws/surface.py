"""A surface of one radiance in all directions: what leaves it, and what a receiver gets."""

import math
from typing import Any

from radcalc.geometry import cones, projected
from radcalc.laws.energy import ENERGY, EXPOSURE
from radcalc.laws.law import HOWELL, AnyLaw, At, Relation, law, relation
from radcalc.maths import sqrt

CONFIGURATION_FACTOR = law(
    "configuration factor", "{configuration-factor} = {projected-solid-angle} / (pi Omega0)"
)
LAWS: list[AnyLaw] = [
    law(
        "Lambertian exitance",
        "{exitance} = pi Omega0 {radiance}",
        "ISO 80000-7, radiance and exitance",
    ),
    law(
        "Lambertian reflector",
        "{exitance} = {reflectance} {incident-irradiance}",
        "ISO 80000-7, reflectance",
    ),
    law("flux of a surface", "{flux} = {exitance} {area}", "ISO 80000-7, exitance"),
    law(
        "intensity of a surface",
        "{intensity} = {radiance} {apparent-area}",
        "ISO 80000-7, radiance",
    ),
    law(
        "irradiance of a uniform radiance",
        "{irradiance} = {radiance} {projected-solid-angle}",
        "ISO 80000-7, radiance and irradiance",
    ),
    CONFIGURATION_FACTOR,
    law(
        "inverse square law, as an estimate",
        "{far-field-irradiance} = {intensity} {cosine-of-source} {cosine} Omega0 / {distance}^2",
    ),
    EXPOSURE,
    ENERGY,
]
FLAT = law("as seen from the front", "{apparent-area} = {area}")
SPHERE_AREA = law("area of a sphere", "{area} = 4 pi {radius}^2")
SPHERE_FRONT = law("as seen from anywhere", "{apparent-area} = pi {radius}^2")
SMALL_SOURCE = law(
    "small source",
    "{projected-solid-angle} = {area} {cosine-of-source} {cosine} Omega0 / {distance}^2",
)


def _over(whole: float, at: At) -> Any:
    """A whole over the projected solid angle, which must be less."""
    part = at("projected-solid-angle")
    cones.refuse(
        part >= whole,
        "more irradiance than the whole hemisphere at that radiance would give",
        "more radiance, or less irradiance",
    )
    return whole / part


def disc_on_axis(away: str) -> Relation:
    """A disc from a place on its axis, which is so far away: its distance, or its height."""
    return relation(
        "disc on its axis",
        f"{{projected-solid-angle}} = pi Omega0 {{radius}}^2 / ({{radius}}^2 + {{{away}}}^2)",
        {
            "projected-solid-angle": lambda at: projected.disc(at("radius"), at(away)),
            away: lambda at: at("radius") * sqrt(_over(math.pi, at) - 1),
            "radius": lambda at: at(away) / sqrt(_over(math.pi, at) - 1),
        },
        HOWELL,
    )


SPHERE_AT_DISTANCE = relation(
    "sphere, its centre at a distance",
    "{projected-solid-angle} = pi Omega0 ({radius} / {distance})^2",
    {
        "projected-solid-angle": lambda at: projected.sphere(at("radius"), at("distance")),
        "distance": lambda at: at("radius") * sqrt(_over(math.pi, at)),
        "radius": lambda at: at("distance") / sqrt(_over(math.pi, at)),
    },
    HOWELL,
)
SPHERE_FLUX = law("flux of a sphere at a distance", "{flux} = 4 pi {distance}^2 {irradiance}")
