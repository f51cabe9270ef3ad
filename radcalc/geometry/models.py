"""Models of lights: the luminance of the sky, and the attenuations of the cinematographer's light.

The luminance of the sky by direction is relative to its zenith: the 15 types of the CIE standard
general sky, and the traditional overcast sky.  Polar angles are counted from the zenith, azimuths
from any one direction, in radians.  The luminance below the horizon is 0.

The cinematographer's light (uberlight) is at the origin; a spot shines along +z, an omni in all
directions.  The light at a point is multiplied by four attenuations:

- `depth_clip`: 0 before a near and after a far limit, each with a soft edge
- `superellipse_clip`: 0 outside a cross-section between a rectangle and an ellipse, which
  widens in proportion to z
- `beam`: a power of the cosine of the angle off the axis
- `falloff`: a power of the distance, limited to a maximum close to the light

They follow Barzel's paper [1]_ in the version of Gritz's shader [2]_.  Lengths are in one unit;
arguments are floats or NumPy arrays, broadcast together.

References
----------
.. [1] R. Barzel, Lighting Controls for Computer Cinematography, Journal of Graphics Tools 2(1)
   (1997) 1-20, doi:10.1080/10867651.1997.10487467.
.. [2] L. Gritz, uberlight.sl, course notes of Advanced RenderMan: Beyond the Companion, SIGGRAPH
   1998.
"""

import math
import sys
from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

from radcalc import geometry
from radcalc.errors import ConditionError, corrections, mention, nearest, quote
from radcalc.geometry import refuse
from radcalc.geometry.numerics import gauss
from radcalc.geometry.projections import NO_NORMAL, Vector, dot, unit
from radcalc.maths import (
    Number,
    asin,
    atan2,
    cos,
    exp,
    expm1,
    hypot,
    larger,
    limit,
    log,
    piecewise,
    power,
    sin,
    smaller,
    sqrt,
    square,
)

CIE = "CIE S 011:2003 (ISO 15469:2004)"
HALF_PI = math.pi / 2
# Points across and around of ever finer rules; each is compared with the one before.
POINTS = (24, 36), (48, 64), (96, 128), (144, 192)
ACCURACY = 1e-9  # [1] difference at which to stop; the error is then a hundredth of it
ROUNDING = 1e-13  # [1] error of the sums, relative to the integral
FAINT = 1e-300  # avoids a division by 0 in exp(b / 0)
NO_WIDTH = 1e-15  # [rad]
LOW = 1e-3  # [1] cosine below which exp(b / cosine) is negligible
SEVERAL, FEW = 256, 8  # integrals that are kept, and those without NumPy
SAMPLES = 721  # of the meridian on which the peak is searched


class SkyType(NamedTuple):
    """The luminance distribution of a sky.

    Attributes
    ----------
    name : str
        Name in the standard.
    number : int
        Type in the standard; 0 for the traditional overcast sky.
    a, b : float [1]
        Parameters of the gradation from zenith to horizon.
    c, d, e : float [1]
        Parameters of the indicatrix, which brightens the sky about the sun.
    is_linear : bool
        Whether the gradation is instead that of the traditional overcast sky, linear in the cosine.

    Examples
    --------
    >>> TYPES["12"].name
    'CIE standard clear sky, low luminance turbidity'
    """

    name: str
    number: int = 0
    a: float = 0.0
    b: float = -1.0
    c: float = 0.0
    d: float = -1.0
    e: float = 0.0
    is_linear: bool = False

    @property
    def follows_sun(self) -> bool:
        """Return whether the luminance depends on the sun's position.

        Examples
        --------
        >>> TYPES["1"].follows_sun, TYPES["2"].follows_sun
        (False, True)
        """
        return self.c != 0

    def gradation(self, height: Number) -> Number:
        """Return the luminance at a height relative to the horizon, without the sun's influence.

        Parameters
        ----------
        height : float or ndarray [1]
            Cosine of the polar angle, from 0 to 1.

        Returns
        -------
        float or ndarray [1]
            phi(Z) = 1 + a exp(b / cos(Z)), or 1 + 2 cos(Z) if linear; 1 at the horizon.

        Examples
        --------
        >>> OVERCAST.gradation(1.0) / OVERCAST.gradation(0.0)
        3.0
        """
        if self.is_linear:
            return 1 + 2 * height
        return 1 + self.a * exp(self.b / (height + FAINT))

    def indicatrix(self, away: Number) -> Number:
        """Return the factor by which the sun brightens the sky at an angle from it.

        Parameters
        ----------
        away : float or ndarray [rad]
            Angle chi between a direction and the sun.

        Returns
        -------
        float or ndarray [1]
            f(chi) = 1 + c (exp(d chi) - exp(d pi / 2)) + e cos(chi)^2.

        Examples
        --------
        >>> TYPES["12"].indicatrix(math.pi / 2)
        1.0
        """
        return (
            1
            + self.c * (exp(self.d * away) - math.exp(self.d * HALF_PI))
            + self.e * (square(cos(away)))
        )


