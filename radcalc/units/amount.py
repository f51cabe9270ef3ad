"""A number with a unit."""

from radcalc.units.unit import Unit

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from typing import Any

    from radcalc.units.parts import Part


class Amount:
    """A number in a unit, as somebody typed it.

    `unit` is None for a bare number; `uncertainty` is the standard uncertainty in the unit, and 0
    where none was given; `assumptions` say how the text was read, where that takes a word.  A
    `reading` on a `scale` is kept beside the number that it stands for.  `rounding` is how far an
    expression may be off as typed, relative to it; None for what is none.  `parts` are what
    follows of each uncertain number of an expression, or of the reading.
    """

    __slots__ = (
        "assumptions",
        "number",
        "parts",
        "reading",
        "rounding",
        "scale",
        "text",
        "uncertainty",
        "unit",
    )

    def __init__(
        self,
        text: str,
        number: float,
        unit: Unit | None,
        uncertainty: float = 0.0,
        assumptions: tuple[str, ...] = (),
        scale: "Any" = None,
        reading: float = 0.0,
        rounding: float | None = None,
        parts: "tuple[Part, ...]" = (),
    ) -> None:
        """Hold what `text` says."""
        self.text = text
        self.number = number
        self.unit = unit
        self.uncertainty = uncertainty
        self.assumptions = assumptions
        self.scale = scale
        self.reading = reading
        self.rounding = rounding
        self.parts = parts

    @property
    def typed(self) -> tuple[float, Unit | None]:
        """The number and the unit that were typed, or the reading and its scale."""
        return (self.reading, self.scale) if self.scale else (self.number, self.unit)

    @property
    def is_uncertain(self) -> bool:
        """Check whether it has an uncertainty, of which a flat expression may leave nothing."""
        return bool(self.uncertainty or self.parts)

    @property
    def typed_uncertainty(self) -> float:
        """The uncertainty of the number that was typed."""
        if self.scale:
            return self.uncertainty / float(abs(self.scale.slope(self.reading)))
        return self.uncertainty

    def __repr__(self) -> str:
        """Show the text."""
        return f"Amount({self.text!r})"
