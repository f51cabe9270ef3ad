"""Triangles, polygons and their clipping: spherical excess, defining integrals, invariances."""

import math
import random
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from geometry.references import DIGITS, close, cross, dot, excess, lambert, over_rectangle
from helpers import for_each
from hypothesis import assume, given
from hypothesis import strategies as st

from radcalc.errors import ConditionError
from radcalc.geometry import solid
from radcalc.geometry.polygons import polygon, triangle


def integral(vertices, weight):
    """The defining integral of a triangle: weight(r) n.r / r^3 over its area."""
    a, b, c = vertices
    ab, bc = ([y - x for x, y in zip(p, q, strict=True)] for p, q in ((a, b), (b, c)))

    def part(u, v):
        p = tuple(x + u * (y + v * z) for x, y, z in zip(a, ab, bc, strict=True))
        away = np.sqrt(dot(p, p))
        return u * weight(p, away) / away**3

    return dot(a, cross(ab, bc)) * over_rectangle(part, (0.0, 1.0), (0.0, 1.0), points=120)


# --- Triangles and convex polygons.

TRIANGLES = [
    [(1.0, 0.0, 0.5), (0.0, 1.0, 0.7), (-0.3, -0.2, 1.0)],
    [(1.0, 0.0, 2.0), (0.0, 1.0, 2.0), (0.5, 0.5, 3.0)],
    [(2.0, 1.0, 1.0), (-1.0, 2.0, 1.5), (-2.0, -2.0, 1.0)],
]


@pytest.mark.parametrize("vertices", TRIANGLES)
def test_a_triangle_is_its_defining_integral(vertices):
    whole = integral(vertices, lambda p, away: 1)
    close(excess(vertices), abs(whole), 1e-13)
    close(abs(triangle(*vertices)), abs(whole))
    for normal in ((0.0, 0.0, 1.0), (0.1, -0.2, 3.0)):
        size = math.sqrt(dot(normal, normal))
        part = integral(vertices, lambda p, away, n=normal: dot(p, n) / away) / size
        close(lambert(vertices, normal), part, 1e-13)
        close(solid.projected_polygon(vertices, normal), abs(part))


def convex(draw, sides, size, away, lean):
    """Vertices on an ellipse, from a centre at a distance."""
    turns = sorted(draw.uniform(0, 2 * math.pi) for _ in range(sides))
    bearing, polar = draw.uniform(0, 6), draw.uniform(0, 0.6)
    centre = [
        away * math.sin(polar) * math.cos(bearing),
        away * math.sin(polar) * math.sin(bearing),
    ]
    return [
        (centre[0] + size * math.cos(t), centre[1] + 0.5 * size * math.sin(t),
         away * math.cos(polar) + lean * size * math.cos(t))
        for t in turns
    ]  # fmt: skip


def polygons():
    draw = random.Random(13)
    for k in range(40):
        size = 10 ** draw.uniform(-9, 2)
        yield convex(draw, 3 + k % 5, size, 1.0, draw.uniform(0, 0.3) if size < 1 else 0.0)


@for_each(list(polygons()))
def test_convex_polygons_small_and_large(vertices):
    # Rounding moves vertices off one plane, so the reference is the sum of the fan's triangles.
    with mpmath.workdps(DIGITS):
        pairs = list(pairwise(vertices[1:]))
        want = sum(excess([vertices[0], *pair]) for pair in pairs)
    close(polygon(vertices), want)
    close(polygon(vertices[::-1]), -want)
    close(solid.projected_polygon(vertices, (0.0, 0.0, 2.0)), abs(lambert(vertices, (0, 0, 2))))


def test_the_octant():
    octant = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    assert triangle(*octant) == pytest.approx(math.pi / 2, rel=1e-15)  # an eighth of 4 pi
    assert triangle(*octant[::-1]) == pytest.approx(-math.pi / 2, rel=1e-15)
    assert solid.projected_polygon(octant, (0.0, 0.0, 1.0)) == pytest.approx(math.pi / 4, rel=1e-14)


def test_a_triangle_that_is_nearly_a_hemisphere():
    # a triangle close by is nearly a hemisphere
    base = [(math.cos(t), math.sin(t), 1e-3) for t in (0.0, 2.0, 4.0)]
    close(triangle(*base), excess(base))
    with pytest.raises(ConditionError):
        polygon(base[:2])


