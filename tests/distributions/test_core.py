"""Shapes, formulas, beams and poses, compared with closed forms and definitions."""

import math

import numpy
import pytest

from radcalc.distributions.distribution import Grid, Pose, beam
from radcalc.distributions.scene import upward_flux
from radcalc.distributions.sources import Cone, Formula, Isotropic, Lobe
from radcalc.errors import ConditionError

MEMBERS = {
    "isotropic": Isotropic(),
    "cone": Cone(0.9),
    "wide cone": Cone(2.5),
    "lobe": Lobe(4.0),
    "formula": Formula("3 + cos(theta) + sin(phi)*sin(theta)"),
    "axial formula": Formula("max(cos(theta), 0)^3"),
    "grid": Grid([0.0, 1.0, 2.5], [0.0], [[3.0, 2.0, 0.5]]),
    "type B": Grid([0.5, 1.5, 2.5], [-1.0, 0.0, 1.0], [[1, 2, 1], [2, 5, 2], [1, 3, 1]], "v", "B"),
}


def midpoints(member, polar, azimuth, count=1500):
    """A plain sum over small cells."""
    theta = polar[0] + (numpy.arange(count) + 0.5) / count * (polar[1] - polar[0])
    phi = azimuth[0] + (numpy.arange(90) + 0.5) / 90 * (azimuth[1] - azimuth[0])
    values = member.intensity(theta[:, None], phi) * numpy.sin(theta)[:, None]
    return values.mean() * (polar[1] - polar[0]) * (azimuth[1] - azimuth[0])


@pytest.mark.parametrize("name", MEMBERS)
@pytest.mark.parametrize(
    ("polar", "azimuth"),
    [((0, math.pi), (0, 2 * math.pi)), ((0, math.pi / 2), (1, 2)), ((0.4, 1.3), (-2, 3))],
)
def test_the_flux_of_a_part_is_the_sum_of_its_intensities(name, polar, azimuth):
    member = MEMBERS[name]
    found = member.flux(polar, azimuth)
    summed = midpoints(member, polar, azimuth)
    assert found.value == pytest.approx(summed, rel=2e-3, abs=1e-9)


@pytest.mark.parametrize("name", MEMBERS)
def test_the_peak_is_the_greatest_intensity(name):
    member = MEMBERS[name]
    theta, phi = numpy.linspace(0, math.pi, 91)[:, None], numpy.linspace(0, 6.28, 91)
    peak = member.peak()
    assert member.intensity(theta, phi).max() <= peak.value * (1 + 1e-12)
    assert member.intensity(peak.polar, peak.azimuth) == pytest.approx(peak.value)


def test_the_peak_of_a_formula_is_accurate():
    peak = Formula("exp(-((theta - 0.7431*rad)/(0.05*rad))^2) * (2 + cos(phi - 2.1*rad))").peak()
    assert peak == pytest.approx((3.0, 0.7431, 2.1), abs=1e-6)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("cos(theta)", "negative value at theta = 9"),
        ("1/sin(theta)", "no finite value at theta = 0 deg"),
        ("ln(theta/rad - 5)", "no finite value"),
    ],
)
def test_a_formula_that_is_not_an_intensity_is_refused(text, said):
    with pytest.raises(ConditionError, match=said):
        Formula(text).peak()


@pytest.mark.parametrize("exponent", [0.5, 1, 3, 20, 181, 5000])
@pytest.mark.parametrize("share", [0.5, 0.1])
def test_the_beam_of_a_lobe(exponent, share):
    """2 arccos(share^(1/n)), by both definitions."""
    found = beam(Lobe(exponent), 0.3, share)
    angle = 2 * math.acos(share ** (1 / exponent))
    assert found.outermost == pytest.approx(angle, abs=1e-9)
    assert found.from_axis == pytest.approx(angle, abs=1e-9)
    assert not found.is_ambiguous


def test_a_batwing_is_ambiguous():
    """100, 300 and 0 cd at 0, 60 and 90 degrees: 150 cd at 75 degrees, 50 cd at 85."""
    wing = Grid(numpy.radians([0, 60, 90]), [0.0], [[100.0, 300.0, 0.0]])
    found = beam(wing, 0.0, 0.5)
    assert math.degrees(found.outermost) == pytest.approx(150)
    assert math.degrees(found.from_axis) == pytest.approx(170)
    assert found.is_ambiguous


