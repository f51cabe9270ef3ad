"""Search for a quantity by a name, a symbol, a unit or a misnomer; names of quantities as units.

A quantity is named as the TARGET of a conversion, and completed there; the name of a unit takes
precedence over that of a quantity.
"""

import unicodedata
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from itertools import product
from typing import NamedTuple, TypeVar

from radcalc.errors import UnitError, UsageError, command, corrections, manual, nearest, quote
from radcalc.quantities import (
    EXITANCES,
    GEOMETRIES,
    KIND_NAMES,
    KINDS,
    LUMINOUS,
    NONE,
    OTHERS,
    PER_WAVELENGTH,
    Reading,
    base_of,
    is_per_length,
    light_dimension,
    name_of,
    read,
    with_suffix,
)
from radcalc.quantities.language import ENGLISH, LANGUAGES
from radcalc.quantities.names import (
    DLI,
    ELSEWHERE,
    LABELS,
    MISNOMERS,
    OTHER_NAMES,
    PPF,
    PPFD,
    QUANTITIES,
    Quantity,
    composed,
)
from radcalc.quantities.symbols import LIGHT_UNITS, SYMBOLS, light_unit, specific_name
from radcalc.units import NUMBER, Exitance, Unit, table
from radcalc.units.catalogue import CATALOGUE
from radcalc.units.compiled import QUANTITIES as QUANTITIES_OF_UNITS
from radcalc.units.compiled import WEIGHTS
from radcalc.units.dimensions import COHERENT, LENGTH
from radcalc.units.languages import bare
from radcalc.units.table import resolve, suggest, unit_of
from radcalc.units.values import find_scale, resolve_any

KIND_OF_SUBSCRIPT = {"e": "radiometric", "v": "photometric", "p": "photon"}
GREEK = {"lambda": "λ", "phi": "Φ", "Phi": "Φ", "omega": "Ω", "Omega": "Ω", "eta": "η"}
BRACKETS = str.maketrans("[]()", "    ")
IN_NO_NAME = "!?#@$&=<>|~;"  # characters that names do not contain
LONGEST = 200  # characters of a search
Item = TypeVar("Item")


class Found(NamedTuple):
    """A quantity found by a search, with a note if it was found by another name."""

    quantity: Quantity
    note: str = ""


def comparable(text: str) -> str:
    """Return a text for comparison: no case, no diacritics, single blanks between words."""
    if text.isascii() and text.replace("-", "").replace(" ", "").isalnum():  # most names
        return " ".join(text.lower().replace("-", " ").split())
    parts = (c if c.isalnum() or c in IN_NO_NAME else " " for c in bare(text))
    return " ".join("".join(parts).split())


def matching(
    text: str,
    items: Iterable[Item],
    where: Callable[[Item], str],
    alike: Callable[[str, str], bool] = str.startswith,
) -> list[Item]:
    """Return the items whose text has, for every word of another text, a word that begins so.

    A text that is too long for a search has none.
    """
    words = {*comparable(text).split()} if len(text) <= LONGEST else set()
    return [item for item in items if words and _have(where(item), words, alike)]


def _have(text: str, words: Iterable[str], alike: Callable[[str, str], bool]) -> bool:
    own = comparable(text).split()
    return all(any(alike(one, word) for one in own) for word in words)


def search(text: str) -> list[Found]:
    """Find quantities by name, misnomer, symbol, unit or parts of a name; all for an empty text.

    The first of these with a match decides.
    """
    text = text.strip()
    if not text:
        return [Found(q) for q in QUANTITIES]
    if len(text) > LONGEST:
        raise UsageError(f"unknown quantity '{quote(text)}'", "a name of a few words")
    unit = _unit(text.strip("[]()"))
    matches = (
        called(text)
        or _by_symbol(text, str)
        or _of_labels(text)
        or _by_words(text, str.__eq__)
        or _by_name_and_unit(text)
        or _by_unit(unit)
        or _by_symbol(text, str.casefold)
        or _by_words(text, str.startswith)
        or (_by_words(text, str.__contains__) if len(comparable(text)) > 2 else [])
    )
    if matches:
        return matches
    if unit and (measured := name_of(unit)):
        raise UsageError(
            f"'{quote(text)}' measures {measured}, not a quantity of light", command("quantities")
        )
    raise UsageError(
        f"unknown quantity '{quote(text)}'",
        corrections(text, *near(text, 3)) or f"{command('quantities')}, which lists them all",
    )


