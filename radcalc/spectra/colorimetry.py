"""Colour of a spectrum: chromaticity, colour temperature, rendering; the CIE's daylight; TM-30.

Colour rendition by TM-30 is calculated by colour-science.  Only this module imports that, on
demand: it takes most of a second.
"""

import math
import os
import warnings
from collections.abc import Sequence
from functools import cache, lru_cache
from itertools import pairwise
from operator import mul
from typing import Any

from radcalc.errors import ConditionError
from radcalc.spectra.data.colours import SAMPLES, X, Z
from radcalc.spectra.data.observers import PHOTOPIC
from radcalc.spectra.observers import C2
from radcalc.spectra.spectrum import VISIBLE, BlackBody, Spectrum, Table
from radcalc.tuples import NamedTuple

DAYLIGHT_START, STEP = 300.0, 5.0
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
    grid = [DAYLIGHT_START + STEP * i for i in range(len(values))]
    return Table(f"CIE daylight of {temperature:.6g} K", grid, values, VISIBLE)


START, Y = PHOTOPIC  # the colour-matching function y is V(lambda)
AT = START, len(Y)  # the first nanometre, and the number of them
FARTHEST = 0.05  # |Duv| above which the CIE defines no correlated colour temperature
SIMILAR = 5.4e-3  # largest distance in (u, v) of a light from its reference, CIE 13.3
GENERAL = 8  # samples of the general colour rendering index
DAYLIGHT_FROM = 5000.0  # K: from here on the reference is daylight, not a black body
NOISE = 1e-13  # in (u, v): rounding error of the sums
COLDEST = 250.0  # K: colder bodies have the chromaticity of 830 nm
ENDLESS = 5e-10  # 1/K: half that of the hottest black body
# 1/K, dense enough that `_Planckian.slope` changes sign at most once between two of them
STEPS = (ENDLESS, *(1e-6 * t for t in (50, 100, 150, 200, 300, 400, 600, 900, 1500)), 1 / COLDEST)
WHITE = 1 / 3  # x and y of the equal-energy white E
NEUTRAL = 1e-4  # in (x, y): the tables put E this close to WHITE
LAST = 699  # nm: from here on the chromaticity stays the same, but for rounding
ENDS_AT = 1e-4  # in (x, y): a ray this close to the end of the locus meets it
# linear sRGB from X, Y, Z (IEC 61966-2-1)
SRGB = (3.2406, -1.5372, -0.4986), (-0.9689, 1.8758, 0.0415), (0.0557, -0.2040, 1.0570)
HUES = {  # nm
    "violet": (360, 450), "blue": (450, 500), "green": (500, 570), "yellow": (570, 591),
    "orange": (591, 610), "red": (610, 760),
}  # fmt: skip
Colour = tuple[float, float]
Light = Sequence[float]


class Undefined(Exception):
    """Error for a property that is undefined for a light."""


# The denominator X + 15 Y + 3 Z of u and v.
_X_15Y_3Z = tuple(x + 15 * y + 3 * z for x, y, z in zip(X, Y, Z, strict=True))
_RATIOS = [C2 / (1e-9 * (AT[0] + i)) for i in range(AT[1])]  # c2/lambda [K]
# Planck's law, lambda^-5 / (e^x - 1) of x = c2/(lambda T), is this times x / (e^x - 1), times T.
_POWERS = [(1e-5 * ratio) ** 4 for ratio in _RATIOS]
_POWERS[0] /= 2  # ends of the trapezoid rule, as in a spectrum's moments
_POWERS[-1] /= 2


def tristimulus(light: Light) -> tuple[float, float, float]:
    """Return the tristimulus values X, Y and Z of a light, up to a common factor."""
    return _dot(light, X), _dot(light, Y), _dot(light, Z)


def chromaticity(light: Light) -> Colour:
    """Return the CIE 1931 chromaticity coordinates x and y of a light."""
    tristimulus_values = tristimulus(light)
    total = sum(tristimulus_values)
    return tristimulus_values[0] / total, tristimulus_values[1] / total


