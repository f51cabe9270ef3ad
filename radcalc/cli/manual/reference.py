"""Generated parts about the tables: quantities, conditions, units, prefixes and scales."""

from collections.abc import Iterator, Sequence

from radcalc.cli.manual.mdoc import argument, plain, sentences, text
from radcalc.cli.spelling import spelled
from radcalc.conversion.bridge import WANTED
from radcalc.conversion.plan import plan, target_of
from radcalc.errors import MissingCondition, RadcalcError
from radcalc.quantities.entries import Entry, entry
from radcalc.quantities.entries import scales as scale_entries
from radcalc.quantities.language import ENGLISH
from radcalc.quantities.light import GEOMETRIES, KINDS, read
from radcalc.quantities.names import MISNOMERS, QUANTITIES, Quantity
from radcalc.units.compiled import PREFIX_NAMES, PREFIX_SYMBOLS, UNITS
from radcalc.units.scale_table import SCALES
from radcalc.units.unit import Unit

EXITANCE = "M"  # of its symbol
LANGUAGE_NAMES = {"cs": "Czech", "ru": "Russian"}
LIGHT = [names[i] for i in range(len(KINDS)) for names, _ in GEOMETRIES.values()]


def quantities(_: str) -> Iterator[str]:
    """Yield each quantity: name, symbol, unit, definition, other names, and conversions."""
    yield ".Bl -tag -width Ds"
    for quantity in QUANTITIES:
        symbol, unit = argument(quantity.symbol), argument(quantity.unit)
        yield f".It Em {quantity.name(ENGLISH)} No ({symbol}, {unit})"
        yield from sentences(quantity.definition)
        yield from sentences(_names(quantity))
        if remarks := [*_misnomers(quantity), *_leads(quantity)]:
            yield ".Bl -dash -compact"
            for remark in remarks:
                yield ".It"
                yield from sentences(remark)
            yield ".El"
    yield ".El"


def _names(quantity: Quantity) -> str:
    names = [f"also {name}" for name in quantity.names(ENGLISH)[1:]]
    names += [
        f"{LANGUAGE_NAMES[code]} {', '.join(quantity.names(code))}"
        for code in LANGUAGE_NAMES
        if quantity.names(code)
    ]
    return _sentence("; ".join(names))


def _sentence(words: str) -> str:
    return f"{words[:1].upper()}{words[1:]}." if words else ""


def _misnomers(quantity: Quantity) -> Iterator[str]:
    for terms, meant, why in MISNOMERS:
        if meant == quantity.symbol:
            yield f"{', '.join(terms)}: {why}"


def _leads(quantity: Quantity) -> Iterator[str]:
    """Return the quantities that one condition leads to, by the condition."""
    by_condition: dict[str, list[str]] = {}
    for other in QUANTITIES:
        try:
            plan(_unit(quantity), _unit(other), [])
        except MissingCondition as error:
            if len(error.missing) == 1 and _is_one_step(quantity, other):
                by_condition.setdefault(next(iter(error.missing)), []).append(other.name(ENGLISH))
        except RadcalcError:
            continue  # no condition leads there, or the quantity lacks a unit
    for what, names in by_condition.items():
        yield f"with {what}: {', '.join(names)}"


def _is_one_step(quantity: Quantity, other: Quantity) -> bool:
    """Return whether they differ by one step, even if W/m2 is both incident and emitted."""
    source, target = _unit(quantity), _unit(other)
    start, end = read(source), read(target)
    if start is None or end is None:
        return True
    if EXITANCE in (quantity.symbol[0], other.symbol[0]):
        if start.axis or end.axis:
            return False  # densities are not marked as leaving a surface
        if start.geometry != end.geometry:
            return start.kind == end.kind and start.time == end.time
        return start.kind == end.kind or source.is_exitance == target.is_exitance
    return start.kind == end.kind or start.geometry == end.geometry


def _unit(quantity: Quantity) -> Unit:
    """Return the usual unit; for an exitance, one of light that leaves a surface."""
    return target_of(quantity.name(ENGLISH))


def conditions(_: str) -> Iterator[str]:
    """Yield the missing conditions as worded in errors, and the options that supply them."""
    yield ".Bl -tag -width Ds -compact"
    for wanted in WANTED.values():
        yield f".It {wanted.phrase}"
        yield from sentences(spelled(wanted.hint) + ".")
    yield ".El"


def units(_: str) -> Iterator[str]:
    """Yield every named unit by quantity, units of light first."""
    measured: dict[str, list[Entry]] = {}
    for name in UNITS:
        listed = entry(name)
        measured.setdefault(listed.quantity or "other", []).append(listed)
    light = [name for name in LIGHT if name in measured]
    for quantity in dict.fromkeys([*light, *measured]):
        yield f".Ss {text(quantity[0].upper() + quantity[1:])}"
        yield from _entries(measured[quantity])


def scales(_: str) -> Iterator[str]:
    """Yield every scale, with its function."""
    yield from _entries(scale_entries(SCALES))


def _entries(entries: Sequence[Entry]) -> Iterator[str]:
    yield ".Bl -tag -width Ds -compact"
    for unit in entries:
        comma = "" if unit.symbols.startswith("(") else ","
        symbols = f" No {comma} {argument(unit.symbols)}" if unit.symbols else ""
        yield f".It Li {argument(unit.name)}{symbols}".replace(" No ,", " ,")
        source = f" [{unit.source}]" if unit.source else ""
        yield from sentences(f"{unit.definition}{source}")
        if unit.note:
            yield from sentences(f"(note: {unit.note})")
    yield ".El"


def prefixes(_: str) -> Iterator[str]:
    """Yield the prefixes with their symbols and powers of ten."""
    yield ".Bl -column quetta Micro 10^-30 -compact"
    for name, power in PREFIX_NAMES.items():
        symbols = ", ".join(symbol for symbol, of in PREFIX_SYMBOLS.items() if of == name)
        yield f".It {name} Ta {plain(symbols)} Ta 10\\(ha{text(str(power))}"
    yield ".El"
