"""Special functions of the closed forms of this package, to full precision for every argument.

Differences of nearly equal numbers are summed as series for small arguments.  All arguments and
results are dimensionless floats or NumPy arrays.
"""

import math

from radcalc.errors import ConditionError
from radcalc.maths import Number, any_true, asin, atan, piecewise, power, sqrt

SMALL = 0.25  # [1] below this a series keeps the digits that a difference would lose
TERMS = 14  # of a series: SMALL**(2 * TERMS) is below the rounding


def cel(kc: Number, p: Number, a: Number, b: Number) -> Number:
    """Return Bulirsch's general complete elliptic integral.

    Parameters
    ----------
    kc : float or ndarray
        Complementary modulus, above 0; at 0 the integral is infinite.
    p : float or ndarray
        Characteristic, above 0; Legendre's n is 1 - p.
    a, b : float or ndarray
        Coefficients of cos^2 and sin^2 in the numerator.

    Returns
    -------
    float or ndarray
        The integral; arrays are broadcast together.

    Raises
    ------
    ConditionError
        If an argument is out of range.

    Notes
    -----
    ::

        cel(kc, p, a, b) = integral from 0 to pi/2 of
            (a cos^2(t) + b sin^2(t)) / ((cos^2(t) + p sin^2(t)) sqrt(cos^2(t) + kc^2 sin^2(t))) dt

    (DLMF 19.2.11, over all t).  Legendre's integrals of the modulus k, k^2 = 1 - kc^2, are
    K = cel(kc, 1, 1, 1), E = cel(kc, 1, 1, kc^2) and Pi(n, k) = cel(kc, 1 - n, 1, 1).

    Bartky's transformation: each step replaces 1 and kc by multiples of their arithmetic and
    geometric means.  It stops when these agree to a relative 1e-9, because the next step doubles
    the number of digits.

    References
    ----------
    .. [1] R. Bulirsch, Numerical Calculation of Elliptic Integrals and Elliptic Functions, Numer.
       Math. 7 (1965) 78, doi:10.1007/BF01397975, and III, 13 (1969) 305, doi:10.1007/BF02165405.
    .. [2] NIST Digital Library of Mathematical Functions, 19.2(iii).

    Examples
    --------
    For kc = 1 the root is 1, and K is pi/2; for kc = 1/sqrt(2) it is 1.8540746773, the quarter
    period of the lemniscate functions times sqrt(2):

    >>> import math
    >>> from radcalc.geometry.numerics.special import cel
    >>> round(cel(1.0, 1.0, 1.0, 1.0) / (math.pi / 2), 12)
    1.0
    >>> round(cel(math.sqrt(0.5), 1.0, 1.0, 1.0), 10)
    1.8540746773
    """
    if any_true((kc <= 0) | (p <= 0)):
        raise ConditionError("the elliptic integral is infinite", "kc and p above 0")
    p = sqrt(p)
    return _transformed(a, b / p, p, kc, 1.0, kc)


def _transformed(
    a: Number, b: Number, p: Number, product: Number, mean: Number, root: Number
) -> Number:
    """Transform `cel` until the means agree, each element of an array as often as a float."""
    a, b = a + b / p, 2 * (b + a * (product / p))
    p = p + product / p
    before, mean = mean, mean + root

    def transform_again(a: Number, b: Number, p: Number, product: Number, mean: Number) -> Number:
        root = 2 * sqrt(product)
        return _transformed(a, b, p, root * mean, mean, root)

    def settled(a: Number, b: Number, p: Number, product: Number, mean: Number) -> Number:
        return math.pi / 2 * (b + a * mean) / (mean * (mean + p))

    return piecewise(
        abs(before - root) > 1e-9 * before, transform_again, settled, a, b, p, product, mean
    )


def less_arctangent(x: Number) -> Number:
    """Return x - arctan(x), without loss of digits for small x.

    Parameters
    ----------
    x : float or ndarray
        0 or more.

    Returns
    -------
    float or ndarray
        0 or more; x^3/3 for small x.

    Notes
    -----
    Below 0.25 the series x^3/3 - x^5/5 + x^7/7 - ..., because the difference would lose up to all
    digits; above, the difference.

    Examples
    --------
    >>> import math
    >>> from radcalc.geometry.numerics.special import less_arctangent
    >>> round(less_arctangent(1.0), 12) == round(1 - math.pi / 4, 12)
    True
    >>> f"{less_arctangent(1e-6):.6e}"
    '3.333333e-19'
    """

    def series(x: Number) -> Number:
        total = 0.0
        for n in range(2 * TERMS + 1, 1, -2):  # x^3/3 - x^5/5 + ...
            total = 1 / n - x * x * total
        return power(x, 3) * total

    return piecewise(x < SMALL, series, lambda x: x - atan(x), x)


def arc_excess(s: Number) -> Number:
    """Return arcsin(s)/s - 1, the relative excess of an arc over the sine of its angle.

    Parameters
    ----------
    s : float or ndarray
        From 0 to 1.

    Returns
    -------
    float or ndarray
        From 0 to pi/2 - 1; s^2/6 for small s.

    Notes
    -----
    Below 0.25 the series s^2/6 + 3 s^4/40 + ..., because the difference would lose up to all
    digits; above, the difference.

    Examples
    --------
    >>> import math
    >>> from radcalc.geometry.numerics.special import arc_excess
    >>> round(arc_excess(1.0), 12) == round(math.pi / 2 - 1, 12)
    True
    >>> f"{arc_excess(1e-6):.6e}"
    '1.666667e-13'
    """

    def series(s: Number) -> Number:
        total, weight = 0.0, 1.0
        for k in range(1, TERMS):
            weight = weight * (2 * k - 1) / (2 * k) * s * s
            total = total + weight / (2 * k + 1)
        return total

    return piecewise(s < SMALL, series, lambda s: asin(s) / s - 1, s)
