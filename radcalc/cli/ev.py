"""`radcalc ev`."""

from radcalc.calculators.ev import ev
from radcalc.cli.calculator import Asked, cases, run
from radcalc.cli.command import define
from radcalc.cli.options import Output


@define(
    "ev",
    {
        "Light": ("ev100", "luminance", "illuminance"),
        "Camera": ("ev", "f-number", "time", "iso"),
        "Meter": ("k", "c"),
    },
)
def command(typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give exposure values, and the light that a light meter shows them for.

    \b
    Examples:
      radcalc ev --ev100 15
      radcalc ev --luminance 1000cd/m2
      radcalc ev --f-number 16 --time 1/100s --iso 100
      radcalc ev --illuminance 500lx --f-number 4 --iso 400 -g time:ms

    --ev is that of the f-number and the time, at the ISO speed given; --ev100 is that of the light.
    """
    return run(cases(typed, arrays=True), ev, asked, shown, "ev")
