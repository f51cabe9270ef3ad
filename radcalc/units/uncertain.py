"""The grammar of values with a standard uncertainty: `100+-3 lx`, `100(3) lx`, `100 lx ± 3%`.

    VALUE ± UNCERTAINTY UNIT     (VALUE ± UNCERTAINTY) UNIT     VALUE UNIT ± UNCERTAINTY UNIT
    VALUE(DIGITS) UNIT           VALUE UNIT ± PERCENT%           numbers of an expression

± may be typed as +- or +/-.  DIGITS apply to the last digits of VALUE: 1.234(5) is 1.234±0.005;
with a point they are the uncertainty itself: 1.234(0.005).
"""

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial
from typing import Any, NamedTuple

from radcalc import errors
from radcalc.errors import quote
from radcalc.floats import divide
from radcalc.units import NUMBER, Dimension, Unit
from radcalc.units.functions import Part, check_uncertainty, slopes
from radcalc.units.grammar import TO
from radcalc.units.numbers import (
    DIGITS,
    SIGNS,
    SIGNS_OF_UNCERTAINTY,
    parse_number,
    read_number,
    split_quantity,
    typed_digits,
)
from radcalc.units.values import ScaleUnit, resolve_any, scale_of

SIGN = "±"
TYPED = SIGNS_OF_UNCERTAINTY[1:]  # other spellings of the sign
PERCENT = "%"
OPERATORS = tuple("*/^+-")
MOST_TRIED = 3  # possible places of a bracket
MOST_DIGITS = 6  # of an exponent, with its sign
DECIMAL = r"(?:\d+\.?\d*|\.\d+)"
BEGIN = r"(?<![\w.])"  # of a number, not inside a number or a name
LEAF = rf"(?:\([^()±]*±[^()±]*\)|{BEGIN}{DECIMAL}\({DECIMAL}\))(?:[eE][-+]?\d+(?!\w))?"
OPERATOR = r"[*/×·⋅÷]|\s[-+]\s|(?<![eE^*])\+"
ARITHMETIC = rf"(?:{OPERATOR})\s*[\d.(]"
BRACKETS = "each number with its ± in brackets: 2 * (100±3) lx"
HINT = "100±3 lx, 100(3) lx or 100 lx ± 3%"


class Reading(NamedTuple):
    """A number with its standard uncertainty, both in a unit or bare.

    `parts` are the contributions of the numbers of an expression.
    """

    number: float
    unit: Unit | None
    uncertainty: float
    nominal: str = ""  # the text without the uncertainty
    parts: tuple[Part, ...] = ()


class _Beside(errors.NumberError):
    """Error for a ± in arithmetic without brackets around its number."""

    def __init__(self, text: str) -> None:
        super().__init__(f"'{quote(text)}' has a ± in arithmetic without brackets", BRACKETS)
        self.text = text


def signed(text: str) -> str:
    """Return the text with ± for each of its other spellings."""
    for typed in TYPED:
        text = text.replace(typed, SIGN)
    return text


def read_uncertain(text: str, dimensions: Sequence[Dimension] = ()) -> Reading | None:
    """Read a value with its uncertainty; None for a text without that form.

    The dimensions that are asked for decide between two readings of an expression.
    """
    try:
        return _read(signed(text.strip()), tuple(dimensions))
    except _Beside as error:
        raise error.reworded(hint=errors.corrections(error.text, *_ways(error.text))) from None


def _read(text: str, dimensions: tuple[Dimension, ...] = ()) -> Reading | None:
    try:
        reading = _with_one(text)
    except errors.RadcalcError:
        if (reading := _with_expression(text, dimensions)) is None:
            raise
        return reading
    if reading is None:
        return _with_expression(text, dimensions)
    if reading.uncertainty < 0:
        raise errors.NumberError(f"'{quote(text)}' has a negative uncertainty", HINT)
    check_uncertainty(reading.uncertainty, text)
    head = text.lstrip("( ")
    unit = reading.unit.text if reading.unit else ""
    return reading._replace(nominal=f"{head[: read_number(head)[1]]}{unit}")


def _with_one(text: str) -> Reading | None:
    return _with_sign(text) if SIGN in text else _with_digits(text)


def _is_product(text: str) -> bool:
    return not {"*", "/"}.isdisjoint(text[: read_number(text)[1]])


