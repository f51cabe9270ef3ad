"""Irradiances from the spherical harmonics of radiance up to order 2."""

from typing import Any

import numpy

from radcalc.distributions.maps.radiance_map import RadianceMap
from radcalc.geometry.light_vectors import half_edges, light_vectors

ORDER = 2


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
