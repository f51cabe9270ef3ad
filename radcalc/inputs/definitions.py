"""Units, constants, reflectances, spectra and weights of one's own, from a file of definitions.

    NAME = VALUE = SYMBOL = ALIAS ...     a unit, as in `units/light.txt`
    constant NAME = VALUE                 a quantity of expressions and inputs: efficacy NAME
    reflectance NAME = VALUE              a constant from 0 to 1
    spectrum NAME = SPECTRUM              a named spectrum, a kind with parameters, or a file
    weight NAME = FILE                    a weight of spectra, with units of its own: W_NAME

Values are read as everywhere else, in order: a definition may use those above it.
"""

import os
import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from radcalc.errors import ConditionError, Hint, RadcalcError, listed, quote, quote_path
from radcalc.files import readable
from radcalc.maths import LARGEST
from radcalc.quantities import KIND_NAMES
from radcalc.spectra import FORMS, observers, sources
from radcalc.units import (
    OWN,
    REFLECTANCES,
    catalogue,
    compiled,
    lookup,
    names_since,
    now,
    scale_table,
    table,
)
from radcalc.units.dimensions import SUFFIXES
from radcalc.units.grammar import MAX_DEPTH
from radcalc.units.languages import definition
from radcalc.units.numbers import FUNCTIONS, OTHER_FUNCTIONS, find_constant
from radcalc.units.ranges import refuse_list
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve

MOST_BYTES = 1 << 18  # of a file of definitions
MOST_SPELLINGS = 20_000
MOST_BITS = 4000  # of the ratio of a definition, which others may raise to a power
EXPECTED = "a text file of definitions such as: mylamp = 54 lm/W"
EXAMPLE = "a value such as 54 lm/W"
SPECTRUM, REFLECTANCE, WEIGHT = "spectrum", "reflectance", "weight"
OF_SOURCES = (SPECTRUM, WEIGHT)  # whose values are no quantities
KINDS = ("constant", REFLECTANCE, *OF_SOURCES)  # the first words of definitions of one's own
RESERVED = ("pi", "per", "in", "to", "as", "into", "x", *FUNCTIONS, *OTHER_FUNCTIONS)
NAME = re.compile(r"[^\W\d_]+(?:_\w*)?")
OF_WEIGHT = re.compile(r"[a-z]+")
SYNTAX = "NAME = VALUE, with constant, reflectance, spectrum or weight before it for these"
BREAK = re.compile(r"\r\n|\r|\n")
TABLES: tuple[dict[str, Any], ...] = (
    OWN,
    *(compiled.UNITS, compiled.SYMBOLS, compiled.NAMES, compiled.NOTES, compiled.CONSTANTS),
    *(compiled.SPELLINGS_OF_CONSTANTS, catalogue.CATALOGUE, catalogue.CONSTANTS),
    *(REFLECTANCES, sources.OWN, compiled.WEIGHTS, KIND_NAMES, observers.OWN),
)

Row = dict[str, Any]
_loaded: dict[tuple[str, bytes], tuple[str, ...]] = {}  # files with their contents; their names


def load(path: str) -> tuple[str, ...]:
    """Add the definitions of a file to the tables of units, constants and spectra.

    Returns their names.  Raises RadcalcError, with the line and the column, for a definition that
    is not possible; the tables are then as before.
    """
    with readable(path, EXPECTED) as name:
        # The reader of a pipe without a writer waits for ever.
        if path != os.devnull and os.path.exists(path) and not os.path.isfile(path):
            raise ConditionError(f"cannot read {name}: not a regular file", EXPECTED)
        with open(path, "rb") as file:
            content = file.read(MOST_BYTES + 1)
    key = os.path.abspath(path), content
    if key in _loaded:
        return _loaded[key]
    if len(content) > MOST_BYTES:
        raise ConditionError(f"{name} is longer than {MOST_BYTES} bytes", EXPECTED)
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        *lines, last = BREAK.split(error.object[: error.start].decode())
        place = f"{name}, line {len(lines) + 1}, column {len(last) + 1}"
        raise ConditionError(f"{place}: not UTF-8", EXPECTED) from None
    before = [dict(table) for table in TABLES]
    try:
        _merge_all(text, name, path)
    except BaseException:
        for changed, kept in zip(TABLES, before, strict=True):
            changed.clear()
            changed.update(kept)
        SUFFIXES[:] = compiled.WEIGHTS
        raise
    _loaded[key] = tuple(name for name in OWN if name not in before[0])
    return _loaded[key]


