"""Tables of numbers in text: their heads, their columns, decimal commas, units in titles."""

import re
from collections.abc import Callable, Iterable, Sequence
from itertools import chain, pairwise

from radcalc.errors import Hint, RadcalcError, quote
from radcalc.files import refusal
from radcalc.units.table import unit_of

DELIMITERS = ("\t", ";", "|", ",")
COMMENTS = ("#", "%", "//", ";;")
COMMA = re.compile(r"[-+]?\d*,\d+(?:[eE][-+]?\d+)?")
# A number with a point or a comma; one that begins within another is not searched for.
MARKED = re.compile(r"(?<![\d.,])[\d.,]*[.,]\d+(?:[eE][-+]?\d+)?")
THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2},\d{3}")
POINTED_THOUSANDS = re.compile(r"[-+]?[1-9]\d{0,2}\.\d{3}")
MARKS = "points or commas in all numbers, and no separators of thousands"
UNIT_TITLES = ("unit", "units", "uom", "einheit", "unité", "jednotka", "единица", "единицы")
IN_BRACKETS = re.compile(r"\[([^\[\]]*)\]|\(((?:[^()]|\([^()]*\))*)\)")  # W/(m2 nm) has its own


def dialect(line: str) -> tuple[str | None, bool]:
    """Return the delimiter of a line (None: blanks), and whether numbers have decimal commas."""
    for delimiter in DELIMITERS[:3]:
        if delimiter in line:
            return delimiter, "," in line
    if "," in line:
        parts = line.split()
        if len(parts) > 1 and all(is_number(part, True) and part[-1] != "," for part in parts):
            return None, True
        return ",", False
    return None, False


def cells(line: str, delimiter: str | None) -> list[str]:
    """Return the cells of a line, without blanks and quotes around them."""
    if delimiter and '"' in line:
        import csv

        try:
            parts = next(csv.reader([line], delimiter=delimiter))
        except csv.Error:  # a cell of more than 128 KiB
            parts = line.split(delimiter)
    else:
        parts = line.split(delimiter)
    return [cell.strip().strip('"').strip() for cell in parts]


def cells_alone(line: str, delimiter: str | None = None) -> list[str]:
    """Return the cells of a line of which no more is known: by its own delimiter, if none is given.

    Those of a table are cut by the delimiter of the table.
    """
    return cells(line, delimiter or dialect(line)[0])


def is_comment(line: str) -> bool:
    """Return whether a line is a comment."""
    return line.lstrip().startswith(COMMENTS)


def is_remark(line: str) -> bool:
    """Return whether a line is blank or a comment."""
    return not line or line.isspace() or is_comment(line)


def comment_text(line: str) -> str:
    """Return the text of a comment."""
    return line.lstrip("#%/; \t")


def has_odd_digits(text: str) -> bool:
    """Return whether a text has digits that only float() accepts: 5_50, other scripts."""
    return not text.isascii() or "_" in text


def finite_numbers(texts: Sequence[str]) -> list[float]:
    """Convert texts to finite numbers; raise ValueError for any other text."""
    values = list(map(float, texts))
    total = sum(values)
    if total - total or has_odd_digits("".join(texts)):
        raise ValueError
    return values


def is_number(cell: str, comma: bool = True) -> bool:
    """Return whether a cell is a number, with a decimal comma or not, NaN and infinity included."""
    if has_odd_digits(cell):
        return False
    try:
        float(cell.replace(",", ".") if comma else cell)
    except ValueError:
        return False
    return True


def finite(cell: str, comma: bool) -> float | None:
    """Return the finite number in a cell, or None."""
    if not is_number(cell, comma):
        return None
    value = float(cell.replace(",", ".") if comma else cell)
    return value if value - value == 0 else None


def numbers_at_once(cells: Sequence[str]) -> list[float] | None:
    """Return the numbers of cells; None if they must be read one by one."""
    try:
        return finite_numbers(cells)
    except ValueError:
        return None


