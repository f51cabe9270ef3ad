"""Pictures of light in space: polar diagrams, fisheye views, plans of a grid, integrands."""

import math
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy

from radcalc import plots
from radcalc.answer import Answer, format_angle
from radcalc.calculators.environment import Source, surroundings
from radcalc.calculators.point_laws import spread
from radcalc.calculators.results import name_of, pick
from radcalc.calculators.sky import place_of_sun
from radcalc.calculators.uncertainty import STANDARD
from radcalc.distributions.distribution import ALL_AZIMUTHS, Distribution
from radcalc.distributions.environments import Radiances, Sky
from radcalc.distributions.maps import RadianceMap
from radcalc.distributions.scene import Axis as Coordinates
from radcalc.distributions.sources import of_shape
from radcalc.errors import UsageError, option
from radcalc.geometry import projections
from radcalc.geometry.models import sky_type
from radcalc.geometry.numerics.expression import Expression
from radcalc.inputs.places import AS_GRID
from radcalc.inputs.sun import located
from radcalc.maths import is_uncertain
from radcalc.plots.curves import Solved, without_band
from radcalc.quantities.symbols import SYMBOLS, light_unit, specific_name
from radcalc.units.table import resolve

PLANES = (("C0-C180", 0.0), ("C90-C270", math.pi / 2))
EVERY_PLANE = "every C plane"
HALVES = 721  # angles of a plane, from -180 deg to 180 deg
PIXELS = 181  # of a disc, along each side
POLARS, AZIMUTHS = 361, 72  # samples of an integrand
FEW = 4  # azimuths at which an integrand is drawn
STRENGTHS = ("peak-intensity", "intensity")
RELATIVE = plots.Axis("relative intensity")
NAMES = "xyz"


def polar(
    distribution: Distribution,
    factor: float,
    radius: plots.Axis,
    title: str = "",
    ends: tuple[float, float] | None = None,
) -> plots.Polar:
    """Return the polar diagram of a distribution: the planes C0-C180 and C90-C270.

    `factor` converts the intensities to the unit of the radius; `ends` are those of an uncertain
    factor.
    """
    angles = numpy.linspace(-180.0, 180.0, HALVES)
    theta = numpy.radians(numpy.abs(angles))
    planes = []
    for label, azimuth in PLANES[: 1 if distribution.is_axial else 2]:
        phi = numpy.where(angles < 0, azimuth + math.pi, azimuth)
        values = numpy.broadcast_to(distribution.intensity(theta, phi), phi.shape)
        name = EVERY_PLANE if distribution.is_axial else label
        band = ((ends[0] * values).tolist(), (ends[1] * values).tolist()) if ends else None
        planes.append(plots.Plane(name, angles.tolist(), (factor * values).tolist(), band))
    return plots.Polar(title, radius, planes)


def of_point_source(solved: Solved, wanted: Sequence[str] = ()) -> plots.Polar:
    """Return the polar diagram of a point source, in the unit of its intensity."""
    values, given = solved.answer.values, solved.given
    present = [value for value in values if not value.is_absent]
    amounts = {name: value for value in present[::-1] for name in (value.also, value.name)}
    source = given.get("distribution")
    distribution: Distribution
    note, uncertain = "", [item for item in given.values() if item.is_uncertain]
    if source is None or isinstance(source.value, str):
        shape = spread(given)
        widths = (amounts[n].amount for n in ("half-angle", "exponent") if n in amounts)
        width: Any = next(widths, None)
        if is_uncertain(width):  # of the shape: a band of the intensity alone would be too narrow
            note, width = without_band(uncertain), width.nominal_value
        distribution, title = of_shape(shape, width), shape
    else:
        distribution = source.value.distribution
        title = source.value.name or source.text
    if amounts.keys().isdisjoint(STRENGTHS):
        relative = polar(distribution, 1 / distribution.peak().value, RELATIVE, title)
        return relative._replace(note=note)
    strength = float(distribution.intensity(0.0, 0.0))
    if strength and "intensity" in amounts:
        asked = next(filter(is_intensity, wanted), amounts["intensity"].name)
    else:
        strength, asked = distribution.peak().value, amounts["peak-intensity"].name
    row = pick(values, asked)
    ends = None
    if row.uncertainty and not note:
        ends = (row.value - row.uncertainty) / strength, (row.value + row.uncertainty) / strength
        note = f"band: \u00b1 {STANDARD}"
    axis = plots.Axis(f"{row.quantity} I", row.unit)
    return polar(distribution, row.value / strength, axis, title, ends)._replace(note=note)


