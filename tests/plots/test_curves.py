"""Curves over a range, and contours over a grid, against hand arithmetic."""

import math

import pytest
from helpers import terminal_of

from radcalc.calculators import scene as page
from radcalc.calculators.lambertian import lambertian
from radcalc.calculators.point_source import point_source
from radcalc.calculators.solved import Task
from radcalc.distributions.scene import Axis, grid
from radcalc.errors import UsageError
from radcalc.inputs.reading import read, split_values
from radcalc.plots import LINE, POINTS
from radcalc.plots.answers import picture
from radcalc.plots.curves import Solved
from radcalc.plots.space import Surveyed, over_grid


def solved(work_out, **values):
    given = {name.replace("_", "-"): read(name.replace("_", "-"), x) for name, x in values.items()}
    return Solved(given, work_out(given))


def test_the_fall_off_of_a_point_is_the_inverse_square():
    each = [solved(point_source, intensity="100cd", distance=f"{d}m") for d in (1, 2, 5)]
    chart = picture("point-source", each)
    (curve,) = chart.series
    assert (curve.x, curve.y, curve.style) == ([1, 2, 5], [100, 25, 4], POINTS)
    assert (chart.x.title, chart.y.title) == ("distance d [m]", "illuminance E_v [lx]")
    assert chart.title == "intensity 100cd"


def test_a_long_range_is_a_curve_of_its_own():
    (places,) = split_values("distance", "100cm:300cm:1mm", arrays=True)
    one = solved(point_source, intensity="100cd", distance=places)
    (curve,) = picture("point-source", [one], ["irradiance:klx"]).series
    assert (len(curve.x), curve.style) == (2001, LINE)
    assert (curve.x[0], curve.x[-1]) == (100, 300)
    assert (curve.y[0], curve.y[1000]) == (pytest.approx(0.1), pytest.approx(0.025))


def test_a_disc_falls_off_as_its_configuration_factor():
    each = [
        solved(lambda g: lambertian("disc", g), luminance="1000cd/m2", radius="1m", distance=d)
        for d in ("1m", "3m")
    ]
    (curve,) = picture("lambertian", each).series
    # E = pi L R^2 / (R^2 + h^2)
    assert curve.y == pytest.approx([1000 * math.pi / 2, 1000 * math.pi / 10])


def test_of_two_lists_the_last_is_along_the_axis():
    each = [
        solved(point_source, intensity=i, distance=d)
        for i in ("100cd", "200cd")
        for d in ("1m", "2m")
    ]
    chart = picture("point-source", each)
    assert {one.label: one.y for one in chart.series} == {
        "intensity 100cd": [100, 25],
        "intensity 200cd": [200, 50],
    }


def test_several_answers_are_several_curves():
    each = [
        solved(point_source, intensity="250cd", offset="8m", illuminance=e)
        for e in ("1lx", "1.1lx")
    ]
    chart = picture("point-source", each, ["height"])
    assert [one.label for one in chart.series] == ["answer 1", "answer 2"]


def test_a_curve_over_decades_has_logarithmic_axes():
    each = [solved(point_source, intensity="100cd", distance=d) for d in ("0.1m", "10m")]
    chart = picture("point-source", each)
    assert chart.x.is_log
    assert chart.y.is_log


@pytest.mark.parametrize(
    ("wanted", "problem"),
    [(["irradiance", "flux"], "an axis has one unit"), (["speed"], "unknown result 'speed'")],
)
def test_what_cannot_be_on_one_axis_is_refused(wanted, problem):
    each = [solved(point_source, intensity="100cd", distance=d) for d in ("1m", "2m")]
    with pytest.raises(UsageError, match=problem):
        picture("point-source", each, wanted)


def test_a_number_alone_has_no_picture():
    with pytest.raises(UsageError, match="no picture of a single answer") as caught:
        picture("lambertian", [solved(lambda g: lambertian("patch", g), luminance="1cd/m2")])
    assert "luminance 0.5cd/m2:1cd/m2:0.05cd/m2" in str(caught.value)  # an input of its own


def surveyed(*axes):
    lamp = {"name": "lamp", "x": 1, "y": 0, "z": 2, "intensity": "100 cd"}
    survey = page.Survey(page.scene([lamp], {}), None)
    own = [Axis(*axis) for axis in axes]
    return Surveyed(own, list(survey.at_points(grid(*own))), [("lamp", (1.0, 0.0, 2.0))])


