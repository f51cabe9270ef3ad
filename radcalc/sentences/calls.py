"""The call of a command that a sentence means: its facts decide."""

from collections.abc import Iterable, Iterator, Sequence
from functools import reduce

from radcalc.calculators.page import Page
from radcalc.calculators.pages import page_of
from radcalc.errors import (
    Try,
    UnitError,
    UsageError,
    correct,
    corrections,
    listed,
    manual,
    quote,
    quote_path,
)
from radcalc.quantities.light import Reading, result_name
from radcalc.quantities.light import read as read_light
from radcalc.quantities.search import comparable
from radcalc.quantities.symbols import (
    FLAG,
    SPECIFIC,
    SYMBOLS,
    in_kind,
    light_unit,
    names_of_kinds,
    specific_name,
)
from radcalc.quantities.targets import is_name
from radcalc.sentences.phrases import BESIDE, DIRECTED, FILLERS, FILTER, MEANINGFUL, SHAPE
from radcalc.sentences.reader import Fact, Goal, Sentence, near_words
from radcalc.sentences.words import Amount
from radcalc.tuples import NamedTuple
from radcalc.units.dimensions import (
    ANGLE,
    AREA,
    LENGTH,
    POWER,
    SOLID_ANGLE,
    TEMPERATURE,
    TIME,
    times,
)
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve, suggest, unit_of
from radcalc.units.unit import NUMBER, Unit

VALUE = "value"  # the amount that is converted
LIGHT = ("flux", "intensity", "exitance", "irradiance", "radiance", "exposure", "energy")
MOST = 3  # readings to show
SHORTEST = 4  # letters of a word with a misspelling
Facts = dict[str, Fact]


class Frame(NamedTuple):
    """A command, and what calls for it: one of the facts `needs`, or a goal among `results`.

    `operand` is the word after the command, which a shape in the sentence replaces; `renamed` are
    facts with another name in the command.  Only a command with `light` is for amounts of light.
    """

    command: str
    needs: frozenset[str]
    operand: str = ""
    light: bool = True
    renamed: tuple[tuple[str, str], ...] = ()
    results: frozenset[str] = frozenset()


def _frame(
    command: str, needs: str, operand: str = "", light: bool = True, results: str = "", **names: str
) -> Frame:
    needed, called_for = frozenset(needs.split()), frozenset(results.split())
    return Frame(command, needed, operand, light, tuple(names.items()), called_for)


FRAMES = (  # the first that takes all facts of a sentence counts
    _frame("ev", "stops nd", time="unfiltered-time"),
    _frame("ev", "f-number iso ev ev100 guide-number stops nd"),
    _frame("room", "luminaires utilance maintenance", results="room-index"),
    _frame("screen", "diagonal aspect gain"),
    _frame("laser", "divergence spot-diameter hazard-distance receiver-diameter profile"),
    _frame("etendue", "na etendue"),
    _frame("sensor", "pixel-pitch quantum-efficiency responsivity"),
    _frame("refraction", "index"),
    _frame("point-source", "", light=False, results="beam-diameter diameter"),
    _frame("convert", " ".join((VALUE, *LIGHT, "wavelength", "fwhm"))),
    _frame("point-source", "flux intensity irradiance", area="receiver-area"),
    _frame("lambertian", f"radiance exitance {SHAPE}", "disc"),
    _frame("lambertian", "radiance exitance reflectance", irradiance="incident-irradiance"),
    _frame("solid-angle", "half-angle apex-angle", "cone", False),
    _frame("solid-angle", "radius diameter", "disc", False, distance="height"),
    _frame("solid-angle", "width length", "rectangle", False, distance="height"),
    _frame("photon", "wavelength", "", False),
    _frame("spectrum", "spectrum", "", False),
)
OPERANDS = {"photon": "wavelength", "spectrum": "spectrum"}  # facts that are words of a call
# Facts that an amount of that dimension may fill, if no phrase says which.
OF_DIMENSION = {
    LENGTH: ("distance",),
    AREA: ("area",),
    TIME: ("time",),
    ANGLE: ("apex-angle", "incidence", "half-angle"),
}
ELECTRICAL = ("flux", "input-power")  # of `60 W led`
# What is asked for without a target, by the value and its condition.
USUAL_GOALS = {
    **dict.fromkeys((("flux", "area"), ("flux", "diameter"), ("flux", "radius")), "irradiance"),
    ("irradiance", "area"): "flux",
    ("irradiance", "time"): "exposure",
    ("irradiance", "incidence"): "irradiance",
    ("flux", "time"): "energy",
}