OVERCAST = SkyType("traditional overcast sky (Moon and Spencer)", is_linear=True)
# a, b, c, d, e of the types 1 to 15, and their descriptions
_TABLE = (
    (4.0, -0.70, 0, -1.0, 0.00, "CIE standard overcast sky"),
    (4.0, -0.70, 2, -1.5, 0.15, "overcast, steeply graded, slightly brighter towards the sun"),
    (1.1, -0.80, 0, -1.0, 0.00, "overcast, moderately graded"),
    (1.1, -0.80, 2, -1.5, 0.15, "overcast, moderately graded, slightly brighter towards the sun"),
    (0.0, -1.00, 0, -1.0, 0.00, "sky of uniform luminance"),
    (0.0, -1.00, 2, -1.5, 0.15, "partly cloudy, not graded, slightly brighter towards the sun"),
    (0.0, -1.00, 5, -2.5, 0.30, "partly cloudy, not graded, brighter around the sun"),
    (0.0, -1.00, 10, -3.0, 0.45, "partly cloudy, not graded, with a distinct solar corona"),
    (-1.0, -0.55, 2, -1.5, 0.15, "partly cloudy, with the sun obscured"),
    (-1.0, -0.55, 5, -2.5, 0.30, "partly cloudy, brighter around the sun"),
    (-1.0, -0.55, 10, -3.0, 0.45, "white-blue sky with a distinct solar corona"),
    (-1.0, -0.32, 10, -3.0, 0.45, "CIE standard clear sky, low luminance turbidity"),
    (-1.0, -0.32, 16, -3.0, 0.30, "CIE standard clear sky, polluted atmosphere"),
    (-1.0, -0.15, 16, -3.0, 0.30, "cloudless turbid sky with a broad solar corona"),
    (-1.0, -0.15, 24, -2.8, 0.15, "white-blue turbid sky with a broad solar corona"),
)
TYPES = {
    "overcast": OVERCAST,
    **{str(k): SkyType(row[-1], k, *row[:-1]) for k, row in enumerate(_TABLE, start=1)},
}

# Errors if a sky, or the light of its sun, depends on the sun's position.
MISSING_SUN = "the sun's elevation is missing", mention("{sun-elevation=40deg}")
MISSING_AZIMUTH = "the sun's azimuth is missing", mention("{sun-azimuth=180deg}")
IS_EVEN = "to the sky type {}, which is the same at every azimuth"  # of its name
# Other names of some types.
ALSO = {"uniform": "5", "intermediate": "7", "clear": "12", "turbid": "13"}
# Other words for skies.
MEANT = {
    "cloudy": "overcast intermediate",
    "grey": "overcast",
    "gray": "overcast",
    "partly-cloudy": "intermediate",
    "hazy": "turbid intermediate",
    "sunny": "clear",
    "blue": "clear",
}
NAMES = ("overcast", *ALSO, *(name for name in TYPES if name != "overcast"))


