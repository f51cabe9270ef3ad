"""Solid angles of triangles and polygons, and their parts above a horizon.

`triangle` and `polygon` compute solid angles [sr] from vertices; `projected` weights each direction
by its cosine to a normal; `above` cuts off the part below a receiver's horizon.

A point is a triple of coordinates, a tuple of floats or arrays or the last axis of an array,
relative to the observer, in any one unit of length.  `split` turns a list of vertices into the form
that the other functions take: the first vertex, and all vertices *from that one* (the first of
these is zero).  These differences keep all digits of a small polygon far away.

The vertices must be in one plane, and the observer must not, which only `read_vertices` checks: it
refuses typed vertices that are not those of a plane polygon.

The closed forms of triangles, Van Oosterom and Strackee's formula and Lambert's contour formula,
lose their digits for splinters, where they are small differences of large terms.  Such a triangle
is cut into strips perpendicular to its longest side.  Lengths along that side and along the strips
are hyperbolic sines of parameters, which gives every decade of length the same share of points, so
few strips are enough even for triangles that pass close by the observer and reach far away.  Every
term is positive, so no digits cancel.  Strips and typed vertices are floats only.
"""

import math
from collections.abc import Sequence
from functools import reduce
from itertools import pairwise, product, starmap
from typing import Any

from radcalc import maths
from radcalc.errors import ConditionError, call, correct, leave_out
from radcalc.geometry import refuse
from radcalc.geometry.numerics import adaptive, arc_excess, integral
from radcalc.geometry.projections import Vector, cross, dot, length, minus, plus, times, vector

STRIPS = 120  # intervals of strips, to limit the time; the thinnest splinters need fewer
# [1] at which to stop.  If an edge passes the observer at 1e-9 of its length, the coordinates do
# not have enough digits for the first.
ACCURACY, COARSE_ACCURACY = 1e-13, 1e-8
FAR = 15.0  # parameter of a strip at which sech^3 has fallen to 1e-19


def over_triangle(a: Vector, ab: Vector, ac: Vector, normal: Vector | None = None) -> float:
    """Integrate the signed solid angle of a plane triangle, or its projected solid angle.

    Parameters
    ----------
    a : tuple of 3 floats [m]
        A vertex, from the observer, in any one unit of length.
    ab, ac : tuple of 3 floats [m]
        The other two vertices, from a.
    normal : tuple of 3 floats [1], optional
        The receiver's normal, of length 1, for the projected solid angle.  No part of the triangle
        may be below the receiver's horizon.

    Returns
    -------
    float [sr]
        With the sign of the triple product [a b c]: positive if a, b, c are clockwise for the
        observer.  0 if the observer is in the triangle's plane.

    Raises
    ------
    ConditionError
        If the integral does not converge, or a float cannot hold a ratio of lengths.

    Notes
    -----
    ::

        Omega = integral of  h / r^3 dA,    Omega_p = integral of  h z / r^4 dA

    over the triangle, with h the observer's distance from its plane, r the distance of a point of
    it and z that point's height over the receiver's horizon.  The integral across a strip is
    elementary for Omega; Gauss-Legendre rules integrate along the strips, and for Omega_p also
    across them.

    Examples
    --------
    The octant of all directions is 4 pi/8 sr, and pi/4 sr projected on a receiver that faces z:

    >>> import math
    >>> from radcalc.geometry.polygons import over_triangle
    >>> octant = (1.0, 0.0, 0.0), (-1.0, 1.0, 0.0), (-1.0, 0.0, 1.0)
    >>> round(over_triangle(*octant) / (math.pi / 2), 12)
    1.0
    >>> round(over_triangle(*octant, normal=(0.0, 0.0, 1.0)) / (math.pi / 4), 12)
    1.0
    """
    plane = cross(ab, ac)
    double_area = length(plane)
    height = dot(a, plane) / double_area if double_area else 0.0
    if height == 0:
        return 0.0
    bc = minus(ac, ab)
    # The base p-q is the longest side, r the apex above it.
    longest = max(((length(ab), 0), (length(bc), 1), (length(ac), 2)))[1]
    p, pq, pr = (
        (a, ab, ac),
        (plus(a, ab), bc, times(ab, -1.0)),
        (plus(a, ac), times(ac, -1.0), minus(ab, ac)),
    )[longest]
    base = length(pq)
    along = times(pq, 1 / base)
    across = times(cross(plane, along), 1 / double_area)
    start, level = dot(along, p), dot(across, p)
    foot, top = dot(along, pr), double_area / base
    left, right = None, None
    if normal is not None:
        foot_up, x, y = (
            dot(normal, plane) / double_area * height,
            dot(normal, along),
            dot(normal, across),
        )
        low = dot(normal, p)
        left, right = (foot_up, low, x, y), (foot_up, low + dot(normal, pq), -x, y)
    h = abs(height)
    try:
        halves = (
            _half(h, start, foot, level, top, left),
            _half(h, -start - base, base - foot, level, top, right),
        )
    except (ArithmeticError, ValueError):  # a ratio that a float cannot hold
        raise ConditionError(
            "the shape is too thin or too near for the integral", "lengths that differ less"
        ) from None
    return math.copysign(sum(halves), height)


