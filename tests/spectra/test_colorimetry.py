"""Colour temperature and colour rendering, compared with definitions and colour-science."""

import math
import warnings

import pytest

from radcalc.spectra import colorimetry
from radcalc.spectra.compile import load_colour
from radcalc.spectra.sources import spectrum


def light(text: str) -> colorimetry.Light:
    return spectrum(text).moments(*colorimetry.AT)


def rendering(text: str) -> float:
    seen = light(text)
    temperature, _ = colorimetry.temperature_and_distance(seen)
    return colorimetry.colour_rendering_index(seen, colorimetry.reference(temperature))


@pytest.mark.parametrize("temperature", [300, 500, 900, 1000, 2856, 4999, 6500, 2e4, 2e5, 1e6, 1e8])
def test_a_black_body_has_its_own_temperature(temperature):
    found, distance = colorimetry.temperature_and_distance(light(f"blackbody:{temperature}K"))
    assert found == pytest.approx(temperature, rel=1e-9)
    assert distance == 0


@pytest.mark.parametrize("temperature", [300, 900, 1000, 2000, 2856, 4999.9])
def test_a_black_body_is_the_reference_below_5000_k(temperature):
    assert rendering(f"blackbody:{temperature}K") == pytest.approx(100, abs=1e-9)


@pytest.mark.parametrize("temperature", [5010, 5500, 6500, 10000, 24000])
def test_a_daylight_is_the_reference_from_5000_k(temperature):
    # CIE 15 rounds the polynomials of the daylight locus, so the colour temperature is 2 K off
    found, distance = colorimetry.temperature_and_distance(light(f"daylight:{temperature}K"))
    assert found == pytest.approx(temperature, rel=1.5e-3)
    assert distance == pytest.approx(0.0032, abs=2e-4)
    assert rendering(f"daylight:{temperature}K") == pytest.approx(100, abs=0.03)


def test_the_rendering_of_named_lamps_agrees_with_colour_science():
    # its tables of CIE 15's illuminants are interpolated linearly, like ours
    colour = load_colour()
    lamps = [f"FL{k}" for k in range(1, 13)] + ["FL3.1", "FL3.8", "FL3.15"]
    lamps += [*(f"HP{k}" for k in range(1, 6)), "A", "C", "D50", "D65", "LED-B3"]
    for name in lamps:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            expected = colour.colour_rendering_index(colour.SDS_ILLUMINANTS[name])
        # colour-science takes the temperature of the reference from Robertson's table
        assert rendering(name) == pytest.approx(expected, abs=0.03), name


@pytest.mark.parametrize(
    ("name", "temperature", "index"),
    [  # CIE 15, table of illuminants, as in the tests and documents of colour-science
        ("FL1", 6430, 76), ("FL2", 4230, 64), ("FL4", 2940, 51),
    ],
)  # fmt: skip
def test_published_temperatures_and_indices(name, temperature, index):
    found, _ = colorimetry.temperature_and_distance(light(name))
    assert found == pytest.approx(temperature, abs=6)
    assert rendering(name) == pytest.approx(index, abs=0.5)


def test_the_rendering_of_hp1_is_from_the_full_table():
    assert rendering("HP1") == pytest.approx(8.498, abs=0.01)  # other interpolations give 8.07


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("gaussian:470nm,150nm", "infinite temperature"),
        ("line:700nm", "250 K"),
        ("gaussian:530nm,30nm", "limit is 0.05"),
        ("line:400nm", "infinite"),
    ],
)
def test_a_missing_colour_temperature_has_a_reason(text, reason):
    with pytest.raises(colorimetry.Undefined, match=reason):
        colorimetry.temperature_and_distance(light(text))


def test_there_is_no_reference_above_25000_k():
    assert math.isfinite(sum(colorimetry.reference(25000.0)))
    with pytest.raises(colorimetry.Undefined, match="25000 K"):
        colorimetry.reference(25001.0)
