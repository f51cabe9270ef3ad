"""What a receiver gets of its surroundings: expressions, skies and maps."""

import json
import math

import pytest
from conftest import run

LIT = 9424.77796076938  # lx: pi times 3000 cd/m2


def asked(*words: str) -> list[float]:
    """The numbers that a call prints."""
    done = run("environment", *words, "-q", "--precision", "15")
    assert not done.stderr, done.stderr
    return [float(number) for number in done.stdout.split()]


# -- expressions ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("source", "normal", "expected"),
    [
        ("3000 cd/m2", "0,0,1", LIT),
        ("3000 cd/m2", "1,2,-3", LIT),
        # the integral of cos^2 over the upper half is 2 pi/3
        ("3000*max(cos(theta), 0) cd/m2", "0,0,1", 2000 * math.pi),
        ("3000*max(cos(theta), 0) cd/m2", "0,0,-1", 0),
        # and over a quarter of the sphere that of cos(theta) x is 2/3
        ("3000*max(cos(theta), 0) cd/m2", "1,0,0", 2000),
        # a uniform upper half on a plane that is tilted by b: pi L (1 + cos b)/2
        ("3000*(theta < 90*deg) cd/m2", "1,0,1", LIT * (1 + math.sqrt(0.5)) / 2),
        # a disc of half angle a about the normal: pi L sin^2 a
        ("3*(theta < 30*deg) kcd/m2", "0,0,1", LIT / 4),
    ],
)
def test_an_expression_has_its_closed_form(source, normal, expected):
    (found,) = asked(source, "--normal", normal, "-g", "irradiance:lx")
    assert found == pytest.approx(expected, rel=1e-6, abs=1e-9)


def test_the_mean_is_by_solid_angle_and_the_peak_has_a_direction():
    source = "(x + 1)*100 cd/m2"
    found = asked(
        source,
        *["-g", "mean-radiance", "-g", "peak-radiance", "-g", "peak-polar", "-g", "peak-azimuth"],
    )
    assert found == pytest.approx([100, 200, 90, 0], abs=1e-6)
    assert asked(source, "--toward", "-1,0,0", "-g", "radiance-toward:cd/m2") == [0]
    assert asked(source, "--toward", "60deg:90deg:30deg", "-g", "radiance-toward") == (
        pytest.approx([100 + 100 * math.sin(math.pi / 3), 200])
    )


def test_a_kind_that_is_linked_is_shown_beside():
    words = ["1 W/m2/sr", "--wavelength", "555nm"]
    found = asked(*words, "-g", "illuminance:lx", "-g", "mean-luminance:cd/m2")
    assert found == pytest.approx([683 * math.pi, 683], rel=1e-5)  # V(555 nm) is 1 within 1e-5
    assert asked("683 cd/m2", "--efficacy", "683lm/W", "-g", "irradiance:W/m2") == (
        pytest.approx([math.pi])
    )


def test_what_is_relative_has_no_unit_of_light_and_says_so():
    done = run("environment", "1")
    assert "irradiance\t3.14159265359\tsr" in done.stdout
    assert "mean-radiance\t1\t1" in done.stdout
    assert "every result" in done.stderr
    rows = json.loads(run("environment", "1", "--json").stdout)["results"]
    assert rows[0]["quantity"] == "relative irradiance"
    assert {row["unit"] for row in rows} <= {"sr", "1", "deg"}


def test_a_number_is_checked():
    done = run("environment", "3000*max(cos(theta), 0) cd/m2", "--check", "illuminance=6283lx")
    assert done.returncode == 0
    assert done.stdout.startswith("right")


# -- skies ----------------------------------------------------------------------------------------


def test_a_sky_is_scaled_or_relative_to_its_zenith():
    """Of (1 + 2 cos Z)/3: 7 pi/9 on the ground, and 0.39618 of it on a wall (CIE S 003)."""
    scaled = asked("sky:overcast", "--zenith-luminance", "9000cd/m2", "-g", "irradiance:lx")
    assert scaled == pytest.approx([7000 * math.pi])
    assert asked("sky:overcast", "-g", "irradiance:sr") == pytest.approx([7 * math.pi / 9])
    words = ["sky:overcast", "--horizontal-illuminance", "10klx"]
    (wall,) = asked(*words, "--normal", "1,0,0", "-g", "irradiance:lx")
    assert wall == pytest.approx(3961.8, rel=1e-5)
    assert asked(*words, "--toward", "0deg", "-g", "radiance-toward:cd/m2") == (
        pytest.approx([90000 / 7 / math.pi])
    )


def test_a_sky_is_at_the_suns_azimuth():
    words = ["sky:clear", "--sun-elevation", "40deg", "--sun-azimuth", "70deg"]
    assert asked(*words, "-g", "peak-polar", "-g", "peak-azimuth") == pytest.approx([50, 70])
