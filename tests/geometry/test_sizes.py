"""Inequalities of solid angles: projected ones are smaller, those of larger shapes larger."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc import geometry
from radcalc.geometry import solid

angles = st.floats(1e-6, 1.5)
tilts = st.floats(-math.pi, math.pi)
lengths = st.floats(1e-2, 1e2)
PAIRS = {
    "cone": lambda a, t, x, y, z: (geometry.cone(a), solid.projected_cone(a, t)),
    "zone": lambda a, t, x, y, z: (
        solid.zone(a, a + abs(t) / 4),
        solid.projected_zone(a, a + abs(t) / 4),
    ),
    "sphere": lambda a, t, x, y, z: (solid.sphere(x, x + y), solid.projected_sphere(x, x + y, t)),
    "disc": lambda a, t, x, y, z: (solid.disc(x, y, z), solid.projected_disc(x, y, z, t)),
    "facing disc": lambda a, t, x, y, z: (solid.disc(x, y, z), solid.projected_disc(x, y, z)),
    "rectangle": lambda a, t, x, y, z: (
        solid.rectangle(x, y, z, t, a),
        solid.projected_rectangle(x, y, z, t, a, (math.sin(t), 0.1, math.cos(t))),
    ),
    "pyramid": lambda a, t, x, y, z: (solid.pyramid(a, abs(t)), solid.projected_pyramid(a, abs(t))),
}


@pytest.mark.parametrize("shape", PAIRS)
@given(angles, tilts, lengths, lengths, lengths)
def test_a_projected_solid_angle_is_not_larger_than_the_solid_angle(shape, a, t, x, y, z):
    whole, part = PAIRS[shape](a, t, x, y, z)
    assert 0 <= part <= whole * (1 + 1e-12)


@given(angles, tilts, lengths, lengths, lengths, st.floats(1.0, 3.0))
def test_larger_shapes_fill_larger_solid_angles(a, t, x, y, z, factor):
    bigger = min(a * factor, 1.57)
    for one, two in (
        (geometry.cone(bigger), geometry.cone(a)),
        (solid.projected_cone(bigger, t), solid.projected_cone(a, t)),
        (solid.sphere(x * factor, 3 * x + y), solid.sphere(x, 3 * x + y * factor)),
        (solid.disc(x * factor, y, z), solid.disc(x, y, z)),
        (solid.projected_disc(x * factor, y, z), solid.projected_disc(x, y, z)),
        (solid.rectangle(x * factor, y, z, t, a), solid.rectangle(x, y, z, t, a)),
        (
            solid.projected_rectangle(x, y * factor, z, t, a),
            solid.projected_rectangle(x, y, z, t, a),
        ),
        (solid.pyramid(bigger, a), solid.pyramid(a, a)),
    ):
        assert one >= two * (1 - 1e-12)
