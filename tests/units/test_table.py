import logging
from fractions import Fraction
from itertools import pairwise

import pytest
from pint.util import UnitsContainer

from radcalc.errors import UnitError
from radcalc.units import compiled
from radcalc.units.compile import (
    BASE_UNITS,
    HERE,
    compile_units,
    every_spelling,
    read,
    refuse_collisions,
)
from radcalc.units.registry import DEFINITIONS, exact_registry
from radcalc.units.table import BASES, lookup, resolve

TEXT = DEFINITIONS.read_text(encoding="utf-8")
FOUND = read(TEXT)
SPELLINGS = every_spelling(FOUND)


@pytest.fixture(scope="module")
def pint_registry():
    return exact_registry()


def test_the_committed_table_is_what_pint_says_today():
    table, catalogue = compile_units(TEXT)
    assert (HERE / "compiled.py").read_text(encoding="utf-8") == table
    assert (HERE / "catalogue.py").read_text(encoding="utf-8") == catalogue


def test_every_spelling_with_every_prefix_is_worth_what_pint_says(pint_registry):
    assert len(SPELLINGS) > 1500
    for spelling, [(prefix, unit)] in SPELLINGS.items():
        ours = resolve(spelling)
        container = UnitsContainer({pint_registry.get_name(prefix + unit): 1})
        factor, _ = pint_registry.get_root_units(container)
        powers = pint_registry.get_dimensionality(container)
        mass = int(powers.get("[mass]", 0))
        assert Fraction(ours.top, ours.bottom) == factor / Fraction(1000) ** mass, spelling
        expected = [0] * len(BASES)
        for base, power in powers.items():
            expected[BASE_UNITS[base]] = int(power)
        assert ours.dimension == tuple(expected), spelling


def test_pint_reads_every_spelling_as_the_same_unit(pint_registry):
    for spelling, [(prefix, unit)] in SPELLINGS.items():
        known = pint_registry.parse_unit_name(spelling)
        plural = pint_registry.parse_unit_name(spelling.removesuffix("s"))
        assert prefix + unit in [p + u for p, u, _ in (*known, *plural)], spelling


def test_no_two_spellings_collide():
    refuse_collisions(FOUND)
    assert all(len(readings) == 1 for readings in SPELLINGS.values())
    full = {prefix + n for u in FOUND.units for n in u.names for prefix in ("", *u.prefixes)}
    for spelling in SPELLINGS:  # a symbol that is also a full name, which has no case
        if spelling.lower() in full:
            assert SPELLINGS[spelling.lower()] == SPELLINGS[spelling]


def test_a_second_definition_is_fatal(tmp_path, monkeypatch):
    from radcalc.units import compile as compiler
    from radcalc.units import registry

    twice = tmp_path / "twice.txt"
    twice.write_text(TEXT + "\nlux = 2 * lumen / metre**2 = _\n", encoding="utf-8")
    monkeypatch.setattr(registry, "DEFINITIONS", twice)
    logging.getLogger("pint").setLevel(logging.NOTSET)
    with pytest.raises(ValueError, match="lux"):
        compiler.compile_units(twice.read_text(encoding="utf-8"))


def test_there_are_about_a_hundred_units_and_each_names_its_source():
    assert len(FOUND.units) > 100
    bare = [u.name for u in FOUND.units if not u.source]
    assert bare == ["percent"]


@pytest.mark.parametrize(
    "spelling",
    ["kinch", "kkg", "klumens", "millift", "lms", "LX", "Lm", "kлм", "лmм", "mfoot", "dd", "xlm",
     "kh", "W²m", "photonn", "mkm"],
)  # fmt: skip
def test_what_nobody_wrote_down_is_unknown(spelling):
    with pytest.raises(UnitError) as caught:
        lookup(spelling)
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
def test_a_misspelt_unit_is_answered_with_the_nearest(spelling, suggestion):
    with pytest.raises(UnitError) as caught:
        resolve(spelling)
    assert suggestion in caught.value.hint


@pytest.mark.parametrize("name", sorted(compiled.REFUSED))
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
def test_a_unit_with_more_than_one_meaning_says_which_it_took(unit):
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


def test_a_wavenumber_is_told_from_a_length():
    per_kayser = resolve("W/m2/cm-1")
    assert per_kayser.dimension == resolve("W/m2/kayser").dimension
    assert per_kayser.dimension != resolve("W/m").dimension
    assert "wavenumber" in per_kayser.notes[0]
    assert resolve("W cm-2 sr-1 um-1").dimension == resolve("flick").dimension
