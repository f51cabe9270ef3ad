"""The manual page and the command line say the same."""

import os
import re
import shutil
import subprocess

import click
import pytest
from conftest import ROOT

from radcalc.cli import commands, manual

PAGE = ROOT / "man" / "radcalc.1"
SHARED = "Options of every command"
OF_CALCULATORS = "Options of every calculator"
OF_STREAMS = "Options of every stream"


def mandoc(*words: str) -> subprocess.CompletedProcess[str]:
    if not shutil.which("mandoc"):
        (pytest.fail if os.environ.get("CI") else pytest.skip)("mandoc is not installed")
    return subprocess.run(
        ["mandoc", *words, str(PAGE)], capture_output=True, text=True, encoding="utf-8", timeout=60
    )


def contexts() -> dict[str, click.Context]:
    """Each command by the words that call it, `radcalc` itself included."""
    top = click.Context(commands, info_name="radcalc", **commands.context_settings)
    found = {"radcalc": top}
    for name in commands.list_commands(top):
        command = commands.get_command(top, name)
        assert command is not None
        found[f"radcalc {name}"] = click.Context(
            command, info_name=name, parent=top, **command.context_settings
        )
    return found


CONTEXTS = contexts()


def options(context: click.Context) -> list[click.Option]:
    return [p for p in context.command.get_params(context) if isinstance(p, click.Option)]


def spellings(context: click.Context) -> set[str]:
    return {s for option in options(context) for s in (*option.opts, *option.secondary_opts)}


@pytest.fixture(scope="module")
def page() -> str:
    """The rendered page without overstrikes, too wide for a word to be broken."""
    done = mandoc("-T", "utf8", "-O", "width=500")
    assert done.returncode == 0, done.stderr
    return re.sub(".\b", "", done.stdout)


@pytest.mark.parametrize("called", CONTEXTS)
def test_every_command_and_every_option_has_help(called):
    context = CONTEXTS[called]
    assert context.command.help
    assert [option.opts for option in options(context) if not option.help] == []


@pytest.mark.parametrize("width", [20, 40, 80, 100])
def test_the_help_lists_the_commands_as_click_would_if_it_imported_them(width):
    ours, clicks = (click.HelpFormatter(width=width) for _ in range(2))
    commands.format_commands(CONTEXTS["radcalc"], ours)
    click.Group.format_commands(commands, CONTEXTS["radcalc"], clicks)
    assert ours.getvalue() == clicks.getvalue()
    assert "convert" in ours.getvalue()


def described(page: str, title: str) -> set[str]:
    """The options that are items of a list in one section of the page."""
    section = re.search(rf"^ *{title}\n(.*?)^ {{0,3}}\S", page, re.M | re.S)
    assert section, f"the manual has no section '{title}'"
    items = re.findall(r"^ {5}((?:--?[\w-]+(?:, )?)+)", section[1], re.M)
    return {spelling for item in items for spelling in item.split(", ") if spelling}


@pytest.mark.parametrize("called", CONTEXTS)
def test_the_manual_describes_every_option_of_every_command_and_no_other(called, page):
    if called == "radcalc":
        found = described(page, "COMMANDS")
    else:
        found = described(page, called) | described(page, SHARED)
        if "--get" in spellings(CONTEXTS[called]):
            found |= described(page, OF_CALCULATORS)
        if "--rename" in spellings(CONTEXTS[called]):
            found |= described(page, OF_STREAMS)
    assert found == spellings(CONTEXTS[called])


def test_every_option_named_in_the_manual_exists(page):
    named = set(re.findall(r"(?<![\w-])--[a-z][\w-]*", page))
    assert named - set().union(*map(spellings, CONTEXTS.values())) == set()


def test_the_lists_of_options_are_those_of_the_commands():
    source = PAGE.read_text(encoding="utf-8")
    assert source == manual.rewritten(source)  # python -m radcalc.cli.manual man/radcalc.1


def test_every_command_with_options_of_its_own_has_a_block_of_them():
    marked = [found[2] for found in manual.BLOCK.finditer(PAGE.read_text(encoding="utf-8"))]
    names = [called.removeprefix("radcalc ") for called in CONTEXTS]
    own = [name for name in names if manual.sections_of(name)]
    assert sorted(marked) == sorted([*own, "every command", "every calculator", "every stream"])


def test_the_lists_of_a_command_have_the_titles_of_its_help(page):
    section = re.search(r"^ *radcalc point-source\n(.*?)^ {0,3}\S", page, re.M | re.S)
    assert section
    titles = re.findall(r"^ {5}([A-Z][\w ]+):$", section[1], re.M)
    assert titles == ["Light", "Its directions", "The receiver", "Kinds of light"]


def test_the_parts_of_an_argument_are_told_apart():
    item = manual.BLOCK.search('.\\" options of every calculator\n.\\" end of options\n')
    assert item
    written = manual.rewritten(item[0])
    assert ".It Fl g , Fl -get Ar NAME Ns Oo : Ns Ar UNIT Oc\n" in written
    assert ".It Fl -check Oo Ar NAME Ns = Oc Ns Ar VALUE Ns Oo Ar UNIT Oc\n" in written


def test_the_manual_is_clean_mdoc():
    done = mandoc("-T", "lint", "-W", "warning")
    assert (done.returncode, done.stdout) == (0, "")