Horizon = tuple[float, float, float, float]


def _half(
    h: float, start: float, width: float, level: float, top: float, horizon: Horizon | None
) -> float:
    """Integrate the right triangle from one end of the base to the foot of the apex.

    Along the base it starts at `start` from the observer's foot and is `width` wide; the base is
    at `level` across, the apex `top` above it.  `horizon` has the heights of the observer's foot
    and of the end of the base above the receiver's plane, and their slopes along and across.
    """
    if width <= 0:
        return 0.0
    u0 = math.asinh(start / h)
    # Heights are counted from the foot, or from the end if the whole triangle is near the end.
    from_end = False
    if horizon:
        up, low, x, y = horizon
        reach = abs(x) * (abs(start) + width) + abs(y) * (abs(level) + top)
        from_end = abs(low) + abs(x) * width + abs(y) * top < 1e-3 * (abs(up) + reach)

    def strip(du: float) -> float:
        u = u0 + du
        q = h * math.cosh(u)
        run = 2 * h * math.cosh(u0 + du / 2) * math.sinh(du / 2)
        rise = top * run / width
        if horizon is None:
            return _strip(h, q, level, rise) * q
        height = low + x * run if from_end else up + x * h * math.sinh(u)
        return _projected_strip(h, q, level, rise, height, y, from_end) * q

    step = _sinh_step(start / h, width / h)
    try:
        return adaptive(strip, 0.0, step, ACCURACY, STRIPS)
    except ConditionError:  # the coordinates have too few digits for the place of the edge
        return adaptive(strip, 0.0, step, COARSE_ACCURACY, STRIPS)


def _sinh_step(x: float, dx: float) -> float:
    """Return asinh(x + dx) - asinh(x), to full precision also for a small step."""
    y = x + dx
    if x * y <= 0:
        return math.asinh(y) - math.asinh(x)
    root_x, root_y = math.hypot(1, x), math.hypot(1, y)
    return math.asinh(dx * (x + y) / (y * root_x + x * root_y))


def _strip(h: float, q: float, level: float, rise: float) -> float:
    """Return the integral of h/r^3 across, from `level` over `rise`, at q from the observer."""
    end = level + rise
    r, s = math.hypot(q, level), math.hypot(q, end)
    if level * end > 0:
        return h * rise / r / s * ((level + end) / (end * r + level * s))
    return h / q / q * (end / s - level / r)


