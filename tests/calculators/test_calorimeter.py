"""Calorimeters against closed forms."""

import pytest
from helpers import number

from radcalc import calorimeter


@pytest.mark.parametrize(
    ("call", "name", "unit", "expected"),
    [
        (lambda: calorimeter(mass="10g", specific_heat="385J/kg/K", temperature_rise="2K",
                             time="30s"), "flux", "W", 7.7 / 30),
        (lambda: calorimeter(irradiance="1000W/m2", receiver_area="20cm2", absorptance=0.95,
                             time="1min", mass="10g", specific_heat="385J/kg/K"),
         "temperature_rise", "K", 0.95 * 120 / 3.85),
    ],
)  # fmt: skip
def test_calorimeters_match_their_formulas(call, name, unit, expected):
    assert number(call(), name, unit) == pytest.approx(expected, rel=1e-12)
