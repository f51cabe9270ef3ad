"""Functions of direction that surround a receiver: skies, expressions, maps of radiances."""

import math
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

import numpy

from radcalc import errors
from radcalc.distributions import sources
from radcalc.distributions.distribution import ALL_AZIMUTHS, ALL_POLAR, Peak, integrated
from radcalc.distributions.sources import Formula
from radcalc.errors import ConditionError, MissingInput, Unused, mention, quote
from radcalc.geometry import models, projections
from radcalc.geometry import models as geometry
from radcalc.geometry.numerics.cubature import Integral
from radcalc.geometry.projections import Vector, View
from radcalc.maths import Number
from radcalc.quantities import KINDS, LUMINOUS, RADIANT, describe, light_dimension
from radcalc.quantities import read as read_light
from radcalc.quantities.symbols import FISHEYE, LATLONG, WHOLE_SPHERE, light_unit
from radcalc.units import NUMBER, Unit
from radcalc.units.table import resolve

if TYPE_CHECKING:
    from radcalc.distributions.maps import RadianceMap
    from radcalc.distributions.maps.pictures import Picture


class Radiances(Protocol):
    """Radiance as a function of the direction that it comes from.

    Attributes
    ----------
    kind : str
        Kind of light: "v" for radiances in cd/m2, "e" for W/m2/sr, "p" for photon/s/m2/sr;
        empty for relative radiances.
    is_axial : bool
        Whether the radiance is known to be the same at every azimuth.
    coverage : float [1]
        Share of the sphere that is covered, by solid angle; the rest is dark.
    """

    @property
    def kind(self) -> str: ...
    @property
    def is_axial(self) -> bool: ...
    @property
    def coverage(self) -> float: ...

    def radiance(self, polar: Number, azimuth: Number) -> Number:
        """Return the radiance [cd/m2, W/m2/sr, photon/s/m2/sr or 1] from directions, 0 or more.

        `polar`, the angle from +z, from 0 to pi, and the azimuth from +x [rad] are broadcast
        together.
        """
        ...

    def irradiance(self, normal: projections.Vector) -> Integral:
        """Return the irradiance [lx, W/m2, photon/s/m2 or sr] of a plane receiver."""
        ...

    def mean(self) -> float:
        """Return the mean radiance, by solid angle, of the covered part."""
        ...

    def peak(self) -> Peak:
        """Return the greatest radiance, and its direction."""
        ...


class FormulaRadiances:
    """Radiances by an expression in theta (polar angle from +z) and phi (azimuth from +x).

    Examples
    --------
    A sky of 3000 cd/m2 gives pi 3000 lx on the ground, and half as much on a wall:

    >>> sky = FormulaRadiances(Formula("3000*(theta < 90*deg)", kind="v"))
    >>> [round(sky.irradiance(n).value, 2) for n in ((0, 0, 1), (1, 0, 0), (0, 0, -1))]
    [9424.78, 4712.39, 0.0]
    """

    coverage = 1.0

    def __init__(self, formula: Formula) -> None:
        self.formula = formula
        self.kind = formula.kind
        self.is_axial = formula.is_axial

    def radiance(self, polar: Number, azimuth: Number) -> Number:
        return self.formula.intensity(polar, azimuth)

    def irradiance(self, normal: projections.Vector) -> Integral:
        forward, left, up = projections.facing(normal)
        is_level = not (forward[0] or forward[1])
        if is_level or self.formula.expression.comparisons:
            return self._in_own_angles(forward, self.formula.is_axial and is_level)
        # about the normal the integrand is smooth: the receiver's horizon does not cross it
        turned = _ReceivedAboutNormal(self.formula, (projections.times(up, -1.0), left, forward))
        return integrated(turned, (0.0, math.pi / 2), ALL_AZIMUTHS, sources.ACCURACY)

    def _in_own_angles(self, normal: projections.Vector, is_axial: bool) -> Integral:
        """Integrate in theta and phi, for which the steps of the expression are known."""
        polar = ALL_POLAR
        if is_axial:
            polar = (0.0, math.pi / 2) if normal[2] > 0 else (math.pi / 2, math.pi)
        steps = self.formula.steps(polar, ALL_AZIMUTHS)
        accuracy = sources.OF_AXIAL if is_axial else sources.ACCURACY
        received = _Received(self.formula, normal, is_axial)
        return integrated(received, polar, ALL_AZIMUTHS, accuracy, steps)

    def mean(self) -> float:
        return self.formula.flux().value / (4 * math.pi)

    def peak(self) -> Peak:
        return self.formula.peak()