# The full angles of beams, which for a solid angle is that of a cone.
ANGLES, ANGLE_OF_CONE = ("field-angle", "beam-angle"), "apex-angle"
# Correlated colour temperatures [K] of the white LEDs of the CIE, as `spectrum` gives them.
LEDS = {"LED-B1": 2735, "LED-B2": 2999, "LED-B3": 4102, "LED-B4": 5106, "LED-B5": 6591}
NEAR = 0.1  # of a temperature
# Words for light that is not that of a lamp.
DAYS = ("sun", "sunlight", "full sun", "solar", "daylight", "skylight", "moonlight")
WAVES = ("frequency", "wavenumber", "photon-energy")  # given in place of a wavelength
# Directions of light, and examples of them.
OF_BEAMS = {"isotropic", "hemisphere", "solid-angle", "exponent"}
OF_BEAMS |= {"half-angle", "apex-angle", "beam-angle"}
EXAMPLES_OF_BEAMS = (
    ("apex-angle", "30deg", "evenly in a cone of 30 deg, an example"),
    ("isotropic", "", "the same in all directions"),
)
# With the size of a beam, an intensity is an irradiance.
SIZES = ("area", "diameter", "radius")
# Results that an input is for: they come before the others of their unit.
OF_INPUT = {
    "receiver-area": "received-flux",
    "receiver-diameter": "received-flux",
    "within": "flux-within",
    "toward": "intensity-toward",
}


def call_of(sentence: Sentence) -> list[str]:
    """Return the call that a sentence means: a command, its operands and NAME=VALUE.

    Raises UsageError if it has several readings, or none, or words that were not understood.
    """
    if sentence.unknown:
        raise _not_understood(sentence)
    sentence = _with_values(sentence)
    for fact in sentence.facts:
        if fact.symbols == ELECTRICAL or _is_of_lamp(fact, sentence):
            raise _electrical(sentence, fact, _goal_of(sentence))
        if not fact.text and SYMBOLS[fact.symbols[0]].form != FLAG:
            raise _without_value(sentence, fact, _goal_of(sentence))
    calls = _calls_of(sentence)
    if len(calls) == 1:
        return list(calls[0])
    if not calls:
        parts = [fact.typed for fact in sentence.facts]
        wanted = f" and asks for {quote(sentence.goals[0].text)}" if sentence.goals else ""
        what = ", ".join(map(quote, parts)) or "these words"
        raise UsageError(f"no command takes {what}{wanted}", manual("convert"))
    tries = [Try(words=tuple(call)) for call in calls[:MOST]]
    raise UsageError(f"'{quote(sentence.text)}' has {len(calls)} readings", tries)


def _is_of_lamp(fact: Fact, sentence: Sentence) -> bool:
    """Return whether a fact is the watts of a lamp, as `400 W HPS`, which may be electrical."""
    is_watts = fact.amount is not None and fact.amount.dimension == POWER
    lamps = [one for one in sentence.facts if _is_lamp(one)]
    is_lit = any(one.text.lower() not in DAYS for one in lamps)
    has_efficacy = any("efficacy" in one.symbols or _is_efficacy(one) for one in sentence.facts)
    return is_watts and is_lit and not has_efficacy and fact.symbols in ((), ("flux",))


def _is_efficacy(fact: Fact) -> bool:
    amount = fact.amount
    return amount is not None and amount.dimension in SYMBOLS["efficacy"].dimensions


def _with_values(sentence: Sentence) -> Sentence:
    """Return a sentence without places that have their value elsewhere: `white`, and its 0.7."""
    valued = {name for fact in sentence.facts if fact.text for name in fact.symbols}
    facts = [fact for fact in sentence.facts if fact.text or valued.isdisjoint(fact.symbols)]
    return sentence._replace(facts=tuple(facts))


def _not_understood(sentence: Sentence) -> UsageError:
    """Return the error for words that were not understood; propose the call without them."""
    unknown = sentence.unknown
    for word in unknown:
        if word[0].isdigit():
            read_amount(word)  # its error says more
    understood = [fact.typed for fact in sentence.facts] + [goal.text for goal in sentence.goals]
    known = f"understood {', '.join(map(quote, understood))}; " if understood else ""
    corrected = next(filter(None, map(_corrected, unknown)), [])
    tries = [*corrected[:1], *_without(sentence)] or corrected
    hint = tries or f"without {quote(unknown[0])}, or with another word for it"
    return UsageError(f"{known}not understood: {listed(unknown)}", hint)


def _corrected(word: str) -> list[Try]:
    """Propose the known words that are like an unknown one, and units in another case."""
    if len(word) < SHORTEST or comparable(word) in MEANINGFUL:
        return []
    if units := _in_other_case(word):
        return units
    near = [n for n in (*suggest(word), *near_words(word)) if comparable(n) not in {*FILLERS, word}]
    others = [n for n in near if not word.startswith(n)]  # rough for roughly
    return corrections(word, *others[:2])


def _is_number(fact: Fact) -> bool:
    """Return whether a fact is a number alone, or one with a name, as `nd 0.6`."""
    amount = fact.amount
    is_named = bool(fact.symbols) and amount is not None and amount.dimension == NUMBER
    return is_named or _is_bare(fact)


def _is_bare(fact: Fact) -> bool:
    return not fact.symbols and fact.amount is not None and fact.amount.unit.text == "1"


