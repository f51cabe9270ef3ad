"""Integrals over directions with known values."""

import math
import re

import mpmath
import pytest
from conftest import run
from helpers import for_each

from radcalc.errors import ConditionError
from radcalc.geometry.numerics.cubature import at_most, over_directions
from radcalc.geometry.numerics.expression import Expression

PI = math.pi
ALL, UPPER, ROUND = (0.0, PI), (0.0, PI / 2), (0.0, 2 * PI)


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
    ("1/sin(theta)", ALL, ROUND, 2 * PI**2),  # a pole that the area element cancels
    # kinks and edges
    ("abs(x)", ALL, ROUND, 2 * PI),
    ("max(x, 0)", ALL, ROUND, PI),
    ("max(z - 0.5, 0)", ALL, ROUND, PI / 4),
    ("max(x - 0.5, 0)", ALL, ROUND, PI / 4),
    ("abs(x - y)", ALL, ROUND, 2 * PI * math.sqrt(2)),
    ("sqrt(abs(z))", ALL, ROUND, 8 * PI / 3),
    ("sqrt(abs(y))", ALL, ROUND, 8 * PI / 3),
    ("abs(phi - 1*rad)", ALL, ROUND, 1 + (2 * PI - 1) ** 2),
    ("max(z - 0.9, 0)**0.5", ALL, ROUND, 2 * PI * 0.1**1.5 / 1.5),
    ("atan(1000*z)**2", ALL, ROUND, None),
    ("exp(-(theta/(0.01*rad))**2)", ALL, ROUND, None),
    ("abs(theta - 1*rad)", ALL, ROUND, None),
    ("(z - 0.3)/abs(z - 0.3)", ALL, ROUND, -1.2 * PI),  # steps
    ("(y - 0.3)/abs(y - 0.3)", ALL, ROUND, -1.2 * PI),
]  # fmt: skip
POLAR_ONLY = {
    "atan(1000*z)**2": (lambda t: mpmath.atan(1000 * mpmath.cos(t)) ** 2, [0, 1.5, 1.57, PI / 2]),
    "exp(-(theta/(0.01*rad))**2)": (
        lambda t: mpmath.exp(-((t / mpmath.mpf("0.01")) ** 2)),
        [0, 0.01, 0.1],
    ),
    "abs(theta - 1*rad)": (lambda t: abs(t - 1), [0, 1, 2, PI]),
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


@pytest.mark.parametrize("accuracy", [1e-4, 1e-7])
@pytest.mark.parametrize("tilt", [0.0, 1e-9, 1e-4, 0.001, 0.003, 0.005, 0.01, 0.02])
def test_a_kink_close_to_the_sides_of_cells_is_detected(tilt, accuracy):
    # pi times the length of (tilt, 0, 1): the integral of max(z, 0), rotated to that axis
    value = PI * math.hypot(tilt, 1)
    got = integrate(f"max({tilt}*x + z, 0)", accuracy=accuracy)
    assert abs(got.value - value) <= got.error + 1e-15


@for_each([i / 97 * PI for i in range(1, 97)])
def test_the_error_covers_a_kink_anywhere(at):
    # by parts: t sin(t) has the antiderivative sin(t) - t cos(t)
    value = 2 * PI * (PI - at - math.sin(at))
    got = integrate(f"max(theta - {at}*rad, 0)", accuracy=1e-3)
    assert abs(got.value - value) <= got.error


def test_a_costly_function_gets_fewer_cells():
    text = "+".join(f"tan({k}*phi)" for k in range(5, 84))  # poles all over the sphere
    costly = Expression(text)
    assert costly.cost > 79 * 10
    with pytest.raises(ConditionError, match="does not converge") as caught:
        over_directions(costly, ALL, ROUND, cost=100 * costly.cost)
    assert int(caught.value.message.split()[-2]) < 1000  # cells


@pytest.mark.parametrize("text", ["x*y*(3*z**2 - 1)", "x*z", "y", "(3*z**2 - 1)*(5*z**3 - 3*z)"])
def test_spherical_harmonics_are_orthogonal(text):
    got = integrate(text)
    assert abs(got.value) <= got.error <= 1e-7


# text, polar angles, integral: 2 pi (cos a - cos b) for a function that is 1 from a to b, else 0
STEPS = [
    ("(theta<30*deg)*100", ALL, 200 * PI * (1 - math.sqrt(0.75))),
    ("z > 0.5", ALL, PI),
    ("10*deg <= theta < 0.1*rad + 10*deg", ALL,
     2 * PI * (math.cos(PI / 18) - math.cos(PI / 18 + 0.1))),
    ("(theta > 1*rad)*(phi < 1*rad)*z", UPPER, math.cos(1) ** 2 / 2),
    ("(phi < 1*rad)*phi", ALL, 1.0),
    ("(1*rad < phi < 2*rad)*(abs(theta - PI/2) < 0.001*rad)*sin(phi)", ALL,
     2 * math.sin(0.001) * (math.cos(1) - math.cos(2))),
    ("x*x*(sin(8*phi) > 0)", ALL, 2 * PI / 3),
]  # fmt: skip


@pytest.mark.parametrize(("text", "polar", "value"), STEPS)
def test_a_step_at_one_angle_costs_no_accuracy(text, polar, value):
    step = Expression(text.replace("PI", "pi"))
    got = over_directions(
        step, polar, ROUND, 1e-12, step.cost, step.is_axial, steps=step.steps(polar, ROUND)
    )
    assert abs(got.value - value) <= got.error <= 1e-12 * abs(value)


@pytest.mark.parametrize("axis", ["0.6*x + 0.8*z", "0.6*y - 0.8*x", "0.28*x + 0.96*y"])
@pytest.mark.parametrize("cosine", [-0.3, 0.5, 0.98])
def test_the_error_covers_a_cap_about_any_axis(axis, cosine):
    got = integrate(f"{axis} > {cosine}", accuracy=0.01)
    assert abs(got.value - 2 * PI * (1 - cosine)) <= got.error


def test_a_narrow_peak_is_exact_or_refused():
    # 2 pi times the integral of (t - t^3/6) exp(-1e9 t^2): pi/1e9 (1 - 1/6e9)
    value = PI / 1e9 * (1 - 1 / 6e9)
    try:
        got = integrate("exp(-1e9*(theta/rad)**2)", UPPER)
    except ConditionError:
        return
    assert abs(got.value - value) <= got.error <= 1e-9 * value * 1.001


@pytest.mark.parametrize("accuracy", [1e-3, 1e-6, 1e-12])
def test_the_accuracy_is_reached(accuracy):
    got = integrate("exp(3*x)*z**2", accuracy=accuracy)
    # by parts: the mean of e^(3x) z^2 is (cosh 3 - sinh(3)/3)/9, with (1 - x^2)/2 as mean of z^2
    value = 4 * PI * (math.cosh(3) - math.sinh(3) / 3) / 9
    assert abs(got.value - value) <= got.error <= accuracy * value * 1.001


@pytest.mark.parametrize(
    "text",
    ["0", "0*x", "1/x", "1/theta**2", "1/0", "0/0*x", "ln(0)", "ln(z)",
     "sqrt(x)", "10**10**10", "1e999", "exp(1000)", "asin(2*z)", "z**0.5"],
)  # fmt: skip
def test_functions_without_an_integral_are_refused(text):
    with pytest.raises(ConditionError) as caught:
        integrate(text)
    assert caught.value.hint


def test_an_integral_of_a_trial_is_refused_after_few_cells():
    with at_most(600), pytest.raises(ConditionError) as caught:
        integrate("cos(theta)^1e9")  # a peak of 3e-5 rad
    assert int(re.findall(r"(\d+) cells", caught.value.message)[0]) < 1200
    refused = run("integrate", "cos(theta)^1e9")
    assert (refused.returncode, "try: --sphere, --hemisphere" in refused.stderr) == (2, True)
