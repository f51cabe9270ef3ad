"""Radiances from expressions: irradiances of receivers with any normal."""

import math

import numpy
import pytest

from radcalc.distributions.environments import FormulaRadiances
from radcalc.distributions.sources import Formula
from radcalc.errors import ConditionError

OVERCAST = "(1 + 2*cos(theta))/3*(theta < 90*deg)"  # Moon and Spencer (1942), over the zenith's


def radiances(text: str) -> FormulaRadiances:
    return FormulaRadiances(Formula(text, quantity="radiance"))


def plain_sum(function, normal, count=800):
    """Return the irradiance as a sum over the centres of equal cells."""
    theta = (numpy.arange(count) + 0.5)[:, None] * math.pi / count
    phi = (numpy.arange(2 * count) + 0.5) * math.pi / count
    x, y, z = numpy.sin(theta) * numpy.cos(phi), numpy.sin(theta) * numpy.sin(phi), numpy.cos(theta)
    a, b, c = numpy.array(normal) / math.dist(normal, (0, 0, 0))
    cosine = numpy.maximum(a * x + b * y + c * z, 0)
    cells = (math.pi / count) ** 2
    return float((function(theta, phi) * cosine * numpy.sin(theta)).sum() * cells)


@pytest.mark.parametrize("normal", [(0, 0, 1), (1, 0, 0), (0, 0, -1), (0.3, -0.8, 0.2)])
def test_a_constant_gives_pi_times_it_in_any_direction(normal):
    found = radiances("2 + 0*theta").irradiance(normal)
    assert found.value == pytest.approx(2 * math.pi, rel=1e-9)


def test_overcast_sky():
    """7 pi/9 on the ground; on a wall the integral of (1 + 2 cos)/3 sin^2 cos phi, 1/6 pi + 4/9."""
    sky = radiances(OVERCAST)
    ground, wall = sky.irradiance((0, 0, 1)).value, sky.irradiance((0, -1, 0)).value
    assert ground == pytest.approx(7 * math.pi / 9, rel=1e-9)
    assert wall == pytest.approx(math.pi / 6 + 4 / 9, rel=2e-6)
    assert sky.irradiance((0, 0, -1)).value == 0
    assert sky.mean() == pytest.approx((2 * math.pi * 2 / 3) / (4 * math.pi), rel=1e-9)


@pytest.mark.parametrize("normal", [(0, 0, -1), (1, 2, -2), (0, 1, 0), (-1, 0.2, 3)])
def test_against_a_plain_sum(normal):
    sky = radiances("exp(-3*acos(0.6*x + 0.8*z)/rad) + max(y, 0)")

    def function(theta, phi):
        x, y = numpy.sin(theta) * numpy.cos(phi), numpy.sin(theta) * numpy.sin(phi)
        cosine = numpy.clip(0.6 * x + 0.8 * numpy.cos(theta), -1, 1)
        return numpy.exp(-3 * numpy.arccos(cosine)) + numpy.maximum(y, 0)

    found = sky.irradiance(normal)
    assert found.value == pytest.approx(plain_sum(function, normal), rel=2e-5)
    assert found.error < 1e-4 * found.value


def test_steps_in_theta_and_phi_seen_from_below():
    """A quarter of a cone of 30 degrees about -z: pi sin^2(30 deg) / 4."""
    found = radiances("(theta > 150*deg)*(phi < 90*deg)").irradiance((0, 0, -1))
    assert found.value == pytest.approx(math.pi / 16, rel=1e-9)


def test_peak_and_refusals():
    peak = radiances("max(x, 0)").peak()
    assert (peak.value, peak.polar) == pytest.approx((1, math.pi / 2))
    with pytest.raises(ConditionError, match="the radiance 'x' has a negative value"):
        radiances("x").irradiance((1, 0, 1))
    with pytest.raises(ConditionError, match="0,0,0 has no direction"):
        radiances("1").irradiance((0, 0, 0))


RADIUS, SUN = math.radians(0.2666), (0.766044443119, 0, 0.642787609687)


def sun_in_a_sky_of(around):
    return radiances(f"{around} + 1.6e9*({SUN[0]}*x + {SUN[2]}*z > {math.cos(RADIUS)!r})")


@pytest.mark.parametrize(("around", "normal"), [(0, (1, 0, 0)), (100, (1, -1, 1))])
def test_a_disc_of_the_size_of_the_sun(around, normal):
    """E is L pi sin(radius)^2 times the cosine, plus pi times the surrounding radiance."""
    cosine = sum(a * b for a, b in zip(normal, SUN, strict=True)) / math.dist(normal, (0, 0, 0))
    true = 1.6e9 * math.pi * math.sin(RADIUS) ** 2 * cosine + math.pi * around
    found = sun_in_a_sky_of(around).irradiance(normal)
    assert found.value == pytest.approx(true, rel=2e-3)
    assert abs(found.value - true) < found.error + 1e-4 * true


def test_the_mean_of_a_sky_with_a_disc_of_the_size_of_the_sun():
    assert sun_in_a_sky_of(100).mean() * 4 * math.pi == pytest.approx(
        1.6e9 * 2 * math.pi * (1 - math.cos(RADIUS)) + 4 * math.pi * 100, rel=2e-3
    )
