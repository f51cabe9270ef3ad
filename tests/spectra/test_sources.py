"""Named sources, compared with published values, and sources given by formulas."""

import math
import re

import pytest
from conftest import run

from radcalc.errors import ConditionError, RadcalcError
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.sources import MEANT, WORDS, find_named, names, read_spectra, spectrum
from radcalc.spectra.spectrum import WHOLE, range_text

PHOTOPIC, SCOTOPIC = OBSERVERS["photopic"], OBSERVERS["scotopic"]
MICROMOLE = 6.02214076e17


def efficacy(text: str, limits=None) -> float:
    source = spectrum(text)
    return PHOTOPIC.maximum * source.seen(PHOTOPIC) / source.power(limits or source.limits)


# Published luminous efficacies of radiation [lm/W] and the range of the watts [nm].
PUBLISHED = [
    ("A", (360, 830), 122.9, 0.05),
    ("A", (380, 780), 156.2, 0.05),
    ("D65", (360, 830), 184.4, 0.05),
    ("D65", (380, 780), 205.2, 0.06),
    ("F11", (380, 780), 337, 0.5),
    ("LED-B3", (380, 780), 317, 0.5),
    ("blackbody:2856K", WHOLE, 16.4, 0.05),
    ("blackbody:6628K", WHOLE, 95.4, 0.05),
    ("AM1.5G", (280, 4000), 109.5, 0.05),
]


@pytest.mark.parametrize(("source", "limits", "value", "within"), PUBLISHED)
def test_published_luminous_efficacies(source, limits, value, within):
    assert efficacy(source, limits) == pytest.approx(value, abs=within)


def test_a_temperature_may_be_in_mired():
    """A mired is a reciprocal megakelvin (ANSI/IES LS-1): 200 mired are 5000 K."""
    for kind in ("blackbody", "daylight"):
        assert efficacy(f"{kind}:200mired") == efficacy(f"{kind}:5000K")
    with pytest.raises(RadcalcError, match="0 mired is not the reciprocal of a"):
        spectrum("blackbody:0mired")


def test_the_best_black_body_has_6628_k():
    best = max(range(6600, 6660), key=lambda t: efficacy(f"blackbody:{t}K"))
    assert abs(best - 6628) <= 2


@pytest.mark.parametrize(("source", "ratio"), [("A", 1.41), ("D65", 2.46)])
def test_published_scotopic_to_photopic_ratios(source, ratio):
    light = spectrum(source)
    scotopic = SCOTOPIC.maximum * light.seen(SCOTOPIC)
    assert scotopic / (PHOTOPIC.maximum * light.seen(PHOTOPIC)) == pytest.approx(ratio, abs=0.006)


def test_the_suns_of_astm_g173():
    # E490 and G173-03: 1348 W/m2 from 280 to 4000 nm outside the atmosphere, 1000.4 and 900.1
    for name, watts in (("AM0", 1347.9), ("AM1.5G", 1000.4), ("AM1.5D", 900.1)):
        sun = spectrum(name)
        assert sun.power(sun.limits) == pytest.approx(watts, abs=0.06)
    outside = spectrum("AM0")
    assert PHOTOPIC.maximum * outside.seen(PHOTOPIC) == pytest.approx(133e3, abs=500)
    ground = spectrum("AM1.5G")
    par = ground.photons((400, 700)) / MICROMOLE
    assert PHOTOPIC.maximum * ground.seen(PHOTOPIC) / par == pytest.approx(55.4, abs=0.05)
    assert par / ground.power((400, 700)) == pytest.approx(4.60, abs=0.02)
    assert "AM1.5G" in spectrum("sun").notes[0]


def test_every_named_source_has_watts_lumens_and_photons():
    assert len(names()) == 59 + 56 + 3
    for name in names():
        light = spectrum(name)
        assert light.power(light.limits) > 0, name
        assert 10 < efficacy(name) < 683.002, name
        assert light.photons((400, 700)) > 0, name


@pytest.mark.parametrize(
    ("one", "other"),
    [("F1", "FL1"), ("f11", "FL11"), ("led-b3", "LED-B3"), ("ledb3", "LED-B3"), ("hps", "HPS"),
     ("am1.5g", "AM1.5G"), ("F3.1", "FL3.1"), ("d65", "D65"), ("led_b3", "LED-B3"),
     ("f34/cw/rs/ew(cool white fl)", "F34/CW/RS/EW (Cool White FL)")],
)  # fmt: skip
def test_names_are_found_as_people_type_them(one, other):
    assert spectrum(one).label == spectrum(other).label