def sky_type(name: str) -> SkyType:
    """Return a sky by its name or number.

    Parameters
    ----------
    name : str
        overcast (the traditional one), uniform (5), intermediate (7), clear (12), turbid (13), or
        the number of a CIE type, "1" (the other overcast sky) to "15".

    Returns
    -------
    SkyType

    Raises
    ------
    ConditionError
        If the sky is unknown.

    Examples
    --------
    >>> sky_type("clear") is TYPES["12"]
    True
    """
    if name not in NAMES:
        close = MEANT.get(name, "").split() or nearest(name, [n for n in NAMES if n.isalpha()])
        raise ConditionError(
            f"unknown sky '{quote(name)}'",
            corrections(name, *close) or f"overcast, {', '.join(ALSO)}, 1 to 15",
        )
    return TYPES[ALSO.get(name, name)]


def angle_between(polar: Number, azimuth: Number, sun: tuple[Number, Number]) -> Number:
    """Return the angle between directions and the sun.

    Parameters
    ----------
    polar, azimuth : float or ndarray [rad]
        The directions.
    sun : tuple of 2 floats [rad]
        Polar angle and azimuth of the sun.

    Returns
    -------
    float or ndarray [rad]
        From 0 to pi, with all digits close to the sun.

    Examples
    --------
    >>> angle_between(0.3, 1.0, (0.5, 1.0))
    0.2
    """
    height, bearing = sun
    half = square(sin((polar - height) / 2)) + sin(polar) * sin(height) * square(
        sin((azimuth - bearing) / 2)
    )
    return 2 * asin(sqrt(smaller(half, 1.0 + 0 * half)))


def relative_luminance(
    sky: SkyType, polar: Number, azimuth: Number, sun: tuple[Number, Number] | None = None
) -> Number:
    """Return the luminance of the sky relative to its zenith.

    Parameters
    ----------
    sky : SkyType
        One of `TYPES`.
    polar, azimuth : float or ndarray [rad]
        Direction; broadcast together.
    sun : tuple of 2 floats [rad], optional
        Polar angle and azimuth of the sun, for a sky that follows it.

    Returns
    -------
    float or ndarray [1]
        L / Lz = f(chi) phi(Z) / (f(Zs) phi(0)); 0 below the horizon.

    References
    ----------
    CIE S 011:2003 (ISO 15469:2004), Spatial distribution of daylight.

    Examples
    --------
    >>> round(relative_luminance(OVERCAST, math.radians(60), 0.0), 12)
    0.666666666667
    """
    height = cos(polar)
    ratio = (polar <= HALF_PI) * sky.gradation((height + abs(height)) / 2) / sky.gradation(1.0)
    if sky.follows_sun:
        assert sun is not None
        ratio = ratio * sky.indicatrix(angle_between(polar, azimuth, sun))
        ratio = ratio / sky.indicatrix(sun[0])
    return ratio + 0.0 * azimuth


