"""Units that are read through a function (scales), such as dBm, and the values of their readings.

A scale is a row of `SCALES`.  With a reference x0 in its unit, the reading n of a quantity x is

    n = zero + steps lg(x / x0)     with lb instead of lg for base 2
    n = x0 / x                      for steps = 0: reciprocal

so readings cannot be multiplied or added.
"""

import math
from collections.abc import Iterable
from typing import Any

from radcalc import maths
from radcalc.errors import ConversionError, NumberError, RadcalcError, correct, quote
from radcalc.floats import SMALLEST
from radcalc.units import TEMPERATURE_ALONE, Dimension, Unit
from radcalc.units.grammar import plain
from radcalc.units.numbers import Amount, read_number
from radcalc.units.scale_table import SCALES, SIZES, Scale, named, usual
from radcalc.units.table import CELSIUS, FAHRENHEIT, resolve, unit_of

RECIPROCAL = next(scale for scale in SCALES if not scale.steps)


class ScaleUnit(Unit):
    """A scale as the user wrote it, used like a unit; the values of its readings are in `unit`.

    `others` are other scales with this spelling.
    """

    __slots__ = ("others", "scale", "unit")
    is_scale = True

    def __init__(self, text: str, scale: Scale, others: "tuple[ScaleUnit, ...]" = ()) -> None:
        unit = resolve(scale.unit)
        super().__init__(text, unit.top, unit.bottom, unit.dimension, unit.atoms)
        self.unit = unit
        self.scale = scale
        self.others = others

    @property
    def assumption(self) -> str:
        return self.describe()

    def describe(self, settable: bool = False) -> str:
        scale = self.scale
        name = quote(self.text)
        text = f"{name}: {scale.inverse(name if scale.constant else 'n')}, {scale.meaning}"
        if scale.constant and scale.size == SIZES[scale.constant]:
            text += f", {usual(scale.constant, settable)}"
        return text

    def quantity(self, reading: Any) -> Any:
        """Return the quantity of a reading [coherent SI]; NumberError if it has none."""
        reading_text = f"{reading:.12g} " if isinstance(reading, float) else ""
        reading_text += quote(self.text)
        if not self.scale.steps and maths.any_true(reading <= 0):
            is_shift = isinstance(reading, float) and reading < 0
            shift = "a difference, as of filters, and " if is_shift else ""
            raise NumberError(
                f"{reading_text} is {shift}not the reciprocal of a temperature", "more than 0"
            )
        try:
            quantity = self.scale.quantity(reading)
        except (OverflowError, ZeroDivisionError):
            quantity = 0.0
        if maths.any_true((quantity < SMALLEST) | (quantity - quantity != 0)):
            raise NumberError(f"{reading_text} is out of range", "less extreme values")
        return quantity

    def reading(self, quantity: Any) -> Any:
        """Return the reading of a quantity above 0 in `unit`."""
        if maths.is_uncertain(quantity):
            reading = self.reading(quantity.nominal_value)
            return reading + (quantity - quantity.nominal_value) / self.slope(reading)
        if maths.any_true(quantity <= 0):
            quantity_text = (
                f"{quantity:.6g} {self.unit.text}" if isinstance(quantity, float) else "0"
            )
            quantity_text = quantity_text.removesuffix(" 1")
            raise ConversionError(
                f"{quantity_text} has no reading on {quote(self.text)}", "more than 0"
            )
        return self.scale.reading(quantity) + 0.0

    def slope(self, reading: Any) -> Any:
        return self.scale.slope(reading)

    def measures(self, dimensions: Iterable[Dimension]) -> "ScaleUnit":
        """Return the scale, of those with this spelling, of one of the dimensions; else this."""
        wanted = tuple(dimensions)
        return next((scale for scale in (self, *self.others) if scale.dimension in wanted), self)

    def with_constants(self, values: dict[str, float]) -> "ScaleUnit":
        others = tuple([other.with_constants(values) for other in self.others])
        scale = self.scale
        if scale.constant in values:
            scale = scale.of_meter(values[scale.constant])
        return ScaleUnit(self.text, scale, others)


