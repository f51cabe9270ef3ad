"""The operands of a conversion, AMOUNT [connective] TARGET: alike for quoted and other words.

A line is divided at `to`, or at every place; the readings that fit are collected.  One is the
answer, and several are refused.  A reading fits if its units are of one quantity, or if a condition
links them.  An amount alone fits if its unit is one word, a quotient, or that of a quantity.
"""

from radcalc import errors
from radcalc.errors import quote
from radcalc.units import NUMBER, Unit
from radcalc.units.amounts import OPERATORS, STREAM_EXAMPLE
from radcalc.units.compiled import NAMES
from radcalc.units.grammar import ALSO, DIVIDERS, TO
from radcalc.units.numbers import DIGITS, SIGNS, SIGNS_OF_UNCERTAINTY, Amount
from radcalc.units.reading import (
    dimensions_of,
    read_amount,
    read_for,
    sum_meant,
    with_unit,
)
from radcalc.units.table import unit_of

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Sequence

    from radcalc.errors import Try
    from radcalc.units import Dimension

EXAMPLE = errors.call("convert", "100", "lx", "fc")
OF_LISTS = ",:"  # characters of a list or a range
PER = "per"
LABELS = ("ev", "nd", "dli", "ppfd", "ppf")  # before a number, their value


class Reading:
    """A reading of a line: the amount, the word after it or '', and the target or ''."""

    __slots__ = ("amount", "connective", "target", "unit")

    def __init__(
        self, amount: Amount, connective: str = "", target: str = "", unit: Unit | None = None
    ) -> None:
        self.amount, self.connective = amount, connective
        self.target, self.unit = target, unit

    @property
    def is_of_one_quantity(self) -> bool:
        source = self.amount.typed[1]
        return bool(source and self.unit and source.dimension == self.unit.dimension)

    @property
    def is_linked(self) -> bool:
        """Return whether a law links the two units, or a condition, which may be missing."""
        from radcalc.conversion.plan import plan, source_of

        source = self.amount.typed[1]
        if source is None or self.unit is None:
            return False
        try:
            plan(source_of(self.amount, self.unit) or source, self.unit)
        except errors.MissingCondition:
            return True
        except errors.RadcalcError:
            return False
        return True

    @property
    def call(self) -> "Try":
        """The call that has this reading alone."""
        to = ["to", self.target] if self.target else []
        return errors.call("convert", self.amount.text, *to)


def read_operands(words: list[str]) -> tuple[Amount, str]:
    """Return the value with its unit, and the text of the target ('' if there is none).

    Raises SeveralReadings, with the call of each, if more than one fits.
    """
    parts = parts_of(words)
    found = unit_first(parts)
    if not found and 0 < len(parts) <= errors.WORDS and is_divisible(parts, words):
        found = readings(parts) or (_to_name(parts) if len(words) == 1 else [])
    if len(found) > 1:
        problem = f"'{quote(' '.join(parts))}' has {len(found)} readings"
        raise errors.SeveralReadings(problem, [one.call for one in found])
    if found:
        return found[0].amount, found[0].target
    try:
        return _read_operands(words)
    except errors.RadcalcError:
        for end in range(len(words), 1, -1):  # 5 ft 3 in m, 5ft 3in m
            if not (end > 3 or all(word[:1].isdigit() for word in words[:end])):
                continue
            if meant := sum_meant(" ".join(words[:end])):
                typed = quote(" ".join(words[:end]))
                hint = errors.computed(errors.call("convert", meant, *words[end:]))
                raise errors.UsageError(f"'{typed}' has several numbers", hint) from None
        raise


def is_conversion(words: list[str]) -> bool:
    """Return whether words are an amount, also with the unit to convert it to, and no more."""
    try:
        amount, target = read_operands(words)
    except errors.RadcalcError:
        return False
    return amount.typed[1] is not None and (not target or _target(target) is not None)


