"""A point source: flux, intensity (on the axis), irradiance, and the position of a receiver."""

import math
from collections.abc import Sequence
from functools import partial

from radcalc import geometry
from radcalc.answer import Answer, coherent_unit_of, format_number, format_value
from radcalc.calculators.page import Page
from radcalc.calculators.point_laws import (
    ASSUMED,
    CONE,
    DIRECTED,
    FLAGS,
    LOBE,
    LYING,
    ON_AXIS,
    ON_DIRECTION,
    ON_RECEIVER,
    POSITION,
    QUANTITIES,
    RECEIVER,
    SHAPED,
    compare_mean,
    lies_at_incidence,
    place_at_incidence,
    place_hemisphere,
    place_incidence,
    place_offsets,
    refuse_light_of_surfaces,
    require_height,
    solve_facing,
    spread,
)
from radcalc.calculators.solved import Solved, Task, Wants, solve
from radcalc.calculators.worksheet import OFFSETS, Placed, Worksheet, worksheet
from radcalc.errors import ConditionError, Contradiction, MissingInput, RadcalcError, add, mention
from radcalc.inputs import Inputs
from radcalc.laws import OFFSET, AnyLaw
from radcalc.laws.point import (
    ANY_LAWS,
    AXIS,
    CONICAL,
    COSINE_BELOW,
    ENERGIES,
    FALL,
    FALL_BELOW,
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
    RECEIVERS,
    SPOT,
    WIDTHS,
    beam_of_cone,
    beam_of_lobe,
)
from radcalc.laws.solver import reached
from radcalc.laws.solver import solve as follow
from radcalc.maths import any_true, is_array, power
from radcalc.quantities.symbols import LINKS, REFINEMENTS

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
    ("beam-diameter",),
    results=("off-axis", "luminous-efficacy"),
    about="Calculate the intensity, illuminance, distance or beam of a small source of light.",
    sections={
        "Light": (*QUANTITIES, "peak-intensity"),
        "Directions": (
            "distribution",
            "isotropic",
            "hemisphere",
            "half-angle",
            "apex-angle",
            "solid-angle",
            "exponent",
            "beam-angle",
            "field-angle",
            "within",
            "toward",
            "aim",
            "rotate",
        ),
        "Receiver": (
            "distance",
            "height",
            "offset",
            "offset-y",
            "incidence",
            "receiver-area",
            "time",
        ),
        "Radiant, luminous and photon quantities": (*LINKS, *REFINEMENTS),
    },
    texts={
        "distance": "Straight line from the source to the receiver.",
        "height": "Height of the source above the receiver's plane, along the source's axis.",
        "incidence": "Angle between the light and the receiver's normal; with {height}, but "
        "without {offset} and {distance}, it gives the position of a horizontal receiver: the "
        "offset is {height} x tan({incidence}).",
        "solid-angle": "Solid angle of a uniform cone.",
    },
    draws=True,
    like={"error": "flux"},
    examples=(
        "flux=800lm distance=2m",
        "illuminance=500lx distance=2m",
        "intensity=100cd illuminance=25lx            (distance)",
        "intensity=250cd height=6m offset=8m",
        "intensity=250cd height=6m illuminance=3lx get=offset",
        "flux=4.5klm half-angle=12.5deg distance=1m,2m,5m",
        "flux=800lm hemisphere= distance=2m",
        "intensity=1000cd beam-angle=30deg",
        "beam-angle=30deg                (exponent, field angle)",
        "half-angle=15deg height=2m get=beam-diameter",
        "luminous-flux=800lm radiant-flux=3W  (efficacy)",
        "intensity=100cd exponent=3 within=45deg get=flux-within:lm",
        "distribution=lamp.ies height=3m offset=1m",
        "flux=500lm intensity=900cd distribution=cone",
        "flux=5mW distance=1m receiver-area=1cm2 wavelength=632.8nm",
        "distribution=lamp.ies plot=                 (polar diagram)",
        "flux=800lm distance=1m:10m:0.1m plot=fall-off.svg",
        "distribution=lamp.ldt flux=3klm illuminance=50lx",
        "distribution=table.csv toward=0deg:90deg:5deg",
        "distribution='300*cos(theta)^4*(theta<90*deg) cd'",
        "distribution=lamp.ies aim=1,0,-2 rotate=90deg height=3m offset=2m",
    ),
    remarks="""
    The source may be a lamp, a spot or the file of a luminaire.  Give the quantities that you know;
    radcalc calculates those that follow from them.  Redundant quantities are checked against each
    other, to the precision of the digits typed.  The irradiance is that on the receiver.  Light is
    assumed to arrive along the receiver's normal, unless you give {incidence}, or ask for the
    angle with {get=incidence}.  With a {height} the source points straight down and the receiver is
    horizontal.  An offset, a height or an exponent can be calculated from the given quantities of
    light (such as {illuminance}); if two values fit, both are shown.

    {distribution} also takes the file of a luminaire (IES LM-63, EULUMDAT), a table of angles and
    intensities (CSV), - for standard input, or an expression with a blank and a unit at its end.
    In the expression, theta is the angle from the source's axis and phi the azimuth around it.  If
    you also give a quantity of light, such as {flux}, the intensities are scaled to match it.
    {offset} is measured towards C0, {offset-y} towards C90.

    Several sources add up (see also radcalc scene):

    \b
      for i in 100cd 250cd; do
        radcalc point-source {intensity} $i {distance} 2m -q {get=irradiance}:lx
      done | awk '{ sum += $1 } END { print sum }'
    """,
    mistakes=("beam",),
)
# The width of a distribution, solved for if no light is given.
WIDTH = {CONICAL: "half-angle", LOBED: "exponent"}
# The full angle, and the law of the beam diameter.
BEAMS = {CONICAL: ("apex-angle", beam_of_cone), LOBED: ("beam-angle", beam_of_lobe)}


