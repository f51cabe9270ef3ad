"""Arithmetic with units, from definitions; `fuzz/expressions.py` compares it with Pint."""

import math
import random
from decimal import Decimal

import mpmath
import pytest
from helpers import for_each, shell

import radcalc
from radcalc.__main__ import run
from radcalc.conversion.operands import read_operands
from radcalc.conversion.plan import plan
from radcalc.errors import ExpressionError, RadcalcError
from radcalc.homework.question import read_claim
from radcalc.inputs.reading import read
from radcalc.units import values
from radcalc.units.amounts import split_value
from radcalc.units.compiled import CONSTANTS
from radcalc.units.ranges import read_series
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve

# text, number, unit: exact by the definitions of the units (foot 0.3048 m, inch 0.0254 m)
READ = {
    "500 lx * 20 m2 / (0.6*0.8)": (62500 / 3, "lx.m2"),
    "800 lm / 2 m2": (400.0, "lm/m2"),
    "800 lm per 2 m2": (400.0, "lm/m2"),
    "100 lx/2 m": (50.0, "lx/m"),
    "6 lx / 2 m2 * 3": (9.0, "lx/m2"),
    "1 m + 2 ft": (1.6096, "m"),
    "1 h + 30 min": (1.5, "h"),
    "5m*4m": (20.0, "m2"),
    "1m+1m": (2.0, "m"),
    "5m-2m": (3.0, "m"),
    "33m+7 cm": (33.07, "m"),
    "5 m -2 m": (3.0, "m"),
    "3 m * -2": (-6.0, "m"),
    "10^3 lx": (1000.0, "lx"),
    "10**3 lx": (1000.0, "lx"),
    "10³ lx": (1000.0, "lx"),
    "5x10^3 lx": (5000.0, "lx"),
    "5 x 10^-3 lx": (0.005, "lx"),
    "5×10³ lx": (5000.0, "lx"),
    "2·10⁻³ lx": (0.002, "lx"),
    "(-2)^2 m": (4.0, "m"),
    "2^-3 m": (0.125, "m"),
    "(10^10)^10 m": (1e100, "m"),
    "(2 m)^2": (4.0, "m2"),
    "40piW": (40 * math.pi, "W"),
    "2 pi rad": (2 * math.pi, "rad"),
    "4pi sr / pi": (4.0, "sr"),
    "180 deg / (pi rad)": (1.0, "1"),
    "800 lm/4pi sr": (800 / (4 * math.pi), "lm/sr"),
    "60deg/2": (30.0, "deg"),
    "(1+2)": (3.0, None),
    "(1+2) lx": (3.0, "lx"),
    "100 lx / 2 lx": (50.0, "1"),
    "1 m / 1 in": (1 / 0.0254, "1"),
    "500 lx * 80%": (400.0, "lx"),
    "50% + 30%": (80.0, "percent"),
    "0.1 m + 0.2 m": (0.3, "m"),  # floats give 0.30000000000000004
    "1/(500 nm)": (0.002, "nm-1"),
    "10 W / 5 cm-1": (2.0, "W/cm-1"),
    "0.5 cm-1 * 2 cm": (1.0, "1"),
    "500 W m-2 * 2 m2": (1000.0, "W"),
    "5 W * 3 m": (15.0, "(W.m)"),
    "5 W.m-2.sr-1 * 3": (15.0, "W/m2/sr"),
    "5m-2.5m": (2.5, "m"),
    "4 m^2/2": (2.0, "m2"),
    "4 m**2/2 m": (2.0, "m"),
    "4 m^(-2)/2": (2.0, "m-2"),
    "sqrt(4 m2)": (2.0, "m"),
    "sqrt(2) m": (math.sqrt(2), "m"),
    "500 lx * cos(60deg)": (250.0, "lx"),
    "sin(210deg)": (-0.5, None),
    "cos(0.1 rad)": (math.cos(0.1), None),
    "tan(45deg)": (1.0, None),
    "ln(10)": (math.log(10), None),
    "log10(1000)": (3.0, None),
    "exp(-1)": (math.exp(-1), None),
    "2 lx * (-5)": (-10.0, "lx"),
    "2*( - 5 lx)": (-10.0, "lx"),
    "(-5 lx)*(-5 lx)": (25.0, "lx2"),
    "3 lx / (-4)": (-0.75, "lx"),
    "(-2) lx": (-2.0, "lx"),
    "(50%)^2 * 1 lx": (0.25, "lx"),
    "(1+2)(3+4) lx": (21.0, "lx"),
    "4 pi (2 m)^2": (16 * math.pi, "m2"),
    "2 (3 lx)": (6.0, "lx"),
    "2(3 lx)": (6.0, "lx"),
    "500 lx cos(60deg)": (250.0, "lx"),
    "2 sqrt(4) lx": (4.0, "lx"),
    "4^0.5 lx": (2.0, "lx"),
    "2**-1.5": (2**-1.5, None),
    "-8^(1/3)": (-2.0, None),
    "(100 lx / 25 lx)^(1/2) * 1 m": (2.0, "m"),
    "log2(8)": (3.0, None),
    "log2(1/4) m": (-2.0, "m"),
    "(10 dBm) * 2": (20.0, "mW"),
    "(0 dBm) + (0 dBm)": (2.0, "mW"),
    "(20 dB) * 1 lx": (100.0, "lx"),
    "1 / (200 mired)": (1 / 5000, "K-1"),
    "2 * 3 foot lambert": (6.0, "foot_lambert"),
    "\u2212(1 lx + 2 lx)": (-3.0, "lx"),
}


