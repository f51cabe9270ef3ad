"""Several values at once: a list `1m,2m,5m`, a range `START:STOP:STEP`, or an array."""

import math
from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any, TypeVar

from radcalc import errors
from radcalc.errors import quote
from radcalc.floats import divide
from radcalc.units import Unit
from radcalc.units.amounts import nominal, split_value
from radcalc.units.numbers import DIGITS, SIGNS, SIGNS_OF_UNCERTAINTY, read_number, without_commas
from radcalc.units.reading import read_amount

T = TypeVar("T")
MOST = 10_000
PERCENT = "%"
GROUP = 3  # digits of thousands
EXACT, EXACT_POWER = 2**53, 22  # whole numbers and powers of ten that a float holds
LARGER = 100  # times a step that is not what was meant
LONG, MOST_IN_ARRAY = 1000, 10_000_000  # longer ranges are arrays, up to the second length


def read_series(text: str) -> list[str]:
    """Split a list or a range into its values, as texts; a single value is a list of one.

    A range includes its end if a whole number of steps leads there.
    """
    if ":" in text:
        return _range(text)
    parts = text.split(",")
    if len(parts) == 1:
        return parts
    if len(parts) > MOST:
        raise errors.TooMany(f"a list of {len(parts)} values is too long", f"at most {MOST}")
    if all(_has_unit(part) for part in parts) or _is_list_of_numbers(parts):
        return parts
    return [text]  # 1,5 and 1,000: the grammar of numbers refuses them


def _is_list_of_numbers(parts: list[str]) -> bool:
    """Return whether bare numbers are a list, not a decimal 1,5 or groups of thousands."""
    if all(any(sign in part for sign in SIGNS_OF_UNCERTAINTY) for part in parts):
        return True
    wholes = [part.partition(".")[0] for part in parts]
    if any(len(whole) > 1 and whole[0] == "0" for whole in wholes):
        return False
    if parts[0].isdigit() and all(len(whole) == GROUP for whole in wholes[1:]):
        return _are_groups(parts)
    return len(parts) > 1 and (len(parts) > 2 or not _is_one_number(*parts))


def _is_one_number(whole: str, decimals: str) -> bool:
    """Return whether two parts round a comma may be one number: 1,5, 1.000,5; not -3,-1, 1.5,2."""
    whole = whole.lstrip(SIGNS)
    if not whole or whole.strip(DIGITS + ".") or decimals[:1] not in DIGITS:
        return False
    return bool(without_commas(f"{whole},{decimals}"))


def with_list(tries: "Sequence[errors.Try]", text: str, unit: str = "") -> "Sequence[errors.Try]":
    """Return the proposals for a number with a comma, with the list that may be meant.

    A unit after the last value, or in another word, applies to each value.
    """
    *others, last = [part.strip() for part in text.split(",")]
    unit = unit or unit_in(last)
    parts = [*others, last.removesuffix(unit).strip()]
    is_begun = any(len(part.partition(".")[0]) > 1 and part[0] == "0" for part in parts)
    if is_begun or not all(map(_is_number, parts)):
        return tries
    unit = unit.replace(" ", ".")
    ending = "" if unit else ".0"
    listed = ",".join(f"{part}{unit or ending * ('.' not in part)}" for part in parts)
    whole = f"{text} {unit}" if unit and not text.endswith(unit) else text
    return [*tries, errors.correct(whole, listed, remark="a list")]


def _is_number(text: str) -> bool:
    try:
        return read_number(text)[1] == len(text)
    except errors.NumberError:
        return False


def _are_groups(parts: Sequence[str]) -> bool:
    """Return whether three or more have three digits: a list, but also a number with commas."""
    return len(parts) > 2 and all(part.isdigit() and len(part) == GROUP for part in parts)


