"""Logs of light: layouts as their makers describe them, and errors in them."""

import io

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc import files as text
from radcalc.errors import RadcalcError
from radcalc.streams.clocks import TimeSettings
from radcalc.streams.log_layout import LogSettings
from radcalc.streams.samples import Log


def read(data: bytes | str, size: int = 1 << 20, **told) -> tuple[list, list, Log]:
    """Return times in seconds from the first (None for a skipped line), values, and the log."""
    raw = io.BytesIO(data.encode() if isinstance(data, str) else data)
    clock = {key: told.pop(key) for key in ("zone", "format") if key in told}
    if "time_unit" in told:
        clock["unit"] = told.pop("time_unit")
    settings = LogSettings(**told, clock=TimeSettings(**clock))
    log = Log("log", lambda count: raw.read(min(count, size)), settings, lambda error: None)
    times, values = [], []
    top, bottom = log.clock.tick
    for found in log.samples():
        times += found[0] if found[1] else [None]
        values += found[1]
    first = next(time for time in times if time is not None)
    return [None if t is None else (t - first) * top / bottom for t in times], values, log


# As exported by Onset's HOBOware: a title of the plot, quoted titles with the logger's number, and
# events in lines without values.
HOBO = """"Plot Title: pond"
"#","Date Time, GMT+01:00","Temp, °C (SEN S/N: 1)","Intensity, Lux (LGR S/N: 1)","Stopped"
1,06/01/19 12:00:00 AM,20.1,0.0,
2,06/01/19 12:10:00 PM,20.1,21500.4,
3,06/01/19 12:20:00 PM,,,Logged
"""
# Campbell Scientific's TOA5: lines for the logger, titles, units and kinds of sampling.
TOA5 = """"TOA5","CR1000","CR1000","12345","CR1000.Std.27","CPU:par.CR1","1234","Table1"
"TIMESTAMP","RECORD","BattV","PAR_Avg"
"TS","RN","Volts","umol/s/m^2"
"","","Smp","Avg"
"2024-06-01 12:00:00",0,12.6,1500
"2024-06-01 12:10:00",1,12.6,1490.5
"""
# NREL's Measurement and Instrumentation Data Center: date and clock in two columns.
MIDC = """DATE (MM/DD/YYYY),MST,Global CMP22 (vent/cor) [W/m^2],Zenith Angle [degrees]
1/2/2019,00:00,0.2,160
1/2/2019,00:01,0.1,160
"""
LAYOUTS = {
    "HOBO": (HOBO, {"format": "%m/%d/%y %I:%M:%S %p", "invalid": "ignore"}, 43800, 21500.4, "Lux"),
    "TOA5": (TOA5, {}, 600, 1490.5, "umol/s/m^2"),
    "MIDC": (MIDC, {}, 60, 0.1, "W/m^2"),
    "commas": ("01.06.2024 00:00;0,5\n01.06.2024 00:10;1,25\n", {"unit": "klx"}, 600, 1.25, "klx"),
    "blanks": ("2024-06-01 00:00:00 1\n2024-06-01 00:00:10 2\n", {"unit": "lx"}, 10, 2, "lx"),
    "a comment": ("# t [min], E [lx]\n0,1\n1,2\n", {}, 60, 2, "lx"),
    "title alone": ("s\tlux\n0\t1\n1\t2\n", {}, 1, 2, "lux"),
    "a word": ("time_s,ppfd\n0,1\n1,2\n", {}, 1, 2, "umol/m2/s"),
    "per second": ("t_s,PAR_umol_m2_s\n0,1\n1,2\n", {}, 1, 2, "umol/m2/s"),
    "three": ("t_s,E_lx,P_mW\n0,1,5\n1,2,6\n", {"column": "P_mW"}, 1, 6, "mW"),
    "by number": ("0,1,5\n1,2,6\n", {"column": "3", "unit": "W", "times": ("1",),
                                     "time_unit": "s"}, 1, 6, "W"),
    "clock first": ("12:00,2024-06-01,1\n12:01,2024-06-01,2\n", {"unit": "lx"}, 60, 2, "lx"),
    "delimiter": ("t_s:E_lx\n0:1\n1:2\n", {"delimiter": ":"}, 1, 2, "lx"),
    "over a slash": ("t / min,E / klx\n0,1\n1,2\n", {}, 60, 2, "klx"),
    "without its unit": ("t_s,E_lx,F_lx\n0,1,5\n1,2,6\n", {"column": "f"}, 1, 6, "lx"),
    "Latin-1": ("t_s,E_lx,T \xb0C\n0,1,1\n1,2,1\n".encode("latin-1"), {}, 1, 2, "lx"),
    "a word with s": ("t_s,PAR_umol_m2_s\n0,1\n1,2\n", {}, 1, 2, "umol/m2/s"),
    "seconds behind": ("t,E [lx] 60 s\n0,1\n1,2\n", {"time_unit": "s"}, 1, 2, "lx"),
    "others scaled": ("t_s,E [lx],log E [lx]\n0,1,0\n1,2,1\n", {"column": "E"}, 1, 2, "lx"),
    "others without light": ("t_s,E [lx],T [K] x10\n0,1,0\n1,2,1\n", {}, 1, 2, "lx"),
    "Unix": ("timestamp,E [lx]\n1717245300,1\n1717245301,2\n", {}, 1, 2, "lx"),
}  # fmt: skip


