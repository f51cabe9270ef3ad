"""Layout of a log, found from its first lines."""

import re
from collections.abc import Iterable, Mapping, Sequence
from itertools import chain, pairwise
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from radcalc import errors
from radcalc.errors import listed, option, quote
from radcalc.files import Text, columns, signatures, where
from radcalc.files.columns import SEARCHED, Head, NumberedLine, Table, is_number
from radcalc.quantities import PHOTON, RADIANT, column_titles
from radcalc.quantities import read as read_light
from radcalc.quantities.column_titles import is_same, read_title, unit_of_meter, unit_of_name
from radcalc.streams.clocks import Clock, TimeSettings, clock_for
from radcalc.streams.timestamps import DIGITS_IN_TITLE, looks_like_clock, looks_like_stamp
from radcalc.terminal import ABORT
from radcalc.units import NUMBER, Unit
from radcalc.units.dimensions import TIME
from radcalc.units.table import resolve
from radcalc.units.values import resolve_any

if TYPE_CHECKING:
    from radcalc.streams.solar import SunTable

MISSING = ("", "--", "-", "nan", "n/a", "na", "null", "none", "#n/a", "---")
SECONDS = resolve("s")
# The parts of a format by the titles of columns that have one part of a time each.
OF_PARTS = "%Y year yyyy yr, %m month mo mon, %d day dy dayofmonth, %j doy jday yday dayofyear, "
OF_PARTS += "%H hour hr hh, %M minute mn mi, %S second ss, %H%M hhmm"
PARTS = {name: part for part, *names in map(str.split, OF_PARTS.split(",")) for name in names}
TEXTS, DEVICES = "texts", "devices"
OF_SERIES = ("id", "device", "sensor", "channel", "station", "logger", "node", "serial", "probe")
PAR_ALSO = " (some meters give PAR in W/m2; a unit in the title decides: PAR [W/m2])"
OF_HOURS = ("hour", "hr", "hh", "hora", "stunde", "heure", "hodina", "час", "hours", "hhmm")
ONE_HOUR = 8  # the first of them are titles of whole hours
OF_TIME = re.compile(
    r"\b(?:time|date|datetime|elapsed|timestamp|unix|epoch|zeit|datum|čas|время|дата)\b|^t$"
)

Blocks = Iterable[tuple[int, list[str]]]