class Other(NamedTuple):
    """A quantity outside the vocabulary of light: a length, an efficacy, a density.

    `unit` has its dimension, and no text but for a quantity with a unit of its own: UV index, UVI.
    """

    names: tuple[str, ...]
    unit: Unit


class Index(NamedTuple):
    """The names of quantities in their form for comparison."""

    names: dict[str, list[Quantity]]
    misnomers: dict[str, dict[str, str]]  # symbol of the quantity -> explanation
    others: dict[str, Other]
    words: dict[str, list[list[list[str]]]]  # of the names of a quantity in each language


@cache
def index() -> Index:
    """Return all names and misnomers in all languages."""
    result = Index({}, {}, {}, {})
    for other in _other_quantities():
        result.others.update({comparable(name): other for name in other.names})
    for q in QUANTITIES:
        names = [[comparable(name) for name in q.names(lang)] for lang in LANGUAGES]
        names.append([comparable(n) for n in ELSEWHERE.get(q.symbol, "").split(", ") if n])
        for name in dict.fromkeys(name for group in names for name in group):
            result.names.setdefault(name, []).append(q)
        result.words[q.symbol] = [[name.split() for name in group] for group in names]
    for terms, symbol, note in MISNOMERS:
        for term in terms:
            result.misnomers.setdefault(comparable(term), {})[symbol] = note
    return result


def _other_quantities() -> Iterator[Other]:
    """Return the quantities of `name_of` that are not in the vocabulary, and the wavelength."""
    for dimension, (name, _) in OTHERS.items():
        if dimension != NUMBER:
            yield Other((name, *names_elsewhere(name)), Unit("", 1, 1, dimension, ()))
    for kind, geometry in product(KIND_NAMES, GEOMETRIES):
        for axis, below in ((NONE, ()), (PER_WAVELENGTH, (("nanometre", -1),))):
            name = Reading(kind, *geometry, axis).name.partition(" (")[0]
            yield Other((name,), Unit("", 1, 1, light_dimension(kind, geometry, axis), below))
    for suffix, (name, base, *_) in WEIGHTS.items():  # blue-light, epar
        if base != LUMINOUS and name not in table.PAR:
            yield Other((name,), resolve(light_unit("irradiance", suffix)))
    for own, name in QUANTITIES_OF_UNITS.items():
        symbols = CATALOGUE[own][0]
        shorter = name.replace("melanopic", "mel").replace(" (", " ").rstrip(")")
        yield Other((name, shorter), resolve((symbols or (own,))[0]))
    yield Other(("wavelength", *names_elsewhere("wavelength")), Unit("", 1, 1, LENGTH, ()))


def names_elsewhere(label: str) -> tuple[str, ...]:
    """Return the other names of a label: in Czech, in Russian, and for searches."""
    others = OTHER_NAMES.get(label)
    return (*LABELS.get(label, ()), *(others.split(", ") if others else ()))


def called(text: str) -> list[Found]:
    """Return the quantities with that full name in any language, then those with that misnomer.

    Some misnomers are part of correct names.  The quantities with "intensity" in their names come
    first; the ratios with "výkon" and the densities with "плотность потока" come last.
    """
    folded = comparable(text)
    named = [Found(q) for q in index().names.get(folded, ())]
    notes = index().misnomers.get(folded, {})
    misnamed = [Found(q, notes[q.symbol]) for q in QUANTITIES if q.symbol in notes]
    parts = _by_words(text, str.__eq__, 1) if misnamed and not named else []
    rightly_named = [f for f in (*named, *parts) if f.quantity.symbol not in notes]
    last = [f for f in rightly_named if parts and not _is_plain(f.quantity)]
    return [f for f in rightly_named if f not in last] + misnamed + last


