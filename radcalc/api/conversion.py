"""Conversion from one unit or quantity to another."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from radcalc.answer import ShownInput
from radcalc.api import arguments
from radcalc.api.arguments import Quantity, in_words, keyword
from radcalc.api.columns import Number, is_spectrum, of_conversion, take_columns, with_unit
from radcalc.api.functions import of_page
from radcalc.api.result import Result, Undrawn
from radcalc.conversion import Plan
from radcalc.conversion.plan import plan, source_of, target_of
from radcalc.conversion.plan import result_of_plan as answer_of
from radcalc.errors import ConditionError, ConversionError, NumberError, option, quote
from radcalc.floats import INFINITE
from radcalc.inputs import Input, any_uncertain, refuse_uncertain, shown_inputs
from radcalc.maths import LARGEST, any_true, frozen, is_array, is_column, is_uncertain
from radcalc.quantities import describe, result_name
from radcalc.units import Unit, unit_behind
from radcalc.units.numbers import Amount as ReadAmount
from radcalc.units.ranges import real
from radcalc.units.reading import read_amount, read_for
from radcalc.units.registry import light_registry
from radcalc.units.table import resolve
from radcalc.units.values import resolve_any

FINITE = "finite numbers, or NaN for a missing one"
ONE_EACH = "one value of each, or without the uncertainty"
WITH_UNIT = 'radcalc.Quantity(numbers, "lx")'


@of_page("convert")
def convert(value: Number, target: str, to: str | None = None, **conditions: Any) -> Quantity:
    """Convert a quantity to another unit, or to another quantity under conditions.

    Parameters
    ----------
    value : Number
        A text such as ``"100 lx"``, a `radcalc.Quantity`, whose magnitude may be an array of any
        shape, Dask's too, or a number of the `uncertainties` package; a list of texts, or a column
        with its unit.  A bare number is dimensionless.
    target : str
        The unit of the result, a quantity (``"ppfd"``: its usual unit), or a scale (``"dBm"``).
    to : str, optional
        The unit of the result, after that of a value without a unit: ``convert(500, "lx", "fc")``.

    Returns
    -------
    Quantity
        In the unit `target`, with the shape of the magnitude of `value` (broadcast with those
        of the conditions).  On a scale, the bare readings (a float or an array), which cannot be
        multiplied like a quantity.  An uncertain input gives a correlated uncertain magnitude,
        and a column gives a column.

    Raises
    ------
    radcalc.RadcalcError
        If a unit is unknown, or a condition is missing, out of range, contradictory or unused.

    Examples
    --------
    >>> print(convert("800 lm", "cd", half_angle="60deg").round(3))
    254.648 candela
    >>> print(convert(500, "lx", "fc").round(3))
    46.452 footcandle
    >>> convert("10 mW", "dBm"), str(convert("-30 dBm", "uW"))
    (10.0, '1.0 microwatt')
    """
    if isinstance(value, float) and value != value:
        units = ", ".join(f'"{unit}"' for unit in (target, to) if unit)
        hint = f"radcalc.convert(np.array([np.nan]), {units}), which passes it on"
        raise NumberError("the value is NaN, not a number", hint)
    value, target = _with_unit(value, target, to)
    columns, arrays = take_columns({"value": value, **conditions})
    if columns:
        unit = target_of(target)
        if unit.is_scale and arguments.is_quantity(source := arrays["value"]):
            one = arguments.quantity(1.0, arguments.unit_of(source))
            given_arrays = {name: array for name, array in arrays.items() if name != "value"}
            unit = _plan(one, target, given_arrays)[0].target
        name = keyword(result_name(unit) or "value")
        column: Quantity = of_conversion(columns, convert(target=target, **arrays), unit, name)
        return column
    if any(map(arguments.is_lazy, arrays.values())):
        from radcalc.api.columns import blockwise

        waiting: Quantity = blockwise("convert", _again, {**arrays, "target": target})
        return waiting
    conversion, magnitude, given = _plan(value, target, conditions)
    if _has_uncertainty(magnitude) or any_uncertain(given):
        number = _converted(conversion, magnitude, given).number
    else:
        number = arguments.broadcast(lambda: conversion.apply(magnitude))
    return (
        frozen(number)
        if conversion.target.is_scale
        else arguments.quantity(number, conversion.target)
    )


@of_page("convert")
def explain(value: Number, target: str, to: str | None = None, **conditions: Any) -> Result:
    """Convert like `convert`, and return the assumptions, notes and derivation with the value.

    Parameters
    ----------
    value : Number
        As in `convert`; a single value, not an array.
    target, to : str
        As in `convert`.

    Returns
    -------
    Result
        One value, under the name of its quantity, with `assumptions`, `notes` and `steps`.

    Raises
    ------
    radcalc.RadcalcError
        As in `convert`.

    Examples
    --------
    >>> found = explain("800 lm", "cd", isotropic=True)
    >>> print(found.luminous_intensity.round(3))
    63.662 candela
    >>> found.assumptions
    ('uniform over 4 pi sr (isotropic)',)
    """
    value, target = _with_unit(value, target, to)
    amounts = (value, *(given for name, given in conditions.items() if not is_spectrum(name)))
    if isinstance(value, (list, tuple)) or any(getattr(one, "shape", ()) for one in amounts):
        raise ConditionError("explain takes single values, not arrays", "one of each")
    conversion, magnitude, given = _plan(value, target, conditions)
    for condition in given:
        if is_column(condition.value):
            problem = f"explain takes one value of {option(condition.name)}"
            raise ConditionError(problem, "one of each")
    number = magnitude.typed[0] if isinstance(magnitude, ReadAmount) else magnitude
    number = float(getattr(number, "nominal_value", number))
    answer = answer_of(conversion, number, steps=True)
    if _has_uncertainty(magnitude) or any_uncertain(given):
        from radcalc.calculators.uncertainty import of_conversion

        uncertain = _converted(conversion, magnitude, given)
        answer = of_conversion(answer, uncertain)
        reading = uncertain.number
    else:
        reading = answer.rows[0].value
    inputs = (
        _value_of(value, number, conversion),
        *shown_inputs({condition.name: condition for condition in given}),
    )
    answer = answer._replace(inputs=inputs).spelled(in_words)
    name = keyword(answer.rows[0].name or "value")
    result = (
        reading if conversion.target.is_scale else arguments.quantity(reading, conversion.target)
    )

    def ask() -> Any:
        from radcalc.homework.question import of_conversion

        amount = magnitude if isinstance(magnitude, ReadAmount) else None
        return of_conversion(number, conversion.source, conversion.target, given, True, amount)

    undrawn = Undrawn("a conversion has no picture", "a calculator's, as of radcalc.point_source")
    return Result("convert", lambda: answer, {name: result}, (name,), ask, undrawn)


@of_page("convert")
def factor(source: str, target: str, **conditions: Any) -> float:
    """Return the number that multiplies values in one unit to convert them to another.

    A query engine (Polars, DuckDB, Spark, SQL) then needs only a multiplication.

    Parameters
    ----------
    source, target : str
        The units, or a quantity's name as the target: ``"ppfd"``.

    Returns
    -------
    float
        The factor; exact, and rounded once, between two units of one quantity.  Each condition
        is a single value; `explain` gives the assumptions.

    Raises
    ------
    radcalc.RadcalcError
        As in `convert`; also if the two are not proportional, as with scales, or the factor is
        an array or uncertain.

    Examples
    --------
    >>> factor("klx", "lx"), factor("lx", "umol/m2/s", efficacy="50 lm s/umol")
    (1000.0, 0.02)
    """
    arguments.require_texts(source=source, target=target)
    start = resolve_any(source)
    given = [*arguments.read_inputs(conditions).values()]
    refuse_uncertain(given, "a factor")
    for condition in given:
        if is_column(condition.value):
            problem = f"a factor is one number, and {option(condition.name)} is an array"
            hint = "one value of each, or radcalc.convert, which takes arrays"
            raise ConditionError(problem, hint)
    conversion = plan(start, target_of(target, start), given)
    if not conversion.is_linear:
        problem = f"{quote(source)} and {quote(target)} are linked by a function, not by a factor"
        raise ConversionError(problem, f'radcalc.convert("1 {quote(source)}", "{quote(target)}")')
    return float(conversion.factor)


def _again(given: Mapping[str, Any]) -> Any:
    return convert(**given)


def _with_unit(value: Any, unit: str, to: str | None) -> tuple[Any, str]:
    """Return the value and the target of a call; of three operands the second is a unit."""
    if to is None:
        return value, unit
    arguments.require_texts(unit=unit, to=to)
    start = resolve_any(unit)
    if arguments.is_quantity(value) or (isinstance(value, str) and read_amount(value).unit):
        problem = f"the value '{quote(str(value))}' has a unit, and '{quote(unit)}' is another"
        raise ConversionError(problem, f'radcalc.convert("{quote(str(value))}", "{quote(to)}")')
    if isinstance(value, str) or type(value) in (int, float):
        return f"{value}{unit_behind(unit)}", to
    if start.is_scale:
        problem = f"'{quote(unit)}' is a scale, and the value is not a single number"
        raise ConversionError(problem, "a call for each reading")
    if arguments.library_of(value):
        return with_unit(value, start), to
    if not (hasattr(value, "dtype") or is_uncertain(value)):
        value = real(value, "the value", "real numbers")
    return Quantity(value, light_registry().container(start)), to


def _value_of(value: Any, number: float, conversion: Plan) -> ShownInput:
    if not isinstance(value, str):
        return ShownInput("value", number, conversion.source.text)
    amount = read_for(value, conversion.target.text)
    return ShownInput(
        "value", number, conversion.source.text, amount.text, amount.typed_uncertainty
    )


def _converted(conversion: Plan, magnitude: Any, given: list[Input]) -> Any:
    """Apply a plan to a magnitude if it or a condition is uncertain."""
    from radcalc.calculators.uncertainty import converted

    if isinstance(magnitude, ReadAmount):
        return converted(conversion, magnitude, given)
    amount = ReadAmount("the value", magnitude, conversion.source)
    original = None
    if is_uncertain(magnitude):
        number, size = magnitude.nominal_value, magnitude.std_dev
        amount, original = ReadAmount(str(magnitude), number, conversion.source, size), magnitude
    elif is_array(magnitude):
        raise ConditionError("an array cannot be used with an uncertain condition", ONE_EACH)
    return converted(conversion, amount, given, original)


def _has_uncertainty(magnitude: Any) -> bool:
    return isinstance(magnitude, ReadAmount) or is_uncertain(magnitude)


def _plan(value: Any, target: str, conditions: dict[str, Any]) -> tuple[Plan, Any, list[Input]]:
    """Return the plan, the magnitude to convert, and the conditions.

    The magnitude of a text with an uncertainty is a `ReadAmount`.
    """
    arguments.refuse_lazy(value, "the value")
    arguments.require_texts(target=target)
    magnitude: Any
    source: Unit | None
    given = [*arguments.read_inputs(conditions).values()]
    if isinstance(value, (list, tuple)):
        value = as_array(value)
    if isinstance(value, str):
        amount = read_for(value, target)
        magnitude = amount.exact
        source = source_of(amount, target_of(target, amount.typed[1]), given)
        magnitude = amount if amount.is_uncertain else magnitude
    elif arguments.is_quantity(value):
        magnitude, source = value.magnitude, arguments.unit_of(value)
    else:
        magnitude, source = value, None
    is_one = isinstance(magnitude, (int, float)) and abs(magnitude) < LARGEST
    conversion = _plan_of(source, target, given, f"{magnitude:.12g}" if is_one else "1")
    if is_uncertain(magnitude) and abs(magnitude.nominal_value) == INFINITE:
        raise NumberError("the value is infinite", FINITE)
    if _has_uncertainty(magnitude):
        return conversion, magnitude, given
    kind = getattr(getattr(magnitude, "dtype", None), "kind", "")
    if kind and kind in "iuf":  # the elements of a masked array stay masked
        magnitude = magnitude.astype(float, copy=False)
    elif not isinstance(magnitude, (int, float)) or isinstance(magnitude, bool):
        hint = "real numbers" if arguments.is_quantity(value) else "a text, a quantity or numbers"
        magnitude = real(magnitude, "the value", hint)
    if any_true(abs(magnitude) == INFINITE):
        raise NumberError("the value is infinite", FINITE)
    return conversion, magnitude, given


def _plan_of(source: Unit | None, target: str, given: list[Input], number: str) -> Plan:
    start = source or resolve("1")
    target_unit = target_of(target, start)
    if source is None and target_unit.dimension != start.dimension and not target_unit.is_scale:
        problem = f"the unit of the value is missing: the target is {describe(target_unit)}"
        raise ConversionError(problem, f'a text such as "100 lx", or {WITH_UNIT}')
    return plan(start, target_unit, given, number)


def as_array(value: Sequence[Any]) -> Any:
    """Return a list of texts or quantities as one array in the unit of the first; others as is."""
    if not any(isinstance(element, str) or arguments.is_quantity(element) for element in value):
        return value
    amounts = [read_amount(element) if isinstance(element, str) else None for element in value]
    if any(amount and amount.is_uncertain for amount in amounts) or any(map(is_uncertain, value)):
        raise ConditionError("a list has an uncertain value", ONE_EACH)
    typed = [
        amount.typed
        if amount
        else arguments.plain(element)
        if arguments.is_quantity(element)
        else (element, None)
        for element, amount in zip(value, amounts, strict=True)
    ]
    pairs = [(number, unit or resolve("1")) for number, unit in typed]
    if any(unit.is_scale for _, unit in pairs):
        problem = "a list has readings on a scale"
        raise ConditionError(problem, "one text a call, or what they stand for, in a unit")
    return arguments.quantity(*arguments.together("a list", pairs))
