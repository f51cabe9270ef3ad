"""The grammar of values with a standard uncertainty: `100+-3 lx`, `100(3) lx`, `100 lx ± 3%`.

    VALUE ± UNCERTAINTY UNIT     (VALUE ± UNCERTAINTY) UNIT     VALUE UNIT ± UNCERTAINTY UNIT
    VALUE(DIGITS) UNIT           VALUE UNIT ± PERCENT%           numbers of an expression

± may be typed as +- or +/-.  DIGITS are of the last digits of VALUE: 1.234(5) is 1.234±0.005; with
a point they stand for themselves: 1.234(0.005).
"""

import math
from collections.abc import Callable
from contextlib import suppress
from functools import partial
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
from radcalc.units.slopes import slopes
from radcalc.units.table import NUMBER, Dimension, Unit, divide

SIGN = "±"
TYPED = SIGNS_OF_UNCERTAINTY[1:]  # as people type the sign
PERCENT = "%"
OPERATORS = tuple("*/^+-")
MOST_TRIED = 3  # places for a bracket
MOST_DIGITS = 6  # of an exponent, with its sign
LEAST, MOST = 1e-150, 1e150  # uncertainties whose squares are numbers
DECIMAL = r"(?:\d+\.?\d*|\.\d+)"
BEGIN = r"(?<![\w.])"  # of a number, and not of the end of one
LEAF = rf"(?:\([^()±]*±[^()±]*\)|{BEGIN}{DECIMAL}\({DECIMAL}\))(?:[eE][-+]?\d+(?!\w))?"
OPERATOR = r"[*/×·⋅÷]|\s[-+]\s|(?<![eE^*])\+"
ARITHMETIC = rf"(?:{OPERATOR})\s*[\d.(]"
BRACKETS = "each number with its ± in brackets: 2 * (100±3) lx"
HINT = "100±3 lx, 100(3) lx or 100 lx ± 3%"


class Part(NamedTuple):
    """What follows of an uncertain number of an expression, or of a reading on a scale.

    Its text; what it adds to the uncertainty, with a sign; and a function that gives what the
    whole comes to where the number is moved by so many of its uncertainties, from -1 to 1; None
    where there is no such value.
    """

    text: str
    size: float
    at: Callable[[float], float | None]


class Reading(NamedTuple):
    """A number with its standard uncertainty, both in a unit, or bare.

    `parts` are those of the numbers of an expression.
    """

    number: float
    unit: Unit | None
    uncertainty: float
    nominal: str = ""  # the text without the uncertainty
    parts: tuple[Part, ...] = ()


class _Beside(NumberError):
    """Arithmetic beside a ± that stands in no bracket of its own."""

    def __init__(self, text: str) -> None:
        super().__init__(f"'{quote(text)}' has a ± beside arithmetic without brackets", BRACKETS)
        self.text = text


def signed(text: str) -> str:
    """The text with ± for each way to type it."""
    for typed in TYPED:
        text = text.replace(typed, SIGN)
    return text


def read_uncertain(text: str) -> Reading | None:
    """Read a value with its uncertainty; None where the text has not the form of one.

    Raises RadcalcError where it has the form and a part of it is wrong, or is read in two ways.
    """
    try:
        return _read(signed(text.strip()))
    except _Beside as error:
        error.hint = " or ".join(map(quote, _ways(error.text))) or error.hint
        raise


def _read(text: str) -> Reading | None:
    try:
        found = _with_one(text)
    except RadcalcError:
        if (found := _with_expression(text)) is None:
            raise
        return found
    if found is None:
        return _with_expression(text)
    if found.uncertainty < 0:
        raise NumberError(f"'{quote(text)}' has an uncertainty below 0", HINT)
    hold(found.uncertainty, text)
    head = text.lstrip("( ")
    unit = found.unit.text if found.unit else ""
    return found._replace(nominal=f"{head[: read_number(head)[1]]}{unit}")


def _with_one(text: str) -> Reading | None:
    """Read a value with one uncertainty."""
    return _with_sign(text) if SIGN in text else _with_digits(text)


