"""Reader of quantities."""

import math
from typing import TYPE_CHECKING, Any, cast

from radcalc import errors, maths
from radcalc.answer import format_number
from radcalc.errors import option, quote
from radcalc.floats import divide
from radcalc.inputs import DigitsMatter, Input, check_limits
from radcalc.maths import LARGEST
from radcalc.quantities import LUMINOUS, describe, names
from radcalc.quantities import read as read_light
from radcalc.quantities.symbols import (
    QUANTITY,
    READINGS,
    SPECTRUM,
    SYMBOLS,
    Symbol,
    is_alone,
    specific_name,
)
from radcalc.units import NUMBER, Unit
from radcalc.units.dimensions import ANGLE, SOLID_ANGLE, TIME
from radcalc.units.numbers import Amount, parse_number, relative_rounding
from radcalc.units.ranges import real, with_list
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve

LEFT_OF_LIGHT = ("reflectance", "transmittance")  # ratios that can be in OD, stops or dB
if TYPE_CHECKING:
    from radcalc.units.values import ScaleUnit

MARKED = {"f-number": "f/", "nd": "nd"}  # prefixes of numbers: f/8,f/11 is a list, not 8.11
MARKS_OF_STOPS = range(101, 114)  # marks of filters for 1 to 13 stops
DIFFERENCES = ("temperature-rise",)  # may be in degrees Celsius, but not in mired


def as_seen(given: Input, kind: str) -> Input:
    """Return an input of lumens, or an efficacy, as one of an observer's kind."""
    if given.unit is None or given.symbol.form != QUANTITY:
        return given
    unit = names.as_seen(given.unit, kind)
    symbol = given.symbol
    if symbol.kind == LUMINOUS and unit is not given.unit:
        symbol = SYMBOLS[specific_name(symbol.generic, kind)]._replace(name=given.name)
    return given._replace(symbol=symbol, unit=unit, dimension=unit.dimension)


def moved(given: Input, shift: float) -> Input:
    """Return an input with its value shifted by `shift` [SI], within its limits.

    For a spectrum, the uncertain parameter is shifted.
    """
    number = given.number + shift * (divide(given.unit.bottom, given.unit.top) if given.unit else 1)
    if given.symbol.form == SPECTRUM:
        from radcalc.spectra.sources import uncertain_parameter

        parameter = uncertain_parameter(given.text)
        assert parameter is not None
        return given._replace(text=f"{given.text}, {number!r}", value=parameter.source(number))
    value = given.value + shift
    if given.name:
        _refuse_extreme(given.name, given.text, value)
    elif not math.isfinite(value):
        raise errors.NumberError(
            f"more than '{quote(given.text)}' is too large for a number", "less"
        )
    if given.unit and given.unit.is_scale:
        number = cast("ScaleUnit", given.unit).reading(value / given.unit.factor)
    shifted = given._replace(
        text=f"{number!r}{given.unit_text if given.unit else ''}",
        value=value,
        number=number,
        off=None,
    )
    check_limits(shifted, given.symbol.limits)
    return shifted


def with_numbers(given: Input, numbers: Any) -> Input:
    """Return an input with an array of numbers in the same unit."""
    if given.name == "nd":  # 3 is ambiguous, 3.0 is not
        raise DigitsMatter
    text = given.text_of(numbers)
    sizes, unit = numbers, given.unit
    if unit and unit.is_scale:
        sizes, unit = unit.quantity(numbers), cast("ScaleUnit", unit).unit
    value = _in_si(given.name, text, sizes, unit)
    old_option, new_option = (option(given.name, quote(item)) for item in (given.text, text))
    assumptions = tuple([item.replace(old_option, new_option) for item in given.assumptions])
    several = given._replace(text=text, value=value, number=numbers, assumptions=assumptions)
    check_limits(several, given.symbol.limits)
    return several