class LogSettings(NamedTuple):
    """The settings for a log: columns, unit, delimiter, times.

    The rows have the text of each `where` in its column (* is any).  `missing` are marks of values
    that are missing, `dark` is subtracted, and `thousands` separates digits in whole numbers.
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
    where: tuple[tuple[str, str], ...] = ()
    missing: tuple[str, ...] = ()
    dark: str = ""
    thousands: str = ""

    @property
    def texts(self) -> dict[str, str]:
        """The settings by option, as they are typed; '' where none is."""
        return {
            "column": self.column,
            "unit": self.unit,
            "time-column": ",".join(self.times),
            "delimiter": self.delimiter,
            "where": ",".join(map("=".join, self.where)),
            "missing": ",".join(self.missing),
            "dark": self.dark,
            "thousands": self.thousands,
            "invalid": self.invalid if self.invalid != ABORT else "",
            "time-zone": self.clock.zone,
            "time-format": self.clock.format,
            "time-unit": self.clock.unit,
        }


class LogLayout(NamedTuple):
    """The columns of times and values of a log, and their readers."""

    table: Table
    times: tuple[int, ...]
    place: int
    clock: Clock
    unit: Unit
    units: int | None = None  # the column with the unit of each value
    title: str = ""
    # The columns that may tell series apart: by their texts, or by numbers of devices, too.
    series: Mapping[int, bool] = MappingProxyType({})
    where: tuple[tuple[int, str], ...] = ()  # the columns that choose rows, and their texts


def rows_where(texts: Iterable[str]) -> tuple[tuple[str, str], ...]:
    """Return the columns and values of texts COLUMN=VALUE."""
    pairs = [text.rpartition("=") for text in texts]
    for name, _, value in pairs:
        if not name.strip():
            problem = f"{option('where', quote(value))} is not COLUMN=VALUE"
            raise errors.UsageError(problem, "a column, = and the text of its rows")
    return tuple([(name.strip(), value.strip()) for name, _, value in pairs])


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


class FirstRows(Head):
    """The head of a log or another table with times: a date and a number, or only numbers."""

    def __init__(self, name: str, lines: Sequence[NumberedLine], settings: LogSettings) -> None:
        self.name, self.settings = name, settings
        names = (*settings.times, settings.column, *[name for name, _ in settings.where])
        wanted = [name for name in names if name and not name.isdecimal()]
        super().__init__(lines, settings.delimiter, wanted)

    @property
    def names(self) -> list[str]:
        """The names of the columns; none without titles."""
        return list(self.table.names)

    @property
    def times(self) -> list[int]:
        """The columns of dates, or else those with titles of times."""
        if stamps := [k for k, cell in enumerate(self.cells) if self.is_start(cell)]:
            return stamps
        titled = [k for k, title in enumerate(self.table.titles) if _is_of_time(title)]
        digits = [k for k in titled if len(self.cells[k]) == 8]
        dates = [k for k in digits if "date" in column_titles.words_of(self.names[k])]
        return dates if len(dates) == 1 < len(titled) else titled

    @property
    def parts(self) -> tuple[tuple[int, ...], str]:
        """The columns of the year, month, day, hour ..., and their format, if each has its own."""
        if self.settings.times or self.settings.clock.format:
            return (), ""
        found: dict[str, int] = {}
        for place, name in enumerate(self.names):
            directive = PARTS.get(re.sub(r"\W|_", "", columns.plain(name)), "")
            if directive and found.setdefault(directive, place) != place:
                return (), ""  # two columns of hours
        for date in (("%Y", "%m", "%d"), ("%Y", "%j")):
            clocks = (("%H", "%M", "%S"), ("%H%M",))
            clock = next((parts for parts in clocks if parts[0] in found), ())
            asked = [*date, *[part for part in clock if part in found]]
            if {*date} <= found.keys() and asked[len(date) :]:
                return tuple([found[part] for part in asked]), " ".join(asked)
        return (), ""

    def error(self, number: int, problem: str, hint: errors.Hint) -> errors.LineError:
        """Return the error of a row (0: of none)."""
        return errors.LineError(f"{where(self.name, number, self.settings.row)}: {problem}", hint)

    def no_data(self, rows: Sequence[NumberedLine]) -> errors.LineError:
        problem = f"no time and value in the first {SEARCHED} lines"
        hint = "lines with a time and a value: 2024-06-01T12:35,812"
        return self.error(0, problem if rows else "the data are missing", hint)

    def is_start(self, cell: str) -> bool:
        return looks_like_stamp(cell, self.settings.clock.format)

    def is_data(self, cells: Sequence[str], is_named: bool) -> bool:
        numbers = [cell for cell in cells if is_number(cell) or cell.lower() in MISSING]
        if is_named:
            return any(map(is_number, cells))
        if any(map(self.is_start, cells)):
            return len(numbers) > 0
        return len(numbers) == len(cells) > 1 and any(map(is_number, cells))

    def skipped(self, rows: Sequence[NumberedLine]) -> int:
        """Return the row of titles of the largest table, if there are several; else 0."""
        cells = [columns.cells_alone(line, self.typed) for _, line in rows]
        starts = [
            k
            for k in range(1, len(rows) - 1)
            if len(cells[k]) == len(cells[k + 1]) > 1
            and (rows[k][0] - rows[k - 1][0] > 1 or len(cells[k - 1]) != len(cells[k]))
            and not any(is_number(cell) or self.is_start(cell) for cell in cells[k])
            and self.is_data(cells[k + 1], False)
        ]
        if not starts:
            return 0
        sizes = [end - start for start, end in pairwise([*starts, len(rows)])]
        largest = starts[sizes.index(max(sizes))]
        if any(self.is_data(row, False) for row in cells[:largest]):
            self.assumptions.append(
                f"the largest of several tables is read, with the titles in line {rows[largest][0]}"
            )
            return largest
        return 0

    def named_row(self, rows: Sequence[NumberedLine], wanted: Sequence[str]) -> int | None:
        """Return the place of the row with all names of the call."""
        refusal: errors.UsageError | None = None
        widest = 0
        for k, (_, line) in enumerate(rows):
            cells = columns.cells_alone(line, self.typed)
            try:
                for name in wanted:
                    column_titles.find(cells, name, self.name)
            except errors.UsageError as error:
                titles = [cell for cell in cells if cell and not is_number(cell)]
                if len(titles) > widest:
                    refusal, widest = error, len(titles)
            else:
                return k
        raise refusal or self.error(0, f"unknown column '{quote(wanted[0])}'", "its number")

    def are_titles(self, cells: Sequence[str]) -> bool:
        units = map(column_titles.unit_in, cells)
        return any(map(_is_of_time, cells)) or any(unit and read_light(unit) for unit in units)

    def _unit_in(self, title: str) -> Unit | None:
        """Return the unit of light in the title of a column, in which its numbers are."""
        try:
            parsed = read_title(title)
            unit = parsed.unit if parsed.unit and read_light(parsed.unit) else None
            column_titles.refuse_uncalibrated(parsed)
            if unit:
                column_titles.refuse_misnamed(parsed, unit)
            elif parsed.unit and (usual := unit_of_name(title)):  # PAR (mV), PPFD [%]
                column_titles.refuse_unknown(parsed, resolve(usual))
            else:
                column_titles.refuse_altered(parsed)
        except errors.UnitError as error:
            raise self.error(0, error.message, error.hint) from None
        if unit is None and (usual := unit_of_name(title)):
            also = PAR_ALSO if "par" in column_titles.words_of(title) else ""
            if not self.settings.unit:
                self.assumptions.append(f"'{quote(title)}' is in {usual}{also}")
            return resolve(usual)
        return unit


class LogHead(FirstRows):
    """The first lines of a log: its layout, and the first line of the data.

    `more` are the further blocks of lines, which are read if the first show no order of the dates.
    """

    def __init__(
        self,
        name: str,
        lines: Sequence[NumberedLine],
        settings: LogSettings,
        more: Iterable[tuple[int, list[str]]] = (),
    ) -> None:
        super().__init__(name, lines, settings)
        if len(self.cells) < 2:
            raise self.no_data(lines)
        self.layout = self._layout([line for number, line in lines if number >= self.begin], more)

    def _layout(self, lines: list[str], more: Iterable[tuple[int, list[str]]]) -> LogLayout:
        """Return the columns of times, values and units, from the titles and the first row."""
        names, titles, cells, table = self.names, list(self.table.titles), self.cells, self.table
        parts, form = self.parts
        times = parts or self._time_columns()
        place = self._value_column(times)
        where = tuple([(self._place(name), text) for name, text in self.settings.where])
        units = columns.unit_column(names, place)
        title = titles[place] if titles else ""
        if names and (stated := table.units_above.get(columns.plain(names[place]))):
            title += f" [{stated}]"
        unit = self._unit(title, None if units is None else cells[units])
        clock = self._clock(times, form, chain([lines], (block for _, block in more)))
        known = {*times, place, units, *[k for k, _ in where]}
        kinds = {k: self._series(k) for k in range(len(cells)) if k not in known}
        series = {k: kind == DEVICES for k, kind in kinds.items() if kind}
        return LogLayout(table, times, place, clock, unit, units, title, series, where)

    def _clock(self, times: tuple[int, ...], form: str, blocks: Iterable[Sequence[str]]) -> Clock:
        """Return the reader of the times in some columns, which have that format if it is given."""
        title = " ".join(map(self._title, times))
        stamps = (
            " ".join([cells[k] for k in times])
            for line in chain.from_iterable(blocks)
            if not columns.is_remark(line) and len(cells := self.cells_of(line)) > max(times)
        )
        try:
            settings = self.settings.clock._replace(title="" if form else title)
            if form:
                settings = settings._replace(format=form)
            elif len(times) == 1:
                settings = settings._replace(declared=_unit_of_time(title))
            return clock_for(" ".join([self.cells[k] for k in times]), settings, stamps)
        except errors.MissingInput:
            raise
        except errors.RadcalcError as error:
            raise self.error(self.number, error.message, error.hint) from None

    def _series(self, place: int) -> str:
        """Return what may tell series apart in a column: TEXTS, the numbers of DEVICES, or ""."""
        cell, title = self.cells[place], self._title(place)
        if _is_of_time(title) or self.is_start(cell) or looks_like_clock(cell):
            return ""
        if not {*column_titles.words_of(title)}.isdisjoint(OF_SERIES):
            return DEVICES
        return TEXTS if not is_number(cell) else ""

    def _title(self, place: int) -> str:
        return self.table.titles[place] if self.table.titles else ""

    def _time_columns(self) -> tuple[int, ...]:
        if self.settings.times:
            return tuple(map(self._place, self.settings.times))
        stamps = self.times
        if not stamps and (not self.names or len(self.cells) == 2):
            stamps = [0]
        if len(stamps) == 1:
            return (*stamps, *self._clock_column(stamps[0]))
        problem = "the column of the times is missing"
        if stamps:
            problem = f"there are {len(stamps)} columns of times"
        raise self._choice(problem, "time-column", stamps, range(len(self.cells)))

    def _choice(
        self, problem: str, name: str, likely: Sequence[int], others: Iterable[int], more: str = ""
    ) -> errors.LineError:
        """Return the error for columns that need a choice, by name or else by number."""
        names = self.names
        own = [
            names[k] if names and names.count(names[k]) == 1 else str(k + 1)
            for k in likely or others
        ]
        hint = f"{option(name, 'NAME')} {more}of {listed(own)}"
        found = self.error(0 if more else self.number, problem, hint)
        is_short = likely and not more and len(own) <= errors.MOST
        found.tries = tuple([errors.add(name, one) for one in own if is_short])
        return found

    def _clock_column(self, date: int) -> list[int]:
        """Find the column of the times of day: next to the dates, or by its title."""
        cells, names = self.cells, self.names
        clocks = [k for k, cell in enumerate(cells) if looks_like_clock(cell)]
        if cells[date].isdigit() and len(cells[date]) == 8:  # 20190101,0955
            clocks += [k for k, cell in enumerate(cells) if len(cell) == 4 and cell.isdigit()]
        titled = [k for k in clocks if _is_of_time(self._title(k)) and k != date]
        near = [k for k in clocks if abs(k - date) == 1]
        candidates = [k for k in near if k in titled] or near or titled
        if len(candidates) > 1:
            problem = f"there are {len(candidates)} columns of clocks"
            more = "twice, for the date and one "
            raise self._choice(problem, "time-column", candidates, (), more)
        hours = [k for k, name in enumerate(names) if columns.plain(name) in OF_HOURS]
        if not candidates and hours and date not in hours and ":" not in cells[date]:
            hour, is_short = cells[hours[0]], columns.plain(names[hours[0]]) in OF_HOURS[:ONE_HOUR]
            if not (len(hours) == 1 and is_short and hour.isdigit() and len(hour) < 3):
                ways = " ".join(option("time-column", quote(names[k])) for k in (date, hours[0]))
                form = "%Y-%m-%d %H" + "%M" * (not is_short)
                hint = f"{ways} with {option('time-format', form)}, or the like"
                problem = f"the column '{quote(names[hours[0]])}' may be the time of the dates"
                raise self.error(0, problem, hint)
            candidates = hours
        if candidates and names:
            pair = f"'{quote(names[date])}' and '{quote(names[candidates[0]])}'"
            self.assumptions.append(f"the date and the clock are those of {pair}")
        return candidates

    def _value_column(self, times: tuple[int, ...]) -> int:
        """Return the place of the values: the named column, or else the only one of light."""
        cells, titles = self.cells, self.table.titles
        candidates = [k for k in range(len(cells)) if k not in times]
        if self.settings.column:
            place = self._place(self.settings.column)
        else:
            numbers = [k for k in candidates if is_number(cells[k])]
            named = [k for k in candidates if _may_be_light(self._title(k))]
            of_light = named or (numbers if titles and len(candidates) > 1 else candidates)
            if len(of_light) != 1:
                problem = f"there are {len(of_light)} columns of values"
                raise self._choice(problem, "column", named, of_light or candidates)
            place = of_light[0]
            if titles and len(candidates) > 1:
                chosen = f"{place + 1} {quote(self.names[place])}".strip()
                self.assumptions.append(f"the values are in column {chosen}")
        if place in times:
            raise errors.UsageError("one column has the times and the values", "two columns")
        return place

    def _unit(self, title: str, cell: str | None) -> Unit:
        """Return the unit of the values: that of the user, in the title, in a cell or above."""
        declared, where = self._unit_in(title), f"the title '{quote(title)}'"
        if declared is None:
            declared, where = self._stated(cell), "the preamble"
            self._refuse_unlike(
                title, resolve_any(self.settings.unit) if self.settings.unit else declared
            )
        unit = resolve_any(self.settings.unit) if self.settings.unit else declared
        if unit is None:
            if (stated := read_title(title).unit) and stated.dimension == NUMBER:
                self._refuse_unlike(title, resolve("lx"))  # RH (%) is none of any unit
            hint = "{unit=lx}, {unit=umol/m2/s}, {unit=W/m2}, or a title such as E [lx]"
            problem = f"{self.name}: the unit of the values is missing"
            raise errors.MissingInput(problem, errors.mention(hint))
        if cell is not None:
            if declared and declared.dimension != (unit_of_meter(cell) or declared).dimension:
                problem = f"{where} is in {quote(declared.text)}, its first value in {quote(cell)}"
                raise self.error(0, problem, "titles that fit the units of the lines")
            self.assumptions.append("each value is in the unit of its line")
        elif declared and not is_same(declared, unit):
            self._override(unit, declared, where, "par" in column_titles.words_of(title))
        elif where == "the preamble" and declared:
            self.assumptions.append(f"the values are in {quote(unit.text)}, as {where} says")
        return unit

    def _stated(self, cell: str | None) -> Unit | None:
        """Return the unit of light in a cell, or else in the lines before the table."""
        stated = [text for key, text in self.table.pairs.items() if key in columns.UNIT_TITLES]
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
        typed, own = quote(unit.text), quote(declared.text)
        if declared.dimension != unit.dimension and not (may_be_par or is_short):
            problem = f"{option('unit', typed)} contradicts the unit {own} of {where}"
            hint = "leave it out, or use another column"
            raise errors.UsageError(problem, hint, [errors.leave_out("unit")])
        self.assumptions.append(f"the values are in {typed}, as given; {where} is in {own}")

    def _refuse_unlike(self, title: str, unit: Unit | None) -> None:
        """Raise for a title without a known unit of light that does not fit the typed unit."""
        try:
            parsed = read_title(title)
            column_titles.refuse_unknown(parsed, unit)
            if unit:
                column_titles.refuse_misnamed(parsed, unit)
        except errors.UnitError as error:
            hint = error.hint
            if hint in column_titles.SPELLINGS.values():
                hint = option("unit", hint)
            raise self.error(0, error.message, hint) from None

    def _place(self, name: str) -> int:
        return column_titles.find(self.names or [""] * len(self.cells), name, self.name)


def _is_of_time(title: str) -> bool:
    if OF_TIME.search(columns.plain(title).replace("_", " ")) or DIGITS_IN_TITLE.search(title):
        return True
    try:
        stated = read_title(title)
        if stated.unit and stated.in_brackets and stated.unit.dimension != TIME:
            return False  # d [m] is a distance
    except errors.UnitError:
        pass
    unit = column_titles.unit_in(title, SECONDS, at_end=True)  # t_s, but not s_cone_opic
    if unit is None or unit.dimension != TIME:
        return False
    return not _may_be_light(title)


def _unit_of_time(title: str) -> Unit | None:
    """Return the unit of time in a title: t [s], time_s, hours."""
    unit = read_title(title, SECONDS).unit
    if not unit or unit.dimension != TIME:
        return None
    title_unit = column_titles.unit_in(title)  # PAR_umol_m2_s
    return None if title_unit and read_light(title_unit) else unit


def _may_be_light(title: str) -> bool:
    """Return whether a title has a unit of light, what looks like one, or a name that has one."""
    if unit := column_titles.unit_in(title):
        return read_light(unit) is not None
    try:
        read_title(title)
    except errors.UnitError:
        return True
    return bool(unit_of_name(title))
