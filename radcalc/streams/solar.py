"""Public formats of the sun, of weather years, networks and satellites: each as a plain table.

pvlib reads a file, and `read` returns its columns of light as the lines of a table with times in
ISO 8601, which the reader of logs takes like any other.
"""

import re
import warnings
from collections.abc import Callable, Sequence
from io import BytesIO, StringIO
from typing import Any, NamedTuple

from radcalc.calculators.dose_sums import MEANS, MEANS_BEFORE, MEANS_CENTRED, POINTS
from radcalc.errors import ConditionError, RadcalcError, quote
from radcalc.files import signatures
from radcalc.quantities import read as read_light
from radcalc.quantities.column_titles import read_title

INSTALL = "pip install 'radcalc[solar]'"
AS_DOWNLOADED = "the whole file, as it was downloaded"
WATTS = """
    ghi dni dhi bhi etr etrn ghi_extra dni_extra ghi_clear dni_clear dhi_clear bhi_clear uw_solar
    poa_global poa_direct poa_sky_diffuse poa_ground_diffuse par
"""
LONGWAVE = ("ghi_infrared", "dw_ir", "uw_ir", "lwd", "dpir", "IR(h)")
TITLES = {
    **{name: f"{name} [W/m2]" for name in WATTS.split()},
    **{name: f"{name} (longwave) [W/m2]" for name in LONGWAVE},
    **{
        f"{name}_illum": f"{name}_illum [lx]"
        for name in ("global_hor", "direct_normal", "diffuse_horizontal")
    },
    "uvb": "uvb [mW/m2]",
}
OF_INFRARED = re.compile(r"\b(?:IR|PIR|CGR4|infrared|pyrgeometer)\b", re.IGNORECASE)
NO_LIGHT = re.compile(r"\bnet\b|temp|\bstd", re.IGNORECASE)  # MIDC has temperatures in W/m^2, too
# Marks of missing values: 9999 W/m2 and 999900 lx of EPW, which pvlib 0.16.1 keeps, and -9900,
# -99999, -7999 and the like of others.
LEAST, MOST, MOST_LUX = -900.0, 9999.0, 999900.0
BAD_FLAGS = (1, 3)  # of the network: of SURFRAD and SOLRAD, and of CRN
# The zero of a pyranometer at night [W/m2]: the physically possible limit of BSRN (C. N. Long and
# E. G. Dutton, recommended QC tests V2.0).
ZERO_OF_PYRANOMETERS = -4.0
OFFSET = re.compile(r"Irradiance Time Offset \(h\):\s*(-?\d+(?:\.\d+)?)")  # of PVGIS
PER_HOUR = re.compile(r"^DATA PERIODS,\d+,(?!1,)(\d+)", re.MULTILINE)
COMMON_YEAR, LEAP_YEAR = 2001, 2000  # of the months of several years


class Format(NamedTuple):
    """What the values of a format are: a setting of `--samples`, words for it, the least zero."""

    samples: str
    words: str
    least: float = 0.0


SATELLITE = Format(POINTS, "values at the times of satellite pictures")
END_OF_MINUTES = Format(
    MEANS_BEFORE, "means of minutes, labelled at their end", ZERO_OF_PYRANOMETERS
)
FORMATS = {
    signatures.EPW: Format(MEANS, "means of hours, labelled at their start (hour 1 is 00:00)"),
    signatures.TMY3: Format(MEANS_BEFORE, "means, labelled at the end of their interval"),
    signatures.NSRDB: Format(MEANS_CENTRED, "values for the interval around their time"),
    signatures.BSRN: Format(
        MEANS, "means of minutes, labelled at their start", ZERO_OF_PYRANOMETERS
    ),
    signatures.SURFRAD: END_OF_MINUTES,
    signatures.SOLRAD: END_OF_MINUTES,
    signatures.MIDC: END_OF_MINUTES,
    signatures.MIDC_RAW: END_OF_MINUTES,
    signatures.CRN: Format(
        MEANS_BEFORE, "means of five minutes, labelled at their end", ZERO_OF_PYRANOMETERS
    ),
    signatures.PVGIS: SATELLITE,
    signatures.PVGIS_TMY: SATELLITE,
    signatures.CAMS: Format(MEANS, "means of their period, labelled at its start"),
}


