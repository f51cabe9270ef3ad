"""Readers of values with their units, and of the words of a conversion."""

from radcalc import errors
from radcalc.errors import quote
from radcalc.units.amount import Amount
from radcalc.units.amounts import (
    ALSO_UNITS,
    EXAMPLE,
    LONGEST_SUM,
    OPERATORS,
    STREAM_EXAMPLE,
    UNCERTAIN,
    amount_in,
    find_unit,
    has_number,
    read_plain,
    read_sum,
)
from radcalc.units.numbers import DIGITS, SEPARATORS, SIGNS_OF_UNCERTAINTY, split_quantity
from radcalc.units.table import resolve, unit_of
from radcalc.units.unit import NUMBER, Dimension

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Sequence

    from radcalc.errors import Try


def read_amount(text: str, dimensions: "Sequence[Dimension]" = ()) -> Amount:
    """Read a value, with a unit or bare; a spelling of several scales is read as one of them."""
    text = text.strip()
    problem: errors.RadcalcError | None = None
    try:
        number, unit = split_quantity(text)
        if unit.isalpha() or not has_number(unit):
            return read_plain(text, number, unit, dimensions)
    except errors.RadcalcError as error:
        problem = error
    is_signed = any(sign in text for sign in SIGNS_OF_UNCERTAINTY)
    is_signed |= any(text[k - 1] in DIGITS for k, c in enumerate(text) if k and c == "(")  # 100(3)
    if not is_signed and (amount := read_sum(text, dimensions)):
        return amount
    if any(mark in text for mark in UNCERTAIN):
        from radcalc.units.uncertain import read_uncertain

        if reading := read_uncertain(text, dimensions):
            size, unit_found, off, _, parts = reading
            return amount_in(text, size, unit_found, off, dimensions, parts)
    if is_signed and (amount := read_sum(text, dimensions)):
        return amount
    if meant := sum_meant(text):
        raise errors.UnitError(f"'{quote(text)}' has several numbers", errors.correct(text, meant))
    if problem:
        raise problem
    return read_plain(text, number, unit, dimensions)


def read_for(text: str, target: str) -> Amount:
    """Read a value that is converted to a target, which decides between two readings."""
    try:
        return read_amount(text)
    except errors.ExpressionError:
        if not (dimensions := _dimensions_of(target)):
            raise
        return read_amount(text, dimensions)


def _dimensions_of(target: str) -> tuple[Dimension, ...]:
    unit = unit_of(target)
    if unit is None and target:
        from radcalc.units.scales import find

        unit = find(target)
    return (unit.dimension,) if unit else ()


def sum_meant(text: str) -> str:
    """Return `5 ft + 3 in` for `5 ft 3 in`, numbers with units of one quantity; else ''."""
    import re  # only when something is wrong already

    if len(text) > LONGEST_SUM:
        return ""
    pairs = re.findall(r"([\d.]+)\s*([^\d\s.]+)", text)
    if len(pairs) < 2 or "".join(map("".join, pairs)) != "".join(text.split()):
        return ""
    units = [unit_of(unit) for _, unit in pairs]
    if len({unit.dimension if unit else None for unit in units} | {None}) != 2 or None in units:
        return ""
    return " + ".join(f"{number} {unit}" for number, unit in pairs)


def temperatures(words: list[str]) -> str:
    """Return `3200K,5600K` for `3200 K 5600 K`, which do not add up; else ''."""
    text = "".join(words)
    parts = [f"{number}K" for number in text.removesuffix("K").split("K")]
    return ",".join(parts) if len(parts) > 1 and text.replace("K", "").isdigit() else ""


def with_unit(amount: Amount, unit: str) -> Amount:
    """Return a bare number with the unit from another word, or arithmetic times that unit."""
    text = f"{amount.text} {unit}"
    if unit == "1":  # multiplies nothing, so that 2 + 3 remains 5
        return Amount(
            text,
            amount.number,
            resolve(unit),
            amount.uncertainty,
            (),
            None,
            0.0,
            amount.rounding,
            amount.parts,
            amount.ratio,
        )
    if amount.rounding is not None or amount.parts:
        return read_amount(text)
    return amount_in(
        text, amount.number, find_unit(text, unit), amount.uncertainty, (), amount.parts
    )


