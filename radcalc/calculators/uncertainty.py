"""Standard uncertainties of what is given, carried linearly to what follows.

No formula knows of them: the whole answer is worked out anew with each uncertain input moved a
little, and the slopes found so are combined by the `uncertainties` package.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from radcalc.answer import Answer, Result, Step, Value
from radcalc.calculators.results import in_unit
from radcalc.conversion.plan import Plan, plan
from radcalc.derivation import format_number
from radcalc.errors import (
    ConditionError,
    Contradiction,
    Exclusive,
    Impossible,
    RadcalcError,
    option,
    quote,
)
from radcalc.given import Given, Inputs, any_uncertain, moved
from radcalc.maths import is_array, is_uncertain
from radcalc.quantities.symbols import ANY, Symbol
from radcalc.units.amounts import Amount
from radcalc.units.table import resolve
from radcalc.units.uncertain import variable

ASSUMED = "standard uncertainties (k = 1), carried linearly"
INDEPENDENT = "standard uncertainties (k = 1) of independent inputs, carried linearly"
FORMULA = "u(y)^2 = sum of (dy/dx u(x))^2"
REFERENCE = "JCGM 100:2008, 5.1.2"
STEP, LEAST_STEP = 2.0**-10, 2.0**-20  # of an input, relative to it
OF_ZERO = 16  # steps in the uncertainty of an input that is 0
NOISE = 1e-14  # what the arithmetic adds to a result, relative to it
DIGITS = 11  # that a slope is good for
CURVED = 0.1  # of an uncertainty: by how much more a result may leave its straight line
MANY = "one value of each, or without the uncertainty"

Key = tuple[Any, ...]
Numbers = Mapping[Key, Any]
VALUE = Symbol("", "", (), limits=ANY)  # of a conversion: no option names it


class Bend(NamedTuple):
    """An uncertain input within which a result is no straight line.

    `ends` are the results at both ends; `problem` says why there is none at one of them.
    """

    given: Given
    ends: dict[Key, tuple[float, float]]
    problem: str = ""

    def note(self, label: str, low: str, high: str) -> str:
        """What to say of a result."""
        return f"{label} is far from linear within {_named(self.given)}: {low} to {high}"


def with_uncertainties(work_out: Callable[[Inputs], Answer], given: Inputs) -> Answer:
    """The answer to what is given; where that is uncertain, the numbers are.

    Raises ConditionError where more is given than needed, and nothing tells what counts.
    """
    answer = work_out(given)
    if not any_uncertain(given.values()):
        return answer
    nominal = _numbers(answer)
    numbers, bends = _carry(lambda inputs: _numbers(work_out(inputs)), given, nominal)
    every = []
    for k, one in enumerate((answer, *answer.more)):
        values = [_uncertain(value, key, numbers) for key, value in _keys(one, k)]
        notes = _notes(bends, dict(_keys(one, k)))
        every.append(
            Answer(
                values,
                (*one.assumptions, _assumed(given)),
                (*one.notes, *notes),
                _WithShares(one.steps, values),
            )
        )
    return every[0]._replace(more=tuple(every[1:]))


def of_conversion(shown: Result, found: "Converted") -> Result:
    """The result of a conversion, with its uncertainty."""
    (row,) = shown.rows
    name = row.quantity or "the result"
    notes = [bend.problem for bend in found.bends if bend.problem]
    for bend in found.bends:
        for ends in bend.ends.values():
            low, high = (_amount(end, row.unit) for end in ends)
            notes.append(bend.note(name, low, high))
    return shown._replace(
        rows=(row._replace(uncertainty=getattr(found.number, "std_dev", 0.0)),),
        assumptions=(*shown.assumptions, found.assumed),
        notes=(*shown.notes, *notes),
        steps=shown.steps and (*shown.steps, *_shares(name, found.number, row.unit)),
    )


class Converted(NamedTuple):
    """A converted number with its uncertainty, what is assumed of it, and the bends on the way."""

    number: Any
    assumed: str
    bends: Sequence[Bend]


def converted(made: Plan, amount: Amount, given: Sequence[Given], of: Any = None) -> Converted:
    """Convert an amount that is uncertain, or is converted under uncertain conditions.

    `of` is the variable that the amount is, where it is one of Python's.
    """

    def work_out(inputs: Inputs) -> Numbers:
        conditions = [one for name, one in inputs.items() if name]
        again = plan(made.source, made.target, conditions)
        return {KEY: again.apply(inputs[""].value)}

    inputs = {"": value_of(amount)._replace(variable=of), **{one.name: one for one in given}}
    numbers, bends = _carry(work_out, inputs, {KEY: made.apply(amount.typed[0])})
    return Converted(numbers[KEY], _assumed(inputs), bends)


def value_of(amount: Amount) -> Given:
    """The value of a conversion as an input: in the unit that was typed, and with no name."""
    number, off = amount.typed[0], amount.typed_uncertainty
    return Given(VALUE, amount.text, number, number=number, uncertainty=off, parts=amount.parts)


KEY = ("",)
AS_TYPED = ("given", "exact")  # the fields of a result in its first unit


def _assumed(given: Inputs) -> str:
    """What carrying assumes; variables of Python's know themselves what they depend on."""
    return INDEPENDENT if all(one.variable is None for one in given.values()) else ASSUMED


