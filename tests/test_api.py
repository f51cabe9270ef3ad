import doctest
import inspect
import math
import re

import numpy as np
import pint
import pytest
from conftest import DOCS, python
from helpers import for_each

import radcalc
from radcalc.errors import ConditionError, ConversionError, NumberError, RadcalcError, UnitError
from radcalc.inputs import definitions
from radcalc.spectra import arrays, observers

Q = radcalc.Quantity


def test_text_and_quantities_go_in_and_quantities_come_out():
    # 1 fc = 1/0.3048^2 lx
    assert radcalc.convert("100 lx", "fc").magnitude == pytest.approx(9.290304, rel=1e-15)
    assert radcalc.convert(Q(100, "lx"), "fc") == Q(9.290304, "fc")
    assert radcalc.convert(0.5, "%") == Q(50, "percent")
    assert radcalc.convert("1 klm", "lm").check("[luminosity] * [angle]**2")


def test_arrays_keep_their_shape():
    values = np.arange(6.0).reshape(2, 3)
    converted = radcalc.convert(Q(values, "klx"), "lx")
    assert converted.magnitude.shape == (2, 3)
    np.testing.assert_array_equal(converted.magnitude, values * 1000)


def test_arrays_without_elements_have_results_without_elements():
    none = np.empty((2, 0))
    assert radcalc.convert(Q(none, "lx"), "umol/m2/s", spectrum="D65").m.shape == (2, 0)
    assert radcalc.convert("1 cd", "lx", distance=Q(none, "m")).m.shape == (2, 0)
    assert radcalc.convert("1 W/sr", "W", distance=Q(none, "m"), area="1 mm2").m.shape == (2, 0)
    found = radcalc.point_source(intensity="100 cd", distance=Q(none, "m"))
    assert {name: np.shape(one.m) for name, one in found.items()} == {
        "intensity": (), "flux": (), "incidence": (), "distance": (2, 0), "illuminance": (2, 0)
    }  # fmt: skip
    assert radcalc.uberlight(np.zeros((0, 3)), intensity="1 cd")["irradiance"].m.shape == (0,)


def test_masked_elements_stay_masked_or_are_refused():
    hidden = np.ma.array([1.0, 2.0, 3.0], mask=[False, True, False])
    made = radcalc.convert(Q(hidden, "lx"), "klx").magnitude
    assert made.mask.tolist() == [False, True, False]
    assert made[2] == pytest.approx(0.003)
    with pytest.raises(NumberError, match="intensity has masked elements"):
        radcalc.point_source(intensity=Q(hidden, "cd"), distance="1 m")
    shown = Q(np.ma.array([1.0, 2.0]), "cd")
    assert radcalc.point_source(intensity=shown, distance="1 m")["irradiance"].m.tolist() == [1, 2]


def test_conditions_may_be_arrays_too():
    far = radcalc.convert("100 cd", "lx", distance=Q(np.array([1.0, 2.0, 5.0]), "m"))
    np.testing.assert_allclose(far.magnitude, [100, 25, 4], rtol=1e-15)
    turned = radcalc.convert(
        "100 cd", "lx", distance="2m", incidence=Q(np.array([0.0, 60.0, 90.0, 120.0]), "deg")
    )
    np.testing.assert_allclose(turned.magnitude, [25, 12.5, 0, 0], rtol=1e-14)
    seen = radcalc.convert("1 W", "lm", wavelength=Q(np.array([555.0, 300.0]), "nm"))
    np.testing.assert_allclose(seen.magnitude, [683.002, 0])


@pytest.mark.parametrize(
    ("conditions", "expected"),
    [
        ({"isotropic": True}, 1 / (4 * np.pi)),
        ({"half_angle": "60deg"}, 1 / np.pi),
        ({"half_angle": Q(60, "deg")}, 1 / np.pi),
        ({"exponent": 1}, 1 / np.pi),
        ({"isotropic": True, "hemisphere": False, "time": None}, 1 / (4 * np.pi)),
    ],
)
def test_conditions_are_texts_quantities_numbers_or_flags(conditions, expected):
    assert radcalc.convert("1 lm", "cd", **conditions).magnitude == pytest.approx(expected)


