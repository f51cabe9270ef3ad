"""A map of radiances: an image of everything around a place, as a function of direction."""

import math
from collections.abc import Sequence
from typing import Any

import numpy

from radcalc.distributions.distribution import Peak
from radcalc.distributions.maps.light_sums import LightSums, Progress, Raster
from radcalc.errors import ConditionError
from radcalc.geometry.directions import FORWARD, cartesian, facing, spherical
from radcalc.geometry.light_vectors import is_shown, shown_directions
from radcalc.geometry.numerics.cubature import ROUNDING, Integral
from radcalc.geometry.numerics.vectors import Vector, components, from_components, unit, vector
from radcalc.geometry.projections import (
    corner_of_pixel,
    has_shape,
    middle_of_pixel,
    name_of_map,
    pixel_solid_angles,
    place_of,
)
from radcalc.maths import Number
from radcalc.quantities.symbols import LATLONG, PROJECTIONS
from radcalc.units.ranges import refuse_masked

STRIP = 1 << 22  # numbers that are read at a time, where the pixels are not in memory
GROUP = 1 << 18  # pixels of which the solid angles are worked out at a time
LEAST = 4  # rows: with fewer even the sign of a direction is open
CUBES = ((3, 4), (4, 3), (6, 1), (1, 6))  # faces across and down, as maps on a cube are laid out
INSIDE = 1 - 1e-12


