"""What an answer is, before anybody renders it: it knows no terminal and no format."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from radcalc.errors import RadcalcError
from radcalc.maths import is_array
from radcalc.units.unit import Dimension


class Step(NamedTuple):
    """One step of a derivation: the law in symbols, then in numbers, and where it comes from."""

    law: str
    formula: str
    numbers: str
    reference: str = ""


class ShownInput(NamedTuple):
    """What somebody gave: a number in a unit, a text that is none, or True for a flag.

    `uncertainty` is the standard one of the number, in the unit.  What `tells` an answer from
    others is shown with it even if it is the only one: the day of a log.
    """

    name: str
    value: Any = None
    unit: str = ""
    text: str = ""
    uncertainty: float = 0.0
    tells: bool = False

    @property
    def is_quantity(self) -> bool:
        """Check whether it is a number in a unit."""
        return bool(self.unit)


def texts_of(texts: Mapping[str, str]) -> tuple[ShownInput, ...]:
    """Inputs that are texts, but for empty ones."""
    return tuple(ShownInput(name, text=text) for name, text in texts.items() if text)


FRACTION = "fraction"  # of a second, as the times of a shutter are marked: 1/60


class Row(NamedTuple):
    """One value of an answer; `case` says which of several answers it belongs to.

    `name` is what `--get` calls the result.  `given` tells what the user gave from what follows;
    `uncertainty` is the standard one, in the unit.  The `form` is how people read the number.
    """

    quantity: str
    symbol: str
    value: Any
    unit: str
    case: str = ""
    name: str = ""
    given: bool = False
    uncertainty: float = 0.0
    form: str = ""


class Result(NamedTuple):
    """One answer: its rows, what was assumed and noted, the derivation, and what was given.

    A conversion has one result, whose name goes without saying where people read it: it is not
    `named`.
    """

    rows: tuple[Row, ...]
    assumptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()
    inputs: tuple[ShownInput, ...] = ()
    named: bool = True

    def spelled(self, spell: Callable[[str], str]) -> "Result":
        """Return the same with the symbols that its texts mention spelled as a gate spells them."""
        return self._replace(
            assumptions=tuple(map(spell, self.assumptions)), notes=tuple(map(spell, self.notes))
        )


ALONE: dict[Dimension, Any] = {}


class Value(NamedTuple):
    """One result of a calculator, in coherent SI units, with the units it is shown in.

    `dimensions` are those of the units in which it may be asked for; the first is its own.  `si`
    may be a function, where working it out is worth waiting until it is looked at.  `reach` has
    the same thing of other kinds, by their dimensions, where the conditions link them.  `given`
    is the number that the user gave, in the first of the units; `also` is another name of it.
    `exact` is the number in that unit where it is known so, and not by way of SI units.
    Where what was given is uncertain, the numbers are those of the `uncertainties` package.
    The `form` is how people read them.
    A result that does not follow has no units; `lacking` tells in words what would do, or
    `because` why none would.
    """

    name: str
    label: str
    letter: str
    si: Any
    dimensions: tuple[Dimension, ...]
    units: tuple[str, ...]
    reach: dict[Dimension, Any] = ALONE
    given: Any = None
    also: str = ""
    lacking: Callable[[], str] | None = None
    because: RadcalcError | None = None
    exact: Any = None
    form: str = ""

    @property
    def in_first(self) -> Any:
        """The number in the first of the units, as it was typed or is known; None elsewhere."""
        return self.exact if self.given is None else self.given

    @property
    def amount(self) -> Any:
        """The value in coherent SI units."""
        return self.si() if callable(self.si) else self.si

    @property
    def is_absent(self) -> bool:
        """Check whether it does not follow from what is given."""
        return self.lacking is not None or self.because is not None


class Answer(NamedTuple):
    """What a calculator gives; `more` are the other answers, where several fit what is given."""

    values: Sequence[Value]
    assumptions: Sequence[str] = ()
    notes: Sequence[str] = ()
    steps: Sequence[Step] = ()
    more: "Sequence[Answer]" = ()


def varying(inputs: Sequence[Sequence[ShownInput]]) -> list[str]:
    """Return the names of the inputs that are not the same in all answers, and of arrays.

    And of those that tell an answer from others, of which there may be none.
    """
    by_name = [{shown_input.name: shown_input for shown_input in group} for group in inputs]
    names = dict.fromkeys(name for group in by_name for name in group)
    return [
        name
        for name in names
        if any(_differ(group.get(name), by_name[0].get(name)) for group in by_name)
    ]


def _differ(first: ShownInput | None, second: ShownInput | None) -> bool:
    if first is None or second is None:
        return first is not second
    return first.tells or is_array(first.value) or is_array(second.value) or first != second


def shows(row: Row, name: str) -> bool:
    """Check whether a row has what was given under a name."""
    return row.given and name in (row.name, row.quantity.replace(" ", "-"))