class SunTable(NamedTuple):
    """The lines of a table, what its samples are, what that assumes, and the least zero."""

    lines: list[str]
    samples: str
    assumption: str
    least: float = 0.0


def read(kind: str, name: str, lines: Sequence[str]) -> SunTable:
    """Return the columns of light of a file of a format; raise a ConditionError for a bad one."""
    try:
        import pandas
        from pvlib import iotools
    except ImportError:
        problem = f"{name} is {kind}, which needs the package pvlib, which is missing"
        raise ConditionError(problem, INSTALL) from None
    text = "\n".join(lines) + "\n"
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            frame = READERS[kind](iotools, pandas, text)
            assumption = _in_one_year(frame)
            of_format = FORMATS[kind]
            if offset := OFFSET.search(text):
                of_format, hours = SATELLITE, float(offset[1])
                if kind == signatures.EPW:
                    # PVGIS counts from the end of an hour, which pvlib labels at its start, and
                    # from UTC, whatever zone its first line has.
                    hours += 1
                    frame.index = frame.index.tz_localize(None).tz_localize("UTC")
                frame.index += pandas.to_timedelta(round(3600 * hours), unit="s")
            table = _lines(frame)
    except RadcalcError:
        raise
    except Exception as error:  # of any kind: these readers check little
        # texts of other classes are about Python's objects
        text = str(error) if isinstance(error, ValueError) else "it has another layout"
        problem = f"{name} is not readable as {kind}: {quote(' '.join(text.split()))}"
        raise ConditionError(problem, AS_DOWNLOADED) from None
    if len(table[0].split("\t")) < 2:
        raise ConditionError(f"{name} is {kind} without a column of light", AS_DOWNLOADED)
    said = f"{kind}: {of_format.words}{assumption}"
    return SunTable(table, of_format.samples, said, of_format.least)


def _lines(frame: Any) -> list[str]:
    """Return the lines of a table: the times, and the columns of light with their units."""
    columns = [[time.isoformat() for time in frame.index]]
    titles = ["time"]
    for name, series in frame.items():
        title = TITLES.get(name) or _title(str(name))
        if title:
            flags = frame.get(f"{name}_flag")
            values = series if flags is None else series.mask(flags.isin(BAD_FLAGS))
            most = MOST_LUX if re.search(r"\Wlx\W", title) else MOST
            titles.append(title)
            columns.append([_cell(value, most) for value in values.tolist()])
    return ["\t".join(row) for row in (titles, *zip(*columns, strict=True))]


def _cell(value: Any, most: float) -> str:
    if isinstance(value, (int, float)) and not LEAST < value < most:
        return "nan"  # also of nan
    return " ".join(str(value).split())


def _title(name: str) -> str:
    """Return the title of a column that has the unit of an irradiance in it; "" for others."""
    name = name.replace("))", ")")  # DNI (W/m^2)) of SolarAnywhere
    try:
        unit = read_title(name).unit
    except RadcalcError:
        return ""
    light = read_light(unit) if unit else None
    if light is None or light.geometry != (0, 1, 0) or light.time or NO_LIGHT.search(name):
        return ""
    return f"longwave {name}" if OF_INFRARED.search(name) else name


def _in_one_year(frame: Any) -> str:
    """Put typical months, which are of several years, in one year; return a remark on that.

    A frame has the day of each time, `attrs["days"]`, if a time of 24:00 is on the next one.
    """
    days = frame.attrs.pop("days", frame.index.normalize())
    months = dict.fromkeys(zip(days.year, days.month, strict=True))
    of_year = [month for _, month in months]
    if len({year for year, _ in months}) < 2 or of_year != sorted({*of_year}):
        return ""
    is_leap = bool(((days.month == 2) & (days.day == 29)).any())
    year = LEAP_YEAR if is_leap else COMMON_YEAR
    clocks = frame.index - days
    frame.index = days.map(lambda day: day.replace(year=year)) + clocks
    return f"; the months are of several years, and are put in {year}"


