"""What is not a number is refused wherever a function takes an amount, and a number is itself."""

import array
import datetime
import decimal
import fractions
import inspect

import numpy as np
import pandas
import pytest

import radcalc
from radcalc.quantities.symbols import QUANTITY, SYMBOLS

Q = radcalc.Quantity
OTHERS = {  # values that no argument takes
    "a truth value": True,
    "a truth value of NumPy": np.bool_(True),
    "a complex number": 1 + 2j,
    "a complex number without its imaginary part": np.complex128(5),
    "an infinite number": float("inf"),
    "an infinite element": np.array([1.0, -np.inf]),
    "no number": float("nan"),
    "a missing value of pandas": pandas.NA,
    "a date": datetime.datetime(2026, 1, 2),
    "a date of NumPy": np.array(["2026-01-02"], "M8[D]"),
    "a duration": datetime.timedelta(1),
    "truth values": np.array([True, False]),
    "a truth value beside a number": [1, True],
    "complex numbers": np.array([1j]),
    "None in a list": [1.0, None],
    "None in an array": np.array([1.0, None]),
    "texts in an array": np.array(["x", "y"]),
    "a record": np.zeros(2, [("a", float)]),
    "lists of other lengths": [[1.0], [1.0, 2.0]],
    "masked elements": np.ma.array([1.0, 2.0], mask=[False, True]),
    "bytes": b"5",
    "a set": {1.0},
    "an object": object(),
    "a function": len,
    "not much": ...,
    "a column of complex numbers": pandas.Series([1 + 2j], name="E [lx]"),
}
TAKEN = {  # by function, parameter (of any function: ""), and the values that it takes
    ("convert", "value"): {"masked elements"},  # which stay masked
    ("dose", "missing"): {"an infinite number", "no number"},  # marks of missing values
    ("direction", "on_ball"): {"a truth value", "a truth value of NumPy"},
    ("point_source", "any_incidence"): {"a truth value", "a truth value of NumPy"},
    ("point_source", "isotropic"): {"a truth value", "a truth value of NumPy"},
    ("point_source", "hemisphere"): {"a truth value", "a truth value of NumPy"},
    ("scene", "shares"): {"a truth value", "a truth value of NumPy"},
    ("uberlight", "omni"): {"a truth value", "a truth value of NumPy"},
}
TIMES = ["2026-01-01 00:00", "2026-01-01 01:00"]
CALLS = {  # calls that are answered
    "ask": {"sentence": "100 lx fc"},
    "calorimeter": {"mass": "1 kg", "specific_heat": "4 kJ/(kg K)", "temperature_rise": "1 K",
                    "time": "1 s"},
    "check": {"result": radcalc.photon("555 nm"), "claim": "wavelength=555 nm"},
    "convert": {"value": 100, "target": "lx", "to": "fc"},
    "direction": {"vector": (1, 1, 1)},
    "dose": {"readings": [1, 2], "times": TIMES, "unit": "lx"},
    "environment": {"source": "sky:overcast", "zenith_luminance": "9000 cd/m2"},
    "etendue": {"area": "1 cm2", "half_angle": "10 deg"},
    "ev": {"f_number": 2.8, "time": "1/60 s", "iso": 100},
    "examples": {"search": "museum"},
    "explain": {"value": "100 lx", "target": "fc"},
    "factor": {"source": "lx", "target": "fc"},
    "integrate": {"expression": "cos(theta)", "half_angle": "90 deg"},
    "irradiance_map": {"source": np.ones((8, 16)), "size": (8, 4), "unit": "cd/m2"},
    "lambertian": {"shape": "disc", "luminance": "1 cd/m2", "radius": "1 m", "height": "1 m"},
    "laser": {"flux": "1 mW", "diameter": "1 mm", "divergence": "1 mrad", "distance": "1 m"},
    "mesopic": {"luminance": "1 cd/m2", "scotopic_luminance": "1.5 cd/m2"},
    "photon": {"wavelength": "555 nm"},
    "point_source": {"flux": "800 lm", "distance": "2 m"},
    "refraction": {"index": 1.5, "incidence": "30 deg"},
    "room": {"length": "5 m", "width": "4 m", "height": "2 m"},
    "scene": {"sources": [{"x": 0, "y": 0, "z": 2, "intensity": "1 cd"}], "points": [[0, 0, 0]]},
    "screen": {"flux": "2000 lm", "diagonal": "100 in", "aspect": "16:9"},
    "sensor": {"luminance": "100 cd/m2", "f_number": 2.8},
    "sky": {"kind": "overcast", "zenith_luminance": "9000 cd/m2"},
    "solid_angle": {"shape": "cone", "half_angle": "30 deg"},
    "spectrum": {"source": "D65"},
    "typical": {"search": "office"},
    "uberlight": {"point": (0, 0, 1), "intensity": "100 cd"},
}  # fmt: skip


