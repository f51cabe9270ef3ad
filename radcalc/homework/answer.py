"""Answers as learners type them, and tolerances."""

import math
from decimal import ROUND_HALF_DOWN, ROUND_HALF_UP, Context, Decimal
from typing import NamedTuple

from radcalc.errors import MINUS, ConditionError, NumberError, RadcalcError, add, option, quote
from radcalc.floats import divide
from radcalc.homework.wording import Translatable
from radcalc.inputs.quantities import MARKED
from radcalc.inputs.reading import read_as
from radcalc.quantities.symbols import ANY, Symbol
from radcalc.units import NUMBER, Unit
from radcalc.units.amounts import UNCERTAIN
from radcalc.units.numbers import read_number, typed_digits
from radcalc.units.scales import find, refuse_product
from radcalc.units.table import unit_of

DIGITS_OF_EXACT = 15
LEAST_MEANT = 2  # digits of a number that count in any case, even if they are zeros
PRINTED = 12  # digits of a right value, which has rounding errors in later ones


class Claim(NamedTuple):
    """The parts of an answer NAME=VALUE UNIT, and its rounding.

    Zeros at the end of an integer are significant, and `half_unit` is half a unit of the last
    digit.  In the search for mistakes they may be not significant, except among the first two
    digits: `widest` is then half a unit.  `uncertainty` is the standard uncertainty, in the unit.
    """

    text: str
    name: str
    value: float
    unit: str
    number: str
    digits: int
    half_unit: float
    widest: float = 0.0
    uncertainty: float = 0.0


def read_claim(text: str) -> Claim:
    """Read `[NAME=]VALUE[UNIT]`."""
    name, equals, value_text = text.partition("=")
    if not equals:
        name, value_text = "", text
    elif not name.strip():
        raise ConditionError(
            f"{option('check', quote(text))}: the name before = is missing",
            option("check", "illuminance=25lx"),
        )
    value_text = value_text.strip().replace(MINUS, "-")
    value_text, off = value_text.removeprefix(MARKED.get(name.strip(), "")), 0.0
    try:
        if any(mark in value_text for mark in UNCERTAIN):
            from radcalc.units.uncertain import read_uncertain

            if reading := read_uncertain(value_text):
                off, value_text = reading.uncertainty, reading.nominal
        if evaluated := _arithmetic(value_text):
            return Claim(text, name.strip(), *evaluated)
        value, end = read_number(value_text)
    except NumberError as error:
        raise NumberError(
            f"{option('check')}: {error.message}", f"{option('check', '25lx')}; {error.hint}"
        ) from None
    number, unit = value_text[:end], value_text[end:].strip()
    digits, half, widest = _digits(number, value)
    return Claim(text, name.strip(), value, unit, number, digits, half, widest, off)


def decimal(number: float, digits: int = DIGITS_OF_EXACT) -> Decimal:
    """Return a float as the decimal number that is printed with these digits."""
    return Decimal(f"{number:.{digits}g}")


def is_rounded(claim: Claim, right: float) -> bool:
    """Return whether an answer is the right value rounded to the digits typed.

    A value half way between two numbers may be rounded to either.
    """
    if not claim.value or not right:
        return False
    digits, claimed = min(claim.digits, DIGITS_OF_EXACT), decimal(claim.value)
    return any(
        Context(digits, rounding).create_decimal(decimal(right, PRINTED)) == claimed
        for rounding in (ROUND_HALF_UP, ROUND_HALF_DOWN)
    )


def _arithmetic(text: str) -> tuple[float, str, str, int, float, float] | None:
    """Evaluate an expression such as 2 * 12.5 lx; None if the text is a plain number.

    The result is value, unit, number, digits, half unit and widest, as in `Claim`.
    """
    try:
        _, end = read_number(text)
        unit_text = text[end:].strip()
        if unit_of(unit_text or "1"):
            return None
        if find(unit_text):
            refuse_product(text, unit_text)
            return None
    except NumberError:
        pass
    from radcalc.units.expressions import read_expression

    result = read_expression(text)
    if result is None:
        return None
    value, unit, off, _ = result
    half = abs(value) * off
    digits = min(DIGITS_OF_EXACT, max(1, -math.floor(math.log10(2 * off))))
    return value, unit.text if unit else "", f"{value:.12g}", digits, half, half


