"""Reading of sentences: the phrases found in them, and what each of them fills."""

import os
import re
from functools import cached_property
from itertools import pairwise

from radcalc.calculators import SUMMARIES
from radcalc.conversion.operands import unit_first
from radcalc.errors import WORDS, RadcalcError, UsageError, input_of, is_wordy
from radcalc.quantities import RADIANT
from radcalc.quantities import read as read_light
from radcalc.quantities.language import LANGUAGES
from radcalc.quantities.search import called, comparable, index
from radcalc.quantities.symbols import QUANTITY, SPECIFIC, SYMBOLS
from radcalc.sentences import (
    ASPECT,
    ENGLISH_ALONE,
    Amount,
    Word,
    amount_at,
    amount_of,
    joined,
    literals,
    names,
    patterns,
    size_of,
    symbols_of,
    unit_in,
    words_of,
)
from radcalc.sentences.phrases import (
    AIR,
    AMOUNTS,
    COMMAND,
    FILLERS,
    LINE,
    LONE,
    MARKS,
    MORE_NEEDED,
    NOUNS,
    OF_THINGS,
    SHIFT,
    TARGET,
    THINGS,
    UNKNOWN,
)
from radcalc.tuples import NamedTuple
from radcalc.units import NUMBER, REFLECTANCES, Unit
from radcalc.units.dimensions import AREA, ENERGY, LENGTH
from radcalc.units.numbers import find_constant
from radcalc.units.reading import read_amount
from radcalc.units.table import PAR, PAR_RANGE, unit_of

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Container, Sequence

LONGEST_NAME = 5  # words
LONGEST = 2000  # characters
LONGEST_RANGE = 6  # words: from 380 nm to 780 nm
NUMBER_OF_RANGE = r"(\d+(?:\.\d+)?)"
RANGE = re.compile(
    f"(?:from )?{NUMBER_OF_RANGE} ?(nm|[uµμ]m)? ?(?:-|–|:|to|\\.\\.\\.?) ?"
    f"{NUMBER_OF_RANGE} ?(nm|[uµμ]m)"
)
GLUED = re.compile(r"([^\W\d_]{2,})(\.?\d\S*)")
DENSITY = re.compile(r"nd\d+(?:\.\d+)?", re.IGNORECASE)
COUNTS = ("luminaires",)  # 12 lamps, but lamps of 3000 lm
LAMPS_OF_LINES = ("led", "sodium", "mercury")  # the name of one beside its wavelength
SHORTEST_UNIT = 2  # letters: sp and rg are results
ASKED = frozenset(["f-number"])  # f-stop 1000 lux asks for one
NARROW = 10e-9  # m: a shorter one is the width of a line
OF_PHOTONS = 1e-9  # J: far above the energy of any photon of light
LARGEST_EV = 40  # the sun's disc has 34
MEAN = ("mean", "average")
PREPOSITIONS = ("in", "as", "a", "at")  # which are units, too
BEFORE_AMOUNT = ("of", "is", "=", ":", "at")  # between a name and its amount


class Fact(NamedTuple):
    """What a phrase fills: a symbol, or one of several, with the text of its value.

    `amount` is None for a text that is not an amount; a fact without symbols is an amount alone.
    """

    symbols: tuple[str, ...]
    text: str
    typed: str
    amount: Amount | None = None


class Goal(NamedTuple):
    """What a sentence asks for: the unit or the name of a result, or both."""

    text: str
    unit: Unit | None = None
    names: tuple[str, ...] = ()


class Sentence(NamedTuple):
    """A sentence that was read: its facts, its goals, its files and the words not understood.

    `ignored` are the words that add nothing, and `named` the things of `MORE_NEEDED`.  `also` is
    another reading, in which a name between two amounts has that behind it: 5 m radius 3 m.
    """

    facts: tuple[Fact, ...]
    goals: tuple[Goal, ...]
    files: tuple[str, ...]
    unknown: tuple[str, ...]
    text: str
    ignored: tuple[str, ...] = ()
    named: frozenset[str] = frozenset()
    also: "Sentence | None" = None

    def has(self, thing: str) -> bool:
        """Return whether a word of a thing that needs more was typed."""
        return thing in self.named

    def fillers(self, thing: str) -> list[str]:
        """Return the words of a thing that needs more, without those of phrases: 3 metre."""
        return [word for word in self.ignored if comparable(word) in MORE_NEEDED[thing]]


