"""What somebody gave for a symbol, as a text, a number or a quantity: read, and held to limits."""

import math
from collections.abc import Callable, Iterable, Sequence
from operator import index
from typing import Any, NamedTuple

from radcalc import maths
from radcalc.answer import Input
from radcalc.derivation import format_number
from radcalc.errors import (
    MINUS,
    ConditionError,
    Exclusive,
    Impossible,
    MissingInput,
    MissingUnit,
    NumberError,
    RadcalcError,
    option,
    quote,
)
from radcalc.maths import LARGEST, SLACK
from radcalc.quantities.light import describe
from radcalc.quantities.symbols import (
    CHOICE,
    DIRECTION,
    DISTRIBUTION,
    FLAG,
    GRID,
    INTERVAL,
    LINKS,
    NUMBERS,
    PAIR,
    POINT,
    QUANTITY,
    REFINEMENTS,
    SPECTRUM,
    SYMBOLS,
    UNIT,
    VECTOR,
    WAVELENGTHS,
    WORD,
    Limits,
    Symbol,
)
from radcalc.units.amounts import Amount, read_amount, split_value
from radcalc.units.dimensions import ANGLE, ENERGY, LENGTH, TIME
from radcalc.units.numbers import parse_number, relative_rounding, rounding
from radcalc.units.ranges import read_array, read_values, real, with_list
from radcalc.units.scales import ScaleUnit, degree
from radcalc.units.table import NUMBER, Dimension, Unit, divide, resolve
from radcalc.units.uncertain import Part


class Given(NamedTuple):
    """A value that was given: the symbol, the text as typed, the value in SI units.

    `number` and `unit` are those typed, a reading and a `ScaleUnit` on a scale; `is_exact` where
    no text was, but a number of Python's.  `uncertainty` is the standard uncertainty in SI units,
    and `variable` the number with it where it is one of Python's `uncertainties`; `assumptions`
    say how it was read.  `off` is how far an expression may be off as typed, relative to it, and
    `parts` are what follows of each of its uncertain numbers, or of a reading, in `unit`.
    """

    symbol: Symbol
    text: str
    value: Any
    dimension: Dimension = NUMBER
    number: Any = None
    unit: Unit | None = None
    is_exact: bool = False
    uncertainty: float = 0.0
    assumptions: tuple[str, ...] = ()
    variable: Any = None
    off: float | None = None
    parts: tuple[Part, ...] = ()

    @property
    def name(self) -> str:
        """The symbol's name."""
        return self.symbol.name

    @property
    def is_uncertain(self) -> bool:
        """Whether it has an uncertainty, of which a flat expression may leave nothing."""
        return bool(self.uncertainty or self.parts)

    @property
    def unit_text(self) -> str:
        """The unit as typed; for a bare number 1."""
        return self.unit.text if self.unit else "1"

    @property
    def size(self) -> float:
        """How large a single number is [SI]: of an uncertain spectrum its parameter."""
        if self.symbol.form == SPECTRUM:
            return float(self.number * self.unit.factor if self.unit else self.number)
        return float(self.value)

    @property
    def rounding(self) -> float:
        """How far the value may be off as typed, relative to it; what is counted is exact."""
        if self.is_exact or self.name in COUNTS:
            return 0.0
        if self.uncertainty:
            return abs(self.uncertainty / self.value) if self.value else 0.0
        if isinstance(self.unit, ScaleUnit):
            off = rounding(self.text) * abs(self.number)
            slope, quantity = self.unit.slope(self.number), self.unit.quantity(self.number)
            return float(abs(off * slope / quantity))
        return rounding(self.text) if self.off is None else self.off


Inputs = dict[str, Given]
LEFT_OF_LIGHT = ("reflectance", "transmittance")  # ratios that may be told in OD, stops or dB
MARKED = {"f-number": "f/", "nd": "nd"}  # what may stand before the number: f/8,f/11 is no 8.11
MARKS_OF_STOPS = range(101, 114)  # filters' marks for 1 to 13 stops
NO_SHARES = (  # numbers of which nothing is a part, so that they have no percentage
    "exponent", "beam-exponent", "falloff", "f-number", "working-f-number", "ev", "ev100", "iso",
    "nd", "stops", "luminaires", "room-index", "electrons", "snr",
)  # fmt: skip
COUNTS = ("luminaires",)  # of things: 12 is no 12.0
DIFFERENCES = ("temperature-rise",)  # which may be told in degrees Celsius, and not in mired


