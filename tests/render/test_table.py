"""Tables on a terminal: their width, their colours, and what stands below them."""

import pytest
from conftest import run
from helpers import screen_of

from radcalc.answer import FRACTION, Result, Row
from radcalc.render import table
from radcalc.render.formats import Style


def test_a_terminal_gets_a_table_with_what_was_assumed_below():
    screen = screen_of("convert", "800", "lm", "cd", "--isotropic", NO_COLOR="1")
    assert "\x1b" not in screen
    assert "quantity" in screen
    assert "luminous intensity" in screen
    assert "63.662" in screen
    assert "assumed: uniform over 4 pi sr (isotropic)" in screen


@pytest.mark.parametrize("columns", [20, 40, 60])
def test_nothing_is_cut_off_on_a_narrow_terminal(columns):
    words = ("convert", "800", "lm", "cd", "--isotropic", "--steps")
    screen = screen_of(*words, columns=columns, NO_COLOR="1")
    assert "…" not in screen
    letters = "".join(screen.split())
    assert "63.662" in letters
    assert "isotropic" in letters


@pytest.mark.parametrize(
    ("words", "environment", "coloured"),
    [
        ((), {}, True),
        ((), {"NO_COLOR": "1"}, False),
        ((), {"TERM": "dumb"}, False),
        (("--color", "always"), {"NO_COLOR": "1"}, True),
        (("--color", "never"), {"FORCE_COLOR": "1"}, False),
        ((), {"NO_COLOR": "1", "FORCE_COLOR": "1"}, False),
        ((), {"TERM": "dumb", "FORCE_COLOR": "1"}, True),
    ],
)
def test_colour_is_decided_by_option_then_environment_then_terminal(words, environment, coloured):
    screen = screen_of("convert", "100", "lx", "fc", *words, **environment)
    assert ("\x1b[" in screen) == coloured


def test_markup_in_what_a_user_typed_is_no_markup():
    screen = screen_of("convert", "1", "lx", "[bold]", NO_COLOR="1")
    assert "[bold]" in screen


def test_a_table_can_be_had_in_a_pipe_and_plain_text_on_a_terminal():
    assert "illuminance" in run("convert", "1", "lx", "fc", "--format", "table").stdout
    assert screen_of("convert", "100", "lx", "fc", "--format", "plain") == "9.290304\tfc\n"
    assert screen_of("convert", "100", "lx", "fc", "-n") == "9.290304\n"


@pytest.mark.parametrize("columns", [15, 28, 40, 80])
def test_a_list_is_a_table_where_its_words_fit_and_lines_elsewhere(columns):
    screen = screen_of("typical", "moon", columns=columns, LC_ALL="C.UTF-8", NO_COLOR="1")
    assert ("───" in screen) == (columns == 80)
    assert all(part in screen for part in ("0.1 to 0.3", "0.0002 to 0.002", "6.418e-5", "cd/m2"))
    longest = len("    0.0002 to 0.002")  # which is not folded
    assert max(len(line) for line in screen.splitlines()) <= max(columns, longest)
    drawn = screen_of("units", columns=80, LC_ALL="C.UTF-8", NO_COLOR="1")
    assert "───" in drawn
    assert "1.602176634e-19" in drawn


def test_no_word_is_folded_where_all_fit():
    screen = screen_of("units", "scales", columns=80, LC_ALL="C.UTF-8", NO_COLOR="1")
    assert "───" in screen
    words = ("Astrophysical", "transmittance", "illuminance")
    assert all(word in screen for word in words)


def test_two_answers_with_the_same_rows_are_a_line_each():
    words = ("point-source", "--intensity", "100cd", "--distance", "1m,2m", "--format", "table")
    lines = run(*words).stdout.splitlines()
    assert lines[0].split()[:4] == ["I_v", "[cd]", "d", "[m]"]
    assert [line.split()[:2] for line in lines[2:4]] == [["100", "1"], ["100", "2"]]


def test_a_row_says_itself_that_its_number_is_read_as_a_fraction():
    row = Row("quelque durée", "t", 1 / 60, "s", form=FRACTION)
    assert "1/60 " in table.results([Result((row,))], Style())
    assert "16.6667 " in table.results(
        [Result((row._replace(value=1e3 / 60, unit="ms"),))], Style()
    )
    assert "1/60" not in table.results([Result((row._replace(form=""),))], Style())


def test_a_table_may_be_as_wide_as_its_room():
    header, cells = ["what", "value"], ["a" * 10, "123"]
    width = 10 + 3 + 5  # the two columns, and what is between them
    head, rule, line = table.draw(header, [cells], [], width, False, right=["value"]).splitlines()
    assert [head.split(), line.split()] == [header, cells]
    assert len(rule) == width
