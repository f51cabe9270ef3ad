"""Quantities of one photon and of a hot body, compared with the exact constants in decimals."""

from decimal import Decimal, getcontext

import numpy
import pytest
from conftest import run
from helpers import for_each

import radcalc
from radcalc.conversion.plan import plan
from radcalc.errors import ConditionError, ConversionError, Unused
from radcalc.units.table import resolve

getcontext().prec = 50
# The defining constants of the SI (SI Brochure, 9th edition, 2.2): exact.
C, H = Decimal(299792458), Decimal("6.62607015e-34")
K, E, N_A = Decimal("1.380649e-23"), Decimal("1.602176634e-19"), Decimal("6.02214076e23")
PI = Decimal("3.14159265358979323846264338327950288")
SIGMA = 2 * PI**5 * K**4 / (15 * H**3 * C**2)
WIEN_X = Decimal("4.96511423174427630369875913132")  # x = 5 (1 - e^-x); OEIS A094090
B = H * C / (K * WIEN_X)

JOULES = {  # of a photon from a number in the unit
    "nm": lambda n: H * C / (n * Decimal("1e-9")),
    "um": lambda n: H * C / (n * Decimal("1e-6")),
    "Å": lambda n: H * C / (n * Decimal("1e-10")),
    "Hz": lambda n: H * n,
    "THz": lambda n: H * n * Decimal("1e12"),
    "PHz": lambda n: H * n * Decimal("1e15"),
    "cm-1": lambda n: H * C * n * 100,
    "1/cm": lambda n: H * C * n * 100,
    "eV": lambda n: E * n,
    "keV": lambda n: 1000 * E * n,
    "J": lambda n: n,
    "J/photon": lambda n: n,
    "kJ/mol": lambda n: 1000 * n / N_A,
}
BACK = {
    "nm": lambda q: H * C / q / Decimal("1e-9"),
    "um": lambda q: H * C / q / Decimal("1e-6"),
    "Å": lambda q: H * C / q / Decimal("1e-10"),
    "Hz": lambda q: q / H,
    "THz": lambda q: q / H / Decimal("1e12"),
    "PHz": lambda q: q / H / Decimal("1e15"),
    "cm-1": lambda q: q / (H * C) / 100,
    "1/cm": lambda q: q / (H * C) / 100,
    "eV": lambda q: q / E,
    "keV": lambda q: q / E / 1000,
    "J": lambda q: q,
    "J/photon": lambda q: q,
    "kJ/mol": lambda q: q * N_A / 1000,
}
NUMBERS = (1.0, 532.0, 2.33, 0.0371, 18797.0)


@for_each([(source, target) for source in JOULES for target in BACK])
def test_every_pair_of_a_photon_follows_the_exact_constants(source, target):
    for number in NUMBERS:
        right = BACK[target](JOULES[source](Decimal(number)))
        found = plan(resolve(source), resolve(target)).apply(number)
        assert found == pytest.approx(float(right), rel=4e-16 * 4), (number, source, target)


def test_constants_of_codata():
    # CODATA 2022: sigma = 5.670374419...e-8 W/(m2 K4), b = 2.897771955...e-3 m K
    assert f"{SIGMA:.9e}" == "5.670374419e-8"
    assert f"{B:.9e}" == "2.897771955e-3"


@for_each([1.0, 2.725, 300.0, 2856.0, 5778.0, 1e6])
def test_a_black_body_of_a_temperature(kelvins):
    exitance = float(SIGMA * Decimal(kelvins) ** 4)
    rows = [
        ("K", "W/m2", kelvins, exitance),
        ("K", "kW/m2", kelvins, exitance / 1000),
        ("K", "W/m2/sr", kelvins, exitance / float(PI)),
        ("K", "um", kelvins, float(B / Decimal(kelvins) * 10**6)),
        ("K", "nm", kelvins, float(B / Decimal(kelvins) * 10**9)),
        ("W/m2", "K", exitance, kelvins),
        ("W/m2/sr", "K", exitance / float(PI), kelvins),
        ("nm", "K", float(B / Decimal(kelvins) * 10**9), kelvins),
    ]
    for source, target, number, right in rows:
        made = plan(resolve(source), resolve(target))
        assert made.apply(number) == pytest.approx(right, rel=1e-14), (source, target)
        assert "black body" in made.assumptions[0]


def answer(line: str, text: str = "") -> str:
    return run(*line.split(), input=text, together="--steps" in line, check=True).stdout


def test_known_values():
    # The sun as a black body of 5778 K, in every textbook: 63.2 MW/m2, 501.5 nm
    assert answer("5778 K MW/m2 -n --precision 3") == "63.2\n"
    assert answer("5778 K nm -n --precision 4") == "501.5\n"
    assert answer("532 nm eV -n --precision 6") == "2.33053\n"
    assert answer("500 1/cm nm -n") == "20000\n"
    # mired: 1e6 / T, by its definition
    assert answer("200 mired nm -n") == answer("5000 K nm -n")


