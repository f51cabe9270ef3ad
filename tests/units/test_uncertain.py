"""Values with a standard uncertainty, in common notations."""

import math

import pytest
from uncertainties import ufloat_fromstr

from radcalc.conversion.operands import read_operands
from radcalc.errors import RadcalcError
from radcalc.units.reading import read_amount


@pytest.mark.parametrize(
    "text",
    [
        "100.02147(35) g",
        "100.02147(0.00035) g",
        "(100.02147 ± 0.00035) g",
        "(100.02147+-0.00035) g",
        "100.02147 ± 0.00035 g",
        "100.02147+/-0.00035 g",
        "100.02147 g ± 0.35 mg",
        "(100.02147 g ± 0.35 mg)",
        "(1.0002147±0.0000035)e2 g",
        "1.0002147(35)e2g",
        "0.10002147(35) kg",
    ],
)
def test_the_notations_of_the_guide_give_the_same_mass(text):
    """JCGM 100:2008, 7.2.2: a mass standard of 100.02147 g with an uncertainty of 0.35 mg."""
    amount = read_amount(text)
    assert amount.number * float(amount.unit.factor) == pytest.approx(0.10002147, rel=1e-15)
    assert amount.uncertainty * float(amount.unit.factor) == pytest.approx(0.35e-6, rel=1e-12)


@pytest.mark.parametrize(
    "number",
    [
        "3.14+/-0.01",
        "3.14(1)",
        "-3.14(1)",
        "100(3)",
        "100(3.0)",
        "3.14(0.15)",
        "0.5(1)",
        "1234(56)",
    ],
)
def test_bare_numbers_are_read_as_by_the_uncertainties_package(number):
    """Compare with its `ufloat_fromstr`, which reads the same notation."""
    other = ufloat_fromstr(number)
    amount = read_amount(number)
    assert (amount.number, amount.unit) == (other.nominal_value, None)
    assert amount.uncertainty == pytest.approx(other.std_dev, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "number", "uncertainty"),
    [
        ("100 lx ± 3%", 100, 3),
        ("100 ± 3% lx", 100, 3),
        ("-5±10% mW", -5, 0.5),
        ("(80±2)%", 80, 2),
        ("80(2)%", 80, 2),
        ("100+-0 lx", 100, 0),
        ("4pi±0.1 sr", 4 * math.pi, 0.1),
        ("100+-3 lx", 100, 3),  # not 97
    ],
)
def test_percents_and_fractions(text, number, uncertainty):
    amount = read_amount(text)
    assert (amount.number, amount.uncertainty) == (number, pytest.approx(uncertainty, rel=1e-15))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("100±3%", "(100±3)% or 100±3"),
        ("80%±2%", "(80±2)% or (80±1.6)%"),
        ("100 lx ± 3", "100±3 lx"),
        ("1 m ± 2 s", "different quantities"),
        ("100+--3 lx", "negative uncertainty"),
        ("1,5±0.1 lx", "comma"),
        ("100±3 foo", "unknown unit"),
        ("±3 lx", "a number is missing"),
        ("100±nan lx", "not a finite number"),
        ("1±1e999 lx", "too large"),
        ("100(3", "'100(3' is not a number"),
        ("100(3)(2) lx", "two values together"),
        ("100 lx(3)", "unit"),
        ("100±3±1 lx", ""),
    ],
)
def test_a_meaningless_or_ambiguous_value_is_refused(text, said):
    with pytest.raises(RadcalcError) as refused:
        read_amount(text)
    assert said in str(refused.value)


@pytest.mark.parametrize(
    "words",
    [
        "100+-3 lx fc",
        "100 ± 3 lx fc",
        "100 +-3 lx to fc",
        "100 lx ± 3 lx fc",
        "100 lx ± 3% fc",
        "100lx ± 3 % fc",
        "100±3% lx fc",
        "(100 ± 3) lx fc",
        "100(3) lx to fc",
    ],
)
def test_uncertain_values_need_no_quotes(words):
    amount, target = read_operands(words.split())
    assert (amount.number, amount.uncertainty, amount.unit.text) == (100, 3, "lx")
    assert target == "fc"


