"""A table in a text: the lines before it, its columns with their titles, and its rows."""

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise

from radcalc.errors import RadcalcError, quote
from radcalc.files import columns

UNITS = " units"
MOST_PAIRS = 1000  # lines before a table that are searched for pairs

Refuse = Callable[[int, str, str], RadcalcError]  # the error of a line, a problem and a hint
NumberedLine = tuple[int, str]


class Table:
    """A table of one delimiter and width, read row by row or many rows at once.

    `titles` are those of the columns, with their units, and `names` are without the units of a row
    below them; `preamble` are the lines before the table.
    The values of a table may not fit into memory: they are returned, not kept.
    """

    def __init__(
        self,
        refuse: Refuse,
        delimiter: str | None,
        width: int,
        titles: Sequence[str] = (),
        preamble: Sequence[NumberedLine] = (),
        names: Sequence[str] = (),
    ) -> None:
        self.refuse = refuse
        self.delimiter = delimiter
        self.width = width
        self.titles = titles
        self.names = names or titles
        self.preamble = preamble
        self.decimals = columns.Decimals()

    @property
    def pairs(self) -> dict[str, str]:
        """The lines before the table of a key and a value, `Technique,Scope`, by plain key."""
        found: dict[str, str] = {}
        for _, line in self.preamble[:MOST_PAIRS]:
            cells = columns.cells(line, columns.dialect(line)[0] or ":")
            if len(cells) > 1 and cells[0]:
                found.setdefault(columns.plain(cells[0].rstrip(":-> ")), cells[1])
        return found

    @property
    def units_above(self) -> dict[str, str]:
        """The units that a row before the table gives by the titles above it: GHI Units, w/m2."""
        rows = [
            columns.cells(line, columns.dialect(line)[0]) for _, line in self.preamble[:MOST_PAIRS]
        ]
        return {
            columns.plain(key).removesuffix(UNITS): value
            for keys, values in pairwise(rows)
            for key, value in zip(keys, values, strict=False)
            if columns.plain(key).endswith(UNITS) and len(keys) == len(values)
        }

    def cells(self, number: int, line: str) -> list[str]:
        """Return the cells of a row; raise for too few or many, without blank ones at its end."""
        cells = columns.cells(line, self.delimiter)
        if len(cells) == self.width - 1 and self.titles and not self.titles[-1]:
            cells.append("")  # the delimiter at the end of other lines
        while len(cells) > self.width and not cells[-1]:
            cells.pop()
        if len(cells) != self.width:
            plural = "s" if len(cells) != 1 else ""
            problem = f"{len(cells)} column{plural} instead of {self.width}"
            raise self.refuse(number, problem, "a value in every column")
        return cells

    def number(self, cell: str, line: int, is_value: bool = True) -> float:
        """Return a number; raise for other texts, and for contradictory decimal marks.

        The values, unlike wavelengths and times, show what a point means.
        """
        value = columns.finite(cell, True)  # between commas, one in a cell was in quotes
        if value is None:
            problem = f"'{quote(cell)}' is not a number" if cell else "a value is missing"
            raise self.refuse(line, problem, "a number in every row, or # before a comment")
        self.check_marks([cell], line, is_value)
        return value

    def check_marks(self, texts: Iterable[str], line: int, are_values: bool = True) -> None:
        """Raise for a number with another decimal mark than the numbers before."""
        for text in texts:
            if problem := self.decimals.conflict(text, line):
                raise self.refuse(line, problem, columns.MARKS)
            if are_values and self.delimiter != ",":
                self.decimals.watch([text], line)

    def at_once(self, lines: Sequence[str]) -> list[list[str]]:
        """Return the columns of many rows; raise ValueError if a row has other cells."""
        delimiter, width = self.delimiter, self.width
        if not delimiter:
            rows = [line.split() for line in lines]
        else:
            text = "\n".join(lines)
            if '"' in text:
                rows = _unquoted(lines, delimiter)
            else:
                # the ends of the lines as separate cells: in a table they are a column
                cells = text.replace("\n", f"{delimiter}\n{delimiter}").split(delimiter)
                if cells[width :: width + 1].count("\n") != len(lines) - 1:
                    raise ValueError
                if len(cells) != len(lines) * (width + 1) - 1:
                    raise ValueError
                return [cells[k :: width + 1] for k in range(width)]
        if {*map(len, rows)} != {width}:
            raise ValueError
        return [list(column) for column in zip(*rows, strict=True)]

    def pointed(self, texts: list[str], line: int, are_values: bool = True) -> list[str]:
        """Return numbers of successive rows with decimal points; raise ValueError if unusual."""
        joined = " ".join(texts)
        if columns.has_odd_digits(joined):
            raise ValueError
        marks, has_point = self.decimals, "." in joined
        if "," in joined:
            if has_point or not marks.comma:
                raise ValueError
            return joined.replace(",", ".").split(" ")
        if has_point:
            if marks.comma or marks.doubtful:
                raise ValueError
            if not marks.point:
                marks.point = next(k for k, text in enumerate(texts, line) if "." in text)
        if are_values and self.delimiter != ",":
            marks.watch(texts, line)
        return texts

    def finish(self) -> None:
        """Raise if a number of the table is ambiguous."""
        if doubt := self.decimals.doubt():
            raise self.refuse(*doubt)


def _unquoted(lines: Sequence[str], delimiter: str) -> list[list[str]]:
    """Return the cells of lines; raise ValueError if a quoted cell spans lines."""
    import csv

    try:
        rows = list(csv.reader(lines, delimiter=delimiter))
    except csv.Error:
        raise ValueError from None
    if len(rows) != len(lines):
        raise ValueError
    return rows
