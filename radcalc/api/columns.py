"""Types of keywords in signatures, and columns of pandas, Polars and xarray, arrays of Dask.

A keyword of None is not given.  An `Amount` is a text with its unit, such as "2 m", a `Quantity`,
whose magnitude may be an array, a list of these, or a column with its unit.  A `Number` may be
bare.

A column has its unit in its name (`distance [m]`); one of xarray also in its attribute `units`, or
in its data, which may be a quantity.  A result that depends on columns is a column of the same
index or coordinates, with its unit in the same place.

With arrays of Dask a calculation is deferred, and done block by block.  A calculator needs values,
so it runs first on arrays without elements, which show the results, their units and their axes, and
later on each block, where invalid values raise errors.
"""

from collections.abc import Callable, Mapping, Sequence
from datetime import date
from importlib import import_module
from os import PathLike
from typing import Any, Literal, NamedTuple, Protocol, TypeAlias

import numpy
from numpy.typing import NDArray

from radcalc.api import arguments
from radcalc.api.arguments import Quantity, gathered, is_lazy, magnitude_of, symbol_name, unit_of
from radcalc.api.result import Result, all_of, in_python, waiting
from radcalc.errors import ConditionError, UnitError, option, quote
from radcalc.maths import is_column
from radcalc.quantities.column_titles import is_same, read_title, refuse_misnamed
from radcalc.quantities.symbols import QUANTITY, SPECTRUM, SYMBOLS
from radcalc.units import NUMBER, Unit
from radcalc.units.ranges import floats
from radcalc.units.table import resolve

Array: TypeAlias = NDArray[Any]


class Column(Protocol):
    """A column of pandas, Polars or xarray."""

    @property
    def name(self) -> Any:
        """Its title."""

    def to_numpy(self) -> Any:
        """Its values alone."""


# A signature shows the names of these unions.
Amount: TypeAlias = str | Quantity | Sequence[str] | Sequence[Quantity] | Column | None
Unnamed: TypeAlias = str | Quantity | Sequence[str] | Sequence[Quantity]  # without a keyword
Number: TypeAlias = Amount | float | Sequence[float] | Array
Direction: TypeAlias = str | Quantity | Sequence[Quantity] | Sequence[float] | Array | None
Vector: TypeAlias = str | Sequence[float] | Array | None
Points: TypeAlias = str | Quantity | Sequence[float] | Sequence[Sequence[float]] | Array
Interval: TypeAlias = str | tuple[str, str] | tuple[Quantity, Quantity] | None
Numbers: TypeAlias = str | Sequence[float] | Array | None
Scalar: TypeAlias = str | Quantity | float
Pair: TypeAlias = str | Sequence[int] | None
Text: TypeAlias = str | None
Path: TypeAlias = str | PathLike[str]
Spectrum: TypeAlias = Path | Any  # a name, a file, arrays, a series or a data frame
Distribution: TypeAlias = Any  # a name, a file, an expression, or an object with its methods
Surroundings: TypeAlias = Path | Quantity | Array | Any
Diffuse: TypeAlias = Literal["patch", "disc", "sphere", "rectangle", "plane", "hemisphere"]
Shape: TypeAlias = Literal[
    "full",
    "hemisphere",
    "cone",
    "cap",
    "zone",
    "band",
    "sphere",
    "disc",
    "rectangle",
    "pyramid",
    "patch",
    "polygon",
    "triangle",
    "pixel",
]
Sky: TypeAlias = Literal["overcast", "uniform", "intermediate", "clear", "turbid"] | int | str
Projection: TypeAlias = Literal[
    "latlong",
    "mirror-ball",
    "angular",
    "fisheye",
    "equisolid",
    "orthographic",
    "stereographic",
    "perspective",
    "cylindrical",
]
Observer: TypeAlias = Literal[
    "photopic", "scotopic", "cie1964", "judd-vos", "cie2008-2", "cie2008-10"
]
Profile: TypeAlias = Literal["gaussian", "uniform"]
ElectricField: TypeAlias = Literal["peak", "rms"]
Readings: TypeAlias = Path | Quantity | Column | Sequence[str] | Sequence[float] | Array
Times: TypeAlias = (
    Quantity | Column | Sequence[str] | Sequence[date] | Sequence[float] | Array | None
)
Samples: TypeAlias = Literal["points", "means", "means-before", "means-centred"]
Invalid: TypeAlias = Literal["abort", "warn", "ignore"]
Period: TypeAlias = Literal["day", "hour"]


