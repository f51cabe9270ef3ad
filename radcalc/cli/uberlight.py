"""`radcalc uberlight X,Y,Z ...`."""

from radcalc.calculators.uberlight import uberlight
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import cases, told
from radcalc.cli.command import LIGHT, define
from radcalc.cli.options import Output
from radcalc.errors import UsageError
from radcalc.given import read_place


@define(
    "uberlight",
    {
        "Light": ("intensity", "irradiance", "omni"),
        "Distance": ("falloff", "falloff-distance", "maximum", "near", "far"),
        "Direction, of a spot": ("superellipse", "roundness", "shear", "beam-exponent"),
        "Receiver": ("normal", "incidence"),
        "Kinds of light": LIGHT,
    },
    words="X,Y,Z ...",
    takes_lines=False,
)
def command(words: tuple[str, ...], typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give what a cinematographer's light ("uberlight") sends to points.

    \b
    Examples:
      radcalc uberlight 0,0,4 --intensity 1000cd
      radcalc uberlight 0,0,4 --intensity 1000cd --falloff 1 --falloff-distance 2m --steps
      radcalc uberlight 0.5m,0m,2m 1m,0m,2m --superellipse 0.2,0.2,0.4,0.4 --roundness 0.5
      radcalc uberlight 1,0,3 --illuminance 500lx --beam-exponent 8 -g intensity:cd
      radcalc uberlight 0,0,1 0,0,1.5 0,0,9 --intensity 100cd --near 1m:2m --far 8m:10m
      radcalc uberlight 0.5,0,0 --omni --intensity 100cd --maximum 4 --falloff 0,1,2

    The light is at 0,0,0; a spot shines along +z, an --omni everywhere.  X,Y,Z are three lengths
    (1m,0m,2m), or bare numbers of metres.  The attenuation is the product of four: by the depth z
    (--near, --far), by the superellipse, by the beam and by the fall-off (--falloff, --maximum).
    The irradiance is I a cos(theta) / L^2, a the attenuation and L the --falloff-distance, so that
    a fall-off of 2 is the inverse square, whatever L is.  intensity-toward is the intensity that
    a source with an inverse square would need to give the same.  Notes say which settings are no
    physics.

    The other lights of computer graphics, a spot with a power of the cosine, one with a cone, and
    the general point source, are point sources:

    \b
      radcalc point-source --intensity 1000cd --exponent 20 --height 3m --offset 1m --steps
      radcalc point-source --intensity 1000cd --half-angle 20deg --height 3m --offset 1m --steps
      radcalc point-source --distribution '(100 + 50*cos(theta)) cd' --distance 2m --steps
    """
    each = cases(typed, arrays=True)
    if not words:
        raise UsageError("a point is missing", "radcalc uberlight 0,0,4 --intensity 1000cd")
    points = [read_place("point", word) for word in words]
    places = [(told(point),) if len(points) > 1 else () for point in points]
    every = [
        case._replace(given=case.given | {"point": point}, varied=(*place, *case.varied))
        for point, place in zip(points, places, strict=True)
        for case in each
    ]
    return run(every, uberlight, asked, shown, "uberlight")
