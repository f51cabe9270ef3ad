"""Irradiance maps: irradiances of receivers that face in all directions, as an image."""

import math
from typing import Any, NamedTuple

import numpy

from radcalc.distributions.maps.light_sums import Progress
from radcalc.distributions.maps.radiance_map import RadianceMap, check_shape
from radcalc.errors import ConditionError
from radcalc.geometry.light_vectors import half_edges, light_vectors
from radcalc.geometry.projections import direction_at, middle_of_pixel
from radcalc.quantities.symbols import LATLONG

ORDER = 2
DIRECTIONS = 128  # receivers at which spherical harmonics are compared with the exact sum
MOST = {True: 1 << 17, False: 1 << 21}  # pixels by the exact sum, and by harmonics
ROUNDING = 1e-13  # of the largest irradiance: smaller differences are 0
GOLDEN = (1 + math.sqrt(5)) / 2


def irradiances_of_order_2(around: RadianceMap, normals: Any) -> Any:
    """Return irradiances of receivers from the harmonics up to order 2 of a map, by channel.

    `normals` are unit vectors (n, 3) in the map's own axes.  The result [lx, W/m2, photon/s/m2 or
    sr] may be negative if the contrast of the map is too high for the nine harmonics.

    Notes
    -----
    With A_l = pi, 2 pi/3, pi/4 and the addition theorem, the sum of A_l L_lm Y_lm(n) over the
    nine coefficients [1]_ is::

        E(n) = S / 4 + n . V / 2 + 5/32 (3 n . T n - S)

    where S, V and T are the integrals over solid angle of the radiance, of the radiance times the
    direction w, and of the radiance times w w^T.  For a pixel with the light vector v, the solid
    angle s and the half edges p and q, the integral of w w^T is v v^T / s + s (p p^T + q q^T) / 3.

    References
    ----------
    .. [1] R. Ramamoorthi and P. Hanrahan, An Efficient Representation for Irradiance Environment
           Maps, SIGGRAPH 2001.

    Examples
    --------
    >>> around = RadianceMap(numpy.full((64, 128), 2.0), "latlong")
    >>> irradiances_of_order_2(around, numpy.eye(3)).round(6).tolist()
    [[6.283185], [6.283185], [6.283185]]
    """
    raster = around.raster
    flux: Any = 0.0
    vector: Any = 0.0
    tensor: Any = 0.0
    for down in range(raster.down):
        first, last = raster.rows(down)
        light = raster.blocks(around.channels(first, last))
        size = raster.blocks(around.solid_angles(first, last))
        u, v = raster.edges(down)
        vectors, *halves = (
            light_vectors(raster.projection, u, v),
            *half_edges(raster.projection, u, v),
        )
        shares = [numpy.sqrt(size / 3) * half for half in halves]
        parts = [vectors / numpy.sqrt(numpy.where(size > 0, size, 1.0)), *shares]
        flux = flux + numpy.einsum("bij,bijc->c", size, light)
        vector = vector + numpy.einsum("xbij,bijc->xc", vectors, light)
        for part in parts:
            tensor = tensor + numpy.einsum("xbij,ybij,bijc->xyc", part, part, light, optimize=True)
    squares = numpy.einsum("nx,xyc,ny->nc", normals, tensor, normals)
    flux_of_tensor = numpy.trace(tensor)  # the flux, up to the fourth power of a pixel's angle
    return flux / 4 + normals @ vector / 2 + 5 / 32 * (3 * squares - flux_of_tensor)


class IrradianceMap(NamedTuple):
    """An irradiance map, and the errors of its order.

    Attributes
    ----------
    pixels : ndarray of shape (height, width, channels) [lx, W/m2, photon/s/m2 or sr]
        Irradiances of receivers that face the pixel centres of a latlong map in world axes.
    largest, rms : float [1]
        Largest and root-mean-square difference from the exact sum in `DIRECTIONS` evenly
        spread directions, relative to the largest exact irradiance; 0 for the exact sum.
    raised : int
        Number of pixels with negative harmonics, which were set to 0.
    deepest : float [1]
        Largest amount below 0, relative to the same irradiance.
    """

    pixels: Any
    largest: float = 0.0
    rms: float = 0.0
    raised: int = 0
    deepest: float = 0.0


