"""Projections of the sphere: directions by their definitions, solid angles by their integrals."""

import math

import mpmath
import numpy as np
import pytest
from geometry.references import close, exact
from hypothesis import given
from hypothesis import strategies as st

from radcalc.errors import ConditionError
from radcalc.geometry.projections import (
    direction_at,
    is_outside,
    middle_of_pixel,
    pixel_solid_angle,
    pixel_solid_angles,
    place_of,
)
from radcalc.quantities.symbols import ANGULAR, LATLONG, MIRROR_BALL, PROJECTIONS, WHOLE_SPHERE

H = math.sqrt(0.5)
# latlong by OpenEXR, ImfEnvmap.h: latitude v pi/2, longitude pi at the left; its z, x, y are x, y,
# z here, and longitude pi/2 points along its x.  The others by their definitions: a ball's normal
# (0.8, 0.6, 0) reflects +x to (0.28, 0.96, 0); a light probe shows 90 degrees at half its radius.
DIRECTIONS = [
    (LATLONG, (0.0, 0.0), (1, 0, 0)), (LATLONG, (-0.5, 0.0), (0, 1, 0)),
    (LATLONG, (0.5, 0.0), (0, -1, 0)), (LATLONG, (0.0, 1.0), (0, 0, 1)),
    (LATLONG, (0.0, -1.0), (0, 0, -1)), (LATLONG, (-1.0, 0.0), (-1, 0, 0)),
    (LATLONG, (-0.25, 0.5), (0.5, 0.5, H)),
    (MIRROR_BALL, (0.0, 0.0), (1, 0, 0)), (MIRROR_BALL, (0.6, 0.0), (0.28, 0.96, 0)),
    (MIRROR_BALL, (H, 0.0), (0, 1, 0)), (MIRROR_BALL, (0.0, H), (0, 0, 1)),
    (MIRROR_BALL, (0.0, -0.6), (0.28, 0, -0.96)), (MIRROR_BALL, (1.0, 0.0), (-1, 0, 0)),
    (ANGULAR, (0.0, 0.0), (1, 0, 0)), (ANGULAR, (-0.5, 0.0), (0, 1, 0)),
    (ANGULAR, (0.0, 0.5), (0, 0, 1)), (ANGULAR, (0.25, 0.0), (H, -H, 0)),
    (ANGULAR, (1.0, 0.0), (-1, 0, 0)),
]  # fmt: skip


@pytest.mark.parametrize(("projection", "place", "direction"), DIRECTIONS)
def test_directions_by_their_definition_and_back(projection, place, direction):
    assert direction_at(projection, *place) == pytest.approx(direction, abs=4e-16)
    assert place_of(projection, *direction) == pytest.approx(place, abs=4e-16)
    arrays = direction_at(projection, *(np.array([[x], [x]]) for x in place))
    assert [float(x[1, 0]) for x in arrays] == pytest.approx(direction, abs=4e-16)
    longer = place_of(projection, *(np.array([x, 3 * x]) for x in direction))
    assert [float(x[1]) for x in longer] == pytest.approx(place, abs=4e-16)


@given(st.sampled_from(PROJECTIONS), st.floats(-1, 1), st.floats(-1, 1))
def test_a_place_round_trip(projection, u, v):
    if is_outside(projection, u, v) or max(abs(u), abs(v)) > 1 - 1e-9:
        return
    direction = direction_at(projection, u, v)
    assert math.hypot(*direction) == pytest.approx(1, rel=4e-16)
    # close to the rim the direction is close to -x; at a pole any u is right
    assert place_of(projection, *direction) == pytest.approx((u, v), abs=1e-9, rel=1e-12)


@pytest.mark.parametrize("projection", WHOLE_SPHERE)
def test_an_ambiguous_direction_has_one_place(projection):
    for direction in [(-1.0, 0.0, 0.0), (-1.0, -0.0, -0.0), (-0.0, 0.0, 1.0), (-0.0, -0.0, -2.0)]:
        u, v = place_of(projection, *direction)
        assert place_of(projection, *(x + 0.0 for x in direction)) == (u, v)
        length = math.hypot(*direction)
        expected = [x / length for x in direction]
        assert direction_at(projection, u, v) == pytest.approx(expected, abs=4e-16)


@pytest.mark.parametrize("projection", WHOLE_SPHERE)
def test_places_outside_the_image_have_no_direction(projection):
    places = [(1.5, 0.0), (0.0, -1.1)] + [(0.8, 0.8)] * (projection != LATLONG)
    for place in places:
        assert is_outside(projection, *place)
        with pytest.raises(ConditionError, match="the place is outside the image"):
            direction_at(projection, *place)
    u, v = (np.array([0.3, *axis]) for axis in zip(*places, strict=True))
    for x in direction_at(projection, u, v):
        assert np.isnan(x).tolist() == [False] + [True] * len(places)
    with pytest.raises(ConditionError, match="unknown projection"):
        direction_at("", 0.0, 0.0)
    with pytest.raises(ConditionError, match="0,0,0 has no direction"):
        place_of(projection, 0.0, 0.0, 0.0)


def test_rows_and_columns_are_counted_from_the_top_left():
    assert middle_of_pixel(1024, 512, 0, 0) == (-1 + 1 / 1024, 1 - 1 / 512)
    assert middle_of_pixel(1024, 512, 1023, 511) == (1 - 1 / 1024, -1 + 1 / 512)
    x, y, z = direction_at(LATLONG, *middle_of_pixel(4, 2, 0, 0))
    assert (x, y, z) == pytest.approx((-0.5, 0.5, H), abs=4e-16)


