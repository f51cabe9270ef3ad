"""A projection screen: the luminance and the illuminance of a projected picture."""

from typing import Any

from radcalc import geometry
from radcalc.answer import Answer
from radcalc.calculators.page import Page
from radcalc.calculators.solved import solve
from radcalc.calculators.worksheet import Placed, worksheet
from radcalc.errors import MissingInput, mention
from radcalc.inputs import Inputs
from radcalc.laws import ASPECT, AnyLaw, law, relation
from radcalc.laws.solver import reached
from radcalc.maths import hypot, power, sqrt, square
from radcalc.quantities.symbols import LINKS, REFINEMENTS

SIZES = ("width", "height", "diagonal", "aspect", "area")


def _side(diagonal: Any, other: Any) -> Any:
    geometry.refuse(diagonal <= other, "the diagonal is not longer than the side", "more of it")
    return sqrt((diagonal - other) * (diagonal + other))


LAWS: list[AnyLaw] = [
    law("illuminance of a picture", "{flux} = {irradiance} {area}", "ISO 80000-7, illuminance"),
    law(
        "luminance of a screen",
        "{radiance} = {gain} {irradiance} / (pi Omega0)",
        "ISO 80000-7, luminance and reflectance: a perfect diffuser has a gain of 1",
    ),
    law("area of a picture", "{area} = {width} {height}"),
    law("aspect of a picture", "{width} = {aspect} {height}"),
    relation(
        "diagonal of a picture",
        "{diagonal} = {width} sqrt(1 + 1/{aspect}^2)",
        {
            "diagonal": lambda at: at("width") * sqrt(1 + power(at("aspect"), -2)),
            "width": lambda at: at("diagonal") / sqrt(1 + power(at("aspect"), -2)),
            "aspect": lambda at: 1 / sqrt(square(at("diagonal") / at("width")) - 1),
        },
    ),
    relation(
        "sides of a picture",
        "{diagonal}^2 = {width}^2 + {height}^2",
        {
            "diagonal": lambda at: hypot(at("width"), at("height")),
            "width": lambda at: _side(at("diagonal"), at("height")),
            "height": lambda at: _side(at("diagonal"), at("width")),
        },
    ),
    relation(
        "width of a picture",
        "{width} = sqrt({area} {aspect})",
        {
            "width": lambda at: sqrt(at("area") * at("aspect")),
            "area": lambda at: square(at("width")) / at("aspect"),
        },
    ),
]
PAGE = Page(
    "a screen",
    (*SIZES, "gain"),
    ("radiance", "irradiance", "flux"),
    ("gain", *SIZES),
    goals=("width",),
    about="Calculate the luminance and the illuminance of the picture on a projection screen.",
    sections={
        "Light": ("flux", "irradiance", "radiance"),
        "Picture": (*SIZES, "gain"),
        "Radiant, luminous and photon quantities": (*LINKS, *REFINEMENTS),
    },
    texts={
        "width": "Width of the picture.",
        "area": ("2m2", "Area of the picture."),
        "height": ("1.2m", "Height of the picture."),
        "flux": "Flux that reaches the picture.",
        "irradiance": "Irradiance on the screen.",
        "radiance": "Radiance along the normal of the screen.",
    },
    examples=(
        "flux=3000lm diagonal=100in aspect=16/9 gain=1.3",
        "flux=2000lm width=2m aspect=4/3 get=luminance:fL",
        "flux=3000lm area=3m2 diagonal=100in",
        "luminance=48cd/m2 width=12m aspect=2.39 gain=1 get=flux:lm",
    ),
    remarks="The luminance is that along the screen's normal, in a dark room.  Give the quantities "
    "that you know; radcalc calculates those that follow from them.",
)


def screen(given: Inputs) -> Answer:
    """Return luminance, illuminance, flux and sizes of a picture from a sufficient set."""
    sheet, placed = worksheet(PAGE, given), Placed()
    sizes = reached(LAWS, set(given))
    if not sheet.lit.values and "aspect" not in sizes and not {"area", "diagonal"} <= sizes:
        hint = mention("{flux=3000lm}, {illuminance} or {luminance}")
        raise MissingInput("a light quantity is missing", hint)
    if sheet.lit.values:
        white = mention("a matt white screen, with a gain of 1 ({gain})")
        placed.default(sheet, LAWS, "gain", 1.0, white)
        even = "the whole flux falls evenly on the picture, in a dark room"
        placed.assume(even, of=["flux", "irradiance", "radiance"])
    laws = LAWS
    known = reached(LAWS, set(sheet.known))
    if {"diagonal", "area"} <= known and not {"width", "height", "aspect"} & known:
        placed.assume("the picture is at least as wide as it is high", of=[ASPECT])
        laws = [*LAWS, ASPECT]
    return solve(sheet, laws, placed).answer()
