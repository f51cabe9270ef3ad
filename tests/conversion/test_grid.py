"""Quantities of the grid, one unit for each: conversions between them need a condition."""

import pytest
from helpers import for_each, shell

from radcalc.conversion.plan import plan
from radcalc.errors import ConversionError
from radcalc.units.table import resolve

HEADS = {"e": ("W", "J"), "v": ("lm", "lm.s"), "p": ("photon/s", "photon")}
SHAPES = ("", "/sr", "/m2", "/m2/sr")
AXES = ("", "/nm", "/THz", "/cm-1", "/eV")
# One unit for each quantity of the grid: kind x time x area x solid angle x axis of density.
GRID = [
    head + shape + axis
    for heads in HEADS.values()
    for head in heads
    for shape in SHAPES
    for axis in AXES
]
OTHERS = ["td", "lm/W", "umol/J", "lm.s/umol", "1", "sr", "deg", "m2.sr", "nm", "m2", "THz", "cm-1",
          "s", "eV/photon", "K", "kg"]  # fmt: skip


# Densities per photon energy that are also efficacies, or numbers, of the same dimension.
ALSO = ({"lm.s/eV", "lm/W"}, {"photon/eV", "umol/J"}, {"J/eV", "1"})


def _only_constants_between(one: str, other: str) -> bool:
    """Return whether c and h link two densities: per frequency, wavenumber and photon energy."""
    (head, _, axis), (tail, _, below) = one.rpartition("/"), other.rpartition("/")
    return {one, other} in ALSO or (head == tail and {axis, below} < {"THz", "cm-1", "eV"})


PHOTON = {"nm", "THz", "cm-1", "eV/photon", "J"}  # a photon has all of them
OF_HEAT = {"W/m2", "W/m2/sr", "nm"}  # a black body has one of each at a temperature


def _linked_by_nature(one: str, other: str) -> bool:
    return {one, other} <= PHOTON or ("K" in (one, other) and bool({one, other} & OF_HEAT))


@for_each([*GRID, *OTHERS])
def test_no_two_different_quantities_convert_without_a_condition(source):
    for target in [*GRID, *OTHERS]:
        if source == target or _only_constants_between(source, target):
            continue
        if _linked_by_nature(source, target):
            assert plan(resolve(source), resolve(target)).assumptions
            continue
        with pytest.raises(ConversionError) as caught:
            plan(resolve(source), resolve(target))
        message, hint = shell(caught.value)
        assert message.startswith("cannot convert "), target
        assert "missing" in message or "no condition links them" in message, target
        assert hint, target


def test_a_density_per_hertz_and_one_per_kayser_differ_by_c_alone():
    # c = 299 792 458 m/s exactly; a kayser is 1/cm
    for shape in SHAPES:
        made = plan(resolve(f"W{shape}/Hz"), resolve(f"W{shape}/cm-1"))
        assert made.factor == pytest.approx(29979245800, rel=1e-15)
        back = plan(resolve(f"W{shape}/cm-1"), resolve(f"W{shape}/Hz"))
        assert back.factor == pytest.approx(1 / 29979245800, rel=1e-15)
