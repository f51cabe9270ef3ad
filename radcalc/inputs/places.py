"""Readers of directions, points, grids, spectra and wavelength ranges."""

import math
import re
from collections.abc import Callable, Iterator, Sequence
from operator import index
from typing import Any

from radcalc import errors, maths
from radcalc.errors import ConditionError, RadcalcError, option, quote
from radcalc.floats import divide
from radcalc.inputs import Input, runs_backwards
from radcalc.inputs.quantities import is_number_with_unit, quantity_input
from radcalc.maths import LARGEST, SLACK
from radcalc.quantities import describe, symbols
from radcalc.quantities.symbols import SYMBOLS, Symbol
from radcalc.units import Unit
from radcalc.units.amounts import split_value
from radcalc.units.dimensions import ANGLE, LENGTH
from radcalc.units.numbers import parse_number
from radcalc.units.ranges import floats
from radcalc.units.table import resolve

Point = tuple[float, float, float]


def read_point(text: str, what: str) -> Point:
    """Read X,Y,Z, three bare numbers in the same unit; `what` names the text in messages."""
    hint = "X,Y,Z, in one unit that is omitted: 1,0,0.5"
    x, y, z = _read_bare(text, what, 3, "coordinate", hint)
    return x, y, z


def read_vector(text: str, what: str) -> Point:
    """Read X,Y,Z like a point; refuse 0,0,0."""
    vector = read_point(text, what)
    if not any(vector):
        raise errors.ConditionError(
            f"{what} '{quote(text)}' has no direction", "a vector other than 0: 1,0,0.5"
        )
    return vector


def read_direction(text: str, what: str) -> tuple[float, float]:
    """Read POLAR or POLAR,AZIMUTH, angles with their units, or a vector X,Y,Z of bare numbers.

    Returns the polar angle (0 to pi) and the azimuth (0 to below 2 pi) [rad]; `what` names the
    text in messages.
    """
    from radcalc.geometry.projections import TURN, spherical

    parts = text.split(",")
    if len(parts) > 2:
        polar, azimuth, _ = spherical(*read_vector(text, what))
        return polar, azimuth
    polar, azimuth = (*(_read_angle(part, text, what) for part in parts), 0.0)[:2]
    if not 0 <= polar <= math.pi * (1 + SLACK):
        raise errors.ConditionError(
            f"{what} '{quote(text)}' is out of range: its polar angle must be from 0 to 180 deg",
            AS_DIRECTION,
        )
    azimuth %= TURN
    return min(polar, math.pi), 0.0 if azimuth == TURN else azimuth  # from just below 0


def require_azimuth(given: Input, why: str) -> None:
    """Refuse a direction without an azimuth, unless it is a pole."""
    if given.value[0] % math.pi and "," not in given.text:
        typed = quote(given.text)
        problem = f"{option(given.name, typed)} has no azimuth, and {why}"
        raise errors.MissingInput(problem, option(given.name, f"{typed},90deg"))


AS_DIRECTION = "angles with units (60deg or 60deg,90deg), or X,Y,Z without units (1,0,0.5)"


def _read_angle(text: str, direction: str, what: str) -> float:
    """Return one angle of a direction [rad]; refuse a range, or another quantity."""
    if ":" in text:
        raise errors.ConditionError(
            f"{what} '{quote(direction)}' has a range, not a single angle",
            "one direction, or at a shell a range of polar angles: 0deg:90deg:15deg,90deg",
        )
    try:
        number, unit_text = split_value(text)
    except errors.NumberError as error:
        raise errors.NumberError(
            f"{what} '{quote(direction)}': {error.message}", AS_DIRECTION
        ) from None
    try:
        unit = resolve(unit_text) if unit_text else None
    except errors.RadcalcError as error:
        raise error.reworded(f"{what} '{quote(direction)}': {error.message}") from None
    if unit is None or unit.dimension != ANGLE:
        description = describe(unit) if unit else "a bare number"
        raise errors.ConditionError(
            f"{what} '{quote(direction)}' has {description}, not an angle", AS_DIRECTION
        )
    angle = number * unit.factor
    if abs(angle) > LARGEST:
        raise errors.NumberError(
            f"{what} '{quote(direction)}' has too large an angle", AS_DIRECTION
        )
    return angle


