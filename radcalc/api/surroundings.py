"""Skies, maps of the sphere, and what else surrounds a place."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Literal

from radcalc.api.calculate import calculate
from radcalc.api.keywords import (
    Amount,
    Direction,
    Observer,
    Pair,
    Projection,
    Sky,
    Surroundings,
    Text,
    Vector,
)
from radcalc.api.quantity import Quantity, is_quantity, quantity, unit_of
from radcalc.api.reading import one_of, read_inputs, refuse_column
from radcalc.api.result import Result
from radcalc.api.spelling import in_python
from radcalc.errors import ConditionError
from radcalc.given import Inputs, refuse_uncertain
from radcalc.quantities.symbols import PROJECTIONS
from radcalc.units.table import resolve

if TYPE_CHECKING:
    from radcalc.calculators.environment import Made, Source


def sky(
    kind: Sky = "overcast",
    *,
    zenith_radiance: Amount = None,
    zenith_luminance: Amount = None,
    zenith_photon_radiance: Amount = None,
    horizontal_irradiance: Amount = None,
    horizontal_illuminance: Amount = None,
    horizontal_photon_irradiance: Amount = None,
    radiance_toward: Amount = None,
    luminance_toward: Amount = None,
    photon_radiance_toward: Amount = None,
    irradiance: Amount = None,
    illuminance: Amount = None,
    photon_irradiance: Amount = None,
    sun_elevation: Amount = None,
    sun_azimuth: Amount = None,
    sun_irradiance: Amount = None,
    sun_illuminance: Amount = None,
    sun_photon_irradiance: Amount = None,
    global_irradiance: Amount = None,
    global_illuminance: Amount = None,
    global_photon_irradiance: Amount = None,
    sun_radiance: Amount = None,
    sun_luminance: Amount = None,
    sun_photon_radiance: Amount = None,
    sun_radius: Amount = None,
    tilt: Amount = None,
    azimuth: Amount = None,
    normal: Vector = None,
    toward: Direction = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Result:
    """The light of the sky, toward a direction, on the ground and on a plane.

    Parameters
    ----------
    kind : str or int
        ``"overcast"`` (the traditional one), ``"uniform"``, ``"intermediate"``, ``"clear"``,
        ``"turbid"``, or a type of the CIE standard general sky, 1 to 15.
    zenith_radiance, zenith_luminance, zenith_photon_radiance : Amount, optional
        The radiance of the sky's zenith. [cd/m2, umol/m2/s/sr]
    horizontal_irradiance, horizontal_illuminance, horizontal_photon_irradiance : Amount, optional
        The irradiance of the ground by the sky, without the sun. [lx, umol/m2/s]
    radiance_toward, luminance_toward, photon_radiance_toward : Amount, optional
        The radiance in a direction (with `toward`). [cd/m2, umol/m2/s/sr]
    irradiance, illuminance, photon_irradiance : Amount, optional
        The irradiance on the receiver. [lx, umol/m2/s]
    sun_elevation : Amount, optional
        Elevation of the sun above the horizon. [deg]
    sun_azimuth : Amount, optional
        Azimuth of the sun, counted as those of the plane and of directions. [deg]
    sun_irradiance, sun_illuminance, sun_photon_irradiance : Amount, optional
        The irradiance by the sun, perpendicular to its rays. [lx, umol/m2/s]
    global_irradiance, global_illuminance, global_photon_irradiance : Amount, optional
        The irradiance of the ground by sky and sun. [lx, umol/m2/s]
    sun_radiance, sun_luminance, sun_photon_radiance : Amount, optional
        The radiance of the sun's disc. [cd/m2, umol/m2/s/sr]
    sun_radius : Amount, optional
        Angular radius of the sun's disc (0.2666 deg). [deg]
    tilt : Amount, optional
        Tilt of a plane from the horizontal: 90deg is a wall. [deg]
    azimuth : Amount, optional
        Azimuth that the plane faces (with `tilt`). [deg]
    normal : Vector, optional
        Where the plane faces, in place of `tilt`: z is up.
    toward : Direction, optional
        Where in the sky: POLAR from the zenith, POLAR,AZIMUTH, or X,Y,Z with Z up.
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
    >>> found = sky("overcast", zenith_luminance="9000 cd/m2", tilt="90 deg")
    >>> print(found.illuminance.round(2))
    8712.39 lux
    """
    given = locals()
    from radcalc.calculators.sky import sky as work_out

    name = str(kind)
    return calculate(
        "sky",
        given,
        lambda inputs: work_out(name, inputs),
        operands={"type": name},
        own=("kind",),
        drawn=name,
    )


def environment(
    source: Surroundings,
    *,
    unit: Text = None,
    projection: Projection | None = None,
    aim: Vector = None,
    channel: Text = None,
    sun_elevation: Amount = None,
    sun_azimuth: Amount = None,
    zenith_radiance: Amount = None,
    zenith_luminance: Amount = None,
    zenith_photon_radiance: Amount = None,
    horizontal_irradiance: Amount = None,
    horizontal_illuminance: Amount = None,
    horizontal_photon_irradiance: Amount = None,
    normal: Vector = None,
    toward: Direction = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Result:
    """What a receiver gets of all that surrounds it: of a map, a sky or an expression.

    Parameters
    ----------
    source : str, path, array or Quantity
        The path of a map (.hdr, .exr, .pfm), ``"sky:overcast"`` or another type, or an expression
        in theta and phi, with a unit of radiance behind a blank.  An array is a map, of the shape
        (height, width) or (height, width, 3), row 0 at the top; of NumPy, or of Dask, which is
        computed a strip of rows at a time.
    unit : Text, optional
        What the map's values are in: cd/m2, W/m2/sr ...; 1 where they are relative.
    projection : Projection, optional
        How a map shows the sphere: latlong (2:1), or mirror-ball or angular, in a square.
    aim : Vector, optional
        What the middle of the map shows (1,0,0).
    channel : Text, optional
        One channel of the map alone (by default the luminance of all of them).
    sun_elevation : Amount, optional
        Elevation of the sun above the horizon. [deg]
    sun_azimuth : Amount, optional
        Azimuth of the sun, from +x towards +y. [deg]
    zenith_radiance, zenith_luminance, zenith_photon_radiance : Amount, optional
        The radiance of the sky's zenith. [cd/m2, umol/m2/s/sr]
    horizontal_irradiance, horizontal_illuminance, horizontal_photon_irradiance : Amount, optional
        The irradiance of the ground by the sky, without the sun. [lx, umol/m2/s]
    normal : Vector, optional
        Where the receiver faces (0,0,1: up).
    toward : Direction, optional
        A direction that light comes from: POLAR from +z, POLAR,AZIMUTH, or X,Y,Z.
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
        What is no map or cannot be read, and what is missing, contradictory, impossible or without
        use.

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
    return _environment(locals())


