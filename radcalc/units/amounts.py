"""Amounts without uncertainties: a number and its unit, an expression, a reading on a scale."""

from radcalc.errors import MINUS, NumberError, RadcalcError, UnitError, command, correct, quote
from radcalc.units import Dimension, Unit
from radcalc.units.numbers import DIGITS, SIGNS_OF_UNCERTAINTY, Amount, split_quantity
from radcalc.units.table import resolve, unit_of

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Sequence

    from radcalc.units.functions import Part

NOT_UNITS = "^*+±×'.,0123456789"  # characters that a unit cannot begin with
BEFORE_NUMBERS = tuple(" */(+×·")  # characters before a number in an expression
OPERATORS = ("+", "-", "*", "/", "·", "×", MINUS)
UNCERTAIN = "±+("  # marks of an uncertainty in 100±3, 100+-3 and 100(3)
LONGEST_SUM = 100  # characters of a text for which a hint suggests a sum
STREAM_EXAMPLE = f"{command('convert', '-', 'lx', 'fc')}, or "
STREAM_EXAMPLE += f"{command('convert', '-', 'fc')} for lines with their own unit"


def has_number(unit: str) -> bool:
    """Return whether a unit's text contains a number other than an exponent."""
    before = last = ""
    for c in unit:
        if c in DIGITS and last in BEFORE_NUMBERS and not before == last == "*":
            return True
        before, last = last, c
    return False


def read_sum(text: str, dimensions: "Sequence[Dimension]" = ()) -> Amount | None:
    """Read arithmetic with units; return None for a text that is not an expression.

    The dimensions that are asked for decide what h is: an hour or the Planck constant.
    """
    from radcalc.units.expressions import read_expression

    result = read_expression(text, dimensions=tuple(dimensions))
    return Amount(text, *result[:2], rounding=result[2], ratio=result[3]) if result else None


def split_value(text: str) -> tuple[float, str]:
    """Split a value into its number and its unit's text, '' for a bare number.

    An expression must not contain uncertainties.  The unit of a plain number is not checked.
    """
    problem: RadcalcError | None = None
    number, unit = 0.0, ""
    try:
        number, unit = split_quantity(text)
        if not unit or unit_of(unit):
            return number, unit
        from radcalc.units.values import find_scale, refuse_product

        if find_scale(unit):
            refuse_product(text, unit)
            return number, unit
    except NumberError as error:
        problem = error
    if any(sign in text for sign in SIGNS_OF_UNCERTAINTY):
        message = f"'{quote(text)}' has an uncertainty, which cannot be used here"
        raise NumberError(message, correct(text, nominal(text)))
    from radcalc.units.expressions import read_expression

    result = read_expression(text)
    if result:
        return result[0], result[1].text if result[1] else ""
    if problem:
        raise problem
    return number, unit


def nominal(text: str) -> str:
    """Return a value without its ± and uncertainty, or the text if it has none."""
    places = [(text.find(sign), sign) for sign in SIGNS_OF_UNCERTAINTY if sign in text]
    if not places:
        return text
    at, sign = min(places)
    try:
        unit = split_quantity(text[at + len(sign) :])[1]
    except NumberError:
        return text
    return f"{text[:at].rstrip()}{unit}"


def read_plain(text: str, number: float, unit: str, dimensions: "Sequence[Dimension]") -> Amount:
    """Return the amount of a number and the text of its unit."""
    if unit and (
        unit[0] in NOT_UNITS
        or unit.lower().startswith("x10")
        or (unit[0] == "(" and unit[1:2].isdigit())
    ):
        raise NumberError(f"'{quote(text)}' is not a number", "a number such as 1000 or 1.5e3")
    amount = amount_in(text, number, find_unit(text, unit) if unit else None, 0.0, dimensions)
    if "+" in unit.replace("^+", "").replace("*+", ""):  # 5m+2 cm is a sum, not m2 cm
        raise NumberError(f"'{quote(text)}' is not a value with a unit", "m^2 for a power")
    return amount


def find_unit(text: str, unit: str) -> Unit:
    """Return the unit or the scale of the number of a text."""
    try:
        return resolve(unit)
    except UnitError:
        from radcalc.units import table
        from radcalc.units.values import find_scale, refuse_product

        scale = find_scale(unit)
        if scale is None:
            if word := table.growers_unit(unit):
                return word
            raise
        refuse_product(text, unit)
        return scale


def amount_in(
    text: str,
    number: float,
    unit: Unit | None,
    uncertainty: float = 0.0,
    dimensions: "Sequence[Dimension]" = (),
    parts: "tuple[Part, ...]" = (),
) -> Amount:
    """Return the amount of a number in its unit, or of a reading on a scale."""
    if unit is None or not unit.is_scale:
        return Amount(text, number, unit, uncertainty, parts=parts)
    from radcalc.units.values import amount_on

    return amount_on(unit, text, number, uncertainty, dimensions)
