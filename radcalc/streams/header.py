"""Header of a stream: the selected fields, their number, and their units.

The unit in the header is compared with the unit of the numbers, and replaced in the output.
"""

import re
from collections.abc import Callable, Collection, Sequence

from radcalc import errors
from radcalc.errors import option, quote
from radcalc.files import Text, columns
from radcalc.files.columns import NumberedLine, unit_column
from radcalc.quantities import column_titles, describe, name_of
from radcalc.quantities import read as read_light
from radcalc.quantities.column_titles import Title, find, is_same, read_title, unit_of_name
from radcalc.streams.fields import BLANKS, Cut, Fields, Span
from radcalc.streams.log_layout import FirstRows, LogSettings
from radcalc.streams.readers import UTF_8, Texts
from radcalc.units import Unit
from radcalc.units.numbers import parse_number
from radcalc.units.table import resolve

WHERE = "the header of stdin"
LONG = 1 << 16  # bytes of a header too long to search for units in brackets
TITLE = re.compile(columns.TITLE.pattern.encode())


class InputHead(FirstRows):
    """The head of a table on standard input, of which every line is written."""

    def skipped(self, rows: Sequence[NumberedLine]) -> int:
        return 0


def head_of(data: bytes, column: str, delimiter: str) -> tuple[str, int]:
    """Return the delimiter ("": blanks) and the lines of titles of a table with a named column.

    `data` are its first bytes; if they show no rows, the first line has the titles.
    """
    parts = [data]
    text = Text("stdin", lambda _: parts.pop() if parts else b"", "a value")
    lines = columns.first_lines(text.blocks())
    try:
        head = InputHead("stdin", lines, LogSettings(column=column, delimiter=delimiter))
    except errors.RadcalcError:
        first = lines[0][1] if lines else ""
        mark = delimiter or columns.dialect(first)[0] or ""
        cells = dict(enumerate(columns.cells(first, mark or None), 1))
        has_number = column.isdecimal() and columns.is_number(cells.get(int(column), ""))
        return mark, int(not has_number)
    return head.delimiter or "", head.title_lines


def title_spans(cut: Cut | None, line: bytes) -> list[Span]:
    """Return the spans of the titles in a line, without a # at its start."""
    start = len(line) - len(line.lstrip(BLANKS + b"#"))
    if not cut:
        return [(start, max(start, len(line.rstrip(BLANKS))))]
    if cut.delimiter or len(line) > LONG:
        return [cut.inner(line, (max(a, start), b)) for a, b in cut.spans(line)]
    return [match.span() for match in TITLE.finditer(line, start)]


