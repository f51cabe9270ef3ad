"""Uncertainties in Python: against formulas, random draws, and differences of plain calls."""

import math

import numpy
import pytest
from conftest import run
from following import call
from helpers import answers
from uncertainties import ufloat

import radcalc
from radcalc.errors import RadcalcError

Q = radcalc.Quantity
DRAWS = 100_000
SEED = 20260801


def parts(quantity):
    return quantity.magnitude.nominal_value, quantity.magnitude.std_dev


# By the rules of JCGM 100:2008, 5.1: f = c x^p y^q has (u(f)/f)^2 = (p u(x)/x)^2 + (q u(y)/y)^2.
@pytest.mark.parametrize(
    ("call", "value", "relative"),
    [
        (lambda: radcalc.convert("100+-3 lx", "fc"), 100 * 0.3048**2, 3 / 100),
        (lambda: radcalc.convert("800(20) lm", "cd", isotropic=True), 200 / math.pi, 20 / 800),
        (
            lambda: radcalc.convert("100.0+-2.0 cd", "lx", distance="2.00+-0.03 m"),
            25.0,
            math.hypot(2 / 100, 2 * 0.03 / 2),
        ),
        (
            lambda: radcalc.convert("100 lx", "cd/m2", reflectance="0.80+-0.02"),
            80 / math.pi,
            0.02 / 0.8,
        ),
        (
            lambda: radcalc.convert("100 cd", "lx", distance="1m", incidence="60+-1deg"),
            50.0,
            math.tan(math.pi / 3) * math.radians(1),
        ),
        (
            lambda: radcalc.convert("1.00+-0.05 W", "lm", efficacy="300+-10 lm/W"),
            300.0,
            math.hypot(0.05, 10 / 300),
        ),
        (
            lambda: radcalc.point_source(intensity="100+-2 cd", distance="2+-0.03m")["irradiance"],
            25.0,
            math.hypot(2 / 100, 2 * 0.03 / 2),
        ),
        (
            lambda: radcalc.point_source(intensity="100+-2 cd", irradiance="25.0+-0.3lx")[
                "distance"
            ],
            2.0,
            math.hypot(2 / 100, 0.3 / 25) / 2,
        ),
        (
            lambda: radcalc.lambertian(luminance="100+-5 cd/m2", area="0.1+-0.001 m2")["flux"],
            10 * math.pi,
            math.hypot(0.05, 0.01),
        ),
        (
            lambda: radcalc.calorimeter(
                mass="10.0+-0.1g", specific_heat="385J/kg/K", temperature_rise="2.0+-0.1K"
            )["energy"],
            7.7,
            math.hypot(0.01, 0.05),
        ),
        (
            lambda: radcalc.ev(f_number="8.0+-0.1", time="1/100s", iso="100", k="12.5 cd.s/m2")[
                "luminance"
            ],
            12.5 * 64,
            2 * 0.1 / 8,
        ),
    ],
)
def test_products_and_powers_follow_the_rule(call, value, relative):
    number, size = parts(call())
    assert number == pytest.approx(value, rel=1e-12)
    assert size == pytest.approx(abs(value) * relative, rel=1e-6)


def test_a_logarithm_and_a_lobe_by_their_derivatives():
    """EV = log2(L S / K): u = u(L) / (L ln 2); I = (n + 1) Phi / (2 pi): u = Phi u(n) / (2 pi)."""
    ev = radcalc.ev(luminance="4096+-100 cd/m2", k="12.5 cd.s/m2")["ev100"]
    assert parts(ev)[1] == pytest.approx(100 / (4096 * math.log(2)), rel=1e-9)
    lobe = radcalc.point_source(flux="100 lm", exponent="5.0+-0.2", distance="1m")
    assert parts(lobe["intensity"])[1] == pytest.approx(100 * 0.2 / (2 * math.pi), rel=1e-9)


