"""Units of conversions whose target is the name of a quantity."""

import unicodedata

import pytest
from helpers import for_each

import radcalc
from radcalc.conversion.plan import target_of
from radcalc.errors import UnitError
from radcalc.quantities import name_of
from radcalc.quantities.names import QUANTITIES
from radcalc.quantities.search import names_with_units
from radcalc.units.compiled import WEIGHTS
from radcalc.units.table import resolve, unit_of

# SI units from the SI Brochure, tables 2 to 6; umol/m2/s as in horticulture (ASABE S640).
USUAL = [
    ("illuminance", "lx"),
    ("Illuminance", "lx"),
    ("osvětlenost", "lx"),
    ("OSVETLENOST", "lx"),
    ("освещённость", "lx"),
    ("освещенность", "lx"),
    ("luminous flux", "lm"),
    ("luminous-flux", "lm"),
    ("světelný tok", "lm"),
    ("radiant flux", "W"),
    ("radiant power", "W"),
    ("поток излучения", "W"),
    ("luminance", "cd/m2"),
    ("jas", "cd/m2"),
    ("luminous intensity", "cd"),
    ("svítivost", "cd"),
    ("radiant exposure", "J/m2"),
    ("luminous energy", "lm s"),
    ("ppfd", "umol/m2/s"),
    ("PPFD", "umol/m2/s"),
    ("photon-irradiance", "umol/m2/s"),
    ("photon flux", "umol/s"),
    ("luminous exitance", "lm/m2"),
    ("radiant exitance", "W/m2"),
    ("spectral irradiance", "W/m2/nm"),
    ("solid angle", "sr"),
    ("etendue", "m2 sr"),
    ("luminous efficacy", "lm/W"),
    ("length", "m"),
    ("délka", "m"),
    ("výkon", "W"),
    ("power", "W"),
    ("luminous power", "lm"),
    ("ozáření", "J/m2"),
    ("iradiance", "W/m2"),
    ("wavelength", "nm"),
    ("длина волны", "nm"),
]


@for_each(USUAL)
def test_a_name_stands_for_the_usual_unit(name, unit):
    assert unit_of(name) is None
    target = target_of(name)
    assert target.text == unit
    assert target.dimension == resolve(unit).dimension


@pytest.mark.parametrize(
    ("name", "source", "unit"),
    [
        ("flux", "lx", "lm"),
        ("flux", "mW/cm2", "W"),
        ("flux", "umol", "umol/s"),
        ("irradiance", "lm", "lx"),
        ("irradiance", "cd", "lx"),
        ("irradiance", "mW", "W/m2"),
        ("irradiance", "mW/cm2", "W/m2"),
        ("irradiance", "lx", "W/m2"),  # already an illuminance
        ("radiance", "nit", "W/m2/sr"),
        ("radiance", "lx", "cd/m2"),
        ("exposure", "lm", "lx s"),
        ("energy", "mol/m2/s", "umol"),
        ("exitance", "cd/m2", "lm/m2"),
    ],
)
def test_the_source_decides_the_kind_of_a_generic_name(name, source, unit):
    assert target_of(name, resolve(source)).text == unit


@pytest.mark.parametrize("text", ["lux", "candela", "photon", "quantum", "E", "L", "nit", "degree"])
def test_the_name_of_a_unit_comes_first(text):
    assert target_of(text).text == text


@pytest.mark.parametrize(
    ("text", "readings"),
    [
        ("intensity", ["radiant intensity (W/sr)", "luminous intensity (cd)", "irradiance (W/m2)"]),
        ("luminosity", ["radiant flux (W)", "luminous exitance (lm/m2)"]),
        ("light intensity", ["irradiance (W/m2)", "illuminance (lx)", "luminous intensity (cd)"]),
        ("hustota toku", ["irradiance (W/m2)", "radiant exitance (W/m2)", "illuminance (lx)"]),
        ("flux", ["radiant flux (W)", "luminous flux (lm)", "photon flux (umol/s)"]),
    ],
)
def test_a_name_with_several_meanings_is_refused_with_them(text, readings):
    with pytest.raises(UnitError, match="is ambiguous") as refused:
        target_of(text)
    for reading in readings:
        assert reading in refused.value.message
        assert reading.partition("(")[2].strip(")") in refused.value.hint.split(" or ")


