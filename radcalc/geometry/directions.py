"""Directions: spherical coordinates and Cartesian ones.

The polar angle is counted from +z, the azimuth from +x towards +y, as in ISO 80000-2; the
elevation is what the polar angle lacks of a right angle.
"""

import math

from radcalc.errors import ConditionError
from radcalc.maths import Number, any_true, atan2, cos, hypot, piecewise, sin

TURN = 2 * math.pi


def spherical(x: Number, y: Number, z: Number) -> tuple[Number, Number, Number]:
    """Polar angle [rad], azimuth [rad] from 0 to below 2 pi, and length of a vector.

    On the poles, where every azimuth would do, it is 0.

    Parameters
    ----------
    x, y, z : float or array
        In any one unit, which is the length's.

    Raises
    ------
    ConditionError
        A vector of length 0 has no direction.
    """
    across = hypot(x, y)
    length = hypot(across, z)
    if any_true(length == 0):
        raise ConditionError("0,0,0 has no direction", "a vector that is not zero")
    azimuth = atan2(y, x)
    azimuth = piecewise(azimuth < 0, lambda a: a + TURN, lambda a: a + 0.0, azimuth)
    # a hair below 0 would be rounded to a whole turn
    azimuth = piecewise((azimuth >= TURN) | (across == 0), lambda a: 0.0 * a, lambda a: a, azimuth)
    return atan2(across, z), azimuth, length


def cartesian(polar: Number, azimuth: Number) -> tuple[Number, Number, Number]:
    """The unit vector of a polar angle from 0 to pi and an azimuth [rad]."""
    if any_true((polar < 0) | (polar > math.pi * (1 + 1e-12))):
        raise ConditionError(
            "a polar angle is from 0 to 180 deg", "an elevation is from -90 to 90 deg"
        )
    across = sin(polar)
    return across * cos(azimuth), across * sin(azimuth), cos(polar)