TABLE = {
    "a lamp's cone": (
        "point_source",
        {"flux": "800 lm", "half_angle": "40 deg", "height": "2.5 m", "offset": "0.6 m"},
    ),
    "a lobe's exponent": (
        "point_source",
        {"intensity": "100 cd", "beam_angle": "35 deg", "distance": "3 m", "incidence": "20 deg"},
    ),
    "light of another kind": (
        "point_source",
        {"flux": "5 mW", "wavelength": "632.8 nm", "distance": "1m"},
    ),
    "a disc aside": (
        "lambertian",
        {"shape": "disc", "luminance": "1e4 cd/m2", "radius": "25 cm", "height": "75 cm"}
        | {"offset": "10 cm"},
    ),
    "a sphere": (
        "lambertian",
        {"shape": "sphere", "flux": "100 lm", "radius": "5 cm", "distance": "1m"},
    ),
    "a rectangle": (
        "lambertian",
        {"shape": "rectangle", "luminance": "500 cd/m2", "width": "1 m", "length": "2 m"}
        | {"height": "1.5 m", "incidence": "10 deg"},
    ),
    "a reflector": ("lambertian", {"incident_irradiance": "500 lx", "reflectance": "0.7"}),
    "a camera": ("ev", {"f_number": "5.6", "time": "0.01 s", "iso": "200"}),
    "a calorimeter": (
        "calorimeter",
        {"flux": "3 W", "mass": "20 g", "specific_heat": "385 J/kg/K", "time": "30 s"}
        | {"absorptance": "0.95", "receiver_area": "4 cm2"},
    ),
    "a sky": (
        "sky",
        {"kind": "12", "sun_elevation": "40 deg", "horizontal_illuminance": "12 klx"}
        | {"tilt": "35 deg", "sun_azimuth": "20 deg", "azimuth": "60 deg"},
    ),
    "surroundings": ("environment", {"source": "sky:overcast", "zenith_luminance": "9 kcd/m2"}),
}


@pytest.mark.parametrize("name", TABLE)
def test_every_slope_is_the_difference_of_two_lanes(name):
    """Inputs changed by a part in 1e5 change the results as the uncertainties predict."""
    function, given = TABLE[name]
    call = getattr(radcalc, function)
    for key, text in given.items():
        number, _, unit = text.partition(" ")
        if key in ("shape", "kind", "source") or (not unit and "." not in number):
            continue
        number = float(number)
        off = 1e-5 * number
        low, high = (call(**{**given, key: f"{number + d!r} {unit}"}) for d in (-off, off))
        found = call(**{**given, key: f"{number!r}+-{off!r} {unit}"})
        assert found.keys() == low.keys() == high.keys()
        for result, quantity in found.items():
            difference = (high[result] - low[result]).magnitude / 2
            size = getattr(quantity.magnitude, "std_dev", 0.0)
            away = abs(size - abs(difference))
            assert away <= 1e-4 * abs(difference) + 1e-9 * abs(high[result].magnitude), result


# The standard error of a standard deviation s of n draws is s / sqrt(2 n); 4 of them, and what the
# curvature adds: for f = x^p it is of the second order in u(x)/x, here below 0.2 % of s.
@pytest.mark.parametrize(
    ("function", "given", "result"),
    [
        ("convert", {"value": (100, 1, "cd"), "target": "lx", "distance": (2, 0.01, "m")}, None),
        (
            "convert",
            {"value": (1, 0.01, "W"), "target": "lm", "wavelength": (600, 0.5, "nm")},
            None,
        ),
        (
            "point_source",
            {"flux": (800, 8, "lm"), "distance": (2, 0.01, "m"), "incidence": (40, 0.5, "deg")},
            "irradiance",
        ),
        (
            "lambertian",
            {"luminance": (1e4, 100, "cd/m2"), "area": (10, 0.1, "cm2"), "height": (1, 0.005, "m")},
            "irradiance",
        ),
    ],
)
def test_random_draws_have_the_same_spread(function, given, result):
    generator = numpy.random.default_rng(SEED)
    call = getattr(radcalc, function)
    drawn, stated = {}, {}
    for key, one in given.items():
        if isinstance(one, str):
            drawn[key] = stated[key] = one
        else:
            value, off, unit = one
            drawn[key] = Q(generator.normal(value, off, DRAWS), unit)
            stated[key] = Q(ufloat(value, off), unit)
    every, one = call(**drawn), call(**stated)
    if result:
        every, one = every[result], one[result]
    number, size = parts(one)
    bound = 4 / math.sqrt(2 * DRAWS) + 0.002
    assert numpy.std(every.magnitude) == pytest.approx(size, rel=bound)
    assert numpy.mean(every.magnitude) == pytest.approx(number, abs=size * 0.02)


