"""Angles: forgotten cosines, angles from the wrong line, half and full ones, degrees as radians."""

import math
from collections.abc import Iterator

from radcalc.geometry import cones, solid
from radcalc.homework.catalogue import Problem, mistake
from radcalc.units.dimensions import ANGLE

CONES = ("half-angle", "apex-angle", "beam-angle", "field-angle")
PYRAMID = ("horizontal", "vertical")


@mistake(
    "cosine-forgotten",
    1,
    "the cosine of the incidence was left out",
    "E = I cos(theta) / d^2: a tilted surface catches less light",
)
def _cosine_forgotten(p: Problem) -> Iterator[float]:
    for name in ("incidence", "tilt"):
        if angle := p.input(name):
            yield from p.anew({name: 0.0})
            cosine = cones.facing(angle)
            if name in p.values and cosine and not p.asks(name):
                yield p.right / cosine
    if aside := p.aside():
        height, distance = aside
        if p.asks("solid-angle") and (radius := p.radius()):
            yield solid.patch(math.pi * radius**2, distance)
        elif p.asks("irradiance") and (ratio := p.far_over_near()):
            yield p.right * ratio * distance / height
    cosine = cones.facing(p.amount("off-axis") or 0.0)
    if p.has("height") and not p.has("incidence") and cosine:
        yield p.right / cosine


@mistake(
    "cosine-squared",
    5,
    "the cosine was taken twice or three times",
    "E = I cos(theta) / d^2 with the slant distance has one cosine (cos^3 goes with the height)",
)
def _cosine_squared(p: Problem) -> Iterator[float]:
    if cosine := cones.facing(p.amount("incidence") or 0.0):
        yield p.right * cosine
        yield p.right * cosine**2


@mistake(
    "angle-from-surface",
    2,
    "the angle was taken from the surface, not from its normal",
    "incidence and polar angle are counted from the normal",
)
def _angle_from_surface(p: Problem) -> Iterator[float]:
    for name in ("incidence", "tilt", "polar", "elevation", "half-angle"):
        if (angle := p.input(name)) is not None:
            yield from p.anew({name: math.pi / 2 - angle})
    if p.asks("polar", "elevation", "incidence"):
        yield math.pi / 2 - p.right


@mistake(
    "full-for-half",
    1,
    "the full angle was used as the half angle, or the half angle as the full one",
    "a half angle goes from the axis to the edge, an apex or beam angle from edge to edge",
)
def _full_for_half(p: Problem) -> Iterator[float]:
    yield from p.scaled((*CONES, *PYRAMID), 2.0)
    for factor in (2.0, 0.5) if p.has(*PYRAMID) else ():  # both of them
        yield from p.anew({name: factor * (p.input(name) or 0.0) for name in PYRAMID})
    if p.asks(*CONES):
        yield from p.both(2.0)


@mistake(
    "degrees-as-radians",
    2,
    "degrees were taken as radians",
    "a calculator set to radians takes 30 as 30 rad, that is 1719 degrees",
)
def _degrees_as_radians(p: Problem) -> Iterator[float]:
    for one in p.given_of(ANGLE):
        if (number := p.degrees(one.name)) is None:
            continue
        turned = math.fmod(abs(number), 2 * math.pi)
        for angle in (turned, 2 * math.pi - turned):  # the cosine is the same
            yield from filter(None, p.anew({one.name: angle}))  # 0 is light from behind
        if one.name == "incidence" and math.cos(one.value):
            yield p.right * math.cos(number) / math.cos(one.value)
    yield from _of_the_cone(p)
    polar, azimuth = p.degrees("polar"), p.degrees("azimuth")
    if polar is not None and azimuth is not None and p.asks("x", "y"):
        yield math.sin(polar) * (math.cos if p.asks("x") else math.sin)(azimuth)
    if ANGLE in p.target.dimensions:
        yield from p.both(math.degrees(1))


def _of_the_cone(p: Problem) -> Iterator[float]:
    """The cone with the cosine, or the squared sine, of a number of radians."""
    half, number = p.half_angle(), p.half_degrees()
    if not half or number is None:
        return
    if p.asks("solid-angle"):
        yield cones.cone(math.acos(math.cos(number)))
    is_projected = p.light or p.asks("etendue", "projected-solid-angle")
    if is_projected and p.is_of("lambertian", "etendue", "solid-angle"):
        yield p.right * (math.sin(number) / math.sin(half)) ** 2


@mistake(
    "wrong-quadrant",
    2,
    "the arc tangent of y/x was taken without looking at the quadrant",
    "phi = atan2(y, x), which knows the signs of both",
)
def _wrong_quadrant(p: Problem) -> Iterator[float]:
    if p.asks("azimuth"):
        yield p.right + math.pi
        yield p.right - math.pi
