"""Solid angles [sr] of shapes from a point, plain and projected; etendues of beams [m^2 sr].

The solid angle is the area that a shape covers on the unit sphere round the observer (CIE e-ILV
17-21-109).  An intensity times a solid angle is a flux.

The projected solid angle weights each direction above the receiver's horizon by the cosine of its
angle to the receiver's normal::

    Omega_p = integral of cos(theta) dOmega,  theta < pi/2

It is pi sr for the whole hemisphere.  A uniform radiance (or luminance) L gives the irradiance
(illuminance) E = L Omega_p.  Omega_p / pi is the configuration factor from the surface element to
the shape (CIE e-ILV 17-29-093), or view factor.  Functions whose names start with `projected` take
the arguments of those without it, and a `tilt` that turns the receiver away from the shape, or its
`normal`.  Shapes that the horizon cuts are computed element by element, which is slower for arrays.

J. R. Howell's Catalog of Radiation Heat Transfer Configuration Factors has most of the formulas;
the forms here keep the digits of small shapes.

The etendue of a beam (geometric extent, CIE e-ILV 17-21-047) is the integral of its cross-section
over solid angle::

    G = integral of  dA1 cos(theta1) dA2 cos(theta2) / r^2  =  integral of  dA cos(theta) dOmega

A uniform radiance (or luminance) L sends the flux Phi = L G.  For a small patch, G is its area
times the projected solid angle of the other surface.  Lengths in another unit than metres give G in
its square times sr.  All beams are in a medium of refractive index 1 (refraction conserves n^2 G).

Cones are in `radcalc.geometry`, polygons in `polygons`.  A sphere fills the cone that touches it.
Functions whose names start with `check` refuse arguments out of range.

Angles are in radians, solid angles in steradians, the lengths of one call in any one unit.
Arguments are floats or NumPy arrays, broadcast together; the result has their shape.  NaN gives
NaN.

Precision: the closed forms avoid differences of nearly equal numbers (narrow cones, distant discs,
spheres seen from close by).  In the tests they agree to a relative 1e-12 with references computed
with 80 digits.
"""

import math
from functools import reduce
from typing import Any

from radcalc import geometry, maths
from radcalc.errors import ConditionError, Try, add, computed
from radcalc.geometry import FULL, HEMISPHERE, bounded, check_tilt, cone, cone_of, facing, refuse
from radcalc.geometry.numerics import adaptive, cel, integral, less_arctangent
from radcalc.geometry.projections import NO_NORMAL, UP, dot, unit, vector


@bounded
def zone(
    lower: maths.Number, upper: maths.Number, azimuth: maths.Number = 2 * math.pi
) -> maths.Number:
    """Return the solid angle of a spherical zone between two polar angles, or of a part of it.

    Parameters
    ----------
    lower, upper : float or ndarray [rad]
        Polar angles t0 and t1, from the zone's axis (not elevations), 0 <= t0 <= t1 <= pi.
    azimuth : float or ndarray [rad], optional
        Width dphi in azimuth, from 0 to 2 pi.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 4 pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega = dphi (cos(t0) - cos(t1)) = 2 dphi sin((t0 + t1)/2) sin((t1 - t0)/2)

    Exact.  The difference of cosines would lose digits in narrow zones and next to the poles.  The
    sine of the mean angle is expanded into those of t0/2 and t1/2, because rounding t0 + t1 would
    cost digits next to the pole at pi.

    References
    ----------
    .. [1] ISO 80000-3, solid angle.

    Examples
    --------
    From 30 to 60 degrees: 2 pi (cos 30 - cos 60) = pi (sqrt(3) - 1).

    >>> band = zone(math.radians(30), math.radians(60))
    >>> round(band / (math.pi * (math.sqrt(3) - 1)), 12)
    1.0
    """
    check_zone(lower, upper, azimuth)
    # sin((t0 + t1)/2), from halves: exact near both poles
    middle = maths.sin(lower / 2) * maths.cos(upper / 2) + maths.cos(lower / 2) * maths.sin(
        upper / 2
    )
    return 2 * azimuth * middle * maths.sin((upper - lower) / 2)


def check_zone(lower: maths.Number, upper: maths.Number, azimuth: maths.Number) -> None:
    """Refuse polar angles and azimuths that do not bound a zone.

    Parameters
    ----------
    lower, upper : float or ndarray [rad]
        Polar angles: 0 <= lower <= upper <= pi.
    azimuth : float or ndarray [rad]
        Width in azimuth, from 0 to 2 pi.

    Raises
    ------
    ConditionError
        If an argument is out of range; upper limits may be exceeded by a relative 1e-12.

    Examples
    --------
    >>> check_zone(0.0, 1.0, 2.0)
    >>> check_zone(1.0, 0.5, 2.0)
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: the zone ends before it starts
    try: the smaller polar angle first
    """
    refuse(
        (lower < 0) | (upper > math.pi * (1 + maths.SLACK)),
        "the polar angle of the zone is out of range",
        "polar angles from 0 to 180 deg",
    )
    refuse(lower > upper, "the zone ends before it starts", "the smaller polar angle first")
    refuse(
        (azimuth < 0) | (azimuth > 2 * math.pi * (1 + maths.SLACK)),
        "the width of the zone in azimuth is out of range",
        "from 0 to 360 deg",
    )


