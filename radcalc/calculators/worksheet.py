"""The worksheet of a calculator: its checked inputs, and the values that a page adds to them."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial, reduce
from itertools import permutations
from typing import Any

from radcalc.answer import Step
from radcalc.calculators import kinds
from radcalc.calculators.page import Page
from radcalc.errors import ConditionError, Try, Unused, mention, option, quote
from radcalc.inputs.given import Input, Inputs, split_by_light
from radcalc.laws.law import AnyLaw
from radcalc.laws.solver import Known, reached
from radcalc.maths import is_array, larger
from radcalc.quantities.symbols import QUANTITY
from radcalc.tuples import NamedTuple
from radcalc.units.dimensions import AREA, LENGTH

FARTHEST = 1e75  # ratio of lengths, which is squared
OFFSETS = ("offset", "offset-y")
PLACES = (*OFFSETS, "incidence", "tilt")  # inputs that pages convert to values of the laws


class Worksheet(NamedTuple):
    """The inputs of a calculator, checked and sorted.

    `lit` are the light quantities in one kind, `given` the other inputs, and `known` the values
    of both for the laws.  `hints` are inputs to suggest; `defaults` may be omitted.
    """

    page: Page
    given: Inputs
    lit: kinds.LightInputs
    known: Mapping[str, Known]
    hints: tuple[str, ...]
    defaults: frozenset[str] = frozenset()

    def has(self, *names: str) -> bool:
        return not self.known.keys().isdisjoint(names)

    def known_with(self, placed: "Placed") -> dict[str, Known]:
        return {**self.known, **placed.known}

    @property
    def quantities(self) -> Inputs:
        """The inputs except flags, choices and spectra; light quantities by generic names."""
        inputs = {**self.lit.values, **self.given}
        return {name: item for name, item in inputs.items() if item.symbol.form == QUANTITY}


def worksheet(
    page: Page,
    given: Inputs,
    with_light: bool = True,
    preferred: str = "",
    accepts: Sequence[str] | None = None,
    hints: tuple[str, ...] | None = None,
    defaults: Iterable[str] = (),
) -> Worksheet:
    """Check and sort the inputs of a page.

    Without `with_light`, light quantities are treated like other inputs.  The kind of light is the
    `preferred` one if a link leads to it.  `accepts` are the accepted inputs (default: the page's),
    `hints` those to suggest (default: the accepted ones).
    """
    accepts = page.takes if accepts is None else accepts
    rest = given
    if with_light:
        quantities, links, rest = split_by_light(given)
    refuse_foreign(rest, accepts, page.title)
    _refuse_disparate(rest)
    lit = kinds.read_light(quantities, links, preferred) if with_light else kinds.NO_LIGHT
    known = {
        name: Known(lit.amounts[name], partial(kinds.rounding, lit, name), item.text)
        for name, item in lit.values.items()
    }
    known |= {
        name: known_by(item.value, item)
        for name, item in rest.items()
        if item.symbol.form == QUANTITY and name not in PLACES
    }
    hints = tuple(accepts) if hints is None else hints
    return Worksheet(page, rest, lit, known, hints, frozenset(defaults))


def known_by(value: Any, *inputs: Input) -> Known:
    """Return a value with the rounding of its inputs, and the text of the first."""
    if not inputs:
        return Known(value)
    return Known(value, partial(_rounding, value, inputs), inputs[0].text)


def _rounding(value: Any, inputs: Sequence[Input]) -> Any:
    """Return the rounding error [SI] of a value from the digits of its inputs."""
    return max([item.rounding for item in inputs]) * abs(value)


class Remarks:
    """Assumptions and notes of an answer, and the inputs used outside the laws."""

    def __init__(self) -> None:
        self.assumptions: list[str] = []
        self.notes: list[str] = []
        self.used: set[str] = set()

    def assume(self, *texts: str) -> None:
        self.assumptions += texts

    def note(self, *texts: str) -> None:
        self.notes += texts

    def use(self, *names: str) -> None:
        """Mark inputs as used that are not in any law."""
        self.used.update(names)


class Placed(Remarks):
    """Laws, values and remarks that a page or a shape derives from its inputs.

    `laws` hold for the case, `known` are values for them, and `steps` derive these values.
    """

    def __init__(self, *laws: AnyLaw) -> None:
        super().__init__()
        self.laws: list[AnyLaw] = [*laws]
        self.known: dict[str, Known] = {}
        self.steps: list[Step] = []

    def add(self, name: str, value: Any, *inputs: Input) -> None:
        self.known[name] = known_by(value, *inputs)

    def default(
        self, sheet: Worksheet, laws: Sequence[AnyLaw], name: str, value: Any, *texts: str
    ) -> None:
        """Add a value as an assumption, unless it is given or follows from the laws."""
        if name not in reached(laws, {*sheet.known, *self.known}):
            self.add(name, value)
            self.assume(*texts)

    def merge(self, other: "Placed") -> None:
        self.laws += other.laws
        self.known |= other.known
        self.steps += other.steps
        self.assume(*other.assumptions)
        self.note(*other.notes)
        self.use(*other.used)


def place(sheet: Worksheet, find: Callable[[Worksheet], Placed]) -> Placed:
    """Return what `find` derives from the inputs, with rounding errors of its values.

    They follow from shifting each input by its own rounding error.
    """
    placed = find(sheet)
    for name, known in placed.known.items():
        if name not in sheet.known and not known.text:
            rounding = partial(_moved_by_roundings, sheet, find, name, known.value)
            placed.known[name] = known._replace(rounding=rounding)
    return placed


def _moved_by_roundings(
    sheet: Worksheet, find: Callable[[Worksheet], Placed], name: str, value: Any
) -> Any:
    """Return the change of a value [SI] when the inputs are shifted by their rounding errors."""
    total = 0.0 * value
    for key, item in sheet.given.items():
        if item.symbol.form != QUANTITY or not item.rounding:
            continue
        moves = [0.0 * value]
        for factor in (1 + item.rounding, 1 - item.rounding):
            given = {**sheet.given, key: item._replace(value=item.value * factor)}
            try:
                placed = find(sheet._replace(given=given))
            except ConditionError:  # past a limit
                continue
            moves.append(abs(placed.known[name].value - value))
        total = total + reduce(larger, moves)
    return total


def refuse_foreign(given: Inputs, takes: Sequence[str], title: str) -> None:
    """Refuse inputs that are not accepted."""
    foreign = [name for name in given if name not in takes]
    if foreign:
        raise Unused(foreign, f"to {title}")


def _refuse_disparate(given: Inputs) -> None:
    """Refuse lengths and areas whose ratio is too large for a number."""
    powers = {LENGTH: 1.0, AREA: 0.5}
    least, most = {}, {}
    for name, item in given.items():
        if item.dimension not in powers:
            continue
        low = high = abs(item.value)
        if is_array(high):
            low, high = high[high > 0].min(initial=math.inf), high.max(initial=0.0)
        if high:
            least[name], most[name] = low ** powers[item.dimension], high ** powers[item.dimension]
    pairs = permutations(most, 2)
    if any(most[name] > FARTHEST * least[other] for name, other in pairs):
        extremes = min(least, key=least.__getitem__), max(most, key=most.__getitem__)
        option_texts = " and ".join(option(name, quote(given[name].text)) for name in extremes)
        raise ConditionError(f"{option_texts} are too far apart", "less extreme values")


def refuse_slant_for_height(distance: Input) -> None:
    """Refuse a distance that is not the height above a flat source."""
    raise ConditionError(
        mention("{distance} is the straight line to the centre, not the height"),
        Try((("height", distance.text),), ("distance",)),
    )
