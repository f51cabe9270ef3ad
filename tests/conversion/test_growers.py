"""Words of growers: ppfd, ppf, dli and par, by the arithmetic of their definitions."""

import pytest
from conftest import run
from helpers import for_each

import radcalc
from radcalc.errors import ConditionError, MissingCondition, RadcalcError, UnitError
from radcalc.units.table import GROWERS_WORDS, unit_of

# micromoles per second times the seconds of light in a day
DAYS = [
    (600, "16h", 600e-6 * 16 * 3600),
    (1000, "12h", 43.2),
    (200, "24h", 17.28),
    (350, "1000 min", 350e-6 * 60000),
]


@for_each(DAYS)
def test_a_daily_light_integral_is_the_ppfd_times_the_photoperiod(ppfd, hours, moles):
    found = radcalc.convert(f"{ppfd} ppfd", "dli", photoperiod=hours)
    assert found.to("mol/m2").magnitude == pytest.approx(moles, rel=1e-14)
    assert radcalc.convert(f"{ppfd} ppfd", "dli", time=hours) == found
    back = radcalc.convert(f"{moles!r} dli", "ppfd", photoperiod=hours)
    assert back.to("umol/m2/s").magnitude == pytest.approx(ppfd, rel=1e-14)


def test_a_rate_per_day_counts_24_hours():
    # 86400 s in a day
    found = radcalc.explain("600 ppfd", "mol/m2/d")
    assert found.photon_irradiance.magnitude == pytest.approx(600e-6 * 86400, rel=1e-14)
    assert any("over 24 h" in note for note in found.notes)
    for value, target in (("20 dli", "mol/m2/d"), ("20 mol/m2/day", "dli")):
        assert radcalc.convert(value, target).magnitude == pytest.approx(20, rel=1e-14)
        found = radcalc.explain(value, target)
        assert found.assumptions == ("the rate is the mean of a day, over 24 h",)


@for_each(["ppfd", "PPFD", "ppf", "dli", "DLI"])
def test_a_word_is_a_unit_of_values_alone(word):
    unit, _, note = GROWERS_WORDS[word.lower()]
    of_word, of_unit = (radcalc.convert(f"7 {text}", unit) for text in (word, unit))
    assert of_word == of_unit
    assert unit_of(word) is None  # in titles of columns it is the name of a quantity
    assert note in radcalc.explain(f"7 {word}", unit).notes


def test_lists_streams_and_calculators_take_the_words():
    words = ("600ppfd,700ppfd", "dli", "--photoperiod", "16h", "-n")
    assert run(*words).stdout == "34.56\n40.32\n"
    numbers = run("convert", "-", "ppfd", "dli", "--photoperiod", "16h", input="600\n700\n")
    assert numbers.stdout == "34.56\n40.32\n"
    found = radcalc.point_source(irradiance="700ppfd", distance="2 m")
    assert found.photon_intensity.to("umol/s/sr").magnitude == pytest.approx(2800, rel=1e-14)


def test_a_photoperiod_is_missing_with_three_proposals():
    with pytest.raises(MissingCondition, match="the time of light in a day is missing") as caught:
        radcalc.convert("600 ppfd", "dli")
    for hours in (12, 16, 18):
        assert f'radcalc.convert("600 ppfd", "dli", photoperiod="{hours} h")' in caught.value.hint


@for_each([{"photoperiod": "25h"}, {"time": "25h"}, {"photoperiod": "0h"}])
def test_a_day_has_24_hours(given):
    with pytest.raises(ConditionError, match="out of range"):
        radcalc.convert("600 ppfd", "dli", **given)


@for_each([("700 par", "lx"), ("100 klx", "par"), ("100 klx", "PAR")])
def test_par_is_photons_or_watts(value, target):
    with pytest.raises(UnitError, match="is ambiguous: photons") as caught:
        radcalc.convert(value, target, spectrum="sun")
    assert "ppfd" in caught.value.hint
    assert "W/m2" in caught.value.hint


@for_each([{"wavelength": "850 nm"}, {"spectrum": "sun", "photon_range": "380nm:780nm"}])
def test_a_ppfd_has_no_photons_beyond_its_range(given):
    with pytest.raises(RadcalcError, match="from 400 nm to 700 nm only"):
        radcalc.convert("700 ppfd", "W/m2", **given)
