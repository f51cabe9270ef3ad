"""`radcalc dose FILE|-` and `radcalc columns FILE`."""

from collections.abc import Sequence
from typing import Any

from radcalc import terminal
from radcalc.answer import ShownInput, texts_of
from radcalc.calculators import dose as page
from radcalc.calculators import page_of
from radcalc.calculators.page import PER_DAY
from radcalc.calculators.solved import Task
from radcalc.cli.answers import Answered, show
from radcalc.cli.calculator import run
from radcalc.cli.command import define
from radcalc.cli.output import Output, refuse_number_options
from radcalc.cli.request import Case, Request, cases, refuse_second_reader, several
from radcalc.cli.spelling import only_file, proposed, quoted
from radcalc.cli.streams import complain
from radcalc.errors import MINUS, ConditionError, RadcalcError, UsageError, quote_path
from radcalc.errors import command as call_of
from radcalc.files import reading
from radcalc.inputs import refuse_uncertain, shown_inputs
from radcalc.quantities.names import DLI, offered
from radcalc.render.formats import Records
from radcalc.render.plain import number
from radcalc.routes import NAMES, ColumnSummary, Contents, Listing, contents_of
from radcalc.streams.clocks import TimeSettings
from radcalc.streams.fields import read_delimiter
from radcalc.streams.log_layout import FirstRows, LogHead, LogSettings, rows_where
from radcalc.streams.samples import EXPECTED, Log, LogDose
from radcalc.terminal import ABORT, CSV, IGNORE, JSON, TABLE
from radcalc.units import Unit
from radcalc.units.table import resolve

HELP = """\
\b
Examples:
  radcalc dose lux.csv
  radcalc dose lux.csv --spectrum D65 -g photon-exposure:mol/m2
  radcalc dose par.csv --by day --time-zone Europe/Prague --max-gap 30min
  radcalc dose par.csv --by day --format csv -g exposure:mol/m2,coverage:%
  radcalc dose gallery.csv -g exposure:lx.h
  radcalc dose - --unit W/m2 --time-unit s < samples.txt
  radcalc dose ghi.csv --samples means --by day
  radcalc dose prague.epw --column ghi
  radcalc dose hobo.csv --time-format '%m/%d/%y %I:%M:%S %p' --invalid ignore
  radcalc dose house.csv --where entity_id=sensor.desk --missing -99.9

FILE has a time and a value in each line; - is standard input.  Irradiances, illuminances and
photon flux densities (PPFD) add up to an exposure (with --receiver-area also to an energy),
fluxes to an energy.
The unit is in the title of the values (E [lx], PAR_umol/m2/s) or in --unit.  Weather files (EPW,
TMY3, NSRDB, BSRN, SURFRAD, SOLRAD, MIDC, CRN, PVGIS, CAMS) are read with pvlib.

Times are ISO 8601 with T or a blank, numbers with a unit in the title or in --time-unit, or Unix
time, which the title (unix, epoch, timestamp) or --time-unit says.  --time-zone is the zone of
times without an offset; days on which the clocks change have 23 or 25 hours.  Dates whose day and
month no line shows are an error: use --time-format.

A column of texts that differ tells series apart: choose one with --where.  Light below 0 is an
error: --missing names a mark of missing values, --dark is what the meter shows in the dark, and
--invalid skips lines.  A rate per day (mol/m2/d, kWh/m2/day) on dates is the sum of each day.

Values between samples are interpolated linearly; with --samples means, each sample is the mean
from its time to that of the next sample, with means-before from the time of the one before, and
with means-centred from half-way before it to half-way after it; the time of the maximum is then
the start of the mean.  A step is a gap if it is more than 0.1 % longer than
--max-gap.  The 0.1 % allows for rounded times in the file.  Without --max-gap, only a step that
contains a line skipped by --invalid is a gap.  A note lists the gaps, and coverage is the part
of the time without them.  A day or hour within a gap has an exposure of 0, no mean,
and coverage 0.
"""


@define("dose", page.PAGE, text=HELP)
def command(
    words: tuple[str, ...],
    typed: dict[str, str],
    time_column: tuple[str, ...],
    where: tuple[str, ...],
    missing: tuple[str, ...],
    invalid: str,
    samples: str | None,
    request: Request,
    output: Output,
    **others: str | None,
) -> int:
    """Answer for the samples of a log, or for each of its periods.

    `others` are the texts of the options without a default.
    """
    path = only_file(words, "samples", call_of("dose", "FILE"))
    if path == "-":
        refuse_second_reader(typed)
    texts = {name: text or "" for name, text in others.items()}
    by, column, unit, delimiter, dark, thousands = map(
        texts.pop, ("by", "column", "unit", "delimiter", "dark", "thousands")
    )
    all_cases = cases(typed, arrays=False)
    _refuse_gaps(all_cases)
    if by and len(all_cases) > 1:
        problem = "--by cannot be used with a list of conditions"
        raise UsageError(problem, "only one of them, and a loop")
    settings = LogSettings(
        time_column,
        column,
        unit,
        read_delimiter(delimiter) if delimiter else "",
        invalid,
        TimeSettings(texts["time_zone"], texts["time_unit"], texts["time_format"]),
        where=rows_where(where),
        missing=tuple(text.replace(MINUS, "-") for text in missing),
        dark=dark.replace(MINUS, "-"),
        thousands=thousands,
    )
    with reading(path, EXPECTED) as (name, read):
        log = Log(name, read, settings, complain)
        summed = LogDose(log, all_cases[0].given, by, samples or "")
    if by != PER_DAY and _asks_for_dli(request):
        summed.summed.refuse_dli(by, request.check is not None)
    typed_here = {"file": path, **settings.texts, "delimiter": delimiter, "samples": samples or ""}
    operands = texts_of(typed_here)
    if by and request.check is None:
        given = all_cases[0].given
        shown = (*operands, *shown_inputs(given))
        answers = [
            Answered(label, (*shown, ShownInput(by, text=label, tells=True)), answer)
            for label, answer in summed.periods(given)
        ]
        show(answers, request, output, [answered.inputs for answered in answers])
        status = terminal.ANSWERED
    else:
        if by and len(summed.summed.dose.periods) > 1:
            raise several()
        task = Task("dose", summed.answer, operands, samples=summed.summed.samples())
        status = run(all_cases, task, request, output)
    return status if log.is_good or status else terminal.FAILED


