"""Commands that list, search and show pages."""

import re
import subprocess
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any

import click

from radcalc import terminal
from radcalc.answer import Result, texts_of
from radcalc.calculators import lists, page, page_of
from radcalc.calculators.lists import MAIN
from radcalc.cli.command import SectionedCommand, commands, context, define, option_of
from radcalc.cli.help import is_colored, narrowed, show
from radcalc.cli.output import Output, refuse_number_options, width_of_terminal
from radcalc.cli.spelling import Shell
from radcalc.errors import RadcalcError, UsageError, call, nearest, quote
from radcalc.quantities.language import ENGLISH, LANGUAGES, language, translate
from radcalc.quantities.lookup import (
    BOUNDS,
    FIELDS,
    Task,
    how_far,
    search_tasks,
    search_typical,
    search_units,
)
from radcalc.quantities.search import search as search_quantities
from radcalc.render.formats import Records
from radcalc.terminal import BOLD, CSV, JSON, PLAIN, RESET, TABLE


@define("units", page_of("units"))
def units_command(words: tuple[str, ...], output: Output) -> None:
    """List the units, with their definitions and sources.

    \b
    Examples:
      radcalc units                    all of them
      radcalc units luminance          the units of a quantity
      radcalc units освещённость       the same, by its Russian name
      radcalc units lambert            the units with that in their name
      radcalc units cd/m2              what a unit measures, and the units like it
      radcalc units scales             dBm, mag, EV and others, with their formulas
      radcalc units constants          c, h, k_B and others, for arithmetic
    """
    refuse_number_options(output, "units")
    matches = search_units(" ".join(words))
    rows = [e._asdict() for e in matches]
    rows = [{"unit": row.pop("name"), **row} for row in rows]
    table = [{**row, "quantity": translate(row["quantity"], output.style.language)} for row in rows]
    notes = list(dict.fromkeys(e.note for e in matches if e.note))
    output.records(Records(rows, notes, table, inputs=texts_of({"search": " ".join(words)})))


@define("typical", page_of("typical"))
def typical_command(words: tuple[str, ...], output: Output) -> None:
    """List typical values: sun, sky, rooms, lamps, screens, plants, with sources.

    \b
    Examples:
      radcalc typical                  all of them
      radcalc typical candle           by a word, in English, Czech or Russian
      radcalc typical illuminance      by a quantity
      radcalc typical cd/m2            by a unit
      radcalc typical 500lx            the nearest to a value

    Errors in published tables are corrected, with a note.
    """
    refuse_number_options(output, "typical")
    text = " ".join(words)
    matches = search_typical(text)
    fields = (*FIELDS, *BOUNDS) if output.format in (JSON, CSV) else FIELDS
    rows = [{field: getattr(value, field) for field in fields} for value in matches]
    language = output.style.language
    translated = [
        {"what": v.name(language), "quantity": translate(v.quantity, language)} for v in matches
    ]
    table = [{**row, **names} for row, names in zip(rows, translated, strict=True)]
    notes = [f"{v.what}, {v.value} {v.unit}: {v.note}" for v in matches if v.note]
    inputs = texts_of({"search": text})
    is_json = output.format == JSON
    output.records(Records(rows, notes, table, right=("value",), inputs=inputs), answers=is_json)
    if not is_json:
        far = how_far(text, matches)
        output.remark([Result((), notes=(far,) if far else ())])


@define("quantities", page_of("quantities"))
def quantities_command(words: tuple[str, ...], lang: str | None, output: Output) -> None:
    """List the quantities of light: names in English, Czech and Russian, symbols and units.

    \b
    Examples:
      radcalc quantities                   all of them
      radcalc quantities svítivost         by a name, with or without diacritics
      radcalc quantities Phi_v             by a symbol
      radcalc quantities W/m2/sr           by a unit
      radcalc quantities 'luminous flux [W]'
                                           a name with a unit: do they fit?
      radcalc quantities --lang ru         with Russian names first

    Misused words (intensity, luminosity) lead to the correct term, with a note.
    """
    refuse_number_options(output, "quantities")
    first = lang or language()
    matches = search_quantities(" ".join(words))
    order = [first, *(code for code in LANGUAGES if code != first)]
    rows = [
        {
            "name": q.name(first),
            "symbol": q.symbol,
            "unit": q.unit,
            "definition": q.definition,
            **{code: q.names(code) for code in LANGUAGES},
            "note": note,
        }
        for q, note in matches
    ]
    table = [
        {
            "name": "\n".join(", ".join(q.names(code)) for code in order if q.names(code)),
            "symbol": q.symbol,
            "unit": q.unit,
            "definition": q.definition,
        }
        for q, _ in matches
    ]
    notes = [f"{q.name(ENGLISH)}: {note}" for q, note in matches if note]
    inputs = texts_of({"search": " ".join(words), "lang": lang or ""})
    output.records(Records(rows, notes, table, inputs=inputs))