def parts_of(words: "Sequence[str]") -> list[str]:
    """Return the parts of words at blanks; arithmetic in quotes is one part.

    Joining a part of it with other words would change its meaning: '1500 J/cm2*0.5' mol/m2.
    """
    first, *others = words or [""]
    rest = " ".join(others).split()
    is_one = bool(rest) and not {*first.split()}.isdisjoint(OPERATORS)
    if rest and " " in first and not is_one:
        try:
            is_one = read_amount(first).rounding is not None
        except errors.RadcalcError:
            is_one = False
    parts = [first, *rest] if is_one else [*first.split(), *rest]
    parts = [part[:-1] if part[-1] == "." and part[:-1].isalpha() else part for part in parts]
    return _with_magnitudes(parts) if any("mag" in part for part in parts) else parts


def _with_magnitudes(parts: list[str]) -> list[str]:
    """Return parts in which a magnitude of a band is one: V mag, whose V is not a volt."""
    from radcalc.units.scale_table import OF_BANDS

    joined: list[str] = []
    while parts:
        counts = (3, 2, 1)
        count = next(n for n in counts if n == 1 or " ".join(parts[:n]) in OF_BANDS)
        joined.append(" ".join(parts[:count]))
        parts = parts[count:]
    return joined


def is_divisible(parts: "Sequence[str]", words: "Sequence[str]") -> bool:
    """Return whether a line is divided by its units: not at `to`, and not in arithmetic."""
    if not all(map(str.strip, words)):
        return False
    if {*parts} & {*TO} or parts[-1] == "-" or " " in parts[0]:
        return False
    if len(words) > 1 and {*parts} & {*OPERATORS}:  # quotes are missing
        return False
    text = " ".join(words)
    return not any(sign in text for sign in SIGNS_OF_UNCERTAINTY)


def readings(parts: "Sequence[str]") -> list[Reading]:
    """Return the readings that fit of a line without `to`, by its parts at blanks."""
    found = [one for at in range(len(parts) - 1, 0, -1) for one in _divided_at(parts, at)]
    of_one = [one for one in found if one.is_of_one_quantity]
    if of_one:  # 5 W as J may also be 5 W in J, and 4 m2 / 2 m2 is a ratio
        others = [one for one in found if one.connective and one not in of_one]
        return of_one + [one for one in others if one.is_linked] + _ratio(parts)
    whole = _alone(parts)
    if whole is None and len(found) == 1:
        return found
    linked = [one for one in found if one.is_linked]
    if whole and (not linked or DIVIDERS.keys() & {*parts}):
        linked.append(whole)
    return linked


def _ratio(parts: "Sequence[str]") -> list[Reading]:
    """Return the reading of arithmetic whose last number may have the unit after it."""
    *before, number, _ = parts
    for sign in OPERATORS:
        number = number.rpartition(sign)[2]
    is_bare = number.strip("()").replace(".", "", 1).isdigit()
    whole = (
        _amount(f"({' '.join(parts)})") if before and is_bare else None
    )  # has this reading alone
    if whole is None:
        return []
    from radcalc.quantities import name_of

    unit = whole.typed[1]
    return [Reading(whole)] if unit is None or name_of(unit) else []


def unit_first(parts: "Sequence[str]") -> list[Reading]:
    """Return the readings of UNIT NUMBER [connective] UNIT: lux 500 to fc, mag 6 lux.

    The unit after a connective is the target; without one, the number may be of either unit.
    """
    if len(parts) < 3 or parts[0].lower() in (*LABELS, "1") or not parts[1][:1].isdigit():
        return []
    if not _target(parts[0]):
        return []
    is_bound = parts[2] in (*TO, *ALSO)
    rest = " ".join(parts[2 + is_bound :])
    ways = [(parts[0], rest), (rest, parts[0])][: 1 if is_bound else 2]
    found = []
    for source, target in ways:
        amount, unit = _amount(f"{parts[1]} {source}", target), rest and _target(target)
        if amount and unit:
            found.append(Reading(amount, "", target, unit))
    return [one for one in found if one.is_of_one_quantity or one.is_linked]


