"""Factors between kinds and between spectral densities: wavelengths, spectra, efficacies."""

from typing import TYPE_CHECKING, Any

from radcalc import errors, maths
from radcalc.answer import Formula, Step, format_number
from radcalc.conversion.geometric import BAND, LINK, Factor
from radcalc.errors import option, quote
from radcalc.inputs import Input, Inputs, require
from radcalc.quantities import (
    KIND_NAMES,
    LUMINOUS,
    NONE,
    PER_ENERGY,
    PER_FREQUENCY,
    PER_WAVELENGTH,
    PER_WAVENUMBER,
    PHOTON,
    PHOTON_NAMES,
    RADIANT,
    RATIOS,
    Reading,
    is_per_length,
    name_of,
)
from radcalc.quantities.symbols import EFFICACIES
from radcalc.spectra.observers import (
    LIGHT,
    OBSERVERS,
    PLANCK,
    TRAPEZOIDS,
    Observer,
    bounds,
    luminous_efficacy,
    ratio_text,
    standard_air_wavelength,
)
from radcalc.tuples import NamedTuple
from radcalc.units import Dimension, Photosynthetic
from radcalc.units.dimensions import (
    COHERENT,
    ENERGY,
    FREQUENCY,
    LENGTH,
    PHOTON_ENERGY,
    WAVENUMBER,
)
from radcalc.units.table import resolve

if TYPE_CHECKING:
    from collections.abc import Callable

    from radcalc.conversion.bridge import Bridge, Links
    from radcalc.spectra.spectrum import Spectrum


COUNTED = {RADIANT: "watts", LUMINOUS: "lumens", PHOTON: "photon flux"}
NARROW = 0.1  # largest relative width of a small band, with an error of 0.3 % of the width


class Light(NamedTuple):
    """Light of one wavelength: in vacuum for photons, in standard air for eye response tables."""

    given: Input
    vacuum: Any
    table: Any
    observer: Observer

    @property
    def photon_energy(self) -> Any:
        """The energy of a photon [J]."""
        return PLANCK * LIGHT / self.vacuum


def light(given: Input, observer: Input | None) -> Light:
    """Return the light of a wavelength, frequency, wavenumber or photon energy."""
    value = given.value
    seen_by = OBSERVERS[observer.value if observer else "photopic"]
    if given.dimension == LENGTH:
        return Light(given, value, value, seen_by)
    if given.dimension == FREQUENCY:
        vacuum = LIGHT / value
    elif given.dimension == WAVENUMBER:
        vacuum = 1 / value
    else:
        vacuum = PLANCK * LIGHT / value
    return Light(given, vacuum, standard_air_wavelength(vacuum), seen_by)


VACUUM = "{} is a vacuum wavelength (it differs by 3e-4 in air)"


def kind_factor(of: Light, over: str, under: str) -> Factor:
    """Return the ratio of two kinds, over / under, at one wavelength."""
    given, energy = of.given, of.photon_energy
    is_length = given.dimension == LENGTH
    assumption = ""
    notes: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()
    efficacy: Any = None
    if LUMINOUS in (over, under):
        efficacy = luminous_efficacy(of.table, of.observer)
        if not is_length:
            assumption = f"{given.text} is {format_number(of.table * 1e9)} nm in standard air"
        elif PHOTON not in (over, under):
            curve = of.observer.label.partition(" ")[0]
            assumption = f"{curve} is read at {given.text}, whether in air or in vacuum"
        if maths.any_true(efficacy == 0):
            notes = (
                f"{given.text_where(efficacy == 0)} is invisible: the table spans "
                f"{of.observer.start}-{of.observer.end} nm",
            )
        steps = (efficacy_step(efficacy, of.observer),)
        notes += _of_other_eye(of.observer)
    if PHOTON in (over, under):
        from radcalc.laws import optics
        from radcalc.spectra.spectrum import OUTSIDE, PAR

        energy_text = f"{format_number(energy)} J"
        steps += (optics.PHOTON_ENERGY.formula.step({"wavelength": of.vacuum}, energy_text),)
        photons = f"{given.text} is {format_number(of.vacuum * 1e9)} nm in vacuum"
        vacuum_text = VACUUM.format(given.text) if is_length else photons
        assumption = "; ".join(filter(None, [assumption, vacuum_text]))
        low, high = (end * 1e-9 for end in PAR)
        outside = (of.table < low * (1 - 1e-12)) | (of.table > high * (1 + 1e-12))
        if maths.any_true(outside):
            notes += (f"{given.text_where(outside)} {OUTSIDE}",)
    unit = KIND_UNITS[over, under]
    if LUMINOUS not in (over, under):
        symbol, value = "Q", energy
        forward = over == RADIANT
    elif PHOTON not in (over, under):
        symbol, value = "K", efficacy
        forward = over == LUMINOUS
    else:
        symbol, value = "(K Q)", efficacy * energy
        forward = over == LUMINOUS
    if not forward:
        if maths.any_true(value == 0):
            raise errors.ConditionError(
                f"{quote(given.text)} is invisible: watts or photons cannot be calculated from "
                "a luminous quantity",
                f"a wavelength from {of.observer.start}nm to {of.observer.end}nm",
            )
        symbol, value = f"(1/{symbol})", 1 / value
    return Factor(symbol, value, unit, assumption, steps, notes)


