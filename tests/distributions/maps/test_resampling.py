"""Maps in other projections: conserved quantities."""

import math

import numpy
import pytest
from distributions.maps.images import SIZES, TILTS, image

from radcalc.distributions.maps.radiance_map import RadianceMap
from radcalc.distributions.maps.resampling import reproject

NEW = [("latlong", 64, 32), ("latlong", 160, 80), ("mirror-ball", 49, 49), ("angular", 50, 50)]
AIM = (0.3, -0.5, 0.2)
FACING = TILTS[1::3]  # along an axis, between the axes, and with a horizon next to the rim


def sizes(projection):
    return [count // 8 for count in SIZES[projection]]


class Mapped:
    """A map, with the means and irradiances of its channels."""

    def __init__(self, *given):
        self.map = RadianceMap(*given, weights=(1, 1, 1, 1))
        rows = self.map.size[1]
        weights = self.map.solid_angles(0, rows)[..., None]
        self.means = (self.map.channels(0, rows) * weights).sum((0, 1)) / weights.sum()
        self.irradiances = self.map.irradiances(FACING, is_each=True).T


@pytest.fixture(scope="module", params=SIZES)
def old(request):
    """Four channels: two are constant, one has a single bright pixel, and one is smooth."""
    width, height = sizes(request.param)
    values = numpy.full((height, width, 4), (3.0, 0.5, 1e-3, 0.0))
    values[int(0.3 * height), int(0.62 * width), 2] = 1e5
    smooth = image(request.param, lambda x, y, z: 1 + x * y + z * z / 2, (width, height), 2)
    values[..., 3] = smooth
    return Mapped(values, request.param)


@pytest.fixture(scope="module", params=NEW, ids=str)
def new(old, request):
    """The same in a new projection and size."""
    return Mapped(reproject(old.map, *request.param, aim=AIM), request.param[0], AIM)


def test_a_constant_map_stays_constant(new):
    """Each pixel is constant; outside the circle it is 0."""
    inside = new.map.solid_angles(0, new.map.size[1]) > 1e-12
    found = new.map.pixels[inside][:, :2]
    numpy.testing.assert_allclose(found, numpy.full_like(found, (3.0, 0.5)), rtol=1e-12)
    assert new.means[:2] == pytest.approx([3.0, 0.5], rel=1e-9)
    if new.map.projection != "latlong":
        assert not new.map.pixels[0, 0].any()


def test_the_light_of_a_single_pixel_stays(old, new):
    """It keeps its amount and its place, to a pixel's size, and does not become brighter."""
    assert new.means[2] == pytest.approx(old.means[2], rel=1e-6)
    assert new.map.pixels[..., 2].max() <= 1e5 * (1 + 1e-12)
    # a pixel of the new map is up to 2 pi / 64 wide, and more next to the rim of the ball
    near = 0.1 * old.means[2] * 4 * math.pi
    assert new.irradiances[2] == pytest.approx(old.irradiances[2], abs=near)


def test_irradiances_of_a_smooth_map_stay(old, new):
    assert new.irradiances[3] == pytest.approx(old.irradiances[3], rel=2e-3)
    assert new.means[3] == pytest.approx(old.means[3], rel=3e-4)


@pytest.mark.parametrize("projection", SIZES)
def test_the_same_projection_gives_the_same_pixels(projection):
    """The same projection, size and aim give the same pixels."""
    width, height = sizes(projection)
    values = numpy.random.default_rng(1).random((height, width, 3))
    around = RadianceMap(values, projection, weights=(1, 1, 1))
    found = reproject(around, projection, width, height)
    found, values = found.reshape(-1, 3), values.reshape(-1, 3)
    if projection != "latlong":  # next to the rim a pixel is wide, and its parts are not rectangles
        u = (numpy.arange(width) + 0.5) * 2 / width - 1
        inside = (numpy.hypot(u[:, None], u) < 0.95).ravel()
        found, values = found[inside], values[inside]
    numpy.testing.assert_allclose(found, values, rtol=1e-9)


def test_fine_detail_is_averaged():
    """A checkerboard of single pixels becomes grey, without a pattern of larger squares."""
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


def test_factor_and_progress():
    told = []
    around = RadianceMap(numpy.ones((32, 64)), "latlong", factor=179.0)
    found = reproject(around, "latlong", 128, 64, progress=lambda done, of: told.append((done, of)))
    assert found == pytest.approx(numpy.full((64, 128, 1), 179.0))
    assert told[-1] == (32, 32)
    assert told == sorted(told)