@pytest.mark.parametrize(
    ("call", "error"),
    [
        (lambda: radcalc.convert("1 lm", "cd"), ConversionError),
        (lambda: radcalc.convert("1 zork", "cd"), UnitError),
        (lambda: radcalc.convert("x lm", "cd"), NumberError),
        (lambda: radcalc.convert("1 lm", "cd", isotropic="yes"), ConditionError),
        (lambda: radcalc.convert("1 lm", "cd", distance=2), ConditionError),
        (lambda: radcalc.convert("1 lx", "nit", reflectance=Q([0.5, 2], "1")), ConditionError),
        (lambda: radcalc.convert(5, "lx"), ConversionError),
        (lambda: radcalc.convert(Q([5.0, -1.0], "lm"), "cd", isotropic=True), ConditionError),
        (lambda: radcalc.convert(Q(-1, "lx"), "cd", distance="1m"), ConditionError),
        (lambda: radcalc.convert(Q(10**400, "lx"), "fc"), NumberError),
        (lambda: radcalc.convert(Q(10**308, "klx"), "lx"), ConversionError),
        (lambda: radcalc.convert(Q([1.0, 1e-307], "lx"), "klx"), ConversionError),
        (lambda: radcalc.convert(Q([1.0, 1e308], "klx"), "lx"), ConversionError),
        (lambda: radcalc.convert(pint.UnitRegistry().Quantity(1, "m"), "ft"), UnitError),
        (lambda: Q(1, "10**10**10 m"), UnitError),
        (lambda: Q("1_000 lx"), NumberError),
        (lambda: Q(1, "W/m^2 sr"), UnitError),
    ],
)  # fmt: skip
def test_wrong_inputs_raise_a_radcalc_error(call, error):
    with pytest.raises(error) as caught:
        call()
    assert isinstance(caught.value, RadcalcError)
    assert caught.value.hint


LAMPS = [{"x": 0, "y": 0, "z": 2, "intensity": "100 cd"}]
FLOOR = [[0, 0, 0]]


def _spot(**given):
    return radcalc.point_source(distribution="100 cd", **given)


def _light(point=(0, 0, 2), **given):
    return radcalc.uberlight(point, intensity="100 cd", **given)


def _lamp(**cells):
    return radcalc.scene([{**LAMPS[0], **cells}], FLOOR)


