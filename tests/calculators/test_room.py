"""The lumen method."""

import pytest
from conftest import run
from helpers import number

import radcalc

FACTORY = "--width 60m --length 24m --flux 18klm --utilance 0.4 --maintenance 0.75"
CLASSROOM = "--width 6m --length 8m --height 2m --flux 3200lm --utilance 0.5 --maintenance 0.7"


@pytest.mark.parametrize(
    ("words", "asked", "expected"),
    [
        # studentnotes.co.uk/2360/lumen_method.php, example 1: 53.33, that is 54 lamps
        (f"{FACTORY} --illuminance 200lx", "luminaires", 53.33),
        (f"{FACTORY} --illuminance 200lx", "luminaires-to-install", 54),
        (f"{FACTORY} --illuminance 200lx", "installed-illuminance", 200 * 54 / (160 / 3)),
        # askfilo.com, a class room of 6 m x 8 m x 2.85 m with benches at 0.85 m, 400 lx: 18
        (f"{CLASSROOM} --illuminance 400lx", "luminaires-to-install", 18),
        ("--width 6m --length 8m --height 2m", "room-index", 48 / (2 * 14)),
        # plnmw.com, 4 m x 5 m under 8800 lm, utilization 0.4 and maintenance 0.8: 140.8 lx
        ("--width 4m --length 5m --flux 8800lm --luminaires 1 --utilance 0.4 --maintenance 0.8",
         "illuminance", 140.8),
        # askfilo.com, a lecture hall of 40 m x 20 m, 4 m above the work plane: about 3.3
        ("--width 20m --length 40m --height 4m", "room-index", 3.333),
        # by hand: k = w l / (h (w + l)) is 2 for 6 m by 12 m at 2 m
        ("--width 6m --length 12m --room-index 2", "height", 2),
        ("--width 6m --height 2m --room-index 2", "length", 12),
        ("--length 12m --height 2m --room-index 2", "width", 6),
        # 54 / (1.8 2) = 15 = 6 + 9, and 6 9 = 54; a square of 6 m at 2 m has k = 36 / (2 12) = 1.5
        ("--area 54m2 --room-index 1.8 --height 2m", "width", 6),
        ("--area 54m2 --room-index 1.8 --height 2m", "length", 9),
        ("--area 36m2 --room-index 1.5 --height 2m", "length", 6),
        # 500 lx on 54 m2 are 27 klm, 60 % of the flux of 12 luminaires of 3750 lm
        ("--area 54m2 --illuminance 500lx --luminaires 12 --utilance 60%", "flux:lm", 3750),
        ("--area 54m2 --illuminance 500lx --luminaires 12 --flux 3750lm", "utilance", 0.6),
        ("--area 54m2 --illuminance 400lx --luminaires 12 --flux 3750lm --utilance 0.6",
         "maintenance", 0.8),
        # 30 W at 120 lm/W are 3600 lm; 15.625 of them, times 0.6 and 0.8, are 500 lx on 54 m2
        ("--area 54m2 --illuminance 500lx --flux 30W --efficacy 120lm/W --utilance 0.6 "
         "--maintenance 0.8", "luminaires", 15.625),
        ("--width 6m --illuminance 500lx --luminaires 12 --utilance 0.6 --flux 3750lm",
         "length", 9),
        # photons in a plant factory, by the same method
        ("--area 10m2 --photon-irradiance 300umol/m2/s --photon-flux 400umol/s --utilance 0.75",
         "luminaires-to-install", 10),
    ],
)  # fmt: skip
def test_a_room_follows_from_any_sufficient_set(words, asked, expected):
    done = run("room", *words.split(), "-q", "-g", asked)
    assert float(done.stdout) == pytest.approx(expected, rel=2e-4)


def test_a_whole_number_is_not_rounded_up_for_its_last_digit():
    """0.1 + 0.2 is 0.30000000000000004 in floats, but 3.0000000000000004 luminaires are three."""
    words = "--area 0.1m2,0.3m2,0.7m2 --illuminance 3lx --flux 0.1lm --utilance 1"
    done = run("room", *words.split(), "-q", "-g", "luminaires-to-install")
    assert done.stdout.split() == ["3", "9", "21"]


def test_assumptions_are_stated():
    done = run("room", *FACTORY.replace("--maintenance 0.75", "--luminaires 54").split())
    assert "maintenance factor of 1" in done.stderr
    done = run("room", "--width", "6m", "--length", "8m", "--height", "2m")
    assert "above the working plane" in done.stderr


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("", "the inputs are missing"),
        ("--area 54m2 --luminaires 12.5 --flux 3klm --utilance 0.6", "not a whole number"),
        ("--area 54m2 --luminaires 12 --flux 3klm --utilance 60", "out of range"),
        ("--area 54m2 --luminaires 12 --flux 3klm --utilance 0", "out of range"),
        ("--area 54m2 --luminaires 12 --flux 3klm --maintenance 1.2", "out of range"),
        ("--area 54m2 --luminaires 12 --flux 3klm --illuminance 5klx", "a utilance of 7.5 follows"),
        ("--area 54m2 --luminaires 12 --flux 3klm --illuminance 900lx --utilance 0.9",
         "a maintenance factor of 1.5 follows"),
        ("--width 6m --length 9m --area 50m2 --height 2m", "contradicts the other inputs"),
        ("--width 6m --height 4m --room-index 1.5", "no room with that side"),
        # of all rooms of 54 m2 at 2 m a square one has the highest index, sqrt(54) / 4 = 1.84
        ("--area 54m2 --room-index 2 --height 2m", "a square room has less"),
        ("--area 54m2 --luminaires 12 --flux 3klm --illuminance 5klx",
         "another value of --flux or --illuminance"),
        ("--width 6m --length 9m --illuminance 500lx", "--illuminance 500lx needs further inputs"),
        ("--area 54m2 --illuminance 500lx --flux 30W --utilance 0.6", "efficacy that links them"),
    ],
)  # fmt: skip
def test_impossible_rooms_are_refused(words, message):
    done = run("room", *words.split())
    assert done.returncode == 2
    assert message in done.stderr


def test_arrays_of_rooms():
    areas = radcalc.Quantity([20.0, 40.0, 41.0], "m2")
    found = radcalc.room(area=areas, illuminance="500 lx", flux="5 klm", utilance=0.5)
    assert found["luminaires"].magnitude == pytest.approx([4, 8, 8.2])
    assert list(found["luminaires_to_install"].magnitude) == [4, 8, 9]
    assert number(radcalc.room(width="6 m", length="9 m", height="2 m"), "area", "m2") == 54
