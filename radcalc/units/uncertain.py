"""The grammar of values with a standard uncertainty: `100+-3 lx`, `100(3) lx`, `100 lx ± 3%`.

    VALUE ± UNCERTAINTY UNIT     (VALUE ± UNCERTAINTY) UNIT     VALUE UNIT ± UNCERTAINTY UNIT
    VALUE(DIGITS) UNIT           VALUE UNIT ± PERCENT%

± may be typed as +- or +/-.  DIGITS are of the last digits of VALUE: 1.234(5) is 1.234±0.005; with
a point they stand for themselves: 1.234(0.005).
"""

from typing import Any, NamedTuple

from radcalc.errors import MINUS, NumberError, RadcalcError, UnitError, quote
from radcalc.units.amounts import SEPARATORS, SIGNS_OF_UNCERTAINTY
from radcalc.units.numbers import (
    DIGITS,
    SIGNS,
    parse_number,
    read_number,
    split_quantity,
    typed_digits,
)
from radcalc.units.scales import resolve_any, scale_of
from radcalc.units.table import Unit, divide

SIGN = "±"
TYPED = SIGNS_OF_UNCERTAINTY[1:]  # as people type the sign
PERCENT = "%"
OPERATORS = tuple("*/^+-")
MOST_DIGITS = 6  # of an exponent, with its sign
HINT = "100±3 lx, 100(3) lx or 100 lx ± 3%"


class Reading(NamedTuple):
    """A number with its standard uncertainty, both in a unit, or bare."""

    number: float
    unit: Unit | None
    uncertainty: float
    nominal: str = ""  # the text without the uncertainty


def signed(text: str) -> str:
    """The text with ± for each way to type it."""
    for typed in TYPED:
        text = text.replace(typed, SIGN)
    return text


def read_uncertain(text: str) -> Reading | None:
    """Read a value with its uncertainty; None where the text has not the form of one.

    Raises RadcalcError where it has the form and a part of it is wrong, or is read in two ways.
    """
    told = signed(text.strip())
    try:
        found = _with_sign(told) if SIGN in told else _with_digits(told)
    except RadcalcError:
        if any(mark in told for mark in "*/^("):  # an expression, in which it may have its place
            return None
        raise
    if found and found.uncertainty < 0:
        raise NumberError(f"'{quote(text)}' has an uncertainty below 0", HINT)
    if found is None:
        return None
    head = told.lstrip("(")
    unit = found.unit.text if found.unit else ""
    return found._replace(nominal=f"{head[: read_number(head)[1]]}{unit}")


def _with_sign(text: str) -> Reading | None:
    if text.count(SIGN) > 1:
        return None
    if text.startswith("("):
        inside, closed, behind = text[1:].partition(")")
        if not closed or SIGN not in inside or "(" in inside:
            return None
        power, behind = _power_of_ten(behind)
        if behind[:1] in OPERATORS:
            return None
        if not behind and not power:
            return _with_sign(inside)
        value, uncertainty = (_times(part.strip(), power) for part in inside.split(SIGN))
        return Reading(value, resolve_any(behind) if behind else None, uncertainty)
    left, right = (part.strip() for part in text.split(SIGN))
    value, unit_text = split_quantity(left)
    uncertainty, behind = split_quantity(right)
    if unit_text:
        return _of_quantity(text, value, resolve_any(unit_text), uncertainty, behind)
    if behind == PERCENT:
        ways = f"({left}±{right[:-1].strip()})%, or {left}±{abs(value) * uncertainty / 100:.6g}"
        raise NumberError(f"'{quote(text)}' can be read in two ways", quote(ways))
    if behind.startswith(PERCENT):
        return Reading(value, resolve_any(behind[1:].strip()), abs(value) * uncertainty / 100)
    return Reading(value, resolve_any(behind) if behind else None, uncertainty)


