"""A question as the mistakes see it: what was given, what follows, and how to ask it anew."""

import math
from typing import NamedTuple

from radcalc.answer import Value
from radcalc.homework import chain
from radcalc.homework.chain import FAILURES
from radcalc.homework.question import Question
from radcalc.quantities.light import GRID, Reading
from radcalc.quantities.symbols import SYMBOLS


class Candidate(NamedTuple):
    """A wrong value [SI], and the mistake that leads there.

    `rank` is how common it is and how near to this question: 1 comes first.  `done` says what was
    done, `right` what would have been right.
    """

    mistake: str
    rank: float
    value: float
    done: str
    right: str


class Problem:
    """One result of a question: what was given for it, what else follows, the right value [SI].

    `light` says which light quantity is asked for, if it is one; `chain` leads to the result.
    """

    def __init__(self, question: Question, target: Value) -> None:
        self.given, self.facts, self.target = question.given, question.facts, target
        self.values = {v.name: v for v in question.answer.values if not v.is_absent}
        self.right = float(target.amount)
        facts = GRID.get(target.dimensions[0])
        self.light = Reading(*facts) if facts else None
        self._work_out, self.plan = question.work_out, question.plan
        if question.plan:
            self.chain = chain.of_conversion(question.plan, self.right, self.given)
        else:
            self.chain = chain.of_answer(question.answer, target, self.given)

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

    def amount(self, name: str) -> float | None:
        """A number that was given, or that follows [SI]."""
        if name in self.given:
            value = self.given[name].value
            return float(value) if isinstance(value, (int, float)) else None
        if name in self.chain.values:
            return self.chain.values[name]
        found = self.values.get(name)
        try:
            return float(found.amount) if found else None
        except FAILURES:
            return None

    def radius(self) -> float | None:
        """The radius of the source [m]."""
        diameter = self.amount("diameter")
        return diameter / 2 if diameter else self.amount("radius")

    def half_angle(self) -> float | None:
        """The half angle of the cone that was given, by whichever name [rad]."""
        apex = self.amount("apex-angle") if "apex-angle" in self.given else None
        return apex / 2 if apex else self.amount("half-angle")

    def misread(self, name: str, value: float) -> float | None:
        """The result with one input changed [SI]; by the laws alone where that is refused."""
        found = self.anew({name: value})
        if found is None and name in self.chain.symbols:
            return self.chain.after(name, value)
        return found

    def anew(self, changed: dict[str, object]) -> float | None:
        """The result with inputs changed [SI]; None where that is not possible."""
        given = dict(self.given)
        for name, value in changed.items():
            given[name] = given[name]._replace(value=value, is_exact=True)
        try:
            for found in self._work_out(given).values:
                if found.name == self.target.name and found.dimensions == self.target.dimensions:
                    amount = float(found.amount)
                    return amount if math.isfinite(amount) else None
        except FAILURES:
            pass  # a wrong input may be an impossible one
        return None