@cache
def spectrum_locus() -> list[Colour]:
    """Return x and y of the wavelengths at every nanometre, up to `LAST`."""
    points = zip(X, Y, Z, strict=True)
    return [(x / (x + y + z), y / (x + y + z)) for x, y, z in points][: LAST - START + 1]


def black_body(temperature: float) -> Light:
    """Return the light of a black body of a temperature [K]."""
    return BlackBody(temperature).moments(*AT)


def _dot(light: Light, weights: Sequence[float]) -> float:
    total: float = sum(map(mul, light, weights))
    return total


def _uv(light: Light) -> Colour:
    whole = _dot(light, _X_15Y_3Z)
    return 4 * _dot(light, X) / whole, 6 * _dot(light, Y) / whole


class _Planckian(NamedTuple):
    """A point of the Planckian locus in (u, v), and its derivative by 1/T."""

    inverse: float
    place: Colour
    speed: Colour

    def slope(self, colour: Colour) -> float:
        """Return half the derivative by 1/T of the squared distance to a chromaticity."""
        (u, v), (du, dv) = self.place, self.speed
        return (u - colour[0]) * du + (v - colour[1]) * dv


def _planckian(inverse: float) -> _Planckian:
    """Return the Planckian locus at 1/T [1/K], from Planck's law and the observer."""
    shares = [ratio * inverse for ratio in _RATIOS]  # c2/(lambda T)
    parts = [x / math.expm1(x) for x in shares]
    light = list(map(mul, _POWERS, parts))
    rise = [s * (1 - x - part) / inverse for s, x, part in zip(light, shares, parts, strict=True)]
    whole, d_whole = _dot(light, _X_15Y_3Z), _dot(rise, _X_15Y_3Z)
    u, v = _uv(light)
    speed = (4 * _dot(rise, X) - u * d_whole) / whole, (6 * _dot(rise, Y) - v * d_whole) / whole
    return _Planckian(inverse, (u, v), speed)


@cache
def _steps() -> list[_Planckian]:
    return [_planckian(inverse) for inverse in STEPS]


def temperature_and_distance(light: Light) -> tuple[float, float]:
    """Return the correlated colour temperature [K] of a light, and its Duv.

    Returns
    -------
    temperature : float
        Temperature of the nearest black body in CIE 1960 (u, v).
    distance : float
        Distance to it, positive above the Planckian locus.

    Raises
    ------
    Undefined
        If no black body is nearest, or the nearest is more than 0.05 away.

    Notes
    -----
    The nearest point is where the derivative by 1/T of the squared distance is 0.  The radius of
    curvature of the locus is at least 0.100, so the point is unique for a light within 0.05 of it.

    References
    ----------
    CIE 15:2004 for the definition and the 0.05; Y. Ohno, "Practical use and calculation of CCT
    and Duv", LEUKOS 10 (2014), for the sign.
    """
    colour = _uv(light)
    slopes = [point.slope(colour) for point in _steps()]
    k = next((k for k, slope in enumerate(slopes) if slope >= 0), 0)
    if not k:
        is_blue = slopes[0] >= 0
        like = (
            "bluer than any black body" if is_blue else f"redder than a black body of {COLDEST:g} K"
        )
        raise Undefined(f"the light is {like}")
    point = _between(colour, STEPS[k - 1], STEPS[k], slopes[k - 1], slopes[k])
    away = math.dist(colour, point.place)
    if away > FARTHEST:
        raise Undefined(f"Duv would be {away:.2g}, but the CIE's limit is {FARTHEST:g}")
    if away < NOISE:
        away = 0.0
    return 1 / point.inverse, math.copysign(away, colour[1] - point.place[1])


def correlated_temperature(source: Spectrum) -> float:
    """Return the correlated colour temperature [K] of a spectrum; raise Undefined without one."""
    return temperature_and_distance(source.moments(*AT))[0]


def temperature_of(source: Spectrum) -> float | None:
    """Return the correlated colour temperature [K] of a spectrum; None if it has none."""
    try:
        return correlated_temperature(source)
    except Undefined:
        return None


