"""Maps of a sky, with or without the sun."""

import math
from typing import Any, NamedTuple

import numpy as np

from radcalc.distributions.maps.pictures import Picture, Y, as_floats, check_size
from radcalc.distributions.maps.radiance_map import check_shape
from radcalc.distributions.radiances import Sky
from radcalc.errors import ConditionError
from radcalc.geometry.directions import cartesian
from radcalc.geometry.light_vectors import light_vectors
from radcalc.geometry.numerics.integrals import gauss
from radcalc.geometry.projections import middle_of_pixel, pixel_solid_angles
from radcalc.geometry.sky import angle_between
from radcalc.quantities.symbols import LATLONG, light_unit
from radcalc.units.table import resolve

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
    polar, azimuth = _directions(width, height, rows)
    facing = np.cos(angle_between(polar, azimuth, sun[:2])).clip(0)
    received = share * facing * pixel_solid_angles(LATLONG, width, height)[rows]
    return rows, sun.irradiance / received.sum() * share


def _directions(width: int, height: int, rows: Any) -> tuple[Any, Any]:
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
        polar, azimuth = _directions(width * FINE, height * FINE, fine)
        inside = angle_between(polar, azimuth, sun[:2]) <= sun.radius
        share[k] = inside.reshape(FINE, width, FINE).mean(axis=(0, 2))
    if not share.any():  # the disc is smaller than a sample
        polar, azimuth = _directions(width, height, rows)
        away = angle_between(polar, azimuth, sun[:2])
        share[np.unravel_index(np.argmin(away), away.shape)] = 1.0
    return rows, share
