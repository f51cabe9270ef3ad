"""Results of functions: attributes, aliases, remarks and their display in a notebook."""

import copy
import json
import pickle
import shlex
from concurrent.futures import ProcessPoolExecutor
from html.parser import HTMLParser
from multiprocessing import get_context

import numpy as np
import pandas
import pytest
from conftest import ROOT, run

import radcalc
from radcalc.quantities.symbols import SYMBOLS

Q = radcalc.Quantity
LAMP = radcalc.point_source(flux="800 lm", distance="2 m")
PER_SR = 800 / (4 * np.pi)  # the intensity of an isotropic source of 800 lm [cd]


def test_results_are_attributes_and_items_under_each_of_their_names():
    for name in ("irradiance", "illuminance"):
        assert getattr(LAMP, name) == LAMP[name]
        assert getattr(LAMP, name).m_as("lx") == pytest.approx(PER_SR / 4)
    assert {"irradiance", "illuminance", "luminous_intensity", "steps"} <= {*dir(LAMP)}
    assert [*LAMP] == ["intensity", "flux", "illuminance", "distance", "incidence"]
    assert len(LAMP) == 5
    assert "illuminance" in LAMP._ipython_key_completions_()
    assert {**LAMP}["flux"] == Q(800, "lm")


def test_an_item_has_its_name_with_hyphens_or_underscores():
    daylight = radcalc.spectrum("D65")
    names = {row.name for row in daylight.rows}  # the names in the repr
    assert "peak-wavelength" in names
    assert {name.replace("-", "_") for name in names} == {*daylight}
    for name in names:
        assert name in daylight
        assert daylight[name] == daylight[name.replace("-", "_")]


def test_kinds_of_light_that_are_linked_have_their_own_names():
    green = radcalc.point_source(flux="5 mW", distance="1 m", wavelength="555 nm")
    assert green.luminous_flux.m_as("lm") == pytest.approx(0.005 * 683.002)  # CIE 018:2019
    assert green.radiant_flux.m_as("mW") == pytest.approx(5)
    assert green.flux.units == green.radiant_flux.units


def test_no_result_has_the_name_of_a_common_attribute():
    own = {name for name in dir(radcalc.Result) if not name.startswith("_")} | vars(LAMP).keys()
    assert not own & {name.replace("-", "_") for name in SYMBOLS}


def test_an_unknown_name_is_an_attribute_error_or_a_key_error_with_the_known_names():
    with pytest.raises(AttributeError, match="'Result' object has no attribute 'iluminance'"):
        LAMP.iluminance  # noqa: B018
    assert not hasattr(LAMP, "luminance")
    with pytest.raises(KeyError, match=r"unknown result 'iluminance'\ntry: .*, illuminance, "):
        LAMP["iluminance"]
    assert LAMP.get("radiance") is None
    assert "radiance" not in LAMP


def test_assumptions_notes_and_steps_are_spelled_for_python():
    assert LAMP.assumptions[0] == "isotropic: the same intensity in all directions"
    assert [step.law for step in LAMP.steps][-1] == "inverse square law"
    assert radcalc.photon("300 nm").notes[0].startswith("300 nm is invisible")
    ball = radcalc.uberlight((0, 0, 1), intensity="1 cd")
    assert "a fall-off distance of 1 m (falloff_distance)" in ball.assumptions


