"""Numbers and units of random letters: read as exact arithmetic reads them, or refused.

The oracle for numbers is a regular expression with `fractions` and 60 digits of pi (OEIS
A000796); the oracle for units is the product of factors of the SI Brochure.
"""

import math
import random
import re
from fractions import Fraction
from itertools import pairwise

from radcalc.conversion.operands import read_operands
from radcalc.conversion.plan import plan
from radcalc.errors import NumberError, RadcalcError
from radcalc.homework.question import read_claim
from radcalc.units import NUMBER as NUMBER_ITSELF
from radcalc.units.dimensions import powers, times
from radcalc.units.numbers import parse_number
from radcalc.units.table import resolve

SHORT, LONG = 4_500, 1_000_000

PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494")
LARGEST, SMALLEST = Fraction(1.7976931348623157e308), Fraction(2.2250738585072014e-308)
PIECES = [
    *"0123", "7", "00", "10", ".", "e", "E", "e5", "e-7", "e308", "e-300", "e400",
    *"+-\u2212*//", "pi", "pi", "π", *",_ ",
]  # fmt: skip
DECIMAL = r"(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+\-\u2212]?[0-9]+)?"
TERM = rf"({DECIMAL})?(pi|π)?"
NUMBER = re.compile(rf"[+\-\u2212]?{TERM}(?:([*/]){TERM})*")
TAIL = re.compile(rf"([*/]){TERM}")


class Refused(Exception):
    """A text without a unique value."""


def told_of(error: RadcalcError, text: object, part: str = "") -> None:
    """Check that an error names what is wrong and has a hint."""
    assert error.hint, text
    assert part in error.message, text


def exactly(text: str) -> tuple[Fraction, int]:
    """Return the value of a number and its count of roundings; raise Refused without a value."""
    text = text.strip()
    if not NUMBER.fullmatch(text) or "pipi" in text.replace("π", "pi"):
        raise Refused
    sign = -1 if text[:1] in ("-", "\u2212") else 1
    value, count = Fraction(1), 0
    for operator, decimal, pi in TAIL.findall("*" + text.lstrip("+-\u2212")):
        if not decimal and not pi:
            raise Refused
        if operator == "/" and decimal and pi:
            raise Refused  # 1/2pi
        mantissa, exponent = re.fullmatch(r"([^eE]*)(?:[eE](.*))?", decimal).groups()
        term, shift = Fraction(mantissa or 1), int((exponent or "0").replace("\u2212", "-"))
        if term and abs(shift) > 400:
            raise Refused
        term = held(term * Fraction(10) ** shift if term else term)
        term = held(term * (PI if pi else 1))
        if operator == "/" and not term:
            raise Refused
        value = held(value * term if operator == "*" else value / term)
        count += 1
    return sign * value, count


def held(value: Fraction) -> Fraction:
    """Return whether a value is a normal float."""
    if value and not SMALLEST <= abs(value) <= LARGEST:
        raise Refused
    return value


def number(draw: random.Random) -> None:
    """Check that a text of the letters of numbers is read correctly or refused."""
    text = "".join(draw.choices(PIECES, k=draw.randint(1, 9)))
    try:
        read = parse_number(text)
    except NumberError as error:
        told_of(error, text)
        read = None
    try:
        right, count = exactly(text)
    except Refused:
        assert read is None, (text, read)
    else:
        assert read is not None, text
        assert math.isclose(read, right, rel_tol=(count + 2) * 2.3e-16, abs_tol=0.0), (text, read)
    for sign in ("", "x="):
        try:
            read_claim(f"{sign}{text}")
        except RadcalcError:
            continue


