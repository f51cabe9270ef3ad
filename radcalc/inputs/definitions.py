"""Units, constants, reflectances and spectra of one's own, from a file of definitions.

    NAME = VALUE = SYMBOL = ALIAS ...     a unit, as in `units/light.txt`
    constant NAME = VALUE                 a quantity of expressions and inputs: efficacy NAME
    reflectance NAME = VALUE              a constant from 0 to 1
    spectrum NAME = SPECTRUM              a named spectrum, a kind with parameters, or a file

Values are read as everywhere else, in order: a definition may use those above it.
"""

import os
import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from radcalc.errors import ConditionError, Hint, RadcalcError, quote, quote_path
from radcalc.files import readable
from radcalc.units import OWN, compiled, lookup, scale_table, table
from radcalc.units.languages import definition
from radcalc.units.numbers import FUNCTIONS, OTHER_FUNCTIONS, find_constant
from radcalc.units.ranges import refuse_list
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve

MOST_BYTES = 1 << 18  # of a file of definitions
EXPECTED = "a text file of definitions such as: mylamp = 54 lm/W"
EXAMPLE = "a value such as 54 lm/W"
KINDS = ("constant", "reflectance", "spectrum")  # the first words of definitions of one's own
RESERVED = ("pi", "per", "in", "to", "as", "into", "x", *FUNCTIONS, *OTHER_FUNCTIONS)
NAME = re.compile(r"[^\W\d_]+(?:_\w*)?")
SYNTAX = "NAME = VALUE, with constant, reflectance or spectrum before it for these"

Row = dict[str, Any]
_loaded: list[str] = []  # paths of the files that are merged


def load(path: str) -> None:
    """Add the definitions of a file to the tables of units, constants and spectra.

    Raises RadcalcError, with the line and the column, for a definition that is not possible.
    """
    if path in _loaded:
        return
    with readable(path, EXPECTED) as name, open(path, "rb") as file:
        content = file.read(MOST_BYTES + 1)
    if len(content) > MOST_BYTES:
        raise ConditionError(f"{name} is longer than {MOST_BYTES} bytes", EXPECTED)
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise ConditionError(f"{name}, line {line}: not UTF-8", EXPECTED) from None
    for row in _rows(text, name):
        _merge(row, os.path.basename(path), os.path.dirname(os.path.abspath(path)))
    _loaded.append(path)


def _rows(text: str, file: str) -> Iterator[Row]:
    """Yield the rows of the tables; each is merged before the next is read, which may use it.

    Raises ConditionError, with the file, the line and the column, for a definition that is
    malformed, or whose name is taken.
    """
    marks: dict[str, list[str]] = {}
    taken: dict[str, int] = {}
    for number, line in enumerate(text.splitlines(), 1):
        if line[:2] in ("#:", "#!", "#~"):
            marks.setdefault(line[1], []).append(line[2:].strip())
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        own = _Line(f"{file}, line {number}", line)
        row = own.row(marks)
        for spelling in own.spellings(row):
            own.refuse_taken(spelling, taken.get(spelling, 0))
            taken[spelling] = number
        if own.kind != "spectrum":
            row |= own.worth(row["value"])
        yield {**row, "line": number}
        marks = {}


