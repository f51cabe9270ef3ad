"""Beam angles and field angles: how wide the light is in a plane through the axis.

Two definitions are in use, and differ where a distribution is not greatest on its axis:

- the outermost directions that have a share of the plane's greatest intensity
- the first directions, counted from the axis, that are down to a share of the axial intensity

The share is a half for the beam angle and a tenth for the field angle.
"""

import math
from typing import Any, NamedTuple

import numpy

from radcalc.distributions.distribution import Distribution

STEPS = 3600  # in which a plane is looked at, from the axis to the direction behind it
HALVINGS = 50
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
    >>> found = beam(Lobe(1.0), 0.0, 0.5)
    >>> round(math.degrees(found.outermost), 9), found.is_ambiguous
    (120.0, False)
    """
    theta = numpy.linspace(0.0, math.pi, STEPS + 1)
    sides = [azimuth, azimuth + math.pi]
    values = [distribution.intensity(theta, phi) for phi in sides]
    axial, greatest = float(values[0][0]), max(float(side.max()) for side in values)
    outermost = from_axis = None
    if greatest > 0:
        ends = [
            _crossing(distribution, phi, theta, side >= share * greatest, share * greatest, -1)
            for phi, side in zip(sides, values, strict=True)
        ]
        outermost = _sum(ends)
    if axial > 0:
        ends = [
            _crossing(distribution, phi, theta, side >= share * axial, share * axial, 0)
            for phi, side in zip(sides, values, strict=True)
        ]
        from_axis = _sum(ends)
    differ = outermost is None or from_axis is None or abs(outermost - from_axis) > DIFFER
    return Beam(outermost, from_axis, differ)


def _sum(ends: list[float | None]) -> float | None:
    return None if None in ends else sum(end for end in ends if end is not None)


def _crossing(
    distribution: Distribution, phi: float, theta: Any, bright: Any, level: float, which: int
) -> float | None:
    """The first (0) or the last (-1) angle at which the intensity falls below a level."""
    falls = numpy.flatnonzero(bright[:-1] & ~bright[1:])
    if not len(falls) or (which == 0 and not bright[0]) or (which == -1 and bright[-1]):
        return None
    low, high = float(theta[falls[which]]), float(theta[falls[which] + 1])
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        if distribution.intensity(middle, phi) >= level:
            low = middle
        else:
            high = middle
    return low
