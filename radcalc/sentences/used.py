"""The promise of sentences: what was typed is in the call, and the result comes from all of it.

So are the conversions of several amounts: products, quotients, and light at another distance.
"""

import re
from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import reduce
from importlib import import_module
from math import isclose
from typing import Any

from radcalc.answer import Answer
from radcalc.calculators import page_of
from radcalc.calculators.solved import Task
from radcalc.conversion.operands import read_operands
from radcalc.conversion.plan import plan, source_of, target_of
from radcalc.errors import RadcalcError, Try, Unused, UsageError, input_of, listed, quote
from radcalc.inputs import Input, Inputs
from radcalc.inputs.reading import read
from radcalc.quantities import read as read_light
from radcalc.quantities.symbols import FLAG, QUANTITY, SYMBOLS, light_unit
from radcalc.sentences import Amount, size_of
from radcalc.sentences.doubts import LEDS, generic, is_number
from radcalc.sentences.frames import FRAMES, is_irradiance
from radcalc.sentences.reader import Fact, Goal, Sentence
from radcalc.units import NUMBER, OWN, Dimension, Unit
from radcalc.units.dimensions import ANGLE, LENGTH, SOLID_ANGLE, TEMPERATURE, times
from radcalc.units.numbers import find_constant
from radcalc.units.table import resolve

DISTANCE = ("distance",)
OF_EFFICACY = ("lm/W", "umol/J")  # light per power, or its photons
INVERSE_SQUARE = re.compile(r"\(.+\) \* \(.+\)\^2 / \(.+\)\^2|.+ \* sqrt\(\(.+\) / \(.+\)\)")
SMALL_SOURCE = "a source small compared to both distances (the inverse square law)"
PPFD = "umol/m2/s"  # which is a unit in expressions


def quotients_or_products(facts: Sequence[Fact], goal: Goal | None) -> list[list[str]]:
    """Return the conversion of the quotient or product of two amounts that has the goal's unit."""
    amounts = [fact.amount for fact in facts if fact.amount]
    if any(a.dimension == SOLID_ANGLE and "*" in a.text for a in amounts):  # 24 deg x 12 deg
        return []
    if goal is None or len(amounts) != len(facts) or any(map(is_number, facts)):
        return []
    dimensions = (goal.unit.dimension,) if goal.unit else SYMBOLS[goal.names[0]].dimensions
    if len(amounts) == 3:  # 24 W/m of 100 lm/W, 5 m
        ways = _product_of_three(amounts)
    elif len(amounts) == 2:
        if of_scale := _on_scale(amounts, goal):
            return [of_scale]
        ways = _of_two(amounts)
    else:
        return []
    targets = dict.fromkeys(dimensions, _unit_of(goal, amounts))
    if goal.names[:1] == ("efficacy",) and not goal.unit:
        targets = {resolve(unit).dimension: unit for unit in OF_EFFICACY}
    return [["convert", way, targets[of]] for way, of in ways.items() if of in targets]


def _product_of_three(amounts: Sequence[Amount]) -> dict[str, Dimension]:
    """Return the product of three different quantities, with its dimension."""
    of_amounts = {amount.dimension for amount in amounts}
    if len(of_amounts) < 3 or of_amounts & {ANGLE, SOLID_ANGLE, NUMBER}:
        return {}
    return {" * ".join([f"({amount.text})" for amount in amounts]): reduce(times, of_amounts)}


def _of_two(amounts: Sequence[Amount]) -> dict[str, Dimension]:
    """Return the quotients and the product of two quantities; places are none."""
    dimensions = [amount.dimension for amount in amounts]
    if set(dimensions) == {NUMBER} or {LENGTH, ANGLE} & set(dimensions):
        return {}
    first, second = amounts
    return {
        f"{first.text} / ({second.text})": times(first.dimension, second.dimension, -1),
        f"{second.text} / ({first.text})": times(second.dimension, first.dimension, -1),
        f"{first.text} * ({second.text})": times(first.dimension, second.dimension),
    }


