"""The grammar of expressions: only arithmetic."""

import math

import numpy as np
import pytest
from helpers import for_each
from hypothesis import given
from hypothesis import strategies as st

from radcalc.errors import RadcalcError
from radcalc.geometry.numerics.expression import FUNCTIONS, NAMES, Expression

PI = math.pi

HERE = {name: np.array([0.3, 0.6]) for name in NAMES}


@for_each([
    ("2**3**2", 512), ("-2**2", -4), ("2^3", 8), ("1 − 3", -2), ("--1", 1), ("+1", 1),
    ("1e3", 1000), ("90*deg", PI / 2), ("e", math.e), ("ln(e**2)", 2), ("log10(1e5)", 5),
    ("log2(8)", 3), ("cos(60 deg)", 0.5), ("sin(90deg)", 1),
    ("atan2(1, -1)", 0.75 * PI), ("min(1, 2) + max(1, 2)", 3), ("7/2", 3.5), ("(1+2)*3", 9),
    ("2 < 3", 1), ("3<2", 0), ("2<2", 0), ("2<=2", 1), ("2>2", 0), ("2 >= 2", 1), ("1≤1", 1),
    ("1⩾2", 0), ("(2<3)*100", 100), ("2<3*100", 1), ("-(1<2)", -1), ("(1<2)-(1<2)", 0),
    ("(1<2)+(2<3)", 2), ("1<2<3", 1), ("1<3<2", 0), ("3>2>=2>1", 1), ("1<1/0", 1),
    ("(1<2)<1", 0), ("abs(x-0.6) < 0.1", 0), ("theta<30*deg", 1),
    ("(" * 99 + "x<1" + ")" * 99, 1),
    ("2**-1", 0.5), ("(-8)**2", 64), ("sin(pi/6)", 0.5), ("tanh(0)", 0), ("abs(-2.5)", 2.5),
])  # fmt: skip
def test_the_values_of_expressions(text, value):
    with np.errstate(divide="ignore"):
        found = np.broadcast_to(Expression(text)(HERE), (2,))
    assert found[0] == pytest.approx(value, rel=1e-14)


def test_a_comparison_with_nan_is_nan():
    with np.errstate(invalid="ignore"):
        assert np.isnan(float(Expression("sqrt(-1) < 2")({})))


@pytest.mark.parametrize(("text", "hint"), [
    ("theta == 1", "(theta<30*deg)*100"), ("x < 1 and y < 0", "(x<1)*(y<0)"),
])  # fmt: skip
def test_a_forbidden_comparison_hints_at_an_allowed_one(text, hint):
    with pytest.raises(RadcalcError) as caught:
        Expression(text)
    assert hint in caught.value.hint


@for_each([
    ("cos(45)", "cos(45*deg) or cos(45*rad)"), ("tan(-x)", "tan((-x)*deg) or tan((-x)*rad)"),
    ("sin(theta*phi)", "sin((theta*phi)/deg) or sin((theta*phi)/rad)"),
    ("exp(-theta)", "(-theta)/deg or (-theta)/rad"), ("2**theta", "theta/deg or theta/rad"),
    ("theta - 30", "30*deg or 30*rad"), ("min(1 < x, acos(z))", "(1 < x)*deg or (1 < x)*rad"),
    ("acos(z) > 60", "60*deg or 60*rad"), ("1 - theta**2", "1*deg**2 or 1*rad**2"),
    ("atan2(theta, 1)", "1*deg or 1*rad"), ("ln(sqrt(phi))", "sqrt(phi)/deg**0.5 or "),
])  # fmt: skip
def test_an_angle_without_a_unit_is_refused(text, ways):
    for whole in (text, f"0*({text}) + x"):
        with pytest.raises(RadcalcError) as caught:
            Expression(whole)
        assert caught.value.message.startswith(f"'{whole}' has ")
        assert ways in caught.value.hint