def projected_sky(
    sky: SkyType, normal: Vector, sun: tuple[float, float] | None = None
) -> tuple[float, float]:
    """Return the irradiance of a plane over the radiance of the zenith: a weighted solid angle.

    Parameters
    ----------
    sky, sun
        As in `relative_luminance`.
    normal : tuple of 3 floats
        Normal of the plane, of any length except 0.

    Returns
    -------
    value, error : float [sr]
        The integral of L / Lz times the cosine to the normal, over the directions above both the
        horizon and the plane, and an estimate of its error: mostly below a relative 1e-12, seldom
        above 1e-9.

    Raises
    ------
    ConditionError
        If the length of the normal is 0.

    Notes
    -----
    With the tilt T of the plane from the horizontal, a uniform sky gives pi (1 + cos(T)) / 2, the
    traditional overcast sky a third of that plus 4/9 ((pi - T) cos(T) + sin(T)).

    The others are integrated in polar coordinates about the sun, where the luminance has a kink,
    along the arcs of each circle about it above both horizons.

    Examples
    --------
    The ground and a wall under the traditional overcast sky, 7 pi / 9 and pi / 6 + 4 / 9:

    >>> [round(projected_sky(OVERCAST, normal)[0], 6) for normal in ((0, 0, 1), (1, 0, 0))]
    [2.443461, 0.968043]
    """
    refuse(not any(normal), *NO_NORMAL)
    facing = unit(normal)
    across = math.hypot(facing[0], facing[1])
    if 1 + facing[2] < ROUNDING:  # the plane faces the ground
        return 0.0, 0.0
    if not sky.follows_sun and not sky.a:
        even = HALF_PI * (1 + facing[2])
        if not sky.is_linear:
            return even, ROUNDING * even
        tilt = math.atan2(across, facing[2])
        integral = even / 3 + 4 / 9 * ((math.pi - tilt) * facing[2] + across)
        return integral, ROUNDING
    return _integrals(sky, sun, facing)


def mean_sky(sky: SkyType, sun: tuple[float, float] | None = None) -> tuple[float, float]:
    """Return the mean luminance of the sky, by solid angle, relative to its zenith.

    Parameters
    ----------
    sky, sun
        As in `relative_luminance`.

    Returns
    -------
    value, error : float [1]
        The mean over the hemisphere, and an estimate of its error.

    Examples
    --------
    >>> round(mean_sky(OVERCAST)[0], 12)
    0.666666666667
    """
    if sky.is_linear:
        return 2 / 3, ROUNDING
    value, error = _integrals(sky, sun, None)
    return value / (2 * math.pi), error / (2 * math.pi)


def brightest(sky: SkyType, sun: tuple[float, float] | None = None) -> tuple[float, float, float]:
    """Return the greatest luminance of the sky relative to its zenith, and its direction.

    Parameters
    ----------
    sky, sun
        As in `relative_luminance`.

    Returns
    -------
    value : float [1]
        The greatest L / Lz.
    polar, azimuth : float [rad]
        A direction with that luminance, on the sun's meridian.

    Examples
    --------
    >>> brightest(OVERCAST)
    (1.0, 0.0, 0.0)
    """
    height, bearing = sun if sun and sky.follows_sun else (0.0, 0.0)

    def along(angle: float) -> float:
        """Return the luminance on the meridian, by the angle from the zenith towards the sun."""
        return float(sky.gradation(cos(angle)) * sky.indicatrix(abs(angle - height)))

    places = [HALF_PI * (2 * k / (SAMPLES - 1) - 1) for k in range(SAMPLES)]
    best = max([0.0, height, *places], key=along)
    step = HALF_PI / (SAMPLES - 1)
    low, high = max(best - step, -HALF_PI), min(best + step, HALF_PI)
    if low < best < high and best not in (0.0, height):
        nudge = step * 1e-6
        best = limit(lambda x: along(x + nudge) >= along(x - nudge), high, low)
    value = along(best) / (sky.gradation(1.0) * sky.indicatrix(height))
    return value, abs(best), (bearing + math.pi if best < 0 else bearing) % (2 * math.pi)


@lru_cache(SEVERAL)
def _integrals(
    sky: SkyType, sun: tuple[float, float] | None, facing: Vector | None
) -> tuple[float, float]:
    """Return the integral of the relative luminance, and an estimate of its error."""
    polar, azimuth = sun if sun and sky.follows_sun else (0.0, 0.0)
    turned = None
    if facing:
        x, y, z = facing
        turned = (
            x * math.cos(azimuth) + y * math.sin(azimuth),
            y * math.cos(azimuth) - x * math.sin(azimuth),
            z,
        )
    value, error = 0.0, math.inf
    for count in POINTS:
        before, value = value, _integral(sky, polar, turned, *count)
        error = abs(value - before)
        if error <= ACCURACY * value:
            break
    scale = sky.gradation(1.0) * sky.indicatrix(polar)
    return value / scale, (error + ROUNDING * value) / scale


