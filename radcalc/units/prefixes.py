"""The SI prefixes that a unit takes: lx, mlx, klx."""

from radcalc.units.compiled import PREFIX_NAMES, PREFIX_SYMBOLS
from radcalc.units.grammar import parse_unit, plain
from radcalc.units.table import lookup, unit_of


def prefixes_of(text: str) -> dict[int, str]:
    """A unit with each prefix of a power of 1000, by the power of ten that it is of the unit.

    The unit itself is the first, and alone where it takes none.  The prefix goes before the first
    of several units, unless that has an exponent: kcd/m2, but m2.
    """
    found = {0: text}
    if unit_of(text) is None:
        return found
    folded = plain(text)
    spelling, exponent, _ = parse_unit(folded)[0]
    read = lookup(spelling)
    if read is None or exponent != 1 or not folded.startswith(spelling):
        return found
    own = PREFIX_NAMES.get(read[0], 0)
    for shift, first in _spellings(spelling, *read).items():
        found.setdefault(shift - own, first + folded[len(spelling) :])
    return found


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
