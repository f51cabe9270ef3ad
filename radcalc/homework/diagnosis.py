"""Search for the mistakes that lead to a wrong answer; checks of answers with uncertainties."""

import math
from collections.abc import Sequence
from contextlib import suppress
from itertools import combinations, product
from typing import Any, NamedTuple

from radcalc.answer import Value, format_number, with_unit
from radcalc.calculators.results import in_unit
from radcalc.homework import edits, formulas, misread, outside
from radcalc.homework.chain import Worked
from radcalc.homework.misread import SLIPS
from radcalc.homework.question import (
    RARER,
    Candidate,
    Claim,
    Diagnosis,
    Problem,
    Question,
    Tolerance,
    both,
)
from radcalc.homework.wording import Translatable
from radcalc.units import Unit

MOST = 5  # diagnoses
COARSEST = 0.05  # largest relative difference between an answer and the value of a mistake
LEAST_DIGITS = 3  # of an answer that may have two mistakes
WHOLE = ("other-quantity", "other-lamp")  # not with another mistake
VERY_COMMON = 3.5  # the last rank for a pair of mistakes in laws
COMMON = 4  # the last rank that is common enough for a pair with a slip
GUESS = 30.0  # an unrelated number is assumed to be within this factor of the right value
SPREAD = math.log(GUESS)
# The share of unrelated numbers that may agree with a mistake, and with two.
BY_CHANCE, TWO_BY_CHANCE = 0.03, 0.01
# Rounding on the way (pi as 3.14, c as 3e8, a cosine of three digits): the largest relative error
# of the commonest mistakes, and its factor for each rank after them.
WITH_CONSTANTS = ("photon-energy", "photon-efficacy", "wavelength", "temperature")
ON_THE_WAY, NARROWER = 0.004, 0.7


FAMILIES = (edits.find, formulas.find_siblings, formulas.find_integrals, outside.find, misread.find)


def diagnose(
    question: Question,
    target: Value,
    claim: Claim,
    scale: float,
    readings: Sequence[Candidate] = (),
) -> tuple[Diagnosis, ...]:
    """Return the mistakes that reproduce an answer to the digits typed, the likeliest first.

    `scale` is the unit of the answer [SI]; `readings` are wrong values on its scale.  Pairs of
    mistakes are tried only if no single mistake fits: among so many pairs, one fits almost any
    number of few digits.
    """
    if not claim.value:  # any mistake may lead to 0
        return ()
    problem = Problem(question, target)
    single = sorted([*candidates(problem), *readings], key=_rank)
    search = _Search(claim, problem.right, scale)
    matches = search.of(single, claim.half_unit) + search.on_the_way(single, _band(problem))
    if not matches and claim.digits >= LEAST_DIGITS:
        of_two = _Search(claim, problem.right, scale, TWO_BY_CHANCE)
        two: list[Candidate | Pair] = [*pairs(single, problem.right), *misread_and_more(problem)]
        two.sort(key=_rank)
        matches = of_two.of(two, claim.half_unit)
        matches = matches or of_two.on_the_way(two, _band(problem))
    if not matches and claim.widest > claim.half_unit:
        matches = _Search(claim, problem.right, scale).of(single, claim.widest)
    matches.sort(key=lambda match: (match.cost, match.off))
    # much rarer mistakes only confuse
    near = [match.wrong for match in matches if match.cost <= matches[0].cost + 1]
    seen: dict[str, Diagnosis] = {}
    for wrong in near:
        found = wrong.together() if isinstance(wrong, Pair) else wrong
        step = _step(found)
        if found.mistake not in seen or (step and not seen[found.mistake].yours):
            seen[found.mistake] = Diagnosis(found.mistake, found.done, found.right, step)
    return tuple(seen.values())[:MOST]


def candidates(problem: Problem) -> list[Candidate]:
    """Return the wrong values of all single mistakes, the most common mistakes first."""
    named: list[Candidate] = []
    for family in FAMILIES:
        with suppress(ArithmeticError):  # powers of an extreme input overflow
            named += family(problem)
    return sorted(
        (candidate for candidate in named if _is_wrong(candidate.value, problem.right)),
        key=_rank,
    )


def _step(candidate: "Candidate | Pair") -> str:
    """Return the first wrong step in the learner's numbers, if it is known."""
    value = candidate.value
    return value.numbers() if isinstance(value, Worked) else ""


def _is_wrong(value: float, right: float) -> bool:
    return math.isfinite(value) and abs(value - right) > 1e-9 * abs(right)


