"""Cones, lobes, pyramids and discs, solved for their sizes, against textbook formulas."""

import math

import mpmath
import pytest
from geometry.references import DIGITS, close, cone_mp, exact
from mpmath import mpf

from radcalc import geometry
from radcalc.geometry import solid

ANGLES = [1e-9, 1e-6, 1e-3, 0.1, 1.0, 1.5, math.pi / 2, 2.0, 3.0, 3.1415926, math.pi]
SOLID_ANGLES = [1e-18, 1e-9, 1e-3, 0.5, 1.0, 3.0, 6.0]


@exact
def rim_mp(solid_angle):
    return mpmath.acos(1 - solid_angle / (2 * mpmath.pi))


@pytest.mark.parametrize("angle", ANGLES)
def test_a_projected_cone_is_the_integral_of_the_cosine(angle):
    close(geometry.cone(angle), cone_mp(angle))
    with mpmath.workdps(DIGITS):
        end = min(mpf(angle), mpmath.pi / 2)  # directions behind the plane do not count
        want = 2 * mpmath.pi * mpmath.quad(lambda t: mpmath.cos(t) * mpmath.sin(t), [0, end])
    close(geometry.projected_cone(angle), want)
    assert geometry.projected_cone(angle) == pytest.approx(solid.projected_cone(angle), rel=1e-15)


@pytest.mark.parametrize("solid_angle", SOLID_ANGLES)
def test_the_half_angle_of_a_cone_from_its_solid_angle(solid_angle):
    close(geometry.cone_of(solid_angle), rim_mp(solid_angle))
    if solid_angle < 3.1:
        with mpmath.workdps(DIGITS):
            want = mpmath.asin(mpmath.sqrt(mpf(solid_angle) / mpmath.pi))
        close(geometry.projected_cone_of(solid_angle), want)


def test_rounded_limits_are_a_hemisphere_and_a_sphere():
    assert geometry.projected_cone_of(3.141592653590) == math.pi / 2
    assert geometry.cone_of(12.566370614360) == math.pi
    assert geometry.projected_cone(math.pi / 2) == math.pi
    assert geometry.FULL == 2 * geometry.HEMISPHERE == 4 * math.pi


@pytest.mark.parametrize("tilt", [0.0, 1e-9, 0.5, math.pi / 3, 1.57])
def test_the_cosine_of_the_incidence(tilt):
    with mpmath.workdps(DIGITS):
        want = mpmath.cos(mpf(tilt))
    close(geometry.facing(tilt), want)
    assert geometry.facing(-tilt) == geometry.facing(tilt)


def test_a_surface_turned_away_gets_no_light():
    assert [geometry.facing(tilt) for tilt in (math.pi / 2, 2.0, math.pi, -3.0)] == [0, 0, 0, 0]


@pytest.mark.parametrize("solid_angle", SOLID_ANGLES)
def test_the_rim_angle_of_a_disc_from_its_solid_angle(solid_angle):
    close(solid.rim_of(solid_angle), rim_mp(solid_angle))


@pytest.mark.parametrize("height", [1e-3, 0.5, 1.0, 7.0, 1e6])
def test_the_radius_of_a_disc_from_its_rim_angle(height):
    assert math.tan(solid.rim_of(solid.disc(1.0, height))) * height == pytest.approx(1, rel=1e-12)


@pytest.mark.parametrize("side", [1e-9, 1e-3, 0.5, 2.0, 3.0, math.pi])
@pytest.mark.parametrize("other", [1e-9, 1e-3, 0.5, 2.0, 2.5])
def test_one_angle_of_a_pyramid_from_the_other_and_the_solid_angle(side, other):
    with mpmath.workdps(DIGITS):
        whole = float(4 * mpmath.asin(mpmath.sin(mpf(side) / 2) * mpmath.sin(mpf(other) / 2)))
        want = 2 * mpmath.asin(mpmath.sin(mpf(whole) / 4) / mpmath.sin(mpf(side) / 2))
    close(solid.pyramid_side(whole, side), want)
    assert solid.pyramid_side(whole, side) == pytest.approx(other, rel=1e-12)


def test_a_wedge_and_the_face_of_a_cube_are_pyramids():
    assert solid.pyramid_side(1.0, math.pi) == pytest.approx(0.5, rel=1e-15)  # twice the angle
    assert solid.pyramid_side(4 * math.pi / 6, math.pi / 2) == pytest.approx(math.pi / 2, rel=1e-15)
    assert solid.pyramid_side(0.0, 1.0) == 0
    assert solid.pyramid_side(2.0, 1.0) == pytest.approx(math.pi, rel=1e-7)  # a wedge


@pytest.mark.parametrize("n", [0.0, 0.3, 1.0, 20.0, 150.5, 1e4])
def test_the_solid_angle_of_a_lobe_is_the_integral_over_its_hemisphere(n):
    with mpmath.workdps(30):
        ends = [0, 0.02, 0.1, 0.5, mpmath.pi / 2]
        whole = mpmath.quad(lambda t: mpmath.cos(t) ** mpf(n) * mpmath.sin(t), ends)
    close(geometry.lobe(n), 2 * mpmath.pi * whole)
