"""The output of a command: its format, and what it writes."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from radcalc import terminal
from radcalc.answer import Result
from radcalc.cli.spelling import spelled
from radcalc.errors import Hint, UsageError, leave_out, one_of
from radcalc.quantities.language import ENGLISH, language
from radcalc.render.formats import Judgement, Records, Style, renderer
from radcalc.render.plain import derivation, omitted
from radcalc.terminal import CSV, FORMATS, JSON, PLAIN, TABLE
from radcalc.tuples import NamedTuple
from radcalc.units import now, own_since

FEW = 3  # remarks that differ only in numbers and are all shown
WITHOUT_NUMBERS = str.maketrans("", "", "0123456789.+-e")


if TYPE_CHECKING:
    from typing import Protocol

    from radcalc.homework.question import Question

    class Listener(Protocol):
        """The prompt, which keeps answers and has output options for every line."""

        settings: dict[str, Any]

        def hear(self, results: Sequence[Result]) -> None:
            """Take the results that are being shown."""

        def ask(self, question: "Question") -> None:
            """Take the question of an answer that is about to be judged."""


class Output(NamedTuple):
    """The output format of an answer; `is_chosen` if it was requested.

    An answer states the user's definitions that are read after the time `since`.
    """

    format: str
    style: Style
    is_chosen: bool = False
    listener: "Listener | None" = None
    since: int = 0

    @property
    def is_bare(self) -> bool:
        """Return whether `--get` writes bare numbers: in plain text, unless a table is requested.

        At the prompt, which only people read, a table is a line with the unit.
        """
        as_table = self.format == TABLE and not self.is_chosen
        return self.format == PLAIN or (as_table and not self.style.brief)

    @property
    def has_columns(self) -> bool:
        """Return whether the results of `--get` are columns, however many lines there are."""
        return self.is_bare or self.format == CSV

    def hear(self, results: Sequence[Result]) -> Sequence[Result]:
        """Return the results with the user's definitions among their notes; a listener hears."""
        own = own_since(self.since)
        if own:
            results = [r._replace(notes=tuple(dict.fromkeys((*r.notes, *own)))) for r in results]
        if self.listener:
            self.listener.hear(results)
        return results

    def ask(self, question: "Question") -> None:
        if self.listener:
            self.listener.ask(question)

    def show(self, results: Sequence[Result]) -> None:
        results = [result.spelled(spelled) for result in self.hear(results)]
        if self.style.auto:
            from radcalc.render.prefixes import with_prefixes

            results = with_prefixes(results, self.format, self.style.precision)
        form = renderer(self.format)
        terminal.write(form.results(results, self._on_terminal()), exact=True)
        if form.REMARKS_ARE_APART:
            if self.style.bare:
                results = [r._replace(notes=(*r.notes, *omitted(r.rows))) for r in results]
            self.remark(results)

    def records(
        self,
        records: Records,
        notes_in: Sequence[str] = FORMATS,
        answers: bool = False,
        of_file: bool = False,
    ) -> None:
        """Write a list, with its notes apart if its format is not among some.

        A list that `answers` states the user's definitions that it uses; in CSV, one `of_file`
        has a note on cells that a spreadsheet may run.
        """
        notes = [*records.notes, *(own_since(self.since) if answers else ())]
        if of_file and self.format == CSV:
            from radcalc.render.csv import note_on_formulas

            notes += note_on_formulas(records)
        is_apart = self.format not in notes_in
        shown = records._replace(notes=() if is_apart else notes)
        terminal.write(renderer(self.format).records(shown, self._on_terminal()))
        if is_apart:
            self._say([Result((), notes=tuple(notes))])

    def judge(self, judgement: Judgement) -> None:
        """Write whether an answer is right; the listener hears the right one."""
        self.hear([Result((judgement.right,))])
        notes = (*judgement.notes, *own_since(self.since))
        steps = judgement.verdict.steps
        remarks = Result((), tuple(judgement.assumptions), notes, steps).spelled(spelled)
        judgement = judgement._replace(assumptions=remarks.assumptions, notes=remarks.notes)
        terminal.write(renderer(self.format).verdict(judgement, self._on_terminal()), exact=True)
        if self.format != JSON:
            self._say([remarks])

    def remark(self, results: Sequence[Result]) -> None:
        """Write assumptions, notes and derivations to standard error."""
        self._say([*results, Result((), notes=own_since(self.since))])

    def _say(self, results: Sequence[Result]) -> None:
        lines: list[str] = []
        if self.style.remarks:
            remarks = [line for r in results for line in terminal.remarks(r.assumptions, r.notes)]
            lines = folded([spelled(line) for line in dict.fromkeys(remarks)])
        terminal.say(lines + [line for r in results for line in derivation(r.steps)])

    def refuse_auto(self, problem: str, hint: Hint) -> None:
        if self.style.auto:
            raise UsageError(f"--auto chooses a unit, but {problem}", hint)

    def _on_terminal(self) -> Style:
        if self.format != TABLE:
            return self.style
        return self.style._replace(width=width_of_terminal())


def width_of_terminal() -> int:
    """Return the terminal's width, or 80 without a terminal."""
    import shutil  # as slow as a conversion; only for tables and pictures

    return shutil.get_terminal_size((80, 24)).columns


def height_of_terminal() -> int:
    """Return the terminal's height, or 0 without a terminal."""
    if not terminal.is_terminal():
        return 0
    import shutil

    return shutil.get_terminal_size().lines


def folded(lines: Sequence[str]) -> list[str]:
    """Merge many lines that differ only in their numbers."""
    alike: dict[str, list[str]] = {}
    for line in lines:
        alike.setdefault(line.translate(WITHOUT_NUMBERS), []).append(line)
    return [
        line
        for group in alike.values()
        for line in (group if len(group) <= FEW else [f"{group[0]} (and {len(group) - 1} like it)"])
    ]


def decide(
    format_: str | None = None,
    json_: bool = False,
    number: bool = False,
    precision: int | None = None,
    color: str = terminal.AUTO,
    quiet: bool = False,
    auto: bool = False,
    command: str = "",
    definitions: str | None = None,
    listener: "Listener | None" = None,
) -> Output:
    """Choose the format from the options and the kind of standard output.

    The file of definitions is read before.  The listener hears the answers.
    """
    if json_ and format_ not in (None, JSON):
        raise UsageError(f"--json cannot be used with --format {format_}", one_of("json", "format"))
    if number and (json_ or format_ not in (None, PLAIN)):
        raise UsageError("--number cannot be used with another format than plain", "-n alone")
    if number and auto:
        problem = "--number cannot be used with --auto: it prints no unit"
        raise UsageError(problem, leave_out("auto"))
    asked = JSON if json_ else PLAIN if number else format_
    is_terminal = terminal.is_terminal()
    chosen = asked or (TABLE if is_terminal else PLAIN)
    spoken = language() if chosen == TABLE else ENGLISH
    colored = terminal.wants_color(color, is_terminal)
    brief = listener is not None and asked is None
    style = Style(precision, number, 80, colored, spoken, not quiet, command, brief, auto)
    return Output(chosen, style, asked is not None, listener, now())


def refuse_number_options(output: Output, command: str) -> None:
    """Refuse -n, --precision and --auto, which do not apply to a list."""
    bare, precision, auto = output.style.bare, output.style.precision, output.style.auto
    if bare or precision or auto:
        useless = "-n" if bare else "--precision" if precision else "--auto"
        name = "number" if bare else useless.removeprefix("--")
        raise UsageError(f"{useless} does not apply to {command}", leave_out(name))
