"""Factors between kinds and between spectral densities: wavelengths, spectra, efficacies."""

from typing import TYPE_CHECKING, Any

from radcalc import errors, maths
from radcalc.answer import Formula, Step, format_number
from radcalc.conversion.geometric import BAND, LINK, Factor
from radcalc.errors import option, quote
from radcalc.inputs import Input, Inputs, require
from radcalc.inputs.quantities import as_seen
from radcalc.quantities import (
    FLUX,
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
    Reading,
    base_of,
    describe,
    is_per_length,
    kind_of_observer,
    name_of,
    names,
    ratio_of,
    ratio_unit,
)
from radcalc.quantities.symbols import EFFICACIES
from radcalc.spectra import observers as weights
from radcalc.spectra.observers import (
    LIGHT,
    PLANCK,
    TRAPEZOIDS,
    Observer,
    luminous_efficacy,
    standard_air_wavelength,
)
from radcalc.tuples import NamedTuple
from radcalc.units import Dimension, Photosynthetic, Unit
from radcalc.units.compiled import WEIGHTS
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
    from collections.abc import Callable, Sequence

    from radcalc.conversion.bridge import Bridge, Links
    from radcalc.spectra.spectrum import Spectrum


NARROW = 0.1  # largest relative width of a small band, with an error of 0.3 % of the width


class Light(NamedTuple):
    """Light of one wavelength: in vacuum for photons, in standard air for tables of weights."""

    given: Input
    vacuum: Any
    table: Any

    @property
    def photon_energy(self) -> Any:
        """The energy of a photon [J]."""
        return PLANCK * LIGHT / self.vacuum


def light(given: Input) -> Light:
    """Return the light of a wavelength, frequency, wavenumber or photon energy."""
    value = given.value
    if given.dimension == LENGTH:
        return Light(given, value, value)
    if given.dimension == FREQUENCY:
        vacuum = LIGHT / value
    elif given.dimension == WAVENUMBER:
        vacuum = 1 / value
    else:
        vacuum = PLANCK * LIGHT / value
    return Light(given, vacuum, standard_air_wavelength(vacuum))


VACUUM = "{} is a vacuum wavelength (it differs by 3e-4 in air)"


def kind_factor(of: Light, over: str, under: str) -> Factor:
    """Return the ratio of two kinds, over / under, at one wavelength."""
    kinds = over, under
    tables = [kind for kind in kinds if kind not in (RADIANT, PHOTON)]
    counted = [kind for kind in kinds if base_of(kind) == PHOTON]
    values: dict[str, Any] = {RADIANT: 1.0}
    assumption = ""
    notes: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()
    for kind in tables:
        value, step, note = _by_table(of, kind)
        values[kind] = value
        notes += note
        steps += (step,)
    if tables and of.given.dimension != LENGTH:
        assumption = f"{of.given.text} is {format_number(of.table * 1e9)} nm in standard air"
    elif tables and not counted:
        curves = " and ".join([_curve(kind) for kind in tables])
        are = "is" if len(tables) == 1 else "are"
        assumption = f"{curves} {are} read at {of.given.text}, whether in air or in vacuum"
    if counted:
        further, step, note = _of_photons(of, plain=PHOTON in kinds)
        assumption = "; ".join(filter(None, [assumption, further]))
        steps += (step,)
        notes += note
        energy = of.photon_energy
        values |= {kind: values.get(kind, 1.0) / energy for kind in counted}
    for kind in kinds:
        if maths.any_true(values[kind] == 0) and kind == under:
            raise _unseen(of, kind)
    symbol, value = _ratio_at(of, over, under, values)
    return Factor(symbol, value, ratio_unit(over, under), assumption, steps, notes)


def _ratio_at(of: Light, over: str, under: str, values: dict[str, Any]) -> tuple[str, Any]:
    """Return the letters and the value of a ratio of kinds at one wavelength."""
    energy = of.photon_energy
    if {over, under} == {RADIANT, PHOTON}:
        return ("Q", energy) if over == RADIANT else ("(1/Q)", 1 / energy)
    eyes = [base_of(kind) == LUMINOUS for kind in (over, under)]
    if eyes[0] and under in (RADIANT, PHOTON):
        return ("K", values[over]) if under == RADIANT else ("(K Q)", values[over] * energy)
    if eyes[1] and over in (RADIANT, PHOTON):
        if over == RADIANT:
            return "(1/K)", 1 / values[under]
        return "(1/(K Q))", 1 / (values[under] * energy)
    return "k", values[over] / values[under]


