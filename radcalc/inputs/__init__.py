"""Inputs: the values of symbols, read and checked against limits.

This module has inputs, and functions that choose and check them.
"""

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from radcalc import maths
from radcalc.answer import ShownInput, format_number
from radcalc.errors import ConditionError, Exclusive, Impossible, MissingInput, option, quote
from radcalc.maths import SLACK
from radcalc.quantities import symbols
from radcalc.tuples import NamedTuple
from radcalc.units import NUMBER, Dimension, Unit
from radcalc.units.numbers import rounding

if TYPE_CHECKING:
    from radcalc.units.functions import Part


class DigitsMatter(Exception):
    """Raised if an answer depends on the typed digits of each number of an array."""


class Input(NamedTuple):
    """A given value: the symbol, the text as typed, the value in SI units.

    `number` and `unit` are as typed (on a scale, a reading and a `ScaleUnit`); `is_exact` marks a
    Python number, which has no text.  `uncertainty` is the standard uncertainty in SI units, and
    `variable` its number of the `uncertainties` package; `assumptions` describe the reading of the
    text.  `off` is the relative rounding error of an expression, and `parts` are the contributions
    of its uncertain numbers, or of a reading, in `unit`.
    """

    symbol: symbols.Symbol
    text: str
    value: Any
    dimension: Dimension = NUMBER
    number: Any = None
    unit: Unit | None = None
    is_exact: bool = False
    uncertainty: float = 0.0
    assumptions: tuple[str, ...] = ()
    variable: Any = None
    off: float | None = None
    parts: "tuple[Part, ...]" = ()

    @property
    def name(self) -> str:
        return self.symbol.name

    @property
    def is_uncertain(self) -> bool:
        """Return whether the input is uncertain, also with a slope of 0."""
        return bool(self.uncertainty or self.parts)

    @property
    def unit_text(self) -> str:
        """Return the unit as typed; 1 for a bare number."""
        return self.unit.text if self.unit else "1"

    def text_where(self, condition: Any) -> str:
        """Return the text; for an array, that of the elements for which a condition holds."""
        if not maths.is_array(self.number):
            return self.text
        return self.text_of(maths.chosen(self.number, condition))

    def text_of(self, numbers: Any) -> str:
        """Return the range of an array, followed by the unit as in the text."""
        range_text, unit = format_number(numbers), self.unit_text
        if self.unit is None or not self.text.endswith(unit):
            return range_text
        blank = " " if self.text.removesuffix(unit).endswith(" ") else ""
        return f"{range_text}{blank}{unit}"

    @property
    def size(self) -> float:
        """The value of a single number [SI]; for an uncertain spectrum, its parameter."""
        if self.symbol.form == symbols.SPECTRUM:
            return float(self.number * self.unit.factor if self.unit else self.number)
        return float(self.value)

    @property
    def rounding(self) -> float:
        """The relative rounding error of the value as typed; 0 for counted things.

        Raises DigitsMatter for an array of typed numbers.
        """
        if self.is_exact or self.name in COUNTS:
            return 0.0
        if maths.is_array(self.number):
            raise DigitsMatter
        if self.uncertainty:
            return abs(self.uncertainty / self.value) if self.value else 0.0
        if self.unit and self.unit.is_scale:
            off = rounding(self.text) * abs(self.number)
            slope, quantity = self.unit.slope(self.number), self.unit.quantity(self.number)
            return float(abs(off * slope / quantity))
        return rounding(self.text) if self.off is None else self.off


Inputs = dict[str, Input]
COUNTS = ("luminaires",)  # counted things, which are exact


def shown_inputs(given: Inputs) -> tuple[ShownInput, ...]:
    """Return the inputs as shown in an answer; a point by its coordinates."""
    return tuple([row for item in given.values() for row in _shown_as(item)])


def _shown_as(given: Input) -> list[ShownInput]:
    form = given.symbol.form
    if form == symbols.QUANTITY:
        off = given.uncertainty and given.uncertainty / float(
            given.unit.factor if given.unit else 1
        )
        if given.unit and given.unit.is_scale:
            off /= abs(given.unit.slope(given.number))
        return [ShownInput(given.name, given.number, given.unit_text, given.text, off)]
    if form == symbols.FLAG:
        return [ShownInput(given.name, True)]
    if given.name == "point":
        axes = zip("xyz", given.value, strict=True)
        return [ShownInput(axis, metres, "m") for axis, metres in axes]
    return [ShownInput(given.name, text=given.text)]


