import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc.conversion.conditions import give
from radcalc.conversion.plan import answer, plan
from radcalc.errors import ConversionError
from radcalc.units import compiled
from radcalc.units.table import resolve

FOOT, INCH = Fraction("0.3048"), Fraction("0.0254")
PI = Fraction("3.14159265358979323846264338327950288419716939937510582")
# (units, the exact value of the first in the second), from the definitions of the units: the
# international foot and inch, the SI Brochure, GNU units' definitions file of 2022, and for the
# sun the nominal values of IAU 2015 resolution B3.
EXACT = [
    ("fc", "lx", 1 / FOOT**2),
    ("phot", "lx", Fraction(10**4)),
    ("nox", "lx", Fraction(1, 1000)),
    ("metre-candle", "lx", Fraction(1)),
    ("footlambert", "cd/m2", 1 / FOOT**2 / PI),
    ("lambert", "cd/m2", Fraction(10**4) / PI),
    ("apostilb", "cd/m2", 1 / PI),
    ("blondel", "nit", 1 / PI),
    ("skot", "apostilb", Fraction(1, 1000)),
    ("stilb", "nit", Fraction(10**4)),
    ("cd/ft2", "nit", 1 / FOOT**2),
    ("cd/in2", "nit", 1 / INCH**2),
    ("fL", "mL", Fraction(1000) / (FOOT * 100) ** 2),
    ("talbot", "lm.s", Fraction(1)),
    ("lumerg_cgs", "talbot", Fraction(1, 10**7)),
    ("violle", "cd", Fraction("20.17")),
    ("mscp", "lm", 4 * PI),
    ("langley", "J/m2", Fraction(41840)),
    ("pyron", "W/m2", Fraction(41840, 60)),
    ("finsen", "W/m2", Fraction(10**5)),
    ("Jy", "W/m2/Hz", Fraction(1, 10**26)),
    ("flick", "W/m2/sr/um", Fraction(10**4)),
    ("flick", "W/m2/sr/nm", Fraction(10)),
    ("W/cm2", "W/m2", Fraction(10**4)),
    ("erg/s", "W", Fraction(1, 10**7)),
    ("cal", "J", Fraction("4.184")),
    ("cal_it", "J", Fraction("4.1868")),
    ("Btu", "J", Fraction("1055.05585262")),
    ("kWh", "J", Fraction(3600000)),
    ("eV", "J", Fraction("1.602176634e-19")),
    ("mol", "photon", Fraction("6.02214076e23")),
    ("einstein", "mol", Fraction(1)),
    ("rayleigh", "photon/s/cm2/sr", Fraction(10**6) / (4 * PI)),
    ("deg", "rad", PI / 180),
    ("arcsec", "deg", Fraction(1, 3600)),
    ("gon", "deg", Fraction(9, 10)),
    ("turn", "deg", Fraction(360)),
    ("deg2", "sr", (PI / 180) ** 2),
    ("spat", "sr", 4 * PI),
    ("kayser", "m-1", Fraction(100)),
    ("au", "m", Fraction(149597870700)),
    ("ly", "m", Fraction(9460730472580800)),
    ("mi", "km", Fraction("1.609344")),
    ("angstrom", "nm", Fraction(1, 10)),
    ("acre", "ft2", Fraction(43560)),
    ("micron", "nm", Fraction(1000)),
    ("yard", "m", 3 * FOOT),
    ("nautical_mile", "m", Fraction(1852)),
    ("thou", "in", Fraction(1, 1000)),
    ("light_second", "m", Fraction(299792458)),
    ("parsec", "m", 648000 * Fraction(149597870700) / PI),
    ("solar_radius", "km", Fraction(695700)),
    ("hectare", "m2", Fraction(10**4)),
    ("sqft", "m2", FOOT**2),
    ("sqm", "cm2", Fraction(10**4)),
    ("litre", "cm3", Fraction(1000)),
    ("percent", "1", Fraction(1, 100)),
    ("permille", "1", Fraction(1, 1000)),
    ("ppm", "ppb", Fraction(1000)),
    ("min", "s", Fraction(60)),
    ("h", "min", Fraction(60)),
    ("d", "h", Fraction(24)),
    ("week", "d", Fraction(7)),
    ("yr", "d", Fraction(1461, 4)),
    ("arcmin", "deg", Fraction(1, 60)),
    ("mas", "arcsec", Fraction(1, 1000)),
    ("hour_angle", "deg", Fraction(15)),
    ("sqdeg", "deg2", Fraction(1)),
    ("hemisphere", "sr", 2 * PI),
    ("lb", "g", Fraction("453.59237")),
    ("oz", "g", Fraction("28.349523125")),
    ("tonne", "kg", Fraction(1000)),
    ("rpm", "Hz", Fraction(1, 60)),
    ("K", "mK", Fraction(1000)),
    ("Wh", "Ws", Fraction(3600)),
    ("cal_th", "J", Fraction("4.184")),
    ("Btu_it", "J", Fraction("1055.05585262")),
    ("Btu_th", "cal_th", Fraction("453.59237") / Fraction("1.8")),
    ("foot_pound", "J", Fraction("1.3558179483314004")),
    ("hp", "W", Fraction("745.69987158227022")),
    ("solar_luminosity", "W", Fraction("3.828e26")),
    ("solar_constant", "W/m2", Fraction(1361)),
    ("sfu", "Jy", Fraction(10**4)),
    ("cp", "cd", Fraction(1)),
    ("decimal_candle", "cd", Fraction("1.0085")),
    ("carcel_974", "cd", Fraction("9.74")),
    ("carcel_961", "cd", Fraction("9.61")),
    ("hefner_0903", "cd", Fraction("0.903")),
    ("hefner_0918", "cd", Fraction("0.918")),
    ("international_candle_10187", "cd", Fraction("1.0187")),
    ("international_candle_102", "cd", Fraction("1.02")),
    ("milliphot", "lx", Fraction(10)),
    ("mcs", "lx.s", Fraction(1)),
    ("lxs", "lx.s", Fraction(1)),
    ("lxh", "lx.s", Fraction(3600)),
    ("footcandle_second", "lx.s", 1 / FOOT**2),
    ("footcandle_hour", "footcandle_second", Fraction(3600)),
    ("radlux", "lm/m2", Fraction(1)),
    ("radphot", "lm/cm2", Fraction(1)),
    ("equivalent_lux", "cd/m2", 1 / PI),
    ("equivalent_phot", "cd/cm2", 1 / PI),
    ("uL", "L", Fraction(1, 10**6)),
    ("lumen_second", "talbot", Fraction(1)),
    ("lmh", "lm.s", Fraction(3600)),
    ("lumerg_talbot", "talbot", Fraction(1)),
    ("ktd", "td", Fraction(1000)),
]


