"""Sentences: calls in words, such as `20000 cd at 8 m to lx`, and the commands that they mean.

`phrases` is the table of phrases, `reader` finds them in a sentence, and `calls` makes the call of
a command from what they fill.  This module has the words that sentences know: patterns of phrases,
and names of quantities.
"""

import os
import re
from collections.abc import Sequence
from contextlib import suppress
from functools import cache, lru_cache

from radcalc.errors import RadcalcError, UsageError, ambiguous, call, nearest, quote
from radcalc.quantities import LUMINOUS, PHOTON
from radcalc.quantities import read as read_light
from radcalc.quantities.language import ENGLISH, LANGUAGES, SYNONYMS
from radcalc.quantities.names import DLI, LABELS, PPF, PPFD, QUANTITIES, Quantity
from radcalc.quantities.search import comparable
from radcalc.quantities.symbols import QUANTITY, SYMBOLS, specific_name
from radcalc.sentences.phrases import FILLERS, PHRASES, Phrase
from radcalc.tuples import NamedTuple
from radcalc.units import LENGTH_ALONE, NUMBER, OWN, WAVELENGTH_UNITS, Dimension, Unit, table
from radcalc.units.compiled import WEIGHTS
from radcalc.units.dimensions import TIME
from radcalc.units.numbers import find_constant
from radcalc.units.reading import read_amount
from radcalc.units.table import unit_of
from radcalc.units.values import find_scale

ENGLISH_ALONE = (ENGLISH,)


@cache
def patterns() -> "tuple[tuple[Phrase, tuple[str, ...]], ...]":
    """Return the phrases, each with the parts of its pattern."""
    return tuple([(phrase, tuple(map(_part, phrase.pattern.split()))) for phrase in PHRASES])


@cache
def literals() -> frozenset[str]:
    """Return the words of all patterns."""
    parts = [part for _, of_phrase in patterns() for part in of_phrase]
    return frozenset(word.rstrip("?") for part in parts for word in part.split("|"))


def _part(text: str) -> str:
    """Return a part of a pattern with its words in the form for comparison."""
    if text[0] == "{":
        return text
    optional = "?" if text[-1] == "?" else ""
    words = [comparable(word) or word for word in text.rstrip("?").split("|")]
    return "|".join([word if "/" not in text else text for word in words]) + optional


@cache
def names(languages: tuple[str, ...] = LANGUAGES) -> "dict[str, tuple[str, ...]]":
    """Return the symbols of every name in the vocabulary, in some languages."""
    found: dict[str, tuple[str, ...]] = {}

    def add(text: str, symbol: str) -> None:
        key = comparable(text)
        if symbol not in found.get(key, ()):
            found[key] = (*found.get(key, ()), symbol)

    for name, symbol in SYMBOLS.items():
        if len(name) > 1 and symbol.form == QUANTITY:
            others = LABELS.get(symbol.label, ()) if languages != ENGLISH_ALONE else ()
            for text in (name, symbol.label, *others):
                add(text, name)
    for name, words in SYNONYMS.items():
        for word in words.split() if name in SYMBOLS else ():
            if comparable(word) not in FILLERS:
                add(word, name)
    for kind, (weight, base, *_) in WEIGHTS.items():
        if base != LUMINOUS and weight not in table.PAR:
            own = specific_name("irradiance", kind)
            add(weight, own)
            add(own, own)
    for quantity in QUANTITIES:
        for own in symbols_of(quantity):
            for text in (text for language in languages for text in quantity.names(language)):
                add(text, own)
    return found


def symbols_of(quantity: Quantity) -> list[str]:
    """Return the symbol of a quantity of light, unless it is a spectral density."""
    own = comparable(quantity.name("en")).replace(" ", "-")
    return [own] if own in SYMBOLS else []


def near_words(word: str) -> list[str]:
    """Return the words of phrases and names that are like a word."""
    of_names = {part for key in names() for part in key.split()}
    known = of_names | {part for part in literals() if part.isalpha()} | {*PPFD, *PPF, *DLI}
    return nearest(comparable(word), known, 1, 0.75)