def _merge_all(text: str, name: str, path: str) -> None:
    """Add the rows of a file to the tables; refuse spectra that are defined by themselves."""
    spectra: dict[str, _Line] = {}
    folder = os.path.dirname(os.path.abspath(path))
    for line, row in _rows(text, name):
        if line.kind == WEIGHT:
            line.add_weight(row, folder)
        _merge(row, f"{os.path.basename(path)} line {line.number}")
        if line.kind == SPECTRUM:
            spectra[row["name"]] = line
        elif line.kind == REFLECTANCE:
            REFLECTANCES[row["name"]] = None
    for own, line in spectra.items():
        sources.OWN[own] = line.target(sources.OWN[own], folder)
    for own, line in spectra.items():
        chain = [own]
        while (target := sources.OWN[chain[-1]]) in spectra and target not in chain:
            chain.append(target)
            if len(chain) > MAX_DEPTH:
                raise line.error(f"'{quote(own)}' is defined by too many others", own, "its source")
        if target == own:
            numbers = listed(sorted({str(spectra[name].number) for name in chain}, key=int))
            others = f" (lines {numbers})" if len(chain) > 1 else ""
            raise line.error(f"'{quote(own)}' is defined by itself{others}", own, "another source")


def _rows(text: str, file: str) -> "Iterator[tuple[_Line, Row]]":
    """Yield the lines with their rows; each is merged before the next is read, which may use it.

    Raises ConditionError, with the file, the line and the column, for a definition that is
    malformed, or whose name is taken.
    """
    marks: dict[str, list[str]] = {}
    taken: dict[str, int] = {}
    for number, line in enumerate(BREAK.split(text), 1):
        if line[:2] in ("#:", "#!", "#~"):
            marks.setdefault(line[1], []).append(line[2:].strip())
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        own = _Line(file, number, line)
        row = own.row(marks)
        for spelling in own.spellings(row):
            own.refuse_taken(spelling, taken.get(spelling, 0))
            taken[spelling] = number
        if len(taken) > MOST_SPELLINGS:
            problem = f"more than {MOST_SPELLINGS} spellings, with prefixes and plurals"
            raise own.error(problem, "", "fewer definitions")
        yield own, row if own.kind in OF_SOURCES else row | own.worth(row["value"])
        marks = {}


