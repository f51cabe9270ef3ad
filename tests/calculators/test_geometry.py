"""Calculators of geometry: commands and their numbers."""

import math

import pytest
from conftest import run
from helpers import for_each

PI = math.pi


@for_each([
    ("solid-angle polygon 1,0,0 0,1,0 0,0,1 -g solid-angle:deg2", [5156.620156177]),  # /8
    ("solid-angle cone --half-angle 60deg -g solid-angle -g projected-solid-angle",
     [PI, 0.75 * PI]),
    ("solid-angle cone --solid-angle 2pisr -g half-angle:deg", [90]),
    ("solid-angle rectangle --width 2m --length 2m --height 1m -g solid-angle", [2 * PI / 3]),
    # the corner of a rectangle is a quarter of one twice as wide: arctan(2 2/sqrt(2 4 + 1))
    ("solid-angle rectangle --width 2m --length 2m --height 1m --corner -g solid-angle",
     [math.atan(4 / 3)]),
    ("solid-angle sphere --radius 1m --distance 2m -g projected-solid-angle", [PI / 4]),
    ("solid-angle disc --diameter 2m --height 100cm -g projected-solid-angle", [PI / 2]),
    ("solid-angle zone --polar 0deg:60deg --azimuth 0deg:90deg -g solid-angle", [PI / 4]),
    ("direction 3m 4m 0m -g length:cm -g azimuth:deg -g polar:deg",
     [500, math.degrees(math.atan2(4, 3)), 90]),
    ("direction --polar 60deg --azimuth 90deg -g y -g z", [math.sqrt(0.75), 0.5]),
    ("etendue --area 1mm2 --half-angle 90deg -g etendue", [PI * 1e-6]),
    ("etendue --area 1m2 --na 0.5 -g etendue", [PI / 4]),
    ("etendue --area 1m2 --na 0.5 -g half-angle:deg -g apex-angle:deg", [30, 60]),
    ("etendue --area 1m2 --f-number 1 -g half-angle:deg -g na", [30, 0.5]),
    ("etendue --area 1m2 --half-angle 30deg -g na", [0.5]),
    ("etendue --area 1cm2 --receiver-area 4cm2 --distance 1m --tilt 60deg -g etendue", [2e-8]),
    ("etendue --area 1mm2 --half-angle 30deg --radiance 1e6cd/m2 -g flux:lm", [PI / 4]),
    ("integrate cos(theta) --hemisphere -g integral", [PI]),
    ("integrate x**2 --sphere -g integral", [4 * PI / 3]),
    # pi L of a uniform sky on the ground; 4 pi I of a bulb; a mole has 6.02214076e23 photons
    ("integrate 3*cos(theta) --hemisphere --unit kcd/m2 -g integral", [3000 * PI]),
    ("integrate 3*cos(theta) --hemisphere --unit kcd/m2 -g integral:klx", [3 * PI]),
    ("integrate 2 --sphere --unit mW/sr -g integral:W", [8e-3 * PI]),
    ("integrate 2 --sphere --unit umol/s/sr -g integral:photon/s", [8e-6 * PI * 6.02214076e23]),
    ("integrate cos(theta)/pi --hemisphere --unit 1/sr -g integral", [1]),
    ("integrate 1/(4*pi) --sphere --unit W/sr/nm -g integral:W/um", [1000]),
    ("integrate 1 --half-angle 60deg -g integral:deg2", [PI * (180 / PI) ** 2]),
])  # fmt: skip
def test_commands_give_bare_numbers(words, values):
    done = run(*words.split())
    assert done.returncode == 0, done.stderr
    assert [float(x) for x in done.stdout.split()] == pytest.approx(values, rel=1e-11)


@pytest.mark.parametrize(
    ("words", "expected"),
    [  # SI Brochure: 1 sr cuts off an area of R^2; the whole sphere has 4 pi R^2
        ("--area 9m2 --radius 3m", 1),
        ("--area 9m2 --diameter 6m", 1),
        ("--area 1cm2 --radius 2m", 2.5e-5),
        (f"--area {2 * math.pi}m2 --radius 1m", 2 * math.pi),
        (f"--area {4 * math.pi}m2 --radius 1m", 4 * math.pi),
    ],
)
def test_the_solid_angle_of_a_part_of_a_sphere_is_its_area_over_the_radius_squared(words, expected):
    done = run("solid-angle", "patch", *words.split(), "-g", "solid-angle", "-q")
    assert float(done.stdout) == pytest.approx(expected, rel=1e-11)
