"""Densities and widths on four axes: wavelength, frequency, wavenumber and photon energy.

A width between wavelengths and another axis is narrow, however it is converted.
"""

from fractions import Fraction
from itertools import permutations, product

import numpy as np
import pytest
from conftest import run

import radcalc
from radcalc.conversion.plan import plan
from radcalc.errors import ConditionError
from radcalc.inputs.reading import read
from radcalc.quantities import name_of
from radcalc.streams.readers import Bulk
from radcalc.units.table import resolve

C, H = 299792458.0, 6.62607015e-34  # SI Brochure
UNITS = {"nm": 1e-9, "THz": 1e12, "cm-1": 100.0, "meV": 1.602176634e-22}
PLACES = [10e-9, 555e-9, 10.6e-6]  # wavelengths [m]
PARTS = [1e-6, 1e-3, 0.05, 0.099, 0.101, 0.5, 1.5]  # widths of bands, of their places
FORMS = ["W{}", "lx{}", "cd/m2{}", "umol/m2/s{}", "J/m2{}"]


def at_place(axis: str, x: float) -> float:
    """Return the wavelength of a place on an axis, or the place of a wavelength [SI]."""
    return {"nm": x, "THz": C / x, "cm-1": 1 / x, "meV": H * C / x}[axis]


def on(axis: str, wavelength: float) -> float:
    """Return the place of a wavelength on an axis, in the unit of the axis."""
    return at_place(axis, wavelength) / UNITS[axis]


def width_between(axis: str, other: str, place: float, part: float) -> float:
    """Return the width on another axis of a band whose middle is at a wavelength."""
    middle = on(axis, place) * UNITS[axis]
    ends = (middle * (1 - part / 2), middle * (1 + part / 2))
    waves = [at_place(axis, x) for x in ends]
    return abs(on(other, waves[0]) - on(other, waves[1]))


CASES = [(*axes, *rest) for axes in permutations(UNITS, 2) for rest in product(PLACES, PARTS)]


def is_narrow(axis: str, other: str, part: float) -> bool:
    return part <= 0.1 or "nm" not in (axis, other)  # proportional at every width


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


# Exact ratios, so more than 50 digits: the SI's h, c, e and N_A; coherent units of each axis.
LIGHT, PLANCK = Fraction(299792458), Fraction("6.62607015e-34")
EXACT = {
    "nm": Fraction("1e-9"), "um": Fraction("1e-6"), "THz": Fraction("1e12"), "Hz": Fraction(1),
    "cm-1": Fraction(100), "eV": Fraction("1.602176634e-19"), "meV": Fraction("1.602176634e-22"),
    "J": Fraction(1),
}  # fmt: skip
# d wavelength / d x is the square of the wavelength over this constant; None for wavelengths
SLOPES = {"THz": LIGHT, "Hz": LIGHT, "cm-1": Fraction(1)}
ENERGIES = ("eV", "meV", "J")
HEADS = {"e": ("W/m2", "J/m2/sr"), "v": ("lx", "lm.s/m2/sr"), "p": ("photon/s/m2", "photon/m2/sr")}
V = {"500": "0.323", "555": "1", "600": "0.631"}  # CIE 018:2019, table 1, at nm in air


def spread(axis: str, wavelength: Fraction) -> Fraction:
    """Return |d wavelength / d x| of an axis, per one of its unit [m]."""
    if axis in ("nm", "um"):
        return EXACT[axis]
    constant = PLANCK * LIGHT if axis in ENERGIES else SLOPES[axis]
    return wavelength**2 / constant * EXACT[axis]


def watts(kind: str, nm: str) -> Fraction:
    """Return the watts of a coherent unit of a kind of light at a wavelength."""
    if kind == "v":
        return 1 / (Fraction("683.002") * Fraction(V[nm]))  # K_m of CIE 018:2019
    return PLANCK * LIGHT / (int(nm) * EXACT["nm"]) if kind == "p" else Fraction(1)


@pytest.mark.parametrize("nm", V)
def test_a_density_is_exact_between_all_axes_and_kinds(nm):
    wavelength = int(nm) * EXACT["nm"]
    given = [read("wavelength", f"{nm}nm")]
    for start, end in product(HEADS, repeat=2):
        for axis, other in permutations(EXACT, 2):
            ratio = spread(other, wavelength) / spread(axis, wavelength)
            ratio *= watts(start, nm) / watts(end, nm)
            for head, tail in zip(HEADS[start], HEADS[end], strict=True):
                source, target = resolve(f"{head}/{axis}"), resolve(f"{tail}/{other}")
                is_needed = start != end or ("m" in (axis[-1], other[-1]) and axis[-1] != other[-1])
                made = plan(source, target, given if is_needed else [])
                assert made.apply(3.0) == pytest.approx(float(3 * ratio), rel=3e-15)


def test_a_width_is_exact_between_all_axes():
    for nm, (axis, other) in product(V, permutations(EXACT, 2)):
        wavelength = int(nm) * EXACT["nm"]
        is_length = [one in ("nm", "um") for one in (axis, other)]
        given = [read("wavelength", f"{nm}nm")] if any(is_length) and not all(is_length) else []
        size = Fraction("1e-9") / spread(axis, wavelength)  # of 1 nm
        exact = size * spread(axis, wavelength) / spread(other, wavelength)
        made = plan(resolve(axis), resolve(other), given)
        assert made.apply(float(size)) == pytest.approx(float(exact), rel=3e-15)


def test_the_wavelength_of_a_density_may_be_on_any_axis():
    # 121.6 nm is Lyman alpha: 3 * (121.6 nm)^2 / (h c) = 35.7784948087 W/m2/eV
    for place in ("121.6nm", f"{LIGHT / Fraction('121.6e-9')}Hz", "82236.842105263158cm-1"):
        found = plan(resolve("W/m2/nm"), resolve("W/m2/eV"), [read("wavelength", place)])
        assert found.apply(3.0) == pytest.approx(35.7784948087, rel=1e-11)


def test_joules_and_photons_per_joule_are_no_densities():
    for text in ("umol/J", "lm.s/J", "J/J"):
        assert "spectral" not in name_of(resolve(text))
    assert plan(resolve("umol/J"), resolve("photon/eV")).links == ()