def quantity_input(symbol: Symbol, value: Any) -> Input:
    """Read a quantity: a text, a Python number, or a number with its unit."""
    variable = None
    if isinstance(value, str):
        text = " ".join(value.split()).replace(errors.MINUS, "-")  # on one line for messages
        if symbol.name == "f-number" and text[:2].lower() == MARKED[symbol.name]:
            text = text[2:]  # f/2.8
        amount = _typed_amount(symbol, text)
    else:
        amount, variable = _python_amount(symbol, value)
        text = amount.text
    _check_unit(symbol, amount)
    unit = amount.unit
    if (unit.dimension if unit else NUMBER) not in symbol.dimensions:
        raise _wrong_dimension(symbol, text, amount)
    given = Input(
        symbol,
        text,
        _in_si(symbol.name, text, amount.number, unit),
        unit.dimension if unit else NUMBER,
        *amount.typed,
        not isinstance(value, str),
        amount.uncertainty * unit.factor if unit else amount.uncertainty,
        (*amount.assumptions, *_said(amount)),
        variable,
        amount.rounding,
        amount.parts,
    )
    check_limits(given, symbol.limits)
    return given


def _said(amount: Amount) -> tuple[str, ...]:
    """Return the notes on the letters of an expression."""
    return amount.unit.notes if amount.unit and amount.rounding is not None else ()


def _typed_amount(symbol: Symbol, text: str) -> Amount:
    amount = None
    if symbol.name in DIFFERENCES:
        amount = _difference(text)
    elif symbol.name == "nd":
        amount = _density(text)
    amount = amount or _read_amount(symbol, text)
    if amount.scale and amount.scale.text in READINGS.get(symbol.name, ()):
        unit = measured_in(amount.scale.text, symbol.name)
        return Amount(text, amount.reading, unit, amount.typed_uncertainty)
    return amount


def _python_amount(symbol: Symbol, value: Any) -> tuple[Amount, Any]:
    """Read a Python number or an array, optionally with a unit and a text.

    Returns the amount, and the number if it is one of the `uncertainties` package, else None.
    """
    number, unit, *texts = value if is_number_with_unit(value) else (value, None)
    variable, uncertainty = None, 0.0
    if maths.is_uncertain(number):
        variable, number, uncertainty = number, number.nominal_value, number.std_dev
    number = real(number, option(symbol.name), option(symbol.name, symbol.example))
    text = texts[0] if texts else format_number(number) + (f" {unit.text}" if unit else "")
    return Amount(text, number, unit, uncertainty), variable


def _check_unit(symbol: Symbol, amount: Amount) -> None:
    scale, unit = amount.scale, amount.unit
    refused = None
    if scale:
        dimension = unit.dimension if unit else NUMBER
        if dimension not in symbol.dimensions or not takes_scale(symbol.name, scale):
            refused = f"{symbol.takes}, not {quote(scale.text)}"
    elif unit and NUMBER in symbol.dimensions and is_alone(symbol.name, unit):
        refused = f"a number, not {quote(unit.text)}"
    elif unit and unit.notes and symbol.name in READINGS:  # (0.3 OD) is a ratio
        refused = "a number, not a reading in arithmetic"
    if refused:
        name = option(symbol.name)
        raise errors.ConditionError(f"{name} takes {refused}", option(symbol.name, symbol.example))


