"""The share of an uncertain number in a value."""

from collections.abc import Callable
from typing import NamedTuple

from radcalc.errors import NumberError, quote

LEAST, MOST = 1e-150, 1e150  # uncertainties whose squares are numbers


class Part(NamedTuple):
    """What follows of an uncertain number of an expression, or of a reading on a scale.

    Its text; what it adds to the uncertainty, with a sign; and a function that gives what the
    whole comes to where the number is moved by so many of its uncertainties, from -1 to 1; None
    where there is no such value.
    """

    text: str
    size: float
    at: Callable[[float], float | None]


def check_uncertainty(off: float, text: str = "") -> None:
    """Refuse an uncertainty, of a text or of a result, whose square is beyond what floats hold."""
    if off and not LEAST <= off <= MOST:
        subject = f"'{quote(text)}'" if text else "a result"
        problem = f"the uncertainty of {subject} is beyond what radcalc reckons with"
        raise NumberError(problem, f"an uncertainty from {LEAST:g} to {MOST:g}")
