"""Pictures of spectra, against the tables of the CIE and Planck's law by hand."""

import math

import pytest

from radcalc.plots import LINES, REFERENCE
from radcalc.plots.curves import photon, spectra
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.sources import spectrum

DAY = OBSERVERS["photopic"]


def at(series, x):
    return dict(zip(series.x, series.y, strict=True))[x]


def test_a_relative_spectrum_is_over_its_peak_and_v_beside_it():
    chart = spectra([spectrum("D65")], DAY)
    own, eye = chart.series
    # CIE 15:2018, table of D65 at 10 nm: 117.81 at 460 nm is the most, 100 at 560 nm
    assert at(own, 560.0) == pytest.approx(100 / 117.81, rel=1e-4)
    # CIE 018:2019, V(lambda): 1 at 555 nm, 0.323 at 500 nm
    assert (at(eye, 555.0), at(eye, 500.0)) == (1.0, 0.323)
    assert eye.style == REFERENCE
    assert (chart.x.title, chart.y.title) == ("wavelength λ [nm]", "relative spectral power")


def test_a_black_body_is_in_its_unit_and_v_is_as_high():
    chart = spectra([spectrum("blackbody:5772K")], DAY)
    own, eye = chart.series
    x, y = own.x[100], own.y[100]
    assert x < 1000
    # c1 = 2 pi h c^2 and c2 = h c / k, CODATA 2018
    planck = 3.741771852e-16 / ((x * 1e-9) ** 5 * math.expm1(1.438776877e-2 / (x * 1e-9 * 5772)))
    assert y == pytest.approx(planck * 1e-9, rel=1e-8)  # of rounded constants
    assert chart.y.title == "spectral exitance [W/m2/nm]"
    assert max(eye.y) == pytest.approx(max(own.y))
    assert eye.label == "V(λ) CIE 1924, 1 at 8.24e+04 W/m2/nm"


def test_lines_are_upright_and_a_band_has_its_edges():
    line, band, _ = spectra([spectrum("line:632.8nm"), spectrum("band:500nm:600nm")], DAY).series
    assert (line.style, list(line.x), list(line.y)) == (LINES, [632.8], [1.0])
    assert list(zip(band.x, band.y, strict=True)) == [(500, 0), (500, 1), (600, 1), (600, 0)]


def test_a_range_cuts_what_is_drawn():
    chart = spectra([spectrum("D65")], DAY, (400.0, 500.0))
    assert (chart.series[0].x[0], chart.series[0].x[-1]) == (400.0, 500.0)
    assert chart.x.limits == (400.0, 500.0)


def test_a_wavelength_is_marked_below_both_eyes():
    chart = photon([("507nm", 507.0)], DAY)
    day, night = chart.series
    # CIE 018:2019: V'(507 nm) = 1, V(507 nm) between 0.4073 (505) and 0.5030 (510)
    assert at(night, 507.0) == 1.0
    assert 0.4073 < at(day, 507.0) < 0.503
    assert chart.marks == [("507nm", 507.0)]


def test_hues_are_those_of_a_screen():
    hues = {hue.place: hue[1:] for hue in spectra([spectrum("D65")], DAY).hues}
    # By hand, of the CIE 1931 observer at 600 nm, 1.0622, 0.6310, 0.0008 (CIE 15): the matrix of
    # IEC 61966-2-1 gives 2.472, 0.154 and below 0
    red = 3.2406 * 1.0622 - 1.5372 * 0.6310 - 0.4986 * 0.0008
    green = -0.9689 * 1.0622 + 1.8758 * 0.6310 + 0.0415 * 0.0008
    assert hues[600.0][0] == pytest.approx(1.0)
    assert hues[600.0][1] == pytest.approx(1.055 * (green / red) ** (1 / 2.4) - 0.055, abs=1e-3)
    assert hues[600.0][2] == 0.0
    assert (min(hues), max(hues)) == (380.0, 780.0)
    red, green, blue = hues[540.0]
    assert green == pytest.approx(1.0)
    assert red < 0.5
    assert blue == 0.0


def test_a_black_body_beside_a_lamp_ends_where_the_lamp_does():
    lamp, body, _ = spectra([spectrum("HPS"), spectrum("blackbody:2856K")], DAY).series
    assert (body.x[0], body.x[-1]) == pytest.approx((380, 780))  # CIE 15:2018: the table of HP1
    assert lamp.x[-1] == body.x[-1]


def test_an_infrared_spectrum_is_drawn_without_the_eye():
    """At 300 K the peak is at 9659 nm, by Wien's law (CODATA 2018: 2897.771955 um K)."""
    chart = spectra([spectrum("blackbody:300K")], DAY)
    (body,) = chart.series
    peak = body.x[body.y.index(max(body.y))]
    assert peak == pytest.approx(2897771.955 / 300, abs=body.x[1] - body.x[0])