@pytest.mark.parametrize(
    ("words", "number", "uncertainty", "unit", "target"),
    [
        (("(10±1)%", "1"), 10, 1, "%", "1"),
        (("(10±1) %", "percent"), 10, 1, "%", "percent"),
        (("( 10 ± 1 )%", "dB"), 10, 1, "%", "dB"),
        (("10(1)%", "1"), 10, 1, "%", "1"),
        (("50", "±", "5", "%", "1"), 50, 5, "%", "1"),
        (("50±5%", "percent", "1"), 50, 2.5, "percent", "1"),
        (("50±5%", "lx", "fc"), 50, 2.5, "lx", "fc"),
        (("50±5%", "lx"), 50, 2.5, "lx", ""),
    ],
)
def test_a_ratio_after_percents_is_the_target(words, number, uncertainty, unit, target):
    amount, found = read_operands([*words])
    assert (amount.number, amount.uncertainty, amount.unit.text) == (number, uncertainty, unit)
    assert found == target


@pytest.mark.parametrize("words", ["50±5 %/1", "50±5%/percent", "50±5%/dB", "50 ±5%/OD"])
def test_a_percentage_or_a_fraction_before_a_ratio_is_refused(words):
    with pytest.raises(RadcalcError, match="ambiguous") as refused:
        read_operands(words.split("/"))
    assert refused.value.hint == "(50±5)% or 50±2.5"


@pytest.mark.parametrize("text", ["10±5% dBm", "10 dBm ± 5%", "0.30±5% OD"])
def test_the_uncertainty_of_a_reading_on_a_scale_is_not_relative(text):
    with pytest.raises(RadcalcError, match="a percentage of a reading"):
        read_amount(text)


def test_a_target_is_not_taken_for_the_unit_of_the_uncertainty():
    with pytest.raises(RadcalcError, match="unit of the uncertainty"):
        read_operands(["100", "lx", "±", "3", "fc"])


FOOT = 0.3048


# By JCGM 100:2008, 5.1.2: relative uncertainties of factors and absolute ones of terms add in
# quadrature.
@pytest.mark.parametrize(
    ("text", "number", "uncertainty"),
    [
        ("(100+-3) lx * (2.0+-0.1) m2", 200, 200 * math.hypot(0.03, 0.05)),
        ("(100±3) lx / (2.0±0.1)", 50, 50 * math.hypot(0.03, 0.05)),
        ("2 * 100(3) lx", 200, 6),
        ("2*(3±1) lx", 6, 2),
        ("(2.0±0.1)^2 m2", 4, 0.4),
        ("sqrt(4.0±0.1)", 2, 0.1 / 4),
        ("1 m + (2.0+-0.1) ft", 1 + 2 * 0.3048, 0.1 * 0.3048),
        ("(5±0.3) - (3±0.4)", 2, 0.5),
        ("(100±3 lx)*2", 200, 6),
        ("2*(100 lx ± 3%)", 200, 6),
        ("(-5±0.3)*2 lx", -10, 0.6),
        ("(1.5±0.1)e3 lx * 2", 3000, 200),
        ("(1.5±0.1)*10^3 lx", 1500, 100),
        ("sqrt(4.0±0.4 m2)", 2, 0.1),
        ("sqrt(4.0±0.4) m", 2, 0.1),
        ("sin(60±1 deg)", math.sqrt(0.75), math.pi / 180 / 2),
        ("(2±0.2) m + (3 ft ± 1 in)", 2 + 3 * FOOT, math.hypot(0.2, FOOT / 12)),
    ],
)
def test_numbers_of_expressions_may_be_uncertain(text, number, uncertainty):
    amount = read_amount(text)
    assert amount.number == pytest.approx(number, rel=1e-12)
    assert amount.uncertainty == pytest.approx(uncertainty, rel=1e-6)


# Interpretations of a text: the ± of its last number alone, or the ± of the whole.
@pytest.mark.parametrize(
    ("text", "ways"),
    [
        ("100+-3*2 lx", {"(100±3)*2 lx": (200, 6), "100±6 lx": (100, 6)}),
        ("100±3×2 lx", {"(100±3)×2 lx": (200, 6), "100±6 lx": (100, 6)}),
        ("100±3/2 lx", {"((100±3)/2) lx": (50, 1.5), "100±1.5 lx": (100, 1.5)}),
        ("2*100+-3 lx", {"2*(100±3) lx": (200, 6), "200±3 lx": (200, 3)}),
        ("1/4±0.01 m", {"(1/(4±0.01)) m": (0.25, 0.01 / 16), "0.25±0.01 m": (0.25, 0.01)}),
        ("500±10 lx * 20", {"(500±10) lx * 20": (1e4, 200), "500±200 lx": (500, 200)}),
        ("2*100 lx ± 3 lx", {"2*(100 lx ± 3 lx)": (200, 6), "200 lx ± 3 lx": (200, 3)}),
        ("100 lx * 2 ± 3 lx", {"200 lx ± 3 lx": (200, 3)}),
        ("(2*100)±3 lx", {"200±3 lx": (200, 3)}),
        ("(2*100±3) lx", {"2*(100±3)": (200, 6), "200±3": (200, 3)}),
        ("100±(2*3) lx", {"100±6 lx": (100, 6)}),
        ("1.5*10^3±0.1*10^2 lx", {"1500±10 lx": (1500, 10)}),
        ("100 lx ± 3% * 2", {"(100 lx ± 3%) * 2": (200, 6)}),
        ("(100±3) lx * 2 ± 1", {"(100±3) lx * (2 ± 1)": (200, math.hypot(6, 100))}),
        ("1/3m2%,(1±1)", {"each number with its ± in brackets: 2 * (100±3) lx": None}),
        ("100±3*2±1 lx", {"each number with its ± in brackets: 2 * (100±3) lx": None}),
    ],
)
def test_an_uncertain_number_in_arithmetic_needs_brackets(text, ways):
    with pytest.raises(RadcalcError, match="without brackets") as refused:
        read_amount(text)
    assert refused.value.hint.split(" or ") == list(ways)
    for way, size in ways.items():
        if size:
            amount = read_amount(way)
            assert (amount.number, amount.uncertainty) == pytest.approx(size, rel=1e-6)