@for_each(READ)
def test_an_expression_is_rounded_once(text):
    amount = read_amount(text)
    assert (amount.number, amount.unit.text if amount.unit else None) == READ[text]
    assert amount.text == text


# The exact values of CODATA 2022 and the SI Brochure (9th edition, tables 1 and 2), multiplied in
# decimals: e = 1.602176634e-19 C, h = 6.62607015e-34 J s, c = 299792458 m/s, k = 1.380649e-23 J/K,
# N_A = 6.02214076e23/mol.
H, C, K_B, E_CHARGE, N_A = map(
    Decimal, ("6.62607015e-34", "299792458", "1.380649e-23", "1.602176634e-19", "6.02214076e23")
)
NM500 = Decimal("500e-9")
CONSTANT = {
    ("h*c/(500 nm)", "eV"): H * C / NM500 / E_CHARGE,
    ("h c/(500 nm)", "J"): H * C / NM500,
    ("h*(600 THz)", "eV"): H * Decimal("6e14") / E_CHARGE,
    ("h*c/(500 nm)", "kJ/mol"): H * C / NM500 * N_A / 1000,
    ("N_A*h*c/(500 nm)", "kJ/mol"): H * C / NM500 * N_A / 1000,
    ("c/(500 nm)", "THz"): C / NM500 / Decimal("1e12"),
    ("c/(600 THz)", "nm"): C / Decimal("6e14") * Decimal("1e9"),
    ("(5 mW)/(h*c/(500 nm))", "umol/s"): Decimal("5e-3") * NM500 / H / C / N_A * 1_000_000,
    ("e*(500 nm)/(h*c)", "A/W"): E_CHARGE * NM500 / H / C,
    ("k_B * 300 K", "meV"): K_B * 300 / E_CHARGE * 1000,
    ("2 c_light", "km/s"): 2 * C / 1000,
    ("2*c", "km/s"): 2 * C / 1000,
    ("K_cd * (1 W)", "lm"): Decimal(683),
    ("h_planck/(2 pi)/hbar", "1"): Decimal(1),
    ("2 h c_light", "m"): 2 * 3600 * C,  # after a number a letter is a unit
    ("(10 + 6) h", "h"): Decimal(16),
    ("16 h", "min"): Decimal(960),
    ("(500 lx)*h", "lx s"): Decimal(500 * 3600),
    ("2*500 lx * h", "lx s"): Decimal(1000 * 3600),
    ("h*c/(500 nm) + 1 eV", "eV"): H * C / NM500 / E_CHARGE + 1,
    ("1 eV + h*c/(500 nm)", "eV"): H * C / NM500 / E_CHARGE + 1,
    ("e^2", "1"): Decimal(2).exp(),
    ("100 lx * e^(-1)", "lx"): 100 * Decimal(-1).exp(),
}
# CODATA 2022, as printed: Stefan-Boltzmann, Wien and the impedance of the vacuum.
PRINTED = {
    ("sigma*(1000 K)^4", "W/m2"): 5.670374419e4,
    ("b/(1000 K)", "um"): 2.897771955,
    ("(100 V/m)^2/Z0", "W/m2"): 1e4 / 376.730313412,
    ("g*(1 kg)*(1 m)", "J"): 9.80665,
}


