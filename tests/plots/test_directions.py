"""Polar diagrams, discs and integrands, against the known light."""

import math
import re

import pytest
from conftest import ROOT

from radcalc.calculators import integrate, point_source, sky
from radcalc.calculators.environment import Source, environment
from radcalc.calculators.photon import photon
from radcalc.calculators.solved import Task
from radcalc.inputs.reading import read
from radcalc.plots import REFERENCE, answers
from radcalc.plots.curves import Solved


def given(**values):
    names = {name.replace("_", "-"): text for name, text in values.items()}
    return {name: read(name, text, uncertain=True) for name, text in names.items()}


def diagram(wanted=(), **values):
    inputs = given(**values)
    solved = Solved(inputs, point_source.point_source(inputs))
    return answers.picture("point-source", [solved], wanted)


def at(plane, angle):
    return dict(zip(plane.angles, plane.values, strict=True))[angle]


def test_an_isotropic_source_is_a_circle():
    polar = diagram(flux="800lm")
    (plane,) = polar.planes
    assert (min(plane.values), max(plane.values)) == pytest.approx(2 * (800 / (4 * math.pi),))
    assert (plane.angles[0], plane.angles[-1]) == (-180.0, 180.0)
    assert (plane.label, polar.radius.title) == ("every C plane", "luminous intensity I [cd]")


def test_a_cone_has_its_intensity_up_to_its_edge():
    # 100 lm over 2 pi (1 - cos 60 deg) = pi sr
    (plane,) = diagram(flux="100lm", half_angle="60deg").planes
    assert at(plane, 59.5) == at(plane, -59.5) == pytest.approx(100 / math.pi)
    assert at(plane, 60.5) == at(plane, 180.0) == 0.0


def test_a_lobe_of_a_beam_angle_has_half_of_its_intensity_at_half_of_it():
    (plane,) = diagram(intensity="1000cd", beam_angle="30deg").planes
    assert at(plane, 0.0) == pytest.approx(1000)
    assert at(plane, 15.0) == at(plane, -15.0) == pytest.approx(500)


def test_a_width_alone_is_relative():
    polar = diagram(beam_angle="30deg")
    assert polar.radius.title == "relative intensity"
    assert at(polar.planes[0], 0.0) == pytest.approx(1.0)


def test_the_planes_of_a_file_are_its_own_columns():
    polar = diagram(distribution=str(ROOT / "examples" / "downlight.ies"))
    first, second = polar.planes
    assert (first.label, second.label) == ("C0-C180", "C90-C270")
    # candelas of the file itself, in the order of its angles: gamma for C0, C45, C90
    numbers = (ROOT / "examples" / "downlight.ies").read_text().split("TILT=NONE")[1].split()
    factor, gammas, planes = float(numbers[2]), int(numbers[3]), int(numbers[4])
    angles = [float(x) for x in numbers[13 : 13 + gammas]]
    azimuths = [float(x) for x in numbers[13 + gammas : 13 + gammas + planes]]
    candelas = [float(x) for x in numbers[13 + gammas + planes :]]
    assert (azimuths[0], azimuths[-1]) == (0.0, 90.0)
    for plane, column in ((first, 0), (second, planes - 1)):
        for k, angle in enumerate(angles):
            expected = factor * candelas[column * gammas + k]
            assert at(plane, angle) == at(plane, -angle) == pytest.approx(expected)


def test_a_scaled_source_is_drawn_as_strong_as_it_is():
    # 100 cos(theta) cd has 100 pi lm into the lower half
    polar = diagram(distribution="max(cos(theta), 0)", flux=f"{100 * math.pi!r}lm")
    assert at(polar.planes[0], 0.0) == pytest.approx(100)
    assert at(polar.planes[0], 60.0) == pytest.approx(50)


def test_the_intensity_that_is_asked_for_has_its_unit():
    polar = diagram(("intensity:kcd",), flux="4kW", isotropic=True, efficacy="100lm/W")
    assert polar.radius.unit == "kcd"
    assert polar.planes[0].values[0] == pytest.approx(400 / (4 * math.pi))


