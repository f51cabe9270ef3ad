"""The lumen method: the number of luminaires in a room, and their illuminance."""

from typing import Any

from radcalc import geometry
from radcalc.answer import Answer
from radcalc.calculators.page import Page
from radcalc.calculators.solved import solve
from radcalc.calculators.worksheet import Placed, worksheet
from radcalc.errors import ConditionError, MissingInput, mention, option, quote
from radcalc.inputs import Inputs
from radcalc.laws import RECTANGLE, AnyLaw, law, relation
from radcalc.maths import any_true, sqrt
from radcalc.quantities.symbols import LINKS, REFINEMENTS
from radcalc.units.numbers import EXACT

SIZES = ("width", "length", "area", "height")
LOSSES = ("utilance", "maintenance")


def _side(other: Any, height: Any, index: Any) -> Any:
    least = index * height
    problem = "no room with that side and height has that room index"
    geometry.refuse(other <= least, problem, "less height, or a smaller index")
    return least * other / (other - least)


def _shorter(area: Any, total: Any) -> Any:
    """Return the shorter side of a room from its area and the sum of both sides."""
    problem = "no room with that area and height has that room index: a square room has less"
    geometry.refuse(total < 2 * sqrt(area), problem, "less height, or a smaller index")
    # avoids the difference of nearly equal numbers in a long room
    return 2 * area / (total + sqrt(total * total - 4 * area))


def _rounded_up(number: Any) -> Any:
    """Round up to a whole number; round down numbers that exceed it by rounding errors only."""
    return -(-number * (1 - EXACT) // 1)


LIT: list[AnyLaw] = [
    law(
        "lumen method",
        "{irradiance} = {luminaires} {flux} {utilance} {maintenance} / {area}",
        "ISO 80000-7, illuminance: the part of the flux that reaches the area",
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
    "sides of a room from its area and index",
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
    about="Calculate the number of luminaires for a room, or the illuminance that they give.",
    sections={
        "Room": (*SIZES, "room-index"),
        "Light": ("irradiance", "flux", "luminaires", *LOSSES),
        "Radiant, luminous and photon quantities": (*LINKS, *REFINEMENTS),
    },
    texts={
        "width": ("6m", "Width of the room."),
        "length": ("9m", "Length of the room."),
        "area": ("54m2", "Area of the room."),
        "height": ("2m", "Height of the luminaires above the working plane."),
        "flux": ("3600lm", "Flux of one luminaire."),
        "irradiance": ("500lx", "Mean irradiance or illuminance on the working plane."),
    },
    examples=(
        "width=6m length=9m height=2m illuminance=500lx flux=3600lm utilance=0.6 maintenance=0.8",
        "width=6m length=9m luminaires=12 flux=3600lm utilance=0.6 maintenance=0.8",
        "area=54m2 illuminance=500lx luminaires=12 utilance=0.6 get=flux:klm",
        "width=6m length=9m height=2m get=room-index",
    ),
    remarks="Lumen method: the mean illuminance of the working plane is the flux that reaches it, "
    "divided by its area.  The data sheet of a luminaire gives its {utilance} for the room index "
    "and the reflectances.  Give the quantities that you know; radcalc calculates those that "
    "follow from them.",
)


def room(given: Inputs) -> Answer:
    """Return the luminaires of a room, its index and illuminance from a sufficient set."""
    sheet, placed = worksheet(PAGE, given), Placed()
    if not given:
        hint = mention("{width}, {length}, {illuminance}, {flux} and {utilance}")
        raise MissingInput("the inputs are missing", hint)
    laws = LIT if "luminaires" in given else LAWS
    if given.keys() >= {"area", "room-index", "height"} and not given.keys() & {"width", "length"}:
        laws = [*laws, SIDES]
        placed.assume("a rectangular room, whose width is the shorter side", of=[SIDES])
    if "luminaires" in given and any_true(given["luminaires"].value % 1 != 0):
        raise ConditionError(
            f"{option('luminaires', quote(given['luminaires'].text))} is not a whole number",
            "a whole number, or the quantities that give it",
        )
    if sheet.lit.values:
        new = mention("new and clean luminaires: a maintenance factor of 1 ({maintenance})")
        placed.default(sheet, laws, "maintenance", 1.0, new)
    solved = solve(sheet, laws, placed)
    solved.refuse_impossible(*LOSSES)
    if solved.has("room-index"):
        above = "room index: the height is that of the luminaires above the working plane"
        solved.assume(above, of=["room-index"])
    if solved.has("luminaires", "irradiance"):
        even = "evenly distributed luminaires; illuminance: the mean over the working plane"
        solved.assume(even, of=["luminaires", "irradiance"])
    return solved.answer()
