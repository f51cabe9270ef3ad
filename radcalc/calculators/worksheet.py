"""The worksheet of a calculator: its checked inputs, and the values that a page adds to them.

Hints about missing inputs propose inputs that make use of an idle one, or that give a result.
"""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from functools import partial
from itertools import combinations, permutations
from typing import Any

from radcalc import errors
from radcalc.answer import Remark, Step
from radcalc.calculators import SUMMARIES, kinds, page_of
from radcalc.calculators.page import Page
from radcalc.errors import ConditionError, Try, Unused, leave_out, mention, option, quote
from radcalc.inputs import Input, Inputs, split_by_light
from radcalc.inputs.quantities import with_likely_unit
from radcalc.laws import AnyLaw, Law, same
from radcalc.laws.solver import Known, reached
from radcalc.maths import any_true, is_array, larger
from radcalc.quantities import read as read_light
from radcalc.quantities.symbols import QUANTITY, SYMBOLS, light_unit, names_of_kinds
from radcalc.tuples import NamedTuple
from radcalc.units.dimensions import AREA, LENGTH
from radcalc.units.reading import read_amount

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


# The results that inputs must lead to; a page may name another goal.
GOALS = frozenset(
    {name for name, symbol in SYMBOLS.items() if symbol.generic == name} | {"projected-solid-angle"}
)


class Search(NamedTuple):
    """A search for helpful inputs, from the known symbols and the laws."""

    sheet: Worksheet
    known: frozenset[str]
    laws: Sequence[AnyLaw]

    def refuse_idle(self, solved: Set[str], used: Set[str]) -> None:
        """Refuse inputs that lead to no result; suggest inputs that make use of them."""
        live = self._live(solved)
        inputs = self.sheet.quantities
        idle = {}
        for name, item in inputs.items():
            symbol = "lateral" if name in OFFSETS else name
            if symbol not in live and name not in used:
                idle[symbol] = item
        if not idle:
            return
        name, item = next(iter(idle.items()))
        lively = {
            other: self._live(reached(self.laws, {*self.known, other}))
            for other in self._inputs()
            if other not in solved
        }
        # inputs that make use of all idle ones, or else of this one
        useful = [other for other, symbols in lively.items() if idle.keys() <= symbols]
        useful = (useful or [other for other, symbols in lively.items() if name in symbols])[:4]
        problem = "needs further inputs"
        hint: errors.Hint = errors.leave_out(item.name)
        if useful:
            hint = self._one_of(useful)
        elif partners := self._partners(name):
            hint = self._all_of(partners)
        else:
            problem = "does not apply to the other inputs"
        if len(inputs) == 1:
            problem = "alone is not enough"
        raise errors.Idle(f"{option(item.name, item.text)} {problem}", hint)

    def lacking(self, name: str) -> errors.Hint:
        """Return the inputs that would give a result, alone or in pairs."""
        light = self.sheet.page.light
        candidates = [
            candidate
            for candidate in self._inputs()
            if candidate != name and candidate not in self.known
        ]
        if single := [
            candidate
            for candidate in candidates
            if name in reached(self.laws, {*self.known, candidate})
        ]:
            used = [candidate for candidate in single if self._uses_light(name, (candidate,))]
            if used:
                return self._one_of(used[:5])
        pairs = [
            pair
            for pair in combinations([one for one in candidates if one not in light], 2)
            if name in reached(self.laws, {*self.known, *pair})
        ]
        for pair in pairs:
            if self._uses_light(name, pair):
                return self._all_of(pair)
        if single:
            return self._one_of(single[:5])
        return self._all_of(pairs[0]) if pairs else "more of the quantities"

    def _uses_light(self, name: str, added: Iterable[str]) -> bool:
        """Return whether a result with added inputs depends on the light that is given."""
        given = {*self.sheet.page.light} & self.sheet.quantities.keys()
        others = self.known - given
        return not given or name not in reached(self.laws, {*others, *added})

    def _one_of(self, names: Sequence[str]) -> list[errors.Try]:
        light = self.sheet.page.light  # after the geometry, which people know
        return [self._all_of([name]) for name in sorted(names, key=lambda name: name in light)]

    def _all_of(self, names: Sequence[str]) -> errors.Try:
        """Propose inputs with the examples of the page, in the kind of light of the call."""
        kind = self.sheet.lit.kind
        values = [
            f"100{light_unit(name, kind)}".replace(" ", ".")
            if SYMBOLS[name].generic == name
            else ""
            for name in names
        ]
        return errors.Try(tuple(zip(names, values, strict=True)))

    def _partners(self, name: str) -> list[str]:
        """Return the fewest missing inputs of a law of a symbol that help."""
        inputs = set(self._inputs())
        lacking = [
            [other for other in law.names[1:] if other not in self.known]
            for law in self.laws
            if name in law.names[1:]
        ]
        helpful = [
            names
            for names in lacking
            if inputs.issuperset(names)
            and name in self._live(reached(self.laws, {*self.known, *names}))
        ]
        return min(helpful, key=len, default=[])

    def _inputs(self) -> Iterable[str]:
        hints = self.sheet.hints  # may have light quantities, in the order of the hint
        light = [n for n in self.sheet.page.light if SYMBOLS[n].help and n not in hints]
        return (*light, *hints)

    def _live(self, known: Set[str]) -> set[str]:
        """Return the symbols of the laws that are complete and lead to light or to the goal."""
        complete = [set(law.names) for law in self.laws if known >= {*law.names}]
        live = {*GOALS, self.sheet.page.goal, *self.sheet.page.goals}
        while more := [names for names in complete if names & live and not names <= live]:
            live = live.union(*more)
        return {name for names in complete if names <= live for name in names}


