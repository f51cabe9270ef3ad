"""Directions and mirrors: commands and their numbers."""

import math

import pytest
from conftest import run
from helpers import for_each

H = math.sqrt(0.5)
NAMES = "-g x -g y -g z"
BALL = "-g mirror-ball-u -g mirror-ball-v -g mirror-ball-w"


@for_each([
    # the normal (0.6, 0, 0.8) of the ball reflects the camera's direction, +z
    (f"--mirror-ball 0.6,0 {NAMES}", [0.96, 0, 0.28]),
    (f"--mirror-ball -0.6,0 {NAMES} {BALL}", [-0.96, 0, 0.28, -0.6, 0, 0.8]),
    (f"--mirror-ball 0,0 {NAMES}", [0, 0, 1]),
    (f"--mirror-ball 0,-0.8 {NAMES}", [0, -0.96, -0.28]),
    (f"--mirror-ball 0,-1 {NAMES} {BALL}", [0, 0, -1, 0, -1, 0]),
    # the reverse, for any form of the direction
    (f"0.96 0 0.28 {BALL}", [0.6, 0, 0.8]),
    (f"0 -9.6m -2.8m {BALL}", [0, -0.8, 0.6]),
    (f"--polar 90deg --azimuth 90deg {BALL}", [0, H, H]),
    (f"--elevation -90deg --azimuth 90deg {BALL}", [1, 0, 0]),
    (f"0 0 -2 {BALL}", [1, 0, 0]),
    (f"1e-9 0 -1 {BALL}", [1, 0, 5e-10]),
    # a flat mirror
    (f"0 0 1 --reflect-at 1,0,1 {NAMES} -g incidence", [1, 0, 0, 45]),
    (f"0,0,3 --reflect-at 2,2,2 {NAMES} -g length", [2 / 3, 2 / 3, -1 / 3, 3]),
    ("3m 4m 0m --reflect-at 1,0,0 -g azimuth -g length:cm -g incidence",
     [360 - math.degrees(math.atan(4 / 3)), 500, math.degrees(math.atan(4 / 3))]),
    (f"--polar 30deg --azimuth 0deg --reflect-at 0,0,1 {NAMES}", [-0.5, 0, math.sqrt(0.75)]),
    (f"--polar 90deg --azimuth 0deg --reflect-at 0,0,1 {NAMES}", [-1, 0, 0]),  # grazing
    (f"0 0 1 --reflect-to 1,0,0 {NAMES} -g incidence", [H, 0, H, 45]),
    (f"0 0 5m --reflect-to 0.96,0,0.28 {NAMES} -g length", [0.6, 0, 0.8, 1]),
    (f"--elevation 90deg --azimuth 0deg --reflect-to 0,0,7 {NAMES} -g incidence", [0, 0, 1, 0]),
    (f"0 0 1 --reflect-at 1,0,1 {BALL}", [H, 0, H]),  # of the reflection
])  # fmt: skip
def test_mirrors_by_hand(words, values):
    done = run("direction", *words.split())
    assert done.returncode == 0, done.stderr
    assert [float(x) for x in done.stdout.split()] == pytest.approx(values, rel=1e-11, abs=1e-15)


def test_a_list_of_directions_is_reflected_one_by_one():
    words = "direction --elevation 10deg:30deg:10deg --azimuth 0deg --reflect-at 0,0,1 -g azimuth"
    assert run(*words.split()).stdout.split() == ["180"] * 3


def test_the_position_on_a_ball_is_shown_on_request():
    assert "mirror-ball" not in run("direction", "1", "1", "1").stdout
    done = run("direction", "1", "1", "1", "--check", "mirror-ball-u=0.325")
    assert done.returncode == 0
    assert "a mirror ball seen along -z" in done.stderr + done.stdout


@pytest.mark.parametrize(
    ("words", "note"),
    [
        ("--mirror-ball 0.8,0.6", "the rim of the ball shows the direction behind it"),
        ("--mirror-ball 0,0", "at a pole the azimuth is arbitrary"),
    ],
)
def test_unusual_inputs_are_noted(words, note):
    assert note in run("direction", *words.split()).stderr


@pytest.mark.parametrize(
    ("words", "message", "hint"),
    [
        ("--mirror-ball 0.9,0.9", "is outside the ball, 1.27279 times its radius", "at most 1"),
        ("--mirror-ball 0.9", "has 1 number, not two", "--mirror-ball 0.6,0"),
        ("--mirror-ball 0.6m,0", "'0.6m' is not a number", "--mirror-ball 0.6,0"),
        ("1 0 0 --mirror-ball 0,0", "a vector cannot be used with --mirror-ball",
         ["1 0 0", "--mirror-ball 0,0"]),
        ("1 0 0 --mirror-ball -0.5,0", "a vector cannot be used with --mirror-ball",
         ["1 0 0", "--mirror-ball -0.5,0"]),
        ("1 0 0 --polar 3deg", "a vector cannot be used with angles",
         ["1 0 0"]),
        ("1 0 0 --polar 3deg --azimuth 4deg --reflect-at 1,0,0",
         "a vector cannot be used with angles",
         ["1 0 0 --reflect-at 1,0,0", "--polar 3deg --azimuth 4deg --reflect-at 1,0,0"]),
        ("--polar 3deg --mirror-ball 0,0", "-ball cannot be used with --polar",
         ["--mirror-ball 0,0"]),
        ("--mirror-ball 0,0 --reflect-at 1,0,0", "-ball cannot be used with --reflect-at",
         ["--mirror-ball 0,0"]),
        ("1 0 0 --reflect-to 1,0,0 --reflect-at 1,0,0", "cannot be used with --reflect-to",
         ["1 0 0 --reflect-at 1,0,0", "1 0 0 --reflect-to 1,0,0"]),
        ("--reflect-at 0,0,1", "a direction is missing", "direction 1 1 1 --reflect-at 0,0,1"),
        ("--polar 3deg --reflect-at 0,0,1", "the azimuth is missing", "--azimuth 30deg"),
        ("1 0 0 --reflect-at 0,0,0", "--reflect-at '0,0,0' has no direction", "1,0,0.5"),
        ("0 0 0 --reflect-at 0,0,1", "0,0,0 has no direction", "not zero"),
        ("0 0 0 --reflect-to 0,0,1", "0,0,0 has no direction", "not zero"),
        ("1 0 0 --reflect-to -2,0,0", "opposite directions", "another direction"),
        ("0 0 -1 --reflect-at 1,0,1", "the direction is behind the mirror, 135 deg from its normal",
         ["0 0 -1 --reflect-at -1,0,-1"]),
    ],
)  # fmt: skip
def test_impossible_reflections_are_refused(words, message, hint):
    done = run("direction", *words.split())
    assert (done.returncode, done.stdout) == (2, "")
    said, *told = done.stderr.splitlines()
    assert message in said
    if isinstance(hint, str):
        assert hint in told[0]
    else:
        calls = [line[5:].strip() for line in told if not line.startswith(" ")]
        assert calls == [f"radcalc direction {call}" for call in hint]


def test_the_hint_for_the_other_side_of_a_mirror_says_so():
    told = run("direction", "0", "0", "-1", "--reflect-at", "1,0,1").stderr.splitlines()[2]
    assert told.endswith(", for its other side")


def test_the_hint_for_the_other_side_of_a_mirror_is_right():
    done = run("direction", "0", "0", "-1", "--reflect-at", "-1,0,-1", "-g", "x", "-q")
    assert (done.returncode, done.stdout) == (0, "-1\n")
