"""Fields of a line, as bytes: the selected ones, and their places."""

import re
from collections.abc import Callable, Iterator
from functools import cache
from itertools import chain

from radcalc import errors
from radcalc.errors import option, quote

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from radcalc.streams.readers import Texts

BLANKS = b" \t"
NAMED = {"tab": "\t", "\\t": "\t", "comma": ",", "semicolon": ";", "space": " "}
MOST = 1_000_000  # the greatest number of a field
FIELDS = "N, N-, N-M, -M or several of them with commas between"

Span = tuple[int, int]  # start and end of a text
Convert = Callable[[list[bytes]], list[bytes] | None]  # converts many texts; None if any is unusual


class Fields:
    """A list of fields as in `cut` and `numfmt`: `2`, `1,3`, `2-4`, `3-`, `-2`."""

    def __init__(self, text: str = "1") -> None:
        self.ranges = sorted(
            _range(text, part) for part in text.replace(errors.MINUS, "-").split(",")
        )
        self.last = max(last or first for first, last in self.ranges)

    @property
    def is_one(self) -> bool:
        return self.ranges == [(self.last, self.last)]

    def of(self, count: int) -> Iterator[int]:
        if count < self.last:
            problem = f"field {self.last} is missing"
            raise errors.NumberError(problem, f"a line of {self.last} fields")
        chosen, done = [], 0
        for first, last in self.ranges:
            end = last or count
            chosen.append(range(max(first - 1, done), end))
            done = max(done, end)
        return chain.from_iterable(chosen)


def _range(text: str, part: str) -> tuple[int, int]:
    """Return the first and last field of a part of a list; 0 for the last of a line."""
    option_text = option("field", quote(text))
    first, dash, last = part.strip().partition("-")
    numbers = [first or "1", last or "0"] if dash else [first, first]
    if not all(number.isascii() and number.isdigit() for number in numbers):
        numbers = [number for number in text.split(",") if number.strip()]
        is_list = all(number.strip("0123456789-") == "" for number in numbers)
        as_title = errors.Try((("column", text),), ("field",))
        fix = errors.add("field", ",".join(numbers)) if is_list and numbers else as_title
        raise errors.UsageError(f"{option_text} is not a list of fields", FIELDS, [fix])
    low, high = (int(number[:9]) for number in numbers)
    if low == 0 or last == "0" or max(low, high) > MOST:
        problem = f"{option_text} is out of range"
        raise errors.UsageError(problem, f"fields are numbered from 1 to {MOST}")
    if high and high < low:
        rising = text.replace(part.strip(), f"{high}-{low}")
        problem = f"{option_text} has a decreasing range"
        raise errors.UsageError(problem, errors.add("field", rising))
    return low, high


def read_delimiter(text: str) -> str:
    """Read one character, or the name of one that is hard to type at a shell."""
    character = NAMED.get(text.lower(), text)
    if len(character) != 1 or character in '"\n\r\0':
        problem = f"{option('delimiter', quote(text))} is not one character"
        hint = "a character, such as , or ; or tab"
        raise errors.UsageError(problem, hint, _delimiters(text))
    return character


def _delimiters(text: str) -> "list[errors.Try]":
    """Propose the separator that a text of several characters has or names."""
    named = errors.nearest(text.lower(), [name for name in NAMED if name.isalpha()], 1)
    marks = [character for character in text if not character.isalnum() and character.isprintable()]
    meant = named or [mark for mark in dict.fromkeys(marks) if mark not in ('"', " ")]
    return [errors.add("delimiter", one) for one in meant[:1]] or [errors.leave_out("delimiter")]


