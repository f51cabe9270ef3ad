"""The worksheet of a calculator: its checked inputs, and the values that a page adds to them."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from itertools import permutations
from typing import Any

from radcalc.answer import Remark, Step
from radcalc.calculators import kinds
from radcalc.calculators.page import Page
from radcalc.errors import ConditionError, Try, Unused, leave_out, mention, option, quote
from radcalc.inputs import Input, Inputs, split_by_light
from radcalc.laws import AnyLaw, Law, same
from radcalc.laws.solver import Known, reached
from radcalc.maths import any_true, is_array, larger
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
        """Return the values for the laws: a given one, or else the one that the page derives."""
        return {**placed.known, **self.known}

    def given_twice(self, placed: "Placed") -> tuple[list[Law], dict[str, Known]]:
        """Return the laws that compare second values of symbols, and these values."""
        if not placed.again and placed.known.keys().isdisjoint(self.known):  # the usual case
            return [], {}
        seconds = [(n, known) for n, known in placed.known.items() if n in self.known]
        laws: list[Law] = []
        values = {}
        for number, (name, known) in enumerate([*seconds, *placed.again]):
            second = f"{name}#{number}"
            laws.append(same(name, second))
            values[second] = known
        return laws, values

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
    """Assumptions and notes of an answer, and the inputs used outside the laws.

    A remark is on all results, or on those whose derivation has one `of` its symbols and laws.
    """

    def __init__(self) -> None:
        self.assumptions: list[str] = []
        self.notes: list[str] = []
        self.used: set[str] = set()

    def assume(self, *texts: str, of: Iterable[str | AnyLaw] = ()) -> None:
        self.assumptions += _of(of, texts)

    def note(self, *texts: str, of: Iterable[str | AnyLaw] = ()) -> None:
        self.notes += _of(of, texts)

    def use(self, *names: str) -> None:
        """Mark inputs as used that are not in any law."""
        self.used.update(names)


def _of(origins: Iterable[str | AnyLaw], texts: Sequence[str]) -> Sequence[str]:
    """Return texts as remarks of symbols and laws, if there are any."""
    of = [origin if isinstance(origin, str) else origin.name for origin in origins]
    return [Remark(text, of) for text in texts] if of else texts


class Placed(Remarks):
    """Laws, values and remarks that a page or a shape derives from its inputs.

    `laws` hold for the case, `known` are values for them, and `steps` derive these values; `again`
    are further values of the same symbols, to compare.
    """

    def __init__(self, *laws: AnyLaw) -> None:
        super().__init__()
        self.laws: list[AnyLaw] = [*laws]
        self.known: dict[str, Known] = {}
        self.again: list[tuple[str, Known]] = []
        self.steps: list[Step] = []

    def add(self, name: str, value: Any, *inputs: Input) -> None:
        if name in self.known:
            self.again.append((name, known_by(value, *inputs)))
        else:
            self.known[name] = known_by(value, *inputs)

    def compare(self, given: Input, value: Any) -> None:
        """Compare an input that is not a value of the laws with its value by other inputs."""
        self.known[given.name] = known_by(abs(given.value), given)
        self.add(given.name, value)

    def corner(self, given: Inputs, width: Any, length: Any) -> tuple[Any, Any]:
        """Return the offsets of a rectangle's corner, and compare them with given ones."""
        corner = width / 2, length / 2
        for name, half in zip(OFFSETS, corner, strict=True):
            if name in given:
                self.compare(given[name], half)
        return corner

    def default(
        self, sheet: Worksheet, laws: Sequence[AnyLaw], name: str, value: Any, *texts: str
    ) -> None:
        """Add a value as an assumption, unless it is given or follows from the laws."""
        if name not in reached(laws, {*sheet.known, *self.known}):
            self.add(name, value)
            self.assume(*texts, of=[name])

    def merge(self, other: "Placed") -> None:
        self.laws += other.laws
        self.known |= other.known
        self.again += other.again
        self.steps += other.steps
        self.assume(*other.assumptions)
        self.note(*other.notes)
        self.use(*other.used)


def place(sheet: Worksheet, find: Callable[[Worksheet], Placed]) -> Placed:
    """Return what `find` derives from the inputs, with rounding errors of its values.

    They follow from shifting each input by its own rounding error.
    """
    try:
        placed = find(sheet)
    except ConditionError as error:
        raise without_one(sheet, error) from None
    for name, known in placed.known.items():
        if not known.text:
            rounding = partial(_moved_by_roundings, sheet, find, name, known.value)
            placed.known[name] = known._replace(rounding=rounding)
    return placed


def without_one(sheet: Worksheet, error: ConditionError) -> ConditionError:
    """Return the error of inputs that do not fit each other, with the call without each of them."""
    fewer = [leave_out(item.name) for item in sheet.quantities.values()]
    return error.reworded(tries=error.tries or (fewer if len(fewer) > 1 else ()))


def _moved_by_roundings(
    sheet: Worksheet, find: Callable[[Worksheet], Placed], name: str, value: Any
) -> Any:
    """Return the change of a value [SI] when the inputs are shifted by their rounding errors."""
    rising, falling, most = {}, {}, 0.0 * value

    def change(moved: Inputs) -> Any:
        try:
            placed = find(sheet._replace(given={**sheet.given, **moved}))
        except ConditionError:  # past a limit
            return None
        return placed.known[name].value - value

    for key, item in sheet.given.items():
        if item.symbol.form != QUANTITY or not item.rounding:
            continue
        for factor in (1 + item.rounding, 1 - item.rounding):
            moved = item._replace(value=item.value * factor)
            by = change({key: moved})
            if by is None:
                continue
            most = larger(most, abs(by))
            if any_true(by > 0):
                rising[key] = moved
            if any_true(by < 0):
                falling[key] = moved
    for together in (rising, falling):
        by = change(together)
        most = most if by is None else larger(most, abs(by))
    return most


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


def facing(given: Inputs) -> tuple[str, ...]:
    """Return the assumption for two small surfaces without an incidence, a tilt or both."""
    if "incidence" not in given:
        one = "the receiver faces the source"
        return (one if "tilt" in given else "source and receiver face each other",)
    return () if "tilt" in given else ("the source faces the receiver",)


def refuse_slant_for_height(distance: Input) -> None:
    """Refuse a distance that is not the height above a flat source."""
    raise ConditionError(
        mention("{distance} is the straight line to the centre, not the height"),
        Try((("height", distance.text),), ("distance",)),
    )