def _integral(sky: SkyType, polar: float, facing: Vector | None, across: int, around: int) -> float:
    """Return the integral of gradation times indicatrix, times the cosine to any normal.

    The sun is at the azimuth 0.  A direction has the angle chi from the sun and the azimuth psi
    about it, from the direction of the zenith.  Its cosine to an axis is (cosine of the axis to the
    sun) cos(chi) + (sine of the axis to the sun) sin(chi) cos(psi - psi of the axis).
    """
    sun = (math.sin(polar), 0.0, math.cos(polar))
    upward, aside = (-sun[2], 0.0, sun[0]), (0.0, 1.0, 0.0)
    cuts = [0.0, math.pi, HALF_PI - polar, HALF_PI + polar]
    along, swing, bearing = 0.0, 0.0, 0.0
    if facing:
        along = dot(facing, sun)
        swing = math.hypot(dot(facing, upward), facing[1])
        bearing = math.atan2(dot(facing, aside), dot(facing, upward))
        tilt = math.atan2(swing, along)
        met = abs(HALF_PI - tilt)
        cuts += [met, math.pi - met]
        level = math.hypot(facing[0], facing[1])
        if level:  # where the plane meets the horizon
            meets = math.acos(max(-1.0, min(1.0, facing[1] / level * sun[0])))
            cuts += [meets, math.pi - meets]
    cuts.sort()
    total, graded = [], []
    for low, high in pairwise(cuts):
        if high - low < NO_WIDTH:
            continue
        for place, weight in _rule(across):
            away = low + (high - low) * place
            near, far = math.cos(away), math.sin(away)
            rise, lift = near * sun[2], far * sun[0]
            level, turn = (near * along, far * swing) if facing else (1.0, 0.0)
            share = weight * (high - low) * far * sky.indicatrix(away)
            for start, end in _arcs(_half_arc(rise, lift), _half_arc(level, turn), bearing):
                even = level * (end - start)
                even += turn * (math.sin(end - bearing) - math.sin(start - bearing))
                total.append(share * even)
                width = end - start
                graded.append((rise, lift, level, turn, start, width, share * width))
    if sky.a and graded:
        total.append(sky.a * _graded(sky.b, bearing, graded, _rule(around)))
    return math.fsum(total)


def _graded(
    b: float, bearing: float, arcs: Sequence[Sequence[float]], rule: Sequence[tuple[float, float]]
) -> float:
    """Return the integral over arcs of exp(b / height) times the cosine to the normal.

    If NumPy is loaded, it computes all points at once; a table of answers loads it.
    """
    numpy: Any = sys.modules.get("numpy")
    if numpy is None and _integrals.cache_info().misses > FEW:
        import numpy
    if numpy is None:
        return math.fsum(
            sum(weight * _at(math, b, bearing, arc, place) for place, weight in rule)
            for arc in arcs
        )
    places, weights = numpy.array(rule).T
    heights = _at(numpy, b, bearing, numpy.array(arcs).T[:, :, None], places)
    return float(numpy.sum(heights * weights))


def _at(functions: Any, b: float, bearing: float, arc: Sequence[Any], place: Number) -> Number:
    """Return exp(b / height) times the cosine to the normal, with functions of `math` or NumPy."""
    rise, lift, level, turn, start, width, size = arc
    psi = start + width * place
    height = rise + lift * functions.cos(psi)
    above = (height + LOW + abs(height - LOW)) / 2  # at least LOW
    return size * (level + turn * functions.cos(psi - bearing)) * functions.exp(b / above)


def _half_arc(level: float, swing: float) -> float:
    """Return half the arc of a circle that is above a horizon [rad]."""
    if abs(level) >= swing:
        return math.pi if level > 0 else 0.0
    return math.acos(-level / swing)