class Cut:
    """The division of a line into fields: at a delimiter, or at blanks if it is empty.

    A field in double quotes, as in CSV, may contain the delimiter; with blanks there are no quotes.
    """

    def __init__(self, delimiter: bytes = b"") -> None:
        self.delimiter = delimiter
        self.blanks = bytes(c for c in BLANKS if c not in delimiter)
        mark = re.escape(delimiter)
        bare = b"[^" + mark + b"]*" if len(delimiter) == 1 else b"(?:(?!" + mark + b").)*"
        quoted = rb'"[^"]*(?:""[^"]*)*"(?!")'
        self.pattern = re.compile(
            b"[" + self.blanks + b"]*" + quoted + bare + b"|" + bare, re.DOTALL
        )

    def spans(self, line: bytes) -> Iterator[Span]:
        """Yield the start and end of every field, with blanks and quotes."""
        if not self.delimiter:
            yield from (match.span() for match in re.finditer(rb"[^ \t]+", line))
            return
        start = 0
        quoted = b'"' in line
        while True:
            if quoted and (match := self.pattern.match(line, start)):
                end = match.end()
                self._check(line[start:end])
            else:
                end = line.find(self.delimiter, start)
                end = len(line) if end < 0 else end
            yield start, end
            if end == len(line):
                return
            start = end + len(self.delimiter)

    def _check(self, field: bytes) -> None:
        """Refuse an opening quote that is not closed at the end of the field, on the line."""
        field = field.strip(self.blanks)
        if field[:1] == b'"' and (len(field) < 2 or field[-1:] != b'"'):
            problem = "a quoted field does not end on its line"
            raise errors.NumberError(problem, "one line for each record")

    def inner(self, line: bytes, span: Span) -> Span:
        if not self.delimiter:
            return span
        start, end = _strip(line, span, self.blanks)
        if end - start > 1 and line[start] == line[end - 1] == ord('"'):
            start, end = _strip(line, (start + 1, end - 1), self.blanks)
        return start, end

    def joint(self, line: bytes) -> bytes:
        return self.delimiter or (b"\t" if b"\t" in line else b" ")

    def quoted(self, field: bytes) -> bytes:
        if self.delimiter and (self.delimiter in field or field[:1] == b'"'):
            return b'"' + field.replace(b'"', b'""') + b'"'
        return field

    def convert(
        self, block: bytes, fields: Fields, texts: "Texts", width: int = 0, adds: bool = False
    ) -> bytes | None:
        """Convert the fields of a block of lines, all lines at once.

        Every line has `width` fields, unless that is 0.  With `adds` the result is appended to the
        line, whose field stays.  Return None if lines differ in shape: then each is read alone.
        """
        converted = None
        mark = self.delimiter or _only_blank(block)
        if self.delimiter and b'"' in block:
            mark = b""
        if len(mark) == 1 and b"#" not in block:
            converted = self._table(block, mark, fields, texts, width, adds)
        return converted or self._matched(block, fields, texts.column, width, adds)

    @staticmethod
    def _table(
        block: bytes, mark: bytes, fields: Fields, texts: "Texts", expected: int, adds: bool
    ) -> bytes | None:
        """Convert column by column, if all lines have the same number of fields."""
        rows = block.count(b"\n")
        width = block.count(mark, 0, block.index(b"\n")) + 1
        is_regular = block.translate(None, _all_but(mark)) == (mark * (width - 1) + b"\n") * rows
        if not is_regular or width < fields.last or expected not in (0, width):
            return None
        # Two cells of two lines stay together, unless one of them is converted.
        places = [*fields.of(width)]
        is_inner = all(0 < index < width - 1 for index in places)
        step = width - 1 if is_inner else width
        end = b"\n" if is_inner else b"\n" + mark
        cells = block.replace(b"\n", end).split(mark)
        for index in places:
            place, is_last = slice(index, rows * step, step), index == width - 1
            old = [cell[:-1] for cell in cells[place]] if is_last else cells[place]
            if texts.form and fields.is_one and b"%" not in block:
                # the lines are the form of their results, which are written at once
                values = texts.values(old)
                if values is not None and adds:
                    return block.replace(b"\n", mark + texts.form + b"\n") % tuple(values)
                if values is not None:
                    cells[place] = [texts.form + b"\n" * is_last] * rows
                    return mark.join(cells).replace(end, b"\n") % tuple(values)
            column = texts.column(old)
            if column is None:
                return None
            if adds:
                lines = zip(block[:-1].split(b"\n"), column, strict=True)
                return b"\n".join(map(mark.join, lines)) + b"\n"
            cells[place] = [cell + b"\n" for cell in column] if is_last else column
        return mark.join(cells).replace(end, b"\n")

    def _matched(
        self, block: bytes, fields: Fields, convert: Convert, width: int, adds: bool
    ) -> bytes | None:
        """Convert one field of lines with blanks or quotes around their fields."""
        if not fields.is_one or len(self.delimiter) > 1 or 0 < width < fields.last:
            return None
        # alternately the text between matches, the text before the field, and the field
        parts = re.split(self._line(fields.last - 1, width), block)
        if len(parts) != 3 * block.count(b"\n") + 1:
            return None
        column = convert(parts[2::3])
        if column is None:
            return None
        if adds:
            lines = zip(parts[1::3], parts[3::3], column, strict=True)
            parts[3::3] = [
                rest[:-1] + self.joint(before + rest) + new + b"\n" for before, rest, new in lines
            ]
        else:
            parts[2::3] = column
        return b"".join(parts)

    def _line(self, before: int, width: int) -> re.Pattern[bytes]:
        """Return the pattern of a line with so many fields before the selected one.

        Its groups are the text before the field, and the field, which has no blanks.  Quoted fields
        have no quotes in them, and the rest of the line is well formed.
        """
        count = f"{{{width - before - 1}}}" if width else "*"
        if not self.delimiter:
            text = rf"^([ \t]*+(?!#)(?:[^ \t\n]++[ \t]++){{{before}}})([^ \t\n]++)"
            text += rf"(?=(?:[ \t]++[^ \t\n]++){count}[ \t]*+$)" if width else ""
            return re.compile(text.encode(), re.MULTILINE)
        mark = re.escape(self.delimiter).decode("latin-1")
        blanks = f"[{self.blanks.decode()}]*"
        cell = rf'(?:{blanks}"[^"\n]*"{blanks}|[^"\n{mark}]*)'
        line_end = rf"{blanks}(?:{mark}{cell}){count}$"
        field = rf'[^" \t\n{mark}]+'
        opened = rf'"{blanks}(?={field}{blanks}"{line_end})|(?={field}{line_end})'
        text = rf"^(?![ \t]*#)((?:{cell}{mark}){{{before}}}{blanks}(?:{opened}))({field})"
        return re.compile(text.encode("latin-1"), re.MULTILINE)


@cache
def _all_but(mark: bytes) -> bytes:
    """Return the bytes of lines besides a mark of one byte and the ends of the lines."""
    return bytes(set(range(256)) - {*mark, *b"\n"})


def _only_blank(block: bytes) -> bytes:
    """Return the one blank or tab that separates all fields of a block, or empty bytes."""
    mark = b"\t" if b"\t" in block else b" "
    if mark == b"\t" and b" " in block:
        return b""
    ends = mark + mark, mark + b"\n", b"\n" + mark
    return b"" if block.startswith(mark) or any(other in block for other in ends) else mark


def _strip(line: bytes, span: Span, blanks: bytes) -> Span:
    start, end = span
    text = line[start:end]
    start += len(text) - len(text.lstrip(blanks))
    return start, start + len(text.strip(blanks))