def inputs_of(given: Inputs) -> tuple[Input, ...]:
    """What was given, as an answer tells it; a place by its coordinates."""
    return tuple([told for one in given.values() for told in _told(one)])


def _told(one: Given) -> list[Input]:
    form = one.symbol.form
    if form == QUANTITY:
        off = one.uncertainty and one.uncertainty / float(one.unit.factor if one.unit else 1)
        if isinstance(one.unit, ScaleUnit):
            off /= abs(one.unit.slope(one.number))
        return [Input(one.name, one.number, one.unit_text, one.text, off)]
    if form == FLAG:
        return [Input(one.name, True)]
    if one.name == "point":
        axes = zip("xyz", one.value, strict=True)
        return [Input(axis, metres, "m") for axis, metres in axes]
    return [Input(one.name, text=one.text)]


def values_of(name: str, text: Any, arrays: bool = False) -> Sequence[Any]:
    """The values of a list or a range; a range of wavelengths, or a file's name, is one value.

    Directions are a range of polar angles, with one azimuth: 0deg:90deg:15deg,90deg.
    """
    form = SYMBOLS[name].form
    if name in MARKED and MARKED[name] in str(text).lower():
        return text.split(",")  # type: ignore[no-any-return]
    if form == SPECTRUM:
        from radcalc.spectra.sources import read_spectra

        return read_spectra(text)
    if form == DIRECTION and ":" in str(text):
        polar, comma, azimuth = text.partition(",")
        return [f"{one}{comma}{azimuth}" for one in read_values(polar)]
    if form != QUANTITY:
        return [text]
    has_unit = NUMBER not in SYMBOLS[name].dimensions
    if arrays and name not in LINKS and (values := read_array(text, has_unit)):
        return [values]
    if not has_unit:
        _refuse_mixed_shares(text)
    return read_values(text)


def _refuse_mixed_shares(text: str) -> None:
    """Refuse 0.5,0.6%, where 0.5 may be a half or half a percent."""
    mark = ":" if ":" in text else ","
    *others, last = [part.strip() for part in text.split(mark)]
    if last.endswith("%") and not all(part.endswith("%") for part in others):
        whole = mark.join(f"{part.removesuffix('%')}%" for part in (*others, last))
        problem = f"'{quote(text)}' can be read in two ways"
        raise ConditionError(problem, f"{quote(whole)}, or numbers without %")


AS_BARE = "0123456789./"  # what a number has that is written without its unit


def read(name: str, value: Any, uncertain: bool = False, bare: str = "") -> Given:
    """Read what was given for a symbol of the vocabulary.

    `value` is a text as on the command line, True for a flag, a number, or a number (or an
    array) with a `Unit`, and with a text if that says it better.  It may be `uncertain` where
    the caller carries that.  `bare` is the unit of a text without one, where people write none.
    """
    text = str(value).strip() if bare else ""
    if text and not text.strip(AS_BARE) and ("time" not in name or "/" in text):  # 4 may be 1/4
        given = read_as(SYMBOLS[name], f"{text} {bare}", uncertain)
        said = f"{option(name, quote(text))} is in {bare}"
        return given._replace(text=text, assumptions=(*given.assumptions, said))
    return read_as(SYMBOLS[name], value, uncertain)


def read_as(symbol: Symbol, value: Any, uncertain: bool = False) -> Given:
    """Read what was given for a symbol, which may stand in no table."""
    reader = _READERS.get(symbol.form)
    given = reader(symbol, value) if reader else _read_quantity(symbol, value)
    if given.is_uncertain and not uncertain:
        told = option(symbol.name, quote(given.text))
        raise ConditionError(f"{told} cannot be uncertain here", "the value alone")
    return given


def any_uncertain(given: Iterable[Given]) -> bool:
    """Whether an input has an uncertainty."""
    return any(one.is_uncertain for one in given)


def refuse_uncertain(given: Iterable[Given], what: str) -> None:
    """Refuse uncertain inputs of what does not carry them."""
    for one in given:
        if one.is_uncertain:
            told = option(one.name, quote(one.text))
            problem = f"{told} has an uncertainty, which {what} does not carry"
            raise ConditionError(problem, "the value alone")


