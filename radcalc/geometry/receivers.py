"""Light of a point source on a round receiver (a disc) of any size.

Each function returns a solid angle [sr] weighted with f(gamma), the source's intensity relative to
that on its axis: times the intensity on the axis it is the flux on the disc.

- `isotropic`: f = 1
- `cone`: f = 1 within a half angle, 0 outside
- `lobe`: f = cos^n(gamma) up to 90 degrees

A disc *lies across* the source's axis if its plane is perpendicular to it.  Lengths are in any one
unit, angles in radians; arguments are floats or arrays, broadcast together.
"""

import math
from collections.abc import Callable

from radcalc import geometry
from radcalc.errors import ConditionError, mention
from radcalc.geometry import solid
from radcalc.geometry.numerics import adaptive
from radcalc.maths import Number, each

UNEVEN = 0.01  # [1] largest variation of a lobe over a tilted receiver
TURNED = mention(  # hint if the axis of a receiver's tilt would matter
    "leave out {incidence}: a receiver in a plane across the axis, or a smaller one"
)
FAINT = 1e-18  # [1] relative intensity of a lobe below which it is not integrated


@geometry.bounded
def isotropic(radius: Number, distance: Number, incidence: Number = 0.0) -> Number:
    """Return the solid angle of a disc, from the distance of its centre and the incidence on it.

    Parameters
    ----------
    radius : float or ndarray [m]
        Radius R of the disc, 0 or more.
    distance : float or ndarray [m]
        Distance d of its centre from the source, above 0.
    incidence : float or ndarray [rad], optional
        Angle theta between the disc's normal and the line to the source.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 2 pi; 0 for incidences from pi/2 on.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    `radcalc.geometry.solid.disc` at the height d cos(theta) and the offset d sin(theta); exact.

    Examples
    --------
    A disc with its rim at 60 degrees fills pi sr:

    >>> round(isotropic(math.sqrt(3), 1.0) / math.pi, 12)
    1.0
    """
    _check(radius, distance)
    return each(_isotropic, radius, distance, abs(incidence))


def _isotropic(radius: float, distance: float, incidence: float) -> Number:
    if incidence >= math.pi / 2:
        return 0.0
    return solid.disc(radius, distance * math.cos(incidence), distance * math.sin(incidence))


@geometry.bounded
def cone(
    half_angle: Number,
    radius: Number,
    distance: Number,
    off_axis: Number = 0.0,
    incidence: Number | None = None,
) -> Number:
    """Return the solid angle of the part of a disc that a uniform cone lights.

    Parameters
    ----------
    half_angle : float or ndarray [rad]
        Half angle alpha of the cone, from 0 to pi.
    radius, distance : float or ndarray [m]
        As in `isotropic`.
    off_axis : float or ndarray [rad], optional
        Angle gamma of the disc's centre from the cone's axis, from 0 to below pi/2.
    incidence : float or ndarray [rad], optional
        Angle between the disc's normal and the line to the source; without it, the disc lies across
        the cone's axis.

    Returns
    -------
    float or ndarray [sr]
        From 0 to the solid angle of the cone.

    Raises
    ------
    ConditionError
        If an argument is out of range, or the cone's edge may cross a tilted disc: an incidence
        does not give the axis of the tilt.

    Notes
    -----
    On the axis, the smaller of the two solid angles; elsewhere an integral over the circles about
    the axis that have an arc on the disc.  Exact.

    Examples
    --------
    A disc larger than the light's footprint receives the whole cone:

    >>> half = math.radians(0.5)
    >>> cone(half, 0.4, 5.0) == geometry.cone(half)
    True
    """
    geometry.cone(half_angle)  # checks the half angle
    _check(radius, distance, off_axis)

    def of_floats(half: float, size: float, away: float, off: float, turn: float) -> Number:
        if not _lies_across(off, turn):
            reach = math.asin(size / away) if size < away else math.pi
            if turn >= math.pi / 2 or off - reach >= half:
                return 0.0
            if off + reach > half:
                raise ConditionError("the cone's edge may cross the tilted receiver", TURNED)
            return _isotropic(size, away, turn)
        height, aside = away * math.cos(off), away * math.sin(off)
        if math.atan2(aside + size, height) <= half:
            return solid.disc(size, height, aside)
        return _across(lambda gamma: 1.0, geometry.cone, half, size, height, aside)

    turn = math.nan if incidence is None else abs(incidence)
    return each(of_floats, half_angle, radius, distance, off_axis, turn)