def test_a_light_without_an_edge_has_no_beam():
    assert beam(Isotropic(), 0.0, 0.5) == (None, None, True, None)
    up = Grid([2.0, 3.0, math.pi], [0.0], [[0.0, 1.0, 1.0]])
    assert beam(up, 0.0, 0.5) == (None, None, True, None)


def test_a_beam_may_lie_on_one_side_of_the_axis():
    """A wall washer: 0, 100 and 0 cd at 10, 40 and 70 degrees on one side: half at 25 and 55."""
    plane = [0.0, 100.0, 0.0]
    washer = Grid(
        numpy.radians([10, 40, 70]),
        numpy.radians([0, 45, 315, 360]),
        [plane, [0.0] * 3, [0.0] * 3, plane],
    )
    found = beam(washer, 0.0, 0.5)
    assert numpy.degrees(found.edges) == pytest.approx([25, 55])
    assert math.degrees(found.outermost) == pytest.approx(30)
    assert (found.from_axis, found.is_ambiguous) == (None, True)
    opposite = beam(washer, math.pi, 0.5)
    assert numpy.degrees(opposite.edges) == pytest.approx([-55, -25])


def degrees(*angles):
    return pytest.approx([math.radians(a) for a in angles], abs=1e-12)


def test_a_source_shines_down_by_default():
    assert Pose().angles((0.0, 0.0, -5.0)) == (0.0, 0.0, 5.0)
    theta, phi, distance = Pose().angles((0.0, 3.0, -3.0))
    assert [theta, phi] == degrees(45, 90)
    assert distance == pytest.approx(math.sqrt(18))
    theta, phi, _ = Pose(rotate=math.radians(90)).angles((0.0, 3.0, -3.0))
    assert [theta, phi] == degrees(45, 0)


def test_an_aim_turns_by_the_shortest_way():
    """Aimed along +x, C0 points up, and C90 does not change."""
    pose = Pose(aim=(2.0, 0.0, 0.0))
    assert pose.angles((7.0, 0.0, 0.0))[0] == pytest.approx(0)
    theta, phi, _ = pose.angles((1.0, 0.0, 1.0))
    assert [theta, phi] == degrees(45, 0)
    theta, phi, _ = pose.angles((1.0, 1.0, 0.0))
    assert [theta, phi] == degrees(45, 90)
    up = Pose(aim=(0.0, 0.0, 1.0))
    assert [*up.angles((1.0, 0.0, 1.0))[:2]] == degrees(45, 0)


@pytest.mark.parametrize("aim", [(0, 0, -1), (1, 2, 3), (0, 0, 1), (1e-9, 0, 1), (-3, 0.1, -2)])
@pytest.mark.parametrize("rotate", [0.0, 1.0, -2.0])
def test_a_rotation_keeps_lengths_and_can_be_inverted(aim, rotate):
    pose = Pose(aim, rotate)
    axes = numpy.array(pose.axes)
    assert axes @ axes.T == pytest.approx(numpy.eye(3), abs=1e-12)
    own = (0.3, -0.5, 0.8)
    theta, phi, length = pose.angles(pose.world(own))
    assert length == pytest.approx(math.sqrt(0.98))
    assert length * math.sin(theta) * math.cos(phi) == pytest.approx(0.3)
    assert length * math.sin(theta) * math.sin(phi) == pytest.approx(-0.5)
    ahead = numpy.array(aim) / numpy.linalg.norm(aim)
    assert pose.world((0.0, 0.0, 1.0)) == pytest.approx(ahead, abs=1e-12)


@pytest.mark.parametrize(
    ("text", "cosine"),
    [("(x*0.8 + z*0.6 > 0.9)*100", 0.9), ("(z >= 0.3)*100", 0.3)],
)
def test_the_error_of_a_tilted_cone_covers_it(text, cosine):
    """A cap has 2 pi (1 - cos) sr for any axis."""
    found = Formula(text).flux()
    true = 200 * math.pi * (1 - cosine)
    assert abs(found.value - true) <= found.error < 1e-3 * true


def test_a_ring_between_the_points_of_any_grid_has_its_flux():
    # 2 pi (cos a - cos b) of what is 1 between the polar angles a and b
    ring = Formula("(20.24*deg < theta < 20.26*deg)")
    expected = 2 * math.pi * (math.cos(math.radians(20.24)) - math.cos(math.radians(20.26)))
    assert ring.flux().value == pytest.approx(expected, rel=1e-9)
    assert ring.flux((math.pi / 2, math.pi)).value == 0


