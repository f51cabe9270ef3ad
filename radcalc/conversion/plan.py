"""Converting: a plan from one unit to another, and applying it to a number or an array.

A plan between two units of one quantity is a ratio of whole numbers, and needs nothing but the
table; what stands between different quantities is in `bridges.py`, loaded only when it is needed.
"""

from radcalc.errors import ConversionError, quote
from radcalc.units.numbers import SMALLEST
from radcalc.units.table import Unit, divide

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from radcalc.answer import Result, Step
    from radcalc.conversion.conditions import Factor
    from radcalc.given import Given


LARGEST = 1.7976931348623157e308


class Plan:
    """A factor from `source` to `target`, with what was assumed on the way.

    `links` are the (factor, +1 or -1) of the conditions that were used.
    """

    __slots__ = ("assumptions", "factor", "links", "notes", "source", "target")

    def __init__(
        self,
        source: Unit,
        target: Unit,
        factor: "Any",
        links: "Sequence[tuple[Factor, int]]" = (),
    ) -> None:
        """Hold the plan; the notes are those of the units and of the conditions."""
        self.source = source
        self.target = target
        self.factor = factor
        self.links = links
        self.assumptions = tuple([f.assumption for f, _ in links if f.assumption])
        self.notes = source.notes + tuple([n for n in target.notes if n not in source.notes])
        for link, _ in links:
            self.notes += link.notes

    def apply(self, value: "Any") -> "Any":
        """Convert a number, or an array element by element."""
        if isinstance(value, float) and not self.links:
            # one rounding of an exact fraction: 100 lx are 1e-05 klm/cm2, no 9.99e-06
            over, under = value.as_integer_ratio()
            over *= self.source.top * self.target.bottom
            under *= self.source.bottom * self.target.top
            result = divide(over, under)
        else:
            result = value * self.factor
        if isinstance(result, float):
            zero = value == 0 or self.factor == 0
            if result - result != 0 or (not zero and abs(result) < SMALLEST):
                raise ConversionError(
                    f"the result in {quote(self.target.text)} cannot be held by a number",
                    "a value between 2.3e-308 and 1.7e308",
                )
            return result + 0.0  # no -0
        return result


def plan(source: Unit, target: Unit, given: "Sequence[Given]" = ()) -> Plan:
    """Plan the conversion from one unit to another under the conditions given.

    Raises ConversionError where a condition is missing, ConditionError where one is
    impossible, contradictory or without use.
    """
    if source.dimension == target.dimension and not given:
        plain = Plan(source, target, exact_ratio(source, target))
        if source.is_light and source.has_wavelength != target.has_wavelength:
            plain.notes += (
                f"{quote(target.text)} and {quote(source.text)} are both read as per wavelength",
            )
        return plain
    from radcalc.conversion.bridges import link

    links = link(source, target, given)
    factor: Any = exact_ratio(source, target)
    for supplied, power in links:
        factor = factor * supplied.value if power > 0 else factor / supplied.value
    if isinstance(factor, float) and factor - factor != 0:
        raise _beyond(source, target)
    return Plan(source, target, factor, links)


def exact_ratio(source: Unit, target: Unit) -> float:
    """The ratio of two units' factors, rounded once; a division of whole numbers is exact."""
    ratio = divide(source.top * target.bottom, source.bottom * target.top)
    if not SMALLEST <= ratio <= LARGEST:
        raise _beyond(source, target)
    return ratio


def _beyond(source: Unit, target: Unit) -> ConversionError:
    return ConversionError(
        f"the ratio of {quote(source.text)} to {quote(target.text)} cannot be held by a number",
        "units closer in size",
    )


def answer(made: Plan, value: float, case: str = "", steps: bool = False) -> "Result":
    """Convert one value and say everything about it."""
    from radcalc.answer import Result, Row
    from radcalc.quantities.light import name_of, symbol_of

    unit = made.target
    row = Row(name_of(unit), symbol_of(unit), made.apply(value), unit.text, case)
    derivation = tuple(derive(made, value)) if steps else ()
    return Result((row,), made.assumptions, made.notes, derivation)


def derive(made: Plan, value: float) -> "list[Step]":
    """The derivation: the steps of every condition, then the conversion, in SI units."""
    from radcalc.answer import Step
    from radcalc.quantities.light import coherent_unit, symbol_of

    source, target = made.source, made.target
    result = f"{made.apply(value):.6g} {target.text}"
    if not made.links:
        ratio = f"{made.factor:.12g} {target.text}"
        numbers = f"{value:.6g} {source.text} * {ratio}/({source.text}) = {result}"
        return [Step("change of unit", f"1 {source.text} = {ratio}", numbers)]
    steps = [step for factor, _ in made.links for step in factor.steps]
    given, wanted = coherent_unit(source), coherent_unit(target)
    formula = f"{symbol_of(target) or 'y'} = {symbol_of(source) or 'x'}"
    over = f"{value * source.factor:.6g} {given}"
    if (source.top, source.text) != (source.bottom, given):
        steps.append(Step("SI units", "", f"{value:.6g} {source.text} = {over}"))
    for factor, power in made.links:
        sign = "*" if power > 0 else "/"
        formula += f" {sign} {factor.letter}"
        over += f" {sign} {factor.value:.6g} {factor.unit}"
    numbers = f"{over} = {made.apply(value) * target.factor:.6g} {wanted}"
    if (target.top, target.text) != (target.bottom, wanted):
        numbers += f" = {result}"
    return [*steps, Step("conversion", formula, numbers)]
