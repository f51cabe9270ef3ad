"""A task: a calculation for the command line or a Python function."""

from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from functools import partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from radcalc.answer import (
    Answer,
    Remark,
    ShownInput,
    Value,
    coherent_unit_of,
    digits_apart,
    format_number,
    format_value,
    itself,
)
from radcalc.calculators import kinds
from radcalc.calculators.results import known, value
from radcalc.calculators.worksheet import Placed, Remarks, Search, Worksheet, without_one
from radcalc.errors import ConditionError, Contradiction, option, options, quote
from radcalc.inputs import Inputs, any_uncertain
from radcalc.laws import AnyLaw, solver
from radcalc.laws.solver import TO_DIGITS, Derivation, Disagreement, Solution
from radcalc.maths import any_true, is_array
from radcalc.quantities import symbols
from radcalc.quantities.symbols import SYMBOLS, article, in_kind
from radcalc.tuples import NamedTuple

if TYPE_CHECKING:
    from radcalc.distributions.maps.pictures import Picture

Wants = Callable[[str], bool]  # returns whether the result of a name is requested


class Task(NamedTuple):
    """A calculation: its command, its function, and arguments in addition to the inputs.

    `operands` are shown with the inputs; `shape` is the shape among them.  `samples` are facts of
    a log, for `--check`; `drawn` is extra data of a picture.
    """

    command: str
    work_out: Callable[[Inputs], Answer]
    operands: Sequence[ShownInput] = ()
    shape: str = ""
    samples: Mapping[str, float] = MappingProxyType({})
    drawn: Any = None

    def nominal(self, inputs: Inputs) -> Answer:
        """Return the answer for the values of inputs, with assumptions about their readings."""
        return _with_readings(self.work_out(inputs), inputs)

    def solve(self, inputs: Inputs) -> Answer:
        if not any_uncertain(inputs.values()):
            return self.nominal(inputs)
        from radcalc.calculators.uncertainty import with_uncertainties

        return with_uncertainties(self.nominal, inputs)


def requesting(function: Callable[..., Answer], names: Sequence[str]) -> Callable[..., Answer]:
    """Return the function of a page that also calculates these results of its `on_request`."""
    return partial(function, requested=names) if names else function


def _with_readings(answer: Answer, inputs: Inputs) -> Answer:
    readings: list[str] = []
    for given in inputs.values():
        readings += [Remark(text, [symbols.generic_name(given.name)]) for text in given.assumptions]
    if not readings:
        return answer
    if answer.origins is itself:
        readings = [*map(str, readings)]
    answers = (answer, *answer.more)
    first, *more = (
        alternative._replace(assumptions=(*readings, *alternative.assumptions))
        for alternative in answers
    )
    return first._replace(more=more)


class RenderedMap(NamedTuple):
    """A picture in full precision in the `unit`, its description, and its answer."""

    picture: "Picture"
    pixels: Any
    unit: str
    what: str
    answer: Answer


LIGHT = frozenset({name for name, symbol in SYMBOLS.items() if symbol.generic})  # of any kind
ROUNDING = 1e-9  # relative tolerance of limits of results


def solve(
    sheet: Worksheet,
    laws: Sequence[AnyLaw],
    placed: Placed | None = None,
    steps: dict[str, float] | None = None,
) -> "Solved":
    """Return the first solution; `placed` has the laws, values and remarks of the page.

    `steps` are the intervals between the marked values of logarithmic symbols.
    """
    placed = placed or Placed()
    return Solved(sheet, placed, laws, _solutions(sheet, laws, placed, steps or {})[0])


def solve_all(sheet: Worksheet, laws: Sequence[AnyLaw], placed: Placed) -> list["Solved"]:
    """Return every solution, with a note if there are several."""
    solutions = _solutions(sheet, laws, placed, {})
    answers = [Solved(sheet, placed, laws, solution) for solution in solutions]
    if len(answers) > 1:
        for solved in answers:
            solved.note(f"{len(answers)} solutions fit the inputs")
    return answers


def _solutions(
    sheet: Worksheet, laws: Sequence[AnyLaw], placed: Placed, steps: dict[str, float]
) -> list[Solution]:
    same, seconds = sheet.given_twice(placed)
    try:
        return solver.solve_all([*same, *laws], sheet.known_with(placed) | seconds, steps, LIGHT)
    except Disagreement as error:
        raise contradiction(sheet, error, steps) from None
    except ConditionError as error:  # no value fits the inputs
        raise without_one(sheet, error) from None