Found = tuple[int, "Fact | Goal | str | None"]  # the place after a phrase, and what it fills


def read(typed: "list[str]", inputs: "Sequence[str]" = ()) -> Sentence:
    """Read the words of a call, and its inputs NAME=VALUE; the longest phrase at a place counts."""
    found = _read(typed)
    given = tuple(map(_input, inputs))
    also = found.also and found.also._replace(facts=(*found.also.facts, *given))
    return found._replace(facts=(*found.facts, *given), also=also)


def _input(word: str) -> Fact:
    """Return the fact of an input NAME=VALUE."""
    name, text = input_of(word)
    amount = amount_of(text, 0) if SYMBOLS[name].form == QUANTITY else None
    return Fact((name,), text, f"{name} {text}".rstrip(), amount)


def _read(typed: "list[str]") -> Sentence:
    """Return the sentence of words, with its other reading; raise UsageError for too many."""
    text = " ".join(typed)
    if len(text) > LONGEST:
        raise UsageError(f"a sentence of {len(text)} characters is too long", f"at most {LONGEST}")
    if is_wordy(typed):
        raise UsageError(f"a sentence of {len(text.split())} words is too long", f"at most {WORDS}")
    words = _apart(words_of(typed))
    reading = _Reading(words, ENGLISH_ALONE)
    found = _found(text, reading)
    if found.unknown:
        reading = _Reading(words, LANGUAGES)
        found = _found(text, reading)
    if reading.has_between:
        return found._replace(also=_found(text, _Reading(words, LANGUAGES, is_forward=True)))
    parts = text.split()
    if unit_first(parts[:3]):  # lx 1000 cd 2 m, whose number may be of the first unit
        other = _apart(words_of([parts[1], parts[0], "to", *parts[2:]]))
        return found._replace(also=_found(text, _Reading(other, LANGUAGES)))
    return found


def _apart(words: list[Word]) -> list[Word]:
    """Return words with a known word apart from a number that is joined to it: iso100, GN58m."""
    apart: list[Word] = []
    for word in words:
        joint = GLUED.fullmatch(word.text)
        head = comparable(joint[1]) if joint else ""
        is_known = head in names(ENGLISH_ALONE) or head in literals()
        if joint and is_known and not _is_whole(word) and not DENSITY.fullmatch(word.text):
            apart += [Word(joint[1], head), Word(joint[2], joint[2], word.is_last)]
        else:
            apart.append(word)
    return apart


def _is_whole(word: Word) -> bool:
    """Return whether a word with a number is a unit, a spectrum, a filler or a file."""
    from radcalc.spectra.sources import is_named

    text = word.text
    known = word.folded in FILLERS or word.folded in names(ENGLISH_ALONE)
    known = known or word.folded in literals() or is_named(text)
    return known or unit_in([text]) is not None or os.path.isfile(text)


def _found(text: str, reading: "_Reading") -> Sentence:
    """Return the facts, goals, files and unknown words of a reading, put in order."""
    words = reading.words
    facts: list[Fact] = []
    goals: list[Goal] = []
    files: list[str] = []
    unknown: list[str] = []
    ignored: list[str] = []
    at = 0
    while at < len(words):
        end, filled = reading.longest(at)
        if isinstance(filled, Fact):
            facts.append(filled)
        elif isinstance(filled, Goal):
            goals.append(filled)
        elif isinstance(filled, str):
            (files if filled else unknown).append(filled or reading.text(at, end) or words[at].text)
        else:
            ignored += [word.text for word in words[at:end]]
        at = end
    found = tuple(facts), tuple(goals), tuple(files), tuple(unknown)
    sentence = Sentence(*found, text, tuple(ignored), _named_in(text))
    for tidied in (
        _with_one_light, _of_line, _of_cone, _of_area, _of_air, _of_mired, _of_other_quantity,
        _of_named_number,
    ):  # fmt: skip
        sentence = tidied(sentence)
    return sentence


