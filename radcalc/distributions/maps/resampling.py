"""Maps in another projection, size or orientation, by the common areas of pixels."""

import math
from collections.abc import Iterator
from typing import Any

import numpy

from radcalc.distributions.maps.light_sums import Progress
from radcalc.distributions.maps.radiance_map import RadianceMap, check_shape
from radcalc.geometry.directions import FORWARD, Vector, components, facing, from_components
from radcalc.geometry.light_vectors import is_shown, shown_directions
from radcalc.geometry.projections import (
    corner_of_pixel,
    density,
    is_outside,
    middle_of_pixel,
    pixel_solid_angles,
    place_of,
)
from radcalc.quantities.symbols import LATLONG, WHOLE_SPHERE

FINER = 3.0  # parts of a pixel along the side of a new pixel
MOST = 256  # parts along a side, close to a pole
IN_ALL = 2048  # parts of a pixel
PARTS = 1 << 19  # parts at a time
NOTHING = 1e-12
MOSTLY = 0.95  # of a new pixel: areas are accurate to about 1 %


def reproject(
    around: RadianceMap,
    projection: str,
    width: int,
    height: int,
    aim: Vector = FORWARD,
    progress: Progress | None = None,
) -> Any:
    """Return the pixels of a map in another projection: means of the radiance by solid angle.

    Parameters
    ----------
    around : RadianceMap
        It is dark where it has no pixels.
    projection : {"latlong", "mirror-ball", "angular"}
    width, height : int
        Size of the new image [pixels].
    aim : tuple of 3 floats, optional
        World direction of the centre of the new image.
    progress : callable, optional
        Called with the work done so far and the total.

    Returns
    -------
    ndarray of shape (height, width, channels) [cd/m2, W/m2/sr, photon/s/m2/sr or 1]
        0 outside the circle of a mirror ball or an angular map.

    Raises
    ------
    ConditionError
        If the size does not fit the projection, or the aim is 0.

    Notes
    -----
    Each pixel is divided into parts, at least three along the side of a new pixel.  The solid
    angle of a part goes to the new pixels that it covers, at most four, by area, as if the part
    were an upright rectangle.  These areas are accurate to about 1 %.  A constant map must not
    change, nor the light of a single bright pixel if the new pixels are not smaller; so a new
    pixel is::

        least + (light - least * covered) / size

    with the least radiance that it received, the light and the solid angle received, and its own
    solid angle.  It is limited to the greatest radiance received; this may take some 1e-3 of the
    light of a single pixel that becomes many.

    Examples
    --------
    >>> sky = RadianceMap(numpy.repeat([3000.0, 0.0], 32)[:, None] + numpy.zeros(128), "latlong")
    >>> ball = reproject(sky, "mirror-ball", 64, 64)
    >>> round(RadianceMap(ball[..., 0], "mirror-ball").irradiance((0.0, 0.0, 1.0)).value, 1)
    9424.8
    """
    target = _Target(projection, width, height, aim, around.pixels.shape[2])
    rows = around.size[1]
    done = 0
    for edges, sizes, values in _bands(around):
        _deposit(around, target, edges, sizes, values)
        done += len(values)
        if progress:
            progress(done, rows)
    return target.finished(around)


class _Target:
    """The new image, and the light received by its pixels."""

    def __init__(
        self, projection: str, width: int, height: int, aim: Vector, channels: int
    ) -> None:
        check_shape(projection, width, height)
        self.projection, self.width, self.height = projection, width, height
        self.axes = facing(aim)
        edges = corner_of_pixel(width, height, numpy.arange(width + 1), numpy.arange(height + 1))
        self.is_shown = numpy.broadcast_to(is_shown(projection, *edges), (height, width)).ravel()
        self.light = numpy.zeros((channels, height * width))
        self.least, self.most = numpy.full_like(self.light, math.inf), numpy.zeros_like(self.light)
        self.size = numpy.zeros(height * width)

    def places(self, around: RadianceMap, u: Any, v: Any) -> tuple[Any, Any]:
        """Return points of the old image in pixels of the new image, from the top left."""
        world = around.world(shown_directions(around.projection, u, v))
        u, v = place_of(self.projection, *components(self.axes, world))
        return (u + 1) / 2 * self.width, (1 - v) / 2 * self.height

    def step(self, x: Any, axis: int) -> Any:
        """Return the larger of the distances along both edges of pixels, from their corners."""
        steps = numpy.diff(x, axis=axis)
        if self.projection == LATLONG:  # the distance across the seam is 0
            steps = steps - self.width * numpy.round(steps / self.width)
        steps = abs(steps)
        return numpy.maximum(*(numpy.delete(steps, k, 1 - axis) for k in (0, -1)))

    def add(self, x: Any, y: Any, wide: Any, high: Any, size: Any, values: Any) -> None:
        """Distribute solid angles over the pixels that upright rectangles cover: 2 each way."""
        middle = self._cell(numpy.floor(x), numpy.floor(y))
        across, down = numpy.floor(x - wide), numpy.floor(y - high)
        right = numpy.clip((x + wide - across - 1) / (2 * wide), 0, 1)
        below = numpy.clip((y + high - down - 1) / (2 * high), 0, 1)
        for column, row, share in [
            (across, down, (1 - right) * (1 - below)),
            (across + 1, down, right * (1 - below)),
            (across, down + 1, (1 - right) * below),
            (across + 1, down + 1, right * below),
        ]:
            here = numpy.flatnonzero(share > NOTHING)
            cell = self._cell(column[here], row[here])
            cell = numpy.where(self.is_shown[cell], cell, middle[here])  # stay inside the circle
            weight = share[here] * size[here]
            numpy.add.at(self.size, cell, weight)
            for k, value in enumerate(values[here].T):
                numpy.add.at(self.light[k], cell, weight * value)
                numpy.minimum.at(self.least[k], cell, value)
                numpy.maximum.at(self.most[k], cell, value)

    def _cell(self, column: Any, row: Any) -> Any:
        if self.projection == LATLONG:
            column = column % self.width
        column = numpy.clip(column, 0, self.width - 1).astype(numpy.intp)
        return numpy.clip(row, 0, self.height - 1).astype(numpy.intp) * self.width + column

    def finished(self, around: RadianceMap) -> Any:
        """Return the means; a pixel too small to receive light has the radiance at its centre."""
        sizes = pixel_solid_angles(self.projection, self.width, self.height)
        sizes = numpy.broadcast_to(sizes, (self.height, self.width)).ravel()
        is_lit = self.is_shown & (self.size > 0) & (sizes > 0)
        means = numpy.zeros_like(self.light)
        least = self.least[:, is_lit]
        if around.coverage < 1:  # a pixel at the edge of the old image is partly dark
            least = least * (self.size[is_lit] > MOSTLY * sizes[is_lit])
        more = (self.light[:, is_lit] - least * self.size[is_lit]) / sizes[is_lit]
        means[:, is_lit] = numpy.clip(least + more, least, self.most[:, is_lit])
        row, column = numpy.divmod(numpy.flatnonzero(self.is_shown & ~is_lit), self.width)
        if len(row):
            u, v = middle_of_pixel(self.width, self.height, column, row)
            in_image = shown_directions(self.projection, u, v)
            world = from_components(self.axes, in_image)
            values = around.toward(around.in_map_axes(world)) * around.factor
            means[:, row * self.width + column] = values.T
        return numpy.moveaxis(means.reshape(-1, self.height, self.width), 0, -1)


