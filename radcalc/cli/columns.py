"""`radcalc columns FILE`: the columns of a table or a log."""

from typing import Any

from radcalc.answer import texts_of
from radcalc.calculators.pages import page_of
from radcalc.cli.command import define
from radcalc.cli.files import only_file, proposed
from radcalc.cli.output import Output, refuse_number_options
from radcalc.cli.spelling import quoted
from radcalc.errors import ConditionError, quote_path
from radcalc.errors import command as call_of
from radcalc.quantities.light import read as read_light
from radcalc.quantities.units import offered
from radcalc.render.formats import Records
from radcalc.render.plain import number
from radcalc.routes.kinds import NAMES, ColumnSummary, contents_of, listing
from radcalc.streams.log_layout import FirstRows
from radcalc.terminal import CSV, JSON, TABLE
from radcalc.units.table import resolve
from radcalc.units.unit import Unit

DIGITS = 6


@define("columns", page_of("columns"))
def command(words: tuple[str, ...], output: Output) -> None:
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
    listed = listing(path, found.rows)
    rows = [_row(path, found.rows, column, output.format) for column in listed.columns]
    table = [{key: str(cell) for key, cell in row.items()} for row in rows]
    notes = (f"{listed.rows} rows", *listed.notes)
    right = ("numbers", "from", "to", "mean")
    output.records(Records(rows, notes, table, right, texts_of({"file": path})), (JSON, TABLE))


def _row(path: str, rows: FirstRows, column: ColumnSummary, form: str) -> dict[str, Any]:
    """Return the record of a column, with all digits of its numbers or a few."""
    is_exact = form in (JSON, CSV)
    low: Any = column.first
    high: Any = column.last
    mean: Any = column.mean
    if column.count:
        low, high = column.least, column.greatest
    if column.count and not is_exact:
        low, high, mean = [number(value, DIGITS) for value in (low, high, mean)]
    return {
        "column": column.name,
        "unit": column.unit.text if column.unit else "",
        "numbers": column.count,
        "from": low,
        "to": high,
        "mean": "" if mean is None and form != JSON else mean,
        "command": _command(path, rows, column),
    }


def _command(path: str, rows: FirstRows, column: ColumnSummary) -> str:
    """Return the command that converts a column, or adds up its dose; "" without a unit."""
    if column.unit is None or not column.count:
        return ""
    if (rows.times or rows.parts) and read_light(column.unit):
        return f"radcalc dose {quoted(path)} --column {quoted(column.name)}"
    target = _another(column.unit)
    if not target or not rows.names:
        return ""
    name = column.name if len(rows.table.titles) == 1 else str(column.place + 1)
    words = [
        "radcalc convert -",
        quoted(column.unit.text),
        quoted(target),
        "--column",
        quoted(name),
    ]
    if rows.table.delimiter:
        words.append(
            "-d tab" if rows.table.delimiter == "\t" else f"-d {quoted(rows.table.delimiter)}"
        )
    if rows.table.decimals.comma:
        words.append("--decimal ,")
    if rows.begin > 2:
        words.append(f"--header={rows.begin - 1}")
    return " ".join([*words, "<", quoted(path)])


def _another(unit: Unit) -> str:
    """Return the first unit of the same quantity with another size, or ""."""
    if unit.is_scale:
        return ""
    units = (text for text in offered(unit) if resolve(text).factor != unit.factor)
    return next(units, "")
