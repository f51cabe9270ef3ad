"""The rows of a scene: the columns of each source.

A row is a line of a file or a Python dict, with values for some of the columns.
"""

import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import partial
from typing import Any, NamedTuple

from radcalc import errors
from radcalc.calculators.point_laws import CONE, LOBE
from radcalc.distributions.sources import read_lines
from radcalc.errors import listed, quote
from radcalc.files import columns, refusal, where
from radcalc.files.columns import Table
from radcalc.quantities import describe
from radcalc.quantities.column_titles import read_title
from radcalc.quantities.symbols import ANY, SYMBOLS, Symbol, names_of_kinds
from radcalc.units import NUMBER, Unit
from radcalc.units.amounts import split_value
from radcalc.units.dimensions import LENGTH
from radcalc.units.table import resolve, unit_of

PLACE, AIM, DIRECTION = (
    tuple(f"{word}{axis}" for axis in "xyz") for word in ("", "aim-", "direction-")
)
SIZE = ("area", "width", "length")
STRENGTH = ("flux", "intensity")  # of any source
SURFACE = ("radiance", "exitance")  # of a Lambertian source


def _coordinate(name: str) -> Symbol:
    return Symbol(name, name, (LENGTH,), "2m", limits=ANY, label=name, unit="m", takes="a length")


COLUMNS: dict[str, Symbol] = {
    **{name: _coordinate(name) for name in (*PLACE, *AIM, *DIRECTION)},
    "rotate": SYMBOLS["rotate"],
    **{
        name: SYMBOLS[name]
        for generic in (*CONE, *LOBE, *SIZE, *STRENGTH, *SURFACE)
        for name in (generic, *names_of_kinds(generic))
    },
}
COMMENT = "#"
TEXTS = ("name", "distribution")
KNOWN = (*TEXTS, *COLUMNS)
OF_LIGHT = ("distribution", *(n for g in (*STRENGTH, *SURFACE) for n in (g, *names_of_kinds(g))))


class Row(NamedTuple):
    """A source as typed.

    `where` names the row in messages; `cells` are its non-blank values by column.
    """

    where: str
    cells: dict[str, Any]
    titles: dict[str, str]

    def error(self, column: str, problem: str, hint: str) -> errors.ConditionError:
        place = f"{self.where}, {_title(self.titles, column)}"
        return errors.ConditionError(f"{place}: {problem}", hint)

    def both(self, first: str, second: str) -> errors.ConditionError:
        message = f"{self.where}: {typed(first)} cannot be used with {typed(second)}"
        return errors.ConditionError(message, "only one of them")


def _title(titles: Mapping[str, str], column: str) -> str:
    return f"column '{quote(titles.get(column, typed(column)))}'"


def typed(column: str) -> str:
    """Return the name of a column as typed.

    Examples
    --------
    >>> typed("aim-x")
    'aim_x'
    """
    return column.replace("-", "_")


def is_scene(titles: Sequence[str]) -> bool:
    """Return whether the titles of a table are those of sources at their places."""
    names: set[str] = set()
    for title in titles:
        with suppress(errors.ConditionError):
            names.add(_column(title, "")[0])
    return {"x", "y"} <= names and not names.isdisjoint(OF_LIGHT)


