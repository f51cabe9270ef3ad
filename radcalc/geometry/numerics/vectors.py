"""Vector algebra on triples of coordinates, each a float or an array.

A vector is a plain tuple (x, y, z), so floats do not need NumPy.
"""

from collections.abc import Sequence
from typing import Any

from radcalc.errors import ConditionError
from radcalc.maths import Number, larger, power_of_two, sqrt

Vector = tuple[Number, Number, Number]


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
    >>> from radcalc.geometry.numerics.vectors import vector
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


def dot(a: Vector, b: Vector) -> Number:
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
    >>> from radcalc.geometry.numerics.vectors import dot
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
    >>> from radcalc.geometry.numerics.vectors import cross
    >>> cross((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    (0.0, 0.0, 1.0)
    """
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def plus(a: Vector, b: Vector, factor: Number = 1.0) -> Vector:
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
    >>> from radcalc.geometry.numerics.vectors import plus
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
    >>> from radcalc.geometry.numerics.vectors import minus
    >>> minus((1.0, 2.0, 3.0), (1.0, 1.0, 1.0))
    (0.0, 1.0, 2.0)
    """
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def times(a: Vector, factor: Number) -> Vector:
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
    >>> from radcalc.geometry.numerics.vectors import times
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
    >>> from radcalc.geometry.numerics.vectors import components
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
    >>> from radcalc.geometry.numerics.vectors import from_components
    >>> from_components(((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0)), (2.0, -1.0, 3.0))
    (1.0, 2.0, 3.0)
    """
    first, second, third = axes
    return plus(plus(times(first, parts[0]), second, parts[1]), third, parts[2])


def length(a: Vector) -> Number:
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
    >>> from radcalc.geometry.numerics.vectors import length
    >>> length((2.0, 3.0, 6.0))
    7.0
    """
    return sqrt(dot(a, a))


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
    >>> from radcalc.geometry.numerics.vectors import scaled
    >>> scaled((0.0, 3.0, -8.0))
    (0.0, 0.1875, -0.5)
    """
    largest = larger(larger(abs(a[0]), abs(a[1])), abs(a[2]))
    return times(a, 1 / power_of_two(largest))


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
    >>> from radcalc.geometry.numerics.vectors import unit
    >>> unit((0.0, 0.0, 5e300))
    (0.0, 0.0, 1.0)
    """
    near_one = scaled(a)
    size = length(near_one)
    return (near_one[0] / size, near_one[1] / size, near_one[2] / size)
