"""The rows of a scene: the columns of each source.

A row is a line of a file or a Python dict, with values for some of the columns.
"""

from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import Any, NamedTuple

from radcalc import errors
from radcalc.calculators.point_laws import CONE, LOBE
from radcalc.distributions.sources import read_lines
from radcalc.errors import listed, quote
from radcalc.files import columns, where
from radcalc.files.columns import NamedHead
from radcalc.quantities import describe
from radcalc.quantities.column_titles import read_title
from radcalc.quantities.symbols import ANY, SYMBOLS, Symbol, names_of_kinds
from radcalc.units import NUMBER, Unit
from radcalc.units.amounts import split_value
from radcalc.units.dimensions import LENGTH
from radcalc.units.table import resolve

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
HEADER = "a header such as x,y,z,flux and rows below it"
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
    name, texts = read_lines(path, "a CSV file with a row for each source")
    lines = [*enumerate(texts, 1)]
    head = NamedHead(name, lines, _heads, "source", HEADER, COMMENT)
    table = head.table
    titles, units = _header(table.titles, where(name, head.title_line))
    rows = []
    for number, line in head.below:
        cells = zip(titles, table.cells(number, line), strict=True)
        filled = {column: cell for column, cell in cells if cell}
        rows.append(Row(where(name, number), filled, titles))
        for column in filter(COLUMNS.__contains__, filled):
            for text in columns.MARKED.findall(filled[column]):
                if problem := table.decimals.conflict(text, number):
                    raise rows[-1].error(column, problem, columns.MARKS)
    _read_numbers(rows, units, bool(table.decimals.comma))
    notes = []
    comments = [(number, line) for number, line in lines if line.lstrip()[:1] == COMMENT]
    like_rows = [str(k) for k, line in comments if len(head.cells_of(line)) == table.width]
    if like_rows:
        lines_text = f"lines {listed(like_rows)}"
        notes.append(f"{name}: comments with as many cells as the rows, skipped: {lines_text}")
    if head.preamble:
        skipped = "the lines of text above are skipped"
        notes.append(f"{name}: the titles are in line {head.title_line}; {skipped}")
    return rows, notes


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
            problem = f"{where}: column {number} has no title"
            raise errors.ConditionError(problem, "a title, or no column")
        name, unit = _column(title, where)
        if name in names:
            problem = f"{where}: column '{quote(title)}' appears twice"
            raise errors.ConditionError(problem, "each column once")
        names[name] = title
        if unit:
            units[name] = unit
    return names, units


def _column(title: str, where: str) -> tuple[str, Unit | None]:
    """Return the name of a column and its unit: x (m), x [cm], x_m, x / m, or x."""
    normalized = _name(title)
    name = max(_heads(title), key=len, default="")
    if name and name == normalized:
        return name, None
    if name in TEXTS:
        problem = f"{where}: column '{quote(title)}' has a unit"
        raise errors.ConditionError(problem, f"'{name}' alone")
    if name and (unit := _unit(name, title, where)):
        return name, unit
    near = [typed(head) for head in errors.nearest(normalized, KNOWN, 3)]
    hint = ", ".join(near) or "x, y, z, flux, intensity, distribution, aim_x, rotate, name ..."
    raise errors.ConditionError(f"{where}: unknown column '{quote(title)}'", hint)


def _heads(title: str) -> list[str]:
    """Return the names of columns with which a title begins."""
    text = _name(title)
    return [h for h in KNOWN if text.startswith(h) and not text[len(h) :][:1].isalpha()]


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
        problem = f"{where}, column '{quote(title)}': {error.message}"
        raise errors.ConditionError(problem, error.hint or example) from None
    if unit.dimension not in symbol.dimensions or unit.dimension == NUMBER:
        problem = f"{where}, column '{quote(title)}': takes {symbol.takes}, not {describe(unit)}"
        raise errors.ConditionError(problem, example)
    return unit if _name(matched.name) == name else None


def rows_of_dicts(sources: Sequence[Mapping[str, Any]]) -> list[Row]:
    """Return the rows of a list of dicts, whose keys are titles; None means missing."""
    rows = []
    headers: dict[tuple[str, ...], tuple[dict[str, str], dict[str, Unit]]] = {}
    for number, source in enumerate(sources, 1):
        if not isinstance(source, Mapping):
            problem = f"source {number} is a {type(source).__name__}"
            raise errors.ConditionError(problem, "a dict for each source")
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
