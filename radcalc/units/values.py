"""Values: of expressions and of the constants in them, and of readings on scales.

Values of expressions and constants (`h*c/(500 nm)`) are exact ratios in coherent SI units, with the
units that were typed; those of constants are compiled from `light.txt`.  A short spelling may also
be a unit (h, g), or a number (e): `HOMONYMS`.  In a product with c or h, whose laws count cycles
and photons as 1, the target decides whether they are counted.

Units that are read through a function are scales, such as dBm: each is a row of `SCALES`.  With a
reference x0 in its unit, the reading n of a quantity x is

    n = zero + steps lg(x / x0)     with lb instead of lg for base 2
    n = x0 / x                      for steps = 0: reciprocal

so readings cannot be multiplied or added.
"""

import math
from collections.abc import Iterable, Mapping
from typing import Any

from radcalc import maths
from radcalc.errors import (
    ConversionError,
    ExpressionError,
    NumberError,
    RadcalcError,
    UnitError,
    correct,
    quote,
)
from radcalc.floats import SMALLEST, divide
from radcalc.units import (
    BASES,
    COUNT_AT,
    CYCLE_AT,
    LUMINOSITY_AT,
    MASS_AT,
    NUMBER,
    TEMPERATURE_ALONE,
    TIME_AT,
    WEIGHT_AT,
    Dimension,
    Unit,
    lookup,
)
from radcalc.units.compiled import CONSTANTS, NOTES, SPELLINGS_OF_CONSTANTS, WEIGHTS
from radcalc.units.dimensions import COHERENT, SUFFIXES, weight_of, weights_of
from radcalc.units.grammar import plain
from radcalc.units.numbers import DIGITS, Amount, read_number, times, word_at
from radcalc.units.scale_table import SCALES, SIZES, Scale, named, usual
from radcalc.units.table import CELSIUS, FAHRENHEIT, PARTS, resolve, unit_of

ANGLE_AT = BASES.index("angle")
LIGHT, PLANCK, REDUCED = "speed_of_light", "planck_constant", "reduced_planck_constant"
EULER = "e"
HOMONYMS = tuple([s for s in SPELLINGS_OF_CONSTANTS if s == EULER or lookup(s)])
BASE_UNITS = ("m", "kg", "s", "K", "rad", "cycle", "photon", "cd", "td", "A")  # as BASES
HEADS = {"e": "W", "v": "lm", "p": "mol"}  # units of the light that a weight is of


class OfConstants(Unit):
    """The coherent unit of an expression with constants, with their powers."""

    __slots__ = ("powers",)
    powers: dict[str, int]

    def fitting(self, dimension: Dimension) -> Unit | None:
        """Return the unit in another dimension that counts cycles and photons; None if unlike."""
        if dimension == self.dimension:
            return self
        free = _uncounted(self.powers)
        if any(
            a != b and place not in free
            for place, (a, b) in enumerate(zip(self.dimension, dimension, strict=True))
        ):
            return None
        photons = dimension[COUNT_AT] - self.dimension[COUNT_AT]
        if photons and photons != -_planck(self.powers):
            return None
        counted = "a photon" if photons else "a cycle"
        note = f"{counted} counts as 1 in a formula with c or h"
        return resolve(text_of(dimension)).of_class(Unit, *self.notes, note)


def value(name: str) -> float:
    """Return a constant in coherent SI, rounded once."""
    top, bottom, _ = CONSTANTS[name]
    return divide(top, bottom)


def plain_spelling(name: str) -> str:
    """Return the short spelling of a constant that is not ambiguous: h_planck."""
    return next(s for s, named in SPELLINGS_OF_CONSTANTS.items() if named == name)


def homonyms(text: str) -> list[str]:
    """Return the short spellings in a text that have another meaning too."""
    found, at = [], 0
    while at < len(text):
        word = word_at(text, at)
        if word in HOMONYMS:
            found.append(word)
        at += len(word) or 1
    return list(dict.fromkeys(found))


def quantity(dimension: Dimension, powers: dict[str, int]) -> Dimension:
    """Return the dimension of a product with constants, with cycles and angles counted as 1."""
    plain = list(dimension)
    if LIGHT in powers or PLANCK in powers or REDUCED in powers:
        plain[CYCLE_AT] = 0
    if REDUCED in powers:
        plain[ANGLE_AT] -= powers[REDUCED] if plain[ANGLE_AT] else 0
    return tuple(plain)


def unit(dimension: Dimension, units: dict[str, int]) -> OfConstants:
    """Return the unit for display of a product with constants."""
    plain = quantity(dimension, units)
    made = resolve(text_of(plain)).of_class(OfConstants)
    made.powers = {name: power for name, power in units.items() if name in CONSTANTS}
    made.notes += tuple([NOTES[name] for name in made.powers if name in NOTES])
    return made


