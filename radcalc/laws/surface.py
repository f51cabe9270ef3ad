"""A surface of one radiance in all directions: what leaves it, and what a receiver gets."""

import math
from typing import Any

from radcalc.geometry import projected, solid
from radcalc.laws.energy import ENERGY, EXPOSURE
from radcalc.laws.law import AnyLaw, At, Law, Relation
from radcalc.maths import sqrt

HOWELL = "J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors"
CONFIGURATION_FACTOR = Law(
    "configuration factor",
    "{configuration-factor} = {projected-solid-angle} / (pi Omega0)",
    "configuration-factor",
    (("projected-solid-angle", 1),),
    1 / math.pi,
    "1/sr",
)
LAWS: list[AnyLaw] = [
    Law(
        "Lambertian exitance",
        "{exitance} = pi Omega0 {radiance}",
        "exitance",
        (("radiance", 1),),
        math.pi,
        "sr",
        "ISO 80000-7, radiance and exitance",
    ),
    Law(
        "Lambertian reflector",
        "{exitance} = {reflectance} {incident-irradiance}",
        "exitance",
        (("reflectance", 1), ("incident-irradiance", 1)),
        reference="ISO 80000-7, reflectance",
    ),
    Law(
        "flux of a surface",
        "{flux} = {exitance} {area}",
        "flux",
        (("exitance", 1), ("area", 1)),
        reference="ISO 80000-7, exitance",
    ),
    Law(
        "intensity of a surface",
        "{intensity} = {radiance} {apparent-area}",
        "intensity",
        (("radiance", 1), ("apparent-area", 1)),
        reference="ISO 80000-7, radiance",
    ),
    Law(
        "irradiance of a uniform radiance",
        "{irradiance} = {radiance} {projected-solid-angle}",
        "irradiance",
        (("radiance", 1), ("projected-solid-angle", 1)),
        reference="ISO 80000-7, radiance and irradiance",
    ),
    CONFIGURATION_FACTOR,
    Law(
        "inverse square law, as an estimate",
        "{far-field-irradiance} = {intensity} {cosine-of-source} {cosine} Omega0 / {distance}^2",
        "far-field-irradiance",
        (("intensity", 1), ("cosine-of-source", 1), ("cosine", 1), ("distance", -2)),
        1.0,
        "sr",
    ),
    EXPOSURE,
    ENERGY,
]
FLAT = Law("as seen from the front", "{apparent-area} = {area}", "apparent-area", (("area", 1),))
RECTANGLE = Law(
    "area of a rectangle", "{area} = {width} {length}", "area", (("width", 1), ("length", 1))
)
CIRCLE = Law("area of a circle", "{area} = pi {radius}^2", "area", (("radius", 2),), math.pi)
DIAMETER = Law("diameter", "{diameter} = 2 {radius}", "diameter", (("radius", 1),), 2.0)
SPHERE_AREA = Law(
    "area of a sphere", "{area} = 4 pi {radius}^2", "area", (("radius", 2),), 4 * math.pi
)
SPHERE_FRONT = Law(
    "as seen from anywhere",
    "{apparent-area} = pi {radius}^2",
    "apparent-area",
    (("radius", 2),),
    math.pi,
)
SMALL_SOURCE = Law(
    "small source",
    "{projected-solid-angle} = {area} {cosine-of-source} {cosine} Omega0 / {distance}^2",
    "projected-solid-angle",
    (("area", 1), ("cosine-of-source", 1), ("cosine", 1), ("distance", -2)),
    1.0,
    "sr",
)


def _over(whole: float, at: At) -> Any:
    """A whole over the projected solid angle, which must be less."""
    part = at("projected-solid-angle")
    solid.refuse(
        part >= whole,
        "more irradiance than the whole hemisphere at that radiance would give",
        "more radiance, or less irradiance",
    )
    return whole / part


def disc_on_axis(away: str) -> Relation:
    """A disc from a place on its axis, which is so far away: its distance, or its height."""
    return Relation(
        "disc on its axis",
        f"{{projected-solid-angle}} = pi Omega0 {{radius}}^2 / ({{radius}}^2 + {{{away}}}^2)",
        ("projected-solid-angle", "radius", away),
        {
            "projected-solid-angle": lambda at: projected.disc(at("radius"), at(away)),
            away: lambda at: at("radius") * sqrt(_over(math.pi, at) - 1),
            "radius": lambda at: at(away) / sqrt(_over(math.pi, at) - 1),
        },
        HOWELL,
    )


SPHERE_AT_DISTANCE = Relation(
    "sphere, its centre at a distance",
    "{projected-solid-angle} = pi Omega0 ({radius} / {distance})^2",
    ("projected-solid-angle", "radius", "distance"),
    {
        "projected-solid-angle": lambda at: projected.sphere(at("radius"), at("distance")),
        "distance": lambda at: at("radius") * sqrt(_over(math.pi, at)),
        "radius": lambda at: at("distance") / sqrt(_over(math.pi, at)),
    },
    HOWELL,
)
SPHERE_FLUX = Law(  # all its flux goes through the sphere of that distance
    "flux of a sphere at a distance",
    "{flux} = 4 pi {distance}^2 {irradiance}",
    "flux",
    (("distance", 2), ("irradiance", 1)),
    4 * math.pi,
)
