"""Tables as programs and people write them: each is right, or refused with what is missing.

The right values are sums by hand, in the comments beside them; each fault has its siblings.
"""

import pytest
from conftest import run

from radcalc import dose
from radcalc.errors import RadcalcError

TWO = "2024-06-01T12:00,{0}\n2024-06-01T13:00,{0}\n"  # an hour of one value: 3600 times it


def of(title: str, value: str = "100") -> str:
    return f"time,{title}\n" + TWO.format(value)


def rows(title: str, *times: str, value: str = "100") -> str:
    return f"{title},E [lx]\n" + "".join(f"{time},{value}\n" for time in times)


TITLES = {
    # the prefix counts: 100 mmol/m2/s for an hour are 360 mol/m2
    of("PAR [mmol photons/m2/s]"): 3.6e8, of("PPFD (mmol m-2 s-1)"): 3.6e8,
    of("PPFD [nmol/m2/s]"): 360, of("PPFD [mol photons/m2/d]", "86.4"): 3.6e6,  # 1 mmol/m2/s
    of("PAR [µmol photons·cm⁻²·s⁻¹]"): 3.6e9, of("GHI [kW/m2]", "1"): 3.6e6,
    of("Ee [mW/cm2]"): 3.6e6, of("Light [klx]", "1"): 3.6e6,
    # numbers in no unit of light, whatever the name beside them
    of("PAR (mV)"): "mV", of("GHI [counts]"): "counts", of("GHI [ly/min]"): "ly/min",
    of("lux [mV]"): "mV", of("LUX (klux-h)"): "two units", of("fc [foo]"): "foo",
    of("PPFD [%]"): "%", of("PAR [a.u.]"): "a.u", of("lux raw counts"): "counts",
    of("E [lx] ±5%"): "function", of("d(E)/dt [lx]"): "function", of("GHI (0-1)"): "0-1",
    of("DNI [V]"): "V", of("PPFD (adu)"): "adu", of("Lux [bits]"): "bits",
    # PVGIS's irradiances; a coordinate and a word with an s are no units
    of("G(h)"): 3.6e5, of("G(i)"): 3.6e5, of("Gb(n)"): 3.6e5,
    "time,RW,s_cone,lux\n2024-06-01T12:00,1,1,1\n2024-06-01T13:00,1,1,1\n": 3600,
    of("Global (DNI) W/m2"): 3.6e5,
    # a bracket of a place, a statistic or a sensor is no factor
    of("Lux (min)"): 3.6e5, of("PAR (in)"): 3.6e5, of("GHI (s)"): 3.6e5, of("Lux (h)"): 3.6e5,
    of("PPFD (A)"): 3.6e5, of("light [lx] (max)"): 3.6e5, of("E [lx] (sensor 2)"): 3.6e5,
    "time,PAR (in),PAR (out)\n2024-06-01T12:00,1,2\n2024-06-01T13:00,1,2\n": "2 columns of values",
    "time,GHI (s),GHI (n)\n2024-06-01T12:00,1,2\n2024-06-01T13:00,1,2\n": "2 columns of values",
    "time,lux (1),lux (2)\n2024-06-01T12:00,1,2\n2024-06-01T13:00,1,2\n": "2 columns of values",
}  # fmt: skip
TIMES = {
    # 100 lx for an hour: 360000 lx s
    rows("MESS_DATUM", "2019071710", "2019071711"): 3.6e5,
    rows("YYYYMMDDHHMM", "202402241100", "202402241200"): 3.6e5,
    rows("yyyymmddhh", "2024022411", "2024022412"): 3.6e5,
    rows("YYMMDDHHMM", "2402241100", "2402241200"): 3.6e5,
    rows("time", "2019071710", "2019071711"): "a date with its hour, or Unix time",
    rows("time", "1717245300", "1717248900"): "the unit of the times is missing",
    rows("timestamp", "1717245300", "1717248900"): 3.6e5,
    rows("unix", "1717245300", "1717248900"): 3.6e5,
    rows("epoch_ms", "1717245300000", "1717248900000"): 3.6e5,
    rows("time", "20240601120000", "20240601130000"): "may be a date",
    rows("time", "202406011200", "202406011300"): "may be a date",
    rows("Date", "45166.5", "45166.6"): "the unit of the times is missing",  # days of a spreadsheet
    rows("time", "2024153", "2024154"): "may be a date",
    rows("t", "0105", "0205"): "the unit of the times is missing",
    # one delimiter, that of the titles
    rows("time", "20240601 1800", "20240602 0600", "20240603 0000"): 1.08e7,  # 100 lx for 30 h
    "time;E [lx]\n2024-06-01 12:00;0,5\n2024-06-01 13:00;0,5\n": 1800,
    "time\tE [lx]\n20240601 1800\t100\n20240602 0600\t100\n": 4.32e6,
    "time|E [lx]\n1 Jun 2024 12:00|1\n1 Jun 2024 13:00|1\n": "is not a date and time",
    # day and month by all lines; 05/05 has one reading
    rows("time", "4/02/2015 11:00", "4/02/2015 12:00", "13/02/2015 12:00"): 7.812e7,  # 217 h
    rows("time", "05/05/2018 09:00", "05/05/2018 10:00"): 3.6e5,
    rows("time", "1/1/2015 11:00:00 AM", "1/1/2015 12:00:00 PM"): 3.6e5,
    rows("time", "4/02/2015 11:00", "4/02/2015 12:00"): "ambiguous: 2015-02-04 or 2015-04-02",
    rows("time", "05-06-2023 14:00", "05-06-2023 15:00"): "ambiguous",
    rows("time", "01-Jun-2024 11:00", "01-Jun-2024 12:00"): 3.6e5,
    rows("time", "1/Jun/2024 11:00", "1/Jun/2024 12:00"): 3.6e5,
    rows("time", "2024-W22-6T11:00", "2024-W22-6T12:00"): 3.6e5,
    rows("Date (MM/DD/YYYY)", "6/1/2024 11:00", "6/1/2024 12:00"): 3.6e5,
    rows("time", "07/07/03 10:45:40.0", "07/07/03 11:45:40.0"): "a year of 2 digits",
    # the parts of times in columns
    "YEAR,DOY,HHMM,E [lx]\n2019,1,105,100\n2019,1,110,100\n2019,1,115,100\n": 6e4,  # 10 min
    "YEAR,MO,DY,HR,E [lx]\n2020,6,1,10,100\n2020,6,1,11,100\n": 3.6e5,
    "Year,Month,Day,Hour,Minute,E [lx]\n2022,6,1,11,30,100\n2022,6,1,12,30,100\n": 3.6e5,
    "LST_DATE,LST_TIME,E [lx]\n20190101,0955,100\n20190101,1005,100\n": 6e4,
    # whole hours beside dates: 100 lx for 12 h; a number of hours, or hours and minutes, may not be
    "date,hour,E [lx]\n2024-06-01,18,100\n2024-06-02,6,100\n": 4.32e6,
    "date,hh,E [lx]\n2024-06-01,18,100\n2024-06-02,6,100\n": 4.32e6,
    "date,hour,E [lx]\n01/06/2024,18,100\n02/06/2024,6,100\n": "ambiguous",
    "date,hour,E [lx]\n2024-06-01,95,100\n2024-06-01,100,100\n": "is not a time of day",
    "date,hours,E [lx]\n2024-06-01,18,100\n2024-06-02,6,100\n": "may be the time of the dates",
    "date,hhmm,E [lx]\n2024-06-01,18,100\n2024-06-02,6,100\n": "may be the time of the dates",
}  # fmt: skip
ROWS = {
    # series of two sensors in one table
    "id,lux,time\nA,0,2024-06-01T06:00\nB,5,2024-06-01T06:01\n": "the column 'id' has 'A' and",
    "time,device_id,lux\n2024-06-01T06:00,A,0\n2024-06-01T06:01,B,5\n": "'device_id' has 'A' and",
    "time,sensor,lux\n2024-06-01T06:00,1,0\n2024-06-01T06:01,2,5\n": "'sensor' has '1' and '2'",
    "time,flag,lux\n2024-06-01T12:00,ok,100\n2024-06-01T13:00,ok,100\n": 3.6e5,
    "time,flag,lux\n2024-06-01T12:00,ok,100\n2024-06-01T13:00,bad,100\n": "has 'ok' and 'bad'",
    "time,note,lux\n2024-06-01T12:00,,100\n2024-06-01T13:00,lamp on,100\n": 3.6e5,
    # a column of numbers with gaps is no series; a row of units may have unknown ones
    "time,par [umol/m2/s],net\n2024-06-01T12:00,10,\n2024-06-01T13:00,10,1.5\n": 36000,
    "time,Rg,T,v\n-,Wm-2,degC,Knots\n2024-07-23 00:00,10,1,2\n2024-07-23 01:00,10,1,2\n": 36000,
    '"TOA5","X","Y"\n"TIMESTAMP","RECORD","PAR"\n"TS","RN","umol/s/m^2"\n"","","Avg"\n'
    '"2024-06-01 12:00:00",0,10\n"2024-06-01 13:00:00",1,10\n': 36000,
    "date format M/d/yyyy,,\nday,time,lux\n2024-06-01,12:00,1\n2024-06-01,13:00,1\n": 3600,
    # rows that are no data
    of("E [lx]") + "Mean,100\n": "line 4: 'Mean' is not a date",
    of("E [lx]") + "Total:,200\n": "line 4: ",
    "t_s,E [lx]\n0,1\n1,1\nMax,1\n": "line 4: 'Max' is not a number",
    "Name:,E [lx]\nMode:,Sum\nBins:,0\n2024-06-01 19:00,26\n": "between the titles and the",
    # light below 0, and marks
    of("E [lx]") + "2024-06-01T14:00,-99.9\n": "line 4: light below 0",
    of("E [W/m2]") + "2024-06-01T14:00,-1.2\n": "line 4: light below 0",
    of("PPFD") + "2024-06-01T14:00,-0.01\n": "line 4: light below 0",
    of("E [lx]") + "2024-06-01T14:00,-9999\n": "line 4: a value is missing",
    of("E [lx]") + '2024-06-01T14:00,"1,033.3"\n': "line 4: '1,033.3' has a comma",
    # sums of days: 20, 30 and 10 mol/m2 are 60
    "date,DLI [mol/m2/d]\n2024-06-01,20\n2024-06-02,30\n2024-06-03,10\n": 6e7,
    "date,GHI [kWh/m2/day]\n2024-06-01,5\n2024-06-02,6\n": 11 * 3.6e6,
    "date,H [MJ/m2/d]\n2024-06-01,5\n2024-06-03,6\n": 1.1e7,  # 2 June is a gap
    # a line between the titles and the data
    "time,E [lx]\nx,y\n2024-06-01T12:00,1\n2024-06-01T13:00,1\n": "between the titles and the",
}  # fmt: skip
OF_TEXTS = "1,100,OK\n2,200,OK\n3,150,OK\n"
TOLD = [
    (of("E [lx]") + "2024-06-01T14:00,-99.9\n", {"missing": "-99.9"}, 3.6e5),
    (of("E [lx]") + "2024-06-01T14:00,65535\n", {"missing": ["65535", "9999"]}, 3.6e5),
    (of("E [lx]") + "2024-06-01T14:00,bad\n", {"missing": "BAD"}, 3.6e5),
    (of("E [lx]", "101"), {"dark": "1 lx"}, 3.6e5),
    (of("E [klx]", "0.101"), {"dark": "1 lx"}, 3.6e5),
    (of("E [lx]", "100"), {"dark": 100}, 0),
    ("t_s,E [lx]\n0,1\n10,9\n", {"dark": 3}, 20),  # -2 and 6 lx, of which one is noise
    (of("E [lx]", "1"), {"dark": 3}, "add up to less than 0"),
    (of("E [lx]", "1"), {"dark": 0.4, "missing": "1"}, "there is no sample"),
    (of("E [lx]", "1"), {"dark": "3 W"}, "is not in lx"),
    (of("E [lx]", '"1,000"'), {"thousands": ","}, 3.6e6),
    (of("E [lx]", "1.000"), {"thousands": "."}, 3.6e6),
    (of("E [lx]", '"1,00"'), {"thousands": ","}, "groups of three digits"),
    (of("Light [foo]"), {"unit": "lx"}, "unknown unit 'foo'"),
    (of("G(i)"), {"unit": "W/m2"}, 3.6e5),
    (of("Global LI-210 [klux]", "1"), {"unit": "lx"}, 3600),
    (of("RH (%)"), {"unit": "lx"}, "not in a unit of light"),
    (of("RH (%)"), {}, "numbers in %, not in a unit of light"),
    # a column of texts, without titles: 100, 200 and 150 lx at 1, 2 and 3 s
    (OF_TEXTS, {"time_column": 1, "column": 2, "unit": "lx", "time_unit": "s"}, 325),
    (OF_TEXTS, {"time_column": 1, "unit": "lx", "time_unit": "s"}, "2 columns of values"),
    ("1\n2\n", {"unit": "lx", "time_unit": "s"}, "no time and value"),
    ("t,lux\n0,1\n1,1\n", {"time_unit": "h"}, 3600),
    ("t,lux\n45166.5,1\n45167.5,1\n", {"time_unit": "d"}, 86400),
    (rows("time", "2019071710", "2019071711"), {"time_format": "%Y%m%d%H"}, 3.6e5),
    (rows("time", "2019071710", "2019071711"), {"time_unit": "s"}, 100),
    (
        "time,device,lux\n2024-06-01T06:00,A,0\n2024-06-01T06:30,B,5\n2024-06-01T07:00,B,5\n",
        {"where": "device=B"},
        9000,
    ),
    (
        "time,device,lux\n2024-06-01T06:00,A,0\n2024-06-01T06:30,B,5\n2024-06-01T07:00,B,5\n",
        {"where": ["device=*"]},
        4500 + 9000,
    ),
    (
        "time,lux,state\n2024-06-01T12:00,1,on\n2024-06-01T13:00,1,off\n",
        {"invalid": "ignore"},
        "has 'on' and 'off'",
    ),
    (of("E [lx]"), {"where": "device=B"}, "no column 'device'"),
    (of("E [lx]"), {"where": "device"}, "is not COLUMN=VALUE"),
    ("time,id,lux\n2024-06-01T06:00,A,0\n", {"where": "id=C"}, "no row has id=C"),
    (of("E [lx]"), {"time_zone": "Europe/Prague"}, 3.6e5),
    (
        "date,DLI [mol/m2/d]\n2024-06-01,20\n2024-06-02,30\n",
        {"time_zone": "Europe/Prague"},
        "does not apply to the sums of days",
    ),
    # 500 lx of 11:00 end at 11:10, which has no value: 6000 + 5000 + 1000 + 1000 lx min
    (
        rows("time", "2024-06-01 10:00")
        + "2024-06-01 11:00,500\n2024-06-01 11:10,NaN\n2024-06-01 11:50,NaN\n"
        + "2024-06-01 12:00,100\n2024-06-01 12:10,100\n",
        {"samples": "means", "invalid": "ignore"},
        13000 * 60,
    ),
]
ALL = [
    *[(text, {}, right) for some in (TITLES, TIMES, ROWS) for text, right in some.items()],
    *TOLD,
]


