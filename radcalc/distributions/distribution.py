"""Distributions: their protocol and flux, beam angles, pose, the contents of a file, and tables.

Two definitions of the beam angle and the field angle are in use, which differ if the intensity is
not greatest on the axis; see `Beam`.  The share of the intensity is one half for the beam angle and
one tenth for the field angle.

A grid is a table of intensities over polar angles and azimuths, with bilinear interpolation.
Functions complete tables of half planes by symmetry, and check their limits and noise; their angles
are in degrees, as in files.
"""

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, NoReturn, Protocol

import numpy

from radcalc.errors import ConditionError
from radcalc.geometry import projections
from radcalc.geometry.numerics.cubature import ROUNDING, Dark, Integral, Steps, over_directions
from radcalc.geometry.projections import TURN, cartesian, spherical
from radcalc.maths import Number, in_chunks

Interval = tuple[float, float]
ALL_POLAR: Interval = (0.0, math.pi)  # [rad]
ALL_AZIMUTHS: Interval = (0.0, 2 * math.pi)  # [rad]
STEPS = 3600  # samples of a half plane, from the axis to the opposite direction
DIFFER = math.radians(2)  # a larger difference between the definitions is reported
DOWN: projections.Vector = (0.0, 0.0, -1.0)
ODD = 0.02  # [1] a larger difference between declared and computed figures is reported


class Peak(NamedTuple):
    """The greatest value of a function of direction [coherent SI], and its direction [rad]."""

    value: float
    polar: float
    azimuth: float


class Integrable(Protocol):
    """A function that can be integrated over directions; see `Distribution`."""

    @property
    def is_axial(self) -> bool: ...
    def intensity(self, theta: Number, phi: Number) -> Number: ...


class Distribution(Protocol):
    """Intensity as a function of direction.

    Attributes
    ----------
    kind : str
        Kind of light: "v" for cd, "e" for W/sr, "p" for photon/s/sr; empty if relative.
    is_axial : bool
        Whether the intensity is the same at every azimuth.
    finest : float [rad]
        Smallest width of a peak.
    """

    @property
    def kind(self) -> str: ...
    @property
    def is_axial(self) -> bool: ...
    @property
    def finest(self) -> float: ...

    def intensity(self, theta: Number, phi: Number) -> Number:
        """Return the intensity [cd, W/sr, photon/s/sr or 1] in directions, 0 or more.

        `theta`, the polar angle from the axis, from 0 to pi, and the azimuth `phi` [rad] are
        broadcast together.
        """
        ...

    def flux(self, polar: Interval = ALL_POLAR, azimuth: Interval = ALL_AZIMUTHS) -> Integral:
        """Return the flux [lm, W, photon/s or sr] in all directions or in a part, and its error.

        `polar` and `azimuth` [rad] are the limits of the part.
        """
        ...

    def peak(self) -> Peak:
        """Return the greatest intensity, and its direction."""
        ...


def integrated(
    distribution: Integrable,
    polar: Interval,
    azimuth: Interval,
    accuracy: float,
    steps: Steps = ((), ()),
) -> Integral:
    """Return the flux between polar angles and azimuths [rad], by cubature.

    The accuracy is relative to the flux; a larger error, up to 1e-3, is accepted if edges across
    the angles cause it.  `steps` are polar angles and azimuths within the limits at which the
    intensity has a step.  The flux is 0 if the part is dark at all points of a fine grid.

    Raises
    ------
    ConditionError
        If the accuracy is not reached.

    Examples
    --------
    >>> from radcalc.distributions.sources import Lobe
    >>> round(integrated(Lobe(1.0), (0.0, math.pi / 2), ALL_AZIMUTHS, 1e-9).value / math.pi, 9)
    1.0
    """
    if not (polar[0] < polar[1] and azimuth[0] < azimuth[1]):
        return Integral(0.0, 0.0, 0)
    counts = DARK_AXIAL if distribution.is_axial else NO_LIGHT
    theta, phi = (
        _middles(*ends, count) for ends, count in zip((polar, azimuth), counts, strict=True)
    )
    theta = theta[:, None]
    if not any(steps) and not numpy.any(distribution.intensity(theta, phi)):
        return Integral(0.0, 0.0, 0)
    try:
        return over_directions(
            lambda at: distribution.intensity(at["theta"], at["phi"]),
            polar,
            azimuth,
            accuracy,
            is_axial=distribution.is_axial,
            accepted=ACCEPTED,
            steps=steps,
        )
    except Dark:  # between its steps
        return Integral(0.0, 0.0, 0)


