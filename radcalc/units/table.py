"""The compiled units at run time: text to a unit, spellings to suggestions.

The numbers come from `compiled.py`, which `compile.py` prints from what Pint says of
`light.txt`.  Factors are exact ratios of whole numbers, so the factor between any two units
is rounded once.
"""

from radcalc.errors import RadcalcError, UnitError, command, nearest, quote
from radcalc.units.compiled import (
    NAMES,
    NOTES,
    PREFIX_NAMES,
    PREFIX_SYMBOLS,
    REFUSED,
    SYMBOLS,
    UNITS,
)
from radcalc.units.grammar import parse_unit

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from typing import TypeVar

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
# A degree of a scale that has its 0 elsewhere, where a difference is meant.
CELSIUS = ("°c", "celsius", "centigrade", "degc", "deg_c", "degree_celsius", "degrees_celsius")
INVERSE_TEMPERATURE: Dimension = (0, 0, 0, -1, *NUMBER[4:])
FIELD_STRENGTH: Dimension = (1, 1, -3, *NUMBER[3:9], -1)  # V/m
# The units that make a length below a light quantity a wavelength.
WAVELENGTH_UNITS = ("nanometre", "micrometre", "picometre", "angstrom", "micron")
EXITANCE_UNITS = ("radlux", "radphot")
COMMON_PREFIXES = "GMkcmun"
# How scales are called, which are above and not looked for in other languages.
SCALE_NAMES = ("dBm", "dBW", "dBu", "mag", "EV", "mired", "OD", "stops", "dB", "bril")
PARTS = ("percent", "permille", "ppm", "ppb")
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

    def of_class(self, kind: "type[Kind]", *notes: str) -> "Kind":
        """The same unit as one of another class, with more notes."""
        told = (*self.notes, *notes)
        return kind(self.text, self.top, self.bottom, self.dimension, self.atoms, told)

    @property
    def has_wavelength(self) -> bool:
        """Whether a length that is usual for wavelengths stands below."""
        return any(name in WAVELENGTH_UNITS and power == -1 for name, power in self.atoms)

    @property
    def is_light(self) -> bool:
        """Whether it counts watts, lumens or photons, or what has a mass."""
        return any(self.dimension[i] for i in LUMINOUS_AND_COUNTED)

    @property
    def is_exitance(self) -> bool:
        """Whether it counts what leaves a surface: the radlux and the radphot."""
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
        if head in PREFIX_SYMBOLS and symbol in SYMBOLS and _takes(head, symbol):
            return PREFIX_SYMBOLS[head], SYMBOLS[symbol]
    for prefix in PREFIX_NAMES:
        if name.startswith(prefix):
            unit = NAMES.get(name[len(prefix) :].lstrip("_"))
            if unit and prefix in UNITS[unit][3]:
                return prefix, unit
    return None


def _takes(prefix: str, symbol: str) -> bool:
    """Whether the prefix goes before this symbol: Cyrillic goes with Cyrillic."""
    allowed = UNITS[SYMBOLS[symbol]][3]
    return prefix.isascii() == symbol.isascii() and PREFIX_SYMBOLS[prefix] in allowed


def resolve(text: str) -> Unit:
    """Read the text of a unit, as people write it.

    Raises UnitError for a text that is not a unit, with the nearest names as the hint.
    """
    unit = _read(text)
    if isinstance(unit, str):
        raise _unknown(unit)
    return unit


def unit_of(text: str) -> Unit | None:
    """A text as a unit; None where it is none, at the cost of no suggestions."""
    try:
        unit = _read(text) if text else None
    except RadcalcError:
        return None
    return None if isinstance(unit, str) else unit


def _read(text: str) -> Unit | str:
    """The unit of a text, or the spelling in it that is none; raise what else is wrong."""
    text = " ".join(text.split())  # it is shown as typed, but for blanks that part lines
    whole = text.lower().replace(" ", "_")
    if " " in text and whole in NAMES:  # a name of two words: foot lambert
        named = resolve(whole)
        named.text = text
        return named
    top = bottom = 1
    loose = ""
    light = False
    dimension = NUMBER
    inverted = 0
    atoms: list[tuple[str, int]] = []
    notes: tuple[str, ...] = ()
    try:
        parsed = parse_unit(text)
    except UnitError:
        if unit := _in_another_language(text):
            return unit
        raise
    for spelling, exponent, below in parsed:
        if spelling == "1":
            continue
        found = lookup(spelling)
        is_product = len(parsed) > 1 or exponent != 1
        if found is None and is_product and spelling.lower().replace("-", "_") in CELSIUS:
            found = "", "kelvin"
            notes += (f"{quote(spelling)} in a product counts a difference, in kelvins",)
        if found is None:
            return (spelling not in SCALE_NAMES and _in_another_language(text)) or spelling
        prefix, name = found
        if exponent not in (1, -1) and name in PARTS:
            hint = "brackets around the number with it, as in (50%)^2"
            raise UnitError(f"'{quote(text)}' is a power of {quote(spelling)}", hint)
        is_same = len(atoms) == 1 == exponent and text.startswith(f"{spelling}-")
        if is_same and len(parsed) == 2 and " " in text:  # 5m-1 m
            hint = f"blanks around a minus, or {quote(spelling)}^{atoms[0][1]} for a power"
            raise UnitError(f"'{quote(text)}' can be read in two ways", hint)
        unit_top, unit_bottom, powers, _ = UNITS[name]
        if prefix:
            shift = PREFIX_NAMES[prefix]
            unit_top *= 10 ** max(shift, 0)
            unit_bottom *= 10 ** max(-shift, 0)
        if exponent < 0:
            unit_top, unit_bottom = unit_bottom, unit_top
        top *= unit_top ** abs(exponent)
        bottom *= unit_bottom ** abs(exponent)
        dimension = tuple([a + exponent * b for a, b in zip(dimension, powers, strict=True)])
        atoms.append((prefix + name, exponent))
        if powers == LENGTH_ALONE and exponent == 1:
            inverted += below
            loose = "" if below else spelling
        light |= bool(
            powers[COUNT_AT] or powers[LUMINOSITY_AT] or (powers[MASS_AT] and powers[TIME_AT])
        )
        if name in NOTES and NOTES[name] not in notes:
            notes += (NOTES[name],)
    if loose and light and "(" not in text:
        raise UnitError(
            f"the unit '{quote(text)}' has a length that multiplies light",
            f"{_with(text, loose, f'({loose}-1)-1')} for a density per wavenumber, "
            f"{_with(text, loose, f'{loose}-1')} for one per length",
        )
    return _as_wavenumber(Unit(text, top, bottom, dimension, tuple(atoms), notes), inverted)


