"""Results in the units that are asked for: floats, or arrays where a range was given."""

import math
from collections.abc import Sequence
from typing import Any

from radcalc.answer import Row, Value
from radcalc.conversion.plan import exact_ratio
from radcalc.errors import NumberError, UsageError, nearest, quote
from radcalc.maths import is_array, is_column
from radcalc.quantities.light import GRID, describe
from radcalc.units.table import Unit, resolve


def in_unit(value: Value, unit: Unit) -> Any:
    """A value in one of the units it may be asked for."""
    amount = value.reach.get(unit.dimension)
    if unit.dimension in value.dimensions:
        amount = value.si
    if amount is None:
        own, asked = GRID.get(value.dimensions[0]), GRID.get(unit.dimension)
        if own and asked and own[1:] == asked[1:]:
            raise UsageError(
                f"{value.name} in {quote(unit.text)} takes what links the kinds of light",
                "--wavelength, --spectrum or --efficacy",
            )
        raise UsageError(
            f"{value.name} is not measured in {describe(unit)}",
            ", ".join(f"{value.name}:{text}" for text in value.units),
        )
    if value.given is not None and unit.text == value.units[0]:
        return value.given + 0.0  # as typed: 30, where pi/6 would give 29.999999999999996
    si = Unit("SI", 1, 1, unit.dimension, ())
    ratio = exact_ratio(si, unit)
    return held(value.name, amount * (float(ratio) if is_array(amount) else ratio))


def held(name: str, number: Any) -> Any:
    """A result as floats, unless it has left what a number can hold."""
    if is_column(number):
        good = bool((abs(number) < math.inf).all())
    else:
        number = float(number)
        good = math.isfinite(number)
    if not good:
        raise NumberError(f"{name} cannot be held by a number", "less extreme values")
    return number + 0.0


def pick(values: Sequence[Value], wanted: str) -> Any:
    """What NAME[:UNIT] asks for."""
    name, _, unit = wanted.partition(":")
    name = name.strip()
    for value in values:
        if name and name in (value.name, value.also):
            return in_unit(value, resolve(unit)) if unit else held(value.name, value.si)
    names = list(dict.fromkeys(value.name for value in values if value.units))
    near = nearest(name, names) or names
    raise UsageError(f"there is no result '{quote(name)}'", ", ".join(near))


def rows(values: Sequence[Value], case: str = "") -> list[Row]:
    """All the results, each in the units it is shown in.

    Of several answers each begins with what was given, which tells them apart.
    """
    found = [
        Row(v.label, v.symbol, in_unit(v, resolve(text)), text, case, v.name, v.given is not None)
        for v in values
        for text in v.units
    ]
    if case:
        found.sort(key=lambda row: not row.given)
    return found
