"""Times of logs: notations, time zones with clock changes, and refusals.

Each time stamp has its UTC next to it; the clock changes are those of Directive
2000/84/EC, at 01:00 UTC of the last Sundays of March and October.
"""

from datetime import UTC, datetime
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc.calculators.page import PER_DAY, PER_HOUR
from radcalc.errors import RadcalcError
from radcalc.streams.clocks import TimeSettings, clock_for
from radcalc.streams.timestamps import SECOND
from radcalc.units.table import resolve

PRAGUE = "Europe/Prague"


def utc(text: str) -> int:
    """Return a tick from ISO 8601 in UTC."""
    return round(datetime.fromisoformat(text).replace(tzinfo=UTC).timestamp()) * SECOND


READ = [
    ("2024-06-01T12:35:00Z", {}, "2024-06-01T12:35"),
    ("2024-06-01 12:35", {}, "2024-06-01T12:35"),
    ("2024-06-01T14:35:00+02:00", {}, "2024-06-01T12:35"),
    ("2024-06-01 14:35+0200", {}, "2024-06-01T12:35"),
    ("2024-06-01 07:05 -0530", {}, "2024-06-01T12:35"),
    ("2024/6/1 12:35", {}, "2024-06-01T12:35"),
    ("20240601T123500Z", {}, "2024-06-01T12:35"),
    ("20240601T1235", {}, "2024-06-01T12:35"),
    ("2024-06-01", {}, "2024-06-01T00:00"),
    ("20240601", {}, "2024-06-01T00:00"),
    ("2024-02-28 24:00", {}, "2024-02-29T00:00"),
    ("2024-02-29 24:00", {}, "2024-03-01T00:00"),
    ("2023-12-31 24:00", {}, "2024-01-01T00:00"),
    ("01.06.2024 12:35:00", {}, "2024-06-01T12:35"),
    ("31/12/2024 12:35", {}, "2024-12-31T12:35"),
    ("12/31/2024 12:35 PM", {}, "2024-12-31T12:35"),
    ("12/31/2024 12:35:00 AM", {}, "2024-12-31T00:35"),
    ("6/1/2024 12:35", {"title": "DATE (MM/DD/YYYY) MST"}, "2024-06-01T12:35"),
    ("6/1/2024 12:35", {"title": "date dd/mm/yyyy"}, "2024-01-06T12:35"),
    ("2024-06-01 12:35", {"title": "Date Time, GMT-05:00"}, "2024-06-01T17:35"),
    ("2024-06-01 12:35", {"title": "time_utc", "zone": PRAGUE}, "2024-06-01T12:35"),
    ("2024-06-01 12:35", {"zone": PRAGUE}, "2024-06-01T10:35"),
    ("2024-12-01 12:35", {"zone": PRAGUE}, "2024-12-01T11:35"),
    ("2024-06-01 12:35", {"zone": "+05:30"}, "2024-06-01T07:05"),
    ("06/01/24 12:35:00 PM", {"format": "%m/%d/%y %I:%M:%S %p"}, "2024-06-01T12:35"),
    ("20240601:1235", {"format": "%Y%m%d:%H%M"}, "2024-06-01T12:35"),
    ("2024 153 12:35", {"format": "%Y %j %H:%M"}, "2024-06-01T12:35"),
    ("1 Jun 2024", {"format": "%d %b %Y"}, "2024-06-01T00:00"),
    ("June 1, 2024 9:05 am", {"format": "%B %d, %Y %I:%M %p"}, "2024-06-01T09:05"),
    ("12:35 on 1.6.2024", {"format": "%H:%M on %d.%m.%Y"}, "2024-06-01T12:35"),
    ("1/6/2024/12:35", {"format": "%d/%m/%Y/%H:%M"}, "2024-06-01T12:35"),
    ("2024 6 1 24", {"format": "%Y %m %d %H"}, "2024-06-02T00:00"),
    ("2024 153 105", {"format": "%Y %j %H%M"}, "2024-06-01T01:05"),
    ("2024 153 240", {"format": "%Y %j %H%M"}, "2024-06-01T02:40"),
    ("2024 153 2400", {"format": "%Y %j %H%M"}, "2024-06-02T00:00"),
    ("202406012400", {"format": "%Y%m%d%H%M"}, "2024-06-02T00:00"),
    ("406011235", {"format": "%y%m%d%H%M"}, "2004-06-01T12:35"),  # a zero is missing
    ("01/06/2024 14:35 +02", {"format": "%d/%m/%Y %H:%M %z"}, "2024-06-01T12:35"),
    ("01/06/2024 12:35UTC", {"format": "%d/%m/%Y %H:%M%z"}, "2024-06-01T12:35"),
    ("2024-W22-6T12:35Z", {}, "2024-06-01T12:35"),
    ("2024-06-01T24:00+02:00", {}, "2024-06-01T22:00"),
    ("2024-06-01 7", {}, "2024-06-01T07:00"),
    ("2024-6-1 9:05", {}, "2024-06-01T09:05"),
    ("2024-06-01 9:05:00 p.m.", {}, "2024-06-01T21:05"),
    ("2024-06-01 07:05 \u22120530", {}, "2024-06-01T12:35"),
    ("01-June-2024 12:35 GMT", {}, "2024-06-01T12:35"),
    # POSIX, strptime: 69 to 99 are 1969 to 1999, 00 to 68 are 2000 to 2068
    ("01.06.69", {"format": "%d.%m.%y"}, "1969-06-01T00:00"),
    ("01.06.68", {"format": "%d.%m.%y"}, "2068-06-01T00:00"),
    ("01/06/2024 12:30 AM", {"format": "%d/%m/%Y %I:%M %p"}, "2024-06-01T00:30"),
    ("1717245300", {"title": "unix"}, "2024-06-01T12:35"),
    ("1717245300", {"unit": "s"}, "2024-06-01T12:35"),
    ("1717245300000", {"title": "timestamp"}, "2024-06-01T12:35"),
    ("1717245300", {"declared": resolve("s")}, "2024-06-01T12:35"),
    ("1717245300.0", {"zone": PRAGUE, "unit": "s"}, "2024-06-01T12:35"),
]


