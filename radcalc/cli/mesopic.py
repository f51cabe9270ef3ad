"""`radcalc mesopic --luminance L --sp-ratio S/P`."""

from radcalc.calculators.mesopic import mesopic
from radcalc.cli.calculator import Asked, cases, run
from radcalc.cli.command import define
from radcalc.cli.options import Output


@define(
    "mesopic",
    {
        "Light": ("luminance", "sp-ratio", "spectrum"),
        "Solved for the others": ("mesopic-luminance", "scotopic-luminance"),
    },
)
def command(typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give the mesopic luminance of CIE 191:2010, between night and day.

    \b
    Examples:
      radcalc mesopic --luminance 0.1cd/m2 --sp-ratio 2
      radcalc mesopic --luminance 0.5cd/m2 --spectrum LED-B3
    """
    return run(cases(typed), mesopic, asked, shown, "mesopic")
