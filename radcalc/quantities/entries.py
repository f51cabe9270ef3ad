"""Entries of `radcalc units`: a unit or a constant, its quantity, definition and source.

A search is for the name of a quantity, as in `radcalc quantities`, or for a unit.
"""

from collections.abc import Iterable
from typing import NamedTuple

from radcalc.errors import UnitError, command, corrections, quote
from radcalc.quantities.language import ENGLISH
from radcalc.quantities.light import EXITANCES, describe, is_per_length, name_of, read
from radcalc.quantities.units import composed, named
from radcalc.units import Unit
from radcalc.units.catalogue import CATALOGUE
from radcalc.units.catalogue import CONSTANTS as CATALOGUE_OF_CONSTANTS
from radcalc.units.compiled import CONSTANTS, NAMES, NOTES, PREFIX_NAMES, PREFIX_SYMBOLS, UNITS
from radcalc.units.scale_table import SCALES, Scale, usual
from radcalc.units.scales import find, on
from radcalc.units.table import resolve
from radcalc.units.values import unit as unit_of_constants


class Entry(NamedTuple):
    """The entry of one unit."""

    name: str
    symbols: str
    quantity: str
    definition: str
    source: str
    note: str


def entry(name: str) -> Entry:
    """Return the entry of a named unit."""
    symbols, _, definition, source = CATALOGUE[name]
    prefixes = UNITS[name][3]
    allowed = [s for s, p in PREFIX_SYMBOLS.items() if p in prefixes and s.isascii()]
    takes_all = len(allowed) == len(PREFIX_NAMES)
    takes = f" (prefixes: {'all' if takes_all else ' '.join(allowed)})" if allowed else ""
    spellings = ", ".join(symbols) + takes
    return Entry(
        name, spellings.strip(), name_of(resolve(name)), definition, source, NOTES.get(name, "")
    )


def product(text: str, quantity: str) -> Entry:
    """Return the entry of a unit without a name, such as W/m2."""
    parts = [
        f"{'*' if power > 0 else '/'} {name}{f'**{abs(power)}' if abs(power) > 1 else ''}"
        for name, power in sorted(resolve(text).atoms, key=lambda atom: atom[1] < 0)
    ]
    return Entry(text, "", quantity, " ".join(parts).removeprefix("* "), "", "")


def scales(rows: Iterable[Scale]) -> list[Entry]:
    """Return the entries of scales, with a function instead of a definition."""
    return [
        Entry(
            scale.name,
            ", ".join(scale.spellings[1:]),
            name_of(resolve(scale.unit)),
            f"{scale.formula}: {scale.meaning}"
            + (f", {usual(scale.constant)}" if scale.constant else ""),
            scale.source,
            "",
        )
        for scale in rows
    ]


def constant(name: str) -> Entry:
    """Return the entry of a constant of arithmetic."""
    symbols, _, definition, source = CATALOGUE_OF_CONSTANTS[name]
    unit = unit_of_constants(CONSTANTS[name][2], {name: 1})
    return Entry(name, ", ".join(symbols), name_of(unit) or "constant", definition, source, "")


def constants(text: str = "") -> list[Entry]:
    """Return the entries of the constants with a spelling or a part of a name; all for ''."""
    folded = text.lower().replace("-", "_").replace(" ", "_")
    return [
        constant(name)
        for name, (symbols, names, *_) in CATALOGUE_OF_CONSTANTS.items()
        if text in symbols or (len(folded) != 1 and any(folded in each for each in names))
    ]


def search(text: str) -> list[Entry]:
    """Find units by name, quantity, part of a name or a unit of their quantity, in that order."""
    text = text.strip()
    if not text:
        return [entry(name) for name in UNITS] + scales(SCALES) + constants()
    if text.lower() in ("scale", "scales"):
        return scales(SCALES)
    if text.lower() in ("constant", "constants"):
        return constants()
    if scale := find(text):
        return scales(reading.scale for reading in (scale, *scale.others))
    if text.lower().replace("-", "_") in NAMES:
        return _of_name(text)
    return _of_quantities(text) or _of_name(text) or _of_unit(text)


def _of_quantities(text: str) -> list[Entry]:
    from radcalc.quantities.search import called, comparable, index, with_words

    measured = [(f.quantity.name(ENGLISH), resolve(f.quantity.unit), f.note) for f in called(text)]
    if not measured and (other := index().others.get(comparable(text))):
        measured = [(other.names[0], other.unit, "")]
    if not measured:
        measured = [(q.name(ENGLISH), resolve(q.unit), "") for q in with_words(text)]
    entries: dict[tuple[str, str], Entry] = {}
    for name, unit, note in measured:
        for listed in _of_quantity(name, unit) or [product(unit.text, name)]:
            entries.setdefault(
                (listed.name, listed.quantity), listed._replace(note=listed.note or note)
            )
    return list(entries.values())


def _of_quantity(quantity: str, unit: Unit) -> list[Entry]:
    """Return the named units of a quantity, those of its densities on other axes, and products."""
    leaves = quantity in EXITANCES
    entries = [entry(name) for name in named(unit.dimension)]
    entries = [e for e in entries if (e.quantity in EXITANCES) == leaves]
    entries = [e for e in entries if not leaves or e.quantity == quantity]
    if quantity.startswith("spectral "):
        every = [entry(name) for name in UNITS if name_of(resolve(name)).startswith("spectral ")]
        entries = [e for e in every if e.quantity.startswith(f"{quantity} (")]
    return entries + _products(quantity, unit) + ([] if leaves else scales(on(unit.dimension)))


def _products(quantity: str, unit: Unit) -> list[Entry]:
    texts = [text for text in composed(unit) if not text.isalpha()]
    return [product(text, quantity) for text in texts]


def _of_name(text: str) -> list[Entry]:
    folded = text.lower().replace("-", "_")
    exact = [name for name in UNITS if text in CATALOGUE[name][0]]
    constants_found = constants(text)
    if (exact or constants_found) and len(folded) < 3:
        return [entry(name) for name in exact] + constants_found
    part = [n for n in UNITS if n not in exact and any(folded in k for k in CATALOGUE[n][1])]
    folded = folded.replace("_", " ")
    scales_found = [
        scale for scale in SCALES if any(folded in spelling.lower() for spelling in scale.spellings)
    ]
    return [entry(name) for name in exact + part] + scales(scales_found) + constants_found


def _of_unit(text: str) -> list[Entry]:
    """Return the quantities that have this unit; UnitError if there are none."""
    try:
        unit = resolve(text)
    except UnitError as error:
        from radcalc.quantities.search import index, near

        names = near(text, 2, index().others.values())
        raise UnitError(
            f"unknown unit or quantity '{quote(text)}'", corrections(text, *names) or error.tries
        ) from None
    reading = read(unit)
    entries = []
    if not is_per_length(unit):
        entries = [entry(name) for name in named(unit.dimension)]
    entries += _products(name_of(unit), unit)
    entries += [] if unit.is_exitance else scales(on(unit.dimension))
    if reading and is_per_length(unit):  # a unit of a strip, and of a spectrum
        spectral = Unit("", 1, 1, unit.dimension, (("nanometre", -1),))
        entries += _products(reading.name, spectral)
    if not entries:
        raise UnitError(f"no named unit of {describe(unit)}", command("units"))
    return entries