def _projected_strip(
    h: float, q: float, level: float, rise: float, up: float, slope: float, from_end: bool
) -> float:
    """Return the integral of h z/r^4 across.

    z, which is at least 0, is `up` at the observer's foot, or at `level` if `from_end`, and rises
    with `slope`.
    """
    v0 = math.asinh(level / q)
    whole = _sinh_step(level / q, rise / q)
    start, end = 0.0, whole
    if v0 + whole <= 0:  # all on the far side: the near end dominates
        start = max(0.0, whole - FAR)
    elif v0 >= 0:
        end = min(whole, FAR)
    else:
        start, end = max(0.0, -FAR - v0), min(whole, FAR - v0)

    def part(dv: float) -> float:
        v = v0 + dv
        y = 2 * math.cosh(v0 + dv / 2) * math.sinh(dv / 2) if from_end else math.sinh(v)
        return max(0.0, up + slope * q * y) / math.cosh(v) ** 3

    panels = max(1, math.ceil(end - start))
    step = (end - start) / panels
    sums = (integral(part, start + k * step, start + (k + 1) * step, 12) for k in range(panels))
    return h / q / q / q * math.fsum(sums)


POOR = 1e-2  # [1] of the terms' sizes: a sum below it has lost too many digits


def triangle(a: Any, b: Any, c: Any) -> maths.Number:
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
    by strip (`radcalc.geometry.polygons`).

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
    return maths.in_chunks(_from_vertices, *a, *b, *c)


def _from_vertices(*xs: maths.Number) -> maths.Number:
    """Return the solid angle of a triangle from nine coordinates, as `in_chunks` passes them."""
    a, b, c = xs[:3], xs[3:6], xs[6:]
    return _triangle(a, b, c, minus(b, a), minus(c, a))


