"""The cinematographer's light at points: results, assumptions and errors."""

import math

import numpy as np
import pytest
from conftest import run
from helpers import Q, for_each, number

import radcalc
from radcalc.errors import RadcalcError


def asked(words: str) -> list[float]:
    done = run("uberlight", *words.split(), "-q", "--precision", "15")
    assert done.returncode == 0, done.stderr
    return [float(part) for part in done.stdout.split()]


@pytest.mark.parametrize("far", ["1m", "3m", "40cm"])
def test_without_settings_it_is_a_point_source(far):
    """E = I / d^2 (ISO 80000-7), for any fall-off distance."""
    words = f"1,2,2 --intensity 900cd --falloff-distance {far}"
    assert asked(f"{words} -g irradiance:lx -g intensity-toward:cd -g distance:m") == pytest.approx(
        [100, 900, 3]
    )


def test_the_receiver_is_turned_by_its_normal_or_by_the_incidence():
    # at (3, 0, 4) light comes along (3, 0, 4)/5: on a floor with the normal -z the cosine is 4/5
    words = "3,0,4 --intensity 1000cd -g irradiance:lx"
    assert asked(words) == pytest.approx([40])
    assert asked(f"{words} --normal 0,0,-2") == pytest.approx([32])
    assert asked(f"{words} --incidence 60deg") == pytest.approx([20])
    assert asked(f"{words} --normal 0,0,1") == [0]
    assert asked(f"{words} --normal -6,0,-2") == pytest.approx([40 * (18 + 8) / 5 / math.sqrt(40)])
    assert asked("3,0,4 --intensity 1cd --normal 0,0,1 -g incidence:deg") == pytest.approx(
        [math.degrees(math.acos(-0.8))]
    )


def test_the_attenuation_is_the_product_of_its_parts():
    # by hand, at (1, 0, 2): depth (2 - 1)/(3 - 1) = 1/2, a step of 1/2; x/z = 1/2 between 0.4 and
    # 0.8 on the axis, t = 1/4, 1 - (3/16 - 2/64); cos^2 = 4/5; (2/sqrt 5)^1
    words = (
        "1,0,2 --near 1m:3m --superellipse 0.4,0.4,0.8,0.8 --beam-exponent 2 --falloff 1 "
        "--falloff-distance 2m"
    )
    parts = [0.5, 1 - (3 / 16 - 2 / 64), 0.8, 2 / math.sqrt(5)]
    names = [f"{name}-attenuation" for name in ("depth", "superellipse", "beam", "falloff")]
    gets = " ".join(f"-g {name}" for name in (*names, "attenuation"))
    assert asked(f"{words} {gets}") == pytest.approx([*parts, math.prod(parts)], rel=1e-12)
    # E = I a / L^2
    found = asked(f"{words} --intensity 100cd -g irradiance:lx")
    assert found == pytest.approx([100 * math.prod(parts) / 4], rel=1e-12)


def test_the_intensity_follows_from_the_irradiance():
    assert asked("0,0,2 --illuminance 500lx --falloff 0 -g intensity:cd") == pytest.approx([500])
    assert asked("0,0,2 --illuminance 500lx -g intensity:cd") == pytest.approx([2000])


def test_an_omni_shines_backwards_and_is_clipped_by_the_distance():
    assert asked("0,0,-2 --omni --intensity 4cd -g irradiance:lx") == pytest.approx([1])
    assert asked("0,3,-4 --omni --near 4m:6m -g depth-attenuation") == pytest.approx([0.5])
    assert asked("0,0,-2 --intensity 4cd -g irradiance:lx") == [0]


def test_several_points_and_lists_make_a_row_each():
    words = "uberlight 0,0,1 0,0,2 --intensity 8cd --falloff 0,1,2 --format csv"
    done = run(*words.split())
    head, *lines = [line.split(",") for line in done.stdout.splitlines()]
    columns = [head.index(name) for name in ("z:m", "falloff:1", "illuminance:lx")]
    rows = [tuple(float(line[k]) for k in columns) for line in lines]
    assert rows == [(1, 0, 8), (1, 1, 8), (1, 2, 8), (2, 0, 8), (2, 1, 4), (2, 2, 2)]


