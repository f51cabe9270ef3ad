"""Units, constants, reflectances and spectra of one's own, from a file of definitions.

Each call is a separate process: definitions change the tables of a process.
"""

import json
import os
import re
import shlex
import subprocess
import sys

import pytest

FILE = """\
# the length of a bridge, and a lamp
#~ k
smoot = 67 inch = smt

constant mylamp = 54 lm/W
reflectance wall = 65%
spectrum office = LED-B3
spectrum mine = mine.csv
kelux = 1000 lx
beam = 0.5 kelux
spectrum lost = lost.csv
spectrum ours = office
"""
SPECTRUM = "wavelength,W\n500,1\n600,1\n"


@pytest.fixture
def home(tmp_path, monkeypatch):
    """Return a folder with its own configuration and cache."""
    folder = tmp_path / "config" / "radcalc"
    folder.mkdir(parents=True)
    (folder / "definitions.txt").write_text(FILE, encoding="utf-8")
    (folder / "mine.csv").write_text(SPECTRUM, encoding="utf-8")
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.delenv("RADCALC_DEFINITIONS", raising=False)
    return tmp_path


def call(text: str, *, status: int = 0, lines: str = "") -> subprocess.CompletedProcess[str]:
    words = [sys.executable, "-m", "radcalc", *shlex.split(text)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=60, input=lines)
    assert done.returncode == status, done.stderr
    return done


# 67 inches of 0.0254 m; 54 lm/W; rho E / pi with rho 0.65.
ANSWERS = {
    "2 smoot m": (3.4036, "smoot = 67 inch, definitions.txt line 3"),
    "3 ksmt km": (5.1054, "smoot = 67 inch"),
    "1 kilosmoot m": (1701.8, "smoot = 67 inch"),
    "3.4036 m smoot": (2.0, "smoot = 67 inch"),
    "'100 W * mylamp' lm": (5400.0, "mylamp = 54 lm/W, definitions.txt line 5"),
    "100W lm --efficacy mylamp": (5400.0, "mylamp = 54 lm/W"),
    "500 lx cd/m2 --reflectance wall": (103.450713009, "wall = 65%, definitions.txt line 6"),
    "point-source --intensity 100cd --distance 2smoot -g illuminance": (
        8.63222933842,
        "smoot = 67 inch",
    ),
}


@pytest.mark.parametrize("text", ANSWERS)
def test_a_definition_is_used_and_said(home, text):
    done = call(text)
    number, said = ANSWERS[text]
    assert float(done.stdout.split()[0]) == pytest.approx(number, rel=1e-11)
    assert f"own definition: {said}" in done.stderr


def test_spectra_of_ones_own_are_those_that_they_name(home):
    for name, source in (("office", "LED-B3"), ("mine", f"{home}/config/radcalc/mine.csv")):
        own, other = (call(f"100 lx W/m2 --spectrum {one}") for one in (name, source))
        assert own.stdout == other.stdout
        assert f"own definition: {name} = " in own.stderr


def test_definitions_are_listed_by_units(home):
    assert "own definition, definitions.txt line 3" in call("units smoot").stdout
    assert "own definition, definitions.txt line 5" in call("units constants").stdout


def test_own_spectra_are_in_the_list_of_spectra(home):
    """The list of the CIE has 4103 K for LED-B3 (CIE 015:2018, table 12.2)."""
    line = call("spectrum --list office").stdout.splitlines()[-1]
    name, _, temperature, _ = line.split("\t")
    assert name == "office"
    assert float(temperature) == pytest.approx(4103, abs=2)


def test_the_option_and_the_variable_name_another_file(home, monkeypatch):
    other = home / "other.txt"
    other.write_text("smoot = 1.7018 m\n", encoding="utf-8")
    assert "other.txt line 1" in call(f"1 smoot m --definitions {other}").stderr
    monkeypatch.setenv("RADCALC_DEFINITIONS", str(other))
    assert "other.txt line 1" in call("1 smoot m").stderr
    monkeypatch.setenv("RADCALC_DEFINITIONS", "")
    assert "unknown unit 'smoot'" in call("1 smoot m", status=2).stderr


