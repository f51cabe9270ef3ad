"""A source that is small beside its distance: flux, intensity, irradiance, and what gives them.

The intensity is that on the source's axis.
"""

import math
from typing import Any

from radcalc.answer import Answer
from radcalc.calculators.light import Lit
from radcalc.calculators.worksheet import Page, Worksheet
from radcalc.derivation import coherent_unit_of, format_number, format_value
from radcalc.errors import (
    ConditionError,
    Exclusive,
    MissingInput,
    command,
    mention,
    option,
)
from radcalc.given import Inputs, angle_of
from radcalc.laws.law import AnyLaw
from radcalc.laws.point import (
    ACROSS,
    ANY_LAWS,
    ASIDE,
    CONICAL,
    FALL,
    INSIDE,
    INVERSE_SQUARE,
    ISOTROPIC,
    LAWS,
    LOBED,
    OFF_AXIS,
    RECEIVED,
)
from radcalc.maths import any_true, atan2, hypot, is_array

QUANTITIES = ("flux", "intensity", "irradiance", "exposure", "energy")
CONE = ("half-angle", "apex-angle", "solid-angle")
LOBE = ("exponent", "beam-angle", "field-angle")
POSITION = ("distance", "height", "offset", "offset-y", "incidence")
RECEIVER = ("within", "time", "receiver-area")
SHAPED = {ISOTROPIC: (), CONICAL: CONE, LOBED: LOBE}
PAGE = Page(
    "a point source",
    (*QUANTITIES, *CONE, *LOBE, *POSITION, *RECEIVER, "distribution"),
    (
        "intensity",
        "flux",
        "irradiance",
        "exposure",
        "energy",
        "received-flux",
        "flux-within",
        "beam-flux",
    ),
)
ASSUMED = {
    ISOTROPIC: "isotropic: the same intensity in all directions",
    CONICAL: "the same intensity everywhere in the cone, none outside",
    LOBED: "intensity I0 cos^n(theta) from the axis; I0 is the intensity given here",
}


def point_source(given: Inputs, any_incidence: bool = False) -> Answer:
    """Everything that follows for a point source from whatever is known of it.

    `given` are light quantities by whichever name, the distribution, lengths, angles, times, and
    what links the kinds.  With `any_incidence` that is looked for, and not taken to be 0.
    """
    shape = spread(given)
    sheet = Worksheet(
        PAGE._replace(others=(*POSITION, "off-axis", *SHAPED[shape], *RECEIVER)), given
    )
    sheet.defaults.add("incidence")
    _refuse_foreign(sheet.lit)
    _refuse_height_and_distance(sheet.given)
    laws = [*LAWS[shape], *ANY_LAWS, *_position(sheet, shape)]
    sheet.assume(ASSUMED[shape])
    _solve(sheet, laws, any_incidence)
    if sheet.has("received-flux"):
        _judge_receiver(sheet, shape)
    if sheet.has("cosine") and any_true(sheet.at("cosine") == 0):
        sheet.notes.append("light from the side or behind does not reach the receiver")
    if shape == CONICAL and sheet.has("share") and any_true(sheet.at("share") == 0):
        reached = sheet.has("received-flux") and any_true(sheet.at("received-flux") > 0)
        centre = "'s centre" if reached else ""
        sheet.notes.append(f"the receiver{centre} is outside the cone")
    return sheet.answer(laws)


def _solve(sheet: Worksheet, laws: list[AnyLaw], any_incidence: bool) -> None:
    """Work out what follows; light comes along the receiver's normal unless told otherwise."""
    told = "incidence" in sheet.known
    placed = sheet.has("irradiance", "distance", "exposure")
    if told or any_incidence or not placed:
        sheet.solve(laws)
        if told or not placed or "incidence" in sheet.solution.values:
            return
    sheet.know("incidence", 0.0)
    sheet.assume("light along the receiver's normal")
    try:
        sheet.solve(laws)
    except ConditionError as error:
        raise _with_incidence(sheet, laws, error) from None


def _with_incidence(sheet: Worksheet, laws: list[AnyLaw], error: ConditionError) -> ConditionError:
    """A contradiction, with the incidence that would resolve it."""
    del sheet.known["incidence"]
    try:
        sheet.solve(laws)
        angle = sheet.at("incidence")
    except (ConditionError, KeyError):
        return error
    if not is_array(angle):
        error.hint += f"; an incidence of {math.degrees(angle):.6g} deg would explain it"
    return error