def test_both_interpretations_keep_the_uncertainty():
    with pytest.raises(RadcalcError, match="ambiguous") as refused:
        read_amount("1/(2.0±0.1) m")
    assert refused.value.hint == "(1/(2.0±0.1)) m or 1/((2.0±0.1) m)"


def test_a_hostile_text_is_refused_quickly():
    with pytest.raises(RadcalcError, match="without brackets"):
        read_amount("*".join(["1"] * 240) + "±1" + "*1" * 240)


def test_each_number_of_an_expression_contributes_to_the_uncertainty():
    amount = read_amount("(100±3) lx - 20(1) lx")
    sizes = {part.text: part.size for part in amount.parts}
    assert sizes == pytest.approx({"100±3": 3, "20(1)": -1}, rel=1e-6)
    assert [(part.at(-1), part.at(1)) for part in amount.parts] == [(77, 83), (81, 79)]


@pytest.mark.parametrize(
    "text",
    [
        "1e308±1e307 lx",
        "1(1)e308 lx",
        "-1e308±1e308 lx",
        "1e-300±1e-301 lx",
        "0±1e-300 lx",
        "1e-200±1e-200% lx",
        "1 lx ± 1e160 lx",
        "3000±1 dBm",
        "1e200±1 mired",
        "(1e150±1e149)*(1e150±1e149) lx",
    ],
)
def test_an_uncertainty_whose_square_is_out_of_range_is_refused(text):
    with pytest.raises(RadcalcError, match="is out of range"):
        read_amount(text)


# Values at the number minus and plus its uncertainty; at an extremum, the first order is 0.
@pytest.mark.parametrize(
    ("text", "size", "ends"),
    [
        ("1/(2.0±0.5)*1 m", -0.125, (1 / 1.5, 1 / 2.5)),
        ("(0±1)^2 m2", 0, (1, 1)),
        ("(0±1)^3 m3", 0, (-1, 1)),
        ("cos(0±5deg)", 0, (math.cos(math.pi / 36),) * 2),
        ("sin(90±1deg)", 0, (math.cos(math.pi / 180),) * 2),
        ("sqrt(0.5±1)*1m", 1 / math.sqrt(2), (None, math.sqrt(1.5))),
        ("(1.00±0.01)^100", 1, (0.99**100, 1.01**100)),
        ("10±3 dBm", 3 * math.log(10), (10**0.7, 10**1.3)),
        ("1±1 OD", -math.log(10) / 10, (1, 0.01)),
        ("1±2 mired", -2e6, (None, 1e6 / 3)),
    ],
)
def test_each_contribution_to_an_amount_has_its_ends(text, size, ends):
    amount = read_amount(text)
    assert amount.is_uncertain
    (part,) = amount.parts
    assert part.size == pytest.approx(size, rel=1e-5)
    for end, other in zip((part.at(-1), part.at(1)), ends, strict=True):
        assert end == other or end == pytest.approx(other, rel=1e-12)


def test_an_infinite_slope_is_refused():
    with pytest.raises(RadcalcError, match="cannot be propagated through 'sqrt"):
        read_amount("sqrt(0±1)*1m")


def test_a_reading_in_arithmetic_is_refused_with_its_number():
    with pytest.raises(RadcalcError, match="is a scale, not a unit") as refused:
        read_amount("2*(10±1 dBm)")
    assert "10" in refused.value.hint
