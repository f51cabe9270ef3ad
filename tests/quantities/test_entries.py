"""Searches of `radcalc units`: by quantity in three languages, by unit's name, by unit."""

import pytest
from helpers import for_each

from radcalc.errors import UnitError
from radcalc.quantities.lookup import product, search_units
from radcalc.quantities.search import index
from radcalc.quantities.search import search as search_quantities
from radcalc.units.compiled import CONSTANTS, UNITS
from radcalc.units.scale_table import SCALES
from radcalc.units.table import resolve
from radcalc.units.values import resolve_any


def found(text: str) -> list[str]:
    return [entry.name for entry in search_units(text)]


# Typed by hand: a search, a unit that must be found, and one that must not.
FINDS = [
    ("ppfd", "umol/m2/s", "lux"),
    ("PPFD", "umol/m2/s", "lux"),
    ("photon irradiance", "umol/m2/s", "lux"),
    ("photon-irradiance", "umol/m2/s", "lux"),
    ("illuminance", "footcandle", "radlux"),
    ("osvětlenost", "footcandle", "radlux"),
    ("OSVETLENOST", "lm/m2", "radlux"),
    ("освещённость", "footcandle", "radlux"),
    ("luminous exitance", "radlux", "lux"),
    ("radiant exitance", "W/m2", "solar_constant"),
    ("irradiance", "W/m2", "radlux"),
    ("jas", "nit", "lux"),
    ("jas", "cd/m2", "lux"),
    ("délka", "foot", "litre"),
    ("длина", "foot", "litre"),
    ("wavelength", "angstrom", "litre"),
    ("luminous efficacy", "lm/W", "lumen"),
    ("spectral irradiance", "jansky", "pyron"),
    ("spectral irradiance", "W/m2/nm", "pyron"),
    ("spectral photon irradiance", "umol/m2/s/nm", "jansky"),
    ("time-integrated luminous intensity", "cd.s", "candela"),
    ("výkon", "watt", "joule"),
    ("energy", "joule", "watt"),
    ("lux", "lux_second", "phot"),
    ("lambert", "footlambert", "nit"),
    ("люкс", "lux", "lumen"),
    ("kandela", "candela", "lux"),
    ("cd/m2", "nit", "lux"),
    ("lx", "lux", "lumen"),
]  # fmt: skip


@for_each(FINDS)
def test_a_search_finds_the_units_of_a_quantity_or_of_that_name(text, there, not_there):
    names = found(text)
    assert there in names
    assert not_there not in names
    assert len(names) == len(set(names))


@pytest.mark.parametrize(
    ("text", "said"), [("ppfd", "400 nm"), ("intensity", "physics"), ("osvětlení", "illuminance")]
)
def test_a_misnomer_has_the_notes_of_the_quantities(text, said):
    notes = {entry.note for entry in search_units(text)} - {""}
    assert any(said in note for note in notes)
    assert {f.note for f in search_quantities(text) if f.note} <= notes


def test_a_watt_per_metre_is_per_length_or_per_wavelength():
    quantities = {entry.quantity for entry in search_units("W/m")}
    assert quantities == {"radiant flux per length", "spectral radiant flux (per wavelength)"}
    assert {"W/m", "W/nm"} <= set(found("W/m"))


def test_without_a_search_every_named_unit_is_listed():
    assert found("") == [*UNITS, *(scale.name for scale in SCALES), *CONSTANTS]


@for_each(sorted(index().names))
def test_every_name_of_a_quantity_has_units_of_its_dimension(name):
    dimensions = {resolve(q.unit).dimension for q in index().names[name]}
    if name in UNITS or not (names := found(name)):
        return
    assert {resolve_any(text).dimension for text in names} & dimensions


def test_a_product_is_defined_by_the_names_of_its_units():
    assert product("umol/m2/s", "").definition == "micromole / metre**2 / second"
    assert (
        product("cm-1", "").definition == "cycle / centimetre"
    )  # as in the definition of the kayser


@pytest.mark.parametrize(
    ("text", "near"), [("luminence", "luminance"), ("osvetlenst", "osvětlenost")]
)
def test_an_unknown_name_has_similar_ones(text, near):
    with pytest.raises(UnitError, match="unknown unit or quantity") as refused:
        search_units(text)
    assert near in refused.value.hint
