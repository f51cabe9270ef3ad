"""The derivation of a conversion as a chain of laws, one for each factor of its conditions.

A letter in a formula that is not a symbol of the law is a light quantity.
"""

import math

from radcalc.conversion import spectral
from radcalc.conversion.conditions import Factor
from radcalc.conversion.linear import Plan
from radcalc.conversion.natural import LawPlan
from radcalc.derivation import format_number, with_unit
from radcalc.homework.chain import (
    VALUE,
    Chain,
    Ends,
    Powers,
    Steps,
    between_kinds,
    multiply,
    of_laws,
)
from radcalc.inputs.given import Inputs
from radcalc.laws.common import APEX, CIRCLE, CONE, DIAMETER, PROJECTED_CONE
from radcalc.laws.law import Law, law
from radcalc.laws.point import BEAM_ANGLE, LOBE
from radcalc.laws.surface import disc_on_axis
from radcalc.quantities.light import read, symbol_of


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
    name = SYMBOL_OF.get(letter, letter)
    for earlier_law, target in BEFORE.get(letter, ()):
        if target not in values and values.keys() >= set(earlier_law.names) - {target}:
            values[target] = float(earlier_law.solve(target, values.__getitem__))
            steps.append((earlier_law, target))
    candidates = [
        candidate for (by, of), candidate in ALL_ROUND.items() if of == letter and by in given
    ]
    factor_law = next(
        (candidate for candidate in candidates if math.isclose(candidate.constant, size)), None
    )
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
    elif letter == "J" and "wavelength" in given:
        values["wavelength"] = float(spectral.light(given["wavelength"], None).vacuum)
        is_from_length = factor.unit.startswith("m/")
        formula = "J = {wavelength}^2 / c" if is_from_length else "J = c / {wavelength}^2"
        power = 2.0 if is_from_length else -2.0
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
