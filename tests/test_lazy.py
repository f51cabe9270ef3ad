"""Dask arrays work in the calculators as NumPy arrays do, and stay lazy until computed."""

import pickle
from collections.abc import Mapping
from inspect import isfunction

import dask
import dask.array
import numpy as np
import pytest
from conftest import ROOT
from helpers import PLAIN, example_of, for_each

import radcalc
from radcalc.api.arguments import keyword
from radcalc.api.columns import Call, Expected, Place, Rows
from radcalc.errors import ConditionError, RadcalcError
from radcalc.inputs.reading import read

Q = radcalc.Quantity
A = np.linspace(0.5, 4.0, 12).reshape(3, 4)  # chunks that do not match
B = np.linspace(1.0, 1.5, 4)
DOWNLIGHT = str(ROOT / "examples" / "downlight.ies")


class Waiting:
    """Array that counts its reads."""

    def __init__(self, values: np.ndarray) -> None:
        self.values, self.shape, self.dtype = values, values.shape, values.dtype
        self.ndim, self.reads = values.ndim, 0

    def __getitem__(self, where):
        self.reads += 1
        return self.values[where]


CALLS = {
    "a value": (radcalc.convert, (A, "lx"), ("umol/m2/s",), {"spectrum": "LED-B3"}, {}),
    "a value on a scale": (radcalc.convert, (A, "mW"), ("dBm",), {}, {}),
    "a condition": (radcalc.convert, "5 cd", ("lx",), {}, {"distance": (A, "m")}),
    "a value and a condition": (
        radcalc.convert, (A, "cd"), ("lx",), {}, {"distance": (B, "m")}),
    "a patch": (
        radcalc.convert, "1 W/sr", ("W",), {"area": "20 mm2"}, {"distance": (A, "m")}),
    "a distance": (
        radcalc.point_source, None, (), {"intensity": "100 cd"}, {"distance": (A, "m")}),
    "an intensity and a distance": (
        radcalc.point_source, None, (), {}, {"intensity": (A, "cd"), "distance": (B, "m")}),
    "a lobe": (
        radcalc.point_source, None, (), {"flux": "800 lm", "offset": "1 m"},
        {"height": (A, "m"), "exponent": (B, "")}),
    "a distance from an irradiance": (
        radcalc.point_source, None, (), {"flux": "800 lm"}, {"irradiance": (A, "lx")}),
    "a file": (
        radcalc.point_source, None, (), {"distribution": DOWNLIGHT, "spectrum": "D65"},
        {"height": (A, "m"), "offset": (B, "m")}),
    "an expression and an aim": (
        radcalc.point_source, None, (),
        {"distribution": "3*max(cos(theta), 0) cd", "aim": (1, 0, -1)}, {"height": (A, "m")}),
    "an expression": (
        radcalc.point_source, None, (), {"distribution": "3*max(cos(theta), 0) cd"},
        {"height": (A, "m"), "offset": (B, "m")}),
    "a diffuse patch": (
        radcalc.lambertian, None, (), {"luminance": "9 cd/m2", "area": "1 cm2"},
        {"distance": (A, "m"), "tilt": (B, "deg")}),
    "a disc off the axis": (
        radcalc.lambertian, None, ("disc",), {"luminance": "9 cd/m2", "radius": "1 m"},
        {"height": (A, "m"), "offset": (B, "m")}),
    "a rectangle": (
        radcalc.lambertian, None, ("rectangle",), {"luminance": "9 cd/m2", "width": "1 m"},
        {"length": (A, "m"), "height": (B, "m")}),
    "a sky": (
        radcalc.sky, None, ("clear",), {"horizontal_illuminance": "9 klx", "sun_azimuth": "5 deg"},
        {"sun_elevation": (30 * B, "deg"), "tilt": (A, "deg"), "azimuth": (A, "deg")}),
    "a meter": (radcalc.ev, None, (), {"time": "1/50 s"}, {"f_number": (A, "")}),
    "heat": (
        radcalc.calorimeter, None, (), {"specific_heat": "385 J/kg/K", "time": "30 s"},
        {"mass": (A, "kg"), "temperature_rise": (B, "K")}),
    "a laser": (
        radcalc.laser, None, (), {"diameter": "1 mm", "divergence": "1 mrad", "limit": "25 W/m2"},
        {"flux": (A, "mW")}),
    "a room": (
        radcalc.room, None, (), {"flux": "3000 lm", "length": "6 m", "height": "2 m",
        "utilance": 0.6}, {"illuminance": (100 * A, "lx"), "width": (B, "m")}),
    "a sensor": (
        radcalc.sensor, None, (), {"time": "10 ms", "pixel_pitch": "3.45 um", "spectrum": "D65"},
        {"luminance": (1000 * A, "cd/m2"), "f_number": (B, "")}),
    "a screen": (
        radcalc.screen, None, (), {"width": "2 m", "height": "1 m"}, {"flux": (1000 * A, "lm")}),
    "a photon": (radcalc.photon, None, (), {}, {"wavelength": (200 * A, "nm")}),
    "a way": (
        radcalc.direction, None, (), {}, {"polar": (10 * A, "deg"), "azimuth": (B, "deg")}),
    "a mirror": (
        radcalc.direction, None, (), {"azimuth": "9 deg", "reflect_at": (0, 0, 1)},
        {"elevation": (10 * A, "deg")}),
    "a cone": (radcalc.solid_angle, None, ("cone",), {}, {"half_angle": (A, "deg")}),
    "a disc": (
        radcalc.solid_angle, None, ("disc",), {"height": "1 m"},
        {"radius": (A, "m"), "offset": (B, "m")}),
    "dusk": (radcalc.mesopic, None, (), {"sp_ratio": 2}, {"luminance": (A, "cd/m2")}),
    "a beam": (
        radcalc.etendue, None, (), {"half_angle": "30 deg"}, {"area": (A, "mm^2")}),
    "a light of films": (
        radcalc.uberlight, None, ((0.0, 0.0, 1.0),), {"falloff": 1},
        {"intensity": (A, "cd"), "falloff_distance": (B, "m")}),
}  # fmt: skip


