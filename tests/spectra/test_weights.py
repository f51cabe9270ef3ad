"""The weights of spectra: check values, units that never mix, independent quadratures."""

import csv
import math
import shlex
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, process, run
from helpers import for_each

import radcalc
from radcalc.conversion.plan import plan
from radcalc.errors import RadcalcError
from radcalc.quantities import KIND_NAMES, name_of, place_of, ratio, ratio_of, ratio_unit
from radcalc.spectra.observers import OBSERVERS, OWN, count, observer_of, weight
from radcalc.spectra.sources import spectrum
from radcalc.units import WEIGHT_AT, compiled
from radcalc.units.catalogue import CATALOGUE
from radcalc.units.compiled import WEIGHTS
from radcalc.units.dimensions import SUFFIXES, weights_of
from radcalc.units.table import resolve

DATA = ROOT / "radcalc" / "spectra" / "data"
H, C, N_A = 6.62607015e-34, 299792458.0, 6.02214076e23


@pytest.fixture(autouse=True)
def _own_weights_are_forgotten():
    """Take the weights of files out of the tables again."""
    tables = (WEIGHTS, compiled.UNITS, compiled.SYMBOLS, compiled.NAMES, CATALOGUE, KIND_NAMES, OWN)
    kept, places = [dict(table) for table in tables], [*SUFFIXES]
    yield
    for table, before in zip(tables, kept, strict=True):
        table.clear()
        table.update(before)
    SUFFIXES[:] = places


def number(words):
    done = run(*shlex.split(words))
    assert done.returncode == 0, done.stderr
    return float(done.stdout.split()[0])


# CIE S 026/E:2018, table 3: mW/lm of D65 (the values of the CIE's toolbox have one digit more).
OF_D65 = {
    "melanopic": 1.32621,
    "l-cone-opic": 1.6289,
    "m-cone-opic": 1.4558,
    "s-cone-opic": 0.8173,
    "rhodopic": 1.4497,
}


@pytest.mark.parametrize(("name", "expected"), OF_D65.items())
def test_the_alpha_opic_efficacies_of_daylight(name, expected):
    digits = 5e-6 if name == "melanopic" else 5e-5
    assert number(f"spectrum D65 -g {name}-elr") == pytest.approx(expected, abs=digits)
    assert number(f"spectrum D65 -g {name}-der") == pytest.approx(1, rel=1e-12)


# Sums of the same tables with numpy: A by its formula, LED-B3 by linear interpolation; luxpy
# 1.12.5 has 0.5621 for FL11, whose lines the interpolation moves.
DER = {
    "A": (0.49575, 1e-4),
    "E": (0.90582, 5e-6),
    "LED-B3": (0.63257, 5e-6),
    "FL11": (0.5636, 2e-3),
}


@pytest.mark.parametrize(("source", "expected", "off"), [(k, *v) for k, v in DER.items()])
def test_the_melanopic_daylight_efficacy_ratio(source, expected, off):
    assert number(f"spectrum {source} -g melanopic-der") == pytest.approx(expected, abs=off)


def test_a_room_under_a_tungsten_lamp():
    """100 lx of illuminant A: 65.746 mW/m2 melanopic, the sum of its formula."""
    assert number("100 lx mW_mel/m2 --spectrum A") == pytest.approx(65.746, rel=1e-4)
    assert number("100 lx melanopic-edi --spectrum A") == pytest.approx(49.575, rel=1e-4)
    assert number("100 lx lx_mel --spectrum D65") == pytest.approx(100, rel=1e-12)
    assert number("100 lx EML --spectrum D65") == pytest.approx(100 / 0.9058, rel=1e-11)


def test_the_uv_index_of_the_sun():
    """0.092247 W/m2 erythemal: the trapezoids of ASTM G173-03, every 0.5 nm; 40 m2/W times it."""
    assert number("spectrum AM1.5G -g erythemal-irradiance") == pytest.approx(0.092247, abs=5e-7)
    assert number("spectrum AM1.5G -g uv-index") == pytest.approx(3.690, abs=5e-4)
    assert number("'1000.3707 W/m2' UVI --spectrum AM1.5G") == pytest.approx(3.690, abs=1e-3)
    assert number("1 SED J_ery/m2") == 100
    assert number("8 UVI mW_ery/m2") == 200


