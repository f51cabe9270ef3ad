"""Aim of a source, and its rotation about its axis.

In the world +z is up.  By default a source shines down: its axis is -z, its C0 half plane is
towards +x and C90 towards +y.
"""

import math

from radcalc.geometry.directions import (
    Vector,
    components,
    dot,
    from_components,
    plus,
    spherical,
    unit,
)
from radcalc.maths import Number

DOWN: Vector = (0.0, 0.0, -1.0)


class Pose:
    """Rotation from a source's own coordinates into world coordinates.

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

    def __init__(self, aim: Vector = DOWN, rotate: float = 0.0) -> None:
        spherical(*aim)  # raises an error if there is no direction
        axis = unit(aim)
        c0 = (math.cos(rotate), math.sin(rotate), 0.0)
        c90 = (-math.sin(rotate), math.cos(rotate), 0.0)
        self.axes = tuple(_turned(source_axis, axis) for source_axis in (c0, c90, DOWN))

    def angles(self, to: Vector) -> tuple[Number, Number, Number]:
        """Return polar angle and azimuth [rad] in the source's coordinates, and the distance.

        `to` is the world vector from the source to a point; raise a ConditionError if it is 0.
        """
        return spherical(*components(self.axes, to))

    def world(self, direction: Vector) -> Vector:
        """Return a vector in the source's coordinates in world coordinates."""
        return from_components(self.axes, direction)


def _turned(vector: Vector, axis: Vector) -> Vector:
    """Turn a vector by the shortest rotation from straight down to an axis.

    v - (s . v) s / (1 + cos) + 2 (down . v) axis, with s = down + axis.  The z component of s is
    computed without loss of digits, so that the formula holds for an axis close to straight up.
    """
    x, y, z = axis
    up = -(x * x + y * y) / (1 + z) if z > 0 else z - 1
    middle = (x, y, up)
    if not any(middle):
        return (vector[0], -vector[1], -vector[2])
    kept = plus(vector, middle, -dot(middle, vector) / (dot(middle, middle) / 2))
    return plus(kept, axis, 2 * dot(DOWN, vector))
