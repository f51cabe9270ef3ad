"""Columns of pandas, Polars and xarray: taken with the unit that they tell, and given back.

A column has its unit in its name (`distance [m]`), as the columns of files have; one of xarray also
in its attribute `units`, or in its data, which may be a quantity.  A result that depends on columns
is one like them: of the same index or coordinates, and with its unit told in the same way.
"""

from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import Any, NamedTuple

import numpy

from radcalc.api.quantity import is_lazy, is_quantity, magnitude_of, quantity, unit_of
from radcalc.api.reading import LIBRARIES, gathered, library_of, refuse_column
from radcalc.api.spelling import symbol_name
from radcalc.errors import ConditionError, UnitError, option, quote
from radcalc.quantities.symbols import QUANTITY, SYMBOLS
from radcalc.quantities.titles import is_same, read_title, refuse_misnamed
from radcalc.units.ranges import floats
from radcalc.units.table import NUMBER, Unit, resolve

PANDAS, POLARS, XARRAY = LIBRARIES
COLUMNS = {PANDAS: "Series", POLARS: "Series", XARRAY: "DataArray"}
UNITS = "units"  # the attribute of xarray's arrays, by the CF conventions


class Columns(NamedTuple):
    """The columns that were given to a function, by the first of them.

    With `quantities` the data of xarray's arrays are quantities; else their units stand apart.
    """

    library: str
    like: Any
    quantities: bool = False

    def result(self, name: str, value: Any, title: str = "") -> Any:
        """A result, or readings on a scale, as a column; what depends on none as it is."""
        magnitude = magnitude_of(value)
        if not numpy.ndim(magnitude):
            return value
        if numpy.shape(magnitude) != self.like.shape:
            problem = f"{name} has the shape {numpy.shape(magnitude)}, and the columns another"
            raise ConditionError(problem, "radcalc.Quantity(column.to_numpy(), UNIT)")
        unit = unit_of(value).text if is_quantity(value) else ""
        if self.library == XARRAY:
            made = self.like.copy(data=value if self.quantities else magnitude)
            made.attrs = {} if self.quantities or not unit else {UNITS: unit}
            return made.rename(name)
        title = title or (f"{name} [{unit}]" if unit not in ("", "1") else name)
        if self.library == POLARS:
            made = type(self.like)(title, magnitude)
            missing = self.like.is_null()  # a null is no NaN there
            return made.set(missing, None) if missing.any() else made
        return type(self.like)(magnitude, index=self.like.index, name=title)


def taken(given: Mapping[str, Any]) -> tuple[Columns | None, dict[str, Any]]:
    """What was given with the columns as arrays in their units, and what they are like."""
    found = {key: one for key, one in given.items() if library_of(magnitude_of(one))}
    if not found:
        return None, dict(given)
    for key, one in found.items():
        column = magnitude_of(one)
        symbol = SYMBOLS.get(symbol_name(key))
        if type(column).__name__ != COLUMNS[library_of(column)] or (
            key != "value" and (symbol is None or symbol.form != QUANTITY)
        ):
            refuse_column(column, key)
    units = {key: _unit_of(key, one) for key, one in found.items()}
    each = _aligned(found)
    first = each[0]
    like = Columns(library_of(first), first, library_of(first) == XARRAY and _is_quantity(first))
    arrays = {
        key: _array(key, column, unit)
        for (key, unit), column in zip(units.items(), each, strict=True)
    }
    return like, {**given, **arrays}


def _is_quantity(column: Any) -> bool:
    return is_quantity(column.data)


