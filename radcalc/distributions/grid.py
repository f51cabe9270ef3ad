"""Tables of intensities over polar angles and azimuths, with bilinear interpolation.

The functions complete tables of half planes by symmetry, and check their limits and noise; their
angles are in degrees, as in files.
"""

import math
from collections.abc import Callable
from typing import Any, NoReturn

import numpy

from radcalc.distributions.distribution import ALL_AZIMUTHS, ALL_POLAR, Interval, Peak, integrated
from radcalc.errors import ConditionError
from radcalc.geometry.directions import TURN, cartesian, spherical
from radcalc.geometry.numerics.cubature import ROUNDING, Integral
from radcalc.maths import Number, in_chunks

NEAR = 1e-9  # [rad] rounding beyond the ends of a table, and the closest of its angles
SEAM = 0.02  # of the peak: largest accepted difference of two values in one direction
NARROW = 0.1  # [rad] half a cell: up to this, four terms of the series are exact
MANY = 9  # azimuths; half of them still show the shape
ACCURACY = 1e-4  # [1] of the flux through a part that cuts across a table's cells
# Indices, among the source's coordinates x, y, z, of the table's: its azimuth goes from the first
# to the second, and its polar angle starts at the third.
AXES = {"C": (0, 1, 2), "B": (2, 0, 1)}
CIRCLE = 360.0  # [deg]
SLACK = 0.01  # [deg] tolerance of angles
CLOSEST = 1e-6  # [deg] below it, two angles of a table are one
GREATEST = 1e100  # intensity in any unit: sums of it stay finite
NOISE = 1e-3  # of the greatest: smaller negative values are a photometer's noise
ROUNDED = 0.5  # [deg] rounding of the angles of evenly spaced planes


