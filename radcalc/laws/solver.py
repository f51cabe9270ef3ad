"""The solver: it derives missing values by laws, and checks values against laws.

Values are in coherent SI units, floats or arrays.
"""

from collections.abc import Callable, Sequence, Set
from functools import cached_property, partial
from itertools import product
from typing import Any

from radcalc.answer import Step, coherent_unit_of, fill, format_value, letter_of
from radcalc.errors import ConditionError, NumberError
from radcalc.laws import AnyLaw, At, Law, Relation, Several
from radcalc.maths import any_true, is_array, is_lost, larger, limit, piecewise, smaller
from radcalc.tuples import NamedTuple
from radcalc.units.numbers import EXACT

TO_DIGITS = "to the digits typed"  # in notes on values that agree


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


class Agreement(NamedTuple):
    """Two values of one symbol that agree only to the digits typed.

    Attributes
    ----------
    name : str
        The symbol.
    value : float or ndarray [SI]
        The value that is used: the given one if there is one.
    implied : float or ndarray [SI]
        Its value by a law.

    Examples
    --------
    >>> from radcalc.laws import DIAMETER
    >>> given = {"diameter": Known(2.0, 0.05), "radius": Known(1.01, 0.005)}
    >>> solve([DIAMETER], given).agreed[0].implied
    2.02
    """

    name: str
    value: Any
    implied: Any


class Solution(NamedTuple):
    """All values, and the laws that gave them.

    Attributes
    ----------
    values : dict of str to Known
        Given and derived values, by the names of symbols.
    used : list of (law, str)
        The laws used, in order, and the symbol that each was solved for.
    agreed : sequence of Agreement
        The surplus values that agree only to the digits typed.
    limited : set of str
        The symbols at the limit of a law, which the digits typed reach.

    Examples
    --------
    >>> from radcalc.laws import CIRCLE
    >>> [(law.name, target) for law, target in solve([CIRCLE], {"area": Known(1.0)}).used]
    [('area of a circle', 'radius')]
    """

    values: Values
    used: list[tuple[AnyLaw, str]]
    agreed: Sequence[Agreement] = ()
    limited: Set[str] = frozenset()

    def origins(self, name: str) -> set[str]:
        """Find what a value comes from.

        Parameters
        ----------
        name : str
            The symbol.

        Returns
        -------
        set of str
            The symbol, those of its derivation, and the names of the laws used there.

        Examples
        --------
        >>> from radcalc.laws import CIRCLE
        >>> sorted(solve([CIRCLE], {"area": Known(1.0)}).origins("radius"))
        ['area', 'area of a circle', 'radius']
        """
        found = _behind([(target, law) for law, target in self.used], {name})
        return found | {law.name for law, target in self.used if target in found}


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
    >>> from radcalc.laws import DIAMETER
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
    symbols are all known, and that gave none of them, is checked to the precision typed: its two
    values agree if the given values, each moved within its rounding error, can make them equal.

    If two laws could give a symbol, and their values differ within the digits typed, the choice
    matters: the sides of a room determine its area better than a flux typed with three digits.
    Then all values are derived again, with the laws of the symbols in `last` at the end.

    Examples
    --------
    >>> from radcalc.laws import CIRCLE, DIAMETER
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
    >>> from radcalc.laws import CIRCLE
    >>> len(solve_all([CIRCLE], {"area": Known(1.0)}))
    1
    """
    sheet = _Sheet(dict(given), {}, given, steps or {}, frozenset(), [], [], set())
    refused: Disagreement | None = None
    try:
        solutions = _follow_all(list(laws), sheet)
        if not (last and any(solution.agreed for solution in solutions)):
            return solutions
    except Disagreement as error:
        if not last:
            raise
        refused = error
    try:
        return _follow_all(list(laws), sheet._replace(**_anew(given), last=last))
    except ConditionError as error:
        if refused and not (isinstance(error, Disagreement) and error.name in given):
            raise refused from None  # the first error is more specific
        raise


class _Sheet(NamedTuple):
    """The values so far, the law of each derived value, and the given values.

    `checked` are the surplus laws, each with the compared symbol and its value by the law;
    `agreed` those that hold only to the digits typed.  `limited` are symbols at the limit of a law
    that has no value for the others.
    """

    values: Values
    laws: dict[str, AnyLaw]
    given: Values
    steps: dict[str, float]
    last: Set[str]
    agreed: list[Agreement]
    checked: list[tuple[AnyLaw, str, Any]]
    limited: set[str]

    def off(self, name: str) -> Any:
        """Return the largest error of a value [SI], from the roundings that it depends on."""
        value = self.values[name].value
        low, high = _range(self, {name}, lambda at: at(name))
        return larger(high - value, value - low)

    def rounding(self, name: str) -> Any:
        """Return the rounding error of a symbol's own digits or steps [SI]; 0 without any."""
        known = self.values[name]
        off = 0.0
        if name in self.given:
            off = known.rounding() if callable(known.rounding) else known.rounding
            self.values[name] = known._replace(rounding=off)
        return larger(off, self.steps[name]) if name in self.steps else off


