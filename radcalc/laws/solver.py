"""The solver: it derives missing values by laws, and checks values against laws.

Values are in coherent SI units, floats or arrays.
"""

from collections.abc import Sequence, Set
from functools import cached_property
from itertools import product
from typing import Any

from radcalc.answer import Step
from radcalc.derivation import coherent_unit_of, fill, format_value, letter_of
from radcalc.errors import ConditionError, NumberError
from radcalc.laws.law import AnyLaw, Law, Relation, Several
from radcalc.maths import any_true, is_array, is_lost, larger, limit
from radcalc.tuples import NamedTuple
from radcalc.units.numbers import EXACT


class Known(NamedTuple):
    """A value, its rounding error, and its text if it was typed.

    Attributes
    ----------
    value : float or ndarray [SI]
        The value.
    rounding : float or ndarray [SI], or callable
        Its largest error due to the digits typed, or a function that computes that.  The solver
        derives those of derived values.
    text : str
        The text typed; empty for a derived value.

    Examples
    --------
    >>> Known(2.0, 0.005, "2m").value
    2.0
    """

    value: Any
    rounding: Any = 0.0
    text: str = ""


Values = dict[str, Known]


class Solution(NamedTuple):
    """All values, and the laws that gave them.

    Attributes
    ----------
    values : dict of str to Known
        Given and derived values, by the names of symbols.
    used : list of (law, str)
        The laws used, in order, and the symbol that each was solved for.

    Examples
    --------
    >>> from radcalc.laws.sizes import CIRCLE
    >>> [(law.name, target) for law, target in solve([CIRCLE], {"area": Known(1.0)}).used]
    [('area of a circle', 'radius')]
    """

    values: Values
    used: list[tuple[AnyLaw, str]]


class Disagreement(ConditionError):
    """The error for two values of one symbol; a caller words it again, with units.

    Parameters
    ----------
    law : Law or Relation
        The violated law.
    name : str
        The symbol.
    given, implied : float or ndarray [SI]
        Its value, and its value by the law.

    Attributes
    ----------
    law, name, given, implied
        As the parameters.

    Examples
    --------
    >>> from radcalc.laws.sizes import DIAMETER
    >>> Disagreement(DIAMETER, "diameter", 3.0, 2.0).message
    "diameter contradicts the others by the law 'diameter'"
    """

    def __init__(self, law: AnyLaw, name: str, given: Any, implied: Any) -> None:
        super().__init__(f"{name} contradicts the others by the law '{law.name}'", "fewer of them")
        self.law, self.name, self.given, self.implied = law, name, given, implied


def solve(
    laws: Sequence[AnyLaw],
    given: Values,
    steps: dict[str, float] | None = None,
    last: Set[str] = frozenset(),
) -> Solution:
    """Derive every value that follows from given values by laws, and check surplus values.

    Parameters
    ----------
    laws : sequence of Law or Relation
        The laws that hold.
    given : dict of str to Known
        Values by the names of symbols [SI].
    steps : dict of str to float, optional
        Largest differences between marked and exact values of logarithmic symbols.
    last : set of str, optional
        Symbols whose laws are used last if the given values agree only to the digits typed.

    Returns
    -------
    Solution
        The values, and the laws that gave them; the first solution if several fit.

    Raises
    ------
    Disagreement
        If two values of one symbol differ by more than the digits typed allow.
    NumberError
        If a float cannot hold a value.
    ConditionError
        If no value of a symbol fits the others.

    Notes
    -----
    Each law with one unknown symbol is solved for it, until no law has exactly one.  A law whose
    symbols are all known, and that gave none of them, is checked to the precision typed: the
    rounding errors of given values propagate to derived values.

    If two laws could give a symbol, and their values differ within the digits typed, the choice
    matters: the sides of a room determine its area better than a flux typed with three digits.
    Then all values are derived again, with the laws of the symbols in `last` at the end.

    Examples
    --------
    >>> from radcalc.laws.sizes import CIRCLE, DIAMETER
    >>> found = solve([CIRCLE, DIAMETER], {"diameter": Known(2.0)})
    >>> found.values["radius"].value, round(found.values["area"].value, 6)
    (1.0, 3.141593)
    """
    return solve_all(laws, given, steps, last)[0]


