"""A source of the same radiance in all directions, or a perfectly diffuse reflector.

The radiance goes over into an irradiance by the projected solid angle under which the receiver
sees the source, which is exact at any distance; the far field is shown beside it.
"""

import math

from radcalc.answer import Answer
from radcalc.calculators import inputs as i
from radcalc.calculators import light as q
from radcalc.calculators.inputs import Inputs
from radcalc.calculators.shapes import LAWS, POSITION, SHAPES, SIZES
from radcalc.calculators.worksheet import Sheet
from radcalc.conversion import geometric
from radcalc.conversion.conditions import show
from radcalc.errors import ConditionError, UsageError
from radcalc.maths import any_true, is_array, larger

QUANTITIES = (
    "radiance",
    "exitance",
    "flux",
    "intensity",
    "irradiance",
    "incident-irradiance",
    "exposure",
    "energy",
)
RESULTS = (*QUANTITIES, "far-field-irradiance")
INPUTS = (*SIZES, *POSITION, "tilt", "half-angle", "reflectance", "time")
UNITS = {
    "reflectance": "1",
    "area": "m2",
    "radius": "m",
    "diameter": "m",
    "width": "m",
    "length": "m",
    "distance": "m",
    "height": "m",
    "offset": "m",
    "offset-y": "m",
    "incidence": "deg",
    "tilt": "deg",
    "half-angle": "deg",
    "solid-angle": "sr",
    "projected-solid-angle": "sr",
    "configuration-factor": "1",
    "time": "s",
}
INTERNAL = {"apparent-area": "A_p", "cosine": "cos(theta)", "cosine-of-source": "cos(theta_s)"}


def lambertian(shape: str, given: Inputs, flags: tuple[str, ...] = ()) -> Answer:
    """Everything that follows for a Lambertian source of a shape of `SHAPES`.

    `given` are light quantities by whichever name, sizes, the receiver's place, and what links
    the kinds; `flags` may be corner and perpendicular.
    """
    quantities, links, rest = q.sort(given)
    named = f"a {shape}"
    i.only(rest, (*SHAPES[shape].takes, "reflectance", "time"), named)
    i.refuse_unused([f"--{flag}" for flag in flags if flag not in SHAPES[shape].flags], named)
    lit = q.read_light(quantities, links)
    if not lit.values and ("reflectance" in rest or "time" in rest or links):
        raise UsageError("a light quantity is missing", "--radiance, --exitance, --flux ...")
    if not given:
        raise UsageError("nothing is given", "--radiance, --exitance, --flux ...")
    if shape in ENDLESS:
        _refuse_whole(shape, lit)
    sheet = Sheet(lit, rest, INTERNAL)
    laws = [*LAWS, *SHAPES[shape].place(sheet, flags)]
    sheet.said.append("Lambertian: the same radiance in all directions")
    sheet.solve(laws)
    sheet.refuse_idle(laws, (*QUANTITIES, *INPUTS))
    if shape == "patch":
        _refuse_near(sheet)
    _judge(sheet)
    rows, shown = sheet.light_rows(RESULTS)
    rows += sheet.input_rows(UNITS)
    rows += sheet.efficacy_row()
    rows += sheet.absent_rows(laws, (*RESULTS, *UNITS), (*QUANTITIES, *INPUTS))
    return sheet.answer(rows, shown)


ENDLESS = ("plane", "hemisphere")


def _refuse_whole(shape: str, lit: q.Lit) -> None:
    """Refuse what an endless source has no end of."""
    for name in ("flux", "energy", "intensity"):
        if name in lit.values:
            raise ConditionError(
                f"{lit.values[name].flag}: a {shape} has no end, and no {name} of its own",
                "--radiance, --exitance or --irradiance",
            )


def _judge(sheet: Sheet) -> None:
    """Refuse what no Lambertian source does; say how far the far field is off."""
    if sheet.has("projected-solid-angle") and any_true(
        sheet.at("projected-solid-angle") > math.pi * (1 + 1e-9)
    ):
        raise ConditionError(
            "more irradiance than a source of that radiance gives, though it filled all that the "
            f"receiver sees (projected solid angle {show(sheet.at('projected-solid-angle'))} sr)",
            "at most pi times the radiance",
        )
    if sheet.has("reflectance") and any_true(sheet.at("reflectance") > 1 + 1e-9):
        raise ConditionError(
            f"a reflectance of {show(sheet.at('reflectance'))} is not possible: more light leaves "
            "the reflector than reaches it",
            "less radiance, or more incident irradiance",
        )
    if sheet.has("far-field-irradiance") and sheet.has("irradiance") and sheet.has("size"):
        far, exact = sheet.at("far-field-irradiance"), sheet.at("irradiance")
        if is_array(far) or is_array(exact) or not exact or abs(far / exact - 1) < 1e-6:
            return
        nearest = 5 * sheet.known["size"].value
        said = f"the inverse square law, from the centre, gives {show(far / exact)} times that"
        if far and sheet.at("distance") < nearest:
            said += f"; it is for {show(nearest)} m and more, five times the size"
        sheet.notes.append(said)


def _refuse_near(sheet: Sheet) -> None:
    """Refuse a patch seen from nearer than five times its size, however that was found."""
    if sheet.has("distance") and sheet.has("area"):
        longest = geometric.size_of(sheet.at("area"))
        for name in ("width", "length"):
            if sheet.has(name):
                longest = larger(longest, sheet.at(name))
        if geometric.is_near(sheet.at("distance"), longest, 1e-9):
            raise ConditionError(
                f"a distance of {show(sheet.at('distance'))} m is less than five times the size "
                f"of the source ({show(longest)} m)",
                "radcalc lambertian disc, sphere or rectangle, which are exact",
            )
