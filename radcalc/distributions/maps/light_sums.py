"""Irradiances of a map: sums of light vectors over blocks of its pixels.

The light vector V of a pixel is its radiance times the integral of direction over its solid angle;
a receiver with the normal n gets n . V from it.  The sum of V over a block serves every receiver
whose horizon does not cut the block.  Blocks cut by a horizon are summed pixel by pixel; from a
pixel cut by the horizon, the part above it counts:

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

from radcalc.geometry.light_vectors import half_edges, light_vectors, shown_directions
from radcalc.geometry.projections import View, corner_of_pixel

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
        u, v = self.view.places(*corner_of_pixel(width, height, column, row))
        return u, v[None]

    def row_edges(self, first: int, last: int) -> tuple[Any, Any]:
        """Return the pixel edges of a range of rows, as u and v."""
        left, top, columns, _ = self.part
        column = numpy.arange(left, left + columns + 1)
        row = numpy.arange(top + first, top + last + 1)
        return self.view.places(*corner_of_pixel(*self.size, column, row))

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