def _in_another_language(text: str) -> Unit | str:
    """Read a unit that is none in English as Czech or Russian; '' where it is none there."""
    from radcalc.units.languages import in_english

    english = in_english(text)
    unit = _read(english) if english else ""
    if isinstance(unit, str):
        if unit in REFUSED:
            raise _unknown(unit)
        return ""
    unit.text = text
    return unit


def _with(text: str, old: str, new: str) -> str:
    """The text of a unit with its last `old` made new."""
    before, _, after = text.rpartition(old)
    return quote(f"{before}{new}{after}")


def _as_wavenumber(unit: Unit, inverted: int) -> Unit:
    """Read an inverse length as a wavenumber where it stands alone or divides a light quantity."""
    cycles = 0
    if unit.dimension == INVERSE_LENGTH and len(unit.atoms) == 1:
        cycles, read = 1, f"{quote(unit.text)} is read as a wavenumber, in cycles per length"
    elif inverted == 1 and any(unit.dimension[i] for i in LUMINOUS_AND_COUNTED):
        cycles, read = -1, f"{quote(unit.text)} is read as a density per wavenumber"
    if cycles:
        powers = list(unit.dimension)
        powers[CYCLE_AT] += cycles
        unit.dimension = tuple(powers)
        unit.atoms = (*unit.atoms, ("cycle", cycles))
        unit.notes = (*unit.notes, read)
    return unit


def spellings() -> list[str]:
    """List every spelling without a prefix, symbols first."""
    return [*SYMBOLS, *NAMES]


def _unknown(spelling: str) -> UnitError:
    """Say that a spelling is unknown or refused, with the nearest names."""
    shown = quote(spelling)
    name = spelling.lower().replace("-", "_")
    if name in REFUSED:
        return UnitError(f"'{shown}' is not accepted as a unit", REFUSED[name])
    from radcalc.units import scales

    if error := scales.refuse(spelling):
        return error
    folded = spelling.lower()
    same = [s for s in (*_prefixed(), *scales.spellings()) if s.lower() == folded]
    if same:
        return UnitError(f"unknown unit '{shown}'", ", ".join(same[:3]))
    for prefixes, text in ((PREFIX_SYMBOLS, spelling), (PREFIX_NAMES, name)):
        for prefix in prefixes:
            rest = text[len(prefix) :]
            if text.startswith(prefix) and (rest in SYMBOLS or rest.lower() in NAMES):
                return UnitError(
                    f"unknown unit '{shown}': the prefix {prefix} does not go before {quote(rest)}",
                    _respelt(PREFIX_SYMBOLS.get(prefix, prefix), rest),
                )
    near = suggest(spelling)
    if not near and not spelling.isascii():
        from radcalc.units import languages

        near = languages.near(spelling)
    return UnitError(
        f"unknown unit '{shown}'",
        ", ".join(near) if near else f"{command('units')}, which lists them all",
    )


def _respelt(prefix: str, rest: str) -> str:
    """The unit with its prefix in full, where it takes it, else without."""
    name = NAMES.get(rest.lower(), "")
    if name and prefix in UNITS[name][3]:
        return prefix + rest.lower()
    return f"{rest}, with the power of ten in the number"


def suggest(spelling: str, count: int = 3) -> list[str]:
    """The known spellings nearest to one that is not."""
    spelling = spelling[:60]
    folded = spelling.lower()
    near = nearest(folded, NAMES, count, 0.7)
    if len(spelling) <= 4:
        near = nearest(spelling, _prefixed(), count) + near
    return list(dict.fromkeys(near))[:count]


def unit_behind(unit: str) -> str:
    """A unit as it stands behind a number, with a blank: none is behind a plain number."""
    return "" if unit == "1" else f" {unit}"


def _prefixed() -> list[str]:
    """The symbols, and those with a common prefix."""
    found = list(SYMBOLS)
    for symbol in SYMBOLS:
        found += [prefix + symbol for prefix in COMMON_PREFIXES if _takes(prefix, symbol)]
    return found