def _with_sign(text: str) -> Reading | None:
    """Return the reading of VALUE±UNCERTAINTY UNIT; None if the text has another form."""
    if text.count(SIGN) > 1:
        return None
    if text.startswith("("):
        inside, closed, after = text[1:].partition(")")
        if not closed or SIGN not in inside or "(" in inside:
            return None
        power, after = _power_of_ten(after)
        if after[:1] in OPERATORS:
            return None
        if not after and not power:
            return _with_sign(inside)
        parts = [part.strip() for part in inside.split(SIGN)]
        if any(map(_is_product, parts)):
            raise _Beside(inside)
        value, uncertainty = (_times(part, power) for part in parts)
        return Reading(value, resolve_any(after) if after else None, uncertainty)
    value_text, uncertainty_text = (part.strip() for part in text.split(SIGN))
    value, unit_text = split_quantity(value_text)
    uncertainty, after = split_quantity(uncertainty_text)
    if _is_product(value_text) or _is_product(uncertainty_text):
        raise _Beside(text)
    if unit_text:
        return _of_quantity(text, value, resolve_any(unit_text), uncertainty, after)
    if after == PERCENT:
        as_percents = f"({value_text}±{uncertainty_text[:-1].strip()})%"
        as_part = f"{value_text}±{abs(value) * uncertainty / 100:.6g}"
        raise errors.NumberError(
            errors.ambiguous(text), errors.corrections(text, as_percents, as_part)
        )
    if after.startswith(PERCENT):
        unit = resolve_any(after[1:].strip())
        return Reading(value, unit, _part_of(text, value, uncertainty, unit))
    return Reading(value, resolve_any(after) if after else None, uncertainty)


def _of_quantity(
    text: str, value: float, unit: Unit, number: float, unit_of_uncertainty: str
) -> Reading:
    """Return the reading of VALUE UNIT±UNCERTAINTY UNIT, with one unit for both."""
    if not unit_of_uncertainty:
        better = errors.correct(text, f"{value:.15g}±{number:.15g} {unit.text}")
        raise errors.UnitError(f"the unit of the uncertainty of '{quote(text)}' is missing", better)
    if unit_of_uncertainty == PERCENT and unit.text == PERCENT:
        as_percents = f"({value:.15g}±{number:.15g})%"
        as_part = f"({value:.15g}±{abs(value) * number / 100:.6g})%"
        raise errors.NumberError(
            errors.ambiguous(text), errors.corrections(text, as_percents, as_part)
        )
    if unit_of_uncertainty == PERCENT:
        return Reading(value, unit, _part_of(text, value, number, unit))
    other_unit = resolve_any(unit_of_uncertainty)
    if other_unit.dimension != unit.dimension or scale_of(other_unit) != scale_of(unit):
        raise errors.UnitError(
            f"the value and the uncertainty of '{quote(text)}' are in units of different "
            "quantities",
            f"an uncertainty in {quote(unit.text)}",
        )
    ratio = divide(other_unit.top * unit.bottom, other_unit.bottom * unit.top)
    return Reading(value, unit, number * ratio)


def _part_of(text: str, value: float, percent: float, unit: Unit) -> float:
    """Return a percentage of a value as its uncertainty; raise for readings on a scale."""
    if unit.is_scale:
        better = f"an uncertainty in {quote(unit.text)}"
        raise errors.UnitError(
            f"'{quote(text)}' has a percentage of a reading as uncertainty", better
        )
    part = abs(value) * percent / 100
    if value and percent and not part:
        check_uncertainty(math.nan, text)
    return part


def _with_digits(text: str) -> Reading | None:
    """Read 100(3) lx."""
    number, opened, after_number = text.partition("(")
    inside, closed, after = after_number.partition(")")
    typed = typed_digits(number)
    if not opened or not closed or typed is None or "e" in number.lower():
        return None
    if not inside or not set(inside) <= set(f"{DIGITS}.") or set(inside) == {"."}:
        return None
    power, after = _power_of_ten(after)
    if after[:1] in OPERATORS or after[:1] == "(":
        return None
    last = 0 if "." in inside else typed[1]
    unit = resolve_any(after) if after else None
    return Reading(_times(number, power), unit, _times(inside, power + last))


