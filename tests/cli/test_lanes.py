"""The quick lane prints the same bytes as Click, or leaves the call to Click."""

import pytest

from radcalc import __main__, cli
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