def _is_product(text: str) -> bool:
    """Whether the number that a text begins with is more than one."""
    return not {"*", "/"}.isdisjoint(text[: read_number(text)[1]])


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
        parts = [part.strip() for part in inside.split(SIGN)]
        if any(map(_is_product, parts)):
            raise _Beside(inside)
        value, uncertainty = (_times(part, power) for part in parts)
        return Reading(value, resolve_any(behind) if behind else None, uncertainty)
    left, right = (part.strip() for part in text.split(SIGN))
    value, unit_text = split_quantity(left)
    uncertainty, behind = split_quantity(right)
    if _is_product(left) or _is_product(right):
        raise _Beside(text)
    if unit_text:
        return _of_quantity(text, value, resolve_any(unit_text), uncertainty, behind)
    if behind == PERCENT:
        ways = f"({left}±{right[:-1].strip()})%, or {left}±{abs(value) * uncertainty / 100:.6g}"
        raise NumberError(f"'{quote(text)}' can be read in two ways", quote(ways))
    if behind.startswith(PERCENT):
        unit = resolve_any(behind[1:].strip())
        return Reading(value, unit, _part_of(text, value, uncertainty, unit))
    return Reading(value, resolve_any(behind) if behind else None, uncertainty)


def _of_quantity(text: str, value: float, unit: Unit, number: float, behind: str) -> Reading:
    """A value with its unit, beside an uncertainty with its own."""
    if not behind:
        better = f"{value:.15g}±{number:.15g} {unit.text}"
        raise UnitError(f"the uncertainty of '{quote(text)}' has no unit", quote(better))
    if behind == PERCENT and unit.text == PERCENT:
        both = f"({value:.15g}±{number:.15g})%"
        raise NumberError(
            f"'{quote(text)}' can be read in two ways",
            f"{both}, or ({value:.15g}±{abs(value) * number / 100:.6g})%",
        )
    if behind == PERCENT:
        return Reading(value, unit, _part_of(text, value, number, unit))
    other = resolve_any(behind)
    if other.dimension != unit.dimension or scale_of(other) != scale_of(unit):
        raise UnitError(
            f"'{quote(text)}' has an uncertainty in another quantity than its value",
            f"an uncertainty in {quote(unit.text)}",
        )
    ratio = divide(other.top * unit.bottom, other.bottom * unit.top)
    return Reading(value, unit, number * ratio)


def _part_of(text: str, value: float, percent: float, unit: Unit) -> float:
    """The uncertainty that is so many percent of a value, which no reading on a scale has."""
    if unit.is_scale:
        better = f"an uncertainty in {quote(unit.text)}"
        raise UnitError(f"'{quote(text)}' has a part of a reading for its uncertainty", better)
    part = abs(value) * percent / 100
    if value and percent and not part:
        hold(math.nan, text)
    return part


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

    from radcalc.units.expressions import Calculator, Leaves, Value, read_expression
    from radcalc.units.grammar import plain

    if "," in text:
        return None  # a list, of which each value is read by itself
    text = plain(text)
    leaves = list(re.finditer(LEAF, text))
    rest = re.sub(LEAF, "", text)
    if SIGN in rest and (leaves or re.search(ARITHMETIC, rest)):
        raise _Beside(text)
    if not leaves or SIGN in rest:
        return None
    found = [_leaf(leaf[0]) for leaf in leaves]

    def whole(moved: int = -1, shift: float = 0.0) -> tuple[float, Unit | None]:
        places: Leaves = {}
        for k, (leaf, one) in enumerate(zip(leaves, found, strict=True)):
            size = Calculator(repr(one.number)).sum()
            if k == moved:
                size = size.plus(Value(*shift.as_integer_ratio()), 1)
            unit = one.unit and Calculator(text).unit(one.unit.text, number=size)
            places[leaf.start()] = leaf.end(), size.times(unit) if unit else size
        read = read_expression(text, places)
        if read is None:
            raise NumberError(f"'{quote(text)}' is not a number and a unit", HINT)
        return read[0], read[1]

    number, unit = whole()
    parts = []
    for k, one in enumerate(found):
        if one.uncertainty:
            told = _inside(leaves[k][0])
            parts.append(_part(text, told, number, one, partial(whole, k)))
    off = float(f"{math.hypot(*(part.size for part in parts)):.7g}")
    hold(off, text)
    nominal = f"{number!r} {unit.text if unit else ''}".strip()
    return Reading(number, unit, off, nominal, tuple(parts))


def _part(
    text: str,
    told: str,
    number: float,
    leaf: Reading,
    whole: Callable[[float], tuple[float, Unit | None]],
) -> Part:
    """What follows of a number of an expression; `whole` is that where it is moved by so much."""
    why = ""

    def at(shift: float) -> dict[str, float]:
        nonlocal why
        try:
            return {"": whole(shift)[0]}
        except RadcalcError as error:
            why = f": {error.message}"
            return {}

    off = leaf.uncertainty
    slope = slopes(at, {"": number}, abs(leaf.number), off)[""]
    if slope is None:
        problem = f"the uncertainty of '{quote(told)}' cannot be carried through '{quote(text)}'"
        raise NumberError(f"{problem}{why}", "the same without it")
    return Part(told, float(f"{slope * off:.7g}"), lambda times: at(times * off).get(""))


