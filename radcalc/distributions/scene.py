"""The irradiance from several sources at their positions, and from one at places and on discs.

Positions are in metres, in world coordinates (`Pose` of `radcalc.distributions.distribution`).

A source with the pose P is at the height h above a horizontal plane.  A place in the plane is at
x, y from the point below the source.  Results have the unit of the distribution: candelas give lux.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy

from radcalc import geometry
from radcalc.distributions.distribution import DOWN, Distribution, Pose, integrated, last_where
from radcalc.errors import ConditionError, option, quote
from radcalc.geometry import projections, solid
from radcalc.geometry.numerics.cubature import Integral
from radcalc.geometry.projections import Vector, cartesian, cross, dot, length, minus, spherical
from radcalc.maths import Number, each

ACCURACY = 1e-6  # [1] best accuracy of the flux through arcs above the horizon
UNCERTAIN = 0.01  # [1] share of the whole flux's error that a part may add to it
ANGLES = 20_000  # angles between straight down and the horizon in the search for an irradiance
FAR = 80  # largest -ln of the angle from straight down, or from the horizon: 1e-35 rad
SAME = 1e-9  # [1] relative difference at which a place found has the wanted irradiance
COUNTS = (4, 8, 16, 32, 64, 128)  # radii sampled in a disc, each at twice as many angles
ENOUGH = 1e-5  # [1] of the light on a disc: a smaller change ends the refinement
RINGS = 9  # rings in which the intensity is compared with that at a disc's centre
ACCEPTED = 1e-3  # [1] of the light on a disc: a larger error is refused
AT_ONCE = 1 << 18  # points in memory at a time
MOST = 1 << 25  # points in all


def relative_irradiance(
    distribution: Distribution, pose: Pose, x: Number, y: Number, height: Number
) -> Number:
    """Return the irradiance I(theta, phi) h / d^3 at a place in a horizontal plane under a source.

    Parameters
    ----------
    distribution : Distribution
    pose : Pose
    x, y : float or ndarray [m]
        The place, from the point below the source.
    height : float or ndarray [m]
        Height of the source above the plane, above 0.

    Returns
    -------
    float or ndarray [lx, W/m^2, photon/s/m^2 or 1/m^2]

    Examples
    --------
    >>> from radcalc.distributions.sources import Isotropic
    >>> round(float(relative_irradiance(Isotropic(), Pose(), 8.0, 0.0, 6.0)), 9)
    0.006
    """
    theta, phi, distance = pose.angles((x, y, 0.0 - height))
    return distribution.intensity(theta, phi) * (height / distance) / distance / distance


def upward_flux(distribution: Distribution, pose: Pose, whole: Integral) -> Integral:
    """Return the flux [lm, W, photon/s or sr] into the upper half of space, from the `whole` flux.

    Raises
    ------
    ConditionError
        If a part of the distribution cannot be integrated.

    Notes
    -----
    Let the axis have the elevation e.  Directions within abs(e) of the axis are on its side of the
    horizon, those within abs(e) of the opposite direction on the other side.  A circle about the
    axis between them is above the horizon in an arc within w of its highest point::

        cos(w) = -tan(e) / tan(theta)

    Examples
    --------
    Half of a light that is aimed at the horizon goes up:

    >>> from radcalc.distributions.sources import Lobe
    >>> lamp = Lobe(1.0)
    >>> round(upward_flux(lamp, Pose((1.0, 0.0, 0.0)), lamp.flux()).value / math.pi, 6)
    0.5
    """
    up = tuple(axis[2] for axis in pose.axes)
    across = math.hypot(up[0], up[1])
    height = math.atan2(up[2], across)
    edge = abs(height)
    forwards, backwards = (0.0, edge), (math.pi - edge, math.pi)
    sides = (forwards, backwards) if height > 0 else (backwards, forwards)
    if across == 0:
        try:
            return distribution.flux(sides[0])
        except ConditionError:  # almost all of the flux is in the other half
            lower = distribution.flux(sides[1])
            return whole._replace(value=max(0.0, whole.value - lower.value))
    upper, lower = map(distribution.flux, sides)
    slope, highest = math.tan(height), math.atan2(up[1], up[0])
    accuracy = max(ACCURACY, UNCERTAIN * whole.error / whole.value) if whole.value else ACCURACY
    above, below = (
        integrated(arcs, (edge, math.pi - edge), (-1.0, 1.0), accuracy)
        for arcs in (
            _Arcs(distribution, slope, highest),
            _Arcs(distribution, -slope, highest + math.pi),
        )
    )
    value, value_below = upper.value + above.value, lower.value + below.value
    missed = abs(value + value_below - whole.value)
    if missed > ACCEPTED * whole.value:
        problem = "the light is too narrow to be divided at the horizon"
        raise ConditionError(problem, "without its flux upwards and downwards")
    error = upper.error + above.error + missed
    return Integral(min(value, whole.value), error, upper.cells + above.cells)


class _Arcs:
    """A distribution over the arcs above the horizon; phi goes from -1 to 1 along each arc."""

    def __init__(self, distribution: Distribution, slope: float, highest: float) -> None:
        self.distribution, self.slope, self.highest = distribution, slope, highest
        self.is_axial = distribution.is_axial

    def intensity(self, theta: Number, phi: Number) -> Number:
        with numpy.errstate(divide="ignore"):
            half = numpy.arccos(numpy.clip(-self.slope / numpy.tan(theta), -1.0, 1.0))
        return self.distribution.intensity(theta, self.highest + half * phi) * half


def heights(
    distribution: Distribution, pose: Pose, lateral: float, bearing: float, wanted: float
) -> tuple[float, ...]:
    """Return the heights [m] of a source at which a place to its side has a given irradiance.

    These are all heights found between the horizon and straight below, the highest first.

    Parameters
    ----------
    lateral : float [m]
        Distance of the place from the point below the source, above 0.
    bearing : float [rad]
        Azimuth of the place about that point, from +x towards +y.
    wanted : float
        Irradiance, above 0, in the unit of `relative_irradiance`.

    Raises
    ------
    ConditionError
        If no height gives this irradiance.

    Examples
    --------
    250 cd give 1.5 lx at a place 8 m to the side from 6 m up, and also from 5.33 m up:

    >>> from radcalc.distributions.sources import Isotropic
    >>> [round(h, 6) for h in heights(Isotropic(), Pose(), 8.0, 0.0, 1.5 / 250)]
    [6.0, 5.329171]
    """
    x, y = lateral * math.cos(bearing), lateral * math.sin(bearing)

    def light(slope: Any) -> Any:
        return relative_irradiance(distribution, pose, x, y, lateral * numpy.exp(-slope))

    return tuple(lateral * math.exp(-slope) for slope in _slopes_with(light, wanted, "height"))


def laterals(
    distribution: Distribution, pose: Pose, height: float, bearing: float, wanted: float
) -> tuple[float, ...]:
    """Return the distances [m] from the point below a source with a given irradiance.

    These are all distances found between the horizon and straight below, the nearest first.
    `height` [m] is above 0; the other parameters and the error are those of `heights`.

    Examples
    --------
    >>> from radcalc.distributions.sources import Isotropic
    >>> [round(x, 6) for x in laterals(Isotropic(), Pose(), 6.0, 0.0, 1.5 / 250)]
    [8.0]
    """
    x, y = math.cos(bearing), math.sin(bearing)

    def light(slope: Any) -> Any:
        lateral = height * numpy.exp(slope)
        return relative_irradiance(distribution, pose, x * lateral, y * lateral, height)

    return tuple(height * math.exp(slope) for slope in _slopes_with(light, wanted, "offset"))


def _slopes_with(light: Callable[[Any], Any], wanted: float, what: str) -> list[float]:
    """Return ln(tan(off)) of the angles off the vertical at which the light is as wanted."""
    off = numpy.linspace(0.0, math.pi / 2, ANGLES + 1)[1:-1]
    steep = numpy.linspace(math.log(off[0]), -FAR, FAR)  # near straight down, and the horizon
    slopes = numpy.concatenate([steep[:0:-1], numpy.log(numpy.tan(off)), -steep[1:]])
    above = light(slopes) >= wanted
    found = []
    for k in numpy.flatnonzero(above[:-1] != above[1:]):
        holds = partial(_is_so, light, wanted, above[k])
        low = last_where(holds, float(slopes[k]), float(slopes[k + 1]))
        # at a jump of the light, as at the edge of a table, no place has exactly this irradiance
        if abs(light(numpy.array([low]))[0] - wanted) <= SAME * wanted:
            found.append(low)
    if not found:
        problem = f"no {what} gives exactly that irradiance"
        raise ConditionError(problem, "another irradiance, flux or intensity")
    return found


def _is_so(light: Callable[[Any], Any], wanted: float, is_above: bool, slope: Any) -> Any:
    return (light(slope) >= wanted) == is_above


def on_plane(
    distribution: Distribution, pose: Pose, radius: Number, x: Number, y: Number, height: Number
) -> Number:
    """Return the solid angle of a horizontal disc under a source, weighted with the intensity.

    It is the flux [lm, W, photon/s or sr] on the disc, to 0.1 % or better.  `x`, `y` and `height`
    are those of the centre in `relative_irradiance`, `radius` [m] is above 0; all may be arrays.

    Raises
    ------
    ConditionError
        If there are too many discs, or the edges of the light on one are too sharp.

    Examples
    --------
    A disc of the half angle 60 degrees fills pi sr:

    >>> from radcalc.distributions.sources import Isotropic
    >>> round(float(on_plane(Isotropic(), Pose(), 3**0.5, 0.0, 0.0, 1.0)) / math.pi, 5)
    1.0
    """

    if pose.axes[2] == DOWN and not (numpy.any(x) or numpy.any(y)):
        return _about_axis(distribution, radius, height)

    def light(across: Any, along: Any, x: Any, y: Any, height: Any) -> Any:
        return relative_irradiance(distribution, pose, x + across, y + along, height)

    counts = _refinements(distribution, radius, height)
    return _over_discs(light, counts, radius, x, y, height)


def on_facing_disc(
    distribution: Distribution, radius: Number, distance: Number, theta: Number, phi: Number
) -> Number:
    """Return the solid angle of a disc that faces a source, weighted with the intensity.

    `distance` [m], `theta` and `phi` [rad] are those of the centre from the source.  The unit, the
    precision and the error are those of `on_plane`.

    Examples
    --------
    >>> from radcalc.distributions.sources import Isotropic
    >>> round(float(on_facing_disc(Isotropic(), 3**0.5, 1.0, 0.7, 0.0)) / math.pi, 5)
    1.0
    """

    if not numpy.any(theta):
        return _about_axis(distribution, radius, distance)

    def light(across: Any, along: Any, distance: Any, theta: Any, phi: Any) -> Any:
        polar, azimuth, slant = _seen(across, along, distance, theta, phi)
        return distribution.intensity(polar, azimuth) * distance / slant**3

    counts = _refinements(distribution, radius, distance)
    return _over_discs(light, counts, radius, distance, theta, phi)


def _about_axis(distribution: Distribution, radius: Number, away: Number) -> Number:
    return each(lambda r, d: distribution.flux((0.0, math.atan2(r, d))).value, radius, away)


def _refinements(distribution: Distribution, radius: Number, away: Number) -> list[int]:
    """Return the numbers of radii to sample, so that no light falls between the samples."""
    widest = float(numpy.arctan(numpy.max(radius / away, initial=0.0)))
    least = math.pi * widest / distribution.finest
    counts = [count for count in COUNTS if 2 * count >= least]
    if len(counts) < 2:
        problem = "the light is too narrow for an integral over the receiver"
        raise ConditionError(problem, "a smaller receiver, or one whose centre is on the axis")
    return counts


def unevenness(
    distribution: Distribution, radius: Number, distance: Number, theta: Number, phi: Number
) -> float:
    """Return the largest relative difference of the intensity on a disc from that at its centre.

    Parameters are those of `on_facing_disc`.  It is infinite if only the centre is dark.

    Examples
    --------
    A Lambertian light falls by 1 - cos(atan(0.1)) at the rim of a disc:

    >>> from radcalc.distributions.sources import Lobe
    >>> round(unevenness(Lobe(1.0), 0.1, 1.0, 0.0, 0.0), 6)
    0.004963
    """
    part, turn = numpy.linspace(0, 1, RINGS)[:, None], numpy.linspace(0, 2 * math.pi, 4 * RINGS)
    across, along = ((part * wave(turn)).ravel() for wave in (numpy.cos, numpy.sin))
    place = (radius, distance, theta, phi)
    radius, distance, theta, phi = (numpy.asarray(x)[..., None] for x in place)
    polar, azimuth, _ = _seen(radius * across, radius * along, distance, theta, phi)
    centre = distribution.intensity(theta, phi)
    apart = abs(distribution.intensity(polar, azimuth) - centre)
    with numpy.errstate(all="ignore"):
        return float(numpy.where(apart > 0, apart / centre, 0.0).max())


def _seen(across: Any, along: Any, distance: Any, theta: Any, phi: Any) -> tuple[Any, Any, Any]:
    """Return the source's angles and the distance of points on a disc that faces the source."""
    ahead = cartesian(theta, phi)
    outward = (
        numpy.cos(theta) * numpy.cos(phi),
        numpy.cos(theta) * numpy.sin(phi),
        -numpy.sin(theta),
    )
    around = (-numpy.sin(phi), numpy.cos(phi), 0.0)
    x, y, z = (
        a * distance + b * across + c * along
        for a, b, c in zip(ahead, outward, around, strict=True)
    )
    return spherical(x, y, z)


