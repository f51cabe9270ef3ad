"""Checking an answer: whether it is right, and if not, what most likely went wrong."""

from collections.abc import Callable
from typing import Any, NamedTuple

from radcalc.asked import in_unit
from radcalc.conditions import Given
from radcalc.errors import ConditionError, RadcalcError, quote
from radcalc.homework.claims import Claim, Tolerance, read_claim, read_tolerance
from radcalc.homework.mistakes import Candidate, Problem, candidates, pairs
from radcalc.quantities import describe
from radcalc.result import Step, Value
from radcalc.units.table import resolve


class Diagnosis(NamedTuple):
    """A likely mistake: its name, what was done, and what would have been right."""

    mistake: str
    done: str
    right: str


class Verdict(NamedTuple):
    """What is said of an answer; `ratio` is the answer over the right value."""

    is_right: bool
    name: str
    unit: str
    right: float
    claimed: float
    claimed_unit: str
    ratio: float | None
    tolerance: str
    diagnoses: tuple[Diagnosis, ...]
    steps: tuple[Step, ...]


class Question(NamedTuple):
    """What was asked: the right results, what was given, and how to work it out anew.

    `facts` say what else the mistakes depend on: the command, the shape, intervals.
    """

    values: list[Value]
    given: dict[str, Given]
    work_out: Callable[[dict[str, Given]], list[Value]]
    facts: dict[str, Any]
    steps: tuple[Step, ...] = ()


MOST = 5  # diagnoses


def check(question: Question, claim: str, tolerance: str = "1%") -> Verdict:
    """Judge an answer `[NAME=]VALUE[UNIT]`, within a tolerance (1%, 0.5lx or 3sf)."""
    said = read_claim(claim)
    target, unit_text, wrong_unit = _target(question, said)
    unit = resolve(unit_text)
    right = in_unit(target, unit)
    if not isinstance(right, float):
        raise ConditionError("--check takes one answer, and there are several", "one value a call")
    allowed = read_tolerance(tolerance, unit)
    ratio = said.value / right if right else None
    verdict = Verdict(
        False,
        target.name,
        unit_text,
        right,
        said.value,
        said.unit or unit_text,
        ratio,
        allowed.text,
        (),
        question.steps,
    )
    if wrong_unit:
        return verdict._replace(
            diagnoses=(_unit_diagnosis(said, target, unit_text, right, allowed),)
        )
    if allowed.holds(said.value, right):
        return verdict._replace(is_right=True)
    found = _diagnoses(question, target, said, unit_text, right)
    return verdict._replace(diagnoses=found)


def _target(question: Question, said: Claim) -> tuple[Value, str, bool]:
    """The result that is meant, the unit to compare in, and whether the unit is of another."""
    derived = [v for v in question.values if v.given is None and v.units]
    named = [v for v in question.values if said.name and said.name in (v.name, v.also)]
    if said.name and not named:
        names = ", ".join(dict.fromkeys(v.name for v in derived))
        raise ConditionError(f"--check: there is no result '{quote(said.name)}'", names)
    pool = [v for v in named if v.units] or named or derived
    if not said.unit:
        units = {u for v in pool[:1] for u in v.units}
        if len({v.name for v in pool}) > 1 or len(units) != 1:
            several = ", ".join(
                f"--check {v.name}={said.number}{v.units[0].removeprefix('1')}" for v in pool[:3]
            )
            raise ConditionError(f"--check {quote(said.text)}: say which result is meant", several)
        return pool[0], pool[0].units[0], False
    unit = resolve(said.unit)
    for value in pool:
        if unit.dimension in value.dimensions or unit.dimension in value.reach:
            return value, said.unit, False
    if not pool:
        raise ConditionError("--check: there is nothing to check", "less of it given")
    for value in pool:  # the one that the number fits, if any
        for text in value.units:
            right = in_unit(value, resolve(text))
            if isinstance(right, float) and abs(said.value - right) <= 0.01 * abs(right):
                return value, text, True
    return pool[0], pool[0].units[0], True


def _unit_diagnosis(
    said: Claim, target: Value, unit: str, right: float, allowed: Tolerance
) -> Diagnosis:
    """The answer's unit measures something else than the result."""
    number = "and the number with it"
    if allowed.holds(said.value, right):
        number = "the number would be right"
    return Diagnosis(
        "wrong-unit",
        f"{describe(resolve(said.unit))} is not {target.label}; {number}",
        f"{target.label} is in {unit}",
    )


def _diagnoses(
    question: Question, target: Value, said: Claim, unit: str, right: float
) -> tuple[Diagnosis, ...]:
    """The mistakes that reproduce the answer to the digits typed, the likeliest first."""
    problem = Problem(question.given, question.values, question.work_out, question.facts, target)
    scale = problem.right / right if right else 1.0
    found = _matching(candidates(problem), said, scale)
    if not found and said.digits >= 3:
        found = _matching(pairs(problem), said, scale)
    seen: dict[str, Diagnosis] = {}
    for one in found:
        seen.setdefault(one.mistake, Diagnosis(one.mistake, one.done, one.right))
    return tuple(seen.values())[:MOST]


def _matching(options: list[Candidate], said: Claim, scale: float) -> list[Candidate]:
    """Those that agree with the answer within half a unit of its last digit, best first."""
    close = []
    for one in options:
        try:
            off = abs(one.value / scale - said.value)
        except (OverflowError, RadcalcError):
            continue
        if off <= said.half_unit * (1 + 1e-9):
            close.append((one.rank, off, one))
    close.sort(key=lambda item: item[:2])
    return [one for _, _, one in close]
