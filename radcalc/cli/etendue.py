"""`radcalc etendue`."""

import click

from radcalc.calculators.etendue import etendue
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand

SECTIONS = {
    "Source": ("area", "radius", "diameter", "width", "length", "tilt", "radiance"),
    "Cone of its light": ("half_angle", "apex_angle", "na", "f_number"),
    "Receiver": (
        "receiver_area",
        "receiver_radius",
        "receiver_diameter",
        "distance",
        "incidence",
    ),
    "Results": calculator.RESULTS,
}


@click.command(
    "etendue",
    cls=SectionedCommand,
    sections=SECTIONS,
    context_settings={"max_content_width": 100},
)
@calculator.inputs(
    "area",
    "radius",
    "diameter",
    "width",
    "length",
    "tilt",
    "half-angle",
    "apex-angle",
    "na",
    "f-number",
    "receiver-area",
    "receiver-radius",
    "receiver-diameter",
    "distance",
    "incidence",
    width="Width of a rectangular source.",
    length="Length of a rectangular source.",
    distance="Straight line from the source to the receiver.",
)
@calculator.quantities("radiance")
@calculator.results
@output.options
def command(
    asked: calculator.Asked,
    shown: output.Output,
    **typed: str | None,
) -> int:
    """Give the etendue of a source, and the flux that a radiance sends through it.

    \b
    Examples:
      radcalc etendue --area 1mm2 --half-angle 90deg
      radcalc etendue --diameter 200um --na 0.22
      radcalc etendue --width 14.5mm --length 8.2mm --f-number 2.4
      radcalc etendue --area 1cm2 --receiver-area 4cm2 --distance 1m --tilt 60deg
      radcalc etendue --radius 1m --receiver-radius 1m --distance 0.5m,1m,2m
      radcalc etendue --area 1mm2 --half-angle 30deg --radiance 1e6cd/m2 -g flux:lm

    A source and a cone, or a source and a receiver: two discs (--radius, --receiver-radius) that
    face each other are exact, other patches must be small beside their distance.
    """
    return calculator.run(calculator.cases(typed), etendue, asked, shown, command="etendue")
