"""Curves: results of several answers, or of arrays, over an input; spectra and their colours.

The pictures of spectra are curves, chromaticities, and TM-30's colour vectors.
"""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from radcalc import errors, plots
from radcalc.answer import Answer, Row
from radcalc.calculators.colours import HUE, RENDITION, SCREEN
from radcalc.calculators.results import pick
from radcalc.errors import ConditionError, UsageError, listed, option, quote
from radcalc.inputs import Input, Inputs
from radcalc.maths import is_array
from radcalc.plots import LINE, POINTS, Axis, Chart, Series
from radcalc.quantities import RADIANT
from radcalc.quantities.symbols import DIRECTION, QUANTITY, light_unit, specific_name
from radcalc.spectra import colorimetry, observers
from radcalc.spectra.colorimetry import START, Y, rendition, srgb
from radcalc.spectra.data.colours import X, Z
from radcalc.spectra.observers import OBSERVERS, Observer
from radcalc.spectra.spectrum import VISIBLE, WHOLE, BlackBody, Lines, Range, Spectrum, Table
from radcalc.units.values import ScaleUnit

MOST = 20_000  # points of a picture
SMOOTH = 16  # least number of points to draw as a line
WIDE = 50.0  # ratio of greatest to least above which an axis may be logarithmic
PREFERRED = ("irradiance", "radiance-toward", "intensity-toward", "luminous-efficacy")
RANGE = "a list or a range of values: {distance=1m:10m:0.1m}"


class Line(NamedTuple):
    """Points of a curve, and the ends of their uncertain values."""

    x: list[float]
    y: list[float]
    low: list[float]
    high: list[float]

    def series(self, label: str) -> Series:
        """Return the curve in the order of x."""
        order = sorted(range(len(self.x)), key=self.x.__getitem__)
        x, y, low, high = ([numbers[k] for k in order] for numbers in self)
        band = (low, high) if low != high else None
        return Series(label, x, y, LINE if len(x) >= SMOOTH else POINTS, band)


LinesByLabel = dict[str, Line]  # by label


class Solved(NamedTuple):
    """The inputs of an answer, and the answer."""

    given: Inputs
    answer: Answer

    @property
    def answers(self) -> list[Answer]:
        return [self.answer, *self.answer.more]


def varied(solved: Sequence[Solved]) -> list[str]:
    """Return the names of the inputs that differ between answers."""
    first = solved[0].given
    return [
        name
        for name, item in first.items()
        if is_array(item.value) or any(other.given[name].text != item.text for other in solved)
    ]


def ranged(given: Inputs) -> errors.Hint:
    """Propose a range of an input for a plot, up to its given value; "" if there is none."""
    for name, item in given.items():
        is_size = isinstance(item.number, (int, float)) and item.number > 0
        if item.symbol.form == QUANTITY and is_size and not isinstance(item.unit, ScaleUnit):
            ends = (f"{item.number * part:.6g}" for part in (0.5, 1, 0.05))
            unit = item.unit_text if item.unit else ""
            return errors.add(name, ":".join(f"{end}{unit}" for end in ends), "a range of values")
    return ""


def without_band(uncertain: Sequence[Input]) -> str:
    """Return the note of a picture that does not show the uncertainty of inputs."""
    texts = dict.fromkeys(f"{item.symbol.label or item.name} {item.text}" for item in uncertain)
    return f"drawn without the uncertainty of {listed([*texts])}"


