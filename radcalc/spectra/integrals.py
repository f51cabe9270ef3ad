"""One plain integral for every spectrum: the trapezoid on the union of two grids.

A spectrum and a weighting are both linear between their points; their product is integrated by
the trapezoid on the union of both grids, and clipped at the limits with a step, not a ramp.
Wavelengths are in nanometres throughout `spectra`.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from math import inf

Grid = Sequence[float]


def clip(grid: Grid, values: Grid, low: float, high: float) -> tuple[list[float], list[float]]:
    """The part of a table between two limits, with interpolated points at the limits."""
    low, high = max(low, grid[0]), min(high, grid[-1])
    if low >= high:
        return [], []
    first, last = bisect_right(grid, low), bisect_left(grid, high)
    inner, inner_values = list(grid[first:last]), list(values[first:last])
    return (
        [low, *inner, high],
        [at(grid, values, low), *inner_values, at(grid, values, high)],
    )


def at(grid: Grid, values: Grid, place: float) -> float:
    """A table's value at a place inside it, linearly interpolated."""
    index = min(max(bisect_right(grid, place) - 1, 0), len(grid) - 2)
    left, right = grid[index], grid[index + 1]
    share = (place - left) / (right - left)
    return values[index] + (values[index + 1] - values[index]) * share


def trapezoid(grid: Grid, values: Grid) -> float:
    """The integral of a table; 0 for an empty one."""
    after = iter(grid), iter(values)
    next(after[0], None), next(after[1], None)
    return 0.5 * sum(
        [(x1 - x0) * (y0 + y1) for x0, y0, x1, y1 in zip(grid, values, *after, strict=False)]
    )


def integral(grid: Grid, values: Grid, low: float = -inf, high: float = inf) -> float:
    """The integral of a table between two limits."""
    if low <= grid[0] and high >= grid[-1]:
        return trapezoid(grid, values)
    return trapezoid(*clip(grid, values, low, high))


def weighted(grid: Grid, values: Grid, start: float, weights: Grid) -> float:
    """The integral of a table times a weighting tabulated at every nanometre from `start`."""
    end = start + len(weights) - 1
    grid, values = clip(grid, values, start, end)
    if not grid:
        return 0.0
    total = 0.0
    last = len(weights) - 2
    x0, y0 = grid[0], values[0]
    cell = min(int(x0 - start), last)
    w0 = weights[cell] + (weights[cell + 1] - weights[cell]) * (x0 - start - cell)
    for x1, y1 in zip(grid, values, strict=True):
        if x1 == x0:
            continue
        rise = (y1 - y0) / (x1 - x0)
        px, py, pw = x0, y0, w0
        edge = start + cell + 1
        while edge < x1:  # the whole nanometres inside this step of the data
            y, w = y0 + rise * (edge - x0), weights[cell + 1]
            total += (edge - px) * (py * pw + y * w)
            px, py, pw = edge, y, w
            cell += 1
            edge += 1
        slope = weights[cell + 1] - weights[cell]
        w1 = weights[cell] + slope * (x1 - start - cell)
        total += (x1 - px) * (py * pw + y1 * w1)
        x0, y0, w0 = x1, y1, w1
        if x1 >= edge and cell < last:
            cell += 1
    return 0.5 * total