def moved(given: Given, shift: float) -> Given:
    """The same with its value moved by so much [SI], within its limits.

    Of a spectrum it is the parameter that is uncertain.
    """
    number = given.number + shift * (divide(given.unit.bottom, given.unit.top) if given.unit else 1)
    if given.symbol.form == SPECTRUM:
        from radcalc.spectra.sources import uncertain_parameter

        parameter = uncertain_parameter(given.text)
        assert parameter is not None
        return given._replace(text=f"{given.text}, {number!r}", value=parameter.source(number))
    value = given.value + shift
    if given.name:
        _refuse_extreme(given.name, given.text, value)
    elif not math.isfinite(value):
        raise NumberError(f"more than '{quote(given.text)}' is too large for a number", "less")
    if isinstance(given.unit, ScaleUnit):
        number = given.unit.reading(value / given.unit.factor)
    one = given._replace(
        text=f"{number!r}{given.unit_text if given.unit else ''}",
        value=value,
        number=number,
        off=None,
    )
    hold(one, given.symbol.limits)
    return one


def with_number(given: Given, number: Any, text: str, off: Any) -> Given:
    """The same with another number in its unit, as typed, which may be `off` by so much of it."""
    size, unit = number, given.unit
    if isinstance(unit, ScaleUnit):
        size, unit = unit.quantity(number), unit.unit
    value = _in_si(given.name, text, size, unit)
    other = given._replace(text=text, value=value, number=number, off=off)
    hold(other, given.symbol.limits)
    return other


def _read_quantity(symbol: Symbol, value: Any) -> Given:
    name = symbol.name
    uncertainty, variable = 0.0, None
    assumptions: tuple[str, ...] = ()
    amount: Amount | None = None
    if isinstance(value, str):
        text = " ".join(value.split()).replace(MINUS, "-")  # it is shown: on one line
        if name == "f-number":
            text = text.removeprefix(MARKED[name])  # as photographers write it: f/2.8
        if name in DIFFERENCES:
            amount = _difference(text)
        elif name == "nd":
            amount = _density(text)
        amount = amount or _read_amount(symbol, text)
        number, unit = amount.number, amount.unit
        uncertainty, assumptions = amount.uncertainty, amount.assumptions
    elif _has_unit(value):
        number, unit, *said = value
        if maths.is_uncertain(number):
            variable, number, uncertainty = number, number.nominal_value, number.std_dev
        number = real(number, option(name), option(name, symbol.example))
        text = said[0] if said else f"{format_number(number)} {unit.text}"
    else:
        if maths.is_uncertain(value):
            variable, value, uncertainty = value, value.nominal_value, value.std_dev
        number, unit = real(value, option(name), option(name, symbol.example)), None
        text = format_number(number)
    dimension = unit.dimension if unit else NUMBER
    scale = amount.scale if amount else None
    if scale and (dimension not in symbol.dimensions or not is_on_scale(name, scale)):
        raise ConditionError(
            f"{option(name)} takes {symbol.takes}, not {quote(scale.text)}",
            option(name, symbol.example),
        )
    if name in NO_SHARES and unit is not None and unit.factor != 1 and not scale:
        problem = f"{option(name)} takes a number, not {quote(unit.text)}"
        raise ConditionError(problem, option(name, symbol.example))
    if dimension not in symbol.dimensions:
        if unit is None and maths.is_array(number):
            problem = f"{option(name)} has numbers without a unit"
            raise ConditionError(problem, "an array with its unit, a radcalc.Quantity")
        if unit is None:
            is_sum = amount is not None and amount.rounding is not None
            whole = f"({quote(text)})" if is_sum else quote(text)
            raise MissingUnit(name, quote(text), _with_unit(symbol, whole))
        example = symbol.example
        if name == "bandwidth" and dimension == ENERGY:
            from radcalc.spectra.planck import PLANCK

            example = f"{number * unit.factor / PLANCK / 1e12:.6g}THz"
        raise ConditionError(
            f"{option(name)} takes {symbol.takes}, not {describe(unit)}", option(name, example)
        )
    given = Given(
        symbol,
        text,
        _in_si(name, text, number, unit),
        dimension,
        amount.reading if amount and scale else number,
        scale or unit,
        not isinstance(value, str),
        uncertainty * unit.factor if unit else uncertainty,
        assumptions,
        variable,
        amount.rounding if amount else None,
        amount.parts if amount else (),
    )
    hold(given, symbol.limits)
    return given


def is_on_scale(name: str, scale: Unit) -> bool:
    """Whether a symbol may be read on a scale: no difference, and of ratios light that is left."""
    if scale.dimension == NUMBER:
        return name in LEFT_OF_LIGHT
    return name not in DIFFERENCES


def _has_unit(value: Any) -> bool:
    return isinstance(value, tuple) and len(value) > 1 and isinstance(value[1], Unit)


