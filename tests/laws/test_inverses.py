"""Every symbol of every law, from the others."""

import math
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from laws.every_law import LAWS, RELATIONS
from mpmath import mpf

PI = math.pi

SIZE = st.floats(0.01, 100)
ANGLE = st.floats(0.05, 1.5)
LN = math.log


def _cone(angle: float) -> float:
    return 4 * PI * math.sin(angle / 2) ** 2


# name of a relation -> the symbols drawn, the symbol they give, and the textbook's formula
FORWARD: dict[str, tuple[dict[str, Any], str, Any]] = {
    "part of an isotropic source": (
        {"within": st.floats(0.01, 3.1)}, "part", lambda within: (1 - math.cos(within)) / 2),
    "solid angle of a cone": (
        {"half-angle": st.floats(0.05, 3.1)}, "solid-angle", _cone),
    "part of a cone": (
        {"within": st.floats(0.05, 3.1), "half-angle": st.floats(0.05, 3.1)}, "part",
        lambda within, angle: min(1.0, _cone(within) / _cone(angle))),
    "flux of a lobe over its peak": (
        {"exponent": st.floats(0.01, 1e4)}, "solid-angle", lambda n: 2 * PI / (n + 1)),
    "beam angle of a lobe": (
        {"beam-angle": st.floats(0.05, 3.1)}, "exponent",
        lambda a: LN(0.5) / LN(math.cos(a / 2))),
    "field angle of a lobe": (
        {"field-angle": st.floats(0.05, 3.1)}, "exponent",
        lambda a: LN(0.1) / LN(math.cos(a / 2))),
    "part of a lobe": (
        {"within": ANGLE, "exponent": st.floats(0.01, 1000)}, "part",
        lambda within, n: 1 - math.cos(within) ** (n + 1)),
    "part of a lobe in its beam": (
        {"beam-angle": st.floats(0.1, 3.1), "exponent": st.floats(0.01, 1000)}, "beam-part",
        lambda angle, n: 1 - math.cos(angle / 2) ** (n + 1)),
    "cosine of the incidence": ({"incidence": ANGLE}, "cosine", math.cos),
    "straight line to the source": (
        {"height": st.floats(0.1, 10), "lateral": st.floats(0, 10)}, "distance", math.hypot),
    "inside the cone": (
        {"off-axis": ANGLE, "half-angle": ANGLE}, "share",
        lambda off, angle: 1.0 if off <= angle else 0.0),
    "fall of a lobe": (
        {"off-axis": ANGLE, "exponent": st.floats(0, 100)}, "share",
        lambda off, n: math.cos(off) ** n),
    "disc on its axis": (
        {"radius": st.floats(0.1, 10), "height": st.floats(0.1, 10)}, "projected-solid-angle",
        lambda r, h: PI * r**2 / (r**2 + h**2)),
    "sphere, its centre at a distance": (
        {"radius": st.floats(0.1, 1), "distance": st.floats(1.01, 10)}, "projected-solid-angle",
        lambda r, d: PI * (r / d) ** 2),
    "exposure value": (
        {"light": st.floats(1e-3, 1e6)}, "ev", math.log2),
    "exposure value at ISO 100": (
        {"ev": st.floats(-10, 25), "iso": st.floats(1, 1e6)}, "ev100",
        lambda value, iso: value - math.log2(iso / 100)),
    "reflected light": (
        {"k": SIZE, "ev100": st.floats(-10, 25)}, "luminance", lambda k, n: k * 2**n / 100),
    "incident light": (
        {"c": SIZE, "ev100": st.floats(-10, 25)}, "illuminance", lambda c, n: c * 2**n / 100),
    "saturation": ({"ev100": st.floats(-10, 25)}, "saturation-luminance", lambda n: 1.2 * 2**n),
}  # fmt: skip


@pytest.mark.parametrize("law", LAWS, ids=lambda law: f"{law.name}: {law.result}")
@given(data=st.data())
@settings(max_examples=25)
def test_every_symbol_of_a_law_comes_back(law, data):
    values = {name: data.draw(SIZE, name) for name, _ in law.powers}
    product = mpf(law.constant)
    for name, power in law.powers:
        product *= mpf(values[name]) ** power
    values[law.result] = float(product)
    assert set(law.targets) == set(law.names)
    for target in law.names:
        others = {name: value for name, value in values.items() if name != target}
        assert law.solve(target, others.__getitem__) == pytest.approx(values[target], rel=1e-13)


@pytest.mark.parametrize("law", RELATIONS, ids=lambda law: f"{law.name}: {law.names}")
@given(data=st.data())
@settings(max_examples=60)
def test_every_symbol_of_a_relation_comes_back(law, data):
    drawn, result, formula = FORWARD[law.name]
    names = {"height": "distance"} if law.name == "disc on its axis" else {}
    drawn = {n if n in law.names else names[n]: s for n, s in drawn.items()}
    values = {name: data.draw(strategy, name) for name, strategy in drawn.items()}
    if law.name == "inside the cone":
        assume(abs(values["off-axis"] - values["half-angle"]) > 1e-9)
    values[result] = formula(*values.values())
    assert set(values) == set(law.names)
    for target in law.targets:
        others = {name: value for name, value in values.items() if name != target}
        found = law.solve(target, others.__getitem__)
        assert found == pytest.approx(values[target], rel=1e-9, abs=1e-10), target
