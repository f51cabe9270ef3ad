"""`radcalc environment SOURCE`."""

import os
from functools import partial

import click

from radcalc.answer import Answer, texts_of
from radcalc.calculators import environment as page
from radcalc.calculators.environment import Source, environment
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import cases
from radcalc.cli.command import ENVIRONMENT, LIGHT, define
from radcalc.cli.maps import one_case, write_map
from radcalc.cli.options import Output
from radcalc.errors import UsageError, quote_path
from radcalc.geometry.sky import NAMES
from radcalc.given import Inputs, inputs_of
from radcalc.quantities.symbols import PROJECTIONS

EXAMPLES = "radcalc environment map.hdr --unit cd/m2, or radcalc environment sky:overcast"
IRRADIANCE_MAP = click.Option(
    ["--irradiance-map"],
    metavar="FILE",
    help="Write the irradiance of receivers that face in all directions, as a latlong map (.hdr, "
    ".exr, .pfm).",
)
ORDER = click.Option(
    ["--order"],
    type=click.Choice(["2"]),
    help="Use spherical harmonics up to this order instead of the exact sum over all pixels.",
)
REPROJECT = click.Option(
    ["--reproject"], metavar="FILE", help="Write the map in another projection (with --to)."
)
TO = click.Option(
    ["--to"], type=click.Choice(PROJECTIONS), help="The projection that --reproject writes."
)


@define(
    "environment",
    {
        "Map": ("unit", "projection", "aim", "channel"),
        "Sky": ("sun-elevation", "sun-azimuth", "zenith-radiance", "horizontal-irradiance"),
        "Receiver": ("normal", "toward"),
        "Maps that are written": (IRRADIANCE_MAP, ORDER, REPROJECT, TO, "size"),
        "Kinds of light": LIGHT,
    },
    words="SOURCE",
    operands=(ENVIRONMENT, NAMES),
    takes_lines=False,
    draws=True,
)
def command(
    words: tuple[str, ...],
    typed: dict[str, str],
    irradiance_map: str | None,
    order: str | None,
    reproject: str | None,
    to: str | None,
    asked: Asked,
    shown: Output,
) -> int:
    """Give what a receiver gets of all that surrounds it: of a map, a sky or an expression.

    \b
    Examples:
      radcalc environment room.hdr --unit W/m2/sr
      radcalc environment room.exr --unit cd/m2 --normal 1,0,0 --toward 60deg,90deg
      radcalc environment ball.hdr --projection mirror-ball --aim 0,-1,0 --unit 1
      radcalc environment sky:overcast --zenith-luminance 9000cd/m2 --normal 1,0,0
      radcalc environment sky:12 --sun-elevation 40deg --sun-azimuth 0deg \\
        --toward 0deg:90deg:15deg,90deg
      radcalc environment room.hdr --unit cd/m2 --plot room.png
      radcalc environment '3000*max(cos(theta), 0) cd/m2' --steps
      radcalc environment room.hdr --unit cd/m2 --irradiance-map lux.exr --size 64x32
      radcalc environment ball.hdr --projection mirror-ball --unit 1 \\
        --reproject room.exr --to latlong

    SOURCE is a map of radiances (Radiance .hdr, OpenEXR .exr, .pfm), sky:TYPE with a type of
    radcalc sky, or an expression in theta (polar angle from +z, which is up) and phi (azimuth from
    +x towards +y), with a unit behind a blank, or relative.  Directions are those that light comes
    from.

    The middle of a map shows the direction --aim, and its up is as near to +z as can be.  A map
    that is 2:1 is latlong; a square one has to be told.  Few files say in which --unit they are;
    with --unit 1 every result is relative.  R, G and B are weighted to a luminance, by the file's
    primaries or those of Rec. 709; in W/m2/sr they are Radiance's, and a watt counts as 179 lm.
    """
    if not words:
        raise UsageError("a map, a sky or an expression is missing", EXAMPLES)
    operands = {"source": " ".join(words)}
    source = Source(operands["source"])
    path = irradiance_map or reproject
    if path is None:
        for name, one, file in (
            ("--order", order, "--irradiance-map"),
            ("--to", to, "--reproject"),
            ("--size", typed.get("size"), "--irradiance-map"),
        ):
            if one:
                raise UsageError(f"{name} has no use without {file}", f"{file} FILE with it")
        each = cases(typed)

        def work_out(given: Inputs) -> Answer:
            return environment(source, given)

        told = texts_of(operands)
        return run(each, work_out, asked, shown, "environment", operands=told, drawn=source)
    for name in ("normal", "toward"):
        if name in typed:
            problem = f"--{name} has no use where a map is written"
            raise UsageError(problem, f"the same without --{name}")
    _refuse_source(path, operands["source"])
    given = one_case(typed, asked)
    if irradiance_map:
        if reproject:
            both = "--irradiance-map and --reproject"
            raise UsageError(f"{both} contradict each other: each makes a file", "one of them")
        if to:
            raise UsageError("--to has no use with --irradiance-map", "the same without --to")
        make = partial(page.irradiance_map, source, given, 2 if order else None)
        inputs = texts_of({**operands, "irradiance-map": path, "order": order or ""})
        return write_map(path, "irradiance map", make, asked, shown, (*inputs, *inputs_of(given)))
    if order:
        raise UsageError("--order has no use with --reproject", "the same without --order")
    if not to:
        ways = " or ".join(f"--to {name}" for name in PROJECTIONS)
        raise UsageError("the projection to write is missing", ways)
    make = partial(page.reprojection, source, given, to)
    inputs = (*texts_of({**operands, "reproject": path, "to": to}), *inputs_of(given))
    return write_map(path, "reprojection", make, asked, shown, inputs)


def _refuse_source(path: str, source: str) -> None:
    """Refuse to write over the map that is read, by whatever name or link."""
    if os.path.exists(source) and os.path.exists(path) and os.path.samefile(source, path):
        raise UsageError(f"{quote_path(path)} is the map that is read", "another name")