KELUX = "kelux = 1000 lx, definitions.txt line 9"
# An own definition in every place of a call, and what the answer begins with.  By hand: 1 klx is
# 92.90304 fc (1 fc = 1 lm/ft2); E = I / d^2; LED-B3 has 69.75 lm s/umol (`spectrum LED-B3`).
STATED = {
    "'1 lx + 1 kelux' fc": ("92.99594304", KELUX),
    "'2 kelux - 1 lx' lx": ("1999", KELUX),
    "'5 kelux,3 klx' lx": ("5000", KELUX),
    "1 beam lx": ("500", "beam = 0.5 kelux, definitions.txt line 10"),
    "point-source --intensity 2000cd --distance 1m -g illuminance:kelux": ("2", KELUX),
    "point-source --intensity 1000cd --distance 1m --check 1kelux": ("right", KELUX),
    "point-source --intensity 1000cd --distance 1m -g illuminance:kelux --format csv": (
        "illuminance:kelux\n1.0", KELUX,
    ),
    "point-source --intensity 1000cd --distance 1m -g illuminance:kelux --format table": (
        "quantity", KELUX,
    ),
    "point-source --intensity 20cd --distance 1m,2smoot -g illuminance": ("20", "smoot = 67 inch"),
    "500 lx ppfd --spectrum office": ("7.16845", "office = LED-B3, definitions.txt line 7"),
    "500 lx ppfd --spectrum ours": ("7.16845", "office = LED-B3"),
    "spectrum office D65 -g cct": ("4102", "office = LED-B3"),
    "'2 * mylamp' lm/W": ("108", "mylamp = 54 lm/W"),
    "solid-angle patch --area 1smoot^2 --radius 2m -g solid-angle": ("0.7240", "smoot = 67 inch"),
    "typical 'wall'": ("wall", "wall = 65%"),
    "800 lm at 2 m to ppfd under office": ("0.228179", "office = LED-B3"),
    "500 lx to ppfd under office": ("7.16845", "office = LED-B3"),
    "100 W to lm with mylamp": ("5400", "mylamp = 54 lm/W"),
    "500 lx on wall to cd/m2": ("103.4507", "wall = 65%"),
    "500 lx reflectance wall to cd/m2": ("103.4507", "wall = 65%"),
    "how many fc is 2 kelux": ("185.80608", KELUX),
}  # fmt: skip


@pytest.mark.parametrize("text", STATED)
def test_an_answer_states_the_definition_wherever_it_is_typed(home, text):
    begins, said = STATED[text]
    done = call(text)
    assert done.stdout.startswith(begins)
    written = done.stdout + done.stderr  # a table has its notes
    assert written.count(f"note: own definition: {said}") == 1
    if "--format" not in text and "right" not in begins:
        notes = json.loads(call(f"{text} --json").stdout.partition("\n")[0].strip("[,"))["notes"]
        assert any(note.startswith(f"own definition: {said}") for note in notes)


def test_a_definition_that_uses_another_states_both(home):
    stated = call("1 beam lx").stderr.splitlines()
    assert [line.partition("definition: ")[2] for line in stated] == [
        "beam = 0.5 kelux, definitions.txt line 10", KELUX,
    ]  # fmt: skip


@pytest.mark.parametrize(
    "text", ["500 lx fc --json", "800 lm at 2 m to lx", "spectrum LED-B3 -g cct", "units smoot"]
)
def test_a_definition_that_is_not_read_is_not_stated(home, text):
    done = call(text)
    assert "own definition:" not in done.stdout + done.stderr


# Lines of standard input, and the outputs with what is written before them.
STREAMS = {
    "convert - fc": ("3 lx\n2 kelux\n", "0.27870912\tfc\n185.80608\tfc\n"),
    "convert - kelux fc": ("2\n", "185.80608\n"),
    "convert - lx kelux": ("2\n", "0.002\n"),
    "convert - fc --column E": ("E [kelux]\n2\n", "E [fc]\n185.80608\n"),
    "point-source --intensity '- cd' --distance 1m -g illuminance:kelux": ("2\n", "0.002\n"),
    "point-source --illuminance - --distance 1m -g intensity": ("1 lx\n2 kelux\n", "1\n2000\n"),
}


