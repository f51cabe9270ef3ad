"""What a mistake is, and the catalogue of them: in `sizes.py` and `kinds.py`.

A mistake is either another input (the full angle as the half angle), with which the answer is
worked out anew, or a factor.  It is offered only where it can have been made: a forgotten cosine
where there is a cosine.  `rank` is how common it is and how much of this law: 1 comes first.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

from radcalc.answer import Value
from radcalc.errors import RadcalcError
from radcalc.given import Given
from radcalc.homework.question import Question
from radcalc.maths import is_array
from radcalc.quantities.light import GRID
from radcalc.quantities.symbols import INTERVAL, POINT


class Candidate(NamedTuple):
    """A wrong value [SI], and the mistake that leads there."""

    mistake: str
    rank: int
    value: float
    done: str
    right: str


class Problem:
    """The question as the mistakes see it."""

    def __init__(self, question: Question, target: Value) -> None:
        self.given = {
            name: one
            for name, one in question.given.items()
            if one.symbol.form not in (INTERVAL, POINT)
        }
        self.facts, self.target = question.facts, target
        self.values = {value.name: value for value in question.answer.values}
        self._work_out = question.work_out
        self.right = float(target.amount)  # [SI]

    def si(self, name: str) -> float | None:
        """What was given or follows [SI]."""
        if name in self.given:
            value = self.given[name].value
            return None if is_array(value) else float(value)
        found = self.values.get(name)
        try:
            return float(found.amount) if found else None
        except (RadcalcError, TypeError):
            return None

    def half_angle(self) -> float | None:
        """The half angle of the cone given [rad], by whichever name."""
        for name, factor in (("half-angle", 1.0), ("apex-angle", 0.5)):
            if name in self.given:
                return float(self.given[name].value) * factor
        return None

    def typed(self, name: str) -> float | None:
        """The number of an angle that was typed in another unit than radians."""
        one = self.given.get(name)
        if one is None or one.unit is None or one.unit.text == "rad":
            return None
        return float(one.number) if isinstance(one.number, (int, float)) else None

    def is_of(self, *commands: str) -> bool:
        """Whether the question is one of these commands'."""
        return self.facts.command in commands

    def named(self, *dimensions: Any) -> list[Given]:
        """The inputs of some dimensions."""
        return [
            g
            for g in self.given.values()
            if g.dimension in dimensions and isinstance(g.value, float)
        ]

    def anew(self, **changed: float) -> Iterator[float]:
        """The target with inputs changed [SI], where that is possible."""
        given = dict(self.given)
        for key, value in changed.items():
            name = key.replace("_", "-")
            given[name] = given[name]._replace(value=value, is_exact=True)
        yield from self.of(given)

    def of(self, given: dict[str, Given]) -> Iterator[float]:
        """The target from other inputs, where that is possible."""
        try:
            for value in self._work_out(given).values:
                if value.name == self.target.name and value.dimensions == self.target.dimensions:
                    number = float(value.amount)
                    if math.isfinite(number):
                        yield number
                    return
        except (RadcalcError, ValueError, ZeroDivisionError, OverflowError, KeyError, TypeError):
            return


Finder = Callable[[Problem], Iterable[float]]
_ALL: list[tuple[str, int, str, str, Finder]] = []


def mistake(name: str, rank: int, done: str, right: str) -> Callable[[Finder], Finder]:
    """Enter a mistake into the catalogue."""

    def enter(find: Finder) -> Finder:
        _ALL.append((name, rank, done, right, find))
        return find

    return enter


def candidates(problem: Problem) -> list[Candidate]:
    """Every wrong value that one mistake leads to."""
    import radcalc.homework.mistakes.kinds
    import radcalc.homework.mistakes.sizes  # noqa: F401  they enter theirs

    found = []
    for name, rank, done, right, find in _ALL:
        for value in find(problem):
            if math.isfinite(value) and abs(value - problem.right) > 1e-9 * abs(problem.right):
                found.append(Candidate(name, rank, value, done, right))
    return found


SINGLY = 4  # the ranks that are common enough to be made together with a slip of unit


def pairs(problem: Problem) -> list[Candidate]:
    """What two common mistakes together lead to: one of the law, one of the unit."""
    one = [c for c in candidates(problem) if c.rank <= SINGLY and c.mistake not in SLIPS]
    other = [c for c in candidates(problem) if c.mistake in SLIPS and c.rank <= SINGLY + 2]
    if not problem.right:
        return []
    return [
        Candidate(
            f"{a.mistake} and {b.mistake}",
            a.rank + b.rank,
            a.value * b.value / problem.right,
            f"{a.done}; and {b.done}",
            f"{a.right}; {b.right}",
        )
        for a in one
        for b in other
    ]


SLIPS = ("power-of-ten", "length-unit", "area-unit")


def light_of(problem: Problem) -> tuple[str, int, int, int, str] | None:
    """Kind, time, area, solid angle, axis of the target, where it is light."""
    return GRID.get(problem.target.dimensions[0])