PANDAS, POLARS, XARRAY = arguments.LIBRARIES
COLUMNS = {PANDAS: "Series", POLARS: "Series", XARRAY: "DataArray"}
UNITS = "units"  # the attribute of xarray arrays in the CF conventions


class Columns(NamedTuple):
    """The columns given to a function; the first one is the model of the results.

    With `quantities` the data of xarray arrays are quantities; otherwise units are attributes.
    """

    library: str
    like: Any
    quantities: bool = False

    def result(self, name: str, value: Any, title: str = "", scale: str = "") -> Any:
        """Return a result, or readings on a scale, as a column if it depends on columns."""
        magnitude = arguments.magnitude_of(value)
        if not numpy.ndim(magnitude):
            return value
        if numpy.shape(magnitude) != self.like.shape:
            problem = f"{name} has the shape {numpy.shape(magnitude)}, and the columns another"
            raise ConditionError(problem, "radcalc.Quantity(column.to_numpy(), UNIT)")
        is_quantity = arguments.is_quantity(value)
        unit = arguments.unit_of(value).text if is_quantity else scale
        if self.library == XARRAY:
            column = self.like.copy(data=value if self.quantities else magnitude)
            column.attrs = {UNITS: unit} if unit and not (self.quantities and is_quantity) else {}
            return column.rename(name)
        title = title or (f"{name} [{unit}]" if unit not in ("", "1") else name)
        if self.library == POLARS:
            column = type(self.like)(title, magnitude)
            missing = self.like.is_null()  # a null is not a NaN there
            return column.set(missing, None) if missing.any() else column
        return type(self.like)(magnitude, index=self.like.index, name=title)


def take_columns(given: Mapping[str, Any]) -> tuple[Columns | None, dict[str, Any]]:
    """Return the columns among the arguments, and the arguments with arrays instead of columns."""
    columns = {
        key: value
        for key, value in given.items()
        if arguments.library_of(arguments.magnitude_of(value)) and not is_spectrum(key)
    }
    if not columns:
        return None, dict(given)
    for key, value in columns.items():
        column = arguments.magnitude_of(value)
        symbol = SYMBOLS.get(symbol_name(key))
        if type(column).__name__ != COLUMNS[arguments.library_of(column)] or (
            key != "value" and (symbol is None or symbol.form != QUANTITY)
        ):
            arguments.refuse_column(column, key)
    units = {key: _unit_of(key, value) for key, value in columns.items()}
    aligned = _aligned(columns)
    first = aligned[0]
    pattern = Columns(
        arguments.library_of(first),
        first,
        arguments.library_of(first) == XARRAY and arguments.is_quantity(first.data),
    )
    arrays = {
        key: _array(key, column, unit)
        for (key, unit), column in zip(units.items(), aligned, strict=True)
    }
    return pattern, {**given, **arrays}


def is_spectrum(key: str) -> bool:
    """Return whether an argument is a spectrum, which may be a whole table."""
    symbol = SYMBOLS.get(symbol_name(key))
    return symbol is not None and symbol.form == SPECTRUM


def _unit_of(key: str, given: Any) -> Unit | None:
    """Return the unit of a column, by its attributes or its title; refuse one without a unit."""
    column = arguments.magnitude_of(given)
    if stated := _stated_unit(given):
        _refuse_other(column, stated)
        return stated
    name = symbol_name(key)
    usual_unit = resolve(SYMBOLS[name].unit) if name in SYMBOLS and SYMBOLS[name].unit else None
    unit = read_title(str(column.name), usual_unit).unit if column.name is not None else None
    if unit and unit.is_scale:
        problem = f"the column '{quote(str(column.name))}' has readings on a scale"
        raise ConditionError(problem, "what they stand for, in a unit")
    if unit is None and name in SYMBOLS and NUMBER not in SYMBOLS[name].dimensions:
        if _is_text(column):
            return None
        likely = f"{key} [{SYMBOLS[name].unit}]"
        problem = f"{option(name)} is a column without a unit: '{quote(str(column.name))}'"
        hint = (
            f'.rename("{likely}"), or radcalc.Quantity(column.to_numpy(), "{SYMBOLS[name].unit}")'
        )
        raise ConditionError(problem, hint)
    return unit


