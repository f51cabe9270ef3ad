"""Scales: what is read through a function, such as dBm, and what a reading on one stands for.

A scale is a row of `SCALES`.  With a reference x0 in its unit, a quantity x reads

    n = zero + steps lg(x / x0)     with lb in place of lg where the base is 2
    n = x0 / x                      where there are no steps: reciprocal

so that no reading can be multiplied by anything, nor added to another.
"""

import math
from collections.abc import Iterable
from typing import Any, NamedTuple

from radcalc import maths
from radcalc.errors import ConversionError, NumberError, RadcalcError, UnitError, mention, quote
from radcalc.units.amounts import Amount
from radcalc.units.grammar import parse_unit, plain
from radcalc.units.numbers import read_number
from radcalc.units.table import CELSIUS, TEMPERATURE_ALONE, Dimension, Unit, lookup, resolve

K, C = 12.5, 250.0  # cd s/m2 and lx s: what most makers of light meters use
METER_UNITS = {"k": "cd.s/m2", "c": "lx.s"}  # of its constants, which people write bare
CONSTANTS = {  # what is assumed of a light meter where nobody says it, and what others have
    "k": ("K = 12.5 cd s/m2", "some makers have 14"),
    "c": ("C = 250 lx s", "320 to 340 with a dome"),
}


class Scale(NamedTuple):
    """A scale: how it is spelled, its function, what is assumed in reading it, and says who.

    The reference is `size` times `unit`; `letter` is that of the quantity.  `constant` is the
    symbol of the light meter's constant that gives the size.
    """

    spellings: tuple[str, ...]
    letter: str
    unit: str
    size: float
    base: int
    steps: float
    zero: float
    meaning: str
    source: str
    constant: str = ""

    @property
    def name(self) -> str:
        """The first of its spellings."""
        return self.spellings[0]

    @property
    def reference(self) -> str:
        """The reference with its unit."""
        return f"{self.size:.7g} {self.unit}".removesuffix(" 1")

    @property
    def formula(self) -> str:
        """The reading of a quantity."""
        return self.of(self.letter)

    def of(self, quantity: str) -> str:
        """The reading of a quantity that is written so."""
        if not self.steps:
            return f"{self.reference} / {quantity}"
        inner = quantity if self.reference == "1" else f"{quantity} / {self.reference}"
        log = f"{'lg' if self.base == 10 else 'lb'}({inner})"
        log = {1.0: log, -1.0: f"-{log}"}.get(self.steps, f"{self.steps:g} {log}")
        return f"{self.zero:g} + {log}" if self.zero else log

    def inverse(self, reading: str = "n") -> str:
        """The quantity of a reading."""
        if not self.steps:
            return f"{self.letter} = {self.reference} / {reading}"
        n = f"({reading})" if reading.startswith("-") and self.steps < 0 else reading
        n = f"{n} - {self.zero:g}" if self.zero else n
        power = {1.0: n, -1.0: f"-{n}", -2.5: f"-0.4 * {n}"}.get(self.steps, f"{n}/{self.steps:g}")
        head = "" if self.reference == "1" else f"{self.reference} * "
        return f"{self.letter} = {head}{self.base}^{power if power.isalnum() else f'({power})'}"

    def quantity(self, reading: Any) -> Any:
        """What a reading stands for, in the scale's unit: a float, or whatever has powers."""
        if not self.steps:
            return self.size / reading
        return self.size * float(self.base) ** ((reading - self.zero) / self.steps)

    def reading(self, quantity: Any) -> Any:
        """The reading of a quantity in the scale's unit."""
        if not self.steps:
            return self.size / quantity
        log = maths.log10 if self.base == 10 else maths.log2
        return self.zero + self.steps * log(quantity / self.size)

    def of_meter(self, constant: Any) -> "Scale":
        """The scale of a light meter that has a constant of its own [SI]."""
        return self._replace(size=constant / 100)

    def slope(self, reading: Any) -> Any:
        """By how much the quantity grows with the reading, in the scale's unit."""
        if not self.steps:
            return -self.size / reading / reading
        return self.quantity(reading) * maths.log(float(self.base)) / self.steps


