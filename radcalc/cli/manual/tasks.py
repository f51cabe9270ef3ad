"""Generated part of radcalc-examples(7): the tasks."""

from collections.abc import Iterator
from itertools import groupby

from radcalc.cli.help_format import narrowed
from radcalc.cli.manual.mdoc import ROOM, argument, literal, sentences, text
from radcalc.sentences import tasks as source
from radcalc.sentences.tasks import CALL
from radcalc.terminal import HANGING, fold


def tasks(_: str) -> Iterator[str]:
    """Yield each task with its calls and how to read them, by trade."""
    for trade, group in groupby(source.tasks(), lambda task: task.trade):
        yield f".Sh {text(trade.upper())}"
        for task in group:
            yield f".Ss {argument(task.title)}"
            yield from sentences(task.question)
            yield from literal(_lines(task))
            yield ".Pp"
            yield from sentences(task.reading)


def _lines(task: source.Task) -> Iterator[str]:
    for call in task.calls:
        yield from narrowed(f"{CALL}{call.command}", ROOM)
        for printed in call.output:
            yield from fold(printed, ROOM, HANGING)
