"""Numerical integrals of functions of one variable: fixed rules, and an adaptive one."""

import math
from collections.abc import Callable

from radcalc.errors import ConditionError

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

    >>> from radcalc.geometry.numerics.quadrature import gauss
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

    >>> from radcalc.geometry.numerics.quadrature import lobatto
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
    >>> from radcalc.geometry.numerics.quadrature import integral
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

    >>> from radcalc.geometry.numerics.quadrature import adaptive
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
