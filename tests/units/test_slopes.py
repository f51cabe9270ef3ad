"""Slopes and corners of numbers, compared with closed forms."""

import math

import pytest

from radcalc.units.functions import sharpest, slopes

SMALL = 0.02  # of a change of 1: what is left of the curvature of a smooth number


@pytest.mark.parametrize(
    ("at", "corner"),
    [
        (lambda t: 3 * t + 1, 0),
        (lambda t: t * t, 0),
        (math.exp, 0),
        (lambda t: 1 / (2 + t) ** 2, 0),
        (lambda t: max(t, 0) + 1e-9 * math.sin(1e9 * t), 1),  # with noise of an integration
        (abs, 2),
        (lambda t: max(0, t - 0.77), 1),
        (lambda t: min(3 * t, 1 + t), 2),
    ],
)
def test_the_change_of_the_slope_at_a_corner_is_found(at, corner):
    """The nearest of the points is within half a step, where half of the change is seen."""
    assert corner / 2 - SMALL <= sharpest(at) <= corner + SMALL


@pytest.mark.parametrize("jump", [-1, -0.99, -0.3, 0, 0.123, 0.5, 1])
def test_a_jump_is_a_large_change_of_the_slope(jump):
    assert sharpest(lambda t: float(t >= jump) if jump > 0 else float(t > jump)) > 500


def test_a_pole_is_an_infinite_change():
    assert sharpest(lambda t: 1 / t if t else None) == math.inf


def test_the_slopes_of_several_numbers():
    def at(shift):
        x = 2 + shift
        return {"square": x * x, "root": math.sqrt(x), "log": math.log(x)}

    for off in (1.9, 0.1, 1e-9):
        found = slopes(at, at(0), 2.0, off)
        expected = {"square": 4, "root": 0.5 / math.sqrt(2), "log": 0.5}
        assert found == pytest.approx(expected, rel=1e-9)


def test_slopes_next_to_a_limit_are_taken_within_the_uncertainty():
    def at(shift):
        return {"": (1 - shift) ** 2} if abs(shift) <= 1e-9 else {}

    assert slopes(at, {"": 1.0}, 1.0, 1e-9)[""] == pytest.approx(-2, rel=1e-5)


def test_a_number_that_a_point_lacks_has_no_slope():
    assert slopes(lambda shift: {"": 1.0} if shift < 0 else {}, {"": 1.0}, 1.0, 0.1) == {"": None}
