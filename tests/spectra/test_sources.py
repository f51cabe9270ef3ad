"""Spectra against published values, closed forms and independent quadrature."""

import math
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from conftest import run
from hypothesis import given
from hypothesis import strategies as st

from radcalc import spectra
from radcalc.calculators.mesopic import solve
from radcalc.calculators.spectrum import spectrum as describe
from radcalc.errors import RadcalcError
from radcalc.spectra import planck
from radcalc.spectra.files import read_file
from radcalc.spectra.integrals import clip, integral, weighted
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.sources import names, spectrum
from radcalc.spectra.spectrum import WHOLE, Table

PHOTOPIC, SCOTOPIC = OBSERVERS["photopic"], OBSERVERS["scotopic"]
MICROMOLE = 6.02214076e17


def efficacy(text: str, limits=None) -> float:
    source = spectrum(text)
    return PHOTOPIC.maximum * source.seen(PHOTOPIC) / source.power(limits or source.limits)


# Published luminous efficacies of radiation [lm/W] and where the watts are counted [nm].
PUBLISHED = [
    ("A", (360, 830), 122.9, 0.05),
    ("A", (380, 780), 156.2, 0.05),
    ("D65", (360, 830), 184.4, 0.05),
    ("D65", (380, 780), 205.2, 0.06),
    ("F11", (380, 780), 337, 0.5),
    ("LED-B3", (380, 780), 317, 0.5),
    ("blackbody:2856K", WHOLE, 16.4, 0.05),
    ("blackbody:6628K", WHOLE, 95.4, 0.05),
    ("AM1.5G", (280, 4000), 109.5, 0.05),
]


@pytest.mark.parametrize(("source", "limits", "value", "within"), PUBLISHED)
def test_published_luminous_efficacies(source, limits, value, within):
    assert efficacy(source, limits) == pytest.approx(value, abs=within)


def test_the_best_black_body_has_6628_k():
    best = max(range(6600, 6660), key=lambda t: efficacy(f"blackbody:{t}K"))
    assert abs(best - 6628) <= 2


@pytest.mark.parametrize(("source", "ratio"), [("A", 1.41), ("D65", 2.46)])
def test_published_scotopic_to_photopic_ratios(source, ratio):
    light = spectrum(source)
    scotopic = SCOTOPIC.maximum * light.seen(SCOTOPIC)
    assert scotopic / (PHOTOPIC.maximum * light.seen(PHOTOPIC)) == pytest.approx(ratio, abs=0.006)


def test_the_suns_of_astm_g173():
    # E490 and G173-03: 1348 W/m2 from 280 to 4000 nm outside the atmosphere, 1000.4 and 900.1
    for name, watts in (("AM0", 1347.9), ("AM1.5G", 1000.4), ("AM1.5D", 900.1)):
        sun = spectrum(name)
        assert sun.power(sun.limits) == pytest.approx(watts, abs=0.06)
    outside = spectrum("AM0")
    assert PHOTOPIC.maximum * outside.seen(PHOTOPIC) == pytest.approx(133e3, abs=500)
    ground = spectrum("AM1.5G")
    par = ground.photons((400, 700)) / MICROMOLE
    assert PHOTOPIC.maximum * ground.seen(PHOTOPIC) / par == pytest.approx(55.4, abs=0.05)
    assert par / ground.power((400, 700)) == pytest.approx(4.60, abs=0.02)
    assert "AM1.5G" in spectrum("sun").notes[0]


RANGES = [(400e-9, 700e-9), (555e-9, 556e-9), (1e-9, 1e-6), (5e-6, 20e-6), (1e-3, 1)]


