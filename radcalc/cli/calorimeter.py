"""`radcalc calorimeter`."""

import click

from radcalc.calculators.calorimeter import INPUTS, QUANTITIES, calorimeter
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.quantities.light import RADIANT


@click.command(
    "calorimeter",
    cls=SectionedCommand,
    sections={
        "Light": tuple(QUANTITIES),
        "Body": (
            "mass",
            "specific_heat",
            "temperature_rise",
            "absorptance",
            "receiver_area",
            "time",
        ),
        "Results": calculator.RESULTS,
    },
    context_settings={"max_content_width": 100},
)
@calculator.quantities(*QUANTITIES, kinds=(RADIANT,))
@calculator.inputs(*INPUTS, time="How long it is in the light.")
@calculator.results
@output.options
def command(asked: calculator.Asked, shown: output.Output, **typed: str | None) -> int:
    """Give the radiant flux that heats a body, or how warm a flux makes it.

    \b
    Examples:
      radcalc calorimeter --mass 10g --specific-heat 385J/kg/K --temperature-rise 2K --time 30s
      radcalc calorimeter --irradiance 1000W/m2 --receiver-area 20cm2 --absorptance 0.95 \\
        --time 1min --mass 10g --specific-heat 385J/kg/K -g temperature-rise:K
    """
    each = calculator.cases(typed, arrays=True)
    return calculator.run(each, calorimeter, asked, shown, command="calorimeter")