GOLDEN = (1 + math.sqrt(5)) / 2


def test_the_faces_of_platonic_solids():
    # by symmetry each of n faces fills 4 pi/n from the centre
    signs = [(i, j) for i in (1, -1) for j in (1, -1)]
    icosahedron = np.array(
        [np.roll((0.0, i * 1.0, j * GOLDEN), k) for i, j in signs for k in range(3)]
    )
    faces = 0
    for i in range(12):
        for j in range(i):
            for k in range(j):
                a, b, c = icosahedron[[i, j, k]]
                if all(abs(np.dot(p - q, p - q) - 4) < 1e-9 for p, q in ((a, b), (b, c), (a, c))):
                    faces += 1
                    assert abs(triangle(a, b, c)) == pytest.approx(math.pi / 5, rel=1e-13)
    assert faces == 20
    # a face of the dodecahedron
    t = 2 * math.pi / 5
    height = math.sqrt(25 + 11 * math.sqrt(5)) / math.sqrt(40)  # inradius over edge
    radius = 1 / (2 * math.sin(math.pi / 5))
    face = [(radius * math.cos(k * t), radius * math.sin(k * t), height) for k in range(5)]
    assert polygon(face) == pytest.approx(math.pi / 3, rel=1e-13)
    # three edges at 60 degrees to each other: the corner of a tetrahedron, arccos(23/27)
    corner = [(1.0, 1.0, 0.0), (0.0, 1.0, 1.0), (1.0, 0.0, 1.0)]
    assert abs(triangle(*corner)) == pytest.approx(math.acos(23 / 27), rel=1e-13)


# --- Invariances.

coordinates = st.floats(-10, 10)
points = st.tuples(coordinates, coordinates, coordinates)


def wide(a, b, c) -> bool:
    """Return whether a triangle is neither a splinter nor seen nearly edge-on."""
    sizes = [math.sqrt(dot(p, p)) for p in (a, b, c)]
    return min(sizes) > 1e-2 and abs(dot(a, cross(b, c))) > 1e-2 * math.prod(sizes)


@given(points, points, points)
def test_the_sign_of_a_triangle_is_its_orientation(a, b, c):
    assume(wide(a, b, c))
    value = triangle(a, b, c)
    assert triangle(a, c, b) == pytest.approx(-value, rel=1e-12)
    assert triangle(b, c, a) == pytest.approx(value, rel=1e-12)
    assert value * dot(a, cross(b, c)) > 0
    assert triangle(*(tuple(1e3 * x for x in p) for p in (a, b, c))) == pytest.approx(value, 1e-12)


def rotation(a, b, c):
    """Return the matrix of three Euler angles."""

    def about(axis, t):
        i, j = [(1, 2), (2, 0), (0, 1)][axis]
        matrix = np.eye(3)
        matrix[i, i] = matrix[j, j] = math.cos(t)
        matrix[i, j], matrix[j, i] = -math.sin(t), math.sin(t)
        return matrix

    return about(2, a) @ about(0, b) @ about(2, c)


rotations = st.builds(rotation, *[st.floats(-3, 3)] * 3)


def turned(matrix, points):
    return [tuple(map(float, matrix @ np.array(point))) for point in points]


@st.composite
def flat_polygons(draw):
    """A convex polygon in the plane z = 1, its vertices on a circle."""
    turns = draw(st.lists(st.integers(0, 71), min_size=4, max_size=9, unique=True))
    x, y, size = draw(st.floats(-3, 3)), draw(st.floats(-3, 3)), draw(st.floats(1e-2, 5))
    angles = [k * math.pi / 36 for k in sorted(turns)]
    return [(x + size * math.cos(t), y + size * math.sin(t), 1.0) for t in angles]


@given(flat_polygons(), st.data())
def test_a_polygon_is_the_sum_of_its_parts(vertices, data):
    cut = data.draw(st.integers(2, len(vertices) - 2))
    one, two = vertices[: cut + 1], [*vertices[cut:], vertices[0]]
    assert polygon(one) + polygon(two) == pytest.approx(polygon(vertices), rel=1e-12)
    for normal in ((0.0, 0.0, 1.0), (1.0, 0.2, 0.1)):
        parts = solid.projected_polygon(one, normal) + solid.projected_polygon(two, normal)
        whole = solid.projected_polygon(vertices, normal)
        assert parts == pytest.approx(whole, rel=1e-12, abs=1e-15)


