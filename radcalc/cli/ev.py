"""`radcalc ev`."""

import click

from radcalc.calculators.ev import INPUTS, ev
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand


@click.command(
    "ev",
    cls=SectionedCommand,
    sections={
        "Light": ("ev100", "luminance", "illuminance"),
        "Camera": ("ev", "f_number", "time", "iso"),
        "Meter": ("k", "c"),
        "Results": calculator.RESULTS,
    },
    context_settings={"max_content_width": 100},
)
@calculator.inputs(*INPUTS, time=("1/100s", "Exposure time."))
@calculator.results
@output.options
def command(asked: calculator.Asked, shown: output.Output, **typed: str | None) -> int:
    """Give exposure values, and the light that a light meter shows them for.

    \b
    Examples:
      radcalc ev --ev100 15
      radcalc ev --luminance 1000cd/m2
      radcalc ev --f-number 16 --time 1/100s --iso 100
      radcalc ev --illuminance 500lx --f-number 4 --iso 400 -g time:ms

    --ev is that of the f-number and the time, at the ISO speed given; --ev100 is that of the light.
    """
    return calculator.run(calculator.cases(typed, arrays=True), ev, asked, shown, command="ev")
