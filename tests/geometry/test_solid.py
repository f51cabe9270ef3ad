"""Solid angles, whole and projected, against textbook formulas and defining integrals."""

import math
from itertools import product

import mpmath
import pytest
from geometry.references import (
    DIGITS,
    close,
    cone_mp,
    disc_mp,
    facing_disc_mp,
    facing_rectangle_mp,
    rectangle_mp,
    sideways_rectangle_mp,
    sphere_mp,
    strips,
    zone_mp,
)
from helpers import for_each
from mpmath import mpf

from radcalc import geometry
from radcalc.geometry import solid

# --- Closed forms.

ANGLES = [1e-9, 1e-6, 1e-3, 0.1, 1.0, 1.5, math.pi / 2, 2.0, 3.0, 3.1415926, math.pi]
TINY = [1e-9, 3e-7, 1e-4, 0.03, 0.5, 1.0, 7.0, 1e3, 1e6, 1e9]


@pytest.mark.parametrize("angle", ANGLES)
def test_a_cone_is_the_integral_of_its_zones(angle):
    close(geometry.cone(angle), cone_mp(angle))
    want = mpmath.pi if angle >= math.pi / 2 else None  # the whole hemisphere of the receiver
    with mpmath.workdps(DIGITS):
        close(solid.projected_cone(angle), want or mpmath.pi * mpmath.sin(mpf(angle)) ** 2)


@pytest.mark.parametrize("angle", [1e-9, 1e-4, 0.2, 0.7])
@pytest.mark.parametrize("tilt", [0.0, 1e-9, 0.3, -0.3, 0.8])
def test_a_cone_above_the_horizon_is_foreshortened(angle, tilt):
    with mpmath.workdps(DIGITS):
        want = mpmath.pi * mpmath.sin(mpf(angle)) ** 2 * mpmath.cos(mpf(tilt))
    close(solid.projected_cone(angle, tilt), want)


ZONES = [
    (0.0, 1e-9), (1e-9, 2e-9), (0.0, math.pi), (0.5, 0.5 + 2**-40), (1e-9, 1.0), (0.3, 2.0),
    (math.pi / 2 - 1e-9, math.pi / 2), (math.pi / 2 - 1e-3, math.pi / 2 + 1e-3), (1.0, math.pi),
    (math.pi - 2e-9, math.pi - 1e-9), (math.pi - 1e-9, math.pi), (3.0, 3.0 + 2**-45), (2.0, 2.0),
]  # fmt: skip


@pytest.mark.parametrize(("lower", "upper"), ZONES)
@pytest.mark.parametrize("azimuth", [1e-9, 1.0, 2 * math.pi])
def test_a_zone_is_a_difference_of_cosines(lower, upper, azimuth):
    close(solid.zone(lower, upper, azimuth), zone_mp(lower, upper, azimuth))
    with mpmath.workdps(DIGITS):
        low, high = (min(mpf(x), mpmath.pi / 2) for x in (lower, upper))
        want = mpf(azimuth) / 2 * (mpmath.sin(high) ** 2 - mpmath.sin(low) ** 2)
    close(solid.projected_zone(lower, upper, azimuth), want)


SPHERES = [(1.0, 1 + 2.0**-k) for k in (52, 51, 40, 30, 20, 3)] + [
    (1.0, 2.0), (1.0, 1e3), (1.0, 1e9), (1e-9, 1.0), (3e-9, 7e8), (695700e3, 149597870700.0),
]  # fmt: skip


@pytest.mark.parametrize(("radius", "distance"), SPHERES)
def test_a_sphere_is_the_cone_that_touches_it(radius, distance):
    close(solid.sphere(radius, distance), sphere_mp(radius, distance))
    with mpmath.workdps(DIGITS):
        want = mpmath.pi * (mpf(radius) / mpf(distance)) ** 2
        close(solid.angular_radius(radius, distance), mpmath.asin(mpf(radius) / mpf(distance)))
    close(solid.projected_sphere(radius, distance), want)


@pytest.mark.parametrize("height", TINY)
def test_a_disc_on_its_axis(height):
    with mpmath.workdps(DIGITS):
        h = mpf(height)
        close(solid.disc(1.0, height), 2 * mpmath.pi * (1 - h / mpmath.sqrt(h * h + 1)))
        close(solid.projected_disc(1.0, height), mpmath.pi / (1 + h * h))


@pytest.mark.parametrize(
    ("height", "offset"),
    [(0.5, 0.3), (2.0, 1.0), (0.1, 1.5), (1e-3, 0.999), (1e-6, 1.0), (3.0, 50.0), (1e-9, 0.2)],
)
def test_the_reference_of_a_disc_is_its_defining_integral(height, offset):
    reference = strips(1.0, height, offset)
    close(disc_mp(1.0, height, offset), reference, 1e-18)
    close(solid.disc(1.0, height, offset), reference)


