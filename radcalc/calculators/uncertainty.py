"""Linear propagation of the standard uncertainties of inputs to results.

Formulas do not handle uncertainties: the answer is computed again with each uncertain input shifted
slightly, and the `uncertainties` package combines the resulting slopes.  An input whose interval
(its value plus and minus its standard uncertainty) has impossible values is refused, and so is a
result that is not near a straight line in it.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, partial
from typing import Any, NamedTuple

from radcalc import errors
from radcalc.answer import Answer, Remark, Result, Step, Value, format_number, with_unit
from radcalc.calculators.results import in_unit, unit_for
from radcalc.conversion import Plan
from radcalc.conversion.plan import plan
from radcalc.errors import quote
from radcalc.inputs import Input, Inputs, any_uncertain
from radcalc.inputs.quantities import moved
from radcalc.maths import is_array, is_uncertain
from radcalc.quantities import name_of
from radcalc.quantities.symbols import ANY, QUANTITY, Symbol, generic_name
from radcalc.units.functions import check_uncertainty, sharpest, slopes
from radcalc.units.numbers import Amount
from radcalc.units.uncertain import variable

STANDARD = "standard uncertainty (k = 1)"  # of a single result
ASSUMED = "standard uncertainties (k = 1), propagated linearly"
INDEPENDENT = "standard uncertainties (k = 1) of independent inputs, propagated linearly"
FORMULA = "u(y)^2 = sum of (dy/dx u(x))^2"
REFERENCE = "JCGM 100:2008, 5.1.2"
CURVED, NOISE = 0.1, 1e-9  # of an uncertainty and of a value: less is on the straight line
SLIGHT = 0.01  # of a value: a deviation to accept, also where the slope is 0
SIDES = (-1.0, -0.5, 0.5, 1.0)
MANY = "one value of each, or without the uncertainty"
NARROWER = "a smaller uncertainty"

Key = tuple[Any, ...]
Numbers = Mapping[Key, Any]
Faults = Mapping[
    Key, tuple[str, errors.Hint]
]  # results without a standard uncertainty: within what
VALUE = Symbol("", "", (), limits=ANY)  # the value of a conversion, which has no name


def with_uncertainties(work_out: Callable[[Inputs], Answer], given: Inputs) -> Answer:
    """Return the answer for the inputs, with uncertain numbers if inputs are uncertain.

    A result that jumps or bends is absent, and a note states the reason.  Raises
    ConditionError if an input leaves its range within its uncertainty, or redundant inputs
    contradict an uncertain one.
    """
    answer = work_out(given)
    if not any_uncertain(given.values()):
        return answer
    numbers, faults = _carry(lambda inputs: _numbers(work_out(inputs)), given, _numbers(answer))
    answers = []
    for k, alternative in enumerate((answer, *answer.more)):
        keyed = list(_keys(alternative, k))
        values = [_uncertain(value, key, numbers, faults) for key, value in keyed]
        uncertain = [generic_name(value.name) for value in values if is_uncertain(value.si)]
        notes = [
            Remark(value.because.message, (generic_name(value.name),))
            for value, (_, before) in zip(values, keyed, strict=True)
            if value.because and not before.is_absent
        ]
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
        rows=(row._replace(uncertainty=conversion.uncertainty),),
        assumptions=(*result.assumptions, conversion.assumed),
        steps=result.steps and (*result.steps, *_shares(name, conversion.number, row.unit)),
    )


class Converted(NamedTuple):
    """A converted number with its uncertainty, and the assumption about it."""

    number: Any
    assumed: str

    @property
    def uncertainty(self) -> float:
        return getattr(self.number, "std_dev", 0.0)


def converted(planned: Plan, amount: Amount, given: Sequence[Input], of: Any = None) -> Converted:
    """Convert an amount, where it or the conditions are uncertain.

    `of` is the Python variable of the amount, if any.
    """

    def work_out(inputs: Inputs) -> Numbers:
        conditions = [item for name, item in inputs.items() if name]
        again = plan(planned.source, planned.target, conditions)
        return {KEY: again.apply(inputs[""].value)}

    inputs = {"": value_of(amount)._replace(variable=of), **{item.name: item for item in given}}
    numbers, faults = _carry(work_out, inputs, {KEY: planned.apply(amount.typed[0])})
    if KEY in faults:
        raise _refusal(name_of(planned.target) or "result", faults[KEY])
    return Converted(numbers[KEY], _assumed(inputs))


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


def _option_text(given: Input) -> str:
    return errors.option(given.name, quote(given.text)) if given.name else quote(given.text)


def _number(at: Callable[[float], Numbers], key: Key, times: float) -> float | None:
    return at(times).get(key)


def _refusal(label: str, fault: tuple[str, errors.Hint]) -> errors.ConditionError:
    where, hint = fault
    problem = f"the {label} has no standard uncertainty: it jumps or bends within {where}"
    return errors.ConditionError(problem, hint)


def _carry(
    work_out: Callable[[Inputs], Numbers], given: Inputs, nominal: Numbers
) -> tuple[dict[Key, Any], Faults]:
    """Return the numbers with uncertainties, and the reasons why some of them have none."""
    sources = {name: item for name, item in given.items() if item.is_uncertain}
    for item in sources.values():
        check_uncertainty(item.uncertainty, item.text)
    varied = [_Varied(work_out, given, name, nominal) for name in sources]
    numbers: dict[Key, Any] = dict(nominal)
    for one in varied:
        if nonzero := {key: slope for key, slope in one.slopes.items() if slope}:
            shift = _shift(one.input)
            numbers |= {key: numbers[key] + slope * shift for key, slope in nonzero.items()}
    for key in nominal:
        if is_uncertain(numbers[key]):
            sizes = numbers[key].error_components().values()
            check_uncertainty(math.hypot(*sizes) or math.nan)
    faults: dict[Key, tuple[str, errors.Hint]] = {}
    for one in varied:
        faults = {**dict(one.faults(numbers)), **faults}
    return numbers, faults


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


class _Varied:
    """One uncertain input, and the results with the input shifted.

    Raises ConditionError if the input leaves its range within its uncertainty.
    """

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
        self.refused: errors.RadcalcError | None = None
        self.ways = list(self._ways())
        if self.refused or not all(at(side) for _, at, _ in self.ways for side in SIDES):
            raise self._out_of_range()
        size, off = abs(self.input.size), self.input.uncertainty
        self.slopes: Mapping[Key, float | None] = (
            slopes(self.at, nominal, size, off) if off else dict.fromkeys(nominal, 0.0)
        )

    def at(self, shift: float) -> Numbers:
        """Return the results with the input shifted by `shift` [SI]; none if that is refused."""
        nominal_input = self.given[self.name]
        try:
            return self.work_out({**self.given, self.name: moved(nominal_input, shift)})
        except (errors.Contradiction, errors.Exclusive) as error:
            raise errors.ConditionError(
                f"{_option_text(self.input)} is uncertain, and cannot be checked against "
                "redundant inputs",
                error.hint,
            ) from None
        except errors.RadcalcError as error:
            self.refused = error
            return {}

    def _ways(self) -> Iterator[tuple[str, Callable[[float], Numbers], float]]:
        """Yield the input, or each number of its expression.

        Each has a name in messages, a function that returns the results with it shifted by a
        multiple (-1 to 1) of its uncertainty, and the shift of the input on a straight line.
        """
        given = self.input
        off, factor = given.uncertainty, given.unit.factor if given.unit else 1
        named = f"{given.symbol.label or 'the value'} {quote(given.text)}"
        if not given.parts:
            yield named, cache(lambda times: self.at(times * off)), off
        for part in given.parts:

            def at(times: float, whole_at: Callable[[float], Any] = part.at) -> Numbers:
                whole = whole_at(times)
                return {} if whole is None else self.at(float(whole * factor - given.size))

            where = f"{quote(part.text)} of {named}" if len(given.parts) > 1 else named
            yield where, cache(at), part.size * factor

    def _out_of_range(self) -> errors.ConditionError:
        refused, text = self.refused, _option_text(self.input)
        problem = f"{text} is out of range within its uncertainty"
        if isinstance(refused, errors.Impossible):
            return errors.ConditionError(problem, refused.limit)
        return errors.ConditionError(
            f"{problem}: {refused.message}" if refused else problem, NARROWER
        )

    def faults(self, numbers: Numbers) -> Iterator[tuple[Key, tuple[str, errors.Hint]]]:
        """Yield the results that have no standard uncertainty: within what, and a hint."""
        for where, at, rise in self.ways:
            sides = {side: at(side) for side in SIDES}
            for key, value in self.nominal.items():
                slope, away = self.slopes[key], math.inf
                if slope is not None and all(key in side for side in sides.values()):
                    away = max(abs(sides[t][key] - value - t * slope * rise) for t in sides)
                total = getattr(numbers[key], "std_dev", 0.0)
                if away <= max(CURVED * total, NOISE * abs(value)):
                    continue
                slight = max(CURVED * total, SLIGHT * abs(value))
                is_bent = away > max(total, slight)
                if is_bent or sharpest(partial(_number, at, key)) > slight:
                    yield key, (where, self._ends())

    def _ends(self) -> errors.Hint:
        """Propose a call for each end of the interval."""
        given = self.input
        if given.parts or given.symbol.form != QUANTITY or given.variable is not None:
            return NARROWER
        unit = given.unit_text if given.unit else ""
        off = given.uncertainty / (float(given.unit.factor) if given.unit else 1.0)
        texts = [f"{given.number + end:.12g}{unit}" for end in (-off, off)]
        return errors.corrections(given.text, *texts)


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
        raise errors.ConditionError("an uncertain value cannot be used with several values", MANY)
    return {key: number for key, number in numbers.items() if math.isfinite(number)}


def _uncertain(value: Value, key: Key, numbers: Numbers, faults: Faults) -> Value:
    """Return a result with its uncertainty; an absent one if it has none, with the reason."""
    if value.is_absent:
        return value
    if fault := next((fault for found, fault in faults.items() if found[:-1] == key), None):
        because = _refusal(value.label, fault)
        return value._replace(si=0.0, reach={}, units=(), because=because)
    reach = {d: numbers.get((*key, d), amount) for d, amount in value.reach.items()}
    typed = {field: numbers.get((*key, field), getattr(value, field)) for field in AS_TYPED}
    si = numbers.get((*key, ""), value.si)
    return value._replace(si=si, reach=reach, **typed)


def _amount(number: float, unit: str) -> str:
    return with_unit(format_number(number), unit)


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
            yield from _shares(value.label, in_unit(value, unit_for(value, unit)), unit)

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
    if not is_uncertain(number):
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
