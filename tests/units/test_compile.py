"""The compiled table of units agrees with Pint for every spelling."""

from fractions import Fraction

import pytest
from pint.util import UnitsContainer

from radcalc.units import BASES, WEIGHT_AT
from radcalc.units.registry import (
    HERE,
    PLACES,
    compile_units,
    definitions,
    every_spelling,
    exact_registry,
    exponent_of,
    read,
    refuse_collisions,
)
from radcalc.units.table import resolve

TEXT = definitions()
FOUND = read(TEXT)
SPELLINGS = every_spelling(FOUND)


@pytest.fixture(scope="module")
def pint_registry():
    return exact_registry()


def test_the_committed_table_is_up_to_date():
    table, catalogue = compile_units(TEXT)
    assert (HERE / "compiled.py").read_text(encoding="utf-8") == table
    assert (HERE / "catalogue.py").read_text(encoding="utf-8") == catalogue


def test_every_spelling_with_every_prefix_has_pints_value(pint_registry):
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
            if base in PLACES:
                expected[PLACES[base]] = int(power)
            else:
                expected[WEIGHT_AT] += int(power) * exponent_of(base)
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
    for spelling in SPELLINGS:  # a symbol may also be a full name, whose case does not matter
        if spelling.lower() in full:
            assert SPELLINGS[spelling.lower()] == SPELLINGS[spelling]


def test_a_second_definition_is_fatal(tmp_path, monkeypatch):
    from radcalc.units import registry
    from radcalc.units import registry as compiler

    twice = tmp_path / "twice.txt"
    twice.write_text(TEXT + "\nlux = 2 * lumen / metre**2 = _\n", encoding="utf-8")
    monkeypatch.setattr(registry, "DEFINITIONS", twice)
    with pytest.raises(ValueError, match="lux"):
        compiler.compile_units(twice.read_text(encoding="utf-8"))


def test_there_are_about_a_hundred_units_and_each_names_its_source():
    assert len(FOUND.units) > 100
    bare = [u.name for u in FOUND.units if not u.source]
    assert bare == ["percent"]
