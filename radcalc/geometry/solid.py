"""Solid angles [sr] of shapes, seen from a point.

The solid angle of a shape is the area that the shape covers on the unit sphere round the
observer (CIE e-ILV 17-21-109).  All directions together are 4 pi sr, those above a plane
2 pi sr.  It is what an intensity is multiplied by to give a flux; what a radiance is
multiplied by to give an irradiance is the *projected* solid angle of `radcalc.geometry.projected`.

Shapes: `zone`, `disc`, `rectangle`, `pyramid`, `patch`; those of `cones`, `spheres` and `polygons`
are in the modules of these names.  The functions whose names start with `check` refuse arguments
out of range, for this module and for `projected`.

Units: angles are in radians, solid angles in steradians.  The lengths of one call are in any
one unit, as only their ratios matter.  Every argument is a float or a NumPy array; arrays are
broadcast together, and the result has their shape.  A NaN is not refused: it gives NaN.

Precision: the closed forms are written so that no digits are lost where two nearly equal
numbers would be subtracted (narrow cones, distant discs, spheres seen from close by).  The
tests hold them to a relative 1e-12 of references that are computed with 80 digits.
"""

import math
from typing import Any

from radcalc.geometry.cones import HEMISPHERE, bounded, check_tilt, cone_of, facing, refuse
from radcalc.geometry.numerics.special import cel
from radcalc.maths import (
    SLACK,
    Number,
    asin,
    atan2,
    cos,
    hypot,
    larger,
    piecewise,
    power_of_two,
    sin,
    smaller,
    sqrt,
    square,
)


@bounded
def zone(lower: Number, upper: Number, azimuth: Number = 2 * math.pi) -> Number:
    """Solid angle of a spherical zone between two polar angles, or of a part of it in azimuth.

    With a part in azimuth it is a patch between two circles of latitude and two meridians.

    Parameters
    ----------
    lower, upper : float or ndarray [rad]
        Polar angles t0 and t1, from the zone's axis (not elevations), 0 <= t0 <= t1 <= pi.
    azimuth : float or ndarray [rad], optional
        Width dphi in azimuth, from 0 to 2 pi; the whole turn by default.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 4 pi.

    Raises
    ------
    ConditionError
        If a polar angle is outside 0 to pi, `lower` is above `upper`, or `azimuth` is outside
        0 to 2 pi.

    Notes
    -----
    ::

        Omega = dphi (cos(t0) - cos(t1)) = 2 dphi sin((t0 + t1)/2) sin((t1 - t0)/2)

    Exact.  The product is computed, not the difference of cosines, which loses digits in narrow
    zones and next to the poles.  The sine of the mean angle is expanded into the sines and cosines
    of t0/2 and t1/2, because rounding the sum t0 + t1 would cost digits next to the pole at pi.

    References
    ----------
    .. [1] ISO 80000-3, solid angle.

    Examples
    --------
    From 30 to 60 degrees: 2 pi (cos 30 - cos 60) = pi (sqrt(3) - 1).

    >>> import math
    >>> from radcalc.geometry import solid
    >>> band = solid.zone(math.radians(30), math.radians(60))
    >>> round(band / (math.pi * (math.sqrt(3) - 1)), 12)
    1.0

    One degree by one degree at the equator is close to the square degree, (pi/180)^2 sr:

    >>> cell = solid.zone(math.radians(89.5), math.radians(90.5), math.radians(1))
    >>> f"{cell:.6e}", f"{math.radians(1) ** 2:.6e}"
    ('3.046136e-04', '3.046174e-04')
    """
    check_zone(lower, upper, azimuth)
    # sin((t0 + t1)/2), from halves: no digit is lost near either pole
    middle = sin(lower / 2) * cos(upper / 2) + cos(lower / 2) * sin(upper / 2)
    return 2 * azimuth * middle * sin((upper - lower) / 2)


