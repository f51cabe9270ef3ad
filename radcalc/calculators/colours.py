"""Results of the colour of a spectrum: chromaticity, rendering, rendition, similarity and hue."""

from collections.abc import Callable, Sequence
from functools import cache

from radcalc.answer import Remark, Value
from radcalc.calculators.results import absent, value
from radcalc.quantities.symbols import HUE_BINS
from radcalc.spectra import colorimetry
from radcalc.spectra.colorimetry import Undefined
from radcalc.spectra.spectrum import WHOLE, BlackBody, Range, Spectrum, range_text
from radcalc.tuples import NamedTuple

CHROMATICITY = "the chromaticity: x and y"
UNSEEN = "this spectrum is invisible"
LIT = "a spectrum with light from 360 nm to 830 nm"
REDDEST = 1000  # temperature [K] of a light that may be called white: a candle has 1900
NEAR_CHANGE = 0.01  # of the temperature where a reference changes
COLOURS = ("x", "y", "cct", "duv", "cri")
SPECIAL = tuple(f"r{k}" for k in range(1, 15))
BINS = tuple(f"{name}-h{k}" for name, *_ in HUE_BINS for k in range(1, 17))
RENDITION = ("rf", "rg", *BINS)
HUE = ("dominant-wavelength", "complementary-wavelength", "excitation-purity")
SCREEN = ("srgb-red", "srgb-green", "srgb-blue")
ON_REQUEST = (*SPECIAL, *RENDITION, "ssi", *HUE, *SCREEN)


class Colours(NamedTuple):
    """Results of the colour of a light, with their remarks."""

    values: list[Value]
    assumptions: list[str]
    notes: list[str]


def in_nanometres(name: str, size: float) -> Value:
    """Return a result that is a wavelength or a width [nm]."""
    return value(name, size * 1e-9)._replace(exact=size)


def colours(source: Spectrum, requested: Sequence[str], reference: Spectrum | None) -> Colours:
    """Return the colour of a light, with the requested ones of `ON_REQUEST`.

    `reference` is that of the similarity; by default the usual one.
    """
    light = source.moments(*colorimetry.AT)
    found = Colours([], [], [])
    if not sum(colorimetry.tristimulus(light)) > 0:
        found.values.extend(absent(name, UNSEEN, LIT) for name in (*COLOURS, *requested))
        return found
    _add_rendering(found, source, [name for name in SPECIAL if name in requested])
    sensitive = [name for name in (*SPECIAL, "ssi") if name in requested]
    if sensitive and not source.is_whole and source.widest_step > colorimetry.COARSEST:
        coarse = f"the data are {source.widest_step:g} nm apart: indices of colour may be far off"
        found.notes.append(Remark(coarse, sensitive))
    if names := [name for name in RENDITION if name in requested]:
        _add_rendition(found, source, names)
    if "ssi" in requested:
        _add_similarity(found, source, reference)
    if names := [name for name in HUE if name in requested]:
        _add_hue(found, light, names)
    if names := [name for name in SCREEN if name in requested]:
        _add_screen(found, light, names)
    return found


def _absent(names: Sequence[str], why: str, *instead: str) -> list[Value]:
    """Return results that are undefined; `instead` are others, by default the chromaticity."""
    hint = " and ".join(instead) if instead else CHROMATICITY
    return [absent(name, why, hint, *(instead or ("x", "y"))) for name in names]


def _add_rendering(found: Colours, source: Spectrum, special: Sequence[str]) -> None:
    """Add chromaticity, temperature and colour rendering indices, by CIE 13.3."""
    light = source.moments(*colorimetry.AT)
    (x, y), names = colorimetry.chromaticity(light), ("cri", *special)
    found.values.extend([value("x", x), value("y", y)])
    try:
        if isinstance(source, BlackBody) and source.known == WHOLE:  # by definition
            temperature, distance = source.temperature, 0.0
        else:
            temperature, distance = colorimetry.temperature_and_distance(light)
    except Undefined as error:
        found.values.extend(_absent(("cct", "duv", *names), str(error)))
        return
    found.values.extend([value("cct", temperature), value("duv", distance)])
    if temperature < REDDEST:
        red = f"a light of {temperature:.4g} K is red: colour rendering is meant for white light"
        found.notes.append(Remark(f"cri: {red}", names))
    change = colorimetry.DAYLIGHT_FROM
    if abs(temperature / change - 1) < NEAR_CHANGE:
        turn = f"at {change:g} K the reference changes from a black body to CIE daylight"
        found.notes.append(Remark(f"cri: {turn}", names))
    try:
        like = colorimetry.reference(temperature).moments(*colorimetry.AT)
        if not colorimetry.is_adapted(light):
            raise Undefined("the adaptation of CIE 13.3 is undefined for its chromaticity")
    except Undefined as error:
        found.values.extend(_absent(names, str(error), "cct", "duv"))
        return
    indices = cache(lambda: colorimetry.colour_rendering_indices(light, like))
    found.values.append(value("cri", lambda: colorimetry.colour_rendering_index(indices())))
    found.values.extend(value(name, indices()[SPECIAL.index(name)]) for name in special)
    away = colorimetry.difference(light, like)
    if away > colorimetry.SIMILAR:
        beyond = f"the distance in (u, v) from the reference is {away:.4g}"
        note = f"cri: {beyond}, CIE 13.3 is for up to {colorimetry.SIMILAR:g}"
        found.notes.append(Remark(note, names))