def _of_quantity(text: str, value: float, unit: Unit, number: float, behind: str) -> Reading:
    """A value with its unit, beside an uncertainty with its own."""
    if not behind:
        better = f"{value:.15g}±{number:.15g} {unit.text}"
        raise UnitError(f"the uncertainty of '{quote(text)}' has no unit", quote(better))
    if behind == PERCENT and unit.is_scale:
        better = f"an uncertainty in {quote(unit.text)}"
        raise UnitError(f"'{quote(text)}' has a part of a reading for its uncertainty", better)
    if behind == PERCENT and unit.text == PERCENT:
        both = f"({value:.15g}±{number:.15g})%"
        raise NumberError(
            f"'{quote(text)}' can be read in two ways",
            f"{both}, or ({value:.15g}±{abs(value) * number / 100:.6g})%",
        )
    if behind == PERCENT:
        return Reading(value, unit, abs(value) * number / 100)
    other = resolve_any(behind)
    if other.dimension != unit.dimension or scale_of(other) != scale_of(unit):
        raise UnitError(
            f"'{quote(text)}' has an uncertainty in another quantity than its value",
            f"an uncertainty in {quote(unit.text)}",
        )
    ratio = divide(other.top * unit.bottom, other.bottom * unit.top)
    return Reading(value, unit, number * ratio)


def _with_digits(text: str) -> Reading | None:
    """Read 100(3) lx."""
    number, opened, rest = text.partition("(")
    inside, closed, behind = rest.partition(")")
    typed = typed_digits(number)
    if not opened or not closed or typed is None or "e" in number.lower():
        return None
    if not inside or not set(inside) <= set(f"{DIGITS}.") or set(inside) == {"."}:
        return None
    power, behind = _power_of_ten(behind)
    if behind[:1] in OPERATORS or behind[:1] == "(":
        return None
    last = 0 if "." in inside else typed[1]
    unit = resolve_any(behind) if behind else None
    return Reading(_times(number, power), unit, _times(inside, power + last))


def _times(number: str, power: int) -> float:
    """A number times a power of ten, rounded once where it is a decimal."""
    if not power:
        return parse_number(number)
    if typed_digits(number) is None or "e" in number.lower():
        return parse_number(number) * 10.0**power
    return parse_number(f"{number}e{power}")


def _power_of_ten(text: str) -> tuple[int, str]:
    """The power of ten that e6 behind a bracket is, and the rest of the text."""
    end = 2 if text[1:2] in tuple(SIGNS) else 1
    first = end
    while text[end : end + 1] in tuple(DIGITS):
        end += 1
    if text[:1] not in ("e", "E") or not first < end <= MOST_DIGITS:
        return 0, text.strip()
    return int(text[1:end].replace(MINUS, "-")), text[end:].strip()


def join_words(words: list[str]) -> list[str]:
    """Words of which those of a value and its uncertainty are one: `100 ± 3 lx fc`.

    The unit that stands behind both remains a word of its own.
    """
    marked = next(k for k, word in enumerate(words) if SIGN in signed(word))
    if any(word in SEPARATORS for word in words):
        return words  # what stands before one is read as a whole
    end = marked + 1
    if signed(words[marked]).endswith(SIGN):  # the number is the next word
        end += 1
    left, _, right = signed(" ".join(words[:end])).partition(SIGN)
    has_unit = split_quantity(left)[1] != "" if not left.startswith("(") else False
    behind = words[end : end + 1]
    if (
        has_unit
        and right.strip()[-1:] in tuple(DIGITS)
        and (behind == [PERCENT] or len(words) > end + 1 or behind == [split_quantity(left)[1]])
    ):
        end += 1  # the unit of the uncertainty
    elif not has_unit and right.endswith(PERCENT) and behind:
        end += 1
    return [" ".join(words[:end]), *words[end:]]


def variable(number: float, uncertainty: float, name: str = "") -> Any:
    """A variable of the `uncertainties` package, independent of every other."""
    from uncertainties import ufloat  # type: ignore[import-untyped]

    return ufloat(number, uncertainty, name or None)
