"""Spellings and misspellings of units."""

from fractions import Fraction
from itertools import pairwise

import pytest
from helpers import for_each

from radcalc.errors import UnitError
from radcalc.units import compiled, lookup
from radcalc.units.table import resolve


@pytest.mark.parametrize(
    "spelling",
    ["kinch", "kkg", "klumens", "millift", "lms", "LX", "Lm", "kлм", "лmм", "mfoot", "dd", "xlm",
     "kh", "W²m", "photonn", "mkm"],
)  # fmt: skip
def test_an_undefined_spelling_is_unknown(spelling):
    assert lookup(spelling) is None
    with pytest.raises(UnitError) as caught:
        resolve(spelling)
    assert caught.value.hint


@pytest.mark.parametrize(
    ("spelling", "suggestion"),
    [
        ("LX", "lx"),
        ("KLM", "klm"),
        ("lumins", "lumens"),
        ("candel", "candela"),
        ("footcandel", "footcandle"),
        ("w", "W"),
        ("stearadian", "steradian"),
    ],
)
def test_a_misspelt_unit_is_refused_with_the_nearest(spelling, suggestion):
    with pytest.raises(UnitError) as caught:
        resolve(spelling)
    assert suggestion in caught.value.hint


@for_each(sorted(compiled.REFUSED))
def test_a_disputed_name_is_refused_and_its_choices_exist(name):
    with pytest.raises(UnitError, match="not accepted") as caught:
        resolve(name)
    for word in caught.value.hint.replace(",", " ").split():
        if "_" in word:
            resolve(word)


@pytest.mark.parametrize(
    "unit",
    ["cal", "Btu", "cp", "ph", "L", "mL", "td", "sp", "year", "pyron", "finsen"],
)
def test_a_unit_with_several_meanings_notes_the_one_assumed(unit):
    assert resolve(unit).notes


@pytest.mark.parametrize(
    "words",
    [
        ("lx", "lux", "Lux", "LUX", "luxes", "лк"),
        ("fc", "ftc", "footcandle", "foot-candle", "Foot-Candles", "foot_candle"),
        ("fL", "ftL", "foot-lambert", "footlamberts"),
        ("klm", "kilolumen", "Kilolumens", "kilo-lumen", "клм"),
        ("µmol", "umol", "μmol", "micromole", "мкмоль"),
        ("Å", "Å", "angstrom", "Angstroms"),
        ("°", "deg", "degree", "degrees"),
        ("Вт/м²", "W/m2", "watts per square metre", "Watt per square meter"),
        ("uE/m2/s", "umol/m2/s", "µE m-2 s-1"),
        ("cm-1", "1/cm", "/cm", "cm^-1", "kayser"),
    ],
)
def test_spellings_of_one_unit_agree(words):
    units = [resolve(word) for word in words]
    for one, other in pairwise(units):
        assert Fraction(one.top, one.bottom) == Fraction(other.top, other.bottom)
        assert one.dimension == other.dimension


def test_a_wavenumber_is_distinguished_from_a_length():
    per_kayser = resolve("W/m2/cm-1")
    assert per_kayser.dimension == resolve("W/m2/kayser").dimension
    assert per_kayser.dimension != resolve("W/m").dimension
    assert "wavenumber" in per_kayser.notes[0]
    assert resolve("W cm-2 sr-1 um-1").dimension == resolve("flick").dimension


@pytest.mark.parametrize("text", ["J/kg/°C", "J/(kg degC)", "J kg-1 celsius-1", "J/kg/℃"])
def test_a_degree_celsius_in_a_product_is_a_difference(text):
    """SI Brochure: the unit degree Celsius is equal in size to the kelvin."""
    unit, coherent = resolve(text), resolve("J/kg/K")
    assert (unit.dimension, unit.factor) == (coherent.dimension, coherent.factor)
    assert "a difference" in unit.notes[0]


@pytest.mark.parametrize("text", ["°C", "celsius", "J/kg/°F"])
def test_a_degree_alone_is_refused(text):
    with pytest.raises(UnitError, match="not accepted"):
        resolve(text)


def test_a_volt_times_an_ampere_is_a_watt():
    """SI Brochure, table 4: V = W/A."""
    power, watt = resolve("mV.kA"), resolve("W")
    assert (power.factor, power.dimension) == (watt.factor, watt.dimension)


def test_an_ampere_is_not_an_angstrom():
    assert resolve("A").dimension != resolve("angstrom").dimension
    with pytest.raises(UnitError, match="not accepted"):
        resolve("a")


# The products that lecture notes write without signs, with their signs (SI Brochure, 5.4.1).
JOINED = {
    "Wm-2": "W/m2",
    "Js-1": "W",
    "J/kgK": "J/(kg K)",
    "Jkg-1K-1": "J/(kg K)",
    "W/m2sr": "W/(m2 sr)",
    "Wm-2sr-1": "W/(m2 sr)",
    "Wm⁻²sr⁻¹": "W/(m2 sr)",
    "Wm^-2nm^-1": "W/(m2 nm)",
    "umol/m2s": "umol/(m2 s)",
    "µmolm-2s-1": "umol/(m2 s)",
    "kgm2s-3": "W",
    "cdm-2": "cd/m2",
    "Втм-2": "W/m2",
}


@pytest.mark.parametrize("text", JOINED)
def test_units_written_together_are_a_product(text):
    unit, signed = resolve(text), resolve(JOINED[text])
    assert (unit.factor, unit.dimension) == (signed.factor, signed.dimension)
    assert any("is read as" in note for note in unit.notes)


@pytest.mark.parametrize("text", ["lmW-1", "lmm-2"])
def test_units_written_together_in_two_ways_are_refused(text):
    with pytest.raises(UnitError, match="ambiguous"):
        resolve(text)


@pytest.mark.parametrize("text", ["Wm", "lmlx", "m-2m", "Wmsr", "W/m2srr"])
def test_letters_without_an_exponent_are_not_a_product(text):
    with pytest.raises(UnitError):
        resolve(text)
