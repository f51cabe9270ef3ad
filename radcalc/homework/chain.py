"""The derivation of a result as a chain of laws, along which a wrong value is carried on.

An edit of the derivation gives one symbol another value, and what follows from that is a wrong
answer.  The chain has the laws that lead to the result, in their order; a light quantity in
another kind than the one given has the link of the kinds at its end.
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
from radcalc.laws.cones import CONE, PROJECTED_CONE
from radcalc.laws.law import AnyLaw, Law
from radcalc.laws.point import BEAM_ANGLE, LOBE
from radcalc.laws.sizes import CIRCLE
from radcalc.laws.solver import Derivation
from radcalc.laws.surface import disc_on_axis
from radcalc.quantities.light import GRID, LUMINOUS, PHOTON, RADIANT, read
from radcalc.quantities.symbols import SYMBOLS
from radcalc.spectra.observers import luminous_efficacy
from radcalc.spectra.planck import LIGHT

PI = math.pi
Steps = list[tuple[AnyLaw, str]]
# Results that are another one but for a factor, where they stand outside the laws.
SAME = {"sphere-fraction": "solid-angle", "apex-angle": "half-angle"}
FAILURES = (RadcalcError, ArithmeticError, ValueError, KeyError, TypeError)


class Chain:
    """What leads to a result: `values` [SI] of the symbols, and the laws with what each gave.

    `goal` is the symbol of the result, which may be `scale` times that.
    """

    def __init__(self, values: dict[str, float], steps: Steps, goal: str, right: float) -> None:
        self.values, self.goal = values, goal
        values.setdefault(goal, right)
        self.scale = right / values[goal] if values[goal] else 1.0
        needed, self.steps = {goal}, []
        for law, target in reversed(steps):
            if target in needed:
                needed.update(law.names)
                self.steps.insert(0, (law, target))
        self.symbols = [name for name in values if name in needed]

    def after(self, name: str, value: float, *more: tuple[str, float]) -> float | None:
        """The result where a symbol (or several) has another value; None where there is none."""
        values = {**self.values, name: value, **dict(more)}
        changed = {name, *(other for other, _ in more)}
        try:
            for law, target in self.steps:
                if target not in changed and not changed.isdisjoint(law.names):
                    values[target] = law.solve(target, values.__getitem__)
                    changed.add(target)
            found = float(values[self.goal]) * self.scale
        except FAILURES:
            return None
        return found if math.isfinite(found) and self.goal in changed else None

    def edited(self, target: str, solve: Callable[[Callable[[str], Any]], Any]) -> float | None:
        """The result where a symbol follows in another way from the others."""
        try:
            value = solve(self.values.__getitem__)
        except FAILURES:
            return None
        return self.after(target, value)


def of_answer(answer: Answer, target: Value, given: Inputs) -> Chain:
    """The chain that leads to a result of a calculator."""
    values: dict[str, float] = {}
    steps: Steps = []
    symbol = SYMBOLS[target.name]
    goal = target.name
    right = float(target.amount)
    if isinstance(answer.steps, Derivation):
        known = answer.steps.solution.values
        values = {n: one.value for n, one in known.items() if isinstance(one.value, float)}
        steps = list(answer.steps.solution.used)
        if goal not in values:
            goal = SAME.get(goal) or symbol.generic or goal
        if goal == "half-angle" and goal not in values and "solid-angle" in values:
            steps.append((CONE, goal))  # that of the equal cone
            values[goal] = CONE.solve(goal, values.__getitem__)
        facts = GRID.get(target.dimensions[0])
        if symbol.generic and facts and answer.steps.kind not in ("", facts[0]) and goal in values:
            link = links(answer.steps.kind, facts[0], given, values, steps)
            value = right / values[goal]
            if link:
                names = tuple(name for name, _ in link)
                steps.append((Law("", "", ("value", goal, *names), ((goal, 1.0), *link)), "value"))
                values["value"] = values[goal] * value
                goal = "value"
    return Chain(values, steps, goal, right)


def links(
    start: str, end: str, given: Inputs, values: dict[str, float], steps: Steps
) -> list[tuple[str, float]]:
    """The symbols, with their powers, that lead from one kind of light to another.

    Their values and laws are added to those that are there.
    """
    if "wavelength" in given:
        light = spectral.light(given["wavelength"], given.get("observer"))
        powers = []
        if LUMINOUS in (start, end):
            eye = light.observer
            efficacy = float(luminous_efficacy(light.table, eye))
            values["luminous-efficiency"] = efficacy / eye.maximum
            values["luminous-efficacy"] = efficacy
            names = ("luminous-efficacy", "luminous-efficiency")
            template = f"{{{names[0]}}} = {eye.constant} {{{names[1]}}}"
            seen = Law("efficacy", template, names, ((names[1], 1.0),), eye.maximum)
            steps.append((seen, names[0]))
            powers.append(("luminous-efficacy", 1.0 if end == LUMINOUS else -1.0))
        if PHOTON in (start, end):
            values["wavelength"] = float(light.vacuum)
            values["photon-energy"] = float(light.photon_energy)
            steps.append((photon.ENERGY, "photon-energy"))
            powers.append(("photon-energy", 1.0 if start == PHOTON else -1.0))
        return powers
    for name, over, under in (
        ("luminous-efficacy", LUMINOUS, RADIANT),
        ("photon-efficacy", PHOTON, RADIANT),
        ("lux-per-ppfd", LUMINOUS, PHOTON),
    ):
        if {over, under} == {start, end}:
            factor = spectral.linked(given, over, under)
            if factor is not None:
                values[name] = float(factor.value)
                return [(name, 1.0 if end == over else -1.0)]
    return []


# ---------------------------------------------------------------------------------------------
# Conversions: each condition is a law that gives one symbol of the whole.

REFLECTOR = Law(
    "", "L = {reflectance} E / (pi Omega0)", ("r", "reflectance"), (("reflectance", 1.0),), 1 / PI
)
INVERSE_SQUARE = Law(
    "",
    "E = I {cosine} Omega0 / {distance}^2",
    ("q", "cosine", "distance"),
    (("cosine", 1.0), ("distance", -2.0)),
)
PUPIL = Law("", "E_T = pi / 4 {pupil}^2 L, d in mm", ("p", "pupil"), (("pupil", 2.0),), PI / 4)
ALL_ROUND = {
    "isotropic": Law("", "{solid-angle} = 4 pi Omega0", ("solid-angle",), (), 4 * PI),
    "hemisphere": Law("", "{solid-angle} = 2 pi Omega0", ("solid-angle",), (), 2 * PI),
    "projected": Law(
        "", "M = pi Omega0 L", ("projected-solid-angle",), (), PI
    ),
}


def of_conversion(made: Plan, right: float, given: Inputs) -> Chain:
    """The chain of a conversion: its value is the source's times the factors of the conditions."""
    values: dict[str, float] = {n: one.value for n, one in given.items() if type(one.value) is float}
    steps: Steps = []
    powers: list[tuple[str, float]] = []
    for factor, sign in made.links:
        powers += [(name, sign * power) for name, power in _condition(factor, given, values, steps)]
    start, end = read(made.source), read(made.target)
    if start and end and start.kind != end.kind:
        powers += links(start.kind, end.kind, given, values, steps)
    values["value"] = right
    whole = Law("", "", ("value", *(name for name, _ in powers)), tuple(powers))
    before = 1.0
    for name, power in powers:
        before *= values[name] ** power
    whole = whole._replace(constant=right / before if before else 1.0)
    return Chain(values, [*steps, (whole, "value")], "value", right)


