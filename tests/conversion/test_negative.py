"""Negative values are differences of light, not light."""

import pytest
from conftest import run
from hypothesis import given, settings
from hypothesis import strategies as st

import radcalc
from radcalc.conversion.plan import plan, result_of_plan
from radcalc.errors import ConditionError
from radcalc.inputs.reading import read
from radcalc.units.table import resolve

# Units of each geometry and kind, with a spectral density; conversions and their conditions.
LIGHT = ("lm", "W", "umol/s", "lx.s", "cd", "W/m2", "nit", "td", "W/m2/nm", "photon/s/m2/sr")
OTHERS = ("deg", "m", "K", "lm/W", "sr", "1")
LEADING = [
    ("lm", "cd", {"isotropic": True}), ("lm", "W", {"efficacy": "93lm/W"}),
    ("W", "lm", {"wavelength": "555nm"}), ("lx", "lx.s", {"time": "1h"}),
    ("cd", "lx", {"distance": "2m"}), ("lx", "nit", {"reflectance": "0.5"}),
    ("nit", "lx", {"half-angle": "30deg"}), ("nit", "td", {"pupil": "3mm"}),
    ("W/m2/nm", "W/m2", {"bandwidth": "10nm"}), ("W/Hz", "W/cm-1", {}),
    ("lx", "radlux", {"reflectance": "0.5"}), ("nit", "lx", {"radius": "1m", "distance": "9m"}),
]  # fmt: skip


@pytest.mark.parametrize("unit", LIGHT)
def test_a_difference_of_light_keeps_its_quantity_and_is_noted(unit):
    result = result_of_plan(plan(resolve(unit), resolve(unit)), -2.0)
    assert result.rows[0].value == -2
    assert "is a difference" in result.notes[-1]


@pytest.mark.parametrize("unit", OTHERS)
def test_quantities_other_than_light_may_be_below_0(unit):
    assert not result_of_plan(plan(resolve(unit), resolve(unit)), -2.0).notes


@pytest.mark.parametrize(("source", "target", "conditions"), LEADING)
# Smaller values are refused as out of range in another unit.
@given(value=st.just(0.0) | st.floats(-1e30, -1e-200) | st.floats(1e-200, 1e30))
@settings(max_examples=10)
def test_a_negative_light_does_not_convert_to_another_quantity(source, target, conditions, value):
    made = plan(resolve(source), resolve(target), [read(n, v) for n, v in conditions.items()])
    if value >= 0:
        assert made.apply(value) >= 0
    else:
        with pytest.raises(ConditionError):
            made.apply(value)


def test_a_stream_takes_a_negative_light_for_an_invalid_line():
    lines = "".join(f"{n}\n" for n in (*range(1, 300), -5, "-1e-3", "1e-3", 7))
    words = ("convert", "-", "lm", "cd", "--solid-angle", "1sr", "-q")
    stopped = run(*words, input=lines)
    assert stopped.returncode == 2
    assert "stdin, line 300: a negative luminous flux" in stopped.stderr
    assert stopped.stdout.endswith("\n299\n")
    for mode, status in (("fail", 2), ("warn", 0), ("ignore", 0)):
        done = run(*words, "--invalid", mode, input=lines)
        assert done.returncode == status
        assert done.stdout == lines.replace("1e-3\n7", "0.001\n7")
        assert done.stderr.count("negative") == (0 if mode == "ignore" else 2)


def test_a_stream_of_differences_passes():
    done = run("convert", "-", "lx", "klx", input="-5\n7\n")
    assert (done.returncode, done.stdout) == (0, "-0.005\n0.007\n")


def test_python_refuses_any_element_below_0():
    Q = radcalc.Quantity
    assert radcalc.convert(Q([-1.0, 2.0], "klx"), "lx").magnitude.tolist() == [-1000, 2000]
    with pytest.raises(ConditionError):
        radcalc.convert(Q([1.0, -2.0], "klx"), "cd", distance="1m")