def _in_other_case(word: str) -> list[Try]:
    """Propose a unit of several parts with the right case: W/m2 for w/m2."""
    try:
        resolve(word)
    except UnitError as error:
        pairs = [one.instead for one in error.tries if len(one.instead) == 2]
        units = [word.replace(typed, other) for typed, other in pairs]
        return [correct(word, unit) for unit in units if "/" in unit and unit_of(unit)]
    return []


def _without(sentence: Sentence) -> list[Try]:
    """Propose the calls of a sentence without its unknown words, unless one changes an amount."""
    unknown = sentence.unknown
    has_bare_number = any(_is_bare(fact) for fact in sentence.facts)  # its unit may be unknown
    if has_bare_number or len(sentence.facts) + len(sentence.goals) < 2:
        return []
    is_number = any(
        not word[0].isalpha() or "=" in word for text in unknown for word in text.split()
    )
    words = {comparable(word) for text in unknown for word in text.split()}
    if is_number or not MEANINGFUL.isdisjoint(words):
        return []
    try:
        tries = [Try(words=tuple(call_of(sentence._replace(unknown=()))))]
    except UsageError as error:
        tries = [one for one in error.tries if one.is_call]
    remark = "without " + " and ".join([f"'{word}'" for word in unknown])
    return [Try(words=one.words, remark=one.remark or remark) for one in tries]


def _calls_of(sentence: Sentence) -> list[tuple[str, ...]]:
    """Return the calls of all readings of a sentence with at most one goal."""
    if sentence.files:
        return _of_file(sentence)
    goal = _goal_of(sentence)
    has_beam = any(map(_is_lamp, sentence.facts)) or not DIRECTED.isdisjoint(sentence.ignored)
    sentence = _without_lamp(_with_led(sentence), goal)
    readings = _readings(sentence)
    found = [call for facts in readings for call in _calls(facts, goal)]
    found = found or _quotients(sentence.facts, goal)
    if not found and not has_beam:
        found = _moved(sentence.facts, goal)
    _refuse_wide(sentence, goal, found)
    if not found and not readings:
        texts = ", ".join([quote(fact.typed) for fact in sentence.facts])
        raise UsageError(f"two of these fill one place: {texts}", "a call for each of them")
    return list(dict.fromkeys(map(tuple, found)))


def _without_lamp(sentence: Sentence, goal: Goal | None) -> Sentence:
    """Return a sentence without a spectrum such as `led` or `sun`, if its light needs none.

    It is of one kind, or its efficacy is given.
    """
    units = [fact.amount.unit for fact in sentence.facts if fact.amount]
    units += [goal.unit] if goal and goal.unit else []
    if any(map(_is_bare, sentence.facts)):  # 1 sun has an unknown unit
        return sentence
    has_efficacy = any(unit.dimension in SYMBOLS["efficacy"].dimensions for unit in units)
    if not has_efficacy and len({light.kind for unit in units if (light := read_light(unit))}) > 1:
        return sentence
    facts = [fact for fact in sentence.facts if not _is_lamp(fact)]
    return sentence._replace(facts=tuple(facts))


def _refuse_wide(sentence: Sentence, goal: Goal | None, calls: Sequence[Sequence[str]]) -> None:
    """Refuse the flux of a source with a beam as if it lit all directions alike."""
    directed = [word for word in sentence.ignored if word.lower() in DIRECTED]
    names = {word.partition("=")[0] for call in calls[:1] for word in call}
    asked = {*goal.names} if goal else set()
    is_flux = any("flux" in name or "energy" in name for name in {*names, *asked})
    has_unit = goal and goal.unit and goal.unit.dimension in SYMBOLS["flux"].dimensions
    is_point = bool(calls) and calls[0][0] == "point-source" and names.isdisjoint(OF_BEAMS)
    if directed and is_point and (is_flux or has_unit):
        tries = [
            Try(words=(*calls[0], f"{name}={value}"), remark=remark)
            for name, value, remark in EXAMPLES_OF_BEAMS
        ]
        problem = f"'{quote(directed[0])}' has a beam, and its angle is missing"
        raise UsageError(problem, tries)


def _with_led(sentence: Sentence) -> Sentence:
    """Return a sentence with the CIE's LED of a colour temperature, as `led` and 3000 K."""
    facts = sentence.facts
    leds = [fact for fact in facts if _is_lamp(fact) and fact.text.lower().endswith("led")]
    colours = [fact for fact in facts if fact.amount and fact.amount.dimension == TEMPERATURE]
    if len(leds) != 1 or len(colours) != 1 or colours[0].symbols:
        return sentence
    assert colours[0].amount is not None
    temperature = _size(colours[0].amount)
    name = min(LEDS, key=lambda led: abs(LEDS[led] - temperature))
    if abs(LEDS[name] - temperature) > NEAR * temperature:
        return sentence
    led = leds[0]._replace(text=name)
    others = [led if fact is leds[0] else fact for fact in facts if fact is not colours[0]]
    return sentence._replace(facts=tuple(others))


