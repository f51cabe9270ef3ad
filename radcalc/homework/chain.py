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

from radcalc.answer import (
    Answer,
    Formula,
    Value,
    coherent_unit_of,
    format_number,
    format_value,
    letter_of,
    with_unit,
)
from radcalc.calculators.kinds import Ratio
from radcalc.conversion import Plan, spectral
from radcalc.conversion.geometric import Factor
from radcalc.conversion.natural import LawPlan
from radcalc.errors import RadcalcError
from radcalc.inputs import Inputs
from radcalc.laws import APEX, CIRCLE, CONE, DIAMETER, PROJECTED_CONE, AnyLaw, Law, Several, law
from radcalc.laws.point import BEAM_ANGLE, LOBE
from radcalc.laws.solver import Derivation, Known, solve, step_of
from radcalc.laws.surface import disc_on_axis
from radcalc.quantities import LUMINOUS, PHOTON, RADIANT, base_of, place_of, read, symbol_of
from radcalc.quantities.symbols import EFFICACIES, SYMBOLS, weighted_generic

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
        values, changed = {**self.values, name: value}, {name}
        try:
            for step_law, target in self.steps:
                if target != name and not changed.isdisjoint(step_law.names):
                    values[target] = _single(step_law.solve(target, values.__getitem__))
                    changed.add(target)
            result = values[self.goal] * self._scale
        except FAILURES:
            return None
        is_result = self.goal in changed and math.isfinite(result)
        return Worked(result, self, {name: value}) if is_result else None

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
        goal = SAME.get(goal) or symbol.generic or weighted_generic(goal) or goal
    if goal not in values and goal in CONE.targets and "solid-angle" in values:
        values[goal] = float(CONE.solve(goal, values.__getitem__))  # of the equal cone
        steps.append((CONE, goal))
    if goal not in values:
        _add_ratio(goal, given, values, steps)
    facts = place_of(target.dimensions[0])
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
    given = spectral.behind_filter(given)
    powers: Powers = []
    if "wavelength" in given:
        from radcalc.laws import optics
        from radcalc.spectra.observers import luminous_efficacy, observer_of

        light = spectral.light(given["wavelength"])
        if eye := observer_of(start) or observer_of(end):
            values["luminous-efficacy"] = float(luminous_efficacy(light.table, eye))
            values["luminous-efficiency"] = values["luminous-efficacy"] / eye.maximum
            steps.append((LUMINOUS_EFFICACY._replace(constant=eye.maximum), "luminous-efficacy"))
            powers.append(("luminous-efficacy", 1.0 if base_of(end) == LUMINOUS else -1.0))
        if PHOTON in (start, end):
            values["wavelength"] = float(light.vacuum)
            values["photon-energy"] = float(light.photon_energy)
            steps.append((optics.PHOTON_ENERGY, "photon-energy"))
            powers.append(("photon-energy", 1.0 if start == PHOTON else -1.0))
        return powers
    for name, *bases in EFFICACIES:
        if {*bases} != {base_of(start), base_of(end)}:
            continue
        over, under = (start, end) if base_of(start) == bases[0] else (end, start)
        if ratio := spectral.linked(given, over, under):
            values[name] = float(ratio.value)
            powers.append((name, 1.0 if end == over else -1.0))
    return powers


def of_conversion(conversion: Plan, number: float, right: float, given: Inputs) -> Chain:
    """Return the chain of a conversion: its source times the factors of the conditions."""
    values = {name: item.value for name, item in given.items() if isinstance(item.value, float)}
    if isinstance(conversion, LawPlan):
        source, target = conversion.names
        values = {"emissivity": 1.0, **values, source: number * conversion.source.factor}
        return of_laws(conversion.laws, target, values, right)
    steps: Steps = []
    powers: Powers = []
    for factor, sign in conversion.links:
        name = _factor(factor, given, values, steps)
        if name:
            powers.append((name, float(sign)))
    start, end = read(conversion.source), read(conversion.target)
    if start and end and start.kind != end.kind:
        powers += between_kinds(start.kind, end.kind, given, values, steps)
    multiply(powers, right, values, steps)
    chain = Chain(values, steps, VALUE, right)
    letters = [symbol_of(unit).partition("_")[0] for unit in (conversion.source, conversion.target)]
    amount = f"({with_unit(format_number(number), conversion.source.text)})"
    unit = conversion.target
    chain.ends = Ends(letters[0], amount, letters[1], unit.text, float(unit.factor))
    return chain


