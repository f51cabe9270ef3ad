"""Conversions between different quantities under conditions, compared with hand calculations."""

import math

import pytest
from helpers import for_each

from radcalc.conversion.plan import plan, result_of_plan
from radcalc.errors import Plain, spell
from radcalc.inputs.reading import read
from radcalc.units.table import resolve

# value, source, target, conditions, result, relative tolerance, source of the result
WORKED = [
    (800, "lm", "cd", {"isotropic": True}, 800 / (4 * math.pi), 1e-15, "Phi = 4 pi I"),
    (800, "lm", "cd", {"hemisphere": True}, 800 / (2 * math.pi), 1e-15, "Phi = 2 pi I"),
    (800, "lm", "cd", {"half-angle": "60deg"}, 800 / math.pi, 1e-15, "2 pi (1 - cos 60) = pi"),
    (800, "lm", "cd", {"apex-angle": "120deg"}, 800 / math.pi, 1e-15, "2 pi (1 - cos 60) = pi"),
    (1, "lm", "cd", {"half-angle": "180deg"}, 1 / (4 * math.pi), 1e-15, "the whole sphere"),
    (1, "lm", "cd", {"half-angle": "1e-9rad"}, 1e18 / math.pi, 1e-12, "pi alpha^2 when small"),
    (1, "lm", "cd", {"solid-angle": "2sr"}, 0.5, 1e-15, "Phi = I Omega"),
    (1, "lm", "cd", {"exponent": "1"}, 1 / math.pi, 1e-15, "Lambertian: Phi = pi I0"),
    (1000, "cd", "lm", {"beam-angle": "30deg"}, 299, 2e-3, "299 lm as a cosine-power lobe"),
    (1000, "cd", "lm", {"apex-angle": "30deg"}, 214, 1e-3, "214 lm as a uniform cone"),
    (100, "cd", "lx", {"distance": "2m"}, 25, 1e-15, "E = I / d^2"),
    (100, "cd", "lx", {"distance": "2m", "incidence": "60deg"}, 12.5, 1e-14, "cos 60 = 1/2"),
    (100, "cd", "fc", {"distance": "10ft"}, 1, 1e-15, "1 fc is 1 cd at 1 ft"),
    (25, "lx", "cd", {"distance": "2m"}, 100, 1e-15, "I = E d^2"),
    (100, "cd", "lx", {"distance": "2m", "incidence": "90deg"}, 0, 0, "grazing"),
    (100, "cd", "lx", {"distance": "2m", "incidence": "120deg"}, 0, 0, "from behind"),
    (100, "lm", "lx", {"area": "4m2"}, 25, 1e-15, "E = Phi / A"),
    (1, "lm", "lx", {"diameter": "2m"}, 1 / math.pi, 1e-15, "A = pi R^2"),
    (1, "cd", "cd/m2", {"area": "1cm2"}, 1e4, 1e-15, "L = I / A: the stilb"),
    (1, "lx", "nit", {"reflectance": "1"}, 1 / math.pi, 1e-15, "1 lx on perfect white"),
    (500, "lx", "cd/m2", {"reflectance": "80%"}, 400 / math.pi, 1e-15, "L = rho E / pi"),
    (1, "nit", "lx", {"hemisphere": True}, math.pi, 1e-15, "M = pi L"),
    (1, "nit", "lx", {"half-angle": "30deg"}, math.pi / 4, 1e-15, "pi sin^2 30"),
    (1, "nit", "lx", {"half-angle": "90deg"}, math.pi, 1e-15, "the hemisphere"),
    (1, "nit", "lx", {"radius": "1m", "distance": "1m"}, math.pi / 2, 1e-15,
     "pi R^2 / (R^2 + d^2)"),
    (1, "nit", "lm", {"area": "1m2", "hemisphere": True}, math.pi, 1e-15, "Phi = pi L A"),
    (1, "nit", "lx", {"area": "1cm2", "distance": "1m"}, 1e-4, 1e-15, "L A / d^2"),
    (800, "lm", "nit", {"isotropic": True, "distance": "2m", "reflectance": "0.8"},
     800 / (16 * math.pi) * 0.8 / math.pi, 1e-14, "Phi/(4 pi d^2), then rho/pi"),
    (1000, "W/m2", "J/cm2", {"time": "1h"}, 360, 1e-15, "H = E t"),
    (300, "umol/m2/s", "mol/m2", {"time": "16h"}, 17.28, 1e-15, "300e-6 * 57600"),
    (100, "nit", "td", {"pupil": "3mm"}, 706.858347058, 1e-12, "100 pi 1.5^2"),
    (40, "W", "lm", {"efficacy": "93lm/W"}, 3720, 1e-15, "40 * 93"),
    (54, "lx", "umol/m2/s", {"efficacy": "54lm.s/umol"}, 1, 1e-15, "a ratio"),
    (2.1, "umol/s", "W", {"efficacy": "2.1umol/J"}, 1, 1e-15, "a ratio"),
    (1, "W", "lm", {"wavelength": "555nm"}, 683.002, 1e-15, "Km, CIE 018:2019"),
    (1, "W", "lm", {"wavelength": "540THz"}, 683, 1e-6, "the candela's definition"),
    (1, "cd", "W/sr", {"wavelength": "540THz"}, 1 / 683, 1e-6, "the candela's definition"),
    (1, "W", "lm", {"wavelength": "507nm", "observer": "scotopic"}, 1700.06, 1e-15, "K'm"),
    (5, "mW", "lm", {"wavelength": "632.8nm"}, 0.005 * 683.002 * 0.2372454, 1e-6,
     "0.23725 between 0.2448896 and 0.2353344 in the 1 nm table"),
    (2000, "umol/m2/s", "W/m2", {"wavelength": "660nm"},
     2000e-6 * 6.02214076e23 * 6.62607015e-34 * 299792458 / 660e-9, 1e-14, "N_A h c / lambda"),
    (1, "umol/s", "W", {"wavelength": "2eV"},
     6.02214076e17 * 2 * 1.602176634e-19, 1e-14, "2 eV a photon"),
    (1, "W/m2/nm", "W/m2/THz", {"wavelength": "555nm"}, 555e-9**2 / 299792458 * 1e21, 1e-14,
     "lambda^2 / c"),
    (1, "W/m2/THz", "W/m2/nm", {"wavelength": "555nm"}, 299792458 / 555e-9**2 * 1e-21, 1e-14,
     "c / lambda^2"),
    (1, "W/m2/um", "W/m2/cm-1", {"wavelength": "10um"}, 0.01, 1e-14, "lambda^2 = 1e-4 um cm"),
    (3, "W/m2/nm", "W/m2", {"bandwidth": "10nm"}, 30, 1e-15, "constant in the band"),
    (30, "W/m2", "W/m2/nm", {"bandwidth": "10nm"}, 3, 1e-15, "constant in the band"),
    (1, "W/m2/nm", "lx", {"bandwidth": "1nm", "wavelength": "555nm"}, 683.002, 1e-14, "Km"),
    (1, "W", "lm", {"wavelength": "300nm"}, 0, 0, "outside the table"),
    (500, "lx", "radlux", {"reflectance": "0.8"}, 400, 1e-15, "M = rho E"),
    (400, "radlux", "lx", {"reflectance": "80%"}, 500, 1e-15, "E = M / rho"),
    # a channel of 0.1 nm at 1550 nm: c d lambda / lambda^2 = 299792458e-10 / 1550e-9^2 Hz
    (0.1, "nm", "GHz", {"wavelength": "1550nm"}, 299792458e-10 / 1550e-9**2 / 1e9, 1e-14,
     "d nu = c d lambda / lambda^2"),
    (1, "cm-1", "nm", {"wavelength": "500nm"}, 500e-9**2 * 100 / 1e-9, 1e-14,
     "d lambda = lambda^2 d sigma"),
]  # fmt: skip


