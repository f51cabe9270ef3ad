"""The names of the quantities: the grid, the search, the language."""

import os
import unicodedata

import pytest
from conftest import run

from radcalc.cli.output import decide
from radcalc.errors import RadcalcError
from radcalc.quantities.language import LANGUAGES, language, translate
from radcalc.quantities.light import name_of, symbol_of
from radcalc.quantities.names import LABELS, MISNOMERS, QUANTITIES
from radcalc.quantities.search import search
from radcalc.units.table import resolve

# Typed from the vocabularies by hand, apart from the data: symbol, English, Czech, Russian.
GRID = [
    ("Q_e", "radiant energy", "zářivá energie", "энергия излучения"),
    ("Q_v", "luminous energy", "světelné množství", "световая энергия"),
    ("Φ_e", "radiant flux", "zářivý tok", "поток излучения"),
    ("Φ_v", "luminous flux", "světelný tok", "световой поток"),
    ("I_e", "radiant intensity", "zářivost", "сила излучения"),
    ("I_v", "luminous intensity", "svítivost", "сила света"),
    ("E_e", "irradiance", "ozářenost", "энергетическая освещённость"),
    ("E_e", "irradiance", "ozářenost", "облучённость"),
    ("E_v", "illuminance", "osvětlenost", "освещённость"),
    ("M_e", "radiant exitance", "intenzita vyzařování", "энергетическая светимость"),
    ("M_e", "radiosity", "intenzita vyzařování", "энергетическая светимость"),
    ("M_v", "luminous exitance", "světlení", "светимость"),
    ("L_e", "radiance", "zář", "энергетическая яркость"),
    ("L_v", "luminance", "jas", "яркость"),
    ("H_e", "radiant exposure", "ozáření", "энергетическая экспозиция"),
    ("H_e", "radiant exposure", "dávka", "энергетическая экспозиция"),
    ("H_v", "luminous exposure", "osvit", "световая экспозиция"),
    ("Q_p", "photon number", "počet fotonů", "число фотонов"),
    ("Φ_p", "photon flux", "fotonový tok", "поток фотонов"),
    ("I_p", "photon intensity", "fotonová zářivost", "сила излучения фотонов"),
    ("E_p", "photon irradiance", "fotonová ozářenost", "облучённость фотонов"),
    ("L_p", "photon radiance", "fotonová zář", "яркость фотонов"),
    ("Ω", "solid angle", "prostorový úhel", "телесный угол"),
]
NAMES = [
    (q.symbol, one, name) for q in QUANTITIES for one in LANGUAGES for name in q.names(one)
]  # fmt: skip


def symbols(text: str) -> list[str]:
    return [found.quantity.symbol for found in search(text)]


def bare(text: str) -> str:
    """The text without its diacritics, as it is typed on another keyboard."""
    parts = unicodedata.normalize("NFD", text)
    return "".join(c for c in parts if unicodedata.category(c) != "Mn")


@pytest.mark.parametrize(("symbol", "en", "cs", "ru"), GRID)
def test_the_data_have_the_names_of_the_vocabularies(symbol, en, cs, ru):
    quantity = next(q for q in QUANTITIES if q.symbol == symbol)
    assert en in quantity.names("en")
    assert cs in quantity.names("cs")
    assert ru in quantity.names("ru")


@pytest.mark.parametrize(("symbol", "language", "name"), NAMES)
def test_every_quantity_is_found_by_each_of_its_names(symbol, language, name):
    decomposed = unicodedata.normalize("NFD", name)
    for typed in (name, bare(name), decomposed):
        for text in (typed, typed.upper(), typed.title(), f"  {typed} ", typed.replace(" ", "-")):
            assert symbol in symbols(text), text


def test_no_name_stands_for_two_quantities():
    for one in LANGUAGES:
        names = [bare(name.casefold()) for _, known, name in NAMES if known == one]
        assert len(names) == len(set(names))
    assert len({q.symbol for q in QUANTITIES}) == len(QUANTITIES)


@pytest.mark.parametrize("quantity", QUANTITIES, ids=lambda q: q.symbol)
def test_a_quantity_is_found_by_its_symbol_and_its_unit(quantity):
    spellings = {quantity.symbol, quantity.symbol.replace("_", ""), f"${quantity.symbol}$"}
    spellings |= {s.replace("Φ", "Phi").replace("Ω", "Omega").replace("λ", "lambda")
                  for s in spellings}  # fmt: skip
    for spelling in spellings:
        assert quantity.symbol in symbols(spelling), spelling
    if quantity.unit != "1":
        assert quantity.symbol in symbols(quantity.unit)


