"""Conversions of several amounts: products, quotients, and light at another distance."""

import re
from collections.abc import Sequence
from functools import reduce

from radcalc.errors import Try, quote
from radcalc.quantities.light import read as read_light
from radcalc.quantities.symbols import (
    SYMBOLS,
    light_unit,
)
from radcalc.sentences.facts import generic, is_number
from radcalc.sentences.frames import is_irradiance
from radcalc.sentences.reader import Fact, Goal
from radcalc.sentences.words import Amount, size_of
from radcalc.units import NUMBER, Dimension, Unit
from radcalc.units.dimensions import (
    ANGLE,
    LENGTH,
    SOLID_ANGLE,
    TEMPERATURE,
    times,
)
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
