"""Lists to look things up in: units and constants, typical values, and tasks.

An entry of `radcalc units` is a unit or a constant, with its quantity, definition and source.  A
search is for the name of a quantity, as in `radcalc quantities`, or for a unit.

Typical values are searched by subject, by quantity, by unit, or near a value; they are in
`data/typical.tsv`.

The tasks of `radcalc examples` and of radcalc-examples(7) are in `examples.md`.
"""

import math
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path

from radcalc import errors
from radcalc.errors import UnitError, UsageError, command, corrections, nearest, quote
from radcalc.quantities import EXITANCES, describe, is_per_length, name_of, read
from radcalc.quantities.language import ENGLISH, LANGUAGES
from radcalc.quantities.names import QUANTITIES, composed, data_rows, named
from radcalc.quantities.search import called, comparable, matching
from radcalc.terminal import HANGING, fold
from radcalc.tuples import NamedTuple
from radcalc.units import OWN, Unit
from radcalc.units.catalogue import CATALOGUE
from radcalc.units.catalogue import CONSTANTS as CATALOGUE_OF_CONSTANTS
from radcalc.units.compiled import CONSTANTS, NAMES, NOTES, PREFIX_NAMES, PREFIX_SYMBOLS, UNITS
from radcalc.units.numbers import Amount
from radcalc.units.reading import read_amount
from radcalc.units.scale_table import SCALES, Scale, usual
from radcalc.units.table import resolve
from radcalc.units.values import ScaleUnit, find_scale, on, resolve_any
from radcalc.units.values import unit as unit_of_constants

SHORT = 3  # letters of a part of a name that begins a word


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
        if text in symbols or (len(folded) != 1 and _is_in(folded, names))
    ]


def _is_in(text: str, names: Iterable[str]) -> bool:
    """Return whether a name has a text, a short one at the start of a word: ampere has no mpe."""
    sought = text if len(text) > SHORT else f"_{text}"
    return any(sought in f"_{name}" for name in names)


def search_units(text: str) -> list[Entry]:
    """Find units by name, quantity, part of a name or a unit of their quantity, in that order."""
    text = text.strip()
    if not text:
        return [entry(name) for name in UNITS] + scales(SCALES) + constants()
    if text.lower() in ("scale", "scales"):
        return scales(SCALES)
    if text.lower() in ("constant", "constants"):
        return constants()
    if scale := find_scale(text):
        return scales(reading.scale for reading in (scale, *scale.others))
    if text.lower().replace("-", "_") in NAMES:
        return _of_name(text)
    return _of_quantities(text) or _of_name(text) or _of_unit(text)


def _of_quantities(text: str) -> list[Entry]:
    from radcalc.quantities.search import index, with_words

    measured = [(f.quantity.name(ENGLISH), resolve(f.quantity.unit), f.note) for f in called(text)]
    if not measured and (other := index().others.get(comparable(text))):
        measured = [(other.names[0], other.unit, "")]
    if not measured:
        measured = [(q.name(ENGLISH), resolve(q.unit), "") for q in with_words(text)]
    entries: dict[tuple[str, str], Entry] = {}
    for name, unit, note in measured:
        for listed in _units_of_quantity(name, unit) or [product(unit.text, name)]:
            entries.setdefault(
                (listed.name, listed.quantity), listed._replace(note=listed.note or note)
            )
    return list(entries.values())


def _units_of_quantity(quantity: str, unit: Unit) -> list[Entry]:
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
    part = [n for n in UNITS if n not in exact and _is_in(folded, CATALOGUE[n][1])]
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


THINGS = (
    *("sun", "sky", "overcast", "shade", "twilight", "moon", "starlight", "cloud", "UV"),
    *("office", "classroom", "corridor", "home", "street", "photo"),
    *("candle", "lamp", "bulb", "LED", "fluorescent", "headlight", "torch", "laser"),
    *("screen", "monitor", "cinema", "HDR", "plants", "lettuce", "tomatoes", "vision"),
    *("slunce", "obloha", "oblačno", "soumrak", "měsíc", "hvězdy", "kancelář", "učebna"),
    *("ulice", "svíčka", "žárovka", "zářivka", "světlomet", "svítilna", "obrazovka", "rostliny"),
    *("солнце", "небо", "пасмурно", "сумерки", "луна", "звёзды", "офис", "класс"),
    *("улица", "свеча", "лампа", "фара", "фонарик", "лазер", "экран", "растения"),
)
FIELDS = ("what", "quantity", "value", "unit", "source", "note")  # of a value in a list
BOUNDS = ("low", "high")
NEAREST = 7  # values shown near a given one
LEAST, MOST = 1e-99, 1e99  # sizes to look near
FAR = 10.0  # ratio above which a value is not near
ENDING = 2  # letters of a word that declension may change, in Czech and Russian
STEM = 4  # letters that do not change