def _of_other_quantity(sentence: Sentence) -> Sentence:
    """Return a sentence that asks for another quantity of its only amount: wavelength of 2 eV."""
    if len(sentence.facts) != 1 or sentence.goals or sentence.files:
        return sentence
    (fact,) = sentence.facts
    amount, typed = fact.amount, fact.typed.replace(" x ", " * ")
    if not amount or not fact.symbols or not typed.endswith(amount.text):
        return sentence
    *name, last = typed.removesuffix(amount.text).split() or [""]
    parts = [*name, *([] if last in BEFORE_AMOUNT else [last])]
    unit = own = unit_in(parts)  # lux of 100 fc
    if own is None:
        unit = _usual_unit(" ".join(parts), amount)
    if unit is None or (own is None and unit.dimension == amount.dimension):
        return sentence
    alone = Fact((), amount.text, amount.text, amount)
    return sentence._replace(facts=(alone,), goals=(Goal(unit.text, unit),))


def _of_named_number(sentence: Sentence) -> Sentence:
    """Return a sentence with the number of a name before it, which it does not ask for: 0.9 ND."""
    for goal in sentence.goals:
        for k, fact in enumerate(sentence.facts):
            is_bare = fact.amount and not fact.symbols and fact.amount.unit.text == "1"
            typed = f"{fact.typed} {goal.text}"
            if is_bare and goal.names and not goal.unit and typed in sentence.text:
                named = Fact(goal.names, fact.text, typed, fact.amount)
                facts = (*sentence.facts[:k], named, *sentence.facts[k + 1 :])
                goals = tuple([one for one in sentence.goals if one is not goal])
                return sentence._replace(facts=facts, goals=goals)
    return sentence


def _usual_unit(name: str, amount: Amount) -> Unit | None:
    from radcalc.quantities.search import is_name, named

    try:
        return named(name, amount.unit) if is_name(name) else None
    except RadcalcError:  # a name of several quantities
        return None


def _with_one_light(sentence: Sentence) -> Sentence:
    """Return a sentence without a second name of its light: AM1.5 sunlight, a white 3000 K led."""
    facts = list(sentence.facts)
    spectra = [fact for fact in facts if fact.symbols == ("spectrum",) and ":" not in fact.text]
    for first, second in pairwise(spectra):
        if _is_same_light(first, second):
            facts.remove(second)
    is_led = any(fact.text.lower() == "led" for fact in spectra)
    unknown = [word for word in sentence.unknown if not is_led or word.lower() != "white"]
    return sentence._replace(facts=tuple(facts), unknown=tuple(unknown))


def _of_line(sentence: Sentence) -> Sentence:
    """Return a sentence with a wavelength without the name or colour of its lamp: sodium, red."""
    facts = sentence.facts
    if not any("wavelength" in fact.symbols or _is_line(fact) for fact in facts):
        return sentence
    lamps = [fact for fact in facts if fact.text.lower() in LAMPS_OF_LINES]
    others = [fact for fact in facts if fact not in lamps]
    without = _ignoring(sentence, OF_THINGS[LINE])
    ignored = (*without.ignored, *[fact.typed for fact in lamps])
    return without._replace(facts=tuple(others), ignored=ignored)


def _of_cone(sentence: Sentence) -> Sentence:
    """Return a sentence with the angle of a cone, which it does not ask for."""
    if not any({*fact.symbols} & {"half-angle", "apex-angle"} for fact in sentence.facts):
        return sentence
    goals = [goal for goal in sentence.goals if goal.text != "cone"]
    return sentence._replace(goals=tuple(goals))


def _of_area(sentence: Sentence) -> Sentence:
    """Return a sentence with an area, over which light is even: its mean."""
    is_even = any("area" in fact.symbols or _is_area(fact) for fact in sentence.facts)
    return _ignoring(sentence, MEAN) if is_even else sentence


