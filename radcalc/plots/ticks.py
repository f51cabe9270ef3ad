"""Round numbers along an axis, and their texts."""

import math
from collections.abc import Iterable

STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)
FAR = 20.0  # ratio of the ends above which contours are not evenly spaced
ROUNDED = 1e-12  # of the greatest value: smaller values are shown as 0
NEGLIGIBLE = 1e-9  # of the greatest value: smaller values are rounding errors of 0
SPAN = 1000.0  # ratio of the brightest to the darkest in an image
CLIPPED = 0.995  # quantile of an image's values that has the greatest brightness
RINGS = 6  # most circles of a polar diagram, including the centre
DIGITS = 6  # of a number, unless it needs more to differ from others
ROUNDING = 1e-9  # of a step: tolerance of a tick


def ticks(low: float, high: float, most: int) -> list[float]:
    """Return evenly spaced round numbers between two ends, including round ends.

    >>> ticks(380.0, 780.0, 5)
    [400.0, 500.0, 600.0, 700.0]
    """
    step = round_step((high - low) / max(most - 1, 1))
    first = math.ceil(low / step - ROUNDING)
    places = []
    while first * step <= high + step * ROUNDING:
        places.append(float(f"{first * step:.12g}"))
        first += 1
    return places if len(places) <= most or most <= 2 else ticks(low, high, most - 1)


def round_step(least: float) -> float:
    """Return the smallest of 1, 2, 2.5, 5 times a power of ten that is not below a number."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(s for s in STEPS if s * power >= least * (1 - ROUNDING)) * power


def log_ticks(low: float, high: float, most: int) -> list[float]:
    """Return powers of ten between two ends, with 2 and 5 times them if there is room."""
    ends = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    for factors in ((1, 2, 5), (1,)):
        places = [float(f"{f}e{power}") for power in ends for f in factors]
        places = [x for x in places if low * (1 - ROUNDING) <= x <= high * (1 + ROUNDING)]
        if len(places) <= most:
            return places
    apart = 2
    while len(places[::apart]) > most:
        apart += 1
    return places[::apart]


def limits(values: list[float], most: int) -> tuple[float, float]:
    """Return round ends of an axis for values, including 0 if it is near.

    >>> limits([3.0, 97.0], 6), limits([996.0, 1004.0], 6)
    ((0.0, 100.0), (996.0, 1004.0))
    """
    low, high = min(values), max(values)
    if 0 < low < high / 2:
        low = 0.0
    if high < 0 and high > low / 2:
        high = 0.0
    if low == high:
        low, high = (low - 1, high + 1) if not low else sorted((0.0, 2 * low))
    step = round_step((high - low) / max(most - 1, 1))
    return math.floor(low / step + ROUNDING) * step, math.ceil(high / step - ROUNDING) * step


def rings(most: float) -> list[float]:
    """Return the radii of the circles of a polar diagram for values up to `most`."""
    return ticks(0.0, limits([0.0, most], RINGS)[1], RINGS)[1:]


def levels(values: Iterable[float], most: int = 10) -> list[float]:
    """Return round numbers between the least and the greatest of many, for contours.

    If the ends are far apart, they are 1, 2 and 5 times powers of ten.  A least value that is a
    rounding error of 0, as at the horizon of a cosine, counts as 0.

    >>> levels([0.4, 210.0])
    [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0]
    """
    ordered = sorted(values)
    low, high = ordered[0], ordered[-1]
    if not low < high * (1 - 1e-6):
        return []
    is_far = low > NEGLIGIBLE * high and high > FAR * low
    places = log_ticks(low, high, most) if is_far else ticks(low, high, most)
    return [x for x in places if low < x < high]


def ends(values: Iterable[float]) -> tuple[float, float]:
    """Return the least and the greatest of many values, with 0 for a rounding error of 0."""
    numbers = [*values]
    low, high = min(numbers), max(numbers)
    least = ROUNDED * max(abs(low), abs(high))
    return low if abs(low) > least else 0.0, high if abs(high) > least else 0.0


def shades(values: list[float]) -> tuple[float, float]:
    """Return the ends of a logarithmic brightness scale; values beyond them are clipped.

    >>> shades([0.0, 2.0, 400.0])
    (0.4, 400.0)
    """
    ordered = sorted(values)
    high = ordered[round(CLIPPED * (len(ordered) - 1))] or 1.0
    return max(ordered[0], high / SPAN), high


def texts(values: list[float]) -> list[str]:
    """Return different numbers as axis labels, with enough digits to distinguish them.

    >>> texts([0.0, 0.5, 1.0]), texts([0.0, 2e-7])
    (['0', '0.5', '1'], ['0', '2e-07'])
    """
    for digits in range(DIGITS, 17):
        numbers = [f"{value + 0.0:.{digits}g}" for value in values]
        if len(set(numbers)) == len(values):
            break
    return numbers