def _band(problem: Problem) -> float:
    """Return the largest relative error by rounding on the way; short constants add theirs."""
    has_constants = not problem.chain.symbols.isdisjoint(WITH_CONSTANTS)
    return ON_THE_WAY * (2.0 if has_constants else 1.0)


class Pair(NamedTuple):
    """Two common mistakes together: a mistake in a law, and a slip or another one in a law."""

    rank: float
    value: float
    law: Candidate
    slip: Candidate

    def together(self) -> Candidate:
        return both(self.law, self.slip, self.value)


def pairs(single: Sequence[Candidate], right: float) -> list[Pair]:
    """Return the wrong values of pairs of common mistakes, the most common first.

    The mistakes are independent: each multiplies the result by its own factor.
    """
    if not right:
        return []
    laws = [
        candidate
        for candidate in single
        if candidate.rank <= COMMON and candidate.mistake not in SLIPS
    ]
    slips = [candidate for candidate in single if candidate.mistake in SLIPS]
    common = [law for law in laws if law.rank <= VERY_COMMON and law.mistake not in WHOLE]
    two = [(0.0, *pair) for pair in product(laws, slips)]
    two += [(RARER, *pair) for pair in combinations(common, 2)]
    combined = [
        Pair(more + first.rank + second.rank, first.value * second.value / right, first, second)
        for more, first, second in two
        if not _concern_the_same(first.mistake, second.mistake)
    ]
    return sorted(combined, key=_rank)


OF_PI = (  # mistakes in one constant: nobody makes two of them
    *("pi-forgotten", "two-pi-for-pi", "wrong-sphere", "pi-upside-down", "pi-twice"),
    *("half-azimuth", "whole-for-half", "azimuth-forgotten"),
)


def _concern_the_same(first: str, second: str) -> bool:
    """Return whether two mistakes concern one symbol, or pi."""
    is_of_pi = first in OF_PI and second in OF_PI
    return is_of_pi or first.partition("-")[0] == second.partition("-")[0]


def misread_and_more(problem: Problem) -> list[Candidate]:
    """Return the wrong values of a mistake in a law after a size or an angle was misread."""
    found = []
    for first, other in misread.halves_of(problem):
        for family in (edits.find, formulas.find_siblings, outside.find):
            with suppress(ArithmeticError):
                found += [
                    both(first, law, law.value)
                    for law in family(other)
                    if law.rank <= VERY_COMMON and law.mistake != first.mistake
                ]
    return [one for one in found if _is_wrong(one.value, problem.right)]


def _rank(candidate: Candidate | Pair) -> float:
    return candidate.rank


class Match(NamedTuple):
    """A wrong value that agrees with an answer.

    The `cost` is the rank of the mistake, and more if the value agrees only by rounding on the way;
    `off` is the distance in parts of the largest that is allowed.
    """

    cost: float
    off: float
    wrong: Candidate | Pair


class _Search:
    """The search for an answer among the wrong values.

    An answer with fewer digits is compared with fewer values, those of the most common mistakes,
    so that unrelated numbers seldom agree by chance.
    """

    def __init__(
        self, claim: Claim, right: float, scale: float, by_chance: float = BY_CHANCE
    ) -> None:
        self.claim, self.right, self.scale = claim, right, scale
        self.by_chance = by_chance
        self.size = abs(claim.value)
        self.seen: dict[float, float] = {}  # values near the right one, compared within a width
        self.chance = 0.0  # share of unrelated numbers that agree with them

    def of(self, options: Sequence[Candidate | Pair], half_unit: float) -> list[Match]:
        """Return the values that agree with the answer to half a unit of its last digit."""
        typed = min(half_unit, COARSEST * self.size) * (1 + 1e-9)
        return [
            # Rounded: if values are equal, the first in order stays first.
            Match(wrong.rank, round(off / typed, 6) if typed else 0.0, wrong)
            for wrong in options
            if self._is_compared(wrong.value, typed)
            and (off := self._off(wrong.value, typed)) <= typed
        ]

    def on_the_way(self, options: Sequence[Candidate | Pair], band: float) -> list[Match]:
        """Return the values that agree only if the learner rounded on the way, or cut off digits.

        The more digits an answer has, the less a value that agrees with all of them needs this.
        """
        typed = self.claim.half_unit * (1 + 1e-9)
        if not self.size or typed > COARSEST * self.size:
            return []
        least = 1 + math.log1p(band / 4 * self.size / typed)
        matches = []
        for wrong in options:
            width = typed + band * NARROWER ** (wrong.rank - 1) * self.size
            if self._is_compared(wrong.value, width):
                off = self._off(wrong.value, typed)
                if typed < off <= max(width, self._cut(wrong.value)):
                    extra = 2 * (off - typed) / (band * self.size)
                    matches.append(Match(wrong.rank + least + extra, off / width, wrong))
        return matches

    def _is_compared(self, value: float, width: float) -> bool:
        """Return whether a value may be compared without too many agreements by chance."""
        if not self.right or not 1 / GUESS < abs(value / self.right) < GUESS:
            return True
        seen = self.seen.get(value, 0.0)
        chance = max(0.0, width - seen) / (SPREAD * self.size) if self.size else math.inf
        if self.chance + chance > self.by_chance:
            return False
        self.seen[value] = max(seen, width)
        self.chance += chance
        return True

    def _off(self, value: float, typed: float) -> float:
        """Return how far a value is from the answer; infinite if it equals the right value."""
        if abs(value - self.right) <= typed * self.scale:
            return math.inf  # to so few digits
        return abs(value / self.scale - self.claim.value)

    def _cut(self, value: float) -> float:
        """Return the width for an answer whose digits were cut off, not rounded."""
        is_cut = abs(value / self.scale) > self.size
        return 2 * self.claim.half_unit if is_cut else 0.0


