"""`radcalc etendue`."""

from radcalc.calculators.etendue import etendue
from radcalc.cli.calculator import Asked, cases, run
from radcalc.cli.command import define
from radcalc.cli.options import Output


@define(
    "etendue",
    {
        "Source": ("area", "radius", "diameter", "width", "length", "tilt"),
        "Cone of its light": ("half-angle", "apex-angle", "na", "f-number"),
        "Receiver": (
            "receiver-area",
            "receiver-radius",
            "receiver-diameter",
            "distance",
            "incidence",
        ),
        "Light": ("radiance", "flux", "etendue"),
    },
)
def command(typed: dict[str, str], asked: Asked, shown: Output) -> int:
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
    return run(cases(typed), etendue, asked, shown, "etendue")
