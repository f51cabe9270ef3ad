"""The laws: their dimensions by Pint, their inverses, and what the calculators make of them.

References are the defining integrals, and closed forms that are written out here.
"""

import ast
import itertools
import math
import random
from typing import Any

import mpmath
import numpy as np
import pytest
from conftest import ROOT, run
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mpf

import radcalc
from radcalc import api, calorimeter, ev, lambertian, point_source
from radcalc.calculators import calorimeter as calorimeter_module
from radcalc.calculators import ev as ev_module
from radcalc.calculators import inputs as inputs_module
from radcalc.calculators import lambertian as lambertian_module
from radcalc.calculators import light as light_module
from radcalc.calculators import point_source as point_module
from radcalc.calculators import shapes as surfaces_module
from radcalc.calculators import worksheet as sheet_module
from radcalc.errors import ConditionError, RadcalcError, UsageError
from radcalc.laws import point as spreads_module
from radcalc.laws.law import Contradiction, Known, Law, Relation, rounding, solve

MODULES = (
    spreads_module,
    surfaces_module,
    point_module,
    lambertian_module,
    ev_module,
    calorimeter_module,
    sheet_module,
)
Q = radcalc.Quantity
PI = math.pi


def flagged(shape, *flags, **given):
    """A Lambertian source with the flags of a rectangle."""
    return lambertian(shape, **dict.fromkeys(flags, True), **given)


def number(answer: dict[str, Any], name: str, unit: str) -> float:
    return float(answer[name].to(unit).magnitude)


# --- All the laws there are: those in the modules' data, and those that a shape adds.


def laws_in(data: Any) -> list[Law | Relation]:
    if isinstance(data, (Law, Relation)):
        return [data]
    if isinstance(data, dict):
        data = list(data.values())
    if isinstance(data, (list, tuple)):
        return [law for one in data for law in laws_in(one)]
    return []


def laws_added() -> list[Law | Relation]:
    """What the sheets solve for every shape and place; not all of it is data of a module."""
    caught: list[Law | Relation] = []

    def catch(laws, known):
        caught.extend(laws)
        return solve(laws, known)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sheet_module, "solve", catch)
        for extra in ({"half_angle": "1rad"}, {"exponent": 2}, {}):
            point_source(intensity="1cd", height="1m", offset="1m", **extra)
        lambertian(luminance="1cd/m2", diameter="1cm", distance="1m")
        lambertian(luminance="1cd/m2", width="1cm", length="1cm")
        lambertian("rectangle", luminance="1cd/m2", width="1m", length="1m")
        for shape in ("disc", "sphere"):
            lambertian(shape, luminance="1cd/m2", diameter="1m", distance="2m")
            lambertian(shape, luminance="1cd/m2", illuminance="1lx", distance="2m")
    return caught


FOUND = laws_in([vars(module) for module in MODULES]) + laws_added()
LAWS = list({law.name + law.template: law for law in FOUND if isinstance(law, Law)}.values())
RELATIONS = list({r.name + r.template: r for r in FOUND if isinstance(r, Relation)}.values())


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_no_law_of_the_source_text_is_left_out(module):
    tree = ast.parse((ROOT / module.__file__).read_text(encoding="utf-8"))
    written = {
        node.args[0].value
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("Law", "Relation")
    }
    assert written <= {law.name for law in (*LAWS, *RELATIONS)}


# --- Dimensions.

KINDS = {  # coherent SI; a photon and the candela's lumen are units of their own
    "e": ("W", "J"),
    "v": ("lm", "lm s"),
    "p": ("photon/s", "photon"),
}
LIGHT = {
    "flux": "{0}", "intensity": "{0}/sr", "irradiance": "{0}/m2", "exitance": "{0}/m2",
    "radiance": "{0}/m2/sr", "exposure": "{1}/m2", "energy": "{1}", "received-flux": "{0}",
    "incident-irradiance": "{0}/m2", "flux-within": "{0}", "beam-flux": "{0}",
    "far-field-irradiance": "{0}/m2",
}  # fmt: skip
OTHER = {
    "distance": "m", "height": "m", "lateral": "m", "radius": "m", "diameter": "m", "width": "m",
    "length": "m", "area": "m2", "apparent-area": "m2", "receiver-area": "m2", "time": "s",
    "half-angle": "rad", "apex-angle": "rad", "beam-angle": "rad", "field-angle": "rad",
    "within": "rad", "off-axis": "rad", "incidence": "rad", "solid-angle": "sr",
    "projected-solid-angle": "sr", "cosine": "1", "cosine-of-source": "1", "share": "1",
    "part": "1", "beam-part": "1", "exponent": "1", "configuration-factor": "1",
    "reflectance": "1", "absorptance": "1", "mass": "kg", "specific-heat": "J/kg/K",
    "temperature-rise": "K", "heat": "J", "light": "1/s", "f-number": "1",
    "ev": "1", "ev100": "1", "iso": "1", "luminance": "cd/m2", "k": "cd s/m2",
    "illuminance": "lx", "c": "lx s", "saturation-luminance": "cd/m2",
}  # fmt: skip


def unit_of(name: str, kind: str) -> Any:
    if name in LIGHT:
        return Q(1, LIGHT[name].format(*KINDS[kind]))
    return Q(1, OTHER[name])


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


# --- Every inverse.

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


# --- solve, check, rounding.

LOBE = [*spreads_module.LAWS["lobe"], *spreads_module.ANY_LAWS, spreads_module.INVERSE_SQUARE]
CONE = [*spreads_module.LAWS["cone"], *spreads_module.ANY_LAWS, spreads_module.INVERSE_SQUARE]
SURFACE = [*surfaces_module.LAWS, surfaces_module.FLAT, surfaces_module.CIRCLE]


def known(**values: float) -> dict[str, Known]:
    return {name.replace("_", "-"): Known(value) for name, value in values.items()}


