"""Solid angles of splinters: triangles whose closed forms lose their digits.

`radcalc.geometry.polygons` uses it if Van Oosterom and Strackee's formula or Lambert's contour
formula is a small difference of large terms.

The triangle is cut into strips perpendicular to its longest side.  Lengths along that side and
along the strips are hyperbolic sines of parameters, which gives every decade of length the same
share of points, so few strips are enough even for triangles that pass close by the observer and
reach far away.  Every term is positive, so no digits cancel.  Floats only; lengths in any one unit.
"""

import math

from radcalc.errors import ConditionError
from radcalc.geometry.numerics.quadrature import adaptive, integral
from radcalc.geometry.numerics.vectors import Vector, cross, dot, length, minus, plus, times

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
    >>> from radcalc.geometry.numerics.strips import over_triangle
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
