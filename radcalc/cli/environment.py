"""`radcalc environment SOURCE`."""

from radcalc.calculators.environment import Source, environment
from radcalc.cli.calculator import Asked, cases, run
from radcalc.cli.command import LIGHT, define
from radcalc.cli.options import Output
from radcalc.errors import UsageError

EXAMPLES = "radcalc environment map.hdr --unit cd/m2, or radcalc environment sky:overcast"


@define(
    "environment",
    {
        "Map": ("unit", "projection", "aim", "channel"),
        "Sky": ("sun-elevation", "sun-azimuth", "zenith-radiance", "horizontal-irradiance"),
        "Receiver": ("normal", "toward"),
        "Kinds of light": LIGHT,
    },
    words="SOURCE",
)
def command(words: tuple[str, ...], typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give what a receiver gets of all that surrounds it: of a map, a sky or an expression.

    \b
    Examples:
      radcalc environment room.hdr --unit W/m2/sr
      radcalc environment room.exr --unit cd/m2 --normal 1,0,0 --toward 60deg,90deg
      radcalc environment ball.hdr --projection mirror-ball --aim 0,-1,0 --unit 1
      radcalc environment sky:overcast --zenith-luminance 9000cd/m2 --normal 1,0,0
      radcalc environment sky:12 --sun-elevation 40deg --sun-azimuth 0deg \\
        --toward 0deg:90deg:15deg
      radcalc environment '3000*max(cos(theta), 0) cd/m2' --steps

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
    source = Source(" ".join(words))
    each = cases(typed)
    return run(each, lambda given: environment(source, given), asked, shown, "environment")