def _is_lamp(fact: Fact) -> bool:
    """Return whether a fact is a spectrum by a word of everyday language: led, sun, daylight."""
    return fact.symbols == ("spectrum",) and fact.text.replace(" ", "").isalpha()


def _of_file(sentence: Sentence) -> list[tuple[str, ...]]:
    """Return the calls of the command that reads a file, with the other facts as its options.

    The file of a spectrum beside an amount of light is the spectrum of that light.
    """
    from radcalc.routes.kinds import LUMINAIRE, MAP, SPECTRUM, call_of_file, is_relative, kind_of

    path, *others = sentence.files
    if others:
        listed = " and ".join(map(quote_path, sentence.files))
        raise UsageError(f"the sentence has several files: {listed}", "a call for each of them")
    kind = kind_of(path)
    if kind == SPECTRUM and any(map(_is_light, sentence.facts)):
        with_file = (*sentence.facts, Fact(("spectrum",), path, path))
        return _calls_of(sentence._replace(files=(), facts=with_file))
    facts = tuple(map(_toward, sentence.facts)) if kind == LUMINAIRE else sentence.facts
    command, *operands = call_of_file(kind, path)
    words = [command, *operands]
    if kind == MAP and is_relative(path):
        words.append("unit=1")
    found = []
    goals = sentence.goals if len(sentence.goals) > 1 else [_goal_of(sentence)]
    for given in _readings(sentence._replace(facts=facts)):
        of_goals = [_on_page(words, page_of(command), given, goal) for goal in goals]
        if len(goals) == 1:
            found += of_goals[0]
        elif all(of_goals):  # several results of one file
            found.append([*of_goals[0][0], *[calls[0][-1] for calls in of_goals[1:]]])
    return list(dict.fromkeys(map(tuple, found)))


def _toward(fact: Fact) -> Fact:
    """Return an angle beside a luminaire: of incidence, or of a direction of its light."""
    if fact.symbols == ("incidence",) and "incidence" not in fact.typed:
        return fact._replace(symbols=("toward", "incidence"))
    return fact


def _electrical(sentence: Sentence, fact: Fact, goal: Goal | None) -> UsageError:
    """Return the error for the watts of a lamp, which may be electrical or those of its light."""
    radiant = fact._replace(symbols=("flux",))
    electrical = radiant._replace(text=f"{fact.text}*100lm/W")
    tries = [
        *_with(sentence, fact, radiant, goal, "watts of light"),
        *_with(sentence, fact, electrical, goal, "electrical watts of a lamp of 100 lm/W"),
    ]
    problem = f"'{quote(fact.typed)}': the watts of a lamp are electrical or of its light"
    return UsageError(problem, tries or "its flux in lm, or its radiant flux")


def _without_value(sentence: Sentence, fact: Fact, goal: Goal | None) -> UsageError:
    """Return the error for a place without its value, as the reflectance of white paper."""
    symbol = SYMBOLS[fact.symbols[0]]
    tries = _with(sentence, fact, fact._replace(text=symbol.example), goal, "an example")
    return UsageError(f"'{quote(fact.typed)}': the {symbol.label} is missing", tries or "a number")


def _with(sentence: Sentence, fact: Fact, other: Fact, goal: Goal | None, remark: str) -> list[Try]:
    """Return the first call of a sentence with another fact in place of one."""
    facts = tuple([other if one is fact else one for one in sentence.facts])
    readings = _readings(sentence._replace(facts=facts))
    calls = [call for reading in readings[:1] for call in _calls(reading, goal)[:1]]
    return [Try(words=tuple(call), remark=remark) for call in calls]


def _calls(facts: Facts, goal: Goal | None) -> list[list[str]]:
    """Return the calls of the first frame that takes all facts."""
    if len(facts) == 1 and goal and goal.unit and (same := _same(next(iter(facts.values())), goal)):
        return [same]
    if goal and ("room-index" in goal.names or _is_solid_angle(goal)):
        facts = _with_sides(facts)
    if {*facts} == {FILTER} and goal and "transmittance" in goal.names:
        return [["convert", *facts[FILTER].text.split(), "%"]]
    if FILTER in facts:
        facts = _filtered(facts)
    results = {*goal.names} if goal else set()
    for frame in FRAMES:
        of_frame = _conversions if frame.command == "convert" else _calculations
        is_called_for = frame.needs & {*_generic_names(facts)} or frame.results & results
        if is_called_for and (calls := of_frame(frame, facts, goal)):
            return calls
    return []


def _is_solid_angle(goal: Goal) -> bool:
    return goal.unit.dimension == SOLID_ANGLE if goal.unit else "solid-angle" in goal.names


def _same(fact: Fact, goal: Goal) -> list[str]:
    """Return the conversion of the only amount, if it has the quantity of the goal."""
    amount, unit = fact.amount, goal.unit
    if amount is None or unit is None or amount.dimension != unit.dimension or unit.is_scale:
        return []
    number, blank, typed = fact.text.partition(" ")
    plain = [number, typed] if blank and typed == amount.unit.text else [fact.text]
    return ["convert", *plain, goal.text]