LONGEST_UNIT = 4  # words
ENDS = ",;:?!"  # marks at the end of a word
OPERATORS = ("+", "-", "*", "/", "^", "**", "×", "·", "±", "+-")
NOT_AFTER_UNITS = {"in", "as", "a", "at", "to", "d"}  # words that are also units
TIMES = ("x", "×", "by")  # between the sides of an area
SIDES = re.compile(r"(\d[\d.]*)([a-z']*)[x×](\d[\d.]*)([a-z']+)", re.I)
BARE_SIDES = re.compile(r"(\d[\d.]*)[x×](\d[\d.]*)")  # before their unit: 4x4 ft
# f/5.6, and T4 of a lens of the cinema; T5 and T12 are tubes of fluorescent lamps.
F_NUMBER = re.compile(r"(?:[fFtT]/|f|T(?!5$|12$))(\d+(?:[.,]\d+)?)")
SHUTTERED = frozenset(["f/", "iso", "asa"])  # beside these, 1/60 is a time
BEFORE_NUMBERS = (*PPFD, *PPF, *DLI)  # quantities that are units: DLI 43.2
MICROMOLES = ("umol", "µmol", "μmol")  # of a PPFD, as growers say
SPELLED = {"average": "mean", "avg": "mean"}
OF_AMOUNTS = ("mean", "average")  # add nothing to an amount before them
LARGEST_DLI = 100  # mol/m2; outdoors it is at most 70
TENS = ["twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety", "hundred"]
MARKS_IN_WORDS = {"=>": " to ", "=?": " to ", "@": " at "}
WITHIN = (["in"], ["a"])  # before a time, not inches and years: dli 17 in 16 h
# Hours of light and darkness: 18/6
HOURS = re.compile(r"(?<![\d./])(\d{1,2}(?:\.\d+)?)/(\d{1,2}(?:\.\d+)?)(?![\d./])")
DAY, NEARLY = 24.0, 5.0  # h; a quotient is another number
DAY_OF_LIGHT = re.compile(rf"(?<![^\W\d])({'|'.join(DLI)})\b")
MICROMOLE = re.compile(r"(?<=\d) ?[uµμ]mol(?![\w/])")
OF_PEAK = re.compile(r"\(?1/e\^?[2²]\)?,?")  # of the diameter of a beam
MOST_AMOUNTS = 64  # texts that are read once in a sentence
BLANK = "\ue004"  # in place of that in the name of a file
ANSI = "ansi"  # between a number and lumens
ASPECT = re.compile(r"\d+(?:\.\d+)?:\d+")
SYMBOL = re.compile(r"([a-zλρθ][a-z0-9λρθ-]*=)(\S+)", re.I)
PART_OF_UNIT = re.compile(r"[^\W\d]+\^?-\d|per|na")  # m-2, nm^-1, per


class Word(NamedTuple):
    """A word as it was typed, its form for comparison, and whether a comma or a stop follows."""

    text: str
    folded: str
    is_last: bool = False


def joined(words: Sequence[Word], is_folded: bool = False) -> str:
    """Return the text of several words; "" if one before the last ends a part of the sentence."""
    if any(word.is_last for word in words[:-1]):
        return ""
    return " ".join([word.folded if is_folded else word.text for word in words])


class Amount(NamedTuple):
    """An amount in a sentence: its text, its unit, and the place after it."""

    text: str
    unit: Unit
    end: int

    @property
    def dimension(self) -> Dimension:
        return self.unit.dimension

    @property
    def is_wavelength(self) -> bool:
        """Return whether it is a length in a unit of wavelengths, from nm to um."""
        names = [name for name, _ in self.unit.atoms]
        return self.dimension == LENGTH_ALONE and all(name in WAVELENGTH_UNITS for name in names)


def words_of(typed: "list[str]") -> list[Word]:
    """Return the words of a call, without the marks of sentences."""
    words: list[Word] = []
    aspects: list[Word] = []
    before = ""
    whole = [word.replace(" ", BLANK) if os.path.isfile(word) else word for word in typed]
    for part in _reordered(_plain_words(" ".join(whole))):
        part = part.replace(BLANK, " ")
        text = SPELLED.get(part, part.removeprefix("--").rstrip(ENDS) if len(part) > 1 else part)
        if _adds_nothing(text, words):
            continue
        if ASPECT.fullmatch(text):
            aspects.append(Word(text, text))
        elif found := F_NUMBER.fullmatch(text):
            words += [Word("f/", "f/"), Word(found[1], found[1])]
        elif found := SIDES.fullmatch(text):
            first, unit, second, other = found.groups()
            sides = (first + (unit or other), "x", second + other)
            words += [Word(side, side) for side in sides]
        elif (found := SYMBOL.fullmatch(text)) and not os.path.isfile(text):
            words += [Word(part, comparable(part)) for part in found.groups()]  # w=0.5mm
        elif text:
            is_value = before[:2] == "--" and text[0].isdigit()  # one word, as of an option
            words.append(Word(text, comparable(text) or text, part[-1] in ENDS or is_value))
        before = part
    return words + aspects


