"""`radcalc solid-angle SHAPE`."""

from radcalc.answer import Answer, texts_of
from radcalc.calculators.pixel import pixel
from radcalc.calculators.solid_angle import ALIASES, NAMES, solid_angle
from radcalc.cli import calculator
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import cases
from radcalc.cli.command import define
from radcalc.cli.options import Output
from radcalc.errors import UsageError, quote
from radcalc.given import Inputs, read_point
from radcalc.quantities.symbols import CHOICE


@define(
    "solid-angle",
    {
        "Cone": ("half-angle", "apex-angle", "projected-solid-angle", "solid-angle"),
        "Zone": ("polar", "azimuth"),
        "Sphere, disc, rectangle, patch": (
            "radius",
            "diameter",
            "width",
            "length",
            "area",
            "distance",
            "height",
            "offset",
            "offset-y",
            "corner",
            "tilt",
        ),
        "Pyramid": ("horizontal", "vertical"),
        "Polygon": ("viewpoint", "normal"),
        "Pixel": ("size", "pixel", "projection"),
    },
    words="SHAPE [X,Y,Z ...]",
    operands=(CHOICE, NAMES),
)
def command(words: tuple[str, ...], typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give the solid angle of a shape, and its projected solid angle.

    \b
    Examples:
      radcalc solid-angle cone --half-angle 30deg
      radcalc solid-angle cone --solid-angle 1sr                    (its half angle)
      radcalc solid-angle zone --polar 30deg:60deg --azimuth 0deg:90deg
      radcalc solid-angle sphere --radius 695700km --distance 1au
      radcalc solid-angle disc --diameter 10cm --height 50cm --offset 0cm:40cm:10cm
      radcalc solid-angle rectangle --width 2m --length 1m --height 1m --corner
      radcalc solid-angle pyramid --horizontal 60deg --vertical 40deg
      radcalc solid-angle patch --area 1cm2 --distance 2m --tilt 60deg
      radcalc solid-angle polygon 1,0,0 0,1,0 0,0,1 -g solid-angle:deg2
      radcalc solid-angle pixel --size 1024x512 --pixel 0,255

    \b
    SHAPE is one of:
      full, hemisphere   all directions, one half of them
      cone               --half-angle, --apex-angle, --solid-angle or --projected-solid-angle
      zone (band)        --polar A:B, --azimuth A:B
      sphere             two of --radius (or --diameter), --distance, --solid-angle
      disc               --radius or --diameter, --height (--distance), --offset
      rectangle          --width, --length, --height (--distance), --offset, --offset-y, --corner
      pyramid            --horizontal and --vertical, full angles
      patch              --area (or --radius, --diameter), --distance, --tilt: small and flat;
                         or --area and --radius, a part of that sphere seen from its centre
      polygon (triangle) X,Y,Z of each vertex in order, --viewpoint, --normal
      pixel              --size, --pixel, --projection: of a map of all directions

    Quantities may be lists (1m,2m) or ranges (1m:5m:1m), for an answer each.
    """
    shape, words = _shape(words)
    each = cases(typed, intervals=("polar", "azimuth"))  # first, so that 2 m is told to be 2m
    if shape != "polygon" and words:
        raise UsageError(f"too many words: '{quote(' '.join(words))}'", "options, as in --help")
    points = [read_point(word, "the vertex") for word in words]

    def work_out(given: Inputs) -> Answer:
        return pixel(given) if shape == "pixel" else solid_angle(shape, given, points)

    operands = texts_of({"shape": shape, "vertices": " ".join(words)})
    return run(each, work_out, asked, shown, "solid-angle", shape, operands)


def _shape(words: tuple[str, ...]) -> tuple[str, tuple[str, ...]]:
    """The shape by its own name, and the words after it."""
    if not words:
        raise UsageError("a shape is missing", ", ".join(NAMES))
    name = calculator.shape(words[0], NAMES)
    return ALIASES.get(name, name), words[1:]