@pytest.mark.parametrize("name", LAYOUTS)
@pytest.mark.parametrize("size", [1 << 20, 7])
def test_a_layout_is_read_in_blocks_of_any_size(name, size):
    text, told, seconds, value, unit = LAYOUTS[name]
    times, values, log = read(text, size, **told)
    seen = [time for time in times if time is not None]
    assert (seen, values[-1], log.layout.unit.text) == ([0, seconds], value, unit)


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_a_byte_order_mark_declares_the_encoding(encoding, end):
    text = f"time,E (lx){end}2024-06-01 00:00,1{end}2024-06-01 00:01,2{end}"
    data = text.encode(encoding)
    if encoding in ("utf-16-le", "utf-16-be"):
        data = "\ufeff".encode(encoding) + data
    assert read(data, 5)[:2] == ([0, 60], [1, 2])


@pytest.mark.parametrize(
    ("text", "told", "said"),
    [
        ("", {}, "the data are missing"),
        ("t_s,E_lx\n", {}, "no time and value"),
        ("t_s,E_lx\n0,1\n1\n", {}, "line 3: 1 column instead of 2"),
        ("t_s,E_lx\n0,1\n1,2,3\n", {}, "line 3: 3 columns instead of 2"),
        ("t_s;E_lx\n0;1,5\n1;2.5\n", {}, "line 3: a decimal point, but line 2 has a decimal comma"),
        ("t_s;E_lx\n0;1,500\n1;2\n", {}, "is ambiguous: a thousand"),
        ("t_s,E_lx\n0,1\n1,x\n", {}, "line 3: 'x' is not a number"),
        ("t_s,E_lx\n0,1\n1,inf\n", {}, "line 3: 'inf' is not a finite number"),
        ("t_s,E_lx\n0,1\n1,1_0\n", {}, "line 3: '1_0' is not a number"),
        ("t_s,E_lx\n0,1\nx,1\n", {}, "line 3: 'x' is not a number of s"),
        *[(f"t_s,E_lx\n0,1\n1,{mark}\n", {}, "line 3: a value is missing")
          for mark in ("", "NaN", "N/A", "--", "null", "-9999", "-9999.9", "-6999")],
        ("t_s,E_lx\n0,1\n2,1\n1,1\n", {}, "line 4: 1 s is before 2 s in line 3"),
        ("t_s,E_lx\n0,1\n2,1\n2,1\n", {}, "line 4: the time 2 s is already in line 3"),
        ("t_s,E_lx,F_lx\n0,1,2\n1,1,2\n", {}, "there are 2 columns of values"),
        ("t_s,a,b\n0,1,2\n1,1,2\n", {"unit": "lx"}, "there are 2 columns of values"),
        ("1\t2015-12-06 15:41:07\t'x'\n", {"unit": "lx"}, "there are 2 columns of values"),
        ("a,b,E_lx\n2024-06-01,2024-06-02,1\n", {}, "there are 2 columns of times"),
        ("a,b,E_lx\n1,2,1\n", {}, "the column of the times is missing"),
        ("t_s,E_lx\n0,1\n", {"column": "F"}, "has no column 'F'"),
        ("t_s,E_lx\n0,1\n", {"column": "3"}, "no column '3'"),
        ("t_s,E,E\n0,1,2\n", {"column": "E", "unit": "lx"}, "the column 'E' 2 times"),
        ("t_s,E_lx\n0,1\n", {"column": "1"}, "one column has the times and the values"),
        ("t_s,E\n0,1\n", {}, "the unit of the values is missing"),
        ("t_s,E_lx\n0,1\n", {"unit": "W/m2"}, "contradicts the unit lx of the title 'E_lx'"),
        ("t_s,E_lx,F\n0,1\n1,2\n", {"column": "E_lx"}, "3 titles for 2 columns"),
        ("t [s] x1000,E [lx]\n0,1\n1,2\n", {}, "'t [s] x1000' scales its numbers"),
        ("t [s],E [lx] x1000\n0,1\n1,2\n", {}, "'E [lx] x1000' scales its numbers"),
        ("t [s],log E\n0,1\n1,2\n", {"unit": "lx"}, "has a function of its numbers"),
        ("t,log E\ns,lx\n0,1\n1,2\n", {}, "has a function of its numbers"),
        ("t,E [W/m2]\ns,lx\n0,1\n1,2\n", {}, "has two units"),
        ("t_s,E (100 lx)\n0,1\n1,2\n", {}, "scales its numbers"),
        # bad lines above the first good one are not lines of titles
        *[(f"time,E [lx]\n2024-06-01T11:00,{bad}\n2024-06-01T12:00,1\n", told, "line 2: ")
          for bad in ("OVER", "<1", "1.000.000", "\0") for told in ({}, {"column": "E"})],
        ("time,E [lx]\n2024-06-01T11:00\n2024-06-01T12:00,1\n", {}, "line 2: 1 column instead"),
        ("time,E [lx]\nx,1\n2024-06-01T12:00,1\n", {}, "line 2: 'x' is not a date"),
        ("t_s,E_lx\n0,OVER\n1,2\n", {}, "line 2: 'OVER' is not a number"),
        ("a,b,c,E_lx\n12:00,2024-06-01,12:01,1\n", {}, "there are 2 columns of clocks"),
        ("time,E [lx]\n2024-06-01T12:00,1\n２０２４-06-01T13:00,1\n", {}, "line 3: "),
        ("time,E [lx]\n2024-06-01T12:00,1\n2024-06-01T１3:00,1\n", {}, "line 3: "),
        # decimal marks of times must agree with each other and with those of values
        ("t [ms];E [lx]\n1,000;5\n2,000;5\n", {}, "line 2: '1,000' is ambiguous: a thousand"),
        ("t_s;E_lx\n0,5;1,5\n1.5;2,5\n", {}, "line 3: a decimal point"),
        ("t_s;E_lx\n0.5;1\n1.5;2,5\n", {}, "line 3: a decimal comma"),
        *[(f"unix,E [lx]\n1717245300,1\n{bad},2\n", {}, "is not a Unix time")
          for bad in ("1e-9999999999999999999", "1.7172453e9", "9" * 5000)],
    ],
)  # fmt: skip
def test_an_error_is_refused_with_its_line(text, told, said):
    with pytest.raises(RadcalcError) as refused:
        read(text, **told)
    assert said in refused.value.message
    assert refused.value.hint


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        # sunrise is not the time of a sample
        ("date,E [lx],rise\n2024-06-01,1,04:00\n2024-06-02,1,04:01\n", 86400),
        ("date,E [lx],time\n2024-06-01,1,04:00\n2024-06-02,1,04:01\n", 86460),
        ("date,MST,E [lx],rise\n2024-06-01,04:00,1,03:00\n2024-06-01,04:01,1,03:00\n", 60),
        ("rise,date,time,E [lx]\n03:00,2024-06-01,04:00,1\n03:00,2024-06-01,04:01,1\n", 60),
    ],
)
def test_the_clock_of_a_date_is_in_the_next_column_or_titled_as_a_time(text, seconds):
    times, _, log = read(text)
    assert times == [0, seconds]
    said = [one for one in log.assumptions if "the date and the clock" in one]
    assert len(said) == (seconds != 86400)


