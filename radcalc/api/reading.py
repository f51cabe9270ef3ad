"""What is given to a function, read: texts, quantities, numbers, and lists of them."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, TypeVar

import numpy

from radcalc.api import spelling
from radcalc.api.quantity import is_lazy, is_quantity, plain, quantity, unit_of
from radcalc.errors import ConditionError, nearest, option, quote
from radcalc.given import TOO_FAR, Given, Inputs, read, read_interval, read_place, values_of
from radcalc.maths import LARGEST, is_column
from radcalc.quantities.light import describe
from radcalc.quantities.symbols import (
    DIRECTION,
    INNER,
    INTERVAL,
    NUMBERS,
    POINT,
    QUANTITY,
    SYMBOLS,
    VECTOR,
    article,
)
from radcalc.units.dimensions import COHERENT, LENGTH
from radcalc.units.ranges import real
from radcalc.units.scales import ScaleUnit
from radcalc.units.table import Unit, resolve

T = TypeVar("T")
LIBRARIES = ("pandas", "polars", "xarray")  # of tables, whose columns `radcalc.api.columns` takes
KNOWN = [name for name, symbol in SYMBOLS.items() if symbol.help and name not in INNER]


def read_inputs(given: Mapping[str, Any], intervals: Sequence[str] = ()) -> Inputs:
    """Read what a calculator is given; `intervals` are A:B."""
    return {
        name: one
        for keyword, value in given.items()
        if (one := read_keyword(keyword, value, KNOWN, "input", intervals)) and (name := one.name)
    }


def is_absent(value: Any) -> bool:
    """Whether an argument is as if it were not given: None, or a flag that is False."""
    return value is None or value is False


def read_keyword(
    keyword: str, value: Any, known: Iterable[str], what: str, intervals: Sequence[str] = ()
) -> Given | None:
    """Read one keyword; None if it is absent."""
    name = spelling.symbol_name(keyword)
    if name not in known:
        known = [*known]
        near = nearest(name, known) if what == "input" else known
        keywords = ", ".join(map(spelling.keyword, near))
        raise ConditionError(f"there is no {what} '{quote(keyword)}'", keywords or "help(radcalc)")
    if is_absent(value):
        return None
    refuse_lazy(value, keyword)
    if name in intervals:
        return read_interval(name, as_interval(value))
    form = SYMBOLS[name].form
    value = _gathered(name, value)
    if isinstance(value, (list, tuple)) and any(map(is_quantity, value)):
        if form not in (DIRECTION, POINT, VECTOR, NUMBERS):
            raise ConditionError(f"{keyword} is a list of quantities", "one of them")
        value = ",".join(map(as_text, value))
    if form == INTERVAL:
        value = as_interval(value)
    return read(name, plain(value), uncertain=True)


def gathered(keyword: str, value: Any) -> Any:
    """A list of texts or quantities as one quantity, in the unit of the first.

    A text may be a list or a range itself: "1m,2m,5m", "1m:5m:1m".
    """
    name = spelling.symbol_name(keyword)
    found = _gathered(name, value) if name in SYMBOLS else value
    return value if found is value else quantity(*found)


def _gathered(name: str, value: Any) -> Any:
    """The same as an array and its unit; what is no such list as it is."""
    if SYMBOLS[name].form != QUANTITY:
        return value
    if isinstance(value, str):
        each_text = values_of(name, value)
        value = each_text if len(each_text) > 1 else value
    if not isinstance(value, (list, tuple)):
        return value
    if not any(isinstance(one, str) or is_quantity(one) for one in value):
        return value
    each = [read(name, plain(one)) for one in value]
    if any(is_column(one.value) for one in each):
        raise ConditionError(f"{option(name)} is a list of arrays", "one array")
    return together(option(name), [_with_unit(one) for one in each])


def _with_unit(given: Given) -> tuple[Any, Unit]:
    """A number and its unit; where it has none, or a scale, what it stands for in SI."""
    if given.unit is None or isinstance(given.unit, ScaleUnit):
        return given.value, resolve(COHERENT[given.dimension])
    return given.number, given.unit


def together(told: str, each: Sequence[tuple[Any, Unit]]) -> tuple[Any, Unit]:
    """Numbers and their units as an array in the unit of the first."""
    units = [unit for _, unit in each]
    first = units[0]
    if any(unit.dimension != first.dimension for unit in units):
        several = " and ".join(dict.fromkeys(map(describe, units)))
        raise ConditionError(f"{told} mixes quantities: {several}", "one quantity")
    sizes = [
        number if unit == first else number * (unit.factor / first.factor) for number, unit in each
    ]
    return real(sizes, told, "single values"), first


def as_text(value: Any) -> str:
    """A quantity, or what else it is, as it would be typed."""
    return f"{value.magnitude} {unit_of(value).text}" if is_quantity(value) else str(value)


def as_interval(value: Any) -> str:
    """A:B, of a text or of two texts or quantities."""
    return ":".join(map(as_text, value)) if isinstance(value, (list, tuple)) else str(value)


def refuse_lazy(value: Any, what: str) -> None:
    """Refuse what is not computed yet where it is needed at once."""
    if is_lazy(value):
        problem = f"{what} is one of Dask's, for which the answer here cannot wait"
        raise ConditionError(problem, "an array in memory: .compute() before the call")


def library_of(value: Any) -> str:
    """The library of tables that an object is of; none of others."""
    root = type(value).__module__.partition(".")[0]
    return root if root in LIBRARIES else ""


def refuse_column(value: Any, what: str) -> None:
    """Refuse an object of a library of tables where it would lose its names."""
    if library := library_of(value):
        problem = f"{what} is {article(type(value).__name__)} of {library}"
        raise ConditionError(problem, ".to_numpy(), for its values alone")


def read_points(point: Any) -> Given:
    """Points, as a text, lengths or numbers of metres."""
    refuse_lazy(point, "the array of points")
    refuse_column(point, "the array of points")
    if isinstance(point, str):
        return read_place("point", point)
    metres, unit = in_metres(point, "a point", "three numbers, [1, 0, 2]")
    array = numpy.asarray(metres)
    if array.shape[-1:] != (3,):
        raise ConditionError("a point has three coordinates", "an array of the shape (..., 3)")
    if not (abs(array) <= LARGEST).all():
        raise ConditionError(*TOO_FAR)
    place = tuple(array.tolist() if array.ndim == 1 else numpy.moveaxis(array, -1, 0))
    return Given(SYMBOLS["point"], "the points", place, unit=unit)


def in_metres(value: Any, what: str, hint: str) -> tuple[Any, Unit | None]:
    """Coordinates in metres, and their unit if they have one."""
    unit = None
    if is_quantity(value):
        unit = unit_of(value)
        if unit.dimension != LENGTH:
            raise ConditionError("the point is a length", "metres")
        value = value.magnitude * unit.factor
    return real(value, what, hint), unit


def broadcast(work_out: Callable[[], T]) -> T:
    """What comes of arrays, which have to fit together."""
    try:
        return work_out()
    except ValueError as error:
        if "broadcast" not in str(error):
            raise
        raise ConditionError("the arrays do not fit together", "arrays of one shape") from None


def one_of(word: object, names: Sequence[str] | Mapping[str, Any], what: str) -> str:
    """A word that is one of several names."""
    if not isinstance(word, str) or word not in names:
        raise ConditionError(f"there is no {what} '{quote(str(word))}'", ", ".join(names))
    return word
