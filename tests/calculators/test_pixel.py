"""Pixels of maps of the sphere: commands and their numbers."""

import math

import pytest
from conftest import run

PI = math.pi


@pytest.mark.parametrize(
    ("words", "values"),
    [
        # a row of a latlong map is a zone, 2 pi (cos a - cos b) sr, divided among its pixels
        ("--size 4x2 --pixel 3,1 -g solid-angle -g sphere-fraction", [PI / 2, 1 / 8]),
        ("--size 12x6 --pixel 0,0 -g solid-angle", [PI / 6 * (1 - math.sqrt(0.75))]),
        ("--size 12x6 --pixel 11,5 -g solid-angle:deg2",
         [PI / 6 * (1 - math.sqrt(0.75)) * (180 / PI) ** 2]),
        ("--size 2x1 --pixel 0,0 -g half-angle -g apex-angle", [90, 180]),
        ("--size 4x2 --pixel 0,0 -g polar -g azimuth", [45, 135]),
        ("--size 4x2 --pixel 3,1 -g polar -g azimuth", [135, 225]),
        # 4 du dv; a quarter of a ball is a quarter of the sphere
        ("--projection mirror-ball --size 100x100 --pixel 50,49 -g solid-angle", [0.0016]),
        ("--projection mirror-ball --size 2x2 --pixel 1,0 -g solid-angle", [PI]),
        ("--projection mirror-ball --size 1x1 --pixel 0,0 -g polar -g azimuth", [90, 0]),
        ("--projection mirror-ball --size 3x3 --pixel 2,1 -g polar -g azimuth",
         [90, math.degrees(2 * math.asin(2 / 3))]),
        # right of the middle at 120 degrees; a corner is outside
        ("--projection angular --size 3x3 --pixel 2,1 -g polar -g azimuth", [90, 240]),
        ("--projection angular --size 3x3 --pixel 1,0 -g polar -g azimuth", [30, 180]),
        ("--projection angular --size 64x64 --pixel 0,63 -g solid-angle", [0]),
        ("--projection angular --size 2x2 --pixel 0,1 -g solid-angle", [PI]),
    ],
)  # fmt: skip
def test_pixels_in_closed_form(words, values):
    done = run("solid-angle", "pixel", *words.split())
    assert done.returncode == 0, done.stderr
    assert [float(x) for x in done.stdout.split()] == pytest.approx(values, rel=1e-11, abs=1e-15)


@pytest.mark.parametrize(
    ("words", "text"),
    [
        ("--size 4x2 --pixel 0,0", "assumed: a latlong map (--projection)"),
        ("--size 4x2 --pixel 0,0", "assumed: the pixel 0,0 is at the top left"),
        ("--size 4x4 --pixel 1,1 --projection mirror-ball", "+y to the right, as in a mirror"),
        ("--size 4x4 --pixel 0,0 --projection angular", "note: the circle of the map cuts"),
        ("--size 64x64 --pixel 0,0 --projection angular", "note: the pixel shows nothing"),
    ],
)
def test_assumptions_and_unusual_inputs_are_stated(words, text):
    assert text in run("solid-angle", "pixel", *words.split()).stderr


def test_a_pixel_within_the_circle_is_not_noted():
    words = "solid-angle pixel --size 4x4 --pixel 1,1 --projection angular"
    assert "note" not in run(*words.split()).stderr


@pytest.mark.parametrize(
    ("words", "message", "hint"),
    [
        ("--pixel 0,0", "the size of the map is missing", "--size 1024x512"),
        ("--size 64x32", "the pixel is missing", "--pixel 0,0"),
        ("--size 64x32 --pixel 64,0", "--pixel 64,0 is outside the map", "columns from 0 to 63"),
        ("--size 64x32 --pixel 0,32", "--pixel 0,32 is outside the map", "rows from 0 to 31"),
        ("--size 64x32 --pixel -1,0", "--pixel -1,0 is not two whole numbers", "--pixel 0,0"),
        ("--size 64 --pixel 0,0", "--size 64 is not two whole numbers", "--size 1024x512"),
        ("--size 0x0 --pixel 0,0", "--size 0x0 is out of range", "from 1 to 1000000 pixels"),
        ("--size 64x64 --pixel 0,0", "not twice as wide as high", "--projection mirror-ball"),
        ("--size 64x64 --pixel 0,0 --projection latlong", "not twice as wide", "--size 128x64"),
        ("--size 64x32 --pixel 0,0 --projection angular", "not square, as an angular map is",
         "--size 32x32"),
        ("--size 64x32 --pixel 0,0 --projection mirror-ball", "not square, as a mirror-ball map is",
         "--size 32x32"),
        ("--size 64x32 --pixel 0,0 --radius 2m", "--radius does not apply to a pixel",
         "try: radcalc solid-angle pixel --size 64x32 --pixel 0,0\n"),
        ("--size 64x64 --pixel 0,0 --projection angular -g polar", "there is no polar",
         "a pixel further inside"),
    ],
)  # fmt: skip
def test_impossible_pixels_are_refused(words, message, hint):
    done = run("solid-angle", "pixel", *words.split())
    assert (done.returncode, done.stdout) == (2, "")
    said, told = done.stderr.splitlines(keepends=True)[:2]
    assert message in said
    assert hint in told
