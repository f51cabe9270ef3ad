"""The spellings of a definition, and the names of constants in a text: `h*c/(500 nm)`."""

from radcalc.tuples import NamedTuple
from radcalc.units.compiled import SPELLINGS_OF_CONSTANTS

LONGEST_SYMBOL = 3  # full names match in any case


def find(word: str) -> str:
    """Return the name of the constant with a spelling, '' if there is none."""
    name = SPELLINGS_OF_CONSTANTS.get(word, "")
    if name or len(word) <= LONGEST_SYMBOL:
        return name
    return SPELLINGS_OF_CONSTANTS.get(word.lower(), "")


def word_at(text: str, at: int) -> str:
    """Return the word of letters, digits and underscores that begins at a place."""
    end = at
    if text[at : at + 1].isalpha():
        while text[end : end + 1].isalpha() or text[end : end + 1] in tuple("_0123456789"):
            end += 1
    return text[at:end]


def are_run_together(word: str) -> bool:
    """Return whether a word is two constants without a sign: hc."""
    return len(word) == 2 and all(map(find, word))


def begins_formula(text: str) -> bool:
    """Return whether a text begins with a constant, or with two without a sign."""
    word = word_at(text, 0)
    return bool(find(word)) or are_run_together(word)


class Definition(NamedTuple):
    """One unit of `light.txt`."""

    name: str
    value: str
    symbols: tuple[str, ...]
    names: tuple[str, ...]
    prefixes: tuple[str, ...]
    note: str
    source: str
    letters: tuple[str, ...]


def is_name(word: str) -> bool:
    """Return whether an alias is a full name (any case, a plural) rather than a symbol."""
    inside = word.replace("_", "").isalnum() and word.islower() and word.isascii()
    return len(word) > LONGEST_SYMBOL and inside and word[0].isalpha()


def definition(
    name: str,
    value: str,
    aliases: list[str],
    marks: dict[str, list[str]],
    prefix_symbols: dict[str, str],
) -> Definition:
    """Return the definition of a unit from the fields of its row, with its plurals."""
    symbol, rest = (aliases[0], aliases[1:]) if aliases else ("_", [])
    symbols = [a for a in [symbol, *rest] if a != "_" and not (a in rest and is_name(a))]
    names = [name, *(a for a in rest if is_name(a))]
    countable = [] if "$" in marks else names
    plurals = [n + "s" for n in countable if n[-1].isalpha() and not n.endswith(("s", "x", "ch"))]
    allowed = " ".join(marks.get("~", [])).split()
    if allowed == ["all"]:
        prefixes = dict.fromkeys(prefix_symbols.values())
    else:
        prefixes = dict.fromkeys(prefix_symbols[p] for p in allowed)
    return Definition(
        name,
        value,
        tuple(symbols),
        tuple(dict.fromkeys(names + plurals)),
        tuple(prefixes),
        " ".join(marks.get("!", [])),
        " ".join(marks.get(":", [])),
        tuple(" ".join(marks.get("$", [])).split()),
    )
