"""Irradiances of a map: sums of light vectors over blocks of its pixels.

A part of radiance L wholly above the horizon of a receiver with the normal n gives it the
irradiance L n . V, where V is the part's light vector, the integral of the unit direction over its
solid angle.  An image is cut into rectangles by edges of rising u (to the right) and falling v
(downwards); `radcalc.geometry.projections` defines the coordinates.

The sum of V over a block serves every receiver whose horizon does not cut the block.  Blocks cut by
a horizon are summed pixel by pixel; from a pixel cut by the horizon, the part above it counts:

    integral of max(0, x) over a cosine x that is spread evenly about its mean m, within +-a
    = max(0, m) + max(0, a - |m|)^2 / (4 a),  a = sqrt((n . p)^2 + (n . q)^2)

where p and q point from the pixel's centre to two of its edges, so that the cosine has its variance
over the pixel.  The reported error is the second term with a = |n . p| + |n . q|, which reaches the
corners.  Pixels that extend farther than `WIDE` are split.  A constant map of 1024 x 512 pixels
then gives pi L to about 1e-8 in any direction, a map of 64 x 32 to 1e-6.
"""

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy

from radcalc.geometry import projections
from radcalc.geometry.numerics import gauss
from radcalc.geometry.projections import Vector, View
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
    if projection in projections.ROUND:
        beyond = numpy.maximum(numpy.hypot(u, v), 1.0)
        u, v = u / beyond, v / beyond
    return projections.direction_at(projection, u, v)


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
    return (numpy.hypot(near_u, near_v) < 1) | (projection not in projections.ROUND)


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
            is_inside = projection not in projections.ROUND or numpy.hypot(u, v) < 1
            weight = numpy.where(is_inside, projections.density(projection, u, v), 0.0) * (
                wide * high
            )
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
        inside = projections.solid_angles_in_circle("angular", x, wide, y, high)
        has_points = solid_angle[cut] > 0
        mean = total[:, cut] / numpy.where(has_points, solid_angle[cut], 1.0)
        mean[0, ~has_points] = -1.0  # if only a corner, without a point, is in the circle
        total[:, cut] = mean * inside
    return total


SIDE = 16  # pixels along the side of a block
FEWEST = 64  # blocks across an image, if it has as many pixels
ACROSS = 3  # sample points along each side, for the extent of a block
MARGIN = 1.1  # factor of that extent, for bulges between the sample points
WIDE = 0.02  # [rad] from the middle of a pixel to its edges
CHUNK = 1 << 17  # numbers at a time (pixels times normals), which fit into a cache
TINY = 1e-290

Progress = Callable[[int, int], object]  # called with the work done and the total
Rows = Callable[[int, int], Any]  # the values in rows: (rows, columns, channels)
Pixels = tuple[Any, Any, Any, Any]  # light vectors at radiance 1, both half edges, radiances


