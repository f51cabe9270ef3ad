"""Sheets of questions: a table with a row for each question and a column for each student."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

from radcalc.errors import ConditionError, RadcalcError, nearest, quote
from radcalc.files import columns
from radcalc.files.table import Table
from radcalc.files.text import Text, reading, refusal, where

QUESTION, COMMAND, EXPECTED, POINTS = KNOWN = ("question", "command", "expected", "points")
MOST_BYTES = 1 << 26  # of a sheet
ALIKE = 0.8  # of a title and the column that it misspells
RULE = " \t;,|-:+="  # characters of a line below the titles of a text, and of a blank row
HEADER = "a header such as question;command;Ann;Bob, and a row for each question"


class Cell(NamedTuple):
    """A cell as typed, with decimal points, and the reason if its numbers are ambiguous."""

    typed: str
    text: str
    problem: str = ""


class Row(NamedTuple):
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
    rows: Sequence[Row]
    students: Sequence[str]

    def error(self, row: Row, column: str, problem: str, hint: str) -> ConditionError:
        place = f"{where(self.name, row.line)}, column '{column}'"
        return ConditionError(f"{place}: {problem}", hint)


def read_sheet(path: str) -> Sheet:
    """Read a sheet: CSV with any delimiter, or text with | between its columns."""
    with reading(path, "a table of questions and answers") as (name, read):
        blocks = Text(name, read, "a question", MOST_BYTES).blocks()
        lines = [entry for start, block in blocks for entry in enumerate(block, start)]
    lines = [(number, line) for number, line in lines if line.strip(RULE)]
    if len(lines) < 2:
        problem = "the sheet has no question" if lines else "the sheet is empty"
        raise refusal(name, 0, problem, HEADER)
    number, header = lines[0]
    delimiter = max(columns.DELIMITERS, key=lambda mark: _known(columns.cells(header, mark)))
    titles = columns.cells(header, delimiter)
    table = Table(partial(refusal, name), delimiter, len(titles), [titles])
    cells = [(line, table.cells(line, text)) for line, text in lines[1:]]
    places = _places(titles, [row for _, row in cells], partial(refusal, name, number))
    by_title = {t: _pointed([row[place] for _, row in cells]) for t, place in places.items()}
    rows = [
        _row(table, line, {title: column[k] for title, column in by_title.items()})
        for k, (line, _) in enumerate(cells)
    ]
    table.finish()
    return Sheet(name, rows, [title for title in places if title not in KNOWN])


def _known(titles: Sequence[str]) -> int:
    return len({*map(columns.plain, titles)} & {*KNOWN})


def _row(table: Table, line: int, cells: dict[str, Cell]) -> Row:
    own = {title: cells.pop(title, Cell("", "")) for title in KNOWN}
    expected, points = own[EXPECTED], 1.0
    if expected.problem:
        raise table.refuse(line, expected.problem, columns.MARKS)
    if not expected.text and not own[COMMAND].typed:
        problem = "the question has neither a command nor an expected value"
        raise table.refuse(line, problem, HEADER)
    if own[POINTS].text or POINTS in table.titles[0]:
        points = table.number(own[POINTS].typed, line)
    if points < 0:
        raise table.refuse(line, f"{points:g} points are less than none", "0 or more points")
    question = own[QUESTION].typed or own[COMMAND].typed or expected.typed
    return Row(line, question, own[COMMAND].typed, expected.text, points, cells)


def _places(
    titles: Sequence[str],
    rows: Sequence[Sequence[str]],
    refuse: Callable[[str, str], RadcalcError],
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
        if title not in KNOWN and (near := nearest(columns.plain(title), missing, 1, ALIKE)):
            raise refuse(f"column '{quote(title)}' is not a student", f"{near[0]}, as its title")
    if not {*places} - {*KNOWN}:
        raise refuse("no column has answers", "a column for each student, with the name as title")
    return places


def _pointed(texts: Sequence[str]) -> list[Cell]:
    """Return the cells of a column with points for its decimal commas.

    A comma before other than three digits is decimal, and then so are all commas of the column.
    """
    numbers = [number for text in texts for number in columns.MARKED.findall(text)]
    has_commas = any(map(_is_decimal, numbers))
    return [_cell(text, has_commas) for text in texts]


def _cell(typed: str, has_commas: bool) -> Cell:
    text = typed
    for number in columns.MARKED.findall(typed):
        if has_commas and columns.POINTED_THOUSANDS.fullmatch(number):
            return Cell(typed, text, f"'{quote(number)}' is ambiguous: a thousand or a decimal")
        if has_commas and columns.COMMA.fullmatch(number):
            text = text.replace(number, number.replace(",", "."))
    return Cell(typed, text)


def _is_decimal(number: str) -> bool:
    return bool(columns.COMMA.fullmatch(number)) and not columns.THOUSANDS.fullmatch(number)
