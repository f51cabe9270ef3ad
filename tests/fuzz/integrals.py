"""Integrals over directions of functions with kinks, steps, roots, ridges and peaks.

The integral over the sphere of a function f of the cosine u to any axis is 2 pi times the integral
of f(u) from -1 to 1 (Archimedes: zones of equal height have equal area); for an even function any
hemisphere has half of it.  Over zones f is a function of z, maybe times a function of the azimuth.
The antiderivatives are those of any table.  Comparisons of theta or phi cut the intervals.  The
printed error must cover the true error.
"""

import math
import random
from collections import Counter

from radcalc.errors import ConditionError
from radcalc.geometry.numerics.cubature import over_directions
from radcalc.geometry.numerics.expression import Expression

SHORT, LONG = 12, 2000
PI, TURN = math.pi, 2 * math.pi


def above(c, p):
    """Return the antiderivative of (u - c)^p for u above c, and 0 below."""
    return lambda u: max(u - c, 0.0) ** (p + 1) / (p + 1)


def both(c, p):
    """Return the antiderivative of |u - c|^p."""
    return lambda u: math.copysign(abs(u - c) ** (p + 1) / (p + 1), u - c)


def shape(rng):
    """Draw a function of U, as a text, and its antiderivative."""
    c = rng.choice([rng.uniform(-0.99, 0.99), rng.uniform(-0.05, 0.05), 0.0])
    p, w, k = rng.choice([1.5, 2, 3]), 10 ** rng.uniform(-2, 0), 10 ** rng.uniform(-1, 3.3)
    degree, root_pi = rng.randint(0, 6), math.sqrt(PI)
    return rng.choice(
        [
            (f"max(U-({c}),0)", above(c, 1)),
            (f"abs(U-({c}))", both(c, 1)),
            (f"(U>({c}))", above(c, 0)),
            (f"({c}<U<={c + w})", lambda u: min(max(u - c, 0.0), w)),
            (f"sqrt(abs(U-({c})))", both(c, 0.5)),
            (f"max(U-({c}),0)**{p}", above(c, p)),
            (f"exp(-((U-({c}))/{w})**2)", lambda u: w * root_pi / 2 * math.erf((u - c) / w)),
            (f"exp({k}*(U-1))", lambda u: math.exp(k * (u - 1)) / k),
            (f"U**{degree}", lambda u: u ** (degree + 1) / (degree + 1)),
        ]
    )


def cosine(rng):
    """Draw the cosine to an axis, as a text: any axis, z, x, or an axis near one of these."""
    tilt = rng.choice([1.0, 10 ** rng.uniform(-6, -1), 0.0])
    x, y, z = rng.gauss(0, 1), rng.gauss(0, 1) * tilt, rng.gauss(0, 1) * tilt
    if rng.random() < 0.5:
        x, z = z, x
    length = math.hypot(x, y, z)
    return f"({x / length}*x+({y / length})*y+({z / length})*z)"


def between(f, low, high):
    """Return the difference of an antiderivative, and its rounding error."""
    ends = f(low), f(high)
    return ends[1] - ends[0], 1e-15 * (abs(ends[0]) + abs(ends[1]))


def case(rng):
    """Draw a text, intervals of polar angle and azimuth, the integral, and its rounding error."""
    where = rng.choice(["sphere", "sphere", "hemisphere", "zone", "wedge"])
    polar, azimuth, times, turn, turn_off = (0.0, PI), (0.0, TURN), "1", TURN, 0.0
    low, high = -1.0, 1.0
    if where == "hemisphere":
        polar, low = (0.0, PI / 2), 0.0
    elif where != "sphere":
        start = rng.choice([0.0, rng.uniform(0, 3)])
        polar = start, rng.uniform(start + 0.01, PI)
        low, high = math.cos(polar[1]), math.cos(polar[0])
        if rng.random() < 0.3:
            end = rng.uniform(*polar)
            times, low = f"(theta<{end}*rad)", math.cos(end)
    if where == "wedge":
        azimuth = 0.0, rng.uniform(0.5, TURN)
        part, f = shape(rng)
        last = azimuth[1]
        times += f"*{part}".replace("U", "((phi-1*rad)/(6*rad))")
        if rng.random() < 0.3:
            last = rng.uniform(*azimuth)
            times += f"*({last}*rad>=phi)"
        turn, turn_off = (6 * x for x in between(f, -1 / 6, (last - 1) / 6))
    terms, value, off = [], 0.0, 0.0
    for _ in range(rng.choice([1, 1, 2, 3])):
        part, f = shape(rng)
        factor = rng.choice([1.0, -1.0, rng.uniform(-3, 3)])
        u = {"sphere": cosine(rng), "hemisphere": f"abs({cosine(rng)})"}.get(where, "z")
        terms.append(f"({factor})*{part.replace('U', u)}")
        difference, rounding = between(f, low, high)
        value, off = value + factor * difference, off + abs(factor) * rounding
    off = off * (abs(turn) + turn_off) + abs(value) * turn_off
    return f"({'+'.join(terms)})*({times})", polar, azimuth, value * turn, off


def sweep(count, seed):
    dice = random.Random(seed)
    refused, least = Counter(), math.inf
    for number in range(count):
        text, polar, azimuth, value, rounding = case(dice)
        accuracy = 10 ** dice.uniform(-6, -2)
        shown = number, text, polar, azimuth, accuracy, value
        try:
            expression = Expression(text)
            is_axial = expression.is_axial and dice.random() < 0.8
            steps = expression.steps(polar, azimuth) if dice.random() < 0.8 else ((), ())
            got = over_directions(expression, polar, azimuth, accuracy, 1, is_axial, steps=steps)
        except ConditionError as error:
            # an integrand that is 0 in the whole zone is refused
            if abs(value) > rounding and "does not converge" not in error.message:
                raise AssertionError(shown) from error
            refused[math.floor(math.log10(accuracy))] += 1
            continue
        off = abs(got.value - value) - rounding
        assert off <= got.error, (*shown, got)
        if off > 0:
            least = min(least, got.error / off)
    assert sum(refused.values()) < count / 5, refused
    by = ", ".join(f"1e{power}: {n}" for power, n in sorted(refused.items()))
    return (
        f"the printed error is at least {least:.3g} times the true one; refusals by accuracy: {by}"
    )


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
