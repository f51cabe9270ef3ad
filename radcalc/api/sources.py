"""Points, diffuse surfaces, and scenes of many sources."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from radcalc.answer import Value, texts_of
from radcalc.api.calculate import calculate
from radcalc.api.keywords import (
    Amount,
    Diffuse,
    Direction,
    Distribution,
    Interval,
    Number,
    Numbers,
    Observer,
    Path,
    Points,
    Text,
    Vector,
)
from radcalc.api.quantity import plain
from radcalc.api.reading import one_of, read_inputs, read_points
from radcalc.api.result import Result, Undrawn, of_answer
from radcalc.api.spelling import in_python
from radcalc.errors import ConditionError, option
from radcalc.given import IN_METRES, inputs_of, read, refuse_uncertain
from radcalc.maths import is_array


def point_source(
    *,
    flux: Amount = None,
    radiant_flux: Amount = None,
    luminous_flux: Amount = None,
    photon_flux: Amount = None,
    intensity: Amount = None,
    radiant_intensity: Amount = None,
    luminous_intensity: Amount = None,
    photon_intensity: Amount = None,
    irradiance: Amount = None,
    illuminance: Amount = None,
    photon_irradiance: Amount = None,
    exposure: Amount = None,
    radiant_exposure: Amount = None,
    luminous_exposure: Amount = None,
    photon_exposure: Amount = None,
    energy: Amount = None,
    radiant_energy: Amount = None,
    luminous_energy: Amount = None,
    photon_number: Amount = None,
    peak_intensity: Amount = None,
    peak_radiant_intensity: Amount = None,
    peak_luminous_intensity: Amount = None,
    peak_photon_intensity: Amount = None,
    distribution: Distribution = None,
    isotropic: bool = False,
    hemisphere: bool = False,
    half_angle: Amount = None,
    apex_angle: Amount = None,
    solid_angle: Amount = None,
    exponent: Number = None,
    beam_angle: Amount = None,
    field_angle: Amount = None,
    within: Amount = None,
    toward: Direction = None,
    aim: Vector = None,
    rotate: Amount = None,
    distance: Amount = None,
    height: Amount = None,
    offset: Amount = None,
    offset_y: Amount = None,
    incidence: Amount = None,
    receiver_area: Amount = None,
    time: Amount = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
    any_incidence: bool = False,
) -> Result:
    """Everything that follows for a source that is small beside its distance.

    Parameters
    ----------
    flux, radiant_flux, luminous_flux, photon_flux : Amount, optional
        All the flux. [W, lm, umol/s]
    intensity, radiant_intensity, luminous_intensity, photon_intensity : Amount, optional
        The intensity on the source's axis. [W/sr, cd, umol/s/sr]
    irradiance, illuminance, photon_irradiance : Amount, optional
        The irradiance on the receiver. [W/m2, lx, umol/m2/s]
    exposure, radiant_exposure, luminous_exposure, photon_exposure : Amount, optional
        The exposure of the receiver (with `time`). [J/m2, lx s, umol/m2]
    energy, radiant_energy, luminous_energy, photon_number : Amount, optional
        All the energy (with `time`). [J, lm s, umol]
    peak_intensity : Amount, optional
        The greatest intensity in any direction. [W/sr, cd, umol/s/sr]
    peak_radiant_intensity, peak_luminous_intensity, peak_photon_intensity : Amount, optional
        The same of one kind.
    distribution : Distribution, optional
        How the light is spread: isotropic (unless an option of a cone or a lobe is given), cone,
        lobe, a file (IES, EULUMDAT, CSV), or 'EXPRESSION cd' in theta and phi.
    isotropic : bool, optional
        Uniform in all directions, over 4 pi sr.
    hemisphere : bool, optional
        Uniform over a hemisphere.
    half_angle : Amount, optional
        Half angle of a cone, from its axis to its edge. [deg]
    apex_angle : Amount, optional
        Full angle of a cone, from edge to edge. [deg]
    solid_angle : Amount, optional
        Solid angle of a uniform cone. [sr]
    exponent : Number, optional
        Exponent of a cosine-power lobe.
    beam_angle : Amount, optional
        Full angle of a lobe, where half the peak is left. [deg]
    field_angle : Amount, optional
        Full angle of a lobe, where a tenth of it is left. [deg]
    within : Amount, optional
        Half angle within which the flux is wanted. [deg]
    toward : Direction, optional
        A direction from the source, in which the receiver is: POLAR from its axis, POLAR,AZIMUTH,
        or X,Y,Z with Z along the axis.
    aim : Vector, optional
        Where the source's axis points; straight down is 0,0,-1.
    rotate : Amount, optional
        Angle by which the source is turned about its axis, C0 from +x towards +y. [deg]
    distance : Amount, optional
        Straight line from the source to the receiver. [m]
    height : Amount, optional
        Height of the source above the receiver's plane, along its axis. [m]
    offset : Amount, optional
        How far aside of the source's axis, along x (with `height`). [m]
    offset_y : Amount, optional
        How far aside of it along y (with `height`). [m]
    incidence : Amount, optional
        Angle between the light and the receiver's normal. [deg]
    receiver_area : Amount, optional
        Area of the receiver. [m2]
    time : Amount, optional
        How long the light is constant. [s]
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
    any_incidence : bool, optional
        Work out the incidence, in place of taking it as 0.

    Returns
    -------
    Result
        What was given and what follows, as attributes by the names of ``radcalc -g``.  Where
        several heights or exponents fit, arrays of all the answers.

    Raises
    ------
    radcalc.RadcalcError
        What is missing, contradictory, impossible or without use.

    Examples
    --------
    >>> lamp = point_source(flux="800 lm", distance=["1 m", "2 m"])
    >>> print(lamp.illuminance.round(3), lamp.intensity.round(3))
    [63.662 15.915] lux 63.662 candela
    >>> print(point_source(distribution="300*max(cos(theta), 0)^2 cd").flux.round(3))
    628.319 lumen
    """
    given = locals()
    from radcalc.calculators.point_source import point_source as work_out

    return calculate(
        "point-source",
        given,
        lambda inputs: work_out(inputs, any_incidence),
        own=("any_incidence",),
    )


def lambertian(
    shape: Diffuse = "patch",
    *,
    radiance: Amount = None,
    luminance: Amount = None,
    photon_radiance: Amount = None,
    exitance: Amount = None,
    radiant_exitance: Amount = None,
    luminous_exitance: Amount = None,
    photon_exitance: Amount = None,
    flux: Amount = None,
    radiant_flux: Amount = None,
    luminous_flux: Amount = None,
    photon_flux: Amount = None,
    intensity: Amount = None,
    radiant_intensity: Amount = None,
    luminous_intensity: Amount = None,
    photon_intensity: Amount = None,
    irradiance: Amount = None,
    illuminance: Amount = None,
    photon_irradiance: Amount = None,
    incident_irradiance: Amount = None,
    incident_illuminance: Amount = None,
    incident_photon_irradiance: Amount = None,
    exposure: Amount = None,
    radiant_exposure: Amount = None,
    luminous_exposure: Amount = None,
    photon_exposure: Amount = None,
    energy: Amount = None,
    radiant_energy: Amount = None,
    luminous_energy: Amount = None,
    photon_number: Amount = None,
    reflectance: Number = None,
    time: Amount = None,
    area: Amount = None,
    radius: Amount = None,
    diameter: Amount = None,
    width: Amount = None,
    length: Amount = None,
    tilt: Amount = None,
    half_angle: Amount = None,
    distance: Amount = None,
    height: Amount = None,
    offset: Amount = None,
    offset_y: Amount = None,
    corner: bool = False,
    incidence: Amount = None,
    perpendicular: bool = False,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Result:
    """Everything that follows for a diffuse source or reflector, exactly at any distance.

    Parameters
    ----------
    shape : {"patch", "disc", "sphere", "rectangle", "plane", "hemisphere"}
        The shape of the source.
    radiance, luminance, photon_radiance : Amount, optional
        The uniform radiance of the source. [W/m2/sr, cd/m2, umol/m2/s/sr]
    exitance, radiant_exitance, luminous_exitance, photon_exitance : Amount, optional
        The exitance of the source. [W/m2, lm/m2, umol/m2/s]
    flux, radiant_flux, luminous_flux, photon_flux : Amount, optional
        All the flux. [W, lm, umol/s]
    intensity, radiant_intensity, luminous_intensity, photon_intensity : Amount, optional
        The intensity on the source's axis. [W/sr, cd, umol/s/sr]
    irradiance, illuminance, photon_irradiance : Amount, optional
        The irradiance on the receiver. [W/m2, lx, umol/m2/s]
    incident_irradiance, incident_illuminance, incident_photon_irradiance : Amount, optional
        The irradiance on the reflector (with `reflectance`). [W/m2, lx, umol/m2/s]
    exposure, radiant_exposure, luminous_exposure, photon_exposure : Amount, optional
        The exposure of the receiver (with `time`). [J/m2, lx s, umol/m2]
    energy, radiant_energy, luminous_energy, photon_number : Amount, optional
        All the energy (with `time`). [J, lm s, umol]
    reflectance : Number, optional
        Reflectance of the reflector, 0 to 1 or in %.
    time : Amount, optional
        How long the light is constant. [s]
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
        Half angle of the part of a hemisphere that shines, about its zenith. [deg]
    distance : Amount, optional
        Straight line to the centre of what is seen. [m]
    height : Amount, optional
        Height above the source's plane, along its axis. [m]
    offset : Amount, optional
        How far aside of the source's axis, along x (with `height`). [m]
    offset_y : Amount, optional
        How far aside of it along y (with `height`). [m]
    corner : bool, optional
        The receiver is under a corner of the rectangle.
    incidence : Amount, optional
        Angle between the light and the receiver's normal. [deg]
    perpendicular : bool, optional
        Its normal runs along the rectangle's length.
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
    >>> print(lambertian(luminance="100 cd/m2", area="0.1 m2").flux.round(3))
    31.416 lumen
    """
    given = locals()
    from radcalc.calculators.lambertian import lambertian as work_out
    from radcalc.calculators.shapes import SHAPES

    name = one_of(shape, SHAPES, "shape")
    return calculate(
        "lambertian", given, lambda inputs: work_out(name, inputs), operands={"shape": name}
    )


def uberlight(
    point: Points,
    *,
    intensity: Amount = None,
    radiant_intensity: Amount = None,
    luminous_intensity: Amount = None,
    photon_intensity: Amount = None,
    irradiance: Amount = None,
    illuminance: Amount = None,
    photon_irradiance: Amount = None,
    omni: bool = False,
    falloff: Number = None,
    falloff_distance: Amount = None,
    maximum: Number = None,
    near: Interval = None,
    far: Interval = None,
    superellipse: Numbers = None,
    roundness: Number = None,
    shear: Numbers = None,
    beam_exponent: Number = None,
    normal: Vector = None,
    incidence: Amount = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Result:
    """What a cinematographer's light sends to points, and how much each setting attenuates it.

    Parameters
    ----------
    point : Points, of the shape (..., 3)
        Texts such as ``"1m,0m,2m"``, lengths, or numbers of metres.  The light is at 0,0,0 and
        shines along +z.
    intensity, radiant_intensity, luminous_intensity, photon_intensity : Amount, optional
        The intensity on the source's axis. [W/sr, cd, umol/s/sr]
    irradiance, illuminance, photon_irradiance : Amount, optional
        The irradiance on the receiver. [W/m2, lx, umol/m2/s]
    omni : bool, optional
        It shines everywhere, and depths are distances from it.
    falloff : Number, optional
        How it falls off with the distance d: as (L/d)^N (2, the inverse square).
    falloff_distance : Amount, optional
        The distance L at which that is 1 (1 m). [m]
    maximum : Number, optional
        What it is held to next to the light, over that at `falloff_distance` (no maximum).
    near : Interval, optional
        Dark up to A, full from B on, smooth between. [m]
    far : Interval, optional
        Full up to C, dark from D on, smooth between. [m]
    superellipse : Numbers, optional
        a,b,A,B: half width and height, over z, within which it is full, and beyond which dark.
    roundness : Number, optional
        Of `superellipse`: 0 a rectangle, 1 an ellipse (1).
    shear : Numbers, optional
        X,Y: how far aside its centre is, over z (0,0).
    beam_exponent : Number, optional
        Times (z/d)^n: how it falls off aside of the axis (0).
    normal : Vector, optional
        Normal of the receiver (it faces the light).
    incidence : Amount, optional
        Angle between the light and the receiver's normal. [deg]
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
    >>> light = uberlight([[0, 0, 1], [0, 0, 2]], intensity="100 cd", falloff=1)
    >>> print(light.irradiance.round(6), light.attenuation.round(6))
    [100.0 50.0] lux [1.0 0.5] dimensionless
    """
    given = locals()
    from radcalc.calculators.uberlight import uberlight as work_out

    return calculate("uberlight", given, work_out)


def scene(
    sources: Path | Iterable[Mapping[str, Any]],
    points: Points,
    normal: Vector = None,
    *,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
    shares: bool = False,
) -> Result:
    """What many sources give together at points, and how even that is.

    Parameters
    ----------
    sources : str, path, or list of dicts
        A CSV file with a row for each source, or a dict for each, with the titles of the columns
        of ``radcalc scene`` as keys (``"x"``, ``"x (cm)"``) and texts, quantities or numbers as
        values.
    points : Points, of the shape (n, 3)
        The points, in metres unless they have a unit; a text such as ``"1,2,0.75"`` for one.
    normal : Vector, optional
        Where the receivers face; up by default.
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
    shares : bool, optional
        Whether to give the irradiance by each source too.

    Returns
    -------
    Result
        `irradiance`, and `share_NAME` of each source where it is asked for, of shape (n,);
        `mean_irradiance`, `minimum_irradiance`, `maximum_irradiance`, `uniformity` (minimum over
        mean) and `minimum_to_maximum`.

    Raises
    ------
    radcalc.RadcalcError
        A row that is no source, with its column; a point at a source; kinds of light that
        nothing links.

    Examples
    --------
    >>> lamps = [{"x": x, "y": 0, "z": 2, "intensity": "100 cd"} for x in (0, 0)]
    >>> print(scene(lamps, [[0, 0, 0], [0, 0, 1]]).irradiance)
    [50.0 200.0] lux
    """
    return _scene(locals())


@in_python
def _scene(given: dict[str, Any]) -> Result:
    import numpy

    from radcalc.calculators import scene as page
    from radcalc.distributions.scene import blocks

    own = ("sources", "points", "normal", "shares")
    sources, points, normal, shares = (given[name] for name in own)
    inputs = read_inputs({name: one for name, one in given.items() if name not in own})
    refuse_uncertain(inputs.values(), "a scene")
    for one in inputs.values():
        if is_array(one.value):
            raise ConditionError(f"{option(one.name)} is an array", "one value for the whole scene")
    if isinstance(sources, os.PathLike):
        sources = os.fspath(sources)
    elif isinstance(sources, Iterable) and not isinstance(sources, (str, bytes)):
        sources = [_row(source) for source in sources]
    elif not isinstance(sources, str):
        raise ConditionError(
            f"the sources are of the type {type(sources).__name__}",
            "the path of a CSV file, or a list with a dict for each",
        )
    read_at = read_points(points)
    places = numpy.atleast_2d(numpy.stack(read_at.value, -1))
    facing = None if normal is None else read("normal", normal).value
    said = () if read_at.unit else (IN_METRES,)
    survey = page.Survey(page.scene(sources, inputs, said), facing, shares)
    parts = [*survey.at_points(blocks(places))]
    remarks = survey.remarks(with_values=True)
    values = [
        _joined([part.values[k] for part in parts])
        for k, one in enumerate(parts[0].values)
        if one.name not in "xyz"
    ]
    answer = remarks._replace(values=[*values, *remarks.values])
    told = texts_of({"file": sources if isinstance(sources, str) else ""})
    grid = "the isolux lines of a grid, which `radcalc scene` draws at a shell"
    undrawn = Undrawn("a scene at points has no picture", grid)
    return of_answer("scene", answer, (*told, *inputs_of(inputs)), None, undrawn)


def _joined(parts: Sequence[Value]) -> Value:
    """The values of blocks of points as one."""
    import numpy

    return parts[0]._replace(
        si=numpy.concatenate([part.amount for part in parts]),
        reach={
            key: numpy.concatenate([part.reach[key] for part in parts]) for key in parts[0].reach
        },
    )


def _row(source: Any) -> Any:
    """A row of a scene, whose quantities are numbers with units."""
    if not isinstance(source, dict):
        return source
    return {key: plain(value) for key, value in source.items()}