def _leaf(text: str) -> Reading:
    """A number of an expression and its uncertainty: (100±3), (100±3 lx) or 100(3)."""
    found = _with_one(text)
    if found is None:
        raise NumberError(f"'{quote(text)}' is not a number and its uncertainty", HINT)
    if found.uncertainty < 0:
        raise NumberError(f"'{quote(text)}' has an uncertainty below 0", HINT)
    return found


def _inside(text: str) -> str:
    """The text without the brackets around it."""
    return text[1:-1] if text[0] == "(" and text[-1] == ")" else text


def _ways(text: str) -> list[str]:
    """How arithmetic beside a ± can be read: brackets around its numbers, and sizes of both sides.

    Those are left out that cannot be read themselves.
    """
    import re

    from radcalc.units.amounts import split_value

    masked = re.sub(LEAF, lambda leaf: "_" * len(leaf[0]), text)
    if masked.count(SIGN) != 1:
        return []
    at = masked.index(SIGN)
    left, right = text[:at], text[at + 1 :]
    sizes = ""
    with suppress(RadcalcError):
        (value, unit), (off, behind) = split_value(left.strip()), split_value(right.strip())
        sizes = f"{value:.12g}±{off:.12g} {unit or behind}".strip()
        if unit and behind:
            sizes = f"{value:.12g} {unit} ± {off:.12g} {behind}"
    as_sizes = _meant(sizes)
    begins = [one.start() for one in re.finditer(BEGIN + DECIMAL, left)]
    number = re.match(rf"\s*{DECIMAL}(?:[eE][-+]?\d+)?", right)
    ends = [one.start() for one in re.finditer(OPERATOR, right)]
    closes = [number.end(), *ends[:MOST_TRIED], len(right)] if number else []
    for begin in begins[: -MOST_TRIED - 1 : -1]:
        for end in closes:
            inside = text[begin : at + 1 + end]
            behind = inside[len(inside.rstrip()) :] + right[end:]
            way = f"{text[:begin]}({inside.rstrip()}){behind}"
            meant = _meant(way)
            if meant and as_sizes and meant[1] != as_sizes[1]:
                continue  # 100 lx * 2 ± 3 lx is no product of two illuminances
            if meant:
                return [one[0] for one in (meant, as_sizes) if one]
    return [as_sizes[0]] if as_sizes else []


def _meant(text: str) -> tuple[str, Dimension] | None:
    """The text, or the first of its two readings, and what it measures; None where it has none."""
    try:
        found = _read(text)
    except RadcalcError as error:
        first = error.hint.partition(" or ")[0]
        return (
            _meant(first)
            if "two ways" in error.message and first.count("(") > text.count("(")
            else None
        )
    return (text, found.unit.dimension if found.unit else NUMBER) if found else None


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
    has_unit = _has_unit(left)
    behind = words[end : end + 1]
    if (
        has_unit
        and typed_digits(right.strip())
        and (behind == [PERCENT] or len(words) > end + 1 or behind == [split_quantity(left)[1]])
    ):
        end += 1  # the unit of the uncertainty
    elif not has_unit and right.endswith(PERCENT) and behind:
        is_apart = left.lstrip().startswith("(")  # (100 ± 3)%
        if not is_apart and (len(words) > end + 1 or not _is_ratio(behind[0])):
            end += 1  # the unit of 100 ± 3% lx
    return [" ".join(words[:end]), *words[end:]]


def _has_unit(text: str) -> bool:
    """Whether a value has a unit, and no bracket around it."""
    try:
        return not text.startswith("(") and split_quantity(text)[1] != ""
    except NumberError:  # sqrt(4.0
        return False


def _is_ratio(text: str) -> bool:
    """Whether a text is a unit of ratios, which may be the target of (50 ± 5)%."""
    try:
        return resolve_any(text).dimension == NUMBER
    except UnitError:
        return False


def hold(off: float, text: str = "") -> None:
    """Refuse an uncertainty, of a text or of a result, whose square is beyond what floats hold."""
    if off and not LEAST <= off <= MOST:
        told = f"'{quote(text)}'" if text else "a result"
        problem = f"the uncertainty of {told} is beyond what radcalc reckons with"
        raise NumberError(problem, f"an uncertainty from {LEAST:g} to {MOST:g}")


def variable(number: float, uncertainty: float, name: str = "") -> Any:
    """A variable of the `uncertainties` package, independent of every other."""
    from uncertainties import ufloat  # type: ignore[import-untyped]

    return ufloat(number, uncertainty, name or None)
