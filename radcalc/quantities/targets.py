"""The unit that the name of a quantity stands for: TARGET of a conversion, and its completion.

A unit's own name wins over a quantity's; a name that has several meanings is refused with them.
"""

from typing import NamedTuple

from radcalc.errors import UnitError, manual, nearest, quote
from radcalc.quantities.language import ENGLISH, LANGUAGES
from radcalc.quantities.light import EXITANCES, KINDS, read
from radcalc.quantities.names import MISNOMERS, PPF, PPFD, QUANTITIES, Quantity
from radcalc.quantities.search import Other, called, comparable, index
from radcalc.quantities.search import near as names_like
from radcalc.quantities.symbols import LIGHT_UNITS, SYMBOLS, light_unit, specific_name
from radcalc.quantities.units import composed
from radcalc.units.dimensions import COHERENT
from radcalc.units.table import resolve, suggest, unit_of
from radcalc.units.unit import Exitance, Photosynthetic, Unit

# Names that serve every kind of light: the source decides which.
GENERIC = ("flux", "irradiance", "exitance", "radiance", "exposure", "energy")
SHORTEST = 3  # letters of a name: what is shorter is a symbol
# No unit tells these from Ω, K and a number; the commands that give them.
WITHOUT_OWN_UNIT = {"Ω_p": "solid-angle", "η_v": "point-source", "V(λ)": "photon"}


class Target(NamedTuple):
    """What a name stands for: a quantity's English name, its usual unit, and a note."""

    name: str
    unit: str
    note: str = ""

    def as_unit(self) -> Unit:
        """Return the unit, with what is to be said of the name."""
        kind = Exitance if self.name in EXITANCES else Unit
        return resolve(self.unit).of_class(kind, *filter(None, [self.note]))


def named(text: str, source: Unit | None = None) -> Unit:
    """Return the usual unit of the quantity of that name, which is the name of no unit.

    `source` decides the kind of a name that serves every kind, where it is known.  Raises
    UnitError for what is no quantity either, and for a name that has several meanings.
    """
    meanings = _meanings(text, source)
    if not meanings:
        raise _without_unit(text) or _unknown(text)
    if len(meanings) > 1:
        raise _ambiguous(text, meanings)
    unit = meanings[0].as_unit()
    if comparable(text) in (*PPFD, *PPF):
        photosynthetic = unit.of_class(Photosynthetic)
        photosynthetic.name = text
        return photosynthetic
    return unit


def is_name(text: str) -> bool:
    """Return whether a quantity, or several, are called that."""
    return bool(_meanings(text, None)) or comparable(text) in index().names


def names_starting(prefix: str) -> list[tuple[str, str]]:
    """Return the names of quantities that begin so, each as one word, with their usual units."""
    return sorted((name, target.unit) for name, target in _targets(comparable(prefix)).items())


def _meanings(text: str, source: Unit | None) -> list[Target]:
    """Return what a name may stand for."""
    folded = comparable(text)
    if len(folded) < SHORTEST:
        return []
    if folded in GENERIC:
        return _of_kinds(folded, source)
    if exact := index().names.get(folded):
        return [_target(q) for q in exact if q.symbol not in WITHOUT_OWN_UNIT]
    matches = [f for f in called(text) if f.quantity.symbol not in WITHOUT_OWN_UNIT]
    if matches := [f for f in matches if "λ" not in f.quantity.symbol]:
        return [_target(f.quantity, f.note) for f in matches]
    other = index().others.get(folded)
    target = _other(other) if other else None
    return [target] if target else []


def _of_kinds(name: str, source: Unit | None) -> list[Target]:
    """A name for every kind of light: of the source's, or of all where it has none.

    Irradiance and radiance are names of radiant quantities, too: those are meant where the
    source has no kind, or is of that geometry already.
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
    """A quantity in the unit in which results show it."""
    reading = read(resolve(quantity.unit))
    unit = quantity.unit
    if reading and not reading.axis and not reading.retinal:
        unit = LIGHT_UNITS[reading.geometry][0][KINDS.index(reading.kind)]
    name = quantity.name(ENGLISH)
    return Target(name, "lm/m2" if name in EXITANCES and unit == "lx" else unit, note)


def _other(other: Other) -> Target | None:
    """What is no light of the vocabulary in the unit in which results show it; None without one."""
    name, dimension = other.names[0], other.unit.dimension
    symbol = SYMBOLS.get(name.replace(" ", "-"))
    units = (symbol.unit if symbol else "", *composed(other.unit), COHERENT.get(dimension, ""))
    usual = next((u for u in units if u and resolve(u).dimension == dimension), None)
    return Target(name, usual) if usual else None


def _targets(start: str) -> dict[str, Target]:
    """Return every name with one meaning that begins so, as one word."""
    targets = {}
    for folded, name in _names().items():
        if folded.startswith(start) and unit_of(name) is None:
            meanings = _meanings(name, None)
            if len(meanings) == 1 or folded in GENERIC:
                targets[name.replace(" ", "-")] = meanings[0]
    return targets


def _names() -> dict[str, str]:
    """Return every name, by how it is compared."""
    names = [name for q in QUANTITIES for language in LANGUAGES for name in q.names(language)]
    names += [term for terms, _, _ in MISNOMERS for term in terms]
    names += [name for other in index().others.values() for name in other.names]
    return {comparable(name): name for name in (*names, *GENERIC)}


def _without_unit(text: str) -> UnitError | None:
    """Refuse a quantity that no unit tells from another; None for every other text."""
    for quantity in index().names.get(comparable(text), ()):
        name, symbol = quantity.name(ENGLISH), quantity.symbol
        return UnitError(f"no unit is of {name} alone", manual(WITHOUT_OWN_UNIT[symbol]))
    return None


def _unknown(text: str) -> UnitError:
    """Refuse what is neither a unit nor a quantity, with the names of quantities like it."""
    try:
        resolve(text)
    except UnitError as error:
        unknown = error
    if all(c.isalpha() or c in " -_" for c in text):
        known = _names()
        alike = [known[name] for name in nearest(comparable(text), known, 4, 0.75)]
        near = [name for name in alike if len(_meanings(name, None)) == 1][:2]
        if near:
            hint = ", ".join(dict.fromkeys([*near, *suggest(text)]))
            unknown = unknown.reworded(hint=hint)
        elif " " in text.strip() and (alike := names_like(text, 2)):  # of a quantity, no unit
            unknown = UnitError(f"no quantity or unit is called '{quote(text)}'", ", ".join(alike))
    return unknown


def _ambiguous(text: str, meanings: list[Target]) -> UnitError:
    """Refuse a name of several quantities."""
    names = [f"{target.name} ({target.unit})" for target in meanings]
    units = dict.fromkeys(target.unit.replace(" ", ".") for target in meanings)
    return UnitError(
        f"'{quote(text)}' may be {', '.join(names[:-1])} or {names[-1]}", ", ".join(units)
    )
