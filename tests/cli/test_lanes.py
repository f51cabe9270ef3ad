"""The lanes without Click print the same bytes as Click, or leave the call to Click."""

import shlex
from fractions import Fraction

import pytest
from conftest import ROOT

from radcalc import __main__, cli
from radcalc.calculators import SUMMARIES, page_of
from radcalc.calculators.page import words_of
from radcalc.cli import boundary, lane
from radcalc.cli.spelling import Shell
from radcalc.conversion.operands import read_operands
from radcalc.floats import read_decimal
from radcalc.units import Unit, single, table
from radcalc.units.compiled import NAMES, PREFIX_NAMES, PREFIX_SYMBOLS, SYMBOLS
from radcalc.units.numbers import is_sentence

ANSWERED = [
    ["100", "lx", "fc"],
    ["100lx", "fc"],
    ["100", "lx", "to", "fc"],
    ["100 lx", "fc"],
    ["100 lx to fc"],
    ["5", "W", "m-2", "to", "mW", "cm-2"],
    ["1/3", "klx", "lx"],
    ["4pi", "sr", "deg2"],
    ["100", "лк", "лм/м²"],
    ["1", "Btu", "J"],
    ["1", "cm-1", "m-1"],
    ["1e-30", "lx", "nlx"],
    ["0", "lx", "fc"],
    ["-0", "lx", "fc"],
    ["1", "W/m2/Hz", "Jy"],
    ["100", "lx", "fc", "-n"],
    ["-5", "deg", "rad", "-n"],
    ["100", "lx", "in", "fc"],
    ["100", "lx", "=", "fc"],
    ["100 lx as fc"],
    ["5", "in", "in", "cm"],
    ["100", "cm", "in"],
    [".5", "lx", "fc"],
    ["pi/2", "rad", "deg"],
]
LEFT = [
    [],
    ["100", "lx", "->", "fc"],
    ["100", "lx"],
    ["100", "lx", "cd"],
    ["100", "zork", "fc"],
    ["1,5", "lx", "fc"],
    ["100", "lx", "fc", "--json"],
    ["100", "lx", "fc", "-q"],
    ["-n", "100", "lx", "fc"],
    ["--", "100", "lx", "fc"],
    ["-", "lx", "fc"],
    ["-pi", "rad", "deg"],
    ["-30", "mW", "uW"],
    ["-30mW", "uW"],
    ["-h"],
    ["1e308", "km", "nm"],
]


@pytest.fixture
def piped(monkeypatch, capsys):
    monkeypatch.setattr("radcalc.terminal.is_terminal", lambda: False)
    return capsys.readouterr


@pytest.mark.parametrize("operands", ANSWERED, ids=" ".join)
def test_both_lanes_print_the_same(operands, piped):
    assert __main__.quick_lane(["convert", *operands]) == 0
    quick = piped()
    assert quick.out
    assert cli.run(["convert", *operands]) == 0
    assert piped() == quick
    for run in (__main__.quick_lane, cli.run):  # the sentence is the command
        assert run(operands) == 0
        assert piped() == quick


@pytest.mark.parametrize("operands", LEFT, ids=" ".join)
def test_the_quick_lane_leaves_the_rest_to_click(operands, piped):
    assert __main__.quick_lane(["convert", *operands]) is None
    assert __main__.quick_lane(operands) is None
    assert piped() == ("", "")


@pytest.mark.parametrize("operands", [one for one in LEFT if is_sentence(one)], ids=" ".join)
def test_the_sentence_is_convert_on_the_slow_lane(operands, piped):
    status = cli.run(["convert", *operands])
    out, error = piped()
    assert (cli.run(operands), piped()) == (
        status,
        (out, error.replace("radcalc convert ", "radcalc ")),
    )


@pytest.mark.parametrize("words", [[], ["units"], ["--version"], ["konvert", "1", "lx", "fc"]])
def test_the_quick_lane_is_for_convert_only(words, piped):
    assert __main__.quick_lane(words) is None


def test_the_quick_lane_leaves_a_terminal_to_click(piped, monkeypatch):
    monkeypatch.setattr("radcalc.terminal.is_terminal", lambda: True)
    assert __main__.quick_lane(["convert", "100", "lx", "fc"]) is None


def examples(command):
    """Return the calls in the examples of a calculator, as words of the shell."""
    of_page = [words_of(example)[0] for example in page_of(command).examples]
    return [shlex.split(Shell.command(command, *words))[1:] for words in of_page]


OUTPUT = [[], ["--json"], ["-q"], ["-n"], ["--get", "flux"], ["-g", "irradiance:lx", "--number"]]


