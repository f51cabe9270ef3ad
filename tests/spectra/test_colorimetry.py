"""Colour temperature and colour rendering, compared with definitions and colour-science."""

import math
import warnings

import numpy
import pytest

from radcalc.spectra import colorimetry
from radcalc.spectra.colorimetry import load_colour
from radcalc.spectra.sources import spectrum


def light(text: str) -> colorimetry.Light:
    return spectrum(text).moments(*colorimetry.AT)


def special(text: str) -> list[float]:
    seen = light(text)
    temperature, _ = colorimetry.temperature_and_distance(seen)
    like = colorimetry.reference(temperature).moments(*colorimetry.AT)
    return colorimetry.colour_rendering_indices(seen, like)


def rendering(text: str) -> float:
    return colorimetry.colour_rendering_index(special(text))


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
            expected = colour.colour_rendering_index(colour.SDS_ILLUMINANTS[name], True)
        # colour-science takes the temperature of the reference from Robertson's table
        assert rendering(name) == pytest.approx(expected.Q_a, abs=0.03), name
        expected_special = [expected.Q_as[k].Q_a for k in range(1, 15)]
        assert special(name) == pytest.approx(expected_special, abs=0.12), name


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
        ("gaussian:470nm,150nm", "bluer than any black body"),
        ("line:700nm", "250 K"),
        ("gaussian:530nm,30nm", "limit is 0.05"),
        ("line:400nm", "bluer"),
    ],
)
def test_a_missing_colour_temperature_has_a_reason(text, reason):
    with pytest.raises(colorimetry.Undefined, match=reason):
        colorimetry.temperature_and_distance(light(text))


def test_there_is_no_reference_above_25000_k():
    assert math.isfinite(colorimetry.reference(25000.0).total())
    with pytest.raises(colorimetry.Undefined, match="25000 K"):
        colorimetry.reference(25001.0)


def mixed(*parts: tuple[float, str]) -> colorimetry.Light:
    """Return lights added in proportion to their tristimulus sums, the weights of chromaticity."""
    mixture = [0.0] * colorimetry.AT[1]
    for weight, text in parts:
        added = light(text)
        scale = weight / sum(colorimetry.tristimulus(added))
        mixture = [total + scale * part for total, part in zip(mixture, added, strict=True)]
    return mixture


# Shares of three lights that add up to X = Y = Z, 0.7 in all.
LINES = ("line:460nm", "line:540nm", "line:620nm")
SHARES = numpy.linalg.solve(
    [*numpy.transpose([colorimetry.chromaticity(light(line)) for line in LINES]), [1, 1, 1]],
    [0.7 / 3, 0.7 / 3, 0.7],
)
WHITE = tuple(zip(SHARES.tolist(), LINES, strict=True))


@pytest.mark.parametrize("nm", [400.0, 450.5, 520.0, 555.0, 589.3, 632.8, 690.0])
def test_the_dominant_wavelength_of_a_mixture_with_white_is_that_of_its_light(nm):
    alone = colorimetry.hue(light(f"line:{nm}nm"))
    assert alone == (pytest.approx(nm, abs=2e-4), False, pytest.approx(1.0, abs=1e-6))
    # by the law of the centre of gravity, a mixture is at its share of the way from white
    pale = colorimetry.hue(mixed((0.3, f"line:{nm}nm"), *WHITE))
    assert pale == (pytest.approx(nm, abs=2e-4), False, pytest.approx(0.3, abs=1e-6))


def test_a_purple_has_a_complementary_wavelength_and_its_purity_is_of_the_line_of_purples():
    ends = mixed((0.5, "line:360nm"), (0.5, f"line:{colorimetry.LAST}nm"))
    full = colorimetry.hue(ends)
    assert full.is_complementary
    assert full.purity == pytest.approx(1.0, abs=1e-9)
    pale = colorimetry.hue(
        mixed((0.15, "line:360nm"), (0.15, f"line:{colorimetry.LAST}nm"), *WHITE)
    )
    assert pale == (pytest.approx(full.wavelength, abs=2e-4), True, pytest.approx(0.3, abs=1e-6))
    # the complementary light and the purple add up to white on their line
    green = f"line:{full.wavelength!r}nm"
    x, y = colorimetry.chromaticity(ends)
    a, b = colorimetry.chromaticity(light(green))
    assert (x - 1 / 3) * (b - 1 / 3) == pytest.approx((y - 1 / 3) * (a - 1 / 3), abs=1e-9)


def test_white_and_the_far_red_have_no_dominant_wavelength():
    with pytest.raises(colorimetry.Undefined, match="white"):
        colorimetry.hue(light("E"))
    with pytest.raises(colorimetry.Undefined, match="699 nm"):
        colorimetry.hue(light("line:760nm"))


@pytest.mark.parametrize(
    ("nm", "name"),
    [  # ISO 21348, by the wavebands of the R package photobiologyWavebands; it has "purple" first
        (360, "violet"), (449.9, "violet"), (450, "blue"), (500, "green"), (570, "yellow"),
        (591, "orange"), (610, "red"), (759, "red"), (760, ""), (359, ""),
    ],
)  # fmt: skip
def test_the_names_of_hues_are_those_of_iso_21348(nm, name):
    assert colorimetry.hue_name(nm) == name


def test_the_colours_of_a_screen_are_those_of_srgb():
    # IEC 61966-2-1: X, Y, Z of its red, green and blue, and of D65
    primaries = [(0.4124, 0.2126, 0.0193), (0.3576, 0.7152, 0.1192), (0.1805, 0.0722, 0.9505)]
    for k, primary in enumerate(primaries):
        expected = [float(j == k) for j in range(3)]
        assert colorimetry.srgb(primary) == pytest.approx(expected, abs=2e-3)
    assert colorimetry.srgb((0.9505, 1.0, 1.089)) == pytest.approx([1, 1, 1], abs=1e-3)
    # a linear half is 188/255 (0.7354)
    half = [a + b / 2 for a, b in zip(primaries[0], primaries[1], strict=True)]
    assert colorimetry.srgb(half) == pytest.approx([1, 0.7354, 0], abs=2e-3)