def check_height(height: maths.Number) -> None:
    """Refuse an observer who is not in front of the plane of a flat shape.

    Parameters
    ----------
    height : float or ndarray
        Distance of the observer from the shape's plane, in any unit.

    Raises
    ------
    ConditionError
        If a height is 0 or negative.  At 0 the shape is seen edge-on, or, from a point on it, its
        solid angle jumps between 2 pi and 0.

    Examples
    --------
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
def disc(radius: maths.Number, height: maths.Number, offset: maths.Number = 0.0) -> maths.Number:
    """Return the solid angle of a circular disc, from a point on its axis or off it.

    Parameters
    ----------
    radius : float or ndarray [m]
        Radius R of the disc, 0 or more.
    height : float or ndarray [m]
        Distance h of the observer from the disc's *plane*, above 0.
    offset : float or ndarray [m], optional
        Distance x of the observer from the disc's axis; its sign does not matter.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 2 pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    On the axis::

        Omega = 2 pi (1 - h / sqrt(h^2 + R^2)) = 4 pi sin^2(alpha/2),  tan(alpha) = R/h

    Off the axis it is a sum of complete elliptic integrals of the first and third kind [1]_.  With
    r1 and r2 the distances to the nearest and the farthest point of the rim::

        Omega = turn - 4 (h / r2) cel(r1/r2, p, a, b)
        p = ((R - x) / (R + x))^2,  a = R / (R + x),  b = a (R - x) / (R + x)

    `cel` is Bulirsch's integral [2]_, and turn is the angle of the rim about the foot of the
    observer's perpendicular: 2 pi for x < R, pi for x = R and 0 for x > R.  For x = R, where p and
    b are 0, the integral is that of p = 1 and b = a.

    Beyond four radii from the centre this is a difference of nearly equal numbers, and is replaced
    by the mean of a smooth positive function over 32 points of the rim; 26 points give every digit.
    Both are exact except for rounding.

    References
    ----------
    .. [1] F. Paxton, Solid Angle Calculation for a Circular Disk, Rev. Sci. Instrum. 30 (1959)
       254, doi:10.1063/1.1716590.  Its form has Heuman's lambda function.
    .. [2] R. Bulirsch, Numerical Calculation of Elliptic Integrals and Elliptic Functions III,
       Numer. Math. 13 (1969) 305, doi:10.1007/BF02165405.

    Examples
    --------
    On the axis, with its rim at 60 degrees, the disc fills the cone of 60 degrees, pi sr:

    >>> round(disc(math.sqrt(3), 1.0) / math.pi, 12)
    1.0
    """
    refuse(radius < 0, "the radius is out of range", "0 or more")
    check_height(height)
    offset = abs(offset)
    scale = maths.power_of_two(maths.larger(maths.larger(radius, height), offset))
    radius, height, offset = radius / scale, height / scale, offset / scale
    far = 4 * radius < maths.hypot(height, offset)
    return maths.piecewise(far, _disc_from_afar, _disc_from_near, radius, height, offset)


def rim_of(solid_angle: maths.Number) -> maths.Number:
    """Return the angle between a disc's axis and its rim, seen from a point on the axis.

    Parameters
    ----------
    solid_angle : float or ndarray [sr]
        Solid angle of the disc, above 0 and below 2 pi.

    Returns
    -------
    float or ndarray [rad]
        The half angle of the cone that the disc fills, as `cone_of`; its tangent is R/h.

    Raises
    ------
    ConditionError
        If no disc fills the solid angle.

    Examples
    --------
    A disc at the distance of its radius fills 2 pi (1 - 1/sqrt 2) sr, with its rim at 45 degrees:

    >>> round(math.degrees(rim_of(2 * math.pi * (1 - math.sqrt(0.5)))), 9)
    45.0
    """
    refuse(
        (solid_angle <= 0) | (solid_angle >= HEMISPHERE),
        "the solid angle is out of range for a disc seen from its axis",
        "more than 0 and less than 2pi sr",
    )
    return cone_of(solid_angle)


RIM = 32  # points on a disc's rim; beyond four radii, 26 give every digit


def _disc_from_afar(
    radius: maths.Number, height: maths.Number, offset: maths.Number
) -> maths.Number:
    """Integrate a distant disc: the mean of a function over its rim, by the trapezoidal rule.

    The function is the solid angle per turn about the line from the observer to the disc's centre.
    """
    away = maths.hypot(height, offset)
    far, both, total = maths.square(away), maths.square(away) + maths.square(radius), 0.0
    for k in range(RIM):
        along = radius * offset * math.cos(2 * math.pi * k / RIM)
        to_rim = maths.sqrt(both + 2 * along)
        total = total + 1 / (to_rim * (to_rim * away + far + along))
    return 2 * math.pi / RIM * maths.square(radius) * height * total


def _disc_from_near(
    radius: maths.Number, height: maths.Number, offset: maths.Number
) -> maths.Number:
    """Return the solid angle of a near disc: the turn of its rim, minus an elliptic integral.

    In polar coordinates about the observer's perpendicular, the solid angle is the integral of
    1 - cos(polar angle of the rim) over the azimuth; the turn is the integral of the 1.
    """
    nearest, farthest = maths.hypot(height, offset - radius), maths.hypot(height, offset + radius)
    inside, outside = radius - offset, radius + offset
    # The rim turns by 2 pi, pi or 0 about the observer's foot; on the rim itself the integral has
    # no pole, and is of the first kind.
    turn = math.pi * (1.0 * (inside >= 0) + 1.0 * (inside > 0))
    rim = inside == 0
    p = maths.piecewise(rim, lambda x: 1.0 + x, lambda x: x * x, inside / outside)
    b = maths.piecewise(rim, lambda x: 1.0 + x, lambda x: x, inside / outside)
    part = radius / outside
    return turn - 4 * height / farthest * cel(nearest / farthest, p, part, part * b)


@bounded
def rectangle(
    width: maths.Number,
    length: maths.Number,
    height: maths.Number,
    offset: maths.Number = 0.0,
    offset_y: maths.Number = 0.0,
) -> maths.Number:
    """Return the solid angle of a rectangle, from a point on its axis or off it.

    Parameters
    ----------
    width, length : float or ndarray [m]
        Whole sides along x and y, 0 or more.
    height : float or ndarray [m]
        Distance h of the observer from the rectangle's *plane*, above 0.
    offset, offset_y : float or ndarray [m], optional
        Sideways distance of the observer from the rectangle's axis, along x and y.
        With half a side each, the observer is above a corner.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 2 pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    On the axis, with the half sides a and b::

        Omega = 4 arctan(a b / (h sqrt(a^2 + b^2 + h^2)))

    Exact.  Computed as the sum of two triangles (see `radcalc.geometry.polygons.triangle`); the
    textbooks' sum over four rectangles loses all digits of a distant rectangle.

    References
    ----------
    .. [1] A. Khadjavi, Calculation of solid angle subtended by rectangular apertures,
       J. Opt. Soc. Am. 58 (1968) 1417.

    Examples
    --------
    The part of a point source's light that falls on a rectangle of 1 m by 2 m, 0.5 m from the
    source above one of its corners, is published as 0.0836 (EES heat transfer library, FDiff_5):

    >>> round(rectangle(1.0, 2.0, 0.5, 0.5, 1.0) / (4 * math.pi), 4)
    0.0836
    """
    from radcalc.geometry.polygons import fan

    return abs(fan(*corners(width, length, height, offset, offset_y)))


def corners(
    width: maths.Number,
    length: maths.Number,
    height: maths.Number,
    offset: maths.Number,
    offset_y: maths.Number,
) -> Any:
    """Return the corners of a rectangle in the form that `radcalc.geometry.polygons` takes.

    Parameters
    ----------
    width, length, height, offset, offset_y : float or ndarray [m]
        As in `rectangle`, whose plane is at z = height.

    Returns
    -------
    first : tuple of 3 floats or ndarrays [m]
        The corner with the smallest x and y, from the observer.
    sides : list of 4 such tuples [m]
        All four corners relative to it, in order from +x to +y; the first is zero.

    Raises
    ------
    ConditionError
        If an argument is out of range, or a length is infinite.

    Notes
    -----
    The differences are known exactly, while the corners of a small and distant rectangle agree in
    most of their digits.

    Examples
    --------
    >>> first, sides = corners(2.0, 4.0, 1.0, 0.0, 0.0)
    >>> first
    (-1.0, -2.0, 1.0)
    >>> sides
    [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (2.0, 4.0, 0.0), (0.0, 4.0, 0.0)]
    """
    refuse((width < 0) | (length < 0), "the side is out of range", "0 or more")
    check_height(height)
    far = maths.larger(
        maths.larger(width, length), maths.larger(height, maths.larger(abs(offset), abs(offset_y)))
    )
    refuse(far == math.inf, "a length of the rectangle is infinite", "a length that is finite")
    corner = (-offset - width / 2, -offset_y - length / 2, height)
    return corner, [(0.0, 0.0, 0.0), (width, 0.0, 0.0), (width, length, 0.0), (0.0, length, 0.0)]


def pyramid(horizontal: maths.Number, vertical: maths.Number) -> maths.Number:
    """Return the solid angle of a right rectangular pyramid from its two apex angles.

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
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega = 4 arcsin(sin(a/2) sin(b/2))

    Exact; computed by an arctangent, atan2(sin(a/2) sin(b/2), sqrt(cos^2(a/2) + sin^2(a/2)
    cos^2(b/2))), because the arcsine loses digits close to 1.  The angles between opposite *edges*
    are smaller and have another formula.

    Examples
    --------
    The pyramid of 90 by 90 degrees is the face of a cube seen from its centre, 4 pi/6 sr:

    >>> round(pyramid(math.pi / 2, math.pi / 2) / (4 * math.pi / 6), 12)
    1.0
    """
    check_pyramid(horizontal, vertical)
    a, b = horizontal / 2, vertical / 2
    return 4 * maths.atan2(
        maths.sin(a) * maths.sin(b), maths.hypot(maths.cos(a), maths.sin(a) * maths.cos(b))
    )


def pyramid_side(solid_angle: maths.Number, other: maths.Number) -> maths.Number:
    """Return one full apex angle of a right rectangular pyramid from the other and its solid angle.

    Parameters
    ----------
    solid_angle : float or ndarray [sr]
        Solid angle of the pyramid.
    other : float or ndarray [rad]
        The other full apex angle, face to face, above 0 and at most pi.

    Returns
    -------
    float or ndarray [rad]
        The full angle between the other two faces, from 0 to pi.

    Raises
    ------
    ConditionError
        If an argument is out of range, or the solid angle is too large for that angle.

    Notes
    -----
    ::

        sin(b/2) = sin(Omega/4) / sin(a/2)

    `pyramid` solved for one of its angles.

    Examples
    --------
    >>> omega = pyramid(math.radians(60), math.radians(40))
    >>> round(math.degrees(pyramid_side(omega, math.radians(60))), 9)
    40.0
    """
    check_pyramid(other, other)
    text = "the solid angle is out of range for a pyramid of that angle"
    refuse((solid_angle < 0) | (solid_angle > HEMISPHERE), text, "from 0 to 2pi sr")
    sine, widest = maths.sin(solid_angle / 4), maths.sin(other / 2)
    refuse((sine > widest * (1 + maths.SLACK)) | (widest == 0), text, "a smaller solid angle")
    return 2 * maths.asin(maths.smaller(sine / widest, 1.0 + 0 * sine))


def check_pyramid(horizontal: maths.Number, vertical: maths.Number) -> None:
    """Refuse apex angles outside 0 to pi.

    Parameters
    ----------
    horizontal, vertical : float or ndarray [rad]
        Full apex angles.

    Raises
    ------
    ConditionError : argument out of range

    Examples
    --------
    >>> check_pyramid(1.0, 0.5)
    >>> check_pyramid(-1.0, 0.5)
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: the angle of the pyramid is out of range
    try: from 0 to 180 deg, face to face
    """
    top = math.pi * (1 + maths.SLACK)
    bad = (horizontal < 0) | (vertical < 0) | (horizontal > top) | (vertical > top)
    refuse(bad, "the angle of the pyramid is out of range", "from 0 to 180 deg, face to face")


@bounded
def patch(area: maths.Number, distance: maths.Number, tilt: maths.Number = 0.0) -> maths.Number:
    """Return the solid angle of a small flat patch of any outline, to first order in its size.

    Parameters
    ----------
    area : float or ndarray [m^2]
        Area A of the patch, 0 or more.
    distance : float or ndarray [m]
        Distance d from the observer to the patch, above 0.
    tilt : float or ndarray [rad], optional
        Angle theta between the patch's normal and the line to the observer, from -pi to pi;
        0 (facing the observer) by default.

    Returns
    -------
    float or ndarray [sr]
        0 or more; 0 for tilts from pi/2 on, at which the patch is edge-on or turned away.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega = A cos(theta) / d^2

    The first term of a series in size over distance: close to a patch it exceeds 2 pi.  For a disc
    of radius R that faces the observer it is too large by a relative 3/4 (R/d)^2, 0.75 % at a
    distance of five diameters.

    Examples
    --------
    >>> round(patch(2.0, 10.0, math.radians(60)), 12)
    0.01
    """
    refuse(area < 0, "the area is out of range", "0 or more")
    refuse(distance <= 0, "the observer is on the patch", "a distance above 0")
    check_tilt(tilt)
    return area / maths.square(distance) * facing(tilt)


@bounded
def angular_radius(radius: maths.Number, distance: maths.Number) -> maths.Number:
    """Return the angular radius of a sphere: the half angle of the cone that touches it.

    Parameters
    ----------
    radius : float or ndarray [m]
        Radius R of the sphere, 0 or more.
    distance : float or ndarray [m]
        Distance D from the observer to the *centre* of the sphere, above `radius`.

    Returns
    -------
    float or ndarray [rad]
        From 0 to below pi/2.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        sin(alpha) = R / D,  computed as  alpha = atan2(R, sqrt((D - R)(D + R)))

    Exact.  (A flat disc of the same radius and distance has tan(alpha) = R/D.)  The arctangent with
    D - R keeps the digits close to the surface.

    Examples
    --------
    >>> import math
    >>> round(math.degrees(angular_radius(1.0, 2.0)), 12)
    30.0
    """
    refuse((radius < 0), "the radius is out of range", "0 or more")
    if maths.any_true(distance <= radius):
        raise ConditionError(
            "the observer is on or inside the sphere",
            "a distance to the centre greater than the radius; from its surface, the sphere fills "
            "2 pi sr",
            _from_surface(radius, distance),
        )
    # R / sqrt(D^2 - R^2), which keeps its digits up to the surface
    return maths.atan2(radius, maths.sqrt(distance - radius) * maths.sqrt(distance + radius))


def _from_surface(radius: maths.Number, distance: maths.Number) -> list[Try]:
    """Propose the distance to the centre, if the given one was measured from the surface."""
    if maths.is_array(radius) or maths.is_array(distance):
        return []
    remark = f"if {distance:g} m is the distance from the surface"
    return [computed(add("distance", f"{radius + distance:.6g}m", remark))]


def sphere(radius: maths.Number, distance: maths.Number) -> maths.Number:
    """Return the solid angle of a sphere seen from outside.

    Parameters
    ----------
    radius, distance : float or ndarray [m]
        As in `angular_radius`.

    Returns
    -------
    float or ndarray [sr]
        From 0 to below 2 pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega = 2 pi (1 - sqrt(1 - (R/D)^2)) = 4 pi sin^2(alpha/2),  sin(alpha) = R/D

    Exact; the second form is computed, by `angular_radius` and `cone`, because the first loses the
    digits of small and distant spheres.

    Examples
    --------
    The sun at its mean distance (radius 695 700 km, 1 au):

    >>> f"{sphere(695_700e3, 149_597_870_700.0):.3e}"
    '6.794e-05'
    """
    return cone(angular_radius(radius, distance))


def _sine(solid_angle: maths.Number) -> maths.Number:
    """Return the sine of the half angle of a sphere's cone, from its solid angle.

    With p = Omega/(4 pi) = sin^2(alpha/2), sin(alpha) = 2 sqrt(p (1 - p)).
    """
    part = solid_angle / FULL
    refuse(
        (part <= 0) | (part >= 0.5),
        "the solid angle is out of range for a sphere seen from outside",
        "more than 0 and less than 2pi sr",
    )
    return 2 * maths.sqrt(part) * maths.sqrt(1 - part)


@bounded
def sphere_distance(radius: maths.Number, solid_angle: maths.Number) -> maths.Number:
    """Return the distance of the centre of a sphere that fills a given solid angle.

    Parameters
    ----------
    radius : float or ndarray [m]
        Radius R of the sphere, in any unit of length.
    solid_angle : float or ndarray [sr]
        Solid angle Omega of the sphere, above 0 and below 2 pi.

    Returns
    -------
    float or ndarray [m]
        Distance from the observer to the *centre*, in the unit of `radius`.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        D = R / sin(alpha),  sin(alpha) = 2 sqrt(p (1 - p)),  p = Omega / (4 pi)

    Exact.

    Examples
    --------
    >>> import math
    >>> from radcalc import geometry
    >>> round(sphere_distance(1.0, geometry.cone(math.radians(30))), 12)
    2.0
    """
    return radius / _sine(solid_angle)


@bounded
def sphere_radius(distance: maths.Number, solid_angle: maths.Number) -> maths.Number:
    """Return the radius of a sphere that fills a given solid angle at a given distance.

    Parameters
    ----------
    distance : float or ndarray [m]
        Distance D from the observer to the *centre* of the sphere, in any unit of length.
    solid_angle : float or ndarray [sr]
        As in `distance_of`.

    Returns
    -------
    float or ndarray [m]
        Radius, in the unit of `distance`.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        R = D sin(alpha),  sin(alpha) = 2 sqrt(p (1 - p)),  p = Omega / (4 pi)

    Exact.

    Examples
    --------
    >>> import math
    >>> from radcalc import geometry
    >>> round(sphere_radius(2.0, geometry.cone(math.radians(30))), 12)
    1.0
    """
    return distance * _sine(solid_angle)


RIGHT = math.pi / 2  # [rad] a right angle


@geometry.bounded
def projected_cone(half_angle: maths.Number, tilt: maths.Number = 0.0) -> maths.Number:
    """Return the projected solid angle of a circular cone tilted from the receiver's normal.

    Parameters
    ----------
    half_angle : float or ndarray [rad]
        Half angle alpha of the cone, from 0 to pi.
    tilt : float or ndarray [rad], optional
        Angle t between the cone's axis and the receiver's normal, from -pi to pi; its sign does
        not matter.

    Returns
    -------
    float or ndarray [sr]
        From 0 to pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    If the whole cone is above the horizon, alpha + t <= pi/2::

        Omega_p = pi sin^2(alpha) cos(t)

    If the horizon cuts it, with u = cos(t)/sin(alpha), from 1 (all above) to -1 (all below)::

        Omega_p = arctan(w) - w cos^2(alpha) + sin^2(alpha) cos(t) arccos(-u cos(alpha)/sin(t))
        w = tan(alpha) sqrt(1 - u^2)

    Both are exact.  For a narrow cone, arctan(w) - w cos^2(alpha) is computed as w sin^2(alpha)
    minus w - arctan(w).  If almost all of the cone is below the horizon (u below -0.9) all terms
    cancel, and the rest is integrated numerically.  For a cone wider than a hemisphere, the
    opposite cone is subtracted from the receiver's pi.

    Examples
    --------
    A surface tilted by t sees (1 + cos(t))/2 of a uniform sky:

    >>> round(projected_cone(math.pi / 2, math.radians(60)) / math.pi, 12)
    0.75
    """
    geometry.cone(half_angle)  # checks the half angle
    geometry.check_tilt(tilt)
    return maths.each(_cone, half_angle, abs(tilt))


def _cone(half_angle: float, tilt: float) -> maths.Number:
    """Return the projected solid angle of one cone; `tilt` is not negative."""
    if half_angle > RIGHT:
        return math.pi - _cone(math.pi - half_angle, math.pi - tilt)
    sine, cosine = math.sin(half_angle), math.cos(tilt)
    if cosine >= sine:
        return math.pi * sine**2 * cosine
    if cosine <= -sine * (1 - maths.SLACK):
        return 0.0
    if cosine < -0.9 * sine:
        return _crescent(half_angle, tilt)
    # u: from -1 (the whole cone is below the horizon) to 1 (above)
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
    """Integrate a cone that is almost wholly below the horizon, zone by zone below its top.

    The zones' depth below the top grows as the square of the variable, which removes the square
    root at the top from the integrand.
    """
    # From the cosine: pi/2 - tilt would lose the digits of a small angle.
    highest = math.asin(math.cos(tilt)) + half_angle  # elevation of the cone's highest point

    def zone(s: float) -> float:  # below the highest point by highest * s^2
        below = highest * s * s
        height = highest - below
        sine = math.sin(half_angle - below / 2) * math.sin(below / 2)
        turn = 4 * math.asin(math.sqrt(sine / (math.sin(tilt) * math.cos(height))))
        return turn * math.sin(height) * math.cos(height) * 2 * highest * s

    return integral(zone, 0.0, 1.0)


@geometry.bounded
def projected_zone(
    lower: maths.Number, upper: maths.Number, azimuth: maths.Number = 2 * math.pi
) -> maths.Number:
    """Return the projected solid angle of a spherical zone about the normal, or of a part of it.

    Parameters
    ----------
    lower, upper : float or ndarray [rad]
        Polar angles t0 and t1, from the receiver's normal, 0 <= t0 <= t1 <= pi.  Directions past
        pi/2 are below the horizon and do not count.
    azimuth : float or ndarray [rad], optional
        Width dphi in azimuth, from 0 to 2 pi.

    Returns
    -------
    float or ndarray [sr]
        From 0 to pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega_p = dphi (sin^2(t1) - sin^2(t0)) / 2 = (dphi/2) sin(t0 + t1) sin(t1 - t0)

    with t0 and t1 at most pi/2.  Exact; the product keeps the digits of narrow zones.

    Examples
    --------
    Half of the illuminance of a uniform sky is from within 45 degrees:

    >>> round(projected_zone(0.0, math.pi / 4) / math.pi, 12)
    0.5
    """
    check_zone(lower, upper, azimuth)
    lower, upper = maths.smaller(lower, RIGHT + 0 * lower), maths.smaller(upper, RIGHT + 0 * upper)
    sum_ = maths.sin(lower) * maths.cos(upper) + maths.cos(lower) * maths.sin(upper)
    return azimuth / 2 * sum_ * maths.sin(upper - lower)


@geometry.bounded
def projected_sphere(
    radius: maths.Number, distance: maths.Number, tilt: maths.Number = 0.0
) -> maths.Number:
    """Return the projected solid angle of a sphere, seen from a receiver outside it.

    Parameters
    ----------
    radius, distance : float or ndarray [m]
        As in `radcalc.geometry.solid.angular_radius`.
    tilt : float or ndarray [rad], optional
        Angle t between the receiver's normal and the direction of the centre, from -pi to pi;
        0 (facing the sphere) by default.

    Returns
    -------
    float or ndarray [sr]
        From 0 to pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    If the sphere is wholly above the horizon::

        Omega_p = pi (R/D)^2 cos(t)

    Exact at every distance: the inverse square law holds for a uniform sphere as for a point.
    If the horizon cuts the sphere, the formula of `cone` holds, with sin(alpha) = R/D.

    Examples
    --------
    >>> round(projected_sphere(1.0, 2.0) / math.pi, 12)
    0.25
    """
    return projected_cone(angular_radius(radius, distance), tilt)


@geometry.bounded
def projected_disc(
    radius: maths.Number, height: maths.Number, offset: maths.Number = 0.0, tilt: maths.Number = 0.0
) -> maths.Number:
    """Return the projected solid angle of a circular disc, for a receiver parallel to it or tilted.

    Parameters
    ----------
    radius, height, offset : float or ndarray [m]
        As in `radcalc.geometry.solid.disc`.
    tilt : float or ndarray [rad], optional
        Rotation t of the receiver in the plane of the offset, from -pi to pi: 0 (the default)
        parallel to the disc, positive towards the disc's axis, negative away from it.

    Returns
    -------
    float or ndarray [sr]
        From 0 to pi.

    Raises
    ------
    ConditionError
        If an argument is out of range, or the integral of a disc that the horizon cuts does not
        converge.

    Notes
    -----
    On the axis, if the disc is wholly above the horizon::

        Omega_p = pi R^2 / (R^2 + h^2) cos(t)

    Off the axis and facing the disc's plane, with Z = h^2 + x^2 + R^2::

        Omega_p = (pi/2) (1 - (Z - 2 R^2) / sqrt(Z^2 - 4 R^2 x^2))

    Both are exact.  The second is computed without its differences.  If the whole disc is above a
    tilted receiver's horizon, the sum of cos(t) times that and sin(t) times the component of the
    light vector towards the axis holds.  A disc that the horizon cuts is integrated strip by strip.

    References
    ----------
    .. [1] J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-13 (on the
       axis, tilted).

    Examples
    --------
    Below a point of the rim, at the same height, Z = 3 and Omega_p = (pi/2) (1 - 1/sqrt(5)):

    >>> round(projected_disc(1.0, 1.0, 1.0), 6), round(math.pi / 2 * (1 - 1 / math.sqrt(5)), 6)
    (0.868315, 0.868315)
    """
    geometry.refuse(radius < 0, "the radius is out of range", "0 or more")
    check_height(height)
    geometry.check_tilt(tilt)
    scale = maths.power_of_two(maths.larger(maths.larger(radius, height), abs(offset)))
    radius, height, offset = radius / scale, height / scale, abs(offset) / scale
    if not maths.is_array(tilt) and tilt == 0:
        return _facing_disc(radius, height, offset)[1]
    return maths.each(_tilted_disc, radius, height, offset, tilt)


def _facing_disc(
    radius: maths.Number, height: maths.Number, offset: maths.Number
) -> tuple[maths.Number, maths.Number]:
    """Return the light vector of a whole disc: components towards the disc's axis and along it."""
    nearest, farthest = maths.hypot(height, offset - radius), maths.hypot(height, offset + radius)
    both, away = nearest * farthest, maths.square(height) + maths.square(offset)
    more = maths.square(height) + (offset - radius) * (offset + radius)
    along = maths.piecewise(
        more > 0,
        lambda b, m, r, h: 2 * maths.square(r * h) / (b * (b + m)),
        lambda b, m, r, h: (1 - m / b) / 2,
        both,
        more,
        radius,
        height,
    )
    across = (
        2 * height * offset * maths.square(radius) / (both * (both + away + maths.square(radius)))
    )
    return math.pi * across, math.pi * along


