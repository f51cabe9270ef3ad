"""Integrals of functions of direction over a part of the sphere [sr], with their error.

The module needs NumPy.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy

from radcalc.errors import ConditionError
from radcalc.geometry.numerics import gauss, lobatto

POINTS = 10  # of the Gauss-Legendre rule along each side of a cell
CHECKS = (7, 8)  # points along each side of the Gauss-Lobatto rules that check it
INSIDE = 1e-11  # [1] of half a side: distance of their end points from its ends
FIRST = (8, 16)  # cells in polar angle and azimuth, before all are quartered once
FIRST_OF_AXIAL = (256, 1)  # for axial functions, which are cheaper
GAP = 0.2  # [1] of a side: widest circle in a cell without a point
MOST = [100_000]  # cells in all, unless `at_most` limits them
WORK = 1e10  # largest cost of the function in all: points times the cost of each
DEEPEST = 32  # levels of cells; a function that needs more has a pole
BATCH = 2_000  # cells at a time, to limit the memory
COARSEST_OF_AXIAL = 1e-4  # [1] accuracy
MIDPOINT = numpy.array([0.0]), numpy.array([2.0])  # exact in azimuth for axial functions
ROUNDING = 1e-14  # [1] error of the sums, relative to the integral of the function's size
SAFETY = 2.0  # [1] largest error at a kink over the difference of two levels


class Integral(NamedTuple):
    """An integral over solid angle, its error and its cost.

    Attributes
    ----------
    value : float [unit of the function times sr]
        The integral.
    error : float [as value]
        Estimate of its error, intended as a bound.
    cells : int
        Number of cells; 0 for a constant.

    Examples
    --------
    >>> from radcalc.geometry.numerics.cubature import Integral
    >>> Integral(3.14, 0.01, 128).value
    3.14
    """

    value: float
    error: float
    cells: int


Function = Callable[[dict[str, Any]], Any]
Interval = tuple[float, float]
Rule = tuple[Any, Any]
Steps = tuple[Sequence[float], Sequence[float]]


def _rules() -> tuple[Rule, ...]:
    """Return the rule of the result and the rules that check it, as arrays of nodes and weights.

    The checking rules have points close to the sides of a cell, so they also detect a kink between
    a side and the first Gauss point.  Exactly at the ends a function may have no value
    (1/sin(theta) at a pole), or that of the neighbouring cell.
    """
    answer, *checks = (
        (numpy.array(nodes), numpy.array(weights))
        for nodes, weights in (gauss(POINTS), *map(lobatto, CHECKS))
    )
    for nodes, _ in checks:
        nodes[[0, -1]] *= 1 - INSIDE
    return answer, *checks


class _Grid:
    """Cells that can be quartered: their level, and their place among the cells of that level."""

    def __init__(
        self, function: Function, polar: Interval, azimuth: Interval, is_axial: bool, steps: Steps
    ) -> None:
        self.function = function
        self.rules = _rules()
        first = FIRST_OF_AXIAL if is_axial else FIRST
        # number of parts of each side of a quartered cell, and the parts by rows and columns
        cuts = 2, 1 if is_axial else 2
        self.cuts, self.parts = numpy.array(cuts), numpy.indices(cuts).reshape(2, -1).T
        self.edges = [_edges(*of) for of in zip((polar, azimuth), first, steps, strict=True)]
        self.columns = len(self.edges[1]) - 1
        rows, columns = numpy.indices([len(edges) - 1 for edges in self.edges])
        self.place = numpy.stack([numpy.zeros(rows.size, int), rows.ravel(), columns.ravel()], 1)
        self.value, self.size, self.error = self._integrate(self.place)
        # the position of a step has the rounding error of its angle
        start, end = self._sides(self.place[:, 1:])
        off = numpy.spacing(end) / (end - start) * [len(angles) > 0 for angles in steps]
        with numpy.errstate(all="ignore"):
            self.rounding = float((self.size * off.sum(1)).sum())

    def quarter(self, split: Any) -> None:
        """Quarter some cells, and neighbours more than twice as large as the quarters.

        The error of a quarter is the larger of two differences: of the four quarters from the
        whole, and of the rule from those that check it.
        """
        split = self._graded(split)
        whole = self.place[split]
        count = len(self.parts)
        rows = self.cuts * whole[:, None, 1:] + self.parts
        levels = numpy.broadcast_to(whole[:, None, :1] + 1, (*rows.shape[:2], 1))
        place = numpy.concatenate([levels, rows], 2).reshape(-1, 3)
        value, size, rough = self._integrate(place)
        differ = SAFETY * abs(value.reshape(-1, count).sum(1) - self.value[split]) / count
        # Either estimate may be small by chance in a cell with a kink.
        error = numpy.maximum(numpy.repeat(differ, count), rough)
        keep = numpy.ones(len(self.value), bool)
        keep[split] = False
        self.place = numpy.concatenate([self.place[keep], place])
        self.value = numpy.concatenate([self.value[keep], value])
        self.size = numpy.concatenate([self.size[keep], size])
        self.error = numpy.concatenate([self.error[keep], error])

    def _graded(self, split: Any) -> Any:
        """Add to some cells their coarser neighbours, into which a peak may reach."""
        cells = {tuple(place): k for k, place in enumerate(self.place.tolist())}
        chosen, todo = set(split.tolist()), list(split.tolist())
        while todo:
            level, row, column = self.place[todo.pop()].tolist()
            columns = self.columns * int(self.cuts[1]) ** level
            for i in (row - 1, row, row + 1):
                for j in (column - 1, column, column + 1):
                    place = i // 2, j % columns // int(self.cuts[1])
                    coarser = cells.get((level - 1, *place))
                    if coarser is not None and coarser not in chosen:
                        chosen.add(coarser)
                        todo.append(coarser)
        return numpy.array(sorted(chosen))

    def _integrate(self, place: Any) -> tuple[Any, Any, Any]:
        parts = []
        for start in range(0, len(place), BATCH):
            cut = place[start : start + BATCH]
            (value, size), *checks = (self._rule(cut, *rule) for rule in self.rules)
            differ = numpy.max([abs(value - check) for check, _ in checks], axis=0)
            parts.append((value, size, differ))
        value, size, differ = (numpy.concatenate(part) for part in zip(*parts, strict=True))
        return value, size, differ

    def _sides(self, first: Any) -> tuple[Any, Any]:
        sides = [edges[i] for edges, i in zip(self.edges, first.T, strict=True)]
        ends = [edges[i + 1] for edges, i in zip(self.edges, first.T, strict=True)]
        return numpy.stack(sides, 1), numpy.stack(ends, 1)

    def _rule(self, place: Any, nodes: Any, weights: Any) -> tuple[Any, Any]:
        """Return the integrals of f and of abs(f) over the cells at `place` (n, 3)."""
        count = self.cuts ** place[:, :1]
        first, part = numpy.divmod(place[:, 1:], count)
        start, end = self._sides(first)
        half = (end - start) / 2 / count
        middle = start + half * (2 * part + 1)
        across = (nodes, weights) if self.cuts[1] == 2 else MIDPOINT
        product = numpy.outer(weights, across[1])
        theta = (middle[:, :1] + half[:, :1] * nodes)[:, :, None]
        phi = (middle[:, 1:] + half[:, 1:] * across[0])[:, None, :]
        sine = numpy.sin(theta)
        at = {
            "theta": theta,
            "phi": phi,
            "x": sine * numpy.cos(phi),
            "y": sine * numpy.sin(phi),
            "z": numpy.cos(theta),
        }
        with numpy.errstate(all="ignore"):
            values = numpy.broadcast_to(self.function(at), (len(place), *product.shape))
            area = half[:, :1, None] * half[:, 1:, None] * product * sine
            value, size = (values * area).sum((1, 2)), (abs(values) * area).sum((1, 2))
        if not numpy.isfinite(size).all():
            cell, i, j = numpy.argwhere(~numpy.isfinite(values * area))[0]
            raise ConditionError(
                f"the expression has no value at theta = {theta[cell, i, 0]:.6g}, "
                f"phi = {phi[cell, 0, j]:.6g}",
                "a function that is a finite number everywhere",
            )
        return value, size


def _edges(interval: Interval, count: int, steps: Sequence[float]) -> Any:
    """Return the sides of the first cells, equally wide except at steps."""
    low, high = interval
    inner = [step for step in steps if low < step < high]
    return numpy.union1d(numpy.linspace(low, high, count + 1), inner)


def narrowest(polar: Interval, azimuth: Interval, is_axial: bool = False) -> tuple[float, float]:
    """Return the width from which on a peak is found by `over_directions`.

    Parameters
    ----------
    polar, azimuth, is_axial
        As in `over_directions`.

    Returns
    -------
    tuple of 2 floats [rad]
        Full widths in polar angle and in azimuth; a narrower peak may be missed.

    Examples
    --------
    >>> [round(math.degrees(width), 3) for width in narrowest((0.0, math.pi), (0.0, 2 * math.pi))]
    [2.25, 2.25]
    """
    if is_axial:
        return GAP * (polar[1] - polar[0]) / (2 * FIRST_OF_AXIAL[0]), 0.0
    sides = zip((polar, azimuth), FIRST, strict=True)
    across, along = (GAP * (high - low) / (2 * count) for (low, high), count in sides)
    return across, along


@contextmanager
def at_most(cells: int) -> Iterator[None]:
    """Limit the cells of each integral, so that one that needs more is refused at once.

    Parameters
    ----------
    cells : int
        Largest number of cells.

    Returns
    -------
    context manager
        The limit holds within it.

    Examples
    --------
    >>> with at_most(1):
    ...     MOST[-1]
    1
    """
    MOST.append(cells)
    try:
        yield
    finally:
        MOST.pop()


def over_directions(
    function: Function,
    polar: Interval,
    azimuth: Interval,
    accuracy: float = 1e-9,
    cost: int = 1,
    is_axial: bool = False,
    accepted: float = 0.0,
    steps: Steps = ((), ()),
) -> Integral:
    """Integrate a function of direction over intervals of polar angle and azimuth.

    Parameters
    ----------
    function : callable
        Takes a dict of arrays: "theta" and "phi" [rad], and "x", "y", "z", the components of the
        unit vector [1].  Returns an array of their common shape, or a number.
    polar : tuple of 2 floats [rad]
        Polar angles between which to integrate, from +z, within 0 and pi.
    azimuth : tuple of 2 floats [rad]
        Azimuths between which to integrate, from +x towards +y.
    accuracy : float, optional
        Allowed error, relative to the integral of the function's absolute value; 1e-9 by default.
    cost : int, optional
        Cost of the function at a point, in additions; 1 by default.  It limits the cells.
    is_axial : bool, optional
        Whether the function is the same at every azimuth, so that cells are halved only in the
        polar angle; false by default.
    accepted : float, optional
        Relative error that is accepted if the accuracy is not reached; none by default.
    steps : tuple of 2 sequences of float [rad], optional
        Known polar angles and azimuths of steps or kinks of the function: cells begin there.

    Returns
    -------
    Integral
        Value, estimate of its error, and number of cells.

    Raises
    ------
    ConditionError
        If the function is not a finite number somewhere, the integral overflows, or its error is
        above the accuracy (and the accepted one) after 100 000 cells (fewer for a costly function)
        or 32 halvings.
    Dark
        If the function is 0 at all points.

    Notes
    -----
    ::

        integral of  f(theta, phi) sin(theta)  dtheta dphi

    A product Gauss-Legendre rule of 10 by 10 points in each cell.  The cells with the largest
    errors are quartered until the sum of the errors is within the accuracy.  The error of a cell is
    the largest of three differences: between the four quarters and their whole (twice that), and
    between the rule and the Gauss-Lobatto rules of 7 by 7 and 8 by 8 points.  All are errors of
    rules coarser than that of the result, so the estimate is on the safe side for smooth functions;
    and for a kink or a step anywhere in a cell, one of the three is larger than the actual error
    (``tests/fuzz/integrals.py``).  A peak much narrower than the first cells may fall between their
    points and be missed.

    Examples
    --------
    The integral of the cosine over the hemisphere is its projected solid angle, pi sr:

    >>> import math
    >>> from radcalc.geometry.numerics.cubature import over_directions
    >>> found = over_directions(lambda at: at["z"], (0.0, math.pi / 2), (0.0, 2 * math.pi))
    >>> round(found.value / math.pi, 9), found.error < 1e-8
    (1.0, True)
    """
    if is_axial:  # digits cost little, and with few digits a pole may look like an integral
        accuracy = min(accuracy, COARSEST_OF_AXIAL)
    grid = _Grid(function, polar, azimuth, is_axial, steps)
    most = min(MOST[-1], WORK / (cost * sum(len(nodes) ** 2 for nodes, _ in grid.rules)))
    split = numpy.arange(len(grid.value))
    while True:
        grid.quarter(split)
        cells = len(grid.value)
        with numpy.errstate(over="ignore"):
            size = float(grid.size.sum())
        if not math.isfinite(size):
            raise ConditionError("the integral is too large for a number", "smaller values")
        error = float(grid.error.sum()) + ROUNDING * size + grid.rounding
        if size and error <= accuracy * size:
            return Integral(math.fsum(grid.value), error, cells)
        # Those with the largest errors, so that the rest is within half the accuracy; all of them
        # if a narrow peak may hide between the points.
        order = numpy.argsort(grid.error)
        matters = numpy.cumsum(grid.error[order]) > accuracy * size / 2
        split = order[matters] if size else order
        deepest = int(grid.place[split, 0].max())
        if cells + (len(grid.parts) - 1) * len(split) > most or deepest >= DEEPEST:
            if size and error <= accepted * size:
                return Integral(math.fsum(grid.value), error, cells)
            raise _not_found(math.fsum(grid.value), error, size, cells)


class Dark(ConditionError):
    """The error for a function that is 0 at all points of the cells.

    Parameters
    ----------
    cells : int
        Number of the cells.

    Attributes
    ----------
    message, hint : str
        As in every `ConditionError`.

    Examples
    --------
    >>> try:
    ...     over_directions(lambda at: 0.0 * at["z"], (0.0, 1.0), (0.0, 1.0))
    ... except Dark as error:
    ...     print(error.hint)
    a part of the sphere where it is not
    """

    def __init__(self, cells: int) -> None:
        super().__init__(
            f"the expression is 0 at all points of {cells} cells",
            "a part of the sphere where it is not",
        )


def _not_found(value: float, error: float, size: float, cells: int) -> ConditionError:
    if not size:
        return Dark(cells)
    hint = "a function that is finite everywhere, or integrate its parts separately"
    if error < 1e-2 * size:
        reached = 10.0 ** math.ceil(math.log10(error / size) + 0.1)
        hint = f"an accuracy of {reached:g}, or integrate its parts separately"
    return ConditionError(
        f"the integral does not converge: {value:.6g} with an error of {error:.2g} after "
        f"{cells} cells",
        hint,
    )


def of_constant(function: Function, solid_angle: float) -> Integral:
    """Return the integral of a constant: its value times the solid angle.

    Parameters
    ----------
    function : callable
        Takes an empty dict and returns a number.
    solid_angle : float [sr]
        Solid angle of the integral.

    Returns
    -------
    Integral
        Its error is the rounding error, its number of cells 0.

    Raises
    ------
    ConditionError
        If the value is not a finite number.

    Examples
    --------
    >>> from radcalc.geometry.numerics.cubature import of_constant
    >>> of_constant(lambda at: 3.0, 2.0).value
    6.0
    """
    with numpy.errstate(all="ignore"):
        value = float(function({})) * solid_angle
    if not math.isfinite(value):
        raise ConditionError("the expression has no finite value", "smaller numbers")
    return Integral(value, ROUNDING * abs(value), 0)
