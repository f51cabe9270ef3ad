"""Slopes, by finite differences, and ranges of numbers that depend on an uncertain one."""

import math
from collections.abc import Callable, Hashable, Mapping
from itertools import pairwise
from typing import TypeVar

from radcalc.maths import limit

Key = TypeVar("Key", bound=Hashable)

STEP, LEAST_STEP = 2.0**-10, 2.0**-20  # relative to the uncertain number
OF_ZERO = 16  # steps in the uncertainty of a number that is 0
NARROWER = 2.0**-7  # of a step, next to a limit
NOISE = 1e-14  # relative error of the arithmetic
FLAT = 1e-5  # error of a slope next to an extremum, relative to the changes within a step
SAME = 0.1  # largest relative growth of a slope next to a limit with a narrower step
DIGITS = 11  # significant digits of a slope
SAMPLES = 8  # on either side of the nominal value; at most one extremum between two of them
GOLDEN = (math.sqrt(5) - 1) / 2
NARROWINGS = 35  # of the interval with an extremum, to 5e-8 of it
ZERO = 1e-12  # of the change towards the end: the residual of an extremum of 0
NEARER = (1e-2, 1e-4, 1e-6)  # of the way to a point where a number may be unbounded
FAINT = 1e-6  # of the range of the samples
HALVINGS, SHARP = 8, 0.2  # searches for a corner: a smooth number keeps 2^-8 of a corner's 1/2 to 2
RESOLVED = 1e-7  # of a number: corners below it may be noise of an integration
ENDLESS = 0.7  # least ratio of successive changes of an unbounded number; 1 for a logarithm