def of_example(name):
    """Return the first example of a calculator's page, with an array for its first quantity."""
    first, *others = (word.split("=", 1) for word in example_of(name))
    given = read(*first)
    unit = given.unit.text.replace("^", "**") if given.unit else ""
    arrays = {keyword(first[0]): (given.number * (1 + A / 1000), unit)}
    inputs = {keyword(name): True if text == "" else text for name, text in others}
    return getattr(radcalc, keyword(name)), None, (), inputs, arrays


CALLS |= {f"the example of {name}": of_example(name) for name in PLAIN}


def lazy(values):
    """Return a Dask array in chunks, and the array that counts its reads."""
    counted = Waiting(values)
    chunks = (2,) * (values.ndim - 1) + (3,)
    return dask.array.from_array(counted, chunks=chunks, asarray=False, meta=np.empty(0)), counted


def of(values, unit):
    return Q(values, unit) if unit else values


def asked(function, value, words, given, arrays, make):
    if isinstance(value, tuple):
        value = of(make(value[0]), value[1])
    first = () if value is None else (value,)
    told = {name: of(make(values), unit) for name, (values, unit) in arrays.items()}
    found = function(*first, *words, **given, **told)
    return found if isinstance(found, Mapping) else {"value": found}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_the_answers_are_lazy_and_equal_those_of_arrays_in_memory(call):
    sources = []

    def make(values):
        array, counted = lazy(values)
        sources.append(counted)
        return array

    found, expected = asked(*call, make), asked(*call, lambda values: values)
    assert [one.reads for one in sources] == [0] * len(sources)
    assert list(found) == list(expected)
    some = 0
    every = {name: getattr(one, "magnitude", one) for name, one in found.items()}
    computed = dask.compute(every, scheduler="synchronous")[0]
    for name, value in expected.items():
        told, known = every[name], getattr(value, "magnitude", value)
        assert getattr(found[name], "units", "") == getattr(value, "units", "")
        some += isinstance(told, dask.array.Array)
        assert isinstance(told, dask.array.Array) == isinstance(known, np.ndarray), name
        assert np.shape(told) == np.shape(known)
        np.testing.assert_allclose(computed[name], known, rtol=1e-14)
    assert some
    assert any(one.reads for one in sources)


