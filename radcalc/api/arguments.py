"""Arguments of functions: quantities of Pint, texts, numbers, lists of them, and tables.

Messages have Python's spelling: keywords instead of options.
"""

import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import wraps
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

import numpy

from radcalc import errors
from radcalc.answer import Row, in_short
from radcalc.calculators.results import listed_in
from radcalc.errors import NumberError, input_of, option, quote, spell
from radcalc.inputs import Input, Inputs
from radcalc.inputs.places import TOO_FAR, read_place
from radcalc.inputs.reading import read, read_interval, split_values
from radcalc.maths import LARGEST, frozen, is_array, is_column
from radcalc.quantities import describe, symbols
from radcalc.quantities.symbols import FLAG, SYMBOLS, article
from radcalc.units import Unit
from radcalc.units.dimensions import COHERENT, LENGTH
from radcalc.units.numbers import read_number
from radcalc.units.ranges import real, refuse_masked
from radcalc.units.registry import (
    Dimensionality,
    DimensionalityError,
    from_container,
    light_registry,
)
from radcalc.units.table import resolve
from radcalc.units.values import ScaleUnit

OTHER_KEYWORDS = {"check": "claim"}  # options whose keywords differ
# Commands that are not functions.
AT_A_SHELL = ("columns", "help", "manual", "mark", "prompt", "quantities", "units")


def keyword(name: str) -> str:
    """Return a name as Python writes it, without hyphens: `half_angle`."""
    return name.replace("-", "_")


def symbol_name(keyword: str) -> str:
    """Return the symbol or command of a keyword: `half-angle`."""
    return keyword.replace("_", "-")


def is_absent(value: object) -> bool:
    """Return whether an argument counts as not given: None, or a flag that is False."""
    return value is None or value is False


class Python:
    """Python's spelling of symbols and commands in messages."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """Return `height="6 m"`; a value in capitals is a placeholder, and a flag is True."""
        spelled = OTHER_KEYWORDS.get(name) or keyword(name)
        if not value:
            return spelled
        if value.isupper() and value.isalpha():
            return f"{spelled}={value}"
        return f"{spelled}={_as_literal(value)}"

    @staticmethod
    def command(*words: str) -> str:
        """Return `radcalc.lambertian("disc")`, or the shell's command if there is no function."""
        function = keyword(words[0])
        pairs = [input_of(word) for word in words[1:]]
        if words[0] in AT_A_SHELL or any(key == "list" for key, _ in pairs):
            call = " ".join([words[0], *[text for key, text in pairs if not key]])
            return f"`radcalc {call}` at a shell"
        arguments = [
            PythonHint.option(key, value) if key else _as_literal(value)
            for key, value in pairs
            if key != "get"
        ]
        results = listed_in([value for key, value in pairs if key == "get"])
        chosen = Python.result(results[0]) if len(results) == 1 else ""  # several: the whole answer
        return f"radcalc.{function}({', '.join(arguments)}){chosen}"

    @staticmethod
    def result(text: str) -> str:
        name, _, unit = text.partition(":")
        return f".{keyword(name)}" + (f'.to("{unit}")' if unit else "")

    @staticmethod
    def manual(name: str) -> str:
        return f"help(radcalc.{keyword(name)})"

    @staticmethod
    def measured(unit: str) -> str:
        """Return `illuminance (lx)`."""
        return describe(resolve(unit))


