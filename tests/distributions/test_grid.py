"""Tables of intensities, compared with closed forms, plain sums and definitions."""

import math
from itertools import product

import mpmath
import numpy
import pytest
from helpers import for_each

from radcalc.distributions.distribution import Grid
from radcalc.errors import ConditionError

TURN = 2 * math.pi


def axial(function, step, last=90):
    degrees = numpy.arange(0, last + step / 2, step)
    return Grid(numpy.radians(degrees), [0.0], [[function(math.radians(d)) for d in degrees]])


def sphere(system="C", planes=13, value=7.0):
    """Return a table of the same intensity everywhere, in any number of planes."""
    polar, azimuth = numpy.linspace(0, math.pi, 10), numpy.linspace(0, TURN, planes)
    return Grid(polar, azimuth, numpy.full((planes, 10), value), system=system)


@for_each(product([0, 1, 2, 3, 5, 10, 20, 50, 100, 300, 1000], [0.5, 1, 2.5, 5, 10]))
def test_the_error_bound_holds_for_a_table_of_a_lobe(exponent, step):
    """A lobe's flux is 2 pi / (n + 1); details between two angles cannot be seen."""
    found = axial(lambda t: max(math.cos(t), 0.0) ** exponent, step).flux()
    true = TURN / (exponent + 1)
    assert abs(found.value - true) <= found.error + 1e-12
    beam = 2 * math.degrees(math.acos(0.5 ** (1 / exponent))) if exponent else 180
    if beam > 4 * step:  # the error is of use where the table shows the lobe
        assert found.error < 0.1 * true


def test_a_laboratory_table():
    """Linear between (theta, I), 2 pi sum of [-I cos + s sin]; and six zones of means."""
    lamp = Grid(
        numpy.radians(range(0, 91, 15)), [0.0], [[300.0, 290.0, 260.0, 200.0, 110.0, 30.0, 0.0]]
    )
    assert lamp.flux().value == pytest.approx(791.3485, abs=5e-5)
    assert lamp.zonal_flux() == pytest.approx(797.6, abs=0.05)


@pytest.mark.parametrize("system", "BC")
@pytest.mark.parametrize("planes", [3, 5, 9, 13])
def test_a_sphere_and_its_parts(system, planes):
    lamp = sphere(system, planes)
    assert lamp.flux().value == pytest.approx(4 * math.pi * 7, rel=1e-14)
    assert lamp.zonal_flux() == pytest.approx(4 * math.pi * 7, rel=1e-14)
    part = lamp.flux((0.3, 1.1), (5.0, 7.5))
    true = 7 * 2.5 * (math.cos(0.3) - math.cos(1.1))
    assert part.value == pytest.approx(true, rel=1e-12 if system == "C" else 1e-4)
    assert lamp.intensity(2.0, 1.0) == pytest.approx(7.0, rel=1e-15)


@pytest.mark.parametrize("width", [1e-7, 2e-4, 0.05, 0.19, 0.21, 1.0])
def test_a_narrow_table_is_exact(width):
    """A straight fall to 0, integrated by mpmath: cosines of near angles differ by few digits."""
    with mpmath.workdps(50):
        w = mpmath.mpf(width)
        true = 2 * mpmath.pi * (1 - mpmath.sin(w) / w)  # of (1 - theta/w) sin(theta)
    assert Grid([0.0, width], [0.0], [[1.0, 0.0]]).flux().value == pytest.approx(
        float(true), rel=2e-14
    )


def test_a_part_between_angles_is_exact():
    """The integral of a bilinear table over a part, by mpmath, piece by piece."""
    polar, azimuth = [0.1, 0.5, 1.2, 2.0], [0.2, 1.0, 3.0]
    values = [[1.0, 4.0, 2.0, 0.5], [2.0, 1.0, 3.0, 0.0], [0.0, 5.0, 1.0, 2.0]]
    lamp = Grid(polar, azimuth, values)

    def at(t, p):
        j = 0 if p < azimuth[1] else 1
        i = 0 if t < polar[1] else 1 if t < polar[2] else 2
        v = (p - azimuth[j]) / (azimuth[j + 1] - azimuth[j])
        u = (t - polar[i]) / (polar[i + 1] - polar[i])
        rows = [values[j + k][i] * (1 - u) + values[j + k][i + 1] * u for k in (0, 1)]
        return rows[0] * (1 - v) + rows[1] * v

    low, high, start, end = 0.3, 1.7, 0.6, 2.1
    true = mpmath.quad(
        lambda t, p: at(t, p) * mpmath.sin(t), [low, 0.5, 1.2, high], [start, 1.0, end]
    )
    assert lamp.flux((low, high), (start, end)).value == pytest.approx(float(true), rel=1e-12)
    # a turn later, and across the dark part
    later = lamp.flux((low, high), (start + TURN, end + TURN)).value
    assert later == pytest.approx(float(true), rel=1e-12)
    whole = lamp.flux().value
    assert lamp.flux((0.0, math.pi), (2.0, 2.0 + TURN)).value == pytest.approx(whole, rel=1e-12)