def _with_sides(facts: Facts) -> Facts:
    """Return facts with the two sides of an area in place of the area."""
    area = facts.get("area")
    first, times_sign, second = area.text.partition("*") if area else ("", "", "")
    if not times_sign or not all(unit_of(side.strip("0123456789. ")) for side in (first, second)):
        return facts
    others = {name: fact for name, fact in facts.items() if name != "area"}
    sides = [Fact((name,), text, text) for name, text in (("length", first), ("width", second))]
    return {**others, "length": sides[0], "width": sides[1]}


def _filtered(facts: Facts) -> Facts:
    """Return facts with the light after a filter in place of the filter."""
    values = [name for name in facts if name in LIGHT]
    loss = facts[FILTER].text
    rest = {name: fact for name, fact in facts.items() if name != FILTER}
    if len(values) != 1:
        return {**rest, FILTER: facts[FILTER]}
    value = facts[values[0]]
    return {**rest, values[0]: value._replace(text=f"{value.text} * ({loss})")}


def _generic_names(facts: Facts) -> Iterator[str]:
    for name in facts:
        yield name
        if name in SPECIFIC:
            yield SPECIFIC[name][0]


def _goal_of(sentence: Sentence) -> Goal | None:
    """Return the only goal; the name and the unit of one result count as one."""
    goals = list(dict.fromkeys(sentence.goals))
    units = [goal for goal in goals if goal.unit]
    named = [goal for goal in goals if not goal.unit]
    if len(units) > 1 or len(named) > 1:
        texts = " and ".join([quote(goal.text) for goal in goals])
        listed = Goal(",".join([goal.text for goal in units]), units[0].unit) if units else goals[0]
        alone = [sentence._replace(goals=(goal,)) for goal in (listed, *goals[:MOST])]
        calls = [call for one in alone for call in _calls_of(one)[:1]]
        tries = [Try(words=tuple(call)) for call in calls]
        problem = f"the sentence asks for several results: {texts}"
        raise UsageError(problem, tries or "one of them")
    if units and named:
        _check_named(sentence, named[0], units[0])
        return units[0]._replace(names=named[0].names)
    return goals[0] if goals else None


def _check_named(sentence: Sentence, named: Goal, goal: Goal) -> None:
    """Refuse the name of one quantity with the unit of another; propose each of them alone."""
    assert goal.unit is not None
    dimensions = {one for name in named.names for one in SYMBOLS[name].dimensions}
    if goal.unit.dimension not in dimensions:
        problem = f"{quote(goal.text)} is not a unit of {quote(named.text)}"
        alone = [sentence._replace(goals=(one,)) for one in (goal, named)]
        tries = [Try(words=tuple(call)) for one in alone for call in _answerable(one)[:MOST]]
        hint = f"one of them: {quote(named.text)} or {quote(goal.text)}"
        raise UsageError(problem, tries or hint)


def _answerable(sentence: Sentence) -> list[tuple[str, ...]]:
    """Return the calls of all readings of a sentence, none if it is refused."""
    try:
        return _calls_of(sentence)
    except UsageError:
        return []


def _readings(sentence: Sentence) -> list[Facts]:
    """Return the facts by their symbols, for every choice among the symbols of each phrase."""
    readings: list[Facts] = [{}]
    for fact in sentence.facts:
        names = _choices(fact, sentence)
        readings = [
            {**given, name: fact} for given in readings for name in names if name not in given
        ]
    return readings


def _choices(fact: Fact, sentence: Sentence) -> tuple[str, ...]:
    """Return the symbols that a fact may fill in a sentence."""
    if fact.symbols == ("incidence",) and "incidence" not in fact.typed and _has_beam(sentence):
        return ("incidence", "toward")  # of the receiver, or off the axis of the beam
    if len(fact.symbols) < 2:
        return fact.symbols or _places(fact.amount, sentence)
    others = {name: other.text for other in sentence.facts for name in other.symbols}
    left_out = [
        name
        for name, (beside, value) in BESIDE.items()
        if name in fact.symbols and others.get(beside, value) == value
    ]
    return tuple([name for name in fact.symbols if name not in left_out])


def _has_beam(sentence: Sentence) -> bool:
    beams = {"beam-angle", "exponent", "half-angle", "apex-angle"}
    return any(beams & {*fact.symbols} for fact in sentence.facts)


def _places(amount: Amount | None, sentence: Sentence) -> tuple[str, ...]:
    """Return the symbols that an amount alone may fill."""
    assert amount is not None
    if _light_of(amount):
        return _meant(amount)
    wanted = {name for goal in sentence.goals for name in goal.names}
    if amount.dimension == ANGLE and wanted & {"hazard-distance", "spot-diameter"}:
        return ("divergence",)
    if amount.dimension == ANGLE and wanted & {"beam-diameter", "diameter"}:
        return OF_DIMENSION[ANGLE]
    alone = [fact.amount for fact in sentence.facts if not fact.symbols]
    others = {name for fact in sentence.facts for name in fact.symbols}
    is_first = alone[0] is amount and others <= taken_by(page_of("convert"))
    if is_first and not any(_is_light(fact) for fact in sentence.facts):
        return (VALUE,)
    is_shutter = amount.dimension == NUMBER and amount.text[:2] == "1/"
    if is_shutter and any({"iso", "f-number"} & {*fact.symbols} for fact in sentence.facts):
        return ("time",)
    if "aspect" in others and amount.dimension == LENGTH and not amount.is_wavelength:
        return ("diagonal",)  # of a screen
    return _meant(amount)


