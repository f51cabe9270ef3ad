"""The head of a table in a text: its delimiter, its titles with their units, its first row."""

from collections.abc import Iterable, Sequence

from radcalc.errors import Hint, RadcalcError
from radcalc.files import columns
from radcalc.files.table import NumberedLine, Table
from radcalc.units.table import unit_of

SEARCHED = 1000  # lines searched for the data, without comments and blank lines
MOST_REMARKS = 10_000  # lines searched with comments and blank lines
# Rows of a logger below the titles (TOA5 of Campbell): how a column was sampled, and its units.
SAMPLED = frozenset(
    ["smp", "avg", "max", "min", "tot", "std", "med", "mean", "sum", "count", "ts", "rn"]
)
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
            raise self.no_data(bool(rows))
        number, line = rows[first]
        self.delimiter = self._delimiter(rows[start - 1 if start else 0 : first], line)
        self.number, self.cells = number, columns.cells(line, self.delimiter)
        while first > start and self._is_bad(rows[first - 1][1]):
            first -= 1
        self.begin = rows[first][0]
        above = [row for row in rows[named or 0 : first] if any(self._cells(row[1]))]
        names, titles = self._titles(above, named is not None)
        self.comments = [
            columns.comment_text(line)
            for number, line in lines
            if number < self.begin and columns.is_comment(line)
        ]
        if not names:
            width = len(self.cells)
            names = titles = columns.titles_in_comments(self.comments, width, delimiter)
        self.cells = self.cells[: len(names)] if names else self.cells
        self.table = Table(self.error, self.delimiter, len(self.cells), titles, rows[:first], names)

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

    def are_titles(self, cells: Sequence[str]) -> bool:
        """Return whether the cells of a line with another number of them must be titles."""
        return False

    def no_data(self, has_rows: bool) -> RadcalcError:
        problem = f"no row of data in the first {SEARCHED} lines"
        return self.error(0, problem if has_rows else "the data are missing", "rows of numbers")

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

    def _cells(self, line: str) -> list[str]:
        return columns.cells(line, self.delimiter)

    def _is_bad(self, line: str) -> bool:
        """Return whether a line above the first good row has data, too: a date or a number."""
        cells = self._cells(line)
        pairs = zip(cells, self.cells, strict=False)
        if any(self.is_start(cell) and self.is_start(other) for cell, other in pairs):
            return True
        return len(cells) == len(self.cells) and any(map(is_number, cells))

    def _titles(self, rows: Sequence[NumberedLine], is_named: bool) -> tuple[list[str], list[str]]:
        """Return the names of the columns, and their titles with the units of rows below them."""
        found: list[list[str]] = []  # the rows of titles, from below
        for _, line in reversed(rows):
            cells = self._of_width(line)
            is_setting = bool(cells) and cells[0].endswith(":")  # Binning mode:,Sum,Average
            if not cells or is_setting or any(map(is_number, cells)):
                break
            if found and not _is_below(found[-1]):
                break
            found.append(cells)
        if (is_named and len(found) < len(rows)) or (
            rows and not found and self._refuses(rows[-1])
        ):
            number, line = rows[0] if is_named else rows[-1]
            problem = f"{len(self._cells(line))} titles for {len(self.cells)} columns"
            raise self.error(number, problem, TITLES)
        while len(found) > 1 and not any(found[-1]):
            found.pop()
        if not found:
            return [], []
        *below, names = found
        units = [[row[k] for row in reversed(below) if row[k]] for k in range(len(names))]
        return names, [
            " ".join([name, *[_bracketed(text) for text in texts]])
            for name, texts in zip(names, units, strict=True)
        ]

    def _of_width(self, line: str) -> list[str]:
        """Return the cells of a line that has one for each column but blank ones at the end."""
        cells, width = self._cells(line), len(self.cells)
        is_whole = len(cells) == width or (cells and not any(self.cells[len(cells) :]))
        return cells if is_whole and len(cells) <= width else []

    def _refuses(self, row: NumberedLine) -> bool:
        cells = self._cells(row[1]) if self.delimiter else []
        is_text = not any(is_number(cell) or self.is_start(cell) for cell in cells)
        return len(cells) > 1 and is_text and self.are_titles(cells)


def is_number(cell: str) -> bool:
    """Return whether a cell is a number, also one with a decimal comma."""
    return columns.is_number(cell, comma=True)


def _is_below(cells: Sequence[str]) -> bool:
    """Return whether a row has the units of the titles above it, or how they were sampled."""
    texts = [cell.strip("()[] ") for cell in cells if cell]
    known = [text.lower() in SAMPLED or unit_of(text) is not None for text in texts]
    bracketed = [cell[:1] in "([" for cell in cells if cell]
    quotients = [unit_of(text) is not None and "/" in text for text in texts]
    return all(known) or all(bracketed) or any(quotients)


def _bracketed(text: str) -> str:
    """Return a text in brackets, as a unit is in a title."""
    return text if text[0] in "([" else f"[{text}]"
