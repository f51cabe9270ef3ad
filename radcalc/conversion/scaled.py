"""Conversions from or to a scale, by plain conversions between the values of the readings.

Field strengths and reciprocal temperatures are treated as scales.  An electric field strength is
read as the irradiance of a plane wave in vacuum,

    S = E_rms^2 / Z0 = E_peak^2 / (2 Z0)

where Z0 is the characteristic impedance of vacuum.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Any

from radcalc import errors, maths
from radcalc.answer import Step
from radcalc.conversion import Plan, are_reciprocal, between
from radcalc.conversion.natural import by_law
from radcalc.errors import ConversionError, NumberError, option, quote
from radcalc.inputs import Input
from radcalc.quantities import PER_FREQUENCY, describe, read
from radcalc.quantities.symbols import LINKS
from radcalc.units import (
    FIELD_STRENGTH,
    INVERSE_TEMPERATURE,
    TEMPERATURE_ALONE,
    Unit,
    unit_behind,
)
from radcalc.units.reading import read_amount
from radcalc.units.scale_table import CONSTANTS, IN_AB, Scale, usual
from radcalc.units.values import ScaleUnit, reciprocal, scale_of

IMPEDANCE = 376.730313412  # ohm, CODATA 2022
PEAK, RMS = "peak", "rms"


class ElectricField(Scale):
    """The irradiance of a field: a field of 1 has an irradiance of `size` W/m2."""

    __slots__ = ()

    def of(self, quantity: str) -> str:
        return f"sqrt({'2 ' if self.steps == PER_PEAK else ''}Z0 {quantity})"

    def inverse(self, reading: str = "n") -> str:
        field = "E" if reading == "n" else f"({reading} {quote(self.name)})"
        return f"{self.letter} = {field}^2 / {'(2 Z0)' if self.steps == PER_PEAK else 'Z0'}"

    def quantity(self, reading: Any) -> Any:
        return self.size * reading * reading

    def reading(self, quantity: Any) -> Any:
        return maths.sqrt(quantity / self.size)

    def slope(self, reading: Any) -> Any:
        return 2 * self.size * reading


PER_RMS, PER_PEAK = 1.0, 2.0  # the divisor of Z0


class FieldUnit(ScaleUnit):
    """A unit of field strength whose readings are converted to irradiances; `plain` is the unit."""

    __slots__ = ("plain",)

    def __init__(self, plain: Unit, scale: Scale) -> None:
        super().__init__(plain.text, scale)
        self.plain = plain

    def describe(self, settable: bool = False) -> str:
        scale = self.scale
        return f"{scale.inverse()}, {scale.meaning}, Z0 = {IMPEDANCE:.6g} ohm"

    def quantity(self, reading: Any) -> Any:
        irradiance = self.scale.quantity(reading)
        if maths.any_true((irradiance - irradiance != 0) | ((irradiance == 0) & (reading != 0))):
            field = (
                f"{reading:.12g} {quote(self.text)}" if isinstance(reading, float) else "a field"
            )
            raise NumberError(f"{field} is out of range", "less extreme values")
        return irradiance

    def reading(self, quantity: Any) -> Any:
        if maths.any_true(quantity < 0):
            raise ConversionError("a negative irradiance has no field strength", "0 or more")
        return self.scale.reading(quantity) + 0.0

    def with_constants(self, values: Mapping[str, float]) -> "FieldUnit":
        """Return the same unit: the constants of light meters do not affect fields."""
        return self


JANSKY, PER_NM = (
    "Jy_",
    "flam_",
)  # means of a density over a band, before its suffix; flam in W/m2/nm


def plane_wave(unit: Unit, kind: str) -> FieldUnit:
    """Return a unit of field strength whose readings are irradiances of plane waves."""
    divisor = PER_PEAK if kind == PEAK else PER_RMS
    strength = unit.top / unit.bottom
    row = ElectricField(
        (unit.text,),
        "S",
        "W/m2",
        strength * strength / (divisor * IMPEDANCE),
        10,
        divisor,
        0,
        f"E the {'peak' if kind == PEAK else 'root mean square'} field of a plane wave in vacuum",
        "ISO 80000-6, Poynting vector",
    )
    return FieldUnit(unit, row)


SUM = re.compile(r"(\s*[-+\u2212]\s*)")  # between terms
LOSS = "OD"  # counts losses, while the other ratios count gains


def refuse_difference(text: str, target: Unit) -> None:
    """Raise for 5600 K - 3200 K in mired, whose shift is a difference of reciprocals."""
    if target.dimension not in (TEMPERATURE_ALONE, INVERSE_TEMPERATURE):
        return
    terms = SUM.split(text)
    if len(terms) == 1 or not all(map(_is_temperature, terms[::2])):
        return
    shift = "".join([term if k % 2 else f"1/({term})" for k, term in enumerate(terms)])
    raise errors.ConversionError(
        f"'{quote(text)}' is a sum or a difference, whose reciprocal is not a colour temperature",
        errors.computed(errors.call("convert", shift, "MK-1", remark="the shift")),
    )


def _is_temperature(text: str) -> bool:
    try:
        unit = read_amount(text).unit
    except errors.RadcalcError:
        return False
    return unit is not None and unit.dimension == TEMPERATURE_ALONE


class ScaledPlan(Plan):
    """A plan with a scale as source or target; `linear` is the plan between their units.

    `ends` are the scales, field strengths among them.
    """

    __slots__ = ("ends", "linear")
    is_linear = False

    def __init__(self, source: Unit, target: Unit, linear: Plan) -> None:
        super().__init__(linear.source, linear.target, linear.factor, linear.links)
        self.linear, self.ends = linear, (source, target)
        self.source, self.target = _plain(source), _plain(target)
        scales = [unit for unit in (source, target) if isinstance(unit, ScaleUnit)]
        assumed = {unit.describe(): unit.describe(settable=True) for unit in scales}
        self.notes = tuple(note for note in linear.notes if note not in assumed)
        self.assumptions = (*assumed.values(), *linear.assumptions)

    def quantity(self, value: Any) -> Any:
        return self._in_target_unit(value) if self.target.is_scale else self.apply(value)

    def _in_target_unit(self, value: Any) -> Any:
        source = self.ends[0]
        return self.linear.apply(source.quantity(value) if isinstance(source, ScaleUnit) else value)

    def apply(self, value: Any) -> Any:
        value = float(value) if isinstance(value, float) else value
        quantity, target = self._in_target_unit(value), self.ends[1]
        if not isinstance(target, ScaleUnit):
            return quantity
        _refuse_gain_as_loss(self.source, target, value, quantity)
        return target.reading(quantity)

    def derive(self, value: Any) -> list[Step]:
        """Return the steps from a scale, between the two units, and to a scale."""
        source, target = self.ends
        steps = []
        if isinstance(source, ScaleUnit):
            scale, read = source.scale, source.quantity(value)
            quantity = f"{read:.6g} {source.unit.text}".removesuffix(" 1")
            numbers = f"{scale.inverse(f'{value:.6g}')} = {quantity}"
            steps.append(Step(f"scale {source.text}", scale.inverse(), numbers, scale.source))
            value = read
        if self.linear.links or not self.linear.is_linear or self.linear.factor != 1:
            steps += self.linear.derive(value)
        if isinstance(target, ScaleUnit):
            scale, read = target.scale, self.linear.apply(value)
            formula = scale.formula
            numbers = f"{read:.6g} {target.unit.text}".removesuffix(" 1")
            text = f"n = {scale.of(numbers)} = {target.reading(read):.6g} {target.text}"
            steps.append(Step(f"scale {target.text}", f"n = {formula}", text, scale.source))
        return steps


def _refuse_gain_as_loss(source: Unit, target: ScaleUnit, value: Any, factor: Any) -> None:
    """Raise for 3 stops, 3 dB or 200 % as a negative density: a loss is meant."""
    is_loss = target.scale.name == LOSS and scale_of(source) != target.scale
    if is_loss and maths.any_true(factor > 1):
        name = quote(source.text)
        problem = "{} is more light, but a density above 0 is less"
        if not isinstance(value, float):
            raise errors.ConversionError(problem.format("one of the values"), "at most 100 %")
        typed, part = f"{value:.6g}{unit_behind(name)}", f"{value / factor**2:.6g}"
        words = (f"-{typed}",) if source.is_scale else (part, name)
        loss = errors.call("convert", *words, target.text, remark="a loss")
        raise errors.ConversionError(problem.format(typed), loss)


def plan(source: Unit, target: Unit, given: Sequence[Input], number: str) -> ScaledPlan:
    """Plan a conversion from or to a scale, of a field, or between reciprocals.

    Of several scales with one spelling, the first that the other side and the conditions allow is
    used; a scale of the other side's quantity comes first.
    """
    meter = {condition.name: condition for condition in given if condition.name in CONSTANTS}
    constants = {name: condition.value for name, condition in meter.items()}
    conditions = [condition for condition in given if condition.name not in CONSTANTS]
    if FIELD_STRENGTH in (source.dimension, target.dimension):
        source, target, conditions = _fields(source, target, conditions)
    for name, condition in meter.items():
        if any(usual(name) in note for note in source.notes):  # (10 EV) * 2
            problem = (
                f"{option(name, quote(condition.text))} does not apply to a reading in arithmetic"
            )
            raise errors.ConditionError(problem, "the value in a unit")
    sources, targets = _readings(source, target, constants), _readings(target, source, constants)
    error: errors.RadcalcError | None = None
    pairs = [(start, end) for start in sources for end in targets]
    for start, end in sorted(pairs, key=lambda pair: pair[0].dimension != pair[1].dimension):
        try:
            linear = _between(_unit(start), _unit(end), conditions, number)
        except errors.RadcalcError as problem:
            if error is None or _lacks_less(problem, error):
                error = problem
            continue
        used = {unit.scale.constant for unit in (start, end) if isinstance(unit, ScaleUnit)}
        if idle := [name for name in constants if name not in used]:
            raise errors.Unused(
                idle, f"to the conversion of {quote(source.text)} to {quote(target.text)}"
            )
        planned = ScaledPlan(start, end, linear)
        assumptions = [text for name in constants for text in meter[name].assumptions]
        planned.assumptions = (*assumptions, *planned.assumptions)
        return planned
    assert error is not None
    raise _in_ab(error, source, target)


def _in_ab(error: errors.RadcalcError, source: Unit, target: Unit) -> errors.RadcalcError:
    """Return an error with the density of a band, or AB magnitudes, in the hint of a magnitude."""
    for unit, other in ((source, target), (target, source)):
        facts = read(_unit(other))
        if not (isinstance(unit, ScaleUnit) and facts and facts.axis):
            continue
        if not isinstance(error, errors.MissingCondition):
            continue
        _, is_of_band, band = unit.unit.text.partition(JANSKY)
        prefix, is_jansky, rest = other.text.partition("Jy")
        of_frequency = facts.axis == PER_FREQUENCY
        mean = f"{prefix if is_jansky and not rest else ''}{JANSKY}" if of_frequency else PER_NM
        in_watts = "" if of_frequency else ", in W/m2/nm"
        # A density at a wavelength is not the mean; a typed number keeps its unit.
        if is_of_band and (other is target or is_jansky or other.text == "W/m2/nm"):
            of_band = errors.correct(
                other.text, mean + band, remark=f"the mean over the band{in_watts}"
            )
            return error.reworded(tries=[of_band])
        if ab := IN_AB.get(unit.scale.name):
            change, remark = (unit.text, ab), "if it is an AB magnitude"
            return error.reworded(
                f"cannot convert {describe(source)} to {describe(target)}: {quote(unit.text)} is a "
                "magnitude of the V band, without a zero point per wavelength or frequency",
                [errors.Try((), names, change, remark=remark) for names in ((), LINKS)],
            )
    return error


def _lacks_less(problem: errors.RadcalcError, other: errors.RadcalcError) -> bool:
    """Return whether a reading lacks fewer conditions than another."""
    both = isinstance(problem, errors.MissingCondition) and isinstance(
        other, errors.MissingCondition
    )
    return both and len(problem.missing) < len(other.missing)


def _between(source: Unit, target: Unit, given: list[Input], number: str) -> Plan:
    law_plan = by_law(source, target, given)
    return law_plan or between(source, target, given, number)


def _readings(unit: Unit, other: Unit, constants: dict[str, float]) -> list[Unit]:
    if isinstance(unit, ScaleUnit):
        unit = unit.with_constants(constants)
        return [unit, *unit.others]
    is_inverse = unit.dimension == INVERSE_TEMPERATURE and are_reciprocal(unit, other)
    return [reciprocal(unit) if is_inverse else unit]


def _fields(source: Unit, target: Unit, given: list[Input]) -> tuple[Unit, Unit, list[Input]]:
    """Return the units, with fields as irradiances of plane waves, and the other conditions."""
    kinds = [condition for condition in given if condition.name == "electric-field"]
    if not kinds:
        raise errors.MissingCondition(
            f"cannot convert {describe(source)} to {describe(target)}: the kind of field value "
            "(peak or root mean square) is missing",
            f"{option('electric-field', RMS)} or {option('electric-field', PEAK)}",
            source.text,
            target.text,
            {"the kind of field value": ("electric-field",)},
            [errors.add("electric-field", kind) for kind in (RMS, PEAK)],
        )
    rest = [condition for condition in given if condition.name != "electric-field"]
    return _wave(source, kinds[0]), _wave(target, kinds[0]), rest


def _wave(unit: Unit, kind: Input) -> Unit:
    return plane_wave(unit, kind.text) if unit.dimension == FIELD_STRENGTH else unit


def _plain(unit: Unit) -> Unit:
    return unit.plain if isinstance(unit, FieldUnit) else unit


def _unit(unit: Unit) -> Unit:
    return unit.unit if isinstance(unit, ScaleUnit) else unit
