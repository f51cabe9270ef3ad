"""What an answer is, before anybody renders it: it knows no terminal and no format."""

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
    """One value of an answer; `case` says which of several answers it belongs to."""

    __slots__ = ("case", "quantity", "symbol", "unit", "value")

    def __init__(self, quantity: str, symbol: str, value: Any, unit: str, case: str = "") -> None:
        """Hold one value in its unit."""
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
