"""Search for the mistakes that lead to a wrong answer."""

import math
from collections.abc import Sequence
from contextlib import suppress
from typing import NamedTuple, TypeVar

from radcalc.answer import Value
from radcalc.homework import edits, misread, outside, siblings
from radcalc.homework.answer import Claim, Diagnosis
from radcalc.homework.misread import SLIPS
from radcalc.homework.problem import Candidate, Problem
from radcalc.homework.question import Question

MOST = 5  # diagnoses
COARSEST = 0.05  # largest relative difference between an answer and the value of a mistake
LEAST_DIGITS = 3  # of an answer in which two mistakes together are looked for
COMMON = 4  # the last rank that is common enough for a pair with a slip
GUESS = 30.0  # an unrelated number is assumed to be within this factor of the right value
SPREAD = math.log(GUESS)
BY_CHANCE = 0.03  # the share of unrelated numbers that may agree with a mistake


def diagnose(
    question: Question, target: Value, claim: Claim, scale: float
) -> tuple[Diagnosis, ...]:
    """Return the mistakes that reproduce an answer to the digits typed, the likeliest first.

    `scale` is the unit of the answer [SI].  Pairs of mistakes are tried only if no single mistake
    fits: among so many pairs, one fits almost any number of few digits.
    """
    problem = Problem(question, target)
    single = candidates(problem)
    search = _Search(claim, problem.right, scale)
    matches = search.of(single, claim.half_unit)
    if not matches and claim.digits >= LEAST_DIGITS:
        combined = pairs(single, problem.right)
        matches = [pair.together() for pair in search.of(combined, claim.half_unit)]
    if not matches and claim.widest > claim.half_unit:
        matches = _Search(claim, problem.right, scale).of(single, claim.widest)
    # much rarer mistakes only confuse
    near = [match for match in matches if match.rank <= matches[0].rank + 1]
    seen: dict[str, Diagnosis] = {}
    for match in near:
        seen.setdefault(match.mistake, Diagnosis(match.mistake, match.done, match.right))
    return tuple(seen.values())[:MOST]


def candidates(problem: Problem) -> list[Candidate]:
    """Return the wrong values of all single mistakes, the most common mistakes first."""
    wrong_values: list[Candidate] = []
    for family in (edits.find, siblings.find, outside.find, misread.find):
        with suppress(ArithmeticError):  # powers of an extreme input overflow
            wrong_values += family(problem)
    return sorted(
        (candidate for candidate in wrong_values if _is_wrong(candidate.value, problem.right)),
        key=_rank,
    )


def _is_wrong(value: float, right: float) -> bool:
    return math.isfinite(value) and abs(value - right) > 1e-9 * abs(right)


class Pair(NamedTuple):
    """Two common mistakes together: a mistake in a law, and a slip."""

    rank: float
    value: float
    law: Candidate
    slip: Candidate

    def together(self) -> Candidate:
        law, slip = self.law, self.slip
        return Candidate(
            f"{law.mistake} and {slip.mistake}",
            self.rank,
            self.value,
            f"{law.done}; and {slip.done}",
            f"{law.right}; {slip.right}",
        )


def pairs(single: Sequence[Candidate], right: float) -> list[Pair]:
    """Return the wrong values of pairs of common mistakes, the most common first."""
    if not right:
        return []
    laws = [
        candidate
        for candidate in single
        if candidate.rank <= COMMON and candidate.mistake not in SLIPS
    ]
    slips = [candidate for candidate in single if candidate.mistake in SLIPS]
    combined = [
        Pair(law.rank + slip.rank, law.value * slip.value / right, law, slip)
        for law in laws
        for slip in slips
    ]
    return sorted(combined, key=_rank)


def _rank(candidate: Candidate | Pair) -> float:
    return candidate.rank


Wrong = TypeVar("Wrong", Candidate, Pair)


class _Search:
    """The search for an answer among the wrong values.

    An answer with fewer digits is compared with fewer values, those of the most common mistakes,
    so that unrelated numbers seldom agree by chance.
    """

    def __init__(self, claim: Claim, right: float, scale: float) -> None:
        self.claim, self.right, self.scale = claim, right, scale
        self.seen: set[float] = set()  # values compared so far, within GUESS of the right one

    def of(self, options: Sequence[Wrong], half_unit: float) -> list[Wrong]:
        """Return the values that agree with the answer to half a unit of its last digit."""
        value = self.claim.value
        allowed = min(half_unit, COARSEST * abs(value)) * (1 + 1e-9)
        most = BY_CHANCE * SPREAD * abs(value) / allowed if allowed else 0.0
        close = []
        for candidate in options:
            if self.right and 1 / GUESS < abs(candidate.value / self.right) < GUESS:
                if len(self.seen) >= most and candidate.value not in self.seen:
                    continue
                self.seen.add(candidate.value)
            if abs(candidate.value - self.right) <= allowed * self.scale:
                continue  # to so few digits it equals the right value
            off = abs(candidate.value / self.scale - value)
            if off <= allowed:
                # Rounded: if values are equal, the first in order stays first.
                close.append(
                    (candidate.rank, round(off / allowed, 6) if allowed else 0.0, candidate)
                )
        close.sort(key=lambda entry: entry[:2])
        return [candidate for _, _, candidate in close]
