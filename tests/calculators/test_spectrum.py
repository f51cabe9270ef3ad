"""Properties of spectra against published values."""

import itertools
import math
import pickle

import numpy
import pytest
from conftest import run
from following import call

import radcalc
from radcalc.calculators.results import absent, pick
from radcalc.calculators.spectrum import PAGE
from radcalc.calculators.spectrum import spectrum as describe
from radcalc.errors import RadcalcError
from radcalc.inputs.reading import read
from radcalc.spectra.data import suns
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.sources import spectrum
from radcalc.spectra.spectrum import BlackBody, Lines


def results(text: str, range_: str = "") -> dict[str, float]:
    given = {"spectrum": read("spectrum", text)}
    if range_:
        given["range"] = read("range", range_)
    return {value.name: value.amount for value in describe(given).values if not value.is_absent}


def test_a_spectrum_is_described():
    # the nominal sun of 5772 K: Wien 502.04 nm, Stefan-Boltzmann 6.2939e7 W/m2
    sun = results("blackbody:5772K")
    assert sun["peak-wavelength"] == pytest.approx(2.897771955e-3 / 5772, rel=1e-9)
    assert sun["exitance"] == pytest.approx(5.670374419e-8 * 5772**4, rel=1e-9)
    assert sun["radiance"] == pytest.approx(sun["exitance"] / math.pi, rel=1e-14)
    assert sun["cct"] == pytest.approx(5772, abs=1)
    # CIE 15: A is x 0.4476, y 0.4074, 2856 K and, as its own reference, Ra 100
    a = results("A")
    assert (a["x"], a["y"]) == pytest.approx((0.4476, 0.4074), abs=5e-5)
    assert a["cct"] == pytest.approx(2856, abs=1)
    assert a["cri"] == pytest.approx(100, abs=0.05)
    assert a["sp-ratio"] == pytest.approx(1.41, abs=0.005)
    d65 = results("D65")
    assert (d65["x"], d65["y"]) == pytest.approx((0.3127, 0.3290), abs=5e-5)
    # CIE 15, table of fluorescent lamps: F2 4230 K, Ra 64; F11 4000 K, Ra 83
    for name, temperature, rendering in (("F2", 4230, 64), ("F11", 4000, 83)):
        lamp = results(name)
        assert lamp["cct"] == pytest.approx(temperature, abs=10)
        assert lamp["cri"] == pytest.approx(rendering, abs=1)


def test_a_range_has_its_share_and_its_efficacy():
    half = results("band:400nm:700nm", "300nm:550nm")
    assert half["range-fraction"] == pytest.approx(0.5)
    assert half["range-start"] == pytest.approx(400e-9)  # the table has no values below
    whole = results("gaussian:530nm,30nm")
    assert whole["fwhm"] == pytest.approx(30e-9, rel=1e-3)
    assert whole["centroid-wavelength"] == pytest.approx(530e-9, rel=1e-9)
    assert "cct" not in whole  # green is not white


def test_no_power_in_the_range_is_refused():
    with pytest.raises(RadcalcError, match="no power"):
        results("band:500nm:600nm", "700nm:800nm")


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ("spectrum D65 --photon-range 600nm:610nm", "lux-per-ppfd"),
        ("point-source --flux 5W --spectrum D65 --range 600nm:610nm", "luminous-flux"),
    ],
)
def test_an_impossible_ratio_is_absent_and_other_results_are_answered(words, name):
    everything = run(*words.split())
    assert everything.returncode == 0
    assert name not in everything.stdout
    done = run(*words.split(), "-g", name)
    assert (done.returncode, done.stdout) == (2, "")
    assert "more than any light gives" in done.stderr


def test_a_band_of_an_absolute_spectrum_has_its_irradiance():
    # ASTM G173-03, global tilt: trapezoidal rule on its table from 600 nm to 700 nm
    band = results("AM1.5G", "600nm:700nm")
    table = zip(suns.WAVELENGTHS, suns.AM1_5G, strict=True)
    inside = [(place, value) for place, value in table if 600 <= place <= 700]
    steps = itertools.pairwise(inside)
    expected = sum((b - a) * (p + q) / 2 for (a, p), (b, q) in steps)
    assert expected == pytest.approx(139.24, abs=5e-3)
    assert band["irradiance"] == pytest.approx(expected, rel=1e-12)


SOURCES = [
    "D65", "F11", "HPS", "AM1.5G", "LED-B3", "band:400nm:700nm", "gaussian:530nm,30nm",
    "daylight:6500K", "line:450nm=2,555nm=1,632.8nm=3", "blackbody:2856K", "blackbody:9000K",
]  # fmt: skip
ENDS = [200, 380, 421.5, 500, 554, 600.25, 700, 790, 1200]