def test_the_erythema_action_spectrum_is_continuous():
    """ISO/CIE 17166: 140, not 139, in the last exponent; 139 would be 3.4 % lower."""
    own = weight("ery")
    assert own.range == (250, 400)
    assert own.at(298.0) == own.at(250.0) == 1
    below, above = own.at(328.0), 10 ** (0.015 * (140 - 328))
    assert below == pytest.approx(above, rel=1e-12)
    assert 10 ** (0.015 * (139 - 328)) / above == pytest.approx(0.966, abs=1e-3)
    assert own.at(400.5) == own.at(249.5) == 0


# ICNIRP 2004, table 1; ICNIRP 2013, table 2; McCree 1972, table IV.
POINTS = {
    "act": {200: 0.03, 254: 0.5, 270: 1.0, 300: 0.3, 315: 0.003, 365: 0.00011, 400: 3e-5},
    "blh": {380: 0.01, 400: 0.1, 435: 1.0, 440: 1.0, 450: 0.94, 500: 0.1, 600: 0.001, 700: 0.001},
    "ypf": {400: 0.42, 550: 0.82, 625: 1.0, 675: 0.9, 700: 0.48},
    "mel": {480: 0.965605, 490: 1.0, 500: 0.965952, 555: 0.162056},
    "rh": {507: 1.0, 555: 0.402},
}


@for_each([(kind, nm, w) for kind, points in POINTS.items() for nm, w in points.items()])
def test_a_weight_has_the_published_values(kind, nm, w):
    assert weight(kind).at(float(nm)) == pytest.approx(w, rel=1e-6)


def column(name, title):
    rows = [line for line in (DATA / name).read_text("utf-8").splitlines() if line[0] != "#"]
    table = list(csv.DictReader(rows, delimiter="\t"))
    pairs = [(float(row["nm"]), float(row[title])) for row in table if row[title]]
    return tuple(np.array(one) for one in zip(*pairs, strict=True))


def erythema(nm):
    steep, flat = 10 ** (0.094 * (298 - nm)), 10 ** (0.015 * (140 - nm))
    return np.where(nm <= 298, 1.0, np.where(nm <= 328, steep, flat))


def by_hand(kind, nm):
    """Return w at wavelengths: of a band, a formula or a table."""
    bands = {
        "uva": (315, 400),
        "par": (400, 700),
        "epar": (400, 750),
        "fr": (700, 800),
        "rs": (655, 665),
        "frs": (725, 735),
    }
    if kind in bands:
        low, high = bands[kind]
        return ((nm >= low) & (nm <= high)).astype(float)
    if kind == "ery":
        return np.where((nm >= 250) & (nm <= 400), erythema(nm), 0.0)
    files = {
        "act": ("actinic_uv.tsv", "actinic"),
        "blh": ("blue_light_hazard.tsv", "blue-light"),
        "ypf": ("rqe_ypf.tsv", "ypf"),
    }
    file = "bands.tsv" if len(kind) == 1 else "alpha_opic.tsv"
    x, y = column(*files.get(kind, (file, WEIGHTS[kind][0])))
    if kind == "act":
        return np.exp(np.interp(nm, x, np.log(y), left=-np.inf, right=-np.inf))
    return np.interp(nm, x, y, left=0, right=0)


@for_each([kind for kind in WEIGHTS if observer_of(kind) is None])
def test_each_weight_agrees_with_an_independent_quadrature(kind):
    """A smooth black body, by a fine midpoint rule of its own."""
    kelvin = 5000.0
    low, high = weight(kind).range
    edges = np.linspace(low, high, 200_001)
    nm = (edges[1:] + edges[:-1]) / 2
    metres = nm * 1e-9
    planck = 2 * math.pi * H * C**2 / metres**5 / np.expm1(H * C / 1.380649e-23 / kelvin / metres)
    counted = planck * (metres / (H * C) if weight(kind).acts_on == "p" else 1.0)
    expected = np.sum(counted * by_hand(kind, nm)) * (edges[1] - edges[0]) * 1e-9
    # the erythema is taken in steps of 0.5 nm, as in the tables of the sun
    off = {"ery": 2e-3, "act": 2e-3}.get(kind, 2e-5)
    off = 1e-3 if len(kind) == 1 else off  # tables with points between the nanometres
    assert count(spectrum(f"blackbody:{kelvin}K"), kind) == pytest.approx(expected, rel=off)


