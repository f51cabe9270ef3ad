"""Images on projection screens."""

import math

import pytest
from conftest import run

import radcalc


@pytest.mark.parametrize(
    ("words", "asked", "expected"),
    [
        # A foot-lambert is 1/pi candela per square foot: a lumen a square foot, at a gain of 1.
        ("--flux 1000lm --area 100ft2 --gain 1", "luminance:fL", 10),
        ("--flux 1000lm --area 100ft2 --gain 1.8", "luminance:fL", 18),
        ("--flux 1000lm --area 100ft2", "illuminance:fc", 10),
        # 14 foot-lamberts are 47.97 cd/m2 (GNU units 2.23: footlambert = (1/pi) cd / ft^2)
        ("--luminance 14fL --width 40ft --height 16.7ft", "flux:lm", 14 * 40 * 16.7),
        ("--luminance 47.9675cd/m2 --area 668ft2", "flux:lm", 9352),
        # of a diagonal c at 16:9 the sides are 16 c/sqrt(337) and 9 c/sqrt(337)
        ("--flux 1lm --diagonal 100in --aspect 16/9", "width:in", 1600 / math.sqrt(337)),
        ("--flux 1lm --diagonal 100in --aspect 16/9", "height:in", 900 / math.sqrt(337)),
        ("--flux 1lm --width 4m --height 3m", "diagonal:m", 5),
        ("--flux 1lm --width 4m --diagonal 5m", "aspect", 4 / 3),
        ("--flux 1lm --area 12m2 --aspect 4/3", "width:m", 4),
        ("--flux 1lm --area 12m2 --diagonal 5m", "width:m", 4),
        ("--flux 1lm --area 12m2 --diagonal 5m", "aspect", 4 / 3),
        ("--flux 1lm --area 12m2 --diagonal 5m --width 3m", "height:m", 4),
        # pi cd/m2 at 1 lx is a perfect diffuser's pi times: the gain is pi L / E
        ("--luminance 100cd/m2 --illuminance 314.159265359lx", "gain", 1),
        ("--illuminance 500lx --gain 0.9", "luminance:cd/m2", 450 / math.pi),
    ],
)
def test_a_picture_follows_from_any_sufficient_set(words, asked, expected):
    done = run("screen", *words.split(), "-q", "-g", asked)
    assert float(done.stdout) == pytest.approx(expected, rel=1e-5)


def test_assumptions_are_stated():
    done = run("screen", "--flux", "10lm", "--area", "1m2")
    assert "gain of 1" in done.stderr
    assert "dark room" in done.stderr


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--width 2m", "a light quantity is missing"),
        ("--flux 1lm --area 2m2 --diagonal 1.9m", "too short for that area"),
        ("--flux 2000lm --width 2m", "--flux 2000lm needs further inputs"),
        ("--flux 1lm --width 2m --height 1m --aspect 16/9", "contradicts the other inputs"),
        ("--flux 1lm --area 1m2 --gain 0", "out of range"),
        ("--flux 1lm --area 1m2 --distance 2m", "screen has no --distance option"),
        ("--flux 1lm --width 2m --diagonal 1m", "diagonal"),
    ],
)
def test_impossible_pictures_are_refused(words, message):
    done = run("screen", *words.split())
    assert done.returncode == 2
    assert message in done.stderr


def test_the_gain_follows_from_flux_area_and_luminance():
    words = "screen --flux 3000lm --area 2m2 --luminance 600cd/m2 -g gain"
    done = run(*words.split())
    assert float(done.stdout) == pytest.approx(600 * math.pi / 1500, rel=1e-11)


@pytest.mark.parametrize(
    ("aspect", "ratio"), [("16:9", 16 / 9), ("2.39:1", 2.39), ("4:3", 4 / 3), ("16/9", 16 / 9)]
)
def test_an_aspect_ratio_may_have_a_colon(aspect, ratio):
    # the width of a diagonal c: c a / sqrt(1 + a^2)
    done = run("screen", "--diagonal", "100in", "--aspect", aspect, "-g", "width:m", "-q")
    right = 2.54 * ratio / math.hypot(1, ratio)
    assert float(done.stdout) == pytest.approx(right, rel=1e-11)
    found = radcalc.screen(diagonal="100in", aspect=aspect).width.to("m").magnitude
    assert found == pytest.approx(right, rel=1e-14)


def test_aspect_ratios_may_be_a_list_or_a_range():
    for aspects, count in (("16:9,4:3", 2), ("1.6:2:0.2", 3)):
        done = run("screen", "--diagonal", "100in", "--aspect", aspects, "-g", "width", "-q")
        assert len(done.stdout.splitlines()) == count