@pytest.mark.parametrize("temperature", [300.0, 2000.0, 2856.0, 6000.0, 1e4, 1e6, 1e9])
@pytest.mark.parametrize(
    ("low", "high"), [(400e-9, 700e-9), (1e-9, 1e-6), (5e-6, 20e-6), (1e-3, 1)]
)
def test_a_black_bodys_part_of_a_range_agrees_with_quadrature(temperature, low, high):
    with mpmath.workdps(30):
        h, c, k = mpmath.mpf("6.62607015e-34"), mpmath.mpf(299792458), mpmath.mpf("1.380649e-23")
        a, b = (h * c / (x * k * temperature) for x in (high, low))
        cuts = [a, *(x for x in (a + 1, a + 5, a + 20, a + 80) if x < b), b]
        power = mpmath.quad(lambda x: x**3 / mpmath.expm1(x), cuts)
        count = mpmath.quad(lambda x: x**2 / mpmath.expm1(x), cuts)
        watts = 2 * mpmath.pi * (k * temperature) ** 4 / (h**3 * c**2) * power
        photons = 2 * mpmath.pi * (k * temperature / h) ** 3 / c**2 * count
    whole = 5.670374419e-8 * temperature**4
    got = planck.exitance(temperature, low, high)
    assert got == pytest.approx(float(watts), rel=1e-9, abs=1e-25 * whole)
    got = planck.photon_exitance(temperature, low, high)
    total = 1.52046e15 * temperature**3
    assert got == pytest.approx(float(photons), rel=1e-9, abs=1e-25 * total)


def test_stefan_boltzmann_and_wien():
    assert pytest.approx(5.670374419e-8, rel=1e-9) == planck.STEFAN_BOLTZMANN  # CODATA 2018
    assert planck.exitance(5772) == pytest.approx(6.2939e7, rel=1e-4)  # the nominal sun
    peak = max(range(400, 600), key=lambda nm: planck.spectral_exitance(nm * 1e-9, 5772.0))
    assert peak == 502  # 2897.771955 um K / 5772 K


@given(
    st.lists(st.floats(310, 900), min_size=2, max_size=12, unique=True),
    st.data(),
)
def test_the_integral_is_the_trapezoid_on_the_union_of_both_grids(places, data):
    grid = sorted(places)
    values = data.draw(st.lists(st.floats(0, 10), min_size=len(grid), max_size=len(grid)))
    if min(b - a for a, b in pairwise(grid)) < 1e-6:
        return
    nodes = range(PHOTOPIC.start, PHOTOPIC.end + 1)
    union = sorted({*grid, *(n for n in nodes if grid[0] <= n <= grid[-1])})
    union = [x for x in union if PHOTOPIC.start <= x <= PHOTOPIC.end]

    def linear(xs, ys, x):
        i = max(j for j in range(len(xs) - 1) if xs[j] <= x)
        return ys[i] + (ys[i + 1] - ys[i]) * (x - xs[i]) / (xs[i + 1] - xs[i])

    heights = [linear(grid, values, x) * linear(nodes, PHOTOPIC.values, x) for x in union]
    pairs = zip(union, union[1:], heights, heights[1:], strict=False)
    expected = math.fsum((b - a) * (p + q) / 2 for a, b, p, q in pairs)
    got = weighted(grid, values, PHOTOPIC.start, PHOTOPIC.values)
    assert got == pytest.approx(expected, rel=1e-9, abs=1e-12)


def test_a_range_clips_with_a_step():
    grid, values = [400.0, 500.0, 600.0], [1.0, 1.0, 1.0]
    assert integral(grid, values, 450, 550) == 100
    assert clip(grid, values, 450, 550) == ([450, 500, 550], [1, 1, 1])
    assert integral(grid, values, 700, 800) == 0
    assert integral(grid, values, 100, 450) == 50


def test_every_named_source_is_counted_in_watts_lumens_and_photons():
    assert len(names()) == 59 + 56 + 3
    for name in names():
        light = spectrum(name)
        assert light.power(light.limits) > 0, name
        assert 10 < efficacy(name) < 683.002, name
        assert light.photons((400, 700)) > 0, name


