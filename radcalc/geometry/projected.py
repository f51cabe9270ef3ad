"""Projected solid angles [sr]: each direction weighted by its cosine to the receiver's normal.

Divided by pi they are the configuration factors from a surface element to the shape; times a
uniform radiance, the irradiance.  What is below the receiver's horizon does not count.
Arguments are those of `solid`, floats or arrays; a `tilt` turns the receiver.  J. R. Howell's
catalogue of configuration factors has most of the formulas, in forms that lose their digits
for small shapes; here they keep them.
"""

import math
from typing import Any

from radcalc.geometry import solid
from radcalc.geometry.numerics.quadrature import adaptive, integral
from radcalc.geometry.numerics.special import less_arctangent
from radcalc.geometry.numerics.vectors import dot, length, times, vector
from radcalc.geometry.polygons import above, projected, split
from radcalc.maths import (
    Number,
    atan2,
    cos,
    each,
    hypot,
    is_array,
    larger,
    piecewise,
    power_of_two,
    sin,
    smaller,
)

HEMISPHERE = math.pi  # and of all directions too: a surface sees one half of them
RIGHT = math.pi / 2
UP = (0.0, 0.0, 1.0)


def cone(half_angle: Number, tilt: Number = 0.0) -> Number:
    """A cone whose axis is tilted from the receiver's normal; angles from 0 to pi.

    pi sin^2(alpha) cos(tilt) while all of it is above the horizon.  Of a cone that the horizon
    cuts, the formula of a sphere partly below it; a cone wider than a hemisphere is what the
    cone about the opposite direction leaves of the receiver's view.
    """
    solid.cone(half_angle)  # refuses what is no cone
    solid.check_tilt(tilt)
    return each(_cone, half_angle, abs(tilt))


def _cone(half_angle: float, tilt: float) -> Number:
    if half_angle > RIGHT:
        return math.pi - _cone(math.pi - half_angle, math.pi - tilt)
    sine, cosine = math.sin(half_angle), math.cos(tilt)
    if cosine >= sine:
        return math.pi * sine**2 * cosine
    if cosine <= -sine:
        return 0.0
    if cosine < -0.9 * sine:
        return _crescent(half_angle, tilt)
    # How high it stands, from -1 (below the horizon) to 1 (above).
    u = cosine / sine
    root, level = math.sqrt((1 - u) * (1 + u)), math.cos(half_angle)
    turn = math.acos(max(-1.0, -u * level / math.sin(tilt)))
    if level < 0.5:
        side = math.atan2(root * sine, level) - root * sine * level
    else:
        w = root * math.tan(half_angle)
        side = sine**2 * w - less_arctangent(w)
    return side + u * sine**3 * turn


def _crescent(half_angle: float, tilt: float) -> float:
    """The upper rim of a cone that all but disappears below the horizon, zone by zone."""
    # From the cosine: pi/2 - tilt would lose the digits of a small angle.
    highest = math.asin(math.cos(tilt)) + half_angle  # of its rim, above the horizon

    def zone(s: float) -> float:  # below the highest point by highest * s^2
        below = highest * s * s
        height = highest - below
        sine = math.sin(half_angle - below / 2) * math.sin(below / 2)
        turn = 4 * math.asin(math.sqrt(sine / (math.sin(tilt) * math.cos(height))))
        return turn * math.sin(height) * math.cos(height) * 2 * highest * s

    return integral(zone, 0.0, 1.0)


def zone(lower: Number, upper: Number, azimuth: Number = 2 * math.pi) -> Number:
    """A zone between two polar angles about the receiver's normal, over a width in azimuth.

    dphi (sin^2 t1 - sin^2 t0) / 2, up to 90 degrees.
    """
    solid.check_zone(lower, upper, azimuth)
    lower, upper = smaller(lower, RIGHT + 0 * lower), smaller(upper, RIGHT + 0 * upper)
    sum_ = sin(lower) * cos(upper) + cos(lower) * sin(upper)
    return azimuth / 2 * sum_ * sin(upper - lower)


def sphere(radius: Number, distance: Number, tilt: Number = 0.0) -> Number:
    """A sphere, its centre at a distance and tilted from the receiver's normal.

    pi (R/D)^2 cos(tilt) while it is wholly above the horizon.
    """
    return cone(solid.angular_radius(radius, distance), tilt)


def disc(radius: Number, height: Number, offset: Number = 0.0, tilt: Number = 0.0) -> Number:
    """A disc, from a height above its plane and an offset from its axis.

    Without tilt the receiver faces the disc's plane; with one it is turned by that angle towards
    the disc's axis (away from it, where negative), in the plane of the offset.  On the axis
    pi R^2 / (R^2 + h^2) cos(tilt).
    """
    solid.refuse(radius < 0, "a negative radius is not possible", "0 or more")
    solid.check_height(height)
    solid.check_tilt(tilt)
    scale = power_of_two(larger(larger(radius, height), abs(offset)))
    radius, height, offset = radius / scale, height / scale, abs(offset) / scale
    if not is_array(tilt) and tilt == 0:
        return _facing_disc(radius, height, offset)[1]
    return each(_tilted_disc, radius, height, offset, tilt)