def _between(colour: Colour, low: float, high: float, below: float, above: float) -> _Planckian:
    """Return the point of slope 0 between two 1/T with a negative and a positive slope.

    References
    ----------
    N. Anderson and A. Bjorck, "A new high order method of regula falsi type", BIT 13 (1973).
    """
    side = 0.0
    point = _planckian(high)
    for _ in range(60):
        before = point.inverse
        point = _planckian(high - above * (high - low) / (above - below))
        slope = point.slope(colour)
        if not slope or abs(point.inverse - before) < 1e-13 * before:
            break
        if slope > 0:
            if side > 0:
                below *= _shrunk(slope / above)
            high, above = point.inverse, slope
        else:
            if side < 0:
                above *= _shrunk(slope / below)
            low, below = point.inverse, slope
        side = slope
    return point


def _shrunk(ratio: float) -> float:
    return 1 - ratio if ratio < 1 else 0.5


def reference(temperature: float, daylight_from: float = DAYLIGHT_FROM) -> Spectrum:
    """Return the reference of CIE 13.3 for a light of a correlated colour temperature [K].

    It is a black body below `daylight_from`, and a CIE daylight from there.
    """
    if temperature > HOTTEST:
        raise Undefined(f"the reference is CIE daylight, which ends at {HOTTEST:g} K")
    return illuminant(temperature) if temperature >= daylight_from else BlackBody(temperature)


def difference(light: Light, other: Light) -> float:
    """Return the distance of two lights in CIE 1960 (u, v)."""
    return math.dist(_uv(light), _uv(other))


def colour_rendering_indices(light: Light, like: Light) -> list[float]:
    """Return the special colour rendering indices R1 to R14 of a light, relative to its reference.

    The general index Ra is the mean of the first eight.

    References
    ----------
    CIE 13.3-1995.
    """
    here, there = _uv(light), _uv(like)
    c_share, d_share = (ours / theirs for ours, theirs in zip(_cd(there), _cd(here), strict=True))
    whites = _dot(light, Y), _dot(like, Y)
    indices = []
    for sample in SAMPLES:
        lit, expected = list(map(mul, light, sample)), list(map(mul, like, sample))
        c, d = _cd(_uv(lit))
        c, d = c_share * c, d_share * d
        below = 16.518 + 1.481 * c - d
        adapted = (10.872 + 0.404 * c - 4 * d) / below, 5.520 / below
        shift = math.dist(
            _uvw(adapted, there, _dot(lit, Y) / whites[0]),
            _uvw(_uv(expected), there, _dot(expected, Y) / whites[1]),
        )
        indices.append(100 - 4.6 * shift)
    return indices


def colour_rendering_index(indices: Sequence[float]) -> float:
    """Return the general colour rendering index Ra, the mean of the first eight special ones."""
    return sum(indices[:GENERAL]) / GENERAL


def is_adapted(light: Light) -> bool:
    """Return whether the adaptation of CIE 13.3, a division by c and d, is defined for a light."""
    return all(_cd(_uv(light)))


def _cd(colour: Colour) -> tuple[float, float]:
    """Return the c and d of the adaptation of CIE 13.3."""
    u, v = colour
    return (4 - u - 10 * v) / v, (1.708 * v + 0.404 - 1.481 * u) / v


def _uvw(colour: Colour, white: Colour, share: float) -> tuple[float, float, float]:
    """Return CIE 1964 U*, V*, W* of a chromaticity and a fraction of the white's luminance."""
    w = 25 * (100 * share) ** (1 / 3) - 17
    return 13 * w * (colour[0] - white[0]), 13 * w * (colour[1] - white[1]), w


class Hue(NamedTuple):
    """The hue of a light: its dominant or complementary wavelength [nm], and excitation purity."""

    wavelength: float
    is_complementary: bool
    purity: float


