"""Spherical coordinates, reflections and axes of directions."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc.errors import ConditionError
from radcalc.geometry import projections

PI = math.pi

DIRECTIONS = [
    ((1.0, 0.0, 0.0), (PI / 2, 0.0, 1.0)), ((0.0, 1.0, 0.0), (PI / 2, PI / 2, 1.0)),
    ((-2.0, 0.0, 0.0), (PI / 2, PI, 2.0)), ((-2.0, -0.0, 0.0), (PI / 2, PI, 2.0)),
    ((0.0, -3.0, 0.0), (PI / 2, 1.5 * PI, 3.0)), ((0.0, 0.0, 5.0), (0.0, 0.0, 5.0)),
    ((0.0, -0.0, -5.0), (PI, 0.0, 5.0)), ((-0.0, 0.0, 5.0), (0.0, 0.0, 5.0)),
    ((1.0, 1.0, math.sqrt(2)), (PI / 4, PI / 4, 2.0)), ((3.0, 4.0, 12.0), (math.atan2(5, 12),
     math.atan2(4, 3), 13.0)), ((1e-300, 0.0, 1.0), (1e-300, 0.0, 1.0)),
    ((1e300, 0.0, 1e300), (PI / 4, 0.0, math.sqrt(2) * 1e300)), ((1.0, -1e-20, 0.0),
     (PI / 2, 0.0, 1.0)),
]  # fmt: skip


@pytest.mark.parametrize(("vector", "angles"), DIRECTIONS)
def test_spherical_coordinates_by_their_definition(vector, angles):
    assert projections.spherical(*vector) == pytest.approx(angles, rel=1e-15)
    arrays = projections.spherical(*(np.array([x, x]) for x in vector))
    assert [float(x[1]) for x in arrays] == pytest.approx(angles, rel=1e-15)


@given(st.floats(1e-9, PI - 1e-9), st.floats(0, 6.28), st.floats(1e-100, 1e100))
def test_a_direction_round_trip(polar, azimuth, length):
    unit = projections.cartesian(polar, azimuth)
    assert sum(x * x for x in unit) == pytest.approx(1, rel=1e-15 * 4)
    got = projections.spherical(*(x * length for x in unit))
    assert got[0] == pytest.approx(polar, rel=1e-14)
    assert got[1] == pytest.approx(azimuth, rel=1e-14, abs=1e-15)
    assert got[2] == pytest.approx(length, rel=1e-14)


@given(*[st.floats(-1e3, 1e3)] * 3)
def test_azimuths_are_within_one_turn(x, y, z):
    if x == y == z == 0:
        return
    polar, azimuth, _ = projections.spherical(x, y, z)
    assert 0 <= polar <= PI
    assert 0 <= azimuth < 2 * PI


# direction, normal, reflection; worked out by hand, the second by a Householder matrix of (1, 1, 1)
REFLECTIONS = [
    ((0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 0.0, 0.0)),
    ((0.0, 0.0, 3.0), (1.0, 1.0, 1.0), (2.0, 2.0, -1.0)),
    ((0.6, 0.0, 0.8), (0.0, 0.0, 1e100), (-0.6, 0.0, 0.8)),
    ((0.0, 0.0, 1.0), (0.6e-200, 0.0, 0.8e-200), (0.96, 0.0, 0.28)),
    ((1.0, 2.0, 0.0), (0.0, 0.0, 1.0), (-1.0, -2.0, 0.0)),
    ((0.0, 0.0, -1.0), (1.0, 0.0, 1.0), (-1.0, 0.0, 0.0)),  # the mirror's back
]


@pytest.mark.parametrize(("direction", "normal", "reflection"), REFLECTIONS)
def test_reflections_by_hand(direction, normal, reflection):
    assert projections.reflected(direction, normal) == pytest.approx(reflection, abs=1e-15)
    arrays = projections.reflected(tuple(np.array([x, -x]) for x in direction), normal)
    assert [float(x[1]) for x in arrays] == pytest.approx([-x for x in reflection], abs=1e-15)


VECTORS = st.tuples(*[st.floats(-1e3, 1e3)] * 3).filter(lambda v: math.hypot(*v) > 1e-3)


@given(VECTORS, VECTORS)
def test_a_reflection_keeps_the_length_and_is_its_own_inverse(direction, normal):
    there = projections.reflected(direction, normal)
    assert math.hypot(*there) == pytest.approx(math.hypot(*direction), rel=1e-14)
    back = projections.reflected(there, normal)
    assert back == pytest.approx(direction, abs=1e-14 * math.hypot(*direction))


@given(VECTORS, VECTORS)
def test_the_normal_of_a_mirror_reflects_one_direction_into_the_other(direction, reflection):
    one, other = math.hypot(*direction), math.hypot(*reflection)
    apart = [a / one + b / other for a, b in zip(direction, reflection, strict=True)]
    if math.hypot(*apart) < 1e-3:  # the normal of a grazing mirror is badly conditioned
        return
    normal = projections.mirror_normal(direction, reflection)
    assert math.hypot(*normal) == pytest.approx(1, rel=1e-15 * 4)
    expected = [x * one / other for x in reflection]
    assert projections.reflected(direction, normal) == pytest.approx(expected, abs=1e-11 * one)


@pytest.mark.parametrize(
    ("function", "vectors", "message"),
    [
        (projections.reflected, ((1.0, 0.0, 0.0), (0.0, 0.0, 0.0)), "0,0,0 has no direction"),
        (projections.mirror_normal, ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)), "0,0,0 has no direction"),
        (projections.mirror_normal, ((1.0, 0.0, 0.0), (0.0, 0.0, 0.0)), "0,0,0 has no direction"),
        (projections.mirror_normal, ((1.0, 2.0, 0.0), (-2.0, -4.0, 0.0)), "opposite directions"),
    ],
)
def test_undefined_mirrors_are_refused(function, vectors, message):
    with pytest.raises(ConditionError, match=message):
        function(*vectors)


@pytest.mark.parametrize("direction", [(0, 0, 3), (0, 0, -1), (1, -2, 0.5), (-1, 0, 0)])
def test_the_axes_of_an_observer(direction):
    forward, left, up = map(np.array, projections.facing(direction))
    assert forward == pytest.approx(np.array(direction) / math.dist(direction, (0, 0, 0)))
    assert np.cross(forward, left) == pytest.approx(up)
    assert left[2] == 0
    assert up[2] >= 0
    assert np.linalg.norm(left) == pytest.approx(1)
