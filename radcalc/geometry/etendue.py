"""Etendue (geometric extent, CIE e-ILV 17-21-047) of beams between simple shapes [m^2 sr].

The etendue of a beam is the integral of its cross-section over solid angle::

    G = integral of  dA1 cos(theta1) dA2 cos(theta2) / r^2  =  integral of  dA cos(theta) dOmega

A uniform radiance (or luminance) L sends the flux Phi = L G.  For a small patch, G is its area
times the projected solid angle of what it sees (`radcalc.geometry.projected`).

Lengths are in metres, areas in square metres, angles in radians, and any other unit of length
gives G in its square times sr.  Arguments are floats or NumPy arrays, broadcast together.  All
beams are in a medium of refractive index 1 (in another, n^2 G is what refraction conserves).
"""

import math

from radcalc.geometry import projected
from radcalc.geometry.solid import facing, refuse
from radcalc.maths import Number, hypot, larger, power_of_two, sqrt


def patch_and_cone(area: Number, half_angle: Number) -> Number:
    """Etendue of a flat patch and a circular cone of directions about its normal.

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
        If a half angle is outside 0 to pi/2: a surface neither sends nor receives light past its
        horizon.

    Notes
    -----
    ::

        G = pi A sin^2(alpha)

    Exact for every half angle, if every point of the patch has the same cone.

    References
    ----------
    .. [1] CIE e-ILV 17-21-047, geometric extent.

    Examples
    --------
    2 m^2 and a cone of half angle 30 degrees, pi/2 m^2 sr:

    >>> import math
    >>> from radcalc.geometry import etendue
    >>> round(etendue.patch_and_cone(2.0, math.radians(30)) / math.pi, 12)
    0.5
    """
    refuse(
        (half_angle < 0) | (half_angle > math.pi / 2 * (1 + 1e-12)),
        "a surface neither sends nor sees light past its horizon",
        "a half angle from 0 to 90 deg",
    )
    return area * projected.cone(half_angle)


def patch_and_aperture(area: Number, na: Number) -> Number:
    """Etendue of a flat patch, such as the core of a fibre, and a numerical aperture in air.

    Parameters
    ----------
    area : float or ndarray [m^2]
        Area A of the patch.
    na : float or ndarray [1]
        Numerical aperture NA = sin(alpha), above 0 and at most 1.

    Returns
    -------
    float or ndarray [m^2 sr]
        Geometric extent G.

    Raises
    ------
    ConditionError
        If a numerical aperture is not above 0, or is above 1, which no cone in air has.

    Notes
    -----
    ::

        G = pi A NA^2

    Exact, if every point of the patch has the same cone.

    References
    ----------
    .. [1] CIE e-ILV 17-21-047, geometric extent.

    Examples
    --------
    2 m^2 and a numerical aperture of 0.5, which is a cone of half angle 30 degrees:

    >>> import math
    >>> from radcalc.geometry import etendue
    >>> round(etendue.patch_and_aperture(2.0, 0.5) / math.pi, 12)
    0.5
    """
    refuse(
        (na <= 0) | (na > 1),
        "that numerical aperture is not possible",
        "above 0 and, in air, at most 1",
    )
    return math.pi * area * na**2


def patch_and_lens(area: Number, f_number: Number) -> Number:
    """Etendue of a patch in the focal plane of a lens, from the lens's f-number.

    Parameters
    ----------
    area : float or ndarray [m^2]
        Area A of the patch, at the lens's axis (such as a pixel or a film).
    f_number : float or ndarray [1]
        F-number N, the focal length over the diameter of the entrance pupil; 0.5 or more.

    Returns
    -------
    float or ndarray [m^2 sr]
        Geometric extent G.

    Raises
    ------
    ConditionError
        If an f-number is below 0.5, where the sine would be above 1.

    Notes
    -----
    ::

        G = pi A / (4 N^2),  sin(alpha) = 1/(2 N)

    Exact for a lens without losses that is focused at infinity and corrected for coma, so that it
    meets Abbe's sine condition.  With tan(alpha) = 1/(2 N), as for a thin lens drawn with straight
    rays, G would be pi A / (4 N^2 + 1); they differ by 1 % at f/5 and by 6 % at f/2.

    References
    ----------
    .. [1] CIE e-ILV 17-21-047, geometric extent.

    Examples
    --------
    At f/1 the cone has a half angle of 30 degrees, sin(alpha) = 1/2:

    >>> import math
    >>> from radcalc.geometry import etendue
    >>> round(etendue.patch_and_lens(2.0, 1.0) / math.pi, 12)
    0.5
    """
    refuse(f_number < 0.5, "that f-number is not possible", "0.5 or more, in air")
    return math.pi * area / (4 * f_number**2)