def test_both_half_planes_of_a_source_that_is_not_symmetrical():
    (first, second) = diagram(distribution="100*(2+cos(phi)) cd").planes
    assert (at(first, 90.0), at(first, -90.0)) == (300, 100)
    assert (at(second, 90.0), at(second, -90.0)) == pytest.approx((200, 200))


def disc_of_sky(name, **values):
    inputs = given(**values)
    solved = Solved(inputs, sky.sky(name, inputs, is_drawn=True))
    return answers.picture("sky", [solved], (), name)


def seen(disc, x, y):
    last = len(disc.rows) - 1
    return disc.rows[round((y + 1) / 2 * last)][round((x + 1) / 2 * last)]


def test_an_overcast_sky_is_a_third_as_bright_at_the_horizon():
    # Moon and Spencer: L = L_z (1 + 2 cos Z) / 3
    disc = disc_of_sky("overcast", zenith_luminance="9000cd/m2")
    assert seen(disc, 0, 0) == pytest.approx(9000)
    assert seen(disc, 1, 0) == seen(disc, 0, -1) == pytest.approx(3000)
    assert seen(disc, 0, 2 / 3) == pytest.approx(9000 * (1 + 2 * 0.5) / 3)  # Z = 60 deg
    assert disc.value.title == "luminance [cd/m2]"


def test_the_sun_is_marked_where_the_sky_is_brightest():
    disc = disc_of_sky(
        "clear", sun_elevation="30deg", sun_azimuth="90deg", horizontal_illuminance="12klx"
    )
    (mark,) = disc.marks
    # azimuth 90 deg is at the right; 60 deg from the zenith are 2/3 of the radius
    assert (mark.label, mark.x, mark.y) == ("sun", pytest.approx(2 / 3), pytest.approx(0, abs=1e-9))
    inside = [v for row in disc.rows for v in row]
    assert seen(disc, mark.x, mark.y) > 0.9 * max(inside)
    assert dict(disc.rim)["90°"] == 90


def test_a_receiver_sees_what_is_before_it():
    inputs = given(normal="1,0,0")
    source = Source("1000*(theta < 90*deg)*(phi < 180*deg) cd/m2")
    solved = Solved(inputs, environment(source, inputs))
    disc = answers.picture("environment", [solved], (), source)
    # who looks along +x has +y to the left, and light comes from y > 0, z > 0 alone
    assert seen(disc, -0.5, 0.5) == 1000
    assert seen(disc, 0.5, 0.5) == seen(disc, -0.5, -0.5) == 0
    assert dict(disc.rim) == {"up": 0, "right": 90, "down": 180, "left": 270}


def test_an_integrand_and_what_of_it_adds_up():
    inputs = given(hemisphere=True)
    solved = Solved(inputs, integrate.integrate("cos(theta)", inputs))
    chart = answers.picture("integrate", [solved], (), ("cos(theta)", "cd"))
    own, weighted = chart.series
    # the trapezoid of what is drawn, times 2 pi, is pi: the integral of cos(theta) sin(theta)
    steps = zip(weighted.x, weighted.x[1:], weighted.y, weighted.y[1:], strict=False)
    area = sum(math.radians(b - a) * (p + q) / 2 for a, b, p, q in steps)
    assert 2 * math.pi * area == pytest.approx(math.pi, rel=1e-4)
    assert weighted.style == REFERENCE
    assert own.y[0] == 1.0
    assert (chart.x.title, chart.y.title) == ("polar angle θ [deg]", "f [cd]")


def test_a_result_that_is_none_leaves_the_picture_as_it_is():
    assert diagram(("speed",), flux="800lm").radius.unit == "cd"  # the answer refuses it


# -- uncertain values ------------------------------------------------------------------------------


def solved(command, work_out, **values):
    """Return a case with its uncertainty, as commands solve it."""
    inputs = given(**values)
    return Solved(inputs, Task(command, work_out).solve(inputs))


def polar_of(**values):
    return answers.picture(
        "point-source", [solved("point-source", point_source.point_source, **values)]
    )


