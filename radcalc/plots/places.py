"""Pictures of a grid of points: contours over a plane, or a curve along a line."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy

from radcalc.answer import Answer
from radcalc.calculators.results import pick
from radcalc.distributions.scene import Axis as Coordinates
from radcalc.errors import UsageError, option
from radcalc.geometry.directions import Vector
from radcalc.inputs.places import AS_GRID
from radcalc.plots.data import Axis, Chart, Field, Mark, Picture, Series

NAMES = "xyz"


class Surveyed(NamedTuple):
    """A grid, the answers for its points in blocks, the sources, and the result to draw."""

    axes: Sequence[Coordinates]
    blocks: Iterable[Answer]
    sources: Sequence[tuple[str, Vector]] = ()
    wanted: str = "irradiance"


def over_grid(survey: Surveyed) -> Picture:
    """Return results at the points of a grid: contours over a plane, or a curve along a line.

    Raise a UsageError if the grid is a point, or has three dimensions.
    """
    long = [k for k, axis in enumerate(survey.axes) if axis.size > 1]
    if not 1 <= len(long) <= 2:
        subject = "a single point" if not long else "a grid in x, y and z"
        problem = f"{subject} has no picture"
        raise UsageError(problem, f"{option('grid')} {AS_GRID}")
    rows = [pick(block.values, survey.wanted) for block in survey.blocks]
    values = numpy.concatenate([row.value for row in rows])
    values = values.reshape([axis.size for axis in survey.axes])
    value = Axis(f"{rows[0].quantity} {rows[0].symbol}".strip(), rows[0].unit)
    lines = [numpy.linspace(axis.start, axis.end, axis.size).tolist() for axis in survey.axes]
    for k, axis in enumerate(survey.axes):
        if axis.start > axis.end:
            lines[k].reverse()
            values = numpy.flip(values, k)
    fixed = [f"{NAMES[k]} = {lines[k][0]:g} m" for k in range(3) if k not in long]
    title = f"{rows[0].quantity} at {', '.join(fixed)}"
    if len(long) == 1:
        (k,) = long
        return Chart(
            title, Axis(NAMES[k], "m"), value, [Series("", lines[k], values.ravel().tolist())]
        )
    i, j = long
    table = values.reshape(len(lines[i]), len(lines[j])).T
    marks = [
        Mark(name, place[i], place[j])
        for name, place in survey.sources
        if lines[i][0] <= place[i] <= lines[i][-1] and lines[j][0] <= place[j] <= lines[j][-1]
    ]
    axes = Axis(NAMES[i], "m"), Axis(NAMES[j], "m")
    return Field(title, *axes, value, lines[i], lines[j], table.tolist(), marks)
