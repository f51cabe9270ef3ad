"""Watts, lumens and photons in one answer, and the names of each kind."""

import itertools
import math

import pytest
from helpers import KINDS, LIGHT, Q, number

import radcalc
from radcalc import point_source
from radcalc.calculators import lambertian as lambertian_module
from radcalc.calculators import point_source as point_module
from radcalc.errors import RadcalcError
from radcalc.inputs.reading import read
from radcalc.quantities.symbols import SYMBOLS, specific_name

PI = math.pi
GENERIC = [name for name, symbol in SYMBOLS.items() if symbol.generic == name]


@pytest.mark.parametrize(
    "link", [{"wavelength": "632.8nm"}, {"spectrum": "D65"}, {"efficacy": "93lm/W"}]
)
@pytest.mark.parametrize(
    ("law", "typed"),
    [
        (point_module.point_source, {"flux": "800lm", "distance": "2m", "time": "3s"}),
        (point_module.point_source, {"intensity": "8W/sr", "beam-angle": "30deg"}),
        (point_module.point_source, {"photon-irradiance": "8umol/m2/s", "distance": "2m"}),
        (lambda v: lambertian_module.lambertian("disc", v), {
            "luminance": "9cd/m2", "radius": "1m", "distance": "3m", "reflectance": "0.5"}),
        (lambda v: lambertian_module.lambertian("patch", v), {
            "radiance": "9W/m2/sr", "area": "1cm2", "distance": "3m"}),
    ],
)  # fmt: skip
def test_all_kinds_agree_with_convert(law, typed, link):
    if "photon-irradiance" in typed and "efficacy" in link:
        link = {"efficacy": "2.1umol/J"}
    answer = law({name: read(name, text) for name, text in {**typed, **link}.items()})
    table: dict[str, dict[str, float]] = {}
    for value in answer.values:
        for name, kind in itertools.product(GENERIC, "evp"):
            if not value.is_absent and value.also == specific_name(name, kind):
                table.setdefault(name, {})[kind] = value.amount
    assert len(table) >= 3
    for name, row in table.items():
        assert len(row) == (2 if "efficacy" in link else 3), name
        own, *others = row  # the kind that was given comes first
        start = Q(row[own], LIGHT[name].format(*KINDS[own]))
        for kind in others:
            expected = radcalc.convert(start, LIGHT[name].format(*KINDS[kind]), **link)
            assert row[kind] == pytest.approx(expected.magnitude, rel=1e-12), (name, kind)


@pytest.mark.parametrize("quantity", ["flux", "irradiance", "intensity"])
def test_the_api_has_all_kinds(quantity):
    found = point_source(flux="800lm", distance="2m", wavelength="555nm")
    for kind in "evp":
        unit = Q(1, LIGHT[quantity].format(*KINDS[kind]))
        assert any(one.check(unit.dimensionality) for one in found.values()), kind


def test_a_quantity_may_be_given_in_another_kind():
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


@pytest.mark.parametrize("quantity", ["flux", "intensity", "irradiance", "exposure", "energy"])
@pytest.mark.parametrize(("kinds", "ratio"), [("ve", 250.0), ("pe", 3e18), ("vp", 7e-17)])
def test_a_quantity_in_two_kinds_links_all_the_others(quantity, kinds, ratio):
    """By the ratio of their numbers, in either order."""
    texts = {
        k: f"{n}{LIGHT[quantity].format(*KINDS[k])}"
        for k, n in zip(kinds, (4 * ratio, 4), strict=True)
    }
    for order in (kinds, kinds[::-1]):
        given = {specific_name(quantity, kind): texts[kind] for kind in order}
        given |= {"time": "10s", "distance": "3m"}
        answer = point_module.point_source({name: read(name, text) for name, text in given.items()})
        sizes = {v.label.replace(" ", "-"): v.amount for v in answer.values if not v.is_absent}
        for name in ("flux", "intensity", "irradiance", "exposure", "energy"):
            one, other = (sizes[specific_name(name, kind)] for kind in kinds)
            assert one / other == pytest.approx(ratio, rel=1e-12), name


def test_two_kinds_are_compared_to_their_digits():
    """800 lm / 3 W is 267 lm/W to the digits typed; with it 0.239 W/sr are 63.7 cd."""
    typed = {"luminous_flux": "800lm", "radiant_flux": "3.00W"}
    assert point_source(**typed, radiant_intensity="0.239W/sr")
    assert point_source(radiant_intensity="0.239W/sr", **typed)
    with pytest.raises(RadcalcError, match="contradicts"):
        point_source(radiant_intensity="0.25W/sr", **typed)


@pytest.mark.parametrize("n", [0.5, 1, 7.5, 200])
def test_the_widths_of_a_lobe_and_of_a_cone_without_light(n):
    half, tenth = (2 * math.degrees(math.acos(left ** (1 / n))) for left in (0.5, 0.1))
    for name, text in (
        ("exponent", n),
        ("beam_angle", f"{half}deg"),
        ("field_angle", f"{tenth}deg"),
    ):
        found = point_source(**{name: text})
        assert number(found, "exponent", "1") == pytest.approx(n, rel=1e-9)
        assert number(found, "beam_angle", "deg") == pytest.approx(half, rel=1e-9)
        assert number(found, "field_angle", "deg") == pytest.approx(tenth, rel=1e-9)
    omega = 2 * PI * (1 - math.cos(math.radians(half / 2)))
    for name, text in (
        ("half_angle", f"{half / 2}deg"),
        ("apex_angle", f"{half}deg"),
        ("solid_angle", f"{omega}sr"),
    ):
        found = point_source(**{name: text})
        assert number(found, "half_angle", "deg") == pytest.approx(half / 2, rel=1e-9)
        assert number(found, "solid_angle", "sr") == pytest.approx(omega, rel=1e-9)
