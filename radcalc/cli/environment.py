"""`radcalc environment SOURCE`."""

from radcalc.calculators.environment import Source, environment
from radcalc.cli.calculator import Asked, cases, run
from radcalc.cli.command import LIGHT, define
from radcalc.cli.options import Output
from radcalc.errors import UsageError

EXAMPLES = "radcalc environment sky:overcast"


@define(
    "environment",
    {
        "Sky": ("sun-elevation", "sun-azimuth", "zenith-radiance", "horizontal-irradiance"),
        "Receiver": ("normal", "toward"),
        "Kinds of light": LIGHT,
    },
    words="SOURCE",
)
def command(words: tuple[str, ...], typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give what a receiver gets of all that surrounds it: of a sky or an expression.

    \b
    Examples:
      radcalc environment sky:overcast --zenith-luminance 9000cd/m2 --normal 1,0,0
      radcalc environment sky:12 --sun-elevation 40deg --sun-azimuth 0deg --toward 0deg:90deg:15deg
      radcalc environment '3000*max(cos(theta), 0) cd/m2' --steps

    SOURCE is sky:TYPE, with a type of radcalc sky, or an expression in theta (polar angle from +z,
    which is up) and phi (azimuth from +x towards +y), with a unit behind a blank, or relative.
    Directions are those that light comes from.
    """
    if not words:
        raise UsageError("a sky or an expression is missing", EXAMPLES)
    source = Source(" ".join(words))
    each = cases(typed)
    return run(each, lambda given: environment(source, given), asked, shown, "environment")
