"""Tables of angles and intensities as text, from a laboratory or a spreadsheet.

The first column has the polar angles from the source's axis; the others have intensities::

    gamma (deg),I (cd)         gamma,C0 (cd),C90 (cd)         angle (deg);C0-C180 (W/sr)
    0,300                      0,300,300                      -90;0
    15,290                     15,290,280                     0;12,5
    ...                        ...                            90;0

A single column with angles from 0 upwards represents every plane.  Columns of C planes (`C0`,
`C 22.5`, `phi=45`, or the angle alone) that span 90 or 180 degrees are mirrored; other columns must
cover the whole circle.  With angles from -90 to 90 degrees, a column is a cut through the axis,
with the negative angles in the opposite half plane.

Commas, semicolons, tabs, bars or blanks separate columns; numbers may have decimal commas unless
commas separate columns.  Lines that begin with #, %, // or ;; are comments; the last one may have
the titles.  The unit of the intensities is in their titles, in a row of units below them, or in a
comment such as `# I (cd)`; without a unit they are relative.  Angles are in degrees unless the
title of the first column has another unit.
"""

import math
from collections.abc import Sequence
from contextlib import suppress
from typing import Any, NoReturn

import numpy

from radcalc.distributions import contents as column_titles
from radcalc.distributions import distribution
from radcalc.distributions.distribution import SLACK, Grid, Photometry
from radcalc.errors import ConditionError, Hint, listed, quote
from radcalc.files import columns, refusal
from radcalc.files.columns import Head, NumberedLine, Table, is_number
from radcalc.quantities import read as facts_of

FLAT = 180.0  # [deg]
AS_RADIANS = 3.15  # up to this, angles without a unit may be in radians


def read(lines: Sequence[str], name: str) -> Photometry:
    """Read a table of angles and intensities.

    Returns
    -------
    Photometry
        Intensities in coherent SI, or relative ones (kind "") if there is no unit.

    Raises
    ------
    ConditionError
        With the line: for other columns, angles that do not rise, missing or negative values, and
        units or planes that cannot be identified.

    Examples
    --------
    >>> rows = ["0;300", "15;290", "30;260", "45;200", "60;110", "75;30", "90;0"]
    >>> lamp = read(["gamma;I (cd)", *rows], "lamp.csv").distribution
    >>> round(lamp.flux().value, 4), lamp.kind
    (791.3485, 'v')
    """
    return _Reader(lines, name).photometry()


class _Head(Head):
    """The head of a table whose rows begin with an angle; the titles may be C planes alone."""

    def __init__(self, lines: Sequence[str], name: str) -> None:
        self.name = name
        super().__init__([*enumerate(lines, 1)])

    def error(self, number: int, problem: str, hint: Hint) -> ConditionError:
        return refusal(self.name, number, problem, str(hint))

    def no_data(self, rows: Sequence[NumberedLine]) -> ConditionError:
        problem = "there is no row of numbers" if rows else "there is no data"
        return self.error(rows[0][0] if rows else 0, problem, "rows of an angle and an intensity")

    def is_data(self, cells: Sequence[str], is_named: bool) -> bool:
        return is_number(cells[0])

    def are_names(self, cells: Sequence[str]) -> bool:
        return not is_number(cells[0])

    def is_bad(self, *lines: str) -> bool:
        return False

    def are_titles(self, cells: Sequence[str]) -> bool:
        return True

    def in_comments(self, width: int) -> list[str]:
        """Return the titles from the last comment with some, angles first."""
        for comment in reversed(self.comments):
            titles = self.titles_in(comment, width)
            with suppress(ConditionError):  # a comment is free text
                if titles and not is_number(titles[0]):
                    column_titles.angles(titles[0])
                    return titles
        return []


