"""Names of quantities, and searches for them."""

import unicodedata

import pytest
from helpers import for_each

from radcalc.quantities import name_of, symbol_of
from radcalc.quantities.language import LANGUAGES
from radcalc.quantities.names import MISNOMERS, QUANTITIES
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
    # names other than the first ones
    ("E_e", "irradiance", "iradiance", "энергетическая освещённость"),
    ("M_e", "radiant exitance", "radiozita", "энергетическая светимость"),
    ("M_e", "radiant exitance", "intenzita vyzáření", "энергетическая светимость"),
    ("Ω_p", "projected solid angle", "promítnutý prostorový úhel", "проекция телесного угла"),
    ("Q_v", "luminous energy", "světelná energie", "световая энергия"),
    ("Φ_v", "luminous power", "světelný výkon", "световой поток"),
    ("Φ_e", "radiant flux", "zářivý tok", "энергетический поток"),
    ("I_e", "radiant intensity", "zářivost", "энергетическая сила излучения"),
    ("E_v", "illuminance", "osvětlenost", "световая освещённость"),
    ("L_v", "luminance", "jas", "световая яркость"),
]
NAMES = [
    (q.symbol, one, name) for q in QUANTITIES for one in LANGUAGES for name in q.names(one)
]  # fmt: skip


def symbols(text: str) -> list[str]:
    return [found.quantity.symbol for found in search(text)]


def bare(text: str) -> str:
    """Return the text without diacritics, as typed on another keyboard."""
    parts = unicodedata.normalize("NFD", text)
    return "".join(c for c in parts if unicodedata.category(c) != "Mn")


@for_each(GRID)
def test_the_data_have_the_names_of_the_vocabularies(symbol, en, cs, ru):
    quantity = next(q for q in QUANTITIES if q.symbol == symbol)
    assert en in quantity.names("en")
    assert cs in quantity.names("cs")
    assert ru in quantity.names("ru")


@for_each(NAMES)
def test_every_quantity_is_found_by_each_of_its_names(symbol, language, name):
    decomposed = unicodedata.normalize("NFD", name)
    for typed in (name, bare(name), decomposed):
        for text in (typed, typed.upper(), typed.title(), f"  {typed} ", typed.replace(" ", "-")):
            assert symbol in symbols(text), text


def test_no_name_is_shared_by_two_quantities():
    for one in LANGUAGES:
        names = [bare(name.casefold()) for _, known, name in NAMES if known == one]
        assert len(names) == len(set(names))
    assert len({q.symbol for q in QUANTITIES}) == len(QUANTITIES)


@for_each(QUANTITIES)
def test_a_quantity_is_found_by_its_symbol_and_its_unit(quantity):
    spellings = {quantity.symbol, quantity.symbol.replace("_", ""), f"${quantity.symbol}$"}
    spellings |= {s.replace("Φ", "Phi").replace("Ω", "Omega").replace("λ", "lambda")
                  for s in spellings}  # fmt: skip
    for spelling in spellings:
        assert quantity.symbol in symbols(spelling), spelling
    if quantity.unit != "1":
        assert quantity.symbol in symbols(quantity.unit)


@for_each(QUANTITIES)
def test_names_and_symbols_agree_with_those_of_the_units(quantity):
    unit = resolve(quantity.unit)
    if quantity.symbol[0] in "MηVf" or quantity.symbol in ("Ω_p", "K(λ)"):
        return  # these share the dimension of another quantity
    axis = " (per wavelength)" if "λ" in quantity.symbol else ""
    assert name_of(unit) == quantity.name("en") + axis
    assert symbol_of(unit) == quantity.symbol


def test_definitions_are_one_line_each():
    for quantity in QUANTITIES:
        assert quantity.definition.endswith(".")
        assert len(quantity.definition) < 80


@for_each(
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
        ("lm/W", ["K", "η_v", "K(λ)"]),
        ("spectral", ["Φ_e,λ", "I_e,λ", "E_e,λ", "M_e,λ", "L_e,λ", "K(λ)"]),
        ("светов", ["Q_v", "Φ_v", "E_v", "L_v", "H_v", "K", "η_v", "V(λ)", "K(λ)"]),
        ("flux luminous", ["Φ_v"]),
        ("radiance (W/m2/sr)", ["L_e"]),
        ("etendue", ["G"]),
    ],
)
def test_a_search_finds_these(text, expected):
    assert symbols(text) == expected


