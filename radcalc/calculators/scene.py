"""A scene: what many sources give together at points, and how even that is."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from os.path import dirname
from typing import Any, NamedTuple

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import light
from radcalc.calculators.results import element, value
from radcalc.calculators.scene_rows import Placed, Reader, rows_of_dicts, rows_of_file
from radcalc.derivation import coherent_unit_of, format_number, format_value
from radcalc.distributions.scene import Emitter, Field, Statistics, field, point_text, unit
from radcalc.geometry.directions import UP
from radcalc.geometry.numerics.vectors import Vector
from radcalc.given import Inputs
from radcalc.quantities.symbols import SYMBOLS
from radcalc.units.dimensions import LENGTH
from radcalc.units.table import NUMBER

LIGHT_OF_ALL = ("mean-irradiance", "minimum-irradiance", "maximum-irradiance")
EVENNESS = ("uniformity", "minimum-to-maximum")
SHARE = "share-"  # before the name of a source


def is_of_all(name: str) -> bool:
    """Whether a result is of all the points, and not of each."""
    symbol = SYMBOLS.get(name.removeprefix("radiant-"))
    return symbol is not None and (symbol.generic in LIGHT_OF_ALL or symbol.name in EVENNESS)


def is_share(name: str) -> bool:
    """Whether a result is the share of a source."""
    return name.startswith(SHARE)


class Scene(NamedTuple):
    """Sources in one kind of light, what links that to others, and what was assumed of them."""

    sources: Sequence[Placed]
    lit: light.Lit
    assumptions: Sequence[str]
    notes: Sequence[str]


def scene(
    sources: str | Sequence[Mapping[str, Any]], links: Inputs, assumptions: Sequence[str] = ()
) -> Scene:
    """The sources of a file, or of a list with a dict for each."""
    if isinstance(sources, str):
        reader = Reader(links, dirname(sources))
        rows, notes = rows_of_file(sources)
    else:
        reader = Reader(links)
        rows, notes = rows_of_dicts(sources), []
    placed = reader.sources(rows)
    lit = light.read_light({}, links)._replace(kind=reader.kind)
    said = tuple(dict.fromkeys([*assumptions, *reader.assumptions]))
    return Scene(placed, lit, said, (*notes, *reader.notes))


class Survey:
    """What a scene gives at points, with or without the share of each source.

    The receivers face along the normal, or up.
    """

    def __init__(self, scene: Scene, normal: Vector | None, with_shares: bool = False) -> None:
        self.scene, self.with_shares = scene, with_shares
        self.normal = unit(UP if normal is None else normal)
        self.statistics = Statistics()
        self.assumptions = [*scene.assumptions]
        if normal is None:
            self.assumptions.append("the receivers face up")

    def fields(self, blocks: Iterable[Vector]) -> Iterator[Field]:
        """What points get, a block of them at a time; the statistics take them in."""
        sources = [one.source for one in self.scene.sources]
        for points in blocks:
            found = field(sources, points, self.normal, self.with_shares)
            self.statistics.add(found)
            yield found

    def at_points(self, blocks: Iterable[Vector]) -> Iterator[Answer]:
        """An answer for each block of points, whose values are arrays."""
        return map(self._values, self.fields(blocks))

    def at_point(self, point: Vector) -> Answer:
        """The answer at one point, with its derivation; the coordinates are arrays of one."""
        (answer,) = self.at_points([point])
        values = [element(value, 0) for value in answer.values]
        return self.remarks()._replace(values=values, steps=self._steps(point))

    def over_all(self, blocks: Iterable[Vector], is_grid: bool = False) -> Answer:
        """The answer over all points: mean, extremes and uniformity."""
        for _ in self.fields(blocks):
            pass
        return self.remarks(is_grid, with_values=True)

    def _values(self, found: Field) -> Answer:
        shown = light.show_light(self.scene.lit, {"irradiance": found.total})
        values = [
            Value(axis, axis, axis, coordinate, (LENGTH,), ("m",), given=coordinate)
            for axis, coordinate in zip("xyz", found.points, strict=True)
        ]
        values += shown.values["irradiance"]
        dark = found.total == 0
        for one, part in zip(self.scene.sources, found.parts, strict=False):
            share = light.show_light(self.scene.lit, {"irradiance": part}).values["irradiance"][0]
            values.append(
                share._replace(
                    name=f"{SHARE}{one.name}",
                    label=f"share of {one.name}",
                    letter=f"E_{one.name}",
                    units=(*share.units, "%") if len(part) == 1 else share.units,
                    reach={**share.reach, NUMBER: part / (found.total + dark)},
                    also="",
                )
            )
        return Answer(values)

    def remarks(self, is_grid: bool = False, with_values: bool = False) -> Answer:
        """What was assumed and is odd, once all points are known; with what all of them get."""
        told = self.statistics
        amounts = dict(zip(LIGHT_OF_ALL, (told.mean, told.least, told.most), strict=True))
        shown = light.show_light(self.scene.lit, amounts)
        values = []
        if with_values:
            values = [one for name in LIGHT_OF_ALL for one in shown.values[name]]
            if told.most > 0:
                values.append(value("uniformity", told.least / told.mean))
                values.append(value("minimum-to-maximum", told.least / told.most))
        notes = [*self.scene.notes, *shown.notes, *self._notes(is_grid)]
        return Answer(values, (*self.assumptions, *shown.assumptions), notes)

    def _notes(self, is_grid: bool) -> Iterator[str]:
        told = self.statistics
        of_points = "" if told.count == 1 else f" of {told.count} points"
        if told.most == 0:
            yield f"no light reaches {'the point' if told.count == 1 else 'any of the points'}"
        if told.behind:
            where = f", at {told.behind}{of_points}" if of_points else ""
            yield f"light from behind the receiver does not count{where}"
        for one, near in zip(self.scene.sources, told.near, strict=True):
            if near:
                where = f" at {near}{of_points}" if of_points else ""
                size = f"{one.source.size:.3g} m"
                yield f"{one.source.name} is nearer than five times its size, {size}{where}"
        if is_grid and told.most > told.least:
            ends = point_text(*told.least_at), point_text(*told.most_at)
            yield f"the least light is at {ends[0]}, the most at {ends[1]}"

    def _steps(self, point: Vector) -> list[Step]:
        """The derivation at one point: the term of each source, and their sum."""
        steps, terms = [], []
        for one in self.scene.sources:
            step, part = self._term(one, point)
            steps.append(step)
            terms.append(part)
        if len(terms) > 1:
            told = " + ".join(map(format_number, terms))
            total = self._told(float(self.statistics.most), "irradiance")
            steps.append(Step("sum over the sources", "E = E_1 + E_2 + ...", f"{told} = {total}"))
        return steps

    def _term(self, one: Placed, point: Vector) -> tuple[Step, float]:
        source, normal = one.source, self.normal
        part = max(float(source.irradiance(point, normal)[0]), 0.0)
        if isinstance(source, Emitter):
            law, reference = "E = I cos(theta) Omega0 / d^2", "inverse square law"
            intensity, cosine, distance = (float(x[0]) for x in source.terms(point, normal))
            numbers = (
                f"{self._told(intensity, 'intensity')} * {format_number(max(cosine, 0.0))} "
                f"/ ({format_number(distance)} m)^2"
            )
        else:
            law, reference = "E = L Omega_p", "projected solid angle of a rectangle, J. H. Lambert"
            omega = max(float(source.projected_solid_angle(point, normal)[0]), 0.0)
            numbers = f"{self._told(source.radiance, 'radiance')} * {format_number(omega)} sr"
        numbers = f"{numbers} = {self._told(part, 'irradiance')}"
        return Step(one.name, law, numbers, reference), part

    def _told(self, amount: float, name: str) -> str:
        return format_value(amount, coherent_unit_of(name, self.scene.lit.kind))
