"""The integral of a function of direction over a part of the sphere, with its error."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy

from radcalc.errors import ConditionError
from radcalc.geometry.numerics.quadrature import gauss

POINTS, FEWER = 10, 7  # of Gauss and Legendre, a side of a cell; of the rule that checks it
FIRST = (4, 8)  # cells in polar angle and azimuth, before all are quartered once
MOST = 100_000  # cells in all
BATCH = 2_000  # cells at a time, which is what bounds the memory
ROUNDING = 1e-14
SAFETY = 2.0  # what a kink may leave beyond the difference of two levels


class Integral(NamedTuple):
    """An integral over solid angle [sr], the estimate of its error, and the cells it took."""

    value: float
    error: float
    cells: int


Function = Callable[[dict[str, Any]], Any]
Interval = tuple[float, float]


class _Grid:
    """Cells that are quartered: their level, and their place among the cells of that level."""

    def __init__(self, function: Function, polar: Interval, azimuth: Interval) -> None:
        self.function, self.start = function, numpy.array([polar[0], azimuth[0]])
        self.width = numpy.array([polar[1] - polar[0], azimuth[1] - azimuth[0]]) / FIRST
        rows, columns = numpy.indices(FIRST)
        self.place = numpy.stack([numpy.zeros(rows.size, int), rows.ravel(), columns.ravel()], 1)
        self.value, self.size, self.error = self._integrate(self.place)

    def quarter(self, split: Any) -> None:
        """Quarter some cells, and neighbours more than twice as large as the quarters.

        A quarter's error is told by how far the four together are from the whole, and by how
        far a rule of fewer points is off in it: by the larger of the two.
        """
        split = self._graded(split)
        whole = self.place[split]
        corners = numpy.array([[0, 0], [0, 1], [1, 0], [1, 1]])
        rows = 2 * whole[:, None, 1:] + corners
        levels = numpy.broadcast_to(whole[:, None, :1] + 1, (*rows.shape[:2], 1))
        place = numpy.concatenate([levels, rows], 2).reshape(-1, 3)
        value, size, rough = self._integrate(place)
        differ = SAFETY * abs(value.reshape(-1, 4).sum(1) - self.value[split]) / 4
        # Next to a singularity one of the two estimates may be small by chance.
        error = numpy.maximum(numpy.repeat(differ, 4), rough)
        keep = numpy.ones(len(self.value), bool)
        keep[split] = False
        self.place = numpy.concatenate([self.place[keep], place])
        self.value = numpy.concatenate([self.value[keep], value])
        self.size = numpy.concatenate([self.size[keep], size])
        self.error = numpy.concatenate([self.error[keep], error])

    def _graded(self, split: Any) -> Any:
        """The cells to quarter, and the coarser ones beside them: a peak may reach into those."""
        cells = {tuple(place): k for k, place in enumerate(self.place.tolist())}
        chosen, todo = set(split.tolist()), list(split.tolist())
        while todo:
            level, row, column = self.place[todo.pop()].tolist()
            columns = FIRST[1] << level
            for i in (row - 1, row, row + 1):
                for j in (column - 1, column, column + 1):
                    coarser = cells.get((level - 1, i // 2, j % columns // 2))
                    if coarser is not None and coarser not in chosen:
                        chosen.add(coarser)
                        todo.append(coarser)
        return numpy.array(sorted(chosen))

    def _integrate(self, place: Any) -> tuple[Any, Any, Any]:
        """For each cell the integral, that of the function's size, and how far two rules differ."""
        parts = []
        for start in range(0, len(place), BATCH):
            cut = place[start : start + BATCH]
            value, size = self._rule(cut, POINTS)
            parts.append((value, size, abs(value - self._rule(cut, FEWER)[0])))
        value, size, differ = (numpy.concatenate(part) for part in zip(*parts, strict=True))
        return value, size, differ

    def _rule(self, place: Any, points: int) -> tuple[Any, Any]:
        half = self.width / 2.0 ** (place[:, :1] + 1)
        middle = self.start + half * (2 * place[:, 1:] + 1)
        nodes, weights = (numpy.array(x) for x in gauss(points))
        theta = (middle[:, :1] + half[:, :1] * nodes)[:, :, None]
        phi = (middle[:, 1:] + half[:, 1:] * nodes)[:, None, :]
        sine = numpy.sin(theta)
        at = {
            "theta": theta,
            "phi": phi,
            "x": sine * numpy.cos(phi),
            "y": sine * numpy.sin(phi),
            "z": numpy.cos(theta),
        }
        with numpy.errstate(all="ignore"):
            values = numpy.broadcast_to(self.function(at), (len(place), points, points))
            area = half[:, :1, None] * half[:, 1:, None] * weights[:, None] * weights * sine
            value, size = (values * area).sum((1, 2)), (abs(values) * area).sum((1, 2))
        if not numpy.isfinite(size).all():
            cell, i, j = numpy.argwhere(~numpy.isfinite(values * area))[0]
            raise ConditionError(
                f"the expression has no value at theta = {theta[cell, i, 0]:.6g}, "
                f"phi = {phi[cell, 0, j]:.6g}",
                "a function that is a finite number everywhere",
            )
        return value, size


def over_directions(
    function: Function, polar: Interval, azimuth: Interval, accuracy: float = 1e-9
) -> Integral:
    """Integrate f(theta, phi, x, y, z) sin(theta) over intervals of polar angle and azimuth [rad].

    A product rule of Gauss and Legendre in cells, which are quartered until the quarters agree
    with the wholes to `accuracy` times the integral of the function's size.  The estimate of
    the error is what they differ by: that of the wholes, which are coarser than the answer.

    Raises
    ------
    ConditionError
        Where the function has no value, or the integral does not converge.
    """
    grid = _Grid(function, polar, azimuth)
    split = numpy.arange(len(grid.value))
    while True:
        grid.quarter(split)
        cells = len(grid.value)
        with numpy.errstate(over="ignore"):
            size = float(grid.size.sum())
        if not math.isfinite(size):
            raise ConditionError("the integral is larger than a number can be", "smaller values")
        error = float(grid.error.sum()) + ROUNDING * size
        if size and error <= accuracy * size:
            return Integral(math.fsum(grid.value), error, cells)
        # Those that matter (without them the rest is within the accuracy); all of them, where
        # a narrow peak may hide between the points.
        order = numpy.argsort(grid.error)
        matters = numpy.cumsum(grid.error[order]) > accuracy * size / 2
        split = order[matters] if size else order
        if cells + 3 * len(split) > MOST:
            raise _not_found(math.fsum(grid.value), error, size, cells)


def _not_found(value: float, error: float, size: float, cells: int) -> ConditionError:
    if not size:
        return ConditionError(
            f"the expression is 0 at all {cells * POINTS**2} points looked at",
            "a part of the sphere where it is not",
        )
    hint = "a function that is finite everywhere, and its parts one by one"
    if error < 1e-2 * size:
        reached = 10.0 ** math.ceil(math.log10(error / size) + 0.1)
        hint = f"an accuracy of {reached:g}, or its parts one by one"
    return ConditionError(
        f"the integral does not converge: {value:.6g} with an error of {error:.2g} after "
        f"{cells} cells",
        hint,
    )


def of_constant(function: Function, solid_angle: float) -> Integral:
    """The integral of what depends on no direction."""
    with numpy.errstate(all="ignore"):
        value = float(function({})) * solid_angle
    if not math.isfinite(value):
        raise ConditionError("the expression has no finite value", "smaller numbers")
    return Integral(value, ROUNDING * abs(value), 0)