def _named(given: Given) -> str:
    """An input as it was typed, behind its name, for a note."""
    return f"{given.symbol.label or 'the value'} {quote(given.text)}"


def _told(given: Given) -> str:
    """An input as it was typed, for a message."""
    return option(given.name, quote(given.text)) if given.name else quote(given.text)


def _carry(
    work_out: Callable[[Inputs], Numbers], given: Inputs, nominal: Numbers
) -> tuple[dict[Key, Any], list[Bend]]:
    """Numbers with their uncertainties, by the slopes over each uncertain input."""
    sources = {name: one for name, one in given.items() if one.uncertainty}
    for one in sources.values():
        if not math.isfinite(one.uncertainty):
            raise ConditionError(f"{_told(one)} has no finite uncertainty", "a number")
    runs = {name: _Run(work_out, given, name) for name in sources}
    slopes = {name: run.slopes(nominal) for name, run in runs.items()}
    numbers: dict[Key, Any] = dict(nominal)
    for name, one in sources.items():
        for key, slope in slopes[name].items():
            if slope:
                numbers[key] = numbers[key] + slope * _shift(one)
    bends = [
        bend
        for name, run in runs.items()
        if (bend := run.bend(nominal, slopes[name], numbers)) is not None
    ]
    return numbers, bends


def _shift(given: Given) -> Any:
    """An input less its nominal value [SI]: a variable of the `uncertainties` package."""
    name, factor = given.name or "value", float(given.unit.factor) if given.unit else 1.0
    if len(given.parts) > 1:
        return sum(
            variable(0.0, 1.0, f"{name} {text}") * size * factor for text, size in given.parts
        )
    if given.variable is None:
        return variable(given.size, given.uncertainty, name) - given.size
    return (given.variable - given.variable.nominal_value) * factor


class _Run:
    """One uncertain input, and what follows where it is moved."""

    def __init__(self, work_out: Callable[[Inputs], Numbers], given: Inputs, name: str) -> None:
        self.work_out, self.name = work_out, name
        # without the room that roundings leave between inputs that contradict each other
        self.given = {key: one._replace(is_exact=True) for key, one in given.items()}
        self.input = given[name]
        self.refused: RadcalcError | None = None

    def at(self, shift: float) -> Numbers:
        """What follows with the input moved by so much [SI]; nothing where that is refused."""
        one = self.given[self.name]
        try:
            return self.work_out({**self.given, self.name: moved(one, shift)})
        except (Contradiction, Exclusive) as error:
            raise ConditionError(
                f"more is given than needed beside {_told(self.input)}, which is uncertain, and "
                "nothing tells what of it counts",
                error.hint,
            ) from None
        except RadcalcError as error:
            self.refused = error
            return {}

    def slopes(self, nominal: Numbers) -> dict[Key, float]:
        """The slope of each number over the input; one-sided next to a limit."""
        size, off = abs(self.input.size), self.input.uncertainty
        step = max(min(size * STEP or off / OF_ZERO, off / 2), size * LEAST_STEP)
        points = {k: self.at(k * step) for k in (-2, -1, 1, 2)}
        found = {}
        for key, value in nominal.items():
            at = {k: numbers[key] for k, numbers in points.items() if key in numbers}
            slope = _slope({0: value, **at}, step)
            if slope is None:
                why = f": {self.refused.message}" if self.refused else ""
                problem = f"the uncertainty of {_told(self.input)} cannot be carried{why}"
                raise ConditionError(problem, "the same without it")
            found[key] = slope
        return found

    def bend(self, nominal: Numbers, slopes: dict[Key, float], numbers: Numbers) -> Bend | None:
        """Where results leave their straight lines within the uncertainty of the input."""
        off = self.input.uncertainty
        self.refused = None
        low, high = self.at(-off), self.at(off)
        if self.refused:
            limit = f": {self.refused.limit}" if isinstance(self.refused, Impossible) else ""
            problem = f"{_named(self.input)} reaches what is not possible{limit}"
            return Bend(self.input, {}, problem)
        ends = {}
        for key, value in nominal.items():
            total = getattr(numbers[key], "std_dev", 0.0)
            line = slopes[key] * off
            if key not in low or key not in high:
                continue
            away = max(abs(high[key] - value - line), abs(low[key] - value + line))
            if away > max(CURVED * total, 1e-9 * abs(value)):
                three = low[key], value, high[key]
                ends[key] = min(three), max(three)
        return Bend(self.input, ends) if ends else None


