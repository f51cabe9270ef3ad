"""A source that is small beside its distance: flux, intensity, irradiance, and what gives them.

The intensity is that on the source's axis.
"""

import math
from typing import Any

from radcalc.answer import Answer
from radcalc.calculators import inputs as i
from radcalc.calculators import light as q
from radcalc.calculators.inputs import Inputs
from radcalc.calculators.worksheet import Sheet
from radcalc.conversion import geometric
from radcalc.conversion.conditions import positive, require, show
from radcalc.errors import ConditionError, UsageError
from radcalc.laws.law import AnyLaw
from radcalc.laws.point import (
    ANY_LAWS,
    CONICAL,
    FALL,
    INSIDE,
    INTERNAL,
    INVERSE_SQUARE,
    ISOTROPIC,
    LAWS,
    LOBED,
    OFF_AXIS,
)
from radcalc.maths import any_true, atan2, hypot, is_array

QUANTITIES = ("flux", "intensity", "irradiance", "exposure", "energy")
POSITION = ("distance", "height", "offset", "offset-y", "incidence")
CONE = ("half-angle", "apex-angle", "solid-angle")
LOBE = ("exponent", "beam-angle", "field-angle")
INPUTS = (*CONE, *LOBE, *POSITION, "within", "time", "receiver-area")
DISTRIBUTIONS = (ISOTROPIC, CONICAL, LOBED)
RESULTS = (
    "intensity",
    "flux",
    "irradiance",
    "exposure",
    "energy",
    "received-flux",
    "flux-within",
    "beam-flux",
)
UNITS = {
    "distance": "m",
    "height": "m",
    "offset": "m",
    "offset-y": "m",
    "incidence": "deg",
    "off-axis": "deg",
}
OTHERS = {"within": "deg", "time": "s", "receiver-area": "m2"}
SHAPED = {
    ISOTROPIC: {},
    CONICAL: {"half-angle": "deg", "apex-angle": "deg", "solid-angle": "sr"},
    LOBED: {"exponent": "1", "beam-angle": "deg", "field-angle": "deg"},
}
SAID = {
    ISOTROPIC: "isotropic: the same intensity in all directions",
    CONICAL: "the same intensity everywhere in the cone, none outside",
    LOBED: "intensity I0 cos^n(theta) from the axis; I0 is the intensity given here",
}


def point_source(
    given: Inputs, distribution: str | None = None, any_incidence: bool = False
) -> Answer:
    """Everything that follows for a point source from whatever is known of it.

    `given` are light quantities by whichever name, lengths, angles, times, and what links the
    kinds; `distribution` is one of `DISTRIBUTIONS`.  With `any_incidence` that is what is
    looked for, and not taken to be 0.
    """
    quantities, links, rest = q.sort(given)
    i.only(rest, INPUTS, "a point source")
    lit = q.read_light(quantities, links)
    _refuse_foreign(lit)
    shape = spread(rest, distribution)
    sheet = Sheet(lit, rest, INTERNAL, "incidence")
    _check_angles(rest)
    laws = [*LAWS[shape], *ANY_LAWS, *_position(rest, sheet, shape)]
    sheet.said.append(SAID[shape])
    _solve(sheet, laws, any_incidence)
    sheet.refuse_idle(laws, (*QUANTITIES, *INPUTS))
    _refuse_near(rest, sheet)
    if sheet.has("cosine") and any_true(sheet.at("cosine") == 0):
        sheet.notes.append("light from the side or behind does not reach the receiver")
    if shape == CONICAL and sheet.has("share") and any_true(sheet.at("share") == 0):
        sheet.notes.append("the receiver is outside the cone")
    rows, shown = sheet.light_rows(RESULTS)
    rows += sheet.input_rows({**UNITS, **SHAPED[shape], **OTHERS})
    rows += sheet.efficacy_row()
    names = {**UNITS, **SHAPED[CONICAL], **SHAPED[LOBED], **OTHERS}
    rows += sheet.absent_rows(laws, (*RESULTS, *names), (*QUANTITIES, *INPUTS))
    return sheet.answer(rows, shown)


def _solve(sheet: Sheet, laws: list[AnyLaw], any_incidence: bool) -> None:
    """Work out what follows; light comes along the receiver's normal unless told otherwise."""
    told = "incidence" in sheet.known
    placed = sheet.has("irradiance", "distance", "exposure")
    if told or any_incidence or not placed:
        sheet.solve(laws)
        if told or not placed or "incidence" in sheet.solution.values:
            return
    sheet.know("incidence", 0.0)
    sheet.said.append("light along the receiver's normal")
    try:
        sheet.solve(laws)
    except ConditionError as error:
        raise _with_incidence(sheet, laws, error) from None


