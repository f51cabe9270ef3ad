"""Linear propagation of the standard uncertainties of inputs to results.

Formulas do not handle uncertainties: the answer is computed again with each uncertain input shifted
slightly, and the `uncertainties` package combines the resulting slopes.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, partial
from typing import Any, NamedTuple

from radcalc.answer import Answer, Ends, Remark, Result, Step, Value
from radcalc.calculators.results import in_unit
from radcalc.conversion.linear import Plan
from radcalc.conversion.plan import plan
from radcalc.derivation import DIGITS, digits_apart, format_number, with_unit
from radcalc.errors import (
    ConditionError,
    Contradiction,
    Exclusive,
    Impossible,
    RadcalcError,
    option,
    quote,
)
from radcalc.inputs.given import Input, Inputs, any_uncertain
from radcalc.inputs.quantities import moved
from radcalc.maths import is_array, is_uncertain
from radcalc.quantities.symbols import ANY, Symbol, generic_name
from radcalc.units.amount import Amount
from radcalc.units.parts import Part, check_uncertainty
from radcalc.units.slopes import at_jumps, is_broken, reach, slopes
from radcalc.units.table import resolve
from radcalc.units.uncertain import variable
from radcalc.units.unit import Unit

STANDARD = "standard uncertainty (k = 1)"  # of a single result
ASSUMED = "standard uncertainties (k = 1), propagated linearly"
INDEPENDENT = "standard uncertainties (k = 1) of independent inputs, propagated linearly"
FORMULA = "u(y)^2 = sum of (dy/dx u(x))^2"
REFERENCE = "JCGM 100:2008, 5.1.2"
CURVED = 0.1  # of an uncertainty: greater deviations from the straight line are noted
MANY = "one value of each, or without the uncertainty"

Key = tuple[Any, ...]
Numbers = Mapping[Key, Any]
VALUE = Symbol("", "", (), limits=ANY)  # the value of a conversion, which has no name


class Bend(NamedTuple):
    """An uncertain input on which results depend non-linearly.

    `named` is its name in notes; `bent` are the results; `at` returns all results with the input
    shifted by a multiple (-1 to 1) of its uncertainty; `problem` is the reason for missing ones.
    """

    named: str
    bent: tuple[Key, ...]
    at: Callable[[float], Numbers]
    problem: str = ""

    def number(self, key: Key) -> Callable[[float], float | None]:
        """Return a result as a function of the shift."""
        return lambda shift: self.at(shift).get(key)

    def note(self, label: str, key: Key, in_its_unit: Callable[[float], Any], unit: str) -> str:
        """Return the note on a result: its range, with enough digits to distinguish the ends."""

        def number(shift: float) -> float | None:
            amount = self.at(shift).get(key)
            try:
                size = None if amount is None else float(in_its_unit(amount))
            except RadcalcError:
                if not shift:
                    raise
                return None
            return size if size is not None and math.isfinite(size) else None

        low, high = reach(number)
        digits = DIGITS if math.inf in (-low, high) else digits_apart(low, high)
        least, most = (_amount(end, unit, digits) for end in (low, high))
        ends = f"{least} to {most}"
        if math.inf in (-low, high):
            ends = f"{least} and more, unbounded"
            if low == -math.inf:
                ends = f"{most} and less, unbounded"
                if high == math.inf:
                    ends = "unbounded below and above"
        return f"{label} is far from linear within {self.named}: {ends}"


def with_uncertainties(work_out: Callable[[Inputs], Answer], given: Inputs) -> Answer:
    """Return the answer for the inputs, with uncertain numbers if inputs are uncertain.

    Raises ConditionError if redundant inputs contradict an uncertain one.
    """
    answer = work_out(given)
    if not any_uncertain(given.values()):
        return answer
    nominal = _numbers(answer)
    numbers, bends, ends = _carry(lambda inputs: _numbers(work_out(inputs)), given, nominal)
    answers = []
    for k, alternative in enumerate((answer, *answer.more)):
        values = [_uncertain(value, key, numbers, ends) for key, value in _keys(alternative, k)]
        notes = _notes(bends, dict(_keys(alternative, k)))
        uncertain = [generic_name(v.name) for v in values if is_uncertain(v.si) or v.ends]
        answers.append(
            Answer(
                values,
                (*alternative.assumptions, Remark(_assumed(given), uncertain)),
                (*alternative.notes, *notes),
                _WithShares(alternative.steps, values),
                origins=alternative.origins,
            )
        )
    return answers[0]._replace(more=tuple(answers[1:]))


def of_conversion(result: Result, conversion: "Converted") -> Result:
    """Return the result of a conversion, with its uncertainty."""
    (row,) = result.rows
    name = row.quantity or "the result"
    return result._replace(
        rows=(row._replace(uncertainty=conversion.uncertainty, ends=conversion.ends),),
        assumptions=(*result.assumptions, conversion.assumed),
        notes=(*result.notes, *conversion.notes(name, row.unit)),
        steps=result.steps and (*result.steps, *_shares(name, conversion.number, row.unit)),
    )


class Converted(NamedTuple):
    """A converted number with its uncertainty, the assumption about it, and its bends.

    `ends` are those of its range, which replaces the uncertainty of a number that jumps.
    """

    number: Any
    assumed: str
    bends: Sequence[Bend]
    ends: Ends | None = None

    @property
    def uncertainty(self) -> float:
        return 0.0 if self.ends else getattr(self.number, "std_dev", 0.0)

    def notes(self, name: str, unit: str) -> list[str]:
        notes = [bend.problem for bend in self.bends if bend.problem]
        for bend in self.bends:
            for key in bend.bent:
                notes.append(bend.note(name, key, float, unit))
        return notes


def converted(planned: Plan, amount: Amount, given: Sequence[Input], of: Any = None) -> Converted:
    """Convert an amount, where it or the conditions are uncertain.

    `of` is the Python variable of the amount, if any.
    """

    def work_out(inputs: Inputs) -> Numbers:
        conditions = [item for name, item in inputs.items() if name]
        again = plan(planned.source, planned.target, conditions)
        return {KEY: again.apply(inputs[""].value)}

    inputs = {"": value_of(amount)._replace(variable=of), **{item.name: item for item in given}}
    numbers, bends, ends = _carry(work_out, inputs, {KEY: planned.apply(amount.typed[0])})
    return Converted(numbers[KEY], _assumed(inputs), bends, ends.get(KEY))


def value_of(amount: Amount) -> Input:
    """Return the value of a conversion as an input without a name, in the unit typed."""
    number, off = amount.typed[0], amount.typed_uncertainty
    parts = () if amount.scale else amount.parts  # on a scale, the value is the reading
    return Input(VALUE, amount.text, number, number=number, uncertainty=off, parts=parts)


KEY = ("",)
AS_TYPED = ("given", "exact")  # the fields of a result in its first unit


def _assumed(given: Inputs) -> str:
    """Return the assumption of the propagation; Python variables may be correlated."""
    return INDEPENDENT if all(item.variable is None for item in given.values()) else ASSUMED


def _named(given: Input) -> str:
    return f"{given.symbol.label or 'the value'} {quote(given.text)}"


def _option_text(given: Input) -> str:
    return option(given.name, quote(given.text)) if given.name else quote(given.text)


def _carry(
    work_out: Callable[[Inputs], Numbers], given: Inputs, nominal: Numbers
) -> tuple[dict[Key, Any], list[Bend], dict[Key, Ends]]:
    """Return the numbers with uncertainties, from the slopes over each uncertain input.

    The uncertainty of a number that jumps is not a number; it has the ends of its range instead.
    """
    sources = {name: item for name, item in given.items() if item.is_uncertain}
    for item in sources.values():
        check_uncertainty(item.uncertainty, item.text)
    runs = {name: _Run(work_out, given, name, nominal) for name in sources}
    numbers: dict[Key, Any] = dict(nominal)
    for name, item in sources.items():
        if nonzero := {key: slope for key, slope in runs[name].slopes.items() if slope}:
            shift = _shift(item)
            numbers |= {key: numbers[key] + slope * shift for key, slope in nonzero.items()}
    for key in nominal:
        if is_uncertain(numbers[key]):
            sizes = numbers[key].error_components().values()
            check_uncertainty(math.hypot(*sizes) or math.nan)
    bends = {run: list(run.bends(numbers)) for run in runs.values()}
    ends = {key: found for key in nominal if (found := _ends(key, bends))}
    for key in ends:
        numbers[key] = variable(nominal[key], math.nan)
    return numbers, [bend for found in bends.values() for bend in found], ends


def _ends(key: Key, bends: "Mapping[_Run, Sequence[Bend]]") -> Ends | None:
    """Return the range of a number that jumps or has a corner, over each input; None of others."""
    bent = [bend for found in bends.values() for bend in found if key in bend.bent]
    if not any(is_broken(bend.number(key)) for bend in bent):
        return None
    reached = [end for bend in bent for end in reach(bend.number(key))]
    reached += [side for bend in bent for side in at_jumps(bend.number(key))]
    for run, found in bends.items():
        if not any(key in bend.bent for bend in found):
            off = abs(run.slopes[key] * run.input.uncertainty)
            reached += [run.nominal[key] - off, run.nominal[key] + off]
    ends = min(reached), max(reached)
    return ends if all(map(math.isfinite, ends)) else None


def _shift(given: Input) -> Any:
    """Return an input minus its nominal value [SI], as a variable of `uncertainties`."""
    name, factor = given.name or "value", float(given.unit.factor) if given.unit else 1.0
    if len(given.parts) > 1:
        return sum(
            variable(0.0, 1.0, f"{name} {part.text}") * part.size * factor for part in given.parts
        )
    if given.variable is None:
        return variable(given.size, given.uncertainty, name) - given.size
    return (given.variable - given.variable.nominal_value) * factor


class _Run:
    """One uncertain input, and the results with the input shifted."""

    def __init__(
        self,
        work_out: Callable[[Inputs], Numbers],
        given: Inputs,
        name: str,
        nominal: Mapping[Key, float],
    ) -> None:
        self.work_out, self.name, self.nominal = work_out, name, nominal
        # exact: the tolerance for rounded inputs must not hide a contradiction
        self.given = {key: item._replace(is_exact=True) for key, item in given.items()}
        self.input = given[name]
        self.refused: RadcalcError | None = None
        self.steep: set[Key] = set()  # results without a slope
        self.slopes = self._slopes() if self.input.uncertainty else dict.fromkeys(nominal, 0.0)

    def at(self, shift: float) -> Numbers:
        """Return the results with the input shifted by `shift` [SI]; none if that is refused."""
        nominal_input = self.given[self.name]
        try:
            return self.work_out({**self.given, self.name: moved(nominal_input, shift)})
        except (Contradiction, Exclusive) as error:
            raise ConditionError(
                f"{_option_text(self.input)} is uncertain, and cannot be checked against "
                "redundant inputs",
                error.hint,
            ) from None
        except RadcalcError as error:
            self.refused = error
            return {}

    def _slopes(self) -> dict[Key, float]:
        """Return the slope of each number over the input; one-sided next to a limit.

        An infinite slope is replaced by the change over the uncertainty (JCGM 100:2008, 5.1.3,
        note 2).
        """
        off = self.input.uncertainty
        by_key = {}
        for key, slope in slopes(self.at, self.nominal, abs(self.input.size), off).items():
            if slope is None:
                slope = self._secant(key, off)
                self.steep.add(key)
            by_key[key] = slope
        return by_key

    def _secant(self, key: Key, off: float) -> float:
        for side in (-off, off):
            if (end := self.at(side).get(key)) is not None:
                return float(end - self.nominal[key]) / side
        why = f": {self.refused.message}" if self.refused else ""
        problem = f"the uncertainty of {_option_text(self.input)} cannot be propagated{why}"
        raise ConditionError(problem, "leave it out")

    def bends(self, numbers: Numbers) -> Iterator[Bend]:
        """Yield the bends of results within the uncertainty of the input."""
        given, named = self.input, _named(self.input)
        off, factor = given.uncertainty, given.unit.factor if given.unit else 1
        if not given.parts:
            yield from self._bend(numbers, named, lambda times: times * off, off)
        for part in given.parts:
            where = f"{quote(part.text)} of {named}" if len(given.parts) > 1 else named

            def shift(times: float, part: Part = part) -> float | None:
                whole = part.at(times)
                return None if whole is None else float(whole * factor - given.size)

            yield from self._bend(numbers, where, shift, part.size * factor)

    def _bend(
        self, numbers: Numbers, named: str, shift: Callable[[float], float | None], rise: float
    ) -> Iterator[Bend]:
        """Yield a bend if results are not linear; `shift` maps a part's shift to the input's.

        `rise` is the shift of the input on a straight line.
        """

        @cache
        def at(times: float) -> Numbers:
            size = shift(times)
            return {} if size is None else self.at(size)

        self.refused = None
        sides = [(sign, at(sign)) for sign in (-1.0, -0.5, 0.5, 1.0)]
        problem = ""
        if self.refused or not all(end for _, end in sides):
            limit = ""
            if isinstance(self.refused, Impossible):
                limit = f": it must be {self.refused.limit}"
            problem = f"{named} goes out of range{limit}"
        bent = []
        for key, value in self.nominal.items():
            line = self.slopes[key] * rise
            ends = [(sign, end[key]) for sign, end in sides if key in end]
            away = max((abs(number - value - sign * line) for sign, number in ends), default=0.0)
            total = getattr(numbers[key], "std_dev", 0.0)
            if ends and (key in self.steep or away > max(CURVED * total, 1e-9 * abs(value))):
                bent.append(key)
        if bent or problem:
            yield Bend(named, tuple(bent), at, problem)


def _keys(answer: Answer, k: int) -> Iterator[tuple[Key, Value]]:
    """Yield the results of answer number `k`, each with a unique key."""
    seen: dict[str, int] = {}
    for value in answer.values:
        seen[value.name] = seen.get(value.name, 0) + 1
        yield (k, value.name, seen[value.name]), value


def _numbers(answer: Answer) -> Numbers:
    numbers: dict[Key, float] = {}
    for k, alternative in enumerate((answer, *answer.more)):
        for key, value in _keys(alternative, k):
            if value.is_absent:
                continue
            numbers[*key, ""] = value.amount
            for field in AS_TYPED:
                if (number := getattr(value, field)) is not None:
                    numbers[*key, field] = number
            for dimension, amount in value.reach.items():
                numbers[*key, dimension] = amount
    if any(map(is_array, numbers.values())):
        raise ConditionError("an uncertain value cannot be used with several values", MANY)
    return {key: number for key, number in numbers.items() if math.isfinite(number)}


def _uncertain(value: Value, key: Key, numbers: Numbers, ends: Mapping[Key, Ends]) -> Value:
    if value.is_absent:
        return value
    own_ends = {ending[-1]: found for ending, found in ends.items() if ending[:-1] == key}
    reach = {d: numbers.get((*key, d), amount) for d, amount in value.reach.items()}
    typed = {field: numbers.get((*key, field), getattr(value, field)) for field in AS_TYPED}
    si = numbers.get((*key, ""), value.si)
    return value._replace(si=si, reach=reach, ends=own_ends, **typed)


def _notes(bends: Sequence[Bend], values: dict[Key, Value]) -> list[str]:
    """Return notes on the bends of one answer: one result of each, and a count of the others."""
    notes = [bend.problem for bend in bends if bend.problem]
    for bend in bends:
        bent = [key for key in bend.bent if key[:-1] in values and not key[-1]]
        if not bent:
            continue
        value = values[bent[0][:-1]]
        unit = value.units[0]
        in_its_unit = partial(_in_unit, value, resolve(unit))
        further = len(bent) - 1
        more = f" (and {further} more result{'s' if further > 1 else ''})" if further else ""
        notes.append(bend.note(value.label, bent[0], in_its_unit, unit) + more)
    return notes


def _in_unit(value: Value, unit: Unit, amount: float) -> Any:
    return in_unit(value._replace(si=amount, given=None, exact=None), unit)


def _amount(number: float, unit: str, digits: int = DIGITS) -> str:
    return with_unit(format_number(number, digits), unit)


class _WithShares(Sequence[Step]):
    """The steps of an answer, then the contributions of uncertain inputs to each result."""

    def __init__(self, steps: Sequence[Step], values: Sequence[Value]) -> None:
        self.before, self.values = steps, values

    def _all(self) -> list[Step]:
        return [*self.before, *self._of_values()]

    def _of_values(self) -> Iterator[Step]:
        for value in self.values:
            if value.is_absent or value.given is not None:
                continue
            unit = value.units[0]
            yield from _shares(value.label, in_unit(value, resolve(unit)), unit)

    def __len__(self) -> int:
        """Return the number of steps."""
        return len(self._all())

    def __getitem__(self, k: Any) -> Any:
        """Return a step."""
        return self._all()[k]

    def __iter__(self) -> Iterator[Step]:
        """Return an iterator over all steps, computed once."""
        return iter(self._all())


def _shares(label: str, number: Any, unit: str) -> list[Step]:
    """Return each input's contribution to a result's uncertainty: in its unit, and its share."""
    if not is_uncertain(number) or math.isnan(number.std_dev):
        return []
    # a list, as two inputs may have the same text
    parts = [(source.tag or "an input", size) for source, size in number.error_components().items()]
    total = number.std_dev
    contributions = [
        f"{format_number(size)} by {name} ({(size / total) ** 2 * 100:.3g} %)" if total else name
        for name, size in sorted(parts, key=lambda part: -part[1])
    ]
    numbers = f"{_amount(total, unit)}: {', '.join(contributions)}"
    return [Step(f"uncertainty of {label}", FORMULA, numbers, REFERENCE)]
