"""Spectra against published values, closed forms and independent quadrature."""

import math
from itertools import pairwise

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc.errors import RadcalcError
from radcalc.spectra import planck
from radcalc.spectra.files import read_file
from radcalc.spectra.integrals import clip, integral, weighted
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.sources import names, spectrum
from radcalc.spectra.spectrum import WHOLE

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


RANGES = [(400e-9, 700e-9), (1e-9, 1e-6), (5e-6, 20e-6), (1e-3, 1)]


@pytest.mark.parametrize("temperature", [300.0, 2000.0, 2856.0, 6000.0, 1e4, 1e6])
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
    assert got == pytest.approx(float(watts), rel=1e-9, abs=1e-15 * whole)
    got = planck.photon_exitance(temperature, low, high)
    total = 1.52046e15 * temperature**3
    assert got == pytest.approx(float(photons), rel=1e-9, abs=1e-14 * total)


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


def test_repairs_are_said(tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text("500 3\n450 -0.1\n600 2\n", encoding="utf-8")
    notes = " ".join(read_file(str(path)).notes)
    for said in ("sorted", "negative", "nanometres", "not all of the visible"):
        assert said in notes