def summed(text: str, low: float, high: float, weight: str = "") -> float:
    """Return the sum of a spectrum times an observer's table, in steps of 1/40 nm."""
    source = spectrum(text)
    if isinstance(source, Lines):
        places, watts = map(numpy.array, zip(*source.lines, strict=True))
        steps = watts * ((places >= low) & (places <= high))
    else:
        places = numpy.arange(low, high, 0.025) + 0.0125
        if isinstance(source, BlackBody):  # CODATA 2022: c1 and c2 [W nm4/m2, nm K]
            c1, c2 = 3.7417718521927573e20, 1.4387768775039337e7
            heights = c1 / places**5 / numpy.expm1(c2 / places / source.temperature)
        else:
            heights = numpy.interp(places, source.grid, source.values, 0.0, 0.0)
        steps = heights * 0.025
    if weight:
        eye = OBSERVERS[weight]
        nodes = numpy.arange(eye.start, eye.end + 1)
        steps = steps * eye.maximum * numpy.interp(places, nodes, eye.values, 0.0, 0.0)
    return float(steps.sum())


@pytest.mark.parametrize("text", SOURCES)
def test_every_result_is_of_the_range(text):
    """Watts, lumens of two eyes and photons, from sums over the range alone."""
    answered = 0
    for low, high in itertools.pairwise(ENDS):
        watts = summed(text, low, high)
        if not watts:
            continue
        found = results(text, f"{low}nm:{high}nm")
        lumens, dark = (summed(text, low, high, eye) for eye in ("photopic", "scotopic"))
        assert found["luminous-efficacy"] == pytest.approx(lumens / watts, rel=5e-3, abs=1e-5)
        by_night = found["scotopic-luminous-efficacy"]
        assert by_night == pytest.approx(dark / watts, rel=5e-3, abs=1e-5)
        for name, amount in (("irradiance", watts), ("exitance", watts)):
            assert found.get(name, amount) == pytest.approx(amount, rel=5e-3)
        assert found.get("illuminance", lumens) == pytest.approx(lumens, rel=5e-3, abs=1e-3)
        assert found.get("luminance", lumens / math.pi) == pytest.approx(lumens / math.pi, rel=5e-3)
        assert low * 1e-9 <= found["peak-wavelength"] <= high * 1e-9
        assert low * 1e-9 <= found["centroid-wavelength"] <= high * 1e-9
        shortest = 6.62607015e-34 * 299792458 / (high * 1e-9)  # photons, if counted, are inside
        assert shortest <= found.get("photon-energy", shortest) <= shortest * high / low
        answered += 1
    assert answered >= 3


def test_parts_of_a_spectrum_add_up():
    """The tristimulus values of two parts: x = X / (X + Y + Z), with Y from the lumens."""
    for text in SOURCES:
        whole, *parts = (results(text, part) for part in ("1nm:1mm", "1nm:580nm", "580nm:1mm"))
        lumens = [part["range-fraction"] * part["luminous-efficacy"] for part in parts]
        all_lumens = whole["luminous-efficacy"] * whole["range-fraction"]
        assert sum(lumens) == pytest.approx(all_lumens, rel=1e-3)
        for axis in "xy":
            weights = [lm / part["y"] for lm, part in zip(lumens, parts, strict=True)]
            sums = sum(w * part[axis] for w, part in zip(weights, parts, strict=True))
            assert sums / sum(weights) == pytest.approx(whole[axis], abs=1e-3)


def test_the_range_of_all_results_is_stated():
    said = run("spectrum", "D65", "--range", "500nm:600nm", "-g", "luminous-efficacy").stderr
    assert "all results are of the light in 500-600 nm" in said
    said = run("spectrum", "D65", "--range", "600nm:700nm").stderr
    assert "the peak is at the end of the range" in said


RANGES = [
    # requested, and cut to a table from 380 nm to 780 nm
    ("--range 280nm:2500nm", "range-start:nm", "380", "watts are counted over 380-780 nm, not"),
    ("--range 280nm:2500nm", "range-end:nm", "780", "not over 280-2500 nm"),
    ("--range 500nm:900nm", "range-start:nm", "500", "watts are counted over 500-780 nm"),
    ("--photon-range 300nm:900nm", "range-end:nm", "780", "photons are counted over 380-780 nm"),
    ("--range 400nm:700nm", "range-end:nm", "700", ""),
]


@pytest.mark.parametrize(("option", "name", "claimed", "note"), RANGES)
def test_the_range_of_an_answer_ends_with_the_data(option, name, claimed, note):
    done = run("spectrum", "HPS", *option.split(), "-g", name)
    assert done.stdout.strip() == claimed
    assert note in done.stderr
    if not note:
        assert "the data of" not in done.stderr