class Typical(NamedTuple):
    """A value in a unit: a number, or a range such as `0.1 to 0.3`.

    `names` are those of its subject in English, Czech and Russian; `also` has other search words.
    """

    names: Sequence[str]
    value: str
    unit: str
    source: str
    note: str = ""
    also: str = ""

    @property
    def what(self) -> str:
        return self.names[0]

    def name(self, language: str) -> str:
        return self.names[LANGUAGES.index(language)]

    @property
    def low(self) -> float:
        return float(self.value.partition(" to ")[0])

    @property
    def high(self) -> float:
        return float(self.value.rpartition(" to ")[2])

    @property
    def measured(self) -> Unit:
        return resolve_any(self.unit)

    @property
    def quantity(self) -> str:
        """The English name of the quantity of its unit."""
        return name_of(self.measured)


VALUES = tuple([Typical(row[:3], *row[3:]) for row in data_rows("typical")])


def values() -> tuple[Typical, ...]:
    """Return the typical values, and the constants and reflectances of the user's definitions."""
    own = []
    for name in OWN:
        if name in CONSTANTS:
            _, _, text, source = CATALOGUE_OF_CONSTANTS[name]
            number, unit = read_amount(text).typed
            of_unit = unit.text if unit else "1"
            own.append(Typical((name,) * len(LANGUAGES), f"{number:.12g}", of_unit, source))
    return (*VALUES, *own)


def words_of_typical() -> tuple[str, ...]:
    """Return suggestions for searches: subjects and names of quantities, each as one word."""
    measured = {value.quantity for value in values()}
    quantities = [q for q in QUANTITIES if q.name(ENGLISH) in measured]
    return (
        *(name for name in OWN if name in CONSTANTS),
        *THINGS,
        *(q.name(language).replace(" ", "-") for language in LANGUAGES for q in quantities),
    )


def search_typical(text: str) -> list[Typical]:
    """Find values by quantity, in any language, by unit, or by words; all for an empty text.

    The first of these with a match decides; a text that begins with a number finds the values
    nearest to it.
    """
    text = text.strip()
    if not text:
        return list(values())
    matches = _near(text) or _values_of_quantity(text) or _in_unit(text)
    matches = matches or matching(text, values(), _names)
    matches = matches or matching(text, values(), lambda v: f"{v.note} {v.source}", str.__eq__)
    matches = matches or matching(text, values(), _names, _is_alike)
    if matches:
        return matches
    words = {word for v in values() for word in comparable(_names(v)).split()}
    near = errors.nearest(comparable(text), words, cutoff=0.75)
    raise errors.UsageError(
        f"no typical value for '{quote(text)}'",
        errors.corrections(text, *near) or f"{command('typical')}, which lists them all",
    )


def is_seen(text: str) -> bool:
    """Return whether words are in the name of a thing with a typical value: full moon."""
    return bool(matching(text, VALUES, _names))


def _names(value: Typical) -> str:
    return " ".join((*value.names, value.quantity, value.unit, value.also))


def _values_of_quantity(text: str) -> list[Typical]:
    meant = {f.quantity.name("en") for f in called(text)}
    return [value for value in values() if value.quantity in meant]


def _is_alike(word: str, typed: str) -> bool:
    """Return whether a word begins like the typed one, apart from the ending of a case."""
    return len(typed) > STEM and word.startswith(typed[: max(STEM, len(typed) - ENDING)])


def _in_unit(text: str) -> list[Typical]:
    try:
        unit = resolve_any(text)
    except errors.RadcalcError:
        return []
    if unit.is_scale:
        on_scale = [value for value in values() if value.unit == unit.text]
        if on_scale:
            return on_scale
    return [value for value in values() if value.measured.dimension == unit.dimension]


def how_far(text: str, values: list[Typical]) -> str:
    """Return a remark if a given value is far from all values found, else ''."""
    amount = _amount(text.strip())
    if not amount or any(_is_named(value, amount) for value in values):
        return ""
    away = min(_away(value, amount) for value in values)
    if away < math.log(FAR):
        return ""
    return (
        f"even the nearest of these differs from {quote(text.strip())} by a factor of "
        f"{math.exp(away):.2g}"
    )


def _amount(text: str) -> Amount | None:
    """Return the amount to search near; None for a word or a number without a unit."""
    try:
        amount = read_amount(text)
    except errors.NumberError:
        if text[:1].isdigit():
            raise
        return None
    except errors.RadcalcError:
        return None
    return amount if amount.unit else None


def _near(text: str) -> list[Typical]:
    """Return the values with an amount in their names, and the values nearest to it by ratio.

    At equal distance an exact value precedes a range.  Sums over a day come after values of a
    moment, or before them if the amount is such a sum.  None for a word.
    """
    amount = _amount(text)
    if amount is None or amount.unit is None:
        return []
    known = [value for value in values() if value.measured.dimension == amount.unit.dimension]
    if known and not LEAST <= _size(amount) <= MOST:
        hint = "less" if _size(amount) > MOST else "more than 0"
        raise errors.UsageError(f"no typical value is near '{quote(text)}'", hint)
    is_of_day = _is_of_day(amount.unit)

    def order(value: Typical) -> tuple[bool, float, bool]:
        is_range = value.low != value.high
        return _is_of_day(value.measured) != is_of_day, _away(value, amount), is_range

    named = [value for value in values() if _is_named(value, amount)]
    near = [value for value in sorted(known, key=order) if value not in named]
    return [*named, *near[:NEAREST]]


