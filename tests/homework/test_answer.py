"""Reading of claims and tolerances."""

import math

import pytest
from helpers import for_each
from homework.questions import CONE, LUX, POINT, typed, verdict

from radcalc.homework.question import read_claim, read_tolerance
from radcalc.units.table import resolve


def test_typed_numbers_keep_their_digits():
    for number in (0.0012345, 0.12, 1.0, 12.34, 999.96, 1234.5, 1e4, 6.02e23, 3.3e-19):
        for digits in (2, 3, 4):
            said = read_claim(typed(number, digits))
            assert said.digits == digits, typed(number, digits)
            assert abs(said.value - number) <= said.half_unit * (1 + 1e-9)


@pytest.mark.parametrize(
    ("text", "digits", "half"),
    [
        ("25lx", 2, 0.5), ("25.0lx", 3, 0.05), ("0.0250lx", 3, 0.00005), ("2.50e3lx", 3, 5.0),
        ("2.5e-3", 2, 5e-5), ("100", 3, 0.5), ("007", 1, 0.5), ("0", 1, 0.5), ("-3.14", 3, 0.005),
        ("\u22123.14", 3, 0.005), ("E=1.5e+2lx", 2, 5.0), ("1E3", 1, 500.0),
    ],
)  # fmt: skip
def test_the_digits_of_a_claim(text, digits, half):
    said = read_claim(text)
    assert said.digits == digits
    assert said.half_unit == pytest.approx(half, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "widest"),
    [
        ("1000", 50.0), ("1200", 50.0), ("25450", 5.0), ("100", 5.0), ("10", 0.5), ("470lx", 5.0),
        ("100.", 0.5), ("1.20e3", 5.0), ("120.0", 0.05), ("3e5", 50000.0), ("0", 0.5),
    ],
)  # fmt: skip
def test_zeros_at_the_end_of_an_integer_may_not_be_significant(text, widest):
    """Except within the first two digits, and in numbers with a point or an exponent."""
    assert read_claim(text).widest == pytest.approx(widest, rel=1e-12)


def test_formulas_are_typed_exactly():
    assert read_claim("pi/6sr").digits == 15
    assert read_claim("2pi sr").value == pytest.approx(2 * math.pi)
    assert read_claim("1/3").half_unit < 1e-9


@for_each([
    (LUX, "111"), (LUX, "111nit"), (LUX, "value=111"), (LUX, "value = 111 cd/m2"),
    (LUX, "350/pi"), (LUX, "1.11e2"), (LUX, "32.5fL"), (LUX, "0.0111cd/cm2"), (POINT, "24.6lx"),
    (POINT, "illuminance=24.6"), (POINT, "irradiance=24.6lx"), (POINT, "2.28fc"),
    (POINT, "flux=1630"), (POINT, "1.63klm"), (CONE, "1933deg2"),
    ("direction 1 1 -1.4", "z=\u22120.7035"), ("direction 1 1 -1.4", "z=-0.7035"),
    ("ev --f-number 5.6 --time 1/60s", "ev=10.88"),
    ("photon 610nm", "2.033eV"), ("photon 610nm", "491THz"),
    ("integrate 1 --half-angle 25deg", "integral=0.589"), (CONE, "sphere-fraction=0.0468"),
    ("ev --f-number 5.6 --time 1/60s", "illuminance=4704lx"),
])  # fmt: skip
def test_name_and_unit_of_a_claim_are_optional_if_it_is_unambiguous(words, claim):
    assert verdict(words, claim).right


def test_tolerances_read():
    lux = resolve("lx")
    assert read_tolerance("1%", lux).kind == "relative"
    assert read_tolerance("0.01", lux).size == pytest.approx(0.01)
    assert read_tolerance("0.5lx", lux)[1:] == ("absolute", 0.5)
    assert read_tolerance("1fc", lux).size == pytest.approx(10.7639104)
    assert read_tolerance(" 3SF ", lux)[1:] == ("digits", 3)
    assert not read_tolerance("3sf", lux).holds(0.1, 0.0)
    assert read_tolerance("3sf", lux).holds(-1.004, -1.0)


@for_each([
    # 130 cd at 2 m: 32.5 lx exactly
    ("32.825lx", "1%", True), ("32.826lx", "1%", False), ("32.175lx", "1%", True),
    ("32.174lx", "1%", False), ("33lx", "0.02", True), ("33.2lx", "0.02", False),
    ("32.5lx", "0", True), ("32.500001lx", "0%", False), ("65lx", "100%", True),
    ("0lx", "100%", True), ("-1lx", "100%", False),
    ("33lx", "0.5lx", True), ("32lx", "0.5lx", True), ("33.01lx", "0.5lx", False),
    ("31.99lx", "0.5lx", False), ("33lx", "500mlx", True), ("33.1lx", "500mlx", False),
    ("33lx", "0.0005klx", True), ("32.6lx", "0.01fc", True), ("32.7lx", "0.01fc", False),
    ("3.02fc", "0.5lx", True), ("3.07fc", "0.5lx", False),
    ("33lx", "2sf", True), ("32lx", "2sf", True), ("33.1lx", "2sf", False),
    ("32.55lx", "3sf", True), ("32.56lx", "3sf", False), ("32.45lx", "3SF", True),
    ("32.44lx", "3sf", False), ("37lx", "1sf", True), ("37.6lx", "1sf", False),
    ("32.5lx", "15sf", True), ("32.5000001lx", "15sf", False), ("0.0325klx", "3sf", True),
])  # fmt: skip
def test_the_bounds_of_the_three_kinds_of_tolerance(claim, tolerance, is_right):
    words = "convert 130 cd lx --distance 2m"
    assert verdict(words, claim, tolerance).right is is_right
