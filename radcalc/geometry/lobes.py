"""A lobe: an intensity that falls off from its axis as a power of the cosine.

Angles in radians; floats or arrays.
"""

import math

from radcalc.maths import Number, asin, expm1, log1p, piecewise, sin


def ln_cos(angle: Number) -> Number:
    """ln cos(angle), to full precision for small angles."""
    return log1p(-2 * sin(angle / 2) ** 2)


def exponent(full_angle: Number, share: float) -> Number:
    """The exponent of a lobe that is down to a share of its peak at half of a full angle."""
    return math.log(share) / ln_cos(full_angle / 2)


def angle(exponent: Number, share: float) -> Number:
    """The full angle at whose edge a lobe is down to a share of its peak."""
    fall = piecewise(
        exponent > 0, lambda n: expm1(math.log(share) / n), lambda n: n - 1.0, exponent
    )
    return 4 * asin((-fall / 2) ** 0.5)  # 1 - cos(x) = 2 sin^2(x/2)


def part(exponent: Number, within: Number) -> Number:
    """The part of a lobe's flux within an angle from its axis: 1 - cos^(n+1)."""
    return piecewise(
        within < math.pi / 2,
        lambda w, n: -expm1((n + 1) * ln_cos(w)),
        lambda w, n: 1.0 + 0 * (w + n),
        within,
        exponent,
    )