def fit(source: Unit, dimension: Dimension) -> Unit:
    """Return the unit of an expression, with cycles and photons as a dimension counts them."""
    if not isinstance(source, OfConstants):
        return source
    return source.fitting(dimension) or source


def _planck(powers: dict[str, int]) -> int:
    return powers.get(PLANCK, 0) + powers.get(REDUCED, 0)


def _uncounted(powers: dict[str, int]) -> tuple[int, ...]:
    """Return the places in a dimension that count as 1 in a product with these constants."""
    places: tuple[int, ...] = ()
    if LIGHT in powers or _planck(powers):
        places = (CYCLE_AT,)
    if _planck(powers):
        places += (COUNT_AT,)
    return (*places, ANGLE_AT) if REDUCED in powers else places


def text_of(dimension: Dimension) -> str:
    """Return the text of the coherent unit of a dimension: J, W/m2/K, lm or (J.m)."""
    text = COHERENT.get(dimension, "")
    if text and resolve(text).dimension == dimension:
        return text
    powers = list(dimension)
    head = _head(dimension)
    if head:
        powers = [a - b for a, b in zip(dimension, resolve(head).dimension, strict=True)]
    over = [head] if head else []
    units = base_units(tuple(powers))
    over += [_raised(name, n) for name, n in units.items() if n > 0]
    under = [_raised(name, -n) for name, n in units.items() if n < 0]
    product = f"({'.'.join(over)})" if len(over) > 1 else "".join(over) or "1"
    return "/".join([product, *under])


def base_units(dimension: Dimension) -> dict[str, int]:
    """Return the base units of a dimension with their powers; a weight is a ratio: W_mel/W."""
    powers = {name: n for name, n in zip(BASE_UNITS, dimension, strict=False) if n}
    for place, power in weights_of(dimension).items():
        suffix = SUFFIXES[place]
        unit = HEADS[WEIGHTS[suffix][1]]
        powers[f"{unit}_{suffix}"] = power
        powers[unit] = powers.get(unit, 0) - power
    return powers


def _raised(name: str, power: int) -> str:
    return f"{name}{power}" if power > 1 else name


def _head(dimension: Dimension) -> str:
    """Return the derived unit in a dimension: W, J, lm, cd or none; with a weight: W_mel."""
    head = ""
    if dimension[MASS_AT] == 1:
        head = "W" if dimension[TIME_AT] == -3 else "J"
    elif dimension[LUMINOSITY_AT] == 1:
        head = "lm" if dimension[ANGLE_AT] == 2 else "cd"
    elif dimension[COUNT_AT] == 1 and dimension[WEIGHT_AT]:
        return f"photon_{suffix}" if (suffix := weight_of(dimension)) else ""
    suffix = weight_of(dimension)
    return f"{head}_{suffix}" if head and suffix else head


# Of a temperature times or over a number or another one, which its reciprocal would give unlike.
MULTIPLIED = (NUMBER, TEMPERATURE_ALONE, tuple([2 * power for power in TEMPERATURE_ALONE]))
KEPT = 1e-12  # largest relative error of a sum by cancellation of digits