def _curve(kind: str) -> str:
    eye = weights.observer_of(kind)
    return eye.label.partition(" ")[0] if eye else f"w({KIND_NAMES[kind]})"


def _by_table(of: Light, kind: str) -> tuple[Any, Step, tuple[str, ...]]:
    """Return the light of a kind in a watt or a photon of one wavelength, by its table."""
    if eye := weights.observer_of(kind):
        value = luminous_efficacy(of.table, eye)
        step, ends = efficacy_step(value, eye), (eye.start, eye.end)
        absent = f"is invisible: the table spans {ends[0]}-{ends[1]} nm"
    else:
        own = weights.weight(kind)
        value = own.at(of.table * 1e9)
        formula = Formula("weight of one wavelength", f"w = {_curve(kind)}", own.described)
        step = formula.with_numbers(f"w = {format_number(value)}")
        absent = "has no {} light: the weight spans {:g}-{:g} nm".format(
            KIND_NAMES[kind], *own.range
        )
    dark = value == 0
    notes = (f"{of.given.text_where(dark)} {absent}",) if maths.any_true(dark) else ()
    return value, step, notes


def _of_photons(of: Light, *, plain: bool) -> tuple[str, Step, tuple[str, ...]]:
    """Return the assumption, the step and the notes on photons of one wavelength."""
    from radcalc.laws import optics
    from radcalc.spectra.spectrum import OUTSIDE, PAR

    given = of.given
    energy_text = f"{format_number(of.photon_energy)} J"
    step = optics.PHOTON_ENERGY.formula.step({"wavelength": of.vacuum}, energy_text)
    photons = f"{given.text} is {format_number(of.vacuum * 1e9)} nm in vacuum"
    vacuum_text = VACUUM.format(given.text) if given.dimension == LENGTH else photons
    low, high = (end * 1e-9 for end in PAR)
    outside = (of.table < low * (1 - 1e-12)) | (of.table > high * (1 + 1e-12))
    is_outside = plain and maths.any_true(outside)
    notes = (f"{given.text_where(outside)} {OUTSIDE}",) if is_outside else ()
    return vacuum_text, step, notes


def _unseen(of: Light, kind: str) -> errors.ConditionError:
    """Return the error for light of a wavelength at which a kind has none."""
    eye = weights.observer_of(kind)
    if eye is None:
        own = weights.weight(kind)
        return errors.ConditionError(
            f"{quote(of.given.text)} has no {KIND_NAMES[kind]} light, from which other light "
            "cannot be calculated",
            "a wavelength from {:g}nm to {:g}nm".format(*own.range),
        )
    return errors.ConditionError(
        f"{quote(of.given.text)} is invisible: watts or photons cannot be calculated from "
        "a luminous quantity",
        f"a wavelength from {eye.start}nm to {eye.end}nm",
    )


def efficacy_step(efficacy: Any, observer: Observer) -> Step:
    """Return the step of the luminous efficacy of one wavelength [lm/W]."""
    share = format_number(efficacy / observer.maximum)
    return Formula(
        "luminous efficacy of one wavelength",
        f"K = {observer.constant} {observer.label.split()[0]}",
        f"CIE 018:2019; {observer.described}",
    ).with_numbers(f"K = {observer.maximum:g} lm/W * {share} = {format_number(efficacy)} lm/W")


