"""The two lengths of help, and help and messages in narrow and wide terminals."""

import os
import re
import shlex
import shutil
from functools import cache
from itertools import product

import click
import pytest
from conftest import process, run
from helpers import for_each, screen_of, terminal_of

from radcalc.calculators import COMMANDS
from radcalc.cli.command import commands
from radcalc.cli.spelling import GROUPS
from radcalc.terminal import CALLS, fold

WIDTHS = (60, 80, 120)


@cache
def command_of(name):
    return commands.get_command(click.Context(commands), name) if name else commands


def help_of(name, width):
    own = command_of(name)
    with click.Context(own, info_name=f"radcalc {name}".strip(), terminal_width=width) as context:
        return own.get_help(context)


def short_help_of(name):
    return run(*name.split(), "-h").stdout


def in_section(text, title):
    """Return the lines of a section of a short help."""
    return text.partition(f"\n{title}:\n")[2].partition("\n\n")[0].split("\n")


def examples_of(text):
    lines = re.sub(r"\\\n +", "", "\n".join(in_section(text, "Examples"))).split("\n")
    return [line.strip().partition("  ")[0] for line in lines]


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
    "point-source --flux 800lm --distance 2m -g illuminance --steps -n",
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


@for_each(["", *COMMANDS])
def test_the_short_help_is_one_screen_with_a_few_examples(name):
    text = short_help_of(name)
    lines = text.removesuffix("\n").split("\n")
    assert len(lines) < 24  # the prompt is the last of them
    assert max(map(len, lines)) <= 80
    assert lines[0].startswith(f"Usage: radcalc {name}".rstrip())
    assert lines[-1] == f"more: {' '.join(['radcalc', name]).strip()} --help"
    assert 1 <= len(examples_of(text)) <= 5


@for_each(COMMANDS)
def test_an_option_of_the_short_help_has_one_line_and_is_in_the_complete_help(name):
    rows = in_section(short_help_of(name), "Options")
    rows = rows[: rows.index(f"more: radcalc {name} --help")]
    visible = sum(len(group) for group in command_of(name).sections.values())
    assert min(5, visible) <= len(rows) <= 13
    words = help_of(name, 1000).replace(",", " ").split()
    for row in rows:
        spellings = re.findall(r"(?<= )--?[a-z][a-z0-9-]*", row[:29])
        assert row.startswith("  -"), row
        assert {*spellings} <= {*words}
        assert len(row.split("  ")) > 2, row  # with its meaning


@for_each(["", *COMMANDS])
def test_an_example_of_the_short_help_is_in_the_complete_help(name):
    complete = " ".join(help_of(name, 1000).split())
    assert [line for line in examples_of(short_help_of(name)) if line not in complete] == []


@for_each(COMMANDS)
def test_the_results_and_the_check_are_in_the_short_help_if_the_command_has_them(name):
    spellings = {o for option in command_of(name).params for o in option.opts}
    text = short_help_of(name)
    assert [o for o in ("--get", "--check", "--json") if o in spellings and o not in text] == []


def test_the_examples_of_the_short_help_run(tmp_path, monkeypatch):
    """An example stops only at a file that is not here, such as room.hdr."""
    shutil.copy("examples/downlight.ies", tmp_path / "lamp.ies")
    for file in ("log.csv", "lux.csv", "sensors.csv"):
        rows = "".join(f"2024-06-01T{hour:02}:00Z,{100 * hour}\n" for hour in range(6))
        (tmp_path / file).write_text(f"time,E [lx]\n{rows}")
    monkeypatch.chdir(tmp_path)
    count = 0
    for name in ("", *COMMANDS):
        for line in examples_of(short_help_of(name)):
            call, _, source = line.partition(" > ")[0].partition(" < ")
            program, *words = shlex.split(call)
            if program != "radcalc" or not words:  # the prompt
                continue
            given = (
                ("time,E\n0,100\n" if "--column" in words else "0 100\n60 100\n") if source else ""
            )
            done = run(*words, input=given)
            missing = re.search("[Nn]o (such )?file", done.stderr)
            assert done.returncode == 0 or missing, (line, done.stderr)
            count += done.returncode == 0
    assert count > 80


def test_the_groups_have_every_command_once():
    listed = [name for names in GROUPS.values() for name in names]
    assert sorted(listed) == sorted({*listed}) == sorted(COMMANDS)
    text = help_of("", 80)
    assert all(f"\n{title}:\n" in text for title in GROUPS)


@pytest.mark.parametrize("thing", [".ies", ".ldt", ".hdr", "CSV", "PAR meter"])
def test_the_help_names_what_people_own(thing):
    assert thing in help_of("", 80)


PAGED = "PAGED: "


def test_the_complete_help_is_paged_on_a_terminal_if_it_is_long():
    pager = f"sed 's/^/{PAGED}/'"
    assert screen_of("convert", "--help", PAGER=pager).startswith(f"{PAGED}Usage")
    assert screen_of("help", "convert", PAGER=pager).startswith(f"{PAGED}Usage")
    for words in (("convert", "-h"), ("100", "lx", "fc")):
        assert PAGED not in screen_of(*words, PAGER=pager)
    assert PAGED not in screen_of("convert", "--help", PAGER=pager, LINES="500")


@pytest.mark.parametrize(
    "environment",
    [{"PAGER": ""}, {"PAGER": "cat"}, {"PAGER": "no-such-pager"}, {"PAGER": "less 'x"}]
    + [{"PAGER": f"sed 's/^/{PAGED}/'", "TERM": term} for term in ("dumb", "")],
)
def test_the_help_is_written_without_a_pager(environment):
    screen = screen_of("convert", "--help", **environment)
    assert re.match(r"(\x1b\[1m)?Usage:", screen)
    assert screen.endswith("Manual: radcalc manual convert\n")


def test_the_help_in_a_pipe_is_not_paged():
    environment = os.environ | {"PAGER": f"sed 's/^/{PAGED}/'"}
    assert process("convert", "--help", env=environment).stdout.startswith("Usage:")


def test_a_pager_that_shows_colours_gets_them(tmp_path):
    less = tmp_path / "less"
    less.write_text('#!/bin/sh\nsed "s/^/PAGED: $LESS /"\n')
    less.chmod(0o755)
    path = f"{tmp_path}{os.pathsep}{os.environ['PATH']}"
    screen = screen_of("convert", "--help", PAGER="less", PATH=path, LESS="")
    assert screen.startswith(f"{PAGED}-R \x1b[1mUsage:\x1b[0m ")
    plain = screen_of("convert", "--help", PAGER="less", PATH=path, LESS="", NO_COLOR="1")
    assert plain.startswith(f"{PAGED} Usage:")
