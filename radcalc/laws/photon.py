"""A photon in vacuum: frequency, wavenumber and energy from the wavelength."""

from radcalc.laws.law import AnyLaw, Law
from radcalc.spectra.planck import LIGHT, PLANCK

EXACT = "SI Brochure: exact h and c"
FREQUENCY = Law(
    "frequency",
    "{frequency} = c / {wavelength}",
    "frequency",
    (("wavelength", -1),),
    LIGHT,
    "m cycle/s",
    EXACT,
)
WAVENUMBER = Law(
    "wavenumber",
    "{wavenumber} = 1 / {wavelength}",
    "wavenumber",
    (("wavelength", -1),),
    1.0,
    "cycle",
)
ENERGY = Law(
    "photon energy",
    "{photon-energy} = h c / {wavelength}",
    "photon-energy",
    (("wavelength", -1),),
    PLANCK * LIGHT,
    "J m/photon",
    EXACT,
)
LAWS: list[AnyLaw] = [FREQUENCY, WAVENUMBER, ENERGY]
