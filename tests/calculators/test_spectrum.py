"""What a spectrum is described by, against published values."""

import math

import pytest
from conftest import run

from radcalc.calculators.spectrum import spectrum as describe
from radcalc.errors import RadcalcError
from radcalc.given import read


def results(text: str, range_: str = "") -> dict[str, float]:
    given = {"spectrum": read("spectrum", text)}
    if range_:
        given["range"] = read("range", range_)
    return {value.name: value.amount for value in describe(given).values if not value.is_absent}


def test_a_spectrum_is_described():
    # the nominal sun of 5772 K: Wien 502.04 nm, Stefan-Boltzmann 6.2939e7 W/m2
    sun = results("blackbody:5772K")
    assert sun["peak-wavelength"] == pytest.approx(2.897771955e-3 / 5772, rel=1e-9)
    assert sun["exitance"] == pytest.approx(5.670374419e-8 * 5772**4, rel=1e-9)
    assert sun["radiance"] == pytest.approx(sun["exitance"] / math.pi, rel=1e-14)
    assert sun["cct"] == pytest.approx(5772, abs=1)
    # CIE 15: A is x 0.4476, y 0.4074, 2856 K and, as its own reference, Ra 100
    a = results("A")
    assert (a["x"], a["y"]) == pytest.approx((0.4476, 0.4074), abs=5e-5)
    assert a["cct"] == pytest.approx(2856, abs=1)
    assert a["cri"] == pytest.approx(100, abs=0.05)
    assert a["sp-ratio"] == pytest.approx(1.41, abs=0.005)
    d65 = results("D65")
    assert (d65["x"], d65["y"]) == pytest.approx((0.3127, 0.3290), abs=5e-5)
    # CIE 15, table of fluorescent lamps: F2 4230 K, Ra 64; F11 4000 K, Ra 83
    for name, temperature, rendering in (("F2", 4230, 64), ("F11", 4000, 83)):
        lamp = results(name)
        assert lamp["cct"] == pytest.approx(temperature, abs=10)
        assert lamp["cri"] == pytest.approx(rendering, abs=1)


def test_a_range_has_its_share_and_its_efficacy():
    half = results("band:400nm:700nm", "300nm:550nm")
    assert half["range-fraction"] == pytest.approx(0.5)
    assert half["range-start"] == pytest.approx(400e-9)  # there is nothing before
    whole = results("gaussian:530nm,30nm")
    assert whole["fwhm"] == pytest.approx(30e-9, rel=1e-3)
    assert whole["centroid-wavelength"] == pytest.approx(530e-9, rel=1e-9)
    assert "cct" not in whole  # green is no white


def test_no_power_in_the_range_is_refused():
    with pytest.raises(RadcalcError, match="no power"):
        results("band:500nm:600nm", "700nm:800nm")


def test_more_lumens_than_the_watts_can_give_are_refused():
    with pytest.raises(RadcalcError, match="leaves out most"):
        results("D65", "600nm:610nm")


@pytest.mark.parametrize(
    ("source", "name", "reason"),
    [
        ("gaussian:530nm,30nm", "cct", "the CIE's limit is 0.05"),
        ("gaussian:470nm,150nm", "duv", "beyond that of a black body of an infinite temperature"),
        ("blackbody:1e5K", "cri", "CIE daylight, which ends at 25000 K"),
        ("line:2um", "cct", "nothing of this spectrum is seen"),
        ("line:2um", "x", "nothing of this spectrum is seen"),
        ("line:555nm", "fwhm", "a line has no width"),
        ("band:500nm:600nm", "fwhm", "the data end above half"),
        ("band:800nm:900nm", "lux-per-ppfd", "no photons"),
        ("line:2um", "sp-ratio", "nothing of this spectrum is seen"),
    ],
)
def test_a_result_that_has_no_meaning_says_why(source, name, reason):
    done = run("spectrum", source, "-g", name)
    assert (done.returncode, done.stdout) == (2, "")
    assert reason in done.stderr


def test_a_colour_far_from_its_reference_is_rendered_with_a_note():
    # CIE 13.3-1995 wants at most 5.4e-3 in (u, v); the low-pressure sodium lamp has more
    assert "CIE 13.3 is for up to 0.0054" in run("spectrum", "LPS").stderr
    assert "CIE 13.3" not in run("spectrum", "HP1").stderr