@pytest.mark.parametrize(
    ("laws", "values"),
    [
        (LOBE, known(flux=900, beam_angle=0.5, distance=3, incidence=0.2, time=60, within=0.1)),
        (LOBE, known(irradiance=20, exponent=3, distance=3, cosine=0.5, receiver_area=0.01)),
        (LOBE, known(flux=500, intensity=900, height=3, lateral=1, incidence=0.3)),
        (CONE, known(flux=900, apex_angle=0.5, exposure=90, time=6, incidence=0.2)),
        (SURFACE, known(exposure=60, time=2, projected_solid_angle=0.3, radius=0.2)),
        (SURFACE, known(energy=60, time=2, radius=0.2, incident_irradiance=900)),
        (ev_module.LAWS, known(luminance=512, k=12.5, c=250, iso=400, f_number=8)),
        (calorimeter_module.LAWS, known(mass=0.1, specific_heat=385, temperature_rise=2,
                                        absorptance=0.9, time=30, receiver_area=0.01)),
    ],
)  # fmt: skip
def test_what_follows_does_not_depend_on_the_order_of_the_laws(laws, values):
    first = solve(laws, values)
    assert len(first.values) > len(values) + 2
    for seed in range(20):
        mixed = random.Random(seed).sample(laws, len(laws))
        other = solve(mixed, values)
        assert set(other.values) == set(first.values)
        for name, one in first.values.items():
            assert other.values[name].value == pytest.approx(one.value, rel=1e-9), name


@pytest.mark.parametrize("seed", range(6))
def test_a_surplus_value_is_checked_in_any_order_of_the_laws(seed):
    laws = random.Random(seed).sample(LOBE, len(LOBE))
    # 100 cd and n = 3: flux 2 pi 100 / 4 = 50 pi lm
    good = known(intensity=100, exponent=3, flux=50 * PI)
    assert solve(laws, good).values["solid-angle"].value == pytest.approx(PI / 2, rel=1e-12)
    for off in (1.001, 0.999, 2):
        bad = known(intensity=100, exponent=3, flux=50 * PI * off)
        with pytest.raises(Contradiction):
            solve(laws, bad)


@pytest.mark.parametrize(
    ("text", "off"),
    [  # half a unit of the last digit, over the number; fewer than three digits count as three
        ("2m", 0.005 / 2), ("2.00m", 0.005 / 2), ("2.000m", 0.0005 / 2), ("10cm", 0.05 / 10),
        ("15", 0.05 / 15), ("-15", 0.05 / 15), ("+1.5", 0.005 / 1.5), ("0.5", 0.0005 / 0.5),
        ("0.0012m", 0.000005 / 0.0012), ("12.5deg", 0.05 / 12.5), ("4.5klm", 0.005 / 4.5),
        ("1e3lx", 0.005), ("1.2345e-7W", 0.00005 / 1.2345), ("999", 0.5 / 999),
        ("1000lx", 0.5 / 1000), ("0", 1e-9), ("0.0", 1e-9), ("1/100s", 1e-9), ("1/3", 1e-9),
        ("pi", 1e-9), ("2pi", 1e-9), ("4π", 1e-9),
    ],
)  # fmt: skip
def test_the_rounding_of_a_number_as_typed(text, off):
    assert rounding(text) == pytest.approx(off, rel=1e-12)


@pytest.mark.parametrize(
    ("given_values", "fits"),
    [  # 800/(16 pi) = 15.9155 lx
        ({"illuminance": "15.9lx"}, True), ({"illuminance": "16lx"}, True),
        ({"illuminance": "15.92lx"}, True), ({"illuminance": "15.5lx"}, False),
        ({"illuminance": "17lx"}, False), ({"intensity": "63.7cd"}, True),
        ({"intensity": "63.66cd"}, True), ({"intensity": "64.5cd"}, False),
    ],
)  # fmt: skip
def test_what_is_typed_twice_is_compared_to_its_digits(given_values, fits):
    def call():
        return point_source(flux="800lm", distance="2m", incidence="0deg", **given_values)

    if fits:
        assert number(call(), "intensity", "cd") == pytest.approx(200 / PI, rel=5e-3)
    else:
        with pytest.raises(ConditionError, match=r"contradicts .*\(ratio "):
            call()


# --- Against quadrature: point source.


@pytest.mark.parametrize("n", [0.3, 1, 3, 20, 150.5])
def test_the_flux_of_a_lobe_is_the_integral_over_its_hemisphere(n):
    with mpmath.workdps(30):
        whole = (
            2
            * mpmath.pi
            * mpmath.quad(
                lambda t: mpmath.cos(t) ** mpf(n) * mpmath.sin(t), [0, 0.1, 0.5, mpmath.pi / 2]
            )
        )
        within = (
            2
            * mpmath.pi
            * mpmath.quad(
                lambda t: mpmath.cos(t) ** mpf(n) * mpmath.sin(t), [0, 0.1, mpmath.pi / 9]
            )
        )
    found = point_source(intensity="7cd", exponent=n, within="20deg")
    assert number(found, "flux", "lm") == pytest.approx(7 * float(whole), rel=1e-12)
    assert number(found, "flux_within", "lm") == pytest.approx(7 * float(within), rel=1e-12)
    back = point_source(intensity="7cd", flux=found["flux"], distribution="lobe")
    assert number(back, "exponent", "1") == pytest.approx(n, rel=1e-9)
    beam, field = (number(found, f"{name}_angle", "rad") / 2 for name in ("beam", "field"))
    assert math.cos(beam) ** n == pytest.approx(1 / 2, rel=1e-12)
    assert math.cos(field) ** n == pytest.approx(1 / 10, rel=1e-12)
    with mpmath.workdps(30):
        inside = (
            2
            * mpmath.pi
            * mpmath.quad(lambda t: mpmath.cos(t) ** mpf(n) * mpmath.sin(t), [0, beam / 2, beam])
        )
    assert number(found, "beam_flux", "lm") == pytest.approx(7 * float(inside), rel=1e-12)


@pytest.mark.parametrize("half", [1, 12.5, 60, 90, 135, 180])
@pytest.mark.parametrize("within", [0.5, 10, 100])
def test_the_flux_of_a_cone_is_the_integral_over_it(half, within):
    found = point_source(intensity="3cd", half_angle=f"{half}deg", within=f"{within}deg")
    for name, end in (("flux", half), ("flux_within", min(within, half))):
        with mpmath.workdps(30):
            part = 2 * mpmath.pi * mpmath.quad(mpmath.sin, [0, mpf(end) * mpmath.pi / 180])
        assert number(found, name, "lm") == pytest.approx(3 * float(part), rel=1e-12)
    back = point_source(intensity="3cd", flux=found["flux"], distribution="cone")
    # at 180 deg the solid angle hardly depends on the angle
    assert number(back, "half_angle", "deg") == pytest.approx(
        half, rel=1e-6 if half > 179 else 1e-9
    )