def slopes(
    at: Callable[[float], Mapping[Key, float]],
    nominal: Mapping[Key, float],
    size: float,
    off: float,
) -> dict[Key, float | None]:
    """Return the slopes of numbers over a variable of a `size` with an uncertainty `off`.

    `at` returns the numbers for a shift of the variable, none if it is impossible.  Next to a limit
    slopes are one-sided.  A slope is None if it does not exist, or grows as the step narrows.
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
    found_slopes = {}
    for key, value in nominal.items():
        wide, slope = _slope(value, points, key, step), _slope(value, nearer, key, narrow)
        is_whole = all(key in numbers for numbers in nearer.values())
        if slope and not is_whole and (wide is None or abs(wide - slope) > SAME * abs(slope)):
            slope = None
        found_slopes[key] = slope
    return found_slopes


def _points(
    at: Callable[[float], Mapping[Key, float]], step: float
) -> dict[int, Mapping[Key, float]]:
    return {k: at(k * step) for k in (-2, -1, 1, 2)}


def _slope(
    value: float, points: Mapping[int, Mapping[Key, float]], key: Key, step: float
) -> float | None:
    """Return the slope of one number; None if there are too few points around it."""
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


def reach(at: Callable[[float], float | None]) -> tuple[float, float]:
    """Return the least and the greatest number that `at` gives from -1 to 1; infinite if unbounded.

    `at` returns None for an impossible shift, never at 0.  Extrema between samples are found by
    golden-section search.
    """
    samples = [(k / SAMPLES, at(k / SAMPLES)) for k in range(-SAMPLES, SAMPLES + 1)]
    numbers = [value for _, value in samples if value is not None]
    least = FAINT * (max(numbers) - min(numbers))
    edges, candidates = [], []
    for (left, left_value), (right, right_value) in pairwise(samples):
        if (left_value is None) != (right_value is None):
            inside, outside = (right, left) if left_value is None else (left, right)
            edge = limit(lambda t: at(t) is not None, outside, inside)
            edges.append((edge, at(edge)))
            candidates.append(_trend(at, edge, inside, least))
    points = sorted((t, value) for t, value in samples + edges if value is not None)
    for sign in (1, -1):
        k = max(range(len(points)), key=lambda k: sign * points[k][1])
        around = [points[j][0] for j in (max(k - 1, 0), k, min(k + 1, len(points) - 1))]
        peak = _peak(at, sign, *around)
        value = at(peak)
        if value and peak not in around and abs(value) <= ZERO * abs(points[0][1] - value):
            value = 0.0
        candidates += [
            points[k][1],
            value,
            *(_trend(at, peak, side, least) for side in around[::2]),
        ]
    reached = [number for number in candidates if number is not None]
    return min(reached), max(reached)


def is_broken(at: Callable[[float], float | None]) -> bool:
    """Return whether a number jumps from -1 to 1, or has a corner that is not at an end.

    Around three points at a distance h, the deviation from a straight line shrinks as h^2 for a
    smooth number, as h at a corner, and not at all at a jump.
    """
    step, first, away, middle = 1 / SAMPLES, 0.0, 0.0, 0.0
    places = [k * step for k in range(1 - SAMPLES, SAMPLES)]
    for _ in range(HALVINGS + 1):
        away, middle = max((_away(at, place, step), place) for place in places)
        first = first or away
        step /= 2
        places = [middle - step, middle, middle + step]
    if any(_falls_off(at, sign) for sign in (-1.0, 1.0)):
        return True
    ends = middle - 4 * step, middle + 4 * step
    if ends[0] < -1 or ends[1] > 1 or None in (at(ends[0]), at(ends[1])):
        return False
    return away > max(first * SHARP * 2.0**-HALVINGS, RESOLVED * abs(at(0.0) or 0.0))


def at_jumps(at: Callable[[float], float | None]) -> list[float]:
    """Return the numbers on both sides of each jump between -1 and 1."""
    samples = [(k / SAMPLES, at(k / SAMPLES)) for k in range(-SAMPLES, SAMPLES + 1)]
    known = [(place, number) for place, number in samples if number is not None]
    numbers = [number for _, number in known]
    least = SAME * (max(numbers) - min(numbers))
    sides = []
    for (left, before), (right, after) in pairwise(known):
        if abs(after - before) > least:
            middle = (before + after) / 2

            def is_before(place: float, rises: bool = after > before, at_: float = middle) -> bool:
                number = at(place)
                return number is not None and (number < at_) == rises

            edge = limit(is_before, right, left)
            sides += [at(edge), at(limit(lambda place: not is_before(place), left, right))]
    return [number for number in sides if number is not None]


def _falls_off(at: Callable[[float], float | None], end: float) -> bool:
    """Return whether a number jumps at an end."""
    numbers = [at(end * k / SAMPLES) for k in range(SAMPLES + 1)]
    last, before = numbers[-1], at(end * (1 - 2.0**-HALVINGS / SAMPLES))
    known = [number for number in numbers if number is not None]
    if last is None or before is None:
        return False
    return abs(last - before) > max(SAME * (max(known) - min(known)), RESOLVED * abs(last))


def _away(at: Callable[[float], float | None], place: float, step: float) -> float:
    """Return the deviation of the middle one of three points from a straight line."""
    low, middle, high = (at(place + k * step) for k in (-1, 0, 1))
    if low is None or middle is None or high is None:
        return 0.0
    return abs(middle - (low + high) / 2)


def _peak(
    at: Callable[[float], float | None], sign: int, left: float, middle: float, right: float
) -> float:
    def height(t: float) -> float:
        value = at(t)
        return -math.inf if value is None else sign * value

    if middle in (left, right):  # an end: from there it may rise before it falls
        aside = middle + NEARER[0] * (left + right - 2 * middle)
        if height(aside) <= height(middle):
            return middle
    low, high = right - GOLDEN * (right - left), left + GOLDEN * (right - left)
    for _ in range(NARROWINGS):
        if height(low) < height(high):
            left, low, high = low, high, low + GOLDEN * (right - low)
        else:
            right, low, high = high, high - GOLDEN * (high - left), low
    return (left + right) / 2


def _trend(
    at: Callable[[float], float | None], end: float, start: float, least: float
) -> float | None:
    """Return the infinity that a number tends to on the way to an end; None if it is bounded.

    Changes up to `least` are noise of an integration.
    """
    a, b, c = (at(end + part * (start - end)) for part in NEARER)
    if a is None or b is None or c is None:
        return None
    change = c - b
    if abs(change) <= max(ENDLESS * abs(b - a), least):
        return None
    return math.copysign(math.inf, change)
