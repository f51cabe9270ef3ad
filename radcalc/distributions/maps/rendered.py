"""Maps that are calculated: irradiances of receivers in every direction, and skies."""

import math
from typing import Any, NamedTuple

import numpy
import numpy as np

from radcalc.distributions.environments import Sky
from radcalc.distributions.maps import RadianceMap, check_shape
from radcalc.distributions.maps.light_sums import Progress, half_edges, light_vectors
from radcalc.distributions.maps.pictures import Picture, Y, as_floats, check_size
from radcalc.errors import ConditionError
from radcalc.geometry.models import angle_between
from radcalc.geometry.numerics import gauss
from radcalc.geometry.projections import (
    cartesian,
    direction_at,
    middle_of_pixel,
    pixel_solid_angles,
)
from radcalc.quantities.symbols import LATLONG, light_unit
from radcalc.units.table import resolve

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
        problem = f"an irradiance map of {width} x {height} pixels takes too long"
        raise ConditionError(problem, f"at most {exact} pixels, or {harmonic} with order {ORDER}")
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


FINE = 8  # samples of a pixel along each side, for the share of the sun's disc
BLOCK = 1 << 18  # pixels that are computed at a time
WIDER = 1.25  # factor by which the sun's disc grows if it has too few pixels
WIDEST = 3.0  # [rows] largest radius of a grown disc
CLOSE = 1e-9  # [1] of the sun's irradiance


class Sun(NamedTuple):
    """The sun's disc: the direction of its centre and its angular radius [rad], and its irradiance.

    The irradiance [lx, W/m2 or photon/s/m2] is that of a receiver that faces the sun.
    """

    polar: float
    azimuth: float
    radius: float
    irradiance: float


def sky_map(sky: Sky, width: int, height: int, sun: Sun | None = None) -> Picture:
    """Return a latlong map of a sky: the azimuth 0 at the centre, +y on the left of it.

    Its channel has the mean radiances of the pixels, in cd/m2, W/m2/sr or umol/m2/s/sr, so the sky
    must have a kind.  The height [pixels] is even, and half of the width.

    The sun's light is distributed over the pixels by the share of its disc in each.  A receiver
    whose horizon does not cut these pixels gets the sun's irradiance times the cosine for the true
    position of the disc.  A disc with too few pixels for that is enlarged, to a radius of three
    rows at most; a disc cut by the horizon may be exact only for a receiver that faces it.

    Raises
    ------
    ConditionError
        If the size is not that of such a map.

    Examples
    --------
    >>> pixels = sky_map(Sky("uniform", zenith=3000.0, kind="v"), 64, 32).pixels
    >>> float(pixels[0, 0, 0]), float(pixels[31, 0, 0])
    (3000.0, 0.0)
    """
    check_shape(LATLONG, width, height)
    check_size(width, height, "the map")
    if height % 2:
        problem = f"{width} x {height} pixels have a row across the horizon"
        raise ConditionError(problem, "an even height")
    unit = light_unit("radiance", sky.kind)
    pixels = _means(sky, width, height)
    if sun:
        rows, light = _sunlight(sun, width, height)
        pixels[rows] += light
    pixels = as_floats(pixels / float(resolve(unit).factor), unit)
    return Picture(pixels[:, :, None], Y, (1.0,), "", unit, LATLONG)


def _means(sky: Sky, width: int, height: int) -> Any:
    """Return the mean radiance of each pixel; larger pixels have more Gauss-Legendre points."""
    places, weights = gauss(min(8, max(2, 512 // height)))
    pixels = np.zeros((height, width))
    columns, step = np.arange(width), max(1, BLOCK // width)
    for top in range(0, height // 2, step):  # the part below the horizon is dark
        rows = np.arange(top, min(top + step, height // 2))
        size: Any = 0.0
        for a, down in zip(places, weights, strict=True):
            polar = (rows[:, None] + (1 + a) / 2) * (math.pi / height)
            weight = down * np.sin(polar)
            size = size + 2 * weight
            for b, along in zip(places, weights, strict=True):
                azimuth = math.pi - (columns + (1 + b) / 2) * (2 * math.pi / width)
                pixels[rows] += along * weight * sky.radiance(polar, azimuth)
        pixels[rows] /= size
    return pixels


def _sunlight(sun: Sun, width: int, height: int) -> tuple[Any, Any]:
    """Return the rows of a map with sunlight, and its radiances there.

    They are the shares of the disc times a linear function of the direction, so that their light
    vector is that of the disc.  The part below the horizon gives no light to the ground.
    """
    toward = sun.irradiance * np.array(cartesian(sun.polar, sun.azimuth))
    row, radius = math.pi / height, sun.radius
    while radius <= max(sun.radius, WIDEST * row):
        rows, share = _shares(sun._replace(radius=radius), width, height)
        edges = np.arange(rows[0], rows[-1] + 2)
        columns = 2 * np.arange(width + 1) / width - 1
        vectors = light_vectors(LATLONG, columns, 1 - 2 * edges / height)
        vectors[2] = vectors[2].clip(0)
        means = vectors / pixel_solid_angles(LATLONG, width, height)[rows]
        moments = np.einsum("irc,jrc->ij", share * means, vectors)
        linear = np.linalg.lstsq(moments, toward, rcond=None)[0]
        light = share * np.einsum("i,irc->rc", linear, means)
        difference = np.einsum("irc,rc->i", vectors, light) - toward
        if light.min() >= 0 and abs(difference).max() <= CLOSE * sun.irradiance:
            return rows, light
        radius = WIDER * max(radius, row / 4)
    rows, share = _shares(sun, width, height)
    polar, azimuth = _directions_of_sky(width, height, rows)
    facing = np.cos(angle_between(polar, azimuth, sun[:2])).clip(0)
    received = share * facing * pixel_solid_angles(LATLONG, width, height)[rows]
    return rows, sun.irradiance / received.sum() * share


def _directions_of_sky(width: int, height: int, rows: Any) -> tuple[Any, Any]:
    """Return polar angles of rows, as a column, and azimuths of all columns, at pixel centres."""
    u, v = middle_of_pixel(width, height, np.arange(width), rows)
    return (math.pi / 2 * (1 - v))[:, None], -math.pi * u


def _shares(sun: Sun, width: int, height: int) -> tuple[Any, Any]:
    """Return the rows of a map with the sun's disc, and its share in their pixels."""
    middle = sun.polar / math.pi * height
    reach = sun.radius / math.pi * height + 1
    low, high = max(0, math.floor(middle - reach)), min(height, math.ceil(middle + reach))
    rows = np.arange(low, high)
    share = np.empty((len(rows), width))
    for k, row in enumerate(rows):
        fine = np.arange(row * FINE, (row + 1) * FINE)
        polar, azimuth = _directions_of_sky(width * FINE, height * FINE, fine)
        inside = angle_between(polar, azimuth, sun[:2]) <= sun.radius
        share[k] = inside.reshape(FINE, width, FINE).mean(axis=(0, 2))
    if not share.any():  # the disc is smaller than a sample
        polar, azimuth = _directions_of_sky(width, height, rows)
        away = angle_between(polar, azimuth, sun[:2])
        share[np.unravel_index(np.argmin(away), away.shape)] = 1.0
    return rows, share
