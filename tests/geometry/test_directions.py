"""Directions, integrals over them, the expressions they take, and the commands of geometry."""

import math

import mpmath
import numpy as np
import pytest
from conftest import run
from hypothesis import given
from hypothesis import strategies as st

from radcalc.errors import ConditionError, RadcalcError
from radcalc.geometry import directions
from radcalc.geometry.numerics.cubature import over_directions
from radcalc.geometry.numerics.expression import FUNCTIONS, NAMES, Expression

PI = math.pi
ALL, UPPER, ROUND = (0.0, PI), (0.0, PI / 2), (0.0, 2 * PI)

# --- Directions.

DIRECTIONS = [
    ((1.0, 0.0, 0.0), (PI / 2, 0.0, 1.0)), ((0.0, 1.0, 0.0), (PI / 2, PI / 2, 1.0)),
    ((-2.0, 0.0, 0.0), (PI / 2, PI, 2.0)), ((-2.0, -0.0, 0.0), (PI / 2, PI, 2.0)),
    ((0.0, -3.0, 0.0), (PI / 2, 1.5 * PI, 3.0)), ((0.0, 0.0, 5.0), (0.0, 0.0, 5.0)),
    ((0.0, -0.0, -5.0), (PI, 0.0, 5.0)), ((-0.0, 0.0, 5.0), (0.0, 0.0, 5.0)),
    ((1.0, 1.0, math.sqrt(2)), (PI / 4, PI / 4, 2.0)), ((3.0, 4.0, 12.0), (math.atan2(5, 12),
     math.atan2(4, 3), 13.0)), ((1e-300, 0.0, 1.0), (1e-300, 0.0, 1.0)),
    ((1e300, 0.0, 1e300), (PI / 4, 0.0, math.sqrt(2) * 1e300)), ((1.0, -1e-20, 0.0),
     (PI / 2, 0.0, 1.0)),
]  # fmt: skip


@pytest.mark.parametrize(("vector", "angles"), DIRECTIONS)
def test_spherical_coordinates_by_their_definition(vector, angles):
    assert directions.spherical(*vector) == pytest.approx(angles, rel=1e-15)
    arrays = directions.spherical(*(np.array([x, x]) for x in vector))
    assert [float(x[1]) for x in arrays] == pytest.approx(angles, rel=1e-15)


@given(st.floats(1e-9, PI - 1e-9), st.floats(0, 6.28), st.floats(1e-100, 1e100))
def test_a_direction_and_back(polar, azimuth, length):
    unit = directions.cartesian(polar, azimuth)
    assert sum(x * x for x in unit) == pytest.approx(1, rel=1e-15 * 4)
    got = directions.spherical(*(x * length for x in unit))
    assert got[0] == pytest.approx(polar, rel=1e-14)
    assert got[1] == pytest.approx(azimuth, rel=1e-14, abs=1e-15)
    assert got[2] == pytest.approx(length, rel=1e-14)


@given(*[st.floats(-1e3, 1e3)] * 3)
def test_azimuths_are_within_one_turn(x, y, z):
    if x == y == z == 0:
        return
    polar, azimuth, _ = directions.spherical(x, y, z)
    assert 0 <= polar <= PI
    assert 0 <= azimuth < 2 * PI


# --- Integrals whose values are known: definition, or by hand.


def integrate(text, polar=ALL, azimuth=ROUND, accuracy=1e-9):
    return over_directions(Expression(text), polar, azimuth, accuracy)


