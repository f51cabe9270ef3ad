"""`radcalc examples [WORD ...]`: tasks with their commands, answers and explanations."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from typing import Any

from radcalc import terminal
from radcalc.answer import texts_of
from radcalc.calculators.pages import page_of
from radcalc.cli.command import define
from radcalc.cli.help_format import narrowed
from radcalc.cli.output import Output, refuse_number_options, width_of_terminal
from radcalc.render.formats import Records
from radcalc.sentences.tasks import Task, search
from radcalc.terminal import BOLD, PLAIN, RESET, TABLE


@define("examples", page_of("examples"))
def command(words: tuple[str, ...], output: Output) -> None:
    """List tasks with the commands that answer them, or show those that mention all words.

    \b
    Examples:
      radcalc examples                 all tasks, each with its first command
      radcalc examples museum          the tasks of a trade, complete
      radcalc examples ppfd spectrum   the tasks that mention both words

    A complete task has a question, commands with their answers, and an explanation.
    """
    refuse_number_options(output, "examples")
    text = " ".join(words)
    found = search(text)
    is_complete = bool(text.strip())
    if output.format == TABLE or (output.format == PLAIN and is_complete):
        width = width_of_terminal() if output.format == TABLE else 0
        lines = _complete(found, width) if is_complete else _overview(found, width)
        terminal.write("".join(_line(line, output.style.color) for line in lines))
    else:
        rows = [_record(task, is_complete) for task in found]
        output.records(Records(rows, (), (), inputs=texts_of({"search": text})))


def _line(line: str, is_colored: bool) -> str:
    """Return a line of a text, in which a title is not indented."""
    is_title = is_colored and line[:1].strip()
    return f"{BOLD}{line}{RESET}\n" if is_title else f"{line}\n"


def _overview(found: Iterable[Task], width: int) -> Iterator[str]:
    """Yield the tasks of each trade, with their first commands."""
    for trade, group in groupby(found, lambda task: task.trade):
        yield trade
        for task in group:
            yield f"  {task.title}"
            yield from narrowed(f"    {task.command}", width)


def _complete(found: Sequence[Task], width: int) -> Iterator[str]:
    """Yield the lines of whole tasks; in plain text, without a width, no line of a call is folded.

    Only titles are not indented.
    """
    for place, task in enumerate(found):
        if place:
            yield ""
        yield from task.lines(width, narrowed) if width else task.lines()


def _record(task: Task, is_complete: bool) -> dict[str, Any]:
    row: dict[str, Any] = {"trade": task.trade, "task": task.title}
    if not is_complete:
        return row | {"command": task.command}
    printed = "\n".join(line for call in task.calls for line in call.output)
    commands = [call.command for call in task.calls]
    return row | {
        "question": task.question,
        "commands": commands,
        "output": printed,
        "reading": task.reading,
    }