SIZES = [(1, 1), (2, 2), (3, 2), (5, 7), (16, 16), (63, 63), (64, 32), (200, 200), (1024, 512)]


@pytest.mark.parametrize("projection", WHOLE_SPHERE)
@pytest.mark.parametrize(("width", "height"), SIZES)
def test_the_pixels_add_up_to_the_sphere(projection, width, height):
    each = np.broadcast_to(pixel_solid_angles(projection, width, height), (height, width))
    assert math.fsum(each.ravel().tolist()) == pytest.approx(4 * math.pi, rel=2e-15)


def density(projection, r):
    """d omega / (du dv), by its definition."""
    return 4 if projection == MIRROR_BALL else mpmath.pi * mpmath.sin(mpmath.pi * r) / r


@exact
def half_ball_pixel(u):
    """4 times the area of the unit circle to the right of u."""
    return 4 * (mpmath.acos(u) - u * mpmath.sqrt(1 - u * u))


def double_integral(projection, width, height, column, row):
    """The integral of the density over the pixel inside the circle, with 16 digits."""
    with mpmath.workdps(16):
        left, right = (mpmath.mpf(2 * (column + k)) / width - 1 for k in (0, 1))
        top, low = (1 - mpmath.mpf(2 * (row + k)) / height for k in (0, 1))

        def column_of(u):
            reach = mpmath.sqrt(max(0, 1 - u * u))
            a, b = max(low, -reach), min(top, reach)
            if a >= b:
                return mpmath.mpf(0)
            if projection == MIRROR_BALL:  # its density is constant
                return density(projection, 0) * (b - a)
            return mpmath.quad(lambda v: density(projection, mpmath.hypot(u, v)), [a, b])

        # the u at which the circle crosses the upper or lower side of the pixel
        kinks = [
            sign * mpmath.sqrt(1 - v * v) for v in (top, low) if abs(v) < 1 for sign in (1, -1)
        ]
        ends = [max(left, -1), *sorted(k for k in kinks if left < k < right), min(right, 1)]
        return mpmath.quad(column_of, ends)


PIXELS = [
    (16, 16, 7, 7), (16, 16, 2, 3), (16, 16, 2, 2), (16, 16, 0, 7), (16, 16, 13, 13),
    (5, 7, 2, 3), (5, 7, 0, 1), (5, 7, 4, 3), (3, 3, 0, 0), (64, 64, 9, 9), (63, 63, 31, 0),
    (200, 100, 100, 0), (200, 200, 29, 29), (1024, 1024, 511, 511), (1024, 1024, 150, 150),
]  # fmt: skip


@pytest.mark.parametrize("projection", [MIRROR_BALL, ANGULAR])
@pytest.mark.parametrize("pixel", PIXELS)
def test_a_pixel_is_the_integral_of_its_density(projection, pixel):
    expected = double_integral(projection, *pixel)
    close(pixel_solid_angle(projection, *pixel), expected, 1e-12)
    width, height, column, row = pixel
    close(pixel_solid_angles(projection, width, height)[row, column], expected, 1e-12)


def test_pixels_in_closed_form():
    assert pixel_solid_angle(MIRROR_BALL, 100, 50, 50, 25) == pytest.approx(4 * 0.02 * 0.04)
    assert pixel_solid_angle(MIRROR_BALL, 2, 2, 0, 0) == pytest.approx(math.pi, rel=1e-15)
    close(pixel_solid_angle(MIRROR_BALL, 10, 1, 9, 0), half_ball_pixel(0.8), 1e-15)
    assert pixel_solid_angle(ANGULAR, 1, 2, 0, 1) == pytest.approx(2 * math.pi, rel=1e-15)
    assert pixel_solid_angle(ANGULAR, 100, 100, 0, 0) == 0


@exact
def latlong_pixel(width, height, row):
    edges = [mpmath.cos(mpmath.pi * (row + k) / height) for k in (0, 1)]
    return 2 * mpmath.pi / width * (edges[0] - edges[1])


@pytest.mark.parametrize("row", [0, 1, 255, 256, 510, 511])
def test_a_latlong_pixel_is_a_difference_of_cosines(row):
    close(pixel_solid_angle(LATLONG, 1024, 512, 7, row), latlong_pixel(1024, 512, row), 1e-15)
    high = 65536
    row = row if row < 256 else high - 512 + row
    close(pixel_solid_angle(LATLONG, 1, high, 0, row), latlong_pixel(1, high, row), 1e-15)


@pytest.mark.parametrize("projection", WHOLE_SPHERE)
def test_directions_and_solid_angles_are_consistent(projection):
    """Over the sphere the mean of a component is 0, that of a product of two 1/3 or 0."""
    width, height = (512, 256) if projection == LATLONG else (400, 400)
    u, v = middle_of_pixel(width, height, np.arange(width)[None, :], np.arange(height)[:, None])
    weights = np.broadcast_to(pixel_solid_angles(projection, width, height), (height, width))
    each = np.array([np.broadcast_to(x, (height, width)) for x in direction_at(projection, u, v)])
    beside = np.isnan(each[0])  # pixels cut by the circle, with their middles outside
    each[:, beside] = np.array([[-1.0], [0.0], [0.0]])
    mean = (each * weights).sum(axis=(1, 2)) / (4 * math.pi)
    assert mean == pytest.approx([0, 0, 0], abs=1e-3)
    products = np.einsum("iab,jab,ab->ij", each, each, weights) / (4 * math.pi)
    assert products == pytest.approx(np.eye(3) / 3, abs=2e-3)
