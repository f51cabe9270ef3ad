"""Distributions: their protocol and flux, beam angles, pose, and the contents of a file.

Two definitions of the beam angle and the field angle are in use, which differ if the intensity is
not greatest on the axis; see `Beam`.  The share of the intensity is one half for the beam angle and
one tenth for the field angle.
"""

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, Protocol

import numpy

from radcalc.geometry import directions
from radcalc.geometry.numerics.cubature import Dark, Integral, Steps, over_directions
from radcalc.maths import Number

Interval = tuple[float, float]
ALL_POLAR: Interval = (0.0, math.pi)  # [rad]
ALL_AZIMUTHS: Interval = (0.0, 2 * math.pi)  # [rad]
STEPS = 3600  # samples of a half plane, from the axis to the opposite direction
DIFFER = math.radians(2)  # a larger difference between the definitions is reported
DOWN: directions.Vector = (0.0, 0.0, -1.0)
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
    >>> from radcalc.distributions.formula import Lobe
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

    >>> from radcalc.distributions.formula import Lobe
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

    def __init__(self, aim: directions.Vector = DOWN, rotate: float = 0.0) -> None:
        directions.spherical(*aim)  # raises an error if there is no direction
        axis = directions.unit(aim)
        c0 = (math.cos(rotate), math.sin(rotate), 0.0)
        c90 = (-math.sin(rotate), math.cos(rotate), 0.0)
        self.axes = tuple(_turned(source_axis, axis) for source_axis in (c0, c90, DOWN))

    def angles(self, to: directions.Vector) -> tuple[Number, Number, Number]:
        """Return polar angle and azimuth [rad] in the source's coordinates, and the distance.

        `to` is the world vector from the source to a point; raise a ConditionError if it is 0.
        """
        return directions.spherical(*directions.components(self.axes, to))

    def world(self, direction: directions.Vector) -> directions.Vector:
        """Return a vector in the source's coordinates in world coordinates."""
        return directions.from_components(self.axes, direction)


def _turned(vector: directions.Vector, axis: directions.Vector) -> directions.Vector:
    """Turn a vector by the shortest rotation from straight down to an axis.

    v - (s . v) s / (1 + cos) + 2 (down . v) axis, with s = down + axis.  The z component of s is
    computed without loss of digits, so that the formula holds for an axis close to straight up.
    """
    x, y, z = axis
    up = -(x * x + y * y) / (1 + z) if z > 0 else z - 1
    middle = (x, y, up)
    if not any(middle):
        return (vector[0], -vector[1], -vector[2])
    kept = directions.plus(
        vector, middle, -directions.dot(middle, vector) / (directions.dot(middle, middle) / 2)
    )
    return directions.plus(kept, axis, 2 * directions.dot(DOWN, vector))


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