def test_nominal_values_equal_those_without_uncertainty():
    for function, given in TABLE.values():
        call = getattr(radcalc, function)
        plain = call(**given)
        key, text = next((k, t) for k, t in given.items() if " " in t)
        number, _, unit = text.partition(" ")
        found = call(**{**given, key: f"{number}+-{float(number) / 50} {unit}"})
        for name, quantity in plain.items():
            magnitude = found[name].magnitude
            assert getattr(magnitude, "nominal_value", magnitude) == quantity.magnitude


def test_results_are_correlated_with_their_inputs():
    distance = ufloat(2, 0.01)
    one, two = (
        radcalc.point_source(flux=f"{flux} lm", distance=Q(distance, "m"))["irradiance"].magnitude
        for flux in (800, 400)
    )
    assert one.std_dev == pytest.approx(0.01 * one.nominal_value, rel=1e-6)
    assert (one / two).std_dev < 1e-12
    assert (one - one).std_dev == 0
    assert (one * distance**2).std_dev == pytest.approx(0, abs=1e-9)
    assert set(one.error_components()) == {distance}


def test_texts_are_variables_with_the_names_of_their_keywords():
    found = radcalc.point_source(flux="800+-20 lm", distance="2.00+-0.03 m")["irradiance"]
    shares = {one.tag: size for one, size in found.magnitude.error_components().items()}
    value = 200 / math.pi / 4
    assert shares == pytest.approx({"flux": value / 40, "distance": value * 0.03}, rel=1e-6)


@pytest.mark.parametrize(
    ("call", "value", "uncertainty"),
    [
        (lambda: radcalc.convert(Q(100, "lx").plus_minus(3), "fc"), 9.290304, 0.27870912),
        (lambda: radcalc.convert("100 cd", "lx", distance=Q(2, "m").plus_minus(0.02)), 25, 0.5),
        (
            lambda: radcalc.point_source(flux=Q(800, "lm").plus_minus(20))["intensity"],
            200 / math.pi,
            5 / math.pi,
        ),
        # 2.5 lx * 2^10, and ln(2) of it per step: only one of the two readings of the scale fits
        (lambda: radcalc.convert("10±1 EV", "lx"), 2560, 2560 * math.log(2)),
    ],
)
def test_measurements_of_pint_and_readings_are_accepted(call, value, uncertainty):
    assert parts(call()) == pytest.approx((value, uncertainty), rel=1e-6)


def test_equal_inputs_have_separate_shares():
    # u^2 = (100 * 3)^2 + (100 * 3)^2 = 424.264^2: half of it each
    steps = radcalc.explain("(100+-3) lx * (100+-3) m2", "lm").steps
    share = "300 by value 100±3 (50 %)"
    assert steps[-1].numbers == f"424.264 lm: {share}, {share}"


def test_texts_are_explained_with_their_shares():
    """Of 200 lm, 6 lm are from 3 lx and 10 lm from 0.1 m2."""
    told = radcalc.explain("(100±3) lx * (2.0±0.1) m2", "lm").steps[-1].numbers
    assert told == "11.6619 lm: 10 by value 2.0±0.1 (73.5 %), 6 by value 100±3 (26.5 %)"


