"""Conversion of a value to another unit or quantity: plans, bridges and factors of conditions.

This module has the plan between two linear units: a factor, exact between units of one quantity.
The errors are imported only when one is raised: that takes a tenth of a conversion.
"""

from radcalc.floats import LARGEST, SMALLEST, divide
from radcalc.units import FIELD_STRENGTH, INVERSE_TEMPERATURE, TEMPERATURE_ALONE, Unit

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from radcalc.answer import Step
    from radcalc.conversion.geometric import Factor
    from radcalc.errors import ConversionError
    from radcalc.inputs import Input


RECIPROCALS = {TEMPERATURE_ALONE, INVERSE_TEMPERATURE}


class Plan:
    """A factor from `source` to `target`, with the assumptions behind it.

    `links` are the (factor, +1 or -1) of the conditions in use; a stream sets `has_negative`.
    """

    __slots__ = ("assumptions", "factor", "has_negative", "links", "notes", "source", "target")
    is_linear = True  # False for a plan between scales

    def __init__(
        self, source: Unit, target: Unit, factor: "Any", links: "Sequence[tuple[Factor, int]]" = ()
    ) -> None:
        self.source = source
        self.target = target
        self.factor = factor
        self.links = links
        self.has_negative = False
        self.assumptions = tuple([f.assumption for f, _ in links if f.assumption])
        self.notes = source.notes + tuple([n for n in target.notes if n not in source.notes])
        for link, _ in links:
            self.notes += link.notes

    def apply(self, value: "Any") -> "Any":
        """Convert a number or an array; a negative value, a difference, only within a quantity."""
        typed = value
        if isinstance(value, (int, float)):
            value = _as_float(value)
            if value != value:
                from radcalc.errors import ConversionError

                raise ConversionError("the value is not a number (nan)", "a finite number")
            if value - value != 0:  # inf
                raise self._not_held()
        if self.links:
            self._check(value)
        if not (isinstance(value, float) and isinstance(self.factor, float)):
            from radcalc.maths import product

            result, lost = product(value, self.factor)
            if lost:
                raise self._not_held()
            return result
        if self.links:
            result = value * self.factor
        else:
            # one rounding of an exact fraction: 100 lx are 1e-05 klm/cm2, not 9.99e-06
            over, under = typed.as_integer_ratio()
            over *= self.source.top * self.target.bottom
            under *= self.source.bottom * self.target.top
            result = divide(over, under)
        zero = value == 0 or self.factor == 0
        if result - result != 0 or (not zero and abs(result) < SMALLEST):
            raise self._not_held()
        return result + 0.0  # 0, not -0

    def quantity(self, value: "Any") -> "Any":
        return self.apply(value)

    def derive(self, value: float) -> "list[Step]":
        return derive(self, value)

    @property
    def result(self) -> tuple[str, str, str]:
        """Return the quantity of the result, its symbol, and its name in `--get`."""
        from radcalc.quantities import name_of, result_name, symbol_of

        return name_of(self.target), symbol_of(self.target), result_name(self.target)

    def _not_held(self) -> "ConversionError":
        from radcalc.errors import ConversionError, quote

        return ConversionError(
            f"the result in {quote(self.target.text)} is out of range",
            "a result between 2.3e-308 and 1.7e308, by another value or unit",
        )

    def _check(self, value: "Any") -> None:
        """Refuse a number that the conditions do not convert."""
        for factor, _ in self.links:
            if factor.check:
                factor.check(value)
        from radcalc.maths import any_true

        if any_true(value < 0):
            from radcalc.errors import ConditionError
            from radcalc.quantities import describe, name_of

            raise ConditionError(
                f"a negative {name_of(self.source)} is a difference, which cannot "
                f"be converted to {describe(self.target)}",
                "0 or more",
            )


def _as_float(value: float) -> float:
    try:
        return float(value)
    except OverflowError:
        from radcalc.errors import NumberError

        raise NumberError("a whole number is too large for a number", "less than 1.8e308") from None


def are_reciprocal(source: Unit, target: Unit) -> bool:
    """Return whether the units are of temperatures and of their reciprocals, such as 1/MK."""
    return {source.dimension, target.dimension} == RECIPROCALS


def is_function(source: Unit, target: Unit) -> bool:
    """Return whether a function, not a factor, leads from one unit to the other (no scales)."""
    dimensions = {source.dimension, target.dimension}
    return dimensions == RECIPROCALS or (FIELD_STRENGTH in dimensions and len(dimensions) > 1)


def between(source: Unit, target: Unit, given: "Sequence[Input]" = (), number: str = "1") -> Plan:
    """Plan a conversion between units that are not scales."""
    same = source.dimension == target.dimension and source.is_exitance == target.is_exitance
    if same and not given:
        plain = Plan(source, target, exact_ratio(source, target))
        if source.is_light and source.has_wavelength != target.has_wavelength:
            from radcalc.errors import quote

            plain.notes += (
                f"{quote(target.text)} and {quote(source.text)} are both read as per wavelength",
            )
        return plain
    from radcalc.conversion.links import link

    links = link(source, target, given, number)
    factor: Any = exact_ratio(source, target)
    for supplied, power in links:
        factor = factor * supplied.value if power > 0 else factor / supplied.value
    if isinstance(factor, float) and factor - factor != 0:
        raise _beyond(source, target)
    planned = Plan(source, target, factor, links)
    planned.assumptions = (
        tuple([text for condition in given for text in condition.assumptions]) + planned.assumptions
    )
    return planned


def exact_ratio(source: Unit, target: Unit) -> float:
    """Return the ratio of two units' factors, exact for whole numbers and rounded once."""
    ratio = divide(source.top * target.bottom, source.bottom * target.top)
    if not SMALLEST <= ratio <= LARGEST:
        raise _beyond(source, target)
    return ratio


def _beyond(source: Unit, target: Unit) -> "ConversionError":
    from radcalc.errors import ConversionError, quote

    return ConversionError(
        f"the ratio of {quote(source.text)} to {quote(target.text)} is out of range",
        "units closer in size",
    )


def derive(made: Plan, value: float) -> "list[Step]":
    """Return the derivation: the steps of every condition, then the conversion, in SI units."""
    from radcalc.answer import Step
    from radcalc.quantities import coherent_unit, symbol_of

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
        over += f" {sign} {factor.value:.6g} {factor.unit}".rstrip()
    numbers = f"{over} = {made.apply(value) * target.factor:.6g} {wanted}"
    if (target.top, target.text) != (target.bottom, wanted):
        numbers += f" = {result}"
    return [*steps, Step("conversion", formula, numbers)]