@pytest.mark.parametrize(("text", "target"), CONSTANT)
def test_constants_have_the_values_of_the_si(text, target, capfd):
    assert run([text, "to", target, "-n", "-q"]) == 0
    assert float(capfd.readouterr().out) == pytest.approx(float(CONSTANT[text, target]), rel=6e-12)
    assert radcalc.convert(text, target).magnitude == pytest.approx(
        float(CONSTANT[text, target]), rel=2e-15
    )


@pytest.mark.parametrize(("text", "target"), PRINTED)
def test_derived_constants_have_the_printed_values(text, target):
    assert radcalc.convert(text, target).magnitude == pytest.approx(
        PRINTED[text, target], rel=5e-10
    )


@pytest.mark.parametrize("constant", CONSTANTS)
def test_every_constant_has_a_name_with_one_reading(constant):
    name = values.plain_spelling(constant)
    top, bottom, dimension = CONSTANTS[constant]
    amount = read_amount(f"3*{name}")
    assert amount.number * amount.unit.factor == pytest.approx(3 * top / bottom, rel=1e-15)
    assert amount.unit.dimension == values.quantity(dimension, {constant: 1})


def test_a_letter_with_two_meanings_is_said(capfd):
    assert run(["h*c/(500 nm)", "eV"]) == 0
    assert "note: h is read as h_planck\n" in capfd.readouterr().err
    assert run(["(500 lx)*h", "lx s"]) == 0
    assert "note: h is read as hour\n" in capfd.readouterr().err
    assert run(["c/(500 nm)", "THz"]) == 0
    assert "note: a cycle counts as 1 in a formula with c or h\n" in capfd.readouterr().err


def test_plancks_law_is_a_formula(capfd):
    """The spectral exitance of a black body of 5778 K at 500 nm, in Decimal."""
    x = H * C / NM500 / K_B / 5778
    exitance = 2 * Decimal(str(mpmath.pi)) * H * C**2 / NM500**5 / (x.exp() - 1)
    text = "2 pi h_planck c^2/((500 nm)^5 (exp(h_planck c/((500 nm) k (5778 K))) - 1))"
    assert radcalc.convert(text, "W/m2/nm").magnitude == pytest.approx(
        float(exitance / 10**9), rel=1e-13
    )


@for_each(range(60))
def test_real_powers_and_logarithms_are_accurate(seed):
    """Compare with mpmath at 60 digits."""
    chance = random.Random(seed)
    base = f"{chance.randint(1, 10**6)}e{chance.randint(-12, 6)}"
    power = f"{chance.choice(('', '-'))}{chance.randint(0, 3)}.{chance.randint(1, 999):03}"
    with mpmath.workdps(60):
        raised = mpmath.power(mpmath.mpf(base), mpmath.mpf(power))
        binary = mpmath.log(mpmath.mpf(base), 2)
    assert read_amount(f"{base}^{power}").number == pytest.approx(float(raised), rel=3e-16)
    assert read_amount(f"log2({base})").number == pytest.approx(float(binary), rel=3e-16)


# Interpretations offered by refusals, and their values.
OFFERED = {
    "100 lx * (1 + 10%)": (110.0, "lx"),
    "(1/2) m + (1/2) m": (1.0, "m"),
    "100 W / (5 W/m2)": (20.0, "m2"),
    "(100 W / 5 W) /m2": (20.0, "m-2"),
    "(5.10)^3 lx": (132.651, "lx"),
    "5*10^3 lx": (5000.0, "lx"),
    "(4*pi/2) sr": (2 * math.pi, "sr"),
    "(4/(2pi)) sr": (2 / math.pi, "sr"),
}


