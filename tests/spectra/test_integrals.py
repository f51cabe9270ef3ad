"""Integrals of tables, compared with the trapezoid rule on both grids."""

import math
from bisect import bisect_right
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.spectrum import clip, integral, moments

PHOTOPIC = OBSERVERS["photopic"]


@given(
    st.lists(st.floats(310, 900), min_size=2, max_size=12, unique=True),
    st.data(),
)
def test_the_integral_is_the_trapezoid_on_the_union_of_both_grids(places, data):
    grid = sorted(places)
    values = data.draw(st.lists(st.floats(0, 10), min_size=len(grid), max_size=len(grid)))
    if min(b - a for a, b in pairwise(grid)) < 1e-6:
        return
    nodes = range(PHOTOPIC.start, PHOTOPIC.end + 1)
    union = sorted({*grid, *(n for n in nodes if grid[0] <= n <= grid[-1])})
    union = [x for x in union if PHOTOPIC.start <= x <= PHOTOPIC.end]

    def linear(xs, ys, x):
        i = bisect_right(xs, x, hi=len(xs) - 1) - 1
        return ys[i] + (ys[i + 1] - ys[i]) * (x - xs[i]) / (xs[i + 1] - xs[i])

    heights = [linear(grid, values, x) * linear(nodes, PHOTOPIC.values, x) for x in union]
    pairs = zip(union, union[1:], heights, heights[1:], strict=False)
    expected = math.fsum((b - a) * (p + q) / 2 for a, b, p, q in pairs)
    found = moments(grid, values, PHOTOPIC.start, len(PHOTOPIC.values))
    got = math.fsum(m * v for m, v in zip(found, PHOTOPIC.values, strict=True))
    assert got == pytest.approx(expected, rel=1e-9, abs=1e-12)


def test_a_range_clips_with_a_step():
    grid, values = [400.0, 500.0, 600.0], [1.0, 1.0, 1.0]
    assert integral(grid, values, 450, 550) == 100
    assert clip(grid, values, 450, 550) == ([450, 500, 550], [1, 1, 1])
    assert integral(grid, values, 700, 800) == 0
    assert integral(grid, values, 100, 450) == 50
