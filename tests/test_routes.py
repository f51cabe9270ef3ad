"""The kind of a file by its contents, and the command of each kind."""

import json
import shlex
from pathlib import Path

import pytest
from conftest import ROOT, run

from radcalc.cli.spelling import quoted, route
from radcalc.errors import ConditionError
from radcalc.routes import LOG, LUMINAIRE, MAP, NAMES, SCENE, SPECTRUM, TABLE, kind_of

SPECTRAL_ROWS = "nm,I\n" + "\n".join(f"{nm},1.5" for nm in range(380, 785, 5))
KINDS = {
    "IES:LM-63-2019\nTILT=NONE\n": LUMINAIRE,
    "gamma (deg),I (cd)\n0,300\n45,200\n90,0\n": LUMINAIRE,
    "angle (deg);C0-C180 (cd)\n-90;0\n0;12,5\n90;0\n": LUMINAIRE,
    "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n": MAP,
    "PF\n8 4\n-1\n": MAP,
    "nm,W/m2/nm\n400,1\n500,1\n": SPECTRUM,
    "wavelength (nm),reflectance\n400,1\n500,1\n": SPECTRUM,
    f"{SPECTRAL_ROWS}\n": SPECTRUM,
    SPECTRAL_ROWS.partition("\n")[2]: TABLE,  # numbers alone are no wavelengths
    "SpectraSuite Data File\n>>>>>Begin Processed Spectral Data<<<<<\n400.1\t1\n400.5\t2\n"
    ">>>>>End Processed Spectral Data<<<<<\n": SPECTRUM,
    "vlnová délka,hodnota\n400,1\n500,1\n": SPECTRUM,
    "time,E [lx]\n2024-06-01T12:00Z,5\n2024-06-01T13:00Z,7\n": LOG,
    "2024-06-01 12:00,5\n2024-06-01 13:00,7\n": LOG,
    "t [h],E [lx]\n0,50\n4,80\n": LOG,
    "Data; Hora; Lux\n2000/1/1; 00:00:00; 0;\n2000/1/1; 00:01:00; 1;\n": LOG,  # ends in ;
    "time,lux,temperature (°C)\n2024-06-01 12:00,5,20\n2024-06-01 13:00,7,21\n": LOG,
    "time,E [lx],PAR [umol/m2/s]\n2024-06-01T12:00Z,5,6\n2024-06-01T13:00Z,7,8\n": TABLE,
    "name,x,y,z,flux\na,0,0,2,800lm\n": SCENE,
    "x (m),y (m),E (lx)\n0,0,20\n0,1,30\n": TABLE,  # a grid of readings
    "desk,E [lx],d [m]\na,500,1\nb,300,2\n": TABLE,
    "1\n2\n3\n1\n2\n3\n4\n5\n": TABLE,  # its lines 2 to 7 are numbers, as in EULUMDAT
    "angle (deg),E (lx)\n0,20\n30,15\n": TABLE,
}


def saved(tmp_path, text, name="file.txt"):
    path = tmp_path / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return str(path)


@pytest.mark.parametrize(("text", "kind"), KINDS.items())
@pytest.mark.parametrize("name", ["file.csv", "file.ies", "file"])
def test_a_file_is_what_it_contains_whatever_its_name(text, kind, name, tmp_path):
    is_damaged = kind == TABLE and name.endswith(".ies")  # whose reader names the error
    assert kind_of(saved(tmp_path, text, name)) == (LUMINAIRE if is_damaged else kind)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig"])
@pytest.mark.parametrize("end", ["\r\n", "\r"])
def test_encodings_and_line_ends_do_not_hide_the_kind(encoding, end, tmp_path):
    for text, kind in KINDS.items():
        if kind != MAP:
            data = text.replace("\n", end).encode(encoding)
            assert kind_of(saved(tmp_path, data)) == kind, text


UNKNOWN = [
    "",
    "{}",
    '{"a": [1, 2, 3]}',
    "<html><p>100 lx</p></html>",
    "# Readme\n\nThe lamp has 100 lm, or 200.\nIt is 3 m away, at 20 deg.\n",
    b"\x89PNG\r\n\x1a\n" + bytes(100),
    b"PK\x03\x04" + bytes(100),
    bytes(range(256)) * 4,
]


@pytest.mark.parametrize("data", UNKNOWN)
def test_another_file_is_refused(data, tmp_path):
    with pytest.raises(ConditionError):
        kind_of(saved(tmp_path, data))
    done = run(saved(tmp_path, data))
    assert (done.returncode, done.stdout) == (2, "")


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("a.ies", "TILT="),
        ("a.ldt", "before its type"),
        ("a.hdr", "not a picture in a known format"),
        ("a.exr", "not a picture in a known format"),
        ("a.spdx", "there is no row of numbers"),
    ],
)
def test_a_damaged_file_of_a_known_ending_gets_the_error_of_its_reader(name, said, tmp_path):
    done = run(saved(tmp_path, "some words\n", name))
    assert done.returncode == 2
    assert said in done.stderr


