"""Directions in space, and their projections onto an image of the sphere or of a part of it.

A vector is a plain tuple (x, y, z) of floats or arrays, so floats do not need NumPy.  As in
ISO 80000-2, the polar angle theta is counted from +z, from 0 to pi, and the azimuth phi from +x
towards +y, from 0 to 2 pi.  Angles are in radians; arguments are floats or NumPy arrays, broadcast
together.  At a mirror, the normal and both directions point away from the mirror.

A place in an image has the coordinates u (to the right) and v (up), both from -1 to 1 over the
whole image; pixel (0, 0) is at the top left.  A direction has the coordinates x, y, z in the map's
own axes: x is the direction of the middle of the image, z is up in the image, and y is to the left
of an observer who looks along +x.

- "latlong": azimuth -pi u and elevation v pi/2.  The top and bottom edges are the poles.
- "mirror-ball": a mirroring ball in front of a distant camera; u^2 + v^2 <= 1.  The reflection
  exchanges right and left: +y is at the right.  The middle shows the direction of the camera, the
  rim the opposite direction.
- "angular" (light probe): the distance from the middle is proportional to the angle from +x, and 1
  at 180 degrees.

The others show a part of the sphere, and the field of view of a picture limits their u and v:

- "fisheye", "equisolid", "orthographic", "stereographic" and "perspective": a direction at the
  angle t from +x has the distance t / pi, sin(t/2), sin(t), tan(t/2) or tan(t) from u = v = 0.
- "cylindrical": azimuth -pi u, and v is the tangent of the elevation.

These are the axes of OpenEXR's latitude-longitude maps [1]_ (whose z, x and y are x, y and z here),
but there the poles are at the centres of the first and last row, here at the edges.  Places and
directions are floats or NumPy arrays, broadcast together.

References
----------
.. [1] OpenEXR, ImfEnvmap.h, "Latitude-Longitude Map".
.. [2] Radiance, src/common/image.c, `setview` and `viewray`; rpict(1), options -vt, -vh, -vv, -vs
   and -vl.
"""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from radcalc import maths
from radcalc.errors import ConditionError, option
from radcalc.geometry import refuse
from radcalc.geometry.numerics import gauss
from radcalc.quantities import symbols

Vector = tuple[maths.Number, maths.Number, maths.Number]


def vector(point: Any) -> Vector:
    """Return the coordinates of a point as a tuple.

    Parameters
    ----------
    point : tuple or list of 3 floats or ndarrays, or array_like of shape (..., 3)
        A triple, or an array (or nested lists) with the coordinates on the last axis.

    Returns
    -------
    tuple of 3 floats or ndarrays of shape (...)

    Raises
    ------
    ConditionError
        If there are not three coordinates.

    Examples
    --------
    >>> from radcalc.geometry.projections import vector
    >>> vector([1.0, 2.0, 3.0])
    (1.0, 2.0, 3.0)
    >>> [x.tolist() for x in vector([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])]
    [[1.0, 4.0], [2.0, 5.0], [3.0, 6.0]]
    """
    if isinstance(point, (tuple, list)) and not any(isinstance(x, (tuple, list)) for x in point):
        coordinates = tuple(point)
    else:
        import numpy

        array = numpy.asarray(point, float)
        coordinates = tuple(array[..., i] for i in range(array.shape[-1] if array.ndim else 0))
    if len(coordinates) != 3:
        raise ConditionError("a point has three coordinates", "X,Y,Z")
    return coordinates


