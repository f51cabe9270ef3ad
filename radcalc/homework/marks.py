"""Marks: the verdicts on a question's answers, and the rule that gives points for them."""

from collections.abc import Mapping
from typing import NamedTuple

from radcalc.answer import Row, Value
from radcalc.calculators.results import pick, rows
from radcalc.errors import (
    ConditionError,
    NumberError,
    RadcalcError,
    UsageError,
    add,
    listed,
    option,
    quote,
)
from radcalc.homework.answer import Claim, is_rounded, read_claim
from radcalc.homework.question import Question, of_conversion
from radcalc.homework.verdict import ROUNDED, Verdict, check
from radcalc.units.numbers import read_number
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve
from radcalc.units.unit import NUMBER, unit_behind

RIGHT, UNIT, DIGITS, MISTAKE = "right", "unit missing", "too few digits", "mistake"
WRONG, UNREADABLE, EMPTY = "wrong", "not readable", "no answer"
# The names in --points, and the parts of a question's points; nothing else has points.
NAMES = {"unit": UNIT, "digits": DIGITS, "mistake": MISTAKE}
PARTS: Mapping[str, float] = {RIGHT: 1.0, UNIT: 0.5, DIGITS: 0.75, MISTAKE: 0.5}
WRONG_UNIT = "wrong-unit"
MOST = 3  # results that a hint proposes


class Key(NamedTuple):
    """A question with the result that it asks for, as a row with its right value."""

    question: Question
    target: Value
    right: Row
    tolerance: str | None

    @property
    def text(self) -> str:
        """The right value with its unit."""
        return f"{self.right.value:.6g}{unit_behind(self.right.unit)}"


class Mark(NamedTuple):
    """The verdict on an answer in a word, the name of the likely mistake, and what was done."""

    verdict: str
    mistake: str = ""
    likely: str = ""


def of_value(text: str) -> Question:
    """Return the question that a value answers: its conversion to its own unit."""
    amount = read_amount(text)
    unit = amount.typed[1] or resolve("1")
    return of_conversion(float(amount.exact), unit, unit, (), amount=amount)


def key(question: Question, wanted: str, expected: str, tolerance: str | None) -> Key:
    """Return the key of a question for a result NAME[:UNIT].

    Without the name, the question has one result, or the one that the expected value is for.
    """
    present = [v for v in question.answer.values if v.given is None and not v.is_absent]
    names = {value.name for value in present}
    if not wanted and len(names) > 1 and expected:
        verdict = check(question, expected, tolerance)
        wanted = f"{verdict.name}:{verdict.unit}"
    if not wanted and len(names) != 1:
        proposed = [add("get", f"{row.name}:{row.unit}") for row in rows(present)[:MOST]]
        raise UsageError("a question has one answer, but its command has several", proposed)
    row = pick(question.answer.values, wanted or present[0].name)
    if not isinstance(row.value, float):
        raise UsageError("a question has one answer, not several", "a result that is a number")
    target = next(v for v in question.answer.values if row.name in (v.name, v.also))
    found = Key(question, target, row, tolerance)
    own = f"{row.name}={row.value!r} {row.unit}"
    check(question, own, tolerance)  # refuses a tolerance that cannot be read
    return found


def refuse_unlike(asked: Key, expected: str) -> None:
    """Refuse an expected value that contradicts the right one."""
    verdict, _ = _judged(asked, expected)
    if not verdict.right:
        problem = f"{quote(expected)} contradicts the command, which gives {asked.text}"
        raise ConditionError(problem, f"{asked.text}, or another command")


def mark(asked: Key, answer: str) -> Mark:
    """Return the mark of an answer; one that cannot be read has the reason, with its mentions."""
    if not answer.strip():
        return Mark(EMPTY)
    try:
        verdict, is_bare = _judged(asked, answer)
        claim = read_claim(answer)
    except RadcalcError as error:
        return Mark(UNREADABLE, likely=error.message)
    if verdict.result != asked.target.name:
        return Mark(WRONG, likely=f"this is the {verdict.result}")
    first = verdict.diagnoses[0] if verdict.diagnoses else None
    mistake, done = (first.mistake, first.done) if first else ("", "")
    if mistake == ROUNDED and (not verdict.right or is_rounded(claim, verdict.value)):
        kind = UNIT if is_bare else DIGITS
        return Mark(kind, likely=f"rounded {done}: {first.right}" if first else "")
    if verdict.right:
        return Mark(UNIT if is_bare else RIGHT)
    is_named = bool(mistake) and not is_bare
    if mistake == WRONG_UNIT:
        is_named = _has_right_number(asked, claim)
    return Mark(MISTAKE if is_named else WRONG, mistake, done)


def _judged(asked: Key, answer: str) -> tuple[Verdict, bool]:
    """Return the verdict on an answer to the result asked for, and whether its unit is missing."""
    claim, unit = read_claim(answer), asked.right.unit
    text = f"{claim.name or asked.right.name}={answer.rpartition('=')[2]}"
    if claim.unit:
        return check(asked.question, text, asked.tolerance), False
    if claim.number not in answer:  # arithmetic
        text = f"{claim.name or asked.right.name}={claim.number}"
    if asked.target.dimensions[0] == NUMBER:
        verdict = check(asked.question, f"{text} 1", asked.tolerance)
        if verdict.right or unit == "1":
            return verdict, False
    return check(asked.question, f"{text} {unit}", asked.tolerance), True


def _has_right_number(asked: Key, claim: Claim) -> bool:
    text = f"{asked.right.name}={claim.number} {asked.right.unit}"
    return check(asked.question, text, asked.tolerance).right


def read_parts(text: str) -> dict[str, float]:
    """Read the parts of a question's points: unit=0.5,digits=0.75,mistake=0.5."""
    parts = dict(PARTS)
    for entry in text.split(","):
        name, _, number = map(str.strip, entry.partition("="))
        if name not in NAMES:
            problem = f"{option('points')}: unknown verdict '{quote(name)}'"
            raise ConditionError(problem, f"some of {listed([f'{n}=0.5' for n in NAMES], ',')}")
        try:
            part, end = read_number(number)
        except NumberError:
            part, end = -1.0, 0
        if end != len(number) or not 0 <= part <= 1:
            problem = f"{option('points')}: '{quote(entry.strip())}' is out of range"
            raise ConditionError(problem, f"{name}=0.5: a part of a question's points, from 0 to 1")
        parts[NAMES[name]] = part
    return parts
