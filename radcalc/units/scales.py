"""Scales: what is read through a function, such as dBm, and what a reading on one stands for.

A scale is a row of `SCALES`.  With a reference x0 in its unit, a quantity x reads

    n = zero + steps lg(x / x0)     with lb in place of lg where the base is 2
    n = x0 / x                      where there are no steps: reciprocal

so that no reading can be multiplied by anything, nor added to another.
"""

import math
from collections.abc import Iterable
from typing import Any

from radcalc import maths
from radcalc.errors import ConversionError, NumberError, RadcalcError, quote
from radcalc.units.amount import Amount
from radcalc.units.grammar import plain
from radcalc.units.numbers import read_number
from radcalc.units.scale_table import SCALES, SIZES, Scale, named, usual
from radcalc.units.table import CELSIUS, resolve
from radcalc.units.unit import TEMPERATURE_ALONE, Dimension, Unit

RECIPROCAL = next(scale for scale in SCALES if not scale.steps)


class ScaleUnit(Unit):
    """A scale as a user wrote it, where a unit may stand: what its readings stand for is in `unit`.

    It counts as its unit for everything but its numbers; `others` are other readings of the text.
    """

    __slots__ = ("others", "scale", "unit")
    is_scale = True

    def __init__(self, text: str, scale: Scale, others: "tuple[ScaleUnit, ...]" = ()) -> None:
        """Hold the reading of `text`."""
        unit = resolve(scale.unit)
        super().__init__(text, unit.top, unit.bottom, unit.dimension, unit.atoms)
        self.unit = unit
        self.scale = scale
        self.others = others

    @property
    def assumption(self) -> str:
        """Return how a reading is read, in one line."""
        return self.describe()

    def describe(self, settable: bool = False) -> str:
        """Return how a reading is read; a constant of light meters may be one that can be given."""
        scale = self.scale
        text = f"{quote(self.text)}: {scale.inverse()}, {scale.meaning}"
        if scale.constant and scale.size == SIZES[scale.constant]:
            text += f", {usual(scale.constant, settable)}"
        return text

    def quantity(self, reading: Any) -> Any:
        """Return what a reading stands for, in `unit`."""
        reading_text = f"{reading:.12g} " if isinstance(reading, float) else ""
        reading_text += quote(self.text)
        if not self.scale.steps and maths.any_true(reading <= 0):
            is_shift = isinstance(reading, float) and reading < 0
            shift = "a difference, as filters have, and " if is_shift else ""
            raise NumberError(
                f"{reading_text} is {shift}the reciprocal of no temperature", "more than 0"
            )
        try:
            quantity = self.scale.quantity(reading)
        except (OverflowError, ZeroDivisionError):
            quantity = 0.0
        if maths.any_true((quantity < maths.SMALLEST) | (quantity - quantity != 0)):
            raise NumberError(
                f"{reading_text} is beyond what a number holds", "less extreme values"
            )
        return quantity

    def reading(self, quantity: Any) -> Any:
        """Return the reading of a quantity in `unit`, of which there is none for 0 and below."""
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
        """By how much the quantity in `unit` grows with the reading."""
        return self.scale.slope(reading)

    def measures(self, dimensions: Iterable[Dimension]) -> "ScaleUnit":
        """The reading of the text that measures one of the dimensions; this where none does."""
        wanted = tuple(dimensions)
        return next((scale for scale in (self, *self.others) if scale.dimension in wanted), self)

    def with_constants(self, values: dict[str, float]) -> "ScaleUnit":
        """Return the scale of a light meter with other constants than the usual ones [SI]."""
        others = tuple([other.with_constants(values) for other in self.others])
        scale = self.scale
        if scale.constant in values:
            scale = scale.of_meter(values[scale.constant])
        return ScaleUnit(self.text, scale, others)


def find(text: str) -> ScaleUnit | None:
    """Read the text of a scale; None where it is none."""
    text = " ".join(text.split())
    rows = named(plain(text))
    if not rows:
        return None
    others = tuple([ScaleUnit(text, row) for row in rows[1:]])
    return ScaleUnit(text, rows[0], others)


def resolve_any(text: str) -> Unit:
    """Read the text of a unit or of a scale.

    Raises UnitError for a text that is neither.
    """
    return find(text) or resolve(text)


def refuse_product(text: str, scale: str) -> None:
    """Refuse 2*10 dBm, which people read in two ways."""
    if "*" not in text:
        return  # nor has to begin with a number: (10±1) dBm
    number, end = read_number(text)
    if "*" in text[:end]:
        raise NumberError(
            f"'{quote(text)}' multiplies, and a reading of {quote(scale)} cannot be multiplied",
            f"{number:.12g} {quote(scale)} for one reading",
        )


def scale_of(unit: Unit) -> Scale | None:
    """Return the scale that stands where a unit may; None for a unit."""
    return unit.scale if isinstance(unit, ScaleUnit) else None


def amount_on(
    unit: Unit, text: str, reading: float, uncertainty: float, dimensions: Iterable[Dimension]
) -> Amount:
    """Return what a reading stands for, with the uncertainty that its own leads to."""
    assert isinstance(unit, ScaleUnit)
    scale = unit.measures(dimensions)
    quantity = scale.quantity(reading)
    assumptions = (scale.assumption,)
    if not uncertainty:
        return Amount(text, quantity, scale.unit, 0.0, assumptions, scale, reading)
    from radcalc.units.parts import Part, check_uncertainty

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
    """A unit such as 1/MK as the scale of temperatures that has the reciprocals."""
    return ScaleUnit(unit.text, RECIPROCAL._replace(size=unit.bottom / unit.top))


FAHRENHEIT = ("°f", "degf", "deg_f", "degree_fahrenheit", "degrees_fahrenheit", "fahrenheit")


def degree(text: str) -> Unit | None:
    """A degree Celsius or Fahrenheit, where a difference is meant; None for what is neither."""
    name = plain(text).lower().replace("° ", "°")
    name = name.replace(" ", "_").replace("-", "_")
    if name in CELSIUS:
        return Unit(text, 1, 1, TEMPERATURE_ALONE, ((name, 1),))
    return Unit(text, 5, 9, TEMPERATURE_ALONE, ((name, 1),)) if name in FAHRENHEIT else None


def resolve_given(text: str) -> Unit:
    """Read the unit of what was given, in which a degree is that of a difference."""
    return degree(text) or resolve_any(text)


def in_which(text: str, dimensions: Iterable[Dimension]) -> Unit:
    """Return the unit of what was typed as a reading, or in degrees that count a difference."""
    if scale := find(text):
        return scale.measures(dimensions).unit
    return resolve("K" if degree(text) else text)


def on(dimension: Dimension) -> list[Scale]:
    """Return the scales on which a quantity is read."""
    return [scale for scale in SCALES if resolve(scale.unit).dimension == dimension]


def names_of(dimension: Dimension) -> list[str]:
    """Their names."""
    return [scale.name for scale in on(dimension)]