def two_patches(
    area: Number, other: Number, distance: Number, tilt: Number = 0.0, incidence: Number = 0.0
) -> Number:
    """Etendue of two flat patches that are small beside their distance.

    Parameters
    ----------
    area, other : float or ndarray [m^2]
        Areas A1 and A2.
    distance : float or ndarray [m]
        Distance d between the patches, above 0.
    tilt : float or ndarray [rad], optional
        Angle t1 between the first patch's normal and the line to the second; 0 by default.
    incidence : float or ndarray [rad], optional
        Angle t2 between the second patch's normal and the line to the first; 0 by default.

    Returns
    -------
    float or ndarray [m^2 sr]
        Geometric extent G; 0 if one of the patches shows its edge or its back.

    Raises
    ------
    ConditionError
        If a distance is not above 0.

    Notes
    -----
    ::

        G = A1 cos(t1) A2 cos(t2) / d^2

    The first term of a series in size over distance.  For two facing discs of radius R it is too
    large by about the relative 2 (R/d)^2, which is 2 % at a distance of five diameters; see
    `coaxial_discs`.

    References
    ----------
    .. [1] CIE e-ILV 17-21-047, geometric extent.

    Examples
    --------
    2 m^2 and 3 m^2 at 10 m, both turned by 60 degrees: 2 * 0.5 * 3 * 0.5 / 100.

    >>> import math
    >>> from radcalc.geometry import etendue
    >>> round(etendue.two_patches(2.0, 3.0, 10.0, math.radians(60), math.radians(60)), 12)
    0.015
    """
    refuse(distance <= 0, "the patches touch", "a distance above 0")
    return area * facing(tilt) * other * facing(incidence) / distance**2


def coaxial_discs(radius: Number, other: Number, distance: Number) -> Number:
    """Etendue of two parallel discs on one axis, at any distance.

    Parameters
    ----------
    radius, other : float or ndarray [m]
        Radii r1 and r2 of the discs.
    distance : float or ndarray [m]
        Distance d between their planes, above 0.

    Returns
    -------
    float or ndarray [m^2 sr]
        Geometric extent G; the same from either disc.

    Raises
    ------
    ConditionError
        If a distance is not above 0.

    Notes
    -----
    ::

        G = (pi^2 / 2) (S - sqrt(S^2 - 4 r1^2 r2^2)),  S = r1^2 + r2^2 + d^2

    Exact.  It is computed as 2 pi^2 r1^2 r2^2 / (S + root), as the difference loses the digits of
    small discs, and with root = sqrt(d^2 + (r1 - r2)^2) sqrt(d^2 + (r1 + r2)^2), as its radicand
    does those of close discs.  The form factor from the first disc to the second is G/(pi A1).

    References
    ----------
    .. [1] J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-41.

    Examples
    --------
    The form factor from a disc of radius 0.1 m to one of 0.2 m at 0.5 m is published as 0.1339 (EES
    heat transfer library, F3D_3):

    >>> import math
    >>> from radcalc.geometry import etendue
    >>> area = math.pi * 0.1**2
    >>> round(etendue.coaxial_discs(0.1, 0.2, 0.5) / (math.pi * area), 4)
    0.1339

    Two unit discs at a distance of 1: S = 3, G = (pi^2/2) (3 - sqrt(5)).

    >>> round(etendue.coaxial_discs(1.0, 1.0, 1.0), 6)
    3.769853
    >>> round(math.pi**2 / 2 * (3 - math.sqrt(5)), 6)
    3.769853
    """
    refuse(distance <= 0, "the discs touch", "a distance above 0")
    scale = power_of_two(larger(larger(radius, other), distance))
    radius, other, distance = radius / scale, other / scale, distance / scale
    root = hypot(distance, radius - other) * hypot(distance, radius + other)
    total = radius**2 + other**2 + distance**2
    return 2 * (math.pi * (radius * (other / sqrt(total + root))) * scale) ** 2
