"""Directions and solid angles."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy

from radcalc.api.arguments import in_metres, one_of, read_inputs, refuse_arrays, require_texts
from radcalc.api.functions import calculate, of_page
from radcalc.api.keywords import Points, Shape, Vector
from radcalc.api.result import Result
from radcalc.calculators.direction import direction as of_direction
from radcalc.calculators.integrate import BARE, integrand
from radcalc.calculators.integrate import integrate as of_expression
from radcalc.calculators.pages import page_of
from radcalc.calculators.pixel import pixel as of_pixel
from radcalc.calculators.solid_angle import ALIASES, NAMES
from radcalc.calculators.solid_angle import solid_angle as of_shape
from radcalc.errors import ConditionError
from radcalc.inputs.places import read_coordinates, read_point


@of_page("solid-angle")
def solid_angle(shape: Shape, vertices: Sequence[Vector] = (), **given: Any) -> Result:
    """
    Parameters
    ----------
    shape : {"cone", "zone", "sphere", "disc", "rectangle", "pyramid", "patch", "polygon", ...}
        ``"full"`` and ``"hemisphere"`` take nothing else, a cone one of its angles, a zone `polar`
        and `azimuth` as ``"30deg:60deg"``, a pixel `size`, `pixel` and `projection`.
    vertices : sequence of Vector, optional
        The vertices of a polygon, in order, in one unit of length.

    Examples
    --------
    >>> print(solid_angle("cone", half_angle="30 deg").solid_angle.round(6))
    0.841787 steradian
    >>> octant = solid_angle("polygon", [(1, 0, 0), (0, 1, 0), (0, 0, 1)])
    >>> print(octant.solid_angle.to("deg^2").round(2))
    5156.62 degree ** 2
    """
    name = one_of(shape, NAMES, "shape")
    name = ALIASES.get(name, name)
    corners = _corners(vertices)
    points = [read_point(corner, "the vertex") for corner in corners]
    if points and name != "polygon":
        raise ConditionError(f"vertices do not apply to a {name}", "leave out vertices")
    work_out = of_pixel if name == "pixel" else partial(of_shape, name, points=points)
    operands = {"shape": name, "vertices": " ".join(corners)}
    return calculate("solid-angle", given, work_out, operands)


@of_page("integrate")
def integrate(expression: str, *, unit: str = "", **given: Any) -> Result:
    """Integrate a function of direction over a part of the sphere.

    Parameters
    ----------
    expression : str
        In `theta` and `phi`, the polar angle and the azimuth, or `x`, `y`, `z`, the unit vector:
        ``"cos(theta)**2"``.  An angle in it has a unit: ``"exp(-(theta/(10*deg))**2)"``.
    unit : str, optional
        The unit of the expression, of intensity or radiance: ``"cd"``; the integral is then a
        flux, or an irradiance.

    Returns
    -------
    Result
        The `integral` over solid angle, for which the factor sin(theta) is supplied, and a bound of
        its `error`.

    Raises
    ------
    radcalc.RadcalcError
        If the expression is not valid, its integral does not converge, or an input is missing,
        contradictory or out of range.

    Examples
    --------
    >>> print(integrate("cos(theta)", half_angle="90 deg").integral.round(6))
    3.141593 steradian
    """
    require_texts(expression=expression, unit=unit)
    refuse_arrays(read_inputs(given, page_of("integrate").intervals), "an integral")
    of = integrand(unit) if unit else BARE
    work_out = partial(of_expression, expression, of=of)
    operands, drawn = {"expression": expression, "unit": unit}, (expression, unit)
    return calculate("integrate", given, work_out, operands, waits=False, drawn=drawn)


@of_page("direction")
def direction(vector: Points | None = None, *, on_ball: bool = False, **given: Any) -> Result:
    """
    Parameters
    ----------
    vector : Points, optional
        Three lengths or numbers, instead of angles.
    on_ball : bool, optional
        Add its place on a mirror ball: `mirror_ball_u`, `mirror_ball_v`, and `_w`.

    Examples
    --------
    >>> found = direction((1, 1, 1))
    >>> print(found.polar.round(4), found.azimuth)
    54.7356 degree 45.0 degree
    >>> print(direction(polar="30 deg", azimuth="0 deg", reflect_at=(0, 0, 1)).azimuth)
    180.0 degree
    """
    place, unit = _vector(vector)
    angle_names = ("polar", "azimuth", "elevation", "mirror_ball")
    angles = [name for name in angle_names if given.get(name) is not None]
    if place and angles:
        raise ConditionError(f"a vector cannot be used with {angles[0]}", "only one of them")
    text = vector if isinstance(vector, str) else ",".join(map(str, place or ()))
    work_out = partial(of_direction, vector=place, unit=unit, with_ball=on_ball)
    return calculate("direction", given, work_out, {"vector": text})


def _vector(vector: Any) -> tuple[Any, str]:
    """Return three coordinates [SI] and their typed unit; None without a vector."""
    if vector is None:
        return None, ""
    if isinstance(vector, str):
        place, unit = read_coordinates(vector.split(","))
    else:
        metres, of = in_metres(vector, "a vector")
        place, unit = tuple(numpy.atleast_1d(metres).tolist()), of.text if of else ""
    if len(place) != 3 or numpy.ndim(place) > 1:
        raise ConditionError("a vector has three coordinates", "[1, 0, 2]")
    return place, unit


def _corners(vertices: Any) -> list[str]:
    try:
        return [
            vertex if isinstance(vertex, str) else ",".join(map(str, vertex)) for vertex in vertices
        ]
    except TypeError:
        problem = f"the vertices are not points, but of the type {type(vertices).__name__}"
        raise ConditionError(problem, "[(1, 0, 0), (0, 1, 0), (0, 0, 1)]") from None