@pytest.mark.parametrize("half", [0.3, 1, 5, 60])
@pytest.mark.parametrize("height", [0.0, 0.1, 0.9, 4.9, -2.0, 30.0, -89.0, 90.0])
def test_flux_of_a_cone_above_the_horizon(half, height):
    """Compare with a sum over rings: cos(w) = -tan(e) / tan(theta) (spherical triangle)."""
    tilt = math.radians(height)
    theta = (numpy.arange(200_000) + 0.5) / 200_000 * math.radians(half)
    arcs = numpy.arccos(numpy.clip(-math.tan(tilt) / numpy.tan(theta), -1, 1))
    up = (2 * arcs * numpy.sin(theta)).mean() * math.radians(half)
    pose, lamp = Pose((math.cos(tilt), 0.0, math.sin(tilt))), Cone(math.radians(half))
    assert upward_flux(lamp, pose, lamp.flux()).value == pytest.approx(up, rel=1e-4)


def test_an_upward_flux_of_planes_and_poses():
    """A plain sum over small cells of the world's upper half."""
    cosine = (numpy.arange(200)[:, None] + 0.5) / 200
    turn = (numpy.arange(400) + 0.5) / 400 * 2 * math.pi
    sine = numpy.sqrt(1 - cosine**2)
    for name in ("formula", "grid", "type B"):
        pose = Pose((0.5, -0.3, 0.2), 0.7)
        theta, phi, _ = pose.angles((sine * numpy.cos(turn), sine * numpy.sin(turn), cosine))
        summed = float(MEMBERS[name].intensity(theta, phi).mean()) * 2 * math.pi
        assert upward_flux(MEMBERS[name], pose, MEMBERS[name].flux()).value == pytest.approx(
            summed, rel=1e-3
        )


def test_a_narrow_peak_of_a_formula_is_found():
    """1001 at 33.5 degrees, where a grid of whole degrees has 1."""
    peak = Formula("1+1000*exp(-((theta-33.5*deg)/(0.05*deg))^2)").peak()
    assert peak.value == pytest.approx(1001)
    assert math.degrees(peak.polar) == pytest.approx(33.5)


def test_a_part_without_light_between_steps_has_no_flux():
    assert Formula("(z > 0)*100").flux((math.pi / 2, math.pi)).value == 0
    assert Formula("(z > 0)*100").flux().value == pytest.approx(200 * math.pi, rel=1e-8)
    assert Formula("(phi < 185*deg)*(theta > 100*deg)").flux((0.0, math.pi / 4)).value == 0


@pytest.mark.parametrize(
    "text", ["(theta < 90)*100", "(0 < phi < 180)*5", "(45 > theta)*cos(theta)"]
)
def test_an_angle_cannot_be_compared_with_a_bare_number(text):
    with pytest.raises(ConditionError, match="an angle and a bare number"):
        Formula(text)


@pytest.mark.parametrize(
    "aim", [(1.0, 0.0, 0.0), (1.0, 0.3, 0.2), (1.0, 0.3, 0.0), (-2.0, 1.0, 1.0)]
)
def test_upward_and_downward_flux_of_a_formula_with_steps_add_up(aim):
    lamp = Formula("(theta < 60*deg)*100")
    up = upward_flux(lamp, Pose(aim), lamp.flux()).value
    down = lamp.flux().value - up
    opposite = tuple(-x for x in aim)
    assert 0 <= up <= lamp.flux().value
    # the mirror image
    assert upward_flux(lamp, Pose(opposite), lamp.flux()).value == pytest.approx(
        down, rel=1e-3, abs=1e-6
    )


def test_the_half_of_a_cone_towards_c90_is_up_when_it_is_aimed_along_y():
    half = Formula("(theta < 60*deg)*(phi < 180*deg)*100")
    whole = half.flux()
    assert upward_flux(half, Pose((0.0, 1.0, 0.0)), whole).value == pytest.approx(
        whole.value, rel=1e-3
    )


def test_phi_of_a_formula_is_within_a_turn():
    assert Formula("phi").peak().value <= 2 * math.pi
    assert Formula("phi").intensity(1.0, -0.5) == pytest.approx(2 * math.pi - 0.5)