KNOWN = [
    ("cos(theta)", UPPER, ROUND, PI),
    ("1", ALL, ROUND, 4 * PI),
    ("1", (0.3, 0.7), (1.0, 2.5), 1.5 * (math.cos(0.3) - math.cos(0.7))),
    ("x**2", ALL, ROUND, 4 * PI / 3),
    ("x^2*y^2", ALL, ROUND, 4 * PI / 15),
    ("x**2*y**2*z**2", ALL, ROUND, 4 * PI / 105),
    ("100*cos(theta)**10", (0.0, PI / 4), ROUND, 200 * PI / 11 * (1 - math.cos(PI / 4) ** 11)),
    ("cos(theta)**3", (0.0, 1.0), ROUND, PI / 2 * (1 - math.cos(1.0) ** 4)),
    ("(3*z**2 - 1)**2", ALL, ROUND, 16 * PI / 5),  # norms of spherical harmonics
    ("(x**2 - y**2)**2", ALL, ROUND, 16 * PI / 15),
    ("(5*z**3 - 3*z)**2", ALL, ROUND, 16 * PI / 7),
    ("exp(z)", ALL, ROUND, 4 * PI * math.sinh(1)),
    ("cos(theta)**1000000", UPPER, ROUND, 2 * PI / 1000001),
    ("phi", ALL, ROUND, 4 * PI**2),
    ("theta", ALL, ROUND, 2 * PI**2),
    ("1/sqrt(1.25 - z)", ALL, ROUND, 4 * PI * (1.5 - 0.5)),
    ("1/sin(theta)", ALL, ROUND, 2 * PI**2),  # a pole that the area takes away
    # kinks and edges
    ("abs(x)", ALL, ROUND, 2 * PI),
    ("max(x, 0)", ALL, ROUND, PI),
    ("max(z - 0.5, 0)", ALL, ROUND, PI / 4),
    ("max(x - 0.5, 0)", ALL, ROUND, PI / 4),
    ("abs(x - y)", ALL, ROUND, 2 * PI * math.sqrt(2)),
    ("sqrt(abs(z))", ALL, ROUND, 8 * PI / 3),
    ("sqrt(abs(y))", ALL, ROUND, 8 * PI / 3),
    ("abs(phi - 1)", ALL, ROUND, 1 + (2 * PI - 1) ** 2),
    ("max(z - 0.9, 0)**0.5", ALL, ROUND, 2 * PI * 0.1**1.5 / 1.5),
    ("atan(1000*z)**2", ALL, ROUND, None),
    ("exp(-(theta/0.01)**2)", ALL, ROUND, None),
    ("abs(theta - 1)", ALL, ROUND, None),
    ("(z - 0.3)/abs(z - 0.3)", ALL, ROUND, -1.2 * PI),  # steps
    ("(y - 0.3)/abs(y - 0.3)", ALL, ROUND, -1.2 * PI),
]  # fmt: skip
POLAR_ONLY = {
    "atan(1000*z)**2": (lambda t: mpmath.atan(1000 * mpmath.cos(t)) ** 2, [0, 1.5, 1.57, PI / 2]),
    "exp(-(theta/0.01)**2)": (
        lambda t: mpmath.exp(-((t / mpmath.mpf("0.01")) ** 2)),
        [0, 0.01, 0.1],
    ),
    "abs(theta - 1)": (lambda t: abs(t - 1), [0, 1, 2, PI]),
}
STEEP = ("abs", "max", "(z", "(y", "sqrt(abs")


@pytest.mark.parametrize(("text", "polar", "azimuth", "value"), KNOWN)
def test_known_integrals_are_within_their_bound(text, polar, azimuth, value):
    if value is None:
        function, cuts = POLAR_ONLY[text]
        value = mpmath.quad(lambda t: 2 * mpmath.pi * mpmath.sin(t) * function(t), cuts)
        value = float(value) * (2 if text.startswith("atan") else 1)  # even in z
    accuracy = 1e-4 if text.startswith(STEEP) else 1e-9
    got = integrate(text, polar, azimuth, accuracy)
    assert abs(got.value - value) <= got.error
    assert got.error <= accuracy * (abs(value) if value > 0 else 4 * PI) * (1 + 1e-3)


@pytest.mark.parametrize("text", ["x*y*(3*z**2 - 1)", "x*z", "y", "(3*z**2 - 1)*(5*z**3 - 3*z)"])
def test_spherical_harmonics_are_orthogonal(text):
    got = integrate(text)
    assert abs(got.value) <= got.error <= 1e-7


def test_a_needle_is_right_or_refused():
    # 2 pi times the integral of t exp(-1e9 t^2), less t^3/6 of the sine: pi/1e9 (1 - 1/6e9)
    value = PI / 1e9 * (1 - 1 / 6e9)
    try:
        got = integrate("exp(-1e9*theta**2)", UPPER)
    except ConditionError:
        return
    assert abs(got.value - value) <= got.error <= 1e-9 * value * 1.001


