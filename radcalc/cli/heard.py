"""Answers of commands that are run without writing anything."""

from collections.abc import Sequence
from typing import Any

from radcalc.answer import Result
from radcalc.errors import RadcalcError


class Heard(RadcalcError):
    """The end of a command whose answer was heard, and is not written."""


class Listener:
    """A listener that keeps an answer, and ends the command before it writes."""

    def __init__(self) -> None:
        self.results: Sequence[Result] = ()
        self.settings: dict[str, Any] = {}

    def hear(self, results: Sequence[Result]) -> None:
        self.results = results
        raise Heard("")


def hear(words: Sequence[str]) -> Sequence[Result]:
    """Return the answers to a call, or none for one that lists or writes; raise its error."""
    from radcalc.cli.group import commands, protect_negatives  # with Click

    listener = Listener()
    try:
        protected = protect_negatives(list(words))
        with commands.make_context("radcalc", protected, obj=listener) as context:
            commands.invoke(context)
    except Heard:
        pass
    return listener.results
