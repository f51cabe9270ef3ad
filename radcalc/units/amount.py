"""A number with a unit."""

from radcalc.units.unit import Unit

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from typing import Any

    from radcalc.units.slopes import Part


class Amount:
    """A number in a unit, as the user typed it.

    `unit` is None for a bare number; `uncertainty` is the standard uncertainty in the unit, 0 if
    none was given; `assumptions` explain how the text was read, if that needs an explanation.  A
    `reading` on a `scale` is kept together with the number that it represents.  `rounding` is the
    relative rounding error of a typed expression, None for other texts.  `parts` are the
    contributions of the uncertain numbers of an expression, or of the reading.  `ratio` is the
    number of an expression, which `number` rounds.
    """

    __slots__ = (
        "assumptions",
        "number",
        "parts",
        "ratio",
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
        ratio: "tuple[int, int] | None" = None,
    ) -> None:
        self.text = text
        self.number = number
        self.unit = unit
        self.uncertainty = uncertainty
        self.assumptions = assumptions
        self.scale = scale
        self.reading = reading
        self.rounding = rounding
        self.parts = parts
        self.ratio = ratio

    @property
    def typed(self) -> tuple[float, Unit | None]:
        return (self.reading, self.scale) if self.scale else (self.number, self.unit)

    @property
    def exact(self) -> float:
        """The typed number or reading, with its ratio if the text has one."""
        if self.scale:
            return self.reading
        from radcalc.floats import Typed
        from radcalc.units.numbers import exactly

        return Typed(self.number, self.ratio) if self.ratio else exactly(self.text, self.number)

    @property
    def is_uncertain(self) -> bool:
        """Return whether it is uncertain, even if a flat expression reduces that to 0."""
        return bool(self.uncertainty or self.parts)

    @property
    def typed_uncertainty(self) -> float:
        if self.scale:
            return self.uncertainty / float(abs(self.scale.slope(self.reading)))
        return self.uncertainty

    def __repr__(self) -> str:
        """Show the text."""
        return f"Amount({self.text!r})"