class Solved(Remarks):
    """One solution of a worksheet, to which the page adds its remarks before the answer."""

    def __init__(
        self, sheet: Worksheet, placed: Placed, laws: Sequence[AnyLaw], solution: Solution
    ) -> None:
        super().__init__()
        self.sheet, self.placed, self.laws, self.solution = sheet, placed, laws, solution
        self.given, self.lit = sheet.given, sheet.lit
        self.derived: dict[str, Iterable[str]] = {}  # results of the page, with their symbols
        self.assume(*sheet.lit.assumptions, *placed.assumptions)
        self.note(*sheet.lit.notes, *placed.notes)
        if solution.limited or solution.agreed:
            self.note(*remarks_on(sheet, solution))
        compared = placed.known.keys() & sheet.known.keys()
        self.use(*sheet.lit.given_in_two_kinds, *placed.used, *compared, *dict(placed.again))

    def has(self, *names: str) -> bool:
        return not self.solution.values.keys().isdisjoint(names)

    def value(self, name: str) -> Any:
        return self.solution.values[name].value

    def describe(self, name: str) -> str:
        if name in self.given:
            return option(name, quote(self.given[name].text))
        size = format_value(self.value(name), coherent_unit_of(name, self.lit.kind))
        return f"{article(SYMBOLS[in_kind(name, self.lit.kind)].label)} of {size}"

    def refuse_impossible(self, *names: str, because: str = "", hint: str = "") -> None:
        for name in names:
            limits = SYMBOLS[name].limits
            if not self.has(name):
                continue
            result = self.value(name)
            low, high = limits.low - ROUNDING * abs(limits.low), limits.high * (1 + ROUNDING)
            if any_true((result < low) | (result > high)) and not self._is_at_limit(name):
                inputs = {**self.sheet.quantities, **self.lit.links}
                error = ConditionError(
                    f"{self.describe(name)} follows from the rest and is out of range: "
                    f"{because or f'it must be {limits.said}'}",
                    hint or f"another value of {options(item.name for item in inputs.values())}",
                )
                raise without_one(self.sheet, error)

    def _is_at_limit(self, name: str) -> bool:
        """Use the limit of a result in its place, if the digits typed allow that."""
        result, limits = self.value(name), SYMBOLS[name].limits
        if name in self.given or is_array(result):
            return False
        limit = limits.high if result > limits.high else limits.low
        limited = Placed()
        limited.merge(self.placed)
        limited.add(name, limit)
        try:
            (self.solution, *_) = _solutions(self.sheet, self.laws, limited, {})
        except ConditionError:
            return False
        self.placed = limited
        self.note(*remarks_on(self.sheet, self.solution))
        return True

    def note_behind(self) -> None:
        if self.has("cosine") and any_true(self.value("cosine") == 0):
            self.note("light from the side or behind does not reach the receiver")

    def answer(self, first: Iterable[Value] = (), laws: Sequence[AnyLaw] | None = None) -> Answer:
        """Return the answer, with results of the page `first`; refuse inputs that lead to none.

        `laws` replace the solved ones in hints.
        """
        values, page = self.solution.values, self.sheet.page
        names = frozenset(self.sheet.known_with(self.placed)) | self.sheet.defaults
        search = Search(self.sheet, names, self.laws if laws is None else laws)
        search.refuse_idle(values.keys(), self.used)
        amounts = {name: self.value(name) for name in page.light if name in values}
        light = kinds.show_light(self.lit, amounts)
        results = [*first, *[row for name in amounts for row in light.values[name]]]
        results += self._others()
        results += kinds.efficacies(self.lit)
        results += self._absent(search)
        before = [*self.lit.steps, *self.placed.steps]
        after = [step for step in light.steps if step not in before]
        return Answer(
            results,
            (*self.assumptions, *light.assumptions),
            (*self.notes, *light.notes),
            Derivation(self.solution, self.lit.kind, before, after),
            origins=self.origins,
        )

    def origins(self, name: str, kind: str) -> Set[str] | None:
        """Return what a result comes from, as in an `Answer`.

        Any result may come from an input outside the laws, and a value of the page from any input.
        """
        ratios = {ratio: {*pair} for ratio, *pair in symbols.EFFICACIES}
        names = self.derived.get(name, (name,) if self.has(name) else ())
        if not names and name not in ratios:
            return None
        found = {name, kind}.union(*map(self.solution.origins, names), ratios.get(name, ()))
        given = self.given.keys() | self.lit.links.keys()
        if self.placed.known.keys().isdisjoint(found):
            given -= self.solution.values.keys()
        return found | given

    def _others(self) -> list[Value]:
        """Return the other results of the page that are given or solved, with its labels."""
        values, page = self.solution.values, self.sheet.page
        results = []
        for name in page.others:
            if name in self.given and self.given[name].symbol.form == symbols.QUANTITY:
                result = known(self.given[name])
            elif name in values:
                result = value(name, self.value(name))
            else:
                continue
            if name in page.labels or name in page.forms:
                form = page.forms.get(name, "")
                label = page.labels.get(name, result.label)
                result = result._replace(label=label, form=form)
            results.append(result)
        return results

    def _absent(self, search: Search) -> list[Value]:
        """Return the results that do not follow; each looks for its missing inputs on demand."""
        absent = []
        page, values = self.sheet.page, self.solution.values
        for name in dict.fromkeys((*page.light, *page.others, *page.takes)):
            symbol = SYMBOLS[name]
            if symbol.form == symbols.QUANTITY and name not in values and name not in self.given:
                label = page.labels.get(name, symbol.label)
                also = symbols.specific_name(name, self.lit.kind) if name == symbol.generic else ""
                lacking = partial(search.lacking, name)
                absent.append(
                    Value(name, label, "", 0.0, symbol.dimensions, (), also=also, lacking=lacking)
                )
        return absent