@pytest.mark.parametrize("quantity", QUANTITIES, ids=lambda q: q.symbol)
def test_names_and_symbols_are_those_of_the_units(quantity):
    unit = resolve(quantity.unit)
    if quantity.symbol[0] in "MηV" or quantity.symbol == "Ω_p":
        return  # they share the dimension of another quantity
    axis = " (per wavelength)" if "λ" in quantity.symbol else ""
    assert name_of(unit) == quantity.name("en") + axis
    assert symbol_of(unit) == quantity.symbol


def test_definitions_are_one_line_each():
    for quantity in QUANTITIES:
        assert quantity.definition.endswith(".")
        assert len(quantity.definition) < 80


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("E_v", ["E_v"]),
        ("Ev", ["E_v"]),
        ("ev", ["E_v"]),
        ("E_{v}", ["E_v"]),
        ("Eᵥ", ["E_v"]),
        ("Phi_v", ["Φ_v"]),
        ("φ_v", ["Φ_v"]),
        (r"\Phi_e", ["Φ_e"]),
        ("Φ", ["Φ_e", "Φ_v", "Φ_p"]),
        ("E", ["E_e", "E_v", "E_p"]),
        ("L_lambda", ["L_e,λ"]),
        ("V(lambda)", ["V(λ)"]),
        ("lx", ["E_v"]),
        ("klx", ["E_v"]),
        ("лк", ["E_v"]),
        ("lm/m2", ["E_v", "M_v"]),
        ("radlux", ["M_v"]),
        ("fc", ["E_v"]),
        ("cd/m2", ["L_v"]),
        ("nit", ["L_v"]),
        ("Вт/м²", ["E_e", "M_e"]),
        ("umol/m2/s", ["E_p", "M_p"]),
        ("lm/W", ["K", "η_v"]),
        ("spectral", ["Φ_e,λ", "I_e,λ", "E_e,λ", "M_e,λ", "L_e,λ"]),
        ("светов", ["Q_v", "Φ_v", "H_v", "K", "η_v", "V(λ)"]),
        ("flux luminous", ["Φ_v"]),
        ("radiance (W/m2/sr)", ["L_e"]),
        ("etendue", ["G"]),
    ],
)
def test_a_search_finds_these(text, expected):
    assert symbols(text) == expected


@pytest.mark.parametrize(
    ("text", "right", "said"),
    [
        ("svítivost", "L_v", "luminance"),
        ("SVITIVOST", "L_v", "luminance"),
        ("luminosity", "M_v", "luminous exitance"),
        ("luminosity", "Φ_e", "astronomer"),
        ("radiosity", "M_e", "radiant exitance"),
        ("intensity", "E_e", "physics"),
        ("light intensity", "I_v", "cd"),
        ("light intensity", "E_v", "lx"),
        ("světelný tok [W]", "Φ_e", "measured in lm"),
        ("svetelny tok W", "Φ_e", "measured in lm"),
        ("световой поток [Вт]", "Φ_e", "measured in lm"),
        ("radiance in W m^-1 sr^-1", "L_e", "W/m2/sr"),
        ("W·m⁻¹·sr⁻¹", "L_e", "W/m2/sr"),
        ("Вт/(м ср)", "L_e", "W/m2/sr"),
        ("Ст", "Ω", "stokes"),
        ("svítivost [cd/m2]", "L_v", "luminance"),
        ("intensity [W/m2]", "E_e", "irradiance"),
        ("brightness", "L_v", "felt"),
        ("PPFD", "E_p", "400 nm"),
        ("W/m2/Hz", "E_e", "per frequency"),
        ("lm/m", "Φ_v", "per length"),
    ],
)
def test_a_misnomer_is_answered_with_the_right_term_and_a_note(text, right, said):
    notes = {found.quantity.symbol: found.note for found in search(text)}
    assert said in notes[right]


def test_the_right_use_of_a_misnomer_comes_first():
    assert symbols("svítivost") == ["I_v", "L_v"]
    assert search("svítivost")[0].note == ""
    assert symbols("intensity") == ["I_e", "I_v", "I_p", "I_e,λ", "E_e"]
    assert symbols("svítivost [cd]") == ["I_v"]


def test_every_misnomer_is_found_and_explained():
    for terms, symbol, note in MISNOMERS:
        for term in terms:
            assert note in {f.note for f in search(term) if f.quantity.symbol == symbol}


