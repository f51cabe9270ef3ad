"""What every distribution can do, and what follows from that alone."""

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
    """The greatest value of a function of direction, and one direction that has it.

    Attributes
    ----------
    value : float [coherent SI]
        The value: an intensity of a distribution.
    polar, azimuth : float [rad]
        The direction.

    Examples
    --------
    >>> Peak(100.0, 0.0, 0.0).value
    100.0
    """

    value: float
    polar: float
    azimuth: float


class Integrable(Protocol):
    """What can be integrated over directions; `Distribution` has the details."""

    @property
    def is_axial(self) -> bool: ...
    def intensity(self, theta: Number, phi: Number) -> Number: ...


class Distribution(Protocol):
    """Intensity as a function of direction.

    Attributes
    ----------
    kind : str
        The kind of light: "v" where intensities are in cd, "e" in W/sr, "p" in photon/s/sr; empty
        where they are relative.
    is_axial : bool
        Whether the intensity is the same at every azimuth.
    finest : float [rad]
        An angle within which no peak of it hides.
    """

    @property
    def kind(self) -> str: ...
    @property
    def is_axial(self) -> bool: ...
    @property
    def finest(self) -> float: ...

    def intensity(self, theta: Number, phi: Number) -> Number:
        """Intensity in directions.

        Parameters
        ----------
        theta, phi : float or ndarray [rad]
            Polar angle from the axis, from 0 to pi, and azimuth; broadcast together.

        Returns
        -------
        float or ndarray [cd, W/sr, photon/s/sr or 1]
            0 or more.
        """
        ...

    def flux(self, polar: Interval = ALL_POLAR, azimuth: Interval = ALL_AZIMUTHS) -> Integral:
        """Integral of the intensity over all directions, or a part of them.

        Parameters
        ----------
        polar, azimuth : tuple of 2 floats [rad], optional
            Between which polar angles and azimuths; all of them by default.

        Returns
        -------
        Integral
            flux [lm, W, photon/s or sr] and an estimate of its error.
        """
        ...

    def peak(self) -> Peak:
        """The greatest intensity, and where it is."""
        ...


def integrated(
    distribution: Integrable,
    polar: Interval,
    azimuth: Interval,
    accuracy: float,
    steps: Steps = ((), ()),
) -> Integral:
    """Flux between polar angles and azimuths, by cubature.

    Parameters
    ----------
    distribution : Distribution
        Of any form; no more than its intensity is needed, and whether it is axial.
    polar, azimuth : tuple of 2 floats [rad]
        Between which to integrate.
    accuracy : float [1]
        Error that is good enough, relative to the flux; a larger one, up to 1e-3, is put up with
        where edges across the angles leave it.
    steps : tuple of 2 sequences of float [rad], optional
        Polar angles and azimuths between those at which it is known to have a step.

    Returns
    -------
    Integral
        Flux and error; a part without light, at all points of a fine grid, has none.

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
    """The middles of so many parts of an interval; at its ends rounding may leave some light."""
    return low + (high - low) * (numpy.arange(count) + 0.5) / count


# Polar angles and azimuths of the grid that tells whether there is light.
NO_LIGHT, DARK_AXIAL = (361, 361), (20_000, 1)


def last_where(holds: Callable[[Any], Any], inside: float, outside: float) -> float:
    """The last number from one at which a condition holds towards one at which it does not.

    Parameters
    ----------
    holds : callable
        Takes an array of numbers and gives an array of truth values.
    inside, outside : float
        Where it holds, and where it does not.

    Returns
    -------
    float
        To the digits of a float, by looking ever closer at many numbers at once; as
        `radcalc.maths.limit` does at one.

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


CLOSER = 65  # numbers that are looked at between two
NARROWER = 9  # times, each 64 times as close
