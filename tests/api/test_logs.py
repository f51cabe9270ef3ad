"""The dose of readings in memory and of files."""

import datetime as dt
from pathlib import Path

import numpy as np
import pandas as pd
import polars as pl
import pytest
from helpers import for_each

import radcalc
from radcalc.errors import RadcalcError

Q = radcalc.Quantity
STAMPS = ["2024-06-01T08:00", "2024-06-01T12:00", "2024-06-01T20:00"]
DATES = [dt.datetime.fromisoformat(stamp) for stamp in STAMPS]
VALUES = [0.0, 500.0, 0.0]  # two triangles: 250 umol/m2/s over 12 h are 10.8 mol/m2
UNIT = "umol/m2/s"
NAME = f"PPFD [{UNIT}]"
SERIES = pd.Series(VALUES, pd.DatetimeIndex(DATES), name=NAME)
HOURS = [0, 4, 12]

SAME = {
    "texts": lambda: radcalc.dose(VALUES, STAMPS, unit=UNIT),
    "datetimes": lambda: radcalc.dose(VALUES, DATES, unit=UNIT),
    "a series": lambda: radcalc.dose(SERIES),
    "two columns": lambda: radcalc.dose(SERIES.reset_index(drop=True), pd.Series(DATES)),
    "columns of polars": lambda: radcalc.dose(pl.Series(NAME, VALUES), pl.Series(DATES)),
    "a quantity": lambda: radcalc.dose(Q(VALUES, UNIT), Q(HOURS, "h")),
    "texts with units": lambda: radcalc.dose([f"{x} {UNIT}" for x in VALUES], Q(HOURS, "h")),
    "numbers": lambda: radcalc.dose(VALUES, HOURS, unit=UNIT, time_unit="h"),
    "arrays": lambda: radcalc.dose(np.array(VALUES), np.array(STAMPS, "M8[s]"), unit=UNIT),
    "timedeltas": lambda: radcalc.dose(VALUES, np.array(HOURS, "m8[h]"), unit=UNIT),
    "an index of timedeltas": lambda: radcalc.dose(
        pd.Series(VALUES, pd.to_timedelta(HOURS, unit="h"), name=NAME)
    ),
}


@for_each(SAME)
def test_readings_with_times_in_any_form_have_the_same_dose(form):
    found = SAME[form]()
    assert found.exposure.m_as("mol/m2") == pytest.approx(10.8)
    assert found.mean_irradiance.m_as(UNIT) == pytest.approx(250)


def test_a_file_has_the_dose_of_its_readings(tmp_path):
    path = tmp_path / "par.csv"
    SERIES.to_csv(path, index_label="time")
    for name in (path, str(path)):
        assert radcalc.dose(name).exposure.m_as("mol/m2") == pytest.approx(10.8)


def test_the_days_are_those_of_the_zone_of_the_index():
    """The clocks are put back on 27 October 2024, which has 25 h."""
    index = pd.date_range("2024-10-27", "2024-10-29", freq="30min", tz="Europe/Prague")
    days = radcalc.dose(pd.Series(100.0, index, name="E [lx]"), by="day")
    assert [day.exposure.m_as("lx h") for day in days.values()][:2] == pytest.approx([2500, 2400])
    assert [*days][:2] == ["2024-10-27", "2024-10-28"]


def test_the_inputs_of_light_and_a_check_are_those_of_other_functions():
    found = radcalc.dose(Q(VALUES, "W/m2"), Q(HOURS, "h"), receiver_area="2 m2")
    assert found.energy.m_as("Wh") == pytest.approx(6000)
    assert radcalc.check(found, "energy=6 kWh")


def test_readings_that_are_skipped_are_gaps_and_warned_of():
    values, times = [100.0, np.nan, 100.0, 100.0], [0, 1, 2, 3]
    with pytest.raises(RadcalcError, match="the log, reading 2: a value is missing") as caught:
        radcalc.dose(values, times, unit="lx", time_unit="h")
    assert "invalid=" in caught.value.hint
    with pytest.warns(UserWarning, match="reading 2") as warned:
        found = radcalc.dose(values, times, unit="lx", time_unit="h", invalid="warn")
    assert Path(warned[0].filename) == Path(__file__)
    assert found.exposure.m_as("lx h") == pytest.approx(100)
    assert found.gaps == 1