def test_lengths_may_have_units():
    assert asked("0ft,0ft,2ft --intensity 1cd -g irradiance:fc") == pytest.approx([0.25])
    assert "metres" in run("uberlight", "0,0,1").stderr
    assert "metres" not in run("uberlight", "0m,0m,1m").stderr


def test_assumptions_are_stated():
    told = run("uberlight", *["0,0,1", "--superellipse", "1,1,1,1", "--intensity", "1cd"]).stderr
    for text in ("along +z", "fall-off of 2", "distance of 1 m", "roundness of 1", "I / L^2",
                 "faces the light"):  # fmt: skip
        assert text in told
    words = "0,0,1 --superellipse 1,1,1,1 --roundness 0 --falloff 2 --falloff-distance 3m"
    assert run("uberlight", *words.split()).stderr.count("assumed") == 2  # place and metres


def test_every_kind_of_light():
    # 683.002 lm/W at 555 nm (CIE 018:2019)
    found = asked("0,0,1 --intensity 683.002cd --wavelength 555nm -g irradiance:W/m2")
    assert found == pytest.approx([1], rel=1e-9)


@for_each([
    ("0,0,4", None),
    ("0,0,4 --maximum 3", None),
    ("0,0,1 --maximum 3", None),
    ("0,0,0.5", None),
    ("0,0,4 --beam-exponent 0", None),
    ("0,0,1.5 --falloff 1", "1.5 times the light of that law here, so light is created"),
    ("0,0,2 --falloff 0:1:0.001 -g attenuation", "light is created or lost"),
    ("0,0,4 --falloff 1", "--falloff 1 is not an inverse square law: it gives 4 times the light of "
     "that law here, so light is created"),
    ("0,0,4 --falloff 3", "0.25 times the light of that law here, so light is lost"),
    ("0,0,0.5 --maximum 3", "--maximum 3 is not an inverse square law"),
    ("0,0,0.5 --falloff 1 --maximum 3", "--falloff 1 and --maximum 3 are not an inverse square"),
    ("0,0,4 --near 1m:2m", "--near is not physical"),
    ("0,0,4 --far 1m:2m", "--far is not physical"),
    ("0,0,4 --far 1m:2m", "no light: the point is outside --far"),
    ("0,0,4 --beam-exponent 2", "--beam-exponent only shapes the directions"),
    ("0,0,4 --superellipse 1,1,1,1", "--superellipse only shapes the directions"),
    ("4,0,4 --superellipse 0.1,0.1,0.2,0.2", "no light: the point is outside --superellipse"),
    ("0,0,-4", "a spot has no light where z is 0 or less"),
    ("1.5,1.5,1 --superellipse 1,1,2,2 --roundness 0", "just above 0"),
    ("0,0,1 --intensity 1cd --normal 0,0,1", "does not reach the receiver"),
])  # fmt: skip
def test_unphysical_settings_and_dark_points_are_noted(words, noted):
    notes = [line for line in run("uberlight", *words.split()).stderr.splitlines()
             if line.startswith("note")]  # fmt: skip
    if noted is None:
        assert not notes
    else:
        assert any(noted in note for note in notes), notes


def test_a_fall_off_other_than_the_inverse_square_is_noted():
    told = run("uberlight", *["0,0,2", "--falloff", "1", "--falloff-distance", "2m"]).stderr
    assert "note: --falloff 1 is not an inverse square law\n" in told


def test_the_steps_have_each_attenuation_with_its_numbers():
    words = (
        "0.5,0,2 --intensity 100cd --near 1m:3m --far 4m:5m --superellipse 0.2,0.2,0.4,0.4 "
        "--beam-exponent 2 --falloff 1 --maximum 2 --falloff-distance 3m --steps"
    )
    told = run("uberlight", *words.split()).stderr
    for text in (
        "smoothstep(a, b, x) = t^2 (3 - 2 t)",
        "smoothstep(1 m, 3 m, 2 m) (1 - smoothstep(4 m, 5 m, 2 m)) = 0.5",
        "q = 0.8; A = 0.4, B = 0.4: r = 1.6; 1 - smoothstep(0.8, 1.6, 1) = 0.84375",
        "(z / 2.06155 m)^2 = 0.941176",
        "exp(s (2.06155 m / 3 m)^beta)",
        "Barzel",
        "a = a_z a_s a_b a_d",
        "E = I a cos(theta) Omega0 / L^2",
    ):
        assert text in told


