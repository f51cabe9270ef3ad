"""Point sources against integrals over their light, and closed forms."""

import math

import mpmath
import pytest
from helpers import Q, number
from mpmath import mpf

from radcalc import convert, point_source
from radcalc.calculators.point_source import point_source as work_out
from radcalc.errors import ConditionError
from radcalc.inputs.reading import read

PI = math.pi


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
def test_the_light_of_a_lobe_off_its_axis(n, height, x, y):
    """E = I0 (h/d)^n (h/d) / d^2 on the floor; without the last cosine if turned to the lamp."""
    place = {"height": f"{height}m", "offset": f"{x}m", "offset_y": f"{y}m"}
    d = math.sqrt(height**2 + x**2 + y**2)
    expected = 900 * (height / d) ** n / d**2
    found = point_source(intensity="900cd", exponent=n, **place)
    assert number(found, "irradiance", "lx") == pytest.approx(expected * height / d, rel=1e-12)
    turned = point_source(intensity="900cd", exponent=n, incidence="0deg", **place)
    assert number(turned, "irradiance", "lx") == pytest.approx(expected, rel=1e-12)
    back = point_source(illuminance=found["irradiance"], exponent=n, **place)
    assert number(back, "intensity", "cd") == pytest.approx(900, rel=1e-12)


def test_the_height_of_the_maximum_irradiance():
    # I h^2 / (h^2 + x^2)^2 of a lobe of exponent 1 is largest at h = x: 9 cd / (4 (1.5 m)^2)
    found = point_source(intensity="9cd", irradiance="1lx", exponent=1, offset="1.5m")
    assert number(found, "height", "m") == pytest.approx(1.5, rel=1e-6)
    with pytest.raises(ConditionError, match="more light than any height"):
        point_source(intensity="9cd", irradiance="1.001lx", exponent=1, offset="1.5m")


def test_the_height_of_an_irradiance_straight_below():
    found = point_source(intensity="100cd", offset="0m", irradiance="25lx")
    assert number(found, "height", "m") == pytest.approx(2, rel=1e-12)


def test_redundant_exact_inputs_may_differ_by_rounding():
    found = point_source(flux="4pi/3 lm", intensity="1/3 cd")
    assert number(found, "intensity", "cd") == pytest.approx(1 / 3, rel=1e-15)


def test_a_cone_ends_at_its_edge():
    # at 3 m height the edge of a cone of 30 deg is at 3 tan(30 deg) = 1.73 m
    def at(offset):
        found = point_source(intensity="1cd", half_angle="30deg", height="3m", offset=offset)
        return number(found, "irradiance", "lx")

    assert at("1.73m") == pytest.approx(3 / (9 + 1.73**2) ** 1.5, rel=1e-12)
    assert at("1.74m") == 0


def test_the_flux_of_the_cosine_spot():
    # I0 cos^n over a hemisphere: 2 pi I0 / (n + 1), n = ln 2 / -ln cos 15 deg for 30 deg FWHM
    n = math.log(2) / -math.log(math.cos(math.radians(15)))
    found = point_source(intensity="1000cd", beam_angle="30deg")
    assert number(found, "exponent", "1") == pytest.approx(n, rel=1e-12)
    assert number(found, "flux", "lm") == pytest.approx(2000 * PI / (n + 1), rel=1e-12)
    assert round(number(found, "flux", "lm")) == 299


def test_the_flux_of_the_cone_spot():
    found = point_source(flux="4.5klm", half_angle="12.5deg", distance="2m")
    candela = 4500 / (2 * PI * (1 - math.cos(math.radians(12.5))))
    assert number(found, "intensity", "cd") == pytest.approx(candela, rel=1e-12)
    assert number(found, "irradiance", "lx") == pytest.approx(candela / 4, rel=1e-12)


def test_the_isotropic_source():
    found = point_source(flux="800lm", distance="2m")
    assert number(found, "intensity", "cd") == pytest.approx(200 / PI, rel=1e-14)
    assert number(found, "irradiance", "lx") == pytest.approx(50 / PI, rel=1e-14)