def _tilted_disc(radius: float, height: float, offset: float, tilt: float) -> maths.Number:
    """Return the projected solid angle of one disc: above, below or cut by the horizon."""
    sine, cosine = math.sin(tilt), math.cos(tilt)
    centre = sine * offset + cosine * height  # the heights above the receiver's plane
    if centre >= abs(sine) * radius:
        across, along = _facing_disc(radius, height, offset)
        return sine * across + cosine * along
    if centre <= -abs(sine) * radius * (1 - maths.SLACK):  # a part due to rounding has no integral
        return 0.0
    return _cut_disc(radius, height, offset, sine, cosine)


def _cut_disc(radius: float, height: float, offset: float, sine: float, cosine: float) -> float:
    """Integrate the part of a disc above the receiver's horizon, in strips parallel to the horizon.

    The strip at the angle t of the rim is at x = offset + R cos t, and R sin t long to either side.
    Angles are counted from the strip nearest the observer, where the integrand of a low disc has a
    sharp peak.
    """
    horizon = -height * cosine / sine  # the x of the strip on the horizon
    cut = math.acos(max(-1.0, min(1.0, (horizon - offset) / radius)))
    nearest = math.acos(max(-1.0, -offset / radius))
    x0 = max(0.0, offset - radius)
    # The sine of the nearest strip's angle; pi - t would lose its digits.
    side = max(0.0, radius - offset) * (radius + offset)
    up, on = math.sqrt(side) / radius, max(-1.0, -offset / radius)

    def sine_of(turn: float) -> float:  # of the rim's angle nearest + turn
        return up * math.cos(turn) + on * math.sin(turn)

    def strip(turn: float) -> float:
        x = x0 - 2 * radius * sine_of(turn / 2) * math.sin(turn / 2)
        away, reach = math.hypot(x, height), radius * sine_of(turn)
        ends = reach / (away**2 + reach**2) + math.atan(reach / away) / away
        return height * sine * (x - horizon) / away**2 * ends * reach

    low, high = (0.0, cut) if sine > 0 else (cut, math.pi)
    low, high = low - nearest, high - nearest
    if low < 0 < high:
        return adaptive(strip, low, 0.0) + adaptive(strip, 0.0, high)
    return adaptive(strip, low, high)


