"""Triples of coordinates, each a float or an array."""

from typing import Any

from radcalc.errors import ConditionError
from radcalc.maths import Number, sqrt

Vector = tuple[Number, Number, Number]


def vector(point: Any) -> Vector:
    """The coordinates of a point; those of an array are on its last axis."""
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
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """The vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def plus(a: Vector, b: Vector, factor: Number = 1.0) -> Vector:
    """a + factor b."""
    return (a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2])


def minus(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def times(a: Vector, factor: Number) -> Vector:
    """A vector times a number."""
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def length(a: Vector) -> Number:
    """The length of a vector."""
    return sqrt(dot(a, a))
