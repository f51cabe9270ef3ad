"""Black bodies, compared with quadrature and the constants of the SI."""

import mpmath
import pytest

from radcalc.spectra import observers

RANGES = [(400e-9, 700e-9), (555e-9, 556e-9), (1e-9, 1e-6), (5e-6, 20e-6), (1e-3, 1)]


@pytest.mark.parametrize("temperature", [300.0, 2000.0, 2856.0, 6000.0, 1e4, 1e6, 1e9])
@pytest.mark.parametrize(("low", "high"), RANGES)
def test_the_fraction_of_a_black_body_in_a_range_agrees_with_quadrature(temperature, low, high):
    with mpmath.workdps(30):
        h, c, k = mpmath.mpf("6.62607015e-34"), mpmath.mpf(299792458), mpmath.mpf("1.380649e-23")
        a, b = (h * c / (x * k * temperature) for x in (high, low))
        cuts = [a, *(x for x in (a + 1, a + 5, a + 20, a + 80) if x < b), b]
        power = mpmath.quad(lambda x: x**3 / mpmath.expm1(x), cuts)
        count = mpmath.quad(lambda x: x**2 / mpmath.expm1(x), cuts)
        watts = 2 * mpmath.pi * (k * temperature) ** 4 / (h**3 * c**2) * power
        photons = 2 * mpmath.pi * (k * temperature / h) ** 3 / c**2 * count
    whole = 5.670374419e-8 * temperature**4
    got = observers.exitance(temperature, low, high)
    assert got == pytest.approx(float(watts), rel=1e-9, abs=1e-25 * whole)
    got = observers.photon_exitance(temperature, low, high)
    total = 1.52046e15 * temperature**3
    assert got == pytest.approx(float(photons), rel=1e-9, abs=1e-25 * total)


def test_stefan_boltzmann_and_wien():
    assert pytest.approx(5.670374419e-8, rel=1e-9) == observers.STEFAN_BOLTZMANN  # CODATA 2018
    assert observers.exitance(5772) == pytest.approx(6.2939e7, rel=1e-4)  # the nominal sun
    peak = max(range(400, 600), key=lambda nm: observers.spectral_exitances([nm * 1e-9], 5772.0))
    assert peak == 502  # 2897.771955 um K / 5772 K
