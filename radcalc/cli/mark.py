"""`radcalc mark FILE`: answers of students to the questions of a sheet."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import click

from radcalc import terminal
from radcalc.answer import texts_of
from radcalc.calculators import page_of
from radcalc.calculators.page import OF_ANSWERS
from radcalc.calculators.results import said_of
from radcalc.cli import sentence, spelling, trials
from radcalc.cli.command import define
from radcalc.cli.lane import Asked, asked
from radcalc.cli.output import Output, refuse_number_options
from radcalc.cli.refusals import of_click
from radcalc.cli.spelling import Shell, refuse_long, spelled, split
from radcalc.errors import RadcalcError, UsageError, drop, listed, printable, quote, spell
from radcalc.errors import command as call_of
from radcalc.homework import marking
from radcalc.homework.marking import Key, Mark, Sheet, SheetRow
from radcalc.render.formats import Records
from radcalc.render.plain import number
from radcalc.terminal import JSON, TABLE

TOTAL = "total"
DIGITS = 6  # of points


class Marked(NamedTuple):
    """A student's answer to a question, as typed, with its mark and its points."""

    row: SheetRow
    right: str
    student: str
    mark: Mark
    points: float

    @property
    def record(self) -> dict[str, Any]:
        return {
            "student": printable(self.student),
            "question": printable(self.row.question),
            "answer": printable(self.row.answers[self.student].typed),
            "right": self.right,
            "verdict": self.mark.verdict,
            "mistake": self.mark.mistake,
            "likely": spell(self.mark.likely, InCell).lstrip(": "),
            **_points(self.points, self.row.points),
        }


class InCell(Shell):
    """The spelling in a message about a cell, which has no --check."""

    @staticmethod
    def option(name: str, value: str) -> str:
        return value if name == "check" else Shell.option(name, value)


@define("mark", page_of("mark"))
def command(
    words: tuple[str, ...], points: str | None, tolerance: str | None, output: Output
) -> int:
    """Mark the answers of students: right or wrong, the likely mistake, points.

    \b
    Examples:
      radcalc mark sheet.csv
      radcalc mark sheet.csv --format csv > gradebook.csv
      radcalc mark sheet.csv --points unit=0,mistake=0.25 --tolerance 2%

    \b
    FILE has a header, then one question in each row:
      question;command;expected;points;Ann;Bob
      Spotlight;20000 cd at 8 m to lx;;2;312 lx;2500 lx
      Cone;solid-angle cone --half-angle 30deg;0.842 sr;1;0.84;
      Speed of light;;299792458 m/s;1;3e8 m/s;3e8

    \b
    question   text of the question (default: the command)
    command    a command or a sentence of radcalc, with or without radcalc; it never writes, and
               is not run by a shell.  -g names the result if there are several.
    expected   the right answer: instead of the command, or to check it
    points     points for a right answer (default 1)
    Every other column has the answers of a student, whose name is its title.
    """
    refuse_number_options(output, "mark")
    path = spelling.only_file(words, "sheet", call_of("mark", "FILE"))
    parts = marking.read_parts(points) if points is not None else marking.PARTS
    sheet = marking.read_sheet(path)
    keys = [_key(sheet, row, tolerance) for row in sheet.rows]
    marked = [*_marked(sheet, keys, parts)]
    notes = _assumptions(sheet, keys)
    rows = [*_with_totals(sheet, marked)]
    table = [_cells(row, len(sheet.students) > 1) for row in rows]
    inputs = texts_of({"file": path, "points": points or "", "tolerance": tolerance or ""})
    records = Records(rows, notes, table, ("points", "of"), inputs, ("answer",))
    output.records(records, (JSON, TABLE), answers=True, of_file=True)
    is_right = all(one.mark.verdict == marking.RIGHT for one in marked)
    return terminal.ANSWERED if is_right else terminal.WRONG


# ---------------------------------------------------------------------------------------------
# The key