@pytest.mark.parametrize("accuracy", [1e-3, 1e-6, 1e-12])
def test_the_accuracy_is_kept(accuracy):
    got = integrate("exp(3*x)*z**2", accuracy=accuracy)
    # by parts: the mean of e^(3x) z^2 is (cosh 3 - sinh(3)/3)/9, z^2 sharing 1 - x^2 with y^2
    value = 4 * PI * (math.cosh(3) - math.sinh(3) / 3) / 9
    assert abs(got.value - value) <= got.error <= accuracy * value * 1.001


@pytest.mark.parametrize(
    "text",
    ["0", "0*x", "1/x", "1/z", "1/theta**2", "1/(x*x)", "1/0", "0/0*x", "log(0)", "log(z)",
     "sqrt(x)", "10**10**10", "1e999", "exp(1000)", "asin(2*z)", "1/(z - 0.3)", "z**0.5"],
)  # fmt: skip
def test_what_has_no_integral_is_refused(text):
    with pytest.raises(ConditionError) as caught:
        integrate(text)
    assert caught.value.hint


# --- The grammar.

HERE = {name: np.array([0.3, 0.6]) for name in NAMES}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2**3**2", 512), ("-2**2", -4), ("2^3", 8), ("1 − 3", -2), ("--1", 1), ("+1", 1),
        ("1e3", 1000), ("90*deg", PI / 2), ("e", math.e), ("log(e**2)", 2), ("log10(1e5)", 5),
        ("atan2(1, -1)", 0.75 * PI), ("min(1, 2) + max(1, 2)", 3), ("7/2", 3.5), ("(1+2)*3", 9),
        ("2**-1", 0.5), ("(-8)**2", 64), ("sin(pi/6)", 0.5), ("tanh(0)", 0), ("abs(-2.5)", 2.5),
    ],
)  # fmt: skip
def test_expressions_mean_what_they_do_on_paper(text, value):
    assert float(Expression(text)(HERE)) == pytest.approx(value, rel=1e-14)


NASTY = [
    "", "   ", "a", "pi2", "X", "sin", "cos", "__import__('os')", "open('x')", "eval(x)", "x.real",
    "x.__class__", "().__class__", "'text'", '"x"', "b'x'", "f'{x}'", "1j", "True", "None", "...",
    "x < y", "x == y", "x and y", "not x", "x if y else z", "lambda: 1", "lambda x: x", "[x]",
    "[x for x in y]", "(x, y)", "x,", "{x}", "{x: y}", "x[0]", "x := 1", "(x := 1)", "x = 1",
    "x; y",
    "x\ny", "import os", "yield x", "(yield)", "await x", "*x", "sin(*x)", "sin(x=1)", "sin(**x)",
    "sin()", "sin(x, y)", "atan2(x)", "max(x)", "sin(x)(y)", "x(y)", "2(x)", "2x", "x y", "x // 2",
    "x % 2", "x @ y", "x << 2", "x | y", "~x", "x ? y", "$x", "x\0", "\0", "\ud800", "(", ")", "(x",
    "x +", "1__0", "0x", "1e", "#", "\\", "x\\", "\x0c(", "x'", '"""', "print(x)",
    "(" * 90 + "x<1" + ")" * 90, "(" * 300 + "x" + ")" * 300, "-" * 401 + "x", "-" * 999 + "x",
    "x" + "+x" * 450, "(" * 199 + "x<1" + ")" * 199, "~" * 999 + "x", "not " * 240 + "x",
    "x" + ".a" * 490, "x" + "()" * 490, "x" + "[0]" * 330, "[" * 90 + "]" * 90,
    "lambda:" * 140 + "x", "x if x else " * 80 + "x", "x<" * 490 + "x", "x^" * 450 + "x",
    "1+" * 500 + "1", "x" * 1000, "x" * 1001, "x" * 1000000, "1" * 999, "(" * 1000000,
    "é", "µ", "x²",
]  # fmt: skip