class PythonHint(Python):
    """The spelling in a hint, where a flag is shown as typed."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """Return `isotropic=True`."""
        is_flag = name in SYMBOLS and SYMBOLS[name].form == FLAG
        return f"{Python.option(name, '')}=True" if is_flag else Python.option(name, value)


class Documented(Python):
    """The spelling of keywords in docstrings."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """Return `half_angle`, in backquotes."""
        return f"``{Python.option(name, value)}``" if value else f"`{Python.option(name, '')}`"


def _as_literal(value: str) -> str:
    """Return a text in quotes, with a blank between a number and its unit."""
    with suppress(NumberError):
        end = read_number(value)[1]
        value = f"{value[:end]} {value[end:].strip()}".strip()
    return '"' + value.replace('"', '\\"') + '"'


def in_words(text: str) -> str:
    """Return a remark with keywords."""
    return spell(text, Python)


if TYPE_CHECKING:
    import pint

    Quantity: TypeAlias = pint.Quantity[Any]
else:
    Quantity = light_registry().Quantity


def is_quantity(value: Any) -> bool:
    """Return whether a value is a quantity; refuse one of another registry."""
    own = getattr(value, "_REGISTRY", None) is light_registry()  # also a Measurement
    other = getattr(value, "magnitude", None) if own else value
    if hasattr(other, "magnitude"):
        hint = "radcalc.Quantity(q.magnitude, str(q.units)), where q is that quantity"
        raise errors.UnitError(f"'{quote(str(other))}' is a quantity of another registry", hint)
    return own


def magnitude_of(value: Any) -> Any:
    """Return the magnitude of a quantity; anything else unchanged."""
    return getattr(value, "magnitude", value)


def is_lazy(value: Any) -> bool:
    """Return whether a value is a Dask collection, or a quantity with one."""
    return hasattr(magnitude_of(value), "__dask_graph__")


def unit_of(quantity: Any) -> Unit:
    """Return the unit of a quantity."""
    return from_container(quantity._units)


def plain(value: Any) -> Any:
    """Return a quantity as a number (or an array) with its unit; anything else unchanged."""
    return (value.magnitude, unit_of(value)) if is_quantity(value) else value


def quantity(magnitude: Any, unit: Unit) -> Quantity:
    """Return a number, or an array, in a unit; nobody can change the array."""
    result: Quantity = Quantity(frozen(magnitude), light_registry().container(unit))
    return result


def typed(value: Any) -> str:
    """Return a quantity as it would be typed."""
    return f"{str(value.magnitude).removesuffix('.0')} {unit_of(value).text}"


def row_of(value: Any) -> Row:
    """Return a number, or a quantity, as a row of an answer."""
    return Row("", "", magnitude_of(value), unit_of(value).text if is_quantity(value) else "1")


class OtherQuantity(errors.ConversionError, Dimensionality):
    """A unit of another quantity: an error of radcalc, and of Pint for those who catch that."""


def _in_words(pint_method: Callable[..., Any]) -> Callable[..., Any]:
    """Return a method of Pint that refuses a unit in the words of `radcalc.convert`."""

    @wraps(pint_method)
    def to(self: Any, other: Any = None, *contexts: Any, **settings: Any) -> Any:
        if not (isinstance(other, Mapping) or hasattr(other, "_REGISTRY")):
            require_texts(target=other)
        try:
            return pint_method(self, other, *contexts, **settings)
        except (DimensionalityError, errors.UnitError) as error:
            refusal = _refusal(self, other)
            if isinstance(error, DimensionalityError):
                refusal = OtherQuantity(refusal.message, refusal.hint)
        raise refusal

    return to


def _refusal(value: Any, other: Any) -> errors.RadcalcError:
    """Return the error for a unit of another quantity, or a text that is not a unit."""
    target = other if isinstance(other, str) else from_container(other._units).text
    try:
        converted = sys.modules["radcalc"].convert(value, target)
    except errors.RadcalcError as error:
        return error
    is_one = isinstance(value.magnitude, (int, float))
    problem = f"'{quote(target)}' is not a unit of {describe(unit_of(value))}"
    shown = f'"{typed(value)}"' if is_one else "quantity"
    hint = f'radcalc.convert({shown}, "{target}")'
    problem = f"{problem}, and Quantity.to keeps the quantity"
    return errors.UnitError(
        problem, f"{hint}\n     {in_short([row_of(converted)])}" if is_one else hint
    )


def _reduced(measure: Any) -> tuple[Any, ...]:
    return _restored, (
        type(measure).__name__,
        getattr(measure, "magnitude", None),
        dict(measure._units),
    )


def _restored(kind: str, magnitude: Any, powers: Mapping[str, int]) -> Any:
    registry = light_registry()
    for name in powers:
        registry.get_name(name)  # defines a prefixed unit
    units = registry.UnitsContainer(powers)
    return getattr(registry, kind)(*([] if magnitude is None else [magnitude]), units)


def _adapt() -> None:
    """Change two things in Pint's classes: the registry of pickles, and the words of refusals."""
    registry = light_registry()
    for kind in (registry.Quantity, registry.Measurement, registry.Unit):
        kind.__reduce__ = _reduced  # type: ignore[method-assign]
    for quantities in (registry.Quantity, registry.Measurement):
        for name in ("to", "ito"):
            setattr(quantities, name, _in_words(getattr(quantities, name)))


