"""`radcalc lambertian [SHAPE]`."""

from radcalc.answer import texts_of
from radcalc.calculators.lambertian import QUANTITIES, lambertian
from radcalc.calculators.shapes import SHAPES
from radcalc.cli import calculator
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import cases
from radcalc.cli.command import LIGHT, define
from radcalc.cli.options import Output
from radcalc.errors import UsageError, quote
from radcalc.quantities.symbols import CHOICE


@define(
    "lambertian",
    {
        "Light": (*QUANTITIES, "reflectance", "time"),
        "Source": ("area", "radius", "diameter", "width", "length", "tilt", "half-angle"),
        "Receiver": (
            "distance",
            "height",
            "offset",
            "offset-y",
            "corner",
            "incidence",
            "perpendicular",
        ),
        "Kinds of light": LIGHT,
    },
    words="[SHAPE]",
    operands=(CHOICE, tuple(SHAPES)),
    draws=True,
)
def command(words: tuple[str, ...], typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give what follows for a diffuse source or reflector, exactly at any distance.

    \b
    Examples:
      radcalc lambertian --radiance 2.0e7W/m2/sr
      radcalc lambertian --luminance 100cd/m2 --area 0.1m2
      radcalc lambertian --luminance 3000cd/m2 --area 100cm2 --height 2m --offset 1m
      radcalc lambertian --incident-illuminance 500lx --reflectance 0.8
      radcalc lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm --offset 10cm
      radcalc lambertian disc --radius 25cm --distance 75cm --illuminance 70lx -g exitance:lm/m2
      radcalc lambertian disc --luminance 1e4cd/m2 --radius 25cm --offset 50cm --illuminance 1klx
      radcalc lambertian hemisphere --luminance 3000cd/m2 --illuminance 5000lx
      radcalc lambertian sphere --luminance 2e4cd/m2 --radius 6cm --distance 1m:5m:1m
      radcalc lambertian disc --luminance 1e4cd/m2 --radius 25cm --distance 0.1m:5m:0.1m --plot
      radcalc lambertian rectangle --luminance 3000cd/m2 --width 1m --length 2m --height 1.5m \\
        --corner --perpendicular
      radcalc lambertian hemisphere --luminance 3000cd/m2 --incidence 30deg

    \b
    SHAPE is one of:
      patch (default)  --area or other sizes, small beside --distance (--tilt, --incidence)
                       or --height and --offset
      disc             --radius or --diameter, --height and --offset (on the axis --distance)
      sphere           --radius or --diameter, --distance to its centre
      rectangle        --width, --length, --height, --offset, --offset-y or --corner
      plane            endless
      hemisphere       a uniform sky, or a cone of it (--half-angle); radcalc sky has others

    \b
        source  ___________ length
               |     |
        height |     | axis
               |     |
          (1) _^_    |  (2) |>
            receiver

    The receiver faces the source's plane, as in (1).  --incidence turns it from the line to the
    centre, in the plane of the offset, off the axis.  --perpendicular: its normal runs along the
    rectangle's length, towards its centre, as in (2).

    The irradiance is that on the receiver, the incident one that on the reflector.
    """
    shape = calculator.shape(words[0] if words else "patch", [*SHAPES])
    if len(words) > 1:
        raise UsageError(f"too many words: '{quote(' '.join(words[1:]))}'", "one shape")
    each = cases(typed, arrays=True)
    operands = texts_of({"shape": shape})
    return run(
        each, lambda given: lambertian(shape, given), asked, shown, "lambertian", shape, operands
    )
