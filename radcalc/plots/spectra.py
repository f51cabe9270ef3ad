"""Pictures of spectra and their colours: curves, chromaticities, TM-30's colour vectors."""

import math
from collections.abc import Sequence

from radcalc.calculators.colours import HUE, RENDITION, SCREEN
from radcalc.errors import ConditionError, UsageError, option
from radcalc.plots import data
from radcalc.quantities.light import RADIANT
from radcalc.quantities.symbols import light_unit, specific_name
from radcalc.spectra import colorimetry, planck
from radcalc.spectra.colorimetry import START, Y, rendition, srgb
from radcalc.spectra.data.colours import X, Z
from radcalc.spectra.observers import OBSERVERS, Observer
from radcalc.spectra.spectrum import VISIBLE, WHOLE, BlackBody, Lines, Range, Spectrum, Table

WAVELENGTH = data.Axis("wavelength \u03bb", "nm")
RELATIVE = data.Axis("relative spectral power")
APART = 2  # nm between two hues
POINTS = 400  # of a black body
SLIVER = 0.05  # of the width of a chart, in which a curve is not readable
WIDEST = 4  # upper limit of a black body's curve, in wavelengths of its peak
EACH = "each relative to its own peak"
IN_THE_PLANE = ("x", "y", "duv", *HUE, *SCREEN)  # results that the diagram explains
BODIES = [1e6 / mired for mired in range(1000, 9, -30)]  # K, evenly along the locus
NAMED = (460, 480, 500, 520, 540, 560, 580, 600, 620)  # nm, of the spectrum locus
TURNS = [2 * math.pi * k / 72 for k in range(72)]  # of a circle
REACH = 1.5  # of the colour vectors, in radii of the reference


def spectra(sources: Sequence[Spectrum], eye: Observer, limits: Range = WHOLE) -> data.Chart:
    """Return spectra in watts per nanometre, with an observer's luminous efficiency.

    Relative spectra, and spectra of different quantities, are relative to their own peaks.  The
    efficiency has its maximum at the greatest value of the spectra.
    """
    quantities = {source.absolute for source in sources}
    unit = ""
    if len(quantities) == 1 and (quantity := quantities.pop()):
        unit = f"{light_unit(quantity, RADIANT)}/nm"
        quantity_name = (
            specific_name(quantity, RADIANT).replace("-", " ").replace("radiant", "").strip()
        )
        axis = data.Axis(f"spectral {quantity_name}", unit)
    else:
        several = len(sources) > 1
        axis = RELATIVE._replace(label=f"{RELATIVE.label}, {EACH}" if several else RELATIVE.label)
    drawn = []
    bodies = [source for source in sources if isinstance(source, BlackBody)]
    tables = [_points(source, limits)[0] for source in sources if source not in bodies]
    thermal = _ends(list(filter(None, tables)), limits) if any(tables) else _thermal(bodies, limits)
    for source in sources:
        x, y = _points(source, thermal if isinstance(source, BlackBody) else limits)
        if not any(y):
            problem = f"{source.label} has no power within the range of the picture"
            raise ConditionError(problem, f"another {option('range')}")
        if not unit:
            peak = max(y)
            y = [value / peak for value in y]
        style = data.LINES if isinstance(source, Lines) else data.LINE
        drawn.append(data.Series(source.label, x, y, style))
    most = max(max(series.y) for series in drawn)
    reference = efficiency(eye, most)
    if unit:
        name = f"{reference.label}, 1 at {most:.3g} {unit}"
        reference = reference._replace(label=name)
    ends = _ends([series.x for series in drawn], limits)
    axis = axis._replace(limits=(0.0, most))
    if VISIBLE[1] - VISIBLE[0] > SLIVER * (ends[1] - ends[0]):
        drawn.append(reference)
    return data.Chart("", WAVELENGTH._replace(limits=ends), axis, drawn, hues=hues())


def efficiency(eye: Observer, most: float = 1.0) -> data.Series:
    """Return an observer's relative luminous efficiency at the wavelengths of its table."""
    x = [float(nm) for nm in range(eye.start, eye.end + 1)]
    label = eye.label.replace("lambda", "\u03bb")
    return data.Series(label, x, [most * value for value in eye.values], data.REFERENCE)


def hues() -> list[data.Tint]:
    """Return the colours of wavelengths, as close as a screen can show them, at full brightness.

    No single wavelength is within sRGB: negative components are omitted.
    """
    return [
        data.Tint(float(START + k), *srgb((X[k], Y[k], Z[k])))
        for k in range(0, len(X), APART)
        if VISIBLE[0] <= START + k <= VISIBLE[1]
    ]


