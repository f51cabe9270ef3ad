"""A source that is small beside its distance: flux, intensity, irradiance, and what gives them.

The intensity is that on the source's axis.
"""

import math
from collections.abc import Sequence
from functools import reduce

from radcalc.answer import Answer
from radcalc.calculators.light import Lit
from radcalc.calculators.worksheet import OFFSETS, Page, Worksheet
from radcalc.derivation import coherent_unit_of, format_number, format_value
from radcalc.errors import (
    ConditionError,
    Exclusive,
    MissingInput,
    RadcalcError,
    command,
    mention,
    option,
    quote,
)
from radcalc.geometry import cones
from radcalc.given import Inputs, angle_of
from radcalc.laws.law import AnyLaw
from radcalc.laws.point import (
    ANY_LAWS,
    AXIS,
    CONICAL,
    FALL,
    FLAT,
    FLOOR,
    INSIDE,
    INVERSE_SQUARE,
    INVERSE_SQUARE_OF_ENERGY,
    ISOTROPIC,
    ISOTROPIC_ENERGY,
    LAWS,
    LOBED,
    OFF_AXIS,
    OFF_AXIS_OF_ENERGY,
    RECEIVER_FLAT,
    RECEIVER_ON_AXIS,
    RECEIVER_TURNED,
    SPOT,
    WIDTHS,
    beam_of_cone,
    beam_of_lobe,
)
from radcalc.laws.sizes import OFFSET
from radcalc.laws.solver import reached
from radcalc.laws.solver import solve as follow
from radcalc.maths import any_true, hypot, is_array

