"""Vectors, and directions in space: spherical coordinates and Cartesian ones.

A vector is a plain tuple (x, y, z) of floats or arrays, so floats do not need NumPy.

As in ISO 80000-2, the polar angle theta is counted from +z, from 0 to pi, and the azimuth phi from
+x towards +y, from 0 to 2 pi.  Angles are in radians; arguments are floats or NumPy arrays,
broadcast together.

At a mirror, the normal and both directions point away from the mirror.
"""

import math
from collections.abc import Sequence
from typing import Any

from radcalc import maths
from radcalc.errors import ConditionError, option
from radcalc.geometry.cones import refuse

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
    >>> from radcalc.geometry.directions import vector
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
    >>> from radcalc.geometry.directions import dot
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
    >>> from radcalc.geometry.directions import cross
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
    >>> from radcalc.geometry.directions import plus
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
    >>> from radcalc.geometry.directions import minus
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
    >>> from radcalc.geometry.directions import times
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
    >>> from radcalc.geometry.directions import components
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
    >>> from radcalc.geometry.directions import from_components
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
    >>> from radcalc.geometry.directions import length
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
    >>> from radcalc.geometry.directions import scaled
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
    >>> from radcalc.geometry.directions import unit
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