def _with_expression(text: str, dimensions: tuple[Dimension, ...]) -> Reading | None:
    """Read `(100±3) lx * (2.0±0.1) m2`: arithmetic with each number with a ± as a variable."""
    import re

    from radcalc.units.expressions import Calculator, Leaves, read_expression
    from radcalc.units.grammar import plain
    from radcalc.units.values import Value

    if "," in text:
        return None  # a list: its values are read separately
    text = plain(text)
    leaves = list(re.finditer(LEAF, text))
    other_text = re.sub(LEAF, "", text)
    if SIGN in other_text and (leaves or re.search(ARITHMETIC, other_text)):
        raise _Beside(text)
    if not leaves or SIGN in other_text:
        return None
    readings = [_leaf(leaf[0]) for leaf in leaves]

    def evaluate(moved: int = -1, shift: float = 0.0) -> tuple[float, Unit | None]:
        places: Leaves = {}
        for k, (leaf, reading) in enumerate(zip(leaves, readings, strict=True)):
            size = Calculator(repr(reading.number)).sum()
            if k == moved:
                size = size.plus(Value(*shift.as_integer_ratio()), 1)
            unit = reading.unit and Calculator(text).unit(reading.unit.text)
            places[leaf.start()] = leaf.end(), size.times(unit) if unit else size
        read = read_expression(text, places, dimensions)
        if read is None:
            raise errors.NumberError(f"'{quote(text)}' is not a value with a unit", HINT)
        return read[0], read[1]

    number, unit = evaluate()
    parts = []
    for k, reading in enumerate(readings):
        if reading.uncertainty:
            leaf_text = _inside(leaves[k][0])
            parts.append(_part(text, leaf_text, number, reading, partial(evaluate, k)))
    off = float(f"{math.hypot(*(part.size for part in parts)):.7g}")
    check_uncertainty(off, text)
    nominal = f"{number!r} {unit.text if unit else ''}".strip()
    return Reading(number, unit, off, nominal, tuple(parts))


def _part(
    text: str,
    leaf_text: str,
    number: float,
    leaf: Reading,
    evaluate: Callable[[float], tuple[float, Unit | None]],
) -> Part:
    """Return the contribution of a number; `evaluate` gives the expression with it shifted."""
    why = ""

    def at(shift: float) -> dict[str, float]:
        nonlocal why
        try:
            return {"": evaluate(shift)[0]}
        except errors.RadcalcError as error:
            why = f": {error.message}"
            return {}

    off = leaf.uncertainty
    slope = slopes(at, {"": number}, abs(leaf.number), off)[""]
    if slope is None:
        problem = (
            f"the uncertainty of '{quote(leaf_text)}' cannot be propagated through '{quote(text)}'"
        )
        raise errors.NumberError(f"{problem}{why}", "leave it out")
    return Part(leaf_text, float(f"{slope * off:.7g}"), lambda times: at(times * off).get(""))


def _leaf(text: str) -> Reading:
    """Read a number of an expression and its uncertainty: (100±3), (100±3 lx) or 100(3)."""
    reading = _with_one(text)
    if reading is None:
        raise errors.NumberError(f"'{quote(text)}' is not a number and its uncertainty", HINT)
    if reading.uncertainty < 0:
        raise errors.NumberError(f"'{quote(text)}' has a negative uncertainty", HINT)
    if isinstance(reading.unit, ScaleUnit):
        problem = f"'{quote(text)}' is in {quote(reading.unit.text)}, which is a scale, not a unit"
        remark = "then arithmetic with it"
        hint = errors.call("convert", _inside(text), reading.unit.unit.text, remark=remark)
        raise errors.ExpressionError(problem, hint)
    return reading


def _inside(text: str) -> str:
    return text[1:-1] if text[0] == "(" and text[-1] == ")" else text


