"""Point sources with any distribution: files, expressions, aimed sources.

Closed forms, independent sums and vectors; files are written here.
"""

import math
import random

import numpy
import pytest
from helpers import Q, number

from radcalc import point_source
from radcalc.calculators.point_source import point_source as work_out
from radcalc.calculators.solved import Task
from radcalc.distributions.distribution import Grid, Photometry
from radcalc.distributions.sources import Lobe
from radcalc.errors import RadcalcError
from radcalc.homework import check
from radcalc.homework.question import of_task
from radcalc.inputs.reading import read

LOBE = "max(cos(theta), 0)^{n}"
TABLE = "gamma (deg),I (cd)\n0,300\n15,290\n30,260\n45,200\n60,110\n75,30\n90,0\n"


@pytest.fixture
def table(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text(TABLE)
    return path


def floats(answer):
    """Return all results in coherent SI."""
    return {
        name: float(numpy.atleast_1d(value.to_base_units().magnitude)[0])
        for name, value in answer.items()
    }


def test_a_table_of_a_laboratory_in_one_command(table):
    """2 pi times the sum of [-I cos + s sin] over its parts, s the slope per radian."""
    angles, candelas = numpy.radians(range(0, 91, 15)), [300, 290, 260, 200, 110, 30, 0]
    slopes = numpy.diff(candelas) / numpy.diff(angles)
    whole = 2 * math.pi * sum(
        -candelas[k + 1] * math.cos(angles[k + 1]) + candelas[k] * math.cos(angles[k])
        + slopes[k] * (math.sin(angles[k + 1]) - math.sin(angles[k]))
        for k in range(6)
    )  # fmt: skip
    found = point_source(distribution=table)
    assert number(found, "flux", "lm") == pytest.approx(whole, rel=1e-12)
    assert number(found, "flux", "lm") == pytest.approx(791.3485, abs=5e-5)
    # by hand: 150 cd between 45 and 60 degrees, 30 cd at 75
    assert number(found, "beam_angle", "deg") == pytest.approx(2 * (45 + 15 * 50 / 90))
    assert number(found, "field_angle", "deg") == pytest.approx(150)


@pytest.mark.parametrize("exponent", [0.5, 30])
@pytest.mark.parametrize(
    "place",
    [
        {},
        {"distance": "2m"},
        {"height": "3m"},
        {"height": "3m", "offset": "1m"},
        {"height": "3m", "offset": "-1m", "offset_y": "2m"},
        {"height": "3m", "offset": "1m", "incidence": "0deg"},
        {"distance": "4m", "offset": "1m"},
        {"distance": "2m", "incidence": "30deg"},
        {"distance": "2m", "receiver_area": "0.01m2"},
        {"height": "3m", "offset": "1m", "receiver_area": "4m2"},
        {"height": "3m", "offset": "1m", "time": "2h"},
        {"within": "20deg"},
    ],
    ids=lambda place: " ".join(place) or "nowhere",
)
def test_an_expression_of_a_lobe_equals_the_lobe(exponent, place):
    closed = floats(point_source(flux="800lm", exponent=exponent, **place))
    for extra in ({"flux": "800lm"}, {"intensity": Q(closed["intensity"], "cd")}):
        text = LOBE.format(n=exponent)
        found = floats(point_source(distribution=text, **extra, **place))
        for name in closed.keys() & found.keys():
            rel = 1e-5 if name == "received_flux" else 1e-8
            assert found[name] == pytest.approx(closed[name], rel=rel, abs=1e-12), name
        assert "flux" in found


@pytest.mark.parametrize(
    ("text", "closed"),
    [
        ("1", {"distribution": "isotropic"}),
        ("(theta <= 30*deg)", {"half_angle": "30deg"}),
    ],
)
def test_an_expression_of_another_shape_equals_the_shape(text, closed):
    place = {"height": "3m", "offset": "1m", "offset_y": "0.5m", "flux": "1klm", "within": "20deg"}
    one, other = (
        floats(point_source(**kind, **place)) for kind in ({"distribution": text}, closed)
    )
    for name in ("flux", "intensity", "illuminance", "distance", "incidence", "flux_within"):
        assert one[name] == pytest.approx(other[name], rel=1e-4), name


def test_sources_that_are_aimed_and_rotated_by_vectors():
    """An oval lobe, by the rotation from straight down to its aim (Rodrigues)."""
    draw = random.Random(13)
    for _ in range(3):
        aim = [draw.uniform(-1, 1) for _ in range(3)]
        place = [draw.uniform(-3, 3), draw.uniform(-3, 3), draw.uniform(0.5, 4)]
        turn, exponent = draw.uniform(-180, 180), draw.uniform(0.5, 6)
        axis = numpy.array(aim) / numpy.linalg.norm(aim)
        down = numpy.array([0.0, 0.0, -1.0])
        about, cosine = numpy.cross(down, axis), down @ axis
        cross = numpy.cross(about, numpy.eye(3))  # v @ cross = about x v
        matrix = numpy.eye(3) + cross + cross @ cross / (1 + cosine)
        c0 = numpy.array([math.cos(math.radians(turn)), math.sin(math.radians(turn)), 0.0])
        x, axis = (v @ matrix for v in (c0, down))
        assert axis == pytest.approx(numpy.array(aim) / numpy.linalg.norm(aim))
        y = numpy.cross(x, axis)  # hanging, C90 is towards +y where C0 is towards +x
        y = y if (numpy.array([-c0[1], c0[0], 0.0]) @ matrix) @ y > 0 else -y
        to = numpy.array([place[0], place[1], -place[2]])
        away = numpy.linalg.norm(to)
        own = numpy.array([to @ x, to @ y, to @ axis]) / away
        intensity = 100 * max(own[2], 0) ** exponent * (1 + 0.3 * own[0] - 0.2 * own[1])
        found = point_source(
            distribution=f"100*max(z, 0)^{exponent!r}*(1 + 0.3*x - 0.2*y) cd",
            aim=",".join(map(repr, aim)),
            rotate=Q(turn, "deg"),
            height=Q(place[2], "m"),
            offset=Q(place[0], "m"),
            offset_y=Q(place[1], "m"),
        )
        assert number(found, "intensity_toward", "cd") == pytest.approx(intensity, abs=1e-9)
        assert number(found, "irradiance", "lx") == pytest.approx(
            intensity * place[2] / away**3, abs=1e-9
        )
        assert number(found, "upward_flux", "lm") + number(
            found, "downward_flux", "lm"
        ) == pytest.approx(number(found, "flux", "lm"))


@pytest.mark.parametrize(
    ("aim", "upward"),
    [("0,0,-1", 0.0), ("0,0,2", 1.0), ("1,0,0", 0.5), ("0,-3,0", 0.5), ("1,0,1", 0.5 + 2**-1.5)],
)
def test_the_upward_flux_of_a_lambertian_source(aim, upward):
    """Its projected solid angle above the horizon is (1 + sin(elevation)) / 2 of pi."""
    found = point_source(exponent=1, flux="100lm", aim=aim)
    assert number(found, "upward_flux", "lm") == pytest.approx(100 * upward, abs=1e-3)


def test_a_direction_from_the_axis():
    found = point_source(intensity="100cd", exponent=2, toward="60deg,90deg", distance="2m")
    assert number(found, "intensity_toward", "cd") == pytest.approx(25)
    assert number(found, "irradiance", "lx") == pytest.approx(6.25)
    found = point_source(distribution="3 + x + 2*y cd", toward="0,3,4", distance="1m")
    assert number(found, "intensity_toward", "cd") == pytest.approx(3 + 2 * 0.6)


def test_the_distance_the_height_and_the_offset_follow_from_an_irradiance(table):
    found = point_source(distribution=table, illuminance="75lx")
    assert number(found, "distance", "m") == pytest.approx(2)
    there = point_source(distribution=table, height="2m", offset="1.5m")
    lux = there["irradiance"]
    asked = point_source(distribution=table, illuminance=lux, offset="1.5m")
    assert min(abs(asked["height"].to("m").magnitude - 2)) < 1e-8
    assert len(asked["height"]) == 2
    flux = there["flux"]
    asked = point_source(distribution=table, flux=flux, illuminance=lux, height="2m")
    assert number(asked, "offset", "m") == pytest.approx(1.5)


def test_an_irradiance_below_a_source_requires_the_offset(table):
    there = point_source(distribution=table, height="2m", offset="1.5m")
    asked = point_source(distribution=table, height="2m", illuminance=there["irradiance"])
    assert number(asked, "offset", "m") == pytest.approx(1.5)
    assert number(asked, "flux", "lm") == pytest.approx(number(there, "flux", "lm"))
    with pytest.raises(RadcalcError, match="give 75 lx"):
        point_source(distribution=table, height="2m", illuminance="90lx")


def test_a_flux_without_convergence_is_absent():
    found = point_source(distribution="(sin(50*phi)>0)*(sin(50*theta)>0) cd", toward="2deg,2deg")
    assert "flux" not in found
    assert number(found, "intensity_toward", "cd") == 1


def test_a_receiver_within_five_times_the_size_of_the_source():
    """For 40 cm the least distance is 2 m."""
    lamp = Photometry(Lobe(1.0), "test", size=0.4)
    for away, is_near in (("1.9m", True), ("2m", False)):
        given = {"distribution": lamp, "distance": away, "intensity": "1cd"}
        notes = work_out({name: read(name, one) for name, one in given.items()}).notes
        assert any("five times" in note for note in notes) is is_near


def test_the_scale_of_a_distribution_is_not_part_of_a_mistake(table):
    """The scale of a table in candelas is 1 cd: nobody forgets it."""
    given = {"distribution": read("distribution", table)}
    verdict = check(of_task(Task("point-source", work_out), given), "flux=79.13485lm")
    assert not verdict.right
    assert "power of ten" in str(verdict)
    assert "weighted solid angle" not in str(verdict)


def test_a_light_quantity_scales_a_distribution(table):
    own = point_source(distribution=table, height="2m", offset="1m")
    for name in ("flux", "intensity", "peak_intensity", "irradiance"):
        twice = point_source(distribution=table, height="2m", offset="1m", **{name: 2 * own[name]})
        assert number(twice, "intensity_toward", "cd") == pytest.approx(
            2 * number(own, "intensity_toward", "cd")
        )
    watts = point_source(distribution=table, flux="10W", distance="1m")
    assert watts["irradiance"].to("W/m2").magnitude == pytest.approx(10 * 300 / 791.3485, rel=1e-6)


def test_a_spectrum_links_the_kinds(table):
    found = point_source(distribution=table, spectrum="LED-B3", distance="2m")
    efficacy = number(found, "luminous_efficacy", "lm/W")
    assert number(found, "radiant_flux", "W") == pytest.approx(791.3485 / efficacy, rel=1e-6)
    # watts are converted to the candelas of the file
    same = point_source(
        distribution=table, spectrum="LED-B3", irradiance=found["radiant_irradiance"]
    )
    assert number(same, "distance", "m") == pytest.approx(2)


def test_arrays_of_any_shape_that_fits(table):
    heights, offsets = numpy.linspace(1, 5, 7)[:, None], numpy.linspace(-3, 3, 5)
    found = point_source(distribution=table, height=Q(heights, "m"), offset=Q(offsets, "m"))
    assert found["irradiance"].shape == (7, 5)
    for i in (0, 6):
        for k in (0, 2, 4):
            one = point_source(
                distribution=table, height=Q(heights[i, 0], "m"), offset=Q(offsets[k], "m")
            )
            got = found["irradiance"].to("lx").magnitude[i, k]
            assert got == pytest.approx(number(one, "irradiance", "lx"))


def test_a_shape_follows_from_flux_and_peak():
    found = point_source(distribution="cone", flux="500lm", peak_intensity="900cd", aim="1,0,0")
    assert number(found, "half_angle", "deg") == pytest.approx(24.2753, abs=1e-4)


def test_a_beam_without_a_unique_angle_is_ambiguous():
    """100, 300 and 0 cd at 0, 60 and 90 degrees: half at 75 degrees, half of the axis at 85."""
    wing = Grid(numpy.radians([0, 60, 90]), [0.0], [[100.0, 300.0, 0.0]])
    answer = work_out({"distribution": read("distribution", wing)})
    rows = {one.name: one for one in answer.values}
    assert math.degrees(rows["beam-angle"].amount) == pytest.approx(150)
    assert math.degrees(rows["peak-polar"].amount) == pytest.approx(60)
    assert any("beam angle is ambiguous" in note and "170 deg" in note for note in answer.notes)


def test_the_diameter_of_a_beam():
    found = point_source(exponent=1, intensity="1cd", peak_intensity="1cd", distance="2m")
    assert number(found, "beam_diameter", "m") == pytest.approx(4 * math.tan(math.pi / 3))


@pytest.mark.parametrize(
    "given",
    [
        {"half_angle": "15deg", "height": "2m"},
        {"half_angle": "15deg", "flux": "9lm", "height": "2m", "offset": "1m"},
        {"beam_angle": "30deg", "distance": "2m"},
        {"beam_angle": "30deg", "intensity": "100cd", "distance": "2m"},
    ],
)
def test_the_diameter_of_a_cone_and_of_a_lobes_beam(given):
    """4 m times tan 15 degrees = 2 - sqrt(3)."""
    found = point_source(**given)
    assert number(found, "beam_diameter", "m") == pytest.approx(4 * (2 - math.sqrt(3)))


@pytest.mark.parametrize("wide", [{"half_angle": "90deg"}, {"exponent": 0}, {}])
def test_a_light_of_90_degrees_or_more_has_no_diameter(wide):
    assert "beam_diameter" not in point_source(**wide, flux="9lm", distance="2m")


def test_a_distribution_of_python():
    lobe = point_source(distribution=Lobe(1.0), intensity="1cd")
    assert number(lobe, "flux", "lm") == pytest.approx(math.pi)
    grid = Grid([0.0, math.pi / 2], [0.0], [[100.0, 100.0]])
    assert number(point_source(distribution=grid), "flux", "lm") == pytest.approx(200 * math.pi)


def ies(intensities, lumens=1000, watts=10):
    """A file of one plane, from the axis to 90 degrees."""
    angles = [90 * k / (len(intensities) - 1) for k in range(len(intensities))]
    return "\n".join(
        [
            "IESNA:LM-63-2002", "[LUMINAIRE] test", "TILT=NONE",
            f"1 {lumens} 1 {len(angles)} 1 1 2 0 0 0", f"1 1 {watts}",
            " ".join(map(str, angles)), "0", " ".join(map(str, intensities)), "",
        ]
    )  # fmt: skip


def test_the_lamps_that_a_file_declares(tmp_path):
    path = tmp_path / "lamp.ies"
    path.write_text(ies([100, 100], lumens=1000, watts=20))
    found = point_source(distribution=path)
    lumens = 200 * math.pi
    assert number(found, "output_ratio", "1") == pytest.approx(lumens / 1000)
    assert number(found, "input_power", "W") == pytest.approx(20)
    assert number(found, "source_efficacy", "lm/W") == pytest.approx(lumens / 20)
    assert "luminous_efficacy" not in found
    scaled = point_source(distribution=path, flux="1klm")
    assert not {"output_ratio", "input_power", "source_efficacy"} & set(scaled)
    linked = point_source(distribution=path, spectrum="D65")
    assert number(linked, "source_efficacy", "lm/W") == pytest.approx(lumens / 20)
    assert number(linked, "luminous_efficacy", "lm/W") > 100


@pytest.mark.parametrize(("declared", "is_noted"), [(0.70, True), (0.64, False)])
def test_a_declared_output_ratio_is_compared(declared, is_noted):
    """200 pi lm of 1000 lm are 0.628."""
    lamp = Photometry(
        Grid([0.0, math.pi / 2], [0.0], [[100.0, 100.0]]),
        "EULUMDAT, Isym 1",
        "lamp",
        {"lamp-flux": 1000.0, "output-ratio": declared},
    )
    told = [note for note in lamp.contradictions() if "62.83 %" in note and "70 %" in note]
    assert bool(told) is is_noted


@pytest.mark.parametrize(
    ("lumens", "is_noted"), [(600, True), (620, False), (900, False), (-1, False)]
)
def test_lamps_have_no_less_light_than_their_luminaire(tmp_path, lumens, is_noted):
    """100 cd in the lower hemisphere are 200 pi lm, for any aim and scale."""
    path = tmp_path / "lamp.ies"
    path.write_text(ies([100, 100], lumens=lumens, watts=20))
    said = "the file declares lamps of 600 lm, but its intensities give 628.3 lm, which is more"
    for more in ({}, {"aim": (0, 0, 1), "height": "2m"}, {"flux": "1klm"}):
        given = {"distribution": path} | more
        notes = work_out({name: read(name, one) for name, one in given.items()}).notes
        assert (said in notes) is is_noted


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"distribution": "cos(theta)^2"}, "relative: a quantity that scales it is missing"),
        ({"distribution": "1 cd", "half_angle": "30deg"}, "half_angle cannot be used with"),
        ({"distribution": "1 cd", "exponent": 3}, "exponent cannot be used with"),
        ({"distribution": "theta cd", "intensity": "5cd"}, "which is 0 in this distribution"),
        ({"distribution": "0 cd"}, "no intensity in the sampled"),
        ({"distribution": "(abs(theta-1*rad)<1e-5*rad) cd"}, "narrower than 0.0"),
        ({"distribution": "cos(theta) cd"}, "has a negative value"),
        ({"distribution": "1 cd", "toward": "3deg", "height": "3m"}, "both place the receiver"),
        ({"distribution": "1 cd", "rotate": "3deg", "distance": "3m"}, "apply without a receiver"),
        ({"distribution": "1 cd", "irradiance": "3W/m2"}, "an efficacy that links them is missing"),
        ({"distribution": "1 cd", "illuminance": "3lx", "offset": "9m"}, "no height gives exactly"),
        ({"distribution": "1 cd", "offset": "9m"}, "offset alone is not enough: height is missing"),
        ({"distribution": "lamp.ies"}, "cannot read 'lamp.ies': no such file"),
        (
            {"exponent": "1", "beam_angle": "30deg", "peak_intensity": "9cd"},
            "contradicts the other inputs, which give 19.9937",
        ),
        ({"distribution": "9*(theta < 0) cd", "distance": "1m"}, "directions; peaks narrower than"),
        ({"distribution": "cone", "aim": "1,0,0", "flux": "1lm"}, "the width of the cone is"),
        ({"distribution": "1 cd", "aim": "0,0,0", "height": "1m"}, "aim '0,0,0' has no direction"),
        (
            {
                "distribution": "(theta < 5*deg) cd",
                "distance": "1m",
                "receiver_area": "0.2m2",
                "toward": "3deg",
            },
            "edges of the light on the receiver are too sharp",
        ),
        (
            {"distribution": "max(cos(theta), 0) cd", "distance": "1m", "incidence": "20deg",
             "receiver_area": "0.2m2"},
            "the axis of its incidence is not known",
        ),
    ],
)  # fmt: skip
def test_options_that_exclude_each_other_are_refused(given, said):
    with pytest.raises(RadcalcError) as refused:
        point_source(**given)
    assert said in refused.value.message
    assert refused.value.hint


def test_a_point_source_has_no_radiance():
    given = {"distribution": "1 cd", "radiance": "3cd/m2"}
    with pytest.raises(RadcalcError, match="a point source has no") as refused:
        work_out({name: read(name, one) for name, one in given.items()})
    assert "lambertian" in refused.value.hint


@pytest.mark.parametrize("place", [{"distance": "1m"}, {"height": "1m"}])
def test_a_receiver_around_the_axis_of_a_narrow_beam_gets_all_of_it(place):
    """A cone of 1 degree has 2 pi (1 - cos 1 deg) sr; a disc of 1 m2 at 1 m is wider."""
    found = point_source(distribution="(theta < 1*deg)*100 W/sr", receiver_area="1m2", **place)
    true = 200 * math.pi * (1 - math.cos(math.radians(1)))
    assert number(found, "received_flux", "W") == pytest.approx(true, rel=1e-6)


def test_a_beam_between_the_sample_points_of_a_receiver_is_refused():
    with pytest.raises(RadcalcError, match=r"too narrow|too sharp"):
        point_source(
            distribution="(theta < 1*deg)*100 W/sr", receiver_area="1m2", height="1m", offset="0.1m"
        )