def _add_rendition(found: Colours, source: Spectrum, names: Sequence[str]) -> None:
    """Add the colour rendition by TM-30."""
    try:
        rendered = colorimetry.rendition(source)
    except Undefined as error:
        found.values.extend(_absent(names, str(error)))
        return
    listed = {"rf": rendered.fidelity, "rg": rendered.gamut}
    local = (rendered.local_fidelity, rendered.chroma_shifts, rendered.hue_shifts)
    listed |= dict(zip(BINS, (size for sizes in local for size in sizes), strict=True))
    found.values.extend(value(name, listed[name]) for name in names)
    standard = (
        "colour rendition of white light by ANSI/IES TM-30-18 (R_f is that of CIE 224:2017), with "
        "99 colour samples"
    )
    found.assumptions.append(Remark(standard, RENDITION))
    low, high = colorimetry.MIXED
    if low < (temperature := colorimetry.correlated_temperature(source)) < high:
        mixed = f"R_f of {temperature:.4g} K: from {low:g} K to {high:g} K"
        note = f"{mixed} the reference is a mix of a black body and CIE daylight"
        found.notes.append(Remark(note, RENDITION))
    found.notes.extend(_of_gaps("colour rendition", RENDITION, source, colorimetry.SAMPLED))


def _add_similarity(found: Colours, source: Spectrum, reference: Spectrum | None) -> None:
    try:
        reference = reference or colorimetry.reference_of(source)
        found.values.append(value("ssi", colorimetry.similarity(source, reference)))
    except Undefined as error:
        found.values.extend(_absent(["ssi"], str(error)))
        return
    compared_with = f"ssi (SMPTE ST 2122): compared with {reference.label}"
    found.assumptions.append(Remark(compared_with, ["ssi"]))
    for compared in (source, reference):
        found.notes.extend(
            _of_gaps("ssi", ["ssi"], compared, (colorimetry.FIRST_BAND, colorimetry.LAST_BAND))
        )


def _of_gaps(what: str, names: Sequence[str], source: Spectrum, ends: Range) -> list[str]:
    """Return a note on results if the data do not reach both ends of a range."""
    if source.is_whole or (source.known[0] <= ends[0] and source.known[1] >= ends[1]):
        return []
    known = range_text(source.known)
    note = f"{what}: the data of {source.label} cover {known}; beyond, they are taken as 0"
    return [Remark(note, names)]


def _add_hue(found: Colours, light: colorimetry.Light, names: Sequence[str]) -> None:
    """Add the wavelengths and the purity of the hue, or the reason why they are undefined."""
    try:
        hue = colorimetry.hue(light)
    except Undefined as error:
        found.values.extend(_absent(names, str(error)))
        return
    present, other = HUE[:2] if not hue.is_complementary else HUE[1::-1]
    sizes: dict[str, Callable[[], Value]] = {
        present: lambda: in_nanometres(present, hue.wavelength),
        other: lambda: _absent([other], f"its hue has a {present.replace('-', ' ')}", present)[0],
        "excitation-purity": lambda: value("excitation-purity", hue.purity),
    }
    found.values.extend(sizes[name]() for name in names)
    white = "hue relative to the equal-energy white, x = y = 1/3"
    found.assumptions.append(Remark(white, HUE))
    if present == HUE[0] and (name := colorimetry.hue_name(hue.wavelength)):
        low, high = colorimetry.HUES[name]
        found.notes.append(Remark(f"the hue is {name} (ISO 21348: {low} nm to {high} nm)", HUE))


def _add_screen(found: Colours, light: colorimetry.Light, names: Sequence[str]) -> None:
    levels = [round(255 * part) for part in colorimetry.srgb(colorimetry.tristimulus(light))]
    listed = dict(zip(SCREEN, map(float, levels), strict=True))
    found.values.extend(value(name, listed[name]) for name in names)
    standard = (
        "sRGB (IEC 61966-2-1) from 0 to 255: the greatest is 255, and negative ones are cut to 0"
    )
    found.assumptions.append(Remark(standard, SCREEN))
    written = "".join(f"{level:02x}" for level in levels)
    found.notes.append(Remark(f"the colour in sRGB is #{written}", SCREEN))
