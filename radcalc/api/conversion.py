"""From one unit or quantity to another."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from radcalc.answer import Input
from radcalc.api.columns import of_conversion, taken
from radcalc.api.keywords import Amount, ElectricField, Number, Observer, Text
from radcalc.api.quantity import Quantity, is_lazy, is_quantity, plain, quantity, unit_of
from radcalc.api.reading import broadcast, is_absent, read_keyword, refuse_lazy, together
from radcalc.api.result import Result, Undrawn
from radcalc.api.spelling import in_python, in_words, keyword
from radcalc.conversion.conditions import CONDITIONS
from radcalc.conversion.plan import Plan, plan, target_of
from radcalc.conversion.plan import answer as answer_of
from radcalc.errors import ConditionError, ConversionError, UnitError, option, quote
from radcalc.given import Given, any_uncertain, inputs_of, refuse_uncertain
from radcalc.maths import is_array, is_column, is_uncertain
from radcalc.quantities.light import describe, result_name
from radcalc.quantities.symbols import article
from radcalc.units.amounts import Amount as ReadAmount
from radcalc.units.amounts import read_amount
from radcalc.units.ranges import real
from radcalc.units.scales import resolve_any
from radcalc.units.table import Unit, resolve

ONE_EACH = "one value of each, or without the uncertainty"
WITH_UNIT = 'radcalc.Quantity(numbers, "lx")'


def convert(
    value: Number,
    target: str,
    *,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
    solid_angle: Amount = None,
    half_angle: Amount = None,
    apex_angle: Amount = None,
    isotropic: bool = False,
    hemisphere: bool = False,
    exponent: Number = None,
    beam_angle: Amount = None,
    distance: Amount = None,
    incidence: Amount = None,
    tilt: Amount = None,
    area: Amount = None,
    radius: Amount = None,
    diameter: Amount = None,
    reflectance: Number = None,
    pupil: Amount = None,
    responsivity: Amount = None,
    electric_field: ElectricField | None = None,
    k: Amount = None,
    c: Amount = None,
    time: Amount = None,
    bandwidth: Amount = None,
) -> Quantity:
    """Convert a quantity to another unit, or to another quantity under conditions.

    Parameters
    ----------
    value : Number
        A text such as ``"100 lx"``, a `radcalc.Quantity`, whose magnitude may be an array of any
        shape, Dask's too, or a number of the `uncertainties` package; a list of texts, or a column
        that tells its unit.  A bare number is dimensionless.
    target : str
        The unit of the result, a quantity (``"ppfd"``: its usual unit), or a scale (``"dBm"``).
    wavelength : Amount, optional
        Light of one wavelength (or frequency, wavenumber, photon energy). [nm]
    spectrum : Text, optional
        Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...
    efficacy : Amount, optional
        A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol. [lm/W]
    observer : Observer, optional
        Whose eyes see `wavelength` or `spectrum`.
    range : Text, optional
        Where the watts of `spectrum` are counted.
    photon_range : Text, optional
        Where the photons of `spectrum` are counted (default 400nm:700nm).
    solid_angle : Amount, optional
        Uniform over that solid angle. [sr]
    half_angle : Amount, optional
        Uniform over the cone of that half angle, from axis to edge. [deg]
    apex_angle : Amount, optional
        Uniform over the cone of that full angle, from edge to edge. [deg]
    isotropic : bool, optional
        Uniform in all directions, over 4 pi sr.
    hemisphere : bool, optional
        Uniform over a hemisphere.
    exponent : Number, optional
        A lobe that falls off as a power of the cosine; 1 is Lambertian.
    beam_angle : Amount, optional
        A cosine-power lobe of that full angle at half the peak intensity. [deg]
    distance : Amount, optional
        Straight line from a small source to the receiver. [m]
    incidence : Amount, optional
        Angle between the light and the normal of the surface that is lit. [deg]
    tilt : Amount, optional
        Angle between the normal of a surface and the way its light takes. [deg]
    area : Amount, optional
        Uniform over that area. [m2]
    radius : Amount, optional
        Radius of a circular area. [m]
    diameter : Amount, optional
        Diameter of a circular area. [m]
    reflectance : Number, optional
        A Lambertian reflector, 0 to 1 or in %.
    pupil : Amount, optional
        Diameter of the eye's pupil. [m]
    responsivity : Amount, optional
        Current that the detector gives per watt of light on it. [A/W]
    electric_field : ElectricField, optional
        How the electric field of the light is told: its peak, or its root mean square.
    k : Amount, optional
        The meter's constant for reflected light (12.5 cd s/m2). [cd s/m2]
    c : Amount, optional
        The meter's constant for incident light (250 lx s). [lx s]
    time : Amount, optional
        Constant over that time. [s]
    bandwidth : Amount, optional
        Width of a band in which the spectral density is constant. [m]

    Returns
    -------
    Quantity
        In the unit `target`, of the shape of the magnitude of `value` (broadcast with those of
        the conditions).  On a scale the bare readings, a float or an array: they are no
        quantity, which could be multiplied.
        Where something is uncertain the magnitude is, correlated with that.  For a column a
        column like it.

    Raises
    ------
    radcalc.RadcalcError
        A text that is not a unit, or a condition that is missing, impossible, contradictory or
        without use.

    Examples
    --------
    >>> print(convert("800 lm", "cd", half_angle="60deg").round(3))
    254.648 candela
    >>> convert("10 mW", "dBm"), str(convert("-30 dBm", "uW"))
    (10.0, '1.0 microwatt')
    """
    found: Quantity = _convert(**_parted(locals()))
    return found


def explain(
    value: Number,
    target: str,
    *,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
    solid_angle: Amount = None,
    half_angle: Amount = None,
    apex_angle: Amount = None,
    isotropic: bool = False,
    hemisphere: bool = False,
    exponent: Number = None,
    beam_angle: Amount = None,
    distance: Amount = None,
    incidence: Amount = None,
    tilt: Amount = None,
    area: Amount = None,
    radius: Amount = None,
    diameter: Amount = None,
    reflectance: Number = None,
    pupil: Amount = None,
    responsivity: Amount = None,
    electric_field: ElectricField | None = None,
    k: Amount = None,
    c: Amount = None,
    time: Amount = None,
    bandwidth: Amount = None,
) -> Result:
    """Convert as `convert` does, and give what was assumed, noted and derived with the value.

    Parameters
    ----------
    value : Number
        As of `convert`; a single one, no array.
    target : str
        As of `convert`.
    wavelength : Amount, optional
        Light of one wavelength (or frequency, wavenumber, photon energy). [nm]
    spectrum : Text, optional
        Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...
    efficacy : Amount, optional
        A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol. [lm/W]
    observer : Observer, optional
        Whose eyes see `wavelength` or `spectrum`.
    range : Text, optional
        Where the watts of `spectrum` are counted.
    photon_range : Text, optional
        Where the photons of `spectrum` are counted (default 400nm:700nm).
    solid_angle : Amount, optional
        Uniform over that solid angle. [sr]
    half_angle : Amount, optional
        Uniform over the cone of that half angle, from axis to edge. [deg]
    apex_angle : Amount, optional
        Uniform over the cone of that full angle, from edge to edge. [deg]
    isotropic : bool, optional
        Uniform in all directions, over 4 pi sr.
    hemisphere : bool, optional
        Uniform over a hemisphere.
    exponent : Number, optional
        A lobe that falls off as a power of the cosine; 1 is Lambertian.
    beam_angle : Amount, optional
        A cosine-power lobe of that full angle at half the peak intensity. [deg]
    distance : Amount, optional
        Straight line from a small source to the receiver. [m]
    incidence : Amount, optional
        Angle between the light and the normal of the surface that is lit. [deg]
    tilt : Amount, optional
        Angle between the normal of a surface and the way its light takes. [deg]
    area : Amount, optional
        Uniform over that area. [m2]
    radius : Amount, optional
        Radius of a circular area. [m]
    diameter : Amount, optional
        Diameter of a circular area. [m]
    reflectance : Number, optional
        A Lambertian reflector, 0 to 1 or in %.
    pupil : Amount, optional
        Diameter of the eye's pupil. [m]
    responsivity : Amount, optional
        Current that the detector gives per watt of light on it. [A/W]
    electric_field : ElectricField, optional
        How the electric field of the light is told: its peak, or its root mean square.
    k : Amount, optional
        The meter's constant for reflected light (12.5 cd s/m2). [cd s/m2]
    c : Amount, optional
        The meter's constant for incident light (250 lx s). [lx s]
    time : Amount, optional
        Constant over that time. [s]
    bandwidth : Amount, optional
        Width of a band in which the spectral density is constant. [m]

    Returns
    -------
    Result
        Of one value, by the name of its quantity, with `assumptions`, `notes` and `steps`.

    Raises
    ------
    radcalc.RadcalcError
        As of `convert`.

    Examples
    --------
    >>> found = explain("800 lm", "cd", isotropic=True)
    >>> print(found.luminous_intensity.round(3))
    63.662 candela
    >>> found.assumptions
    ('uniform over 4 pi sr (isotropic)',)
    """
    return _explain(**_parted(locals()))


def factor(
    source: str,
    target: str,
    *,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
    solid_angle: Amount = None,
    half_angle: Amount = None,
    apex_angle: Amount = None,
    isotropic: bool = False,
    hemisphere: bool = False,
    exponent: Number = None,
    beam_angle: Amount = None,
    distance: Amount = None,
    incidence: Amount = None,
    tilt: Amount = None,
    area: Amount = None,
    radius: Amount = None,
    diameter: Amount = None,
    reflectance: Number = None,
    pupil: Amount = None,
    responsivity: Amount = None,
    electric_field: ElectricField | None = None,
    k: Amount = None,
    c: Amount = None,
    time: Amount = None,
    bandwidth: Amount = None,
) -> float:
    """The number by which values in one unit are multiplied to be in another.

    A query engine then needs nothing but a multiplication: Polars, DuckDB, Spark, SQL.

    Parameters
    ----------
    source, target : str
        The units, or a quantity's name as the target: ``"ppfd"``.
    wavelength : Amount, optional
        Light of one wavelength (or frequency, wavenumber, photon energy). [nm]
    spectrum : Text, optional
        Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...
    efficacy : Amount, optional
        A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol. [lm/W]
    observer : Observer, optional
        Whose eyes see `wavelength` or `spectrum`.
    range : Text, optional
        Where the watts of `spectrum` are counted.
    photon_range : Text, optional
        Where the photons of `spectrum` are counted (default 400nm:700nm).
    solid_angle : Amount, optional
        Uniform over that solid angle. [sr]
    half_angle : Amount, optional
        Uniform over the cone of that half angle, from axis to edge. [deg]
    apex_angle : Amount, optional
        Uniform over the cone of that full angle, from edge to edge. [deg]
    isotropic : bool, optional
        Uniform in all directions, over 4 pi sr.
    hemisphere : bool, optional
        Uniform over a hemisphere.
    exponent : Number, optional
        A lobe that falls off as a power of the cosine; 1 is Lambertian.
    beam_angle : Amount, optional
        A cosine-power lobe of that full angle at half the peak intensity. [deg]
    distance : Amount, optional
        Straight line from a small source to the receiver. [m]
    incidence : Amount, optional
        Angle between the light and the normal of the surface that is lit. [deg]
    tilt : Amount, optional
        Angle between the normal of a surface and the way its light takes. [deg]
    area : Amount, optional
        Uniform over that area. [m2]
    radius : Amount, optional
        Radius of a circular area. [m]
    diameter : Amount, optional
        Diameter of a circular area. [m]
    reflectance : Number, optional
        A Lambertian reflector, 0 to 1 or in %.
    pupil : Amount, optional
        Diameter of the eye's pupil. [m]
    responsivity : Amount, optional
        Current that the detector gives per watt of light on it. [A/W]
    electric_field : ElectricField, optional
        How the electric field of the light is told: its peak, or its root mean square.
    k : Amount, optional
        The meter's constant for reflected light (12.5 cd s/m2). [cd s/m2]
    c : Amount, optional
        The meter's constant for incident light (250 lx s). [lx s]
    time : Amount, optional
        Constant over that time. [s]
    bandwidth : Amount, optional
        Width of a band in which the spectral density is constant. [m]

    Returns
    -------
    float
        The factor; exact, and rounded once, between two units of one quantity.  `explain` tells
        what the conditions, of which there is a single value each, assume.

    Raises
    ------
    radcalc.RadcalcError
        As of `convert`; and where the two are not proportional, as with scales, or the factor is
        an array or uncertain.

    Examples
    --------
    >>> factor("klx", "lx"), factor("lx", "umol/m2/s", efficacy="50 lm s/umol")
    (1000.0, 0.02)
    """
    return _factor(**_parted(locals()))


def _parted(given: Mapping[str, Any]) -> dict[str, Any]:
    """The arguments of a call, its conditions apart."""
    first = {name: one for name, one in given.items() if name in ("value", "source", "target")}
    rest = {name: one for name, one in given.items() if name not in first}
    return {**first, "conditions": {k: v for k, v in rest.items() if not is_absent(v)}}


@in_python
def _convert(value: Any, target: str, conditions: dict[str, Any]) -> Any:
    columns, arrays = taken({"value": value, **conditions})
    if columns:
        made = _convert(arrays.pop("value"), target, arrays)
        unit = target_of(target)
        name = keyword(result_name(unit) or "value")
        return of_conversion(columns, made, unit, name)
    if any(map(is_lazy, (value, *conditions.values()))):
        from radcalc.api.lazy import blockwise

        return blockwise("convert", (value, target), conditions)
    made, magnitude, given = _plan(value, target, conditions)
    if _has_uncertainty(magnitude) or any_uncertain(given):
        found = _converted(made, magnitude, given).number
    else:
        found = broadcast(lambda: made.apply(magnitude))
    return found if made.target.is_scale else quantity(found, made.target)


@in_python
def _explain(value: Any, target: str, conditions: dict[str, Any]) -> Result:
    if isinstance(value, (list, tuple)) or any(
        getattr(one, "shape", ()) for one in (value, *conditions.values())
    ):
        raise ConditionError("explain takes single values, not arrays", "one of each")
    made, magnitude, given = _plan(value, target, conditions)
    for one in given:
        if is_column(one.value):
            raise ConditionError(f"explain takes one value of {option(one.name)}", "one of each")
    number = magnitude.typed[0] if isinstance(magnitude, ReadAmount) else magnitude
    number = float(getattr(number, "nominal_value", number))
    shown = answer_of(made, number, steps=True)
    if _has_uncertainty(magnitude) or any_uncertain(given):
        from radcalc.calculators.uncertainty import of_conversion

        made_of = _converted(made, magnitude, given)
        shown = of_conversion(shown, made_of)
        reading = made_of.number
    else:
        reading = shown.rows[0].value
    inputs = (_value_of(value, number, made), *inputs_of({one.name: one for one in given}))
    shown = shown._replace(inputs=inputs).spelled(in_words)
    name = keyword(shown.rows[0].name or "value")
    found = reading if made.target.is_scale else quantity(reading, made.target)

    def ask() -> Any:
        from radcalc.homework.question import of_conversion

        amount = magnitude if isinstance(magnitude, ReadAmount) else None
        return of_conversion(number, made.source, made.target, given, True, amount)

    undrawn = Undrawn("a conversion has no picture", "a calculator's, as of radcalc.point_source")
    return Result("convert", lambda: shown, {name: found}, {}, ask, undrawn)


def _value_of(value: Any, number: float, made: Plan) -> Input:
    """The value that was converted, as an answer tells it."""
    if not isinstance(value, str):
        return Input("value", number, made.source.text)
    amount = read_amount(value)
    return Input("value", number, made.source.text, amount.text, amount.typed_uncertainty)


@in_python
def _factor(source: str, target: str, conditions: dict[str, Any]) -> float:
    _require_texts(source, target)
    start = resolve_any(source)
    given = _conditions(conditions)
    refuse_uncertain(given, "a factor")
    for one in given:
        if is_column(one.value):
            problem = f"a factor is one number, and {option(one.name)} is an array"
            raise ConditionError(
                problem, "one value of each, or radcalc.convert, which takes arrays"
            )
    made = plan(start, target_of(target, start), given)
    if not made.is_linear:
        problem = f"{quote(source)} and {quote(target)} are linked by a function, not by a factor"
        raise ConversionError(problem, f'radcalc.convert("1 {quote(source)}", "{quote(target)}")')
    return float(made.factor)


def _require_texts(*units: Any) -> None:
    for unit in units:
        if not isinstance(unit, str):
            problem = f"a unit is a text, and not {article(type(unit).__name__)}"
            raise UnitError(problem, "a text such as 'lx'")


def _converted(made: Plan, magnitude: Any, given: list[Given]) -> Any:
    """A magnitude through a plan, where it or a condition is uncertain."""
    from radcalc.calculators.uncertainty import converted

    if isinstance(magnitude, ReadAmount):
        return converted(made, magnitude, given)
    amount = ReadAmount("the value", magnitude, made.source)
    of = None
    if is_uncertain(magnitude):
        number, size = magnitude.nominal_value, magnitude.std_dev
        amount, of = ReadAmount(str(magnitude), number, made.source, size), magnitude
    elif is_array(magnitude):
        raise ConditionError("an array stands beside an uncertain condition", ONE_EACH)
    return converted(made, amount, given, of)


def _has_uncertainty(magnitude: Any) -> bool:
    return isinstance(magnitude, ReadAmount) or is_uncertain(magnitude)


def _plan(value: Any, target: str, conditions: dict[str, Any]) -> tuple[Plan, Any, list[Given]]:
    """The plan that both need, the magnitude to apply it to, and the conditions.

    The magnitude of a text with an uncertainty is an `ReadAmount`.
    """
    refuse_lazy(value, "the value")
    _require_texts(target)
    magnitude: Any
    source: Unit | None
    if isinstance(value, (list, tuple)):
        value = _as_array(value)
    if isinstance(value, str):
        amount = read_amount(value)
        magnitude, source = amount.typed
        magnitude = amount if amount.is_uncertain else magnitude
    elif is_quantity(value):
        magnitude, source = value.magnitude, unit_of(value)
    else:
        magnitude, source = value, None
    given = _conditions(conditions)
    made = _plan_of(source, target, given)
    if _has_uncertainty(magnitude):
        return made, magnitude, given
    kind = getattr(getattr(magnitude, "dtype", None), "kind", "")
    if not isinstance(magnitude, (int, float)) and kind not in ("i", "u", "f"):
        hint = "real numbers" if is_quantity(value) else "a text, a quantity or numbers"
        magnitude = real(magnitude, "the value", hint)
    return made, magnitude, given


def _plan_of(source: Unit | None, target: str, given: list[Given]) -> Plan:
    """The plan from a unit, or from numbers without one."""
    start = source or resolve("1")
    wanted = target_of(target, start)
    if source is None and wanted.dimension != start.dimension and not wanted.is_scale:
        problem = f"the value has no unit, and {describe(wanted)} is wanted"
        raise ConversionError(problem, f'a text such as "100 lx", or {WITH_UNIT}')
    return plan(start, wanted, given)


def _as_array(value: Sequence[Any]) -> Any:
    """A list of texts or quantities as one array, in the unit of the first; another as it is."""
    if not any(isinstance(one, str) or is_quantity(one) for one in value):
        return value
    amounts = [read_amount(one) if isinstance(one, str) else None for one in value]
    if any(one and one.is_uncertain for one in amounts) or any(map(is_uncertain, value)):
        raise ConditionError("a list has an uncertain value", ONE_EACH)
    read = [
        amount.typed if amount else plain(one) if is_quantity(one) else (one, None)
        for one, amount in zip(value, amounts, strict=True)
    ]
    each = [(number, unit or resolve("1")) for number, unit in read]
    if any(unit.is_scale for _, unit in each):
        problem = "a list has readings on a scale"
        raise ConditionError(problem, "one text a call, or what they stand for, in a unit")
    return quantity(*together("a list", each))


def _conditions(conditions: dict[str, Any]) -> list[Given]:
    """Read the conditions of a conversion."""
    read = [read_keyword(name, one, CONDITIONS, "condition") for name, one in conditions.items()]
    return [one for one in read if one]
