"""Slopes by finite differences, contributions of uncertain numbers, jumps and corners."""

import math
from collections.abc import Callable, Hashable, Mapping
from typing import NamedTuple, TypeVar

from radcalc.errors import NumberError, quote

Key = TypeVar("Key", bound=Hashable)

LEAST, MOST = 1e-150, 1e150  # uncertainties whose squares are numbers
STEP, LEAST_STEP = 2.0**-10, 2.0**-20  # relative to the uncertain number
OF_ZERO = 16  # steps in the uncertainty of a number that is 0
NOISE = 1e-14  # relative error of the arithmetic
FLAT = 1e-5  # error of a slope next to an extremum, relative to the changes within a step
DIGITS = 11  # significant digits of a slope
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
    return float(f"{rise / step:.{DIGITS}g}")


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