@pytest.mark.parametrize("text", ["2pi^2 lx", "2π² lx", "3 lx * 4pi^2"])
def test_a_power_after_a_multiple_of_pi_is_ambiguous(text):
    with pytest.raises(RadcalcError, match="ambiguous") as refused:
        read_amount(text)
    one, other = (read_amount(way).number for way in shell(refused.value)[1].split(" or "))
    factor, times = (4, 3) if "4" in text else (2, 1)
    ways = times * factor**2 * math.pi**2, times * factor * math.pi**2
    assert (one, other) == pytest.approx(ways)


RATIOS = {  # a gain of 1000 is 30 dB, a gain of 2 is one stop
    ("1 W / 1 mW", "dB"): 30.0,
    ("100 lx / 50 lx", "stops"): 1.0,
    ("100 lx / 50 lx", "%"): 200.0,
    ("(2 m)^0", "%"): 100.0,
    ("sqrt(9 m2) / 2 m", "1"): 1.5,
}


@pytest.mark.parametrize(("text", "target"), RATIOS)
def test_a_ratio_of_quantities_is_a_number_that_takes_no_unit(text, target, capfd):
    assert run([text, target, "-n", "-q"]) == 0
    assert float(capfd.readouterr().out) == RATIOS[text, target]
    assert run([text, "lx"]) == 2
    assert run([text, "lx", "fc"]) == 2
    assert run(["point-source", "--flux", text, "--distance", "2m"]) == 2


@pytest.mark.parametrize("text", OFFERED)
def test_an_interpretation_offered_by_a_refusal_is_read(text):
    amount = read_amount(text)
    assert (amount.number, amount.unit.text) == OFFERED[text]


# Plain values that contain an operator but are not expressions.
PLAIN = {
    "1/2 m": (0.5, "m"),
    "100/2 m": (50.0, "m"),
    "2*100 lx": (200.0, "lx"),
    "4pi sr": (4 * math.pi, "sr"),
    "5 W m-2": (5.0, "W m-2"),
    "3 picometre": (3.0, "picometre"),
    "5 m^+2": (5.0, "m^+2"),
    "5 m^-1 m": (5.0, "m^-1 m"),
    "5 m m-1": (5.0, "m m-1"),
    "5 m-1 m-1": (5.0, "m-1 m-1"),
    "5 nm-1 m": (5.0, "nm-1 m"),
}


@pytest.mark.parametrize("text", PLAIN)
def test_a_number_with_a_unit_is_not_an_expression(text):
    amount = read_amount(text)
    assert (amount.number, amount.unit.text, amount.rounding) == (*PLAIN[text], None)


