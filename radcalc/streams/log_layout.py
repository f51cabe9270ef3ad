"""Layout of a log, found from its first lines."""

import re
from collections.abc import Iterable, Sequence
from itertools import chain, pairwise
from typing import TYPE_CHECKING, NamedTuple

from radcalc import errors
from radcalc.errors import listed, option, quote
from radcalc.files import columns, signatures
from radcalc.files.table import Table
from radcalc.files.text import Text, where
from radcalc.quantities.column_titles import (
    SPELLINGS,
    find,
    is_same,
    read_title,
    refuse_altered,
    refuse_misnamed,
    refuse_unknown,
    unit_in,
    unit_of_meter,
    unit_of_name,
)
from radcalc.quantities.light import PHOTON, RADIANT
from radcalc.quantities.light import read as read_light
from radcalc.streams.clocks import Clock, TimeSettings, clock_for
from radcalc.streams.timestamps import looks_like_clock, looks_like_stamp
from radcalc.terminal import ABORT
from radcalc.units.dimensions import TIME
from radcalc.units.scales import resolve_any
from radcalc.units.table import resolve
from radcalc.units.unit import Unit

if TYPE_CHECKING:
    from radcalc.streams.solar import SunTable

# Light of other weights and bands, which the lumens and the watts of a spectrum do not measure.
OF_OTHER_LIGHT = """
    melanopic rhodopic cyanopic chloropic erythropic scotopic medi edi uva uvb uvc uv uvi erythemal
    ery longwave lw lwin lwout infrared nir
"""
OTHER_LIGHT = frozenset(OF_OTHER_LIGHT.split())
NAMES_OF_PAR = ("par", "qpar", "фар")
HEAD = 1000  # lines searched for the data, without comments and blank lines
MOST_REMARKS = 10_000  # lines searched with comments and blank lines
MISSING = ("", "--", "-", "nan", "n/a", "na", "null", "none", "#n/a", "---")
SECONDS = resolve("s")
PARTS = ("year", "month", "day", "hour", "minute", "second")  # titles of the parts of times
FORMATS = ("%Y", "%m", "%d", "%H", "%M", "%S")  # of the parts
LEAST_PARTS = 3  # a date; with an hour, it is a time
PAR_ALSO = " (some meters give PAR in W/m2; a unit in the title decides: PAR [W/m2])"
OF_HOURS = ("hour", "hours", "hr", "hh", "hhmm", "hora", "stunde", "heure", "hodina", "час")
OF_TIME = re.compile(r"\b(?:time|elapsed|timestamp|unix|epoch|zeit|čas|время)\b|^t$")

NumberedLine = tuple[int, str]
Blocks = Iterable[tuple[int, list[str]]]


class LogSettings(NamedTuple):
    """The settings for a log: columns, unit, delimiter, times.

    A row of data is a `row` in messages, and the first row of all has the number `first`.
    """

    times: tuple[str, ...] = ()
    column: str = ""
    unit: str = ""
    delimiter: str = ""
    invalid: str = ABORT
    clock: TimeSettings = TimeSettings()
    row: str = "line"
    first: int = 1


class LogLayout(NamedTuple):
    """The columns of times and values of a log, and their readers."""

    table: Table
    times: tuple[int, ...]
    place: int
    clock: Clock
    unit: Unit
    units: int | None = None  # the column with the unit of each value
    is_par: bool = False  # of watts from 400 nm to 700 nm, by the title
    band: str = ""  # by the title: melanopic, UVA; no spectrum of visible light links these


def error(name: str, number: int, problem: str, hint: str, row: str) -> errors.LineError:
    """Return the error of a log in a row (0: in none)."""
    return errors.LineError(f"{where(name, number, row)}: {problem}", hint)


def blocks_of(text: Text) -> tuple[Blocks, "SunTable | None"]:
    """Return the lines of a text in blocks; of a public format of the sun, those of its table."""
    blocks = text.blocks()
    number, lines = next(blocks, (text.first, []))
    kind = signatures.of_sun(lines)
    if not kind:
        return chain([(number, lines)], blocks), None
    from radcalc.streams import solar  # which needs pvlib

    table = solar.read(kind, text.name, [*lines, *(line for _, more in blocks for line in more)])
    return [(number, table.lines)], table


def first_lines(blocks: Blocks) -> list[NumberedLine]:
    """Return the lines that show the layout of a log, and the rest of their block."""
    head: list[NumberedLine] = []
    count = 0
    for number, lines in blocks:
        head += enumerate(lines, number)
        count += sum(not is_remark(line) for line in lines)
        if count >= HEAD or len(head) >= MOST_REMARKS:
            break
    return head


