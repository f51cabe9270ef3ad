"""Names of results as people write them: a symbol (E_v, Φ), or a name in another language.

The name of a result itself (`illuminance`) is looked up before.
"""

from collections.abc import Sequence

from radcalc.answer import Value
from radcalc.errors import UsageError, ambiguous, corrections
from radcalc.quantities import KINDS, read
from radcalc.quantities.names import LABELS, QUANTITIES, Quantity
from radcalc.quantities.search import called, comparable, label_of, symbol_key
from radcalc.quantities.symbols import SPECIFIC, SYMBOLS, light_unit
from radcalc.units import Dimension
from radcalc.units.table import resolve


def results_meant(
    name: str, values: Sequence[Value], dimension: Dimension | None = None
) -> tuple[str, str]:
    """Return the result, and its unit or '', that a symbol or a foreign name means.

    `dimension` is that of the unit that is asked for.  The result may be absent.  Both are '' if
    the name means no result, or none of that dimension.  Raises UsageError if it means several.
    """
    if name in SPECIFIC or name in SYMBOLS:
        return "", ""
    present = [value for value in values if not value.is_absent]
    found = _by_letter(name, present) or _by_name(name, present) or _by_name(name, values)
    if dimension:
        found = [way for way in found if _measures(way[1], dimension)]
    if len(found) > 1:
        ways = [":".join(filter(None, way)) for way in found]
        raise UsageError(ambiguous(name), corrections(name, *ways))
    return found[0] if found else ("", "")


def _measures(unit: str, dimension: Dimension) -> bool:
    """Return whether a unit of a result, '' for any, has a dimension."""
    return not unit or resolve(unit).dimension == dimension


def _by_letter(name: str, values: Sequence[Value]) -> list[tuple[str, str]]:
    """Return the results with a symbol; a letter alone is that of any kind of light."""
    typed = symbol_key(name)
    if not typed:
        return []
    if exact := [value for value in values if symbol_key(value.letter) == typed]:
        return _distinct(exact)
    if bare := [value for value in values if _bare(value.letter) == typed]:
        return _distinct(bare)
    return _of_light([q for q in QUANTITIES if symbol_key(q.symbol) == typed], values)


def _bare(letter: str) -> str:
    head, _, below = letter.partition("_")
    return symbol_key(head) if below in KINDS else ""


def _by_name(name: str, values: Sequence[Value]) -> list[tuple[str, str]]:
    """Return the results with that name in any language, or with that other word for it."""
    folded = comparable(name)
    labels = {label for label, names in LABELS.items() if folded in map(comparable, names)}
    labels |= {label_of(name)} - {""}
    if labelled := [value for value in values if value.label in labels or value.name in labels]:
        return _distinct(labelled)
    return _of_light([found.quantity for found in called(name)], values)


def _of_light(quantities: Sequence[Quantity], values: Sequence[Value]) -> list[tuple[str, str]]:
    """Return the results that are one of the quantities, in its unit; those at hand if any are."""
    found = {}
    by_name = {value.name: value for value in values}
    for quantity in quantities:
        name = quantity.name("en").replace(" ", "-")
        reading = read(resolve(quantity.unit))
        generic, kind = SPECIFIC.get(name, (name, reading.kind if reading else ""))
        if name in SPECIFIC and name in by_name:
            found[name, ""] = True
            continue
        value = by_name.get(generic)
        if value is None:
            continue
        unit = light_unit(generic, kind) if kind and not (reading and reading.axis) else ""
        own = bool(unit) and _measures(unit, value.dimensions[0])
        found[generic, "" if own else unit] = own or not unit
    return [way for way, is_own in found.items() if is_own] or list(found)


def _distinct(values: Sequence[Value]) -> list[tuple[str, str]]:
    return list(dict.fromkeys((value.name, "".join(value.units[:1])) for value in values))
