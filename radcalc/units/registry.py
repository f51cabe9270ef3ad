"""The units of `light.txt` in Pint: the registry of the Python API, and the compiled tables.

The units of the weights of spectra are made from the rows of `weights.tsv`.

`python -m radcalc.units.registry` writes `compiled.py`, which every conversion loads, and
`catalogue.py`, which only `radcalc units` loads.  Only this module imports Pint.
"""

import re
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import pint
from pint.util import UnitsContainer

from radcalc.errors import UnitError, quote
from radcalc.floats import divide
from radcalc.units import BASES, MASS_AT, OWN, WEIGHT_AT, WEIGHT_BASE, Dimension, Unit, table
from radcalc.units.compiled import UNITS, WEIGHTS
from radcalc.units.dimensions import SUFFIXES, UNITS_OF_BASES, weights_of
from radcalc.units.languages import Definition, definition
from radcalc.units.reading import read_amount
from radcalc.units.uncertain import variable
from radcalc.units.values import BASE_UNITS

HERE = Path(__file__).parent
DEFINITIONS = HERE / "light.txt"
PREFIXES = {"W": "all", "J": "all", "lm": "k M m u", "lx": "k m u", "cd": "k m u", "mol": "m u n"}


class Weight(NamedTuple):
    """A row of `weights.tsv`."""

    name: str
    suffix: str
    word: str
    base: str
    adjective: str
    table: str
    low: str
    high: str
    units: str
    source: str

    def definitions(self) -> list[str]:
        """Return the definitions of its units, with their marks; the first is of its base unit."""
        lines = [f"{self.base_unit} = [{self.base_unit}]"]
        for symbol, name in UNITS_OF_BASES[self.base]:
            lines += [f"#: {self.source}", f"#~ {PREFIXES.get(symbol, '')}"]
            lines.append(f"{self.word}_{name} = {name} * {self.base_unit} = {symbol}_{self.suffix}")
        for text in filter(None, self.units.split("; ")):
            definition, _, rest = text.partition(" : ")
            definition, _, prefixes = definition.partition(" ~ ")
            lines += [f"#: {rest or self.source}", f"#~ {prefixes}", definition]
        return lines

    @property
    def short(self) -> tuple[str, str, str, str]:
        """The parts of the compiled table."""
        return self.name, self.base, self.adjective, self.word

    @property
    def base_unit(self) -> str:
        """The unit of its base in Pint, which no text has."""
        return f"weight_{self.suffix}"

    def names(self) -> dict[str, str]:
        """Return the quantities of its further units that have a name of their own."""
        texts = (text.partition(" : ")[::2] for text in self.units.split("; "))
        return {unit.split(" = ")[0]: name for unit, name in texts if name}


@cache
def read_weights() -> list[Weight]:
    """Return the rows of `weights.tsv`."""
    text = (HERE / "weights.tsv").read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if line[0] != "#"]
    return [Weight(*line.split("\t")) for line in lines[1:]]


def definitions() -> str:
    """Return the definitions of `light.txt`, and those of the units of weights."""
    lines = [line for weight in read_weights() for line in weight.definitions()]
    return "\n".join([DEFINITIONS.read_text(encoding="utf-8"), *lines])


if TYPE_CHECKING:
    Registry = pint.UnitRegistry[Any]
else:
    Registry = pint.UnitRegistry  # generic in some versions of Pint only


DimensionalityError = pint.DimensionalityError


class Dimensionality(DimensionalityError):
    """Pint's error for a unit of another quantity, with a message of radcalc."""

    __eq__, __hash__ = Exception.__eq__, Exception.__hash__

    def __init__(self, message: str) -> None:
        Exception.__init__(self, message)


