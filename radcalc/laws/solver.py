"""Solving laws for whatever is missing, and checking them against what is given twice.

- `solve`: everything that follows from what is given, law by law
- `reached`: which symbols would follow, whatever their values
- `rounding`: how far a number may be off as typed, which is what a check allows
- `Derivation`: the steps of an answer

Values are in coherent SI units, floats or arrays.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

from radcalc.answer import Step
from radcalc.derivation import coherent_unit_of, fill, format_value, letter_of
from radcalc.errors import ConditionError, NumberError
from radcalc.laws.law import AnyLaw, Relation
from radcalc.maths import any_true, is_array
from radcalc.units.numbers import read_number

EXACT = 1e-9  # what rounding in the arithmetic may add
FEWEST_DIGITS = 3  # 2m is meant as 2.00 m


class Known(NamedTuple):
    """A value, how far it may be off as typed, and its text where it was given.

    Attributes
    ----------
    value : float or ndarray [SI]
        The value.
    rounding : float [1]
        How far it may be off, relative to it.
    text : str
        What was typed; empty where the value follows.

    Examples
    --------
    >>> Known(2.0, rounding("2m"), "2m").rounding
    0.0025
    """

    value: Any
    rounding: float = 0.0
    text: str = ""


Values = dict[str, Known]


class Solution(NamedTuple):
    """Every value that follows, and how.

    Attributes
    ----------
    values : dict of str to Known
        What was given and what follows, by the names of symbols.
    used : list of (law, str)
        The laws that gave something, in that order, and the symbol each was solved for.

    Examples
    --------
    >>> from radcalc.laws.sizes import CIRCLE
    >>> [(law.name, target) for law, target in solve([CIRCLE], {"area": Known(1.0)}).used]
    [('area of a circle', 'radius')]
    """

    values: Values
    used: list[tuple[AnyLaw, str]]


class Disagreement(ConditionError):
    """Two values of one symbol, by a law; whoever knows what was given says it with units.

    Parameters
    ----------
    law : Law or Relation
        The law that is broken.
    name : str
        The symbol.
    given, found : float or ndarray [SI]
        Its value, and that which the law gives.

    Attributes
    ----------
    law, name, given, found
        As the parameters.

    Examples
    --------
    >>> from radcalc.laws.sizes import DIAMETER
    >>> Disagreement(DIAMETER, "diameter", 3.0, 2.0).message
    "diameter contradicts the others by the law 'diameter'"
    """

    def __init__(self, law: AnyLaw, name: str, given: Any, found: Any) -> None:
        super().__init__(f"{name} contradicts the others by the law '{law.name}'", "fewer of them")
        self.law, self.name, self.given, self.found = law, name, given, found


def rounding(text: str) -> float:
    """How far a number may be off as typed: half a unit of its last digit, relative to it.

    Parameters
    ----------
    text : str
        A number, with or without a unit behind it.

    Returns
    -------
    float [1]
        A short number counts as three digits: 2m is meant as 2.00 m.  A fraction, a multiple of
        pi and 0 are exact, but for the rounding of the arithmetic.

    Examples
    --------
    >>> rounding("2m"), rounding("125lm"), rounding("1/3")
    (0.0025, 0.004, 1e-09)
    """
    number = text[: read_number(text)[1]]
    digits = ""
    for character in number.lstrip("+-"):
        if character in "0123456789":
            digits += character
        elif character != ".":
            break
    digits = digits.lstrip("0")
    if not digits or not {"/", "p", "π"}.isdisjoint(number):
        return EXACT
    digits = digits.ljust(FEWEST_DIGITS, "0")
    return 0.5 / float(digits)


def solve(laws: Sequence[AnyLaw], given: Values, steps: dict[str, float] | None = None) -> Solution:
    """Work out everything that follows from what is given, and check what is given twice.

    Parameters
    ----------
    laws : sequence of Law or Relation
        What holds.
    given : dict of str to Known
        Values by the names of symbols [SI].
    steps : dict of str to float, optional
        By how much the marked values of logarithmic symbols differ from exact ones.

    Returns
    -------
    Solution
        The values, and the laws that gave them.

    Raises
    ------
    Disagreement
        If two values of one symbol differ by more than their digits leave open.
    NumberError
        If a value cannot be held by a float.
    ConditionError
        If no value of a symbol fits the others.

    Notes
    -----
    Each law that lacks one symbol gives it, until no law lacks just one.  A law that lacks none,
    and gave none, is checked to the precision typed.

    Examples
    --------
    >>> from radcalc.laws.sizes import CIRCLE, DIAMETER
    >>> found = solve([CIRCLE, DIAMETER], {"diameter": Known(2.0)})
    >>> found.values["radius"].value, round(found.values["area"].value, 6)
    (1.0, 3.141593)
    """
    values, used = dict(given), []
    waiting = list(laws)
    found = True
    while found:
        found = False
        for law in tuple(waiting):
            missing = set(law.names).difference(values)
            if not missing:
                _check(law, values, given, steps or {})
                waiting.remove(law)
            elif len(missing) == 1 and (target := missing.pop()) in law.targets:
                values[target] = _follow(law, target, values)
                used.append((law, target))
                waiting.remove(law)
                found = True
    return Solution(values, used)


def _follow(law: AnyLaw, target: str, values: Values) -> Known:
    """The target by the law, with what the roundings of the others make of it."""
    at = {name: values[name].value for name in law.names if name != target}
    try:
        value = law.solve(target, at.__getitem__)
    except (ValueError, ZeroDivisionError, OverflowError):
        fits = f"no {target.replace('-', ' ')} fits what is given, by the law '{law.name}'"
        raise ConditionError(fits, "other values") from None
    if is_array(value):
        return Known(value, max(values[name].rounding for name in law.names if name != target))
    if isinstance(value, complex) or value != value or value in (float("inf"), float("-inf")):
        raise NumberError(
            f"the {target.replace('-', ' ')} cannot be held by a number", "less extreme values"
        )
    off = 0.0
    for name in law.names:
        if name != target and values[name].rounding and value:
            off += abs(_moved(law, target, name, values) / value - 1)
    return Known(value, off)


def _moved(law: AnyLaw, target: str, name: str, values: Values) -> float:
    """The target with one symbol moved by its rounding."""
    for sign in (1, -1):
        at = {n: values[n].value for n in law.names if n != target}
        at[name] *= 1 + sign * values[name].rounding
        try:
            found = law.solve(target, at.__getitem__)
        except (ConditionError, ValueError, ZeroDivisionError):
            continue  # past a limit: an incidence typed as 90 deg is not meant as 90.05
        if not isinstance(found, complex):
            return float(found)
    return float(values[target].value) if target in values else float("nan")


def _check(law: AnyLaw, values: Values, given: Values, steps: dict[str, float]) -> None:
    """Refuse values that contradict each other by a law."""
    names = [name for name in law.targets if name in given] or list(law.targets)
    name = names[0]
    other = _follow(law, name, values)
    value = values[name].value
    allowed = values[name].rounding + other.rounding + EXACT
    difference = abs(value - other.value)
    if any_true(difference > allowed * abs(value) + steps.get(name, 1e-300)):
        raise Disagreement(law, name, value, other.value)


def reached(laws: Sequence[AnyLaw], known: set[str]) -> set[str]:
    """Find the symbols that follow from those that are known, whatever their values.

    Parameters
    ----------
    laws : sequence of Law or Relation
        What holds.
    known : set of str
        The symbols that are known.

    Returns
    -------
    set of str
        Those and what follows.

    Examples
    --------
    >>> from radcalc.laws.sizes import CIRCLE, DIAMETER
    >>> sorted(reached([CIRCLE, DIAMETER], {"area"}))
    ['area', 'diameter', 'radius']
    """
    known, before = set(known), -1
    while before != len(known):
        before = len(known)
        for law in laws:
            missing = [name for name in law.names if name not in known]
            if len(missing) == 1 and missing[0] in law.targets:
                known.add(missing[0])
    return known


class Derivation(Sequence[Step]):
    """The steps of an answer, worked out when somebody looks at them.

    Each law that was used, in symbols, then in numbers.

    Parameters
    ----------
    solution : Solution
        What follows, and by which laws.
    kind : str
        The kind of the light quantities: e, v or p.
    before, after : sequence of Step
        Steps of what was worked out elsewhere.

    Examples
    --------
    >>> from radcalc.laws.sizes import DIAMETER
    >>> steps = Derivation(solve([DIAMETER], {"radius": Known(2.0)}))
    >>> len(steps), steps[0].numbers
    (1, 'D = 2 (2 m) = 4 m')
    """

    def __init__(
        self,
        solution: Solution,
        kind: str = "",
        before: Sequence[Step] = (),
        after: Sequence[Step] = (),
    ) -> None:
        self._solution, self._kind, self._before, self._after = solution, kind, before, after

    @cached_property
    def _steps(self) -> list[Step]:
        values, kind = self._solution.values, self._kind
        laws = (_step(law, target, values, kind) for law, target in self._solution.used)
        return [*self._before, *laws, *self._after]

    def __len__(self) -> int:
        """How many there are."""
        return len(self._before) + len(self._solution.used) + len(self._after)

    def __getitem__(self, index: Any) -> Any:
        """One of them, or a part."""
        return self._steps[index]


def _step(law: AnyLaw, target: str, values: Values, kind: str) -> Step:
    """A law solved for whichever of its symbols: `(800 lm) = 4 pi Omega0 I, so I = 63.7 cd`."""

    def write(name: str, is_factor: bool) -> str:
        if name == target:
            return letter_of(name)
        value, unit = values[name].value, coherent_unit_of(name, kind)
        text = format_value(value, unit)
        return text if unit in ("1", "rad") or is_array(value) else f"({text})"

    letter, value = letter_of(target), values[target].value
    unit = coherent_unit_of(target, kind)
    found = format_value(value, unit)
    if isinstance(law, Relation) and law.template.startswith(f"{{{target}}} = "):
        others = {name: values[name].value for name in law.names if name != target}
        return law.formula.step(others, found)
    numbers = fill(law.template, write)
    told = f"{numbers} = {found}"
    if not numbers.startswith(f"{letter} = "):
        told = f"{numbers}, so {letter} = {found}"
    return law.formula.told(told)