def _of_other_eye(observer: Observer) -> tuple[str, ...]:
    """Return the note on lumens that are not those of V(lambda); none on those of V(lambda)."""
    if observer is OBSERVERS["photopic"]:
        return ()
    return (f"lumens by {observer.label} do not add to lumens by V(lambda)",)


def efficacy_step(efficacy: Any, observer: Observer) -> Step:
    """Return the step of the luminous efficacy of one wavelength [lm/W]."""
    share = format_number(efficacy / observer.maximum)
    return Formula(
        "luminous efficacy of one wavelength",
        f"K = {observer.constant} {observer.label.split()[0]}",
        f"CIE 018:2019; {observer.described}",
    ).with_numbers(f"K = {observer.maximum:g} lm/W * {share} = {format_number(efficacy)} lm/W")


def spectral_factor(
    given: Input,
    over: str,
    under: str,
    limits: Input | None,
    photon_limits: Input | None,
    observer: Input | None,
) -> Factor:
    """Return the ratio of two kinds, over / under, of a whole spectrum."""
    from radcalc.spectra import contents

    source: Spectrum = given.value
    seen_by = OBSERVERS[observer.value if observer else "photopic"]
    ranges = [given_range and given_range.value for given_range in (limits, photon_limits)]
    counted = contents.Counts(source, seen_by, *ranges)
    remarks = [source.described]
    for kind in (over, under):
        if kind != LUMINOUS:
            remarks.append(f"{contents.NAMES[kind]} counted over {counted.over(kind)}")
    amounts = {kind: counted.amount(kind) for kind in (over, under)}
    if not all(amount > 0 or kind == LUMINOUS != under for kind, amount in amounts.items()):
        spectrum_text = option("spectrum", quote(given.text))
        known_range = f"; it is known over {counted.known}" if counted.known else ""
        raise errors.ConditionError(
            f"{spectrum_text} has no light to count there: {'; '.join(remarks[1:])}{known_range}",
            "another spectrum or range",
            [errors.leave_out(given.name) for given in (limits, photon_limits) if given],
        )
    if problem := counted.impossible(over, under):
        raise problem
    value = amounts[over] / amounts[under]
    names = {
        RADIANT: "int(S)",
        LUMINOUS: f"{seen_by.constant} int(S {seen_by.label.split('(')[0]})",
        PHOTON: "int(S lambda/(h c))",
    }
    below = f"({names[under]})" if " int" in names[under] else names[under]
    formula = Formula(
        f"{COUNTED[over]} per {COUNTED[under].removesuffix('s')} in a spectrum",
        f"K = {names[over]} / {below}",
        f"{TRAPEZOIDS}; {seen_by.described}" if LUMINOUS in amounts else TRAPEZOIDS,
    )
    top, bottom = (over, under) if (over, under) in SHOWN else (under, over)
    in_words = ratio_text(amounts[top] / amounts[bottom], top, bottom)
    ratio = f"{format_number(amounts[over])} / {format_number(amounts[under])}"
    step = formula.with_numbers(f"K = {ratio} = {format_number(value)}; that is {in_words}")
    remarks.insert(1, in_words)
    notes = source.notes + tuple(counted.notes((over, under)) + counted.left_out((over, under)))
    if LUMINOUS in amounts:
        notes += _of_other_eye(seen_by)
    if LUMINOUS in amounts and not amounts[LUMINOUS]:
        notes += ("this spectrum is invisible",)
    return Factor("K", value, KIND_UNITS[over, under], "; ".join(remarks), (step,), notes)