@pytest.mark.parametrize(
    ("one", "other"),
    [("F1", "FL1"), ("f11", "FL11"), ("led-b3", "LED-B3"), ("ledb3", "LED-B3"), ("hps", "HPS"),
     ("am1.5g", "AM1.5G"), ("F3.1", "FL3.1"), ("d65", "D65")],
)  # fmt: skip
def test_names_are_found_as_people_type_them(one, other):
    assert spectrum(one).label == spectrum(other).label


def test_lines_bands_and_gaussians():
    # V(555) = 1, V(600) = 0.631, the CIE table
    lines = spectrum("line:555nm=40,600nm=30")
    assert lines.seen(PHOTOPIC) == pytest.approx(40 + 30 * 0.631, rel=1e-9)
    assert lines.power(WHOLE) == 70
    band = spectrum("band:580nm:630nm")
    assert band.power(WHOLE) == 50
    # photons of a flat band: the mean wavelength
    per_watt = band.photons(WHOLE) / band.power(WHOLE)
    assert per_watt == pytest.approx(605e-9 / (6.62607015e-34 * 299792458), rel=1e-12)
    bell = spectrum("gaussian:530nm,30nm")
    area = 30 * math.sqrt(math.pi / math.log(2)) / 2  # of a Gaussian of that FWHM
    assert bell.power(WHOLE) == pytest.approx(area, rel=1e-6)
    assert spectrum("line:540THz").seen(PHOTOPIC) == pytest.approx(683 / 683.002, rel=1e-6)


def test_daylight_6504_k_is_d65():
    light, table = spectrum("daylight:6503.6K"), spectrum("D65")
    for a, b in zip(light.values, table.values, strict=True):
        assert a == pytest.approx(b, rel=1e-3, abs=0.02)


FILES = {
    "commas": "400,1\n500,3\n700,2\n",
    "blanks": "400 1\n500   3\n700 2\n",
    "tabs": "400\t1\n500\t3\n700\t2\n",
    "semicolons and decimal commas": "400,0;1,0\n500,0;3,0\n700,0;2,0\n",
    "a header": "wavelength,value\n400,1\n500,3\n700,2\n",
    "comments and blank lines": "# a lamp\n\n400 1\n500 3\n# more\n700 2\n",
    "a byte order mark and CRLF": "\ufeff400,1\r\n500,3\r\n700,2\r\n",
    "micrometres by their size": "0.4 1\n0.5 3\n0.7 2\n",
    "angstroms by the header": "wavelength (angstrom),value\n4000,1\n5000,3\n7000,2\n",
    "metres": "4e-7 1\n5e-7 3\n7e-7 2\n",
    "falling": "700 2\n500 3\n400 1\n",
    "out of order": "500 3\n400 1\n700 2\n",
    "quotes": '"400","1"\n"500","3"\n"700","2"\n',
}


