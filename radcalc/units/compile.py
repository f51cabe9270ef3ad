"""Compile the units of `light.txt`, with their values from Pint, into the tables of units.

`python -m radcalc.units.compile` writes `compiled.py`, which every conversion loads, and
`catalogue.py`, which only `radcalc units` loads.
"""

import re
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

from pint.errors import UndefinedUnitError
from pint.util import UnitsContainer

from radcalc.errors import ConditionError, quote
from radcalc.units import horticulture, scale_table
from radcalc.units.numbers import FUNCTIONS, OTHER_FUNCTIONS
from radcalc.units.registry import DEFINITIONS, exact_registry
from radcalc.units.unit import BASES, MASS_AT, lookup
from radcalc.units.words import find

NAME = re.compile(r"[^\W\d_]+(?:_\w*)?")
HERE = Path(__file__).parent
BASE_UNITS = {f"[{name}]": place for place, name in enumerate(BASES)}


class Definition(NamedTuple):
    """One unit of `light.txt`."""

    name: str
    value: str
    symbols: tuple[str, ...]
    names: tuple[str, ...]
    prefixes: tuple[str, ...]
    note: str
    source: str
    letters: tuple[str, ...]


class Definitions(NamedTuple):
    """All definitions of `light.txt`; `letters` of a constant are its short spellings."""

    units: list[Definition]
    constants: list[Definition]
    prefix_names: dict[str, int]
    prefix_symbols: dict[str, str]
    refused: dict[str, str]


def is_name(word: str) -> bool:
    """Return whether an alias is a full name (any case, a plural) rather than a symbol."""
    return re.fullmatch(r"[a-z][a-z_0-9]{3,}", word) is not None


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
            elif name != "pi":
                kind = definitions.constants if "$" in marks else definitions.units
                kind.append(_definition(name, value, aliases, marks, definitions.prefix_symbols))
            marks = {}
    return definitions


def _power_of_ten(value: Fraction) -> int:
    power = len(str(max(value.numerator, value.denominator))) - 1
    return power if value > 1 else -power


def _definition(
    name: str,
    value: str,
    aliases: list[str],
    marks: dict[str, list[str]],
    prefix_symbols: dict[str, str],
) -> Definition:
    """Return the definition of a unit from the fields of its row, with its plurals."""
    symbol, rest = (aliases[0], aliases[1:]) if aliases else ("_", [])
    symbols = [a for a in [symbol, *rest] if a != "_" and not (a in rest and is_name(a))]
    names = [name, *(a for a in rest if is_name(a))]
    countable = [] if "$" in marks else names
    plurals = [n + "s" for n in countable if n[-1].isalpha() and not n.endswith(("s", "x", "ch"))]
    allowed = " ".join(marks.get("~", [])).split()
    if allowed == ["all"]:
        prefixes = dict.fromkeys(prefix_symbols.values())
    else:
        prefixes = dict.fromkeys(prefix_symbols[p] for p in allowed)
    return Definition(
        name,
        value,
        tuple(symbols),
        tuple(dict.fromkeys(names + plurals)),
        tuple(prefixes),
        " ".join(marks.get("!", [])),
        " ".join(marks.get(":", [])),
        tuple(" ".join(marks.get("$", [])).split()),
    )


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


def worth(registry: Any, name: str) -> tuple[int, int, tuple[int, ...]]:
    """Return Pint's exact factor of a unit to coherent SI units, and its dimension."""
    container = UnitsContainer({name: 1})
    factor, _ = registry.get_root_units(container)
    powers = [0] * len(BASE_UNITS)
    for base, power in registry.get_dimensionality(container).items():
        powers[BASE_UNITS[base]] = int(power)
    factor = Fraction(factor) / Fraction(1000) ** powers[MASS_AT]  # Pint's base is the gram
    return factor.numerator, factor.denominator, tuple(powers)


