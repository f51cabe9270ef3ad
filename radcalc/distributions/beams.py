"""Beam angles and field angles: the width of the light in a plane through the axis.

Two definitions are in use, which differ if the intensity is not greatest on the axis; see `Beam`.
The share of the intensity is one half for the beam angle and one tenth for the field angle.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy

from radcalc.distributions.distribution import Distribution, last_where

STEPS = 3600  # samples of a half plane, from the axis to the opposite direction
DIFFER = math.radians(2)  # a larger difference between the definitions is reported


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

    >>> from radcalc.distributions.shapes import Lobe
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
