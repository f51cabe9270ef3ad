"""The geometry under radiometry and photometry.

- `solid`: solid angles of shapes [sr], which turn intensity into flux, projected ones [sr], which
  turn radiance into irradiance, and etendues of beams [m^2 sr], which turn radiance into flux.
- `receivers`: light of a cone, a lobe or an isotropic source on a round receiver of any size.
- `models`: the CIE skies, and the attenuations of a cinematographer's light.
- `projections`: vectors, directions [rad], and maps of the sphere.
- `polygons`: plane polygons, and the check of their vertices.
- `numerics`: integrals, special functions and typed expressions.

This module has what a conversion needs: cones and lobes [sr], the cosine of the light on a
surface, and range checks.  A lobe of exponent n has the intensity I(theta) = I0 cos^n(theta) up to
90 degrees from its axis and 0 beyond.  n = 1 is a Lambertian surface, n = 0 a uniform hemisphere; a
spotlight with a beam angle of 30 degrees has n = 20.  The flux is 2 pi I0 / (n + 1).

Angles are in radians; the lengths of a shape are in any one unit.  Arguments are floats or NumPy
arrays, broadcast together; for floats only the integrals over directions import NumPy.  Arguments
out of range raise a `ConditionError`.  The examples assume the names of their module.
"""

import math
from collections.abc import Callable, Sequence
from functools import wraps
from typing import Any, TypeVar

from radcalc import maths
from radcalc.errors import ConditionError, Try
from radcalc.maths import LARGEST

FULL = 4 * math.pi  # [sr] all directions
HEMISPHERE = 2 * math.pi  # [sr] all directions on one side of a plane
# Names of arguments that have a lower limit as well as an upper one.
SIZES = {"radius", "other", "distance", "height", "width", "length", "area", "reach"}

F = TypeVar("F", bound=Callable[..., Any])


def refuse(bad: Any, message: str, hint: str, tries: Sequence[Try] = ()) -> None:
    """Raise a `ConditionError` if a comparison holds for any element.

    Parameters
    ----------
    bad : bool or ndarray of bool
        The comparison that must not hold, such as ``radius < 0``.  A comparison with NaN is
        false, so NaN passes.
    message : str
        Message of the error.
    hint : str
        Valid values, shown after ``try:``.
    tries : sequence of Try, optional
        Calls to propose with a hint in words.

    Raises
    ------
    ConditionError
        If `bad` is true, or true for any element of an array.

    Examples
    --------
    >>> refuse(-1.0 < 0, "the radius is out of range", "0 or more")
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: the radius is out of range
    try: 0 or more
    """
    if maths.any_true(bad):
        raise ConditionError(message, hint, tries)


def bounded(function: F) -> F:
    """Make a function refuse sizes and angles too large or too small for its formulas.

    Parameters
    ----------
    function : callable
        Takes floats and arrays; None and tuples among its arguments are not checked.

    Returns
    -------
    callable
        The same function; NaN gives NaN.

    Raises
    ------
    ConditionError
        If it is called with a value above 1e100, or a size below 1e-100 that is not 0.

    Examples
    --------
    >>> from radcalc.geometry import solid
    >>> solid.disc(1.0, float("inf"))
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: a size of inf is out of range
    try: sizes from 1e-100 to 1e+100
    """

    names = function.__code__.co_varnames

    @wraps(function)
    def checked(*given: Any, **named: Any) -> Any:
        for name, size in (*zip(names, given, strict=False), *named.items()):
            if size is None or isinstance(size, tuple):
                continue
            far = abs(size)
            least = 1 / LARGEST if name in SIZES else 0.0
            if maths.any_true((far > LARGEST) | ((far < least) & (far > 0))):
                size_text = f"a size of {size}" if isinstance(size, float) else "one of the sizes"
                raise ConditionError(
                    f"{size_text} is out of range",
                    f"sizes from {1 / LARGEST:g} to {LARGEST:g}",
                )
            if isinstance(size, float) and size != size:
                return size
        return function(*given, **named)

    return checked  # type: ignore[return-value]


