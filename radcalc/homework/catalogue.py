"""What a mistake is, and a question as the mistakes see it.

A mistake is either another input (the full angle as the half angle), with which the answer is
worked out anew, or a factor.  It is offered only where it can have been made: a forgotten cosine
where there is a cosine.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple

from radcalc.answer import Value
from radcalc.errors import RadcalcError
from radcalc.given import Given
from radcalc.homework.question import Question
from radcalc.quantities.light import GRID, Reading
from radcalc.quantities.symbols import SYMBOLS
from radcalc.units.table import Dimension


class Problem:
    """One result of a question: what was given for it, what else follows, the right value [SI].

    `light` says which light quantity is asked for, if it is one.
    """

    def __init__(self, question: Question, target: Value) -> None:
        self.given, self.facts, self.target = question.given, question.facts, target
        values = question.answer.values
        self.values = {value.name: value for value in values if not value.is_absent}
        self.right = float(target.amount)
        facts = GRID.get(target.dimensions[0])
        self.light = Reading(*facts) if facts else None
        self._work_out = question.work_out

    def is_of(self, *commands: str) -> bool:
        """Whether the question is one of these commands'."""
        return self.facts.command in commands

    def asks(self, *names: str) -> bool:
        """Whether the result is one of these; a generic name serves every kind of light."""
        symbol = SYMBOLS.get(self.target.name)
        return self.target.name in names or (symbol is not None and symbol.generic in names)

    def has(self, *names: str) -> bool:
        """Whether one of these was given; a generic name serves every kind of light."""
        return any(one.name in names or one.symbol.generic in names for one in self.given.values())

    def given_of(self, dimension: Dimension) -> list[Given]:
        """The numbers given of a dimension."""
        alike = (one for one in self.given.values() if one.dimension == dimension)
        return [one for one in alike if isinstance(one.value, float)]

    def input(self, name: str) -> float | None:
        """A number that was given [SI]."""
        value = self.given[name].value if name in self.given else None
        return float(value) if isinstance(value, (int, float)) else None

    def amount(self, name: str) -> float | None:
        """A number that was given, or that follows [SI]."""
        found = self.values.get(name)
        if name in self.given or found is None:
            return self.input(name)
        try:
            return float(found.amount)
        except (RadcalcError, TypeError):
            return None

    def number(self, name: str) -> float | None:
        """A number as it was typed, in its own unit."""
        typed = self.given[name].number if name in self.given else None
        return float(typed) if isinstance(typed, (int, float)) else None

    def degrees(self, name: str) -> float | None:
        """The number of an angle that was not typed in radians."""
        if name not in self.given or self.given[name].unit_text in ("1", "rad"):
            return None
        return self.number(name)

    def half_angle(self) -> float | None:
        """The half angle of the cone that was given, by whichever name [rad]."""
        return _either(self.input("half-angle"), self.input("apex-angle"))

    def half_degrees(self) -> float | None:
        """The number of that half angle, if it was not typed in radians."""
        return _either(self.degrees("half-angle"), self.degrees("apex-angle"))

    def radius(self) -> float | None:
        """The radius of the source [m]."""
        return _either(self.amount("radius"), self.amount("diameter"))

    def aside(self) -> tuple[float, float] | None:
        """The height above a flat source and the straight line to it, off its axis [m]."""
        height, offset = self.amount("height"), self.amount("offset")
        if height and offset and self.facts.shape in ("disc", "rectangle"):
            return height, math.hypot(height, offset)
        return None

    def far_over_near(self) -> float | None:
        """What the inverse square law gives of the irradiance, as a ratio."""
        far, near = self.amount("far-field-irradiance"), self.amount("irradiance")
        return far / near if far and near else None

    def both(self, *factors: float) -> Iterator[float]:
        """The right value times a factor, and over it."""
        for factor in factors:
            yield self.right * factor
            yield self.right / factor

    def anew(self, changed: dict[str, float]) -> Iterator[float]:
        """The result with inputs changed [SI], where that is possible."""
        given = dict(self.given)
        for name, value in changed.items():
            given[name] = given[name]._replace(value=value, is_exact=True)
        try:
            for found in self._work_out(given).values:
                if found.name == self.target.name and found.dimensions == self.target.dimensions:
                    yield float(found.amount)
                    return
        except (RadcalcError, ArithmeticError, ValueError, KeyError, TypeError):
            return  # a wrong input may be an impossible one

    def scaled(self, names: Iterable[str], *factors: float) -> Iterator[float]:
        """The result with one of the inputs times a factor, or over it."""
        for name in names:
            if value := self.input(name):
                for factor in factors:
                    yield from self.anew({name: value * factor})
                    yield from self.anew({name: value / factor})


def _either(half: float | None, whole: float | None) -> float | None:
    """What was given as such, or as its double."""
    return whole / 2 if half is None and whole is not None else half


Finder = Callable[[Problem], Iterable[float]]


class Mistake(NamedTuple):
    """A mistake: what was done, what would have been right, and the wrong values [SI] it gives.

    `rank` is how common it is and how much of this law: 1 comes first.
    """

    name: str
    rank: int
    done: str
    right: str
    find: Finder


class Candidate(NamedTuple):
    """A wrong value [SI], and the mistake that leads there."""

    mistake: str
    rank: int
    value: float
    done: str
    right: str


def mistake(name: str, rank: int, done: str, right: str) -> Callable[[Finder], Mistake]:
    """Make a mistake of a function that yields wrong values [SI]."""
    return lambda find: Mistake(name, rank, done, right, find)


def mistake_factor(name: str, rank: int, done: str, right: str) -> Callable[[Finder], Mistake]:
    """Make a mistake of a function that yields factors, by which one may be off either way."""
    return lambda find: Mistake(name, rank, done, right, lambda p: p.both(*find(p)))