@for_each(
    [
        ("svítivost", "L_v", "luminance"),
        ("SVITIVOST", "L_v", "luminance"),
        ("luminosity", "M_v", "luminous exitance"),
        ("luminosity", "Φ_e", "astronomical"),
        ("radiosity", "M_e", "radiant exitance"),
        ("intensity", "E_e", "physics"),
        ("light intensity", "I_v", "cd"),
        ("light intensity", "E_v", "lx"),
        ("světelný tok [W]", "Φ_e", "courses that count watts"),
        ("svetelny tok W", "Φ_e", "radiant flux (zářivý tok)"),
        ("световой поток [Вт]", "Φ_e", "measured in lm"),
        ("radiance in W m^-1 sr^-1", "L_e", "W/m2/sr"),
        ("W·m⁻¹·sr⁻¹", "L_e", "W/m2/sr"),
        ("Вт/(м ср)", "L_e", "W/m2/sr"),
        ("Ст", "Ω", "stokes"),
        ("svítivost [cd/m2]", "L_v", "luminance"),
        ("intensity [W/m2]", "E_e", "irradiance"),
        ("brightness", "L_v", "sensation"),
        ("PPFD", "E_p", "400 nm"),
        ("W/m2/Hz", "E_e", "per frequency"),
        ("lm/m", "Φ_v", "per length"),
        ("lm/m", "Φ_v", "per wavelength"),
        ("W/m", "Φ_e", "per length"),
        ("W/m", "Φ_e,λ", "per wavelength"),
        ("ozáření", "E_e", "some courses"),
        ("výkon", "Φ_e", "radiant flux"),
        ("hustota toku", "E_e", "density on"),
        ("hustota toku", "M_e", "leaves"),
        ("hustota toku", "E_v", "light"),
        ("radiozita", "M_e", "reflected"),
        ("spektrální světelná účinnost", "V(λ)", "maximum"),
        ("spektrální světelná účinnost", "K", "lm/W"),
    ],
)
def test_a_misnomer_finds_the_right_term_with_a_note(text, right, said):
    notes = {found.quantity.symbol: found.note for found in search(text)}
    assert said in notes[right]


def test_the_right_use_of_a_misnomer_comes_first():
    assert symbols("svítivost") == ["I_v", "L_v"]
    assert search("svítivost")[0].note == ""
    assert symbols("intensity") == ["I_e", "I_v", "I_p", "E_e", "I_e,λ"]
    assert symbols("svítivost [cd]") == ["I_v"]


@pytest.mark.parametrize(
    ("text", "meant", "part"), [("výkon", "Φ_e", "η_v"), ("плотность потока", "E_e", "Φ_e,λ")]
)
def test_a_quantity_comes_before_a_ratio_or_a_density_with_the_same_word(text, meant, part):
    assert symbols(text)[0] == meant
    assert symbols(text)[-1] == part


def test_every_misnomer_is_found_and_explained():
    for terms, symbol, note in MISNOMERS:
        for term in terms:
            assert note in {f.note for f in search(term) if f.quantity.symbol == symbol}


# Names of lecture notes and textbooks: Reichl, "Encyklopedie fyziky" (intenzita ozařování); MFF UK,
# "Počítačová grafika III" (zář, radiozita); the Great Soviet Encyclopedia (функция относительной
# спектральной световой эффективности); instrumentsystems.com and Politechnika Warszawska for the
# German and Polish names.
OF_NOTES = {
    "celkový zářivý tok": "Φ_e",
    "plošná hustota zářivého toku": "E_e",
    "kapacita paprsku": "G",
    "křivka světelné efektivity": "V(λ)",
    "intenzita ozařování": "E_e",
    "полный поток": "Φ_e",
    "спектральный поток": "Φ_e,λ",
    "функция спектральной световой эффективности": "V(λ)",
    "плотность потока": "E_e",
    "кривая видности": "V(λ)",
    "vlnová délka": "λ",
    "длина волны": "λ",
    "azimut": "φ",
    "азимут": "φ",
    "zenitový úhel": "θ",
    "kmitočet": "ν",
    "reflectance": "ρ",
    "odrazivost": "ρ",
    "коэффициент отражения": "ρ",
    "K(λ)": "K(λ)",
    "BRDF": "f_r",
    "DLI": "H_p",
    "Strahlungsleistung": "Φ_e",
    "Beleuchtungsstärke": "E_v",
    "Leuchtdichte": "L_v",
    "strumień świetlny": "Φ_v",
    "światłość": "I_v",
    "luminancja": "L_v",
}


@pytest.mark.parametrize("text", OF_NOTES)
def test_a_name_of_lecture_notes_is_found(text):
    assert OF_NOTES[text] in symbols(text)


@pytest.mark.parametrize(
    ("text", "said"), [("яркость", "radiance"), ("světelný tok", "radiant flux")]
)
def test_a_word_that_courses_use_for_watts_has_a_note(text, said):
    (first, *others) = search(text)
    assert first.note == ""
    assert any(said in found.note for found in others)
