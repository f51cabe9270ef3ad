"""The sources of a scene, from its rows."""

import os
import re
from collections.abc import Sequence
from numbers import Real
from typing import Any, NamedTuple

from radcalc import errors, geometry
from radcalc.answer import coherent_unit_of, format_value
from radcalc.calculators import kinds, scene_rows
from radcalc.calculators.point_laws import SHAPED
from radcalc.calculators.results import LINKS_HINT, MISSING_LINK
from radcalc.calculators.scene_rows import AIM, DIRECTION, PLACE, Row, is_bare, typed
from radcalc.distributions.distribution import DOWN, Distribution, Photometry, Pose
from radcalc.distributions.scene import Emitter, Panel, Source
from radcalc.distributions.sources import PATH, Cone, Isotropic, Lobe, photometry
from radcalc.errors import quote
from radcalc.geometry.projections import Vector, minus
from radcalc.inputs import Input, Inputs
from radcalc.inputs.places import IN_METRES
from radcalc.inputs.quantities import as_seen
from radcalc.inputs.reading import read_as
from radcalc.laws import surface
from radcalc.laws.point import CONICAL, ISOTROPIC, LOBED, WIDTHS
from radcalc.laws.solver import TO_DIGITS, Disagreement, Known
from radcalc.laws.solver import solve as follow
from radcalc.quantities import KIND_NAMES
from radcalc.units.dimensions import LENGTH
from radcalc.units.table import resolve

LAMBERTIAN = "lambertian"
SHAPES = (ISOTROPIC, CONICAL, LOBED, LAMBERTIAN)
TAKES = {**SHAPED, LAMBERTIAN: (*scene_rows.SIZE, *scene_rows.SURFACE)}
NO_NAME = re.compile(r"[^\w.+-]+")  # characters that names of results do not have


class NamedSource(NamedTuple):
    """A source of a scene, and its name in results."""

    name: str
    source: Source


class Reader:
    """A reader that turns rows into sources of one kind of light, with assumptions and notes."""

    def __init__(self, lit: kinds.LightInputs, folder: str = "") -> None:
        self.links, self.lumens, self.folder = lit.links, lit.lumens, folder
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
                problem = f"'{quote(name)}' is already the source of {names[name].where}"
                raise row.error("name", problem, "a name for each source, or none")
            names[name] = row
            placed.append(self.source(name, row))
        return placed

    def source(self, name: str, row: Row) -> NamedSource:
        """Return the source of a row: an emitter with a distribution, or a Lambertian patch."""
        given = {c: self.read(row, c) for c in row.cells if c not in scene_rows.TEXTS}
        place = self.point(row, given, PLACE)
        shape, photometry = self.shape(row, given)
        pose = self.pose(row, given, place, shape != ISOTROPIC)
        strengths = [
            item
            for item in given.values()
            if item.symbol.generic in (*scene_rows.STRENGTH, *scene_rows.SURFACE)
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
        symbol, value = scene_rows.COLUMNS[column], row.cells[column]
        number = value[0] if isinstance(value, tuple) else value
        if isinstance(number, bool) or not isinstance(number, (str, Real)):
            problem = f"a {type(number).__name__} is not a value"
            raise row.error(column, problem, "one number or text")
        is_place = symbol.dimensions == (LENGTH,) and column in (*PLACE, *AIM, *DIRECTION)
        if is_place and is_bare(value):
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
            problem = f"{row.where}: aim_x cannot be used with direction_x"
            raise errors.ConditionError(problem, "a point to aim at, or a direction")
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
                problem = f"{row.where}: it has columns for {' and for '.join(shapes)}"
                raise errors.ConditionError(problem, "only one of them")
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
        useful = (*PLACE, *AIM, *DIRECTION, "rotate", *scene_rows.STRENGTH, *TAKES.get(shape, ()))
        idle = [n for n, item in given.items() if {n, item.symbol.generic}.isdisjoint(useful)]
        if idle:
            what = shape or "a file or an expression"
            raise row.error(idle[0], f"does not apply to {what}", "a blank cell there")

    def factor(self, row: Row, distribution: Distribution, strength: Input | None) -> float:
        """Return the factor from a distribution to intensities in the scene's kind."""
        if strength is None:
            if not distribution.kind:
                problem = f"{row.where}: the flux or intensity of the source is missing"
                raise errors.ConditionError(problem, "flux or intensity, with its unit: 800lm")
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
        kind = kinds.kind_of(as_seen(given, self.lumens))
        return float(given.value) * self.in_kind(row, given.name, kind)

    def in_kind(self, row: Row, column: str, kind: str) -> float:
        """Return the factor from a kind of light to the scene's, the kind of the first source."""
        if not self.kind:
            self.kind = kind
        if kind == self.kind:
            return 1.0
        factor = kinds.linking_factor(self.links, self.kind, kind)
        if factor is None:
            problem = (
                f"it is {KIND_NAMES[kind]}, other sources are {KIND_NAMES[self.kind]}: "
                + MISSING_LINK
            )
            raise row.error(column, problem, LINKS_HINT)
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
            problem = f"{row.where}: the size of the patch is missing or given twice"
            raise errors.ConditionError(problem, "width and length, or area")
        if strength is None:
            problem = f"{row.where}: a light quantity of the patch is missing"
            hint = "luminance, exitance, flux or intensity, with its unit"
            raise errors.ConditionError(problem, hint)
        area = float(given["area"].value if "area" in given else sides[0] * sides[1])
        known = {strength.symbol.generic: Known(self.amount(row, strength)), "area": Known(area)}
        radiance = float(follow([*surface.LAWS, surface.FLAT], known).values["radiance"].value)
        if sides:
            return Panel(label, place, pose, float(sides[0]), float(sides[1]), radiance)
        self.assumptions["a patch given by its area is small compared to its distance"] = None
        return Emitter(
            label, place, pose, Lobe(1.0), radiance * area, geometry.size(area), is_patch=True
        )