@pytest.mark.parametrize("text", ["D65!", "D65;", "D65-", "-D65", "D65,", "(D65", "'D65'", "D65/"])
def test_a_name_with_other_signs_around_it_is_refused(text):
    with pytest.raises(ConditionError):
        spectrum(text)


@pytest.mark.parametrize(
    ("text", "message", "hint"),
    [
        ("D65,-", "standard input is not allowed in the list 'D65,-'", "D65"),
        ("D65,", "a spectrum is missing in the list 'D65,'", "D65"),
        ("D65,,A", "a spectrum is missing in the list 'D65,,A'", "D65,A"),
        ("D65,532nm", "in the list 'D65,532nm': unknown spectrum '532nm'", "line:532nm"),
        ("D65,lamp.csv", "there is no file 'lamp.csv'", "path"),
        ("D65,LED-B33", "unknown spectrum 'LED-B33'", "LED-B3"),
    ],
)
def test_the_wrong_part_of_a_list_is_named(text, message, hint):
    (whole,) = read_spectra(text)
    with pytest.raises(ConditionError) as caught:
        spectrum(whole)
    assert message in caught.value.message
    assert hint in caught.value.hint


@pytest.mark.parametrize("nanometres", ["0.5", "1.2", "1e3", "1e-6", "1e11"])
def test_a_gaussian_as_wide_as_its_centre_extends_to_0(nanometres):
    bell = spectrum(f"gaussian:{nanometres}nm,{nanometres}nm")
    peak, width = bell.peak()
    assert peak == pytest.approx(float(nanometres), rel=1e-12)
    # a normal distribution above 0 only, sigma 0.424661: 1 - cdf(-2.354820) = 0.990734
    area = 0.990734 * math.sqrt(2 * math.pi) * 0.424661 * float(nanometres)
    if peak > 1e-5:  # the part below the shortest wavelength, 1e-6 nm, is small
        assert bell.power(WHOLE) == pytest.approx(area, rel=1e-3)
        assert width == pytest.approx(float(nanometres), rel=1e-3)


def test_lines_bands_and_gaussians():
    # V(555) = 1, V(600) = 0.631, the CIE table
    lines = spectrum("line:555nm=40,600nm=30")
    assert lines.seen(PHOTOPIC) == pytest.approx(40 + 30 * 0.631, rel=1e-9)
    assert lines.power(WHOLE) == 70
    band = spectrum("band:580nm:630nm")
    assert band.power(WHOLE) == 50
    # photons of a flat band: the mean wavelength
    per_watt = band.photons(WHOLE) / band.power(WHOLE)
    assert per_watt == pytest.approx(605e-9 / (6.62607015e-34 * 299792458), rel=1e-12)
    bell = spectrum("gaussian:530nm,30nm")
    area = 30 * math.sqrt(math.pi / math.log(2)) / 2  # of a Gaussian of that FWHM
    assert bell.power(WHOLE) == pytest.approx(area, rel=1e-6)
    assert spectrum("line:540THz").seen(PHOTOPIC) == pytest.approx(683 / 683.002, rel=1e-6)


def test_the_range_of_a_wide_gaussian_begins_at_0():
    """150/21 standard deviations, each 300 nm / (2 sqrt(2 ln 2)), are 909.99 nm above 555 nm."""
    assert range_text(spectrum("gaussian:555nm,300nm").limits) == "0-1464.99 nm"


def test_daylight_6504_k_is_d65():
    light, table = spectrum("daylight:6503.6K"), spectrum("D65")
    for a, b in zip(light.values, table.values, strict=True):
        assert a == pytest.approx(b, rel=1e-3, abs=0.02)


@pytest.mark.parametrize(
    "text",
    ["gaussian:530nm,1e-12nm", "gaussian:530nm,1um", "gaussian:530nm", "band:700nm:600nm",
     "line:0nm", "line:555nm=0", "line:555nm=2W", "line:555nm=1e300", "blackbody:5m", "daylight:1K",
     "line:", "blackbody:", "band:1nm"],
)  # fmt: skip
def test_a_meaningless_source_is_refused(text):
    with pytest.raises(RadcalcError) as caught:
        spectrum(text)
    assert caught.value.hint


# Correlated colour temperatures of CIE 15:2018, which the words round to hundreds.
TEMPERATURES = {
    "LED-B1": 2733, "LED-B3": 4103, "LED-B5": 6598, "D65": 6504, "D75": 7504, "A": 2856
}  # fmt: skip