ACCEPTED = 1e-3  # [1] of the flux


def _middles(low: float, high: float, count: int) -> Any:
    """Return the middles of the parts of an interval; rounding may leave some light at its ends."""
    return low + (high - low) * (numpy.arange(count) + 0.5) / count


# Polar angles and azimuths of the grid that shows whether there is light.
NO_LIGHT, DARK_AXIAL = (361, 361), (20_000, 1)


def last_where(holds: Callable[[Any], Any], inside: float, outside: float) -> float:
    """Return the last number from `inside` to `outside` at which a condition holds.

    The precision is that of a float, by repeated refinement with many numbers at once;
    `radcalc.maths.limit` does the same with single numbers.

    Examples
    --------
    >>> round(last_where(lambda x: x * x < 2, 1.0, 2.0), 12)
    1.414213562373
    """
    for _ in range(NARROWER):
        parts = numpy.linspace(inside, outside, CLOSER)
        first = int(numpy.argmin(holds(parts))) or CLOSER - 1
        inside, outside = float(parts[first - 1]), float(parts[first])
    return inside


CLOSER = 65  # numbers per refinement
NARROWER = 9  # refinements, each by a factor of 64


class Beam(NamedTuple):
    """A full angle in one plane, by both definitions (CIE e-ILV 17-27-077, beam angle).

    Attributes
    ----------
    outermost : float [rad] or None
        Angle between the outermost directions with the share of the plane's greatest intensity;
        None if there are none, as in a uniform light.
    from_axis : float [rad] or None
        Angle between the first directions from the axis with the share of the axial intensity;
        None if there are none, or if the axis is dark.
    is_ambiguous : bool
        Whether the two differ by more than 2 degrees, or one of them does not exist.
    edges : tuple of 2 floats [rad] or None
        Outermost directions, as angles from the axis: positive towards the azimuth, negative
        towards the opposite one.
    """

    outermost: float | None
    from_axis: float | None
    is_ambiguous: bool
    edges: tuple[float, float] | None = None


def beam(distribution: Distribution, azimuth: float, share: float) -> Beam:
    """Return the full angle in the plane of an azimuth [rad] and the opposite one.

    `share` is that of the intensity: 1/2 for the beam angle, 1/10 for the field angle.

    Examples
    --------
    The intensity of a Lambertian surface falls to one half at 60 degrees:

    >>> from radcalc.distributions.sources import Lobe
    >>> beam_angle = beam(Lobe(1.0), 0.0, 0.5)
    >>> round(math.degrees(beam_angle.outermost), 9), beam_angle.is_ambiguous
    (120.0, False)
    """
    angle = numpy.linspace(-math.pi, math.pi, 2 * STEPS + 1)

    def along(angle: Any) -> Any:
        return distribution.intensity(
            abs(angle), numpy.where(angle < 0, azimuth + math.pi, azimuth)
        )

    values = along(angle)
    edges = _edges(along, angle, values, share * float(values.max()), None)
    near = _edges(along, angle, values, share * float(values[STEPS]), STEPS)
    outermost, from_axis = (None if ends is None else ends[1] - ends[0] for ends in (edges, near))
    differ = outermost is None or from_axis is None or abs(outermost - from_axis) > DIFFER
    return Beam(outermost, from_axis, differ, edges)


def _edges(
    along: Callable[[Any], Any], angle: Any, values: Any, level: float, start: int | None
) -> tuple[float, float] | None:
    """Return the outermost angles with a level of intensity, or the first ones around `start`.

    Return None if there is no light, or if the light goes all the way round.
    """
    bright = values >= level
    dark = numpy.flatnonzero(~bright)
    if not level or not len(dark):
        return None
    if start is None:
        lit = numpy.flatnonzero(bright)
        left, right = int(lit[0]), int(lit[-1])
    else:
        beyond = numpy.searchsorted(dark, start)
        if beyond in (0, len(dark)):
            return None
        left, right = int(dark[beyond - 1]) + 1, int(dark[beyond]) - 1
    if left == 0 or right == len(angle) - 1:
        return None

    def is_bright(angle: Any) -> Any:
        return along(angle) >= level

    return (
        last_where(is_bright, float(angle[left]), float(angle[left - 1])),
        last_where(is_bright, float(angle[right]), float(angle[right + 1])),
    )