class RadianceMap:
    """Radiances by an image in a projection.

    Parameters
    ----------
    pixels : array of shape (height, width) or (height, width, channels)
        0 or more, row 0 at the top.  Anything that NumPy takes rows of: its own arrays, also mapped
        into memory, and Dask arrays, of which a strip of rows at a time is computed.
    projection : {"latlong", "mirror-ball", "angular"}
        As in `radcalc.geometry.projections`; latlong maps are 2:1, the others square.
    aim : tuple of 3 floats, optional
        Where in the world the middle of the image is; +x by default.  Its up stays as near to the
        world's as can be, as of `facing`.
    weights : sequence of floats, one a channel, optional
        What gives the scalar of the channels, as the luminance of R, G and B; only of one channel
        1 by default.
    factor : float, optional
        What a value is in coherent SI (cd/m2, W/m2/sr, photon/s/m2/sr).
    kind : {"v", "e", "p", ""}, optional
        The kind of light; empty where values are relative.
    frame : tuple of 4 ints, optional
        Left, top, full width and full height, where the pixels are a part of a larger image.

    Attributes
    ----------
    coverage : float [1]
        The share of the sphere that the pixels show.
    solid_angle : float [sr]
        The same as a solid angle.

    Raises
    ------
    ConditionError
        If the shape is not the projection's, or a pixel is negative, infinite or NaN; outside of
        the circle of a mirror ball or an angular map pixels may be anything.
    NumberError
        If a pixel is masked.

    Notes
    -----
    A pixel has one radiance in all directions that it shows: `radiance` looks up the pixel, and
    `irradiance` is the sum over pixels of their radiance times the integral of cos(theta) over
    their solid angle (`light_sums` says how).  The error that is given of an irradiance is how much
    of the light of pixels that the receiver's horizon cuts may be on its other side: nobody knows
    how it is spread there.  What an image lost when its pixels were made is no part
    of it.

    All pixels are read once when a map is made.

    Examples
    --------
    3000 cd/m2 everywhere:

    >>> around = RadianceMap(numpy.full((512, 1024), 3000.0), "latlong", kind="v")
    >>> round(around.irradiance((1.0, 2.0, 3.0)).value, 2), around.coverage
    (9424.78, 1.0)
    """

    def __init__(
        self,
        pixels: Any,
        projection: str,
        aim: Vector = FORWARD,
        weights: Sequence[float] | None = None,
        factor: float = 1.0,
        kind: str = "",
        frame: tuple[int, int, int, int] | None = None,
    ) -> None:
        if not (hasattr(pixels, "shape") and hasattr(pixels, "dtype")):
            pixels = numpy.asarray(pixels)
        if len(pixels.shape) not in (2, 3) or 0 in pixels.shape or pixels.dtype.kind not in "fiu":
            raise ConditionError(
                f"pixels of the shape {pixels.shape} and the type {pixels.dtype} are no map",
                "real numbers of the shape (height, width) or (height, width, channels)",
            )
        self.pixels = pixels if len(pixels.shape) == 3 else pixels[:, :, None]
        rows, columns, channels = self.pixels.shape
        if len(weights or (1.0,)) != channels:
            raise ConditionError(
                f"pixels of {channels} channels have {len(weights or (1.0,))} weights",
                "a weight for each channel",
            )
        left, top, width, height = frame or (0, 0, columns, rows)
        check_shape(projection, width, height)
        if min(left, top) < 0 or left + columns > width or top + rows > height:
            raise ConditionError(
                f"{columns} x {rows} pixels from {left},{top} on are no part of an image of "
                f"{width} x {height}",
                "a part that lies within it",
            )
        self.projection, self.kind, self.is_axial = projection, kind, False
        self.size, self.part = (width, height), (left, top, columns, rows)
        self.axes = facing(aim)
        self._weights = factor * numpy.array(weights or (1.0,), float)
        self.factor = factor
        self.raster = Raster(projection, self.size, self.part)
        self._strip = _rows_of_a_strip(self.pixels, self.raster.side)
        self._read = self._angles = (-1, numpy.empty(0))  # what was read or worked out last
        self.solid_angle = self._flux = 0.0
        self._peak = (-1.0, 0, 0)  # value, column and row in the whole image
        self._sums = LightSums(self.raster, self.luminances, self._survey)
        is_whole = (columns, rows) == self.size
        self.coverage = 1.0 if is_whole else self.solid_angle / (4 * math.pi)

    def channels(self, first: int, last: int) -> Any:
        """Radiances of the channels, in coherent SI, from a row to before another.

        Both in the same strip; what is outside of the circle is 0.
        """
        return numpy.multiply(self._inside(first, last), self.factor, dtype=float)

    def luminances(self, first: int, last: int) -> Any:
        """Weighted sums of the channels, of a single channel; else the same as of `channels`."""
        channels = numpy.moveaxis(self._inside(first, last), -1, 0)
        with numpy.errstate(invalid="ignore"):  # NaN and infinity, which are refused then
            # of a few channels faster than a matrix product
            parts = (
                weight * channel for weight, channel in zip(self._weights, channels, strict=True)
            )
            return numpy.asarray(sum(parts))[..., None]

    def _inside(self, first: int, last: int) -> Any:
        """Pixels as they are, but for those of which nothing is in the circle."""
        number, start = divmod(first, self._strip)
        pixels = self._rows(number)[start : start + last - first]
        if self.projection == LATLONG:
            return pixels
        (left, top, columns, _), (width, height) = self.part, self.size
        column = numpy.arange(left, left + columns + 1)
        u, v = corner_of_pixel(width, height, column, numpy.arange(top + first, top + last + 1))
        return numpy.where(is_shown(self.projection, u, v)[..., None], pixels, 0)

    def _rows(self, strip: int) -> Any:
        """A strip of rows; one is kept."""
        if strip != self._read[0]:
            rows = self.pixels[strip * self._strip : (strip + 1) * self._strip]
            if hasattr(rows, "compute"):  # of Dask's; else its mask would be lost
                rows = rows.compute()
            refuse_masked(rows, "the map")
            self._read = (strip, numpy.asarray(rows))
        return self._read[1]

    def solid_angles(self, first: int, last: int) -> Any:
        """Solid angles [sr] of the pixels from a row to before another."""
        # many rows are worked out at a time, and kept
        (left, top, columns, rows), side = self.part, self.raster.side
        many = -(-GROUP // (self.size[0] * side)) * side
        group, start = divmod(first, many)
        if group != self._angles[0]:
            part = slice(top + group * many, top + min((group + 1) * many, rows))
            sizes = pixel_solid_angles(self.projection, *self.size, part)
            full_rows = numpy.broadcast_to(sizes, (len(sizes), self.size[0]))
            self._angles = (group, full_rows[:, left : left + columns])
        return self._angles[1][start : start + last - first]

    def _survey(self, first: int, last: int, values: Any) -> None:
        """Check the pixels of rows, and note the flux, the solid angle and the peak."""
        left, top, *_ = self.part
        pixels = self._inside(first, last)
        # of NaN both are NaN
        if not (pixels.min() >= 0 and pixels.max() < math.inf):
            row, column, channel = numpy.argwhere(~((pixels >= 0) & (pixels < math.inf)))[0]
            raise ConditionError(
                f"the pixel in column {left + column} of row {top + first + row}, from 0 at the "
                f"top left, is {pixels[row, column, channel]:g}",
                "a map of radiances, which are 0 or more",
            )
        solid_angles = self.solid_angles(first, last)
        self.solid_angle += float(solid_angles.sum())
        # not by numpy.vdot, whose threads wait for each other on a busy machine
        self._flux += float((values[..., 0] * solid_angles).sum())
        row, column, _ = numpy.unravel_index(numpy.argmax(values), values.shape)
        highest = float(values[row, column, 0])
        if highest > self._peak[0]:
            self._peak = (highest, left + int(column), top + first + int(row))

    def radiance(self, polar: Number, azimuth: Number) -> Number:
        """As of `Radiances`: that of the pixel that shows a direction, 0 where none does."""
        polar, azimuth = numpy.broadcast_arrays(polar, azimuth)
        direction = self.in_map_axes(cartesian(polar.ravel(), azimuth.ravel()))
        return (self.toward(direction) @ self._weights).reshape(polar.shape)[()]

    def toward(self, direction: Vector) -> Any:
        """Values, as the channels have them, of the pixels that show directions in its own axes.

        Parameters
        ----------
        direction : tuple of 3 ndarrays of shape (n,)

        Returns
        -------
        ndarray of shape (n, channels)
            0 where none does; not times the factor.
        """
        column, row = self._pixel_of(direction)
        values = numpy.zeros((len(column), self.pixels.shape[2]))
        is_there = column >= 0
        for strip in numpy.unique(row[is_there] // self._strip):
            here = is_there & (row // self._strip == strip)
            values[here] = self._rows(strip)[row[here] % self._strip, column[here]]
        return values

    def irradiance(self, normal: Vector) -> Integral:
        in_map = numpy.array([self.in_map_axes(_unit(normal))])
        values, errors = self._sums.irradiances(in_map, has_errors=True)
        value, error = float(values[0, 0]), float(errors[0, 0])
        return Integral(value, error + ROUNDING * value, self.part[2] * self.part[3])

    def irradiances(
        self, normals: Any, is_each: bool = False, progress: Progress | None = None
    ) -> Any:
        """Irradiances of many receivers.

        Parameters
        ----------
        normals : array_like of shape (..., 3)
            Where they face; of any length but 0.
        is_each : bool, optional
            Whether to give those of the channels, and not of their weighted sum.
        progress : callable, optional
            Is called with how much is done, and all there is, each time when more is done.

        Returns
        -------
        ndarray of shape (...) or (..., channels) [lx, W/m2, photon/s/m2 or sr]

        Examples
        --------
        >>> above = RadianceMap(numpy.repeat([1.0, 0.0], 32)[:, None] + numpy.zeros(128), "latlong")
        >>> above.irradiances([(0, 0, 1), (1, 0, 0), (0, 0, -1)]).round(6).tolist()
        [3.141593, 1.570796, 0.0]
        """
        x, y, z = self.in_map_axes(_unit(vector(numpy.asarray(normals, float))))
        in_map = numpy.stack([numpy.ravel(component) for component in (x, y, z)], -1)
        if not is_each:
            values, _ = self._sums.irradiances(in_map, progress)
            return values.reshape(numpy.shape(x))[()]
        sums = LightSums(self.raster, self.channels)
        values, _ = sums.irradiances(in_map, progress)
        return values.reshape(*numpy.shape(x), -1)

    def mean(self) -> float:
        return self._flux / self.solid_angle

    def peak(self) -> Peak:
        """As of `Radiances`: the first pixel that has it, and the direction of its middle."""
        value, column, row = self._peak
        u, v = middle_of_pixel(*self.size, column, row)
        polar, azimuth, _ = spherical(*self.world(shown_directions(self.projection, u, v)))
        return Peak(value, float(polar), float(azimuth))

    def in_map_axes(self, direction: Vector) -> Vector:
        """A direction of the world in the map's own axes."""
        return components(self.axes, direction)

    def world(self, direction: Vector) -> Vector:
        """A direction in the map's own axes as one of the world."""
        return from_components(self.axes, direction)

    def _pixel_of(self, direction: Vector) -> tuple[Any, Any]:
        """Column and row, among the pixels there are, that show directions; -1 where none does."""
        (left, top, columns, rows), (width, height) = self.part, self.size
        u, v = place_of(self.projection, *direction)
        # a place on the edge belongs to the pixel inside of it
        column, row = (1 + INSIDE * u) / 2 * width - left, (1 - INSIDE * v) / 2 * height - top
        is_there = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
        column, row = (numpy.where(is_there, place, -1).astype(int) for place in (column, row))
        return column, row


def check_shape(projection: str, width: int, height: int) -> None:
    """Refuse the size of an image that a projection does not have.

    Parameters
    ----------
    projection : {"latlong", "mirror-ball", "angular"}
    width, height : int
        Size [pixels].

    Raises
    ------
    ConditionError

    Examples
    --------
    >>> check_shape("latlong", 1024, 512)
    """
    if projection not in PROJECTIONS:
        raise ConditionError(f"{projection} is no projection", ", ".join(PROJECTIONS))
    size = f"{width} x {height} pixels"
    if not has_shape(projection, width, height):
        of_cube = any(width * down == height * across for across, down in CUBES)
        what = "look like a map on a cube" if of_cube else f"are no {projection} map"
        shape = "twice as wide as high" if projection == LATLONG else "square"
        raise ConditionError(f"{size} {what}", f"{name_of_map(projection)}, which is {shape}")
    if height < LEAST:
        raise ConditionError(f"{size} are too few for a map", f"{LEAST} rows or more")


def _unit(normal: Vector) -> Vector:
    spherical(*normal)  # refuses what has no direction
    return unit(normal)


def _rows_of_a_strip(pixels: Any, side: int) -> int:
    """How many rows to read at a time: a multiple of those of a block.

    All of NumPy's, of which parts are no copies; of Dask's no fewer than a chunk has, since each
    time all of a chunk is computed.
    """
    rows, columns, channels = map(int, pixels.shape)
    if isinstance(pixels, numpy.ndarray):
        return -(-rows // side) * side
    chunks = getattr(pixels, "chunks", None)
    least = int(max(chunks[0])) if chunks else 1
    return -(-max(least, STRIP // (columns * channels)) // side) * side
