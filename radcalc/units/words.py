"""The names of constants in a text: `h*c/(500 nm)` begins with one."""

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
