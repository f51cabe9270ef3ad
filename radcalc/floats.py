"""Floats: their limits, and those that keep the ratio that was typed."""

from sys import float_info

SMALLEST, LARGEST = float_info.min, float_info.max  # a smaller float loses digits
INFINITE = float("inf")
PLAIN = 30  # characters of a decimal that is certainly within the limits


class Typed(float):
    """A number with the `ratio` of whole numbers that was typed, which a float may only be near.

    Arithmetic with it gives floats; a conversion by an exact ratio rounds once.
    """

    __slots__ = ("ratio",)
    ratio: tuple[int, int]

    def __new__(cls, number: float, ratio: tuple[int, int]) -> "Typed":
        """Return the number with its ratio."""
        made = super().__new__(cls, number)
        made.ratio = ratio
        return made

    def as_integer_ratio(self) -> tuple[int, int]:
        """Return the ratio as typed."""
        return self.ratio


def read_decimal(text: str) -> Typed | None:
    """Read `100` or `2.5`; return None for a longer number, and for any other text."""
    whole, _, part = text.partition(".")
    digits = whole + part
    if not (whole and digits.isascii() and digits.isdigit()) or len(text) > PLAIN:
        return None
    return Typed(float(text), (int(digits), 10 ** len(part)))


def divide(over: int, under: int) -> float:
    """Return the quotient of two whole numbers, rounded once; infinite if out of range."""
    try:
        return over / under
    except OverflowError:
        return INFINITE


def last_place(off: float) -> int:
    """Return the power of ten of the last digit of an uncertainty, which is printed with two."""
    return int(f"{off:.1e}".partition("e")[2]) - 1


def as_printed(value: float, off: float) -> tuple[float, float]:
    """Return a number and its uncertainty as they are printed."""
    return round(float(value), -last_place(off)), float(f"{off:.1e}")
