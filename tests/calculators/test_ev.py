"""Exposure values against closed forms."""

import math
from itertools import cycle, product

import pytest
from conftest import run
from helpers import number

from radcalc import check, ev
from radcalc.errors import Contradiction


@pytest.mark.parametrize(
    ("call", "name", "unit", "expected"),
    [
        (lambda: ev(ev100=15), "luminance", "cd/m2", 4096),
        (lambda: ev(ev100=15), "illuminance", "lx", 81920),
        (lambda: ev(luminance="1000cd/m2"), "ev100", "1", math.log2(8000)),
        (lambda: ev(f_number=16, time="1/100s", iso=100), "ev", "1", math.log2(25600)),
        (lambda: ev(illuminance="500lx", f_number=4, iso=400), "time", "s", 16 / 800),
    ],
)  # fmt: skip
def test_exposures_match_their_formulas(call, name, unit, expected):
    assert number(call(), name, unit) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("words", "reading"),
    [
        ("--luminance 100cd/m2 -g luminance:EV", math.log2(100 / 0.125)),
        ("--luminance 100cd/m2 --k 14cd.s/m2 -g luminance:EV", math.log2(100 / 0.14)),
        ("--illuminance 100lx --c 340lx.s -g illuminance:EV", math.log2(100 / 3.4)),
    ],
)
def test_a_reading_in_ev_depends_on_the_constant_of_the_meter(words, reading):
    done = run("ev", *words.split())
    assert float(done.stdout) == pytest.approx(reading, rel=1e-9)
    assert ("K = 12.5" in done.stderr.splitlines()[-1]) == (
        "--k" not in words and "--c" not in words
    )


@pytest.mark.parametrize(
    ("words", "expected"),
    [  # marks of neutral filters: opticalglasscn.com/ND.php
        ("--nd ND2 -g nd -g stops", (0.3, 1)),
        ("--nd ND0.9 -g nd -g stops", (0.9, 3)),
        ("--nd ND64 -g nd -g stops", (1.8, 6)),
        ("--nd ND400 -g nd -g stops", (2.6, 8 + 2 / 3)),
        ("--nd 3.0ND -g nd -g stops", (3.0, 10)),
        # 1 s becomes 8 s with three stops: practiceadvices.com, "calculate shutter speed"
        ("--unfiltered-time 1s --stops 3 -g time", (8,)),
        ("--time 8s --stops 3 -g unfiltered-time", (1,)),
        ("--time 8s --unfiltered-time 1s -g stops", (3,)),
    ],
)
def test_filters_match_a_table_of_a_manufacturer(words, expected):
    found = run("ev", *words.split()).stdout.split()
    assert list(map(float, found)) == pytest.approx(expected, rel=4e-3)


@pytest.mark.parametrize(
    ("words", "expected", "digits"),
    [  # idigitalphoto.com, "guide number": 45 and 5 m give f/9
        ("--guide-number 45m --distance 5m -g f-number", 9, 1e-12),
        # Kodak DCS 600 user's guide: 51 m at ISO 200 and 9 m give 5.67; at ISO 800 it is 102 m
        ("--f-number 5.67 --distance 9m --iso 200 -g guide-number", 51 / math.sqrt(2), 1e-3),
        ("--guide-number 36.06m --iso 800 --f-number 1 -g distance", 102, 1e-3),
        # Pentax MZ-7 manual: 11 m and f/2.8 reach 3.9 m; 22 m at ISO 400
        ("--guide-number 11m --f-number f/2.8 -g distance", 3.9, 1e-2),
        ("--guide-number 11m --distance 22m --f-number 1 -g iso", 400, 1e-12),
        # two stops less light: half the distance
        ("--guide-number 40m --f-number 4 --stops 2 -g distance", 5, 1e-12),
    ],
)
def test_the_range_of_a_flash_matches_its_manual(words, expected, digits):
    assert float(run("ev", *words.split()).stdout) == pytest.approx(expected, rel=digits)


