"""Numbers in columns, and CSV: a line for each answer, a column NAME:UNIT for each number."""

import csv
import io
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from radcalc.answer import Result, Row, ShownInput, shows, varying
from radcalc.conversion.plan import plan
from radcalc.errors import printable
from radcalc.maths import is_array
from radcalc.render.formats import Judgement, Records, Style
from radcalc.render.plain import DIGITS, fields, number, refuse_verdict, rounded
from radcalc.units.values import resolve_given

LINES = 1000  # lines to format at a time
FORMULA = re.compile(r"[=@\t\r]|[+-](?![\d.][\w .,/%°]*$)")  # the beginning of a cell


def lines(columns: Sequence[Any], precision: int | None, count: int = 1) -> str:
    """Return tab-separated columns on `count` lines, or a line for each element of arrays."""
    if not any(map(is_array, columns)):
        return ("\t".join(number(column, precision) for column in columns) + "\n") * count
    return formatted(columns, f"%.{precision or DIGITS}g", "\t")


def formatted(columns: Sequence[Any], form: str, delimiter: str) -> str:
    """Return a line for each element of arrays; `form` formats numbers, not texts."""
    lists = [column.tolist() for column in columns if is_array(column)]
    flat = lists[0] if len(lists) == 1 else [x for line in zip(*lists, strict=True) for x in line]
    cells = [form if is_array(column) else _text(column, form) for column in columns]
    line = delimiter.join(cells) + "\n"
    width = len(lists) * LINES
    pieces = (flat[k : k + width] for k in range(0, len(flat), width))
    return "".join([line * (len(part) // len(lists)) % tuple(part) for part in pieces])


def _text(column: Any, form: str) -> str:
    return (column if isinstance(column, str) else form % column).replace("%", "%%")


REMARKS_ARE_APART = True


def results(results: Sequence[Result], style: Style) -> str:
    """Return the varied inputs and the results, a line for each answer, under one header.

    A missing result is an empty cell.  Text inputs are omitted if the given numbers identify the
    answers.
    """
    units = units_of_varied([result.inputs for result in results])
    given = [[row for row in result.rows if row.given] for result in results]
    numbers = {tuple(row.value for row in rows) for rows in given}
    are_apart = len(numbers) == len(results) > 1
    units = {
        name: unit
        for name, unit in units.items()
        if not (_is_column(name, given) if unit else are_apart)
    }
    lines = []
    for result in results:
        line = {head: _cell(value, style) for head, value in _inputs(result, units).items()}
        for row in result.rows:
            if not any(shows(row, name) for name in units):
                line |= _of_row(row, style)
        lines.append(line)
    header = list(dict.fromkeys(head for line in lines for head in line))
    return _write([header, *([line.get(head, "") for head in header] for line in lines)])


def block(result: Result, units: Mapping[str, str], style: Style, with_header: bool) -> str:
    """Return the lines of an answer with arrays, as one of many parts.

    `units` are those of the inputs that vary in any part.
    """
    unshown_inputs = {
        name: unit
        for name, unit in units.items()
        if not any(shows(row, name) for row in result.rows)
    }
    columns = _inputs(result, unshown_inputs)
    columns |= {f"{row.name}:{row.unit}": row.value for row in result.rows}
    form = f"%.{style.precision}g" if style.precision else "%r"
    cells = [_write([[x]])[:-1] if isinstance(x, str) else x for x in columns.values()]
    return (_write([list(columns)]) if with_header else "") + formatted(cells, form, ",")


def units_of_varied(inputs: Sequence[Sequence[ShownInput]]) -> dict[str, str]:
    """Return the inputs that vary, with the unit of each; '' for a text."""
    return {
        name: _unit(
            [
                next((item for item in case_inputs if item.name == name), None)
                for case_inputs in inputs
            ]
        )
        for name in varying(inputs)
    }


def records(records: Records, style: Style) -> str:
    """Return rows under a header."""
    return _write([list(records.rows[0]), *fields(records)])


def note_on_formulas(records: Records) -> list[str]:
    """Return a note on the cells that a spreadsheet may take as formulas: =1+1, but not +5 lx."""
    count = sum(bool(FORMULA.match(field)) for row in fields(records) for field in row)
    cells = "a cell begins" if count == 1 else f"{count} cells begin"
    return [f"{cells} with =, +, - or @, which a spreadsheet may run"] if count else []


def verdict(judgement: Judgement, style: Style) -> str:
    """Raise an error: a judgement is not a table of values."""
    refuse_verdict()


def _inputs(result: Result, units: Mapping[str, str]) -> dict[str, Any]:
    """Return the named inputs by their column titles."""
    return {
        f"{item.name}:{unit}" if unit else item.name: _in(item, unit)
        if unit
        else printable(item.text)
        for item in result.inputs
        if (unit := units.get(item.name)) is not None
    }


def _of_row(row: Row, style: Style) -> dict[str, str]:
    """Return a value and its uncertainty by their column titles."""
    if row.uncertainty:
        value, off = rounded(row.value, row.uncertainty, style.precision)
        cells = {"": repr(float(value)), "-uncertainty": repr(off)}
    else:
        cells = {"": _cell(row.value, style)}
    return {f"{row.name}{suffix}:{row.unit}": cell for suffix, cell in cells.items()}


def _is_column(name: str, given: Sequence[Sequence[Row]]) -> bool:
    """Return whether an input is among the results of all answers, in the same unit."""
    units = [{row.unit for row in rows if shows(row, name)} for rows in given]
    return bool(set.intersection(*units))


def _unit(cells: Sequence[ShownInput | None]) -> str:
    """Return the unit of the first quantity, or '' unless all have its dimension."""
    units = {cell.unit if cell else "" for cell in cells}
    if "" in units or len({resolve_given(unit).dimension for unit in units}) > 1:
        return ""
    return cells[0].unit if cells[0] else ""


def _in(item: ShownInput, unit: str) -> Any:
    if item.unit == unit:
        return item.value
    return plan(resolve_given(item.unit), resolve_given(unit)).apply(item.value)


def _write(lines: Iterable[Sequence[Any]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(lines)
    return text.getvalue()


def _cell(value: Any, style: Style) -> str:
    if isinstance(value, str):
        return value
    return number(value, style.precision) if style.precision else repr(float(value))
