"""The sun's position from a place and a time, against the paper of its algorithm and astropy."""

import json
import os
import sys

import pytest
from conftest import run

import radcalc
from radcalc.errors import ConditionError

try:
    import pvlib  # noqa: F401
except ImportError:
    if os.environ.get("CI"):
        raise
    pytest.skip("pvlib is not installed", allow_module_level=True)

PRAGUE, NOON = "50.1N,14.4E", "2026-06-21T12:00+02:00"
LIGHT = ("--horizontal-illuminance", "12klx")
# By astropy 8.0.2 (get_sun in AltAz at 1013.25 hPa, 12 deg C and 550 nm), which has another model
# of refraction: 0.036 deg at an elevation of 3.3 deg.
ASTROPY = [
    (PRAGUE, NOON, 60.5514, 148.9478, 0.001),
    ("33.9S,151.2E", "2024-12-21T13:00+11:00", 79.4378, 351.5682, 0.001),
    ("-33.9,151.2", "2024-12-21T02:00Z", 79.4378, 351.5682, 0.001),
    ("0.2S, 78.5W", "2025-03-20T12:00-05:00", 84.6665, 86.4467, 0.001),
    ("40N,105W", "2010-01-15T08:00-07:00", 5.9097, 123.8116, 0.01),
    ("69.65N,18.96E", "2024-06-21T00:30+02:00", 3.3154, 356.3341, 0.04),
]
# Reda and Andreas, Solar position algorithm, NREL/TP-560-34302: a zenith angle of 50.11162 deg at
# 820 mbar, which bend the light by 0.01633 deg; 1013.25 hPa bend it by 0.0038 deg more.
SPA = ("39.742476N,105.1786W", "2003-10-17T12:30:30-07:00", 39.88838 + 0.0038, 194.34024, 0.001)


@pytest.mark.parametrize(("place", "when", "elevation", "azimuth", "off"), [*ASTROPY, SPA])
def test_the_sun_is_where_others_have_it(place, when, elevation, azimuth, off):
    done = run("sky", "clear", "--place", place, "--when", when, *LIGHT, "--tilt", "90deg",
               "--azimuth", "180deg", "--json", check=True)  # fmt: skip
    found = json.loads(done.stdout)["results"]
    assert found["sun-elevation"]["value"] == pytest.approx(elevation, abs=off)
    assert found["sun-azimuth"]["value"] == pytest.approx(azimuth, abs=off)


def test_an_answer_is_that_of_the_angles_and_says_what_they_are():
    plane = ("--sun-illuminance", "80klx", "--tilt", "30deg", "--azimuth", "180deg", *LIGHT)
    found = run("sky", "clear", "--place", PRAGUE, "--when", NOON, *plane, check=True)
    rows = dict(line.split("\t")[:2] for line in found.stdout.splitlines())
    angles = "--sun-elevation", f"{rows['sun-elevation']}deg", "--sun-azimuth"
    other = run("sky", "clear", *angles, f"{rows['sun-azimuth']}deg", *plane, check=True)
    for line, typed in zip(found.stdout.splitlines(), other.stdout.splitlines(), strict=True):
        assert float(line.split("\t")[1]) == pytest.approx(float(typed.split("\t")[1]), rel=1e-10)
    assert "azimuths are clockwise from north (+x is north, and +y east)" in found.stderr
    assert "with refraction" in found.stderr
    assert "measured from the same direction" not in found.stderr


def test_python_has_them_too_and_a_level_sky_needs_no_plane():
    found = radcalc.sky("clear", place=PRAGUE, when=NOON, horizontal_illuminance="12 klx")
    assert found.sun_elevation.to("deg").magnitude == pytest.approx(60.5514, abs=0.001)


def test_a_picture_has_the_sun(tmp_path):
    path = tmp_path / "sky.svg"
    words = ("sky", "clear", "--place", PRAGUE, "--when", NOON, *LIGHT, "--plot")
    assert run(*words, str(path)).returncode == 0
    assert path.stat().st_size > 1000


def test_a_map_has_the_sun(tmp_path):
    path = tmp_path / "sky.hdr"
    done = run("sky", "clear", "--place", PRAGUE, "--when", NOON, *LIGHT, "--save", str(path),
               "--size", "64x32")  # fmt: skip
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("words", "problem"),
    [
        (["clear", "--place", PRAGUE], "the time of the sun is missing"),
        (["clear", "--when", NOON], "the place of the sun is missing"),
        (["clear", "--place", PRAGUE, "--when", NOON, "--sun-elevation", "4deg"], "cannot be used"),
        (["clear", "--place", PRAGUE, "--when", NOON, "--sun-azimuth", "4deg"], "cannot be used"),
        (["clear", "--place", PRAGUE, "--when", "2026-06-21T12:00"], "has no offset from UTC"),
        (["clear", "--place", PRAGUE, "--when", "2026-06-21"], "has no offset from UTC"),
        (["clear", "--place", PRAGUE, "--when", "noon"], "not a date and a time of ISO 8601"),
        (["clear", "--place", PRAGUE, "--when", "0900-06-21T12:00Z"], "is out of range"),
        (["clear", "--place", PRAGUE, "--when", "2026-06-21T00:00Z"], "below the horizon (-15.4"),
        (["clear", "--place", "90.1N,14E", "--when", NOON], "is out of range"),
        (["clear", "--place", "50N,181E", "--when", NOON], "is out of range"),
        (["clear", "--place", "-50N,14E", "--when", NOON], "is not a latitude and a longitude"),
        (["clear", "--place", "14.4E,50.1N", "--when", NOON], "is not a latitude and a longitude"),
        (["clear", "--place", "Prague", "--when", NOON], "is not a latitude and a longitude"),
        (["overcast", "--place", PRAGUE, "--when", NOON], "--place and --when do not apply"),
        (["uniform", "--when", NOON], "--when does not apply"),
    ],
)
def test_what_is_unclear_or_unused_is_refused(words, problem):
    done = run("sky", *words, *LIGHT)
    assert (done.returncode, done.stdout) == (2, "")
    assert problem in done.stderr


def test_without_pvlib_the_extra_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "pvlib", None)
    done = run("sky", "clear", "--place", PRAGUE, "--when", NOON, *LIGHT)
    assert (done.returncode, done.stdout) == (2, "")
    assert "--place needs the package pvlib, which is missing" in done.stderr
    assert "pip install 'radcalc[solar]'" in done.stderr
    with pytest.raises(ConditionError, match="pvlib"):
        radcalc.sky("clear", place=PRAGUE, when=NOON, horizontal_illuminance="12 klx")