@for_each(
    [
        lambda: _spot(distance="1m", toward=Q([0, 30], "deg")),
        lambda: _spot(distance="1m", toward=(1, "x", 0)),
        lambda: _spot(distance="1m", toward=(Q(30, "deg"), 90)),
        lambda: _spot(distance="1m", toward=[[1, 0, 1]]),
        lambda: _spot(distance="1m", toward=object()),
        lambda: _spot(height="1m", aim=5),
        lambda: _spot(height="1m", aim=(1, "x", 0)),
        lambda: _spot(height="1m", aim=Q([0, 0, -1], "m")),
        lambda: _spot(height="1m", aim=(10**400, 0, 0)),
        lambda: _spot(height="1m", rotate=(1, 2)),
        lambda: _spot(height="1m", rotate=(1,)),
        lambda: radcalc.point_source(distribution=5),
        lambda: radcalc.point_source(flux=[1, 2], distance="2m"),
        lambda: radcalc.point_source(flux=[Q([1, 2], "lm")], distance="2m"),
        lambda: radcalc.point_source(flux={}, distance="2m"),
        lambda: radcalc.point_source(flux=Q([1 + 2j], "lm"), distance="2m"),
        lambda: radcalc.point_source(flux=Q(10**400, "lm"), distance="2m"),
        lambda: radcalc.point_source(flux="1lm", distance=Q([1, 2], "m"), exponent=[1, 2, 3]),
        lambda: _light(superellipse=5),
        lambda: _light(superellipse=("a", 1, 2, 3)),
        lambda: _light(normal=3),
        lambda: _light(normal=Q(3, "m")),
        lambda: _light(near=(1, 2)),
        lambda: _light(5),
        lambda: _light(Q([1, 2, 3], "lm")),
        lambda: _light((Q(1, "m"), Q(1, "m"), Q(1, "m"))),
        lambda: radcalc.scene(5, FLOOR),
        lambda: radcalc.scene(None, FLOOR),
        lambda: radcalc.scene([5], FLOOR),
        lambda: radcalc.scene(LAMPS, 5),
        lambda: radcalc.scene(LAMPS, [["a", 0, 0]]),
        lambda: radcalc.scene(LAMPS, Q(FLOOR, "lm")),
        lambda: radcalc.scene(LAMPS, FLOOR, normal=5),
        lambda: radcalc.scene(LAMPS, FLOOR, normal=("a", 0, 1)),
        lambda: radcalc.scene(LAMPS, FLOOR, normal=Q([0, 0, 1], "m")),
        lambda: radcalc.scene(LAMPS, FLOOR, wavelength=Q([500, 555], "nm")),
        lambda: _lamp(intensity=Q([1, 2], "cd")),
        lambda: _lamp(intensity=np.array([1, 2])),
        lambda: _lamp(intensity=Q(1j, "cd")),
        lambda: _lamp(intensity=object()),
        lambda: _lamp(name=[1]),
        lambda: radcalc.convert(Q([1, 2, 3], "lm"), "cd", half_angle=Q([30, 60], "deg")),
        lambda: radcalc.convert({}, "lx"),
        lambda: radcalc.convert(Q(np.array(["a"]), "lx"), "fc"),
        lambda: radcalc.explain(Q([1, 2], "lm"), "cd", isotropic=True),
        lambda: radcalc.lambertian([1]),
        lambda: radcalc.ev(ev100={}),
        lambda: radcalc.photon(None),
        lambda: radcalc.photon({}),
        lambda: radcalc.spectrum(5),
        lambda: radcalc.spectrum("nope"),
        lambda: radcalc.direction(5),
        lambda: radcalc.direction((1, 2)),
        lambda: radcalc.direction("a,b,c"),
        lambda: radcalc.solid_angle(5),
        lambda: radcalc.solid_angle("polygon", 5),
        lambda: radcalc.solid_angle("polygon", [(1, 2)]),
        lambda: radcalc.solid_angle("cone", [(1, 2, 3)], half_angle="3 deg"),
    ],
)
def test_python_objects_that_are_not_inputs_are_refused(call):
    with pytest.raises(RadcalcError) as caught:
        call()
    assert caught.value.hint


def test_vectors_and_points_are_texts_or_sequences():
    for toward in ((1, 0, 1), [1, 0, 1], np.array([1, 0, 1]), "1,0,1", Q(45, "deg"),
                   (Q(45, "deg"), Q(0, "deg"))):  # fmt: skip
        found = _spot(distance="2m", toward=toward)
        assert found["intensity_toward"].magnitude == pytest.approx(100)
    for point in ("0,0,0", [0, 0, 0], FLOOR, Q(FLOOR, "m")):
        found = radcalc.scene(LAMPS, point, normal="0,0,1")
        assert found["irradiance"].magnitude.tolist() == [25.0]  # 100 cd / (2 m)^2


@pytest.mark.parametrize(
    ("one", "other"), [("lm", "cd"), ("lx", "nit"), ("W/Hz", "J"), ("td", "cd")]
)
def test_pint_itself_refuses_to_drop_an_angle_a_cycle_or_the_eye(one, other):
    with pytest.raises(pint.DimensionalityError):
        Q(1, one).to(other)


def test_assumptions_are_available_in_python():
    result = radcalc.explain("1 W", "lm", wavelength="300nm")
    assert result.rows[0].value == 0
    assert "CIE 1924" in result.steps[0].reference
    assert "is invisible" in result.notes[0]
    assert result.steps[-1].law == "conversion"
    assert "1055.05585262 J" in radcalc.explain("1 Btu", "J").notes[0]