def _power(spellings: str, unit: str) -> Scale:
    return Scale(
        tuple(spellings.split()), "P", unit, 1, 10, 10, 0, "a level of power", "IEC 60027-3"
    )


# The zero point of magnitudes stands once; per square second of arc it is 1.0806e5 cd/m2.
MAGNITUDE = Scale(
    ("mag", "Vmag", "vmag", "magnitude", "magnitudes"), "E", "lx", 2.54e-6, 10, -2.5, 0,
    "V band, above the atmosphere; zero points in print differ by up to a third",
    "Allen, Astrophysical Quantities",
)  # fmt: skip
LUMINANCE_EV = Scale(
    ("EV", "EV100"), "L", "cd/m2", K / 100, 2, 1, 0,
    "of the luminance, at ISO 100", "ISO 2720", "k",
)  # fmt: skip
ILLUMINANCE_EV = LUMINANCE_EV._replace(
    letter="E", unit="lx", size=C / 100, meaning="of the illuminance, at ISO 100", constant="c",
)  # fmt: skip
SCALES = (
    _power("dBm dB(mW) dB(1mW) dBmW дБм", "mW"),
    _power("dBW dB(W) dB(1W) дБВт", "W"),
    _power("dBu(W) dBuW dB(uW) dB(1uW)", "uW"),
    MAGNITUDE,
    MAGNITUDE._replace(
        spellings=("mag/arcsec2", "mpsas"),
        meaning="V band; zero points in print differ by up to a third", letter="L", unit="cd/m2",
        size=MAGNITUDE.size * (180 * 3600 / math.pi) ** 2,
    ),
    LUMINANCE_EV,
    ILLUMINANCE_EV,
    Scale(
        ("mired", "mireds"), "T", "K", 1e6, 10, 0, 0,
        "reciprocal colour temperature, in 1/MK", "ANSI/IES LS-1, reciprocal color temperature",
    ),
    Scale(
        ("OD", "optical density"), "tau", "1", 1, 10, -1, 0,
        "optical density, of the part of the light that is left",
        "CIE S 017, transmittance optical density",
    ),
    Scale(
        ("stops", "stop"), "x", "1", 1, 2, 1, 0,
        "a ratio, above 0 for more light: a filter has less than 0",
        "a step of exposure values (ISO 2720)",
    ),
    Scale(
        ("dB", "decibel", "decibels", "дБ"), "x", "1", 1, 10, 10, 0,
        "a ratio of powers, above 0 for more light: a loss is below 0", "IEC 60027-3",
    ),
    Scale(
        ("bril", "brils"), "L", "lambert", 1, 2, 1, 100,
        "a step is twice the luminance; others call 1e-7 lambert or a sensation so",
        "GNU units, bril",
    ),
)  # fmt: skip

REFUSED = {
    "dBu": "dBu(W) or dBuW for a power: dBu alone is a voltage",
    "dBuV": "dBu(W) for a power",
    "dBV": "dBW for a power",
    "SQM": "mag/arcsec2 for a reading of a sky quality meter",
}
RECIPROCAL = next(scale for scale in SCALES if not scale.steps)


