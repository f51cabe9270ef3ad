"""Files of meters, made here from descriptions of their formats.

UPRtek and LI-COR: one figure per row, a tab, then from 380nm; Sekonic: `Spectral Data 380[nm],`
in steps of 5 nm and again of 1 nm; OceanView, SpectraSuite and Jaz:
`>>>>>Begin Spectral Data<<<<<`; X-Rite: CGATS; IES TM-27-14: XML.
"""

import pytest

from radcalc.errors import RadcalcError
from radcalc.spectra.files import read_file
from radcalc.spectra.observers import OBSERVERS

KM = 683.002  # lm/W; h c N_A = 0.11962656564 J m/mol and Km of the SI
# 1 W/m2/nm from 380 nm to 780 nm is 400 W/m2; the illuminance is Km times 106.857 nm, the sum of
# the 1 nm table of V(lambda); from 400 nm to 700 nm there are 300 x 550e-9 / (h c N_A) mol/m2/s.
FLAT_LUX = KM * 106.857
FLAT_PPFD = 300 * 550e-9 / 0.11962656564 * 1e6
GRID = range(380, 781)


def uprtek(value, **figures):
    head = "".join(f"{name}\t{number}\n" for name, number in figures.items())
    rows = "".join(f"{nm}nm\t{value}\n" for nm in GRID)
    return f"Model Name\tCV600\nSerial Number\t19J00789\nTime\t2021/01/04_23:14:46\n{head}{rows}"


def sekonic(value, lux, steps=(5, 1)):
    rows = "\n".join(
        f"Spectral Data {nm}[nm],{value}" for step in steps for nm in range(380, 781, step)
    )
    return (
        "Date Saved,15/03/2021 3:44:14 p.m.\nTitle,BENCH_1_02°_3262K\n\nViewing Angle [°],2\n"
        f"Illuminance [lx],{lux}\nPPFD [umolm⁻²s⁻¹],{FLAT_PPFD:.1f}\nTLMF,---\n\n{rows}\n"
        "bin1,-0.29,1\n"
    )


def save(tmp_path, text, encoding="utf-8"):
    path = tmp_path / "meter.txt"
    path.write_bytes(text if isinstance(text, bytes) else text.encode(encoding))
    return str(path)


@pytest.mark.parametrize(
    ("value", "unit"),
    [("1", "W/m2/nm"), ("1000.0", "mW/m2/nm"), ("100", "uW/cm2/nm"), ("1000,0", "mW/m2/nm")],
)
def test_the_unit_of_a_meter_is_the_one_that_gives_its_illuminance(value, unit, tmp_path):
    table = read_file(save(tmp_path, uprtek(value, LUX=f"{FLAT_LUX:.6f}", IRR="400.0")))
    assert table.absolute == "irradiance"
    assert unit in table.described
    assert table.total() == pytest.approx(400, rel=1e-12)
    assert not table.notes


def test_photons_of_a_meter_are_distinguished_from_watts_by_its_illuminance(tmp_path):
    # 1 W/m2/nm at x nm is x 1e-9 / 0.11962656564 mol/m2/s/nm
    rows = "".join(f"{x}nm\t{x * 1e-3 / 0.11962656564:.9f}\n" for x in GRID)
    text = f"Model Name\tPG100N\nLUX\t{FLAT_LUX:.4f}\nPPFD\t{FLAT_PPFD:.4f}\n{rows}"
    table = read_file(save(tmp_path, text))
    assert "umol/m2/s/nm" in table.described
    assert table.total() == pytest.approx(400, rel=1e-6)
    assert not table.notes


def test_a_spectrum_that_contradicts_the_meters_figures_is_relative_with_a_note(tmp_path):
    table = read_file(save(tmp_path, uprtek("1", LUX="12345.0")))
    assert table.absolute == ""
    assert "relative watts" in table.described
    assert any("the meter measured 12345 lx" in note for note in table.notes)
    without = read_file(save(tmp_path, uprtek("1")))
    assert (without.absolute, without.notes) == ("", ())


def test_differences_from_other_figures_are_noted(tmp_path):
    lux = f"{FLAT_LUX:.3f}"
    table = read_file(save(tmp_path, uprtek("1", LUX=lux, PPFD="1500.0", CCT="3000", IRR="402.0")))
    said = " ".join(table.notes)
    assert "1500 umol/m2/s (ppfd)" in said
    assert "3000 K (cct)" in said
    assert "irradiance" not in said  # half a percent
    assert f"{FLAT_PPFD:.6g}" in said


