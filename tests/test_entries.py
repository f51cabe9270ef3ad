"""Every entry point reads a line alike: words, one quoted word, `convert`, `ask`, the prompt."""

from itertools import product

import pytest
from conftest import run
from hypothesis import given, settings
from hypothesis import strategies as st

import radcalc

PAIRS = [
    ("5", "m", "ft"), ("500", "lx", "fc"), ("1000", "lm", "cd"), ("1", "eV", "nm"),
    ("1", "eV", "J"), ("60", "deg", "rad"), ("2", "h", "s"), ("100", "W", "lm"), ("1", "W", "mW"),
    ("10", "in", "cm"), ("5", "ft", "in"), ("100", "cd/m2", "nit"), ("5", "mW", "dBm"),
    ("2", "m2", "cm2"), ("1/3", "lx", "fc"), ("-5", "deg", "rad"),
]  # fmt: skip
LINKS = ["", "to", "in", "as", "na", "в", "->", "="]
UNITS = [
    *("m", "ft", "in", "cm", "lx", "fc", "lm", "cd", "nit", "W", "mW", "J", "eV", "nm", "s", "h"),
    *("deg", "rad", "sr", "K", "mired", "dBm", "EV", "ppfd", "mol", "W/m2", "cd/m2", "lm s", "%"),
    *("W m-2", "lux", "footcandles", "lumens per square foot", "лк", "люкс", "люменов", "метров"),
    *("luxů", "lumenů", "cm-1", "umol/m2/s", "mag", "OD", "as", "1", "lx h", "m2", "kelvin"),
]
AMOUNTS = ["5", "1/3", "2.5e3", "-5", "0.5", "100*2", "2pi", "1:3:1"]
OTHERS = """
    500 люкс в фут-канделы
    1000 люмен в люксы
    1000 lumenů na kandely
    5 метров в сантиметры
    100 люкс на фут-канделы
    800 lumens per candela
    lux 500 to fc
    mag 6 lux
    dBm 20 mW
    nm 532 eV
    5 lm s
    100 W m-2 mW cm-2
    500 lux hours lx s
    100 lm na W
    1,5 lx fc
    1 000 lx fc
    100 km za h to m/s
    500 люмен на м2 to lx
"""
LINES = [" ".join(filter(None, (v, a, link, b))) for (v, a, b), link in product(PAIRS, LINKS)]
LINES += [line.strip() for line in OTHERS.strip().splitlines()]
REFUSED = "refused"


def of_process(*words: str, input: str = "") -> str:
    """Return the number that a call begins its answer with, or that it is refused."""
    done = run(*words, input=input)
    lines = done.stdout.splitlines()
    if done.returncode or not lines:
        return REFUSED
    cells = lines[0].split("\t")  # of several results, the first has a name
    return f"{float(cells[len(cells) > 2].split()[0]):.6g}"


def of_python(line: str) -> str:
    try:
        answer = radcalc.ask(line)
    except radcalc.RadcalcError:
        return REFUSED
    if isinstance(answer, radcalc.Result):  # of a calculator: several numbers
        return REFUSED
    return f"{float(getattr(answer, 'magnitude', answer)):.6g}"


def readings(line: str) -> dict[str, str]:
    """Return what each entry point makes of a line."""
    words = line.split()
    return {
        "words": of_process(*words),
        "one word": of_process(line),
        "convert": of_process("convert", *words),
        "convert, one word": of_process("convert", line),
        "number": of_process(*words, "-n"),
        "prompt": of_process("prompt", input=f"{line}\n"),
        "ask": of_python(line),
    }


@pytest.mark.parametrize("line", LINES)
def test_every_entry_point_reads_a_line_alike(line):
    found = readings(line)
    if found["words"] != REFUSED and found["number"] == REFUSED:  # -n needs a target
        assert found["words"] == f"{float(line.split()[0]):.6g}"
        del found["number"]
    assert len({*found.values()}) == 1, found


@settings(max_examples=150)
@given(
    amount=st.sampled_from(AMOUNTS),
    source=st.sampled_from(UNITS),
    link=st.sampled_from([*LINKS, "na", "за", "do", "into"]),
    target=st.sampled_from(UNITS),
)
def test_entry_points_answer_with_one_number_or_refuse(amount, source, link, target):
    found = readings(" ".join(filter(None, (amount, source, link, target))))
    assert len({*found.values()} - {REFUSED}) < 2, found


# 1 ft is 0.3048 m, 1 parsec 3.0857e16 m (IAU 2015 B2); h c / 1 eV is 1239.84 nm (CODATA 2018).
@pytest.mark.parametrize(
    ("line", "number"),
    [
        ("5 ft m", "1.524"),
        ("5 W m-2 mW cm-2", "0.5"),
        ("10 in cm", "25.4"),
        ("1 parsec m", "3.08568e+16"),
        ("2 m cm", "200"),
        ("60 deg na rad", "1.0472"),
        ("1 эВ в нм", "1239.84"),
        ("500 люкс в фут-канделы", "46.4515"),
        ("5 метров в сантиметры", "500"),
        ("lux 500 to fc", "46.4515"),
        ("lux 500 in fc", "46.4515"),
        ("100 km za h to m/s", "27.7778"),
        ("500 люмен на м2 lx", "500"),
        ("10 W/m2 za h to J/m2/s/h", "10"),
        ("1000 lm na cd", REFUSED),  # a solid angle is missing
        ("1000 J na W", REFUSED),  # a time is missing
        ("100 lm na W", REFUSED),  # to watts, or lumens per watt
        ("1 eV na nm", REFUSED),
        ("5 W as J", REFUSED),  # attoseconds, or the joules of 5 W
        ("mag 6 lux", REFUSED),
        ("OD 2 %", REFUSED),
        ("dBm 20 mW", REFUSED),
        ("nm 532 eV", REFUSED),
        ("50% lx", REFUSED),
        ("100 lx + 10% fc", REFUSED),
    ],
)
def test_an_entry_point_answers_with_the_right_number(line, number):
    assert {*readings(line).values()} == {number}
