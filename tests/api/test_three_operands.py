"""A conversion of a number, its unit and a target: convert(500, "lx", "fc")."""

import dask.array
import numpy
import pandas
import polars
import pytest
import xarray
from helpers import for_each

import radcalc
from radcalc.errors import RadcalcError

FC = 0.09290304  # fc in a lux: a square foot in m2, exactly


@for_each([500, 500.0, "500", numpy.float64(500)])
def test_a_number_has_the_unit_after_it(value):
    assert radcalc.convert(value, "lx", "fc").magnitude == pytest.approx(500 * FC, rel=1e-15)
    assert radcalc.convert(value, "lx", to="fc") == radcalc.convert("500 lx", "fc")
    found = radcalc.explain(value, "lx", "fc").illuminance.magnitude
    assert found == pytest.approx(500 * FC, rel=1e-15)


def test_arrays_and_columns_have_the_unit_after_them():
    numbers = [1.0, 500.0]
    right = [pytest.approx(number * FC, rel=1e-15) for number in numbers]
    array = numpy.array(numbers)
    assert list(radcalc.convert(array, "lx", "fc").magnitude) == right
    assert list(radcalc.convert(numbers, "lx", "fc").magnitude) == right
    waiting = radcalc.convert(dask.array.from_array(array), "lx", "fc")
    assert list(waiting.compute().magnitude) == right
    series = radcalc.convert(pandas.Series(numbers, name="E"), "lx", "fc")
    assert (series.name, list(series)) == ("E [fc]", right)
    assert list(radcalc.convert(pandas.Series(numbers), "lx", "fc")) == right
    assert list(radcalc.convert(polars.Series("E", numbers), "lx", "fc")) == right
    data = radcalc.convert(xarray.DataArray(numbers), "lx", "fc")
    assert (data.attrs["units"], list(data.values)) == ("fc", right)


def test_conditions_and_words_of_growers_and_scales():
    assert radcalc.convert(600, "ppfd", "dli", photoperiod="16h") == radcalc.convert(
        "600 ppfd", "dli", photoperiod="16h"
    )
    assert radcalc.convert(10, "dBm", "mW") == radcalc.convert("10 dBm", "mW")
    with pytest.raises(RadcalcError, match="is missing") as caught:
        radcalc.convert("500", "lx", "cd/m2")
    assert 'radcalc.convert("500", "lx", "cd/m2", reflectance="0.5")' in caught.value.hint


@for_each(["500 lx", radcalc.Quantity(500, "lx"), pandas.Series([1.0], name="E [fc]"),
           xarray.DataArray([1.0], attrs={"units": "lx"})])  # fmt: skip
def test_a_value_with_a_unit_takes_no_other(value):
    with pytest.raises(RadcalcError, match=r"has a unit|is in fc|has the unit"):
        radcalc.convert(value, "lx", "fc")


@for_each(
    [(500, "lxx", "fc"), ("a", "lx", "fc"), (numpy.array([1.0]), "dBm", "mW"), (500, 5, "fc")]
)
def test_other_operands_are_refused(value, unit, target):
    with pytest.raises(RadcalcError):
        radcalc.convert(value, unit, target)
