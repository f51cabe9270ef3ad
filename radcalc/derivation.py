"""The steps of a derivation: a formula in symbols, then in numbers, with its source."""

import math
from collections.abc import Callable, Mapping
from typing import Any

from radcalc.answer import Step
from radcalc.maths import is_array
from radcalc.quantities.symbols import SYMBOLS, light_unit
from radcalc.tuples import NamedTuple
from radcalc.units.dimensions import COHERENT
from radcalc.units.unit import unit_behind

# Units of derivations that are not coherent, and their number in one coherent unit.
CUSTOMARY = {"nm": 1e9, "THz": 1e-12, "cm-1": 0.01, "mrad": 1e3}
ASCII = {
    "2α": "2 alpha",
    "∫": "int ",
    "²": "^2",
    "π": "pi",
    "ψ": "psi",
    "Φ": "Phi",
    "Δ": "d",
    "Ω": "Omega",
    "α": "alpha",
    "ε": "epsilon",
    "η": "eta",
    "β": "beta",
    "γ": "gamma",
    "θ": "theta",
    "λ": "lambda",
    "ν": "nu",
    "ρ": "rho",
    "σ": "sigma",
    "τ": "tau",
    "φ": "phi",
}


DIGITS, MOST_DIGITS = 6, 17


def format_number(value: Any, digits: int = DIGITS) -> str:
    """Return a number for a derivation or a message; for an array, its least and greatest."""
    if not isinstance(value, (int, float)) and is_array(value):
        if not value.size:
            return "no numbers"
        low, high = (format_number(float(end), digits) for end in (value.min(), value.max()))
        return low if low == high else f"{low} to {high}"
    return f"{value + 0.0:.{digits}g}"  # no -0


def digits_apart(first: Any, second: Any) -> int:
    """Return how many digits distinguish two numbers, and their ratio from 1."""
    digits = DIGITS
    if isinstance(first, float) and isinstance(second, float) and first != second:
        while abs(first - second) < 10.0 ** (1 - digits) * abs(first) and digits < MOST_DIGITS:
            digits += 1
    return digits


def format_angle(angle: Any, digits: int = DIGITS) -> str:
    """Return an angle [rad] for a derivation, in degrees."""
    return f"{format_number(angle * (180 / math.pi), digits)} deg"


def format_value(value: Any, unit: str, digits: int = DIGITS) -> str:
    """Return a value in a coherent unit, for a derivation."""
    if unit == "rad":
        return format_angle(value, digits)
    if unit in CUSTOMARY:
        return f"{format_number(value * CUSTOMARY[unit], digits)} {unit}"
    return with_unit(format_number(value, digits), unit)


def with_unit(number: str, unit: str) -> str:
    """Return a number with its unit, if it has one."""
    return number + unit_behind(unit)


def letter_of(name: str) -> str:
    """Return the letter of a symbol in ASCII formulas."""
    return in_ascii(SYMBOLS[name].letter or name)


def in_ascii(letter: str) -> str:
    """Return a letter with Greek letters and signs spelled in ASCII."""
    for sign, word in ASCII.items():
        letter = letter.replace(sign, word)
    return letter


def coherent_unit_of(name: str, kind: str = "") -> str:
    """Return the unit of a symbol in derivations; for a light quantity, of a kind."""
    symbol = SYMBOLS[name]
    if symbol.geometry:
        return light_unit(symbol.generic, symbol.kind or kind, coherent=True)
    return symbol.unit if symbol.unit in CUSTOMARY else COHERENT[symbol.dimensions[0]]


def fill(template: str, write: Callable[[str, bool], str]) -> str:
    """Return a template with each {name} replaced by `write(name, is_factor)`.

    A factor, raised to a power or followed by another factor, needs brackets if it has a unit.
    """
    head, *parts = template.split("{")
    text = head
    for part in parts:
        name, _, rest = part.partition("}")
        is_factor = rest[:1] == "^" or (rest[:1] == " " and rest[1:2] not in FOLLOWING)
        text += write(name, is_factor) + rest
    return text


FOLLOWING = tuple("/+-*=),")  # characters after a value that is not a factor, or the last one


class Formula(NamedTuple):
    """A formula with {names} of symbols, and its source."""

    name: str
    template: str
    reference: str = ""

    @property
    def text(self) -> str:
        """The formula in letters."""
        return fill(self.template, lambda name, _: letter_of(name))

    def step(self, values: Mapping[str, Any], result: str, kind: str = "") -> Step:
        """Return the formula with values [SI] and a result; symbols without values stay letters.

        `kind` is the kind of light quantities.
        """

        def write(name: str, is_factor: bool) -> str:
            if name not in values:
                return letter_of(name)
            text = format_value(values[name], coherent_unit_of(name, kind))
            return f"({text})" if is_factor and not text.endswith(" deg") else text

        body = self.template.partition(", ")[0]  # a remark may follow a comma
        numbers = fill(body.replace("Omega0", "sr"), write)
        return self.with_numbers(f"{numbers} = {result}")

    def with_numbers(self, numbers: str) -> Step:
        """Return the formula with a text of its numbers."""
        left, _, right = self.text.partition(" = ")
        formula = "" if left == right else self.text  # cos(theta) = cos(theta)
        return Step(self.name, formula, numbers, self.reference)
