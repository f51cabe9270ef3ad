"""The words between an amount and its target, or between a unit and its divisor: one table.

A divisor after Czech `za` and Russian `за` and `в` is a time; after `na` and `на` it is neither a
time nor light that is seen or counted.  It is never of the quantity that it divides.
"""

from radcalc.units.unit import COUNT_AT, LUMINOSITY_AT, TIME_AT, Unit

TO = ("to", "into", "->", "=>", "→", "=")  # before a target, always
ALSO_UNITS = ("in", "as")  # before a target, or inches and attoseconds
TIME, OTHERS = "time", "others"
DIVIDERS = {"na": OTHERS, "на": OTHERS, "za": TIME, "за": TIME, "в": TIME}
ALSO = (*ALSO_UNITS, "na", "на", "в", "v", "do")  # before a target, or something else


def divides(word: str, over: "Unit | None", under: "Unit | None") -> bool:
    """Return whether a word of another language is `per` between two units."""
    if under is None:
        return False
    powers = under.dimension
    is_time = sum(map(abs, powers)) == powers[TIME_AT] == 1
    if is_time != (DIVIDERS[word] == TIME) or (over and over.dimension == powers):
        return False
    return not (powers[COUNT_AT] or powers[LUMINOSITY_AT])