@pytest.mark.parametrize("text", STREAMS)
def test_a_stream_states_it_once(home, text):
    lines, written = STREAMS[text]
    done = call(text, lines=lines)
    assert done.stdout == written
    assert done.stderr.count(f"note: own definition: {KELUX}\n") == 1
    records = [json.loads(one) for one in call(f"{text} --json", lines=lines).stdout.splitlines()]
    assert f"own definition: {KELUX}" in records[-1]["notes"]
    assert bool(records[0]["notes"]) == (len(records) == 1)  # the first line is in lux


# Files with own units in titles, cells and keys.  By hand: 2000 lx h is the trapezoid from 1 klx to
# 3 klx in an hour; 1000 cd / (3.4036 m)^2; the only answer of the sheet is 1000 lx.
FILES = {
    "dose F -g exposure": ("time,E [kelux]\n2024-06-01T10:00,1\n2024-06-01T11:00,3\n", "2000\n"),
    "scene F --at 0m,0m,0m -g illuminance": (
        "x,y,z,intensity\n0 m,0 m,2 smoot,1 kecd\n", "86.3222933842\n",
    ),
    "point-source --distribution F --distance 1m -g illuminance": (
        "angle [deg],I [kecd]\n0,1\n90,0\n", "1000\n",
    ),
    "mark F": ("question,command,Ann\nQ,2 kelux to lx,2 klx\n", "Ann\tQ\t2 klx\t2000 lx\tright"),
}  # fmt: skip


@pytest.mark.parametrize("text", FILES)
def test_a_file_with_own_units_states_them(home, text):
    content, begins = FILES[text]
    (home / "own.txt").write_text("smoot = 67 inch\nkelux = 1000 lx\nkecd = 1000 cd\n")
    (home / "f.csv").write_text(content)
    call_of_file = f"{text.replace('F', str(home / 'f.csv'), 1)} --definitions {home}/own.txt"
    done = call(call_of_file)
    assert done.stdout.startswith(begins)
    used = [name for name in ("smoot", "kelux", "kecd") if name in content]
    stated = re.findall("note: own definition: (\\w+) = ", done.stderr)
    assert sorted(stated) == sorted(used)
    document = json.loads(call(f"{call_of_file} --json").stdout)
    assert len([note for note in document["notes"] if "own definition" in note]) == len(used)


def test_the_prompt_states_it_in_the_lines_that_use_it(home):
    done = call("prompt", lines="2 kelux fc\n3 lx fc\nx = 2 smoot\nx m\n")
    said = f"note: own definition: {KELUX}\n0.27870912"
    text = subprocess.run(
        [sys.executable, "-m", "radcalc", "prompt"], stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, input="2 kelux fc\n3 lx fc\n2 smoot m\n", timeout=60,
    ).stdout  # fmt: skip
    assert said in text
    assert done.stderr.count("kelux") == 1


# Refusals of sentences: a missing file is not skipped, and no constant is lost.
@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("800 lm at 2 m to ppfd under lost", "there is no file '"),
        ("800 lm at 2 m to lx under lost", "there is no file '"),
        (
            "500 lx ppfd --spectrum lost",
            "lost = lost.csv, definitions.txt line 11: there is no file",
        ),
        ("500 lx with mylamp on wall to cd/m2", "not used for cd/m2: mylamp"),
        ("800 lm at 2 m to ppfd under offise", "not understood: offise"),
    ],
)
def test_a_sentence_loses_no_definition(home, text, said):
    done = call(text, status=2)
    assert done.stdout == ""
    assert said in done.stderr