@define("examples", page_of("examples"))
def examples_command(words: tuple[str, ...], output: Output) -> None:
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
    found = search_tasks(text)
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


# The kinds with their plurals, and the commands that list all of one kind.


PREFIX = f"{MAIN}-"
OF_COMMANDS = "1"
SECTIONS = (OF_COMMANDS, "7")
# Programs that show a page; the first that is installed does.  Every `man` takes an argument with a
# slash as the path of a page.  With -a, mandoc shows a page screen by screen, as `man` does.
PROGRAMS = (["man"], ["mandoc", "-a"])
OVERSTRUCK = re.compile(".\b")  # a letter below the next one, which is then bold or underlined


def find_pages(words: Sequence[str]) -> list[Path]:
    """Return the pages of a name, which may have a section before it, and `radcalc-`.

    That of a command, in section 1, is the first.

    Examples
    --------
    >>> [page.name for page in find_pages(["units"])]
    ['radcalc-units.1', 'radcalc-units.7']
    >>> [page.name for page in find_pages(["7", "units"])]
    ['radcalc-units.7']
    """
    section = words[0] if words and words[0] in SECTIONS else ""
    typed = " ".join(words[1:] if section else words)
    name = "-".join(typed.split()).lower().removeprefix(PREFIX) or MAIN
    known = lists.manual_pages()
    if not known:
        problem = f"cannot read '{quote(str(lists.manual_folder()))}': it has no pages"
        raise RadcalcError(problem, "a new installation of radcalc")
    named = [page for page in known if _name(page) == name]
    found = [page for page in named if _section(page) in (section or SECTIONS)]
    if not found:
        place = f"section {section} of the manual" if section else "the manual"
        near = [name] if named else nearest(name, map(_name, known))
        hint = [call("manual", other) for other in near] or [call("manual")]
        raise UsageError(f"{place} has no page '{quote(typed or MAIN)}'", hint)
    return found


def _name(page: Path) -> str:
    return page.stem.removeprefix(PREFIX)


def _section(page: Path) -> str:
    return page.suffix[1:]


def manual(words: Sequence[str], color: str) -> None:
    """Show a page of the manual with man.

    \b
    Examples:
      radcalc manual                 the main page, which lists the others
      radcalc manual convert         the page of a command
      radcalc manual solid angle     a name of several words
      radcalc manual sentences       a page on a subject
      radcalc manual 7 units         a page that has the name of a command

    On a terminal, man shows the page screen by screen; in a pipe, the page is plain text.  Without
    man and mandoc, the path of the page is printed, and the --help of its command.
    """
    page, *others = find_pages(words)
    if not _has_shown(page):
        show("\n\n".join([str(page), *_helps(page)]))
        problem = "neither man nor mandoc is available: this is the path of the page"
        terminal.say(terminal.remarks((), [problem]))
    terminal.say(terminal.remarks((), [_mention(other) for other in others]))


def _has_shown(page: Path) -> bool:
    """Show a page with one of `PROGRAMS`; return whether one could show it."""
    output = None if terminal.is_terminal() else subprocess.PIPE
    for program in PROGRAMS:
        words = [*program, str(page)]
        try:
            done = subprocess.run(words, stdout=output, text=True, errors="replace", check=False)
        except OSError:  # it is not installed
            continue
        if done.returncode == 0:
            terminal.write(OVERSTRUCK.sub("", done.stdout or ""))
            return True
    return False


def _helps(page: Path) -> list[str]:
    """Return the help of the command that a page describes; none for a page on a subject."""
    if _section(page) != OF_COMMANDS:
        return []
    top = context()
    name = _name(page)
    command = commands.get_command(top, name)
    of_page = click.Context(command, top, name, color=is_colored()) if command else top
    return [of_page.get_help()]


def _mention(page: Path) -> str:
    """Return the call that shows a page, with what the page is about."""
    about = re.search(r"^\.Nd (.*)$", page.read_text(encoding="utf-8"), re.M)
    typed = Shell.command("manual", _section(page), _name(page))
    return f"{typed} has {about[1]}" if about else typed


PAGE = page_of("manual")
COLOR = option_of(page.COLOR)
manual_command = SectionedCommand(
    "manual",
    callback=manual,
    params=[click.Argument(["words"], nargs=-1, metavar="[SECTION] [PAGE]"), COLOR],
    help=manual.__doc__,
    sections={"Output": (COLOR,)},
    page=PAGE,
)