@pytest.mark.parametrize("within", [1, 60, 90, 170])
def test_the_part_of_an_isotropic_source_within_an_angle(within):
    found = point_source(intensity="3W/sr", within=f"{within}deg")
    part = 2 * PI * (1 - math.cos(math.radians(within)))
    assert number(found, "flux_within", "W") == pytest.approx(3 * part, rel=1e-12)
    assert number(found, "flux", "W") == pytest.approx(12 * PI, rel=1e-14)


@pytest.mark.parametrize("n", [0.5, 1, 4, 40])
@pytest.mark.parametrize(("height", "x", "y"), [(2, 1, 0), (2, 0, 0.3), (1, 3, -4), (5, -1, 2)])
def test_the_light_of_a_lobe_aside_of_its_axis(n, height, x, y):
    """E = I0 (h/d)^n (h/d) / d^2 on the floor, and turned to the lamp without the last cosine."""
    place = {"height": f"{height}m", "offset": f"{x}m", "offset_y": f"{y}m"}
    d = math.sqrt(height**2 + x**2 + y**2)
    expected = 900 * (height / d) ** n / d**2
    found = point_source(intensity="900cd", exponent=n, **place)
    assert number(found, "irradiance", "lx") == pytest.approx(expected * height / d, rel=1e-12)
    turned = point_source(intensity="900cd", exponent=n, incidence="0deg", **place)
    assert number(turned, "irradiance", "lx") == pytest.approx(expected, rel=1e-12)
    back = point_source(illuminance=found["irradiance"], exponent=n, **place)
    assert number(back, "intensity", "cd") == pytest.approx(900, rel=1e-12)


def test_a_cone_ends_at_its_edge():
    # at 3 m height the edge of a cone of 30 deg is at 3 tan(30 deg) = 1.73 m
    def at(offset):
        found = point_source(intensity="1cd", half_angle="30deg", height="3m", offset=offset)
        return number(found, "irradiance", "lx")

    assert at("1.73m") == pytest.approx(3 / (9 + 1.73**2) ** 1.5, rel=1e-12)
    assert at("1.74m") == 0


# --- Against quadrature: Lambertian sources.

NODES, WEIGHTS = np.polynomial.legendre.leggauss(160)


def interval(low: Any, high: Any) -> tuple[Any, Any]:
    return (low + high) / 2 + (high - low) / 2 * NODES, (high - low) / 2 * WEIGHTS


def seen(x: Any, y: Any, h: float, normal: tuple[float, ...]) -> Any:
    """cos cos / r^2 of an element at x, y of a ceiling, from a receiver h below the origin."""
    square = x * x + y * y + h * h
    toward = normal[0] * x + normal[1] * y + normal[2] * h
    assert (toward > -1e-9).all()  # the limits of integration end at the horizon
    return toward * h / square**2


def disc_integral(r: float, h: float, x: float, normal: tuple[float, ...]) -> float:
    """Over the strips across the offset, of a disc whose centre is at -x from the receiver."""
    low, high = -r - x, r - x
    if normal[0] > 0:
        low = max(low, -h * normal[2] / normal[0])
    if normal[0] < 0:
        high = min(high, -h * normal[2] / normal[0])
    # the half width of the disc is smooth in this angle
    a, b = (math.asin(max(-1.0, min(1.0, (end + x) / r))) for end in (low, high))
    total = 0.0
    for angle, weight in zip(*interval(a, b), strict=True):
        half = r * math.cos(angle)
        y, wy = interval(-half, half)
        u = r * math.sin(angle) - x
        total += weight * half * float((wy * seen(u + 0 * y, y, h, normal)).sum())
    return total


@pytest.mark.parametrize("incidence", [None, -20, 0, 10, 35, 70, 100])
@pytest.mark.parametrize(("r", "h", "x"), [(0.25, 0.75, 0.1), (1, 1, 2), (2, 1, 0.5), (1, 1, -2)])
def test_the_light_of_a_disc_is_the_integral_over_it(r, h, x, incidence):
    """The incidence turns the receiver from the line to the centre, away from the axis."""
    off = math.atan2(abs(x), h)
    tilt = 0.0 if incidence is None else off - math.radians(incidence)
    normal = (-math.copysign(1, x) * math.sin(tilt), 0.0, math.cos(tilt))
    angle = {} if incidence is None else {"incidence": f"{incidence}deg"}
    found = lambertian(
        "disc", radius=f"{r}m", height=f"{h}m", offset=f"{x}m", luminance="1e4cd/m2", **angle
    )
    expected = 1e4 * disc_integral(r, h, x, normal)
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-9)
    assert number(found, "configuration_factor", "1") == pytest.approx(
        expected / 1e4 / PI, rel=1e-9
    )


@pytest.mark.parametrize(("r", "d"), [(0.06, 3), (1, 1.5), (1, 1.02)])
@pytest.mark.parametrize("incidence", [0, 20, 50, 80, 90, 110])
def test_the_light_of_a_sphere_is_the_integral_over_what_is_above_the_horizon(r, d, incidence):
    """Rings about the receiver's normal: cos(a) = cos(t) cos(p) + sin(t) sin(p) cos(phi)."""
    found = lambertian(
        "sphere", radius=f"{r}m", distance=f"{d}m", incidence=f"{incidence}deg",
        luminance="2e4cd/m2",
    )  # fmt: skip
    with mpmath.workdps(25):
        a, t = mpmath.asin(mpf(r) / mpf(d)), mpf(incidence) * mpmath.pi / 180

        def ring(p):
            if t == 0 or p == 0:
                return 2 * mpmath.pi * mpmath.cos(p) * mpmath.sin(p)
            cosine = (mpmath.cos(a) - mpmath.cos(t) * mpmath.cos(p)) / mpmath.sin(t) / mpmath.sin(p)
            return 2 * mpmath.acos(max(-1, min(1, cosine))) * mpmath.cos(p) * mpmath.sin(p)

        low, high = max(t - a, 0), min(t + a, mpmath.pi / 2)
        inner = [abs(t - a)] if t < a < mpmath.pi / 2 else []
        ends = sorted({low, high, *(e for e in inner if low < e < high)})
        expected = 2e4 * float(mpmath.quad(ring, ends)) if high > low else 0.0
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-10)
    area = 4 * PI * r**2
    assert number(found, "flux", "lm") == pytest.approx(PI * 2e4 * area, rel=1e-12)
    assert number(found, "intensity", "cd") == pytest.approx(2e4 * PI * r**2, rel=1e-12)


