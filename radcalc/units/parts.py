"""The contribution of an uncertain number to the uncertainty of a value."""

from collections.abc import Callable
from typing import NamedTuple

from radcalc.errors import NumberError, quote

LEAST, MOST = 1e-150, 1e150  # uncertainties whose squares are numbers


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