@pytest.mark.parametrize("command", [name for name in SUMMARIES if page_of(name).examples])
def test_an_example_of_a_page_has_the_same_answer_without_click(command, piped, monkeypatch):
    monkeypatch.chdir(ROOT / "examples")
    for words in examples(command):
        for more in OUTPUT:
            call = [*words, *more]
            status = lane.answer_in_full(call)
            plain = piped()
            if status is None:
                assert plain == ("", ""), call
            else:
                assert (boundary.run(call), piped()) == (status, plain), call


@pytest.mark.parametrize(
    "call",
    [
        "point-source --intensity 100cd --distance 2m",
        "point-source --intensity 100cd --distance 1m:3m:1m --format table",
        "sky overcast --zenith-luminance 9000cd/m2",
        "photon 555nm",
        "lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm",
        "convert 800 lm cd --isotropic",
        "laser --flux 5mW --diameter 1mm --receiver-diameter 7mm -g received-flux:mW",
        "solid-angle cone --half-angle 30deg --json",
    ],
)
def test_a_lane_is_answered_without_click(call, piped):
    assert lane.answer_in_full(call.split()) == 0
    assert piped().out


@pytest.mark.parametrize(
    "call",
    [
        "point-source --intensity 100cd --distance",
        "point-source --intensity 100cd --distance ''",
        "point-source --intensity 100cd --distance '- m'",
        "point-source --intensity=100cd --distance=2m",
        "point-source --intens 100cd --distance 2m",
        "point-source --intensity 100cd --intensity 200cd",
        "point-source --intensity 100cd --distance 2m 3m",
        "point-source --intensity 100cd --distance 2m --check irradiance=25lx",
        "point-source --intensity 100cd --steps",
        "point-source --intensity 100cd --area 1m2",
        "point-source --intensity -100cd",
        "point-source -h",
        "convert 100 lx fc -g irradiance",
        "convert - lx fc --header",
        "convert - lx cd --distance 2m",
        "point-source --intensity - --distance 2m",
        "solid-angle hemisphere --field 2",
        "units lx",
        "sky overcast --horizontal-illuminance 10klx --save sky.hdr",
        "solid-angle hemisphere --format json --format json",
        "solid-angle hemisphere --format xml",
    ],
)
def test_a_lane_leaves_the_rest_to_click(call, piped):
    assert lane.answer_in_full(shlex.split(call)) is None
    assert piped() == ("", "")


SIMPLE_NUMBERS = ["0", "100", "2.50", "5.", "0.000001", "007", "123456789012345678901234567890"]
OTHER_NUMBERS = [".5", "1e3", "-1", "+1", "1,5", "1/3", "٣", "²", "1_0", "pi", "", "5" * 31]


@pytest.mark.parametrize("text", SIMPLE_NUMBERS)
def test_a_decimal_is_read_as_the_grammar_reads_it(text):
    number, (amount, _) = read_decimal(text), read_operands([text, "lx", "fc"])
    assert number == amount.number
    over, under = amount.exact.as_integer_ratio()
    assert Fraction(*number.as_integer_ratio()) == Fraction(over, under) == Fraction(text)


@pytest.mark.parametrize("text", OTHER_NUMBERS)
def test_other_numbers_are_left_to_the_grammar(text):
    assert read_decimal(text) is None


def test_a_single_spelling_is_read_as_the_grammar_reads_it(monkeypatch):
    """Every symbol and name, with every prefix that may go before it, and words that are none."""
    spelled = [f"{prefix}{symbol}" for prefix in ("", *PREFIX_SYMBOLS) for symbol in SYMBOLS]
    spelled += [f"{prefix}{name}" for prefix in ("", *PREFIX_NAMES) for name in NAMES]
    fields = {text: parts(single(text)) for text in spelled}
    monkeypatch.setattr(table, "single", lambda text: None)
    units = {text: parts(table.unit_of(text)) for text in spelled}
    simple = {text: of for text, of in fields.items() if of}
    assert simple == {text: units[text] for text in simple}
    assert len(simple) > 1500
    for text in ("lm/m2", "W m-2", "m2", "%", "°", "cm-1", "diopter", "in_", "zork", ""):
        assert single(text) is None


def parts(unit):
    return unit and [getattr(unit, name) for name in Unit.__slots__]


def test_every_simple_call_has_the_same_answer_without_the_shortcut(piped, monkeypatch):
    calls = [
        [value, source, *to, target]
        for value, to in (("100", []), ("2.5", ["to"]))
        for source in SYMBOLS
        for target in ("lx", "klm", "nm", "in", "rad", "J", "umol")
    ]
    assert sum(__main__.simplest(call) is not None for call in calls) > 1000
    quick = [(__main__.quick_lane(call), piped()) for call in calls]
    monkeypatch.setattr(__main__, "simplest", lambda operands: None)
    assert [(__main__.quick_lane(call), piped()) for call in calls] == quick