def task(words: Sequence[str], wants: Wants) -> Task:
    """Return the task of a call; the incidence is solved for if it is requested."""
    return Task("point-source", partial(point_source, any_incidence=wants("incidence")))


def point_source(given: Inputs, any_incidence: bool = False) -> Answer:
    """Return the answer for a point source.

    Without a light quantity, one width of a cone or a lobe gives the others.  `any_incidence`
    solves for the incidence instead of assuming 0.  Without an offset the receiver is on the axis,
    unless the other inputs contradict that.
    """
    work_out = _answer
    shaped = "distribution" not in given or isinstance(given["distribution"].value, str)
    if not shaped or {item.symbol.generic or name for name, item in given.items()} & set(DIRECTED):
        from radcalc.calculators.luminaire import luminaire as work_out
    offsets = set(OFFSETS) & set(given)
    if "height" not in given or offsets or {"distance", "incidence"} & set(given):
        return work_out(given, bool(offsets or "height" in given), any_incidence)
    try:
        return work_out(given, False, any_incidence)
    except ConditionError as error:
        try:
            return work_out(given, True, any_incidence)
        except RadcalcError:
            raise error from None


def _answer(given: Inputs, is_aside: bool, any_incidence: bool) -> Answer:
    """Return the answer for a source of one shape, with the receiver on its axis or aside."""
    shape = spread(given)
    results = (*POSITION, "off-axis", *SHAPED[shape], "beam-diameter", *RECEIVER)
    hints = (*QUANTITIES, *SHAPED[shape], *POSITION, *RECEIVER)
    page = PAGE._replace(others=results)
    sheet = worksheet(page, given, hints=hints, defaults=("incidence",))
    refuse_light_of_surfaces(sheet.lit)
    placed = Placed(*LAWS[shape], *ANY_LAWS)
    place_hemisphere(given, placed)
    if not sheet.lit.values:
        return _width(sheet, placed, shape)
    (_place_aside if is_aside else _place_on_axis)(sheet, placed, shape)
    away = "height" if is_aside or "height" in given else "distance"
    laws = [*placed.laws, *_beam(sheet, placed, shape, away)]
    even = [*LAWS[shape], *ENERGIES, *RECEIVERS[shape]]
    if is_aside:  # the light towards the receiver is not that on the axis
        even += [INVERSE_SQUARE, INSIDE, FALL, FALL_BELOW, SPOT, *FLOOR[shape]]
    elif shape == LOBED:
        even.append(INVERSE_SQUARE)
    placed.assume(ASSUMED[shape], of=even)
    is_explicit = not given.keys().isdisjoint(("distribution", "isotropic"))
    if shape == ISOTROPIC and "intensity" in sheet.lit.values and not is_explicit:
        beam = mention("the source is taken as isotropic; for a beam, give {beam-angle}")
        placed.note(beam, of=even)
    try:
        solutions = solve_facing(sheet, laws, placed, any_incidence, FLAT in laws)
    except Contradiction as error:
        if shape != ISOTROPIC or is_explicit or not {"flux", "intensity"} <= {*sheet.lit.values}:
            raise
        cone = add("distribution", "cone", "evenly in a cone, whose width follows")
        problem = f"{error.message}, as an isotropic source"
        raise error.reworded(problem, tries=[cone, *error.tries]) from None
    if is_aside:
        require_height(solutions[0])
    for solved in solutions:
        if shape == LOBED and not is_aside and solved.has("irradiance"):
            solved.assume(ON_AXIS, of=ON_RECEIVER)
    answers = [_with_remarks(solved, shape) for solved in solutions]
    return answers[0]._replace(more=tuple(answers[1:]))


def _width(sheet: Worksheet, placed: Placed, shape: str) -> Answer:
    if sheet.lit.links or not {*SHAPED[shape], "hemisphere"} & set(sheet.given):
        hint = mention("{flux}, {intensity} or {irradiance}")
        raise MissingInput("a light quantity is missing", hint)
    away = next((name for name in ("height", "distance") if name in sheet.given), "")
    beam = _beam(sheet, placed, shape, away) if away else []
    page = sheet.page._replace(goal="beam-diameter" if beam else WIDTH[shape])
    placed.assume(ASSUMED[shape].partition(";")[0])
    solved = solve(sheet._replace(page=page), [*WIDTHS[shape], *beam], placed)
    # without a beam, the laws of light say which inputs would help
    return solved.answer(laws=None if beam else [*placed.laws, INVERSE_SQUARE])


