"""Times of a log: calendar times, Unix time, or times since the start.

A clock turns texts into ticks: whole nanoseconds since 1970 in UTC for dates, or numbers in the
log's own unit for elapsed times.  A local time that occurs twice, when clocks are put back, is
resolved by the order; one that does not exist, when they are put forward, is refused.
"""

import re
from collections.abc import Iterable
from datetime import UTC, date, datetime, timedelta, timezone, tzinfo
from functools import lru_cache
from typing import NamedTuple

from radcalc import errors
from radcalc.calculators.page import PER_DAY
from radcalc.errors import NumberError, RadcalcError, add, mention, option, quote
from radcalc.files import columns
from radcalc.streams.timestamps import (
    DAY,
    EPOCH,
    FIRST_DAY,
    HOUR,
    LAST_YEAR,
    OFFSET,
    SECOND,
    Pattern,
    formats_of_digits,
    offset_in,
    pattern_of,
    pattern_of_format,
    read_offset,
)
from radcalc.units import Unit
from radcalc.units.dimensions import TIME
from radcalc.units.table import resolve

LATEST = (date(LAST_YEAR, 1, 1).toordinal() - FIRST_DAY) * DAY
MOST_KNOWN = 200_000  # texts of dates or times in the cache
# Unix time from 2001 to 2286: ticks by the digits before the point.
OF_UNIX = re.compile(r"[0-9]{1,19}(?:[.,][0-9]{0,30})?")
SAYS_UNIX = re.compile(r"unix|epoch|posix|timestamp", re.IGNORECASE)
UNIX = {10: SECOND, 13: 10**6, 16: 10**3, 19: 1}
SYMBOLS = {SECOND: "s", 10**6: "ms", 10**3: "us", 1: "ns"}
NAMES = {"s": "seconds", "ms": "milliseconds", "us": "microseconds", "ns": "nanoseconds"}
ZONE = option("time-zone", "Europe/Prague")


class TimeSettings(NamedTuple):
    """The settings for times: zone, unit of numbers, format of dates.

    The title of their column is `title`, with the unit `declared`.
    """

    zone: str = ""
    unit: str = ""
    format: str = ""
    title: str = ""
    declared: Unit | None = None


Interval = tuple[int, int, str]  # a day or an hour: its first tick, its end, and its label


class Undecided(NumberError):
    """An earlier local time occurs twice, and the order does not tell which one it is."""


class Elapsed:
    """Numbers of a unit elapsed since some start."""

    has_numbers = True  # decimals with a mark
    doubtful = ""

    def __init__(self, unit: Unit) -> None:
        self.unit = unit
        self.tick = unit.top, unit.bottom  # a tick in seconds
        self.assumptions: tuple[str, ...] = ()

    def many(self, texts: list[str]) -> list[float]:
        """Return the ticks of many texts; raise ValueError if any is unusual."""
        return columns.finite_numbers(texts)

    def one(self, text: str) -> float:
        value = columns.finite(text, comma=True)
        if value is None:
            raise NumberError(f"'{quote(text)}' is not a number of {self.unit.text}", "a number")
        return value

    def say(self, tick: float) -> str:
        return f"{tick:.12g} {self.unit.text}"

    def period(self, tick: float, by: str) -> Interval:
        """Refuse days: a time without a date has none."""
        problem = f"the times have no date, so they have no {by}"
        raise errors.ConditionError(problem, "times with dates: 2024-06-01T12:35, or Unix time")


