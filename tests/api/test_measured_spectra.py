"""Spectra from data frames, series and arrays, and hints that are calls with arrays."""

import numpy as np
import pandas as pd
import polars as pl
import pytest
from helpers import for_each

import radcalc
from radcalc import Quantity, RadcalcError

# Watts at equal steps, linear in between, and the constants of the SI.
GRID, WATTS = np.array([400.0, 500.0, 600.0, 700.0]), np.array([0.01, 0.02, 0.02, 0.01])
PLANCK, LIGHT, AVOGADRO = 6.62607015e-34, 299792458.0, 6.02214076e23
TITLES = "wavelength (nm)", "E (W/m2/nm)"
FRAME = {TITLES[0]: GRID, TITLES[1]: WATTS}
UNIT = {"unit": "W/m2/nm"}


def trapezoids(values, grid):
    return float(np.sum((values[1:] + values[:-1]) / 2 * np.diff(grid)))


@for_each(
    [
        ((GRID, WATTS), UNIT),
        ((GRID.tolist(), WATTS.tolist()), UNIT),
        ((Quantity(GRID / 1000, "um"), Quantity(WATTS, "W/m2/nm")), {}),
        (pd.DataFrame(FRAME), {}),
        (pd.DataFrame(FRAME).set_index(TITLES[0]), {}),
        (pd.DataFrame({TITLES[1]: WATTS}, index=GRID), {}),
        (pd.DataFrame({**FRAME, "other": 1.0}), {"column": TITLES[1]}),
        (pd.Series(WATTS, index=GRID, name=TITLES[1]), {}),
        (pd.Series(WATTS, index=GRID), UNIT),
        (pl.DataFrame(FRAME), {}),
    ]
)
def test_a_table_in_memory_is_a_spectrum(source, told):
    found = radcalc.spectrum(source, **told)
    assert found.irradiance.to("W/m2").magnitude == pytest.approx(trapezoids(WATTS, GRID))
    fine = np.linspace(400, 700, 300_001)
    photons = np.interp(fine, GRID, WATTS) * fine * 1e-9 / (PLANCK * LIGHT * AVOGADRO) * 1e6
    ppfd = found.photon_irradiance.to("umol/m2/s").magnitude
    assert ppfd == pytest.approx(trapezoids(photons, fine), rel=1e-9)


@for_each(
    [
        (GRID, WATTS),
        [GRID.tolist(), WATTS.tolist()],
        (Quantity(GRID / 1000, "um"), WATTS),
        pd.Series(WATTS, index=GRID),
        pd.DataFrame(FRAME).set_index(TITLES[0]),
    ]
)
def test_a_table_in_memory_is_the_spectrum_of_a_conversion(source):
    fine = np.linspace(400, 700, 300_001)
    watts = np.interp(fine, GRID, WATTS)
    photons = trapezoids(watts * fine, fine) * 1e-9 / (PLANCK * LIGHT * AVOGADRO) * 1e6
    efficacy = photons / trapezoids(WATTS, GRID)  # umol/J
    found = radcalc.convert([1.0, 2.0], "W/m2", "umol/m2/s", spectrum=source)
    assert found.magnitude == pytest.approx([efficacy, 2 * efficacy], rel=1e-9)
    assert radcalc.factor("W/m2", "umol/m2/s", spectrum=source) == pytest.approx(efficacy)
    explained = radcalc.explain("1 W/m2", "umol/m2/s", spectrum=source)
    assert explained.photon_irradiance.magnitude == pytest.approx(efficacy)
    assert float(radcalc.spectrum(source, reference=source).ssi) == 100


@for_each(
    [
        (5, "not of type int"),
        ((1, 2), "the shapes"),
        ((), "not of type tuple"),
        (WATTS, "not of type ndarray"),
        (pl.Series("E", WATTS), "not of type Series"),
        ((GRID, WATTS[:-1]), r"the shapes \(4,\) and \(3,\)"),
        ((GRID, [0.01, float("nan"), 0.02, 0.01]), "arrays, line 3: 'nan' is not a number"),
    ]
)
def test_what_is_not_a_spectrum_is_refused(source, said):
    with pytest.raises(RadcalcError, match=said) as caught:
        radcalc.spectrum(source, **UNIT)
    if "type" in said:
        assert 'radcalc.spectrum("D65")' in caught.value.hint


@for_each(
    [
        (lambda: radcalc.convert(300, "cd", "lx", distance=np.array([1.0, 2.0])), "an array with"),
        (lambda: radcalc.convert(np.array([np.pi]), "lx", "cd/m2"), "reflectance=RHO, or"),
        (lambda: radcalc.lambertian(flux=Quantity(np.ones(1), "lm"), radius="3cm"), "disc"),
    ]
)
def test_a_hint_for_arrays_names_keywords_and_shows_no_call(work_out, named):
    """No call with the user's array is made or shown."""
    with pytest.raises(RadcalcError) as caught:
        work_out()
    assert named in caught.value.hint
    assert "\n" not in caught.value.hint


def test_a_number_that_is_not_one_is_refused_with_the_call_that_keeps_it():
    with pytest.raises(RadcalcError) as caught:
        radcalc.convert(float("nan"), "lx", "fc")
    call = caught.value.hint.partition(", which")[0]
    kept = eval(call, {"radcalc": radcalc, "np": np})
    assert np.isnan(kept.magnitude).all()