REFUSED = {
    "100 lx + 5 lm": ("cannot add illuminance (lx) and luminous flux (lm)", "one quantity"),
    "100 lx - 5 lm": ("cannot subtract luminous flux (lm) from illuminance (lx)", "one quantity"),
    "100 lx + 3": ("illuminance (lx) and a bare number", "100 lx + 3 lx"),
    "30deg + 0.5": ("angle (deg) and a bare number", "30deg + 0.5 deg"),
    "500+200 lx": ("a bare number and illuminance (lx)", "(500 + 200) lx"),
    "5*3 - 2 lx": ("illuminance (lx) from a bare number", "(5*3 - 2) lx"),
    "100 lx + 10%": ("cannot add", "100 lx * (1 + 10%)"),
    "100 + 10%": ("ambiguous", "100 * (1 + 10%) or 100 + 0.1"),  # pocket calculators, algebra
    "0.8 - 5%": ("ambiguous", "0.8 * (1 - 5%) or 0.8 - 0.05"),
    # a correction keeps the rest of the text
    "3 lx + 3": ("cannot add", "3 lx + 3 lx"),
    "2*(500+200 lx)": ("cannot add", "2*((500 + 200) lx)"),
    "2 lx*(100 + 4 - 10%)": ("ambiguous", "2 lx*((100 + 4) * (1 - 10%)) or 2 lx*(100 + 4 - 0.1)"),
    "5 lx + 2*(-2^2) lx": ("ambiguous", "5 lx + 2*((-2)^2) lx or 5 lx + 2*(-(2^2)) lx"),
    "3*cos(60) + cos(60)": ("no angle in cos(60)", "3*cos(60rad) + cos(60)"),
    "2*abs(3) lx": ("unknown function 'abs'", "sqrt"),
    "3 lx * log(10)": ("unknown function 'log'", "3 lx * log10(10) or 3 lx * ln(10)"),
    "100 radlux + 5 lx": ("luminous exitance (radlux) and illuminance (lx)", "one quantity"),
    "1 W/m2/nm + 1 W/m3 * 1": ("cannot add", "one quantity"),
    "1/2 m + 1/2 m": ("ambiguous", "(1/2) m + 1/2 m or 1/(2 m) + 1/2 m"),
    "2 * pi / 3 rad": ("ambiguous", "(2 * pi/3) rad or 2 * pi/(3 rad)"),
    "100 W / 5 W/m2": ("ambiguous", "100 W / (5 W/m2) or (100 W / 5 W) /m2"),
    "800 lm / 4pi": ("ambiguous", "800 lm/(4pi) or 800 lm/4*pi"),
    "5.10^3 lx": ("ambiguous", "5*10^3 lx or (5.10)^3 lx"),
    "5m-1 m": ("'m-1 m' is ambiguous", "blanks around a minus, or m^-1"),
    "2 klx-1 klx": ("is ambiguous", "blanks around a minus, or klx^-1"),
    "1/50%": ("ambiguous", "(1/50) % or 1/(50%)"),
    "50%^2 * 1 lx": ("a power of percent", "(50%)^2"),
    "50%^2": ("a power of percent", "(50%)^2"),
    "4 m^1/2": ("'m^1/2' has an exponent that is not a whole number", "a whole number"),
    "4 m^2.5*2": ("has an exponent that is not a whole number", "a whole number"),
    "2^(-3 m": ("a bracket that is not closed", ")"),
    "-2^2 m": ("ambiguous", "(-2)^2 m or -(2^2) m"),
    "10**10**10": ("an exponent on an exponent", "(10**10)**10"),
    "9^9^9": ("an exponent on an exponent", "(9^9)^9"),
    "2^1000000": ("an exponent too large", "at most 1000"),
    "(9^999)^999": ("too many digits", "fewer"),
    "(4 m2)^0.5": ("area (m2) with an exponent that is not whole, (4 m2)^0.5", "sqrt(4 m2)"),
    "(-8)^(1/3) lx": ("no value for (-8)^(1/3)", "above 0"),
    "0^-0.5 lx": ("no value for 0^-0.5", "above 0"),
    "1e300^1.5 lx": ("too large", "1.8e308"),
    "2^(3 m) lx": ("an exponent at '(3 m) lx' that has a unit", "a bare number"),
    "800 lm / 4 (2 m)^2": ("ambiguous", "800 lm / (4 (2 m)^2) or (800 lm / 4) * (2 m)^2"),
    "1 J/2 c_light^2": ("ambiguous", "1 J / (2 c_light^2) or (1 J/2) * c_light^2"),
    "3*2 (3) lx": ("runs two values together at '(3) lx'", "*"),
    "3 lx * lg(10)": ("unknown function 'lg'", "3 lx * log10(10)"),
    "hc/(500 nm)": ("'hc' is not the name of a constant", "h*c/(500 nm)"),
    "h*c/(500 nm)": ("is ambiguous: h", "h_planck*c/(500 nm) or hour*c/(500 nm)"),
    "(500 lx)*h": ("is ambiguous: h", "(500 lx)*h_planck or (500 lx)*hour"),
    "e^2": ("is ambiguous: e", "e_charge^2 or exp(1)^2"),
    "(12 EV) * 2": ("EV, which is a scale of cd/m2 and of lx", "radcalc convert '12 EV' cd/m2"),
    "2 * (-3 mired)": ("not the reciprocal of a temperature", "more than 0"),
    "1 lx/(2-2)": ("divides by zero", "other than 0"),
    "0^-1 * 2": ("divides by zero", "other than 0"),
    "1e300 lx * 1e300 lx": ("too large", "1.8e308"),
    "1e-300 lx * 1e-300 lx": ("too small", "2.3e-308"),
    "2 * (3 lx": ("a bracket that is not closed", ")"),
    "(2 * 3)) lx": ("a closing bracket too many", "("),
    "(" * 17 + "1" + ")" * 17: ("too many brackets", "at most 16"),
    "2 * 3 zork": ("unknown unit 'zork'", "units"),
    "3 lx * 2 3": ("runs two values together at '3'", "*"),
    "5 m + -3 m": ("two signs in a row", "brackets"),
    "(100)±3 lx": ("has an uncertainty", "100±3 lx"),
    "5 lx +": ("a number is missing in '5 lx +'", "arithmetic"),
    "5 lx + lx": ("has no number at 'lx'", "1 lx"),
    "500 lx * cos(60)": ("no angle in cos(60)", "cos(60deg)"),
    "exp(-1000) m": ("too small at exp(-1000)", "2.3e-308"),
    "tan(90deg) m": ("no value for tan(90deg)", "another number"),
    "1/tan(-270deg)": ("no value for tan(-270deg)", "another number"),
    "sin(1e60 rad)": ("too few digits for sin(1e60 rad)", "another number"),
    "exp(1000)": ("no value for exp(1000)", "another number"),
    "sqrt(2 m)": ("no value for sqrt(2 m)", "a square"),
    "ln(2 m)": ("length (m) in ln(2 m)", "a bare number"),
    "10 dBm + 3 dBm": ("calculates with dBm", "radcalc convert 10 dBm mW"),
    "5 lx / dBm": ("calculates with dBm", "radcalc convert 1 dBm mW"),
    "(10+5) dBm": ("calculates with dBm", "15 dBm"),
    "-(10+5) dBm": ("calculates with dBm", "-15 dBm"),
    "10^2 EV": ("calculates with EV", "100 EV"),
}