class _Line:
    """A line of a user's definitions."""

    def __init__(self, file: str, number: int, line: str) -> None:
        self.file, self.number, self.line = file, number, line
        head, *_ = line.split(None, 1)
        self.kind = head if head in KINDS and line.split("=")[0].strip() != head else "unit"
        body = line.strip().removeprefix(self.kind) if self.kind != "unit" else line
        self.parts = [part.strip() for part in body.split("=")]

    def error(
        self, problem: str, at: str = "", hint: Hint = SYNTAX, of_value: bool = False
    ) -> ConditionError:
        """Return an error at a name, or at a word of the value."""
        start = self.line.find(self.kind) + len(self.kind) if self.kind in KINDS else 0
        if of_value:
            start = self.line.find("=") + 1
        word = re.compile(rf"(?<!\w){re.escape(at)}(?!\w)").search(self.line, start) if at else None
        column = (word.start() if word else max(self.line.find(at or self.line, start), 0)) + 1
        return ConditionError(f"{self.file}, line {self.number}, column {column}: {problem}", hint)

    def row(self, marks: dict[str, list[str]]) -> Row:
        """Return the row of the line, without its value in SI units."""
        if len(self.parts) < 2 or not all(self.parts):
            raise self.error("not a definition", self.line.strip())
        name, value, *aliases = self.parts
        if self.kind in OF_SOURCES:
            if aliases:
                raise self.error(f"a {self.kind} has one name", aliases[0])
            if self.kind == WEIGHT and not OF_WEIGHT.fullmatch(name):
                raise self.error(f"'{quote(name)}' is not the name of a weight", name, "a to z")
            return {"kind": self.kind, "name": name, "value": value}
        for word in (name, *(alias for alias in aliases if alias != "_")):
            if not NAME.fullmatch(word):
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
        if self.kind in OF_SOURCES:
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
        if self.kind in OF_SOURCES:
            self.refuse_known(spelling)
            return
        entry = lookup(spelling)
        owner = "".join(entry) if entry else find_constant(spelling)
        owner = owner or "".join(row.name for row in scale_table.named(spelling)[:1])
        if owner:
            raise self.error(f"'{quote(spelling)}' is {owner} already", spelling, "another name")
        is_refused = spelling.lower() in compiled.REFUSED
        if is_refused or spelling.lower() in RESERVED or spelling in table.GROWERS_WORDS:
            raise self.error(f"'{quote(spelling)}' is a word of radcalc", spelling, "another name")

    def refuse_known(self, name: str) -> None:
        """Raise for the name of a spectrum that is one of radcalc, or a unit."""
        is_known = name in OWN or sources.find_named(name) or name.lower() in FORMS
        if self.kind == WEIGHT:
            is_known = is_known or name in {*compiled.WEIGHTS, *observers.names()}
        if is_known or lookup(name) or name.lower() in table.GROWERS_WORDS:
            raise self.error(f"'{quote(name)}' is a name of radcalc", name, "another name")

    def target(self, source: str, folder: str) -> str:
        """Return the source of a spectrum: a name, a kind with parameters, or a path.

        A path is from the folder of the file.
        """
        kind, colon, _ = source.partition(":")
        if source in sources.OWN or sources.find_named(source) or (colon and kind.lower() in FORMS):
            return source
        path = os.path.join(folder, os.path.expanduser(source))
        if NAME.fullmatch(source.replace("-", "_")) and not os.path.exists(path):
            error = sources.unknown(source)
            raise self.error(error.message, source, error.hint, True)
        return path

    def add_weight(self, row: Row, folder: str) -> None:
        """Read the file of a weight, which is from the folder of the definitions."""
        path = os.path.join(folder, os.path.expanduser(row["value"]))
        if not os.path.isfile(path):
            problem = f"there is no file '{quote(row['value'])}'"
            raise self.error(problem, row["value"], "a file of a weight", True)
        try:
            sources.of_file(path, row["name"])
        except RadcalcError as error:
            raise self.error(error.message, row["value"], error.hint, True) from None

    def worth(self, value: str) -> Row:
        """Return the exact value and the dimension; raise for a value that is not one above 0."""
        time = now()
        try:
            refuse_list(value)
            amount = read_amount(value)
            if amount.uncertainty:
                raise ConditionError(f"'{quote(value)}' has an uncertainty", EXAMPLE)
        except RadcalcError as error:
            unknown = re.search(r"unknown unit '(.*?)'", error.message)
            at = unknown[1] if unknown else value
            raise self.error(error.message, at, error.hint or EXAMPLE, True) from None
        unit = amount.unit or resolve("1")
        number = Fraction(*amount.ratio) if amount.ratio else Fraction(repr(amount.number))
        size = number * Fraction(unit.top, unit.bottom)
        if size <= 0:
            raise self.error(f"'{quote(value)}' is not above 0", value, "a value above 0", True)
        if not 1 / LARGEST <= size <= LARGEST:
            hint = f"values from {1 / LARGEST:g} to {LARGEST:g} in SI units"
            raise self.error(f"'{quote(value)}' is out of range", value, hint, True)
        if size.numerator.bit_length() + size.denominator.bit_length() > MOST_BITS:
            raise self.error(f"'{quote(value)}' has too many digits", value, "fewer", True)
        if self.kind == REFLECTANCE and (any(unit.dimension) or size > 1):
            raise self.error(f"'{quote(value)}' is not a reflectance", value, "from 0 to 1", True)
        worth = {"top": size.numerator, "bottom": size.denominator, "powers": unit.dimension}
        return {**worth, "notes": (*amount.assumptions, *unit.notes), "uses": names_since(time)}


def _merge(row: Row, place: str) -> None:
    """Add a row of the user's file to the tables of units, constants or spectra."""
    name = row["name"]
    note = f"own definition: {name} = {quote(row['value'])}, {quote_path(place)}"
    OWN[name] = note, row.get("uses", ())
    if row["kind"] == SPECTRUM:
        sources.OWN[name] = row["value"]
    if row["kind"] in OF_SOURCES:
        return
    worth = (row["top"], row["bottom"], tuple(row["powers"]))
    source = f"own definition, {place}"
    if row["notes"]:
        compiled.NOTES[name] = "; ".join(row["notes"])
    if row["kind"] == "unit":
        compiled.UNITS[name] = (*worth, tuple(row["prefixes"]))
        compiled.SYMBOLS.update(dict.fromkeys(row["symbols"], name))
        compiled.NAMES.update(dict.fromkeys(row["names"], name))
        listed_ = tuple(row["symbols"]), tuple(row["names"]), row["value"], source
        catalogue.CATALOGUE[name] = listed_
        return
    compiled.CONSTANTS[name] = worth
    spellings = (*row["symbols"], *row["names"])
    compiled.SPELLINGS_OF_CONSTANTS.update(dict.fromkeys((name, *spellings), name))
    catalogue.CONSTANTS[name] = ((name, *row["symbols"]), tuple(row["names"]), row["value"], source)
