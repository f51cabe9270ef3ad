"""The scales: units that are read through a function, with their spellings and sources."""

import math
from typing import Any

from radcalc import maths
from radcalc.errors import RadcalcError, UnitError, alternatives, mention, quote
from radcalc.tuples import NamedTuple
from radcalc.units import single
from radcalc.units.dimensions import SOLID_ANGLE
from radcalc.units.grammar import parse_unit

K, C = 12.5, 250.0  # cd s/m2 and lx s: the constants of most makers of light meters
CONSTANTS = {  # the assumed constants of a light meter, and values of other meters
    "k": ("K = 12.5 cd s/m2", "some makers use 14"),
    "c": ("C = 250 lx s", "meters with a dome-shaped diffuser use 320 to 340"),
}
GAINS = ("dB", "stops")  # scales of ratios on which more is more light


class Scale(NamedTuple):
    """A scale: its spellings, its function, the assumption in reading it, and its source.

    The reference is `size` times `unit`; `letter` is the symbol of the quantity, `constant` that of
    the light meter's constant that determines the size.
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
        return self.spellings[0]

    @property
    def reference(self) -> str:
        return f"{self.size:.7g} {self.unit}".removesuffix(" 1")

    @property
    def formula(self) -> str:
        return self.of(self.letter)

    def of(self, quantity: str) -> str:
        if not self.steps:
            return f"{self.reference} / {quantity}"
        inner = quantity if self.reference == "1" else f"{quantity} / {self.reference}"
        log = f"{'lg' if self.base == 10 else 'lb'}({inner})"
        log = {1.0: log, -1.0: f"-{log}"}.get(self.steps, f"{self.steps:g} {log}")
        return f"{self.zero:g} + {log}" if self.zero else log

    def inverse(self, reading: str = "n") -> str:
        if not self.steps:
            return f"{self.letter} = {self.reference} / {reading}"
        n = f"({reading})" if reading.startswith("-") and self.steps < 0 else reading
        n = f"{n} - {self.zero:g}" if self.zero else n
        power = {1.0: n, -1.0: f"-{n}", -2.5: f"-0.4 * {n}"}.get(self.steps, f"{n}/{self.steps:g}")
        head = "" if self.reference == "1" else f"{self.reference} * "
        return f"{self.letter} = {head}{self.base}^{power if power.isalnum() else f'({power})'}"

    def quantity(self, reading: Any) -> Any:
        """Return the quantity of a reading, in the scale's unit."""
        if not self.steps:
            return self.size / reading
        return self.size * maths.power(float(self.base), (reading - self.zero) / self.steps)

    def reading(self, quantity: Any) -> Any:
        if not self.steps:
            return self.size / quantity
        log = maths.log10 if self.base == 10 else maths.log2
        return self.zero + self.steps * log(quantity / self.size)

    def of_meter(self, constant: Any) -> "Scale":
        """Return the scale of a light meter with its own constant [SI]."""
        return self._replace(size=constant / 100)

    def change(self, of: "Scale") -> float:
        """Return the change of a reading by a gain of 1 on another scale; 0 if it has no gains."""
        if of.name not in GAINS or not self.steps or self.unit == "1":
            return 0.0
        return self.steps / of.steps * math.log(of.base, self.base)

    def slope(self, reading: Any) -> Any:
        """Return the derivative of the quantity, in the scale's unit, over the reading."""
        if not self.steps:
            return -self.size / reading / reading
        return self.quantity(reading) * maths.log(float(self.base)) / self.steps


def _power(spellings: str, unit: str) -> Scale:
    return Scale(
        tuple(spellings.split()), "P", unit, 1, 10, 10, 0, "a level of power", "IEC 60027-3"
    )