def direction_input(symbol: symbols.Symbol, value: Any) -> Input:
    """Read a direction: one angle or two, or a vector."""
    if is_number_with_unit(value) and maths.is_array(value[0]):
        raise errors.ConditionError(
            f"{option(symbol.name)} takes one direction at a time", AS_DIRECTION
        )
    text = joined(value)
    return Input(symbol, text, read_direction(text, option(symbol.name)))


COUNTED = {2: "two", 3: "three", 4: "four"}


def _read_bare(text: str, what: str, count: int, noun: str, hint: str) -> tuple[float, ...]:
    parts = text.split(",")
    if len(parts) != count:
        how_many = f"{len(parts)} {noun}{'s' if len(parts) > 1 else ''}"
        raise errors.ConditionError(
            f"{what} '{quote(text)}' has {how_many}, not {COUNTED[count]}", hint
        )
    try:
        numbers = tuple(parse_number(part) for part in parts)
    except errors.NumberError as error:
        raise errors.NumberError(f"{what} '{quote(text)}': {error.message}", hint) from None
    if max(map(abs, numbers)) > LARGEST:
        problem = f"{what} '{quote(text)}' is out of range: numbers must be at most {LARGEST:g}"
        raise errors.NumberError(problem, hint)
    return numbers


def joined(value: Any, mark: str = ",", number: Callable[[Any], Any] = floats) -> str:
    """Return Python numbers as typed text; the readers refuse other values."""
    if isinstance(value, str):
        return value
    if is_number_with_unit(value):
        return f"{value[0]} {value[1].text}"
    try:
        return mark.join(str(number(item)) for item in value)
    except (TypeError, ValueError, OverflowError):
        return " ".join(str(value).split())


def point_input(symbol: symbols.Symbol, value: Any) -> Input:
    """Read a point in space."""
    text = joined(value)
    return Input(symbol, text, read_point(text, option(symbol.name)))


def vector_input(symbol: symbols.Symbol, value: Any) -> Input:
    """Read a vector, as a text or as three numbers."""
    text = joined(value)
    return Input(symbol, text, read_vector(text, option(symbol.name)))


def numbers_input(symbol: symbols.Symbol, value: Any) -> Input:
    """Read as many numbers as the symbol's example has."""
    text, count = joined(value), len(symbol.example.split(","))
    hint = option(symbol.name, symbol.example)
    return Input(symbol, text, _read_bare(text, option(symbol.name), count, "number", hint))


def _whole(item: Any) -> int:
    """Return a whole number; NumPy 2.0 takes its truth values for 0 and 1."""
    if str(getattr(item, "dtype", "")) == "bool":
        raise TypeError
    return index(item)


def pair_input(symbol: symbols.Symbol, value: Any) -> Input:
    """Read two whole numbers separated as in the symbol's example: 1024x512, or 0,0."""
    mark = "x" if "x" in symbol.example else ","
    text = joined(value, mark, _whole)
    parts = [part.strip() for part in text.lower().replace("×", "x").split(mark)]
    option_text = option(symbol.name, quote(text))
    if len(parts) != 2 or not all(part.isascii() and part.isdigit() for part in parts):
        problem = f"{option_text} is not two whole numbers with '{mark}' between them"
        raise errors.ConditionError(problem, option(symbol.name, symbol.example))
    low, high, limit_text, *_ = symbol.limits
    if not all(len(part) <= DIGITS and low <= int(part) <= high for part in parts):
        raise errors.Impossible(symbol.name, text, limit_text)
    return Input(symbol, text, (int(parts[0]), int(parts[1])))


DIGITS = 18  # of a whole number
IN_METRES = "coordinates without a unit are in metres"
TOO_FAR = "a coordinate is out of range", "up to 1e100 m"