def _plain_words(text: str) -> list[str]:
    """Return the parts of a text in plain words: `per` for `each`, 1 for `one`, `to` for `=>`."""
    text = " ".join([part if os.path.isfile(part) else _marked(part) for part in text.split()])
    if DAY_OF_LIGHT.search(text.lower()):  # 450umol 18h dli
        text = HOURS.sub(_of_light, MICROMOLE.sub(" ppfd", text))
    parts = [part for part in text.split() if not OF_PEAK.fullmatch(part)]
    plain: list[str] = []
    for part, following in zip(parts, [*parts[1:], ""], strict=False):
        is_before_unit = bool(following) and unit_of(following.rstrip(f"{ENDS}.")) is not None
        lower = part.lower()
        if part[-1] == "." and part[-2:-1].isalpha():  # 6 ft.
            part = part[:-1]
        elif lower == "one" and is_before_unit and not (plain and plain[-1].lower() in TENS):
            part = "1"
        elif lower in ("each", "every") and is_before_unit and plain and plain[-1][-1].isalpha():
            part = "per"
        plain.append(part.removesuffix("'s"))
    return [part for part in plain if part]


def _of_light(hours: re.Match[str]) -> str:
    total = float(hours[1]) + float(hours[2])
    if total != DAY and abs(total - DAY) < NEARLY:
        raise UsageError(
            f"the hours of light and darkness {hours[0]} are not those of a day", f"{hours[1]}h"
        )
    return f"{hours[1]}h " if total == DAY else hours[0]


def _marked(part: str) -> str:
    for mark, word in MARKS_IN_WORDS.items():
        part = part.replace(mark, word)
    return part


def _adds_nothing(text: str, words: Sequence[Word]) -> bool:
    """Return whether a word adds nothing to an amount: 5 W average; mean luminance is a result."""
    has_number = any(word.text[0].isdigit() for word in words[-2:])
    unit = unit_in([words[-1].text]) if has_number else None
    light = read_light(unit) if unit else None
    is_of_photons = light is not None and light.kind == PHOTON
    nothing = (*OF_AMOUNTS, *table.PAR * is_of_photons)
    return text.lower() == ANSI or (text.lower() in nothing and unit is not None)


def _reordered(parts: list[str]) -> list[str]:
    """Return words with a number before its unit: `--lux 200`, `dli 600 16h`, `inverse cm`."""
    parts = _with_sides(parts)
    for at, part in enumerate(parts):
        name = part.removeprefix("--")
        if name.lower() in BEFORE_NUMBERS and parts[at + 1 : at + 2] in (["of"], ["is"]):
            del parts[at + 1]
        following = parts[at + 1 : at + 2]
        is_before = (name != part and unit_of(name)) or name.lower() in BEFORE_NUMBERS
        is_number = bool(following) and following[0][0].isdigit()
        behind = parts[at + 2 : at + 3]
        is_alone = is_number and not any(map(str.isalpha, following[0]))
        is_bare = is_alone and (name != part or behind in WITHIN or not unit_in(behind))
        asks_rate = not {*map(str.lower, parts[2:])}.isdisjoint(PPFD)
        is_daily = name.lower() in DLI and at == 0 and not asks_rate
        if is_number and is_daily and (is_bare or parts[2] in MICROMOLES):
            if is_bare:
                _refuse_small(parts)
            parts[: 2 + (not is_bare)] = [following[0], "ppfd", name]  # dli 600 16h
        elif is_bare and is_before:
            number = following[0].rstrip(ENDS)
            parts[at : at + 2] = [number, name + following[0].removeprefix(number)]
        elif part in ("inverse", "reciprocal") and following and unit_of(following[0]):
            parts[at : at + 2] = ["", f"{following[0]}^-1"]
    return parts


def _refuse_small(parts: list[str]) -> None:
    """Refuse a number after DLI that may be the DLI itself, and one without a unit: dli 600 16."""
    _, number, *rest = parts
    if rest and rest[0].rstrip(ENDS).isdigit() and not unit_in(rest[1:2]):
        hours = call("convert", f"{number} ppfd", "dli", time=f"{rest[0].rstrip(ENDS)}h")
        raise UsageError(f"the unit of {quote(rest[0])} is missing", [hours])
    with suppress(ValueError):
        if float(number) <= LARGEST_DLI and rest:
            days = [call("convert", f"{number} dli", "ppfd", time=rest[0])]
            lights = [call("convert", f"{number} ppfd", "dli", time=rest[0])]
            raise UsageError(ambiguous(f"{parts[0]} {number}"), days + lights)


