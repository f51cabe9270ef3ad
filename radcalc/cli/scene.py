"""`radcalc scene FILE.csv`."""

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import click

from radcalc import stdio
from radcalc.answer import Answer
from radcalc.calculators.results import element, pick
from radcalc.cli.calculator import (
    Asked,
    cases,
    formatted,
    lines,
    refuse_bare,
    refuse_format,
    result,
    run,
)
from radcalc.cli.command import FILE, LIGHT, define
from radcalc.cli.options import Output
from radcalc.errors import ConditionError, UsageError, quote
from radcalc.errors import command as call_of
from radcalc.given import AS_GRID, IN_METRES, Given, Inputs, read_place
from radcalc.render.formats import CSV

FEW = 12  # sources whose shares are shown unasked
AT = click.Option(
    ["--at"],
    multiple=True,
    metavar="X,Y,Z",
    help="A point that gets the light (repeatable), in metres or with units.",
)


@define(
    "scene",
    {"The points": (AT, "grid", "normal"), "Kinds of light": LIGHT},
    words="FILE.csv",
    operands=(FILE, (".csv", ".tsv", ".txt")),
)
def command(
    words: tuple[str, ...],
    typed: dict[str, str],
    at: tuple[str, ...],
    asked: Asked,
    shown: Output,
) -> int:
    """Add up the light of many sources at points, or over a grid of them.

    \b
    Examples:
      radcalc scene room.csv --at 1,2,0.75
      radcalc scene room.csv --at 1,2,0.75 --at 3,2,0.75 --normal 0,-1,0
      radcalc scene room.csv --grid 0:6:61,0:4:41,0.75
      radcalc scene room.csv --grid 0:6:61,0:4:41,0.75 -g uniformity
      radcalc scene room.csv --grid 0:6:61,0:4:41,0.75 --format csv > room-lux.csv
      radcalc scene room.csv --at 1,2,0.75 -g share-desk:%
      radcalc scene grow.csv --at 0,0,0 --spectrum LED-B3 -g irradiance:umol/m2/s

    \b
    FILE.csv has a title for each column and a source in each row:
      name,x (m),y (m),z (m),aim_x,aim_y,aim_z,distribution,flux,exponent
      desk,1,2,1.2,1,2,0.75,lobe,400lm,2
      door,5,0.5,2.5,,,,downlight.ies,,

    \b
    x, y, z                 where it is; metres, unless the title or the cell has a unit
    aim_x, aim_y, aim_z     the point it is aimed at (straight down), or
    direction_x ... _z      the direction
    rotate                  angle by which it is turned about its axis, from +x towards +y
    distribution            isotropic, cone, lobe, lambertian, a file (.ies, .ldt, .csv) beside
                            this one, or an expression in theta and phi
    half_angle, apex_angle, solid_angle (cone); exponent, beam_angle, field_angle (lobe)
    flux, intensity         how strong it is (of a file: what it is scaled to)
    width, length or area; luminance, exitance, flux or intensity (lambertian)

    Rectangles are exact; every other source is small beside its distance.  Light from behind a
    receiver does not count.  A grid has the mean, the extremes and the uniformity; its points come
    with --format csv, or with -g x -g y -g irradiance:lx.
    """
    from radcalc.calculators import scene as page

    if len(words) != 1:
        problem = "there is a word too many" if words else "the file of the scene is missing"
        raise UsageError(problem, f"{call_of('scene', 'FILE.csv')} --at X,Y,Z")
    each = cases(typed)
    if len(each) > 1:
        raise UsageError("a list of conditions is not for a scene", "one of them, and a loop")
    given = each[0][1]
    points = _points(at, given.pop("grid", None))
    normal = given.pop("normal").value if "normal" in given else None
    names = [name.partition(":")[0].strip() for name in asked.wanted]
    of_all = [name for name in names if page.is_of_all(name)]
    if of_all and len(of_all) < len(names):
        other = next(name for name in names if name not in of_all)
        problem = f"{quote(of_all[0])} is of all the points, {quote(other)} of each"
        raise UsageError(problem, "one call for each")
    if asked.steps and points.size > 1:
        raise UsageError("--steps is of one point", "--at X,Y,Z once")

    def survey(given: Inputs) -> page.Survey:
        scene = page.scene(words[0], given, points.assumptions)
        few = bool(at) and 1 < len(scene.sources) <= FEW
        return page.Survey(scene, normal, few or any(map(page.is_share, names)))

    def work_out(given: Inputs) -> Answer:
        """The answer of which there is one: at one point, or over all of them."""
        if points.size == 1 and not of_all:
            return survey(given).at_point(next(points.blocks()))
        return survey(given).over_all(points.blocks(), points.is_grid)

    by_points = shown.format == CSV or (bool(names) and not of_all)
    if asked.check is None and by_points and not (names and points.size == 1):
        return _stream(survey(given), points, asked, shown)
    if asked.check is None and not names and not points.is_grid and points.size > 1:
        return _show(survey(given), points, shown)
    return run([("", given)], work_out, asked, shown, "scene")