def note_of(text: str) -> tuple[str, ...]:
    """Return a note on a list that may be meant as one number with commas."""
    if text.count(",") < 2:
        return ()
    word = text.split()[0]
    word = word.removesuffix(unit_in(word.rpartition(",")[2]))
    parts = word.split(",")
    if not _are_groups(parts):
        return ()
    return (f"{quote(word)} is read as {len(parts)} values, not as {quote(''.join(parts))}",)


def read_values(text: str) -> list[str]:
    """Split a list or a range into values, each with the unit after the last one.

    `10,20,30 lx` are three values; two numbers around a comma may be one, and are refused.
    """
    values, unit = _cut_unit(text)
    series = read_series(values)
    if len(series) == 1:
        return [text]
    if unit:
        return [value.strip() + unit for value in series]
    if len({bool(unit_in(value)) for value in series}) > 1:
        raise errors.ConditionError(
            f"'{quote(text)}' has values with a unit and without", _with_units(text, series)
        )
    return series


def _with_units(text: str, series: Sequence[str]) -> errors.Hint:
    """Propose one unit for all values, if only one is typed."""
    units = {unit_in(value) for value in series} - {""}
    if len(units) > 1 or ":" in text:
        return "a unit after each value, or one at the end"
    (unit,) = units
    return errors.correct(
        text, ",".join([value if unit_in(value) else value + unit for value in series])
    )


def _cut_unit(text: str) -> tuple[str, str]:
    """Split several values from their common unit at the end, kept with a blank before it."""
    mark = ":" if ":" in text else ","
    *values, last = text.strip().split(mark)
    if not values:
        return text, ""
    if _is_part(last) and not all(map(_is_part, values)):
        bracketed = [f"({value.strip().rstrip(PERCENT).strip()})%" for value in (*values, last)]
        problem = errors.ambiguous(text, "only the last value or all are in %")
        raise errors.ConditionError(problem, errors.correct(text, mark.join(bracketed)))
    unit = "" if any(map(unit_in, values)) else unit_in(last)
    if not unit or not last.endswith(unit):
        return mark.join([*values, last]), ""
    last = last.removesuffix(unit)
    bare = last.rstrip()
    return mark.join([*values, bare]), f" {unit}" if bare != last else unit


def _is_part(text: str) -> bool:
    """Return whether the uncertainty of a bare number is a percentage: 100±3%."""
    is_uncertain = any(sign in text for sign in SIGNS_OF_UNCERTAINTY)
    return is_uncertain and text.rstrip().endswith(PERCENT) and not unit_in(text)


def unit_in(text: str) -> str:
    """Return the text of the unit of a value, '' without one."""
    try:
        if any(sign in text for sign in (*SIGNS_OF_UNCERTAINTY, "(")):
            unit = read_amount(text).typed[1]
            return unit.text if unit else ""
        return split_value(text)[1]
    except errors.OutOfRange:  # the error of the list
        raise
    except errors.RadcalcError:
        return ""


def refuse_commas(text: str, values: Sequence[str], behind: str = "") -> None:
    """Raise for a value with a comma that is not a list, with the list that may be meant.

    Its unit may be in another word, `behind`.
    """
    if "," not in text or len(values) > 1:
        return
    unit = "" if unit_in(text.rpartition(",")[2]) else behind.strip()
    whole = f"{text.strip()} {unit}".strip()
    try:
        split_value(whole)
    except errors.NumberError as error:
        raise errors.NumberError(error.message, with_list(error.tries, text, unit)) from None


def refuse_list(text: str) -> None:
    """Raise for a text with a comma, or of several values: one is asked for."""
    values = read_values(text)
    if len(values) == 1 and "," in text:
        split_value(text)  # the same error without a list
    if len(values) > 1:
        raise errors.ConditionError(f"'{quote(text)}' has {len(values)} values", "one value")


def grid(given: Mapping[str, Sequence[T]], long: int = 1) -> list[dict[str, T]]:
    """Return every combination of lists of values; the last list varies fastest.

    One of the values may represent `long` values, as an array.
    """
    sizes = [*map(len, given.values()), long]
    refuse_many(sizes, MOST if long == 1 else MOST_IN_ARRAY)
    return [dict(zip(given, case, strict=True)) for case in product(*given.values())]


