"""Laws as data.

A `Law` is a monomial: result = constant * product of symbols to their powers, which any of its
symbols can be had from.  A `Relation` is what is no monomial: a function for each symbol it can
be solved for.  All values are in coherent SI units, floats or arrays.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from radcalc.derivation import Formula
from radcalc.errors import ConditionError
from radcalc.maths import any_true

At = Callable[[str], Any]  # gives the value of a symbol


class Law(NamedTuple):
    """A monomial law: the first of the `names` = `constant` * product of the `powers`.

    `template` is the formula with {names} in it; `unit` that of the constant, in which Omega0,
    one photon and one cycle are written out.
    """

    name: str
    template: str
    names: tuple[str, ...]
    powers: tuple[tuple[str, float], ...]
    constant: float = 1.0
    unit: str = "1"
    reference: str = ""

    @property
    def result(self) -> str:
        """The symbol on the left."""
        return self.names[0]

    @property
    def targets(self) -> tuple[str, ...]:
        """The symbols that it can be solved for."""
        return self.names

    @property
    def formula(self) -> Formula:
        """How it is written in a derivation."""
        return Formula(self.name, self.template, self.reference)

    def solve(self, target: str, at: At) -> Any:
        """The target, from a function that gives every other symbol's value."""
        product, power = self.constant, 1.0
        for name, exponent in self.powers:
            if name == target:
                power = exponent
            elif exponent == -1:
                product = product / at(name)
            else:
                product = product * at(name) ** exponent
        if target == self.names[0]:
            return product
        result = at(self.names[0])
        if any_true(product == 0) or (power < 0 and any_true(result == 0)):
            raise ConditionError(
                f"no light arrives, so no {target.replace('-', ' ')} follows from it",
                "a receiver in the light",
            )
        quotient = result / product
        return quotient if power == 1 else quotient ** (1 / power)


def law(
    name: str, template: str, reference: str = "", constant: float = 1.0, unit: str = "1"
) -> Law:
    """A monomial law, read from its formula: `{flux} = 4 pi Omega0 {intensity}`.

    Factors stand beside each other, with a power behind ^; a solidus goes with the factor or the
    bracket behind it.  Numbers, pi and Omega0 (1 sr) are read; `constant` and its `unit` are what
    the other letters of the formula stand for.
    """
    result, _, right = template.partition(" = ")
    powers: list[tuple[str, float]] = []
    steradians, sign, is_in_bracket = 0, 1, False
    for word in right.replace("(", "( ").replace(")", " )").split():
        factor, _, power = word.partition("^")
        exponent = sign * float(power or 1)
        if factor.startswith("{"):
            powers.append((factor.strip("{}"), exponent))
        elif factor == "Omega0":
            steradians += sign
        elif factor == "pi" or factor[0].isdigit():
            constant *= (math.pi if factor == "pi" else float(factor)) ** exponent
        is_in_bracket = word == "(" or (is_in_bracket and word != ")")
        sign = -1 if word == "/" or (sign < 0 and is_in_bracket) else 1
    if steradians:
        unit = "sr" if steradians > 0 else "1/sr"
    names = (result.strip("{}"), *(symbol for symbol, _ in powers))
    return Law(name, template, names, tuple(powers), constant, unit, reference)


class Relation(NamedTuple):
    """A law that is no monomial: a function of the other values for each target."""

    name: str
    template: str
    names: tuple[str, ...]
    solvers: dict[str, Callable[[At], Any]]
    reference: str = ""

    @property
    def targets(self) -> tuple[str, ...]:
        """The symbols that it can be solved for."""
        return tuple(self.solvers)

    @property
    def formula(self) -> Formula:
        """How it is written in a derivation."""
        return Formula(self.name, self.template, self.reference)

    def solve(self, target: str, at: At) -> Any:
        """The target, from a function that gives every other symbol's value."""
        return self.solvers[target](at)


def relation(
    name: str, template: str, solvers: dict[str, Callable[[At], Any]], reference: str = ""
) -> Relation:
    """A relation between the symbols of its formula, with a solver for some or all of them."""
    names = [part.partition("}")[0] for part in template.split("{")[1:]]
    return Relation(name, template, tuple(dict.fromkeys(names)), solvers, reference)


AnyLaw = Law | Relation
HOWELL = "J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors"
