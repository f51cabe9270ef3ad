"""Commands that take the facts of a sentence, and the calls of them."""

from collections.abc import Iterable, Iterator, Sequence

from radcalc.calculators import page_of
from radcalc.calculators.page import Page
from radcalc.errors import MOST, Try, input_of, mention
from radcalc.quantities import read as read_light
from radcalc.quantities import result_name, symbols
from radcalc.quantities.names import kind_of
from radcalc.quantities.search import is_name
from radcalc.quantities.symbols import SYMBOLS, generic_name, in_kind
from radcalc.sentences import Amount
from radcalc.sentences.doubts import (
    LIGHT_SYMBOLS,
    OF_DIMENSION,
    VALUE,
    Facts,
    generic,
    is_light,
    light_of,
    quantities_meant,
)
from radcalc.sentences.phrases import BESIDE, COMMAND, FILTER, SHAPE
from radcalc.sentences.reader import Fact, Goal, Sentence
from radcalc.tuples import NamedTuple
from radcalc.units import NUMBER, Unit
from radcalc.units.compiled import WEIGHTS
from radcalc.units.dimensions import (
    ANGLE,
    LENGTH,
    SOLID_ANGLE,
    TEMPERATURE,
)
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve, unit_of


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


SENSOR = _frame("sensor", "f-number pixel-pitch quantum-efficiency responsivity")
FRAMES = (  # the first that takes all facts of a sentence counts
    _frame("ev", "stops nd", time="unfiltered-time"),
    _frame("ev", "f-number iso ev ev100 guide-number stops nd"),
    _frame("room", "luminaires utilance maintenance", results="room-index luminaires"),
    _frame("screen", "diagonal aspect gain"),
    _frame(
        "laser",
        "divergence spot-diameter hazard-distance receiver-diameter profile",
        results="peak-irradiance",
    ),
    _frame("etendue", "na etendue"),
    SENSOR,
    _frame("refraction", "index"),
    _frame("point-source", "", light=False, results="beam-diameter diameter"),
    _frame("convert", " ".join((VALUE, *LIGHT_SYMBOLS, "wavelength", "fwhm"))),
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
# The result of a sentence without a target, by the value and its condition.
USUAL_GOALS: dict[tuple[str, ...], str] = {
    **dict.fromkeys((("flux", "area"), ("flux", "diameter"), ("flux", "radius")), "irradiance"),
    ("irradiance", "area"): "flux",
    ("irradiance", "time"): "exposure",
    ("irradiance", "incidence"): "irradiance",
    ("flux", "time"): "energy",
}
# The full angles of beams, which for a solid angle is that of a cone.
ANGLES, ANGLE_OF_CONE = ("field-angle", "beam-angle"), "apex-angle"
WAVES = ("frequency", "wavenumber", "photon-energy")  # given instead of a wavelength
TIMES_OF_FILTERS = {"time", "unfiltered-time", "stops", "nd"}
# With the size of a beam, an intensity is an irradiance.
SIZES = ("area", "diameter", "radius")
EV = "EV"
RECTANGLE = "rectangle"
PERCENT = ("%", "percent")
# Results that an input is for: they come before the others of their unit.
OF_INPUT = {
    "receiver-area": "received-flux",
    "receiver-diameter": "received-flux",
    "within": "flux-within",
    "toward": "intensity-toward",
}


def calls_of(facts: Facts, goal: Goal | None) -> list[list[str]]:
    """Return the calls of the first frame that takes all facts."""
    if len(facts) == 1 and goal and (alone := _alone(*next(iter(facts.items())), goal)):
        return [alone]
    if _is_of_unknown_side(facts, goal):
        return []
    named = facts.get(COMMAND)
    facts = {name: fact for name, fact in facts.items() if name != COMMAND}
    facts = _of_rectangle(facts, goal)
    facts = _filtered(facts) if FILTER in facts else facts
    called_for, results = {*_generic_names(facts)}, {*goal.names} if goal else set()
    for frame in FRAMES:
        of_frame = _conversions if frame.command == "convert" else _calculations
        is_called_for = bool(frame.needs & called_for or frame.results & results)
        if named:
            is_called_for = frame.command == named.text
        if is_called_for and (calls := of_frame(frame, facts, goal)):
            return calls if named else [*calls, *_on_sensor(frame, facts, goal)]
    return []


def _is_of_unknown_side(facts: Facts, goal: Goal | None) -> bool:
    """Return whether the time or the light may be that before a filter, or that after it."""
    if not {"stops", "nd"}.isdisjoint(facts) and goal:
        return TIMES_OF_FILTERS.isdisjoint((*goal.names, goal.text))
    return FILTER in facts and not {*facts} <= {
        FILTER,
        VALUE,
        *LIGHT_SYMBOLS,
        "wavelength",
        "spectrum",
    }


def _alone(name: str, fact: Fact, goal: Goal) -> list[str]:
    """Return the conversion of the only fact: of its amount, or of a filter to the light it passes.

    Return none for another goal.
    """
    if name == FILTER and "transmittance" in goal.names:
        return ["convert", *fact.text.split(), "%"]
    if name == "nd" and _is_part(goal) and "." in fact.text:
        return ["convert", fact.text, "OD", "%"]
    return _same(fact, goal)


def _of_rectangle(facts: Facts, goal: Goal | None) -> Facts:
    """Return facts with the two sides of an area in its place, if they are of a rectangle."""
    is_of_sides = goal is not None and ("room-index" in goal.names or is_solid_angle(goal))
    if is_of_sides or (SHAPE in facts and facts[SHAPE].text == RECTANGLE):
        return _with_sides(facts)
    if SHAPE in facts or not _is_panel({*_generic_names(facts)}, goal):
        return facts
    sides = _with_sides(facts)
    return facts if sides is facts else {**sides, SHAPE: Fact((SHAPE,), RECTANGLE, "")}


def _is_panel(given: set[str], goal: Goal | None) -> bool:
    """Return whether a surface shines, or is to shine, on a place near it."""
    if "area" not in given or given.isdisjoint(("distance", "height")):
        return False
    if given.isdisjoint(("radiance", "exitance")):
        is_of_surface = (
            goal and goal.unit and goal.unit.dimension in symbols.SYMBOLS["radiance"].dimensions
        )
        return "irradiance" in given and bool(is_of_surface)
    return goal is None or is_irradiance(goal)


def _is_part(goal: Goal) -> bool:
    """Return whether a goal is a part of the light, as a transmittance or in percent."""
    return "transmittance" in goal.names or (goal.unit is not None and goal.unit.text in PERCENT)


def _on_sensor(frame: Frame, facts: Facts, goal: Goal | None) -> list[list[str]]:
    """Return the call for the light on a sensor, where a light meter gives that on the scene."""
    is_of_lens = frame.command == "ev" and any(map(is_light, facts.values()))
    if goal is None or not is_of_lens or not (is_irradiance(goal) or is_exposure(goal)):
        return []
    return _calculations(SENSOR, facts, goal)


def is_exposure(goal: Goal) -> bool:
    """Return whether a goal is a unit, or the name, of light on a surface over a time."""
    if goal.unit:
        return goal.unit.dimension in symbols.SYMBOLS["exposure"].dimensions
    return any(symbols.generic_name(name) == "exposure" for name in goal.names)


def is_irradiance(goal: Goal) -> bool:
    """Return whether a goal is a unit, or the name, of light on a surface."""
    if goal.unit:
        return goal.unit.dimension in symbols.SYMBOLS["irradiance"].dimensions
    return any(symbols.generic_name(name) == "irradiance" for name in goal.names)


def is_solid_angle(goal: Goal) -> bool:
    """Return whether a goal is a unit, or the name, of a solid angle."""
    return goal.unit.dimension == SOLID_ANGLE if goal.unit else "solid-angle" in goal.names


def _same(fact: Fact, goal: Goal) -> list[str]:
    """Return the conversion of the only amount, if it has the quantity of the goal."""
    amount, unit = fact.amount, goal.unit
    if amount is None or unit is None or amount.dimension != unit.dimension or unit.is_scale:
        return []
    if unit.dimension == NUMBER and fact.symbols:  # ND 1.2 in %
        return []
    return ["convert", *_operands(fact), goal.text]


def _operands(fact: Fact) -> list[str]:
    """Return a number and its unit as two words, and any other amount as one."""
    number, blank, unit = fact.text.partition(" ")
    is_plain = blank and fact.amount and fact.amount.unit.text == unit
    return [number, unit] if is_plain else [fact.text]


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
    values = [name for name in facts if name in LIGHT_SYMBOLS]
    loss = facts[FILTER].text
    rest = {name: fact for name, fact in facts.items() if name != FILTER}
    if len(values) != 1:
        return {**rest, FILTER: facts[FILTER]}
    value = facts[values[0]]
    return {**rest, values[0]: value._replace(text=f"{value.text} * ({loss})")}


def _generic_names(facts: Facts) -> Iterator[str]:
    for name in facts:
        yield name
        if name in symbols.SPECIFIC:
            yield symbols.SPECIFIC[name][0]


def inputs_of(command: str, unit: Unit, given: Iterable[str] = ()) -> list[str]:
    """Return the inputs of a command that an amount without a name may be, by its unit.

    They are several if the command has other inputs of the same light, or lengths in um, or if its
    frames rename the input beside those that are given.
    """
    page, amount = page_of(command), Amount("", unit, 0)
    taken = taken_by(page)
    names, light = [*quantities_meant(amount)], light_of(amount)
    if light and names != [VALUE]:
        alike = [
            n
            for n in page.listed
            if symbols.SYMBOLS[n].geometry == symbols.SYMBOLS[names[0]].geometry
        ]
        names += [name for name in alike if not name.startswith("peak-")]
    elif amount.is_wavelength:
        alike = [n for n in page.listed if symbols.SYMBOLS[n].unit in ("nm", "um")]
        names = [name for name in alike if amount.dimension in symbols.SYMBOLS[name].dimensions]
    found = [in_kind(name, light.kind) if light else name for name in names]
    for frame in FRAMES:
        if frame.command == command:
            names = [n for n in found if n not in taken or frame.needs & {*given}]
            found += [new for name, new in frame.renamed if name in names]
    return [name for name in dict.fromkeys(found) if name in taken]


def _calculations(frame: Frame, facts: Facts, goal: Goal | None) -> list[list[str]]:
    """Return the calls of a calculator: one for each result that the goal may mean."""
    if not frame.light and any(is_light(fact) for fact in facts.values()):
        return []
    page = page_of(frame.command)
    taken = taken_by(page)
    given = {_taken(dict(frame.renamed).get(n, n), fact, taken): fact for n, fact in facts.items()}
    words = [frame.command]
    operand = OPERANDS.get(frame.command)
    if operand and operand not in given:
        return []
    if operand:
        words.append(one_word(given.pop(operand)))
    elif SHAPE in given and frame.operand:
        words.append(given.pop(SHAPE).text)
    elif frame.operand:
        words.append(frame.operand)
    return on_page(words, page, given, goal)


def on_page(words: list[str], page: Page, given: Facts, goal: Goal | None) -> list[list[str]]:
    """Return calls with facts as options of a page, one for each result that the goal may mean."""
    if not {*given} <= taken_by(page):
        return []
    goal = goal and _with_weight(goal)
    words = [*words]
    for name, fact in given.items():
        words.append(_input(name, fact))
    if goal is None:
        return [words]
    kind = kind_of(goal.unit) if goal.unit else ""
    if kind in WEIGHTS and "spectrum" in given and "weight" in page.listed:
        words.append(f"weight={WEIGHTS[kind][0]}")
    return [[*words, f"get={name}"] for name in _results(page, goal, given)]


def _with_weight(goal: Goal) -> Goal:
    """Return a goal of weighted light with its unit, which no other light has."""
    names = [name for name in goal.names if symbols.weighted_generic(name)]
    if goal.unit or not names:
        return goal
    symbol = symbols.SYMBOLS[names[0]]
    unit = resolve(symbol.unit.replace(" ", "."))
    return goal._replace(text=unit.text, unit=unit, names=())


def _taken(name: str, fact: Fact, taken: set[str]) -> str:
    """Return the name of a fact, or its name in one kind of light if a page takes only that."""
    light = read_light(fact.amount.unit) if fact.amount else None
    return name if name in taken or not light else in_kind(name, light.kind)


def _usual(value: str, fact: Fact, given: Facts) -> str:
    """Return what an amount with one condition becomes; its own quantity if that is named."""
    usual = USUAL_GOALS.get((symbols.generic_name(value), *given), "")
    is_named = usual and fact.symbols and " of " in fact.typed  # illuminance of 100 fc for 2 h
    return value.replace("-", " ") if is_named else usual


def _conversions(frame: Frame, facts: Facts, goal: Goal | None) -> list[list[str]]:
    """Return the conversion of the only amount that is not a condition."""
    conditions = taken_by(page_of("convert"))
    facts = {"wavelength" if n in WAVES else n: fact for n, fact in facts.items()}
    values = [name for name in facts if name not in conditions] or [*facts]
    if len(values) != 1 or values[0] not in (
        VALUE,
        *LIGHT_SYMBOLS,
        *symbols.SPECIFIC,
        "wavelength",
        "fwhm",
    ):
        return []
    value, given = values[0], {**facts}
    fact = given.pop(value)
    amount = fact.amount
    target = _target(goal, fact, given) if goal else _usual(value, fact, given)
    if amount is None or ((given or goal) and not target):
        return []
    if amount.dimension == NUMBER and given:  # a number whose unit is missing
        return []
    if "distance" in given and _is_of_small_source(facts, goal):
        return []
    words = ["convert", *_operands(fact), *filter(None, [target])]
    calls = [words + [_input(name, fact) for name, fact in given.items()]]
    if "incidence" in given and len(given) > 1 and generic(amount) == "irradiance":
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
        return symbols.specific_name("irradiance", light.kind).replace("-", " ")
    if value.amount and value.amount.dimension == TEMPERATURE and "peak-wavelength" in goal.names:
        return "wavelength"  # of a black body
    for name in goal.names if light and not goal.unit else ():
        symbol = symbols.SYMBOLS[name]
        if light and symbol.geometry and symbol.kind in ("", light.kind):
            return symbols.specific_name(symbol.generic, light.kind).replace("-", " ")
    if not goal.unit and goal.names and not is_name(goal.text):  # lambda
        label = symbols.SYMBOLS[goal.names[0]].label
        return label if is_name(label) else ""
    return goal.text


def _input(name: str, fact: Fact) -> str:
    """Return an input of a call; a flag has no value."""
    if symbols.SYMBOLS[name].form == symbols.FLAG:
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


def taken_by(page: Page) -> set[str]:
    """Return the symbols that a page takes, with the names of one kind of light."""
    names = {*page.listed}
    return names | {other for name in names for other in symbols.names_of_kinds(name)}


def _results(page: Page, goal: Goal | None, given: Facts) -> list[str]:
    """Return the results of a page that a goal may mean, as `-g` takes them."""
    if goal is None:
        return []
    if not page.light and not page.others:
        return _of_inputs(page, goal)
    options = (*page.light, *page.others, *page.takes)
    listed = [name for name in dict.fromkeys(options) if name not in given]
    if goal.unit or not any(map(is_light, given.values())):  # ISO 100 is assumed, not found
        listed = [name for name in listed if "(default" not in page.symbol(name).help]
    if goal.unit and goal.unit.text == EV and page.accepts("iso") and _has_other_speed(given):
        return [name for name in ("ev", "ev100") if name in listed]
    if goal.text in listed and "irradiance" not in goal.names[1:]:  # stops, ev100; not intensity
        return [goal.text]
    if "diameter" in goal.names and "beam-diameter" in listed and "diameter" not in listed:
        return ["beam-diameter"]
    own = {OF_INPUT[name] for name in given if name in OF_INPUT}
    return _with_units(goal, listed, own) if goal.unit else _called(goal, listed, own)


def _with_units(goal: Goal, listed: list[str], own: set[str]) -> list[str]:
    """Return the results that a goal with a unit, or with several, may mean."""
    assert goal.unit is not None
    result = result_name(goal.unit)
    found = _called(goal, listed, own) if goal.names else _in_unit(goal.unit, listed, own)
    names = [result if symbols.SPECIFIC.get(result, ("",))[0] == name else name for name in found]
    units = goal.text.split(",")
    return [",".join([f"{name}:{unit}" for unit in units]) for name in names]


def _has_other_speed(given: Facts) -> bool:
    """Return whether an ISO speed other than 100 is given."""
    return "iso" in given and read_amount(given["iso"].text).number != 100


def _of_inputs(page: Page, goal: Goal) -> list[str]:
    """Return the result of a page whose results depend on its inputs: by its name or its unit."""
    if goal.unit:
        own = result_name(goal.unit)
        is_result = is_solid_angle(goal) or own in symbols.SPECIFIC or own in LIGHT_SYMBOLS
        name = (
            own if is_irradiance(goal) else symbols.generic_name(own)
        )  # a spectrum has all three kinds
        return [f"{name}:{goal.text}"] if is_result else []
    angles = [ANGLE_OF_CONE] if {*goal.names} & {*ANGLES} else []
    return [n for n in goal.names if n in page.listed] or angles or list(goal.names[:1])


def _called(goal: Goal, listed: list[str], own: set[str]) -> list[str]:
    """Return the results with the names of a goal, or of its quantity if an input is for it."""
    wanted = {*goal.names, *map(symbols.generic_name, goal.names)}
    dimensions = {one for name in wanted for one in symbols.SYMBOLS[name].dimensions}
    wanted |= {name for name in own if dimensions & {*symbols.SYMBOLS[name].dimensions}}
    return [name for name in listed if name in wanted]


def _in_unit(unit: Unit, listed: list[str], own: set[str]) -> list[str]:
    """Return the results in a unit: those that an input is for, of its quantity, or all."""
    fitting = [name for name in listed if unit.dimension in symbols.SYMBOLS[name].dimensions]
    result = result_name(unit)
    wanted = own & {*fitting} or {result, symbols.generic_name(result)}
    return [name for name in fitting if name in wanted] or fitting


def readings_of(sentence: Sentence) -> list[Facts]:
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
    is_alone = [one.symbols for one in sentence.facts].count(("incidence",)) == 1
    is_plain = fact.symbols == ("incidence",) and "incidence" not in fact.typed
    if is_plain and is_alone and _has_beam(sentence):
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
    if light_of(amount):
        return quantities_meant(amount)
    wanted = {name for goal in sentence.goals for name in goal.names}
    if amount.dimension == ANGLE and wanted & {"hazard-distance", "spot-diameter"}:
        return ("divergence",)
    if amount.dimension == ANGLE and wanted & {"beam-diameter", "diameter"}:
        return OF_DIMENSION[ANGLE]
    if amount.dimension == ANGLE and any(map(is_solid_angle, sentence.goals)):
        return ("apex-angle", "half-angle")
    first = next(fact.amount for fact in sentence.facts if not fact.symbols)
    others = {name for fact in sentence.facts for name in fact.symbols}
    is_converted = first is amount and others <= taken_by(page_of("convert"))
    if is_converted and not any(map(is_light, sentence.facts)):
        return (VALUE,)
    if others & {"iso", "f-number"} and amount.dimension == NUMBER and amount.text[:2] == "1/":
        return ("time",)  # of a shutter
    if "aspect" in others and amount.dimension == LENGTH and not amount.is_wavelength:
        return ("diagonal",)  # of a screen
    return quantities_meant(amount)


def explained(calls: Sequence[tuple[str, ...]]) -> list[Try]:
    """Propose the calls of several readings, each with the meaning of what only it has."""
    in_all = set.intersection(*[{input_of(word)[0] for word in call[1:]} for call in calls])
    tries = []
    for command, *words in calls[:MOST]:
        page, pairs = page_of(command), [input_of(word) for word in words]
        own = [name for name, _ in pairs if name and name not in in_all]
        if not own:  # another command, or another result
            own = [text.partition(":")[0] for name, text in pairs if name == "get"]
        texts = [_meaning(page, name) for name in own if name in SYMBOLS]
        tries.append(Try(words=(command, *words), remark="; ".join(texts), follow=True))
    return tries


def _meaning(page: Page, name: str) -> str:
    """Return the first clause of the help of an input or a result, or its label."""
    symbol = page.symbol(name if name in page.texts else generic_name(name))
    text = symbol.help.partition("; ")[0].partition(". ")[0].rstrip(".")
    return mention(text[:1].lower() + text[1:]) if text else SYMBOLS[name].label
