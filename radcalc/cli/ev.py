"""`radcalc ev`."""

import click

from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.laws.ev import INPUTS, ev


@click.command(
    "ev",
    cls=SectionedCommand,
    sections={
        "Light": ("ev100", "luminance", "illuminance"),
        "Camera": ("ev", "f_number", "time", "iso"),
        "Meter": ("k", "c"),
        "Results": ("wanted",),
    },
    context_settings={"max_content_width": 100},
)
@calculator.inputs(*INPUTS, time="Exposure time, such as 1/100s.")
@calculator.get_option
@calculator.steps_option
@output.options
def command(
    wanted: tuple[str, ...], steps: bool, shown: output.Output, **typed: str | None
) -> None:
    """Give exposure values, and the light that a light meter shows them for.

    \b
    Examples:
      radcalc ev --ev100 15
      radcalc ev --luminance 1000cd/m2
      radcalc ev --f-number 16 --time 1/100s --iso 100
      radcalc ev --illuminance 500lx --f-number 4 --iso 400 -g time:ms

    --ev is that of the f-number and the time, at the ISO speed given; --ev100 is that of the light.
    """
    answers = [(case, ev(given)) for case, given in calculator.cases(typed, arrays=True)]
    calculator.show(answers, wanted, shown, steps)