class FirstRows:
    """The first rows of a table: the titles, and the first line of the data and its cells."""

    def __init__(self, name: str, lines: Sequence[NumberedLine], settings: LogSettings) -> None:
        self.name = name
        self.settings = settings
        self.assumptions: list[str] = []
        rows = [row for row in lines if not is_remark(row[1])][:HEAD]
        # of the titles, with blanks inside cells below: 20240601 1800,100
        self.commas = rows[0][1].count(",") if rows and columns.dialect(rows[0][1])[0] == "," else 0
        rows = rows[self._largest(rows) :]
        named = self._named_row(rows)
        start = 0 if named is None else named + 1
        first = next((k for k in range(start, len(rows)) if self.is_data(rows[k][1], named)), None)
        if first is None:
            raise self.error(
                0,
                f"no time and value in the first {HEAD} lines" if rows else "the data are missing",
                "lines with a time and a value: 2024-06-01T12:35,812",
            )
        number, line = rows[first]
        delimiter = self.delimiter(line)
        cells = columns.cells(line, delimiter)
        while first > start and self._is_bad(rows[first - 1][1], line):
            first -= 1
        self.begin = rows[first][0]
        titles = self._titles(rows[:first], named, delimiter, len(cells))
        if not titles:
            comments = [
                columns.comment_text(line)
                for number, line in lines
                if number < self.begin and columns.is_comment(line)
            ]
            of_comment = columns.titles_in_comments(comments, len(cells), settings.delimiter)
            titles = [of_comment] if of_comment else []
        self.number, self.cells = number, cells
        self.table = Table(self.error, delimiter, len(cells), titles, rows[:first])

    @property
    def names(self) -> list[str]:
        """The titles of the columns; none without titles."""
        return list(self.table.titles[0]) if self.table.titles else []

    @property
    def times(self) -> list[int]:
        """The columns of dates, or else those with titles of times."""
        stamps = [k for k, cell in enumerate(self.cells) if self.is_stamp(cell)]
        return stamps or [k for k, name in enumerate(self.names) if _is_of_time(name)]

    @property
    def parts(self) -> tuple[int, ...]:
        """The columns of the year, month, day, hour ..., if each has its own."""
        if self.settings.times or self.settings.clock.format:
            return ()
        plain = [columns.plain(name) for name in self.names]
        count = next((k for k, part in enumerate(PARTS) if plain.count(part) != 1), len(PARTS))
        return tuple([plain.index(part) for part in PARTS[:count]]) if count > LEAST_PARTS else ()

    def error(self, number: int, problem: str, hint: str) -> errors.LineError:
        return error(self.name, number, problem, hint, self.settings.row)

    def delimiter(self, line: str) -> str | None:
        found, has_decimal_commas = columns.dialect(line)
        if found is None and has_decimal_commas and line.count(",") == self.commas:
            found = ","
        return self.settings.delimiter or found

    def _largest(self, rows: Sequence[NumberedLine]) -> int:
        """Return the row of titles of the largest table, if there are several; else 0."""
        cells = [columns.cells(line, self.delimiter(line)) for _, line in rows]
        starts = [
            k
            for k in range(1, len(rows) - 1)
            if len(cells[k]) == len(cells[k + 1]) > 1
            and (rows[k][0] - rows[k - 1][0] > 1 or len(cells[k - 1]) != len(cells[k]))
            and not any(_is_number(cell) or self.is_stamp(cell) for cell in cells[k])
            and self.is_data(rows[k + 1][1], None)
        ]
        if not starts:
            return 0
        sizes = [end - start for start, end in pairwise([*starts, len(rows)])]
        largest = starts[sizes.index(max(sizes))]
        if any(self.is_data(line, None) for _, line in rows[:largest]):
            self.assumptions.append(
                f"the largest of several tables is read, with the titles in line {rows[largest][0]}"
            )
            return largest
        return 0

    def _named_row(self, rows: Sequence[NumberedLine]) -> int | None:
        """Return the place of the row with all names of the call, None if it names no column."""
        wanted = (*self.settings.times, self.settings.column)
        names = [name for name in wanted if name and not name.isdecimal()]
        if not names:
            return None
        refusal: errors.UsageError | None = None
        widest = 0
        for k, (_, line) in enumerate(rows):
            cells = columns.cells(line, self.delimiter(line))
            try:
                for name in names:
                    find(cells, name, self.name)
            except errors.UsageError as error:
                titles = [cell for cell in cells if cell and not _is_number(cell)]
                if len(titles) > widest:
                    refusal, widest = error, len(titles)
            else:
                return k
        raise refusal or self.error(0, f"unknown column '{quote(names[0])}'", "its number")

    def is_data(self, line: str, named: int | None) -> bool:
        """Return whether a line has a time and a value: a stamp and a number, or only numbers."""
        cells = columns.cells(line, self.delimiter(line))
        numbers = [cell for cell in cells if _is_number(cell) or cell.lower() in MISSING]
        if named is not None:
            return any(map(_is_number, cells))
        if any(map(self.is_stamp, cells)):
            return len(numbers) > 0
        return len(numbers) == len(cells) > 1 and any(map(_is_number, cells))

    def _is_bad(self, line: str, good: str) -> bool:
        """Return whether a line above a good one has data, too: a time or a number."""
        delimiter = self.delimiter(good)
        cells, good_cells = columns.cells(line, delimiter), columns.cells(good, delimiter)
        pairs = zip(cells, good_cells, strict=False)
        if any(self.is_stamp(cell) and self.is_stamp(other) for cell, other in pairs):
            return True
        return len(cells) == len(good_cells) and any(map(_is_number, cells))

    def is_stamp(self, cell: str) -> bool:
        return looks_like_stamp(cell, self.settings.clock.format)

    def _titles(
        self, rows: Sequence[NumberedLine], named: int | None, delimiter: str | None, width: int
    ) -> list[list[str]]:
        """Return the rows of titles above the data: names, and units if they are below."""
        titles: list[list[str]] = []
        for _, line in reversed(rows[named or 0 :]):
            cells = columns.cells(line, delimiter)
            if len(cells) != width or any(_is_number(cell) for cell in cells if cell):
                break
            titles.insert(0, cells)
        if named is not None and len(titles) < len(rows) - named:
            raise self._unlike(rows[named], delimiter, width)
        if rows and not titles and self._has_titles(rows[-1][1], delimiter):
            raise self._unlike(rows[-1], delimiter, width)
        return titles

    def _has_titles(self, line: str, delimiter: str | None) -> bool:
        """Return whether the line above the data has titles of times and of light."""
        cells = columns.cells(line, delimiter) if delimiter else []
        if len(cells) < 2 or any(_is_number(cell) or self.is_stamp(cell) for cell in cells):
            return False
        return any(map(_is_of_time, cells)) or any(
            self._unit_in([cell]) is not None for cell in cells
        )

    def _unlike(self, row: NumberedLine, delimiter: str | None, width: int) -> errors.LineError:
        number, line = row
        count = len(columns.cells(line, delimiter))
        return self.error(
            number,
            f"{count} titles for {width} columns",
            "a title for each column; quotation marks around a text with a delimiter, and "
            "1000 for 1,000",
        )

    def _unit_in(self, texts: list[str]) -> Unit | None:
        """Return the unit of light in the titles of a column, in which its numbers are."""
        try:
            read = [read_title(title) for title in texts]
            units = [parsed.unit for parsed in read if parsed.unit and read_light(parsed.unit)]
            for parsed in read:
                refuse_altered(parsed)
                if units:
                    refuse_misnamed(parsed, units[0])
                elif parsed.unit and unit_of_name(parsed.text):  # PAR (mV)
                    refuse_unknown(parsed)
        except errors.UnitError as error:
            raise self.error(0, error.message, error.hint) from None
        for unit in units[1:]:
            if not is_same(unit, units[0]):
                problem = f"the titles '{quote(' '.join(texts))}' have two units"
                raise self.error(0, problem, "only one of them")
        if units:
            return units[0]
        for title in texts:
            if usual := unit_of_name(title):
                also = PAR_ALSO if "par" in _words(title) else ""
                if not self.settings.unit:
                    self.assumptions.append(f"'{quote(title)}' is in {usual}{also}")
                return resolve(usual)
        return None