def _digits(number: str, value: float) -> tuple[int, float, float]:
    """Count the digits of a number; half a unit of the last digit, and of the last nonzero one."""
    typed = typed_digits(number)
    if typed is None:  # pi/6, 2*pi
        return DIGITS_OF_EXACT, abs(value) * 1e-9, abs(value) * 1e-9
    digits, power = typed[0].lstrip("0"), min(typed[1], 308)
    zeros = 0 if "." in number else len(digits) - len(digits.rstrip("0"))
    zeros = max(0, min(zeros, len(digits) - LEAST_MEANT))
    return max(1, len(digits)), 0.5 * 10.0**power, 0.5 * 10.0 ** min(power + zeros, 308)


class Diagnosis(NamedTuple):
    """A likely mistake: its name, a description, the right rule, and the first wrong step.

    `yours` is that step in the learner's own numbers, or ''.
    """

    mistake: str
    done: str
    right: str
    yours: str = ""


class Tolerance(NamedTuple):
    """A tolerance: relative, absolute in the unit of the answer, or in significant digits."""

    text: str
    kind: str
    size: float

    def holds(self, value: float, right: float) -> bool:
        """Return whether a value is near the right one, as computed or as printed."""
        if not math.isfinite(value):
            return False
        claimed = decimal(value)
        texts = {Decimal(repr(right)), decimal(right), decimal(right, PRINTED)}
        return any(abs(claimed - text) <= self._width(text) for text in texts)

    def width(self, right: float) -> float:
        """Return the largest allowed difference from the right value."""
        return float(self._width(Decimal(right)))

    def _width(self, right: Decimal) -> Decimal:
        size = decimal(self.size)
        if self.kind == "relative":
            return size * abs(right)
        if self.kind == "absolute":
            return size
        return Decimal(5).scaleb((right.adjusted() if right else 0) - int(self.size))


def read_tolerance(text: str, unit: Unit) -> Tolerance:
    """Read a tolerance: 1%, 0.01, 0.5lx or 3sf."""
    text = text.strip().lower() if text.strip().lower().endswith("sf") else text.strip()
    typed = option("tolerance", quote(text))
    hint = add("tolerance", "1%", "or a size such as 0.5lx, or 3sf for three significant digits")
    if text.endswith("sf"):
        if not (text[:-2].isascii() and text[:-2].isdecimal()) or not 1 <= int(text[:-2]) <= 15:
            raise ConditionError(f"{typed} is out of range", hint)
        count = int(text[:-2])
        digits = Translatable("within half a unit of digit {0}", count)
        return Tolerance(digits, "digits", count)
    takes = "a part or a quantity"
    symbol = Symbol("tolerance", "", (NUMBER, unit.dimension), "1%", limits=ANY, takes=takes)
    try:
        given = read_as(symbol, text)
    except RadcalcError as error:
        name = option("tolerance")
        raise ConditionError(f"{name}: {error.message.removeprefix(f'{name}: ')}", hint) from None
    if given.value < 0:
        raise ConditionError(f"{typed} is out of range", hint)
    if given.unit is None and given.value >= 1:
        raise ConditionError(f"the unit of {typed} is missing", hint)
    is_part = given.dimension == NUMBER and unit.dimension != NUMBER
    if is_part or given.unit is None or given.unit.text in ("%", "1"):
        return Tolerance(Translatable("within {0}", given.text), "relative", given.value)
    size = given.value * divide(unit.bottom, unit.top)
    return Tolerance(Translatable("within {0}", given.text), "absolute", size)
