"""Tables of half planes about an axis: completion by symmetry, limits and noise.

Angles are in degrees, as in files.
"""

import math
from collections.abc import Callable
from typing import Any, NoReturn

import numpy

from radcalc.errors import ConditionError

TURN = 360.0  # [deg]
SLACK = 0.01  # [deg] tolerance of angles
CLOSEST = 1e-6  # [deg] below it, two angles of a table are one
GREATEST = 1e100  # intensity in any unit: sums of it stay finite
NOISE = 1e-3  # of the greatest: smaller negative values are a photometer's noise
ROUNDED = 0.5  # [deg] rounding of the angles of evenly spaced planes


def mirrored(planes: Any, values: Any) -> tuple[Any, Any]:
    """Complete a table of a half or a quarter of the circle by reflection at its last plane.

    `planes` are azimuths [deg], rising, from a plane of symmetry to the next; `values` has a row
    for each.  Return those of a whole turn, where the last plane repeats the first.

    Raises
    ------
    ConditionError
        If the planes do not span 90 or 180 degrees.

    Examples
    --------
    >>> mirrored([0, 45, 90], [[1], [2], [3]])[0].tolist()
    [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0, 360.0]
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
    """Close a table of the whole circle by a repetition of its first plane, unless it has one.

    Parameters are those of `mirrored`, for planes anywhere on the circle.  Raise a ConditionError
    if the gap after the last plane is wider than any other, so that planes are missing.

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
            f"the planes end at {planes[-1]:g} deg, and {gap:g} deg of the circle are missing",
            f"planes all around, such as 0 to {TURN - widest:g} deg" if widest else "more planes",
        )
    return numpy.append(planes, planes[0] + TURN), numpy.concatenate([values, values[:1]])


def end_of(polar: Any) -> tuple[str, ...]:
    """Return the assumption about the intensity beyond the polar angles [deg] of a table, if any.

    >>> end_of([0, 45, 90])
    ('no light beyond the angles of the table, 0 to 90 deg',)
    """
    if polar[0] <= SLACK and polar[-1] >= TURN / 2 - SLACK:
        return ()
    return (f"no light beyond the angles of the table, {polar[0]:g} to {polar[-1]:g} deg",)


def without_noise(
    values: Any, refuse: Callable[[int, str, str], NoReturn]
) -> tuple[Any, tuple[str, ...]]:
    """Return intensities with 0 for negative noise, and a note about it.

    `refuse` raises the error of a bad value, from its index in the flat array, the problem and a
    hint.  Bad are values further below 0 than noise or too large for sums, and the last value if
    none is above 0.
    """
    peak, low = float(values.max()), float(values.min())
    if max(peak, -low) > GREATEST:
        refuse(int(abs(values).argmax()), "an intensity is above 1e100", "those of a source")
    if peak <= 0:
        refuse(values.size - 1, "no intensity is above 0", "a table with light")
    if low < -NOISE * peak:
        refuse(int(values.argmin()), f"the intensity {low:g} is negative", "0 or more")
    if low >= 0:
        return values, ()
    count = int((values < 0).sum())
    what, verb = ("intensity", "counts") if count == 1 else ("intensities", "count")
    return values.clip(min=0), (f"{count} negative {what} (down to {low:g}) {verb} as 0",)
