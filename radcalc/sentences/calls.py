"""The call of a command that a sentence means: its facts decide."""

from collections.abc import Mapping, Sequence

from radcalc import errors
from radcalc.calculators import SUMMARIES, page_of
from radcalc.conversion.operands import read_operands, unit_first
from radcalc.errors import call, listed, quote, quote_path
from radcalc.quantities import name_of, symbols
from radcalc.quantities import read as read_light
from radcalc.quantities.names import DLI
from radcalc.quantities.search import comparable
from radcalc.sentences import doubts, near_words, size_of
from radcalc.sentences.doubts import (
    ELECTRICAL,
    LEDS,
    Facts,
    Way,
    is_bare,
    is_efficacy,
    is_lamp,
    is_light,
)
from radcalc.sentences.frames import calls_of, explained, on_page, readings_of
from radcalc.sentences.phrases import (
    BEAM,
    COMMAND,
    FILLERS,
    FILTER,
    LASER,
    MEANINGFUL,
    METER,
    PER_DAY,
    PERIOD,
)
from radcalc.sentences.reader import Fact, Goal, Sentence
from radcalc.sentences.used import (
    is_idle,
    moved_either_way,
    moved_in_distance,
    quotients_or_products,
    refuse_unused,
)
from radcalc.units import NUMBER, Daily
from radcalc.units.amounts import OPERATORS
from radcalc.units.dimensions import TEMPERATURE
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve, suggest

SHORTEST = 4  # letters of a word with a misspelling
OF_LASER = {COMMAND: Fact((COMMAND,), LASER, LASER)}
NEAR = 0.05  # of a temperature
OF_ROOM = {"flux", "irradiance", "receiver-area"}
UNDER_LAMP = {"irradiance", "receiver-area", "height"}
# Directions of light, and examples of them.
DIRECTIONS = {"isotropic", "hemisphere", "solid-angle", "exponent"}
DIRECTIONS |= {"half-angle", "apex-angle", "beam-angle"}
EXAMPLES_OF_BEAMS = (
    ("apex-angle", "30deg", "evenly in a cone of 30 deg, an example"),
    ("isotropic", "", "the same in all directions"),
)


def call_of(sentence: Sentence) -> list[str]:
    """Return the call that a sentence means: a command, its operands and NAME=VALUE.

    Raises UsageError if it has several readings, or none, or words that were not understood.
    """
    if unit_first(sentence.text.split()):
        amount, target = read_operands([sentence.text])
        return ["convert", amount.text, "to", target]
    if sentence.also:
        return _either(sentence._replace(also=None), sentence.also)
    if sentence.unknown:
        raise _not_understood(sentence)
    sentence = _of_efficacy(_with_values(sentence))
    doubts.refuse(sentence, None if sentence.files else _goal_of(sentence), _answerable)
    calls = _calls_of(sentence)
    if len(calls) > 1 and all(map(is_idle, calls)):
        refuse_unused(sentence, calls[0])
    if len(calls) == 1:
        _refuse_room(calls[0])
        refuse_unused(sentence, calls[0])
        return list(calls[0])
    is_name = len(sentence.goals) == 1 and not (sentence.facts or sentence.files)
    if not calls and is_name and sentence.ignored:  # what is a candela
        asked = quote(sentence.goals[0].text)
        raise errors.UsageError(f"{asked} of what?", call("help", *asked.split()))
    if not calls:
        parts = [fact.typed for fact in sentence.facts]
        wanted = f" and gives {quote(sentence.goals[0].text)}" if sentence.goals else ""
        what = ", ".join(map(quote, parts)) or "these words"
        raise errors.UsageError(f"no command takes {what}{wanted}", _about(sentence))
    raise _several(sentence, calls)


def _about(sentence: Sentence) -> str:
    """Return a hint about what is asked for: the call that finds what gives this quantity."""
    units = [fact.amount.unit for fact in sentence.facts if fact.amount and not is_bare(fact)]
    unit = units[0] if units else None
    if units and sentence.goals:
        unit = sentence.goals[0].unit
    if unit is None or unit.dimension == NUMBER:
        return "a call of the command that calculates it"
    return errors.command("help", *name_of(unit).split())