def test_a_fractional_power_is_refused():
    with pytest.raises(UnitError, match="not a whole number"):
        radcalc.convert(Q(4.0, "lx") ** 0.5, "1")


def test_pint_arithmetic_works_in_radcalcs_units():
    assert (Q(1, "klm") + Q(1, "lm")).to("lm").magnitude == pytest.approx(1001)
    assert (Q(12, "lm") / Q(4, "sr")).to("cd").magnitude == pytest.approx(3)
    assert Q("5 W m-2").to("mW/cm2").magnitude == pytest.approx(0.5)


@pytest.mark.parametrize(
    "first", ["radcalc.cli", "radcalc.conversion.plan", "radcalc.api", "radcalc"]
)
def test_the_public_names_do_not_depend_on_the_order_of_imports(first):
    done = python(f"import {first}, radcalc; print(radcalc.convert('1 klx', 'lx'))")
    assert done.stdout == "1000.0 lux\n", done.stderr


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError):
        radcalc.nothing  # noqa: B018


PUBLIC = {name: getattr(radcalc, name) for name in radcalc.__all__}
DOCUMENTED = [
    *(one for one in PUBLIC.values() if inspect.isfunction(one)),
    *(radcalc, radcalc.Result, radcalc.Verdict, observers, arrays),
]


@for_each(DOCUMENTED)
def test_the_examples_in_the_docstrings_run(documented):
    names = PUBLIC | vars(documented) | {"radcalc": radcalc}
    finder = doctest.DocTestFinder()
    examples = finder.find(documented, documented.__name__, module=False, globs=names)
    assert any(one.examples for one in examples)
    before = [dict(table) for table in definitions.TABLES]
    for one in examples:
        assert not doctest.DocTestRunner().run(one).failed
    for table, kept in zip(definitions.TABLES, before, strict=True):  # of the user's definitions
        table.clear()
        table.update(kept)


@pytest.mark.parametrize(
    "page", [path for path in DOCS if ">>> " in path.read_text("utf-8")], ids=lambda page: page.name
)
def test_the_python_examples_of_the_documentation_run(page):
    """Use a new interpreter: colour-science, loaded by other tests, changes how NumPy prints."""
    code = "import doctest, sys; print(doctest.testfile(sys.argv[1], module_relative=False))"
    done = python(code, str(page))
    found = re.search(r"failed=(\d+), attempted=(\d+)", done.stdout)
    assert found, done.stderr
    assert int(found[2]) > 0
    assert int(found[1]) == 0, done.stdout


def test_a_reading_on_a_scale_becomes_a_quantity_and_a_bare_number_again():
    """By definition 0 dBm is 1 mW; K = 12.5 cd s/m2 and C = 250 lx s of ISO 2720."""
    assert radcalc.convert("-30 dBm", "uW") == Q(1.0, "uW")
    assert radcalc.convert("15 EV", "lx") == Q(81920.0, "lx")
    assert radcalc.convert("15 EV", "cd/m2", k="14 cd s/m2").m == pytest.approx(0.14 * 2**15)
    readings = radcalc.convert(Q(np.array([1.0, 10.0, 100.0]), "mW"), "dBm")
    assert type(readings) is np.ndarray
    assert readings.tolist() == [0.0, 10.0, 20.0]
    assert type(radcalc.convert("1 %", "OD")) is float
    assert radcalc.Quantity("10 dBm") == Q(10.0, "mW")
    shown = radcalc.point_source(flux="10 dBm", distance="2 m")
    assert shown["flux"] == Q(10.0, "mW")
    assert shown["intensity"].m == pytest.approx(0.01 / (4 * math.pi))


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (lambda: Q("15 EV"), "is ambiguous: cd/m2 or lx"),
        (lambda: Q(10.0, "dBm"), "is a scale"),
        (lambda: radcalc.convert(Q(np.array([0.0, 1.0]), "W"), "dBm"), "no reading on dBm"),
        (lambda: radcalc.convert("5 lx", "EV", k="14 cd s/m2"), "k does not apply"),
        (
            lambda: radcalc.lambertian(incident_irradiance="1 lx", reflectance="3 dB"),
            "out of range",
        ),
    ],
)
def test_a_meaningless_or_ambiguous_reading_is_refused(ask, said):
    with pytest.raises(RadcalcError, match=said):
        ask()