def test_the_finer_of_two_tables_is_read(tmp_path):
    table = read_file(save(tmp_path, sekonic("1", f"{FLAT_LUX:.0f}")))
    assert (len(table.grid), table.absolute) == (401, "irradiance")
    assert list(table.notes) == ["of its 2 tables the one of 401 rows is used"]


def replaced(text, old, new):
    assert old in text
    return text.replace(old, new, 1)


DAMAGED = {
    "a row is missing": (replaced(uprtek(1), "450nm\t1\n", ""), "a step of 2 nm to 451 nm"),
    "a row is not a number": (
        replaced(uprtek(1), "450nm\t1\n", "450nm\tx\n"),
        "'x' is not a number",
    ),
    "a wavelength is damaged": (replaced(uprtek(1), "450nm", "4?0nm"), "a step of 2 nm to 451 nm"),
    "a value is missing": (replaced(uprtek(1), "450nm\t1", "450nm\t"), "a value is missing"),
    "a table is cut short": (
        sekonic("1", "73000").rpartition("Spectral Data 600")[0],
        "it ends at 599 nm, another table at 780 nm",
    ),
}


@pytest.mark.parametrize(("text", "message"), DAMAGED.values(), ids=DAMAGED.keys())
def test_a_damaged_file_of_a_meter_is_refused(text, message, tmp_path):
    with pytest.raises(RadcalcError) as caught:
        read_file(save(tmp_path, text))
    assert message in caught.value.message


@pytest.mark.parametrize(
    "form", ["{}nm,{}", "{}nm;{}", "{}nm\t{}", '"{}nm","{}"', '"{}nm,{}"', "{}nm,{},,"]
)
def test_a_delimiter_of_a_meter_is_not_a_decimal_comma(form, tmp_path):
    text = "".join(form.format(x, f"{x / 200:.2f}") + "\n" for x in (400, 500, 600))
    assert list(read_file(save(tmp_path, text)).values) == [2, 2.5, 3]
    quoted = form if ";" in form or "\t" in form else '{}nm,"{}"'
    text = "".join(quoted.format(x, f"{x / 200:.2f}") + "\n" for x in (400, 500, 600))
    assert list(read_file(save(tmp_path, text.replace(".", ","))).values) == [2, 2.5, 3]


@pytest.mark.parametrize("delimiter", [",", ";", "\t"])
def test_two_values_at_a_wavelength_of_a_meter_are_refused(delimiter, tmp_path):
    text = "".join(f"{x}nm,1,5\n".replace(",", delimiter) for x in (400, 500, 600))
    with pytest.raises(RadcalcError, match="line 1: 2 values at one wavelength"):
        read_file(save(tmp_path, text))


def test_a_meter_has_no_columns(tmp_path):
    with pytest.raises(RadcalcError, match="no columns to choose from"):
        read_file(save(tmp_path, uprtek(1)), "2")


OCEAN = (
    "Data from lamp_Irradiance_12-00-00.txt Node\n\nDate: Mon Nov 17 14:18:29 EST 2025\nUser: 3\n"
    "Spectrometer: USB4F03499\nIntegration Time (sec): 1.0E-1\nScans to average: 5\n"
    "XAxis mode: Wavelengths\nNumber of Pixels in Spectrum: 3\n>>>>>Begin Spectral Data<<<<<\n"
    "4.00E2\t1.0\n5.00E2\t3.0\n7.00E2\t2.0\n"
)
SUITE = (
    "SpectraSuite Irradiance File\n++++++++++++++++++++++++\nDark Spectrum Present: Yes\n"
    "Integration Time (usec): 20000 (USB4A00428)\nNumber of Pixels in Processed Spectrum: 3\n"
    ">>>>>Begin Processed Spectral Data<<<<<\n400.00\t1.000\n500.00\t3.000\n700.00\t2.000\n"
    ">>>>>End Processed Spectral Data<<<<<\n"
)
JAZ = (
    "Jaz Absolute Irradiance File\n++++++++++++\nFiber (micron): 7140\n"
    "Number of Pixels in Processed Spectrum: 3\n>>>>>Begin Processed Spectral Data<<<<<\n"
    "W\tD\tS\tP\n400.0\t9\t8\t1.0\n500.0\t9\t8\t3.0\n700.0\t9\t8\t2.0\n"
    ">>>>>End Processed Spectral Data<<<<<\n>>>>>Begin Calibration Data<<<<<\n4.3E-05\n"
)