def test_a_misnomer_has_its_note():
    assert any("400 nm to 700 nm" in note for note in target_of("ppfd").notes)
    assert not target_of("illuminance").notes


@pytest.mark.parametrize(
    ("text", "near"), [("iluminance", "illuminance"), ("ozarenst", "ozářenost"), ("lumen flux", "")]
)
def test_an_unknown_name_is_refused_with_similar_ones(text, near):
    with pytest.raises(UnitError, match="unknown unit") as refused:
        target_of(text)
    assert near in refused.value.hint


@pytest.mark.parametrize("text", ["projected solid angle", "luminous efficiency", "měrný výkon"])
def test_a_quantity_without_a_distinct_unit_is_not_a_target(text):
    with pytest.raises(UnitError, match="has no unit that distinguishes"):
        target_of(text)


@pytest.mark.parametrize(
    ("name", "conditions"),
    [
        ("ppfd", {"wavelength": "900nm"}),
        ("PPFD", {"wavelength": "399nm"}),
        ("ppfd", {"spectrum": "line:850nm"}),
        ("ppfd", {"spectrum": "D65", "photon_range": "300nm:800nm"}),
    ],
)
def test_ppfd_is_refused_for_photons_outside_400_to_700_nm(name, conditions):
    with pytest.raises(radcalc.errors.RadcalcError, match="400 nm to 700 nm only"):
        radcalc.convert("1 W/m2", name, **conditions)
    assert radcalc.convert("1 W/m2", "photon irradiance", **conditions).magnitude > 0


def test_ppfd_of_a_wavelength_in_range_counts_its_photons():
    # E lambda / (h c N_A) = 1 * 600e-9 / (6.62607015e-34 * 299792458 * 6.02214076e23) mol/m2/s
    expected = 600e-9 / (6.62607015e-34 * 299792458 * 6.02214076e23) * 1e6
    found = radcalc.convert("1 W/m2", "ppfd", wavelength="600nm")
    assert found.magnitude == pytest.approx(expected, rel=1e-12)
    same = radcalc.convert("1 W/m2", "ppfd", spectrum="D65", photon_range="400nm:700nm")
    assert same == radcalc.convert("1 W/m2", "ppfd", spectrum="D65")


def test_exitance_is_not_irradiance():
    # Half of 100 lm/m2 leaves a surface of reflectance 0.5; 1 W at 555 nm is 683 lm (SI, Kcd)
    assert name_of(target_of("radiant exitance")) == "radiant exitance"
    assert name_of(target_of("luminous exitance")) == "luminous exitance"
    for name in ("luminous exitance", "radiant exitance"):
        with pytest.raises(radcalc.errors.RadcalcError, match="reflectance is missing"):
            radcalc.convert("100 lx", name, wavelength="555nm")
    left = radcalc.convert("100 lx", "luminous exitance", reflectance=0.5)
    assert left.magnitude == pytest.approx(50, rel=1e-15)
    left = radcalc.convert("100 lx", "radiant exitance", wavelength="555nm", reflectance=0.5)
    assert left.magnitude == pytest.approx(50 / 683, rel=1e-4)


def test_python_takes_names_too():
    # 1 ft is 0.3048 m exactly
    assert radcalc.convert("100 fc", "illuminance").magnitude == pytest.approx(100 / 0.3048**2)
    assert str(radcalc.convert("100 fc", "osvětlenost").units) == "lux"


@for_each(QUANTITIES)
def test_the_name_of_every_quantity_with_a_unit_of_its_own_is_a_target(quantity):
    if quantity.symbol not in ("Ω_p", "η_v", "V(λ)", "K(λ)", "f_r"):
        assert target_of(quantity.name("en")).dimension == resolve(quantity.unit).dimension


def test_completion_has_the_names_with_their_units():
    names = names_with_units()
    assert {("luminous-flux", "lm"), ("osvětlenost", "lx"), ("ppfd", "umol/m2/s")} <= {*names}
    for name, unit in names:
        assert " " not in name
        assert unit_of(name) is None
        bare = unicodedata.normalize("NFD", name)
        is_weight = name in {row[0] for row in WEIGHTS.values()}  # then of the source's geometry
        assert target_of(bare, resolve("W/m2" if is_weight else "W")).text == unit