class ScaleUnit(Unit):
    """A scale as a user wrote it, where a unit may stand: what its readings stand for is in `unit`.

    It counts as its unit for everything but its numbers; `others` are other readings of the text.
    """

    __slots__ = ("others", "scale", "unit")
    is_scale = True

    def __init__(self, text: str, scale: Scale, others: "tuple[ScaleUnit, ...]" = ()) -> None:
        """Hold the reading of `text`."""
        unit = resolve(scale.unit)
        super().__init__(text, unit.top, unit.bottom, unit.dimension, unit.atoms)
        self.unit = unit
        self.scale = scale
        self.others = others

    @property
    def assumption(self) -> str:
        """How a reading is read, in one line."""
        return self.told()

    def told(self, settable: bool = False) -> str:
        """How a reading is read; a constant of light meters may be one that can be given."""
        scale = self.scale
        told = f"{quote(self.text)}: {scale.inverse()}, {scale.meaning}"
        if scale.constant and scale.size == SIZES[scale.constant]:
            told += f", {usual(scale.constant, settable)}"
        return told

    def quantity(self, reading: Any) -> Any:
        """What a reading stands for, in `unit`."""
        told = f"{reading:.12g} " if isinstance(reading, float) else ""
        told += quote(self.text)
        if not self.scale.steps and maths.any_true(reading <= 0):
            is_shift = isinstance(reading, float) and reading < 0
            shift = "a difference, as filters have, and " if is_shift else ""
            raise NumberError(f"{told} is {shift}the reciprocal of no temperature", "more than 0")
        try:
            found = self.scale.quantity(reading)
        except (OverflowError, ZeroDivisionError):
            found = 0.0
        if maths.any_true((found < maths.SMALLEST) | (found - found != 0)):
            raise NumberError(f"{told} is beyond what a number holds", "less extreme values")
        return found

    def reading(self, quantity: Any) -> Any:
        """The reading of a quantity in `unit`, of which there is none for 0 and below."""
        if maths.is_uncertain(quantity):
            reading = self.reading(quantity.nominal_value)
            return reading + (quantity - quantity.nominal_value) / self.slope(reading)
        if maths.any_true(quantity <= 0):
            told = f"{quantity:.6g} {self.unit.text}" if isinstance(quantity, float) else "0"
            told = told.removesuffix(" 1")
            raise ConversionError(f"{told} has no reading on {quote(self.text)}", "more than 0")
        return self.scale.reading(quantity) + 0.0

    def slope(self, reading: Any) -> Any:
        """By how much the quantity in `unit` grows with the reading."""
        return self.scale.slope(reading)

    def measures(self, dimensions: Iterable[Dimension]) -> "ScaleUnit":
        """The reading of the text that measures one of the dimensions; this where none does."""
        wanted = tuple(dimensions)
        return next((one for one in (self, *self.others) if one.dimension in wanted), self)

    def with_constants(self, values: dict[str, float]) -> "ScaleUnit":
        """The scale of a light meter with other constants than the usual ones [SI]."""
        others = tuple([one.with_constants(values) for one in self.others])
        scale = self.scale
        if scale.constant in values:
            scale = scale.of_meter(values[scale.constant])
        return ScaleUnit(self.text, scale, others)


SIZES = {scale.constant: scale.size for scale in SCALES if scale.constant}
# Symbols are as they are written, names of words in any case; several scales may have one.
BY_SPELLING: dict[str, list[Scale]] = {}
BY_NAME: dict[str, list[Scale]] = {}
for _scale in SCALES:
    for _spelling in _scale.spellings:
        BY_SPELLING.setdefault(_spelling, []).append(_scale)
        if len(_spelling) > 3 and _spelling.islower():
            BY_NAME.setdefault(_spelling, []).append(_scale)


def usual(constant: str, settable: bool = False) -> str:
    """What is assumed of a light meter's constant, where it can be given with its symbol."""
    assumed, others = CONSTANTS[constant]
    return f"{assumed} ({others}{mention(f': {{{constant}}}') if settable else ''})"


def find(text: str) -> ScaleUnit | None:
    """Read the text of a scale; None where it is none."""
    text = " ".join(text.split())
    rows = _named(plain(text))
    if not rows:
        return None
    others = tuple([ScaleUnit(text, row) for row in rows[1:]])
    return ScaleUnit(text, rows[0], others)


def _named(text: str) -> list[Scale]:
    """The rows of a spelling: symbols as they are written, names of words in any case."""
    bare, folded = text.replace(" ", ""), text.lower().replace("_", " ")
    rows = BY_SPELLING.get(bare) or BY_NAME.get(folded) or []
    if rows or "mag" not in text:
        return rows
    try:  # mag/arcsec^2, mag arcsec-2
        atoms = [(name, power) for name, power, _ in parse_unit(text)]
        area = [(lookup(name), power) for name, power in atoms if name != "mag"]
    except RadcalcError:
        return []
    is_area = ("mag", 1) in atoms and area == [(("", "arcsecond"), -2)]
    return [scale for scale in SCALES if "mpsas" in scale.spellings and is_area]


