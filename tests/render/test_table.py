"""Tables on a terminal: width, colours, and the lines below them."""

import os
import random
import re
from itertools import product

import pytest
from conftest import process, run
from helpers import answers, for_each, screen_of, terminal_of

from radcalc.answer import FRACTION, Result, Row
from radcalc.quantities.language import translate
from radcalc.render import table
from radcalc.render.formats import Style


def test_a_terminal_gets_a_table_with_assumptions_below():
    screen = screen_of("convert", "800", "lm", "cd", "--isotropic", NO_COLOR="1")
    assert "\x1b" not in screen
    assert "quantity" in screen
    assert "luminous intensity" in screen
    assert "63.662" in screen
    assert "assumed: uniform over 4 pi sr (isotropic)" in screen


@pytest.mark.parametrize("columns", [20, 40, 60])
def test_nothing_is_cut_off_on_a_narrow_terminal(columns):
    words = ("convert", "800", "lm", "cd", "--isotropic", "--steps")
    screen = terminal_of(*words, columns=columns, NO_COLOR="1")
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
    screen = terminal_of("convert", "100", "lx", "fc", *words, **environment)
    assert ("\x1b[" in screen) == coloured


def test_markup_in_user_text_is_not_interpreted():
    screen = screen_of("convert", "1", "lx", "[bold]", NO_COLOR="1")
    assert "[bold]" in screen


def test_format_options_override_the_terminal():
    assert "illuminance" in run("convert", "1", "lx", "fc", "--format", "table").stdout
    assert screen_of("convert", "100", "lx", "fc", "--format", "plain") == "9.290304\tfc\n"
    assert screen_of("convert", "100", "lx", "fc", "-n") == "9.290304\n"


@pytest.mark.parametrize("columns", [15, 28, 40, 80])
def test_a_list_is_a_table_if_its_words_fit_and_lines_otherwise(columns):
    screen = terminal_of("typical", "moon", columns=columns, LC_ALL="C.UTF-8", NO_COLOR="1")
    assert ("───" in screen) == (columns == 80)
    assert all(part in screen for part in ("0.1 to 0.3", "0.0005 to 0.001", "6.418e-5", "cd/m2"))
    longest = len("    0.0005 to 0.001")  # this is not folded
    assert max(len(line) for line in screen.splitlines()) <= max(columns, longest)
    drawn = terminal_of("units", columns=80, LC_ALL="C.UTF-8", NO_COLOR="1")
    assert "───" in drawn
    assert "1.602176634e-19" in drawn


def test_no_word_is_folded_where_all_fit():
    screen = terminal_of("units", "scales", columns=80, LC_ALL="C.UTF-8", NO_COLOR="1")
    assert "───" in screen
    words = ("Astrophysical", "transmittance", "illuminance")
    assert all(word in screen for word in words)


@for_each(product(range(36, 64), ["en", "cs", "ru"]))
def test_words_of_names_are_parted_at_slashes_only(columns, language):
    """A word of a name ends at a blank; a part of it ends at a slash."""
    names = ("scotopic/photopic ratio", "correlated colour temperature", "lux per PPFD")
    rows = tuple(Row(name, "T_cp", 0.000600783, "lm.s/umol") for name in names)
    words = {
        word
        for name in (*names, "quantity")
        for text in translate(name, language).split()
        for word in (text, *text.replace("/", "/ ").split())
    }
    shown = table.results([Result(rows)], Style(width=columns, language=language))
    seen = {word for word in shown.split() if word[0].isalpha()}
    assert seen - {"symbol", "value", "unit", "T_cp", "lm.s/umol"} <= words
    assert max(map(len, shown.splitlines())) <= columns


def test_two_answers_with_the_same_rows_are_a_line_each():
    words = ("point-source", "--intensity", "100cd", "--distance", "1m,2m", "--format", "table")
    given, each, head, _, *lines = run(*words).stdout.splitlines()
    assert given == "given: luminous intensity 100 cd"
    assert "luminous flux 1256.64 lm · incidence 0 deg" in each  # 400 pi
    assert head.split() == ["d", "[m]", "E_v", "[lx]"]
    assert [line.split() for line in lines[:2]] == [["1", "100"], ["2", "25"]]


def test_shared_rows_are_shown_once_in_tables_only():
    words = ("point-source", "--intensity", "100cd", "--exponent", "2", "--distance", "1m,2m")
    drawn = run(*words, "--format", "table").stdout
    assert "given: luminous intensity 100 cd · exponent 2\n" in drawn
    assert drawn.count("exponent") == 1
    assert [
        one["results"]["exponent"]["value"] for one in answers(run(*words, "--json").stdout)
    ] == [
        2.0,
        2.0,
    ]
    alike = run("convert", "1lx,1lx", "fc", "--format", "table").stdout  # in all rows
    assert alike.count("0.092903") == 2
    asked = ("-g", "illuminance", "-g", "flux", "--format", "table", "-q")
    assert run(*words[:-2], "--distance", "1m,1m", *asked).stdout.count("100") == 2


def test_a_constant_column_of_a_list_is_shown_above_it():
    drawn = run("units", "lambert", "--format", "table").stdout
    told, head, *_ = drawn.splitlines()
    assert told == "quantity: luminance"
    assert head.split() == ["unit", "symbols", "definition", "source"]


