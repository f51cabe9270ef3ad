"""Lobes: intensity distributions that fall off as a power of the cosine from their axis.

A lobe of exponent n has the intensity I(theta) = I0 cos^n(theta) up to 90 degrees from its axis and
0 beyond.  n = 1 is a Lambertian surface, n = 0 a uniform hemisphere; a spotlight with a beam angle
of 30 degrees has n = 20.  The flux is 2 pi I0 / (n + 1).

Angles are in radians; arguments are floats or NumPy arrays, broadcast together.
"""

import math

from radcalc.geometry.cones import refuse
from radcalc.maths import SLACK, Number, asin, expm1, log1p, piecewise, power, sin, square

SMALLEST = 1e-150  # [rad] full angle whose square a float can hold


def ln_cos(angle: Number) -> Number:
    """Return the natural logarithm of the cosine of an angle.

    Parameters
    ----------
    angle : float or ndarray [rad]
        From -pi/2 to pi/2, both excluded.

    Returns
    -------
    float or ndarray [1]
        0 or less.

    Raises
    ------
    ConditionError
        If an angle is below -pi/2 or above pi/2.

    Notes
    -----
    ::

        ln cos(x) = log1p(-2 sin^2(x/2))

    The cosine of a small angle rounds to 1, and its logarithm would lose all digits.  Close to
    pi/2 the result is as exact as the logarithm of the cosine.

    Examples
    --------
    >>> ln_cos(1e-9)
    -5e-19
    """
    bad = abs(angle) > math.pi / 2
    refuse(bad, "a lobe has no light beyond 90 deg from its axis", "from 0 to 90 deg")
    return log1p(-2 * square(sin(angle / 2)))


def exponent(full_angle: Number, share: float) -> Number:
    """Return the exponent of the lobe that falls to a share of its peak at a given full angle.

    Parameters
    ----------
    full_angle : float or ndarray [rad]
        Full angle between the two directions with that share, above 0 and below pi.
    share : float [1]
        Share of the peak, above 0 and below 1: 1/2 for the beam angle, 1/10 for the field angle.

    Returns
    -------
    float or ndarray [1]
        Exponent n, above 0.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        n = ln(share) / ln(cos(full_angle / 2))

    References
    ----------
    .. [1] CIE e-ILV 17-27-077, beam angle: a full angle, to 50 % of the centre beam intensity.
    .. [2] J. M. Kahn and J. R. Barry, Wireless Infrared Communications, Proc. IEEE 85 (1997) 265,
       doi:10.1109/5.554222.  "Generalized Lambertian" with the order n.

    Examples
    --------
    A Lambertian surface, n = 1, falls to cos(60 deg) = 1/2 at a full angle of 120 degrees:

    >>> round(exponent(math.radians(120), 0.5), 12)
    1.0
    """
    _check_share(share)
    bad = (full_angle <= SMALLEST) | (full_angle >= math.pi)
    refuse(bad, "the full angle is out of range", "more than 0 and less than 180 deg")
    return math.log(share) / ln_cos(full_angle / 2)


def _check_share(share: float) -> None:
    bad = (share <= 0) | (share >= 1)
    refuse(bad, "the share of the peak is out of range", "more than 0 and less than 1")


def angle(exponent: Number, share: float) -> Number:
    """Return the full angle at which a lobe falls to a share of its peak; inverse of `exponent`.

    Parameters
    ----------
    exponent : float or ndarray [1]
        Exponent n of the lobe, 0 or more.
    share : float [1]
        As in `exponent`.

    Returns
    -------
    float or ndarray [rad]
        From 0 to pi; pi for n = 0.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        full_angle = 2 arccos(share^(1/n)) = 4 arcsin(sqrt((1 - share^(1/n)) / 2))

    The second form is computed, with expm1 for the difference.

    References
    ----------
    .. [1] CIE e-ILV 17-27-077, beam angle.

    Examples
    --------
    >>> round(math.degrees(angle(1.0, 0.5)), 10)
    120.0
    """
    _check_share(share)
    _check_exponent(exponent)
    fall = piecewise(
        exponent > 0, lambda n: expm1(math.log(share) / n), lambda n: n - 1.0, exponent
    )
    return 4 * asin(power(-fall / 2, 0.5))  # 1 - cos(x) = 2 sin^2(x/2)


def part(exponent: Number, within: Number) -> Number:
    """Return the share of a lobe's flux within an angle from its axis.

    Parameters
    ----------
    exponent : float or ndarray [1]
        Exponent n of the lobe, 0 or more.
    within : float or ndarray [rad]
        Angle from the axis (a half angle), from 0 to pi.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; 1 for angles from pi/2 on.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Phi(within) / Phi = 1 - cos^(n+1)(within)

    Exact; computed as -expm1((n + 1) ln cos(within)), which keeps the digits of small angles.

    Examples
    --------
    A Lambertian surface sends sin^2(30 deg) = 1/4 of its flux within 30 degrees from its normal:

    >>> round(part(1.0, math.radians(30)), 12)
    0.25
    """
    _check_exponent(exponent)
    bad = (within < 0) | (within > math.pi * (1 + SLACK))
    refuse(bad, "the angle from the axis is out of range", "from 0 to 180 deg")
    return piecewise(
        within < math.pi / 2,
        lambda w, n: -expm1((n + 1) * ln_cos(w)),
        lambda w, n: 1.0 + 0 * (w + n),
        within,
        exponent,
    )


def solid_angle(exponent: Number) -> Number:
    """Return the solid angle that a lobe's whole flux would fill with its peak intensity.

    Parameters
    ----------
    exponent : float or ndarray [1]
        Exponent n of the lobe, 0 or more.

    Returns
    -------
    float or ndarray [sr]
        From above 0 to 2 pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega = Phi / I0 = 2 pi / (n + 1)

    Examples
    --------
    >>> round(solid_angle(1.0), 6)
    3.141593
    """
    _check_exponent(exponent)
    return 2 * math.pi / (exponent + 1)


def _check_exponent(exponent: Number) -> None:
    bad = (exponent < 0) | (exponent == math.inf)
    refuse(bad, "the exponent of the lobe is out of range", "0 or more, and finite")
