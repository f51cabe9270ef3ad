"""Half planes about an axis: what a symmetric table leaves out, and where a table ends.

Angles are in degrees, as files have them.
"""

import math
from typing import Any

import numpy

from radcalc.errors import ConditionError

TURN = 360.0  # [deg]
SLACK = 1e-6  # [deg]
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
    if not any(math.isclose(span, whole, abs_tol=SLACK) for whole in (TURN / 4, TURN / 2)):
        raise ConditionError(
            f"symmetric planes span {span:g} deg", "90 or 180 deg, from one symmetry to the next"
        )
    while span < TURN - 1:
        planes = numpy.concatenate([planes, 2 * planes[-1] - planes[-2::-1]])
        values = numpy.concatenate([values, values[-2::-1]])
        span *= 2
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