def refuse_many(sizes: Sequence[int], most: int = MOST) -> None:
    """Raise for lists with too many combinations."""
    if math.prod(sizes) > most:
        counted = " x ".join(str(size) for size in sizes if size > 1)
        raise errors.TooMany(
            f"the lists make {counted} = {math.prod(sizes)} answers", f"at most {most}"
        )


def _has_unit(part: str) -> bool:
    return part.strip()[-1:] in ("%", "°") or any(map(str.isalpha, part))


def read_array(text: str, has_unit: bool) -> tuple[Any, Unit, str] | None:
    """Return a range of more than `LONG` values as an array, its unit and text; else None.

    If a value must have a unit (`has_unit`), the unit may be after the last number only.
    """
    if text.count(":") != 2:
        return None
    cut, unit = _cut_unit(text) if has_unit else (text, "")
    start, step, values, unit_in_steps = _steps(cut, MOST_IN_ARRAY)
    unit = unit or unit_in_steps
    from radcalc.units.values import resolve_given

    if values <= LONG or resolve_given(unit or "1").is_scale:
        return None
    import numpy

    return _decimals(start, step, numpy.arange(values)), resolve_given(unit or "1"), text


def _decimals(start: float, step: float, counts: Any) -> Any:
    """Return START + k STEP, rounded once: the third of 0.1, 0.2 ... is 0.3."""
    from decimal import Decimal

    ends = [Decimal(f"{number:.15g}") for number in (start, step)]
    places = max(0, *(-int(end.as_tuple().exponent) for end in ends))
    first, each = (int(end.scaleb(places)) for end in ends)
    if places > EXACT_POWER or abs(first) + abs(each) * len(counts) > EXACT:
        return start + step * counts
    return (first + each * counts) / 10.0**places


def _range(text: str) -> list[str]:
    start, step, values, unit = _steps(text, MOST)
    return [f"{start + i * step:.15g}{unit}" for i in range(values)]


def _steps(text: str, most: int) -> tuple[float, float, int, str]:
    """Return the start, the step and the number of values of a range, in the unit of its start."""
    parts = _parts(text)
    (start, stop, step), unit = _numbers(text, parts)
    count = (stop - start) / step if step else 0.0
    if not all(map(math.isfinite, (start, stop, step, count))):
        raise errors.TooMany(f"'{quote(text)}' has too many values", f"at most {most}")
    if step == 0 or count < 0:
        problem = "has a step of 0" if step == 0 else "has a step that leads away from its end"
        ends = [part.strip() for part in parts]
        better = ",".join(ends[:2]) if step == 0 else ":".join([*ends[:2], _negative(ends[2])])
        raise errors.ConditionError(f"'{quote(text)}' {problem}", errors.correct(text, better))
    values = math.floor(count * (1 + 1e-12) + 1e-9) + 1
    if values > most:
        many = f"{values}" if count < 1e15 else f"{count:.2g}"
        problem = f"'{quote(text)}' has {many} values"
        better = with_larger_step(text, values, most)
        tries = [errors.correct(text, better, remark="a larger step")] if better else []
        raise errors.TooMany(problem, f"at most {most}", tries)
    return start, step, values, unit


def _parts(text: str) -> list[str]:
    """Return the start, the end and the step of a range as texts."""
    parts = text.split(":")
    if len(parts) != 3:
        hint = "START:STOP:STEP, as in 1m:5m:1m"
        if len(parts) == 2 and all(part.strip().isdigit() for part in parts):
            hint = f"{quote('/'.join(parts))}, or {hint}"  # 16:9
        raise errors.ConditionError(f"'{quote(text)}' is not a range", hint)
    if any(sign in text for sign in SIGNS_OF_UNCERTAINTY):
        problem = f"'{quote(text)}' has an uncertainty, which a range cannot have"
        raise errors.ConditionError(problem, errors.correct(text, ":".join(map(nominal, parts))))
    return parts


