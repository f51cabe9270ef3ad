"""Long ranges and arrays give the same results as single values."""

import itertools
import math
import random

import numpy as np
import pytest
from conftest import run
from helpers import Q, flagged

from radcalc import calorimeter, ev, lambertian, point_source
from radcalc.errors import ConditionError, UsageError

PI = math.pi


@pytest.mark.parametrize(
    ("command", "option", "start", "step", "unit"),
    [
        ("point-source --flux 800lm -g irradiance:lx -g intensity:cd", "--distance", 1, 0.005, "m"),
        ("point-source --intensity 9cd --exponent 3 --height 2m -g irradiance:lx -g off-axis:deg",
         "--offset", 0, 0.01, "m"),
        ("lambertian sphere --luminance 2e4cd/m2 --radius 6cm -g irradiance:lx", "--distance",
         0.1, 0.003, "m"),
        ("ev --f-number 8 -g ev100:1 -g luminance:cd/m2", "--time", 0.001, 0.001, "s"),
        ("calorimeter --energy 5J --mass 10g -g temperature-rise:K", "--specific-heat", 100, 0.7,
         "J/kg/K"),
    ],
)  # fmt: skip
def test_a_long_range_prints_the_same_as_single_values(command, option, start, step, unit):
    count = 1203
    stop = start + step * (count - 1)
    done = run(*command.split(), option, f"{start}{unit}:{stop:.12g}{unit}:{step}{unit}")
    lines = done.stdout.splitlines()
    assert len(lines) == count, done.stderr
    picked = random.Random(command).sample(range(count), 40)
    texts = ",".join(f"{start + k * step:.15g}{unit}" for k in picked)
    short = run(*command.split(), option, texts)
    assert [lines[k] for k in picked] == short.stdout.splitlines()
    alone = run(*command.split(), option, f"{start + picked[0] * step:.15g}{unit}")
    assert alone.stdout.splitlines() == [lines[picked[0]]]


@pytest.mark.parametrize(
    ("call", "words", "base", "name", "values"),
    [
        (point_source, (), {"flux": "800lm"}, "distance", Q([1.0, 2, 5, 9.7], "m")),
        (point_source, (), {"flux": "800lm", "within": "50deg"}, "exponent", Q([0.5, 1, 90], "1")),
        (point_source, (), {"flux": "800lm", "distance": "2m"}, "beam-angle",
         Q([1.0, 40, 179], "deg")),
        (point_source, (), {"intensity": "800cd", "height": "3m", "half-angle": "30deg"}, "offset",
         Q([0.0, 1, 1.7, 2], "m")),
        (point_source, (), {"intensity": "800cd", "height": "3m", "exponent": "2"}, "offset",
         Q([0.0, -1, 1.7, 20], "m")),
        (point_source, (), {"flux": "5mW", "wavelength": "632.8nm"}, "distance",
         Q([1.0, 2], "m")),
        (lambertian, ("patch",), {"radiance": "9W/m2/sr", "area": "1mm2"}, "distance",
         Q([1.0, 2, 3], "m")),
        (lambertian, ("disc",), {"radiance": "9W/m2/sr", "radius": "1m", "height": "1m"}, "offset",
         Q([0.0, -1, 1, 3], "m")),
        (lambertian, ("disc",), {"radiance": "9W/m2/sr", "irradiance": "1W/m2"}, "distance",
         Q([0.1, 1, 30], "m")),
        (lambertian, ("sphere",), {"radiance": "9W/m2/sr", "radius": "1m", "distance": "2m"},
         "incidence", Q([0.0, 50, 70, 119, 121], "deg")),
        (lambertian, ("rectangle",), {"radiance": "9W/m2/sr", "width": "1m", "length": "2m",
                                      "offset": "1m"}, "height", Q([0.1, 1, 30], "m")),
        (flagged, ("rectangle", "perpendicular"),
         {"radiance": "9W/m2/sr", "width": "1m", "length": "2m", "height": "1m"}, "offset-y",
         Q([0.5, 1.5], "m")),
        (flagged, ("rectangle", "perpendicular"),
         {"radiance": "9W/m2/sr", "width": "1m", "length": "2m", "height": "1m"}, "offset-y",
         Q([-0.5, 0, 0.5], "m")),
        (lambertian, ("rectangle",),
         {"radiance": "9W/m2/sr", "width": "1m", "length": "2m", "height": "1m",
          "incidence": "20deg"}, "offset", Q([0.0, 1, -1], "m")),
        (lambertian, ("rectangle",),
         {"radiance": "9W/m2/sr", "width": "1m", "length": "2m", "height": "1m",
          "incidence": "20deg"}, "offset", Q([0.5, 1, -1], "m")),
        (lambertian, ("disc",),
         {"radiance": "9W/m2/sr", "radius": "1m", "height": "1m", "incidence": "20deg"},
         "offset", Q([0.0, 1, -1], "m")),
        (lambertian, ("hemisphere",), {"radiance": "9W/m2/sr"}, "incidence",
         Q([0.0, 50, 180], "deg")),
        (ev, (), {"f-number": "8"}, "time", Q([0.001, 1, 30], "s")),
        (calorimeter, (), {"energy": "8J", "mass": "1g"}, "specific-heat",
         Q([100.0, 385], "J/kg/K")),
    ],
)  # fmt: skip
def test_arrays_give_the_same_as_floats(call, words, base, name, values):
    given_values = {n.replace("-", "_"): text for n, text in base.items()}
    own = name.replace("-", "_")
    columns = call(*words, **given_values, **{own: values})
    changing = 0
    for k, value in enumerate(values.magnitude):
        one = call(*words, **given_values, **{own: Q(float(value), values.units)})
        assert set(one) == set(columns)
        for result, single in one.items():
            column = columns[result].to(single.units).magnitude
            shape = np.shape(column)
            assert shape in ((), (len(values.magnitude),))
            changing += bool(shape)
            got = column[k] if shape else column
            assert got == pytest.approx(single.magnitude, rel=1e-13, abs=1e-15), result
    assert changing > len(values.magnitude)


def test_arrays_are_broadcast_together():
    found = point_source(flux=Q([100.0, 200, 300], "lm"), distance=Q([1.0, 2, 3], "m"))
    expected = [f / (4 * PI * d * d) for f, d in ((100, 1), (200, 2), (300, 3))]
    assert found["irradiance"].to("lx").magnitude == pytest.approx(expected, rel=1e-14)


def test_a_bad_element_of_an_array_is_refused():
    for bad in itertools.permutations([1.0, 2, -3]):
        with pytest.raises(ConditionError):
            point_source(flux="1lm", distance=Q(list(bad), "m"))
    with pytest.raises((ConditionError, UsageError)):
        lambertian(incident_illuminance="9lx", reflectance=Q([0.5, 1.1], "1"))