@for_each(WORKED)
def test_worked_values(value, source, target, conditions, expected, tolerance, origin):
    given_ = [read(name, text) for name, text in conditions.items()]
    got = plan(resolve(source), resolve(target), given_).apply(float(value))
    assert got == pytest.approx(expected, rel=tolerance, abs=0), origin


@pytest.mark.parametrize("nm", ["399.9", "400", "555", "700", "700.1"])
def test_photons_that_ppfd_does_not_count_are_noted(nm):
    made = plan(resolve("umol/s"), resolve("W"), [read("wavelength", f"{nm}nm")])
    assert any("400-700 nm" in note for note in made.notes) == (not 400 <= float(nm) <= 700)


def test_zero_lumens_are_an_answer_with_a_note():
    made = plan(resolve("W"), resolve("lm"), [read("wavelength", "300nm")])
    assert made.apply(1.0) == 0
    assert "300nm is invisible" in made.notes[0]


def test_every_answer_states_its_assumptions_or_the_table_of_the_eye_in_its_steps():
    for _, source, target, conditions, *_ in WORKED:
        given_ = [read(name, text) for name, text in conditions.items()]
        made = plan(resolve(source), resolve(target), given_)
        tables = [step for step in made.derive(1.0) if "in the 1 nm table" in step.reference]
        assert made.assumptions or tables, (source, target)


