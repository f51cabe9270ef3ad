"""Checks of polygons that a user typed."""

import math

import pytest
from geometry.references import close, excess, lambert

from radcalc.errors import ConditionError
from radcalc.geometry import polygons, solid
from radcalc.geometry.polygons import polygon

SQUARE = [(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0), (0.0, 1.0, 1.0)]
HERE = (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("vertices", "viewpoint", "message"),
    [
        (SQUARE[:2], HERE, "2 vertices"),
        ([(math.cos(k / 200), math.sin(k / 200), 1.0) for k in range(1001)], HERE, "1001 vertices"),
        ([*SQUARE, SQUARE[0]], HERE, "given twice"),
        ([SQUARE[0], SQUARE[1], SQUARE[1], SQUARE[2]], HERE, "given twice"),
        ([(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (3.0, 0.0, 1.0)], HERE, "no area"),
        ([*SQUARE[:3], (0.0, 1.0, 1.01)], HERE, "not flat"),
        ([SQUARE[0], SQUARE[2], SQUARE[1], SQUARE[3]], HERE, "cross"),
        ([(0.0, 0.0, 1.0), (4.0, 3.0, 1.0), (4.0, 0.0, 1.0), (0.0, 2.0, 1.0)], HERE, "cross"),
        # a vertex on a side
        ([(0.0, 0.0, 1.0), (4.0, 0.0, 1.0), (4.0, 2.0, 1.0), (2.0, 0.0, 1.0), (0.0, 2.0, 1.0)],
         HERE, "cross or touch"),
        (SQUARE, (5.0, 5.0, 1.0), "in the polygon's plane"),
        (SQUARE, (0.5, 0.5, 1.0), "in the polygon's plane"),
    ],
)  # fmt: skip
def test_invalid_polygons_are_refused(vertices, viewpoint, message):
    with pytest.raises(ConditionError, match=message) as caught:
        polygons.read_vertices(vertices, viewpoint)
    assert caught.value.hint


def test_a_polygon_with_a_notch_is_the_sum_of_its_triangles():
    notched = [(-2.0, -2.0, 0.0), (2.0, -2.0, 0.0), (0.0, -1.0, 0.0), (2.0, 2.0, 0.0)]
    viewpoint = (0.3, 0.2, -1.5)
    found = polygons.read_vertices(notched, viewpoint)
    moved = [tuple(x - v for x, v in zip(p, viewpoint, strict=True)) for p in notched]
    # the notch is at the third vertex: two triangles that share the diagonal from it
    want = sum(excess([moved[2], *pair]) for pair in ((moved[0], moved[1]), (moved[0], moved[3])))
    close(abs(polygon(found.vertices)), want)
    assert found.notes == []
    assert not found.dips_below((0.0, 0.0, 1.0))
    assert found.dips_below((0.0, 0.0, -1.0))
    assert found.normal == pytest.approx((0.0, 0.0, 1.0), abs=1e-15)
    away = polygons.read_vertices(notched, (0.3, 0.2, 1.5))
    assert away.normal == pytest.approx((0.0, 0.0, -1.0), abs=1e-15)
    # a receiver that faces the plane sees the whole polygon
    close(solid.projected_polygon(found.vertices, found.normal), abs(lambert(moved, (0, 0, 1))))


def test_a_polygon_of_a_thousand_vertices():
    ring = [(math.cos(k * math.pi / 500), math.sin(k * math.pi / 500), 1.0) for k in range(1000)]
    found = polygons.read_vertices(ring, HERE)
    # a regular pyramid's apex: 2 pi - 2 n arctan(tan(pi/n) / sqrt(1 + r^2/h^2))
    want = 2 * math.pi - 2000 * math.atan(math.tan(math.pi / 1000) / math.sqrt(2))
    assert polygon(found.vertices) == pytest.approx(want, rel=1e-12)
    close(polygon(found.vertices), excess(ring))
