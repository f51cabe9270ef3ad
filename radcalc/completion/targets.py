"""Operands of a conversion: units, and those that the source's quantity reaches."""

from radcalc.completion.table import NAMES
from radcalc.completion.table import UNITS as MEASURES
from radcalc.completion.words import Completion, split_number
from radcalc.conversion.geometric import CONDITIONS
from radcalc.conversion.operands import read_lists, read_value, sides
from radcalc.conversion.plan import plan
from radcalc.errors import MissingCondition, RadcalcError, mentioned, spell
from radcalc.inputs import Input
from radcalc.inputs.reading import read, split_values
from radcalc.quantities import is_per_length, name_of
from radcalc.quantities.names import full_name, offered
from radcalc.quantities.symbols import FLAG, LIGHT_UNITS, QUANTITY, SYMBOLS
from radcalc.units import Exitance, Unit
from radcalc.units.compiled import NAMES as SPELLINGS
from radcalc.units.compiled import UNITS
from radcalc.units.reading import with_unit
from radcalc.units.scale_table import SCALES
from radcalc.units.table import resolve, unit_of
from radcalc.units.values import resolve_any

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

# The last parts of compound units, after a stroke and in other products.
BELOW = ("m2", "sr", "s", "cm2", "mm2", "ft2", "in2", "nm", "um", "Hz", "THz", "m", "h", "day", "W")
BESIDE = ("m-2", "sr-1", "s-1", "cm-2", "nm-1", "um-1", "Hz-1", "sr", "s", "h")
AXES = ("/nm", "/um", "/Hz", "/THz", "/cm-1", "/eV")  # in densities
USUAL = [text.replace(" ", ".") for units, _ in LIGHT_UNITS.values() for text in units]
USUAL.append("td")
# Light at work is asked for more often than energy and exposure.
LIKELY = {
    text.replace(" ", ".")
    for (is_over_time, _, _), (units, _) in LIGHT_UNITS.items()
    if not is_over_time
    for text in units
}
TYPING = "x"  # stands for the word being typed


class Alone:
    """Conditions by name, without a value, which the user knows."""

    @staticmethod
    def option(name: str, value: str) -> str:
        return f"--{name}"


def operands(words: "Sequence[str]", given: "Mapping[str, str]", typed: str) -> list[Completion]:
    """Return every completion of an operand: a value with its unit, a unit, a target."""
    if not words:
        head, number, unit = split_number(typed)
        units = _units("", unit) if number and unit else []
        return [completion.after(head + number) for completion in units]
    source, has_separator, target_words = _read(words)
    if source is None:
        return _units("", typed) if len(words) == 1 else []
    if target_words and not has_separator:
        return []
    head = f"{' '.join(target_words)} " if target_words else ""
    before, comma, last = typed.rpartition(",")  # a list of targets
    targets = Reach(source, _conditions(given)).units(head, last)
    return [completion.after(before + comma) for completion in targets]


def lacking(words: "Sequence[str]", given: "Mapping[str, str]") -> tuple[str, ...]:
    """Return the symbols that a conversion lacks."""
    source, _, target_words = _read(words)
    target = unit_of(" ".join(target_words).rpartition(",")[2])  # only the last of a list
    if source and target:
        try:
            plan(source, target, _conditions(given))
        except MissingCondition as error:
            return mentioned(error.hint)
    return ()


def _read(words: "Sequence[str]") -> tuple[Unit | None, bool, "Sequence[str]"]:
    """Return the unit of VALUE UNIT, whether a separator follows it, and the words after it."""
    if words[0] == "-":
        before, separator, target = sides([*words[1:], TYPING], is_stream=True)
        if separator:
            return resolve_any(before), True, target.split()[:-1]
        return (resolve_any(words[1]) if words[1:] else None), False, words[2:]
    words = read_lists([*words, TYPING])[-1][-1]  # the last value of a list or a range
    amount, separator, later_words = read_value(words)
    if separator:
        return amount.typed[1], True, " ".join(later_words).split()[:-1]
    if amount.unit is None and later_words[1:]:
        amount, later_words = with_unit(amount, later_words[0]), later_words[1:]
    return amount.typed[1], False, later_words[:-1]


def _conditions(given: "Mapping[str, str]") -> list[Input]:
    conditions = []
    for option, text in given.items():
        name = option.lstrip("-")
        if name not in CONDITIONS:
            continue
        symbol = SYMBOLS[name]
        try:
            as_typed = split_values(name, text)[0] if symbol.form == QUANTITY else symbol.example
            conditions.append(read(name, symbol.form == FLAG or as_typed))
        except RadcalcError:
            conditions.append(read(name, symbol.example))
    return conditions