# The zero point of magnitudes; per square second of arc it is 1.0806e5 cd/m2.
MAGNITUDE = Scale(
    ("mag", "Vmag", "vmag", "magnitude", "magnitudes"), "E", "lx", 2.54e-6, 10, -2.5, 0,
    "V band, above the atmosphere; published zero points differ by up to a third",
    "Allen, Astrophysical Quantities",
)  # fmt: skip
# 0 is 10^(-48.60 / 2.5) erg/s/cm2/Hz, in Jy.
AB_MAGNITUDE = Scale(
    ("ABmag", "AB mag", "mag AB", "mag(AB)"), "E_nu", "Jy", 10 ** (23 - 48.6 / 2.5), 10, -2.5, 0,
    "an AB magnitude, at one frequency", "Oke and Gunn 1983, Astrophysical Journal 266, 713",
)  # fmt: skip
IN_AB = {"mag": "ABmag", "mag/arcsec2": "ABmag/arcsec2"}  # of a magnitude of the V band
# AB magnitudes of Vega, whose own magnitudes are 0: U to I and u to z of Blanton and Roweis 2007, G
# of Gaia EDR3, the difference of the zero points of Riello et al. 2021.
OF_VEGA = {
    "U": 0.79, "B": -0.09, "V": 0.02, "R": 0.21, "I": 0.45,
    "u": 0.91, "g": -0.08, "r": 0.16, "i": 0.37, "z": 0.54, "G": 0.1137,
}  # fmt: skip


def _of_band(band: str, of_vega: float) -> list[Scale]:
    """Return the magnitudes of a band: by Vega, and AB."""
    in_ab = AB_MAGNITUDE._replace(
        spellings=(f"ABmag_{band}", f"{band} ABmag", f"{band} AB mag", f"{band} mag AB"),
        unit=f"Jy_{band}",
        meaning=f"an AB magnitude in the band {band}, above the atmosphere",
    )
    paper = "Blanton and Roweis 2007, Astronomical Journal 133, 734"
    source = "Riello et al. 2021, Astronomy and Astrophysics 649, A3" if band == "G" else paper
    by_vega = in_ab._replace(
        spellings=(f"mag_{band}", f"{band} mag", f"{band} Vega mag"),
        size=AB_MAGNITUDE.size * 10 ** (-0.4 * of_vega),
        meaning=f"a Vega magnitude in the band {band}: Vega has {of_vega:g} mag in AB",
        source=source,
    )
    return [by_vega, in_ab]


LUMINANCE_EV = Scale(
    ("EV", "EV100"), "L", "cd/m2", K / 100, 2, 1, 0,
    "a luminance at ISO 100", "ISO 2720", "k",
)  # fmt: skip
ILLUMINANCE_EV = LUMINANCE_EV._replace(
    letter="E", unit="lx", size=C / 100, meaning="an illuminance at ISO 100", constant="c",
)  # fmt: skip
SCALES = (
    _power("dBm dB(mW) dB(1mW) dBmW дБм", "mW"),
    _power("dBW dB(W) dB(1W) дБВт", "W"),
    _power("dBu(W) dBuW dB(uW) dB(1uW)", "uW"),
    MAGNITUDE,
    MAGNITUDE._replace(
        spellings=("mag/arcsec2", "mpsas"),
        meaning="V band; published zero points differ by up to a third", letter="L", unit="cd/m2",
        size=MAGNITUDE.size * (180 * 3600 / math.pi) ** 2,
    ),
    AB_MAGNITUDE,
    AB_MAGNITUDE._replace(
        spellings=("ABmag/arcsec2",), letter="L_nu", unit="Jy/arcsec2",
        meaning="an AB magnitude of a square second of arc, at one frequency",
    ),
    *[scale for band, of_vega in OF_VEGA.items() for scale in _of_band(band, of_vega)],
    LUMINANCE_EV,
    ILLUMINANCE_EV,
    Scale(
        ("mired", "mireds", "mirek", "mireks"), "T", "K", 1e6, 10, 0, 0,
        "reciprocal colour temperature, in 1/MK", "ANSI/IES LS-1, reciprocal color temperature",
    ),
    Scale(
        ("OD", "optical density"), "tau", "1", 1, 10, -1, 0,
        "optical density, of the transmitted part of the light",
        "CIE S 017, transmittance optical density",
    ),
    Scale(
        ("stops", "stop"), "x", "1", 1, 2, 1, 0,
        "the step of a ratio: the reading is positive for more light, negative for a filter",
        "a step of exposure values (ISO 2720)",
    ),
    Scale(
        ("dB", "decibel", "decibels", "дБ"), "x", "1", 1, 10, 10, 0,
        "a ratio of powers: the reading is positive for more light, negative for a loss",
        "IEC 60027-3",
    ),
    Scale(
        ("bril", "brils"), "L", "lambert", 1, 2, 1, 100,
        "each step doubles the luminance; 'bril' is also a name for 1e-7 lambert, and for a unit "
        "of sensation",
        "GNU units, bril",
    ),
)  # fmt: skip