def _either(first: Sentence, second: Sentence) -> list[str]:
    """Return the call of the only reading that has one."""
    calls: list[list[str]] = []
    problem: errors.RadcalcError | None = None
    for sentence in (first, second):
        try:
            calls.append(call_of(sentence))
        except errors.SeveralReadings:
            raise
        except errors.RadcalcError as error:
            problem = problem or error
    if len(calls) > 1 and sorted(calls[0]) != sorted(calls[1]):
        raise _several(first, [tuple(call) for call in calls])
    if not calls:
        assert problem is not None
        raise problem
    return calls[0]


def _several(sentence: Sentence, calls: Sequence[tuple[str, ...]]) -> errors.SeveralReadings:
    problem = f"'{quote(sentence.text)}' has {len(calls)} readings"
    return errors.SeveralReadings(problem, explained(calls))


def _refuse_room(call: Sequence[str]) -> None:
    """Refuse a flux and an illuminance on an area, which may be a receiver's or a room's."""
    values = {}
    for word in call[1:]:
        name, _ = errors.input_of(word)
        values[symbols.generic_name(name)] = word
    if call[0] == "point-source" and {*values} - {"get"} == UNDER_LAMP:
        _refuse_lamp_above(call, values)
    if call[0] != "point-source" or {*values} != OF_ROOM:
        return
    size = errors.input_of(values["receiver-area"])[1]
    inputs = [word for name, word in values.items() if name != "receiver-area"]
    room = ("room", f"area={size}", *inputs, "utilance=0.6")
    remark = "luminaires of a room, with a utilance of 0.6 as an example"
    tries = [
        errors.Try(words=room, remark=remark, follow=True),
        errors.Try(words=(*call, "get=distance"), remark="distance of one lamp", follow=True),
    ]
    raise errors.SeveralReadings(f"{quote(size)} is the area of a receiver or of a room", tries)


def _refuse_lamp_above(call: Sequence[str], values: Mapping[str, str]) -> None:
    """Refuse the flux on an area of a room, which is lit evenly or by one lamp at its height."""
    result, _, unit = errors.input_of(values.get("get", ""))[1].partition(":")
    if not result.startswith("received"):
        return
    light, size = (errors.input_of(values[name])[1] for name in ("irradiance", "receiver-area"))
    tries = [
        errors.computed(
            errors.call("convert", light, unit or "lm", area=size, remark="lit evenly")
        ),
        errors.Try(
            words=tuple(call),
            remark="by one lamp above the middle, which has that irradiance",
            follow=True,
        ),
    ]
    raise errors.SeveralReadings("the light may be even, or that of one lamp at this height", tries)


def _of_efficacy(sentence: Sentence) -> Sentence:
    """Return a sentence whose watts of a lamp are those of its efficacy: 240 W LED, 2.7 umol/J."""
    if not any("efficacy" in fact.symbols or is_efficacy(fact) for fact in sentence.facts):
        return sentence
    facts = [
        fact._replace(symbols=()) if fact.symbols == ELECTRICAL else fact for fact in sentence.facts
    ]
    return sentence._replace(facts=tuple(facts))


def _with_values(sentence: Sentence) -> Sentence:
    """Return a sentence without places that have their value elsewhere: `white`, and its 0.7."""
    valued = {name for fact in sentence.facts if fact.text for name in fact.symbols}
    facts = [
        fact
        for fact in sentence.facts
        if fact.text or valued.isdisjoint(fact.symbols) or fact.symbols == ("spectrum",)
    ]
    return sentence._replace(facts=tuple(facts))


