"""The help, called by its option or by its name."""

import pytest
from conftest import run

from radcalc.cli import COMMANDS


@pytest.mark.parametrize("name", COMMANDS)
def test_help_of_a_command_is_its_help(name):
    done = run("help", name)
    assert done.stdout == run(name, "--help").stdout
    assert done.stdout.startswith(f"Usage: radcalc {name} ")
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("words", [["help"], ["help", "--help"], ["help", "-h"], ["-h"]])
def test_help_alone_is_that_of_radcalc(words):
    assert run(*words).stdout == run("--help").stdout
