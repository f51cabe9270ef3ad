"""Irradiance maps: what receivers get that face in all directions, as an image."""

from typing import Any, NamedTuple

import numpy

from radcalc.distributions.maps.harmonics import ORDER, irradiances_of_order_2
from radcalc.distributions.maps.light_sums import Progress
from radcalc.distributions.maps.radiance_map import RadianceMap, check_shape
from radcalc.errors import ConditionError
from radcalc.geometry.projections import direction_at, middle_of_pixel
from radcalc.quantities.symbols import LATLONG


class IrradianceMap(NamedTuple):
    """An irradiance map, and what its order changed.

    Attributes
    ----------
    pixels : ndarray of shape (height, width, channels) [lx, W/m2, photon/s/m2 or sr]
        Irradiances of receivers that face towards the middles of the pixels of a latlong map in
        the world's axes.
    largest, rms : float [1]
        The largest difference from the exact sum, and the root mean square of all by solid angle,
        in shares of the largest exact irradiance; 0 of the exact sum itself.

    Examples
    --------
    >>> IrradianceMap(numpy.ones((4, 8, 1))).largest
    0.0
    """

    pixels: Any
    largest: float = 0.0
    rms: float = 0.0


def irradiance_map(
    around: RadianceMap,
    width: int,
    height: int,
    order: int | None = None,
    progress: Progress | None = None,
) -> IrradianceMap:
    """Irradiances of receivers that face in all directions, as a latlong map.

    Parameters
    ----------
    around : RadianceMap
        Where the light comes from.
    width, height : int
        Size of the map that is made [pixels], 2:1.
    order : int, optional
        2 for spherical harmonics up to that order; the exact sum by default.
    progress : callable, optional
        Is called with how much is done, and all there is, each time when more is done.

    Returns
    -------
    IrradianceMap

    Raises
    ------
    ConditionError
        If the size is not that of a latlong map, or the order another.

    Examples
    --------
    >>> sky = numpy.repeat([3000.0, 0.0], 32)[:, None] + numpy.zeros(128)
    >>> found = irradiance_map(RadianceMap(sky, "latlong"), 16, 8)
    >>> found.pixels.shape, [round(float(x), 2) for x in found.pixels[[0, -1], 0, 0]]
    ((8, 16, 1), [9334.23, 90.55])
    """
    check_shape(LATLONG, width, height)
    if order not in (None, ORDER):
        raise ConditionError(f"no irradiances are summed up to order {order}", f"order {ORDER}")
    places = middle_of_pixel(width, height, numpy.arange(width), numpy.arange(height)[:, None])
    normals = numpy.stack(direction_at(LATLONG, *numpy.broadcast_arrays(*places)), -1)
    exact = around.irradiances(normals, is_each=True, progress=progress)
    if order is None:
        return IrradianceMap(exact)
    own = numpy.stack(around.own(tuple(numpy.moveaxis(normals, -1, 0))), -1).reshape(-1, 3)
    found = irradiances_of_order_2(around, own).reshape(exact.shape)
    off = (found - exact) / (exact.max() or 1.0)
    weights = numpy.hypot(normals[..., 0], normals[..., 1])[..., None]  # sines of polar angles
    rms = numpy.sqrt((off * off * weights).sum() / (weights.sum() * exact.shape[-1]))
    return IrradianceMap(found, float(abs(off).max()), float(rms))