def test_a_field_has_a_row_for_each_y():
    field = over_grid(surveyed((0, 2, 3), (0, 2, 2), (0, 0, 1)))
    assert (field.xs, field.ys) == ([0, 1, 2], [0, 2])
    # E = I h / d^3: below the lamp, 100/4; 1 m aside, 100*2/5^1.5; 2 m aside in y, 100*2/8^1.5
    assert field.rows[0] == pytest.approx([200 / 5**1.5, 25, 200 / 5**1.5])
    assert field.rows[1][1] == pytest.approx(200 / 8**1.5)
    assert [(mark.label, mark.x, mark.y) for mark in field.marks] == [("lamp", 1, 0)]
    assert field.value.title == "illuminance E_v [lx]"
    assert field.title == "illuminance at z = 0 m"


def test_a_grid_along_a_line_is_a_curve_and_others_are_refused():
    own = surveyed((0, 2, 3), (0, 0, 1), (0, 0, 1))._replace(wanted="irradiance:klx")
    chart = over_grid(own)
    assert chart.series[0].y[1] == pytest.approx(0.025)
    for axes in (((0, 0, 1),) * 3, ((0, 1, 2),) * 3):
        with pytest.raises(UsageError, match="has no picture"):
            over_grid(surveyed(*axes))


def test_values_in_other_units_stand_where_they_are_and_in_order():
    each = [solved(point_source, intensity="100cd", distance=d) for d in ("5m", "100cm", "2m")]
    chart = picture("point-source", each)
    assert (chart.series[0].x, chart.series[0].y) == ([1, 2, 5], [100, 25, 4])
    assert chart.x.unit == "m"


def uncertain(**values):
    """Return the case with its uncertainty, as commands solve it."""
    names = {name.replace("_", "-"): text for name, text in values.items()}
    given = {name: read(name, text, uncertain=True) for name, text in names.items()}
    return Solved(given, Task("point-source", point_source).solve(given))


def test_a_curve_of_uncertain_values_has_a_band():
    each = [uncertain(intensity="100+-5cd", distance=f"{d}m") for d in range(1, 21)]
    chart = picture("point-source", each)
    (curve,) = chart.series
    low, high = curve.band
    # E = I/d^2, so that u(E) = u(I)/d^2
    assert low == pytest.approx([95 / d**2 for d in range(1, 21)])
    assert high == pytest.approx([105 / d**2 for d in range(1, 21)])
    assert (curve.style, chart.note) == (LINE, "band: ± standard uncertainty (k = 1)")


def test_bars_contain_the_uncertainty_of_the_axis_and_follow_its_order():
    each = [uncertain(intensity="100cd", distance=d) for d in ("4m", "2+-0.1m", "5+-0.1m")]
    chart = picture("point-source", each)
    (points,) = chart.series
    # u(E) = 2 E u(d)/d: 2.5 at 25 lx, none at 6.25 lx, 0.16 at 4 lx
    assert (points.x, points.y) == ([2, 4, 5], pytest.approx([25, 6.25, 4]))
    assert points.band == (pytest.approx([22.5, 6.25, 3.84]), pytest.approx([27.5, 6.25, 4.16]))
    assert chart.note == "bar: ± standard uncertainty (k = 1), with that of the distance"


def test_exact_values_have_no_band():
    chart = picture("point-source", [uncertain(intensity="1cd", distance=d) for d in ("1m", "2m")])
    assert (chart.series[0].band, chart.note) == (None, "")


def test_a_band_above_0_has_a_logarithmic_axis():
    each = [uncertain(intensity="100+-10cd", distance=f"{d}m") for d in (0.1, 1, 10)]
    assert picture("point-source", each).y.is_log


def test_a_picture_instead_of_a_table_keeps_the_assumptions_without_the_derivation():
    call = ["point-source", "--flux", "800lm", "--distance", "1m:30m:1m", "--plot"]
    drawn = terminal_of(*call)
    assert "isotropic: the same intensity" in drawn
    assert "Phi = 4 pi" not in drawn
    assert "Phi = 4 pi" in terminal_of(*call, "--steps")
    assert "isotropic" not in terminal_of(*call, "-g", "flux")  # it has no effect on the flux
