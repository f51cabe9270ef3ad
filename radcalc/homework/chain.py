"""The derivation of a result as a chain of laws that propagates a wrong value.

A mistake gives one symbol a wrong value; the laws after it turn that into a wrong answer.  The
chain of a conversion, or of a quantity in a kind (radiant, luminous or photon) that was not given,
ends with a product of the factors between them.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from itertools import combinations
from typing import Any, NamedTuple

from radcalc.answer import Answer, Value
from radcalc.calculators.kinds import Ratio
from radcalc.derivation import (
    Formula,
    coherent_unit_of,
    format_number,
    format_value,
    letter_of,
    with_unit,
)
from radcalc.errors import RadcalcError
from radcalc.inputs.given import Inputs
from radcalc.laws.common import CONE
from radcalc.laws.law import AnyLaw, Law, Several, law
from radcalc.laws.solver import Derivation, Known, solve, step_of
from radcalc.quantities.light import GRID, LUMINOUS, PHOTON, RADIANT
from radcalc.quantities.symbols import EFFICACIES, SYMBOLS

Steps = list[tuple[AnyLaw, str]]
Powers = list[tuple[str, float]]
VALUE = "value"  # the result at the end of a product
# Results outside the laws that are proportional to another one.
SAME = {"sphere-fraction": "solid-angle", "apex-angle": "half-angle"}
FAILURES = (RadcalcError, ArithmeticError, ValueError, KeyError)


class Ends(NamedTuple):
    """The letters of a conversion's two quantities, its number, and the unit of the result."""

    source: str
    amount: str
    target: str
    unit: str
    factor: float

    def text(self, result: float) -> str:
        return with_unit(format_number(result / self.factor), self.unit)


class Worked(float):
    """A wrong result [SI], with what leads to it: wrong values of symbols, or a law as edited.

    A result that is not computed by a law may have its step as a text.
    """

    __slots__ = ("chain", "law", "target", "text", "wrong")
    chain: "Chain"
    law: AnyLaw | None
    target: str
    text: str
    wrong: Mapping[str, float]

    def __new__(
        cls,
        result: float,
        chain: "Chain",
        wrong: Mapping[str, float],
        law: AnyLaw | None = None,
        target: str = "",
        text: str = "",
    ) -> "Worked":
        worked = super().__new__(cls, result)
        worked.text = text
        worked.chain, worked.wrong, worked.law, worked.target = chain, wrong, law, target
        return worked

    def numbers(self) -> str:
        """Return the first step that goes wrong, in the learner's numbers; '' if it has none."""
        try:
            return self.text or self._numbers()
        except FAILURES:
            return ""

    def _numbers(self) -> str:
        values = {**self.chain.values, **self.wrong}
        law, target = self.law, self.target
        if law is None:
            for law, target in self.chain.steps:
                if target not in self.wrong and not self.wrong.keys().isdisjoint(law.names):
                    values[target] = _single(law.solve(target, values.__getitem__))
                    break
            else:
                return self._sizes()
        if not law.template.startswith(("{", "sin(")):
            return self._converted(law, values)
        known = {name: Known(values[name]) for name in law.names}
        return step_of(law, target, known, self.chain.kind).numbers

    def _converted(self, law: AnyLaw, values: Mapping[str, float]) -> str:
        """Return the formula of a factor, with the number that is converted: E = I / d^2."""
        left, _, right = law.template.partition(" = ")
        ends = self.chain.ends
        if ends is None or left != ends.target or f" {ends.source} " not in f" {right} ":
            return ""
        known = {name: values[name] for name in law.names[1:]}
        template = f" {right} ".replace(f" {ends.source} ", f" {ends.amount} ").strip()
        step = Formula("", f"{left} = {template}").step(known, ends.text(self), self.chain.kind)
        return step.numbers.replace(" (1) ", " ")  # a cosine of 1

    def _sizes(self) -> str:
        """Return the wrong values themselves."""
        return ", ".join(
            f"{letter_of(name)} = {format_value(size, coherent_unit_of(name, self.chain.kind))}"
            for name, size in self.wrong.items()
            if name != self.chain.goal
        )


class Chain:
    """The derivation of a result: values [SI] by symbol, and laws with the symbols solved for.

    `goal` is the symbol of the result, or one that it is proportional to; `symbols` are all that it
    depends on; `kind` is that of its light quantities.
    """

    def __init__(
        self, values: dict[str, float], steps: Steps, goal: str, right: float, kind: str = ""
    ) -> None:
        self.values, self.goal, self.kind = values, goal, kind
        self.ends: Ends | None = None
        self._scale = right / values.setdefault(goal, right) if right else 1.0
        self.steps: Steps = []
        needed = {goal}
        for step_law, target in reversed(steps):
            if target in needed:
                needed.update(step_law.names)
                self.steps.insert(0, (step_law, target))
        self.symbols = needed.intersection(values)

    def after(self, name: str, value: float) -> float | None:
        """Return the result [SI] with another value of a symbol, or None if there is no result."""
        return self.after_all({name: value})

    def after_all(self, wrong: Mapping[str, float]) -> float | None:
        """Return the result [SI] with other values of several symbols."""
        values, changed = {**self.values, **wrong}, {*wrong}
        try:
            for step_law, target in self.steps:
                if target not in wrong and not changed.isdisjoint(step_law.names):
                    values[target] = _single(step_law.solve(target, values.__getitem__))
                    changed.add(target)
            result = values[self.goal] * self._scale
        except FAILURES:
            return None
        is_result = self.goal in changed and math.isfinite(result)
        return Worked(result, self, wrong) if is_result else None

    def solved(self, target: str, solve: Callable[[Callable[[str], Any]], Any]) -> float | None:
        """Return the result [SI] if `solve` gives the value of `target` from the other symbols."""
        try:
            value = _single(solve(self.values.__getitem__))
        except FAILURES:
            return None
        return self.after(target, value)

    def by(self, law: AnyLaw, target: str, value: float) -> float | None:
        """Return the result [SI] with the value of a symbol that an edited law gives."""
        result = self.after(target, value)
        return None if result is None else Worked(result, self, {target: value}, law, target)


