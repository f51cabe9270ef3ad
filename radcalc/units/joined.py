"""Units that are written together: Wm-2, Js-1, J/kgK, W/m2sr, as in lecture notes.

A product below a solidus is all below it, so W/m2sr is W/(m2.sr).  A text with several readings
(lmm-2) has none.
"""

import re

from radcalc.units.compiled import PREFIX_SYMBOLS, SYMBOLS
from radcalc.units.grammar import plain
from radcalc.units.unit import takes

RUN = r"(?:[^\W\d_]+(?:\^?[-\u2212\u207b]?[\d\u00b9\u00b2\u00b3\u2070-\u2079]+)?)+"
JOINED = re.compile(rf"({RUN})(?:/({RUN}))?")
PARTS = re.compile(r"([^\W\d_]+)([^\w]*[\d\u00b9\u00b2\u00b3\u2070-\u2079]*)")
DIFFERENCE = re.compile(r"[-\u2212]\d+[^\W\d_]+$")  # the end of 5m-2cm
LONGEST = 30  # characters of a text
ENOUGH = 2  # readings that make a text ambiguous


def readings(text: str) -> list[str]:
    """Return the texts with signs between the units, up to two; none for another text."""
    text = plain(text)
    match = JOINED.fullmatch(text) if len(text) <= LONGEST else None
    if match is None or text.isalpha() or DIFFERENCE.search(text):
        return []
    over = _products(match[1])
    under = _products(match[2]) if match[2] else [""]
    return [f"{a}/({b})" if "." in b else f"{a}/{b}" if b else a for a in over for b in under][
        :ENOUGH
    ]


def _products(run: str) -> list[str]:
    """Return the products of symbols that a run of letters and exponents may be."""
    found = [""]
    for letters, exponent in PARTS.findall(run):
        splits = [letters] if _is_symbol(letters) else _splits(letters)
        found = [
            f"{before}.{split}{exponent}".removeprefix(".") for before in found for split in splits
        ][:ENOUGH]
    return found


def _splits(letters: str) -> list[str]:
    """Return the ways to write letters as symbols with points between them."""
    found = []
    for end in range(1, len(letters)):
        if _is_symbol(letters[:end]):
            rest = letters[end:]
            rests = [rest] if _is_symbol(rest) else _splits(rest)
            found += [f"{letters[:end]}.{other}" for other in rests]
    return found[:ENOUGH]


def _is_symbol(text: str) -> bool:
    if text in SYMBOLS:
        return True
    return any(
        text[:size] in PREFIX_SYMBOLS and text[size:] in SYMBOLS and takes(text[:size], text[size:])
        for size in (1, 2)
    )