@geometry.bounded
def projected_rectangle(
    width: maths.Number,
    length: maths.Number,
    height: maths.Number,
    offset: maths.Number = 0.0,
    offset_y: maths.Number = 0.0,
    normal: Any = UP,
) -> maths.Number:
    """Return the projected solid angle of a rectangle, for a receiver facing in any direction.

    Parameters
    ----------
    width, length, height, offset, offset_y : float or ndarray [m]
        As in `radcalc.geometry.solid.rectangle`.
    normal : tuple of 3 floats or ndarrays, optional
        The receiver's normal: components along the width, along the length and towards the
        rectangle's plane, of any length except 0.  (0, 0, 1), facing the plane, by default.

    Returns
    -------
    float or ndarray [sr]
        From 0 to pi.

    Raises
    ------
    ConditionError
        If an argument is out of range, or the normal does not have three components.

    Notes
    -----
    For a receiver below a corner that faces the plane, with X = width/h and Y = length/h::

        Omega_p = 1/2 (X / sqrt(1 + X^2) arctan(Y / sqrt(1 + X^2))
                       + Y / sqrt(1 + Y^2) arctan(X / sqrt(1 + Y^2)))

    Exact.  Computed as a polygon, by Lambert's contour formula (see `polygon`); the textbooks' sum
    over four corners cancels for distant rectangles.

    References
    ----------
    .. [1] J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3
       (parallel) and B-4 (perpendicular).

    Examples
    --------
    From the middle, a square at a height of half its side is four corners with X = Y = 1, each
    arctan(1/sqrt(2)) / sqrt(2):

    >>> round(projected_rectangle(2.0, 2.0, 1.0), 6)
    1.74084
    >>> round(4 * math.atan(1 / math.sqrt(2)) / math.sqrt(2), 6)
    1.74084
    """
    first, sides = corners(width, length, height, offset, offset_y)
    return _clipped(first, sides, normal)


