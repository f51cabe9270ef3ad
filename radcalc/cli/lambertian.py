"""`radcalc lambertian [SHAPE]`."""

import click

from radcalc.calculators.lambertian import INPUTS, QUANTITIES, lambertian
from radcalc.calculators.shapes import SHAPES
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.errors import UsageError, quote

SECTIONS = {
    "Light": (*(name.replace("-", "_") for name in QUANTITIES), "reflectance", "time"),
    "Source": ("area", "radius", "diameter", "width", "length", "tilt", "half_angle"),
    "Receiver": (
        "distance",
        "height",
        "offset",
        "offset_y",
        "corner",
        "incidence",
        "perpendicular",
    ),
    "Kinds of light": ("wavelength", "spectrum", "efficacy", "observer", "range", "photon_range"),
    "Results": calculator.RESULTS,
}


@click.command(
    "lambertian",
    cls=SectionedCommand,
    sections=SECTIONS,
    context_settings={"max_content_width": 100},
)
@click.argument("words", nargs=-1, metavar="[SHAPE]")
@calculator.quantities(*QUANTITIES)
@calculator.inputs(
    *INPUTS,
    distance="Straight line to the centre of the source.",
    half_angle="Half angle of the part of a hemisphere that shines, about its zenith.",
)
@click.option("--corner", is_flag=True, help="The receiver is under a corner of the rectangle.")
@click.option("--perpendicular", is_flag=True, help="Its normal runs along the rectangle's length.")
@calculator.light_options
@calculator.results
@output.options
def command(
    words: tuple[str, ...],
    corner: bool,
    perpendicular: bool,
    asked: calculator.Asked,
    shown: output.Output,
    **typed: str | None,
) -> int:
    """Give what follows for a diffuse source or reflector, exactly at any distance.

    \b
    Examples:
      radcalc lambertian --radiance 2.0e7W/m2/sr
      radcalc lambertian --luminance 100cd/m2 --area 0.1m2
      radcalc lambertian --incident-illuminance 500lx --reflectance 0.8
      radcalc lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm --offset 10cm
      radcalc lambertian disc --radius 25cm --distance 75cm --illuminance 70lx -g exitance:lm/m2
      radcalc lambertian sphere --luminance 2e4cd/m2 --radius 6cm --distance 1m:5m:1m
      radcalc lambertian rectangle --luminance 3000cd/m2 --width 1m --length 2m --height 1.5m \\
        --corner --perpendicular
      radcalc lambertian hemisphere --luminance 3000cd/m2 --incidence 30deg

    \b
    SHAPE is one of:
      patch (default)  --area or other sizes; with --distance small beside it, --tilt, --incidence
      disc             --radius or --diameter, --height and --offset (on the axis --distance)
      sphere           --radius or --diameter, --distance to its centre
      rectangle        --width, --length, --height, --offset, --offset-y or --corner
      plane            endless
      hemisphere       the whole sky, or a cone of it (--half-angle)

    \b
           source  ___________ length      The receiver faces the source's plane, as in (1).
                  |     |                  --incidence turns it from the line to the centre,
           height |     | axis             in the plane of the offset, off the axis.
                  |     |                  --perpendicular: its normal runs along the
             (1) _^_    |  (2) |>          rectangle's length, towards its centre, as in (2).
               receiver

    The irradiance is that on the receiver, the incident one that on the reflector.
    """
    shape = calculator.shape(words[0] if words else "patch", [*SHAPES])
    if len(words) > 1:
        raise UsageError(f"too many words: '{quote(' '.join(words[1:]))}'", "one shape")
    chosen = {"corner": corner, "perpendicular": perpendicular}
    flags = tuple(name for name, on in chosen.items() if on)
    each = calculator.cases(typed, arrays=True)
    facts = {"command": "lambertian", "shape": shape}
    return calculator.run(each, lambda g: lambertian(shape, g, flags), asked, shown, **facts)
