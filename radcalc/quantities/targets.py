"""Names of quantities as units: TARGET of a conversion, and its completion.

The name of a unit takes precedence over that of a quantity.
"""

from typing import NamedTuple

from radcalc.errors import UnitError, corrections, manual, nearest, quote
from radcalc.quantities.language import ENGLISH, LANGUAGES
from radcalc.quantities.light import EXITANCES, KINDS, read
from radcalc.quantities.names import DLI, MISNOMERS, PPF, PPFD, QUANTITIES, Quantity
from radcalc.quantities.search import Other, called, comparable, index
from radcalc.quantities.search import near as names_like
from radcalc.quantities.symbols import LIGHT_UNITS, SYMBOLS, light_unit, specific_name
from radcalc.quantities.units import composed
from radcalc.units import Exitance, Unit, table
from radcalc.units.dimensions import COHERENT
from radcalc.units.scales import resolve_any
from radcalc.units.table import resolve, suggest, unit_of

# Names for every kind of light; the source determines the kind.
GENERIC = ("flux", "irradiance", "exitance", "radiance", "exposure", "energy")
SHORTEST = 3  # letters of a name; shorter texts are symbols
# Quantities with the units of others (Ω, K, a number), and the commands that compute them.
WITHOUT_OWN_UNIT = {
    "Ω_p": "solid-angle",
    "η_v": "point-source",
    "V(λ)": "photon",
    "K(λ)": "photon",
    "f_r": "lambertian",
}


class Target(NamedTuple):
    """The meaning of a name: a quantity's English name, its usual unit, and a note."""

    name: str
    unit: str
    note: str = ""

    def as_unit(self) -> Unit:
        kind = Exitance if self.name in EXITANCES else Unit
        return resolve(self.unit).of_class(kind, *filter(None, [self.note]))


def named(text: str, source: Unit | None = None) -> Unit:
    """Return the usual unit of the quantity with that name, which is not the name of a unit.

    A known `source` determines the kind of a name for every kind.
    """
    table.refuse_par(text)
    for names in (PPFD, PPF, DLI):
        if comparable(text) in names:
            return resolve_any(names[0])
    meanings = _meanings(text, source)
    if not meanings:
        raise _without_unit(text) or _unknown(text)
    if len(meanings) > 1:
        raise _ambiguous(text, meanings, source)
    return meanings[0].as_unit()


def is_name(text: str) -> bool:
    """Return whether a text is the name of one or several quantities."""
    return bool(_meanings(text, None)) or comparable(text) in index().names


def names_with_units() -> list[tuple[str, str]]:
    """Return the unambiguous names of quantities, each as one word, with their usual units."""
    units = {}
    for folded, name in _names().items():
        if unit_of(name) is None:
            meanings = _meanings(name, None)
            if len(meanings) == 1 or folded in GENERIC:
                units[name.replace(" ", "-")] = meanings[0].unit
    return sorted(units.items())


def _meanings(text: str, source: Unit | None) -> list[Target]:
    """Return the quantities that the text can name, none if it names no quantity."""
    folded = comparable(text)
    if len(folded) < SHORTEST or folded in table.PAR:
        return []
    if folded in DLI:
        return [Target("photon exposure", table.GROWERS_WORDS["dli"][0], table.DLI)]
    if folded in GENERIC:
        return _of_kinds(folded, source)
    if exact := index().names.get(folded):
        return [_target(q) for q in exact if q.symbol not in WITHOUT_OWN_UNIT]
    matches = [f for f in called(text) if f.quantity.symbol not in WITHOUT_OWN_UNIT]
    if matches := [f for f in matches if "λ" not in f.quantity.symbol]:
        return [_target(f.quantity, f.note) for f in matches]
    other = index().others.get(folded)
    target = _other_target(other) if other else None
    return [target] if target else []


def _of_kinds(name: str, source: Unit | None) -> list[Target]:
    """Return the meanings of a name for every kind of light: the source's kind, or all kinds.

    Irradiance and radiance are radiant quantities if the source has no kind or has that geometry.
    """
    reading = read(source) if source else None
    kinds = (reading.kind,) if reading else KINDS
    targets = [Target(_plain(name, kind), light_unit(name, kind)) for kind in kinds]
    if source is None or reading is None or resolve(targets[0].unit).dimension == source.dimension:
        return [_target(q) for q in index().names.get(name, ())] or targets
    return targets


def _plain(name: str, kind: str) -> str:
    return specific_name(name, kind).replace("-", " ")


def _target(quantity: Quantity, note: str = "") -> Target:
    reading = read(resolve(quantity.unit))
    unit = quantity.unit
    if reading and not reading.axis and not reading.retinal:
        unit = LIGHT_UNITS[reading.geometry][0][KINDS.index(reading.kind)]
    name = quantity.name(ENGLISH)
    return Target(name, "lm/m2" if name in EXITANCES and unit == "lx" else unit, note)


def _other_target(other: Other) -> Target | None:
    """Return a quantity outside the vocabulary of light and its unit of display, or None."""
    name, dimension = other.names[0], other.unit.dimension
    symbol = SYMBOLS.get(name.replace(" ", "-"))
    units = (symbol.unit if symbol else "", *composed(other.unit), COHERENT.get(dimension, ""))
    usual = next((u for u in units if u and resolve(u).dimension == dimension), None)
    return Target(name, usual) if usual else None


def _names() -> dict[str, str]:
    names = [name for q in QUANTITIES for language in LANGUAGES for name in q.names(language)]
    names += [term for terms, _, _ in MISNOMERS for term in terms]
    names += [name for other in index().others.values() for name in other.names]
    return {comparable(name): name for name in (*names, *GENERIC)}


def _without_unit(text: str) -> UnitError | None:
    """Return the error for a quantity that shares its unit with another; None for other texts."""
    for quantity in index().names.get(comparable(text), ()):
        name, symbol = quantity.name(ENGLISH), quantity.symbol
        problem = f"{name} has no unit that distinguishes it"
        return UnitError(problem, manual(WITHOUT_OWN_UNIT[symbol]))
    return None


def _unknown(text: str) -> UnitError:
    """Return the error for a text that names no quantity, with similar names."""
    unknown = UnitError(f"'{quote(text)}' is a unit, not the name of a quantity", "a name")
    try:
        resolve(text)
    except UnitError as error:
        unknown = error
    if all(c.isalpha() or c in " -_" for c in text):
        known = _names()
        alike = [known[name] for name in nearest(comparable(text), known, 4, 0.75)]
        near = [name for name in alike if len(_meanings(name, None)) == 1][:2]
        if near:
            others = dict.fromkeys([*near, *suggest(text)])
            unknown = unknown.reworded(hint=corrections(text, *others))
        elif " " in text.strip() and (similar := names_like(text, 2)):  # a quantity, not a unit
            problem = f"unknown unit or quantity '{quote(text)}'"
            unknown = UnitError(problem, corrections(text, *similar))
    return unknown


def _ambiguous(text: str, meanings: list[Target], source: Unit | None) -> UnitError:
    """Return the error for a name of several quantities; those of the source's kind come first."""
    names = [f"{target.name} ({target.unit})" for target in meanings]
    kind = _kind(source) if source else ""
    by_kind = sorted(meanings, key=lambda target: _kind(resolve(target.unit)) != kind)
    units = dict.fromkeys(target.unit.replace(" ", ".") for target in by_kind)
    return UnitError(
        f"'{quote(text)}' is ambiguous: {', '.join(names[:-1])} or {names[-1]}",
        corrections(text, *units),
    )


def _kind(unit: Unit) -> str:
    reading = read(unit)
    return reading.kind if reading else ""