def test_the_steps_of_a_corner_and_of_the_centre():
    told = run("uberlight", *["1,1,2", "--superellipse", "0.4,0.4,0.8,0.8", "--steps"]).stderr
    # q = a b / sqrt(2 (b/2)^2) = 0.4 sqrt(2), r = 0.8 sqrt(2)
    assert "q = 0.565685; A = 0.8, B = 0.8: r = 1.13137" in told
    told = run("uberlight", *["0,0,2", "--superellipse", "0.4,0.4,0.8,0.8", "--steps"]).stderr
    assert "u = 0, v = 0; a_s = 1" in told
    assert "a_z = 1 where z > 0, else 0" in told


@for_each(
    [
        ("", "a point is missing", "radcalc uberlight 0,0,4 --intensity 1000cd"),
        ("0,0,0", "the point is at the light", "another point"),
        ("0,0", "has 2 coordinates, not three", "1,0,2"),
        ("1,0,1m", "the unit of '1' is missing", "uberlight 1m,0m,1m"),
        ("0:2:1,0,1", "one number, not a range", "one point at a time"),
        ("0,0,1cd,", "has 4 coordinates", "1,0,2"),
        ("1cd,0cd,1cd", "a coordinate is a length", "without cd"),
        ("0,0,1 --near 2m:1m", "--near 2m:1m ends before it starts", "--near 1m:2m"),
        (
            "0,0,1 --near 2m",
            "is not an interval",
            "--near 1m:2m",
            ", from 1m to 2m, --near 1m:2m is an example",
        ),
        ("0,0,1 --near 1:2", "the unit of --near 1:2 is missing", "--near 1m:2m"),
        ("0,0,1 --near -1m:2m", "is out of range", "--near 1m:2m", " (--near: 0 or more)"),
        (
            "0,0,1 --near -3m:2m",
            "--near -3m is out of range",
            "--near 2m:3m",
            " (--near: 0 or more)",
        ),
        (
            "0,0,1 --falloff -1",
            "--falloff -1 is out of range",
            "--falloff 1",
            " (--falloff: 0 or more)",
        ),
        (
            "0,0,1 --maximum 0.5",
            "--maximum 0.5 is out of range",
            "1 or more",
        ),
        ("0,0,1 --falloff-distance 0m", "is out of range", "more than 0"),
        (
            "0,0,1 --superellipse 1,1,1,1 --roundness -1",
            "--roundness -1 is out of range",
            "--superellipse 1,1,1,1 --roundness 1",
            " (--roundness: from 0 to 1, or from 0% to 100%)",
        ),
        (
            "0,0,1 --superellipse 1,1,1,1 --roundness 2",
            "--roundness 2 is out of range",
            "from 0 to 1, or from 0% to 100%",
        ),
        ("0,0,1 --superellipse 2,1,1,3", "larger inside than outside", "--superellipse 1,1,2,3"),
        ("0,0,1 --superellipse 0,1,1,3", "has no area inside", "a and b above 0"),
        ("0,0,1 --superellipse 1,1", "has 2 numbers, not four", "--superellipse 0.4,0.3,0.5,0.4"),
        (
            "0,0,1 --roundness 1",
            "not apply without --superellipse",
            "--superellipse 0.4,0.3,0.5,0.4",
        ),
        ("0,0,1 --shear 1,1", "not apply without --superellipse", "--superellipse 0.4,0.3,0.5,0.4"),
        (
            "0,0,1 --omni --superellipse 1,1,1,1",
            "not apply to a light",
            "radcalc uberlight 0,0,1 --superellipse 1,1,1,1",
        ),
        (
            "0,0,1 --omni --beam-exponent 1",
            "not apply to a light",
            "radcalc uberlight 0,0,1 --beam-exponent 1",
        ),
        ("0,0,1 --normal 0,0,1", "--normal 0,0,1 needs further inputs", "--intensity 100cd"),
        ("0,0,1 --intensity 1cd --normal 0,0,0", "--normal '0,0,0' has no direction", "1,0,0.5"),
        (
            "0,0,1 --intensity 1cd --normal 0,0,1 --incidence 0deg",
            "both give",
            "0,0,1 --intensity 1cd --normal 0,0,1",
            "or:  radcalc uberlight 0,0,1 --intensity 1cd --incidence 0deg",
        ),
        (
            "0,0,1 --intensity 1cd --illuminance 2lx",
            "contradicts the other inputs, which give 1 lx",
            "",
        ),
        ("0,0,-1 --illuminance 2lx", "no light arrives", ""),
        ("0,0,1e90", "is too large or too small", "less extreme"),
        ("0,0,1 --falloff-distance 1e90m", "is too large or too small", "less extreme"),
        ("0,0,9 --falloff 999", "too large or too small for a number", "a smaller exponent"),
        ("0,0,1 -g irradiance", "the inputs do not give", "--intensity 100W/sr"),
    ],
)
def test_impossible_settings_are_refused_with_a_hint(words, message, hint, *further):
    done = run("uberlight", *words.split())
    assert done.returncode == 2
    told, tried, *lines = done.stderr.splitlines()
    assert message in told
    assert hint in tried
    if tried.startswith("try: radcalc"):
        assert tried.endswith(hint) or not hint
    for text in further:
        assert any(line.endswith(text) for line in lines)