@pytest.mark.parametrize("text", FILES.values(), ids=FILES.keys())
def test_a_spectrum_is_read_however_it_is_written(text, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_bytes(text.encode())
    table = read_file(str(path))
    assert list(table.grid) == pytest.approx([400, 500, 700])
    assert list(table.values) == [1, 3, 2]
    assert table.power(table.limits) == pytest.approx(100 * 2 + 200 * 2.5)


def test_a_column_is_chosen_by_name_or_number(tmp_path):
    path = tmp_path / "lamps.csv"
    path.write_text("nm,red,blue\n400,1,9\n700,2,8\n", encoding="utf-8")
    assert list(read_file(str(path), "blue").values) == [9, 8]
    assert list(read_file(str(path), "2").values) == [1, 2]
    with pytest.raises(RadcalcError, match="2 columns of values"):
        read_file(str(path))


def test_a_unit_in_the_header_makes_a_spectrum_absolute(tmp_path):
    path = tmp_path / "sun.csv"
    path.write_text("wavelength (nm),E (W/m2/um)\n400,1000\n700,1000\n", encoding="utf-8")
    table = read_file(str(path))
    assert table.absolute == "irradiance"
    assert table.power(table.limits) == pytest.approx(300)  # 1 W/m2/nm over 300 nm


BROKEN = {
    "nothing": ("", "no data"),
    "one row": ("400 1\n", "1 row"),
    "one column": ("400\n500\n", "line 1: one column"),
    "a missing value": ("400,1\n500,\n600,2\n", "line 2: a value is missing"),
    "a word": ("400,1\n500,x\n600,2\n", "line 2: 'x' is not a number"),
    "not a number": ("400,1\n500,nan\n600,2\n", "line 2: 'nan' is not a number"),
    "a short row": ("400 1\n500\n600 2\n", "line 2: 1 columns"),
    "a long row": ("400 1\n500 2 3\n600 2\n", "line 2: 3 columns"),
    "twice the same": ("400 1\n500 2\n\n400 2\n", "line 4: the wavelength 400 nm stands in line 1"),
    "darkness": ("400 0\n500 0\n", "every value is 0"),
    "a negative wavelength": ("-400 1\n500 2\n", "a wavelength of -400"),
    "a frequency": ("frequency (THz),x\n400,1\n700,1\n", "is no wavelength"),
    "an unknown length": ("wavelength (furlong),x\n400,1\n700,1\n", "no unit of length"),
    "wavelengths last": ("value,wavelength (nm)\n1,400\n1,700\n", "not in the first column"),
    "photons": ("nm,J (umol/m2/s/nm)\n400,1\n700,1\n", "no radiant power per wavelength"),
    "per hertz": ("nm,K (W/m2/Hz)\n400,1\n700,1\n", "no radiant power per wavelength"),
    "dark light": ("400,1\n550,-0.5\n700,1\n", "too far below 0 for noise"),
    "an underscore": ("400,1\n5_50,2\n700,1\n", "line 2: '5_50' is not a number"),
    "other digits": ("400,1\n٥٥٠,2\n700,1\n", "line 2"),
    "an unknown unit": ("4000 1\n7000 2\n", "not declared"),
    "no text": (b"400 1\n500 \xff\n", "line 2: not UTF-8"),
}


@pytest.mark.parametrize(("text", "message"), BROKEN.values(), ids=BROKEN.keys())
def test_what_is_wrong_with_a_file_is_said_with_its_line(text, message, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(RadcalcError) as caught:
        read_file(str(path))
    assert message in caught.value.message
    assert caught.value.hint


def test_an_unreadable_file_is_an_error(tmp_path):
    with pytest.raises(RadcalcError, match="cannot read"):
        read_file(str(tmp_path))


@pytest.mark.parametrize(
    ("head", "scale"),
    [
        ("wavelength [um],x", 1e-3),
        ("Wavelength (Angstroms),x", 10),
        ("nm,x", 1),
        ("# wavelength in nm\nw,x", 1),
        ("# a wavelength sweep at 3 m\nw,x", 1),
        ("wavelength_nm,x", 1),
        ("wavelength (nanometers),x", 1),
        ("µm,x", 1e-3),
    ],
)
def test_the_unit_of_wavelengths_is_declared_in_many_ways(head, scale, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"{head}\n{400 * scale},1\n{700 * scale},2\n", encoding="utf-8")
    table = read_file(str(path))
    assert list(table.grid) == pytest.approx([400, 700])
    assert any("wavelengths are" in note for note in table.notes)


@pytest.mark.parametrize(
    "text",
    ["gaussian:530nm,1e-12nm", "gaussian:530nm,1um", "gaussian:530nm", "band:700nm:600nm",
     "line:0nm", "line:555nm=0", "line:555nm=2W", "blackbody:5m", "daylight:1K", "line:",
     "blackbody:", "band:1nm"],
)  # fmt: skip
def test_a_source_that_makes_no_sense_is_refused(text):
    with pytest.raises(RadcalcError) as caught:
        spectrum(text)
    assert caught.value.hint


def test_more_lumens_than_the_watts_can_give_are_refused():
    with pytest.raises(RadcalcError, match="leaves out most"):
        describe(spectrum("D65"), limits=(600, 610))


def test_repairs_are_said(tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text("500 3\n450 -0.1\n600 2\n", encoding="utf-8")
    notes = " ".join(read_file(str(path)).notes)
    for said in ("sorted", "negative", "nanometres", "not all of the visible"):
        assert said in notes


def test_arrays_of_spectra_give_what_each_spectrum_gives():
    grid = np.linspace(390, 720, 34)
    cube = np.random.default_rng(1).random((3, 4, 34))
    lumens = spectra.luminous(grid, cube)
    efficacies = spectra.luminous_efficacy(grid, cube, limits=(400, 700))
    assert lumens.shape == efficacies.shape == (3, 4)
    for index in np.ndindex(3, 4):
        table = Table("", list(grid), list(cube[index]))
        seen = PHOTOPIC.maximum * table.seen(PHOTOPIC)
        assert lumens[index] == pytest.approx(seen, rel=1e-12)
        assert efficacies[index] == pytest.approx(seen / table.power((400, 700)), rel=1e-12)


def test_dask_arrays_stay_lazy_and_give_the_same():
    import dask.array

    grid = np.linspace(380, 780, 41)
    cube = np.random.default_rng(2).random((20, 30, 41))
    lazy = dask.array.from_array(cube, chunks=(5, 10, 41))
    for function in (spectra.luminous, spectra.luminous_efficacy):
        result = function(grid, lazy)
        assert isinstance(result, dask.array.Array)
        np.testing.assert_allclose(result.compute(), function(grid, cube), rtol=1e-12)


@pytest.mark.parametrize(
    ("grid", "shape", "observer"),
    [
        ([500.0, 400.0], (2,), "photopic"),
        ([400.0, 500.0], (3,), "photopic"),
        ([400.0], (1,), "photopic"),
        ([-1.0, 500.0], (2,), "photopic"),
        ([400.0, 500.0], (2,), "owl"),
    ],
)
def test_arrays_that_do_not_fit_are_refused(grid, shape, observer):
    with pytest.raises(RadcalcError):
        spectra.luminous(grid, np.ones(shape), observer)


def test_a_large_file_gives_what_a_small_one_gives(tmp_path):
    grid = np.linspace(300, 1100, 20001)
    values = np.exp(-(((grid - 550) / 80) ** 2))
    path = tmp_path / "large.csv"
    header = "wavelength (nm),E (W/m2/nm)"
    np.savetxt(path, np.c_[grid, values], fmt="%.10g", delimiter=",", header=header, comments="")
    assert path.stat().st_size > 2**18
    large = read_file(str(path))
    small = Table("", grid.tolist(), values.tolist())
    assert large.absolute == "irradiance"
    for limits in (WHOLE, (400, 700), (555.5, 555.6), (2000, 3000)):
        assert large.power(limits) == pytest.approx(small.power(limits), rel=1e-8)
        assert large.photons(limits) == pytest.approx(small.photons(limits), rel=1e-8)
    assert large.seen(PHOTOPIC) == pytest.approx(small.seen(PHOTOPIC), rel=1e-8)
    assert large.peak() == pytest.approx(small.peak(), rel=1e-6)


@pytest.mark.parametrize(
    ("line", "message"),
    [("nan,1", "'nan' is not a number"), ("300,1", "stands in line"), ("700", "1 columns"),
     ("700,x", "'x' is not a number")],
)  # fmt: skip
def test_what_is_wrong_with_a_large_file_is_said_with_its_line(line, message, tmp_path):
    path = tmp_path / "large.csv"
    rows = [f"{300 + i / 50},1.000000001" for i in range(20000)]
    path.write_text("\n".join([*rows, line]) + "\n", encoding="utf-8")
    with pytest.raises(RadcalcError) as caught:
        read_file(str(path))
    assert "line 20001" in caught.value.message
    assert message in caught.value.message


@pytest.mark.parametrize(
    ("luminance", "ratio", "mesopic", "m"),
    [
        (0.1, 2.0, 0.13096, 0.4727),  # CIE 191, MES2
        (10.0, 2.0, 10.0, 1.0),
        (0.001, 1.0, 0.001, 0.0),
    ],
)
def test_mesopic_luminance_is_the_fixed_point(luminance, ratio, mesopic, m):
    got, adapted = solve(luminance, ratio)
    assert got == pytest.approx(mesopic, abs=5e-6)
    assert adapted == pytest.approx(m, abs=5e-5)


@given(st.floats(1e-5, 100), st.floats(0.2, 5))
def test_the_mesopic_solution_is_consistent(luminance, ratio):
    # CIE 191:2010: m = 0.7670 + 0.3334 log10 L_mes, between 0.005 and 5 cd/m2
    mesopic, m = solve(luminance, ratio)
    assert 0 <= m <= 1
    if 0.0051 < mesopic < 4.99:
        assert m == pytest.approx(0.7670 + 0.3334 * math.log10(mesopic), abs=1e-9)


def results(text: str, **ranges) -> dict[str, float]:
    return {v.name: v.si for v in describe(spectrum(text), **ranges)[0]}


def test_a_spectrum_is_described():
    # the nominal sun of 5772 K: Wien 502.04 nm, Stefan-Boltzmann 6.2939e7 W/m2
    sun = results("blackbody:5772K")
    assert sun["peak-wavelength"] == pytest.approx(2.897771955e-3 / 5772, rel=1e-9)
    assert sun["exitance"] == pytest.approx(5.670374419e-8 * 5772**4, rel=1e-9)
    assert sun["radiance"] == pytest.approx(sun["exitance"] / math.pi, rel=1e-14)
    assert sun["cct"] == pytest.approx(5772, abs=1)
    # CIE 15: A is x 0.4476, y 0.4074, 2856 K and, as its own reference, Ra 100
    a = results("A")
    assert (a["x"], a["y"]) == pytest.approx((0.4476, 0.4074), abs=5e-5)
    assert a["cct"] == pytest.approx(2856, abs=1)
    assert a["cri"] == pytest.approx(100, abs=0.05)
    assert a["sp-ratio"] == pytest.approx(1.41, abs=0.005)
    d65 = results("D65")
    assert (d65["x"], d65["y"]) == pytest.approx((0.3127, 0.3290), abs=5e-5)
    # CIE 15, table of fluorescent lamps: F2 4230 K, Ra 64; F11 4000 K, Ra 83
    for name, temperature, rendering in (("F2", 4230, 64), ("F11", 4000, 83)):
        lamp = results(name)
        assert lamp["cct"] == pytest.approx(temperature, abs=10)
        assert lamp["cri"] == pytest.approx(rendering, abs=1)


def test_a_range_has_its_share_and_its_efficacy():
    half = results("band:400nm:700nm", limits=(300, 550))
    assert half["range-fraction"] == pytest.approx(0.5)
    assert half["range-start"] == pytest.approx(400e-9)  # there is nothing before
    whole = results("gaussian:530nm,30nm")
    assert whole["fwhm"] == pytest.approx(30e-9, rel=1e-3)
    assert whole["centroid-wavelength"] == pytest.approx(530e-9, rel=1e-9)
    assert "cct" not in whole  # green is no white


def test_no_power_in_the_range_is_refused():
    with pytest.raises(RadcalcError, match="no power"):
        describe(spectrum("band:500nm:600nm"), limits=(700, 800))


def test_colour_science_says_nothing_on_standard_error():
    done = run("spectrum", "LED-B3", "-g", "cri", "-q")
    assert (done.returncode, done.stderr) == (0, "")