def test_steps_end_in_the_result():
    result = result_of_plan(
        plan(resolve("lm"), resolve("cd"), [read("half-angle", "60deg")]), 800.0, "", True
    )
    assert [step.law for step in result.steps] == ["solid angle of a cone", "conversion"]
    assert result.steps[-1].formula == "I_v = Φ_v / Omega"
    assert result.steps[-1].numbers == "800 lm / 3.14159 sr = 254.648 cd"


def test_the_dimension_of_every_factor_agrees_with_pint():
    """The factors of a plan, with Omega0, 1 cycle and 1 photon, are multiplied by Pint."""
    from radcalc.quantities import coherent_unit
    from radcalc.units.registry import light_registry

    q = light_registry().Quantity
    for _, source, target, conditions, *_ in WORKED:
        given_ = [read(name, text) for name, text in conditions.items()]
        made = plan(resolve(source), resolve(target), given_)
        total = q(1.0, coherent_unit(made.source))
        for factor, power in made.links:
            total = (
                total
                * q(1.0, factor.unit.replace("lm s/", "lm.s/").replace("td m2", "td.m2")) ** power
            )
        assert total.check(q(1.0, coherent_unit(made.target)).dimensionality), (source, target)


@pytest.mark.parametrize("degrees", [1e-9, 1e-6, 1e-3, 0.1, 1, 10, 90, 170, 179])
def test_the_lobe_of_a_narrow_beam_keeps_its_digits(degrees):
    import mpmath

    with mpmath.workdps(50):
        half = mpmath.mpf(degrees) * mpmath.pi / 360
        exponent = mpmath.log(mpmath.mpf(1) / 2) / mpmath.log(mpmath.cos(half))
        expected = (exponent + 1) / (2 * mpmath.pi)
    got = plan(resolve("lm"), resolve("cd"), [read("beam-angle", f"{degrees}deg")]).factor
    assert got == pytest.approx(float(expected), rel=1e-12)


# Its edges are 45 deg from its axis: its lower edge sets at 45 deg, its upper one at 135 deg.
@pytest.mark.parametrize(
    ("incidence", "place"),
    [("45deg", ""), ("46deg", "partly below"), ("134deg", "partly below"), ("136deg", "below")],
)
def test_a_disc_below_the_horizon_has_a_note(incidence, place):
    conditions = {"radius": "1m", "distance": "1m", "incidence": incidence}
    made = plan(resolve("nit"), resolve("lx"), [read(k, v) for k, v in conditions.items()])
    assert (made.apply(1.0) == 0) is (place == "below")
    notes = [spell(note, Plain) for note in made.notes]
    text = f"incidence {incidence}: the disc is {place} the receiver's horizon"
    assert notes == ([text] if place else [])


def test_lengths_and_wavelengths_are_not_mixed_without_a_note():
    assert plan(resolve("lm/m"), resolve("lm/nm")).notes
    assert plan(resolve("W/m3"), resolve("W/m2/nm")).notes
    assert not plan(resolve("lm/m"), resolve("lm/ft")).notes
    assert not plan(resolve("W/m2/nm"), resolve("W/m2/um")).notes