def _slope(at: dict[int, float], step: float) -> float | None:
    """The slope at 0 from values at whole steps beside it; None where these are too few."""
    if max(abs(value - at[0]) for value in at.values()) <= NOISE * abs(at[0]):
        return 0.0 if len(at) > 1 else None
    if len(at) == 5:
        rise = (8 * (at[1] - at[-1]) - (at[2] - at[-2])) / 12
    elif 1 in at and -1 in at:
        rise = (at[1] - at[-1]) / 2
    else:
        side = 1 if 1 in at else -1
        if 2 * side not in at or side not in at:
            return None
        rise = side * (4 * at[side] - 3 * at[0] - at[2 * side]) / 2
    return float(f"{rise / step:.{DIGITS}g}")


def _keys(answer: Answer, k: int) -> Iterator[tuple[Key, Value]]:
    """The results of one of several answers, with what tells each from all others."""
    seen: dict[str, int] = {}
    for value in answer.values:
        seen[value.name] = seen.get(value.name, 0) + 1
        yield (k, value.name, seen[value.name]), value


def _numbers(answer: Answer) -> Numbers:
    """All numbers of an answer: of each result that in SI units, as typed, and in other kinds."""
    found: dict[Key, float] = {}
    for k, one in enumerate((answer, *answer.more)):
        for key, value in _keys(one, k):
            if value.is_absent:
                continue
            found[*key, ""] = value.amount
            for field in AS_TYPED:
                if (number := getattr(value, field)) is not None:
                    found[*key, field] = number
            for dimension, amount in value.reach.items():
                found[*key, dimension] = amount
    if any(map(is_array, found.values())):
        raise ConditionError("several values stand beside an uncertain one", MANY)
    return {key: number for key, number in found.items() if math.isfinite(number)}


def _uncertain(value: Value, key: Key, numbers: Numbers) -> Value:
    """A result with the uncertainties of its numbers."""
    if value.is_absent:
        return value
    reach = {d: numbers.get((*key, d), amount) for d, amount in value.reach.items()}
    typed = {field: numbers.get((*key, field), getattr(value, field)) for field in AS_TYPED}
    return value._replace(si=numbers.get((*key, ""), value.si), reach=reach, **typed)


def _notes(bends: Sequence[Bend], values: dict[Key, Value]) -> list[str]:
    """What to say of the bends of one answer: one result of each, and how many more there are."""
    notes = [bend.problem for bend in bends if bend.problem]
    for bend in bends:
        bent = [key for key in bend.ends if key[:-1] in values and not key[-1]]
        if not bent:
            continue
        value = values[bent[0][:-1]]
        unit = value.units[0]
        ends = (value._replace(si=end, given=None, exact=None) for end in bend.ends[bent[0]])
        low, high = (_amount(in_unit(end, resolve(unit)), unit) for end in ends)
        more = f" (and {len(bent) - 1} more results)" if len(bent) > 1 else ""
        notes.append(bend.note(value.label, low, high) + more)
    return notes


def _amount(number: float, unit: str) -> str:
    return format_number(number) if unit == "1" else f"{format_number(number)} {unit}"


class _WithShares(Sequence[Step]):
    """The steps of an answer, then what each uncertain input adds to each result."""

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
        """How many there are."""
        return len(self._all())

    def __getitem__(self, k: Any) -> Any:
        """One of them."""
        return self._all()[k]

    def __iter__(self) -> Iterator[Step]:
        """All of them, worked out once."""
        return iter(self._all())


def _shares(label: str, number: Any, unit: str) -> list[Step]:
    """What each input adds to the uncertainty of a result: in its unit, and of its square."""
    if not is_uncertain(number):
        return []
    parts = {one.tag or "an input": size for one, size in number.error_components().items()}
    whole = number.std_dev
    told = [
        f"{format_number(size)} by {name} ({(size / whole) ** 2 * 100:.3g} %)" if whole else name
        for name, size in sorted(parts.items(), key=lambda part: -part[1])
    ]
    numbers = f"{_amount(whole, unit)}: {', '.join(told)}"
    return [Step(f"uncertainty of {label}", FORMULA, numbers, REFERENCE)]