def _not_understood(sentence: Sentence) -> errors.UsageError:
    """Return the error for words that were not understood; propose the call without them."""
    unknown = sentence.unknown
    for word in unknown:
        if word[0].isdigit():
            read_amount(word)  # its error says more
    understood = [fact.typed for fact in sentence.facts] + [goal.text for goal in sentence.goals]
    known = f"understood {', '.join(map(quote, understood))}; " if understood else ""
    is_unit = any(map(is_bare, sentence.facts))  # 5 mw
    corrected = next(filter(None, [_corrected(word, is_unit) for word in unknown]), [])
    from radcalc.quantities.lookup import is_seen  # the values

    seen = next(filter(is_seen, (sentence.text, " ".join(unknown))), "")
    hint: errors.Hint = corrected or f"another word for {listed(unknown)}"
    if seen and not corrected and not sentence.facts:
        hint = call("typical", *seen.split())
    if (
        len(unknown) == 1 and len(sentence.facts) == 2 and unknown[0] in OPERATORS
    ):  # 10+-1 lx + 5+-2 lx
        sign, goals = f" {unknown[0]} ", [goal.text for goal in sentence.goals[:1]]
        hint = call("convert", sign.join([f"({text})" for text in understood[:2]]), *goals)
    return errors.UsageError(f"{known}not understood: {listed(unknown)}", hint)


def _corrected(word: str, is_unit: bool) -> list[errors.Try]:
    """Propose the known words that are like an unknown one, and units in another case."""
    if (len(word) < SHORTEST and not is_unit) or comparable(word) in MEANINGFUL:
        return []
    units = _in_other_case(word) if is_unit or "/" in word else []
    if units or len(word) < SHORTEST:
        return units
    near = [n for n in (*suggest(word), *near_words(word)) if comparable(n) not in {*FILLERS, word}]
    others = [n for n in near if not word.startswith(n)]  # rough for roughly
    return errors.corrections(word, *others[:2])


def _in_other_case(word: str) -> list[errors.Try]:
    """Propose a unit of several parts with the right case: W/m2 for w/m2."""
    try:
        resolve(word)
    except errors.UnitError as error:
        pairs = [one.instead for one in error.tries if len(one.instead) == 2]
        units = [word.replace(typed, other) for typed, other in pairs]
        return [errors.correct(word, one) for one in units if one.lower() == word.lower()]
    return []


def _calls_of(sentence: Sentence) -> list[tuple[str, ...]]:
    """Return the calls of all readings of a sentence with at most one goal."""
    if sentence.files:
        return _of_file(sentence)
    goal = _goal_of(sentence)
    if goal and _is_daily(goal):  # 16 h per day
        sentence = sentence._replace(facts=_periods(sentence)[1])
    has_filter = any(fact.symbols == (FILTER,) for fact in sentence.facts)
    if has_filter and sentence.fillers(METER):
        raise errors.UsageError(
            "the meter may be in front of the filter or behind it", "the light without it"
        )
    names_a_source = any(map(is_lamp, sentence.facts)) or bool(sentence.fillers(BEAM))
    sentence = _without_needless_spectrum(_with_led(sentence), goal)
    readings = readings_of(sentence)
    found = _in_frames(sentence, readings, goal) or quotients_or_products(sentence.facts, goal)
    if not found and not names_a_source:
        found = moved_in_distance(sentence.facts, goal)
    _refuse_wide(sentence, goal, found)
    if not found and not readings:
        texts = ", ".join([quote(fact.typed) for fact in sentence.facts])
        tries = [] if names_a_source else moved_either_way(sentence.facts, goal)
        raise errors.UsageError(
            f"two of these fill one place: {texts}",
            tries or "a call for each of them",
        )
    return list(dict.fromkeys(map(tuple, found)))


def _in_frames(sentence: Sentence, readings: Sequence[Facts], goal: Goal | None) -> list[list[str]]:
    """Return the calls of commands for all readings; the spot of a laser has a mean and a peak."""
    spots = [{**facts, **OF_LASER} for facts in readings if "diameter" in facts]
    found = [call for facts in spots for call in calls_of(facts, goal)] * sentence.has(LASER)
    return found or [call for facts in readings for call in calls_of(facts, goal)]