def curves(solved: Sequence[Solved], wanted: Sequence[str] = ()) -> Chart:
    """Return results as curves; of several varied inputs, the last numeric one is the x axis.

    At least one input must differ between answers, or be an array.  `wanted` are results,
    NAME[:UNIT]; by default the main one.  Raise a UsageError if there is nothing to draw, or
    results have different units.
    """
    _check_arrays(solved[0].given)
    lists = varied(solved)
    numbers = [name for name in lists if _is_number(solved[0].given[name])]
    along = (numbers or lists)[-1]
    other_lists = [name for name in lists if name != along]
    lines, rows = _lines(solved, wanted or [_usual(solved, along)], along, other_lists)
    if len({row.unit for row in rows}) > 1:
        several = " and ".join(dict.fromkeys(f"{row.name} in {row.unit}" for row in rows))
        each = {row.name: errors.add("get", f"{row.name}:{row.unit}") for row in rows}
        raise errors.UsageError(f"{several}: an axis has one unit", [*each.values()])
    _refuse_many(lines)
    is_log = _is_wide([line.x for line in lines.values()]) and _is_wide(
        [[*line.y, *line.low] for line in lines.values()]
    )
    x_axis = Axis(*_axis_name(solved[0].given[along]), is_log=is_log)
    names = list(dict.fromkeys(f"{row.quantity} {row.symbol}".strip() for row in rows))
    y_axis = Axis(names[0] if len(names) == 1 else "", rows[0].unit, is_log=is_log)
    fixed = [item for name, item in solved[0].given.items() if name not in (*other_lists, along)]
    title = ", ".join(f"{item.name} {item.text}".strip() for item in fixed)
    drawn = [line.series(label) for label, line in lines.items()]
    note = _coverage(drawn, [answered.given[along] for answered in solved])
    return Chart(title, x_axis, y_axis, drawn, note=note)


def _coverage(drawn: Sequence[Series], places: Sequence[Input]) -> str:
    """Return the meaning of the bands; "" without any."""
    styles = {series.style for series in drawn if series.band}
    if not styles:
        return ""
    from radcalc.calculators.uncertainty import STANDARD

    kind = " and ".join(
        name for style, name in ((LINE, "band"), (POINTS, "bar")) if style in styles
    )
    text = f"{kind}: \u00b1 {STANDARD}"
    if any(place.is_uncertain for place in places):
        text += f", with that of the {places[0].symbol.label}"
    return text


def _check_arrays(given: Inputs) -> None:
    for item in given.values():
        if is_array(item.value) and (item.value.ndim != 1 or not item.value.size):
            problem = f"{option(item.name)} is an array of the shape {item.value.shape}"
            raise errors.UsageError(problem, "one dimension, with an element or more")


def _lines(
    solved: Sequence[Solved], wanted: Sequence[str], along: str, other_lists: Sequence[str]
) -> tuple[LinesByLabel, list[Row]]:
    """Return the points of each line by its label, and the rows they come from."""
    first = solved[0].given[along]
    lines: LinesByLabel = {}
    rows: list[Row] = []
    for answered in solved:
        places = _places(answered.given[along], first)
        list_texts = [f"{name} {answered.given[name].text}".strip() for name in other_lists]
        for k, answer in enumerate(answered.answers, start=1):
            case = [*list_texts, *([f"answer {k}"] if len(answered.answers) > 1 else [])]
            for name in wanted:
                row = pick(answer.values, name, ", ".join(case))
                rows.append(row)
                label = ", ".join([*([row.quantity] if len(wanted) > 1 else []), *case])
                line = lines.setdefault(label, Line([], [], [], []))
                numbers = _numbers(row.value, len(places))
                ends = row.value - row.uncertainty, row.value + row.uncertainty
                for part, more in zip(line, (places, numbers, *ends), strict=True):
                    part += more if isinstance(more, list) else _numbers(more, len(places))
    return lines, rows


def _usual(solved: Sequence[Solved], along: str) -> str:
    """Return the main result among those that vary."""
    values = [
        value
        for value in solved[0].answer.values
        if not value.is_absent and value.given is None and value.name != along
    ]
    names = [value.name for value in values]
    for name in (*(preferred for preferred in PREFERRED if preferred in names), *names):
        results = [pick(case.answer.values, name).value for case in solved if _has(case, name)]
        if len(results) == len(solved) and (is_array(results[0]) or len(set(results)) > 1):
            return name
    problem = f"no result depends on {option(along)}"
    raise errors.UsageError(problem, "a range of something else")


def _has(solved: Solved, name: str) -> bool:
    return any(value.name == name and not value.is_absent for value in solved.answer.values)


