"""Numerical methods for the geometry: integrals, special functions, expressions.

This module has integrals of functions of one variable, and the special functions of closed forms.

The integrals have fixed rules and an adaptive one.  The special functions have full precision for
every argument: differences of nearly equal numbers are summed as series for small arguments.  Their
arguments and results are dimensionless floats or NumPy arrays.
"""

import math
from collections.abc import Callable

from radcalc.errors import ConditionError
from radcalc.maths import Number, any_true, asin, atan, piecewise, power, sqrt

Rule = tuple[tuple[float, ...], tuple[float, ...]]
_RULES: dict[int, Rule] = {}  # those computed so far, by their number of points
DEEPEST, MOST = 60, 2000  # halvings of an interval, and intervals


def gauss(n: int) -> Rule:
    """Return the nodes and weights of the n-point Gauss-Legendre rule on [-1, 1].

    Parameters
    ----------
    n : int
        Number of points, 1 or more.

    Returns
    -------
    nodes : tuple of n floats
        The zeros of Legendre's polynomial of degree n, from -1 to 1.
    weights : tuple of n floats
        Their weights; the sum is 2.

    Notes
    -----
    Exact for polynomials up to the degree 2n - 1.  The zeros are found by Newton's method from
    cos(pi (i + 3/4)/(n + 1/2)), and each rule is computed only once.

    Examples
    --------
    Two points: -1/sqrt(3) and 1/sqrt(3), both of weight 1.

    >>> from radcalc.geometry.numerics import gauss
    >>> nodes, weights = gauss(2)
    >>> [round(x, 6) for x in nodes], [round(w, 6) for w in weights]
    ([-0.57735, 0.57735], [1.0, 1.0])
    """
    if n not in _RULES:
        nodes, weights = [0.0] * n, [0.0] * n
        for i in range((n + 1) // 2):
            x = math.cos(math.pi * (i + 0.75) / (n + 0.5))
            for _ in range(8):  # more than enough: the digits double each time
                before, p = 1.0, x
                for k in range(2, n + 1):
                    before, p = p, ((2 * k - 1) * x * p - (k - 1) * before) / k
                slope = n * (before - x * p) / ((1 - x) * (1 + x))
                x -= p / slope
            nodes[i], nodes[n - 1 - i] = -x, x
            weights[i] = weights[n - 1 - i] = 2 / ((1 - x) * (1 + x) * slope**2)
        _RULES[n] = tuple(nodes), tuple(weights)
    return _RULES[n]


def lobatto(n: int) -> Rule:
    """Return the nodes and weights of the n-point Gauss-Lobatto rule on [-1, 1], with the ends.

    Parameters
    ----------
    n : int
        Number of points, 2 or more.

    Returns
    -------
    nodes : tuple of n floats
        -1, the zeros of the derivative of Legendre's polynomial of degree n - 1, and 1.
    weights : tuple of n floats
        Their weights; the sum is 2.

    Notes
    -----
    Exact for polynomials up to the degree 2n - 3.  The nodes are found by Newton's method from
    cos(pi i/(n - 1)); the weights are 2/(n (n - 1) P(x)^2), with P of degree n - 1.

    Examples
    --------
    With three points it is Simpson's rule:

    >>> from radcalc.geometry.numerics import lobatto
    >>> nodes, weights = lobatto(3)
    >>> [round(x, 6) for x in nodes], [round(w, 6) for w in weights]
    ([-1.0, 0.0, 1.0], [0.333333, 1.333333, 0.333333])
    """
    nodes, weights = [0.0] * n, [0.0] * n
    for i in range(n):
        x = -math.cos(math.pi * i / (n - 1))
        for _ in range(8):
            before, p = 1.0, x
            for k in range(2, n):
                before, p = p, ((2 * k - 1) * x * p - (k - 1) * before) / k
            x -= (x * p - before) / (n * p)
        nodes[i], weights[i] = x, 2 / (n * (n - 1) * p**2)
    return tuple(nodes), tuple(weights)


def integral(function: Callable[[float], float], low: float, high: float, n: int = 32) -> float:
    """Return the integral of a smooth function over an interval, by one Gauss-Legendre rule.

    Parameters
    ----------
    function : callable
        Takes a float and returns a float.
    low, high : float
        Ends of the interval, in either order.
    n : int, optional
        Number of points.

    Returns
    -------
    float
        The integral from low to high.

    Notes
    -----
    Exact for polynomials up to the degree 2n - 1, and to rounding for functions without kinks,
    poles or narrow peaks close to the interval.  It does not estimate the error; see `adaptive`.

    Examples
    --------
    The integral of the sine over half a turn is 2:

    >>> import math
    >>> from radcalc.geometry.numerics import integral
    >>> round(integral(math.sin, 0.0, math.pi), 12)
    2.0
    """
    middle, half = (low + high) / 2, (high - low) / 2
    nodes, weights = gauss(n)
    return half * math.fsum(
        w * function(middle + half * x) for x, w in zip(nodes, weights, strict=True)
    )


def adaptive(
    function: Callable[[float], float],
    low: float,
    high: float,
    accuracy: float = 1e-13,
    most: int = MOST,
) -> float:
    """Return the integral of a piecewise smooth function, halving the interval where necessary.

    Parameters
    ----------
    function : callable
        Takes a float and returns a float.
    low, high : float
        Ends of the interval.
    accuracy : float, optional
        Largest difference between two halves and their whole, relative to a first estimate of the
        integral of the function's absolute value.
    most : int, optional
        Largest number of intervals.

    Returns
    -------
    float
        The integral from low to high.

    Raises
    ------
    ConditionError
        If the halves still differ after 60 halvings of an interval, or with more than `most`
        intervals.

    Notes
    -----
    A rule of 16 points on an interval is compared with the same rule on its halves; if they differ,
    the halves are halved in turn.  A kink inside the interval costs some 20 halvings, so it is
    better to split the interval there.  A peak between the first points is missed.

    Examples
    --------
    The absolute value of x from -1 to 2, 1/2 + 2:

    >>> from radcalc.geometry.numerics import adaptive
    >>> round(adaptive(abs, -1.0, 2.0), 12)
    2.5
    """
    size = integral(lambda x: abs(function(x)), low, high)
    parts, open_ = [], [(low, high, integral(function, low, high, 16), 0)]
    while open_:
        a, b, whole, depth = open_.pop()
        middle = (a + b) / 2
        left, right = integral(function, a, middle, 16), integral(function, middle, b, 16)
        if abs(left + right - whole) <= accuracy * max(size, abs(left + right)):
            parts.append(left + right)
            continue
        if depth == DEEPEST or len(parts) + len(open_) > most:
            raise ConditionError("the integral does not converge", "less extreme values")
        open_ += [(a, middle, left, depth + 1), (middle, b, right, depth + 1)]
    return math.fsum(parts)


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
    >>> from radcalc.geometry.numerics import cel
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
    >>> from radcalc.geometry.numerics import less_arctangent
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
    >>> from radcalc.geometry.numerics import arc_excess
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
