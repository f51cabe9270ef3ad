"""Calls of very many words are refused at once, with a short message and a short hint."""

import sys

import pytest
from following import call, liars
from helpers import for_each

from radcalc.cli.spelling import Shell

MANY = 5000
SHORT = 300  # characters of a message and of a hint
WORDY = {
    "no words of radcalc": ["foo"] * MANY,
    "letters": ["\N{LATIN SMALL LETTER E WITH ACUTE}"] * MANY,
    "amounts": ["100", "lx"] * MANY,
    "amounts in quotes": ["100 lx "] * MANY,
    "numbers": ["convert"] + ["1"] * MANY,
    "places": ["at 8 m"] * MANY,
    "options": ["100", "lx", "fc"] + ["--distance", "2m"] * MANY,
    "a calculator": ["point-source"] + ["x"] * MANY,
    "a sentence in quotes": [" ".join(["foo"] * MANY)],
    "units in quotes": ["1 " + "m " * MANY],
    "a quotient of units": ["m/" * MANY + "s"],
    "results": ["-g", ",".join(["flux"] * MANY)],
    "names": ["help"] + ["x"] * MANY,
    "things": ["typical"] + ["x"] * MANY,
    "spectra": ["spectrum"] + ["D65x"] * MANY,
    "an explanation": ["--explain"] + ["x"] * MANY,
    "JSON": ["x"] * MANY + ["--json"],
}


def calls_of(words: list[str]) -> int:
    """Count the Python functions that a call runs."""
    count = 0

    def profiled(frame: object, event: str, arg: object) -> None:
        nonlocal count
        count += event == "call"

    sys.setprofile(profiled)
    try:
        call(words)
    finally:
        sys.setprofile(None)
    return count


@pytest.mark.parametrize("name", WORDY)
def test_very_many_words_are_refused_at_once(name):
    words = WORDY[name]
    outcome = call(words)
    assert outcome.error is not None
    assert outcome.status == 2
    message, hint = outcome.error.spelled(Shell)
    assert len(message) <= SHORT
    assert len("\n".join(outcome.hints) or hint) <= SHORT
    assert calls_of(words) < 100 * MANY  # each word may be looked at, but not read in all places
    assert liars(words) == []


ANSWERED = [  # a long sum is not a sentence
    (["100 lx" + " + 1 lx" * 100, "lx"], "200"),
    (["spectrum", *["line:500nm"] * 100, "-g", "peak-wavelength:nm"], "500"),
]


@for_each(ANSWERED)
def test_long_calls_are_answered(words, number):
    assert call(words).output.split()[0] == number