def read_operands(words: list[str]) -> tuple[Amount, str]:
    """Return the value with its unit, and the text of the target ('' if there is none).

    Units of several words are allowed only around a separator.
    """
    try:
        return _read_operands(words)
    except errors.RadcalcError:
        if several := temperatures(words[:-1]):  # 3200 K 5600 K mired
            typed = quote(" ".join(words[:-1]))
            hint = errors.call("convert", several, words[-1])
            raise errors.UsageError(f"'{typed}' has several temperatures", hint) from None
        for end in range(len(words), 1, -1):  # 5 ft 3 in m, 5ft 3in m
            if not (end > 3 or all(word[:1].isdigit() for word in words[:end])):
                continue
            if meant := sum_meant(" ".join(words[:end])):
                typed = quote(" ".join(words[:end]))
                hint = errors.call("convert", meant, *words[end:])
                raise errors.UsageError(f"'{typed}' has several numbers", hint) from None
        raise


def _read_operands(words: list[str]) -> tuple[Amount, str]:
    """Return the amount and the target of the words, '' if they have none."""
    if not words:
        raise errors.UsageError("a value is missing", EXAMPLE)
    if words[1:] and words[-1] in ("-", "="):
        shell = "'to' instead, or '->' in quotes: without them > is the shell's"
        alone = errors.correct(" ".join(words), *words[:-1], remark="'->' needs quotes")
        raise errors.UsageError(f"a unit is missing after '{words[-1]}'", shell, [alone])
    try:
        amount, separator, rest = read_value(words)
    except errors.ExpressionError:
        target = sides(words)[2] or "".join(words[1:][-1:])
        if not (dimensions := _dimensions_of(target)):
            raise
        amount, separator, rest = read_value(words, dimensions)
    if separator and not rest:
        alone = errors.correct(" ".join(words), *words[:-1])
        raise errors.UsageError(f"a unit is missing after '{separator}'", alone)
    if amount.unit is None:
        amount, rest = _with_next_unit(words, amount, separator, rest)
    if amount.unit is None:
        is_plain = words[0].replace(".", "").isalnum()
        hint: errors.Hint = errors.call(
            "convert", words[0], *(("lx", "fc") if is_plain else ("to", "1"))
        )
        raise errors.UsageError(f"the unit of '{quote(words[0])}' is missing", hint)
    if rest and not rest[0].strip():
        raise errors.UsageError("the unit to convert to is missing", EXAMPLE)
    if len(rest) > 1:
        _, typed = amount.typed
        raise _too_many(words, [typed.text if typed else "", *rest])
    return amount, rest[0] if rest else ""


def _with_next_unit(
    words: list[str], amount: Amount, separator: str, rest: list[str]
) -> tuple[Amount, list[str]]:
    """Return a bare number with the unit in the word after it, if any, and the further words."""
    if separator:
        return (with_unit(amount, "1") if _is_of_numbers(rest[0]) else amount), rest
    if rest and rest[0] in OPERATORS:
        raise _too_many(words, words)
    if rest and rest[0].strip():
        return with_unit(amount, rest[0].strip()), rest[1:]
    return amount, rest


def read_value(
    words: list[str], dimensions: "Sequence[Dimension]" = ()
) -> tuple[Amount, str, list[str]]:
    """Return the value, the separator after it or '', and the words after both.

    The dimensions that are asked for decide between two readings of an expression.  The first
    word after the value may be the unit of a bare number, if there is no separator.
    """
    if any(mark in word for word in words for mark in SIGNS_OF_UNCERTAINTY):
        from radcalc.units.uncertain import join_words

        words = join_words(words)
    source, separator, target = sides(words)
    if separator:
        return read_amount(source, dimensions), separator, [target] if target else []
    return read_amount(words[0], dimensions), "", words[1:]


