"""Light vectors of the parts of an image: integrals of the unit direction over their solid angles.

A part of radiance L wholly above the horizon of a receiver with the normal n gives it the
irradiance L n . V, where V is the part's light vector.  Here an image is cut into rectangles by
edges of rising u (to the right) and falling v (downwards); `projections` defines the coordinates.
"""

import math
from typing import Any

import numpy

from radcalc.geometry.directions import Vector
from radcalc.geometry.numerics.integrals import gauss
from radcalc.geometry.projections import ROUND, density, direction_at, solid_angles_in_circle
from radcalc.quantities import symbols


def light_vectors(projection: str, u: Any, v: Any) -> Any:
    """Return the light vectors of the rectangles of an image.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}
    u : ndarray of shape (..., n + 1) [1]
        Edges from left to right, from -1 to 1.
    v : ndarray of shape (..., m + 1) [1]
        Edges from top to bottom, from 1 to -1.

    Returns
    -------
    ndarray of shape (3, ..., m, n) [sr]
        In the map's own axes; 0 outside the circle of a mirror ball or an angular map.

    Raises
    ------
    ConditionError
        If the projection is unknown.

    Notes
    -----
    Closed forms, with the polar angle t from z, the azimuth a, and n the normal of the ball::

        latlong      x, y: integral of sin(t)^2 dt times that of cos(a), sin(a) da
                     z: integral of sin(t) cos(t) dt times the width in a
        mirror-ball  4 times the integrals of (2 n^2 - 1, 2 n u, 2 n v) du dv
        equisolid    the same, with -u for u
        orthographic integrals of (1, -u / n, v / n) du dv

    Those with n are differences of antiderivatives, with an error of about 1e-15 sr.  For the
    others the density is integrated by two Gauss-Legendre points each way; a rectangle that the
    circle of an angular map cuts has the mean direction of the points inside, and the exact solid
    angle.

    Examples
    --------
    The upper half of a latlong map has the vector (0, 0, pi):

    >>> edges = numpy.array([-1.0, 1.0]), numpy.array([1.0, 0.0])
    >>> (light_vectors("latlong", *edges).ravel().round(12) + 0).tolist()
    [0.0, 0.0, 3.14159265359]
    """
    if projection in (symbols.LATLONG, symbols.CYLINDRICAL):
        t = (1 - v) * (math.pi / 2) if projection == symbols.LATLONG else numpy.arctan2(1.0, v)
        return _by_rows(u, t)
    across, down = u[..., None, :], v[..., :, None]
    if projection in (symbols.MIRROR_BALL, symbols.EQUISOLID):
        sign = 1 if projection == symbols.MIRROR_BALL else -1
        sides = [sign * _corners(_cubed, across, down), _corners(_cubed, down, across)]
        return numpy.stack([4 * _corners(_forward, across, down), *(-8 / 3 * s for s in sides)])
    if projection == symbols.ORTHOGRAPHIC:
        sides = [_corners(_normal, across, down), -_corners(_normal, down, across)]
        return numpy.stack([_corners(_area, across, down), *sides])
    if projection == symbols.ANGULAR:
        return _angular(across, down)
    return _by_points(projection, across, down)[0]


def solid_angles(projection: str, u: Any, v: Any) -> Any:
    """Return the solid angles of the rectangles of an image that shows a part of the sphere.

    Parameters
    ----------
    projection : str
        One of those with a field of view.
    u, v
        As in `light_vectors`.

    Returns
    -------
    ndarray of shape (..., m, n) [sr]

    Raises
    ------
    ConditionError
        If the projection is unknown.

    Examples
    --------
    The upper half of a hemisphere, and a face of a cube:

    >>> edges = numpy.array([-1.0, 1.0]), numpy.array([1.0, 0.0])
    >>> round(float(solid_angles("orthographic", *edges)[0, 0]), 12)
    3.14159265359
    """
    across, down = u[..., None, :], v[..., :, None]
    if projection == symbols.CYLINDRICAL:  # the height of a zone of the unit sphere
        return math.pi * numpy.diff(across) * -numpy.diff(down / numpy.hypot(1.0, down), axis=-2)
    if projection == symbols.EQUISOLID:
        return 4 * _corners(_area, across, down)
    if projection == symbols.ORTHOGRAPHIC:
        return _corners(_above, across, down)
    return _by_points(projection, across, down)[1]