@pytest.mark.parametrize("text", NASTY, ids=lambda text: ascii(text)[:24])
def test_nothing_but_arithmetic_is_read(text):
    with pytest.raises(RadcalcError) as caught:
        Expression(text)
    assert caught.value.hint
    assert len(caught.value.message) < 1000


def refused_or_numbers(text):
    try:
        function = Expression(text)
    except RadcalcError:
        return
    with np.errstate(all="ignore"):
        assert np.broadcast_to(function(HERE), (2,)).dtype == float


@given(st.text())
def test_no_text_breaks_the_reader(text):
    refused_or_numbers(text)


TOKENS = [*NAMES, *FUNCTIONS, "pi", "deg", "1", "2.5", "1e400", "0", "+", "-", "*", "/", "**", "^",
          "(", ")", "(", ")", ",", ".", " ", "<", "[", "]", "'", "lambda", ":", "if", "else", "not",
          "~", "%", "=", "_", "\n", "10**10**10"]  # fmt: skip


@given(st.lists(st.sampled_from(TOKENS), max_size=40).map("".join))
def test_no_jumble_of_tokens_breaks_the_reader(text):
    refused_or_numbers(text)


# --- Commands.


@pytest.mark.parametrize(
    ("words", "values"),
    [
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
        ("etendue --area 1cm2 --receiver-area 4cm2 --distance 1m --tilt 60deg -g etendue", [2e-8]),
        ("etendue --area 1mm2 --half-angle 30deg --radiance 1e6cd/m2 -g flux:lm", [PI / 4]),
        ("integrate cos(theta) --hemisphere -g integral", [PI]),
        ("integrate x**2 --sphere -g integral", [4 * PI / 3]),
        ("integrate 1 --half-angle 60deg -g integral:deg2", [PI * (180 / PI) ** 2]),
    ],
)  # fmt: skip
def test_commands_give_bare_numbers(words, values):
    done = run(*words.split())
    assert done.returncode == 0, done.stderr
    assert [float(x) for x in done.stdout.split()] == pytest.approx(values, rel=1e-11)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("solid-angle polygon 0,0,1 1,0,1 2,0,1", "no area"),
        ("solid-angle polygon 0,0,1 1,0,1 1,1,1.1 0,1,1", "not flat"),
        ("solid-angle polygon 0,0,1 1,0,1 1,0,1 0,1,1", "twice"),
        ("solid-angle polygon 0,0,1 1,0,1", "vertices"),
        ("solid-angle polygon 0,0 1,0,1 0,1,1", "2 coordinates"),
        ("solid-angle polygon 0,0,1,2 1,0,1 0,1,1", "4 coordinates"),
        ("solid-angle polygon nan,0,1 1,0,1 0,1,1", "nan"),
        ("solid-angle polygon 1,0,0 0,1,0 0,0,1 --normal 0,0,0", "normal"),
        ("solid-angle polygon 1,0,0 0,1,0 0,0,1 --viewpoint 1,0,0", "plane"),
        ("solid-angle sphere --radius 1m --distance 1m", "on or inside the sphere"),
        ("solid-angle disc --radius 1m --height 0m", "not possible"),
        ("solid-angle cone --half-angle nandeg", "nan"),
        ("solid-angle cone --half-angle 181deg", "not possible"),
        ("direction 1 1", "three coordinates"),
        ("direction 1 1 1 1", "three coordinates"),
        ("direction nan 0 1", "nan"),
        ("direction 0 0 0", "no direction"),
        ("etendue --area 1mm2 --na 1.5", "not possible"),
        ("etendue --area nanm2 --half-angle 10deg", "nan"),
        ("integrate x-x --sphere", "is 0"),
        ("integrate 1/(x-x) --sphere", "no value"),
        ("integrate x.real --sphere", "cannot stand"),
        ("integrate " + "x" + ".a" * 490 + " --sphere", "cannot stand"),
        ("integrate nan --sphere", "nan"),
    ],
)
def test_bad_input_ends_in_one_refusal(words, message):
    done = run(*words.split())
    assert done.returncode == 2
    assert done.stdout == ""
    assert message in done.stderr
    assert "Traceback" not in done.stderr