class _Received(NamedTuple):
    """The radiance times the cosine of incidence on a receiver."""

    formula: Formula
    normal: projections.Vector
    is_axial: bool

    def intensity(self, theta: Any, phi: Any) -> Any:
        cosine = projections.dot(self.normal, projections.cartesian(theta, phi))
        return self.formula.intensity(theta, phi) * numpy.maximum(cosine, 0.0)


class _ReceivedAboutNormal(NamedTuple):
    """The radiance times the cosine, in angles about the receiver's normal."""

    formula: Formula
    axes: tuple[projections.Vector, projections.Vector, projections.Vector]
    is_axial: bool = False

    def intensity(self, theta: Any, phi: Any) -> Any:
        direction = projections.cartesian(theta, phi)
        polar, azimuth, _ = projections.spherical(
            *projections.from_components(self.axes, direction)
        )
        return self.formula.intensity(polar, azimuth) * direction[2]


class Sky:
    """Radiances of a sky; see the protocol `radcalc.distributions.radiances.Radiances`.

    The sun itself is not included, and below the horizon the radiance is 0.

    Parameters
    ----------
    name : str
        A name or a number in `radcalc.geometry.models.NAMES`.
    sun : tuple of 2 floats [rad], optional
        Polar angle and azimuth of the sun, above the horizon; for skies that depend on it.
    zenith : float [cd/m2, W/m2/sr, photon/s/m2/sr or 1], optional
        Radiance at the zenith; 1 by default.
    kind : str, optional
        "v", "e" or "p"; empty, the default, for relative radiances.

    Raises
    ------
    ConditionError
        If there is no such sky, the sun is below the horizon, or the sky does not depend on it.
    MissingInput
        If the sky depends on the sun, and its position is missing.

    Examples
    --------
    An overcast sky of 9000 cd/m2 at the zenith, on the ground and on a wall:

    >>> sky = Sky("overcast", zenith=9000.0, kind="v")
    >>> [round(sky.irradiance(normal).value, 2) for normal in ((0, 0, 1), (1, 0, 0))]
    [21991.15, 8712.39]
    """

    coverage = 0.5

    def __init__(
        self, name: str, sun: tuple[float, float] | None = None, zenith: float = 1.0, kind: str = ""
    ) -> None:
        self.type = geometry.sky_type(name)
        if self.type.follows_sun and sun is None:
            raise MissingInput(*geometry.MISSING_SUN)
        if sun is not None and not self.type.follows_sun:
            raise Unused(("sun-elevation",), geometry.IS_EVEN.format(name))
        if sun is not None and not 0 <= sun[0] <= math.pi / 2:
            raise ConditionError("the sun is below the horizon", mention("{sun-elevation=40deg}"))
        self.sun, self.zenith, self.kind = sun, zenith, kind
        self.is_axial = not self.type.follows_sun

    def radiance(self, polar: Number, azimuth: Number) -> Number:
        return self.zenith * geometry.relative_luminance(self.type, polar, azimuth, self.sun)

    def irradiance(self, normal: projections.Vector) -> Integral:
        value, error = geometry.projected_sky(self.type, normal, self.sun)
        return Integral(self.zenith * value, self.zenith * error, 0)

    def mean(self) -> float:
        return self.zenith * geometry.mean_sky(self.type, self.sun)[0]

    def peak(self) -> Peak:
        value, polar, azimuth = geometry.brightest(self.type, self.sun)
        return Peak(self.zenith * value, polar, azimuth)


EXAMPLE = "a map (.hdr, .exr, .pfm), sky:overcast, or 'max(cos(theta), 0) cd/m2'"
MAP = sources.path_pattern("hdr|pic|rgbe|exr|pfm")
# Radiance's three channels are in watts.  color.h has the share of each in the brightness, and the
# luminous efficacy of "uniform white light" over the visible spectrum.
RADIANCE = "Radiance, src/common/color.h"
BRIGHTNESS = (0.265, 0.670, 0.065)
EFFICACY = 179.0  # [lm/W]
RADIANCES = {light_dimension(kind, (0, 1, 1), ""): kind for kind in KINDS}


