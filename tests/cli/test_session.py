"""Lines of a prompt: their syntax, the last answer, and names of amounts."""

import json
import math
import re
from pathlib import Path

import pytest
from conftest import ROOT, standard_streams
from test_cases import FILES, transcripts

from radcalc.cli.command import commands
from radcalc.cli.session import Session

# 1 fc = 1 lm/ft2 and 1 ft = 0.3048 m exactly: 100 lx = 9.290304 fc


NEEDS_QUOTES = "quotes around a value that is calculated"


@pytest.fixture
def session(monkeypatch):
    monkeypatch.setattr("radcalc.terminal.is_terminal", lambda: False)
    return Session()


@pytest.fixture
def typed(session, capsys):
    """Answer lines; return the output and the error message of the last one."""

    def answer(*lines):
        for line in lines:
            capsys.readouterr()
            status = session.answer(line)
        shown = capsys.readouterr()
        assert status == (2 if "radcalc: " in shown.err else 0)
        return shown.out if not status else shown.err

    return answer


READ = {
    "": [],
    "  ": [],
    "100 lx fc": ["convert", "100", "lx", "fc"],
    "radcalc 100 lx fc": ["convert", "100", "lx", "fc"],
    "convert 100 lx to fc": ["convert", "100", "lx", "to", "fc"],
    "-30 mW uW": ["convert", "-30", "mW", "uW"],
    "1 J/(m2 s) W/m2": ["convert", "1", "J/(m2", "s)", "W/m2"],
    "'5 W m-2' W/m2": ["convert", "5 W m-2", "W/m2"],
    "- lx fc --header -d ,": ["convert", "-", "lx", "fc", "--header", "-d", ","],
    "convert - --header lx fc": ["convert", "-", "lx", "fc", "--header"],
    "convert - --field 2 lx fc": ["convert", "-", "lx", "fc", "--field", "2"],
    "photon 555nm": ["photon", "555nm"],
    "units 'photon flux'": ["units", "photon flux"],
    "help convert": ["help", "convert"],
    "--version": ["--version"],
}


@pytest.mark.parametrize("line", READ)
def test_a_line_is_read_as_the_words_at_a_shell(session, line):
    assert session.read(line) == READ[line]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_line_is_answered_as_at_the_shell(path):
    for command, output in transcripts(path):
        if not command.startswith("radcalc ") or set("|<>;$&`\n") & set(command):
            continue
        if command.split()[1] == "prompt" or NEEDS_QUOTES in output:  # a shell expands *
            continue
        if "--definitions" in command:  # which are read when radcalc starts
            continue
        with standard_streams(b"", together=True) as (out, _):
            status = Session().answer(command)
            out.seek(0)
            assert out.read().decode() + (f"[{status}]\n" if status else "") == output, command


def test_definitions_are_not_read_in_a_line(typed):
    """The option was taken and its file left out: the line was answered without its units."""
    assert typed("100 lx fc --definitions own.txt") == (
        "radcalc: --definitions is read once, when radcalc starts\n"
        "try: radcalc prompt --definitions own.txt\n"
    )


def test_the_last_answer_is_a_value_with_its_unit(typed):
    assert typed("100 lx fc", "ans lx") == "100\tlx\n"


def test_the_last_answer_is_not_rounded_as_it_was_shown(typed):
    assert typed("2 rad deg --precision 2", "ans rad --precision 17") == "2\trad\n"


def test_the_last_answer_may_be_the_value_of_an_option(typed):
    # 800 lm / 4 pi sr / (2 m)2 = 50/pi lx
    typed("0.8 klm lm")
    assert typed("1 klm lx --isotropic --distance 2m") == "19.8943678865\tlx\n"
    assert typed("0.2 dam m", "1 klm lx --isotropic --distance ans") == "19.8943678865\tlx\n"


def test_a_line_without_an_answer_keeps_the_last_one(typed):
    assert typed("100 lx fc", "units lux", "vars", "100 zork fc", "help", "ans lx") == "100\tlx\n"