class LightRegistry(Registry):
    """A Pint registry of units of light that reads texts as `radcalc convert` does."""

    closed = False  # True once its own definitions are read

    def container(self, unit: Unit) -> UnitsContainer:
        powers: dict[str, int] = {}
        for suffix in SUFFIXES[len(read_weights()) :]:  # of weights of files
            self._define_weight(suffix)
        for name in OWN:
            if name in UNITS and name not in self._units:
                self._define_own(*UNITS[name][:3], name)
        for name, exponent in unit.atoms:
            self.get_name(name)  # defines a prefixed unit in Pint
            powers[name] = powers.get(name, 0) + exponent
        return UnitsContainer({name: power for name, power in powers.items() if power})

    def _define_weight(self, suffix: str) -> None:
        """Define the base unit of a weight of a file, and its units."""
        if f"weight_{suffix}" in self._units:
            return
        self.closed = False
        try:
            self.define(f"weight_{suffix} = [weight_{suffix}]")
            for symbol, name in UNITS_OF_BASES[WEIGHTS[suffix][1]]:
                self.define(f"{suffix}_{name} = {name} * weight_{suffix} = {symbol}_{suffix}")
        finally:
            self.closed = True

    def _define_own(self, top: int, bottom: int, dimension: Dimension, name: str) -> None:
        """Define a unit of the user's definitions in Pint."""
        base = [
            *zip(BASE_UNITS, dimension, strict=False),
            *[(f"weight_{SUFFIXES[k]}", power) for k, power in weights_of(dimension).items()],
        ]
        self.closed = False
        try:
            product = " * ".join([f"{unit}**{power}" for unit, power in base if power])
            self.define(f"{name} = {divide(top, bottom)!r} * {product or 1}")
        finally:
            self.closed = True

    def parse_units_as_container(self, input_string: str, *args: Any, **kwargs: Any) -> Any:
        if not self.closed:
            return super().parse_units_as_container(input_string, *args, **kwargs)
        if not input_string:  # NumPy's functions ask Pint for the unit of a bare number
            return self.UnitsContainer()
        return self.container(table.resolve(input_string))

    def parse_expression(self, input_string: str, *args: Any, **kwargs: Any) -> Any:
        """Read a number and a unit; an uncertain number becomes a variable."""
        if not self.closed:
            return super().parse_expression(input_string, *args, **kwargs)
        amount = read_amount(input_string)
        if amount.scale and amount.scale.others:
            read = " or ".join(scale.unit.text for scale in (amount.scale, *amount.scale.others))
            raise UnitError(f"'{quote(amount.text)}' is ambiguous: {read}", "one of them")
        value: Any = amount.number
        if amount.uncertainty:
            value = variable(value, amount.uncertainty, amount.text)
        return self.Quantity(value, self.container(amount.unit or table.resolve("1")))


def from_container(units: Any) -> Unit:
    """Convert Pint's units to a unit of the table."""
    if any(power != int(power) for _, power in units.items()):
        raise UnitError(f"'{units}' has an exponent that is not a whole number", "whole powers")
    symbol = light_registry().get_symbol
    text = " ".join(
        symbol(name) if power == 1 else f"{symbol(name)}^{int(power)}"
        for name, power in units.items()
    )
    return table.resolve(text or "1")


@cache
def light_registry() -> LightRegistry:
    """Return the registry of the Python API, built once."""
    registry = LightRegistry(
        definitions().splitlines(), cache_folder=None, autoconvert_offset_to_baseunit=False
    )
    registry.closed = True
    return registry


def exact_registry() -> Registry:
    """Build a registry with exact fractions as factors; a name defined twice is an error."""
    return Registry(
        definitions().splitlines(),
        non_int_type=Fraction,
        cache_folder=None,
        on_redefinition="raise",
    )


PLACES = {f"[{name}]": place for place, name in enumerate(BASES)}


class Definitions(NamedTuple):
    """All definitions of `light.txt`; `letters` of a constant are its short spellings."""

    units: list[Definition]
    constants: list[Definition]
    prefix_names: dict[str, int]
    prefix_symbols: dict[str, str]
    refused: dict[str, str]


def read(text: str) -> Definitions:
    """Read the definitions and their marks."""
    definitions = Definitions([], [], {}, {}, {})
    marks: dict[str, list[str]] = {}
    for line in text.splitlines():
        if line[:2] in ("#:", "#!", "#~", "#$"):
            marks.setdefault(line[1], []).append(line[2:].strip())
        elif line[:2] == "#?":
            names, _, reason = line[2:].partition(" : ")
            definitions.refused.update(
                dict.fromkeys(re.split(r"[,\s]+", names.strip()), reason.strip())
            )
        elif "=" in line and not line.startswith("#"):
            name, value, *aliases = (part.strip() for part in line.split("="))
            if name.endswith("-"):
                name = name[:-1]
                definitions.prefix_names[name] = _power_of_ten(Fraction(value))
                definitions.prefix_symbols.update({a.rstrip("-"): name for a in aliases})
            elif name != "pi" and not name.startswith("weight_"):
                kind = definitions.constants if "$" in marks else definitions.units
                kind.append(definition(name, value, aliases, marks, definitions.prefix_symbols))
            marks = {}
    return definitions


def _power_of_ten(value: Fraction) -> int:
    power = len(str(max(value.numerator, value.denominator))) - 1
    return power if value > 1 else -power


def every_spelling(definitions: Definitions) -> dict[str, list[tuple[str, str]]]:
    """List every accepted spelling, full names in lower case, with all its readings."""
    readings: dict[str, list[tuple[str, str]]] = {}
    for unit in definitions.units:
        for symbol in unit.symbols:
            readings.setdefault(symbol, []).append(("", unit.name))
            for prefix, name in definitions.prefix_symbols.items():
                if name in unit.prefixes and prefix.isascii() == symbol.isascii():
                    readings.setdefault(prefix + symbol, []).append((name, unit.name))
        for full in unit.names:
            for prefix in ("", *unit.prefixes):
                readings.setdefault(prefix + full, []).append((prefix, unit.name))
    return readings


