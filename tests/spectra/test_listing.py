"""List of the named spectra."""

import pytest

from radcalc.errors import UsageError
from radcalc.quantities.language import LANGUAGES
from radcalc.spectra.listing import LAMPS, PATTERNS, described, search, temperature_and_ratio
from radcalc.spectra.sources import names

# Correlated colour temperatures [K] of CIE 15:2018, tables T.3 to T.12, and of the black body of
# illuminant A; lux per umol/m2/s of E: Km times the 106.857 nm of V(lambda) over the photons of
# 300 nm about 550 nm, 683.002 x 106.857 / (300 x 550 / 119.62656564).
CIE = {"A": 2856, "C": 6774, "D50": 5003, "D65": 6504, "E": 5455, "FL1": 6430, "FL2": 4230,
       "FL4": 2940, "FL7": 6500, "FL11": 4000, "FL12": 3000, "HP1": 1959, "HP2": 2506,
       "LED-B1": 2733, "LED-B3": 4103, "LED-B5": 6598, "LED-V1": 2724, "ID65": 6598}  # fmt: skip


@pytest.mark.parametrize(("name", "temperature"), CIE.items())
def test_the_colour_temperature_agrees_with_the_cie(name, temperature):
    assert temperature_and_ratio(name)[0] == pytest.approx(temperature, rel=2e-3)


def test_lux_per_ppfd_counts_photons_from_400_to_700_nm():
    assert temperature_and_ratio("E")[1] == pytest.approx(
        683.002 * 106.857 / (300 * 550 / 119.62656564), rel=1e-4
    )


def test_a_colour_temperature_may_be_missing():
    assert temperature_and_ratio("ISO 7589 Sensitometric Printer")[0] is None


def test_every_kind_is_used_and_named_in_every_language():
    used = {one.kind for one in search()}
    assert used - {None} == set(range(len(LAMPS)))
    assert all(len(row) == 1 + len(LANGUAGES) and all(row) for row in LAMPS)
    assert len(PATTERNS) == len(LAMPS)
    without = [one.name for one in search() if one.kind is None]
    assert without == ["ISO 7589 Sensitometric Printer", "Natural", "Kinoton 75P"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("sun", ["B", "AM0", "AM1.5G", "AM1.5D"]),
        ("Slunce", ["AM0", "AM1.5G", "AM1.5D"]),
        ("натриевая низкого", ["LPS"]),
        ("nizkotlaka", ["LPS"]),
        ("led red", ["LED-BH1"]),
        ("mercury dx", ["H38JA-100/DX (Mercury DX)"]),
    ],
)
def test_a_spectrum_is_found_by_its_name_and_its_kind_in_three_languages(text, expected):
    assert [one.name for one in search(text)] == expected


def test_all_spectra_are_listed_and_described_in_order():
    assert [one.name for one in search(" ")] == names()
    assert dict(described(search("LPS"))) == {"LPS": "1720 K, low-pressure sodium"}


@pytest.mark.parametrize("text", ["zork", "LED zork", "-", "\ud800"])
def test_an_unknown_word_is_refused_with_a_hint(text):
    with pytest.raises(UsageError) as caught:
        search(text)
    assert caught.value.hint