def projected_pyramid(horizontal: maths.Number, vertical: maths.Number) -> maths.Number:
    """Return the projected solid angle of a right rectangular pyramid about the receiver's normal.

    Parameters
    ----------
    horizontal, vertical : float or ndarray [rad]
        Full apex angles a and b, each between two opposite *faces*, from 0 to pi.

    Returns
    -------
    float or ndarray [sr]
        From 0 to pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega_p = 2 (sin(a/2) arctan(tan(b/2) cos(a/2)) + sin(b/2) arctan(tan(a/2) cos(b/2)))

    Exact; Lambert's contour formula for the four faces, with atan2, because the tangents have poles
    at pi.

    Examples
    --------
    A pyramid of 180 by 180 degrees is the hemisphere:

    >>> round(projected_pyramid(math.pi, math.pi) / math.pi, 12)
    1.0
    """
    check_pyramid(horizontal, vertical)
    a, b = horizontal / 2, vertical / 2
    term = maths.sin(a) * maths.atan2(maths.sin(b) * maths.cos(a), maths.cos(b))
    return 2 * (term + maths.sin(b) * maths.atan2(maths.sin(a) * maths.cos(b), maths.cos(a)))


def projected_polygon(vertices: Any, normal: Any) -> maths.Number:
    """Return the projected solid angle of the part of a polygon above a receiver's horizon.

    Parameters
    ----------
    vertices : sequence of points, or ndarray of shape (..., n, 3) [m]
        At least three vertices in one plane, in order round the polygon, from the receiver and in
        any one unit of length.
    normal : tuple of 3 floats or ndarrays, or ndarray of shape (..., 3)
        The receiver's normal, of any length except 0.

    Returns
    -------
    float or ndarray of shape (...) [sr]
        From 0 to pi; not negative, whichever way the vertices go round.

    Raises
    ------
    ConditionError
        If there are fewer than three vertices, one does not have three coordinates, the normal is
        zero, or the receiver is on a side of the polygon.

    Notes
    -----
    The part below the horizon is cut off; the rest is computed by Lambert's contour formula: half
    the sum, over the sides, of the angle that a side subtends times the cosine between the
    receiver's normal and that of the plane through the side and the receiver.  Exact.  See
    `radcalc.geometry.polygons.above` and `radcalc.geometry.polygons.projected`.

    Examples
    --------
    The octant x, y, z > 0 is a quarter of the hemisphere above z = 0, pi/4 sr:

    >>> octant = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    >>> round(projected_polygon(octant, (0.0, 0.0, 1.0)) / (math.pi / 4), 12)
    1.0
    """
    from radcalc.geometry.polygons import split

    first, sides = split(vertices)
    return _clipped(first, sides, normal)


