"""Common parts of point sources: receivers, angular distributions and laws."""

import math
from collections.abc import Sequence
from functools import reduce
from typing import Any

from radcalc import errors
from radcalc.answer import coherent_unit_of, format_value
from radcalc.calculators.kinds import LightInputs
from radcalc.calculators.solved import Solved, solve, solve_all
from radcalc.calculators.worksheet import OFFSETS, Placed, Worksheet
from radcalc.errors import option
from radcalc.inputs import Inputs, angle_of, require
from radcalc.laws import AnyLaw
from radcalc.laws.point import ASIDE, CONICAL, ISOTROPIC, LOBED
from radcalc.maths import any_true, hypot, is_array

QUANTITIES = ("flux", "intensity", "irradiance", "exposure", "energy")
# Inputs that need the distribution as a function of direction, not the laws of its shape.
DIRECTED = ("peak-intensity", "toward", "aim", "rotate")
CONE = ("half-angle", "apex-angle", "solid-angle")
LOBE = ("exponent", "beam-angle", "field-angle")
POSITION = ("distance", "height", *OFFSETS, "incidence")
RECEIVER = ("within", "time", "receiver-area")
SHAPED = {ISOTROPIC: (), CONICAL: CONE, LOBED: LOBE}
FLAGS = {"isotropic": ISOTROPIC, "hemisphere": CONICAL}  # complete distributions
OF = {ISOTROPIC: "an isotropic source", CONICAL: "a uniform cone", LOBED: "a cosine-power lobe"}
ASSUMED = {
    ISOTROPIC: "isotropic: the same intensity in all directions",
    CONICAL: "the same intensity everywhere in the cone, none outside",
    LOBED: "intensity I0 cos^n(theta) from the axis; I0 is the intensity given here",
}
ON_AXIS = "the receiver is on the source's axis"
# What a remark on the place of a receiver, or on its turn, is on.
ON_RECEIVER = ("irradiance", "exposure", "incidence", "cosine", "received-solid-angle")
# What a remark on the direction of a receiver from the source is on.
ON_DIRECTION = ("height", "lateral", "off-axis", "relative-intensity", *ON_RECEIVER)
LYING = "the receiver lies in a plane perpendicular to the source's axis"
TURNED = "the receiver is turned to that incidence"


def lies_at_incidence(given: Inputs) -> bool:
    """Return whether an incidence places a receiver that lies flat: no other input does."""
    if "incidence" not in given or "height" not in given:
        return False
    if not given.keys().isdisjoint(("distance", *OFFSETS)):
        return False
    is_above = not any_true(angle_of(given, "incidence") >= math.pi / 2)
    require(given["incidence"], is_above, "less than 90 deg for a receiver that lies flat")
    return True


def place_at_incidence(given: Inputs, placed: Placed, lying: str = LYING) -> None:
    """Add the law and the meaning of an incidence below a source."""
    if lies_at_incidence(given):
        placed.laws.append(ASIDE)
        angle = errors.mention("{incidence} is the light's angle to its normal")
        placed.assume(f"{lying}, and {angle}", of=ON_DIRECTION)
    else:
        placed.assume(TURNED, of=ON_RECEIVER)


def place_incidence(given: Inputs, placed: Placed) -> None:
    """Add an incidence that is given."""
    if "incidence" in given:
        placed.add("incidence", angle_of(given, "incidence"), given["incidence"])


def place_offsets(given: Inputs, placed: Placed) -> bool:
    """Add the distance from the axis of offsets that are given; return whether there are any."""
    offsets = [given[name] for name in OFFSETS if name in given]
    if offsets:
        placed.add("lateral", reduce(hypot, (offset.value for offset in offsets), 0.0), *offsets)
    return bool(offsets)


def require_height(solved: Solved) -> None:
    """Refuse an offset without a height."""
    if not solved.has("height"):
        offset = next(solved.given[name] for name in OFFSETS if name in solved.given)
        raise errors.MissingInput(
            f"{option(offset.name)} alone is not enough: {option('height')} is missing",
            errors.mention("{height=6m}, along the source's axis"),
        )


def solve_facing(
    sheet: Worksheet, laws: list[AnyLaw], placed: Placed, any_incidence: bool, is_flat: bool
) -> list[Solved]:
    """Return every solution; without an incidence, light arrives along the receiver's normal.

    The incidence at a flat receiver follows from its position.
    """
    known = sheet.known_with(placed)
    is_turned = is_flat or "incidence" in known
    is_lit = not known.keys().isdisjoint(("irradiance", "distance", "exposure"))
    if is_turned or any_incidence or not is_lit:
        solutions = solve_all(sheet, laws, placed)
        if is_turned or not is_lit or solutions[0].has("incidence"):
            return solutions
    facing = Placed()
    facing.merge(placed)
    facing.add("incidence", 0.0)
    facing.assume("light arrives along the receiver's normal", of=ON_RECEIVER)
    try:
        return solve_all(sheet, laws, facing)
    except errors.ConditionError as error:
        angle = _explaining_incidence(sheet, laws, placed)
        if angle is None or is_array(angle):
            raise
        turned = errors.add("incidence", f"{math.degrees(angle):.6g}deg", "would explain it")
        raise error.reworded(hint=[errors.computed(turned), *error.tries]) from None


def _explaining_incidence(sheet: Worksheet, laws: list[AnyLaw], placed: Placed) -> Any:
    try:
        solved = solve(sheet, laws, placed)
    except errors.ConditionError:
        return None
    return solved.value("incidence") if solved.has("incidence") else None


def refuse_light_of_surfaces(lit: LightInputs, takes: Sequence[str] = QUANTITIES) -> None:
    """Refuse quantities of surfaces, which a point source does not have: radiance, exitance."""
    for name, item in lit.values.items():
        if name not in takes:
            raise errors.ConditionError(
                f"{option(item.name)}: a point source has no {name}", errors.command("lambertian")
            )


def spread(given: Inputs) -> str:
    """Return the angular distribution, as chosen or as implied by its inputs."""
    chosen = given["distribution"].value if "distribution" in given else None
    shapes = {name: shape for shape, names in SHAPED.items() for name in names if name in given}
    shapes |= {name: shape for name, shape in FLAGS.items() if name in given}
    if not shapes:
        return str(chosen or ISOTROPIC)
    (first, shape), *further = shapes.items()
    for name, other in further:
        if other != shape:
            raise errors.ConditionError(
                f"{option(first)} describes {OF[shape]}, {option(name)} {OF[other]}",
                errors.one_of(first, name),
            )
    if chosen not in (None, shape):
        distribution = option("distribution", errors.quote(given["distribution"].text))
        message = f"{option(first)} cannot be used with {distribution}: it describes {OF[shape]}"
        raise errors.ConditionError(message, errors.one_of(first, "distribution"))
    return shape


def place_hemisphere(given: Inputs, placed: Placed) -> None:
    """Add the half angle of a hemisphere."""
    if "hemisphere" in given:
        placed.add("half-angle", math.pi / 2)
        placed.assume("uniform over 2 pi sr (a hemisphere)", of=["half-angle"])


def compare_mean(solved: Solved) -> None:
    """Note a mean irradiance of the receiver that differs from that at its centre."""
    mean = solved.value("received-flux") / solved.value("receiver-area")
    if not is_array(mean) and abs(solved.value("irradiance") - mean) > 0.01 * mean:
        unit = coherent_unit_of("irradiance", solved.lit.kind)
        solved.note(
            "the irradiance is that at the receiver's centre; the mean over the receiver is "
            f"{format_value(mean, unit)}",
            of=["irradiance", "received-flux"],
        )
