"""The protocol of distributions, and functions for all of them."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple, Protocol

import numpy

from radcalc.geometry.numerics.cubature import Dark, Integral, Steps, over_directions
from radcalc.maths import Number

Interval = tuple[float, float]
ALL_POLAR: Interval = (0.0, math.pi)  # [rad]
ALL_AZIMUTHS: Interval = (0.0, 2 * math.pi)  # [rad]


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
    >>> from radcalc.distributions.shapes import Lobe
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