def resolve_any(text: str) -> Unit:
    """Read the text of a unit or of a scale.

    Raises UnitError for a text that is neither.
    """
    return find(text) or resolve(text)


def refuse_product(text: str, scale: str) -> None:
    """Refuse 2*10 dBm, which people read in two ways."""
    if "*" not in text:
        return  # nor has to begin with a number: (10±1) dBm
    number, end = read_number(text)
    if "*" in text[:end]:
        raise NumberError(
            f"'{quote(text)}' multiplies, and a reading of {quote(scale)} cannot be multiplied",
            f"{number:.12g} {quote(scale)} for one reading",
        )


def scale_of(unit: Unit) -> Scale | None:
    """The scale that stands where a unit may; None for a unit."""
    return unit.scale if isinstance(unit, ScaleUnit) else None


def amount_on(
    unit: Unit, text: str, reading: float, uncertainty: float, dimensions: Iterable[Dimension]
) -> Amount:
    """What a reading stands for, with the uncertainty that its own leads to."""
    assert isinstance(unit, ScaleUnit)
    scale = unit.measures(dimensions)
    quantity = scale.quantity(reading)
    told = (scale.assumption,)
    if not uncertainty:
        return Amount(text, quantity, scale.unit, 0.0, told, scale, reading)
    from radcalc.units.uncertain import Part, hold

    def at(times: float) -> float | None:
        try:
            return float(scale.quantity(reading + times * uncertainty))
        except RadcalcError:
            return None

    size = scale.slope(reading) * uncertainty
    hold(abs(size) or math.nan, text)
    part = Part(text, size, at)
    return Amount(text, quantity, scale.unit, abs(size), told, scale, reading, parts=(part,))


def reciprocal(unit: Unit) -> ScaleUnit:
    """A unit such as 1/MK as the scale of temperatures that has the reciprocals."""
    return ScaleUnit(unit.text, RECIPROCAL._replace(size=unit.bottom / unit.top))


FAHRENHEIT = ("°f", "degf", "deg_f", "degree_fahrenheit", "degrees_fahrenheit", "fahrenheit")


def degree(text: str) -> Unit | None:
    """A degree Celsius or Fahrenheit, where a difference is meant; None for what is neither."""
    name = plain(text).lower().replace("° ", "°")
    name = name.replace(" ", "_").replace("-", "_")
    if name in CELSIUS:
        return Unit(text, 1, 1, TEMPERATURE_ALONE, ((name, 1),))
    return Unit(text, 5, 9, TEMPERATURE_ALONE, ((name, 1),)) if name in FAHRENHEIT else None


def resolve_given(text: str) -> Unit:
    """Read the unit of what was given, in which a degree is that of a difference."""
    return degree(text) or resolve_any(text)


def in_which(text: str, dimensions: Iterable[Dimension]) -> Unit:
    """The unit of what was typed as a reading, or in degrees that count a difference."""
    if scale := find(text):
        return scale.measures(dimensions).unit
    return resolve("K" if degree(text) else text)


def refuse(spelling: str) -> UnitError | None:
    """What to say of a spelling that is no unit, but a scale or nearly one."""
    shown = quote(spelling)
    if spelling in REFUSED:
        return UnitError(f"'{shown}' is not accepted as a scale", REFUSED[spelling])
    if rows := _named(spelling):
        scale = rows[0]
        return UnitError(
            f"'{shown}' is a scale, {scale.formula}, and no unit that is multiplied or divided",
            f"a number of {scale.unit}" if scale.unit != "1" else "the ratio as a number",
        )
    return None


def on(dimension: Dimension) -> list[Scale]:
    """The scales on which a quantity is read."""
    return [scale for scale in SCALES if resolve(scale.unit).dimension == dimension]


def names_of(dimension: Dimension) -> list[str]:
    """Their names."""
    return [scale.name for scale in on(dimension)]


def spellings() -> list[str]:
    """Every spelling of a scale."""
    return list(dict.fromkeys(one for scale in SCALES for one in scale.spellings))
