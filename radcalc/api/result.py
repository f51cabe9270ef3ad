"""Results of functions, and their errors.

Results are quantities by name, with assumptions, notes, steps and a picture.  Errors are in
Python's spelling, with the calls that their hints propose.
"""

import json
import os
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property, partial, wraps
from inspect import Parameter, signature
from itertools import chain
from typing import TYPE_CHECKING, Any, NamedTuple, ParamSpec, TypeVar, cast

from radcalc import answer, errors
from radcalc.answer import Answer, Row, ShownInput, Step, in_short
from radcalc.api.arguments import (
    Python,
    PythonHint,
    Quantity,
    in_words,
    is_absent,
    is_lazy,
    is_quantity,
    keyword,
    magnitude_of,
    quantity,
    require_texts,
    row_of,
    symbol_name,
    typed,
    unit_of,
)
from radcalc.calculators import SUMMARIES, page_of
from radcalc.calculators.page import NOTHING
from radcalc.calculators.results import in_unit, name_in, name_of, rows, unit_for
from radcalc.calculators.worksheet import on_page
from radcalc.errors import ConditionError, RadcalcError, Try, quote
from radcalc.inputs import Inputs
from radcalc.maths import frozen, is_column
from radcalc.quantities.symbols import FLAG, READINGS, SYMBOLS
from radcalc.units import now, own_since, table
from radcalc.units.table import resolve

if TYPE_CHECKING:
    from radcalc.homework.question import Question
    from radcalc.plots import Picture
    from radcalc.units.values import ScaleUnit

P = ParamSpec("P")
T = TypeVar("T")
REFUSED = (RadcalcError, TypeError, ValueError, LookupError, AttributeError)  # a proposed call


def in_python(function: Callable[P, T]) -> Callable[P, T]:
    """Raise errors with keywords instead of options; state the user's definitions that are read."""

    @wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> T:
        time = now()
        try:
            found = function(*args, **kwargs)
            return _stating(found, own) if (own := own_since(time)) else found
        except RadcalcError as error:
            given = signature(function).bind_partial(*args).arguments | kwargs
            raise with_keywords(error, function, given) from None

    return call


def _stating(found: Any, own: Sequence[str]) -> Any:
    """Return what a function returned, with the user's definitions in its notes if it has some."""
    if isinstance(found, dict):  # by day
        return {period: _stating(result, own) for period, result in found.items()}
    if isinstance(found, Result):
        found._own = tuple(dict.fromkeys((*found._own, *own)))
    elif hasattr(found, "notes"):
        notes = tuple(dict.fromkeys((*found.notes, *own)))
        found = (
            found._replace(notes=notes) if hasattr(found, "_replace") else type(found)(found, notes)
        )
    return found


def with_keywords(
    error: RadcalcError, function: Callable[..., Any], given: Mapping[str, Any]
) -> RadcalcError:
    """Return the error of a call with keywords, and with the calls that its hint proposes."""
    error = on_page(error, symbol_name(function.__name__))
    message, hint = errors.spell(error.message, Python), errors.spell(error.hint, PythonHint)
    if error.tries:
        hint = proposals(error, function, given) or hint
    return error.reworded(message, hint).with_traceback(error.__traceback__)


def proposals(error: RadcalcError, function: Callable[..., Any], given: Mapping[str, Any]) -> str:
    """Return the calls that an error's hint proposes, each with its results below it.

    Return '' if all are refused.  A call with an array is neither made nor shown.
    """
    lines = []
    for proposal in error.tries[: errors.MOST]:
        with suppress(*REFUSED):
            words = proposal.words or _changed(proposal, function, given)
            made = [errors.input_of(word) for word in words[1:]]
            remark = errors.spell(answer.remark_on(proposal, made, _pairs(given)), PythonHint)
            results = _results(call_function(words), remark)
            lines.append(f"{Python.command(*words)}\n     {results}")
    text = "\nor:  ".join(dict.fromkeys(lines))
    if text and (others := error.others):
        help_ = Python.manual(symbol_name(function.__name__))
        text += f"\nor {', '.join(map(keyword, others))} ({help_})"
    return text