def test_the_part_outside_of_short_tables_is_noted():
    said = run("spectrum", "ISO 7589 Photoflood").stderr
    assert "watts are counted over 380-690 nm, not over 380-780 nm" in said
    assert "photons are counted over 400-690 nm, not over 400-700 nm" in said
    assert "the peak is at the end of the data" in run("spectrum", "A").stderr
    assert "the peak is at the end of the data" not in run("spectrum", "D65").stderr


def test_the_lumens_outside_of_a_range_are_noted():
    # of an equal-energy band, V summed over 450-650 nm against V over all: 1924, 1 nm steps
    inside = sum(OBSERVERS["photopic"].values[90:291]) - 0.5 * (0.038 + 0.107)
    share = inside / 106.86  # the integral of V, as CIE 018:2019's table sums up
    said = run("convert", "1", "W", "lm", "--spectrum", "band:360nm:830nm", "--range",
               "450nm:650nm").stderr  # fmt: skip
    assert f"450-650 nm has {100 * share:.3g} % of them" in said
    assert f"which is {683.002 * inside / 200:.6g} lm/W of its watts" in said
    assert "lumens" not in run("convert", "1", "W", "lm", "--spectrum", "D65").stderr


@pytest.mark.parametrize(
    ("source", "name", "reason"),
    [
        ("gaussian:530nm,30nm", "cct", "the CIE's limit is 0.05"),
        ("gaussian:470nm,150nm", "duv", "the light is bluer than any black body"),
        ("blackbody:1e5K", "cri", "CIE daylight, which ends at 25000 K"),
        ("line:2um", "cct", "this spectrum is invisible"),
        ("line:2um", "x", "this spectrum is invisible"),
        ("line:555nm", "fwhm", "a line has no width"),
        ("band:500nm:600nm", "fwhm", "the data end above half"),
        ("band:800nm:900nm", "lux-per-ppfd", "no photons"),
        ("line:2um", "sp-ratio", "this spectrum is invisible"),
        ("D65", "irradiance", "the spectrum is relative"),
        ("D65", "illuminance", "the spectrum is relative"),
    ],
)
def test_an_absent_result_has_a_reason(source, name, reason):
    done = run("spectrum", source, "-g", name)
    assert (done.returncode, done.stdout) == (2, "")
    assert reason in done.stderr


def test_a_colour_far_from_its_reference_is_rendered_with_a_note():
    # CIE 13.3-1995 wants at most 5.4e-3 in (u, v); the low-pressure sodium lamp has more
    assert "CIE 13.3 is for up to 0.0054" in run("spectrum", "LPS").stderr
    assert "CIE 13.3" not in run("spectrum", "HP1").stderr


@pytest.mark.parametrize("nanometres", ["670", "670.5", "671"])
def test_a_deep_red_line_has_no_colour_rendering_index(nanometres):
    """The adaptation of CIE 13.3-1995 divides by c = (4 - u - 10 v) / v, which is 0 here."""
    done = call(["spectrum", f"line:{nanometres}nm", "-q", "-g", "cri"])
    assert done.status == 2
    assert "adaptation of CIE 13.3" in done.error.message
    assert call(["spectrum", f"line:{nanometres}nm", "-q", "-g", "cct"]).status == 0


def test_colour_quality_is_calculated_on_request():
    # R9 23.8, R_f 85.32 and R_g 97.86 of LED-B3: see tests/spectra/test_rendition.py
    done = run("spectrum", "LED-B3", "-n", "-g", "r9", "-g", "rf", "-g", "rg", "-g", "ssi")
    r9, fidelity, gamut, _ = map(float, done.stdout.split())
    assert (r9, fidelity, gamut) == pytest.approx((23.8, 85.32, 97.86), abs=0.04)
    assert "TM-30" in done.stderr
    assert "TM-30" not in run("spectrum", "LED-B3").stderr


@pytest.mark.parametrize(("spelled", "name"), [("R9", "r9"), ("R_f", "rf"), ("R_f,h1", "rf-h1")])
def test_letters_of_colour_quality_are_its_names(spelled, name):
    shown = [run("spectrum", "FL2", "-n", "-g", text).stdout for text in (spelled, name)]
    assert shown[0] == shown[1] != ""


def test_a_sheet_has_no_results_on_request():
    names = {line.split("\t")[0] for line in run("spectrum", "FL2").stdout.splitlines()}
    assert not names & {*PAGE.on_request}
    assert "cri" in names