SHOWN = [(over, under) for _, over, under in EFFICACIES]


def linked(given: Inputs, over: str, under: str) -> Factor | None:
    """Return the ratio of two kinds, over / under, by the input that links them, or None."""
    observer = given.get("observer")
    if "wavelength" in given:
        return kind_factor(light(given["wavelength"], observer), over, under)
    if "spectrum" in given:
        ranges = given.get("range"), given.get("photon-range")
        return spectral_factor(given["spectrum"], over, under, *ranges, observer)
    return given_ratio(given["efficacy"], over, under, observer) if "efficacy" in given else None


KIND_UNITS = {
    (LUMINOUS, RADIANT): "lm/W",
    (RADIANT, LUMINOUS): "W/lm",
    (PHOTON, RADIANT): "photon/J",
    (RADIANT, PHOTON): "J/photon",
    (LUMINOUS, PHOTON): "lm s/photon",
    (PHOTON, LUMINOUS): "photon/(lm s)",
}


PART_OF_LIGHT = (
    "{} is less than 1/{:.0f} W/lm: these watts are a part of the radiation, such as its UV, which "
    "the lumens do not measure"
)
PER_WATT_OF_LIGHT = (
    "{} is taken per watt of light; the efficacy of a lamp is per electrical watt, and the watts "
    "here would then also be electrical"
)


NOT_OF_PAR = (
    "{} is outside {}, the efficacies of light from 400 nm to 700 nm: some of its light is not of "
    "these wavelengths"
)
PART_OF_WATTS = (
    "{} is less than the {} of light from 400 nm to 700 nm: the watts include other light, or are "
    "electrical"
)
LONGEST = 1e6  # nm: the end of the infrared, and of light
AS_IN_AIR = 1.0003  # wavelengths in vacuum over those in air


USUAL_UNITS = dict(zip(SHOWN, ("lm/W", "umol/J", "lm.s/umol"), strict=True))


def given_ratio(
    given: Input, over: str, under: str, observer: Input | None, ppfd: str = ""
) -> Factor | None:
    """Return a given efficacy as over / under, or None if it links two other kinds.

    `ppfd` is the word for photons from 400 nm to 700 nm only, if there is one.
    """
    value = given.value
    pairs = {dimension: pair for pair, dimension in RATIOS.items()}
    pair = pairs[given.dimension]
    seen_by = OBSERVERS[observer.value if observer else "photopic"]
    notes = _bounded(given, pair, seen_by, ppfd)
    text = f"an efficacy of {given.text}, as given"
    if observer and LUMINOUS in pair:
        text += f", by {seen_by.label}"
    if pair == (over, under):
        return Factor("K", value, KIND_UNITS[over, under], text, notes=notes)
    if pair == (under, over):
        return Factor("(1/K)", 1 / value, KIND_UNITS[over, under], text, notes=notes)
    return None


def _bounded(given: Input, pair: tuple[str, str], seen_by: Observer, ppfd: str) -> tuple[str, ...]:
    """Refuse an efficacy that no light has; return notes on what its light or its watts are."""
    kinds, ratio = (pair, given.value) if pair in SHOWN else (pair[::-1], 1 / given.value)
    _, most = bounds(*kinds, seen_by, (0.0, LONGEST))
    is_beyond = maths.any_true(ratio > most * (1 + 1e-12))
    if PHOTON not in kinds:
        if is_beyond and pair == (RADIANT, LUMINOUS):  # 75 uW/lm, the UV of museums
            return (PART_OF_LIGHT.format(given.text, most),)
        if is_beyond:
            raise _impossible(given, kinds, 0.0, most)
        return (PER_WATT_OF_LIGHT.format(given.text),)
    from radcalc.spectra.spectrum import PAR

    low, high = bounds(*kinds, seen_by, PAR)
    has_watts = RADIANT in kinds  # which may be those of other light, too
    outside = ratio > high * AS_IN_AIR if has_watts else ratio < low / AS_IN_AIR
    is_outside = maths.any_true(outside)
    if is_outside and ppfd:
        raise _impossible(given, kinds, low, high, ppfd)
    if is_beyond:
        raise _impossible(given, kinds, 0.0, most)
    if is_outside:
        return (NOT_OF_PAR.format(given.text_where(outside), _range_text(low, high, kinds)),)
    if ppfd and has_watts and maths.any_true(small := ratio < low / AS_IN_AIR):
        return (PART_OF_WATTS.format(given.text_where(small), _range_text(low, high, kinds)),)
    return ()


