"""Radiances of pictures of the surroundings, as functions of direction.

This module has the maps of radiances: an image of everything around a place.  Pixels are 32-bit
floats in NumPy arrays of (height, width, channels); row 0 is the top of the picture.  They are
proportional to radiance, and not encoded for display.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy

from radcalc.distributions.distribution import Peak
from radcalc.distributions.maps import light_sums
from radcalc.distributions.maps.light_sums import LightSums, Progress, Raster
from radcalc.errors import ConditionError
from radcalc.geometry import projections
from radcalc.geometry.numerics.cubature import ROUNDING, Integral
from radcalc.geometry.projections import View
from radcalc.maths import Number, frozen
from radcalc.quantities.symbols import LATLONG, PROJECTIONS, WHOLE_SPHERE
from radcalc.units.ranges import refuse_masked

STRIP = 1 << 22  # numbers to read at a time, if the pixels are not in memory
GROUP = 1 << 18  # pixels for which solid angles are computed at a time
LEAST = 4  # rows: with fewer, even the sign of a direction is uncertain
CUBES = ((3, 4), (4, 3), (6, 1), (1, 6))  # layouts of cube maps: faces across and down
INSIDE = 1 - 1e-12
SEEN = 300


class RadianceMap:
    """Radiances given by an image in a projection; all pixels are read once when it is made.

    Parameters
    ----------
    pixels : array of shape (height, width) or (height, width, channels)
        0 or more, row 0 at the top.  NumPy arrays, also memory-mapped ones, and Dask arrays,
        of which a strip of rows is computed at a time.
    projection : str
        As in `radcalc.geometry.projections`; latlong maps are 2:1, mirror balls and angular maps
        square.
    aim : tuple of 3 floats, optional
        World direction of the image centre; +x by default.  The top of the image is as close to
        world up as possible; see `facing`.
    weights : sequence of floats, one a channel, optional
        Weights of the channels in the scalar radiance, such as the luminance of R, G and B.
    factor : float, optional
        Factor that converts the values to coherent SI (cd/m2, W/m2/sr, photon/s/m2/sr).
    kind : {"v", "e", "p", ""}, optional
        Kind of light; empty for relative values.
    frame : tuple of 4 ints, optional
        Left, top, full width and full height, if the pixels are a part of a larger image.
    view : View, optional
        What the whole image shows, in a projection of a part of the sphere.
    up : tuple of 3 floats, optional
        World direction of the top of the image, instead of world up.
    grain : float, optional
        Largest error of each channel, as a share of the brightest channel of its pixel.

    Attributes
    ----------
    coverage : float [1]
        Share of the sphere that the pixels show.
    solid_angle : float [sr]
        The same as a solid angle.

    Raises
    ------
    ConditionError
        If the shape does not fit the projection, or a pixel is negative, infinite or NaN; pixels
        outside the circle of a mirror ball or an angular map may have any value.
    NumberError
        If a pixel is masked.

    Notes
    -----
    A pixel has the same radiance in all its directions.  The irradiance is the sum over pixels of
    their radiance times the integral of cos(theta) over their solid angle (see `light_sums`).  Its
    reported error is the light of pixels cut by the receiver's horizon that may come from the
    other side of it, and the grain.  It does not include the loss of detail when the image was
    made.

    Examples
    --------
    A radiance of 3000 cd/m2 in all directions:

    >>> around = RadianceMap(numpy.full((512, 1024), 3000.0), "latlong", kind="v")
    >>> round(around.irradiance((1.0, 2.0, 3.0)).value, 2), around.coverage
    (9424.78, 1.0)
    """

    def __init__(
        self,
        pixels: Any,
        projection: str,
        aim: projections.Vector = projections.FORWARD,
        weights: Sequence[float] | None = None,
        factor: float = 1.0,
        kind: str = "",
        frame: tuple[int, int, int, int] | None = None,
        view: View | None = None,
        up: projections.Vector | None = None,
        grain: float = 0.0,
    ) -> None:
        if not (hasattr(pixels, "shape") and hasattr(pixels, "dtype")):
            pixels = numpy.asarray(pixels)
        if len(pixels.shape) not in (2, 3) or 0 in pixels.shape or pixels.dtype.kind not in "fiu":
            raise ConditionError(
                f"pixels of the shape {pixels.shape} and the type {pixels.dtype} are not a map",
                "real numbers of the shape (height, width) or (height, width, channels)",
            )
        self.pixels = frozen(pixels if len(pixels.shape) == 3 else pixels[:, :, None])
        rows, columns, channels = self.pixels.shape
        if len(weights or (1.0,)) != channels:
            problem = f"pixels of {channels} channels have {len(weights or (1.0,))} weights"
            raise ConditionError(problem, "a weight for each channel")
        left, top, width, height = frame or (0, 0, columns, rows)
        check_shape(projection, width, height)
        if min(left, top) < 0 or left + columns > width or top + rows > height:
            raise ConditionError(
                f"{columns} x {rows} pixels from {left},{top} do not fit in an image of "
                f"{width} x {height}",
                "a part that lies within it",
            )
        self.projection, self.kind, self.is_axial = projection, kind, False
        self.size, self.part = (width, height), (left, top, columns, rows)
        self.axes = projections.upright(aim, up) if up else projections.facing(aim)
        self._weights = factor * numpy.array(weights or (1.0,), float)
        self.factor, self.grain = factor, grain
        self.raster = Raster(projection, self.size, self.part, view)
        self._strip = _rows_of_a_strip(self.pixels, self.raster.side)
        self._read = self._angles = (-1, numpy.empty(0))  # last strip read, last angles computed
        self.solid_angle = self._flux = 0.0
        self._peak = (-1.0, 0, 0)  # value, column and row in the whole image
        self._sums = LightSums(self.raster, self.luminances, self._survey)
        is_whole = (columns, rows) == self.size and projection in WHOLE_SPHERE
        self.coverage = 1.0 if is_whole else self.solid_angle / (4 * math.pi)

    def channels(self, first: int, last: int) -> Any:
        """Return radiances of the channels, in coherent SI, for a range of rows of one strip."""
        return numpy.multiply(self._inside(first, last), self.factor, dtype=float)

    def luminances(self, first: int, last: int) -> Any:
        """Return weighted sums of the channels, and with a grain their largest errors."""
        channels = numpy.moveaxis(self._inside(first, last), -1, 0)
        with numpy.errstate(invalid="ignore"):  # NaN and infinity are refused later
            # faster than a matrix product for a few channels
            parts = (
                weight * channel for weight, channel in zip(self._weights, channels, strict=True)
            )
            sums = numpy.asarray(sum(parts))
            if not self.grain:
                return sums[..., None]
            return numpy.stack([sums, self.grain * self._weights.sum() * channels.max(0)], -1)

    def _inside(self, first: int, last: int) -> Any:
        """Return the pixels times their shares inside the circle."""
        number, start = divmod(first, self._strip)
        pixels = self._rows(number)[start : start + last - first]
        if self.projection == LATLONG:
            return pixels
        u, v = self.raster.row_edges(first, last)
        inside = numpy.where(light_sums.is_shown(self.projection, u, v)[..., None], pixels, 0)
        if self.raster.view.circle == math.inf:
            return inside
        share = self._share(u, v)[..., None]
        return numpy.where(share > 0, inside, 0) * share

    def _share(self, u: Any, v: Any) -> Any:
        """Return the shares of pixels inside the circle of the view, by the distance from it."""
        u, v = (u[1:] + u[:-1]) / 2, (v[1:] + v[:-1])[:, None] / 2
        pixel = 2 * self.raster.view.right / self.size[0]
        return ((self.raster.view.circle - numpy.hypot(u, v)) / pixel + 0.5).clip(0, 1)

    def _rows(self, strip: int) -> Any:
        if strip != self._read[0]:
            rows = self.pixels[strip * self._strip : (strip + 1) * self._strip]
            if hasattr(rows, "compute"):  # a Dask array, which would lose its mask otherwise
                rows = rows.compute()
            refuse_masked(rows, "the map")
            self._read = (strip, numpy.asarray(rows))
        return self._read[1]

    def solid_angles(self, first: int, last: int) -> Any:
        """Return the solid angles [sr] of the pixels in a range of rows."""
        if self.projection not in WHOLE_SPHERE:
            return light_sums.solid_angles(self.projection, *self.raster.row_edges(first, last))
        # many rows are computed at a time, and cached
        (left, top, columns, rows), side = self.part, self.raster.side
        many = -(-GROUP // (self.size[0] * side)) * side
        group, start = divmod(first, many)
        if group != self._angles[0]:
            part = slice(top + group * many, top + min((group + 1) * many, rows))
            sizes = projections.pixel_solid_angles(self.projection, *self.size, part)
            full_rows = numpy.broadcast_to(sizes, (len(sizes), self.size[0]))
            self._angles = (group, full_rows[:, left : left + columns])
        return self._angles[1][start : start + last - first]

    def _survey(self, first: int, last: int, values: Any) -> None:
        """Check the pixels of rows; update the flux, the solid angle and the peak."""
        left, top, *_ = self.part
        pixels = self._inside(first, last)
        # with NaN among them, both are NaN
        if not (pixels.min() >= 0 and pixels.max() < math.inf):
            row, column, channel = numpy.argwhere(~((pixels >= 0) & (pixels < math.inf)))[0]
            raise ConditionError(
                f"the pixel in column {left + column} of row {top + first + row}, from 0 at the "
                f"top left, is {pixels[row, column, channel]:g}",
                "a map of radiances, which are 0 or more",
            )
        sizes = self.solid_angles(first, last)
        # numpy.vdot is slower on a busy machine, as its threads wait for each other
        self._flux += float((values[..., 0] * sizes).sum())
        if self.raster.view.circle < math.inf:
            sizes = sizes * self._share(*self.raster.row_edges(first, last))
        self.solid_angle += float(sizes.sum())
        row, column = numpy.unravel_index(numpy.argmax(values[..., 0]), values.shape[:2])
        highest = float(values[row, column, 0])
        if highest > self._peak[0]:
            self._peak = (highest, left + int(column), top + first + int(row))

    def radiance(self, polar: Number, azimuth: Number) -> Number:
        polar, azimuth = numpy.broadcast_arrays(polar, azimuth)
        direction = self.in_map_axes(projections.cartesian(polar.ravel(), azimuth.ravel()))
        return (self.toward(direction) @ self._weights).reshape(polar.shape)[()]

    def toward(self, direction: projections.Vector) -> Any:
        """Return the values of each channel, without the factor, in directions in map axes."""
        column, row = self._pixel_of(direction)
        values = numpy.zeros((len(column), self.pixels.shape[2]))
        is_there = column >= 0
        for strip in numpy.unique(row[is_there] // self._strip):
            here = is_there & (row // self._strip == strip)
            values[here] = self._rows(strip)[row[here] % self._strip, column[here]]
        return values

    def irradiance(self, normal: projections.Vector) -> Integral:
        in_map = numpy.array([self.in_map_axes(_unit(normal))])
        values, errors = self._sums.irradiances(in_map, has_errors=True)
        value, error = float(values[0, 0]), float(errors[0, 0])
        error += float(values[0, 1:].sum())
        return Integral(value, error + ROUNDING * value, self.part[2] * self.part[3])

    def irradiances(
        self, normals: Any, is_each: bool = False, progress: Progress | None = None
    ) -> Any:
        """Return the irradiances of many receivers [lx, W/m2, photon/s/m2 or sr].

        Parameters
        ----------
        normals : array_like of shape (..., 3)
            Normals of the receivers, of any length but 0.
        is_each : bool, optional
            Whether to return each channel, in a last axis, instead of the weighted sum.
        progress : callable, optional
            Called with the work done so far and the total.

        Examples
        --------
        >>> above = RadianceMap(numpy.repeat([1.0, 0.0], 32)[:, None] + numpy.zeros(128), "latlong")
        >>> above.irradiances([(0, 0, 1), (1, 0, 0), (0, 0, -1)]).round(6).tolist()
        [3.141593, 1.570796, 0.0]
        """
        x, y, z = self.in_map_axes(_unit(projections.vector(numpy.asarray(normals, float))))
        in_map = numpy.stack([numpy.ravel(component) for component in (x, y, z)], -1)
        if not is_each:
            values, _ = self._sums.irradiances(in_map, progress)
            return values[:, 0].reshape(numpy.shape(x))[()]
        sums = LightSums(self.raster, self.channels)
        values, _ = sums.irradiances(in_map, progress)
        return values.reshape(*numpy.shape(x), -1)

    def seen(self, normal: projections.Vector) -> float:
        """Return the share of a receiver's hemisphere, weighted by the cosine, that the map shows.

        It is the share of `SEEN` squared directions that all have the same weight.
        """
        share = (numpy.arange(SEEN) + 0.5) / SEEN
        across, azimuth = numpy.sqrt(share)[:, None], 2 * math.pi * share
        cosine = numpy.broadcast_to(numpy.sqrt(1 - share)[:, None], (SEEN, SEEN))
        about = numpy.stack([cosine, across * numpy.cos(azimuth), across * numpy.sin(azimuth)])
        world = projections.from_components(
            projections.facing(normal), projections.vector(about.reshape(3, -1).T)
        )
        return float((self._pixel_of(self.in_map_axes(world))[0] >= 0).mean())

    def mean(self) -> float:
        return self._flux / self.solid_angle

    def peak(self) -> Peak:
        """Return the first pixel with the greatest radiance, and the direction of its centre."""
        value, column, row = self._peak
        u, v = self.raster.view.places(*projections.middle_of_pixel(*self.size, column, row))
        polar, azimuth, _ = projections.spherical(
            *self.world(light_sums.shown_directions(self.projection, u, v))
        )
        return Peak(value, float(polar), float(azimuth))

    def in_map_axes(self, direction: projections.Vector) -> projections.Vector:
        return projections.components(self.axes, direction)

    def world(self, direction: projections.Vector) -> projections.Vector:
        return projections.from_components(self.axes, direction)

    def _pixel_of(self, direction: projections.Vector) -> tuple[Any, Any]:
        """Return column and row of the pixels that show directions; -1 if none does."""
        (left, top, columns, rows), (width, height) = self.part, self.size
        u, v = projections.place_of(self.projection, *direction)
        is_seen = numpy.hypot(u, v) <= self.raster.view.circle
        u, v = self.raster.view.in_image(u, v)
        # a point on the edge belongs to the pixel inside it
        column, row = (1 + INSIDE * u) / 2 * width - left, (1 - INSIDE * v) / 2 * height - top
        is_there = (column >= 0) & (column < columns) & (row >= 0) & (row < rows) & is_seen
        column, row = (numpy.where(is_there, place, -1).astype(int) for place in (column, row))
        return column, row


def check_shape(projection: str, width: int, height: int) -> None:
    """Raise a ConditionError if the size [pixels] of an image does not fit a projection."""
    if projection not in PROJECTIONS:
        raise ConditionError(f"unknown projection '{projection}'", ", ".join(PROJECTIONS))
    size = f"{width} x {height} pixels"
    if not projections.has_shape(projection, width, height):
        of_cube = any(width * down == height * across for across, down in CUBES)
        what = (
            "look like a map on a cube"
            if of_cube
            else f"are not {projections.name_of_map(projection)}"
        )
        shape = "twice as wide as high" if projection == LATLONG else "square"
        raise ConditionError(
            f"{size} {what}", f"{projections.name_of_map(projection)}, which is {shape}"
        )
    if height < LEAST:
        raise ConditionError(f"{size} are too few for a map", f"{LEAST} rows or more")


def _unit(normal: projections.Vector) -> projections.Vector:
    projections.spherical(*normal)  # raises an error if there is no direction
    return projections.unit(normal)


def _rows_of_a_strip(pixels: Any, side: int) -> int:
    """Return the number of rows to read at a time: a multiple of the rows of a block.

    NumPy arrays are read as a whole, as slices are not copies; of Dask arrays, each access
    computes whole chunks.
    """
    rows, columns, channels = map(int, pixels.shape)
    if isinstance(pixels, numpy.ndarray):
        return -(-rows // side) * side
    chunks = getattr(pixels, "chunks", None)
    least = int(max(chunks[0])) if chunks else 1
    return -(-max(least, STRIP // (columns * channels)) // side) * side
