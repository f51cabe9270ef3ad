"""Readers of inputs of all forms."""

import math
from collections.abc import Callable, Sequence
from typing import Any

from radcalc import errors
from radcalc.errors import option, quote
from radcalc.inputs import Input, runs_backwards
from radcalc.inputs.quantities import MARKED, quantity_input, with_likely_unit
from radcalc.quantities import symbols
from radcalc.units import NUMBER, Unit
from radcalc.units.amounts import split_value
from radcalc.units.ranges import read_array, read_values
from radcalc.units.table import resolve


def split_values(name: str, text: Any, arrays: bool = False) -> Sequence[Any]:
    """Split a list or a range into values; a range of wavelengths or a file name is one value.

    A range of directions has polar angles and one azimuth: 0deg:90deg:15deg,90deg.
    """
    form = symbols.SYMBOLS[name].form
    if name == "aspect":
        text = _as_aspect(text)
    if name in MARKED and (mark := MARKED[name]) in str(text).lower():
        values: list[str] = text.split(",")  # f/2,8 is not a list, as 2,8 is not
        is_list = all(mark in value.lower() for value in values)
        return values if is_list or read_values(text.lower().replace(mark, ""))[1:] else [text]
    if form == symbols.SPECTRUM:
        from radcalc.spectra.sources import read_spectra

        return read_spectra(text)
    if form == symbols.DIRECTION and ":" in str(text):
        angles, comma, azimuth = text.partition(",")
        return [f"{polar}{comma}{azimuth}" for polar in read_values(angles)]
    return _quantities(name, text, arrays) if form == symbols.QUANTITY else [text]


def _as_aspect(text: str) -> str:
    """Return 16:9 as 16/9 for an aspect ratio; a range has two colons."""
    parts = text.split(",")
    return ",".join(part.replace(":", "/") if part.count(":") == 1 else part for part in parts)


def _quantities(name: str, text: str, arrays: bool) -> Sequence[Any]:
    has_unit = NUMBER not in symbols.SYMBOLS[name].dimensions
    if arrays and name not in symbols.LINKS and (values := read_array(text, has_unit)):
        return [values]
    if not has_unit:
        _refuse_mixed_shares(text)
    return read_values(text)


def _refuse_mixed_shares(text: str) -> None:
    """Refuse 0.5,0.6%, where 0.5 may be 50 % or 0.5 %."""
    mark = ":" if ":" in text else ","
    *first_parts, last = [part.strip() for part in text.split(mark)]
    if last.endswith("%") and not all(part.endswith("%") for part in first_parts):
        in_percent = mark.join(f"{part.removesuffix('%')}%" for part in (*first_parts, last))
        problem = errors.ambiguous(text, "only the last value or all are in %")
        raise errors.ConditionError(problem, f"{quote(in_percent)}, or numbers without %")


AS_BARE = "0123456789./"  # characters of numbers that are usually written without a unit


def read(name: str, value: Any, uncertain: bool = False, bare: str = "") -> Input:
    """Read the value of a symbol of the vocabulary.

    `value` is a text as on the command line, True for a flag, a number, or a tuple of a number (or
    an array), a `Unit` and optionally a text for messages.  `bare` is the unit of a number that is
    usually written without one.
    """
    text = str(value).strip() if bare else ""
    if text and not text.strip(AS_BARE) and ("time" not in name or "/" in text):  # 4 may be 1/4
        given = read_as(symbols.SYMBOLS[name], f"{text} {bare}", uncertain)
        assumption = f"{option(name, quote(text))} is in {bare}"
        return given._replace(text=text, assumptions=(*given.assumptions, assumption))
    if name == "aspect" and isinstance(value, str):
        value = _as_aspect(value)
    return read_as(symbols.SYMBOLS[name], value, uncertain)


def read_as(symbol: symbols.Symbol, value: Any, uncertain: bool = False) -> Input:
    """Read the value of any symbol, also outside the vocabulary."""
    given = _reader(symbol.form)(symbol, value)
    if given.is_uncertain and not uncertain:
        option_text = option(symbol.name, quote(given.text))
        raise errors.ConditionError(f"{option_text} cannot be uncertain here", "the value alone")
    return given


