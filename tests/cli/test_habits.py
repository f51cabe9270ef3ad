"""Words of other tools: --from and --to, GNU units' two units, and pipes without a -."""

import subprocess
import sys

import pytest
from conftest import python
from helpers import for_each

from radcalc.cli import spelling
from radcalc.errors import UsageError

PIPED = [  # with standard input from a pipe: what is typed, and the call that it means
    ("to fc", "convert - fc"),
    ("in fc", "convert - fc"),
    ("-> fc", "convert - fc"),
    ("--to fc", "convert - fc"),
    ("--to=fc -q", "convert - fc -q"),
    ("--from lx --to fc", "convert - lx fc"),
    ("convert fc", "convert - fc"),
    ("convert to fc", "convert - fc"),
    ("convert lx fc", "convert - lx fc"),
    ("convert lx to fc", "convert - lx fc"),
    ("convert lx illuminance", "convert - lx illuminance"),
    ("convert ppfd lx --spectrum sun", "convert - ppfd lx --spectrum sun"),
    ("convert - --from lx --to fc", "convert - lx fc"),
    ("convert - ft --from m", "convert - m ft"),
    ("- to ft --from=m", "convert - m ft"),
    ("--from m ft", "convert - m ft"),
    ("footcandle lx", "convert 1 footcandle lx"),
    ("in cm", "convert 1 in cm"),
]
ALONE = [  # without a pipe
    ("footcandle lx", "convert 1 footcandle lx"),
    ("footcandle to lx", "convert 1 footcandle lx"),
    ("convert footcandle lx", "convert 1 footcandle lx"),
    ("W/m2 ppfd --wavelength 555nm", "convert 1 W/m2 ppfd --wavelength 555nm"),
    ("mired K", "convert 1 mired K"),
    ("convert 500 --from lx --to fc", "convert 500 lx fc"),
    ("convert --from lx --to fc 500", "convert 500 lx fc"),
    ("convert --to=fc --from=lx 500", "convert 500 lx fc"),
    ("500 --from lx --to fc -n", "convert 500 lx fc -n"),
    ("500 lx --to fc", "convert 500 lx to fc"),
    ("500 --from lx", "convert 500 lx"),
    ("10 to ft --from m", "convert 10 m ft"),
    ("10 --to ft m", "convert 10 m to ft"),
    ("-30 mW --to uW", "convert -30 mW to uW"),
    ("convert --from lx --to fc", "convert 1 lx fc"),
    ("to fc", "convert to fc"),
    ("--to fc", "convert to fc"),
]
OTHERS = ["", "500 lx fc", "convert 500 lx fc", "convert", "convert - lx fc", "lux", "units lux",
          "photon 555nm", "point-source --from 3", "--help", "--version", "to foo", "foo lx",
          "convert foo lx", "convert 500 --from lx --to", "solid-angle cone", "help convert",
          "convert log.csv", "spectrum D65"]  # fmt: skip


@pytest.fixture(autouse=True)
def quiet(monkeypatch):
    monkeypatch.setattr(spelling, "say", lambda words: None)


@for_each(PIPED)
def test_a_call_with_a_pipe(typed, meant):
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(spelling, "is_piped", lambda: True)
        assert spelling.canonical(typed.split()) == meant.split()


@for_each(ALONE)
def test_a_call_without_a_pipe(typed, meant):
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(spelling, "is_piped", lambda: False)
        found = spelling.canonical(typed.split())
    assert found == meant.split()


@for_each(OTHERS)
def test_other_calls_are_as_they_were(typed):
    for piped in (True, False):
        with pytest.MonkeyPatch.context() as patched:
            patched.setattr(spelling, "is_piped", lambda piped=piped: piped)
            assert spelling.canonical(typed.split()) == typed.split()


TWO_UNITS = {  # calls with another unit next to --from, and the calls that their hints propose
    "10 ft --from m": ["convert 10 m ft", "convert 10 ft to m"],
    "500lx fc --from fc": ["convert 500lx fc"],
    "500lx --from fc": ["convert 500lx to fc"],
    "10 m ft --from s": ["convert 10 m ft"],
    "- m ft --from s": ["convert - m ft"],
    "m ft --from s": ["convert m ft"],
    "- --from m": ["convert 1 m"],
}


@for_each(TWO_UNITS)
def test_two_units_are_refused(typed):
    with pytest.raises(UsageError) as caught:
        spelling.canonical(typed.split())
    assert [" ".join(one.words) for one in caught.value.tries] == TWO_UNITS[typed]


def radcalc(words: str, given: str | None) -> subprocess.CompletedProcess[str]:
    stdin = {"input": given} if given is not None else {"stdin": subprocess.DEVNULL}
    return subprocess.run(
        [sys.executable, "-m", "radcalc", *words.split()],
        capture_output=True, text=True, timeout=60, **stdin,
    )  # fmt: skip


def test_the_kind_of_standard_input_decides():
    # 1 fc is 10.7639104167 lx: 1 ft2 is 0.09290304 m2 exactly
    done = radcalc("to fc", "500 lux\n")
    assert (done.stdout, done.stderr) == ("46.45152\tfc\n", "read as: radcalc convert - fc\n")
    assert radcalc("convert lx fc -q", "100\n200\n").stdout == "9.290304\n18.580608\n"
    done = radcalc("convert footcandle lx", None)
    assert done.stdout == "10.7639104167\tlx\n"
    assert done.stderr == "read as: radcalc convert 1 footcandle lx\n"
    done = radcalc("to fc", None)
    assert done.returncode == 2
    assert "try: radcalc convert - fc\n" in done.stderr


def test_the_unit_of_from_is_that_of_the_value():
    # 1 ft is 0.3048 m exactly
    assert radcalc("convert - ft --from m -q", "3.048\n").stdout == "10\n"


def test_two_units_before_a_pipe_are_a_value_or_the_units_of_its_lines():
    # the pipe stays open: a reader of it would never end
    code = (
        "import os, subprocess, sys; r, w = os.pipe(); "
        "done = subprocess.run([sys.executable, '-m', 'radcalc', 'footcandle', 'lx', '-n'], "
        "stdin=r, timeout=30, capture_output=True); print(done.returncode, done.stderr.decode())"
    )
    refused = python(code).stdout
    assert refused.startswith("2 radcalc: standard input is a pipe")
    assert "try: radcalc convert - footcandle lx\nor:  radcalc convert 1 footcandle lx" in refused
    assert radcalc("lux fc -q", "100\n200\n").stdout == "9.290304\n18.580608\n"
    assert radcalc("footcandle lx -n", "").stdout == "10.7639104167\n"
