"""Text to units and back: the definitions, the grammar and the compiled table.

This module has dimensions and units.
"""

from _thread import _local

from radcalc.floats import divide
from radcalc.units.compiled import NAMES, NOTES, PREFIX_NAMES, PREFIX_SYMBOLS, SYMBOLS, UNITS

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing


if TYPE_CHECKING:
    from typing import Any, TypeVar

    Kind = TypeVar("Kind", bound="Unit")

# The order of the exponents in a dimension.
BASES = (
    "length",
    "mass",
    "time",
    "temperature",
    "angle",
    "cycle",
    "count",
    "luminosity",
    "retinal_illuminance",
    "current",
    "weight",
)
MASS_AT, TIME_AT, CYCLE_AT, COUNT_AT, LUMINOSITY_AT = 1, 2, 5, 6, 7  # places in BASES
WEIGHT_AT, CURRENT_AT = 10, 9
# The exponent of `weight` has the exponents of all weights of spectra as digits, from -32 to 31,
# one at the place of each: one slot of the dimension has (weight, exponent).
WEIGHT_BASE = 64
Dimension = tuple[int, ...]
NUMBER: Dimension = (0,) * len(BASES)
LENGTH_ALONE: Dimension = (1, *NUMBER[1:])
INVERSE_LENGTH: Dimension = (-1, *NUMBER[1:])
TEMPERATURE_ALONE: Dimension = (0, 0, 0, 1, *NUMBER[4:])
INVERSE_TEMPERATURE: Dimension = (0, 0, 0, -1, *NUMBER[4:])
FIELD_STRENGTH: Dimension = (1, 1, -3, *NUMBER[3:9], -1, 0)  # V/m
# Units of length that are read as a wavelength in the divisor of a light quantity.
WAVELENGTH_UNITS = ("nanometre", "micrometre", "picometre", "angstrom", "micron")
EXITANCE_UNITS = ("radlux", "radphot")
PI = UNITS["degree"][0] * 180, UNITS["degree"][1]  # as a ratio of whole numbers
LUMINOUS_AND_COUNTED = (MASS_AT, COUNT_AT, LUMINOSITY_AT)


class Unit:
    """A unit as the user wrote it, with its value in coherent SI units.

    `top / bottom` is the exact factor; `dimension` has the exponents of `BASES`; `atoms` are
    (canonical name, exponent); `notes` are the assumptions in reading it.
    """

    __slots__ = ("atoms", "bottom", "dimension", "notes", "text", "top")
    is_scale = False  # True for a scale, which differs from its unit in its numbers only

    def __init__(
        self,
        text: str,
        top: int,
        bottom: int,
        dimension: Dimension,
        atoms: tuple[tuple[str, int], ...],
        notes: tuple[str, ...] = (),
    ) -> None:
        self.text = text
        self.top = top
        self.bottom = bottom
        self.dimension = dimension
        self.atoms = atoms
        self.notes = notes

    def __repr__(self) -> str:
        """Show the text."""
        return f"Unit({self.text!r})"

    def quantity(self, reading: "Any") -> "Any":
        """Return a number in the unit; overridden by scales."""
        return reading

    def slope(self, reading: "Any") -> "Any":
        """Return the derivative of the quantity over the number; overridden by scales."""
        return 1.0

    def of_class(self, kind: "type[Kind]", *notes: str) -> "Kind":
        all_notes = (*self.notes, *notes)
        return kind(self.text, self.top, self.bottom, self.dimension, self.atoms, all_notes)

    @property
    def has_wavelength(self) -> bool:
        return any(name in WAVELENGTH_UNITS and power == -1 for name, power in self.atoms)

    @property
    def is_light(self) -> bool:
        """Return whether it contains watts, lumens or photons, or has a mass."""
        return any(self.dimension[i] for i in LUMINOUS_AND_COUNTED)

    @property
    def is_exitance(self) -> bool:
        """Return whether it counts light that leaves a surface: the radlux and the radphot."""
        return any(name in EXITANCE_UNITS for name, _ in self.atoms)

    @property
    def factor(self) -> float:
        """The value of the unit in coherent SI units, rounded once."""
        return divide(self.top, self.bottom)