def _range_text(low: float, high: float, kinds: tuple[str, str]) -> str:
    first = f"{ratio_text(low, *kinds).partition(' ')[0]} to " if low else "up to "
    return first + ratio_text(high, *kinds)


def _impossible(
    given: Input, kinds: tuple[str, str], low: float, high: float, ppfd: str = ""
) -> errors.Impossible:
    """Return the error for an efficacy out of limits, with its number in the usual unit if in."""
    limit = _range_text(low, high, kinds)
    because = f"no light gives more than {ratio_text(high, *kinds)}"
    if ppfd:
        because = f"{quote(ppfd)} counts photons from 400 nm to 700 nm, whose light gives {limit}"
        low, limit = (0.0, _range_text(0.0, high, kinds)) if RADIANT in kinds else (low, limit)
    unit = resolve(USUAL_UNITS[kinds])
    nearest = ""
    if isinstance(given.number, float) and low <= given.number * unit.factor <= high:
        nearest = f"{given.number:.12g}{unit.text}"
    return errors.Impossible(given.name, given.text, f"an efficacy of {limit}", because, nearest)


class Axis(NamedTuple):
    """An axis of spectral densities, x = constant / wavelength; the wavelength itself has none.

    `letters` are the factors of the constant.  The ends of a band are in `unit`; `example` is a
    width.
    """

    letter: str
    letters: tuple[str, ...]
    constant: float
    unit: str
    example: str
    dimensions: tuple[Dimension, ...]

    def at(self, wavelength: Any) -> Any:
        """Return the place of a wavelength on the axis [SI]."""
        return self.constant / wavelength if self.constant else wavelength

    def slope(self, wavelength: Any) -> Any:
        """Return |dx / d(1/wavelength)|, to which densities are inversely proportional."""
        return self.constant or maths.square(wavelength)


AXES = {
    PER_WAVELENGTH: Axis("lambda", ("lambda^2",), 0.0, "nm", "10nm", (LENGTH,)),
    PER_FREQUENCY: Axis("nu", ("c",), LIGHT, "THz", "1THz", (FREQUENCY,)),
    PER_WAVENUMBER: Axis("sigma", (), 1.0, "cm-1", "10cm-1", (WAVENUMBER,)),
    PER_ENERGY: Axis("Q", ("h", "c"), PLANCK * LIGHT, "eV", "10meV", (ENERGY, PHOTON_ENERGY)),
}
AXIS_UNITS = {axis: COHERENT[row.dimensions[0]] for axis, row in AXES.items()}
OF_DIMENSION = {dimension: axis for axis, row in AXES.items() for dimension in row.dimensions}


def jacobian(of: Light | None, start: str, end: str) -> Factor:
    """Return the factor from a density on one axis to the density on another.

    `of` may be None between frequency, wavenumber and photon energy, which are proportional.
    """
    here, there = AXES[start], AXES[end]
    vacuum = of.vacuum if of else None
    value = here.slope(vacuum) / there.slope(vacuum)
    over, under = (
        " ".join([letter for letter in one.letters if letter not in other.letters])
        for one, other in ((here, there), (there, here))
    )
    if under:
        over = f"{over or 1} / {f'({under})' if ' ' in under else under}"
    text = f"J = |d {here.letter} / d {there.letter}| = {over}"
    numbers, source = f"J = {format_number(value)}", "SI Brochure: exact h and c"
    assumption = "a photon of energy h nu"
    if PER_WAVENUMBER in (start, end):
        assumption = "wavenumber in vacuum, 1 cycle per wavelength"
    if of:
        numbers += f" at {format_number(of.vacuum * 1e9)} nm"
        source = "E_nu = E_lambda lambda^2 / c"
        assumption = f"spectral density at {of.given.text}"
        if of.given.dimension == LENGTH:
            assumption += "; " + VACUUM.format(of.given.text)
    step = Formula("density", text, source).with_numbers(numbers)
    below = AXIS_UNITS[end]
    unit = f"{AXIS_UNITS[start]}/{f'({below})' if '/' in below else below}"
    return Factor("J", value, unit, assumption, (step,))


