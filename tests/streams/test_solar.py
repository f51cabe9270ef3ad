"""Public formats of the sun: files written here, with sums worked out by hand.

All sums are in W h/m2, over steps of an hour unless a comment says otherwise.
"""

import os
import sys
import warnings

import pytest
from conftest import run

import radcalc
from radcalc.errors import ConditionError, RadcalcError
from radcalc.files.signatures import of_sun
from radcalc.streams.solar import FORMATS, READERS

try:
    import pvlib  # noqa: F401
except ImportError:
    if os.environ.get("CI"):
        raise
    pytest.skip("pvlib is not installed", allow_module_level=True)


def epw(*rows, zone="2.0", per_hour=1):
    """Return an EPW of rows: the time as Y,M,D,H, the ghi, and the global illuminance."""
    head = [f"LOCATION,Somewhere,-,XYZ,own,123450,50.10,14.40,{zone},300.0", "DESIGN CONDITIONS,0"]
    head += ["TYPICAL/EXTREME PERIODS,0", "GROUND TEMPERATURES,0"]
    head += ["HOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0", "COMMENTS 1,own numbers", "COMMENTS 2,"]
    head += [f"DATA PERIODS,1,{per_hour},Data,Sunday, 1/ 1,12/31"]
    data = [
        f"{time},60,?9?9,20.0,10.0,50,98000,9999,9999,350,{ghi},9999,80,{lux},999999,999999,9999,"
        "180,3.0,5,5,20.0,7777,9,999999999,10,0.1,0,88,0.2,0.0,0.0"
        for time, ghi, lux in rows
    ]
    return "\n".join(head + data) + "\n"


# The hour 10 is that from 9:00 to 10:00; 100 + 300 + 200 = 600.
EPW = epw(
    ("2021,7,1,10", 100, 10000), ("2021,7,1,11", 300, 30000), ("2021,7,1,12", 200, 20000)
)  # fmt: skip
# Typical months: February is of 1996, which had 29 days, and March of 1988.  24:00 on the 28th is
# in the 28th, whose sum is 10 + 20; that of 1 March is 30.
TMY3 = """\
700001,"OWN PLACE",XX,-9.0,64.800,-147.900,138
Date (MM/DD/YYYY),Time (HH:MM),ETR (W/m^2),GHI (W/m^2),GHI source,GH illum (lx)
02/28/1996,23:00,100,10,1,1000
02/28/1996,24:00,100,20,1,2000
03/01/1988,01:00,100,30,1,-9900
"""
# 9:00 to 11:00: 100 + 200 = 300, where a trapezoid between the samples would be 150.
NSRDB = """\
Source,Location ID,City,State,Country,Latitude,Longitude,Time Zone,Elevation,Local Time Zone,\
DHI Units,DNI Units,GHI Units
NSRDB,1,-,-,-,40.5,-108.5,-7,2000,-7,w/m2,w/m2,w/m2
Year,Month,Day,Hour,Minute,DHI,GHI,Clearsky GHI,Temperature
2019,6,1,9,30,50,100,120,11.5
2019,6,1,10,30,60,200,220,12.5
"""


def placed(*cells):
    """Return a line with texts that end at columns."""
    line = ""
    for end, text in cells:
        line = line.ljust(end - len(text)) + text
    return line + "\n"


def bsrn(*rows):
    """Return a BSRN file of days, minutes, ghi and longwave radiation."""
    head = "*U0001\n 99 07 2020  1\n   2   3   4\n*U0004\n 01 00 00\n 1  2\nOwn street 1\n"
    head += "000000               000000\n0.0.0.0         a@b.cz\n 140.100 194.400  300 none\n"
    head += " 01 00 00\n  0  1 90  2 -1 -1\n*U0100\n"
    return head + "".join(
        placed((3, str(day)), (9, str(minute)), (16, str(ghi)), (22, "1.0"), (39, "-999"))
        + placed((16, "50"), (39, str(longwave)), (64, "20.0"), (70, "50.0"), (75, "990"))
        for day, minute, ghi, longwave in rows
    )


BSRN = bsrn((1, 0, 60, 300), (1, 1, 120, 310))  # two minutes: (60 + 120)/60 = 3


