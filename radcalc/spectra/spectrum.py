"""Spectra, and their integrals by the trapezoid rule on the union of two grids."""

import math
from array import array
from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from itertools import pairwise
from math import inf
from operator import mul
from typing import Any

from radcalc.errors import ConditionError
from radcalc.maths import frozen
from radcalc.spectra import observers
from radcalc.spectra.observers import Observer, at

Grid = Sequence[float]


def clip(grid: Grid, values: Grid, low: float, high: float) -> tuple[list[float], list[float]]:
    """Return the part of a table between two limits, with interpolated points at the limits."""
    low, high = max(low, grid[0]), min(high, grid[-1])
    if low >= high:
        return [], []
    first, last = bisect_right(grid, low), bisect_left(grid, high)
    inner, inner_values = list(grid[first:last]), list(values[first:last])
    return ([low, *inner, high], [at(grid, values, low), *inner_values, at(grid, values, high)])


def trapezoid(grid: Grid, values: Grid) -> float:
    """Return the integral of a table; 0 for an empty one."""
    after = iter(grid), iter(values)
    next(after[0], None), next(after[1], None)
    return 0.5 * sum(
        [(x1 - x0) * (y0 + y1) for x0, y0, x1, y1 in zip(grid, values, *after, strict=False)]
    )


def moment_between(a: Any, b: Any, p: Any, q: Any) -> Any:
    """Return the integral of x times a line from (a, p) to (b, q), times 6; of floats or arrays."""
    return (b - a) * (2 * (a * p + b * q) + a * q + b * p)


def integral(grid: Grid, values: Grid, low: float = -inf, high: float = inf) -> float:
    """Return the integral of a table between two limits."""
    if low <= grid[0] and high >= grid[-1]:
        return trapezoid(grid, values)
    return trapezoid(*clip(grid, values, low, high))


def moments(grid: Grid, values: Grid, start: float, count: int, step: float = 1.0) -> list[float]:
    """Return the weights whose sum of products with any weighting is its integral over the table.

    The weighting is linear between `count` points, `step` nanometres apart, from `start`.
    """
    if step != 1:
        places = [x / step for x in grid]
        return [step * weight for weight in moments(places, values, start / step, count)]
    weights = [0.0] * count
    grid, values = clip(grid, values, start, start + count - 1)
    if not grid:
        return weights
    place, height = grid[0] - start, values[0]
    cell = min(int(place), count - 2)
    for x, y in zip(grid, values, strict=True):
        end = x - start
        if end == place:
            continue
        rise = (y - height) / (end - place)
        while cell + 1 < end:  # the whole nanometres within this step of the data
            width = cell + 1 - place
            at_edge = height + rise * width
            half = 0.5 * width
            weights[cell] += half * height * width
            weights[cell + 1] += half * (height * (1 - width) + at_edge)
            cell += 1
            place, height = float(cell), at_edge
        half, share = 0.5 * (end - place), end - cell
        weights[cell] += half * (height * (cell + 1 - place) + y * (1 - share))
        weights[cell + 1] += half * (height * (place - cell) + y * share)
        place, height = end, y
        if end >= cell + 1 and cell < count - 2:
            cell += 1
    return weights


Range = tuple[float, float]
WHOLE: Range = (0.0, math.inf)
VISIBLE: Range = (380.0, 780.0)
SHORTEST, LONGEST = 1e-6, 1e12  # nm: from gamma rays to long waves
WEAKEST, STRONGEST = 1e-100, 1e100  # limits of the greatest value: its photons stay floats
NEAR_ZERO = 0.05  # of the peak: an end of a table above it cuts off light
PAR: Range = (400.0, 700.0)  # nm: the photosynthetically active photons that PPFD counts


def range_text(limits: Range) -> str:
    """Return a range of wavelengths [nm] as text."""
    low, high = limits
    if limits == WHOLE:
        return "all wavelengths"
    if high == math.inf:
        return f"from {low:.6g} nm"
    return f"{low if low > SHORTEST else 0:.6g}-{high:.6g} nm"


OUTSIDE = f"is outside {range_text(PAR)}, the range of PPFD"