def _ways(text: str) -> list[str]:
    """Return the well-formed readings of arithmetic with a ±, with brackets or both sizes."""
    import re

    from radcalc.units.amounts import split_value

    masked = re.sub(LEAF, lambda leaf: "_" * len(leaf[0]), text)
    if masked.count(SIGN) != 1:
        return []
    at = masked.index(SIGN)
    left, right = text[:at], text[at + 1 :]
    sizes = ""
    with suppress(errors.RadcalcError):
        (value, unit), (off, after) = split_value(left.strip()), split_value(right.strip())
        sizes = f"{value:.12g}±{off:.12g} {unit or after}".strip()
        if unit and after:
            sizes = f"{value:.12g} {unit} ± {off:.12g} {after}"
    as_sizes = _quantity_meant(sizes)
    begins = [match.start() for match in re.finditer(BEGIN + DECIMAL, left)]
    number = re.match(rf"\s*{DECIMAL}(?:[eE][-+]?\d+)?", right)
    ends = [match.start() for match in re.finditer(OPERATOR, right)]
    closes = [number.end(), *ends[:MOST_TRIED], len(right)] if number else []
    for begin in begins[: -MOST_TRIED - 1 : -1]:
        for end in closes:
            inside = text[begin : at + 1 + end]
            after = inside[len(inside.rstrip()) :] + right[end:]
            candidate = f"{text[:begin]}({inside.rstrip()}){after}"
            meant = _quantity_meant(candidate)
            if meant and as_sizes and meant[1] != as_sizes[1]:
                continue  # 100 lx * 2 ± 3 lx is not a product of two illuminances
            if meant:
                return [meaning[0] for meaning in (meant, as_sizes) if meaning]
    return [as_sizes[0]] if as_sizes else []


def _quantity_meant(text: str) -> tuple[str, Dimension] | None:
    """Return the text, or the first of its two readings, and its dimension; None if unreadable."""
    try:
        reading = _read(text)
    except errors.RadcalcError as error:
        first = error.hint.partition(" or ")[0]
        return (
            _quantity_meant(first)
            if "is ambiguous" in error.message and first.count("(") > text.count("(")
            else None
        )
    return (text, reading.unit.dimension if reading.unit else NUMBER) if reading else None


def _times(number: str, power: int) -> float:
    """Return a number times a power of ten, rounded once if the number is a decimal."""
    if not power:
        return parse_number(number)
    if typed_digits(number) is None or "e" in number.lower():
        return parse_number(number) * 10.0**power
    return parse_number(f"{number}e{power}")


def _power_of_ten(text: str) -> tuple[int, str]:
    """Return the power of ten of an e6 after a bracket, and the rest of the text."""
    end = 2 if text[1:2] in tuple(SIGNS) else 1
    first = end
    while text[end : end + 1] in tuple(DIGITS):
        end += 1
    if text[:1] not in ("e", "E") or not first < end <= MOST_DIGITS:
        return 0, text.strip()
    return int(text[1:end].replace(errors.MINUS, "-")), text[end:].strip()


def join_words(words: list[str]) -> list[str]:
    """Join the words of a value and its uncertainty, `100 ± 3 lx`, not a unit after both."""
    marked = next(k for k, word in enumerate(words) if SIGN in signed(word))
    if any(word in TO for word in words):
        return words  # the part before a separator is read as a whole
    end = marked + 1
    if signed(words[marked]).endswith(SIGN):  # the number is the next word
        end += 1
    left, _, right = signed(" ".join(words[:end])).partition(SIGN)
    has_unit = _has_unit(left)
    next_words = words[end : end + 1]
    if (
        has_unit
        and typed_digits(right.strip())
        and (
            next_words == [PERCENT]
            or len(words) > end + 1
            or next_words == [split_quantity(left)[1]]
        )
    ):
        end += 1  # the unit of the uncertainty
    elif not has_unit and right.endswith(PERCENT) and next_words:
        has_brackets = left.lstrip().startswith("(")  # (100 ± 3)%
        if not has_brackets and (len(words) > end + 1 or not _is_ratio(next_words[0])):
            end += 1  # the unit of 100 ± 3% lx
    return [" ".join(words[:end]), *words[end:]]


def _has_unit(text: str) -> bool:
    try:
        return not text.startswith("(") and split_quantity(text)[1] != ""
    except errors.NumberError:  # sqrt(4.0
        return False


def _is_ratio(text: str) -> bool:
    """Return whether a text is a unit of ratios, which may be the target of (50 ± 5)%."""
    try:
        return resolve_any(text).dimension == NUMBER
    except errors.UnitError:
        return False


def variable(number: float, uncertainty: float, name: str = "") -> Any:
    """Return an independent variable of the `uncertainties` package."""
    from uncertainties import ufloat  # type: ignore[import-untyped]

    return ufloat(number, uncertainty, name or None)
