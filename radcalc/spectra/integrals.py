"""The integral of all spectra: the trapezoid rule on the union of two grids.

Spectra and weightings are linear between their points, and cut at the limits by a step, not a ramp.
Wavelengths are in nanometres throughout `spectra`.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from math import inf
from typing import Any

Grid = Sequence[float]


def clip(grid: Grid, values: Grid, low: float, high: float) -> tuple[list[float], list[float]]:
    """Return the part of a table between two limits, with interpolated points at the limits."""
    low, high = max(low, grid[0]), min(high, grid[-1])
    if low >= high:
        return [], []
    first, last = bisect_right(grid, low), bisect_left(grid, high)
    inner, inner_values = list(grid[first:last]), list(values[first:last])
    return ([low, *inner, high], [at(grid, values, low), *inner_values, at(grid, values, high)])


def at(grid: Grid, values: Grid, place: float) -> float:
    """Return a table's value at a place inside it, by linear interpolation."""
    index = min(max(bisect_right(grid, place) - 1, 0), len(grid) - 2)
    left, right = grid[index], grid[index + 1]
    share = (place - left) / (right - left)
    return values[index] + (values[index + 1] - values[index]) * share


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


def moments(grid: Grid, values: Grid, start: float, count: int) -> list[float]:
    """Return the weights whose sum of products with any weighting is its integral over the table.

    The weighting is linear between `count` whole nanometres from `start`.
    """
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
            step = cell + 1 - place
            at_edge = height + rise * step
            half = 0.5 * step
            weights[cell] += half * height * step
            weights[cell + 1] += half * (height * (1 - step) + at_edge)
            cell += 1
            place, height = float(cell), at_edge
        half, share = 0.5 * (end - place), end - cell
        weights[cell] += half * (height * (cell + 1 - place) + y * (1 - share))
        weights[cell + 1] += half * (height * (place - cell) + y * share)
        place, height = end, y
        if end >= cell + 1 and cell < count - 2:
            cell += 1
    return weights