def _of_air(sentence: Sentence) -> Sentence:
    """Return a sentence with light in air, which has another wavelength than in vacuum."""
    waves = AMOUNTS["wavelength"]
    has_wave = any(fact.amount and fact.amount.dimension in waves[1:] for fact in sentence.facts)
    has_wave |= any(map(_is_line, sentence.facts)) or not sentence.facts
    has_wave |= any("wavelength" in (*fact.symbols, fact.text) for fact in sentence.facts)
    return sentence if has_wave else _ignoring(sentence, OF_THINGS[AIR])


def _of_mired(sentence: Sentence) -> Sentence:
    """Return a sentence with a shift of colour temperatures, in mireds."""
    is_mired = any(goal.unit and goal.unit.is_scale for goal in sentence.goals)
    return _ignoring(sentence, OF_THINGS[SHIFT]) if is_mired else sentence


def _ignoring(sentence: Sentence, words: "Container[str]") -> Sentence:
    """Return a sentence in which some of the unknown words are ignored."""
    ignored = [word for word in sentence.unknown if comparable(word) in words]
    unknown = [word for word in sentence.unknown if comparable(word) not in words]
    return sentence._replace(unknown=tuple(unknown), ignored=(*sentence.ignored, *ignored))


def _named_in(text: str) -> frozenset[str]:
    """Return the things that need more, by the words for them in a text."""
    words = {comparable(word.strip(".,;:?!")) for word in text.split()}
    return frozenset([thing for thing in MORE_NEEDED if not MORE_NEEDED[thing].isdisjoint(words)])


def _is_same_light(first: Fact, second: Fact) -> bool:
    from radcalc.spectra.sources import find_named

    tables = find_named(first.text), find_named(second.text)
    return None not in tables and len({table.label for table in tables if table}) == 1


def _is_unit(name: str) -> bool:
    """Return whether the name of a quantity is a unit, which is asked for: 100 fL nits."""
    return len(name) > SHORTEST_UNIT and unit_of(name) is not None


def _is_letter(text: str, name: str) -> bool:
    """Return whether a text is the letter of a result with an index: R9 and Rg, also units."""
    letter = SYMBOLS[name].letter
    return "_" in letter and text.replace("_", "") == letter.replace("_", "")


def _is_area(fact: Fact) -> bool:
    return not fact.symbols and fact.amount is not None and fact.amount.dimension == AREA


def _is_line(fact: Fact) -> bool:
    return not fact.symbols and fact.amount is not None and fact.amount.is_wavelength