@pytest.mark.parametrize("text", [OCEAN, SUITE, JAZ], ids=["OceanView", "SpectraSuite", "Jaz"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\n\r"])
@pytest.mark.parametrize("decimal", [".", ","])
def test_the_table_begins_after_its_mark(text, end, decimal, tmp_path):
    head, mark, table = text.partition("<<<<<\n")
    text = head + mark + table.replace(".", decimal)
    found = read_file(save(tmp_path, text.replace("\n", end)))
    assert list(found.grid) == [400, 500, 700]
    watts = 0.01 if "Jaz" in text else 1  # uW/cm2 to W/m2
    assert list(found.values) == pytest.approx([1 * watts, 3 * watts, 2 * watts], rel=1e-12)
    assert found.absolute == ("irradiance" if "Jaz" in text else "")
    assert any(note.startswith("the table begins in line") for note in found.notes)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("7.00E2\t2.0\n", "", "2 rows, but its own count of pixels is 3"),
        ("Spectrum: 3", f"Spectrum: {'9' * 5000}", "3 rows, but its own count of pixels is 9"),
        ("7.00E2\t2.0\n", "7.00E2\n", "1 column instead of 2"),
        ("XAxis mode: Wavelengths", "XAxis mode: Raman Shifts", "is not a wavelength"),
        ("lamp_Irr", "leaf_Reflection_Irr", "is a reflection, not light"),
        ("lamp_Irr", "leaf_Transmission__0__Irr", "is a transmission, not light"),
        ("_Irradiance", "", "the values may be counts of a detector"),
    ],
)
def test_an_incomplete_or_unsuitable_file_of_oceanview_is_refused(old, new, message, tmp_path):
    with pytest.raises(RadcalcError) as caught:
        read_file(save(tmp_path, replaced(OCEAN, old, new)))
    assert message in caught.value.message


def test_a_measurement_against_a_reference_is_refused(tmp_path):
    text = JAZ.replace("Jaz Absolute Irradiance", "Jaz Data").replace("D\tS", "D\tR\tS")
    text = text.replace("\t9\t", "\t9\t7\t")
    with pytest.raises(RadcalcError, match="transmittance or reflectance"):
        read_file(save(tmp_path, text))
    head = SUITE.replace("Dark Spectrum", "Reference Spectrum")
    assert any("a reference spectrum" in note for note in read_file(save(tmp_path, head)).notes)


SPDX = """<?xml version="1.0"?>
<IESTM2714 xmlns="iestm2714" version="1.0">
  <Header><Manufacturer>Unknown &amp; Sons</Manufacturer><Comments>at 25 C</Comments></Header>
  <SpectralDistribution>
    <SpectralQuantity>irradiance</SpectralQuantity>
    <BandwidthFWHM>Unknown</BandwidthFWHM>
    <SpectralData wavelength="400.0">1</SpectralData>
    <SpectralData wavelength="500.0">3</SpectralData>
    <SpectralData wavelength="700.0">2</SpectralData>
  </SpectralDistribution>
</IESTM2714>
"""


