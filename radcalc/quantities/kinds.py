"""Units in the kind of light of an observer or a weight: lumens of scotopic eyes, lm_scot."""

from radcalc.errors import UnitError, quote
from radcalc.quantities import (
    KIND_NAMES,
    LUMINOUS,
    coherent_text,
    ratio_of,
    read,
    with_suffix,
)
from radcalc.units import Unit
from radcalc.units.compiled import WEIGHTS
from radcalc.units.table import unit_of


def kind_of(unit: Unit) -> str:
    """Return the kind of light of a unit; '' for another quantity."""
    reading = None if unit.is_scale else read(unit)
    return reading.kind if reading else ""


def as_seen(unit: Unit, kind: str) -> Unit:
    """Return a unit of lumens, or of a ratio of them, as that of an observer's kind."""
    if kind == LUMINOUS or unit.is_scale:
        return unit
    pair = ratio_of(unit.dimension)
    if kind_of(unit) == LUMINOUS or (pair and LUMINOUS in pair):
        return _in_kind(unit, kind)
    return unit


def is_seen(unit: Unit, kind: str) -> bool:
    """Return whether a unit is of the lumens of an observer's kind, or a ratio of them."""
    pair = None if unit.is_scale else ratio_of(unit.dimension)
    return kind in (kind_of(unit), *(pair or ()))


def weighted(unit: Unit, kind: str) -> Unit:
    """Return a unit as that of a weight: W/m2 as W_mel/m2; as it is, if it is of a weight.

    Raises UnitError if the light has no such unit in the kind.
    """
    own = kind_of(unit)
    return unit if own in WEIGHTS or not own else _in_kind(unit, kind)


def _in_kind(unit: Unit, kind: str) -> Unit:
    """Return a unit in a weighted kind: with the suffix of the kind at its light."""
    texts = [f"{WEIGHTS[kind][3]}_{unit.text.lower()}"]
    for start, c in enumerate(unit.text):
        if c.isalpha() and not unit.text[max(start - 1, 0) : start].isalpha():
            texts.append(unit.text[:start] + with_suffix(unit.text[start:], kind))
    for text in texts:
        if (found := unit_of(text)) and is_seen(found, kind):
            return found.of_class(type(unit)) if unit.is_exitance else found
    raise UnitError(
        f"'{quote(unit.text)}' is not a unit of {KIND_NAMES[kind]} light", _usual(unit, kind)
    )


def _usual(unit: Unit, kind: str) -> str:
    reading = read(unit)
    if reading is None or reading.retinal:
        return "a unit of watts, lumens or photons"
    return f"the amount in {coherent_text(reading._replace(kind=kind))}"
