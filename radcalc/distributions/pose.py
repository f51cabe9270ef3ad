"""Where a source stands, where it is aimed, and how it is rotated about its axis.

In the world +z is up.  A source hangs and shines down: its axis is -z, its C0 half plane is
towards +x and C90 towards +y.
"""

import math

from radcalc.geometry.directions import spherical
from radcalc.geometry.numerics.vectors import Vector, components, dot, from_components, plus, unit
from radcalc.maths import Number

DOWN: Vector = (0.0, 0.0, -1.0)


class Pose:
    """A turn from a source's own coordinates into the world's.

    Parameters
    ----------
    aim : tuple of 3 floats, optional
        Direction of the axis, of any length but 0; straight down by default.
    rotate : float [rad], optional
        Angle by which the source is turned about its axis beforehand, as it hangs: C0 from +x
        towards +y.

    Raises
    ------
    ConditionError
        If the aim has no direction.

    Notes
    -----
    From straight down the axis is turned to its aim by the shortest way, about the horizontal line
    across both.  Straight up it is turned about the x axis, so that C0 stays where it is.

    Examples
    --------
    Below it and to the side along x, at 45 degrees from the axis in C0:

    >>> theta, phi, distance = Pose().angles((2.0, 0.0, -2.0))
    >>> round(math.degrees(theta), 9), phi, round(distance, 6)
    (45.0, 0.0, 2.828427)
    """

    def __init__(self, aim: Vector = DOWN, rotate: float = 0.0) -> None:
        spherical(*aim)  # refuses what is no direction
        axis = unit(aim)
        c0 = (math.cos(rotate), math.sin(rotate), 0.0)
        c90 = (-math.sin(rotate), math.cos(rotate), 0.0)
        self.axes = tuple(_turned(source_axis, axis) for source_axis in (c0, c90, DOWN))

    def angles(self, to: Vector) -> tuple[Number, Number, Number]:
        """The source's own angles of a direction in the world, and the length of its vector.

        Parameters
        ----------
        to : tuple of 3 floats or ndarrays [m]
            From the source to a point, not both the same.

        Returns
        -------
        theta : float or ndarray [rad]
            Polar angle from the source's axis.
        phi : float or ndarray [rad]
            Azimuth about it, from C0 towards C90.
        distance : float or ndarray [m]
            Length of the vector.

        Raises
        ------
        ConditionError
            If a point is where the source is.
        """
        return spherical(*components(self.axes, to))

    def world(self, direction: Vector) -> Vector:
        """A vector in the source's own coordinates, as one in the world's.

        Parameters
        ----------
        direction : tuple of 3 floats or ndarrays

        Returns
        -------
        tuple of 3 floats or ndarrays
        """
        return from_components(self.axes, direction)


def _turned(vector: Vector, axis: Vector) -> Vector:
    """A vector, turned as straight down is to an axis by the shortest way.

    v - (s . v) s / (1 + cos) + 2 (down . v) axis, with s = down + axis: of the axis's height over
    straight up only the digits that count are taken, so that it holds next to that.
    """
    x, y, z = axis
    up = -(x * x + y * y) / (1 + z) if z > 0 else z - 1
    middle = (x, y, up)
    if not any(middle):
        return (vector[0], -vector[1], -vector[2])
    kept = plus(vector, middle, -dot(middle, vector) / (dot(middle, middle) / 2))
    return plus(kept, axis, 2 * dot(DOWN, vector))
