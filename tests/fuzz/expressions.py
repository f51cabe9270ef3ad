"""Arithmetic with units, drawn as trees: Pint computes each in fractions, radcalc reads the text.

Pint has radcalc's definitions in a registry of exact fractions, and the answer must be Pint's,
rounded once.  Texts of random pieces must be read or refused, without any other error.
"""

import math
import random
from fractions import Fraction
from functools import cache

from fuzz.grammar import told_of
from pint.util import UnitsContainer

from radcalc.errors import RadcalcError
from radcalc.units.reading import read_amount
from radcalc.units.registry import exact_registry

SHORT, LONG = 1_200, 300_000

# The digits of light.txt (OEIS A000796).
PI = Fraction("3.14159265358979323846264338327950288419716939937510582")
GROUPS = [
    {"m": "metre", "cm": "centimetre", "ft": "foot", "in": "inch", "km": "kilometre"},
    {"s": "second", "h": "hour", "min": "minute"},
    {"lm": "lumen", "klm": "kilolumen"},
    {"lx": "lux", "fc": "footcandle", "klx": "kilolux", "ph": "phot"},
    {"cd": "candela", "mcd": "millicandela"},
    {"W": "watt", "mW": "milliwatt"},
    {"deg": "degree", "rad": "radian", "arcmin": "arcminute"},
    {"sr": "steradian", "msr": "millisteradian"},
    {"nit": "nit", "fL": "footlambert"},
    {"K": "kelvin"},
]
NAMES = {symbol: name for group in GROUPS for symbol, name in group.items()}


class Drawn:
    """A text, its value by Pint, and the precedence of its last operator."""

    def __init__(self, text, value, level, ends_in_number=False):
        self.text, self.value, self.level = text, value, level
        self.ends_in_number = ends_in_number


SUM, PRODUCT, TERM, BARE = range(4)


@cache
def registry():
    return exact_registry()


def quantity(number, **units):
    powers = {NAMES[symbol]: power for symbol, power in units.items()}
    for name in powers:
        registry().get_name(name)
    return registry().Quantity(Fraction(number), UnitsContainer(powers))


def number(draw: random.Random) -> tuple[str, Fraction]:
    """Make a number as people type it, and its value."""
    kind = draw.random()
    if kind < 0.4:
        text = str(draw.randint(1, 99))
    elif kind < 0.7:
        text = f"{draw.randint(0, 99)}.{draw.randint(1, 99):02}"
    elif kind < 0.8:
        text = f"{draw.randint(1, 9)}e{draw.randint(-9, 9)}"
    elif kind < 0.9:
        power = draw.randint(1, 9)
        times = draw.choice((" * ", "*", "×", "x"))
        raised = draw.choice(("^", "**", "⁻"))
        shown = f"⁻{'⁰¹²³⁴⁵⁶⁷⁸⁹'[power]}" if raised == "⁻" else f"{raised}{power}"
        digit = draw.randint(2, 9)
        value = digit * Fraction(10) ** (-power if raised == "⁻" else power)
        return f"({digit}{times}10{shown})", value
    else:
        digit = draw.randint(2, 9)
        return f"{digit}{draw.choice(('pi', 'π'))}", digit * PI
    return text, Fraction(text)


def leaf(draw: random.Random, group: dict[str, str] | None = None) -> Drawn:
    """Make a number with a unit or without."""
    text, value = number(draw)
    if group is None and draw.random() < 0.3:
        return Drawn(text, registry().Quantity(value), BARE)
    symbol = draw.choice(list(group or draw.choice(GROUPS)))
    power = 1 if group else draw.choice((1, 1, 1, 2, 3, -2))
    shown = symbol if power == 1 else f"{symbol}{draw.choice(('', '^', '**'))}{power}"
    blank = " " if text[-1:] in "iπ" else draw.choice(("", " "))
    return Drawn(f"{text}{blank}{shown}", quantity(value, **{symbol: power}), TERM)


def bracketed(drawn: Drawn, below: int) -> str:
    return f"({drawn.text})" if drawn.level < below else drawn.text


