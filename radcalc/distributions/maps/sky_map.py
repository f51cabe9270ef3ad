"""The map of a sky, and of the sun in it."""

import math
from typing import Any, NamedTuple

import numpy as np

from radcalc.distributions.maps.pictures import Picture, check_size
from radcalc.distributions.maps.radiance_map import check_shape
from radcalc.distributions.sky import Sky
from radcalc.errors import ConditionError
from radcalc.geometry.projections import middle_of_pixel, pixel_solid_angles
from radcalc.geometry.sky import angle_between
from radcalc.quantities.symbols import LATLONG, light_unit
from radcalc.units.table import resolve

FINE = 8  # parts of a pixel each way, of which it is counted how many the sun's disc has


class Sun(NamedTuple):
    """The sun's disc.

    Attributes
    ----------
    polar, azimuth : float [rad]
        Where its centre is.
    radius : float [rad]
        Its angular radius.
    irradiance : float [lx, W/m2 or photon/s/m2]
        What a receiver gets that faces it.

    Examples
    --------
    >>> Sun(0.5, 0.0, 0.00465, 1e5).irradiance
    100000.0
    """

    polar: float
    azimuth: float
    radius: float
    irradiance: float


def sky_map(sky: Sky, width: int, height: int, sun: Sun | None = None) -> Picture:
    """A latitude-longitude map of a sky: the azimuth 0 in the middle, and +y to the left of it.

    Parameters
    ----------
    sky : Sky
        Its radiances have a kind.
    width, height : int
        Size [pixels]; twice as wide as high, with an even height.
    sun : Sun, optional
        The sun's disc, if it is to be in the map.

    Returns
    -------
    Picture
        Of one channel, in cd/m2, W/m2/sr or umol/m2/s/sr: the radiances in the middles of the
        pixels.  The sun's irradiance is spread over the pixels by the share that its disc has of
        each, and is exact for a receiver that faces it.

    Raises
    ------
    ConditionError
        If the size is that of no such map.

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
    polar, azimuth = _directions(width, height, np.arange(height))
    pixels = sky.radiance(polar, azimuth)
    if sun:
        rows, share = _shares(sun, width, height)
        polar, azimuth = _directions(width, height, rows)
        facing = np.cos(angle_between(polar, azimuth, sun[:2])).clip(0)
        received = share * facing * pixel_solid_angles(LATLONG, width, height)[rows]
        pixels[rows] += sun.irradiance / received.sum() * share
    pixels = (pixels / float(resolve(unit).factor)).astype(np.float32)
    return Picture(pixels[:, :, None], ("Y",), (1.0,), "", unit, LATLONG)


def _directions(width: int, height: int, rows: Any) -> tuple[Any, Any]:
    """Polar angles of the middles of rows, as a column, and azimuths of those of all columns."""
    u, v = middle_of_pixel(width, height, np.arange(width), rows)
    return (math.pi / 2 * (1 - v))[:, None], -math.pi * u


def _shares(sun: Sun, width: int, height: int) -> tuple[Any, Any]:
    """The rows of a map that the sun's disc is in, and its share of their pixels."""
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
    if not share.any():  # it is smaller than the parts
        polar, azimuth = _directions(width, height, rows)
        away = angle_between(polar, azimuth, sun[:2])
        share[np.unravel_index(np.argmin(away), away.shape)] = 1.0
    return rows, share