class Spectrum:
    """Watts per nanometre over wavelength [nm]; relative unless `absolute` names a quantity.

    `reading` is the assumption on a file's values.  `limits` is the default range for watts,
    `known` the range of the data, and `is_whole` is true if the light has nothing beyond it.  No
    light has a wavelength above `longest`.  `left_out` is a note on watts beyond the default range.
    """

    absolute = ""
    reading = ""
    known = WHOLE
    is_whole = True
    longest = math.inf
    left_out = ""
    widest_step = 0.0  # nm, between the points of a table from 380 nm to 780 nm

    def __init__(self, label: str, limits: Range, notes: tuple[str, ...] = ()) -> None:
        self.label = label
        self.limits = limits
        self.notes = notes
        self._moments: dict[tuple[float, int, float], Sequence[float]] = {}

    @property
    def described(self) -> str:
        return f"spectrum {self.label}" + (f", {self.reading}" if self.reading else "")

    def power(self, limits: Range) -> float:
        """Return the watts between two wavelengths."""
        raise NotImplementedError

    def moments(self, start: float, count: int, step: float = 1.0) -> Sequence[float]:
        """Return the weights at `count` points, 1 nm apart; see `integrals.moments`."""
        key = start, count, step
        if key not in self._moments:
            weights = self.find_moments(*key)
            self._moments[key] = array("d", weights)  # small: there may be many spectra
        return self._moments[key]

    def find_moments(self, start: float, count: int, step: float) -> Sequence[float]:
        raise NotImplementedError

    def weigh(self, start: float, weights: Sequence[float], step: float = 1.0) -> float:
        """Return the watts weighted by a table at every nanometre, or other step, from `start`."""
        total: float = sum(map(mul, self.moments(start, len(weights), step), weights))
        return total

    def seen(self, observer: Observer) -> float:
        """Return the watts weighted by an observer's relative luminous efficiency."""
        return self.weigh(observer.start, observer.values)

    def lumens(self, observer: Observer) -> float:
        return observer.maximum * self.seen(observer)

    def photons(self, limits: Range) -> float:
        """Return the photons per second between two wavelengths."""
        raise NotImplementedError

    def part(self, limits: Range) -> "Spectrum | None":
        """Return the part between two wavelengths, or None if it is empty."""
        raise NotImplementedError

    def total(self) -> float:
        return self.power(WHOLE)

    def peak(self) -> tuple[float, float | None]:
        """Return the wavelength [nm] of the peak in watts per nanometre, and the width at half."""
        raise NotImplementedError

    @property
    def counts_all_photons(self) -> bool:
        """Return whether photons of all wavelengths count by default, not 400 nm to 700 nm only."""
        return False


class Table(Spectrum):
    """A spectrum given by points, linear between them and 0 outside."""

    def __init__(
        self,
        label: str,
        grid: Sequence[float],
        values: Sequence[float],
        limits: Range = WHOLE,
        notes: tuple[str, ...] = (),
        absolute: str = "",
        is_whole: bool = False,
        left_out: str = "",
    ) -> None:
        """Watts are counted over all data unless `limits` are given."""
        self.known = float(grid[0]), float(grid[-1])
        self.longest = self.known[1]
        self.is_whole = is_whole
        if not is_whole and (self.known[0] > PAR[0] or self.known[1] < PAR[1]):
            ends = range_text(self.known)
            notes += (f"the data covers {ends}, not all of the visible {range_text(PAR)}",)
        super().__init__(label, self.known if limits == WHOLE else limits, notes)
        self.grid = frozen(grid)
        self.values = frozen(values)
        self.measured: Sequence[float] = self.grid  # without the points in between
        self.absolute = absolute
        self._left_out = left_out

    @property
    def covered(self) -> Range:
        """The range [nm] of which the light is known, for weights."""
        return self.known

    @property
    def left_out(self) -> str:  # type: ignore[override]
        """Return a note on the watts beyond the default range, from the values at its ends."""
        if self.is_whole or self._left_out:
            return self._left_out
        grid, values = clip(self.grid, self.values, *self.limits)
        top = max(values, default=0.0)
        ends = [
            f"{100 * values[k] / top:.0f} % of its peak at {grid[k]:g} nm"
            for k in (0, -1)
            if top > 0 and values[k] >= NEAR_ZERO * top
        ]
        if not ends:
            return ""
        return f"{self.label} does not end near 0 ({', '.join(ends)}): watts beyond are not counted"

    @property
    def widest_step(self) -> float:  # type: ignore[override]
        inside = [x for x in self.measured if VISIBLE[0] <= x <= VISIBLE[1]]
        return max((b - a for a, b in pairwise(inside)), default=math.inf)

    def part(self, limits: Range) -> Spectrum | None:
        grid, values = clip(self.grid, self.values, *limits)
        return Table(self.label, grid, values, is_whole=True) if grid else None

    def power(self, limits: Range) -> float:
        return integral(self.grid, self.values, *limits)

    def find_moments(self, start: float, count: int, step: float) -> Sequence[float]:
        return moments(self.grid, self.values, start, count, step)

    def photons(self, limits: Range) -> float:
        """Integrate the product with the wavelength exactly."""
        grid, values = clip(self.grid, self.values, *limits)
        return observers.photons(sum(map(moment_between, grid, grid[1:], values, values[1:])) / 6)

    def peak(self) -> tuple[float, float | None]:
        """Measure the width between the half-height crossings next to the peak."""
        grid, values = self.grid, self.values
        top = max(range(len(values)), key=values.__getitem__)
        half = values[top] / 2
        ends = []
        for step in (-1, 1):
            here = top
            while 0 <= here + step < len(values) and values[here + step] > half:
                here += step
            if not 0 <= here + step < len(values):
                return grid[top], None  # the data ends above half height
            a, b = values[here], values[here + step]
            ends.append(grid[here] + (grid[here + step] - grid[here]) * (a - half) / (a - b))
        return grid[top], ends[1] - ends[0]