@pytest.mark.parametrize(("text", "told", "right"), [*ALL, *TOLD])
def test_a_table_is_right_or_refused(text, told, right, tmp_path):
    path = tmp_path / "log.csv"
    path.write_text(text, "utf-8")
    if isinstance(right, str):
        with pytest.raises(RadcalcError) as refused:
            dose(path, **told)
        assert right in refused.value.message
        assert refused.value.hint
        return
    found = dose(path, **told).exposure
    unit = next(u for u in ("lm*s/m**2", "J/m**2", "umol/m**2") if found.is_compatible_with(u))
    assert found.to(unit).magnitude == pytest.approx(right, rel=1e-12)


@pytest.mark.parametrize(("unit", "value", "is_noted"), [
    ("lx", "3576020.5", True), ("lx", "150000", False), ("klx", "201", True), ("fc", "20000", True),
    ("W/m2", "2100", True), ("W/m2", "1900", False), ("mW/cm2", "210", True),
])  # fmt: skip
def test_a_sample_above_what_the_sun_gives_is_noted_with_its_line(unit, value, is_noted):
    done = run("dose", "-", input=of(f"E [{unit}]", "1") + f"2024-06-01T14:00,{value}\n")
    assert ("more than the sun gives" in done.stderr) == is_noted
    assert ("in line 4 " in done.stderr) == is_noted


