"""Etendues against textbook formulas and published view factors."""

import math

import mpmath
import pytest
from geometry.references import DIGITS, close, facing_disc_mp
from helpers import by_law
from mpmath import mpf

from radcalc import geometry
from radcalc.errors import ConditionError
from radcalc.geometry import solid
from radcalc.laws.beams import APERTURE, LENS, PATCHES


@pytest.mark.parametrize("radius", [1e-9, 0.3, 1.0, 2.0, 1e9])
@pytest.mark.parametrize("distance", [1e-9, 1e-3, 1.0, 1e4, 1e9])
def test_two_discs_on_one_axis(radius, distance):
    with mpmath.workdps(DIGITS):
        # the textbook's formula, which the next test checks by rings
        s = 1 + mpf(radius) ** 2 + mpf(distance) ** 2
        want = mpmath.pi**2 / 2 * (s - mpmath.sqrt(s * s - 4 * mpf(radius) ** 2))
    close(solid.coaxial_discs(1.0, radius, distance), want)


def test_two_discs_are_the_sum_over_rings_of_one():
    for radius, distance in ((0.5, 0.3), (2.0, 1.0)):
        with mpmath.workdps(20):
            want = mpmath.quad(
                lambda r, R=radius, d=distance: 2 * mpmath.pi * r * facing_disc_mp(R, d, r), [0, 1]
            )
        close(solid.coaxial_discs(1.0, radius, distance), want)


@pytest.mark.parametrize(
    ("one", "other", "distance", "factor"),
    [
        # the examples of EES's heat transfer library, fchart.com/ees/heat_transfer_library/
        # transient_conduction/shape_factors/hs203.htm and shape_factors/hs308.htm
        (0.1, 0.2, 0.5, 0.1339),
        (0.5, 1.0, 2.0, 0.1922),
    ],
)
def test_published_view_factors_of_two_discs(one, other, distance, factor):
    got = solid.coaxial_discs(one, other, distance) / (math.pi * math.pi * one**2)
    assert got == pytest.approx(factor, abs=5e-5)


SIZES = [(1.0, 1.0, 1.0), (1.0, 2.0, 0.5), (0.1, 0.2, 0.5), (3.0, 1e-3, 2.0), (1.0, 1.0, 0.05),
         (1e-6, 1.0, 4.0), (1.0, 1.0, 1e6), (2e5, 1e5, 3e5)]  # fmt: skip


@pytest.mark.parametrize(("one", "other", "distance"), SIZES)
def test_the_distance_and_radius_of_two_discs_from_their_etendue(one, other, distance):
    with mpmath.workdps(DIGITS):
        r, s, d = map(mpf, (one, other, distance))
        whole = r * r + s * s + d * d
        size = float(mpmath.pi**2 / 2 * (whole - mpmath.sqrt(whole * whole - 4 * r * r * s * s)))
        # G^2 - pi^2 S G + pi^4 r^2 s^2 = 0, solved for S, and for the radius
        m = mpf(size) / mpmath.pi**2
        away = mpmath.sqrt(m + (r * s) ** 2 / m - r * r - s * s)
        radius = mpmath.sqrt((m * m - m * (s * s + d * d)) / (m - s * s))
    close(solid.discs_distance(one, other, size), away, 1e-10)
    close(solid.discs_distance(other, one, size), away, 1e-10)
    assert solid.discs_distance(one, other, size) == pytest.approx(distance, rel=1e-9)
    close(solid.discs_radius(other, distance, size), radius, 1e-10)
    assert solid.discs_radius(other, distance, size) == pytest.approx(one, rel=1e-9)


@pytest.mark.parametrize("size", [0.0, math.pi**2, 10.0])
def test_an_etendue_too_large_for_two_discs_is_refused(size):
    with pytest.raises(ConditionError, match="the etendue is out of range"):
        solid.discs_distance(1.0, 2.0, size)
    with pytest.raises(ConditionError, match="the etendue is out of range"):
        solid.discs_radius(1.0, 2.0, size)


def test_etendues_of_patches():
    close(solid.patch_and_cone(2.0, math.pi / 6), math.pi / 2)  # pi A sin^2
    close(by_law(APERTURE)(2.0, 0.5), math.pi / 2)  # pi A NA^2
    close(by_law(LENS)(2.0, 1.0), math.pi / 2)  # sin = 1/2N
    half = geometry.facing(math.pi / 3)
    close(by_law(PATCHES)(2.0, half, 3.0, half, 10.0), 0.015, 1e-15)
    assert by_law(PATCHES)(2.0, geometry.facing(2.0), 3.0, 1.0, 10.0) == 0
    close(solid.patch(2.0, 10.0, math.pi / 3), 0.01, 1e-15)
