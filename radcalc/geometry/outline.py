"""Checks of polygons that a user typed.

`read` refuses vertices that are not those of a plane polygon, or a viewpoint in its plane.  Lengths
are in any one unit; floats only.
"""

import math
from collections.abc import Sequence
from functools import reduce
from itertools import pairwise, product, starmap

from radcalc.errors import ConditionError, call, correct, leave_out
from radcalc.geometry.numerics.vectors import cross, dot, length, minus, plus, times
from radcalc.maths import power_of_two

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
    >>> outline = read(square, (0.0, 0.0, 0.0))
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
        >>> outline = read([(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0)], (0.0, 0.0, 0.0))
        >>> outline.dips_below((1.0, 0.0, 0.0)), outline.dips_below((-1.0, 0.0, 0.0))
        (False, True)
        """
        return any(dot(normal, vertex) < 0 for vertex in self.vertices)


def read(points: Sequence[Point], viewpoint: Point) -> Outline:
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
    >>> read(square, (0.0, 0.0, 0.0)).normal
    (0.0, 0.0, 1.0)
    >>> read([square[0], square[2], square[1], square[3]], (0.0, 0.0, 0.0))
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
    scale = 1 / power_of_two(max(abs(x) for point in (*points, viewpoint) for x in point) or 1.0)
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