class Environment(NamedTuple):
    """Radiances, with their origin, assumptions and notes.

    A map has the names of its `channels`, and their `weights` in the sum, whose formula and source
    are `luminance` and `reference`.  `efficacy` is the luminous efficacy [lm/W] of its watts, or 0
    if the format does not define it.
    """

    radiances: Radiances
    channels: tuple[str, ...] = ("Y",)
    weights: tuple[float, ...] = (1.0,)
    efficacy: float = 0.0
    luminance: str = ""
    reference: str = ""
    assumptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def is_map(source: str) -> bool:
    """Return whether a text is the name of a file, existing or not, or "-" for standard input."""
    return source == "-" or bool(MAP.search(source)) or os.path.exists(source)


def expression(text: str) -> Environment:
    """Read an expression in theta (polar angle from +z) and phi (azimuth from +x), with its unit.

    Raise a ConditionError or a UnitError for other texts and units.

    >>> round(expression("3000 cd/m2").radiances.mean(), 6)
    3000.0
    """
    if sources.is_unknown_word(text):
        skies = (
            errors.nearest(text.lower(), models.NAMES, 1)
            or models.MEANT.get(text.lower(), "").split()
        )
        problem = f"'{quote(text)}' is not a file, a sky or an expression"
        raise errors.ConditionError(
            problem, EXAMPLE, [errors.correct(text, f"sky:{name}") for name in skies]
        )
    formula = sources.formula_with_unit(text, "radiance", RADIANCES, "cd/m2")
    assumption = f"the radiance is {quote(text)}, with theta from +z and phi from +x towards +y"
    return Environment(
        FormulaRadiances(formula), assumptions=(assumption, *sources.unseen(formula))
    )


def of_picture(
    picture: "Picture",
    unit: Unit | None = None,
    projection: str = "",
    field: float | None = None,
    aim: Vector | None = None,
    channel: str = "",
) -> Environment:
    """Return the environment of a map, with the world direction of its centre (+x by default).

    `unit`, `projection`, `field` [rad] and `channel` are choices of the user.  Raise a
    ConditionError or a MissingInput if one of them is impossible or missing, or the pixels do
    not fit the projection.
    """
    from radcalc.distributions.maps import RadianceMap
    from radcalc.distributions.maps.pictures import BY_REC_709, Y

    map_projection = projection_of(picture, projection)
    view = view_of(picture, map_projection, field)
    factor, kind = unit_of(picture, unit)
    statements, overruled = _file_statements(picture, unit, projection, field)
    alone = list[str]()
    if channel and not picture.is_chosen:
        picture = channel_of(picture, channel)
        if picture.channels != Y:
            alone.append(f"the channel {quote(picture.channels[0])} alone")
    sums = weighted(picture, kind)
    pixels = RadianceMap(
        picture.pixels,
        map_projection,
        aim or picture.aim or projections.FORWARD,
        sums.weights,
        factor,
        kind,
        picture.frame,
        view,
        None if aim else picture.up,
        picture.grain,
    )
    width, height = pixels.size
    assumptions = [f"{projections.name_of_map(map_projection)} of {width} x {height} pixels"]
    if field:
        assumptions[0] += f", {projections.field_text(field)} wide"
    if picture.aim and not aim:
        at = "{:g},{:g},{:g}".format(*picture.aim)
        assumptions[0] += errors.mention(f", with {at} at the centre by its file ({{aim}})")
    elif not aim:
        assumptions[0] += errors.mention(", with +x at the centre ({aim})")
    elif aim[0] == aim[1] == 0:  # the rotation about a vertical axis is open
        assumptions[0] += ", with +y on the left"
    assumptions += statements
    assumptions += [assumption for assumption in picture.assumptions if assumption != BY_REC_709]
    notes = [*picture.notes, *overruled]
    if pixels.coverage < 1:
        covered = f"{100 * pixels.coverage:.3g} % of the sphere"
        notes.append(f"the map covers {covered}; the rest counts as dark")
    return Environment(
        pixels,
        picture.channels,
        sums.weights,
        sums.efficacy,
        sums.formula,
        sums.reference,
        (*assumptions, *alone, *([sums.assumption] if sums.assumption else [])),
        tuple(notes),
    )


def channel_of(picture: "Picture", channel: str) -> "Picture":
    """Return a picture with one channel, in any case; raise a ConditionError without it."""
    names = [name.lower() for name in picture.channels]
    if channel.lower() not in names:
        problem = f"the map has no channel '{quote(channel)}'"
        raise errors.ConditionError(problem, errors.leave_out("channel"))
    place = names.index(channel.lower())
    pixels = picture.pixels[:, :, place : place + 1]
    return picture._replace(
        pixels=pixels, channels=picture.channels[place : place + 1], weights=(1.0,)
    )


