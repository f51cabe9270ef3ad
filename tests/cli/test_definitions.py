"""Units, constants, reflectances and spectra of one's own, from a file of definitions.

Each call is a separate process: definitions change the tables of a process.
"""

import os
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


def call(text: str, *, status: int = 0) -> subprocess.CompletedProcess[str]:
    words = [sys.executable, "-m", "radcalc", *shlex.split(text)]
    done = subprocess.run(
        words, capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL
    )
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
    "spectrum D65 = A": "line 1: 'D65' is a name of radcalc",
}


@pytest.mark.parametrize("text", MALFORMED)
def test_a_malformed_definition_is_refused_with_its_place(home, text):
    file = home / "own.txt"
    file.write_text(f"{text}\n", encoding="utf-8")
    done = call(f"100 lx fc -q --definitions {file}", status=2)
    assert done.stdout == ""
    assert f"own.txt, {MALFORMED[text]}" in done.stderr


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
