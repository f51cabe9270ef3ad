"""The conditions that a user can give, and how each is read.

A condition is an option of `convert` (`--distance 2m`) or a keyword of the Python API
(`distance="2m"`).  What factor it supplies is in `factors/`; which factors a conversion needs is
the business of `link.py`.
"""

import math
from typing import Any, NamedTuple

from radcalc import maths
from radcalc.answer import Step
from radcalc.errors import ConditionError, NumberError, RadcalcError, quote
from radcalc.quantities.light import (
    AREA,
    AXIS,
    DURATION,
    FLUX,
    FREQUENCY,
    RADIANT,
    RATIOS,
    SOLID_ANGLE,
    WAVELENGTH,
    WAVENUMBER,
    describe,
    powers,
    times,
)
from radcalc.spectra.observers import (
    OBSERVERS,
)
from radcalc.units.grammar import split_quantity
from radcalc.units.table import NUMBER, Dimension, Unit, divide, resolve

# What a condition is about; two conditions in one slot contradict each other.
LINK, TIME, AREA_SLOT, CONE, DISTANCE = "link", "time", "area", "solid angle", "distance"
BAND, REFLECTANCE, PUPIL = "bandwidth", "reflectance", "pupil"
REFINES = "refines"  # --observer and --incidence, which only refine another condition

EXTREME = 1e100  # squares and ratios of what is within stay within a float
LENGTH = powers(length=1)
ANGLE = powers(angle=1)
TEMPERATURE = powers(temperature=1)
ENERGY = times(FLUX[RADIANT], DURATION)
PHOTON_ENERGY = powers(mass=1, length=2, time=-2, count=-1)


class Option(NamedTuple):
    """A condition as a user can give it: a quantity, a choice, a text, else a flag."""

    name: str
    slot: str
    dimensions: tuple[Dimension, ...]
    takes: str
    example: str
    help: str
    choices: tuple[str, ...] = ()
    is_text: bool = False


OPTIONS = {
    option.name: option
    for option in (
        Option(
            "wavelength",
            LINK,
            (LENGTH, AXIS[FREQUENCY], AXIS[WAVENUMBER], ENERGY, PHOTON_ENERGY),
            "a wavelength, frequency, wavenumber or photon energy",
            "555nm",
            "Light of one wavelength (or frequency, wavenumber, photon energy).",
        ),
        Option(
            "spectrum",
            LINK,
            (),
            "a spectrum",
            "D65",
            "Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...",
            is_text=True,
        ),
        Option(
            "efficacy",
            LINK,
            tuple(RATIOS.values()),
            "a ratio of two kinds",
            "93lm/W",
            "A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol.",
        ),
        Option(
            "observer",
            REFINES,
            (),
            "an observer",
            "photopic",
            "Whose eyes see --wavelength or --spectrum.",
            tuple(OBSERVERS),
        ),
        Option(
            "range",
            REFINES,
            (),
            "two wavelengths",
            "380nm:780nm",
            "Where the watts of --spectrum are counted.",
            is_text=True,
        ),
        Option(
            "photon-range",
            REFINES,
            (),
            "two wavelengths",
            "400nm:700nm",
            "Where the photons of --spectrum are counted (default 400nm:700nm).",
            is_text=True,
        ),
        Option("time", TIME, (DURATION,), "a time", "1h", "Constant over that time."),
        Option("area", AREA_SLOT, (AREA,), "an area", "1m2", "Uniform over that area."),
        Option("radius", AREA_SLOT, (LENGTH,), "a length", "10cm", "Radius of a circular area."),
        Option(
            "diameter", AREA_SLOT, (LENGTH,), "a length", "20cm", "Diameter of a circular area."
        ),
        Option(
            "solid-angle",
            CONE,
            (SOLID_ANGLE,),
            "a solid angle",
            "1sr",
            "Uniform over that solid angle.",
        ),
        Option(
            "half-angle",
            CONE,
            (ANGLE,),
            "an angle",
            "30deg",
            "Uniform over the cone of that half angle, from axis to edge.",
        ),
        Option(
            "apex-angle",
            CONE,
            (ANGLE,),
            "an angle",
            "60deg",
            "Uniform over the cone of that full angle, from edge to edge.",
        ),
        Option("isotropic", CONE, (), "", "", "Uniform in all directions, over 4 pi sr."),
        Option("hemisphere", CONE, (), "", "", "Uniform over a hemisphere."),
        Option(
            "exponent",
            CONE,
            (NUMBER,),
            "a number",
            "1",
            "A lobe that falls off as a power of the cosine; 1 is Lambertian.",
        ),
        Option(
            "beam-angle",
            CONE,
            (ANGLE,),
            "an angle",
            "30deg",
            "A cosine-power lobe of that full angle at half the peak intensity.",
        ),
        Option(
            "distance",
            DISTANCE,
            (LENGTH,),
            "a length",
            "2m",
            "Straight line from a small source to the receiver.",
        ),
        Option(
            "incidence",
            REFINES,
            (ANGLE,),
            "an angle",
            "45deg",
            "Angle between the light and the receiver's normal (with --distance).",
        ),
        Option(
            "bandwidth",
            BAND,
            (AXIS[WAVELENGTH], AXIS[FREQUENCY], AXIS[WAVENUMBER]),
            "a width in wavelength, frequency or wavenumber",
            "10nm",
            "Width of a band in which the spectral density is constant.",
        ),
        Option(
            "reflectance",
            REFLECTANCE,
            (NUMBER,),
            "a number from 0 to 1",
            "0.8",
            "A Lambertian reflector, 0 to 1 or in %.",
        ),
        Option("pupil", PUPIL, (LENGTH,), "a length", "3mm", "Diameter of the eye's pupil."),
    )
}


