"""Light at a plane surface between two transparent media: angles, reflectances, transmittances."""

import math

from radcalc.answer import Answer
from radcalc.calculators.page import Page
from radcalc.calculators.solved import solve
from radcalc.calculators.worksheet import Placed, worksheet
from radcalc.errors import ConditionError, MissingInput, mention, option, quote
from radcalc.inputs import Inputs, angle_of, require
from radcalc.laws.optics import CRITICAL_INSIDE, CRITICAL_OUTSIDE, REFRACTION_LAWS, TOTAL
from radcalc.maths import any_true, sin

ANGLES = ("incidence", "refraction-angle", "brewster-angle", "critical-angle")
PAGE = Page(
    "a surface between two media",
    ("index", *ANGLES),
    (),
    (
        "index",
        "incidence",
        "refraction-angle",
        "reflectance-s",
        "reflectance-p",
        "reflectance",
        "transmittance",
        "slab-transmittance",
        "brewster-angle",
        "critical-angle",
    ),
    goal="index",
    about="Calculate angles, reflectances and transmittances at a surface between two media.",
    sections={"Media": ("index",), "Angles": ANGLES},
    texts={"incidence": ("60deg", "Angle between the incident light and the normal.")},
    examples=(
        "index=1.52 incidence=60deg",
        "index=1.52 incidence=0deg:80deg:10deg get=slab-transmittance:%",
        "index=1.333 incidence=45deg get=refraction-angle:deg",
        "incidence=45deg refraction-angle=28deg get=index",
        "index=1/1.52 incidence=60deg",
        "brewster-angle=56.66deg get=index",
    ),
    remarks="{index} is the refractive index after the surface divided by that before it: 1.52 "
    "into glass, 1/1.52 out of it; absorbing media are not covered.  s-polarised light has its "
    "electric field perpendicular to the plane of incidence, p-polarised light parallel to it; the "
    "result reflectance is for unpolarised light.  The slab is a plane layer of the second medium "
    "with the first medium on both sides; its transmittance includes all internal reflections.",
)


def refraction(given: Inputs) -> Answer:
    """Return angles, reflectances and transmittances at a surface, without absorption."""
    if not given:
        raise MissingInput("the index is missing", mention("{index=1.52} and {incidence=60deg}"))
    sheet, placed = worksheet(PAGE, given, with_light=False), Placed()
    if "incidence" in given:
        angle = angle_of(given, "incidence")
        require(given["incidence"], not any_true(angle > math.pi / 2), "from 0 to 90 deg")
        placed.add("incidence", angle, given["incidence"])
    placed.assume("transparent media: nothing is absorbed")
    is_rarer = "index" in given and any_true(given["index"].value < 1)
    critical = CRITICAL_OUTSIDE if is_rarer else CRITICAL_INSIDE
    if _is_total(given):
        for name in ("reflectance-s", "reflectance-p"):
            placed.add(name, 1.0 + 0.0 * given["incidence"].value)
        placed.use("incidence")
        placed.note("total reflection: the incidence is above the critical angle")
        solved = solve(sheet, [*TOTAL, critical], placed)
    else:
        solved = solve(sheet, [*REFRACTION_LAWS, critical], placed)
    if solved.has("slab-transmittance"):
        solved.assume("unpolarised light", of=["reflectance", "slab-transmittance"])
        slab = "a slab reflects at both faces, without interference"
        solved.assume(slab, of=["slab-transmittance"])
    return solved.answer()


def _is_total(given: Inputs) -> bool:
    """Return whether all light is totally reflected; refuse a range that is so only in part."""
    if not {"index", "incidence"} <= given.keys():
        return False
    index, sine = given["index"].value, sin(angle_of(given, "incidence"))
    if not any_true(sine > index):
        return False
    if "refraction-angle" in given:
        angle = option("refraction-angle", quote(given["refraction-angle"].text))
        raise ConditionError(f"{angle}: the light is totally reflected", "a smaller incidence")
    if any_true(sine <= index):
        raise ConditionError("some of the light is totally reflected", "one value a call")
    return True
