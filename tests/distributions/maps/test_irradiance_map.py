"""Irradiance maps, exact and by spherical harmonics, against closed forms."""

import math

import numpy
import pytest
from distributions.maps.images import SIZES, TILTS, image, unit

from radcalc.distributions.maps import RadianceMap
from radcalc.distributions.maps.rendered import irradiance_map, irradiances_of_order_2
from radcalc.errors import ConditionError


@pytest.mark.parametrize("order", [None, 2])
def test_a_uniform_sky(order):
    """E = pi L (1 + cos t)/2 has no harmonics above the first, so order 2 is exact."""
    sky = numpy.repeat([3000.0, 0.0], 64)[:, None, None] * [1.0, 2.0] + numpy.zeros((256, 1))
    found = irradiance_map(RadianceMap(sky, "latlong", weights=(1, 0)), 16, 8, order)
    polar = (numpy.arange(8) + 0.5) * math.pi / 8
    true = math.pi * 3000 * (1 + numpy.cos(polar)) / 2
    assert found.pixels.shape == (8, 16, 2)
    for channel in (0, 1):
        expected = numpy.broadcast_to(true[:, None] * (channel + 1), (8, 16))
        assert found.pixels[..., channel] == pytest.approx(expected, rel=2e-5)
    assert found.largest < 1e-6
    assert found.rms <= found.largest


def test_the_orientation_of_the_map():
    """Light from +y reaches pixels left of the centre, as in a latlong map."""
    found = irradiance_map(
        RadianceMap(image("latlong", lambda x, y, z: y > 0.9, (64, 32)), "latlong"), 64, 32
    ).pixels[..., 0]
    assert numpy.unravel_index(found.argmax(), found.shape)[1] in (15, 16)
    turned = RadianceMap(image("latlong", lambda x, y, z: y > 0.9, (64, 32)), "latlong", (0, 1, 0))
    found = irradiance_map(turned, 64, 32).pixels[..., 0]  # now it comes from -x
    assert numpy.unravel_index(found.argmax(), found.shape)[1] in (0, 63)


@pytest.mark.parametrize("projection", SIZES)
def test_order_2_of_a_polynomial(projection):
    """The harmonics of order 0, 1 and 2 have the factors pi, 2 pi/3 and pi/4."""
    size = [count // 16 for count in SIZES[projection]]
    radiance = image(projection, lambda x, y, z: 3 + x - z / 2 + x * y + 0.7 * z * z, size, 2)
    around = RadianceMap(radiance, projection)
    normals = numpy.array([unit(normal) for normal in TILTS])
    x, y, z = normals.T
    true = math.pi * (3 + 0.7 / 3) + 2 * math.pi / 3 * (x - z / 2)
    true += math.pi / 4 * (x * y + 0.7 * (z * z - 1 / 3))
    found = irradiances_of_order_2(around, normals)[:, 0]
    assert found == pytest.approx(true, rel=2e-3)
    # of the unchanged pixels, by the exact sum
    assert found == pytest.approx(around.irradiances(normals), rel=2e-4)


def test_order_2_of_a_small_sun():
    """1/4 + cos/2 + 5/32 (3 cos^2 - 1) replaces the cosine: 9.4 % of the peak at 90 degrees.

    Ramamoorthi and Hanrahan 2001: up to 9 % where all light comes from one direction.
    """
    sun = numpy.zeros((64, 128))
    sun[16, 40] = 1e5
    around = RadianceMap(sun, "latlong")
    found = irradiance_map(around, 64, 32, 2)
    exact = irradiance_map(around, 64, 32).pixels
    # of 128 directions: none is exactly at 90 degrees, where the difference has its peak, and
    # one 5 degrees off the sun, where the exact sum has its own
    assert 3 / 32 - 0.006 < found.largest < 3 / 32 + 0.001
    cosine = exact.max() * 17 / 16
    assert found.pixels.max() == pytest.approx(cosine, rel=1e-3)
    # the mean square over all directions, of the formula, by a plain sum
    c = numpy.linspace(-1, 1, 100_001)
    nine = 1 / 4 + c / 2 + 5 / 32 * (3 * c * c - 1)
    off = numpy.maximum(nine, 0) - numpy.maximum(c, 0)
    assert found.rms == pytest.approx(numpy.sqrt((off * off).mean()), rel=0.02)
    # below 0 they count as 0: over the share of the cosines that make them so, by 1/24 at most
    assert found.pixels.min() == 0
    polar = (numpy.arange(32)[:, None] + 0.5) * math.pi / 32
    weights = numpy.broadcast_to(numpy.sin(polar) / numpy.sin(polar).sum() / 64, (32, 64))
    dark = weights[found.pixels[..., 0] == 0].sum()
    assert dark == pytest.approx((nine < 0).mean(), abs=0.01)
    assert found.raised == numpy.count_nonzero(found.pixels == 0)
    assert found.deepest == pytest.approx(-nine.min(), rel=0.02)


@pytest.mark.parametrize(("projection", "size"), [("latlong", (16, 8)), ("angular", (10, 5))])
def test_each_pixel_is_the_irradiance_of_its_receiver(projection, size):
    """Half of the pixels follow from the opposite ones; all are the sum of a single receiver."""
    count = (64, 32) if projection == "latlong" else (48, 48)
    light = numpy.random.default_rng(5).lognormal(0, 2, count[::-1])
    around = RadianceMap(light, projection, (1, 2, 0.5))
    found = irradiance_map(around, *size).pixels[..., 0]
    width, height = size
    for row in range(height):
        for column in range(width):
            polar = (row + 0.5) * math.pi / height
            azimuth = math.pi - (column + 0.5) * 2 * math.pi / width
            across = math.sin(polar)
            normal = across * math.cos(azimuth), across * math.sin(azimuth), math.cos(polar)
            one = around.irradiance(normal)
            # pixels of an angular map are integrated by a few points
            off = 1e-10 * one.value if projection == "latlong" else one.error / 20
            assert found[row, column] == pytest.approx(one.value, abs=off)


def test_refusals():
    around = RadianceMap(numpy.ones((8, 16)), "latlong")
    with pytest.raises(ConditionError, match="latlong"):
        irradiance_map(around, 16, 16)
    with pytest.raises(ConditionError, match="1024 x 512 pixels takes too long"):
        irradiance_map(around, 1024, 512)
    with pytest.raises(ConditionError, match="16384 x 8192 pixels takes too long"):
        irradiance_map(around, 16384, 8192, 2)
    with pytest.raises(ConditionError, match="order 3"):
        irradiance_map(around, 16, 8, 3)