def _on_scale(amounts: Sequence[Amount], goal: Goal) -> list[str]:
    """Return the optical density of two amounts, or the shift of a filter in mired."""
    dimensions = {amount.dimension for amount in amounts}
    if goal.text.upper() == "OD" and not dimensions & {LENGTH, ANGLE} and dimensions != {NUMBER}:
        smaller, larger = sorted(amounts, key=size_of)  # a density is positive
        return ["convert", f"({smaller.text}) / ({larger.text})", goal.text]
    is_mired = goal.unit and goal.unit.is_scale and goal.unit.dimension == TEMPERATURE
    if is_mired and dimensions == {TEMPERATURE}:
        before, after = [amount.text for amount in amounts]
        return ["convert", f"1/({after}) - 1/({before})", "1/MK"]
    return []


def _unit_of(goal: Goal, amounts: Sequence[Amount]) -> str:
    """Return the unit of a goal; a name for several kinds of light is that of the amounts."""
    if goal.unit or not goal.names:
        return goal.text
    symbol = SYMBOLS[goal.names[0]]
    kinds = [light.kind for amount in amounts if (light := read_light(amount.unit))]
    return light_unit(symbol.generic, kinds[0]) if symbol.generic and kinds else symbol.unit


def moved_in_distance(facts: Sequence[Fact], goal: Goal | None) -> list[list[str]]:
    """Return the conversion of light on a surface from one distance to another, or a distance.

    Both distances have `at`, and the light comes from a small lamp: it is not the sun's, nor a
    laser's.  The distance that is known stands after its light.
    """
    lights, places = _lights_and_places(facts)
    if len(facts) != 3 or facts[0] not in lights:
        return []
    starts = {fact.typed.split()[0] for fact in places}
    if len(starts) > 1 or any(fact.symbols != DISTANCE for fact in places):  # from one to another
        return []
    if len(places) == 2 and (goal is None or is_irradiance(goal) or is_micromoles(goal.unit)):
        return [_moved(lights[0], places, goal)]
    if len(lights) == 2 and places and goal and "distance" in goal.names:
        known = facts[facts.index(places[0]) - 1]
        wanted = next(light for light in lights if light is not known)
        place = f"{places[0].text} * sqrt(({known.text}) / ({wanted.text}))"
        return [["convert", place, goal.text if goal.unit else _unit_text(places[0])]]
    return []


def law_of(call: Sequence[str]) -> list[str]:
    """Return the law of a conversion of light from one distance to another."""
    is_moved = call[0] == "convert" and any(map(INVERSE_SQUARE.fullmatch, call[1:2]))
    return [SMALL_SOURCE] if is_moved else []


def moved_either_way(facts: Sequence[Fact], goal: Goal | None) -> list[Try]:
    """Propose the light at one distance from that at another, where either may be known."""
    lights, places = _lights_and_places(facts)
    if (len(lights), len(places), len(facts)) != (1, 2, 3) or not (
        goal is None or is_irradiance(goal) or is_micromoles(goal.unit)
    ):
        return []
    return [
        Try(
            words=tuple(_moved(lights[0], both, goal)),
            remark="from {} to {}, by the inverse square law".format(
                *[quote(f.text) for f in both]
            ),
            follow=True,
        )
        for both in (places, places[::-1])
    ]


def _lights_and_places(facts: Sequence[Fact]) -> tuple[list[Fact], list[Fact]]:
    """Return the facts of light on a surface, as growers say umol for PPFD, and the distances."""
    amounts = [(fact, fact.amount) for fact in facts if fact.amount]
    lights = [f for f, a in amounts if generic(a) == "irradiance" or is_micromoles(a.unit)]
    places = [f for f, a in amounts if a.dimension == LENGTH and not a.is_wavelength]
    return lights, [fact for fact in places if fact.symbols in ((), DISTANCE)]


def _moved(light: Fact, places: Sequence[Fact], goal: Goal | None) -> list[str]:
    """Return the conversion of light at the first place to that at the second."""
    here, there = places
    unit = _unit_text(light)
    texts = [light.text, goal.text if goal else unit]
    if is_micromoles(light.amount and light.amount.unit):
        texts = [text.replace(unit, PPFD) for text in texts]
    value = f"({texts[0].replace('ppfd', PPFD)}) * ({here.text})^2 / ({there.text})^2"
    return ["convert", value, texts[1]]


def is_micromoles(unit: Unit | None) -> bool:
    """Return whether a unit is that of a number of photons."""
    light = read_light(unit) if unit else None
    return light is not None and light.is_count


