"""CIE daylight illuminants from their components, 300 nm to 830 nm at 5 nm."""

from collections.abc import Sequence

from radcalc.errors import ConditionError
from radcalc.spectra.spectrum import VISIBLE, Table

START, STEP = 300.0, 5.0
COOLEST, HOTTEST = 4000.0, 25000.0


def combine(
    temperature: float, S0: Sequence[float], S1: Sequence[float], S2: Sequence[float]
) -> list[float]:
    """Return the relative spectral power of CIE daylight of a correlated colour temperature [K].

    .. math:: S(\\lambda) = S_0 + M_1 S_1 + M_2 S_2

    References
    ----------
    CIE 15, the daylight illuminants: x_D as a polynomial of 1/T from 4000 K to 25 000 K.
    """
    if not COOLEST <= temperature <= HOTTEST:
        raise ConditionError(
            f"no CIE daylight of {temperature:g} K", "a temperature from 4000K to 25000K"
        )
    t = 1e3 / temperature
    if temperature <= 7000:
        x = -4.6070 * t**3 + 2.9678 * t**2 + 0.09911 * t + 0.244063
    else:
        x = -2.0064 * t**3 + 1.9018 * t**2 + 0.24748 * t + 0.237040
    y = -3.000 * x**2 + 2.870 * x - 0.275
    common = 0.0241 + 0.2562 * x - 0.7341 * y
    m1 = (-1.3515 - 1.7703 * x + 5.9114 * y) / common
    m2 = (0.0300 - 31.4424 * x + 30.0717 * y) / common
    return [a + m1 * b + m2 * c for a, b, c in zip(S0, S1, S2, strict=True)]


def illuminant(temperature: float) -> Table:
    """Return the CIE daylight of a correlated colour temperature [K]."""
    from radcalc.spectra.data.sources import S0, S1, S2

    values = combine(temperature, S0, S1, S2)
    grid = [START + STEP * i for i in range(len(values))]
    return Table(f"CIE daylight of {temperature:.6g} K", grid, values, VISIBLE)
