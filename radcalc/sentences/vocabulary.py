"""The words that sentences know: patterns of phrases, and names of quantities."""

from functools import cache

from radcalc.errors import nearest
from radcalc.quantities.language import ENGLISH, LANGUAGES, SYNONYMS
from radcalc.quantities.names import DLI, LABELS, PPF, PPFD, QUANTITIES, Quantity
from radcalc.quantities.search import comparable
from radcalc.quantities.symbols import QUANTITY, SYMBOLS
from radcalc.sentences.phrases import (
    FILLERS,
    PHRASES,
    Phrase,
)

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