def _arcs(half: float, other: float, bearing: float) -> list[tuple[float, float]]:
    """Return the arcs within `half` of 0 and within `other` of `bearing`."""
    if half == math.pi:
        return [(bearing - other, bearing + other)] if other else []
    arcs = []
    for turn in (-2 * math.pi, 0.0, 2 * math.pi):
        start, end = max(-half, bearing - other + turn), min(half, bearing + other + turn)
        if other == math.pi:
            start, end = -half, half
        if start < end:
            arcs.append((start, end))
            if other == math.pi:
                break
    return arcs


_RULES: dict[int, list[tuple[float, float]]] = {}


def _rule(n: int) -> list[tuple[float, float]]:
    """Return places and weights of a Gauss-Legendre rule on [0, 1], mapped by a cubic.

    The cubic makes a square root at an end smooth, and puts more points close to the ends.
    """
    if n not in _RULES:
        _RULES[n] = [
            ((2 - x) * (1 + x) ** 2 / 4, 0.75 * (1 - x) * (1 + x) * weight)
            for x, weight in zip(*gauss(n), strict=True)
        ]
    return _RULES[n]


MOST = 690.0  # largest logarithm whose exponential a float holds
OUTSIDE = 1e150  # outside every cross-section


def smoothstep(low: Number, high: Number, x: Number) -> Number:
    """Return the smooth step from 0 at one limit to 1 at another.

    Parameters
    ----------
    low, high : float or ndarray
        The limits, low <= high, in any one unit.
    x : float or ndarray
        The position, in the same unit.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; if the limits are equal, 0 below them, else 1.

    Notes
    -----
    ::

        t^2 (3 - 2 t),  t = (x - low) / (high - low), limited to 0 .. 1

    Its slope is 0 at both limits.

    Examples
    --------
    >>> smoothstep(1.0, 3.0, 1.5), smoothstep(2.0, 2.0, 2.0)
    (0.15625, 1.0)
    """

    def between(low: Number, high: Number, x: Number) -> Number:
        t = (x - low) / (high - low)
        return t * t * (3 - 2 * t)

    def ends(low: Number, high: Number, x: Number) -> Number:
        return piecewise(x >= high, lambda x: 1.0 + 0 * x, lambda x: 0.0 * abs(x), x)

    return piecewise((x > low) & (x < high), between, ends, low, high, x)


def depth_clip(
    depth: Number,
    near: tuple[Number, Number] | None = None,
    far: tuple[Number, Number] | None = None,
) -> Number:
    """Return the attenuation by the depth of a point: 0 before a near and after a far limit.

    Parameters
    ----------
    depth : float or ndarray
        z of the point for a spot; its distance from the light for an omni.
    near : tuple of 2 floats or ndarrays, optional
        Depths at which the light begins, and at which it becomes full.
    far : tuple of 2 floats or ndarrays, optional
        Depths up to which the light is full, and at which it ends.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; 0 for a depth of 0 or less.

    Notes
    -----
    ::

        smoothstep(A, B, z) (1 - smoothstep(C, D, z))

    Examples
    --------
    >>> depth_clip(1.5, near=(1.0, 2.0)), depth_clip(-1.0)
    (0.5, 0.0)
    """
    clip = piecewise(depth > 0, lambda z: 1.0 + 0 * z, lambda z: 0.0 * abs(z), depth)
    if near is not None:
        clip = clip * smoothstep(*near, depth)
    if far is not None:
        clip = clip * (1 - smoothstep(*far, depth))
    return clip


