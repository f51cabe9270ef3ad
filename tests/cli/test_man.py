"""`radcalc manual`: which page is shown, where pages are, and which program shows them."""

import os
import shutil
import sys

import pytest
from conftest import ROOT, run
from helpers import require, screen_of

from radcalc.calculators import COMMANDS, lists
from radcalc.cli.lists import find_pages

PAGES = {page.name for page in lists.manual_pages()}
OTHER = "radcalc manual 7 units has units, numbers, expressions and scales in radcalc"


@pytest.mark.parametrize(
    ("words", "page"),
    [
        ([], "radcalc.1"),
        (["radcalc"], "radcalc.1"),
        (["convert"], "radcalc-convert.1"),
        (["Solid", "angle"], "radcalc-solid-angle.1"),
        (["radcalc-convert"], "radcalc-convert.1"),
        (["sentences"], "radcalc-sentences.7"),
        (["1", "units"], "radcalc-units.1"),
        (["7", "units"], "radcalc-units.7"),
        (["7", "radcalc-units"], "radcalc-units.7"),
    ],
)
def test_a_page_is_found(words, page):
    assert [found.name for found in find_pages(words)] == [page]


def test_every_page_has_a_name_and_every_command_its_page_first():
    assert {page.name for name in lists.manual_names() for page in find_pages([name])} == PAGES
    for name in COMMANDS:
        assert find_pages([name])[0].name == f"radcalc-{name}.1"


@pytest.mark.parametrize(
    ("words", "problem", "hint"),
    [
        (["covnert"], "the manual has no page 'covnert'", "radcalc manual convert"),
        (["xyzzy"], "the manual has no page 'xyzzy'", "radcalc manual"),
        (
            ["7", "convert"],
            "section 7 of the manual has no page 'convert'",
            "radcalc manual convert",
        ),
        (["7"], "section 7 of the manual has no page 'radcalc'", "radcalc manual radcalc"),
        (["convert\x1b[2J"], r"the manual has no page 'convert\x1b[2J'", "radcalc manual convert"),
    ],
)
def test_an_unknown_page_is_refused(words, problem, hint):
    done = run("manual", *words)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.splitlines()[:2] == [f"radcalc: {problem}", f"try: {hint}"]


def test_an_installation_without_pages_is_refused(monkeypatch, tmp_path):
    monkeypatch.setattr(lists, "manual_folder", lambda: tmp_path)
    done = run("manual", "convert")
    assert done.returncode == 2
    assert done.stderr.startswith("radcalc: cannot read '/")
    assert ": it has no pages\n" in done.stderr


def test_pages_are_in_the_package_next_to_it_or_where_man_looks(monkeypatch, tmp_path):
    package = tmp_path / "radcalc"
    monkeypatch.setattr(lists, "__file__", str(package / "calculators" / "lists.py"))
    monkeypatch.setattr(sys, "prefix", str(tmp_path / "prefix"))
    assert lists.manual_folder() == package / "man"  # the place that a refusal names
    for place in (tmp_path / "prefix" / "share" / "man", tmp_path / "man", package / "man"):
        (place / "man1").mkdir(parents=True)
        (place / "man1" / "radcalc.1").touch()
        assert lists.manual_folder() == place


@pytest.fixture
def only(monkeypatch, tmp_path):
    """Let only the named programs be found."""

    def links(*tools):
        require(*tools)
        for tool in tools:
            (tmp_path / tool).symlink_to(shutil.which(tool))
        monkeypatch.setenv("PATH", str(tmp_path))

    return links


def test_in_a_pipe_mandoc_prints_plain_text(only):
    only("mandoc")
    done = run("manual", "units")
    assert "NAME\n     radcalc-units " in done.stdout
    assert not {"\b", "\033"} & set(done.stdout)
    assert (done.returncode, done.stderr) == (0, f"note: {OTHER}\n")


def test_man_shows_a_page_and_comes_before_mandoc(monkeypatch, tmp_path):
    shown = tmp_path / "man"
    shown.write_text('#!/bin/sh\ntest -f "$1" && echo "S\bShown: $1"\n')
    shown.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")
    page = ROOT / "man" / "man1" / "radcalc-ev.1"
    assert run("manual", "ev").stdout == f"Shown: {page}\n"
    screen = screen_of("manual", "ev")  # of the installed command; man looks after the terminal
    assert screen.startswith("S\bShown: ")
    assert screen.endswith("man1/radcalc-ev.1\n")
    shown.write_text("#!/bin/sh\nexit 1\n")
    require("mandoc")
    assert "NAME\n     radcalc-ev " in run("manual", "ev").stdout


def test_without_man_the_path_and_the_help_are_printed(only):
    only()
    missing = "note: neither man nor mandoc is available: this is the path of the page\n"
    done = run("manual", "units")
    path, _, text = done.stdout.partition("\n\n")
    assert path == str(ROOT / "man" / "man1" / "radcalc-units.1")
    assert text == run("units", "--help").stdout
    assert (done.returncode, done.stderr) == (0, f"{missing}note: {OTHER}\n")
    assert run("manual").stdout.partition("\n\n")[2] == run("--help").stdout
    done = run("manual", "7", "units")
    assert done.stdout == f"{ROOT / 'man' / 'man7' / 'radcalc-units.7'}\n"
    assert (done.returncode, done.stderr) == (0, missing)