def _as_another(error: errors.WrongQuantity, page: Page) -> list[errors.Try]:
    """Propose the inputs of a page that take a value, or its number as the right quantity."""
    inputs = {*page.listed}
    inputs |= {other for name in inputs for other in names_of_kinds(name)}
    if error.tries and all(name in inputs for one in error.tries for name, _ in one.inputs):
        return list(error.tries)
    if not error.text:
        return []
    amount, symbol = read_amount(error.text), page.symbol(error.symbol)
    if amount.unit is None:
        return []
    dimension = amount.unit.dimension
    names = [name for name in page.listed if name in SYMBOLS]
    takers = [
        name
        for name in names
        if SYMBOLS[name].form == QUANTITY and dimension in page.symbol(name).dimensions
    ]
    if takers:
        return [errors.Try(((name, error.text),), (error.symbol,)) for name in takers[:2]]
    light = read_light(amount.unit)
    if light is None or not symbol.generic:
        return []
    unit = light_unit(symbol.generic, light.kind).replace(" ", ".")
    number = error.text.removesuffix(amount.unit.text).strip()
    if symbol.kind in ("", light.kind):
        return [errors.add(error.symbol, f"{number}{unit}")]
    other = light_unit(symbol.generic, symbol.kind).replace(" ", ".")
    return [errors.call("convert", error.text, other, spectrum="D65", remark="for this spectrum")]


def on_page(error: errors.RadcalcError, command: str) -> errors.RadcalcError:
    """Return the error about a unit with a unit, or with inputs, that are likely in a command."""
    if isinstance(error, errors.WrongQuantity) and command in SUMMARIES:
        return error.reworded(tries=_as_another(error, page_of(command)))
    if not isinstance(error, errors.MissingUnit) or not error.number or command not in SUMMARIES:
        return error
    if error.hint != option(error.symbol, error.written):  # a better one was found
        return error
    page = page_of(command)
    likely = error.with_unit(with_likely_unit(page.symbol(error.symbol), error.number))
    is_shutter = page.bare.get(error.symbol) == "s" and error.number.isdigit()
    if is_shutter and not error.several:
        marked = errors.add(error.symbol, f"1/{error.number}s", "as cameras are marked")
        return error.reworded(hint=[errors.computed(marked), *likely.tries])
    return likely
