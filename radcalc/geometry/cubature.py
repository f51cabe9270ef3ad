"""The integral of a function of direction over a part of the sphere, with its error."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy

from radcalc.errors import ConditionError
from radcalc.geometry.quadrature import gauss

COARSE, FINE = 7, 10  # points of the two rules a side of a cell
CELLS = (8, 16)  # to begin with, in polar angle and azimuth
MOST = 100_000  # cells in all
BATCH = 2_000  # cells at a time, which is what bounds the memory
ROUNDING = 1e-14


class Integral(NamedTuple):
    """An integral over solid angle [sr], the bound of its error, and the cells it took."""

    value: float
    error: float
    cells: int


def over_directions(
    function: Callable[[dict[str, Any]], Any],
    polar: tuple[float, float],
    azimuth: tuple[float, float],
    accuracy: float = 1e-9,
) -> Integral:
    """Integrate f(theta, phi, x, y, z) sin(theta) over intervals of polar angle and azimuth [rad].

    Product rules of Gauss and Legendre, of 10 x 10 and of 7 x 7 points, in cells; the cells in
    which the two differ most are quartered until all differences together are below
    `accuracy` times the integral of the function's size.  That sum is the error given: it is
    the coarse rule's, so the fine rule's own is smaller.

    Raises
    ------
    ConditionError
        Where the function has no value, or the integral does not converge.
    """
    edges = [numpy.linspace(*ends, n + 1) for ends, n in zip((polar, azimuth), CELLS, strict=True)]
    low, high = (
        numpy.stack(numpy.meshgrid(edges[0][s], edges[1][s], indexing="ij"), -1).reshape(-1, 2)
        for s in (slice(None, -1), slice(1, None))
    )
    values, errors, sizes = _cells(function, low, high)
    while True:
        size = float(sizes.sum())
        error = float(errors.sum()) + ROUNDING * size
        if size and error <= accuracy * size:
            return Integral(math.fsum(values), error, len(values))
        # Quarter those that matter (without them the rest is within the accuracy); all of
        # them, where a narrow peak may hide between the points.
        order = numpy.argsort(errors)
        split = order[numpy.cumsum(errors[order]) > accuracy * size / 2] if size else order
        if len(values) + 3 * len(split) > MOST:
            if not size:
                raise ConditionError(
                    f"the expression is 0 at all {len(values) * FINE**2} points looked at",
                    "a part of the sphere where it is not",
                )
            raise ConditionError(
                f"the integral does not converge: {math.fsum(values):.6g} with an error of "
                f"{error:.2g} after {len(values)} cells",
                _remedy(error / size),
            )
        middle = (low[split] + high[split]) / 2
        lows, highs = [], []
        for i in (0, 1):
            for j in (0, 1):
                pick = numpy.array([bool(i), bool(j)])
                lows.append(numpy.where(pick, middle, low[split]))
                highs.append(numpy.where(pick, high[split], middle))
        new_low, new_high = numpy.concatenate(lows), numpy.concatenate(highs)
        new = _cells(function, new_low, new_high)
        kept = numpy.ones(len(values), bool)
        kept[split] = False
        values, errors, sizes, low, high = (
            numpy.concatenate([old[kept], added])
            for old, added in zip(
                (values, errors, sizes, low, high), (*new, new_low, new_high), strict=True
            )
        )


def _remedy(error: float) -> str:
    """The next power of ten as an accuracy to ask for, where there is hope of an integral."""
    if not 0 < error < 1e-2:
        return "a function that is finite everywhere, and its parts one by one"
    return f"--accuracy {10.0 ** math.ceil(math.log10(error) + 0.1):g}, or its parts one by one"


def _cells(function: Callable[[dict[str, Any]], Any], low: Any, high: Any) -> tuple[Any, Any, Any]:
    """For each cell: the integral, what the two rules differ by, and that of the size."""
    parts = []
    for start in range(0, len(low), BATCH):
        cut = slice(start, start + BATCH)
        fine, size = _rule(function, low[cut], high[cut], FINE)
        coarse, _ = _rule(function, low[cut], high[cut], COARSE)
        parts.append((fine, abs(fine - coarse), size))
    values, errors, sizes = (numpy.concatenate(part) for part in zip(*parts, strict=True))
    return values, errors, sizes


def _rule(
    function: Callable[[dict[str, Any]], Any], low: Any, high: Any, n: int
) -> tuple[Any, Any]:
    nodes, weights = (numpy.array(x) for x in gauss(n))
    middle, half = (low + high) / 2, (high - low) / 2
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
        values = numpy.broadcast_to(function(at), (len(low), n, n))
    if not numpy.isfinite(values).all():
        cell, i, j = numpy.argwhere(~numpy.isfinite(values))[0]
        raise ConditionError(
            f"the expression has no value at theta = {theta[cell, i, 0]:.6g}, "
            f"phi = {phi[cell, 0, j]:.6g}",
            "a function that is a finite number everywhere",
        )
    area = half[:, :1, None] * half[:, 1:, None] * weights[:, None] * weights * sine
    return (values * area).sum((1, 2)), (abs(values) * area).sum((1, 2))