OFFSETS = [1e-9, 0.2, 0.9, 1 - 1e-9, 1 - 2**-53, 1.0, 1 + 2**-52, 1 + 1e-9, 1.1, 3.9, 4.1, 1e4, 1e9]


@pytest.mark.parametrize("offset", OFFSETS)
def test_a_disc_off_its_axis_within_on_and_outside_the_rim(offset):
    for height in TINY:
        close(solid.disc(1.0, height, offset), disc_mp(1.0, height, offset))
        close(solid.disc(1.0, height, -offset), disc_mp(1.0, height, offset))
        close(solid.projected_disc(1.0, height, offset), facing_disc_mp(1.0, height, offset))


SIDES = [(1.0, 1.0), (1e-9, 1.0), (1.0, 1e-9), (1e-9, 1e-9), (2.0, 0.3), (1e6, 1e-3)]
PLACES = [(0.0, 0.0), (0.5, 0.5), (0.2, 0.0), (0.0, 3.0), (2.0, -1.0), (1e3, 1e3), (1e-9, 0.0)]


def test_the_references_of_rectangles_are_the_defining_integrals():
    at = (1.0, 2.0, 0.75, 0.25, -0.5)
    width, length, height, offset, offset_y = map(mpf, at)
    x = [-offset - width / 2, 0, -offset + width / 2]
    y = [-offset_y - length / 2, -offset_y + length / 2]

    def over(weight, low=0):
        def part(x, y):
            return weight(x, y) / (x * x + y * y + height**2) ** 2

        return mpmath.quad(part, x[low:], y)

    with mpmath.workdps(17):
        facing = over(lambda x, y: height**2)
        sideways = over(lambda x, y: x * height, low=1)
        whole = over(lambda x, y: height * mpmath.sqrt(x * x + y * y + height**2))
    close(facing_rectangle_mp(*at), facing, 1e-15)
    close(sideways_rectangle_mp(*at), sideways, 1e-15)
    close(rectangle_mp(*at), whole, 1e-15)


@pytest.mark.usefixtures("_few_integrals")
@pytest.mark.parametrize(("width", "length"), SIDES)
@pytest.mark.parametrize("height", [1e-6, 1e-3, 0.5, 20.0, 1e9])
def test_a_rectangle_is_the_sum_over_its_four_corners(width, length, height):
    for offset, offset_y in PLACES:
        at = (width, length, height, offset, offset_y)
        close(solid.rectangle(*at), rectangle_mp(*at))
        close(solid.projected_rectangle(*at), facing_rectangle_mp(*at))
        side = solid.projected_rectangle(*at, normal=(1.0, 0.0, 0.0))
        close(side, sideways_rectangle_mp(*at))


def test_a_rectangle_on_its_axis():
    # 4 arctan(a b / (h sqrt(a^2 + b^2 + h^2))) with half sides a, b; a cube's face fills 4 pi/6
    close(solid.rectangle(2.0, 2.0, 1.0), 2 * math.pi / 3, 1e-15)
    close(solid.rectangle(6.0, 8.0, 12.0), 4 * math.atan(1 / 13), 1e-15)  # 3, 4, 12 and 13


HALVES = [1e-9, 1e-5, 0.1, 1.0, math.pi / 2, 3.0, math.pi - 1e-5, math.pi - 1e-9]


@for_each(product(HALVES, HALVES))
def test_a_pyramid_is_a_rectangle_at_height_one(horizontal, vertical):
    with mpmath.workdps(DIGITS):
        a, b = (2 * mpmath.tan(mpf(x) / 2) for x in (horizontal, vertical))
    close(solid.pyramid(horizontal, vertical), rectangle_mp(a, b, 1, 0, 0))
    close(solid.projected_pyramid(horizontal, vertical), facing_rectangle_mp(a, b, 1, 0, 0))


def test_the_widest_pyramids():
    # a wedge of the full angle a fills 2 a; with both angles at 180 degrees it is the hemisphere
    close(solid.pyramid(math.pi, math.pi), 2 * math.pi)
    close(solid.pyramid(1.0, math.pi), 2.0)
    close(solid.projected_pyramid(math.pi, math.pi), math.pi)
    close(solid.projected_pyramid(1.0, math.pi), math.pi * math.sin(0.5))


# --- Inverses.


@pytest.mark.parametrize("angle", [1e-9, 1e-4, 0.3, 1.0, 2.0, 3.0])
def test_a_cone_round_trip(angle):
    close(geometry.cone_of(geometry.cone(angle)), angle)
    assert geometry.cone_of(12.566370614359173) == pytest.approx(math.pi, rel=1e-7)
    assert geometry.cone_of(12.566370614360) == pytest.approx(math.pi, rel=1e-7)  # as typed


@pytest.mark.parametrize(("radius", "distance"), SPHERES[1:])
def test_a_sphere_round_trip(radius, distance):
    size = solid.sphere(radius, distance)
    close(solid.sphere_distance(radius, size), distance)
    close(solid.sphere_radius(distance, size), radius)
