"""Functions of the numbers of expressions, to so many digits that what cancels later is right.

A number is a ratio of whole numbers with its blur: how far it may be off, relative to it; 0 where
it is exact.
"""

import math
from decimal import Context, Decimal, Overflow, Underflow, getcontext, localcontext

from radcalc.units.unit import PI

DIGITS = 50  # of a result, beyond those that tell its argument from its neighbours
MAX_DIGITS = 2000
BITS = 170  # which are as many digits
PI_BLUR = Decimal("1e-54")  # of PI
LAST = Decimal(100)  # of the last digit: what the steps of a function round away, and more
FINEST = 1e-300  # the least blur, for 0 is that of an exact number
EXACT = (0, Decimal("0.5"), 1)
LARGEST = 708  # and -LARGEST: whose exponential is a float still

Ratio = tuple[int, int, float]  # top, bottom, blur


def of_number(name: str, top: int, bottom: int, blur: float) -> Ratio:
    """Return the exponential or a logarithm of a number.

    Raises ArithmeticError or ValueError where it has none that a float holds.
    """
    if name == "exp" and abs(top) > LARGEST * bottom:
        raise OverflowError
    with localcontext(_context(top, bottom, blur)):
        x = Decimal(top) / Decimal(bottom)
        if name == "exp":
            return _ratio(x.exp(), abs(x) * Decimal(blur))
        if x <= 0:
            raise ValueError
        result, natural = x.ln() if name == "ln" else x.log10(), x.ln()
        return _ratio(result, Decimal(blur) / abs(natural) if natural else Decimal(blur))


def of_angle(name: str, top: int, bottom: int, blur: float) -> Ratio:
    """The sine, cosine or tangent of top / bottom degrees, from which quarters are taken exactly.

    Raises ValueError where it has none.
    """
    quarters = (2 * top + 90 * bottom) // (180 * bottom)
    remainder = top - 90 * bottom * quarters
    with localcontext(_context(remainder, bottom, blur, 2)):  # 1 less a cosine is as the square
        x = Decimal(remainder * PI[0]) / Decimal(180 * bottom * PI[1])
        sine, cosine = _series(x, x, 1), _series(Decimal(1), x, 0)
        if abs(remainder) == 30 * bottom:
            sine = Decimal("0.5").copy_sign(sine)
        if abs(remainder) == 45 * bottom and name == "tan":
            cosine = abs(sine)
        off = abs(Decimal(top) / Decimal(bottom)) * Decimal(blur) + abs(x) * PI_BLUR
        if quarters and bottom.bit_length() > BITS:  # radians, of which turns of pi are taken
            off += abs(quarters) * PI_BLUR
        if name == "cos":
            quarters += 1
        if quarters % 2:
            sine, cosine = cosine, -sine
        if name != "tan":
            result, slope = (-sine if quarters % 4 > 1 else sine), abs(cosine)
        elif cosine:
            result = sine / cosine
            slope = 1 + result * result
        else:
            raise ValueError
        if not result or (abs(result) in EXACT and not blur):
            return (*result.as_integer_ratio(), 0.0)
        return _ratio(result, off * (slope + off) / abs(result))


def root(top: int, bottom: int, blur: float) -> Ratio:
    """Return the square root of a number that is not below 0, exact where it can be."""
    over, under = math.isqrt(top), math.isqrt(bottom)
    if over * over == top and under * under == bottom:
        return over, under, blur / 2
    shift = BITS + _bits(top, bottom, blur)
    result = math.isqrt((top << (2 * shift)) // bottom)
    return result, 1 << shift, blur / 2 + 2.0 ** max(2 - result.bit_length(), -1000)


def _bits(top: int, bottom: int, blur: float) -> int:
    """How many binary digits tell a number from 1, and from another that is typed in as many."""
    over, under = top.bit_length(), bottom.bit_length()
    return abs(over - under) if blur else over + under


def _context(top: int, bottom: int, blur: float, power: int = 1) -> Context:
    digits = DIGITS + power * _bits(top, bottom, blur) * 3 // 10
    if digits > MAX_DIGITS:
        raise OverflowError
    return Context(prec=digits, traps=[Overflow, Underflow])


def _series(term: Decimal, x: Decimal, place: int) -> Decimal:
    """Return the alternating series of a sine or a cosine, from its first term on."""
    total = Decimal(0)
    while total + term != total:
        total += term
        term *= -x * x / ((place + 1) * (place + 2))
        place += 2
    return total


def _ratio(result: Decimal, blur: Decimal) -> Ratio:
    """A result, with the blur of the last digits that are worked out."""
    return (*result.as_integer_ratio(), float(blur + LAST.scaleb(-getcontext().prec)) + FINEST)