@for_each([
    ("cos(0.5*rad)", math.cos(0.5)), ("cos(60*deg)", 0.5), ("cos(pi/3)", 0.5), ("cos(0)", 1),
    ("sin(theta)/theta", math.sin(0.3) / 0.3), ("sin(2*(theta - 10*deg))", math.sin(0.6 - PI / 9)),
    ("max(theta, 0) < pi/2", 1), ("acos(z) < atan2(y, x)", 0), ("theta*180/pi < 30", 1),
    ("exp(-(theta/(10*deg))**2)", math.exp(-((0.3 * 18 / PI) ** 2))), ("theta < phi", 0),
    ("sqrt(theta**2 + phi**2) < 1*rad", 1), ("1 - theta/rad", 0.7), ("x**-y + pi", 0.3**-0.3 + PI),
])  # fmt: skip
def test_angles_with_units(text, value):
    assert float(Expression(text)(dict.fromkeys(NAMES, 0.3))) == pytest.approx(value, rel=1e-14)


NASTY = [
    "", "   ", "a", "pi2", "X", "sin", "cos", "__import__('os')", "open('x')", "eval(x)", "x.real",
    "x.__class__", "().__class__", "'text'", '"x"', "b'x'", "f'{x}'", "1j", "True", "None", "...",
    "x == y", "x != y", "x = y", "x =< y", "x => y", "x <> y", "x << y", "x <", "< x",
    "x < y == z", "x is y", "x in y", "x < y and y < z", "x or y", "x and y",
    "not x", "x if y else z", "lambda: 1", "lambda x: x", "[x]",
    "[x for x in y]", "(x, y)", "x,", "{x}", "{x: y}", "x[0]", "x := 1", "(x := 1)", "x = 1",
    "x; y",
    "x\ny", "import os", "yield x", "(yield)", "await x", "*x", "sin(*x)", "sin(x=1)", "sin(**x)",
    "sin()", "sin(x, y)", "atan2(x)", "max(x)", "sin(x)(y)", "x(y)", "2(x)", "2x", "x y", "x // 2",
    "x % 2", "x @ y", "x << 2", "x | y", "~x", "x ? y", "$x", "x\0", "\0", "\ud800", "(", ")", "(x",
    "x +", "1__0", "0x", "1e", "#", "\\", "x\\", "\x0c(", "x'", '"""', "print(x)",
    "(" * 300 + "x" + ")" * 300, "-" * 401 + "x", "-" * 999 + "x",
    "x" + "+x" * 450, "~" * 999 + "x", "not " * 240 + "x",
    "x" + ".a" * 490, "x" + "()" * 490, "x" + "[0]" * 330, "[" * 90 + "]" * 90,
    "lambda:" * 140 + "x", "x if x else " * 80 + "x", "x<" * 500 + "x", "x^" * 450 + "x",
    "1+" * 500 + "1", "x" * 1000, "x" * 1001, "x" * 1000000, "1" * 999, "(" * 1000000,
    "é", "µ", "x²",
]  # fmt: skip


@for_each(NASTY)
def test_only_arithmetic_is_read(text):
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


TOKENS = [*NAMES, *FUNCTIONS, "pi", "deg", "rad", "1", "2.5", "1e400", "0", "+", "-", "*",
          "/", "**", "^", "(", ")", "(", ")", ",", ".", " ", "<", ">=",
          "[", "]", "'", "lambda", ":", "if", "else", "not",
          "~", "%", "=", "_", "\n", "10**10**10"]  # fmt: skip


@given(st.lists(st.sampled_from(TOKENS), max_size=40).map("".join))
def test_no_jumble_of_tokens_breaks_the_reader(text):
    refused_or_numbers(text)


def test_the_cost_counts_functions_and_powers():
    assert Expression("1").cost == 1
    assert Expression("x + y").cost < Expression("tan(x*rad)").cost < Expression("x**y").cost
    assert Expression("+".join(["tan(x*rad)"] * 79)).cost == pytest.approx(79 * 12, abs=1)


def test_the_sign_of_an_uncertainty_is_refused():
    with pytest.raises(RadcalcError, match="takes no uncertainties"):
        Expression("cos(theta)*(1+-0.1)")
    assert Expression("cos(theta) + -0.1")({"theta": 0.0}) == 0.9
