"""A band between wavelengths, frequencies and wavenumbers is narrow, however it is converted."""

from itertools import permutations, product

import numpy as np
import pytest
from conftest import run

import radcalc
from radcalc.conversion.plan import plan
from radcalc.errors import ConditionError
from radcalc.inputs.reading import read
from radcalc.streams.readers import Bulk
from radcalc.units.table import resolve

C = 299792458.0  # SI Brochure
UNITS = {"nm": 1e-9, "THz": 1e12, "cm-1": 100.0}
PLACES = [10e-9, 555e-9, 10.6e-6]  # wavelengths [m]
PARTS = [1e-6, 1e-3, 0.05, 0.099, 0.101, 0.5, 1.5]  # widths of bands, of their places
FORMS = ["W{}", "lx{}", "cd/m2{}", "umol/m2/s{}", "J/m2{}"]


def on(axis: str, wavelength: float) -> float:
    """Return the place of a wavelength on an axis, in the unit of the axis."""
    si = {"nm": wavelength, "THz": C / wavelength, "cm-1": 1 / wavelength}[axis]
    return si / UNITS[axis]


def width_between(axis: str, other: str, place: float, part: float) -> float:
    """Return the width on another axis of a band whose middle is at a wavelength."""
    middle = on(axis, place) * UNITS[axis]
    ends = (middle * (1 - part / 2), middle * (1 + part / 2))
    waves = [{"nm": x, "THz": C / x, "cm-1": 1 / x}[axis] for x in ends]
    return abs(on(other, waves[0]) - on(other, waves[1]))


CASES = [(*axes, *rest) for axes in permutations(UNITS, 2) for rest in product(PLACES, PARTS)]


def is_narrow(axis: str, other: str, part: float) -> bool:
    return part <= 0.1 or {axis, other} == {"THz", "cm-1"}  # proportional at every width


def test_the_width_of_a_band_is_converted_if_it_is_narrow():
    """In every way: a number, an array, a block of a stream."""
    for axis, other, place, part in CASES:
        if "nm" not in (axis, other):
            continue
        at, size = read("wavelength", f"{place!r}m"), part * on(axis, place)
        made = plan(resolve(axis), resolve(other), [at])
        lines = f"{size!r}\n".encode()
        if is_narrow(axis, other, part):
            exact = width_between(axis, other, place, part)
            assert made.apply(size) == pytest.approx(exact, rel=0.003)
            assert Bulk(made, 12).lines(lines) == b"%.12g\n" % made.apply(size)
            continue
        for value in (size, np.array([size / 1e6, size])):
            with pytest.raises(ConditionError, match="not small compared with"):
                made.apply(value)
        assert Bulk(made, 12).lines(lines) is None  # for the grammar, which refuses it


@pytest.mark.parametrize("form", FORMS)
def test_a_density_takes_a_width_on_another_axis_if_it_is_narrow(form):
    for axis, other, place, part in CASES:
        density, total = resolve(form.format(f"/{axis}")), resolve(form.format(""))
        given = [read("bandwidth", f"{part * on(other, place)!r}{other}")]
        if "nm" in (axis, other):
            given.append(read("wavelength", f"{place!r}m"))
        for source, target in ((density, total), (total, density)):
            if not is_narrow(axis, other, part):
                with pytest.raises(ConditionError, match="not small compared with"):
                    plan(source, target, given)
                continue
            factor = width_between(other, axis, place, part)
            expected = factor if target == total else 1 / factor
            assert plan(source, target, given).apply(1.0) == pytest.approx(expected, rel=0.003)


def test_a_wide_band_is_refused_by_the_command_the_stream_and_python():
    for words in (
        ("100", "W/m2", "W/m2/nm", "--bandwidth", "2000THz"),
        ("2000", "THz", "nm"),
        ("-", "THz", "nm"),
    ):
        done = run("convert", *words, "--wavelength", "555nm", input="1\n2000\n")
        assert done.returncode == 2
        assert "2000THz is not small compared with --wavelength 555nm" in done.stderr
        assert done.stdout == ("1.02746080423\n" if words[0] == "-" else "")
    with pytest.raises(ConditionError, match="not small"):
        radcalc.convert(radcalc.Quantity([1.0, 2000.0], "THz"), "nm", wavelength="555 nm")