class Decimals:
    """The decimal mark of the numbers of a file, point or comma; 1,000 may be a thousand.

    1.000 may be one, too, if others of its column are whole and none has other decimals.
    """

    def __init__(self) -> None:
        self.point = self.comma = 0  # first lines with the mark
        self.is_sure = self.has_whole = False  # in the column of the values
        self.thousand: tuple[int, str] | tuple[()] = ()  # first line with 1.000
        # Line and text of the first ambiguous number.
        self.doubtful: tuple[int, str] | tuple[()] = ()

    def conflict(self, text: str, line: int) -> str:
        """Record a number; return the problem if earlier numbers have the other mark."""
        if "." in text:
            self.point = self.point or line
        elif THOUSANDS.fullmatch(text):
            self.doubtful = self.doubtful or (line, text)
        elif COMMA.fullmatch(text):
            self.comma = self.comma or line
        comma = self.comma or (self.doubtful[0] if self.doubtful else 0)
        if not (self.point and comma):
            return ""
        mark, other_mark = ("point", "comma") if line == self.point else ("comma", "point")
        return f"a decimal {mark}, but line {min(self.point, comma)} has a decimal {other_mark}"

    def watch(self, texts: Iterable[str], line: int) -> None:
        """Record the values of a column in successive lines that commas do not separate."""
        for number, text in enumerate(texts, line):
            if self.is_sure:
                return
            if "." not in text and "," not in text:
                self.has_whole = True
            elif POINTED_THOUSANDS.fullmatch(text):
                self.thousand = self.thousand or (number, text)
            else:
                self.is_sure = True

    def doubt(self) -> tuple[int, str, str] | tuple[()]:
        """Return the line of an ambiguous number, the problem and the hint, if any."""
        doubtful = () if self.comma else self.doubtful
        if not doubtful and self.has_whole and not self.is_sure:
            doubtful = self.thousand
        if not doubtful:
            return ()
        line, text = doubtful
        whole = re.sub(r"[.,]", "", text)
        hint = f"{whole} or {float(text.replace(',', '.'))} in every such number"
        return line, f"'{text}' is ambiguous: a thousand or a decimal", hint


def unit_column(titles: Sequence[str], place: int) -> int | None:
    """Return the column with the units of the values in another: after it, or else before."""
    found = [k for k, title in enumerate(titles) if plain(title) in UNIT_TITLES and k != place]
    return next((k for k in found if k > place), found[-1] if found else None)


def plain(title: str) -> str:
    """Return a title in lower case, with one kind of micro and of degrees."""
    return title.strip().lower().replace("µ", "u").replace("μ", "u").replace("º", "°")


def units_in(title: str) -> tuple[list[str], list[str]]:
    """Return candidates for a title's unit: texts in brackets, the last first; last words."""
    brackets = ["".join(filter(None, bracketed)) for bracketed in IN_BRACKETS.findall(title)][::-1]
    words = title.split()
    return brackets, [" ".join(words[start:]) for start in range(len(words))]