@for_each([kind for kind in WEIGHTS if observer_of(kind) is not None])
def test_the_lumens_of_each_observer_are_a_kind(kind):
    eye = OBSERVERS[WEIGHTS[kind][0]]
    nm = np.arange(eye.start, eye.end + 1, dtype=float)
    light = spectrum("D65")
    watts = np.interp(nm, light.grid, light.values, left=0, right=0)
    expected = eye.maximum * np.trapezoid(watts * np.array(eye.values), nm)
    assert count(light, kind) == pytest.approx(expected, rel=1e-9)
    assert resolve(f"lm_{kind}").dimension != resolve("lm").dimension


# ---------------------------------------------------------------------------------------------
# Kinds that never mix


@for_each(WEIGHTS)
def test_a_weight_is_one_place_of_one_slot_of_the_dimension(kind):
    place = [*WEIGHTS].index(kind)
    unit = {"e": "W", "v": "lm", "p": "mol"}[WEIGHTS[kind][1]]
    own, plain = resolve(f"{unit}_{kind}"), resolve(unit)
    assert own.dimension[:WEIGHT_AT] == plain.dimension[:WEIGHT_AT]
    assert weights_of(own.dimension) == {place: 1}
    assert weights_of(resolve(f"({unit}_{kind})-2").dimension) == {place: -2}
    assert (own.top, own.bottom) == (plain.top, plain.bottom)
    pair = ratio_of(ratio(kind, WEIGHTS[kind][1]))
    assert pair == (kind, WEIGHTS[kind][1])
    assert ratio_of(resolve(f"({ratio_unit(*pair)})").dimension) == pair


def test_no_two_quantities_of_two_kinds_share_a_dimension():
    found = {}
    for kind in (*"evp", *WEIGHTS):
        for geometry in ((0, 0, 0), (0, 0, 1), (0, 1, 0), (0, 1, 1), (1, 0, 0), (1, 1, 0)):
            from radcalc.quantities import light_dimension

            dimension = light_dimension(kind, geometry, "")
            assert place_of(dimension) == (kind, *geometry, "")
            assert found.setdefault(dimension, (kind, geometry)) == (kind, geometry)


UNMIXED = [("100 lx", "lx_mel"), ("100 lx_mel", "lx"), ("1 lm", "lm_scot"), ("5 W/m2", "W_ery/m2")]


@pytest.mark.parametrize(("amount", "target"), UNMIXED)
def test_a_weighted_quantity_does_not_convert_without_a_spectrum(amount, target):
    done = run("convert", *amount.split(), target)
    assert (done.returncode, done.stdout) == (2, "")
    assert "a wavelength, a spectrum or an efficacy is missing" in done.stderr
    with pytest.raises(RadcalcError):
        radcalc.convert(amount, target)


def test_a_weighted_quantity_does_not_add_in_python():
    edi, lux = radcalc.Quantity("250 lx_mel"), radcalc.Quantity("250 lx")
    with pytest.raises(Exception, match="melanopic"):
        edi + lux
    with pytest.raises(Exception, match="melanopic"):
        edi.to("lx")
    assert edi != lux
    assert (edi + radcalc.Quantity("1 EML")).to("lx_mel").magnitude == pytest.approx(250.9058)
    dark = radcalc.convert("2 W", "lm", wavelength="507nm", observer="scotopic")
    assert str(dark.units) == "scotopic_lumen"
    with pytest.raises(Exception, match="scotopic"):
        dark + radcalc.Quantity("50 lm")


def test_a_weighted_quantity_does_not_add_in_an_expression():
    done = run("convert", "100 lx + 100 lx_mel", "lx")
    assert (done.returncode, done.stdout) == (2, "")


def test_a_claim_in_lux_is_not_a_melanopic_edi():
    done = run("convert", *["100", "lx", "lx_mel", "--spectrum", "D65", "--check", "100lx"])
    assert done.returncode == 1
    assert "illuminance (lx) is not melanopic EDI" in done.stdout
    right = run("convert", *["100", "lx", "lx_mel", "--spectrum", "D65", "--check", "100lx_mel"])
    assert right.returncode == 0


