"""The etendue of a source with a receiver or a cone, and the flux of a radiance."""

from typing import Any

from radcalc import errors, geometry
from radcalc.answer import Answer, format_number
from radcalc.calculators.page import Page
from radcalc.calculators.results import known, value
from radcalc.calculators.solved import Solved, solve
from radcalc.calculators.worksheet import Placed, Worksheet, facing, place, worksheet
from radcalc.inputs import Inputs, angle_of, any_of, half_angle_of, one_of
from radcalc.laws import APEX, CIRCLE, CONFIGURATION_FACTOR, RECTANGLE, AnyLaw, round_sizes
from radcalc.laws import beams as laws_of
from radcalc.maths import FAINTEST, any_true, larger
from radcalc.quantities.symbols import LINKS, REFINEMENTS

CONES = ("half-angle", "apex-angle", "na", "f-number")
RECEIVERS = ("receiver-area", "receiver-radius", "receiver-diameter")
SOURCES = ("area", "radius", "diameter", "width", "length")
ROUND = ("radius", "diameter")
WITH_CONE = (*SOURCES, *CONES, "etendue")
WITH_RECEIVER = (*SOURCES, *RECEIVERS, "distance", "tilt", "incidence", "etendue")
FAR_FIELD = "A1 A2 / d^2"
ON_BOTH = ("etendue", "projected-solid-angle")  # what a remark on source and receiver is on
RESULTS = ("projected-solid-angle", "configuration-factor", "far-field-etendue")
PAGE = Page(
    "",
    (),
    ("flux", "radiance"),
    goal="etendue",
    results=RESULTS,
    about="Calculate the etendue of a beam, and its flux from the radiance of the source.",
    sections={
        "Source": (*SOURCES, "tilt"),
        "Cone of light": CONES,
        "Receiver": (*RECEIVERS, "distance", "incidence"),
        "Light": ("etendue", "radiance", "flux"),
        "Radiant, luminous and photon quantities": (*LINKS, *REFINEMENTS),
    },
    texts={"flux": "Flux of the beam."},
    examples=(
        "area=1mm2 half-angle=90deg",
        "diameter=200um na=0.22",
        "area=1mm2 f-number=1.4 get=half-angle:deg",
        "width=14.5mm length=8.2mm f-number=2.4",
        "area=1cm2 receiver-area=4cm2 distance=1m tilt=60deg",
        "radius=1m receiver-radius=1m distance=0.5m,1m,2m",
        "area=1mm2 half-angle=30deg radiance=1e6cd/m2 get=flux:lm",
        "etendue=1mm2.sr area=4mm2 get=half-angle:deg",
        "etendue=1mm2.sr flux=1W",
    ),
    remarks="Give a source and a cone, or a source and a receiver.  The etendue of two discs "
    "({radius}, {receiver-radius}) that face each other is exact; other surfaces must be small "
    "compared with their distance.  Give the sizes, etendue, flux or radiance that you know; "
    "radcalc calculates those that follow from them.",
    mistakes=("projected cone",),
)


def etendue(given: Inputs) -> Answer:
    """Return etendue, sizes, flux and radiance of a source and a cone or a receiver.

    Any sufficient set of these gives the others.
    """
    has_cone = any(name in given for name in CONES)
    has_receiver = any(name in given for name in RECEIVERS)
    has_receiver |= "distance" in given and not has_cone
    if has_receiver and has_cone:
        raise errors.ConditionError(
            "a receiver cannot be used with a cone: both limit the light",
            [
                errors.leave_out(*(name for name in CONES if name in given)),
                errors.leave_out(*(name for name in (*RECEIVERS, "distance") if name in given)),
            ],
        )
    takes = WITH_RECEIVER if has_receiver else WITH_CONE
    named = f"a source and a {'receiver' if has_receiver else 'cone'}"
    results = (*RESULTS, *(name for name in takes if name != "etendue"))
    sheet = worksheet(PAGE._replace(title=named, takes=takes, others=results), given)
    placed = place(sheet, _with_receiver if has_receiver else _with_cone)
    laws = [*placed.laws, laws_of.RADIANCE_FLUX, laws_of.PER_AREA, CONFIGURATION_FACTOR]
    solved = solve(sheet, laws, placed)
    if has_receiver:
        _refuse_near(solved)
    if not solved.has("etendue"):
        raise _unlimited(given)
    size = solved.value("etendue")
    if any_true(size == 0):
        solved.note("one of the patches is seen from its edge or from behind")
    elif any_true(size < FAINTEST):
        raise errors.NumberError("the etendue is too small for a number", "larger sizes")
    _note_far_field(solved)
    first = value("etendue", size, "m2 sr", "mm2 sr")
    if "etendue" in given:
        first = known(given["etendue"], "m2 sr", "mm2 sr")
    return solved.answer([first])


def _unlimited(given: Inputs) -> errors.MissingInput:
    if set(given) & {*CONES, *RECEIVERS}:
        sizes = "{area=1cm2}, {radius=10cm}, {diameter=20cm}, or {width=2cm} with {length=1cm}"
        return errors.MissingInput("the size of the source is missing", errors.mention(sizes))
    limits = "{half-angle}, {apex-angle}, {na}, {f-number}, or {receiver-area} (-radius, -diameter)"
    ways = [
        errors.add("half-angle"),
        errors.add("f-number"),
        errors.Try((("receiver-area", ""), ("distance", ""))),
    ]
    hint = errors.mention(limits + " with {distance}")
    return errors.MissingInput("a cone or a receiver is missing", hint, ways)