def in_kinds(
    source: Unit, target: Unit, given: "Sequence[Input]"
) -> tuple[Unit, Unit, list[Input]]:
    """Return units in the kinds of an observer and of a weight, and the other conditions.

    The lumens of a call are those of its observer; the weight is that of the target.
    Raises Unused for an observer without lumens, or a weight of other light than the target's.
    """
    for condition in given:
        if condition.name == "observer":
            kind = kind_of_observer(condition.value)
            source, target = names.as_seen(source, kind), names.as_seen(target, kind)
            given = [as_seen(one, kind) for one in given]
            lumens = [one.unit for one in given if one.name == "efficacy" and one.unit]
            if not any(names.is_seen(unit, kind) for unit in (source, target, *lumens)):
                raise errors.Unused(["observer"], "without lumens")
        elif condition.name == "weight":
            target = names.weighted(target, condition.value)
            if not names.is_seen(target, condition.value):
                where = f"to {describe(target)}"
                raise errors.Unused(["weight"], where)
    others = {one.name: one for one in given if one.name not in ("observer", "weight")}
    return source, target, [*behind_filter(others).values()]


def behind_filter(given: Inputs) -> Inputs:
    """Return inputs with the spectrum behind the filter, if there is one.

    Raises Unused for a filter without a spectrum.
    """
    if "filter" not in given:
        return given
    if "spectrum" not in given:
        raise errors.Unused(["filter"], f"without {option('spectrum')}")
    from radcalc.spectra.sources import through

    spectrum, others = given["spectrum"], {**given}
    filtered = through(spectrum.value, others.pop("filter").value)
    return {**others, "spectrum": spectrum._replace(value=filtered)}


class Refined(NamedTuple):
    """The inputs that refine a spectrum: the ranges of watts and photons, and darkness outside."""

    limits: Input | None = None
    photon_limits: Input | None = None
    dark: Input | None = None


def spectral_factor(given: Input, over: str, under: str, refined: Refined) -> Factor:
    """Return the ratio of two kinds, over / under, of a whole spectrum."""
    from radcalc.spectra import contents

    source: Spectrum = given.value
    ranges = [one and one.value for one in refined[:2]]
    counted = contents.Counts(source, *ranges, is_dark_outside=refined.dark is not None)
    remarks = [source.described]
    for kind in (over, under):
        if kind in counted.ranges:
            remarks.append(f"{contents.NAMES[kind]} counted over {counted.over(kind)}")
        elif limits := weights.range_of(kind):
            remarks.append("{} weight over {:g}-{:g} nm".format(KIND_NAMES[kind], *limits))
    amounts = {kind: counted.amount(kind) for kind in (over, under)}
    if not all(
        amount > 0 or kind not in (under, *counted.ranges) for kind, amount in amounts.items()
    ):
        spectrum_text = option("spectrum", quote(given.text))
        known_range = f"; it is known over {counted.known}" if counted.known else ""
        raise errors.ConditionError(
            f"{spectrum_text} has no light to count there: {'; '.join(remarks[1:])}{known_range}",
            "another spectrum or range",
            [errors.leave_out(one.name) for one in refined[:2] if one],
        )
    if problem := counted.impossible(over, under):
        raise problem
    value = amounts[over] / amounts[under]
    step, in_words = _spectral_step(amounts, over, under)
    remarks.insert(1, in_words)
    kinds = over, under
    notes = source.notes + tuple(counted.notes(kinds) + counted.left_out(kinds))
    notes += tuple(
        [
            "this spectrum is invisible"
            if kind == LUMINOUS
            else f"this spectrum has no {contents.name_of(kind)}"
            for kind in kinds
            if not amounts[kind]
        ]
    )
    if refined.dark:
        notes += (f"{source.label} is taken as dark outside its data",)
    return Factor("K", value, ratio_unit(over, under), "; ".join(remarks), (step,), notes)