def _stated_unit(given: Any) -> Unit | None:
    """Return the unit of a column that is not in its title."""
    column = arguments.magnitude_of(given)
    if column is not given:
        return arguments.unit_of(given)
    if arguments.library_of(column) != XARRAY:
        return None
    if arguments.is_quantity(column.data):
        return arguments.unit_of(column.data)
    return resolve(str(column.attrs[UNITS])) if UNITS in column.attrs else None


def with_unit(column: Any, unit: Unit) -> Any:
    """Return a column without a unit in a unit; raise UnitError if it has another one."""
    if type(column).__name__ != COLUMNS[arguments.library_of(column)]:
        arguments.refuse_column(column, "the value")
    if stated := _stated_unit(column):
        problem = f"the column has the unit {quote(stated.text)}, and '{quote(unit.text)}' too"
        raise UnitError(problem, "only one of them")
    if arguments.library_of(column) == XARRAY:
        return column.assign_attrs({UNITS: unit.text})
    name = "value" if column.name in (None, "") else str(column.name)
    _refuse_other(column, unit)
    titled = read_title(name, unit).unit
    return column if titled else column.rename(f"{name} [{unit.text}]")


def _refuse_other(column: Any, unit: Unit) -> None:
    """Refuse a column whose title disagrees with its unit, or names another quantity."""
    if column.name is None:
        return
    title = read_title(str(column.name), unit)
    if title.unit and not is_same(title.unit, unit):
        titled = quote(title.unit.text)
        problem = f"the column '{quote(title.text)}' is in {titled}, and in {quote(unit.text)}"
        raise UnitError(f"{problem} by its units", "only one of them")
    refuse_misnamed(title, unit)


def _is_text(column: Any) -> bool:
    if getattr(column.dtype, "kind", "O") not in "OTU":
        return False
    return any(isinstance(element, str) for element in column.to_numpy().flat)


def _aligned(given: Mapping[str, Any]) -> Sequence[Any]:
    """Return the columns with the same rows, or with all of their dimensions."""
    columns = [arguments.magnitude_of(column) for column in given.values()]
    first, *others = columns
    library = arguments.library_of(first)
    names = " and ".join(given)
    if any(arguments.library_of(column) != library for column in others):
        raise ConditionError(f"{names} are columns of two libraries", "columns of one")
    if library == XARRAY:
        xarray: Any = import_module(XARRAY)
        try:
            return list(xarray.broadcast(*xarray.align(*columns, join="exact")))
        except ValueError:
            problem = f"{names} have other coordinates"
            raise ConditionError(problem, "xarray.align before the call") from None
    for column in others:
        if len(column) != len(first) or (
            library == PANDAS and not column.index.equals(first.index)
        ):
            raise ConditionError(f"{names} have other rows", "columns of one table")
    return columns


def _array(key: str, column: Any, unit: Unit | None) -> Any:
    """Return a column as an array or a quantity; refuse missing values."""
    if unit is None and _is_text(column):
        texts = column.to_numpy().tolist()
        if not all(isinstance(text, str) for text in texts):
            _refuse_missing(key, column)
        return arguments.gathered(key, texts)
    values = column.data if arguments.library_of(column) == XARRAY else column.to_numpy()
    values = arguments.magnitude_of(values)
    if not arguments.is_lazy(values):
        try:
            values = floats(values, None)
        except (TypeError, ValueError):
            problem = (
                f"{key} is a column with a value that is not a number: '{quote(str(column.name))}'"
            )
            raise ConditionError(problem, "a column of numbers") from None
        if key != "value" and numpy.isnan(values).any():
            _refuse_missing(key, column)
    return values if unit is None else arguments.quantity(values, unit)


