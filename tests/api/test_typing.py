"""Type checks of programs that use radcalc."""

import re
from typing import get_args

from conftest import ROOT, python
from mypy import api as mypy

from radcalc.api import columns
from radcalc.calculators.shapes import SHAPES
from radcalc.calculators.solid_angle import NAMES
from radcalc.quantities.symbols import SYMBOLS

PROGRAMS = ROOT / "tests" / "api"
CLIENT, MISTAKES = PROGRAMS / "client.py", PROGRAMS / "mistakes.py"


def errors_of(*paths):
    """Return the lines of the errors that mypy finds, by file name."""
    said, problem, _ = mypy.run(["--strict", "--no-error-summary", *map(str, paths)])
    assert not problem
    found = re.findall(r"^(?:.*/)?(\w+\.py):(\d+): error:", said, re.MULTILINE)
    return [(name, int(line)) for name, line in found]


def test_a_program_is_accepted_and_one_with_six_mistakes_refused_at_each():
    lines = MISTAKES.read_text(encoding="utf-8").splitlines()
    marked = [k for k, line in enumerate(lines, start=1) if "# mistake: " in line]
    assert len(marked) == 6
    assert errors_of(CLIENT, MISTAKES) == [(MISTAKES.name, line) for line in marked]


def test_the_program_that_is_accepted_runs():
    """800 lm give 800 lm / (4 pi sr) / (1 m)^2 = 63.66 lx, or 5.914 fc, at 1 m."""
    done = python(CLIENT.read_text(encoding="utf-8"))
    assert done.stdout.startswith("[5.914"), done.stderr


def test_choices_are_those_of_the_vocabulary_and_of_the_calculators():
    for name, symbol in SYMBOLS.items():
        if symbol.choices and name != "distribution":
            named = "".join(map(str.capitalize, name.split("-")))
            assert get_args(getattr(columns, named)) == symbol.choices
    assert set(get_args(columns.Shape)) == set(NAMES)
    assert set(get_args(columns.Diffuse)) == set(SHAPES)
