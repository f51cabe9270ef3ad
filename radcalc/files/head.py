"""The head of a table in a text: its delimiter, its titles with their units, its first row."""

import re
from collections.abc import Iterable, Sequence

from radcalc.errors import Hint, RadcalcError, quote
from radcalc.files import columns
from radcalc.files.table import NumberedLine, Table
from radcalc.units.table import unit_of

SEARCHED = 1000  # lines searched for the data, without comments and blank lines
MOST_REMARKS = 10_000  # lines searched with comments and blank lines
# Rows of a logger below the titles (TOA5 of Campbell): how a column was sampled, and its units.
SAMPLED = frozenset(
    ["smp", "avg", "max", "min", "tot", "std", "med", "mean", "sum", "count", "ts", "rn"]
)
TITLE = re.compile(r"[^\s(\[]+(?:\s*[(\[][^)\]]*[)\]])?")  # with its unit in brackets
TITLES = (
    "a title for each column; quotation marks around a text with a delimiter, and 1000 for 1,000"
)


def first_lines(blocks: Iterable[tuple[int, list[str]]]) -> list[NumberedLine]:
    """Return the lines that show the head of a table, and the rest of their block."""
    head: list[NumberedLine] = []
    count = 0
    for number, lines in blocks:
        head += enumerate(lines, number)
        count += sum(not columns.is_remark(line) for line in lines)
        if count >= SEARCHED or len(head) >= MOST_REMARKS:
            break
    return head


