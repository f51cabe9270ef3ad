import contextlib
import math

import pytest
from helpers import at_most, for_each
from hypothesis import given
from hypothesis import strategies as st

from radcalc.errors import NumberError, UnitError
from radcalc.units.grammar import parse_unit
from radcalc.units.numbers import parse_number, rounding, split_quantity, typed_digits
from radcalc.units.table import resolve

SAME = [("W", 1), ("m", -2), ("sr", -1)]


@pytest.mark.parametrize(
    "text",
    [
        "W/m2/sr",
        "W/m^2/sr",
        "W/m**2/sr",
        "W.m-2.sr-1",
        "W m-2 sr-1",
        "W·m⁻²·sr⁻¹",
        "W*m^-2*sr^(-1)",
        "W/(m^2 sr)",
        "W/(m2·sr)",
        "W m-2/sr",
        " W  /  m2 / sr ",
        "W per square m per sr",
        "W per sq.m per sr",
        "W/sq. m/sr",
        "W\u00a0m\u22122 sr\u22121",
        "(W/m2)/sr",
    ],
)
def test_every_spelling_is_read_as_the_same_unit(text):
    assert [(name, n) for name, n, _ in parse_unit(text)] == SAME


@pytest.mark.parametrize(
    ("text", "readings"),
    [
        ("W/m^2 sr", "W/(m^2 sr) or (W/m^2) sr"),
        ("W/m2.sr", "W/(m2.sr) or (W/m2) sr"),
        ("W/m2*sr", "W/(m2*sr) or (W/m2) sr"),
        ("umol/m2 s-1", "umol/(m2 s-1) or (umol/m2) s-1"),
        ("lm/(W/m2 nm)", "W/(m2 nm) or (W/m2) nm"),
    ],
)
def test_a_product_after_a_solidus_is_refused_with_both_interpretations(text, readings):
    with pytest.raises(UnitError, match="ambiguous") as caught:
        parse_unit(text)
    assert caught.value.hint == readings


@pytest.mark.parametrize(
    ("text", "power"),
    [
        ("square m", 2), ("sq m", 2), ("Sq m", 2), ("cubic m", 3), ("cu m", 3), ("lm per sq m", -2),
        ("m12", 12), ("m^-12", -12), ("m⁺²", 2), ("m^+2", 2), ("m^(2)", 2), ("(m2)3", 6),
        ("(" * 16 + "m" + ")" * 16, 1),
    ],
)  # fmt: skip
def test_powers_as_words_digits_and_brackets(text, power):
    assert parse_unit(text)[-1][:2] == ("m", power)


@pytest.mark.parametrize("text", ["W/m2/cm-1", "mW/(m2 sr cm-1)", "W m-2 (cm-1)-1"])
def test_an_inverse_below_a_solidus_is_marked(text):
    assert ("cm", 1, True) in parse_unit(text)


@pytest.mark.parametrize("text", ["lm/(W/m)", "W/m2/(cycle/m)", "cm-1", "W m-2 nm-1"])
def test_a_solidus_inside_brackets_is_not_an_inverse(text):
    assert not any(inverse for _, _, inverse in parse_unit(text))


@for_each([
    "", " ", "()", "((m)", "m)", "m//s", "m*", "*m", "m/", "m^", "m^x", "m^0.5", "m^(1/2)",
    "m^999999", "m^13", "(m^7)^2", "m2^2", "m^2^2", "m2sr", "10**10**10 m", "2 m", "m 2 s",
    "a\x00b", "\x1b[31m", "m;s", "m,s", "m⁻", "m⁻⁻²", "lx\udcff", "__import__('os')", "m--2",
    "(" * 17 + "m" + ")" * 17,
])  # fmt: skip
def test_a_malformed_unit_is_refused(text):
    with pytest.raises(UnitError) as caught:
        parse_unit(text)
    assert caught.value.message
    assert caught.value.hint


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1.5e3", 1500),
        (".5", 0.5),
        ("5.", 5),
        ("-5", -5),
        ("\u22125", -5),
        ("+5", 5),
        ("+.5", 0.5),
        ("-5.", -5),
        ("1/3", 1 / 3),
        ("4pi", 4 * math.pi),
        ("4π", 4 * math.pi),
        ("pi/6", math.pi / 6),
        ("2*pi/3", 2 * math.pi / 3),
        ("-pi", -math.pi),
        ("1E-3", 1e-3),
        ("0e-999", 0),
    ],
)
def test_numbers_are_read(text, value):
    assert parse_number(text) == value