def _divided_at(parts: "Sequence[str]", at: int) -> list[Reading]:
    """Return the readings with the target after a place, or after the connective there."""
    *before, last = parts[:at]
    if len(before) > 1 and last in ALSO and not unit_of(" ".join([*before[1:], last])):
        return []  # 100 lx in
    found = []
    for skipped in (1, 0) if parts[at] in ALSO and parts[at + 1 :] else (0,):
        target = " ".join(parts[at + skipped :])
        if unit := _target(target):
            amount = _amount(" ".join(parts[:at]), target)
            if amount and amount.unit:
                found.append(Reading(amount, parts[at] if skipped else "", target, unit))
    return found


def _to_name(parts: "Sequence[str]") -> list[Reading]:
    """Return the reading with the name of a quantity as the target: 5 lx luminance."""
    from radcalc.quantities.search import is_name

    for at in range(len(parts) - 1, 0, -1):
        amount, name = _amount(" ".join(parts[:at])), " ".join(parts[at:])
        if amount and amount.typed[1] and is_name(name):
            return [Reading(amount, "", name)]
    return []


def _target(text: str) -> Unit | None:
    """Return the unit of a target; that of several words is a quotient, or a name."""
    first, *others = text.split()
    if first == PER or first[0] == "/":  # the end of a unit
        return None
    is_quotient = PER in others or all("-" in part and "/" not in part for part in others)
    if not is_quotient and text.lower().replace(" ", "_") not in NAMES:
        return unit_of(text) if DIVIDERS.keys() & {*others} else None
    if unit := unit_of(text):
        return unit
    from radcalc.units import table
    from radcalc.units.values import find_scale

    return find_scale(text) or (
        table.growers_unit(text) if text.lower() in table.GROWERS_WORDS else None
    )


def _amount(text: str, target: str = "") -> Amount | None:
    """Return the amount of a text, or None."""
    try:
        return read_for(text, target)
    except errors.RadcalcError:
        return None


def _alone(parts: "Sequence[str]") -> Reading | None:
    """Return the reading of a line as an amount: 5 lm s, not 532 nm cm-1."""
    amount = _amount(" ".join(parts))
    unit = amount.typed[1] if amount else None
    if amount is None or unit is None:
        return None
    if " " in unit.text and unit.is_scale:  # dBu W
        return None
    if " " in _without_per(unit.text):
        from radcalc.quantities import name_of

        if unit.dimension == NUMBER or not name_of(unit):
            return None
    return Reading(amount)


def _without_per(text: str) -> str:
    """Return the text of a unit with / for each word that divides, without blanks around it."""
    words = ["/" if word in (PER, *DIVIDERS) else word for word in text.split()]
    return " ".join(words).replace(" /", "/").replace("/ ", "/")


def _read_operands(words: list[str]) -> tuple[Amount, str]:
    """Return the amount and the target of the words, '' if they have none."""
    if not words:
        raise errors.UsageError("a value is missing", EXAMPLE)
    if words[1:] and words[-1] in ("-", "="):
        shell = "'to' instead, or '->' in quotes: without them > is the shell's"
        alone = errors.correct(" ".join(words), *words[:-1], remark="'->' needs quotes")
        raise errors.UsageError(f"a unit is missing after '{words[-1]}'", shell, [alone])
    try:
        amount, separator, rest = read_value(words)
    except errors.ExpressionError:
        target = sides(words)[2] or "".join(words[1:][-1:])
        if not (dimensions := dimensions_of(target)):
            raise
        amount, separator, rest = read_value(words, dimensions)
    if separator and not rest:
        alone = errors.correct(" ".join(words), *words[:-1])
        raise errors.UsageError(f"a unit is missing after '{separator}'", alone)
    if amount.unit is None:
        amount, rest = _with_next_unit(words, amount, separator, rest)
    if amount.unit is None:
        is_plain = words[0].replace(".", "").isalnum()
        others = ("lx", "fc") if is_plain else ("to", "1")
        hint: errors.Hint = errors.call("convert", words[0], *others)
        if any(char.isdigit() for char in "".join(words[1:])):  # which the call would drop
            hint = "a unit after the number"
        raise errors.UsageError(f"the unit of '{quote(words[0])}' is missing", hint)
    if rest and not rest[0].strip():
        raise errors.UsageError("the unit to convert to is missing", EXAMPLE)
    if len(rest) > 1:
        _, typed = amount.typed
        raise _too_many(words, [typed.text if typed else "", *rest])
    return amount, rest[0] if rest else ""


