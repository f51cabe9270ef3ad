"""Laws as data, solved for whatever is missing, and checked against what is given twice.

A `Law` is a monomial: result = constant * product of symbols to their powers, which any of its
symbols can be had from.  A `Relation` is what is no monomial: a function for each symbol it can
be solved for.  All values are in coherent SI units, floats or arrays.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from radcalc.answer import Step
from radcalc.conversion.conditions import degrees, show
from radcalc.errors import ConditionError, NumberError
from radcalc.maths import any_true, is_array
from radcalc.units.grammar import read_number

LOGARITHMIC = {"ev": 0.1, "ev100": 0.1}  # steps, by which marked values differ from exact ones
EXACT = 1e-9  # what rounding in the arithmetic may add
FEWEST_DIGITS = 3  # 2m is meant as 2.00 m


class Known(NamedTuple):
    """A value, how far it may be off as typed (relative), and its text where it was given."""

    value: Any
    rounding: float = 0.0
    text: str = ""


Values = dict[str, Known]


class Law(NamedTuple):
    """A monomial law: `result` = `constant` * product of the `powers`.

    `template` is the formula with {names} in it; `unit` that of the constant, in which Omega0,
    one photon and one cycle are written out.
    """

    name: str
    template: str
    result: str
    powers: tuple[tuple[str, float], ...]
    constant: float = 1.0
    unit: str = "1"
    reference: str = ""

    @property
    def names(self) -> tuple[str, ...]:
        """The symbols that it links."""
        return (self.result, *(name for name, _ in self.powers))

    @property
    def targets(self) -> tuple[str, ...]:
        """The symbols that it can be solved for."""
        return self.names

    def solve(self, target: str, at: Callable[[str], Any]) -> Any:
        """The target, from a function that gives every other symbol's value."""
        product, power = self.constant, 1.0
        for name, exponent in self.powers:
            if name == target:
                power = exponent
            else:
                product = product * at(name) ** exponent
        if target == self.result:
            return product
        result = at(self.result)
        if any_true(product == 0) or (power < 0 and any_true(result == 0)):
            raise ConditionError(
                f"no light arrives, so no {target.replace('-', ' ')} follows from it",
                "a receiver in the light",
            )
        quotient = result / product
        return quotient if power == 1 else quotient ** (1 / power)


class Relation(NamedTuple):
    """A law that is no monomial: a function of the other values for each target."""

    name: str
    template: str
    names: tuple[str, ...]
    solvers: dict[str, Callable[[Callable[[str], Any]], Any]]
    reference: str = ""

    @property
    def targets(self) -> tuple[str, ...]:
        """The symbols that it can be solved for."""
        return tuple(self.solvers)

    def solve(self, target: str, at: Callable[[str], Any]) -> Any:
        """The target, from a function that gives every other symbol's value."""
        return self.solvers[target](at)


AnyLaw = Law | Relation


class Naming(NamedTuple):
    """How a symbol is written: its letter in formulas, and its coherent unit."""

    symbol: str
    unit: str


class Solution(NamedTuple):
    """Every value that follows, and how: the law and the symbol it was solved for."""

    values: Values
    used: list[tuple[AnyLaw, str]]


def rounding(text: str) -> float:
    """How far a number may be off as typed: half a unit of its last digit, relative to it.

    A short number counts as three digits: 2m is meant as 2.00 m.
    """
    number = text[: read_number(text)[1]]
    digits = ""
    for character in number.lstrip("+-"):
        if character in "0123456789":
            digits += character
        elif character != ".":
            break
    digits = digits.lstrip("0")
    if not digits or not {"/", "p", "π"}.isdisjoint(number):
        return EXACT
    digits = digits.ljust(FEWEST_DIGITS, "0")
    return 0.5 / float(digits)