class Head(FirstRows):
    """The first lines of a log: its layout, and the first line of the data."""

    def __init__(self, name: str, lines: Sequence[NumberedLine], settings: LogSettings) -> None:
        super().__init__(name, lines, settings)
        self.pairs = self.table.pairs
        self.layout = self._columns(self.number, self.cells, self.table)

    def _columns(self, number: int, cells: list[str], table: Table) -> LogLayout:
        """Return the columns of times, values and units, from the titles and the first row."""
        titles = [list(row) for row in table.titles]
        names = self.names
        parts = self.parts
        times = parts or self._time_columns(number, cells, names)
        place = self._value_column(number, cells, titles, times)
        units = columns.unit_column(names, place)
        above = [row[place] for row in titles]
        if names and (stated := table.units_above.get(columns.plain(names[place]))):
            above.append(stated)
        unit = self._unit(above, None if units is None else cells[units])
        title = " ".join([names[k] for k in times]) if names and not parts else ""
        text = " ".join([cells[k] for k in times])
        try:
            settings = self.settings.clock._replace(title=title, declared=_unit_of_time(title))
            if parts:
                settings = settings._replace(format=" ".join(FORMATS[: len(parts)]))
            clock = clock_for(text, settings)
        except (errors.NumberError, errors.UnitError) as error:
            raise self.error(number, error.message, error.hint) from None
        light = read_light(unit)
        is_of_watts = light is not None and light.kind == RADIANT
        is_par = is_of_watts and any(map(_is_par, above))
        words = [word for title in above for word in _words(title) if word in OTHER_LIGHT]
        return LogLayout(table, times, place, clock, unit, units, is_par, "".join(words[:1]))

    def _time_columns(self, number: int, cells: list[str], names: list[str]) -> tuple[int, ...]:
        if self.settings.times:
            return tuple([self._place(name, names, len(cells)) for name in self.settings.times])
        stamps = self.times
        if not stamps and (not names or len(cells) == 2):
            stamps = [0]
        if len(stamps) == 1:
            return (*stamps, *self._clock_column(stamps[0], cells, names))
        choices = [names[k] if names else str(k + 1) for k in stamps or range(len(cells))]
        problem = (
            f"there are {len(stamps)} columns of times"
            if stamps
            else "the column of the times is missing"
        )
        raise self.error(number, problem, f"{option('time-column', 'NAME')} of {listed(choices)}")

    def _clock_column(self, date: int, cells: list[str], names: list[str]) -> list[int]:
        """Find the column of the times of day: next to the dates, or by its title."""
        clocks = [k for k, cell in enumerate(cells) if looks_like_clock(cell)]
        titled = [k for k in clocks if names and _is_of_time(names[k]) and k != date]
        near = [k for k in clocks if abs(k - date) == 1]
        candidates = [k for k in near if k in titled] or near or titled
        if len(candidates) > 1:
            choices = listed([names[k] if names else str(k + 1) for k in candidates])
            hint = f"{option('time-column', 'NAME')} twice, for the date and one of {choices}"
            raise self.error(0, f"there are {len(candidates)} columns of clocks", hint)
        hours = [k for k, name in enumerate(names) if columns.plain(name) in OF_HOURS]
        if not candidates and hours and ":" not in cells[date]:
            title = quote(names[hours[0]])
            ways = " ".join(option("time-column", quote(names[k])) for k in (date, hours[0]))
            hint = f"{ways} with {option('time-format', '%Y-%m-%d %H')}, or the like"
            raise self.error(0, f"the column '{title}' may be the time of the dates", hint)
        if candidates and names:
            pair = f"'{quote(names[date])}' and '{quote(names[candidates[0]])}'"
            self.assumptions.append(f"the date and the clock are those of {pair}")
        return candidates

    def _value_column(
        self, number: int, cells: list[str], titles: list[list[str]], times: tuple[int, ...]
    ) -> int:
        """Return the place of the values: the named column, or else the only one of light."""
        candidates = [k for k in range(len(cells)) if k not in times]
        if self.settings.column:
            place = self._place(self.settings.column, titles[0] if titles else [], len(cells))
        else:
            numbers = [k for k in candidates if _is_number(cells[k])]
            of_light = [k for k in candidates if any(_may_be_light(row[k]) for row in titles)]
            of_light = of_light or (numbers if titles and len(candidates) > 1 else candidates)
            if len(of_light) != 1:
                choices = [titles[0][k] if titles else str(k + 1) for k in of_light or candidates]
                raise self.error(
                    number,
                    f"there are {len(of_light)} columns of values",
                    f"{option('column', 'NAME')} of {listed(choices)}",
                )
            place = of_light[0]
            if titles and len(candidates) > 1:
                chosen = f"{place + 1} {quote(titles[0][place])}".strip()
                self.assumptions.append(f"the values are in column {chosen}")
        if place in times:
            raise errors.UsageError("one column has the times and the values", "two columns")
        return place

    def _unit(self, titles: list[str], cell: str | None) -> Unit:
        """Return the unit of the values: that of the user, in the titles, in a cell or above."""
        declared, where = self._unit_in(titles), f"the title '{quote(' '.join(titles))}'"
        if declared is None:
            declared, where = self._stated(cell), "the preamble"
            for title in titles:
                self._refuse_unlike(
                    title, resolve_any(self.settings.unit) if self.settings.unit else declared
                )
        unit = resolve_any(self.settings.unit) if self.settings.unit else declared
        if unit is None:
            raise errors.MissingInput(
                f"{self.name}: the unit of the values is missing",
                errors.mention(
                    "{unit=lx}, {unit=umol/m2/s}, {unit=W/m2}, or a title such as E [lx]"
                ),
            )
        if cell is not None:
            if declared and declared.dimension != (unit_of_meter(cell) or declared).dimension:
                problem = f"{where} is in {quote(declared.text)}, its first value in {quote(cell)}"
                raise self.error(0, problem, "titles that fit the units of the lines")
            self.assumptions.append("each value is in the unit of its line")
        elif declared and not is_same(declared, unit):
            self._override(unit, declared, where, any("par" in _words(title) for title in titles))
        elif where == "the preamble" and declared:
            self.assumptions.append(f"the values are in {quote(unit.text)}, as {where} says")
        return unit

    def _stated(self, cell: str | None) -> Unit | None:
        """Return the unit of light in a cell, or else in the lines before the table."""
        stated = [text for key, text in self.pairs.items() if key in columns.UNIT_TITLES]
        unit = unit_of_meter(cell if cell is not None else stated[0]) if stated or cell else None
        return unit if unit and read_light(unit) else None

    def _override(self, unit: Unit, declared: Unit, where: str, is_par: bool) -> None:
        """State that the typed unit wins; refuse another quantity.

        Exceptions are W/m2 for PAR, and umol/m2/s for the uE of loggers.
        """
        reading = read_light(unit)
        stated = read_light(declared)
        is_ppfd = reading and (reading.kind, reading.geometry) == (PHOTON, (0, 1, 0))
        is_short = stated and stated.is_count and is_ppfd
        may_be_par = is_par and reading and reading.kind == RADIANT
        if declared.dimension != unit.dimension and not (may_be_par or is_short):
            raise errors.UsageError(
                f"{option('unit', quote(unit.text))} contradicts the unit "
                f"{quote(declared.text)} of {where}",
                "leave it out, or use another column",
                [errors.leave_out("unit")],
            )
        self.assumptions.append(
            f"the values are in {quote(unit.text)}, as given; {where} is in {quote(declared.text)}"
        )

    def _refuse_unlike(self, title: str, unit: Unit | None) -> None:
        """Raise for a title without a known unit of light that does not fit the typed unit."""
        try:
            parsed = read_title(title)
            refuse_unknown(parsed, unit)
            if unit:
                refuse_misnamed(parsed, unit)
        except errors.UnitError as error:
            hint = error.hint
            if hint in SPELLINGS.values():
                hint = option("unit", hint)
            raise self.error(0, error.message, hint) from None

    def _place(self, name: str, names: list[str], width: int) -> int:
        return find(names or [""] * width, name, self.name)


