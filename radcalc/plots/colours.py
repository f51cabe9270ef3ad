"""Pictures of colour: the chromaticity diagram, and the colour vectors of TM-30."""

import math
from collections.abc import Sequence

from radcalc.calculators.colours import HUE, RENDITION, SCREEN
from radcalc.errors import ConditionError, UsageError
from radcalc.plots.data import LINE, REFERENCE, Axis, ColourDiagram, Mark, Series
from radcalc.spectra import colorimetry
from radcalc.spectra.rendition import rendition
from radcalc.spectra.spectrum import Spectrum

IN_THE_PLANE = ("x", "y", "duv", *HUE, *SCREEN)  # results that the diagram explains
BODIES = [1e6 / mired for mired in range(1000, 9, -30)]  # K, evenly along the locus
NAMED = (460, 480, 500, 520, 540, 560, 580, 600, 620)  # nm, of the spectrum locus
TURNS = [2 * math.pi * k / 72 for k in range(72)]  # of a circle
REACH = 1.5  # of the colour vectors, in radii of the reference


def diagram(sources: Sequence[Spectrum], wanted: Sequence[str]) -> ColourDiagram | None:
    """Return the picture that explains the requested results of colour, if there is one."""
    if not set(wanted).isdisjoint(RENDITION):
        if len(sources) > 1:
            raise UsageError("colour vectors are drawn of one spectrum", "one spectrum")
        return vectors(sources[0])
    return chromaticities(sources) if not set(wanted).isdisjoint(IN_THE_PLANE) else None


def explains(name: str) -> bool:
    """Return whether there is a picture for a result."""
    return name in (*IN_THE_PLANE, *RENDITION)


def chromaticities(sources: Sequence[Spectrum]) -> ColourDiagram:
    """Return the chromaticities of lights, with the spectrum locus and the Planckian locus."""
    locus = colorimetry.spectrum_locus()
    bodies = [colorimetry.chromaticity(colorimetry.black_body(kelvin)) for kelvin in BODIES]
    marks = [Mark(str(nm), *locus[nm - colorimetry.START]) for nm in NAMED]
    for source in sources:
        light = source.moments(*colorimetry.AT)
        if not sum(light) > 0:
            raise ConditionError(f"{source.label} is invisible", "visible light")
        marks.append(Mark(source.label, *colorimetry.chromaticity(light)))
    outline = [*locus, locus[0]]
    series = [
        Series("spectrum locus [nm] and line of purples", *_columns(outline), LINE),
        Series("black bodies, 1000 K to 1e5 K", *_columns(bodies), REFERENCE),
    ]
    x, y = (
        Axis(f"CIE 1931 {name}", limits=ends) for name, ends in (("x", (0, 0.8)), ("y", (0, 0.9)))
    )
    return ColourDiagram("", x, y, series, marks)


def vectors(source: Spectrum) -> ColourDiagram:
    """Return the colour vector graphic of a light: mean colours of the hue bins of TM-30.

    They are relative to the reference, whose colours are on a circle of radius 1.
    """
    try:
        found = rendition(source)
    except colorimetry.Undefined as error:
        raise ConditionError(
            f"no colour vectors of {source.label}: {error}", "white light"
        ) from None
    circle = [(math.cos(turn), math.sin(turn)) for turn in TURNS]
    radii = [math.hypot(*mean) for mean in found.reference]
    lit = [(a / size, b / size) for (a, b), size in zip(found.test, radii, strict=True)]
    series = [
        Series("reference", *_columns([*circle, circle[0]]), REFERENCE),
        Series(source.label, *_columns([*lit, lit[0]]), LINE),
    ]
    rim = (REACH + 1) / 2
    bins = [(k, math.pi * (2 * k - 1) / len(lit)) for k in range(1, len(lit) + 1)]
    marks = [Mark(f"h{k}", rim * math.cos(turn), rim * math.sin(turn)) for k, turn in bins]
    indices = f"Rf {found.fidelity:.0f}, Rg {found.gamut:.0f}"
    title = f"TM-30 colour vectors: {indices}"
    x, y = (Axis(name, limits=(-REACH, REACH)) for name in ("a' (relative)", "b' (relative)"))
    arrows = [
        ((a / size, b / size), end)
        for (a, b), size, end in zip(found.reference, radii, lit, strict=True)
    ]
    return ColourDiagram(title, x, y, series, marks, arrows)


def _columns(points: Sequence[tuple[float, float]]) -> tuple[list[float], list[float]]:
    return [x for x, _ in points], [y for _, y in points]
