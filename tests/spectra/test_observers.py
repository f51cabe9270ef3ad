"""Observers at, between and outside the points of their tables."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc.spectra.observers import (
    OBSERVERS,
    luminous_efficacy,
    luminous_efficiency,
    standard_air_wavelength,
)

PHOTOPIC, SCOTOPIC = OBSERVERS["photopic"], OBSERVERS["scotopic"]


@pytest.mark.parametrize(
    ("wavelength", "value"),
    [  # CIE 1924, from colour-science 0.4.7
        (555e-9, 1.0),
        (632e-9, 0.2448896),
        (633e-9, 0.2353344),
        (632.8e-9, 0.2448896 * 0.2 + 0.2353344 * 0.8),
        (360e-9, 3.917e-6),
        (359.999e-9, 0),
        (830.001e-9, 0),
        (10e-6, 0),
    ],
)
def test_v_of_lambda_at_between_and_outside_points_of_the_table(wavelength, value):
    assert luminous_efficiency(wavelength, PHOTOPIC) == pytest.approx(value, rel=1e-9, abs=0)


def test_scotopic_vision_peaks_at_507_nm():
    assert luminous_efficacy(507e-9, SCOTOPIC) == 1700.06
    assert luminous_efficiency(379.9e-9, SCOTOPIC) == 0


@given(st.lists(st.floats(min_value=300e-9, max_value=900e-9), min_size=1, max_size=9))
def test_an_array_gives_the_same_as_its_elements(wavelengths):
    for observer in OBSERVERS.values():
        together = luminous_efficiency(np.array(wavelengths), observer)
        alone = [luminous_efficiency(w, observer) for w in wavelengths]
        np.testing.assert_allclose(together, alone, rtol=1e-9, atol=1e-15)


@pytest.mark.parametrize(
    ("name", "maximum"),
    [("cie1964", 683.60), ("cie2008-2", 683.36), ("cie2008-10", 683.15)],
)
def test_other_observers_follow_from_the_candela(name, maximum):
    # 683 lm/W over V at 540 THz; values by the rule of CIE 018:2019, to two decimals
    assert OBSERVERS[name].maximum == pytest.approx(maximum, abs=5e-3)


def test_540_thz_is_555_017_nm_in_standard_air():
    # the candela of 2019: 683 lm/W at 540 THz, 555.171 nm in vacuum, n about 1.00028
    vacuum = 299792458 / 540e12
    assert vacuum * 1e9 == pytest.approx(555.171, abs=5e-4)
    air = standard_air_wavelength(vacuum)
    assert vacuum / air == pytest.approx(1.00028, abs=5e-6)
    assert luminous_efficacy(air, PHOTOPIC) == pytest.approx(683.000, abs=5e-4)
    assert luminous_efficacy(vacuum, PHOTOPIC) == pytest.approx(682.985, abs=5e-4)
    assert standard_air_wavelength(np.array([vacuum]))[0] == air