def test_an_uncertain_intensity_has_a_band():
    polar = polar_of(flux="800+-40lm")
    (plane,) = polar.planes
    low, high = plane.band
    ends = (760 / (4 * math.pi), 840 / (4 * math.pi))  # I = Phi / (4 pi)
    assert (min(low), max(low), min(high), max(high)) == pytest.approx(
        (ends[0], ends[0], ends[1], ends[1])
    )
    assert polar.most == pytest.approx(ends[1])
    assert polar.note == "band: ± standard uncertainty (k = 1)"


def test_an_uncertain_shape_is_drawn_without_a_band_and_says_so():
    polar = polar_of(intensity="1000cd", beam_angle="30+-2deg")
    (plane,) = polar.planes
    assert plane.band is None
    assert at(plane, 15.0) == pytest.approx(500)
    assert polar.note == "drawn without the uncertainty of beam angle 30+-2deg"


def test_an_uncertainty_that_the_picture_does_not_depend_on_is_not_mentioned():
    polar = polar_of(intensity="1000cd", distance="2+-0.1m")
    assert (polar.planes[0].band, polar.note) == (None, "")


@pytest.mark.parametrize(
    ("command", "work_out", "operand", "values", "named"),
    [
        (
            "sky",
            lambda inputs: sky.sky("overcast", inputs, is_drawn=True),
            "overcast",
            {"zenith_luminance": "9000+-90cd/m2"},
            "zenith luminance 9000+-90cd/m2",
        ),
        (
            "environment",
            lambda inputs: environment(Source("sky:overcast"), inputs),
            Source("sky:overcast"),
            {"zenith_luminance": "9000+-90cd/m2"},
            "zenith luminance 9000+-90cd/m2",
        ),
        (
            "integrate",
            lambda inputs: integrate.integrate("cos(theta)", inputs),
            ("cos(theta)", "cd"),
            {"half_angle": "30+-1deg"},
            "half angle 30+-1deg",
        ),
        ("photon", photon, None, {"wavelength": "555+-2nm"}, "wavelength 555+-2nm"),
    ],
)
def test_a_picture_without_bands_says_so(command, work_out, operand, values, named):
    drawn = answers.picture(command, [solved(command, work_out, **values)], (), operand)
    assert drawn.note.endswith(f"drawn without the uncertainty of {named}")


# -- the peak of an environment --------------------------------------------------------------------


def environment_of(text, **values):
    source = Source(text)
    inputs = given(**values)
    case = Solved(inputs, environment(source, inputs))
    return answers.picture("environment", [case], (), source)


LOBE = "(1 + 199*exp(-((theta - 45*deg)/(9*deg))^2)*((1 + sin(phi))/2)^9) cd/m2"


def test_the_peak_of_an_environment_is_marked_with_its_value_and_direction():
    """The brightest direction is 45 deg from the zenith at the azimuth 90 deg, by construction."""
    disc = environment_of(LOBE)
    (mark,) = disc.marks
    assert mark.label == "peak"
    assert (mark.x, mark.y) == (pytest.approx(0.5, abs=0.01), pytest.approx(0, abs=0.01))
    value, polar_angle, azimuth = re.fullmatch(
        r"peak ([\d.]+) cd/m2 toward ([\d.]+)°,([\d.]+)°", disc.note
    ).groups()
    assert float(value) == pytest.approx(200, rel=0.01)
    assert float(polar_angle) == pytest.approx(45, abs=0.5)
    assert float(azimuth) == pytest.approx(90, abs=0.5)


def test_a_peak_out_of_sight_is_noted_but_not_marked():
    disc = environment_of(LOBE, normal="0,0,-1")
    assert not disc.marks
    assert disc.note.endswith(", behind the receiver")


@pytest.mark.parametrize("text", ["5 cd/m2", "0 cd/m2"])
def test_even_and_dark_surroundings_have_no_peak(text):
    disc = environment_of(text)
    assert (disc.marks, disc.note) == ([], "")
    assert all(math.isfinite(z) for row in disc.rows for z in row)