def rows_of_file(path: str) -> tuple[list[Row], list[str]]:
    """Return the rows of a file with a header and a line for each source, and notes."""
    name, all_lines = read_lines(path, "a CSV file with a row for each source")
    lines = [(number, line) for number, line in enumerate(all_lines, 1) if line.strip(" \t;,|")]
    comments = [entry for entry in lines if entry[1].lstrip().startswith(COMMENT)]
    lines = [entry for entry in lines if entry not in comments]
    if len(lines) < 2:
        problem = "the file has a header but no source" if lines else "the file has no source"
        raise errors.ConditionError(
            f"{name}: {problem}", "a header such as x,y,z,flux and rows below it"
        )
    begin = _header_place([line for _, line in lines])
    number, header = lines[begin]
    delimiter = next((mark for mark in columns.DELIMITERS if mark in header), None)
    if delimiter is None:
        raise errors.ConditionError(
            f"{where(name, number)}: there is only one column", "a header such as x,y,z,flux"
        )
    cells, below = _with_units(lines[begin:], delimiter)
    titles, units = _header(cells, where(name, number))
    rows = _rows(name, below, delimiter, titles, units)
    notes = []
    like_rows = [
        str(place) for place, line in comments if len(columns.cells(line, delimiter)) == len(titles)
    ]
    if like_rows:
        lines_text = f"lines {listed(like_rows)}"
        notes.append(f"{name}: comments with as many cells as the rows, skipped: {lines_text}")
    if begin:
        skipped = "the lines of text above are skipped"
        notes.append(f"{name}: the titles are in line {number}; {skipped}")
    return rows, notes


def _with_units(
    lines: Sequence[tuple[int, str]], delimiter: str
) -> tuple[list[str], Sequence[tuple[int, str]]]:
    """Return the titles of a table, with a row of units if it has one, and the lines below."""
    cells = columns.cells(lines[0][1], delimiter)
    units = columns.cells(lines[1][1], delimiter) if len(lines) > 2 else []
    if len(units) != len(cells) or not all(not unit or unit_of(unit) for unit in units):
        return cells, lines[1:]
    pairs = zip(cells, units, strict=True)
    return [f"{title} ({unit})" if unit else title for title, unit in pairs], lines[2:]


def _rows(
    name: str,
    lines: Sequence[tuple[int, str]],
    delimiter: str,
    titles: dict[str, str],
    units: Mapping[str, Unit],
) -> list[Row]:
    """Return the rows of lines with their numbers, with the units of their columns."""
    rows = []
    table = Table(partial(refusal, name), delimiter, len(titles), list(titles.values()))
    for number, line in lines:
        cells = table.cells(number, line)
        filled = {column: cell for column, cell in zip(titles, cells, strict=True) if cell}
        rows.append(Row(where(name, number), filled, titles))
        _check_marks(rows[-1], number, table)
    _read_numbers(rows, units, bool(table.decimals.comma))
    return rows


def _header_place(lines: Sequence[str]) -> int:
    """Return the place of the titles: the first line with a column x, if it is below text alone."""
    for place, line in enumerate(lines):
        mark = next((mark for mark in columns.DELIMITERS if mark in line), None)
        cells = columns.cells(line, mark) if mark else [line]
        if any(re.fullmatch(r"x(?![^\W_]).*", _name(cell)) for cell in cells):
            return place
        if any(columns.is_number(cell, True) for cell in cells[1:]):
            return 0
    return 0


def _check_marks(row: Row, line: int, table: Table) -> None:
    for column, cell in row.cells.items():
        if column in COLUMNS:
            for number in columns.MARKED.findall(cell):
                if problem := table.decimals.conflict(number, line):
                    raise row.error(column, problem, columns.MARKS)


def _read_numbers(rows: Sequence[Row], units: Mapping[str, Unit], have_commas: bool) -> None:
    """Replace decimal commas by points, and give bare numbers the units of their columns."""
    places = [(row.cells, column) for row in rows for column in row.cells if column in COLUMNS]
    if have_commas:
        for row, column in places:
            row[column] = row[column].replace(",", ".")
    for row, column in places:
        row[column] = _in_unit(row[column], units.get(column))


def _in_unit(value: Any, unit: Unit | None) -> Any:
    """Return a bare number with the unit of its title and its text; other values unchanged."""
    if unit is None or not is_bare(value):
        return value
    number = split_value(value)[0] if isinstance(value, str) else value
    return number, unit, f"{value} {unit.text}"