def dot(a: Vector, b: Vector) -> maths.Number:
    """Return the scalar product of two vectors.

    Parameters
    ----------
    a, b : tuple of 3 floats or ndarrays

    Returns
    -------
    float or ndarray
        a . b = |a| |b| cos(angle between them)

    Examples
    --------
    >>> from radcalc.geometry.projections import dot
    >>> dot((1.0, 2.0, 3.0), (4.0, 5.0, 6.0))
    32.0
    """
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Return the vector product of two vectors.

    Parameters
    ----------
    a, b : tuple of 3 floats or ndarrays

    Returns
    -------
    tuple of 3 floats or ndarrays
        a x b, perpendicular to both, right-handed; its length is the area of the parallelogram of
        a and b.

    Examples
    --------
    >>> from radcalc.geometry.projections import cross
    >>> cross((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    (0.0, 0.0, 1.0)
    """
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def plus(a: Vector, b: Vector, factor: maths.Number = 1.0) -> Vector:
    """Return the sum of a vector and a multiple of another.

    Parameters
    ----------
    a, b : tuple of 3 floats or ndarrays
    factor : float or ndarray, optional
        Factor of b.

    Returns
    -------
    tuple of 3 floats or ndarrays
        a + factor b

    Examples
    --------
    >>> from radcalc.geometry.projections import plus
    >>> plus((1.0, 0.0, 0.0), (0.0, 1.0, 2.0), 0.5)
    (1.0, 0.5, 1.0)
    """
    return (a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2])


def minus(a: Vector, b: Vector) -> Vector:
    """Return the difference of two vectors: from b to a.

    Parameters
    ----------
    a, b : tuple of 3 floats or ndarrays

    Returns
    -------
    tuple of 3 floats or ndarrays
        a - b

    Examples
    --------
    >>> from radcalc.geometry.projections import minus
    >>> minus((1.0, 2.0, 3.0), (1.0, 1.0, 1.0))
    (0.0, 1.0, 2.0)
    """
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def times(a: Vector, factor: maths.Number) -> Vector:
    """Return the product of a vector and a number.

    Parameters
    ----------
    a : tuple of 3 floats or ndarrays
    factor : float or ndarray

    Returns
    -------
    tuple of 3 floats or ndarrays
        factor a

    Examples
    --------
    >>> from radcalc.geometry.projections import times
    >>> times((1.0, 2.0, 3.0), 2.0)
    (2.0, 4.0, 6.0)
    """
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def components(axes: Sequence[Vector], a: Vector) -> Vector:
    """Return the components of a vector along three axes.

    Parameters
    ----------
    axes : sequence of 3 tuples of 3 floats
        Unit vectors at right angles.
    a : tuple of 3 floats or ndarrays

    Returns
    -------
    tuple of 3 floats or ndarrays

    Examples
    --------
    >>> from radcalc.geometry.projections import components
    >>> components(((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0)), (1.0, 2.0, 3.0))
    (2.0, -1.0, 3.0)
    """
    x, y, z = (dot(axis, a) for axis in axes)
    return x, y, z


def from_components(axes: Sequence[Vector], parts: Vector) -> Vector:
    """Return the vector with given components along three axes; the inverse of `components`.

    Parameters
    ----------
    axes : sequence of 3 tuples of 3 floats
        Unit vectors at right angles.
    parts : tuple of 3 floats or ndarrays
        The components.

    Returns
    -------
    tuple of 3 floats or ndarrays

    Examples
    --------
    >>> from radcalc.geometry.projections import from_components
    >>> from_components(((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0)), (2.0, -1.0, 3.0))
    (1.0, 2.0, 3.0)
    """
    first, second, third = axes
    return plus(plus(times(first, parts[0]), second, parts[1]), third, parts[2])


def length(a: Vector) -> maths.Number:
    """Return the length of a vector.

    Parameters
    ----------
    a : tuple of 3 floats or ndarrays

    Returns
    -------
    float or ndarray
        |a| = sqrt(a . a); the squares overflow from 1e154 on and vanish below 1e-162, so polygons
        are scaled first (`radcalc.geometry.polygons.scaled`).

    Examples
    --------
    >>> from radcalc.geometry.projections import length
    >>> length((2.0, 3.0, 6.0))
    7.0
    """
    return maths.sqrt(dot(a, a))


def scaled(a: Vector) -> Vector:
    """Return a multiple of a vector whose squares are not too large or too small for a float.

    Parameters
    ----------
    a : tuple of 3 floats or ndarrays
        Of any size.

    Returns
    -------
    tuple of 3 floats or ndarrays
        a times a power of two, which is exact: the largest coordinate is at least 1/2 and below 1,
        unless all are 0.

    Examples
    --------
    >>> from radcalc.geometry.projections import scaled
    >>> scaled((0.0, 3.0, -8.0))
    (0.0, 0.1875, -0.5)
    """
    largest = maths.larger(maths.larger(abs(a[0]), abs(a[1])), abs(a[2]))
    return times(a, 1 / maths.power_of_two(largest))


def unit(a: Vector) -> Vector:
    """Return the vector of length 1 in the direction of another.

    Parameters
    ----------
    a : tuple of 3 floats or ndarrays
        Of any size, not all 0.

    Returns
    -------
    tuple of 3 floats or ndarrays
        a / |a|

    Examples
    --------
    >>> from radcalc.geometry.projections import unit
    >>> unit((0.0, 0.0, 5e300))
    (0.0, 0.0, 1.0)
    """
    near_one = scaled(a)
    size = length(near_one)
    return (near_one[0] / size, near_one[1] / size, near_one[2] / size)


TURN = 2 * math.pi  # [rad]
UP: Vector = (0.0, 0.0, 1.0)
FORWARD: Vector = (1.0, 0.0, 0.0)  # default direction of the middle of an image
NO_DIRECTION = "0,0,0 has no direction", "a vector that is not zero"
NO_NORMAL = "a normal of length 0 has no direction", option("normal", "0,0,1")
OPPOSITE = (
    "opposite directions have no single mirror: any parallel to them will do",
    "another direction",
)


def spherical(
    x: maths.Number, y: maths.Number, z: maths.Number
) -> tuple[maths.Number, maths.Number, maths.Number]:
    """Return the spherical coordinates of a vector: polar angle, azimuth and length.

    Parameters
    ----------
    x, y, z : float or ndarray
        Cartesian components, in any one unit; not all 0.

    Returns
    -------
    polar : float or ndarray [rad]
        Angle theta from +z, from 0 to pi.
    azimuth : float or ndarray [rad]
        Angle phi from +x towards +y, from 0 to below 2 pi; 0 on the z axis.
    length : float or ndarray
        Length r of the vector, in the unit of its components.

    Raises
    ------
    ConditionError
        If the length of a vector is 0.

    Notes
    -----
    ::

        theta = arccos(z / r),  phi = atan2(y, x),  r = sqrt(x^2 + y^2 + z^2)

    The polar angle is computed as atan2(sqrt(x^2 + y^2), z), because the arccosine loses half of
    the digits close to the z axis; the lengths by hypot, which does not overflow.

    References
    ----------
    .. [1] ISO 80000-2, spherical coordinates.

    Examples
    --------
    >>> polar, azimuth, length = spherical(1.0, 1.0, math.sqrt(2))
    >>> round(math.degrees(polar), 10), round(math.degrees(azimuth), 10), round(length, 10)
    (45.0, 45.0, 2.0)
    """
    across = maths.hypot(x, y)
    size = maths.hypot(across, z)
    refuse(size == 0, *NO_DIRECTION)
    azimuth = maths.atan2(y, x)
    azimuth = maths.piecewise(azimuth < 0, lambda a: a + TURN, lambda a: a + 0.0, azimuth)
    # a tiny negative azimuth plus a turn is rounded to a whole turn
    azimuth = maths.piecewise(
        (azimuth >= TURN) | (across == 0), lambda a: 0.0 * a, lambda a: a, azimuth
    )
    return maths.atan2(across, z), azimuth, size


def cartesian(
    polar: maths.Number, azimuth: maths.Number
) -> tuple[maths.Number, maths.Number, maths.Number]:
    """Return the unit vector of a direction with a given polar angle and azimuth.

    Parameters
    ----------
    polar : float or ndarray [rad]
        Angle theta from +z, from 0 to pi.
    azimuth : float or ndarray [rad]
        Angle phi from +x towards +y; any number of turns.

    Returns
    -------
    x, y, z : float or ndarray [1]
        Components of a vector of length 1.

    Raises
    ------
    ConditionError
        If a polar angle is out of range (by more than a relative 1e-12), or an azimuth is infinite.

    Notes
    -----
    ::

        x = sin(theta) cos(phi),  y = sin(theta) sin(phi),  z = cos(theta)

    References
    ----------
    .. [1] ISO 80000-2, spherical coordinates.

    Examples
    --------
    >>> [round(x, 6) for x in cartesian(math.radians(60), math.radians(90))]
    [0.0, 0.866025, 0.5]
    """
    if maths.any_true((polar < 0) | (polar > math.pi * (1 + maths.SLACK))):
        raise ConditionError(
            "the polar angle is out of range: it must be from 0 to 180 deg",
            "an elevation is from -90 to 90 deg",
        )
    if maths.any_true(abs(azimuth) == math.inf):
        raise ConditionError("the azimuth is infinite", "any number of turns")
    across = maths.sin(polar)
    return across * maths.cos(azimuth), across * maths.sin(azimuth), maths.cos(polar)


def upright(direction: Vector, up: Vector) -> tuple[Vector, Vector, Vector]:
    """Return the axes of an observer who faces in a direction, with another vector as up.

    Parameters
    ----------
    direction, up : tuple of 3 floats
        Vectors of any length except 0, and not parallel.

    Returns
    -------
    forward, left, up : tuple of 3 floats [1]
        Unit vectors at right angles, as from `facing`; `up` is as close as possible to the given.

    Raises
    ------
    ConditionError
        If the vectors are parallel.

    Examples
    --------
    >>> upright((0.0, 0.0, 1.0), (0.0, 2.0, 0.0))
    ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    """
    refuse(length(direction) * length(up) == 0, *NO_DIRECTION)
    forward, above = unit(direction), unit(up)
    left = cross(above, forward)
    parallel = f"the direction up is parallel to {','.join(f'{x:g}' for x in direction)}"
    refuse(length(left) < 1e-9, parallel, "another direction up")
    left = unit(left)
    return forward, left, cross(forward, left)


def facing(direction: Vector) -> tuple[Vector, Vector, Vector]:
    """Return the axes of an upright observer (or map) that faces in a direction.

    Parameters
    ----------
    direction : tuple of 3 floats
        Direction of view, a vector of any length except 0.

    Returns
    -------
    forward, left, up : tuple of 3 floats [1]
        Unit vectors at right angles: the direction, the horizontal vector to its left, and the
        vector closest to +z.  For a direction straight up or down, left is +y.

    Raises
    ------
    ConditionError
        If the length of the vector is 0.

    Examples
    --------
    >>> facing((2.0, 0.0, 0.0))
    ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    """
    x, y, z = direction
    _, azimuth, size = spherical(x, y, z)
    across, level = maths.hypot(x, y) / size, z / size
    c, s = maths.cos(azimuth), maths.sin(azimuth)
    forward = (x / size, y / size, level)
    return forward, (0.0 - s, c, 0.0), (0.0 - c * level, 0.0 - s * level, across)


def reflected(direction: Vector, normal: Vector) -> Vector:
    """Return the reflection of a direction at a mirror.

    Parameters
    ----------
    direction : tuple of 3 floats or ndarrays
        A vector d of any length, away from the mirror.
    normal : tuple of 3 floats or ndarrays
        The mirror's normal n, of any length except 0.

    Returns
    -------
    tuple of 3 floats or ndarrays
        The vector r, as long as d, also away from the mirror and on the same side of it as d.

    Raises
    ------
    ConditionError
        If the length of a normal is 0.

    Notes
    -----
    ::

        r = 2 (n . d) / (n . n) n - d

    Renderers often let d point towards the mirror; their d - 2 (n . d) n is the same reflection.

    Examples
    --------
    >>> reflected((0.0, 0.0, 1.0), (1.0, 0.0, 1.0))
    (1.0, 0.0, 0.0)
    """
    n = scaled(normal)
    square = dot(n, n)
    refuse(square == 0, *NO_DIRECTION)
    return minus(times(n, 2 * dot(n, direction) / square), direction)


def mirror_normal(direction: Vector, reflection: Vector) -> Vector:
    """Return the normal of the mirror that reflects one direction into another.

    Parameters
    ----------
    direction, reflection : tuple of 3 floats or ndarrays
        Vectors d and r of any length except 0, away from the mirror.

    Returns
    -------
    tuple of 3 floats or ndarrays
        The normal, of length 1: the bisector of the two directions.

    Raises
    ------
    ConditionError
        If the length of a vector is 0, or the two are opposite to a relative 1e-12: then every
        mirror parallel to them reflects one into the other.

    Notes
    -----
    ::

        n = (d / |d| + r / |r|) / |d / |d| + r / |r||

    Examples
    --------
    >>> [round(x, 6) for x in mirror_normal((0.0, 0.0, 1.0), (1.0, 0.0, 0.0))]
    [0.707107, 0.0, 0.707107]
    """
    d, r = scaled(direction), scaled(reflection)
    both, sizes = plus(times(d, length(r)), r, length(d)), length(d) * length(r)
    refuse(sizes == 0, *NO_DIRECTION)
    refuse(length(both) <= maths.SLACK * sizes, *OPPOSITE)
    return unit(both)


# Projections whose places are in a circle of the radius 1.
ROUND = (
    symbols.MIRROR_BALL,
    symbols.ANGULAR,
    symbols.FISHEYE,
    symbols.EQUISOLID,
    symbols.ORTHOGRAPHIC,
)
FAR = 1e99  # distance from the middle of a direction that a projection cannot show
FEW, MANY = 4, 16  # points of a rule each way, over a small and a large pixel
INSIDE = 1 - 1e-9  # of half a side: the rest is rounding
USUAL_SIZE = (1024, 512)  # default size of a new latlong map [pixels]
SMALL = 1 / 64  # of the image: with 4 points the error of such a pixel is 1e-16


def is_outside(projection: str, u: maths.Number, v: maths.Number) -> Any:
    """Return whether a place is outside an image, or outside the circle in it.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}
    u, v : float or ndarray [1]
        The place.

    Returns
    -------
    bool or ndarray of bool
        A limit may be exceeded by a relative 1e-12; NaN is not outside.

    Raises
    ------
    ConditionError
        If the projection is unknown.

    Examples
    --------
    >>> is_outside("latlong", 0.9, 0.9), is_outside("angular", 0.9, 0.9)
    (False, True)
    """
    if _is_latlong(projection):
        return (abs(u) > 1 + maths.SLACK) | (abs(v) > 1 + maths.SLACK)
    if projection in ROUND:
        return maths.hypot(u, v) > 1 + maths.SLACK
    return (abs(u) > 1 + maths.SLACK) & (projection == symbols.CYLINDRICAL)


def _is_latlong(projection: str, known: tuple[str, ...] = symbols.PROJECTIONS) -> bool:
    """Return whether a projection is latlong, which has no circle; refuse an unknown one."""
    refuse(projection not in known, f"unknown projection '{projection}'", ", ".join(known))
    return projection == symbols.LATLONG


def name_of_map(projection: str) -> str:
    """Return the name of a map for texts, with its article.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}

    Returns
    -------
    str

    Examples
    --------
    >>> name_of_map("angular")
    'an angular map'
    """
    noun = "map" if projection in symbols.WHOLE_SPHERE else "picture"
    return f"{'an' if projection[0] in 'aeo' else 'a'} {projection} {noun}"


def has_shape(projection: str, width: int, height: int) -> bool:
    """Return whether an image of a size can be a whole map in a projection.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}
    width, height : int
        Size of the image [pixels].

    Returns
    -------
    bool
        A latlong map is twice as wide as high, a mirror ball and an angular map are square; a
        picture of a part of the sphere has any shape.

    Examples
    --------
    >>> has_shape("latlong", 64, 32), has_shape("angular", 64, 32)
    (True, False)
    """
    if projection not in symbols.WHOLE_SPHERE:
        return True
    return width == (2 * height if projection == symbols.LATLONG else height)


def direction_at(projection: str, u: maths.Number, v: maths.Number) -> Vector:
    """Return the direction that an image shows at a place.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}
    u, v : float or ndarray [1]
        The place.

    Returns
    -------
    x, y, z : float or ndarray [1]
        A vector of length 1.  In arrays, places outside (`is_outside`) have NaN in all three.

    Raises
    ------
    ConditionError
        If the projection is unknown, or a place given by floats is outside.

    Notes
    -----
    ::

        latlong      (cos(e) cos(a), cos(e) sin(a), sin(e)),  a = -pi u,  e = v pi/2
        cylindrical  the same, e = atan(v)
        mirror-ball  (2 n^2 - 1, 2 n u, 2 n v),  n = sqrt(1 - u^2 - v^2)
        the others   (cos(t), -sin(t) u / r, sin(t) v / r),  r = sqrt(u^2 + v^2)

    (n, u, v) is the normal of the mirror ball, at which the camera's direction, +x, is reflected;
    t is the angle of which r is the distance.

    Examples
    --------
    A quarter of the width to the left of the middle, a latlong map shows +y:

    >>> [round(x, 12) for x in direction_at("latlong", -0.5, 0.0)]
    [0.0, 1.0, 0.0]
    """
    outside = is_outside(projection, u, v)
    if maths.any_true(outside):
        if not (maths.is_array(u) or maths.is_array(v)):
            limit = (
                "u and v from -1 to 1"
                if projection == symbols.LATLONG
                else "u^2 + v^2 of at most 1"
            )
            raise ConditionError("the place is outside the image", limit)
        u, v = (
            maths.piecewise(outside, lambda a: a * math.nan, lambda a: a, coordinate)
            for coordinate in (u, v)
        )
    if projection in (symbols.LATLONG, symbols.CYLINDRICAL):
        azimuth = -math.pi * u
        elevation = math.pi / 2 * v if projection == symbols.LATLONG else maths.atan2(v, 1.0)
        across = maths.cos(elevation)
        return across * maths.cos(azimuth), across * maths.sin(azimuth), maths.sin(elevation)
    r = maths.hypot(u, v)
    if projection == symbols.MIRROR_BALL:
        normal = maths.sqrt(maths.larger(0.0, (1 - r) * (1 + r)))
        return 2 * maths.square(normal) - 1, 2 * normal * u, 2 * normal * v
    forward, share = _cosine_and_share(projection, r)
    return forward, -share * u, share * v


def _cosine_and_share(projection: str, r: maths.Number) -> tuple[maths.Number, maths.Number]:
    """Return the cosine of the angle of a distance from the middle, and its sine over r."""
    if projection == symbols.PERSPECTIVE:
        cosine = 1 / maths.hypot(1.0, r)
        return cosine, cosine
    if projection == symbols.STEREOGRAPHIC:
        share = 2 / (1 + maths.square(r))
        return share - 1, share
    if projection in (symbols.ANGULAR, symbols.FISHEYE):
        share = maths.piecewise(
            r == 0, lambda a: a + math.pi, lambda a: maths.sin(math.pi * a) / a, r
        )
        return maths.cos(math.pi * r), share
    normal = maths.sqrt(maths.larger(0.0, (1 - r) * (1 + r)))
    if projection == symbols.ORTHOGRAPHIC:
        return normal, 1.0 + 0.0 * r
    return 2 * maths.square(normal) - 1, 2 * normal


def density(projection: str, u: maths.Number, v: maths.Number) -> maths.Number:
    """Return the solid angle per area of an image, d omega / (du dv), within its limits.

    Parameters
    ----------
    projection : str
        One of `PROJECTIONS`.
    u, v : float or ndarray [1]
        The place.

    Returns
    -------
    float or ndarray [sr]

    Examples
    --------
    >>> density("equisolid", 0.3, 0.4), round(density("perspective", 0.0, 1.0), 6)
    (4.0, 0.353553)
    """
    if projection == symbols.LATLONG:
        return math.pi**2 / 2 * maths.cos(math.pi / 2 * v)
    if projection == symbols.CYLINDRICAL:
        return math.pi / maths.power(maths.hypot(1.0, v), 3)
    r = maths.hypot(u, v)
    if projection in (symbols.MIRROR_BALL, symbols.EQUISOLID):
        return 4.0 + 0.0 * r
    cosine, share = _cosine_and_share(projection, r)
    if projection in (symbols.ANGULAR, symbols.FISHEYE):
        return math.pi * share
    if projection == symbols.ORTHOGRAPHIC:
        return 1 / maths.larger(cosine, 1e-9)
    return maths.power(share, 2 if projection == symbols.STEREOGRAPHIC else 3)


def place_of(
    projection: str, x: maths.Number, y: maths.Number, z: maths.Number
) -> tuple[maths.Number, maths.Number]:
    """Return the place at which an image shows a direction; the inverse of `direction_at`.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}
    x, y, z : float or ndarray
        A vector of any length, not all 0, in the map's own axes.

    Returns
    -------
    u, v : float or ndarray [1]
        If there are many places, one of them: for -x the place (-1, 0) on the left edge of a
        latlong map, and (1, 0) on the rim of the others; for a pole the middle of the edge, u = 0.

    Raises
    ------
    ConditionError
        If the projection is unknown, or the length of a vector is 0.

    Notes
    -----
    ::

        latlong      u = -atan2(y, x) / pi,  v = atan2(z, sqrt(x^2 + y^2)) 2 / pi
        cylindrical  u = -atan2(y, x) / pi,  v = z / sqrt(x^2 + y^2)
        the others   (u, v) = r (+-y, z) / sqrt(y^2 + z^2),  + for a mirror ball
        mirror-ball  r = sin(theta/2),  theta = atan2(sqrt(y^2 + z^2), x)
        angular      r = theta / pi

    The arctangents keep their digits in all directions; on a mirror ball the place is as exact as
    the direction, also at the rim.

    Examples
    --------
    >>> place_of("latlong", 0.0, 1.0, 0.0), place_of("latlong", 0.0, 0.0, 2.0)
    ((-0.5, 0.0), (0.0, 1.0))
    """
    zero = (x == 0) & (y == 0) & (z == 0)
    refuse(zero, *NO_DIRECTION)
    if _is_latlong(projection) or projection == symbols.CYLINDRICAL:
        azimuth = maths.atan2(y + 0.0, x + 0.0)  # + 0.0 because -0.0 would give the other edge
        elevation = maths.atan2(z, maths.hypot(x, y))
        v = elevation * (2 / math.pi) if projection == symbols.LATLONG else maths.tan(elevation)
        return 0.0 - azimuth / math.pi, v
    across = maths.hypot(y, z)
    r = radius_of(projection, maths.atan2(across, x))
    sign = 1.0 if projection == symbols.MIRROR_BALL else -1.0
    on_axis = across == 0
    u = maths.piecewise(
        on_axis, lambda r, a, b: r, lambda r, a, b: sign * r * (a / b), r, y, across
    )
    v = maths.piecewise(on_axis, lambda r, a, b: 0 * r, lambda r, a, b: r * (a / b), r, z, across)
    return u, v


def radius_of(projection: str, angle: maths.Number) -> maths.Number:
    """Return the distance from the middle, in u and v, of directions at an angle from it.

    Parameters
    ----------
    projection : str
        One of `PROJECTIONS`, but not "latlong" or "cylindrical".
    angle : float or ndarray [rad]
        From 0 to pi.

    Returns
    -------
    float or ndarray [1]
        Very large for an angle that the projection cannot show.

    Examples
    --------
    >>> round(radius_of("orthographic", math.pi / 6), 12), radius_of("fisheye", math.pi / 4)
    (0.5, 0.25)
    """
    if projection in (symbols.ANGULAR, symbols.FISHEYE):
        return angle / math.pi
    if projection in (symbols.MIRROR_BALL, symbols.EQUISOLID):
        return maths.sin(angle / 2)
    if projection == symbols.STEREOGRAPHIC:
        return maths.smaller(maths.tan(angle / 2), FAR)
    function = maths.sin if projection == symbols.ORTHOGRAPHIC else maths.tan
    limit = math.pi / 2 * (1 + maths.SLACK) if projection == symbols.ORTHOGRAPHIC else math.pi / 2
    return maths.piecewise(angle < limit, function, lambda a: FAR + 0 * a, angle)


def middle_of_pixel(width: int, height: int, column: Any, row: Any) -> tuple[Any, Any]:
    """Return the place of the middle of a pixel.

    Parameters
    ----------
    width, height : int
        Size of the image [pixels].
    column, row : int or ndarray of int
        Counted from 0 at the top left.

    Returns
    -------
    u, v : float or ndarray [1]

    Examples
    --------
    >>> middle_of_pixel(4, 2, 0, 0), middle_of_pixel(5, 5, 2, 2)
    ((-0.75, 0.5), (0.0, 0.0))
    """
    return (2 * column + 1 - width) / width, (height - 1 - 2 * row) / height


def corner_of_pixel(width: int, height: int, column: Any, row: Any) -> tuple[Any, Any]:
    """Return the place of the upper left corner of a pixel.

    Parameters
    ----------
    width, height : int
        Size of the image [pixels].
    column, row : int or ndarray of int
        Counted from 0 at the top left; width and height give the right and the lower edge.

    Returns
    -------
    u, v : float or ndarray [1]

    Examples
    --------
    >>> corner_of_pixel(4, 2, 0, 0), corner_of_pixel(4, 2, 4, 1)
    ((-1.0, 1.0), (1.0, 0.0))
    """
    return 2 * column / width - 1, 1 - 2 * row / height


def pixel_solid_angle(projection: str, width: int, height: int, column: int, row: int) -> float:
    """Return the solid angle that one pixel of an image shows.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}
    width, height : int
        Size of the image [pixels], 1 or more.
    column, row : int
        Counted from 0 at the top left, below the width and the height.

    Returns
    -------
    float [sr]
        0 for a pixel outside the circle of a mirror ball or an angular map; that of the part inside
        for a pixel that the circle cuts.

    Raises
    ------
    ConditionError
        If the projection is unknown.

    Notes
    -----
    ::

        latlong      2 (2 pi / width) sin(t) sin(pi / (2 height)),  t = pi (row + 1/2) / height
        mirror-ball  d omega = 4 du dv
        angular      d omega = pi sin(pi r) / r du dv

    The product for a latlong map keeps the digits of the difference of two cosines.  Over a pixel
    of the others the density is integrated by Gauss-Legendre rules, exact to rounding; if the
    circle cuts the pixel, over the part whose whole width is inside, and over the rest with the
    angle along the arc as the variable.

    Examples
    --------
    A pixel at the equator of 1024 x 512 pixels:

    >>> f"{pixel_solid_angle('latlong', 1024, 512, 0, 255):.6e}"
    '3.764932e-05'
    """
    if _is_latlong(projection, symbols.WHOLE_SPHERE):
        return float(_latlong(width, height, row))
    ball = projection == symbols.MIRROR_BALL
    return float(_in_quadrant(ball, *_span(column, width), *_span(row, height)))


def pixel_solid_angles(projection: str, width: int, height: int, rows: slice = slice(None)) -> Any:
    """Return the solid angles that the pixels of an image show: `pixel_solid_angle` of all.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}
    width, height : int
        Size of the image [pixels], 1 or more.
    rows : slice, optional
        The rows to compute; all by default.

    Returns
    -------
    ndarray [sr]
        Of shape (rows, 1) for a latlong map, where all pixels of a row are equal, and of shape
        (rows, width) for the others.  The sum over all pixels is 4 pi.

    Raises
    ------
    ConditionError
        If the projection is unknown.

    Examples
    --------
    >>> round(float(pixel_solid_angles("angular", 63, 63).sum()) / (4 * math.pi), 12)
    1.0
    """
    import numpy

    row = numpy.arange(height)[rows]
    if _is_latlong(projection, symbols.WHOLE_SPHERE):
        return _latlong(width, height, row[:, None])
    # Left and right, top and bottom are mirror images, so the lower right quadrant is enough.
    below, down = numpy.unique(abs(2 * row + 1 - height) // 2, return_inverse=True)
    high = (bound[:, None] for bound in _span(height // 2 + below, height))
    across = _span(numpy.arange(width // 2, width), width)
    quadrant = _in_quadrant(projection == symbols.MIRROR_BALL, *across, *high)
    return quadrant[numpy.ix_(down, abs(2 * numpy.arange(width) + 1 - width) // 2)]


def solid_angles_in_circle(projection: str, u: Any, wide: Any, v: Any, high: Any) -> Any:
    """Return the solid angles of the parts of rectangles inside the circle of an image.

    Parameters
    ----------
    projection : {"mirror-ball", "angular"}
    u, v : ndarray [1]
        Middles of the rectangles.
    wide, high : ndarray [1]
        Halves of their sides.  An axis (u = 0 or v = 0) may be outside a rectangle or along its
        middle.

    Returns
    -------
    ndarray [sr]

    Examples
    --------
    A quarter of the square around the circle:

    >>> import numpy
    >>> half = numpy.array([0.5])
    >>> round(float(solid_angles_in_circle("angular", half, half, -half, half)[0]), 12)
    3.14159265359
    """

    def side(middle: Any, half: Any) -> tuple[Any, Any, Any]:
        within = abs(middle) < half * INSIDE  # the axis is in the middle: two halves
        parts = 1.0 + within
        return (
            maths.piecewise(within, lambda _, h: h / 2, lambda m, _: abs(m), middle, half),
            (half / parts),
            parts,
        )

    return _in_quadrant(projection == symbols.MIRROR_BALL, *side(u, wide), *side(v, high))


def _latlong(width: int, height: int, row: Any) -> Any:
    """Return the solid angle of a pixel of a latlong map, by its row."""
    row = maths.smaller(row, height - 1 - row)  # the sine of an angle close to pi would lose digits
    middle = math.pi * (row + 0.5) / height
    return 4 * math.pi / width * maths.sin(middle) * maths.sin(math.pi / (2 * height))


def _span(pixel: Any, count: int) -> tuple[Any, Any, Any]:
    """Return middle and half width of a pixel mirrored to the positive side, and its parts.

    The middle pixel of an odd number counts as two halves, any other as one whole.
    """
    middle = abs(2 * pixel + 1 - count)
    half = maths.piecewise(middle == 0, lambda m: 0.5 + m, lambda m: 1.0 + 0 * m, middle)
    return maths.larger(middle, 0.5) / count, half / count, 1 / half


def _in_quadrant(
    ball: bool,
    x: maths.Number,
    wide: maths.Number,
    halves: maths.Number,
    y: maths.Number,
    high: maths.Number,
    parts: maths.Number,
) -> maths.Number:
    """Return the solid angle of a pixel of positive u and v, times the number of its parts."""

    def uncut(
        x: maths.Number, wide: maths.Number, y: maths.Number, high: maths.Number
    ) -> maths.Number:
        return _rectangle(ball, x, wide, y, high)

    def cut(
        x: maths.Number, wide: maths.Number, y: maths.Number, high: maths.Number
    ) -> maths.Number:
        return _cut(ball, x, wide, y, high)

    def inside(
        x: maths.Number, wide: maths.Number, y: maths.Number, high: maths.Number
    ) -> maths.Number:
        is_whole = maths.hypot(x + wide, y + high) <= 1
        return maths.piecewise(is_whole, uncut, cut, x, wide, y, high)

    is_out = maths.hypot(x - wide, y - high) >= 1
    return halves * parts * maths.piecewise(is_out, lambda *xs: 0 * xs[0], inside, x, wide, y, high)


def _rectangle(
    ball: bool, x: maths.Number, wide: maths.Number, y: maths.Number, high: maths.Number
) -> maths.Number:
    """Return the solid angle of a rectangle within the circle, by its middle and half its sides."""
    rule = zip(*gauss(_points(wide, high)), strict=True)
    return high * sum(weight * _line(ball, x, wide, y + b * high) for b, weight in rule)


def _points(wide: maths.Number, high: maths.Number) -> int:
    return MANY if maths.any_true(maths.larger(wide, high) > SMALL) else FEW


def _cut(
    ball: bool, x: maths.Number, wide: maths.Number, y: maths.Number, high: maths.Number
) -> maths.Number:
    """Return the solid angle of the part of a rectangle inside the circle."""
    left, right, low, top = x - wide, x + wide, y - high, y + high
    # up to `full` the circle is right of the rectangle; beyond `end` it is left of it
    full = maths.smaller(
        top, maths.larger(low, maths.sqrt(maths.larger(0.0, (1 - right) * (1 + right))))
    )
    end = maths.larger(full, maths.smaller(top, maths.sqrt((1 - left) * (1 + left))))
    total = _rectangle(ball, x, wide, (full + low) / 2, (full - low) / 2)
    first, last = maths.asin(full), maths.asin(end)
    points = gauss(_points(wide, high))
    for a, weight in zip(*points, strict=True):
        angle = (first + last) / 2 + a * (last - first) / 2
        strip = weight * maths.cos(angle) * (last - first) / 2  # height of the strip
        half = (maths.cos(angle) - left) / 2
        total = total + strip * _line(ball, left + half, half, maths.sin(angle))
    return total


def _line(ball: bool, x: maths.Number, half: maths.Number, y: maths.Number) -> maths.Number:
    """Return the integral of the density along u, by the middle and half the length."""
    if ball:
        return 8 * half
    nodes: Any
    weights: Any
    nodes, weights = gauss(_points(half, half))
    if maths.is_array(half):  # all points at once, as arrays are short
        import numpy

        nodes, weights = (numpy.reshape(rule, (-1, *[1] * half.ndim)) for rule in (nodes, weights))
        r = maths.hypot(x + nodes * half, y)
        terms = weights * (maths.sin(math.pi * r) / r)
    else:
        radii = [maths.hypot(x + a * half, y) for a in nodes]
        terms = [
            weight * (maths.sin(math.pi * r) / r) for r, weight in zip(radii, weights, strict=True)
        ]
    return math.pi * half * sum(terms, 0.0)


# Largest fields [rad]; those in OPEN must be smaller, as their edges would be infinitely far away.
WIDEST = {
    symbols.FISHEYE: 2 * math.pi,
    symbols.EQUISOLID: 2 * math.pi,
    symbols.ORTHOGRAPHIC: math.pi,
    symbols.STEREOGRAPHIC: 2 * math.pi,
    symbols.PERSPECTIVE: math.pi,
    symbols.CYLINDRICAL: 2 * math.pi,
}
OPEN = (symbols.STEREOGRAPHIC, symbols.PERSPECTIVE)
NEAREST = 1e-6  # [rad] to that limit


class View(NamedTuple):
    """The rectangle that an image shows, in u and v of its projection; by default -1 to 1.

    Attributes
    ----------
    right, top : float [1]
        Distances of the edges of the image from its middle.
    aside, above : float [1]
        Place of its middle.
    circle : float [1]
        Pixels farther than this from u = v = 0 show nothing.

    Examples
    --------
    The left half of a picture:

    >>> View(right=0.5, aside=-0.5).places(1.0, 1.0)
    (0.0, 1.0)
    """

    right: float = 1.0
    top: float = 1.0
    aside: float = 0.0
    above: float = 0.0
    circle: float = math.inf

    def places(self, u: Any, v: Any) -> tuple[Any, Any]:
        """Return u and v of the projection at places of the image.

        Parameters
        ----------
        u, v : float or ndarray [1]
            Places from -1 to 1.

        Returns
        -------
        tuple of float or ndarray [1]

        Examples
        --------
        >>> View(right=0.5, top=0.25).places(1.0, -1.0)
        (0.5, -0.25)
        """
        return u * self.right + self.aside, v * self.top + self.above

    def in_image(self, u: Any, v: Any) -> tuple[Any, Any]:
        """Return the places of the image; the inverse of `places`.

        Parameters
        ----------
        u, v : float or ndarray [1]
            Coordinates of the projection.

        Returns
        -------
        tuple of float or ndarray [1]
            From -1 to 1 in the image.

        Examples
        --------
        >>> View(right=0.5, top=0.25).in_image(0.5, -0.25)
        (1.0, -1.0)
        """
        return (u - self.aside) / self.right, (v - self.above) / self.top


def field_text(field: float) -> str:
    """Return a field of view for texts.

    Parameters
    ----------
    field : float [rad]

    Returns
    -------
    str

    Examples
    --------
    >>> field_text(math.pi)
    '180 deg'
    """
    return f"{math.degrees(field):.6g} deg"


def reach(projection: str, field: float, is_upright: bool = False) -> float:
    """Return the distance of the edge of a picture from its middle, in u or v.

    Parameters
    ----------
    projection : str
        One of those with a field of view.
    field : float [rad]
        Full angle from edge to edge.
    is_upright : bool, optional
        Whether it is measured from the bottom to the top.

    Returns
    -------
    float [1]

    Raises
    ------
    ConditionError
        If the projection cannot show that field.

    Examples
    --------
    >>> round(reach("orthographic", math.pi), 12), round(reach("perspective", math.pi / 2), 12)
    (1.0, 1.0)
    """
    flat = projection == symbols.CYLINDRICAL and is_upright
    if flat:
        projection = symbols.PERSPECTIVE
    widest = WIDEST[projection]
    limit = widest - NEAREST if projection in OPEN else widest * (1 + 1e-9)
    refuse(
        (field <= 0) | (field > limit),
        f"a {'cylindrical' if flat else projection} picture cannot show {field_text(field)}",
        f"more than 0, and {'less than' if projection in OPEN else 'at most'} {field_text(widest)}",
    )
    half = min(field, widest) / 2
    return (
        half / math.pi if projection == symbols.CYLINDRICAL else float(radius_of(projection, half))
    )


def view_of_field(projection: str, field: float, width: int, height: int) -> View:
    """Return the view of a whole picture with square pixels.

    Parameters
    ----------
    projection : str
        One of those with a field of view.
    field : float [rad]
        Full angle across the circle in the middle of a square fisheye picture, or across the width
        of the others.
    width, height : int
        Size of the picture in pixels.

    Returns
    -------
    View

    Raises
    ------
    ConditionError
        If the projection cannot show that field, or a fisheye picture is not square.

    Examples
    --------
    >>> view = view_of_field("perspective", math.pi / 2, 400, 200)
    >>> round(view.right, 12), round(view.top, 12)
    (1.0, 0.5)
    """
    right = reach(projection, field)
    if projection in symbols.CIRCLES:
        refuse(
            width != height,
            f"{width} x {height} pixels are not square around the circle of {field_text(field)}",
            "the square around its circle",
        )
        is_whole = projection in ROUND and right > 1 - 1e-9  # all that the projection can show
        return View(right, right, circle=math.inf if is_whole else right)
    is_flat = projection == symbols.PERSPECTIVE
    return View(right, (1 if is_flat else math.pi) * right * height / width)


def view_of_angles(
    projection: str, across: float, upright: float, shift: float = 0.0, lift: float = 0.0
) -> View:
    """Return the view that Radiance defines by its options -vh, -vv, -vs and -vl [1]_.

    Parameters
    ----------
    projection : str
        One of those with a field of view.
    across, upright : float [rad]
        Full angles from edge to edge, -vh and -vv.
    shift, lift : float, optional [1]
        Shifts of the middle, -vs and -vl, in widths and heights of the picture.

    Returns
    -------
    View

    Raises
    ------
    ConditionError
        If the projection cannot show these angles.

    Examples
    --------
    >>> view = view_of_angles("perspective", math.pi / 2, math.pi / 2, shift=0.5)
    >>> round(view.right, 12), round(view.aside, 12)
    (1.0, 1.0)
    """
    right, top = reach(projection, across), reach(projection, upright, True)
    return View(right, top, 2 * shift * right, 2 * lift * top)