@pytest.mark.parametrize(
    ("number", "problem"), [(math.nan, "is not a number"), (math.inf, "is infinite")]
)
@pytest.mark.parametrize("make", [float, lambda number: ufloat(number, 1)])
def test_other_values_than_numbers_are_refused(number, problem, make):
    with pytest.raises(RadcalcError, match=problem):
        radcalc.convert(Q(make(number), "lx"), "fc")


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (
            lambda: radcalc.point_source(flux="800+-20lm", intensity="63.66cd", distance="2m"),
            "cannot be checked against redundant inputs",
        ),
        (
            lambda: radcalc.convert(Q(numpy.ones(2), "cd"), "lx", distance="1+-0.1m"),
            "array",
        ),
        (
            lambda: radcalc.point_source(flux="8+-1lm", distance=Q(numpy.ones(2), "m")),
            "several values",
        ),
        (lambda: radcalc.convert(Q([ufloat(1, 0.1)] * 2, "lx"), "fc"), "real numbers"),
        (lambda: radcalc.scene([], [[0, 0, 0]], efficacy="100+-1lm/W"), "a scene"),
        (lambda: radcalc.convert("100 cd", "lx", distance="1+-inf m"), "not a finite number"),
        (
            lambda: radcalc.convert("1 cd", "lx", distance=Q(ufloat(1, math.inf), "m")),
            "uncertainty",
        ),
    ],
)
def test_uncertainties_that_cannot_be_propagated_are_refused(call, said):
    with pytest.raises(RadcalcError, match=said):
        call()


# Each command with an uncertain input: it propagates the uncertainty or refuses it.
EVERY = {
    "convert": "100+-3 lx fc",
    "solid-angle": "cone --half-angle 30+-1deg",
    "direction": "--polar 45+-1deg --azimuth 30deg",
    "etendue": "--area 1.00(5)mm2 --half-angle 30deg",
    "integrate": "cos(theta) --half-angle 60+-1deg",
    "point-source": "--flux 800+-20lm --distance 2m",
    "lambertian": "--luminance 100+-2cd/m2 --area 1cm2",
    "uberlight": "0,0,4 --intensity 100+-3cd",
    "sky": "overcast --zenith-luminance 9000+-100cd/m2",
    "environment": "sky:overcast --zenith-luminance 9000+-100cd/m2",
    "ev": "--f-number 8.0+-0.1 --time 1/100s",
    "calorimeter": "--energy 7.7+-0.1J --mass 10g --specific-heat 385J/kg/K",
    "screen": "--flux 2500+-50lm --width 2.00+-0.01m --height 1.1m",
    "sensor": "--luminance 100+-5cd/m2 --f-number 2.8",
    "laser": "--flux 5.0+-0.1mW --diameter 1mm --divergence 1.00+-0.05mrad --distance 10m",
    "room": "--area 54m2 --illuminance 500+-25lx --flux 3600lm --utilance 0.60+-0.03",
    "photon": "555+-2nm",
    "spectrum": "blackbody:2856+-20K",
    "mesopic": "--luminance 0.10+-0.01cd/m2 --sp-ratio 2",
}


@pytest.mark.parametrize("command", EVERY)
def test_every_command_propagates_an_uncertainty(command):
    done = call([command, *EVERY[command].split(), "--json"])
    assert done.status == 0
    (answer,) = answers(done.output)
    assert any("uncertainty" in one for one in answer["results"].values() if not one["given"])
    assert any("k = 1" in text for text in answer["assumptions"])


@pytest.mark.parametrize(
    "words",
    [
        "scene lamps.csv --at 0,0,0 --efficacy 100+-3lm/W",
        "environment sky:overcast --zenith-luminance 9+-1cd/m2 --irradiance-map none.pfm",
        "sky overcast --zenith-luminance 9+-1cd/m2 --save none.pfm",
        "convert 100 lx cd/m2 --reflectance 0.80+-0.02:0.9:0.1",
        "point-source --flux 800+-20lm --distance 1m:5000m:1m -g irradiance",
        "solid-angle zone --polar 10+-1deg:30deg",
        "integrate 1 --polar 10+-1deg:30deg",
        "spectrum D65 --range 380+-1nm:780nm",
        "direction --polar 30deg --azimuth 0deg --reflect-at 1+-0.1,0,1",
        "ev --ev100 15 --check 4096cd/m2 --tolerance 5+-1%",
    ],
)
def test_commands_without_propagation_refuse_uncertainties(words):
    done = call(words.split())
    assert (done.status, done.output) == (2, "")