def cross_section(
    x: Number, y: Number, z: Number, shear: tuple[Number, Number] = (0.0, 0.0)
) -> tuple[Number, Number]:
    """Return where the light to a point crosses the plane z = 1, from the beam's centre.

    Parameters
    ----------
    x, y, z : float or ndarray
        The point.
    shear : tuple of 2 floats or ndarrays, optional
        Centre of the beam in that plane.

    Returns
    -------
    tuple of 2 floats or ndarrays [1]
        Distances along x and y; 1e150, outside every cross-section, for z of 0 or less or too small
        for the quotients.

    Notes
    -----
    ::

        |x / z - X|,  |y / z - Y|

    Examples
    --------
    >>> cross_section(3.0, 1.0, 2.0, shear=(0.5, 0.0)), cross_section(0.0, 0.0, -1.0)
    ((1.0, 0.5), (1e+150, 1e+150))
    """
    u, v = (
        piecewise(
            z > 0,
            lambda z, aside, s: smaller(abs(aside / z - s), OUTSIDE + 0 * z),
            lambda z, aside, s: OUTSIDE + 0 * (z + aside + s),
            z,
            aside,
            centre,
        )
        for aside, centre in zip((x, y), shear, strict=True)
    )
    return u, v


def superellipse_scale(
    x: Number, y: Number, width: Number, height: Number, roundness: Number
) -> Number:
    """Return the factor that scales a superellipse so that it passes through a point.

    Parameters
    ----------
    x, y : float or ndarray
        The point; only its distances from the axes matter.
    width, height : float or ndarray
        Half axes along x and y, above 0, in the unit of the point.
    roundness : float or ndarray [1]
        From above 0 to 1: 1 is an ellipse; towards 0 it becomes a rectangle.

    Returns
    -------
    float or ndarray [1]
        Below 1 for a point inside, above 1 outside.

    Notes
    -----
    ::

        ((|x| / a)^(2/R) + (|y| / b)^(2/R))^(R/2)

    Computed so that no power overflows.

    Examples
    --------
    >>> superellipse_scale(3.0, 4.0, 1.0, 1.0, 1.0), superellipse_scale(3.0, 4.0, 1.0, 1.0, 1e-6)
    (5.0, 4.0)
    """
    across, along = abs(x) / width, abs(y) / height
    most, least = larger(across, along), smaller(across, along)
    ratio = piecewise(most > 0, lambda m, n: n / m, lambda m, n: 0.0 * m, most, least)
    return most * power(1 + power(ratio, 2 / roundness), roundness / 2)


def superellipse_clip(
    x: Number,
    y: Number,
    inner: tuple[float, float],
    outer: tuple[float, float],
    roundness: Number = 1.0,
) -> Number:
    """Return the attenuation by a spot's cross-section: 1 inside, 0 outside, soft between.

    Parameters
    ----------
    x, y : float or ndarray [1]
        Point of the plane z = 1, from `cross_section`.
    inner : tuple of 2 floats [1]
        Half width and half height of the area of full light in that plane, above 0.
    outer : tuple of 2 floats [1]
        Half width and half height of the area of all light; at least as large.
    roundness : float or ndarray [1], optional
        From 0, a rectangle, to 1, an ellipse.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1.

    Notes
    -----
    ::

        1 - smoothstep(q, r, 1)
        q = a b / ((b |x|)^(2/R) + (a |y|)^(2/R))^(R/2),  r the same with A and B

    q and r are the reciprocals of `superellipse_scale`.  For R = 0, a rectangle, it is the product
    of the attenuations along both axes, as in the shader:

    ::

        (1 - smoothstep(a, A, |x|)) (1 - smoothstep(b, B, |y|))

    which for soft edges is not quite the limit of the first formula.

    Examples
    --------
    >>> superellipse_clip(1.2, 0.0, inner=(1.0, 1.0), outer=(1.5, 1.5))
    0.648
    """
    (a, b), (outer_a, outer_b) = inner, outer

    def rounded(x: Number, y: Number, roundness: Number) -> Number:
        """Return 1 inside, 0 outside, and a smooth step between two superellipses."""
        return piecewise(
            (x == 0) & (y == 0),
            lambda x, y, R: 1.0 + 0 * x,
            lambda x, y, R: (
                1
                - smoothstep(
                    1 / superellipse_scale(x, y, a, b, R),
                    1 / superellipse_scale(x, y, outer_a, outer_b, R),
                    1.0 + 0 * x,
                )
            ),
            x,
            y,
            roundness,
        )

    def rectangle(x: Number, y: Number, roundness: Number) -> Number:
        return (1 - smoothstep(a, outer_a, abs(x))) * (1 - smoothstep(b, outer_b, abs(y)))

    return piecewise(roundness > 0, rounded, rectangle, x, y, roundness)