def hue(light: Light) -> Hue:
    """Return the hue of a light, relative to the equal-energy white E.

    Purples have no dominant wavelength; theirs is the complementary one.

    Raises
    ------
    Undefined
        If the light is white, or has the chromaticity of every wavelength from 699 nm.

    References
    ----------
    CIE 15: the line from the white through the light meets the spectrum locus, which is straight
    between whole nanometres, at the dominant wavelength.
    """
    x, y = (coordinate - WHITE for coordinate in chromaticity(light))
    away = math.hypot(x, y)
    if away < NEUTRAL:
        raise Undefined("it is the equal-energy white")
    locus = [(xa - WHITE, ya - WHITE) for xa, ya in spectrum_locus()]
    met, opposite = _meet(locus, x, y), _meet(locus, -x, -y)
    if met and met[0] < LAST - 0.5:
        return Hue(met[0], False, away / met[1])
    (xa, ya), (xb, yb) = locus[0], locus[-1]
    if met or opposite is None or abs(xb * y - yb * x) < ENDS_AT * away:
        raise Undefined(f"all wavelengths from {LAST:g} nm have its chromaticity")
    share = (xa * y - ya * x) / ((xa - xb) * y - (ya - yb) * x)  # along the line of purples
    boundary = math.hypot(xa + share * (xb - xa), ya + share * (yb - ya))
    return Hue(opposite[0], True, away / boundary)


def _meet(locus: Sequence[Colour], x: float, y: float) -> tuple[float, float] | None:
    """Return the wavelength [nm] where a ray from the white meets the locus, and its distance."""
    for k, ((xa, ya), (xb, yb)) in enumerate(pairwise(locus)):
        before, after = xa * y - ya * x, xb * y - yb * x
        if before <= 0 <= after and before != after and xa * x + ya * y > 0:
            share = before / (before - after)
            distance = math.hypot(xa + share * (xb - xa), ya + share * (yb - ya))
            # The observer is linear in the wavelength, which weighs the ends by their sums.
            weight = share * (X[k] + Y[k] + Z[k])
            other = (1 - share) * (X[k + 1] + Y[k + 1] + Z[k + 1])
            return START + k + weight / (weight + other), distance
    return None


def hue_name(wavelength: float) -> str:
    """Return the name of a spectral colour [nm], "" outside of the visible.

    References
    ----------
    ISO 21348, table of spectral categories, which calls the first one purple.
    """
    for name, (low, high) in HUES.items():
        if low <= wavelength < high:
            return name
    return ""


def srgb(tristimulus_values: Sequence[float]) -> tuple[float, float, float]:
    """Return the colour of tristimulus values on a screen: red, green and blue from 0 to 1.

    The greatest of the three is 1.  Negative ones, of colours that no screen shows, are 0.

    References
    ----------
    IEC 61966-2-1.
    """
    linear = [max(sum(map(mul, row, tristimulus_values)), 0.0) for row in SRGB]
    red, green, blue = (_encoded(part / max(linear)) for part in linear)
    return red, green, blue


def _encoded(part: float) -> float:
    return 12.92 * part if part <= 0.0031308 else min(1.055 * part ** (1 / 2.4) - 0.055, 1.0)


SAMPLED = 380, 780  # nm: CIE 224
MIXED = 4000.0, 5000.0  # K: CIE 224 mixes black body and daylight in its reference
COARSEST = 5.0  # nm: widest step of data for CIE 224
COLDEST_REFERENCE = 1000.0  # K: lowest temperature of the reference that colour-science finds
Point = tuple[float, float]


class Rendition(NamedTuple):
    """Colour rendition of a light by ANSI/IES TM-30-18.

    `fidelity` (R_f) and `gamut` (R_g) are of all samples.  Each hue bin has its local fidelity,
    chroma shift (a fraction) and hue shift.  `test` and `reference` are the mean a', b' of each bin
    in CAM02-UCS, under the light and under its reference.
    """

    fidelity: float
    gamut: float
    local_fidelity: tuple[float, ...]
    chroma_shifts: tuple[float, ...]
    hue_shifts: tuple[float, ...]
    test: tuple[Point, ...]
    reference: tuple[Point, ...]