def _read_amount(symbol: Symbol, text: str) -> Amount:
    try:
        return read_amount(text, symbol.dimensions)
    except NumberError as error:
        hint = with_list(error.hint, text) if "," in text else error.hint
        raise NumberError(f"{option(symbol.name)}: {error.message}", hint) from None


def _difference(text: str) -> Amount | None:
    """A difference of temperature, in degrees of a scale that has its 0 elsewhere; else None."""
    unit_text = text[max(map(text.rfind, "0123456789.)%")) + 1 :].strip()
    unit = degree(unit_text)
    rest = text.replace(unit_text, "") if unit else ""
    if unit is None or any(c.isalpha() for c in rest.lower().replace("e", "")):
        return None
    try:
        amount = read_amount(text.replace(unit_text, "K"))
    except RadcalcError:
        return None  # which is said of the text as it was typed
    if amount.unit is None or amount.rounding is not None:
        return None
    said = f"a difference of temperature: 1 {quote(unit_text)} is {format_number(unit.factor)} K"
    return Amount(text, amount.number, unit, amount.uncertainty, (said,))


def _density(text: str) -> Amount | None:
    """The density of a neutral filter by its mark: ND8 is a factor of 8, ND0.9 a density.

    None for a density alone, which is read as other numbers are.
    """
    number = text[:-1] if text[-1:] in ("X", "x") else text
    if number[:2].upper() == "ND":
        number = number[2:]
    if number[-2:].upper() == "ND":
        number = number[:-2]
    number = number.strip()
    if not number[:1].isdecimal():
        return None
    if number == text:
        if text.isdecimal() and float(text) > 1:
            problem = f"{option('nd', quote(text))} can be a density or a factor"
            ways = (option("nd", f"{quote(text)}.0"), option("nd", f"ND{quote(text)}"))
            raise ConditionError(problem, f"{ways[0]} for the density, or {ways[1]} for the factor")
        return None
    factor = parse_number(number)
    if "." in number:
        said, off = f"{quote(text)} is a density", relative_rounding(number)
        return Amount(text, factor, None, assumptions=(said,), rounding=off)
    if factor < 1:
        problem = f"{option('nd', quote(text))} is no filter: its factor is below 1"
        raise ConditionError(problem, option("nd", "ND8"))
    if factor in MARKS_OF_STOPS:  # as some makers mark 3 stops: 103
        problem = f"{option('nd', quote(text))} can be a factor, or {number[1:].lstrip('0')} stops"
        raise ConditionError(problem, f"{option('nd', f'{(factor - 100) * 0.3:.1f}')}, for stops")
    density = math.log10(factor)
    said = f"{quote(text)} lets 1/{number} of the light through: a density of {density:.4g}"
    return Amount(text, density, None, assumptions=(said,), rounding=relative_rounding(number))


def _with_unit(symbol: Symbol, number: str) -> str:
    if ANGLE in symbol.dimensions and ("pi" in number or "π" in number):
        return f"{number}rad"
    if TIME in symbol.dimensions and "/" in number:
        return f"{number}s"  # as a shutter says it
    return number + symbol.example.lstrip("0123456789./")


def _in_si(name: str, text: str, number: Any, unit: Unit | None) -> Any:
    """The value in SI units."""
    value = number * (divide(unit.top, unit.bottom) if unit else 1)
    _refuse_extreme(name, text, value)
    return value


def _refuse_extreme(name: str, text: str, value: Any) -> None:
    """Refuse extremes that no light reaches, and that would only overflow later [SI]."""
    if isinstance(value, float) and value != value:
        raise ConditionError(f"{option(name, quote(text))} is no number", "a finite number")
    size = abs(value)
    extreme = (size > LARGEST) | ((size < 1 / LARGEST) & (size != 0)) | (size != size)
    if maths.any_true(extreme):
        raise ConditionError(
            f"{option(name, quote(text))} is beyond what radcalc reckons with",
            f"values from {1 / LARGEST:g} to {LARGEST:g} in SI units",
        )


def hold(given: Given, limits: Limits) -> None:
    """Refuse a value outside limits, naming the limit.

    Whoever is below the lowest value of a symbol that starts at 0 is told that first.
    """
    value = given.value
    low, high = limits.low, limits.high
    below = value <= low if limits.without_low else value < low - SLACK * abs(low)
    if maths.any_true(below):
        said = limits.said
        if low == 0 and limits.without_low:
            said = "more than 0"
        raise Impossible(given.name, given.text, said)
    above = value >= high if limits.without_high else value > high * (1 + SLACK)
    if maths.any_true(above):
        raise Impossible(given.name, given.text, limits.said)


