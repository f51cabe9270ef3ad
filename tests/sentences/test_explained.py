"""`--explain` shows how a sentence is read, and answers nothing."""

import json

import pytest
from conftest import run
from helpers import for_each

SHOWN = {
    "20000 cd at 8 m to lx": [
        ("20000 cd", "--intensity 20000cd"),
        ("at 8 m", "--distance 8m"),
        ("lx", "-g illuminance:lx"),
        (
            "20000 cd at 8 m to lx",
            "radcalc point-source --intensity 20000cd --distance 8m -g illuminance:lx",
        ),
    ],
    "100 lx fc": [("100 lx", "100 lx"), ("fc", "fc"), ("100 lx fc", "radcalc convert 100 lx fc")],
    "1200 lm isotropic to cd": [
        ("1200 lm", "1200 lm"),
        ("isotropic", "--isotropic"),
        ("cd", "cd"),
        ("1200 lm isotropic to cd", "radcalc convert 1200 lm cd --isotropic"),
    ],
    "examples/downlight.ies --height 3m": [
        ("height 3m", "--height 3m"),
        ("examples/downlight.ies", "--distribution examples/downlight.ies"),
        (
            "examples/downlight.ies --height 3m",
            "radcalc point-source --distribution examples/downlight.ies --height 3m",
        ),
    ],
    "footcandle lx": [("footcandle lx", "radcalc convert 1 footcandle lx")],
    "20000 cd lx --distance 8m": [
        ("20000 cd lx --distance 8m", "radcalc convert 20000 cd lx --distance 8m")
    ],
}


def explained(sentence):
    done = run(*sentence.split(), "--explain", "-q")
    assert done.returncode == 0, done.stderr
    return [tuple(line.split("\t")) for line in done.stdout.splitlines()]


@for_each(list(SHOWN.items()))
def test_the_lines_are_the_phrases_and_the_command(sentence, lines):
    assert explained(sentence) == lines


ANSWERED = [
    "1500 lm over 100 m2 to fc",
    "how many lumens for a 15 m x 20 m office at 500 lux",
    "250000 cd how far for 1614 lux",
    "20 W laser 2 mm beam W/cm2",
    "f/5.6 1/60s ISO 100 to cd/m2",
    "EV 9 to lx",
    "svítivost 80 cd, vzdálenost 2.4 m, plocha 600 cm2, kolik lm",
    "25 лк на 2 м под углом 30 градусов сила света",
    "400 J/m2 at 150 mW/m2 how long",
    "peak wavelength of a 5778 K blackbody",
    "15500 lux W/m2 with D65",
    "2000 lm on a 100 inch 16:9 screen",
    "d=2m I=100cd",
    "at 3 m examples/downlight.ies lx",
    "1 mW od 2 to uW",
]


@for_each(ANSWERED)
def test_the_command_is_the_one_that_answers(sentence):
    *phrases, (whole, command) = explained(sentence)
    assert whole == sentence
    assert f"read as: {command}\n" in run(*sentence.split()).stderr
    assert phrases
    for phrase, meaning in phrases:
        assert meaning in command, phrase


def test_the_words_that_add_nothing_are_in_a_note():
    done = run("how", "many", "lumens", "for", "500", "lx", "on", "3", "m2", "--explain")
    assert done.stderr == "note: ignored: how, many, for\n"


def test_json_is_an_object():
    shown = json.loads(run("--json", *next(iter(SHOWN)).split(), "--explain").stdout)
    assert shown["inputs"] == {"sentence": {"text": "20000 cd at 8 m to lx"}}
    assert [tuple(row.values()) for row in shown["records"]] == SHOWN["20000 cd at 8 m to lx"]


REFUSED = {
    "24 degree beam 800 lm to cd --explain": ("2 readings", "--apex-angle 24degree"),
    "20000 cd at 8 m roughly --explain": ("not understood: roughly", "another word for roughly"),
    "800 lm isotorpic cd --explain": (
        "not understood: isotorpic",
        "try: radcalc 800 lm isotropic cd --explain\n",
    ),
    "convert 100 lx fc --explain": (
        "--explain does not apply to convert",
        "try: radcalc convert 100 lx fc\n     9.2903 fc\n",
    ),
    "--explain": (
        "a sentence is missing",
        "try: radcalc 20000 cd at 8 m to lx\n     312.5 lx, an example\n",
    ),
    "20000 cd at 8 m --explain -n": (
        "-n does not apply to --explain",
        "try: radcalc 20000 cd at 8 m --explain\n",
    ),
    "20000 cd at 8 m --explain --steps": ("--steps does not apply to --explain", "--steps\n"),
}


@for_each(list(REFUSED.items()))
def test_what_is_not_explained_is_refused(words, texts):
    done = run(*words.split())
    assert (done.returncode, done.stdout) == (2, "")
    for text in texts:
        assert text in done.stderr


@pytest.mark.parametrize(
    "option", ["--precision 99", "--format foo", "--color pink", "--precision"]
)
@pytest.mark.parametrize("explain", ["", "--explain "])
def test_a_wrong_option_of_the_output_is_refused(option, explain):
    done = run(*f"20000 cd at 8 m to lx {explain}{option}".split())
    assert (done.returncode, done.stdout) == (2, "")
    assert option.split()[0] in done.stderr