@pytest.mark.parametrize(
    ("call", "name", "unit", "expected"),
    [
        (lambda: point_source(illuminance="500lx", distance="2m"), "flux", "lm", 8000 * PI),
        (lambda: point_source(intensity="100cd", illuminance="25lx"), "distance", "m", 2),
        (lambda: point_source(intensity="250cd", height="6m", offset="8m"), "irradiance", "lx",
         1.5),
        (lambda: point_source(intensity="100cd", exponent=3, within="45deg"), "flux_within", "lm",
         50 * PI * 0.75),
        (lambda: point_source(flux="500lm", intensity="900cd", distribution="cone"), "half_angle",
         "rad", math.acos(1 - 500 / 900 / 2 / PI)),
    ],
)  # fmt: skip
def test_point_sources_match_their_formulas(call, name, unit, expected):
    assert number(call(), name, unit) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("by", [{"half_angle": "0.5deg"}, {"beam_angle": "1deg"}])
def test_no_receiver_gets_more_than_all_the_light(by):
    """A spot of 4.4 cm radius (0.5 deg at 5 m), on a disc of 40 cm: all of it."""
    found = point_source(flux="100lm", distance="5m", receiver_area="0.5m2", **by)
    assert number(found, "received_flux", "lm") == pytest.approx(100, rel=1e-9)


def test_a_receiver_at_the_edge_of_a_cone_gets_the_light_on_it():
    """Half of a small disc whose centre is on the edge of the light, which is nearly straight."""
    found = point_source(
        flux="100lm", half_angle="45deg", height="1m", offset="1m", receiver_area="1e-6m2"
    )
    inside = point_source(
        flux="100lm", half_angle="46deg", height="1m", offset="1m", receiver_area="1e-6m2"
    )
    cone = (1 - math.cos(PI / 4)) / (1 - math.cos(math.radians(46)))
    part = number(found, "received_flux", "lm") / number(inside, "received_flux", "lm") * cone
    assert part == pytest.approx(0.5, abs=1e-3)
    assert number(inside, "received_flux", "lm") == pytest.approx(
        number(inside, "irradiance", "lx") * 1e-6, rel=1e-5
    )


def test_an_array_of_receivers_and_of_distances():
    """Small ones get E A, with E = 100 lm / (4 pi sin^2(0.25 deg)) / 25 m2."""
    areas = Q([1e-4, 0.5, 100.0], "m2")
    found = point_source(flux="100lm", half_angle="0.5deg", distance="5m", receiver_area=areas)
    assert found["received_flux"].to("lm").magnitude == pytest.approx([1.67193, 100, 100], rel=2e-6)
    away = Q([0.01, 5.0, 500.0], "m")
    found = point_source(flux="100lm", half_angle="0.5deg", distance=away, receiver_area="0.5m2")
    spot = PI * (500 * math.tan(math.radians(0.5))) ** 2
    assert found["received_flux"].to("lm").magnitude == pytest.approx(
        [100, 100, 50 / spot], rel=1e-4
    )


def test_the_flux_of_a_uniform_cone_is_noted_for_a_beam_angle():
    """1000 cd at 30 degrees: 299 lm as a lobe, 2 pi (1 - cos 15 deg) 1000 lm = 214 lm as a cone."""
    for given, said in (({"intensity": "1000cd"}, "214.094 lm"), ({"flux": "214lm"}, "999.559 cd")):
        inputs = {name: read(name, text) for name, text in given.items()}
        answer = work_out({**inputs, "beam-angle": read("beam-angle", "30deg")})
        assert f"a uniform cone of that full angle would have {said}" in answer.notes


@pytest.mark.parametrize(("flag", "angle"), [("isotropic", 4 * math.pi), ("hemisphere", math.tau)])
@pytest.mark.parametrize("place", [{"distance": "2m"}, {"height": "2m", "offset": "1m"}])
def test_isotropic_and_hemisphere_are_the_same_as_in_a_conversion(flag, angle, place):
    """By the definition of the solid angle: I = Phi / 4 pi sr, or / 2 pi sr."""
    answer = point_source(flux="800lm", **{flag: True}, **place)
    assert answer["intensity"].m_as("cd") == pytest.approx(800 / angle, rel=1e-14)
    converted = convert("800lm", "lx", **{flag: True}, distance="2m")
    if "distance" in place:
        assert answer["irradiance"].m_as("lx") == pytest.approx(converted.m_as("lx"), rel=1e-14)
    same = {"isotropic": {"distribution": "isotropic"}, "hemisphere": {"half_angle": "90deg"}}
    other = point_source(flux="800lm", **same[flag], **place)
    assert {n: str(q) for n, q in answer.items()} == {n: str(q) for n, q in other.items()}