def _light_of(amount: Amount) -> Reading | None:
    """Return the light that an amount measures; None for a density, a scale or no light."""
    light = read_light(amount.unit)
    return light if light and not light.axis and not amount.unit.is_scale else None


def _meant(amount: Amount) -> tuple[str, ...]:
    """Return the symbols that a unit means."""
    if _light_of(amount):
        return (_generic(amount) or VALUE,)
    if amount.is_wavelength:
        return ("wavelength",)
    for name in ("efficacy", "responsivity"):
        if amount.dimension in SYMBOLS[name].dimensions:
            return (name,)
    return OF_DIMENSION.get(amount.dimension, (VALUE,))


def inputs_of(command: str, unit: Unit, given: Iterable[str] = ()) -> list[str]:
    """Return the inputs of a command that an amount without a name may be, by its unit.

    They are several if the command has other inputs of the same light, or lengths in um, or if its
    frames rename the input beside those that are given.
    """
    page, amount = page_of(command), Amount("", unit, 0)
    taken = taken_by(page)
    names, light = [*_meant(amount)], _light_of(amount)
    if light and names != [VALUE]:
        alike = [n for n in listed_by(page) if SYMBOLS[n].geometry == SYMBOLS[names[0]].geometry]
        names += [name for name in alike if not name.startswith("peak-")]
    elif amount.is_wavelength:
        alike = [n for n in listed_by(page) if SYMBOLS[n].unit in ("nm", "um")]
        names = [name for name in alike if amount.dimension in SYMBOLS[name].dimensions]
    found = [in_kind(name, light.kind) if light else name for name in names]
    for frame in FRAMES:
        if frame.command == command:
            names = [n for n in found if n not in taken or frame.needs & {*given}]
            found += [new for name, new in frame.renamed if name in names]
    return [name for name in dict.fromkeys(found) if name in taken]


def _is_light(fact: Fact) -> bool:
    """Return whether a fact is an amount of light, with or without its name."""
    is_named = any(SYMBOLS[name].geometry for name in fact.symbols if name in SYMBOLS)
    is_alone = not fact.symbols and fact.amount and read_light(fact.amount.unit)
    return bool(is_named or is_alone)


def _generic(amount: Amount) -> str:
    """Return the generic name of a light quantity: flux, intensity, irradiance, radiance ..."""
    if amount.unit.is_exitance:
        return "exitance"
    names = [name for name in LIGHT[::-1] if amount.dimension in SYMBOLS[name].dimensions]
    return next((name for name in names if name != "exitance"), "")


def _calculations(frame: Frame, facts: Facts, goal: Goal | None) -> list[list[str]]:
    """Return the calls of a calculator: one for each result that the goal may mean."""
    if not frame.light and any(_is_light(fact) for fact in facts.values()):
        return []
    page = page_of(frame.command)
    taken = taken_by(page)
    given = {_taken(dict(frame.renamed).get(n, n), fact, taken): fact for n, fact in facts.items()}
    words = [frame.command]
    if operand := OPERANDS.get(frame.command):
        words.append(one_word(given.pop(operand)))
    elif SHAPE in given and frame.operand:
        words.append(given.pop(SHAPE).text)
    elif frame.operand:
        words.append(frame.operand)
    return _on_page(words, page, given, goal)


def _on_page(words: list[str], page: Page, given: Facts, goal: Goal | None) -> list[list[str]]:
    """Return calls with facts as options of a page, one for each result that the goal may mean."""
    if not {*given} <= taken_by(page):
        return []
    words = [*words]
    for name, fact in given.items():
        words.append(_input(name, fact))
    if goal is None:
        return [words]
    return [[*words, f"get={name}"] for name in _results(page, goal, given)]


def _taken(name: str, fact: Fact, taken: set[str]) -> str:
    """Return the name of a fact, or its name in one kind of light if a page takes only that."""
    light = read_light(fact.amount.unit) if fact.amount else None
    return name if name in taken or not light else in_kind(name, light.kind)