def _with_next_unit(
    words: list[str], amount: Amount, separator: str, rest: list[str]
) -> tuple[Amount, list[str]]:
    """Return a bare number with the unit in the word after it, if any, and the further words."""
    if separator:
        return (with_unit(amount, "1") if _is_of_numbers(rest[0]) else amount), rest
    if rest and rest[0] in OPERATORS:
        raise _too_many(words, words)
    if rest and rest[0].strip():
        return with_unit(amount, rest[0].strip()), rest[1:]
    return amount, rest


def read_value(
    words: list[str], dimensions: "Sequence[Dimension]" = ()
) -> tuple[Amount, str, list[str]]:
    """Return the value, the separator after it or '', and the words after both.

    The dimensions that are asked for decide between two readings of an expression.  The first
    word after the value may be the unit of a bare number, if there is no separator.
    """
    text = " ".join(words)
    if any(mark in text for mark in SIGNS_OF_UNCERTAINTY):
        from radcalc.units.uncertain import join_words

        words = join_words(words)
    source, separator, target = sides(words)
    if separator:
        return read_amount(source, dimensions), separator, [target] if target else []
    return read_amount(words[0], dimensions), "", words[1:]


def read_stream_operands(words: list[str]) -> tuple[str, str]:
    """Return the units of `- UNIT [to] TARGET`; the first is '' if lines have their own unit."""
    if words.count("-") > 1:
        raise errors.UsageError(
            "'-' is given more than once: there is one standard input", STREAM_EXAMPLE
        )
    source, separator, target = sides(words[1:], is_stream=True)
    units = [source, target] if separator else words[1:]
    if not units or not all(unit.strip() for unit in units[bool(separator) :]):
        raise errors.UsageError("a unit to convert to is missing", STREAM_EXAMPLE)
    if len(units) > 2:
        found = readings(["1", *units])
        source_unit = found[0].amount.typed[1] if len(found) == 1 and found[0].target else None
        if source_unit is None:
            raise _too_many(units, units, is_stream=True)
        units = [source_unit.text, found[0].target]
    return (units[0] if len(units) > 1 else ""), units[-1]


def sides(words: list[str], is_stream: bool = False) -> tuple[str, str, str]:
    """Split the words at the separator: source, separator and target, all '' without one.

    `5 in in cm` has an inch and a separator, `100 in cm` and `100 cm in` have inches only.
    """
    parts = " ".join(words).split()
    places = [place for place, part in enumerate(parts) if part in TO]
    if not places and (len(words) == 1 or any(word in ALSO for word in words)):
        last = max((i for i, part in enumerate(parts[:-1]) if part in ALSO), default=0)
        if last and (parts[last + 1][0] in "(°%" or parts[last + 1][0].isalpha()):
            places = [last] if is_stream or _has_unit(" ".join(parts[:last])) else []
    if not places:
        return "", "", ""
    at, *others = places
    if others:
        again = parts[others[0]]
        raise errors.UsageError(
            f"the word {again} is given more than once"
            if again == parts[at]
            else f"{parts[at]} and {again} both separate units",
            STREAM_EXAMPLE if is_stream else EXAMPLE,
        )
    return " ".join(parts[:at]), parts[at], " ".join(parts[at + 1 :])


