"""What an answer is, before anybody renders it: it knows no terminal and no format."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from radcalc.errors import RadcalcError
from radcalc.units.table import Dimension


class Step(NamedTuple):
    """One step of a derivation: the law in symbols, then in numbers, and where it comes from."""

    law: str
    formula: str
    numbers: str
    reference: str = ""


class Row(NamedTuple):
    """One value of an answer; `case` says which of several answers it belongs to.

    `name` is what `--get` calls a calculator's result; a conversion has none.  `given` tells
    what the user gave from what follows.
    """

    quantity: str
    symbol: str
    value: Any
    unit: str
    case: str = ""
    name: str = ""
    given: bool = False


class Result(NamedTuple):
    """Rows, what was assumed, what should be noted, and the steps of the derivation."""

    rows: tuple[Row, ...]
    assumptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()

    def spelled(self, spell: Callable[[str], str]) -> "Result":
        """The same with the symbols that its texts mention spelled as a gate spells them."""
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

    @property
    def amount(self) -> Any:
        """The value in coherent SI units."""
        return self.si() if callable(self.si) else self.si

    @property
    def is_absent(self) -> bool:
        """Whether it does not follow from what is given."""
        return self.lacking is not None or self.because is not None


class Answer(NamedTuple):
    """What a calculator gives; `more` are the other answers, where several fit what is given."""

    values: Sequence[Value]
    assumptions: Sequence[str] = ()
    notes: Sequence[str] = ()
    steps: Sequence[Step] = ()
    more: "Sequence[Answer]" = ()


def columns(results: Sequence[Result]) -> list[tuple[str, str]] | None:
    """The name and unit of each row where several answers of a calculator have the same rows.

    Such answers are shown one a line: for plotting, or to be compared.
    """
    if len(results) < 2:
        return None
    heads = [[(row.name, row.unit) for row in result.rows] for result in results]
    same = all(head == heads[0] for head in heads) and all(name for name, _ in heads[0])
    return heads[0] if same else None
