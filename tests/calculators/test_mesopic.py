import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc.laws.photometry import mesopic_luminance


@pytest.mark.parametrize(
    ("luminance", "ratio", "mesopic", "m"),
    [
        (0.1, 2.0, 0.13096, 0.4727),  # CIE 191, MES2
        (10.0, 2.0, 10.0, 1.0),
        (0.001, 1.0, 0.001, 0.0),
    ],
)
def test_mesopic_luminance_is_the_fixed_point(luminance, ratio, mesopic, m):
    got, adapted = mesopic_luminance(luminance, ratio)
    assert got == pytest.approx(mesopic, abs=5e-6)
    assert adapted == pytest.approx(m, abs=5e-5)


@given(st.floats(1e-5, 100), st.floats(0.2, 5))
def test_the_mesopic_solution_is_consistent(luminance, ratio):
    # CIE 191:2010: m = 0.7670 + 0.3334 log10 L_mes, between 0.005 and 5 cd/m2
    mesopic, m = mesopic_luminance(luminance, ratio)
    assert 0 <= m <= 1
    if 0.0051 < mesopic < 4.99:
        assert m == pytest.approx(0.7670 + 0.3334 * math.log10(mesopic), abs=1e-9)
