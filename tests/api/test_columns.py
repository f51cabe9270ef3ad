"""Columns of pandas, Polars and xarray: their units are read and their indexes kept."""

import numpy as np
import pandas as pd
import pint
import polars as pl
import pytest
import xarray as xr

import radcalc

Q = radcalc.Quantity
METRES = [1.0, 2.0, 5.0]
LUX = [100.0, 25.0, 4.0]  # of 100 cd, by the inverse square law
FC = [x * 0.3048**2 for x in LUX]  # lm/m2 and lm/ft2


def lamp(distance, **given):
    return radcalc.point_source(intensity="100 cd", distance=distance, **given)


def test_a_series_of_pandas_keeps_its_index_and_has_its_unit():
    distance = pd.Series(METRES, index=["a", "b", "c"], name="distance [m]")
    found = lamp(distance)
    pd.testing.assert_series_equal(
        found.illuminance, pd.Series(LUX, index=distance.index, name="illuminance [lx]")
    )
    pd.testing.assert_series_equal(found.distance, distance)
    assert found.intensity == Q(100, "cd")
    again = radcalc.convert(found.illuminance, "fc")
    assert again.name == "illuminance [fc]"
    np.testing.assert_allclose(again, FC)


def test_a_series_of_polars_keeps_its_kind_and_has_its_unit():
    found = lamp(pl.Series("d (cm)", [100.0, 200.0, 500.0])).illuminance
    assert isinstance(found, pl.Series)
    assert found.name == "illuminance [lx]"
    np.testing.assert_allclose(found.to_numpy(), LUX)
    assert radcalc.convert(found, "fc").name == "illuminance [fc]"
    wrapped = radcalc.convert(Q(pl.Series("E", LUX), "lx"), "fc")
    assert wrapped.name == "illuminance [fc]"
    np.testing.assert_allclose(wrapped.to_numpy(), FC)


def test_missing_values_stay_missing_in_a_conversion():
    found = radcalc.convert(pl.Series("E [lx]", [1076.391041671, None, float("nan")]), "fc")
    assert found.to_list()[:2] == [pytest.approx(100), None]  # 10.76391041671 lx = 1 fc
    assert np.isnan(found[2])
    found = radcalc.convert(pd.Series([1076.391041671, None], name="E [lx]"), "fc")
    assert found.isna().tolist() == [False, True]


@pytest.mark.parametrize("texts", [["1 m", None], [None, "1 m"], [float("nan"), "1 m"]])
def test_a_column_of_texts_with_a_missing_one_is_refused(texts):
    column = pd.Series(texts, dtype=object, name="d")
    for ask in (lambda: lamp(column), lambda: radcalc.convert(column, "ft")):
        with pytest.raises(radcalc.RadcalcError, match="missing values, 'd'"):
            ask()


@pytest.mark.parametrize(
    "values", [np.array(["2020-01-01"], "datetime64[ns]"), np.array([5], "timedelta64[s]"), [True]]
)
def test_a_value_that_is_not_a_number_is_not_taken_for_one(values):
    refusals = (radcalc.RadcalcError, pint.DimensionalityError)  # Pint raises it from 0.26 on
    for ask in (
        lambda: radcalc.convert(pd.Series(values, name="E [lx]"), "fc"),
        lambda: lamp(pd.Series(values, name="d [m]")),
        lambda: radcalc.convert(Q(np.asarray(values), "lx"), "fc"),
        lambda: lamp(Q(np.asarray(values), "m")),
    ):
        with pytest.raises(refusals, match=r"is not a number|takes real numbers|[Cc]annot convert"):
            ask()


def test_an_array_of_xarray_keeps_its_coordinates_and_its_units():
    told = xr.DataArray(METRES, dims="d", coords={"d": [10, 20, 30]}, attrs={"units": "m"})
    found = lamp(told).illuminance
    assert found.attrs == {"units": "lx"}
    assert found.d.values.tolist() == [10, 20, 30]
    np.testing.assert_allclose(found, LUX)
    wrapped = xr.DataArray(Q(np.array(METRES), "m"), dims="d", coords={"d": [10, 20, 30]})
    data = lamp(wrapped).illuminance.data
    assert data.units == Q(1, "lx").units
    assert radcalc.convert(lamp(wrapped).illuminance, "fc").data.m == pytest.approx(FC)


def _of_xarray(name, unit):
    return xr.DataArray([100.0], dims="x", name=name, attrs={"units": unit})


