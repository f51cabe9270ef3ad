"""Files of spectra in common forms, and with common mistakes."""

import codecs
import subprocess

import numpy as np
import pytest
from conftest import entry_point, run

from radcalc.errors import RadcalcError
from radcalc.spectra.files import read_file
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.spectrum import WHOLE, Table

PHOTOPIC = OBSERVERS["photopic"]

FILES = {
    "commas": "400,1\n500,3\n700,2\n",
    "blanks": "400 1\n500   3\n700 2\n",
    "tabs": "400\t1\n500\t3\n700\t2\n",
    "semicolons and decimal commas": "400,0;1,0\n500,0;3,0\n700,0;2,0\n",
    "decimal commas from the second row on": "400;1\n500;3,0\n700;2,0\n",
    "commas that others tell from thousands": "400;1,000\n500;3,00\n700;2,000\n",
    "a header": "wavelength,value\n400,1\n500,3\n700,2\n",
    "comments and blank lines": "# a lamp\n\n400 1\n500 3\n# more\n700 2\n",
    "a byte order mark and CRLF": "\ufeff400,1\r\n500,3\r\n700,2\r\n",
    "a title in a comment": "# wl I\n400 1\n500 3\n700 2\n",
    "angstroms by the header": "wavelength (angstrom),value\n4000,1\n5000,3\n7000,2\n",
    "metres": "lambda (m) I\n4e-7 1\n5e-7 3\n7e-7 2\n",
    "falling": "700 2\n500 3\n400 1\n",
    "out of order": "500 3\n400 1\n700 2\n",
    "quotes": '"400","1"\n"500","3"\n"700","2"\n',
}


