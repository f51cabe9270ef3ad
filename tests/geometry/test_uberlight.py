"""The attenuations of the cinematographer's light: values, limits and continuity."""

import math
from itertools import product

import mpmath
import numpy as np
import pytest
from helpers import for_each
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mpf

from radcalc.errors import ConditionError
from radcalc.geometry import models

exponents = st.floats(0.1, 8)
maxima = st.floats(1.001, 1e6)


def test_the_smooth_step_is_the_cubic_with_level_ends():
    # 3 t^2 - 2 t^3, as in the RenderMan Interface
    for t in (0.0, 0.1, 0.25, 0.5, 0.9, 1.0):
        found = models.smoothstep(2.0, 6.0, 2 + 4 * t)
        assert found == pytest.approx(3 * t**2 - 2 * t**3, abs=1e-15)
    assert [models.smoothstep(2.0, 6.0, x) for x in (-9.0, 99.0)] == [0, 1]
    for end, inside in ((2.0, 2.001), (6.0, 5.999)):
        change = models.smoothstep(2.0, 6.0, inside) - models.smoothstep(2.0, 6.0, end)
        assert abs(change) < 1e-6  # 3 t^2 for t = 0.001/4


def test_a_step_without_a_width_is_sharp():
    assert [models.smoothstep(2.0, 2.0, x) for x in (1.999, 2.0, 2.001)] == [0, 1, 1]


@pytest.mark.parametrize(
    ("z", "expected"),
    [(-1, 0), (0, 0), (1, 0), (1.25, 0.15625), (1.5, 0.5), (2, 1), (4, 1), (4.5, 0.84375), (6, 0)],
)
def test_depth_is_clipped_smoothly_at_both_ends(z, expected):
    assert models.depth_clip(float(z), near=(1.0, 2.0), far=(4.0, 6.0)) == expected


@for_each(product([1e-6, 0.01, 0.5, 0.99, 1, 1.01, 3], [0.5, 1, 2, 5], [1.01, 2, 10, 1e4]))
def test_the_fall_off_is_the_formula(d, exponent, maximum):
    with mpmath.workdps(30):
        d, n, top, far = map(mpf, (d, exponent, maximum, 2))
        d *= far
        s = mpmath.log(1 / top)
        held = top * mpmath.exp(s * (d / far) ** (-n / s))
        expected = held if d < far else (far / d) ** n
    found = models.falloff(float(d), float(exponent), 2.0, float(maximum))
    assert found == pytest.approx(float(expected), rel=1e-13)


@given(exponents, maxima, st.floats(0.01, 100))
def test_the_fall_off_and_its_slope_are_continuous(exponent, maximum, far):
    at = models.falloff(far, exponent, far, maximum)
    assert at == pytest.approx(1, abs=1e-12)
    width = 1e-6 * far
    inside, beyond = (
        (models.falloff(far + side * width, exponent, far, maximum) - at) / (side * width)
        for side in (-1, 1)
    )
    # d/dd (L/d)^N = -N/L at L; within L the curvature grows with N^2 / ln M
    bend = 1e-5 * (1 + exponent + exponent / math.log(maximum))
    assert beyond == pytest.approx(-exponent / far, rel=1e-4)
    assert inside == pytest.approx(-exponent / far, rel=1e-4 + bend)


@given(exponents, maxima, st.floats(1e-9, 1))
def test_the_fall_off_exceeds_neither_its_maximum_nor_the_power(exponent, maximum, d):
    found = models.falloff(d, exponent, 1.0, maximum)
    assert 1 - 1e-12 <= found <= maximum * (1 + 1e-12)
    assert found <= d**-exponent * (1 + 1e-12)


def test_a_maximum_of_1_holds_and_a_high_one_has_no_effect():
    assert models.falloff(0.1, 2.0, 1.0, 1.0) == 1
    assert models.falloff(0.1, 2.0, 1.0, 1 + 1e-12) == pytest.approx(1, abs=1e-11)
    assert models.falloff(0.5, 2.0, 1.0, 1e100) == pytest.approx(4, rel=0.01)
    assert models.falloff(0.5, 2.0, 1.0) == 4
    assert models.falloff(1e-30, 2.0, 1.0, 7.0) == pytest.approx(7)


def test_a_power_too_large_for_a_number_is_refused():
    with pytest.raises(ConditionError, match="too large or too small"):
        models.falloff(10.0, 500.0, 1.0)


@given(st.floats(0, 2), st.floats(0, 2))
def test_roundness_1_is_an_ellipse_and_0_a_rectangle(x, y):
    sharp = {"inner": (1.0, 0.5), "outer": (1.0, 0.5)}
    distance = math.hypot(x / 1, y / 0.5)
    if abs(distance - 1) > 1e-9:
        assert models.superellipse_clip(x, y, **sharp, roundness=1.0) == (distance < 1)
    assert models.superellipse_clip(x, y, **sharp, roundness=0.0) == (x < 1 and y < 0.5)