def _is_of_numbers(text: str) -> bool:
    """Return whether a unit or a scale is of bare numbers: 1, % or dB."""
    return dimensions_of(text) == (NUMBER,)


def _has_unit(text: str) -> bool:
    """Return whether a value has a unit, which may be unknown."""
    try:
        return read_amount(text).unit is not None
    except errors.RadcalcError as error:
        return isinstance(error, errors.ExpressionError) or not isinstance(
            error, errors.NumberError
        )


def _too_many(words: list[str], units: list[str], is_stream: bool = False) -> errors.TooManyWords:
    """Return the error for words after the units; propose the divisions that fit."""
    _, second, *others = units
    if second.lower() in TO + ALSO and others:
        return errors.TooManyWords(
            f"'{quote(second)}' does not separate units",
            errors.correct(f"{second} {others[0]}", f"to {others[0]}"),
        )
    problem = f"too many words: '{quote(' '.join(units))}'"
    if any(word in OPERATORS for word in units):
        whole, last = " ".join(words), words[-1]
        calculated = [
            errors.correct(whole, whole),
            errors.correct(whole, whole.removesuffix(f" {last}"), last),
        ]
        return errors.TooManyWords(problem, "quotes around a value that is calculated", calculated)
    return errors.TooManyWords(problem, lambda: _of_targets(units, is_stream))


def _of_targets(units: list[str], is_stream: bool) -> "list[Try]":
    """Propose several targets as a list, and each alone; a stream has one, of the same quantity."""
    source, *targets = units
    ends = targets if is_stream else [",".join(targets), *targets]
    ends = [end for end in ends if not is_stream or _are_alike(source, end)]
    return [errors.correct(" ".join(units), source, end) for end in ends]


def _are_alike(start: str, end: str) -> bool:
    first, second = unit_of(start), unit_of(end)
    return first is not None and second is not None and first.dimension == second.dimension


def read_lists(words: list[str]) -> list[list[list[str]]]:
    """Return the words of each conversion that lists in VALUE and TARGET request, by value."""
    text = " ".join(words)
    if not any(mark in text for mark in OF_LISTS):
        return [[words]]
    from itertools import pairwise

    from radcalc.units.ranges import read_values, refuse_commas, refuse_many

    source, separator, target = sides(words)
    if separator:
        values, between, targets = read_values(source), [separator], _targets(target)
        refuse_commas(source, values)
    else:
        for word, next_word in pairwise(words):
            if word.endswith(","):
                problem = f"'{quote(word)} {quote(next_word)}' has a blank in its list"
                better = errors.correct(f"{word} {next_word}", _without_blank(word, next_word))
                raise errors.ConditionError(problem, better)
        values, between = read_values(words[0]), words[1:-1]
        refuse_commas(words[0], values, *words[1:2])
        targets = _targets(words[-1]) if len(words) > 1 else []
    refuse_many([len(values), len(targets)])
    ends = [[target] for target in targets] or [[]]
    return [[[value, *between, *end] for end in ends] for value in values]


def _without_blank(word: str, behind: str) -> str:
    """Return the intended list if a blank after a comma splits off a value, target or unit."""
    from radcalc.units.ranges import unit_in

    numeric = tuple(f"{DIGITS}{SIGNS}.(")
    if behind.startswith(numeric) or not word.startswith(numeric):
        return word + behind
    values = word.rstrip(",").split(",")
    return ",".join(values if unit_in(values[0]) else [value + behind for value in values])


def _targets(text: str) -> list[str]:
    targets = [target.strip() for target in text.split(",")]
    if len(targets) > 1 and not all(targets):
        there = ",".join(filter(None, targets)) or "lx,fc"
        problem = f"a unit is missing in the list '{quote(text)}'"
        raise errors.ConditionError(problem, errors.correct(text, there))
    return targets