_adapt()


T = TypeVar("T")
TEXTS = {
    "source": "lx",
    "target": "lx",
    "to": "fc",
    "expression": "cos(theta)",
    "unit": "W/m2",
    "time_zone": "Europe/Prague",
    "thousands": ",",
    "time_unit": "s",
    "time_format": "%d.%m.%Y",
    "wanted": "illuminance:fc",
    "search": "museum",
    "sentence": "20000 cd at 8 m to lx",
    "path": "picture.svg",
}
LIBRARIES = (
    "pandas",
    "polars",
    "xarray",
)  # libraries of tables, whose columns `radcalc.api.columns` takes


def read_inputs(given: Mapping[str, Any], intervals: Sequence[str] = ()) -> Inputs:
    """Read the symbols given to a function by keyword; `intervals` are A:B."""
    inputs = [
        _read(keyword, value, intervals) for keyword, value in given.items() if not is_absent(value)
    ]
    return {entry.name: entry for entry in inputs}


def _read(keyword: str, value: Any, intervals: Sequence[str]) -> Input:
    """Read the value of one symbol: a text, a quantity, a number, a list of these, or a table."""
    name = symbol_name(keyword)
    refuse_lazy(value, keyword)
    if name in intervals:
        return read_interval(name, as_interval(value))
    form = symbols.SYMBOLS[name].form
    if form == symbols.SPECTRUM and isinstance(value, Mapping):  # a result of radcalc.spectrum
        problem = f"{keyword} is {article(type(value).__name__)}, not a source of light"
        raise errors.ConditionError(problem, errors.add(name, "D65", "its source"))
    if form == symbols.SPECTRUM and _is_table(value):
        from radcalc.spectra.files import read_text

        value = read_text(*table_of(value))
    value = _gathered(name, value)
    if isinstance(value, (list, tuple)) and any(map(is_quantity, value)):
        if form not in (symbols.DIRECTION, symbols.POINT, symbols.VECTOR, symbols.NUMBERS):
            raise errors.ConditionError(f"{keyword} is a list of quantities", "only one of them")
        value = ",".join(map(as_text, value))
    if form == symbols.INTERVAL:
        value = as_interval(value)
    return read(name, _owned(plain(value)), uncertain=True)


def _owned(value: Any) -> Any:
    """Return a copy of an array of a user, who may change it later."""
    if isinstance(value, tuple):
        return tuple(map(_owned, value))
    return frozen(value.copy()) if isinstance(value, numpy.ndarray) and value.ndim else value


def gathered(keyword: str, value: Any) -> Any:
    """Return a list of texts or quantities as one quantity, in the unit of the first.

    A text may be a list or a range itself: "1m,2m,5m", "1m:5m:1m".
    """
    name = symbol_name(keyword)
    array_and_unit = _gathered(name, value) if name in symbols.SYMBOLS else value
    return value if array_and_unit is value else quantity(*array_and_unit)


def _gathered(name: str, value: Any) -> Any:
    if symbols.SYMBOLS[name].form != symbols.QUANTITY:
        return value
    if isinstance(value, str):
        texts = split_values(name, value)
        value = texts if len(texts) > 1 else value
    if not isinstance(value, (list, tuple)):
        return value
    if not any(isinstance(element, str) or is_quantity(element) for element in value):
        return value
    inputs = [read(name, plain(element)) for element in value]
    if any(is_column(entry.value) for entry in inputs):
        raise errors.ConditionError(f"{option(name)} is a list of arrays", "one array")
    return together(option(name), [_with_unit(entry) for entry in inputs])


