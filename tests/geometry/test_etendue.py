"""Etendues against textbook formulas and published view factors."""

import math

import mpmath
import pytest
from geometry.references import DIGITS, close, facing_disc_mp
from mpmath import mpf

from radcalc.geometry import etendue, solid


@pytest.mark.parametrize("radius", [1e-9, 0.3, 1.0, 2.0, 1e9])
@pytest.mark.parametrize("distance", [1e-9, 1e-3, 1.0, 1e4, 1e9])
def test_two_discs_on_one_axis(radius, distance):
    with mpmath.workdps(DIGITS):
        # the textbook's, itself checked by the rings below
        s = 1 + mpf(radius) ** 2 + mpf(distance) ** 2
        want = mpmath.pi**2 / 2 * (s - mpmath.sqrt(s * s - 4 * mpf(radius) ** 2))
    close(etendue.coaxial_discs(1.0, radius, distance), want)


def test_two_discs_are_the_rings_of_one_seen_by_the_other():
    for radius, distance in ((0.5, 0.3), (2.0, 1.0)):
        with mpmath.workdps(20):
            want = mpmath.quad(
                lambda r, R=radius, d=distance: 2 * mpmath.pi * r * facing_disc_mp(R, d, r), [0, 1]
            )
        close(etendue.coaxial_discs(1.0, radius, distance), want)


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
    got = etendue.coaxial_discs(one, other, distance) / (math.pi * math.pi * one**2)
    assert got == pytest.approx(factor, abs=5e-5)


def test_etendues_of_patches():
    close(etendue.patch_and_cone(2.0, math.pi / 6), math.pi / 2)  # pi A sin^2
    close(etendue.patch_and_aperture(2.0, 0.5), math.pi / 2)  # pi A NA^2
    close(etendue.patch_and_lens(2.0, 1.0), math.pi / 2)  # sin = 1/2N
    close(etendue.two_patches(2.0, 3.0, 10.0, math.pi / 3, math.pi / 3), 0.015, 1e-15)
    assert etendue.two_patches(2.0, 3.0, 10.0, 2.0) == 0
    close(solid.patch(2.0, 10.0, math.pi / 3), 0.01, 1e-15)