def test_a_hint_that_skips_a_line_is_followed_to_its_answer(tmp_path):
    """Between 500 and 600 W/m2 ten minutes apart, straight lines give 330 kJ/m2."""
    path = tmp_path / "log.csv"
    rows = "2021-01-01 12:00,500\n2021-01-01 12:05,-99.9\n2021-01-01 12:10,600\n"
    path.write_text(f"time,E [W/m2]\n{rows}", "utf-8")
    done = run("dose", str(path))
    for way in ("--missing -99.9", "--invalid ignore"):
        assert f"{way} --max-gap 10min\n     exposure 330000 J/m2" in done.stderr


def test_columns_of_light_are_proposed_with_their_sums(tmp_path):
    """By the trapezoids of 10 and 20, and of 20 and 30 W/m2, over an hour."""
    rows = "2024-06-01 10:00,10,20\n2024-06-01 11:00,20,30\n"
    (tmp_path / "log.csv").write_text(f"time,GHI (s),GHI (n)\n{rows}", "utf-8")
    done = run("dose", str(tmp_path / "log.csv"))
    assert "--column 'GHI (s)'\n     exposure 15 Wh/m2" in done.stderr
    assert "--column 'GHI (n)'\n     exposure 25 Wh/m2" in done.stderr
    done = run("dose", "-", input=f"time,T,RH\n{rows}")  # no light, by their titles
    assert "try: --column NAME of T, RH" in done.stderr