class Pose:
    """Rotation from a source's own coordinates into world coordinates, in which +z is up.

    By default a source shines down: its axis is -z, its C0 half plane is towards +x and C90
    towards +y.

    Parameters
    ----------
    aim : tuple of 3 floats, optional
        Direction of the axis, of any length but 0; straight down by default.
    rotate : float [rad], optional
        Rotation of the source about its axis before it is aimed: C0 from +x towards +y.

    Raises
    ------
    ConditionError
        If the aim has no direction.

    Notes
    -----
    The axis turns from straight down to its aim by the shortest way, about the horizontal line
    perpendicular to both.  To straight up it turns about the x axis, so that C0 does not change.

    Examples
    --------
    A point below and to the side, at 45 degrees from the axis in C0:

    >>> theta, phi, distance = Pose().angles((2.0, 0.0, -2.0))
    >>> round(math.degrees(theta), 9), phi, round(distance, 6)
    (45.0, 0.0, 2.828427)
    """

    def __init__(self, aim: projections.Vector = DOWN, rotate: float = 0.0) -> None:
        projections.spherical(*aim)  # raises an error if there is no direction
        axis = projections.unit(aim)
        c0 = (math.cos(rotate), math.sin(rotate), 0.0)
        c90 = (-math.sin(rotate), math.cos(rotate), 0.0)
        self.axes = tuple(_turned(source_axis, axis) for source_axis in (c0, c90, DOWN))

    def angles(self, to: projections.Vector) -> tuple[Number, Number, Number]:
        """Return polar angle and azimuth [rad] in the source's coordinates, and the distance.

        `to` is the world vector from the source to a point; raise a ConditionError if it is 0.
        """
        return projections.spherical(*projections.components(self.axes, to))

    def world(self, direction: projections.Vector) -> projections.Vector:
        """Return a vector in the source's coordinates in world coordinates."""
        return projections.from_components(self.axes, direction)


def _turned(vector: projections.Vector, axis: projections.Vector) -> projections.Vector:
    """Turn a vector by the shortest rotation from straight down to an axis.

    v - (s . v) s / (1 + cos) + 2 (down . v) axis, with s = down + axis.  The z component of s is
    computed without loss of digits, so that the formula holds for an axis close to straight up.
    """
    x, y, z = axis
    up = -(x * x + y * y) / (1 + z) if z > 0 else z - 1
    middle = (x, y, up)
    if not any(middle):
        return (vector[0], -vector[1], -vector[2])
    kept = projections.plus(
        vector, middle, -projections.dot(middle, vector) / (projections.dot(middle, middle) / 2)
    )
    return projections.plus(kept, axis, 2 * projections.dot(DOWN, vector))


class Photometry(NamedTuple):
    """A distribution as read from a file.

    Attributes
    ----------
    declared : dict of str to float
        Declared values [SI], by symbol: `lamp-flux` of all lamps and `output-ratio`, or the
        luminaire's `flux` for absolute photometry; `input-power`, `downward-fraction`.
    size : float [m]
        Longest side or diameter of the luminous area, if declared; else 0.
    assumptions, notes : tuple of str
        Assumptions of the reader, and oddities.
    """

    distribution: Distribution
    format: str
    name: str = ""
    declared: dict[str, float] = {}  # noqa: RUF012  it is never modified
    assumptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    size: float = 0.0

    def contradictions(self) -> Iterator[str]:
        """Yield the declared values that differ from those of the intensities by more than 2 %.

        Lamps may have more flux than the luminaire, but not less.
        """
        declared, flux = self.declared, self.distribution.flux().value
        if not (declared and flux):
            return
        template = "the file declares {} of {} {unit}, but its intensities give {} {unit}"
        lamps = declared.get("lamp-flux", math.inf)
        if flux > lamps * (1 + ODD):
            yield template.format("lamps", *_rounded(lamps, flux), unit="lm") + ", which is more"
        downward = self.distribution.flux((0.0, math.pi / 2)).value
        for symbol, label, computed, measure in (
            ("flux", "a luminaire", flux, "lm"),
            ("output-ratio", "a light output ratio", 100 * flux / lamps, "%"),
            ("downward-fraction", "a downward fraction", 100 * downward / flux, "%"),
        ):
            stated = declared.get(symbol, 0.0) * (100 if measure == "%" else 1)
            if stated and abs(computed - stated) > ODD * stated:
                yield template.format(label, *_rounded(stated, computed), unit=measure)


def _rounded(*figures: float) -> Iterator[str]:
    """Yield numbers with four significant digits."""
    return (f"{float(f'{figure:.4g}'):g}" for figure in figures)


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
        problem = f"symmetric planes span {span:g} deg"
        raise ConditionError(problem, "90 or 180 deg, from one symmetry to the next")
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