def test_every_function_takes_lazy_arrays_or_refuses_them():
    """Functions that refuse them are listed below; `environment` reads maps strip by strip."""
    taken = {call[0].__name__ for call in CALLS.values()}
    refuse = {"explain", "factor", "scene", "environment", "spectrum", "check"}
    refuse |= {"irradiance_map", "ask", "define", "dose", "integrate", "examples", "typical"}
    assert taken | refuse == {one for one in radcalc.__all__ if isfunction(getattr(radcalc, one))}


def test_the_points_of_a_light_may_be_lazy():
    points = np.stack([A - 2, 0 * A, A], -1)
    array = dask.array.from_array(points, chunks=(2, 3, 2))
    falloff = dask.array.from_array(B, chunks=2)
    found = radcalc.uberlight(Q(array, "m"), intensity="9 cd", falloff=falloff)
    expected = radcalc.uberlight(Q(points, "m"), intensity="9 cd", falloff=B)
    for name in ("x", "irradiance", "attenuation"):
        assert isinstance(found[name].m, dask.array.Array)
        np.testing.assert_allclose(found[name].m.compute(), expected[name].m, rtol=1e-14)
    alone = radcalc.uberlight(array[0, 0], intensity="9 cd")["irradiance"].m
    assert alone.compute() == radcalc.uberlight(points[0, 0], intensity="9 cd")["irradiance"].m


def test_a_result_has_the_shape_of_the_arrays_it_depends_on():
    """As NumPy broadcasts: a column of distances and a row of intensities."""
    column, row = A[:, :1], B
    lazily = [dask.array.from_array(array, chunks=2) for array in (column, row)]
    found = radcalc.point_source(distance=Q(lazily[0], "m"), intensity=Q(lazily[1], "cd"))
    expected = radcalc.point_source(distance=Q(column, "m"), intensity=Q(row, "cd"))
    for name, value in expected.items():
        assert np.shape(found[name].m) == np.shape(value.m), name
    np.testing.assert_allclose(found["irradiance"].m.compute(), expected["irradiance"].m)
    np.testing.assert_allclose(found["flux"].m.compute(), expected["flux"].m)


def test_arrays_in_memory_and_lists_with_a_lazy_one_get_its_chunks():
    """Otherwise a list as long as a chunk would be used again for each chunk."""
    distance = Q(dask.array.from_array(np.arange(1.0, 7.0), chunks=3), "m")
    exponents = [1, 2, 3, 4, 5, 6]
    found = radcalc.point_source(intensity="1 cd", distance=distance, exponent=exponents)
    assert found["exponent"].m.compute().tolist() == exponents
    with pytest.raises(ConditionError, match="do not fit together"):
        radcalc.point_source(intensity="1 cd", distance=distance, exponent=[1, 2, 3])


def test_a_single_lazy_number_and_unknown_lengths():
    one = dask.array.from_array(np.array(2.0))
    assert radcalc.convert("1 cd", "lx", distance=Q(one, "m")).m.compute() == 0.25
    logged = dask.array.from_array(np.array([1.0, -1.0, 2.0, -3.0]), chunks=2)
    kept = logged[logged > 0]  # the lengths of the chunks depend on the values; one may be empty
    assert radcalc.convert(Q(kept, "klx"), "lx").m.compute().tolist() == [1000.0, 2000.0]
    found = radcalc.point_source(flux="1 lm", distance=Q(logged[logged < -1], "m") * -1)
    assert found["distance"].m.compute().tolist() == [3.0]