def cone(half_angle: maths.Number) -> maths.Number:
    """Return the solid angle of a circular cone.

    Parameters
    ----------
    half_angle : float or ndarray [rad]
        Angle alpha between the axis and the side, from 0 (nothing) through pi/2 (a hemisphere)
        to pi (all directions).  The apex angle of a data sheet is twice this.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 4 pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega = 2 pi (1 - cos(alpha)) = 4 pi sin^2(alpha/2)

    Exact.  The second form is computed, because cos(alpha) of a narrow cone rounds to 1.

    References
    ----------
    .. [1] ISO 80000-3, solid angle.
    .. [2] CIE e-ILV 17-21-109, solid angle.

    Examples
    --------
    A cone of half angle 60 degrees is a quarter of all directions, pi sr:

    >>> round(cone(math.radians(60)) / math.pi, 12)
    1.0
    """
    bad = (half_angle < 0) | (half_angle > math.pi * (1 + maths.SLACK))
    refuse(bad, "the half angle of the cone is out of range", "from 0 to 180 deg")
    return FULL * maths.square(maths.sin(half_angle / 2))


def cone_of(solid_angle: maths.Number) -> maths.Number:
    """Return the half angle of the circular cone with a given solid angle; the inverse of `cone`.

    Parameters
    ----------
    solid_angle : float or ndarray [sr]
        Solid angle Omega of the cone, from 0 to 4 pi.

    Returns
    -------
    float or ndarray [rad]
        Half angle, from 0 to pi.

    Raises
    ------
    ConditionError
        If a solid angle is negative or above 4 pi by more than a relative 1e-12: a typed
        12.566370614360 sr is accepted as 4 pi.

    Notes
    -----
    ::

        alpha = 2 arcsin(sqrt(Omega / (4 pi)))

    Exact.  Close to 4 pi the problem is badly conditioned: pi - alpha grows as the square root of
    4 pi - Omega, so a relative rounding of 1e-16 in Omega becomes 1e-8 rad in alpha.

    References
    ----------
    .. [1] ISO 80000-3, solid angle.

    Examples
    --------
    >>> round(math.degrees(cone_of(math.pi)), 10)
    60.0
    """
    part = solid_angle / FULL
    bad = (part < 0) | (part > 1 + maths.SLACK)
    refuse(bad, "the solid angle of the cone is out of range", "from 0 to 4pi sr")
    return 2 * maths.asin(
        maths.sqrt(maths.piecewise(part > 1, lambda p: 1.0 + 0 * p, lambda p: p, part))
    )


def projected_cone(half_angle: maths.Number) -> maths.Number:
    """Return the projected solid angle of a cone onto the plane perpendicular to its axis.

    Parameters
    ----------
    half_angle : float or ndarray [rad]
        From the axis to the edge, from 0 to pi; only directions in front of the plane count.

    Returns
    -------
    float or ndarray [sr]
        From 0 to pi; pi for half angles from pi/2 on.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega_p = pi sin^2(alpha)

    The integral of cos(theta) over the cone: the irradiance on that plane over the uniform radiance
    of the cone (ISO 80000-7, radiance and irradiance).

    Examples
    --------
    A half angle of 30 degrees projects to a quarter of the hemisphere's pi:

    >>> round(projected_cone(math.radians(30)) / math.pi, 12)
    0.25
    """
    cone(half_angle)  # checks the half angle
    return math.pi * maths.piecewise(
        half_angle < math.pi / 2,
        lambda a: maths.square(maths.sin(a)),
        lambda a: 1.0 + 0 * a,
        half_angle,
    )


