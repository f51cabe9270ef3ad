"""SI prefixes that put numbers from 1 to below 1000: 0.0021 lx are 2.1 mlx."""

from radcalc.units.compiled import PREFIX_NAMES, PREFIX_SYMBOLS
from radcalc.units.grammar import parse_unit, plain
from radcalc.units.table import lookup, unit_of

LEAST, MOST = 1.0, 1000.0
DIGITS = 12  # in which a number is told: 999.9999999999999 is 1000


def prefixed(text: str, size: float) -> str:
    """A unit with the prefix that suits a size in it; as it is where it takes none.

    The prefix goes before the first of several units, unless that has an exponent: kcd/m2, but m2.
    """
    if not size or _fits(size) or unit_of(text) is None:
        return text
    folded = plain(text)
    spelling, exponent, _ = parse_unit(folded)[0]
    read = lookup(spelling)
    if read is None or exponent != 1 or not folded.startswith(spelling):
        return text
    own = PREFIX_NAMES.get(read[0], 0)
    others = _spellings(spelling, *read)
    suited = [shift for shift in others if _fits(size * 10.0 ** (own - shift))]
    if not suited:  # beyond the last of them
        suited = [max([own, *others]) if abs(size) >= MOST else min([own, *others])]
    text_of_first = others.get(suited[0], spelling)
    return text if suited[0] == own else text_of_first + folded[len(spelling) :]


def _fits(size: float) -> bool:
    return LEAST <= abs(float(f"{size:.{DIGITS}g}")) < MOST


def _spellings(spelling: str, prefix: str, unit: str) -> dict[int, str]:
    """A unit with each prefix of a power of 1000 that it takes, and without, by the powers of 10.

    Symbols have symbols before them, and names have names.
    """
    own = [prefix, *(mark for mark, name in PREFIX_SYMBOLS.items() if name == prefix)]
    head = next(head for head in own if spelling.lower().startswith(head.lower()))
    stem = spelling[len(head) :]
    found: dict[int, str] = {}
    for mark, name in [("", ""), *PREFIX_SYMBOLS.items(), *((one, one) for one in PREFIX_NAMES)]:
        shift = PREFIX_NAMES.get(name, 0)
        if shift % 3 == 0 and lookup(mark + stem) == (name, unit):
            found.setdefault(shift, mark + stem)
    return found