@pytest.mark.parametrize("text", FILES.values(), ids=FILES.keys())
def test_a_spectrum_is_read_in_many_forms(text, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_bytes(text.encode())
    is_titled = text[1:2].isalpha() or "wl" in text
    table = read_file(str(path), axis="" if is_titled else "nm")
    assert list(table.grid) == pytest.approx([400, 500, 700])
    assert list(table.values) == [1, 3, 2]
    assert table.power(table.limits) == pytest.approx(100 * 2 + 200 * 2.5)
    if not is_titled:
        with pytest.raises(RadcalcError, match="no title says that the numbers from 400 to 700"):
            read_file(str(path))


# Numbers, the unit of their wavelengths, and the first in nm (1 um = 1000 nm, 1 angstrom = 0.1 nm).
UNITS = [("0.4 1\n0.7 2\n", "um"), ("4000 1\n7000 2\n", "angstrom"), ("400 1\n700 2\n", "nm")]


@pytest.mark.parametrize(("rows", "unit"), UNITS)
@pytest.mark.parametrize("head", ["", "x y\n", "wavelength y\n"])
def test_the_unit_of_wavelengths_is_never_chosen_by_their_size(head, rows, unit, tmp_path):
    path = tmp_path / "lamp.txt"
    path.write_text(head + rows)
    assert list(read_file(str(path), axis=unit).grid) == pytest.approx([400, 700])
    if "wave" in head and unit == "nm":
        said = "the wavelengths are taken in nanometres: their title has no unit"
        assert said in read_file(str(path)).notes
        return
    done = run("convert", "100", "lx", "W/m2", "--spectrum", str(path), "-q")
    assert (done.returncode, done.stdout) == (2, "")
    call, answer = done.stderr.partition("try: radcalc ")[2].split("\n")[:2]
    assert call == f"convert 100 lx W/m2 --spectrum {unit}:{path} -q"
    assert answer.split()[0] == f"{float(run(*call.split(), '-n').stdout):.6g}"


def test_a_given_unit_of_wavelengths_wins_over_the_declared_one_but_not_over_another_axis(tmp_path):
    path = tmp_path / "lamp.txt"
    path.write_text("wavelength (um),y\n400,1\n700,2\n")
    said = "the wavelengths are in nm, as given, though um is declared"
    assert said in read_file(str(path), axis="nm").notes
    path.write_text("frequency (THz),y\n400,1\n700,2\n")
    with pytest.raises(RadcalcError, match="'frequency \\(THz\\)' is not a wavelength"):
        read_file(str(path), axis="nm")


def test_a_column_is_chosen_by_name_or_number(tmp_path):
    path = tmp_path / "lamps.csv"
    path.write_text("nm,red,blue\n400,1,9\n700,2,8\n", encoding="utf-8")
    assert list(read_file(str(path), "blue").values) == [9, 8]
    assert list(read_file(str(path), "2").values) == [1, 2]
    with pytest.raises(RadcalcError, match="2 columns of values"):
        read_file(str(path))


@pytest.mark.parametrize("column", ["Absolute Irradiance", "absolute irradiance", "3"])
def test_a_column_is_chosen_by_its_title_without_brackets(column, tmp_path):
    path = tmp_path / "lamp.txt"
    head = "Wave;Sample;Absolute Irradiance\n[nm];[counts];[µWatt/cm²/nm]\n"
    path.write_text(f"{head}400;7;1\n700;8;2\n", encoding="utf-8")
    table = read_file(str(path), column)
    assert list(table.values) == pytest.approx([0.01, 0.02])
    with pytest.raises(RadcalcError, match="not a calibrated"):
        read_file(str(path), "sample")


def test_a_unit_in_the_header_makes_a_spectrum_absolute(tmp_path):
    path = tmp_path / "sun.csv"
    path.write_text("wavelength (nm),E (W/m2/um)\n400,1000\n700,1000\n", encoding="utf-8")
    table = read_file(str(path))
    assert table.absolute == "irradiance"
    assert table.power(table.limits) == pytest.approx(300)  # 1 W/m2/nm over 300 nm


ENCODED = "Wellenlänge;Bestrahlungsstärke\r\n[nm];[µW/cm²/nm]\r\n400;1,5\r\n500;3,25\r\n700;2\r\n"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-be", "latin-1"])
def test_text_is_read_in_any_usual_encoding(encoding, tmp_path):
    mark = codecs.BOM_UTF16_BE if encoding == "utf-16-be" else b""
    path = tmp_path / "lamp.csv"
    path.write_bytes(mark + ENCODED.encode(encoding))
    table = read_file(str(path))
    assert table.absolute == "irradiance"
    assert list(table.values) == pytest.approx([0.015, 0.0325, 0.02], rel=1e-12)  # W/m2
    assert any("Latin-1" in note for note in table.notes) == (encoding == "latin-1")


@pytest.mark.parametrize("cut", [1, 3, 501])
def test_truncated_text_in_utf16_is_refused(cut, tmp_path):
    path = tmp_path / "lamp.csv"
    text = "\n".join(["nm,x", *(f"{k},1" for k in range(400, 701))])
    path.write_bytes(text.encode("utf-16")[:-cut])
    with pytest.raises(RadcalcError, match="not UTF-16"):
        read_file(str(path))


HEADED = {
    "titles and units": "wavelength,irradiance\nnm,W/m2/nm\n",
    "units in brackets below titles": "Wave ;Sample\n[nm] ;[W/m2/nm]\n\n",
    "a title above": "Reference spectra v. 2.9.2,,,\nWvlgth nm,Global  W*m-2*nm-1\n",
    "a preamble": "lamp 7 at 2.9 m\n3 scans of 100 ms were averaged\nGain\t4\nnm,E [W/m2/nm]\n",
    "a preamble with the unit": "Title: bench 2\nUnits: W/m2/nm\nPower: 350\nwavelength,value\n",
    "a unit in brackets before": "Irradiance [W/m2/nm],\nName,,\n[nm],\n",
    "a unit in a comment": "# spectral irradiance in W/m2/nm\nwavelength,value\n",
    "quotes": '"wavelength (nm)","E, on the bench (W/m2/nm)"\n',
    "a prefix with a name": "wavelength,E [mWatt/m2/nm]\n",
}


@pytest.mark.parametrize("head", HEADED.values(), ids=HEADED.keys())
@pytest.mark.parametrize("delimiter", [",", ";", "\t"])
@pytest.mark.parametrize("tail", ["", "{}", "{}{}"])
def test_lines_before_a_table_are_not_part_of_it(head, delimiter, tail, tmp_path):
    rows = "".join(f"{x},{y}{tail}\n" for x, y in ((400, 1), (500, 3), (700, 2)))
    tail = tail.replace("{}", ",")
    text = head + rows.replace("{}", ",")
    if '"' not in head and "E, " not in head:
        text = text.replace(",", delimiter) if ";" not in head else text.replace(",", ";")
    path = tmp_path / "lamp.csv"
    path.write_text(text, encoding="utf-8")
    table = read_file(str(path))
    factor = 1e-3 if "mWatt" in head else 1
    assert list(table.values) == pytest.approx([factor, 3 * factor, 2 * factor])
    assert table.absolute == "irradiance"


@pytest.mark.parametrize(
    ("head", "message"),
    [
        ("Irradiance [umol/m2/s/nm]\nMode: W/m2/nm\nnm,x\n", "several units of light"),
        ("REM: SUN (QNTM)\nnm,x\n", "may mean that the values are photons"),
        ("PPFD: 12\nnm,x\n", "may mean that the values are photons"),
        ("# photon flux\nnm,x\n", "may mean that the values are photons"),
        ("Y Units: Reflectance (percent)\nnm,x\n", "is not light"),
        ("Leaf 7\nTransmittance\nnm,x\n", "is not light"),
        ("Absorbance of leaf 7\n", "'Absorbance of leaf 7' is not light"),
        ("Units: 1e-3 W/m2/nm\nnm,x\n", "scales its values"),
        ("Units: W/m2/nm\nnm,photons\n", "the title has photons, the lines before it watts"),
        ("Pixel,Wavelength\n0,1\n", "there is no column of values"),
    ],
)
def test_lines_before_a_table_are_taken_into_account(head, message, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{head}400,1\n500,3\n700,2\n", encoding="utf-8")
    with pytest.raises(RadcalcError) as caught:
        read_file(str(path))
    assert message in caught.value.message


@pytest.mark.parametrize(
    ("head", "message"),
    [
        ("wavelength of the leaf", "4 titles for 2 columns"),
        ("nm absorbance of it", "4 titles for 2 columns"),
        ("reflectance after cleaning", "is not light"),
        ("flux of photons per nm", "may mean that the values are photons"),
    ],
)
def test_titles_between_blanks_are_not_skipped_as_text(head, message, tmp_path):
    path = tmp_path / "lamp.txt"
    path.write_text(f"{head}\n400 1\n500 3\n700 2\n", encoding="utf-8")
    with pytest.raises(RadcalcError, match=message):
        read_file(str(path), axis="nm")


def test_a_line_before_the_table_declares_the_unit_of_wavelengths(tmp_path):
    path = tmp_path / "lamp.txt"
    path.write_text("X Units: Wavelength (angstrom)\nthe end\n4000 1\n7000 2\n", encoding="utf-8")
    assert list(read_file(str(path)).grid) == pytest.approx([400, 700])


@pytest.mark.parametrize("unit", ["umol/m2/s/nm", "[umol/m2/s/nm]", "in umol m-2 s-1 nm-1"])
@pytest.mark.parametrize("place", ["Values {}\nnm,x\n", "# values {}\nnm,x\n", "nm,E {}\n"])
def test_a_unit_of_photons_is_never_read_as_watts(unit, place, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{place.format(unit)}400,1\n500,1\n700,1\n", encoding="utf-8")
    table = read_file(str(path))
    assert table.absolute == "irradiance"
    # h c N_A / lambda in W per umol/s; the integral of 1/lambda is ln(700/400) = 0.5596157879
    assert table.total() == pytest.approx(119.62656564 * 0.5596157879, rel=1e-7)


def test_a_comma_and_a_blank_separate_columns(tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text("nm,x\n400, 1.5\n500,-0.001\n700, 2\n", encoding="utf-8")
    assert list(read_file(str(path)).values) == [1.5, -0.001, 2]


def test_a_row_that_may_be_missing_is_noted(tmp_path):
    path = tmp_path / "lamp.csv"
    rows = ["nm,x", *[f"{x},1" for x in range(400, 701, 10)]]
    path.write_text("\n".join(rows[:10] + rows[11:]), encoding="utf-8")
    said = "a step of 20 at 480, while most are 10: a row may be missing"
    assert said in read_file(str(path)).notes
    for steps in (rows, rows[:10], ["nm,x", "400,1", "410,1", "450,1", "700,1"]):
        path.write_text("\n".join(steps), encoding="utf-8")
        assert not any("missing" in note for note in read_file(str(path)).notes)


def test_noise_outside_the_visible_range_is_noted_with_its_share(tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text("nm,x\n200,0\n210,-5\n220,0\n400,10\n700,10\n", encoding="utf-8")
    # by hand: the triangle of -50 over 180 x 10 / 2 + 300 x 10 = 3900
    assert "kept as noise: 1.3 % of the watts" in " ".join(read_file(str(path)).notes)
    path.write_text("nm,x\n200,0\n210,-50\n220,0\n400,10\n700,10\n", encoding="utf-8")
    with pytest.raises(RadcalcError, match=r"12\.8 % of those above"):
        read_file(str(path))


BROKEN = {
    "nothing": ("", "no data"),
    "one row": ("nm x\n400 1\n", "1 row"),
    "one column": ("400\n500\n", "line 1: there is only one column"),
    "a missing value": ("400,1\n500,\n600,2\n", "line 2: a value is missing"),
    "a word": ("400,1\n500,x\n600,2\n", "line 2: 'x' is not a number"),
    "not a number": ("400,1\n500,nan\n600,2\n", "line 2: 'nan' is not a number"),
    "a short row": ("400 1\n500\n600 2\n", "line 2: 1 column"),
    "a long row": ("400 1\n500 2 3\n600 2\n", "line 2: 3 columns"),
    "twice the same": (
        "nm x\n400 1\n500 2\n\n400 2\n",
        "line 5: the wavelength 400 nm is also in line 2",
    ),
    # 1e300 W at 500 nm is 2.5e318 photons per second (h c = 1.986e-25 J m), too large for a float
    "a value beyond": ("nm x\n400 1e300\n500 1\n", "a greatest value of 1e+300"),
    "nearly darkness": ("nm x\n400 1e-320\n500 1e-320\n", "a greatest value of 9.99989e-321"),
    "a wavelength beyond": ("nm,E\n1e300,1\n1e301,2\n", "a wavelength of 1e+300 nm"),
    "darkness": ("nm x\n400 0\n500 0\n", "every value is 0"),
    "a negative wavelength": ("-400 1\n500 2\n", "a wavelength of -400"),
    "a frequency": ("frequency (THz),x\n400,1\n700,1\n", "is not a wavelength"),
    "an unknown length": ("wavelength (furlong),x\n400,1\n700,1\n", "unknown unit of wavelengths"),
    "wavelengths twice": ("E,nm,wavelength\n1,400,400\n1,700,700\n", "2 columns of wavelengths"),
    "per hertz": ("nm,K (W/m2/Hz)\n400,1\n700,1\n", "not power or photons per wavelength"),
    "not per wavelength": ("nm,umol/m2/s\n400,1\n700,1\n", "not power or photons per wavelength"),
    "lumens": ("nm,lm/nm\n400,1\n700,1\n", "not power or photons per wavelength"),
    "a luminous word": ("nm,illuminance\n400,1\n700,1\n", "not power or photons"),
    "absorbance": ("nm,absorbance\n400,1\n700,1\n", "'absorbance' is not a calibrated"),
    "a transmittance": ("nm,Transmittance (%)\n400,1\n700,1\n", "is not a calibrated"),
    "a reflectance": ("nm,reflectance_1\n400,1\n700,1\n", "is not a calibrated"),
    "a responsivity": ("nm,Responsivity (A/W)\n400,1\n700,1\n", "is not a calibrated"),
    "a responsivity in its unit": ("nm,R [A/W]\n400,1\n700,1\n", "A/W, not in a unit of light"),
    "a responsivity without brackets": ("nm,R A/W\n400,1\n700,1\n", "A/W, not in a unit of light"),
    "a responsivity in a comment": (
        "# R [mA/W]\nnm,R\n400,1\n700,1\n",
        "'R [mA/W]' is not light",
    ),
    "volts": ("nm,x [mV]\n400,1\n700,1\n", "mV, not in a unit of light"),
    "an unknown ratio": ("nm,E [J/m²·nm]\n400,1\n700,1\n", "unknown unit"),
    "an unknown unit of light": ("nm,E [mW/m²·nm]\n400,1\n700,1\n", "unknown unit"),
    "two units": ("nm,E [uW/cm2/nm] and [uW/m2/nm]\n400,1\n700,1\n", "has two units"),
    "an efficiency": ("nm,quantum efficiency\n400,1\n700,1\n", "is not a calibrated"),
    "counts": ("nm,Intensity (counts)\n400,1\n700,1\n", "is not a calibrated quantity of light"),
    "titles in a comment": ("# nm, absorbance\n400,1\n700,1\n", "'absorbance' is not a calibrated"),
    "very many columns": ("1," * 9999 + "1\n", "there are 9999 columns of values"),
    "an endless line": (b"0" * (1 << 23), "line 1: the line has more than 4194304 bytes"),
    "dark light": ("nm,x\n400,1\n550,-0.5\n700,1\n", "too far below 0 for noise"),
    "an underscore": ("400,1\n5_50,2\n700,1\n", "line 2: '5_50' is not a number"),
    "other digits": ("400,1\n٥٥٠,2\n700,1\n", "line 2"),
    "an unknown unit": ("lambda I\n4000 1\n7000 2\n", "the unit of the wavelengths"),
    "commas and points": (
        "400;0,5\n500;1.234\n600;2\n",
        "line 2: a decimal point, but line 1 has a decimal comma",
    ),
    "points and, far below, a comma": (
        "".join(f"{400 + k / 1e6:.6f};1\n" for k in range(100_000)) + "600;0,5\n",
        "line 100001: a decimal comma, but line 1 has a decimal point",
    ),
    "thousands or decimals": (
        "400;1,000\n500;2,000\n",
        "line 1: '1,000' is ambiguous: a thousand or a decimal",
    ),
    "a bad first row": ("nm,E\nx400,1\n500,2\n600,3\n", "line 2: 'x400' is not a number"),
    "a bad first row alone": ("x400;1\n500;2\n600;3\n", "line 1: 'x400' is not a number"),
    "a first row of a word": (
        "wavelength,E\nn/a,1\n500,2\n600,3\n",
        "line 2: 'n/a' is not a number",
    ),
    "a bad first row with another delimiter": (
        "wavelength (nm),E\nOVER;5\n500,2\n600,3\n",
        "line 2: 'OVER;5' is between the titles and the numbers",
    ),
    "a bad first row between tabs": (
        "wavelength\tE\nOVER 5\n500\t2\n600\t3\n",
        "line 2: 'OVER 5' is between the titles and the numbers",
    ),
    "two bad first rows": (
        "wavelength;E\nOVER,5\nx;7\n500;2\n600;3\n",
        "line 2: 'OVER,5' is between the titles and the numbers",
    ),
    "no first wavelength": ("wavelength,E\n,1\n500,2\n600,3\n", "line 2: a value is missing"),
    "a long title": ("nm,E " + "1" * 20_000 + "\n400,1\n500,2\n", "a title of 20002 characters"),
    "an end of lines that Latin-1 has not": (
        b"# \x85, \x0c, \x1c, \xff\n400 1\n500 x\n",
        "line 3: 'x' is not a number",
    ),
    "no text": (b"400 1\n500 \xff\n", "line 2: 'ÿ' is not a number"),
}


@pytest.mark.parametrize(("text", "message"), BROKEN.values(), ids=BROKEN.keys())
def test_an_error_in_a_file_is_refused_with_its_line(text, message, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(RadcalcError) as caught:
        read_file(str(path))
    assert message in caught.value.message
    assert caught.value.hint


RULED = {
    "a rule below the titles": "wavelength (nm),E [W/m2/nm]\n---,---\n500,2\n600,3\n",
    "units below the titles": "wavelength,E\nnm,W/m2/nm\n500,2\n600,3\n",
    "a preamble with the range": "wavelength range,380-780\nnm,E [W/m2/nm]\n500,2\n600,3\n",
    "a preamble with the unit": "wavelength unit,nm\nlambda,E [W/m2/nm]\n500,2\n600,3\n",
}


@pytest.mark.parametrize("text", RULED.values(), ids=RULED.keys())
def test_titles_are_used_whatever_lines_surround_them(text, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(text)
    assert read_file(str(path)).absolute == "irradiance"


@pytest.mark.parametrize("titles", ["wavelength,2700", "nm,2700", "WL,2700", "λ,2700"])
def test_a_title_may_be_a_number(titles, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(titles + "\n400,1\n500,2\n", encoding="utf-8")
    assert list(read_file(f"{path}", "2700").values) == [1, 2]


@pytest.mark.parametrize(
    "line", ["# " + "a:" * 500_000, "# " + "percent " * 200_000, "a " * 500_000, "(" * 1_000_000]
)
def test_long_lines_before_a_table_are_read_quickly(line, tmp_path):
    """An algorithm quadratic in the length of a line would take hours."""
    path = tmp_path / "lamp.csv"
    path.write_text(f"{line}\n" * 4 + "nm,E\n400,1\n500,2\n", encoding="utf-8")
    assert list(read_file(str(path)).values) == [1, 2]


PHOTONS = [  # titles, quantity of the values, part of the description
    ("nm,umol/m2/s/nm", "irradiance", "photons turned into watts"),
    ("nm,PPFD (umol/m2/s/nm)", "irradiance", "photons turned into watts"),
    ("nm,photon flux density umol m-2 s-1 nm-1", "irradiance", "photons turned into watts"),
    ("nm,flux [umol/s/nm]", "flux", "photons turned into watts"),
    ("# wavelength (nm), umol/m2/s/nm", "irradiance", "photons turned into watts"),
    ("nm,photons", "", "taken as relative photons per wavelength"),
    ("nm,PPFD", "", "taken as relative photons per wavelength"),
    ("nm,Photon_flux", "", "taken as relative photons per wavelength"),
]


@pytest.mark.parametrize(
    "text",
    [
        '"wavelength","E, umol/m2/s/nm"\n400,1\n500,3\n700,2\n',
        "nm,bench (2) [umol/m2/s/nm]\n400,1\n500,3\n700,2\n",
        "nm,[2] photons (umol/(m2 s nm))\n400,1\n500,3\n700,2\n",
        "# wavelength (nm), spectral distribution measured at the long optical bench "
        "(umol/m2/s/nm)\n400,1\n500,3\n700,2\n",
    ],
)
def test_a_unit_is_found_anywhere_in_a_title(text, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(text, encoding="utf-8")
    table = read_file(str(path))
    assert table.absolute == "irradiance"
    # h c N_A / lambda of CODATA 2018: 0.11962656 J m/mol, so 1 umol at 500 nm is 0.23925 J
    assert table.values[list(table.grid).index(500)] == pytest.approx(
        3 * 0.11962656e9 / 500 * 1e-6, rel=1e-7
    )


@pytest.mark.parametrize(
    "title", ["E_W/m2/nm", "E_W_m2_nm", "E / W/(m2 nm)", "E at 2 m in W/m2/nm", "W/m2/nm of A"]
)
def test_the_unit_in_a_title_is_read_as_in_a_stream(title, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"nm;{title}\n400;1\n500;3\n700;2\n", encoding="utf-8")
    table = read_file(str(path))
    assert (table.absolute, list(table.values)) == ("irradiance", [1, 3, 2])


@pytest.mark.parametrize("title", ["E_fc", "klx", "E_cd/m2", "E_W/m2", "P, dBW", "PAR_umol_m2_s"])
def test_a_unit_of_light_that_is_not_per_wavelength_is_refused_without_brackets(title, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"nm;{title}\n400;1\n500;3\n700;2\n", encoding="utf-8")
    with pytest.raises(RadcalcError, match="are not power or photons per wavelength"):
        read_file(str(path))


def test_titles_that_do_not_fit_the_columns_are_refused(tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text("nm,E,umol/m2/s/nm\n400,1\n500,3\n", encoding="utf-8")
    with pytest.raises(RadcalcError, match="3 titles for 2 columns"):
        read_file(str(path))


@pytest.mark.parametrize(("head", "absolute", "said"), PHOTONS)
def test_photons_are_converted_to_watts(head, absolute, said, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{head}\n400,1\n500,1\n700,1\n", encoding="utf-8")
    table = read_file(str(path))
    assert table.absolute == absolute
    assert said in table.described
    # h c N_A = 0.119626565... J m/mol in the SI: 1 umol at 400 nm is 0.299 J
    micromole = 0.11962656564 / 400e-9 * 1e-6
    assert table.values[0] == pytest.approx(micromole if absolute else 4.96611e-19, rel=1e-5)
    ratios = [
        value / table.values[0] * x / 400 for x, value in zip(table.grid, table.values, strict=True)
    ]
    assert ratios == pytest.approx([1] * len(ratios), rel=1e-12)


@pytest.mark.parametrize(("title", "efficacy"), [("photons", 274.950), ("W/m2/nm", 284.044)])
def test_the_quantity_of_a_table_is_straight_between_its_points(title, efficacy, tmp_path):
    """Photons turned into watts at the points alone gave 276.216 lm/W.

    The efficacies are trapezoids of V(lambda) of colour 0.4.7 over 3,000,001 points; radcalc sums
    over 1 nm.
    """
    path = tmp_path / "lamp.csv"
    path.write_text(f"nm,{title}\n400,1\n500,2\n600,2\n700,1\n", encoding="utf-8")
    done = run("spectrum", str(path), "-g", "luminous-efficacy", "-q", "-n")
    assert float(done.stdout) == pytest.approx(efficacy, rel=1e-5)


def test_the_photons_of_a_table_are_those_of_its_straight_lines(tmp_path):
    """Trapezoids by hand: 150 + 200 + 150 umol/m2/s."""
    path = tmp_path / "lamp.csv"
    rows = "400,1\n500,2\n600,2\n700,1\n"
    path.write_text(f"nm,SPFD [umol/m2/s/nm]\n{rows}", encoding="utf-8")
    done = run("spectrum", str(path), "-g", "photon-irradiance", "-q", "-n")
    assert float(done.stdout) == pytest.approx(500, rel=1e-7)


@pytest.mark.parametrize("head", ["nm,value", "nm,Relative intensity (%)", "nm,LED-B3 1", "# WL I"])
def test_relative_watts_are_an_assumption(head, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{head}\n400,1\n700,2\n", encoding="utf-8")
    table = read_file(str(path))
    assert (table.absolute, list(table.values)) == ("", [1, 2])
    assert table.described.endswith("its values taken as relative watts per wavelength")
    done = run("convert", "1", "W", "lm", "--spectrum", str(path))
    assert "assumed: " in done.stderr.split("relative watts")[0]


@pytest.mark.parametrize("head", ["nm,W/m2/nm", "nm,E uW/cm2/nm", "nm,I [W m-2 nm-1]"])
def test_a_unit_without_brackets_is_read(head, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{head}\n400,1\n700,2\n", encoding="utf-8")
    table = read_file(str(path))
    assert table.absolute == "irradiance"
    assert table.values[0] == pytest.approx(0.01 if "cm2" in head else 1, rel=1e-12)


def test_an_unknown_column_is_refused_with_the_nearest(tmp_path):
    path = tmp_path / "wide.csv"
    names = ",".join(f"column{k}" for k in range(5000))
    row = ",".join(["1"] * 5000)
    path.write_text(f"nm,{names}\n400,{row}\n700,{row}\n", encoding="utf-8")
    for column in ("", "colunm17"):
        with pytest.raises(RadcalcError) as caught:
            read_file(str(path), column)
        assert len(caught.value.hint) < 300
    assert "column17" in caught.value.hint


@pytest.mark.parametrize("words", ["spectrum -", "convert 1 W lm --spectrum -"])
def test_an_endless_or_closed_input_is_refused(words):
    quoted = f"'{entry_point()}' {words}"
    for source in ("</dev/zero", "<&-"):
        done = subprocess.run(["sh", "-c", f"{quoted} {source}"], capture_output=True, text=True)
        assert (done.returncode, done.stdout) == (2, ""), done.stderr
        assert "stdin" in done.stderr
    done = run(*words.replace("-", "/dev/zero", 1).split())
    assert (done.returncode, done.stdout) == (2, "")


def test_an_unreadable_file_is_an_error(tmp_path):
    with pytest.raises(RadcalcError, match="cannot read"):
        read_file(str(tmp_path))


@pytest.mark.parametrize(
    ("head", "scale"),
    [
        ("wavelength [um],x", 1e-3),
        ("Wavelength (Angstroms),x", 10),
        ("nm,x", 1),
        ("# wavelength in nm\nw,x", 1),
        ("# a wavelength sweep at 3 m\nwl,x", 1),
        ("# in metres\nwavelength in m,x", 1e-9),
        ("wavelength_nm,x", 1),
        ("wavelength (nanometers),x", 1),
        ("µm,x", 1e-3),
    ],
)
def test_the_unit_of_wavelengths_is_declared_in_many_ways(head, scale, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{head}\n{400 * scale},1\n{700 * scale},2\n", encoding="utf-8")
    table = read_file(str(path))
    assert list(table.grid) == pytest.approx([400, 700])
    assert any("wavelengths are" in note for note in table.notes)


def test_corrections_are_noted(tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text("wl I\n500 3\n450 -0.1\n600 2\n", encoding="utf-8")
    notes = " ".join(read_file(str(path)).notes)
    for said in ("sorted", "negative", "nanometres", "not all of the visible"):
        assert said in notes


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("extra", ["", "# half way", '"410.00001","2"', "\n\n"])
def test_a_file_of_many_blocks_is_read_line_by_line(extra, end, tmp_path, monkeypatch):
    monkeypatch.setattr("radcalc.files.BLOCK", 1 << 16)
    rows = [f"{400 + k / 1000:.3f},{1 + k % 7}" for k in range(20_000)]
    rows.insert(9000, extra.replace("\n", end))
    path = tmp_path / "long.csv"
    path.write_text(end.join(["nm,value", *rows]), encoding="utf-8", newline="")
    table = read_file(str(path))
    kept = 20_000 + ("410" in extra)
    assert len(table.grid) == kept
    assert table.grid[-1] == pytest.approx(419.999)
    bad = end.join(["nm,value", *rows, "600,x"])
    path.write_text(bad, encoding="utf-8", newline="")
    with pytest.raises(RadcalcError) as caught:
        read_file(str(path))
    number = 20_003 + extra.count("\n")
    assert f"line {number}:" in caught.value.message


def test_a_large_file_gives_the_same_as_a_small_one(tmp_path):
    grid = np.linspace(300, 1100, 20001)
    values = np.exp(-(((grid - 550) / 80) ** 2))
    path = tmp_path / "large.csv"
    header = "wavelength (nm),E (W/m2/nm)"
    np.savetxt(path, np.c_[grid, values], fmt="%.10g", delimiter=",", header=header, comments="")
    assert path.stat().st_size > 2**18
    large = read_file(str(path))
    small = Table("", grid.tolist(), values.tolist())
    assert large.absolute == "irradiance"
    for limits in (WHOLE, (400, 700), (555.5, 555.6), (2000, 3000)):
        assert large.power(limits) == pytest.approx(small.power(limits), rel=1e-8)
        assert large.photons(limits) == pytest.approx(small.photons(limits), rel=1e-8)
    assert large.seen(PHOTOPIC) == pytest.approx(small.seen(PHOTOPIC), rel=1e-8)
    assert large.peak() == pytest.approx(small.peak(), rel=1e-6)


@pytest.mark.parametrize(
    ("line", "message"),
    [("nan,1", "'nan' is not a number"), ("300,1", "is also in line"), ("701", "1 column"),
     ("701,x", "'x' is not a number"), ("701,1_0", "'1_0' is not a number")],
)  # fmt: skip
def test_an_error_in_a_large_file_is_refused_with_its_line(line, message, tmp_path):
    path = tmp_path / "large.csv"
    rows = ["nm,x", *[f"{300 + i / 50},1.000000001" for i in range(19999)]]
    path.write_text("\n".join([*rows, line]) + "\n", encoding="utf-8")
    with pytest.raises(RadcalcError) as caught:
        read_file(str(path))
    assert "line 20001" in caught.value.message
    assert message in caught.value.message


@pytest.mark.parametrize(
    "titles",
    [
        "nm,1e-3 W/m2/nm", "nm,log10(W/m2/nm)", "nm,1/(W/m2/nm)", "nm,error (W/m2/nm)",
        "nm,cumulative W/m2/nm", "nm,dBm", "nm,%T", "nm,albedo", "nm,V(lambda)", "nm,W/m2/5nm",
        "nm,W/m2/nm x 1000", "eV,W/m2/eV", "THz,power", "wavenumber (cm-1),power",
    ],
)  # fmt: skip
def test_scaled_values_and_other_axes_are_refused(titles, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{titles}\n400,1\n500,3\n700,2\n", encoding="utf-8")
    with pytest.raises(RadcalcError):
        read_file(str(path))


@pytest.mark.parametrize("title", ["wavelength [A]", "Wavelength (Ly)", "Energy [keV]"])
def test_a_unit_of_wavelengths_that_is_refused_is_shown_as_typed(title, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{title},W/m2/nm\n400,1\n500,3\n700,2\n", encoding="utf-8")
    with pytest.raises(RadcalcError, match=r"'A'|'Ly'|'Energy \[keV\]'"):
        read_file(str(path))


@pytest.mark.parametrize("title", ["relative power (%)", "E [W/m2/nm]", "W*m-2*nm-1", "lamp 2"])
def test_titles_that_only_look_scaled_are_read(title, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"nm,{title}\n400,1\n500,3\n700,2\n", encoding="utf-8")
    assert list(read_file(str(path)).values) == [1, 3, 2]


def test_photons_lie_on_lines_between_the_points_of_a_table(tmp_path):
    # The trapezoids of 1, 2, 1, 0 umol/m2/s/nm over 100 nm each are 350 umol/m2/s.  Their watts
    # are h c N_A times the integral of photons/lambda, by NumPy on 1e6 points: 82.0488 W/m2; their
    # lux, by the same sum with V(lambda) of colour 0.4.7 on 1 nm: 21887.
    path = tmp_path / "photons.csv"
    path.write_text("nm,umol/m2/s/nm\n400,1\n500,2\n600,1\n700,0\n")
    wanted = "photon-irradiance:umol/m2/s,irradiance:W/m2,illuminance:lx"
    done = run("spectrum", str(path), "-g", wanted)
    found = [float(text) for text in done.stdout.split()]
    assert found == [
        pytest.approx(350, rel=2e-7),
        pytest.approx(82.04887, rel=1e-6),
        pytest.approx(21887, rel=2e-5),
    ]
    assert "100 nm apart" in run("spectrum", str(path), "-g", "r9").stderr