def _with_incidence(sheet: Sheet, laws: list[AnyLaw], error: ConditionError) -> ConditionError:
    """A contradiction, with the incidence that would resolve it."""
    del sheet.known["incidence"]
    try:
        sheet.solve(laws)
        angle = sheet.at("incidence")
    except (ConditionError, KeyError):
        return error
    if is_array(angle):
        return error
    hint = f"{error.hint}; an incidence of {math.degrees(angle):.6g} deg would explain it"
    return ConditionError(error.message, hint)


def _refuse_foreign(lit: q.Lit) -> None:
    """Refuse what a point has not: a radiance, an exitance."""
    for name, one in lit.values.items():
        if name not in QUANTITIES:
            raise ConditionError(f"{one.flag}: a point source has none", "radcalc lambertian")
    if not lit.values:
        raise UsageError("a light quantity is missing", "--flux, --intensity or --irradiance")


def _check_angles(given: Inputs) -> None:
    """Refuse angles that no cone and no lobe has."""
    for name, one in given.items():
        if name in ("beam-angle", "field-angle"):
            require(one, not any_true(one.value >= math.pi), "less than 180 deg")
        elif name in ("half-angle", "apex-angle"):
            i.half_angle(one)
        elif name == "height" and "distance" in given and "offset" not in given:
            raise ConditionError(
                "--height and --distance are the same on the source's axis",
                "one of them, or --height with --offset",
            )
        elif name in ("within", "incidence"):
            i.tilt(given, name)


def spread(given: Inputs, chosen: str | None) -> str:
    """How the light is spread: as it was chosen, or as an option of its own tells."""
    of = {CONICAL: CONE, LOBED: LOBE}
    told = {shape: [given[n].flag for n in names if n in given] for shape, names in of.items()}
    if told[CONICAL] and told[LOBED]:
        raise ConditionError(
            f"{told[CONICAL][0]} is of a uniform cone, {told[LOBED][0]} of a cosine-power lobe",
            "one of them",
        )
    for shape, flags in told.items():
        if flags:
            if chosen not in (None, shape):
                raise ConditionError(
                    f"{flags[0]} is of a {shape}, and contradicts --distribution {chosen}",
                    "one of them",
                )
            return shape
    return chosen or ISOTROPIC


def _position(given: Inputs, sheet: Sheet, shape: str) -> list[AnyLaw]:
    """What the receiver's place adds: known values, and laws for a place off the axis."""
    if "incidence" in given:
        sheet.know("incidence", i.tilt(given, "incidence"), given["incidence"])
    lateral = [given[name] for name in ("offset", "offset-y") if name in given]
    if not lateral:
        if "height" in given:
            sheet.know("lateral", 0.0)
            _level(given, sheet, 0.0)
        return [INVERSE_SQUARE]
    if "height" not in given:
        raise UsageError(
            "--height is missing beside --offset", "--height 6m, along the source's axis"
        )
    sideways = (
        hypot(*(one.value for one in lateral)) if len(lateral) == 2 else abs(lateral[0].value)
    )
    sheet.know("lateral", sideways, *lateral)
    off = atan2(sideways, positive(given["height"]))
    sheet.know("off-axis", off)
    _level(given, sheet, off)
    if shape == ISOTROPIC:
        return [INVERSE_SQUARE]
    sheet.said.append("the source points straight down")
    if shape == CONICAL:
        if not (set(CONE) & set(given) or {"flux", "intensity"} <= set(sheet.known)):
            sheet.said.append("the receiver is inside the cone")
            return [INVERSE_SQUARE]
        return [OFF_AXIS, INSIDE]
    return [OFF_AXIS, FALL]


def _level(given: Inputs, sheet: Sheet, off: Any) -> None:
    """A receiver under a height lies in a plane across the source's axis, unless told."""
    if "incidence" not in given:
        sheet.know("incidence", off)
        sheet.said.append("the receiver lies flat, in a plane across the source's axis")


def _refuse_near(given: Inputs, sheet: Sheet) -> None:
    """Refuse a receiver so large beside its distance that its irradiance is not uniform."""
    if "receiver-area" in given and sheet.has("distance"):
        size = geometric.size_of(given["receiver-area"].value)
        if geometric.is_near(sheet.at("distance"), size):
            raise ConditionError(
                f"--receiver-area {given['receiver-area'].text} is too large for its distance: "
                "the irradiance on it is not uniform",
                f"a distance of {show(5 * size)} m or more",
            )