def _places(given: Input, first: Input) -> list[float]:
    """Return positions along the axis, in the unit of the first answer."""
    if given.symbol.form == DIRECTION:
        return [math.degrees(given.value[0])]
    if not _is_number(given):
        problem = f"{option(given.name, quote(given.text))} is not a number for an axis"
        raise errors.ConditionError(problem, errors.mention(RANGE))
    number = given.number
    if given.unit_text != first.unit_text:
        is_on_scale = isinstance(given.unit, ScaleUnit) or isinstance(first.unit, ScaleUnit)
        if is_on_scale or given.dimension != first.dimension:
            problem = f"{option(given.name)} is in {given.unit_text} and in {first.unit_text}"
            raise errors.UsageError(f"{problem}: an axis has one unit", errors.leave_out("plot"))
        number = given.value / float(first.unit.factor if first.unit else 1)
    return [float(x) for x in (number if is_array(number) else [number])]


def _is_number(given: Input) -> bool:
    return given.symbol.form == DIRECTION or (
        given.symbol.form == QUANTITY and given.number is not None
    )


def _axis_name(given: Input) -> tuple[str, str]:
    if given.symbol.form == DIRECTION:
        return "polar angle \u03b8", "deg"
    letter = given.symbol.letter
    unit = "" if given.unit is None else given.unit_text
    return f"{given.symbol.label} {letter}".strip(), unit


def _numbers(value: Any, count: int) -> list[float]:
    return [float(x) for x in value] if is_array(value) else [float(value)] * count


def _refuse_many(lines: LinesByLabel) -> None:
    count = sum(len(line.x) for line in lines.values())
    if count > MOST:
        raise errors.UsageError(f"{count} points are too many for a picture", f"at most {MOST}")


def _is_wide(numbers: Sequence[Sequence[float]]) -> bool:
    values = [x for row in numbers for x in row]
    return min(values) > 0 and max(values) > WIDE * min(values)


WAVELENGTH = plots.Axis("wavelength \u03bb", "nm")
RELATIVE = plots.Axis("relative spectral power")
APART = 2  # nm between two hues
STEPS_OF_BLACK_BODY = 400  # of a black body
SLIVER = 0.05  # of the width of a chart, in which a curve is not readable
WIDEST = 4  # upper limit of a black body's curve, in wavelengths of its peak
EACH = "each relative to its own peak"
IN_THE_PLANE = ("x", "y", "duv", *HUE, *SCREEN)  # results that the diagram explains
BODIES = [1e6 / mired for mired in range(1000, 9, -30)]  # K, evenly along the locus
NAMED = (460, 480, 500, 520, 540, 560, 580, 600, 620)  # nm, of the spectrum locus
TURNS = [2 * math.pi * k / 72 for k in range(72)]  # of a circle
REACH = 1.5  # of the colour vectors, in radii of the reference


def spectra(sources: Sequence[Spectrum], eye: Observer, limits: Range = WHOLE) -> plots.Chart:
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
        axis = plots.Axis(f"spectral {quantity_name}", unit)
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
        style = plots.LINES if isinstance(source, Lines) else plots.LINE
        drawn.append(plots.Series(source.label, x, y, style))
    most = max(max(series.y) for series in drawn)
    reference = efficiency(eye, most)
    if unit:
        name = f"{reference.label}, 1 at {most:.3g} {unit}"
        reference = reference._replace(label=name)
    ends = _ends([series.x for series in drawn], limits)
    axis = axis._replace(limits=(0.0, most))
    if VISIBLE[1] - VISIBLE[0] > SLIVER * (ends[1] - ends[0]):
        drawn.append(reference)
    return plots.Chart("", WAVELENGTH._replace(limits=ends), axis, drawn, hues=hues())


def efficiency(eye: Observer, most: float = 1.0) -> plots.Series:
    """Return an observer's relative luminous efficiency at the wavelengths of its table."""
    x = [float(nm) for nm in range(eye.start, eye.end + 1)]
    label = eye.label.replace("lambda", "\u03bb")
    return plots.Series(label, x, [most * value for value in eye.values], plots.REFERENCE)


def hues() -> list[plots.Tint]:
    """Return the colours of wavelengths, as close as a screen can show them, at full brightness.

    No single wavelength is within sRGB: negative components are omitted.
    """
    return [
        plots.Tint(float(START + k), *srgb((X[k], Y[k], Z[k])))
        for k in range(0, len(X), APART)
        if VISIBLE[0] <= START + k <= VISIBLE[1]
    ]


