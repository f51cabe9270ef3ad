"""Exposure values in closed form."""

import math

import pytest
from conftest import run
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


@pytest.mark.parametrize(
    ("words", "reading"),
    [
        ("--luminance 100cd/m2 -g luminance:EV", math.log2(100 / 0.125)),
        ("--luminance 100cd/m2 --k 14cd.s/m2 -g luminance:EV", math.log2(100 / 0.14)),
        ("--illuminance 100lx --c 340lx.s -g illuminance:EV", math.log2(100 / 3.4)),
    ],
)
def test_a_reading_in_ev_is_that_of_the_meter_with_its_constant(words, reading):
    done = run("ev", *words.split())
    assert float(done.stdout) == pytest.approx(reading, rel=1e-9)
    assert ("K = 12.5" in done.stderr.splitlines()[-1]) == (
        "--k" not in words and "--c" not in words
    )
