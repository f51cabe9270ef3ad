"""Numbers with their uncertainty as text."""

import random
import re

import pytest
from helpers import for_each
from uncertainties import ufloat, ufloat_fromstr

from radcalc.render.plain import rounded, uncertain
from radcalc.units.reading import read_amount


@for_each(
    [
        (9.290304, 0.27870912, "9.29 ± 0.28"),
        (100, 3, "100.0 ± 3.0"),
        (12345, 320, "12340 ± 320"),
        (4000, 100, "4000 ± 100"),
        (0.001234, 0.0000321, "0.001234 ± 0.000032"),
        (0.00001234, 0.000000321, "(1.234 ± 0.032)e-05"),
        (12345678, 32100, "(1.2346 ± 0.0032)e+07"),
        (0, 0.05, "0.000 ± 0.050"),
        (-5, 0.996, "-5.0 ± 1.0"),  # 0.996 has two digits as 1.0
        (5, 0, "5"),
        (1, 20, "1 ± 20"),
        (-0.01, 5, "0.0 ± 5.0"),
        (9999995, 100, "(1.000000 ± 0.000010)e+07"),
        (0.000099999, 0.0000099, "0.0001000 ± 0.0000099"),
        (-34, 7.2e9, "(0.0 ± 7.2)e+09"),
        (1e302, 1e-3, "1e+302 ± 0.001"),  # no digits of one are digits of the other
        (2000, 4e-140, "2000 ± 4e-140"),
        (5, 0.0995, "5.00 ± 0.10"),
        (5, 9.96, "5 ± 10"),
        (5, 0.095, "5.000 ± 0.095"),
    ],
)
def test_two_digits_of_the_uncertainty(value, off, text):
    assert uncertain(value, off) == text


def test_a_precision_changes_neither():
    for precision in range(1, 18):
        assert uncertain(9.290304, 0.27870912, precision) == "9.29 ± 0.28"
        assert rounded(9.290304, 0.27870912, precision) == (9.29, 0.28)
    assert rounded(9.290304, 0.27870912, None) == (9.290304, 0.27870912)
    assert rounded(9.290304, 0.0, 2) == (9.3, 0.0)


def test_numbers_agree_with_the_uncertainties_package():
    generator = random.Random(20260801)
    for _ in range(2000):
        value = generator.choice((-1, 1)) * 10 ** generator.uniform(-8, 8)
        off = abs(value) * 10 ** generator.uniform(-6, 0.5)
        text = uncertain(value, off)
        other = ufloat_fromstr(f"{ufloat(value, off):.2u}")
        again = read_amount(re.sub(" ", "", text))
        assert again.number == pytest.approx(other.nominal_value, rel=1e-12, abs=1e-12 * off)
        assert again.uncertainty == pytest.approx(other.std_dev, rel=1e-12)
