"""The light on places and discs under a source, and the places with a given irradiance.

A source with the pose P is at the height h above a horizontal plane.  A place in the plane is at
x, y from the point below the source.  Results have the unit of the distribution: candelas give lux.
"""

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy

from radcalc.distributions.distribution import DOWN, Distribution, Pose, integrated, last_where
from radcalc.errors import ConditionError
from radcalc.geometry.directions import cartesian, spherical
from radcalc.geometry.numerics.cubature import Integral
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
    >>> from radcalc.distributions.formula import Isotropic
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

    >>> from radcalc.distributions.formula import Lobe
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
        raise ConditionError(
            "the light is too narrow to be divided at the horizon",
            "without its flux upwards and downwards",
        )
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

    >>> from radcalc.distributions.formula import Isotropic
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
    >>> from radcalc.distributions.formula import Isotropic
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
        raise ConditionError(
            f"no {what} gives exactly that irradiance", "another irradiance, flux or intensity"
        )
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

    >>> from radcalc.distributions.formula import Isotropic
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
    >>> from radcalc.distributions.formula import Isotropic
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
        raise ConditionError(
            "the light is too narrow for an integral over the receiver",
            "a smaller receiver, or one whose centre is on the axis",
        )
    return counts


def unevenness(
    distribution: Distribution, radius: Number, distance: Number, theta: Number, phi: Number
) -> float:
    """Return the largest relative difference of the intensity on a disc from that at its centre.

    Parameters are those of `on_facing_disc`.  It is infinite if only the centre is dark.

    Examples
    --------
    A Lambertian light falls by 1 - cos(atan(0.1)) at the rim of a disc:

    >>> from radcalc.distributions.formula import Lobe
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
        raise ConditionError(
            "the edges of the light on the receiver are too sharp for an integral",
            "a smaller receiver, or one that is all inside the light",
        )
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
