"""What lies under a source: the light on a disc, and the places that get so much of it.

A source of the pose P is at the height h above a horizontal plane; a place in it is at x, y from
the point below the source.  All is relative to the distribution: of one in candelas an irradiance
is in lux.

- `relative_irradiance` on the plane at a place
- `upward_flux` into the upper half of the world
- `heights`, `laterals`: the places that get so much
- `on_plane`, `on_facing_disc`: solid angle of a disc, weighted with the intensity
- `unevenness` of the intensity over a disc
"""

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy

from radcalc.distributions.distribution import Distribution, integrated, last_where
from radcalc.distributions.pose import DOWN, Pose
from radcalc.errors import ConditionError
from radcalc.geometry.directions import cartesian, spherical
from radcalc.geometry.numerics.cubature import Integral
from radcalc.maths import Number, each

ACCURACY = 1e-6  # [1] of the flux through arcs above the horizon, at best
UNCERTAIN = 0.01  # [1] of the error of all the flux, which that of a part may add to it
ANGLES = 20_000  # between straight down and the horizon, at which light is looked for
SAME = 1e-9  # [1] by which a place found may miss the light that is looked for
COUNTS = (4, 8, 16, 32, 64, 128)  # radii at which a disc is looked at, each of twice as many angles
ENOUGH = 1e-5  # [1] of the light on a disc, from where on more of them do not matter
RINGS = 9  # at which an intensity is compared with that at a disc's centre
ACCEPTED = 1e-3  # [1] of the light on a disc, beyond which it is refused
AT_ONCE = 1 << 18  # places that are looked at, in memory
MOST = 1 << 25  # places that are looked at in all


def relative_irradiance(
    distribution: Distribution, pose: Pose, x: Number, y: Number, height: Number
) -> Number:
    """Irradiance of a place on a horizontal plane under a source.

    Parameters
    ----------
    distribution : Distribution
        Of any form.
    pose : Pose
        How the source is aimed and rotated.
    x, y : float or ndarray [m]
        The place, from the point below the source.
    height : float or ndarray [m]
        Of the source above the plane, above 0.

    Returns
    -------
    float or ndarray [lx, W/m^2, photon/s/m^2 or 1/m^2]
        I(theta, phi) h / d^3.

    Examples
    --------
    >>> from radcalc.distributions.shapes import Isotropic
    >>> round(float(relative_irradiance(Isotropic(), Pose(), 8.0, 0.0, 6.0)), 9)
    0.006
    """
    theta, phi, distance = pose.angles((x, y, 0.0 - height))
    return distribution.intensity(theta, phi) * height / distance**3