def solve(laws: Sequence[AnyLaw], given: Values) -> Solution:
    """Everything that follows from what is given; what is given twice is checked.

    Each law that lacks one symbol gives it, until no law lacks just one.  A law that lacks none,
    and gave none, is checked to the precision typed.
    """
    values, used, done = dict(given), [], set()
    found = True
    while found:
        found = False
        for k, law in enumerate(laws):
            missing = [name for name in law.names if name not in values]
            if k in done or len(missing) > 1:
                continue
            if not missing:
                _check(law, values, given)
                done.add(k)
            elif missing[0] in law.targets:
                values[missing[0]] = _follow(law, missing[0], values)
                used.append((law, missing[0]))
                done.add(k)
                found = True
    return Solution(values, used)


def _follow(law: AnyLaw, target: str, values: Values) -> Known:
    """The target by the law, with what the roundings of the others make of it."""
    value = law.solve(target, lambda name: values[name].value)
    if is_array(value):
        return Known(value, max(values[name].rounding for name in law.names if name != target))
    if isinstance(value, complex) or value != value or value in (float("inf"), float("-inf")):
        raise NumberError(
            f"the {target.replace('-', ' ')} cannot be held by a number", "less extreme values"
        )
    off = 0.0
    for name in law.names:
        if name != target and values[name].rounding and value:
            off += abs(_moved(law, target, name, values) / value - 1)
    return Known(value, off)


def _moved(law: AnyLaw, target: str, name: str, values: Values) -> float:
    """The target with one symbol moved by its rounding."""
    for sign in (1, -1):
        at = {n: values[n].value for n in law.names if n != target}
        at[name] *= 1 + sign * values[name].rounding
        try:
            found = law.solve(target, at.__getitem__)
        except (ConditionError, ValueError, ZeroDivisionError):
            continue  # past a limit: an incidence typed as 90 deg is not meant as 90.05
        if not isinstance(found, complex):
            return float(found)
    return float(values[target].value) if target in values else float("nan")


def _check(law: AnyLaw, values: Values, given: Values) -> None:
    """Refuse values that contradict each other by a law."""
    names = [name for name in law.targets if name in given] or list(law.targets)
    name = names[0]
    other = _follow(law, name, values)
    value = values[name].value
    allowed = values[name].rounding + other.rounding + EXACT
    difference = abs(value - other.value)
    if any_true(difference > allowed * abs(value) + LOGARITHMIC.get(name, 1e-300)):
        raise Contradiction(law, name, value, other.value)


class Contradiction(ConditionError):
    """Two values of one symbol, by a law; whoever knows the units says it with them."""

    def __init__(self, law: AnyLaw, name: str, given: Any, found: Any) -> None:
        """Keep the values [SI]."""
        super().__init__(f"{name} contradicts the others by the law '{law.name}'", "fewer of them")
        self.law, self.name, self.given, self.found = law, name, given, found


def reached(laws: Sequence[AnyLaw], known: set[str]) -> set[str]:
    """The symbols that follow from those that are known, whatever their values."""
    known, before = set(known), -1
    while before != len(known):
        before = len(known)
        for law in laws:
            missing = [name for name in law.names if name not in known]
            if len(missing) == 1 and missing[0] in law.targets:
                known.add(missing[0])
    return known


def steps(solution: Solution, naming: dict[str, Naming]) -> list[Step]:
    """The derivation: each law in symbols, then in numbers."""
    return [_step(law, target, solution.values, naming) for law, target in solution.used]


def _step(law: AnyLaw, target: str, values: Values, naming: dict[str, Naming]) -> Step:
    symbols = {name: naming[name].symbol for name in law.names}
    numbers = {
        name: symbols[name] if name == target else _number(values[name].value, naming[name].unit)
        for name in law.names
    }
    formula, written = law.template.format(**symbols), law.template.format(**numbers)
    left, _, right = formula.partition(" = ")
    if left == right:  # cos(theta) = cos(theta)
        formula = ""
    found = _number(values[target].value, naming[target].unit).strip("()")
    if written.startswith(f"{symbols[target]} = "):
        text = f"{written} = {found}"
    else:
        text = f"{written}, so {symbols[target]} = {found}"
    return Step(law.name, formula, text, law.reference)


def _number(value: Any, unit: str) -> str:
    if is_array(value):
        return show(value)
    if unit == "rad":
        return degrees(value)
    return show(value) if unit == "1" else f"({show(value)} {unit})"