def _unit_text(fact: Fact) -> str:
    assert fact.amount is not None
    return fact.amount.unit.text


NUMBERS = re.compile(r"(?<![^\W\d_])\d+(?:\.\d+)?")
EXPONENTS = re.compile(r"(?<=[^\W\d_])\^?-?[1-4](?![\w.°])")  # of units: m-2, m^2
WORD = re.compile(r"[^\W\d]\w*")
OF_LED = "spectrum=LED-"  # in place of a colour temperature
DESCRIBING = frozenset(["wavelength", "spectrum"])  # what a light is: said, if it is not used
ROUNDED = 1e-9  # relative difference of equal results, far below that of moved inputs
MOVED = 1e-3  # relative change of an input, which a result shows
ALL = "a sentence in which each amount changes the answer"
SOLVED = {frame.command for frame in FRAMES}


def refuse_unused(sentence: Sentence, call: Sequence[str]) -> None:
    """Raise for an amount of a sentence that its call lacks, or that the result does not need.

    Raise the error of a call that is refused if its hint would leave out an amount.
    """
    facts = sentence.facts
    lost = _lost(facts, call)
    tries: list[Try] = []
    if not lost:
        try:
            names, tries = unneeded(call)
            names = names - DESCRIBING
        except RadcalcError as error:
            numbers = [number for fact in facts for number in _numbers(fact.text)]
            kept = [one for one in error.tries if _has(_whole(one, call), numbers)]
            if len(kept) == len(error.tries):
                return  # the call says it
            raise error.reworded(hint=[_whole(one, call) for one in kept] or ALL) from None
        lost = [_typed(fact) for fact in facts if names & _names(fact, call)] or [*names]
    if lost:
        goals = listed([goal.text for goal in sentence.goals])
        known = [text for text in map(_typed, facts) if text not in lost]
        understood = f"understood {', '.join(map(quote, known))}; " if known else ""
        wanted = f" for {goals}" if goals else ""
        raise UsageError(f"{understood}not used{wanted}: {listed(lost)}", tries or ALL)


def _lost(facts: Sequence[Fact], call: Sequence[str]) -> list[str]:
    """Return the phrases with a number that the words of a call lack."""
    has = Counter(_numbers(" ".join(call)))
    has_led = any(word.startswith(OF_LED) for word in call)
    lost = []
    for fact in facts:
        is_of_led = has_led and fact.amount and fact.amount.dimension == TEMPERATURE
        typed = Counter(_numbers(fact.amount.text if fact.amount else fact.text))
        if typed - has and not is_of_led:
            lost.append(_typed(fact))
        has -= typed
    return lost


def _has(proposal: Try, numbers: Sequence[str]) -> bool:
    """Return whether a proposed call has all of some numbers."""
    text = " ".join(proposal.words)
    return all(number in text for number in numbers)


def _typed(fact: Fact) -> str:
    return fact.typed.replace("f/ ", "f/")


def _names(fact: Fact, call: Sequence[str]) -> set[str]:
    """Return the inputs of a call that have the numbers of a fact."""
    typed = _numbers(fact.text)
    pairs = [input_of(word) for word in call[1:]]
    return {name for name, text in pairs if name and typed and _numbers(text) == typed}


def _numbers(text: str) -> list[str]:
    """Return the numbers of a text, without those in its units, and the user's constants."""
    own = [word for word in WORD.findall(text) if find_constant(word) in OWN] if OWN else []
    return NUMBERS.findall(EXPONENTS.sub("", text)) + own


def assumptions_of(sentence: Sentence, call: Sequence[str]) -> list[str]:
    """Return what the answer of a sentence assumes, which its call does not say."""
    texts = dict(map(input_of, call))
    idle = _unneeded_in(call) if DESCRIBING & texts.keys() else set()
    said = [
        f"the same at every wavelength: {quote(texts[name])} is not used"
        for name in sorted(DESCRIBING & idle)
    ]
    led = texts.get("spectrum", "")
    for fact in sentence.facts:
        if led in LEDS and fact.amount and fact.amount.dimension == TEMPERATURE:
            said.append(f"an LED of {quote(fact.typed)} is taken as {led}, of {LEDS[led]} K (CIE)")
        elif fact.symbols == ("spectrum",) and "efficacy" in texts and not led:
            said.append(f"the efficacy is that of {quote(fact.text)}, whose spectrum is not used")
    return [*law_of(call), *said]


