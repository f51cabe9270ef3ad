"""Dimensions, and the units that have them."""

from radcalc.units.compiled import NAMES, PREFIX_NAMES, PREFIX_SYMBOLS, SYMBOLS, UNITS

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
)
MASS_AT, TIME_AT, CYCLE_AT, COUNT_AT, LUMINOSITY_AT = 1, 2, 5, 6, 7  # where some stand in it
Dimension = tuple[int, ...]
NUMBER: Dimension = (0,) * len(BASES)
LENGTH_ALONE: Dimension = (1, *NUMBER[1:])
INVERSE_LENGTH: Dimension = (-1, *NUMBER[1:])
TEMPERATURE_ALONE: Dimension = (0, 0, 0, 1, *NUMBER[4:])
INVERSE_TEMPERATURE: Dimension = (0, 0, 0, -1, *NUMBER[4:])
FIELD_STRENGTH: Dimension = (1, 1, -3, *NUMBER[3:9], -1)  # V/m
# The units that make a length below a light quantity a wavelength.
WAVELENGTH_UNITS = ("nanometre", "micrometre", "picometre", "angstrom", "micron")
EXITANCE_UNITS = ("radlux", "radphot")
PI = UNITS["degree"][0] * 180, UNITS["degree"][1]  # as a ratio of whole numbers
LUMINOUS_AND_COUNTED = (MASS_AT, COUNT_AT, LUMINOSITY_AT)


class Unit:
    """A unit as a user wrote it, with what it is worth in coherent SI units.

    `top / bottom` is the exact factor; `dimension` has the exponents of `BASES`; `atoms` are
    (canonical name, exponent); `notes` say what was assumed in reading it.
    """

    __slots__ = ("atoms", "bottom", "dimension", "notes", "text", "top")
    is_scale = False  # which counts as a unit for everything but its numbers

    def __init__(
        self,
        text: str,
        top: int,
        bottom: int,
        dimension: Dimension,
        atoms: tuple[tuple[str, int], ...],
        notes: tuple[str, ...] = (),
    ) -> None:
        """Hold the reading of `text`."""
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
        """Return what a number in the unit stands for: itself, but on a scale."""
        return reading

    def slope(self, reading: "Any") -> "Any":
        """Return by how much the quantity grows with the number: as much, but on a scale."""
        return 1.0

    def of_class(self, kind: "type[Kind]", *notes: str) -> "Kind":
        """Return the same unit as one of another class, with more notes."""
        all_notes = (*self.notes, *notes)
        return kind(self.text, self.top, self.bottom, self.dimension, self.atoms, all_notes)

    @property
    def has_wavelength(self) -> bool:
        """Check whether a length that is usual for wavelengths stands below."""
        return any(name in WAVELENGTH_UNITS and power == -1 for name, power in self.atoms)

    @property
    def is_light(self) -> bool:
        """Check whether it counts watts, lumens or photons, or what has a mass."""
        return any(self.dimension[i] for i in LUMINOUS_AND_COUNTED)

    @property
    def is_exitance(self) -> bool:
        """Check whether it counts what leaves a surface: the radlux and the radphot."""
        return any(name in EXITANCE_UNITS for name, _ in self.atoms)

    @property
    def factor(self) -> float:
        """The unit in coherent SI units, rounded once."""
        return divide(self.top, self.bottom)


class Exitance(Unit):
    """A unit of what leaves a surface, by the name of the quantity: lm/m2 is not lx then."""

    __slots__ = ()
    is_exitance = True


class Photosynthetic(Unit):
    """A unit of the photons from 400 nm to 700 nm alone, by the name of PPFD or PPF.

    `name` is what was typed.
    """

    __slots__ = ("name",)
    name: str


def divide(over: int, under: int) -> float:
    """The quotient of two whole numbers, rounded once; infinite where a float cannot hold it."""
    try:
        return over / under
    except OverflowError:
        return float("inf")


def lookup(spelling: str) -> tuple[str, str] | None:
    """Find (prefix name, unit name) for one spelling; None where there is none.

    Symbols are matched as written; full names in any case, with hyphens as underscores.
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


def takes(prefix: str, symbol: str) -> bool:
    """Check whether the prefix goes before this symbol: Cyrillic goes with Cyrillic."""
    allowed = UNITS[SYMBOLS[symbol]][3]
    return prefix.isascii() == symbol.isascii() and PREFIX_SYMBOLS[prefix] in allowed


def unit_behind(unit: str) -> str:
    """A unit as it stands behind a number, with a blank: none is behind a plain number."""
    return "" if unit == "1" else f" {unit}"
