"""Scales, in both directions, compared with GNU units and published values."""

import math
import re
import subprocess

import pytest
from conftest import ROOT, python, run
from following import call
from helpers import for_each, require
from hypothesis import given
from hypothesis import strategies as st

import radcalc
from radcalc.conversion.plan import plan
from radcalc.errors import RadcalcError, UnitError
from radcalc.units.reading import read_amount
from radcalc.units.scale_table import SCALES, spellings
from radcalc.units.table import SCALE_NAMES, resolve
from radcalc.units.values import ScaleUnit, find_scale, resolve_any

ROWS = {f"{scale.name} ({scale.unit})": scale for scale in SCALES}


def convert(number: float, source: str, target: str) -> float:
    return plan(resolve_any(source), resolve_any(target)).apply(number)


@pytest.mark.parametrize("row", ROWS)
@given(st.floats(-300.0, 300.0))
def test_reading_and_value_are_inverse(row, number):
    scale = ROWS[row]
    if not scale.steps:
        number = abs(number) + 1e-3
    again = scale.reading(scale.quantity(number))
    assert again == pytest.approx(number, rel=1e-12, abs=1e-12 * max(1, abs(scale.steps)))
    assert scale.quantity(again) == pytest.approx(scale.quantity(number), rel=1e-12)


@pytest.mark.parametrize("row", ROWS)
@given(st.floats(1.0, 200.0))
def test_the_slope_is_that_of_the_function(row, number):
    scale = ROWS[row]
    step = 1e-5
    secant = (scale.quantity(number + step) - scale.quantity(number - step)) / (2 * step)
    assert scale.slope(number) == pytest.approx(secant, rel=1e-6)


def gnu_units(have: str, want: str) -> float:
    """Return the answer of GNU units."""
    require("units")
    words = ["units", "-1", "-o", "%.17g", "-t", have, want]
    asked = subprocess.run(words, capture_output=True, text=True, check=True, timeout=60)
    return float(asked.stdout)