def _spectral_step(amounts: dict[str, float], over: str, under: str) -> tuple[Step, str]:
    """Return the step of a ratio of kinds in a spectrum, and the ratio in words."""
    from radcalc.spectra import contents

    names, sources = {}, [TRAPEZOIDS]
    for kind in (over, under):
        names[kind] = {RADIANT: "int(S)", PHOTON: "int(S lambda/(h c))"}.get(kind, "")
        if eye := weights.observer_of(kind):
            names[kind] = f"{eye.constant} int(S {eye.label.split('(')[0]})"
            sources.append(eye.described)
        elif not names[kind]:
            own = weights.weight(kind)
            by_energy = " lambda/(h c)" if own.acts_on == PHOTON else ""
            names[kind] = f"int(S {_curve(kind)}{by_energy})"
            sources.append(own.described)
    below = f"({names[under]})" if " int" in names[under] else names[under]
    counted = {kind: "photon flux" if kind == PHOTON else contents.name_of(kind) for kind in names}
    formula = Formula(
        f"{counted[over]} per {counted[under].removesuffix('s')} in a spectrum",
        f"K = {names[over]} / {below}",
        "; ".join(sources),
    )
    is_usual = (over, under) in SHOWN or (over in WEIGHTS and (under, over) not in SHOWN)
    top, bottom = (over, under) if is_usual else (under, over)
    in_words = (
        weights.ratio_text(amounts[top] / amounts[bottom], top, bottom) if amounts[bottom] else ""
    )
    value = format_number(amounts[over] / amounts[under])
    ratio = f"{format_number(amounts[over])} / {format_number(amounts[under])}"
    return formula.with_numbers(f"K = {ratio} = {value}; that is {in_words}"), in_words


SHOWN = [(over, under) for _, over, under in EFFICACIES]


def refined_by(given: Inputs) -> Refined:
    """Return the inputs among others that refine a spectrum."""
    return Refined(*map(given.get, ("range", "photon-range", "dark-outside")))


def linked(given: Inputs, over: str, under: str) -> Factor | None:
    """Return the ratio of two kinds, over / under, by the input that links them, or None."""
    if "wavelength" in given:
        return kind_factor(light(given["wavelength"]), over, under)
    if "spectrum" in given:
        return spectral_factor(given["spectrum"], over, under, refined_by(given))
    return given_ratio(given["efficacy"], over, under) if "efficacy" in given else None


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


def given_ratio(given: Input, over: str, under: str, ppfd: str = "") -> Factor | None:
    """Return a given efficacy as over / under, or None if it links two other kinds.

    `ppfd` is the word for photons from 400 nm to 700 nm only, if there is one.
    """
    value = given.value
    pair = ratio_of(given.dimension)
    assert pair is not None
    notes = _bounded(given, pair, ppfd)
    text = f"an efficacy of {given.text}, as given"
    if pair == (over, under):
        return Factor("K", value, ratio_unit(over, under), text, notes=notes)
    if pair == (under, over):
        return Factor("(1/K)", 1 / value, ratio_unit(over, under), text, notes=notes)
    return None


def _bounded(given: Input, pair: tuple[str, str], ppfd: str) -> tuple[str, ...]:
    """Refuse an efficacy that no light has; return notes on what its light or its watts are."""
    is_usual = (base_of(pair[0]), base_of(pair[1])) in SHOWN or pair[0] in WEIGHTS
    kinds, ratio = (pair, given.value) if is_usual else (pair[::-1], 1 / given.value)
    _, most = weights.bounds(*kinds, (0.0, LONGEST))
    is_beyond = maths.any_true(ratio > most * (1 + 1e-12))
    if PHOTON not in kinds:
        if is_beyond and pair == (RADIANT, LUMINOUS):  # 75 uW/lm, the UV of museums
            return (PART_OF_LIGHT.format(given.text, most),)
        if is_beyond:
            raise _impossible(given, kinds, 0.0, most)
        return (PER_WATT_OF_LIGHT.format(given.text),) if RADIANT in kinds else ()
    if not {*kinds} <= {RADIANT, LUMINOUS, PHOTON}:
        if is_beyond:
            raise _impossible(given, kinds, 0.0, most)
        return ()
    from radcalc.spectra.spectrum import PAR

    low, high = weights.bounds(*kinds, PAR)
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
    first = f"{weights.ratio_text(low, *kinds).partition(' ')[0]} to " if low else "up to "
    return first + weights.ratio_text(high, *kinds)