def _with_sides(parts: list[str]) -> list[str]:
    """Return words with the sides of an area apart: 4 x 4 ft for 4x4 ft."""
    apart: list[str] = []
    for part, following in zip(parts, [*parts[1:], ""], strict=False):
        sides = BARE_SIDES.fullmatch(part)
        unit = unit_of(following) if sides else None
        is_area = sides and unit and unit.dimension == LENGTH_ALONE
        apart += [sides[1], "x", sides[2]] if sides and is_area else [part]
    return apart


def amount_at(words: "list[Word]", start: int) -> Amount | None:
    """Return the amount that begins at a word: a number, its unit and arithmetic, or sides."""
    amount = _operand(words, start)
    if amount is None:
        return None
    if amount.dimension in (NUMBER, LENGTH_ALONE) and (sides := _sides(words, amount)):
        return sides
    end = amount.end
    while end + 1 < len(words) and words[end].text in (*OPERATORS, *TIMES[:2]):
        following = _operand(words, end + 1)
        if following is None:
            break
        end = following.end
    if end == amount.end:
        return amount
    texts = ["*" if w.folded in TIMES else _in_arithmetic(w.text) for w in words[start:end]]
    return amount_of(" ".join(texts), end) or amount


def _in_arithmetic(text: str) -> str:
    """Return a word of an expression: the unit that ppfd stands for."""
    return table.GROWERS_WORDS.get(text.lower(), (text,))[0]


def _operand(words: "list[Word]", start: int) -> Amount | None:
    """Return a number with its unit, a constant of the user's definitions, or what is in brackets.

    These are `20000 cd`, `1/60 s`, `mylamp`, `(10 m)^2`.
    """
    text = words[start].text
    if find_constant(text) in OWN:
        return amount_of(text, start + 1)
    if not any(c.isdigit() for c in text) and "(" not in text:
        return None
    end = start + 1
    while text.count("(") > text.count(")") and end < len(words):
        text += f" {words[end].text}"
        end += 1
    amount = amount_of(text, end)
    following = words[end : end + 1]
    if text[:2] == "1/" and following and not SHUTTERED.isdisjoint([w.folded for w in words]):
        wanted = unit_in([following[0].text])
        if wanted and wanted.dimension != TIME:
            return amount  # a shutter, whose light is asked for: iso 400 f/4 1/60 lux
    if amount and amount.dimension == NUMBER and "%" not in text:
        for last in range(min(len(words), end + LONGEST_UNIT), end, -1):
            whole = joined(words[start:last])
            if whole and (unit := unit_in(whole.split()[1:], words[last : last + 1])):
                return Amount(whole, unit, last)
    return amount


def unit_in(parts: list[str], following: Sequence[Word] = ()) -> Unit | None:
    """Return the unit or the scale of the words after a number; `in` before a unit separates."""
    text = " ".join(parts)
    if not text:
        return None
    is_par = text.lower() in table.PAR
    unit = unit_of(text) or find_scale(text) or (None if is_par else table.growers_unit(text))
    if unit is None or (parts[0] in NOT_AFTER_UNITS and following and unit_of(following[0].text)):
        return None
    is_share = "per" in parts and unit.dimension == NUMBER  # 16 h per day of light
    if is_share or any(part[0].isdigit() for part in parts):
        return None
    if len(parts) > 1 and len(unit.atoms) != 1 and not all(map(PART_OF_UNIT.fullmatch, parts[1:])):
        last = unit_of(parts[-1])
        is_time = last and last.dimension == TIME and parts[-1] not in NOT_AFTER_UNITS
        if not (is_time and unit.is_light and "per" not in parts):
            return unit if "per" in parts else None
    return unit


def _sides(words: "list[Word]", first: Amount) -> Amount | None:
    """Return an area of two sides: `15 x 20 ft`, `2 m x 4 m`."""
    if first.end + 1 >= len(words) or words[first.end].folded not in TIMES:
        return None
    second = _operand(words, first.end + 1)
    if second is None or second.dimension != LENGTH_ALONE:
        return None
    unit = "" if first.dimension == LENGTH_ALONE else second.unit.text
    return amount_of(f"{first.text}{unit}*{second.text}".replace(" ", ""), second.end)


def amount_of(text: str, end: int) -> Amount | None:
    """Return the amount of a text, or None; `end` is the place after it."""
    unit = _unit_of_amount(text)
    return Amount(text, unit, end) if unit else None


@lru_cache(MOST_AMOUNTS)
def _unit_of_amount(text: str) -> Unit | None:
    """Return the unit of an amount, None for another text; phrases try the same text often."""
    try:
        amount = read_amount(text)
    except RadcalcError:
        return None
    return amount.typed[1] or Unit("1", 1, 1, NUMBER, ())


def size_of(amount: Amount) -> float:
    """Return the value of an amount [SI]."""
    return read_amount(amount.text).number * amount.unit.factor
