"""What a function gives: quantities by name, and everything that is said of them."""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from radcalc import answer
from radcalc.answer import Answer, Input, Row, Step
from radcalc.api.drawing import Drawing
from radcalc.api.quantity import Quantity, is_lazy, magnitude_of, quantity, unit_of
from radcalc.api.spelling import in_python, in_words, keyword, symbol_name
from radcalc.calculators.results import in_unit, name_of, rows
from radcalc.errors import ConditionError, RadcalcError, nearest, quote
from radcalc.given import Inputs
from radcalc.maths import is_column
from radcalc.units.scales import in_which
from radcalc.units.table import resolve

if TYPE_CHECKING:
    from radcalc.api.columns import Columns
    from radcalc.homework.question import Question

Told = Callable[[], answer.Result]
Drawn = tuple[Inputs, Answer, Any]  # with what a picture takes beside the inputs


class Undrawn(NamedTuple):
    """Why a result has no picture, and what has."""

    problem: str
    hint: str


class MissingResult(RadcalcError, KeyError, AttributeError):
    """A name that no result has, behind a dot or in brackets."""


class Result(Mapping[str, Quantity]):
    """What was given and what follows: quantities by the names of results.

    They are attributes and items, by the names that ``radcalc -g`` takes; those of attributes
    have underscores for hyphens, and those of items either: ``r["solid-angle"]``.  Of a light
    quantity ``r.irradiance`` is also ``r.illuminance``, as its kind is called.  A value that
    is an array is an array in every quantity that depends on it; where columns of pandas, Polars
    or xarray were given, these are columns too.

    Attributes
    ----------
    command : str
        The calculator.
    inputs : tuple of radcalc.answer.Input
        What was given, as it was typed.
    rows : tuple of radcalc.answer.Row
        The results with their labels, symbols and units, in all the units that the calculator
        shows.
    assumptions, notes : tuple of str
        What was assumed, and what is to be said besides.
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
        told: Told,
        found: Mapping[str, Any],
        others: Mapping[str, Any],
        ask: "Callable[[], Question] | None",
        solved: Drawn | Undrawn,
    ) -> None:
        self.command = command
        self._told = told
        self._found = dict(found)
        self._others = dict(others)
        self._ask = ask
        self._solved = solved

    def __getitem__(self, name: str) -> Quantity:
        """A result by its name, or by another name that it has; hyphens are underscores."""
        every, called = self.every, keyword(str(name))
        if called not in every:
            near = ", ".join(nearest(called, every, 3) or self._found)
            raise MissingResult(f"there is no result '{quote(str(name))}'", near)
        return every[called]  # type: ignore[no-any-return]

    def __iter__(self) -> Iterator[str]:
        """The names of the results, each once."""
        return iter(self._found)

    def __len__(self) -> int:
        """How many results there are."""
        return len(self._found)

    def __getattr__(self, name: str) -> Quantity:
        """A result by any of its names."""
        if name.startswith("_"):
            raise AttributeError(name, name=name, obj=self)
        return self[name]

    def __eq__(self, other: object) -> bool:
        """Whether another has the same results: those of arrays, where every element is equal."""
        if not isinstance(other, Mapping):
            return NotImplemented
        return len(self) == len(other) and all(
            name in other and _is_same(one, other[name]) for name, one in self.items()
        )

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        """What pickle keeps: all that is shown, without what works it out anew."""
        return _restored, (self.command, self._shown, self._found, self._others)

    def __dir__(self) -> list[str]:
        """The results, by all of their names, among the rest."""
        return [*super().__dir__(), *self.every]

    def _ipython_key_completions_(self) -> list[str]:
        """What IPython completes behind a bracket."""
        return [*self.every]

    def __repr__(self) -> str:
        """The results, what was assumed and noted."""
        from radcalc.render.notebook import text

        return text(self.command, self._shown)

    def _repr_html_(self) -> str:
        """The same for a notebook, with what was given and the derivation."""
        from radcalc.render.notebook import html

        return html(self.command, self._shown)

    @property
    def _shown(self) -> answer.Result:
        """The answer as a renderer takes it."""
        told = self._told()
        self._told = lambda: told
        return told

    @property
    def inputs(self) -> tuple[Input, ...]:
        """What was given."""
        return self._shown.inputs

    @property
    def rows(self) -> tuple[Row, ...]:
        """The results with their labels, symbols and units."""
        return self._shown.rows

    @property
    def assumptions(self) -> tuple[str, ...]:
        """What was assumed."""
        return self._shown.assumptions

    @property
    def notes(self) -> tuple[str, ...]:
        """What is to be said besides."""
        return self._shown.notes

    @property
    def steps(self) -> tuple[Step, ...]:
        """The derivation."""
        return self._shown.steps

    def to_dict(self) -> dict[str, Any]:
        """Everything in the schema of ``--json --steps``; the values of arrays are lists.

        Returns
        -------
        dict
            With ``command``, ``inputs``, ``results``, ``assumptions``, ``notes``, ``steps`` and
            ``check``, of texts, numbers, lists and dicts alone.

        Raises
        ------
        radcalc.ConditionError
            For what Dask has not computed yet.
        """
        from radcalc.render.formats import Style
        from radcalc.render.json import results

        told = self._shown
        listed = told._replace(
            rows=tuple(one._replace(value=_listed(one.value)) for one in told.rows),
            inputs=tuple(_told_as_list(one) for one in told.inputs),
        )
        made: dict[str, Any] = json.loads(results([listed], Style(command=self.command)))
        return made

    def plot(self, *wanted: str) -> Drawing:
        """Draw the answer, or what follows over an array that was given.

        Parameters
        ----------
        *wanted : str
            The results to be drawn over an array, by their names: ``"illuminance:fc"``; the one
            that the calculator is about by default.  A single answer's picture is its own: of
            these, a point source's intensity alone may be named, with a unit.

        Returns
        -------
        Drawing
            Which a notebook shows, and which `save` writes; it takes ``radcalc[plot]``.

        Raises
        ------
        radcalc.RadcalcError
            If there is nothing to be drawn.
        """
        return _drawing(self, self._solved, wanted)

    @property
    def question(self) -> "Question":
        """What was asked, which `radcalc.check` judges answers to."""
        if self._ask is None:
            problem = "there are several answers, and one is checked"
            raise ConditionError(problem, "one value of each")
        return self._ask()

    @property
    def every(self) -> dict[str, Any]:
        """The results by all of their names."""
        return {**self._found, **self._others}

    def in_columns(self, columns: "Columns | None") -> "Result":
        """The same with columns for the arrays, where some were given."""
        if columns is None:
            return self
        found = {name: columns.result(name, one) for name, one in self._found.items()}
        others = {name: columns.result(name, one) for name, one in self._others.items()}
        return Result(self.command, self._told, found, others, None, self._solved)

    def waiting(self, results: Mapping[str, Any]) -> "Result":
        """The same with other results, as those of which Dask has not computed the values."""

        def told() -> answer.Result:
            shown = self._shown
            rows = [_with_value(row, results) for row in shown.rows]
            return shown._replace(rows=tuple(row for row in rows if row), steps=())

        found = {name: results[name] for name in self._found}
        others = {name: results[name] for name in self._others}
        waits = Undrawn("what Dask has not computed is not drawn", "the same of NumPy's arrays")
        return Result(self.command, told, found, others, None, waits)


def _is_same(one: Any, other: Any) -> bool:
    """Whether two quantities, or two columns, are equal in every element."""
    if hasattr(one, "equals"):  # a column of pandas, Polars or xarray
        return type(one) is type(other) and bool(one.equals(other))
    sizes = (getattr(magnitude_of(each), "shape", ()) for each in (one, other))
    same = one == other if len({*sizes}) == 1 else False
    return bool(same.all() if hasattr(same, "all") else same)


def _restored(
    command: str, shown: answer.Result, found: Mapping[str, Any], others: Mapping[str, Any]
) -> Result:
    """A result that pickle kept."""

    problem = "a result that was pickled is not worked out anew"

    def ask() -> "Question":
        raise ConditionError(problem, "radcalc.check of what the function gives")

    undrawn = Undrawn(problem, ".plot() of what the function gives")
    return Result(command, lambda: shown, found, others, ask, undrawn)


def _with_value(row: Row, results: Mapping[str, Any]) -> Row | None:
    """A row with the value of its result; None in another unit than that has."""
    found = results[keyword(row.name)]
    if not is_column(row.value):
        return row
    if resolve(row.unit).dimension != unit_of(found).dimension:
        return None
    return row._replace(value=found.to(row.unit).magnitude)


@in_python
def _drawing(result: Result, solved: Drawn | Undrawn, wanted: tuple[str, ...]) -> Drawing:
    if isinstance(solved, Undrawn):
        raise ConditionError(*solved)
    from radcalc.plots.answers import depends, picture
    from radcalc.plots.curves import Solved

    inputs, found, beside = solved
    one = Solved(inputs, found)
    for name in wanted:
        result[keyword(name_of(name))]
        if not depends(result.command, one, symbol_name(name)):
            problem = f"the picture of a single answer here does not depend on {quote(name)}"
            raise ConditionError(problem, ".plot(), or an array of values, over which it follows")
    return Drawing(picture(result.command, [one], [*map(symbol_name, wanted)], beside))


def _listed(value: Any) -> Any:
    """An array as lists."""
    if is_lazy(value):
        raise ConditionError("a result of Dask's is not there yet", ".compute() of its magnitude")
    return value.tolist() if hasattr(value, "tolist") else value


def _told_as_list(one: Input) -> Input:
    return one._replace(value=one.value.tolist(), text="") if is_column(one.value) else one


def of_answer(
    command: str,
    found: Answer,
    inputs: tuple[Input, ...],
    ask: "Callable[[], Question] | None",
    solved: Drawn | Undrawn,
) -> Result:
    """The result of a calculator, each quantity in the first unit it is shown in."""
    answers = (found, *found.more)
    parts = [_quantities(one) for one in answers]
    first, others = parts[0]
    if len(parts) > 1:
        first = {n: Quantity.from_list([one[n] for one, _ in parts]) for n in first}
        others = {n: Quantity.from_list([one[n] for _, one in parts]) for n in others}

    def told() -> answer.Result:
        return answer.Result(
            _together([rows(one.values) for one in answers]),
            tuple(dict.fromkeys(text for one in answers for text in one.assumptions)),
            tuple(dict.fromkeys(text for one in answers for text in one.notes)),
            tuple(found.steps),
            inputs,
        ).spelled(in_words)

    return Result(command, told, first, others, ask, solved)


def _together(each: Sequence[Sequence[Row]]) -> tuple[Row, ...]:
    """The rows of several answers as one, whose values are arrays of theirs."""
    if len(each) == 1:
        return tuple(each[0])
    import numpy

    return tuple(
        same[0]._replace(value=numpy.stack([row.value for row in same]))
        for same in zip(*each, strict=True)
    )


def _quantities(found: Answer) -> tuple[dict[str, Any], dict[str, Any]]:
    """The results by their names, and by other names that they have, as of one kind of light."""
    first: dict[str, Any] = {}
    others: dict[str, Any] = {}
    for value in found.values:
        name, also = keyword(value.name), keyword(value.also)
        if value.is_absent:
            continue
        unit = in_which(value.units[0], value.dimensions)
        made = quantity(in_unit(value, unit), unit)
        first.setdefault(name, made)
        if also:
            others.setdefault(also, made)
    return first, {name: one for name, one in others.items() if name not in first}