@given(flat_polygons(), rotations)
def test_a_rotation_changes_no_solid_angle(vertices, matrix):
    value = polygon(vertices)
    assert polygon(turned(matrix, vertices)) == pytest.approx(value, rel=1e-12)
    normal = (1.0, 0.2, 0.1)
    value = solid.projected_polygon(vertices, normal)
    (other,) = turned(matrix, [normal])
    got = solid.projected_polygon(turned(matrix, vertices), other)
    assert got == pytest.approx(value, rel=1e-11, abs=1e-15)


@given(flat_polygons(), points)
def test_the_parts_above_and_below_the_horizon_differ_by_the_light_vector(vertices, normal):
    assume(dot(normal, normal) > 1e-4)
    above = solid.projected_polygon(vertices, normal)
    below = solid.projected_polygon(vertices, tuple(-x for x in normal))
    assert above >= 0
    assert below >= 0
    # the part above the horizon counts positively, as the vertices are anticlockwise about +z
    with mpmath.workdps(DIGITS):
        want = lambert(vertices, normal)
    assert above - below == pytest.approx(float(want), rel=1e-12, abs=1e-13)
    assert above + below <= abs(polygon(vertices)) * (1 + 1e-12)


@given(flat_polygons(), st.floats(1.0, 3.0))
def test_a_larger_polygon_fills_a_larger_solid_angle(vertices, factor):
    x, y = (sum(p[i] for p in vertices) / len(vertices) for i in (0, 1))
    larger = [(x + factor * (p[0] - x), y + factor * (p[1] - y), 1.0) for p in vertices]
    assert abs(polygon(larger)) >= abs(polygon(vertices)) * (1 - 1e-12)
    one, two = (solid.projected_polygon(p, (0.5, 0.0, 1.0)) for p in (larger, vertices))
    assert one >= two * (1 - 1e-12)


@given(st.tuples(*[st.floats(-3, 3)] * 3), rotations)
def test_the_faces_of_a_cube_add_up_to_4_pi_inside_and_0_outside(place, matrix):
    assume(all(abs(abs(x) - 1) > 1e-3 for x in place))
    total = 0.0
    for axis in range(3):
        for sign in (1.0, -1.0):
            ring = [(1.0, 1.0), (-sign, sign), (-1.0, -1.0), (sign, -sign)]  # left from inside
            face = [np.insert(np.array(p), axis, sign) - np.array(place) for p in ring]
            total += polygon(turned(matrix, face)) * (-1 if axis == 1 else 1)
    inside = all(abs(x) < 1 for x in place)
    assert abs(total) == pytest.approx(4 * math.pi if inside else 0.0, rel=1e-12, abs=1e-12)


def test_arrays_of_polygons_give_the_same_as_floats():
    draw = random.Random(14)
    one = [convex(draw, 5, 10 ** draw.uniform(-3, 0), 1.0, 0.1) for _ in range(12)]
    array = np.reshape(one, (3, 4, 5, 3))
    want = np.reshape([polygon(p) for p in one], (3, 4))
    np.testing.assert_allclose(polygon(array), want, rtol=1e-13)
    a, b, c = (array[..., k, :] for k in range(3))
    want = np.reshape([triangle(*p[:3]) for p in one], (3, 4))
    np.testing.assert_allclose(triangle(a, b, c), want, rtol=1e-13)
    np.testing.assert_allclose(triangle(one[0][0], b, c)[0, 0], want[0, 0], rtol=1e-13)
    for normal in ((0.0, 0.0, 1.0), (1.0, 0.1, 0.05)):
        want = np.reshape([solid.projected_polygon(p, normal) for p in one], (3, 4))
        np.testing.assert_allclose(solid.projected_polygon(array, normal), want, rtol=1e-13)
    normals = np.array([(0.0, 0.0, 1.0), (1.0, 0.1, 0.05), (0.3, 0.3, 0.3), (0.0, 0.0, -1.0)])
    want = np.reshape(
        [solid.projected_polygon(p, tuple(normals[k % 4])) for k, p in enumerate(one)], (3, 4)
    )
    np.testing.assert_allclose(solid.projected_polygon(array, normals), want, rtol=1e-13)
