"""`radcalc calorimeter`."""

from radcalc.calculators.calorimeter import QUANTITIES, calorimeter
from radcalc.cli.calculator import Asked, cases, run
from radcalc.cli.command import define
from radcalc.cli.options import Output
from radcalc.quantities.light import RADIANT


@define(
    "calorimeter",
    {
        "Light": QUANTITIES,
        "Body": (
            "mass",
            "specific-heat",
            "temperature-rise",
            "absorptance",
            "receiver-area",
            "time",
        ),
    },
    kinds=(RADIANT,),
)
def command(typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give the radiant flux that heats a body, or how warm a flux makes it.

    \b
    Examples:
      radcalc calorimeter --mass 10g --specific-heat 385J/kg/K --temperature-rise 2K --time 30s
      radcalc calorimeter --irradiance 1000W/m2 --receiver-area 20cm2 --absorptance 0.95 \\
        --time 1min --mass 10g --specific-heat 385J/kg/K -g temperature-rise:K
    """
    return run(cases(typed, arrays=True), calorimeter, asked, shown, "calorimeter")
