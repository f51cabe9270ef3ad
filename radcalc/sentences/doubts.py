"""Facts of a sentence, and doubts about what it does not say.

Facts are the light that its amounts measure, and the places that they mean.  A doubt has the ways
to say what is missing; each way is another sentence.
"""

from collections.abc import Callable, Iterator, Sequence

from radcalc import errors
from radcalc.errors import quote
from radcalc.quantities import LUMINOUS, PHOTON, Reading, symbols
from radcalc.quantities import read as read_light
from radcalc.quantities.search import comparable
from radcalc.quantities.symbols import SYMBOLS
from radcalc.sentences import Amount, amount_of
from radcalc.sentences.phrases import FILTER, LAMP, LIGHT, SUN
from radcalc.sentences.reader import Fact, Goal, Sentence
from radcalc.tuples import NamedTuple
from radcalc.units import NUMBER, OWN, dimensions
from radcalc.units.dimensions import ANGLE, POWER, SOLID_ANGLE

VALUE = "value"  # the amount that is converted
LIGHT_SYMBOLS = ("flux", "intensity", "exitance", "irradiance", "radiance", "exposure", "energy")
Facts = dict[str, Fact]
# Facts that an amount of that dimension may fill, if no phrase says which.
OF_DIMENSION = {
    dimensions.LENGTH: ("distance",),
    dimensions.AREA: ("area",),
    dimensions.TIME: ("time",),
    dimensions.ANGLE: ("apex-angle", "incidence", "half-angle"),
}
# Words for light that is not that of a lamp.
DAYS = ("sun", "sunlight", "full sun", "solar", "daylight", "skylight", "moonlight")
# Correlated colour temperatures [K] of the white LEDs of the CIE, as `spectrum` gives them.
LEDS = {"LED-B1": 2735, "LED-B2": 2999, "LED-B3": 4102, "LED-B4": 5106, "LED-B5": 6591}


def is_efficacy(fact: Fact) -> bool:
    """Return whether a fact is a ratio of two kinds of light, such as lm/W."""
    amount = fact.amount
    return amount is not None and amount.dimension in SYMBOLS["efficacy"].dimensions


def is_number(fact: Fact) -> bool:
    """Return whether a fact is a number alone, or one with a name, as `nd 0.6`."""
    amount = fact.amount
    is_named = bool(fact.symbols) and amount is not None and amount.dimension == NUMBER
    return is_named or is_bare(fact)


def is_bare(fact: Fact) -> bool:
    """Return whether a fact is a number alone, without a name and without a unit."""
    return not fact.symbols and fact.amount is not None and fact.amount.unit.text == "1"


def is_lamp(fact: Fact) -> bool:
    """Return whether a fact is a spectrum by a word of everyday language: led, sun, daylight."""
    is_word = fact.text.replace(" ", "").isalpha() and fact.text not in OWN
    return fact.symbols == ("spectrum",) and is_word


def light_of(amount: Amount) -> Reading | None:
    """Return the light that an amount measures; None for a density, a scale or no light."""
    light = read_light(amount.unit)
    return light if light and not light.axis and not amount.unit.is_scale else None


def quantities_meant(amount: Amount) -> tuple[str, ...]:
    """Return the symbols that a unit means."""
    if light_of(amount):
        return (generic(amount) or VALUE,)
    if amount.is_wavelength:
        return ("wavelength",)
    for name in ("efficacy", "responsivity"):
        if amount.dimension in SYMBOLS[name].dimensions:
            return (name,)
    return OF_DIMENSION.get(amount.dimension, (VALUE,))


def is_light(fact: Fact) -> bool:
    """Return whether a fact is an amount of light, with or without its name."""
    is_named = any(SYMBOLS[name].geometry for name in fact.symbols if name in SYMBOLS)
    is_alone = not fact.symbols and fact.amount and read_light(fact.amount.unit)
    return bool(is_named or is_alone)


def generic(amount: Amount) -> str:
    """Return the generic name of a light quantity: flux, intensity, irradiance, radiance ..."""
    if amount.unit.is_exitance:
        return "exitance"
    names = [name for name in LIGHT_SYMBOLS[::-1] if amount.dimension in SYMBOLS[name].dimensions]
    return next((name for name in names if name != "exitance"), "")