def _clipped(first: Any, sides: Any, normal: Any) -> maths.Number:
    """Return the projected solid angle of the part of a polygon above the horizon of a normal.

    In arrays, polygons wholly above the horizon are computed at once; the others one by one, since
    they keep different numbers of vertices.
    """
    from radcalc.geometry.polygons import above, projected

    n = vector(normal)
    is_none = (n[0] == 0) & (n[1] == 0) & (n[2] == 0)
    geometry.refuse(is_none, *NO_NORMAL)
    axis = unit(n)
    coordinates = [*first, *axis, *(x for side in sides for x in side)]

    def clipped(*xs: Any) -> maths.Number:
        flat: list[Any] = [xs[i : i + 3] for i in range(0, len(xs), 3)]
        kept, kept_sides = above(flat[0], flat[2:], flat[1])
        return abs(projected(kept, kept_sides, flat[1])) if kept_sides else 0.0

    def unclipped(*xs: Any) -> maths.Number:
        flat: list[Any] = [xs[i : i + 3] for i in range(0, len(xs), 3)]
        return abs(projected(flat[0], flat[2:], flat[1]))

    if not any(map(maths.is_array, coordinates)):
        return clipped(*coordinates)
    heights = [dot(axis, first) + dot(axis, side) for side in sides]
    lowest = reduce(maths.smaller, heights)
    return maths.piecewise(
        lowest >= 0, unclipped, lambda *xs: maths.each(clipped, *xs), *coordinates
    )


