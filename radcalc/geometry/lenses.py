"""Pictures of a part of the sphere: their field of view, in the coordinates of a projection.

References
----------
.. [1] Radiance, src/common/image.c, `setview` and `viewray`; rpict(1), options -vt, -vh, -vv, -vs
   and -vl.
"""

import math
from typing import Any, NamedTuple

from radcalc.geometry.cones import refuse
from radcalc.geometry.projections import ROUND, radius_of
from radcalc.quantities.symbols import (
    CIRCLES,
    CYLINDRICAL,
    EQUISOLID,
    FISHEYE,
    ORTHOGRAPHIC,
    PERSPECTIVE,
    STEREOGRAPHIC,
)

# Largest fields [rad]; those in OPEN must be smaller, as their edges would be infinitely far away.
WIDEST = {
    FISHEYE: 2 * math.pi,
    EQUISOLID: 2 * math.pi,
    ORTHOGRAPHIC: math.pi,
    STEREOGRAPHIC: 2 * math.pi,
    PERSPECTIVE: math.pi,
    CYLINDRICAL: 2 * math.pi,
}
OPEN = (STEREOGRAPHIC, PERSPECTIVE)
NEAREST = 1e-6  # [rad] to that limit


class View(NamedTuple):
    """The rectangle that an image shows, in u and v of its projection; by default -1 to 1.

    Attributes
    ----------
    right, top : float [1]
        Distances of the edges of the image from its middle.
    aside, above : float [1]
        Place of its middle.
    circle : float [1]
        Pixels farther than this from u = v = 0 show nothing.

    Examples
    --------
    The left half of a picture:

    >>> View(right=0.5, aside=-0.5).places(1.0, 1.0)
    (0.0, 1.0)
    """

    right: float = 1.0
    top: float = 1.0
    aside: float = 0.0
    above: float = 0.0
    circle: float = math.inf

    def places(self, u: Any, v: Any) -> tuple[Any, Any]:
        """Return u and v of the projection at places of the image.

        Parameters
        ----------
        u, v : float or ndarray [1]
            Places from -1 to 1.

        Returns
        -------
        tuple of float or ndarray [1]

        Examples
        --------
        >>> View(right=0.5, top=0.25).places(1.0, -1.0)
        (0.5, -0.25)
        """
        return u * self.right + self.aside, v * self.top + self.above

    def in_image(self, u: Any, v: Any) -> tuple[Any, Any]:
        """Return the places of the image; the inverse of `places`.

        Parameters
        ----------
        u, v : float or ndarray [1]
            Coordinates of the projection.

        Returns
        -------
        tuple of float or ndarray [1]
            From -1 to 1 in the image.

        Examples
        --------
        >>> View(right=0.5, top=0.25).in_image(0.5, -0.25)
        (1.0, -1.0)
        """
        return (u - self.aside) / self.right, (v - self.above) / self.top


def field_text(field: float) -> str:
    """Return a field of view for texts.

    Parameters
    ----------
    field : float [rad]

    Returns
    -------
    str

    Examples
    --------
    >>> field_text(math.pi)
    '180 deg'
    """
    return f"{math.degrees(field):.6g} deg"


def reach(projection: str, field: float, is_upright: bool = False) -> float:
    """Return the distance of the edge of a picture from its middle, in u or v.

    Parameters
    ----------
    projection : str
        One of those with a field of view.
    field : float [rad]
        Full angle from edge to edge.
    is_upright : bool, optional
        Whether it is measured from the bottom to the top.

    Returns
    -------
    float [1]

    Raises
    ------
    ConditionError
        If the projection cannot show that field.

    Examples
    --------
    >>> round(reach("orthographic", math.pi), 12), round(reach("perspective", math.pi / 2), 12)
    (1.0, 1.0)
    """
    flat = projection == CYLINDRICAL and is_upright
    if flat:
        projection = PERSPECTIVE
    widest = WIDEST[projection]
    limit = widest - NEAREST if projection in OPEN else widest * (1 + 1e-9)
    refuse(
        (field <= 0) | (field > limit),
        f"a {'cylindrical' if flat else projection} picture cannot show {field_text(field)}",
        f"more than 0, and {'less than' if projection in OPEN else 'at most'} {field_text(widest)}",
    )
    half = min(field, widest) / 2
    return half / math.pi if projection == CYLINDRICAL else float(radius_of(projection, half))


def view_of_field(projection: str, field: float, width: int, height: int) -> View:
    """Return the view of a whole picture with square pixels.

    Parameters
    ----------
    projection : str
        One of those with a field of view.
    field : float [rad]
        Full angle across the circle in the middle of a square fisheye picture, or across the width
        of the others.
    width, height : int
        Size of the picture in pixels.

    Returns
    -------
    View

    Raises
    ------
    ConditionError
        If the projection cannot show that field, or a fisheye picture is not square.

    Examples
    --------
    >>> view = view_of_field("perspective", math.pi / 2, 400, 200)
    >>> round(view.right, 12), round(view.top, 12)
    (1.0, 0.5)
    """
    right = reach(projection, field)
    if projection in CIRCLES:
        refuse(
            width != height,
            f"{width} x {height} pixels are not square around the circle of {field_text(field)}",
            "the square around its circle",
        )
        is_whole = projection in ROUND and right > 1 - 1e-9  # all that the projection can show
        return View(right, right, circle=math.inf if is_whole else right)
    is_flat = projection == PERSPECTIVE
    return View(right, (1 if is_flat else math.pi) * right * height / width)


def view_of_angles(
    projection: str, across: float, upright: float, shift: float = 0.0, lift: float = 0.0
) -> View:
    """Return the view that Radiance defines by its options -vh, -vv, -vs and -vl [1]_.

    Parameters
    ----------
    projection : str
        One of those with a field of view.
    across, upright : float [rad]
        Full angles from edge to edge, -vh and -vv.
    shift, lift : float, optional [1]
        Shifts of the middle, -vs and -vl, in widths and heights of the picture.

    Returns
    -------
    View

    Raises
    ------
    ConditionError
        If the projection cannot show these angles.

    Examples
    --------
    >>> view = view_of_angles("perspective", math.pi / 2, math.pi / 2, shift=0.5)
    >>> round(view.right, 12), round(view.aside, 12)
    (1.0, 1.0)
    """
    right, top = reach(projection, across), reach(projection, upright, True)
    return View(right, top, 2 * shift * right, 2 * lift * top)
