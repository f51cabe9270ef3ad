"""The language of names, and quantities with their names in it."""

import pytest
from helpers import for_each

from radcalc.quantities.language import LANGUAGES, language, translate
from radcalc.quantities.names import LABELS, PARTS, QUANTITIES
from radcalc.quantities.symbols import INNER, QUANTITY, SYMBOLS


@pytest.mark.parametrize(
    ("variables", "expected"),
    [
        ({}, "en"),
        ({"LANG": "cs_CZ.UTF-8"}, "cs"),
        ({"LANG": "ru_RU"}, "ru"),
        ({"LANG": "cs"}, "cs"),
        ({"LANG": "ru@latin"}, "ru"),
        ({"LANG": "cs.UTF-8"}, "cs"),
        ({"LANG": "en_GB.UTF-8"}, "en"),
        ({"LANG": "de_DE.UTF-8"}, "en"),
        ({"LANG": "csb_PL.UTF-8"}, "en"),
        ({"LANG": "C"}, "en"),
        ({"LANG": "C.UTF-8"}, "en"),
        ({"LANG": "POSIX"}, "en"),
        ({"LANG": ""}, "en"),
        ({"LANG": "cs_CZ.UTF-8", "LC_MESSAGES": "ru_RU.UTF-8"}, "ru"),
        ({"LANG": "cs_CZ.UTF-8", "LC_MESSAGES": "en_US.UTF-8"}, "en"),
        ({"LANG": "cs_CZ.UTF-8", "LC_MESSAGES": ""}, "cs"),
        ({"LANG": "cs_CZ.UTF-8", "LC_ALL": "C"}, "en"),
        ({"LANG": "C", "LC_MESSAGES": "C", "LC_ALL": "ru_RU.UTF-8"}, "ru"),
        ({"LANG": "C", "LC_CTYPE": "cs_CZ.UTF-8"}, "en"),
    ],
)
def test_the_language_follows_the_locale_of_messages(variables, expected, monkeypatch):
    for name in ("LC_ALL", "LC_MESSAGES", "LC_CTYPE", "LANG"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert language() == expected


@pytest.mark.parametrize(
    ("label", "cs", "ru"),
    [
        ("luminous flux", "světelný tok", "световой поток"),
        ("illuminance", "osvětlenost", "освещённость"),
        ("solid angle", "prostorový úhel", "телесный угол"),
        ("distance", "vzdálenost", "расстояние"),
        (
            "spectral irradiance (per wavelength)",
            "spektrální ozářenost (podle vlnové délky)",
            "спектральная плотность энергетической освещённости (по длине волны)",
        ),
        ("photon exitance", "photon exitance", "photon exitance"),
        ("sphere fraction", "sphere fraction", "sphere fraction"),
        ("light output ratio", "účinnost svítidla", "КПД светильника"),
        (
            "downward luminous flux",
            "světelný tok do dolního poloprostoru",
            "световой поток в нижнюю полусферу",
        ),
        ("mean illuminance", "průměrná osvětlenost", "средняя освещённость"),
        ("mean photon exitance", "mean photon exitance", "mean photon exitance"),
        ("", "", ""),
    ],
)
def test_a_label_is_translated_if_there_is_a_name(label, cs, ru):
    assert [translate(label, one) for one in LANGUAGES] == [label, cs, ru]


# Letters, and quantities without an established name.
IN_ENGLISH = {"x", "y", "z", "photon exitance", "photon exposure"}
OF_WEIGHTS = ("melanopic", "rhodopic", "s-cone", "m-cone", "l-cone", "weighted light", "red to")
IN_ENGLISH |= {
    symbol.label
    for symbol in SYMBOLS.values()
    if symbol.label.startswith((*OF_WEIGHTS, "actinic", "blue-light", "spectral mismatch"))
}
SHOWN = sorted(
    {
        symbol.label
        for symbol in SYMBOLS.values()
        if symbol.form == QUANTITY and symbol.name not in INNER and symbol.name != symbol.generic
    }
)


@for_each(SHOWN)
def test_every_label_shown_has_a_name_in_every_language(label):
    assert (translate(label, "ru") == label) == (label in IN_ENGLISH)


def test_every_label_has_both_translations():
    for label, names in (LABELS | PARTS).items():
        assert len(names) == 2
        assert all(names), label
        assert label not in {name for q in QUANTITIES for name in q.names("en")}
