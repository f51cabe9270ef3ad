"""`radcalc help WORD ...`: the findings and their order, and that the commands answer."""

import json
import re
import shlex

import pytest
from conftest import run
from helpers import for_each, terminal_of

from radcalc.calculators import COMMANDS
from radcalc.cli.findings import EXACT, KINDS, MOST, OF_A_KIND, SEARCHES, find, near
from radcalc.quantities.lookup import THINGS
from radcalc.quantities.names import QUANTITIES
from radcalc.spectra.sources import names as spectra
from radcalc.units.compiled import UNITS

WORDS = ["lux", "footcandle", "beam angle", "ppfd", "sunlight", "intensity", "LED", "cone", "W/m2"]
WORDS += ["výkon", "поток", "blackbody", "sodium", "dBm", "iso", "distance", "projector"]


def rows(*words):
    done = run("help", *words)
    assert done.returncode == 0, done.stderr
    return [line.split("\t") for line in done.stdout.splitlines()]


@for_each(COMMANDS)
def test_the_help_of_a_command_is_that_of_its_option(name):
    assert run("help", name).stdout == run(name, "--help").stdout


def test_help_alone_is_the_help_of_radcalc():
    assert run("help").stdout == run("--help").stdout
    assert run("help", "help").stdout == run("help", "--help").stdout


def test_several_commands_are_refused_with_both():
    done = run("help", "convert", "ev")
    assert (done.returncode, done.stdout) == (2, "")
    calls = re.findall(r"(?:try: |or:  )radcalc (.*)", done.stderr)
    assert calls == ["convert --help", "ev --help"]


# The kind of each word: the definition of the unit, the quantity that it measures, its misnomer.
@pytest.mark.parametrize(
    ("words", "kind", "name"),
    [
        ("lux", "unit", "lux"),
        ("lux", "quantity", "illuminance"),
        ("footcandle", "unit", "footcandle"),
        ("foot-candle", "unit", "footcandle"),
        ("beam angle", "option", "--beam-angle"),
        ("ppfd", "quantity", "photon irradiance"),
        ("osvětlenost", "quantity", "illuminance"),
        ("projector", "command", "screen"),
        ("cone", "command", "solid-angle"),
        ("dBm", "unit", "dBm"),
        ("sodium", "spectrum", "HPS"),
        ("black body", "spectrum", "blackbody:2856K"),
        ("moon", "typical value", "full moon"),
        ("sunlight", "spectrum", "AM1.5G"),
    ],
)
def test_a_word_finds_its_meaning(words, kind, name):
    assert [kind, name] in [row[:2] for row in rows(*words.split())]


@for_each([*(q.name("en") for q in QUANTITIES[::3]), *[*UNITS][::19], *spectra()[::19], *COMMANDS])
def test_an_exact_name_comes_first(name):
    found = find(name)
    assert found[0].place(name) == EXACT


@for_each(WORDS)
def test_the_best_come_first_and_no_kind_crowds_the_others_out(text):
    found = find(text)
    places = [one.place(text) for one in found]
    assert places == sorted(places)
    shown = rows(*text.split())
    assert 0 < len(shown) <= MOST
    for kind in KINDS:
        exact = sum(one.kind == kind and one.place(text) == EXACT for one in found)
        assert sum(row[0] == kind for row in shown) <= max(OF_A_KIND, exact)


@for_each(WORDS)
def test_notes_count_what_is_not_shown(text):
    found = find(text)
    done = run("help", *text.split())
    more = re.findall(r"^note: (\d+) more", done.stderr, re.M)
    assert sum(map(int, more)) == len(found) - len(done.stdout.splitlines())


@for_each(WORDS)
def test_every_command_of_a_list_answers(text):
    done = run("help", *text.split())
    calls = {line.split("\t")[3] for line in done.stdout.splitlines()}
    calls |= {*re.findall(r": (radcalc .*)$", done.stderr, re.M)}
    for command in calls:
        program, *words = shlex.split(command)
        answered = run(*words)
        assert (program, answered.returncode) == ("radcalc", 0), command
        assert answered.stdout


@for_each(
    [
        "nonsense",
        "lumnes",
        "solar zork",
        "candella",
        "wavelenght",
        "zork\nblub",
        "zork --lux",
        "x" * 300,
    ]
)
def test_an_unknown_word_is_refused_with_calls_that_answer(text):
    done = run("help", "--", text)
    assert (done.returncode, done.stdout) == (2, "")
    assert "nothing has the words" in done.stderr
    calls = re.findall(r"(?:try: |or:  )radcalc (.*)", done.stderr)
    assert calls
    for words in calls:
        assert run(*shlex.split(words)).returncode == 0
    assert all(find(name) for name in near(text, 3))


@for_each([("candella", "candela"), ("wavelenght", "wavelength"), ("steradien", "steradian")])
def test_a_misspelt_name_is_proposed(typed, name):
    assert f"try: radcalc help {name}\n" in run("help", typed).stderr


def test_every_search_finds_something():
    for search in SEARCHES:
        assert any([*search(word)] for word in ("light", "sun", "D65", "illuminance", "cri"))


@for_each(THINGS[::3])
def test_the_subjects_of_typical_values_are_found(word):
    assert find(word)


def test_json_has_the_same_findings_and_the_notes():
    done = run("help", "lux", "--json")
    answer = json.loads(done.stdout)
    assert [[*record.values()] for record in answer["records"]] == rows("lux")
    notes = run("help", "lux").stderr.splitlines()
    assert [f"note: {note}" for note in answer["notes"]] == notes != []
    assert done.stderr == ""


def test_a_table_keeps_each_command_on_one_line():
    text = terminal_of("help", "beam", "angle", columns=80, NO_COLOR="1")
    assert "command to type" in text
    for *_, command in rows("beam", "angle"):
        assert command in text


# The names of CIE 13.3, ANSI/IES TM-30 and SMPTE ST 2122, and those that people use for them.
@for_each(
    [
        ("cri", "cri"),
        ("Ra", "cri"),
        ("colour rendering", "cri"),
        ("index podání barev", "cri"),
        ("R9", "r9"),
        ("SSI", "ssi"),
        ("spectral similarity", "ssi"),
        ("TM-30", "rf"),
        ("fidelity", "rf"),
        ("gamut", "rg"),
        ("beam diameter", "beam-diameter"),
        ("pool", "beam-diameter"),
        ("rcs-h5", "rcs-h5"),
    ]
)
def test_a_result_is_found_first_with_a_call_that_shows_it(text, name):
    first = find(text)[0]
    assert (first.kind, first.name) == ("result", name)
    if not name.startswith("r"):  # those of colour-science take long
        assert run(*first.call, "-q").stdout.strip().replace("\n", "").replace(".", "").isdigit()


def test_the_distance_is_found_by_the_word_of_the_stage():
    assert find("throw")[0].name == "--distance"
