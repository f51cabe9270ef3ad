"""Sources at their positions, compared with a double loop, closed forms and quadrature."""

import math
import random

import numpy
import pytest

from radcalc.distributions.distribution import DOWN, Grid, Pose
from radcalc.distributions.scene import (
    BLOCK,
    Axis,
    Emitter,
    Panel,
    Statistics,
    blocks,
    field,
    grid,
    unit,
)
from radcalc.distributions.sources import Cone, Formula, Isotropic, Lobe
from radcalc.errors import ConditionError

UP = (0.0, 0.0, 1.0)


def turned(vector, aim, rotate):
    """Rotate a vector (Rodrigues) by the least angle from straight down to the aim.

    Beforehand it is turned about the vertical by `rotate`.
    """
    x, y, z = vector
    x, y = x * math.cos(rotate) - y * math.sin(rotate), x * math.sin(rotate) + y * math.cos(rotate)
    size = math.hypot(*aim)
    aim = [c / size for c in aim]
    k = (aim[1], -aim[0], 0.0)  # (0,0,-1) x aim
    sine, cosine = math.hypot(*k), -aim[2]
    if not sine:  # straight up: about the x axis, so that C0 stays
        return (x, y, z) if cosine > 0 else (x, -y, -z)
    k = [c / sine for c in k]
    along = k[0] * x + k[1] * y
    across = (k[1] * z, -k[0] * z, k[0] * y - k[1] * x)
    return tuple(
        v * cosine + a * sine + c * along * (1 - cosine)
        for v, a, c in zip((x, y, z), across, k, strict=True)
    )


def by_hand(intensity, place, aim, rotate, point, normal):
    """I(theta, phi) cos(epsilon) / d^2, of one source at one point."""
    to = [p - s for p, s in zip(point, place, strict=True)]
    distance = math.hypot(*to)
    x, y, z = (
        sum(a * b for a, b in zip(turned(own, aim, rotate), to, strict=True)) / distance
        for own in ((1, 0, 0), (0, 1, 0), (0, 0, -1))
    )
    theta, phi = math.acos(max(-1.0, min(1.0, z))), math.atan2(y, x) % (2 * math.pi)
    size = math.hypot(*normal)
    cosine = -sum(n * t for n, t in zip(normal, to, strict=True)) / distance / size
    return intensity(theta, phi) * max(cosine, 0.0) / distance**2


DEGREES = [0, 15, 30, 45, 60, 75, 90]
CANDELAS = [300, 290, 260, 200, 110, 30, 0]