def _wrong_dimension(symbol: Symbol, text: str, amount: Amount) -> errors.ConditionError:
    """Return the error for an amount of another quantity, with the condition that takes it."""
    name, unit = symbol.name, amount.unit
    if unit is None and maths.is_array(amount.number):
        problem = f"{option(name)} has numbers without a unit"
        words = "an array with its unit, a radcalc.Quantity"
        return errors.ConditionError(problem, words, [errors.add(name, symbol.unit)])
    if unit is None:
        is_expression = amount.rounding is not None
        number = f"({quote(text)})" if is_expression else quote(text)
        return errors.MissingUnit(name, quote(text), with_likely_unit(symbol, number), number)
    example, is_array = symbol.example, maths.is_array(amount.number)
    problem = f"{option(name)} takes {symbol.takes}, not {describe(unit)}"
    light, other = read_light(unit), ""
    if light and symbol.kind and light.kind != symbol.kind:  # 5 W as a luminous flux
        other = specific_name(symbol.generic, light.kind)
    elif ANGLE in symbol.dimensions and unit.dimension == SOLID_ANGLE:
        other = "solid-angle"
    text = "" if is_array else text
    if other in SYMBOLS and unit.dimension in SYMBOLS[other].dimensions:
        proposal = errors.Try(((other, text),), (name,))
        return errors.WrongQuantity(problem, proposal if text else str(proposal), name, text)
    hint: errors.Hint = (
        errors.add(name, example) if name == "bandwidth" else f"a value such as {example}"
    )
    error = errors.WrongQuantity(problem, hint, name, text)
    if name == "wavelength" and unit.dimension == TIME and text and amount.number > 0:
        remark = f"the frequency of a period of {quote(text)}"
        period = f"{1 / (amount.number * unit.factor):.6g}Hz"
        return error.reworded(tries=[errors.computed(errors.add(name, period, remark))])
    return error


def takes_scale(name: str, scale: Unit) -> bool:
    """Return whether a symbol has readings on a scale; dB and stops are for transmitted light."""
    if scale.dimension == NUMBER:
        return name in LEFT_OF_LIGHT
    return name not in DIFFERENCES


def measured_in(text: str, name: str = "") -> Unit:
    """Return the unit or the scale of a text, for a symbol.

    A difference may be in degrees Celsius.  A number that is a reading has its scale for a unit.
    """
    from radcalc.units.values import degree, resolve_any

    if step := READINGS.get(name, {}).get(text):
        return Unit(text, *step.as_integer_ratio(), NUMBER, ())
    return (degree(text) if name in DIFFERENCES else None) or resolve_any(text)


def is_number_with_unit(value: Any) -> bool:
    """Return whether a value is a tuple of a number or an array, and its unit."""
    return isinstance(value, tuple) and len(value) > 1 and isinstance(value[1], Unit)


def _read_amount(symbol: Symbol, text: str) -> Amount:
    try:
        return read_amount(text, symbol.dimensions)
    except errors.NumberError as error:
        hint: errors.Hint = error.tries or error.hint
        if "," in text and error.tries:
            hint = with_list(error.tries, text)
        raise errors.NumberError(f"{option(symbol.name)}: {error.message}", hint) from None


def _difference(text: str) -> Amount | None:
    """Read a temperature difference in degrees of another scale (°C); None for other texts."""
    unit_text = text[max(map(text.rfind, "0123456789.)%")) + 1 :].strip()
    from radcalc.units.values import degree

    unit = degree(unit_text)
    without_unit = text.replace(unit_text, "") if unit else ""
    if unit is None or any(c.isalpha() for c in without_unit.lower().replace("e", "")):
        return None
    try:
        amount = read_amount(text.replace(unit_text, "K"))
    except errors.RadcalcError:
        return None  # the general reader reports the text as typed
    if amount.unit is None or amount.rounding is not None:
        return None
    assumption = f"a temperature difference: 1 {quote(unit_text)} is {format_number(unit.factor)} K"
    return Amount(text, amount.number, unit, amount.uncertainty, (assumption,))


def _density(text: str) -> Amount | None:
    """Read the mark of a neutral-density filter: ND8 is a factor of 8, ND0.9 a density.

    Returns None for a bare density, which is read like other numbers.
    """
    number = _without_mark(text)
    if not number[:1].isdecimal():
        return None
    if number == text:
        if text.isdecimal() and float(text) > 1:
            problem = f"{option('nd', quote(text))} is ambiguous: a density or a factor"
            ways = [
                errors.add("nd", f"{text}.0", "for the density"),
                errors.add("nd", f"ND{text}", "for the factor"),
            ]
            raise errors.ConditionError(problem, ways)
        return None
    factor, off = parse_number(number), relative_rounding(number)
    if "." in number:
        return Amount(
            text, factor, None, assumptions=(f"{quote(text)} is a density",), rounding=off
        )
    _check_factor(text, number, factor)
    density = math.log10(factor)
    assumption = f"{quote(text)} transmits 1/{number} of the light: a density of {density:.4g}"
    return Amount(text, density, None, assumptions=(assumption,), rounding=off)