CALLS = {
    "a lamp": (
        lambda: radcalc.point_source(flux="800 lm", distance="2 m"),
        "point-source --flux '800 lm' --distance '2 m'"),
    "a disc": (
        lambda: radcalc.lambertian("disc", luminance="1e4 cd/m2", radius="25 cm", height="75 cm"),
        "lambertian disc --luminance '1e4 cd/m2' --radius '25 cm' --height '75 cm'"),
    "an uncertain distance": (
        lambda: radcalc.point_source(intensity="100 cd", distance="2.00+-0.02 m"),
        "point-source --intensity '100 cd' --distance '2.00+-0.02 m'"),
    "a cone": (
        lambda: radcalc.solid_angle("cone", half_angle="30 deg"),
        "solid-angle cone --half-angle '30 deg'"),
    "a polygon": (
        lambda: radcalc.solid_angle("triangle", ["1,0,0", "0,1,0", "0,0,1"]),
        "solid-angle triangle 1,0,0 0,1,0 0,0,1"),
    "a photon": (
        lambda: radcalc.photon("2.33 eV", observer="scotopic"),
        "photon '2.33 eV' --observer scotopic"),
    "a spectrum": (lambda: radcalc.spectrum("D65"), "spectrum D65"),
    "a vector": (lambda: radcalc.direction("1,1,1"), "direction 1 1 1"),
    "a beam": (
        lambda: radcalc.etendue(area="1 mm2", half_angle="30 deg"),
        "etendue --area '1 mm2' --half-angle '30 deg'"),
    "a sky": (
        lambda: radcalc.sky("overcast", zenith_luminance="9000 cd/m2", tilt="90 deg"),
        "sky overcast --zenith-luminance '9000 cd/m2' --tilt '90 deg'"),
    "surroundings": (
        lambda: radcalc.environment("sky:overcast", zenith_luminance="9 kcd/m2", normal="1,0,0"),
        "environment sky:overcast --zenith-luminance '9 kcd/m2' --normal 1,0,0"),
    "twilight": (
        lambda: radcalc.mesopic(luminance="0.1 cd/m2", spectrum="LED-B3"),
        "mesopic --luminance '0.1 cd/m2' --spectrum LED-B3"),
    "a picture": (
        lambda: radcalc.screen(flux="2 klm", width="2 m", aspect="4/3"),
        "screen --flux '2 klm' --width '2 m' --aspect 4/3"),
    "a conversion": (
        lambda: radcalc.explain("800 lm", "cd", half_angle="60 deg"),
        "convert '800 lm' cd --half-angle '60 deg'"),
    "an uncertain conversion": (
        lambda: radcalc.explain("100+-3 lx", "fc"), "convert '100+-3 lx' fc"),
}  # fmt: skip


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_a_dict_equals_the_json_of_the_command(call):
    ask, words = call
    expected = json.loads(run(*shlex.split(words), "--json", "--steps").stdout)
    found = ask().to_dict()
    for one in (expected, found):  # spelled differently at the two gates
        one.pop("assumptions"), one.pop("notes")
        for given in one["inputs"].values():
            given.pop("text", None) if "value" in given else None
    assert found == expected
    json.dumps(found, allow_nan=False)


def test_the_dict_of_arrays_has_lists():
    found = radcalc.point_source(flux="800 lm", distance=["1 m", "2 m"]).to_dict()
    assert found["results"]["illuminance"]["value"] == pytest.approx([PER_SR, PER_SR / 4])
    assert found["inputs"]["distance"] == {"value": [1.0, 2.0], "unit": "m"}


def test_every_calculator_takes_arrays():
    """E = h c / lambda; h c is 1239.841984 eV nm by the SI's constants."""
    found = radcalc.photon(Q(np.array([[500.0, 600.0]]), "nm"))
    np.testing.assert_allclose(found.photon_energy.m_as("eV"), 1239.841984 / np.array([[500, 600]]))
    cones = radcalc.solid_angle("cone", half_angle=["60 deg", "90 deg"])
    np.testing.assert_allclose(cones.solid_angle.m_as("sr"), [np.pi, 2 * np.pi])
    assert radcalc.photon(Q(np.empty(0), "nm")).photon_energy.shape == (0,)


def test_several_answers_are_arrays_of_them():
    found = radcalc.point_source(intensity="100 cd", offset="1 m", illuminance="10 lx")
    assert found.height.shape == (2,)
    assert "2 " not in found.command
    assert len(found.rows[0].value) == 2


class Page(HTMLParser):
    """Parser that collects the table cells, list items and tags of a page."""

    def __init__(self, text):
        super().__init__()
        self.rows, self.items, self.open, self.tags, self.styles = [], [], [], [], ""
        self.folded = ""
        self.feed(text)
        self.close()
        assert not self.open

    def handle_starttag(self, tag, attributes):
        self.open.append(tag)
        self.tags.append(tag)
        self.styles += " ".join(value or "" for _, value in attributes)
        if tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th"):
            self.rows[-1].append("")
        elif tag == "li":
            self.items.append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1] in ("td", "th"):
            self.rows[-1][-1] += data
        elif self.open[-1] == "li":
            self.items[-1] += data
        elif self.open[-1] == "pre":
            self.folded += data


def test_a_notebook_shows_inputs_results_and_assumptions():
    page = Page(LAMP._repr_html_())
    assert page.rows[0] == ["quantity", "symbol", "value", "unit"]
    assert ["flux (given)", "", "800 lm", ""] in page.rows
    assert ["illuminance", "E_v", "15.9155", "lx"] in page.rows  # 800 / (16 pi)
    assert f"assumed: {LAMP.assumptions[1]}" in page.items
    assert "E = I cos(theta) Omega0 / d^2" in page.folded


def test_a_notebook_shows_notes_arrays_uncertainties_and_texts():
    dark = Page(radcalc.photon("300 nm", observer="scotopic")._repr_html_())
    assert any(one.startswith("note: 300 nm is invisible") for one in dark.items)
    assert ["observer (given)", "", "scotopic", ""] in dark.rows
    many = radcalc.point_source(intensity="1 cd", distance=Q(np.arange(1.0, 100.0), "m"))
    page = Page(many._repr_html_())
    assert ["distance (given)", "", "[1 2 3 ... 97 98 99]", "m"] in page.rows
    off = radcalc.point_source(intensity="100 cd", distance="2.00+-0.02 m")
    assert ["illuminance", "E_v", "25.00 ± 0.50", "lx"] in Page(off._repr_html_()).rows