class _Line:
    """A line of a user's definitions."""

    def __init__(self, place: str, line: str) -> None:
        self.place, self.line = place, line
        head, *_ = line.split(None, 1)
        self.kind = head if head in KINDS and line.split("=")[0].strip() != head else "unit"
        body = line.strip().removeprefix(self.kind) if self.kind != "unit" else line
        self.parts = [part.strip() for part in body.split("=")]

    def error(self, problem: str, at: str = "", hint: Hint = SYNTAX) -> ConditionError:
        start = self.line.find(self.kind) + len(self.kind) if self.kind in KINDS else 0
        word = re.compile(rf"(?<!\w){re.escape(at)}(?!\w)").search(self.line, start)
        column = (word.start() if word else max(self.line.find(at), 0)) + 1
        return ConditionError(f"{self.place}, column {column}: {problem}", hint)

    def row(self, marks: dict[str, list[str]]) -> Row:
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
        known = {"all", *compiled.PREFIX_SYMBOLS}
        if unknown := {*" ".join(marks.get("~", [])).split()} - known:
            raise self.error(f"unknown prefix '{quote(min(unknown))}'", "", "#~ all, or #~ k M m u")
        unit = definition(name, value, aliases, marks, compiled.PREFIX_SYMBOLS)
        return {
            "kind": "unit" if self.kind == "unit" else "constant",
            "name": name,
            "symbols": unit.symbols,
            "names": unit.names,
            "prefixes": unit.prefixes,
            "value": value,
        }

    def spellings(self, row: Row) -> list[str]:
        """Return every spelling of a definition, with prefixes."""
        if self.kind == "spectrum":
            return [row["name"]]
        names = dict.fromkeys((row["name"], *row["symbols"], *row["names"]))
        symbols = {name: symbol for symbol, name in compiled.PREFIX_SYMBOLS.items()}
        prefixed = [symbols[p] + s for p in row["prefixes"] for s in row["symbols"]]
        return [*names, *prefixed, *(p + n for p in row["prefixes"] for n in row["names"])]

    def refuse_taken(self, spelling: str, line: int) -> None:
        """Raise for a spelling of another line, of a unit, a constant or a scale, or a refused one.

        `line` is the other line, or 0.
        """
        if line:
            problem = f"'{quote(spelling)}' is defined in line {line}, too"
            raise self.error(problem, spelling, "another name")
        if self.kind == "spectrum":
            return
        entry = lookup(spelling)
        owner = "".join(entry) if entry else find_constant(spelling)
        owner = owner or "".join(row.name for row in scale_table.named(spelling)[:1])
        if owner:
            raise self.error(f"'{quote(spelling)}' is {owner} already", spelling, "another name")
        is_refused = spelling.lower() in compiled.REFUSED
        if is_refused or spelling.lower() in RESERVED or spelling in table.GROWERS_WORDS:
            raise self.error(f"'{quote(spelling)}' is a word of radcalc", spelling, "another name")

    def worth(self, value: str) -> Row:
        """Return the exact value and the dimension; raise for a value that is not one above 0."""
        try:
            refuse_list(value)
            amount = read_amount(value)
            if amount.uncertainty:
                raise ConditionError(f"'{quote(value)}' has an uncertainty", EXAMPLE)
        except RadcalcError as error:
            unknown = re.search(r"unknown unit '(.*?)'", error.message)
            at = unknown[1] if unknown else value
            raise self.error(error.message, at, error.hint or EXAMPLE) from None
        unit = amount.unit or resolve("1")
        number = Fraction(*amount.ratio) if amount.ratio else Fraction(repr(amount.number))
        size = number * Fraction(unit.top, unit.bottom)
        if size <= 0:
            raise self.error(f"'{quote(value)}' is not above 0", value, "a value above 0")
        if self.kind == "reflectance" and (any(unit.dimension) or size > 1):
            raise self.error(f"'{quote(value)}' is not a reflectance", value, "from 0 to 1")
        worth = {"top": size.numerator, "bottom": size.denominator, "powers": unit.dimension}
        return {**worth, "notes": unit.notes}


def _merge(row: Row, file: str, folder: str) -> None:
    """Add a row of the user's file to the tables of units, constants or spectra."""
    name, place = row["name"], f"{file} line {row['line']}"
    note = f"{OWN}: {name} = {quote(row['value'])}, {quote_path(place)}"
    if row["kind"] == "spectrum":
        _merge_spectrum(row, note, f"{file}, line {row['line']}", folder)
        return
    from radcalc.units import catalogue

    worth = (row["top"], row["bottom"], tuple(row["powers"]))
    source = f"{OWN}, {place}"
    compiled.NOTES[name] = "; ".join([note, *row["notes"]])
    if row["kind"] == "unit":
        compiled.UNITS[name] = (*worth, tuple(row["prefixes"]))
        compiled.SYMBOLS.update(dict.fromkeys(row["symbols"], name))
        compiled.NAMES.update(dict.fromkeys(row["names"], name))
        listed = tuple(row["symbols"]), tuple(row["names"]), row["value"], source
        catalogue.CATALOGUE[name] = listed
        return
    compiled.CONSTANTS[name] = worth
    spellings = (*row["symbols"], *row["names"])
    compiled.SPELLINGS_OF_CONSTANTS.update(dict.fromkeys((name, *spellings), name))
    catalogue.CONSTANTS[name] = ((name, *row["symbols"]), tuple(row["names"]), row["value"], source)


def _merge_spectrum(row: Row, note: str, place: str, folder: str) -> None:
    from radcalc.spectra import FORMS, sources

    name, target = row["name"], row["value"]
    taken = sources.find_named(name) is not None or name.lower() in FORMS
    if taken or lookup(name) or table.GROWERS_WORDS.get(name.lower()):
        raise ConditionError(f"{place}: '{quote(name)}' is a name of radcalc", "another name")
    path = os.path.join(folder, os.path.expanduser(target))
    if os.path.exists(path) and sources.find_named(target) is None:
        target = path
    sources.OWN[name] = target, note
