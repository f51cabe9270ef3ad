"""Marks and points for the answers of a sheet, and the sheet itself."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import NamedTuple

from radcalc import errors
from radcalc.answer import Row, Value
from radcalc.calculators.results import pick, rows, unit_for
from radcalc.errors import listed, option, quote
from radcalc.files import Text, columns, reading, refusal, where
from radcalc.files.columns import NamedHead, Table
from radcalc.homework import ROUNDED, Verdict, check
from radcalc.homework.question import Question, is_rounded, of_conversion, read_claim
from radcalc.units import NUMBER, unit_behind
from radcalc.units.numbers import read_number
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve

QUESTION, COMMAND, EXPECTED, POINTS = KNOWN = ("question", "command", "expected", "points")
MOST_BYTES = 1 << 26  # of a sheet
ALIKE = 0.8  # of a title and the column that it misspells
HEADER = "a header such as question;command;Ann;Bob, and a row for each question"


class Cell(NamedTuple):
    """A cell as typed, with decimal points, and the reason if its numbers are ambiguous."""

    typed: str
    text: str
    problem: str = ""


class SheetRow(NamedTuple):
    """A question as typed, with its points and the answers by student."""

    line: int
    question: str
    command: str
    expected: str
    points: float
    answers: dict[str, Cell]


class Sheet(NamedTuple):
    """The name of a sheet in messages, its rows, and the students."""

    name: str
    rows: Sequence[SheetRow]
    students: Sequence[str]

    def error(self, row: SheetRow, column: str, problem: str, hint: str) -> errors.ConditionError:
        place = f"{where(self.name, row.line)}, column '{column}'"
        return errors.ConditionError(f"{place}: {problem}", hint)


def read_sheet(path: str) -> Sheet:
    """Read a sheet: CSV with any delimiter, or text with | between its columns."""
    with reading(path, "a table of questions and answers") as (name, read):
        blocks = Text(name, read, "a question", MOST_BYTES).blocks()
        lines = [entry for start, block in blocks for entry in enumerate(block, start)]
    head = NamedHead(name, lines, _is_known, "question", HEADER)
    table = head.table
    cells = [(number, table.cells(number, line)) for number, line in head.below]
    refuse = partial(refusal, name, head.title_line)
    places = _places(table.titles, [row for _, row in cells], refuse)
    by_title = {t: _pointed([row[place] for _, row in cells]) for t, place in places.items()}
    rows = [
        _row(table, line, {title: column[k] for title, column in by_title.items()})
        for k, (line, _) in enumerate(cells)
    ]
    table.finish()
    return Sheet(name, rows, [title for title in places if title not in KNOWN])


def _is_known(title: str) -> bool:
    return columns.plain(title) in KNOWN


def _row(table: Table, line: int, cells: dict[str, Cell]) -> SheetRow:
    own = {title: cells.pop(title, Cell("", "")) for title in KNOWN}
    expected, points = own[EXPECTED], 1.0
    if expected.problem:
        raise table.refuse(line, expected.problem, columns.MARKS)
    if not expected.text and not own[COMMAND].typed:
        problem = "the question has neither a command nor an expected value"
        raise table.refuse(line, problem, HEADER)
    if own[POINTS].text or POINTS in table.titles:
        points = table.number(own[POINTS].typed, line)
    if points < 0:
        raise table.refuse(line, f"{points:g} points are less than none", "0 or more points")
    question = own[QUESTION].typed or own[COMMAND].typed or expected.typed
    return SheetRow(line, question, own[COMMAND].typed, expected.text, points, cells)


def _places(
    titles: Sequence[str],
    rows: Sequence[Sequence[str]],
    refuse: Callable[[str, str], errors.RadcalcError],
) -> dict[str, int]:
    """Return the place of each column by its title, or by its name if it is one of the sheet's.

    A column without a title and without cells does not count: text may begin and end with |.
    """
    places: dict[str, int] = {}
    for place, title in enumerate(titles):
        name = columns.plain(title)
        name = name if name in KNOWN else title
        if not name and not any(row[place] for row in rows):
            continue
        if not name:
            raise refuse(f"column {place + 1} has no title", "a title: the name of a student")
        if name in places:
            raise refuse(f"column '{quote(title)}' appears twice", "each column once")
        places[name] = place
    if COMMAND not in places and EXPECTED not in places:
        raise refuse("a column 'command' or 'expected' is missing", HEADER)
    missing = [name for name in KNOWN if name not in places]
    for title in places:
        if title not in KNOWN and (near := errors.nearest(columns.plain(title), missing, 1, ALIKE)):
            raise refuse(f"column '{quote(title)}' is not a student", f"{near[0]}, as its title")
    if not {*places} - {*KNOWN}:
        raise refuse("no column has answers", "a column for each student, with the name as title")
    return places


def _pointed(texts: Sequence[str]) -> list[Cell]:
    """Return the cells of a column with points for its decimal commas.

    A comma before other than three digits is decimal, and then so are all commas of the column.
    """
    numbers = [number for text in texts for number in columns.MARKED.findall(text)]
    commas = filter(columns.COMMA.fullmatch, numbers)
    has_commas = not all(map(columns.THOUSANDS.fullmatch, commas))
    return [_cell(text, has_commas) for text in texts]


def _cell(typed: str, has_commas: bool) -> Cell:
    text = typed
    for number in columns.MARKED.findall(typed):
        if has_commas and columns.POINTED_THOUSANDS.fullmatch(number):
            return Cell(typed, text, f"'{quote(number)}' is ambiguous: a thousand or a decimal")
        if has_commas and columns.COMMA.fullmatch(number):
            text = text.replace(number, number.replace(",", "."))
    return Cell(typed, text)


RIGHT, UNIT, DIGITS, MISTAKE = "right", "unit missing", "too few digits", "mistake"
WRONG, UNREADABLE, EMPTY = "wrong", "not readable", "no answer"
# The names in --points, and the parts of a question's points; nothing else has points.
NAMES = {"unit": UNIT, "digits": DIGITS, "mistake": MISTAKE}
PARTS: Mapping[str, float] = {RIGHT: 1.0, UNIT: 0.5, DIGITS: 0.75, MISTAKE: 0.5}
WRONG_UNIT = "wrong-unit"
MOST = 3  # results that a hint proposes


class Key(NamedTuple):
    """A question with the result that it asks for, as a row with its right value."""

    question: Question
    target: Value
    right: Row
    tolerance: str | None

    @property
    def text(self) -> str:
        """The right value with its unit."""
        return f"{self.right.value:.6g}{unit_behind(self.right.unit)}"


class Mark(NamedTuple):
    """The verdict on an answer in a word, the name of the likely mistake, and what was done."""

    verdict: str
    mistake: str = ""
    likely: str = ""


def of_value(text: str) -> Question:
    """Return the question that a value answers: its conversion to its own unit."""
    amount = read_amount(text)
    unit = amount.typed[1] or resolve("1")
    return of_conversion(float(amount.exact), unit, unit, (), amount=amount)


def key(question: Question, wanted: str, expected: str, tolerance: str | None) -> Key:
    """Return the key of a question for a result NAME[:UNIT].

    Without the name, the question has one result, or the one that the expected value is for.
    """
    present = [v for v in question.answer.values if v.given is None and not v.is_absent]
    names = {value.name for value in present}
    if not wanted and len(names) > 1 and expected:
        verdict = check(question, expected, tolerance)
        wanted = f"{verdict.name}:{verdict.unit}"
    if not wanted and len(names) != 1:
        proposed = [errors.add("get", f"{row.name}:{row.unit}") for row in rows(present)[:MOST]]
        raise errors.UsageError("a question has one answer, but its command has several", proposed)
    row = pick(question.answer.values, wanted or present[0].name)
    if not isinstance(row.value, float):
        problem = "a question has one answer, not several"
        raise errors.UsageError(problem, "a result that is a number")
    target = next(v for v in question.answer.values if row.name in (v.name, v.also))
    found = Key(question, target, row, tolerance)
    own = f"{row.name}={row.value!r} {row.unit}"
    check(question, own, tolerance)  # refuses a tolerance that cannot be read
    return found


def refuse_unlike(asked: Key, expected: str) -> None:
    """Refuse an expected value that contradicts the right one."""
    verdict, _ = _judged(asked, expected)
    if not verdict.right:
        problem = f"{quote(expected)} contradicts the command, which gives {asked.text}"
        raise errors.ConditionError(problem, f"{asked.text}, or another command")


def mark(asked: Key, answer: str) -> Mark:
    """Return the mark of an answer; one that cannot be read has the reason, with its mentions."""
    if not answer.strip():
        return Mark(EMPTY)
    try:
        verdict, is_bare = _judged(asked, answer)
        claim = read_claim(answer)
    except errors.RadcalcError as error:
        return Mark(UNREADABLE, likely=error.message)
    if verdict.result != asked.target.name:
        return Mark(WRONG, likely=f"this is the {verdict.result}")
    first = verdict.diagnoses[0] if verdict.diagnoses else None
    mistake, done = (first.mistake, first.done) if first else ("", "")
    if mistake == ROUNDED and (not verdict.right or is_rounded(claim, verdict.value)):
        kind = UNIT if is_bare else DIGITS
        return Mark(kind, likely=f"rounded {done}: {first.right}" if first else "")
    if verdict.right:
        return Mark(UNIT if is_bare else RIGHT)
    is_named = bool(mistake) and not is_bare
    if mistake == WRONG_UNIT:
        text = f"{asked.right.name}={claim.number} {asked.right.unit}"
        is_named = check(asked.question, text, asked.tolerance).right
    return Mark(MISTAKE if is_named else WRONG, mistake, done)


def _judged(asked: Key, answer: str) -> tuple[Verdict, bool]:
    """Return the verdict on an answer to the result asked for, and whether its unit is missing."""
    claim, unit = read_claim(answer), asked.right.unit
    text = f"{claim.name or asked.right.name}={answer.rpartition('=')[2]}"
    if claim.unit:
        return check(asked.question, text, asked.tolerance), False
    if claim.number not in answer:  # arithmetic
        text = f"{claim.name or asked.right.name}={claim.number}"
    own = unit_for(asked.target, asked.target.units[0])
    if own.dimension == NUMBER and not own.is_scale:  # 8 is not an answer of 3 stops
        verdict = check(asked.question, f"{text} 1", asked.tolerance)
        if verdict.right or unit == "1":
            return verdict, False
    return check(asked.question, f"{text} {unit}", asked.tolerance), True


def read_parts(text: str) -> dict[str, float]:
    """Read the parts of a question's points: unit=0.5,digits=0.75,mistake=0.5."""
    parts = dict(PARTS)
    for entry in text.split(","):
        name, _, number = map(str.strip, entry.partition("="))
        if name not in NAMES:
            problem = f"{option('points')}: unknown verdict '{quote(name)}'"
            hint = f"some of {listed([f'{n}=0.5' for n in NAMES], ',')}"
            raise errors.ConditionError(problem, hint)
        try:
            part, end = read_number(number)
        except errors.NumberError:
            part, end = -1.0, 0
        if end != len(number) or not 0 <= part <= 1:
            problem = f"{option('points')}: '{quote(entry.strip())}' is out of range"
            hint = f"{name}=0.5: a part of a question's points, from 0 to 1"
            raise errors.ConditionError(problem, hint)
        parts[NAMES[name]] = part
    return parts
