"""Spectra as arrays: a large file, or a whole image of spectra on one grid.

Since a spectrum is linear between its points, its watts, lumens and photons are weighted sums of
its values.  All arrays that support NumPy's protocols are served, Dask arrays included.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from radcalc.errors import ConditionError, quote
from radcalc.spectra.observers import OBSERVERS, photons
from radcalc.spectra.spectrum import WHOLE, Range, Spectrum, Table, moment_between


def product_weights(grid: Any, nodes: Any, heights: Any) -> Any:
    """Return weights w such that w @ S is the integral of S times a table, both piecewise linear.

    Parameters
    ----------
    grid : array of shape (n,)
        Rising wavelengths of the spectrum.
    nodes, heights : arrays of shape (m,)
        The table, 0 outside its range.

    Returns
    -------
    array of shape (n,)
        Weights by the trapezoid rule on the union of both grids.
    """
    union, weights = _trapezoid_weights(grid, nodes)
    return _spread(union, weights * np.interp(union, nodes, heights), grid)


def _trapezoid_weights(grid: Any, nodes: Any) -> tuple[Any, Any]:
    """Return the union of two grids over their common range, and its trapezoid weights."""
    low, high = max(grid[0], nodes[0]), min(grid[-1], nodes[-1])
    if low >= high:
        return np.zeros(0), np.zeros(0)
    inner = np.asarray(nodes)[(nodes > low) & (nodes < high)]
    first, last = np.searchsorted(grid, (low, high))
    part = grid[first : last + 1]
    part = part[(part >= low) & (part <= high)]
    union = np.insert(part, np.searchsorted(part, inner), inner)
    union = np.concatenate(([low], union, [high]))  # a step of zero width changes nothing
    steps = np.diff(union)
    weights = np.zeros(len(union))
    weights[:-1] += steps / 2
    weights[1:] += steps / 2
    return union, weights


def _spread(places: Any, amounts: Any, grid: Any) -> Any:
    """Return amounts at some places, each divided between the adjacent points of a grid."""
    cell = np.clip(np.searchsorted(grid, places, side="right") - 1, 0, len(grid) - 2)
    upper = (places - grid[cell]) / (grid[cell + 1] - grid[cell])
    below = np.bincount(cell, amounts * (1 - upper), minlength=len(grid))
    return below + np.bincount(cell + 1, amounts * upper, minlength=len(grid))


def power_weights(grid: Any, limits: Range = WHOLE) -> Any:
    """Return weights of a spectrum's integral between two wavelengths, as `product_weights`."""
    low, high = max(grid[0], limits[0]), min(grid[-1], limits[1])
    return product_weights(grid, np.array([low, high]), np.ones(2))


class ArrayTable(Table):
    """A spectrum of very many points."""

    def power(self, limits: Range) -> float:
        grid, values = self._part(limits)
        return float(np.trapezoid(values, grid))

    def part(self, limits: Range) -> Spectrum | None:
        grid, values = self._part(limits)
        return ArrayTable(self.label, grid, values, is_whole=True) if len(grid) else None

    def find_moments(self, start: float, count: int, step: float) -> Sequence[float]:
        nodes = start + step * np.arange(count, dtype=float)
        union, weights = _trapezoid_weights(self.grid, nodes)
        heights = np.interp(union, self.grid, self.values)
        moments: list[float] = _spread(union, weights * heights, nodes).tolist()
        return moments

    def photons(self, limits: Range) -> float:
        grid, values = self._part(limits)
        moments = moment_between(grid[:-1], grid[1:], values[:-1], values[1:])
        return photons(float(moments.sum()) / 6)

    def _part(self, limits: Range) -> tuple[Any, Any]:
        grid, values = np.asarray(self.grid), np.asarray(self.values)
        low, high = max(grid[0], limits[0]), min(grid[-1], limits[1])
        if low >= high:
            return np.zeros(0), np.zeros(0)
        inner = (grid > low) & (grid < high)
        ends = np.interp([low, high], grid, values)
        return (
            np.concatenate(([low], grid[inner], [high])),
            np.concatenate((ends[:1], values[inner], ends[1:])),
        )