def _is_plain(quantity: Quantity) -> bool:
    """Return whether a quantity is light itself, not a ratio or a spectral density."""
    reading = read(resolve(quantity.unit))
    return reading is not None and reading.axis == NONE


def label_of(text: str) -> str:
    """Return the English label of a quantity outside the vocabulary of light, by any of its names.

    '' if there is none: vlnová délka is the wavelength.
    """
    return _labels().get(comparable(text), "")


@cache
def _labels() -> dict[str, str]:
    labels = {}
    for label, others in OTHER_NAMES.items():
        names = (label, *LABELS[label], *others.split(", "))
        labels.update({comparable(name): label for name in names})
    return labels


def _of_labels(text: str) -> list[Found]:
    """Return the quantity of `OTHER_NAMES` with that name in any language: the wavelength."""

    label = label_of(text)
    symbol = next((s for s in SYMBOLS.values() if s.label == label), None) if label else None
    if symbol is None:
        return []
    names = LABELS[label]
    return [Found(Quantity(symbol.letter, symbol.unit, label, *names, symbol.help))]


def with_words(text: str) -> list[Quantity]:
    """Return the quantities whose first name contains every word of the text."""
    return [f.quantity for f in _by_words(text, str.__eq__, 1)] if len(comparable(text)) > 2 else []


def near(text: str, count: int, others: Iterable[Other] = ()) -> list[str]:
    """Return the names, of quantities of light and of `others`, most similar to an unknown name."""
    names = [name for q in QUANTITIES for lang in LANGUAGES for name in q.names(lang)]
    by_comparable = {
        comparable(name): name for name in (*names, *(n for other in others for n in other.names))
    }
    return [by_comparable[name] for name in nearest(comparable(text), by_comparable, count)]


def symbol_key(symbol: str) -> str:
    """Return a symbol for comparison: E_v, Ev, $E_{v}$ and Eᵥ are equal, and so are Φ and Phi."""
    text = unicodedata.normalize("NFKC", symbol)
    for name, letter in GREEK.items():
        text = text.replace(name, letter)
    return "".join(c for c in text if c.isalnum())


def _by_symbol(text: str, case: Callable[[str], str]) -> list[Found]:
    """Return the quantities with that symbol, or with that letter without its subscript."""
    key = case(symbol_key(case(text)))
    matches = []
    for q in QUANTITIES:
        letter, _, below = q.symbol.partition("_")
        keys = {symbol_key(q.symbol), symbol_key(q.symbol.replace("_e,", "_"))}
        if below in KIND_OF_SUBSCRIPT or "(" in letter:
            keys.add(letter[0])
        if key in map(case, keys):
            matches.append(Found(q))
    return matches


def _by_words(
    text: str, alike: Callable[[str, str], bool], first: int | None = None
) -> list[Found]:
    words = comparable(text).split()
    matches = []
    for q in QUANTITIES:
        kind = [KIND_OF_SUBSCRIPT.get(q.symbol.partition("_")[2][:1], "")]
        names = [name + kind for group in index().words[q.symbol] for name in group[:first]]
        if words and any(all(any(alike(n, w) for n in name) for w in words) for name in names):
            matches.append(Found(q))
    return matches


def _unit(text: str) -> Unit | None:
    unit = find_scale(text) or unit_of(text)
    return unit if unit and unit.dimension != NUMBER else None


