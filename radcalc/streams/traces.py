"""A calculation on floats, recorded once and repeated for columns of them.

A number that is traced does what a float does, and has it noted down: each operation as a step,
each comparison as a bound within which the calculation takes the same way.  The steps are then
repeated for many numbers at a time, by the same functions on the same floats in the same order:
every result is, to its last bit, that of a calculation of its own.  What is outside the bounds,
or refused, is left to that.
"""

import math
import operator
from collections.abc import Callable, Sequence
from functools import partial
from itertools import product, repeat
from sys import float_info
from typing import Any, NamedTuple, NoReturn

from radcalc.errors import RadcalcError
from radcalc.streams import MARK

MOST_STEPS = 5000  # of a calculation that is recorded
MOST_NUMBERS = 200_000  # of all steps at a time
REFUSALS = (ValueError, ZeroDivisionError, OverflowError, RadcalcError)  # by a function of floats
FINITE = (-float_info.max, float_info.max)

# Functions that refuse no finite floats; those that rise or fall with each operand: of any sign,
# from 0 on, and with the first from 0 to an end.
NEVER_REFUSED = {operator.add, operator.sub, operator.mul, operator.neg, operator.abs, float}
SIGNED = {operator.add, operator.sub, operator.mul, operator.neg}
MONOTONE = {operator.truediv, operator.abs, math.hypot, math.sqrt, math.atan2}
MONOTONE |= {math.atan, math.exp, math.expm1, math.log, math.log10, math.log2, math.log1p}
UP_TO = {operator.pow: math.inf, math.cos: math.pi, math.sin: math.pi / 2, math.tan: math.pi / 2}
ROOM = 1e-9  # for roundings, which need not rise where the function does

Function = Callable[..., Any]
Range = tuple[float, float]
Operand = int | tuple[Any]  # an earlier step by its number, or a constant


class Untraceable(BaseException):
    """Raised where a record cannot have what is asked of a number; nothing else may catch it."""


class Trace:
    """A record of what is done with a number, which is the first of its steps."""

    def __init__(self, value: float) -> None:
        """Begin with a number."""
        self.steps: list[tuple[Function, tuple[Operand, ...]]] = [(float, ())]
        self.bounds: dict[int, Range] = {}
        self.orders: dict[tuple[Function, int, int], bool] = {}
        self.start = Traced(self, 0, value)
        self._known: dict[Any, Traced] = {}
        self._is_broken = False

    def refuse(self) -> NoReturn:
        """Give the record up, even if somebody catches what this raises."""
        self._is_broken = True
        raise Untraceable

    def do(self, function: Function, *operands: Any) -> Any:
        """Take a step, or give the result of the same step as before."""
        if any(isinstance(one, Unknown) for one in operands):
            return Unknown(self)
        try:
            value = function(*[one.value if isinstance(one, Traced) else one for one in operands])
        except REFUSALS:
            self._is_broken = True  # other numbers may not be refused
            raise
        if type(value) is not float or len(self.steps) > MOST_STEPS:
            self.refuse()
        places = tuple([one.step if isinstance(one, Traced) else (one,) for one in operands])
        key = (function, *[one if type(one) is int else _key(*one) for one in places])  # type: ignore[misc]
        if key not in self._known:
            self._known[key] = Traced(self, len(self.steps), value)
            self.steps.append((function, places))
        return self._known[key]

    def compare(self, how: Function, one: "Traced", other: Any) -> bool:
        """Give the outcome of a comparison, and bound the record to where it is the same."""
        value: float = one.value
        if isinstance(other, Traced):
            outcome: bool = how(value, other.value)
            if other is one:
                self.bound(one, *FINITE)  # and so no NaN
            else:
                self.orders[how, one.step, other.step] = outcome
            return outcome
        if isinstance(other, Unknown) or not isinstance(other, (int, float)) or other != other:
            self.refuse()
        if value == other:
            self.bound(one, value, value)
        elif value > other:
            self.bound(one, math.nextafter(other, math.inf), FINITE[1])
        else:
            self.bound(one, FINITE[0], math.nextafter(other, -math.inf))
        return how(value, other)  # type: ignore[no-any-return]

    def bound(self, one: "Traced", low: float, high: float) -> None:
        """Bound a step, both ends included; that keeps it finite as well."""
        if one.value - one.value != 0:
            self.refuse()
        lowest, highest = self.bounds.get(one.step, FINITE)
        self.bounds[one.step] = max(low, lowest), min(high, highest)

    def record(self, results: Sequence[Any]) -> "Recording":
        """What is to be repeated for these results; Untraceable where that cannot be."""
        if self._is_broken or any(isinstance(one, Unknown) for one in results):
            raise Untraceable
        return Recording(self, results)


def _key(constant: Any) -> Any:
    """What tells constants apart: 0.0 is neither 0 nor -0.0."""
    return (type(constant), repr(constant)) if type(constant) in (int, float) else id(constant)


