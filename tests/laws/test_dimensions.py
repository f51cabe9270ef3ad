"""The dimension of every law by Pint, in which an angle and a photon have one."""

import ast

import pytest
from conftest import ROOT
from helpers import KINDS, LIGHT, OTHER, Q, unit_of
from laws.every_law import LAWS, MODULES, RELATIONS

from radcalc.calculators import inputs as inputs_module
from radcalc.calculators import light as light_module


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_no_law_of_the_source_text_is_left_out(module):
    tree = ast.parse((ROOT / module.__file__).read_text(encoding="utf-8"))
    written = {
        node.args[0].value
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("Law", "Relation")
    }
    assert written <= {law.name for law in (*LAWS, *RELATIONS)}


@pytest.mark.parametrize("law", LAWS, ids=lambda law: f"{law.name}: {law.result}")
def test_every_law_has_the_same_dimension_on_both_sides(law):
    kinds = KINDS
    if any("heat" in name for name in law.names):
        kinds = {"e": KINDS["e"]}  # heat is watts and joules
    for kind in kinds:
        product = Q(1, law.unit)
        for name, power in law.powers:
            assert power == int(power)
            product = product * unit_of(name, kind) ** int(power)
        result = unit_of(law.result, kind)
        assert product.dimensionality == result.dimensionality, (law.name, kind)
        # and coherent: no factor of 1000 hides in a unit
        assert (product / result).to("1").magnitude == pytest.approx(1, rel=1e-15)
        assert law.unit in ("1", "sr", "1/sr")


def test_a_steradian_is_not_forgotten_by_the_check():
    assert Q(1, "W/sr").dimensionality != Q(1, "W").dimensionality
    assert Q(1, "photon").dimensionality != Q(1, "1").dimensionality


@pytest.mark.parametrize("name", [*light_module.GEOMETRY, *inputs_module.COHERENT])
def test_the_units_of_derivations_are_coherent(name):
    """The letters in --steps go with the units that the laws are checked with above."""
    if name in LIGHT:
        for kind in KINDS:
            unit = Q(1, light_module.unit(name, kind, coherent=True))
            assert (unit / unit_of(name, kind)).to("1").magnitude == pytest.approx(1, rel=1e-15)
    elif name in OTHER:
        unit = Q(1, inputs_module.COHERENT[name])
        assert (unit / unit_of(name, "e")).to("1").magnitude == pytest.approx(1, rel=1e-15)