@pytest.mark.parametrize(("title", "is_doubtful"), [("PAR", True), ("ppfd", False)])
def test_the_doubtful_unit_of_par_is_noted(title, is_doubtful):
    _, _, log = read(f"time_s,{title}\n0,1\n1,2\n")
    (said,) = [one for one in log.assumptions if "umol/m2/s" in one]
    assert ("W/m2" in said) == is_doubtful


@pytest.mark.parametrize("size", [1 << 20, 20])
def test_ambiguous_times_that_the_order_does_not_resolve_are_left_out(size):
    """01:30 is 23:30 UTC, 03:30 is 02:30 UTC, and 02:00 to 02:59 may be in either hour."""
    clocks = ["01:30", "02:10", "02:20", "02:30", "03:30", "04:30"]
    rows = [f"2024-10-27 {clock},{k}" for k, clock in enumerate(clocks)]
    rows[2] = "2024-10-27 02:20,--"
    said = []
    text = "\n".join(["time,E [lx]", *rows, ""])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Log, "_leave_out", lambda log, error: said.append(error.message))
        times, values, _ = read(text, size, zone="Europe/Prague", invalid="ignore")
    assert values == [0, 4, 5]
    assert [time for time in times if time is not None] == [0, 3 * 3600, 4 * 3600]
    assert times[0] == 0
    assert times[1] is None
    assert [one.partition(":")[0] for one in said] == ["log, line 4", "log, line 3", "log, line 5"]