def _is_number(x: Any) -> bool:
    return isinstance(x, (int, float, Traced, Unknown))


def _is(number: int, x: Any) -> bool:
    return isinstance(x, (int, float)) and x == number


def _operator(function: Function, nothing: int | None = None, reflected: bool = False) -> Function:
    """A method that takes a step; the operand that changes `nothing` takes none."""

    def do(self: "Traced", other: Any) -> Any:
        if nothing is not None and _is(nothing, other):
            return self
        if not _is_number(other):
            return NotImplemented
        return self.trace.do(function, *((other, self) if reflected else (self, other)))

    return do


_reflected = partial(_operator, reflected=True)


def _comparison(how: Function) -> Function:
    return lambda self, other: self.trace.compare(how, self, other)


def _plus(self: "Traced", other: Any) -> Any:
    """The sum; 0 changes all but -0."""
    if _is(0, other) and self.value != 0 and self != 0:
        return self
    return self.trace.do(operator.add, self, other) if _is_number(other) else NotImplemented


def _minus(self: "Traced", other: Any) -> Any:
    """The difference; of a number and itself it is 0 where it is finite."""
    if other is self:
        self.trace.bound(self, *FINITE)
        return 0.0
    return self.trace.do(operator.sub, self, other) if _is_number(other) else NotImplemented


def _size(self: "Traced") -> Any:
    """The number without its sign."""
    return self if self > 0 else self.trace.do(operator.abs, self)


def _negative(self: "Traced") -> Any:
    return self.trace.do(operator.neg, self)


def _is_not_0(self: "Traced") -> bool:
    return bool(self != 0)


def _refuse(self: "Traced | Unknown", *others: Any) -> NoReturn:
    self.trace.refuse()


def _text(self: "Traced", form: str = "") -> str:
    return MARK


class Traced:
    """A number whose part in a calculation is recorded.

    What changes no float is left out: the sum with 0, the product with 1, the size of what is
    positive.
    """

    __slots__ = ("step", "trace", "value")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, trace: Trace, step: int, value: float) -> None:
        """Hold what a step gives."""
        self.trace, self.step, self.value = trace, step, value

    def call(self, function: Function, *operands: Any) -> Any:
        """What a function of floats gives, as one step."""
        return self.trace.do(function, *operands)

    __add__ = __radd__ = _plus
    __sub__, __rsub__ = _minus, _reflected(operator.sub)
    __mul__ = _operator(operator.mul, nothing=1)
    __rmul__ = _reflected(operator.mul, nothing=1)
    __truediv__ = _operator(operator.truediv, nothing=1)
    __rtruediv__ = _reflected(operator.truediv)
    __pow__, __rpow__ = _operator(operator.pow, nothing=1), _reflected(operator.pow)
    __mod__, __rmod__ = _operator(operator.mod), _reflected(operator.mod)
    __neg__, __abs__ = _negative, _size
    __lt__, __le__ = _comparison(operator.lt), _comparison(operator.le)
    __gt__, __ge__ = _comparison(operator.gt), _comparison(operator.ge)
    __eq__, __ne__ = _comparison(operator.eq), _comparison(operator.ne)
    __bool__ = _is_not_0
    __float__ = __int__ = __index__ = _refuse
    __format__ = __str__ = __repr__ = _text


class Unknown:
    """A number that another line may have otherwise, and that no result may depend on."""

    __hash__ = None  # type: ignore[assignment]

    def __init__(self, trace: Trace) -> None:
        """Belong to a record."""
        self.trace = trace

    def call(self, function: Function, *operands: Any) -> "Unknown":
        """What a function gives is as unknown."""
        return self

    def _also(self, *others: Any) -> "Unknown":
        return self

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = _also
    __truediv__ = __rtruediv__ = __pow__ = __rpow__ = __neg__ = __abs__ = _also
    __lt__ = __le__ = __gt__ = __ge__ = __eq__ = __ne__ = _refuse
    __bool__ = __float__ = _refuse


class _Step(NamedTuple):
    """A step of a record, and comparisons of it and an earlier one, with their outcomes."""

    number: int
    function: Function
    operands: tuple[Operand, ...]
    orders: list[tuple[Function, int, int, bool]]


def _is_monotone(function: Function, ranges: Sequence[Any]) -> bool:
    """Whether a function rises or falls all along with each operand, between these ends."""
    if function in SIGNED:
        return True
    if function in UP_TO:
        return bool(ranges[0][0] >= 0 and ranges[0][1] <= UP_TO[function])
    return function in MONOTONE and all(low >= 0 for low, _ in ranges)


def _is_sure(how: Function, one: int, other: int, outcome: bool, ranges: dict[int, Range]) -> bool:
    """Whether two ranges do not meet, and a comparison has that outcome."""
    if one not in ranges or other not in ranges:
        return False
    (low, high), (least, most) = ranges[one], ranges[other]
    return (high < least or most < low) and how(low, least) is outcome