def read_stream_operands(words: list[str]) -> tuple[str, str]:
    """Return the units of `- UNIT [to] TARGET`; the first is '' if lines have their own unit."""
    if words.count("-") > 1:
        raise errors.UsageError(
            "'-' is given more than once: there is one standard input", STREAM_EXAMPLE
        )
    source, separator, target = sides(words[1:], is_stream=True)
    units = [source, target] if separator else words[1:]
    if not units or not all(unit.strip() for unit in units[bool(separator) :]):
        raise errors.UsageError("a unit to convert to is missing", STREAM_EXAMPLE)
    if len(units) > 2:
        raise _too_many(units, units, is_stream=True)
    return (units[0] if len(units) > 1 else ""), units[-1]


def sides(words: list[str], is_stream: bool = False) -> tuple[str, str, str]:
    """Split the words at the separator: source, separator and target, all '' without one.

    `5 in in cm` has an inch and a separator, `100 in cm` and `100 cm in` have inches only.
    """
    parts = " ".join(words).split()
    places = [place for place, part in enumerate(parts) if part in SEPARATORS]
    if not places and (len(words) == 1 or any(word in ALSO_UNITS for word in words)):
        last = max((i for i, part in enumerate(parts[:-1]) if part in ALSO_UNITS), default=0)
        if last and (parts[last + 1][0] in "(°%" or parts[last + 1][0].isalpha()):
            places = [last] if is_stream or _has_unit(" ".join(parts[:last])) else []
    if not places:
        return "", "", ""
    at, *others = places
    if others:
        again = parts[others[0]]
        raise errors.UsageError(
            f"the word {again} is given more than once"
            if again == parts[at]
            else f"{parts[at]} and {again} both separate units",
            STREAM_EXAMPLE if is_stream else EXAMPLE,
        )
    return " ".join(parts[:at]), parts[at], " ".join(parts[at + 1 :])


def _is_of_numbers(text: str) -> bool:
    """Return whether a unit or a scale is of bare numbers: 1, % or dB."""
    unit = unit_of(text)
    if unit is None:
        from radcalc.units.scales import find

        unit = find(text)
    return unit is not None and unit.dimension == NUMBER


def _has_unit(text: str) -> bool:
    """Return whether a value has a unit, which may be unknown."""
    try:
        return read_amount(text).unit is not None
    except errors.RadcalcError as error:
        return isinstance(error, errors.ExpressionError) or not isinstance(
            error, errors.NumberError
        )


def _too_many(words: list[str], units: list[str], is_stream: bool = False) -> errors.TooManyWords:
    """Return the error for words after the units; propose the divisions that fit."""
    _, second, *others = units
    if second.lower() in SEPARATORS + ALSO_UNITS and others:
        return errors.TooManyWords(
            f"'{quote(second)}' does not separate units",
            errors.correct(f"{second} {others[0]}", f"to {others[0]}"),
        )
    problem = f"too many words: '{quote(' '.join(units))}'"
    if any(word in OPERATORS for word in units):
        whole, last = " ".join(words), words[-1]
        calculated = [
            errors.correct(whole, whole),
            errors.correct(whole, whole.removesuffix(f" {last}"), last),
        ]
        return errors.TooManyWords(problem, "quotes around a value that is calculated", calculated)
    return errors.TooManyWords(problem, lambda: _divided(units) or _of_targets(units, is_stream))


def _divided(units: list[str]) -> "list[Try]":
    """Propose `W m-2 to mW cm-2`, with a unit of several words on both sides or one."""
    typed = " ".join(units)
    ends = [(" ".join(units[:k]), " ".join(units[k:])) for k in range(1, len(units))]
    return [
        errors.correct(typed, start, "to", end) for start, end in ends if _are_alike(start, end)
    ]


def _of_targets(units: list[str], is_stream: bool) -> "list[Try]":
    """Propose several targets as a list, and each alone; a stream has one, of the same quantity."""
    source, *targets = units
    ends = targets if is_stream else [",".join(targets), *targets]
    ends = [end for end in ends if not is_stream or _are_alike(source, end)]
    return [errors.correct(" ".join(units), source, end) for end in ends]


def _are_alike(start: str, end: str) -> bool:
    first, second = unit_of(start), unit_of(end)
    return first is not None and second is not None and first.dimension == second.dimension