def rectangle_integral(w, l, h, x, y, normal) -> float:  # noqa: E741
    """The rectangle's centre is at (-x, -y) from the receiver; cut where the normal is level."""
    box = [[-w / 2 - x, w / 2 - x], [-l / 2 - y, l / 2 - y]]
    for axis in (0, 1):
        if normal[axis] and not normal[1 - axis]:
            at = -h * normal[2] / normal[axis]
            if normal[axis] > 0:
                box[axis][0] = max(box[axis][0], at)
            else:
                box[axis][1] = min(box[axis][1], at)
    (u, wu), (v, wv) = interval(*box[0]), interval(*box[1])
    values = seen(u[:, None], v[None, :], h, normal)
    return float(wu @ values @ wv)


PLACES = [(0, 0), (0.5, 1), (0.3, 0.2), (2, -1.5), (-0.4, 3)]


@pytest.mark.parametrize(("x", "y"), PLACES)
def test_the_light_of_a_rectangle_is_the_integral_over_it(x, y):
    found = lambertian(
        "rectangle", luminance="3000cd/m2", width="1m", length="2m", height="1.5m",
        offset=f"{x}m", offset_y=f"{y}m",
    )  # fmt: skip
    expected = 3000 * rectangle_integral(1, 2, 1.5, x, y, (0, 0, 1))
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize(("x", "y"), PLACES)
def test_the_light_across_a_rectangle_is_the_integral_over_it(x, y):
    found = lambertian(
        "rectangle", perpendicular=True, luminance="3000cd/m2", width="1m", length="2m",
        height="1.5m", offset=f"{x}m", offset_y=f"{y}m",
    )  # fmt: skip
    expected = 3000 * rectangle_integral(1, 2, 1.5, x, y, (0, -1 if y > 0 else 1, 0))
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize(
    ("x", "y", "incidence"),
    [
        *itertools.product((0.3, 2, -2), (0,), (-30, 0, 15, 60, 85)),
        *itertools.product((0,), (0.7, -3), (-30, 0, 15, 60, 85)),
        *itertools.product((0.3, -0.3), (0.4,), (-10, 0, 15)),  # no horizon across its corners
    ],
)
def test_the_light_on_a_receiver_turned_under_a_rectangle(x, y, incidence):
    lateral = math.hypot(x, y)
    tilt = math.atan2(lateral, 1.5) - math.radians(incidence)
    normal = (-x / lateral * math.sin(tilt), -y / lateral * math.sin(tilt), math.cos(tilt))
    found = lambertian(
        "rectangle", luminance="3000cd/m2", width="1m", length="2m", height="1.5m",
        offset=f"{x}m", offset_y=f"{y}m", incidence=f"{incidence}deg",
    )  # fmt: skip
    expected = 3000 * rectangle_integral(1, 2, 1.5, x, y, tuple(n + 0.0 for n in normal))
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-10)


def test_a_corner_is_half_the_width_and_the_length_aside():
    sizes = {"luminance": "3000cd/m2", "width": "1m", "length": "2m", "height": "1.5m"}
    for flags in ((), ("perpendicular",)):
        normal = (0, -1, 0) if flags else (0, 0, 1)
        found = lambertian("rectangle", corner=True, **dict.fromkeys(flags, True), **sizes)
        expected = 3000 * rectangle_integral(1, 2, 1.5, 0.5, 1, normal)
        assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize("shape", ["hemisphere", "plane"])
@pytest.mark.parametrize("tilt", [0, 30, 90, 135, 180])
def test_the_light_of_a_sky_on_a_tilted_plane(shape, tilt):
    found = lambertian(shape, luminance="3000cd/m2", incidence=f"{tilt}deg")
    expected = 3000 * PI / 2 * (1 + math.cos(math.radians(tilt)))
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-12, abs=1e-9)


@pytest.mark.parametrize(("r", "d"), [(0.25, 0.75), (3, 0.5), (0.01, 4)])
def test_the_size_and_the_distance_of_a_disc_and_of_a_sphere_from_their_light(r, d):
    part = {"disc": r**2 / (r**2 + d**2), "sphere": (r / (r + d)) ** 2}
    away = {"disc": d, "sphere": r + d}
    for shape, factor in part.items():
        lit = {"luminance": Q(1e4, "cd/m2"), "illuminance": Q(1e4 * PI * factor, "lx")}
        size = lambertian(shape, distance=Q(away[shape], "m"), **lit)
        assert number(size, "radius", "m") == pytest.approx(r, rel=1e-9)
        far = lambertian(shape, radius=Q(r, "m"), **lit)
        assert number(far, "distance", "m") == pytest.approx(away[shape], rel=1e-9)
        twice = lambertian(shape, diameter=Q(2 * r, "m"), **lit)
        assert number(twice, "distance", "m") == pytest.approx(away[shape], rel=1e-9)


# --- The questions of the lecture.


def test_the_flux_of_the_cosine_spot():
    # I0 cos^n over a hemisphere: 2 pi I0 / (n + 1), n = ln 2 / -ln cos 15 deg for 30 deg FWHM
    n = math.log(2) / -math.log(math.cos(math.radians(15)))
    found = point_source(intensity="1000cd", beam_angle="30deg")
    assert number(found, "exponent", "1") == pytest.approx(n, rel=1e-12)
    assert number(found, "flux", "lm") == pytest.approx(2000 * PI / (n + 1), rel=1e-12)
    assert round(number(found, "flux", "lm")) == 299  # as the issue has it


def test_the_flux_of_the_cone_spot():
    found = point_source(flux="4.5klm", half_angle="12.5deg", distance="2m")
    candela = 4500 / (2 * PI * (1 - math.cos(math.radians(12.5))))
    assert number(found, "intensity", "cd") == pytest.approx(candela, rel=1e-12)
    assert number(found, "irradiance", "lx") == pytest.approx(candela / 4, rel=1e-12)


def test_the_isotropic_source():
    found = point_source(flux="800lm", distance="2m")
    assert number(found, "intensity", "cd") == pytest.approx(200 / PI, rel=1e-14)
    assert number(found, "irradiance", "lx") == pytest.approx(50 / PI, rel=1e-14)