class Value:
    """A number top / bottom in coherent SI units, with the typed units and their powers.

    `rounding` is the relative rounding error of the typed digits, `blur` that of functions.
    `had_units` is true also if all units cancelled: such a number takes no unit.  `is_mired`
    marks a temperature that was read as its reciprocal, in mired.
    """

    __slots__ = ("blur", "bottom", "dimension", "had_units", "is_mired", "rounding", "top", "units")

    def __init__(
        self,
        top: int,
        bottom: int = 1,
        dimension: Dimension = NUMBER,
        units: "dict[str, int] | None" = None,
        rounding: float = 0.0,
        had_units: bool = False,
        blur: float = 0.0,
    ) -> None:
        common = math.gcd(top, bottom) or 1
        self.top = times(1, top // common)
        self.bottom = times(1, bottom // common)
        self.dimension = dimension
        self.units = units or {}
        self.had_units = had_units or bool(units)
        self.rounding = rounding
        self.blur = blur
        self.is_mired = False

    def times(self, other: "Value", power: int = 1) -> "Value":
        """Return the product with the power of another value; refuse 0 in a denominator."""
        top, bottom = (other.top, other.bottom) if power > 0 else (other.bottom, other.top)
        if bottom == 0:
            raise ExpressionError("the expression divides by zero", "a number other than 0")
        if bottom < 0:
            top, bottom = -top, -bottom
        size = abs(power)
        units = dict(self.units)
        for name, exponent in other.units.items():
            units[name] = units.get(name, 0) + power * exponent
        powers = zip(self.dimension, other.dimension, strict=True)
        dimension = tuple([a + power * b for a, b in powers])
        if (self.is_mired or other.is_mired) and dimension in MULTIPLIED:
            problem = "the expression multiplies a reading in mired, which is a reciprocal"
            raise ExpressionError(problem, "the temperature in K, or one reading")
        return Value(
            times(self.top, top, size),
            times(self.bottom, bottom, size),
            dimension,
            {name: exponent for name, exponent in units.items() if exponent},
            self.rounding + size * other.rounding,
            self.had_units or other.had_units,
            self.blur + size * other.blur,
        )

    def plus(self, other: "Value", sign: int) -> "Value":
        """Return the sum, or the difference, in this value's unit."""
        a, b = self.top * other.bottom, sign * other.top * self.bottom
        rounding = blur = 0.0
        if a + b:
            for part, value in ((a, self), (b, other)):
                rounding += abs(divide(part, a + b)) * value.rounding if value.rounding else 0.0
                blur += abs(divide(part, a + b)) * value.blur if value.blur else 0.0
        if blur >= 1:  # sqrt(2)^2 - 2: 0 to all digits that are computed
            a, b, rounding, blur = 0, 0, 0.0, 0.0
        if blur > KEPT:
            problem = "a difference in the expression cancels too many digits of its terms"
            raise ExpressionError(problem, "terms that differ more")
        had_units = self.had_units or other.had_units
        bottom = self.bottom * other.bottom
        return Value(a + b, bottom, self.dimension, self.units, rounding, had_units, blur)

    @property
    def ratio(self) -> tuple[int, int, float]:
        """The number with its relative error."""
        return self.top, self.bottom, self.blur

    def is_bare(self) -> bool:
        return not self.units

    @property
    def has_constants(self) -> bool:
        return any(name in CONSTANTS for name in self.units)

    @property
    def quantity(self) -> Dimension:
        """The dimension, in which a cycle counts as 1 in a product with c or h."""
        if not self.has_constants:
            return self.dimension
        return quantity(self.dimension, self.units)

    def unit(self) -> Unit | None:
        """Return the unit for display, None for a bare number."""
        if self.has_constants:
            return unit(self.dimension, self.units)
        if self.dimension == NUMBER:
            (name, power), *more_units = self.units.items() or [("", 0)]
            if power == 1 and not more_units and is_part(name):
                return resolve(name)
            return resolve("1") if self.had_units else None
        units = {name: power for name, power in self.units.items() if not is_part(name)}
        text = unit_text(units)
        try:
            return resolve(text)
        except UnitError as error:
            if "multiplies light" not in error.message:  # the typed * makes it unambiguous
                raise
            return resolve(f"({text})")


def is_part(name: str) -> bool:
    """Return whether a unit is of parts: % or ppm."""
    entry = lookup(name)
    return entry is not None and entry[1] in PARTS


def unit_text(units: dict[str, int]) -> str:
    """Return the text of a product of units: lm.s/m2."""

    def factor(name: str, power: int) -> str:
        if power == 1:
            return name
        name = f"({name})" if name.endswith("-1") else name
        return f"{name}^{power}" if name[-1] in DIGITS else f"{name}{power}"

    over = [factor(name, power) for name, power in units.items() if power > 0]
    if not over:
        return ".".join([factor(name, power) for name, power in units.items()])
    under = [factor(name, -power) for name, power in units.items() if power < 0]
    return "/".join([".".join(over), *under])


class Term:
    """A term of a product: its value, its place in the text and its form."""

    __slots__ = ("end", "has_number", "middle", "start", "units", "value")

    def __init__(
        self, value: Value, start: int, middle: int, end: int, has_number: bool, units: int
    ) -> None:
        """The number of the text from `start` to `end` ends at `middle`."""
        self.value = value
        self.start, self.middle, self.end = start, middle, end
        self.has_number = has_number
        self.units = units  # count of units after the number


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

    def with_constants(self, values: Mapping[str, float]) -> "ScaleUnit":
        others = tuple([other.with_constants(values) for other in self.others])
        scale = self.scale
        if scale.constant and scale.constant in values:
            scale = scale.of_meter(values[scale.constant])
        return ScaleUnit(self.text, scale, others)


def find_scale(text: str) -> ScaleUnit | None:
    """Return the scale of a text; None for another text."""
    text = " ".join(text.split())
    rows = named(plain(text))
    if not rows:
        return None
    others = tuple([ScaleUnit(text, row) for row in rows[1:]])
    return ScaleUnit(text, rows[0], others)


def resolve_any(text: str) -> Unit:
    """Return the unit of a text, a scale or a word of growers; raise UnitError for other texts."""
    if unit := find_scale(text) or unit_of(text):
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


def on(dimension: Dimension) -> list[Scale]:
    """Return the scales of a dimension."""
    return [scale for scale in SCALES if resolve(scale.unit).dimension == dimension]


def names_of(dimension: Dimension) -> list[str]:
    """Return the names of the scales of a dimension."""
    return [scale.name for scale in on(dimension)]