@bounded
def patch_and_cone(area: maths.Number, half_angle: maths.Number) -> maths.Number:
    """Return the etendue of a flat patch and a circular cone of directions about its normal.

    Parameters
    ----------
    area : float or ndarray [m^2]
        Area A of the patch.
    half_angle : float or ndarray [rad]
        Half angle alpha of the cone, from 0 to pi/2.

    Returns
    -------
    float or ndarray [m^2 sr]
        Geometric extent G.

    Raises
    ------
    ConditionError
        If an area is negative, or a half angle is outside 0 to pi/2.

    Notes
    -----
    ::

        G = pi A sin^2(alpha)

    Exact for every half angle, if the cone is the same at every point of the patch.

    References
    ----------
    .. [1] CIE e-ILV 17-21-047, geometric extent.

    Examples
    --------
    >>> round(patch_and_cone(2.0, math.radians(30)) / math.pi, 12)
    0.5
    """
    refuse(
        (half_angle < 0) | (half_angle > math.pi / 2 * (1 + maths.SLACK)),
        "the half angle is out of range: a surface has no light below its horizon",
        "a half angle from 0 to 90 deg",
    )
    refuse(area < 0, "the area is out of range", "0 or more")
    return area * projected_cone(half_angle)


@bounded
def coaxial_discs(
    radius: maths.Number, other: maths.Number, distance: maths.Number
) -> maths.Number:
    """Return the etendue of two parallel discs on one axis, at any distance.

    Parameters
    ----------
    radius, other : float or ndarray [m]
        Radii r1 and r2 of the discs.
    distance : float or ndarray [m]
        Distance d between their planes, above 0.

    Returns
    -------
    float or ndarray [m^2 sr]
        Geometric extent G, the same in both directions.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        G = (pi^2 / 2) (S - sqrt(S^2 - 4 r1^2 r2^2)),  S = r1^2 + r2^2 + d^2

    Exact.  It is computed as 2 pi^2 r1^2 r2^2 / (S + root), with root = sqrt(d^2 + (r1 - r2)^2)
    sqrt(d^2 + (r1 + r2)^2), which keeps the digits of small and of close discs.  The form factor
    from disc 1 to disc 2 is G/(pi A1).

    References
    ----------
    .. [1] J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-41.

    Examples
    --------
    The form factor from a disc of radius 0.1 m to one of 0.2 m at 0.5 m is published as 0.1339 (EES
    heat transfer library, F3D_3):

    >>> area = math.pi * 0.1**2
    >>> round(coaxial_discs(0.1, 0.2, 0.5) / (math.pi * area), 4)
    0.1339
    """
    refuse((radius < 0) | (other < 0), "the radius is out of range", "0 or more")
    refuse(distance <= 0, "the discs touch", "a distance above 0")
    scale = maths.power_of_two(maths.larger(maths.larger(radius, other), distance))
    radius, other, distance = radius / scale, other / scale, distance / scale
    root = maths.hypot(distance, radius - other) * maths.hypot(distance, radius + other)
    total = maths.square(radius) + maths.square(other) + maths.square(distance)
    return 2 * maths.square(math.pi * (radius * (other / maths.sqrt(total + root))) * scale)