def projected_cone_of(solid_angle: maths.Number) -> maths.Number:
    """Return the half angle of the cone with a projected solid angle, up to a hemisphere.

    Parameters
    ----------
    solid_angle : float or ndarray [sr]
        Projected onto the plane perpendicular to the axis, from 0 to pi.

    Returns
    -------
    float or ndarray [rad]
        From 0 to pi/2.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        alpha = arcsin sqrt(Omega_p / pi)

    Examples
    --------
    >>> round(math.degrees(projected_cone_of(math.pi / 4)), 12)
    30.0
    """
    part = solid_angle / math.pi
    bad = (part < 0) | (part > 1 + maths.SLACK)
    refuse(bad, "the projected solid angle of the cone is out of range", "from 0 to pi sr")
    return maths.asin(
        maths.sqrt(maths.piecewise(part > 1, lambda p: 1.0 + 0 * p, lambda p: p, part))
    )


def check_tilt(tilt: maths.Number) -> None:
    """Refuse a tilt outside -pi to pi.

    Parameters
    ----------
    tilt : float or ndarray [rad]
        Angle from a normal.

    Raises
    ------
    ConditionError
        If an angle is below -pi or above pi, as when degrees are taken for radians.

    Examples
    --------
    >>> check_tilt(45.0)
    Traceback (most recent call last):
        ...
    radcalc.errors.ConditionError: the tilt is out of range
    try: from 0 to 180 deg
    """
    refuse(abs(tilt) > math.pi * (1 + maths.SLACK), "the tilt is out of range", "from 0 to 180 deg")


def facing(tilt: maths.Number) -> maths.Number:
    """Return the cosine of the incidence on a flat surface, 0 for light on its back.

    Parameters
    ----------
    tilt : float or ndarray [rad]
        Angle theta between the surface's normal and the light; its sign does not matter.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1: cos(theta) below pi/2, 0 from there on.

    Notes
    -----
    ::

        max(cos(theta), 0)

    The ratio of the projected area to the area.  At exactly pi/2 it is 0, not the rounded cosine
    6e-17.

    Examples
    --------
    >>> round(facing(math.radians(60)), 12), facing(math.radians(120))
    (0.5, 0.0)
    """
    return maths.piecewise(
        abs(tilt) < math.pi / 2, maths.cos, lambda t: 0.0 * maths.smaller(math.pi, abs(t)), tilt
    )


LEAST_EXPONENT = 1e-150  # [rad] full angle whose square a float can hold


def ln_cos(angle: maths.Number) -> maths.Number:
    """Return the natural logarithm of the cosine of an angle.

    Parameters
    ----------
    angle : float or ndarray [rad]
        From -pi/2 to pi/2, both excluded.

    Returns
    -------
    float or ndarray [1]
        0 or less.

    Raises
    ------
    ConditionError
        If an angle is below -pi/2 or above pi/2.

    Notes
    -----
    ::

        ln cos(x) = log1p(-2 sin^2(x/2))

    The cosine of a small angle rounds to 1, and its logarithm would lose all digits.  Close to
    pi/2 the result is as exact as the logarithm of the cosine.

    Examples
    --------
    >>> ln_cos(1e-9)
    -5e-19
    """
    bad = abs(angle) > math.pi / 2
    refuse(bad, "a lobe has no light beyond 90 deg from its axis", "from 0 to 90 deg")
    return maths.log1p(-2 * maths.square(maths.sin(angle / 2)))


