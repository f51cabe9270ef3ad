"""The worksheet of a calculator: what is given, the laws, and everything that follows."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial, reduce
from itertools import combinations, permutations
from types import MappingProxyType
from typing import Any, NamedTuple, TypeVar

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import light
from radcalc.calculators.results import known, value
from radcalc.derivation import coherent_unit_of, digits_apart, format_number, format_value
from radcalc.errors import (
    ConditionError,
    Contradiction,
    Exclusive,
    Idle,
    Unused,
    mention,
    option,
    options,
    quote,
)
from radcalc.given import Given, Inputs, sort
from radcalc.laws.law import AnyLaw
from radcalc.laws.solver import (
    Derivation,
    Disagreement,
    Known,
    Solution,
    reached,
    solve_all,
)
from radcalc.maths import any_true, is_array, larger
from radcalc.quantities.light import KINDS
from radcalc.quantities.symbols import INNER, QUANTITY, SYMBOLS, article, specific_name
from radcalc.units.dimensions import AREA, LENGTH

# What calculators are about: what leads nowhere near one of these has no use.
GOALS = frozenset(
    {name for name, symbol in SYMBOLS.items() if symbol.generic == name} | {"projected-solid-angle"}
)
LIGHT = frozenset({name for name, symbol in SYMBOLS.items() if symbol.generic})  # of any kind
ROUNDING = 1e-9  # of what follows, beyond a limit
FARTHEST = 1e75  # between lengths, whose ratio is squared
OFFSETS = ("offset", "offset-y")
PLACED = (*OFFSETS, "incidence", "tilt")  # what a calculator itself makes use of


class Page(NamedTuple):
    """What a calculator's page has on it.

    `takes` are the symbols that can be given; `light` those results that are light quantities,
    by generic names, and `others` the rest, in the order in which they are shown; `goal` is what
    it is about, where that is no light.  A page that
    has an `about` is a command of its own: one line that says what it gives, the symbols that
    can be given by the section of its help, examples (NAME=VALUE for each symbol), remarks in
    which {name} is a symbol, and the kinds of light that it takes.  `bare` are the units of what
    is mostly written without one; `labels` are those of symbols that have another meaning here,
    and `forms` say how people read their numbers.
    """

    title: str
    takes: tuple[str, ...]
    light: tuple[str, ...] = ()
    others: tuple[str, ...] = ()
    goal: str = ""
    about: str = ""
    sections: Mapping[str, tuple[str, ...]] = MappingProxyType({})
    examples: tuple[str, ...] = ()
    remarks: str = ""
    kinds: tuple[str, ...] = KINDS
    takes_arrays: bool = True
    bare: Mapping[str, str] = MappingProxyType({})
    labels: Mapping[str, str] = MappingProxyType({})
    forms: Mapping[str, str] = MappingProxyType({})


T = TypeVar("T")


class Worksheet:
    """What is given to a calculator, and what follows from it.

    `lit` are the light quantities, in one kind; `given` the other inputs.  Without
    `with_light` a light quantity is an input like others; the kind is the `preferred` one where
    that is linked with what is given.
    """

    def __init__(
        self, page: Page, given: Inputs, with_light: bool = True, preferred: str = ""
    ) -> None:
        self.page = page
        self.takes = page.takes  # what may be named as missing
        self.lit, self.given = light.DARK, given
        if with_light:
            quantities, links, self.given = sort(given)
        refuse_foreign(self.given, page.takes, page.title)
        _refuse_disparate(self.given)
        if with_light:
            self.lit = light.read_light(quantities, links, preferred)
        self.defaults: set[str] = set()  # what goes without saying where nothing gives it
        self.used: set[str] = {*self.lit.twins}
        self.placed: list[Step] = []  # of what was worked out outside the laws
        self.assumptions, self.notes = list(self.lit.assumptions), list(self.lit.notes)
        self.known: dict[str, Known] = {}
        self.solution = Solution({}, [])
        self.solutions = [self.solution]
        for name, one in self.lit.values.items():
            self.known[name] = Known(
                self.lit.amounts[name], lambda name=name: light.rounding(self.lit, name), one.text
            )
        for name, one in self.given.items():
            if one.symbol.form == QUANTITY and name not in PLACED:
                self.know(name, one.value, one)

    def know(self, name: str, value: Any, *of: Given) -> None:
        """Add a value: one that was given, or one that goes without saying."""
        off = max([one.rounding for one in of]) * abs(value) if of else 0.0
        self.known[name] = Known(value, off, of[0].text if of else "")

    def place(self, how: Callable[["Worksheet"], T]) -> T:
        """Add what a function works out of the inputs, and give what it returns.

        What it adds may be off by what the inputs, moved by their roundings, would make of it.
        """
        before = dict(self.known)
        returned = how(self)
        for name, one in self.known.items():
            if name not in before and not one.text:
                off = partial(self._rounding, how, before, name)
                self.known[name] = one._replace(rounding=off)
        return returned

    def _rounding(
        self, how: Callable[["Worksheet"], Any], before: dict[str, Known], name: str
    ) -> Any:
        """How far a value may be off [SI] that was worked out of the inputs."""
        value = self.known[name].value
        total = 0.0 * value
        for key, one in self.given.items():
            if one.symbol.form != QUANTITY or not one.rounding:
                continue
            moved = [0.0 * value]
            for factor in (1 + one.rounding, 1 - one.rounding):
                twin = self._twin()
                twin.given = {**self.given, key: one._replace(value=one.value * factor)}
                twin.known, twin.used = dict(before), set()
                twin.placed, twin.assumptions, twin.notes = [], [], []
                try:
                    how(twin)
                except ConditionError:  # past a limit
                    continue
                moved.append(abs(twin.known[name].value - value))
            total = total + reduce(larger, moved)
        return total

    def default(self, laws: Sequence[AnyLaw], name: str, value: Any, *texts: str) -> None:
        """Take a value that goes without saying, unless it is given or follows; say so."""
        if name not in reached(laws, set(self.known)):
            self.know(name, value)
            self.assume(*texts)

    def refuse_impossible(self, *names: str, because: str = "", hint: str = "") -> None:
        """Refuse what follows and is beyond the limits of its symbol; say why that cannot be."""
        for name in names:
            limits = SYMBOLS[name].limits
            if not self.has(name):
                continue
            found = self.at(name)
            low, high = limits.low - ROUNDING * abs(limits.low), limits.high * (1 + ROUNDING)
            if any_true((found < low) | (found > high)):
                every = {**self._quantities(), **self.lit.links}
                raise ConditionError(
                    f"{self.told(name)} follows from the rest, and is not possible: "
                    f"{because or f'it is {limits.said}'}",
                    hint or f"another value of {options(one.name for one in every.values())}",
                )

    def note_behind(self) -> None:
        """Say where light comes from the side of the receiver, or from behind it."""
        if self.has("cosine") and any_true(self.at("cosine") == 0):
            self.notes.append("light from the side or behind does not reach the receiver")

    def assume(self, *texts: str) -> None:
        """Say what is assumed."""
        self.assumptions += texts

    def use(self, *names: str) -> None:
        """Count inputs as used, which went into a value that was worked out outside the laws."""
        self.used.update(names)

    def has(self, *names: str) -> bool:
        """Whether one of the symbols is known, or follows."""
        return not (
            self.solution.values.keys().isdisjoint(names) and self.known.keys().isdisjoint(names)
        )

    def at(self, name: str) -> Any:
        """A value."""
        return self.solution.values[name].value

    def told(self, name: str) -> str:
        """A value as it was given, or as it follows, for a message."""
        if name in self.given:
            return option(name, quote(self.given[name].text))
        size = format_value(self.at(name), coherent_unit_of(name, self.lit.kind))
        return f"{article(SYMBOLS[name].label)} of {size}"

    def solve(self, laws: Sequence[AnyLaw], steps: dict[str, float] | None = None) -> None:
        """Work out what follows; a contradiction is said in the units given."""
        try:
            self.solutions = solve_all(laws, self.known, steps, LIGHT)
            self.solution = self.solutions[0]
        except Disagreement as error:
            raise self.contradiction(error, steps or {}) from None

    def each(self) -> Iterator["Worksheet"]:
        """Give a sheet for each set of values that fits what is given."""
        for solution in self.solutions:
            twin = self._twin()
            twin.solution = solution
            twin.assumptions, twin.notes = list(self.assumptions), list(self.notes)
            if len(self.solutions) > 1:
                twin.notes.append(f"{len(self.solutions)} answers fit what is given")
            yield twin

    def _twin(self) -> "Worksheet":
        twin = object.__new__(Worksheet)
        twin.__dict__.update(self.__dict__)
        return twin

    def answer(self, laws: Sequence[AnyLaw], first: Iterable[Value] = ()) -> Answer:
        """Everything that follows, once it is solved; nothing that is given may be idle."""
        self._refuse_idle(laws)
        values = self.solution.values
        found = {name: self.at(name) for name in self.page.light if name in values}
        shown = light.show_light(self.lit, found)
        results = [*first, *(row for name in found for row in shown.values[name])]
        for name in self.page.others:
            if name in self.given and self.given[name].symbol.form == QUANTITY:
                result = known(self.given[name])
            elif name in values:
                result = value(name, self.at(name))
            else:
                continue
            if name in self.page.labels or name in self.page.forms:
                form = self.page.forms.get(name, "")
                label = self.page.labels.get(name, result.label)
                result = result._replace(label=label, form=form)
            results.append(result)
        results += [value(name, ratio) for name, ratio in light.efficacies(self.lit)]
        results += self._absent(laws)
        before = [*self.lit.steps, *self.placed]
        after = [step for step in shown.steps if step not in before]
        steps = Derivation(self.solution, self.lit.kind, before, after)
        assumptions = _once([*self.assumptions, *shown.assumptions])
        return Answer(
            results, assumptions, tuple(dict.fromkeys([*self.notes, *shown.notes])), steps
        )

    def _refuse_idle(self, laws: Sequence[AnyLaw]) -> None:
        """Refuse what is given and nothing follows from; say what would change that."""
        values, known = self.solution.values, {*self.known, *self.defaults}
        goal = self.page.goal
        live = _live(laws, set(values), goal)
        aliases = {"offset": "lateral", "offset-y": "lateral"}
        everything = self._quantities()
        idle = {
            own: one
            for name, one in everything.items()
            if (own := aliases.get(name, name)) not in live and name not in self.used
        }
        if not idle:
            return
        name, one = next(iter(idle.items()))
        brings = {
            n: _live(laws, reached(laws, known | {n}), goal)
            for n in self._inputs()
            if n not in values
        }
        # what makes use of all that is given, or else of this
        useful = [n for n, then in brings.items() if idle.keys() <= then]
        useful = (useful or [n for n, then in brings.items() if name in then])[:4]
        alone = "" if len(everything) > 1 else " alone"
        hint = f"the same without {option(one.name)}"
        if useful:
            hint = f"with it, {options(useful)}"
        elif several := self._partners(name, laws):
            hint = f"with it, {options(several, ' and ')}"
        raise Idle(f"nothing follows from {option(one.name, one.text)}{alone}", hint)

    def _partners(self, name: str, laws: Sequence[AnyLaw]) -> list[str]:
        """What has to be given with a symbol so that something follows by one of its laws."""
        known, inputs = {*self.known, *self.defaults}, set(self._inputs())
        lacking = [
            [other for other in law.names[1:] if other not in known]
            for law in laws
            if name in law.names[1:]
        ]
        lacking = [
            names
            for names in lacking
            if inputs.issuperset(names)
            and name in _live(laws, reached(laws, known.union(names)), self.page.goal)
        ]
        return min(lacking, key=len, default=[])

    def _quantities(self) -> Inputs:
        """What is given, but for flags, choices and spectra."""
        every = {**self.lit.values, **self.given}
        return {name: one for name, one in every.items() if one.symbol.form == QUANTITY}

    def _inputs(self) -> tuple[str, ...]:
        """The symbols that can be given, light quantities by generic names."""
        takes = self.takes  # which may have light quantities, in the order to name them
        return (*(n for n in self.page.light if SYMBOLS[n].help and n not in takes), *takes)

    def _absent(self, laws: Sequence[AnyLaw]) -> list[Value]:
        """Results that do not follow, which tell what they lack when they are asked for."""
        rows = []
        for name in dict.fromkeys((*self.page.light, *self.page.others, *self.page.takes)):
            follows = name in self.solution.values or name in self.given
            if follows or SYMBOLS[name].form != QUANTITY:
                continue

            def lacking(name: str = name) -> str:
                known = {*self.known, *self.defaults}
                others = [n for n in self._inputs() if n not in (name, *known)]
                if found := [n for n in others if name in reached(laws, {*known, n})]:
                    return options(found[:5])
                pairs = combinations([n for n in others if n not in self.page.light], 2)
                pair = next((two for two in pairs if name in reached(laws, known.union(two))), ())
                return options(pair, " and ") or "more of the quantities"

            symbol = SYMBOLS[name]
            also = specific_name(name, self.lit.kind) if name == symbol.generic else ""
            label = self.page.labels.get(name, symbol.label)
            rows.append(
                Value(name, label, "", 0.0, symbol.dimensions, (), also=also, lacking=lacking)
            )
        return rows

    def contradiction(self, error: Disagreement, steps: dict[str, float]) -> ConditionError:
        """Both values, with their unit, and the ratio."""
        everything = self._quantities()
        names = [one.name for one in everything.values()]
        if error.name in INNER:
            return Exclusive(
                names,
                f"contradict each other, by the law '{error.law.name}'",
                "fewer of them",
                ", ",
            )
        unit = coherent_unit_of(error.name, self.lit.kind)
        one = everything.get(error.name)
        digits = digits_apart(error.given, error.found)
        told = f"{error.name} {format_value(error.given, unit, digits)}"
        if one:
            told = option(one.name, one.text)
        ratio = ""
        if error.name in steps:
            ratio = f" ({format_number(error.given - error.found)} apart)"
        elif isinstance(error.found, float) and error.found:
            ratio = f" (ratio {format_number(error.given / error.found, digits)})"
        found = format_value(error.found, unit, digits)
        return Contradiction(
            f"{told} contradicts the rest, which gives {found}{ratio}",
            f"without one of {options(names, ', ')}",
            error.name,
            error.given,
            error.found,
        )


def _once(texts: Iterable[str]) -> tuple[str, ...]:
    """Texts without the clauses that others before them have."""
    said: dict[str, None] = {}
    kept = []
    for text in texts:
        clauses = [clause for clause in text.split("; ") if clause not in said]
        said.update(dict.fromkeys(clauses))
        kept += ["; ".join(clauses)] if clauses else []
    return tuple(kept)


def refuse_foreign(given: Inputs, takes: Sequence[str], title: str) -> None:
    """Refuse inputs that the case at hand does not take."""
    foreign = [name for name in given if name not in takes]
    if foreign:
        raise Unused(foreign, f"with {title}")


def _refuse_disparate(given: Inputs) -> None:
    """Refuse lengths and areas that are so far apart that a number cannot hold their ratio."""
    powers = {LENGTH: 1.0, AREA: 0.5}
    sizes = {
        name: abs(one.value) ** powers[one.dimension]
        for name, one in given.items()
        if one.dimension in powers and not is_array(one.value) and one.value
    }
    # each held against each, so that a stream's lines take one way whichever is the larger
    if [one for one, other in permutations(sizes.values(), 2) if one > FARTHEST * other]:
        least, most = min(sizes, key=sizes.__getitem__), max(sizes, key=sizes.__getitem__)
        told = " beside ".join(option(name, quote(given[name].text)) for name in (least, most))
        raise ConditionError(f"{told} is beyond what radcalc reckons with", "less extreme values")


def _live(laws: Sequence[AnyLaw], known: set[str], goal: str) -> set[str]:
    """The symbols that have a part in what follows of the light, or of a calculator's goal.

    Those of the laws of which every symbol is known, and that lead to a goal.
    """
    whole = [set(law.names) for law in laws if known.issuperset(law.names)]
    live = {*GOALS, goal}
    while more := [names for names in whole if names & live and not names <= live]:
        live = live.union(*more)
    return {name for names in whole if names <= live for name in names}


def refuse_slant_for_height() -> None:
    """Refuse a distance where the height above a flat source is meant."""
    raise ConditionError(
        mention("{distance} is the straight line to the centre, and off the axis no height"),
        mention("{height} in its place"),
    )
