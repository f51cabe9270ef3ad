"""Commands that list, search and show pages."""

import re
import subprocess
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import groupby
from pathlib import Path
from typing import Any

import click

from radcalc import terminal
from radcalc.answer import Result, texts_of
from radcalc.calculators import lists, page
from radcalc.calculators.lists import MAIN
from radcalc.calculators.pages import COMMANDS, page_of
from radcalc.cli.command import SectionedCommand, define, option_of
from radcalc.cli.files import only_file, proposed
from radcalc.cli.findings import EXACT, Finding, find, near
from radcalc.cli.group import commands, context
from radcalc.cli.help import is_colored, narrowed, show
from radcalc.cli.output import Output, refuse_number_options, width_of_terminal
from radcalc.cli.spelling import Shell, pasted, quoted
from radcalc.errors import (
    ConditionError,
    RadcalcError,
    UsageError,
    call,
    nearest,
    quote,
    quote_path,
)
from radcalc.errors import command as call_of
from radcalc.quantities.entries import search as search_units
from radcalc.quantities.language import ENGLISH, LANGUAGES, language, translate
from radcalc.quantities.light import read as read_light
from radcalc.quantities.search import search as search_quantities
from radcalc.quantities.typical import BOUNDS, FIELDS, how_far
from radcalc.quantities.typical import search as search_typical
from radcalc.quantities.units import offered
from radcalc.render.formats import Records
from radcalc.render.plain import number
from radcalc.routes.kinds import NAMES, ColumnSummary, contents_of, listing
from radcalc.sentences import tasks
from radcalc.sentences.tasks import Task
from radcalc.sentences.tasks import search as search_tasks
from radcalc.streams.log_layout import FirstRows
from radcalc.terminal import BOLD, CSV, JSON, PLAIN, RESET, TABLE
from radcalc.units.table import resolve
from radcalc.units.unit import Unit

DIGITS = 6


@define("columns", page_of("columns"))
def columns_command(words: tuple[str, ...], output: Output) -> None:
    """List the columns of a table: units, extremes, mean, and a command for each.

    \b
    Examples:
      radcalc columns log.csv          a log with several columns of light
      radcalc columns sensors.csv      any table of numbers
      radcalc sensors.csv              the same

    The mean of a column is that of its numbers, each of which counts the same; radcalc dose has
    the mean over time.  A command for a column of light with times adds up its dose, any other
    command converts the column.
    """
    refuse_number_options(output, "columns")
    path = only_file(words, "table", call_of("columns", "FILE"))
    found = contents_of(path)
    if found.rows is None:
        problem = f"{quote_path(path)} is {NAMES[found.kind]}, not a table"
        raise ConditionError(problem, proposed(found.kind, path))
    listed = listing(path, found.rows)
    rows = [_row(path, found.rows, column, output.format) for column in listed.columns]
    table = [{key: str(cell) for key, cell in row.items()} for row in rows]
    notes = (f"{listed.rows} rows", *listed.notes)
    right = ("numbers", "from", "to", "mean")
    output.records(Records(rows, notes, table, right, texts_of({"file": path})), (JSON, TABLE))


def _row(path: str, rows: FirstRows, column: ColumnSummary, form: str) -> dict[str, Any]:
    """Return the record of a column, with all digits of its numbers or a few."""
    is_exact = form in (JSON, CSV)
    low: Any = column.first
    high: Any = column.last
    mean: Any = column.mean
    if column.count:
        low, high = column.least, column.greatest
    if column.count and not is_exact:
        low, high, mean = [number(value, DIGITS) for value in (low, high, mean)]
    return {
        "column": column.name,
        "unit": column.unit.text if column.unit else "",
        "numbers": column.count,
        "from": low,
        "to": high,
        "mean": "" if mean is None and form != JSON else mean,
        "command": _command(path, rows, column),
    }