def test_a_wrong_answer_is_judged():
    words = "uberlight 0,0,2 --intensity 1000cd --incidence 60deg --check 250lx"
    done = run(*words.split())
    assert done.returncode == 1
    assert "cosine" in done.stdout


def test_arrays_of_points_from_python():
    grid = np.stack(np.meshgrid([-1.0, 0.0, 2.0], [0.0, 1.0], [2.0], indexing="ij"), -1)
    light = radcalc.uberlight(grid, intensity="9cd", normal=(0, 0, -1))
    assert light["irradiance"].shape == (3, 2, 1)
    # E = I z / d^3 on a plane across the axis
    expected = 9 * grid[..., 2] / np.linalg.norm(grid, axis=-1) ** 3
    assert light["irradiance"].to("lx").magnitude == pytest.approx(expected, rel=1e-12)
    feet = radcalc.uberlight(Q([0.0, 0.0, 2.0], "ft"), intensity="1cd")
    assert number(feet, "distance", "ft") == pytest.approx(2)
    text = radcalc.uberlight("0m,0m,50cm", omni=True, falloff=2, maximum=4, near="1cm:2cm")
    # s = -ln 4, beta = 2/ln 4: 4 exp(-ln 4 2^(-2/ln 4))
    expected = 4 * math.exp(-math.log(4) * 0.5 ** (2 / math.log(4)))
    assert number(text, "attenuation", "1") == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("point", "more", "message"),
    [
        ([1, 2], {}, "three coordinates"),
        ("a,b,c", {}, "not a number"),
        ([["x", 0, 1]], {}, "takes real numbers"),
        ([0, 0, math.nan], {}, "out of range"),
        (Q([0, 0, 1], "s"), {}, "is a length"),
        ([[0, 0, 0], [0, 0, 1]], {}, "at the light"),
        ([0, 0, 1], {"superellipse": (1, 2, 3)}, "not four"),
        ([0, 0, 1], {"near": "2m:1m"}, 'near="2 m:1m" ends before'),
        ([[0, 0, 1], [0, 0, 2]], {"falloff": np.array([1.0, 2.0, 3.0])}, "do not fit together"),
    ],
)
def test_wrong_calls_from_python_have_messages(point, more, message):
    with pytest.raises(RadcalcError, match=message):
        radcalc.uberlight(point, **more)
