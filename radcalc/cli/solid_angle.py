"""`radcalc solid-angle SHAPE`."""

from typing import Any

import click

from radcalc.calculators.inputs import read_interval, read_point
from radcalc.calculators.solid_angle import ALIASES, SHAPES, solid_angle
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.errors import UsageError, quote

SECTIONS = {
    "Cone": ("half_angle", "apex_angle", "projected_solid_angle", "solid_angle"),
    "Zone": ("polar", "azimuth"),
    "Sphere, disc, rectangle, patch": (
        "radius",
        "diameter",
        "width",
        "length",
        "area",
        "distance",
        "height",
        "offset",
        "offset_y",
        "corner",
        "tilt",
    ),
    "Pyramid": ("horizontal", "vertical"),
    "Polygon": ("viewpoint", "normal"),
    "Results": calculator.RESULTS,
}


@click.command(
    "solid-angle",
    cls=SectionedCommand,
    sections=SECTIONS,
    context_settings={"max_content_width": 100},
)
@click.argument("words", nargs=-1, metavar="SHAPE [X,Y,Z ...]")
@calculator.inputs(
    "half-angle",
    "apex-angle",
    "solid-angle",
    "projected-solid-angle",
    "radius",
    "diameter",
    "width",
    "length",
    "area",
    "distance",
    "height",
    "offset",
    "offset-y",
    "tilt",
    "horizontal",
    "vertical",
    solid_angle="Solid angle of the cone, or of the sphere.",
)
@click.option("--polar", metavar="30deg:60deg", help="Polar angles of a zone, from +z.")
@click.option("--azimuth", metavar="0deg:90deg", help="Azimuths of a zone (default: all).")
@click.option("--corner", is_flag=True, help="Seen from above a corner of the rectangle.")
@click.option("--viewpoint", metavar="X,Y,Z", help="Where the polygon is seen from (0,0,0).")
@click.option("--normal", metavar="X,Y,Z", help="Normal of the plane projected onto.")
@calculator.results
@output.options
def command(
    words: tuple[str, ...],
    polar: str | None,
    azimuth: str | None,
    corner: bool,
    viewpoint: str | None,
    normal: str | None,
    asked: calculator.Asked,
    shown: output.Output,
    **typed: str | None,
) -> int:
    """Give the solid angle of a shape, and its projected solid angle.

    \b
    Examples:
      radcalc solid-angle cone --half-angle 30deg
      radcalc solid-angle cone --solid-angle 1sr                    (its half angle)
      radcalc solid-angle zone --polar 30deg:60deg --azimuth 0deg:90deg
      radcalc solid-angle sphere --radius 695700km --distance 1au
      radcalc solid-angle disc --diameter 10cm --height 50cm --offset 0cm:40cm:10cm
      radcalc solid-angle rectangle --width 2m --length 1m --height 1m --corner
      radcalc solid-angle pyramid --horizontal 60deg --vertical 40deg
      radcalc solid-angle patch --area 1cm2 --distance 2m --tilt 60deg
      radcalc solid-angle polygon 1,0,0 0,1,0 0,0,1 -g solid-angle:deg2

    \b
    SHAPE is one of:
      full, hemisphere   all directions, one half of them
      cone               --half-angle, --apex-angle, --solid-angle or --projected-solid-angle
      zone (band)        --polar A:B, --azimuth A:B
      sphere             two of --radius (or --diameter), --distance, --solid-angle
      disc               --radius or --diameter, --height (--distance), --offset
      rectangle          --width, --length, --height (--distance), --offset, --offset-y, --corner
      pyramid            --horizontal and --vertical, full angles
      patch              --area (or --radius, --diameter), --distance, --tilt: small and flat
      polygon (triangle) X,Y,Z of each vertex in order, --viewpoint, --normal

    One of the quantities may be a list (1m,2m) or a range (1m:5m:1m), for an answer each.
    """
    shape, points = _shape(words)
    each = calculator.cases(typed)  # before the words, so that `--radius 2 m` is told to write 2m
    others: dict[str, Any] = {
        "polar": polar and read_interval("polar", polar),
        "azimuth": azimuth and read_interval("azimuth", azimuth),
        "corner": corner or None,
        "viewpoint": viewpoint and read_point(viewpoint, "--viewpoint"),
        "normal": normal and read_point(normal, "--normal"),
    }
    others = {name: value for name, value in others.items() if value is not None}
    if shape == "polygon":
        others["points"] = [read_point(word, "the vertex") for word in points]
    elif points:
        raise UsageError(f"too many words: '{quote(' '.join(points))}'", "options, as in --help")
    facts = {"command": "solid-angle", "shape": shape, "polar": others.get("polar")}
    return calculator.run(each, lambda g: solid_angle(shape, g, others), asked, shown, **facts)


def _shape(words: tuple[str, ...]) -> tuple[str, tuple[str, ...]]:
    """The shape by its own name, and the words after it."""
    names = [*SHAPES, *ALIASES]
    if not words:
        raise UsageError("a shape is missing", ", ".join(names))
    name = calculator.shape(words[0], names)
    return ALIASES.get(name, name), words[1:]