def _arrays(wavelengths: Any, spectra: Any) -> tuple[Any, Any]:
    """Return wavelengths (n,) and spectra (..., n) as arrays; refuse other shapes."""
    spectra = spectra if hasattr(spectra, "shape") else np.asarray(spectra, dtype=float)
    grid = np.asarray(wavelengths, dtype=float)
    if (
        grid.ndim != 1
        or len(grid) < 2
        or not np.all(np.diff(grid) > 0)
        or not 0 < grid[0] <= grid[-1] < np.inf
    ):
        raise ConditionError("the wavelengths do not rise", "a rising array of two or more [nm]")
    if spectra.shape[-1:] != grid.shape:
        raise ConditionError(
            f"spectra of shape {spectra.shape} do not match {len(grid)} wavelengths",
            "spectra of shape (..., n) for n wavelengths",
        )
    return grid, spectra


def luminous(wavelengths: Any, spectra: Any, observer: str = "photopic") -> Any:
    """Return the lumens of spectra on a common grid.

    Parameters
    ----------
    wavelengths : array of shape (n,)
        Rising wavelengths in standard air [nm].
    spectra : array of shape (..., n)
        Spectral radiant quantity [W/nm, W/m2/nm, W/m2/sr/nm ...].
    observer : str
        One of `radcalc.spectra.observers.OBSERVERS`.

    Returns
    -------
    array of shape (...)
        The luminous quantity [lm, lx, cd/m2 ...].

    Raises
    ------
    radcalc.errors.ConditionError
        If shapes do not match, or wavelengths do not rise.

    Notes
    -----
    .. math:: K_m \\int S(\\lambda) V(\\lambda) d\\lambda

    by the trapezoid rule on the union of both grids; both are linear between their points.

    Examples
    --------
    >>> import numpy as np
    >>> round(float(luminous([554.0, 555.0, 556.0], np.array([0.0, 1.0, 0.0]))), 1)
    683.0
    """
    grid, spectra = _arrays(wavelengths, spectra)
    return spectra @ _luminous_weights(grid, observer)


def _luminous_weights(grid: Any, observer: str) -> Any:
    if observer not in OBSERVERS:
        raise ConditionError(f"unknown observer '{quote(observer)}'", ", ".join(OBSERVERS))
    eye = OBSERVERS[observer]
    nodes = np.arange(eye.start, eye.end + 1, dtype=float)
    return eye.maximum * product_weights(grid, nodes, np.array(eye.values))


def luminous_efficacy(
    wavelengths: Any, spectra: Any, observer: str = "photopic", limits: Range = WHOLE
) -> Any:
    """Return the luminous efficacy of radiation of spectra on a common grid.

    Parameters
    ----------
    wavelengths, spectra, observer
        As in `luminous`.
    limits : (float, float)
        Range of the watts [nm]; the whole grid by default.

    Returns
    -------
    array of shape (...)
        Lumens per watt; NaN for a spectrum without power.

    Raises
    ------
    radcalc.errors.ConditionError
        As in `luminous`.

    Examples
    --------
    >>> import numpy as np
    >>> float(luminous_efficacy([380.0, 780.0], np.ones((2, 2)))[0]) < 683
    True
    """
    grid, spectra = _arrays(wavelengths, spectra)
    if not max(limits[0], grid[0]) < min(limits[1], grid[-1]):
        raise ConditionError(f"the limits {limits} are outside the grid", "limits [nm] in it")
    both = np.stack([_luminous_weights(grid, observer), power_weights(grid, limits)], axis=1)
    counted = spectra @ both  # one pass over the spectra
    return counted[..., 0] / counted[..., 1]