def solve_all(
    laws: Sequence[AnyLaw],
    given: Values,
    steps: dict[str, float] | None = None,
    last: Set[str] = frozenset(),
) -> list[Solution]:
    """Derive every set of values that fits the given values; `solve` returns the first.

    Parameters
    ----------
    laws, given, steps, last
        As in `solve`.

    Returns
    -------
    list of Solution
        One, or several if a law has `Several` values for one of its symbols.

    Raises
    ------
    Disagreement, NumberError, ConditionError
        As in `solve`; if none of several values fits, the error of the first.

    Examples
    --------
    >>> from radcalc.laws.sizes import CIRCLE
    >>> len(solve_all([CIRCLE], {"area": Known(1.0)}))
    1
    """
    sheet = _Sheet(dict(given), {}, given, steps or {}, frozenset(), [])
    refused: Disagreement | None = None
    try:
        solutions = _follow_all(list(laws), sheet)
        if not (sheet.rounded and last):
            return solutions
    except Disagreement as error:
        if not last:
            raise
        refused = error
    try:
        return _follow_all(list(laws), sheet._replace(values=dict(given), laws={}, last=last))
    except ConditionError as error:
        if refused and not (isinstance(error, Disagreement) and error.name in given):
            raise refused from None  # the first error is more specific
        raise


class _Sheet(NamedTuple):
    """The values so far, the law of each derived value, and the given values.

    `rounded` are the laws that hold only within the digits typed.
    """

    values: Values
    laws: dict[str, AnyLaw]
    given: Values
    steps: dict[str, float]
    last: Set[str]
    rounded: list[AnyLaw]

    def off(self, name: str) -> Any:
        """Return the largest error of a value [SI], from the roundings that it depends on."""
        known = self.values[name]
        off = known.rounding
        if off is UNKNOWN:
            off = _spread(self, self.laws[name], name)
        elif callable(off):
            off = off()
        self.values[name] = known._replace(rounding=off)
        return larger(off, self.steps[name]) if name in self.steps else off


UNKNOWN = None  # a rounding that is not computed yet


def _follow_all(waiting: list[AnyLaw], sheet: _Sheet) -> list[Solution]:
    values, last = sheet.values, sheet.last
    is_followed = True
    while is_followed or last:
        if not is_followed:
            last = frozenset()
        is_followed = False
        for law in tuple(waiting):
            if not last.isdisjoint(law.names):
                continue
            missing = set(law.names).difference(values)
            if not missing:
                _check(law, sheet)
                waiting.remove(law)
            elif len(missing) == 1 and (target := missing.pop()) in law.targets:
                value = _follow(law, target, sheet)
                waiting.remove(law)
                sheet.laws[target] = law
                if isinstance(value, Several):
                    return _follow_each(waiting, sheet, target, value)
                values[target] = Known(value, UNKNOWN)
                is_followed = True
    return [Solution(values, [(law, target) for target, law in sheet.laws.items()])]


def _follow_each(
    waiting: list[AnyLaw], sheet: _Sheet, target: str, several: Several
) -> list[Solution]:
    """Derive the solutions for each of several values of a symbol, except those that do not fit."""
    solutions: list[Solution] = []
    refused: ConditionError | None = None
    for value in several:
        values = {**sheet.values, target: Known(value, UNKNOWN)}
        try:
            solutions += _follow_all(
                list(waiting), sheet._replace(values=values, laws=dict(sheet.laws))
            )
        except ConditionError as error:
            refused = refused or error
    if not solutions and refused:
        raise refused
    return solutions