def width(bridge: "Bridge", given: Input) -> Factor | None:
    """Return the factor between densities, at a wavelength, for the widths of one narrow band.

    None if the units are not of widths of a band, or if the wavelength does not matter.
    """
    start, end = (OF_DIMENSION.get(unit.dimension) for unit in (bridge.source, bridge.target))
    if start is None or end is None or PER_WAVELENGTH not in (start, end):
        return None
    bridge.conditions.used.add(LINK)
    assumption = f"a width that is small compared with {given.text}, the place of its band"
    if given.dimension == LENGTH:
        assumption += "; " + VACUUM.format(given.text)
    of = light(given, None)
    factor = jacobian(of, start, end)._replace(assumption=assumption)

    def check(value: Any) -> None:
        unit, size = quote(bridge.source.text), value * float(bridge.source.factor)

        def text_where(wide: Any) -> str:
            return f"{format_number(maths.chosen(value, wide))}{unit}"

        _check_narrow(of, size, start, end, text_where)

    return factor._replace(check=check)


def _check_narrow(
    of: Light, width: Any, axis: str, other: str, text_where: "Callable[[Any], str]"
) -> None:
    """Raise unless the width of a band is small compared with the place of the band on its axis."""
    on, name = AXES[axis], PHOTON_NAMES[AXES[other].dimensions[0]]
    place = on.at(of.vacuum)
    if maths.any_true(wide := width > NARROW * place):
        both = place - width / 2, place + width / 2
        ends = [maths.chosen(end, wide) / resolve(on.unit).factor for end in both]
        listed = ",".join([f"{format_number(end)}{on.unit}" for end in ends])
        remark = "the two ends of the band"
        raise errors.ConditionError(
            f"a width of {text_where(wide)} is not small compared with "
            f"{option(of.given.name, of.given.text)}: its ends are not at equal distances on both "
            "axes",
            errors.computed(errors.call("photon", listed, get=name, remark=remark)),
        )


def bandwidth(given: Input, of_kind: Input | None) -> Factor:
    """Return the width of a band [m, Hz or cycle/m], in which a kind may be at one wavelength."""
    axis = OF_DIMENSION[given.dimension]
    width = given.value
    if axis == PER_WAVELENGTH:
        require(given, not maths.any_true(width > 1e-3), "at most 1 mm, for a band of wavelengths")
    assumption = f"constant over a band of {given.text}"
    if of_kind is not None and of_kind.name == "wavelength":
        assumption += f", in which all light is treated as light of {of_kind.text}"
    return Factor("B", width, AXIS_UNITS[axis], assumption)


def between(bridge: "Bridge", start: Reading, end: Reading) -> "Links":
    """Return the links between two kinds, and between two axes of spectral density."""
    links = [*_kind(bridge, start, end), *_axis(bridge, start, end)]
    for unit in (bridge.source, bridge.target):
        if isinstance(unit, Photosynthetic):
            _refuse_other_photons(bridge, unit, links)
    return links


def _refuse_other_photons(bridge: "Bridge", unit: Photosynthetic, links: "Links") -> None:
    """Raise for a PPFD of photons that are not from 400 nm to 700 nm."""
    from radcalc.spectra.spectrum import OUTSIDE, PAR

    asked = bridge.conditions.given.get("photon-range")
    notes = [note for factor, _ in links for note in factor.notes]
    if (asked and tuple(asked.value) != PAR) or any(OUTSIDE in note for note in notes):
        raise errors.ConditionError(
            f"{quote(unit.name)} counts photons from 400 nm to 700 nm only",
            errors.correct(unit.name, name_of(unit).replace(" ", "-"), remark="all photons"),
        )