def beam(x: Number, y: Number, z: Number, exponent: Number) -> Number:
    """Return the attenuation by the angle off the axis of a spot: a power of its cosine.

    Parameters
    ----------
    x, y, z : float or ndarray
        The point.
    exponent : float or ndarray [1]
        Exponent n, 0 or more.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; 0 for z of 0 or less.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        (z / d)^n = cos^n(gamma)

    Computed with the logarithm of the cosine, which keeps the digits close to the axis.

    Examples
    --------
    >>> round(beam(3**0.5, 0.0, 1.0, 2.0), 12), beam(0.0, 0.0, -1.0, 2.0)
    (0.25, 0.0)
    """
    refuse(exponent < 0, "the beam exponent is out of range", "0 or more")
    return piecewise(
        z > 0,
        lambda z, off, n: exp(n * geometry.ln_cos(atan2(off, z))),
        lambda z, off, n: 0.0 * (abs(z) + off + n),
        z,
        hypot(x, y),
        exponent,
    )


def falloff(
    distance: Number, exponent: Number, reference: Number, maximum: Number | None = None
) -> Number:
    """Return the attenuation by the distance: a power of it, limited within the fall-off distance.

    Parameters
    ----------
    distance : float or ndarray
        Distance d from the light, above 0.
    exponent : float or ndarray [1]
        Exponent N, 0 or more; 2 is an inverse square.
    reference : float or ndarray
        Fall-off distance L, above 0, at which the attenuation is 1.
    maximum : float or ndarray [1], optional
        Attenuation M at the light, 1 or more; no maximum by default.

    Returns
    -------
    float or ndarray [1]
        Up to 1 from L on; up to M within L.

    Raises
    ------
    ConditionError
        If an argument is out of range, or a float cannot hold the attenuation.

    Notes
    -----
    ::

        (L / d)^N                                    beyond L, and everywhere without a maximum
        M exp(s (d / L)^beta), s = ln(1/M), beta = -N / s       within L

    Both have the value 1 and the slope -N / L at L.  For M = 1 the limit is 1 everywhere within L.

    Examples
    --------
    >>> round(falloff(2.0, 2.0, 1.0), 12), round(falloff(0.5, 2.0, 1.0), 12)
    (0.25, 4.0)
    >>> round(falloff(1e-9, 2.0, 1.0, maximum=3.0), 6)
    3.0
    """
    refuse(distance <= 0, "the distance from the light is out of range", "more than 0")
    refuse(exponent < 0, "the fall-off exponent is out of range", "0 or more")
    refuse(reference <= 0, "the fall-off distance is out of range", "more than 0")
    if maximum is None:
        return _power(distance, exponent, reference)
    refuse(maximum < 1, "the maximum is out of range", "1 or more")
    return piecewise(
        distance < reference,
        _limited,
        lambda d, n, far, m: _power(d, n, far) + 0 * m,
        distance,
        exponent,
        reference,
        maximum,
    )


def _power(distance: Number, exponent: Number, reference: Number) -> Number:
    ratio = reference / distance
    beyond = abs(exponent * log(ratio)) > MOST
    refuse(beyond, "the attenuation is too large or too small for a number", "a smaller exponent")
    return power(ratio, exponent)


def _limited(distance: Number, exponent: Number, reference: Number, maximum: Number) -> Number:
    """Return exp(-m expm1(x / m)), with m = ln M and x = N ln(d / L), for d below L."""
    return piecewise(
        maximum > 1,
        lambda x, m: exp(-m * expm1(x / m)),
        lambda x, m: 1.0 + 0 * (x + m),
        exponent * log(distance / reference),
        log(maximum),
    )
