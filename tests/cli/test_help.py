"""Help and messages in narrow and wide terminals."""

import re
import shlex
from functools import cache
from itertools import product

import click
import pytest
from helpers import for_each, terminal_of

from radcalc.cli.group import commands
from radcalc.cli.names import COMMANDS
from radcalc.terminal import CALLS, fold

WIDTHS = (60, 80, 120)


@cache
def command_of(name):
    return commands.get_command(click.Context(commands), name) if name else commands


def help_of(name, width):
    own = command_of(name)
    with click.Context(own, info_name=f"radcalc {name}".strip(), terminal_width=width) as context:
        return own.get_help(context)


@for_each(product(["", *COMMANDS], WIDTHS))
def test_no_line_is_wider_than_the_terminal(name, width):
    lines = help_of(name, width).split("\n")
    assert [line for line in lines if len(line) > width] == []


@for_each(product(["", *COMMANDS], WIDTHS))
def test_the_words_are_the_same_in_every_width(name, width):
    def words(text):
        text = re.sub(r" \\\n", " ", text)  # an example goes on
        text = re.sub(r"\|\n +", "|", text)  # choices
        return sorted(text.split())

    assert words(help_of(name, width)) == words(help_of(name, 1000))


@for_each(COMMANDS)
def test_every_option_shown_is_on_one_line(name):
    text = help_of(name, 60).split()
    for option in command_of(name).params:
        if isinstance(option, click.Option) and not option.hidden:
            assert any(word.rstrip(",") == option.opts[-1] for word in text), option.opts


@for_each(COMMANDS)
def test_an_example_over_several_lines_is_the_same_command(name):
    def examples(width):
        text = help_of(name, width).replace("\\\n", " ")
        lines = [line.partition("  (")[0].strip() for line in text.split("\n")]
        return [shlex.split(line) for line in lines if line.startswith("radcalc ")]

    narrow, wide = ([words[:3] for words in examples(width)] for width in (60, 1000))
    assert narrow == wide


@pytest.mark.parametrize("name", ["units", "quantities", "typical"])
def test_an_option_that_is_always_refused_is_not_in_the_help(name):
    text = help_of(name, 80)
    assert "--number" not in text
    assert "--precision" not in text


MESSAGES = [
    "convert 800 lm cd",
    "convert 100 lux furlong",
    "lambertian --luminance 100cd/m2 --check exitance=628lm/m2",
    "point-source --flux 800lm --distance 2m -g illuminance --steps",
    "convert 5 mW lm --wavelength 632.8nm -n",
]


@pytest.mark.parametrize("width", [24, 60])
@pytest.mark.parametrize("typed", MESSAGES)
def test_a_message_on_a_terminal_is_folded_between_its_words(typed, width):
    words = shlex.split(typed)
    wide, narrow = (terminal_of(*words, columns=columns, NO_COLOR="1") for columns in (500, width))
    assert narrow.split() == wide.split()
    lines = [line for line in narrow.split("\n") if len(line) > width]
    lines = [line for line in lines if not line.startswith(CALLS)]  # which are pasted
    assert all(len(line.split()) == 1 for line in lines)  # a word is not cut


def test_a_message_that_fits_is_unchanged():
    line = "    a line  with   blanks"
    assert fold(line, 25) == [line]
    assert fold("note: one two", 9, 4) == ["note: one", "    two"]