def _key(sheet: Sheet, row: SheetRow, tolerance: str | None) -> Key:
    """Return the key of a question; raise its error with the place in the sheet."""
    words: list[str] = []
    column = marking.COMMAND if row.command else marking.EXPECTED
    try:
        if not row.command:
            return marking.key(marking.of_value(row.expected), "", "", tolerance)
        refuse_long(row.command)
        words = split(row.command)
        question, wanted, own = _asked(words)
        found = marking.key(question, wanted, row.expected, own or tolerance)
        if row.expected:
            column, words = marking.EXPECTED, []
            marking.refuse_unlike(found, row.expected)
        return found
    except (RadcalcError, click.UsageError) as error:
        problem = of_click(error, words) if isinstance(error, click.UsageError) else error
        shown = trials.trials(problem, words) if words else []
        message, hint = problem.spelled(InCell)
        hint = " or ".join([trial.command for trial in shown]) or hint
        problem_here = message.replace("--check", "a question").lstrip(": ")
        raise sheet.error(row, column, problem_here, hint) from None


def _asked(words: list[str]) -> Asked:
    """Return the question that a command or a sentence asks."""
    if not words:
        raise UsageError("the command is missing", "a command after radcalc")
    trials.refuse_effects(words)
    _, options = sentence.options_of(words, OF_ANSWERS)
    if options:
        problem = f"{quote(options[0])} does not apply to a question"
        raise UsageError(problem, drop(options[0]))
    if spelling.begins_with_file(words):
        words = spelling.call_of_file(words)
    try:
        return asked(words)
    except (RadcalcError, click.UsageError) as error:
        return asked(sentence.as_call(words, error, trials.has_answers))


def _assumptions(sheet: Sheet, keys: Sequence[Key]) -> list[str]:
    """Return the assumptions of the right answers, each with the lines of its questions."""
    lines: dict[str, list[str]] = {}
    for row, found in zip(sheet.rows, keys, strict=True):
        for assumption in said_of(found.question.answer, [found.right])[0]:
            lines.setdefault(spelled(assumption), []).append(str(row.line))
    return [
        f"line{'s' if len(found) > 1 else ''} {listed(found)}: assumed: {assumption}"
        for assumption, found in lines.items()
    ]


# ---------------------------------------------------------------------------------------------
# The marks


def _marked(sheet: Sheet, keys: Sequence[Key], parts: Mapping[str, float]) -> Iterator[Marked]:
    """Yield the answers of each student; equal answers to a question are judged once."""
    known: dict[tuple[int, str], Mark] = {}
    for student in sheet.students:
        for row, found in zip(sheet.rows, keys, strict=True):
            _, text, problem = row.answers[student]
            if not problem and (row.line, text) not in known:
                known[row.line, text] = marking.mark(found, text)
            judged = Mark(marking.UNREADABLE, likely=problem) if problem else known[row.line, text]
            part = parts.get(judged.verdict, 0.0)
            yield Marked(row, found.text, student, judged, row.points * part)


def _with_totals(sheet: Sheet, marked: Sequence[Marked]) -> Iterator[dict[str, Any]]:
    """Yield the records of each student's answers, and then of the total."""
    most = sum(row.points for row in sheet.rows)
    for student in sheet.students:
        own = [one for one in marked if one.student == student]
        yield from (one.record for one in own)
        total = dict.fromkeys(own[0].record, "") | {"student": own[0].record["student"]}
        yield total | {"verdict": TOTAL, **_points(sum(one.points for one in own), most)}


def _points(points: float, most: float) -> dict[str, float]:
    """Return points and the most possible, as whole numbers if they are."""
    sizes = {"points": round(points, DIGITS), "of": round(most, DIGITS)}
    return {name: int(size) if size.is_integer() else size for name, size in sizes.items()}


def _cells(record: Mapping[str, Any], has_several: bool) -> dict[str, str]:
    """Return a row of the table, without the right answer."""
    cells = {"student": record["student"]} if has_several else {}
    cells |= {name: record[name] for name in ("question", "answer", "verdict")}
    if record["verdict"] == TOTAL:
        cells |= {"question": TOTAL, "verdict": ""}
    numbers = {name: number(record[name], DIGITS) for name in ("points", "of")}
    return {**cells, "likely mistake": record["likely"], **numbers}