def _stream(survey: Any, points: "Points", asked: Asked, shown: Output) -> int:
    """Write a line for each point, a block of them at a time."""
    if asked.wanted:
        refuse_format(shown)
    form = f"%.{shown.style.precision}g" if shown.style.precision else "%r"
    is_first = True
    for answer in survey.at_points(points.blocks()):
        if asked.wanted:
            columns = [pick(answer.values, name) for name in asked.wanted]
            text = lines(columns, shown.style.precision)
        else:
            names = [f"{value.name}:{unit}" for value in answer.values for unit in value.units]
            text = formatted([pick(answer.values, name) for name in names], form, ",")
            text = f"{','.join(names)}\n{text}" if is_first else text
        stdio.pour(text.encode())
        is_first = False
    shown.remark([result("", survey.remarks(points.is_grid))])
    return stdio.ANSWERED


def _show(survey: Any, points: "Points", shown: Output) -> int:
    """Write what each of a few points gets, and then what all of them do."""
    refuse_bare(shown)
    (answer,) = survey.at_points(points.blocks())
    each = [
        (point, answer._replace(values=[element(value, k) for value in answer.values]))
        for k, point in enumerate(points.names)
    ]
    shown.show([result(point, one._replace(assumptions=(), notes=())) for point, one in each])
    shown.show([result("", survey.remarks(points.is_grid, with_values=True))])
    return stdio.ANSWERED


class Points(NamedTuple):
    """The points of a call: their names where they are typed, and blocks of them."""

    blocks: Callable[[], Iterator[Any]]
    size: int
    names: tuple[str, ...] = ()
    assumptions: tuple[str, ...] = ()

    @property
    def is_grid(self) -> bool:
        """Whether they are of a grid."""
        return not self.names


def _points(at: tuple[str, ...], grid: Given | None) -> Points:
    """The points that are typed one by one, or those of a grid."""
    from radcalc.distributions import scene

    if at and grid:
        raise UsageError("--at and --grid contradict each other", "one of them")
    if grid:
        axes = [scene.Axis(*axis) for axis in grid.value]
        size = math.prod(axis.size for axis in axes)
        return Points(lambda: scene.grid(*axes), size, (), () if grid.unit else (IN_METRES,))
    if not at:
        raise UsageError("there is no point", f"--at X,Y,Z or --grid {AS_GRID}")
    if several := next((text for text in at if ":" in text), None):
        raise ConditionError(f"--at {quote(several)} is a range", f"--grid {AS_GRID}")
    places = [read_place("point", text, "--at") for text in at]
    bare = any(place.unit is None for place in places)
    every = [place.value for place in places]
    return Points(lambda: scene.blocks(every), len(at), at, (IN_METRES,) if bare else ())
