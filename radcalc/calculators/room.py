"""The lighting of a room by the lumen method: how many luminaires give which illuminance."""

from typing import Any

from radcalc.answer import Answer
from radcalc.calculators.worksheet import Page, Worksheet
from radcalc.errors import ConditionError, MissingInput, mention
from radcalc.geometry import cones
from radcalc.given import Inputs
from radcalc.laws.law import AnyLaw, law, relation
from radcalc.laws.sizes import RECTANGLE
from radcalc.maths import any_true, sqrt
from radcalc.quantities.symbols import LINKS, REFINEMENTS
from radcalc.units.numbers import EXACT

SIZES = ("width", "length", "area", "height")
LOSSES = ("utilance", "maintenance")


def _side(other: Any, height: Any, index: Any) -> Any:
    """One side of a room, by the other one."""
    least = index * height
    problem = "no room of that side and height has that room index"
    cones.refuse(other <= least, problem, "less height, or a smaller index")
    return least * other / (other - least)


def _shorter(area: Any, both: Any) -> Any:
    """The shorter side of a room, by its area and the sum of two sides."""
    problem = "no room of that area and height has that room index: a square one has less"
    cones.refuse(both < 2 * sqrt(area), problem, "less height, or a smaller index")
    # without the difference of nearly equal numbers that a long room has
    return 2 * area / (both + sqrt(both * both - 4 * area))


def _rounded_up(number: Any) -> Any:
    """The next whole number, or that which the number differs from in its last digits only."""
    return -(-number * (1 - EXACT) // 1)


LIT: list[AnyLaw] = [
    law(
        "lumen method",
        "{irradiance} = {luminaires} {flux} {utilance} {maintenance} / {area}",
        "ISO 80000-7, illuminance: what of the flux gets to the area",
    ),
    RECTANGLE,
    relation(
        "room index",
        "{room-index} = {width} {length} / ({height} ({width} + {length}))",
        {
            "room-index": lambda at: (
                at("width") / at("height") * (at("length") / (at("width") + at("length")))
            ),
            "height": lambda at: (
                at("width") / at("room-index") * (at("length") / (at("width") + at("length")))
            ),
            "width": lambda at: _side(at("length"), at("height"), at("room-index")),
            "length": lambda at: _side(at("width"), at("height"), at("room-index")),
        },
    ),
]
SIDES = relation(
    "sides of a room, by its area and index",
    "{width} = (s - sqrt(s^2 - 4 {area})) / 2, s = {area} / ({room-index} {height})",
    {"width": lambda at: _shorter(at("area"), at("area") / (at("room-index") * at("height")))},
)
INSTALLED: list[AnyLaw] = [
    relation(
        "luminaires to install",
        "{luminaires-to-install} = ceil({luminaires})",
        {"luminaires-to-install": lambda at: _rounded_up(at("luminaires"))},
    ),
    law(
        "illuminance as installed",
        "{installed-irradiance} = {irradiance} {luminaires-to-install} / {luminaires}",
    ),
]
LAWS = [*LIT, *INSTALLED]
PAGE = Page(
    "a room",
    (*SIZES, "room-index", "luminaires", *LOSSES),
    ("irradiance", "installed-irradiance", "flux"),
    ("luminaires", "luminaires-to-install", "room-index", *SIZES, *LOSSES),
    goal="room-index",
    about="Give the luminaires that light a room, or the illuminance that they give it.",
    sections={
        "Room": (*SIZES, "room-index"),
        "Light": ("irradiance", "flux", "luminaires", *LOSSES),
        "Kinds of light": (*LINKS, *REFINEMENTS),
    },
    examples=(
        "width=6m length=9m height=2m illuminance=500lx flux=3600lm utilance=0.6 maintenance=0.8",
        "width=6m length=9m luminaires=12 flux=3600lm utilance=0.6 maintenance=0.8",
        "area=54m2 illuminance=500lx luminaires=12 utilance=0.6 get=flux:klm",
        "width=6m length=9m height=2m get=room-index",
    ),
    remarks="The lumen method: the mean illuminance of the working plane is the flux that gets "
    "there over its area.  The {utilance} of a luminaire is in its data sheet, by the room index "
    "and the reflectances.  Any sufficient set of these gives the others.",
)


def room(given: Inputs) -> Answer:
    """The luminaires of a room, its index and illuminance, from any that suffice."""
    sheet = Worksheet(PAGE, given)
    if not given:
        hint = mention("{width}, {length}, {illuminance}, {flux} and {utilance}")
        raise MissingInput("nothing is given", hint)
    laws = LIT if "luminaires" in given else LAWS
    if given.keys() >= {"area", "room-index", "height"} and not given.keys() & {"width", "length"}:
        laws = [*laws, SIDES]
        sheet.assume("a rectangular room, whose width is the shorter side")
    if "luminaires" in given and any_true(given["luminaires"].value % 1 != 0):
        raise ConditionError(
            f"{sheet.told('luminaires')} is no whole number of luminaires",
            "a whole number, or what it follows from",
        )
    if sheet.lit.values:
        new = mention("new and clean luminaires: a maintenance factor of 1 ({maintenance})")
        sheet.default(laws, "maintenance", 1.0, new)
    sheet.solve(laws)
    sheet.refuse_impossible(*LOSSES)
    if sheet.has("room-index"):
        sheet.assume("room index by the height of the luminaires above the working plane")
    if sheet.has("luminaires", "irradiance"):
        sheet.assume("luminaires spread evenly; illuminance: the mean over the working plane")
    return sheet.answer(laws)