UNITS = " units"
RULE = " \t;,|-:+="  # characters of a line below the titles of a text, and of a blank row
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
        self.refuse, self.delimiter, self.width, self.titles = refuse, delimiter, width, titles
        self.names = names or titles
        self.preamble = preamble
        self.decimals = Decimals()

    @property
    def pairs(self) -> dict[str, str]:
        """The lines before the table of a key and a value, `Technique,Scope`, by plain key."""
        found: dict[str, str] = {}
        for _, line in self.preamble[:MOST_PAIRS]:
            key, *values = cells(line, dialect(line)[0] or ":")
            if key and values:
                found.setdefault(plain(key.rstrip(":-> ")), values[0])
        return found

    @property
    def units_above(self) -> dict[str, str]:
        """The units that a row before the table gives by the titles above it: GHI Units, w/m2."""
        rows = [cells_alone(line) for _, line in self.preamble[:MOST_PAIRS]]
        return {
            plain(key).removesuffix(UNITS): value
            for keys, values in pairwise(rows)
            for key, value in zip(keys, values, strict=False)
            if plain(key).endswith(UNITS) and len(keys) == len(values)
        }

    def cells(self, number: int, line: str) -> list[str]:
        """Return the cells of a row; raise for too few or many, without blank ones at its end."""
        parts = cells(line, self.delimiter)
        if len(parts) == self.width - 1 and self.titles and not self.titles[-1]:
            parts.append("")  # the delimiter at the end of other lines
        while len(parts) > self.width and not parts[-1]:
            parts.pop()
        if len(parts) != self.width:
            plural = "s" if len(parts) != 1 else ""
            problem = f"{len(parts)} column{plural} instead of {self.width}"
            raise self.refuse(number, problem, "a value in every column")
        return parts

    def number(self, cell: str, line: int, is_value: bool = True) -> float:
        """Return a number; raise for other texts, and for contradictory decimal marks.

        The values, unlike wavelengths and times, show what a point means.
        """
        value = finite(cell, True)  # between commas, one in a cell was in quotes
        if value is None:
            problem = f"'{quote(cell)}' is not a number" if cell else "a value is missing"
            raise self.refuse(line, problem, "a number in every row, or # before a comment")
        self.check_marks([cell], line, is_value)
        return value

    def check_marks(self, texts: Iterable[str], line: int, are_values: bool = True) -> None:
        """Raise for a number with another decimal mark than the numbers before."""
        for text in texts:
            if problem := self.decimals.conflict(text, line):
                raise self.refuse(line, problem, MARKS)
            if are_values and self.delimiter != ",":
                self.decimals.watch([text], line)

    def at_once(self, lines: Sequence[str]) -> list[list[str]]:
        """Return the columns of many rows; raise ValueError if a row has other cells."""
        delimiter, width = self.delimiter, self.width
        text = "\n".join(lines)
        if delimiter and '"' not in text:
            # the ends of the lines as separate cells: in a table they are a column
            parts = text.replace("\n", f"{delimiter}\n{delimiter}").split(delimiter)
            are_ends = parts[width :: width + 1].count("\n") == len(lines) - 1
            if not are_ends or len(parts) != len(lines) * (width + 1) - 1:
                raise ValueError
            return [parts[k :: width + 1] for k in range(width)]
        rows = [cells(line, delimiter) for line in lines]
        if {*map(len, rows)} != {width}:
            raise ValueError
        return [list(column) for column in zip(*rows, strict=True)]

    def pointed(self, texts: list[str], line: int, are_values: bool = True) -> list[str]:
        """Return numbers of successive rows with decimal points; raise ValueError if unusual."""
        joined = " ".join(texts)
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


SEARCHED = 1000  # lines searched for the data, without comments and blank lines
MOST_REMARKS = 10_000  # lines searched with comments and blank lines
# Rows of a logger below the titles (TOA5 of Campbell): how a column was sampled, and its units.
SAMPLED = ("smp", "avg", "tmn", "tmx", "max", "min", "tot", "std", "med", "mean", "sum", "ts", "rn")
WITH_POWERS = re.compile(r"[^\W\d][^\s\d]{0,20}(?:-[12]|⁻[¹²])\S{0,20}")  # Wm-2, umolm-2s-1
# A title between blanks: a word, perhaps with a unit in brackets or after a slash.
BRACKETS = r"(?:\[[^\[\]]*\]|\((?:[^()]|\([^()]*\))*\))"
WORD = rf"(?:[^ \t\[\]()]|{BRACKETS})+"
TITLE = re.compile(rf"{WORD}(?:[ \t]+{BRACKETS}|[ \t]+/[ \t]+{WORD})?(?![^ \t])|[^ \t]+")
TITLES = (
    "a title for each column; quotation marks around a text with a delimiter, and 1000 for 1,000"
)