def check_zone(lower: Number, upper: Number, azimuth: Number) -> None:
    """Refuse polar angles and azimuths that bound no zone.

    Parameters
    ----------
    lower, upper : float or ndarray [rad]
        Polar angles, to be 0 <= lower <= upper <= pi.
    azimuth : float or ndarray [rad]
        Width in azimuth, to be from 0 to 2 pi.

    Raises
    ------
    ConditionError
        If a polar angle is outside 0 to pi, `lower` is above `upper`, or `azimuth` is outside
        0 to 2 pi.  Upper limits may be exceeded by a relative 1e-12.

    Examples
    --------
    >>> from radcalc.geometry.solid import check_zone
    >>> check_zone(0.0, 1.0, 2.0)
    >>> check_zone(1.0, 0.5, 2.0)
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: the zone ends before it starts
    try: the smaller polar angle first
    """
    refuse(
        (lower < 0) | (upper > math.pi * (1 + SLACK)),
        "a zone beyond the poles is out of range",
        "polar angles from 0 to 180 deg",
    )
    refuse(lower > upper, "the zone ends before it starts", "the smaller polar angle first")
    refuse(
        (azimuth < 0) | (azimuth > 2 * math.pi * (1 + SLACK)),
        "a zone of that width in azimuth is out of range",
        "from 0 to 360 deg",
    )


def check_height(height: Number) -> None:
    """Refuse an observer in or behind the plane of a flat shape.

    Parameters
    ----------
    height : float or ndarray
        Distance of the observer from the shape's plane, in any unit, to be above 0.

    Raises
    ------
    ConditionError
        If a height is 0 or negative.  From its own plane a flat shape is seen edge-on, and from
        a point on the shape the solid angle jumps between 2 pi and 0.

    Examples
    --------
    >>> from radcalc.geometry.solid import check_height
    >>> check_height(0.5)
    >>> check_height(0.0)
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: the observer is not above the shape's plane
    try: a height above 0 (edge-on, a flat shape fills no solid angle)
    """
    refuse(
        height <= 0,
        "the observer is not above the shape's plane",
        "a height above 0 (edge-on, a flat shape fills no solid angle)",
    )


@bounded
def disc(radius: Number, height: Number, offset: Number = 0.0) -> Number:
    """Solid angle of a circular disc, from a point on its axis or off it.

    Parameters
    ----------
    radius : float or ndarray [m]
        Radius R of the disc, 0 or more (any one unit of length for all arguments).
    height : float or ndarray [m]
        Distance h of the observer from the disc's *plane*, above 0.
    offset : float or ndarray [m], optional
        Distance x of the observer from the disc's axis; the sign does not matter.  0, on the
        axis, by default.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 2 pi.

    Raises
    ------
    ConditionError
        If a radius is negative, or a height is not above 0.

    Notes
    -----
    On the axis::

        Omega = 2 pi (1 - h / sqrt(h^2 + R^2)) = 4 pi sin^2(alpha/2),  tan(alpha) = R/h

    Off the axis it is a sum of complete elliptic integrals of the first and third kind [1]_; with
    r1 and r2 the distances to the nearest and the farthest point of the rim::

        Omega = turn - 4 (h / r2) cel(r1/r2, p, a, b)
        p = ((R - x) / (R + x))^2,  a = R / (R + x),  b = a (R - x) / (R + x)

    `cel` is Bulirsch's integral [2]_, and turn is how far the rim turns about the foot of the
    observer's perpendicular: 2 pi for x < R, pi for x = R and 0 for x > R.  For x = R, where p and
    b are 0, the integral is that of p = 1 and b = a.

    Beyond four radii from the centre that is a difference of nearly equal numbers.  There the mean
    of a positive function over 32 points of the rim is taken instead: the function is smooth and
    periodic, so the trapezoidal rule converges geometrically, and 26 points would give every digit.
    Both are exact but for rounding.

    References
    ----------
    .. [1] F. Paxton, Solid Angle Calculation for a Circular Disk, Rev. Sci. Instrum. 30 (1959)
       254, doi:10.1063/1.1716590.  Its form has Heuman's lambda function.
    .. [2] R. Bulirsch, Numerical Calculation of Elliptic Integrals and Elliptic Functions III,
       Numer. Math. 13 (1969) 305, doi:10.1007/BF02165405.

    Examples
    --------
    On the axis, where the rim is seen at 60 degrees, the disc fills the cone of 60 degrees, pi sr:

    >>> import math
    >>> from radcalc.geometry import solid
    >>> round(solid.disc(math.sqrt(3), 1.0) / math.pi, 12)
    1.0

    Just above a point of the rim it fills half of the hemisphere below the observer, also pi sr:

    >>> round(solid.disc(1.0, 1e-9, 1.0) / math.pi, 6)
    1.0
    """
    refuse(radius < 0, "a negative radius is out of range", "0 or more")
    check_height(height)
    offset = abs(offset)
    scale = power_of_two(larger(larger(radius, height), offset))
    radius, height, offset = radius / scale, height / scale, offset / scale
    far = 4 * radius < hypot(height, offset)
    return piecewise(far, _disc_from_afar, _disc_from_near, radius, height, offset)