def functions():
    """Return the public functions by their names."""
    public = {name: getattr(radcalc, name) for name in radcalc.__all__}
    return {name: f for name, f in public.items() if callable(f) and not isinstance(f, type)}


def test_every_public_function_has_a_call_that_is_answered():
    assert functions().keys() - {"define"} == CALLS.keys()  # it takes a path alone
    for name, given in CALLS.items():
        functions()[name](**given)


@pytest.mark.parametrize("name", CALLS)
def test_what_is_not_a_number_is_refused_by_every_argument(name):
    function = getattr(radcalc, name)
    for key, parameter in inspect.signature(function).parameters.items():
        if parameter.kind == parameter.VAR_POSITIONAL:
            continue
        symbol = SYMBOLS.get(key.replace("_", "-"))
        for what, value in OTHERS.items():
            values = [value]
            if symbol and symbol.form == QUANTITY and isinstance(value, np.ndarray):
                values.append(Q(value, symbol.unit))
            for one in values:
                if what not in TAKEN.get((name, key), ()):
                    with pytest.raises(radcalc.RadcalcError):
                        print(f"{name}, {key}, {what}:", function(**CALLS[name] | {key: one}))


@pytest.mark.parametrize(
    "name", [n for n, f in functions().items() if "amounts" in inspect.signature(f).parameters]
)
def test_what_is_not_a_number_is_refused_without_a_keyword(name):
    function = getattr(radcalc, name)
    operands = [value for key, value in CALLS[name].items() if key in ("shape", "point")]
    given = {key: value for key, value in CALLS[name].items() if key not in ("shape", "point")}
    for what, value in OTHERS.items():
        for one in (value, *([Q(value, "W")] if isinstance(value, np.ndarray) else [])):
            with pytest.raises(radcalc.RadcalcError):
                print(f"{name}, {what}:", function(*operands, one, **given))


# 1 ft2 is 0.09290304 m2, exactly
@pytest.mark.parametrize(
    "two",
    [
        *(kind(2) for kind in (np.float16, np.float32, np.longdouble, np.int8, np.uint64)),
        *(np.array([2], kind) for kind in (np.float16, np.float32, np.longdouble, np.int8, object)),
        *(decimal.Decimal(2), fractions.Fraction(2), np.array(2), [2], (2,), range(2, 3)),
        *([decimal.Decimal(2)], [fractions.Fraction(2)], array.array("f", [2])),
        *(
            np.ma.array([2.0]),
            pandas.Series([2], name="E [lx]"),
            pandas.Series([2.0], dtype=object),
        ),
    ],
    ids=repr,
)
def test_a_number_of_any_type_is_converted_with_all_digits(two):
    named = isinstance(two, pandas.Series) and two.name
    found = radcalc.convert(two, "fc") if named else radcalc.convert(two, "lx", "fc")
    values = np.asarray(getattr(found, "magnitude", found))
    assert values.dtype == float
    assert values.ravel() == pytest.approx([2 * 0.09290304], rel=1e-15)


def test_small_types_do_not_limit_a_result():
    for kind in (np.float16, np.float32, np.int16):
        lux = Q(np.array([3e4], kind), "lx")
        exact = float(lux.magnitude[0])
        assert radcalc.convert(lux, "nlx").magnitude.tolist() == [exact * 1e9]
        assert radcalc.convert(lux, "Glx").magnitude.tolist() == [exact / 1e9]
        assert radcalc.convert(Q(np.array([2], kind), "W"), "dBm")[0] == pytest.approx(
            33.010299956639813,
            rel=1e-15,  # 10 lg 2000
        )


def test_a_result_beyond_a_double_names_its_range():
    with pytest.raises(radcalc.RadcalcError, match="out of range") as refused:
        radcalc.convert(Q(np.array([1e308]), "lx"), "mlx")
    assert "1.7e308" in refused.value.hint