def test_a_stream_has_the_kind_of_its_title():
    piped = run("convert", *["-", "lx_mel", "W_mel/m2"], input="1\n2\n")
    assert [float(x) for x in piped.stdout.split()] == pytest.approx(
        [1.32621e-3, 2.65241e-3], rel=1e-5
    )
    with_title = run("convert", *["-", "lx", "--header"], input="melanopic EDI [lx]\n100\n")
    assert (with_title.returncode, with_title.stdout) == (2, "")


# ---------------------------------------------------------------------------------------------
# Spectra that do not cover a weight


def test_a_spectrum_that_does_not_cover_a_weight_is_refused_with_what_is_missing():
    done = run("convert", *["100", "lx", "W_ery/m2", "--spectrum", "LED-B3"])
    assert done.returncode == 2
    assert "cover 380-780 nm, without 250-380 nm of the erythemal weight" in done.stderr
    assert "--dark-outside" in done.stderr
    dark = run("convert", *["100", "lx", "W_ery/m2", "--spectrum", "LED-B3", "--dark-outside"])
    assert dark.returncode == 0
    assert "LED-B3 is taken as dark outside its data" in dark.stderr
    unused = run("convert", *["100", "lx", "W/m2", "--spectrum", "LED-B3", "--dark-outside"])
    assert unused.returncode == 2


def test_the_sun_on_the_ground_is_dark_below_its_table_and_the_sun_in_space_is_not():
    assert run("spectrum", "AM1.5G", "-g", "uv-index").returncode == 0
    assert "250-280 nm" in run("spectrum", "AM0", "-g", "uv-index").stderr


# ---------------------------------------------------------------------------------------------
# Names, options, results

TARGETS = {
    "melanopic-edi": "lx_mel",
    "mel-edi": "lx_mel",
    "melanopic EDI": "lx_mel",
    "EML": "EML",
    "UVI": "UVI",
    "erythemal irradiance": "W_ery/m2",
    "blue-light": "W_blh/m2",
    "epar": "umol_epar/m2/s",
    "ypfd": "ypfd",
}


@for_each(TARGETS.items())
def test_a_target_has_a_name(name, unit):
    light = "blackbody:6000K"
    expected = number(f"convert 100 lx {unit} --spectrum {light}")
    done = run("convert", "100", "lx", name, "--spectrum", light)
    assert float(done.stdout.split()[0]) == expected


def test_the_radiance_of_the_blue_light_hazard():
    expected = number("convert 1e4 cd/m2 W_blh/m2/sr --spectrum D65")
    assert number("convert 1e4 cd/m2 blue-light --spectrum D65") == expected
    # IEC TR 62778: K_B,v of D65; the sum of the tables
    assert number("spectrum D65 -g blue-light-elr") == pytest.approx(0.9886, abs=5e-5)


def test_the_weight_of_an_option_is_the_kind_of_the_target():
    plain = number("convert 100 lx W/m2 --spectrum LED-B3 --weight melanopic")
    assert plain == number("convert 100 lx W_mel/m2 --spectrum LED-B3")
    assert number("convert 100 lx lx --spectrum LED-B3 --weight melanopic") == pytest.approx(
        63.257, abs=5e-4
    )
    unknown = run("convert", *["100", "lx", "W/m2", "--spectrum", "LED-B3", "--weight", "melanopc"])
    assert "unknown weight 'melanopc'" in unknown.stderr
    assert "--weight melanopic" in unknown.stderr


def test_a_calculator_has_the_results_of_a_weight():
    call = "point-source --intensity 100cd --distance 2m --spectrum D65 --weight melanopic"
    assert number(f"{call} -g melanopic-irradiance:lx_mel") == pytest.approx(25, rel=1e-12)
    assert number(f"{call} -g illuminance") == 25
    given = "point-source --intensity 1W_mel/sr --distance 2m"
    assert number(f"{given} -g irradiance") == 0.25


def test_an_observer_has_lumens_of_its_own():
    done = run("convert", *["2", "W", "lm", "--wavelength", "507nm", "--observer", "scotopic"])
    assert done.stdout == "3400.12\tlm_scot\n"
    assert number("convert 1 lm lm_scot --spectrum D65") == pytest.approx(2.4646, abs=5e-5)
    assert name_of(resolve("lx_scot")) == "scotopic illuminance"
    assert number("photon 507nm -g scotopic-luminous-efficacy") == 1700.06