@pytest.mark.parametrize(
    ("claim", "last"),
    [
        ("200 lx fc --check 3", "200\tlx\n"),
        ("200 lx fc --check 18.6", "200\tlx\n"),
        # 100 cd give 100 / 2^2 = 25 lx at 2 m
        ("point-source --intensity 100cd --distance 2m --check irradiance=3lx", "25\tlx\n"),
    ],
)
def test_the_right_value_of_a_check_is_the_last_answer(session, capsys, claim, last):
    for line in ("100 lx fc", claim, "ans lx"):
        capsys.readouterr()
        session.answer(line)
    assert capsys.readouterr().out == last


def test_the_right_value_of_a_check_may_be_named(typed):
    assert typed("x = 200 lx fc --check 18.6", "x lx") == "200\tlx\n"


def test_points_one_per_line_are_not_a_value(typed, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("lamp.csv").write_text("x,y,z,intensity\n0,0,2,100cd\n")
    typed("100 lx fc", "scene lamp.csv --grid 0:1:2,0,0 -g irradiance")
    assert "ans is not a number" in typed("ans fc")


def test_one_of_several_results_is_selected_by_name(typed):
    typed("point-source --flux 800lm --distance 2m")
    assert "ans is one value, but the answer has several" in typed("ans fc")
    assert "ans.illuminance" in typed("ans fc")
    assert "no 'exitance'" in typed("ans.exitance fc")
    assert typed("ans.distance ft") == "6.56167979003\tft\n"  # 2 / 0.3048
    for name in ("irradiance", "illuminance"):  # 800/(4 pi 2^2) 0.3048^2
        assert typed("point-source --flux 800lm --distance 2m", f"ans.{name} fc").endswith(
            "1.47859780443\tfc\n"
        )


def test_several_answers_are_not_a_value(typed):
    typed("800 lm lx --isotropic --distance 1m,2m")
    assert "there are 2" in typed("ans fc")


def test_there_is_no_last_answer_at_first(typed):
    assert typed("ans fc").startswith("radcalc: ans has no value yet\ntry: ")


def test_a_name_keeps_an_amount_as_it_was_typed(typed):
    assert typed("x = 100 lx") == "100\tlx\n"
    assert typed("x fc") == "9.290304\tfc\n"
    assert typed("y=2m", "vars") == "x = 100 lx\ny = 2m\nans = 2 m\n"


def test_a_name_may_be_the_value_of_a_calculators_option(typed):
    typed("source = 800 lm", "y = 2 m")
    # 800 lm / 4 pi sr / (2 m)2 = 50/pi lx
    line = "point-source --flux source --distance=y -g irradiance:lx"
    assert typed(line) == "15.9154943092\n"
    assert typed("point-source --flux source --distance 1m,y -g irradiance:lx -q") == (
        "63.6619772368\n15.9154943092\n"
    )


def test_a_name_keeps_the_answer_of_a_conversion(typed):
    assert typed("x = 100 lx fc") == "9.290304\tfc\n"
    assert typed("x lx") == "100\tlx\n"


def test_a_name_keeps_a_bare_number(typed):
    assert typed("k = 1/4", "k lx mlx") == "250\tmlx\n"


# E = I / d^2 and Phi = E A
SENTENCES = {
    "20000 cd at 8 m to lx": "312.5\tlx",
    "source at 8 m to lx": "312.5\tlx",
    "source at there to lx": "312.5\tlx",
    "at there, source, lx": "312.5\tlx",
    "source * 2 at there lx": "625\tlx",
    "how many lumens for 500 lx on table": "1500\tlumens",
    "20000 cd at 4 m to lx": "1250\tlx",
}


@pytest.mark.parametrize("line", SENTENCES)
def test_a_line_may_be_a_sentence_with_names(typed, line):
    typed("source = 20000 cd", "there = 8 m", "table = 3 m2")
    assert typed(line) == SENTENCES[line] + "\n"


@pytest.mark.parametrize("line", SENTENCES)
def test_the_answer_of_a_sentence_is_the_last_answer(typed, line):
    typed("source = 20000 cd", "there = 8 m", "table = 3 m2")
    value, _, unit = typed(f"x = {line}").rstrip("\n").partition("\t")
    assert typed(f"ans {unit} -n") == typed(f"x {unit} -n") == f"{value}\n"


def test_the_last_answer_goes_on_in_a_sentence(typed):
    # I = Phi (n + 1) / 2 pi sr, where cos^n(12 deg) = 1/2; E = I / d^2
    exponent = math.log(0.5) / math.log(math.cos(math.radians(12)))
    lx = 800 * (exponent + 1) / (2 * math.pi) / 3**2
    answer = typed("800 lm 24 deg lobe to cd", "ans at 3 m to lx")
    assert float(answer.split()[0]) == pytest.approx(lx, rel=1e-9)
    typed("100 cd at 2 m")  # all results
    assert typed("ans.illuminance on 3 m2 to lm") == "75\tlm\n"


def test_a_sentence_has_the_settings_of_all_lines(capsys):
    session = Session({"json_": True})
    session.answer("20000 cd at 8 m to lx")
    shown = json.loads(capsys.readouterr().out)
    assert shown["results"]["illuminance"]["value"] == 312.5
    Session({"number": True, "quiet": True}).answer("20000 cd at 8 m to lx")
    assert capsys.readouterr() == ("312.5\n", "")


def test_a_sentence_with_names_is_explained(typed):
    typed("source = 20000 cd")
    shown = "at 8 m\t--distance 8m\n20000 cd\t--intensity 20000cd\nlx\t-g illuminance:lx\n"
    assert typed("at 8 m source to lx --explain").startswith(shown)
    assert typed("--explain at 8 m source to lx").startswith(shown)


def test_a_refused_sentence_has_the_values_of_its_names(typed):
    typed("flow = 800 lm")
    refusal = typed("24 degree beam flow to cd")
    assert "radcalc convert 800 lm cd --beam-angle 24degree" in refusal
    assert "understood 800 lm, fc; not understood: roughly" in typed("flow fc roughly")


ARITHMETIC = {  # 1 ft = 0.3048 m; 1 lx = 1 lm/m2
    "2 * 100 lx in fc": "18.580608\tfc",
    "2 * 100 lx fc": "18.580608\tfc",
    "convert 2 * 100 lx to fc": "18.580608\tfc",
    "2 * 100 lx": "200\tlx",
    "(1 m + 2 ft) in m": "1.6096\tm",
    "(1 m + 2 ft) cm": "160.96\tcm",
    "1 m + 2 ft": "1.6096\tm",
    "1 m + 2 ft cm": "160.96\tcm",
    "800 lm / 2 m2": "400\tlm/m2",
    "800 lm / 2 m2 in lx": "400\tlx",
    "500 lx * 20 m2 / 0.8 in klm": "12.5\tklm",
    "500 lx*20 m2/(0.8*1) to klm": "12.5\tklm",
    "'500 lx * 20 m2 / (0.8*1)' klm": "12.5\tklm",
    "100 lx * (2 + 3) klx": "0.5\tklx",
    "100 lx * 2 %": "2\tlx",
    "3 * 4": "12\t1",
    "4 m2 / (2 m2)": "2\t1",
    "sqrt(4 m2) cm": "200\tcm",
    "2*here klx": "0.2\tklx",
    "2 * here klx": "0.2\tklx",
    "here * 2 klx --precision 3": "0.2\tklx",
    "here + 2*ans": "300\tlx",
    "1/here": "0.01\tlx-1",
    "here/(2 lx)": "50\t1",
    "ans / 2": "50\tlx",
    "half * here": "50\tlx",
}


@pytest.mark.parametrize("line", ARITHMETIC)
def test_arithmetic_needs_no_quotes(typed, line):
    assert typed("half = 1/2", "here = 100 lx", line) == ARITHMETIC[line] + "\n"


@pytest.mark.parametrize("line", ["y*3", "3*y", "y + y + y", "1 m2/y/3", "convert y*3 m"])
def test_a_fraction_that_a_name_keeps_is_exact_in_arithmetic(typed, line):
    assert typed("y = 1/3 m", line) == "1\tm\n"
    assert typed("vars").startswith("y = (1/3) m\n")


def test_arithmetic_is_accepted_in_options_and_names(typed):
    typed("side = 1 m + 1 m", "two = 2 * 400 lm")
    # 800 lm / 4 pi sr / (2 m)2 = 50/pi lx
    line = "point-source --flux two --distance side -g irradiance:lx"
    assert typed(line) == "15.9154943092\n"
    assert typed(line.replace("two", "two*2").replace("side", "side/2")) == "127.323954474\n"


TWO_WAYS = {  # the number of each reading
    "500 lx * 20 m2 / 0.5 klm": ("20 klm", "20"),
    "500 lx*20 m2/(0.8*1) klm": ("12.5 klm", "12.5"),
    "4 m2 / 2 m2": ("2 m2", "2"),
}


@pytest.mark.parametrize("line", TWO_WAYS)
def test_a_last_word_that_may_be_a_unit_or_the_target_is_refused_with_both(typed, line):
    message, _, first, _, second = typed(line).splitlines()
    assert "has 2 readings" in message
    assert first.split(",")[0].strip() == TWO_WAYS[line][0]
    assert second.split(",")[0].strip().split()[0] == TWO_WAYS[line][1]


def test_an_uncertain_value_may_be_a_part_of_arithmetic(typed):
    typed("side = 2 ± 0.1 m")
    assert typed("2*side cm") == "400 ± 20\tcm\n"
    assert typed("twice = 2*side", "twice / 2") == "2.00 ± 0.10\tm\n"


def test_a_reading_on_a_scale_is_kept_as_typed(typed):
    assert typed("power_in = 10 dBm", "power_in mW") == "10\tmW\n"  # 1 mW * 10^(10/10)
    assert typed("10 mW dBm", "ans mW") == "10\tmW\n"


def test_a_name_is_not_replaced_inside_other_words(typed):
    typed("x = 800 lm")
    # CIE 15:2018, table 11.3: x of D65 is 0.31272, here from 380 nm to 780 nm
    assert typed("spectrum D65 -g x -q --precision 5") == "0.31273\n"


REFUSED = {
    "m = 5 lm": ("'m' is already the unit metre", "my_m = 5 lm"),
    "lx = 5": ("'lx' is already the unit lux", "my_lx = 5"),
    "convert = 5 lm": ("already a word of radcalc", "my_convert"),
    "ans = 5 lm": ("already a word of radcalc", "my_ans"),
    "pi = 3": ("already a word of radcalc", "my_pi"),
    "illuminance = 5 lx": ("already a quantity", "my_illuminance"),
    "flux = 5 lm": ("already a quantity", "my_flux"),
    "sqrt = 5": ("'sqrt' is already a word of radcalc", "my_sqrt = 5"),
    f"100 lx {'f' * 10_000}": ("a line of 10007 characters is too long", "at most 10000"),
    "dBm = 5": ("'dBm' is already a scale", "my_dBm = 5"),
    "EV = 5": ("'EV' is already a scale", "my_EV = 5"),
    "x =": ("x = has no value", "x = 800 lm"),
    "x = help": ("the amount for x is missing", "x = 800 lm"),
    "x = zork": ("unknown command 'zork'", "radcalc --help"),
    "x = point-source --flux 800lm --distance 2m": ("x is one value", "-g intensity"),
    "x = 1,5 lx": ("has a comma in its number", "1.5"),
    "units 'lux": ("the ' has no second one", "the line without '"),
    'units "lux': ('the " has no second one', 'the line without "'),
    "units lux \\": ("the \\ has nothing after it", "the line without \\"),
    "zork 5": ("unknown command 'zork'", "radcalc --help"),
    "prompt": ("this is the prompt", "exit"),
    "y fc": ("unknown command 'y'", "radcalc --help"),
}


@pytest.mark.parametrize("line", REFUSED)
def test_a_line_that_cannot_be_answered_is_refused_with_a_reason_and_a_hint(typed, session, line):
    message, hint = typed(line).split("\ntry: ")
    assert REFUSED[line][0] in message
    assert REFUSED[line][1] in hint
    assert session.variables == {}


@pytest.mark.parametrize(
    ("line", "hint"),
    [
        ("1,5 lx fc", "radcalc '1.5 lx' fc"),
        ("convert 1,5 lx fc", "radcalc convert '1.5 lx' fc"),
        ("convert 100 cd lx --distance 2 m", "radcalc convert 100 cd lx --distance 2m"),
        ("100 cd + 3 cd lx", "radcalc '100 cd + 3 cd lx' --distance 2m"),
    ],
)
def test_the_calls_of_a_hint_are_as_typed(typed, line, hint):
    assert f"\ntry: {hint}" in typed(line)


def test_a_conversion_to_every_unit_is_one_value(typed):
    typed("250 cd/m2")
    # a footlambert is 1/pi cd/ft2
    assert typed("ans fL --precision 6") == "72.9659\tfL\n"


def test_a_kept_value_is_shown_by_its_name(typed):
    assert typed("x = 100 lx", "x") == "100\tlx\n"
    assert typed("100 lx fc", "ans") == "9.290304\tfc\n"


@pytest.mark.parametrize(
    "line", ["100 ± 3 lx fc", "100 +- 3 lx in fc", "100 lx ± 3% fc", "(100 ± 3) lx fc"]
)
def test_an_uncertain_value_needs_no_quotes(typed, line):
    # 100 lx are 9.290304 fc, and 3% of that is 0.2787
    assert typed(line) == "9.29 ± 0.28\tfc\n"
    assert typed("ans lx") == "100.0 ± 3.0\tlx\n"


def test_an_uncertain_name_is_used_once_in_a_line(typed):
    """Two uses of one value are correlated but would be propagated as independent."""
    typed("side = 2 ± 0.1 m", "same = side ft", "other = 2 ± 0.1 m")
    line = "solid-angle rectangle --width side --length {} --height 1m -g solid-angle"
    assert "side is correlated with" in typed(line.format("side"))
    assert "same is correlated with" in typed(line.format("same"))
    assert "is uncertain" not in typed(line.format("other"))


@pytest.mark.parametrize("value", ["100+-3 lx", "100(3) lx", "100 lx +/- 3%", "100±3 lx"])
@pytest.mark.parametrize("line", ["x + x", "x - x", "x + ans", "x + same", "same / x"])
def test_an_uncertain_name_is_used_once_in_arithmetic_however_it_is_written(typed, value, line):
    typed(f"x = {value}", "same = 2*x", "x")
    assert "is correlated with" in typed(line)


def test_a_bug_is_reported_and_the_next_line_is_answered(session, monkeypatch, capsys):
    def broken(*args, **kwargs):
        raise ZeroDivisionError("oh")

    with monkeypatch.context() as patched:
        patched.setattr(commands, "invoke", broken)
        assert session.answer("100 lx fc") == 3
    assert "bug in radcalc" in capsys.readouterr().err
    assert session.answer("100 lx fc") == 0


def test_an_interrupt_ends_only_the_line(session, monkeypatch, capsys):
    def interrupted(*args, **kwargs):
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(commands, "invoke", interrupted)
        assert session.answer("100 lx fc") == 130
    assert session.answer("100 lx fc") == 0
    assert capsys.readouterr().out == "9.290304\tfc\n"


@pytest.mark.parametrize("line", ["exit", "quit", " exit "])
def test_exit_ends_the_lines(session, line):
    with pytest.raises(EOFError):
        session.answer(line)


def test_output_options_apply_to_every_line(capsys, monkeypatch):
    monkeypatch.setattr("radcalc.terminal.is_terminal", lambda: False)
    Session({"number": True, "precision": 3}).answer("100 lx fc")
    assert capsys.readouterr().out == "9.29\n"


def test_a_single_value_is_one_line_on_a_terminal(monkeypatch, capsys):
    monkeypatch.setattr("radcalc.terminal.is_terminal", lambda: True)
    monkeypatch.setenv("NO_COLOR", "1")
    session = Session()
    session.answer("800 lm cd --isotropic")
    first, assumed = capsys.readouterr().out.splitlines()
    assert first == "63.662 cd   (luminous intensity)"  # 800 / (4 pi)
    assert assumed == "assumed: uniform over 4 pi sr (isotropic)"
    session.answer("point-source --flux 800lm --distance 2m")
    assert len(capsys.readouterr().out.splitlines()) > 5


def test_the_session_in_the_documentation_is_printed_as_shown(monkeypatch, capsys):
    monkeypatch.setattr("radcalc.terminal.is_terminal", lambda: True)
    monkeypatch.setenv("NO_COLOR", "1")
    found = re.search(
        r"```text\n(> .*?)```", (ROOT / "docs" / "prompt.md").read_text("utf-8"), re.S
    )
    assert found
    session = Session()
    for entry in re.split(r"^> ", found[1], flags=re.M)[1:]:
        line, _, answer = entry.partition("\n")
        session.answer(line)
        assert capsys.readouterr().out == answer, line