def test_interpolation_is_bilinear_and_the_outside_dark():
    polar, azimuth = numpy.radians([0, 30, 90]), numpy.radians([0, 90, 270, 360])
    values = numpy.array([[10.0, 6, 2], [10, 4, 0], [10, 8, 4], [10, 6, 2]])
    lamp = Grid(polar, azimuth, values)
    at = lamp.intensity(
        numpy.radians([15, 60, 60, 30, 90, 91]), numpy.radians([0, 45, -45, 540] + [0] * 2)
    )
    assert at.tolist() == pytest.approx([8.0, 3.0, 5.0, 6.0, 2.0, 0.0])
    assert lamp.intensity(numpy.zeros((2, 1)), numpy.zeros(3)).shape == (2, 3)


def test_the_shape_of_the_poles():
    """Type B: tan V = cos C tan gamma, sin H = sin C sin gamma; polar = 90 deg - H."""
    h, v = numpy.radians(numpy.arange(-90, 91, 10.0)), numpy.radians(numpy.arange(-90, 91, 10.0))
    polar = math.pi / 2 - h[::-1]
    values = numpy.array([[1000 + 10 * i + j for j in range(19)] for i in range(19)], float)
    lamp = Grid(polar, v, values, system="B")
    gamma, c = 0.7, 0.4
    vertical = math.atan(math.cos(c) * math.tan(gamma))
    horizontal = math.asin(math.sin(c) * math.sin(gamma))
    row, column = (vertical - v[0]) / (v[1] - v[0]), (math.pi / 2 - horizontal) / (v[1] - v[0])
    assert lamp.intensity(gamma, c) == pytest.approx(1000 + 10 * row + column)
    assert lamp.intensity(3.0, 0.0) == 0
    assert lamp.flux((0.0, math.pi / 2)).value == pytest.approx(lamp.flux().value, rel=1e-3)


@pytest.mark.parametrize("system", "BC")
def test_the_peak_has_the_greatest_intensity(system):
    values = numpy.ones((5, 7))
    values[1, 2] = 9.0
    lamp = Grid(numpy.linspace(0.2, 2.0, 7), numpy.linspace(0.3, 1.5, 5), values, system=system)
    peak = lamp.peak()
    assert peak.value == 9
    assert lamp.intensity(peak.polar, peak.azimuth) == pytest.approx(9.0)


@pytest.mark.parametrize(
    ("polar", "azimuth", "values"),
    [
        ([0, 1, 1], [0], [[1, 2, 3]]),
        ([0, 1], [0, 1], [[1, 2]]),
        ([0], [0], [[1]]),
        ([1, 0], [0], [[1, 2]]),
    ],
)
def test_angles_that_do_not_rise_and_values_that_do_not_fit_are_refused(polar, azimuth, values):
    with pytest.raises(ConditionError):
        Grid(polar, azimuth, values)


@pytest.mark.parametrize("power", [2, 4, 8])
@pytest.mark.parametrize("step", [5, 10, 18])
def test_the_error_bound_holds_for_a_table_that_falls_at_its_end(power, step):
    """1 - (t/90)^k, whose integral over the hemisphere is by mpmath."""
    degrees = numpy.arange(0, 90 + step / 2, step)
    found = Grid(numpy.radians(degrees), [0.0], [1 - (degrees / 90) ** power]).flux()
    true = TURN * mpmath.quad(
        lambda t: (1 - (t / (mpmath.pi / 2)) ** power) * mpmath.sin(t), [0, mpmath.pi / 2]
    )
    assert abs(found.value - float(true)) <= found.error
