"""The values of expressions and of the constants in them: `h*c/(500 nm)`.

Values are exact ratios in coherent SI units, with the units that were typed; those of constants are
compiled from `light.txt`.

A short spelling may also be a unit (h, g), or a number (e): `HOMONYMS`.  In a product with c or h,
whose laws count cycles and photons as 1, the target decides whether they are counted.
"""

import math

from radcalc.errors import ExpressionError, UnitError
from radcalc.floats import divide
from radcalc.units import (
    BASES,
    COUNT_AT,
    CYCLE_AT,
    LUMINOSITY_AT,
    MASS_AT,
    NUMBER,
    TIME_AT,
    Dimension,
    Unit,
    lookup,
)
from radcalc.units.compiled import CONSTANTS, NOTES, SPELLINGS_OF_CONSTANTS
from radcalc.units.dimensions import COHERENT
from radcalc.units.numbers import DIGITS, word_at
from radcalc.units.table import PARTS, resolve

ANGLE_AT = BASES.index("angle")
LIGHT, PLANCK, REDUCED = "speed_of_light", "planck_constant", "reduced_planck_constant"
EULER = "e"
HOMONYMS = tuple([s for s in SPELLINGS_OF_CONSTANTS if s == EULER or lookup(s)])
BASE_UNITS = ("m", "kg", "s", "K", "rad", "cycle", "photon", "cd", "td", "A")  # as BASES


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
        return resolve(_text(dimension)).of_class(Unit, *self.notes, note)


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
    made = resolve(_text(plain)).of_class(OfConstants)
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


def _text(dimension: Dimension) -> str:
    """Return the text of the coherent unit of a dimension: J, W/m2/K, lm or (J.m)."""
    text = COHERENT.get(dimension, "")
    if text and resolve(text).dimension == dimension:
        return text
    powers = list(dimension)
    head = _head(dimension)
    if head:
        powers = [a - b for a, b in zip(dimension, resolve(head).dimension, strict=True)]
    over = [head] if head else []
    over += [_raised(name, n) for name, n in zip(BASE_UNITS, powers, strict=True) if n > 0]
    under = [_raised(name, -n) for name, n in zip(BASE_UNITS, powers, strict=True) if n < 0]
    product = f"({'.'.join(over)})" if len(over) > 1 else "".join(over) or "1"
    return "/".join([product, *under])


def _raised(name: str, power: int) -> str:
    return f"{name}{power}" if power > 1 else name


def _head(dimension: Dimension) -> str:
    """Return the derived unit in a dimension: W, J, lm, cd or none."""
    if dimension[MASS_AT] == 1:
        return "W" if dimension[TIME_AT] == -3 else "J"
    if dimension[LUMINOSITY_AT] == 1:
        return "lm" if dimension[ANGLE_AT] == 2 else "cd"
    return ""


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
