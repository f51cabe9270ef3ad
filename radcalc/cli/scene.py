"""`radcalc scene FILE.csv`, and `radcalc environment SOURCE`.

Commands that write a map do so if every input is valid.
"""

import math
import os
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

from radcalc import terminal
from radcalc.answer import Answer, Result, ShownInput, texts_of
from radcalc.calculators import environment as environment_page
from radcalc.calculators import scene as page
from radcalc.calculators.environment import Source, environment
from radcalc.calculators.results import element, name_in, name_of, pick
from radcalc.calculators.solved import Task
from radcalc.cli.answers import Answered, refuse_bare, result, show
from radcalc.cli.calculator import run
from radcalc.cli.command import define
from radcalc.cli.output import Output
from radcalc.cli.plot import one_case, write_map
from radcalc.cli.request import Case, Request, cases
from radcalc.cli.spelling import only_file
from radcalc.errors import ConditionError, UsageError, call, leave_out, one_of, quote, quote_path
from radcalc.errors import command as call_of
from radcalc.inputs import Input, Inputs, refuse_uncertain, shown_inputs
from radcalc.inputs.places import AS_GRID, IN_METRES, read_place
from radcalc.quantities.symbols import SYMBOLS
from radcalc.render import csv
from radcalc.terminal import CSV, JSON
from radcalc.units.ranges import MOST

COORDINATES = ("x", "y", "z")
FEW = 12  # sources whose shares are shown by default
HELP = """\
\b
Examples:
  radcalc scene room.csv --at 1,2,0.75
  radcalc scene room.csv --at 1,2,0.75 --at 3,2,0.75 --normal 0,-1,0
  radcalc scene room.csv --grid 0:6:61,0:4:41,0.75
  radcalc scene room.csv --grid 0:6:61,0:4:41,0.75 -g uniformity
  radcalc scene room.csv --grid 0:6:61,0:4:41,0.75 --plot room.svg  (isolux)
  radcalc scene room.csv --grid 0:6:61,0:4:41,0.75 --format csv > room-lux.csv
  radcalc scene room.csv --at 1,2,0.75 -g share-desk:%
  radcalc scene grow.csv --at 0,0,0 --spectrum LED-B3 -g irradiance:umol/m2/s

\b
FILE.csv has a header with the column titles, then one source in each row:
  name,x (m),y (m),z (m),aim_x,aim_y,aim_z,distribution,flux,exponent
  desk,1,2,1.2,1,2,0.75,lobe,400lm,2
  door,5,0.5,2.5,,,,downlight.ies,,

\b
x, y, z                 position; in metres unless the title or the cell has a unit
aim_x, aim_y, aim_z     point at which the source is aimed (default: straight down), or
direction_x ... _z      direction of the source's axis
rotate                  rotation of the source about the vertical, from +x towards +y, before it
                        is aimed
distribution            isotropic, cone, lobe, lambertian, a file (.ies, .ldt, .csv) with a
                        path relative to FILE.csv, or an expression in theta and phi
half_angle, apex_angle, solid_angle (cone); exponent, beam_angle, field_angle (lobe)
flux, intensity         flux or intensity of the source (scales the values of a file)
lambertian: width and length, or area; and one of luminance, exitance, flux, intensity

A lambertian source with width and length is calculated exactly, at any distance; every other
source is treated as a point.
Light from behind a receiver does not count.  For a grid, the answer gives the mean, the extremes
and the uniformity; --format csv, or -g x,y,irradiance:lx, prints the points.
"""


@define("scene", page.PAGE, text=HELP)
def command(
    words: tuple[str, ...],
    typed: dict[str, str],
    at: tuple[str, ...],
    request: Request,
    output: Output,
) -> int:
    """Answer for the points of a scene."""
    path = only_file(words, "scene", f"{call_of('scene', 'FILE.csv')} --at X,Y,Z")
    all_cases = cases(typed, arrays=False)
    if len(all_cases) > 1:
        problem = "a list of conditions cannot be used with a scene"
        raise UsageError(problem, "only one of them, and a loop")
    given = all_cases[0].given
    refuse_uncertain(given.values(), "a scene")
    places = texts_of({"file": path, "at": " ".join(at)})
    all_inputs = (*places, *shown_inputs(given))
    points = _points(at, given.pop("grid", None))
    normal = given.pop("normal").value if "normal" in given else None
    names = [*map(name_of, request.wanted)]
    of_all = _of_all(names)
    if points.size > 1:
        _refuse_one_of_many(request, points.size)

    def survey(given: Inputs) -> page.Survey:
        scene = page.scene(path, given, points.assumptions)
        few = bool(at) and 1 < len(scene.sources) <= FEW
        return page.Survey(scene, normal, few or any(map(page.is_share, names)))

    def work_out(given: Inputs) -> Answer:
        if points.size == 1 and not of_all:
            return survey(given).at_point(next(points.blocks()))
        return survey(given).over_all(points.blocks(), points.is_grid)

    is_for_each = points.size > 1 and not of_all and request.check is None and not request.plot
    if is_for_each and (output.format == CSV or names):
        by_points = _stream if output.has_columns else _list
        return by_points(survey(given), all_inputs, points, request, output)
    if is_for_each and not points.is_grid:
        return _show(survey(given), all_inputs, points, output)
    links = tuple(entry for entry in all_inputs if entry.name not in given)
    if request.plot:
        return _draw(survey, given, points, request, output, links)
    return run([Case(given)], Task("scene", work_out, links), request, output)