def _command(path: str, rows: FirstRows, column: ColumnSummary) -> str:
    """Return the command that converts a column, or adds up its dose; "" without a unit."""
    if column.unit is None or not column.count:
        return ""
    if (rows.times or rows.parts) and read_light(column.unit):
        return f"radcalc dose {quoted(path)} --column {quoted(column.name)}"
    target = _another(column.unit)
    if not target or not rows.names:
        return ""
    name = column.name if len(rows.table.titles) == 1 else str(column.place + 1)
    words = [
        "radcalc convert -",
        quoted(column.unit.text),
        quoted(target),
        "--column",
        quoted(name),
    ]
    if rows.table.delimiter:
        words.append(
            "-d tab" if rows.table.delimiter == "\t" else f"-d {quoted(rows.table.delimiter)}"
        )
    if rows.table.decimals.comma:
        words.append("--decimal ,")
    if rows.begin > 2:
        words.append(f"--header={rows.begin - 1}")
    return " ".join([*words, "<", quoted(path)])


def _another(unit: Unit) -> str:
    """Return the first unit of the same quantity with another size, or ""."""
    if unit.is_scale:
        return ""
    units = (text for text in offered(unit) if resolve(text).factor != unit.factor)
    return next(units, "")


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
    output.records(Records(rows, notes, table, right=("value",), inputs=inputs))
    if output.format != JSON and (far := how_far(text, matches)):
        output.remark([Result((), notes=(far,))])


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


MOST, OF_A_KIND = 20, 5  # findings shown, and of one kind unless they have the exact name
# The kinds with their plurals, and the commands that list all of one kind.
KINDS = {
    "command": ("commands", ()),
    "result": ("results", ()),
    "quantity": ("quantities", ("quantities",)),
    "unit": ("units", ("units",)),
    "spectrum": ("spectra", ("spectrum", "--list")),
    "typical value": ("typical values", ("typical",)),
    "option": ("options", ()),
}


@define("help", page_of("help"))
def help_command(words: tuple[str, ...], output: Output) -> None:
    """Show the help of a command, or search for words.

    \b
    Examples:
      radcalc help convert             the same as radcalc convert --help
      radcalc help beam angle          options, quantities ... with these words
      radcalc help lux                 a unit, its quantity, typical values
      radcalc help sunlight            spectra and typical values

    The search covers commands, options, results, quantities, units, spectra and typical values.
    Exact names come first, then names that begin so, then words of names and of texts.
    """
    refuse_number_options(output, "help")
    text = " ".join(words)
    if not text.strip():
        raise UsageError("a word is missing", [call("help", "lux"), call("--help")])
    if len(words) > 1 and all(word in COMMANDS for word in words):
        raise UsageError("help takes one command", [call(word, "--help") for word in words])
    found = find(text)
    if not found:
        similar = [call("help", *name.split()) for name in near(text, 3)]
        raise UsageError(
            f"nothing has the words '{quote(text)}'", similar or [call("--help"), call("examples")]
        )
    shown = _best(found, text)
    rows = [
        {"kind": one.kind, "name": one.name, "what": one.what, "command": pasted(one.call)}
        for one in shown
    ]
    titles = ("kind", "name", "what it is", "command to type")
    table = [dict(zip(titles, row.values(), strict=True)) for row in rows]
    notes = [*_more(text, found, shown), *_tasks(text)]
    inputs, unfolded = texts_of({"search": text}), ("command to type",)
    output.records(Records(rows, notes, table, inputs=inputs, unfolded=unfolded), (JSON,))


def _best(found: Sequence[Finding], text: str) -> list[Finding]:
    """Return the findings to show."""
    shown: list[Finding] = []
    for finding in found:
        alike = sum(other.kind == finding.kind for other in shown)
        if len(shown) < MOST and (alike < OF_A_KIND or finding.place(text) == EXACT):
            shown.append(finding)
    return shown


def _more(text: str, found: Sequence[Finding], shown: Sequence[Finding]) -> Iterator[str]:
    """Yield the numbers of the findings that are not shown, with the calls that list them."""
    for kind, (plural, lists_them) in KINDS.items():
        more = sum(one.kind == kind for one in found) - sum(one.kind == kind for one in shown)
        if more:
            way = f": {pasted((*lists_them, *text.split()))}" if lists_them else ""
            yield f"{more} more {kind if more == 1 else plural}{way}"


def _tasks(text: str) -> Iterator[str]:
    with suppress(UsageError):  # no task has the words
        count = len(tasks.search(text))
        mention = "1 example mentions" if count == 1 else f"{count} examples mention"
        yield f"{mention} it: {pasted(('examples', *text.split()))}"


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
