"""Skies, maps of the sphere, and other surroundings of a place."""

from __future__ import annotations

import os
from functools import partial
from typing import Any, Literal

from radcalc.api.calculate import calculate
from radcalc.api.keywords import Pair, Sky, Surroundings
from radcalc.api.pages import of_page
from radcalc.api.quantity import Quantity, is_quantity, quantity, unit_of
from radcalc.api.reading import read_inputs, refuse_column
from radcalc.api.result import Result
from radcalc.calculators import environment as page
from radcalc.calculators.environment import Source
from radcalc.calculators.sky import sky as of_sky
from radcalc.distributions.environments import picture_of
from radcalc.errors import ConditionError
from radcalc.inputs.given import refuse_uncertain
from radcalc.units.table import resolve


@of_page("sky", without=("size",))
def sky(kind: Sky = "overcast", **given: Any) -> Result:
    """
    Parameters
    ----------
    kind : str or int
        ``"overcast"`` (the traditional one), ``"uniform"``, ``"intermediate"``, ``"clear"``,
        ``"turbid"``, or a type of the CIE standard general sky, 1 to 15.

    Examples
    --------
    >>> found = sky("overcast", zenith_luminance="9000 cd/m2", tilt="90 deg")
    >>> print(found.illuminance.round(2))
    8712.39 lux
    """
    name = str(kind)
    return calculate("sky", given, partial(of_sky, name), {"type": name}, drawn=name)


@of_page("environment", without=("size",))
def environment(source: Surroundings, **given: Any) -> Result:
    """
    Parameters
    ----------
    source : str, path, array or Quantity
        The path of a map (.hdr, .exr, .pfm), ``"sky:overcast"`` or another type, or an expression
        in theta and phi, with a unit of radiance after a blank.  An array is a map, of the shape
        (height, width) or (height, width, 3), row 0 at the top; of NumPy, or of Dask, which is
        computed a strip of rows at a time.

    Raises
    ------
    radcalc.RadcalcError
        If a map is invalid or unreadable, or an input is missing, contradictory, out of range or
        unused.

    Examples
    --------
    >>> found = environment("sky:overcast", zenith_luminance="9000 cd/m2")
    >>> print(found.illuminance.round(2))
    21991.15 lux
    >>> import numpy
    >>> room = environment(numpy.full((32, 64), 3000.0), unit="cd/m2", normal=(1, 0, 0))
    >>> print(room.illuminance.round(2))
    9424.78 lux
    """
    around, given = _surroundings(source, given)
    name = around.named if isinstance(around.named, str) else ""
    work_out = partial(page.environment, around)
    operands = {"source": name}
    return calculate("environment", given, work_out, operands, waits=False, drawn=around)


@of_page("environment", without=("normal", "toward", "size"))
def irradiance_map(
    source: Surroundings, size: Pair = None, *, order: Literal[2] | None = None, **given: Any
) -> Quantity:
    """Compute the irradiances of receivers facing every direction, as a latlong map.

    Parameters
    ----------
    source : str, path, array or Quantity
        As in `environment`.  Skies and expressions are sampled, at 1024 x 512 pixels.
    size : sequence of 2 ints, optional
        Width and height of the new map, 2:1; 64 x 32 by default.
    order : int, optional
        2 for spherical harmonics up to that order; the exact sum over all pixels by default.

    Returns
    -------
    Quantity
        An array of shape (height, width, channels), in lx, W/m2, umol/m2/s or sr; row 0 is the
        top, and the middle is the receiver that faces 1,0,0.

    Raises
    ------
    radcalc.RadcalcError
        As in `environment`.

    Examples
    --------
    >>> import numpy
    >>> lit = irradiance_map(numpy.full((32, 64), 3000.0), (16, 8), unit="cd/m2")
    >>> print(lit.shape, lit[0, 0, 0].round(1))
    (8, 16, 1) 9424.8 lux
    """
    around, given = _surroundings(source, {"size": size, **given})
    inputs = read_inputs(given)
    refuse_uncertain(inputs.values(), "a map")
    rendered = page.irradiance_map(around, inputs, order)
    return quantity(rendered.pixels, resolve(rendered.unit))


def _surroundings(source: Any, given: dict[str, Any]) -> tuple[Source, dict[str, Any]]:
    """Return the surroundings and their symbols; a quantity has the unit of its map."""
    if isinstance(source, str):
        return Source(source), given
    if isinstance(source, os.PathLike):
        return Source(os.fspath(source), is_path=True), given
    if is_quantity(source):
        if given.get("unit") is not None:
            raise ConditionError("unit cannot be used with a map that has a unit", "leave out unit")
        given = {**given, "unit": unit_of(source)}
        source = source.magnitude
    refuse_column(source, "the map")
    return Source(picture_of(source)), given