def require(given: Given, good: bool, limit: str) -> None:
    """Refuse a value that the case at hand makes impossible, naming the limit."""
    if not good:
        raise Impossible(given.name, given.text, limit)


def _read_choice(symbol: Symbol, value: Any) -> Given:
    if not isinstance(value, str) or value not in symbol.choices:
        raise ConditionError(
            f"{option(symbol.name)} does not know '{quote(str(value))}'", ", ".join(symbol.choices)
        )
    return Given(symbol, str(value), value)


def _read_flag(symbol: Symbol, value: Any) -> Given:
    if value is not True:
        raise ConditionError(
            f"{option(symbol.name)} takes no value", f"{option(symbol.name)} alone"
        )
    return Given(symbol, "", True)


def _read_spectrum(symbol: Symbol, value: Any) -> Given:
    from radcalc.spectra.sources import spectrum, uncertain_parameter

    text = str(value).strip()
    uncertain = uncertain_parameter(text)
    if uncertain is None:
        return Given(symbol, text, spectrum(text))
    amount = uncertain.amount
    return Given(
        symbol,
        text,
        uncertain.source(amount.number),
        number=amount.number,
        unit=amount.unit,
        uncertainty=amount.uncertainty * float(amount.unit.factor if amount.unit else 1),
        parts=amount.parts,
    )


def _read_wavelengths(symbol: Symbol, value: Any) -> Given:
    """LOW:HIGH, two wavelengths [nm]."""
    text = str(value).strip()
    parts = text.split(":")
    ends = [read("wavelength", end) for end in parts] if all(map(_is_length, parts)) else []
    if len(ends) != 2:
        raise ConditionError(
            f"{option(symbol.name, quote(text))} is not a range of wavelengths",
            option(symbol.name, symbol.example),
        )
    low, high = (round(end.value * 1e9, 9) for end in ends)
    if low == high:
        raise ConditionError(
            f"{option(symbol.name, quote(text))} is one wavelength",
            option(symbol.name, symbol.example),
        )
    if low > high:
        raise _backwards(symbol, text, option(symbol.name, f"{ends[1].text}:{ends[0].text}"))
    return Given(symbol, text, (low, high))


def _is_length(text: str) -> bool:
    try:
        value, unit = split_value(text)
        return value > 0 and bool(unit) and resolve(unit).dimension == LENGTH
    except RadcalcError:
        return False


def read_interval(name: str, text: str) -> Given:
    """Read A:B, two angles [rad] of a symbol; an interval of azimuths may lead across +x."""
    symbol = SYMBOLS[name]._replace(limits=Limits(), example="30deg:60deg")
    low, high = _ends(symbol, text)
    if low.value == high.value:
        raise ConditionError(
            f"{option(name, quote(text))} has no width", option(name, symbol.example)
        )
    if low.value > high.value:
        hint = option(name, f"{high.text}:{low.text}")
        if name == "azimuth":  # across +x
            hint = option(name, f"{low.text}:{math.degrees(high.value) + 360:.12g}deg")
        raise _backwards(symbol, text, hint)
    return Given(symbol._replace(form=INTERVAL), text, (low.value, high.value))


def _read_interval(symbol: Symbol, value: Any) -> Given:
    """A:B, of which both may be the same."""
    text = " ".join(str(value).split())
    low, high = _ends(symbol, text)
    if low.value > high.value:
        raise _backwards(symbol, text, option(symbol.name, f"{high.text}:{low.text}"))
    return Given(symbol, text, (low.value, high.value))


def _ends(symbol: Symbol, text: str) -> tuple[Given, Given]:
    parts = text.split(":")
    example = option(symbol.name, symbol.example)
    if len(parts) != 2:
        told = option(symbol.name, quote(text))
        raise ConditionError(f"{told} is not an interval", f"{example}, from A to B")
    end = symbol._replace(form=QUANTITY, example=symbol.example.partition(":")[0])
    try:
        low, high = (read_as(end, part) for part in parts)
    except MissingUnit:
        whole = (part if split_value(part)[1] else _with_unit(end, part) for part in parts)
        raise MissingUnit(symbol.name, quote(text), quote(":".join(whole))) from None
    return low, high


def _backwards(symbol: Symbol, text: str, hint: str) -> ConditionError:
    return ConditionError(f"{option(symbol.name, quote(text))} ends before it starts", hint)


Point = tuple[float, float, float]