class Reach:
    """The units reached from a unit under the given conditions."""

    def __init__(self, source: Unit, given: "Sequence[Input]") -> None:
        self.source, self.given = source, given
        self.known: dict[tuple[object, ...], str | None] = {}

    def lacks(self, target: Unit) -> str | None:
        """Return the missing conditions, '' for none; None if no condition helps."""
        key = (target.dimension, target.is_exitance, target.has_wavelength, len(target.notes))
        if key not in self.known:
            self.known[key] = self._lacks(target)
        return self.known[key]

    def _lacks(self, target: Unit) -> str | None:
        try:
            plan(self.source, target, self.given)
        except MissingCondition as error:
            return spell(error.hint.partition(" (see ")[0], Alone)
        except RadcalcError:
            return None
        return ""

    def units(self, head: str, typed: str) -> list[Completion]:
        """Return units with this beginning: those in reach, then those that need a condition.

        Given conditions put the units of the source's own quantity, which need none, last.
        """
        reached, conditional, same_dimension = [], [], []
        seen = set() if self.source.is_scale else {frozenset(self.source.atoms)}
        for text in _texts(self.source, head, typed):
            unit = unit_of(head + text)
            if unit is None or is_per_length(unit) or frozenset(unit.atoms) in seen:
                continue
            seen.add(frozenset(unit.atoms))
            lack = self.lacks(unit)
            if lack:
                description = f"{name_of(unit)}, with {lack}"
                rank = text not in LIKELY, len(lack)
                conditional.append((rank, Completion(text, description)))
            elif lack == "":
                reached.append(Completion(text, full_name(unit)))
            elif self.given and unit.dimension == self.source.dimension:
                same_dimension.append(Completion(text, full_name(unit)))
        conditional.sort(key=lambda row: row[0])  # the usual units, the fewest conditions first
        reached += [] if head else self._scales(typed)
        return [
            *reached,
            *(completion for _, completion in conditional),
            *same_dimension,
            *self._names(head, typed),
        ]

    def _scales(self, typed: str) -> list[Completion]:
        """Return scales with this beginning: of the source's quantity or, once typed, in reach."""
        rows = [(text, self.lacks(unit), description) for text, unit, description in _scales(typed)]
        return [
            Completion(text, f"{description}, with {lack}" if lack else description)
            for text, lack, description in sorted(rows, key=lambda row: len(row[1] or ""))
            if text != self.source.text and (lack == "" or (typed and lack))
        ]

    def _names(self, head: str, typed: str) -> "Iterator[Completion]":
        """Return the names of quantities with this beginning in reach, with their units."""
        for name, (text, is_exitance) in NAMES.items():
            if head or not typed or not name.startswith(typed):
                continue
            if not text:
                lack = "" if self.source.is_light else None
            else:
                lack = self.lacks(resolve(text).of_class(Exitance if is_exitance else Unit))
            if lack is not None:
                description = text.replace(" ", ".") or "of the same kind of light"
                yield Completion(name, f"{description}, with {lack}" if lack else description)


def _units(head: str, typed: str) -> list[Completion]:
    known = [(text, unit_of(head + text)) for text in _texts(None, head, typed)]
    units = [Completion(text, full_name(unit)) for text, unit in known if unit and _is_known(unit)]
    return units + [
        Completion(text, description)
        for text, _, description in _scales(typed)
        if typed and not head
    ]


def _scales(typed: str) -> "Iterator[tuple[str, Unit, str]]":
    for scale in SCALES:
        for text in scale.spellings if typed else scale.spellings[:1]:
            if text.startswith(typed):
                yield text, resolve(scale.unit), scale.meaning


def _is_known(unit: Unit) -> bool:
    return bool(name_of(unit)) and not is_per_length(unit)


def _texts(source: Unit | None, head: str, typed: str) -> "Iterator[str]":
    """Return units with this beginning, the most usual first; `head` is the unit before."""
    if head:
        yield from (part for part in BESIDE if part.startswith(typed))
        return
    offered_texts = offered(source) if source else []
    if not typed:
        yield from (text for text in offered_texts if text not in SPELLINGS)
        yield from USUAL
        return
    yield from _spellings(offered_texts, typed)
    if len(typed) > 1:
        yield from (name for name in UNITS if name.startswith(typed.lower()))
    yield typed
    cut = max(typed.rfind(mark) for mark in "/.*\u00b7 (") + 1
    if cut:
        parts = BELOW if typed[cut - 1] == "/" else BESIDE
        yield from (typed[:cut] + part for part in parts if part.startswith(typed[cut:]))


def _spellings(offered_texts: "Sequence[str]", typed: str) -> "Iterator[str]":
    """Yield the units with this beginning, and densities of those typed in full."""
    style = "**" if "**" in typed else "^" if "^" in typed else ""
    measure_texts = [text for units in MEASURES.values() for text, _ in units]
    texts = sorted([*offered_texts, *USUAL, *measure_texts], key=lambda text: text in SPELLINGS)
    for text in dict.fromkeys(texts):
        text = _powers(text, style) if style else text
        if text.startswith(typed):
            yield text
        elif typed.startswith(text):
            yield from (text + axis for axis in AXES if (text + axis).startswith(typed))


def _powers(text: str, style: str) -> str:
    """Return a unit with its powers in another style: W/m^2."""
    letters = [
        style + letter if letter.isdigit() and before.isalpha() else letter
        for before, letter in zip(" " + text, text, strict=False)
    ]
    return "".join(letters)