def _of_all(names: Sequence[str]) -> list[str]:
    of_all = [name for name in names if page.is_of_all(name)]
    if of_all and len(of_all) < len(names):
        other = next(name for name in names if name not in of_all)
        problem = f"{quote(of_all[0])} cannot be used with {quote(other)} of each point"
        raise UsageError(problem, "one call for each")
    return of_all


def _refuse_one_of_many(request: Request, count: int) -> None:
    if request.check is not None:
        claimed = name_of(request.check.partition("=")[0])
        if (claimed in SYMBOLS or page.is_share(claimed)) and not page.is_of_all(claimed):
            problem = f"--check {quote(claimed)} takes one point, but there are {count}"
            raise UsageError(problem, "--at X,Y,Z once, or --check mean-irradiance=VALUE")
    if request.steps:
        raise UsageError("--steps takes one point", "--at X,Y,Z once")


def _draw(
    survey: Callable[[Inputs], Any],
    given: Inputs,
    points: "Points",
    request: Request,
    output: Output,
    operands: tuple[ShownInput, ...],
) -> int:
    """Draw the values at the points of a grid, with the answer over all of them.

    A requested result of each point is the one drawn.
    """
    from radcalc.plots.space import Surveyed

    blocks: list[Answer] = []
    sources: list[Any] = []

    def work_out(given: Inputs) -> Answer:
        surveyed: page.Survey = survey(given)
        blocks.extend(surveyed.at_points(points.blocks()))
        sources.extend((source.name, source.source.place) for source in surveyed.scene.sources)
        return surveyed.remarks(points.is_grid, with_values=True)

    of_each = [name for name in request.wanted if not page.is_of_all(name_of(name))]
    drawn = Surveyed(points.axes, blocks, sources, *of_each[:1])
    request = request._replace(wanted=() if of_each else request.wanted)
    return run([Case(given)], Task("scene", work_out, operands, drawn=drawn), request, output)


def _stream(
    survey: Any, inputs: tuple[ShownInput, ...], points: "Points", request: Request, output: Output
) -> int:
    """Write a line for each point, in blocks of points."""
    output.refuse_auto("a column of points has one", leave_out("auto"))

    is_first = True
    for answer in survey.at_points(points.blocks()):
        wanted = request.wanted or [
            f"{name_in(v, v.dimensions[0])}:{unit}" for v in answer.values for unit in v.units
        ]
        rows = [pick(answer.values, name) for name in wanted]
        if is_first:  # the answer is not a single number
            output.hear([Result(tuple(rows))])
        if output.format == CSV:
            at = () if _has_places(request) else _coordinates(answer)
            units = {coordinate.name: coordinate.unit for coordinate in at}
            text = csv.block(Result(tuple(rows), inputs=at), units, output.style, is_first)
        else:
            text = csv.lines([row.value for row in rows], output.style.precision)
        terminal.pour(text.encode())
        is_first = False
    output.remark([result(Answered("", inputs, survey.remarks(points.is_grid)))])
    return terminal.ANSWERED


def _list(
    survey: Any, inputs: tuple[ShownInput, ...], points: "Points", request: Request, output: Output
) -> int:
    if points.size > MOST:
        raise UsageError(f"a table of {points.size} points is too long", "--format csv")
    answers, _ = _at_each(survey, inputs, points)
    if output.format == CSV and _has_places(request):
        answers = [answered._replace(inputs=inputs) for answered in answers]
    show(answers, request, output)
    return terminal.ANSWERED


def _show(survey: Any, inputs: tuple[ShownInput, ...], points: "Points", output: Output) -> int:
    refuse_bare(output)
    answers, over_all = _at_each(survey, inputs, points)
    results = [result(answered) for answered in answers]
    if output.format == JSON:
        output.show([*results, result(over_all)])
    else:
        output.show([at_point._replace(assumptions=(), notes=()) for at_point in results])
        output.show([result(over_all)])
    return terminal.ANSWERED