def is_idle(call: Sequence[str]) -> bool:
    """Return whether an input of a call does not change its result, nor describes its light."""
    return bool(_unneeded_in(call) - DESCRIBING)


def _unneeded_in(call: Sequence[str]) -> set[str]:
    """Return the inputs that do not change the result of a call; none if it is refused."""
    try:
        return unneeded(call)[0]
    except RadcalcError:
        return set()


def unneeded(call: Sequence[str]) -> tuple[set[str], list[Try]]:
    """Return the inputs of a call that do not change its result, and calls that use them.

    Return none for a call with all results.
    """
    command, *words = call
    if command not in SOLVED:
        return set(), []
    pairs = [input_of(word) for word in words]
    operands = [text for name, text in pairs if not name]
    results = [text for name, text in pairs if name == "get"]
    page = page_of(command)
    given = {
        name: read(name, text or SYMBOLS[name].form == FLAG, bare=page.bare.get(name, ""))
        for name, text in pairs
        if name and name != "get"
    }
    try:
        if command == "convert":
            _plan(operands, [*given.values()])
        elif results and (work_out := _function(command, operands)):
            names = [result.partition(":")[0] for text in results for result in text.split(",")]
            return _idle(work_out, given, names), [
                Try(words=(command, *words[: -len(results)]), follow=True)
            ]
    except Unused as error:
        kept = [one for one in error.tries if not one.without]
        kept = [one for one in kept if one.instead[:1] in ((), (operands[-1],))]
        return {*error.symbols}, [_whole(one, call) for one in kept]
    return set(), []


def _plan(operands: list[str], given: list[Input]) -> None:
    """Plan a conversion, which refuses a condition that it does not need."""
    amount, text = read_operands(operands)
    unit = amount.typed[1]
    if text and unit:
        target = target_of(text, unit)
        source = source_of(amount, target, given) or unit
        plan(source, target, given, f"{amount.exact:.12g}")


def _function(command: str, operands: Sequence[str]) -> Callable[[Inputs], Answer] | None:
    """Return the function of a calculator; None for one with an operand."""
    module = import_module(f"radcalc.calculators.{command.replace('-', '_')}")
    if hasattr(module, "task"):
        task: Task = module.task(operands, lambda name: False)
        return task.nominal
    if module.PAGE.operand:  # a wavelength or a spectrum, with no other inputs to lose
        return None
    return Task(command, getattr(module, command.replace("-", "_"))).nominal


def _idle(work_out: Callable[[Inputs], Answer], given: Inputs, names: Sequence[str]) -> set[str]:
    """Return the inputs that can change without any of the results of these names."""
    first = _results(work_out(given), names)
    idle = set()
    for name, item in given.items():
        if item.symbol.form != QUANTITY or not any(first):
            continue
        moved = item._replace(value=item.value * (1 + MOVED) + MOVED * (not item.value))
        with suppress(RadcalcError):  # one that contradicts the others is used
            second = _results(work_out({**given, name: moved}), names)
            if len(second) == len(first) and all(map(_is_same, first, second)):
                idle.add(name)
    return idle


def _is_same(first: float, second: float) -> bool:
    return isclose(first, second, rel_tol=ROUNDED)


def _results(answer: Answer, names: Sequence[str]) -> list[Any]:
    """Return the results of these names [SI]."""
    values = [value for value in answer.values if {value.name, value.also} & {*names}]
    return [value.amount for value in values if not value.is_absent]


def _whole(proposal: Try, call: Sequence[str]) -> Try:
    """Return the call that a proposal changes, as a whole."""
    if proposal.words:
        return proposal
    old, *new = proposal.instead or ("", "")
    gone = {*proposal.without, *[name for name, _ in proposal.inputs]}
    words = [" ".join(new) if word == old else word for word in call]
    words = [word for word in words if word and input_of(word)[0] not in gone]
    words += [f"{name}={value}" for name, value in proposal.inputs]
    return Try(words=tuple(words), remark=proposal.remark, follow=True)