def lobe_exponent(full_angle: maths.Number, share: float) -> maths.Number:
    """Return the exponent of the lobe that falls to a share of its peak at a given full angle.

    Parameters
    ----------
    full_angle : float or ndarray [rad]
        Full angle between the two directions with that share, above 0 and below pi.
    share : float [1]
        Share of the peak, above 0 and below 1: 1/2 for the beam angle, 1/10 for the field angle.

    Returns
    -------
    float or ndarray [1]
        Exponent n, above 0.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        n = ln(share) / ln(cos(full_angle / 2))

    References
    ----------
    .. [1] CIE e-ILV 17-27-077, beam angle: a full angle, to 50 % of the centre beam intensity.
    .. [2] J. M. Kahn and J. R. Barry, Wireless Infrared Communications, Proc. IEEE 85 (1997) 265,
       doi:10.1109/5.554222.  "Generalized Lambertian" with the order n.

    Examples
    --------
    A Lambertian surface, n = 1, falls to cos(60 deg) = 1/2 at a full angle of 120 degrees:

    >>> round(lobe_exponent(math.radians(120), 0.5), 12)
    1.0
    """
    _check_share(share)
    bad = (full_angle <= LEAST_EXPONENT) | (full_angle >= math.pi)
    refuse(bad, "the full angle is out of range", "more than 0 and less than 180 deg")
    return math.log(share) / ln_cos(full_angle / 2)


def _check_share(share: float) -> None:
    bad = (share <= 0) | (share >= 1)
    refuse(bad, "the share of the peak is out of range", "more than 0 and less than 1")


def lobe_angle(exponent: maths.Number, share: float) -> maths.Number:
    """Return the full angle at which a lobe falls to a share of its peak; inverse of `exponent`.

    Parameters
    ----------
    exponent : float or ndarray [1]
        Exponent n of the lobe, 0 or more.
    share : float [1]
        As in `exponent`.

    Returns
    -------
    float or ndarray [rad]
        From 0 to pi; pi for n = 0.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        full_angle = 2 arccos(share^(1/n)) = 4 arcsin(sqrt((1 - share^(1/n)) / 2))

    The second form is computed, with expm1 for the difference.

    References
    ----------
    .. [1] CIE e-ILV 17-27-077, beam angle.

    Examples
    --------
    >>> round(math.degrees(lobe_angle(1.0, 0.5)), 10)
    120.0
    """
    _check_share(share)
    _check_exponent(exponent)
    fall = maths.piecewise(
        exponent > 0, lambda n: maths.expm1(math.log(share) / n), lambda n: n - 1.0, exponent
    )
    return 4 * maths.asin(maths.power(-fall / 2, 0.5))  # 1 - cos(x) = 2 sin^2(x/2)


def lobe_part(exponent: maths.Number, within: maths.Number) -> maths.Number:
    """Return the share of a lobe's flux within an angle from its axis.

    Parameters
    ----------
    exponent : float or ndarray [1]
        Exponent n of the lobe, 0 or more.
    within : float or ndarray [rad]
        Angle from the axis (a half angle), from 0 to pi.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; 1 for angles from pi/2 on.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Phi(within) / Phi = 1 - cos^(n+1)(within)

    Exact; computed as -expm1((n + 1) ln cos(within)), which keeps the digits of small angles.

    Examples
    --------
    A Lambertian surface sends sin^2(30 deg) = 1/4 of its flux within 30 degrees from its normal:

    >>> round(lobe_part(1.0, math.radians(30)), 12)
    0.25
    """
    _check_exponent(exponent)
    bad = (within < 0) | (within > math.pi * (1 + maths.SLACK))
    refuse(bad, "the angle from the axis is out of range", "from 0 to 180 deg")
    return maths.piecewise(
        within < math.pi / 2,
        lambda w, n: -maths.expm1((n + 1) * ln_cos(w)),
        lambda w, n: 1.0 + 0 * (w + n),
        within,
        exponent,
    )


def lobe(exponent: maths.Number) -> maths.Number:
    """Return the solid angle that a lobe's whole flux would fill with its peak intensity.

    Parameters
    ----------
    exponent : float or ndarray [1]
        Exponent n of the lobe, 0 or more.

    Returns
    -------
    float or ndarray [sr]
        From above 0 to 2 pi.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        Omega = Phi / I0 = 2 pi / (n + 1)

    Examples
    --------
    >>> round(lobe(1.0), 6)
    3.141593
    """
    _check_exponent(exponent)
    return 2 * math.pi / (exponent + 1)