def test_plant_bands():
    """Counts of ASTM G173-03 in each band, by trapezoids over its own points."""
    path = Path(__import__("pvlib").__file__).with_name("data") / "ASTMG173.csv"
    rows = np.array(list(csv.reader(path.read_text("utf-8").splitlines()))[2:], dtype=float)
    nm, watts = rows[:, 0], rows[:, 2]

    def band(low, high):
        inside = (nm >= low) & (nm <= high)
        return np.trapezoid((watts * nm)[inside], nm[inside]) * 1e-9 / (H * C * N_A) * 1e6

    for name, limits in (("epar", (400, 750)), ("far-red", (700, 800))):
        value = number(f"spectrum AM1.5G -g {name}-photon-irradiance")
        assert value == pytest.approx(band(*limits), rel=1e-4)
    red = number("spectrum AM1.5G -g r-fr-smith10")
    assert red == pytest.approx(band(655, 665) / band(725, 735), rel=1e-4)


def test_the_efficacy_of_two_weights_follows_from_a_spectrum():
    expected = number("convert 1 lx W_blh/m2 --spectrum D65") / number(
        "convert 1 lx lx_mel --spectrum D65"
    )
    assert number("convert 1 lx_mel W_blh/m2 --spectrum D65") == pytest.approx(expected, rel=1e-11)
    plain = plan(resolve("lx_mel"), resolve("EML"))
    assert plain.factor == pytest.approx(1 / 0.9058, rel=1e-15)


# ---------------------------------------------------------------------------------------------
# Bands of astronomy

# Willmer 2018, ApJS 236, 47: apparent magnitudes of the sun by Vega; its spectrum, its Vega and its
# bands differ from those here by a few hundredths.
OF_SUN = {"U": -25.97, "B": -26.13, "V": -26.76, "R": -27.15, "I": -27.47}


@pytest.mark.parametrize(("band", "expected"), OF_SUN.items())
def test_the_magnitudes_of_the_sun(band, expected):
    value = number(f"convert '1347.93 W/m2' '{band} mag' --spectrum AM0")
    assert value == pytest.approx(expected, abs=0.07)


# Pivot wavelengths [nm]: of Gaia by Riello et al. 2021, of the others by the sums of the tables,
# which are those of Willmer 2018 to 1 nm (V 547.8, B 437.8).
PIVOTS = {"G": 621.79, "V": 547.8, "B": 437.8}


@pytest.mark.parametrize(("band", "pivot"), PIVOTS.items())
def test_janskys_and_watts_per_nanometre_of_a_band(band, pivot):
    """A flat spectrum per frequency has c / pivot^2 times as much per wavelength."""
    flam = number(f"convert 1 Jy_{band} flam_{band}")
    assert flam == pytest.approx(1e-26 * C / (pivot * 1e-9) ** 2 * 1e-9, rel=4e-3)


def test_the_zero_points_of_magnitudes():
    """Oke and Gunn 1983: 3630.78 Jy is 0 mag in AB."""
    for band in ("U", "g", "G"):
        assert number(f"convert 0 '{band} AB mag' Jy_{band}") == pytest.approx(3630.78, rel=1e-6)
    # Vega in AB: Blanton and Roweis 2007; Gaia EDR3: 25.8010 - 25.6874
    assert number("convert 0 'B mag' 'B AB mag'") == pytest.approx(-0.09)
    assert number("convert 0 'z mag' 'z AB mag'") == pytest.approx(0.54)
    assert number("convert 0 'G mag' 'G AB mag'") == pytest.approx(25.8010 - 25.6874, abs=2e-4)
    # the zero point of Gaia in AB, in W/m2/nm: 3630.78 Jy at its pivot
    assert number("convert 0 'G AB mag' flam_G") == pytest.approx(2.8154e-11, rel=1e-3)


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        # 3944.573 Jy 10^-4, the zero point by Bessell's curve and -0.09 mag of Vega
        ("10|B mag|mJy", "radcalc convert 10 'B mag' mJy_B\n     394.457 mJy_B, the mean"),
        ("10|B mag|W/m2/nm", "radcalc convert 10 'B mag' flam_B\n"),
        ("3600|mJy|V mag", "radcalc convert 3600 mJy_V 'V mag'\n     7.48924 V mag, the mean"),
        ("1e-9|W/m2/nm|V mag", "radcalc convert 1e-9 flam_V 'V mag'\n"),
    ],
)
def test_a_magnitude_of_a_band_is_a_mean_density_not_one_at_a_wavelength(words, hint):
    """The hint made up a wavelength and a width: 10 B mag were 13196 Jy."""
    done = run("convert", *words.split("|"))
    assert done.returncode == 2
    assert hint in done.stderr