def _triangle(a: Vector, b: Vector, c: Vector, ab: Vector, ac: Vector) -> maths.Number:
    """Return the solid angle of a triangle whose sides from a are known with all their digits."""
    la, lb, lc = length(a), length(b), length(c)
    whole = la * lb * lc
    under = whole + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la
    triple = dot(a, cross(ab, ac))
    angle = 2 * maths.atan2(triple, under)
    # For a splinter seen from close by, `under` is a small difference of large terms.
    size = abs(under)
    off = (whole * abs(triple) > 1e3 * abs(angle) * (triple * triple + size * size)) | (
        size < 1e-13 * whole
    )
    if not maths.any_true(off):
        return angle

    def strips(*xs: Any) -> maths.Number:
        return over_triangle(xs[:3], xs[3:6], xs[6:])

    return maths.piecewise(
        off, lambda _, *xs: maths.each(strips, *xs), lambda angle, *_: angle, angle, *a, *ab, *ac
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
        size = maths.larger(size, abs(x))
    scale = 1 / maths.power_of_two(size)
    return times(first, scale), [times(side, scale) for side in sides]


def fan(first: Vector, sides: Sequence[Vector]) -> maths.Number:
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
    if maths.is_array(vertices) and hasattr(vertices, "shape"):
        points = [vector(vertices[..., i, :]) for i in range(vertices.shape[-2])]
    else:
        points = [vector(point) for point in vertices]
    if len(points) < 3:
        raise ConditionError("a polygon has three vertices or more", "X,Y,Z X,Y,Z X,Y,Z")
    return points[0], [minus(point, points[0]) for point in points]


def polygon(vertices: Any) -> maths.Number:
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


def projected(first: Vector, sides: Sequence[Vector], normal: Vector) -> maths.Number:
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
        maths.smaller(length(side) / size, 2.0 + 0 * size)
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
        more = maths.piecewise(cosine > 0.1, lambda s, c: arc_excess(s), _wide, sine, cosine)
        total = total + dot(normal, product) / scale * more
        largest = largest + sine * more
    poor = abs(total) < POOR * largest
    if not maths.any_true(poor):
        return total / 2

    def strips(*xs: Any) -> maths.Number:
        start, toward, *rest = (xs[i : i + 3] for i in range(0, len(xs), 3))
        pairs = pairwise(rest[1:])
        return sum(
            over_triangle(start, vertex, next_vertex, toward) for vertex, next_vertex in pairs
        )

    given = [*first, *normal, *(x for side in sides for x in side)]
    return maths.piecewise(
        poor, lambda _, *xs: maths.each(strips, *xs), lambda half, *_: half, total / 2, *given
    )


def _move(
    first: Vector, far: maths.Number, side: Vector, point: Vector, size: maths.Number
) -> Vector:
    """Return p/|p| - p0/|p0|, without loss of digits for a short side from p0 to p."""
    longer = dot(side, plus(point, first)) / (size + far)
    small = plus(times(side, 1 / size), first, -longer / (size * far))
    large = minus(times(point, 1 / size), times(first, 1 / far))
    short = length(side) < size / 2
    x, y, z = (
        maths.piecewise(short, lambda s, _: s, lambda _, w: w, s, w)
        for s, w in zip(small, large, strict=True)
    )
    return x, y, z


def _wide(sine: maths.Number, cosine: maths.Number) -> maths.Number:
    """Return beta/sin(beta) - 1, for an angle that is not small."""
    if maths.any_true(sine == 0):
        raise ConditionError("the observer is on an edge of the polygon", "another viewpoint")
    return maths.atan2(sine, cosine) / sine - 1


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


Point = tuple[float, float, float]
FLAT = 1e-6  # [1] of the polygon's size: largest distance of a vertex from the plane
NOTED = 1e-12  # [1] of the polygon's size: largest such distance without a note
MOST = 1000  # vertices; every side is checked against every other one


class Outline:
    """A plane polygon seen from a viewpoint, checked by `read`.

    Parameters
    ----------
    vertices : list of tuples of 3 floats
        Vertices in order, from the observer.  `read` scales them by a power of two, so they serve
        for solid angles, not for lengths.
    normal : tuple of 3 floats [1]
        Normal of the polygon's plane, of length 1, on the side away from the observer.
    notes : list of str
        Notes for the user.

    Attributes
    ----------
    vertices, normal, notes
        As given.

    Examples
    --------
    >>> square = [(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0), (0.0, 1.0, 1.0)]
    >>> outline = read_vertices(square, (0.0, 0.0, 0.0))
    >>> outline.normal, outline.notes
    ((0.0, 0.0, 1.0), [])
    """

    def __init__(self, vertices: list[Point], normal: Point, notes: list[str]) -> None:
        self.vertices = vertices
        self.normal = normal
        self.notes = notes

    def dips_below(self, normal: Point) -> bool:
        """Return whether a vertex is below the horizon of a receiver.

        Parameters
        ----------
        normal : tuple of 3 floats
            The receiver's normal, of any length.

        Returns
        -------
        bool
            A vertex on the horizon is not below it.

        Examples
        --------
        >>> triangle = [(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0)]
        >>> outline = read_vertices(triangle, (0.0, 0.0, 0.0))
        >>> outline.dips_below((1.0, 0.0, 0.0)), outline.dips_below((-1.0, 0.0, 0.0))
        (False, True)
        """
        return any(dot(normal, vertex) < 0 for vertex in self.vertices)


def read_vertices(points: Sequence[Point], viewpoint: Point) -> Outline:
    """Check the vertices of a polygon, and return them relative to a viewpoint.

    Parameters
    ----------
    points : sequence of tuples of 3 floats [m]
        The vertices in order, from 3 to 1000, without the first one again at the end; in any one
        unit of length.
    viewpoint : tuple of 3 floats [m]
        Position of the observer.

    Returns
    -------
    Outline
        Vertices and normal, seen from the viewpoint, with a note if the vertices are off one
        plane by more than rounding errors.

    Raises
    ------
    ConditionError
        If there are fewer than 3 or more than 1000 vertices, a vertex is given twice, the polygon
        has no area, a vertex is off the plane by more than 1e-6 of the polygon's size, sides
        cross or touch, or the viewpoint is in the polygon's plane.

    Notes
    -----
    The normal is Newell's: the sum of the vector products of successive vertices.

    References
    ----------
    .. [1] F. Tampieri, Newell's Method for Computing the Plane Equation of a Polygon, in D. Kirk
       (ed.), Graphics Gems III (Academic Press, 1992).

    Examples
    --------
    >>> square = [(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0), (0.0, 1.0, 1.0)]
    >>> read_vertices(square, (0.0, 0.0, 0.0)).normal
    (0.0, 0.0, 1.0)
    >>> read_vertices([square[0], square[2], square[1], square[3]], (0.0, 0.0, 0.0))
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: the polygon's sides cross or touch
    try: the vertices in order round it
    """
    if not 3 <= len(points) <= MOST:
        raise ConditionError(
            f"a polygon cannot have {len(points)} vertices", f"from 3 to {MOST}, as X,Y,Z"
        )
    for k, point in enumerate(points):
        if point in points[:k]:
            raise ConditionError(
                f"the vertex {_write(point)} is given twice",
                "each once, and no closing one",
                [correct(_write(point))],
            )
    # Only directions matter, so lengths are scaled so that no square overflows.
    scale = 1 / maths.power_of_two(
        max(abs(x) for point in (*points, viewpoint) for x in point) or 1.0
    )
    typed, points = points, [times(point, scale) for point in points]
    viewpoint = times(viewpoint, scale)
    first = points[0]
    sides = [minus(point, first) for point in points]
    size = max(map(length, sides))
    # Newell's normal, whose length is twice the area
    area: Point = reduce(plus, starmap(cross, pairwise(sides[1:])), (0.0, 0.0, 0.0))
    if length(area) <= 1e-12 * size * size:
        widest = max(map(length, starmap(cross, product(sides, sides))))
        if widest > 1e-12 * size * size:
            raise _crossing(typed)  # a bow tie, whose halves are equal
        raise ConditionError("the polygon has no area", "vertices that are not on one line")
    unit = times(area, 1 / length(area))
    off = max(abs(dot(unit, side)) for side in sides)
    if off > FLAT * size:
        raise ConditionError(
            f"the polygon is not flat: its vertices are up to {off / scale:.3g} away from a plane",
            "its triangles, one by one",
        )
    _refuse_crossing(typed, sides, unit)
    away = minus(first, viewpoint)
    height = dot(unit, away)
    if abs(height) <= 1e-12 * max(size, length(away)):
        raise ConditionError(
            "the viewpoint is in the polygon's plane",
            "a viewpoint off that plane",
            [leave_out("viewpoint")] if any(viewpoint) else (),
        )
    notes = []
    if off > NOTED * size:
        notes = [f"the vertices are up to {off / scale:.2g} away from a plane"]
    normal = times(unit, math.copysign(1.0, height))
    return Outline([plus(away, side) for side in sides], normal, notes)


def _refuse_crossing(points: Sequence[Point], sides: Sequence[Point], unit: Point) -> None:
    """Refuse sides that cross: the two halves of a bow tie would be subtracted."""
    axis = max(range(3), key=lambda k: abs(unit[k]))
    flat = [tuple(x for k, x in enumerate(side) if k != axis) for side in sides]
    count = len(flat)

    def turn(a: int, b: int, c: int) -> float:
        (ax, ay), (bx, by), (cx, cy) = flat[a % count], flat[b % count], flat[c % count]
        return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

    for j in range(count):
        for k in range(j + 2, count - (j == 0)):
            apart = turn(j, j + 1, k) * turn(j, j + 1, k + 1)
            across = turn(k, k + 1, j) * turn(k, k + 1, j + 1)
            if apart <= 0 and across <= 0 and (apart or across):
                raise _crossing(points)


def _crossing(points: Sequence[Point]) -> ConditionError:
    """Return the error for sides that cross; also for a bow tie without vector area.

    The call that it proposes has the vertices in order around their middle.
    """
    middle = times(reduce(plus, points), 1 / len(points))
    sides = [minus(point, middle) for point in points]
    normal = max((cross(sides[0], side) for side in sides), key=length)

    def angle(k: int) -> float:
        along = dot(sides[0], sides[k]) * length(normal)
        return math.atan2(dot(normal, cross(sides[0], sides[k])), along) % math.tau

    ordered = [_write(points[k]) for k in sorted(range(len(points)), key=angle)]
    problem, hint = "the polygon's sides cross or touch", "the vertices in order round it"
    return ConditionError(problem, hint, [call("solid-angle", "polygon", *ordered)])


def _write(point: Point) -> str:
    """Return a point as the user would type it."""
    return ",".join(f"{x:.12g}" for x in point)