def test_other_shapes_are_between_the_rectangle_and_the_ellipse():
    # through (s, s) of a square of half side 1: 2 s^(2/R) = 1
    for roundness in (0.1, 0.5, 0.9, 1.0):
        s = 0.5 ** (roundness / 2)
        found = models.superellipse_scale(s, s, 1.0, 1.0, roundness)
        assert found == pytest.approx(1, rel=1e-13)
    # towards 0 the scale is the larger coordinate
    assert models.superellipse_scale(0.3, 0.9, 1.0, 1.0, 1e-9) == pytest.approx(0.9, rel=1e-8)


@pytest.mark.parametrize("roundness", [0, 1e-6, 0.3, 1])
def test_along_an_axis_the_soft_edge_does_not_depend_on_the_shape(roundness):
    """On an axis q = a/x and r = A/x, so the step has t = (x - a)/(A - a) for every R."""
    for t in (0.0, 0.1, 0.5, 0.8, 1.0):
        found = models.superellipse_clip(2 + t, 0.0, (2.0, 1.0), (3.0, 4.0), float(roundness))
        assert found == pytest.approx(1 - (3 * t**2 - 2 * t**3), abs=1e-12)


def test_the_soft_corner_of_a_rectangle_multiplies_both_steps():
    # as in uberlight.sl: t = 1/2 in x and in y, (1 - 1/2)^2
    assert models.superellipse_clip(1.5, 1.5, (1.0, 1.0), (2.0, 2.0), 0.0) == 0.25


def test_a_shear_moves_the_centre_of_the_beam():
    x, y = models.cross_section(3.0, -1.0, 2.0, shear=(1.5, -0.5))
    assert (x, y) == (0, 0)
    assert models.superellipse_clip(x, y, (0.1, 0.1), (0.2, 0.2)) == 1


@pytest.mark.parametrize("exponent", [0, 1, 2.5, 40])
def test_the_beam_is_a_power_of_the_cosine(exponent):
    for angle in (0, 1e-9, 0.3, 1.2):
        with mpmath.workdps(30):
            expected = mpmath.cos(mpf(angle)) ** exponent
        found = models.beam(math.sin(angle), 0.0, math.cos(angle), float(exponent))
        assert found == pytest.approx(float(expected), rel=1e-12)
    assert models.beam(1.0, 0.0, 0.0, float(exponent)) == 0
    assert models.beam(0.1, 0.0, -1.0, float(exponent)) == 0


def test_arrays_give_the_same_as_floats():
    rng = np.random.default_rng(5)
    x, y, z = rng.uniform(-2, 2, (3, 200))
    n, far, top = rng.uniform(0, 4, 200), rng.uniform(0.1, 3, 200), rng.uniform(1, 9, 200)
    top[:9] = 1
    roundness = np.where(rng.uniform(size=200) < 0.3, 0, rng.uniform(0, 1, 200))
    d = np.sqrt(x**2 + y**2 + z**2)
    u, v = models.cross_section(x, y, z)
    found = {
        "depth": models.depth_clip(z, (0.1, 0.9), (1.0, 1.8)),
        "beam": models.beam(x, y, z, n),
        "falloff": models.falloff(d, n, far, top),
        "clip": models.superellipse_clip(u, v, (0.4, 0.3), (0.9, 0.8), roundness),
    }
    for k in range(200):
        at = [float(value[k]) for value in (x, y, z)]
        one = {
            "depth": models.depth_clip(at[2], (0.1, 0.9), (1.0, 1.8)),
            "beam": models.beam(*at, float(n[k])),
            "falloff": models.falloff(float(d[k]), float(n[k]), float(far[k]), float(top[k])),
            "clip": models.superellipse_clip(
                *models.cross_section(*at), (0.4, 0.3), (0.9, 0.8), float(roundness[k])
            ),
        }
        for name, value in one.items():
            assert found[name][k] == pytest.approx(value, rel=1e-12, abs=1e-300), (name, k)


def test_between_the_axes_the_scale_is_the_formula():
    # R = 1/2 has the exponent 4: (3^4 + 2^4)^(1/4)
    found = models.superellipse_scale(3.0, -4.0, 1.0, 2.0, 0.5)
    assert found == pytest.approx((3**4 + 2**4) ** 0.25, rel=1e-14)


def test_without_limits_there_is_light_in_front():
    assert [models.depth_clip(z) for z in (1e-9, 0.5, 1e9, 0.0, -0.5)] == [1, 1, 1, 0, 0]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0.0, 2.0, 1.0), "the distance from the light"),
        ((1.0, -2.0, 1.0), "the fall-off exponent"),
        ((1.0, 2.0, 0.0), "the fall-off distance"),
        ((1.0, 2.0, 1.0, 0.9), "the maximum is out of range"),
    ],
)
def test_invalid_fall_offs_are_refused(arguments, message):
    with pytest.raises(ConditionError, match=message):
        models.falloff(*arguments)
    assert models.falloff(2.0, 0.0, 1.0) == 1


def test_a_negative_beam_exponent_is_refused():
    with pytest.raises(ConditionError, match="the beam exponent is out of range"):
        models.beam(0.0, 0.0, 1.0, -1.0)