def half_edges(projection: str, u: Any, v: Any) -> tuple[Any, Any]:
    """Return the vectors from the middles of rectangles of an image to their edges.

    Parameters
    ----------
    projection, u, v
        As in `light_vectors`.

    Returns
    -------
    along, down : ndarray of shape (3, ..., m, n) [rad]
        Vectors to the middle of the right and of the lower edge, from the directions of the four
        corners.  A corner outside the circle counts as the nearest place on it.

    Raises
    ------
    ConditionError
        If the projection is unknown.

    Examples
    --------
    >>> edges = numpy.linspace(-0.1, 0.1, 2), numpy.linspace(0.2, -0.2, 2)
    >>> along, down = half_edges("latlong", *edges)
    >>> along.ravel().round(3).tolist(), down.ravel().round(3).tolist()
    ([0.0, -0.294, 0.0], [0.0, 0.0, -0.309])
    """
    corners = shown_directions(projection, u[..., None, :], v[..., :, None])
    corner = numpy.stack(numpy.broadcast_arrays(*corners))
    left, right = corner[..., :-1], corner[..., 1:]
    along, step = right - left, left + right
    return (
        (along[..., :-1, :] + along[..., 1:, :]) / 4,
        (step[..., 1:, :] - step[..., :-1, :]) / 4,
    )


def shown_directions(projection: str, u: Any, v: Any) -> Vector:
    """Return the directions at places of an image; outside the circle, at the nearest place on it.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}
    u, v : ndarray [1]

    Returns
    -------
    x, y, z : ndarray [1]
        Unit vectors in the map's own axes.

    Raises
    ------
    ConditionError
        If the projection is unknown.

    Examples
    --------
    >>> u = v = numpy.array(1.0)
    >>> [round(float(x), 12) for x in shown_directions("angular", u, v)]
    [-1.0, -0.0, 0.0]
    """
    if projection in ROUND:
        beyond = numpy.maximum(numpy.hypot(u, v), 1.0)
        u, v = u / beyond, v / beyond
    return direction_at(projection, u, v)


def is_shown(projection: str, u: Any, v: Any) -> Any:
    """Return whether rectangles show any part of an image: whether they reach into the circle.

    Parameters
    ----------
    projection, u, v
        As in `light_vectors`.

    Returns
    -------
    ndarray of bool, of shape (..., m, n)

    Examples
    --------
    >>> edges = numpy.linspace(-1, 1, 8), numpy.linspace(1, -1, 8)
    >>> is_shown("angular", *edges)[0].tolist()
    [False, True, True, True, True, True, False]
    """
    near_u = numpy.clip(0.0, u[..., :-1], u[..., 1:])[..., None, :]
    near_v = numpy.clip(0.0, v[..., 1:], v[..., :-1])[..., :, None]
    if projection == symbols.CYLINDRICAL:
        return (abs(near_u) < 1) & (near_v == near_v)
    return (numpy.hypot(near_u, near_v) < 1) | (projection not in ROUND)


def _by_rows(u: Any, t: Any) -> Any:
    """Return the light vectors of rows between polar angles, as products, which keep digits."""
    half, middle = numpy.diff(t) / 2, (t[..., 1:] + t[..., :-1]) / 2
    sine = numpy.sin(2 * half) / 2
    level, upright = half - sine * numpy.cos(2 * middle), sine * numpy.sin(2 * middle)
    azimuth = -math.pi / 2 * (u[..., 1:] + u[..., :-1])
    width = math.pi * numpy.diff(u)
    chord = 2 * numpy.sin(width / 2)
    rows = numpy.stack([level, level, upright])
    columns = numpy.stack([chord * numpy.cos(azimuth), chord * numpy.sin(azimuth), width])
    return rows[..., :, None] * columns[..., None, :]


def _corners(function: Any, across: Any, down: Any) -> Any:
    """Return the integral over rectangles, by differences of an antiderivative at their corners."""
    values = function(across, down)
    values = values[..., :-1, :] - values[..., 1:, :]
    return values[..., 1:] - values[..., :-1]


def _cubed(u: Any, v: Any) -> Any:
    """Return the integral of n^3 over v from 0; that of n u over u is -n^3 / 3."""
    wide = numpy.maximum(1 - u * u, 0.0)
    reach = numpy.sqrt(wide)
    t = numpy.clip(v, -reach, reach)
    n = numpy.sqrt(numpy.maximum(wide - t * t, 0.0))
    return (t * n * (2 * n * n + 3 * wide) + 3 * wide * wide * numpy.arctan2(t, n)) / 8