def _numbers(text: str, parts: Sequence[str]) -> tuple[list[float], str]:
    """Return the numbers of a range in the unit of its start, and that unit."""
    from radcalc.units.values import resolve_given, scale_of

    numbers = [split_value(part) for part in parts]
    first = numbers[0][1]
    units = [resolve_given(unit or "1") for _, unit in numbers]
    quantities = [(unit.dimension, scale_of(unit)) for unit in units]
    if len(set(quantities)) > 1:
        typed = {unit: quantity for (_, unit), quantity in zip(numbers, quantities, strict=True)}
        better = [  # a number keeps a unit of the same quantity
            ":".join(
                part.strip() if typed[own] == quantity else f"{number:.12g}{unit}"
                for part, (number, own) in zip(parts, numbers, strict=True)
            )
            for unit, quantity in typed.items()
            if unit
        ]
        tries = [errors.correct(text, one) for one in better]
        raise errors.ConditionError(
            f"'{quote(text)}' mixes quantities", "one unit in START, STOP and STEP", tries
        )
    sizes = [
        value * divide(unit.top * units[0].bottom, unit.bottom * units[0].top)
        for (value, _), unit in zip(numbers, units, strict=True)
    ]
    return sizes, first


def size_of(text: str) -> int:
    """Return the number of values in a list or a range; 1 for another text."""
    try:
        return _steps(text, MOST_IN_ARRAY)[2] if text.count(":") == 2 else text.count(",") + 1
    except errors.RadcalcError as error:
        return MOST_IN_ARRAY if isinstance(error, errors.TooMany) else 1


def _negative(text: str) -> str:
    return text[1:] if text[:1] in tuple(SIGNS) else f"-{text}"


def with_larger_step(text: str, answers: float, most: int = MOST) -> str:
    """Return a range with a step that is larger by a whole number, for at most `most` answers.

    Return '' for another text, or if the number is so large that something else is meant.
    """
    times = math.ceil(answers / most)
    if text.count(":") != 2 or times > LARGER:
        return ""
    start, stop, step = text.split(":")
    number, unit = split_value(step)
    return f"{start}:{stop}:{number * times:.12g}{unit}"


def real(value: Any, what: str, hint: str) -> Any:
    """Return a Python number unchanged, or an array-like as an array of floats.

    `what` names the argument in errors.
    """
    problem = f"{what} takes real numbers, not '{quote(str(value))}'"
    try:
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            float(value)
            return value
        array = floats(value)
        refuse_masked(value, what)
    except OverflowError:
        problem = f"a number in {what} is out of range"
        raise errors.NumberError(problem, hint) from None
    except (TypeError, ValueError):
        raise errors.NumberError(problem, hint) from None
    return array if array.ndim else float(array)


def floats(value: Any, missing: Any = ...) -> Any:
    """Return an array of floats; raise TypeError for other elements, but for one that is `missing`.

    NumPy would take truth values, texts, and the real parts of complex numbers, for numbers.
    """
    from decimal import Decimal
    from numbers import Real

    import numpy

    if hasattr(value, "dimensionality"):
        raise TypeError("the unit of a quantity would be lost")
    array = numpy.asarray(value, None if hasattr(value, "dtype") else object)
    if array.dtype.kind == "O":
        others = (one for one in array.flat if one is not missing)
        if any(isinstance(one, bool) or not isinstance(one, (Real, Decimal)) for one in others):
            raise TypeError("an array of objects")
    elif array.dtype.kind not in "iuf":
        raise TypeError(f"an array of {array.dtype}")
    return array.astype(float, copy=False)


def refuse_masked(value: Any, what: str) -> None:
    """Raise for a NumPy masked array with masked elements, whose values would be used."""
    import numpy

    if numpy.ma.is_masked(value):
        raise errors.NumberError(
            f"{what} has masked elements", "numbers in their place, by .filled(0)"
        )