def remarks_on(sheet: Worksheet, solution: Solution) -> list[str]:
    """Return notes on values that fit only to the digits typed, and which of them are used."""
    notes = []
    for name in sorted(solution.limited):
        unit = coherent_unit_of(name, sheet.lit.kind)
        size = format_value(solution.values[name].value, unit)
        label = f"{article(SYMBOLS[name].label)} of {size}"
        notes.append(f"{label} is the limit: the other inputs reach it only by their rounding")
    for name, value_used, implied in solution.agreed:
        if name in symbols.INNER or is_array(value_used - implied):
            inputs = options([item.name for item in sheet.quantities.values()], " and ")
            notes.append(f"{inputs} agree {TO_DIGITS}; each is used as typed")
            continue
        unit = coherent_unit_of(name, sheet.lit.kind)
        digits = digits_apart(value_used, implied)
        used = format_value(value_used, unit, digits)
        if item := sheet.quantities.get(name):
            used = option(item.name, quote(item.text))
        other = format_value(implied, unit, digits)
        notes.append(
            f"{used} agrees {TO_DIGITS} with the other inputs, which give {other}; "
            "each is used as typed"
        )
    return list(dict.fromkeys(notes))


def contradiction(sheet: Worksheet, error: Disagreement, steps: dict[str, float]) -> ConditionError:
    """Return the error for two values of a symbol, with their units and ratio."""
    inputs = sheet.quantities
    names = [item.name for item in inputs.values()]
    if error.name in symbols.INNER:
        return Contradiction(
            f"{options(names, ' and ')} contradict each other: see the law '{error.law.name}'",
            "fewer of them",
            error.name,
            error.given,
            error.implied,
        )
    unit = coherent_unit_of(error.name, sheet.lit.kind)
    digits = digits_apart(error.given, error.implied)
    name = in_kind(error.name, sheet.lit.kind)
    first = f"{name} {format_value(error.given, unit, digits)}"
    if item := inputs.get(error.name):
        first = option(item.name, item.text)
    ratio = ""
    if error.name in steps:
        ratio = f" (difference {format_number(error.given - error.implied)})"
    elif isinstance(error.implied, float) and error.implied:
        ratio = f" (ratio {format_number(error.given / error.implied, digits)})"
    second = format_value(error.implied, unit, digits)
    return Contradiction(
        f"{first} contradicts the other inputs, which give {second}{ratio}",
        f"leave out one of {options(names, ', ')}",
        error.name,
        error.given,
        error.implied,
    )
