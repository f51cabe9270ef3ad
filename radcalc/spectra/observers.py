"""Black bodies, observers, and all other weights of spectra.

The radiation of black bodies is Planck's law, with its integrals over a range in closed form.  The
constants h, c and k are exact (the SI of 2019).  Temperatures in kelvin, wavelengths in metres.

The tables of observers have steps of 1 nm in standard air, are interpolated linearly, and are 0
outside.

A weight is a function of the wavelength that counts a kind of light.  A weighted amount is the
integral of S(lambda) w(lambda), of watts or, for a weight of photons, of photons; the lumens of an
observer are its constant times the watts weighted by its table.  The rows are those of
`units/weights.tsv`, and the user's own.  Weights are linear between their points.
"""

import math
from bisect import bisect_right
from collections.abc import Callable, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from radcalc.maths import Number, is_array, larger, rounded, smaller, square
from radcalc.quantities import KIND_NAMES, LUMINOUS, PHOTON, RADIANT, base_of, ratio_unit
from radcalc.spectra.data.observers import (
    CIE_1964,
    CIE_2008_2,
    CIE_2008_10,
    JUDD_VOS,
    PHOTOPIC,
    SCOTOPIC,
)
from radcalc.tuples import NamedTuple
from radcalc.units.compiled import WEIGHTS
from radcalc.units.table import resolve
from radcalc.units.values import value

if TYPE_CHECKING:
    from radcalc.spectra.spectrum import Range, Spectrum

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


def lumens_per_photon(observer: Observer, limits: tuple[float, float]) -> tuple[float, float]:
    """Return the least and the most at a wavelength within limits [lm s].

    Mixtures of wavelengths are between them.  The limits are in nm, within the table; between two
    of its points, the ratio of two linear functions rises or falls.
    """
    places = range(observer.start, observer.end + 1)
    shares = [
        v / nm
        for v, nm in zip(observer.values, places, strict=True)
        if limits[0] <= nm <= limits[1]
    ]
    per_share = observer.maximum * 1e9 * PLANCK * LIGHT
    return min(shares) * per_share, max(shares) * per_share


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


# ---------------------------------------------------------------------------------------------
# Weights: the lumens of observers and every other weight


class Weight(NamedTuple):
    """A weight: w at points from `start` [nm] at equal steps, 0 outside, and its source.

    `acts_on` is the light that it weights, watts or photons.
    """

    kind: str
    label: str
    acts_on: str
    start: float
    step: float
    values: tuple[float, ...]
    source: str

    @property
    def range(self) -> "Range":
        """Its first and its last wavelength [nm]."""
        return self.start, self.start + self.step * (len(self.values) - 1)

    @property
    def grid(self) -> list[float]:
        """The wavelengths of its points [nm]."""
        return [self.start + self.step * k for k in range(len(self.values))]

    @property
    def per_watt(self) -> "Sequence[float]":
        """The weighted light of a watt at each point: photons, if it is a weight of photons."""
        if self.acts_on == RADIANT:
            return self.values
        return [w * photons(nm) for nm, w in zip(self.grid, self.values, strict=True)]

    @property
    def described(self) -> str:
        """Its name and its source, for derivations."""
        return f"w({KIND_NAMES[self.kind]}): {self.source}"

    def at(self, nanometres: Any) -> Any:
        """Return w at a wavelength or an array of them [nm]; 0 outside its range."""
        place = (rounded(nanometres, 9) - self.start) / self.step
        last = len(self.values) - 1
        if is_array(place):
            import numpy

            return numpy.interp(place, numpy.arange(last + 1), self.values, left=0, right=0)
        if not 0 <= place <= last:
            return 0.0
        index = min(int(place), last - 1)
        below, above = self.values[index], self.values[index + 1]
        return below + (above - below) * (place - index)


def erythema(nanometres: float) -> float:
    """Return the erythema action spectrum of ISO/CIE 17166:2019 at a wavelength [nm].

    Examples
    --------
    >>> erythema(298.0), round(erythema(328.0), 9)
    (1.0, 0.001513561)
    """
    if nanometres <= 298:
        return 1.0
    if nanometres <= 328:
        return 10 ** (0.094 * (298 - nanometres))
    return 10 ** (0.015 * (140 - nanometres))


FORMULAS: dict[str, Callable[[float], float]] = {"erythema": erythema, "band": lambda _: 1.0}
STEPS = {"erythema": 0.5}  # nm; others have 1 nm
LOGARITHMIC = ("actinic_uv",)  # tables whose logarithm is linear between their points
OWN: dict[str, Weight] = {}  # the weights of files, by kind


@cache
def _rows() -> dict[str, list[str]]:
    from radcalc.quantities.names import data_rows

    return {row[1]: row for row in data_rows("weights", "units")}


def weight(kind: str) -> Weight:
    """Return the weight of a kind that is not of an observer."""
    return OWN.get(kind) or _of_row(kind)