def tree(draw: random.Random, depth: int) -> Drawn:
    """Make an expression of some depth."""
    kind = draw.random()
    if not depth or kind < 0.1:
        return leaf(draw)
    blank = draw.choice(("", " "))
    if kind < 0.4:
        a, b = tree(draw, depth - 1), tree(draw, depth - 1)
        sign = draw.choice(("*", "*", "·", "×"))
        text = f"{bracketed(a, PRODUCT)}{blank}{sign}{blank}{bracketed(b, TERM)}"
        return Drawn(text, a.value * b.value, PRODUCT)
    if kind < 0.7:
        a, b = tree(draw, depth - 1), tree(draw, depth - 1)
        if b.value.magnitude == 0:
            return a
        text = f"{bracketed(a, PRODUCT)}{blank}/{blank}({b.text})"
        if b.level == TERM and a.value.units != registry().Unit("") and draw.random() < 0.5:
            text = f"{bracketed(a, PRODUCT)}{blank}/{blank}{b.text}"
        return Drawn(text, a.value / b.value, PRODUCT)
    if kind < 0.8:
        a, power = tree(draw, depth - 1), draw.choice((-2, -1, 2, 3))
        if a.value.magnitude == 0 or sum(map(abs, a.value.dimensionality.values())) > 3:
            return a
        return Drawn(f"({a.text}){draw.choice(('^', '**'))}{power}", a.value**power, TERM)
    group = draw.choice(GROUPS)
    a, b = leaf(draw, group), leaf(draw, group)
    if draw.random() < 0.4:
        factor, value = number(draw)
        a = Drawn(f"{factor} * {a.text}", value * a.value, PRODUCT)
    if draw.random() < 0.7:
        return Drawn(f"{a.text}{blank}+{blank}{b.text}", a.value + b.value, SUM)
    return Drawn(f"{a.text} - {b.text}", a.value - b.value, SUM)


def against_pint(draw: random.Random) -> bool:
    """Return whether a random expression was read; if so, its value is Pint's, rounded once."""
    drawn = tree(draw, draw.randint(1, 4))
    try:
        amount = read_amount(drawn.text)
    except RadcalcError as error:
        told_of(error, drawn.text)
        return False
    atoms = dict.fromkeys([name for name, _ in amount.unit.atoms] if amount.unit else [], 0)
    for name, power in amount.unit.atoms if amount.unit else ():
        atoms[name] += power
    atoms.pop("cycle", None)  # of an inverse length that is read as a wavenumber
    for name in atoms:
        registry().get_name(name)
    unit = registry().Quantity(Fraction(1), UnitsContainer({n: p for n, p in atoms.items() if p}))
    right = (drawn.value / unit).to_base_units()
    assert right.dimensionless, (drawn.text, amount.unit, drawn.value)
    exact = Fraction(right.magnitude)
    rounded = exact.numerator / exact.denominator
    if amount.rounding is None:  # a number such as 2*3.5, which is multiplied in floats
        assert math.isclose(amount.number, rounded, rel_tol=1e-15), (drawn.text, rounded)
    else:
        assert amount.number == rounded, (drawn.text, amount.number, exact)
    return True


PIECES = [
    *"0123456789", "10", ".", "e5", "^", "**", "²", "⁻", "*", "/", "+", "-", "\u2212", "×", "·",
    "(", ")", "(", ")", " ", " ", "pi", "π", "m", "lx", "cm-1", "deg", "%", "W/m2", "per ",
    "sqrt(", "cos(", "ln(", "exp(", "±", "x", "10^", "foot lambert", "dBm", ",", "_", "\ue000",
]  # fmt: skip


def hostile(draw: random.Random) -> None:
    """Read random pieces: the result is a number, or an error with a hint."""
    text = "".join(draw.choices(PIECES, k=draw.randint(1, 14)))
    try:
        amount = read_amount(text)
    except RadcalcError as error:
        told_of(error, text)
    else:
        assert abs(amount.number) < float("inf"), text


def sweep(count: int, seed: int) -> str:
    """Check random expressions and as many texts of pieces."""
    draw = random.Random(seed)
    read = 0
    for _ in range(count):
        read += against_pint(draw)
        hostile(draw)
    assert read > 0.9 * count
    return f"{read} of {count} expressions equal to Pint, the others too large; {count} texts"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
