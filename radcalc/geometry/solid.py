"""Solid angles [sr] of shapes, seen from a point.

Lengths are all in one unit, angles in radians; every argument is a float or an array, and
arrays are broadcast together.  The forms are those that keep their digits for small and for
large arguments, so a disc a thousand million radii away is as exact as one at hand.  What no
observer can see (a sphere from within, a disc from its own plane) is a `ConditionError`.
"""

import math
from typing import Any

from radcalc.errors import ConditionError
from radcalc.geometry.numerics.special import cel
from radcalc.geometry.polygons import polygon, triangle
from radcalc.maths import (
    Number,
    any_true,
    asin,
    atan2,
    cos,
    hypot,
    larger,
    piecewise,
    power_of_two,
    sin,
    sqrt,
)

__all__ = [
    "FULL",
    "HEMISPHERE",
    "angular_radius",
    "cone",
    "cone_of",
    "disc",
    "patch",
    "polygon",
    "pyramid",
    "rectangle",
    "sphere",
    "sphere_distance",
    "sphere_radius",
    "triangle",
    "zone",
]

FULL = 4 * math.pi
HEMISPHERE = 2 * math.pi
SLACK = 1e-12  # 12.566370614359 sr and 3.14159265359 rad, as typed, are still within the sphere


def refuse(bad: Any, message: str, hint: str) -> None:
    """Raise a `ConditionError` where a comparison holds for any element."""
    if any_true(bad):
        raise ConditionError(message, hint)


def cone(half_angle: Number) -> Number:
    """A cone (a spherical cap) of a half angle from 0 to pi: 4 pi sin^2(alpha/2).

    ISO 80000-3 defines the solid angle; the form with the sine keeps the digits of narrow cones.
    """
    bad = (half_angle < 0) | (half_angle > math.pi * (1 + SLACK))
    refuse(bad, "a cone of that half angle is not possible", "from 0 to 180 deg")
    return FULL * sin(half_angle / 2) ** 2


def cone_of(solid_angle: Number) -> Number:
    """The half angle [rad] of the cone of a solid angle [sr]: 2 arcsin sqrt(Omega / 4 pi)."""
    part = solid_angle / FULL
    bad = (part < 0) | (part > 1 + SLACK)
    refuse(bad, "a cone of that solid angle is not possible", "from 0 to 4pi sr")
    return 2 * asin(sqrt(piecewise(part > 1, lambda p: 1.0 + 0 * p, lambda p: p, part)))


def zone(lower: Number, upper: Number, azimuth: Number = 2 * math.pi) -> Number:
    """A zone between two polar angles, over a width in azimuth.

    2 dphi sin((t0 + t1)/2) sin((t1 - t0)/2), for 0 <= t0 <= t1 <= pi and 0 <= dphi <= 2 pi.
    """
    check_zone(lower, upper, azimuth)
    # sin((t0 + t1)/2), from halves: no digit is lost near either pole
    middle = sin(lower / 2) * cos(upper / 2) + cos(lower / 2) * sin(upper / 2)
    return 2 * azimuth * middle * sin((upper - lower) / 2)


def check_zone(lower: Number, upper: Number, azimuth: Number) -> None:
    """Refuse what is no zone."""
    refuse(
        (lower < 0) | (upper > math.pi * (1 + SLACK)),
        "a zone beyond the poles is not possible",
        "polar angles from 0 to 180 deg",
    )
    refuse(lower > upper, "the zone ends before it starts", "the smaller polar angle first")
    refuse(
        (azimuth < 0) | (azimuth > 2 * math.pi * (1 + SLACK)),
        "a zone of that width in azimuth is not possible",
        "from 0 to 360 deg",
    )


def angular_radius(radius: Number, distance: Number) -> Number:
    """The half angle [rad] of a sphere's cone of sight: sin alpha = R/D, D to the centre."""
    refuse((radius < 0), "a negative radius is not possible", "0 or more")
    refuse(
        distance <= radius,
        "the observer is on or inside the sphere",
        "a distance to the centre above the radius (on the surface a sphere fills 2pi sr)",
    )
    # R / sqrt(D^2 - R^2), whose digits last up to the surface
    return atan2(radius, sqrt(distance - radius) * sqrt(distance + radius))


def sphere(radius: Number, distance: Number) -> Number:
    """A sphere, its centre at a distance: the cone whose half angle is `angular_radius`."""
    return cone(angular_radius(radius, distance))


def _sine(solid_angle: Number) -> Number:
    """The sine of the half angle of a sphere's cone of sight, from its solid angle."""
    part = solid_angle / FULL
    refuse(
        (part <= 0) | (part >= 0.5),
        "no sphere seen from outside fills that solid angle",
        "more than 0 and less than 2pi sr",
    )
    return 2 * sqrt(part) * sqrt(1 - part)


def sphere_distance(radius: Number, solid_angle: Number) -> Number:
    """How far the centre of a sphere is that fills a solid angle."""
    return radius / _sine(solid_angle)


def sphere_radius(distance: Number, solid_angle: Number) -> Number:
    """The radius of a sphere that fills a solid angle, its centre at a distance."""
    return distance * _sine(solid_angle)


