"""Points and diffuse surfaces."""

from __future__ import annotations

from functools import partial
from typing import Any

from radcalc.api.arguments import one_of
from radcalc.api.functions import calculate, of_page
from radcalc.api.keywords import Diffuse, Points
from radcalc.api.result import Result
from radcalc.calculators.lambertian import OPERAND
from radcalc.calculators.lambertian import lambertian as of_surface
from radcalc.calculators.point_source import point_source as of_point
from radcalc.calculators.shapes import SHAPES
from radcalc.calculators.uberlight import uberlight as of_uberlight
from radcalc.errors import MissingInput


@of_page("point-source", amounts=True)
def point_source(*, any_incidence: bool = False, **given: Any) -> Result:
    """
    Parameters
    ----------
    any_incidence : bool, optional
        Compute the incidence instead of taking it as 0.

    Returns
    -------
    Result
        The inputs and results, as attributes with the names of ``radcalc -g``.  If several
        heights or exponents fit, arrays of all the answers.

    Examples
    --------
    >>> lamp = point_source(flux="800 lm", distance=["1 m", "2 m"])
    >>> print(lamp.illuminance.round(3), lamp.intensity.round(3))
    [63.662 15.915] lux 63.662 candela
    >>> print(point_source(distribution="300*max(cos(theta), 0)^2 cd").flux.round(3))
    628.319 lumen
    """
    return calculate("point-source", given, partial(of_point, any_incidence=any_incidence))


@of_page("lambertian", amounts=True)
def lambertian(shape: Diffuse | None = None, **given: Any) -> Result:
    """
    Parameters
    ----------
    shape : {"patch", "disc", "sphere", "rectangle", "plane", "hemisphere"}, optional
        The shape of the source (default: a patch, a flat surface; a radius needs a shape).

    Examples
    --------
    >>> print(lambertian(luminance="100 cd/m2", area="0.1 m2").flux.round(3))
    31.416 lumen
    """
    name = "" if shape is None else one_of(shape, SHAPES, "shape")
    operands = {"shape": name or OPERAND.default}
    return calculate("lambertian", given, partial(of_surface, name), operands)


@of_page("uberlight", amounts=True)
def uberlight(point: Points, **given: Any) -> Result:
    """
    Parameters
    ----------
    point : Points, of the shape (..., 3)
        Texts such as ``"1m,0m,2m"``, lengths, or numbers of metres.  The light is at 0,0,0 and
        shines along +z.

    Examples
    --------
    >>> light = uberlight([[0, 0, 1], [0, 0, 2]], intensity="100 cd", falloff=1)
    >>> print(light.irradiance.round(6), light.attenuation.round(6))
    [100.0 50.0] lux [1.0 0.5] dimensionless
    """
    if point is None:
        raise MissingInput("the point is missing", '"1m,0m,2m", for one point')
    return calculate("uberlight", {"point": point, **given}, of_uberlight)