def tabulated(theta, phi):
    """Return the table with linear interpolation."""
    degrees = math.degrees(theta)
    if degrees >= 90:
        return 0.0
    k = int(degrees // 15)
    return CANDELAS[k] + (CANDELAS[k + 1] - CANDELAS[k]) * (degrees - DEGREES[k]) / 15


DISTRIBUTIONS = [
    (Isotropic(), lambda theta, phi: 1.0),
    (Cone(0.6), lambda theta, phi: float(theta <= 0.6)),
    (Lobe(2.5), lambda theta, phi: max(math.cos(theta), 0.0) ** 2.5 * (theta < math.pi / 2)),
    (
        Formula("(2 + cos(phi) + sin(2*phi))*(1 + cos(theta))"),
        lambda theta, phi: (2 + math.cos(phi) + math.sin(2 * phi)) * (1 + math.cos(theta)),
    ),
    (Grid(numpy.radians(DEGREES), [0.0], [CANDELAS]), tabulated),
]


@pytest.mark.parametrize("seed", range(6))
def test_the_sum_equals_a_double_loop(seed):
    chance = random.Random(seed)
    sources, rows = [], []
    for k in range(7):
        distribution, intensity = chance.choice(DISTRIBUTIONS)
        place = tuple(chance.uniform(-3, 3) for _ in range(3))
        aim = chance.choice([DOWN, (0.0, 0.0, 2.0), tuple(chance.gauss(0, 1) for _ in range(3))])
        rotate, factor = chance.uniform(-7, 7), chance.uniform(1, 500)
        sources.append(Emitter(f"{k}", place, Pose(aim, rotate), distribution, factor))
        rows.append((intensity, factor, place, aim, rotate))
    points = [tuple(chance.uniform(-4, 4) for _ in range(3)) for _ in range(50)]
    normal = tuple(chance.gauss(0, 1) for _ in range(3))
    expected = [
        [factor * by_hand(intensity, *where, point, normal) for intensity, factor, *where in rows]
        for point in points
    ]
    found = field(sources, next(blocks(points)), unit(normal), with_parts=True)
    assert found.total == pytest.approx([sum(row) for row in expected], rel=1e-9)
    assert numpy.transpose(found.parts) == pytest.approx(numpy.array(expected), rel=1e-9, abs=1e-12)


def test_a_ring_of_sources_above_its_centre():
    """N I h / (R^2 + h^2)^(3/2), for N sources of I on a circle of R."""
    ring = [
        Emitter("", (3 * math.cos(a), 3 * math.sin(a), 4.0), Pose(), Isotropic(), 250.0)
        for a in numpy.linspace(0, 2 * math.pi, 12, endpoint=False)
    ]
    total = field(ring, next(blocks([[0, 0, 0]])), UP).total
    assert total == pytest.approx([12 * 250 * 4 / 125])


@pytest.mark.parametrize(("exponent", "power"), [(0.0, 3), (1.0, 4), (2.0, 5)])
def test_a_lobe_follows_the_cosine_law(exponent, power):
    """On a plane E = I0 cos^(n+3) / h^2; cos^4 of a Lambertian source."""
    angles = numpy.radians([0, 10, 30, 60, 80])
    points = [[2 * math.tan(a), 0, 0] for a in angles]
    lamp = Emitter("", (0.0, 0.0, 2.0), Pose(), Lobe(exponent), 100.0)
    expected = 25 * numpy.cos(angles) ** power
    assert field([lamp], next(blocks(points)), UP).total == pytest.approx(expected)


def panel_by_quadrature(place, pose, width, length, radiance, point, normal, count=700):
    """Return Return L times the sum of cos cos dA / d^2 over small parts of a rectangle."""
    u, v = ((numpy.arange(count) + 0.5) / count * side - side / 2 for side in (width, length))
    u, v = numpy.meshgrid(u, v)
    a, b, ahead = pose.axes
    to = [p - s - u * x - v * y for p, s, x, y in zip(point, place, a, b, strict=True)]
    square = sum(t * t for t in to)
    out = sum(t * n for t, n in zip(to, ahead, strict=True))
    into = -sum(t * n for t, n in zip(to, normal, strict=True))
    shares = numpy.maximum(out, 0) * numpy.maximum(into, 0) / square**2
    return radiance * float(shares.sum()) * width * length / count**2


@pytest.mark.parametrize(
    ("place", "aim", "rotate", "point", "normal"),
    [
        ((0, 0, 1), DOWN, 0.0, (0, 0, 0), UP),
        ((0, 0, 1), DOWN, 0.5, (0.3, 0.2, 0), UP),
        ((1, 2, 3), (1.0, 0.5, -1.0), 1.0, (2, 2, 0.5), UP),
        ((0, 0, 1), DOWN, 0.0, (0.2, 0, 0), (1.0, 0.0, 0.0)),  # the plane cuts it
        ((0, 0, 1), (1.0, 0.0, -0.2), 0.3, (1, 0.5, 1), (-0.6, 0.0, 0.8)),
    ],
)
def test_a_panel_is_exact_in_any_orientation(place, aim, rotate, point, normal):
    pose = Pose(aim, rotate)
    panel = Panel("panel", place, pose, 0.6, 1.2, 3000.0)
    expected = panel_by_quadrature(place, pose, 0.6, 1.2, 3000.0, point, normal)
    # the sum over parts is off where the receiver's plane cuts a row of them
    assert panel.irradiance(next(blocks([point])), normal) == pytest.approx([expected], rel=2e-4)


def test_a_panel_emits_on_one_side_only():
    panel = Panel("panel", (0.0, 0.0, 1.0), Pose(), 2.0, 2.0, 100.0)
    points = next(blocks([[0, 0, 2], [5, 0, 1], [0, 0, 0.5]]))
    assert (panel.irradiance(points, UP) > 0).tolist() == [False, False, True]
    down = field([panel], next(blocks([[0, 0, 0.5]])), DOWN)
    assert (down.total.tolist(), down.behind) == ([0.0], 1)


def test_points_at_sources_are_refused():
    lamp = Emitter("the lamp", (1.0, 2.0, 3.0), Pose(), Isotropic(), 1.0)
    with pytest.raises(ConditionError, match=r"the point 1,2,3 is at the position of the lamp"):
        field([lamp], next(blocks([[0, 0, 0], [1, 2, 3]])), UP)
    panel = Panel("the panel", (0.0, 0.0, 0.0), Pose(), 2.0, 1.0, 1.0)
    with pytest.raises(ConditionError, match=r"the point 0.9,0.4,0 is on the panel"):
        field([panel], next(blocks([[0.9, 0.4, 0]])), UP)


def test_a_near_patch_is_refused_and_a_near_luminaire_counted():
    where = next(blocks([[0, 0, 1.1], [0, 0, 0]]))
    patch = Emitter("the patch", (0.0, 0.0, 2.0), Pose(), Lobe(1.0), 1.0, 0.2, is_patch=True)
    with pytest.raises(ConditionError, match="nearer than five times"):
        field([patch], where, UP)
    lamp = Emitter("the lamp", (0.0, 0.0, 2.0), Pose(), Lobe(1.0), 1.0, 0.2)
    assert field([lamp], where, UP).near == (1,)


def test_light_from_behind_is_excluded_and_its_points_counted():
    lamps = [Emitter("", (0.0, 0.0, z), Pose(), Isotropic(), 9.0) for z in (3.0, -3.0)]
    found = field(lamps, next(blocks([[0, 0, 0], [0, 0, -5]])), UP)
    assert found.total.tolist() == pytest.approx([1.0, 9 / 64 + 9 / 4])
    assert found.behind == 1


def test_a_grid_includes_its_ends_and_z_varies_fastest():
    found = list(grid(Axis(0.0, 1.0, 3), Axis(5.0, 7.0, 2), Axis(2.0, 2.0, 1)))
    points = numpy.transpose(numpy.hstack(found)).tolist()
    assert points == [[x, y, 2.0] for x in (0.0, 0.5, 1.0) for y in (5.0, 7.0)]


def test_statistics_do_not_depend_on_blocks():
    lamps = [Emitter("", (1.0, 0.5, 3.0), Pose(), Lobe(2.0), 500.0)]
    told, everything = Statistics(), []
    for points in grid(Axis(0.0, 2.0, 301), Axis(0.0, 3.0, 300), Axis(0.0, 0.0, 1)):
        found = field(lamps, points, UP)
        told.add(found)
        everything += found.total.tolist()
    assert told.count == len(everything) == 301 * 300 > BLOCK
    assert told.mean == pytest.approx(math.fsum(everything) / len(everything), rel=1e-14)
    assert (told.least, told.most) == (min(everything), max(everything))
    assert told.least_at == (0.0, 3.0, 0.0)
    assert told.most_at == pytest.approx((1.0, 0.5, 0.0), abs=1e-2)


@pytest.mark.parametrize("points", [[], [[1, 2]], [1, 2, 3], 5.0, [[0, 0, math.nan]]])
def test_arrays_that_are_not_points_are_refused(points):
    with pytest.raises(ConditionError):
        next(blocks(points))