def test_a_users_text_is_escaped_in_a_notebook():
    text = "3*(theta<1*rad)*(phi>=0)*1 cd"
    page = Page(radcalc.point_source(distribution=text)._repr_html_())
    assert ["distribution (given)", "", text, ""] in page.rows


def test_the_page_has_no_colours_scripts_or_links():
    page = Page(LAMP._repr_html_())
    assert not {*page.tags} & {"script", "style", "a", "img", "font"}
    assert "color" not in page.styles
    assert "background" not in page.styles


def test_an_interpreter_shows_the_results_with_units_and_assumptions():
    lines = repr(LAMP).splitlines()
    assert lines[0] == "radcalc point-source"
    assert "  illuminance  15.9155 lx" in lines
    assert "  flux         800 lm (given)" in lines
    assert f"  assumed: {LAMP.assumptions[0]}" in lines


def test_values_that_dask_has_not_computed_are_shown_as_lazy():
    import dask.array

    array = dask.array.from_array(np.array([1.0, 2.0]))
    found = radcalc.point_source(intensity="1 cd", distance=Q(array, "m"))
    assert "illuminance  an array of the shape (2,), not computed yet lx" in repr(found)
    assert found.assumptions
    with pytest.raises(radcalc.ConditionError, match="not computed yet"):
        found.to_dict()


def test_a_file_is_named_among_the_inputs():
    found = radcalc.point_source(distribution=ROOT / "examples" / "downlight.ies")
    assert "downlight.ies" in str(found.inputs) or found.inputs[0].text


def test_a_text_may_be_a_list_or_a_range_as_on_the_command_line():
    for text in ("1m,2m,5m", ["1 m", "200 cm", Q(5, "m")]):
        found = radcalc.point_source(intensity="100 cd", distance=text)
        np.testing.assert_allclose(found.illuminance.m_as("lx"), [100, 25, 4])
    steps = radcalc.point_source(intensity="100 cd", distance="1m:5m:1m").distance
    assert steps.m_as("m").tolist() == [1, 2, 3, 4, 5]
    shares = radcalc.lambertian(incident_irradiance="100 lx", reflectance=["50 %", 0.25]).exitance
    np.testing.assert_allclose(shares.m, [50, 25])


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"distance": ["1 m", "2 lm"]}, "takes a length"),
        ({"wavelength": ["500 nm", "2 eV"]}, "mixes quantities"),
        ({"distance": ["1 m", "2"]}, "the unit of .* is missing"),
        ({"distance": [Q([1, 2], "m")]}, "a list of arrays"),
        ({"distance": ["1+-0.1 m", "2 m"]}, "cannot be uncertain here"),
    ],
)
def test_a_list_that_is_not_an_array_is_refused(given, said):
    with pytest.raises(radcalc.RadcalcError, match=said) as caught:
        radcalc.point_source(flux="800 lm", **given)
    assert caught.value.hint


def test_explain_refuses_a_list():
    with pytest.raises(radcalc.RadcalcError, match="single values"):
        radcalc.explain(["1 lx", "2 lx"], "fc")
    with pytest.raises(radcalc.ConditionError, match="one value of"):
        radcalc.explain("100 cd", "lx", distance=["1 m", "2 m"])


def test_a_picture_is_shown_by_a_notebook_and_written_to_a_file(tmp_path):
    drawn = radcalc.point_source(flux="800 lm", distance="1m:5m:1m").plot("illuminance:fc")
    assert "<svg" in drawn._repr_svg_()
    assert drawn.figure.axes
    assert "distance" in repr(drawn)  # the name of an axis
    drawn.save(tmp_path / "fall-off.png")
    assert (tmp_path / "fall-off.png").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(radcalc.RadcalcError, match="fall-off"):
        drawn.save(tmp_path / "fall-off.txt")


def test_a_picture_that_is_not_drawn_in_characters_names_the_call_that_writes_it():
    drawn = radcalc.sky("overcast", zenith_luminance="9 kcd/m2").plot()
    assert repr(drawn) == "a fisheye view: .save('plot.png') writes it into a file"
    assert "<svg" in drawn._repr_svg_()


UNDRAWN = {
    "a conversion has no picture": lambda: radcalc.explain("800 lm", "cd", isotropic=True),
    "a scene at points has no picture": lambda: radcalc.scene(
        [{"x": 0, "y": 0, "z": 2, "flux": "8 lm"}], (0, 0, 0)
    ),
    "pickled": lambda: pickle.loads(pickle.dumps(LAMP)),
}


