"""Light vectors of parts of an image, against Gauss-Legendre quadrature."""

import numpy
import pytest
from geometry.references import over_rectangle

from radcalc.distributions.maps.light_sums import light_vectors

PARTS = [(-0.6, -0.5, 0.3, 0.2), (0.1, 0.35, -0.2, -0.5)]


def density(projection, u, v):
    """Direction times solid angle per area, by the definitions of the projections."""
    if projection == "latlong":
        a, e = -numpy.pi * u, numpy.pi / 2 * v
        c = numpy.cos(e)
        scale = numpy.pi**2 / 2 * c
        return scale * c * numpy.cos(a), scale * c * numpy.sin(a), scale * numpy.sin(e) + 0 * a
    r = numpy.hypot(u, v)
    if projection == "mirror-ball":
        n = numpy.sqrt(1 - r * r)
        return 4 * (2 * n * n - 1), 8 * n * u, 8 * n * v
    share = numpy.sin(numpy.pi * r) / r
    scale = numpy.pi * share
    return scale * numpy.cos(numpy.pi * r), -scale * share * u, scale * share * v


@pytest.mark.parametrize(
    ("projection", "bound"), [("latlong", 1e-12), ("mirror-ball", 1e-11), ("angular", 3e-3)]
)
@pytest.mark.parametrize("part", PARTS)
def test_a_rectangle(projection, bound, part):
    """With four points in an angular map, the error is the fourth power of the part's size."""
    left, right, top, low = part
    u, v = numpy.array([left, right]), numpy.array([top, low])
    found = light_vectors(projection, u, v).ravel()
    true = over_rectangle(lambda x, y: density(projection, x, y), (left, right), (low, top))
    size = numpy.linalg.norm(true)
    assert found == pytest.approx(true, rel=bound, abs=bound * size)


def test_a_rectangle_that_the_circle_cuts():
    """For the quadrant of positive u and v: the integrals of (2 n^2 - 1, 2 n u, 2 n v) 4 du dv.

    In polar coordinates they are 0, pi/2 and pi/2.
    """
    edges = numpy.array([0.0, 1.0]), numpy.array([1.0, 0.0])
    found = light_vectors("mirror-ball", *edges).ravel()
    assert found == pytest.approx([0, numpy.pi / 2, numpy.pi / 2], abs=1e-14)