def rim_of(solid_angle: Number) -> Number:
    """Angle of a disc's rim from its axis, seen from a place on the axis.

    Parameters
    ----------
    solid_angle : float or ndarray [sr]
        Of the disc, above 0 and below 2 pi.

    Returns
    -------
    float or ndarray [rad]
        The half angle of the cone that the rim fills, whose tangent is R/h.

    Raises
    ------
    ConditionError
        A solid angle that no disc fills.

    Notes
    -----
    The rim of a disc on its axis fills a cone, so this is `cone_of` below a hemisphere.

    Examples
    --------
    A disc as far away as its radius, 2 pi (1 - 1/sqrt 2) sr, has its rim at 45 degrees:

    >>> import math
    >>> from radcalc.geometry import solid
    >>> round(math.degrees(solid.rim_of(2 * math.pi * (1 - math.sqrt(0.5)))), 9)
    45.0
    """
    refuse(
        (solid_angle <= 0) | (solid_angle >= HEMISPHERE),
        "no disc seen from its axis fills that solid angle",
        "more than 0 and less than 2pi sr",
    )
    return cone_of(solid_angle)


RIM = 32  # points on a disc's rim; from four radii on, 26 give every digit


def _disc_from_afar(radius: Number, height: Number, offset: Number) -> Number:
    """Far from the disc: the mean over the rim of a positive function, by the trapezoidal rule.

    The function is the solid angle per turn about the line from the observer to the disc's centre.
    """
    away = hypot(height, offset)
    far, both, total = square(away), square(away) + square(radius), 0.0
    for k in range(RIM):
        along = radius * offset * math.cos(2 * math.pi * k / RIM)
        to_rim = sqrt(both + 2 * along)
        total = total + 1 / (to_rim * (to_rim * away + far + along))
    return 2 * math.pi / RIM * square(radius) * height * total


def _disc_from_near(radius: Number, height: Number, offset: Number) -> Number:
    """Near the disc: the rim's turn about the axis, less an elliptic integral.

    In polar coordinates about the observer's perpendicular, the disc is the integral of
    1 - cos(polar angle of the rim) over the azimuth; the turn is the integral of the 1.
    """
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


@bounded
def rectangle(
    width: Number, length: Number, height: Number, offset: Number = 0.0, offset_y: Number = 0.0
) -> Number:
    """Solid angle of a rectangle, from a point on its axis or off it.

    Parameters
    ----------
    width, length : float or ndarray [m]
        Whole sides along x and y, 0 or more (any one unit of length for all arguments).
    height : float or ndarray [m]
        Distance h of the observer from the rectangle's *plane*, above 0.
    offset, offset_y : float or ndarray [m], optional
        How far aside of the rectangle's axis the observer is, along x and along y; 0 by
        default.  Half a side each puts the observer above a corner.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 2 pi.

    Raises
    ------
    ConditionError
        If a side is negative, or a height is not above 0.

    Notes
    -----
    On the axis, with the half sides a and b::

        Omega = 4 arctan(a b / (h sqrt(a^2 + b^2 + h^2)))

    Exact everywhere.  Off the axis the rectangle is the sum of its two triangles (see
    `radcalc.geometry.polygons.triangle`); the textbook's four rectangles that meet below the
    observer are added and subtracted, and of a distant rectangle all digits would cancel.

    References
    ----------
    .. [1] A. Khadjavi, Calculation of solid angle subtended by rectangular apertures,
       J. Opt. Soc. Am. 58 (1968) 1417.

    Examples
    --------
    From the centre of a cube each of the six faces fills 4 pi/6 sr:

    >>> import math
    >>> from radcalc.geometry import cones, solid
    >>> round(solid.rectangle(2.0, 2.0, 1.0) / (4 * math.pi / 6), 12)
    1.0

    The part of a point source's light that falls on a rectangle of 1 m by 2 m, 0.5 m from the
    source above one of its corners, is published as 0.0836 (EES heat transfer library, FDiff_5):

    >>> round(solid.rectangle(1.0, 2.0, 0.5, 0.5, 1.0) / cones.FULL, 4)
    0.0836
    """
    from radcalc.geometry.polygons import fan

    return abs(fan(*corners(width, length, height, offset, offset_y)))