def irradiance_map(
    source: Surroundings,
    size: Pair = None,
    *,
    unit: Text = None,
    projection: Projection | None = None,
    aim: Vector = None,
    channel: Text = None,
    sun_elevation: Amount = None,
    sun_azimuth: Amount = None,
    zenith_radiance: Amount = None,
    zenith_luminance: Amount = None,
    zenith_photon_radiance: Amount = None,
    horizontal_irradiance: Amount = None,
    horizontal_illuminance: Amount = None,
    horizontal_photon_irradiance: Amount = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
    order: Literal[2] | None = None,
) -> Quantity:
    """The irradiances of receivers that face in all directions, as a latlong map.

    Parameters
    ----------
    source : str, path, array or Quantity
        As of `environment`.  Skies and expressions are sampled, at 1024 x 512 pixels.
    size : sequence of 2 ints, optional
        Width and height of the map that is made, 2:1; 64 x 32 by default.
    unit : Text, optional
        What the map's values are in: cd/m2, W/m2/sr ...; 1 where they are relative.
    projection : Projection, optional
        How a map shows the sphere: latlong (2:1), or mirror-ball or angular, in a square.
    aim : Vector, optional
        What the middle of the map shows (1,0,0).
    channel : Text, optional
        One channel of the map alone (by default the luminance of all of them).
    sun_elevation : Amount, optional
        Elevation of the sun above the horizon. [deg]
    sun_azimuth : Amount, optional
        Azimuth of the sun, from +x towards +y. [deg]
    zenith_radiance, zenith_luminance, zenith_photon_radiance : Amount, optional
        The radiance of the sky's zenith. [cd/m2, umol/m2/s/sr]
    horizontal_irradiance, horizontal_illuminance, horizontal_photon_irradiance : Amount, optional
        The irradiance of the ground by the sky, without the sun. [lx, umol/m2/s]
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
    order : int, optional
        2 for spherical harmonics up to that order; the exact sum over all pixels by default.

    Returns
    -------
    Quantity
        Of the shape (height, width, channels), in lx, W/m2, umol/m2/s or sr; row 0 is the top, and
        the middle the receiver that faces 1,0,0.

    Raises
    ------
    radcalc.RadcalcError
        As of `environment`.

    Examples
    --------
    >>> import numpy
    >>> lit = irradiance_map(numpy.full((32, 64), 3000.0), (16, 8), unit="cd/m2")
    >>> print(lit.shape, lit[0, 0, 0].round(1))
    (8, 16, 1) 9424.8 lux
    """
    given = locals()
    from radcalc.calculators.environment import irradiance_map as work_out

    return _map(given, lambda named, inputs: work_out(named, inputs, order))


