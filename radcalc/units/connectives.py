"""The words between an amount and its target, or between a unit and its divisor: one table.

A divisor after Czech `za` and Russian `за` and `в` is a time; after `na` and `на` it is neither a
time nor light that is seen or counted.  It is never of the quantity that it divides.
"""

TO = ("to", "into", "->", "=>", "→", "=")  # before a target, always
ALSO_UNITS = ("in", "as")  # before a target, or inches and attoseconds
TIME, OTHERS = "time", "others"
DIVIDERS = {"na": OTHERS, "на": OTHERS, "za": TIME, "за": TIME, "в": TIME}
ALSO = (*ALSO_UNITS, "na", "на", "в", "v", "do")  # before a target, or something else
ALL = (*TO, *ALSO)


def divides(word: str, over: str, under: str) -> bool:
    """Return whether a word of another language is `per` between the English texts of two units."""
    from radcalc.units.dimensions import TIME as OF_TIME
    from radcalc.units.table import unit_of
    from radcalc.units.unit import COUNT_AT, LUMINOSITY_AT

    first, second = unit_of(over), unit_of(under)
    if second is None:
        return False
    powers = second.dimension
    if (powers == OF_TIME) != (DIVIDERS[word] == TIME) or (first and first.dimension == powers):
        return False
    return not (powers[COUNT_AT] or powers[LUMINOSITY_AT])
