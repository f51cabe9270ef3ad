"""Lists to look things up in: typical values, and tasks with their commands."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple, TypeVar

from radcalc.api.arguments import Quantity, as_text, is_quantity, quantity, require_texts
from radcalc.api.refusals import in_python
from radcalc.quantities.typical import FIELDS, how_far
from radcalc.quantities.typical import search as values_for
from radcalc.quantities.typical_values import Typical
from radcalc.sentences.tasks import Task
from radcalc.sentences.tasks import search as tasks_for
from radcalc.units.unit import unit_behind

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