def noaa(head, width, *rows):
    """Return a file of SURFRAD or SOLRAD, of minutes and ghi with their flags."""
    rest = " ".join(["-9999.9 1"] * (width // 2 - 5))
    rest += " 0.1" * (width - 10 - 2 * (width // 2 - 5))
    return head + "".join(
        f" 2020 183  7  1 12 {minute:2}  12.0 30.0 {ghi} {flag} {rest}\n"
        for minute, ghi, flag in rows
    )


# Two minutes, labelled at their ends: (600 + 300)/60 = 15.
MINUTES = (1, 600.0, 0), (2, 300.0, 2)
SURFRAD = noaa(" Own place\n   40.10  -100.20 500 m version 1\n", 48, *MINUTES)
SOLRAD = noaa(" Own place\n   40.10000 -100.20000 500 -7 version 1\n", 22, *MINUTES)
MADISON = noaa(" Own place\n   40.10000 -100.20000 500 -7 version 1\n", 31, *MINUTES)
MIDC = """\
DATE (MM/DD/YYYY),PST,ghi [W/m^2],Air Temperature [W/m^2],PIR [W/m^2],Zenith Angle [degrees]
07/01/2020,12:01,600,20,300,30
07/01/2020,12:02,300,20,300,30
"""
MIDC_RAW = """\
,Year,DOY,MST,ghi [W/m^2],Battery [VDC]
0,2020,183,1201,600,12.5,-7999
0,2020,183,1202,300,12.5,-7999
"""
CRN = "".join(
    f"99999 20200701 {stamp} 20200701 0505      3 -111.20   32.20    20.0     0.0 {ghi:6} 0"
    "    30.0 C 0    50 0 -99.000 -9999.0  1000 0   1.00 0\n"
    for stamp, ghi in (("1205", 600), ("1210", 300))
)
PVGIS = """\
Latitude (decimal degrees):\t45.100
Longitude (decimal degrees):\t8.200
Elevation (m):\t250
Radiation database:\tPVGIS-SARAH2

Slope: 30 deg.
Azimuth: 0 deg.
time,G(i),H_sun,T2m,WS10m,Int
20200701:1010,100.0,40.0,20.0,1.0,0.0
20200701:1110,300.0,45.0,21.0,1.0,0.0

G(i): Global irradiance on the inclined plane (W/m2)
"""


def pvgis_tmy():
    """Return a typical year of zeros, but for 100 and 300 at 10 and 11 o'clock on 1 July."""
    lines = ["Latitude (decimal degrees): 45.100", "Longitude (decimal degrees): 8.200"]
    lines += ["Elevation (m): 250.0", "Irradiance Time Offset (h): 0.25", "month,year"]
    lines += [f"{month},{2005 + month % 3}" for month in range(1, 13)]
    lines += ["time(UTC),T2m,RH,G(h),Gb(n),Gd(h),IR(h),WS10m,WD10m,SP"]
    for month, days in enumerate((31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31), 1):
        for hours in range(24 * days):
            day, hour = hours // 24 + 1, hours % 24
            light = {10: 100.0, 11: 300.0}.get(hour, 0.0) if (month, day) == (7, 1) else 0.0
            stamp = f"{2005 + month % 3}{month:02}{day:02}:{hour:02}00"
            lines.append(f"{stamp},10.0,50.0,{light},0.0,0.0,300.0,1.0,100.0,99000.0")
    return "\n".join([*lines, "", "G(h): Global irradiance (W/m2)"]) + "\n"


def cams(period="0 year 0 month 0 day 0 h 15 min 0 s", reference="Universal time (UT)"):
    """Return two quarters of an hour, with 25 and 50 Wh/m2."""
    return f"""\
# Coding: utf-8
# File format version: 2
# Title: CAMS Radiation Service v3.2 all-sky irradiation (derived from satellite data).
# Latitude (positive North, ISO 19115): 50.1
# Time reference: {reference}
# Summarization (integration) period: {period}
# noValue: nan
#
# Observation period;TOA;GHI;Reliability
2020-07-01T12:00:00.0/2020-07-01T12:15:00.0;75.0;25.0;1.0
2020-07-01T12:15:00.0/2020-07-01T12:30:00.0;75.0;50.0;1.0
"""


FILES = {
    "EPW": (EPW, "ghi", 600, "2021-07-01 10:00:00+02:00"),
    "TMY3": (TMY3, "ghi", 60, "2001-03-01 01:00:00-09:00"),
    "NSRDB PSM": (NSRDB, "ghi", 300, "2019-06-01 10:30:00-07:00"),
    "BSRN": (BSRN, "ghi", 3, "2020-07-01 00:01:00+00:00"),
    "SURFRAD": (SURFRAD, "ghi", 15, "2020-07-01 12:01:00+00:00"),
    "SOLRAD": (SOLRAD, "ghi", 15, "2020-07-01 12:01:00+00:00"),
    "MIDC": (MIDC, "ghi", 15, "2020-07-01 12:01:00-08:00"),
    "MIDC (raw)": (MIDC_RAW, "ghi", 15, "2020-07-01 12:01:00-07:00"),
    "CRN": (CRN, "ghi", 75, "2020-07-01 12:05:00+00:00"),  # (600 + 300)/12
    "PVGIS hourly": (PVGIS, "poa_global", 200, "2020-07-01 11:10:00+00:00"),  # the trapezoid
    # 100/2 + (100 + 300)/2 + 300/2; the times are those of the satellite, a quarter of an hour late
    "PVGIS TMY": (pvgis_tmy(), "ghi", 400, "2001-07-01 11:15:00+00:00"),
    "CAMS": (cams(), "ghi", 75, "2020-07-01 12:15:00+00:00"),  # Wh/m2 of each period
}


def written(tmp_path, text, name="own.txt"):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return str(path)


def test_each_format_has_a_file():
    assert set(FILES) == set(FORMATS) == set(READERS)


@pytest.mark.parametrize("kind", FILES)
def test_each_format_is_summed_by_its_own_convention(kind, tmp_path):
    text, column, total, peak = FILES[kind]
    path = written(tmp_path, text)
    done = run("dose", path, "--column", column, "-g", "exposure:Wh/m2")
    assert float(done.stdout) == pytest.approx(total, rel=1e-12), done.stderr
    assert f"assumed: {kind}: " in done.stderr
    assert FORMATS[kind].words in done.stderr or "hourly" in kind
    assert f"at {peak}" in done.stderr
    answer = radcalc.dose(path, column=column)
    assert answer.exposure.to("W h/m2").magnitude == pytest.approx(total, rel=1e-12)


@pytest.mark.parametrize("kind", FILES)
def test_columns_lists_what_dose_reads_and_its_commands_run(kind, tmp_path):
    path = written(tmp_path, FILES[kind][0])
    done = run("columns", path, "--format", "csv")
    assert done.returncode == 0, done.stderr
    commands = [row.rpartition(",")[2] for row in done.stdout.splitlines() if "radcalc dose" in row]
    assert commands
    for command in commands:
        words = command.replace(path, "FILE").strip('"').split(" --column ")
        name, _, rest = words[1].partition(" --invalid ")
        ignore = ["--invalid", rest] if rest else []
        assert run("dose", path, "--column", name.strip("'"), *ignore).returncode == 0, command


@pytest.mark.parametrize(
    ("kind", "titles"),
    [
        ("EPW", ["etr", "ghi_infrared (longwave)", "global_hor_illum [lx]"]),
        ("BSRN", ["dhi [W/m2]", "lwd (longwave) [W/m2]"]),
        ("SURFRAD", ["dw_ir (longwave)", "uvb [mW/m2]", "par [W/m2]"]),
        ("MIDC", ["longwave PIR [W/m^2]"]),
    ],
)
def test_light_alone_is_in_the_table_with_its_units(kind, titles, tmp_path):
    listed = run("columns", written(tmp_path, FILES[kind][0])).stdout
    assert all(title in listed for title in titles)
    assert not any(word in listed for word in ("temp", "Temp", "std", "flag", "Zenith", "netsolar"))


def test_several_columns_need_a_choice_and_longwave_has_no_spectrum(tmp_path):
    path = written(tmp_path, EPW)
    done = run("dose", path)
    assert (done.returncode, done.stdout) == (2, "")
    assert "columns of values" in done.stderr
    assert "--column" in done.stderr
    assert "ghi [W/m2]" in done.stderr
    done = run("dose", path, "--column", "ghi_infrared (longwave)", "--spectrum", "sun")
    assert done.returncode == 2
    assert "another light" in done.stderr


def test_days_are_split_where_the_intervals_end(tmp_path):
    """24:00 of 28 February is in that day, and 29 February is not in a typical year."""
    done = run(
        "dose", written(tmp_path, TMY3), "--column", "ghi", "--by", "day", "-g", "exposure:Wh/m2",
        "--format", "csv", check=True,
    )  # fmt: skip
    assert [line.split(",")[-1] for line in done.stdout.splitlines()[1:]] == ["30.0", "30.0"]
    assert "2001-02-28" in done.stdout
    assert "the months are of several years, and are put in 2001" in done.stderr


def test_29_february_of_a_real_year_stays_that_day(tmp_path):
    text = TMY3.splitlines()[:2]
    text += [f"02/29/2020,{hour:02}:00,0,{hour},1,0" for hour in range(1, 25)]
    text += ["03/01/2020,01:00,0,7,1,0"]
    done = run(
        "dose", written(tmp_path, "\n".join(text)), "--column", "ghi", "--by", "day",
        "-g", "exposure:Wh/m2", "-n", check=True,
    )  # fmt: skip
    assert done.stdout.split() == ["300", "7"]  # 1 + 2 + ... + 24


def test_a_real_season_over_the_turn_of_the_year_keeps_its_years(tmp_path):
    text = epw(("2021,12,31,24", 10, 0), ("2022,1,1,1", 20, 0))
    done = run("dose", written(tmp_path, text), "--column", "ghi", check=True)
    assert "2022-01-01 00:00:00+02:00" in done.stderr
    assert "several years" not in done.stderr


@pytest.mark.parametrize(
    ("text", "column", "total"),
    [
        (epw(("2021,7,1,10", 9999, 0), ("2021,7,1,11", 300, 0), ("2021,7,1,12", 100, 0)),
         "ghi", 400),
        (epw(("2021,7,1,10", 1, 999900), ("2021,7,1,11", 1, 30), ("2021,7,1,12", 1, 10)),
         "global_hor_illum", 40),
        (TMY3.replace(",30,1,-9900", ",-9900,1,0"), "ghi", 30),
        (SURFRAD + noaa("", 48, (3, 90, 1)), "ghi", 15),  # a bad flag; 2 is doubtful, and kept
        (SURFRAD + noaa("", 48, (3, -9999.9, 0)), "ghi", 15),
        (MIDC + "07/01/2020,12:03,-99999,20,300,30\n", "ghi", 15),
        (CRN + CRN.splitlines()[1].replace("1210", "1215").replace("300 0", "300 3") + "\n",
         "ghi", 75),
        (CRN + CRN.splitlines()[1].replace("1210", "1215").replace("   300", "-99999"), "ghi", 75),
        (bsrn((1, 0, 60, 300), (1, 1, 120, 310), (1, 2, -999, 300)), "ghi", 3),
        (cams().replace(";75.0;25.0;", ";75.0;nan;"), "ghi", None),
    ],
)  # fmt: skip
def test_missing_values_are_refused_or_left_out(text, column, total, tmp_path):
    path = written(tmp_path, text)
    done = run("dose", path, "--column", column)
    assert (done.returncode, done.stdout) == (2, "")
    assert ", row " in done.stderr
    assert "a value is missing" in done.stderr
    assert ("--invalid ignore" in done.stderr) == (total is not None)  # a call that answers
    if total is not None:
        kind = "illuminance" in run("dose", path, "--column", column, "--invalid", "ignore").stdout
        unit = "lx.h" if kind else "Wh/m2"
        done = run(
            "dose", path, "--column", column, "--invalid", "ignore", "-g", f"exposure:{unit}"
        )
        assert float(done.stdout) == pytest.approx(total), done.stderr


def test_solrad_of_madison_is_known_by_its_columns_and_not_by_its_name(tmp_path):
    for name in ("plain.dat", "msn20183.dat"):
        for text in (MADISON, SOLRAD):
            done = run(
                "dose", written(tmp_path, text, name), "--column", "ghi", "-g", "exposure:Wh/m2"
            )
            assert float(done.stdout) == pytest.approx(15), done.stderr


def test_an_epw_of_pvgis_has_values_at_the_times_of_the_satellite(tmp_path):
    """The hour 11 ends at 11:00, and its value is of 0.75 h before that, in UTC.

    The typical year of PVGIS for 45 N, 8 E has the same rows as EPW, with the zone 1, and as CSV,
    in UTC; its light has its centre at 11.5, and noon at 8 E is 11.47 in UTC.
    """
    text = EPW.replace("COMMENTS 2,", "COMMENTS 2,Irradiance Time Offset (h):-0.75")
    done = run("dose", written(tmp_path, text), "--column", "ghi", "-g", "exposure:Wh/m2")
    assert float(done.stdout) == 450  # (100 + 300)/2 + (300 + 200)/2
    assert "2021-07-01 10:15:00+00:00" in done.stderr
    assert "assumed: EPW: values at the times of satellite pictures" in done.stderr


def test_true_solar_time_is_not_utc(tmp_path):
    text = cams(reference="True solar time (TST)")
    done = run("dose", written(tmp_path, text), "--column", "ghi", "-g", "exposure:Wh/m2")
    assert done.stdout == "75\n"
    assert "+00:00" not in done.stderr


def test_samples_of_the_call_win_over_those_of_the_format(tmp_path):
    path = written(tmp_path, EPW)
    done = run("dose", path, "--column", "ghi", "--samples", "points", "-g", "exposure:Wh/m2")
    assert done.stdout == "450\n"
    assert "--samples points replaces the format's own" in done.stderr
    assert "trapezoidal" in done.stderr
    answer = radcalc.dose(path, column="ghi", samples="means")
    assert answer.exposure.to("W h/m2").magnitude == pytest.approx(600)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        (EPW.replace(",2.0,", ",two,", 1), "EPW"),
        (epw(("2021,13,1,10", 1, 1), ("2021,13,1,11", 1, 1)), "EPW"),
        (epw(("2021,7,1,10", 1, 1), ("2021,7,1,11", 1, 1), per_hour=4), "EPW"),
        (TMY3.replace("24:00", "noon"), "TMY3"),
        (NSRDB.replace(",-7,2000", ",5.5,2000"), "NSRDB PSM"),
        (BSRN[:60], "BSRN"),
        (SURFRAD.replace("  1 12  1 ", "  1 99  1 "), "SURFRAD"),
        ("\n".join(SURFRAD.splitlines()[:2]) + "\n", "SURFRAD"),
        (MIDC.replace("12:01", "25:61"), "MIDC"),
        (MIDC_RAW.replace("2020,183", "2020,999"), "MIDC (raw)"),
        (CRN.replace("20200701 1205", "20209901 1205"), "CRN"),
        (PVGIS.replace("100.0", "many"), "PVGIS hourly"),
        (pvgis_tmy()[:-5000], "PVGIS TMY"),
        (cams("0 year 1 month 0 day 0 h 0 min 0 s"), "CAMS"),
        (cams("of a while"), "CAMS"),
    ],
)
def test_a_damaged_file_is_refused_by_its_format(text, kind, tmp_path):
    path = written(tmp_path, text)
    for command in ("dose", "columns"):
        done = run(command, path)
        assert (done.returncode, done.stdout) == (2, ""), done.stdout
        assert f"is not readable as {kind}: " in done.stderr, done.stderr
    with pytest.raises(RadcalcError, match="is not readable as"):
        radcalc.dose(path)


def test_a_bad_number_is_named_with_its_row(tmp_path):
    done = run("dose", written(tmp_path, EPW.replace(",300,", ",3OO,")), "--column", "ghi")
    assert done.returncode == 2
    assert "row 2: '3OO' is not a number" in done.stderr


@pytest.mark.parametrize("kind", FILES)
def test_without_pvlib_the_format_and_the_extra_are_named(kind, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pvlib", None)
    path = written(tmp_path, FILES[kind][0])
    for words in (["dose", path, "--column", "ghi"], ["columns", path], [path]):
        done = run(*words)
        assert (done.returncode, done.stdout) == (2, "")
        assert f"is {kind}, which needs the package pvlib, which is missing" in done.stderr
        assert "pip install 'radcalc[solar]'" in done.stderr
    with pytest.raises(ConditionError, match="pvlib"):
        radcalc.dose(path)
    ordinary = written(tmp_path, "time,E_lx\n2024-06-01T12:00,1\n2024-06-01T13:00,1\n")
    assert run("dose", ordinary, "-g", "exposure:lx.h").stdout == "1\n"


def test_readers_give_no_warnings(tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for text, column, *_ in FILES.values():
            radcalc.dose(written(tmp_path, text), column=column)


@pytest.mark.parametrize(
    "text",
    [
        "time,E_lx\n2024-06-01T12:00,1\n",
        "LOCATION,E_lx\n1,2\n",
        "# Coding: utf-8\n# Title: CAMS Radiation\n# Observation\n",  # pvlib would read for ever
        "Latitude (decimal degrees): 45\nLongitude (decimal degrees): 8\n",
        "",
    ],
)
def test_other_files_are_not_taken_for_a_format(text):
    assert of_sun(text.splitlines()) == ""


def test_the_zero_of_a_pyranometer_is_kept_in_a_network(tmp_path):
    # means of minutes: (-1.2 + 61.2) W/m2 for a minute each are 1 Wh/m2
    path = tmp_path / "midc.csv"
    head = "DATE (MM/DD/YYYY),MST,Global [W/m^2]\n06/01/2024,05:01,"
    path.write_text(f"{head}-1.2\n06/01/2024,05:02,61.2\n")
    done = run("dose", str(path), "-g", "exposure:Wh/m2")
    assert done.stdout == "1\n"
    assert "noise in the dark: a sample below 0, down to -1.2" in done.stderr
    path.write_text(f"{head}-4.5\n06/01/2024,05:02,61.2\n")
    assert "light below 0 without --dark: '-4.5'" in run("dose", str(path)).stderr
