"""Units of one quantity: ratios are exact and rounded once."""

import math
from fractions import Fraction

import pytest
from helpers import for_each
from hypothesis import given
from hypothesis import strategies as st

from radcalc.conversion.plan import plan
from radcalc.errors import ConversionError
from radcalc.units import compiled
from radcalc.units.table import resolve
from radcalc.units.values import resolve_any

ALPHA_OPIC = ("sc", "mc", "lc", "rh", "mel")
OF_WATTS = (*ALPHA_OPIC, "ery", "act", "uva", "blh", "par", *"UBVRI")
OF_EYES = ("scot", "ten", "jv", "cf", "cften")
OF_PHOTONS = ("epar", "fr", "rs", "frs", "ypf", *"ugrizG")
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
    ("klux", "lx", Fraction(1000)),
    ("fcd", "fc", Fraction(1)),
    ("Lmb", "lambert", Fraction(1)),
    ("Ein", "mol", Fraction(1)),
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
    ("W/A", "V", Fraction(1)),
    ("mA", "uA", Fraction(1000)),
    # Weighted units are those of their light; the UV index is 40 m2/W (WHO 2002), the dose SED
    # 100 J/m2 (CIE S 007), the EML 0.9058 lx of melanopic EDI (WELL v2, feature L03).
    ("UVI", "mW_ery/m2", Fraction(25)),
    ("SED", "J_ery/m2", Fraction(100)),
    ("EML", "lx_mel", Fraction("0.9058")),
    ("epfd", "umol_epar/m2/s", Fraction(1)),
    ("ypfd", "umol_ypf/m2/s", Fraction(1)),
    *[(f"W_{kind}.s", f"J_{kind}", Fraction(1)) for kind in OF_WATTS],
    *[(f"cd_{kind}.sr", f"lx_{kind}.m2", Fraction(1)) for kind in ALPHA_OPIC],
    *[(f"lm_{kind}/m2", f"lx_{kind}", Fraction(1)) for kind in OF_EYES],
    *[(f"kJy_{band}", f"Jy_{band}", Fraction(1000)) for band in "UBVRIugrizG"],
    *[(f"flam_{band}.m2", f"flam_{band}.m2", Fraction(1)) for band in "UBVRIugrizG"],
    *[(f"fc_{kind}", f"cd_{kind}.sr/m2", 1 / FOOT**2) for kind in OF_EYES],
    *[(f"mol_{kind}", f"photon_{kind}", Fraction(602214076 * 10**15)) for kind in OF_PHOTONS],
]


def test_every_unit_has_a_value_from_its_definition():
    named = {name for row in EXACT for text in row[:2] for name, _ in resolve(text).atoms}
    assert set(compiled.UNITS) <= named


@for_each(EXACT)
def test_a_unit_has_the_value_of_its_definition(source, target, value):
    assert plan(resolve(source), resolve(target)).factor == pytest.approx(float(value), rel=1e-15)


def _by_quantity() -> list[list[str]]:
    groups: dict[tuple[int, ...], list[str]] = {}
    for name, (_, _, dimension, _) in compiled.UNITS.items():
        # exitance is irradiance times a reflectance
        leaves = name.startswith("rad") and dimension == resolve("lx").dimension
        groups.setdefault((*dimension, leaves), []).append(name)
    return list(groups.values())


@for_each(_by_quantity())
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
def test_a_conversion_there_and_back_returns_the_value(pair, value):
    there = plan(resolve(pair[0]), resolve(pair[1]))
    back = plan(resolve(pair[1]), resolve(pair[0]))
    assert back.apply(there.apply(value)) == pytest.approx(value, rel=1e-15)


def test_a_plain_conversion_is_rounded_once():
    # 100 lx are 1e-5 klm/cm2 exactly
    assert plan(resolve("lx"), resolve("klm/cm2")).apply(100.0) == 1e-5
    assert plan(resolve("in"), resolve("m")).apply(3.0) == 0.0762


@pytest.mark.parametrize("value", [1e300, -1e300])
def test_a_result_beyond_a_float_is_refused(value):
    with pytest.raises(ConversionError, match="is out of range"):
        plan(resolve("km"), resolve("qm")).apply(value)


@pytest.mark.parametrize(("source", "target"), [("lx", "fc"), ("mW", "dBm")])
def test_nan_is_refused_as_not_a_number(source, target):
    with pytest.raises(ConversionError, match="not a number"):
        plan(resolve(source), resolve_any(target)).apply(math.nan)


def test_a_result_below_a_float_is_refused():
    with pytest.raises(ConversionError, match="is out of range"):
        plan(resolve("qm"), resolve("Qm")).apply(1e-290)


def test_a_ratio_beyond_a_float_is_refused():
    with pytest.raises(ConversionError, match="is out of range"):
        plan(resolve("Qm12"), resolve("qm12"))