def _with_unit(given: Input) -> tuple[Any, Unit]:
    """Return a number and its unit; for a bare number or a scale, the value in SI."""
    if given.unit is None or isinstance(given.unit, ScaleUnit):
        return given.value, resolve(COHERENT[given.dimension])
    return given.number, given.unit


def together(label: str, pairs: Sequence[tuple[Any, Unit]]) -> tuple[Any, Unit]:
    """Return numbers with units as an array in the unit of the first."""
    units = [unit for _, unit in pairs]
    first = units[0]
    if any(unit.dimension != first.dimension for unit in units):
        several = " and ".join(dict.fromkeys(map(describe, units)))
        raise errors.ConditionError(f"{label} mixes quantities: {several}", "one quantity")
    sizes = [
        number if unit == first else number * (unit.factor / first.factor) for number, unit in pairs
    ]
    return real(sizes, label, "single values"), first


def as_text(value: Any) -> str:
    """Return a quantity, or another value, as it would be typed."""
    return typed(value) if is_quantity(value) else str(value)


def as_interval(value: Any) -> str:
    """Return A:B from a text, or from two texts or quantities."""
    return ":".join(map(as_text, value)) if isinstance(value, (list, tuple)) else str(value)


def require_texts(**given: Any) -> None:
    """Refuse an argument that is not a text, of those with an example in `TEXTS`."""
    for keyword, value in given.items():
        if not isinstance(value, str):
            problem = f"{keyword} is a text, not {article(type(value).__name__)}"
            raise errors.ConditionError(problem, f"a text such as '{TEXTS[keyword]}'")


def refuse_unlike_index(first: Any, second: Any) -> None:
    """Refuse two series of pandas whose rows have other labels, by which they do not match."""
    own: Any = getattr(first, "index", None)
    other: Any = getattr(second, "index", None)
    if hasattr(own, "equals") and hasattr(other, "equals") and not own.equals(other):
        problem = "the two series have other labels in their indices"
        hint = ".to_numpy() of both, if their rows have the same order"
        raise errors.ConditionError(problem, hint)


def refuse_lazy(value: Any, what: str) -> None:
    """Refuse a Dask collection if its value is needed at once."""
    if is_lazy(value):
        problem = f"{what} is a Dask collection, but its value is needed at once"
        raise errors.ConditionError(problem, "an array in memory: .compute() before the call")


def refuse_arrays(inputs: Inputs, whole: str) -> None:
    """Refuse arrays where a single value holds for the whole."""
    for given in inputs.values():
        if is_array(given.value):
            problem = f"{option(given.name)} is an array"
            raise errors.ConditionError(problem, f"one value for {whole}")


def library_of(value: Any) -> str:
    """Return the library of tables of an object, if any."""
    root = type(value).__module__.partition(".")[0]
    return root if root in LIBRARIES else ""


def table_of(source: Any) -> tuple[str, str]:
    """Return the kind of a table in memory, and its text, with a line for each wavelength."""
    name = "arrays" if _is_pair(source) else type(source).__name__
    columns = _columns_of(source)
    if columns is None:
        hint = (
            'radcalc.spectrum("D65"), radcalc.spectrum("FILE") or '
            'radcalc.spectrum((wavelengths, values), unit="W/m2/nm")'
        )
        raise errors.ConditionError(f"a spectrum is a text or a table, not of type {name}", hint)
    for values in columns.values():
        refuse_masked(magnitude_of(values), "the spectrum")
    if _is_pair(source):
        refuse_unlike_index(*source)
    arrays = [numpy.asarray(magnitude_of(values)) for values in columns.values()]
    if any(array.ndim != 1 or array.shape != arrays[0].shape for array in arrays):
        shapes = " and ".join(str(array.shape) for array in arrays)
        problem = f"the wavelengths and the values have the shapes {shapes}"
        raise errors.ConditionError(problem, "arrays of one length")
    rows = [columns, *zip(*(array.tolist() for array in arrays), strict=True)]
    return name, "".join("\t".join(" ".join(str(c).split()) for c in row) + "\n" for row in rows)