@pytest.mark.parametrize(
    ("marked", "hints"),
    [
        ("8", {"8.0": "for the density", "ND8": "for the factor"}),
        ("ND103", {"0.9": "for 3 stops", "2.0128": "for a factor of 103"}),
        ("ND", {}),
        ("ND0", {"ND8": ""}),
        ("-1", {"1": " (--nd: 0 or more)"}),
    ],
)
def test_an_ambiguous_or_unknown_mark_of_a_filter_is_refused(marked, hints):
    done = run("ev", "--f-number", "8", "--time", "1s", "--nd", marked)
    assert done.returncode == 2
    _, *told = done.stderr.splitlines()
    if not hints:
        assert told == ["try: a number such as 1.5e3, 1/3 or 4pi"]
        return
    assert [line[5:] for line in told[::2]] == [
        f"radcalc ev --f-number 8 --time 1s --nd {hint}" for hint in hints
    ]
    for line, remark in zip(told[1::2], hints.values(), strict=True):
        assert line.endswith(remark)


def values_of(words):
    return run("ev", *words.split()).stdout


def test_a_filter_adds_its_stops_to_the_light():
    asked = "--f-number 8 --time 1/60s -g ev100 -g luminance"
    ev100, luminance = map(float, values_of(asked).split())
    more = list(map(float, values_of(f"{asked} --stops 3").split()))
    assert more == pytest.approx([ev100 + 3, 8 * luminance], rel=1e-11)


def test_a_short_exposure_time_is_a_fraction_only_in_tables():
    asked = "--f-number 8 --ev100 12 --nd ND4"  # 64 / 2^12 s, times 4
    assert "1/16 " in values_of(f"{asked} --format table")
    assert "time\t0.0625\ts" in values_of(asked)


def test_a_time_that_a_filter_would_shorten_is_refused():
    done = run("ev", "--time", "1/125s", "--unfiltered-time", "1/60s")
    assert (done.returncode, done.stdout) == (2, "")
    assert "--unfiltered-time" in done.stderr


# Marks of cameras, whose exact values are 2^(k/2) and 2^-k s for whole stops.
APERTURES = "1.4 2 2.8 4 5.6 8 11 16 22 32"
SHUTTERS = "1 1/2 1/4 1/8 1/15 1/30 1/60 1/125 1/250 1/500 1/1000"
# In third stops they are 2^(k/6), 2^(-k/3) s and ISO 100 2^(k/3); the first k are 9, 18 and 0.
THIRD_APERTURES = "2.8 3.2 3.5 4 4.5 5 5.6 6.3 7.1 8 9 10 11 13 14 16"
THIRD_SHUTTERS = "1/60 1/80 1/100 1/125 1/160 1/200 1/250 1/320 1/400 1/500"
SPEEDS = "100 125 160 200 250 320 400 500 640 800 1000 1250 1600"


def marks(series: str, first: int) -> list[tuple[int, str]]:
    return list(enumerate(series.split(), first))


def agrees(**inputs: str) -> bool:
    try:
        ev(**inputs)
    except Contradiction:
        return False
    return True


def test_marks_of_cameras_agree_in_whole_stops():
    for (k, f), (n, t) in product(marks(APERTURES, 1), marks(SHUTTERS, 0)):
        inputs = {"f_number": f, "time": f"{t} s"}
        assert agrees(**inputs, ev=str(k + n)), inputs
        assert not agrees(**inputs, ev=f"{k + n}.5"), inputs
        assert check(ev(**inputs), f"ev={k + n}.0"), inputs


def test_marks_of_cameras_agree_in_third_stops():
    speeds = cycle(marks(SPEEDS, 0))
    pairs = product(marks(THIRD_APERTURES, 9), marks(THIRD_SHUTTERS, 18))
    for ((k, f), (n, t)), (s, iso) in zip(pairs, speeds, strict=False):
        inputs = {"f_number": f, "time": f"{t} s", "iso": iso}
        exact = (k + n - s) / 3
        assert agrees(**inputs, ev100=f"{exact:.2f}"), inputs
        assert not agrees(**inputs, ev100=f"{exact + 0.5:.2f}"), inputs


def test_a_note_names_the_rounded_marks():
    found = ev(f_number="22", time="1/15 s", ev="13.0")
    assert [note.partition(" is rounded")[2] for note in found.notes] == [
        ", as marked on cameras: 22.63",
        ", as marked on cameras: 0.0625 s",
    ]
    assert not ev(f_number="16", time="1/4 s", ev="10").notes