def read_point(text: str, what: str) -> Point:
    """Read X,Y,Z, three bare numbers in any one unit; `what` is said where it is none."""
    hint = "X,Y,Z, in one unit that is not written: 1,0,0.5"
    x, y, z = _read_bare(text, what, 3, "coordinate", hint)
    return x, y, z


def read_vector(text: str, what: str) -> Point:
    """Read X,Y,Z that are not all 0, as of a point."""
    vector = read_point(text, what)
    if not any(vector):
        raise ConditionError(
            f"{what} '{quote(text)}' has no direction", "a vector other than 0: 1,0,0.5"
        )
    return vector


def read_direction(text: str, what: str) -> tuple[float, float]:
    """Read POLAR or POLAR,AZIMUTH, angles with their units, or a vector X,Y,Z of bare numbers.

    Gives the polar angle, from 0 to pi, and the azimuth, from 0 to below 2 pi [rad], as
    `radcalc.geometry.directions` counts them; `what` is said where it is no direction.
    """
    from radcalc.geometry.directions import TURN, spherical

    parts = text.split(",")
    if len(parts) > 2:
        polar, azimuth, _ = spherical(*read_vector(text, what))
        return polar, azimuth
    polar, azimuth = (*(_read_angle(part, text, what) for part in parts), 0.0)[:2]
    if not 0 <= polar <= math.pi * (1 + SLACK):
        raise ConditionError(
            f"{what} '{quote(text)}' has a polar angle that is not from 0 to 180 deg", AS_DIRECTION
        )
    azimuth %= TURN
    return min(polar, math.pi), 0.0 if azimuth == TURN else azimuth  # of a hair below 0


def require_azimuth(given: Given, why: str) -> None:
    """Refuse a direction that has a polar angle alone, where it is none of the poles."""
    if given.value[0] % math.pi and "," not in given.text:
        told = quote(given.text)
        problem = f"{option(given.name, told)} has no azimuth, and {why}"
        raise MissingInput(problem, option(given.name, f"{told},90deg"))


AS_DIRECTION = "angles with their units, 60deg or 60deg,90deg, or X,Y,Z without: 1,0,0.5"


def _read_angle(text: str, whole: str, what: str) -> float:
    """One of the angles of a direction [rad]."""
    if ":" in text:
        raise ConditionError(
            f"{what} '{quote(whole)}' has a range where one angle is meant",
            "one direction, or at a shell a range of polar angles: 0deg:90deg:15deg,90deg",
        )
    try:
        number, unit_text = split_value(text)
    except NumberError as error:
        raise NumberError(f"{what} '{quote(whole)}': {error.message}", AS_DIRECTION) from None
    try:
        unit = resolve(unit_text) if unit_text else None
    except RadcalcError as error:
        error.message = f"{what} '{quote(whole)}': {error.message}"
        raise
    if unit is None or unit.dimension != ANGLE:
        found = describe(unit) if unit else "a bare number"
        raise ConditionError(
            f"{what} '{quote(whole)}' has {found} where an angle is meant", AS_DIRECTION
        )
    angle = number * unit.factor
    if abs(angle) > LARGEST:
        raise NumberError(f"{what} '{quote(whole)}' has too large an angle", AS_DIRECTION)
    return angle


def _read_direction(symbol: Symbol, value: Any) -> Given:
    if _has_unit(value) and maths.is_array(value[0]):
        raise ConditionError(f"{option(symbol.name)} takes one direction at a time", AS_DIRECTION)
    text = _joined(value)
    return Given(symbol, text, read_direction(text, option(symbol.name)))


COUNTED = {2: "two", 3: "three", 4: "four"}


def _read_bare(text: str, what: str, count: int, noun: str, hint: str) -> tuple[float, ...]:
    """So many bare numbers, between commas."""
    parts = text.split(",")
    if len(parts) != count:
        told = f"{len(parts)} {noun}{'s' if len(parts) > 1 else ''}"
        raise ConditionError(f"{what} '{quote(text)}' has {told}, not {COUNTED[count]}", hint)
    try:
        numbers = tuple(parse_number(part) for part in parts)
    except NumberError as error:
        raise NumberError(f"{what} '{quote(text)}': {error.message}", hint) from None
    if max(map(abs, numbers)) > LARGEST:
        raise NumberError(f"{what} '{quote(text)}' is beyond what radcalc reckons with", hint)
    return numbers


def _joined(value: Any, mark: str = ",", number: Callable[[Any], Any] = float) -> str:
    """Numbers of Python's as they would be typed; what is none is refused by its reader."""
    if isinstance(value, str):
        return value
    if _has_unit(value):
        return f"{value[0]} {value[1].text}"
    try:
        return mark.join(str(number(one)) for one in value)
    except (TypeError, ValueError, OverflowError):
        return " ".join(str(value).split())


