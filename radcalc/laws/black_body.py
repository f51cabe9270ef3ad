"""A hot body: its exitance by Stefan and Boltzmann, its peak wavelength by Wien.

The body emits like a black body times an emissivity that is the same at all wavelengths and in all
directions.
"""

from radcalc.laws.law import law
from radcalc.spectra.planck import STEFAN_BOLTZMANN, WIEN

SIGMA = "sigma: CODATA 2022 (exact)"
EXITANCE = law(
    "Stefan-Boltzmann law",
    "{exitance} = {emissivity} sigma {temperature}^4",
    SIGMA,
    constant=STEFAN_BOLTZMANN,
    unit="W/(m2 K^4)",
)
PEAK = law(
    "Wien's displacement law",
    "{peak-wavelength} = b / {temperature}",
    "b: CODATA 2022 (exact), the peak per wavelength",
    constant=WIEN,
    unit="m K",
)
