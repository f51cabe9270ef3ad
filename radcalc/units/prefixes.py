"""The SI prefixes that a unit takes: lx, mlx, klx."""

from radcalc.units.compiled import PREFIX_NAMES, PREFIX_SYMBOLS
from radcalc.units.grammar import parse_unit, plain
from radcalc.units.table import unit_of
from radcalc.units.unit import lookup


def prefixes_of(text: str) -> dict[int, str]:
    """Return a unit with each prefix of a power of 1000, by power of ten relative to the unit.

    The unit itself is first.  The prefix goes before the first of several units, unless that one
    has an exponent: kcd/m2, but m2.
    """
    spellings = {0: text}
    if unit_of(text) is None:
        return spellings
    folded = plain(text)
    spelling, exponent, _ = parse_unit(folded)[0]
    read = lookup(spelling)
    if read is None or exponent != 1 or not folded.startswith(spelling):
        return spellings
    own_shift = PREFIX_NAMES.get(read[0], 0)
    for shift, first in _spellings(spelling, *read).items():
        spellings.setdefault(shift - own_shift, first + folded[len(spelling) :])
    return spellings


def _spellings(spelling: str, prefix: str, unit: str) -> dict[int, str]:
    own_marks = [prefix, *(mark for mark, name in PREFIX_SYMBOLS.items() if name == prefix)]
    head = next(head for head in own_marks if spelling.lower().startswith(head.lower()))
    stem = spelling[len(head) :]
    spellings: dict[int, str] = {}
    for mark, name in [("", ""), *PREFIX_SYMBOLS.items(), *((full, full) for full in PREFIX_NAMES)]:
        shift = PREFIX_NAMES.get(name, 0)
        if shift % 3 == 0 and lookup(mark + stem) == (name, unit):
            spellings.setdefault(shift, mark + stem)
    return spellings