@pytest.mark.parametrize(("text", "listed", "said"), [
    # 100, 300 and 200; below them are rows of their own mean and sum
    ("n,E (lx)\n1,100\n2,300\n3,200\nMean,200\nSum,600\n", ["3\t100\t300\t200"], "line 5: 'Mean"),
    ('t,lx\n2024-06-01,"1,033.3"\n2024-06-02,900.5\n', ["1\t900.5\t900.5"], "'1,033.3' in line 2"),
    ("1,100,OK\n2,200,OK\n3,150,OK\n", ["3\t100\t200\t150"], "3 rows"),
    ("Meter,LI,,\n,,,\nPoint,X (m),Y (m),E (lx)\n1,0,0,1\n2,1,0,3\n", ["E (lx)\tlx\t2"], "2 rows"),
    ("time,L [cd/m2]\n2024-06-01,1\n2024-06-02,2\n", ["convert - cd/m2"], "2 rows"),
    ("time,lux\n4/02/2015,1\n5/02/2015,2\n", ["convert - lux"], "2 rows"),
    ("time,lux\n2024-06-01,1\n2024-06-02,-2\n", ["convert - lux"], "2 rows"),
    ("time,lux\n2024-06-01,1\n2024-06-02,2\n", ["radcalc dose"], "2 rows"),
])  # fmt: skip
def test_columns_lists_what_is_data_and_proposes_what_answers(text, listed, said, tmp_path):
    path = tmp_path / "log.csv"
    path.write_text(text, "utf-8")
    done = run("columns", str(path))
    assert all(one in done.stdout for one in listed), done.stdout
    assert said in done.stderr
