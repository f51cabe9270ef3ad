"""Functions of the numbers of expressions, and slopes of functions by finite differences.

The functions have digits to spare for later cancellation: a number is a ratio of whole numbers with
a blur, its relative error, 0 if it is exact.  The slopes give contributions of uncertain numbers,
jumps and corners.
"""

import math
from collections.abc import Callable, Hashable, Mapping
from decimal import Context, Decimal, Overflow, Underflow, getcontext, localcontext
from typing import NamedTuple, TypeVar

from radcalc.errors import NumberError, quote
from radcalc.units import PI
from radcalc.units.numbers import times

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
        return times(1, over, size), times(1, under, size), blur * size
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


Key = TypeVar("Key", bound=Hashable)

LEAST, MOST = 1e-150, 1e150  # uncertainties whose squares are numbers
STEP, LEAST_STEP = 2.0**-10, 2.0**-20  # relative to the uncertain number
OF_ZERO = 16  # steps in the uncertainty of a number that is 0
NOISE = 1e-14  # relative error of the arithmetic
FLAT = 1e-5  # error of a slope next to an extremum, relative to the changes within a step
ROUNDED_DIGITS = 11  # significant digits of a slope
SAMPLES = 8  # on either side of the nominal value
HALVINGS = 8  # of the distance of samples, towards the sharpest corner


class Part(NamedTuple):
    """The contribution of an uncertain number in an expression, or of a reading on a scale.

    `text` is the number as typed, `size` its signed contribution, and `at` returns the whole with
    the number shifted by -1 to 1 of its uncertainty, None if that does not exist.
    """

    text: str
    size: float
    at: Callable[[float], float | None]


def check_uncertainty(off: float, text: str = "") -> None:
    """Raise for an uncertainty, of a text or of a result, whose square a float cannot hold."""
    if off and not LEAST <= off <= MOST:
        subject = f"'{quote(text)}'" if text else "a result"
        problem = f"the uncertainty of {subject} is out of range"
        raise NumberError(problem, f"an uncertainty from {LEAST:g} to {MOST:g}")


def slopes(
    at: Callable[[float], Mapping[Key, float]],
    nominal: Mapping[Key, float],
    size: float,
    off: float,
) -> dict[Key, float | None]:
    """Return the slopes of numbers over a variable of a `size` with an uncertainty `off`.

    `at` returns the numbers for a shift of the variable.  A slope is None if `at` does not return
    its number for each shift.
    """
    half = off / 2  # two steps of it remain within the uncertainty
    step = max(min(size * STEP or off / OF_ZERO, half), (size or off) * LEAST_STEP)
    points = _points(at, step)
    if step > half and not all(points.values()):  # next to a limit
        step, points = half, _points(at, half)
    return {key: _slope(value, points, key, step) for key, value in nominal.items()}


def _points(
    at: Callable[[float], Mapping[Key, float]], step: float
) -> dict[int, Mapping[Key, float]]:
    return {k: at(k * step) for k in (-2, -1, 1, 2)}


def _slope(
    value: float, points: Mapping[int, Mapping[Key, float]], key: Key, step: float
) -> float | None:
    """Return the slope of one number; None if a point lacks it."""
    if not all(key in numbers for numbers in points.values()):
        return None
    at = {k: numbers[key] for k, numbers in points.items()}
    rise = (8 * (at[1] - at[-1]) - (at[2] - at[-2])) / 12
    most = max(abs(number - value) for number in at.values())
    if math.isfinite(most) and abs(rise) <= max(NOISE * abs(value), FLAT * most):
        return 0.0
    return float(f"{rise / step:.{ROUNDED_DIGITS}g}")


def sharpest(at: Callable[[float], float | None]) -> float:
    """Return the greatest sudden change of the slope of a number from -1 to 1; infinite at a pole.

    `at` returns None where the number does not exist.  Around three points at a distance h, the
    deviation from a straight line shrinks as h^2 for a smooth number, as h at a corner, and not at
    all at a jump, whose change of the slope is then large.
    """
    step, places = 1 / SAMPLES, [k / SAMPLES for k in range(1 - SAMPLES, SAMPLES)]
    for _ in range(HALVINGS):
        _, middle = max((_away(at, place, step), place) for place in places)
        step /= 2
        places = [middle - step, middle, middle + step]
    return max(_away(at, place, step) for place in places) * 2 / step


def _away(at: Callable[[float], float | None], place: float, step: float) -> float:
    """Return the deviation of the middle one of three points from a straight line."""
    low, middle, high = (at(place + k * step) for k in (-1, 0, 1))
    if low is None or middle is None or high is None:
        return math.inf
    return abs(middle - (low + high) / 2)
