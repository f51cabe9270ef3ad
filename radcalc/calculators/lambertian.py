"""A source of the same radiance in all directions, or a perfectly diffuse reflector.

The radiance goes over into an irradiance by the projected solid angle under which the receiver
sees the source, which is exact at any distance; the far field is shown beside it.
"""

import math
from collections.abc import Callable

from radcalc.answer import Answer
from radcalc.calculators.light import Lit
from radcalc.calculators.shapes import OTHERWISE, POSITION, SHAPES, SIZES, cut_by_horizon
from radcalc.calculators.worksheet import Page, Worksheet
from radcalc.derivation import format_number
from radcalc.errors import (
    ConditionError,
    HorizonCuts,
    Idle,
    MissingInput,
    RadcalcError,
    TooNear,
    command,
    mention,
    option,
    quote,
)
from radcalc.geometry import far_field
from radcalc.given import Given, Inputs, angle_of, offset_of, read
from radcalc.laws.law import AnyLaw
from radcalc.laws.surface import CUT_DISC, LAWS, SURFACE_ENERGY
from radcalc.maths import acos, any_true, is_array

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
INPUTS = (*SIZES, *POSITION, "tilt", "half-angle", "reflectance", "time")
SHOWN_AS_1 = 0.9999995, 1.000005  # a ratio between these, in six digits
PAGE = Page(
    "",
    INPUTS,
    (*QUANTITIES, "far-field-irradiance"),
    (
        "reflectance",
        *SIZES,
        *POSITION,
        "tilt",
        "half-angle",
        "solid-angle",
        "projected-solid-angle",
        "configuration-factor",
        "time",
    ),
)
ENDLESS = ("plane", "hemisphere")


def lambertian(shape: str, given: Inputs) -> Answer:
    """Everything that follows for a Lambertian source of a shape of `SHAPES`.

    `given` are light quantities by whichever name, sizes, the receiver's place, and what links
    the kinds.
    """
    try:
        return _answer(shape, SHAPES[shape].place, given)
    except (TooNear, HorizonCuts) as error:
        error.hint = _exact_call(given) or error.hint
        raise
    except Idle as error:
        received = [one.text for one in given.values() if one.symbol.generic == "irradiance"]
        if received and "reflectance" in given:
            incident = option("incident-irradiance", quote(received[0]))
            error.hint = f"{incident} for what falls on the reflector; {error.hint}"
        raise
    except ConditionError as error:
        told, place = OTHERWISE.get(shape, (given, None))
        if place is None or set(told) & set(given):
            raise
        try:
            return _answer(shape, place, given)
        except RadcalcError:
            raise error from None


def _answer(shape: str, place: Callable[[Worksheet], list[AnyLaw]], given: Inputs) -> Answer:
    """What follows; a small patch that is near is refused."""
    takes = (*SHAPES[shape].takes, "reflectance", "time")
    sheet = Worksheet(PAGE._replace(title=f"a {shape}", takes=takes), given)
    _refuse_dark(given, sheet.lit)
    if shape in ENDLESS:
        _refuse_whole(shape, sheet.lit)
    laws = [*LAWS, *sheet.place(place)]
    if "time" not in given:
        laws.append(SURFACE_ENERGY)
    sheet.assume("Lambertian: the same radiance in all directions")
    sheet.page = sheet.page._replace(takes=INPUTS)  # what another shape would take may be lacking
    sheet.solve(laws)
    if shape == "patch":
        _refuse_near(sheet)
    answers = []
    for one in sheet.each():
        _judge(one)
        answers.append(one.answer(laws))
    return answers[0]._replace(more=tuple(answers[1:]))


def _refuse_dark(given: Inputs, lit: Lit) -> None:
    """Refuse to begin without any light."""
    hint = mention("{radiance}, {exitance}, {flux} ...")
    if not lit.values and ({"reflectance", "time"} & set(given) or lit.links):
        raise MissingInput("a light quantity is missing", hint)
    if not given:
        raise MissingInput("nothing is given", hint)


def _refuse_whole(shape: str, lit: Lit) -> None:
    """Refuse what an endless source has no end of."""
    for name in ("flux", "energy", "intensity"):
        if name in lit.values:
            raise ConditionError(
                f"{option(lit.values[name].name)}: a {shape} has no end, and no {name} of its own",
                mention("{radiance}, {exitance} or {irradiance} in its place"),
            )


