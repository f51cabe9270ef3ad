"""Light and the current of a detector; light and the electric field of a plane wave."""

import numpy as np
import pytest
from conftest import run

import radcalc

Q = radcalc.Quantity


@pytest.mark.parametrize(
    ("source", "target", "responsivity", "expected"),
    [
        # rfwireless-world.com, "Photodiode responsivity": 50 mA of 500 mW is 0.1 A/W
        ("500mW", "mA", "0.1A/W", 50),
        ("50mA", "mW", "0.1A/W", 500),
        # coseti.org/9008-039.htm: 0.26 mA/mW at 656 nm
        ("3mW", "mA", "0.26mA/mW", 0.78),
    ],
)
def test_a_current_is_the_responsivity_times_the_radiant_flux(
    source, target, responsivity, expected
):
    found = radcalc.convert(source, target, responsivity=responsivity)
    assert found.magnitude == pytest.approx(expected, rel=1e-12)


def test_a_current_converts_under_other_conditions_as_its_watts_do():
    conditions = {"wavelength": "555nm", "area": "1cm2"}
    watts = radcalc.convert("100lx", "W", **conditions).magnitude
    amperes = radcalc.convert("100lx", "A", responsivity="0.4A/W", **conditions).magnitude
    assert amperes == pytest.approx(0.4 * watts, rel=1e-12)
    charge = radcalc.convert("100lx", "A.s", responsivity="0.4A/W", time="3s", **conditions)
    assert charge.magnitude == pytest.approx(1.2 * watts, rel=1e-12)
    back = radcalc.convert(Q(amperes, "A"), "lx", responsivity="0.4A/W", **conditions)
    assert back.magnitude == pytest.approx(100, rel=1e-12)


@pytest.mark.parametrize(("responsivity", "is_told"), [("4A/W", True), ("0.4A/W", False)])
def test_more_than_one_electron_per_photon_is_noted(responsivity, is_told):
    # of 500 nm, h c / lambda = 1239.842 eV nm / 500 nm = 2.479684 eV: 4 A/W are 9.91874 electrons
    for call in ("1 lm mA", "1 mA lm"):
        words = (*call.split(), "--responsivity", responsivity, "--wavelength", "500nm")
        assert ("9.91874 electrons per photon" in run("convert", *words).stderr) == is_told


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("5 mW uA", "responsivity is missing"),
        ("1 lm A --responsivity 0.5A/W", "a wavelength, a spectrum or an efficacy is missing"),
        ("1 mA uA --responsivity 0.4A/W", "--responsivity does not apply"),
        ("5 W/m2 V/m", "(peak or root mean square) is missing"),
        ("5 V/m kV/m --electric-field rms", "--electric-field does not apply"),
        ("5 lx W/m2 --wavelength 555nm --electric-field rms", "--electric-field does not apply"),
        ("-5 W/m2 V/m --electric-field rms", "negative"),
        ("1e300 V/m W/m2 --electric-field rms", "is out of range"),
        ("5 W/m2 V/m --field rms", "--field rms applies to the fields of lines"),
        ("5 W/m2 V/m --electric-field mean", "peak"),
    ],
)
def test_a_missing_or_unused_condition_is_refused(words, said):
    done = run("convert", *words.split())
    assert (done.returncode, done.stdout) == (2, "")
    assert said in done.stderr


@pytest.mark.parametrize(
    ("source", "target", "kind", "expected", "digits"),
    [
        # sqrt(2 * 376.73 ohm * 1380 W/m2) = 1019.7 V/m
        ("1380W/m2", "kV/m", "peak", 1.0197, 1e-4),
        # Z0 of CODATA 2022
        ("1W/m2", "V/m", "rms", 376.730313412**0.5, 1e-12),
        ("1V/m", "W/m2", "rms", 1 / 376.730313412, 1e-12),
        # eps0 c E^2 / 2 with eps0 = 8.8541878188e-12 F/m: sqrt(4 / (eps0 c)) V/m
        ("2W/m2", "V/m", "peak", (4 / (8.8541878188e-12 * 299792458)) ** 0.5, 1e-10),
    ],
)
def test_a_field_corresponds_to_the_irradiance_of_a_plane_wave(
    source, target, kind, expected, digits
):
    found = radcalc.convert(source, target, electric_field=kind)
    assert found.magnitude == pytest.approx(expected, rel=digits)


def test_fields_of_arrays_and_streams_equal_those_of_single_values():
    found = radcalc.convert(Q(np.array([0.0, 1.0, 3.0]), "V/m"), "W/m2", electric_field="rms")
    assert found.magnitude == pytest.approx(np.array([0, 1, 9]) / 376.730313412, rel=1e-12)
    words = ("convert", "-", "W/m2", "V/m", "--electric-field", "peak")
    done = run(*words, input="0\n1380\n")
    assert done.stdout.split() == ["0", "1019.69390751"]


def test_the_uncertainty_of_a_field_follows_its_slope():
    done = run("convert", "100+-1 V/m", "W/m2", "--electric-field", "rms")
    assert done.stdout.startswith("26.54 ± 0.53\t")  # 2 u(E) / E times 100^2 / 376.73