@pytest.mark.parametrize(
    ("column", "said"),
    [
        (_of_xarray("E [lx]", "fc"), "'E [lx]' is in lx, and in fc"),
        (_of_xarray("E [lx]", "klx"), "'E [lx]' is in lx, and in klx"),
        (_of_xarray("E_lx", "W/m2"), "'E_lx' is in lx, and in W/m2"),
        (_of_xarray("illuminance", "cd/m2"), "names illuminance, not luminance (cd/m2)"),
        (xr.DataArray(Q([1.0], "fc"), dims="x", name="E [lx]"), "'E [lx]' is in lx, and in "),
        (pd.Series([100.0], name="illuminance [W/m2]"), "names illuminance, not irradiance"),
        (pl.Series("PPFD [lx]", [100.0]), "names photon irradiance, not illuminance (lx)"),
    ],
)
def test_a_title_that_contradicts_its_unit_is_refused(column, said):
    with pytest.raises(radcalc.UnitError) as refused:
        radcalc.convert(column, "lx", efficacy="100 lm/W")
    assert said in str(refused.value)


@pytest.mark.parametrize(("name", "unit"), [("E [lx]", "lux"), ("E [lux]", "lm/m2"), ("E", "lx")])
def test_a_title_and_a_separate_unit_that_agree_are_accepted(name, unit):
    assert radcalc.convert(_of_xarray(name, unit), "klx").item() == pytest.approx(0.1)


def test_arrays_of_xarray_are_broadcast_by_dimension_names():
    distance = xr.DataArray(METRES, dims="d", attrs={"units": "m"})
    intensity = xr.DataArray([100.0, 200.0], dims="lamp", attrs={"units": "cd"})
    found = radcalc.point_source(intensity=intensity, distance=distance).illuminance
    assert dict(found.sizes) == {"lamp": 2, "d": 3}
    np.testing.assert_allclose(found.sel(lamp=1), np.multiply(LUX, 2))


def test_several_series_belong_to_one_table():
    table = pd.DataFrame({"I [cd]": [100.0, 50.0], "d [m]": [1.0, 5.0]}, index=[7, 9])
    found = radcalc.point_source(intensity=table["I [cd]"], distance=table["d [m]"])
    assert found.illuminance.to_dict() == {7: 100.0, 9: 2.0}
    other = table["d [m]"].sort_index(ascending=False)
    with pytest.raises(radcalc.ConditionError, match="have other rows"):
        radcalc.point_source(intensity=table["I [cd]"], distance=other)


def test_texts_in_a_column_carry_their_own_units():
    found = lamp(pd.Series(["1 m", "200 cm", "5 m"], name="distance")).illuminance
    np.testing.assert_allclose(found, LUX)


def test_a_number_needs_no_unit():
    found = radcalc.lambertian(incident_irradiance="100 lx", reflectance=pd.Series([0.5, 1.0]))
    np.testing.assert_allclose(found.exitance, [50, 100])
    share = radcalc.convert(pd.Series([0.5], index=["a"], name="share"), "%")
    assert share.to_dict() == {"a": 50.0}


def test_a_column_is_converted_to_readings_on_a_scale_and_to_another_quantity():
    power = pd.Series([1.0, 100.0], index=[3, 4], name="P [mW]")
    assert radcalc.convert(power, "dBm").to_dict() == {3: 0.0, 4: 20.0}
    lux = pd.Series([54.0], name="E [lx]")
    # lb(54 / 2.5) = 4.43296; 54 cd at 2 m are 13.5 lx, lb 5.4 = 2.43296
    for light, name in ((lux, "E [EV]"), (lux.rename("L [cd/m2]"), "L [EV]")):
        assert radcalc.convert(light, "EV").name == name
    assert radcalc.convert(lux, "EV").tolist() == pytest.approx([4.43296], rel=1e-6)
    candela = radcalc.convert(lux.rename("I [cd]"), "EV", distance="2 m")
    assert (candela.name, candela.tolist()) == ("illuminance [EV]", pytest.approx([2.43296]))
    assert radcalc.convert(pl.Series("E [lx]", [54.0]), "mag").name == "E [mag]"
    ppfd = radcalc.convert(lux, "umol/m2/s", efficacy="54 lm s/umol")
    assert ppfd.name == "photon_irradiance [umol/m2/s]"
    assert ppfd.tolist() == pytest.approx([1.0])


