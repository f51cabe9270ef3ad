"""Checks of a learner's answer: --check and --tolerance."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from radcalc import terminal
from radcalc.answer import Row, ShownInput
from radcalc.errors import Try, UsageError, correct, leave_out

if TYPE_CHECKING:
    from radcalc.cli.output import Output
    from radcalc.homework.question import Question


def refuse_idle(check: str | None, tolerance: str | None) -> None:
    """Refuse --tolerance without --check."""
    if tolerance is not None and check is None:
        raise UsageError("--tolerance does not apply without --check", leave_out("tolerance"))


def several(
    varied: Sequence[ShownInput] = (), operands: Sequence[tuple[str, str]] = ()
) -> UsageError:
    """Return the error for --check with several answers, with the first values as a proposal.

    `varied` are the inputs with several values, `operands` the lists typed as words, each with
    its first value.
    """
    problem = "--check takes one answer, not several"
    first = first_of(varied)
    if first.inputs:
        return UsageError(problem, first)
    lists = [correct(typed, value) for typed, value in operands if typed != value]
    return UsageError(problem, lists or leave_out("check"))


def first_of(varied: Sequence[ShownInput]) -> Try:
    """Propose the first value of each input that has several."""
    return Try(tuple([(given.name, given.text) for given in varied if given.name]))


def refuse_stream(check: str | None) -> None:
    """Refuse --check with a stream."""
    if check is not None:
        raise UsageError("--check cannot be used with a stream", leave_out("check"))


def judge(
    question: "Question",
    claim: str,
    tolerance: str | None,
    output: "Output",
    inputs: Sequence[ShownInput] = (),
) -> int:
    """Write whether an answer is right, or its likely mistake; return the exit status."""
    output.ask(question)
    from radcalc.calculators.results import measured_in, of_kind, said_of
    from radcalc.homework import check
    from radcalc.render.formats import Judgement

    output.refuse_auto("--check compares it with the answer given", leave_out("auto"))
    verdict = check(question, claim, tolerance)
    answer = question.answer
    right = next(value for value in answer.values if value.name == verdict.result)
    name = right.also if question.plan else verdict.name
    label = of_kind(right, measured_in(verdict.unit, right.name))
    is_given, off = right.given is not None, verdict.uncertainty
    row = Row(*label, verdict.value, verdict.unit, "", name, is_given, off)
    output.judge(Judgement(verdict, row, inputs, *said_of(answer, [row])))
    return terminal.ANSWERED if verdict.right else terminal.WRONG
