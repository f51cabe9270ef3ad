"""Etendue (geometric extent, CIE e-ILV 17-21-047) of beams between simple shapes [m^2 sr].

The etendue of a beam is the integral of its cross-section over solid angle::

    G = integral of  dA1 cos(theta1) dA2 cos(theta2) / r^2  =  integral of  dA cos(theta) dOmega

A uniform radiance (or luminance) L sends the flux Phi = L G.  For a small patch, G is its area
times the projected solid angle of the other surface (`radcalc.geometry.projected`).

Lengths in another unit than metres give G in its square times sr.  Arguments are floats or NumPy
arrays, broadcast together.  All beams are in a medium of refractive index 1 (refraction conserves
n^2 G).
"""

import math

from radcalc.geometry import projected
from radcalc.geometry.cones import bounded, refuse
from radcalc.maths import SLACK, Number, hypot, larger, power_of_two, smaller, sqrt, square


@bounded
def patch_and_cone(area: Number, half_angle: Number) -> Number:
    """Return the etendue of a flat patch and a circular cone of directions about its normal.

    Parameters
    ----------
    area : float or ndarray [m^2]
        Area A of the patch.
    half_angle : float or ndarray [rad]
        Half angle alpha of the cone, from 0 to pi/2.

    Returns
    -------
    float or ndarray [m^2 sr]
        Geometric extent G.

    Raises
    ------
    ConditionError
        If an area is negative, or a half angle is outside 0 to pi/2.

    Notes
    -----
    ::

        G = pi A sin^2(alpha)

    Exact for every half angle, if the cone is the same at every point of the patch.

    References
    ----------
    .. [1] CIE e-ILV 17-21-047, geometric extent.

    Examples
    --------
    >>> round(patch_and_cone(2.0, math.radians(30)) / math.pi, 12)
    0.5
    """
    refuse(
        (half_angle < 0) | (half_angle > math.pi / 2 * (1 + SLACK)),
        "the half angle is out of range: a surface has no light below its horizon",
        "a half angle from 0 to 90 deg",
    )
    refuse(area < 0, "the area is out of range", "0 or more")
    return area * projected.cone(half_angle)


@bounded
def coaxial_discs(radius: Number, other: Number, distance: Number) -> Number:
    """Return the etendue of two parallel discs on one axis, at any distance.

    Parameters
    ----------
    radius, other : float or ndarray [m]
        Radii r1 and r2 of the discs.
    distance : float or ndarray [m]
        Distance d between their planes, above 0.

    Returns
    -------
    float or ndarray [m^2 sr]
        Geometric extent G, the same in both directions.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        G = (pi^2 / 2) (S - sqrt(S^2 - 4 r1^2 r2^2)),  S = r1^2 + r2^2 + d^2

    Exact.  It is computed as 2 pi^2 r1^2 r2^2 / (S + root), with root = sqrt(d^2 + (r1 - r2)^2)
    sqrt(d^2 + (r1 + r2)^2), which keeps the digits of small and of close discs.  The form factor
    from disc 1 to disc 2 is G/(pi A1).

    References
    ----------
    .. [1] J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-41.

    Examples
    --------
    The form factor from a disc of radius 0.1 m to one of 0.2 m at 0.5 m is published as 0.1339 (EES
    heat transfer library, F3D_3):

    >>> area = math.pi * 0.1**2
    >>> round(coaxial_discs(0.1, 0.2, 0.5) / (math.pi * area), 4)
    0.1339
    """
    refuse((radius < 0) | (other < 0), "the radius is out of range", "0 or more")
    refuse(distance <= 0, "the discs touch", "a distance above 0")
    scale = power_of_two(larger(larger(radius, other), distance))
    radius, other, distance = radius / scale, other / scale, distance / scale
    root = hypot(distance, radius - other) * hypot(distance, radius + other)
    total = square(radius) + square(other) + square(distance)
    return 2 * square(math.pi * (radius * (other / sqrt(total + root))) * scale)


@bounded
def discs_distance(radius: Number, other: Number, etendue: Number) -> Number:
    """Return the distance of two parallel discs on one axis from their etendue.

    Parameters
    ----------
    radius, other : float or ndarray [m]
        Radii of the two discs, above 0.
    etendue : float or ndarray [m2 sr]
        Above 0 and below pi times the area of the smaller disc.

    Returns
    -------
    float or ndarray [m]
        Distance of their planes.

    Raises
    ------
    ConditionError
        If discs of these radii do not have such an etendue at any distance.

    Notes
    -----
    ::

        d^2 = (r1^2 - m) (r2^2 - m) / m    with m = G / pi^2

    `coaxial_discs` solved for the distance.

    Examples
    --------
    >>> round(discs_distance(1.0, 2.0, coaxial_discs(1.0, 2.0, 3.0)), 9)
    3.0
    """
    part = _part_of_discs(etendue, smaller(radius, other))
    return sqrt((square(radius) - part) * (square(other) - part) / part)


@bounded
def discs_radius(other: Number, distance: Number, etendue: Number) -> Number:
    """Return the radius of one of two parallel discs on one axis from their etendue.

    Parameters
    ----------
    other : float or ndarray [m]
        Radius r2 of the other disc, above 0.
    distance : float or ndarray [m]
        Distance of their planes, above 0.
    etendue : float or ndarray [m2 sr]
        Above 0 and below pi times the area of the other disc.

    Returns
    -------
    float or ndarray [m]
        Radius of the disc.

    Raises
    ------
    ConditionError
        If no disc at that distance gives such an etendue.

    Notes
    -----
    ::

        r1^2 = m (r2^2 + d^2 - m) / (r2^2 - m)    with m = G / pi^2

    `coaxial_discs` solved for a radius.

    Examples
    --------
    >>> round(discs_radius(2.0, 3.0, coaxial_discs(1.0, 2.0, 3.0)), 9)
    1.0
    """
    refuse(distance <= 0, "the discs touch", "a distance above 0")
    part = _part_of_discs(etendue, other)
    return sqrt(part * (square(other) + square(distance) - part) / (square(other) - part))


def _part_of_discs(etendue: Number, radius: Number) -> Number:
    """Return G / pi^2, which must be less than the square of the smaller radius."""
    refuse(radius < 0, "the radius is out of range", "0 or more")
    part = etendue / math.pi**2
    refuse(
        (part <= 0) | (part >= square(radius)),
        "the etendue is out of range for discs of these radii",
        "an etendue above 0 and below pi times the area of the smaller disc",
    )
    return part