def find(text: str) -> ScaleUnit | None:
    """Return the scale of a text; None for another text."""
    text = " ".join(text.split())
    rows = named(plain(text))
    if not rows:
        return None
    others = tuple([ScaleUnit(text, row) for row in rows[1:]])
    return ScaleUnit(text, rows[0], others)


def resolve_any(text: str) -> Unit:
    """Return the unit of a text, a scale or a word of growers; raise UnitError for other texts."""
    if unit := find(text) or unit_of(text):
        return unit
    from radcalc.units import table

    return table.growers_unit(text) or resolve(text)


def refuse_product(text: str, scale: str) -> None:
    """Raise for 2*10 dBm, which is ambiguous."""
    if "*" not in text:
        return  # a text without a product need not begin with a number: (10±1) dBm
    number, end = read_number(text)
    if "*" in text[:end]:
        raise NumberError(
            f"'{quote(text)}' multiplies a reading of {quote(scale)}, which is not possible",
            correct(text, f"{number:.12g} {scale}", remark="one reading"),
        )


def scale_of(unit: Unit) -> Scale | None:
    """Return the scale of a `ScaleUnit`; None for a unit."""
    return unit.scale if isinstance(unit, ScaleUnit) else None


def amount_on(
    unit: Unit, text: str, reading: float, uncertainty: float, dimensions: Iterable[Dimension]
) -> Amount:
    """Return the amount of a reading, with its uncertainty."""
    assert isinstance(unit, ScaleUnit)
    scale = unit.measures(dimensions)
    quantity = scale.quantity(reading)
    assumptions = (scale.assumption,)
    if not uncertainty:
        return Amount(text, quantity, scale.unit, 0.0, assumptions, scale, reading)
    from radcalc.units.functions import Part, check_uncertainty

    def at(times: float) -> float | None:
        try:
            return float(scale.quantity(reading + times * uncertainty))
        except RadcalcError:
            return None

    size = scale.slope(reading) * uncertainty
    check_uncertainty(abs(size) or math.nan, text)
    part = Part(text, size, at)
    return Amount(text, quantity, scale.unit, abs(size), assumptions, scale, reading, parts=(part,))


def reciprocal(unit: Unit) -> ScaleUnit:
    """Return a unit such as 1/MK as a scale of temperatures, read as their reciprocals."""
    return ScaleUnit(unit.text, RECIPROCAL._replace(size=unit.bottom / unit.top))


def degree(text: str) -> Unit | None:
    """Return the unit of a temperature difference in degrees Celsius or Fahrenheit, else None."""
    name = plain(text).lower().replace("° ", "°")
    name = name.replace(" ", "_").replace("-", "_")
    if name in CELSIUS:
        return Unit(text, 1, 1, TEMPERATURE_ALONE, ((name, 1),))
    return Unit(text, 5, 9, TEMPERATURE_ALONE, ((name, 1),)) if name in FAHRENHEIT else None


def resolve_given(text: str) -> Unit:
    """Return the unit of an input, with degrees as units of temperature differences."""
    return degree(text) or resolve_any(text)


def in_which(text: str, dimensions: Iterable[Dimension]) -> Unit:
    """Return the unit for the value of an input that is a reading or in degrees."""
    if scale := find(text):
        return scale.measures(dimensions).unit
    return resolve("K" if degree(text) else text)


def on(dimension: Dimension) -> list[Scale]:
    """Return the scales of a dimension."""
    return [scale for scale in SCALES if resolve(scale.unit).dimension == dimension]


def names_of(dimension: Dimension) -> list[str]:
    """Return the names of the scales of a dimension."""
    return [scale.name for scale in on(dimension)]
