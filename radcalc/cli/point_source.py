"""`radcalc point-source`."""

import click

from radcalc.calculators.point_source import DISTRIBUTIONS, INPUTS, QUANTITIES, point_source, spread
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand

SECTIONS = {
    "Light": tuple(QUANTITIES),
    "Its directions": (
        "distribution",
        "half_angle",
        "apex_angle",
        "solid_angle",
        "exponent",
        "beam_angle",
        "field_angle",
        "within",
    ),
    "The receiver": (
        "distance",
        "height",
        "offset",
        "offset_y",
        "incidence",
        "receiver_area",
        "time",
    ),
    "Kinds of light": ("wavelength", "spectrum", "efficacy", "observer", "range", "photon_range"),
    "Results": calculator.RESULTS,
}


@click.command(
    "point-source",
    cls=SectionedCommand,
    sections=SECTIONS,
    context_settings={"max_content_width": 100},
)
@calculator.quantities(*QUANTITIES)
@click.option(
    "--distribution",
    type=click.Choice(DISTRIBUTIONS),
    help="How the light is spread (isotropic, unless an option of a cone or a lobe is given).",
)
@calculator.inputs(
    *INPUTS,
    distance="Straight line from the source to the receiver.",
    height="Height of the source above the receiver's plane, along its axis.",
    half_angle="Half angle of a uniform cone, from its axis to its edge.",
    apex_angle="Full angle of a uniform cone, from edge to edge.",
    solid_angle="Solid angle of a uniform cone.",
)
@calculator.light_options
@calculator.results
@output.options
def command(
    distribution: str | None,
    asked: calculator.Asked,
    shown: output.Output,
    **typed: str | None,
) -> int:
    """Give what follows for a source that is small beside its distance.

    \b
    Examples:
      radcalc point-source --flux 800lm --distance 2m
      radcalc point-source --illuminance 500lx --distance 2m
      radcalc point-source --intensity 100cd --illuminance 25lx            (the distance)
      radcalc point-source --intensity 250cd --height 6m --offset 8m
      radcalc point-source --flux 4.5klm --half-angle 12.5deg --distance 1m,2m,5m
      radcalc point-source --intensity 1000cd --beam-angle 30deg
      radcalc point-source --intensity 100cd --exponent 3 --within 45deg -g flux-within:lm
      radcalc point-source --flux 500lm --intensity 900cd --distribution cone
      radcalc point-source --flux 5mW --distance 1m --wavelength 632.8nm

    Any sufficient set of the quantities gives the others; what is given twice is checked, to the
    digits typed.  The irradiance is at the receiver.  Light comes along the receiver's normal,
    unless --incidence tells otherwise or -g incidence asks what it is; under a --height the
    source points straight down and the receiver lies flat.  Several sources add up:

    \b
      for i in 100cd 250cd; do
        radcalc point-source --intensity $i --distance 2m -q -g irradiance:lx
      done | awk '{ sum += $1 } END { print sum }'
    """
    each = calculator.cases(typed, arrays=True)
    shape = spread(each[0][1], distribution)
    return calculator.run(
        each,
        lambda given: point_source(given, distribution, asked.wants("incidence")),
        asked,
        shown,
        command="point-source",
        distribution=shape,
    )