def photon(wavelengths: Sequence[tuple[str, float]], eye: Observer) -> plots.Chart:
    """Return a chart of wavelengths [nm] below the photopic and scotopic luminous efficiency."""
    night = OBSERVERS["scotopic"]
    curves = [
        efficiency(observer)._replace(style=plots.LINE) for observer in dict.fromkeys((eye, night))
    ]
    ends = VISIBLE
    if wavelengths:
        places = [nm for _, nm in wavelengths]
        ends = min(VISIBLE[0], *places), max(VISIBLE[1], *places)
    axis = plots.Axis("relative luminous efficiency", limits=(0.0, 1.0))
    x = WAVELENGTH._replace(limits=ends)
    return plots.Chart("", x, axis, curves, wavelengths, hues())


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
        x = [low + (high - low) * k / STEPS_OF_BLACK_BODY for k in range(STEPS_OF_BLACK_BODY + 1)]
        exitances = observers.spectral_exitances([nm * 1e-9 for nm in x], source.temperature)
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


def diagram(sources: Sequence[Spectrum], wanted: Sequence[str]) -> plots.ColourDiagram | None:
    """Return the picture that explains the requested results of colour, if there is one."""
    if not set(wanted).isdisjoint(RENDITION):
        if len(sources) > 1:
            raise UsageError("colour vectors are drawn of one spectrum", "one spectrum")
        return vectors(sources[0])
    return chromaticities(sources) if not set(wanted).isdisjoint(IN_THE_PLANE) else None


def explains(name: str) -> bool:
    """Return whether there is a picture for a result."""
    return name in (*IN_THE_PLANE, *RENDITION)


def chromaticities(sources: Sequence[Spectrum]) -> plots.ColourDiagram:
    """Return the chromaticities of lights, with the spectrum locus and the Planckian locus."""
    locus = colorimetry.spectrum_locus()
    bodies = [colorimetry.chromaticity(colorimetry.black_body(kelvin)) for kelvin in BODIES]
    marks = [plots.Mark(str(nm), *locus[nm - colorimetry.START]) for nm in NAMED]
    for source in sources:
        light = source.moments(*colorimetry.AT)
        if not sum(light) > 0:
            raise ConditionError(f"{source.label} is invisible", "visible light")
        marks.append(plots.Mark(source.label, *colorimetry.chromaticity(light)))
    outline = [*locus, locus[0]]
    series = [
        plots.Series("spectrum locus [nm] and line of purples", *_columns(outline), plots.LINE),
        plots.Series("black bodies, 1000 K to 1e5 K", *_columns(bodies), plots.REFERENCE),
    ]
    x, y = (
        plots.Axis(f"CIE 1931 {name}", limits=ends)
        for name, ends in (("x", (0, 0.8)), ("y", (0, 0.9)))
    )
    return plots.ColourDiagram("", x, y, series, marks)


def vectors(source: Spectrum) -> plots.ColourDiagram:
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
        plots.Series("reference", *_columns([*circle, circle[0]]), plots.REFERENCE),
        plots.Series(source.label, *_columns([*lit, lit[0]]), plots.LINE),
    ]
    rim = (REACH + 1) / 2
    bins = [(k, math.pi * (2 * k - 1) / len(lit)) for k in range(1, len(lit) + 1)]
    marks = [plots.Mark(f"h{k}", rim * math.cos(turn), rim * math.sin(turn)) for k, turn in bins]
    indices = f"Rf {found.fidelity:.0f}, Rg {found.gamut:.0f}"
    title = f"TM-30 colour vectors: {indices}"
    x, y = (plots.Axis(name, limits=(-REACH, REACH)) for name in ("a' (relative)", "b' (relative)"))
    arrows = [
        ((a / size, b / size), end)
        for (a, b), size, end in zip(found.reference, radii, lit, strict=True)
    ]
    return plots.ColourDiagram(title, x, y, series, marks, arrows)


def _columns(points: Sequence[tuple[float, float]]) -> tuple[list[float], list[float]]:
    return [x for x, _ in points], [y for _, y in points]
