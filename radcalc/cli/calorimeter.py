"""`radcalc calorimeter`."""

import click

from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.laws.calorimeter import INPUTS, QUANTITIES, calorimeter


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
        "Results": ("wanted",),
    },
    context_settings={"max_content_width": 100},
)
@calculator.quantities(*QUANTITIES)
@calculator.inputs(*INPUTS, time="How long it is in the light.")
@calculator.get_option
@calculator.steps_option
@output.options
def command(
    wanted: tuple[str, ...], steps: bool, shown: output.Output, **typed: str | None
) -> None:
    """Give the radiant flux that heats a body, or how warm a flux makes it.

    \b
    Examples:
      radcalc calorimeter --mass 10g --specific-heat 385J/kg/K --temperature-rise 2K --time 30s
      radcalc calorimeter --irradiance 1000W/m2 --receiver-area 20cm2 --absorptance 0.95 \\
        --time 1min --mass 10g --specific-heat 385J/kg/K -g temperature-rise:K
    """
    answers = [(case, calorimeter(given)) for case, given in calculator.cases(typed, arrays=True)]
    calculator.show(answers, wanted, shown, steps)