def _without_needless_spectrum(sentence: Sentence, goal: Goal | None) -> Sentence:
    """Return a sentence without a spectrum such as `led` or `sun`, if its light needs none.

    It is of one kind, or its efficacy is given.
    """
    units = [fact.amount.unit for fact in sentence.facts if fact.amount]
    units += [goal.unit] if goal and goal.unit else []
    if not units or any(map(is_bare, sentence.facts)):  # cri hps; 1 sun has an unknown unit
        return sentence
    efficacies = {
        u.dimension for u in units if u.dimension in symbols.SYMBOLS["efficacy"].dimensions
    }
    if len(efficacies) > 1:  # 150 lm/W in umol/J
        return sentence
    has_efficacy = bool(efficacies)
    if not has_efficacy and len({light.kind for unit in units if (light := read_light(unit))}) > 1:
        return sentence
    facts = [fact for fact in sentence.facts if not is_lamp(fact)]
    return sentence._replace(facts=tuple(facts))


def _refuse_wide(sentence: Sentence, goal: Goal | None, calls: Sequence[Sequence[str]]) -> None:
    """Refuse the flux of a source with a beam as if it lit all directions alike."""
    directed = sentence.fillers(BEAM) or [LASER] * sentence.has(LASER)
    names = {errors.input_of(word)[0] for call in calls[:1] for word in call}
    asked = {*goal.names} if goal else set()
    is_flux = any("flux" in name or "energy" in name for name in {*names, *asked})
    has_unit = goal and goal.unit and goal.unit.dimension in symbols.SYMBOLS["flux"].dimensions
    is_point = bool(calls) and calls[0][0] == "point-source" and names.isdisjoint(DIRECTIONS)
    is_crossed = len(calls) == 1 and _is_crossed(calls[0])
    if is_point and (is_crossed or (directed and (is_flux or has_unit))):
        tries = [
            errors.Try(words=(*calls[0], f"{name}={value}"), remark=remark, follow=True)
            for name, value, remark in EXAMPLES_OF_BEAMS
        ]
        problem = "the directions of the light are missing"
        if directed:
            problem = f"'{quote(directed[0])}' has a beam, and its angle is missing"
        raise errors.UsageError(problem, tries)


def _is_crossed(call: Sequence[str]) -> bool:
    """Return whether a call finds the light in all directions from that in one, at a distance."""
    pairs = [errors.input_of(word) for word in call]
    given = {symbols.generic_name(name) for name, _ in pairs}
    results = {
        symbols.generic_name(text.partition(":")[0]) for name, text in pairs if name == "get"
    } - given
    return results == {"flux"} or (results == {"intensity"} and "irradiance" not in given)


def _with_led(sentence: Sentence) -> Sentence:
    """Return a sentence with the CIE's LED of a colour temperature, as `led` and 3000 K."""
    facts = sentence.facts
    leds = [fact for fact in facts if is_lamp(fact) and fact.text.lower().endswith("led")]
    colours = [fact for fact in facts if fact.amount and fact.amount.dimension == TEMPERATURE]
    if len(leds) != 1 or len(colours) != 1 or colours[0].symbols:
        return sentence
    assert colours[0].amount is not None
    temperature = size_of(colours[0].amount)
    first, second = sorted(LEDS, key=lambda led: abs(LEDS[led] - temperature))[:2]
    others = sentence._replace(facts=tuple([fact for fact in facts if fact is not colours[0]]))
    if abs(LEDS[first] - temperature) <= NEAR * temperature:
        return Way(first, "").of(others, leds[0])
    names = (first, second)
    tries = [
        errors.Try(words=call, remark=f"an LED of {LEDS[name]} K", follow=True)
        for name in names
        for call in _answerable(Way(name, "").of(others, leds[0]))[:1]
    ]
    raise errors.UsageError(
        f"no LED of the CIE has about {quote(colours[0].typed)}", tries or first
    )