def test_a_misspelt_result_on_request_is_suggested():
    error = call(["spectrum", "FL2", "-g", "rff"]).error
    assert "unknown result 'rff'" in error.message
    assert "rf" in run("spectrum", "FL2", "-g", "rff").stderr.split()


def test_a_reference_is_for_the_similarity_alone():
    assert run("spectrum", "C", "-n", "-g", "ssi", "--reference", "D65").stdout == "94\n"
    error = call(["spectrum", "C", "--reference", "D65"]).error
    assert "does not apply without a spectral similarity index" in error.message


def test_data_that_do_not_reach_the_ends_are_noted(tmp_path):
    measured = tmp_path / "flat.csv"
    rows = [f"{nm},1" for nm in range(400, 705, 5)]
    measured.write_text("\n".join(["wavelength [nm],W/m2/nm", *rows, ""]), encoding="utf-8")
    short = run("spectrum", str(measured), "-g", "rf", "-g", "ssi").stderr
    assert "cover 400-700 nm; beyond, they are taken as 0" in short
    assert short.count("taken as 0") == 2  # of the rendition, and of the similarity
    # light behind a filter has no gaps
    filtered = run("spectrum", "D65", "--range", "420nm:700nm", "-g", "rf", "-g", "ssi").stderr
    assert "taken as 0" not in filtered


def test_indices_of_coarse_data_have_a_note(tmp_path):
    measured = tmp_path / "coarse.csv"
    rows = [f"{nm},1" for nm in range(380, 800, 20)]
    measured.write_text("\n".join(["wavelength [nm],W/m2/nm", *rows, ""]), encoding="utf-8")
    assert "20 nm apart" in run("spectrum", str(measured), "-g", "r9").stderr
    assert "apart" not in run("spectrum", "FL2", "-g", "r9").stderr


def test_a_result_with_remarks_is_copied():
    lamp = radcalc.spectrum("LED-B3", reference="D65")
    assert pickle.loads(pickle.dumps(lamp)).assumptions == lamp.assumptions


def test_colours_of_one_wavelength_are_named():
    # 589.3 nm is yellow in ISO 21348
    done = run("spectrum", "line:589.3nm", "-g", "dominant-wavelength", "-g", "srgb-blue")
    assert done.stdout.split() == ["589.3", "0"]
    assert "the hue is yellow" in done.stderr
    assert "in sRGB is #ff" in done.stderr
    purple = ["spectrum", "LED-RGB1", "--range", "600nm:780nm", "-g", "complementary-wavelength"]
    assert "has a dominant wavelength" in call(purple).error.message


def test_colour_quality_of_python_is_calculated_at_the_first_access():
    lamp = radcalc.spectrum("LED-B3")
    assert lamp.r9.magnitude == pytest.approx(23.8, abs=0.04)
    assert lamp["rf-h1"].magnitude == pytest.approx(83.42, abs=0.01)  # colour-science
    assert "rf" in dir(lamp)
    assert "rf" not in [*lamp]
    assert not hasattr(radcalc.spectrum("line:532nm"), "rf")
    assert radcalc.spectrum("C", reference="D65").ssi.magnitude == 94


def test_absent_results_of_several_spectra_are_noted_with_their_names():
    values = [absent("irradiance", "it is relative", "another")]
    for case in ("lamp.csv", "sun.csv"):
        with pytest.raises(RadcalcError) as caught:
            pick(values, "irradiance", case)
        assert caught.value.message == f"{case}: there is no irradiance: it is relative"
        with pytest.raises(RadcalcError, match=rf"{case}: unknown result 'lux'"):
            pick(values, "lux", case)


def test_a_range_of_one_wavelength_is_refused():
    error = call(["spectrum", "D65", "--range", "400nm:0.4um"]).error
    assert "is a single wavelength" in error.message


@pytest.mark.parametrize(
    ("name", "label", "way"),
    [
        ("ppfd", "photon irradiance", "-g photon-efficacy"),
        ("photon-irradiance", "photon irradiance", "-g photon-efficacy"),
        ("osvětlenost", "illuminance", "-g luminous-efficacy"),
    ],
)
def test_another_name_of_an_absent_result_gives_its_reason(name, label, way, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text("nm,value\n400,1\n500,2\n600,2\n700,1\n")
    done = run("spectrum", str(path), "-g", name)
    assert f"there is no {label}: the spectrum is relative" in done.stderr
    assert way in done.stderr


def test_the_colour_rendering_of_a_red_light_has_a_note():
    assert (
        "note: cri: a light of 900 K is red"
        in run("spectrum", "blackbody:900K", "-g", "cri").stderr
    )
    assert "is red" not in run("spectrum", "blackbody:1900K", "-g", "cri").stderr
