"""Exposure values in closed form."""

import math

import pytest
from helpers import number

from radcalc import ev


@pytest.mark.parametrize(
    ("call", "name", "unit", "expected"),
    [
        (lambda: ev(ev100=15), "luminance", "cd/m2", 4096),
        (lambda: ev(ev100=15), "illuminance", "lx", 81920),
        (lambda: ev(luminance="1000cd/m2"), "ev100", "1", math.log2(8000)),
        (lambda: ev(f_number=16, time="1/100s", iso=100), "ev", "1", math.log2(25600)),
        (lambda: ev(illuminance="500lx", f_number=4, iso=400), "time", "s", 16 / 800),
    ],
)  # fmt: skip
def test_each_answer_about_an_exposure_is_its_formula(call, name, unit, expected):
    assert number(call(), name, unit) == pytest.approx(expected, rel=1e-12)