@bounded
def discs_distance(
    radius: maths.Number, other: maths.Number, etendue: maths.Number
) -> maths.Number:
    """Return the distance of two parallel discs on one axis from their etendue.

    Parameters
    ----------
    radius, other : float or ndarray [m]
        Radii of the two discs, above 0.
    etendue : float or ndarray [m2 sr]
        Above 0 and below pi times the area of the smaller disc.

    Returns
    -------
    float or ndarray [m]
        Distance of their planes.

    Raises
    ------
    ConditionError
        If discs of these radii do not have such an etendue at any distance.

    Notes
    -----
    ::

        d^2 = (r1^2 - m) (r2^2 - m) / m    with m = G / pi^2

    `coaxial_discs` solved for the distance.

    Examples
    --------
    >>> round(discs_distance(1.0, 2.0, coaxial_discs(1.0, 2.0, 3.0)), 9)
    3.0
    """
    part = _part_of_discs(etendue, maths.smaller(radius, other))
    return maths.sqrt((maths.square(radius) - part) * (maths.square(other) - part) / part)


@bounded
def discs_radius(
    other: maths.Number, distance: maths.Number, etendue: maths.Number
) -> maths.Number:
    """Return the radius of one of two parallel discs on one axis from their etendue.

    Parameters
    ----------
    other : float or ndarray [m]
        Radius r2 of the other disc, above 0.
    distance : float or ndarray [m]
        Distance of their planes, above 0.
    etendue : float or ndarray [m2 sr]
        Above 0 and below pi times the area of the other disc.

    Returns
    -------
    float or ndarray [m]
        Radius of the disc.

    Raises
    ------
    ConditionError
        If no disc at that distance gives such an etendue.

    Notes
    -----
    ::

        r1^2 = m (r2^2 + d^2 - m) / (r2^2 - m)    with m = G / pi^2

    `coaxial_discs` solved for a radius.

    Examples
    --------
    >>> round(discs_radius(2.0, 3.0, coaxial_discs(1.0, 2.0, 3.0)), 9)
    1.0
    """
    refuse(distance <= 0, "the discs touch", "a distance above 0")
    part = _part_of_discs(etendue, other)
    return maths.sqrt(
        part * (maths.square(other) + maths.square(distance) - part) / (maths.square(other) - part)
    )


def _part_of_discs(etendue: maths.Number, radius: maths.Number) -> maths.Number:
    """Return G / pi^2, which must be less than the square of the smaller radius."""
    refuse(radius < 0, "the radius is out of range", "0 or more")
    part = etendue / math.pi**2
    refuse(
        (part <= 0) | (part >= maths.square(radius)),
        "the etendue is out of range for discs of these radii",
        "an etendue above 0 and below pi times the area of the smaller disc",
    )
    return part
