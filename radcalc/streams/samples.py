"""Logs of light: the lines of a file or a stream as times and values, many at a time.

The first lines show how a log is laid out: what parts its cells, which lines are its header, how
its times are written, and in which unit its values are.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from math import inf
from operator import lt
from typing import Any, NamedTuple

from radcalc import columns
from radcalc.errors import (
    LineError,
    MissingInput,
    NumberError,
    RadcalcError,
    UnitError,
    UsageError,
    listed,
    mention,
    option,
    quote,
)
from radcalc.quantities.light import describe
from radcalc.quantities.light import read as read_light
from radcalc.quantities.names import PPFD
from radcalc.quantities.titles import find, is_same, read_title, refuse_altered, unit_in
from radcalc.streams import ABORT, FAIL, IGNORE, timestamps
from radcalc.texts import Text, where
from radcalc.units.dimensions import TIME
from radcalc.units.numbers import parse_number
from radcalc.units.scales import resolve_any
from radcalc.units.table import Unit, resolve

HEAD = 100  # lines in which the data begin, without comments and blank lines
MOST_REMARKS = 10_000  # lines that are looked through for them
FEW = 32  # lines that are not cut further
MISSING = ("", "--", "-", "nan", "n/a", "na", "null", "none", "#n/a", "---")
MARKED = re.compile(r"-(?:9{3,}|6999)(?:\.[09]*)?")  # as loggers mark what is missing: -9999.9
SECONDS = resolve("s")
LEAST = -999.0  # such marks are no greater
PPFD_UNIT = "umol/m2/s"
PAR_ALSO = " (meters give PAR in W/m2, too: its unit in the title, PAR [W/m2], tells)"
OF_TIME = re.compile(r"\b(?:time|elapsed|timestamp|unix|epoch|zeit|čas|время)\b")

Row = tuple[int, str]  # the number of a line and its text

Samples = tuple[list[Any], list[float]]  # times in ticks, and values


class Sample(NamedTuple):
    """A sample with its line, and its time as it stands there."""

    time: Any
    value: float
    number: int
    stamp: str


class Settings(NamedTuple):
    """What is told of a log: its columns, its unit, what parts its cells, how its times are."""

    times: tuple[str, ...] = ()
    column: str = ""
    unit: str = ""
    delimiter: str = ""
    invalid: str = ABORT
    clock: timestamps.Settings = timestamps.Settings()


class Layout(NamedTuple):
    """Where the times and the values of a log stand, and how they are read."""

    delimiter: str | None
    width: int
    times: tuple[int, ...]
    place: int
    clock: timestamps.Clock
    unit: Unit


class Log:
    """A log, read a block at a time."""

    def __init__(
        self, name: str, read: Callable[[int], bytes], settings: Settings, say: Callable[..., None]
    ) -> None:
        """Read the first lines; `say` is told of lines that are left out."""
        self.name = name
        self.settings = settings
        self.say = say
        self.notes: list[str] = []
        self.assumptions: list[str] = []
        self.is_good = True
        self.left_out, self.first_left_out = 0, ""
        self.last: Any = None  # tick
        self.last_line = 0
        # Local times that come twice wait for a later one, None for a line that was left out.
        self.waiting: list[Sample | None] = []
        self.before: tuple[Any, int] = None, 0  # the last time before them, and its line
        self.decimals = columns.Decimals()
        self.text = Text(name, read, "a time and a value", inf)
        self._blocks = self.text.blocks()
        self.layout = self._lay_out()

    @property
    def clock(self) -> timestamps.Clock:
        """What reads the times."""
        return self.layout.clock

    def error(self, number: int, problem: str, hint: str) -> LineError:
        """What is wrong, with the line."""
        return LineError(f"{where(self.name, number)}: {problem}", hint)

    def samples(self) -> Iterator[Samples | None]:
        """Times and values, many at a time; None where a line was left out."""
        for number, lines in self._pending:
            yield from self._of(lines, number)
        for number, lines in self._blocks:
            yield from self._of(lines, number)
        yield from _runs(self.waiting)
        if doubt := self.decimals.doubt():
            raise self.error(*doubt, columns.MARKS)
        if self.text.note:
            self.notes.append(self.text.note)
        if self.left_out:
            many = "a line is" if self.left_out == 1 else f"{self.left_out} lines are"
            self.notes.append(f"{many} left out; the first: {self.first_left_out}")
        self.assumptions += self.clock.assumptions

    # How the log is laid out.

    def _lay_out(self) -> Layout:
        """Read the first lines, of which those with data are kept for later."""
        head: list[Row] = []
        rows: list[Row] = []
        for number, lines in self._blocks:
            new = list(enumerate(lines, number))
            head += new
            rows += [row for row in new if not _is_remark(row[1])]
            if len(rows) >= HEAD or len(head) >= MOST_REMARKS:
                break
        rows = rows[:HEAD]
        named = self._named_row(rows)
        start = 0 if named is None else named + 1
        first = next((k for k in range(start, len(rows)) if self._is_data(rows[k][1], named)), None)
        if first is None:
            raise self.error(
                0,
                f"no time and value in the first {HEAD} lines" if rows else "there is no data",
                "lines with a time and a value: 2024-06-01T12:35,812",
            )
        number, line = rows[first]
        delimiter = self._delimiter(line)
        width = len(columns.cells(line, delimiter))
        while first > start and self._is_bad(rows[first - 1][1], line):
            first -= 1
        begin = rows[first][0]
        self._pending = [(begin, [text for n, text in head if n >= begin])]
        titles = self._titles(rows[:first], named, delimiter, width)
        if not titles:
            comments = [text for n, text in head if n < begin and _is_comment(text)]
            titles = self._commented(comments, width)
        return self._columns(number, columns.cells(line, delimiter), titles, delimiter)

    def _delimiter(self, line: str) -> str | None:
        return self.settings.delimiter or columns.dialect(line)[0]

    def _named_row(self, rows: Sequence[Row]) -> int | None:
        """The row with the names of columns that were asked for."""
        every = (*self.settings.times, self.settings.column)
        names = [name for name in every if name and not name.isdecimal()]
        if not names:
            return None
        refusal: UsageError | None = None
        widest = 0
        for k, (_, line) in enumerate(rows):
            cells = columns.cells(line, self._delimiter(line))
            try:
                for name in names:
                    find(cells, name, self.name)
            except UsageError as error:
                titles = [cell for cell in cells if cell and not _is_number(cell)]
                if len(titles) > widest:
                    refusal, widest = error, len(titles)
            else:
                return k
        raise refusal or self.error(0, f"there is no column '{quote(names[0])}'", "its number")

    def _is_data(self, line: str, named: int | None) -> bool:
        """Whether a line has a time and a value: a stamp and a number, or numbers alone."""
        cells = columns.cells(line, self._delimiter(line))
        numbers = [cell for cell in cells if _is_number(cell) or cell.lower() in MISSING]
        if named is not None:
            return any(map(_is_number, cells))
        if any(map(self._is_stamp, cells)):
            return len(numbers) > 0
        return len(numbers) == len(cells) > 1 and any(map(_is_number, cells))

    def _is_bad(self, line: str, good: str) -> bool:
        """Whether a line above a good one is of data, too: titles have no time and no number."""
        delimiter = self._delimiter(good)
        cells, own = columns.cells(line, delimiter), columns.cells(good, delimiter)
        both = zip(cells, own, strict=False)
        if any(self._is_stamp(one) and self._is_stamp(other) for one, other in both):
            return True
        return len(cells) == len(own) and any(map(_is_number, cells))

    def _is_stamp(self, cell: str) -> bool:
        return timestamps.looks_like_stamp(cell, self.settings.clock.format)

    def _titles(
        self, rows: Sequence[Row], named: int | None, delimiter: str | None, width: int
    ) -> list[list[str]]:
        """The rows of titles above the data: names, and units if they stand below."""
        found: list[list[str]] = []
        for _, line in reversed(rows[named or 0 :]):
            cells = columns.cells(line, delimiter)
            if len(cells) != width or any(_is_number(cell) for cell in cells if cell):
                break
            found.insert(0, cells)
        if named is not None and len(found) < len(rows) - named:
            raise self._unlike(rows[named], delimiter, width)
        if rows and not found and self._has_titles(rows[-1][1], delimiter):
            raise self._unlike(rows[-1], delimiter, width)
        return found

    def _has_titles(self, line: str, delimiter: str | None) -> bool:
        """Whether the line above the data has titles of times and of light, of any number."""
        cells = columns.cells(line, delimiter) if delimiter else []
        if len(cells) < 2 or any(_is_number(cell) or self._is_stamp(cell) for cell in cells):
            return False
        return any(map(_is_of_time, cells)) or any(
            self._unit_in([cells], k) is not None for k in range(len(cells))
        )

    def _unlike(self, row: Row, delimiter: str | None, width: int) -> LineError:
        """What is wrong where the data have more columns than titles, or fewer."""
        number, line = row
        count = len(columns.cells(line, delimiter))
        return self.error(
            number,
            f"{count} titles over {width} columns",
            "a title for each column; quotation marks around what has a delimiter in it, and "
            "1000 in place of 1,000",
        )

    def _commented(self, comments: Sequence[str], width: int) -> list[list[str]]:
        """The titles of columns, where a comment has them."""
        for comment in reversed(comments):
            text = comment.lstrip("#%/; \t")
            cells = columns.cells(text, self._delimiter(text))
            if len(cells) == width:
                return [cells]
        return []

    def _columns(
        self, number: int, cells: list[str], titles: list[list[str]], delimiter: str | None
    ) -> Layout:
        """Which columns have the times and the values, by their titles and the first line."""
        names = titles[0] if titles else []
        times = self._time_columns(number, cells, names)
        place, unit = self._value_column(number, cells, titles, times)
        title = " ".join([names[k] for k in times]) if names else ""
        text = " ".join([cells[k] for k in times])
        try:
            told = self.settings.clock._replace(title=title, declared=_unit_of_time(title))
            clock = timestamps.clock_for(text, told)
        except (NumberError, UnitError) as error:
            raise self.error(number, error.message, error.hint) from None
        return Layout(delimiter, len(cells), times, place, clock, unit)

    def _time_columns(self, number: int, cells: list[str], names: list[str]) -> tuple[int, ...]:
        """The column of the times, or those of dates and of clocks."""
        if self.settings.times:
            return tuple([self._place(name, names, len(cells)) for name in self.settings.times])
        stamps = [k for k, cell in enumerate(cells) if self._is_stamp(cell)]
        if not stamps:
            stamps = [k for k, name in enumerate(names) if _is_of_time(name)]
            if not names or (not stamps and len(cells) == 2):
                stamps = [0]
        if len(stamps) == 1:
            return (*stamps, *self._clock_column(stamps[0], cells, names))
        shown = [names[k] if names else str(k + 1) for k in stamps or range(len(cells))]
        problem = f"there are {len(stamps)} columns of times" if stamps else "no column has times"
        raise self.error(number, problem, f"{option('time-column', 'NAME')} of {listed(shown)}")

    def _clock_column(self, date: int, cells: list[str], names: list[str]) -> list[int]:
        """The column of the clock to that of the dates: the next to it, or one of that title."""
        clocks = [k for k, cell in enumerate(cells) if timestamps.looks_like_clock(cell)]
        own = [k for k in clocks if names and _is_of_time(names[k]) and k != date]
        near = [k for k in clocks if abs(k - date) == 1]
        found = [k for k in near if k in own] or near or own
        if len(found) > 1:
            shown = listed([names[k] if names else str(k + 1) for k in found])
            hint = f"{option('time-column', 'NAME')} twice, for the date and one of {shown}"
            raise self.error(0, f"there are {len(found)} columns of clocks", hint)
        if found and names:
            pair = f"'{quote(names[date])}' and '{quote(names[found[0]])}'"
            self.assumptions.append(f"the date and the clock are those of {pair}")
        return found

    def _value_column(
        self, number: int, cells: list[str], titles: list[list[str]], times: tuple[int, ...]
    ) -> tuple[int, Unit]:
        """The column of the values, and their unit."""
        others = [k for k in range(len(cells)) if k not in times]
        if self.settings.column:
            place = self._place(self.settings.column, titles[0] if titles else [], len(cells))
        else:
            numbers = [k for k in others if _is_number(cells[k])]
            of_light = [k for k in others if any(_may_be_light(row[k]) for row in titles)]
            of_light = of_light or (numbers if titles and len(others) > 1 else others)
            if len(of_light) != 1:
                shown = [titles[0][k] if titles else str(k + 1) for k in of_light or others]
                raise self.error(
                    number,
                    f"there are {len(of_light)} columns of values",
                    f"{option('column', 'NAME')} of {listed(shown)}",
                )
            place = of_light[0]
        if place in times:
            raise UsageError("one column has the times and the values", "two columns")
        return place, self._unit(self._unit_in(titles, place), titles[0][place] if titles else "")

    def _unit(self, declared: Unit | None, title: str) -> Unit:
        """The unit of the values: as told, or as the title has it."""
        if not self.settings.unit:
            if declared is None:
                raise MissingInput(
                    f"{self.name}: the unit of the values is missing",
                    mention("{unit=lx}, or a title such as E [lx]"),
                )
            return declared
        told = resolve_any(self.settings.unit)
        if declared and not is_same(declared, told):
            raise UsageError(
                f"{option('unit', quote(told.text))} contradicts the title '{quote(title)}', "
                f"which has {describe(declared)}",
                "the same without it, or another column",
            )
        return told

    def _unit_in(self, titles: list[list[str]], place: int) -> Unit | None:
        """The unit of light in the titles of a column, which has its numbers as they are."""
        own = [row[place] for row in titles]
        try:
            read = [read_title(title) for title in own]
            for one in read:
                refuse_altered(one)
        except UnitError as error:
            raise self.error(0, error.message, error.hint) from None
        units = [one.unit for one in read if one.unit and read_light(one.unit)]
        for unit in units[1:]:
            if not is_same(unit, units[0]):
                problem = f"the titles '{quote(' '.join(own))}' have two units"
                raise self.error(0, problem, "one of them")
        if units:
            return units[0]
        for title in own:
            if _is_ppfd(title):
                also = PAR_ALSO if "par" in _words(title) else ""
                self.assumptions.append(f"'{quote(title)}' is in {PPFD_UNIT}{also}")
                return resolve(PPFD_UNIT)
        return None

    def _place(self, name: str, names: list[str], width: int) -> int:
        """The column of a name, or of a number."""
        return find(names or [""] * width, name, self.name)

    # The samples.

    def _of(self, lines: list[str], number: int) -> Iterator[Samples | None]:
        """The samples of lines, all at once or in parts, down to a few that are read alone."""
        found = self._at_once(lines, number)
        if found:
            yield found
        elif len(lines) <= FEW:
            yield from self._one_by_one(lines, number)
        else:
            middle = len(lines) // 2
            yield from self._of(lines[:middle], number)
            yield from self._of(lines[middle:], number + middle)

    def _at_once(self, lines: list[str], number: int) -> Samples | None:
        """The samples of lines that have nothing unusual; else None."""
        layout = self.layout
        try:
            cells = _columns_of(lines, layout.delimiter, layout.width)
            values = list(map(float, self._with_points(cells[layout.place], number)))
            total = sum(values)
            if total - total or min(values) <= LEAST:
                return None
            stamps = cells[layout.times[0]]
            if layout.clock.has_numbers:
                stamps = self._with_points(stamps, number)
            elif layout.times[1:]:
                stamps = list(map(" ".join, zip(*[cells[k] for k in layout.times], strict=True)))
            times: list[Any] = list(layout.clock.many(stamps))
        except (ValueError, TypeError, RadcalcError):
            return None
        if not all(map(lt, times, times[1:])) or (self.last is not None and times[0] <= self.last):
            return None
        self.last, self.last_line = times[-1], number + len(lines) - 1
        return times, values

    def _with_points(self, texts: list[str], number: int) -> list[str]:
        """Numbers with decimal points; ValueError where a text or a mark is unusual."""
        joined = " ".join(texts)
        if not joined.isascii() or "_" in joined:
            raise ValueError
        if self.layout.delimiter == ",":
            return texts
        marks, has_point = self.decimals, "." in joined
        if "," in joined:
            if has_point or not marks.comma:
                raise ValueError
            return joined.replace(",", ".").split(" ")
        if has_point:
            if marks.comma or marks.doubtful:
                raise ValueError
            if not marks.point:
                marks.point = next(k for k, text in enumerate(texts, number) if "." in text)
        return texts

    def _one_by_one(self, lines: list[str], number: int) -> Iterator[Samples | None]:
        """The samples of lines, each by itself; what is wrong with one is said."""
        rows = [row for row in enumerate(lines, number) if not _is_remark(row[1])]
        yield from _runs(sample for row in rows for sample in self._of_line(*row))

    def _of_line(self, number: int, line: str) -> Iterator[Sample | None]:
        """The sample of a line, with those before it that waited for its time."""
        try:
            try:
                sample = self._sample(line, number)
            except timestamps.Undecided:
                yield from self._leave_out_waiting()
                sample = self._sample(line, number)
        except LineError as error:
            self._leave_out(error)
            yield from self._in_order([None])
            return
        try:
            self._check_order(sample.time, number)
        except LineError as error:
            self._leave_out(error)
            return
        if self.clock.doubtful and not any(self.waiting):
            self.before = self.last, self.last_line
        self.last, self.last_line = sample.time, number
        yield from self._in_order([sample])

    def _in_order(self, samples: list[Sample | None]) -> list[Sample | None]:
        """The samples whose times are known, of which some may have waited for a later one."""
        self.waiting += samples
        if self.clock.doubtful:
            return []
        samples, self.waiting = self.waiting, []
        return samples

    def _leave_out_waiting(self) -> Iterator[None]:
        """Leave out the samples of which no order tells which of two times they have."""
        assert isinstance(self.clock, timestamps.Calendar)
        waiting, self.waiting = self.waiting, []
        self.clock.doubtful = ""
        for sample in waiting:
            if sample:
                why = self.clock.comes_twice(sample.stamp, sample.time)
                self._leave_out(self.error(sample.number, why.message, why.hint))
        self.last, self.last_line = self.before
        self.clock.last = self.last
        yield None

    def _leave_out(self, error: LineError) -> None:
        """Say what is wrong with a line, or stop there."""
        if self.settings.invalid == ABORT:
            raise error
        self.first_left_out = self.first_left_out or error.message
        self.left_out += 1
        self.is_good = self.is_good and self.settings.invalid != FAIL
        if self.settings.invalid != IGNORE:
            self.say(error)

    def _sample(self, line: str, number: int) -> Sample:
        """The time and the value of a line."""
        layout = self.layout
        cells = columns.cells(line, layout.delimiter)
        if len(cells) != layout.width:
            raise self.error(
                number, f"{len(cells)} cells instead of {layout.width}", "a cell in every column"
            )
        stamp, comma = " ".join([cells[k] for k in layout.times]), layout.delimiter != ","
        try:
            time = layout.clock.one(stamp)
        except timestamps.Undecided:
            raise
        except RadcalcError as error:
            raise self.error(number, error.message, error.hint) from None
        text = cells[layout.place]
        if text.lower() in MISSING or MARKED.fullmatch(text):
            hint = mention("{invalid=ignore}, which leaves the line out")
            raise self.error(number, f"a value is missing: '{quote(text)}'", hint)
        value = columns.finite(text, comma)
        if value is None:
            try:
                parse_number(text)
            except NumberError as error:
                raise self.error(number, error.message, error.hint) from None
            raise self.error(number, f"'{quote(text)}' is not a number", "a number")
        for one in (stamp, text) if layout.clock.has_numbers else (text,):
            if comma and (problem := self.decimals.conflict(one, number)):
                raise self.error(number, problem, columns.MARKS)
        return Sample(time, value, number, stamp)

    def _check_order(self, time: Any, number: int) -> None:
        """Refuse a time that is not after the one before."""
        if self.last is None or time > self.last:
            return
        say = self.clock.say
        if time == self.last:
            problem = f"the time {say(time)} stands in line {self.last_line} already"
            raise self.error(number, problem, "each time once")
        problem = f"{say(time)} is before {say(self.last)} in line {self.last_line}"
        hint = "lines in the order of their times"
        if isinstance(self.clock, timestamps.Calendar) and not self.clock.is_told:
            hint += f"; where clocks were put back, {timestamps.ZONE}"
        raise self.error(number, problem, hint)


def _runs(samples: Iterable[Sample | None]) -> Iterator[Samples | None]:
    """Samples as lists of times and values, with None between them where a line was left out."""
    times: list[Any] = []
    values: list[float] = []
    for sample in samples:
        if sample is None:
            if times:
                yield times, values
                times, values = [], []
            yield None
        else:
            times.append(sample.time)
            values.append(sample.value)
    if times:
        yield times, values


def _columns_of(lines: list[str], delimiter: str | None, width: int) -> list[list[str]]:
    """The columns of lines that have as many cells each; ValueError where any has not."""
    if not delimiter:
        rows = [line.split() for line in lines]
    else:
        text = "\n".join(lines)
        if '"' in text:
            rows = _unquoted(lines, delimiter)
        else:
            # the ends of the lines as cells of their own: in a table they are a column
            cells = text.replace("\n", f"{delimiter}\n{delimiter}").split(delimiter)
            if cells[width :: width + 1].count("\n") != len(lines) - 1:
                raise ValueError
            if len(cells) != len(lines) * (width + 1) - 1:
                raise ValueError
            return [cells[k :: width + 1] for k in range(width)]
    if {*map(len, rows)} != {width}:
        raise ValueError
    return [list(column) for column in zip(*rows, strict=True)]


def _unquoted(lines: list[str], delimiter: str) -> list[list[str]]:
    """The cells of lines; ValueError where a quoted one goes on in the next."""
    import csv

    try:
        rows = list(csv.reader(lines, delimiter=delimiter))
    except csv.Error:
        raise ValueError from None
    if len(rows) != len(lines):
        raise ValueError
    return rows


def _is_comment(line: str) -> bool:
    return line.lstrip().startswith(columns.COMMENTS)


def _is_remark(line: str) -> bool:
    """Whether a line is blank or a comment."""
    return not line or line.isspace() or _is_comment(line)


def _is_number(cell: str) -> bool:
    return columns.is_number(cell, comma=True)


def _is_of_time(title: str) -> bool:
    """Whether a title is that of times."""
    if OF_TIME.search(columns.plain(title).replace("_", " ")):
        return True
    unit = unit_in(title, SECONDS)
    return bool(unit and unit.dimension == TIME) and not _may_be_light(title)


def _unit_of_time(title: str) -> Unit | None:
    """The unit of time in a title: t [s], time_s, hours."""
    unit = read_title(title, SECONDS).unit
    if not unit or unit.dimension != TIME:
        return None
    whole = unit_in(title)  # PAR_umol_m2_s
    return None if whole and read_light(whole) else unit


def _may_be_light(title: str) -> bool:
    """Whether a title has a unit of light, or what looks like one, or is that of PPFD."""
    if unit := unit_in(title):
        return read_light(unit) is not None
    try:
        read_title(title)
    except UnitError:
        return True
    return _is_ppfd(title)


def _is_ppfd(title: str) -> bool:
    return not _words(title).isdisjoint(PPFD)


def _words(title: str) -> set[str]:
    return {*columns.plain(title).replace("_", " ").split()}
