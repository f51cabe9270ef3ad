"""Colour rendition by TM-30, which colour-science calculates.

Only this module imports colour-science, on demand: that takes most of a second.
"""

import os
import warnings
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

from radcalc.spectra import colorimetry
from radcalc.spectra.colorimetry import HOTTEST, Undefined
from radcalc.spectra.spectrum import Spectrum, Table
from radcalc.tuples import NamedTuple

SAMPLED = 380, 780  # nm: CIE 224
COARSEST = 5.0  # nm: widest step of data for CIE 224
COLDEST = 1000.0  # K: lowest temperature of the reference that colour-science finds
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
    temperature = colorimetry.correlated_temperature(source)
    if not COLDEST <= temperature <= HOTTEST:
        limits = f"{COLDEST:g} K to {HOTTEST:g} K"
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