@pytest.mark.parametrize("unit", ["EV", "mag"])
def test_an_array_of_xarray_keeps_its_unit_on_a_scale(unit):
    lux = xr.DataArray([54.0, 108.0], dims="t", attrs={"units": "lx"}, name="E")
    for light in (lux, xr.DataArray(radcalc.Quantity([54.0, 108.0], "lx"), dims="t")):
        found = radcalc.convert(light, unit)
        assert (found.name, found.attrs) == ("illuminance", {"units": unit})
        np.testing.assert_allclose(found.data[1], radcalc.convert("108 lx", unit))


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (lambda: lamp(pd.Series(METRES)), "distance is a column without a unit"),
        (lambda: lamp(pd.Series(METRES, name="d")), "distance is a column without a unit: 'd'"),
        (lambda: lamp(pl.Series("d", METRES)), "distance is a column without a unit: 'd'"),
        (lambda: lamp(xr.DataArray(METRES)), "distance is a column without a unit"),
        (lambda: lamp(pd.Series([1.0, None], name="d [m]")), "missing values"),
        (lambda: lamp(pl.Series("d [m]", [1.0, None])), "missing values"),
        (lambda: lamp(pd.Series([True, "x"], name="d [m]")), "with a value that is not a number"),
        (lambda: lamp(pd.DataFrame({"d [m]": METRES})), "distance is a DataFrame of pandas"),
        (lambda: lamp(pd.Index(METRES, name="d [m]")), "distance is an Index of pandas"),
        (lambda: lamp(pl.DataFrame({"d [m]": METRES})), "distance is a DataFrame of polars"),
        (lambda: radcalc.convert(pd.DataFrame({"E": METRES}), "lx", "fc"), "value is a DataFrame"),
        (lambda: lamp(pd.Series(METRES, name="E [lx]")), "takes a length, not illuminance"),
        (lambda: lamp(pd.Series(METRES, name="P [dBm]")), "readings on a scale"),
        (
            lambda: radcalc.point_source(
                intensity=pl.Series("I [cd]", METRES), distance=pd.Series(METRES, name="d [m]")
            ),
            "two libraries",
        ),
        (
            lambda: lamp(
                xr.DataArray(METRES, dims="d", coords={"d": [1, 2, 3]}, attrs={"units": "m"}),
                incidence=xr.DataArray(
                    METRES, dims="d", coords={"d": [1, 2, 4]}, attrs={"units": "deg"}
                ),
            ),
            "have other coordinates",
        ),
        (
            lambda: radcalc.point_source(
                intensity=Q(np.ones((2, 3)), "cd"), distance=pd.Series(METRES, name="d [m]")
            ),
            "and the columns another",
        ),
        (lambda: radcalc.uberlight(pd.DataFrame(np.ones((2, 3))), intensity="1 cd"), "DataFrame"),
        (
            lambda: radcalc.environment(xr.DataArray(np.ones((4, 8))), unit="cd/m2"),
            "the map is a DataArray of xarray",
        ),
        (
            lambda: radcalc.explain(pd.Series([1.0], name="E [lx]"), "fc"), "single values"),
        (
            lambda: radcalc.factor("cd", "lx", distance=pd.Series(METRES, name="d [m]")),
            "distance",
        ),
    ],
)  # fmt: skip
def test_a_column_without_a_unit_or_whose_names_would_be_lost_is_refused_with_a_hint(ask, said):
    with pytest.raises(radcalc.RadcalcError, match=said) as caught:
        ask()
    assert caught.value.hint


def test_a_list_or_column_of_texts_is_converted_in_the_unit_of_the_first():
    """A footcandle is 1/0.3048^2 lx."""
    found = radcalc.convert(["1 lx", "2 fc", Q(5, "klx")], "lx")
    np.testing.assert_allclose(found.to("lx").magnitude, [1, 2 / 0.3048**2, 5000])
    texts = pd.Series(["1 lx", "2 lx"], name="E", index=["a", "b"])
    given = radcalc.convert(texts, "klx")
    pd.testing.assert_series_equal(
        given, pd.Series([0.001, 0.002], name="illuminance [klx]", index=["a", "b"])
    )
    # I/d^2, each element with its own distance
    lit = radcalc.convert(["100 cd", "400 cd"], "lx", distance=["1 m", "2 m"])
    np.testing.assert_allclose(lit.magnitude, [100, 100])


@pytest.mark.parametrize(
    ("value", "said"),
    [
        (["1 lx", "2 cd"], "a list mixes quantities: illuminance (lx) and luminous intensity (cd)"),
        (["1 lx", 2], "a list mixes quantities"),
        (["10 dBm", "1 mW"], "a list has readings on a scale"),
        (["1+-0.1 lx", "2 lx"], "a list has an uncertain value"),
        (["1 lx", "2 lux of"], "unknown unit 'of'"),
        (100, "the unit of the value is missing: the target is illuminance (klx)"),
        (pd.Series([1.0], name="E"), "the unit of the value is missing"),
    ],
)
def test_a_list_without_a_common_quantity_and_unit_is_refused(value, said):
    with pytest.raises(radcalc.RadcalcError) as refused:
        radcalc.convert(value, "klx")
    assert said in str(refused.value)
