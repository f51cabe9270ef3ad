"""Maps in other projections: what they must keep."""

import math

import numpy
import pytest
from distributions.maps.images import SIZES, TILTS, image

from radcalc.distributions.maps.radiance_map import RadianceMap
from radcalc.distributions.maps.resampling import reproject

NEW = [("latlong", 64, 32), ("latlong", 200, 100), ("mirror-ball", 75, 75), ("angular", 90, 90)]
AIM = (0.3, -0.5, 0.2)


def sizes(projection):
    return [count // 8 for count in SIZES[projection]]


@pytest.mark.parametrize("new", NEW)
@pytest.mark.parametrize("old", SIZES)
def test_a_constant_map_stays_constant(old, new):
    """In each pixel; outside of the circle there is nothing."""
    width, height = sizes(old)
    around = RadianceMap(numpy.full((height, width, 2), (3.0, 0.5)), old, weights=(1, 1))
    found = reproject(around, *new, aim=AIM)
    again = RadianceMap(found, new[0], AIM, weights=(1, 1))
    inside = again.solid_angles(0, new[2]) > 1e-12
    assert found[inside] == pytest.approx(numpy.full((inside.sum(), 2), (3.0, 0.5)), rel=1e-12)
    assert again.mean() == pytest.approx(3.5, rel=1e-9)
    if new[0] != "latlong":
        assert not found[0, 0].any()


@pytest.mark.parametrize("new", NEW)
@pytest.mark.parametrize("old", SIZES)
def test_the_light_of_a_single_pixel_stays(old, new):
    """All of it, and where it is, to a pixel's size; nothing is brighter than it was."""
    width, height = sizes(old)
    values = numpy.full((height, width), 1e-3)
    row, column = int(0.3 * height), int(0.62 * width)
    values[row, column] = 1e5
    around = RadianceMap(values, old)
    found = reproject(around, *new, aim=AIM)[..., 0]
    again = RadianceMap(found, new[0], AIM)
    assert again.mean() == pytest.approx(around.mean(), rel=1e-6)
    assert found.max() <= 1e5 * (1 + 1e-12)
    before, after = around.irradiances(TILTS), again.irradiances(TILTS)
    # a pixel of the new map is up to 2 pi / 64 wide, and more next to the rim of the ball
    assert after == pytest.approx(before, abs=0.1 * around.mean() * 4 * math.pi)


@pytest.mark.parametrize("new", NEW)
@pytest.mark.parametrize("old", SIZES)
def test_irradiances_of_a_smooth_map_stay(old, new):
    around = RadianceMap(image(old, lambda x, y, z: 1 + x * y + z * z / 2, sizes(old), 2), old)
    again = RadianceMap(reproject(around, *new, aim=AIM)[..., 0], new[0], AIM)
    before, after = around.irradiances(TILTS), again.irradiances(TILTS)
    assert after == pytest.approx(before, rel=2e-3)
    assert again.mean() == pytest.approx(around.mean(), rel=3e-4)


@pytest.mark.parametrize("projection", SIZES)
def test_the_same_again(projection):
    """Of the same projection, size and aim: the same pixels."""
    width, height = sizes(projection)
    values = numpy.random.default_rng(1).random((height, width, 3))
    around = RadianceMap(values, projection, weights=(1, 1, 1))
    found = reproject(around, projection, width, height)
    found, values = found.reshape(-1, 3), values.reshape(-1, 3)
    if projection != "latlong":  # next to the rim a pixel is wide, and its parts are no rectangles
        u = (numpy.arange(width) + 0.5) * 2 / width - 1
        inside = (numpy.hypot(u[:, None], u) < 0.95).ravel()
        found, values = found[inside], values[inside]
    assert found == pytest.approx(values, rel=1e-9)


def test_what_is_finer_than_the_new_pixels_is_averaged():
    """A checkerboard of single pixels is grey, and no pattern of larger squares."""
    board = (numpy.indices((256, 512)).sum(0) % 2).astype(float)
    found = reproject(RadianceMap(board, "latlong"), "mirror-ball", 33, 33, aim=AIM)[..., 0]
    inside = RadianceMap(found, "mirror-ball").solid_angles(0, 33) > 0.9 * 4 * (2 / 33) ** 2
    assert abs(found[inside] - 0.5).max() < 0.05


def test_a_part_is_dark_elsewhere():
    values = numpy.random.default_rng(2).random((20, 30))
    padded = numpy.zeros((64, 128))
    padded[11:31, 50:80] = values
    part, whole = (
        RadianceMap(values, "latlong", frame=(50, 11, 128, 64)),
        RadianceMap(padded, "latlong"),
    )
    found, same = (reproject(one, "angular", 50, 50, aim=AIM) for one in (part, whole))
    assert found == pytest.approx(same, rel=1e-9, abs=1e-12)


def test_a_factor_and_what_is_done():
    told = []
    around = RadianceMap(numpy.ones((32, 64)), "latlong", factor=179.0)
    found = reproject(
        around, "latlong", 512, 256, progress=lambda done, of: told.append((done, of))
    )
    assert found == pytest.approx(numpy.full((256, 512, 1), 179.0))
    assert told[-1] == (32, 32)
    assert told == sorted(told)
