"""Solid angles of triangles and polygons, and what of them lies above a horizon.

A point is a triple of coordinates: a tuple of floats, of arrays, or the last axis of an array.
The vertices are taken from the observer; inside, a polygon is its first vertex and all
vertices *from that one*, whose differences keep their digits however far the polygon is.
"""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from radcalc.errors import ConditionError
from radcalc.geometry.quadrature import adaptive
from radcalc.geometry.special import arc_excess
from radcalc.maths import Number, any_true, atan2, each, is_array, piecewise, sqrt

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


def times(a: Vector, factor: Number) -> Vector:
    """A vector times a number."""
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def minus(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def length(a: Vector) -> Number:
    """The length of a vector."""
    return sqrt(dot(a, a))


def triangle(a: Any, b: Any, c: Any) -> Number:
    """The solid angle of a triangle, positive where a, b, c turn left as the observer sees them.

    tan(Omega/2) = [a b c] / (abc + (a.b)c + (a.c)b + (b.c)a), of A. van Oosterom and
    J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125; from -2 pi to 2 pi.

    Parameters
    ----------
    a, b, c : triple of floats, or array (..., 3)
        The vertices, from the observer.

    Returns
    -------
    float or array (...)
    """
    a, b, c = vector(a), vector(b), vector(c)
    return _triangle(a, b, c, minus(b, a), minus(c, a))


def _triangle(a: Vector, b: Vector, c: Vector, ab: Vector, ac: Vector) -> Number:
    """The same, where the sides from a are known with all their digits."""
    la, lb, lc = length(a), length(b), length(c)
    under = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la
    return 2 * atan2(dot(a, cross(ab, ac)), under)


def fan(first: Vector, sides: Sequence[Vector]) -> Number:
    """The signed solid angle of a polygon, as the sum of the triangles of its first vertex."""
    points = [plus(first, side) for side in sides]
    total, sizes = 0.0, length(first)
    for i in range(1, len(sides) - 1):
        total = total + _triangle(first, points[i], points[i + 1], sides[i], sides[i + 1])
    # Of a splinter seen from near, the denominator of a triangle all but vanishes.
    spread = sum(length(side) for side in sides)
    return _unless(
        abs(total) < POOR * spread * spread / (spread + sizes) ** 2, total, first, sides, None
    )


POOR = 1e-2  # of the largest term: below it a sum has lost too many digits


def split(vertices: Any) -> tuple[Vector, list[Vector]]:
    """A polygon's first vertex, and every vertex from there."""
    if is_array(vertices) and hasattr(vertices, "shape"):
        points = [vector(vertices[..., i, :]) for i in range(vertices.shape[-2])]
    else:
        points = [vector(point) for point in vertices]
    if len(points) < 3:
        raise ConditionError("a polygon has three vertices or more", "X,Y,Z X,Y,Z X,Y,Z")
    return points[0], [minus(point, points[0]) for point in points]


def polygon(vertices: Any) -> Number:
    """The solid angle of a flat polygon, positive where it turns left as the observer sees it.

    Parameters
    ----------
    vertices : sequence of points, or array (..., n, 3)
        In their order, from the observer.

    Returns
    -------
    float or array (...)
    """
    return fan(*split(vertices))


def projected(first: Vector, sides: Sequence[Vector], normal: Vector) -> Number:
    """The signed projected solid angle of a polygon that is wholly above the horizon.

    J. H. Lambert's contour formula: half the sum of the angles that the sides subtend, each
    times the cosine between the normal and that of the side's plane.  The vector area of the
    directions to the vertices is taken apart from what the sides' arcs add to it: of a small
    polygon the sides' terms all but cancel.
    """
    far = length(first)
    points = [plus(first, side) for side in sides]
    lengths = [length(point) for point in points]
    # (p/|p| - p0/|p0|), from the side p - p0
    moves = []
    for side, point, size in zip(sides, points, lengths, strict=True):
        longer = dot(side, plus(point, first)) / (size + far)
        moves.append(plus(times(side, 1 / size), first, -longer / (size * far)))
    total, largest = 0.0, 0.0
    for i in range(1, len(sides) - 1):
        total = total + dot(normal, cross(moves[i], moves[i + 1]))
        largest = largest + length(moves[i]) * length(moves[i + 1])
    for i, (point, size) in enumerate(zip(points, lengths, strict=True)):
        j = (i + 1) % len(points)
        product = cross(point, minus(sides[j], sides[i]))
        scale = size * lengths[j]
        sine, cosine = length(product) / scale, dot(point, points[j]) / scale
        more = piecewise(cosine > 0.1, lambda s, c: arc_excess(s), _wide, sine, cosine)
        total = total + dot(normal, product) / scale * more
        largest = largest + sine * more
    return _unless(abs(total) < POOR * largest, total / 2, first, sides, normal)


def _unless(
    poor: Any,
    total: Number,
    first: Vector,
    sides: Sequence[Vector],
    normal: Vector | None,
) -> Number:
    """The total, or the integral over the triangles where the total is poor in digits."""
    if not any_true(poor):
        return total

    def exact(*xs: Any) -> Number:
        flat: list[Any] = [xs[i : i + 3] for i in range(0, len(xs), 3)]
        start, toward, rest = flat[0], (flat[1] if normal else None), flat[1 + bool(normal) :]
        pairs = pairwise(rest[1:])
        return sum(_integral(start, one, two, toward) for one, two in pairs)

    given = [*first, *(normal or ()), *(x for side in sides for x in side)]
    return piecewise(poor, lambda _, *xs: each(exact, *xs), lambda total, *xs: total, total, *given)


def _integral(a: Vector, ab: Vector, ac: Vector, normal: Vector | None) -> Number:
    """The integral over a triangle of the solid angle, or the projected one, of its parts."""
    bc, solid = minus(ac, ab), dot(a, cross(ab, ac))

    def part(u: float, v: float) -> Number:
        p = (
            a[0] + u * (ab[0] + v * bc[0]),
            a[1] + u * (ab[1] + v * bc[1]),
            a[2] + u * (ab[2] + v * bc[2]),
        )
        square = dot(p, p)
        weight = math.sqrt(square) if normal is None else dot(normal, p)
        return u * weight / square**2

    return solid * adaptive(lambda u: adaptive(lambda v: part(u, v), 0.0, 1.0), 0.0, 1.0)


def _wide(sine: Number, cosine: Number) -> Number:
    """beta/sin(beta) - 1, for an angle that is not small."""
    if any_true(sine == 0):
        raise ConditionError("the observer is on an edge of the polygon", "a viewpoint off it")
    return atan2(sine, cosine) / sine - 1


def above(first: Vector, sides: Sequence[Vector], normal: Vector) -> tuple[Vector, list[Vector]]:
    """The part of a polygon above the horizon of a normal (floats only); [] where none is."""
    base = dot(normal, first)
    heights = [base + dot(normal, side) for side in sides]
    kept: list[Vector] = []
    for i, (side, height) in enumerate(zip(sides, heights, strict=True)):
        before, low = sides[i - 1], heights[i - 1]
        if (low < 0) != (height < 0) and low != 0 and height != 0:
            kept.append(plus(before, minus(side, before), low / (low - height)))
        if height >= 0:
            kept.append(side)
    if len(kept) < 3:
        return first, []
    return plus(first, kept[0]), [minus(side, kept[0]) for side in kept]