def _conversions(frame: Frame, facts: Facts, goal: Goal | None) -> list[list[str]]:
    """Return the conversion of the only amount that is not a condition."""
    conditions = taken_by(page_of("convert"))
    facts = {"wavelength" if n in WAVES else n: fact for n, fact in facts.items()}
    values = [name for name in facts if name not in conditions] or [*facts]
    if len(values) != 1 or values[0] not in (VALUE, *LIGHT, *SPECIFIC, "wavelength", "fwhm"):
        return []
    ((value,), given) = values, {name: f for name, f in facts.items() if name != values[0]}
    usual = USUAL_GOALS.get((SPECIFIC.get(value, (value,))[0], next(iter(given), "")))
    target = _target(goal, facts[value], given) if goal else usual if len(given) == 1 else ""
    amount = facts[value].amount
    if amount is None or (given and not target):
        return []
    if amount.dimension == NUMBER and given:  # a number whose unit is missing
        return []
    if "distance" in given and _is_of_small_source(facts, goal):
        return []
    number, _, unit = facts[value].text.partition(" ")
    is_plain = amount.unit.text == unit
    words = ["convert", *([number, unit] if is_plain else [facts[value].text])]
    words += [target] if target else []
    calls = [words + [_input(name, fact) for name, fact in given.items()]]
    if "incidence" in given and len(given) > 1 and _generic(amount) == "irradiance":
        calls.append([word for word in calls[0] if not word.startswith("incidence=")])
    return calls  # an irradiance is that across the light, or that on the surface


def _is_of_small_source(facts: Facts, goal: Goal | None) -> bool:
    """Return whether `point-source` takes all facts, and has the result."""
    page = page_of("point-source")
    return {*facts} <= taken_by(page) and bool(_results(page, goal, facts))


def _target(goal: Goal, value: Fact, given: Facts) -> str:
    """Return the target of a conversion; a name for several kinds of light is that of the value."""
    light = read_light(value.amount.unit) if value.amount else None
    if light and "irradiance" in goal.names[1:] and not goal.unit and {*given} & {*SIZES}:
        return specific_name("irradiance", light.kind).replace("-", " ")
    if value.amount and value.amount.dimension == TEMPERATURE and "peak-wavelength" in goal.names:
        return "wavelength"  # of a black body
    for name in goal.names if light and not goal.unit else ():
        symbol = SYMBOLS[name]
        if light and symbol.geometry and symbol.kind in ("", light.kind):
            return specific_name(symbol.generic, light.kind).replace("-", " ")
    if not goal.unit and goal.names and not is_name(goal.text):  # lambda
        return SYMBOLS[goal.names[0]].label
    return goal.text


def _quotients(facts: Sequence[Fact], goal: Goal | None) -> list[list[str]]:
    """Return the conversion of the quotient or product of two amounts that has the goal's unit."""
    amounts = [fact.amount for fact in facts if fact.amount]
    if any(a.dimension == SOLID_ANGLE and "*" in a.text for a in amounts):  # 24 deg x 12 deg
        return []
    if goal is None or len(amounts) != len(facts) or any(map(_is_number, facts)):
        return []
    dimensions = (goal.unit.dimension,) if goal.unit else SYMBOLS[goal.names[0]].dimensions
    target = _unit_of(goal, amounts)
    if len(amounts) == 3:  # 24 W/m of 100 lm/W, 5 m
        of_amounts = {amount.dimension for amount in amounts}
        if len(of_amounts) < 3 or of_amounts & {ANGLE, SOLID_ANGLE, NUMBER}:
            return []
        product = reduce(times, of_amounts)
        text = " * ".join([f"({amount.text})" for amount in amounts])
        return [["convert", text, target]] if product in dimensions else []
    if len(amounts) != 2:
        return []
    if all(amount.dimension == NUMBER for amount in amounts):
        return []
    if any(amount.dimension in (LENGTH, ANGLE) for amount in amounts):  # they have places
        return []
    if goal.text.upper() == "OD":  # a density is positive
        smaller, larger = sorted(amounts, key=_size)
        return [["convert", f"({smaller.text}) / ({larger.text})", goal.text]]
    is_mired = goal.unit and goal.unit.is_scale and goal.unit.dimension == TEMPERATURE
    if is_mired and all(amount.dimension == TEMPERATURE for amount in amounts):
        before, after = [amount.text for amount in amounts]  # the shift of a filter
        return [["convert", f"1/({after}) - 1/({before})", "1/MK"]]
    first, second = amounts
    ways = {
        f"{first.text} / ({second.text})": times(first.dimension, second.dimension, -1),
        f"{second.text} / ({first.text})": times(second.dimension, first.dimension, -1),
        f"{first.text} * ({second.text})": times(first.dimension, second.dimension),
    }
    return [["convert", way, target] for way, dimension in ways.items() if dimension in dimensions]


def _size(amount: Amount) -> float:
    return read_amount(amount.text).number * amount.unit.factor


def _unit_of(goal: Goal, amounts: Sequence[Amount]) -> str:
    """Return the unit of a goal; a name for several kinds of light is that of the amounts."""
    if goal.unit or not goal.names:
        return goal.text
    symbol = SYMBOLS[goal.names[0]]
    kinds = [light.kind for amount in amounts if (light := read_light(amount.unit))]
    return light_unit(symbol.generic, kinds[0]) if symbol.generic and kinds else symbol.unit


