"""Laws are read from their formulas, and the tests cover all laws of the calculators."""

import ast
import math
import re

import pytest
from helpers import for_each
from hypothesis import given, settings
from hypothesis import strategies as st
from laws.every_law import FOUND, LAWS, MODULES, OF_PAGES, RELATIONS, key

from radcalc import lambertian, point_source
from radcalc.calculators import etendue as etendue_module
from radcalc.calculators import mesopic as mesopic_module
from radcalc.calculators import solid_angle as solid_angle_module
from radcalc.inputs.reading import read
from radcalc.laws import law, solver

# Values of the letters in formulas; SI Brochure.
LETTERS = {"pi": math.pi, "Omega0": 1.0, "c": 299792458.0, "h": 6.62607015e-34,
           "sigma": 5.670374419184429e-8, "b": 2.897771955185173e-3,  # CODATA 2022
           "e": 1.602176634e-19,
           "lg2": math.log10(2)}  # fmt: skip


def right_side(template: str, values: dict[str, float]) -> float:
    """The right side of a formula, by Python's arithmetic."""
    text = template.partition(" = ")[2].replace("^", "**")
    text = re.sub(r"\{([\w-]+)\}", lambda found: repr(values[found[1]]), text)
    text = re.sub(r"(?<=[\w.)]) (?=[\w.(])", " * ", text)
    return float(eval(text, {"__builtins__": {}}, LETTERS))  # of radcalc's own formulas


@pytest.mark.parametrize("one", LAWS, ids=lambda one: f"{one.name}: {one.template}")
@given(data=st.data())
@settings(max_examples=10)
def test_a_law_has_the_value_of_its_formula(one, data):
    values = {name: data.draw(st.floats(0.01, 100), name) for name, _ in one.powers}
    expected = right_side(one.template, values)
    assert one.solve(one.result, values.__getitem__) == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize(
    ("template", "constant", "powers", "unit"),
    [
        ("{y} = {a}", 1, {"a": 1}, "1"),
        ("{y} = 4 pi {a}^2 {b}", 4 * math.pi, {"a": 2, "b": 1}, "1"),
        ("{y} = {a} / {b}^2 Omega0", 1, {"a": 1, "b": -2}, "sr"),
        ("{y} = {a} / {b} {c}", 1, {"a": 1, "b": -1, "c": 1}, "1"),
        ("{y} = {a} / (pi Omega0)", 1 / math.pi, {"a": 1}, "1/sr"),
        ("{y} = pi {a} / (4 {b}^2) {c}", math.pi / 4, {"a": 1, "b": -2, "c": 1}, "1"),
        ("{y} = 1 / {b}", 1, {"b": -1}, "1"),
    ],
)
def test_powers_and_constant_are_read_from_a_formula(template, constant, powers, unit):
    one = law("a law", template)
    assert (one.names, one.result) == (("y", *powers), "y")
    assert dict(one.powers) == powers
    assert one.constant == pytest.approx(constant, rel=1e-15)
    assert one.unit == unit


@for_each(MODULES)
def test_every_law_in_the_source_text_is_tested(module):
    with open(module.__file__, encoding="utf-8") as file:
        tree = ast.parse(file.read())
    written = {
        node.args[0].value
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        and getattr(node.func, "id", "") in ("Law", "Relation", "law", "relation")
        and isinstance(node.args[0], ast.Constant)
    }
    assert written <= {one.name for one in (*LAWS, *RELATIONS, *OF_PAGES)}


def test_every_law_that_the_calculators_solve_is_tested(monkeypatch):
    caught = []
    solve = solver.solve_all

    def catch(laws, *words):
        caught.extend(laws)
        return solve(laws, *words)

    monkeypatch.setattr(solver, "solve_all", catch)
    for extra in ({"half_angle": "1rad"}, {"exponent": 2}, {}):
        point_source(intensity="1cd", height="1m", offset="1m", **extra)
    lambertian("patch", luminance="1cd/m2", diameter="1cm", distance="1m")
    lambertian(luminance="1cd/m2", width="1cm", length="1cm")
    lambertian("rectangle", luminance="1cd/m2", width="1m", length="1m")
    for shape in ("disc", "sphere"):
        lambertian(shape, luminance="1cd/m2", diameter="1m", distance="2m")
        lambertian(shape, luminance="1cd/m2", illuminance="1lx", distance="2m")

    def inputs(text):
        return {name: read(name, value) for name, _, value in map(split, text.split())}

    def split(word):
        return word.partition("=")

    for text in (
        "area=1mm2 na=0.1",
        "diameter=1mm f-number=2",
        "width=1mm length=1mm half-angle=20deg",
        "radius=1m receiver-diameter=2m distance=1m",
        "area=1cm2 receiver-area=1cm2 distance=1m",
    ):
        etendue_module.etendue(inputs(text))
    for shape, text in (
        ("cone", "apex-angle=20deg"),
        ("sphere", "diameter=1m distance=2m"),
        ("disc", "diameter=1m solid-angle=1sr"),
        ("disc", "height=1m solid-angle=1sr"),
        ("pyramid", "horizontal=20deg vertical=20deg"),
        ("patch", "diameter=1cm distance=2m"),
    ):
        solid_angle_module.solid_angle(shape, inputs(text))
    mesopic_module.mesopic(inputs("luminance=0.1cd/m2 sp-ratio=2"))
    assert {key(one) for one in caught} <= set(FOUND)
    assert len({key(one) for one in caught}) > 40