def _follow(law: AnyLaw, target: str, sheet: _Sheet) -> Any:
    """Return the target by the law; if no value fits, one that does within the roundings."""
    at = {name: sheet.values[name].value for name in law.names if name != target}
    try:
        value = law.solve(target, at.__getitem__)
    except (ConditionError, *ARITHMETIC) as error:
        if not isinstance(error, ConditionError) and any(map(is_array, at.values())):
            raise  # arrays have no such errors
        value = _nearest(law, target, sheet, at)
        if value is None:
            if isinstance(error, ConditionError):
                raise
            fits = f"no {target.replace('-', ' ')} fits the other values, by the law '{law.name}'"
            raise ConditionError(fits, "other values") from None
    if isinstance(value, Several):
        return value
    if isinstance(law, Law) and is_lost(value, *at.values()):
        raise NumberError(
            f"the {target.replace('-', ' ')} is too small for a number", "less extreme values"
        )
    if is_array(value):
        return value
    if isinstance(value, complex) or value != value or value in (float("inf"), float("-inf")):
        raise NumberError(
            f"the {target.replace('-', ' ')} cannot be held by a number", "less extreme values"
        )
    return value


ARITHMETIC = (ValueError, ZeroDivisionError, OverflowError)


def _nearest(law: AnyLaw, target: str, sheet: _Sheet, at: dict[str, Any]) -> Any:
    """Return the target at the limit of a relation, or None if the roundings do not reach it.

    A cosine of 1.004 from numbers typed with three digits counts as 1; a typed value that is
    impossible is still refused.
    """
    follows = isinstance(law, Relation) and not at.keys() <= sheet.given.keys()
    if not follows or any(map(is_array, at.values())):
        return None
    off = {name: sheet.off(name) for name in at}
    moving = [name for name in at if off[name]]
    best, least = None, 1.0
    for signs in product((1, -1), repeat=len(moving)):
        move = {name: sign * off[name] for name, sign in zip(moving, signs, strict=True)}
        if _moved(law, target, at, move, least) is None:
            continue
        least = _limit(law, target, at, move, 0.0, least)
        best = _moved(law, target, at, move, least)
    return best


def _moved(
    law: AnyLaw, target: str, at: dict[str, Any], move: dict[str, Any], part: float = 1.0
) -> Any:
    """Return the target with other symbols moved by a part of `move`; None past a limit."""
    moved = at | {name: at[name] + part * size for name, size in move.items()}
    try:
        value = law.solve(target, moved.__getitem__)
    except (ConditionError, *ARITHMETIC):
        return None
    return None if isinstance(value, complex) else value


def _limit(
    law: AnyLaw,
    target: str,
    at: dict[str, Any],
    move: dict[str, Any],
    outside: float,
    inside: float,
) -> float:
    """Return the part of `move` at which the law begins or ceases to have a target."""
    return limit(lambda part: _moved(law, target, at, move, part) is not None, outside, inside)


def _spread(sheet: _Sheet, law: AnyLaw, target: str) -> Any:
    """Return the largest error of a law's target, from the roundings of its other symbols."""
    at = {name: sheet.values[name].value for name in law.names if name != target}
    value = sheet.values[target].value
    total = 0.0 * value
    for name in at:
        off = sheet.off(name)
        if any_true(off != 0):
            moves = ({name: off}, {name: -off})
            moved = [_moved_to_limit(law, target, at, move, value) for move in moves]
            total = total + larger(*(abs(other - value) for other in moved))
    return total


def _moved_to_limit(
    law: AnyLaw, target: str, at: dict[str, Any], move: dict[str, Any], value: Any
) -> Any:
    """Return the target with one symbol moved as far as possible; the nearest of several values.

    An incidence typed as 90 deg is not meant as 90.05.
    """
    moved = _moved(law, target, at, move)
    if moved is None and not is_array(value):
        most = _limit(law, target, at, move, 1.0, 0.0)
        moved = _moved(law, target, at, move, most)
    if isinstance(moved, Several):
        return min(moved, key=lambda candidate: abs(candidate - value))
    return value if moved is None else moved