def test_a_magnitude_needs_a_spectrum_for_another_band():
    done = run("convert", "10", "V mag", "B mag")
    assert (done.returncode, done.stdout) == (2, "")
    assert run("convert", "10 V mag", "Jy_V").stdout == run("convert", "10", "V mag", "Jy_V").stdout


# ---------------------------------------------------------------------------------------------
# Files


def test_a_weight_from_a_file(tmp_path):
    path = tmp_path / "cry.csv"
    path.write_text("nm,action\n400,0\n500,1\n600,0\n")
    done = run("convert", *f"100 lx W/m2 --spectrum D65 --weight {path}".split())
    light = spectrum("D65")
    nm = np.arange(400, 601, dtype=float)
    weighted = np.interp(nm, light.grid, light.values) * np.interp(nm, [400, 500, 600], [0, 1, 0])
    lumens = light.lumens(OBSERVERS["photopic"])
    value, unit = done.stdout.split()
    assert unit == "W_cry/m2"
    assert float(value) == pytest.approx(100 * np.trapezoid(weighted, nm) / lumens, rel=1e-6)
    answer = radcalc.convert("100 lx", "W/m2", spectrum="D65", weight=str(path))
    assert answer.magnitude == pytest.approx(float(value))
    with pytest.raises(Exception, match="cry"):
        answer + radcalc.Quantity("1 W/m2")
    negative = tmp_path / "bad.csv"
    negative.write_text("nm,action\n400,0\n500,-1\n600,0\n")
    refused = run("convert", *f"100 lx W/m2 --spectrum D65 --weight {negative}".split())
    assert "line 3: a value of -1 is below 0" in refused.stderr


def test_a_filter_multiplies_the_spectrum(tmp_path):
    path = tmp_path / "yellow.csv"
    path.write_text("nm,transmittance (%)\n300,0\n500,0\n550,90\n1200,90\n")
    call = f"spectrum D65 --filter {path} -g luminous-efficacy"
    light = spectrum("D65")
    nm = np.arange(380, 781, dtype=float)
    watts = np.interp(nm, light.grid, light.values)
    watts *= np.interp(nm, [300, 500, 550, 1200], [0, 0, 0.9, 0.9])
    eye = OBSERVERS["photopic"]
    v = np.interp(nm, eye.start + np.arange(len(eye.values)), eye.values)
    expected = eye.maximum * np.trapezoid(watts * v, nm) / np.trapezoid(watts, nm)
    assert number(call) == pytest.approx(expected, rel=1e-4)
    twice = number(f"spectrum D65 --filter {path},{path} -g luminous-efficacy")
    assert twice != pytest.approx(expected, rel=1e-3)
    done = run("convert", *f"100 lx W/m2 --wavelength 555nm --filter {path}".split())
    assert "--filter does not apply without --spectrum" in done.stderr


def test_a_detector_from_a_file_and_its_spectral_mismatch(tmp_path):
    """pvlib's example of a silicon cell; its mismatch is that of IEC 60904-7."""
    pvlib = pytest.importorskip("pvlib")
    suns = pvlib.spectrum.get_reference_spectra()
    for grid in (None, suns.index):
        cell = pvlib.spectrum.get_example_spectral_response(grid)
        path = tmp_path / "cell.csv"
        rows = "".join(f"{nm},{s}\n" for nm, s in cell.items())
        path.write_text(f"wavelength (nm),responsivity (A/W)\n{rows}")
        expected = pvlib.spectrum.calc_spectral_mismatch_field(cell, suns["direct"], suns["global"])
        words = f"spectrum AM1.5D --response {path} --reference AM1.5G -g mismatch"
        assert number(words) == pytest.approx(expected, rel=1e-6)
    assert expected == pytest.approx(0.9989155, abs=5e-8)
    amperes = number(f"convert 1 W A --spectrum AM1.5G --response {path}")
    watts = np.trapezoid(suns["global"], suns.index)
    assert amperes == pytest.approx(
        np.trapezoid(suns["global"] * cell, suns.index) / watts, rel=1e-6
    )