def photon(wavelengths: Sequence[tuple[str, float]], eye: Observer) -> data.Chart:
    """Return a chart of wavelengths [nm] below the photopic and scotopic luminous efficiency."""
    night = OBSERVERS["scotopic"]
    curves = [
        efficiency(observer)._replace(style=data.LINE) for observer in dict.fromkeys((eye, night))
    ]
    ends = VISIBLE
    if wavelengths:
        places = [nm for _, nm in wavelengths]
        ends = min(VISIBLE[0], *places), max(VISIBLE[1], *places)
    axis = data.Axis("relative luminous efficiency", limits=(0.0, 1.0))
    x = WAVELENGTH._replace(limits=ends)
    return data.Chart("", x, axis, curves, wavelengths, hues())


def _ends(places: Sequence[Sequence[float]], limits: Range) -> Range:
    """Return the wavelengths to show: those of the spectra, and all visible ones."""
    if limits != WHOLE and limits[1] < math.inf:
        return limits
    return (min(VISIBLE[0], *(x[0] for x in places)), max(VISIBLE[1], *(x[-1] for x in places)))


def _thermal(bodies: Sequence[BlackBody], limits: Range) -> Range:
    peaks = [body.peak()[0] for body in bodies]
    low, high = min(VISIBLE[0], *peaks, 1e99) / 10, max(VISIBLE[1], *(WIDEST * x for x in peaks), 0)
    return max(low, limits[0]), min(high, limits[1])


def _points(source: Spectrum, limits: Range) -> tuple[list[float], list[float]]:
    """Return wavelengths [nm] and watts per nanometre, or watts for lines."""
    low, high = limits
    if isinstance(source, BlackBody):
        x = [low + (high - low) * k / POINTS for k in range(POINTS + 1)]
        exitances = planck.spectral_exitances([nm * 1e-9 for nm in x], source.temperature)
        return x, [1e-9 * value for value in exitances]
    part = source if limits == WHOLE else source.part(limits)
    if isinstance(part, Lines):
        return [nm for nm, _ in part.lines], [watts for _, watts in part.lines]
    if not isinstance(part, Table):
        return [], []
    x, y = [float(nm) for nm in part.grid], [float(value) for value in part.values]
    if source.is_whole:  # it is 0 beyond its ends; other spectra are unknown there
        return [x[0], *x, x[-1]], [0.0, *y, 0.0]
    return x, y


def diagram(sources: Sequence[Spectrum], wanted: Sequence[str]) -> data.ColourDiagram | None:
    """Return the picture that explains the requested results of colour, if there is one."""
    if not set(wanted).isdisjoint(RENDITION):
        if len(sources) > 1:
            raise UsageError("colour vectors are drawn of one spectrum", "one spectrum")
        return vectors(sources[0])
    return chromaticities(sources) if not set(wanted).isdisjoint(IN_THE_PLANE) else None


def explains(name: str) -> bool:
    """Return whether there is a picture for a result."""
    return name in (*IN_THE_PLANE, *RENDITION)


def chromaticities(sources: Sequence[Spectrum]) -> data.ColourDiagram:
    """Return the chromaticities of lights, with the spectrum locus and the Planckian locus."""
    locus = colorimetry.spectrum_locus()
    bodies = [colorimetry.chromaticity(colorimetry.black_body(kelvin)) for kelvin in BODIES]
    marks = [data.Mark(str(nm), *locus[nm - colorimetry.START]) for nm in NAMED]
    for source in sources:
        light = source.moments(*colorimetry.AT)
        if not sum(light) > 0:
            raise ConditionError(f"{source.label} is invisible", "visible light")
        marks.append(data.Mark(source.label, *colorimetry.chromaticity(light)))
    outline = [*locus, locus[0]]
    series = [
        data.Series("spectrum locus [nm] and line of purples", *_columns(outline), data.LINE),
        data.Series("black bodies, 1000 K to 1e5 K", *_columns(bodies), data.REFERENCE),
    ]
    x, y = (
        data.Axis(f"CIE 1931 {name}", limits=ends)
        for name, ends in (("x", (0, 0.8)), ("y", (0, 0.9)))
    )
    return data.ColourDiagram("", x, y, series, marks)


def vectors(source: Spectrum) -> data.ColourDiagram:
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
        data.Series("reference", *_columns([*circle, circle[0]]), data.REFERENCE),
        data.Series(source.label, *_columns([*lit, lit[0]]), data.LINE),
    ]
    rim = (REACH + 1) / 2
    bins = [(k, math.pi * (2 * k - 1) / len(lit)) for k in range(1, len(lit) + 1)]
    marks = [data.Mark(f"h{k}", rim * math.cos(turn), rim * math.sin(turn)) for k, turn in bins]
    indices = f"Rf {found.fidelity:.0f}, Rg {found.gamut:.0f}"
    title = f"TM-30 colour vectors: {indices}"
    x, y = (data.Axis(name, limits=(-REACH, REACH)) for name in ("a' (relative)", "b' (relative)"))
    arrows = [
        ((a / size, b / size), end)
        for (a, b), size, end in zip(found.reference, radii, lit, strict=True)
    ]
    return data.ColourDiagram(title, x, y, series, marks, arrows)


def _columns(points: Sequence[tuple[float, float]]) -> tuple[list[float], list[float]]:
    return [x for x, _ in points], [y for _, y in points]