class Exitance(Unit):
    """A unit of exitance, from the name of the quantity, which distinguishes lm/m2 from lx."""

    __slots__ = ()
    is_exitance = True


class Photosynthetic(Unit):
    """A unit of photons from 400 nm to 700 nm only; `name` is the typed PPFD or PPF."""

    __slots__ = ("name",)
    name: str


class Daily(Photosynthetic):
    """A unit of photons from 400 nm to 700 nm in a day: of a DLI."""

    __slots__ = ()


def lookup(spelling: str) -> tuple[str, str] | None:
    """Return (prefix name, unit name) of a spelling; None if it is unknown.

    Symbols match as written; full names match in any case, with hyphens as underscores.
    """
    if spelling in SYMBOLS:
        return "", SYMBOLS[spelling]
    name = spelling.lower().replace("-", "_")
    if name in NAMES:
        return "", NAMES[name]
    if "-" in spelling and spelling.replace("-", "") in SYMBOLS:  # ft-L
        return "", SYMBOLS[spelling.replace("-", "")]
    for size in (2, 1):
        head, symbol = spelling[:size], spelling[size:]
        if head in PREFIX_SYMBOLS and symbol in SYMBOLS and takes(head, symbol):
            return PREFIX_SYMBOLS[head], SYMBOLS[symbol]
    for prefix in PREFIX_NAMES:
        if name.startswith(prefix):
            unit = NAMES.get(name[len(prefix) :].lstrip("_"))
            if unit and prefix in UNITS[unit][3]:
                return prefix, unit
    return None


def multiple(prefix: str, name: str) -> tuple[int, int, Dimension]:
    """Return the factor of a named unit with a prefix, as a ratio, and its dimension."""
    top, bottom, dimension, _ = UNITS[name]
    shift = PREFIX_NAMES[prefix] if prefix else 0
    return top * 10 ** max(shift, 0), bottom * 10 ** max(-shift, 0), dimension


def single(text: str) -> Unit | None:
    """Return the unit of one spelling in letters; None if it is unknown or read with a remark."""
    entry = lookup(text) if text.isalpha() else None
    if entry is None:
        return None
    top, bottom, dimension = multiple(*entry)
    if entry[1] in NOTES or entry[1] in OWN or dimension == INVERSE_LENGTH:
        return None
    return Unit(text, top, bottom, dimension, (("".join(entry), 1),))


# The names of a user's definitions: a note on each, and the names that it uses.
OWN: dict[str, tuple[str, tuple[str, ...]]] = {}
REFLECTANCES: dict[str, None] = {}  # those of reflectances
_read = _local()  # names that were read in a thread, in order, with the time of the last reading
_times = [0]  # the last time


def now() -> int:
    """Return a time for `own_since`."""
    _times[0] += 1
    return _times[0]


def read_own(name: str) -> None:
    """Keep a name that is being read, if it is one of a user's definitions."""
    if name in OWN:
        times = vars(_read)
        times.pop(name, None)
        times[name] = now()


def names_since(time: int) -> tuple[str, ...]:
    """Return the names of a user's definitions that were read since a time."""
    times, names = vars(_read), []
    for name in reversed(times):
        if times[name] < time:
            break
        names.append(name)
    return tuple([name for name in names[::-1] if name in OWN])


def own_since(time: int) -> tuple[str, ...]:
    """Return the notes on the definitions that were read since a time, and on those they use."""
    names = [*names_since(time)]
    known = {*names}
    for name in names:
        names += [used for used in OWN[name][1] if used not in known]
        known.update(OWN[name][1])
    return tuple([OWN[name][0] for name in names])


def takes(prefix: str, symbol: str) -> bool:
    """Return whether the prefix goes before this symbol: Cyrillic goes with Cyrillic."""
    allowed = UNITS[SYMBOLS[symbol]][3]
    return prefix.isascii() == symbol.isascii() and PREFIX_SYMBOLS[prefix] in allowed


def unit_behind(unit: str) -> str:
    """Return a unit as a suffix of a number, with a blank; '' for a plain number."""
    return "" if unit == "1" else f" {unit}"
