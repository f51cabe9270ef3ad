"""Readers of values with their units."""

from radcalc import errors
from radcalc.errors import quote
from radcalc.units import Dimension
from radcalc.units.amounts import (
    LONGEST_SUM,
    UNCERTAIN,
    amount_in,
    find_unit,
    has_number,
    read_plain,
    read_sum,
)
from radcalc.units.numbers import DIGITS, SIGNS_OF_UNCERTAINTY, Amount, split_quantity
from radcalc.units.table import resolve, unit_of

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Sequence


def read_amount(text: str, dimensions: "Sequence[Dimension]" = ()) -> Amount:
    """Read a value, with a unit or bare; a spelling of several scales is read as one of them."""
    text = text.strip()
    problem: errors.RadcalcError | None = None
    try:
        number, unit = split_quantity(text)
        if unit.isalpha() or not has_number(unit):
            return read_plain(text, number, unit, dimensions)
    except errors.RadcalcError as error:
        problem = error
    is_signed = any(sign in text for sign in SIGNS_OF_UNCERTAINTY)
    is_signed |= any(text[k - 1] in DIGITS for k, c in enumerate(text) if k and c == "(")  # 100(3)
    if not is_signed and (amount := read_sum(text, dimensions)):
        return amount
    if any(mark in text for mark in UNCERTAIN):
        from radcalc.units.uncertain import read_uncertain

        if reading := read_uncertain(text, dimensions):
            size, unit_found, off, _, parts = reading
            return amount_in(text, size, unit_found, off, dimensions, parts)
    if is_signed and (amount := read_sum(text, dimensions)):
        return amount
    if meant := sum_meant(text):
        raise errors.UnitError(f"'{quote(text)}' has several numbers", errors.correct(text, meant))
    if problem:
        raise problem
    return read_plain(text, number, unit, dimensions)


def read_for(text: str, target: str) -> Amount:
    """Read a value that is converted to a target, which decides between two readings."""
    try:
        return read_amount(text)
    except errors.ExpressionError:
        if not (dimensions := dimensions_of(target)):
            raise
        return read_amount(text, dimensions)


def dimensions_of(target: str) -> tuple[Dimension, ...]:
    """Return the dimension of a target that is a unit or a scale, as a tuple; else ()."""
    unit = unit_of(target)
    if unit is None and target:
        from radcalc.units.values import find_scale

        unit = find_scale(target)
    return (unit.dimension,) if unit else ()


def sum_meant(text: str) -> str:
    """Return `5 ft + 3 in` for `5 ft 3 in`, numbers with units of one quantity; else ''."""
    import re  # only when something is wrong already

    if len(text) > LONGEST_SUM:
        return ""
    pairs = re.findall(r"([\d.]+)\s*([^\d\s.]+)", text)
    if len(pairs) < 2 or "".join(map("".join, pairs)) != "".join(text.split()):
        return ""
    units = [unit_of(unit) for _, unit in pairs]
    if len({unit.dimension if unit else None for unit in units} | {None}) != 2 or None in units:
        return ""
    return " + ".join(f"{number} {unit}" for number, unit in pairs)


def with_unit(amount: Amount, unit: str) -> Amount:
    """Return a bare number with the unit from another word, or arithmetic times that unit."""
    text = f"{amount.text} {unit}"
    if unit == "1":  # multiplies nothing, so that 2 + 3 remains 5
        return Amount(
            text,
            amount.number,
            resolve(unit),
            amount.uncertainty,
            (),
            None,
            0.0,
            amount.rounding,
            amount.parts,
            amount.ratio,
        )
    if amount.rounding is not None or amount.parts:
        return read_amount(text)
    return amount_in(
        text, amount.number, find_unit(text, unit), amount.uncertainty, (), amount.parts
    )