def _check_exponent(exponent: maths.Number) -> None:
    bad = (exponent < 0) | (exponent == math.inf)
    refuse(bad, "the exponent of the lobe is out of range", "0 or more, and finite")


MORE_ROOM = "more distance, or less area"  # the hint if a patch is too near
FAR = 5  # [1] the least distance over the size
REACH = 0.64  # [1] half the diagonal of a rectangle over its size is 0.636 at most


@bounded
def size(area: maths.Number, *sides: maths.Number) -> maths.Number:
    """Return the size of a patch that its distance is compared with.

    Parameters
    ----------
    area : float or ndarray [m^2]
        Its area, 0 or more.
    sides : float or ndarray [m]
        Its sides, if it is known to be a rectangle.

    Returns
    -------
    float or ndarray [m]
        The diameter of a circle of that area, or the longest side if that is longer.

    Raises
    ------
    ConditionError : argument out of range

    Examples
    --------
    >>> round(size(1.0), 6), size(1.0, 4.0, 0.25)
    (1.128379, 4.0)
    """
    refuse(area < 0, "the area is out of range", "0 or more")
    longest = 2 * maths.power(area / math.pi, 0.5)
    for side in sides:
        longest = maths.larger(longest, side)
    return longest


def reach(area: maths.Number, *sides: maths.Number) -> maths.Number:
    """Return how far a patch reaches from its centre, at most, if no longer than its `size`.

    Parameters
    ----------
    area : float or ndarray [m^2]
        As in `size`.
    sides : float or ndarray [m]
        Its sides, if it is known to be a rectangle.

    Returns
    -------
    float or ndarray [m]
        Half the diagonal of a rectangle, or a little more.

    Raises
    ------
    ConditionError : argument out of range

    Examples
    --------
    >>> round(reach(1.0), 3), round(2**0.5 / 2, 3)
    (0.722, 0.707)
    """
    return REACH * size(area, *sides)


def is_near(distance: maths.Number, extent: maths.Number) -> bool:
    """Return whether any distance is under five times a size, by more than a relative 1e-9.

    Parameters
    ----------
    distance, extent : float or ndarray [m]
        Distance and size of a patch.

    Returns
    -------
    bool

    Examples
    --------
    >>> is_near(4.9, 1.0), is_near(5.0, 1.0)
    (True, False)
    """
    return maths.any_true(nearer(distance, extent))


def nearer(distance: maths.Number, extent: maths.Number) -> Any:
    """Return which distances are under five times a size, by more than a relative 1e-9.

    Parameters
    ----------
    distance, extent : float or ndarray [m]
        Distance and size of a patch.

    Returns
    -------
    bool or ndarray of bool
        Element by element.

    Examples
    --------
    >>> nearer(4.9, 1.0), nearer(5.0, 1.0)
    (True, False)
    """
    return distance < FAR * extent * (1 - 1e-9)


