"""Solid angles of triangles and polygons, and their parts above a horizon.

`triangle` and `polygon` compute solid angles [sr] from vertices; `projected` weights each direction
by its cosine to a normal; `above` cuts off the part below a receiver's horizon.

A point is a triple of coordinates, a tuple of floats or arrays or the last axis of an array,
relative to the observer, in any one unit of length.  `split` turns a list of vertices into the form
that the other functions take: the first vertex, and all vertices *from that one* (the first of
these is zero).  These differences keep all digits of a small polygon far away.

The vertices must be in one plane, and the observer must not, which only
`radcalc.geometry.outline.read` checks.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from radcalc.errors import ConditionError
from radcalc.geometry.cones import refuse
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

POOR = 1e-2  # [1] of the terms' sizes: a sum below it has lost too many digits


def triangle(a: Any, b: Any, c: Any) -> Number:
    """Return the signed solid angle of a plane triangle, by Van Oosterom and Strackee's formula.

    Parameters
    ----------
    a, b, c : tuple of 3 floats or ndarrays, or ndarray of shape (..., 3) [m]
        The vertices, from the observer.

    Returns
    -------
    float or ndarray of shape (...) [sr]
        From -2 pi to 2 pi, with the sign of the triple product [a b c]: positive if a, b, c are
        clockwise for the observer, and so anticlockwise from the far side.

    Raises
    ------
    ConditionError
        If a vertex does not have three coordinates, or the integral of a splinter does not
        converge.

    Notes
    -----
    ::

        tan(Omega/2) = [a b c] / (|a||b||c| + (a.b)|c| + (a.c)|b| + (b.c)|a|)

    with [a b c] = a . (b x c).  Exact.  It is solved with atan2, because the denominator is
    negative for triangles of more than pi sr.  The triple product is computed from b - a and c - a.
    For a splinter seen from close by, the denominator is a small difference; it is integrated strip
    by strip (`radcalc.geometry.numerics.strips`).

    References
    ----------
    .. [1] A. van Oosterom and J. Strackee, The Solid Angle of a Plane Triangle, IEEE Trans.
       Biomed. Eng. BME-30 (1983) 125, doi:10.1109/TBME.1983.325207.

    Examples
    --------
    Three directions at right angles bound an eighth of all directions, 4 pi/8 sr:

    >>> import math
    >>> x, y, z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
    >>> round(triangle(x, y, z) / (math.pi / 2), 12)
    1.0
    """
    a, b, c = vector(a), vector(b), vector(c)
    return in_chunks(_from_vertices, *a, *b, *c)


def _from_vertices(*xs: Number) -> Number:
    """Return the solid angle of a triangle from nine coordinates, as `in_chunks` passes them."""
    a, b, c = xs[:3], xs[3:6], xs[6:]
    return _triangle(a, b, c, minus(b, a), minus(c, a))


def _triangle(a: Vector, b: Vector, c: Vector, ab: Vector, ac: Vector) -> Number:
    """Return the solid angle of a triangle whose sides from a are known with all their digits."""
    la, lb, lc = length(a), length(b), length(c)
    whole = la * lb * lc
    under = whole + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la
    triple = dot(a, cross(ab, ac))
    angle = 2 * atan2(triple, under)
    # For a splinter seen from close by, `under` is a small difference of large terms.
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
    """Scale a polygon so that no square or cube of a length overflows or underflows.

    Parameters
    ----------
    first, sides : tuple of 3 floats or ndarrays, sequence of such tuples [m]
        The vertices, as `split` returns them.

    Returns
    -------
    first, sides : tuple of 3 floats or ndarrays, list of such tuples [1]
        The same in the new unit; every coordinate of the first vertex is below 1.

    Notes
    -----
    The unit is the power of two above the largest coordinate: a division by it is exact.

    Examples
    --------
    >>> scaled((0.0, 0.0, 4.0), [(0.0, 0.0, 0.0), (4.0, 0.0, 0.0), (0.0, 2.0, 0.0)])
    ((0.0, 0.0, 0.5), [(0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (0.0, 0.25, 0.0)])
    """
    size = abs(first[0])
    for x in (*first[1:], *(x for side in sides for x in side)):
        size = larger(size, abs(x))
    scale = 1 / power_of_two(size)
    return times(first, scale), [times(side, scale) for side in sides]


def fan(first: Vector, sides: Sequence[Vector]) -> Number:
    """Return the signed solid angle of a polygon, the sum of the triangles from its first vertex.

    Parameters
    ----------
    first, sides : tuple of 3 floats or ndarrays, sequence of such tuples [m]
        The vertices, as `split` returns them.

    Returns
    -------
    float or ndarray [sr]
        From -2 pi to 2 pi; positive if the vertices are clockwise for the observer.

    Raises
    ------
    ConditionError
        If the integral of a splinter does not converge.

    Notes
    -----
    Exact for convex and concave polygons: parts of triangles outside the polygon are counted once
    positively and once negatively.

    Examples
    --------
    The face of a cube, from the cube's centre, fills 4 pi/6 sr:

    >>> import math
    >>> sides = [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (2.0, 2.0, 0.0), (0.0, 2.0, 0.0)]
    >>> round(fan((-1.0, -1.0, 1.0), sides) / (4 * math.pi / 6), 12)
    1.0
    """
    first, sides = scaled(first, sides)
    points = [plus(first, side) for side in sides]
    total = 0.0
    for i in range(1, len(sides) - 1):
        total = total + _triangle(first, points[i], points[i + 1], sides[i], sides[i + 1])
    return total


def split(vertices: Any) -> tuple[Vector, list[Vector]]:
    """Return the first vertex of a polygon, and all vertices relative to it.

    Parameters
    ----------
    vertices : sequence of points, or ndarray of shape (..., n, 3) [m]
        At least three vertices, in order round the polygon, from the observer.

    Returns
    -------
    first : tuple of 3 floats or ndarrays [m]
        The first vertex.
    sides : list of n such tuples [m]
        Every vertex minus the first one; the first of these is zero.

    Raises
    ------
    ConditionError
        If there are fewer than three vertices, or one does not have three coordinates.

    Examples
    --------
    >>> split([(1.0, 0.0, 5.0), (3.0, 0.0, 5.0), (1.0, 4.0, 5.0)])
    ((1.0, 0.0, 5.0), [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (0.0, 4.0, 0.0)])
    """
    if is_array(vertices) and hasattr(vertices, "shape"):
        points = [vector(vertices[..., i, :]) for i in range(vertices.shape[-2])]
    else:
        points = [vector(point) for point in vertices]
    if len(points) < 3:
        raise ConditionError("a polygon has three vertices or more", "X,Y,Z X,Y,Z X,Y,Z")
    return points[0], [minus(point, points[0]) for point in points]


def polygon(vertices: Any) -> Number:
    """Return the signed solid angle of a plane polygon.

    Parameters
    ----------
    vertices : sequence of points, or ndarray of shape (..., n, 3) [m]
        At least three vertices in one plane, in order round the polygon, from the observer and in
        any one unit of length.  The polygon may be concave; its sides must not cross.

    Returns
    -------
    float or ndarray of shape (...) [sr]
        From -2 pi to 2 pi; positive if the vertices are clockwise for the observer, and so
        anticlockwise from the far side.

    Raises
    ------
    ConditionError
        If there are fewer than three vertices, one does not have three coordinates, or the integral
        of a splinter does not converge.

    Notes
    -----
    The sum of the triangles from the first vertex, each by `triangle`.  Exact.

    Examples
    --------
    The face of a cube, from the cube's centre, fills 4 pi/6 sr:

    >>> import math
    >>> face = [(-1.0, -1.0, 1.0), (1.0, -1.0, 1.0), (1.0, 1.0, 1.0), (-1.0, 1.0, 1.0)]
    >>> round(polygon(face) / (4 * math.pi / 6), 12)
    1.0
    """
    return fan(*split(vertices))


def projected(first: Vector, sides: Sequence[Vector], normal: Vector) -> Number:
    """Return the signed projected solid angle of a polygon, by Lambert's contour formula.

    Parameters
    ----------
    first, sides : tuple of 3 floats or ndarrays, sequence of such tuples [m]
        The vertices, as `split` returns them.
    normal : tuple of 3 floats or ndarrays [1]
        The receiver's normal, of length 1.  The whole polygon must be above the receiver's horizon:
        `above` cuts off the rest.

    Returns
    -------
    float or ndarray [sr]
        From -pi to pi; positive if the vertices are clockwise for the observer.

    Raises
    ------
    ConditionError
        If the observer is on a side of the polygon, or the integral of a splinter does not
        converge.

    Notes
    -----
    ::

        Omega_p = 1/2 sum over the sides of  beta n . (p x q) / |p x q|

    where the side from p to q subtends the angle beta.  Exact.  The terms of a small polygon nearly
    cancel.  Therefore the vector area of the polygon whose vertices are the unit vectors p/|p| is
    computed first, and each side adds only the excess of its arc over its chord,
    beta/sin(beta) - 1.
    If these also cancel (a splinter, or a polygon along the horizon) the triangles are integrated
    strip by strip.

    References
    ----------
    .. [1] J. H. Lambert, Photometria (1760).
    .. [2] D. R. Baum, H. E. Rushmeier and J. M. Winget, Improving Radiosity Solutions Through the
       Use of Analytically Determined Form-Factors, Computer Graphics 23 (1989) 325.

    Examples
    --------
    The octant x, y, z > 0 is a quarter of the hemisphere above z = 0, pi/4 sr:

    >>> import math
    >>> octant = split([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)])
    >>> round(projected(*octant, (0.0, 0.0, 1.0)) / (math.pi / 4), 12)
    1.0
    """
    first, sides = scaled(first, sides)
    far = length(first)
    points = [plus(first, side) for side in sides]
    lengths = [length(point) for point in points]
    for size in lengths:
        refuse(size == 0, "the observer is at a corner of the shape", "another viewpoint")
    moves = [_move(first, far, *vertex) for vertex in zip(sides, points, lengths, strict=True)]
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
        return sum(
            over_triangle(start, vertex, next_vertex, toward) for vertex, next_vertex in pairs
        )

    given = [*first, *normal, *(x for side in sides for x in side)]
    return piecewise(
        poor, lambda _, *xs: each(strips, *xs), lambda half, *_: half, total / 2, *given
    )


def _move(first: Vector, far: Number, side: Vector, point: Vector, size: Number) -> Vector:
    """Return p/|p| - p0/|p0|, without loss of digits for a short side from p0 to p."""
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
    """Return beta/sin(beta) - 1, for an angle that is not small."""
    if any_true(sine == 0):
        raise ConditionError("the observer is on an edge of the polygon", "another viewpoint")
    return atan2(sine, cosine) / sine - 1


def above(first: Vector, sides: Sequence[Vector], normal: Vector) -> tuple[Vector, list[Vector]]:
    """Return the part of a polygon above the horizon of a normal, with its crossings.

    Parameters
    ----------
    first, sides : tuple of 3 floats, sequence of such tuples [m]
        The vertices, as `split` returns them.  Floats only: the number of vertices kept would
        differ between the elements of an array.
    normal : tuple of 3 floats [1]
        The receiver's normal; its horizon is the plane through the observer perpendicular to it.

    Returns
    -------
    first, sides : tuple of 3 floats, list of such tuples [m]
        The part in the same form; `sides` is empty if the whole polygon is below.

    Notes
    -----
    One step of Sutherland and Hodgman's clipping.  The part of a concave polygon may have edges
    along the horizon that run there and back, which cancel.

    References
    ----------
    .. [1] I. E. Sutherland and G. W. Hodgman, Reentrant Polygon Clipping, Commun. ACM 17 (1974)
       32, doi:10.1145/360767.360802.

    Examples
    --------
    A square in the plane x = 1, half of it above z = 0:

    >>> square = split([(1.0, -1.0, -1.0), (1.0, 1.0, -1.0), (1.0, 1.0, 1.0), (1.0, -1.0, 1.0)])
    >>> first, sides = above(*square, (0.0, 0.0, 1.0))
    >>> [tuple(f + s for f, s in zip(first, side)) for side in sides]
    [(1.0, -1.0, 0.0), (1.0, 1.0, 0.0), (1.0, 1.0, 1.0), (1.0, -1.0, 1.0)]
    """
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