SENTENCES = {
    "20000 cd at 8 m to melanopic EDI under D65": ("312.5", "lx_mel"),
    "20000 cd at 8 m to lx_mel under D65": ("312.5", "lx_mel"),
    "20000 cd at 8 m to melanopic under D65": ("0.414439297235", "W_mel/m2"),
    "100 lx to melanopic irradiance under D65": ("0.132620575115", "W_mel/m2"),
    "8 uvi in mW_ery/m2": ("200", "mW_ery/m2"),
}


@for_each(SENTENCES.items())
def test_a_sentence_has_the_kind_of_its_weight(sentence, answer):
    """312.5 lx of D65 are 312.5 lx of melanopic EDI, by 1.32621 mW/lm 0.41444 W/m2."""
    assert tuple(run(*sentence.split()).stdout.split()) == answer


def test_a_weight_of_definitions(tmp_path):
    (tmp_path / "cry.csv").write_text("nm,action\n400,0\n500,1\n600,0\n")
    own = tmp_path / "own.txt"
    own.write_text("weight cryptochrome = cry.csv\n")
    words = f"100 lx W_cryptochrome/m2 --spectrum D65 --definitions {own}"
    done = process("convert", *words.split())
    assert done.returncode == 0
    assert "own definition: cryptochrome = cry.csv" in done.stderr
    for line, said in {
        "weight melanopic = cry.csv": "'melanopic' is a name of radcalc",
        "weight foo = nowhere.csv": "there is no file 'nowhere.csv'",
        "weight F2 = cry.csv": "'F2' is not the name of a weight",
    }.items():
        own.write_text(line + "\n")
        refused = process("convert", *f"1 lx fc --definitions {own}".split())
        assert refused.returncode == 2
        assert said in refused.stderr


@pytest.mark.parametrize(
    ("title", "unit"),
    [
        ("mel EDI [lx]", "J_mel/m2"),
        ("melanopic-EDI [lx]", "J_mel/m2"),
        ("m-EDI [lx]", "J_mel/m2"),
        ("rhodopic EDI [lx]", "J_rh/m2"),
        ("E_ery [W/m2]", "J_ery/m2"),
        ("UV irradiance (erythemal) [W/m2]", "J_ery/m2"),
        ("ePAR [umol/m2/s]", "umol_epar/m2"),
        ("edition [lx]", "lx h"),
    ],
)
def test_a_title_of_a_weight_is_in_its_kind_however_it_is_spelt(title, unit, tmp_path):
    path = tmp_path / "log.csv"
    path.write_text(f"time [h],{title}\n0,100\n1,100\n", encoding="utf-8")
    assert run("dose", str(path), "-q").stdout.splitlines()[0].endswith(f"\t{unit}")


@pytest.mark.parametrize("unit", ["W_mel/m2/nm", "lx_mel/nm"])
def test_a_spectrum_that_is_weighed_already_is_refused(unit, tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text(f"nm,{unit}\n400,1\n500,2\n", encoding="utf-8")
    done = run("spectrum", str(path))
    assert done.returncode == 2
    assert "are not power or photons per wavelength" in done.stderr


def test_a_mismatch_counts_all_watts_of_a_named_spectrum(tmp_path):
    """Trapezoids of Planck's law of 2848 K from 300 nm to 830 nm gave 1.2176; 1.55 before."""
    cell, flat = tmp_path / "cell.csv", tmp_path / "flat.csv"
    cell.write_text("nm,A/W\n300,0.1\n900,0.6\n1100,0.05\n", encoding="utf-8")
    flat.write_text("nm,W/m2/nm\n300,1\n1100,1\n", encoding="utf-8")
    files = ("--response", str(cell), "--reference", str(flat))
    done = run("spectrum", "A", *files, "-g", "mismatch", "--dark-outside", "-q", "-n")
    nm = np.arange(300.0, 830.5, 0.5)
    light = nm**-5 / np.expm1(1.435e7 / (2848 * nm))  # CIE 15: illuminant A
    amperes_per_watt = np.sum(light * np.interp(nm, [300, 900], [0.1, 0.6])) / np.sum(light)
    of_flat = (0.35 * 600 + 0.325 * 200) / 800
    assert float(done.stdout) == pytest.approx(amperes_per_watt / of_flat, rel=1e-3)
