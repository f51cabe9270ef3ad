"""Columns of numbers in text: separators, decimal commas, and units in titles."""

import re
from collections.abc import Iterable, Sequence

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


def is_comment(line: str) -> bool:
    """Return whether a line is a comment."""
    return line.lstrip().startswith(COMMENTS)


def is_remark(line: str) -> bool:
    """Return whether a line is blank or a comment."""
    return not line or line.isspace() or is_comment(line)


def comment_text(line: str) -> str:
    """Return the text of a comment."""
    return line.lstrip("#%/; \t")


def titles_in_comments(
    comments: Sequence[str], width: int, delimiter: str | None = None
) -> list[str]:
    """Return the titles in the last comment with that many columns, if any."""
    for comment in reversed(comments):
        titles = cells(comment, delimiter or dialect(comment)[0])
        if len(titles) == width and not is_number(titles[0], False):
            return titles
    return []


def has_odd_digits(text: str) -> bool:
    """Return whether a text has digits that only float() accepts: 5_50, other scripts."""
    return not text.isascii() or "_" in text


def finite_numbers(texts: Sequence[str]) -> list[float]:
    """Convert texts to finite numbers; raise ValueError for any other text."""
    values = list(map(float, texts))
    total = sum(values)
    if total - total:
        raise ValueError
    return values


def is_number(cell: str, comma: bool) -> bool:
    """Return whether a cell is a number, including NaN and infinity."""
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


def numbers_at_once(text: str, cells: Sequence[str]) -> list[float] | None:
    """Return the numbers of a text's cells; None if they must be read one by one."""
    if has_odd_digits(text):
        return None
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
        self.doubtful: (
            tuple[int, str] | tuple[()]
        ) = ()  # line and text of the first ambiguous number

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
