"""Limits of the far field A cos(theta_s) cos(theta) / d^2 for patches small against their distance.

- `error`: a bound of its relative error
- `is_cut`: whether a receiver's plane may cut the patch, so that the formula does not hold
- `is_near`: whether the distance is less than five times the size, the least allowed
- `size`, `reach`: size of a patch, and distance of its farthest point from its centre

A patch is a disc or a rectangle.  Lengths are in any one unit, angles in radians; arguments are
floats or arrays, broadcast together.
"""

import math
from typing import Any

from radcalc import maths
from radcalc.geometry.cones import bounded, facing, refuse

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