@for_each(REFUSED)
def test_a_meaningless_or_ambiguous_expression_is_refused(text):
    with pytest.raises(RadcalcError) as caught:
        read_amount(text)
    message, hint = shell(caught.value)
    assert REFUSED[text][0] in message
    assert REFUSED[text][1] in hint


@pytest.mark.parametrize(
    "text", ["100 zork", "abc", "lx*2", "5 lx * (", "2 3 m", "1,5 lx", "5 W*m", "5 W/m2 sr"]
)
def test_a_text_without_arithmetic_has_the_error_of_a_number_or_a_unit(text):
    with pytest.raises(RadcalcError) as caught:
        read_amount(text)
    assert not isinstance(caught.value, ExpressionError)


@pytest.mark.parametrize(
    "text", ["((1" * 300, "2^" * 400 + "2", "9*" * 400 + "9", "1+" * 499 + "1"]
)
def test_a_long_text_is_refused_quickly(text):
    """The work grows in proportion to the length."""
    with pytest.raises(RadcalcError):
        read_amount(f"{text} lx")


def test_the_rounding_of_an_expression_follows_from_its_decimals():
    """0.005 relative to 2.50 and to 4.00, and 0.05 to 7.5; whole numbers are exact."""
    assert read("area", "5m*4m").rounding == pytest.approx(1e-9)
    assert read("area", "2.50m*4.00m").rounding == pytest.approx(0.005 / 2.5 + 0.005 / 4)
    assert read("distance", "2.50m + 7.5 m").rounding == pytest.approx((0.005 + 0.05) / 10)


def test_expressions_are_accepted_wherever_a_value_is():
    assert read("distance", "1 m + 2 ft").value == pytest.approx(1.6096)
    assert read("range", "300nm*2:1um - 300nm").value == (600.0, 700.0)
    assert [read("distance", one).value for one in read_series("1m+1m,3m")] == [2.0, 3.0]
    assert read_series("1m:1m+2m:2m/2") == ["1m", "2m", "3m"]
    assert split_value("(1+2) m") == (3.0, "m")
    claim = read_claim("illuminance=2 * 12.5 lx")
    assert (claim.value, claim.unit) == (25.0, "lx")
    assert claim.half_unit == pytest.approx(25 * 0.05 / 12.5)
    assert radcalc.convert("2*100 lx + 1 klx", "lx").magnitude == 1200.0
    assert radcalc.Quantity("500 lx * 20 m2").to("lm").magnitude == 10000.0


def outcome(words):
    """Return the reading of the words of a call, or the error message."""
    try:
        amount, target = read_operands(words)
    except RadcalcError as error:
        return type(error), shell(error)
    return amount.number, amount.unit.text, target


