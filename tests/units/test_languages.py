"""Units by their Czech and Russian names, in the grammatical cases used after numbers."""

import unicodedata
from itertools import product

import pytest
from helpers import for_each

from radcalc.errors import UnitError
from radcalc.units import lookup
from radcalc.units.languages import LANGUAGES, in_english
from radcalc.units.table import resolve, unit_of

# Typed by hand: the name in the language, and the unit in symbols.
WRITTEN = [
    ("люкс", "lx"),
    ("Люкс", "lx"),
    ("люкса", "lx"),
    ("люксов", "lx"),
    ("килолюксов", "klx"),
    ("люмен", "lm"),
    ("люменов", "lm"),
    ("кандела", "cd"),
    ("канделы", "cd"),
    ("кандел", "cd"),
    ("ватт", "W"),
    ("ватта", "W"),
    ("киловатт", "kW"),
    ("милливатт", "mW"),
    ("джоуль", "J"),
    ("джоулей", "J"),
    ("метр", "m"),
    ("метров", "m"),
    ("нанометров", "nm"),
    ("стерадиан", "sr"),
    ("нит", "nit"),
    ("моль", "mol"),
    ("микромоль", "umol"),
    ("фотонов", "photon"),
    ("секунд", "s"),
    ("часов", "h"),
    ("герц", "Hz"),
    ("терагерц", "THz"),
    ("электронвольт", "eV"),
    ("электрон-вольт", "eV"),
    ("киловатт-час", "kWh"),
    ("люмен-секунда", "lm.s"),
    ("люкс-секунд", "lx.s"),
    ("фут-ламберт", "fL"),
    ("фут-свеча", "fc"),
    ("люмен на квадратный метр", "lm/m2"),
    ("люмен на метр квадратный", "lm/m2"),
    ("кандела на кв. метр", "cd/m2"),
    ("лм/кв.м", "lm/m2"),
    ("ватт на квадратный сантиметр", "W/cm2"),
    ("ватт на стерадиан", "W/sr"),
    ("микромоль на квадратный метр в секунду", "umol/m2/s"),
    ("lux", "lx"),
    ("luxů", "lx"),
    ("LUXU", "lx"),
    ("kiloluxů", "klx"),
    ("lumenů", "lm"),
    ("kandela", "cd"),
    ("kandel", "cd"),
    ("milikandely", "mcd"),
    ("wattů", "W"),
    ("miliwatt", "mW"),
    ("mikrowattů", "uW"),
    ("joulů", "J"),
    ("metrů", "m"),
    ("milimetr", "mm"),
    ("steradiánů", "sr"),
    ("fotonů", "photon"),
    ("molů", "mol"),
    ("mikromol", "umol"),
    ("hodin", "h"),
    ("stupňů", "deg"),
    ("lumensekunda", "lm.s"),
    ("lumensekund", "lm.s"),
    ("luxsekunda", "lx.s"),
    ("watthodin", "Wh"),
    ("lumen na metr čtvereční", "lm/m2"),
    ("lumenů na čtvereční metr", "lm/m2"),
    ("kandela na metr čtvereční", "cd/m2"),
    ("W/metr čtvereční", "W/m2"),
    ("mikromolů na metr čtvereční za sekundu", "umol/m2/s"),
]


@for_each(WRITTEN)
def test_a_name_is_read_as_the_unit_of_its_symbol(name, symbols):
    expected = resolve(symbols)
    for text in (name, unicodedata.normalize("NFD", name), f" {name} "):
        unit = resolve(text)
        assert unit.dimension == expected.dimension
        assert unit.top * expected.bottom == expected.top * unit.bottom
        assert unit.text == text.strip()


def test_no_form_means_another_unit_in_english_or_in_the_other_language():
    readings: dict[str, set[str]] = {}
    for prefixes, units in LANGUAGES:
        for (prefix, power), (form, name) in product([("", ""), *prefixes.items()], units.items()):
            meant = lookup(power + name)
            if meant:
                english = lookup(prefix + form)
                assert english in (None, meant), prefix + form
                readings.setdefault(prefix + form, set()).add(power + name)
    assert len(readings) > 5000
    assert {form: names for form, names in readings.items() if len(names) > 1} == {}


@pytest.mark.parametrize(
    "text",
    [
        "люмен квадратный метр",  # either of the two may be squared
        "metr čtvereční steradián",
        "килоlux",
        "мегафотон",
        "люксс",
        "na",
        "в",
        "люмен на",
        "метр2 квадратный",
        "lumen na metr čtvereční steradián",
        "стоп",
    ],
)
def test_a_text_that_is_not_a_unit_in_any_language_is_refused(text):
    with pytest.raises(UnitError) as refused:
        resolve(text)
    assert refused.value.hint


@pytest.mark.parametrize("text", ["svíčka", "svíček", "свеча", "свечей"])
def test_a_candle_has_several_values_in_every_language(text):
    with pytest.raises(UnitError, match="not accepted") as refused:
        resolve(text)
    assert "candela" in refused.value.hint


def test_a_misspelt_name_is_refused_with_similar_ones():
    with pytest.raises(UnitError, match="unknown unit 'люменн'") as refused:
        resolve("люменн")
    assert "люмен" in refused.value.hint


def test_english_is_unchanged():
    for text in ("lm/m2", "photon", "W m-2", "lumen per square metre", "zork"):
        assert (
            in_english(text, unit_of) == ""
            or resolve(text).dimension == resolve(in_english(text, unit_of)).dimension
        )