def test_the_sphere_seen_from_a_distance():
    found = lambertian("sphere", luminance="2e4cd/m2", radius="6cm", distance="3m")
    assert number(found, "irradiance", "lx") == pytest.approx(2e4 * PI * 0.02**2, rel=1e-12)
    omega = 2 * PI * (1 - math.sqrt(1 - 0.02**2))
    assert number(found, "solid_angle", "sr") == pytest.approx(omega, rel=1e-10)


@pytest.mark.parametrize("half", [10, 45, 80])
def test_a_disc_and_a_part_of_a_hemisphere_light_the_axis_alike(half):
    tangent = math.tan(math.radians(half))
    disc = lambertian("disc", luminance="1e4cd/m2", radius=f"{tangent!r}m", distance="1m")
    sky = lambertian("hemisphere", luminance="1e4cd/m2", half_angle=f"{half}deg")
    expected = 1e4 * PI * math.sin(math.radians(half)) ** 2
    for found in (disc, sky):
        assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-12)


def test_the_irradiance_of_the_sun():
    # IAU 2015 B3: R = 695 700 km, 3.828e26 W, so M = L/(4 pi R^2), and 1361 W/m2 at 1 au
    au, r, power = 149597870700, 695700e3, 3.828e26
    found = lambertian("sphere", radiance=f"{power / (4 * PI**2 * r**2)!r}W/m2/sr",
                       radius="695700km", distance="1au")  # fmt: skip
    assert number(found, "irradiance", "W/m2") == pytest.approx(power / (4 * PI * au**2), rel=1e-12)
    assert round(number(found, "irradiance", "W/m2")) == 1361
    assert number(found, "flux", "W") == pytest.approx(power, rel=1e-12)
    assert number(lambertian(radiance="2.0e7W/m2/sr"), "exitance", "W/m2") == 2e7 * PI


@pytest.mark.parametrize(
    ("call", "name", "unit", "expected"),
    [  # the other lines of the issue, each by its formula
        (lambda: point_source(illuminance="500lx", distance="2m"), "flux", "lm", 8000 * PI),
        (lambda: point_source(intensity="100cd", illuminance="25lx"), "distance", "m", 2),
        (lambda: point_source(intensity="250cd", height="6m", offset="8m"), "irradiance", "lx",
         1.5),
        (lambda: point_source(intensity="100cd", exponent=3, within="45deg"), "flux_within", "lm",
         50 * PI * 0.75),
        (lambda: point_source(flux="500lm", intensity="900cd", distribution="cone"), "half_angle",
         "rad", math.acos(1 - 500 / 900 / 2 / PI)),
        (lambda: lambertian(luminance="100cd/m2", area="0.1m2"), "flux", "lm", 10 * PI),
        (lambda: lambertian(luminance="100cd/m2", area="0.1m2"), "intensity", "cd", 10),
        (lambda: lambertian(incident_illuminance="500lx", reflectance=0.8), "radiance", "cd/m2",
         400 / PI),
        (lambda: lambertian("disc", radius="25cm", distance="75cm", illuminance="70lx"),
         "exitance", "lm/m2", 700),
        (lambda: ev(ev100=15), "luminance", "cd/m2", 4096),
        (lambda: ev(ev100=15), "illuminance", "lx", 81920),
        (lambda: ev(luminance="1000cd/m2"), "ev100", "1", math.log2(8000)),
        (lambda: ev(f_number=16, time="1/100s", iso=100), "ev", "1", math.log2(25600)),
        (lambda: ev(illuminance="500lx", f_number=4, iso=400), "time", "s", 16 / 800),
        (lambda: calorimeter(mass="10g", specific_heat="385J/kg/K", temperature_rise="2K",
                             time="30s"), "flux", "W", 7.7 / 30),
        (lambda: calorimeter(irradiance="1000W/m2", receiver_area="20cm2", absorptance=0.95,
                             time="1min", mass="10g", specific_heat="385J/kg/K"),
         "temperature_rise", "K", 0.95 * 120 / 3.85),
    ],
)  # fmt: skip
def test_the_lines_of_the_issue(call, name, unit, expected):
    assert number(call(), name, unit) == pytest.approx(expected, rel=1e-12)


# --- Refusals.


def refused(words: str) -> str:
    done = run(*words.split())
    assert done.returncode == 2, done.stdout
    assert done.stdout == ""
    assert "\ntry: " in done.stderr
    return done.stderr