# A call, and what its refusal says.
REFUSED = [
    (lambda: radcalc.dose([1, 2]), "times of the readings are missing"),
    (lambda: radcalc.dose(pd.Series([1, 2], name="E [lx]")), "times of the readings are missing"),
    (lambda: radcalc.dose([1, 2], STAMPS, unit="lx"), "2 readings and 3 times"),
    (lambda: radcalc.dose(VALUES, STAMPS), "unit of the values is missing"),
    (lambda: radcalc.dose(VALUES, HOURS, unit="lx"), "unit of the times is missing"),
    (lambda: radcalc.dose(VALUES, STAMPS, unit="cd"), "neither an exposure nor an energy"),
    (lambda: radcalc.dose(Q(VALUES, "lx"), STAMPS, unit="lx"), "unit cannot be used"),
    (lambda: radcalc.dose(VALUES, STAMPS[::-1], unit="lx"), "is before 2024-06-01 20:00:00"),
    (lambda: radcalc.dose(VALUES, [*STAMPS[:2], "noon"], unit="lx"), "reading 3: 'noon'"),
    (lambda: radcalc.dose(VALUES, STAMPS, unit="lx", column="2"), "no columns to choose"),
    (lambda: radcalc.dose(VALUES, HOURS, unit="lx", time_unit="s", by="day"), "have no date"),
    (lambda: radcalc.dose(VALUES, STAMPS, unit="lx", by="week"), "unknown period"),
    (lambda: radcalc.dose(VALUES, STAMPS, unit="lx", samples="sums"), "unknown kind of samples"),
    (lambda: radcalc.dose(VALUES, STAMPS, unit="lx", invalid="fail"), "unknown treatment"),
    (lambda: radcalc.dose(VALUES, STAMPS, unit="lx", efficacy=["1 lm/W", "2 lm/W"]), "an array"),
    (lambda: radcalc.dose([1, np.nan, 2], STAMPS, unit="lx", by="day"), "a value is missing"),
    (lambda: radcalc.dose("absent.csv"), "cannot read absent.csv"),
    (lambda: radcalc.dose("absent.csv", STAMPS), "times do not apply to a file"),
    (lambda: radcalc.dose(SERIES.to_frame()), "not a sequence, but a DataFrame"),
    (lambda: radcalc.dose(np.zeros((2, 2)), HOURS, unit="lx"), "not a sequence"),
    (lambda: radcalc.dose(5, HOURS, unit="lx"), "not a sequence"),
]


@for_each(REFUSED)
def test_a_log_that_has_no_dose_is_refused(call, said):
    with pytest.raises(RadcalcError, match=said) as caught:
        call()
    assert caught.value.hint


def test_watts_of_par_need_their_range_beside_a_spectrum():
    """Photons of 550 nm have h c N_A / (550 nm) joules a mole (exact constants of the SI)."""
    log = pd.Series(
        [100.0, 100.0], ["2024-06-01 08:00", "2024-06-01 09:00"], name="PAR [W/m2]"
    )  # fmt: skip
    log.index = pd.DatetimeIndex(log.index)
    with pytest.raises(RadcalcError, match="counted from 400 nm to 700 nm") as caught:
        radcalc.dose(log, spectrum="line:550nm")
    assert 'range="400 nm:700nm"' in caught.value.hint
    found = radcalc.dose(log, spectrum="line:550nm", range="400 nm:700 nm")
    per_mole = 6.62607015e-34 * 299792458 * 6.02214076e23 / 550e-9
    assert found.photon_exposure.to("mol/m2").magnitude == pytest.approx(100 * 3600 / per_mole)
    assert radcalc.dose(log).exposure.to("J/m2").magnitude == pytest.approx(100 * 3600)


def test_two_meters_in_a_file_are_not_powers_of_a_unit(tmp_path):
    path = tmp_path / "two.csv"
    path.write_text("time,lux1,lux2\n2024-06-01 08:00,1,10\n2024-06-01 09:00,2,20\n")
    with pytest.raises(RadcalcError, match="2 columns of values"):
        radcalc.dose(path)
    found = radcalc.dose(path, column="lux2")
    assert found.exposure.to("lx h").magnitude == pytest.approx(15)


def test_series_are_joined_by_their_labels_or_refused():
    times = pd.Series(["2024-06-01 08:00", "2024-06-01 09:00"])
    values = pd.Series([1.0, 2.0], index=[1, 0], name="E [lx]")
    with pytest.raises(RadcalcError, match="other labels"):
        radcalc.dose(values, times)
    waves, powers = pd.Series([400, 500, 600]), pd.Series([1, 2, 5], index=[2, 1, 0])
    with pytest.raises(RadcalcError, match="other labels"):
        radcalc.spectrum((waves, powers), unit="W/m2/nm")


def test_masked_values_of_a_spectrum_are_refused():
    masked = np.ma.array([1.0, 2.0, 9999.0], mask=[0, 0, 1])
    for pair in (([400, 500, 600], masked), (masked, [1, 2, 3])):
        with pytest.raises(RadcalcError, match="masked"):
            radcalc.spectrum(pair, unit="W/m2/nm")


NOT_TEXTS = {
    "unit of a log": lambda: radcalc.dose([1], unit=5),
    "zone": lambda: radcalc.dose([1], time_zone=5),
    "unit of times": lambda: radcalc.dose([1], time_unit=5),
    "format of times": lambda: radcalc.dose([1], time_format=5),
    "unit of a spectrum": lambda: radcalc.spectrum(([400, 500], [1, 2]), unit=5),
    "sentence": lambda: radcalc.ask(None),
    "unit of an integrand": lambda: radcalc.integrate("cos(theta)", unit=5),
    "result to draw": lambda: radcalc.spectrum("D65").plot(1),
    "search": lambda: radcalc.examples(5),
    "value to look up": lambda: radcalc.typical(None),
    "target of a quantity": lambda: radcalc.Quantity(5, "lx").to(5),
    "path of a picture": lambda: radcalc.spectrum("D65").plot().save(5),
}


@pytest.mark.parametrize("name", NOT_TEXTS)
def test_what_is_not_a_text_is_refused_in_words(name):
    with pytest.raises(RadcalcError, match="is a text, not"):
        NOT_TEXTS[name]()


def test_a_truth_value_and_a_result_are_not_taken_for_others():
    with pytest.raises(RadcalcError, match="real numbers, not 'True'"):
        radcalc.convert(True, "lx", "fc")
    with pytest.raises(RadcalcError, match="not a source of light"):
        radcalc.convert("500 lx", "ppfd", spectrum=radcalc.spectrum("D65"))
    with pytest.raises(RadcalcError, match="the point is missing"):
        radcalc.uberlight(None, intensity="1 cd")