def _beam(sheet: Worksheet, placed: Placed, shape: str, away: str) -> list[AnyLaw]:
    """Return the law of the beam diameter, if the beam's edge is in front of the source."""
    name, beam = BEAMS.get(shape, ("", None))
    try:
        width = follow(LAWS[shape], sheet.known_with(placed)).values.get(name)
    except ConditionError:  # the solution of all laws raises it
        return []
    return [beam(away)] if beam and width and not any_true(width.value >= math.pi) else []


def _with_remarks(solved: Solved, shape: str) -> Answer:
    if shape == CONICAL:
        solved.refuse_impossible("solid-angle")
    if solved.has("received-flux"):
        _judge_receiver(solved, shape)
    if "beam-angle" in solved.given and solved.has("intensity"):
        _compare_cone(solved)
    solved.note_behind()
    fall = solved.value("relative-intensity") if solved.has("relative-intensity") else 1.0
    if shape == CONICAL and any_true(fall == 0):
        reached = solved.has("received-flux") and any_true(solved.value("received-flux") > 0)
        centre = "'s centre" if reached else ""
        solved.note(f"the receiver{centre} is outside the cone")
    return solved.answer()


def _place_on_axis(sheet: Worksheet, placed: Placed, shape: str) -> None:
    """Place a receiver on the source's axis, or anywhere around an isotropic source."""
    given = sheet.given
    place_incidence(given, placed)
    placed.laws += [INVERSE_SQUARE, RECEIVER_ON_AXIS[shape]]
    if "height" in given:
        placed.add("lateral", 0.0)
        if "incidence" not in given:
            placed.add("incidence", 0.0)
            placed.assume(LYING, of=ON_RECEIVER)
    if "time" not in given:
        placed.laws.append(ISOTROPIC_ENERGY if shape == ISOTROPIC else INVERSE_SQUARE_OF_ENERGY)


def _place_aside(sheet: Worksheet, placed: Placed, shape: str) -> None:
    """Place a receiver below the source, off its axis; its height or offset may be unknown."""
    given, laws = sheet.given, placed.laws
    place_incidence(given, placed)
    laws.append(AXIS)
    if not place_offsets(given, placed):
        laws.append(OFFSET)
    is_flat = "incidence" not in given or lies_at_incidence(given)
    if "incidence" in given:
        place_at_incidence(given, placed)
    else:
        laws.append(FLAT)
        placed.assume(LYING, of=ON_RECEIVER)
    laws.append((RECEIVER_FLAT if is_flat else RECEIVER_TURNED)[shape])
    if shape == ISOTROPIC:
        laws.append(INVERSE_SQUARE)
    else:
        placed.assume("the source points straight down", of=ON_DIRECTION)
        laws += [OFF_AXIS, INSIDE if shape == CONICAL else FALL]
    if "time" not in given:
        laws.append(ISOTROPIC_ENERGY if shape == ISOTROPIC else OFF_AXIS_OF_ENERGY)
    known = reached(laws, {*sheet.known_with(placed)})
    if is_flat and not {"height", "lateral"} <= known:
        laws += FLOOR[shape]
        laws.insert(0, COSINE_BELOW)
        if shape == LOBED and "exponent" in known:
            laws[laws.index(FALL)] = FALL_BELOW
    if shape == LOBED and "exponent" not in known:
        laws.append(SPOT)
    if shape == CONICAL and "half-angle" not in known:
        placed.assume("the receiver is inside the cone", of=["relative-intensity"])
        laws.remove(INSIDE)
        placed.add("relative-intensity", 1.0)


def _compare_cone(solved: Solved) -> None:
    """Note the result for a uniform cone, which is often meant by a beam angle."""
    omega = geometry.cone(solved.value("beam-angle") / 2)
    name = "intensity" if "flux" in solved.lit.values else "flux"
    other = (
        solved.value("flux") / omega if name == "intensity" else solved.value("intensity") * omega
    )
    if not is_array(other):
        size = format_value(other, coherent_unit_of(name, solved.lit.kind))
        solved.note(f"a uniform cone of that full angle would have {size}")


def _judge_receiver(solved: Solved, shape: str) -> None:
    solved.assume("the receiver is a disc of that area", of=["received-solid-angle"])
    area, away, off = solved.value("receiver-area"), solved.value("distance"), 0.0
    if solved.has("off-axis"):
        off = solved.value("off-axis")
    if shape == LOBED and "incidence" in solved.given:
        from radcalc.geometry import receivers

        uneven = receivers.unevenness(
            solved.value("exponent"), power(area / math.pi, 0.5), away, off
        )
        varies = f"the intensity varies by {format_number(100 * uneven)} % over the receiver"
        solved.assume(varies, of=["received-solid-angle"])
    compare_mean(solved)
