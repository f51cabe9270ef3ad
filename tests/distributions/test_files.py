"""Opening, decoding and recognition of files."""

import math
import os
import subprocess
import sys

import pytest
from conftest import python

from radcalc.distributions.sources import MOST_BYTES, read_file
from radcalc.errors import RadcalcError

IES = """IESNA:LM-63-2002
[LUMINAIRE] Ball
TILT=NONE
1 -1 1 3 1 1 2 0 0 0
1 1 9
0 90 180
0
100 100 100
"""
# fmt: off
LDT = "\n".join([
    "Lamps", "1", "1", "1", "0", "3", "90", "", "Kugelleuchte Größe 1", *[""] * 12, "50", "80", "1",
    "0", "1", "1", "LED", "1000", "", "", "9", *[""] * 10, "0", "0", "90", "180", "100", "100",
    "100", "",
])
# fmt: on
CSV = "gamma (deg),I (cd)\n0,100\n90,100\n180,100\n"
FORMATS = {"IES LM-63-2002, type C": IES, "EULUMDAT, Isym 1": LDT, "CSV table": CSV}
SPHERE = 400 * math.pi  # [lm] of 100 cd everywhere


@pytest.fixture
def written(tmp_path):
    def write(data, name="lamp.txt"):
        path = tmp_path / name
        path.write_bytes(data if isinstance(data, bytes) else data.encode())
        return str(path)

    return write


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize(
    "name", ["lamp.ies", "lamp.ldt", "lamp.csv", "lamp.txt", "LAMP", "lamp.dat"]
)
def test_the_contents_determine_the_format(form, name, written):
    found = read_file(written(FORMATS[form], name))
    assert found.format == form
    assert found.distribution.flux().value == pytest.approx(SPHERE, rel=1e-12)


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "latin-1"])
def test_line_ends_and_encodings(form, end, encoding, written):
    text = FORMATS[form].replace("Ball", "Größe 1").replace("\n", end)
    found = read_file(written(text.encode(encoding)))
    assert found.distribution.flux().value == pytest.approx(SPHERE, rel=1e-12)
    assert found.name.endswith("Größe 1") or form == "CSV table"


@pytest.mark.parametrize(
    ("symmetry", "stored", "listed", "wave"),
    [
        (0, range(0, 360, 30), range(0, 361, 30), lambda c: 2 + math.cos(c) + math.sin(2 * c)),
        (2, range(0, 181, 30), range(0, 181, 30), lambda c: 2 + math.cos(c)),
        (3, range(-90, 91, 30), range(90, 271, 30), lambda c: 2 + math.sin(c)),
        (4, range(0, 91, 30), range(0, 91, 30), lambda c: 2 + math.cos(2 * c)),
    ],
)
def test_one_lamp_is_the_same_in_every_format(symmetry, stored, listed, wave, written):
    gammas = range(0, 181, 20)

    def rows(planes):
        """Intensities of whole planes, which are the same on the axis."""
        return [
            [100 + 10 * wave(math.radians(c)) * math.sin(math.radians(g)) for g in gammas]
            for c in planes
        ]

    def said(numbers, between=" "):
        return between.join(map(repr, numbers))

    ies = [*IES.split("\n")[:3], f"1 -1 1 {len(gammas)} {len(listed)} 1 2 0 0 0", "1 1 9"]
    ies += [said(gammas), said(listed), *map(said, rows(listed))]
    head = LDT.split("\n")[:42]
    head[2:7] = map(str, (symmetry, 12, 30, len(gammas), 20))
    table = [said(row, "\n") for row in rows(stored)]
    ldt = [*head, said(range(0, 360, 30), "\n"), said(gammas, "\n"), *table]
    columns = zip(gammas, *rows(listed), strict=True)
    csv = ["gamma," + ",".join(f"C{c} (cd)" for c in listed), *(said(row, ",") for row in columns)]
    found = [read_file(written("\n".join(lines))).distribution for lines in (ies, ldt, csv)]
    for c in range(0, 360, 15):
        for g in (0, 10, 75, 90, 170):
            values = [lamp.intensity(math.radians(g), math.radians(c)) for lamp in found]
            assert values == pytest.approx([values[0]] * 3, rel=1e-12)
    on_a_node = 100 + 10 * wave(math.radians(60)) * math.sin(math.radians(40))
    assert values[0] > 0
    assert found[1].intensity(math.radians(40), math.radians(60)) == pytest.approx(on_a_node)
    fluxes = [lamp.flux().value for lamp in found]
    assert fluxes == pytest.approx([fluxes[0]] * 3, rel=1e-12)


def test_other_line_separators_do_not_end_a_line(written):
    """Windows-1252 has an ellipsis at a line end of Latin-1; a form feed is a blank."""
    for mark in (b"\x85", b"\x0b", b"\x0c", b"\xe2\x80\xa8"):
        data = LDT.encode("latin-1").replace(b"Gr\xf6\xdfe", b"G" + mark + b"x")
        assert read_file(written(data)).distribution.flux().value == pytest.approx(SPHERE)


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("end", ["", "\x1a", "\n\x1a", "\x1a\r\n\r\n", "\n \n\t\n"])
def test_padding_after_a_text_is_ignored(form, end, written):
    found = read_file(written(FORMATS[form].rstrip("\n") + end))
    assert found.distribution.flux().value == pytest.approx(SPHERE, rel=1e-12)


