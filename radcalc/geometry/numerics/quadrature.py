"""Numerical integrals of one variable: Gauss and Legendre's rule, and an adaptive one."""

import math
from collections.abc import Callable

from radcalc.errors import ConditionError

Rule = tuple[tuple[float, ...], tuple[float, ...]]
_RULES: dict[int, Rule] = {}
DEEPEST, MOST = 60, 2000  # halvings of an interval, and intervals


def gauss(n: int) -> Rule:
    """The nodes and weights of the n-point rule of Gauss and Legendre on [-1, 1].

    The nodes are the zeros of Legendre's polynomial, by Newton's method.
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


def integral(function: Callable[[float], float], low: float, high: float, n: int = 32) -> float:
    """The integral of a smooth function of one variable, by the n-point rule."""
    middle, half = (low + high) / 2, (high - low) / 2
    nodes, weights = gauss(n)
    return half * math.fsum(
        w * function(middle + half * x) for x, w in zip(nodes, weights, strict=True)
    )


def adaptive(
    function: Callable[[float], float], low: float, high: float, accuracy: float = 1e-13
) -> float:
    """The integral of a piecewise smooth function, its intervals halved until both halves agree.

    `accuracy` is relative to the integral of the function's size, as the first rules see it.
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
        if depth == DEEPEST or len(parts) + len(open_) > MOST:
            raise ConditionError("the integral does not converge", "less extreme values")
        open_ += [(a, middle, left, depth + 1), (middle, b, right, depth + 1)]
    return math.fsum(parts)