def test_the_uncertainty_of_a_reading_follows_the_slope_of_its_scale():
    """0.1 dB at 10 mW is 10 ln(10)/10 times 0.1 mW; 0.1 mW at 10 mW is 10/ln(10) times 0.01 dB."""
    power = radcalc.convert("10±0.1 dBm", "mW").m
    assert (power.nominal_value, power.std_dev) == pytest.approx((10.0, math.log(10) / 10))
    level = radcalc.convert("10±0.1 mW", "dBm")
    assert (level.nominal_value, level.std_dev) == pytest.approx((10.0, 0.1 / math.log(10)))


@pytest.mark.parametrize(
    ("source", "target", "conditions", "expected"),
    [
        ("lx", "fc", {}, 0.3048**2),  # lm/m2 and lm/ft2
        ("mol/m2/day", "umol/m2/s", {}, 1e6 / 86400),
        ("cd", "lx", {"distance": "2m", "incidence": Q(60, "deg")}, 0.5 / 4),
        ("lm", "cd", {"isotropic": True, "distance": None}, 1 / (4 * math.pi)),
        ("lx", "ppfd", {"efficacy": "54 lm s/umol"}, 1 / 54),
        ("W", "lm", {"wavelength": Q(555, "nm")}, 683.002),  # CIE 018:2019
        ("W", "lm", {"wavelength": "300 nm"}, 0.0),
        ("lx s", "lx", {"time": "1/50 s"}, 50.0),
    ],
)
def test_a_factor_is_a_single_multiplier(source, target, conditions, expected):
    factor = radcalc.factor(source, target, **conditions)
    assert type(factor) is float
    assert factor == pytest.approx(expected, rel=1e-15, abs=0)
    column = np.array([0.0, 0.3, 1e5])
    converted = radcalc.convert(Q(column, source), target, **conditions)
    np.testing.assert_allclose(column * factor, converted.magnitude, rtol=1e-15)


@pytest.mark.parametrize(
    ("source", "target", "conditions", "said", "hint"),
    [
        ("mW", "dBm", {}, "mW and dBm are linked by a function", 'convert("1 mW", "dBm")'),
        ("EV", "lx", {}, "EV and lx are linked by a function", 'convert("1 EV", "lx")'),
        ("K", "1/MK", {}, "K and 1/MK are linked by a function", 'convert("1 K", "1/MK")'),
        ("nm", "eV", {}, "nm and eV are linked by a function", 'convert("1 nm", "eV")'),
        ("degC", "K", {}, "'degC' is not accepted as a unit", "K: a step of"),
        ("lm", "cd", {}, "a solid angle is missing", "isotropic=True"),
        (
            "lx",
            "fc",
            {"distance": "2 m"},
            "distance does not apply",
            'radcalc.factor("lx", "fc")\n     0.092903',
        ),
        ("cd", "lx", {"distance": Q([1, 2], "m")}, "distance is an array", "one value of each"),
        ("lm", "cd", {"exponent": [1, 2]}, "exponent is an array", "one value of each"),
        ("cd", "lx", {"distance": "2±0.1 m"}, "an uncertainty, which a factor", "alone"),
        ("cd", "lx", {"distance": ["1m", "2m"]}, "distance is an array", "one value of each"),
        ("2 lx", "fc", {}, "has a number in it", "one number"),
        (2, "fc", {}, "source is a text, not an int", "'lx'"),
        ("lx", None, {}, "target is a text, not a NoneType", "'lx'"),
    ],
)
def test_units_that_no_factor_links_are_refused(source, target, conditions, said, hint):
    with pytest.raises(RadcalcError) as caught:
        radcalc.factor(source, target, **conditions)
    assert said in caught.value.message
    assert hint in caught.value.hint