def test_every_unit_has_a_value_from_its_definition():
    named = {name for row in EXACT for text in row[:2] for name, _ in resolve(text).atoms}
    assert set(compiled.UNITS) <= named


@pytest.mark.parametrize(("source", "target", "value"), EXACT)
def test_a_unit_is_worth_its_definition(source, target, value):
    assert plan(resolve(source), resolve(target)).factor == pytest.approx(float(value), rel=1e-15)


def _by_quantity() -> list[list[str]]:
    groups: dict[tuple[int, ...], list[str]] = {}
    for name, (_, _, dimension, _) in compiled.UNITS.items():
        groups.setdefault(dimension, []).append(name)
    return list(groups.values())


@pytest.mark.parametrize("names", _by_quantity(), ids=lambda names: names[0])
def test_every_pair_of_units_of_a_quantity_agrees_with_pint(names):
    from radcalc.units.registry import light_registry

    registry = light_registry()
    for source in names:
        for target in names:
            pint_says = registry.Quantity(1.0, source).to(target).magnitude
            ours = plan(resolve(source), resolve(target)).factor
            assert ours == pytest.approx(pint_says, rel=1e-12), (source, target)


PAIRS = [(a, b) for names in _by_quantity() for a in names for b in names]


@given(st.sampled_from(PAIRS), st.floats(min_value=1e-30, max_value=1e30))
def test_there_and_back_is_where_one_was(pair, value):
    there = plan(resolve(pair[0]), resolve(pair[1]))
    back = plan(resolve(pair[1]), resolve(pair[0]))
    assert back.apply(there.apply(value)) == pytest.approx(value, rel=1e-15)


