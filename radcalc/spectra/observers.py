"""The luminous efficacy of radiation at one wavelength, for each standard observer.

The tables have steps of 1 nm in standard air, are interpolated linearly, and are 0 outside.
"""

from radcalc.maths import Number, is_array, larger, rounded, smaller, square
from radcalc.spectra.data.observers import (
    CIE_1964,
    CIE_2008_2,
    CIE_2008_10,
    JUDD_VOS,
    PHOTOPIC,
    SCOTOPIC,
)
from radcalc.spectra.planck import LIGHT, PLANCK
from radcalc.tuples import NamedTuple


class Observer(NamedTuple):
    """A table of relative luminous efficiency, and the efficacy [lm/W] at its maximum."""

    label: str
    constant: str
    maximum: float
    start: int
    values: tuple[float, ...]

    @property
    def end(self) -> int:
        """The last wavelength of the table [nm]."""
        return self.start + len(self.values) - 1

    @property
    def described(self) -> str:
        """Its table and its constant, for derivations."""
        return (
            f"{self.label}, {self.constant} {self.maximum:g} lm/W, "
            "linear interpolation in the 1 nm table"
        )


def luminous_efficiency(wavelength: Number, observer: Observer) -> Number:
    """Return the relative luminous efficiency of monochromatic radiation.

    Parameters
    ----------
    wavelength : float or array
        Wavelength in standard air [m].
    observer : Observer
        One of `OBSERVERS`.

    Returns
    -------
    float or array
        V(lambda), or V'(lambda), of the same shape; 0 outside the table.

    Notes
    -----
    Linear interpolation in the 1 nm table, according to CIE 018:2019.

    Examples
    --------
    >>> round(luminous_efficiency(632.8e-9, OBSERVERS["photopic"]), 6)
    0.237245
    """
    place = rounded(wavelength * 1e9, 9) - observer.start  # 555e-9 m is 555 nm: a point of it
    last = len(observer.values) - 1
    if is_array(place):
        import numpy

        grid = numpy.arange(last + 1)
        return numpy.interp(place, grid, observer.values, left=0, right=0)
    if not 0 <= place <= last:
        return 0.0
    index = min(int(place), last - 1)
    below, above = observer.values[index], observer.values[index + 1]
    return below + (above - below) * (place - index)


def luminous_efficacy(wavelength: Number, observer: Observer) -> Number:
    """Return the luminous efficacy of monochromatic radiation [lm/W]."""
    return observer.maximum * luminous_efficiency(wavelength, observer)


def most_lumens_per_photon(observer: Observer) -> float:
    """Return the maximum over wavelengths [lm s], which no mixture of wavelengths exceeds."""
    places = range(observer.start, observer.end + 1)
    shares = (v / nm for v, nm in zip(observer.values, places, strict=True))
    return observer.maximum * max(shares) * 1e9 * PLANCK * LIGHT


def standard_air_wavelength(vacuum: Number) -> Number:
    """Return the wavelength in standard air of radiation of a given vacuum wavelength.

    Parameters
    ----------
    vacuum : float or array
        Vacuum wavelength [m].

    Returns
    -------
    float or array
        Wavelength in dry air at 15 degrees C, 101325 Pa, 450 ppm CO2 [m].

    Notes
    -----
    .. math:: 10^8 (n - 1) = k_1 / (k_0 - \\sigma^2) + k_3 / (k_2 - \\sigma^2)

    with sigma the vacuum wavenumber in 1/um.  Fitted from 230 nm to 1690 nm; beyond, where the eye
    is insensitive, the index of the nearer end is used.

    References
    ----------
    P. E. Ciddor, "Refractive index of air: new equations for the visible and near infrared",
    Applied Optics 35 (1996) 1566, equation 1, https://doi.org/10.1364/AO.35.001566

    Examples
    --------
    >>> round(standard_air_wavelength(555.171e-9) * 1e9, 3)
    555.017
    """
    sigma_2 = square(1e-6 / smaller(larger(vacuum, 0.23e-6), 1.69e-6))
    return vacuum / (1 + 5792105e-8 / (238.0185 - sigma_2) + 167917e-8 / (57.362 - sigma_2))


def _by_the_candela(label: str, table: tuple[int, tuple[float, ...]]) -> Observer:
    """Return an observer with K by the definition of the candela, 683 lm/W at 540 THz in air."""
    relative = Observer(label, "K", 1.0, *table)
    at_540_thz = luminous_efficiency(standard_air_wavelength(LIGHT / 540e12), relative)
    return relative._replace(maximum=683 / at_540_thz)


# Km and K'm: CIE 018:2019, table of the efficacies at the maximum.
# The quadrature of derivations.
TRAPEZOIDS = "trapezoidal rule, at all wavelengths of the data and of the observer's table"
OBSERVERS = {
    "photopic": Observer("V(lambda) CIE 1924", "Km", 683.002, *PHOTOPIC),
    "scotopic": Observer("V'(lambda) CIE 1951", "K'm", 1700.06, *SCOTOPIC),
    "cie1964": _by_the_candela("V10(lambda) CIE 1964", CIE_1964),
    "judd-vos": _by_the_candela("VM(lambda) Judd-Vos 1978", JUDD_VOS),
    "cie2008-2": _by_the_candela("VF(lambda) CIE 2008 2 degree", CIE_2008_2),
    "cie2008-10": _by_the_candela("VF,10(lambda) CIE 2008 10 degree", CIE_2008_10),
}