def corners(width: Number, length: Number, height: Number, offset: Number, offset_y: Number) -> Any:
    """Corners of a rectangle as `radcalc.geometry.polygons` takes them: a point, and sides from it.

    Parameters
    ----------
    width, length : float or ndarray [m]
        Whole sides along x and y, 0 or more (any one unit of length for all arguments).
    height : float or ndarray [m]
        Distance of the observer from the rectangle's plane, which is at z = height; above 0.
    offset, offset_y : float or ndarray [m]
        How far aside of the rectangle's axis the observer is, along x and along y.

    Returns
    -------
    first : tuple of 3 floats or ndarrays [m]
        The corner of the smallest x and y, from the observer.
    sides : list of 4 such tuples [m]
        All four corners from that one, counted from +x to +y; the first is zero.

    Raises
    ------
    ConditionError
        If a side is negative, a height is not above 0, or a length is infinite.

    Notes
    -----
    The corners are handed over as differences from the first one, because these are known exactly
    while the corners of a small and distant rectangle agree in most of their digits.

    Examples
    --------
    >>> from radcalc.geometry import solid
    >>> first, sides = solid.corners(2.0, 4.0, 1.0, 0.0, 0.0)
    >>> first
    (-1.0, -2.0, 1.0)
    >>> sides
    [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (2.0, 4.0, 0.0), (0.0, 4.0, 0.0)]
    """
    refuse((width < 0) | (length < 0), "a negative side is out of range", "0 or more")
    check_height(height)
    far = larger(larger(width, length), larger(height, larger(abs(offset), abs(offset_y))))
    refuse(far == math.inf, "an infinite length has no corners", "a length that is finite")
    corner = (-offset - width / 2, -offset_y - length / 2, height)
    return corner, [(0.0, 0.0, 0.0), (width, 0.0, 0.0), (width, length, 0.0), (0.0, length, 0.0)]


def pyramid(horizontal: Number, vertical: Number) -> Number:
    """Solid angle of a right rectangular pyramid, from its two apex angles.

    Parameters
    ----------
    horizontal, vertical : float or ndarray [rad]
        Full apex angles a and b, each between two opposite *faces* (such as a camera's
        horizontal and vertical field of view), from 0 to pi.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 2 pi.

    Raises
    ------
    ConditionError
        If an angle is outside 0 to pi.

    Notes
    -----
    ::

        Omega = 4 arcsin(sin(a/2) sin(b/2))

    Exact.  The arcsine loses digits where its argument is next to 1; the arctangent of the same
    angle keeps them, atan2(sin(a/2) sin(b/2), sqrt(cos^2(a/2) + sin^2(a/2) cos^2(b/2))).  The
    angles between opposite *edges* would be smaller, and have another formula.

    Examples
    --------
    The pyramid of 90 by 90 degrees is the face of a cube seen from its centre, 4 pi/6 sr:

    >>> import math
    >>> from radcalc.geometry import solid
    >>> round(solid.pyramid(math.pi / 2, math.pi / 2) / (4 * math.pi / 6), 12)
    1.0

    With one angle open to 180 degrees it is a wedge, whose solid angle is twice the other angle:

    >>> round(solid.pyramid(0.5, math.pi), 12)
    1.0
    """
    check_pyramid(horizontal, vertical)
    a, b = horizontal / 2, vertical / 2
    return 4 * atan2(sin(a) * sin(b), hypot(cos(a), sin(a) * cos(b)))


