"""Luminance of the sky by direction, relative to its zenith, and irradiance of a plane.

The 15 types of the CIE standard general sky, and the traditional overcast sky.  Polar angles are
counted from the zenith, azimuths from any one direction, in radians.  The luminance below the
horizon is 0.
"""

import math
import sys
from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any, NamedTuple

from radcalc.errors import ConditionError, corrections, mention, nearest, quote
from radcalc.geometry.cones import refuse
from radcalc.geometry.directions import NO_NORMAL, Vector, dot, unit
from radcalc.geometry.numerics.integrals import gauss
from radcalc.maths import Number, asin, cos, exp, limit, sin, smaller, sqrt, square

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
