"""Hints about missing inputs: inputs that make use of an idle one, or that give a result."""

from collections.abc import Iterable, Sequence, Set
from itertools import combinations

from radcalc import errors
from radcalc.calculators.page import Page
from radcalc.calculators.pages import SUMMARIES, page_of
from radcalc.calculators.worksheet import OFFSETS, Worksheet
from radcalc.errors import option
from radcalc.inputs.quantities import with_likely_unit
from radcalc.laws import AnyLaw
from radcalc.laws.solver import reached
from radcalc.quantities.light import read as read_light
from radcalc.quantities.symbols import QUANTITY, SYMBOLS, light_unit, names_of_kinds
from radcalc.tuples import NamedTuple
from radcalc.units.reading import read_amount

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
        return error.reworded(hint=[marked, *likely.tries])
    return likely