def _condition(
    factor: Factor, given: Inputs, values: dict[str, float], steps: Steps
) -> list[tuple[str, float]]:
    """The symbols of a factor but for the link of kinds; their values and laws are added."""
    letter, size = factor.letter, float(factor.value)
    name = LETTERS.get(letter, "")
    if name:
        values[name] = size
    if letter in ("t", "B"):
        return [(name, 1.0)]
    if letter == "A":
        radius = values.get("radius") or values.get("diameter", 0.0) / 2
        if radius:
            values["radius"] = radius
            steps.append((CIRCLE, "area"))
        return [(name, 1.0)]
    if letter in ("Omega", "Omega_p"):
        steps += _cone(letter, given, values)
        return [(name, 1.0)]
    if letter == "q":
        values["cosine"] = size * values["distance"] ** 2
        values["q"] = size
        steps.append((INVERSE_SQUARE, "q"))
        return [("q", 1.0)]
    if letter == "r":
        values["r"] = size
        steps.append((REFLECTOR, "r"))
        return [("r", 1.0)]
    if letter == "p":
        values["p"], values["pupil"] = size, values["pupil"] / 1e-3
        steps.append((PUPIL, "p"))
        return [("p", 1.0)]
    if letter == "J" and "wavelength" in given:
        wave = float(spectral.light(given["wavelength"], None).vacuum)
        for power in (2.0, -2.0):
            rest = size / wave**power
            if abs(math.log(rest * LIGHT**(power / 2))) < 1e-6 or abs(math.log(rest)) < 1e-6:
                values["wavelength"] = wave
                forms = {2.0: "J = {wavelength}^2 / c", -2.0: "J = c / {wavelength}^2"}
                law = Law("", forms[power], ("J", "wavelength"), (("wavelength", power),), rest)
                steps.append((law, "J"))
        values["J"] = size
        return [("J", 1.0)]
    return []


LETTERS = {
    "t": "time",
    "B": "bandwidth",
    "A": "area",
    "Omega": "solid-angle",
    "Omega_p": "projected-solid-angle",
}


def _cone(letter: str, given: Inputs, values: dict[str, float]) -> Steps:
    """The laws of a solid angle, with the values of their symbols."""
    if "apex-angle" in given:
        values["half-angle"] = values["apex-angle"] / 2
    if "beam-angle" in given:
        values["exponent"] = BEAM_ANGLE.solve("exponent", values.__getitem__)
        return [(BEAM_ANGLE, "exponent"), (LOBE, "solid-angle")]
    if "exponent" in given:
        return [(LOBE, "solid-angle")]
    if "half-angle" in values:
        if letter == "Omega":
            return [(CONE, "solid-angle")]
        return [(PROJECTED_CONE, "projected-solid-angle")]
    if "hemisphere" in given and letter == "Omega_p":
        return [(ALL_ROUND["projected"], "projected-solid-angle")]
    if "isotropic" in given or "hemisphere" in given:
        return [(ALL_ROUND["isotropic" if "isotropic" in given else "hemisphere"], "solid-angle")]
    if "distance" in values and letter == "Omega_p":
        values["radius"] = values.get("radius") or values["diameter"] / 2
        values["cosine"] = values["projected-solid-angle"] / disc_on_axis("distance").solve("projected-solid-angle", values.__getitem__)
        return [(disc_on_axis("distance"), "projected-solid-angle")] if values["cosine"] == 1 else []
    return []
