"""The derivation of a result as a chain of laws, along which a wrong value is carried on.

An edit of the derivation gives one symbol another value, and what follows from that is a wrong
answer.  A light quantity in another kind than the one given, and a conversion, end with a law of
their own: a product of what stands between.
"""

import math
from collections.abc import Callable
from typing import Any

from radcalc.answer import Answer, Value
from radcalc.conversion import spectral
from radcalc.conversion.conditions import Factor
from radcalc.conversion.plan import Plan
from radcalc.errors import RadcalcError
from radcalc.given import Inputs
from radcalc.laws import photon
from radcalc.laws.cones import APEX, CONE, PROJECTED_CONE
from radcalc.laws.law import AnyLaw, Law, law
from radcalc.laws.point import BEAM_ANGLE, LOBE
from radcalc.laws.sizes import CIRCLE, DIAMETER
from radcalc.laws.solver import Derivation
from radcalc.laws.surface import disc_on_axis
from radcalc.quantities.light import GRID, LUMINOUS, PHOTON, RADIANT, read
from radcalc.quantities.symbols import SYMBOLS
from radcalc.spectra.observers import luminous_efficacy

Steps = list[tuple[AnyLaw, str]]
Powers = list[tuple[str, float]]
VALUE = "value"  # the result at the end of a product
# Results that are another one but for a factor, where they stand outside the laws.
SAME = {"sphere-fraction": "solid-angle", "apex-angle": "half-angle"}
FAILURES = (RadcalcError, ArithmeticError, ValueError, KeyError, TypeError)


class Chain:
    """What leads to a result: values [SI] by symbols, and the laws, with what each was solved for.

    `goal` is the symbol of the result, or of what it is a multiple of; `symbols` are those that
    have a part in it.
    """

    def __init__(self, values: dict[str, float], steps: Steps, goal: str, right: float) -> None:
        self.values, self.goal = values, goal
        self._scale = right / values.setdefault(goal, right) if right else 1.0
        self.steps: Steps = []
        needed = {goal}
        for one, target in reversed(steps):
            if target in needed:
                needed.update(one.names)
                self.steps.insert(0, (one, target))
        self.symbols = needed.intersection(values)

    def after(self, name: str, value: float) -> float | None:
        """The result where a symbol has another value; None where there is none."""
        values, changed = {**self.values, name: value}, {name}
        try:
            for one, target in self.steps:
                if target != name and not changed.isdisjoint(one.names):
                    values[target] = one.solve(target, values.__getitem__)
                    changed.add(target)
            found = float(values[self.goal]) * self._scale
        except FAILURES:
            return None
        return found if self.goal in changed and math.isfinite(found) else None

    def solved(self, target: str, solve: Callable[[Callable[[str], Any]], Any]) -> float | None:
        """The result where a symbol follows in another way from the others."""
        try:
            value = float(solve(self.values.__getitem__))
        except FAILURES:
            return None
        return self.after(target, value)


def of_answer(answer: Answer, target: Value, given: Inputs) -> Chain:
    """The chain that leads to a result of a calculator."""
    right, goal = float(target.amount), target.name
    if not isinstance(answer.steps, Derivation):
        return Chain({}, [], goal, right)
    solution, kind = answer.steps.solution, answer.steps.kind
    values = {n: one.value for n, one in solution.values.items() if isinstance(one.value, float)}
    steps: Steps = list(solution.used)
    if goal not in values:
        goal = SAME.get(goal) or SYMBOLS[goal].generic or goal
    if goal not in values and goal in CONE.targets and "solid-angle" in values:
        values[goal] = float(CONE.solve(goal, values.__getitem__))  # of the equal cone
        steps.append((CONE, goal))
    facts = GRID.get(target.dimensions[0])
    if SYMBOLS[goal].generic and goal in values and facts and facts[0] != kind:
        powers = _between_kinds(kind, facts[0], given, values, steps)
        _multiply([(goal, 1.0), *powers], right, values, steps)
        goal = VALUE
    return Chain(values, steps, goal, right)


def of_conversion(made: Plan, right: float, given: Inputs) -> Chain:
    """The chain of a conversion: its source times the factors of the conditions."""
    values = {name: one.value for name, one in given.items() if isinstance(one.value, float)}
    steps: Steps = []
    powers: Powers = []
    for factor, sign in made.links:
        name = _factor(factor, given, values, steps)
        if name:
            powers.append((name, float(sign)))
    start, end = read(made.source), read(made.target)
    if start and end and start.kind != end.kind:
        powers += _between_kinds(start.kind, end.kind, given, values, steps)
    _multiply(powers, right, values, steps)
    return Chain(values, steps, VALUE, right)


def _multiply(powers: Powers, right: float, values: dict[str, float], steps: Steps) -> None:
    """End a chain with a product of powers."""
    product = math.prod(values[name] ** power for name, power in powers)
    names = (VALUE, *(name for name, _ in powers))
    values[VALUE] = right
    steps.append((Law("", "", names, tuple(powers), right / product if product else 1.0), VALUE))


