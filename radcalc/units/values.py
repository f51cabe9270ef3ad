"""The values of expressions: exact ratios in coherent SI units, with the units that were typed."""

import math

from radcalc.errors import ExpressionError, UnitError
from radcalc.floats import divide
from radcalc.units import constants
from radcalc.units.compiled import CONSTANTS
from radcalc.units.numbers import DIGITS
from radcalc.units.table import PARTS, resolve
from radcalc.units.unit import (
    NUMBER,
    Dimension,
    Unit,
    lookup,
)

MAX_BITS = 40_000  # of a number's numerator or denominator: about 12 000 digits
KEPT = 1e-12  # largest relative error of a sum by cancellation of digits


class Value:
    """A number top / bottom in coherent SI units, with the typed units and their powers.

    `rounding` is the relative rounding error of the typed digits, `blur` that of functions.
    `had_units` is true also if all units cancelled: such a number takes no unit.
    """

    __slots__ = ("blur", "bottom", "dimension", "had_units", "rounding", "top", "units")

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
        self.top = top // common
        self.bottom = bottom // common
        self.dimension = dimension
        self.units = units or {}
        self.had_units = had_units or bool(units)
        self.rounding = rounding
        self.blur = blur
        if max(abs(self.top), self.bottom).bit_length() > MAX_BITS:
            raise ExpressionError("a number in the expression has too many digits", "fewer")

    def times(self, other: "Value", power: int = 1) -> "Value":
        """Return the product with the power of another value; refuse 0 in a denominator."""
        top, bottom = (other.top, other.bottom) if power > 0 else (other.bottom, other.top)
        if max(abs(top), bottom).bit_length() * abs(power) > MAX_BITS:
            raise ExpressionError("a number in the expression has too many digits", "fewer")
        if bottom == 0:
            raise ExpressionError("the expression divides by zero", "a number other than 0")
        if bottom < 0:
            top, bottom = -top, -bottom
        size = abs(power)
        units = dict(self.units)
        for name, exponent in other.units.items():
            units[name] = units.get(name, 0) + power * exponent
        return Value(
            self.top * top**size,
            self.bottom * bottom**size,
            tuple([a + power * b for a, b in zip(self.dimension, other.dimension, strict=True)]),
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
        return constants.quantity(self.dimension, self.units)

    def unit(self) -> Unit | None:
        """Return the unit for display, None for a bare number."""
        if self.has_constants:
            return constants.unit(self.dimension, self.units)
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