def load_colour() -> Any:
    """Return colour-science, without its warnings of missing packages and its print options."""
    import numpy

    with warnings.catch_warnings(), numpy.printoptions():
        warnings.simplefilter("ignore")
        import colour
    return colour


@lru_cache(maxsize=32)
def rendition(source: Spectrum) -> Rendition:
    """Return the colour rendition of a spectrum.

    Raises
    ------
    Undefined
        If the light has no colour temperature from 1000 K to 25 000 K, or its data are too coarse.

    References
    ----------
    ANSI/IES TM-30-18, whose R_f is that of CIE 224:2017; colour-science.
    """
    temperature = correlated_temperature(source)
    if not COLDEST_REFERENCE <= temperature <= HOTTEST:
        limits = f"{COLDEST_REFERENCE:g} K to {HOTTEST:g} K"
        raise Undefined(f"its colour temperature, {temperature:.6g} K, is not within {limits}")
    if (step := source.widest_step) > COARSEST:
        raise Undefined(f"CIE 224 needs data at every {COARSEST:g} nm, and these have {step:g} nm")
    colour = load_colour()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = colour.colour_fidelity_index(
            _distribution(source, *SAMPLED), True, "ANSI/IES TM-30-18"
        )
    return Rendition(
        float(found.R_f),
        float(found.R_g),
        tuple(map(float, found.R_fs)),
        tuple(float(shift) / 100 for shift in found.R_cs),
        tuple(map(float, found.R_hs)),
        tuple((float(a), float(b)) for a, b in found.averages_test),
        tuple((float(a), float(b)) for a, b in found.averages_reference),
    )


def vector_background() -> str:
    """Return the path of the picture behind the colour vectors of TM-30."""
    load_colour()
    from colour.plotting.tm3018.components import ROOT_RESOURCES_ANSIIESTM3018

    return os.path.join(ROOT_RESOURCES_ANSIIESTM3018, "CVG_Background.jpg")


def draw_chromaticities(axes: Any) -> None:
    """Draw the colours of the CIE 1931 chromaticity diagram in the axes of Matplotlib."""
    load_colour()
    from colour.plotting.diagrams import plot_chromaticity_diagram_colours

    plot_chromaticity_diagram_colours(diagram_colours="RGB", axes=axes, show=False)


def _distribution(source: Spectrum, start: int, end: int) -> Any:
    """Return the spectrum for colour-science, 0 outside of the data.

    A table of every nanometre, or of every fifth, keeps its values: CIE 224 has samples for both.
    Any other light is summed around each nanometre.
    """
    colour = load_colour()
    if isinstance(source, Table) and (step := _even_step(source.grid)):
        inside = dict(zip(source.grid, source.values, strict=True))
        places = range(start, end + 1, step)
        return colour.SpectralDistribution([inside.get(nm, 0.0) for nm in places], places)
    light = source.moments(start - 1, end - start + 3)[1:-1]  # without the halved ends
    return colour.SpectralDistribution(light, range(start, end + 1))


def _even_step(grid: Sequence[float]) -> int:
    """Return 5 or 1 if the wavelengths are all multiples of 5 nm, or all of 1 nm; otherwise 0."""
    for step in (5, 1):
        if all(nm % step == 0 for nm in grid) and grid[-1] - grid[0] == step * (len(grid) - 1):
            return step
    return 0


FIRST_BAND, WIDTH, COUNT = 375, 10, 30  # nm, nm: the bands that are compared
LAST_BAND = FIRST_BAND + WIDTH * COUNT
DAYLIGHT_FROM_IN_TM30 = 4000.0  # K: from here on the reference is daylight, not a black body
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
    temperature = correlated_temperature(source)
    return reference(temperature, DAYLIGHT_FROM_IN_TM30)


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
    bands = [FIRST_BAND + WIDTH * k for k in range(COUNT)]
    powers = [source.power((float(low), float(low + WIDTH))) for low in bands]
    total = sum(powers)
    if not total > 0:
        raise Undefined(f"{source.label} has no power from {FIRST_BAND} nm to {LAST_BAND} nm")
    return [power / total for power in powers]
