"""The README's comparison with other calculators, checked by running each of them."""

import os
import re
import subprocess
from functools import cache

import pint
import pytest
from conftest import ROOT, run
from helpers import require

SECTION = (ROOT / "README.md").read_text("utf-8").partition("## How other tools answer\n")[2]
ABOUT, _, TABLE = SECTION.partition("\n\n| question ")
ROWS = [line.strip("| ").split(" | ") for line in TABLE.split("\n\n")[0].splitlines()[2:]]
TOOLS = ("units", "qalc", "Pint")  # in the order of the columns
VERSIONS = dict(
    re.findall(r"(units|qalc) ([\d.]+\d)", ABOUT)
)  # of the tools whose answers depend on it
REGISTRY = cache(pint.UnitRegistry)  # Pint's own units, without radcalc's
EXPONENTS = str.maketrans({"²": "**2", "µ": "u"})
PLAIN = str.maketrans({"²": "2", "µ": "u"})


def codes(cell):
    """Return the code spans of a cell."""
    return re.findall(r"`(.*?)`", cell)


def said(*words, home):
    """Return the output of a command, both streams together."""
    env = os.environ | {"HOME": str(home), "QALCULATE_USER_DIR": str(home), "LC_ALL": "C.UTF-8"}
    done = subprocess.run(
        words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", env=env
    )
    return done.stdout.strip()


def asked(tool, source, target, home):
    """Return the version and the answer of another calculator."""
    if tool == "units":
        found = said("units", "--version", home=home).split()[3]
        return found, said("units", "-1", "-t", source, target.translate(PLAIN), home=home)
    if tool == "qalc":
        found = said("qalc", "--version", home=home)
        return found, said("qalc", "-t", f"{source} to {target.translate(PLAIN)}", home=home)
    try:
        found = REGISTRY()(source.translate(EXPONENTS)).to(target.translate(EXPONENTS))
    except pint.PintError as error:
        return "", f"{type(error).__name__}: {error}"
    return "", str(found)


def test_the_table_is_read():
    assert len(ROWS) == 5
    assert VERSIONS.keys() == {"units", "qalc"}


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[0])
@pytest.mark.parametrize("tool", TOOLS)
def test_another_calculator_answers_as_in_the_table(tool, row, tmp_path):
    if tool != "Pint":
        require(tool)
    source, target = codes(row[0])
    found, answer = asked(tool, source, target, tmp_path)
    if not found.startswith(VERSIONS.get(tool, "")):
        pytest.skip(f"the table is about {tool} {VERSIONS[tool]}, and this is {found}")
    cell = row[1 + TOOLS.index(tool)]
    (expected,) = codes(cell)
    if cell.startswith("refused: "):
        assert expected in answer
    else:
        assert answer == expected


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[0])
def test_radcalc_answers_as_in_the_table(row):
    words = [text.translate(PLAIN) for text in codes(row[0])]
    *option, expected = codes(row[4])
    if option:
        refused = run(*words[0].split(), words[1])
        needed = re.findall(r"asks for a ([\w ]+):", row[4])[0]
        assert refused.returncode == 2
        assert needed in refused.stderr
        assert option[0].split()[0] in refused.stderr
    done = run(*words[0].split(), words[1], *" ".join(option).split(), "-q")
    assert done.stdout.split() == expected.split()
