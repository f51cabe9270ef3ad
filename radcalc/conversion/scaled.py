"""Conversions from a scale or to one: plain ones between what the readings stand for."""

from collections.abc import Sequence
from typing import Any

from radcalc.answer import Step
from radcalc.conversion.plan import Plan, are_reciprocal, between
from radcalc.errors import ConversionError, RadcalcError, Unused, quote
from radcalc.given import Given
from radcalc.units.scales import CONSTANTS, ScaleUnit, reciprocal
from radcalc.units.table import INVERSE_TEMPERATURE, Unit

LOSS = "OD"  # which counts what is lost, where the other ratios count what is gained


class ScaledPlan(Plan):
    """A plan whose source or target is a scale; `linear` is the one between their units."""

    __slots__ = ("linear",)
    is_linear = False

    def __init__(self, source: Unit, target: Unit, linear: Plan) -> None:
        """Hold the plan; how the scales are read is assumed."""
        super().__init__(linear.source, linear.target, linear.factor, linear.links)
        self.notes = linear.notes
        self.linear, self.source, self.target = linear, source, target
        read = [one.told(settable=True) for one in (source, target) if isinstance(one, ScaleUnit)]
        self.assumptions = (*dict.fromkeys(read), *linear.assumptions)

    def quantity(self, value: Any) -> Any:
        """The result as a quantity, in the unit of the target's scale."""
        source = self.source
        return self.linear.apply(source.quantity(value) if isinstance(source, ScaleUnit) else value)

    def apply(self, value: Any) -> Any:
        """Convert a number of the source's, a reading where it is a scale."""
        found, target = self.quantity(value), self.target
        if not isinstance(target, ScaleUnit):
            return found
        _refuse_gain_as_loss(self.source, target, value, found)
        return target.reading(found)

    def derive(self, value: Any) -> list[Step]:
        """The steps: the functions of the scales around those of the units."""
        source, target = self.source, self.target
        steps = []
        if isinstance(source, ScaleUnit):
            scale, read = source.scale, source.quantity(value)
            found = f"{read:.6g} {source.unit.text}".removesuffix(" 1")
            numbers = f"{scale.inverse(f'{value:.6g}')} = {found}"
            steps.append(Step(f"scale {source.text}", scale.inverse(), numbers, scale.source))
            value = read
        if self.linear.links or self.linear.factor != 1:
            steps += self.linear.derive(value)
        if isinstance(target, ScaleUnit):
            scale, read = target.scale, self.linear.apply(value)
            formula = scale.formula
            numbers = f"{read:.6g} {target.unit.text}".removesuffix(" 1")
            text = f"n = {scale.of(numbers)} = {target.reading(read):.6g} {target.text}"
            steps.append(Step(f"scale {target.text}", f"n = {formula}", text, scale.source))
        return steps


def _refuse_gain_as_loss(source: Unit, target: ScaleUnit, value: Any, found: Any) -> None:
    """Refuse 3 stops or 3 dB as a density below 0: who says so means a loss."""
    if target.scale.name == LOSS and isinstance(source, ScaleUnit) and source.scale != target.scale:
        from radcalc.maths import any_true

        if any_true(found > 1):
            told = quote(source.text)
            raise ConversionError(
                f"{value:.6g} {told} is more light, and a density above 0 is less",
                f"-{value:.6g} {told}, for a loss",
            )


def plan(source: Unit, target: Unit, given: Sequence[Given], number: str) -> ScaledPlan:
    """Plan a conversion from a scale or to one, or between temperatures and their reciprocals.

    Of a scale with several readings the first is taken that the other side, and the conditions,
    leave possible; what measures the same comes first.
    """
    meter = {one.name: one for one in given if one.name in CONSTANTS}
    constants = {name: one.value for name, one in meter.items()}
    others = [one for one in given if one.name not in CONSTANTS]
    sources, targets = _readings(source, target, constants), _readings(target, source, constants)
    error: RadcalcError | None = None
    pairs = [(one, other) for one in sources for other in targets]
    for one, other in sorted(pairs, key=lambda pair: pair[0].dimension != pair[1].dimension):
        try:
            linear = between(_unit(one), _unit(other), others, number)
        except RadcalcError as problem:
            error = error or problem
            continue
        used = {end.scale.constant for end in (one, other) if isinstance(end, ScaleUnit)}
        if idle := [name for name in constants if name not in used]:
            raise Unused(idle, f"from {quote(source.text)} to {quote(target.text)}")
        made = ScaledPlan(one, other, linear)
        told = [text for name in constants for text in meter[name].assumptions]
        made.assumptions = (*told, *made.assumptions)
        return made
    assert error is not None
    raise error


def _readings(unit: Unit, other: Unit, constants: dict[str, float]) -> list[Unit]:
    if isinstance(unit, ScaleUnit):
        unit = unit.with_constants(constants)
        return [unit, *unit.others]
    is_inverse = unit.dimension == INVERSE_TEMPERATURE and are_reciprocal(unit, other)
    return [reciprocal(unit) if is_inverse else unit]


def _unit(unit: Unit) -> Unit:
    return unit.unit if isinstance(unit, ScaleUnit) else unit