def check_height(height: Number) -> None:
    """Refuse an observer in the plane of a flat shape."""
    refuse(
        height <= 0,
        "the observer is not above the shape's plane",
        "a height above 0 (edge-on, a flat shape fills no solid angle)",
    )


def disc(radius: Number, height: Number, offset: Number = 0.0) -> Number:
    """A disc, from a height above its plane and an offset from its axis.

    On the axis 2 pi (1 - h / sqrt(h^2 + R^2)).  Elsewhere the integral round the rim, of
    which far away the trapezoidal rule takes every digit, and which near by is complete
    elliptic (F. Paxton, Rev. Sci. Instrum. 30 (1959) 254, has it with other functions).
    """
    refuse(radius < 0, "a negative radius is not possible", "0 or more")
    check_height(height)
    offset = abs(offset)
    scale = power_of_two(larger(larger(radius, height), offset))
    radius, height, offset = radius / scale, height / scale, offset / scale
    far = 4 * radius < hypot(height, offset)
    return piecewise(far, _disc_from_afar, _disc_from_near, radius, height, offset)


RIM = 32  # points on the rim; from four radii on, 26 give every digit


def _disc_from_afar(radius: Number, height: Number, offset: Number) -> Number:
    """The mean over the rim of the solid angle per turn about the line to the disc's centre.

    All terms are positive, whatever the offset.
    """
    away = hypot(height, offset)
    total = 0.0
    for k in range(RIM):
        along = radius * offset * math.cos(2 * math.pi * k / RIM)
        to_rim = sqrt(away**2 + radius**2 + 2 * along)
        total = total + 1 / (to_rim * (to_rim * away + away**2 + along))
    return 2 * math.pi / RIM * radius**2 * height * total


def _disc_from_near(radius: Number, height: Number, offset: Number) -> Number:
    """The turn about the axis, less what the cosine of the polar angle of the rim takes of it."""
    nearest, farthest = hypot(height, offset - radius), hypot(height, offset + radius)
    inside, outside = radius - offset, radius + offset
    # The rim's turn about the observer's foot is all of it, half of it or none; on the rim
    # itself the integral has no pole left, and is of the first kind.
    turn = math.pi * (1.0 * (inside >= 0) + 1.0 * (inside > 0))
    rim = inside == 0
    p = piecewise(rim, lambda x: 1.0 + x, lambda x: x * x, inside / outside)
    b = piecewise(rim, lambda x: 1.0 + x, lambda x: x, inside / outside)
    part = radius / outside
    return turn - 4 * height / farthest * cel(nearest / farthest, p, part, part * b)


def rectangle(
    width: Number,
    length: Number,
    height: Number,
    offset: Number = 0.0,
    offset_y: Number = 0.0,
) -> Number:
    """A rectangle, from a height above its plane and offsets from its axis along its sides.

    On the axis 4 arctan(a b / (h sqrt(a^2 + b^2 + h^2))) with half sides a, b; elsewhere the
    same through its two triangles.
    """
    from radcalc.geometry.polygons import fan

    return abs(fan(*corners(width, length, height, offset, offset_y)))


def corners(width: Number, length: Number, height: Number, offset: Number, offset_y: Number) -> Any:
    """A rectangle as `polygons` takes it: its first corner, and the corners from there."""
    refuse((width < 0) | (length < 0), "a negative side is not possible", "0 or more")
    check_height(height)
    corner = (-offset - width / 2, -offset_y - length / 2, height)
    return corner, [(0.0, 0.0, 0.0), (width, 0.0, 0.0), (width, length, 0.0), (0.0, length, 0.0)]


def pyramid(horizontal: Number, vertical: Number) -> Number:
    """A right rectangular pyramid of two full apex angles, face to face, from 0 to pi.

    4 arcsin(sin(a/2) sin(b/2)), through the arc tangent, which keeps its digits near pi.
    """
    check_pyramid(horizontal, vertical)
    a, b = horizontal / 2, vertical / 2
    return 4 * atan2(sin(a) * sin(b), hypot(cos(a), sin(a) * cos(b)))


def check_pyramid(horizontal: Number, vertical: Number) -> None:
    """Refuse angles that no pyramid has."""
    top = math.pi * (1 + SLACK)
    bad = (horizontal < 0) | (vertical < 0) | (horizontal > top) | (vertical > top)
    refuse(bad, "a pyramid of those angles is not possible", "from 0 to 180 deg, face to face")


def patch(area: Number, distance: Number, tilt: Number = 0.0) -> Number:
    """A small flat patch, tilted from the line of sight: A cos(theta) / d^2.

    The first term of a series in size over distance: at five times the size a disc is 1 % off.
    Past 90 degrees it is seen from behind, and fills nothing.
    """
    refuse(area < 0, "a negative area is not possible", "0 or more")
    refuse(distance <= 0, "the observer is on the patch", "a distance above 0")
    check_tilt(tilt)
    return area / distance**2 * facing(tilt)


def check_tilt(tilt: Number) -> None:
    """Refuse an angle that is none from a normal."""
    refuse(abs(tilt) > math.pi * (1 + SLACK), "that tilt is not possible", "from 0 to 180 deg")


def facing(tilt: Number) -> Number:
    """cos(theta) for light from the front, 0 for light from the side or behind."""
    return piecewise(abs(tilt) < math.pi / 2, cos, lambda t: 0.0 * t, tilt)