PIPED = [
    ("convert", "800", "lm", "cd", "--isotropic", "--format", "table"),
    ("convert", "800", "lm", "cd"),
    ("lambertian", "--luminance", "100cd/m2", "--check", "exitance=628lm/m2", "--format", "table"),
    ("point-source", "--flux", "800lm", "--distance", "1m,2m", "--format", "table", "--steps"),
    ("units", "lambert", "--format", "table"),
    ("ev", "--help"),
    ("--help",),
    (),
]


@pytest.mark.parametrize("words", PIPED, ids=" ".join)
def test_no_escapes_in_a_pipe_or_without_colour(words, monkeypatch):
    monkeypatch.setenv("TERM", "xterm")
    assert "\x1b" not in run(*words, together=True).stdout
    if words:
        assert "\x1b[" in terminal_of(*words)
        assert "\x1b" not in terminal_of(*words, NO_COLOR="1")
    monkeypatch.setenv("FORCE_COLOR", "1")
    assert "\x1b" not in run(*words).stderr


COLORS = {
    ("convert", "800", "lm", "cd", "--isotropic"): ["\x1b[36massumed:\x1b[0m uniform", "[1m63.662"],
    ("convert", "800", "lm", "cd"): ["\x1b[1;31mradcalc:\x1b[0m cannot", "\x1b[1;32mtry:\x1b[0m "],
    ("lambertian", "--luminance", "1cd/m2", "--check", "exitance=3.14lm/m2"): [
        "\x1b[1;32mright\x1b[0m (within"
    ],
    ("lambertian", "--luminance", "1cd/m2", "--check", "exitance=6.28lm/m2"): [
        "\x1b[1;31mwrong\x1b[0m (within", "\x1b[35mlikely:\x1b[0m 2 pi",
    ],
    ("point-source", "--flux", "800lm", "--distance", "2m"): [
        "\x1b[2mluminous flux (given)", "\x1b[1m15.9155",
    ],
    ("ev", "--help"): ["\x1b[1mUsage:\x1b[0m", "\x1b[1mExamples:\x1b[0m", "\x1b[1mCamera:\x1b[0m"],
}  # fmt: skip


@pytest.mark.parametrize("words", COLORS, ids=" ".join)
def test_the_first_word_of_a_line_is_coloured_without_change_of_text(words):
    screen = terminal_of(*words)
    assert all(text in screen for text in COLORS[words])
    assert re.sub(r"\x1b\[[\d;]*m", "", screen) == terminal_of(*words, NO_COLOR="1")
    assert set(re.findall(r"\x1b\[([\d;]*)m", screen)) <= {
        "0",
        "1",
        "2",
        "31",
        "1;31",
        "1;32",
        "35",
        "36",
    }
    assert "\x1b" not in terminal_of(*words, "--color", "never")
    assert "\x1b" not in terminal_of(*words, "--color=never")


def test_rules_and_symbols_are_ascii_if_the_encoding_requires_it():
    words = ("point-source", "--flux", "800lm", "--exponent", "2", "--distance", "1m,2m")
    env = os.environ | {"PYTHONIOENCODING": "ascii"}
    drawn = process(*words, "--format", "table", env=env).stdout
    assert "given: luminous flux 800 lm, exponent 2\n" in drawn
    assert "\n----------" in drawn
    photon = process("photon", "555nm", "--format", "table", env=env).stdout
    assert [line.split()[-3] for line in photon.splitlines()[2:5]] == ["lambda", "nu", "sigma"]
    for text in (drawn, photon):
        assert text.isascii()
        assert "\\u" not in text


def test_a_row_marks_a_number_read_as_a_fraction():
    row = Row("quelque durée", "t", 1 / 60, "s", form=FRACTION)
    assert "1/60 " in table.results([Result((row,))], Style())
    assert "16.6667 " in table.results(
        [Result((row._replace(value=1e3 / 60, unit="ms"),))], Style()
    )
    assert "1/60" not in table.results([Result((row._replace(form=""),))], Style())


def test_a_table_may_fill_the_terminal():
    header, cells = ["what", "value"], ["a" * 10, "123"]
    width = 10 + 3 + 5  # the two columns, and what is between them
    head, rule, line = table.draw(
        table.Drawn(header, [cells], right=["value"]), Style(width=width)
    ).splitlines()
    assert [head.split(), line.split()] == [header, cells]
    assert len(rule) == width


CELLS = (
    "", "1.25", "lx", "a/b", "long name of a quantity", "W/m²/sr", "日本", "x\u200b", "φ", "a\nb",
    " x", "x ", "\xa0y", "photon/s/m2", "a" * 30, "[bold]x", "1e-12 ± 3",
)  # fmt: skip


def test_rows_of_a_long_table_are_those_that_rich_draws(monkeypatch):
    draw = random.Random(1)
    for _ in range(100):
        header = ["value", "unit", "x y", "symbol", "for"][: draw.randint(1, 5)]
        rows = [[draw.choice(CELLS) for _ in header] for _ in range(draw.randint(1, 20))]
        drawn = table.Drawn(header, rows, right=("value",), faint={"for", 3, 5}, unfolded=("x y",))
        style = Style(width=draw.choice((20, 40, 60, 200)), color=draw.choice((True, False)))
        monkeypatch.setattr(table, "FEW", len(rows))
        by_rich = table.draw(drawn, style)
        monkeypatch.setattr(table, "FEW", draw.choice((0, 1, 3)))
        assert table.draw(drawn, style) == by_rich