class Given(NamedTuple):
    """A condition that was given: the option, the text as typed, the value in SI units.

    `number` and `unit` are those typed; `is_exact` where no text was, but a number of Python's.
    """

    option: Option
    text: str
    value: Any
    dimension: Dimension
    number: Any = None
    unit: Unit | None = None
    is_exact: bool = False

    @property
    def flag(self) -> str:
        """The option as one types it."""
        return f"--{self.option.name}"


class Factor(NamedTuple):
    """A number with a symbol that a quantity is multiplied or divided by."""

    symbol: str
    value: Any
    unit: str
    assumption: str
    steps: tuple[Step, ...] = ()
    notes: tuple[str, ...] = ()


def show(value: Any) -> str:
    """A number for a derivation; an array by its shape."""
    return f"{value:.6g}" if isinstance(value, (int, float)) else f"array{value.shape}"


def degrees(angle: Any) -> str:
    """An angle [rad] for a derivation."""
    return f"{show(angle * (180 / math.pi))} deg"


def give(name: str, value: Any) -> Given:
    """Read one condition of a conversion."""
    return read(OPTIONS[name], value)


def read(option: Option, value: Any) -> Given:
    """Read what an option was given.

    `value` is a text as on the command line, True for a flag, a number, or a number (or an
    array) with a `Unit`, and with a text if that says it better.
    """
    name = option.name
    if option.choices:
        if value not in option.choices:
            raise ConditionError(
                f"--{name} does not know '{quote(str(value))}'", ", ".join(option.choices)
            )
        return Given(option, str(value), value, NUMBER)
    if option.is_text:
        text = str(value).strip()
        return Given(option, text, _read_text(option, text), NUMBER)
    if not option.dimensions:
        if value is not True:
            raise ConditionError(f"--{name} takes no value", f"--{name} alone")
        return Given(option, "", True, NUMBER)
    if isinstance(value, str):
        text = value.strip().replace("\u2212", "-")
        number, unit_text = _split(option, text)
        unit = resolve(unit_text) if unit_text else None
    elif isinstance(value, tuple):
        number, unit, *said = value
        text = said[0] if said else f"{show(number)} {unit.text}"
    else:
        number, unit, text = value, None, show(value)
    dimension = unit.dimension if unit else NUMBER
    if dimension not in option.dimensions:
        if unit is None:
            raise ConditionError(
                f"--{name} {quote(text)} has no unit",
                f"--{name} {_with_unit(option, quote(text))} (one word, no blank)",
            )
        raise ConditionError(
            f"--{name} takes {option.takes}, not {describe(unit)}", f"--{name} {option.example}"
        )
    in_si = _in_si(option, text, number, unit)
    return Given(option, text, in_si, dimension, number, unit, not isinstance(value, str))


def _read_text(option: Option, text: str) -> Any:
    """A spectrum, or a range of wavelengths [nm]."""
    if option.name == "spectrum":
        from radcalc.spectra.sources import spectrum

        return spectrum(text)
    parts = text.split(":")
    ends = [give("wavelength", end) for end in parts] if all(map(_is_length, parts)) else []
    if len(ends) != 2:
        raise ConditionError(
            f"--{option.name} {quote(text)} is not a range of wavelengths",
            f"--{option.name} {option.example}",
        )
    low, high = (round(positive(end) * 1e9, 9) for end in ends)
    if low >= high:
        raise ConditionError(
            f"--{option.name} {quote(text)} ends before it starts", f"{ends[1].text}:{ends[0].text}"
        )
    return low, high


def _is_length(text: str) -> bool:
    try:
        value, unit = split_quantity(text)
        return value > 0 and bool(unit) and resolve(unit).dimension == LENGTH
    except RadcalcError:
        return False


def _split(option: Option, text: str) -> tuple[float, str]:
    try:
        return split_quantity(text)
    except NumberError as error:
        raise NumberError(f"--{option.name}: {error.message}", error.hint) from None


def _with_unit(option: Option, number: str) -> str:
    if ANGLE in option.dimensions and ("pi" in number or "π" in number):
        return f"{number}rad"
    return number + option.example.lstrip("0123456789.")


def _in_si(option: Option, text: str, number: Any, unit: Unit | None) -> Any:
    """The value in SI units; extremes that no light reaches would only overflow later."""
    value = number * (divide(unit.top, unit.bottom) if unit else 1)
    size = abs(value)
    extreme = (size > EXTREME) | ((size < 1 / EXTREME) & (size != 0)) | (size != size)
    if maths.any_true(extreme):
        raise ConditionError(
            f"--{option.name} {quote(text)} is beyond what radcalc reckons with",
            f"values from {1 / EXTREME:g} to {EXTREME:g} in SI units",
        )
    return value


def require(given: Given, good: bool, limit: str) -> None:
    """Refuse a value that is physically impossible, naming the limit."""
    if not good:
        raise ConditionError(f"{given.flag} {quote(given.text)} is not possible", limit)


def positive(given: Given) -> Any:
    """The value in SI units, which must be more than 0."""
    require(given, not maths.any_true(given.value <= 0), "more than 0")
    return given.value