class _Reader:
    def __init__(self, lines: Sequence[str], name: str) -> None:
        self.name = name
        self.head = _Head(lines, name)
        self.assumptions: list[str] = []
        if self.head.preamble:
            self.assumptions.append(f"the titles are in line {self.head.title_line}")
        self.comments = [*self.head.comments, *[line.strip() for _, line in self.head.preamble]]
        self.rows = self.head.below

    def refuse(self, number: int, problem: str, hint: str) -> NoReturn:
        raise refusal(self.name, number, problem, hint)

    def photometry(self) -> Photometry:
        """Return the intensities [cd, W/sr or photons] of the planes in the titles."""
        titles = list(self.head.table.titles) or [""] * self.head.table.width
        head = self.head.title_line or self.head.begin
        try:
            angle_unit = column_titles.angles(titles[0])
            titled_columns = [column_titles.column(title) for title in titles[1:]]
            kind, factors = self.units(titled_columns)
        except ConditionError as error:
            self.refuse(head, error.message, error.hint)
        angles, values = self.numbers(len(titles))
        degrees = self.degrees(angles, math.degrees(angle_unit.factor) if angle_unit else 0.0)
        planes = self.planes(titles[1:], titled_columns, head)
        values = values * factors
        if degrees[0] < 0:
            polar, planes, rows = self.cuts(degrees, planes, values)
        else:
            polar, rows = degrees, values.T
            if SLACK < polar[0] < FLAT / 2:
                problem = f"the angles begin at {polar[0]:g} deg, not on the axis"
                self.refuse(self.rows[0][0], problem, "a row for 0 deg")
        try:
            around, rows = self.around(planes, rows)
        except ConditionError as error:
            self.refuse(head, error.message, error.hint)
        return Photometry(
            Grid(numpy.radians(polar), numpy.radians(around), rows, kind),
            "CSV table",
            assumptions=(*self.assumptions, *distribution.end_of(polar)),
            notes=self.notes,
        )

    def numbers(self, width: int) -> tuple[Any, Any]:
        """Return the rising angles, and the values (angles, planes), in the units of the table."""
        if width < 2:
            problem = "there is only one column"
            self.refuse(self.rows[0][0], problem, "an angle and an intensity in each row")
        if len(self.rows) < 2:
            self.refuse(self.rows[0][0], "one row is not a table", "two rows or more")
        text = self.head.table
        table = numpy.array([self.row(number, line, text) for number, line in self.rows])
        text.finish()
        angles, values = table[:, 0], table[:, 1:]
        for (number, _), angle, before in zip(self.rows[1:], angles[1:], angles, strict=False):
            if angle - before < distribution.CLOSEST:
                problem = f"the angles do not rise: {angle:g} after {before:g}"
                self.refuse(number, problem, "rising angles")
        values, self.notes = distribution.without_noise(
            values,
            lambda place, problem, hint: self.refuse(
                self.rows[place // (width - 1)][0], problem, hint
            ),
        )
        return angles, values

    def row(self, number: int, line: str, table: Table) -> list[float]:
        if table.delimiter == ",":
            values = columns.numbers_at_once(line.split(table.delimiter))
            if values is not None and len(values) == table.width:
                return values
        cells = table.cells(number, line)
        for k, cell in enumerate(cells):
            if columns.finite(cell, True) is None:
                what = "an intensity" if k else "an angle"
                self.refuse(number, f"'{quote(cell)}' in column {k + 1} is not {what}", "a number")
        return [table.number(cell, number, is_value=k > 0) for k, cell in enumerate(cells)]

    def degrees(self, angles: Any, factor: float) -> Any:
        """Return the angles in degrees; a factor of 0 means that their unit is not declared."""
        if not factor:
            if abs(angles).max() <= AS_RADIANS:
                problem = f"the unit of the angles, up to {angles[-1]:g}, is missing"
                self.refuse(self.rows[-1][0], problem, "a title such as angle (deg) or angle (rad)")
            self.assumptions.append("the angles are in degrees")
        degrees = angles * (factor or 1.0)
        if abs(degrees).max() > FLAT + SLACK:
            line = self.rows[int(abs(degrees).argmax())][0]
            problem = f"a polar angle of {degrees[abs(degrees).argmax()]:g} deg is out of range"
            hint = "angles from 0 to 180 deg, or from -180 to 180 deg; not a spectrum"
            self.refuse(line, problem, hint)
        return numpy.clip(degrees, -FLAT, FLAT)

    def units(self, titled_columns: Sequence[column_titles.Column]) -> tuple[str, Any]:
        declared = [column.unit for column in titled_columns if column.unit]
        common = None if declared else column_titles.in_comments(self.comments)
        if common:
            self.assumptions.append(f"intensities in {quote(common.text)}, according to a comment")
        elif not declared:
            self.assumptions.append("relative intensities: the titles have no unit, such as cd")
        units = [common] * len(titled_columns) if common else declared
        if len(units) not in (0, len(titled_columns)):
            raise ConditionError("some columns have a unit, others do not", "one for each")
        facts = [facts_of(unit) for unit in units if unit]
        kinds = {fact.kind for fact in facts if fact} or {""}
        if len(kinds) > 1:
            raise ConditionError("the columns have different kinds of light", "one kind")
        return kinds.pop(), numpy.array([unit.factor for unit in units if unit] or 1.0)

    def planes(
        self, titles: Sequence[str], titled_columns: Sequence[column_titles.Column], head: int
    ) -> Any:
        """Return the C planes of the titles [deg], rising; one untitled column is plane 0."""
        if len(titled_columns) == 1 and titled_columns[0].plane is None:
            return numpy.zeros(1)
        unknown = [
            title
            for title, column in zip(titles, titled_columns, strict=True)
            if column.plane is None
        ]
        if unknown:
            unknown_titles = f" ({listed(unknown)})" if any(unknown) else ""
            problem = (
                f"{len(unknown)} of {len(titled_columns)} columns{unknown_titles} have no C plane "
                "in their titles"
            )
            self.refuse(head, problem, "titles such as gamma,C0,C90; or one column of intensities")
        planes = numpy.array([column.plane for column in titled_columns])
        if (numpy.diff(planes) <= 0).any() or planes[0] < -FLAT or planes[-1] > 2 * FLAT:
            plane_texts = listed([f"{plane:g}" for plane in planes])
            self.refuse(head, f"the C planes are {plane_texts}", "rising angles, from 0 to 360 deg")
        for column in titled_columns:
            if column.opposite is not None and column.opposite - (column.plane or 0) != FLAT:
                title = f"C{column.plane:g}-C{column.opposite:g}"
                self.refuse(head, f"{title} is not a plane through the axis", "such as C0-C180")
        return planes

    def cuts(self, degrees: Any, planes: Any, values: Any) -> tuple[Any, Any, Any]:
        """Return the half planes of cuts through the axis: negative angles are opposite."""
        if abs(degrees[0] + degrees[-1]) > SLACK:
            problem = f"the angles go from {degrees[0]:g} to {degrees[-1]:g} deg"
            self.refuse(self.rows[-1][0], problem, "as far on both sides of the axis, or from 0 up")
        if planes[-1] - planes[0] >= FLAT:
            self.refuse(
                self.rows[0][0],
                f"an angle is negative, but the planes C{planes[0]:g} to C{planes[-1]:g} already "
                "cover both sides of the axis",
                "angles from 0 up, or planes from C0 to below C180",
            )
        polar = numpy.unique(numpy.append(abs(degrees), 0.0))
        sides = [
            numpy.array([numpy.interp(sign * polar, degrees, column) for column in values.T])
            for sign in (1, -1)
        ]
        azimuths = numpy.concatenate([planes, planes + FLAT])
        order = numpy.argsort(azimuths)
        self.assumptions.append(
            "each column is a cut through the axis: negative angles are in the opposite half plane"
        )
        return polar, azimuths[order], numpy.concatenate(sides)[order]

    def around(self, planes: Any, rows: Any) -> tuple[Any, Any]:
        """Return the planes of the whole circle [deg], and their values."""
        if len(planes) == 1:
            self.assumptions.append("the only column represents every plane through the axis")
            return numpy.zeros(1), rows
        span = planes[-1] - planes[0]
        if span in (FLAT / 2, FLAT) and planes[0] % (FLAT / 2) == 0:
            self.assumptions.append(
                f"the planes C{planes[0]:g} to C{planes[-1]:g} also represent their mirror images"
            )
            return distribution.mirrored(planes, rows)
        return distribution.closed(planes, rows)