def read_coordinates(parts: Sequence[str]) -> tuple[tuple[float, ...], str]:
    """Read coordinates, all lengths or all bare; return them [m] and the first unit.

    A 0 among lengths needs no unit.
    """
    if any(":" in part for part in parts):
        raise errors.ConditionError(
            "a coordinate is one number, not a range", "one point at a time"
        )
    numbers_and_units = [split_value(part) for part in parts]
    units = [resolve(unit or "1") for _, unit in numbers_and_units]
    first_unit = next((unit for _, unit in numbers_and_units if unit), "")
    for part, (number, unit_text) in zip(parts, numbers_and_units, strict=True):
        if first_unit and not unit_text and number:
            problem = f"the unit of '{quote(part.strip())}' is missing: another coordinate has one"
            raise errors.ConditionError(problem, _with_units(parts, first_unit))
    sizes = tuple(
        _coordinate(number, unit_text, unit)
        for (number, unit_text), unit in zip(numbers_and_units, units, strict=True)
    )
    if max(map(abs, sizes)) > LARGEST:
        raise errors.ConditionError(*TOO_FAR)
    return sizes, first_unit


def _with_units(parts: Sequence[str], unit: str) -> list[errors.Try]:
    """Propose coordinates that all have a unit, typed as one word or as several."""
    texts = [part.strip() for part in parts]
    whole = ",".join([text if split_value(text)[1] else text + unit for text in texts])
    return [errors.correct(mark.join(parts), whole) for mark in (",", " ")]


def _coordinate(number: float, unit_text: str, unit: Unit) -> float:
    """Return a coordinate [m], rounded once."""
    if unit_text and unit.dimension != LENGTH:
        raise errors.ConditionError(
            f"a coordinate is a length or a bare number, not {describe(unit)}",
            f"without {quote(unit_text)}",
        )
    over, under = number.as_integer_ratio()
    return divide(over * unit.top, under * unit.bottom)


def read_place(name: str, text: str, description: str = "") -> Input:
    """Read X,Y,Z, the position [m] of a symbol: three lengths, or bare numbers in metres.

    `description` is its name in messages, by default that of the symbol.
    """
    parts = text.split(",")
    what = f"{description or f'the {name}'} '{quote(text)}'"
    hint = "X,Y,Z, as 1,0,2 in metres, or 1m,0m,2m"
    if len(parts) != 3:
        count = f"{len(parts)} coordinate{'s' if len(parts) > 1 else ''}"
        raise errors.ConditionError(f"{what} has {count}, not three", hint)
    try:
        place, unit = read_coordinates(parts)
    except errors.RadcalcError as error:
        raise error.reworded(f"{what}: {error.message}") from None
    return Input(symbols.SYMBOLS[name], text, place, unit=resolve(unit) if unit else None)


AS_GRID = "X0:X1:N,Y0:Y1:N,Z, as in 0:6:61,0:4:41,0.75"
MOST_POINTS = 100_000_000  # of a grid


def grid_input(symbol: symbols.Symbol, value: Any) -> Input:
    """Read X0:X1:N,Y0:Y1:N,Z as start, end and count of three axes; an axis may be one number."""
    text = joined(value)
    what = f"{option(symbol.name)} '{quote(text)}'"
    parts = [part.split(":") for part in text.split(",")]
    if len(parts) != 3 or any(len(part) not in (1, 3) for part in parts):
        raise errors.ConditionError(f"{what} is not a grid", AS_GRID)
    try:
        ends, unit = read_coordinates([word for part in parts for word in part[:2]])
    except errors.RadcalcError as error:
        raise errors.ConditionError(f"{what}: {error.message}", AS_GRID) from None
    coordinates = iter(ends)
    axes = tuple([_axis(part, coordinates, what) for part in parts])
    size = math.prod(count for _, _, count in axes)
    if size > MOST_POINTS:
        raise errors.ConditionError(f"{what} has {size} points", f"at most {MOST_POINTS}")
    return Input(symbol, text, axes, unit=resolve(unit) if unit else None)


def _axis(part: list[str], coordinates: Iterator[float], what: str) -> tuple[float, float, int]:
    start = next(coordinates)
    if len(part) == 1:
        return start, start, 1
    end, count = next(coordinates), _count(part[2].strip(), what)
    if start == end:
        raise errors.ConditionError(f"{what}: '{quote(':'.join(part))}' has no width", AS_GRID)
    return start, end, count