def test_a_spectrum_has_the_slope_of_its_temperature():
    """M = sigma T^4; by the law of Wien the peak is at b/T."""
    (answer,) = answers(call(["spectrum", "blackbody:2856+-20K", "--json"]).output)
    for name, power in (("exitance", 4), ("peak-wavelength", 1), ("temperature", 1)):
        one = answer["results"][name]
        assert one["uncertainty"] / one["value"] == pytest.approx(power * 20 / 2856, rel=1e-4)


def test_a_result_may_be_requested_on_a_scale():
    """n = 10 lg(P / 1 mW): u(n) = 10 / ln(10) u(P)/P."""
    asked = "flux-uncertainty:dBm"
    done = call(["point-source", "--flux", "10.0+-0.1mW", "--distance", "2m", "-g", asked])
    assert float(done.output) == pytest.approx(10 / math.log(10) * 0.01, rel=1e-6)


# The interval of an input is its value plus and minus its uncertainty.
@pytest.mark.parametrize(
    ("words", "limit"),
    [
        ("lambertian --incident-irradiance 500lx --reflectance 0.95+-0.1", "from 0 to 1"),
        ("solid-angle cone --half-angle 180+-1deg", "at most 180 deg"),
        ("solid-angle cone --solid-angle 12.566370614359172(100000)sr", "at most"),
        ("etendue --area 1cm2 --na 1.0+-0.01 -g etendue:cm2.sr", "at most 1, in air"),
        ("etendue --area 1cm2 --na 0.9999+-0.01", "at most 1, in air"),
        ("point-source --intensity 100cd --distance 1+-1m", "more than 0"),
        ("point-source --intensity 100cd --distance 1+-2m", "more than 0"),
        ("convert 100 cd lx --distance 2.0+-2.5m", "more than 0"),
        ("convert 100+-150mW dBm", "no reading on dBm"),
        ("convert 100lx*sqrt(0.31+-2.5) lx", "a smaller uncertainty"),
        ("spectrum blackbody:2856+-2900K", "a black body of -44 K"),
        ("photon 555+-600nm", "more than 0"),
    ],
)
def test_an_interval_that_leaves_the_range_of_its_input_is_refused(words, limit):
    done = call(words.split())
    assert (done.status, done.output) == (2, "")
    assert "is out of range within its uncertainty" in str(done.error)
    assert limit in f"{done.error} {done.error.hint}"


def test_an_interval_up_to_a_limit_is_propagated():
    """pi A NA^2 at 0.99: 2 * 0.01 / 0.99 of it; 1 is the limit of NA in air."""
    result = "etendue-uncertainty:cm2.sr"
    done = call(["etendue", "--area", "1cm2", "--na", "0.99+-0.01", "-g", result])
    assert float(done.output) == pytest.approx(2 * math.pi * 0.99 * 0.01, rel=1e-6)


# The values of a result at both ends, from the formula in each comment, are further from the
# straight line than its uncertainty, and than 1 % of it.
@pytest.mark.parametrize(
    "words",
    [
        # 100 / 1.1^2 is 82.6, and 25 + 22.5 is 47.5
        "convert 100cd lx --distance 2.0+-0.9m",
        # 10 lg(1) is 0, and 6.99 - 3.47 is 3.52
        "convert 5+-4mW dBm",
        # V is 1 at 555 nm with a slope of 0; at 540 nm 0.954, at 545 nm 0.980
        "convert 1 W lm --wavelength 550+-10nm",
        "convert 1 W lm --wavelength 555+-30nm",
        # 500/200 is 2.5, and 1 + 0.6 is 1.6
        "photon 500+-300nm -g photon-energy",
        "convert (0±1)^2*1m2 cm2",
        "convert 100lx*(0.31+-2.5)^2 lx",
        "convert 10+-10OD 1",
        # poles between the ends
        "convert 100lx/(2.0+-2.5)^2 lx",
        "convert 100lx/(0.3+-2.5) lx",
        # asin(NA) has an infinite slope at 1
        "etendue --area 1cm2 --na 0.99+-0.01 -g half-angle",
    ],
)
def test_a_result_that_bends_is_refused(words):
    done = call(words.split())
    assert (done.status, done.output) == (2, "")
    assert "has no standard uncertainty: it jumps or bends within" in str(done.error)


