"""Typical values, and the search for them by subject, by quantity, by unit, or near a value.

The values are in `data/typical.tsv`.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

from radcalc import errors
from radcalc.errors import command, quote
from radcalc.quantities.language import ENGLISH, LANGUAGES
from radcalc.quantities.light import name_of
from radcalc.quantities.names import QUANTITIES, data_rows
from radcalc.quantities.search import called, comparable, matching
from radcalc.units import Unit
from radcalc.units.numbers import Amount
from radcalc.units.reading import read_amount
from radcalc.units.scales import ScaleUnit, resolve_any

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


def words() -> tuple[str, ...]:
    """Return suggestions for searches: subjects and names of quantities, each as one word."""
    measured = {value.quantity for value in VALUES}
    quantities = [q for q in QUANTITIES if q.name(ENGLISH) in measured]
    return (
        *THINGS,
        *(q.name(language).replace(" ", "-") for language in LANGUAGES for q in quantities),
    )


def search(text: str) -> list[Typical]:
    """Find values by quantity, in any language, by unit, or by words; all for an empty text.

    The first of these with a match decides; a text that begins with a number finds the values
    nearest to it.
    """
    text = text.strip()
    if not text:
        return list(VALUES)
    matches = _near(text) or _of_quantity(text) or _in_unit(text)
    matches = matches or matching(text, VALUES, _names)
    matches = matches or matching(text, VALUES, lambda v: f"{v.note} {v.source}", str.__eq__)
    matches = matches or matching(text, VALUES, _names, _is_alike)
    if matches:
        return matches
    words = {word for v in VALUES for word in comparable(_names(v)).split()}
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


def _of_quantity(text: str) -> list[Typical]:
    meant = {f.quantity.name("en") for f in called(text)}
    return [value for value in VALUES if value.quantity in meant]


def _is_alike(word: str, typed: str) -> bool:
    """Return whether a word begins like the typed one, apart from the ending of a case."""
    return len(typed) > STEM and word.startswith(typed[: max(STEM, len(typed) - ENDING)])


def _in_unit(text: str) -> list[Typical]:
    try:
        unit = resolve_any(text)
    except errors.RadcalcError:
        return []
    if unit.is_scale:
        on_scale = [value for value in VALUES if value.unit == unit.text]
        if on_scale:
            return on_scale
    return [value for value in VALUES if value.measured.dimension == unit.dimension]


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
    known = [value for value in VALUES if value.measured.dimension == amount.unit.dimension]
    if known and not LEAST <= _size(amount) <= MOST:
        hint = "less" if _size(amount) > MOST else "more than 0"
        raise errors.UsageError(f"no typical value is near '{quote(text)}'", hint)
    is_of_day = _is_of_day(amount.unit)

    def order(value: Typical) -> tuple[bool, float, bool]:
        is_range = value.low != value.high
        return _is_of_day(value.measured) != is_of_day, _away(value, amount), is_range

    named = [value for value in VALUES if _is_named(value, amount)]
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