def _count(text: str, what: str) -> int:
    if not (text.isascii() and text.isdecimal() and 1 < int(text[:12]) <= MOST_POINTS):
        raise errors.ConditionError(
            f"{what}: '{quote(text)}' is not a number of points (2 or more)", AS_GRID
        )
    return int(text)


# two numbers, with a unit after the last or after both
RANGE = re.compile(r"(\d+\.?\d*)\s*(?:nm|um|µm)?\s*(?:[-:,–]|to|\.\.)\s*(\d+\.?\d*)\s*(nm|um|µm)?")


def spectrum_input(symbol: Symbol, value: Any) -> Input:
    """Read a spectrum: a text, the path, column and unit of a file, or a spectrum."""
    from radcalc.spectra.sources import spectrum, uncertain_parameter
    from radcalc.spectra.spectrum import Spectrum

    if isinstance(value, Spectrum):
        return Input(symbol, value.label, value)
    if isinstance(value, tuple):  # a file, its column and its unit
        return Input(symbol, value[0], spectrum(*value))
    text = str(value).strip()
    uncertain = uncertain_parameter(text)
    if uncertain is None:
        return Input(symbol, text, spectrum(text))
    amount = uncertain.amount
    return Input(
        symbol,
        text,
        uncertain.source(amount.number),
        number=amount.number,
        unit=amount.unit,
        uncertainty=amount.uncertainty * float(amount.unit.factor if amount.unit else 1),
        parts=amount.parts,
    )


def wavelengths_input(symbol: Symbol, value: Any) -> Input:
    """Read LOW:HIGH, two wavelengths [nm]."""
    text = str(value).strip()
    parts = text.split(":")
    ends = (
        [quantity_input(SYMBOLS["wavelength"], end) for end in parts]
        if all(map(_is_length, parts))
        else []
    )
    if len(ends) != 2:
        raise ConditionError(
            f"{option(symbol.name, quote(text))} is not a range of wavelengths",
            option(symbol.name, _in_nanometres(text) or symbol.example),
        )
    low, high = (round(end.value * 1e9, 9) for end in ends)
    if low == high:
        raise ConditionError(
            f"{option(symbol.name, quote(text))} is a single wavelength",
            option(symbol.name, symbol.example),
        )
    if low > high:
        raise runs_backwards(symbol, text, option(symbol.name, f"{ends[1].text}:{ends[0].text}"))
    return Input(symbol, text, (low, high))


def _in_nanometres(text: str) -> str:
    """Return the range that 400-700, 400:700 or 400-700nm means; '' for other texts."""
    ends = RANGE.fullmatch(text)
    return f"{ends[1]}{ends[3] or 'nm'}:{ends[2]}{ends[3] or 'nm'}" if ends else ""


def _is_length(text: str) -> bool:
    try:
        value, unit = split_value(text)
        return value > 0 and bool(unit) and resolve(unit).dimension == LENGTH
    except RadcalcError:
        return False


def file_input(symbol: Symbol, value: Any) -> Input:
    """Read a weight, whose value is its kind, a responsivity or transmittances of files."""
    from radcalc.spectra import sources

    readers: dict[str, Callable[[str], Any]] = {
        symbols.WEIGHT: sources.weight_of,
        symbols.RESPONSE: sources.response_of,
        symbols.FILTER: sources.transmittance_of,
    }
    text = str(value).strip()
    return Input(symbol, text, readers[symbol.form](text))


READERS = {
    **dict.fromkeys((symbols.WEIGHT, symbols.RESPONSE, symbols.FILTER), file_input),
    symbols.POINT: point_input,
    symbols.VECTOR: vector_input,
    symbols.GRID: grid_input,
    symbols.DIRECTION: direction_input,
    symbols.NUMBERS: numbers_input,
    symbols.PAIR: pair_input,
    symbols.SPECTRUM: spectrum_input,
    symbols.WAVELENGTHS: wavelengths_input,
}
