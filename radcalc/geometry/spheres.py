"""Spheres seen from outside: angular radius [rad], solid angle [sr] and their inverses.

A sphere fills the cone that touches it.  Units and arguments are those of `radcalc.geometry.solid`.
"""

from radcalc.errors import ConditionError, Try, add
from radcalc.geometry.cones import FULL, bounded, cone, refuse
from radcalc.maths import Number, any_true, atan2, is_array, sqrt


@bounded
def angular_radius(radius: Number, distance: Number) -> Number:
    """Return the angular radius of a sphere: the half angle of the cone that touches it.

    Parameters
    ----------
    radius : float or ndarray [m]
        Radius R of the sphere, 0 or more.
    distance : float or ndarray [m]
        Distance D from the observer to the *centre* of the sphere, above `radius`.

    Returns
    -------
    float or ndarray [rad]
        From 0 to below pi/2.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        sin(alpha) = R / D,  computed as  alpha = atan2(R, sqrt((D - R)(D + R)))

    Exact.  (A flat disc of the same radius and distance has tan(alpha) = R/D.)  The arctangent with
    D - R keeps the digits close to the surface.

    Examples
    --------
    >>> import math
    >>> round(math.degrees(angular_radius(1.0, 2.0)), 12)
    30.0
    """
    refuse((radius < 0), "the radius is out of range", "0 or more")
    if any_true(distance <= radius):
        raise ConditionError(
            "the observer is on or inside the sphere",
            "a distance to the centre greater than the radius; from its surface, the sphere fills "
            "2 pi sr",
            _from_surface(radius, distance),
        )
    # R / sqrt(D^2 - R^2), which keeps its digits up to the surface
    return atan2(radius, sqrt(distance - radius) * sqrt(distance + radius))


def _from_surface(radius: Number, distance: Number) -> list[Try]:
    """Propose the distance to the centre, if the given one was measured from the surface."""
    if is_array(radius) or is_array(distance):
        return []
    remark = f"if {distance:g} m is the distance from the surface"
    return [add("distance", f"{radius + distance:.6g}m", remark)]


def solid_angle(radius: Number, distance: Number) -> Number:
    """Return the solid angle of a sphere seen from outside.

    Parameters
    ----------
    radius, distance : float or ndarray [m]
        As in `angular_radius`.

    Returns
    -------
    float or ndarray [sr]
        From 0 to below 2 pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega = 2 pi (1 - sqrt(1 - (R/D)^2)) = 4 pi sin^2(alpha/2),  sin(alpha) = R/D

    Exact; the second form is computed, by `angular_radius` and `cone`, because the first loses the
    digits of small and distant spheres.

    Examples
    --------
    The sun at its mean distance (radius 695 700 km, 1 au):

    >>> f"{solid_angle(695_700e3, 149_597_870_700.0):.3e}"
    '6.794e-05'
    """
    return cone(angular_radius(radius, distance))


def _sine(solid_angle: Number) -> Number:
    """Return the sine of the half angle of a sphere's cone, from its solid angle.

    With p = Omega/(4 pi) = sin^2(alpha/2), sin(alpha) = 2 sqrt(p (1 - p)).
    """
    part = solid_angle / FULL
    refuse(
        (part <= 0) | (part >= 0.5),
        "the solid angle is out of range for a sphere seen from outside",
        "more than 0 and less than 2pi sr",
    )
    return 2 * sqrt(part) * sqrt(1 - part)


@bounded
def distance_of(radius: Number, solid_angle: Number) -> Number:
    """Return the distance of the centre of a sphere that fills a given solid angle.

    Parameters
    ----------
    radius : float or ndarray [m]
        Radius R of the sphere, in any unit of length.
    solid_angle : float or ndarray [sr]
        Solid angle Omega of the sphere, above 0 and below 2 pi.

    Returns
    -------
    float or ndarray [m]
        Distance from the observer to the *centre*, in the unit of `radius`.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        D = R / sin(alpha),  sin(alpha) = 2 sqrt(p (1 - p)),  p = Omega / (4 pi)

    Exact.

    Examples
    --------
    >>> import math
    >>> from radcalc.geometry import cones
    >>> round(distance_of(1.0, cones.cone(math.radians(30))), 12)
    2.0
    """
    return radius / _sine(solid_angle)


@bounded
def radius_of(distance: Number, solid_angle: Number) -> Number:
    """Return the radius of a sphere that fills a given solid angle at a given distance.

    Parameters
    ----------
    distance : float or ndarray [m]
        Distance D from the observer to the *centre* of the sphere, in any unit of length.
    solid_angle : float or ndarray [sr]
        As in `distance_of`.

    Returns
    -------
    float or ndarray [m]
        Radius, in the unit of `distance`.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        R = D sin(alpha),  sin(alpha) = 2 sqrt(p (1 - p)),  p = Omega / (4 pi)

    Exact.

    Examples
    --------
    >>> import math
    >>> from radcalc.geometry import cones
    >>> round(radius_of(2.0, cones.cone(math.radians(30))), 12)
    1.0
    """
    return distance * _sine(solid_angle)
