"""Shapes that the receiver's horizon cuts."""

import math
import random

import pytest
from geometry.references import close, tilted_cone_mp, tilted_disc_mp
from helpers import for_each

from radcalc.geometry import solid


def sunken_cones():
    draw = random.Random(11)
    for k in range(25):
        angle = 10 ** draw.uniform(-9, 0) if k % 2 else draw.uniform(0.05, 1.57)
        height = draw.uniform(-0.999, 0.999)  # sine of the axis's elevation over that of `angle`
        yield angle, math.acos(height * math.sin(angle))
    yield from ((1.0, 2.57), (1e-3, math.pi / 2 + 0.999999e-3), (2.0, 1.0), (3.0, 1.3))
    yield from ((math.pi / 2 + x, 1.0) for x in (-1e-3, -1e-6, -1e-9, 0.0, 1e-9, 1e-6))


@for_each(list(sunken_cones()))
def test_a_cone_that_the_horizon_cuts(angle, tilt):
    reference = tilted_cone_mp(angle, tilt)
    close(solid.projected_cone(angle, tilt), reference, 1e-9)
    close(solid.projected_cone(angle, -tilt), reference, 1e-9)
    if 1e-6 < angle < 1.5:
        distance = 1 / math.sin(angle)
        close(solid.projected_sphere(1.0, distance, tilt), reference, 1e-9)


@for_each([0.1, 0.5, 1.0, 1.5])
def test_a_disc_directly_overhead_covers_a_quarter_of_the_sphere(tilt):
    """The quarter above the receiver on the side of the disc: pi/2 for each of its two faces."""
    want = math.pi / 2 * (math.cos(tilt) + math.sin(tilt))
    close(solid.projected_disc(0.5, 1e-100, 0.5, tilt), want, 1e-15)


def tilted_discs():
    draw = random.Random(12)
    for _ in range(25):
        height, offset = (10 ** draw.uniform(-2, 3) for _ in "ho")
        cut = offset + draw.uniform(-0.98, 0.98)  # the x at which the horizon cuts the disc
        yield height, offset, math.atan2(-height, cut) + draw.choice((0.0, math.pi))
    yield from ((0.5, 0.0, 1.4), (0.5, 0.0, -1.4), (1e-6, 0.5, 1.5), (1e-6, 1.0, -1.5))


@pytest.mark.usefixtures("_few_integrals")
@pytest.mark.parametrize(("height", "offset", "tilt"), list(tilted_discs()))
def test_a_disc_that_the_horizon_cuts(height, offset, tilt):
    got = solid.projected_disc(1.0, height, offset, tilt)
    close(got, tilted_disc_mp(1.0, height, offset, tilt), 1e-9)


@pytest.mark.parametrize("tilt", [0.2, -0.2, 1e-9])
def test_a_tilted_disc_above_the_horizon(tilt):
    close(solid.projected_disc(1.0, 3.0, 0.5, tilt), tilted_disc_mp(1.0, 3.0, 0.5, tilt))


@pytest.mark.parametrize("radius", [0.1, 1.0, 2.0, 7.0])
def test_a_disc_that_touches_the_horizon_from_below_does_not_count(radius):
    for turn in (-1, 1):  # the highest point of its rim is on the receiver's horizon
        tilt = turn * (math.pi - math.atan(1 / radius))
        assert solid.projected_disc(radius, 1.0, 0.0, tilt) == pytest.approx(0, abs=1e-15)


def test_shapes_below_the_horizon_do_not_count():
    assert solid.projected_cone(0.5, math.pi) == 0
    assert solid.projected_sphere(1.0, 2.0, 3.0) == 0
    assert solid.projected_disc(1.0, 2.0, 0.0, math.pi) == 0
    assert solid.projected_rectangle(1.0, 1.0, 2.0, normal=(0.0, 0.0, -1.0)) == 0
    assert solid.projected_zone(1.6, 3.0) == 0