@pytest.mark.parametrize(
    ("words", "parts"),
    [
        # too little: which quantities would do
        ("point-source --flux 800lm -g irradiance:lx", ["irradiance", "--distance"]),
        ("point-source --intensity 100cd -g exposure:lx.s", ["exposure"]),
        ("point-source --flux 800lm -g energy:lm.s", ["energy", "--time"]),
        ("point-source --distance 2m", ["--flux, --intensity or --irradiance"]),
        ("point-source --flux 800lm --offset 2m", ["--height"]),
        ("point-source --illuminance 25lx -g distance:m", ["distance", "--flux", "--intensity"]),
        ("lambertian --luminance 100cd/m2 -g flux:lm", ["flux", "--area"]),
        ("lambertian --incident-illuminance 500lx -g radiance:cd/m2", ["--reflectance"]),
        ("lambertian disc --luminance 9cd/m2 --radius 1m -g irradiance:lx", ["--distance"]),
        ("ev --iso 100", ["--ev100, --luminance, --illuminance or --f-number"]),
        ("calorimeter --mass 10g", ["--mass 10g", "without --mass"]),
        # contradictions: both values and the ratio; 800/(16 pi) = 15.9155, 20/15.9155 = 1.25664
        ("point-source --flux 800lm --distance 2m --illuminance 20lx",
         ["--illuminance 20lx", "15.9155 lx", "ratio 1.25664"]),
        ("point-source --flux 800lm --intensity 100cd",
         ["--flux 800lm", "1256.64 lm", "ratio 0.63662"]),
        ("lambertian --luminance 100cd/m2 --exitance 200lm/m2",
         ["--exitance 200lm/m2", "314.159 lm/m2", "ratio 0.63662"]),
        ("ev --ev100 15 --luminance 1000cd/m2", ["4096", "1000cd/m2"]),
        ("calorimeter --flux 5W --time 2s --energy 20J", ["10", "ratio 2"]),
        # impossible: the limit
        ("lambertian --luminance 400cd/m2 --incident-illuminance 500lx", ["2.51327"]),
        ("lambertian --incident-illuminance 500lx --reflectance 1.2", ["from 0 to 1"]),
        ("lambertian disc --luminance 10cd/m2 --radius 1m --illuminance 40lx",
         ["whole hemisphere"]),
        ("lambertian sphere --luminance 10cd/m2 --radius 1m --illuminance 40lx",
         ["whole hemisphere"]),
        ("calorimeter --energy 1J --mass 10g --specific-heat 385J/kg/K --temperature-rise 2K",
         ["absorptance above 1"]),
        ("calorimeter --energy 1J --absorptance 1.5", ["from 0 to 1"]),
        ("point-source --intensity 1cd --beam-angle 180deg", ["180 deg"]),
        ("point-source --intensity 1cd --half-angle 181deg", ["180 deg"]),
        ("point-source --intensity 1cd --apex-angle 361deg", ["360 deg"]),
        ("point-source --intensity 1cd --flux 7lm --distribution lobe", ["hemisphere"]),
        ("point-source --intensity 1cd --flux 13lm --distribution cone", ["sr"]),
        ("point-source --intensity 1cd --distance 1m --illuminance 2lx", ["contradicts", "ratio"]),
        ("point-source --intensity 1cd --distance -1m", ["more than 0"]),
        ("point-source --intensity 1cd --distance 1m --receiver-area 1m2",
         ["too large", "5.6419 m"]),
        ("lambertian --luminance 1cd/m2 --area 1m2 --distance 1m", ["five times", "1.12838 m"]),
        ("lambertian sphere --luminance 1cd/m2 --radius 1m --distance 50cm", ["radius"]),
        # of another calculator, kind or shape
        ("point-source --luminous-flux 5W", ["luminous flux"]),
        ("point-source --illuminance 5W/m2 --distance 1m", ["illuminance"]),
        ("point-source --flux 5W --illuminance 20lx", ["--wavelength, --spectrum or --efficacy"]),
        ("point-source --flux 5lm --luminous-flux 5lm", ["the same quantity"]),
        ("calorimeter --flux 5lm --time 1s", ["watts"]),
        ("point-source --flux 5lm --half-angle 9deg --exponent 3", ["--half-angle", "--exponent"]),
        ("point-source --flux 5lm --half-angle 9deg --distribution lobe", ["--half-angle"]),
        ("lambertian disc --luminance 9cd/m2 --width 1m", ["--width"]),
        ("lambertian disc --luminance 9cd/m2 --corner --radius 1m", ["--corner"]),
        ("lambertian cube --luminance 9cd/m2", ["cube"]),
        ("lambertian disc --luminance 9cd/m2 --radius 1m --diameter 2m --height 1m",
         ["--radius and --diameter"]),
        ("point-source --flux 1lm,2lm --distance 1m,2m", ["both lists"]),
    ],
)  # fmt: skip
def test_what_has_no_answer_is_refused_and_says_why(words, parts):
    said = refused(words)
    for part in parts:
        assert part in said, said


POINT = (*point_module.QUANTITIES, *point_module.INPUTS, *light_module.LINKS,
         *light_module.REFINEMENTS)  # fmt: skip
SURFACES = (*lambertian_module.QUANTITIES, *lambertian_module.INPUTS, *light_module.LINKS,
            *light_module.REFINEMENTS)  # fmt: skip
CALORIMETER = (*calorimeter_module.QUANTITIES, *calorimeter_module.INPUTS)
EXAMPLE = {
    "wavelength": "555nm", "spectrum": "D65", "efficacy": "93lm/W", "observer": "scotopic",
    "range": "400nm:700nm", "photon-range": "380nm:780nm", "k": "14cd.s/m2", "c": "320lx.s",
    "iso": "800", "absorptance": "0.9", "offset": "10cm", "offset-y": "10cm", "tilt": "10deg",
    "incidence": "10deg", "half-angle": "20deg", "apex-angle": "50deg",
}  # fmt: skip
BASES: list[tuple[Any, tuple[str, ...], tuple[str, ...], dict[str, str]]] = [
    *(
        (point_source, (), POINT, base)
        for base in (
            {"flux": "800lm"},
            {"intensity": "100cd"},
            {"irradiance": "5lx"},
            {"exposure": "5lx.s"},
            {"energy": "5lm.s"},
            {"flux": "800lm", "distance": "2m"},
            {"irradiance": "5lx", "distance": "2m"},
            {"intensity": "100cd", "height": "6m"},
            {"intensity": "100cd", "height": "6m", "offset": "1m"},
            {"intensity": "100cd", "beam-angle": "30deg"},
            {"intensity": "100cd", "exponent": "3", "distance": "2m"},
            {"flux": "100lm", "half-angle": "30deg"},
            {"flux": "100lm", "half-angle": "30deg", "distance": "2m"},
            {"flux": "100lm", "spectrum": "D65"},
        )
    ),
    *((lambertian, ("patch",), SURFACES, base)
      for base in (
          {"radiance": "9cd/m2"}, {"irradiance": "9lx"}, {"exitance": "9lm/m2"},
          {"flux": "9lm"}, {"intensity": "9cd"}, {"energy": "9lm.s"},
          {"incident-irradiance": "9lx"}, {"radiance": "9cd/m2", "area": "1cm2"},
          {"radiance": "9cd/m2", "area": "1cm2", "distance": "1m"})),
    *((lambertian, (shape,), SURFACES, base)
      for shape in ("disc", "sphere")
      for base in (
          {"radiance": "9cd/m2"}, {"radiance": "9cd/m2", "radius": "1m"},
          {"radiance": "9cd/m2", "distance": "3m"},
          {"radiance": "9cd/m2", "radius": "1m", "distance": "3m"})),
    (lambertian, ("disc",), SURFACES, {"flux": "9lm", "radius": "1m", "height": "3m"}),
    *((lambertian, ("rectangle",), SURFACES, base)
      for base in (
          {"radiance": "9cd/m2"}, {"radiance": "9cd/m2", "width": "1m"},
          {"radiance": "9cd/m2", "width": "1m", "length": "2m", "height": "3m"})),
    (flagged, ("rectangle", "corner"), SURFACES,
     {"radiance": "9cd/m2", "width": "1m", "length": "2m", "height": "3m"}),
    (flagged, ("rectangle", "perpendicular"), SURFACES,
     {"radiance": "9cd/m2", "width": "1m", "length": "2m", "height": "3m", "offset-y": "30cm"}),
    *((lambertian, (shape,), SURFACES, {"radiance": "9cd/m2"})
      for shape in ("plane", "hemisphere")),
    *((ev, (), ev_module.INPUTS, base)
      for base in (
          {"ev100": "15"}, {"ev": "12"}, {"luminance": "99cd/m2"}, {"illuminance": "99lx"},
          {"f-number": "16"}, {"f-number": "16", "time": "1/100s"},
          {"ev": "12", "ev100": "10"})),
    *((calorimeter, (), CALORIMETER, base)
      for base in (
          {"flux": "5W"}, {"energy": "5J"}, {"irradiance": "5W/m2"},
          {"flux": "5W", "time": "2s"}, {"irradiance": "5W/m2", "receiver-area": "1cm2"},
          {"energy": "5J", "mass": "10g"}, {"energy": "5J", "mass": "10g",
                                            "specific-heat": "385J/kg/K"})),
]  # fmt: skip


