"""Distances and sizes: which distance the law takes, to which power, and radii for diameters."""

import math
from collections.abc import Iterator

from radcalc.geometry import solid
from radcalc.homework.catalogue import Problem, mistake, mistake_factor


@mistake("one-over-r", 2, "the distance was not squared", "irradiance falls as 1/d^2")
def _one_over_r(p: Problem) -> Iterator[float]:
    if p.asks("distance"):
        if p.is_of("point-source"):
            yield p.right**2
        return
    for distance in (p.amount("distance"), p.number("distance")):
        if distance:
            yield from p.both(distance)


@mistake(
    "height-for-distance",
    2,
    "the height was used for the slant distance",
    "d is the straight line: d^2 = h^2 + x^2",
)
def _height_for_distance(p: Problem) -> Iterator[float]:
    if aside := p.aside():
        height, distance = aside
        if p.asks("solid-angle") and (radius := p.radius()):
            yield solid.patch(math.pi * radius**2, distance) * distance / height
        elif p.asks("irradiance") and (ratio := p.far_over_near()):
            yield p.right * ratio * (distance / height) ** 2
            yield p.right * ratio * (distance / height) ** 3
    given, slant = p.input("height"), p.amount("distance")
    if given and slant and slant > given:
        yield from p.both((slant / given) ** 2, (slant / given) ** 3)


@mistake(
    "diameter-for-radius",
    1,
    "the diameter was used for the radius, or the radius for the diameter",
    "R is half the diameter: areas are off by 4",
)
def _diameter_for_radius(p: Problem) -> Iterator[float]:
    sizes = ("radius", "diameter", "receiver-radius", "receiver-diameter", "pupil")
    yield from p.scaled(sizes, 2.0)
    if p.asks("radius", "diameter"):
        yield from p.both(2.0)


@mistake(
    "distance-to-surface",
    3,
    "the distance was taken to the sphere's surface",
    "sin(alpha) = R/d, with d to the centre",
)
def _distance_to_surface(p: Problem) -> Iterator[float]:
    radius, distance = p.radius(), p.input("distance")
    if p.facts.shape != "sphere" or not radius:
        return
    if distance:
        yield from p.anew({"distance": distance - radius})
        yield from p.anew({"distance": distance + radius})
    elif p.asks("distance"):
        yield p.right - radius


@mistake(
    "far-field-of-extended-source",
    2,
    "the inverse square law was used on an extended source",
    "near a source of some size E = L Omega_p: for a disc pi L R^2/(R^2 + d^2)",
)
def _far_field(p: Problem) -> Iterator[float]:
    ratio = p.far_over_near()
    if ratio and p.light and not p.asks("far-field-irradiance"):
        yield from p.both(ratio)
    far, near = p.amount("far-field-etendue"), p.amount("etendue")
    if far and near and (p.light or p.asks("etendue")):
        yield p.right * far / near


@mistake_factor(
    "inverse-square-on-radiance",
    3,
    "the inverse square law was used on a radiance",
    "a radiance is the same from any distance",
)
def _inverse_square_on_radiance(p: Problem) -> Iterator[float]:
    distance = p.amount("distance")
    if distance and p.light and p.light.is_radiance:
        yield distance**2