@cache
def _of_row(kind: str) -> Weight:
    name, _, _, base, adjective, table, low, high, _, source = _rows()[kind]
    first, last, step = float(low), float(high), STEPS.get(table, 1.0)
    grid = [first + step * k for k in range(round((last - first) / step) + 1)]
    values = map(FORMULAS.get(table) or _of_table(table, name), grid)
    return Weight(kind, adjective, base, first, step, tuple(values), source)


def _of_table(table: str, column: str) -> "Callable[[float], float]":
    """Return the function of a column of a file of data, between its points and 0 outside."""
    from radcalc.quantities.names import data_rows

    titles, *lines = data_rows(table, "spectra/data", with_titles=True)
    place = titles.index(column) if column in titles else 1
    points = [(float(line[0]), float(line[place])) for line in lines if line[place]]
    grid, values = [nm for nm, _ in points], [w for _, w in points]
    if table in LOGARITHMIC:
        logs = [math.log(w) for w in values]
        return lambda nm: math.exp(at(grid, logs, nm)) if grid[0] <= nm <= grid[-1] else 0.0
    return lambda nm: at(grid, values, nm) if grid[0] <= nm <= grid[-1] else 0.0


def at(grid: Sequence[float], values: Sequence[float], place: float) -> float:
    """Return a table's value at a place inside it, by linear interpolation."""
    index = min(max(bisect_right(grid, place) - 1, 0), len(grid) - 2)
    left, right = grid[index], grid[index + 1]
    share = (place - left) / (right - left)
    return values[index] + (values[index + 1] - values[index]) * share


def names() -> dict[str, str]:
    """Return the kinds of the weights by their names."""
    return {row[0]: kind for kind, row in WEIGHTS.items()}


def observer_of(kind: str) -> Observer | None:
    """Return the observer whose lumens a kind has, or None."""
    if base_of(kind) != LUMINOUS:
        return None
    return OBSERVERS[WEIGHTS[kind][0] if kind in WEIGHTS else "photopic"]


def per_watt(kind: str, nanometres: Any) -> Any:
    """Return the light of a kind in a watt of one wavelength [nm, in vacuum for photons]."""
    if kind == RADIANT:
        return 1.0
    if kind == PHOTON:
        return nanometres * 1e-9 / (PLANCK * LIGHT)
    if eye := observer_of(kind):
        return luminous_efficacy(nanometres * 1e-9, eye)
    own = weight(kind)
    return own.at(nanometres) * per_watt(own.acts_on, nanometres)


def count(source: "Spectrum", kind: str) -> float:
    """Return the amount of a weighted kind in a spectrum: lumens, weighted watts or photons."""
    if eye := observer_of(kind):
        return source.lumens(eye)
    own = weight(kind)
    if _is_band(kind) and own.acts_on == RADIANT:
        return source.power(own.range)
    if _is_band(kind):
        return source.photons(own.range)
    return source.weigh(own.start, own.per_watt, own.step)


def _is_band(kind: str) -> bool:
    return kind not in OWN and _rows()[kind][5] == "band"


def range_of(kind: str) -> "Range | None":
    """Return the range [nm] of a weight that a spectrum must cover, or None."""
    return weight(kind).range if kind in WEIGHTS and observer_of(kind) is None else None


GRID = tuple([float(nm) for nm in range(100, 1201)])  # for the bounds of ratios


def bounds(top: str, bottom: str, limits: "Range") -> tuple[float, float]:
    """Return the least and the greatest ratio of two kinds, of light within a range."""
    eyes = [observer_of(kind) for kind in (top, bottom)]
    if {top, bottom} == {RADIANT, PHOTON}:
        return photons(limits[0]), photons(limits[1])
    if bottom == PHOTON and (eye := eyes[0]):
        return lumens_per_photon(eye, limits)
    if bottom == RADIANT and (eye := eyes[0]):
        return 0.0, eye.maximum
    ratios = [
        per_watt(top, nm) / below if below else math.inf
        for nm in GRID
        if limits[0] <= nm <= limits[1]
        if (below := per_watt(bottom, nm)) or per_watt(top, nm)
    ]
    return min(ratios, default=0.0), max(ratios, default=0.0)


def ratio_text(ratio: float, over: str, under: str) -> str:
    """Return a ratio of kinds in its usual unit: lm/W, umol/J, lm s/umol or mW_mel/lm."""
    bases = base_of(over), base_of(under)
    unit = ratio_unit(over, under)
    if bases == (LUMINOUS, PHOTON):
        return f"{ratio * AVOGADRO * 1e-6:.6g} {unit.replace('photon', 'umol')}"
    if bases == (PHOTON, RADIANT):
        return f"{ratio / AVOGADRO * 1e6:.6g} {unit.replace('photon', 'umol')}"
    if bases == (RADIANT, PHOTON) and over in WEIGHTS:
        return f"{ratio * AVOGADRO * 1e-6:.6g} {unit.replace('photon', 'umol')}"
    if bases == (RADIANT, LUMINOUS) and over in WEIGHTS:
        return f"{ratio * 1e3:.6g} m{unit}"
    return f"{ratio:.6g} {unit}"
