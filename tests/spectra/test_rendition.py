"""Colour rendition and similarity, compared with spreadsheets of CIE and IES, and programs."""

import warnings

import pytest
from conftest import run

from radcalc.spectra.colorimetry import Undefined, load_colour, reference_of, rendition, similarity
from radcalc.spectra.data.sources import SOURCES
from radcalc.spectra.sources import spectrum
from radcalc.spectra.spectrum import Table

# R_f and R_g by luxpy 1.12.5 (iesrf-tm30-20), an implementation of its own, of the same tables
OF_LUXPY = {
    "FL1": (80.64, 89.83), "FL2": (70.12, 86.42), "FL4": (56.70, 83.49), "FL7": (91.47, 98.90),
    "FL8": (95.46, 101.67), "FL11": (80.04, 101.06), "FL12": (77.55, 102.41),
    "HP1": (34.19, 53.97), "LED-B1": (84.08, 96.15), "LED-B3": (85.32, 97.86),
    "LED-B5": (79.47, 94.15), "LED-RGB1": (71.00, 107.01), "LED-V1": (87.34, 101.93),
    "A": (100.0, 100.0), "D65": (100.0, 100.0),
}  # fmt: skip


def test_every_named_spectrum_is_rendered_as_by_colour_science():
    colour = load_colour()
    groups = colour.SDS_ILLUMINANTS, colour.colorimetry.SDS_LIGHT_SOURCES
    compared = 0
    for name in SOURCES:
        own, table = spectrum(name), next(group[name] for group in groups if name in group)
        if table.shape.interval != 5 or [*own.values] != pytest.approx([*table.values]):
            continue  # coarser, or another table than colour-science's: A and the D series
        rendered = rendition(own)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            expected = colour.quality.colour_fidelity_index_ANSIIESTM3018(table.copy(), True)
        assert (rendered.fidelity, rendered.gamut) == pytest.approx((expected.R_f, expected.R_g))
        assert rendered.local_fidelity == pytest.approx(list(expected.R_fs))
        assert [100 * x for x in rendered.chroma_shifts] == pytest.approx(list(expected.R_cs))
        assert rendered.hue_shifts == pytest.approx(list(expected.R_hs))
        compared += 1
    assert compared > 95


@pytest.mark.parametrize(("name", "expected"), OF_LUXPY.items(), ids=str)
def test_fidelity_and_gamut_agree_with_another_program(name, expected):
    rendered = rendition(spectrum(name))
    assert (rendered.fidelity, rendered.gamut) == pytest.approx(expected, abs=0.006)


def test_the_spreadsheets_of_the_cie_and_the_ies():
    # as the tests of colour-science quote them: R_f of FL1 and FL2 by that of CIE 224
    assert rendition(spectrum("FL1")).fidelity == pytest.approx(80.6, abs=0.1)
    fl2 = rendition(spectrum("FL2"))
    assert fl2.fidelity == pytest.approx(70.1, abs=0.1)
    # all of FL2 by that of TM-30-18
    assert fl2.gamut == pytest.approx(86, abs=0.5)
    fidelity = [60, 61, 53, 68, 80, 88, 77, 73, 76, 62, 70, 77, 81, 71, 64, 65]
    assert fl2.local_fidelity == pytest.approx(fidelity, abs=0.75)
    chroma = [-25, -18, -9, 5, 11, 4, -8, -15, -17, -15, -4, 5, 11, 7, -6, -16]
    assert [100 * shift for shift in fl2.chroma_shifts] == pytest.approx(chroma, abs=0.75)
    hues = [-0.02, 0.14, 0.24, 0.20, 0.09, -0.07, -0.12, -0.08, 0.01, 0.17, 0.19, 0.11, -0.08]
    hues += [-0.15, -0.26, -0.17]
    assert fl2.hue_shifts == pytest.approx(hues, abs=0.01)
    # the Lighting Toolbox of F. Rudawski has 84.081 for LED-B1, in its documentation of ciecfi
    assert rendition(spectrum("LED-B1")).fidelity == pytest.approx(84.081, abs=0.01)


def test_a_finer_table_of_the_same_light_has_nearly_the_same_rendition():
    lamp = spectrum("LED-B3")
    assert isinstance(lamp, Table)
    fine = [380 + k / 2 for k in range(801)]
    between = Table("fine", fine, [lamp.power((nm - 0.25, nm + 0.25)) for nm in fine])
    for table in (between, Table("1 nm", fine[::2], between.values[::2])):
        # samples of 5 nm and of 1 nm differ by about 0.1, as in the CIE's own sheet
        assert rendition(table).fidelity == pytest.approx(rendition(lamp).fidelity, abs=0.1)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("line:532nm", "limit is 0.05"),
        ("blackbody:900K", "900 K, is not within 1000 K to 25000 K"),
        ("blackbody:30000K", "is not within"),
    ],
)
def test_lights_without_a_rendition_have_a_reason(text, why):
    with pytest.raises(Undefined, match=why):
        rendition(spectrum(text))


def test_coarse_data_have_no_rendition():
    coarse = Table("coarse", [380.0 + 10 * k for k in range(41)], [1.0] * 41)
    with pytest.raises(Undefined, match="every 5 nm, and these have 10 nm"):
        rendition(coarse)


def test_the_similarity_agrees_with_published_indices():
    # colour-science's tests: C and D65 94
    assert similarity(spectrum("C"), spectrum("D65")) == 94
    # and light-emitting diodes of its model against one of 535 nm
    diode = load_colour().colorimetry.sd_single_led
    made = {nm: diode(nm, half_spectral_width=width) for nm, width in LEDS}
    tables = {nm: Table(f"{nm} nm", sd.wavelengths, sd.values) for nm, sd in made.items()}
    others = [520, 540, 560]
    assert [similarity(tables[nm], tables[535]) for nm in others] == [52, 82, 18]
    assert [similarity(tables[535], tables[nm]) for nm in others] == [50, 84, 20]


LEDS = ((520, 45), (540, 55), (560, 50), (535, 48))


@pytest.mark.parametrize("text", ["blackbody:2000K", "blackbody:3999K", "daylight:5600K"])
def test_the_usual_reference_of_a_thermal_light_or_daylight_is_its_like(text):
    # Academy S-2018-001: a black body below 4000 K, then CIE daylight
    own = spectrum(text)
    assert similarity(own, reference_of(own)) == 100


def test_the_reference_changes_at_4000_k():
    assert "daylight" not in reference_of(spectrum("blackbody:3990K")).label
    assert "daylight" in reference_of(spectrum("blackbody:4010K")).label


def test_light_outside_of_the_bands_has_no_similarity():
    with pytest.raises(Undefined, match="no power from 375 nm to 675 nm"):
        similarity(spectrum("line:800nm"), spectrum("D65"))


@pytest.mark.parametrize(
    ("spectrum", "is_mixed", "changes"),
    [
        ("blackbody:3990K", False, False),
        ("blackbody:4500K", True, False),  # R_f is 98.4 of a perfect black body: CIE 224
        ("blackbody:4960K", True, True),
        ("blackbody:5040K", False, True),  # R_a falls from 100 to 98.6 here: CIE 13.3
        ("blackbody:5060K", False, False),
    ],
)
def test_a_change_of_the_reference_is_noted(spectrum, is_mixed, changes):
    notes = run("spectrum", spectrum, "-g", "rf,cri").stderr
    assert ("the reference is a mix of a black body and CIE daylight" in notes) == is_mixed
    assert ("cri: at 5000 K the reference changes" in notes) == changes
    assert "note" not in run("spectrum", spectrum, "-g", "x").stderr
