"""Blocks of numbers through a plan: the answers of `Plan.apply`, many at a time.

A plan between two units is an exact fraction, applied with one rounding.  Floats certainly give the
same result in two cases:

- The fraction is a decimal of few digits (1 lx = 0.09290304 fc), as are the numbers: their product
  is a decimal of at most 15 digits.  Its factors of 2 keep it from lying halfway between two
  numbers of the required precision, and otherwise it is further from that point than three
  roundings can move it: a plain product prints the same digits.
- The product is computed in two parts, with a bound on the error.  If both ends of the interval
  round to one float, that is the exact answer; if not, the fraction decides.
"""

from math import gcd

from radcalc.conversion import Plan
from radcalc.errors import RadcalcError
from radcalc.floats import divide

SHAPE = bytes.maketrans(b"123456789E", b"000000000e")  # every digit becomes 0, to find long numbers
SIGNS = b".+-"
SPLITTER = 134217729.0  # 2^27 + 1 splits the 53 bits of a float (Veltkamp)
LOST = 2.0**-75  # bound of the relative error of a product in parts
SMALL, LARGE = 1e-100, 1e100  # between these, every part of a product is in the range of a float
LONGEST = 99  # digits of a number that is certainly between them, or 0
MOST_DIGITS, MOST_PRECISION = 15, 14  # digits of decimals that three roundings keep distinct


class Bulk:
    """A plan prepared for blocks of numbers, shown with `precision` digits."""

    def __init__(self, plan: Plan, precision: int) -> None:
        self.plan = plan
        self.factor = plan.factor
        self.form = b"%%.%dg" % precision
        able = self.factor == 0 or SMALL < abs(self.factor) < LARGE
        self.singly = not plan.is_linear or any(link.check for link, _ in plan.links)
        self.able = able or not plan.is_linear
        self.digits = LONGEST  # numbers of at most so many digits take a plain product
        if not plan.links and plan.is_linear:
            over = plan.source.top * plan.target.bottom
            under = plan.source.bottom * plan.target.top
            self.digits = plain_digits(over, under, precision)
            if self.able:
                self._split(over, under)

    def _split(self, over: int, under: int) -> None:
        """Split the factor into a part of 26 bits and the rest."""
        scaled = SPLITTER * self.factor
        self.high = scaled - (scaled - self.factor)
        top, bottom = self.high.as_integer_ratio()
        self.low = divide(over * bottom - top * under, under * bottom)

    def lines(self, block: bytes) -> bytes | None:
        """Convert lines of one decimal number each; return None if any is unusual."""
        values = self.values(block)
        return None if values is None else (self.form + b"\n") * len(values) % tuple(values)

    def values(self, block: bytes) -> list[float] | None:
        """Return the results of lines of one decimal number each; None if any is unusual.

        The grammar must read unusual lines: blanks, an empty line, `1/3`, a number out of range.
        """
        shape = shape_of(block)
        if shape is None or not self.able:
            return None
        try:
            typed = floats(block, shape)
            if typed is None:
                return None
            if b"-" in block and min(typed) < 0:
                self.plan.has_negative = True
                if self.plan.links:
                    return None
            if self.singly:
                values = [self.plan.apply(value) for value in typed]
            elif b"0" * (self.digits + 1) not in shape:
                factor = self.factor
                values = [value * factor for value in typed]
            else:
                values = self.exact(typed)
        except (ValueError, RadcalcError):
            return None
        return [value + 0.0 for value in values] if b"-" in block else values  # no -0

    def exact(self, values: list[float]) -> list[float]:
        """Return the products with the exact fraction, rounded once."""
        high, low, factor, splitter, lost = self.high, self.low, self.factor, SPLITTER, LOST
        answers = []
        for value in values:
            scaled = splitter * value
            head = scaled - (scaled - value)
            product = head * high
            correction = head * low + (value - head) * factor
            bound = product * lost
            answer = product + (correction - bound)
            if answer != product + (correction + bound):
                answer = self.plan.apply(value)
            answers.append(answer)
        return answers


def shape_of(block: bytes) -> bytes | None:
    """Return lines of decimal numbers with every digit as 0, or None for other lines."""
    shape = block.translate(SHAPE, SIGNS)
    is_other = shape.translate(None, b"0e\n") or b"0" * (LONGEST + 1) in shape
    return None if is_other else shape


def floats(block: bytes, shape: bytes) -> list[float] | None:
    """Return the numbers of lines; None if one with an exponent may be out of range."""
    texts = block.split(b"\n")
    texts.pop()
    values = list(map(float, texts))
    if b"e" not in shape:
        return values
    sizes = list(map(abs, values))
    return values if min(sizes) > SMALL and max(sizes) < LARGE else None


def numbers(texts: list[bytes]) -> list[float] | None:
    """Return decimal numbers as the grammar reads them, or None for other texts or -0."""
    block = b"\n".join(texts) + b"\n"
    shape = shape_of(block)
    if shape is None:
        return None
    try:
        values = floats(block, shape)
    except ValueError:
        return None
    return None if values and b"-" in block and 0.0 in values else values


def plain_digits(over: int, under: int, precision: int) -> int:
    """Return the digits of numbers whose plain product with over/under is printed correctly.

    Return 0 if the fraction is not a decimal of few digits.  With T the digits of the fraction as
    a whole number, a number N of n digits gives N T of at most n + digits(T) digits.  N T lies
    halfway only if it has L digits and is 5 * 10^(L - precision - 1) times an odd number; then 2
    divides it exactly L - precision - 1 times, but it does so at least as often as T.
    """
    under //= gcd(over, under)
    tens = next((power for power in range(23) if 10**power % under == 0), None)
    if tens is None or precision > MOST_PRECISION:
        return 0
    digits = str(over * 10**tens // under).rstrip("0")
    twos = (int(digits) & -int(digits)).bit_length() - 1
    return max(0, min(MOST_DIGITS, precision + twos) - len(digits))