@pytest.mark.parametrize("reading", [-27.5, -3.0, 0.0, 4.25, 21.5])
@pytest.mark.parametrize(
    ("scale", "function", "unit", "theirs"),
    [
        ("dBm", "dBm", "mW", "mW"),
        ("dBW", "dBW", "W", "W"),
        ("dB", "dB", "1", "1"),
        ("mag", "vmag", "lx", "lx"),
        ("mag/arcsec2", "SB_sec", "cd/m2", "cd/m^2"),
        ("EV", "EV100", "cd/m2", "cd/m^2"),
        ("EV", "iv100", "lx", "lx"),
        ("bril", "bril", "cd/m2", "cd/m^2"),
    ],
)
def test_gnu_units_agrees_on_a_scale(scale, function, unit, theirs, reading):
    quantity = gnu_units(f"{function}({reading})", theirs)
    assert convert(reading, scale, unit) == pytest.approx(quantity, rel=1e-12)
    back = gnu_units(f"{quantity!r} {theirs}", function)
    assert convert(quantity, unit, scale) == pytest.approx(back, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("kelvins", [1667.0, 2856.0, 6504.0])
def test_a_mired_is_a_reciprocal_megakelvin(kelvins):
    """ANSI/IES LS-1: 10^6/T with T in kelvins; GNU units 2.22 is off by 1e12."""
    assert convert(kelvins, "K", "mired") == pytest.approx(1e6 / kelvins, rel=1e-15)
    assert convert(kelvins, "K", "MK-1") == pytest.approx(1e6 / kelvins, rel=1e-15)
    assert convert(1e6 / kelvins, "MK-1", "K") == pytest.approx(kelvins, rel=1e-15)
    assert convert(1e6 / kelvins, "MK-1", "mired") == pytest.approx(1e6 / kelvins, rel=1e-15)


@pytest.mark.parametrize(
    ("number", "source", "target", "printed", "off"),
    [
        # GNU units, definitions file: the visual magnitude of the sun, and the surface of the moon
        (-26.74, "mag", "lx", 126134.45, 1e-7),
        (3.3679199, "mag/arcsec2", "cd/m2", 4858.6546, 1e-8),
        # Unihedron, "Convert visual mags/arcsecond2 to cd/m2", with 10.8e4 for the reference
        (21.31, "mag/arcsec2", "ucd/m2", 323.16, 2e-3),
        (21.30, "mag/arcsec2", "ucd/m2", 326.15, 2e-3),
        (0.0, "mag/arcsec2", "cd/m2", 10.8e4, 1e-3),
        # Oke and Gunn 1983: AB = -2.5 lg(f) - 48.60, f in erg/s/cm2/Hz; astropy 6 for 0 ABmag
        (0.0, "ABmag", "Jy", 3630.7805477010035, 1e-14),
        (0.0, "mag(AB)", "erg/s/cm2/Hz", 3.6307805477010035e-20, 1e-14),
        (5.0, "AB mag", "Jy", 36.307805477010035, 1e-14),
        (22.0, "ABmag/arcsec2", "Jy/arcsec2", 3630.7805477010035 * 10**-8.8, 1e-14),
        # Federal Standard 1037C: zero dBm equals one milliwatt; dBW from its definition
        (0.0, "dBm", "mW", 1.0, 1e-15),
        (0.0, "dBW", "dBm", 30.0, 1e-15),
        (0.0, "dBu(W)", "dBm", -30.0, 1e-15),
        # Jacobson and others, Manual of Photography: 2^EV/8 cd/m2 and 2.5 2^EV lx at ISO 100
        (15.0, "EV", "cd/m2", 4096.0, 1e-15),
        (15.0, "EV", "lx", 81920.0, 1e-15),
        # a Wratten 85B: 5500 K to 3200 K is 131 mired; 10^-0.3 is half, an ND 0.9 is 3 stops
        (3200.0, "K", "mired", 312.5, 1e-15),
        (5500.0, "K", "mired", 181.8, 1e-3),
        (0.3, "OD", "%", 50.1, 1e-3),
        (0.9, "OD", "stops", -3.0, 4e-3),
        (3.0, "stops", "1", 8.0, 1e-15),
        (3.0, "dB", "1", 1.995, 1e-3),
        (100.0, "bril", "lambert", 1.0, 1e-15),
        # 60^2 square seconds of arc in a square minute: 21.2 - 2.5 lg 3600; 21.2 - 5 lg 3600
        (21.2, "mag/arcsec2", "mag/arcmin2", 12.30924, 1e-6),
        (21.2, "mag/arcsec2", "mag/deg2", 3.418487, 1e-6),
        (12.30924, "mag arcmin-2", "mpsas", 21.2, 1e-6),
    ],
)
def test_published_values_are_found(number, source, target, printed, off):
    assert convert(number, source, target) == pytest.approx(printed, rel=off)


# Arithmetic with readings, by hand: twice the light is 2.5 lg 2 = 0.7526 mag less, or one stop
# more; 2.5 lx 2^10 are 2560 lx; 3 dB and 3 stops are steps of dBm and EV; a stop is 2.5 lg 2 mag.
SUMS = {
    ("(21 mag/arcsec2) + (21 mag/arcsec2)", "mag/arcsec2"): 21 - 2.5 * math.log10(2),
    ("(21 mag/arcsec2)*2", "mag/arcsec2"): 21 - 2.5 * math.log10(2),
    ("(21 mag arcsec-2) * 2", "mag/arcmin2"): 21 - 2.5 * math.log10(2 * 3600),
    ("(12 mag/arcmin2)*1", "mag/arcsec2"): 12 + 2.5 * math.log10(3600),
    ("(10 EV)*2", "lx"): 5120.0,
    ("(10 EV)*2", "cd/m2"): 256.0,
    ("2 (10 EV100)", "EV"): 11.0,
    ("13 EV - 3 stops", "EV"): 10.0,
    ("13 EV - 3 stops", "lx"): 2560.0,
    ("(13 EV) - 3 stops + 1 stop", "EV"): 11.0,
    ("(13 EV - 3 stops) * 2", "EV"): 11.0,
    ("10 dBm + 3 dB", "dBm"): 13.0,
    ("(10 dBm) - (3 dB)", "dBW"): -23.0,
    ("-10 dB(1 mW) - 3 dB", "dBm"): -13.0,
    ("(10 dBm + 3 dB) * 2", "dBm"): 13 + 10 * math.log10(2),
    ("(10 dBm) + (10 dBm)", "dBm"): 10 + 10 * math.log10(2),
    ("21 mag/arcsec2 - 1 stop", "mpsas"): 21 + 2.5 * math.log10(2),
    ("20 bril + 3 stops", "bril"): 23.0,
    # kelvins of sums of reciprocals: 1e6/(200 - 100), 1/(1/3200 - 1/5000), 1e6/200
    ("1/(1/(200 mired) - 1/(100 mired))", "K"): 10000.0,
    ("1/(1/(3200 K) - 1/(200 mired))", "K"): 8888.888889,
    ("((200 mired))", "K"): 5000.0,
    ("1/(200 mired)", "MK-1"): 200.0,
}


@for_each(SUMS)
def test_readings_in_brackets_and_levels_with_gains_are_quantities(text, target):
    right = pytest.approx(SUMS[text, target], rel=1e-9)
    found = radcalc.convert(text, target)
    assert getattr(found, "magnitude", found) == right
    assert float(run("convert", text, target, "-n").stdout) == right
    assert float(run("prompt", input=f"{text} to {target}\n").stdout.split()[0]) == right


# What is refused, with the answer to the first call that the hint proposes, if it proposes one.
REFUSED_SUMS = {
    ("(200 mired)-(100 mired)", "K"): 10000.0,
    ("(200 mired) - (100 mired)", "mired"): 100.0,
    ("(3200 K)-(200 mired)", "K"): 8888.888889,
    ("5600 K + 134 mired", "mired"): 1e6 / 5600 + 134,
    ("-(200 mired)", "K"): None,
    ("2*(200 mired)", "K"): None,
    ("(200 mired)/2", "K"): None,
    ("(200 mired)/(100 mired)", "1"): None,
    ("10 dBm + 10 dBm", "dBm"): None,
    ("10 dBm + 3", "dBm"): None,
    ("3 dB + 3 dB", "dB"): None,
    ("21 mag/arcsec2 * 2", "mag/arcsec2"): None,
    ("21 mag/arcsec2 - 1 mag", "mag/arcsec2"): None,
    ("500 lx - 1 EV", "lx"): None,
    ("(10 EV)*2 m2", "lm"): None,
    # a density counts losses, and none of these is one
    ("200%", "OD"): math.log10(2),
    ("(3 dB)", "OD"): 0.3,
    ("3 dB", "OD"): 0.3,
    ("2 stops", "OD"): 0.60206,
}


@for_each(REFUSED_SUMS)
def test_sums_of_readings_and_gains_as_losses_are_refused(text, target):
    right = REFUSED_SUMS[text, target]
    outcome = call(["convert", text, target])
    assert outcome.status == 2
    assert outcome.error.hint
    if right:
        words, _ = next(outcome.proposed)
        assert float(run(*words, "-n").stdout) == pytest.approx(right, rel=1e-6)
    with pytest.raises(RadcalcError):
        radcalc.convert(text, target)
    assert run("prompt", input=f"{text} to {target}\n").returncode == 2


def test_a_factor_above_one_has_no_density():
    assert run("convert", "1", "1", "OD", "-n").stdout == "0\n"
    assert run("convert", "1", "1", "dB", "-n").stdout == "0\n"
    assert run("convert", "1", "1", "%", "-n").stdout == "100\n"
    assert "a density above 0 is less" in run("convert", "2", "1", "OD").stderr
    assert "a density above 0 is less" in run("convert", "-", "1", "OD", input="0.5\n2\n").stderr
    assert radcalc.convert([0.1, 1.0], "OD") == pytest.approx([1.0, 0.0])
    with pytest.raises(RadcalcError, match="a density above 0 is less"):
        radcalc.convert([0.1, 2.0], "OD")


def test_the_constant_of_a_meter_is_not_that_of_a_reading_in_arithmetic():
    assert float(run("convert", "10 EV", "cd/m2", "--k", "14", "-n").stdout) == 0.14 * 2**10
    done = run("convert", "13 EV - 3 stops", "EV", "--k", "14")
    assert done.returncode == 2
    assert "--k 14 does not apply to a reading in arithmetic" in done.stderr


@for_each(spellings())
def test_a_spelling_of_a_scale_is_not_a_unit(spelling):
    assert isinstance(find_scale(spelling), ScaleUnit)
    with pytest.raises(UnitError):
        resolve(spelling)


@pytest.mark.parametrize("unit", ["dBm/m2", "W/dB", "mag/m2", "OD.m-1", "EV s", "2 dBm", "mired2"])
def test_a_scale_is_not_part_of_a_unit(unit):
    assert find_scale(unit) is None
    with pytest.raises(UnitError):
        resolve_any(unit)


@pytest.mark.parametrize(
    "text",
    ["mag/arcsec^2", "mag arcsec-2", "mag/arcsec²", "mag·arcsec⁻²", "mpsas", "mag/arcsecond**2"],
)
def test_magnitudes_per_square_second_of_arc_have_the_spellings_of_units(text):
    assert read_amount(f"21.5 {text}").reading == 21.5
    with pytest.raises(RadcalcError):
        read_amount(f"2*21.5 {text}")
    assert convert(0.0, text, "cd/m2") == convert(0.0, "mag/arcsec2", "cd/m2")


@pytest.mark.parametrize(
    ("text", "scale"),
    [("dBµW", "dBu(W)"), ("dB (1 mW)", "dBm"), ("Decibels", "dB"), ("Optical density", "OD"),
     ("MIRED", "mired"), ("EV100", "EV")],
)  # fmt: skip
def test_other_spellings_are_understood(text, scale):
    assert find_scale(text).scale == find_scale(scale).scale


def test_an_amount_on_a_scale_is_converted_with_a_remark():
    amount = read_amount("-30 dBm")
    assert (amount.number, amount.unit.text) == (1e-3, "mW")
    assert (amount.reading, amount.scale.text) == (-30.0, "dBm")
    assert amount.assumptions == ("dBm: P = 1 mW * 10^(n/10), a level of power",)


@pytest.mark.parametrize(
    ("number", "source", "target"),
    [(0.0, "W", "dBm"), (-1.0, "lx", "mag"), (1e5, "dBm", "W"), (-1e5, "dBm", "W"),
     (0.0, "mired", "K"), (-100.0, "mired", "K"), (math.inf, "stops", "1"), (3.0, "dB", "OD"),
     (1e9, "bril", "cd/m2"), (1e4, "mag", "lx"), (0.0, "%", "OD")],
)  # fmt: skip
def test_a_value_without_a_reading_or_a_reading_without_a_value_is_refused(number, source, target):
    with pytest.raises(RadcalcError) as caught:
        convert(number, source, target)
    assert caught.value.hint


@pytest.mark.parametrize("name", sorted({scale.name for scale in SCALES}))
def test_the_manual_describes_every_scale(name):
    page = (ROOT / "man" / "man7" / "radcalc-units.7").read_text(encoding="utf-8")
    section = page.partition(".Sh SCALES")[2].partition(".Sh ")[0]
    items = [line for line in section.splitlines() if line.startswith(".It Li ")]
    assert any(name in item.replace(",", " ").split() for item in items)


def test_the_table_of_units_has_the_names_of_scales():
    """The table repeats them, up to `/` or `(`, because it must not import the scales."""
    assert set(SCALE_NAMES) == {re.split(r"[/(_]", scale.name)[0] for scale in SCALES}


def test_a_scale_in_a_product_is_refused_as_a_scale_before_any_scale_is_read():
    code = "from radcalc.units.table import resolve\nresolve('Wh/dBm')"
    assert "'dBm' is a scale" in python(code).stderr


@pytest.mark.parametrize("words", ["(21 mag/arcsec2)*2 mag/arcsec2", "13 EV - 3 stops EV"])
def test_a_scale_of_an_expression_and_of_its_target_is_said_once(words):
    text, _, target = words.rpartition(" ")
    said = run("convert", text, target).stderr.splitlines()
    assert len(said) == 1
    assert said[0].startswith(f"assumed: {target}: ")