# value, source, target, conditions, result, relative tolerance, where the result comes from
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
]  # fmt: skip


@pytest.mark.parametrize(
    ("value", "source", "target", "conditions", "expected", "tolerance", "origin"), WORKED
)
def test_worked_values(value, source, target, conditions, expected, tolerance, origin):
    given_ = [give(name, text) for name, text in conditions.items()]
    got = plan(resolve(source), resolve(target), given_).apply(float(value))
    assert got == pytest.approx(expected, rel=tolerance, abs=0), origin


def test_zero_lumens_are_an_answer_with_a_note():
    made = plan(resolve("W"), resolve("lm"), [give("wavelength", "300nm")])
    assert made.apply(1.0) == 0
    assert "nothing is seen at 300nm" in made.notes[0]


@pytest.mark.parametrize("value", [1e300, -1e300])
def test_a_result_beyond_a_float_is_refused(value):
    with pytest.raises(ConversionError, match="cannot be held"):
        plan(resolve("km"), resolve("qm")).apply(value)


def test_a_result_below_a_float_is_refused():
    with pytest.raises(ConversionError, match="cannot be held"):
        plan(resolve("qm"), resolve("Qm")).apply(1e-290)


def test_a_ratio_beyond_a_float_is_refused():
    with pytest.raises(ConversionError, match="cannot be held"):
        plan(resolve("Qm12"), resolve("qm12"))


def test_every_answer_says_what_it_assumed():
    for _, source, target, conditions, *_ in WORKED:
        given_ = [give(name, text) for name, text in conditions.items()]
        assert plan(resolve(source), resolve(target), given_).assumptions, (source, target)


def test_steps_end_in_the_result():
    result = answer(
        plan(resolve("lm"), resolve("cd"), [give("half-angle", "60deg")]), 800.0, "", True
    )
    assert [step.law for step in result.steps] == ["solid angle of a cone", "conversion"]
    assert result.steps[-1].formula == "I_v = Φ_v / Omega"
    assert result.steps[-1].numbers == "800 lm / 3.14159 sr = 254.648 cd"


def test_the_dimension_of_every_factor_is_what_pint_says():
    """Omega0, 1 cycle and 1 photon written out: what a plan multiplies by, Pint multiplies out."""
    from radcalc.quantities.light import coherent_unit
    from radcalc.units.registry import light_registry

    q = light_registry().Quantity
    for _, source, target, conditions, *_ in WORKED:
        given_ = [give(name, text) for name, text in conditions.items()]
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
    got = plan(resolve("lm"), resolve("cd"), [give("beam-angle", f"{degrees}deg")]).factor
    assert got == pytest.approx(float(expected), rel=1e-12)


def test_a_disc_below_the_horizon_gives_nothing_and_says_so():
    conditions = {"radius": "1m", "distance": "1m", "incidence": "136deg"}
    made = plan(resolve("nit"), resolve("lx"), [give(k, v) for k, v in conditions.items()])
    assert made.apply(1.0) == 0
    assert "below the receiver's horizon" in made.notes[0]


def test_lengths_and_wavelengths_are_not_mixed_without_a_note():
    assert plan(resolve("lm/m"), resolve("lm/nm")).notes
    assert plan(resolve("W/m3"), resolve("W/m2/nm")).notes
    assert not plan(resolve("lm/m"), resolve("lm/ft")).notes
    assert not plan(resolve("W/m2/nm"), resolve("W/m2/um")).notes


def test_a_plain_conversion_is_rounded_once():
    # 100 lx are 1e-5 klm/cm2 exactly
    assert plan(resolve("lx"), resolve("klm/cm2")).apply(100.0) == 1e-5
    assert plan(resolve("in"), resolve("m")).apply(3.0) == 0.0762