def _of_epw(iotools: Any, pandas: Any, text: str) -> Any:
    if found := PER_HOUR.search(text):  # pvlib 0.16.1 drops the minutes
        raise ValueError(f"it has {found[1]} values per hour")
    return iotools.read_epw(StringIO(text))[0]


def _of_tmy3(iotools: Any, pandas: Any, text: str) -> Any:
    """Read TMY3, without the dates of pvlib 0.16.1, which puts all 29 February on 1 March."""
    frame = iotools.read_tmy3(StringIO(text))[0]
    days = pandas.DatetimeIndex(
        pandas.to_datetime(frame["Date (MM/DD/YYYY)"], format="%m/%d/%Y")
    ).tz_localize(frame.index.tz)
    frame.index = days + pandas.to_timedelta(frame["Time (HH:MM)"] + ":00").array
    frame.attrs["days"] = days
    return frame


def _of_noaa(iotools: Any, pandas: Any, text: str) -> Any:
    """Read SURFRAD or SOLRAD, by the number of columns.

    pvlib 0.16.1 reads only files with a name, and takes SOLRAD for that of Madison by "msn" there.
    """
    from pvlib.iotools import solrad, surfrad

    names = {
        len(names): names
        for names in (surfrad.SURFRAD_COLUMNS, solrad.HEADERS, solrad.MADISON_HEADERS)
    }[len(text.splitlines()[2].split())]
    frame = pandas.read_csv(StringIO(text), sep=r"\s+", skiprows=2, header=None, names=names)
    parts = frame[["year", "month", "day", "hour", "minute"]].astype(str)
    stamps = pandas.to_datetime(parts.agg("-".join, axis=1), format="%Y-%m-%d-%H-%M", utc=True)
    frame.index = pandas.DatetimeIndex(stamps)
    return frame.rename(columns=surfrad.VARIABLE_MAP)


def _of_midc(iotools: Any, pandas: Any, text: str, is_raw: bool = False) -> Any:
    titles = text.partition("\n")[0].split(",")  # lines of raw data may be longer
    return iotools.read_midc(StringIO(text), raw_data=is_raw, usecols=range(len(titles)))


def _of_cams(iotools: Any, pandas: Any, text: str) -> Any:
    frame, facts = iotools.read_cams(StringIO(text), label="left")
    if facts["time_step"] == "1M":
        raise ValueError("its months have different lengths; ask for days or hours")
    frame.index = frame.index.tz_localize(None)
    # pvlib 0.16.1 calls true solar time UTC, too
    is_solar = "solar" in facts.get("Time reference", "").lower()
    return frame if is_solar else frame.tz_localize("UTC")


Reader = Callable[[Any, Any, str], Any]
READERS: dict[str, Reader] = {
    signatures.EPW: _of_epw,
    signatures.TMY3: _of_tmy3,
    signatures.NSRDB: lambda iotools, _, text: iotools.read_nsrdb_psm4(StringIO(text))[0],
    signatures.BSRN: lambda iotools, _, text: iotools.read_bsrn(StringIO(text))[0],
    signatures.SURFRAD: _of_noaa,
    signatures.SOLRAD: _of_noaa,
    signatures.MIDC: _of_midc,
    signatures.MIDC_RAW: lambda iotools, pandas, text: _of_midc(iotools, pandas, text, True),
    signatures.CRN: lambda iotools, _, text: iotools.read_crn(StringIO(text)),
    signatures.PVGIS: lambda iotools, _, text: iotools.read_pvgis_hourly(StringIO(text), "csv")[0],
    signatures.PVGIS_TMY: lambda iotools, _, text: iotools.read_pvgis_tmy(
        BytesIO(text.encode()), "csv"
    )[0],
    signatures.CAMS: _of_cams,
}