class Calendar:
    """Dates with times of day, in one zone or with their own offsets."""

    tick = 1, SECOND
    has_numbers = False

    def __init__(
        self, zone: tzinfo | None, pattern: "Pattern", first: str = "", of_title: int | None = None
    ) -> None:
        """Read by a pattern; the first stamp shows whether there are offsets.

        The title may have the offset of all stamps [ticks].
        """
        self.zone, self.pattern = zone, pattern
        self.has_offsets = bool(first) and pattern.clock(pattern.parts(first)[1])[1] is not None
        self.is_of_days = bool(first) and not pattern.parts(first)[1].strip()
        self.of_title = 0 if self.has_offsets else of_title
        self.is_local = zone is not None and self.of_title is None
        self.offsets: set[int] = set()
        if of_title is not None and not self.has_offsets:
            self.offsets.add(of_title)
        self.days = lru_cache(MOST_KNOWN)(self._day)
        self.clocks = lru_cache(MOST_KNOWN)(self._clock)
        self.last: int | None = None  # ticks of local texts
        self.doubtful = ""  # a text that may be the first or the second time
        self.resolved = ""
        self.by = ""  # the period of the sums

    def many(self, texts: list[str]) -> list[int]:
        """Return the ticks of texts; raise any error if one of them is unusual."""
        days, clocks = self.days, self.clocks
        mark = self.pattern.mark
        if self.doubtful or not (mark or self.pattern.width):
            raise ValueError
        day = texts[0].partition(mark or " ")[0]
        text = "\n" + "\n".join(texts)
        if not mark or self.pattern.pieces > 1:
            parts = map(self.pattern.parts, texts)
            ticks = [days(day) + clocks(time) for day, time in parts]  # type: ignore[operator]
        elif text.count(f"\n{day}{mark}") == len(texts):  # all of one day, like most of a log
            midnight = days(day)
            clock_texts = text.replace(f"\n{day}{mark}", "\n").split("\n")[1:]
            ticks = [midnight + clocks(time) for time in clock_texts]  # type: ignore[operator]
        else:
            divided = [text.partition(mark) for text in texts]
            # a day with a clock change is None, and the addition fails
            ticks = [days(day) + clocks(time) for day, _, time in divided]  # type: ignore[operator]
        self.last = ticks[-1]
        return ticks

    def one(self, text: str) -> int:
        day, clock = self.pattern.parts(text)
        local = self.pattern.day(day) + self.clocks(clock)
        if not self.is_local:
            return local - (self.of_title or 0)
        self.last = self._local(local, text)
        return self.last

    def _day(self, text: str) -> int | None:
        """Return the tick of a day's midnight, or None if the clocks change on that day."""
        day = self.pattern.day(text)
        if not self.is_local:
            return day - (self.of_title or 0)
        ends = (day, day + DAY)
        offsets = {_offset(self.shown_in, at, fold) for at in ends for fold in (0, 1)}
        return day - offsets.pop() if len(offsets) == 1 else None

    def _clock(self, text: str) -> int:
        """Return ticks since midnight, less the offset."""
        ticks, offset = self.pattern.clock(text)
        if (offset is not None) != self.has_offsets:
            problem = "an offset" if offset is not None else "no offset"
            raise NumberError(f"'{quote(text)}' has {problem}, unlike those before", "one way")
        if offset is not None:
            self.offsets.add(offset)
        return ticks - (offset or 0)

    def _local(self, local: int, text: str) -> int:
        """Return the tick of a local time; the order resolves one that occurs twice."""
        assert self.zone is not None
        candidates = {local - _offset(self.zone, local, fold) for fold in (0, 1)}
        ticks = sorted(t for t in candidates if t + _offset_at(self.zone, t) == local)
        if not ticks:
            problem = f"'{quote(text)}' does not exist in {self.zone}: clocks are put forward there"
            raise NumberError(problem, _without_change(self.zone, local))
        if len(ticks) == 1:
            if self.doubtful:
                raise self.comes_twice(self.doubtful, ticks[0], Undecided)
            return ticks[0]
        if self.last is None:
            raise self.comes_twice(text, ticks[0])
        if ticks[0] > self.last:
            self.doubtful = text
            return ticks[0]
        self.doubtful = ""
        self.resolved = self.resolved or text
        return ticks[1]

    def comes_twice(
        self, text: str, tick: int, kind: type[NumberError] = NumberError
    ) -> NumberError:
        assert self.zone is not None
        problem = f"'{quote(text)}' comes twice in {self.zone}, as clocks are put back, and the "
        problem += "order of the log does not resolve it"
        local = tick + _offset_at(self.zone, tick)
        return kind(problem, f"times with offsets, or {_without_change(self.zone, local)}")

    @property
    def shown_in(self) -> tzinfo:
        if self.zone:
            return self.zone
        return _fixed(next(iter(self.offsets))) if len(self.offsets) == 1 else UTC

    @property
    def has_offset(self) -> bool:
        return bool(self.zone or self.offsets)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """The assumptions about format, zone and doubtful hours of the times that were read."""
        said = [self.pattern.assumption] if self.pattern.assumption else []
        if not self.has_offset:
            said.append(f"the times are in a zone without changes of daylight saving time ({ZONE})")
        elif self.by and not self.zone:
            zone = _format_offset(_offset_at(self.shown_in, 0))
            said.append(f"the {self.by}s are those of the offset {zone} ({ZONE})")
        if self.resolved:
            said.append(f"the hour that comes twice is resolved by the order ('{self.resolved}')")
        if self.doubtful:
            said.append(f"'{self.doubtful}', which comes twice, is taken as the first")
        return tuple(said)

    def say(self, tick: float) -> str:
        seconds, fraction = divmod(int(tick), SECOND)
        text = _at(self.shown_in, seconds).strftime("%Y-%m-%d %H:%M:%S")
        if fraction:
            text += f".{fraction:09}".rstrip("0")
        return text + self._offset_text(_offset_at(self.shown_in, int(tick)))

    def period(self, tick: float, by: str) -> Interval:
        """Return the local day or hour of a time; a day may have 23 or 25 hours."""
        if self.zone is None and len(self.offsets) > 1:
            raise errors.MissingInput(f"the offset changes: the zone of the {by}s is missing", ZONE)
        self.by = by
        zone = self.shown_in
        local = _at(zone, int(tick) // SECOND)
        if by == PER_DAY:
            today = local.replace(hour=0, minute=0, second=0, tzinfo=None)
            first = (today - EPOCH) // timedelta(seconds=1) * SECOND
            start, end = (at - _offset(zone, at, 0) for at in (first, first + DAY))
            return start, end, f"{today:%Y-%m-%d}"
        offset = _offset_at(zone, int(tick))
        start = (int(tick) + offset) // HOUR * HOUR - offset
        return start, start + HOUR, f"{local:%Y-%m-%d %H}:00{self._offset_text(offset)}"

    def _offset_text(self, offset: int) -> str:
        return _format_offset(offset) if self.has_offset else ""


class Unix(Calendar):
    """Seconds since 1970, or milliseconds and so on."""

    has_numbers = True

    def __init__(self, zone: tzinfo | None, ticks: int) -> None:
        super().__init__(zone or UTC, Pattern())
        self.ticks = ticks
        self.is_utc = zone is None

    def many(self, texts: list[str]) -> list[int]:
        if columns.has_odd_digits(" ".join(texts)):
            raise ValueError
        try:
            ticks = [int(text) * self.ticks for text in texts]
        except ValueError:
            return [self.one(text) for text in texts]
        if not (0 < ticks[0] < LATEST and 0 < ticks[-1] < LATEST):
            raise ValueError
        return ticks

    def one(self, text: str) -> int:
        from decimal import Decimal

        if not OF_UNIX.fullmatch(text):
            raise NumberError(f"'{quote(text)}' is not a Unix time", "seconds since 1970")
        tick = round(Decimal(text.replace(",", ".")) * self.ticks)
        if not 0 < tick < LATEST:
            raise NumberError(f"'{quote(text)}' is not a Unix time", f"up to the year {LAST_YEAR}")
        return tick

    @property
    def assumptions(self) -> tuple[str, ...]:
        of_utc = f"; days and hours are those of UTC ({ZONE})" if self.is_utc else ""
        return (f"the times are Unix time, in {NAMES[SYMBOLS[self.ticks]]}{of_utc}",)


Clock = Elapsed | Calendar


def clock_for(first: str, settings: TimeSettings, others: Iterable[str] = ()) -> Clock:
    """Return the reader of the times of a log, from the first; others show the order of dates."""
    zone = zone_of(settings.zone) if settings.zone else None
    if settings.format:
        if settings.unit:
            raise errors.ConditionError(
                mention("{time-unit} cannot be used with {time-format}"), "only one of them"
            )
        pattern = pattern_of_format(settings.format)
    elif columns.is_number(first, comma=True):
        return _of_numbers(first, settings, zone)
    elif settings.unit:
        problem = f"{option('time-unit', quote(settings.unit))} applies to numbers, not to"
        raise errors.ConditionError(f"{problem} '{quote(first)}'", "leave it out")
    else:
        pattern = pattern_of(first, settings.title, others)
    return Calendar(zone, pattern, first, offset_in(settings.title))


def _of_numbers(first: str, settings: TimeSettings, zone: tzinfo | None) -> Clock:
    """Return the reader of Unix time, dates of digits, or times elapsed in a unit."""
    integer_part = first.replace(",", ".").partition(".")[0]
    unit = settings.declared
    if settings.unit:
        declared = resolve(settings.unit)
        if declared.dimension != TIME:
            problem = f"{option('time-unit', quote(settings.unit))} is not a unit of time"
            raise errors.ConditionError(problem, "s, ms, min, h")
        if unit and (unit.top, unit.bottom) != (declared.top, declared.bottom):
            problem = f"{option('time-unit', quote(settings.unit))} contradicts the title"
            raise errors.ConditionError(f"{problem} '{quote(settings.title)}'", "leave it out")
        unit = declared
    ticks = UNIX.get(len(integer_part)) if integer_part.isdigit() else None
    if ticks and unit and ticks * unit.bottom == unit.top * SECOND:
        return Unix(zone, ticks)
    if unit:
        if zone:
            problem = f"{option('time-zone')} does not apply: the times have no date"
            raise errors.ConditionError(problem, "leave it out")
        return Elapsed(unit)
    forms, is_stated = formats_of_digits(first, settings.title) if first.isdigit() else ([], False)
    if forms and (is_stated or forms == ["%Y%m%d"]):
        return Calendar(zone, pattern_of_format(forms[0]), first, offset_in(settings.title))
    if ticks and not forms and SAYS_UNIX.search(settings.title):
        return Unix(zone, ticks)
    raise _without_unit(first, forms, ticks)


def _without_unit(text: str, forms: list[str], ticks: int | None) -> RadcalcError:
    """Return the error for a time of digits that may be a date, Unix time, or an elapsed time."""
    ways = [add("time-format", form) for form in forms]
    if ticks:
        ways.append(add("time-unit", SYMBOLS[ticks]))
    units = f"{option('time-unit')} s, min, h or d, or a title such as t [s]"
    if forms:
        unix = ", or Unix time" if ticks else ""
        return NumberError(f"'{quote(text)}' may be a date with its hour{unix}", ways)
    return errors.MissingInput(f"the unit of the times is missing: '{quote(text)}'", ways or units)


def zone_of(text: str) -> tzinfo:
    """Return a zone by name, or one with a fixed offset."""
    if re.fullmatch(OFFSET, text):
        return _fixed(read_offset(text))
    from zoneinfo import ZoneInfo, available_timezones

    try:
        return ZoneInfo(text)
    except (KeyError, ValueError, OSError, RecursionError):  # of many dots in a name
        pass
    names = available_timezones()
    if not names:
        raise errors.ConditionError(
            f"this system has no time zone data: {option('time-zone', quote(text))} is unknown",
            mention("the package tzdata, or a fixed offset: {time-zone=+02:00}"),
        )
    from radcalc.errors import nearest

    near = nearest(text, names) or ["Europe/Prague, +02:00 or UTC"]
    raise errors.ConditionError(f"unknown time zone '{quote(text)}'", ", ".join(near))


def _fixed(offset: int) -> tzinfo:
    return timezone(timedelta(seconds=offset // SECOND))


def _format_offset(offset: int) -> str:
    minutes = abs(offset) // (60 * SECOND)
    return f"{'-' if offset < 0 else '+'}{minutes // 60:02}:{minutes % 60:02}"


def _offset(zone: tzinfo, local: int, fold: int) -> int:
    """Return the offset of a local time from UTC in ticks; of two, the first or the second."""
    when = (EPOCH + timedelta(seconds=local // SECOND)).replace(fold=fold)
    return _ticks_of(zone.utcoffset(when))


def _ticks_of(offset: timedelta | None) -> int:
    assert offset is not None
    return round(offset.total_seconds()) * SECOND


def _at(zone: tzinfo, seconds: int) -> datetime:
    """Return the local time at seconds since 1970 in UTC."""
    return (EPOCH + timedelta(seconds=seconds)).replace(tzinfo=UTC).astimezone(zone)


def _offset_at(zone: tzinfo, tick: int) -> int:
    return _ticks_of(_at(zone, tick // SECOND).utcoffset())


def _without_change(zone: tzinfo, local: int) -> str:
    """Return the hint for a clock on winter time all the year."""
    offset = min(_offset(zone, local, fold) for fold in (0, 1))
    return f"{option('time-zone', _format_offset(offset))}, where the clock was not changed"