def _source(given: Inputs) -> list[AnyLaw]:
    sides, radii = ([n for n in names if n in given] for names in (("width", "length"), ROUND))
    if sides and radii:
        raise errors.Exclusive((sides[0], radii[0]), "a rectangle and a circle")
    if sides:
        return [RECTANGLE]
    return [*round_sizes(given), CIRCLE] if radii else []


def _with_cone(sheet: Worksheet) -> Placed:
    """Place a source whose points send light into a cone, given by an angle or an aperture."""
    given = sheet.given
    placed = Placed(*_source(given))
    if sheet.has("area", "radius", "diameter", "width", *CONES):
        cone = "every point of the source sends light into the same cone around the normal"
        placed.assume(cone, of=ON_BOTH)
        placed.assume("in air: the numerical aperture is the sine of the half angle", of=["na"])
    for name in ("half-angle", "apex-angle"):
        if name in given:
            half_angle_of(given[name], 90)
    angles: list[AnyLaw] = [laws_of.NUMERICAL_APERTURE, APEX]
    if "f-number" in given:
        lens = "a lens corrected for coma and focused far away: sin(alpha) = 1/(2 N)"
        placed.assume(lens, of=["f-number"])
        angles = [laws_of.F_NUMBER, *angles]
    if "na" in given:
        placed.laws += [laws_of.APERTURE, *angles]
    elif "f-number" in given:
        placed.laws += [laws_of.LENS, *angles]
    else:
        placed.laws += [*angles, laws_of.CONE]
    return placed


def _with_receiver(sheet: Worksheet) -> Placed:
    """Place a source and a receiver: two discs that face each other, or two small patches."""
    given = sheet.given
    if "etendue" not in given and not {"flux", "radiance"} <= sheet.known.keys():
        any_of(given, "the size of the receiver", *RECEIVERS)
        one_of(given, "the distance", "distance")
    tilt, incidence = angle_of(given, "tilt"), angle_of(given, "incidence")
    receiver = "receiver-radius" in given or "receiver-diameter" in given
    placed = Placed(*_source(given))
    if receiver:
        placed.laws.append(laws_of.RECEIVER_CIRCLE)
    if "receiver-diameter" in given:
        placed.laws.append(laws_of.RECEIVER_DIAMETER)
    is_disc = not {"width", "length"} & set(given) and (
        "area" not in given or {*ROUND} & set(given)
    )
    if receiver and is_disc and not tilt and not incidence:
        if CIRCLE not in placed.laws:
            placed.laws.append(CIRCLE)
        placed.assume("two discs that face each other on one axis", of=ON_BOTH)
        means = "projected solid angle and configuration factor: means over the source"
        placed.assume(means, of=["projected-solid-angle"])
        placed.laws += [laws_of.DISCS, laws_of.FAR_FIELD]
    else:
        placed.add("cosine-of-source", geometry.facing(tilt))
        placed.add("cosine", geometry.facing(incidence))
        placed.assume(*facing(given))
        placed.laws.append(laws_of.PATCHES)
    placed.use("tilt", "incidence")
    return placed


def _refuse_near(solved: Solved) -> None:
    """Refuse patches that are too near or cut by a horizon; assume small ones otherwise."""
    if not solved.has("cosine") or not solved.has("area"):
        return
    if not solved.has("receiver-area") or not solved.has("distance"):
        return
    area, other, away = (solved.value(n) for n in ("area", "receiver-area", "distance"))
    sides = [solved.value(name) for name in ("width", "length") if solved.has(name)]
    source, receiver = geometry.size(area, *sides), geometry.size(other)
    longest = larger(source, receiver)
    if geometry.is_near(away, longest):
        hint = "more distance, or {radius} and {receiver-radius} for two discs exactly"
        if {"tilt", "incidence"} & set(solved.given):
            hint = "two discs without {tilt} and {incidence}, which are exact"
        size = format_number(longest)
        raise errors.TooNear(
            solved.describe("distance"), "patches", size, errors.mention(hint), FAR_FIELD
        )
    tilt, incidence = angle_of(solved.given, "tilt"), angle_of(solved.given, "incidence")
    _refuse_cut(solved, "incidence", geometry.REACH * source)
    _refuse_cut(solved, "tilt", geometry.REACH * receiver)
    off = geometry.error(source, away, tilt, incidence, bool(sides))
    off += geometry.error(receiver, away, incidence, tilt)
    good = geometry.percent(off)
    small = f"patches small compared to their distance: A1 A2 cos cos / d^2 {good}"
    solved.assume(small, of=ON_BOTH)


def _refuse_cut(solved: Solved, name: str, reach: Any) -> None:
    """Refuse an angle at which the plane of one patch may cut the other."""
    away, angle = solved.value("distance"), angle_of(solved.given, name)
    if any_true(geometry.is_cut(reach, away, angle)):
        least = geometry.steepest(reach, away)
        raise errors.HorizonCuts(name, solved.given[name].text, least, law=FAR_FIELD)


def _note_far_field(solved: Solved) -> None:
    if solved.has("far-field-etendue"):
        ratio = solved.value("far-field-etendue") / solved.value("etendue")
        away = format_number(solved.value("distance"))
        solved.note(
            f"at {away} m the far field {FAR_FIELD} is {format_number(ratio)} times the exact one"
        )
