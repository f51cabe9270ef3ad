"""Functions of the numbers of expressions, with digits to spare for later cancellation.

A number is a ratio of whole numbers with a blur: its relative error, 0 if it is exact.
"""

import math
from decimal import Context, Decimal, Overflow, Underflow, getcontext, localcontext

from radcalc.units.unit import PI

DIGITS = 50  # of a result, in addition to those that distinguish its argument from its neighbours
MAX_DIGITS = 2000
BITS = 170  # as many as DIGITS
PI_BLUR = Decimal("1e-54")  # of PI
LAST = Decimal(100)  # units of the last digit: more than the rounding of a function's steps
FINEST = 1e-300  # the least blur of a number that is not exact
EXACT = (0, Decimal("0.5"), 1)
LARGEST = 708  # largest argument, of either sign, whose exponential is a float

Ratio = tuple[int, int, float]  # top, bottom, blur


def of_number(name: str, top: int, bottom: int, blur: float) -> Ratio:
    """Return the exponential or a logarithm; ArithmeticError or ValueError if there is none."""
    if name == "exp" and abs(top) > LARGEST * bottom:
        raise OverflowError
    with localcontext(_context(top, bottom, blur)):
        x = Decimal(top) / Decimal(bottom)
        if name == "exp":
            return _ratio(x.exp(), abs(x) * Decimal(blur))
        if x <= 0:
            raise ValueError
        natural = x.ln()
        result = {"ln": natural, "log10": x.log10(), "log2": natural / Decimal(2).ln()}[name]
        if name == "log2" and 1 in (top, bottom) and (top * bottom).bit_count() == 1:
            return top.bit_length() - bottom.bit_length(), 1, blur  # of a power of 2
        return _ratio(result, Decimal(blur) / abs(natural) if natural else Decimal(blur))


def of_power(base: Ratio, power: Ratio) -> Ratio:
    """Return a number above 0 to a power that is not whole; ArithmeticError if too large."""
    if power[1] == 2 and not power[2] and abs(power[0]) < MAX_DIGITS:  # half of a whole number
        top, bottom, blur = root(*base)
        size = abs(power[0])
        over, under = (top, bottom) if power[0] > 0 else (bottom, top)
        return over**size, under**size, blur * size
    top, bottom, blur = of_number("ln", *base)
    over, under = top * power[0], bottom * power[1]
    return of_number("exp", over, under, blur + power[2])


def of_angle(name: str, top: int, bottom: int, blur: float) -> Ratio:
    """Return the sine, cosine or tangent of top / bottom degrees, exact at quarter turns.

    Raises ValueError if it does not exist.
    """
    quarters = (2 * top + 90 * bottom) // (180 * bottom)
    remainder = top - 90 * bottom * quarters
    with localcontext(_context(remainder, bottom, blur, 2)):  # 2: 1 - cos x is of second order
        x = Decimal(remainder * PI[0]) / Decimal(180 * bottom * PI[1])
        sine, cosine = _series(x, x, 1), _series(Decimal(1), x, 0)
        if abs(remainder) == 30 * bottom:
            sine = Decimal("0.5").copy_sign(sine)
        if abs(remainder) == 45 * bottom and name == "tan":
            cosine = abs(sine)
        off = abs(Decimal(top) / Decimal(bottom)) * Decimal(blur) + abs(x) * PI_BLUR
        if quarters and bottom.bit_length() > BITS:  # radians: the turns are multiples of pi
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
    """Return the square root of a number of 0 or more, exact if possible."""
    over, under = math.isqrt(top), math.isqrt(bottom)
    if over * over == top and under * under == bottom:
        return over, under, blur / 2
    shift = BITS + _bits(top, bottom, blur)
    result = math.isqrt((top << (2 * shift)) // bottom)
    return result, 1 << shift, blur / 2 + 2.0 ** max(2 - result.bit_length(), -1000)


def _bits(top: int, bottom: int, blur: float) -> int:
    """Return the binary digits that distinguish a number from 1 and from neighbours as long."""
    over, under = top.bit_length(), bottom.bit_length()
    return abs(over - under) if blur else over + under


def _context(top: int, bottom: int, blur: float, power: int = 1) -> Context:
    digits = DIGITS + power * _bits(top, bottom, blur) * 3 // 10
    if digits > MAX_DIGITS:
        raise OverflowError
    return Context(prec=digits, traps=[Overflow, Underflow])


def _series(term: Decimal, x: Decimal, place: int) -> Decimal:
    """Return the alternating series of a sine or a cosine, starting with its first term."""
    total = Decimal(0)
    while total + term != total:
        total += term
        term *= -x * x / ((place + 1) * (place + 2))
        place += 2
    return total


def _ratio(result: Decimal, blur: Decimal) -> Ratio:
    return (*result.as_integer_ratio(), float(blur + LAST.scaleb(-getcontext().prec)) + FINEST)
