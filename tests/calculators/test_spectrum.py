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
    return {value.name: value.amount for value in describe(given).values}


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


def test_colour_science_says_nothing_on_standard_error():
    done = run("spectrum", "LED-B3", "-g", "cri", "-q")
    assert (done.returncode, done.stderr) == (0, "")
