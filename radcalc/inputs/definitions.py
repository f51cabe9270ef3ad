"""Units, constants, reflectances and spectra of one's own, from a file of definitions.

    NAME = VALUE = SYMBOL = ALIAS ...     a unit, as in `units/light.txt`
    constant NAME = VALUE                 a quantity of expressions and inputs: efficacy NAME
    reflectance NAME = VALUE              a constant from 0 to 1
    spectrum NAME = SPECTRUM              a named spectrum, a kind with parameters, or a file

The compiled file is kept in the user's cache: only a new one loads Pint.
"""

import json
import os
from contextlib import suppress
from typing import Any

from radcalc._version import __version__
from radcalc.errors import ConditionError, quote, quote_path
from radcalc.files.text import readable
from radcalc.units import compiled, horticulture
from radcalc.units.unit import OWN, lookup

MOST_BYTES = 1 << 18  # of a file of definitions
EXPECTED = "a text file of definitions such as: mylamp = 54 lm/W"

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
    rows = _cached(text, name)
    for row in rows:
        _merge(row, os.path.basename(path), os.path.dirname(os.path.abspath(path)))
    _loaded.append(path)


def _cached(text: str, name: str) -> list[Row]:
    """Return the compiled rows from the cache, or compile and keep them."""
    import hashlib

    units = f"{__version__} {len(compiled.UNITS)} {len(compiled.SYMBOLS)} {len(compiled.CONSTANTS)}"
    digest = hashlib.sha256(f"{units}\n{text}".encode()).hexdigest()
    folder = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    path = os.path.join(folder, "radcalc", f"definitions-{digest}.json")
    with suppress(OSError, ValueError, TypeError, KeyError), open(path, encoding="utf-8") as file:
        kept = json.load(file)
        if kept["sum"] == _sum(kept["rows"]):
            rows: list[Row] = kept["rows"]
            return rows
    from radcalc.units.compile import compile_own

    rows = compile_own(text, name)
    with suppress(OSError):
        _keep(path, json.dumps({"rows": rows, "sum": _sum(rows)}))
    return rows


def _sum(rows: list[Row]) -> str:
    import hashlib

    return hashlib.sha256(json.dumps(rows, sort_keys=True).encode()).hexdigest()


def _keep(path: str, text: str) -> None:
    """Write a file at once, so that no reader sees a part of it."""
    import tempfile

    os.makedirs(os.path.dirname(path), mode=0o700, exist_ok=True)
    handle, temporary = tempfile.mkstemp(dir=os.path.dirname(path))
    try:
        with open(handle, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(temporary, path)
    except OSError:
        with suppress(OSError):
            os.unlink(temporary)
        raise


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
    compiled.NOTES[name] = note
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
    if taken or lookup(name) or horticulture.WORDS.get(name.lower()):
        raise ConditionError(f"{place}: '{quote(name)}' is a name of radcalc", "another name")
    path = os.path.join(folder, os.path.expanduser(target))
    if os.path.exists(path) and sources.find_named(target) is None:
        target = path
    sources.OWN[name] = target, note