class _Reading:
    """The words of a sentence, with the amounts that begin at each of them."""

    def __init__(
        self, words: list[Word], languages: tuple[str, ...], is_forward: bool = False
    ) -> None:
        self.words, self.is_forward, self.has_between = words, is_forward, False
        self.names = names(languages)
        self.amounts: dict[int, Amount | None] = {}

    def amount(self, at: int) -> Amount | None:
        if at >= len(self.words):
            return None
        if at not in self.amounts:
            self.amounts[at] = amount_at(self.words, at)
        return self.amounts[at]

    def _before_target(
        self, at: int, amount: Amount, symbols: "tuple[str, ...]"
    ) -> "Amount | None":
        """Return the number of an amount whose unit is the target: gain 1.1 nits, iso 100 EV.

        The target is the last word, or `in`, and the name is not asked for itself: f-stop 1000 lux.
        """
        is_in = self.words[amount.end - 1].folded in MARKS
        is_last = all(ASPECT.fullmatch(word.text) for word in self.words[amount.end :])
        is_asked = not (is_last or is_in) or not ASKED.isdisjoint(symbols)
        number = amount_at(self.words[: at + 1], at)
        if number is None or (is_asked and not amount.unit.is_scale):
            return None
        is_too_large = "ev" in symbols and read_amount(number.text).number > LARGEST_EV
        return None if is_too_large else number

    @staticmethod
    def _is_number(amount: Amount) -> bool:
        return amount.dimension == NUMBER and not amount.unit.is_scale

    def folded(self, at: int, end: int) -> str:
        return joined(self.words[at:end], True)

    def text(self, at: int, end: int) -> str:
        return joined(self.words[at:end])

    def longest(self, at: int) -> Found:
        """Return the longest phrase at a place; of two of one length, the first."""
        ways = (
            self._range(at), self._phrases(at), self._named(at), self._spectrum(at), self._goal(at),
            self._alone(at), self._file(at), self._literal(at), self._filler(at), self._command(at),
        )  # fmt: skip
        found = [one for way in ways for one in way]
        return max(found, key=lambda one: one[0]) if found else (at + 1, "")

    def _range(self, at: int) -> list[Found]:
        """Find a range of wavelengths: `380-780 nm`, `400 nm to 500 nm`, PAR next to watts."""
        if self.words[at].folded in PAR and self._has_watts:
            return [(at + 1, Fact(("range",), PAR_RANGE, self.words[at].text))]
        for end in range(min(len(self.words), at + LONGEST_RANGE), at, -1):
            if match := RANGE.fullmatch(self.text(at, end)):
                low, unit, high, last = match.groups()
                text = f"{low}{unit or last}:{high}{last}"
                return [(end, Fact(("range",), text, self.text(at, end)))]
        return []

    @cached_property
    def _has_watts(self) -> bool:
        """Return whether an amount or a target is in a radiant unit, such as W/m2."""
        amounts = filter(None, map(self.amount, range(len(self.words))))
        units = [amount.unit for amount in amounts]
        units += filter(None, [unit_in([word.text]) for word in self.words])
        readings = filter(None, map(read_light, units))
        return any(reading.kind == RADIANT for reading in readings)

    def _phrases(self, at: int) -> list[Found]:
        """Find the phrases of the table: those with an amount between two names are left out."""
        found: list[Found] = []
        for phrase, parts in patterns():
            if match := self._match(parts, at, phrase.fills):
                end, amount = match
                if amount and self._has_own(parts, end, amount):
                    continue
                text = phrase.form.format(_joined(amount.text) if amount else "")
                fills = phrase.fills
                if amount and self.words[end - 1].folded == LINE and size_of(amount) < NARROW:
                    fills = ("fwhm",)
                if fills == (TARGET,):
                    found.append((end, Goal(text, None, (text,))))
                elif fills == (UNKNOWN,):
                    found.append((end, ""))
                else:
                    found.append((end, Fact(fills, text, self.text(at, end), amount)))
        return found

    def _match(
        self, parts: "tuple[str, ...]", at: int, fills: "tuple[str, ...]"
    ) -> "tuple[int, Amount | None] | None":
        """Return the end of a pattern that begins at `at`, and its amount; None without a match."""
        amount: Amount | None = None
        for part in parts:
            is_apart = amount is not None and at and self.words[at - 1].is_last  # 5 m, radius 3 m
            if part[0] == "{":
                amount = self.amount(at)
                if part == "{number}" and amount and not self._is_number(amount):
                    amount = self._before_target(at, amount, fills)
                if amount is None or not fits(amount, part[1:-1]):
                    return None
                at = amount.end
            elif (
                at < len(self.words)
                and not is_apart
                and self.words[at].folded in part.rstrip("?").split("|")
            ):
                at += 1
            elif part[-1] != "?":
                return None
        return at, amount

    def _has_own(self, parts: tuple[str, ...], end: int, amount: Amount) -> bool:
        """Return whether the words of a phrase have the amount after them: 532 nm diameter 2 mm."""
        following = None if self.words[end - 1].is_last else self.amount(end)
        if parts[0][0] != "{" or len(parts) < 2 or not following or self._is_other(end):
            return False
        if not fits(following, parts[0][1:-1]):
            return False
        self.has_between |= not amount.is_wavelength
        return self.is_forward or (amount.is_wavelength and not following.is_wavelength)

    def _is_other(self, at: int) -> bool:
        """Return whether an amount has another name behind it: 5 m radius 3 m away."""
        _, filled = self.longest(at)
        return isinstance(filled, Fact) and bool(filled.symbols)

    def _named(self, at: int) -> list[Found]:
        """Find a name with its amount, before or after it: `radius 6 cm`, `1 mrad divergence`."""
        found: list[Found] = []
        for end, symbols in self._names(at):
            start = end
            while start < len(self.words) and self.words[start].text in BEFORE_AMOUNT:
                start += 1
            amount = self.amount(start)
            if start == end and amount and not _of_amount(symbols, amount):
                amount = self._before_target(start, amount, symbols)
                symbols = tuple(
                    [n for n in symbols if NUMBER in SYMBOLS[n].dimensions and n not in COUNTS]
                )
            if amount and (fitting := _of_amount(symbols, amount)):
                text = self.text(at, amount.end)
                found.append((amount.end, Fact(_with_plain(fitting), amount.text, text, amount)))
        amount = self.amount(at)
        if amount and not self.words[amount.end - 1].is_last:
            for end, symbols in self._names(amount.end):
                fitting = _of_amount(symbols, amount)
                own = self.amount(end)
                is_asked = "wavelength" in fitting and amount.dimension != LENGTH  # 3.1 eV lambda
                has_own = own and _of_amount(symbols, own) and not self._is_other(end)
                self.has_between |= bool(has_own and fitting and not amount.is_wavelength)
                if fitting and not is_asked and amount.dimension != NUMBER and not has_own:
                    found.append((end, Fact(fitting, amount.text, self.text(at, end), amount)))
        return found

    def _names(self, at: int) -> "list[tuple[int, tuple[str, ...]]]":
        last = min(len(self.words), at + LONGEST_NAME)
        if at < len(self.words) and self.words[at].text[-1] == "=":
            letter = self.words[at].text[:-1]
            found = self.names.get(comparable(letter), ()) or tuple(
                [n for n, s in SYMBOLS.items() if s.letter == letter and n not in SPECIFIC]
            )
            amount = self.amount(at + 1)
            if amount and not _of_amount(found, amount):  # E=3.1eV is not an irradiance
                return []
            return [(at + 1, found)] if found else []
        ends = [end for end in range(at + 1, last + 1) if self.folded(at, end) in self.names]
        ends = [end for end in ends if not _is_unit(self.text(at, end))]
        return [(end, self.names[self.folded(at, end)]) for end in ends]

    def _spectrum(self, at: int) -> list[Found]:
        """Find a spectrum, by nm:FILE or by name: of a single letter only after such as `with`."""
        from radcalc.spectra.sources import axis_of, is_named

        start = at + 1 if self.words[at].folded in LONE and at + 1 < len(self.words) else at
        for end in range(min(len(self.words), start + LONGEST_NAME), start, -1):
            text = self.text(start, end)
            is_letter = len(text) < 2 and (start == at or not text.isupper())
            is_known = is_named(text) or axis_of(text)[0]
            if not is_letter and not text[0].isdigit() and is_known:
                return [(end, Fact(("spectrum",), text, self.text(at, end)))]
        return []

    def _goal(self, at: int) -> list[Found]:
        """Find a target: a unit or a name, after a word such as `to` or alone."""
        start = at + 1 if self.words[at].folded in MARKS or self.words[at].text in MARKS else at
        last = min(len(self.words), start + LONGEST_NAME)
        for end in range(last, start, -1):
            text = self.text(start, end)
            if not text:
                continue
            is_filler = start == at == end - 1 and self.words[at].folded in FILLERS
            if text[0].isdigit() or (is_filler and not self._is_last_unit(at)):
                return []
            symbols = self.names.get(self.folded(start, end), ())
            unit = unit_in(text.split())
            if any(_is_letter(text, name) for name in symbols):
                unit = None
            if not unit and self.folded(start, end) in index().misnomers:
                symbols = tuple([name for f in called(text) for name in symbols_of(f.quantity)])
            if unit or symbols:
                return [(end, Goal(text, unit, () if unit else symbols))]
        return []

    def _alone(self, at: int) -> list[Found]:
        amount = self.amount(at)
        if amount is None:
            return []
        if amount.dimension == LENGTH and not amount.is_wavelength and self._is_size(at, amount):
            return [(min(amount.end + 1, len(self.words)), "")]
        symbols = ("reflectance",) if find_constant(amount.text) in REFLECTANCES else ()
        return [(amount.end, Fact(symbols, amount.text, amount.text, amount))]

    def _is_size(self, at: int, amount: Amount) -> bool:
        """Return whether a length may be the size of a thing next to it: a 30 cm lamp."""
        end = amount.end
        is_end = end >= len(self.words) or self.words[end - 1].is_last
        is_start = at == 0 or self.words[at - 1].is_last
        is_after = not is_start and self.words[at - 1].folded in THINGS
        return is_after or (not is_end and self.words[end].folded in NOUNS)

    def _literal(self, at: int) -> list[Found]:
        """Find an aspect, 16:9, or a filter with its number, ND8 or ND0.9."""
        text = self.words[at].text
        if ASPECT.fullmatch(text):
            return [(at + 1, Fact(("aspect",), text, text))]
        return [(at + 1, Fact(("nd",), text.upper(), text))] if DENSITY.fullmatch(text) else []

    def _file(self, at: int) -> list[Found]:
        text = self.words[at].text
        return [(at + 1, text)] if "." in text and os.path.isfile(text) else []

    def _filler(self, at: int) -> list[Found]:
        text = self.words[at].text
        if not text[0].isalnum() and text not in MARKS:
            return []
        is_ampere = len(text) == 1 and text.isupper() and at > 0
        is_letter = text[-1] == "=" and text[0].isalpha()
        amount = self.amount(at + 1) if is_letter else None
        if amount and (amount.is_wavelength or amount.dimension in AMOUNTS["wavelength"][1:]):
            return [(at + 1, None)]
        is_after = any(amount and amount.end == at for amount in self.amounts.values())
        is_after = is_after and text not in PREPOSITIONS  # 5 lm/m2 s lx
        is_unit = (is_ampere or is_after) and unit_in([text])
        last = min(at + 2, len(self.words))
        ends = [end for end in range(at + 1, last + 1) if self.folded(at, end) in FILLERS | MARKS]
        return [] if is_unit or self._is_last_unit(at) else [(end, None) for end in ends]

    def _command(self, at: int) -> list[Found]:
        """Find the name of a calculator before a sentence: lambertian disc ..."""
        text = self.words[at].text
        return [(at + 1, Fact((COMMAND,), text, text))] if at == 0 and text in SUMMARIES else []

    def _is_last_unit(self, at: int) -> bool:
        """Return whether a word is the last, and a unit, not a preposition: s, in, a."""
        return at + 1 == len(self.words) and unit_in([self.words[at].text]) is not None