def test_every_list_has_own_names(home):
    spectra = call("spectrum --list").stdout
    assert "\noffice\t\t4102\t69.75\n" in spectra
    assert "\nlost\t\t\t\n" in spectra  # its file is missing, which a note says
    document = json.loads(call("spectrum --list --json").stdout)
    (lost,) = [row for row in document["records"] if row["source"] == "lost"]
    assert (lost["cct"], lost["lux_per_ppfd"]) == (None, None)
    assert any(
        "lost.csv, definitions.txt line 11: there is no file" in n for n in document["notes"]
    )
    for words, row in {
        "units": "smoot\tsmt (prefixes: k)\tlength\t67 inch\town definition",
        "units illuminance": "kelux\t\tilluminance\t1000 lx\town definition, definitions.txt",
        "typical mylamp": "mylamp\tluminous efficacy\t54\tlm/W\town definition",
        "typical lm/W": "mylamp\tluminous efficacy\t54\tlm/W", "typical": "wall\tnumber\t65\t%",
        "help office": "spectrum\toffice\town definition: office = LED-B3",
        "help kelux": "unit\tkelux\tilluminance: 1000 lx", "help lost": "spectrum\tlost\t",
        "help mylamp": "unit\tmylamp\tluminous efficacy: 54 lm/W",
    }.items():  # fmt: skip
        assert row in call(words).stdout, words
    near = call("500 lx ppfd --spectrum offise", status=2).stderr
    assert "--spectrum office\n" in near


COMPLETED = {
    "100 lx kel": "kelux", "5kel": "5kelux", "2 smo": "smoot", "units kel": "kelux",
    "spectrum off": "office", "500 lx ppfd --spectrum los": "lost",
    "100 W lm --efficacy my": "mylamp", "500 lx cd/m2 --reflectance w": "wall",
    "point-source -g illuminance:kel": "illuminance:kelux", "typical myl": "mylamp",
    "point-source --illuminance 5kel": "5kelux",
}  # fmt: skip


@pytest.mark.parametrize("typed", COMPLETED)
def test_own_names_are_completed(home, typed, monkeypatch):
    monkeypatch.setenv("_RADCALC_COMPLETE", "fish_complete")
    monkeypatch.setenv("COMP_LINE", f"radcalc {typed}")
    assert f"{COMPLETED[typed]}\t" in call("").stdout
    (home / "config" / "radcalc" / "definitions.txt").write_text("kelux = zork\n")
    assert call("").stderr == ""  # a Tab reports no error


# Spellings that Pint's own reader refuses, with the value in the other unit by the SI.
SPELT = {
    "5 m2": ("m2", 5.0),
    "5 µmol/m²/s": ("umol/m2/s", 5.0),
    "5 ppfd": ("umol/m2/s", 5.0),
    "5 foot-candles": ("lx", 5 / 0.3048**2),
    "5 люкс": ("lx", 5.0),
    "2 pi sr": ("sr", 6.28318530717959),
    "0.1 inch": ("mm", 2.54),
    "(1/3) lx": ("lx", 1 / 3),
}


@pytest.mark.parametrize("value", SPELT)
def test_a_value_is_read_as_everywhere_else(home, value):
    unit, number = SPELT[value]
    file = home / "own.txt"
    file.write_text(f"boat = {value}\ntwo = 2 boat\n", encoding="utf-8")
    done = call(f"1 two {unit} -q -n --definitions {file}")
    assert float(done.stdout) == pytest.approx(2 * number, rel=1e-11)