# A curved result keeps the uncertainty of its slope.
@pytest.mark.parametrize(
    ("words", "value", "uncertainty"),
    [
        ("etendue --area 1cm2 --na 0.5+-0.01 -g etendue:cm2.sr", math.pi / 4, 0.01 * math.pi),
        ("convert 100cd lx --distance (2±0.5)*1m", 25.0, 12.5),
        # 10 mW over 4 pi, with a slope of ln(10)/10 per dB
        (
            "point-source --flux 10+-3dBm -g intensity:W/sr",
            0.01 / 4 / math.pi,
            0.01 / 4 / math.pi * 0.3 * math.log(10),
        ),
        # extrema, at whose ends the results differ by less than 1 %
        ("convert 100*cos(0±5deg)*1lx fc", 100 * 0.3048**2, 0.0),
        ("convert 100 cd lx --distance 2m --incidence 0+-5deg", 25.0, 0.0),
        ("convert 100 cd lx --distance 2m --incidence 60+-5deg", 12.5,
         25 * math.sin(math.pi / 3) * math.radians(5)),
        ("convert (100±3)*1lx/(2.0±0.5) lx", 50.0, 50 * math.hypot(0.03, 0.25)),
        # V is 0.6438 at 599 nm and 0.6182 at 601 nm; its table has no corner that counts
        ("convert 1 W lm --wavelength 600.0+-0.5nm", 683.002 * 0.631, 4.386),
    ],
)  # fmt: skip
def test_a_curved_result_has_the_uncertainty_of_its_slope(words, value, uncertainty):
    (answer,) = answers(call([*words.split(), "--json"]).output)
    (result,) = answer["results"].values()
    assert result["value"] == pytest.approx(value, rel=1e-12)
    assert result.get("uncertainty", 0.0) == pytest.approx(uncertainty, rel=1e-3)


def test_units_on_whose_scales_the_interval_has_no_reading_are_left_out():
    """At -0.1 of the light there is no density; 0.3 ± 0.4 has one in no unit."""
    (answer,) = answers(call(["convert", "(30+-40)%", "--json"]).output)
    (result,) = answer["results"].values()
    assert {"OD", "dB"}.isdisjoint(row["unit"] for row in result["also"])
    (answer,) = answers(call(["convert", "(30+-20)%", "--json"]).output)
    (result,) = answer["results"].values()
    assert {"OD", "dB"} <= {row["unit"] for row in result["also"]}


@pytest.mark.parametrize(
    "words",
    [
        "1±0.1 cd lx --distance 1e-100m",
        "1±1e140 cd lx --distance 1e-10m",
        "1±0.1 cd lx --distance 1+-1e150m",
        "1±0.1 cd lx --distance 1+-1e-200m",
        "100 cd lx --distance 5e99±6e99m",
    ],
)
def test_results_out_of_range_are_refused(words):
    number, rest = words.split(" ", 1)
    done = call(["convert", number, *rest.split()])
    assert (done.status, done.output) == (2, "")
    assert "is out of range" in str(done.error)


def count_of_luminaires(flux):
    # lumen method: N = E A / (F U M), rounded up
    return math.ceil(500 * 54 / (flux * 0.6 * 0.8) - 1e-9)


def in_the_cone(half):
    # a cone of 100 lm seen at 45 deg from 3 m high: I cos(45 deg) / 18 m2 inside, nothing outside
    inside = half >= 45 - 1e-9
    return 100 / (2 * math.pi * (1 - math.cos(math.radians(half)))) * 0.5**0.5 / 18 * inside


def turned(incidence):
    return 25 * max(0.0, math.cos(math.radians(incidence)))


