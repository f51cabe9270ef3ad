"""Images for tests, from the definitions of the projections, without radcalc."""

import math
from functools import lru_cache

import numpy

SIZES = {"latlong": (1024, 512), "mirror-ball": (1024, 1024), "angular": (1024, 1024)}
TILTS = [
    (0, 0, 1),
    (1, 0, 0),
    (-1, 0, 0),
    (0, -1, 0),
    (1, 2, 3),
    (-0.2, 0.7, -0.1),
    (1, 0, 0.1),
    (0.1, 0, 1),  # its horizon passes next to -x, the rim of a mirror ball
    (0.02, 1, 0.01),
]


@lru_cache(4)  # large, and the same for many tests
def directions(projection, width, height, part=None):
    """Return the directions of pixels in the map's axes; NaN outside the circle.

    Those of all pixels, or of a part: its left, top, width and height.
    """
    left, top, wide, high = part or (0, 0, width, height)
    u = (left + numpy.arange(wide) + 0.5) / width * 2 - 1
    v = 1 - (top + numpy.arange(high) + 0.5) / height * 2
    u, v = numpy.meshgrid(u, v)
    if projection == "latlong":
        azimuth, polar = -math.pi * u, math.pi / 2 * (1 - v)
        x, y = numpy.sin(polar) * numpy.cos(azimuth), numpy.sin(polar) * numpy.sin(azimuth)
        return numpy.array([x, y, numpy.cos(polar)])
    r = numpy.hypot(u, v)
    inside = numpy.where(r < 1, 1.0, math.nan)
    if projection == "mirror-ball":
        n = numpy.sqrt(numpy.maximum(1 - r * r, 0))
        return inside * numpy.array([2 * n * n - 1, 2 * n * u, 2 * n * v])
    share = numpy.sin(math.pi * r) / numpy.where(r > 0, r, 1)
    return inside * numpy.array([numpy.cos(math.pi * r), -share * u, share * v])


@lru_cache(4)
def solid_angles(projection, width, height, part=None):
    """Solid angle by area at the pixels' middles, times their areas; 0 outside."""
    x, _, z = directions(projection, width, height, part)
    area = 4 / width / height
    if projection == "latlong":
        return area * math.pi**2 / 2 * numpy.sqrt(1 - z * z)
    if projection == "mirror-ball":
        return numpy.where(numpy.isnan(x), 0, 4 * area)
    angle = numpy.arccos(x)
    return numpy.nan_to_num(area * math.pi**2 * numpy.sin(angle) / angle)


def image(projection, function, size=None, count=1):
    """Return an image of a function of direction: means over sample points in each pixel."""
    width, height = size or SIZES[projection]
    values = function(*directions(projection, width * count, height * count))
    parts = values.reshape(height, count, width, count)
    here = ~numpy.isnan(parts)
    total = numpy.where(here, parts, 0).sum((1, 3))
    return total / numpy.maximum(here.sum((1, 3)), 1)


def unit(vector):
    return numpy.array(vector) / numpy.linalg.norm(vector)
