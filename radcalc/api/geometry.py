"""Directions, solid angles and etendues."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy

from radcalc.answer import Answer
from radcalc.api.calculate import calculate
from radcalc.api.keywords import (
    Amount,
    Interval,
    Number,
    Numbers,
    Observer,
    Pair,
    Points,
    Projection,
    Shape,
    Text,
    Vector,
)
from radcalc.api.reading import in_metres, one_of
from radcalc.api.result import Result
from radcalc.api.spelling import in_python
from radcalc.errors import ConditionError
from radcalc.given import Inputs, read_coordinates, read_point


def solid_angle(
    shape: Shape,
    vertices: Sequence[Vector] = (),
    *,
    half_angle: Amount = None,
    apex_angle: Amount = None,
    projected_solid_angle: Amount = None,
    solid_angle: Amount = None,
    polar: Interval = None,
    azimuth: Interval = None,
    radius: Amount = None,
    diameter: Amount = None,
    width: Amount = None,
    length: Amount = None,
    area: Amount = None,
    distance: Amount = None,
    height: Amount = None,
    offset: Amount = None,
    offset_y: Amount = None,
    corner: bool = False,
    tilt: Amount = None,
    horizontal: Amount = None,
    vertical: Amount = None,
    viewpoint: Vector = None,
    normal: Vector = None,
    size: Pair = None,
    pixel: Pair = None,
    projection: Projection | None = None,
) -> Result:
    """The solid angle of a shape, and its projected solid angle.

    Parameters
    ----------
    shape : {"cone", "zone", "sphere", "disc", "rectangle", "pyramid", "patch", "polygon", ...}
        ``"full"`` and ``"hemisphere"`` take nothing else, a cone one of its angles, a zone `polar`
        and `azimuth` as ``"30deg:60deg"``, a pixel `size`, `pixel` and `projection`.
    vertices : sequence of Vector, optional
        Of a polygon, in order, in any one unit of length.
    half_angle : Amount, optional
        Half angle of a cone, from its axis to its edge. [deg]
    apex_angle : Amount, optional
        Full angle of a cone, from edge to edge. [deg]
    projected_solid_angle : Amount, optional
        Solid angle projected along the cone's axis. [sr]
    solid_angle : Amount, optional
        Solid angle of the cone, or of the sphere. [sr]
    polar : Interval, optional
        Polar angles of a zone, from +z. [deg]
    azimuth : Interval, optional
        Azimuths of a zone (default: all). [deg]
    radius : Amount, optional
        Radius of a sphere, a disc or a round patch. [m]
    diameter : Amount, optional
        Diameter of a sphere, a disc or a round patch. [m]
    width : Amount, optional
        Width of a rectangle, along x. [m]
    length : Amount, optional
        Length of a rectangle, along y. [m]
    area : Amount, optional
        Area of a small patch. [m2]
    distance : Amount, optional
        Straight line to the centre of what is seen. [m]
    height : Amount, optional
        Height above the source's plane, along its axis. [m]
    offset : Amount, optional
        How far aside of the source's axis, along x (with `height`). [m]
    offset_y : Amount, optional
        How far aside of it along y (with `height`). [m]
    corner : bool, optional
        Seen from above a corner of the rectangle.
    tilt : Amount, optional
        Angle by which a patch is turned from the line of sight. [deg]
    horizontal : Amount, optional
        Full angle between the pyramid's left and right face. [deg]
    vertical : Amount, optional
        Full angle between its upper and lower face. [deg]
    viewpoint : Vector, optional
        Where the polygon is seen from (0,0,0).
    normal : Vector, optional
        Normal of the plane projected onto.
    size : Pair, optional
        Width and height of a map, in pixels.
    pixel : Pair, optional
        COLUMN,ROW of a pixel of a map; 0,0 is at the top left.
    projection : Projection, optional
        How a map shows the sphere: latlong (2:1), or mirror-ball or angular, in a square.

    Returns
    -------
    Result
        What was given and what follows, as attributes by the names of ``radcalc -g``.

    Raises
    ------
    radcalc.RadcalcError
        What is missing, contradictory, impossible or without use.

    Examples
    --------
    >>> print(solid_angle("cone", half_angle="30 deg").solid_angle.round(6))
    0.841787 steradian
    >>> octant = solid_angle("polygon", [(1, 0, 0), (0, 1, 0), (0, 0, 1)])
    >>> print(octant.solid_angle.to("deg^2").round(2))
    5156.62 degree ** 2
    """
    given = locals()
    from radcalc.calculators.pixel import pixel as of_pixel
    from radcalc.calculators.solid_angle import ALIASES, NAMES
    from radcalc.calculators.solid_angle import solid_angle as of_shape

    name = one_of(shape, NAMES, "shape")
    name = ALIASES.get(name, name)
    corners = _corners(vertices)
    points = [read_point(one, "the vertex") for one in corners]
    if points and name != "polygon":
        raise ConditionError(f"vertices have no use with a {name}", "the same without vertices")

    def work_out(inputs: Inputs) -> Answer:
        return of_pixel(inputs) if name == "pixel" else of_shape(name, inputs, points)

    return calculate(
        "solid-angle",
        given,
        work_out,
        operands={"shape": name, "vertices": " ".join(corners)},
        intervals=("polar", "azimuth"),
        waits=False,
        singly=True,
    )


def direction(
    vector: Points | None = None,
    *,
    polar: Amount = None,
    elevation: Amount = None,
    azimuth: Amount = None,
    mirror_ball: Numbers = None,
    reflect_at: Vector = None,
    reflect_to: Vector = None,
    on_ball: bool = False,
) -> Result:
    """A direction in spherical coordinates and as a unit vector, or what a mirror makes of it.

    Parameters
    ----------
    vector : Points, optional
        Three lengths, or numbers, in place of angles.
    polar : Amount, optional
        Polar angle, from +z. [deg]
    elevation : Amount, optional
        Elevation above the plane of x and y. [deg]
    azimuth : Amount, optional
        Azimuth, from +x towards +y. [deg]
    mirror_ball : Numbers, optional
        U,V, to the right and up: what a mirror ball shows there, over its radius.
    reflect_at : Vector, optional
        Give the direction's reflection at a mirror of that normal.
    reflect_to : Vector, optional
        Give the normal of the mirror that reflects the direction to there.
    on_ball : bool, optional
        Add where a mirror ball shows the direction: `mirror_ball_u`, `mirror_ball_v`, and `_w`.

    Returns
    -------
    Result
        What was given and what follows, as attributes by the names of ``radcalc -g``.

    Raises
    ------
    radcalc.RadcalcError
        What is missing, contradictory, impossible or without use.

    Examples
    --------
    >>> found = direction((1, 1, 1))
    >>> print(found.polar.round(4), found.azimuth)
    54.7356 degree 45.0 degree
    >>> print(direction(polar="30 deg", azimuth="0 deg", reflect_at=(0, 0, 1)).azimuth)
    180.0 degree
    """
    given = locals()
    return _direction(given)


def etendue(
    *,
    area: Amount = None,
    radius: Amount = None,
    diameter: Amount = None,
    width: Amount = None,
    length: Amount = None,
    tilt: Amount = None,
    half_angle: Amount = None,
    apex_angle: Amount = None,
    na: Number = None,
    f_number: Number = None,
    receiver_area: Amount = None,
    receiver_radius: Amount = None,
    receiver_diameter: Amount = None,
    distance: Amount = None,
    incidence: Amount = None,
    etendue: Amount = None,
    radiance: Amount = None,
    luminance: Amount = None,
    photon_radiance: Amount = None,
    flux: Amount = None,
    radiant_flux: Amount = None,
    luminous_flux: Amount = None,
    photon_flux: Amount = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Result:
    """The etendue of a source and a cone of light, or of a source and a receiver.

    Parameters
    ----------
    area : Amount, optional
        Area of the source. [m2]
    radius : Amount, optional
        Radius of the source. [m]
    diameter : Amount, optional
        Diameter of the source. [m]
    width : Amount, optional
        Width of the source, along x. [m]
    length : Amount, optional
        Length of the source, along y. [m]
    tilt : Amount, optional
        Angle by which the source is turned from the line of sight. [deg]
    half_angle : Amount, optional
        Half angle of a cone, from its axis to its edge. [deg]
    apex_angle : Amount, optional
        Full angle of a cone, from edge to edge. [deg]
    na : Number, optional
        Numerical aperture, in air.
    f_number : Number, optional
        The lens's f-number.
    receiver_area : Amount, optional
        Area of the receiver. [m2]
    receiver_radius : Amount, optional
        Radius of the receiver. [m]
    receiver_diameter : Amount, optional
        Diameter of the receiver. [m]
    distance : Amount, optional
        Straight line to the centre of what is seen. [m]
    incidence : Amount, optional
        Angle between the light and the receiver's normal. [deg]
    etendue : Amount, optional
        Etendue of the beam. [m2 sr]
    radiance, luminance, photon_radiance : Amount, optional
        The uniform radiance of the source. [W/m2/sr, cd/m2, umol/m2/s/sr]
    flux, radiant_flux, luminous_flux, photon_flux : Amount, optional
        The flux of the beam. [W, lm, umol/s]
    wavelength : Amount, optional
        Light of one wavelength (or frequency, wavenumber, photon energy). [nm]
    spectrum : Text, optional
        Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...
    efficacy : Amount, optional
        A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol. [lm/W]
    observer : Observer, optional
        Whose eyes see `wavelength` or `spectrum`.
    range : Text, optional
        Where the watts of `spectrum` are counted.
    photon_range : Text, optional
        Where the photons of `spectrum` are counted (default 400nm:700nm).

    Returns
    -------
    Result
        What was given and what follows, as attributes by the names of ``radcalc -g``.

    Raises
    ------
    radcalc.RadcalcError
        What is missing, contradictory, impossible or without use.

    Examples
    --------
    >>> print(etendue(diameter="200 um", na=0.22).etendue.to("mm^2 sr").round(8))
    0.00477689 millimetre ** 2 * steradian
    """
    given = locals()
    from radcalc.calculators.etendue import etendue as work_out

    return calculate("etendue", given, work_out)


def _corners(vertices: Any) -> list[str]:
    """The vertices of a polygon as texts."""
    try:
        return [one if isinstance(one, str) else ",".join(map(str, one)) for one in vertices]
    except TypeError:
        problem = f"the vertices are of the type {type(vertices).__name__}"
        raise ConditionError(problem, "[(1, 0, 0), (0, 1, 0), (0, 0, 1)]") from None


@in_python
def _direction(given: dict[str, Any]) -> Result:
    from radcalc.calculators.direction import direction as work_out

    vector, place, unit = given["vector"], None, ""
    if isinstance(vector, str):
        place, unit = read_coordinates(vector.split(","))
    elif vector is not None:
        metres, of = in_metres(vector, "a vector", "three numbers, [1, 0, 2]")
        place, unit = tuple(numpy.atleast_1d(metres).tolist()), of.text if of else ""
    if place is not None and (len(place) != 3 or numpy.ndim(place) > 1):
        raise ConditionError("a vector has three coordinates", "[1, 0, 2]")
    others = ("polar", "azimuth", "elevation", "mirror_ball")
    angles = [name for name in others if given[name] is not None]
    if place and angles:
        raise ConditionError(f"a vector and {angles[0]} contradict each other", "one of them")
    told = vector if isinstance(vector, str) else ",".join(map(str, place or ()))
    return calculate(
        "direction",
        given,
        lambda inputs: work_out(inputs, place, unit, given["on_ball"]),
        operands={"vector": told},
        own=("on_ball",),
        waits=False,
        singly=True,
    )