def first_lines(blocks: Iterable[tuple[int, list[str]]]) -> list[NumberedLine]:
    """Return the lines that show the head of a table, and the rest of their block."""
    head: list[NumberedLine] = []
    count = 0
    for number, lines in blocks:
        head += enumerate(lines, number)
        count += sum(not is_remark(line) for line in lines)
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
        rows = [row for row in lines if not self.is_remark(row[1])][:SEARCHED]
        rows = rows[self.skipped(rows) :]
        named = self.named_row(rows, wanted) if any(wanted) else None
        start = 0 if named is None else named + 1
        first, self.has_texts = self._first(rows, range(start, len(rows)), named is not None)
        self.number, line = rows[first]
        self.delimiter = self._delimiter(rows[start - 1 if start else 0 : first], line)
        self.cells = cells(line, self.delimiter)
        while first > start and self.is_bad(*[row[1] for row in rows[max(first - 2, 0) : first]]):
            first -= 1
        self.begin = rows[first][0]
        above = [row for row in rows[named or 0 : first] if any(map(str.isalnum, row[1]))]
        self.title_line, names, titles = self._titles(above, named is not None)
        self.preamble = [row for row in rows[:first] if row[0] < (self.title_line or self.begin)]
        self.comments = [
            comment_text(line) for number, line in lines if number < self.begin and is_comment(line)
        ]
        width = len(names or _trimmed(self.cells))
        if not names:
            names = titles = self.in_comments(width)
        self.cells = self.cells[:width]
        self.table = Table(self.error, self.delimiter, width, titles, rows[:first], names)

    @property
    def below(self) -> list[NumberedLine]:
        """The rows from the first one on, among the lines that were read."""
        return [
            (number, line)
            for number, line in self.lines
            if number >= self.begin and not self.is_remark(line)
        ]

    @property
    def title_lines(self) -> int:
        """The number of lines up to the titles, with their units below them."""
        is_alone = self.table.names == self.table.titles
        return self.title_line if is_alone and self.title_line else self.begin - 1

    # What a subclass knows.

    def error(self, number: int, problem: str, hint: Hint) -> RadcalcError:
        """Return the error of a line (0: none)."""
        raise NotImplementedError

    def is_data(self, cells: Sequence[str], is_named: bool) -> bool:
        """Return whether the cells of a line are data, below titles with the names or without."""
        raise NotImplementedError

    def is_remark(self, line: str) -> bool:
        """Return whether a line is blank or a comment, and so not a row."""
        return is_remark(line)

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
        """Return the titles in the last comment with that many columns, if any."""
        for comment in reversed(self.comments):
            titles = cells_alone(comment, self.typed)
            if len(titles) == width and not is_number(titles[0], False):
                return titles
        return []

    def no_data(self, rows: Sequence[NumberedLine]) -> RadcalcError:
        problem = f"no row of data in the first {SEARCHED} lines"
        return self.error(0, problem if rows else "the data are missing", "rows of numbers")

    def unlike(self, number: int, line: str) -> RadcalcError:
        problem = f"{len(self.cells_of(line))} titles for {len(_trimmed(self.cells))} columns"
        return self.error(number, problem, TITLES)

    def is_row(self, line: str, is_named: bool) -> bool:
        return self.is_data(cells_alone(line, self.typed), is_named)

    def _first(
        self, rows: Sequence[NumberedLine], places: Sequence[int], is_named: bool
    ) -> tuple[int, bool]:
        """Return the first row, and whether it has texts without titles: if there is no other."""
        sure = (k for k in places if dialect(rows[k][1])[0] or is_number(rows[k][1]))
        for among, by_name in ((places, is_named), (sure, True)):
            if (first := next((k for k in among if self.is_row(rows[k][1], by_name)), -1)) >= 0:
                return first, among is sure
        raise self.no_data(rows)

    def _delimiter(self, above: Sequence[NumberedLine], line: str) -> str | None:
        """Return the delimiter of the table: that of its titles, if they have as many cells."""
        own = dialect(line)[0]
        for _, title in above[-1:]:
            other = dialect(title)[0]
            if other and len(cells(title, other)) == len(cells(line, other)) > 1:
                own = other
        return self.typed or own

    def cells_of(self, line: str) -> list[str]:
        return cells(line, self.delimiter)

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
        if is_named and count and not self._of_width(rows[0][1]):
            raise self.unlike(*rows[0])
        for k, (_, above) in enumerate(rows[:count]):
            cells = self._of_width(above)
            is_full = 2 * sum(map(bool, cells)) >= len(cells)  # unlike `Serial Number: 7,,,`
            if cells and (is_named or (is_full and self.are_titles(cells))):
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


