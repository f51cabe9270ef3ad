"""The kinds of spectra with parameters: notation and description."""

LENGTHS = ("nm", "um")
# The parameters, a description, an example, and the usual units of the parameters.
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