MALFORMED = {
    "lux = 3 lm": "line 1, column 1: 'lux' is lux already",
    "Hz = 3 lm": "line 1, column 1: 'Hz' is hertz already",
    "ns = 3 lm": "line 1, column 1: 'ns' is nanosecond already",
    "constant c = 3 m/s": "line 1, column 10: 'c' is speed_of_light already",
    "dBm = 3 W": "line 1, column 1: 'dBm' is dBm already",
    "candle = 1 cd": "line 1, column 1: 'candle' is a word of radcalc",
    "\nfoo 3": "line 2, column 1: not a definition",
    "a1 = 3 m": "line 1, column 1: 'a1' is not a name",
    "foo = 3 zork": "line 1, column 9: unknown unit 'zork'",
    "#~ k\n#~ all\nfoo = 3 zork": "line 3, column 9: unknown unit 'zork'",
    "foo = 3 m +": "line 1, column 7: a number is missing in '3 m +'",
    "foo = -3 m": "line 1, column 7: '-3 m' is not above 0",
    "foo = 9**9**9 m": "line 1, column 7: '9**9**9 m' has an exponent on an exponent",
    "reflectance w = 1.2": "line 1, column 17: '1.2' is not a reflectance",
    "foo = 1 m\nbar = 2 m = foo": "line 2, column 13: 'foo' is defined in line 1, too",
    "foo = 1 m\nfoo = 1 m": "line 2, column 1: 'foo' is defined in line 1, too",
    "foo = __import__('os')": "line 1, column 7: '__import__('os')' is not a number",
    "boat = 1,702 m": "line 1, column 8: '1,702 m' has a comma in its number",
    "boat = 1,5 lm": "line 1, column 8: '1,5 lm' has a comma in its number",
    "rig = 3 200 lm": "line 1, column 7: '3 200 lm' is not a number",
    "constant bulb = 54,5 lm/W": "line 1, column 17: '54,5 lm/W' has a comma in its number",
    "cam = 12,5 cd*s/m**2": "line 1, column 7: '12,5 cd*s/m**2' has a comma in its number",
    "boat = 1_5 lm": "line 1, column 8: '1_5 lm' is not a number",
    "boat = 3200 lm 2": "line 1, column 8: the unit 'lm 2' has a number in it",
    "boat = 1.5.2 lm": "line 1, column 8: '1.5.2 lm' is not a number",
    "boat = 3.200,5 lm": "line 1, column 8: '3.200,5 lm' has a comma in its number",
    "boat = 1e3,5 lm": "line 1, column 8: '1e3,5 lm' has 2 values",
    "boat = 1/1,5 lm": "line 1, column 8: '1/1,5 lm' has 2 values",
    "boat = 1,2,3 lx": "line 1, column 8: '1,2,3 lx' has 3 values",
    "boat = 1:3:1 m": "line 1, column 8: '1:3:1 m' has 3 values",
    "reflectance wall = ,8%": "line 1, column 20: ',8%' has 2 values",
    "boat = 5 W/m^2 sr": "line 1, column 8: the unit 'W/m^2 sr' is ambiguous",
    "boat = \N{MINUS SIGN}5 lx": "line 1, column 8: '-5 lx' is not above 0",
    "boat = 5±1 m": "line 1, column 8: '5±1 m' has an uncertainty",
    "foo = 1e99 m\nbar = 2 foo^2": "line 2, column 7: '2 foo^2' is out of range",
    "foo = 1e-101 m": "line 1, column 7: '1e-101 m' is out of range",
    "foo = 1e999999 m": "line 1, column 7: '1e999999' is too large for a number",
    "foo = 5 foo": "line 1, column 9: unknown unit 'foo'",
    "_ = 5 m": "line 1, column 1: '_' is not a name",
    "#~ k\n#~ zork\nfoo = 1 m": "line 3, column 1: unknown prefix 'zork'",
    "foo = 1 m\n\x0c = \N{LINE SEPARATOR}": "line 2, column 3: not a definition",
    "spectrum rig = rig": "line 1, column 10: 'rig' is defined by itself",
    "spectrum rig = way\nfoo = 1 m\nspectrum way = rig": (
        "line 1, column 10: 'rig' is defined by itself (lines 1, 3)"
    ),
    "spectrum rig = way\nspectrum way = zoo\nspectrum zoo = way": (
        "line 2, column 10: 'way' is defined by itself (lines 2, 3)"
    ),
    "spectrum rig = LED-B33": "line 1, column 16: unknown spectrum 'LED-B33'",
    "spectrum rig = A = B": "line 1, column 20: a spectrum has one name",
    "spectrum m = A": "line 1, column 10: 'm' is a name of radcalc",
    "foo = (1+1/3^900) m\nbar = 1 foo^3": "line 2, column 7: '1 foo^3' has too many digits",
    "spectrum D65 = A": "line 1, column 10: 'D65' is a name of radcalc",
}


@pytest.mark.parametrize("text", MALFORMED)
def test_a_malformed_definition_is_refused_with_its_place(home, text):
    file = home / "own.txt"
    file.write_text(f"{text}\n", encoding="utf-8")
    done = call(f"100 lx fc -q --definitions {file}", status=2)
    assert done.stdout == ""
    assert f"own.txt, {MALFORMED[text]}" in done.stderr