def _pairs(given: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return the single values of a call by the names of their symbols, '' for operands."""
    pairs = []
    for key, value in given.items():
        name = symbol_name(key)
        with suppress(TypeError):  # an array has no text
            pairs.append((name if name in SYMBOLS else "", _text_in_call(value)))
    return pairs


def _text_in_call(value: Any) -> str:
    """Return a single value as a text in a call; '' for True, the value of a flag."""
    is_single = isinstance(magnitude_of(value), (int, float))
    if not isinstance(value, str) and not is_single:
        raise TypeError
    return typed(value) if is_quantity(value) else "" if value is True else str(value)


def _changed(
    proposal: Try, function: Callable[..., Any], given: Mapping[str, Any]
) -> tuple[str, ...]:
    """Return the words of the user's call with a change: the command, operands and NAME=VALUE."""
    command = symbol_name(function.__name__)
    page = page_of(command if command in SUMMARIES else "convert")
    typed_texts = {
        key: _text_in_call(value) for key, value in given.items() if not is_absent(value)
    }
    arguments = dict(typed_texts)
    if proposal.instead:
        part, *correction = proposal.instead
        (name,) = [name for name, text in arguments.items() if part in text]
        arguments[name] = errors.with_correction(arguments[name], part, " ".join(correction))
    for symbol in proposal.without:
        arguments.pop(keyword(symbol), None)
    for symbol, text in proposal.inputs:
        is_flag = symbol in SYMBOLS and SYMBOLS[symbol].form == FLAG
        arguments[keyword(symbol)] = "" if is_flag else text or page.symbol(symbol).example
    if arguments == typed_texts:
        raise LookupError
    operands = [
        arguments.pop(parameter.name)
        for parameter in signature(function).parameters.values()
        if parameter.kind == Parameter.POSITIONAL_OR_KEYWORD and parameter.name in arguments
    ]
    return command, *operands, *(f"{symbol_name(k)}={text}" for k, text in arguments.items())


def call_function(words: Sequence[str], in_core: bool = True) -> Any:
    """Call the function of a command with operands and NAME=VALUE, and return what it returns.

    Its error is that of the core, or that of Python with the calls that its hint proposes.
    """
    command, *others = words
    pairs = [errors.input_of(word) for word in others]
    operands = [text for name, text in pairs if not name]
    inputs = {name: text for name, text in pairs if name}
    wanted = inputs.pop("get", "")
    arguments = {
        keyword(name): text or SYMBOLS[name].form == FLAG or page_of(command).symbol(name).example
        for name, text in inputs.items()
    }
    function = getattr(sys.modules["radcalc"], keyword(command), None)
    function = getattr(function, "__wrapped__", None) if in_core else function
    if function is None:
        raise LookupError
    found = function(*operands, **arguments)
    return _result(found, wanted) if wanted else found


def _result(found: Any, wanted: str) -> Any:
    """Return a result NAME[:UNIT] of those that a function returned; of each day, if by day."""
    if isinstance(found, dict):
        return {period: _result(result, wanted) for period, result in found.items()}
    name, _, unit = wanted.partition(":")
    quantity = getattr(found, keyword(name), None)
    if quantity is None:
        raise LookupError(f"the function has no result {keyword(name)}")
    unit, *_ = table.GROWERS_WORDS.get(unit.lower(), (unit,))  # of ppfd and dli, which are names
    return quantity.to(unit) if unit else quantity


def _results(found: Any, remark: str) -> str:
    """Return what a function returned in a line, with a remark; the first row of a list."""
    if isinstance(found, dict):  # by day
        return next(f"{day}: {_results(result, remark)}" for day, result in found.items())
    if isinstance(found, tuple):
        return str(found[0]).partition("\n")[0]
    if hasattr(found, "rows"):
        rows = [row._replace(name=keyword(row.name)) for row in found.rows if not row.given]
        return in_short(rows, True, remark)
    return in_short([row_of(found)], False, remark)


class Drawing:
    """A picture for a notebook, as a Matplotlib figure, or in a file."""

    def __init__(self, picture: "Picture") -> None:
        self.picture = picture

    def __repr__(self) -> str:
        """Return the picture in characters, or a text if it is drawn in a file only."""
        from radcalc.plots import IN_A_FILE
        from radcalc.plots.characters import draw, style_of

        if kind := IN_A_FILE.get(type(self.picture)):
            return f"{kind}: .save('plot.png') writes it into a file"
        return draw(self.picture, style_of()).rstrip("\n")

    @cached_property
    def figure(self) -> Any:
        from radcalc.plots.figure import figure

        return figure(self.picture)

    def _repr_svg_(self) -> str:
        from radcalc.plots.figure import data

        return data(self.picture, ".svg").decode()

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Write it into an SVG or PNG file, by the ending of the name.

        Raises
        ------
        radcalc.RadcalcError
            If the file has another ending, or cannot be written.
        """
        from radcalc.plots.figure import write

        if not isinstance(path, os.PathLike):
            require_texts(path=path)
        write(os.fspath(path), self.picture)


Show = Callable[[], answer.Result]
Drawn = tuple[Inputs, Answer, Any]  # with the other inputs of a picture


class Undrawn(NamedTuple):
    """The reason why a result has no picture, and what has one."""

    problem: str
    hint: str


class MissingResult(RadcalcError, KeyError, AttributeError):
    """An unknown result, as an attribute or in brackets."""


class Result(Mapping[str, Quantity]):
    """The inputs and results of a calculation: quantities by name.

    The quantities are attributes and items, with the names of ``radcalc -g``; attributes have
    underscores instead of hyphens, items either: ``r["solid-angle"]``.  A light quantity also has
    the name of its kind: ``r.irradiance`` is ``r.illuminance``.  Quantities that depend on an
    array are arrays; those that depend on columns of pandas, Polars or xarray are columns.

    Attributes
    ----------
    command : str
        The calculator.
    inputs : tuple of radcalc.answer.ShownInput
        The inputs, as they were typed.
    rows : tuple of radcalc.answer.Row
        The results with labels and symbols, in all the units that the calculator shows.
    assumptions, notes : tuple of str
        The assumptions of the answer, and its remarks.
    steps : tuple of radcalc.answer.Step
        The derivation: laws in symbols and in numbers, with their references.

    Examples
    --------
    >>> import radcalc
    >>> lamp = radcalc.point_source(flux="800 lm", distance="2 m")
    >>> print(lamp.illuminance.to("fc").round(3))
    1.479 footcandle
    >>> lamp.assumptions[0]
    'isotropic: the same intensity in all directions'
    """

    def __init__(
        self,
        command: str,
        show: Show,
        every: Mapping[str, Any],
        names: Sequence[str],
        ask: "Callable[[], Question] | None",
        solved: Drawn | Undrawn,
        later: Mapping[str, Callable[[], Any]] = NOTHING,
    ) -> None:
        """`later` are results that are calculated at the first access."""
        self.command, self._show = command, show
        self._every = dict(every)
        self._names, self._ask, self._solved, self._later = names, ask, solved, later
        self._own: tuple[str, ...] = ()  # notes on the user's definitions

    def __getitem__(self, name: str) -> Quantity:
        """Return a result by any of its names; hyphens are underscores."""
        called = keyword(str(name))
        if called in self._later and called not in self._every:
            self._every[called] = self._later[called]()
        if called not in self._every:
            raise MissingResult(f"unknown result '{quote(str(name))}'", ", ".join(self._names))
        return self._every[called]  # type: ignore[no-any-return]

    def __iter__(self) -> Iterator[str]:
        """Iterate over the names of the results, each once."""
        return iter(self._names)

    def __len__(self) -> int:
        """Count the results."""
        return len(self._names)

    def __getattr__(self, name: str) -> Quantity:
        """Return a result by any of its names."""
        if name.startswith("_") or name not in names_of(self):
            raise AttributeError(f"'Result' object has no attribute '{name}'", name=name, obj=self)
        return self[name]

    def __setattr__(self, name: str, value: Any) -> None:
        """Refuse to replace a result: an answer does not change."""
        if name != "command" and not name.startswith("_"):
            raise AttributeError(f"a result has no attribute that can be set: {name}")
        super().__setattr__(name, value)

    def __eq__(self, other: object) -> bool:
        """Compare the results; arrays are equal if all elements are."""
        if not isinstance(other, Mapping):
            return NotImplemented
        return len(self) == len(other) and all(
            name in other and _is_same(value, other[name]) for name, value in self.items()
        )

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        """Return the pickled form: everything shown, without the calculation."""
        shown = self.command, self._renderable, self._every, self._names
        return _restored, (*shown, tuple(self._later))

    def __copy__(self) -> "Result":
        """Return the result itself, which never changes."""
        return self

    def __deepcopy__(self, memo: Any) -> "Result":
        """Return the result itself, which never changes."""
        return self

    def __dir__(self) -> list[str]:
        """List the results, by all of their names, with the other public attributes."""
        public = (name for name in dir(Result) if name[0] != "_")
        return [*names_of(self), "command", *public]

    def _ipython_key_completions_(self) -> list[str]:
        return [*self._every]

    def __repr__(self) -> str:
        """Return the results, assumptions and notes as text."""
        from radcalc.render.notebook import text

        return text(self.command, self._renderable)

    def _repr_html_(self) -> str:
        from radcalc.render.notebook import html

        return html(self.command, self._renderable)

    @property
    def _renderable(self) -> answer.Result:
        result = self._show()
        self._show = lambda: result
        return result._replace(notes=tuple(dict.fromkeys((*result.notes, *self._own))))

    @property
    def inputs(self) -> tuple[ShownInput, ...]:
        return self._renderable.inputs

    @property
    def rows(self) -> tuple[Row, ...]:
        return self._renderable.rows

    @property
    def assumptions(self) -> tuple[str, ...]:
        return self._renderable.assumptions

    @property
    def notes(self) -> tuple[str, ...]:
        return self._renderable.notes

    @property
    def steps(self) -> tuple[Step, ...]:
        return self._renderable.steps

    def to_dict(self) -> dict[str, Any]:
        """Return everything in the schema of ``--json --steps``, with arrays as lists.

        Returns
        -------
        dict
            With ``command``, ``inputs``, ``results``, ``assumptions``, ``notes``, ``steps`` and
            ``check``; only texts, numbers, lists and dicts.

        Raises
        ------
        radcalc.ConditionError
            If Dask has not computed a value yet.
        """
        from radcalc.render.formats import Style
        from radcalc.render.json import results

        result = self._renderable
        listed = result._replace(
            rows=tuple(row._replace(value=_listed(row.value)) for row in result.rows),
            inputs=tuple(map(_input_as_list, result.inputs)),
        )
        document: dict[str, Any] = json.loads(results([listed], Style(command=self.command)))
        return document

    def plot(self, *wanted: str) -> Drawing:
        """Draw the answer, or results over an array that was given.

        Parameters
        ----------
        *wanted : str
            The results to draw over an array, by name: ``"illuminance:fc"``; by default the main
            result of the calculator.  A single answer has a fixed picture; only the intensity of
            a point source may be named, with a unit.

        Returns
        -------
        Drawing
            A picture for a notebook, or for `save`; it needs ``radcalc[plot]``.

        Raises
        ------
        radcalc.RadcalcError
            If there is nothing to draw.
        """
        for name in wanted:
            require_texts(wanted=name)
        return _drawing(self, self._solved, wanted)


def question_of(result: Result) -> "Question":
    """Return the question that a result answers, for a check."""
    if result._ask is None:
        problem = "check takes one answer, but there are several"
        raise ConditionError(problem, "one value of each")
    return result._ask()


def all_of(result: Result) -> dict[str, Any]:
    """Return the quantities of a result by all of their names."""
    return result._every


def names_of(result: Result) -> list[str]:
    """Return all names of the results, also of those that are calculated at the first access."""
    return [*result._every, *result._later]


def waiting(result: Result, results: Mapping[str, Any]) -> Result:
    """Return a result with other values, which Dask has not computed yet."""

    def show() -> answer.Result:
        shown = result._renderable
        rows = [_with_value(row, results) for row in shown.rows]
        return shown._replace(rows=tuple(row for row in rows if row), steps=())

    waits = Undrawn(
        "a result not yet computed by Dask cannot be drawn", "the same of NumPy's arrays"
    )
    return Result(result.command, show, results, result._names, None, waits)


def _is_same(first: Any, second: Any) -> bool:
    if hasattr(first, "equals"):  # a column of pandas, Polars or xarray
        return type(first) is type(second) and bool(first.equals(second))
    sizes = (getattr(magnitude_of(value), "shape", ()) for value in (first, second))
    same = first == second if len({*sizes}) == 1 else False
    return bool(same.all() if hasattr(same, "all") else same)


def _restored(
    command: str,
    result: answer.Result,
    every: Mapping[str, Any],
    names: Sequence[str],
    on_request: Sequence[str] = (),
) -> Result:
    """Return a result read from a pickle: its values, and refusals of what needs its call."""
    problem = "a pickled result cannot be calculated again"

    def ask() -> "Question":
        raise ConditionError(problem, "radcalc.check of what the function gives")

    def refuse(name: str) -> Any:
        raise MissingResult(problem, f".{name} of what the function gives, before it is pickled")

    undrawn = Undrawn(problem, ".plot() of what the function gives")
    later = {name: partial(refuse, name) for name in on_request}
    return Result(command, lambda: result, every, names, ask, undrawn, later)


def _with_value(row: Row, results: Mapping[str, Any]) -> Row | None:
    """Return a row with the value of its result; None for another unit."""
    result = results[keyword(row.name)]
    if not is_column(row.value):
        return row
    if resolve(row.unit).dimension != unit_of(result).dimension:
        return None
    return row._replace(value=result.to(row.unit).magnitude)


@in_python
def _drawing(result: Result, solved: Drawn | Undrawn, wanted: tuple[str, ...]) -> Drawing:
    if isinstance(solved, Undrawn):
        raise ConditionError(*solved)
    from radcalc.plots.answers import depends, picture
    from radcalc.plots.curves import Solved

    inputs, solution, drawn = solved
    case = Solved(inputs, solution)
    for name in wanted:
        result[keyword(name_of(name))]
        if not depends(result.command, case, symbol_name(name)):
            problem = f"the picture of a single answer here does not depend on {quote(name)}"
            raise ConditionError(problem, ".plot(), or an array of values, over which it follows")
    return Drawing(picture(result.command, [case], [*map(symbol_name, wanted)], drawn))


def _listed(value: Any) -> Any:
    if is_lazy(value):
        raise ConditionError("a result of Dask is not computed yet", ".compute() of its magnitude")
    return value.tolist() if hasattr(value, "tolist") else value


def _input_as_list(given: ShownInput) -> ShownInput:
    return given._replace(value=given.value.tolist(), text="") if is_column(given.value) else given


def of_answer(
    command: str,
    solution: Answer,
    inputs: tuple[ShownInput, ...],
    ask: "Callable[[], Question] | None",
    solved: Drawn | Undrawn,
    again: Callable[[str], Answer] | None = None,
) -> Result:
    """Return the result of a calculator, each quantity in the first unit shown.

    `again` calculates the answer with a result that is calculated only on request.
    """
    answers = (solution, *solution.more)
    parts = [_quantities(part) for part in answers]
    every, names = parts[0]
    if len(parts) > 1:
        every = {name: _stacked([part[name] for part, _ in parts]) for name in every}

    def show() -> answer.Result:
        all_rows = _together([rows(part.values) for part in answers])
        assumptions, notes = zip(*[part.said() for part in answers], strict=True)
        return answer.Result(
            tuple([row._replace(value=frozen(row.value)) for row in all_rows]),
            tuple(dict.fromkeys(chain(*assumptions))),
            tuple(dict.fromkeys(chain(*notes))),
            tuple(solution.steps),
            inputs,
        ).spelled(in_words)

    waiting = [value.name for value in solution.values if value.is_on_request]
    later = {keyword(name): partial(_on_request, again, name) for name in waiting if again}
    return Result(command, show, every, names, ask, solved, later)


def _on_request(again: Callable[[str], Answer], name: str) -> Any:
    value = next(value for value in again(name).values if value.name == name)
    if value.because:
        raise MissingResult(value.because.message, value.because.hint)
    return _quantity(value)


def _quantity(value: answer.Value) -> Any:
    unit = unit_for(value, "1" if value.name in READINGS else value.units[0])
    unit = cast("ScaleUnit", unit).unit if unit.is_scale else unit
    return quantity(in_unit(value, unit), unit)


def _stacked(quantities: list[Any]) -> Any:
    stacked = Quantity.from_list(quantities)
    return Quantity(frozen(stacked.magnitude), stacked.units)


def _together(tables: Sequence[Sequence[Row]]) -> tuple[Row, ...]:
    if len(tables) == 1:
        return tuple(tables[0])
    import numpy

    return tuple(
        same[0]._replace(value=numpy.stack([row.value for row in same]))
        for same in zip(*tables, strict=True)
    )


def _quantities(solution: Answer) -> tuple[dict[str, Any], list[str]]:
    """Return the results by all of their names, and the shown name of each."""
    first: dict[str, Any] = {}
    aliases: dict[str, dict[str, Any]] = {}
    shown: dict[str, None] = {}
    for value in solution.values:
        name, also = keyword(value.name), keyword(value.also)
        if value.is_absent:
            continue
        result = _quantity(value)
        in_kind = keyword(name_in(value, value.dimensions[0]))
        first.setdefault(name, result)
        first.setdefault(in_kind, result)
        shown.setdefault(in_kind)
        if also:
            aliases.setdefault(also, {}).setdefault(name, result)
    single = {also: next(iter(of.values())) for also, of in aliases.items() if len(of) == 1}
    return {**first, **single, **first}, [*shown]  # a first name comes before an alias