@pytest.mark.parametrize("unit", ["lx", "dBm", "EV", "m"])
@pytest.mark.parametrize(
    "number", ["500+200", "3-1", "(500+200)", "10^2", "2^3/4", "1e3-1", "-(2+3)", "sqrt(4)*3"]
)
def test_arithmetic_means_the_same_with_its_unit_in_one_word_or_two(number, unit):
    assert outcome([number, unit, "fc"]) == outcome([f"{number} {unit}", "fc"])


def test_a_reading_out_of_range_is_not_refused_as_arithmetic():
    with pytest.raises(RadcalcError, match="is out of range"):
        read_amount("756 mag")


def test_a_product_has_the_quantity_of_its_unit():
    amount = read_amount("500 lx * 20 m2 / 0.5")
    assert plan(amount.unit, resolve("klm")).apply(amount.number) == 20.0


# Each is 0 by an identity; floats give values such as 7e-17.
NOTHING = [
    "sin(45deg)^2 - 1/2",
    "sqrt(2)^2 - 2",
    "tan(60deg)^2 - 3",
    "sin(1 rad)^2 + cos(1 rad)^2 - 1",
    "ln(exp(1)) - 1",
    "sqrt(2)*sqrt(3) - sqrt(6)",
    "cos(-270deg)*1",
    "tan(7*180deg)",
]


@pytest.mark.parametrize("text", NOTHING)
def test_an_expression_that_is_0_by_an_identity_is_0(text):
    assert read_amount(text).number == 0


def a_function(chance):
    """Return the text and the value in mpmath of a function of a number near or far from 0 or 1."""
    digits = f"{chance.randint(1, 10 ** chance.randint(1, 12))}e{chance.randint(-40, 1)}"
    name = chance.choice(("sin", "cos", "tan", "exp", "ln", "log10", "sqrt"))
    x = mpmath.mpf(digits)
    if name in ("sin", "cos", "tan"):
        base, unit = chance.choice((0, 30, 45, 90, 180, 270, -360)), chance.choice(("deg", "rad"))
        angle = base * mpmath.pi / 180 + x * (mpmath.pi / 180 if unit == "deg" else 1)
        return f"{name}({base}deg + {digits}{unit})", getattr(mpmath, name)(angle)
    base = chance.choice((0, 1))
    return f"{name}({base} + {digits})", getattr(mpmath, name)(base + x)


@for_each(range(200))
def test_functions_are_accurate_after_cancellation(seed):
    """Compare with mpmath at 300 digits."""
    chance = random.Random(seed)
    with mpmath.workdps(300):
        text, true = a_function(chance)
        taken = chance.choice((0, 1, -1))
        true -= taken
        if abs(true) < 1e-250:  # a multiple of 90 degrees: a rounding error at 300 digits
            true = mpmath.mpf(0)
        text = f"({text} - ({taken}))*1"
        if not 2.3e-308 < abs(true) < 1.7e308 and true:  # beyond a float
            with pytest.raises(RadcalcError):
                read_amount(text)
            return
        found = read_amount(text).number
        assert abs(found - true) <= 2**-52 * abs(true), text


@for_each(range(-300, 301, 25))
def test_a_root_of_a_tiny_or_huge_number_has_all_its_digits(power):
    """Compare with mpmath at 50 digits."""
    with mpmath.workdps(50):
        true = float(mpmath.sqrt(mpmath.mpf(f"2e{power}")))
    amount = read_amount(f"sqrt(2e{power} m2)")
    assert amount.number == pytest.approx(true, rel=1e-15)
    assert amount.unit.text == "m"


UNITS = ("km", "lx", "W", "sr", "lm", "s")


@for_each(range(60))
def test_spellings_of_exponents_and_products_are_equivalent(seed):
    """m-2, m^-2, m**-2 and m⁻², joined by a dot, a star or a blank, with more arithmetic."""
    chance = random.Random(seed)
    powers = {name: chance.choice((-3, -2, -1, 2, 3)) for name in chance.sample(UNITS, 3)}
    raised = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
    found = set()
    for form in ("{}{}", "{}^{}", "{}**{}", "{}^({})"):
        for joint in (".", "·", " "):
            text = joint.join(form.format(name, power) for name, power in powers.items())
            found.add(read_amount(f"3*53 {text}*2").number)
    text = ".".join(f"{name}{str(power).translate(raised)}" for name, power in powers.items())
    found.add(read_amount(f"3 * 53 {text} * 2").number)
    assert found == {318.0}