class Grid:
    """Intensities in the directions of a table, with bilinear interpolation in its two angles.

    Parameters
    ----------
    polar : array_like of shape (m,) [rad]
        Polar angles from the table's pole, rising, within 0 and pi; two or more.
    azimuth : array_like of shape (n,) [rad]
        Azimuths about that pole, rising, over a turn at most.  A table of the whole circle
        repeats its first plane a turn later; the single azimuth 0 applies to every azimuth.
    values : array_like of shape (n, m) [cd, W/sr, photon/s/sr or 1]
        Intensities, 0 or more.
    kind : str, optional
        Kind of light, as in `Distribution`; "v" by default.
    system : {"C", "B"}, optional
        Pole, by the type of goniometer: the source's axis (z), or its y axis with azimuths from
        the axis towards x.

    Raises
    ------
    ConditionError
        If the angles do not rise or the values do not fit them; file readers give more detail.

    Notes
    -----
    The intensity is 0 beyond the angles.  A cell from a to b, with values I linear in theta, has::

        integral of I sin(theta) dtheta = A (I(a) + I(b)) / 2 + B (I(b) - I(a)) / (b - a)
        A = 2 sin(m) sin(h),  B = 2 cos(m) (sin(h) - h cos(h)),  m = (a + b)/2,  h = (b - a)/2

    which is exact; the zonal method of photometric laboratories omits B.  Over a sphere, the error
    of both is about B.  The reported error is the larger of two: their difference, and half of
    the change if every other angle is omitted, the odd ones or the even ones (azimuths only
    if there are many).

    Examples
    --------
    A laboratory's table with a step of 15 degrees:

    >>> degrees, candelas = range(0, 91, 15), [300, 290, 260, 200, 110, 30, 0]
    >>> lamp = Grid(numpy.radians(degrees), [0.0], [candelas])
    >>> round(lamp.flux().value, 4), round(lamp.zonal_flux(), 1)
    (791.3485, 797.6)
    >>> round(float(lamp.intensity(math.radians(20), 0.0)), 6)
    280.0
    """

    def __init__(
        self, polar: Any, azimuth: Any, values: Any, kind: str = "v", system: str = "C"
    ) -> None:
        self.polar, self.azimuth = (numpy.array(x, float) for x in (polar, azimuth))
        self.values = numpy.array(values, float)
        self.kind, self.system = kind, system
        shape = (len(self.azimuth), len(self.polar))
        if self.values.shape != shape or shape[1] < 2 or shape[0] < 1:
            raise ConditionError(
                f"a table of {shape[0]} azimuths and {shape[1]} polar angles has values of the "
                f"shape {self.values.shape}",
                "a value for each pair, of two polar angles or more",
            )
        if any(numpy.any(numpy.diff(angles) < NEAR) for angles in (self.polar, self.azimuth)):
            raise ConditionError("the angles of a table do not rise", "each larger than the last")
        self._has_one_plane = len(self.azimuth) == 1
        self._closes = math.isclose(self.azimuth[-1] - self.azimuth[0], TURN)
        self.is_axial = system == "C" and self._has_one_plane
        self.finest = float(numpy.diff(self.polar).min())

    def intensity(self, theta: Number, phi: Number) -> Number:
        if self.system == "C":
            return self._at(theta, phi)
        vector = cartesian(theta, phi)
        polar, azimuth, _ = spherical(*(vector[k] for k in AXES[self.system]))
        return self._at(polar, azimuth)

    def _at(self, polar: Number, azimuth: Number) -> Number:
        polar, azimuth = numpy.broadcast_arrays(polar, azimuth)
        if self._has_one_plane:
            values = in_chunks(self._in_plane, polar.ravel())
        else:
            values = in_chunks(self._between_planes, polar.ravel(), azimuth.ravel())
        return values.reshape(polar.shape)[()]

    def _in_plane(self, polar: Any) -> Any:
        return numpy.interp(polar, self.polar, self.values[0]) * self._reaches(polar)

    def _reaches(self, polar: Any) -> Any:
        return (polar >= self.polar[0] - NEAR) & (polar <= self.polar[-1] + NEAR)

    def _between_planes(self, polar: Any, azimuth: Any) -> Any:
        """Return the bilinear interpolation of the intensity in directions."""
        count = len(self.polar)
        turned = (azimuth - self.azimuth[0] + NEAR) % TURN + (self.azimuth[0] - NEAR)
        # fractional row and column of each direction
        row = numpy.interp(turned, self.azimuth, numpy.arange(len(self.azimuth)))
        column = numpy.interp(polar, self.polar, numpy.arange(count))
        i = numpy.minimum(row.astype(numpy.intp), len(self.azimuth) - 2)
        j = numpy.minimum(column.astype(numpy.intp), count - 2)
        row -= i
        column -= j
        flat, first = self.values.ravel(), i * count + j
        in_plane = flat[first] * (1 - column) + flat[first + 1] * column
        in_next_plane = flat[first + count] * (1 - column) + flat[first + count + 1] * column
        values = in_plane * (1 - row) + in_next_plane * row
        lit = self._reaches(polar)
        if not self._closes:
            lit &= turned <= self.azimuth[-1] + NEAR
        return values * lit

    def flux(self, polar: Interval = ALL_POLAR, azimuth: Interval = ALL_AZIMUTHS) -> Integral:
        """Return the exact integral of the intensity over all directions, or a part of them.

        See `Distribution`.  For a table of type B, a part (given in the source's coordinates) is
        integrated numerically.
        """
        is_whole = (*polar, *azimuth) == (*ALL_POLAR, *ALL_AZIMUTHS)
        if self.system != "C" and not is_whole:
            integral = integrated(self, polar, azimuth, ACCURACY)
            return integral._replace(error=integral.error + integral.value * self._relative_error())
        value = self._sum(self.polar, self.values, polar, azimuth)
        zonal = self._sum(self.polar, self.values, polar, azimuth, is_zonal=True)
        halves = [self._every_other(polar, azimuth, first) for first in (0, 1)]
        off = max(abs(value - half) / 2 for half in halves)
        error = max(abs(value - zonal), off, ROUNDING * value)
        return Integral(value, error, self.values.size)

    def _relative_error(self) -> float:
        flux = self.flux()
        return flux.error / flux.value if flux.value else 0.0

    def zonal_flux(self) -> float:
        """Return the flux in all directions by the zonal method of photometric laboratories.

        It is the sum of the mean of a cell's corners times its solid angle, and agrees with the
        digits in laboratories' reports (IES LM-63).
        """
        return self._sum(self.polar, self.values, ALL_POLAR, ALL_AZIMUTHS, is_zonal=True)

    def _sum(
        self,
        nodes: Any,
        values: Any,
        polar: Interval,
        azimuth: Interval,
        is_zonal: bool = False,
        planes: Any = None,
    ) -> float:
        """Return the integral over an interval of the table's own angles."""
        planes = self.azimuth if planes is None else planes
        turns = azimuth[1] - azimuth[0]
        if len(planes) == 1:
            across = numpy.array([turns])
        else:
            first = planes[0]
            start = first + (azimuth[0] - first) % TURN
            across = sum(
                _weights(planes, low - k * TURN, low + turns - k * TURN, _even)
                for k, low in ((0, start), (1, start))
            )
        along = _weights(nodes, *polar, _zonal if is_zonal else _sine)
        return float(across @ values @ along)

    def _every_other(self, polar: Interval, azimuth: Interval, first: int) -> float:
        rows, columns = (_halved(len(angles), first) for angles in (self.azimuth, self.polar))
        if len(self.azimuth) < MANY:
            rows = list(range(len(self.azimuth)))
        return self._sum(
            self.polar[columns],
            self.values[rows][:, columns],
            polar,
            azimuth,
            planes=self.azimuth[rows],
        )

    def peak(self) -> Peak:
        """Return the greatest value of the table, and the first direction with it."""
        row, column = numpy.unravel_index(numpy.argmax(self.values), self.values.shape)
        intensity = float(self.values[row, column])
        polar, azimuth = float(self.polar[column]), float(self.azimuth[row]) % TURN
        if self.system != "C":
            direction = cartesian(polar, azimuth)
            axes = AXES[self.system]
            polar, azimuth, _ = spherical(*(direction[axes.index(k)] for k in range(3)))
        return Peak(intensity, polar, azimuth)

    def contradictions(self) -> tuple[str, ...]:
        """Return notes on directions for which the table has several, different values.

        >>> Grid([0, 1], [0, 1, 2], [[10, 1], [11, 1], [10, 1]]).contradictions()
        ('the planes differ on the axis, which is one direction, by 9.1 % of the peak',)
        """
        if self.system != "C" or self._has_one_plane:
            return ()
        rows = self.values / (self.values.max() or 1.0)
        spread = numpy.ptp(rows, axis=0)
        gaps = {
            "differ on the axis, which is one direction,": spread[self.polar <= NEAR],
            "differ opposite to the axis, which is one direction,": spread[
                self.polar >= math.pi - NEAR
            ],
        }
        if self._closes:
            gaps["at both ends of the circle, which are one, differ"] = abs(rows[0] - rows[-1])
        return tuple(
            f"the planes {how} by {100 * gap.max():.2g} % of the peak"
            for how, gap in gaps.items()
            if gap.max(initial=0.0) > SEAM
        )