def _asks_for_dli(request: Request) -> bool:
    """Return whether a result is a DLI: DLI, exposure:DLI, or --check 20DLI."""
    parts = [part for asked in (*request.wanted, request.check or "") for part in asked.split(":")]
    return any(part.strip().lower().endswith(DLI) for part in parts)


def _refuse_gaps(all_cases: Sequence[Case]) -> None:
    """Refuse several longest steps that are bridged, and an uncertain one."""
    gaps = [case.given["max-gap"] for case in all_cases if "max-gap" in case.given]
    refuse_uncertain(gaps, "a log")
    if len({gap.value for gap in gaps}) > 1:
        raise UsageError("a log is read with one --max-gap, not a list", "--max-gap once")


DIGITS = 6
MOST_TRIED = 200_000  # rows of a table whose dose is tried before it is proposed


@define("columns", page_of("columns"))
def columns_command(words: tuple[str, ...], output: Output) -> None:
    """List the columns of a table: units, extremes, mean, and a command for each.

    \b
    Examples:
      radcalc columns log.csv          a log with several columns of light
      radcalc columns sensors.csv      any table of numbers
      radcalc sensors.csv              the same

    The mean of a column is that of its numbers, each of which counts the same; radcalc dose has
    the mean over time.  A command for a column of light with times adds up its dose, any other
    command converts the column.
    """
    refuse_number_options(output, "columns")
    path = only_file(words, "table", call_of("columns", "FILE"))
    found = contents_of(path)
    if found.rows is None:
        problem = f"{quote_path(path)} is {NAMES[found.kind]}, not a table"
        raise ConditionError(problem, proposed(found.kind, path))
    listed = Listing(path, found.rows)
    rows = [_row(path, found, column, listed.rows, output.format) for column in listed.columns]
    table = [{key: str(cell) for key, cell in row.items()} for row in rows]
    notes = (f"{listed.rows} rows", *listed.notes)
    right = ("numbers", "from", "to", "mean")
    records = Records(rows, notes, table, right, texts_of({"file": path}))
    output.records(records, (JSON, TABLE), of_file=True)


def _row(
    path: str, found: Contents, column: ColumnSummary, count: int, form: str
) -> dict[str, Any]:
    """Return the record of a column, with all digits of its numbers or a few."""
    is_exact = form in (JSON, CSV)
    found_numbers: list[Any] = [column.first, column.last, column.mean]
    if column.count:
        found_numbers[:2] = column.least, column.greatest
    if column.count and not is_exact:
        found_numbers = [number(value, DIGITS) for value in found_numbers]
    low, high, mean = found_numbers
    return {
        "column": column.name,
        "unit": column.unit.text if column.unit else "",
        "numbers": column.count,
        "from": low,
        "to": high,
        "mean": "" if mean is None and form != JSON else mean,
        "command": _command(path, found, column, count),
    }


def _command(path: str, found: Contents, column: ColumnSummary, count: int) -> str:
    """Return the command that converts a column, or adds up its dose; "" without a unit."""
    rows = found.rows
    if column.unit is None or not column.count or rows is None:
        return ""
    skip = " --invalid ignore" if column.count < count else ""
    if _has_dose(path, rows, column, count):
        return f"radcalc dose {quoted(path)} --column {quoted(column.name)}{skip}"
    target = _another(column.unit)
    if not target or not rows.names or found.is_made:
        return ""
    name = column.name if rows.names.count(column.name) == 1 else str(column.place + 1)
    units = quoted(column.unit.text), quoted(target)
    words = ["radcalc convert -", *units, "--column", quoted(name)]
    if rows.table.decimals.comma:
        words.append("--decimal ,")
    return " ".join([*words, *skip.split(), "<", quoted(path)])


def _has_dose(path: str, rows: FirstRows, column: ColumnSummary, count: int) -> bool:
    """Return whether the samples of a column add up: the call is made, but for a long table."""
    is_long = count > MOST_TRIED
    if not (rows.times or rows.parts[0]) or (is_long and (column.least < 0 or column.odd)):
        return False
    settings = LogSettings(column=column.name, invalid=IGNORE if column.count < count else ABORT)
    try:
        if is_long:
            page.check_unit(LogHead(rows.name, rows.lines, settings).layout.unit)
            return True
        with reading(path, EXPECTED) as (name, read):
            LogDose(Log(name, read, settings, lambda error: None), {})
    except RadcalcError:
        return False
    return True


def _another(unit: Unit) -> str:
    """Return the first unit of the same quantity with another size, or ""."""
    units = (text for text in offered(unit) if resolve(text).factor != unit.factor)
    return "" if unit.is_scale else next(units, "")