QUANTITIES = ("flux", "intensity", "irradiance", "exposure", "energy")
# What takes a distribution as a function of direction, and not the laws of its own shape.
DIRECTED = ("peak-intensity", "toward", "aim", "rotate")
CONE = ("half-angle", "apex-angle", "solid-angle")
LOBE = ("exponent", "beam-angle", "field-angle")
POSITION = ("distance", "height", *OFFSETS, "incidence")
RECEIVER = ("within", "time", "receiver-area")
SHAPED = {ISOTROPIC: (), CONICAL: CONE, LOBED: LOBE}
FLAGS = {"isotropic": ISOTROPIC, "hemisphere": CONICAL}  # which tell all of a distribution
OF = {ISOTROPIC: "an isotropic source", CONICAL: "a uniform cone", LOBED: "a cosine-power lobe"}
PAGE = Page(
    "a point source",
    (*QUANTITIES, *CONE, *LOBE, *POSITION, *RECEIVER, "distribution", *FLAGS),
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
# What a distribution is about where no light is given.
WIDTH = {CONICAL: "half-angle", LOBED: "exponent"}
# The angle from edge to edge, and the law of how wide that is across the axis.
BEAMS = {CONICAL: ("apex-angle", beam_of_cone), LOBED: ("beam-angle", beam_of_lobe)}
LYING = "the receiver lies flat, in a plane across the source's axis"


def point_source(given: Inputs, any_incidence: bool = False) -> Answer:
    """Everything that follows for a point source from whatever is known of it.

    Without any light, the widths of a cone or a lobe follow from one of them.  `given` are light
    quantities by whichever name, the distribution, lengths, angles, times, and what links the
    kinds.  With `any_incidence` that is looked for, and not taken to be 0.  Where
    nothing tells how far aside of the axis the receiver is, it is on it, unless the rest tells
    another place.
    """
    work_out = _answer
    shaped = "distribution" not in given or isinstance(given["distribution"].value, str)
    if not shaped or {one.symbol.generic or name for name, one in given.items()} & set(DIRECTED):
        from radcalc.calculators.luminaire import luminaire as work_out
    offsets = set(OFFSETS) & set(given)
    if "height" not in given or offsets or "distance" in given:
        return work_out(given, bool(offsets or "height" in given), any_incidence)
    try:
        return work_out(given, False, any_incidence)
    except ConditionError as error:
        try:
            return work_out(given, True, any_incidence)
        except RadcalcError:
            raise error from None


def _answer(given: Inputs, is_aside: bool, any_incidence: bool) -> Answer:
    """What follows for a receiver on the source's axis, or aside of it."""
    shape = spread(given)
    sheet = Worksheet(
        PAGE._replace(others=(*POSITION, "off-axis", *SHAPED[shape], "beam-diameter", *RECEIVER)),
        given,
    )
    sheet.takes = (*QUANTITIES, *SHAPED[shape], *POSITION, *RECEIVER)
    sheet.defaults.add("incidence")
    refuse_light_of_surfaces(sheet.lit)
    know_hemisphere(sheet)
    laws = [*LAWS[shape], *ANY_LAWS]
    if not sheet.lit.values:
        return _width(sheet, shape, [*laws, INVERSE_SQUARE])
    laws += _aside(sheet, shape, laws) if is_aside else _on_axis(sheet, shape)
    laws += _beam(sheet, shape, "height" if is_aside or "height" in sheet.given else "distance")
    sheet.assume(ASSUMED[shape])
    is_told = not given.keys().isdisjoint(("distribution", "isotropic"))
    if shape == ISOTROPIC and "intensity" in sheet.lit.values and not is_told:
        sheet.notes.append(
            mention("4 pi times the intensity is not the flux of a beam: {beam-angle} gives that")
        )
    solve(sheet, laws, any_incidence, FLAT in laws)
    if is_aside:
        require_height(sheet)
    answers = [_judged(one, shape, laws) for one in sheet.each()]
    return answers[0]._replace(more=tuple(answers[1:]))


def _width(sheet: Worksheet, shape: str, laws: list[AnyLaw]) -> Answer:
    """How wide the beam is, by any of its widths; `laws` tell what light would be of use for."""
    if sheet.lit.links or not {*SHAPED[shape], "hemisphere"} & set(sheet.given):
        hint = mention("{flux}, {intensity} or {irradiance}")
        raise MissingInput("a light quantity is missing", hint)
    away = next((name for name in ("height", "distance") if name in sheet.given), "")
    beam = _beam(sheet, shape, away) if away else []
    sheet.page = sheet.page._replace(goal="beam-diameter" if beam else WIDTH[shape])
    sheet.assume(ASSUMED[shape].partition(";")[0])
    own = [*WIDTHS[shape], *beam]
    sheet.solve(own)
    return sheet.answer(own if beam else laws)


def _beam(sheet: Worksheet, shape: str, away: str) -> list[AnyLaw]:
    """The law of how wide the light is across the axis, where its edge is ahead of the source."""
    name, beam = BEAMS.get(shape, ("", None))
    try:
        width = follow(LAWS[shape], sheet.known).values.get(name)
    except ConditionError:  # which is said where everything is solved
        return []
    return [beam(away)] if beam and width and not any_true(width.value >= math.pi) else []


def _judged(sheet: Worksheet, shape: str, laws: list[AnyLaw]) -> Answer:
    """The answer, with what is to be said of it."""
    if sheet.has("received-flux"):
        _judge_receiver(sheet, shape)
    if "beam-angle" in sheet.given and sheet.has("intensity"):
        _compare_cone(sheet)
    sheet.note_behind()
    fall = sheet.at("relative-intensity") if sheet.has("relative-intensity") else 1.0
    if shape == CONICAL and any_true(fall == 0):
        reached = sheet.has("received-flux") and any_true(sheet.at("received-flux") > 0)
        centre = "'s centre" if reached else ""
        sheet.notes.append(f"the receiver{centre} is outside the cone")
    return sheet.answer(laws)


def require_height(sheet: Worksheet) -> None:
    """Refuse an offset for which no height is given or follows."""
    if not sheet.has("height"):
        told = next(sheet.given[name] for name in OFFSETS if name in sheet.given)
        raise MissingInput(
            f"{option('height')} is missing beside {option(told.name)}",
            mention("{height=6m}, along the source's axis"),
        )


def solve(sheet: Worksheet, laws: list[AnyLaw], any_incidence: bool, is_flat: bool) -> None:
    """Work out what follows; light comes along the receiver's normal unless told otherwise.

    That of a receiver that is flat follows from its place.
    """
    told = is_flat or "incidence" in sheet.known
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


def refuse_light_of_surfaces(lit: Lit, takes: Sequence[str] = QUANTITIES) -> None:
    """Refuse what a point has not: a radiance, an exitance."""
    for name, one in lit.values.items():
        if name not in takes:
            raise ConditionError(
                f"{option(one.name)}: a point source has none", command("lambertian")
            )


def spread(given: Inputs) -> str:
    """How the light is spread: as it was chosen, or as an input of its own tells."""
    chosen = given["distribution"].value if "distribution" in given else None
    told = {name: shape for shape, names in SHAPED.items() for name in names if name in given}
    told |= {name: shape for name, shape in FLAGS.items() if name in given}
    if not told:
        return str(chosen or ISOTROPIC)
    (first, shape), *others = told.items()
    for name, other in others:
        if other != shape:
            raise ConditionError(
                f"{option(first)} is of {OF[shape]}, {option(name)} of {OF[other]}", "one of them"
            )
        if name in FLAGS:
            raise Exclusive([first, name], "contradict each other: both give the cone")
    if chosen not in (None, shape):
        raise ConditionError(
            f"{option(first)} is of {OF[shape]}, and contradicts "
            f"{option('distribution', quote(given['distribution'].text))}",
            "one of them",
        )
    return shape


def know_hemisphere(sheet: Worksheet) -> None:
    """A hemisphere is a cone of a right angle."""
    if "hemisphere" in sheet.given:
        sheet.know("half-angle", math.pi / 2)
        sheet.assume("uniform over 2 pi sr (a hemisphere)")


def _on_axis(sheet: Worksheet, shape: str) -> list[AnyLaw]:
    """The laws of a receiver somewhere on the source's axis, or about a source without one."""
    _know_incidence(sheet)
    laws: list[AnyLaw] = [INVERSE_SQUARE, RECEIVER_ON_AXIS[shape]]
    if "height" in sheet.given:
        sheet.know("lateral", 0.0)
        if "incidence" not in sheet.given:
            sheet.know("incidence", 0.0)
            sheet.assume(LYING)
    if "time" not in sheet.given:
        laws.append(ISOTROPIC_ENERGY if shape == ISOTROPIC else INVERSE_SQUARE_OF_ENERGY)
    return laws


def _aside(sheet: Worksheet, shape: str, laws: list[AnyLaw]) -> list[AnyLaw]:
    """The laws of a receiver off the source's axis, of which the place may be looked for."""
    given = sheet.given
    _know_incidence(sheet)
    own: list[AnyLaw] = [AXIS]
    lateral = [given[name] for name in OFFSETS if name in given]
    if lateral:
        sheet.know("lateral", reduce(hypot, (one.value for one in lateral), 0.0), *lateral)
    else:
        own.append(OFFSET)
    is_flat = "incidence" not in given
    if is_flat:
        own.append(FLAT)
        sheet.assume(LYING)
    own.append((RECEIVER_FLAT if is_flat else RECEIVER_TURNED)[shape])
    if shape == ISOTROPIC:
        own.append(INVERSE_SQUARE)
    else:
        sheet.assume("the source points straight down")
        own += [OFF_AXIS, INSIDE if shape == CONICAL else FALL]
    if "time" not in given:
        own.append(ISOTROPIC_ENERGY if shape == ISOTROPIC else OFF_AXIS_OF_ENERGY)
    known = reached([*laws, *own], set(sheet.known))
    if is_flat and not {"height", "lateral"} <= known:
        own += FLOOR[shape]
    if shape == LOBED and "exponent" not in known:
        own.append(SPOT)
    if shape == CONICAL and "half-angle" not in known:
        sheet.assume("the receiver is inside the cone")
        own.remove(INSIDE)
        sheet.know("relative-intensity", 1.0)
    return own


def _know_incidence(sheet: Worksheet) -> None:
    if "incidence" in sheet.given:
        sheet.know("incidence", angle_of(sheet.given, "incidence"), sheet.given["incidence"])


def _compare_cone(sheet: Worksheet) -> None:
    """Say what a uniform cone of a beam angle would give, which is often meant by it."""
    omega = cones.cone(sheet.at("beam-angle") / 2)
    name = "intensity" if "flux" in sheet.lit.values else "flux"
    other = sheet.at("flux") / omega if name == "intensity" else sheet.at("intensity") * omega
    if not is_array(other):
        size = format_value(other, coherent_unit_of(name, sheet.lit.kind))
        sheet.notes.append(f"a uniform cone of that full angle would have {size}")


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
    compare_mean(sheet)


def compare_mean(sheet: Worksheet) -> None:
    """Say where the irradiance at a receiver's centre is not its mean."""
    mean = sheet.at("received-flux") / sheet.at("receiver-area")
    if not is_array(mean) and abs(sheet.at("irradiance") - mean) > 0.01 * mean:
        unit = coherent_unit_of("irradiance", sheet.lit.kind)
        sheet.notes.append(
            "the irradiance is that at the receiver's centre; its mean over the receiver is "
            f"{format_value(mean, unit)}"
        )
