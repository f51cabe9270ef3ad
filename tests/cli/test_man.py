"""`radcalc manual`: which page is shown, where pages are, and how they are written."""

import pytest
from conftest import run
from helpers import screen_of, terminal_of

from radcalc.calculators import lists
from radcalc.calculators.pages import COMMANDS
from radcalc.cli import man

PAGES = {page.name for page in lists.manual_pages()}


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
    assert [found.name for found in man.find(words)] == [page]
    name, _, section = page.rpartition(".")
    done = run("manual", *words)
    assert done.stdout.splitlines()[1].startswith(f"     {name} - ")
    assert (done.returncode, done.stderr) == (0, "")
    assert f"radcalc-{section}" not in done.stdout


def test_the_other_page_of_a_name_is_mentioned():
    done = run("manual", "units")
    assert done.stdout.startswith(
        "NAME\n     radcalc-units - units, their definitions and sources\n"
    )
    assert done.stderr == (
        "note: radcalc manual 7 units has units, numbers, expressions and scales in radcalc\n"
    )


def test_every_page_has_a_name_and_every_command_its_page_first():
    assert {page.name for name in lists.manual_names() for page in man.find([name])} == PAGES
    for name in COMMANDS:
        assert man.find([name])[0].name == f"radcalc-{name}.1"


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


def test_pages_of_a_wheel_are_in_the_package(monkeypatch, tmp_path):
    package = tmp_path / "radcalc"
    (package / "cli").mkdir(parents=True)
    monkeypatch.setattr(lists, "__file__", str(package / "calculators" / "lists.py"))
    assert lists.manual_folder() == tmp_path / "man"
    (package / "man").mkdir()
    assert lists.manual_folder() == package / "man"


@pytest.mark.parametrize(("columns", "widest"), [(50, 50), (200, 100)])
def test_a_page_is_as_wide_as_the_terminal_up_to_100_columns(columns, widest):
    text = terminal_of("manual", "convert", columns=columns, NO_COLOR="1", PAGER="")
    description = text.partition("DESCRIPTION\n")[2].partition("\nOPTIONS")[0]
    assert widest - 12 < max(map(len, description.splitlines())) <= widest


def test_a_page_is_shown_by_the_pager_of_the_help():
    assert screen_of("manual", "convert", PAGER="sed 's/^/>>/'").startswith(">>NAME")
    coloured = screen_of("manual", "convert", PAGER="")
    assert "\033[1mNAME\033[0m" in coloured