class Recording:
    """The steps that lead to results, repeated for many numbers at a time."""

    def __init__(self, trace: Trace, results: Sequence[Any]) -> None:
        """Take the steps, of which some may turn out to be of no use."""
        self.results = [one.step if isinstance(one, Traced) else (float(one),) for one in results]
        self.bounds = trace.bounds
        orders: dict[int, list[tuple[Function, int, int, bool]]] = {}
        for (how, one, other), outcome in trace.orders.items():
            orders.setdefault(max(one, other), []).append((how, one, other, outcome))
        self.steps = [
            _Step(k, function, operands, orders.get(k, []))
            for k, (function, operands) in enumerate(trace.steps)
        ]

    def run(self, values: list[float]) -> tuple[list[int] | None, list[list[float]]]:
        """The results in columns, and for which of the numbers they are: None for all of them.

        The others are outside the bounds, or are refused.  Many are taken in parts, for which
        there is room.
        """
        size = max(MOST_NUMBERS // len(self.steps), 1)
        if len(values) <= size:
            return self._run(values)
        together: list[int] = []
        columns: list[list[float]] = [[] for _ in self.results]
        for start in range(0, len(values), size):
            part = values[start : start + size]
            places, found = self._run(part)
            together += [start + k for k in (range(len(part)) if places is None else places)]
            for column, more in zip(columns, found, strict=True):
                column += more
        return (None if len(together) == len(values) else together), columns

    def _run(self, values: list[float]) -> tuple[list[int] | None, list[list[float]]]:
        places: list[int] | None = None
        while values:
            try:
                good, columns = self._repeat(values)
            except REFUSALS:
                good, columns = self._halved(values)
            if good is None:
                return places, columns
            kept = [k for k, is_good in enumerate(good) if is_good]
            values = [values[k] for k in kept]
            places = kept if places is None else [places[k] for k in kept]
        return [], [[] for _ in self.results]

    def _repeat(self, values: list[float]) -> tuple[list[bool] | None, list[list[float]]]:
        """The results; or which of the numbers keep within the first bounds that not all do."""
        columns: dict[int, list[float]] = {0: values}
        for step, bounds in self._needed(self._ranges(min(values), max(values))):
            if step.number:
                operands = step.operands
                of = [columns[one] if isinstance(one, int) else repeat(*one) for one in operands]
                columns[step.number] = list(map(step.function, *of))
            if bounds:
                low, high = bounds
                good = [low <= value <= high for value in columns[step.number]]
                if not all(good):
                    return good, []
            for how, one, other, outcome in step.orders:
                pairs = zip(columns[one], columns[other], strict=True)
                good = [how(*pair) is outcome for pair in pairs]
                if not all(good):
                    return good, []
        count = len(values)
        return None, [
            columns[one] if isinstance(one, int) else list(one) * count for one in self.results
        ]

    def _ranges(self, low: float, high: float) -> dict[int, Range]:
        """Between what the steps are surely, and not refused, for numbers from low to high.

        A function that rises or falls with each of its operands has its extremes at their ends.
        """
        ranges = {0: (low, high)}
        for step in self.steps[1:]:
            of = [ranges.get(one) if isinstance(one, int) else one * 2 for one in step.operands]
            if None in of or not _is_monotone(step.function, of):
                continue
            try:
                ends = [step.function(*corner) for corner in product(*of)]  # type: ignore[arg-type]
            except REFUSALS:
                continue
            least, most = min(ends), max(ends)
            if all(map(math.isfinite, ends)):
                ranges[step.number] = least - abs(least) * ROOM, most + abs(most) * ROOM
        return ranges

    def _needed(self, ranges: dict[int, Range]) -> "list[tuple[_Step, Range | None]]":
        """The steps that lead to the results or to bounds that may be left, with these bounds."""
        wanted = {one for one in self.results if isinstance(one, int)}
        needed: list[tuple[_Step, Range | None]] = []
        for step in reversed(self.steps):
            bounds, found = self.bounds.get(step.number), ranges.get(step.number)
            if bounds and found and bounds[0] <= found[0] and found[1] <= bounds[1]:
                bounds = None
            orders = [one for one in step.orders if not _is_sure(*one, ranges)]
            for _, *two, _ in orders:
                wanted.update(two)
            may_be_refused = found is None and step.function not in NEVER_REFUSED
            if bounds or orders or may_be_refused or step.number in wanted:
                wanted.update(one for one in step.operands if isinstance(one, int))
                needed.append((step._replace(orders=orders), bounds))
        return needed[::-1]

    def _halved(self, values: list[float]) -> tuple[list[bool], list[list[float]]]:
        """Which of the numbers can be worked out, where a function refuses some of them."""
        if len(values) == 1:
            return [False], []
        middle = len(values) // 2
        good: list[bool] = []
        for part in (values[:middle], values[middle:]):
            places, _ = self.run(part)
            fits = range(len(part)) if places is None else set(places)
            good += [k in fits for k in range(len(part))]
        return good, []