def sampled(radiances: Radiances, width: int, height: int) -> "RadianceMap":
    """Sample radiances at the pixel centres of a latlong map.

    >>> from radcalc.distributions.environments import Sky
    >>> round(sampled(Sky("uniform"), 64, 32).irradiance((0, 0, 1)).value, 6)
    3.141593
    """
    import numpy

    from radcalc.distributions.maps import RadianceMap
    from radcalc.geometry.projections import direction_at, middle_of_pixel, spherical

    rows, columns = numpy.mgrid[:height, :width]
    polar, azimuth, _ = spherical(
        *direction_at(LATLONG, *middle_of_pixel(width, height, columns, rows))
    )
    return RadianceMap(radiances.radiance(polar, azimuth), LATLONG, kind=radiances.kind)


def picture_of(pixels: Any) -> "Picture":
    """Return an array as a picture without metadata.

    Its shape is (height, width), with a third dimension for 1 channel or for R, G and B; raise a
    ConditionError for another shape.
    """
    from radcalc.distributions.maps.pictures import REC_709, RGB, Picture, Y

    shape = tuple(getattr(pixels, "shape", ()))
    if len(shape) == 2:
        pixels = pixels[:, :, None]
    elif len(shape) != 3 or shape[2] not in (1, 3):
        hint = "an array of the shape (height, width) or (height, width, 3)"
        raise errors.ConditionError(f"pixels of the shape {quote(str(shape))} are not a map", hint)
    if len(shape) == 3 and shape[2] == 3:
        return Picture(pixels, RGB, REC_709, "array")
    return Picture(pixels, Y, (1.0,), "array")


def _file_statements(
    picture: "Picture", unit: Unit | None, projection: str, field: float | None
) -> tuple[list[str], list[str]]:
    """Return which declarations of the file are used, and which the user overrules."""
    used, overruled = list[str](), list[str]()
    declared = picture.projection
    if picture.view_text:
        declared += f" ({picture.view_text})"
    is_agreed = projection == picture.projection
    if declared and not field and (not projection or (is_agreed and picture.view)):
        used.append(declared)
    elif declared and (field or not is_agreed):
        wide = f", {projections.field_text(field)} wide" if field else ""
        overruled.append(f"{declared}; it is read as {projection or picture.projection}{wide}")
    file_unit = resolve(picture.unit) if picture.unit else None
    if file_unit and not unit:
        used.append(_in(file_unit))
    elif (
        file_unit
        and unit
        and (unit.factor, unit.dimension) != (file_unit.factor, file_unit.dimension)
    ):
        overruled.append(f"{_in(file_unit)}; it is read as {_in(unit)}")
    saying = "according to its file, the map is "
    return (
        [saying + " and ".join(used)] if used else [],
        [saying + difference for difference in overruled],
    )


def _in(unit: Unit) -> str:
    return "relative" if unit.dimension == NUMBER else f"in {quote(unit.text)}"


def unit_of(picture: "Picture", given: Unit | None) -> tuple[float, str]:
    """Return the factor to coherent SI, and the kind of light, of a picture's values.

    A unit given by the user overrules that of the picture.  Raise a MissingInput if there is none,
    and a ConditionError for a unit that is not a unit of radiance.
    """
    file_unit = resolve(picture.unit) if picture.unit else None
    if file_unit and file_unit.dimension not in (NUMBER, *RADIANCES):
        problem = (
            f"the map is in {quote(file_unit.text)} by its file, and that is {describe(file_unit)}"
        )
        raise errors.ConditionError(problem, "a map of radiances")
    unit = given or file_unit
    if unit is None:
        raise errors.MissingInput(
            "the unit of the map is missing",
            errors.mention("{unit=cd/m2}, {unit=W/m2/sr}, or {unit=1} for relative results"),
        )
    if unit.dimension == NUMBER:
        if unit.factor != 1:
            problem = f"{_unit_option(unit)} is not a unit"
            raise errors.ConditionError(problem, errors.mention("{unit=1}"))
        return 1.0, ""
    if unit.dimension not in RADIANCES:
        problem = f"{_unit_option(unit)}: a map has radiances, but that is {describe(unit)}"
        raise errors.ConditionError(problem, _radiance_for(unit))
    return unit.factor, RADIANCES[unit.dimension]


def _unit_option(unit: Unit) -> str:
    return errors.option("unit", quote(unit.text))