LENGTH, TIME, LIGHT, ANGLE, POWER = "length", "time", "light", "angle", "power"
ATOMS = {
    "m": (1, LENGTH), "cm": (Fraction(1, 100), LENGTH), "km": (1000, LENGTH),
    "in": (Fraction(254, 10_000), LENGTH), "ft": (Fraction(3048, 10_000), LENGTH),
    "s": (1, TIME), "h": (3600, TIME), "min": (60, TIME), "lm": (1, LIGHT), "klm": (1000, LIGHT),
    "sr": (1, ANGLE), "msr": (Fraction(1, 1000), ANGLE), "W": (1, POWER),
    "uW": (Fraction(1, 10**6), POWER),
    "mW": (Fraction(1, 1000), POWER), "kilowatt": (1000, POWER), "Lumens": (1, LIGHT),
}  # fmt: skip
DIMENSIONS = {  # the steradian is the square of the radian, the candela the base of light
    LENGTH: powers(length=1), TIME: powers(time=1), LIGHT: powers(luminosity=1, angle=2),
    ANGLE: powers(angle=2), POWER: powers(mass=1, length=2, time=-3),
}  # fmt: skip
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def product(draw: random.Random, sign: int, found: dict[str, int]) -> tuple[str, Fraction]:
    """Make a product of units as a text, and its factor; add its dimension to `found`."""
    text, factor = "", Fraction(1)
    for _ in range(draw.randint(1, 3)):
        name = draw.choice(list(ATOMS))
        size, dimension = ATOMS[name]
        power = draw.choice((1, 1, 1, 2, 3, -1, -2))
        style = draw.choice(("", "^", "**", "⁻"))
        shown = str(power).translate(SUPERSCRIPTS) if style == "⁻" else f"{style}{power}"
        text += (draw.choice((" ", ".", "*", "·")) if text else "") + name
        text += "" if power == 1 else shown
        factor *= Fraction(size) ** power
        found[dimension] = found.get(dimension, 0) + sign * power
    return text, factor


def is_beside(text: str) -> bool:
    """Return whether two units of one quantity have a blank alone between them: s min."""
    parts = text.split(" ")
    kinds = [ATOMS[part][1] if part in ATOMS else None for part in parts]
    return any(one == other and one for one, other in pairwise(kinds))


def unit(draw: random.Random) -> None:
    """Check that the factor of a unit is the product of the factors of its parts."""
    own: dict[str, int] = {}
    text, factor = product(draw, 1, own)
    if draw.random() < 0.5:
        below, size = product(draw, -1, own)
        text += f"/({below})"
        factor /= size
    try:
        found = resolve(text)
    except RadcalcError as error:
        is_difference = re.fullmatch(r"(\w+)-\d \1", text)  # h-2 h, of an expression
        why = "two of one quantity side by side" if is_beside(text) else "a length that multiplies"
        told_of(error, text, "ambiguous" if is_difference else why)
        return
    assert not is_beside(text), text
    assert Fraction(found.top, found.bottom) == factor, text
    right = NUMBER_ITSELF
    for name, power in own.items():
        right = times(right, DIMENSIONS[name], power)
    if not any("wavenumber" in note for note in found.notes):
        assert found.dimension == right, text


WORDS = [
    *PIECES, *ATOMS, *"()^·%°'", "**", "per ", "square ", "to", "lx", "cd/m2", "nm-1", "K",
    "\udcff", "\n",
]  # fmt: skip


def words(draw: random.Random) -> None:
    """Check that random words of both are refused if they are not a conversion."""
    typed = ["".join(draw.choices(WORDS, k=draw.randint(1, 6))) for _ in range(draw.randint(1, 4))]
    if draw.random() < 0.5:
        typed[0] = f"{draw.choice(('1', '2/3', '1e-300*1e-9', '0e309', '1e2pi'))}{typed[0]}"
    try:
        amount, target = read_operands(typed)
        plan(amount.unit, resolve(target) if target else amount.unit).apply(amount.number)
    except RadcalcError as error:
        told_of(error, typed)


def sweep(count: int, seed: int) -> str:
    """Check texts of all sorts in turn."""
    draw = random.Random(seed)
    for _ in range(count // 3):
        number(draw)
        unit(draw)
        words(draw)
    return f"{count // 3} numbers, units and conversions read correctly or refused"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
