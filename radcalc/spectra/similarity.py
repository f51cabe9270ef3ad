"""The spectral similarity index (SSI) of two lights."""

from radcalc.spectra import colorimetry
from radcalc.spectra.spectrum import Spectrum

START, WIDTH, COUNT = 375, 10, 30  # nm, nm: the bands that are compared
END = START + WIDTH * COUNT
DAYLIGHT_FROM = 4000.0  # K: from here on the reference is daylight, not a black body
# 1 from 430 nm to 650 nm, less at both ends
WEIGHTS = (12 / 45, 22 / 45, 32 / 45, 40 / 45, 44 / 45, *(1.0,) * 23, 11 / 15, 3 / 15)
SMOOTHING = (0.22, 0.56, 0.22)


def reference_of(source: Spectrum) -> Spectrum:
    """Return the usual reference for a light: a black body below 4000 K, then CIE daylight.

    Raises
    ------
    colorimetry.Undefined
        If the light has no correlated colour temperature, or one above 25 000 K.
    """
    temperature = colorimetry.correlated_temperature(source)
    return colorimetry.reference(temperature, DAYLIGHT_FROM)


def similarity(source: Spectrum, reference: Spectrum) -> float:
    """Return the similarity index of a spectrum to a reference, 100 if they are alike.

    Raises
    ------
    colorimetry.Undefined
        If one of them has no power from 375 nm to 675 nm.

    References
    ----------
    Academy of Motion Picture Arts and Sciences, S-2018-001 (SMPTE ST 2122), which rounds the index
    to a whole number.
    """
    differences = [0.0]
    for share, expected, weight in zip(_shares(source), _shares(reference), WEIGHTS, strict=True):
        differences.append(weight * (share - expected) / (expected + 1 / COUNT))
    differences.append(0.0)
    around = zip(differences, differences[1:], differences[2:], strict=False)
    smooth = [sum(w * d for w, d in zip(SMOOTHING, three, strict=True)) for three in around]
    return float(round(100 - 32 * sum(d * d for d in smooth) ** 0.5))


def _shares(source: Spectrum) -> list[float]:
    """Return the shares of the bands in the power of all of them."""
    bands = [START + WIDTH * k for k in range(COUNT)]
    powers = [source.power((float(low), float(low + WIDTH))) for low in bands]
    total = sum(powers)
    if not total > 0:
        raise colorimetry.Undefined(f"{source.label} has no power from {START} nm to {END} nm")
    return [power / total for power in powers]