def test_the_command_is_printed_and_has_the_same_answer():
    lamp = str(ROOT / "examples" / "downlight.ies")
    routed, typed = (
        run(lamp, "-g", "flux"),
        run("point-source", "--distribution", lamp, "-g", "flux"),
    )
    first, _, rest = routed.stderr.partition("\n")
    assert first == f"read as: radcalc point-source --distribution {quoted(lamp)} -g flux"
    assert (routed.stdout, rest) == (typed.stdout, typed.stderr)
    assert "read as" not in run(lamp, "-q").stderr
    assert json.loads(run(lamp, "--json").stdout)["command"] == "point-source"


@pytest.mark.parametrize("name", ["D65", "photon", "100lx", "lux", "help"])
def test_what_radcalc_knows_comes_before_a_file_of_that_name(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    saved(tmp_path, "nm,W/m2/nm\n400,1\n500,1\n", name)
    assert f"read as: radcalc spectrum ./{name}" not in run(name).stderr
    assert f"read as: radcalc spectrum ./{name}\n" in run(f"./{name}").stderr


@pytest.mark.parametrize("name", ["2024-06-01.csv", "3 lamps.csv", "-log.csv"])
def test_a_name_that_begins_like_a_value_may_be_a_file(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    path = saved(tmp_path, "nm,W/m2/nm\n400,1\n500,1\n", name)
    word = f"./{name}" if name[0] == "-" else name
    assert "read as: radcalc spectrum" in run(word).stderr
    assert route(path) == ("spectrum", path)


READERS = {
    LUMINAIRE: ("point-source", "--distribution"),
    MAP: ("environment",),
    SPECTRUM: ("spectrum",),
    LOG: ("dose",),
    SCENE: ("scene",),
}


def test_a_command_names_the_command_for_a_file_of_another_kind(tmp_path):
    files = {
        kind: saved(tmp_path, next(t for t in KINDS if KINDS[t] == kind), kind) for kind in READERS
    }
    for wanted, words in READERS.items():
        for kind, path in files.items():
            if kind != wanted:
                done = run(*words, path)
                assert done.returncode == 2, (wanted, kind)
                assert f"is {NAMES[kind]}, not {NAMES[wanted]}" in done.stderr
                if kind not in (MAP, LUMINAIRE, LOG):  # files cut off here, which no call reads
                    assert " ".join(["try: radcalc", *READERS[kind], path]) in done.stderr


# The mean of 500, 300 and 100 is 300; -9999 and NaN mark missing values.
def test_columns_have_the_numbers_of_their_cells(tmp_path):
    path = saved(tmp_path, "lamp;E [lx];d [m]\na;500;1,5\nb;300;NaN\nc;100;-9999\n\nd;x\n")
    lamp, lux, distance = json.loads(run("columns", path, "--json").stdout)["records"]
    assert (lamp["from"], lamp["to"], lamp["mean"]) == ("a", "c", None)
    assert (lux["unit"], lux["from"], lux["to"], lux["mean"]) == ("lx", 100, 500, 300)
    assert (distance["unit"], distance["numbers"], distance["mean"]) == ("m", 1, 1.5)
    assert "a line is no row of data; the first: line 6: 'd;x'" in run("columns", path).stderr


def test_many_rows_are_summed_as_single_ones(tmp_path):
    rows = [f"{k % 97},{k / 8}" for k in range(20_000)]
    plain = saved(tmp_path, "\n".join(["a [lx],b [m]", *rows]))
    mixed = saved(tmp_path, "\n".join(["a [lx],b [m]", *rows, "", "# end"]), "mixed")
    first, second = (
        json.loads(run("columns", p, "--json").stdout)["records"] for p in (plain, mixed)
    )
    assert [r["mean"] for r in first] == [r["mean"] for r in second]
    assert first[0]["mean"] == sum(k % 97 for k in range(20_000)) / 20_000
    assert first[1]["to"] == 19_999 / 8


def test_the_command_for_a_column_is_answered(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    texts = ["desk,E [lx],d [m]\na,500,1\nb,300,2\n", "some text\ndesk;E (lx)\na;500,5\nb;300\n"]
    for text in [*texts, next(t for t in KINDS if "PAR" in t)]:
        Path("t.csv").write_text(text, encoding="utf-8")
        for row in json.loads(run("columns", "t.csv", "--json").stdout)["records"]:
            if row["command"]:
                words, _, file = row["command"].removeprefix("radcalc ").partition(" < ")
                done = run(*shlex.split(words), input=text if file else "")
                assert done.returncode == 0, (row["command"], done.stderr)


LAMP, LOGGED = "examples/downlight.ies", "examples/gallery.csv"


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        (f"point-source --ies {LAMP}", f"point-source --distribution {LAMP}"),
        (f"point-source --ldt {LAMP} -q", f"point-source --distribution {LAMP} -q"),
        (f"point-source --file {LAMP}", f"point-source --distribution {LAMP}"),
        (f"dose --csv {LOGGED}", f"dose {LOGGED}"),
        (f"dose --file={LOGGED} -q", f"dose {LOGGED} -q"),
        ("spectrum --spd D65 -g cct", "spectrum D65 -g cct"),
        ("spectrum D65 --csv", "spectrum D65 --format csv"),
        ("environment --hdr sky:overcast -q", "environment sky:overcast -q"),
        ("convert 100 lx W/m2 --spd D65", "convert 100 lx W/m2 --spectrum D65"),
    ],
)
def test_a_wrong_option_for_a_file_leads_to_the_right_one(typed, meant):
    assert f"try: radcalc {meant}\n" in run(*typed.split()).stderr
