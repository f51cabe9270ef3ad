"""How numbers follow an uncertain one: their slopes, by differences."""

import math
from collections.abc import Callable, Hashable, Mapping
from typing import TypeVar

Key = TypeVar("Key", bound=Hashable)

STEP, LEAST_STEP = 2.0**-10, 2.0**-20  # of what is uncertain, relative to it
OF_ZERO = 16  # steps in the uncertainty of what is 0
NARROWER = 2.0**-7  # of a step, next to a limit
NOISE = 1e-14  # what the arithmetic adds to a number, relative to it
FLAT = 1e-5  # of the changes within a step: what a slope beside an extremum may be off by
SAME = 0.1  # by what part of it a slope next to a limit may grow in a narrower step
DIGITS = 11  # that a slope is good for


def slopes(
    at: Callable[[float], Mapping[Key, float]],
    nominal: Mapping[Key, float],
    size: float,
    off: float,
) -> dict[Key, float | None]:
    """The slope of each number over one of a `size` that is uncertain by `off`.

    `at` gives the numbers where that is moved by so much, and none where it cannot be.  Next to a
    limit slopes are one-sided; None where there is none, or it grows as the step becomes narrower.
    """
    least = (size or off) * LEAST_STEP
    step = max(min(size * STEP or off / OF_ZERO, off / 2), least)
    points = _points(at, step)
    if all(points.values()):
        return {key: _slope(value, points, key, step) for key, value in nominal.items()}
    narrow = max(step * NARROWER, least)
    nearer = _points(at, narrow)
    if (wider := narrow / NARROWER) > step:
        step, points = wider, _points(at, wider)
    found = {}
    for key, value in nominal.items():
        wide, slope = _slope(value, points, key, step), _slope(value, nearer, key, narrow)
        is_whole = all(key in numbers for numbers in nearer.values())
        if slope and not is_whole and (wide is None or abs(wide - slope) > SAME * abs(slope)):
            slope = None
        found[key] = slope
    return found


def _points(
    at: Callable[[float], Mapping[Key, float]], step: float
) -> dict[int, Mapping[Key, float]]:
    """The numbers at whole steps beside the nominal ones."""
    return {k: at(k * step) for k in (-2, -1, 1, 2)}


def _slope(
    value: float, points: Mapping[int, Mapping[Key, float]], key: Key, step: float
) -> float | None:
    """The slope of one number; None where there are too few points beside it."""
    at = {0: value, **{k: numbers[key] for k, numbers in points.items() if key in numbers}}
    if len(at) == 5:
        rise = (8 * (at[1] - at[-1]) - (at[2] - at[-2])) / 12
    elif 1 in at and -1 in at:
        rise = (at[1] - at[-1]) / 2
    else:
        side = 1 if 1 in at else -1
        if 2 * side not in at or side not in at:
            return None
        rise = side * (4 * at[side] - 3 * at[0] - at[2 * side]) / 2
    most = max(abs(number - value) for number in at.values())
    if math.isfinite(most) and abs(rise) <= max(NOISE * abs(value), FLAT * most):
        return 0.0
    return float(f"{rise / step:.{DIGITS}g}")