def _bands(around: RadianceMap) -> Iterator[tuple[Any, Any, Any]]:
    """Yield edges, solid angles and radiances of rows of the whole image, dark without pixels.

    Edges are u and v of (columns + 1) and (rows + 1).
    """
    if around.projection not in WHOLE_SPHERE:
        for first, last in map(around.raster.rows, range(around.raster.down)):
            edges = around.raster.row_edges(first, last)
            yield edges, around.solid_angles(first, last), around.channels(first, last)
        return
    (width, height), (left, top, columns, rows) = around.size, around.part
    parts = [around.raster.rows(down) for down in range(around.raster.down)]
    bands = [(top + first, top + last, True) for first, last in parts]
    bands += [(row, row + 1, False) for row in range(height) if not top <= row < top + rows]
    for first, last, is_in_map in bands:
        row = numpy.arange(first, last + 1)
        edges = corner_of_pixel(width, height, numpy.arange(width + 1), row)
        values = numpy.zeros((last - first, width, around.pixels.shape[2]))
        if is_in_map:
            values[:, left : left + columns] = around.channels(first - top, last - top)
        sizes = pixel_solid_angles(around.projection, width, height, slice(first, last))
        yield edges, numpy.broadcast_to(sizes, values.shape[:2]), values


def _deposit(around: RadianceMap, target: _Target, edges: Any, sizes: Any, values: Any) -> None:
    u, v = edges
    corners = target.places(around, *numpy.broadcast_arrays(u, v[:, None]))
    # extent of a pixel in the new image along u, and along v: (2, rows, columns)
    along, down = ([target.step(coordinate, axis) for coordinate in corners] for axis in (1, 0))
    columns, rows = (
        numpy.clip(numpy.ceil(FINER * numpy.hypot(*reach)), 1, MOST).astype(int)
        for reach in (along, down)
    )
    # close to a rim both are large, since all azimuths meet there
    less = numpy.minimum(1.0, numpy.sqrt(IN_ALL / (columns * rows)))
    columns, rows = (numpy.maximum(1, count * less).astype(int) for count in (columns, rows))
    wide, high = (
        numpy.clip(numpy.hypot(a / columns, b / rows) / 2, 1e-9, 0.5)
        for a, b in zip(along, down, strict=True)
    )
    ends = numpy.cumsum(columns * rows)
    # pixels outside the circle have only a rounding error as solid angle, and no radiance
    is_used = sizes.ravel() > NOTHING / sizes.size
    for chosen in numpy.split(
        numpy.arange(sizes.size), numpy.flatnonzero(numpy.diff(ends // PARTS)) + 1
    ):
        chosen = chosen[is_used[chosen]]
        if not len(chosen):
            continue
        i, j = numpy.unravel_index(chosen, sizes.shape)
        counts = columns[i, j] * rows[i, j]
        starts = numpy.cumsum(counts) - counts
        of = numpy.repeat(numpy.arange(len(chosen)), counts)
        down_, across = numpy.divmod(numpy.arange(len(of)) - starts[of], columns[i, j][of])
        part_u = u[j][of] + (u[j + 1] - u[j])[of] * (across + 0.5) / columns[i, j][of]
        part_v = v[i][of] + (v[i + 1] - v[i])[of] * (down_ + 0.5) / rows[i, j][of]
        weight = numpy.maximum(_within(around.projection, part_u, part_v), NOTHING)
        share = weight / numpy.add.reduceat(weight, starts)[of]
        x, y = target.places(around, part_u, part_v)
        target.add(x, y, wide[i, j][of], high[i, j][of], share * sizes[i, j][of], values[i, j][of])


def _within(projection: str, u: Any, v: Any) -> Any:
    """Return the solid angle per area of an image; 0 outside the circle."""
    return numpy.where(is_outside(projection, u, v), 0.0, density(projection, u, v))
