"""`radcalc sky [TYPE]`."""

import click

from radcalc.answer import texts_of
from radcalc.calculators.sky import sky, sky_map
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import cases
from radcalc.cli.command import LIGHT, define
from radcalc.cli.maps import one_case, write_map
from radcalc.cli.options import Output
from radcalc.errors import UsageError, quote
from radcalc.geometry.sky import NAMES
from radcalc.given import inputs_of
from radcalc.quantities.symbols import CHOICE

SAVE = click.Option(
    ["--save"],
    metavar="FILE.hdr",
    help="Write a latlong map of the sky (.hdr, .exr or .pfm; 1024x512), with the sun's disc if "
    "the sun has light.",
)


@define(
    "sky",
    {
        "Light": (
            "zenith-radiance",
            "horizontal-irradiance",
            "radiance-toward",
            "irradiance",
        ),
        "Sun": (
            "sun-elevation",
            "sun-azimuth",
            "sun-irradiance",
            "global-irradiance",
            "sun-radiance",
            "sun-radius",
        ),
        "Plane and direction": ("tilt", "azimuth", "normal", "toward"),
        "Map": (SAVE, "size"),
        "Kinds of light": LIGHT,
    },
    words="[TYPE]",
    operands=(CHOICE, NAMES),
    draws=True,
)
def command(
    words: tuple[str, ...],
    typed: dict[str, str],
    save: str | None,
    asked: Asked,
    shown: Output,
) -> int:
    """Give the light of the sky, toward a direction, on the ground and on a plane.

    \b
    Examples:
      radcalc sky overcast --zenith-luminance 9000cd/m2 --tilt 90deg
      radcalc sky overcast --horizontal-illuminance 10klx --toward 0deg:90deg:15deg
      radcalc sky clear --sun-elevation 40deg --horizontal-illuminance 12klx
      radcalc sky clear --sun-elevation 40deg --sun-azimuth 200deg --horizontal-illuminance 12klx \\
        --sun-illuminance 80klx --tilt 30deg --azimuth 180deg
      radcalc sky 12 --sun-elevation 10deg:80deg:10deg --zenith-luminance 3000cd/m2 \\
        -g horizontal-illuminance:klx
      radcalc sky 13 --sun-elevation 35deg --global-irradiance 600W/m2 --sun-irradiance 750W/m2
      radcalc sky clear --sun-elevation 40deg --horizontal-illuminance 12klx --spectrum D65 \\
        -g horizontal-photon-irradiance:umol/m2/s
      radcalc sky clear --sun-elevation 40deg --horizontal-illuminance 12klx --plot
      radcalc sky overcast --illuminance 4klx --tilt 90deg -g zenith-luminance
      radcalc sky clear --sun-elevation 40deg --sun-azimuth 0deg --horizontal-illuminance 12klx \\
        --save clear.hdr --size 2048x1024

    \b
    TYPE is one of:
      overcast (default)  the traditional one, of Moon and Spencer: the zenith is three times as
                          bright as the horizon
      uniform             the same in all directions (CIE type 5)
      clear               CIE type 12, low turbidity
      turbid              CIE type 13, the clear sky over polluted places
      intermediate        CIE type 7, partly cloudy and brighter about the sun
      1 to 15             a type of the CIE standard general sky (ISO 15469); 1 is its overcast sky

    The types 2, 4 and 6 to 15 depend on where the sun is.  The sun's own light is no part of the
    sky's: it is added where one of --sun-irradiance (perpendicular to its rays), --sun-radiance (of
    its disc) or --global-irradiance tells how much there is.  Any of the light gives all others.

    Azimuths may be counted in any one way, such as from north clockwise, as only their differences
    count; with --normal X,Y,Z or --toward X,Y,Z they are counted from +x towards +y.  The ground
    is dark: a wall is lit by half of the sky, and what the ground reflects is not counted.
    daylight-share is what the plane gets of the sky alone, over what the ground gets of it.
    """
    if len(words) > 1:
        raise UsageError(f"too many words: '{quote(' '.join(words[1:]))}'", "one type of sky")
    name = words[0].lower() if words else "overcast"
    if save:
        given = one_case(typed, asked)
        inputs = (*texts_of({"type": name, "save": save}), *inputs_of(given))
        return write_map(save, "map", lambda progress: sky_map(name, given), asked, shown, inputs)
    if "size" in typed:
        raise UsageError("--size has no use without --save", "--save FILE with it")
    each = cases(typed, arrays=True)
    operands = texts_of({"type": name})
    is_drawn = bool(asked.plot)
    return run(
        each,
        lambda given: sky(name, given, is_drawn),
        asked,
        shown,
        "sky",
        name,
        operands,
        drawn=name,
    )