def _forward(u: Any, v: Any) -> Any:
    """Return the integral of 2 n^2 - 1 over the part in the circle of the rectangle 0 to (u, v)."""
    v = numpy.clip(v, -1.0, 1.0)
    reach = numpy.sqrt(numpy.maximum(1 - u * u, 0.0))
    t = numpy.clip(v, -reach, reach)
    inside = u * t * (1 - 2 / 3 * (u * u + t * t))
    return inside + numpy.sign(u) * (_strip(v) - _strip(t))


def _strip(v: Any) -> Any:
    """Return that from u = 0 to the circle, over v from 0: of 4/3 c^3 - c, c = sqrt(1 - v^2)."""
    c = numpy.sqrt((1 - v) * (1 + v))
    return v * c * c * c / 3


def _normal(u: Any, v: Any) -> Any:
    """Return the integral of n over v from 0; that of u / n over u is -n."""
    wide = numpy.maximum(1 - u * u, 0.0)
    reach = numpy.sqrt(wide)
    t = numpy.clip(v, -reach, reach)
    n = numpy.sqrt(numpy.maximum(wide - t * t, 0.0))
    return (t * n + wide * numpy.arctan2(t, n)) / 2


def _area(u: Any, v: Any) -> Any:
    """Return the area of the part in the circle of the rectangle from 0 to (u, v)."""
    reach = numpy.sqrt(numpy.maximum(1 - u * u, 0.0))
    v = numpy.clip(v, -1.0, 1.0)
    t = numpy.clip(v, -reach, reach)
    zero = numpy.zeros(1)
    return u.clip(-1, 1) * t + numpy.sign(u) * (_normal(zero, v) - _normal(zero, t))


def _above(u: Any, v: Any) -> Any:
    """Return the integral of 1 / n over the part in the circle of the rectangle 0 to (u, v)."""
    u, v = numpy.clip(u, -1.0, 1.0), numpy.clip(v, -1.0, 1.0)
    reach = numpy.sqrt(1 - u * u)
    t = numpy.clip(v, -reach, reach)
    n = numpy.sqrt(numpy.maximum(1 - u * u - t * t, 0.0))
    inside = t * numpy.arctan2(u, n) + u * numpy.arctan2(t, n) - numpy.arctan2(u * t, n)
    return inside + numpy.sign(u) * math.pi / 2 * (v - t)


def _by_points(projection: str, across: Any, down: Any) -> tuple[Any, Any]:
    """Return light vectors and solid angles of rectangles, by four points of each."""
    x, wide = (across[..., 1:] + across[..., :-1]) / 2, numpy.diff(across) / 2
    y, high = (down[..., :-1, :] + down[..., 1:, :]) / 2, -numpy.diff(down, axis=-2) / 2
    points = gauss(2)[0]
    total: Any = 0.0
    solid_angle: Any = 0.0
    for a in points:
        for b in points:
            u, v = x + a * wide, y + b * high
            is_inside = projection not in ROUND or numpy.hypot(u, v) < 1
            weight = numpy.where(is_inside, density(projection, u, v), 0.0) * (wide * high)
            total = total + weight * numpy.stack(shown_directions(projection, u, v))
            solid_angle = solid_angle + weight
    return total, solid_angle


def _angular(across: Any, down: Any) -> Any:
    """Return the light vectors of an angular map."""
    total, solid_angle = _by_points(symbols.ANGULAR, across, down)
    x, wide = (across[..., 1:] + across[..., :-1]) / 2, numpy.diff(across) / 2
    y, high = (down[..., :-1, :] + down[..., 1:, :]) / 2, -numpy.diff(down, axis=-2) / 2
    is_out = numpy.hypot(abs(x) + wide, abs(y) + high) > 1
    cut = is_out & (numpy.hypot(abs(x) - wide, abs(y) - high) < 1)
    if cut.any():
        x, wide, y, high = (array[cut] for array in numpy.broadcast_arrays(x, wide, y, high))
        inside = solid_angles_in_circle("angular", x, wide, y, high)
        has_points = solid_angle[cut] > 0
        mean = total[:, cut] / numpy.where(has_points, solid_angle[cut], 1.0)
        mean[0, ~has_points] = -1.0  # if only a corner, without a point, is in the circle
        total[:, cut] = mean * inside
    return total
