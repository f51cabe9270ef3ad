"""The rows of a scene: the columns of each source, and a reader of sources.

A row is a line of a file or a Python dict, with values for some of the columns.
"""

import os
import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import partial
from numbers import Real
from typing import Any, NamedTuple

from radcalc import errors
from radcalc.calculators import kinds
from radcalc.calculators.point_laws import CONE, LOBE, SHAPED
from radcalc.calculators.results import LINKS_HINT, MISSING_LINK
from radcalc.derivation import coherent_unit_of, format_value
from radcalc.distributions.distribution import DOWN, Distribution, Photometry, Pose
from radcalc.distributions.files import read_lines
from radcalc.distributions.formula import Cone, Isotropic, Lobe
from radcalc.distributions.scene import Emitter, Panel, Source
from radcalc.distributions.sources import PATH, photometry
from radcalc.errors import listed, quote
from radcalc.files import columns, text
from radcalc.files.table import Table
from radcalc.geometry import cones
from radcalc.geometry.directions import Vector, minus
from radcalc.inputs.given import Input, Inputs
from radcalc.inputs.places import IN_METRES
from radcalc.inputs.reading import read_as
from radcalc.laws import surface
from radcalc.laws.point import CONICAL, ISOTROPIC, LOBED, WIDTHS
from radcalc.laws.solver import TO_DIGITS, Disagreement, Known
from radcalc.laws.solver import solve as follow
from radcalc.quantities.column_titles import read_title
from radcalc.quantities.light import KIND_NAMES, describe
from radcalc.quantities.symbols import ANY, SYMBOLS, Symbol, names_of_kinds
from radcalc.units.amounts import split_value
from radcalc.units.dimensions import LENGTH
from radcalc.units.table import resolve, unit_of
from radcalc.units.unit import NUMBER, Unit

LAMBERTIAN = "lambertian"
SHAPES = (ISOTROPIC, CONICAL, LOBED, LAMBERTIAN)
PLACE, AIM, DIRECTION = (
    tuple(f"{word}{axis}" for axis in "xyz") for word in ("", "aim-", "direction-")
)
SIZE = ("area", "width", "length")
STRENGTH = ("flux", "intensity")  # of any source
SURFACE = ("radiance", "exitance")  # of a Lambertian source
TAKES = {**SHAPED, LAMBERTIAN: (*SIZE, *SURFACE)}


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
NO_NAME = re.compile(r"[^\w.+-]+")  # characters that names of results do not have


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


class NamedSource(NamedTuple):
    """A source of a scene, and its name in results."""

    name: str
    source: Source


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
            f"{text.where(name, number)}: there is only one column", "a header such as x,y,z,flux"
        )
    cells, below = _with_units(lines[begin:], delimiter)
    titles, units = _header(cells, text.where(name, number))
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
    table = Table(partial(text.refusal, name), delimiter, len(titles), [list(titles.values())])
    for number, line in lines:
        cells = table.cells(number, line)
        filled = {column: cell for column, cell in zip(titles, cells, strict=True) if cell}
        rows.append(Row(text.where(name, number), filled, titles))
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
    if unit is None or not _is_bare(value):
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