@pytest.mark.parametrize("word", WORDS)
def test_a_word_for_light_is_taken_as_a_table_and_says_so(word):
    name, meaning = WORDS[word]
    for typed in (word, word.upper(), word.replace(" ", "-")):
        found, table = find_named(typed), find_named(name)
        assert found is not None
        assert table is not None
        assert list(found.grid) == list(table.grid)
        assert list(found.values) == list(table.values)
        assert f"'{typed}' is taken as {name}, {meaning}" in found.notes
    if name in TEMPERATURES:
        nominal = TEMPERATURES[name]
        assert {f"{nominal} K", f"{round(nominal, -2)} K"} & set(re.findall(r"\d+ K", meaning))


def test_white_is_never_a_fluorescent_tube():
    for words in (WORDS, MEANT):
        for word, spectra in words.items():
            if "white" in word:
                assert not any(name.startswith("F") for name in str(spectra).split(", "))


@pytest.mark.parametrize("word", MEANT)
def test_a_word_for_light_is_refused_with_spectra(word):
    with pytest.raises(ConditionError) as caught:
        spectrum(word)
    for proposal in caught.value.tries:
        spectrum(proposal.instead[1])
        assert (":" in proposal.instead[1]) == (proposal.remark == "an example")


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("5600K", "blackbody:5600K or daylight:5600K"),
        ("2856K", "blackbody:2856K"),  # CIE 15 defines daylight from 4000 K to 25 000 K
        ("532nm", "line:532nm"),
        ("580nm:630nm", "band:580nm:630nm"),
    ],
)
def test_parameters_alone_are_refused_with_kinds_that_take_them(text, hint):
    with pytest.raises(ConditionError) as caught:
        spectrum(text)
    assert caught.value.hint == hint


# AM0: the table of ASTM G173-03 and the solar constant of ASTM E490; on the ground, less than
# (1366.1 - 1347.93) / 1000.37 and / 900.14; D65 of CIE 15 has 49.98, 63.38 and, its peak at
# 460 nm, 117.81
LEFT_OUT = [
    ("AM0", "has 1347.93 W/m2 over 280-4000 nm, of 1366.1 W/m2"),
    ("AM1.5G", "has 1000.37 W/m2 over 280-4000 nm; less than 1.8 % is beyond"),
    ("sun", "less than 1.8 % is beyond"),
    ("AM1.5D", "has 900.139 W/m2 over 280-4000 nm; less than 2 % is beyond"),
    ("A", "carries a tenth of what a 2856 K body radiates"),
    ("D65", "(42 % of its peak at 380 nm, 54 % of its peak at 780 nm): watts beyond"),
    ("cut.csv", "cut.csv does not end near 0 (50 % of its peak at 700 nm): watts beyond"),
    *[(text, "") for text in ("LED-B3", "whole.csv", "blackbody:2856K", "gaussian:555nm,50nm")],
    *[(text, "") for text in ("line:555nm", "band:500nm:600nm")],
]


@pytest.mark.parametrize(("text", "left_out"), LEFT_OUT)
def test_what_a_spectrum_leaves_out_is_noted_where_watts_count(text, left_out, tmp_path):
    (tmp_path / "cut.csv").write_text("nm,W\n400,0.04\n500,1\n600,2\n700,1\n")
    (tmp_path / "whole.csv").write_text("nm,W\n400,0\n500,1\n600,2\n700,0.09\n")
    text = str(tmp_path / text) if text.endswith(".csv") else text
    calls = [
        (("convert", "1000", "W/m2", "lx"), True),
        (("convert", "1000", "lx", "W/m2"), True),
        (("convert", "1000", "W/m2", "umol/m2/s"), True),
        (("point-source", "--flux", "5W", "--distance", "2m", "-g", "illuminance:lx"), True),
        (("convert", "1000", "lx", "umol/m2/s"), False),
        (("convert", "1000", "W/m2", "lx", "--range", "450nm:650nm"), False),
    ]
    calls += [(("spectrum", "-g", "luminous-efficacy"), True), (("spectrum", "-g", "x"), False)]
    for words, counts_watts in calls:
        given = [text] if words[0] == "spectrum" else ["--spectrum", text]
        notes = run(*words, *given).stderr
        assert ((left_out or "watts beyond") in notes) == (counts_watts and bool(left_out)), words