def _reader(form: str) -> Callable[[symbols.Symbol, Any], Input]:
    """Return the reader of a form; load those of places and spectra on demand."""
    if form not in _READERS:
        from radcalc.inputs.places import READERS

        return READERS[form]
    return _READERS[form]


def _read_choice(symbol: symbols.Symbol, value: Any) -> Input:
    if not isinstance(value, str) or value not in symbol.choices:
        raise errors.ConditionError(
            f"unknown {option(symbol.name)} '{quote(str(value))}'", ", ".join(symbol.choices)
        )
    return Input(symbol, str(value), value)


def _read_flag(symbol: symbols.Symbol, value: Any) -> Input:
    if value is not True:
        raise errors.ConditionError(
            f"{option(symbol.name)} takes no value", f"{option(symbol.name)} alone"
        )
    return Input(symbol, "", True)


def read_interval(name: str, text: str) -> Input:
    """Read A:B, two angles [rad] of a symbol; an interval of azimuths may cross +x."""
    symbol = symbols.SYMBOLS[name]._replace(limits=symbols.Limits(), example="30deg:60deg")
    low, high = _ends(symbol, text)
    if low.value == high.value:
        raise errors.ConditionError(
            f"{option(name, quote(text))} has no width", option(name, symbol.example)
        )
    if low.value > high.value:
        hint = option(name, f"{high.text}:{low.text}")
        if name == "azimuth":  # across +x
            hint = option(name, f"{low.text}:{math.degrees(high.value) + 360:.12g}deg")
        raise runs_backwards(symbol, text, hint)
    return Input(symbol._replace(form=symbols.INTERVAL), text, (low.value, high.value))


def _read_interval(symbol: symbols.Symbol, value: Any) -> Input:
    text = " ".join(str(value).split())
    low, high = _ends(symbol, text)
    if low.value > high.value:
        raise runs_backwards(symbol, text, option(symbol.name, f"{high.text}:{low.text}"))
    return Input(symbol, text, (low.value, high.value))


def _ends(symbol: symbols.Symbol, text: str) -> tuple[Input, Input]:
    """Return the two ends of an interval LOW:HIGH."""
    parts = text.split(":")
    if len(parts) != 2:
        option_text = option(symbol.name, quote(text))
        remark = "from {} to {}".format(*symbol.example.split(":"))
        hint = errors.add(symbol.name, symbol.example, remark)
        raise errors.ConditionError(f"{option_text} is not an interval", hint)
    end = symbol._replace(form=symbols.QUANTITY, example=symbol.example.partition(":")[0])
    try:
        low, high = (read_as(end, part) for part in parts)
    except errors.MissingUnit:
        with_units = (
            part if split_value(part)[1] else with_likely_unit(end, part) for part in parts
        )
        raise errors.MissingUnit(symbol.name, quote(text), quote(":".join(with_units))) from None
    except errors.Impossible as error:
        nearest = [value for proposal in error.tries for _, value in proposal.inputs]
        whole = (
            text.replace(errors.MINUS, "-").replace(error.text, nearest[0], 1) if nearest else ""
        )
        raise errors.Impossible(
            symbol.name, error.text, error.limit, error.because, whole
        ) from None
    return low, high


def _read_distribution(symbol: symbols.Symbol, value: Any) -> Input:
    name = value.strip().lower() if isinstance(value, str) else ""
    if name in symbol.choices:
        return Input(symbol, name, name)
    from radcalc.distributions.sources import photometry  # loads NumPy

    distribution = photometry(value)
    return Input(symbol, value.strip() if name else distribution.format, distribution)


def _read_unit(symbol: symbols.Symbol, value: Any) -> Input:
    unit = value if isinstance(value, Unit) else resolve(str(value))
    return Input(symbol, unit.text, unit, unit.dimension)


def _read_word(symbol: symbols.Symbol, value: Any) -> Input:
    return Input(symbol, str(value), str(value))


_READERS = {
    symbols.CHOICE: _read_choice,
    symbols.FLAG: _read_flag,
    symbols.INTERVAL: _read_interval,
    symbols.UNIT: _read_unit,
    symbols.WORD: _read_word,
    symbols.DISTRIBUTION: _read_distribution,
    symbols.QUANTITY: quantity_input,
}