@pytest.mark.parametrize(
    ("text", "message", "hint"),
    [
        ("luminanse", "no quantity is called 'luminanse'", "luminance"),
        ("svitivsot", "no quantity is called", "svítivost"),
        ("яркасть", "no quantity is called", "яркость"),
        ("zork", "no quantity is called 'zork'", "radcalc quantities, which lists them all"),
        ("kg", "'kg' measures mass", "radcalc quantities"),
        ("%", "no quantity is called '%'", "radcalc quantities"),
        ("[]", "no quantity is called", "radcalc quantities"),
        ("[/bold]", "no quantity is called", ""),
        ("x" * 100_000, "no quantity is called", ""),
        ("lx " * 66, "no quantity is called", ""),
    ],
)
def test_what_is_not_found_is_refused_with_the_nearest_names(text, message, hint):
    with pytest.raises(RadcalcError) as refused:
        search(text)
    assert message in refused.value.message
    assert hint in refused.value.hint
    assert refused.value.hint


def test_the_command_exits_2_where_nothing_is_found():
    done = run("quantities", "luminanse")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.splitlines()[1].startswith("try: luminance")
    done = run("quantities", "-n")
    assert done.returncode == 2
    assert "-n has no use with quantities" in done.stderr


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
def test_the_language_is_that_of_the_locales_messages(variables, expected, monkeypatch):
    for name in ("LC_ALL", "LC_MESSAGES", "LC_CTYPE", "LANG"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert language() == expected


def test_only_tables_follow_the_locale(monkeypatch):
    monkeypatch.setenv("LC_ALL", "cs_CZ.UTF-8")
    spoken = [decide(f, False, False, None, "auto", False).language
              for f in ("table", "plain", "json", "csv")]  # fmt: skip
    assert spoken == ["cs", "en", "en", "en"]


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
        ("", "", ""),
    ],
)
def test_a_label_is_translated_where_there_is_a_name(label, cs, ru):
    assert [translate(label, one) for one in LANGUAGES] == [label, cs, ru]


def test_every_label_has_both_translations():
    for label, names in LABELS.items():
        assert len(names) == 2
        assert all(names), label
        assert label not in {name for q in QUANTITIES for name in q.names("en")}


TABLES = {
    ("convert", "100", "lx", "fc"): ("illuminance", "osvětlenost", "освещённость"),
    ("convert", "250", "cd/m2"): ("luminance", "jas", "яркость"),
    ("point-source", "--flux", "800lm", "--distance", "2m"): (
        "luminous intensity", "svítivost", "сила света",
    ),
    ("solid-angle", "cone", "--half-angle", "30deg"): (
        "solid angle", "prostorový úhel", "телесный угол",
    ),
    ("photon", "555nm"): ("wavelength", "vlnová délka", "длина волны"),
    ("units", "lambert"): ("luminance", "jas", "яркость"),
    ("typical", "sky"): ("luminance", "jas", "яркость"),
}  # fmt: skip
LOCALES = {"C": 0, "en_GB.UTF-8": 0, "cs_CZ.UTF-8": 1, "ru_RU.UTF-8": 2}


@pytest.mark.parametrize("words", TABLES, ids=" ".join)
def test_the_names_in_tables_follow_the_locale_and_nothing_else_does(words):
    english = {}
    for locale, place in LOCALES.items():
        env = os.environ | {"LC_ALL": locale, "PYTHONIOENCODING": "utf-8"}
        table = run(*words, "--format", "table", env=env)
        assert table.returncode == 0
        rows = table.stdout.split("assumed:")[0]
        assert TABLES[words][place] in rows
        assert all(name not in rows for name in TABLES[words] if name != TABLES[words][place])
        for form in ("plain", "json", "csv"):
            answer = run(*words, "--format", form, env=env)
            assert english.setdefault(form, answer.stdout) == answer.stdout
        if place == 0:
            assert english.setdefault("table", table.stdout) == table.stdout


def test_the_command_puts_the_names_of_one_language_first():
    env = os.environ | {"LC_ALL": "cs_CZ.UTF-8", "PYTHONIOENCODING": "utf-8"}
    assert run("quantities", "lx", env=env).stdout.startswith("osvětlenost\tE_v\tlx\t")
    assert run("quantities", "lx", "--lang", "ru", env=env).stdout.startswith("освещённость\t")
    assert run("quantities", "lx", "--lang", "en", env=env).stdout.startswith("illuminance\t")
    done = run("quantities", "M_p", "--lang", "ru")
    assert done.stdout.startswith("photon exitance\t")
