"""Words of growers: ppfd, ppf, dli and par, by the arithmetic of their definitions."""

import pytest
from conftest import run
from helpers import for_each

import radcalc
from radcalc.errors import ConditionError, MissingCondition, RadcalcError, UnitError
from radcalc.spectra.observers import OBSERVERS, lumens_per_photon, luminous_efficacy
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


# 1e6 / N_A photons of h c / wavelength are the wavelength in nm / 119.626566 umol/J; with
# K_m = 683.002 lm/W and V of CIE 018:2019, at 400 nm 683.002 * 0.000396 / 3.343745 lm s/umol
PER_NM = 1e-9 / (6.62607015e-34 * 299792458 * 6.02214076e23) * 1e6
AT_400 = 683.002 * 0.000396 / (400 * PER_NM)
LEAST, MOST = 400 * PER_NM, 700 * PER_NM
BOUNDS = [("W/m2", "umol/J", MOST, 1), ("lx", "lm.s/umol", AT_400, -1)]


@for_each(BOUNDS)
def test_an_efficacy_of_no_light_from_400_to_700_nm_is_refused_for_a_ppfd(unit, of, bound, sign):
    """In each order of the ratio, the call, the sentence, the stream, Python and arrays."""
    over, _, under = of.rpartition("/")
    for word in ("ppfd", "PPFD"):
        for text, is_good in (
            (f"{bound * (1 - sign * 1e-6):.9g}{of}", True),
            (f"{bound * (1 + sign * 1e-3):.9g}{of}", False),
            (f"{1 / bound / (1 - sign * 1e-6):.9g}{under}/({over})", True),
            (f"{1 / bound / (1 + sign * 1e-3):.9g}{under}/({over})", False),
        ):
            for words in ([unit, word], [word, unit]):
                done = run("convert", "100", *words, "--efficacy", text)
                piped = run("convert", "-", *words, "--efficacy", text, input="100\n")
                for outcome in (done, piped):
                    assert outcome.returncode == (0 if is_good else 2), outcome
                    assert is_good or "photons from 400 nm to 700 nm, whose light" in outcome.stderr
    wrong = f"{bound * (1 + sign * 1e-3):.9g}"
    sentence = run(f"100 {unit} at {wrong}{of} to ppfd")
    assert (sentence.returncode, "whose light gives" in sentence.stderr) == (2, True)
    values = radcalc.Quantity([bound, float(wrong)], of)
    with pytest.raises(ConditionError, match="whose light gives"):
        radcalc.convert(f"100 {unit}", "ppfd", efficacy=values)


def test_other_photons_and_electrical_watts_are_noted():
    for efficacy, target, part, is_noted in (
        ("20 umol/J", "umol/m2/s", "outside 3.34374 to 5.85154 umol/J", True),
        ("2.1 umol/J", "ppfd", "the watts include other light, or are electrical", True),
        ("4.6 umol/J", "ppfd", "umol/J", False),
    ):
        notes = radcalc.explain("100 W/m2", target, efficacy=efficacy).notes
        assert any(part in note for note in notes) == is_noted
    done = run("convert", "100", "lx", "umol/m2/s", "--efficacy", "0.05lm.s/umol")
    assert done.stdout.split()[0] == "2000"
    assert "outside 0.0808881 to 147.805 lm s/umol" in done.stderr


@for_each(OBSERVERS)
def test_the_bounds_of_lumens_per_photon_are_those_of_the_table(eye):
    """The extremes of K_m V(lambda) h c N_A / lambda over each 1 nm of the observer's table."""
    observer = OBSERVERS[eye]
    places = range(400, 701)
    per_umol = [luminous_efficacy(nm * 1e-9, observer) / (nm * PER_NM) for nm in places]
    found = [one * 6.02214076e17 for one in lumens_per_photon(observer, (400.0, 700.0))]
    assert found == pytest.approx([min(per_umol), max(per_umol)], rel=1e-12)