def _refuse_missing(key: str, column: Any) -> None:
    problem = f"{key} is a column with missing values, '{quote(str(column.name))}'"
    raise ConditionError(problem, "the rows that have one: .dropna(), or .drop_nulls()")


def of_conversion(columns: Columns, value: Any, target: Unit, name: str) -> Any:
    """Return the values as a column, with its own name if the quantity is the same."""
    column_name = str(columns.like.name) if columns.like.name is not None else ""
    title = read_title(column_name) if column_name and columns.library != XARRAY else None
    if title and title.unit and title.unit.dimension == target.dimension:
        return columns.result(name, value, title.with_unit(target.text), target.text)
    return columns.result(name, value, f"{name} [{target.text}]", target.text)


ALONE = ""  # the name of a function's only result


class Place(NamedTuple):
    """The place of an array in a call: its keyword, and the unit of a quantity.

    A point has three arrays, one for each coordinate.
    """

    key: str
    unit: str
    parts: int


class Expected(NamedTuple):
    """A result for no elements: its unit, its shape, and its value, which may have no axis."""

    unit: str
    shape: tuple[int, ...]
    value: Any


class Call(NamedTuple):
    """A call that can be sent to another process, with the places of the arrays of a block.

    The function takes a mapping of magnitudes with units, since Pint quantities would lose their
    registry, or of None instead of an array of a block.
    """

    function: Callable[[dict[str, Any]], Any]
    given: dict[str, tuple[Any, str] | None]
    places: tuple[Place, ...]

    @in_python
    def answer(self, *blocks: Any) -> Any:
        values = {key: pair and _quantity(*pair) for key, pair in self.given.items()}
        remaining = iter(blocks)
        for place in self.places:
            parts = [next(remaining) for _ in range(place.parts)]
            array = parts[0] if place.parts == 1 else numpy.stack(parts, -1)
            values[place.key] = _quantity(array, place.unit)
        return self.function(values)

    def results(self, *blocks: Any) -> dict[str, Any]:
        return _by_name(self.answer(*blocks))


class Rows(NamedTuple):
    """The array results of a call, one after the other along a first axis."""

    call: Call
    expected: dict[str, Expected]

    def __call__(self, *blocks: Any) -> Any:
        """Return the results for these blocks, which must match those for no elements."""
        results = self.call.results(*blocks)
        if not (results.keys() == self.expected.keys() and all(map(self._fits, results.items()))):
            problem = "not all elements have the same results, in number and unit"
            raise ConditionError(problem, "arrays in memory: .compute() before the call")
        shape = numpy.broadcast_shapes(*(block.shape for block in blocks))
        rows = [
            magnitude_of(results[name])
            for name, expected in self.expected.items()
            if expected.shape
        ]
        rows = [row if row.shape == shape else numpy.broadcast_to(row, shape) for row in rows]
        return rows[0][None] if len(rows) == 1 else numpy.stack(rows)

    def _fits(self, result: tuple[str, Any]) -> bool:
        name, value = result
        unit, shape, known = self.expected[name]
        same = bool(shape) or numpy.array_equal(magnitude_of(value), known, equal_nan=True)
        return same and _unit(value) == unit


