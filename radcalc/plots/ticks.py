"""Round numbers along an axis, and their texts."""

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)
FAR = 20.0  # ratio of the ends above which contours are not evenly spaced
ROUNDED = 1e-12  # of the greatest value: smaller values are shown as 0
NEGLIGIBLE = 1e-9  # of the greatest value: smaller values are rounding errors of 0
SPAN = 1000.0  # ratio of an image's brightest part to its darkest shade, and of a sun to that part
PART = 0.005  # of an image, which may be brighter by more than the span: the sun
EVEN = 1.05  # ratio of the brightest to the darkest below which an image without it is even
GLOW = 2.0  # ratio to the brightest of the rest below which a value still belongs to it
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


def span(values: Iterable[float]) -> str:
    """Return the range of values as text.

    >>> span([32.38201, 93.258]), span([5.0, 5.0])
    ('from 32.38 to 93.26', '5 everywhere')
    """
    low, high = ends(values)
    if high - low <= ROUNDED * max(abs(low), abs(high)):
        return f"{high:.4g} everywhere"
    rounded = [float(f"{end:.4g}") for end in (low, high)]
    return "from {} to {}".format(*texts(rounded if rounded[0] < rounded[1] else [low, high]))


class Shades(NamedTuple):
    """A scale of brightness from `low` to `high`; values beyond its ends look like the ends."""

    low: float
    high: float
    is_log: bool

    @property
    def kind(self) -> str:
        return "log scale" if self.is_log else "linear scale"

    def share(self, value: float) -> float:
        """Return the brightness of a value, from 0 to 1."""
        if value >= self.high:
            return 1.0 if self.high > 0 else 0.0
        if value <= self.low:
            return 0.0
        if self.is_log:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)


def shades(values: Sequence[float]) -> Shades:
    """Return the scale of brightness of an image.

    It reaches the greatest value.  Only a small part of an image with contrast, such as the sun,
    which is brighter than the rest by more than `SPAN`, is beyond it.  The scale is logarithmic if
    its ends are far apart.

    >>> shades([1.0] * 999 + [200.0])
    Shades(low=1.0, high=200.0, is_log=True)
    >>> shades([300.0, 5000.0] * 500 + [1e9])
    Shades(low=300.0, high=5000.0, is_log=True)
    """
    ordered = sorted(values)
    least, most = ordered[0], ordered[-1]
    rest = ordered[round((1 - PART) * (len(ordered) - 1))]
    darkest = next((x for x in ordered if x > 0), 0.0)
    high = most
    if most > SPAN * rest > SPAN * EVEN * darkest > 0:
        high = max(x for x in ordered if x <= GLOW * rest)
    is_log = high > FAR * max(least, 0.0) and high > FAR * darkest > 0
    low = max(darkest, min(high, rest or high) / SPAN) if is_log else least
    return Shades(low, high, is_log)


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
