"""A table of intensities over polar angles and azimuths, between which it is bilinear."""

import math
from typing import Any

import numpy

from radcalc.distributions.distribution import ALL_AZIMUTHS, ALL_POLAR, Interval, Peak, integrated
from radcalc.errors import ConditionError
from radcalc.geometry.directions import TURN, cartesian, spherical
from radcalc.geometry.numerics.cubature import ROUNDING, Integral
from radcalc.maths import Number, in_chunks

SLACK = 1e-9  # [rad] beyond the ends of a table, where rounding leads
SEAM = 0.02  # of the peak: what two values of one direction may differ by
NARROW = 0.1  # [rad] half a cell: up to there four terms of a series are exact
MANY = 9  # azimuths of which half still tell the shape
ACCURACY = 1e-4  # [1] of the flux through a part that cuts across a table's cells
# Which of the source's coordinates x, y, z are those of the table: its azimuth is counted from the
# first towards the second, and its polar angle from the third.
AXES = {"C": (0, 1, 2), "B": (2, 0, 1)}


class Grid:
    """Intensities in the directions of a table, bilinear in its two angles between them.

    Parameters
    ----------
    polar : array_like of shape (m,) [rad]
        Polar angles from the table's pole, rising, within 0 and pi; two or more.
    azimuth : array_like of shape (n,) [rad]
        Azimuths about that pole, rising, over a turn at most.  A table of the whole circle ends
        with the plane that it begins with, a turn later; one of the single azimuth 0 is the same
        at every azimuth.
    values : array_like of shape (n, m) [cd, W/sr, photon/s/sr or 1]
        Intensities, 0 or more.
    kind : str, optional
        The kind of light, as of `Distribution`; "v" by default.
    system : {"C", "B"}, optional
        Where the pole is, by the types of goniometer: on the source's axis (z), or across it on its
        y axis, with azimuths from its axis towards x.

    Raises
    ------
    ConditionError
        If the angles do not rise or the values do not fit them; readers of files say so better.

    Notes
    -----
    Beyond its angles a table is dark.  A cell from a to b, with values I linear in theta, has::

        integral of I sin(theta) dtheta = A (I(a) + I(b)) / 2 + B (I(b) - I(a)) / (b - a)
        A = 2 sin(m) sin(h),  B = 2 cos(m) (sin(h) - h cos(h)),  m = (a + b)/2,  h = (b - a)/2

    which is exact; the zonal method of photometric laboratories leaves B out.  Over a sphere both
    have errors of about the size of B.  The error that is given is the larger of two: their
    difference, and half of what leaving out every other angle changes, the odd ones or the even
    ones (of the azimuths only where there are many).

    Examples
    --------
    A laboratory's table of every 15 degrees:

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
        if any(numpy.any(numpy.diff(angles) <= 0) for angles in (self.polar, self.azimuth)):
            raise ConditionError("the angles of a table do not rise", "each larger than the last")
        self._is_alike = len(self.azimuth) == 1  # in every plane
        self._closes = math.isclose(self.azimuth[-1] - self.azimuth[0], TURN)
        self.is_axial = system == "C" and self._is_alike
        self.finest = float(numpy.diff(self.polar).min())

    def intensity(self, theta: Number, phi: Number) -> Number:
        if self.system == "C":
            return self._at(theta, phi)
        vector = cartesian(theta, phi)
        polar, azimuth, _ = spherical(*(vector[k] for k in AXES[self.system]))
        return self._at(polar, azimuth)

    def _at(self, polar: Number, azimuth: Number) -> Number:
        """Intensity at the table's own angles."""
        polar, azimuth = numpy.broadcast_arrays(polar, azimuth)
        if self._is_alike:
            values = in_chunks(self._in_plane, polar.ravel())
        else:
            values = in_chunks(self._between_planes, polar.ravel(), azimuth.ravel())
        return values.reshape(polar.shape)[()]

    def _in_plane(self, polar: Any) -> Any:
        """Linear between the two values about each direction."""
        return numpy.interp(polar, self.polar, self.values[0]) * self._reaches(polar)

    def _reaches(self, polar: Any) -> Any:
        return (polar >= self.polar[0] - SLACK) & (polar <= self.polar[-1] + SLACK)

    def _between_planes(self, polar: Any, azimuth: Any) -> Any:
        """Bilinear between the four values about each direction."""
        count = len(self.polar)
        turned = (azimuth - self.azimuth[0] + SLACK) % TURN + (self.azimuth[0] - SLACK)
        # the place of each direction among the rows and columns, as numbers with fractions
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
            lit &= turned <= self.azimuth[-1] + SLACK
        return values * lit

    def flux(self, polar: Interval = ALL_POLAR, azimuth: Interval = ALL_AZIMUTHS) -> Integral:
        """Integral of the intensity over all directions, or a part of them: exact.

        As of `Distribution`.  A part in the source's coordinates, which are not those of a table
        of type B, is integrated numerically.
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
        """Flux by the zonal method: the mean of a cell's corners times its solid angle.

        Returns
        -------
        float [lm, W, photon/s or sr]
            Flux in all directions.

        References
        ----------
        .. [1] IES LM-63 and the zonal lumen method of photometric laboratories; agrees with
           their reports to the digits printed.
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
        """Integral over an interval of the table's own angles."""
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
        """The same of the table without every other of its angles."""
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
        """The greatest value of the table, and the first direction that has it."""
        row, column = numpy.unravel_index(numpy.argmax(self.values), self.values.shape)
        intensity = float(self.values[row, column])
        polar, azimuth = float(self.polar[column]), float(self.azimuth[row]) % TURN
        if self.system != "C":
            direction = cartesian(polar, azimuth)
            axes = AXES[self.system]
            polar, azimuth, _ = spherical(*(direction[axes.index(k)] for k in range(3)))
        return Peak(intensity, polar, azimuth)

    def contradictions(self) -> tuple[str, ...]:
        """What the table says twice of one direction, and differently.

        Returns
        -------
        tuple of str
            A note for each: on the axis, behind it, and where the circle closes.

        Examples
        --------
        >>> Grid([0, 1], [0, 1, 2], [[10, 1], [11, 1], [10, 1]]).contradictions()
        ('the planes differ on the axis, which is one direction, by 9.1 % of the peak',)
        """
        if self.system != "C" or self._is_alike:
            return ()
        rows = self.values / (self.values.max() or 1.0)
        spread = numpy.ptp(rows, axis=0)
        gaps = {
            "differ on the axis, which is one direction,": spread[self.polar <= SLACK],
            "differ behind the axis, which is one direction,": spread[
                self.polar >= math.pi - SLACK
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
    """Every other of so many, from one of the first two on, and both ends."""
    return sorted({0, *range(first, count, 2), count - 1})


def _weights(nodes: Any, low: float, high: float, cell: Any) -> Any:
    """What a value at each node counts in the integral, from low to high, of what is linear.

    `cell` integrates over parts of the cells: from the middle of each and half of its width, it
    gives what their mean and what their difference counts.
    """
    left, right = nodes[:-1], nodes[1:]
    start, end = numpy.clip(left, low, high), numpy.clip(right, low, high)
    half, width = (end - start) / 2, right - left
    mean, slope = cell((start + end) / 2, half)
    # the value at the middle of the part, in terms of those at the ends of the cell
    place = ((start + end) / 2 - left) / width
    weights = numpy.zeros(len(nodes))
    weights[:-1] += mean * (1 - place) - slope / width
    weights[1:] += mean * place + slope / width
    return weights


def _even(middle: Any, half: Any) -> Any:
    """Of a linear function over azimuths: its mean times the width."""
    return 2 * half, 0.0 * half


def _sine(middle: Any, half: Any) -> Any:
    """Of a linear function times the sine: A, and B without the width."""
    sine, square = numpy.sin(half), half * half
    # sin(h) - h cos(h), of narrow cells by its series: the difference loses digits
    series = half * square * (1 / 3 - square * (1 / 30 - square * (1 / 840 - square / 45360)))
    difference = numpy.where(half < NARROW, series, sine - half * numpy.cos(half))
    return 2 * numpy.sin(middle) * sine, 2 * numpy.cos(middle) * difference


def _zonal(middle: Any, half: Any) -> Any:
    """Of the mean of both ends times the cell."""
    return 2 * numpy.sin(middle) * numpy.sin(half), 0.0 * half