def is_smooth(function, nominal, off):
    """Return whether a function has no step and no corner within the uncertainty."""
    counts = {count_of_luminaires(end) for end in (nominal - off, nominal + off)}
    return {
        count_of_luminaires: len(counts) == 1,
        in_the_cone: nominal + off < 45 or nominal - off >= 45,
        turned: abs(nominal - 90) > off,
    }[function]


JUMPS = [
    (count_of_luminaires, "room --width 6m --length 9m --illuminance 500lx --utilance 0.6 "
     "--maintenance 0.8 --flux {}+-{}lm -g luminaires-to-install", [1000, 2900, 3600, 3610],
     [10, 200, 700]),
    (in_the_cone, "point-source --flux 100lm --height 3m --offset 3m --half-angle {}+-{}deg -g "
     "illuminance:lx", [42, 44, 45, 45.6, 48], [0.5, 1, 2.5]),
    (turned, "point-source --intensity 100cd --distance 2m --incidence {}+-{}deg -g illuminance:lx",
     [86, 89.5, 90, 90.5, 95], [0.25, 1, 3]),
    (turned, "convert 100cd lx --distance 2m --incidence {}+-{}deg", [88, 89.5, 90, 92], [1, 3]),
]  # fmt: skip


@pytest.mark.parametrize(("function", "words", "places", "offs"), JUMPS)
def test_a_result_that_jumps_is_refused(function, words, places, offs):
    """By its closed form; a smooth result has the value and the uncertainty of it."""
    for nominal in places:
        for off in offs:
            done = call([*words.format(nominal, off).split(), "--json"])
            assert (done.status == 0) == is_smooth(function, nominal, off), (nominal, off)
            if done.status:
                assert "it jumps or bends within" in str(done.error)
            else:
                (answer,) = answers(done.output)
                (result,) = answer["results"].values()
                small = off * 1e-4
                rise = (function(nominal + small) - function(nominal - small)) / 2e-4
                assert result["value"] == pytest.approx(function(nominal), rel=1e-9, abs=1e-12)
                assert result.get("uncertainty", 0) == pytest.approx(abs(rise), rel=1e-3)


def test_the_other_results_of_a_call_keep_their_uncertainties():
    words = "room --area 54m2 --illuminance 500lx --utilance 0.6 --maintenance 0.8"
    (answer,) = answers(call([*words.split(), "--flux", "3600+-200lm", "--json"]).output)
    assert answer["results"]["luminaires"]["uncertainty"] == pytest.approx(15.625 / 18, rel=1e-6)
    assert "luminaires-to-install" not in answer["results"]
    note = (
        "the luminaires to install has no standard uncertainty: it jumps or bends within flux "
        "3600+-200lm"
    )
    assert note in answer["notes"]
    requested = call([*words.split(), "--flux", "3600+-200lm", "-g", "luminaires-to-install"])
    assert requested.error.message == note
    hints = [hint for hint in requested.hints if hint.startswith(("try: ", "or: "))]
    for flux, hint in zip(("3400lm", "3800lm"), hints, strict=True):
        assert f"--flux {flux}" in hint
    other = call([*words.split(), "--flux", "3600+-200lm", "-g", "luminaires", "--json"])
    assert note not in other.output


def test_an_uncertainty_is_printed_with_two_digits_at_any_precision():
    for precision in (1, 2, 5, 17):
        done = call(["convert", "99.99+-0.01 lx", "fc", "--precision", str(precision)])
        assert "9.28937 ± 0.00093\tfc" in done.output


@pytest.mark.parametrize(("words", "has_note"), [
    ("convert 100+-3lx fc -n", True), ("convert 100lx fc -n", False),
    ("ev --luminance 4096+-100cd/m2 -g ev100", True),
    ("ev --luminance 4096+-100cd/m2 -g ev100 -g ev100-uncertainty", False),
    ("ev --luminance 4096+-100cd/m2 -g ev100 --json", False),
    ("ev --luminance 4096+-100cd/m2 --time 1/60s -g time", False),
])  # fmt: skip
def test_a_bare_number_says_that_its_uncertainty_is_omitted(words, has_note):
    assert ("only the number is printed" in run(*words.split()).stderr) == has_note