def _header(titles: Sequence[str], where: str) -> tuple[dict[str, str], dict[str, Unit]]:
    """Return the titles and the units of columns by name; refuse blank or repeated titles."""
    names: dict[str, str] = {}
    units: dict[str, Unit] = {}
    for number, title in enumerate(titles, 1):
        if not title:
            raise errors.ConditionError(
                f"{where}: column {number} has no title", "a title, or no column"
            )
        name, unit = _column(title, where)
        if name in names:
            raise errors.ConditionError(
                f"{where}: column '{quote(title)}' appears twice", "each column once"
            )
        names[name] = title
        if unit:
            units[name] = unit
    return names, units


def _column(title: str, where: str) -> tuple[str, Unit | None]:
    """Return the name of a column and its unit: x (m), x [cm], x_m, x / m, or x."""
    normalized = _name(title)
    heads = [
        head
        for head in KNOWN
        if normalized.startswith(head) and not normalized[len(head) :][:1].isalpha()
    ]
    name = max(heads, key=len, default="")
    if name and name == normalized:
        return name, None
    if name in TEXTS:
        raise errors.ConditionError(
            f"{where}: column '{quote(title)}' has a unit", f"'{name}' alone"
        )
    if name and (unit := _unit(name, title, where)):
        return name, unit
    near = [typed(head) for head in errors.nearest(normalized, KNOWN, 3)]
    hint = ", ".join(near) or "x, y, z, flux, intensity, distribution, aim_x, rotate, name ..."
    raise errors.ConditionError(f"{where}: unknown column '{quote(title)}'", hint)


def _name(title: str) -> str:
    return "-".join(title.lower().replace("_", " ").replace("-", " ").split())


def _unit(name: str, title: str, where: str) -> Unit | None:
    """Return the unit in a title, which must suit the column; None if there is more text."""
    symbol = COLUMNS[name]
    example = typed(name) if symbol.unit == "1" else f"{typed(name)} ({symbol.unit})"
    units = (COLUMNS[key].unit for key in (name, *names_of_kinds(name)))
    try:
        titles = (read_title(title, resolve(text)) for text in units)
        matched = next((parsed for parsed in titles if parsed.unit), None)
        unit = matched and matched.unit
        if not matched or not unit:
            for text in columns.units_in(title)[0]:
                resolve(text)  # raises the error of an unknown unit
            return None
        if unit.is_scale:
            raise errors.UnitError(f"{quote(unit.text)} is a scale", example)
    except errors.RadcalcError as error:
        raise errors.ConditionError(
            f"{where}, column '{quote(title)}': {error.message}", error.hint or example
        ) from None
    if unit.dimension not in symbol.dimensions or unit.dimension == NUMBER:
        raise errors.ConditionError(
            f"{where}, column '{quote(title)}': takes {symbol.takes}, not {describe(unit)}", example
        )
    return unit if _name(matched.name) == name else None


def rows_of_dicts(sources: Sequence[Mapping[str, Any]]) -> list[Row]:
    """Return the rows of a list of dicts, whose keys are titles; None means missing."""
    rows = []
    headers: dict[tuple[str, ...], tuple[dict[str, str], dict[str, Unit]]] = {}
    for number, source in enumerate(sources, 1):
        if not isinstance(source, Mapping):
            raise errors.ConditionError(
                f"source {number} is a {type(source).__name__}", "a dict for each source"
            )
        where, keys = f"source {number}", tuple(map(str, source))
        if keys not in headers:
            headers[keys] = _header(keys, where)
        titles, units = headers[keys]
        cells = {
            column: _in_unit(value, units.get(column))
            for column, value in zip(titles, source.values(), strict=True)
            if value is not None and not (isinstance(value, str) and not value.strip())
        }
        rows.append(Row(where, cells, {}))
    if not rows:
        raise errors.ConditionError("there is no source", "a dict for each")
    return rows


def is_bare(value: Any) -> bool:
    """Return whether a value of a cell has no unit."""
    if not isinstance(value, str):
        return not isinstance(value, tuple)
    try:
        return not split_value(value)[1]
    except errors.NumberError:
        return False