@for_each([("300 K", "W/m2"), ("300 K", "W/m2/sr"), ("400 W/m2", "K"), ("100 W/m2/sr", "K")])
def test_an_emissivity(value, target):
    black = radcalc.convert(value, target).magnitude
    grey = radcalc.convert(value, target, emissivity=0.5).magnitude
    times = 0.5 if target != "K" else 2**0.25
    assert grey == pytest.approx(black * times, rel=1e-14)


def test_arrays_equal_single_values():
    numbers = numpy.array([400.0, 532.0, 700.0])
    found = radcalc.convert(radcalc.Quantity(numbers, "nm"), "eV").magnitude
    assert list(found) == [radcalc.convert(f"{n} nm", "eV").magnitude for n in numbers]
    found = radcalc.convert(["300 K", "5778 K"], "W/m2", emissivity=[0.5, 1.0]).magnitude
    single = [radcalc.convert("300 K", "W/m2", emissivity=0.5), radcalc.convert("5778 K", "W/m2")]
    assert list(found) == [one.magnitude for one in single]


def test_a_stream_equals_single_calls():
    numbers = ["400", "532", "0.5", "1e3"]
    out = answer("convert - nm eV", "\n".join(numbers) + "\n")
    assert out == "".join(answer(f"{number} nm eV -n") for number in numbers)


def test_an_uncertainty_follows_the_slope():
    # u(Q) / Q = u(lambda) / lambda; u(M) / M = 4 u(T) / T
    found = radcalc.convert("532+-1 nm", "eV").magnitude
    assert found.std_dev / found.nominal_value == pytest.approx(1 / 532, rel=1e-6)
    found = radcalc.convert("300+-1 K", "W/m2").magnitude
    assert found.std_dev / found.nominal_value == pytest.approx(4 / 300, rel=1e-6)


def test_steps_and_check():
    assert "Q = h c / (532 nm) = 3.73392e-19 J" in answer("532 nm eV --steps")
    out = answer("5778 K W/m2/sr --steps")
    assert "M = 1 sigma (5778 K)^4 = 6.32007e+07 W/m2" in out
    assert "M = pi Omega0 L" in out
    assert answer("532 nm eV --check 2.33eV").startswith("right")
    assert answer("5778 K W/m2 --check 63.2MW/m2").startswith("right")
    assert run("532", "nm", "eV", "--check", "2.5eV").returncode == 1


def test_a_result_has_the_name_of_its_quantity():
    assert list(radcalc.explain("532 nm", "eV")) == ["photon_energy"]
    assert list(radcalc.explain("500 THz", "nm")) == ["wavelength"]
    assert list(radcalc.explain("300 K", "W/m2")) == ["radiant_exitance"]
    assert list(radcalc.explain("300 K", "um")) == ["peak_wavelength"]


@for_each([("5 m", "eV"), ("440 Hz", "m"), ("1 mm", "THz"), ("3 K", "mm"), ("3000 K", "lm"),
           ("3000 K", "eV"), ("3 m", "K"), ("500 lx", "K")])  # fmt: skip
def test_other_lengths_and_light_stay_refused(value, target):
    with pytest.raises(ConversionError, match="no condition links them") as caught:
        radcalc.convert(value, target)
    assert caught.value.hint


def test_a_width_needs_the_place_of_its_band():
    # d nu = c d lambda / lambda^2
    found = radcalc.convert("1 nm", "THz", wavelength="550 nm").magnitude
    assert found == pytest.approx(299792458e-12 * 1e-9 / 550e-9**2, rel=1e-12)
    assert "not the width of a band" in radcalc.explain("1 nm", "THz").assumptions[0]


@for_each([("532 nm", "eV", {"time": "3 s"}), ("532 THz", "eV", {"wavelength": "500 nm"}),
           ("5778 K", "um", {"emissivity": 0.9}), ("5778 K", "W/m2", {"area": "1 m2"}),
           ("532 nm", "eV", {"emissivity": 0.9})])  # fmt: skip
def test_a_condition_without_use_is_refused(value, target, given):
    with pytest.raises(Unused):
        radcalc.convert(value, target, **given)


@for_each([("0 nm", "eV"), ("-5 nm", "eV"), ("0 K", "W/m2"), ("-3 W/m2", "K"), ("-1 THz", "nm")])
def test_nothing_is_0_or_negative(value, target):
    with pytest.raises(ConditionError, match="of 0 or less"):
        radcalc.convert(value, target)


@for_each([("1e-305 nm", "ueV"), ("1e300 K", "W/m2")])
def test_what_a_float_does_not_hold_is_refused(value, target):
    with pytest.raises(ConversionError, match="out of range"):
        radcalc.convert(value, target)


def test_an_emissivity_is_from_0_to_1():
    for text in ("0", "1.2", "-0.5"):
        with pytest.raises(ConditionError, match="out of range"):
            radcalc.convert("300 K", "W/m2", emissivity=text)