def _of_factor(name: str, formula: str, letter: str, *powers: tuple[str, float]) -> Law:
    return Law(name, formula, (letter, *(symbol for symbol, _ in powers)), powers)


INVERSE_SQUARE = _of_factor(
    "inverse square law",
    "E = I {cosine} Omega0 / {distance}^2",
    "q",
    ("cosine", 1),
    ("distance", -2),
)
SMALL_SOLID_ANGLE = law("small solid angle", "{projected-solid-angle} = {solid-angle} {cosine}")
REFLECTOR = _of_factor(
    "Lambertian reflector", "L = {reflectance} E / (pi Omega0)", "r", ("reflectance", 1)
)
PUPIL = _of_factor("retinal illuminance", "E_T = pi / 4 {pupil}^2 L, d in mm", "p", ("pupil", 2))
ALL_ROUND = {  # by condition and letter of the factor
    ("isotropic", "Omega"): law("isotropic source", "{solid-angle} = 4 pi Omega0"),
    ("hemisphere", "Omega"): law("hemisphere", "{solid-angle} = 2 pi Omega0"),
    ("hemisphere", "Omega_p"): law("hemisphere", "{projected-solid-angle} = pi Omega0"),
}
SYMBOL_OF = {
    "t": "time",
    "s": "responsivity",
    "B": "bandwidth",
    "A": "area",
    "Omega": "solid-angle",
    "Omega_p": "projected-solid-angle",
    "cos(theta)": "cosine",
    "cos(theta_s)": "cosine-of-source",
}
BEFORE: dict[str, Steps] = {  # laws that give these symbols from other inputs
    "A": [(DIAMETER, "radius"), (CIRCLE, "area")],
    "Omega": [
        (APEX, "half-angle"),
        (BEAM_ANGLE, "exponent"),
        (LOBE, "solid-angle"),
        (CONE, "solid-angle"),
    ],
    "Omega_p": [
        (APEX, "half-angle"),
        (DIAMETER, "radius"),
        (PROJECTED_CONE, "projected-solid-angle"),
        (disc_on_axis("distance"), "projected-solid-angle"),
    ],
}


def _factor(factor: Factor, given: Inputs, values: dict[str, float], steps: Steps) -> str:
    """Return the symbol of a factor, or '' for a factor between kinds; add its laws."""
    letter, size = factor.letter, float(factor.value)
    factor_law: Law | None = None
    name = SYMBOL_OF.get(letter, letter)
    for earlier_law, target in BEFORE.get(letter, ()):
        if target not in values and values.keys() >= set(earlier_law.names) - {target}:
            values[target] = float(earlier_law.solve(target, values.__getitem__))
            steps.append((earlier_law, target))
    for (condition, of), all_round in ALL_ROUND.items():
        if of == letter and condition in given and math.isclose(all_round.constant, size):
            factor_law = all_round
    if letter == "q":
        values["cosine"] = size * values["distance"] ** 2
        factor_law = INVERSE_SQUARE
    elif letter == "Omega_p" and "solid-angle" in given:
        values["cosine"] = size / values["solid-angle"]
        factor_law = SMALL_SOLID_ANGLE
    elif letter == "r":
        factor_law = REFLECTOR._replace(constant=1 / math.pi)
    elif letter == "p":
        values["pupil"] /= 1e-3
        factor_law = PUPIL._replace(constant=math.pi / 4)
    elif letter == "J" and "lambda" in factor.steps[0].formula:
        values["wavelength"] = float(spectral.light(given["wavelength"]).vacuum)
        text = factor.steps[0].formula.rpartition("= ")[2].replace("lambda", "{wavelength}")
        formula, power = f"J = {text}", 2.0 if text.startswith("{") else -2.0
        factor_law = _of_factor("density", formula, letter, ("wavelength", power))
        factor_law = factor_law._replace(constant=size / values["wavelength"] ** power)
    elif name == letter:
        return ""
    if name in values and not math.isclose(values[name], size, rel_tol=1e-9):
        steps.pop()  # the law of a disc on its axis does not apply to an oblique disc
    values[name] = size
    if factor_law:
        steps.append((factor_law, name))
    return name
