"""Solid angles of triangles and polygons, and what of them lies above a horizon.

A point is a triple of coordinates: a tuple of floats, of arrays, or the last axis of an array.
The vertices are taken from the observer; inside, a polygon is its first vertex and all
vertices *from that one*, whose differences keep their digits however far the polygon is.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from radcalc.errors import ConditionError
from radcalc.geometry.numerics.special import arc_excess
from radcalc.geometry.numerics.strips import over_triangle
from radcalc.geometry.numerics.vectors import Vector, cross, dot, length, minus, plus, times, vector
from radcalc.maths import (
    Number,
    any_true,
    atan2,
    each,
    in_chunks,
    is_array,
    larger,
    piecewise,
    power_of_two,
    smaller,
)

POOR = 1e-2  # of the largest term: below it a sum has lost too many digits


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
    return in_chunks(_from_vertices, *a, *b, *c)


def _from_vertices(*xs: Number) -> Number:
    a, b, c = xs[:3], xs[3:6], xs[6:]
    return _triangle(a, b, c, minus(b, a), minus(c, a))


def _triangle(a: Vector, b: Vector, c: Vector, ab: Vector, ac: Vector) -> Number:
    """The same, where the sides from a are known with all their digits."""
    la, lb, lc = length(a), length(b), length(c)
    whole = la * lb * lc
    under = whole + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la
    triple = dot(a, cross(ab, ac))
    angle = 2 * atan2(triple, under)
    # Of a splinter seen from near, `under` is a small difference of large terms.
    size = abs(under)
    off = (whole * abs(triple) > 1e3 * abs(angle) * (triple * triple + size * size)) | (
        size < 1e-13 * whole
    )
    if not any_true(off):
        return angle

    def strips(*xs: Any) -> Number:
        return over_triangle(xs[:3], xs[3:6], xs[6:])

    return piecewise(
        off, lambda _, *xs: each(strips, *xs), lambda angle, *_: angle, angle, *a, *ab, *ac
    )


def scaled(first: Vector, sides: Sequence[Vector]) -> tuple[Vector, list[Vector]]:
    """A polygon made so small or large that no square of a length leaves the floats."""
    size = abs(first[0])
    for x in (*first[1:], *(x for side in sides for x in side)):
        size = larger(size, abs(x))
    scale = 1 / power_of_two(size)
    return times(first, scale), [times(side, scale) for side in sides]


def fan(first: Vector, sides: Sequence[Vector]) -> Number:
    """The signed solid angle of a polygon, as the sum of the triangles of its first vertex."""
    first, sides = scaled(first, sides)
    points = [plus(first, side) for side in sides]
    total = 0.0
    for i in range(1, len(sides) - 1):
        total = total + _triangle(first, points[i], points[i + 1], sides[i], sides[i + 1])
    return total


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
    first, sides = scaled(first, sides)
    far = length(first)
    points = [plus(first, side) for side in sides]
    lengths = [length(point) for point in points]
    moves = [_move(first, far, *one) for one in zip(sides, points, lengths, strict=True)]
    turns = [
        smaller(length(side) / size, 2.0 + 0 * size)
        for side, size in zip(sides, lengths, strict=True)
    ]
    total, largest = 0.0, 0.0
    for i in range(1, len(sides) - 1):
        total = total + dot(normal, cross(moves[i], moves[i + 1]))
        largest = largest + turns[i] * turns[i + 1]
    for i, (point, size) in enumerate(zip(points, lengths, strict=True)):
        j = (i + 1) % len(points)
        product = cross(point, minus(sides[j], sides[i]))
        scale = size * lengths[j]
        sine, cosine = length(product) / scale, dot(point, points[j]) / scale
        more = piecewise(cosine > 0.1, lambda s, c: arc_excess(s), _wide, sine, cosine)
        total = total + dot(normal, product) / scale * more
        largest = largest + sine * more
    poor = abs(total) < POOR * largest
    if not any_true(poor):
        return total / 2

    def strips(*xs: Any) -> Number:
        start, toward, *rest = (xs[i : i + 3] for i in range(0, len(xs), 3))
        pairs = pairwise(rest[1:])
        return sum(over_triangle(start, one, two, toward) for one, two in pairs)

    given = [*first, *normal, *(x for side in sides for x in side)]
    return piecewise(
        poor, lambda _, *xs: each(strips, *xs), lambda half, *_: half, total / 2, *given
    )


def _move(first: Vector, far: Number, side: Vector, point: Vector, size: Number) -> Vector:
    """p/|p| - p0/|p0|; of a short side from p0 to p without the loss of its digits."""
    longer = dot(side, plus(point, first)) / (size + far)
    small = plus(times(side, 1 / size), first, -longer / (size * far))
    large = minus(times(point, 1 / size), times(first, 1 / far))
    short = length(side) < size / 2
    x, y, z = (
        piecewise(short, lambda s, _: s, lambda _, w: w, s, w)
        for s, w in zip(small, large, strict=True)
    )
    return x, y, z


def _wide(sine: Number, cosine: Number) -> Number:
    """beta/sin(beta) - 1, for an angle that is not small."""
    if any_true(sine == 0):
        raise ConditionError("the observer is on an edge of the polygon", "another viewpoint")
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