class Lines(Spectrum):
    """Lines of zero width: wavelengths [nm] and watts."""

    def __init__(self, label: str, lines: Sequence[tuple[float, float]]) -> None:
        notes: tuple[str, ...] = ()
        if any(not PAR[0] <= place <= PAR[1] for place, _ in lines):
            notes = (f"a line {OUTSIDE}; it counts here",)
        super().__init__(label, WHOLE, notes)
        self.lines = lines
        self.longest = max(lines)[0]

    def part(self, limits: Range) -> Spectrum | None:
        inside = self._inside(limits)
        part = Lines(self.label, inside) if inside else None
        if part:
            part.known = limits
        return part

    def _inside(self, limits: Range) -> list[tuple[float, float]]:
        return [line for line in self.lines if limits[0] <= line[0] <= limits[1]]

    def power(self, limits: Range) -> float:
        return sum(watts for _, watts in self._inside(limits))

    def find_moments(self, start: float, count: int, step: float) -> Sequence[float]:
        """Divide a line between the points on both sides of it."""
        weights = [0.0] * count
        for nanometres, watts in self.lines:
            place = (nanometres - start) / step
            if 0 <= place <= count - 1:
                cell = min(int(place), count - 2)
                weights[cell] += watts * (1 - (place - cell))
                weights[cell + 1] += watts * (place - cell)
        return weights

    def peak(self) -> tuple[float, float | None]:
        return max(self.lines, key=lambda line: line[1])[0], None

    def photons(self, limits: Range) -> float:
        return observers.photons(sum(watts * place for place, watts in self._inside(limits)))

    @property
    def counts_all_photons(self) -> bool:
        return True


class BlackBody(Spectrum):
    """A black body of a temperature [K]; its watts are those of a square metre."""

    absolute = "exitance"

    def __init__(self, temperature: float, limits: Range = WHOLE) -> None:
        """The light between the limits, as behind a filter."""
        if not 1 <= temperature <= 1e9:
            raise ConditionError(
                f"a black body of {temperature:g} K is out of range",
                "from 1K to 1e9K",
            )
        super().__init__(f"a black body of {temperature:.6g} K", limits)
        self.temperature = temperature
        self.known = limits

    def part(self, limits: Range) -> Spectrum | None:
        low, high = self._within(limits)
        return BlackBody(self.temperature, (low, high)) if low < high else None

    def _within(self, limits: Range) -> Range:
        low, high = max(limits[0], self.known[0]), min(limits[1], self.known[1])
        return low, max(low, high)

    def power(self, limits: Range) -> float:
        low, high = self._within(limits)
        return observers.exitance(self.temperature, low * 1e-9, high * 1e-9)

    def find_moments(self, start: float, count: int, step: float) -> Sequence[float]:
        """Use Planck's law at every point, linear in between."""
        grid = [float(start + step * i) for i in range(count)]
        exitances = observers.spectral_exitances([1e-9 * x for x in grid], self.temperature)
        weights = [1e-9 * y for y in exitances]
        if self.known != WHOLE:
            grid, weights = clip(grid, weights, *self.known)
            return moments(grid, weights, start, count, step) if grid else [0.0] * count
        weights[0] /= 2
        weights[-1] /= 2
        return [step * weight for weight in weights]

    def peak(self) -> tuple[float, float | None]:
        """Use Wien's law, and the roots of half the peak in x = c2/(lambda T)."""
        scale = observers.C2 / self.temperature * 1e9
        peak, start, end = (scale / x for x in (observers.WIEN_X, *observers.HALF_X[::-1]))
        low, high = self.known
        width = end - start if low <= start and end <= high else None
        return min(max(peak, low), high), width

    def photons(self, limits: Range) -> float:
        low, high = self._within(limits)
        return observers.photon_exitance(self.temperature, low * 1e-9, high * 1e-9)
