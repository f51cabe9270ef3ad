"""Scenes of many sources."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy

from radcalc.answer import Value, texts_of
from radcalc.api.arguments import plain, read_inputs, read_points, refuse_arrays
from radcalc.api.functions import of_page
from radcalc.api.keywords import Path, Points, Vector
from radcalc.api.result import Result, Undrawn, of_answer
from radcalc.calculators.scene import Survey
from radcalc.calculators.scene import scene as add_up
from radcalc.distributions.scene import blocks
from radcalc.errors import ConditionError
from radcalc.inputs.given import refuse_uncertain, shown_inputs
from radcalc.inputs.places import IN_METRES
from radcalc.inputs.reading import read


@of_page("scene", without=("grid", "normal"))
def scene(
    sources: Path | Iterable[Mapping[str, Any]],
    points: Points,
    normal: Vector = None,
    *,
    shares: bool = False,
    **given: Any,
) -> Result:
    """Add up the light of many sources at points, and compute its uniformity.

    Parameters
    ----------
    sources : str, path, or list of dicts
        A CSV file with a row for each source, or a dict for each, with the titles of the columns
        of ``radcalc scene`` as keys (``"x"``, ``"x (cm)"``) and texts, quantities or numbers as
        values.
    points : Points, of the shape (n, 3)
        The points, in metres unless they have a unit; a text such as ``"1,2,0.75"`` for one.
    normal : Vector, optional
        The normal of the receivers; up by default.
    shares : bool, optional
        Add the irradiance from each source.

    Returns
    -------
    Result
        `irradiance`, and `share_NAME` of each source if requested, of shape (n,);
        `mean_irradiance`, `minimum_irradiance`, `maximum_irradiance`, `uniformity` (minimum over
        mean) and `minimum_to_maximum`.

    Raises
    ------
    radcalc.RadcalcError
        If a row is not a source (with its column), a point is at a source, or kinds of light
        are not linked.

    Examples
    --------
    >>> lamps = [{"x": x, "y": 0, "z": 2, "intensity": "100 cd"} for x in (0, 0)]
    >>> print(scene(lamps, [[0, 0, 0], [0, 0, 1]]).irradiance)
    [50.0 200.0] lux
    """
    inputs = read_inputs(given)
    refuse_uncertain(inputs.values(), "a scene")
    refuse_arrays(inputs, "the whole scene")
    rows = _rows(sources)
    read_at = read_points(points)
    places = numpy.atleast_2d(numpy.stack(read_at.value, -1))
    facing = None if normal is None else read("normal", normal).value
    notes = () if read_at.unit else (IN_METRES,)
    survey = Survey(add_up(rows, inputs, notes), facing, shares)
    parts = [*survey.at_points(blocks(places))]
    remarks = survey.remarks(with_values=True)
    values = [
        _joined([part.values[k] for part in parts])
        for k, value in enumerate(parts[0].values)
        if value.name not in "xyz"
    ]
    answer = remarks._replace(values=[*values, *remarks.values])
    operands = texts_of({"file": rows if isinstance(rows, str) else ""})
    grid = "the isolux lines of a grid, which `radcalc scene` draws at a shell"
    undrawn = Undrawn("a scene at points has no picture", grid)
    return of_answer("scene", answer, (*operands, *shown_inputs(inputs)), None, undrawn)


def _joined(parts: Sequence[Value]) -> Value:
    return parts[0]._replace(
        si=numpy.concatenate([part.amount for part in parts]),
        reach={
            key: numpy.concatenate([part.reach[key] for part in parts]) for key in parts[0].reach
        },
    )


def _rows(sources: Any) -> str | list[Any]:
    if isinstance(sources, (str, os.PathLike)):
        return os.fspath(sources)
    if not isinstance(sources, Iterable) or isinstance(sources, bytes):
        raise ConditionError(
            f"the sources are not rows, but of the type {type(sources).__name__}",
            "the path of a CSV file, or a list with a dict for each",
        )
    return [
        {key: plain(value) for key, value in source.items()} if isinstance(source, dict) else source
        for source in sources
    ]