NEAR = 0.05  # of an uncertainty, which has two digits at most
WRONG = "uncertainty"  # a mistake without a more specific name
EXACT = "the right value has no uncertainty"
SQUARES = "the squares of independent uncertainties add up"
SLOPES = "each uncertainty is multiplied by a slope: the relative one of 1/d^2 is twice that of d"


def of_result(question: Question, target: Value, unit: Unit) -> Any:
    """Return a result with its uncertainty (as `uncertainties` has it), or 0 without one."""
    if question.uncertain is None:
        return 0.0
    values = zip(question.answer.values, question.uncertain.values, strict=True)
    return next(in_unit(other, unit) for value, other in values if value is target)


def tolerance(off: float, unit: str) -> Tolerance:
    """Return a tolerance of one standard uncertainty."""
    text = Translatable("within {0}, the standard uncertainty", _in(off, unit))
    return Tolerance(text, "uncertainty", off)


def judge(
    number: Any, claim: Claim, unit: str, allowed: float, per_unit: float
) -> tuple[Diagnosis, ...]:
    """Return the mistake in a claimed uncertainty, or nothing if it is right.

    For an exact result it may be as large as `allowed`, in the `unit`.  `per_unit` is the change
    of a reading over that of the number.
    """
    off, claimed = getattr(number, "std_dev", 0.0) * per_unit, claim.uncertainty
    if not off:
        too_large = claimed > allowed
        return (Diagnosis(WRONG, "an uncertainty is claimed", EXACT),) if too_large else ()
    if not claimed or _is_near(claimed, off):
        return ()
    right = Translatable("it is {0}", _in(off, unit))
    components = number.error_components()
    parts = [abs(size) * per_unit for size in components.values()]
    sizes = [
        component.std_dev / component.nominal_value
        for component in components
        if component.nominal_value
    ]
    without_slopes = abs(number.nominal_value) * math.hypot(*sizes) * per_unit
    mistakes = [
        ("uncertainties-added", sum(parts), "the uncertainties were added up", SQUARES),
        (
            "uncertainty-expanded",
            2 * off,
            "the expanded uncertainty (k = 2) was used",
            "the standard uncertainty (k = 1) is required",
        ),
        (
            "uncertainty-slope",
            without_slopes,
            "the relative uncertainties of the inputs were combined without their slopes",
            SLOPES,
        ),
        *(
            ("uncertainty-left-out", part, "only one input's uncertainty was counted", SQUARES)
            for part in parts
            if len(parts) > 1
        ),
    ]
    for name, size, done, why in mistakes:
        if _is_near(claimed, size):
            return (Diagnosis(name, done, Translatable("{0}: it is {1}", why, _in(off, unit))),)
    return (Diagnosis(WRONG, "the uncertainty is wrong", right),)


def _in(size: float, unit: str) -> str:
    """Format an uncertainty with two digits and its unit: 0.28 fc, 100 lx."""
    return with_unit(format_number(float(f"{size:.2g}")), unit)


def _is_near(claimed: float, size: float) -> bool:
    """Return whether an uncertainty is near another one, or equal to it rounded to one digit."""
    return abs(claimed - size) <= NEAR * size or claimed == float(f"{size:.1g}")
