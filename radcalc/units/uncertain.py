"""The grammar of values with a standard uncertainty: `100+-3 lx`, `100(3) lx`, `100 lx ± 3%`.

    VALUE ± UNCERTAINTY UNIT     (VALUE ± UNCERTAINTY) UNIT     VALUE UNIT ± UNCERTAINTY UNIT
    VALUE(DIGITS) UNIT           VALUE UNIT ± PERCENT%           numbers of an expression

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
SMALL = 2.0**-13  # a step of a number in an expression, relative to it
DECIMAL = r"((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)"
BEGIN = r"(?<![\w.])"  # of a number, and not of the end of one
LEAF = (
    rf"\(\s*{DECIMAL}\s*±\s*{DECIMAL}\s*\)"
    rf"|{BEGIN}(\d+\.?\d*|\.\d+)\((\d+\.?\d*)\)"
)
ARITHMETIC = r"[*/]\s*[\d.(]|\s[-+]\s"
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
        if (found := _with_expression(told)) is None:
            raise
        return found
    if found is None:
        return _with_expression(told)
    if found and found.uncertainty < 0:
        raise NumberError(f"'{quote(text)}' has an uncertainty below 0", HINT)
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


def _with_expression(text: str) -> Reading | None:
    """Read `(100±3) lx * (2.0±0.1) m2`: arithmetic, in which each number with a ± is a variable.

    The slope over each is that between two values beside its own.
    """
    import re

    if "," in text:
        return None  # a list, of which each value is read by itself
    pieces = re.split(LEAF, text)
    texts, leaves = pieces[::5], list(zip(*(iter(pieces[k::5]) for k in range(1, 5)), strict=True))
    found = [_leaf(*leaf) for leaf in leaves]
    rest = "".join(texts)
    if SIGN in rest and (found or re.search(ARITHMETIC, rest)):
        problem = f"'{quote(text)}' has a ± beside arithmetic without brackets"
        raise NumberError(problem, "each number with its ± in brackets: 2 * (100±3) lx")
    if not found or SIGN in rest:
        return None

    def value(moved: int = -1, shift: float = 0.0) -> tuple[float, Unit | None]:
        from radcalc.units.expressions import read_expression

        sizes = [size + shift * (k == moved) for k, (size, _) in enumerate(found)]
        filled = texts[0] + "".join(f"({s!r}){t}" for s, t in zip(sizes, texts[1:], strict=True))
        read = read_expression(filled)
        if read is None:
            raise NumberError(f"'{quote(text)}' is not a number and a unit", HINT)
        return read[0], read[1]

    number, unit = value()
    square = 0.0
    for k, (size, off) in enumerate(found):
        step = min(abs(size) * SMALL or off, off)
        if step:
            square += ((value(k, step)[0] - value(k, -step)[0]) / (2 * step) * off) ** 2
    nominal = f"{number!r} {unit.text if unit else ''}".strip()
    return Reading(number, unit, float(f"{square**0.5:.7g}"), nominal)


def _leaf(*parts: str | None) -> tuple[float, float]:
    """A number of an expression and its uncertainty: (A±B) or A(DIGITS)."""
    number, off, other, digits = parts
    if digits is None:
        return parse_number(number or ""), parse_number(off or "")
    reading = _with_digits(f"{other}({digits})")
    assert reading is not None
    return reading.number, reading.uncertainty


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