class Header:
    """The titles in the last line of the header."""

    def __init__(
        self,
        cut: Cut | None,
        source: Unit | None,
        target: Unit | None,
        titled: Callable[[Unit], tuple[Texts, Unit]],
        note: Callable[[str], None],
        column: str = "",
        name: str | None = None,
        adds: bool = False,
        call: Callable[[str], str] | None = None,
        is_bare: bool = False,
        given: Collection[str] = (),
    ) -> None:
        """Take the source and the target, and the names of the inputs that link them."""
        self.cut, self.given, self.source = cut, given, source
        self.target = target or resolve("1")
        self.is_known = target is not None
        self.titled, self.note, self.column, self.name = titled, note, column, name
        self.adds = adds
        self.own = self._own() if target else None
        self.is_bare = is_bare
        self.call = call or (
            lambda unit: errors.command("convert", "-", unit, quote(self.target.text))
        )
        self.texts: Texts | None = None
        self.fields: Fields | None = None
        self.units: int | None = None  # the field with the unit of each line
        self.new_titles: dict[int | None, str] = {}

    def read(self, line: bytes, fields: Fields, above: bytes = b"") -> tuple[bytes, int]:
        """Return the line as written, and the number of fields (0: any number)."""
        if b"\0" in line:
            raise errors.UsageError(f"{WHERE} is not text in UTF-8", UTF_8)
        try:
            spans = title_spans(self.cut, line)
            titles = [self._text(line, span) for span in spans]
            if self.column:
                fields = self.fields = Fields(str(self._find(titles, above) + 1))
            places = list(fields.of(len(titles)))
            read = [read_title(titles[place], self.source) for place in places]
            names = self._names_above(above, len(titles))
            if self.cut and self.cut.delimiter and len(places) == 1:
                self.units = unit_column(titles, places[0])
            for title in read:
                if title.unit:
                    column_titles.refuse_uncalibrated(title)
            if self.cut:  # not a line of text
                self._refuse(read, [read_title(names[place]) for place in places if names])
        except (errors.NumberError, errors.UnitError) as error:
            raise errors.UsageError(f"{WHERE}: {error.message}", error.hint) from None
        self._check_units(read)
        out, done = bytearray(), 0
        for place, title in zip(places, read, strict=True):
            new_title = self.title_of(title)
            self.new_titles[place + 1 if self.cut else None] = new_title
            if new_title != title.text and not self.adds:
                start, end = spans[place]
                out += line[done:start] + self._cell(new_title, self._is_quoted(line, start))
                done = end
        out += line[done:]
        if self.adds:
            if (new_title := self.title_of(read[0])) in titles:
                problem = f"{WHERE} has the column '{quote(new_title)}'"
                raise errors.UsageError(problem, "another name")
            out += (self.cut.joint(line) if self.cut else b"\t") + self._cell(new_title)
        return bytes(out), len(titles) if self.cut else 0

    def _refuse(self, read: Sequence[Title], above: Sequence[Title]) -> None:
        """Refuse titles, with those above them, that are not of the unit that is read."""
        for title in [*read, *above]:
            column_titles.refuse_altered(title)
        if self.source and read_light(self.source):
            for title in read:
                column_titles.refuse_linked(title.text, self.source, self.given, "another column")
                column_titles.refuse_unknown(title, self.source)
                if not title.unit:
                    column_titles.refuse_misnamed(title, self.source)
        for title, parsed in zip(above, read, strict=False):
            if parsed.unit:
                column_titles.refuse_misnamed(title, parsed.unit)

    def title_of(self, title: Title | None = None) -> str:
        """Return the title of a result: the own one, or that of the source in the new unit."""
        unit = self.target.text
        if self.cut and not self.cut.delimiter:
            unit = unit.replace(" ", ".")  # one word if fields are separated by blanks
        if self.own:
            is_bare = unit == "1" or (title and not title.unit and not self.adds)
            if self.own.unit:
                return self.own.text
            if is_bare:
                return self._unlike_usual(self.own.text, unit)
            if title and not self.adds:
                return title.renamed(self.own.text, unit)
            return f"{self.own.text} [{unit}]"
        if title is None:
            return ""
        if title.unit is None and title.text[-1:] in ("]", ")"):
            self.note(f"the title '{quote(title.text)}' has no known unit, and is kept")
        _refuse_other(title.name, self.target)
        return title.with_unit(unit) if title.unit else self._unlike_usual(title.text, unit)

    def _unlike_usual(self, text: str, unit: str) -> str:
        """Return a title with the unit of its numbers if its name alone means another: PPFD."""
        usual = unit_of_name(text)
        if not usual or is_same(resolve(usual), self.target):
            return text
        return f"{text}_{unit}" if self.cut and not self.cut.delimiter else f"{text} [{unit}]"

    def check_unit(self, text: bytes) -> None:
        """Refuse the unit of a line if it is not that of the numbers."""
        typed = text.decode(errors="replace")
        unit = column_titles.unit_of_meter(typed)
        if self.source and not (unit and is_same(unit, self.source)):
            problem = f"the unit is '{quote(typed)}', not {quote(self.source.text)}"
            raise errors.NumberError(problem, "a call for the lines of each unit")

    def _find(self, titles: list[str], above: bytes) -> int:
        try:
            return find(titles, self.column, WHERE, self.source)
        except errors.UsageError as error:
            if names := self._names_above(above, len(titles)):
                return find(names, self.column, WHERE, self.source)
            if len(titles) == 1:
                raise error.reworded(hint=_of_one_title(titles[0])) from None
            raise

    def _names_above(self, above: bytes, count: int) -> list[str]:
        """Return the names of the columns in the line above, if it has as many."""
        names = [self._text(above, span) for span in title_spans(self.cut, above)]
        return names if len(names) == count > 1 else []

    def _check_units(self, titles: list[Title]) -> None:
        """Compare the units in the titles with those of the call; take them if it has none."""
        first = next((title for title in titles if title.unit), None)
        if first is None or first.unit is None:
            if self.source is None and self.cut and not (self.cut.delimiter or self.is_bare):
                problem = f"the unit of '{quote(titles[0].text)}' is missing in {WHERE}"
                raise errors.UsageError(problem, self.call("UNIT"))
            if not self.is_known:
                problem = f"the unit of the results is missing in {WHERE}"
                raise errors.UsageError(problem, option("get", "NAME:UNIT"))
            return
        for title in titles:
            if self.source is None:
                if title.unit is None or not is_same(title.unit, first.unit):
                    raise errors.UsageError(
                        f"'{quote(first.text)}' and '{quote(title.text)}' have different units",
                        "a call for each unit",
                    )
            elif title.unit and not is_same(title.unit, self.source):
                unit_text, typed = quote(title.unit.text), quote(self.source.text)
                is_there = is_same(title.unit, self.target)
                raise errors.UsageError(
                    f"the column '{quote(title.text)}' is in {unit_text}, not in {typed}",
                    f"a column in {typed}" if is_there else self.call(unit_text),
                )
        if self.source is None:
            self.texts, self.target = self.titled(first.unit)
            self.own = self._own()

    @property
    def option(self) -> str:
        """Return the option with the title of the results."""
        return "add" if self.adds else "rename"

    def _own(self) -> Title | None:
        """Return the typed title for the results, which may have their unit."""
        name = self.name
        if name is None:
            return None
        typed = option(self.option, quote(name))
        if not name.strip() or not name.isprintable():
            raise errors.UsageError(f"{typed} is not a title", errors.leave_out(self.option))
        if self.cut and not self.cut.delimiter and len(name.split()) > 1:
            hint = "_".join(name.split())
            problem = f"{typed} has blanks, at which the lines are cut"
            raise errors.UsageError(problem, errors.add(self.option, hint))
        title = read_title(name, self.target)
        if title.unit and not is_same(title.unit, self.target):
            unit_text, target = quote(title.unit.text), quote(self.target.text)
            problem = f"{typed} is in {unit_text}, not in {target}"
            raise errors.UsageError(problem, errors.add(self.option, title.with_unit(target)))
        _refuse_other(title.name, self.target, self.option)
        return title

    def _text(self, line: bytes, span: Span) -> str:
        start, end = span
        text = line[start:end].decode(errors="surrogateescape")
        return text.replace('""', '"') if self._is_quoted(line, start) else text

    def _is_quoted(self, line: bytes, start: int) -> bool:
        if self.cut is None or not self.cut.delimiter:
            return False
        while start and line[start - 1] in BLANKS:  # without copying the line
            start -= 1
        return line[start - 1 : start] == b'"'

    def _cell(self, title: str, in_quotes: bool = False) -> bytes:
        text = title.encode(errors="surrogateescape")
        if in_quotes:
            return text.replace(b'"', b'""')
        return self.cut.quoted(text) if self.cut else text


def refuse_change(source: Unit, target: Unit) -> None:
    """Refuse numbers of another quantity under the title of the first."""
    if source.dimension != target.dimension or source.is_exitance != target.is_exitance:
        change = f"{describe(source)} to {describe(target)}"
        problem = f"the numbers under the header would change from {change}"
        raise errors.UsageError(
            problem, [errors.add(name, _title_of(target)) for name in ("add", "rename")]
        )


def _title_of(target: Unit) -> str:
    """Return the name of a quantity as one word, or the unit of one without a name."""
    return (name_of(target) or target.text).replace(" ", "_")


def _of_one_title(title: str) -> errors.Hint:
    """Propose the only column."""
    try:
        parse_number(title)
    except errors.NumberError:
        return errors.add("column", title)
    return errors.leave_out("column")  # there is no header


def _refuse_other(name: str, target: Unit, option: str = "") -> None:
    """Refuse a title that names another quantity than its unit."""
    if column_titles.other_quantity(name, target):
        problem = f"the column would be named '{quote(name)}', but contain {describe(target)}"
        better = [errors.add(way, _title_of(target)) for way in (option, "add", "rename") if way]
        raise errors.UsageError(problem, better[: 1 if option else 2])