REFUSED = {
    "dBu": "dBu(W) or dBuW for a power: dBu alone is a voltage",
    "dBuV": "dBu(W) for a power",
    "dBV": "dBW for a power",
    "SQM": "mag/arcsec2 for a reading of a sky quality meter",
}
SIZES = {scale.constant: scale.size for scale in SCALES if scale.constant}
# Symbols match as written, names in any case; several scales may share a spelling.
BY_SPELLING: dict[str, list[Scale]] = {}
BY_NAME: dict[str, list[Scale]] = {}
for _scale in SCALES:
    for _spelling in _scale.spellings:
        BY_SPELLING.setdefault(_spelling, []).append(_scale)
        if len(_spelling) > 3 and _spelling.islower():
            BY_NAME.setdefault(_spelling, []).append(_scale)


# Spellings of magnitudes of bands that have a blank.
OF_BANDS = {spelling for spelling in BY_SPELLING if " " in spelling and spelling[1:2] == " "}


def usual(constant: str, settable: bool = False) -> str:
    """Return the assumed constant of a light meter, with its symbol if it can be given."""
    assumed, others = CONSTANTS[constant]
    return f"{assumed} ({others}{mention(f': {{{constant}}}') if settable else ''})"


def named(text: str) -> list[Scale]:
    """Return the scales with a spelling: symbols match as written, names in any case."""
    head, bracket, reference = text.partition("(")  # dB (1 mW), but not dBm W
    bare = head.rstrip() + bracket + reference.replace(" ", "")
    folded = text.lower().replace("_", " ")
    rows = BY_SPELLING.get(bare) or BY_NAME.get(folded) or []
    if rows or "mag" not in text:
        return rows
    try:  # mag/arcsec^2, mag arcsec-2, mag/arcmin2
        (mag, one, _), (name, power, _) = parse_unit(text)
    except (RadcalcError, ValueError):
        return []
    unit, rows = single(name), BY_SPELLING.get(f"{mag}/arcsec2", [])
    if one != 1 or not unit or tuple([-power * n for n in unit.dimension]) != SOLID_ANGLE:
        return []
    ratio = unit.factor**power * (math.pi / 180 / 3600) ** 2
    if math.isclose(ratio, 1):
        return rows
    return [row._replace(spellings=(text,), size=row.size * ratio) for row in rows]


def refuse(spelling: str) -> UnitError | None:
    """Return the error for a spelling that is a scale, or nearly one, but not a unit."""
    name = quote(spelling)
    if spelling in REFUSED:
        hint = REFUSED[spelling]
        return UnitError(f"'{name}' is not accepted as a scale", hint, alternatives(spelling, hint))
    if rows := named(spelling):
        scale = rows[0]
        return UnitError(
            f"'{name}' is a scale, {scale.formula}, not a unit: it cannot be multiplied or divided",
            f"the value in {scale.unit}" if scale.unit != "1" else "the ratio as a number",
        )
    return None


def spellings() -> list[str]:
    """Return every spelling of a scale."""
    return list(dict.fromkeys(spelling for scale in SCALES for spelling in scale.spellings))