def _wavelength(bridge: "Bridge") -> Light | None:
    """Return the given wavelength or None, marked as used, with its observer."""
    given = bridge.conditions.given.get(LINK)
    if given is None or given.name != "wavelength":
        return None
    bridge.conditions.used.add(LINK)
    return light(given, bridge.conditions.given.get("observer"))


def _kind(bridge: "Bridge", start: Reading, end: Reading) -> "Links":
    """Return the factor between two kinds of light, or none and add a missing condition."""
    if start.kind == end.kind:
        return []
    of = _wavelength(bridge)
    if of is not None:
        if LUMINOUS in (start.kind, end.kind):
            bridge.conditions.use("observer")
        return [(kind_factor(of, end.kind, start.kind), 1)]
    given = bridge.conditions.use(LINK)
    if given is None:
        _refinements(bridge, start, end)  # of the spectrum that is missing
        bridge.want("kind")
        return []
    if given.name == "spectrum":
        return [(_of_spectrum(bridge, given, start, end), 1)]
    seen_by = bridge.conditions.use("observer") if LUMINOUS in (start.kind, end.kind) else None
    units = bridge.source, bridge.target
    ppfd = "".join([unit.name for unit in units if isinstance(unit, Photosynthetic)][:1])
    factor = given_ratio(given, end.kind, start.kind, seen_by, ppfd)
    if factor is None:
        both = f"{KIND_NAMES[start.kind]} and {KIND_NAMES[end.kind]}"
        raise errors.ConditionError(
            f"{option('efficacy', given.text)} does not link {both} quantities",
            option("efficacy", EXAMPLES[frozenset((start.kind, end.kind))]),
        )
    return [(factor, 1)]


EXAMPLES = {
    frozenset((RADIANT, LUMINOUS)): "93lm/W",
    frozenset((RADIANT, PHOTON)): "2.1umol/J",
    frozenset((LUMINOUS, PHOTON)): "54lm.s/umol",
}


def _of_spectrum(bridge: "Bridge", given: Input, start: Reading, end: Reading) -> Factor:
    if start.axis or end.axis:
        raise errors.ConditionError(
            f"{bridge.heading}: {option('spectrum')} links whole bands, not spectral densities",
            errors.Try((("wavelength", ""),), ("spectrum",)),
        )
    return spectral_factor(given, end.kind, start.kind, *_refinements(bridge, start, end))


def _refinements(bridge: "Bridge", start: Reading, end: Reading) -> list[Input | None]:
    """Return the ranges of watts and photons, and the observer, marked as used."""
    both, use = {start.kind, end.kind}, bridge.conditions.use
    needed = (("range", RADIANT), ("photon-range", PHOTON), ("observer", LUMINOUS))
    return [use(name) if kind in both else None for name, kind in needed]


def _axis(bridge: "Bridge", start: Reading, end: Reading) -> "Links":
    """Return the factors between two axes of density, or a density and the whole of a band."""
    if start.axis == end.axis:
        return []
    if NONE not in (start.axis, end.axis):
        return _jacobian(bridge, start.axis, end.axis)
    band = bridge.conditions.use(BAND)
    if band is None:
        strip = any(is_per_length(unit) for unit in (bridge.source, bridge.target))
        bridge.want("per length" if strip else BAND)
        if not strip:
            likely = errors.add("bandwidth", AXES[start.axis or end.axis].example)
            bridge.lacking[BAND] = bridge.lacking[BAND]._replace(choices=(likely,))
        return []
    of_kind = bridge.conditions.given.get(LINK) if start.kind != end.kind else None
    width = bandwidth(band, of_kind)
    if end.axis == NONE:
        return [*_jacobian(bridge, start.axis, OF_DIMENSION[band.dimension], band), (width, 1)]
    return [(width, -1), *_jacobian(bridge, OF_DIMENSION[band.dimension], end.axis, band)]


def _jacobian(bridge: "Bridge", start: str, end: str, band: Input | None = None) -> "Links":
    if start == end:
        return []
    if PER_WAVELENGTH not in (start, end):
        return [(jacobian(None, start, end), 1)]
    of = _wavelength(bridge)
    if of is None:
        bridge.want("axis")
        return []
    if band is not None:
        axis = OF_DIMENSION[band.dimension]
        _check_narrow(of, band.value, axis, end if axis == start else start, band.text_where)
    return [(jacobian(of, start, end), 1)]