def _unit_of(key: str, given: Any) -> Unit | None:
    """The unit that a column tells; None for bare numbers."""
    column = magnitude_of(given)
    if told := _told_unit(given):
        _refuse_other(column, told)
        return told
    name = symbol_name(key)
    like = resolve(SYMBOLS[name].unit) if name in SYMBOLS and SYMBOLS[name].unit else None
    unit = read_title(str(column.name), like).unit if column.name is not None else None
    if unit and unit.is_scale:
        problem = f"the column '{quote(str(column.name))}' has readings on a scale"
        raise ConditionError(problem, "what they stand for, in a unit")
    if unit is None and name in SYMBOLS and NUMBER not in SYMBOLS[name].dimensions:
        if _is_text(column):
            return None
        likely = f"{key} [{SYMBOLS[name].unit}]"
        problem = f"{option(name)} is a column without a unit, '{quote(str(column.name))}'"
        way = f'.rename("{likely}"), or radcalc.Quantity(column.to_numpy(), "{SYMBOLS[name].unit}")'
        raise ConditionError(problem, way)
    return unit


def _told_unit(given: Any) -> Unit | None:
    """The unit that stands beside the title of a column."""
    column = magnitude_of(given)
    if column is not given:
        return unit_of(given)
    if library_of(column) != XARRAY:
        return None
    if _is_quantity(column):
        return unit_of(column.data)
    return resolve(str(column.attrs[UNITS])) if UNITS in column.attrs else None


def _refuse_other(column: Any, unit: Unit) -> None:
    """Refuse a column whose title has another unit than stands beside it, or another quantity."""
    if column.name is None:
        return
    title = read_title(str(column.name), unit)
    if title.unit and not is_same(title.unit, unit):
        own = quote(title.unit.text)
        problem = f"the column '{quote(title.text)}' is in {own}, and in {quote(unit.text)}"
        raise UnitError(f"{problem} by its units", "one of them")
    refuse_misnamed(title, unit)


def _is_text(column: Any) -> bool:
    if getattr(column.dtype, "kind", "O") not in "OTU":
        return False
    return any(isinstance(one, str) for one in column.to_numpy().flat)


def _aligned(found: Mapping[str, Any]) -> Sequence[Any]:
    """The columns with the same rows, or with all of their dimensions."""
    each = [magnitude_of(one) for one in found.values()]
    first, *others = each
    library = library_of(first)
    names = " and ".join(found)
    if any(library_of(one) != library for one in others):
        raise ConditionError(f"{names} are columns of two libraries", "columns of one")
    if library == XARRAY:
        xarray: Any = import_module(XARRAY)
        try:
            return list(xarray.broadcast(*xarray.align(*each, join="exact")))
        except ValueError:
            problem = f"{names} have other coordinates"
            raise ConditionError(problem, "xarray.align before the call") from None
    for one in others:
        if len(one) != len(first) or (library == PANDAS and not one.index.equals(first.index)):
            raise ConditionError(f"{names} have other rows", "columns of one table")
    return each


def _array(key: str, column: Any, unit: Unit | None) -> Any:
    """The values of a column, with their unit."""
    if unit is None and _is_text(column):
        texts = column.to_numpy().tolist()
        if not all(isinstance(one, str) for one in texts):
            _refuse_missing(key, column)
        return gathered(key, texts)
    values = column.data if library_of(column) == XARRAY else column.to_numpy()
    values = magnitude_of(values)
    if not is_lazy(values):
        try:
            values = floats(values)
        except (TypeError, ValueError):
            problem = f"{key} is a column with what is no number, '{quote(str(column.name))}'"
            raise ConditionError(problem, "a column of numbers") from None
        if key != "value" and numpy.isnan(values).any():
            _refuse_missing(key, column)
    return values if unit is None else quantity(values, unit)


def _refuse_missing(key: str, column: Any) -> None:
    problem = f"{key} is a column with missing values, '{quote(str(column.name))}'"
    raise ConditionError(problem, "the rows that have one: .dropna(), or .drop_nulls()")


def of_conversion(like: Columns, value: Any, target: Unit, name: str) -> Any:
    """What a column is converted to: by its own name, if it stays the same quantity."""
    own = str(like.like.name) if like.like.name is not None else ""
    title = read_title(own) if own and like.library != XARRAY else None
    if title and title.unit and title.unit.dimension == target.dimension:
        return like.result(name, value, title.with_unit(target.text))
    return like.result(name, value, f"{name} [{target.text}]")
