"""Observers and sources, which link watts, lumens and photons.

`radcalc.spectra.luminous` and `radcalc.spectra.luminous_efficacy` serve whole arrays of spectra;
they load NumPy at their first use.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from radcalc.spectra.arrays import luminous, luminous_efficacy

__all__ = ["luminous", "luminous_efficacy"]
LENGTHS = ("nm", "um")
AXES = ("nm", "um", "angstrom")  # units of the wavelengths of a file, as in nm:FILE
# Kinds of spectra: parameters, a description, an example, and the usual units of the parameters.
FORMS = {
    "blackbody": ("T", "a black body of a temperature", "blackbody:2856K", ("K",)),
    "daylight": ("T", "daylight of a colour temperature", "daylight:6500K", ("K",)),
    "line": (
        "WAVELENGTH[=WATTS],...",
        "lines with their shares",
        "line:555nm=40,600nm=30",
        LENGTHS,
    ),
    "gaussian": ("CENTRE,FWHM", "a centre and a width", "gaussian:530nm,30nm", LENGTHS),
    "band": ("LOW:HIGH", "constant from one wavelength to another", "band:580nm:630nm", LENGTHS),
}


def example(kind: str) -> str:
    """Return an example of a kind of spectrum."""
    return FORMS[kind][2]


def __getattr__(name: str) -> "Any":
    if name in __all__:
        from radcalc.spectra import arrays

        return getattr(arrays, name)
    raise AttributeError(f"module 'radcalc.spectra' has no attribute '{name}'")
