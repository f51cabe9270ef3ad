"""Black-body radiation: Planck's law, and its integrals over a range in closed form.

The constants h, c and k are exact (the SI of 2019).  Temperatures in kelvin, wavelengths in metres.
"""

import math
from collections.abc import Sequence

from radcalc.units.table import resolve
from radcalc.units.values import value

PLANCK = value("planck_constant")  # J s
LIGHT = value("speed_of_light")  # m/s
BOLTZMANN = value("boltzmann_constant")  # J/K
AVOGADRO = resolve("mol").factor  # photons
C2 = PLANCK * LIGHT / BOLTZMANN  # m K
SMALL = 0.5  # below it the power series in x = c2/(lambda T) has the precision of a float
WIEN_X = 4.9651142317442763  # the root of x = 5 (1 - e^-x): the peak per wavelength
HALF_X = (2.7325893071213999, 8.096610458229823)  # roots of x^5/(e^x - 1) at half of its maximum
WIEN = value("wien_constant")  # m K: the wavelength of that peak times the temperature
STEFAN_BOLTZMANN = value("stefan_boltzmann_constant")  # W/m2/K4


def photons(energy_wavelength: float) -> float:
    """Return the number of photons with a product of energy and wavelength [J nm]."""
    return energy_wavelength * 1e-9 / (PLANCK * LIGHT)


def spectral_exitances(wavelengths: Sequence[float], temperature: float) -> list[float]:
    """Return the spectral radiant exitance of a black body [W/m3] at wavelengths [m]."""
    scale, x1 = 2 * math.pi * PLANCK * LIGHT**2, C2 / temperature
    return [scale / (w**5 * math.expm1(x1 / w)) if x1 < 700 * w else 0.0 for w in wavelengths]


def exitance(temperature: float, low: float = 0.0, high: float = math.inf) -> float:
    """Return the radiant exitance of a black body [W/m2] between two wavelengths [m]."""
    first, last = C2 / (high * temperature), C2 / (low * temperature) if low else math.inf
    if last < SMALL:
        share = _power_below(last) - _power_below(first)
    else:
        share = _power_beyond(first) - _power_beyond(last)
    return STEFAN_BOLTZMANN * temperature**4 * share


def photon_exitance(temperature: float, low: float, high: float) -> float:
    """Return the photon exitance of a black body [1/(s m2)] between two wavelengths [m]."""
    scale = 2 * math.pi * (BOLTZMANN * temperature / PLANCK) ** 3 / LIGHT**2
    first, last = C2 / (high * temperature), C2 / (low * temperature) if low else math.inf
    if last < SMALL:
        return scale * (_photons_below(last) - _photons_below(first))
    return scale * (_photons_beyond(first) - _photons_beyond(last))


def _power_below(x: float) -> float:
    """Return 15/pi^4 times the integral of t^3/(e^t - 1) from 0 to a small x, by power series."""
    series = 1 / 3 - x / 8 + x**2 / 60 - x**4 / 5040 + x**6 / 272160 - x**8 / 13305600
    return 15 / math.pi**4 * x**3 * series


def _photons_below(x: float) -> float:
    """Return the integral of t^2/(e^t - 1) from 0 to a small x, by power series."""
    series = 1 / 2 - x / 6 + x**2 / 48 - x**4 / 4320 + x**6 / 241920 - x**8 / 12096000
    return x**2 * series


def _power_beyond(x: float) -> float:
    """Return 15/pi^4 times the integral of t^3/(e^t - 1) from x to infinity."""
    if x == math.inf:
        return 0.0
    if x < SMALL:
        return 1 - _power_below(x)
    total, n = 0.0, 1
    while n * x < 745 and n < 200:
        total += math.exp(-n * x) * (x**3 / n + 3 * x**2 / n**2 + 6 * x / n**3 + 6 / n**4)
        n += 1
    return 15 / math.pi**4 * total


def _photons_beyond(x: float) -> float:
    """Return the integral of t^2/(e^t - 1) from x to infinity."""
    if x == math.inf:
        return 0.0
    if x < SMALL:
        return 2 * 1.2020569031595942 - _photons_below(x)  # 2 zeta(3) is the whole integral
    total, n = 0.0, 1
    while n * x < 745 and n < 200:
        total += math.exp(-n * x) * (x**2 / n + 2 * x / n**2 + 2 / n**3)
        n += 1
    return total