@pytest.mark.parametrize("bad", [-1.0, np.nan, np.inf])
def test_a_value_out_of_range_raises_when_it_is_computed(bad):
    values = np.ones(8)
    values[5] = bad
    array = dask.array.from_array(values, chunks=2)
    found = radcalc.point_source(intensity="1 cd", distance=Q(array, "m"))["irradiance"].m
    assert found[:4].compute().tolist() == [1.0] * 4
    with pytest.raises(RadcalcError, match=r'distance=".*m.* is out of range|is beyond'):
        found.compute(scheduler="synchronous")
    if bad < 0:
        lit = radcalc.convert(Q(array, "cd"), "lx", distance="1 m").m
        with pytest.raises(ConditionError, match="negative luminous intensity is a difference"):
            lit.compute()


def test_a_receiver_that_is_too_near_raises_when_it_is_computed():
    array = dask.array.from_array(np.array([1.0, 0.01]), chunks=1)
    found = radcalc.lambertian(luminance="1 cd/m2", area="1 cm2", distance=Q(array, "m"))
    assert found["irradiance"].m[0].compute() > 0
    with pytest.raises(RadcalcError, match="distance"):
        found["irradiance"].m.compute()


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda x: radcalc.convert(Q(x, "lm"), "cd"), "a solid angle is missing"),
        (lambda x: radcalc.convert(Q(x, "lm"), "m"), "no condition links"),
        (lambda x: radcalc.point_source(distance=Q(x, "lm")), "takes a length"),
        (lambda x: radcalc.point_source(flux="1 lm", distance=x), "numbers without a unit"),
        (lambda x: radcalc.point_source(intensity="1 cd", toward=x), "toward is a Dask array"),
        (lambda x: radcalc.point_source(intensity="1+-0.1 cd", distance=Q(x, "m")), "uncertain"),
        (lambda x: radcalc.uberlight(x, intensity="1 cd"), "three coordinates"),
        (lambda x: radcalc.explain(Q(x, "lx"), "fc"), "single values"),
        (lambda x: radcalc.factor("cd", "lx", distance=Q(x, "m")), "distance is a Dask collection"),
        (
            lambda x: radcalc.scene([{"z": 2, "intensity": "1 cd"}], x),
            "points is a Dask collection",
        ),
        (
            lambda x: radcalc.environment("sky:clear", sun_elevation=Q(x, "deg")),
            "sun_elevation is a Dask collection",
        ),
    ],
)
def test_errors_that_do_not_depend_on_the_elements_are_raised_at_once(call, said):
    array, counted = lazy(A)
    with pytest.raises(RadcalcError, match=said) as caught:
        call(array)
    assert caught.value.hint
    assert counted.reads == 0


@for_each(CALLS)
def test_lazy_answers_can_be_sent_to_another_process(name):
    answer = asked(*CALLS[name], dask.array.asarray).values()
    magnitudes = [getattr(value, "magnitude", value) for value in answer]
    waiting = [value for value in magnitudes if isinstance(value, dask.array.Array)]
    assert pickle.loads(pickle.dumps(waiting))[0].shape == waiting[0].shape


def to_lux(given):
    return radcalc.convert(target="lx", **given)


def test_a_call_can_be_sent_to_another_process():
    call = Call(to_lux, {"value": None, "distance": (2.0, "m")}, (Place("value", "cd", 1),))
    rows = pickle.loads(pickle.dumps(Rows(call, {"": Expected("lx", (0,), np.empty(0))})))
    assert rows(np.array([4.0])).tolist() == [[1.0]]


def test_results_that_only_some_elements_have_are_refused():
    call = Call(to_lux, {"value": None, "distance": (2.0, "m")}, (Place("value", "cd", 1),))
    for known in (Expected("fc", (0,), np.empty(0)), Expected("lx", (), 5.0)):
        with pytest.raises(ConditionError, match="not all elements have the same results"):
            Rows(call, {"": known})(np.array([4.0]))