def is_remark(line: str) -> bool:
    """Return whether a line is blank or a comment."""
    return not line or line.isspace() or columns.is_comment(line)


def _is_number(cell: str) -> bool:
    return columns.is_number(cell, comma=True)


def _is_of_time(title: str) -> bool:
    if OF_TIME.search(columns.plain(title).replace("_", " ")):
        return True
    try:
        stated = read_title(title)
        if stated.unit and stated.in_brackets and stated.unit.dimension != TIME:
            return False  # d [m] is a distance
    except errors.UnitError:
        pass
    unit = unit_in(title, SECONDS)
    if unit is None or unit.dimension != TIME:
        return False
    return not _may_be_light(title)


def _unit_of_time(title: str) -> Unit | None:
    """Return the unit of time in a title: t [s], time_s, hours."""
    unit = read_title(title, SECONDS).unit
    if not unit or unit.dimension != TIME:
        return None
    title_unit = unit_in(title)  # PAR_umol_m2_s
    return None if title_unit and read_light(title_unit) else unit


def _may_be_light(title: str) -> bool:
    """Return whether a title has a unit of light, what looks like one, or a name that has one."""
    if unit := unit_in(title):
        return read_light(unit) is not None
    try:
        read_title(title)
    except errors.UnitError:
        return True
    return bool(unit_of_name(title))


def _is_par(title: str) -> bool:
    """Return whether a title names photosynthetically active radiation: PAR, PAR1, QPAR, ФАР."""
    words = {word.rstrip("0123456789") for word in _words(title)}
    return not words.isdisjoint(NAMES_OF_PAR) or "photosynthetic" in title.lower()


def _words(title: str) -> set[str]:
    return {*columns.plain(title).replace("_", " ").split()}