ELECTRICAL = ("flux", "input-power")  # of `60 W led`
PLAIN_FLUX = ((), ("flux",))
# Examples of the efficacy of a lamp, and of one with a filament, which `typical` gives.
EXAMPLES_OF_LAMPS = {LUMINOUS: "100lm/W", PHOTON: "2.5umol/J"}
FILAMENTS = frozenset(["incandescent", "tungsten", "filament", "zarovka", "zarovky"])
OF_FILAMENTS = "12lm/W"
GREY = "0.18"  # the reflectance of a grey card of photographers
# Usual fluorescent lamps of the CIE, with their colour temperatures as `spectrum` gives them.
FLUORESCENT = {
    "FL2": "cool white, 4225 K",
    "FL4": "warm white, 2940 K",
    "FL11": "three bands, 4000 K",
}
REFLECTANCE = "reflectance"


class Way(NamedTuple):
    """Another sentence: a fact with another text, in which {} is its own, or other symbols.

    `without` is a symbol that goes, `more` a fact that comes, and `goal` is asked for if none is.
    `call` is that of the way, without another sentence.
    """

    text: str
    remark: str
    symbols: tuple[str, ...] | None = None
    without: str = ""
    more: tuple[Fact, ...] = ()
    goal: str = ""
    call: tuple[str, ...] = ()

    def of(self, sentence: Sentence, fact: Fact) -> Sentence:
        """Return the sentence with a fact changed."""
        text = self.text.format(fact.text)
        amount = fact.amount if text == fact.text else amount_of(text, 0) or fact.amount
        names = fact.symbols if self.symbols is None else self.symbols
        other = Fact(names, text, fact.typed, amount)
        facts = [other if one is fact else one for one in sentence.facts]
        kept = [one for one in facts if self.without not in one.symbols]
        goals = sentence.goals
        if self.goal and not goals:
            goals = (Goal(symbols.SYMBOLS[self.goal].label, None, (self.goal,)),)
        return sentence._replace(facts=(*kept, *self.more), goals=goals)


class Doubt(NamedTuple):
    """A doubt about a fact: whether it applies, what is said, its ways, and a hint without one.

    In the problem, {0} is the phrase as typed and {1} the text of its value.
    """

    applies: Callable[[Sentence, Fact, Goal | None], bool]
    problem: str
    ways: Callable[[Sentence, Fact, Goal | None], Iterator[Way]]
    hint: str


def refuse(
    sentence: Sentence,
    goal: Goal | None,
    calls_of: Callable[[Sentence], Sequence[tuple[str, ...]]],
) -> None:
    """Raise the first doubt about a sentence, with the first call of each way."""
    for doubt in DOUBTS:
        for fact in sentence.facts:
            if doubt.applies(sentence, fact, goal):
                label = symbols.SYMBOLS[fact.symbols[0]].label if _has_no_text(fact) else ""
                problem = doubt.problem.format(quote(fact.typed), quote(fact.text), label)
                tries = [
                    errors.Try(words=call, remark=way.remark, follow=True)
                    for way in doubt.ways(sentence, fact, goal)
                    for call in ([way.call] if way.call else calls_of(way.of(sentence, fact)))[:1]
                ]
                kind = errors.SeveralReadings if len(tries) > 1 else errors.UsageError
                raise kind(problem, tries or doubt.hint)


def _none(*_: object) -> Iterator[Way]:
    return iter(())