@pytest.mark.parametrize(
    ("old", "new", "absolute"),
    [
        (' xmlns="iestm2714"', "", "irradiance"),
        ('xmlns="iestm2714"', 'xmlns="http://www.ies.org/iestm2714"', "irradiance"),
        ("irradiance", "relative", ""),
        ("irradiance", " Flux ", "flux"),
        ("irradiance", "exitance", "exitance"),
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_tm27_is_read(old, new, absolute, encoding, tmp_path):
    table = read_file(save(tmp_path, replaced(SPDX, old, new), encoding))
    assert (list(table.grid), list(table.values)) == ([400, 500, 700], [1, 3, 2])
    assert table.absolute == absolute
    assert "TM-27" in table.described


@pytest.mark.parametrize("declared", ["UTF-16", "utf-16", "ISO-8859-1", "windows-1252", "UTF-8"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_the_encoding_of_tm27_is_taken_from_the_bytes_not_the_declaration(
    declared, encoding, tmp_path
):
    text = f'<?xml version="1.0" encoding="{declared}"?>\n' + SPDX[SPDX.index("<IES") :]
    assert list(read_file(save(tmp_path, text, encoding)).values) == [1, 3, 2]


def test_tm27_with_a_prefix_is_read(tmp_path):
    text = SPDX.replace("</", "</t:").replace("<Sp", "<t:Sp").replace("<IES", "<t:IES")
    text = text.replace("<H", "<t:H").replace("<M", "<t:M").replace("<C", "<t:C")
    text = text.replace("<B", "<t:B").replace("xmlns=", "xmlns:t=")
    assert list(read_file(save(tmp_path, text)).values) == [1, 3, 2]


BAD_SPDX = {
    "one row": (
        SPDX[SPDX.index('    <SpectralData wavelength="500') : SPDX.index("  </Sp")],
        "",
        "1 row of data is not a spectrum",
    ),
    "transmittance": ("irradiance", "transmittance", "the quantity is 'transmittance'"),
    "no quantity": ("<SpectralQuantity>irradiance</SpectralQuantity>", "", "a quantity is missing"),
    "no number": (">3<", ">x<", "line 8: 'x' is not a number"),
    "no value": (">3<", "><", "line 8: a value is missing"),
    "no wavelength": ('wavelength="500.0"', "", "line 8: a wavelength is missing"),
    "two of a spectrum": (
        "  </SpectralDistribution>",
        '  </SpectralDistribution><SpectralDistribution><SpectralData wavelength="600">1'
        "</SpectralData></SpectralDistribution>",
        "line 10: a second spectrum",
    ),
    "two quantities": ("<Band", "<SpectralQuantity>flux</SpectralQuantity><Band", "a second"),
    "other XML": ("IESTM2714 xmlns", "svg xmlns", "XML of 'svg'"),
    "cut short": ("</SpectralDistribution>\n</IESTM2714>", "", "not XML: no element found"),
    "a bomb": (
        '<?xml version="1.0"?>',
        '<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a "1"><!ENTITY b "&a;&a;">]>',
        "a document type declaration",
    ),
}


@pytest.mark.parametrize(("old", "new", "message"), BAD_SPDX.values(), ids=BAD_SPDX.keys())
def test_incomplete_or_unsuitable_xml_is_refused(old, new, message, tmp_path):
    with pytest.raises(RadcalcError) as caught:
        read_file(save(tmp_path, replaced(SPDX, old, new)))
    assert message in caught.value.message


@pytest.mark.parametrize("place", ["    <SpectralQ", "1</SpectralData>", "  <Header>"])
def test_blank_lines_in_tm27_are_read_quickly(place, tmp_path):
    """An algorithm quadratic in their number would take hours."""
    text = replaced(SPDX, place, "\n" * 1_000_000 + place)
    assert list(read_file(save(tmp_path, text)).values) == [1, 3, 2]


ARGYLL = (
    'SPECT  \n\nDESCRIPTOR "lamp"\nMEAS_TYPE "EMISSION"\nSPECTRAL_BANDS "3"\n'
    'SPECTRAL_START_NM "400.000000"\nSPECTRAL_NORM "1.000000"\n\nNUMBER_OF_FIELDS 3\n'
    "BEGIN_DATA_FORMAT\nSPEC_400 SPEC_500 SPEC_600 \nEND_DATA_FORMAT\n\nNUMBER_OF_SETS 1\n"
    "BEGIN_DATA\n1.0 3.0 2.0 \nEND_DATA\n"
)


def test_the_spectrum_of_an_argyll_file_is_read(tmp_path):
    table = read_file(save(tmp_path, ARGYLL))
    assert (list(table.grid), list(table.values)) == ([400, 500, 600], [1, 3, 2])
    for measured in ("TRANSMISSIVE", "REFLECTIVE", "SENSITIVITY"):
        with pytest.raises(RadcalcError, match="the file does not state that this is light"):
            read_file(save(tmp_path, ARGYLL.replace("EMISSION", measured)))


def test_the_norm_of_an_argyll_file_divides_its_values(tmp_path):
    """As in getval_lxspec of ArgyllCMS."""
    normed = replaced(ARGYLL, 'NORM "1.000000"', 'NORM "100.000000"')
    table = read_file(save(tmp_path, normed))
    assert list(table.values) == pytest.approx([0.01, 0.03, 0.02])
    assert table.notes[0] == "its values are divided by its SPECTRAL_NORM of 100"
    for bad in ("0.0", "-1", "nan", "x"):
        with pytest.raises(RadcalcError, match="SPECTRAL_NORM is"):
            read_file(save(tmp_path, replaced(ARGYLL, "1.000000", bad)))
    bands = range(400, 701, 10)
    even = (
        f'SPECT\nMEAS_TYPE "EMISSION"\nSPECTRAL_NORM "100.0"\nNUMBER_OF_FIELDS {len(bands)}\n'
        f"BEGIN_DATA_FORMAT\n{' '.join(f'SPEC_{nm}' for nm in bands)}\nEND_DATA_FORMAT\n"
        f"NUMBER_OF_SETS 1\nBEGIN_DATA\n{'50.0 ' * len(bands)}\nEND_DATA\n"
    )
    # the sum of CIE's V(lambda) from 400 to 700 nm in steps of 1 nm is 106.79
    lumens = read_file(save(tmp_path, even), unit="mW/m2/nm").lumens(OBSERVERS["photopic"])
    assert lumens == pytest.approx(683 * 0.5e-3 * 106.79, rel=2e-4)


def ccss(bands, start, end, titles):
    """Spectra of a display, as ccss.c of ArgyllCMS writes them: titles are rounded to 1 nm."""
    values = "\n".join(
        f"{row} " + " ".join(f"{row}.{k}" for k in range(len(titles))) for row in (1, 2)
    )
    columns = " ".join(f"SPEC_{nm}" for nm in titles)
    return (
        f'CCSS   \n\nDESCRIPTOR "x"\nDISPLAY "y"\nSPECTRAL_BANDS "{bands}"\n'
        f'SPECTRAL_START_NM "{start}"\nSPECTRAL_END_NM "{end}"\n\n'
        f"NUMBER_OF_FIELDS {1 + len(titles)}\n"
        f"BEGIN_DATA_FORMAT\nSAMPLE_ID {columns}\nEND_DATA_FORMAT\n\nNUMBER_OF_SETS 2\n"
        f"BEGIN_DATA\n{values}\nEND_DATA\n"
    )


def test_a_ccss_has_light_at_exact_wavelengths(tmp_path):
    """From 350 to 740 nm in 118 bands the step is 10/3 nm; titles: ref/CRT.ccss of ArgyllCMS."""
    path = save(tmp_path, ccss(4, "350.000000", "360.000000", [350, 353, 357, 360]))
    with pytest.raises(RadcalcError, match="there are 2 samples"):
        read_file(path)
    table = read_file(path, "2")
    assert list(table.grid) == pytest.approx([350, 353 + 1 / 3, 356 + 2 / 3, 360], abs=1e-6)
    assert list(table.values) == [2.0, 2.1, 2.2, 2.3]
    assert "relative watts" in table.described
    for bands, start, titles in (
        (5, "350.0", [350, 353, 357, 360]),
        (1, "350.0", [350, 353, 357, 360]),
        (4, "340.0", [350, 353, 357, 360]),
        (4, "350.0", [350, 354, 357, 360]),
    ):
        with pytest.raises(RadcalcError, match="do not agree with SPECTRAL_BANDS"):
            read_file(save(tmp_path, ccss(bands, start, "360.0", titles)), "2")


CGATS = (
    'LGOROWLENGTH\t10\nCREATED\t"11/14/2014"  # Time: 16:45\nINSTRUMENTATION\t"i1Pro"\n'
    'MEASUREMENT_SOURCE\t"MeasurementCondition=Emission\tFilter=No"\nNUMBER_OF_FIELDS\t5\n'
    "BEGIN_DATA_FORMAT\nSampleID\tSAMPLE_NAME\tnm400\tnm500\tnm700\nEND_DATA_FORMAT\n"
    "NUMBER_OF_SETS\t2\nBEGIN_DATA\n1\twarm\t1\t3\t2\n2\tcold\t4\t6\t5\nEND_DATA\n"
)


def test_a_sample_of_cgats_is_chosen_by_name(tmp_path):
    assert list(read_file(save(tmp_path, CGATS), "cold").values) == [4, 6, 5]
    alone = replaced(CGATS, "2\tcold\t4\t6\t5\n", "").replace("SETS\t2", "SETS\t1")
    table = read_file(save(tmp_path, alone))
    assert (list(table.grid), list(table.values)) == ([400, 500, 700], [1, 3, 2])
    assert "relative watts" in table.described


@pytest.mark.parametrize(
    ("old", "new", "column", "message"),
    [
        ("Emission", "Reflection", "cold", "it may be a reflectance of samples"),
        ("Emission", "Emission", "", "there are 2 samples"),
        ("Emission", "Emission", "hot", "unknown sample 'hot'"),
        ("\tcold\t", "\twarm\t", "warm", "2 samples are named 'warm'"),
        ("2\tcold\t4\t6\t5\n", "", "warm", "1 rows, but NUMBER_OF_SETS is 2"),
        ("\t4\t6\t5", "\t4\t6", "warm", "4 columns instead of 5"),
        ("END_DATA\n", "", "warm", "0 times END_DATA"),
        ("nm400\tnm500\tnm700", "a\tb\tc", "warm", "no columns of wavelengths"),
    ],
)
def test_an_incomplete_or_unsuitable_file_of_cgats_is_refused(old, new, column, message, tmp_path):
    with pytest.raises(RadcalcError) as caught:
        read_file(save(tmp_path, replaced(CGATS, old, new)), column)
    assert message in caught.value.message
    assert caught.value.hint