def _check(law: AnyLaw, sheet: _Sheet) -> None:
    """Refuse values that contradict each other by a law."""
    names = [name for name in law.targets if name in sheet.given] or list(law.targets)
    name = names[0]
    try:
        other = _follow(law, name, sheet)
    except ConditionError:
        if isinstance(law, Relation):
            if _holds(law, sheet):
                return
            raise
        name = law.result  # if no light arrives, the law can be solved only for its result
        other = _follow(law, name, sheet)
    value = sheet.values[name].value
    if isinstance(other, Several):
        other = min(other, key=lambda candidate: abs(candidate - value))
    difference = abs(value - other)
    if not any_true(difference > EXACT * abs(value) + 1e-300):
        return
    for symbol in law.names:
        sheet.off(symbol)  # from the present values, before `other` replaces one of them
    aside = sheet._replace(values={**sheet.values, name: Known(other)})
    allowed = sheet.off(name) + _spread(aside, law, name) + EXACT * abs(value)
    if any_true(difference > allowed):
        raise Disagreement(law, name, value, other)
    sheet.rounded.append(law)


def _holds(law: Relation, sheet: _Sheet) -> bool:
    """Return whether values fit a relation that has no single solution: any lobe, on its axis."""
    result = law.names[0]
    if result not in law.targets:
        return False
    value, other = sheet.values[result].value, _follow(law, result, sheet)
    return not isinstance(other, Several) and not any_true(abs(value - other) > EXACT * abs(value))


def reached(laws: Sequence[AnyLaw], known: set[str]) -> set[str]:
    """Find the symbols that follow from known ones, whatever their values.

    Parameters
    ----------
    laws : sequence of Law or Relation
        The laws that hold.
    known : set of str
        The known symbols.

    Returns
    -------
    set of str
        Those, and all that follow.

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
    """The steps of an answer, computed on access: each law used, in symbols and in numbers.

    Parameters
    ----------
    solution : Solution
        The values, and the laws that gave them.
    kind : str
        The kind of the light quantities: e, v or p.
    before, after : sequence of Step
        Steps that were computed elsewhere.

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
        self.solution, self.kind = solution, kind
        self._before, self._after = before, after

    @cached_property
    def _steps(self) -> list[Step]:
        values, kind = self.solution.values, self.kind
        laws = (_step(law, target, values, kind) for law, target in self.solution.used)
        return [*self._before, *laws, *self._after]

    def __len__(self) -> int:
        """Return the number of steps."""
        return len(self._before) + len(self.solution.used) + len(self._after)

    def __getitem__(self, index: Any) -> Any:
        """Return one step, or a slice of steps."""
        return self._steps[index]


def _step(law: AnyLaw, target: str, values: Values, kind: str) -> Step:
    """Return a law solved for one of its symbols: `(800 lm) = 4 pi Omega0 I, so I = 63.7 cd`."""

    def write(name: str, is_factor: bool) -> str:
        if name == target:
            return letter_of(name)
        value, unit = values[name].value, coherent_unit_of(name, kind)
        text = format_value(value, unit)
        return text if unit in ("1", "rad") or is_array(value) else f"({text})"

    letter, value = letter_of(target), values[target].value
    unit = coherent_unit_of(target, kind)
    result = format_value(value, unit)
    if isinstance(law, Relation) and law.template.startswith(f"{{{target}}} = "):
        others = {name: values[name].value for name in law.names if name != target}
        return law.formula.step(others, result, kind)
    numbers = fill(law.template, write)
    sentence = f"{numbers} = {result}"
    if not numbers.startswith(f"{letter} = "):
        sentence = f"{numbers}, so {letter} = {result}"
    return law.formula.with_numbers(sentence)
