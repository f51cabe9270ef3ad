"""What an answer is, before anybody renders it: it knows no terminal and no format."""

from collections.abc import Sequence
from typing import Any


class Step:
    """One step of a derivation: the law in symbols, then in numbers, and where it comes from."""

    __slots__ = ("formula", "law", "numbers", "reference")

    def __init__(self, law: str, formula: str, numbers: str, reference: str = "") -> None:
        """Hold the texts; `numbers` is the formula with the numbers and units put in."""
        self.law = law
        self.formula = formula
        self.numbers = numbers
        self.reference = reference


class Row:
    """One value of an answer; `case` says which of several answers it belongs to.

    `name` is what `--get` calls a calculator's result; a conversion has none.  `given` tells
    what the user gave from what follows.
    """

    __slots__ = ("case", "given", "name", "quantity", "symbol", "unit", "value")

    def __init__(
        self,
        quantity: str,
        symbol: str,
        value: Any,
        unit: str,
        case: str = "",
        name: str = "",
        given: bool = False,
    ) -> None:
        """Hold one value in its unit."""
        self.name = name
        self.given = given
        self.quantity = quantity
        self.symbol = symbol
        self.value = value
        self.unit = unit
        self.case = case


class Result:
    """Rows, what was assumed, what should be noted, and the steps of the derivation."""

    __slots__ = ("assumptions", "notes", "rows", "steps")

    def __init__(
        self,
        rows: tuple[Row, ...],
        assumptions: tuple[str, ...] = (),
        notes: tuple[str, ...] = (),
        steps: tuple[Step, ...] = (),
    ) -> None:
        """Hold an answer."""
        self.rows = rows
        self.assumptions = assumptions
        self.notes = notes
        self.steps = steps


def columns(results: Sequence[Result]) -> list[tuple[str, str]] | None:
    """The name and unit of each row where several answers of a calculator have the same rows.

    Such answers are shown one a line: for plotting, or to be compared.
    """
    if len(results) < 2:
        return None
    heads = [[(row.name, row.unit) for row in result.rows] for result in results]
    same = all(head == heads[0] for head in heads) and all(name for name, _ in heads[0])
    return heads[0] if same else None


class Value:
    """One result of a calculator, in coherent SI units, with the units it is shown in.

    `dimensions` are those of the units in which it may be asked for; the first is its own.  The
    value may be a function, which is called when it is first looked at.  `reach` has the same
    thing of other kinds, by their dimensions, where the conditions link them.  `given` says
    the number that the user gave, in the first of the units; `also` is another name that --get
    takes.
    """

    __slots__ = (
        "_si",
        "also",
        "dimensions",
        "given",
        "label",
        "name",
        "reach",
        "symbol",
        "units",
    )

    def __init__(
        self,
        name: str,
        label: str,
        symbol: str,
        si: Any,
        dimensions: tuple[tuple[int, ...], ...],
        units: tuple[str, ...],
        reach: dict[tuple[int, ...], float] | None = None,
        given: Any = None,
        also: str = "",
    ) -> None:
        """Hold a result: `name` is what --get takes, `label` what a table shows."""
        self.given = given
        self.also = also
        self.name = name
        self.label = label
        self.symbol = symbol
        self._si = si
        self.dimensions = dimensions
        self.units = units
        self.reach = reach or {}

    @property
    def si(self) -> Any:
        """The value in coherent SI units."""
        if callable(self._si):
            self._si = self._si()
        return self._si


# What a calculator gives: values, assumptions, notes, steps.
Answer = tuple[list[Value], list[str], list[str], list[Step]]
