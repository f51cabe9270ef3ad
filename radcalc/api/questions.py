"""Sentences and their answers, checks of answers, and lists to look things up in."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple, TypeVar

from radcalc.answer import Row, Value
from radcalc.api.arguments import Quantity, as_text, is_quantity, quantity, require_texts
from radcalc.api.keywords import Scalar
from radcalc.api.refusals import call_function, in_python
from radcalc.api.result import Result, question_of
from radcalc.api.spelling import in_words, keyword
from radcalc.conversion.operands import read_operands
from radcalc.conversion.plan import target_of
from radcalc.errors import ConditionError, RadcalcError, SeveralReadings, UsageError, input_of
from radcalc.homework.verdict import Verdict as Judged
from radcalc.quantities.lookup import FIELDS, Typical, how_far
from radcalc.quantities.lookup import search_typical as values_for
from radcalc.quantities.symbols import article
from radcalc.render.formats import Judgement, Style
from radcalc.render.plain import verdict as words_of
from radcalc.sentences.calls import call_of
from radcalc.sentences.reader import read
from radcalc.sentences.tasks import Task
from radcalc.sentences.tasks import search as tasks_for
from radcalc.units import unit_behind
from radcalc.units.numbers import is_sentence


@in_python
def ask(sentence: str) -> Result | Quantity:
    """Answer a sentence, such as ``"20000 cd at 8 m to lx"``.

    Parameters
    ----------
    sentence : str
        Amounts, their places and a target, as at a shell (radcalc-sentences(7)).

    Returns
    -------
    Result or Quantity
        The result that the sentence asks for; without a target, all results.

    Raises
    ------
    radcalc.RadcalcError
        If words are not understood, if the sentence has several readings, or as in the function
        that it means.

    Examples
    --------
    >>> print(ask("20000 cd at 8 m to lx"))
    312.5 lux
    """
    require_texts(sentence=sentence)
    command, *words = _conversion(sentence) or call_of(read([sentence]))
    if command == "convert":
        operands = [text for name, text in map(input_of, words) if not name]
        amount, target = read_operands(operands)
        unit = amount.unit.text if amount.unit else "1"
        words = [amount.text, target or unit, *words[len(operands) :]]
    try:
        answer: Result | Quantity = call_function((command, *words), in_core=False)
    except (LookupError, TypeError) as error:  # no function, no such result, or more is needed
        problem = str(error) or f"{command} is not a function of Python"
        raise UsageError(problem, "the same sentence at a shell") from None
    return answer


def _conversion(line: str) -> list[str]:
    """Return the call of a line that is a conversion or an amount, as at a shell; or []."""
    if not is_sentence(line.split()):
        return []
    try:
        amount, target = read_operands([line])
        if target:
            target_of(target, amount.unit)
    except SeveralReadings:
        raise
    except RadcalcError:
        return []
    if amount.unit is None:
        return []
    return ["convert", amount.text, *(["to", target] if target else [])]


class Verdict(Judged):
    """The judgement of an answer; true if it is right.

    Examples
    --------
    >>> import radcalc
    >>> verdict = check(radcalc.explain("500 lx", "cd/m2", reflectance=0.8), "400")
    >>> bool(verdict), verdict.diagnoses[0].done
    (False, 'pi was forgotten')
    """

    __slots__ = ()

    def __bool__(self) -> bool:
        """Return whether the answer is right."""
        return self.right

    def __repr__(self) -> str:
        """Return the judgement and the likely mistakes as text."""
        row = Row(self.name, "", self.value, self.unit)
        return words_of(Judgement(self, row, (), (), ()), Style()).rstrip()


@in_python
def check(result: Result, claim: Scalar, tolerance: Scalar | None = None) -> Verdict:
    """Check an answer against a result, and name the mistakes that lead to it.

    Parameters
    ----------
    result : Result
        The result of a calculator, or of `explain` for a conversion.
    claim : str, Quantity or float
        The answer: ``"16 lx"``, ``"illuminance=16 lx"`` for a certain result, or a bare number
        if it is unambiguous.  A name may have hyphens or underscores.
    tolerance : str, Quantity or float, optional
        ``"1%"`` (the default), ``"0.5 lx"``, or ``"3sf"`` (3 significant digits); a bare number
        is a fraction of the right value.

    Returns
    -------
    Verdict
        True or false (also `right`), with the right `value` in its `unit`, the `ratio` of the
        answer to it, and the `diagnoses`: each has a `mistake` that reproduces the number, what
        was `done`, the `right` rule, and in `yours` the first wrong step in your numbers.

    Raises
    ------
    radcalc.RadcalcError
        If the answer is invalid or ambiguous, or the result has arrays.

    Examples
    --------
    >>> import radcalc
    >>> cone = radcalc.solid_angle("cone", half_angle="30 deg")
    >>> check(cone, "0.842 sr")
    right (within 1%): solid-angle is 0.841787214477 sr
    """
    from radcalc.homework import check as judge

    if not isinstance(result, Result):
        problem = f"{article(type(result).__name__)} is not a result to check"
        raise ConditionError(problem, "radcalc.explain, or a calculator's function")
    allowed = None if tolerance is None else as_text(tolerance)
    question = question_of(result)
    judgement = judge(question, _as_named(as_text(claim), question.answer.values), allowed)
    return Verdict(*judgement._replace(diagnoses=tuple(map(_in_python, judgement.diagnoses))))


def _as_named(claim: str, values: Sequence[Value]) -> str:
    name, equals, claimed = claim.partition("=")
    names = {keyword(known): known for value in values for known in (value.name, value.also)}
    return f"{names.get(keyword(name.strip()), name)}{equals}{claimed}" if equals else claim


def _in_python(diagnosis: Any) -> Any:
    return diagnosis._replace(done=in_words(diagnosis.done), right=in_words(diagnosis.right))


T = TypeVar("T")


class Listing(tuple[T, ...]):
    """Rows found by a search: a tuple that is shown as text, with notes on the search."""

    notes: tuple[str, ...]

    def __new__(cls, rows: Iterable[T], notes: Iterable[str] = ()) -> Listing[T]:
        """Return the rows with their notes."""
        listing = super().__new__(cls, rows)
        listing.notes = tuple(notes)
        return listing

    def __repr__(self) -> str:
        """Return the texts of the rows, then the notes."""
        return "\n".join([*map(str, self), *(f"note: {note}" for note in self.notes)])


class TypicalValue(NamedTuple):
    """A typical value with its source.

    `value` is the text of a number or a range in `unit`.  `low` and `high` are its ends:
    quantities, or bare readings on a scale.
    """

    what: str
    quantity: str
    value: str
    unit: str
    source: str
    note: str
    low: Quantity | float
    high: Quantity | float

    def __str__(self) -> str:
        """Return the value in a line."""
        return f"{self.what}: {self.quantity} {self.value}{unit_behind(self.unit)} ({self.source})"


@in_python
def typical(search: str | Quantity = "") -> Listing[TypicalValue]:
    """List typical values: sun, sky, rooms, lamps, screens, plants, with sources.

    Parameters
    ----------
    search : str, optional
        A subject (``"office"``), a quantity (``"illuminance"``) or a unit, in English, Czech or
        Russian, or a value, for those nearest to it (``"500 lx"``); all values by default.

    Returns
    -------
    Listing of TypicalValue
        A tuple of named tuples: `what` the value is of, its `quantity`, `value` and `unit`, its
        ends `low` and `high` as quantities, its `source`, and a `note`.

    Raises
    ------
    radcalc.RadcalcError
        If nothing is found.

    Examples
    --------
    >>> print(typical("office")[0].low.to("fc").round(1))
    46.5 footcandle
    """
    if not is_quantity(search):
        require_texts(search=search)
    text = as_text(search)
    found = values_for(text)
    far = how_far(text, found)
    return Listing(map(_typical_value, found), [far] if far else [])


def _typical_value(value: Typical) -> TypicalValue:
    unit = value.measured
    low, high = (end if unit.is_scale else quantity(end, unit) for end in (value.low, value.high))
    texts = {field: getattr(value, field) for field in FIELDS}
    return TypicalValue(**texts, low=low, high=high)


@in_python
def examples(search: str = "") -> Listing[Task]:
    """List tasks with the commands that answer them, and how to read the answers.

    Parameters
    ----------
    search : str, optional
        Words that a task mentions: a trade (``"museum"``), a quantity; all tasks by default.

    Returns
    -------
    Listing of Task
        A tuple of named tuples: the `trade`, the `title`, the `question`, the `calls`, each with
        its `command` at a shell and the lines of its `output`, and how to read them (`reading`).

    Raises
    ------
    radcalc.RadcalcError
        If nothing is found.

    Examples
    --------
    >>> [task.title for task in examples("museum log")]
    ['A log']
    """
    require_texts(search=search)
    return Listing(tasks_for(search))