def _read_distribution(symbol: Symbol, value: Any) -> Given:
    """One of the names, or else the photometry of a file or an expression."""
    name = value.strip().lower() if isinstance(value, str) else ""
    if name in symbol.choices:
        return Given(symbol, name, name)
    from radcalc.distributions.sources import photometry  # with NumPy

    found = photometry(value)
    return Given(symbol, value.strip() if name else found.format, found)


def _read_point(symbol: Symbol, value: Any) -> Given:
    text = _joined(value)
    return Given(symbol, text, read_point(text, option(symbol.name)))


def _read_vector(symbol: Symbol, value: Any) -> Given:
    text = _joined(value)
    return Given(symbol, text, read_vector(text, option(symbol.name)))


def _read_numbers(symbol: Symbol, value: Any) -> Given:
    text, count = _joined(value), len(symbol.example.split(","))
    hint = option(symbol.name, symbol.example)
    return Given(symbol, text, _read_bare(text, option(symbol.name), count, "number", hint))


def _read_pair(symbol: Symbol, value: Any) -> Given:
    """Two whole numbers, parted as in the example: 1024x512, or 0,0."""
    mark = "x" if "x" in symbol.example else ","
    text = _joined(value, mark, index)
    parts = [part.strip() for part in text.lower().replace("×", "x").split(mark)]
    told = option(symbol.name, quote(text))
    if len(parts) != 2 or not all(part.isascii() and part.isdigit() for part in parts):
        problem = f"{told} is not two whole numbers with '{mark}' between them"
        raise ConditionError(problem, option(symbol.name, symbol.example))
    low, high, said, *_ = symbol.limits
    if not all(len(part) <= DIGITS and low <= int(part) <= high for part in parts):
        raise Impossible(symbol.name, text, said)
    return Given(symbol, text, (int(parts[0]), int(parts[1])))


DIGITS = 18  # of a whole number that is read at all


def _read_unit(symbol: Symbol, value: Any) -> Given:
    unit = value if isinstance(value, Unit) else resolve(str(value))
    return Given(symbol, unit.text, unit, unit.dimension)


def _read_word(symbol: Symbol, value: Any) -> Given:
    return Given(symbol, str(value), str(value))


IN_METRES = "coordinates without a unit are in metres"
TOO_FAR = "a coordinate is beyond what radcalc reckons with", "up to 1e100"


def read_coordinates(parts: Sequence[str]) -> tuple[tuple[float, ...], str]:
    """Read coordinates that are all lengths [m], or all bare; give the first unit too.

    A 0 needs no unit beside lengths.
    """
    if any(":" in part for part in parts):
        raise ConditionError("a coordinate is one number, not a range", "one point at a time")
    read = [split_value(part) for part in parts]
    units = [resolve(unit or "1") for _, unit in read]
    first = next((unit for _, unit in read if unit), "")
    for part, (number, unit_text), unit in zip(parts, read, units, strict=True):
        if unit_text and unit.dimension != LENGTH:
            raise ConditionError(
                f"a coordinate is a length or a bare number, not {describe(unit)}",
                f"without {quote(unit_text)}",
            )
        if first and not unit_text and number:
            bare = part.strip()
            raise ConditionError(
                f"'{quote(bare)}' has no unit, and another coordinate has one",
                f"{quote(bare + first)} in place of {quote(bare)}",
            )
    sizes = tuple(_exactly(number, unit) for (number, _), unit in zip(read, units, strict=True))
    if max(map(abs, sizes)) > LARGEST:
        raise ConditionError(*TOO_FAR)
    return sizes, first


def _exactly(number: float, unit: Unit) -> float:
    """A number in SI units, rounded once: 3 ft are 0.9144 m."""
    over, under = number.as_integer_ratio()
    return divide(over * unit.top, under * unit.bottom)


def read_place(name: str, text: str, said: str = "") -> Given:
    """Read X,Y,Z, the place [m] of a symbol: three lengths, or bare numbers of metres.

    `said` is what a message calls it; the name by default.
    """
    parts = text.split(",")
    what = f"{said or f'the {name}'} '{quote(text)}'"
    hint = "X,Y,Z, as 1,0,2 in metres, or 1m,0m,2m"
    if len(parts) != 3:
        count = f"{len(parts)} coordinate{'s' if len(parts) > 1 else ''}"
        raise ConditionError(f"{what} has {count}, not three", hint)
    try:
        place, unit = read_coordinates(parts)
    except RadcalcError as error:
        error.message = f"{what}: {error.message}"
        raise
    return Given(SYMBOLS[name], text, place, unit=resolve(unit) if unit else None)