def irradiance_map(
    around: RadianceMap,
    width: int,
    height: int,
    order: int | None = None,
    progress: Progress | None = None,
) -> IrradianceMap:
    """Return the irradiances of receivers that face in all directions, as a latlong map.

    `order` is 2 for spherical harmonics up to that order; the exact sum is the default.
    `progress` is called with the work done so far and the total.

    Raises
    ------
    ConditionError
        If the size [pixels] is not that of a latlong map, or more than 512x256 (2048x1024 with an
        order); or if the order is not 2.

    Examples
    --------
    >>> sky = numpy.repeat([3000.0, 0.0], 32)[:, None] + numpy.zeros(128)
    >>> irradiances = irradiance_map(RadianceMap(sky, "latlong"), 16, 8)
    >>> irradiances.pixels.shape, [round(float(x), 2) for x in irradiances.pixels[[0, -1], 0, 0]]
    ((8, 16, 1), [9334.23, 90.55])
    """
    check_shape(LATLONG, width, height)
    exact, harmonic = (f"{math.isqrt(2 * most)}x{math.isqrt(most // 2)}" for most in MOST.values())
    if width * height > MOST[order is None]:
        raise ConditionError(
            f"an irradiance map of {width} x {height} pixels takes too long",
            f"at most {exact} pixels, or {harmonic} with order {ORDER}",
        )
    if order not in (None, ORDER):
        raise ConditionError(f"there are no irradiance maps of order {order}", f"order {ORDER}")
    places = middle_of_pixel(width, height, numpy.arange(width), numpy.arange(height)[:, None])
    normals = numpy.stack(direction_at(LATLONG, *numpy.broadcast_arrays(*places)), -1)
    if order is None:
        return IrradianceMap(_exact(around, normals, progress))
    # the exact sums of all pixels would take several times as long as the harmonics
    checked = _directions()
    exact = around.irradiances(checked, is_each=True, progress=progress)
    x, y, z = around.in_map_axes(tuple(numpy.concatenate([checked, normals.reshape(-1, 3)]).T))
    irradiances = irradiances_of_order_2(around, numpy.stack([x, y, z], -1))
    highest = exact.max() or 1.0
    below = irradiances[len(checked) :].min(-1)
    irradiances = numpy.maximum(irradiances, 0)
    off = (irradiances[: len(checked)] - exact) / highest
    return IrradianceMap(
        irradiances[len(checked) :].reshape(height, width, -1),
        float(abs(off).max()),
        float(numpy.sqrt((off * off).mean())),
        int(numpy.count_nonzero(below < 0)),
        float(max(0.0, -below.min() / highest)),
    )


def _exact(around: RadianceMap, normals: Any, progress: Progress | None) -> Any:
    """Return the irradiances of the pixels of a latlong map.

    Those of opposite receivers differ by n . V, where V is the light vector of all pixels, as
    max(0, x) - max(0, -x) = x.  So the upper half, and V from three pairs of receivers, give the
    lower half.
    """
    height, width, _ = normals.shape
    upper = (height + 1) // 2
    axes = numpy.concatenate([numpy.eye(3), -numpy.eye(3)])
    receivers = numpy.concatenate([normals[:upper].reshape(-1, 3), axes])
    found = around.irradiances(receivers, is_each=True, progress=progress)
    vector = found[-6:-3] - found[-3:]
    above = found[:-6].reshape(upper, width, -1)
    opposite = numpy.roll(above[height - upper - 1 :: -1], width // 2, axis=1)
    below = opposite + normals[upper:] @ vector
    below[below < ROUNDING * found.max()] = 0
    return numpy.concatenate([above, below])


def _directions() -> Any:
    """Return evenly spread unit vectors: a Fibonacci lattice."""
    number = numpy.arange(DIRECTIONS) + 0.5
    z = 1 - 2 * number / DIRECTIONS
    across, azimuth = numpy.sqrt(1 - z * z), 2 * math.pi / GOLDEN * number
    return numpy.stack([across * numpy.cos(azimuth), across * numpy.sin(azimuth), z], -1)
