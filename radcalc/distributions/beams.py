"""Beam angles and field angles: how wide the light is in a plane through the axis.

Two definitions are in use, and differ where a distribution is not greatest on its axis:

- the outermost directions that have a share of the plane's greatest intensity
- the first directions, counted from the axis, that are down to a share of the axial intensity

The share is a half for the beam angle and a tenth for the field angle.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy

from radcalc.distributions.distribution import Distribution, last_where

STEPS = 3600  # in which a half of a plane is looked at, from the axis to the direction behind it
DIFFER = math.radians(2)  # from which on the definitions are said to differ


class Beam(NamedTuple):
    """A full angle in one plane, by both definitions.

    Attributes
    ----------
    outermost : float [rad] or None
        Between the outermost directions with the share of the plane's greatest intensity; None
        where there are none, as in a uniform light.
    from_axis : float [rad] or None
        Between the first directions from the axis with the share of the axial intensity; None
        where there are none, or no light on the axis.
    is_ambiguous : bool
        Whether the two differ by more than 2 degrees, or one of them does not exist.
    edges : tuple of 2 floats [rad] or None
        Where the outermost directions are: angles from the axis towards the azimuth, negative
        towards the opposite one.

    References
    ----------
    .. [1] CIE e-ILV 17-27-077, beam angle (to half of the maximum or of the axial intensity).

    Examples
    --------
    >>> Beam(1.0, None, True).is_ambiguous
    True
    """

    outermost: float | None
    from_axis: float | None
    is_ambiguous: bool
    edges: tuple[float, float] | None = None


def beam(distribution: Distribution, azimuth: float, share: float) -> Beam:
    """The full angle in the plane of an azimuth and the one opposite.

    Parameters
    ----------
    distribution : Distribution
        Of any form.
    azimuth : float [rad]
        Azimuth of a half of the plane: 0 for C0-C180, pi/2 for C90-C270.
    share : float [1]
        Of the intensity: 1/2 for the beam angle, 1/10 for the field angle.

    Returns
    -------
    Beam
        The angle by both definitions.

    Examples
    --------
    A Lambertian surface is down to a half at 60 degrees:

    >>> from radcalc.distributions.shapes import Lobe
    >>> beam_angle = beam(Lobe(1.0), 0.0, 0.5)
    >>> round(math.degrees(beam_angle.outermost), 9), beam_angle.is_ambiguous
    (120.0, False)
    """
    angle = numpy.linspace(-math.pi, math.pi, 2 * STEPS + 1)

    def along(angle: Any) -> Any:
        """Intensity in the plane, by the angle from the axis; negative on the opposite side."""
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
    """The outermost angles with a level of intensity, or the first ones on both sides of a start.

    None where there is no light, or where the light goes all the way round.
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