def test_the_order_resolves_the_hour_although_its_first_line_has_no_value():
    """02:30 and 02:40 come before 02:10, so they are in the first of the two hours."""
    rows = ["01:30,0", "02:20,--", "02:30,2", "02:40,3", "02:10,4", "03:30,5"]
    text = "time,E [lx]\n" + "".join(f"2024-10-27 {row}\n" for row in rows)
    times, values, _ = read(text, zone="Europe/Prague", invalid="ignore")
    assert values == [0, 2, 3, 4, 5]
    assert times == [0, None, 3600, 4200, 6000, 10800]


@pytest.mark.parametrize(
    ("zone", "time", "offset"),
    [
        ("Europe/Prague", "2024-10-27 02:30", "+01:00"),
        ("Europe/Prague", "2024-03-31 02:30", "+01:00"),
        ("America/New_York", "2024-11-03 01:30", "-05:00"),
        ("Australia/Lord_Howe", "2024-04-07 01:45", "+10:30"),
    ],
)
def test_the_offset_in_the_hint_is_that_of_the_zone(zone, time, offset):
    with pytest.raises(RadcalcError) as refused:
        read(f"time,E [lx]\n{time},1\n{time[:10]} 05:30,1\n", zone=zone)
    assert offset in str(refused.value.hint)


def test_decimal_commas_are_read_in_times_and_values():
    rows = [f"{k},5;{k},25" for k in range(100)]
    times, values, _ = read("t_s;E_lx\n" + "\n".join(rows))
    assert (times, values) == ([float(k) for k in range(100)], [k + 0.25 for k in range(100)])


def test_a_long_preamble_of_comments_is_skipped():
    times, values, _ = read("# site\n" * 1500 + "t_s,E_lx\n0,1\n1,2\n")
    assert (times, values) == ([0, 1], [1, 2])


def test_a_line_that_is_too_long_is_refused():
    with pytest.raises(RadcalcError, match="the line has more than"):
        read("t_s,E_lx\n0,1\n" + "1" * (text.LONGEST + 2))


@pytest.mark.parametrize(
    ("invalid", "is_good"), [("fail", False), ("warn", True), ("ignore", True)]
)
def test_skipped_lines_are_noted_and_marked(invalid, is_good):
    times, values, log = read("t_s,E_lx\n0,1\n1,--\n2,3\n2,4\n3,5\n", invalid=invalid)
    assert (times, values) == ([0, None, 2, 3], [1, 3, 5])  # a repeated time is not a gap
    assert log.is_good is is_good
    assert "2 lines are skipped; the first: log, line 3" in log.notes[0]


@pytest.mark.parametrize("mark", [".", ","])
def test_single_lines_give_the_same_as_blocks(monkeypatch, mark):
    lines = [f"2024-06-{1 + k // 24:02} {k % 24:02}:30;{k * 0.1:.1f}" for k in range(500)]
    text = "time;E [lx]\n" + "\n".join(lines).replace(".", mark) + "\n"
    at_once = read(text, 999)[:2]
    assert at_once[1] == [round(k * 0.1, 1) for k in range(500)]
    monkeypatch.setattr(Log, "_at_once", lambda *_: None)
    assert read(text)[:2] == at_once


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        (["2024-06-01 2024-06-01 12:00,1", "12:01,1"], "line 42"),  # as many dates as lines
        (["2024-06-01 12:00,1,2", "12:01"], "line 42"),  # as many cells as in two lines
        (["2024-06-01 12:00,1 2", "2024-06-01 12:01,"], "line 42"),
    ],
)
def test_surplus_in_one_line_does_not_hide_a_lack_in_the_next(lines, said):
    before = [f"2024-06-01 11:{k:02},1" for k in range(40)]
    with pytest.raises(RadcalcError, match=said):
        read("\n".join(["time,E [lx]", *before, *lines, ""]))


def test_decimal_marks_far_apart_must_agree():
    rows = [f"{k};{k},5" for k in range(5000)]
    with pytest.raises(RadcalcError, match="line 5002: a decimal point, but line 2"):
        read("t_s;E_lx\n" + "\n".join([*rows, "5000;1.5", ""]), 4096)


@given(st.lists(st.integers(0, 299), max_size=40), st.integers(1, 400))
def test_skipped_lines_do_not_depend_on_the_blocks(bad, size):
    lines = [f"{k},{'x' if k in bad else k}" for k in range(300)]
    text = "t_s,E_lx\n0.5,1\n" + "\n".join(lines[1:]) + "\n"
    times, values, _ = read(text, size, invalid="ignore")
    expected = [1.0, *(float(k) for k in range(1, 300) if k not in bad)]
    assert values == expected
    assert times.count(None) == len({*bad} - {0})