def of_sky(name: str, solved: Solved) -> plots.Disc:
    """Return a sky as seen by an observer who looks up, in the unit of its zenith luminance."""
    given = located(solved.given)
    kind = sky_type(name)
    sun = place_of_sun(given) if "sun-elevation" in given else None
    values = solved.answer.values
    zenith = next(v.name for v in values if "zenith-radiance" in (v.name, v.also))
    row = pick(values, zenith)
    sky = Sky(name, sun if kind.follows_sun else None)
    title = f"sky {name}: {kind.name}"
    if sun and "sun-azimuth" not in given:
        title += "; azimuths relative to the sun"
    return fisheye(
        sky,
        row.value,
        plots.Axis(row.quantity.removeprefix("zenith "), row.unit),
        projections.UP,
        title,
        sun,
    )


def of_environment(source: Source, solved: Solved) -> plots.Disc:
    """Return the surroundings as seen by a receiver."""
    radiances = surroundings(source, solved.given)
    unit = light_unit("radiance", radiances.kind) if radiances.kind else ""
    label = specific_name("radiance", radiances.kind) if unit else "relative radiance"
    factor = 1 / float(resolve(unit).factor) if unit else 1.0
    normal = solved.given["normal"].value if "normal" in solved.given else projections.UP
    title = "" if "normal" not in solved.given else f"toward {solved.given['normal'].text}"
    value = plots.Axis(label.replace("-", " "), unit)
    is_image = isinstance(radiances, RadianceMap)
    drawn = fisheye(radiances, factor, value, normal, title, is_image=is_image)
    return _with_peak(drawn, solved, normal)


def _with_peak(disc: plots.Disc, solved: Solved, normal: projections.Vector) -> plots.Disc:
    """Mark the direction of the peak, and note its radiance; neither if there is none."""
    values = {value.name: value for value in solved.answer.values}
    if values["peak-polar"].is_absent:
        return disc
    peak, *to = (
        pick(solved.answer.values, name)
        for name in ("peak-radiance", "peak-polar:rad", "peak-azimuth:rad")
    )
    polar_angle, azimuth = (row.value for row in to)
    mark = _mark("peak", (polar_angle, azimuth), normal)
    direction = f"{math.degrees(polar_angle):.4g}\u00b0,{math.degrees(azimuth):.4g}\u00b0"
    note = f"peak {peak.value:.4g} {peak.unit.removesuffix('1')}".strip() + f" toward {direction}"
    if not mark:
        note += ", behind the receiver"
    return disc._replace(marks=[*disc.marks, *mark], note=note)


def is_intensity(wanted: str) -> bool:
    """Return whether a result, NAME[:UNIT], is the axial intensity of any kind of light."""
    name = name_of(wanted)
    return name in SYMBOLS and SYMBOLS[name].generic == "intensity"


def fisheye(
    radiances: Radiances,
    factor: float,
    value: plots.Axis,
    normal: projections.Vector = projections.UP,
    title: str = "",
    sun: tuple[float, float] | None = None,
    is_image: bool = False,
) -> plots.Disc:
    """Return an equidistant view of the surroundings along a normal, with 90 deg at the rim.

    In a vertical view the azimuth 0 is at the top; seen from below, azimuths increase clockwise.
    `factor` converts the radiances to the unit of `value`; `sun` is marked at its polar angle and
    azimuth [rad].
    """
    right, up, forward = _axes(normal)
    is_level = not (forward[0] or forward[1])
    x, y = numpy.meshgrid(*2 * [numpy.linspace(-1.0, 1.0, PIXELS)])
    away = numpy.hypot(x, y)
    angle = numpy.minimum(away, 1.0) * math.pi / 2
    across = numpy.sin(angle) / numpy.where(away > 0, away, 1.0)
    direction = (x * across, y * across, numpy.cos(angle))
    theta, phi, _ = projections.spherical(
        *projections.from_components((right, up, forward), direction)
    )
    values = numpy.broadcast_to(factor * radiances.radiance(theta, phi), x.shape)
    rim = [("up", 0), ("right", 90), ("down", 180), ("left", 270)]
    centre = "normal"
    if is_level:
        sign = 1 if forward[2] > 0 else -1
        rim = [(f"{azimuth}\u00b0", sign * azimuth % 360) for azimuth in range(0, 360, 45)]
        centre = "zenith" if forward[2] > 0 else "nadir"
    marks = _mark("sun", sun, normal) if sun else []
    return plots.Disc(title, value, values.tolist(), rim, centre, marks, is_image)


