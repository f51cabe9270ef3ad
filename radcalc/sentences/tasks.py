"""The tasks of `radcalc examples` and of radcalc-examples(7), from `examples.md`."""

from functools import cache
from pathlib import Path

from radcalc.errors import UsageError, corrections, nearest, quote
from radcalc.quantities.search import comparable, matching
from radcalc.terminal import HANGING, fold
from radcalc.tuples import NamedTuple

FILE = Path(__file__).parent / "examples.md"
TRADE, TITLE, CALL = "# ", "## ", "$ "
BEGIN, END = "```console", "```"
WIDTH = 80  # of paragraphs in plain text

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from typing import TypeAlias

    Narrowed: TypeAlias = Callable[[str, int], Iterable[str]]


class Call(NamedTuple):
    """A command, as it is typed, and the lines that it prints."""

    command: str
    output: tuple[str, ...]


class Task(NamedTuple):
    """A question with its calls, and how to read the answer."""

    trade: str
    title: str
    question: str
    calls: tuple[Call, ...]
    reading: str

    @property
    def command(self) -> str:
        """The first call of radcalc."""
        return next(call.command for call in self.calls if "radcalc " in call.command)

    @property
    def words(self) -> str:
        """The text for searches: everything except the output."""
        commands = [call.command for call in self.calls]
        return " ".join([self.trade, self.title, self.question, *commands, self.reading])

    def __str__(self) -> str:
        """Return the whole task as plain text."""
        return "\n".join(self.lines())

    def lines(self, width: int = 0, narrowed: "Narrowed | None" = None) -> "Iterator[str]":
        """Yield the title, and indented the question, the calls with their output, the reading.

        With a width, `narrowed` folds the calls; without one, only paragraphs are folded.
        """
        yield f"{self.trade}: {self.title}"
        yield from fold(f"  {self.question}", width or WIDTH)
        yield ""
        for call in self.calls:
            typed = f"    {CALL}{call.command}"
            yield from narrowed(typed, width) if narrowed else [typed]
            for printed in call.output:
                line = f"    {printed}".rstrip()
                yield from fold(line, width, HANGING) if width else [line]
        yield ""
        yield from fold(f"  {self.reading}", width or WIDTH)


@cache
def tasks() -> tuple[Task, ...]:
    """Read the tasks in the order of the page."""
    return tuple(
        _task(trade.strip(), section)
        for part in f"\n\n{FILE.read_text(encoding='utf-8')}".split(f"\n\n{TRADE}")[1:]
        for trade, *sections in [part.split(f"\n\n{TITLE}")]
        for section in sections
    )


def _task(trade: str, section: str) -> Task:
    title, _, body = section.partition("\n")
    question, _, rest = body.partition(BEGIN)
    display, _, reading = rest.partition(f"\n{END}\n")
    calls = []
    for entry in f"{display}\n".split(f"\n{CALL}")[1:]:
        command, *output = entry.removesuffix("\n").split("\n")
        calls.append(Call(command, tuple(output)))
    return Task(trade, title, _joined(question), tuple(calls), _joined(reading))


def _joined(paragraph: str) -> str:
    return " ".join(paragraph.split())


def words() -> tuple[str, ...]:
    """Return suggestions for searches: the words of trades and titles."""
    texts = [f"{task.trade} {task.title}" for task in tasks()]
    found = [word for text in texts for word in comparable(text).split() if len(word) > 2]
    return tuple(dict.fromkeys(found))


def search(text: str) -> list[Task]:
    """Return the tasks that have, for every word of a text, a word that begins so.

    Examples
    --------
    >>> [task.title for task in search("museum log")]
    ['A log']
    """
    if not text.strip():
        return [*tasks()]
    found = matching(text, tasks(), lambda task: task.words)
    if found:
        return found
    known = {word for task in tasks() for word in comparable(task.words).split() if word.isalnum()}
    unknown = next((word for word in text.split() if comparable(word) not in known), "")
    near = nearest(comparable(unknown), known, cutoff=0.75) if unknown else []
    trades = dict.fromkeys(task.trade.split()[0].lower() for task in tasks())
    raise UsageError(
        f"no example mentions '{quote(text)}'",
        corrections(unknown, *near) or f"one of these words: {', '.join(trades)}",
    )