def _columns_of(source: Any) -> dict[Any, Any] | None:
    """Return the columns of a table in memory by their titles; None for another object."""
    if _is_pair(source):
        return dict(zip(map(_title, source, ("wavelength", "value")), source, strict=True))
    name = type(source).__name__ if library_of(source) else ""
    if name == "Series" and hasattr(source, "index"):
        return {source.index.name or "wavelength": source.index, source.name or "value": source}
    if name != "DataFrame":
        return None
    if hasattr(source, "index") and (source.index.name or len(source.columns) == 1):
        source = source.rename_axis(source.index.name or "wavelength").reset_index()
    return {title: source[title] for title in source.columns}


def _is_table(value: Any) -> bool:
    """Return whether a spectrum is a table in memory, not a text or a file with its column."""
    if isinstance(value, (tuple, list)):
        return not value or not all(isinstance(one, str) for one in value)
    return bool(library_of(value)) or is_quantity(value) or isinstance(value, numpy.ndarray)


def _is_pair(value: Any) -> bool:
    """Return whether a value is the wavelengths and the values of a spectrum."""
    is_pair = isinstance(value, (tuple, list)) and len(value) == 2
    return is_pair and not any(isinstance(one, str) for one in value)


def _title(values: Any, name: str) -> str:
    return f"{name} [{unit_of(values).text}]" if is_quantity(values) else name


def refuse_column(value: Any, what: str) -> None:
    """Refuse an object of a library of tables if it would lose its names."""
    if library := library_of(value):
        problem = f"{what} is {article(type(value).__name__)} of {library}"
        is_frame = type(value).__name__ == "DataFrame"
        hint = 'a column of it: frame["NAME"]' if is_frame else ".to_numpy(), for its values alone"
        raise errors.ConditionError(problem, hint)


def read_points(point: Any) -> Input:
    """Read points: a text, lengths, or numbers in metres."""
    refuse_lazy(point, "the array of points")
    refuse_column(point, "the array of points")
    if isinstance(point, str):
        return read_place("point", point)
    metres, unit = in_metres(point, "a point")
    array = numpy.asarray(metres)
    if array.shape[-1:] != (3,):
        problem = "a point has three coordinates"
        raise errors.ConditionError(problem, "an array of the shape (..., 3)")
    if not (abs(array) <= LARGEST).all():
        raise errors.ConditionError(*TOO_FAR)
    place = tuple(array.tolist() if array.ndim == 1 else numpy.moveaxis(array, -1, 0))
    return Input(symbols.SYMBOLS["point"], "the points", place, unit=unit)


def in_metres(value: Any, what: str) -> tuple[Any, Unit | None]:
    """Coordinates in metres, and their unit if they have one."""
    unit = None
    if is_quantity(value):
        unit = unit_of(value)
        if unit.dimension != LENGTH:
            raise errors.ConditionError("the point is a length", "metres")
        value = value.magnitude
    return real(value, what, "three numbers, [1, 0, 2]") * (unit.factor if unit else 1.0), unit


def broadcast(work_out: Callable[[], T]) -> T:
    """Calculate with arrays, which must fit together."""
    try:
        return work_out()
    except ValueError as error:
        if "broadcast" not in str(error):
            raise
        problem = "the arrays do not fit together"
        raise errors.ConditionError(problem, "arrays of one shape") from None


def one_of(word: object, names: Sequence[str] | Mapping[str, Any], what: str) -> str:
    """Return a word that is one of several names, in any case."""
    if not isinstance(word, str) or word.lower() not in names:
        raise errors.ConditionError(f"unknown {what} '{quote(str(word))}'", ", ".join(names))
    return word.lower()