class Head:
    """The head of a table, found from its first lines; a subclass knows what its data are.

    The delimiter is decided once, by the titles where there are some.  `begin` is the line of the
    first row, which may be a bad one, and `cells` are those of the first good one.
    """

    def __init__(
        self, lines: Sequence[NumberedLine], delimiter: str = "", wanted: Sequence[str] = ()
    ) -> None:
        """Read the first lines; `wanted` are names of columns, which the titles must have."""
        self.typed, self.lines = delimiter, lines
        self.assumptions: list[str] = []
        rows = [row for row in lines if not columns.is_remark(row[1])][:SEARCHED]
        rows = rows[self.skipped(rows) :]
        named = self.named_row(rows, wanted) if any(wanted) else None
        start = 0 if named is None else named + 1
        first = next(
            (k for k in range(start, len(rows)) if self.is_row(rows[k][1], named is not None)), None
        )
        if first is None:
            raise self.no_data(rows)
        self.number, line = rows[first]
        self.delimiter = self._delimiter(rows[start - 1 if start else 0 : first], line)
        self.cells = columns.cells(line, self.delimiter)
        while first > start and self.is_bad(*[row[1] for row in rows[max(first - 2, 0) : first]]):
            first -= 1
        self.begin = rows[first][0]
        above = [row for row in rows[named or 0 : first] if any(map(str.isalnum, row[1]))]
        self.title_line, names, titles = self._titles(above, named is not None)
        self.preamble = [row for row in rows[:first] if row[0] < (self.title_line or self.begin)]
        self.comments = [
            columns.comment_text(line)
            for number, line in lines
            if number < self.begin and columns.is_comment(line)
        ]
        width = len(names or _trimmed(self.cells))
        if not names:
            names = titles = self.in_comments(width)
        self.cells = self.cells[:width]
        self.table = Table(self.error, self.delimiter, width, titles, rows[:first], names)

    # What a subclass knows.

    def error(self, number: int, problem: str, hint: Hint) -> RadcalcError:
        """Return the error of a line (0: none)."""
        raise NotImplementedError

    def is_data(self, cells: Sequence[str], is_named: bool) -> bool:
        """Return whether the cells of a line are data, below titles with the names or without."""
        raise NotImplementedError

    def is_start(self, cell: str) -> bool:
        """Return whether a cell can only be in a row of data, as the date of a log."""
        return False

    def skipped(self, rows: Sequence[NumberedLine]) -> int:
        """Return the number of rows above the table that is read."""
        return 0

    def named_row(self, rows: Sequence[NumberedLine], wanted: Sequence[str]) -> int | None:
        """Return the place of the row of titles with all names, None if there are none."""
        return None

    def are_names(self, cells: Sequence[str]) -> bool:
        """Return whether the cells of a line may be titles: by default, not with a number."""
        return not any(map(is_number, cells))

    def are_titles(self, cells: Sequence[str]) -> bool:
        """Return whether the cells of a line must be titles, also with another number of them."""
        return False

    def check_text(self, number: int, line: str) -> None:
        """Raise for the line above the first row if it should have titles; it has none."""
        cells = self.cells_of(line) if self.delimiter else []
        is_text = not any(is_number(cell) or self.is_start(cell) for cell in cells)
        if len(cells) > 1 and is_text and self.are_titles(cells):
            raise self.unlike(number, line)

    def in_comments(self, width: int) -> list[str]:
        """Return the titles in a comment, if any."""
        return columns.titles_in_comments(self.comments, width, self.typed)

    def no_data(self, rows: Sequence[NumberedLine]) -> RadcalcError:
        problem = f"no row of data in the first {SEARCHED} lines"
        return self.error(0, problem if rows else "the data are missing", "rows of numbers")

    def unlike(self, number: int, line: str) -> RadcalcError:
        problem = f"{len(self.cells_of(line))} titles for {len(_trimmed(self.cells))} columns"
        return self.error(number, problem, TITLES)

    def is_row(self, line: str, is_named: bool) -> bool:
        return self.is_data(columns.cells(line, self.typed or columns.dialect(line)[0]), is_named)

    def _delimiter(self, above: Sequence[NumberedLine], line: str) -> str | None:
        """Return the delimiter of the table: that of its titles, if they have as many cells."""
        own = columns.dialect(line)[0]
        for _, title in above[-1:]:
            other = columns.dialect(title)[0]
            if other and len(columns.cells(title, other)) == len(columns.cells(line, other)) > 1:
                own = other
        return self.typed or own

    def cells_of(self, line: str) -> list[str]:
        return columns.cells(line, self.delimiter)

    def is_bad(self, *lines: str) -> bool:
        """Return whether the last of two lines above the first good row is data, too."""
        cells = self.cells_of(lines[-1])
        pairs = zip(cells, self.cells, strict=False)
        if any(self.is_start(cell) and self.is_start(other) for cell, other in pairs):
            return True
        return len(cells) == len(self.cells) and any(map(is_number, cells))

    def _titles(
        self, rows: Sequence[NumberedLine], is_named: bool
    ) -> tuple[int, list[str], list[str]]:
        """Return the line of the names of the columns, the names, and the titles with units.

        The units may be in a row below the names.
        """
        found: list[list[str]] = []  # the rows of titles, from below
        for _, line in reversed(rows):
            cells = self._of_width(line)
            if not cells or not self.are_names(cells) or cells[0].endswith(":"):
                break
            if found and (len(cells) != len(found[-1]) or not _is_below(found[-1])):
                break
            found.append(cells)
        count = len(rows) - len(found)
        if is_named and count:
            raise self.unlike(*rows[0])
        for k, (_, above) in enumerate(rows[:count]):
            if (cells := self._of_width(above)) and self.are_titles(cells):
                number, line = rows[min(k + 1, len(rows) - 1)]
                problem = f"'{quote(line.strip())}' is between the titles and the numbers"
                raise self.error(number, problem, "a row with a value in every column")
        if not found:
            if rows:
                self.check_text(*rows[-1])
            return 0, [], []
        *below, names = found
        units = [[row[k] for row in reversed(below) if row[k]] for k in range(len(names))]
        titles = [
            " ".join(filter(None, [name, *map(_bracketed, texts)]))
            for name, texts in zip(names, units, strict=True)
        ]
        return rows[len(rows) - len(found)][0], names, titles

    def _of_width(self, line: str) -> list[str]:
        """Return the titles of the columns in a line, which may lack blank ones at the end."""
        least, most = len(_trimmed(self.cells)), len(self.cells)
        return next(filter(None, (self.titles_in(line, k) for k in range(most, least - 1, -1))), [])

    def titles_in(self, line: str, width: int) -> list[str]:
        """Return so many titles in a line, of several words if blanks divide them; else []."""
        cells = self.cells_of(line)
        splits = [cells if any(cells[width:]) else cells[:width]]
        if not self.delimiter:
            splits += [re.split(r"\s{2,}|\t", line.strip()), TITLE.findall(line)]
        return next((one for one in splits if len(one) == width), [])


def _trimmed(cells: Sequence[str]) -> list[str]:
    """Return cells without blank ones at the end, but at least two."""
    trimmed = [*cells]
    while len(trimmed) > 2 and not trimmed[-1]:
        trimmed.pop()
    return trimmed


def is_number(cell: str) -> bool:
    """Return whether a cell is a number, also one with a decimal comma."""
    return columns.is_number(cell, comma=True)


def _is_below(cells: Sequence[str]) -> bool:
    """Return whether a row has the units of the titles above it, or how they were sampled."""
    units = {cell: unit_of(cell.strip("()[] ")) for cell in cells if cell}
    others = [cell for cell, unit in units.items() if not unit and cell.lower() not in SAMPLED]
    has_quotient = any(unit and "/" in cell for cell, unit in units.items())
    return has_quotient or all(cell[0] in "([" for cell in others)


def _bracketed(text: str) -> str:
    """Return a text in brackets, as a unit is in a title."""
    return text if text[0] in "([" else f"[{text}]"