def pyramid_side(solid_angle: Number, other: Number) -> Number:
    """Full apex angle of a right rectangular pyramid, from its solid angle and the other one.

    Parameters
    ----------
    solid_angle : float or ndarray [sr]
        Of the pyramid.
    other : float or ndarray [rad]
        The known full angle, face to face, above 0 and at most pi.

    Returns
    -------
    float or ndarray [rad]
        The full angle between the other two faces, from 0 to pi.

    Raises
    ------
    ConditionError
        A solid angle that is too large for that angle, or an angle that no pyramid has.

    Notes
    -----
    ::

        sin(b/2) = sin(Omega/4) / sin(a/2)

    `pyramid` solved for one of its angles.

    Examples
    --------
    >>> import math
    >>> from radcalc.geometry import solid
    >>> omega = solid.pyramid(math.radians(60), math.radians(40))
    >>> round(math.degrees(solid.pyramid_side(omega, math.radians(60))), 9)
    40.0
    """
    check_pyramid(other, other)
    text = "no pyramid of that angle fills that solid angle"
    refuse((solid_angle < 0) | (solid_angle > HEMISPHERE), text, "from 0 to 2pi sr")
    sine, widest = sin(solid_angle / 4), sin(other / 2)
    refuse((sine > widest * (1 + SLACK)) | (widest == 0), text, "a smaller solid angle")
    return 2 * asin(smaller(sine / widest, 1.0 + 0 * sine))


def check_pyramid(horizontal: Number, vertical: Number) -> None:
    """Refuse apex angles that no pyramid has.

    Parameters
    ----------
    horizontal, vertical : float or ndarray [rad]
        Full apex angles, to be from 0 to pi.

    Raises
    ------
    ConditionError
        If an angle is negative or above pi.

    Examples
    --------
    >>> from radcalc.geometry.solid import check_pyramid
    >>> check_pyramid(1.0, 0.5)
    >>> check_pyramid(-1.0, 0.5)
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: a pyramid of those angles is out of range
    try: from 0 to 180 deg, face to face
    """
    top = math.pi * (1 + SLACK)
    bad = (horizontal < 0) | (vertical < 0) | (horizontal > top) | (vertical > top)
    refuse(bad, "a pyramid of those angles is out of range", "from 0 to 180 deg, face to face")


@bounded
def patch(area: Number, distance: Number, tilt: Number = 0.0) -> Number:
    """Solid angle of a small flat patch of any outline, to first order in its size.

    Parameters
    ----------
    area : float or ndarray [m^2]
        Area A of the patch, 0 or more.
    distance : float or ndarray [m]
        Distance d from the observer to the patch, above 0.
    tilt : float or ndarray [rad], optional
        Angle theta between the patch's normal and the line of sight, from -pi to pi; 0, facing
        the observer, by default.

    Returns
    -------
    float or ndarray [sr]
        0 or more; 0 from pi/2 on, where the patch is seen edge-on or from behind.

    Raises
    ------
    ConditionError
        If an area is negative, a distance is not above 0, or a tilt is beyond pi.

    Notes
    -----
    ::

        Omega = A cos(theta) / d^2

    It is the first term of a series in size over distance, and no bound: close to a patch it
    exceeds 2 pi.  Of a disc of radius R that faces the observer it is too large by the relative
    3/4 (R/d)^2, which is 0.75 % at a distance of five diameters.

    Examples
    --------
    >>> import math
    >>> from radcalc.geometry import solid
    >>> round(solid.patch(2.0, 10.0, math.radians(60)), 12)
    0.01

    A disc of radius 1 m from 10 m, against the exact solid angle:

    >>> round(solid.patch(math.pi, 10.0) / solid.disc(1.0, 10.0) - 1, 4)
    0.0075
    """
    refuse(area < 0, "a negative area is out of range", "0 or more")
    refuse(distance <= 0, "the observer is on the patch", "a distance above 0")
    check_tilt(tilt)
    return area / square(distance) * facing(tilt)