def _is_named(value: Typical, amount: Amount) -> bool:
    """Return whether a value has an amount in its name, as a bulb of 60 W has."""
    typed = f"{amount.number:g} {amount.unit.text if amount.unit else ''}"
    return bool(matching(typed, (value,), lambda value: value.what, str.__eq__))


def _is_of_day(unit: Unit) -> bool:
    return any(name == "day" for name, _ in unit.atoms)


def _size(amount: Amount) -> float:
    return amount.number * float(amount.unit.factor) if amount.unit else 0.0


def _away(value: Typical, amount: Amount) -> float:
    size = _size(amount)
    low, high = (_in_si(value, end) for end in (value.low, value.high))
    return max(math.log(low / size), math.log(size / high), 0.0)


def _in_si(value: Typical, number: float) -> float:
    unit = value.measured
    if isinstance(unit, ScaleUnit):
        return float(unit.quantity(number) * unit.unit.factor)
    return float(number * unit.factor)


FILE = Path(__file__).parent / "examples.md"
TRADE, TITLE, CALL = "# ", "## ", "$ "
BEGIN, END = "```console", "```"
WIDTH = 80  # of paragraphs in plain text

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from typing import TypeAlias

    Narrowed: TypeAlias = Callable[[str, int], Iterable[str]]


class Call(NamedTuple):
    """A command, as it is typed, and the lines that it prints."""

    command: str
    output: tuple[str, ...]


class Task(NamedTuple):
    """A question with its calls, and how to read the answer."""

    trade: str
    title: str
    question: str
    calls: tuple[Call, ...]
    reading: str

    @property
    def command(self) -> str:
        """The first call of radcalc."""
        return next(call.command for call in self.calls if "radcalc " in call.command)

    @property
    def words(self) -> str:
        """The text for searches: everything except the output."""
        commands = [call.command for call in self.calls]
        return " ".join([self.trade, self.title, self.question, *commands, self.reading])

    def __str__(self) -> str:
        """Return the whole task as plain text."""
        return "\n".join(self.lines())

    def lines(self, width: int = 0, narrowed: "Narrowed | None" = None) -> "Iterator[str]":
        """Yield the title, and indented the question, the calls with their output, the reading.

        With a width, `narrowed` folds the calls; without one, only paragraphs are folded.
        """
        yield f"{self.trade}: {self.title}"
        yield from fold(f"  {self.question}", width or WIDTH)
        yield ""
        for call in self.calls:
            typed = f"    {CALL}{call.command}"
            yield from narrowed(typed, width) if narrowed else [typed]
            for printed in call.output:
                line = f"    {printed}".rstrip()
                yield from fold(line, width, HANGING) if width else [line]
        yield ""
        yield from fold(f"  {self.reading}", width or WIDTH)


@cache
def tasks() -> tuple[Task, ...]:
    """Read the tasks in the order of the page."""
    return tuple(
        _task(trade.strip(), section)
        for part in f"\n\n{FILE.read_text(encoding='utf-8')}".split(f"\n\n{TRADE}")[1:]
        for trade, *sections in [part.split(f"\n\n{TITLE}")]
        for section in sections
    )


def _task(trade: str, section: str) -> Task:
    title, _, body = section.partition("\n")
    question, _, rest = body.partition(BEGIN)
    display, _, reading = rest.partition(f"\n{END}\n")
    calls = []
    for entry in f"{display}\n".split(f"\n{CALL}")[1:]:
        command, *output = entry.removesuffix("\n").split("\n")
        calls.append(Call(command, tuple(output)))
    return Task(trade, title, _joined(question), tuple(calls), _joined(reading))


def _joined(paragraph: str) -> str:
    return " ".join(paragraph.split())


def words_of_tasks() -> tuple[str, ...]:
    """Return suggestions for searches: the words of trades and titles."""
    texts = [f"{task.trade} {task.title}" for task in tasks()]
    found = [word for text in texts for word in comparable(text).split() if len(word) > 2]
    return tuple(dict.fromkeys(found))


def search_tasks(text: str) -> list[Task]:
    """Return the tasks that have, for every word of a text, a word that begins so.

    Examples
    --------
    >>> [task.title for task in search_tasks("museum log")]
    ['A log']
    """
    if not text.strip():
        return [*tasks()]
    found = matching(text, tasks(), lambda task: task.words)
    if found:
        return found
    known = {word for task in tasks() for word in comparable(task.words).split() if word.isalnum()}
    unknown = next((word for word in text.split() if comparable(word) not in known), "")
    near = nearest(comparable(unknown), known, cutoff=0.75) if unknown else []
    trades = dict.fromkeys(task.trade.split()[0].lower() for task in tasks())
    raise UsageError(
        f"no example mentions '{quote(text)}'",
        corrections(unknown, *near) or f"one of these words: {', '.join(trades)}",
    )