AS_GRID = "X0:X1:N,Y0:Y1:N,Z, as in 0:6:61,0:4:41,0.75"
MOST_POINTS = 100_000_000  # of a grid


def _read_grid(symbol: Symbol, value: Any) -> Given:
    """X0:X1:N,Y0:Y1:N,Z, in which any of the three may be a range; start, end and count of each."""
    text = _joined(value)
    told = f"{option(symbol.name)} '{quote(text)}'"
    parts = [part.split(":") for part in text.split(",")]
    if len(parts) != 3 or any(len(part) not in (1, 3) for part in parts):
        raise ConditionError(f"{told} is no grid", AS_GRID)
    try:
        ends, unit = read_coordinates([word for part in parts for word in part[:2]])
    except RadcalcError as error:
        raise ConditionError(f"{told}: {error.message}", AS_GRID) from None
    axes, size, rest = [], 1, list(ends)
    for part in parts:
        start = end = rest.pop(0)
        count = 1
        if len(part) == 3:
            end, count = rest.pop(0), _count(part[2].strip(), told)
            if start == end:
                raise ConditionError(f"{told}: '{quote(':'.join(part))}' has no width", AS_GRID)
        axes.append((start, end, count))
        size *= count
    if size > MOST_POINTS:
        raise ConditionError(f"{told} has {size} points", f"at most {MOST_POINTS}")
    return Given(symbol, text, tuple(axes), unit=resolve(unit) if unit else None)


def _count(text: str, told: str) -> int:
    """How many points there are along an axis of a grid."""
    if not (text.isascii() and text.isdecimal() and 1 < int(text[:12]) <= MOST_POINTS):
        raise ConditionError(f"{told}: '{quote(text)}' is no number of points from 2 on", AS_GRID)
    return int(text)


_READERS = {
    CHOICE: _read_choice,
    FLAG: _read_flag,
    SPECTRUM: _read_spectrum,
    WAVELENGTHS: _read_wavelengths,
    POINT: _read_point,
    VECTOR: _read_vector,
    GRID: _read_grid,
    DIRECTION: _read_direction,
    INTERVAL: _read_interval,
    NUMBERS: _read_numbers,
    PAIR: _read_pair,
    UNIT: _read_unit,
    WORD: _read_word,
    DISTRIBUTION: _read_distribution,
}


def sort(given: Inputs) -> tuple[Inputs, Inputs, Inputs]:
    """Tell light quantities, what links their kinds, and the rest from each other."""
    quantities = {n: one for n, one in given.items() if one.symbol.generic}
    links = {n: one for n, one in given.items() if n in (*LINKS, *REFINEMENTS)}
    rest = {n: one for n, one in given.items() if n not in quantities and n not in links}
    return quantities, links, rest


def at_most_one(inputs: Inputs, what: str, *names: str) -> Given | None:
    """The one of several inputs that was given, or None."""
    found = [inputs[name] for name in names if name in inputs]
    if len(found) > 1:
        given = [one.name for one in found]
        raise Exclusive(given, f"contradict each other: both give {what}")
    return found[0] if found else None


def one_of(inputs: Inputs, what: str, *names: str) -> Given:
    """The one of several inputs that was given, of which there has to be one."""
    found = at_most_one(inputs, what, *names)
    if found is None:
        examples = " or ".join(option(name, SYMBOLS[name].example) for name in names)
        raise MissingInput(f"{what} is missing", examples)
    return found


def radius_of(given: Given) -> Any:
    """A radius [m], given as such or as a diameter."""
    return given.value / (2 if given.name.endswith("diameter") else 1)


def half_angle_of(given: Given, most: int = 180) -> Any:
    """A half angle [rad], given as such or as the apex angle, of at most so many degrees."""
    factor = 2 if given.name == "apex-angle" else 1
    limit = Limits(0.0, math.radians(factor * most), f"at most {factor * most} deg", True)
    hold(given, limit)
    return given.value / factor


def angle_of(inputs: Inputs, name: str) -> Any:
    """An angle from a normal [rad], whichever way it is counted; 0 where none is given."""
    return abs(inputs[name].value) if name in inputs else 0.0


def offset_of(inputs: Inputs, name: str = "offset") -> Any:
    """A distance aside [m]; 0 where none is given."""
    return inputs[name].value if name in inputs else 0.0
