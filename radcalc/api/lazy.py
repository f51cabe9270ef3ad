"""Dask arrays: a calculation that is deferred, and done block by block.

A calculator needs values, so it runs first on arrays without elements, which show the results,
their units and their axes, and later on each block, where invalid values raise errors.
"""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import dask.array
import numpy

from radcalc.api.arguments import Quantity, gathered, is_lazy, magnitude_of, symbol_name, unit_of
from radcalc.api.result import Result, all_of, in_python, waiting
from radcalc.errors import ConditionError, option
from radcalc.maths import is_column
from radcalc.quantities.symbols import QUANTITY, SYMBOLS

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