def upward_flux(distribution: Distribution, pose: Pose, whole: Integral) -> Integral:
    """Flux of a source into the upper half of the world.

    Parameters
    ----------
    distribution, pose
        As of `relative_irradiance`.
    whole : Integral
        Its flux in all directions.

    Returns
    -------
    Integral
        Flux [lm, W, photon/s or sr] and an estimate of its error.

    Raises
    ------
    ConditionError
        If a part of the distribution cannot be integrated.

    Notes
    -----
    Of an axis at the height e above the horizon, directions within abs(e) of it are on its side
    of the horizon, and those within abs(e) of its opposite on the other.  Of a circle about it
    between these, the arc is up that is within w of its highest point::

        cos(w) = -tan(e) / tan(theta)

    Examples
    --------
    Half of a light that is aimed at the horizon:

    >>> from radcalc.distributions.shapes import Lobe
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
        except ConditionError:  # of a half with next to nothing, that the other one has
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
            "the light is too narrow for the horizon to be cut from it",
            "without its flux upwards and downwards",
        )
    error = upper.error + above.error + missed
    return Integral(min(value, whole.value), error, upper.cells + above.cells)


class _Arcs:
    """A distribution over the arcs above the horizon: phi goes from -1 to 1 along each of them."""

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
    """Heights from which a place aside of the source gets so much light.

    Parameters
    ----------
    distribution, pose
        As of `relative_irradiance`.
    lateral : float [m]
        Distance of the place from the point below the source, above 0.
    bearing : float [rad]
        Azimuth of the place about that point, from +x towards +y.
    wanted : float
        Irradiance, above 0, in the unit of `relative_irradiance`.

    Returns
    -------
    tuple of float [m]
        All that are found between the horizon and straight below, the highest first.

    Raises
    ------
    ConditionError
        If no height gives so much.

    Examples
    --------
    250 cd give a place 8 m aside 1.5 lx from 6 m up, and from higher up as well:

    >>> from radcalc.distributions.shapes import Isotropic
    >>> [round(h, 6) for h in heights(Isotropic(), Pose(), 8.0, 0.0, 1.5 / 250)]
    [6.0, 5.329171]
    """
    x, y = lateral * math.cos(bearing), lateral * math.sin(bearing)

    def light(off: Any) -> Any:
        return relative_irradiance(distribution, pose, x, y, lateral / numpy.tan(off))

    return tuple(lateral / math.tan(off) for off in _angles_with(light, wanted, "height"))


def laterals(
    distribution: Distribution, pose: Pose, height: float, bearing: float, wanted: float
) -> tuple[float, ...]:
    """Distances from the point below a source at which a plane gets so much light.

    Parameters
    ----------
    distribution, pose
        As of `relative_irradiance`.
    height : float [m]
        Of the source above the plane, above 0.
    bearing : float [rad]
        Azimuth in which to look, about the point below the source from +x towards +y.
    wanted : float
        Irradiance, above 0, in the unit of `relative_irradiance`.

    Returns
    -------
    tuple of float [m]
        All that are found between the horizon and straight below, the nearest first.

    Raises
    ------
    ConditionError
        If no place gets so much.

    Examples
    --------
    >>> from radcalc.distributions.shapes import Isotropic
    >>> [round(x, 6) for x in laterals(Isotropic(), Pose(), 6.0, 0.0, 1.5 / 250)]
    [8.0]
    """
    x, y = math.cos(bearing), math.sin(bearing)

    def light(off: Any) -> Any:
        lateral = height * numpy.tan(off)
        return relative_irradiance(distribution, pose, x * lateral, y * lateral, height)

    return tuple(height * math.tan(off) for off in _angles_with(light, wanted, "offset"))


def _angles_with(light: Callable[[Any], Any], wanted: float, what: str) -> list[float]:
    """The angles from straight down at which there is so much light, by looking ever closer."""
    off = numpy.linspace(0.0, math.pi / 2, ANGLES + 1)[:-1]
    off[0] = 1e-9  # where it is below the source but for what no number tells
    above = light(off) >= wanted
    angles = []
    for k in numpy.flatnonzero(above[:-1] != above[1:]):
        holds = partial(_is_so, light, wanted, above[k])
        low = last_where(holds, float(off[k]), float(off[k + 1]))
        # where the light jumps, at the edge of a table, no place has just so much
        if abs(light(numpy.array([low]))[0] - wanted) <= SAME * wanted:
            angles.append(low)
    if not angles:
        raise ConditionError(
            f"no {what} gives just that irradiance", "another irradiance, flux or intensity"
        )
    return angles


def _is_so(light: Callable[[Any], Any], wanted: float, is_above: bool, off: Any) -> Any:
    """Whether a light is as much as is wanted, or whether it is not."""
    return (light(off) >= wanted) == is_above


def on_plane(
    distribution: Distribution, pose: Pose, radius: Number, x: Number, y: Number, height: Number
) -> Number:
    """Solid angle of a horizontal disc under a source, weighted with the intensity.

    Parameters
    ----------
    distribution, pose
        As of `relative_irradiance`.
    radius : float or ndarray [m]
        Radius of the disc, above 0.
    x, y, height : float or ndarray [m]
        Its centre, as of `relative_irradiance`.

    Returns
    -------
    float or ndarray [lm, W, photon/s or sr]
        The flux on the disc, to 0.1 % or better.

    Raises
    ------
    ConditionError
        If there are too many discs, or the light on one has edges that are too sharp.

    Examples
    --------
    A disc whose rim is seen at 60 degrees fills pi sr:

    >>> from radcalc.distributions.shapes import Isotropic
    >>> round(float(on_plane(Isotropic(), Pose(), 3**0.5, 0.0, 0.0, 1.0)) / math.pi, 5)
    1.0
    """

    if pose.axes[2] == DOWN and not (numpy.any(x) or numpy.any(y)):
        return _about_axis(distribution, radius, height)

    def light(across: Any, along: Any, x: Any, y: Any, height: Any) -> Any:
        return relative_irradiance(distribution, pose, x + across, y + along, height)

    counts = _counts(distribution, radius, height)
    return _over_discs(light, counts, radius, x, y, height)


def on_facing_disc(
    distribution: Distribution, radius: Number, distance: Number, theta: Number, phi: Number
) -> Number:
    """Solid angle of a disc that faces a source, weighted with the intensity.

    Parameters
    ----------
    distribution : Distribution
        Of any form.
    radius, distance : float or ndarray [m]
        Radius of the disc and distance of its centre, above 0.
    theta, phi : float or ndarray [rad]
        Direction of its centre, from the source.

    Returns
    -------
    float or ndarray [lm, W, photon/s or sr]
        As of `on_plane`.

    Raises
    ------
    ConditionError
        As of `on_plane`.

    Examples
    --------
    >>> from radcalc.distributions.shapes import Isotropic
    >>> round(float(on_facing_disc(Isotropic(), 3**0.5, 1.0, 0.7, 0.0)) / math.pi, 5)
    1.0
    """

    if not numpy.any(theta):
        return _about_axis(distribution, radius, distance)

    def light(across: Any, along: Any, distance: Any, theta: Any, phi: Any) -> Any:
        polar, azimuth, slant = _seen(across, along, distance, theta, phi)
        return distribution.intensity(polar, azimuth) * distance / slant**3

    counts = _counts(distribution, radius, distance)
    return _over_discs(light, counts, radius, distance, theta, phi)


def _about_axis(distribution: Distribution, radius: Number, away: Number) -> Number:
    """The flux on discs whose centres are on the axis."""
    return each(lambda r, d: distribution.flux((0.0, math.atan2(r, d))).value, radius, away)


def _counts(distribution: Distribution, radius: Number, away: Number) -> list[int]:
    """How many radii of a disc are looked at, so that nothing of the light falls between them."""
    widest = float(numpy.arctan(numpy.max(radius / away, initial=0.0)))
    least = math.pi * widest / distribution.finest
    counts = [count for count in COUNTS if 2 * count >= least]
    if len(counts) < 2:
        raise ConditionError(
            "the light is too narrow for the receiver to be cut from it",
            "a smaller receiver, or one whose centre is on the axis",
        )
    return counts


def unevenness(
    distribution: Distribution, radius: Number, distance: Number, theta: Number, phi: Number
) -> float:
    """How much the intensity varies over a disc that faces a source.

    Parameters
    ----------
    distribution, radius, distance, theta, phi
        As of `on_facing_disc`.

    Returns
    -------
    float [1]
        The largest difference from that at its centre, relative to it; infinite where that is
        dark and the disc is not.

    Examples
    --------
    Down by 1 - cos(atan(0.1)) at the rim of a disc in a Lambertian light:

    >>> from radcalc.distributions.shapes import Lobe
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
    """The own angles and the distance of points of a disc that faces the source."""
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
    """The integral of a light over discs, with ever more points until they do not matter."""
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
            "the light on the receiver has edges that are too sharp to be integrated",
            "a smaller receiver, or one that is all inside the light",
        )
    return sums.reshape(shape)[()]


def _sums(light: Callable[..., Any], count: int, size: Any, where: list[Any]) -> Any:
    """The integral over each disc: Gauss and Legendre's radii, each of twice as many angles."""
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