def _by_unit(unit: Unit | None) -> list[Found]:
    """Return the quantities of a unit; for an unlisted density, the quantity without its axis."""
    if unit is None:
        return []
    if is_per_length(unit):
        return _per_length(unit)
    measured = [q for q in QUANTITIES if resolve(q.unit).dimension == unit.dimension]
    if unit.is_exitance:
        measured = [q for q in measured if q.symbol.startswith("M")]
    elif name_of(unit) == "illuminance" and not any(n.endswith("lumen") for n, _ in unit.atoms):
        # the lux is not a unit of exitance
        measured = [q for q in measured if not q.symbol.startswith("M")]
    if measured:
        return [Found(q) for q in measured]
    reading = read(unit)
    if reading is None or reading.axis == NONE:
        return []
    return _without_axis(reading, f"{quote(unit.text)} measures {name_of(unit)}")


def _without_axis(reading: Reading, note: str) -> list[Found]:
    name = reading._replace(axis=NONE).name
    return [Found(q, note) for q in QUANTITIES if name in q.names("en")]


def _per_length(unit: Unit) -> list[Found]:
    """Return both readings of W/m: of a strip, and of a spectrum."""
    reading = read(unit)
    if reading is None:
        return []
    of_strip = f"{quote(unit.text)} measures {name_of(unit)}, as of a strip of lamps"
    of_spectrum = f"{reading.name} if the length is a wavelength"
    spectral = [q for q in QUANTITIES if resolve(q.unit).dimension == unit.dimension]
    if not spectral:
        return _without_axis(reading, f"{of_strip}, and {of_spectrum}")
    note = f"{quote(unit.text)} measures {of_spectrum}"
    return _without_axis(reading, of_strip) + [Found(q, note) for q in spectral]


def _by_name_and_unit(text: str) -> list[Found]:
    """Return the quantity of a name followed by a unit, which may be that of another quantity."""
    words = text.translate(BRACKETS).split()
    for cut in range(1, len(words)):
        name, rest = " ".join(words[:cut]), words[cut:]
        unit = _unit(" ".join(rest[1:] if rest[0] in ("in", "v", "в") else rest))
        if unit is None or not (named := called(name)):
            continue
        fitting = [f for f in named if resolve(f.quantity.unit).dimension == unit.dimension]
        if fitting:
            return fitting
        right = named[0].quantity
        note = f"{right.name('en')} is measured in {right.unit}, not in {quote(unit.text)}"
        measured = [f for f in _by_unit(unit) if not f.note]
        if measured:
            note += f", which measures {measured[0].quantity.name('en')}"
        return [Found(f.quantity, note) for f in (measured or named)]
    return []


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
    if kind := {comparable(row[0]): suffix for suffix, row in WEIGHTS.items()}.get(folded):
        reading = read(source) if source else None
        geometry = reading.geometry if reading and reading.geometry in LIGHT_UNITS else (0, 1, 0)
        unit = _usual_unit(geometry, kind)
        return [Target(name_of(resolve(unit)), unit)]
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


def _usual_unit(geometry: tuple[int, int, int], kind: str) -> str:
    return with_suffix(LIGHT_UNITS[geometry][0][KINDS.index(base_of(kind))], kind)


def _plain(name: str, kind: str) -> str:
    return specific_name(name, kind).replace("-", " ")


def _target(quantity: Quantity, note: str = "") -> Target:
    reading = read(resolve(quantity.unit))
    unit = quantity.unit
    if reading and not reading.axis and not reading.retinal:
        unit = _usual_unit(reading.geometry, reading.kind)
    name = quantity.name(ENGLISH)
    return Target(name, "lm/m2" if name in EXITANCES and unit == "lx" else unit, note)


def _other_target(other: Other) -> Target | None:
    """Return a quantity outside the vocabulary of light and its unit of display, or None."""
    name, dimension = other.names[0], other.unit.dimension
    if other.unit.text:
        return Target(name, other.unit.text)
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
        likely = [name for name in alike if len(_meanings(name, None)) == 1][:2]
        if likely:
            others = dict.fromkeys([*likely, *suggest(text)])
            unknown = unknown.reworded(hint=corrections(text, *others))
        elif " " in text.strip() and (similar := near(text, 2)):  # a quantity, not a unit
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
