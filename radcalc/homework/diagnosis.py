"""Which mistakes lead to an answer."""

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from radcalc.homework.answer import Claim
from radcalc.homework.catalogue import Candidate, Mistake, Problem
from radcalc.homework.mistakes import MISTAKES
from radcalc.homework.mistakes.slips import SLIPS

MOST = 5  # diagnoses
COARSEST = 0.05  # how far a number of one digit may be off a mistake's
LEAST_DIGITS = 3  # of an answer that two mistakes together are told from
COMMON = 4  # the last rank that is common enough to be made together with a slip


class Diagnosis(NamedTuple):
    """A likely mistake: its name, what was done, and what would have been right."""

    mistake: str
    done: str
    right: str


def diagnose(problem: Problem, said: Claim, right: float) -> tuple[Diagnosis, ...]:
    """The mistakes that reproduce an answer to the digits typed, the likeliest first.

    `right` is the right value in the answer's unit.  Two mistakes at once are looked for only
    where no single one fits: with so many pairs a number of few digits would always fit some.
    """
    scale = problem.right / right if right else 1.0
    single = candidates(problem)
    found = _matching(single, said, scale)
    if not found and said.digits >= LEAST_DIGITS:
        found = _matching(pairs(single, problem.right), said, scale)
    seen = dict.fromkeys(Diagnosis(one.mistake, one.done, one.right) for one in found)
    return tuple(seen)[:MOST]


def candidates(problem: Problem) -> list[Candidate]:
    """Every wrong value that one mistake leads to."""
    return [
        Candidate(one.name, one.rank, value, one.done, one.right)
        for one in MISTAKES
        for value in _values(one, problem)
        if math.isfinite(value) and abs(value - problem.right) > 1e-9 * abs(problem.right)
    ]


def _values(one: Mistake, problem: Problem) -> Iterator[float]:
    try:
        yield from one.find(problem)
    except ArithmeticError:
        return  # powers of an extreme input leave what a float holds


def pairs(single: Sequence[Candidate], right: float) -> list[Candidate]:
    """What two common mistakes together lead to: one of the law, and a slip."""
    return [
        Candidate(
            f"{law.mistake} and {slip.mistake}",
            law.rank + slip.rank,
            law.value * slip.value / right,
            f"{law.done}; and {slip.done}",
            f"{law.right}; {slip.right}",
        )
        for law in single
        if right and law.rank <= COMMON and law.mistake not in SLIPS
        for slip in single
        if slip.mistake in SLIPS
    ]


def _matching(options: Sequence[Candidate], said: Claim, scale: float) -> list[Candidate]:
    """Those that agree with the answer within half a unit of its last digit, best first."""
    allowed = min(said.half_unit, COARSEST * abs(said.value)) * (1 + 1e-9)
    near = [(one, abs(one.value / scale - said.value)) for one in options]
    close = [(one, off) for one, off in near if off <= allowed]
    # Rounded, so that of equal values the first in the catalogue comes first.
    close.sort(key=lambda pair: (pair[0].rank, round(pair[1] / allowed, 6) if allowed else 0.0))
    return [one for one, _ in close]
