"""The dimensions of every law by Pint, with dimensions for angle, cycle and photon."""

import math
from typing import Any

import pytest
from helpers import KINDS, LIGHT, OTHER, Q, for_each, unit_of
from laws.every_law import LAWS, RELATIONS

from radcalc.answer import coherent_unit_of
from radcalc.quantities.symbols import SYMBOLS
from radcalc.units.registry import from_container
from radcalc.units.table import resolve


def constant(unit: str) -> Any:
    """A law's constant of 1 in its unit, factor by factor: 'J m' is not a unit."""
    top, _, bottom = unit.partition("/")
    return math.prod(Q(1, factor) for factor in top.split()) / Q(1, bottom or "1")


@for_each(LAWS)
def test_every_law_has_the_same_dimension_on_both_sides(law):
    kinds = KINDS
    if any("heat" in name or name == "temperature" for name in law.names):
        kinds = {"e": KINDS["e"]}  # heat is in watts and joules
    elif {"photon-efficacy", "responsivity"} & set(law.names):
        kinds = {"e": KINDS["e"]}  # per watt or joule
    elif {"photons", "current"} & set(law.names):
        kinds = {"p": KINDS["p"]}
    for kind in kinds:
        product = constant(law.unit)
        for name, power in law.powers:
            assert power == int(power)
            unit = Q(1, "lm_scot/lm") if name == "sp-ratio" else unit_of(name, kind)
            product = product * unit ** int(power)
        result = unit_of(law.result, kind)
        assert product.dimensionality == result.dimensionality, (law.name, kind)
        # and coherent: without a factor such as 1000
        assert (product / result).to("1").magnitude == pytest.approx(1, rel=1e-15)
    # steradian, cycle and photon, and the units of h and c
    assert law.unit in ("1", "sr", "1/sr", "cycle", "m cycle/s", "J m/photon", *OTHERS)


def test_the_check_includes_steradian_photon_and_cycle():
    assert Q(1, "W/sr").dimensionality != Q(1, "W").dimensionality
    assert Q(1, "photon").dimensionality != Q(1, "1").dimensionality
    assert Q(1, "cycle").dimensionality != Q(1, "1").dimensionality


OTHERS = ("W/(m2 K^4)", "m K", "A s", "A s/photon", "1/photon")
NAMES = sorted({name for law in (*LAWS, *RELATIONS) for name in law.names})


@for_each(NAMES)
def test_the_vocabulary_has_the_units_of_this_check(name):
    kinds = KINDS if SYMBOLS[name].geometry else ["e"]  # its own dimension is the first
    for kind, dimension in zip(kinds, SYMBOLS[name].dimensions, strict=False):
        assert from_container(unit_of(name, kind)._units).dimension == dimension


@for_each(NAMES)
def test_the_units_of_derivations_are_coherent(name):
    """The units in --steps are those of the check of the laws above."""
    if name in LIGHT:
        for kind in KINDS:
            unit = Q(1, coherent_unit_of(name, kind))
            assert (unit / unit_of(name, kind)).to("1").magnitude == pytest.approx(1, rel=1e-15)
        return
    shown = {
        "wavelength": ("nm", "m"),
        "peak-wavelength": ("nm", "m"),
        "frequency": ("THz", "cycle/s"),
        "wavenumber": ("cm-1", "cycle/m"),
        "photon-energy": ("J", "J/photon"),  # of one photon
        "divergence": ("mrad", "rad"),
    }
    if name in shown:
        assert (coherent_unit_of(name), OTHER[name]) == shown[name]
        return
    unit = Q(1, coherent_unit_of(name))
    assert (unit / unit_of(name, "e")).to("1").magnitude == pytest.approx(1, rel=1e-15)


@for_each([name for name, symbol in SYMBOLS.items() if symbol.unit])
def test_a_symbol_is_shown_in_a_unit_of_its_own_dimension(name):
    symbol = SYMBOLS[name]
    assert resolve(symbol.unit.replace(" ", ".")).dimension in symbol.dimensions