class Reader:
    """A reader that turns rows into sources of one kind of light, with assumptions and notes."""

    def __init__(self, links: Inputs, folder: str = "") -> None:
        self.links, self.folder = links, folder
        self.kind = ""
        self.assumptions: dict[str, None] = {}
        self.notes: dict[str, None] = {}
        self.files: dict[str, Photometry] = {}
        self.fluxes: dict[Distribution, float] = {}

    def sources(self, rows: Sequence[Row]) -> list[NamedSource]:
        """Return the sources of rows, by default named by number; refuse a repeated name."""
        placed: list[NamedSource] = []
        names: dict[str, Row] = {}
        for number, row in enumerate(rows, 1):
            given = row.cells.get("name", number)
            if not isinstance(given, (str, Real)):
                raise row.error("name", f"a {type(given).__name__} is not a name", "a text")
            name = NO_NAME.sub("-", str(given))
            if name in names:
                raise row.error(
                    "name",
                    f"'{quote(name)}' is already the source of {names[name].where}",
                    "a name for each source, or none",
                )
            names[name] = row
            placed.append(self.source(name, row))
        return placed

    def source(self, name: str, row: Row) -> NamedSource:
        """Return the source of a row: an emitter with a distribution, or a Lambertian patch."""
        given = {c: self.read(row, c) for c in row.cells if c not in TEXTS}
        place = self.point(row, given, PLACE)
        shape, photometry = self.shape(row, given)
        pose = self.pose(row, given, place, shape != ISOTROPIC)
        strengths = [
            item for item in given.values() if item.symbol.generic in (*STRENGTH, *SURFACE)
        ]
        if len(strengths) > 1:
            raise row.both(*(item.name for item in strengths[:2]))
        strength = strengths[0] if strengths else None
        label = f"source '{quote(name)}' ({row.where})"
        if shape == LAMBERTIAN:
            return NamedSource(name, self.patch(label, row, given, strength, place, pose))
        self.assumptions["sources are points, except for rectangles"] = None
        factor = self.factor(row, photometry.distribution, strength)
        source = Emitter(label, place, pose, photometry.distribution, factor, photometry.size)
        return NamedSource(name, source)

    def read(self, row: Row, column: str) -> Input:
        """Read a cell as an input; take a position without a unit in metres."""
        symbol, value = COLUMNS[column], row.cells[column]
        number = value[0] if isinstance(value, tuple) else value
        if isinstance(number, bool) or not isinstance(number, (str, Real)):
            raise row.error(
                column, f"a {type(number).__name__} is not a value", "one number or text"
            )
        is_place = symbol.dimensions == (LENGTH,) and column in (*PLACE, *AIM, *DIRECTION)
        if is_place and _is_bare(value):
            self.assumptions[IN_METRES] = None
            value = f"{value} m" if isinstance(value, str) else (value, resolve("m"))
        try:
            return read_as(symbol, value)
        except errors.RadcalcError as error:
            message, hint = error.spelled(errors.Plain)
            hint = hint.removeprefix(f"{column} ")
            if message.startswith("the unit of") and row.titles:
                unit = symbol.example.lstrip("0123456789.")
                hint += f", or a unit in the header: {typed(column)} ({unit})"
            raise row.error(column, message.replace(column, typed(column), 1), hint) from None

    def point(self, row: Row, given: Inputs, names: Sequence[str]) -> Vector:
        for name in names:
            if name not in given:
                problem = "is blank" if name in row.titles else "is missing"
                hint = ", ".join(map(typed, names))
                raise errors.ConditionError(
                    f"{row.where}: {typed(name)} {problem}", f"all of {hint}"
                )
        x, y, z = (float(given[name].value) for name in names)
        return x, y, z

    def pose(self, row: Row, given: Inputs, place: Vector, is_aimed: bool) -> Pose:
        """Return the direction of a source: to its aim, as given, or straight down."""
        aims = [names for names in (AIM, DIRECTION) if any(name in given for name in names)]
        if len(aims) > 1:
            raise errors.ConditionError(
                f"{row.where}: aim_x cannot be used with direction_x",
                "a point to aim at, or a direction",
            )
        rotate = given["rotate"].value if "rotate" in given else 0.0
        if not aims:
            if is_aimed:
                self.assumptions["a source without an aim points straight down"] = None
            return Pose(DOWN, rotate)
        toward = self.point(row, given, aims[0])
        direction = minus(toward, place) if aims[0] == AIM else toward
        if not any(direction):
            if aims[0] == AIM:
                raise row.error(AIM[0], "the source is aimed at its own position", "another point")
            raise row.error(DIRECTION[0], "0,0,0 has no direction", "a vector other than 0")
        return Pose(direction, rotate)

    def shape(self, row: Row, given: Inputs) -> tuple[str, Photometry]:
        """Return the name of a shape, empty for other distributions, and the distribution."""
        text = row.cells.get("distribution")
        names = set(given) | {item.symbol.generic for item in given.values()}
        shapes = [shape for shape, takes in TAKES.items() if names.intersection(takes)]
        if text is None:
            if len(shapes) > 1:
                raise errors.ConditionError(
                    f"{row.where}: it has columns for {' and for '.join(shapes)}",
                    "only one of them",
                )
            shape = shapes[0] if shapes else ISOTROPIC
            if not shapes:
                self.assumptions["a source without a distribution is isotropic"] = None
        elif isinstance(text, str) and text.lower() in SHAPES:
            shape = text.lower()
        else:
            shape = ""
        self.refuse_idle(row, given, shape)
        if not shape:
            return "", self.photometry(row, text)
        if shape == CONICAL:
            return shape, Photometry(Cone(self.width(row, given, shape, "half-angle")), "")
        if shape == LOBED:
            return shape, Photometry(Lobe(self.width(row, given, shape, "exponent")), "")
        return shape, Photometry(Isotropic(), "")

    def photometry(self, row: Row, text: Any) -> Photometry:
        """Return the distribution of a file, relative to the scene's folder, or an expression."""
        if not isinstance(text, str):
            return self._photometry(row, text)
        in_folder = os.path.join(self.folder, text)
        if PATH.search(text) or os.path.exists(in_folder):
            text = in_folder
        if text not in self.files:
            self.files[text] = photometry = self._photometry(row, text)
            head = f"{quote(os.path.basename(text))}: "
            self.assumptions.update({head + remark: None for remark in photometry.assumptions})
            self.notes.update({head + remark: None for remark in photometry.notes})
        return self.files[text]

    def _photometry(self, row: Row, source: Any) -> Photometry:
        try:
            return photometry(source)
        except errors.RadcalcError as error:
            raise row.error("distribution", *error.spelled(errors.Plain)) from None

    def width(self, row: Row, given: Inputs, shape: str, wanted: str) -> float:
        """Return the half angle of a cone [rad], or the exponent of a lobe."""
        sizes = [given[name] for name in TAKES[shape] if name in given]
        if not sizes:
            what, hint = (
                "shape" if shape == LOBED else "width",
                " or ".join(map(typed, TAKES[shape])),
            )
            raise errors.ConditionError(f"{row.where}: the {what} of the {shape} is missing", hint)
        known = {
            size.name: Known(float(size.value), size.rounding * abs(float(size.value)))
            for size in sizes
        }
        names = " and ".join(typed(size.name) for size in sizes)
        try:
            solution = follow(WIDTHS[shape], known)
        except Disagreement as error:
            unit = coherent_unit_of(error.name)
            values = [format_value(value, unit) for value in (error.given, error.implied)]
            problem = f"{names} contradict each other: {' is not '.join(values)}"
            raise errors.ConditionError(f"{row.where}: {problem}", "only one of them") from None
        if solution.agreed:
            self.notes[f"{row.where}: {names} agree {TO_DIGITS}"] = None
        return float(solution.values[wanted].value)

    def refuse_idle(self, row: Row, given: Inputs, shape: str) -> None:
        useful = (*PLACE, *AIM, *DIRECTION, "rotate", *STRENGTH, *TAKES.get(shape, ()))
        idle = [n for n, item in given.items() if {n, item.symbol.generic}.isdisjoint(useful)]
        if idle:
            what = shape or "a file or an expression"
            raise row.error(idle[0], f"does not apply to {what}", "a blank cell there")

    def factor(self, row: Row, distribution: Distribution, strength: Input | None) -> float:
        """Return the factor from a distribution to intensities in the scene's kind."""
        if strength is None:
            if not distribution.kind:
                raise errors.ConditionError(
                    f"{row.where}: the flux or intensity of the source is missing",
                    "flux or intensity, with its unit: 800lm",
                )
            return self.in_kind(row, "distribution", distribution.kind)
        if distribution.kind:
            self.assumptions["scaling keeps only the shape of the distribution"] = None
        if strength.symbol.generic == "intensity":
            unscaled = float(distribution.intensity(0.0, 0.0))
            what = "intensity on its axis"
        else:
            unscaled, what = self.flux(row, distribution), "flux"
        if not unscaled > 0:
            raise row.error(strength.name, f"the distribution has no {what}", "another quantity")
        return self.amount(row, strength) / unscaled

    def flux(self, row: Row, distribution: Distribution) -> float:
        if distribution not in self.fluxes:
            try:
                self.fluxes[distribution] = distribution.flux().value
            except errors.ConditionError as error:
                raise row.error("distribution", *error.spelled(errors.Plain)) from None
        return self.fluxes[distribution]

    def amount(self, row: Row, given: Input) -> float:
        kind = kinds.kind_of(given)
        return float(given.value) * self.in_kind(row, given.name, kind)

    def in_kind(self, row: Row, column: str, kind: str) -> float:
        """Return the factor from a kind of light to the scene's, the kind of the first source."""
        if not self.kind:
            self.kind = kind
        if kind == self.kind:
            return 1.0
        factor = kinds.linking_factor(self.links, self.kind, kind)
        if factor is None:
            raise row.error(
                column,
                f"it is {KIND_NAMES[kind]}, other sources are {KIND_NAMES[self.kind]}: "
                + MISSING_LINK,
                LINKS_HINT,
            )
        if factor.assumption:
            self.assumptions[factor.assumption] = None
        self.notes.update(dict.fromkeys(factor.notes))
        return float(factor.value)

    def patch(
        self, label: str, row: Row, given: Inputs, strength: Input | None, place: Vector, pose: Pose
    ) -> Source:
        """Return a Lambertian patch: an exact rectangle, or a small area."""
        sides = [given[name].value for name in ("width", "length") if name in given]
        if len(sides) == 1 or ("area" in given) == bool(sides):
            raise errors.ConditionError(
                f"{row.where}: the size of the patch is missing or given twice",
                "width and length, or area",
            )
        if strength is None:
            raise errors.ConditionError(
                f"{row.where}: a light quantity of the patch is missing",
                "luminance, exitance, flux or intensity, with its unit",
            )
        area = float(given["area"].value if "area" in given else sides[0] * sides[1])
        known = {strength.symbol.generic: Known(self.amount(row, strength)), "area": Known(area)}
        radiance = float(follow([*surface.LAWS, surface.FLAT], known).values["radiance"].value)
        if sides:
            return Panel(label, place, pose, float(sides[0]), float(sides[1]), radiance)
        self.assumptions["a patch given by its area is small compared to its distance"] = None
        return Emitter(
            label, place, pose, Lobe(1.0), radiance * area, cones.size(area), is_patch=True
        )


def _is_bare(value: Any) -> bool:
    if not isinstance(value, str):
        return not isinstance(value, tuple)
    try:
        return not split_value(value)[1]
    except errors.NumberError:
        return False