@pytest.mark.parametrize("said", UNDRAWN)
def test_a_result_without_a_picture_names_those_that_have_one(said):
    with pytest.raises(radcalc.RadcalcError, match=said) as caught:
        UNDRAWN[said]().plot()
    assert caught.value.hint


KEPT = {
    "numbers": lambda: radcalc.spectrum("D65"),
    "an array": lambda: radcalc.point_source(flux="800 lm", distance=Q(np.array([1, 2]), "m")),
    "a column": lambda: radcalc.point_source(
        flux="800 lm", distance=pandas.Series([1.0, 2.0], name="distance [m]")
    ),
    "points": lambda: radcalc.uberlight([(0, 0, 1), (0, 0, 2)], intensity="100 cd"),
    "a conversion": lambda: radcalc.explain("500 lx", "cd/m2", reflectance=0.8),
}


@pytest.mark.parametrize("what", KEPT)
def test_a_result_is_kept_by_pickle_and_is_equal_to_itself(what):
    found = KEPT[what]()
    again = pickle.loads(pickle.dumps(found))
    assert (found == again) is True
    assert (found != again) is False
    assert repr(again) == repr(found)
    assert again.to_dict() == found.to_dict()
    with pytest.raises(radcalc.ConditionError):
        radcalc.check(again, "1")


def test_a_copy_has_the_results_on_request_and_a_pickle_those_requested_before():
    lamp = radcalc.spectrum("LED-B3")
    before = pickle.loads(pickle.dumps(lamp))
    assert copy.copy(lamp).rf == copy.deepcopy(lamp).rf == lamp.rf
    assert pickle.loads(pickle.dumps(lamp)).rf == lamp.rf
    with pytest.raises(radcalc.RadcalcError, match="pickled") as caught:
        before.rf  # noqa: B018
    assert ".rf" in caught.value.hint


def test_a_result_cannot_be_replaced():
    with pytest.raises(AttributeError, match="illuminance"):
        LAMP.illuminance = 5
    assert not hasattr(LAMP, "__dict__") or "illuminance" not in vars(LAMP)


@pytest.mark.parametrize(
    "other",
    [
        lambda: radcalc.point_source(flux="800 lm", distance=["1 m", "3 m"]),
        lambda: radcalc.point_source(flux="800 lm", distance=["1 m", "2 m", "3 m"]),
        lambda: LAMP,
        lambda: radcalc.spectrum("D65"),
        lambda: {},
        lambda: 5,
    ],
)
def test_results_with_other_values_or_names_are_not_equal(other):
    found = radcalc.point_source(flux="800 lm", distance=["1 m", "2 m"])
    assert (found == other()) is False


@pytest.mark.parametrize(
    "kept", [Q(3, "klx"), Q(np.array([1.0, 2.0]), "umol/s"), Q(3, "lx").plus_minus(0.1)]
)
def test_an_unpickled_quantity_belongs_to_the_registry_of_the_functions(kept):
    again = pickle.loads(pickle.dumps(kept))
    assert repr(again) == repr(kept)
    assert type(again) is type(kept)
    assert pickle.loads(pickle.dumps(kept.units)) == kept.units


def test_another_process_gives_results():
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        found = pool.submit(radcalc.spectrum, "D65").result()
    assert found == radcalc.spectrum("D65")
    assert radcalc.convert(found.peak_wavelength, "um").m == pytest.approx(0.46)  # 117.8 at 460 nm


@pytest.mark.parametrize(
    ("result", "wanted"),
    [
        (lambda: radcalc.spectrum("D65"), "cct"),
        (lambda: radcalc.sky("overcast", zenith_luminance="9 kcd/m2"), "zenith_luminance"),
        (lambda: LAMP, "illuminance"),
    ],
)
def test_an_axis_that_a_picture_does_not_depend_on_is_refused(result, wanted):
    with pytest.raises(radcalc.RadcalcError, match=f"does not depend on {wanted}"):
        result().plot(wanted)
    with pytest.raises(radcalc.RadcalcError, match="unknown result 'peak_zork'"):
        result().plot("peak_zork")
    assert "[kcd]" in repr(LAMP.plot("intensity:kcd"))


@pytest.mark.parametrize("shape", [(2, 3), (0,)])
def test_an_array_that_is_not_a_curve_is_refused(shape):
    found = radcalc.point_source(flux="1 lm", distance=radcalc.Quantity(np.ones(shape), "m"))
    with pytest.raises(radcalc.RadcalcError, match="distance is an array of the shape"):
        found.plot()


def test_the_errors_are_in_the_top_level_package():
    assert issubclass(radcalc.UnitError, radcalc.RadcalcError)
    with pytest.raises(radcalc.UnitError):
        radcalc.convert("1 zork", "lx")