REFUSED = {
    "nothing": (b"", "is empty"),
    "blanks": (b"\n \n\xef\xbb\xbf"[:3], "is empty"),
    "UTF-16": (IES.encode("utf-16"), "is text in UTF-16"),
    "UTF-16 the other way": (b"\xfe\xff" + IES.encode("utf-16-be"), "is text in UTF-16"),
    "UTF-16 without its mark": (IES.encode("utf-16-le"), "is not text: byte 1 is 0"),
    "a picture": (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "is not text: byte 8 is 0"),
    "an archive": (b"PK\x03\x04\x14\x00", "is not text: byte 2 is 3"),
    "compressed": (b"\x1f\x8b\x08\x00", "is not text: byte 0 is 31"),
    "XML": ("<?xml version='1.0'?>\n<a/>", "is XML or HTML"),
    "JSON": ('{"a": 1}', "is JSON"),
    "prose": ("Dear all,\n\nthe lamp is bright.\n", "begins with 'Dear all,'"),
    "one column": ("1\n2\n3\n", "begins with '1'"),
    "a spectrum": ("wavelength (nm),W/m2/nm\n400,1\n700,2\n", "line 1: 'wavelength (nm)'"),
    "wavelengths": ("400 1\n500 2\n700 3\n", "line 3: a polar angle of 700 deg"),
}


@pytest.mark.parametrize(("data", "message"), REFUSED.values(), ids=REFUSED.keys())
def test_anything_else_is_refused(data, message, written):
    with pytest.raises(RadcalcError) as caught:
        read_file(written(data))
    assert message in caught.value.message
    assert "lamp.txt" in caught.value.message
    assert caught.value.hint


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("lamp.ies", IES.replace("TILT=NONE", "NONE"), "TILT="),
        ("lamp.ies", "a label\n1 2 3\n4\n", "TILT="),
        (
            "lamp.ldt",
            LDT.replace("Lamps\n1\n1", "Lamps\n1\n9", 1),
            "line 3: '9' is not a valid",
        ),
        ("lamp.ldt", "\n".join(LDT.split("\n")[1:]), "line 4: '0' is not a valid number Mc"),
        ("lamp.csv", "gamma\n0\n9\n", "there is only one column"),
        ("lamp.csv", "gamma,I\nx,1\n0,1\n", "line 2: 'x,1' is between the titles and the numbers"),
    ],
)
def test_the_extension_selects_the_reader_that_reports_the_error(name, text, message, written):
    with pytest.raises(RadcalcError) as caught:
        read_file(written(text, name))
    assert message in caught.value.message


def test_a_path_that_is_not_a_file_is_refused(tmp_path):
    for path, message in (
        (str(tmp_path), "Is a directory"),
        (str(tmp_path / "none.ies"), "No such file"),
        ("a\0b.ies", "not a file name"),
        ("/dev/zero", "a pipe or a device"),
        ("/dev/null", "a pipe or a device"),
    ):
        with pytest.raises(RadcalcError, match=message):
            read_file(path)


def test_an_idle_pipe_does_not_block(tmp_path):
    path = tmp_path / "lamp.ies"
    os.mkfifo(path)
    code = f"from radcalc.distributions.sources import read_file; read_file({str(path)!r})"
    done = python(code)
    assert "a pipe or a device" in done.stderr


def test_a_large_file_is_refused_before_reading(tmp_path):
    path = tmp_path / "lamp.csv"
    with open(path, "wb") as file:
        file.truncate(1 << 30)
    with pytest.raises(RadcalcError, match="more than 64 MiB") as caught:
        read_file(str(path))
    assert "lamp.csv" in caught.value.message
    assert MOST_BYTES == 64 << 20


@pytest.mark.parametrize("form", FORMATS)
def test_standard_input_is_read_like_a_file(form):
    code = "from radcalc.distributions.sources import read_file; print(read_file('-').format)"
    done = subprocess.run(
        [sys.executable, "-c", code],
        input=FORMATS[form],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == form


def test_standard_input_without_end_is_refused():
    code = "from radcalc.distributions.sources import read_file; read_file('-')"
    with open("/dev/zero", "rb") as zeros:
        done = subprocess.run(
            [sys.executable, "-c", code], stdin=zeros, capture_output=True, text=True
        )
    assert "stdin has more than 64 MiB" in done.stderr


def test_a_damaged_byte_is_at_most_an_error(written):
    for text in FORMATS.values():
        data = text.encode()
        for k in range(len(data)):
            for damaged in (data[:k], data[:k] + b"\xff" + data[k + 1 :], data[:k] + data[k + 1 :]):
                try:
                    read_file(written(damaged))
                except RadcalcError as error:
                    message = error.message
                else:
                    continue
                assert "lamp.txt" in message


@pytest.mark.parametrize(
    ("header", "rows", "said"),
    [
        ("gamma,C0 (cd),C45 (cd),C90 (cd)", "0,100,110,100", "on the axis"),
        ("gamma,C0 (cd),C90 (cd)", "0,9,9\n0.5,9,5\n1,9,5", ""),
        (
            "gamma,C0 (cd),C90 (cd),C180 (cd),C270 (cd),C360 (cd)",
            "0,9,9,9,9,9\n45,5,6,7,8,6",
            "which are one",
        ),
    ],
)
def test_a_contradictory_table_has_a_note(tmp_path, header, rows, said):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{header}\n{rows}\n90{',0' * header.count(',')}\n")
    notes = " ".join(read_file(str(path)).notes)
    assert said in notes if said else not notes