def _is_height_of_sun(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    is_plain = fact.symbols == ("incidence",) and "incidence" not in fact.typed
    is_given = "normal" in fact.typed or fact.text[:6] == "90deg-"
    return is_plain and not is_given and sentence.has(SUN)


def _heights(sentence: Sentence, fact: Fact, goal: Goal | None) -> Iterator[Way]:
    yield Way("{}", "from the normal")
    yield Way("90deg-{}", "the sun's height")


def _is_electrical(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    """Return whether watts are those of a lamp without its efficacy: 400 W HPS."""
    facts = sentence.facts
    if any("efficacy" in one.symbols or is_efficacy(one) for one in facts):
        return False
    is_lit = sentence.has(LAMP) or any(is_lamp(f) and f.text.lower() not in DAYS for f in facts)
    is_of_lamp = is_lit and not sentence.has(LIGHT) and fact.symbols in PLAIN_FLUX
    is_watts = fact.amount is not None and fact.amount.dimension == POWER
    return fact.symbols == ELECTRICAL or (is_watts and is_of_lamp)


def _watts(sentence: Sentence, fact: Fact, goal: Goal | None) -> Iterator[Way]:
    efficacy = EXAMPLES_OF_LAMPS[PHOTON if goal and _is_of_photons(goal) else LUMINOUS]
    words = {*map(comparable, sentence.text.split())}
    if efficacy == EXAMPLES_OF_LAMPS[LUMINOUS] and not FILAMENTS.isdisjoint(words):
        efficacy = OF_FILAMENTS
    led = (Fact(("spectrum",), "LED", "LED"),) if "led" in fact.typed.lower().split() else ()
    yield Way(f"{{}}*{efficacy}", f"electrical watts, {efficacy} as an example", ("flux",))
    yield Way("{}", "watts of light", ("flux",), more=led)


def _is_of_photons(goal: Goal) -> bool:
    """Return whether a goal is a unit, or the name, of photons."""
    light = read_light(goal.unit) if goal.unit else None
    return bool(light and light.kind == PHOTON) or any(
        symbols.SYMBOLS[name].kind == PHOTON for name in goal.names
    )


def _has_no_text(fact: Fact) -> bool:
    return not fact.text and symbols.SYMBOLS[fact.symbols[0]].form != symbols.FLAG


def _is_lamp_of_many(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    return _has_no_text(fact) and fact.symbols == ("spectrum",)


def _fluorescent(sentence: Sentence, fact: Fact, goal: Goal | None) -> Iterator[Way]:
    yield from (Way(name, remark) for name, remark in FLUORESCENT.items())


def _has_no_value(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    return _has_no_text(fact)


def _examples(sentence: Sentence, fact: Fact, goal: Goal | None) -> Iterator[Way]:
    is_grey = not {"grey", "gray"}.isdisjoint(fact.typed.lower().split())
    yield Way(GREY if is_grey else symbols.SYMBOLS[fact.symbols[0]].example, "an example")


def _is_percentage(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    """Return whether a percentage has no name, and is not that of a surface that shines."""
    is_alone = fact.symbols == (REFLECTANCE,) and fact.typed == fact.text and "%" in fact.text
    return is_alone and not (goal and _is_of_shining(goal))


def _is_of_shining(goal: Goal) -> bool:
    """Return whether a goal is the radiance or the exitance of a surface, by its unit or name."""
    reading = read_light(goal.unit) if goal.unit else None
    names = {symbols.generic_name(name) for name in goal.names}
    return bool(reading and reading.is_radiance) or not names.isdisjoint(("radiance", "exitance"))


def _leaves_or_falls(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    """Return whether the exitance of a reflector is in lux: exitance of 500 lx, reflectance 0.8."""
    has_reflectance = any(REFLECTANCE in one.symbols for one in sentence.facts)
    return bool(
        has_reflectance and _exitances(fact) and fact.amount and not fact.amount.unit.is_exitance
    )


def _exitances(fact: Fact) -> list[str]:
    return [name for name in fact.symbols if symbols.generic_name(name) == "exitance"]


def _sides(sentence: Sentence, fact: Fact, goal: Goal | None) -> Iterator[Way]:
    name = _exitances(fact)[0]
    yield Way("{}", "it falls on the surface", (), goal=name)
    yield Way("{}", "it leaves the surface", (name,), without=REFLECTANCE)


def _is_density_or_factor(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    """Return whether the number of an ND filter is a density or a factor: ND 8."""
    number = fact.amount.text if fact.amount else ""
    is_nd = fact.symbols == (FILTER,) and "nd" in fact.typed.lower().split()
    return is_nd and number.isdigit() and int(number) > 1


def _densities(sentence: Sentence, fact: Fact, goal: Goal | None) -> Iterator[Way]:
    number = fact.amount.text if fact.amount else ""
    yield Way(f"{number}.0 OD", "the density")
    yield Way(f"1/{number}", "the factor")


def _has_no_unit(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    """Return whether the unit of the only number is missing: 10 S to ms, luminance 700 to lx."""
    if len(sentence.facts) != 1 or sentence.files or goal is None or goal.unit is None:
        return False
    number, unit = fact.text, goal.unit
    has_number = fact.amount is not None and fact.amount.unit.text == "1"
    if not has_number or (unit.dimension == NUMBER and not unit.is_scale):
        return False
    known = [symbols.SYMBOLS[name] for name in fact.symbols if name in symbols.SYMBOLS]
    dimensions = [one for symbol in known for one in symbol.dimensions]
    is_other = bool(dimensions) and {NUMBER, unit.dimension}.isdisjoint(dimensions)
    is_behind = sentence.text.rfind(goal.text) > sentence.text.find(number)
    is_apart = is_behind and f"{number} {goal.text}" not in sentence.text
    return is_other or (is_bare(fact) and (unit.is_scale or is_apart))


def _is_field(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    """Return whether the diameter of a field is asked for, which is not that of the beam."""
    is_diameter = goal and not {"diameter", "beam-diameter"}.isdisjoint(goal.names)
    return bool(is_diameter) and "field-angle" in fact.symbols


def _edges(sentence: Sentence, fact: Fact, goal: Goal | None) -> Iterator[Way]:
    yield Way("{}", "to the edge of the field", ("apex-angle",))
    yield Way("{}", "of the beam, at half of the peak")


def _is_width(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    """Return whether the width of a band lacks its place: 1 nm is 1059 GHz at 532 nm."""
    if len(sentence.facts) > 1 or fact.symbols[-1:] != ("fwhm",):
        return False
    is_same = goal and goal.unit and fact.amount and goal.unit.dimension == fact.amount.dimension
    return not is_same


def _places(sentence: Sentence, fact: Fact, goal: Goal | None) -> Iterator[Way]:
    place = Fact(("wavelength",), "532nm", "532 nm", amount_of("532 nm", 0))
    yield Way("{}", "at 532 nm, an example", (), more=(place,))


def _is_of_two_angles(sentence: Sentence, fact: Fact, goal: Goal | None) -> bool:
    """Return whether a solid angle is a product of two angles, as of a field of 60 deg x 40 deg."""
    sides = [amount_of(side, 0) for side in fact.text.split("*")]
    is_alone = len(sides) == 2 and not fact.symbols
    return is_alone and all(side and side.dimension == ANGLE for side in sides)


def _fields(sentence: Sentence, fact: Fact, goal: Goal | None) -> Iterator[Way]:
    sides = [f"2m*tan(({side.strip()})/2)" for side in fact.text.split("*")]
    page = ("solid-angle", "rectangle", f"width={sides[0]}", f"length={sides[1]}", "distance=1m")
    if goal and goal.unit and goal.unit.dimension == SOLID_ANGLE and len(sentence.facts) == 1:
        call = (*page, f"get=solid-angle:{goal.text}")
        yield Way("{}", "a field from edge to edge", call=call)
    yield Way("{}", "the product, for small angles")


DOUBTS = (
    Doubt(
        _is_of_two_angles,
        "'{0}' is a field from edge to edge, or a product",
        _fields,
        "the solid angle",
    ),
    Doubt(
        _is_height_of_sun,
        "'{0}' is the angle from the normal, or the sun's height",
        _heights,
        "the angle from the normal",
    ),
    Doubt(
        _is_electrical,
        "'{0}': the watts of a lamp are electrical or of its light",
        _watts,
        "its flux in lm, or its radiant flux",
    ),
    Doubt(_is_lamp_of_many, "'{0}': lamps of this kind differ", _fluorescent, "FL2"),
    Doubt(_has_no_value, "'{0}': the {2} is missing", _examples, "a number"),
    Doubt(
        _is_percentage,
        "{1} may be a reflectance, a transmittance or another part",
        _none,
        "its name before it, or the number times it: 500*0.8 lx",
    ),
    Doubt(
        _leaves_or_falls,
        "{1} may fall on the surface or leave it",
        _sides,
        "the illuminance or the exitance",
    ),
    Doubt(
        _is_density_or_factor,
        "{0} is ambiguous: a density or a factor",
        _densities,
        "a density of one decimal",
    ),
    Doubt(_has_no_unit, "the unit of {1} is missing", _none, "a unit after the number"),
    Doubt(
        _is_width,
        "'{0}' is the width of a band, and its wavelength is missing",
        _places,
        "the wavelength of the band, and a unit after 'to'",
    ),
    Doubt(_is_field, "the field and the beam have two diameters", _edges, "the angle of the beam"),
)
