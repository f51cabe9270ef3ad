"""The range of a number, compared with closed forms."""

import math
import random

import pytest

from radcalc.units.slopes import reach

INFINITE = math.inf


def possible(function, holds=lambda t: True):
    """Return the function where a condition is true; None elsewhere, and at its poles."""

    def at(t):
        try:
            return function(t) if holds(t) else None
        except ZeroDivisionError:
            return None

    return at


@pytest.mark.parametrize(
    ("at", "ends"),
    [
        (possible(lambda t: 3 * t + 1), (-2, 4)),
        (possible(lambda t: 5.0), (5, 5)),
        (possible(lambda t: t * t), (0, 1)),
        # a plateau with numerical noise of an integration is not a pole
        (possible(lambda t: max(t, 0) + 1e-9 * math.sin(1e9 * t)), (0, 1)),
        (possible(abs), (0, 1)),
        (possible(lambda t: t**3 - 0.75 * t), (-0.25, 0.25)),  # at both ends and at ±1/2
        (possible(math.exp), (math.exp(-1), math.exp(1))),
        (possible(math.log, lambda t: t > 0), (-INFINITE, 0)),
        (possible(math.sqrt, lambda t: t >= 0), (0, 1)),
        (possible(lambda t: t**0.25, lambda t: t > 0), (0, 1)),
        (possible(lambda t: 1 / (t - 0.3) ** 2), (1 / 1.69, INFINITE)),
        (possible(lambda t: 1 / (t - 0.3)), (-INFINITE, INFINITE)),
        (possible(math.acos, lambda t: t <= 0.5), (math.pi / 3, math.pi)),
    ],
)
def test_the_range_of_a_number_is_found(at, ends):
    assert reach(at) == pytest.approx(ends, rel=1e-7, abs=2e-9)


def test_the_extremum_of_a_parabola_is_found_wherever_it_is():
    rng = random.Random(20261123)
    for _ in range(200):
        top = rng.uniform(-1.5, 1.5)
        ends = [-((end - top) ** 2) for end in (-1, 1)]
        most = 0.0 if abs(top) <= 1 else max(ends)
        found = reach(lambda t, top=top: -((t - top) ** 2))
        assert found == pytest.approx((min(ends), most), rel=1e-12, abs=1e-10)