@for_each([
    "", "-", "+", ".", "+.", "-.", "nan", "inf", "-inf", "Infinity", "1,5", "1,000",
    "1,000,000", "1_000", "0x10",
    "1e999", "-1e999", "1e-999", "1e-310", "1/0", "10**10", "٣", "1٣", "²", "one", "--5",
    "1 000", "1..2", "pixel", "5²", "1e308*10", "9" * 2000, "1e400/1e400", "1e400*0",
    "1/1e400", "1e-200*1e-200", "1e-200/1e200", "1e308pi", "1/2pi", "2/3 pi", "pi/2π",
])  # fmt: skip
def test_a_malformed_number_is_refused(text):
    with pytest.raises(NumberError) as caught:
        parse_number(text)
    assert caught.value.message
    assert caught.value.hint


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("1,5", "1.5"), ("1,000", "1000 or 1.000"), ("1,000,000", "1000000"), ("1_000", "1000"),
        ("1.000,5", "1000.5"), ("1,000.5", "1000.5"), ("1,5W.m-2", "1.5W.m-2"),
        ("-1,5 lx", "-1.5 lx"), ("1,23,4", "a number such as 1500 or 1.5, without commas"),
        ("1_0 foot_lambert", "10 foot_lambert"),
    ],
)  # fmt: skip
def test_a_number_with_a_comma_or_an_underscore_is_refused_with_a_correction(text, hint):
    with pytest.raises(NumberError) as caught:
        split_quantity(text)
    assert caught.value.hint == hint


@pytest.mark.parametrize(
    ("text", "two_thirds", "below"),
    [
        ("2/3pi", "2pi/3", "2/3/pi"), ("1/2π rad", "1pi/2 rad", "1/2/pi rad"),
        ("2/3pirad", "2pi/3rad", "2/3/pirad"), ("2/3pisr", "2pi/3sr", "2/3/pisr"),
        ("1/4 pi sr", "1pi/4 sr", "1/4/pi sr"), ("pi/2pi", "pi*pi/2", "pi/2/pi"),
    ],
)  # fmt: skip
def test_a_pi_after_a_divisor_is_refused_with_both_interpretations(text, two_thirds, below):
    with pytest.raises(NumberError) as caught:
        split_quantity(text)
    assert caught.value.hint == f"{two_thirds} or {below}"
    above, under = split_quantity(two_thirds), split_quantity(below)
    assert above[1] == under[1]
    assert math.isclose(above[0], under[0] * math.pi**2, rel_tol=1e-15)


@pytest.mark.parametrize("text", ["град", "grad", "Grad", "pi"])
def test_a_unit_that_may_be_degrees_or_gons_is_refused(text):
    with pytest.raises(UnitError) as caught:
        resolve(text)
    assert caught.value.hint


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [
        ("100lx", 100, "lx"),
        ("100 lx", 100, "lx"),
        ("5eV", 5, "eV"),
        ("1e3eV", 1000, "eV"),
        ("1/3 lx", 1 / 3, "lx"),
        ("5/m2", 5, "/m2"),
        ("4pi sr", 4 * math.pi, "sr"),
        ("18000cm-1", 18000, "cm-1"),
    ],
)
def test_a_quantity_is_split_into_number_and_unit(text, value, unit):
    assert split_quantity(text) == (value, unit)


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused(text):
    with contextlib.suppress(UnitError):
        parse_unit(text)
    with contextlib.suppress(NumberError):
        split_quantity(text)


@given(st.floats(allow_nan=False, allow_infinity=False, allow_subnormal=False))
def test_every_float_is_read_back_exactly(value):
    assert parse_number(repr(value)) == value


@pytest.mark.parametrize(
    "hostile",
    ["m" * 10_000_000, "(" * 10_000_000, "9" * 10_000_000, "m/" * 5_000_000, "\0" * 10_000_000],
)
def test_ten_megabytes_are_refused_without_parsing_them(hostile):
    with at_most(100):
        with pytest.raises(UnitError):
            parse_unit(hostile)
        with pytest.raises(NumberError):
            split_quantity(hostile)


@pytest.mark.parametrize(
    ("text", "half_a_digit"),
    [
        ("2", 0.005 / 2), ("2.5", 0.05 / 2.5), ("2.50", 0.005 / 2.5), ("-2.500", 0.0005 / 2.5),
        ("1.25e3", 5 / 1250), ("0.0012", 0.00005 / 0.0012), ("31.6 lx", 0.05 / 31.6),
        ("1/3", 1e-9), ("4pi", 1e-9), ("0", 1e-9), ("2*3", 1e-9), ("\u22122", 0.005 / 2),
    ],
)  # fmt: skip
def test_the_rounding_of_a_number_is_half_its_last_digit_and_2_is_read_as_2_00(text, half_a_digit):
    assert rounding(text) == pytest.approx(half_a_digit, rel=1e-14)


def test_only_a_whole_decimal_has_digits():
    assert typed_digits("-1.50e\u22123") == ("150", -5)
    for text in ("", ".", "1e++5", "1e", "1e5.5", "1.2.3", "²", "1/3", "pi", "-+1", "e5", "١"):
        assert typed_digits(text) is None, text
