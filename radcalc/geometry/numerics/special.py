"""Functions that the closed forms of this package rest on, to full precision everywhere."""

import math

from radcalc.maths import Number, any_true, asin, atan, piecewise, sqrt

SMALL = 0.25  # below this a series keeps the digits that a difference would lose
TERMS = 14  # SMALL**(2 * TERMS) is below the rounding


def cel(kc: Number, p: Number, a: Number, b: Number) -> Number:
    """Bulirsch's complete elliptic integral (DLMF 19.2.11 between 0 and infinity).

    The integral of (a cos^2 t + b sin^2 t) / ((cos^2 t + p sin^2 t) sqrt(cos^2 t + kc^2 sin^2 t))
    over t from 0 to pi/2, for kc > 0 and p > 0.  Bartky's transformation: each turn replaces
    1 and kc by multiples of their arithmetic and geometric means and doubles the digits.

    Parameters and result are floats, or arrays that are broadcast together.
    """
    p = sqrt(p)
    b = b / p
    product, mean, root = kc, 1.0, kc
    while True:
        a, b = a + b / p, 2 * (b + a * (product / p))
        p = p + product / p
        before, mean = mean, mean + root
        if not any_true(abs(before - root) > 1e-9 * before):
            return math.pi / 2 * (b + a * mean) / (mean * (mean + p))
        root = 2 * sqrt(product)
        product = root * mean


def less_arctangent(x: Number) -> Number:
    """x - arctan x, for x >= 0."""

    def series(x: Number) -> Number:
        total = 0.0
        for n in range(2 * TERMS + 1, 1, -2):  # x^3/3 - x^5/5 + ...
            total = 1 / n - x * x * total
        return x**3 * total

    return piecewise(x < SMALL, series, lambda x: x - atan(x), x)


def arc_excess(s: Number) -> Number:
    """arcsin(s)/s - 1, for 0 <= s <= 1."""

    def series(s: Number) -> Number:
        total, weight = 0.0, 1.0
        for k in range(1, TERMS):
            weight = weight * (2 * k - 1) / (2 * k) * s * s
            total = total + weight / (2 * k + 1)
        return total

    return piecewise(s < SMALL, series, lambda s: asin(s) / s - 1, s)