@pytest.mark.parametrize("text", ["foo = 1 m = _ = bar", "#~ all\n#~ k\nfoo = 1 m", "#~ all\n"])
def test_what_the_format_allows_is_read(home, text):
    file = home / "own.txt"
    file.write_text(f"{text}\n", encoding="utf-8")
    assert call(f"100 lx fc -q --definitions {file}").stdout == "9.290304\tfc\n"


def test_the_place_of_a_byte_that_is_not_utf_8_is_said(home):
    file = home / "own.txt"
    file.write_bytes(b"\xef\xbb\xbffoo = 1 m\r\nbar = \xff\n")
    done = call(f"100 lx fc -q --definitions {file}", status=2)
    assert "own.txt, line 2, column 7: not UTF-8" in done.stderr


def words(count: int) -> list[str]:
    """Return so many names."""
    letters = "abcdefghijklmnopqrstuvwxyz"
    return [f"qq{a}{b}{c}" for a in letters for b in letters for c in letters][:count]


def test_the_number_of_spellings_and_of_names_in_a_row_is_bounded(home):
    """A unit of all 24 prefixes has 25 symbols, and 50 names with plurals (and without)."""
    names = words(600)
    (home / "own.txt").write_text("".join(f"#~ all\n{name} = 1 m = {name}x\n" for name in names))
    done = call(f"100 lx fc -q --definitions {home}/own.txt", status=2)
    assert "more than 20000 spellings" in done.stderr
    rows = [f"spectrum {a} = {b}\n" for a, b in zip(names, [*names[1:], "A"], strict=True)]
    (home / "own.txt").write_text("".join(rows))
    done = call(f"100 lx fc -q --definitions {home}/own.txt", status=2)
    assert "line 1, column 10: 'qqaaa' is defined by too many others" in done.stderr
    (home / "own.txt").write_text("".join(rows[-9:]))
    done = call(f"spectrum {names[-9]} -g cct --definitions {home}/own.txt")
    assert done.stdout == call("spectrum A -g cct").stdout
    assert done.stderr.count("own definition") == 9


def test_what_is_read_before_a_bad_line_is_taken_back(home):
    (home / "own.txt").write_text("smoot = 1 m\nspectrum office = A\nzork\n")
    code = (
        "from radcalc.errors import RadcalcError\n"
        "from radcalc.inputs import definitions\n"
        "before = [dict(one) for one in definitions.TABLES]\n"
        "try:\n    definitions.load('own.txt')\n"
        "except RadcalcError as error:\n    print(error.message)\n"
        "assert before == [dict(one) for one in definitions.TABLES]\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=home, capture_output=True, text=True, timeout=60
    )
    assert (done.returncode, done.stdout) == (0, "own.txt, line 3, column 1: not a definition\n")


# Calls that only show texts are answered; Tab is in the test of completion.
@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("--help", "Usage: radcalc "), ("--version", "radcalc "), ("help", "Usage: radcalc "),
        ("convert --help", "Usage: radcalc convert"), ("help lux", "unit\tlux\t"),
        ("100 lx fc -h", "Usage: radcalc convert"), ("help convert", "Usage: radcalc convert"),
    ],
)  # fmt: skip
def test_a_bad_line_does_not_stop_help(home, text, shown):
    (home / "config" / "radcalc" / "definitions.txt").write_text("smoot = 67 inch\nzork\n")
    done = call(text)
    assert shown in done.stdout
    assert "/definitions.txt, line 2, column 1: not a definition\n" in done.stderr