def _halved(count: int, first: int) -> list[int]:
    return sorted({0, *range(first, count, 2), count - 1})


def _weights(nodes: Any, low: float, high: float, cell: Any) -> Any:
    """Return the weights of the nodes in the integral of a piecewise linear function, low to high.

    `cell` takes the middle and the half width of a part of a cell; it returns the weights of the
    cell's mean and of its difference.
    """
    left, right = nodes[:-1], nodes[1:]
    start, end = numpy.clip(left, low, high), numpy.clip(right, low, high)
    half, width = (end - start) / 2, right - left
    mean, slope = cell((start + end) / 2, half)
    # the value at the middle of the part, from those at the ends of the cell
    place = ((start + end) / 2 - left) / width
    weights = numpy.zeros(len(nodes))
    weights[:-1] += mean * (1 - place) - slope / width
    weights[1:] += mean * place + slope / width
    return weights


def _even(middle: Any, half: Any) -> Any:
    """Linear in the azimuth: the mean times the width."""
    return 2 * half, 0.0 * half


def _sine(middle: Any, half: Any) -> Any:
    """Linear in theta, times its sine: A, and B without the width."""
    sine, square = numpy.sin(half), half * half
    # sin(h) - h cos(h); a series for narrow cells, as the difference loses digits
    series = half * square * (1 / 3 - square * (1 / 30 - square * (1 / 840 - square / 45360)))
    difference = numpy.where(half < NARROW, series, sine - half * numpy.cos(half))
    return 2 * numpy.sin(middle) * sine, 2 * numpy.cos(middle) * difference