def _judge(sheet: Worksheet) -> None:
    """Refuse what no Lambertian source does; say how far the far field is off."""
    sheet.refuse_impossible(
        "projected-solid-angle",
        because="that is more irradiance than a source of that radiance gives, though it filled "
        "all that the receiver sees",
        hint="at most pi times the radiance",
    )
    sheet.refuse_impossible(
        "reflectance",
        because="more light leaves the reflector than reaches it",
        hint="less radiance, or more incident irradiance",
    )
    if sheet.has("far-field-irradiance") and sheet.has("irradiance") and sheet.has("extent"):
        far, exact = sheet.at("far-field-irradiance"), sheet.at("irradiance")
        if is_array(far) or is_array(exact) or not exact:
            return
        nearest = far_field.FAR * sheet.known["extent"].value
        times = far / exact
        if SHOWN_AS_1[0] <= times <= SHOWN_AS_1[1]:
            return
        times = f"gives {format_number(times)} times that" if far else "gives no light"
        said = f"the inverse square law, from the centre, {times}"
        if far and sheet.at("distance") < nearest:
            said += f"; it is for {format_number(nearest)} m and more, five times the size"
        sheet.notes.append(said)


def _exact_call(given: Inputs) -> str:
    """The call that is exact where that of a small patch is not; empty where there is none."""
    if any(is_array(one.value) for one in given.values()):
        return ""
    inputs = {name: one for name, one in given.items() if name not in ("area", "tilt", "offset-y")}
    sides = {"width", "length"} & set(given)
    shape = "rectangle" if sides else "disc"
    if sides:
        inputs |= {"offset-y": given["offset-y"]} if "offset-y" in given else {}
        if "area" in given and len(sides) == 1:
            (other,) = {"width", "length"} - sides
            inputs[other] = _length(other, given["area"].value / given[next(iter(sides))].value)
    else:
        if "area" in given:
            inputs["radius"] = _length("radius", (given["area"].value / math.pi) ** 0.5)
        if "offset-y" in given:
            aside = math.hypot(offset_of(given), given["offset-y"].value)
            inputs["offset"] = _length("offset", aside)
    if "tilt" in given:
        if sides or "incidence" in given or "distance" not in given:
            return ""  # which does not say about which axis
        away, tilt = inputs.pop("distance").value, given["tilt"].value
        inputs["height"] = _length("height", away * math.cos(tilt))
        inputs["offset"] = _length("offset", away * math.sin(tilt))
        inputs["incidence"] = read("incidence", "0deg")
    try:
        lambertian(shape, inputs)
    except RadcalcError:
        return ""
    texts = {name: quote(one.text) for name, one in inputs.items()}
    circle = ", for a circle" if "area" in given and not sides else ""
    return f"{command('lambertian', shape, **texts)}{circle}, which is exact"


def _length(name: str, size: float) -> Given:
    return read(name, f"{format_number(size)}m")


def _refuse_near(sheet: Worksheet) -> None:
    """Refuse a patch for which the far field does not hold, however it was found; else say so."""
    if not sheet.has("distance"):
        return
    if not sheet.has("area"):
        sheet.assume("a source small beside its distance")
        return
    away = sheet.at("distance")
    sides = [sheet.at(name) for name in ("width", "length") if sheet.has(name)]
    longest = far_field.size(sheet.at("area"), *sides)
    if far_field.is_near(away, longest):
        size = format_number(longest)
        raise TooNear(sheet.told("distance"), "source", size, far_field.MORE_ROOM)
    if CUT_DISC in (law for law, _ in sheet.solution.used):
        return
    tilt, incidence = angle_of(sheet.given, "tilt"), angle_of(sheet.given, "incidence")
    reach = sheet.at("radius") if sheet.has("radius") else far_field.REACH * longest
    if any_true(far_field.is_cut(reach, away, incidence)):
        raise cut_by_horizon(sheet.given, reach, away)
    if "height" in sheet.given:
        tilt = acos(sheet.at("cosine-of-source"))
        if "incidence" not in sheet.given:  # the planes are parallel: neither cuts the other
            incidence = tilt
    good = far_field.percent(far_field.error(longest, away, tilt, incidence, bool(sides)))
    sheet.assume(f"a source small beside its distance: the inverse square law is {good}")