@pytest.mark.parametrize(("text", "told", "expected"), READ)
def test_a_time_is_the_same_alone_and_among_many(text, told, expected):
    clock = clock_for(text, TimeSettings(**told))
    assert clock.one(text) == utc(expected)
    try:
        assert clock.many([text]) == [utc(expected)]
    except ValueError:
        assert "format" in told  # some patterns have both the date and the time


def test_fractions_of_a_second_are_whole_nanoseconds():
    clock = clock_for("2024-06-01 12:35:00.5", TimeSettings())
    texts = ["2024-06-01 12:35:00.5", "2024-06-01 12:35:00,000000001", "2024-06-01 12:35:00"]
    assert [clock.one(text) - utc("2024-06-01T12:35") for text in texts] == [SECOND // 2, 1, 0]
    unix = clock_for("1717245300.25", TimeSettings(title="epoch"))
    assert unix.one("1717245300.25") - utc("2024-06-01T12:35") == SECOND // 4


@pytest.mark.parametrize(
    ("text", "told", "seconds"),
    [
        ("90", {"declared": resolve("s")}, 90),
        ("1.5", {"declared": resolve("min")}, 90),
        ("1,5", {"declared": resolve("min")}, 90),
        ("0.025", {"unit": "h"}, 90),
        ("90000", {"declared": resolve("ms")}, 90),
        ("0.5", {"declared": resolve("d")}, 43200),
    ],
)
def test_an_elapsed_time_is_in_the_unit_given(text, told, seconds):
    clock = clock_for(text, TimeSettings(**told))
    assert Fraction(str(clock.one(text))) * Fraction(*clock.tick) == seconds


@pytest.mark.parametrize(
    ("text", "told", "said"),
    [
        ("06/01/2024 12:35", {}, "is ambiguous: 2024-01-06 or 2024-06-01"),
        ("06/01/24 12:35", {}, "a year of 2 digits"),
        ("2024-02-30", {}, "is not a date"),
        ("2023-02-29", {}, "is not a date"),
        ("2024-06-01 25:00", {}, "not a time of day"),
        ("2024-06-01 12:60", {}, "not a time of day"),
        ("2024-06-01 13:00 PM", {}, "not a time of day"),
        ("2024-06-01 noon", {}, "not a time of day"),
        ("9999-12-31", {}, "in the year 9999"),
        ("yesterday", {}, "not a date and time"),
        ("12", {}, "the unit of the times is missing"),
        ("12", {"unit": "lx"}, "not a unit of time"),
        ("12", {"unit": "h", "declared": resolve("s")}, "contradicts the title"),
        ("2024-06-01", {"unit": "s"}, "applies to numbers"),
        ("12", {"unit": "s", "zone": PRAGUE}, "no date"),
        ("2024-06-01", {"zone": "Europe/Praha"}, "unknown time zone"),
        ("2024-06-01", {"zone": "../../etc/passwd"}, "unknown time zone"),
        ("2024-06-01", {"zone": "+25:00"}, "not an offset"),
        ("2024-06-01", {"format": "%Q"}, "not supported"),
        ("2024-06-01", {"format": "%Y-%m-%d %Y"}, "twice"),
        ("12:30", {"format": "%H:%M"}, "no complete date"),
        ("01/06 12:30", {"format": "%d/%m %H:%M"}, "no complete date"),
        ("06/2024", {"format": "%m/%Y"}, "no complete date"),
        ("01/06/2024 12:30", {"format": "%d/%m/%Y %I:%M"}, "%I alone"),
        ("01/06/2024 01:30 PM", {"format": "%d/%m/%Y %H:%M %p"}, "%p alone"),
        ("2023-366", {"format": "%Y-%j"}, "is not a date"),
        ("2024060112", {"format": "%Y%m%d%H%M"}, "is not a time of day"),
        ("2024-06-01 12:35.5", {}, "is not a time of day"),
        ("2024-06-01 12.5", {}, "is not a time of day"),
        ("2024-06-01 24:01", {}, "is not a time of day"),
        ("2024-06-01 105", {}, "is not a time of day"),
        ("2024-06-01 12:35 25", {}, "is not a time of day"),
        ("24-06-01", {"format": "%Y-%m-%d"}, "is not a date"),
        ("\u0661/06/2024", {"format": "%d/%m/%Y"}, "is not a date"),
        ("2023-Foo-01", {"format": "%Y-%b-%d"}, "is not a date"),
        ("2024-03-31 02:30", {"zone": PRAGUE}, "does not exist"),
        ("2024-10-27 02:30", {"zone": PRAGUE}, "comes twice"),
    ],
)
def test_a_malformed_or_ambiguous_time_is_refused(text, told, said):
    with pytest.raises(RadcalcError) as refused:
        clock_for(text, TimeSettings(**told)).one(text)
    assert said in refused.value.message
    assert refused.value.hint


def test_dates_of_one_reading_do_not_decide_the_order_of_a_later_one():
    clock = clock_for("05/05/2018 12:00", TimeSettings(), ["05/05/2018 13:00"])
    assert clock.one("05/05/2018 13:00") == utc("2018-05-05T13:00")
    with pytest.raises(RadcalcError, match="ambiguous: 2018-06-05 or 2018-05-06"):
        clock.one("05/06/2018 00:00")  # beyond the lines that were read first


def test_an_offset_is_in_all_stamps_or_in_none():
    clock = clock_for("2024-06-01T12:35Z", TimeSettings())
    with pytest.raises(RadcalcError, match="no offset"):
        clock.one("2024-06-01T12:36")


def test_missing_zone_data_is_refused_with_a_remedy(monkeypatch):
    import zoneinfo

    monkeypatch.setattr(zoneinfo, "ZoneInfo", lambda name: {}[name])
    monkeypatch.setattr(zoneinfo, "available_timezones", set)
    with pytest.raises(RadcalcError, match="no time zone data") as refused:
        clock_for("2024-06-01", TimeSettings(zone=PRAGUE))
    assert "tzdata" in refused.value.hint


def test_the_order_of_lines_resolves_a_repeated_hour():
    """01:30 is the last time before that hour, in summer time; 02:00 CET is 01:00 UTC."""
    clock = clock_for("2024-10-27 01:30", TimeSettings(zone=PRAGUE))
    texts = ["01:30", "02:00", "02:30", "02:00", "02:30", "03:00"]
    ticks = [clock.one(f"2024-10-27 {text}") for text in texts]
    first = utc("2024-10-26T23:30")
    assert [(tick - first) // (60 * SECOND) for tick in ticks] == [0, 30, 60, 90, 120, 150]
    assert "2024-10-27 02:00" in " ".join(clock.assumptions)


def test_a_log_that_ends_in_a_repeated_hour_is_read_as_the_first():
    clock = clock_for("2024-10-27 01:30", TimeSettings(zone=PRAGUE))
    assert clock.one("2024-10-27 01:30") < clock.one("2024-10-27 02:30")
    assert "taken as the first" in " ".join(clock.assumptions)


@pytest.mark.parametrize(
    ("zone", "day", "hours"),
    [
        (PRAGUE, "2024-03-31", 23),
        (PRAGUE, "2024-10-27", 25),
        (PRAGUE, "2024-02-29", 24),
        ("Australia/Lord_Howe", "2024-04-07", 24.5),  # clocks go back by half an hour
        ("Africa/Cairo", "2024-04-26", 23),  # at midnight: the day begins at 01:00
    ],
)
def test_a_day_is_as_long_as_by_the_local_clock(zone, day, hours):
    clock = clock_for(f"{day} 12:00", TimeSettings(zone=zone))
    start, end, label = clock.period(clock.one(f"{day} 12:00"), PER_DAY)
    assert (label, (end - start) / 3600 / SECOND) == (day, hours)


def test_days_of_stamps_with_changing_offsets_need_a_zone():
    clock = clock_for("2024-10-26T12:00+02:00", TimeSettings())
    for text in ("2024-10-26T12:00+02:00", "2024-10-28T12:00+01:00"):
        tick = clock.one(text)
    with pytest.raises(RadcalcError, match="the offset changes"):
        clock.period(tick, PER_DAY)


@given(st.integers(utc("1990-01-01T00:00") // SECOND, utc("2037-12-31T00:00") // SECOND))
def test_periods_contain_their_time_and_follow_each_other(seconds):
    clock = clock_for("2024-06-01 12:00", TimeSettings(zone=PRAGUE))
    tick = seconds * SECOND
    for by in (PER_DAY, PER_HOUR):
        start, end, _ = period = clock.period(tick, by)
        assert start <= tick < end
        assert clock.period(end - 1, by) == period
        assert clock.period(end, by)[0] == end