def _anew(given: Values) -> dict[str, Any]:
    """Return the fields of a sheet without derived values."""
    return {"values": dict(given), "laws": {}, "agreed": [], "checked": [], "limited": set()}


def _follow_all(waiting: list[AnyLaw], sheet: _Sheet) -> list[Solution]:
    """Follow laws until none gives a new value; one with several roots splits the solution."""
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
                values[target] = Known(value)
                is_followed = True
    if sheet.agreed:
        _compare_together(sheet)
    used = [(law, name) for name, law in sheet.laws.items()]
    return [Solution(values, used, sheet.agreed, sheet.limited)]


def _follow_each(
    waiting: list[AnyLaw], sheet: _Sheet, target: str, several: Several
) -> list[Solution]:
    """Derive the solutions for each of several values of a symbol, except those that do not fit."""
    solutions: list[Solution] = []
    refused: ConditionError | None = None
    for value in several:
        values = {**sheet.values, target: Known(value)}
        branch = sheet._replace(
            values=values,
            laws=dict(sheet.laws),
            agreed=[*sheet.agreed],
            checked=[*sheet.checked],
            limited={*sheet.limited},
        )
        try:
            solutions += _follow_all(list(waiting), branch)
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


EPSILON = 1e-15  # relative error of arithmetic
ARITHMETIC = (ValueError, ZeroDivisionError, OverflowError)


def _nearest(law: AnyLaw, target: str, sheet: _Sheet, at: dict[str, Any]) -> Any:
    """Return the target at the limit of a relation, or None if the roundings do not reach it.

    A cosine of 1.004 from numbers typed with three digits counts as 1; a typed value that is
    impossible is still refused, except where the limit is a usual value.
    """
    if not isinstance(law, Relation) or any(map(is_array, at.values())):
        return None
    if at.keys() <= sheet.given.keys() and not law.has_limit:
        return None
    off = {name: sheet.off(name) for name in at}
    moving = [name for name in at if off[name]]
    best, least = None, 1.0
    for signs in product((1, -1), repeat=len(moving)):
        move = {name: sign * off[name] for name, sign in zip(moving, signs, strict=True)}

        def moved(part: float, move: dict[str, Any] = move) -> Any:
            places = at | {name: at[name] + part * size for name, size in move.items()}
            return _solved(law, target, places.__getitem__)

        if moved(least) is not None:
            least = limit(lambda part: moved(part) is not None, 0.0, least)
            best = moved(least)
    if best is not None:
        sheet.limited.add(target)
    return best


def _solved(law: AnyLaw, target: str, at: At) -> Any:
    """Return the target of a law; None past a limit."""
    try:
        value = law.solve(target, at)
    except (ConditionError, *ARITHMETIC):
        return None
    return None if isinstance(value, complex) else value


Result = Callable[[At], Any]  # a number or an array from values; None past a limit


def _range(sheet: _Sheet, names: Set[str], result: Result) -> tuple[Any, Any]:
    """Return the lowest and the highest result of values within the digits typed.

    Each value is moved by its rounding error alone, and then all of them to the same side.
    """
    needed = _needed(sheet, names)
    centre = result(lambda name: sheet.values[name].value)
    low = high = centre
    falls, rises = {}, {}
    for name in needed:
        off = sheet.rounding(name)
        if not any_true(off != 0):
            continue
        up, down = (_at_limit(sheet, needed, result, {name: o}, centre) for o in (off, -off))
        low, high = smaller(low, smaller(up, down)), larger(high, larger(up, down))
        rise = piecewise(up >= down, lambda o: o, lambda o: -o, off)
        rises[name] = rise * (larger(up, down) > centre)
        falls[name] = -rise * (smaller(up, down) < centre)
    if len(rises) > 1:
        low = smaller(low, _at_limit(sheet, needed, result, falls, centre))
        high = larger(high, _at_limit(sheet, needed, result, rises, centre))
    return low, high


def _needed(sheet: _Sheet, names: Set[str]) -> list[str]:
    """Return the symbols on which values depend, themselves included, in order of derivation."""
    needed = _behind([*sheet.laws.items()], names)
    return [name for name in sheet.values if name in needed]


def _behind(derived: Sequence[tuple[str, AnyLaw]], names: Set[str]) -> set[str]:
    """Return symbols with those that they depend on; `derived` has each with its law, in order."""
    needed = set(names)
    for target, law in reversed(derived):
        if target in needed:
            needed.update(law.names)
    return needed