def any_uncertain(given: Iterable[Input]) -> bool:
    """Return whether any input is uncertain."""
    return any(item.is_uncertain for item in given)


def refuse_uncertain(given: Iterable[Input], what: str) -> None:
    """Refuse uncertain inputs if `what` does not propagate uncertainties."""
    for item in given:
        if item.is_uncertain:
            option_text = option(item.name, quote(item.text))
            problem = f"{option_text} has an uncertainty, which {what} does not propagate"
            raise ConditionError(problem, "the value alone")


def check_limits(given: Input, limits: symbols.Limits) -> None:
    """Refuse a value outside limits, and name the limit.

    If the symbol must be above 0, the message for 0 or less names that limit only.
    """
    value = given.value
    low, high = limits.low, limits.high
    below = value <= low if limits.without_low else value < low - SLACK * abs(low)
    above = value >= high if limits.without_high else value > high * (1 + SLACK)
    if below is above is False:  # the usual case
        return
    if maths.any_true(below):
        limit_text = limits.said
        if low == 0 and limits.without_low:
            limit_text = "more than 0"
        raise Impossible(given.name, given.text, limit_text, nearest=_nearest(given, low, limits))
    if maths.any_true(above):
        nearest = _nearest(given, high, limits) if not limits.without_high else ""
        raise Impossible(given.name, given.text, limits.said, nearest=nearest)


def _nearest(given: Input, bound: float, limits: symbols.Limits) -> str:
    """Return what was probably meant: a value without its sign, or a percentage; else ''."""
    if maths.is_array(given.value) or given.symbol.form != symbols.QUANTITY:
        return ""
    if bound == 0 and given.value < 0 and -given.value <= limits.high:
        return given.text.lstrip("-")
    is_percentage = limits.high == 1 and 5 <= given.value <= 100 and given.unit is None
    return f"{given.text}%" if is_percentage else ""


def require(given: Input, good: bool, limit: str) -> None:
    """Refuse a value that is not `good`, and name the limit."""
    if not good:
        raise Impossible(given.name, given.text, limit)


def split_by_light(given: Inputs) -> tuple[Inputs, Inputs, Inputs]:
    """Split inputs into light quantities, links between kinds, and the rest."""
    quantities = {n: item for n, item in given.items() if item.symbol.generic}
    links = {n: item for n, item in given.items() if n in (*symbols.LINKS, *symbols.REFINEMENTS)}
    rest = {n: item for n, item in given.items() if n not in quantities and n not in links}
    return quantities, links, rest


def any_of(inputs: Inputs, what: str, *names: str) -> Input:
    """Return the first given one of inputs, which laws compare; refuse none."""
    for name in names:
        if name in inputs:
            return inputs[name]
    examples = " or ".join(option(name, symbols.SYMBOLS[name].example) for name in names)
    raise MissingInput(f"{what} is missing", examples)


def at_most_one(inputs: Inputs, what: str, *names: str) -> Input | None:
    """Return the given one of several inputs, or None; refuse two."""
    matches = [inputs[name] for name in names if name in inputs]
    if len(matches) > 1:
        given_names = [match.name for match in matches]
        raise Exclusive(given_names, f"both give {what}")
    return matches[0] if matches else None


def one_of(inputs: Inputs, what: str, *names: str) -> Input:
    """Return the given one of several inputs; refuse none and two."""
    return at_most_one(inputs, what, *names) or any_of(inputs, what, *names)


def radius_of(given: Input) -> Any:
    """Return a radius [m] given as a radius or a diameter."""
    return given.value / (2 if given.name.endswith("diameter") else 1)


def half_angle_of(given: Input, most: int = 180) -> Any:
    """Return a half angle [rad] of at most `most` degrees, given as a half or an apex angle."""
    factor = 2 if given.name == "apex-angle" else 1
    limit = symbols.Limits(0.0, math.radians(factor * most), f"at most {factor * most} deg", True)
    check_limits(given, limit)
    return given.value / factor


def angle_of(inputs: Inputs, name: str) -> Any:
    """Return the absolute value of an angle from a normal [rad]; 0 if it is not given."""
    return abs(inputs[name].value) if name in inputs else 0.0


def offset_of(inputs: Inputs, name: str = "offset") -> Any:
    """Return a sideways distance [m]; 0 if it is not given."""
    return inputs[name].value if name in inputs else 0.0


def runs_backwards(symbol: symbols.Symbol, text: str, hint: str) -> ConditionError:
    """Return the error for an interval that ends before it starts."""
    return ConditionError(f"{option(symbol.name, quote(text))} ends before it starts", hint)
