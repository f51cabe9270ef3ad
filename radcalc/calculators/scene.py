"""A scene: the irradiance of many sources at points, and its uniformity."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from os.path import dirname
from typing import Any, NamedTuple

from radcalc.answer import Answer, Step, Value, coherent_unit_of, format_number, format_value
from radcalc.calculators import kinds
from radcalc.calculators.page import FILE, Operand, Page, text
from radcalc.calculators.results import element, value
from radcalc.calculators.scene_reader import NamedSource, Reader
from radcalc.calculators.scene_rows import rows_of_dicts, rows_of_file
from radcalc.distributions.scene import Emitter, Field, Statistics, field, point_text, unit
from radcalc.files import ENDINGS
from radcalc.geometry.projections import UP, Vector
from radcalc.inputs import Inputs
from radcalc.quantities.symbols import LINKS, REFINEMENTS, SYMBOLS
from radcalc.units import NUMBER
from radcalc.units.dimensions import LENGTH

PAGE = Page(
    about="Calculate the light that many sources together give at points or on a grid.",
    operand=Operand("file", "FILE.csv", FILE, ENDINGS),
    sections={
        "Points": (
            text(
                "at",
                "X,Y,Z",
                "Illuminated point (repeatable), in metres or with units.",
                repeats=True,
            ),
            "grid",
            "normal",
        ),
        "Radiant, luminous and photon quantities": (*LINKS, *REFINEMENTS),
    },
    texts={"normal": "Normal of the receivers (default 0,0,1: up)."},
    draws=True,
    takes_lines=False,
)

LIGHT_OF_ALL = ("mean-irradiance", "minimum-irradiance", "maximum-irradiance")
EVENNESS = ("uniformity", "minimum-to-maximum")
SHARE = "share-"  # before the name of a source


def is_of_all(name: str) -> bool:
    """Return whether a result is for all points together."""
    symbol = SYMBOLS.get(name.removeprefix("radiant-"))
    return symbol is not None and (symbol.generic in LIGHT_OF_ALL or symbol.name in EVENNESS)


def is_share(name: str) -> bool:
    """Return whether a result is the share of a source."""
    return name.startswith(SHARE)


class Scene(NamedTuple):
    """Sources in one kind of light, with links to other kinds, assumptions and notes."""

    sources: Sequence[NamedSource]
    lit: kinds.LightInputs
    assumptions: Sequence[str]
    notes: Sequence[str]


def scene(
    sources: str | Sequence[Mapping[str, Any]], links: Inputs, assumptions: Sequence[str] = ()
) -> Scene:
    """Return the sources of a file, or of a list of dicts."""
    lit = kinds.read_light({}, links)
    if isinstance(sources, str):
        reader = Reader(lit, dirname(sources))
        rows, notes = rows_of_file(sources)
    else:
        reader = Reader(lit)
        rows, notes = rows_of_dicts(sources), []
    placed = reader.sources(rows)
    lit = lit._replace(kind=reader.kind)
    all_assumptions = tuple(dict.fromkeys([*assumptions, *reader.assumptions]))
    return Scene(placed, lit, all_assumptions, (*notes, *reader.notes))


class Survey:
    """The irradiances of a scene at points, with or without the share of each source.

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
        sources = [placed.source for placed in self.scene.sources]
        for points in blocks:
            irradiances = field(sources, points, self.normal, self.with_shares)
            self.statistics.add(irradiances)
            yield irradiances

    def at_points(self, blocks: Iterable[Vector]) -> Iterator[Answer]:
        return map(self._values, self.fields(blocks))

    def at_point(self, point: Vector) -> Answer:
        """Return the answer at one point with its derivation; coordinates are arrays of one."""
        (answer,) = self.at_points([point])
        values = [element(value, 0) for value in answer.values]
        return self.remarks()._replace(values=values, steps=self._steps(point))

    def over_all(self, blocks: Iterable[Vector], is_grid: bool = False) -> Answer:
        for _ in self.fields(blocks):
            pass
        return self.remarks(is_grid, with_values=True)

    def _values(self, irradiances: Field) -> Answer:
        """Return the irradiances at points, with their coordinates and any shares of sources."""
        light = kinds.show_light(self.scene.lit, {"irradiance": irradiances.total})
        values = [
            Value(axis, axis, axis, coordinate, (LENGTH,), ("m",), given=coordinate)
            for axis, coordinate in zip("xyz", irradiances.points, strict=True)
        ]
        values += light.values["irradiance"]
        dark = irradiances.total == 0
        for placed, part in zip(self.scene.sources, irradiances.parts, strict=False):
            share = kinds.show_light(self.scene.lit, {"irradiance": part}).values["irradiance"][0]
            values.append(
                share._replace(
                    name=f"{SHARE}{placed.name}",
                    label=f"share of {placed.name}",
                    letter=f"E_{placed.name}",
                    units=(*share.units, "%") if len(part) == 1 else share.units,
                    reach={**share.reach, NUMBER: part / (irradiances.total + dark)},
                    also="",
                )
            )
        return Answer(values)

    def remarks(self, is_grid: bool = False, with_values: bool = False) -> Answer:
        statistics = self.statistics
        amounts = dict(
            zip(LIGHT_OF_ALL, (statistics.mean, statistics.least, statistics.most), strict=True)
        )
        light = kinds.show_light(self.scene.lit, amounts)
        values = []
        if with_values:
            values = [row for name in LIGHT_OF_ALL for row in light.values[name]]
            if statistics.most > 0:
                values.append(value("uniformity", statistics.least / statistics.mean))
                values.append(value("minimum-to-maximum", statistics.least / statistics.most))
        notes = [*self.scene.notes, *light.notes, *self._notes(is_grid)]
        return Answer(values, (*self.assumptions, *light.assumptions), notes)

    def _notes(self, is_grid: bool) -> Iterator[str]:
        """Yield notes on darkness, uncounted light, near sources, and the extremes of a grid."""
        statistics = self.statistics
        is_alone = statistics.count == 1
        of_points = "" if is_alone else f" of {statistics.count} points"
        if statistics.most == 0:
            yield f"no light reaches {'the point' if is_alone else 'any of the points'}"
        if statistics.behind:
            where = f", at {statistics.behind}{of_points}" if of_points else ""
            yield f"light from behind the receiver does not count{where}"
        for placed, near in zip(self.scene.sources, statistics.near, strict=True):
            if near:
                where = f" at {near}{of_points}" if of_points else ""
                size = f"{placed.source.size:.3g} m"
                yield f"{placed.source.name} is nearer than five times its size ({size}){where}"
        if is_grid and statistics.most > statistics.least:
            ends = point_text(*statistics.least_at), point_text(*statistics.most_at)
            yield f"the least light is at {ends[0]}, the most at {ends[1]}"

    def _steps(self, point: Vector) -> list[Step]:
        steps, terms = [], []
        for placed in self.scene.sources:
            step, part = self._term(placed, point)
            steps.append(step)
            terms.append(part)
        if len(terms) > 1:
            sum_text = " + ".join(map(format_number, terms))
            total = self._format(float(self.statistics.most), "irradiance")
            steps.append(
                Step("sum over the sources", "E = E_1 + E_2 + ...", f"{sum_text} = {total}")
            )
        return steps

    def _term(self, placed: NamedSource, point: Vector) -> tuple[Step, float]:
        """Return the step of a source's irradiance at a point, and that irradiance, at least 0."""
        source, normal = placed.source, self.normal
        part = max(float(source.irradiance(point, normal)[0]), 0.0)
        if isinstance(source, Emitter):
            law, reference = "E = I cos(theta) Omega0 / d^2", "inverse square law"
            intensity, cosine, distance = (float(x[0]) for x in source.terms(point, normal))
            numbers = (
                f"{self._format(intensity, 'intensity')} * {format_number(max(cosine, 0.0))} "
                f"/ ({format_number(distance)} m)^2"
            )
        else:
            law, reference = "E = L Omega_p", "projected solid angle of a rectangle, J. H. Lambert"
            omega = max(float(source.projected_solid_angle(point, normal)[0]), 0.0)
            numbers = f"{self._format(source.radiance, 'radiance')} * {format_number(omega)} sr"
        numbers = f"{numbers} = {self._format(part, 'irradiance')}"
        return Step(placed.name, law, numbers, reference), part

    def _format(self, amount: float, name: str) -> str:
        return format_value(amount, coherent_unit_of(name, self.scene.lit.kind))
