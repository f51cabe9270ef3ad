"""Checking an answer: whether it is right, and if not, what most likely went wrong."""

import math
from typing import NamedTuple

from radcalc.answer import Step, Value
from radcalc.calculators.results import in_unit, pick
from radcalc.derivation import format_number
from radcalc.errors import ConditionError, RadcalcError, option, quote
from radcalc.homework.answer import Claim, Tolerance, read_claim, read_tolerance
from radcalc.homework.catalogue import Candidate, Problem, candidates, pairs
from radcalc.homework.question import Question
from radcalc.quantities.light import describe
from radcalc.units.table import Unit, divide, resolve


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


MOST = 5  # diagnoses
COARSEST = 0.05  # how far a number of one digit may be off a mistake's
REMARKS = ("error",)  # results that say how good another is


def check(question: Question, claim: str, tolerance: str = "1%") -> Verdict:
    """Judge an answer `[NAME=]VALUE[UNIT]`, within a tolerance (1%, 0.5lx or 3sf)."""
    said = read_claim(claim)
    target, unit_text, wrong_unit = _target(question, said, tolerance)
    unit = resolve(unit_text)
    right = in_unit(target, unit)
    if not isinstance(right, float):
        raise ConditionError(
            f"{option('check')} takes one answer, and there are several", "one value a call"
        )
    allowed = read_tolerance(tolerance, unit)
    if target.name == "azimuth":  # a turn more or less is the same direction
        turn = 2 * math.pi / divide(unit.top, unit.bottom)
        said = said._replace(value=said.value + turn * round((right - said.value) / turn))
    ratio = said.value / right if right and not wrong_unit else None
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
    steps = verdict.steps
    if steps and found and ratio is not None:
        steps += (_as_answered(verdict, found[0]),)
    return verdict._replace(diagnoses=found, steps=steps)


def _as_answered(verdict: Verdict, found: Diagnosis) -> Step:
    """How the likeliest mistake leads from the right value to the answer."""
    unit = "" if verdict.unit == "1" else f" {verdict.unit}"
    sizes = (verdict.right, verdict.ratio, verdict.claimed)
    right, ratio, claimed = (format_number(size) for size in sizes)
    return Step(
        f"as it was answered: {found.done}",
        "",
        f"{right}{unit} * {ratio} = {claimed}{unit}",
    )


def _target(question: Question, said: Claim, tolerance: str) -> tuple[Value, str, bool]:
    """The result that is meant, the unit to compare in, and whether the unit is of another.

    Without a name it is the first that has that unit; where the number fits only another one,
    nothing can be said before it is named.
    """
    told = option("check", quote(said.text))
    pool = _named(question, said) if said.name else _unnamed(question)
    if not said.unit:
        units = {unit for value in pool[:1] for unit in value.units}
        if len({value.name for value in pool}) > 1 or len(units) != 1:
            missing = "in which unit" if said.name else "which result is meant"
            raise ConditionError(
                f"{option('check', quote(said.text))}: say {missing}", _ways(pool, said)
            )
        return pool[0], pool[0].units[0], False
    unit = resolve(said.unit)
    spelled = [value for value in pool if said.unit in value.units]
    fitting = spelled or [
        value
        for value in pool
        if unit.dimension in value.dimensions or unit.dimension in value.reach
    ]
    if fitting:
        holding = [v for v in fitting if _holds(v, unit, said, tolerance)]
        if holding and fitting[0] not in holding:
            raise ConditionError(
                f"{told} would be right for {holding[0].name}: say which result is meant",
                _ways([fitting[0], *holding], said),
            )
        return fitting[0], said.unit, False
    for value in pool:  # the one that the number fits, if any
        for text in value.units:
            if _holds(value, resolve(text), said, tolerance):
                return value, text, True
    return pool[0], pool[0].units[0], True


def _named(question: Question, said: Claim) -> list[Value]:
    """The results of a name."""
    named = [v for v in question.answer.values if said.name in (v.name, v.also)]
    shown = [v for v in named if not v.is_absent]
    if shown:
        return shown
    for value in named:
        pick([value], value.name)  # which says what it lacks
    names = ", ".join(dict.fromkeys(v.name for v in question.answer.values if not v.is_absent))
    raise ConditionError(f"{option('check')}: there is no result '{quote(said.name)}'", names)


def _unnamed(question: Question) -> list[Value]:
    """The results that a number alone may mean: what follows, then what was given."""
    shown = [v for v in question.answer.values if not v.is_absent and v.name not in REMARKS]
    shown.sort(key=lambda value: value.given is not None)
    if not shown:
        raise ConditionError(f"{option('check')}: there is nothing to check", "less of it given")
    return shown


def _holds(value: Value, unit: Unit, said: Claim, tolerance: str) -> bool:
    right = in_unit(value, unit)
    return isinstance(right, float) and read_tolerance(tolerance, unit).holds(said.value, right)


def _ways(values: list[Value], said: Claim) -> str:
    """How the answer can be said clearly."""
    ways = [
        option("check", f"{value.name}={said.number}{unit.replace(' ', '.').removeprefix('1')}")
        for value in values
        for unit in ([said.unit] if said.unit else value.units)
    ]
    return ", ".join(list(dict.fromkeys(ways))[:4])


def _unit_diagnosis(
    said: Claim, target: Value, unit: str, right: float, allowed: Tolerance
) -> Diagnosis:
    """The answer's unit measures something else than the result."""
    number = "the number would be right" if allowed.holds(said.value, right) else "check both"
    return Diagnosis(
        "wrong-unit",
        f"{describe(resolve(said.unit))} is not {target.label}; {number}",
        f"{target.label} is in {unit}",
    )


def _diagnoses(
    question: Question, target: Value, said: Claim, unit: str, right: float
) -> tuple[Diagnosis, ...]:
    """The mistakes that reproduce the answer to the digits typed, the likeliest first."""
    problem = Problem(question, target)
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
        if off <= min(said.half_unit, COARSEST * abs(said.value)) * (1 + 1e-9):
            close.append((one.rank, off, one))
    close.sort(key=lambda item: item[:2])
    return [one for _, _, one in close]