@geometry.bounded
def lobe(
    exponent: Number,
    radius: Number,
    distance: Number,
    off_axis: Number = 0.0,
    incidence: Number | None = None,
) -> Number:
    """Return the solid angle of a disc, weighted with a cosine-power lobe.

    Parameters
    ----------
    exponent : float or ndarray [1]
        Exponent n of the lobe, 0 or more.
    radius, distance : float or ndarray [m]
        As in `isotropic`.
    off_axis, incidence : float or ndarray [rad], optional
        As in `cone`, with the lobe's axis.

    Returns
    -------
    float or ndarray [sr]
        From 0 to 2 pi/(n + 1), the value for the whole lobe.

    Raises
    ------
    ConditionError
        If an argument is out of range, or the lobe varies by more than 1 % over a tilted disc: an
        incidence does not give the axis of the tilt.

    Notes
    -----
    On the axis, with tan(beta) = R/d::

        2 pi (1 - cos^(n+1)(beta)) / (n + 1)

    Off the axis, an integral as in `cone`.  Both are exact.  For a tilted disc, the solid angle
    times cos^n(gamma); `unevenness` bounds the relative error.

    Examples
    --------
    A disc with its rim at 60 degrees receives three quarters of the flux of a Lambertian source:

    >>> round(lobe(1.0, math.tan(math.radians(60)), 1.0) / math.pi, 12)
    0.75
    """
    _check(radius, distance, off_axis)
    geometry.lobe(exponent)  # checks the exponent

    def of_floats(n: float, size: float, away: float, off: float, turn: float) -> Number:
        """Return the flux per axial intensity [sr] on a disc."""
        if not _lies_across(off, turn):
            if turn >= math.pi / 2:
                return 0.0
            geometry.refuse(
                _unevenness(n, size, away, off) > UNEVEN,
                "the lobe varies by more than 1 % over the tilted receiver",
                TURNED,
            )
            return _isotropic(size, away, turn) * math.exp(n * geometry.ln_cos(off))
        height, aside = away * math.cos(off), away * math.sin(off)
        nearest = max(0.0, math.atan2(aside - size, height))
        edge = math.pi / 2
        if n > 0:  # the rest is negligible against the flux on the nearest part of the disc
            fall = geometry.ln_cos(nearest) + math.log(FAINT) / n
            edge = 2 * math.asin(math.sqrt(-math.expm1(fall) / 2))
        return _across(
            lambda gamma: math.exp(n * geometry.ln_cos(gamma)),
            lambda gamma: geometry.lobe(n) * geometry.lobe_part(n, gamma),
            edge,
            size,
            height,
            aside,
        )

    turn = math.nan if incidence is None else abs(incidence)
    return each(of_floats, exponent, radius, distance, off_axis, turn)


@geometry.bounded
def unevenness(
    exponent: Number, radius: Number, distance: Number, off_axis: Number = 0.0
) -> Number:
    """Return a bound of the difference between a lobe's intensity on a disc and at its centre.

    Parameters
    ----------
    exponent, radius, distance, off_axis
        As in `lobe`.

    Returns
    -------
    float or ndarray [1]
        Relative to the intensity towards the centre; infinite if the disc may reach the edge of
        the lobe, or the source.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    At any incidence the disc is seen within the angle d = asin(R/distance) from its centre::

        max(cos^n(gamma - d) / cos^n(gamma) - 1, 1 - cos^n(gamma + d) / cos^n(gamma))

    with gamma - d replaced by 0 if it is negative.

    Examples
    --------
    A spot of 10 degrees (n = 181) and a disc of 1 cm radius on its axis, 1 m away:

    >>> round(unevenness(181.0, 0.01, 1.0), 5)
    0.00901
    """
    _check(radius, distance, off_axis)
    geometry.lobe(exponent)  # checks the exponent
    return each(_unevenness, exponent, radius, distance, off_axis)


def _unevenness(exponent: float, radius: float, distance: float, off_axis: float) -> float:
    if exponent == 0 and radius < distance:
        return 0.0
    reach = math.asin(radius / distance) if radius < distance else math.pi
    if off_axis + reach >= math.pi / 2:
        return math.inf
    middle = geometry.ln_cos(off_axis)
    more = exponent * (geometry.ln_cos(max(0.0, off_axis - reach)) - middle)
    less = exponent * (geometry.ln_cos(off_axis + reach) - middle)
    return max(math.expm1(min(more, 700.0)), -math.expm1(less))


def _check(radius: Number, distance: Number, off_axis: Number = 0.0) -> None:
    geometry.refuse(radius < 0, "the radius is out of range", "0 or more")
    geometry.refuse(distance <= 0, "the source is on the receiver", "a distance above 0")
    bad = (off_axis < 0) | (off_axis >= math.pi / 2)
    geometry.refuse(bad, "the angle off the axis is out of range", "from 0 to below 90 deg")


def _lies_across(off_axis: float, incidence: float) -> bool:
    """Return whether a disc lies across the axis; an incidence of NaN means none was given."""
    return math.isnan(incidence) or (incidence == 0 and off_axis == 0)


def _across(
    share: Callable[[float], float],
    within: Callable[[float], Number],
    edge: float,
    radius: float,
    height: float,
    offset: float,
) -> Number:
    """Return the solid angle, weighted with `share`, of a disc that lies across the axis.

    `within` is that of all directions up to an angle from the axis; directions past `edge` do not
    count.  Circles about the axis are wholly on the disc up to the radius R - x, and have an arc on
    it from |R - x| to R + x.  With these radii as m + a cos(t), the integrand has no root.
    """
    large, small = max(radius, offset), min(radius, offset)
    whole = within(min(edge, math.atan2(radius - offset, height))) if radius > offset else 0.0
    last = height * math.tan(edge) if edge < math.pi / 2 else math.inf
    if small == 0 or last <= large - small:
        return whole
    start = 0.0
    if last < large + small:
        start = 2 * math.asin(math.sqrt((large + small - last) / (2 * small)))

    def circle(t: float) -> float:
        more, less = 2 * math.sin(t / 2) ** 2, 2 * math.cos(t / 2) ** 2  # 1 - cos, 1 + cos
        r = large - small + small * less
        outside, inside = small * less, 2 * (large - small) + small * less
        if radius > offset:
            outside, inside = inside, outside
        over = math.sqrt(small * more * outside)
        arc = 4 * math.atan2(over, math.sqrt(inside * (r + large + small)))
        away = math.hypot(height, r)
        return share(math.atan2(r, height)) * r * height / away**3 * arc * small * math.sin(t)

    return whole + adaptive(circle, start, math.pi)