def _impossible(
    given: Input, kinds: tuple[str, str], low: float, high: float, ppfd: str = ""
) -> errors.Impossible:
    """Return the error for an efficacy out of limits, with its number in the usual unit if in."""
    limit = _range_text(low, high, kinds)
    because = f"no light gives more than {weights.ratio_text(high, *kinds)}"
    if ppfd:
        because = f"{quote(ppfd)} counts photons from 400 nm to 700 nm, whose light gives {limit}"
        low, limit = (0.0, _range_text(0.0, high, kinds)) if RADIANT in kinds else (low, limit)
    unit = resolve(USUAL_UNITS.get(kinds) or f"({ratio_unit(*kinds)})")
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
    of = light(given)
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
    """Return the given wavelength or None, marked as used."""
    given = bridge.conditions.given.get(LINK)
    if given is None or given.name != "wavelength":
        return None
    bridge.conditions.used.add(LINK)
    return light(given)


def response(bridge: "Bridge", given: Input) -> Factor:
    """Return the responsivity of a file at a wavelength, or under a spectrum [A/W]."""
    own, link = given.value, bridge.conditions.use(LINK)
    if link is None or link.name == "efficacy":
        raise errors.MissingInput(
            f"{bridge.heading}: the wavelength or the spectrum of the light is missing",
            errors.mention("{spectrum=sun} or {wavelength=850nm}"),
            [errors.add("spectrum", "sun"), errors.add("wavelength", "850nm")],
        )
    if link.name == "wavelength":
        value = own.at(light(link).table * 1e9)
        text = f"{own.label} at {link.text}"
        if maths.any_true(value == 0):
            raise errors.ConditionError(f"{text} is 0", "a wavelength within its response")
        step = Formula("responsivity of one wavelength", "s = s(lambda)", own.source)
        return Factor("s", value, "A/W", text, (step.with_numbers(f"s = {value:.6g} A/W"),))
    from radcalc.spectra.contents import responsivity
    from radcalc.spectra.spectrum import range_text

    dark = bridge.conditions.use("dark-outside")
    value = responsivity(own, link.value, link.value.limits, is_dark_outside=dark is not None)
    if not value:
        raise errors.ConditionError(f"{own.label} does not respond to {link.text}", "another light")
    low, high = link.value.limits
    step = Formula("responsivity under a spectrum", "s = int(S s) / int(S)", own.source)
    counted = f"watts counted over {range_text((low, high))}"
    text = f"{own.label} under {link.value.described}; {counted}"
    return Factor("s", value, "A/W", text, (step.with_numbers(f"s = {value:.6g} A/W"),))


def _kind(bridge: "Bridge", start: Reading, end: Reading) -> "Links":
    """Return the factor between two kinds of light, or none and add a missing condition."""
    if start.kind == end.kind:
        return []
    of = _wavelength(bridge)
    if of is not None:
        return [(kind_factor(of, end.kind, start.kind), 1)]
    given = bridge.conditions.use(LINK)
    if given is None:
        _refinements(bridge, start, end)  # of the spectrum that is missing
        bridge.want("kind")
        return []
    if given.name == "spectrum":
        return [(_of_spectrum(bridge, given, start, end), 1)]
    units = bridge.source, bridge.target
    ppfd = "".join([unit.name for unit in units if isinstance(unit, Photosynthetic)][:1])
    factor = given_ratio(given, end.kind, start.kind, ppfd)
    if factor is None:
        both = f"{KIND_NAMES[start.kind]} and {KIND_NAMES[end.kind]}"
        usual = frozenset(map(base_of, (start.kind, end.kind)))
        example = EXAMPLES[usual] if usual in EXAMPLES and start.kind in FLUX else ""
        raise errors.ConditionError(
            f"{option('efficacy', given.text)} does not link {both} quantities",
            option("efficacy", example or f"1{ratio_unit(end.kind, start.kind)}"),
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
    return spectral_factor(given, end.kind, start.kind, _refinements(bridge, start, end))


def _refinements(bridge: "Bridge", start: Reading, end: Reading) -> Refined:
    """Return the ranges of watts and photons, and darkness beside a weight, marked as used."""
    both, use = {start.kind, end.kind}, bridge.conditions.use
    is_weighted = any(kind in WEIGHTS for kind in both)
    return Refined(
        use("range") if RADIANT in both else None,
        use("photon-range") if PHOTON in both else None,
        use("dark-outside") if is_weighted else None,
    )


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