def _moved(facts: Sequence[Fact], goal: Goal | None) -> list[list[str]]:
    """Return the conversion of light on a surface from one distance to another, or a distance.

    Both distances have `at`, and the light comes from a small lamp: it is not the sun's, nor a
    laser's.  The distance that is known stands after its light.
    """
    lights = [fact for fact in facts if fact.amount and _generic(fact.amount) == "irradiance"]
    places = [fact for fact in facts if fact.symbols == ("distance",)]
    if len(facts) != 3 or len(lights) + len(places) != 3 or facts[0] not in lights:
        return []
    if len({fact.typed.split()[0] for fact in places}) > 1:  # from one to another
        return []
    if len(places) == 2 and (goal is None or _is_irradiance(goal)):
        (light,), (here, there) = lights, places
        text = light.text.replace("ppfd", "umol/m2/s")  # which is a unit in expressions
        moved = f"({text}) * ({here.text})^2 / ({there.text})^2"
        return [["convert", moved, goal.text if goal else _unit_text(light)]]
    if len(lights) == 2 and places and goal and "distance" in goal.names:
        known = facts[facts.index(places[0]) - 1]
        wanted = next(light for light in lights if light is not known)
        moved = f"{places[0].text} * sqrt(({known.text}) / ({wanted.text}))"
        return [["convert", moved, _unit_text(places[0])]]
    return []


def _unit_text(fact: Fact) -> str:
    assert fact.amount is not None
    return fact.amount.unit.text


def _is_irradiance(goal: Goal) -> bool:
    """Return whether a goal is a unit, or the name, of light on a surface."""
    if goal.unit:
        return goal.unit.dimension in SYMBOLS["irradiance"].dimensions
    return any(SPECIFIC.get(name, (name,))[0] == "irradiance" for name in goal.names)


def _input(name: str, fact: Fact) -> str:
    """Return an input of a call; a flag has no value."""
    if SYMBOLS[name].form == FLAG:
        return f"{name}="
    light = read_light(fact.amount.unit) if fact.amount else None
    return f"{in_kind(name, light.kind) if light else name}={one_word(fact)}"


def one_word(fact: Fact) -> str:
    """Return the text of a fact as one word, if it reads the same: 2 m becomes 2m."""
    number, blank, unit = fact.text.partition(" ")
    is_shutter = fact.symbols == () and fact.amount and fact.amount.dimension == NUMBER
    if is_shutter and fact.text[:2] == "1/":
        return f"{fact.text}s"
    is_amount = number[:1].isdigit() and unit[:1].isalpha() and " " not in unit
    return number + unit if blank and is_amount else fact.text


def listed_by(page: Page) -> list[str]:
    """Return the symbols of a page's options, in their order."""
    return [name for names in page.sections.values() for name in names]


def taken_by(page: Page) -> set[str]:
    """Return the symbols that a page takes, with the names of one kind of light."""
    names = {*listed_by(page)}
    return names | {other for name in names for other in names_of_kinds(name)}


def _results(page: Page, goal: Goal | None, given: Facts) -> list[str]:
    """Return the results of a page that a goal may mean, as `-g` takes them."""
    if goal is None:
        return []
    if not page.light and not page.others:  # the results depend on the inputs
        angles = [ANGLE_OF_CONE] if {*goal.names} & {*ANGLES} else []
        return [n for n in goal.names if n in listed_by(page)] or angles or list(goal.names[:1])
    options = (*page.light, *page.others, *listed_by(page))
    listed = [name for name in dict.fromkeys(options) if name not in given]
    if not any(map(_is_light, given.values())):  # ISO 100 is assumed, not found
        listed = [name for name in listed if "(default" not in page.symbol(name).help]
    if "irradiance" in goal.names[1:] and "distance" in given:
        goal = goal._replace(names=("irradiance",))  # an intensity would not need the distance
    elif goal.text in listed:  # stops, ev100
        return [goal.text]
    if "diameter" in goal.names and "beam-diameter" in listed and "diameter" not in listed:
        return ["beam-diameter"]
    if goal.names:
        wanted = {*goal.names, *(SPECIFIC[name][0] for name in goal.names if name in SPECIFIC)}
        dimensions = {one for name in wanted for one in SYMBOLS[name].dimensions}
        own_results = {OF_INPUT[name] for name in given if name in OF_INPUT}
        wanted |= {name for name in own_results if dimensions & {*SYMBOLS[name].dimensions}}
        found = [name for name in listed if name in wanted]
    else:
        assert goal.unit is not None
        own = result_name(goal.unit)
        wanted = {own, SPECIFIC.get(own, (own,))[0]}
        fitting = [n for n in listed if goal.unit.dimension in SYMBOLS[n].dimensions]
        own_results = {OF_INPUT[name] for name in given if name in OF_INPUT}
        wanted = own_results & {*fitting} or wanted
        found = [name for name in fitting if name in wanted] or fitting
    if not goal.unit:
        return found
    names = [
        own if SPECIFIC.get(own := result_name(goal.unit), ("",))[0] == n else n for n in found
    ]
    return [f"{name}:{goal.text}" for name in names]
