"""Directions by their definition, and back."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc.geometry import directions

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
    assert directions.spherical(*vector) == pytest.approx(angles, rel=1e-15)
    arrays = directions.spherical(*(np.array([x, x]) for x in vector))
    assert [float(x[1]) for x in arrays] == pytest.approx(angles, rel=1e-15)


@given(st.floats(1e-9, PI - 1e-9), st.floats(0, 6.28), st.floats(1e-100, 1e100))
def test_a_direction_and_back(polar, azimuth, length):
    unit = directions.cartesian(polar, azimuth)
    assert sum(x * x for x in unit) == pytest.approx(1, rel=1e-15 * 4)
    got = directions.spherical(*(x * length for x in unit))
    assert got[0] == pytest.approx(polar, rel=1e-14)
    assert got[1] == pytest.approx(azimuth, rel=1e-14, abs=1e-15)
    assert got[2] == pytest.approx(length, rel=1e-14)


@given(*[st.floats(-1e3, 1e3)] * 3)
def test_azimuths_are_within_one_turn(x, y, z):
    if x == y == z == 0:
        return
    polar, azimuth, _ = directions.spherical(x, y, z)
    assert 0 <= polar <= PI
    assert 0 <= azimuth < 2 * PI