def refuse_collisions(definitions: Definitions) -> None:
    """Raise ValueError for a spelling with two readings, or one that is also refused."""
    every = every_spelling(definitions)
    for constant in definitions.constants:
        for spelling in (*constant.symbols, *constant.names):
            every.setdefault(spelling, []).append(("", constant.name))
    for spelling, readings in every.items():
        if len(readings) > 1:
            raise ValueError(f"{spelling!r} has more than one reading: {readings}")
        if spelling in definitions.refused:
            raise ValueError(f"{spelling!r} is both a unit and refused")
    letters = [letter for constant in definitions.constants for letter in constant.letters]
    if len(set(letters)) < len(letters):
        raise ValueError(f"a short spelling of two constants: {letters}")


def exponent_of(base: str) -> int:
    """Return the exponent of `weight` that is 1 for the base unit of a weight in Pint."""
    places = {f"[{row.base_unit}]": place for place, row in enumerate(read_weights())}
    exponent: int = WEIGHT_BASE ** places[base]
    return exponent


def worth(registry: Any, name: str) -> tuple[int, int, tuple[int, ...]]:
    """Return Pint's exact factor of a unit to coherent SI units, and its dimension."""
    container = UnitsContainer({name: 1})
    factor, _ = registry.get_root_units(container)
    powers = [0] * len(PLACES)
    for base, power in registry.get_dimensionality(container).items():
        if base in PLACES:
            powers[PLACES[base]] = int(power)
        else:
            powers[WEIGHT_AT] += int(power) * exponent_of(base)
    factor = Fraction(factor) / Fraction(1000) ** powers[MASS_AT]  # Pint's base is the gram
    return factor.numerator, factor.denominator, tuple(powers)


def compile_units(text: str) -> tuple[str, str]:
    """Return the texts of `compiled.py` and `catalogue.py`."""
    definitions = read(text)
    refuse_collisions(definitions)
    registry = exact_registry()
    source = "`python -m radcalc.units.registry` from light.txt and weights.tsv"
    head = f'"""Generated by {source}; do not edit."""\n\n'
    prefixes = tuple(definitions.prefix_names)
    units = "".join(
        f"    {u.name!r}: ({top}, {bottom}, {powers}, {allowed}),\n"
        for u in definitions.units
        for top, bottom, powers in [worth(registry, u.name)]
        for allowed in ["ALL" if u.prefixes == prefixes else u.prefixes]
    )
    rows = read_weights()
    table = (
        f"{head}ALL = {prefixes}\n"
        f"UNITS = {{\n{units}}}\n"
        f"SYMBOLS = {_lines({s: u.name for u in definitions.units for s in u.symbols})}\n"
        f"NAMES = {_lines({n: u.name for u in definitions.units for n in u.names})}\n"
        f"NOTES = {_lines({u.name: u.note for u in definitions.units if u.note})}\n"
        f"CONSTANTS = {_lines({c.name: worth(registry, c.name) for c in definitions.constants})}\n"
        f"SPELLINGS_OF_CONSTANTS = {_lines(_constants(definitions))}\n"
        f"# suffix: (name, base, adjective, word), in the order of the places\n"
        f"WEIGHTS = {_lines({row.suffix: row.short for row in rows})}\n"
        f"QUANTITIES = {_lines({k: v for row in rows for k, v in row.names().items()})}\n"
        f"REFUSED = {_lines(definitions.refused)}\n"
        f"PREFIX_NAMES = {_lines(definitions.prefix_names)}\n"
        f"PREFIX_SYMBOLS = {_lines(definitions.prefix_symbols)}\n"
    )
    entries, constants = (
        _lines({d.name: (d.letters + d.symbols, d.names, d.value, d.source) for d in listed})
        for listed in (definitions.units, definitions.constants)
    )
    catalogue = (
        f"{head}# name: (symbols, full names, definition, source)\nCATALOGUE = {entries}\n"
        f"CONSTANTS = {constants}\n"
    )
    return table, catalogue


def _constants(definitions: Definitions) -> dict[str, str]:
    """Return the names of the constants by spelling; the first of each is unambiguous."""
    return {
        spelling: constant.name
        for constant in definitions.constants
        for spelling in (*constant.symbols, constant.name, *constant.names, *constant.letters)
    }


def _lines(mapping: dict[str, Any]) -> str:
    return "{\n" + "".join(f"    {k!r}: {v!r},\n" for k, v in mapping.items()) + "}"


def main() -> None:
    """Write both tables into the folder of this module."""
    table, catalogue = compile_units(definitions())
    (HERE / "compiled.py").write_text(table, encoding="utf-8")
    (HERE / "catalogue.py").write_text(catalogue, encoding="utf-8")


if __name__ == "__main__":
    main()