def blockwise(
    name: str, function: Callable[[dict[str, Any]], Any], given: Mapping[str, Any]
) -> Any:
    """Call a function with Dask arrays: like with NumPy arrays, but the results are deferred.

    The function is elementwise, takes a mapping, and can be pickled; `name` is for Dask's tasks.
    Values that depend on an array are Dask arrays.  A call that is wrong for all elements raises
    RadcalcError; errors of single elements are raised when the results are computed.
    """
    import dask.array

    given = {key: gathered(key, value) for key, value in given.items()}
    parts = {key: blocks for key, value in given.items() if (blocks := _arrays(key, value))}
    places = [Place(key, _unit(given[key]), len(blocks)) for key, blocks in parts.items()]
    arrays = [array for blocks in parts.values() for array in blocks]
    plain = {
        key: None if key in parts else (magnitude_of(value), _unit(value))
        for key, value in given.items()
    }
    call = Call(function, plain, tuple(places))
    count = max(array.ndim for array in arrays)  # 0 for single values, whose rows have one axis
    axes = tuple(range(max(count, 1)))
    arrays = [array if array.ndim else array.reshape(1) for array in arrays]
    answer = call.answer(*map(_without_elements, arrays))
    empty = _by_name(answer)
    expected = {
        name: Expected(_unit(value), numpy.shape(magnitude_of(value)), magnitude_of(value))
        for name, value in empty.items()
    }
    names = [name for name, entry in expected.items() if entry.shape]
    try:
        rows: Any = dask.array.blockwise(
            Rows(call, expected),
            (len(axes), *axes),
            *(x for array in arrays for x in (array, axes[len(axes) - array.ndim :])),
            new_axes={len(axes): len(names)},
            dtype=numpy.result_type(*(expected[name].value.dtype for name in names)),
            meta=numpy.empty((0,) * (len(axes) + 1)),
            token=f"radcalc-{name}",
        )
    except ValueError:
        hint = "arrays of one shape, or of shapes that NumPy broadcasts, with known chunks"
        raise ConditionError("the arrays do not fit together", hint) from None
    results = dict(empty)
    for row, name in enumerate(names):
        array = rows[(row, *_index(expected[name].shape, len(axes), not count))]
        results[name] = Quantity(array, empty[name].units) if expected[name].unit else array
    return waiting(answer, results) if isinstance(answer, Result) else results[ALONE]


def _by_name(answer: Any) -> dict[str, Any]:
    """Return the results of an answer by all of their names; a single one has none."""
    return all_of(answer) if isinstance(answer, Result) else {ALONE: answer}


def _arrays(key: str, value: Any) -> list[Any]:
    """Return a value as Dask arrays: three for points, none for a single value."""
    import dask.array

    array = magnitude_of(value)
    symbol = SYMBOLS.get(symbol_name(key))
    if isinstance(array, (list, tuple)) and (symbol is None or symbol.form == QUANTITY):
        array = numpy.asarray(array)
    waits = is_lazy(array)
    if waits and not isinstance(array, dask.array.Array):
        problem = f"a {type(array).__name__} of Dask is not an array"
        raise ConditionError(problem, "its values: .to_dask_array(), or .values")
    if key == "point":
        if not waits and numpy.ndim(array) < 2:
            return []
        if array.shape[-1:] != (3,):
            raise ConditionError("a point has three coordinates", "an array of the shape (..., 3)")
        return [dask.array.asarray(array[..., axis]) for axis in range(3)]
    if waits and symbol and symbol.form != QUANTITY:
        raise ConditionError(f"{option(symbol.name)} is a Dask array", "one value: .compute()")
    return [dask.array.asarray(array)] if waits or is_column(array) else []


def _without_elements(array: Any) -> Any:
    """Return an array without elements, with the axes of another; axes of length 1 are kept."""
    shape = [int(length == 1) for length in array.shape]
    if all(shape):
        shape[-1] = 0
    return numpy.empty(shape, array.dtype)


def _index(shape: tuple[int, ...], count: int, is_single: bool) -> tuple[Any, ...]:
    """Return the index of a result in rows with `count` axes; it may have fewer or be single."""
    if is_single:
        return (0,)
    kept = (slice(None, 1) if length == 1 else slice(None) for length in shape)
    return (*[0] * (count - len(shape)), *kept)


def _unit(value: Any) -> str:
    return unit_of(value).text if hasattr(value, "magnitude") else ""


def _quantity(magnitude: Any, unit: str) -> Any:
    return Quantity(magnitude, unit) if unit else magnitude


def in_columns(result: Result, columns: Columns | None) -> Result:
    """Return a result with columns for arrays that depend on columns."""
    if columns is None:
        return result
    every = {name: columns.result(name, value) for name, value in result._every.items()}
    return Result(result.command, result._show, every, result._names, None, result._solved)