def _axes(
    normal: projections.Vector,
) -> tuple[projections.Vector, projections.Vector, projections.Vector]:
    """Return the directions to the right, up and forward of a view along a normal."""
    forward, _, up = projections.facing(normal)
    if not (forward[0] or forward[1]):
        up = (1.0, 0.0, 0.0)
    return projections.cross(forward, up), up, forward


def _mark(label: str, to: tuple[float, float], normal: projections.Vector) -> list[plots.Mark]:
    """Return the mark of a direction (polar angle and azimuth [rad]); none behind the view."""
    right, up, forward = _axes(normal)
    direction = projections.cartesian(*to)
    ahead = math.acos(max(-1.0, min(1.0, projections.dot(direction, forward))))
    if ahead > math.pi / 2:
        return []
    place = projections.dot(direction, right), projections.dot(direction, up)
    share = ahead / (math.pi / 2) / (math.hypot(*place) or 1.0)
    return [plots.Mark(label, place[0] * share, place[1] * share)]


def integrand(
    text: str,
    unit: str,
    polar_angles: tuple[float, float],
    azimuths: tuple[float, float] = ALL_AZIMUTHS,
) -> plots.Chart:
    """Return an expression over the polar angle at some azimuths, and its part in the integral.

    `polar_angles` and `azimuths` [rad] are the limits of the integral.
    """
    expression = Expression(text)
    theta = numpy.linspace(*polar_angles, POLARS)
    start, end = azimuths
    turns = numpy.linspace(start, end, AZIMUTHS, endpoint=False) + (end - start) / AZIMUTHS / 2
    along, around = numpy.meshgrid(theta, turns)

    def values_at(along: Any, around: Any) -> Any:
        x, y, z = projections.cartesian(along, around)
        with numpy.errstate(all="ignore"):  # at a pole
            values = expression({"theta": along, "phi": around, "x": x, "y": y, "z": z})
        return numpy.broadcast_to(values, numpy.shape(along)).astype(float)

    with numpy.errstate(all="ignore"):
        weighted = values_at(along, around).mean(axis=0) * numpy.sin(theta)

    def series(name: str, values: Any, style: str = plots.LINE) -> plots.Series:
        """Return a series without poles, which are drawn only as far as they are sampled."""
        finite = numpy.isfinite(values)
        return plots.Series(
            name, numpy.degrees(theta[finite]).tolist(), values[finite].tolist(), style
        )

    drawn_azimuths = [
        start + (end - start) * k / FEW for k in range(1 if expression.is_axial else FEW)
    ]
    curves = []
    for azimuth in drawn_azimuths:
        name = "f(\u03b8)"
        if not expression.is_axial:
            name = f"f(\u03b8, \u03c6 = {format_angle(azimuth)})"
        curves.append(series(name, values_at(theta, azimuth + 0 * theta)))
    mean = "f sin \u03b8" if expression.is_axial else "mean of f over \u03c6, times sin \u03b8"
    curves.append(series(mean, weighted, plots.REFERENCE))
    title = f"f = {text}"
    return plots.Chart(
        title, plots.Axis("polar angle \u03b8", "deg"), plots.Axis("f", unit), curves
    )


class Surveyed(NamedTuple):
    """A grid, the answers for its points in blocks, the sources, and the result to draw."""

    axes: Sequence[Coordinates]
    blocks: Iterable[Answer]
    sources: Sequence[tuple[str, projections.Vector]] = ()
    wanted: str = "irradiance"


def over_grid(survey: Surveyed) -> plots.Picture:
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
    value = plots.Axis(f"{rows[0].quantity} {rows[0].symbol}".strip(), rows[0].unit)
    lines = [numpy.linspace(axis.start, axis.end, axis.size).tolist() for axis in survey.axes]
    for k, axis in enumerate(survey.axes):
        if axis.start > axis.end:
            lines[k].reverse()
            values = numpy.flip(values, k)
    fixed = [f"{NAMES[k]} = {lines[k][0]:g} m" for k in range(3) if k not in long]
    title = f"{rows[0].quantity} at {', '.join(fixed)}"
    if len(long) == 1:
        (k,) = long
        return plots.Chart(
            title,
            plots.Axis(NAMES[k], "m"),
            value,
            [plots.Series("", lines[k], values.ravel().tolist())],
        )
    i, j = long
    table = values.reshape(len(lines[i]), len(lines[j])).T
    marks = [
        plots.Mark(name, place[i], place[j])
        for name, place in survey.sources
        if lines[i][0] <= place[i] <= lines[i][-1] and lines[j][0] <= place[j] <= lines[j][-1]
    ]
    axes = plots.Axis(NAMES[i], "m"), plots.Axis(NAMES[j], "m")
    return plots.Field(title, *axes, value, lines[i], lines[j], table.tolist(), marks)