# ---------------------------------------------------------------------------------------------
# What stands between two kinds of light

SEEN = law("efficacy of one wavelength", "{luminous-efficacy} = Km {luminous-efficiency}")
RATIOS = (
    ("luminous-efficacy", LUMINOUS, RADIANT),
    ("photon-efficacy", PHOTON, RADIANT),
    ("lux-per-ppfd", LUMINOUS, PHOTON),
)


def _between_kinds(
    start: str, end: str, given: Inputs, values: dict[str, float], steps: Steps
) -> Powers:
    """The symbols, with their powers; their values and laws are added to those that are there."""
    powers: Powers = []
    if "wavelength" in given:
        light = spectral.light(given["wavelength"], given.get("observer"))
        if LUMINOUS in (start, end):
            eye = light.observer
            values["luminous-efficacy"] = float(luminous_efficacy(light.table, eye))
            values["luminous-efficiency"] = values["luminous-efficacy"] / eye.maximum
            steps.append((SEEN._replace(constant=eye.maximum), "luminous-efficacy"))
            powers.append(("luminous-efficacy", 1.0 if end == LUMINOUS else -1.0))
        if PHOTON in (start, end):
            values["wavelength"] = float(light.vacuum)
            values["photon-energy"] = float(light.photon_energy)
            steps.append((photon.ENERGY, "photon-energy"))
            powers.append(("photon-energy", 1.0 if start == PHOTON else -1.0))
        return powers
    for name, over, under in RATIOS:
        if {over, under} == {start, end} and (ratio := spectral.linked(given, over, under)):
            values[name] = float(ratio.value)
            powers.append((name, 1.0 if end == over else -1.0))
    return powers


# ---------------------------------------------------------------------------------------------
# The factors of a conversion as laws.  A symbol in a formula that is none of the law's stands for
# the light itself.


def _of_factor(name: str, formula: str, letter: str, *powers: tuple[str, float]) -> Law:
    return Law(name, formula, (letter, *(one for one, _ in powers)), powers)


INVERSE_SQUARE = _of_factor(
    "inverse square law",
    "E = I {cosine} Omega0 / {distance}^2",
    "q",
    ("cosine", 1),
    ("distance", -2),
)
REFLECTOR = _of_factor(
    "Lambertian reflector", "L = {reflectance} E / (pi Omega0)", "r", ("reflectance", 1)
)
PUPIL = _of_factor("retinal illuminance", "E_T = pi / 4 {pupil}^2 L, d in mm", "p", ("pupil", 2))
ALL_ROUND = {  # by the condition, and the letter of the factor
    ("isotropic", "Omega"): law("isotropic source", "{solid-angle} = 4 pi Omega0"),
    ("hemisphere", "Omega"): law("hemisphere", "{solid-angle} = 2 pi Omega0"),
    ("hemisphere", "Omega_p"): law("hemisphere", "{projected-solid-angle} = pi Omega0"),
}
SYMBOL_OF = {
    "t": "time",
    "B": "bandwidth",
    "A": "area",
    "Omega": "solid-angle",
    "Omega_p": "projected-solid-angle",
}
BEFORE: dict[str, Steps] = {  # the laws of what may be given in place of these symbols
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
    """The symbol that stands for a factor, or '' for a link of kinds; its laws are added."""
    letter, size = factor.letter, float(factor.value)
    name = SYMBOL_OF.get(letter, letter)
    for one, target in BEFORE.get(letter, ()):
        if target not in values and values.keys() >= set(one.names) - {target}:
            values[target] = float(one.solve(target, values.__getitem__))
            steps.append((one, target))
    whole = next((one for (by, of), one in ALL_ROUND.items() if of == letter and by in given), None)
    if letter == "q":
        values["cosine"] = size * values["distance"] ** 2
        whole = INVERSE_SQUARE
    elif letter == "r":
        whole = REFLECTOR._replace(constant=1 / math.pi)
    elif letter == "p":
        values["pupil"] /= 1e-3
        whole = PUPIL._replace(constant=math.pi / 4)
    elif letter == "J" and "wavelength" in given:
        values["wavelength"] = float(spectral.light(given["wavelength"], None).vacuum)
        is_from_length = factor.unit.startswith("m/")
        formula = "J = {wavelength}^2 / c" if is_from_length else "J = c / {wavelength}^2"
        power = 2.0 if is_from_length else -2.0
        whole = _of_factor("density", formula, letter, ("wavelength", power))
        whole = whole._replace(constant=size / values["wavelength"] ** power)
    elif name == letter:
        return ""
    if name in values and not math.isclose(values[name], size, rel_tol=1e-9):
        steps.pop()  # a disc aslant is no disc on its axis
    values[name] = size
    if whole:
        steps.append((whole, name))
    return name