class NamedHead(Head):
    """The head of a table that has columns of certain names; its cells may be texts."""

    def __init__(
        self,
        name: str,
        lines: Sequence[NumberedLine],
        is_known: Callable[[str], object],
        what: str,
        hint: str,
        mark: str = "",
    ) -> None:
        """Take the test of a name, what a row is, a hint, and the mark of comments."""
        self.name, self.is_known, self.what, self.hint = name, is_known, what, hint
        self.mark = mark
        super().__init__(lines, wanted=(what,))

    def error(self, number: int, problem: str, hint: Hint) -> RadcalcError:
        return refusal(self.name, number, problem, str(hint))

    def is_remark(self, line: str) -> bool:
        """Return whether a line has no text, or is a comment: others may begin with blank cells."""
        return not line.strip(RULE) or bool(self.mark and line.lstrip().startswith(self.mark))

    def named_row(self, rows: Sequence[NumberedLine], wanted: Sequence[str]) -> int | None:
        """Return the first row with the most known names, at the delimiter that gives them.

        Rows of numbers above it are not skipped: then it is the first.
        """
        best, found = (0, 0), 0
        for place, (_, line) in enumerate(rows):
            for mark in DELIMITERS:
                titles = cells(line, mark)
                size = len([*filter(self.is_known, titles)]), len(titles)
                if size > best:
                    best, found, self.typed = size, place, mark
        above = [cells(line, self.typed)[1:] for _, line in rows[:found]]
        return 0 if any(map(is_number, chain.from_iterable(above))) else found

    def is_data(self, cells: Sequence[str], is_named: bool) -> bool:
        """Return whether cells are not only units."""
        return any(cell and (is_number(cell) or unit_of(cell) is None) for cell in cells)

    def are_names(self, cells: Sequence[str]) -> bool:
        return True

    def no_data(self, rows: Sequence[NumberedLine]) -> RadcalcError:
        problem = f"a header but no {self.what}" if rows else f"no {self.what}"
        return self.error(0, f"the file has {problem}", self.hint)

    def _of_width(self, line: str) -> list[str]:
        return self.cells_of(line)


def _trimmed(cells: Sequence[str]) -> list[str]:
    """Return cells without blank ones at the end, but at least two."""
    trimmed = [*cells]
    while len(trimmed) > 2 and not trimmed[-1]:
        trimmed.pop()
    return trimmed


def _is_below(cells: Sequence[str]) -> bool:
    """Return whether a row has the units of the titles above it, or how they were sampled."""
    texts = [cell.strip("()[] ") for cell in cells if cell]
    bracketed = [cell[0] in "([" for cell in cells if cell]
    sampled = [text.lower() in SAMPLED for text in texts]
    if all(map(max, sampled, bracketed)):
        return True
    return not any(map(is_number, texts)) and any(
        unit_of(text) is not None or WITH_POWERS.fullmatch(text) for text in texts
    )


def _bracketed(text: str) -> str:
    """Return a text in brackets, as a unit is in a title."""
    return text if text[0] in "([" else f"[{text}]"
