"""Heights above a place with a given illuminance, at offsets from 1e-12 m to 1000 m.

With y = h / d the illuminance of a lobe is E = I y^(n + 1) (1 - y^2) / x^2; n = 0 stands for an
isotropic source, a hemisphere and a distribution.  Both zeros in y, found by bisection with 60
digits, are the expected heights.
"""

import random
import sys
from pathlib import Path

import mpmath
from mpmath import mpf

sys.path.append(str(Path(__file__).parent.parent))  # for a script
from fuzz.command import main

from radcalc import Quantity, RadcalcError, point_source

SHORT, LONG = 30, 1000
UNIFORM = (
    {"intensity": "1 cd"},
    {"intensity": "1 cd", "half_angle": "90 deg"},
    {"distribution": "1 cd"},
)


def heights(offset: float, part: float, exponent: float) -> list[float]:
    """Return the heights at which E / I is `part`."""
    with mpmath.workdps(60):
        light = mpf(part) * mpf(offset) ** 2
        cosines = _zeros(light, mpf(exponent))
        return sorted(float(offset * y / mpmath.sqrt(1 - y * y)) for y in cosines)


def _zeros(light: mpf, n: mpf) -> list[mpf]:
    """Return the cosines y of y^(n + 1) (1 - y^2) = light, by bisection of ln(h / x)."""

    def cosine(slope: mpf) -> mpf:
        return 1 / mpmath.sqrt(1 + mpmath.exp(-2 * slope))

    def excess(slope: mpf) -> mpf:
        return (n + 1) * mpmath.log(cosine(slope)) - mpmath.log1p(mpmath.exp(2 * slope)) - wanted

    wanted, top = mpmath.log(light), mpmath.log((n + 1) / 2) / 2
    if excess(top) < 0:
        return []
    zeros = []
    for outside in (mpf(-200), mpf(200)):
        inside = top
        for _ in range(160):
            middle = (outside + inside) / 2
            if excess(middle) >= 0:
                inside = middle
            else:
                outside = middle
        zeros.append(cosine(inside))
    return zeros


def answered(source: dict[str, object], offset: float, part: float) -> list[float]:
    """Return the heights that radcalc gives, the lowest first."""
    try:
        found = point_source(
            offset=Quantity(offset, "m"), illuminance=Quantity(part, "lx"), **source
        )
    except RadcalcError:
        return []
    magnitude = found["height"].to("m").magnitude
    return sorted(map(float, magnitude if getattr(magnitude, "shape", ()) else [magnitude]))


def sweep(count: int, seed: int) -> str:
    rng = random.Random(seed)
    pairs = 0
    for _ in range(count):
        offset, part = 10 ** rng.uniform(-12, 3), 10 ** rng.uniform(-6, 6)
        exponent = rng.choice((0.0, 0.0, 0.0, 0.3, 1.0, 3.0, 80.0))
        source = rng.choice(UNIFORM)
        if exponent:
            source = {"intensity": "1 cd", "exponent": exponent}
        expected, found = heights(offset, part, exponent), answered(source, offset, part)
        case = f"{source} at {offset!r} m, {part!r} lx: {found} instead of {expected}"
        assert len(found) == len(expected), case
        close = (abs(a - b) <= 1e-9 * b for a, b in zip(found, expected, strict=True))
        assert all(close), case
        pairs += len(expected) == 2
    return f"{pairs} pairs of heights, {count - pairs} refused"


if __name__ == "__main__":
    main(sweep, LONG)