class Raster:
    """An image, or a rectangle of it, divided into blocks of pixels.

    `part` is left, top, width and height of the rectangle [pixels], and `view` what the whole image
    shows.
    """

    def __init__(
        self,
        projection: str,
        size: tuple[int, int],
        part: tuple[int, int, int, int],
        view: View | None = None,
    ) -> None:
        self.projection, self.size, self.part = projection, size, part
        self.view = view or View()
        self.side = max(1, min(SIDE, size[0] // FEWEST))
        self.across, self.down = (-(-count // self.side) for count in part[2:])

    def edges(self, down: int) -> tuple[Any, Any]:
        """Return the pixel edges of a row of blocks, as u and v: a row of edges for each block.

        The last blocks may extend beyond the rectangle; their pixels have no size there.
        """
        (width, height), (left, top, columns, rows) = self.size, self.part
        steps = numpy.arange(self.side + 1)
        column = left + numpy.minimum(
            numpy.arange(self.across)[:, None] * self.side + steps, columns
        )
        row = top + numpy.minimum(down * self.side + steps, rows)
        u, v = self.view.places(*projections.corner_of_pixel(width, height, column, row))
        return u, v[None]

    def row_edges(self, first: int, last: int) -> tuple[Any, Any]:
        """Return the pixel edges of a range of rows, as u and v."""
        left, top, columns, _ = self.part
        column = numpy.arange(left, left + columns + 1)
        row = numpy.arange(top + first, top + last + 1)
        return self.view.places(*projections.corner_of_pixel(*self.size, column, row))

    def rows(self, down: int) -> tuple[int, int]:
        """Return the first row of a row of blocks, and the row after its last."""
        return down * self.side, min((down + 1) * self.side, self.part[3])

    def blocks(self, values: Any) -> Any:
        """Arrange (rows, columns, ...) as (blocks, side, side, ...)."""
        rows, columns, *channels = values.shape
        room = numpy.zeros((self.side, self.across * self.side, *channels), values.dtype)
        room[:rows, :columns] = values
        return room.reshape(self.side, self.across, self.side, *channels).swapaxes(0, 1)

    def cones(self, u: Any, v: Any) -> tuple[Any, Any]:
        """Return the axes of cones about blocks, (blocks, 3), and the sines of their half angles.

        The sine is 2 if the half angle exceeds a right angle.
        """
        steps = numpy.linspace(0, 1, ACROSS)
        wide, high = (edges[:, :1] + (edges[:, -1:] - edges[:, :1]) * steps for edges in (u, v))
        # also the point nearest to the centre: a circle may cut off only the middle of an edge
        wide, high = (
            numpy.concatenate([edges, numpy.clip(0.0, edges.min(1), edges.max(1))[:, None]], 1)
            for edges in (wide, high)
        )
        directions = shown_directions(self.projection, wide[:, None, :], high[:, :, None])
        places = numpy.stack(numpy.broadcast_arrays(*directions), -1).reshape(len(u), -1, 3)
        axes = places.mean(1)
        axes /= numpy.maximum(numpy.linalg.norm(axes, axis=-1, keepdims=True), 1e-9)
        chords = numpy.linalg.norm(places - axes[:, None], axis=-1).max(-1)
        angles = MARGIN * 2 * numpy.arcsin(numpy.minimum(chords / 2, 1.0))
        return axes, numpy.where(angles < math.pi / 2, numpy.sin(angles), 2.0)


class LightSums:
    """Light vectors of the blocks of a raster, for irradiances.

    `rows` returns the radiances of a range of rows, (rows, columns, channels); `seen` is called
    once with each range and its radiances, during construction.
    """

    def __init__(
        self, raster: Raster, rows: Rows, seen: Callable[[int, int, Any], None] | None = None
    ) -> None:
        self.raster, self._rows = raster, rows
        sums_and_cones = []
        for down in range(raster.down):
            u, v = raster.edges(down)
            first, last = raster.rows(down)
            radiances = rows(first, last)
            if seen:
                seen(first, last, radiances)
            values = raster.blocks(radiances)
            vectors = light_vectors(raster.projection, u, v)
            sums_and_cones.append(
                (numpy.einsum("xbij,bijc->bcx", vectors, values), *raster.cones(u, v))
            )
        # (rows of blocks, blocks, channels, 3), (rows of blocks, blocks, 3), (..., blocks)
        self._vectors, self._axes, self._sines = map(numpy.stack, zip(*sums_and_cones, strict=True))

    def irradiances(
        self, normals: Any, progress: Progress | None = None, has_errors: bool = False
    ) -> tuple[Any, Any]:
        """Return the irradiances of receivers, and their possible errors: (n, channels) each.

        Parameters
        ----------
        normals : ndarray of shape (n, 3)
            Unit vectors in the map's own axes.
        progress : callable, optional
            Called with the number of completed rows of blocks and the total.
        has_errors : bool, optional
            Else the errors are 0.
        """
        channels = self._vectors.shape[2]
        total, errors = numpy.zeros((2, len(normals), channels))
        for down in range(self.raster.down):
            towards = normals @ self._axes[down].T
            is_whole = abs(towards) >= self._sines[down]
            above = (is_whole & (towards > 0)).astype(float)
            vector_sums = above @ self._vectors[down].reshape(len(above.T), -1)
            total += numpy.einsum("ncx,nx->nc", vector_sums.reshape(-1, channels, 3), normals)
            chosen = numpy.flatnonzero(~is_whole.all(0))
            if len(chosen):
                for block, (pixels, split) in zip(chosen, self._pixels(down, chosen), strict=True):
                    cut = numpy.flatnonzero(~is_whole[:, block])
                    for part in numpy.array_split(cut, 1 + cut.size * len(split[-1]) // CHUNK):
                        total[part] += _received(normals[part], *split)
                        if has_errors:
                            errors[part] += _error(normals[part], *pixels)
            if progress:
                progress(down + 1, self.raster.down)
        return total, errors

    def _pixels(self, down: int, chosen: Any) -> Iterator[tuple[Pixels, Pixels]]:
        """Yield the pixels of each block, and the same with wide pixels split."""
        raster = self.raster
        u, v = raster.edges(down)
        u = u[chosen]
        values = raster.blocks(self._rows(*raster.rows(down)))[chosen]
        shape = _shape(raster.projection, u, v)
        reach = numpy.sqrt((shape[1:] ** 2).sum((0, 1)))
        parts = math.ceil(reach.max() / WIDE)
        steps = numpy.linspace(0, 1, parts + 1)
        is_wide = reach > WIDE
        block, i, j = numpy.nonzero(is_wide)
        finer = _shape(
            raster.projection,
            u[block, j, None] + (u[block, j + 1] - u[block, j])[:, None] * steps,
            v[0, i, None] + (v[0, i + 1] - v[0, i])[:, None] * steps,
        )
        first = numpy.searchsorted(block, numpy.arange(len(chosen) + 1))
        for k, wide in enumerate(is_wide):
            pixels = split = (*shape[:, :, k].reshape(3, 3, -1), values[k].reshape(wide.size, -1))
            if wide.any():
                own = finer[:, :, first[k] : first[k + 1]].reshape(3, 3, -1)
                light = values[k, wide].repeat(parts * parts, 0)
                split = (
                    *numpy.concatenate([shape[:, :, k, ~wide], own], -1),
                    numpy.concatenate([values[k, ~wide], light]),
                )
            yield pixels, split


def _shape(projection: str, u: Any, v: Any) -> Any:
    """Return light vectors and half edges, (3, 3, ...)."""
    return numpy.stack([light_vectors(projection, u, v), *half_edges(projection, u, v)])


def _received(normals: Any, vectors: Any, along: Any, down: Any, light: Any) -> Any:
    mean = normals @ vectors
    sizes = _size(vectors)
    longest = sizes * numpy.sqrt((along * along + down * down).sum(0))  # of any normal's reach
    normal, pixel = numpy.nonzero(abs(mean) < longest)  # a few that the horizon may cut
    near, cosine = normals[normal], mean[normal, pixel]
    numpy.maximum(mean, 0.0, out=mean)
    reach = numpy.hypot(
        numpy.einsum("nx,xn->n", near, along[:, pixel]),
        numpy.einsum("nx,xn->n", near, down[:, pixel]),
    )
    mean[normal, pixel] += _beyond(cosine, reach * sizes[pixel])
    return mean @ light


def _error(normals: Any, vectors: Any, along: Any, down: Any, light: Any) -> Any:
    """Return the possible error: corners extend beyond a cosine that is spread evenly."""
    reach = (abs(normals @ along) + abs(normals @ down)) * _size(vectors)
    return _beyond(normals @ vectors, reach) @ light


def _size(vectors: Any) -> Any:
    return numpy.sqrt((vectors * vectors).sum(0))


def _beyond(mean: Any, reach: Any) -> Any:
    """Return the positive part of the cosine, in excess of the positive part of its mean."""
    over = numpy.maximum(reach - abs(mean), 0.0)
    return over * over / (4 * numpy.maximum(reach, TINY))  # 0 for a pixel without size
