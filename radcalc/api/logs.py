"""Logs of light: files, and readings with times in memory."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from datetime import date, timedelta
from io import BytesIO
from typing import Any, overload
from warnings import warn

import numpy

from radcalc.answer import ShownInput, texts_of
from radcalc.api import arguments
from radcalc.api.arguments import in_words
from radcalc.api.columns import Invalid, Period, Readings, Samples, Times
from radcalc.api.conversion import as_array
from radcalc.api.functions import calculate, of_page
from radcalc.api.result import Result, Undrawn, of_answer
from radcalc.calculators.dose import READINGS
from radcalc.calculators.page import PERIODS
from radcalc.errors import ConditionError, LineError, MissingInput, mention
from radcalc.files import reading as opened
from radcalc.inputs import refuse_uncertain, shown_inputs
from radcalc.quantities.symbols import article
from radcalc.streams.clocks import TimeSettings
from radcalc.streams.log_layout import LogSettings, rows_where
from radcalc.streams.samples import EXPECTED, Log, LogDose
from radcalc.terminal import ABORT, IGNORE, WARN

TAB = "\t"
TIMES = "times as the second argument, or a Series of pandas with a DatetimeIndex"
SKIPPING = ABORT, WARN, IGNORE
UNDRAWN = Undrawn("a part of a log has no picture", "the whole log, without by")

# The name of a log, and what reads its bytes.
Source = AbstractContextManager[tuple[str, Callable[[int], bytes]]]


def _of_readings(readings: Any, times: Any, chosen: LogSettings) -> tuple[LogSettings, Source]:
    """Return the settings of readings in memory, and their text with that of their times."""
    if chosen.column or chosen.times or chosen.where:
        raise ConditionError("readings in memory have no columns to choose", "a file")
    values = as_array(readings) if isinstance(readings, (list, tuple)) else readings
    of_values = _elements(values, "readings")
    if times is None:
        times = getattr(readings, "index", None)
        if not hasattr(times, "freq"):  # an index of dates or of timedeltas
            raise MissingInput("the times of the readings are missing", TIMES)
    of_times = _elements(times, "times")
    arguments.refuse_unlike_index(values, times)
    if len(of_values) != len(of_times):
        problem = f"there are {len(of_values)} readings and {len(of_times)} times"
        raise ConditionError(problem, "a time for each reading")
    own = arguments.unit_of(values).text if arguments.is_quantity(values) else ""
    if own and chosen.unit:
        raise ConditionError("unit cannot be used with readings that have a unit", "leave out unit")
    first, clock = of_times[0] if of_times else None, chosen.clock
    zone = getattr(first, "tzinfo", None)
    zone_name = getattr(zone, "key", None) or getattr(zone, "zone", None) or ""
    unit = "s" if isinstance(first, (timedelta, numpy.timedelta64)) else ""
    unit = arguments.unit_of(times).text if arguments.is_quantity(times) else unit
    clock = clock._replace(zone=clock.zone or zone_name, unit=clock.unit or unit)
    titles = _title(times, "time"), _title(readings, "value")
    rows = [titles, *zip(map(_cell, of_times), map(_cell, of_values), strict=True)]
    text = BytesIO("\n".join(map(TAB.join, rows)).encode())
    settings = chosen._replace(times=("1",), column="2", unit=own or chosen.unit, delimiter=TAB)
    settings = settings._replace(clock=clock, row="reading", first=0)
    return settings, nullcontext(("the log", text.read))


@overload
def dose(readings: Readings, times: Times = None, *, by: None = None, **given: Any) -> Result: ...
@overload
def dose(
    readings: Readings, times: Times = None, *, by: Period, **given: Any
) -> dict[str, Result]: ...
@of_page("dose")
def dose(
    readings: Readings,
    times: Times = None,
    *,
    unit: str = "",
    column: str | int | None = None,
    time_column: str | int | Sequence[str | int] = (),
    time_unit: str = "",
    time_zone: str = "",
    time_format: str = "",
    samples: Samples | None = None,
    where: str | Sequence[str] = (),
    missing: str | float | Sequence[str | float] = (),
    dark: str | float = "",
    thousands: str = "",
    invalid: Invalid = "abort",
    by: Period | None = None,
    **given: Any,
) -> Result | dict[str, Result]:
    """Add up samples of light over time: exposure, energy, daily light integral.

    Parameters
    ----------
    readings : str, path, Series, Quantity or sequence
        The path of a file with a time and a value in each line, or the samples: a column of
        pandas or Polars with its unit in its name (``"E [lx]"``), a quantity, texts, or numbers
        with `unit`.
    times : Series, Quantity or sequence, optional
        The times of the samples: dates (of `datetime`, NumPy, pandas or as texts), a quantity, or
        numbers with `time_unit`.  By default those of the index of a pandas Series.
    unit : str, optional
        The unit of the values, if they have none: ``"lx"``, ``"W/m2"``, ``"umol/m2/s"`` ...
    column, time_column : str or int, optional
        The columns of a file, by title or number; several for a date and a time of day.
    time_unit : str, optional
        The unit of times that are numbers since the start: ``"s"``.
    time_zone : str, optional
        The zone of local times and of days: ``"Europe/Prague"``, ``"+02:00"``, ``"UTC"``; by
        default that of the times.
    time_format : str, optional
        The format of dates in texts, as in strptime: ``"%d/%m/%Y %H:%M"``.
    samples : {"points", "means", "means-before", "means-centred"}, optional
        Points with straight lines between them (the default), or means from each time to the next,
        from the time before to each, or centred on each.  A public format of the sun has its own
        default.
    where : str or sequence, optional
        The rows of a file that are read, by the text in a column: ``"sensor=A"`` (``*`` is any).
    missing : str, number or sequence, optional
        The marks of missing values, whose rows are gaps: ``-99.9``.
    dark : str or number, optional
        What the meter shows in the dark, which is subtracted.
    thousands : str, optional
        The separator of thousands in the values.
    invalid : {"abort", "warn", "ignore"}, optional
        Refuse the log at a reading that is missing or invalid (the default), or skip it, which is a
        gap, with a warning or without.
    by : {"day", "hour"}, optional
        Give a result for each local day or hour.

    Returns
    -------
    Result
        With `by` a dict of results by day or hour.  Each has `exposure` (of an irradiance) or
        `energy` (of a flux), the mean, the maximum, `covered_time` and `coverage`.

    Examples
    --------
    >>> hours = ["2024-06-01 08:00", "2024-06-01 12:00", "2024-06-01 20:00"]
    >>> print(dose([0, 500, 0], hours, unit="umol/m2/s").exposure)
    10.8 mole / metre ** 2
    """
    if samples is not None:
        arguments.one_of(samples, READINGS, "kind of samples")
    arguments.one_of(invalid, SKIPPING, "treatment of an invalid reading")
    period = "" if by is None else arguments.one_of(by, PERIODS, "period")
    texts = {"time_zone": time_zone, "time_unit": time_unit, "time_format": time_format}
    arguments.require_texts(unit=unit, thousands=thousands, **texts)
    inputs = arguments.read_inputs(given)
    refuse_uncertain([inputs["max-gap"]] if "max-gap" in inputs else [], "a log")
    arguments.refuse_arrays(inputs, "the whole log")
    chosen = LogSettings(
        tuple(filter(None, _listed("time_column", time_column))),
        "" if column is None else str(column),
        unit,
        invalid=invalid,
        clock=TimeSettings(time_zone, time_unit, time_format),
        where=rows_where(_listed("where", where)),
        missing=tuple(_listed("missing", missing)),
        dark=str(dark),
        thousands=thousands,
    )
    path = os.fspath(readings) if isinstance(readings, (str, os.PathLike)) else None
    if path is not None and times is not None:
        raise ConditionError("times do not apply to a file", mention("{time-column}"))
    settings, source = (
        _of_readings(readings, times, chosen) if path is None else (chosen, opened(path, EXPECTED))
    )
    with source as (name, read):
        skipped: list[LineError] = []
        log = LogDose(Log(name, read, settings, skipped.append), inputs, period, samples or "")
    for error in skipped:
        warn(in_words(error.message), stacklevel=4)  # in the caller's line
    operands = {"file": path or "", **chosen.texts, "samples": samples or ""}
    if not period:
        facts = log.summed.samples()
        return calculate("dose", given, log.answer, operands, waits=False, samples=facts)
    shown = (*texts_of(operands), *shown_inputs(inputs))
    results = {}
    for label, answer in log.periods(inputs):
        of_period = ShownInput(period, text=label, tells=True)
        results[label] = of_answer("dose", answer, (*shown, of_period), None, UNDRAWN)
    return results


def _listed(key: str, given: Any) -> list[str]:
    """Return one or several texts or numbers as texts; refuse other values."""
    several = given if isinstance(given, (list, tuple)) else [given]
    for one in several:
        if isinstance(one, bool) or not isinstance(one, (str, float, int)):
            problem = f"{key} is {article(type(one).__name__)}, not a text or a number"
            raise ConditionError(problem, f"{key} as a text, or a list of texts")
    return [*map(str, several)]


def _elements(value: Any, what: str) -> list[Any]:
    """Return the elements of a sequence, a column or an array of one dimension."""
    arguments.refuse_lazy(value, what)
    array = arguments.magnitude_of(value)
    if hasattr(array, "to_list"):  # of pandas and Polars
        return list(array.to_list())
    if not isinstance(array, (list, tuple, numpy.ndarray)) or getattr(array, "ndim", 1) != 1:
        problem = f"the {what} are not a sequence, but {article(type(array).__name__)}"
        raise ConditionError(problem, "a column, a list or an array of one dimension")
    is_time = getattr(getattr(array, "dtype", None), "kind", "") in "mM"
    return array.tolist() if isinstance(array, numpy.ndarray) and not is_time else [*array]


def _cell(value: Any) -> str:
    """Return a time or a reading as a line of a log has it."""
    if isinstance(value, date):  # also a datetime, and a Timestamp of pandas
        return value.isoformat()
    if isinstance(value, numpy.timedelta64):
        return str(value / numpy.timedelta64(1, "s"))
    if isinstance(value, timedelta):
        return str(value.total_seconds())
    return " ".join(str("" if value is None else value).split())


def _title(value: Any, otherwise: str) -> str:
    """Return the name of a column, if it has one that is not a number."""
    name = " ".join(str(getattr(value, "name", None) or "").split())
    return otherwise if not name or name.isdecimal() else name