def _at_limit(
    sheet: _Sheet, needed: list[str], result: Result, moves: dict[str, Any], centre: Any
) -> Any:
    """Return the result for values moved as far as possible.

    An incidence typed as 90 deg is not meant as 90.05.
    """
    moved = _moved(sheet, needed, result, moves)
    if moved is None and not is_array(centre):
        part = limit(lambda part: _moved(sheet, needed, result, moves, part) is not None, 1.0, 0.0)
        moved = _moved(sheet, needed, result, moves, part)
    return centre if moved is None else moved


def _moved(
    sheet: _Sheet, needed: list[str], result: Result, moves: dict[str, Any], part: float = 1.0
) -> Any:
    """Return the result for values moved by a part of `moves`; None past a limit."""
    at: dict[str, Any] = {}
    for name in needed:
        value = sheet.values[name].value
        if name in sheet.laws:
            derived = _near(_solved(sheet.laws[name], name, at.__getitem__), value)
            if derived is None and name not in sheet.limited:
                return None
            value = value if derived is None else derived
        at[name] = value + part * moves[name] if name in moves else value
    return result(at.__getitem__)


def _near(found: Any, value: Any) -> Any:
    """Return what a law gives; of several values the one next to another value."""
    if isinstance(found, Several):
        return min(found, key=lambda candidate: abs(candidate - value))
    return found


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
    other = _near(other, value)
    sheet.checked.append((law, name, other))
    if any_true(abs(value - other) > EXACT * abs(value) + 1e-300):
        _compare(sheet, law, name, other)
        sheet.agreed.append(Agreement(name, value, other))


def _compare(sheet: _Sheet, law: AnyLaw, name: str, other: Any) -> None:
    """Refuse two values that differ by more than the digits typed allow."""
    value = sheet.values[name].value
    is_limited = _solved(law, name, lambda symbol: sheet.values[symbol].value) is None

    def excess(at: At) -> Any:
        implied = _near(_solved(law, name, at), at(name))
        if implied is None:
            return at(name) - other if is_limited else None
        return at(name) - implied

    low, high = _range(sheet, {*law.names}, excess)
    exact = EXACT * abs(value) + 1e-300
    if name in sheet.given and name in _needed(sheet, {*law.names} - {name}):
        exact = exact + sheet.rounding(name)  # the others follow from it: errors of arithmetic
    for symbol in {*law.names} - {name}:  # such as the cosine of nearly 90 deg
        shifts = 0.0 * exact
        for by in (EPSILON, -EPSILON):
            at = {n: sheet.values[n].value * (1 + by * (n == symbol)) for n in law.names}
            shifted = _implied(law, name, value, at.__getitem__)
            shifts = shifts if shifted is None else larger(shifts, abs(shifted - other))
        exact = exact + shifts
    if any_true((low > exact) | (high < -exact)):
        raise Disagreement(law, name, value, other)


def _compare_together(sheet: _Sheet) -> None:
    """Refuse values of which each two agree to the digits typed, but not all of them.

    The sides of a room leave less room for its area than the two digits of 54 m2 do.
    """
    for law, *_ in sheet.checked:
        for name in sheet.given.keys() & {*law.targets}:
            value, off = sheet.values[name].value, sheet.rounding(name)
            implied = partial(_implied, law, name, value)
            if not any_true(off != 0) or implied(lambda n: sheet.values[n].value) is None:
                continue
            low, high = _range(sheet, {*law.names}, implied)
            least = smaller(off, larger(high - value, value - low))
            sheet.values[name] = sheet.values[name]._replace(rounding=least)
    for checked in sheet.checked:
        _compare(sheet, *checked)


def _implied(law: AnyLaw, name: str, value: Any, at: At) -> Any:
    return _near(_solved(law, name, at), value)


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
    >>> from radcalc.laws import CIRCLE, DIAMETER
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
    >>> from radcalc.laws import DIAMETER
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
        laws = (step_of(law, target, values, kind) for law, target in self.solution.used)
        return [*self._before, *laws, *self._after]

    def __len__(self) -> int:
        """Return the number of steps."""
        return len(self._before) + len(self.solution.used) + len(self._after)

    def __getitem__(self, index: Any) -> Any:
        """Return one step, or a slice of steps."""
        return self._steps[index]


def step_of(law: AnyLaw, target: str, values: Values, kind: str) -> Step:
    """Return a law solved for one of its symbols: `(800 lm) = 4 pi Omega0 I, so I = 63.7 cd`.

    Parameters
    ----------
    law : Law or Relation
        The law.
    target : str
        The symbol that it gives.
    values : dict of str to Known
        The values of all its symbols [SI].
    kind : str
        The kind of the light quantities: e, v or p.

    Returns
    -------
    Step
        Its formula, in symbols and in numbers.

    Examples
    --------
    >>> from radcalc.laws import DIAMETER
    >>> values = {"diameter": Known(2.0), "radius": Known(1.0)}
    >>> step_of(DIAMETER, "radius", values, "").numbers
    '(2 m) = 2 R, so R = 1 m'
    """

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