def answer_of(call: Any, words: tuple[str, ...], values: dict[str, str]) -> dict[str, Any] | None:
    try:
        return call(*words, **{name.replace("-", "_"): text for name, text in values.items()})
    except RadcalcError:
        return None


def example_of(name: str) -> str:
    option = inputs_module.INPUTS.get(name)
    return EXAMPLE.get(name) or (option or light_module.option(name)).example


@pytest.mark.parametrize(
    ("call", "words", "options", "base"),
    BASES,
    ids=[" ".join((b[0].__name__, *b[1], *b[3])) for b in BASES],
)
def test_an_option_is_refused_or_changes_something_else(call, words, options, base):
    before = answer_of(call, words, base) or {}  # alone it may say what it lacks
    given_names = {name.replace("-", "_") for name in base}
    accepted = []
    for name in options:
        if name in base:
            continue
        after = answer_of(call, words, {**base, name: example_of(name)})
        if after is None:
            continue
        told = {*given_names, name.replace("-", "_")}
        others = {n: str(q) for n, q in after.items() if n not in told}
        if others == {n: str(q) for n, q in before.items() if n not in told}:
            accepted.append(f"--{name} {example_of(name)}")
    assert not accepted


# --- Kinds.


@pytest.mark.parametrize(
    "link", [{"wavelength": "632.8nm"}, {"spectrum": "D65"}, {"efficacy": "93lm/W"}]
)
@pytest.mark.parametrize(
    ("law", "typed"),
    [
        (point_module.point_source, {"flux": "800lm", "distance": "2m", "time": "3s"}),
        (point_module.point_source, {"intensity": "8W/sr", "beam_angle": "30deg"}),
        (point_module.point_source, {"photon_irradiance": "8umol/m2/s", "distance": "2m"}),
        (lambda v: lambertian_module.lambertian("disc", v), {
            "luminance": "9cd/m2", "radius": "1m", "distance": "3m", "reflectance": "0.5"}),
        (lambda v: lambertian_module.lambertian("patch", v), {
            "radiance": "9W/m2/sr", "area": "1cm2", "distance": "3m"}),
    ],
)  # fmt: skip
def test_all_kinds_are_what_convert_makes_of_them(law, typed, link):
    if "photon_irradiance" in typed and "efficacy" in link:
        link = {"efficacy": "2.1umol/J"}
    values, *_ = law(api._inputs({**typed, **link}))
    table: dict[str, dict[str, float]] = {}
    for value in values:
        for name, kind in itertools.product(light_module.GEOMETRY, "evp"):
            if value.units and value.also == light_module.specific(name, kind):
                table.setdefault(name, {})[kind] = value.si
    assert len(table) >= 3
    for name, row in table.items():
        assert len(row) == (2 if "efficacy" in link else 3), name
        own, *others = row  # the kind that was given comes first
        start = Q(row[own], LIGHT[name].format(*KINDS[own]))
        for kind in others:
            expected = radcalc.convert(start, LIGHT[name].format(*KINDS[kind]), **link)
            assert row[kind] == pytest.approx(expected.magnitude, rel=1e-12), (name, kind)


@pytest.mark.parametrize("quantity", ["flux", "irradiance", "intensity"])
def test_the_api_has_every_kind_too(quantity):
    found = point_source(flux="800lm", distance="2m", wavelength="555nm")
    for kind in "evp":
        unit = Q(1, LIGHT[quantity].format(*KINDS[kind]))
        assert any(one.check(unit.dimensionality) for one in found.values()), kind


def test_another_kind_may_be_given_for_what_is_solved():
    # at 555 nm of 540 THz 683 lm/W: 1 W isotropic gives 683.002 / (4 pi) lx at 1 m
    watts = point_source(flux="1W", illuminance=Q(683.002 / 4 / PI, "lx"), wavelength="555nm")
    assert number(watts, "distance", "m") == pytest.approx(1, rel=1e-6)


@pytest.mark.parametrize(
    ("generic", "own", "value"),
    [
        ("flux", "luminous_flux", "5lm"), ("flux", "radiant_flux", "5W"),
        ("flux", "photon_flux", "5umol/s"), ("intensity", "luminous_intensity", "5cd"),
        ("intensity", "radiant_intensity", "5W/sr"),
        ("intensity", "photon_intensity", "5umol/s/sr"),
        ("irradiance", "illuminance", "5lx"), ("irradiance", "photon_irradiance", "5umol/m2/s"),
        ("exposure", "luminous_exposure", "5lx.s"), ("exposure", "radiant_exposure", "5J/m2"),
        ("energy", "radiant_energy", "5J"), ("energy", "photon_number", "5umol"),
    ],
)  # fmt: skip
def test_generic_and_specific_names_are_the_same(generic, own, value):
    more = {"time": "2s", "distance": "2m"}
    one, other = point_source(**{generic: value}, **more), point_source(**{own: value}, **more)
    assert {n: str(q) for n, q in one.items()} == {n: str(q) for n, q in other.items()}
    wrong = {"lm": "5W", "W": "5lm"}.get(value[1:3].strip("/"), "5m")
    with pytest.raises(RadcalcError):
        point_source(**{own: wrong}, **more)


# --- Long ranges and arrays.