def _refuse_foreign(lit: Lit) -> None:
    """Refuse what a point has not: a radiance, an exitance."""
    for name, one in lit.values.items():
        if name not in QUANTITIES:
            raise ConditionError(
                f"{option(one.name)}: a point source has none", command("lambertian")
            )
    if not lit.values:
        hint = mention("{flux}, {intensity} or {irradiance}")
        raise MissingInput("a light quantity is missing", hint)


def _refuse_height_and_distance(given: Inputs) -> None:
    if {"height", "distance"} <= set(given) and "offset" not in given:
        raise Exclusive(
            ("height", "distance"),
            "are the same on the source's axis",
            mention("one of them, or {height} with {offset}"),
        )


def spread(given: Inputs) -> str:
    """How the light is spread: as it was chosen, or as an input of its own tells."""
    chosen = given["distribution"].value if "distribution" in given else None
    told = {shape: [n for n in names if n in given] for shape, names in SHAPED.items()}
    if told[CONICAL] and told[LOBED]:
        raise ConditionError(
            f"{option(told[CONICAL][0])} is of a uniform cone, "
            f"{option(told[LOBED][0])} of a cosine-power lobe",
            "one of them",
        )
    for shape, names in told.items():
        if names:
            if chosen not in (None, shape):
                raise ConditionError(
                    f"{option(names[0])} is of a {shape}, and contradicts "
                    f"{option('distribution', str(chosen))}",
                    "one of them",
                )
            return shape
    return str(chosen or ISOTROPIC)


def _position(sheet: Worksheet, shape: str) -> list[AnyLaw]:
    """What the receiver's place adds: known values, and laws for a place off the axis."""
    given = sheet.given
    if "incidence" in given:
        sheet.know("incidence", angle_of(given, "incidence"), given["incidence"])
    lateral = [given[name] for name in ("offset", "offset-y") if name in given]
    if not lateral:
        if "height" in given:
            sheet.know("lateral", 0.0)
            _lie_flat(sheet, 0.0)
        return [INVERSE_SQUARE, RECEIVED[shape]]
    if "height" not in given:
        raise MissingInput(
            f"{option('height')} is missing beside {option(lateral[0].name)}",
            mention("{height=6m}, along the source's axis"),
        )
    sideways = abs(lateral[0].value)
    if len(lateral) == 2:
        sideways = hypot(*(one.value for one in lateral))
    sheet.know("lateral", sideways, *lateral)
    off = atan2(sideways, given["height"].value)
    sheet.know("off-axis", off)
    _lie_flat(sheet, off)
    received = (ASIDE if "incidence" in given else ACROSS)[shape]
    if shape == ISOTROPIC:
        return [INVERSE_SQUARE, received]
    sheet.assume("the source points straight down")
    if shape == CONICAL:
        if not (set(CONE) & set(given) or {"flux", "intensity"} <= set(sheet.known)):
            sheet.assume("the receiver is inside the cone")
            return [INVERSE_SQUARE, received]
        return [OFF_AXIS, INSIDE, received]
    return [OFF_AXIS, FALL, received]


def _lie_flat(sheet: Worksheet, off: Any) -> None:
    """A receiver under a height lies in a plane across the source's axis, unless told."""
    if "incidence" not in sheet.given:
        sheet.know("incidence", off)
        sheet.assume("the receiver lies flat, in a plane across the source's axis")


def _judge_receiver(sheet: Worksheet, shape: str) -> None:
    """Say what is assumed of the receiver, and where the light on it is not even."""
    sheet.assume("the receiver is a disc of that area")
    area, away, off = sheet.at("receiver-area"), sheet.at("distance"), 0.0
    if sheet.has("off-axis"):
        off = sheet.at("off-axis")
    if shape == LOBED and "incidence" in sheet.given:
        from radcalc.geometry import receivers

        uneven = receivers.unevenness(sheet.at("exponent"), (area / math.pi) ** 0.5, away, off)
        sheet.assume(f"the intensity on it is even, within {format_number(100 * uneven)} %")
    mean = sheet.at("received-flux") / area
    if not is_array(mean) and abs(sheet.at("irradiance") - mean) > 0.01 * mean:
        unit = coherent_unit_of("irradiance", sheet.lit.kind)
        sheet.notes.append(
            "the irradiance is that at the receiver's centre; its mean over the receiver is "
            f"{format_value(mean, unit)}"
        )
