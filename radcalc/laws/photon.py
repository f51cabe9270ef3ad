"""A photon in vacuum: frequency, wavenumber and energy from the wavelength.

The cycle and the photon are dimensions here, so a joule per photon is not a joule.
"""

from radcalc.laws.law import law
from radcalc.spectra.planck import LIGHT, PLANCK

EXACT = "SI Brochure: exact h and c"
FREQUENCY = law(
    "frequency", "{frequency} = c / {wavelength}", EXACT, constant=LIGHT, unit="m cycle/s"
)
WAVENUMBER = law("wavenumber", "{wavenumber} = 1 / {wavelength}", unit="cycle")
ENERGY = law(
    "photon energy",
    "{photon-energy} = h c / {wavelength}",
    EXACT,
    constant=PLANCK * LIGHT,
    unit="J m/photon",
)
LAWS = [FREQUENCY, WAVENUMBER, ENERGY]