@bounded
def error(
    size: maths.Number,
    distance: maths.Number,
    tilt: maths.Number = 0.0,
    incidence: maths.Number = 0.0,
    is_long: bool = False,
) -> maths.Number:
    """Return a bound of the relative error of the far field that is due to the size of one patch.

    Parameters
    ----------
    size : float or ndarray [m]
        Size of the patch.
    distance : float or ndarray [m]
        From its centre to the receiver, five times the size or more.
    tilt : float or ndarray [rad], optional
        Angle between its normal and the line to the receiver.
    incidence : float or ndarray [rad], optional
        Angle between that line and the receiver's normal, in any plane through the line.  The
        receiver's plane must not cut the patch.
    is_long : bool, optional
        Whether the patch may be a rectangle of any sides, not only a disc or a square.

    Returns
    -------
    float or ndarray [1]
        The bound, for the projected solid angle and the solid angle of the patch.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    To the second order in p = size/(2 d), a disc has 1 - p^2 cos(2 tilt) times the far field, plus
    or minus p^2 sin(2 tilt) tan(incidence) / 2; for a square these terms are 1.05 times as large.
    A thin rectangle has twice the first term if it is seen along its length, and 4/3 p^2 sin(tilt)
    tan(incidence).  The bounds have a margin for higher orders::

        1.15 p^2 (1.05 + 0.53 |sin(2 tilt)| tan(incidence))                       disc, square
        1.15 p^2 (1.08 + 0.92 sin^2(tilt) + 4/3 |sin(tilt)| tan(incidence))        any rectangle

    For the solid angle the 1.05 would be 0.8 for a patch that faces the receiver, and 1.18, within
    the margin, for a patch seen edge-on.

    Examples
    --------
    >>> round(error(1.0, 5.0), 6)
    0.012075
    """
    _check(size, distance)
    cosine = facing(incidence)
    slope = maths.piecewise(
        cosine > 0, lambda c: maths.power(1 - c * c, 0.5) / c, lambda c: 0.0 * c, cosine
    )
    if is_long:
        terms = 1.08 + 0.92 * maths.square(maths.sin(tilt)) + 4 / 3 * abs(maths.sin(tilt)) * slope
    else:
        terms = 1.05 + 0.53 * abs(maths.sin(2 * tilt)) * slope
    part = size / (2 * distance)
    return 1.15 * part * part * terms


@bounded
def is_cut(reach: maths.Number, distance: maths.Number, incidence: maths.Number) -> Any:
    """Return whether a receiver's plane may cut a patch.

    Parameters
    ----------
    reach : float or ndarray [m]
        Distance of the patch's farthest point from its centre.
    distance : float or ndarray [m]
        From the receiver to the patch's centre, above 0.
    incidence : float or ndarray [rad]
        Angle between that line and the receiver's normal.

    Returns
    -------
    bool or ndarray of bool
        False if the whole patch is above the receiver's horizon, or the whole patch below it.

    Raises
    ------
    ConditionError : argument out of range

    Examples
    --------
    A disc of 1 m radius at 10 m reaches 5.74 degrees from its centre:

    >>> [is_cut(1.0, 10.0, math.radians(angle)) for angle in (84, 85, 95, 96)]
    [False, True, True, False]
    """
    _check(reach, distance)
    within = maths.asin(maths.smaller(reach / distance, 1.0 + 0 * reach / distance))
    return abs(abs(incidence) - math.pi / 2) < within


def _check(reach: maths.Number, distance: maths.Number) -> None:
    refuse(reach < 0, "the size is out of range", "0 or more")
    refuse(distance <= 0, "the receiver is on the patch", "a distance above 0")


@bounded
def steepest(reach: maths.Number, distance: maths.Number) -> str:
    """Return the largest incidence at which a receiver's plane does not cut a patch, as a text.

    Parameters
    ----------
    reach, distance : float or ndarray [m]
        As in `is_cut`; for arrays the smallest of the angles counts.

    Returns
    -------
    str
        In degrees, rounded down to a tenth.

    Raises
    ------
    ConditionError : argument out of range

    Examples
    --------
    >>> steepest(1.0, 10.0)
    '84.2deg'
    """
    _check(reach, distance)
    part = reach / distance
    part = float(part.max(initial=0.0)) if maths.is_array(part) else part
    most = 90 - math.degrees(math.asin(min(part, 1.0)))
    return f"{math.floor(10 * most) / 10:g}deg"


def percent(bound: maths.Number) -> str:
    """Return a bound of an error as the predicate of a sentence.

    Parameters
    ----------
    bound : float or ndarray [1]
        The bound; the largest of an array counts.

    Returns
    -------
    str
        In per cent, to two digits.

    Examples
    --------
    >>> percent(0.022)
    'has an error of at most 2.2 %'
    """
    most = float(bound.max(initial=0.0)) if maths.is_array(bound) else bound
    return f"has an error of at most {100 * most:.2g} %"