SHAPES = {
    "isotropic": ({}, lambda cosine: 1.0),
    "a lobe": ({"exponent": 5}, lambda cosine: cosine**5),
    "a cone": ({"half_angle": "80 deg"}, lambda cosine: 1.0),
    "an expression": ({"distribution": "max(cos(theta), 0)"}, lambda cosine: cosine),
}


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("offset", [0.0, 0.4, 1.0, 7.0])
def test_the_place_on_a_floor_is_the_same_by_any_two_of_its_sizes(shape, offset):
    """E = I f(gamma) h / d^3 on a floor; an answer that is fed back gives the same answer."""
    given, fall = SHAPES[shape]
    given = {"intensity": "100 cd", **given}
    distance = math.hypot(2, offset)
    expected = 100 * fall(2 / distance) * 2 / distance**3
    first = point_source(height="2 m", offset=Q(offset, "m"), **given)
    assert number(first, "irradiance", "lx") == pytest.approx(expected, rel=1e-12)
    for name in ("offset", "distance", "incidence"):
        for more in ({}, {"illuminance": first["illuminance"]}):
            again = point_source(height="2 m", **{name: first[name]}, **given, **more)
            for result in ("illuminance", "offset", "distance", "incidence", "off_axis"):
                if result not in again:  # on the axis
                    continue
                unit = first[result].units
                found = number(again, result, unit)
                assert found == pytest.approx(first[result].magnitude, rel=1e-6, abs=1e-6), name


def test_an_incidence_turns_a_receiver_whose_place_is_given():
    """E = I cos(30 deg) / d^2 = 100 * 0.866025 / 4 = 21.6506 lx below the source."""
    for place in ({"distance": "2 m"}, {"height": "2 m", "offset": "0 m"}):
        found = point_source(intensity="100 cd", incidence="30 deg", **place)
        assert number(found, "illuminance", "lx") == pytest.approx(21.6506, rel=1e-5)
    with pytest.raises(ConditionError, match="out of range"):
        point_source(intensity="100 cd", incidence="90 deg", height="2 m")


@pytest.mark.parametrize(
    "source", [{"intensity": "100 cd"}, {"distribution": "100 cd"}], ids=["law", "distribution"]
)
@pytest.mark.parametrize("offset", [1e-12, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5, 1.0, 1.13])
def test_both_heights_are_found_however_small_the_offset(offset, source):
    """E / I = h / d^3, so that p = E x^2 / I = y - y^3 with y = h / d; the cubic's two roots."""
    found = point_source(offset=Q(offset, "m"), illuminance="30 lx", **source)
    with mpmath.workdps(60):
        third = mpmath.acos(-mpf(0.3) * mpf(offset) ** 2 * mpmath.sqrt(27) / 2) / 3
        roots = [2 / mpmath.sqrt(3) * mpmath.cos(third - k * mpmath.pi * 2 / 3) for k in (0, 1)]
        heights = sorted(float(offset * y / mpmath.sqrt(1 - y * y)) for y in roots)
    assert sorted(found["height"].to("m").magnitude) == pytest.approx(heights, rel=1e-9)


@pytest.mark.parametrize("exponent", [0.5, 3, 80])
@pytest.mark.parametrize("offset", [1e-3, 0.03, 0.2])
def test_both_heights_of_a_lobe_give_its_light(offset, exponent):
    """E = I cos^(n + 1)(gamma) / d^2 below and beside the source."""
    found = point_source(
        offset=Q(offset, "m"), illuminance="2 lx", intensity="100 cd", exponent=exponent
    )
    heights = found["height"].to("m").magnitude
    assert len(heights) == 2
    for height in heights:
        away = math.hypot(height, offset)
        assert 100 * (height / away) ** (exponent + 1) / away**2 == pytest.approx(2, rel=1e-9)


def test_a_cone_is_at_most_a_sphere():
    """4 pi sr are 12.566 sr: 13 lm may be 12.6 lm, but 13.0 lm may not."""
    found = point_source(intensity="1 cd", flux="13 lm", distribution="cone")
    assert found["solid_angle"].to("sr").magnitude == pytest.approx(4 * math.pi)
    assert found["half_angle"].to("deg").magnitude == pytest.approx(180)
    for flux in ("13.0 lm", "50 lm"):
        with pytest.raises(ConditionError, match="no cone has a solid angle of"):
            point_source(intensity="1.00 cd", flux=flux, distribution="cone")