@pytest.mark.parametrize(
    ("command", "option", "start", "step", "unit"),
    [
        ("point-source --flux 800lm -g irradiance:lx -g intensity:cd", "--distance", 1, 0.005, "m"),
        ("point-source --intensity 9cd --exponent 3 --height 2m -g irradiance:lx -g off-axis:deg",
         "--offset", 0, 0.01, "m"),
        ("lambertian sphere --luminance 2e4cd/m2 --radius 6cm -g irradiance:lx", "--distance",
         0.1, 0.003, "m"),
        ("ev --f-number 8 -g ev100:1 -g luminance:cd/m2", "--time", 0.001, 0.001, "s"),
        ("calorimeter --energy 5J --mass 10g -g temperature-rise:K", "--specific-heat", 100, 0.7,
         "J/kg/K"),
    ],
)  # fmt: skip
def test_a_long_range_prints_what_single_values_print(command, option, start, step, unit):
    count = 1203
    stop = start + step * (count - 1)
    done = run(*command.split(), option, f"{start}{unit}:{stop:.12g}{unit}:{step}{unit}")
    lines = done.stdout.splitlines()
    assert len(lines) == count, done.stderr
    picked = random.Random(command).sample(range(count), 40)
    texts = ",".join(f"{start + k * step:.15g}{unit}" for k in picked)
    short = run(*command.split(), option, texts)
    assert [lines[k] for k in picked] == short.stdout.splitlines()
    alone = run(*command.split(), option, f"{start + picked[0] * step:.15g}{unit}")
    assert alone.stdout.splitlines() == [lines[picked[0]]]


@pytest.mark.parametrize(
    ("call", "words", "base", "name", "values"),
    [
        (point_source, (), {"flux": "800lm"}, "distance", Q([1.0, 2, 5, 9.7], "m")),
        (point_source, (), {"flux": "800lm", "within": "50deg"}, "exponent", Q([0.5, 1, 90], "1")),
        (point_source, (), {"flux": "800lm", "distance": "2m"}, "beam-angle",
         Q([1.0, 40, 179], "deg")),
        (point_source, (), {"intensity": "800cd", "height": "3m", "half-angle": "30deg"}, "offset",
         Q([0.0, 1, 1.7, 2], "m")),
        (point_source, (), {"intensity": "800cd", "height": "3m", "exponent": "2"}, "offset",
         Q([0.0, -1, 1.7, 20], "m")),
        (point_source, (), {"flux": "5mW", "wavelength": "632.8nm"}, "distance",
         Q([1.0, 2], "m")),
        (lambertian, ("patch",), {"radiance": "9W/m2/sr", "area": "1mm2"}, "distance",
         Q([1.0, 2, 3], "m")),
        (lambertian, ("disc",), {"radiance": "9W/m2/sr", "radius": "1m", "height": "1m"}, "offset",
         Q([0.0, -1, 1, 3], "m")),
        (lambertian, ("disc",), {"radiance": "9W/m2/sr", "irradiance": "1W/m2"}, "distance",
         Q([0.1, 1, 30], "m")),
        (lambertian, ("sphere",), {"radiance": "9W/m2/sr", "radius": "1m", "distance": "2m"},
         "incidence", Q([0.0, 50, 70, 119, 121], "deg")),
        (lambertian, ("rectangle",), {"radiance": "9W/m2/sr", "width": "1m", "length": "2m",
                                      "offset": "1m"}, "height", Q([0.1, 1, 30], "m")),
        (flagged, ("rectangle", "perpendicular"),
         {"radiance": "9W/m2/sr", "width": "1m", "length": "2m", "height": "1m"}, "offset-y",
         Q([0.5, 1.5], "m")),
        (flagged, ("rectangle", "perpendicular"),
         {"radiance": "9W/m2/sr", "width": "1m", "length": "2m", "height": "1m"}, "offset-y",
         Q([-0.5, 0, 0.5], "m")),
        (lambertian, ("rectangle",),
         {"radiance": "9W/m2/sr", "width": "1m", "length": "2m", "height": "1m",
          "incidence": "20deg"}, "offset", Q([0.0, 1, -1], "m")),
        (lambertian, ("rectangle",),
         {"radiance": "9W/m2/sr", "width": "1m", "length": "2m", "height": "1m",
          "incidence": "20deg"}, "offset", Q([0.5, 1, -1], "m")),
        (lambertian, ("disc",),
         {"radiance": "9W/m2/sr", "radius": "1m", "height": "1m", "incidence": "20deg"},
         "offset", Q([0.0, 1, -1], "m")),
        (lambertian, ("hemisphere",), {"radiance": "9W/m2/sr"}, "incidence",
         Q([0.0, 50, 180], "deg")),
        (ev, (), {"f-number": "8"}, "time", Q([0.001, 1, 30], "s")),
        (calorimeter, (), {"energy": "8J", "mass": "1g"}, "specific-heat",
         Q([100.0, 385], "J/kg/K")),
    ],
)  # fmt: skip
def test_arrays_give_what_floats_give(call, words, base, name, values):
    given_values = {n.replace("-", "_"): text for n, text in base.items()}
    own = name.replace("-", "_")
    columns = call(*words, **given_values, **{own: values})
    changing = 0
    for k, value in enumerate(values.magnitude):
        one = call(*words, **given_values, **{own: Q(float(value), values.units)})
        assert set(one) == set(columns)
        for result, single in one.items():
            column = columns[result].to(single.units).magnitude
            shape = np.shape(column)
            assert shape in ((), (len(values.magnitude),))
            changing += bool(shape)
            got = column[k] if shape else column
            assert got == pytest.approx(single.magnitude, rel=1e-13, abs=1e-15), result
    assert changing > len(values.magnitude)


def test_arrays_are_broadcast_together():
    found = point_source(flux=Q([100.0, 200, 300], "lm"), distance=Q([1.0, 2, 3], "m"))
    expected = [f / (4 * PI * d * d) for f, d in ((100, 1), (200, 2), (300, 3))]
    assert found["irradiance"].to("lx").magnitude == pytest.approx(expected, rel=1e-14)


def test_a_bad_element_of_an_array_is_refused():
    for bad in itertools.permutations([1.0, 2, -3]):
        with pytest.raises(ConditionError):
            point_source(flux="1lm", distance=Q(list(bad), "m"))
    with pytest.raises((ConditionError, UsageError)):
        lambertian(incident_illuminance="9lx", reflectance=Q([0.5, 1.1], "1"))