def _at_each(
    survey: Any, inputs: tuple[ShownInput, ...], points: "Points"
) -> tuple[list[Answered], Answered]:
    """Return the answer at each point, and the answer over all points."""
    blocks = list(survey.at_points(points.blocks()))
    over_all = survey.remarks(points.is_grid, with_values=True)
    conditions = tuple(entry for entry in inputs if entry.name not in ("at", "grid"))
    answers: list[Answered] = []
    for block in blocks:
        for k in range(len(block.values[0].si)):
            answer = over_all._replace(values=[element(value, k) for value in block.values])
            at = _coordinates(answer)
            name = (
                points.names[len(answers)] if points.names else ",".join(f"{p.value:g}" for p in at)
            )
            answers.append(Answered(name, (*conditions, *at), answer))
    return answers, Answered("", inputs, over_all)


def _coordinates(answer: Answer) -> tuple[ShownInput, ...]:
    return tuple(ShownInput(value.name, value.si, value.units[0]) for value in answer.values[:3])


def _has_places(request: Request) -> bool:
    """Return whether coordinates, which then come first, are among the requested results."""
    return any(name_of(name) in COORDINATES for name in request.wanted)


class Points(NamedTuple):
    """The points of a call: names if typed, or axes of a grid; and blocks of them."""

    blocks: Callable[[], Iterator[Any]]
    size: int
    names: tuple[str, ...] = ()
    assumptions: tuple[str, ...] = ()
    axes: tuple[Any, ...] = ()

    @property
    def is_grid(self) -> bool:
        return not self.names


def _points(at: tuple[str, ...], grid: Input | None) -> Points:
    """Return the points of --at or --grid; refuse both, none, and a range of --at."""
    from radcalc.distributions import scene

    if at and grid:
        raise UsageError("--at cannot be used with --grid", one_of("at", "grid"))
    if grid:
        axes = [scene.Axis(*axis) for axis in grid.value]
        size = math.prod(axis.size for axis in axes)
        assumptions = () if grid.unit else (IN_METRES,)
        return Points(lambda: scene.grid(*axes), size, (), assumptions, tuple(axes))
    if not at:
        raise UsageError("the points are missing", f"--at X,Y,Z or --grid {AS_GRID}")
    if several := next((text for text in at if ":" in text), None):
        raise ConditionError(f"--at {quote(several)} is a range", f"--grid {AS_GRID}")
    places = [read_place("point", text, "--at") for text in at]
    bare = any(place.unit is None for place in places)
    values = [place.value for place in places]
    return Points(lambda: scene.blocks(values), len(at), at, (IN_METRES,) if bare else ())


EXAMPLES = (
    call("environment", "sky:overcast"),
    call("environment", "map.hdr", unit="cd/m2", remark="for a picture"),
)


@define("environment", environment_page.PAGE)
def environment_command(
    words: tuple[str, ...],
    typed: dict[str, str],
    irradiance_map: str | None,
    order: str | None,
    request: Request,
    output: Output,
) -> int:
    """Answer for a receiver, or write an irradiance map."""
    if not words:
        raise UsageError("a map, a sky or an expression is missing", EXAMPLES)
    operands = {"source": " ".join(words)}
    source = Source(operands["source"])
    if irradiance_map is None:
        for name, value in (("--order", order), ("--size", typed.get("size"))):
            if value:
                problem = f"{name} does not apply without --irradiance-map"
                raise UsageError(problem, "--irradiance-map FILE with it")
        all_cases = cases(typed, arrays=False)

        def work_out(given: Inputs) -> Answer:
            return environment(source, given)

        task = Task("environment", work_out, texts_of(operands), drawn=source)
        return run(all_cases, task, request, output)
    for name in ("normal", "toward"):
        if name in typed:
            problem = f"--{name} does not apply when a map is written"
            raise UsageError(problem, leave_out(name))
    _refuse_source(irradiance_map, operands["source"])
    given = one_case(typed, request)
    make = partial(environment_page.irradiance_map, source, given, 2 if order else None)
    inputs = texts_of({**operands, "irradiance-map": irradiance_map, "order": order or ""})
    return write_map(
        irradiance_map, "irradiance map", make, request, output, (*inputs, *shown_inputs(given))
    )


def _refuse_source(path: str, source: str) -> None:
    """Refuse to overwrite the map to read, under any name or link."""
    if os.path.exists(source) and os.path.exists(path) and os.path.samefile(source, path):
        raise UsageError(f"{quote_path(path)} is also the map to read", "another name")