# Other calls are refused, and show the call without the file and its answer.
@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("100 lx fc -q", "     9.2903 fc, without the file\n"),
        ("800 lm at 2 m to lx", "     15.9155 lx, without the file\n"),
        ("spectrum D65 -g cct", "     6502.61 K, without the file\n"),
        ("units lux", "     without the file\n"), ("prompt", "     without the file\n"),
        ("2 smoot m -q", ""),  # it needs the file
    ],
)  # fmt: skip
def test_a_bad_line_stops_other_calls(home, text, shown):
    (home / "config" / "radcalc" / "definitions.txt").write_text("smoot = 67 inch\nzork\n")
    done = call(text, status=2)
    assert done.stdout == ""
    assert "definitions.txt, line 2, column 1: not a definition" in done.stderr
    proposed = f"try: radcalc {text} --definitions /dev/null\n{shown}" if shown else ""
    assert done.stderr.partition("\n")[2] == proposed
    if shown:
        call(f"{text} --definitions /dev/null", lines="")


def test_a_file_that_cannot_be_read_is_named(home):
    assert "cannot read /nope" in call("100 lx fc -q --definitions /nope", status=2).stderr


def test_a_plain_conversion_does_not_look_for_definitions(home):
    """The file is malformed: reading it would be an error."""
    (home / "config" / "radcalc" / "definitions.txt").write_text("zork\n", encoding="utf-8")
    assert call("100 lx fc -n").stdout == "9.290304\n"
    assert "not a definition" in call("100 lx fc -q", status=2).stderr


def test_a_compiled_file_loads_no_pint(home):
    call("2 smoot m")
    words = [sys.executable, "-X", "importtime", "-m", "radcalc", "2", "smoot", "m"]
    done = subprocess.run(words, capture_output=True, text=True, timeout=60, env=os.environ)
    assert "radcalc.units" in done.stderr
    assert "pint" not in done.stderr


PYTHON = """
import pickle, radcalc
radcalc.define("own.txt")
radcalc.define("own.txt")  # once is enough
lamp = radcalc.point_source(intensity="2000 cd", distance="1 m")
right = radcalc.check(lamp, "2 kelux")
given = radcalc.point_source(illuminance="2 kelux", distance="1 m")
print(radcalc.convert("2 kelux", "fc").magnitude, radcalc.convert("500 lx", "kelux"))
print(radcalc.Quantity(2.0, "kelux").to("lx"), radcalc.Quantity(1.0, "Mkel").to("lx").magnitude)
print(lamp.notes, bool(right), given.intensity, pickle.loads(pickle.dumps(given)).notes)
print([radcalc.explain(*words, **given).notes[-1] for words, given in (
    (("1 lx + 1 kelux", "lx"), {}), (("500 lx", "ppfd"), {"spectrum": "office"}),
    (("100 W", "lm"), {"efficacy": "mylamp"}))])
print(right.notes, given.to_dict()["notes"], radcalc.typical("2 kelux").notes)
print(round(radcalc.ask("800 lm at 2 m to ppfd under office").magnitude, 6))
print(radcalc.explain("1 lx", "fc").notes, radcalc.point_source(flux="1 lm", distance="1 m").notes)
try:
    radcalc.define("bad.txt")
except radcalc.RadcalcError as error:
    print(error.message)
"""


def test_python_reads_definitions_and_states_them(home):
    """By hand: 2 klx are 2000 / 10.763910 fc (SP 811); 800 lm / (16 pi m2) / 69.75 lm s/umol."""
    text = "#~ M\nkelux = 1000 lx = kel\nconstant mylamp = 54 lm/W\nspectrum office = LED-B3\n"
    (home / "own.txt").write_text(text)
    (home / "bad.txt").write_text("zork\n")
    done = subprocess.run(
        [sys.executable, "-c", PYTHON], cwd=home, capture_output=True, text=True, timeout=60
    )
    assert done.stderr == ""
    stated = "own definition: kelux = 1000 lx, own.txt line 2"
    isotropic = ["the source is taken as isotropic; for a beam, give beam_angle"]
    assert done.stdout.splitlines() == [
        "185.80608 0.5 kelux",
        "2000.0 lux 1000000000.0",
        f"{(*isotropic,)} True 2000.0 candela {(stated,)}",
        str([
            stated, "own definition: office = LED-B3, own.txt line 4",
            "own definition: mylamp = 54 lm/W, own.txt line 3",
        ]),
        f"{(stated,)} {[stated]} {(stated,)}",
        "0.228179",
        "() ()",
        "bad.txt, line 1, column 1: not a definition",
    ]  # fmt: skip