def _without_mark(text: str) -> str:
    number = text[:-1] if text[-1:] in ("X", "x") else text
    if number[:2].upper() == "ND":
        number = number[2:]
    if number[-2:].upper() == "ND":
        number = number[:-2]
    return number.strip()


def _check_factor(text: str, number: str, factor: float) -> None:
    """Refuse a filter factor below 1, and one that may be a mark for stops."""
    if factor < 1:
        problem = f"{option('nd', quote(text))} is not a filter: its factor is below 1"
        raise errors.ConditionError(problem, option("nd", "ND8"))
    if factor in MARKS_OF_STOPS:  # some makers mark 3 stops as 103
        stops = number[1:].lstrip("0")
        problem = f"{option('nd', quote(text))} is ambiguous: a factor or {stops} stops"
        of_stops = errors.add("nd", f"{(factor - 100) * 0.3:.1f}", f"for {stops} stops")
        of_factor = errors.add("nd", f"{math.log10(factor):.4f}", f"for a factor of {number}")
        raise errors.ConditionError(problem, list(map(errors.computed, (of_stops, of_factor))))


def with_likely_unit(symbol: Symbol, number: str) -> str:
    """Return a bare number with a unit that suits the symbol."""
    if ANGLE in symbol.dimensions and ("pi" in number or "π" in number):
        return f"{number}rad"
    if TIME in symbol.dimensions and "/" in number:
        return f"{number}s"  # like marks of shutters
    unit = symbol.example.lstrip("0123456789./")
    usual = symbol.unit.replace(" ", ".")
    if usual not in ("1", unit) and _is_more_likely(symbol, number, usual, unit):
        unit = usual
    return number + unit


def _is_more_likely(symbol: Symbol, number: str, usual: str, unit: str) -> bool:
    """Return whether a number is in the usual unit, not in that of the example.

    A quantity of light extends over many powers of ten: it has no prefix that was not typed.
    """
    if symbol.generic:
        return resolve(usual).dimension == resolve(unit).dimension
    return not _is_nearer(symbol.example, number, unit, usual)


def _is_nearer(example: str, number: str, unit: str, usual: str) -> bool:
    """Return whether a number is ten times nearer to the example in one unit than in another."""
    try:
        amounts = [read_amount(text) for text in (example, number + unit, number + usual)]
        typical, here, there = (
            math.log10(amount.number * amount.unit.factor) for amount in amounts if amount.unit
        )
    except (errors.RadcalcError, ValueError):  # not a positive number
        return True
    return abs(there - typical) - abs(here - typical) >= 1


def _in_si(name: str, text: str, number: Any, unit: Unit | None) -> Any:
    value = number * (divide(unit.top, unit.bottom) if unit else 1)
    _refuse_extreme(name, text, value)
    return value


def _refuse_extreme(name: str, text: str, value: Any) -> None:
    """Refuse extreme values [SI], which would overflow later."""
    if isinstance(value, float) and value != value:
        raise errors.ConditionError(
            f"{option(name, quote(text))} is not a number", "a finite number"
        )
    size = abs(value)
    extreme = (size > LARGEST) | ((size < 1 / LARGEST) & (size != 0)) | (size != size)
    if maths.any_true(extreme):
        raise errors.ConditionError(
            f"{option(name, quote(text))} is out of range: it is too large or too small",
            f"values from {1 / LARGEST:g} to {LARGEST:g} in SI units",
        )