def _facing_disc(radius: Number, height: Number, offset: Number) -> tuple[Number, Number]:
    """The light vector of a whole disc: towards its axis, and along it."""
    nearest, farthest = hypot(height, offset - radius), hypot(height, offset + radius)
    both, square = nearest * farthest, height**2 + offset**2
    more = height**2 + (offset - radius) * (offset + radius)
    along = piecewise(
        more > 0,
        lambda b, m, r, h: 2 * (r * h) ** 2 / (b * (b + m)),
        lambda b, m, r, h: (1 - m / b) / 2,
        both,
        more,
        radius,
        height,
    )
    across = 2 * height * offset * radius**2 / (both * (both + square + radius**2))
    return math.pi * across, math.pi * along


def _tilted_disc(radius: float, height: float, offset: float, tilt: float) -> Number:
    sine, cosine = math.sin(tilt), math.cos(tilt)
    centre = sine * offset + cosine * height  # the heights above the receiver's plane
    if centre >= abs(sine) * radius:
        across, along = _facing_disc(radius, height, offset)
        return sine * across + cosine * along
    if centre <= -abs(sine) * radius:
        return 0.0
    return _cut_disc(radius, height, offset, sine, cosine)


def _cut_disc(radius: float, height: float, offset: float, sine: float, cosine: float) -> float:
    """What the receiver's horizon leaves of a disc, strip by strip along the horizon.

    The strip at the angle t of the rim lies at x = offset + R cos t, and reaches R sin t to
    either side.  Angles are counted from the strip nearest the observer, over whom a low disc's
    share is sharply peaked.
    """
    horizon = -height * cosine / sine  # the x of the strip on it
    cut = math.acos(max(-1.0, min(1.0, (horizon - offset) / radius)))
    nearest = math.acos(max(-1.0, -offset / radius))
    x0 = max(0.0, offset - radius)

    def strip(turn: float) -> float:
        t = nearest + turn
        x = x0 - 2 * radius * math.sin(nearest + turn / 2) * math.sin(turn / 2)
        away, reach = math.hypot(x, height), radius * math.sin(t)
        ends = reach / (away**2 + reach**2) + math.atan(reach / away) / away
        return height * sine * (x - horizon) / away**2 * ends * reach

    low, high = (0.0, cut) if sine > 0 else (cut, math.pi)
    low, high = low - nearest, high - nearest
    if low < 0 < high:
        return adaptive(strip, low, 0.0) + adaptive(strip, 0.0, high)
    return adaptive(strip, low, high)


def rectangle(
    width: Number,
    length_: Number,
    height: Number,
    offset: Number = 0.0,
    offset_y: Number = 0.0,
    normal: Any = UP,
) -> Number:
    """A rectangle, from a height above its plane and offsets from its axis.

    The receiver's normal has coordinates along the width, along the length and towards the
    rectangle's plane; without one it faces that plane.
    """
    first, sides = solid.corners(width, length_, height, offset, offset_y)
    return _clipped(first, sides, normal)


def pyramid(horizontal: Number, vertical: Number) -> Number:
    """A right rectangular pyramid of two full apex angles, about the receiver's normal."""
    solid.check_pyramid(horizontal, vertical)
    a, b = horizontal / 2, vertical / 2
    one = sin(a) * atan2(sin(b) * cos(a), cos(b))
    return 2 * (one + sin(b) * atan2(sin(a) * cos(b), cos(a)))


def polygon(vertices: Any, normal: Any) -> Number:
    """A flat polygon, what of it is above the horizon of a normal.

    Parameters
    ----------
    vertices : sequence of points, or array (..., n, 3)
        In their order, from the receiver.
    normal : point
        The direction the receiver faces, of any length.

    Returns
    -------
    float or array (...)
        Not negative, whichever way the polygon turns.
    """
    first, sides = split(vertices)
    return _clipped(first, sides, normal)


def _clipped(first: Any, sides: Any, normal: Any) -> Number:
    n = vector(normal)
    largest = larger(larger(abs(n[0]), abs(n[1])), abs(n[2]))
    solid.refuse(largest == 0, "a normal of length 0 has no direction", "another, such as 0,0,1")
    n = times(n, 1 / power_of_two(largest))
    unit = times(n, 1 / length(n))
    coordinates = [*first, *unit, *(x for side in sides for x in side)]

    def one(*xs: Any) -> Number:
        flat: list[Any] = [xs[i : i + 3] for i in range(0, len(xs), 3)]
        kept, kept_sides = above(flat[0], flat[2:], flat[1])
        return abs(projected(kept, kept_sides, flat[1])) if kept_sides else 0.0

    if any(map(is_array, coordinates)):
        heights = [dot(unit, first) + dot(unit, side) for side in sides]
        if all(bool((h >= 0).all() if is_array(h) else h >= 0) for h in heights):
            return abs(projected(first, sides, unit))
    return each(one, *coordinates)