def fits(amount: Amount, name: str) -> bool:
    """Return whether an amount may be in that place of a pattern."""
    if amount.dimension not in AMOUNTS[name]:
        return False
    if name == "percent":
        return amount.unit.text == "%"
    if amount.dimension == ENERGY and size_of(amount) > OF_PHOTONS:  # a pulse of 1 mJ
        return False
    is_of_light = amount.dimension == LENGTH and name != "size"
    return not is_of_light or amount.is_wavelength == (name == "wavelength")


def _joined(text: str) -> str:
    """Return an amount as one word, if it reads the same: 2 m becomes 2m."""
    number, blank, unit = text.partition(" ")
    return number + unit if blank and unit.isalpha() and number.isascii() else text


def _with_plain(symbols: tuple[str, ...]) -> tuple[str, ...]:
    """Return symbols of means with those of the quantities: an average luminance as an input."""
    plain = [name.removeprefix("mean-") for name in symbols]
    return (*symbols, *[name for name in plain if name in SYMBOLS and name not in symbols])


def _of_amount(symbols: "tuple[str, ...]", amount: Amount) -> tuple[str, ...]:
    return tuple(
        [
            name
            for name in symbols
            if amount.dimension in SYMBOLS[name].dimensions
            or (amount.unit.text == "1" and SYMBOLS[name].form == QUANTITY)
        ]
    )