def reproject(
    source: Surroundings,
    to: Projection,
    size: Pair = None,
    *,
    unit: Text = None,
    projection: Projection | None = None,
    aim: Vector = None,
    channel: Text = None,
    sun_elevation: Amount = None,
    sun_azimuth: Amount = None,
    zenith_radiance: Amount = None,
    zenith_luminance: Amount = None,
    zenith_photon_radiance: Amount = None,
    horizontal_irradiance: Amount = None,
    horizontal_illuminance: Amount = None,
    horizontal_photon_irradiance: Amount = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Quantity:
    """A map in another projection: each pixel the mean of what it shows, by solid angle.

    Parameters
    ----------
    source : str, path, array or Quantity
        As of `irradiance_map`.
    to : {"latlong", "mirror-ball", "angular"}
        The new projection; its middle shows +x.
    size : sequence of 2 ints, optional
        Width and height of the new map; as high as the source's by default.
    unit : Text, optional
        What the map's values are in: cd/m2, W/m2/sr ...; 1 where they are relative.
    projection : Projection, optional
        How a map shows the sphere: latlong (2:1), or mirror-ball or angular, in a square.
    aim : Vector, optional
        What the middle of the map shows (1,0,0).
    channel : Text, optional
        One channel of the map alone (by default the luminance of all of them).
    sun_elevation : Amount, optional
        Elevation of the sun above the horizon. [deg]
    sun_azimuth : Amount, optional
        Azimuth of the sun, from +x towards +y. [deg]
    zenith_radiance, zenith_luminance, zenith_photon_radiance : Amount, optional
        The radiance of the sky's zenith. [cd/m2, umol/m2/s/sr]
    horizontal_irradiance, horizontal_illuminance, horizontal_photon_irradiance : Amount, optional
        The irradiance of the ground by the sky, without the sun. [lx, umol/m2/s]
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
    Quantity
        Of the shape (height, width, channels), in cd/m2, W/m2/sr, umol/m2/s/sr or 1.

    Raises
    ------
    radcalc.RadcalcError
        As of `environment`.

    Examples
    --------
    >>> print(reproject("sky:uniform", "angular", (64, 64), zenith_luminance="9 cd/m2").max())
    9.0 candela / metre ** 2
    """
    given = locals()
    from radcalc.calculators.environment import reprojection as work_out

    name = one_of(to, PROJECTIONS, "projection")
    return _map(given, lambda named, inputs: work_out(named, inputs, name))


def _environment(given: dict[str, Any]) -> Result:
    from radcalc.calculators.environment import environment as work_out

    source, given = _surroundings(given)
    name = source.named if isinstance(source.named, str) else ""
    return calculate(
        "environment",
        {"source": name, **given},
        lambda inputs: work_out(source, inputs),
        operands={"source": name},
        waits=False,
        drawn=source,
    )


@in_python
def _map(given: dict[str, Any], make: Callable[[Source, Inputs], Made]) -> Quantity:
    """A map that is made of what surrounds a place."""
    source, given = _surroundings(given)
    inputs = read_inputs({n: one for n, one in given.items() if n not in ("order", "to")})
    refuse_uncertain(inputs.values(), "a map")
    made = make(source, inputs)
    return quantity(made.pixels, resolve(made.unit))


def _surroundings(given: Mapping[str, Any]) -> tuple[Source, dict[str, Any]]:
    """What surrounds a place, and what is given with it."""
    from radcalc.calculators.environment import Source
    from radcalc.distributions.environments import picture_of

    given = dict(given)
    source = given.pop("source")
    if isinstance(source, str):
        return Source(source), given
    if isinstance(source, os.PathLike):
        return Source(os.fspath(source), is_path=True), given
    if is_quantity(source):
        if given.get("unit") is not None:
            raise ConditionError("unit is given, and the map has its own", "the same without unit")
        given["unit"] = unit_of(source)
        source = source.magnitude
    refuse_column(source, "the map")
    return Source(picture_of(source)), given