def _radiance_for(unit: Unit) -> str:
    """Return the unit of radiance of the same kind of light, or a choice of units."""
    reading = read_light(unit)
    if reading is None or reading.kind not in KINDS:
        return errors.mention("{unit=cd/m2}, {unit=W/m2/sr}, or {unit=1} for relative results")
    return errors.option("unit", light_unit("radiance", reading.kind).replace(" ", "."))


class Weighted(NamedTuple):
    """Weights of a picture's channels in the radiance, and texts for a derivation.

    `efficacy` is the luminous efficacy of the radiance [lm/W], or 0 if it is not defined.
    """

    weights: tuple[float, ...]
    assumption: str = ""
    formula: str = ""
    reference: str = ""
    efficacy: float = 0.0


def weighted(picture: "Picture", kind: str) -> Weighted:
    """Return the weights with which the channels add up to a luminance or radiance.

    Raise a MissingInput if they have no common sum in that kind of light.
    """
    from radcalc.distributions.maps.pictures import REC_709, RGB

    names = picture.channels
    if len(names) == 1:
        return Weighted((1.0,))
    # of a file that declares these primaries, the weights have more digits
    is_709 = numpy.allclose(picture.weights, REC_709, atol=1e-4)
    if kind in ("", LUMINOUS):
        sums = _sum(picture.weights, names)
        assumption, reference = f"the luminance is {sums}", ""
        if is_709:
            assumption, reference = f"{assumption}, of Rec. 709's primaries", "ITU-R BT.709"
        elif names == RGB:
            assumption += ", of the map's primaries"
        return Weighted(picture.weights, assumption, f"L = {sums}", reference)
    # R, G and B are X, Y and Z if only the second has a luminance
    if kind == RADIANT and names == RGB and picture.weights[::2] != (0.0, 0.0):
        weights = BRIGHTNESS if is_709 else picture.weights
        sums = _sum(weights, names)
        primaries = "of Radiance's primaries" if weights == BRIGHTNESS else "of the map's primaries"
        assumption = f"the radiance is {sums}, {primaries}"
        return Weighted(weights, assumption, f"L = {sums}", RADIANCE, EFFICACY)
    problem = f"{', '.join(names)} have no sum that is a radiance in this unit"
    raise errors.MissingInput(problem, errors.option("unit", "cd/m2"))


def _sum(weights: Sequence[float], names: Sequence[str]) -> str:
    return " + ".join(
        f"{weight:.4g} {name}" for weight, name in zip(weights, names, strict=True) if weight
    )


def view_of(picture: "Picture", projection: str, field: float | None) -> View | None:
    """Return the view of a picture of a part of the sphere; a field [rad] given by the user first.

    Raise an Unused or a MissingInput for a field that does not apply, or is missing.
    """
    if projection in WHOLE_SPHERE:
        if field:
            problem = f"to {projections.name_of_map(projection)}, which shows the whole sphere"
            raise errors.Unused(["field"], problem, errors.option("projection", FISHEYE))
        return None
    if field:
        height, width = picture.pixels.shape[:2]
        return projections.view_of_field(
            projection, field, *(picture.frame or (0, 0, width, height))[2:]
        )
    if picture.view and picture.projection == projection:
        return picture.view
    problem = f"the field of view of the {projection} picture is missing"
    raise errors.MissingInput(problem, errors.option("field", "180deg"))


def projection_of(picture: "Picture", given: str) -> str:
    """Return the projection: given by the user, declared by the file, or latlong for a 2:1 picture.

    Raise a MissingInput if there is none.
    """
    from radcalc.distributions.maps.pictures import PARALLEL

    height, width = picture.pixels.shape[:2]
    if picture.frame:
        width, height = picture.frame[2:]
    if not given and picture.projection == PARALLEL:
        raise errors.ConditionError(
            f"the map is a parallel view ({picture.view_text}), which shows a single direction",
            "a picture with another view",
        )
    if given or picture.projection:
        return given or picture.projection
    if projections.has_shape(LATLONG, width, height):
        return LATLONG
    round_ones = [name for name in WHOLE_SPHERE if name != LATLONG]
    if width != height:
        from radcalc.distributions.maps import check_shape

        check_shape(LATLONG, width, height)  # refuses it
    raise errors.MissingInput(
        f"the projection of the map is missing: {width} x {height} pixels fit several",
        [
            *(errors.add("projection", name) for name in round_ones),
            errors.Try((("projection", FISHEYE), ("field", "180deg"))),
        ],
    )
