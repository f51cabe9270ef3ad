"""Answers and questions of commands that are run without writing anything."""

from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from radcalc.answer import Result
from radcalc.errors import RadcalcError, UsageError
from radcalc.tuples import NamedTuple

if TYPE_CHECKING:
    from radcalc.homework.question import Question


class Heard(RadcalcError):
    """The end of a command whose answer was heard, and is not written."""


class Hearer:
    """A listener that keeps an answer, and ends the command before it writes."""

    def __init__(self) -> None:
        self.settings: dict[str, Any] = {}
        self.results: Sequence[Result] = ()

    def hear(self, results: Sequence[Result]) -> None:
        self.results = results
        raise Heard("")

    def ask(self, question: "Question") -> None:
        """Let a question be answered: the right answer is heard."""


class Examiner(Hearer):
    """A listener that keeps a question, and ends the command before an answer is judged."""

    question: "Question | None" = None

    def ask(self, question: "Question") -> None:
        self.question = question
        raise Heard("")


class Asked(NamedTuple):
    """The question that a call answers, the result NAME[:UNIT] that it asks for, its tolerance."""

    question: "Question"
    wanted: str
    tolerance: str | None


def hear(words: Sequence[str]) -> Sequence[Result]:
    """Return the answers to a call, or none for one that lists or writes; raise its error."""
    from radcalc.cli.command import commands, protect_negatives  # with Click

    listener = Hearer()
    protected = protect_negatives(list(words))
    with suppress(Heard), commands.make_context("radcalc", protected, obj=listener) as context:
        commands.invoke(context)
    return listener.results


def asked(words: Sequence[str]) -> Asked:
    """Return the question that a call answers; raise its error.

    The call is parsed as always, and its check is then one whose answer is never read.
    """
    from radcalc.cli.command import commands, context, protect_negatives  # with Click

    examiner = Examiner()
    top = context(examiner)
    name, command, rest = commands.resolve_command(top, protect_negatives(list(words)))
    assert command is not None
    with command.make_context(name, rest, parent=top) as call:
        params = call.params
        several = params.get("wanted", ())
        if params.get("check") is not None or len(several) > 1:
            problem = "several results" if len(several) > 1 else "an answer in its command"
            raise UsageError(f"a question cannot have {problem}", "one -g, and no --check")
        wanted, tolerance = "".join(several), params.get("tolerance")
        if several:
            params["wanted"] = ()
        params["check"] = f"{wanted.partition(':')[0]}=?"
        with suppress(Heard):
            command.invoke(call)
    if examiner.question is None:
        raise UsageError("a question needs one answer", "a command with one answer")
    return Asked(examiner.question, wanted, tolerance)