def _zonal(middle: Any, half: Any) -> Any:
    """The zonal method: the mean of both ends times the solid angle."""
    return 2 * numpy.sin(middle) * numpy.sin(half), 0.0 * half


def mirrored(planes: Any, values: Any) -> tuple[Any, Any]:
    """Complete a table of a half or a quarter of the circle by reflection at its last plane.

    `planes` are azimuths [deg], rising, from a plane of symmetry to the next; `values` has a row
    for each.  Return those of a whole turn, where the last plane repeats the first.

    Raises
    ------
    ConditionError
        If the planes do not span 90 or 180 degrees.

    Examples
    --------
    >>> mirrored([0, 45, 90], [[1], [2], [3]])[0].tolist()
    [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0, 360.0]
    """
    planes, values = numpy.array(planes, float), numpy.array(values, float)
    span = planes[-1] - planes[0]
    if not any(math.isclose(span, allowed, abs_tol=SLACK) for allowed in (CIRCLE / 4, CIRCLE / 2)):
        raise ConditionError(
            f"symmetric planes span {span:g} deg", "90 or 180 deg, from one symmetry to the next"
        )
    planes[-1] = planes[0] + round(span)
    while planes[-1] - planes[0] < CIRCLE - 1:
        planes = numpy.concatenate([planes, 2 * planes[-1] - planes[-2::-1]])
        values = numpy.concatenate([values, values[-2::-1]])
    return planes, values


def closed(planes: Any, values: Any) -> tuple[Any, Any]:
    """Close a table of the whole circle by a repetition of its first plane, unless it has one.

    Parameters are those of `mirrored`, for planes anywhere on the circle.  Raise a ConditionError
    if the gap after the last plane is wider than any other, so that planes are missing.

    >>> closed([0, 120, 240], [[1], [2], [3]])[0].tolist()
    [0.0, 120.0, 240.0, 360.0]
    """
    planes, values = numpy.array(planes, float), numpy.array(values, float)
    gap = planes[0] + CIRCLE - planes[-1]
    if abs(gap) <= SLACK:
        planes[-1] = planes[0] + CIRCLE
        return planes, values
    widest = float(numpy.diff(planes).max(initial=0.0))
    if not 0 < gap <= widest + ROUNDED:
        raise ConditionError(
            f"the planes end at {planes[-1]:g} deg, and {gap:g} deg of the circle are missing",
            f"planes all around, such as 0 to {CIRCLE - widest:g} deg" if widest else "more planes",
        )
    return numpy.append(planes, planes[0] + CIRCLE), numpy.concatenate([values, values[:1]])


def end_of(polar: Any) -> tuple[str, ...]:
    """Return the assumption about the intensity beyond the polar angles [deg] of a table, if any.

    >>> end_of([0, 45, 90])
    ('no light beyond the angles of the table, 0 to 90 deg',)
    """
    if polar[0] <= SLACK and polar[-1] >= CIRCLE / 2 - SLACK:
        return ()
    return (f"no light beyond the angles of the table, {polar[0]:g} to {polar[-1]:g} deg",)


def without_noise(
    values: Any, refuse: Callable[[int, str, str], NoReturn]
) -> tuple[Any, tuple[str, ...]]:
    """Return intensities with 0 for negative noise, and a note about it.

    `refuse` raises the error of a bad value, from its index in the flat array, the problem and a
    hint.  Bad are values further below 0 than noise or too large for sums, and the last value if
    none is above 0.
    """
    peak, low = float(values.max()), float(values.min())
    if max(peak, -low) > GREATEST:
        refuse(int(abs(values).argmax()), "an intensity is above 1e100", "those of a source")
    if peak <= 0:
        refuse(values.size - 1, "no intensity is above 0", "a table with light")
    if low < -NOISE * peak:
        refuse(int(values.argmin()), f"the intensity {low:g} is negative", "0 or more")
    if low >= 0:
        return values, ()
    count = int((values < 0).sum())
    what, verb = ("intensity", "counts") if count == 1 else ("intensities", "count")
    return values.clip(min=0), (f"{count} negative {what} (down to {low:g}) {verb} as 0",)