def _over_discs(
    light: Callable[..., Any], counts: list[int], radius: Number, *places: Number
) -> Number:
    """Integrate over discs, with more points until the result is stable."""
    shape = numpy.broadcast_shapes(*map(numpy.shape, (radius, *places)))
    size, *where = (numpy.broadcast_to(x, shape).ravel() for x in (radius, *places))
    if 2 * counts[1] ** 2 * len(size) > MOST:
        raise ConditionError(f"{len(size)} receivers are too many", "fewer, or without their area")
    sums, error = _sums(light, counts[0], size, where), math.inf
    for count in counts[1:]:
        if 2 * count * count * len(size) > MOST:
            break
        before, sums = sums, _sums(light, count, size, where)
        apart = abs(sums - before)
        error = float((apart / numpy.where(apart > 0, numpy.maximum(sums, before), 1.0)).max())
        if error < ENOUGH:
            break
    if error > ACCEPTED:
        problem = "the edges of the light on the receiver are too sharp for an integral"
        raise ConditionError(problem, "a smaller receiver, or one that is all inside the light")
    return sums.reshape(shape)[()]


def _sums(light: Callable[..., Any], count: int, size: Any, where: list[Any]) -> Any:
    """Sum over each disc: Gauss-Legendre radii, each at twice as many angles."""
    nodes, weights = numpy.polynomial.legendre.leggauss(count)
    radii = numpy.sqrt((nodes + 1) / 2)  # of rings of equal area
    angles = (numpy.arange(2 * count) + 0.5) * math.pi / count
    across = (radii[:, None] * numpy.cos(angles)).ravel()
    along = (radii[:, None] * numpy.sin(angles)).ravel()
    shares = numpy.repeat(weights / (4 * count), 2 * count)
    integrals = numpy.empty(len(size))
    step = max(1, AT_ONCE // len(across))
    for start in range(0, len(size), step):
        part = slice(start, start + step)
        reach = size[part, None]
        values = light(reach * across, reach * along, *(x[part, None] for x in where))
        integrals[part] = values @ shares * (math.pi * size[part] ** 2)
    return integrals


NEAREST = 1e-6  # [m] a point must be farther than this from a source
BLOCK = 1 << 16  # points at a time
RECTANGLE = ((-1, -1), (1, -1), (1, 1), (-1, 1))  # corners, in half sides


class Emitter:
    """A source that is small compared with its distance, at its position.

    Intensities times `factor` are in coherent SI.  `size` [m] is 0 if it is not known; with
    `is_patch`, a surface, points nearer than five times its size are refused.

    Examples
    --------
    100 cd in all directions, 2 m above the origin:

    >>> from radcalc.distributions.sources import Isotropic
    >>> lamp = Emitter("lamp", (0.0, 0.0, 2.0), Pose(), Isotropic(), 100.0)
    >>> points = tuple(numpy.zeros((3, 1)))
    >>> lamp.irradiance(points, (0.0, 0.0, 1.0)).tolist()
    [25.0]
    """

    def __init__(
        self,
        name: str,
        place: Vector,
        pose: Pose,
        distribution: Distribution,
        factor: float = 1.0,
        size: float = 0.0,
        is_patch: bool = False,
    ) -> None:
        self.name, self.place, self.pose = name, place, pose
        self.distribution, self.factor = distribution, factor
        self.size, self.is_patch = size, is_patch

    def irradiance(self, points: Vector, normal: Vector) -> Any:
        """Return the irradiance E = I(gamma, C) cos(theta) Omega0 / d^2 at points.

        It is negative for light from behind the receiver.

        Parameters
        ----------
        points : tuple of 3 ndarrays of shape (n,) [m]
            Coordinates.
        normal : tuple of 3 floats [1]
            Unit normal of the receivers.

        Returns
        -------
        ndarray of shape (n,) [lx, W/m^2 or photon/s/m^2]

        Raises
        ------
        ConditionError
            If a point is at the source, or too near a patch.
        """
        intensity, cosine, distance = self.terms(points, normal)
        return intensity * cosine / (distance * distance)

    def terms(self, points: Vector, normal: Vector) -> tuple[Any, Any, Any]:
        """Return the intensity towards points, the cosine of incidence, and the distance."""
        to = minus(points, self.place)
        distance = length(to)
        _refuse(distance <= NEAREST, points, f"is at the position of {self.name}", "another point")
        if self.is_patch:
            _refuse(
                geometry.nearer(distance, self.size),
                points,
                f"is nearer than five times its size ({self.size:.3g} m) to {self.name}",
                "its width and length in place of its area, which holds at any distance",
            )
        if self.distribution.is_axial:  # any azimuth gives the same
            axis = self.pose.axes[2]
            theta, phi = numpy.arctan2(length(cross(axis, to)), dot(axis, to)), 0.0
        else:
            theta, phi, _ = self.pose.angles(to)
        try:
            intensity = self.factor * self.distribution.intensity(theta, phi)
        except ConditionError as error:  # from an expression
            raise error.reworded(f"{self.name}: {error.message}") from None
        return intensity, -dot(normal, to) / distance, distance

    def near(self, points: Vector) -> Any:
        """Return which points are nearer than five times the size."""
        return geometry.nearer(length(minus(points, self.place)), self.size)


class Panel:
    """A rectangle of uniform luminance that emits on one side; exact at any distance.

    `place` [m] is its centre; `width` and `length_` [m] are its sides along C0 and C90.

    Examples
    --------
    A wide ceiling of 100 cd/m2 gives pi times that below it:

    >>> panel = Panel("ceiling", (0.0, 0.0, 1.0), Pose(), 1e6, 1e6, 100.0)
    >>> points = tuple(numpy.zeros((3, 1)))
    >>> round(float(panel.irradiance(points, (0.0, 0.0, 1.0))[0] / math.pi), 3)
    100.0
    """

    size = 0.0

    def __init__(
        self, name: str, place: Vector, pose: Pose, width: float, length_: float, radiance: float
    ) -> None:
        self.name, self.place, self.pose, self.radiance = name, place, pose, radiance
        self.half = (width / 2, length_ / 2)

    def irradiance(self, points: Vector, normal: Vector) -> Any:
        """Return the irradiance E = L Omega_p at points; see `Emitter.irradiance`.

        Omega_p is the projected solid angle of the part of the panel above their horizon, by
        Lambert's contour formula.  It is negative if all of the panel is below.
        """
        return self.radiance * self.projected_solid_angle(points, normal)

    def projected_solid_angle(self, points: Vector, normal: Vector) -> Any:
        """Return the projected solid angle [sr], with the sign of `irradiance`."""
        to = minus(points, self.place)
        across, along, ahead = (dot(axis, to) for axis in self.pose.axes)
        inside = (abs(across) <= self.half[0]) & (abs(along) <= self.half[1])
        on_it = inside & (abs(ahead) <= NEAREST)
        _refuse(on_it, points, f"is on {self.name}", "another point")
        corners = [self.pose.world((a * self.half[0], b * self.half[1], 0.0)) for a, b in RECTANGLE]
        highest = numpy.max([dot(normal, corner) for corner in corners], axis=0)
        seen = (ahead > 0) & (highest > dot(normal, to))
        solid_angles = numpy.where((ahead > 0) & ~seen, -1.0, 0.0)
        if numpy.any(seen):
            lit: Any = tuple(x[seen] for x in to)
            solid_angles[seen] = solid.projected_polygon(
                [minus(corner, lit) for corner in corners], normal
            )
        return solid_angles

    def near(self, points: Vector) -> Any:
        """Return which points are too near: none."""
        return numpy.zeros(len(points[0]), bool)


Source = Emitter | Panel


def _refuse(bad: Any, points: Vector, problem: str, hint: str) -> None:
    if numpy.any(bad):
        k = int(numpy.argmax(bad))
        raise ConditionError(
            f"the point {point_text(*(float(x[k]) for x in points))} {problem}", hint
        )


def point_text(x: float, y: float, z: float) -> str:
    """Return a point for a message, as the user types it.

    >>> point_text(1.0, 0.25, -0.0)
    '1,0.25,0'
    """
    return quote(",".join(f"{c + 0.0:.12g}" for c in (x, y, z)))


def unit(normal: Vector) -> Vector:
    """Return a normal scaled to length 1; raise a ConditionError if it is 0 or not finite."""
    if not any(normal) or not math.isfinite(sum(normal)):
        raise ConditionError("a normal needs a finite length above 0", option("normal", "0,0,1"))
    return projections.unit(normal)


class Field(NamedTuple):
    """The irradiance at points from all sources.

    Attributes
    ----------
    points : tuple of 3 ndarrays of shape (n,) [m]
    total : ndarray of shape (n,) [lx, W/m^2 or photon/s/m^2]
    parts : list of ndarrays of shape (n,)
        Irradiance from each source; empty unless requested.
    behind : int
        Number of points with light from behind the receiver, which does not count.
    near : tuple of int
        For each source, the number of points nearer than five times its size.
    """

    points: Vector
    total: Any
    parts: list[Any]
    behind: int
    near: tuple[int, ...]


def field(
    sources: Sequence[Source], points: Vector, normal: Vector, with_parts: bool = False
) -> Field:
    """Return the irradiance at points, summed over sources of one kind of light.

    Parameters and errors are those of `Emitter.irradiance`; `with_parts` keeps the irradiance
    from each source.

    Examples
    --------
    >>> from radcalc.distributions.sources import Isotropic
    >>> lamps = [Emitter(k, (k, 0.0, 2.0), Pose(), Isotropic(), 100.0) for k in (0.0, 0.0)]
    >>> field(lamps, tuple(numpy.zeros((3, 1))), (0.0, 0.0, 1.0)).total.tolist()
    [50.0]
    """
    total = numpy.zeros(len(points[0]))
    behind = numpy.zeros(len(points[0]), bool)
    parts, near = [], []
    for source in sources:
        part = source.irradiance(points, normal)
        behind |= part < 0
        part = numpy.maximum(part, 0.0)
        total += part
        if with_parts:
            parts.append(part)
        near.append(int(numpy.sum(source.near(points) & (part > 0))) if source.size else 0)
    return Field(points, total, parts, int(behind.sum()), tuple(near))


class Statistics:
    """Mean and extremes over many points, updated with one field at a time.

    `behind` and `near` are those of `Field`; `least_at` and `most_at` [m] are the first points with
    the extremes.
    """

    def __init__(self) -> None:
        self.count = self.behind = 0
        self.sums: list[float] = []
        self.near: list[int] = []
        self.least, self.most = math.inf, -math.inf
        self.least_at = self.most_at = (0.0, 0.0, 0.0)

    def add(self, field: Field) -> None:
        """Add a field of at least one point."""
        self.count += len(field.total)
        self.behind += field.behind
        self.near = [
            a + b for a, b in zip(self.near or [0] * len(field.near), field.near, strict=True)
        ]
        self.sums.append(float(field.total.sum()))
        low, high = int(field.total.argmin()), int(field.total.argmax())
        if field.total[low] < self.least:
            self.least, self.least_at = float(field.total[low]), _point(field, low)
        if field.total[high] > self.most:
            self.most, self.most_at = float(field.total[high]), _point(field, high)

    @property
    def mean(self) -> float:
        return math.fsum(self.sums) / self.count


def _point(field: Field, k: int) -> tuple[float, float, float]:
    x, y, z = (float(c[k]) for c in field.points)
    return x, y, z


class Axis(NamedTuple):
    """Evenly spaced coordinates [m] of a grid along an axis, both ends included."""

    start: float
    end: float
    size: int


def grid(x: Axis, y: Axis, z: Axis) -> Iterator[Vector]:
    """Yield the points of a grid in blocks of up to `BLOCK`; z varies fastest, then y.

    >>> [x.tolist() for x in next(grid(Axis(0, 1, 2), Axis(0, 2, 2), Axis(5, 5, 1)))]
    [[0.0, 0.0, 1.0, 1.0], [0.0, 2.0, 0.0, 2.0], [5.0, 5.0, 5.0, 5.0]]
    """
    coordinates = [numpy.linspace(axis.start, axis.end, axis.size) for axis in (x, y, z)]
    count = x.size * y.size * z.size
    for start in range(0, count, BLOCK):
        index = numpy.arange(start, min(start + BLOCK, count))
        places = numpy.unravel_index(index, (x.size, y.size, z.size))
        a, b, c = (values[place] for values, place in zip(coordinates, places, strict=True))
        yield a, b, c


def blocks(points: Any) -> Iterator[Vector]:
    """Yield points, array_like of shape (n, 3) [m], in blocks of up to `BLOCK`.

    Raise a ConditionError for another shape, or a coordinate that is not finite.

    >>> [x.tolist() for x in next(blocks([[1, 2, 3]]))]
    [[1.0], [2.0], [3.0]]
    """
    coordinates = numpy.asarray(points, float)
    if coordinates.ndim != 2 or coordinates.shape[1] != 3 or not len(coordinates):
        shape = " x ".join(map(str, coordinates.shape))
        problem = f"points of the shape {shape or 'of a number'}"
        raise ConditionError(problem, "n points of 3 coordinates")
    if not numpy.isfinite(coordinates).all():
        raise ConditionError("a point has a coordinate that is not finite", "finite numbers")
    for start in range(0, len(coordinates), BLOCK):
        x, y, z = coordinates[start : start + BLOCK].T
        yield x, y, z
