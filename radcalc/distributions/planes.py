"""Tables of half planes about an axis: what symmetry leaves out, where they end, their noise.

Angles are in degrees, as files have them.
"""

import math
from collections.abc import Callable
from typing import Any, NoReturn

import numpy

from radcalc.errors import ConditionError

TURN = 360.0  # [deg]
SLACK = 0.01  # [deg] by which an angle is taken for another
GREATEST = 1e100  # intensity in any unit, which sums can hold
NOISE = 1e-3  # of the greatest: negative values within it are a photometer's noise
ROUNDED = 0.5  # [deg] by which angles may be rounded where planes are evenly apart


def mirrored(planes: Any, values: Any) -> tuple[Any, Any]:
    """A table of a half or a quarter of the circle, reflected at its last plane until it closes.

    Parameters
    ----------
    planes : array_like of shape (n,) [deg]
        Azimuths of the half planes, rising, from a plane of symmetry to the next: 90 or 180
        degrees later.
    values : array_like of shape (n, m)
        A row for each.

    Returns
    -------
    tuple of two ndarrays
        Azimuths [deg] over a whole turn, the last of which is the first again, and their rows.

    Raises
    ------
    ConditionError
        If the planes do not span 90 or 180 degrees.

    Examples
    --------
    >>> planes, values = mirrored([0, 45, 90], [[1], [2], [3]])
    >>> planes.tolist()
    [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0, 360.0]
    >>> values[:, 0].tolist()
    [1.0, 2.0, 3.0, 2.0, 1.0, 2.0, 3.0, 2.0, 1.0]
    """
    planes, values = numpy.array(planes, float), numpy.array(values, float)
    span = planes[-1] - planes[0]
    if not any(math.isclose(span, allowed, abs_tol=SLACK) for allowed in (TURN / 4, TURN / 2)):
        raise ConditionError(
            f"symmetric planes span {span:g} deg", "90 or 180 deg, from one symmetry to the next"
        )
    planes[-1] = planes[0] + round(span)
    while planes[-1] - planes[0] < TURN - 1:
        planes = numpy.concatenate([planes, 2 * planes[-1] - planes[-2::-1]])
        values = numpy.concatenate([values, values[-2::-1]])
    return planes, values


def closed(planes: Any, values: Any) -> tuple[Any, Any]:
    """A table of the whole circle, with the first plane repeated at its end.

    Parameters
    ----------
    planes : array_like of shape (n,) [deg]
        Azimuths of the half planes, rising.
    values : array_like of shape (n, m)
        A row for each.

    Returns
    -------
    tuple of two ndarrays
        Azimuths [deg] over a whole turn, and their rows; a table that ends with its first plane
        as it is.

    Raises
    ------
    ConditionError
        If the gap behind the last plane is wider than any other, so that planes are missing.

    Examples
    --------
    >>> closed([0, 120, 240], [[1], [2], [3]])[0].tolist()
    [0.0, 120.0, 240.0, 360.0]
    """
    planes, values = numpy.array(planes, float), numpy.array(values, float)
    gap = planes[0] + TURN - planes[-1]
    if abs(gap) <= SLACK:
        planes[-1] = planes[0] + TURN
        return planes, values
    widest = float(numpy.diff(planes).max(initial=0.0))
    if not 0 < gap <= widest + ROUNDED:
        raise ConditionError(
            f"the planes end at {planes[-1]:g} deg, which leaves {gap:g} deg of the circle without",
            f"planes all around, such as 0 to {TURN - widest:g} deg" if widest else "more planes",
        )
    return numpy.append(planes, planes[0] + TURN), numpy.concatenate([values, values[:1]])


def end_of(polar: Any) -> tuple[str, ...]:
    """What is assumed beyond the polar angles of a table.

    Parameters
    ----------
    polar : array_like [deg]
        Its polar angles, rising.

    Returns
    -------
    tuple of str
        An assumption; none where the table reaches from 0 to 180 degrees.

    Examples
    --------
    >>> end_of([0, 45, 90])
    ('no light beyond the angles of the table, 0 to 90 deg',)
    """
    if polar[0] <= SLACK and polar[-1] >= TURN / 2 - SLACK:
        return ()
    return (f"no light beyond the angles of the table, {polar[0]:g} to {polar[-1]:g} deg",)


def without_noise(
    values: Any, refuse: Callable[[int, str, str], NoReturn]
) -> tuple[Any, tuple[str, ...]]:
    """Intensities of which none is negative.

    Parameters
    ----------
    values : ndarray
        Intensities as measured, finite.
    refuse : callable
        Raises the error of a bad one, from its place in the flat array, the problem and a hint:
        one that is further below 0 than noise, or beyond what sums can hold; the last one where
        none is above 0.

    Returns
    -------
    tuple of ndarray and tuple of str
        The same with 0 for what is negative by a photometer's noise, and a note of it.

    Examples
    --------
    >>> without_noise(numpy.array([100.0, -0.01]), print)
    (array([100.,   0.]), ('1 negative intensity (down to -0.01) counts as 0',))
    """
    peak, low = float(values.max()), float(values.min())
    if max(peak, -low) > GREATEST:
        refuse(int(abs(values).argmax()), "an intensity of more than 1e100", "those of a source")
    if peak <= 0:
        refuse(values.size - 1, "no intensity is above 0", "a table with light")
    if low < -NOISE * peak:
        refuse(int(values.argmin()), f"an intensity of {low:g}", "0 or more")
    if low >= 0:
        return values, ()
    count = int((values < 0).sum())
    what, verb = ("intensity", "counts") if count == 1 else ("intensities", "count")
    return values.clip(min=0), (f"{count} negative {what} (down to {low:g}) {verb} as 0",)