def compile_units(text: str) -> tuple[str, str]:
    """Return the texts of `compiled.py` and `catalogue.py`."""
    definitions = read(text)
    refuse_collisions(definitions)
    registry = exact_registry()
    head = '"""Generated by `python -m radcalc.units.compile` from light.txt; do not edit."""\n\n'
    prefixes = tuple(definitions.prefix_names)
    units = "".join(
        f"    {u.name!r}: ({top}, {bottom}, {powers}, {allowed}),\n"
        for u in definitions.units
        for top, bottom, powers in [worth(registry, u.name)]
        for allowed in ["ALL" if u.prefixes == prefixes else u.prefixes]
    )
    table = (
        f"{head}ALL = {prefixes}\n"
        f"UNITS = {{\n{units}}}\n"
        f"SYMBOLS = {_lines({s: u.name for u in definitions.units for s in u.symbols})}\n"
        f"NAMES = {_lines({n: u.name for u in definitions.units for n in u.names})}\n"
        f"NOTES = {_lines({u.name: u.note for u in definitions.units if u.note})}\n"
        f"CONSTANTS = {_lines({c.name: worth(registry, c.name) for c in definitions.constants})}\n"
        f"SPELLINGS_OF_CONSTANTS = {_lines(_constants(definitions))}\n"
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


KINDS = ("constant", "reflectance", "spectrum")  # the first words of definitions of one's own
RESERVED = ("pi", "per", "in", "to", "as", "into", "x", *FUNCTIONS, *OTHER_FUNCTIONS)
# Powers that would take long, or a power of a power.
LARGE = re.compile(r"[eE][-+]?\d{4}|(\*\*|\^)\s*([-+]?\d{3}|[-+]?\w*\s*(\*\*|\^)|\()")
SYNTAX = "NAME = VALUE, with constant, reflectance or spectrum before it for these"


def compile_own(text: str, file: str) -> list[dict[str, Any]]:
    """Return the definitions of a user's file as rows of the tables.

    Raises ConditionError, with the file, the line and the column, for a definition that is
    malformed, or whose name is taken.
    """
    registry = exact_registry()
    rows: list[dict[str, Any]] = []
    marks: dict[str, list[str]] = {}
    taken: dict[str, int] = {}
    builtin = read(DEFINITIONS.read_text(encoding="utf-8"))
    for number, line in enumerate(text.splitlines(), 1):
        if line[:2] in ("#:", "#!", "#~"):
            marks.setdefault(line[1], []).append(line[2:].strip())
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        own = _Own(f"{file}, line {number}", line, builtin)
        row = own.row(marks)
        for spelling in own.spellings(row):
            own.refuse_taken(spelling, row["kind"], taken.get(spelling, 0))
            taken[spelling] = number
        if row["kind"] != "spectrum":
            row |= own.worth(registry, row["name"], row["value"])
        rows.append({**row, "line": number})
        marks = {}
    return rows


class _Own:
    """A line of a user's definitions."""

    def __init__(self, place: str, line: str, builtin: Definitions) -> None:
        self.place, self.line, self.builtin = place, line, builtin
        head, *_ = line.split(None, 1)
        self.kind = head if head in KINDS and line.split("=")[0].strip() != head else "unit"
        body = line.strip().removeprefix(self.kind) if self.kind != "unit" else line
        self.parts = [part.strip() for part in body.split("=")]

    def error(self, problem: str, at: str = "", hint: str = SYNTAX) -> ConditionError:
        start = self.line.find(self.kind) + len(self.kind) if self.kind in KINDS else 0
        word = re.compile(rf"(?<!\w){re.escape(at)}(?!\w)").search(self.line, start)
        column = (word.start() if word else max(self.line.find(at), 0)) + 1
        return ConditionError(f"{self.place}, column {column}: {problem}", hint)

    def row(self, marks: dict[str, list[str]]) -> dict[str, Any]:
        """Return the row of the line, without its value in SI units."""
        if len(self.parts) < 2 or not all(self.parts):
            raise self.error("not a definition", self.line.strip())
        name, value, *aliases = self.parts
        if self.kind == "spectrum":
            if aliases:
                raise self.error("a spectrum has one name", aliases[0])
            return {"kind": "spectrum", "name": name, "value": value}
        for word in (name, *aliases):
            if word != "_" and not NAME.fullmatch(word):
                hint = "letters, and digits only after an underscore"
                raise self.error(f"'{quote(word)}' is not a name", word, hint)
        if unknown := {*" ".join(marks.get("~", [])).split()} - {
            "all",
            *self.builtin.prefix_symbols,
        }:
            raise self.error(f"unknown prefix '{quote(min(unknown))}'", "", "#~ all, or #~ k M m u")
        unit = _definition(name, value, aliases, marks, self.builtin.prefix_symbols)
        return {
            "kind": "unit" if self.kind == "unit" else "constant",
            "name": name,
            "symbols": unit.symbols,
            "names": unit.names,
            "prefixes": unit.prefixes,
            "value": value,
        }

    def spellings(self, row: dict[str, Any]) -> list[str]:
        """Return every spelling of a definition, with prefixes."""
        if row["kind"] == "spectrum":
            return [row["name"]]
        names = dict.fromkeys((row["name"], *row["symbols"], *row["names"]))
        symbols = {name: symbol for symbol, name in self.builtin.prefix_symbols.items()}
        prefixed = [symbols[p] + s for p in row["prefixes"] for s in row["symbols"]]
        return [*names, *prefixed, *(p + n for p in row["prefixes"] for n in row["names"])]

    def refuse_taken(self, spelling: str, kind: str, line: int) -> None:
        """Raise for a spelling of another line, of a unit, a constant or a scale, or a refused one.

        `line` is the other line, or 0.
        """
        if line:
            problem = f"'{quote(spelling)}' is defined in line {line}, too"
            raise self.error(problem, spelling, "another name")
        if kind == "spectrum":
            return
        entry = lookup(spelling)
        owner = "".join(entry) if entry else find(spelling)
        owner = owner or "".join(row.name for row in scale_table.named(spelling)[:1])
        if owner:
            raise self.error(f"'{quote(spelling)}' is {owner} already", spelling, "another name")
        is_refused = spelling.lower() in self.builtin.refused
        if is_refused or spelling.lower() in RESERVED or spelling in horticulture.WORDS:
            raise self.error(f"'{quote(spelling)}' is a word of radcalc", spelling, "another name")

    def worth(self, registry: Any, name: str, value: str) -> dict[str, Any]:
        """Return the exact value and the dimension by Pint; raise for a value without them."""
        if LARGE.search(value):
            raise self.error(f"'{quote(value)}' has a large power", value, "powers of two digits")
        try:
            registry.define(f"{name} = {value.replace('%', ' percent')}")
            top, bottom, powers = worth(registry, name)
        except UndefinedUnitError as error:
            names = error.unit_names
            unknown = names if isinstance(names, str) else min(names)
            raise self.error(f"unknown unit '{quote(unknown)}'", unknown) from None
        except Exception as error:  # Pint's parser raises errors of many kinds
            problem = f"'{quote(value)}' is not a value ({type(error).__name__})"
            raise self.error(problem, value, "a value such as 54 lm/W") from None
        if top <= 0:
            raise self.error(f"'{quote(value)}' is not above 0", value, "a value above 0")
        if self.kind == "reflectance" and (any(powers) or top > bottom):
            raise self.error(f"'{quote(value)}' is not a reflectance", value, "from 0 to 1")
        return {"top": top, "bottom": bottom, "powers": powers}


def _lines(mapping: dict[str, Any]) -> str:
    return "{\n" + "".join(f"    {k!r}: {v!r},\n" for k, v in mapping.items()) + "}"


def main() -> None:
    """Write both tables into the folder of this module."""
    table, catalogue = compile_units(DEFINITIONS.read_text(encoding="utf-8"))
    (HERE / "compiled.py").write_text(table, encoding="utf-8")
    (HERE / "catalogue.py").write_text(catalogue, encoding="utf-8")


if __name__ == "__main__":
    main()