def _single(value: Any) -> float:
    if isinstance(value, Several):
        raise ValueError("several values")
    return float(value)


def of_answer(answer: Answer, target: Value, given: Inputs) -> Chain:
    """Return the chain of a calculator's result."""
    right, goal = float(target.amount), target.name
    if not isinstance(answer.steps, Derivation):
        return Chain({}, [], goal, right)
    solution, kind = answer.steps.solution, answer.steps.kind
    values = {
        n: amount.value for n, amount in solution.values.items() if isinstance(amount.value, float)
    }
    steps: Steps = list(solution.used)
    if goal not in values:
        symbol = SYMBOLS.get(goal) or SYMBOLS[target.also]  # of the radiant results: radiant-...
        goal = SAME.get(goal) or symbol.generic or goal
    if goal not in values and goal in CONE.targets and "solid-angle" in values:
        values[goal] = float(CONE.solve(goal, values.__getitem__))  # of the equal cone
        steps.append((CONE, goal))
    if goal not in values:
        _add_ratio(goal, given, values, steps)
    facts = GRID.get(target.dimensions[0])
    if SYMBOLS[goal].generic and goal in values and facts and facts[0] != kind:
        powers = between_kinds(kind, facts[0], given, values, steps)
        multiply([(goal, 1.0), *powers], right, values, steps)
        goal = VALUE
    return Chain(values, steps, goal, right, kind)


def of_laws(laws: Sequence[AnyLaw], goal: str, values: dict[str, float], right: float) -> Chain:
    """Return the chain of a result that follows from values by laws."""
    try:
        solution = solve(laws, {name: Known(value) for name, value in values.items()})
    except RadcalcError:
        return Chain({}, [], goal, right)
    found = {name: float(amount.value) for name, amount in solution.values.items()}
    return Chain(found, list(solution.used), goal, right, RADIANT)


def _add_ratio(goal: str, given: Inputs, values: dict[str, float], steps: Steps) -> None:
    """Add the law of the ratio of two kinds, if one quantity was given in both."""
    light_inputs = [light for light in given.values() if light.symbol.generic]
    for light, other in combinations(light_inputs, 2):
        if light.symbol.generic == other.symbol.generic:
            ratio = Ratio.of(light, other)
            if ratio.name == goal:
                over, _, under = ratio.law.names
                values |= {over: ratio.over.value, under: ratio.under.value, goal: ratio.value}
                steps.append((ratio.law, goal))


def multiply(powers: Powers, right: float, values: dict[str, float], steps: Steps) -> None:
    """End a chain with a product of powers, unless these overflow."""
    values[VALUE] = right
    with suppress(OverflowError):
        product = math.prod(values[name] ** power for name, power in powers)
        names = (VALUE, *(name for name, _ in powers))
        constant = right / product if product else 1.0
        steps.append((Law("", "", names, tuple(powers), constant), VALUE))


# ---------------------------------------------------------------------------------------------
# The factors between two kinds of light

LUMINOUS_EFFICACY = law(
    "efficacy of one wavelength", "{luminous-efficacy} = Km {luminous-efficiency}"
)


def between_kinds(
    start: str, end: str, given: Inputs, values: dict[str, float], steps: Steps
) -> Powers:
    """Return the factors between two kinds and their powers; add their values and laws."""
    from radcalc.conversion import spectral  # with the tables of the observers

    powers: Powers = []
    if "wavelength" in given:
        from radcalc.laws import optics
        from radcalc.spectra.observers import luminous_efficacy

        light = spectral.light(given["wavelength"], given.get("observer"))
        if LUMINOUS in (start, end):
            eye = light.observer
            values["luminous-efficacy"] = float(luminous_efficacy(light.table, eye))
            values["luminous-efficiency"] = values["luminous-efficacy"] / eye.maximum
            steps.append((LUMINOUS_EFFICACY._replace(constant=eye.maximum), "luminous-efficacy"))
            powers.append(("luminous-efficacy", 1.0 if end == LUMINOUS else -1.0))
        if PHOTON in (start, end):
            values["wavelength"] = float(light.vacuum)
            values["photon-energy"] = float(light.photon_energy)
            steps.append((optics.PHOTON_ENERGY, "photon-energy"))
            powers.append(("photon-energy", 1.0 if start == PHOTON else -1.0))
        return powers
    for name, over, under in EFFICACIES:
        if {over, under} == {start, end} and (ratio := spectral.linked(given, over, under)):
            values[name] = float(ratio.value)
            powers.append((name, 1.0 if end == over else -1.0))
    return powers
