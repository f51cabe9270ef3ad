"""The page of the validation: its commands have the answers that it shows."""

import re
import runpy

from conftest import ROOT, run

PAGE = (ROOT / "docs" / "validation.md").read_text(encoding="utf-8")
CURRENT = runpy.run_path(str(ROOT / "docs" / "validation.py"))["current"]


def ask(words):
    return run(*words, check=True).stdout


def test_the_answers_and_deviations_are_current():
    assert CURRENT(PAGE, ask) == PAGE


def test_every_command_is_compared():
    commands = re.findall(r"^\| .*\| `radcalc .*$", PAGE, re.M)
    assert len(commands) >= 50
    assert all(
        row.endswith(" |") and re.search(r"\| \**(0|[-+].* %)\** \|$", row) for row in commands
    )


def test_a_deviation_beyond_the_printed_digits_is_bold():
    """1 fc is 10.7639 lx, by the definition of the foot: 10.76 is rounded, 10.7 is wrong."""
    rows = "| 10.76 lx | | `radcalc 1 fc lx` |\n| 10.7 lx | | `radcalc 1 fc lx` |"
    rounded, wrong = CURRENT(rows, ask).splitlines()
    assert rounded.endswith("| 10.76391 | +0.04 % |")
    assert wrong.endswith("| 10.76391 | **+0.6 %** |")
