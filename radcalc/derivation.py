"""The steps of a derivation: a formula in symbols, then in numbers, and where it comes from."""

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from radcalc.answer import Step
from radcalc.quantities.symbols import SYMBOLS, light_unit
from radcalc.units.dimensions import COHERENT

GREEK = {
    "Φ": "Phi",
    "Δ": "d",
    "Ω": "Omega",
    "α": "alpha",
    "β": "beta",
    "γ": "gamma",
    "θ": "theta",
    "λ": "lambda",
    "ν": "nu",
    "ρ": "rho",
    "σ": "sigma",
    "φ": "phi",
}


def format_number(value: Any) -> str:
    """A number for a derivation; an array by its shape."""
    return f"{value:.6g}" if isinstance(value, (int, float)) else f"array{value.shape}"


def format_angle(angle: Any) -> str:
    """An angle [rad] for a derivation."""
    return f"{format_number(angle * (180 / math.pi))} deg"


def format_value(value: Any, unit: str) -> str:
    """A value in a coherent unit, for a derivation; wavelengths are shown in nanometres."""
    if hasattr(value, "shape"):
        return format_number(value)
    if unit == "rad":
        return format_angle(value)
    if unit == "nm":
        return f"{format_number(value * 1e9)} nm"
    return format_number(value) if unit == "1" else f"{format_number(value)} {unit}"


def letter_of(name: str) -> str:
    """How a formula in ASCII writes a symbol."""
    letter = SYMBOLS[name].letter or name
    for greek, word in GREEK.items():
        letter = letter.replace(greek, word)
    return letter


def coherent_unit_of(name: str, kind: str = "") -> str:
    """The unit in which a derivation shows a symbol; a light quantity is of a kind."""
    symbol = SYMBOLS[name]
    if symbol.geometry:
        return light_unit(symbol.generic, symbol.kind or kind, coherent=True)
    return symbol.unit if symbol.unit == "nm" else COHERENT[symbol.dimensions[0]]


def fill(template: str, write: Callable[[str, bool], str]) -> str:
    """A template with each {name} replaced by `write(name, is_raised)`: whether a power follows."""
    head, *parts = template.split("{")
    text = head
    for part in parts:
        name, _, rest = part.partition("}")
        text += write(name, rest[:1] == "^") + rest
    return text


class Formula(NamedTuple):
    """A formula with {names} of symbols in it, and where it comes from."""

    name: str
    template: str
    reference: str = ""

    @property
    def text(self) -> str:
        """The formula in letters."""
        return fill(self.template, lambda name, _: letter_of(name))

    def step(self, values: Mapping[str, Any], found: str) -> Step:
        """The formula with values [SI] put in, and what was found; other symbols stay letters."""

        def write(name: str, is_raised: bool) -> str:
            if name not in values:
                return letter_of(name)
            text = format_value(values[name], coherent_unit_of(name))
            return f"({text})" if is_raised else text

        numbers = fill(self.template.replace("Omega0", "sr"), write)
        return self.told(f"{numbers} = {found}")

    def told(self, numbers: str) -> Step:
        """The formula, and a sentence where its numbers are too many to be put in."""
        left, _, right = self.text.partition(" = ")
        formula = "" if left == right else self.text  # cos(theta) = cos(theta)
        return Step(self.name, formula, numbers, self.reference)