def _of_file(sentence: Sentence) -> list[tuple[str, ...]]:
    """Return the calls of the command that reads a file, with the other facts as its options.

    The file of a spectrum beside an amount of light is the spectrum of that light.
    """
    from radcalc.routes import LOG, LUMINAIRE, SPECTRUM, TABLE, call_of_file, kind_of

    path, *others = sentence.files
    if others:
        listed = " and ".join(map(quote_path, sentence.files))
        raise errors.UsageError(
            f"the sentence has several files: {listed}", "a call for each of them"
        )
    kind = kind_of(path)
    if kind in (SPECTRUM, TABLE) and any(map(is_light, sentence.facts)):
        with_file = (*sentence.facts, Fact(("spectrum",), path, path))
        return _calls_of(sentence._replace(files=(), facts=with_file))
    facts = tuple(map(_toward, sentence.facts)) if kind == LUMINAIRE else sentence.facts
    command, *operands = call_of_file(kind, path)
    if command not in SUMMARIES:  # a table, which has no results
        if sentence.facts or sentence.goals:
            raise errors.UsageError(f"{quote_path(path)} is a table", call(command, *operands))
        return [(command, *operands)]
    words = [command, *operands]
    if kind == LOG:
        periods, facts = _periods(sentence._replace(facts=facts))
        words += [f"{PERIOD}={fact.text}" for fact in periods]
    found = []
    goals = sentence.goals if len(sentence.goals) > 1 else [_goal_of(sentence)]
    for given in readings_of(sentence._replace(facts=facts)):
        of_goals = [on_page(words, page_of(command), given, goal) for goal in goals]
        if len(goals) == 1:
            found += of_goals[0]
        elif all(of_goals):  # several results of one file
            found.append([*of_goals[0][0], *[calls[0][-1] for calls in of_goals[1:]]])
    return list(dict.fromkeys(map(tuple, found)))


def _periods(sentence: Sentence) -> tuple[list[Fact], tuple[Fact, ...]]:
    """Return the period of the answers to a log, by default a day for a DLI, and other facts."""
    periods = [fact for fact in sentence.facts if fact.symbols == (PERIOD,)]
    if not periods and any(map(_is_daily, sentence.goals)):
        periods = [Fact((PERIOD,), PER_DAY, "")]
    return periods, tuple([fact for fact in sentence.facts if fact.symbols != (PERIOD,)])


def _is_daily(goal: Goal) -> bool:
    """Return whether a goal is a DLI, by its unit or by its name."""
    return isinstance(goal.unit, Daily) or goal.text.lower() in DLI


def _toward(fact: Fact) -> Fact:
    """Return an angle beside a luminaire: of incidence, or of a direction of its light."""
    if fact.symbols == ("incidence",) and "incidence" not in fact.typed:
        return fact._replace(symbols=("toward", "incidence"))
    return fact


def _goal_of(sentence: Sentence) -> Goal | None:
    """Return the only goal; the name and the unit of one result count as one."""
    goals = list(dict.fromkeys(sentence.goals))
    units = [goal for goal in goals if goal.unit]
    named = [goal for goal in goals if not goal.unit]
    if len(units) > 1 or len(named) > 1:
        texts = " and ".join([quote(goal.text) for goal in goals])
        calls = []
        if len(units) == len(goals):  # 10 dBm uW mW
            text = ",".join([goal.text for goal in units])
            calls = _answerable(sentence._replace(goals=(Goal(text, units[0].unit),)))
        tries = [errors.Try(words=words, follow=True) for words in calls[:1]]
        problem = f"the sentence asks for several results: {texts}"
        raise errors.UsageError(problem, tries or "one of them")
    if units and named:
        _check_named(named[0], units[0])
        return units[0]._replace(names=named[0].names)
    return goals[0] if goals else None


def _check_named(named: Goal, goal: Goal) -> None:
    """Refuse the name of one quantity with the unit of another."""
    assert goal.unit is not None
    dimensions = {one for name in named.names for one in symbols.SYMBOLS[name].dimensions}
    if goal.unit.dimension not in dimensions:
        problem = f"{quote(goal.text)} is not a unit of {quote(named.text)}"
        hint = f"one of them: {quote(named.text)} or {quote(goal.text)}"
        raise errors.UsageError(problem, hint)


def _answerable(sentence: Sentence) -> list[tuple[str, ...]]:
    """Return the calls of all readings of a sentence, none if it is refused."""
    try:
        return _calls_of(sentence)
    except errors.UsageError:
        return []
