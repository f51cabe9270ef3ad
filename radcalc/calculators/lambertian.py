"""A Lambertian source or reflector: the same radiance in all directions.

The irradiance is the radiance times the projected solid angle of the source at the receiver, which
is exact at any distance.  The far-field irradiance is given for comparison.
"""

import math
from collections.abc import Callable, Sequence
from functools import partial

from radcalc import errors, geometry
from radcalc.answer import Answer, Remark, format_number, texts_of
from radcalc.calculators.kinds import LightInputs
from radcalc.calculators.page import Operand, Page
from radcalc.calculators.shapes import (
    ON_RECEIVER,
    OTHERWISE,
    POSITION,
    SHAPES,
    SIZES,
    cut_by_horizon,
)
from radcalc.calculators.solved import Solved, Task, Wants, solve_all
from radcalc.calculators.worksheet import Placed, Worksheet, place, worksheet
from radcalc.errors import command, option, quote
from radcalc.inputs import Input, Inputs, angle_of, offset_of, split_by_light
from radcalc.inputs.reading import read
from radcalc.laws.surface import CUT_DISC, LAWS, SURFACE_ENERGY
from radcalc.maths import Number, acos, any_true, chosen, is_array, piecewise
from radcalc.quantities.symbols import CHOICE, LINKS, REFINEMENTS

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
SHOWN_AS_1 = 0.9999995, 1.000005  # ratios in between print as 1 with six digits
OPERAND = Operand("shape", "[SHAPE]", CHOICE, tuple(SHAPES), "patch")
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
    about="Calculate the luminance, illuminance or size of a diffuse source or reflector.",
    operand=OPERAND,
    sections={
        "Light": (*QUANTITIES, "reflectance", "time"),
        "Source": ("area", "radius", "diameter", "width", "length", "tilt", "half-angle"),
        "Receiver": (
            "distance",
            "height",
            "offset",
            "offset-y",
            "corner",
            "incidence",
            "perpendicular",
        ),
        "Radiant, luminous and photon quantities": (*LINKS, *REFINEMENTS),
    },
    texts={"half-angle": "Half angle of the luminous part of a hemisphere, around its zenith."},
    draws=True,
    examples=(
        "radiance=2.0e7W/m2/sr",
        "luminance=100cd/m2 area=0.1m2",
        "luminance=3000cd/m2 area=100cm2 height=2m offset=1m",
        "incident-illuminance=500lx reflectance=0.8",
        "disc luminance=1e4cd/m2 radius=25cm height=75cm offset=10cm",
        "disc radius=25cm distance=75cm illuminance=70lx get=exitance:lm/m2",
        "disc luminance=1e4cd/m2 radius=25cm offset=50cm illuminance=1klx",
        "hemisphere luminance=3000cd/m2 illuminance=5000lx",
        "sphere luminance=2e4cd/m2 radius=6cm distance=1m:5m:1m",
        "disc luminance=1e4cd/m2 radius=25cm distance=0.1m:5m:0.1m plot=",
        "rectangle luminance=3000cd/m2 width=1m length=2m height=1.5m corner= perpendicular=",
        "hemisphere luminance=3000cd/m2 incidence=30deg",
    ),
    remarks="""
    \b
    SHAPE is one of:
      patch (default)  a small flat surface: {area} or another size, with {distance} (optionally
                       {tilt}, {incidence}), or with {height} and {offset}; name the shape
                       with a {radius} or {diameter}
      disc             {radius} or {diameter}; {height} (or, on the axis, {distance}); optionally
                       {offset}
      sphere           {radius} or {diameter}, and {distance} to its centre
      rectangle        {width}, {length} and {height}; optionally {offset} and {offset-y}, or
                       {corner}
      plane            infinite
      hemisphere       a uniform sky, or a cone of it ({half-angle}); radcalc sky has other
                       skies

    \b
        source  ___________ length
               |     |
        height |     | axis
               |     |
          (1) _^_    |  (2) |>
            receiver

    The results are exact at any distance; only a patch must be small compared with its distance.

    The receiver faces the source's plane, as in (1).  {incidence} is the angle between the
    receiver's normal and the line to the source's centre; a positive angle turns the normal away
    from the axis.  With {perpendicular} the receiver's normal is parallel to the rectangle's length
    and points towards the rectangle's centre, as in (2).

    'Irradiance' is that on the receiver; 'incident irradiance' is that on the reflector.
    """,
    mistakes=("flat source", "projected cone"),
)
# What needs the same radiance in all directions.
EVEN = (
    *("radiance", "intensity", "irradiance", "exposure", "far-field-irradiance"),
    "configuration-factor",
)
ENDLESS = ("plane", "hemisphere")
ON_SHAPE = ("area", "flux", "energy", "intensity", "irradiance", "exposure")  # depend on the shape
ONE_SIDE = "a flat surface that emits on one side (a patch)"  # assumed without a shape


def task(words: Sequence[str], wants: Wants) -> Task:
    """Return the task of a call, whose only word may be a shape."""
    shape, *more_words = words or [OPERAND.default]
    if shape.lower() not in SHAPES:
        takes = {name: known.takes for name, known in SHAPES.items()}
        return Task("lambertian", partial(OPERAND.refuse, shape, takes))
    shape = OPERAND.choice(shape)
    if more_words:
        ways = [errors.correct(word) for word in words[::-1]]
        raise errors.UsageError(f"unexpected argument '{quote(more_words[0])}'", "one shape", ways)
    work_out = partial(lambertian, shape if words else "")
    return Task("lambertian", work_out, texts_of({"shape": shape}), shape)


def lambertian(shape: str, given: Inputs) -> Answer:
    """Return the answer for a Lambertian source of a shape of `SHAPES`.

    Without a shape (''), the source is a patch, unless its size may be that of a sphere.
    """
    if not shape:
        _refuse_round(given)
    try:
        return _answer(shape, SHAPES[shape or OPERAND.default].place, given)
    except (errors.TooNear, errors.HorizonCuts) as error:
        raise error.reworded(hint=_exact_call(given)) from None
    except errors.Idle as error:
        received = [item.text for item in given.values() if item.symbol.generic == "irradiance"]
        if not received or "reflectance" not in given:
            raise
        incident = option("incident-irradiance", quote(received[0]))
        hint = f"{incident} for the light on the reflector; {error.hint}"
        raise error.reworded(hint=hint) from None
    except errors.ConditionError as error:
        without, other_way = OTHERWISE.get(shape, ((), None))
        if other_way is None or set(without) & set(given):
            raise
        try:
            return _answer(shape, other_way, given)
        except errors.RadcalcError:
            raise error from None


def _refuse_round(given: Inputs) -> None:
    """Refuse a radius without a shape if the other inputs fit a sphere as well as a disc."""
    sizes = [name for name in ("radius", "diameter") if name in given]
    _, _, rest = split_by_light(given)
    if sizes and {*rest} <= {*_inputs_of("sphere")}:
        ways = [errors.add(OPERAND.name, shape) for shape in ("disc", "sphere")]
        size = option(sizes[0], quote(given[sizes[0]].text))
        raise errors.MissingInput(f"the shape is missing: {size} fits a disc and a sphere", ways)


def _inputs_of(shape: str) -> tuple[str, ...]:
    return (*SHAPES[shape].takes, "reflectance", "time")


def _answer(named: str, find: Callable[[Worksheet], Placed], given: Inputs) -> Answer:
    """Return the solutions for a shape that `find` places; without a name, for the default one."""
    shape = named or OPERAND.default
    sheet = worksheet(PAGE._replace(title=f"a {shape}"), given, accepts=_inputs_of(shape))
    _refuse_dark(given, sheet.lit)
    if shape in ENDLESS:
        _refuse_whole(shape, sheet.lit)
    placed = place(sheet, find)
    placed.assume("Lambertian: the same radiance in all directions", of=EVEN)
    laws = [*LAWS, *placed.laws]
    if "time" not in given:
        laws.append(SURFACE_ENERGY)
    solutions = solve_all(sheet, laws, placed)
    assumed = _check_far(solutions[0]) if shape == "patch" else ()
    answers = []
    for solved in solutions:
        solved.assume(*assumed, of=ON_RECEIVER)
        if not named and solved.has(*ON_SHAPE):
            solved.assumptions.insert(0, Remark(ONE_SIDE, ON_SHAPE))
        _judge(solved)
        answers.append(solved.answer())
    return answers[0]._replace(more=tuple(answers[1:]))


def _refuse_dark(given: Inputs, lit: LightInputs) -> None:
    hint = errors.mention("{radiance}, {exitance} or {flux}")
    if not lit.values and ({"reflectance", "time"} & set(given) or lit.links):
        raise errors.MissingInput("a light quantity is missing", hint)
    if not given:
        raise errors.MissingInput("nothing is given", hint)


def _refuse_whole(shape: str, lit: LightInputs) -> None:
    """Refuse the total flux, energy or intensity of an infinite source."""
    for name in ("flux", "energy", "intensity"):
        if name in lit.values:
            raise errors.ConditionError(
                f"{option(lit.values[name].name)}: a {shape} is infinite and has no total {name}",
                errors.mention("{radiance}, {exitance} or {irradiance} in its place"),
            )


def _judge(solved: Solved) -> None:
    """Refuse results that no Lambertian source has; note the error of the far field."""
    solved.refuse_impossible(
        "projected-solid-angle",
        because="no source of that radiance gives so much irradiance, even if it fills the whole "
        "hemisphere",
        hint="at most pi times the radiance",
    )
    solved.refuse_impossible(
        "reflectance",
        because="more light leaves the reflector than reaches it",
        hint="less radiance, or more incident irradiance",
    )
    if solved.has("far-field-irradiance") and solved.has("irradiance") and solved.has("extent"):
        far, exact = solved.value("far-field-irradiance"), solved.value("irradiance")
        _compare(solved, far, exact)


def _compare(solved: Solved, far: Number, exact: Number) -> None:
    ratio = piecewise(exact == 0, lambda f, e: 1.0 + 0.0 * e, lambda f, e: f / e, far, exact)
    differs = (ratio < SHOWN_AS_1[0]) | (ratio > SHOWN_AS_1[1])
    law = "the inverse square law, applied at the centre,"
    compared = ("irradiance", "far-field-irradiance")
    if any_true(differs & (far == 0)):
        solved.note(f"{law} would give no light", of=compared)
    nearest, away = geometry.FAR * solved.value("extent"), solved.value("distance")
    if any_true(is_near := differs & (far != 0) & (away < nearest)):
        times, least = (format_number(chosen(x, is_near)) for x in (ratio, nearest))
        validity = f"it holds from {least} m (five times the size)"
        solved.note(f"{law} would give {times} times this irradiance; {validity}", of=compared)
    if any_true(is_far := differs & (far != 0) & (away >= nearest)):
        times = format_number(chosen(ratio, is_far))
        solved.note(f"{law} would give {times} times this irradiance", of=compared)


def _exact_call(given: Inputs) -> str:
    """Return the exact call to use instead of a small patch, or an empty text."""
    if any(is_array(item.value) for item in given.values()):
        return ""
    inputs = {
        name: item for name, item in given.items() if name not in ("area", "tilt", "offset-y")
    }
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
            offset = math.hypot(offset_of(given), given["offset-y"].value)
            inputs["offset"] = _length("offset", offset)
    if "tilt" in given:
        if sides or "incidence" in given or "distance" not in given:
            return ""  # the axis of the tilt is not known
        away, tilt = inputs.pop("distance").value, given["tilt"].value
        inputs["height"] = _length("height", away * math.cos(tilt))
        inputs["offset"] = _length("offset", away * math.sin(tilt))
        inputs["incidence"] = read("incidence", "0deg")
    try:
        lambertian(shape, inputs)
    except errors.RadcalcError:
        return ""
    texts = {name: quote(item.text) for name, item in inputs.items()}
    circle = " if the patch is a circle" if "area" in given and not sides else ""
    return f"{command('lambertian', shape, **texts)}, exact{circle}"


def _length(name: str, size: float) -> Input:
    return read(name, f"{format_number(size)}m")


def _check_far(solved: Solved) -> tuple[str, ...]:
    """Refuse a patch too near or cut by the horizon; return the assumption that it is small."""
    if not solved.has("distance"):
        return ()
    if not solved.has("area"):
        return ("a source small compared to its distance",)
    away = solved.value("distance")
    sides = [solved.value(name) for name in ("width", "length") if solved.has(name)]
    longest = geometry.size(solved.value("area"), *sides)
    if geometry.is_near(away, longest):
        size = format_number(longest)
        raise errors.TooNear(solved.describe("distance"), "source", size, geometry.MORE_ROOM)
    if CUT_DISC in (law for law, _ in solved.solution.used):
        return ()
    given = solved.given
    tilt, incidence = angle_of(given, "tilt"), angle_of(given, "incidence")
    reach = solved.value("radius") if solved.has("radius") else geometry.REACH * longest
    if any_true(geometry.is_cut(reach, away, incidence)):
        raise cut_by_horizon(given, reach, away)
    if "height" in given:
        tilt = acos(solved.value("cosine-of-source"))
        if "incidence" not in given:  # parallel planes do not cut each other
            incidence = tilt
    good = geometry.percent(geometry.error(longest, away, tilt, incidence, bool(sides)))
    return (f"a source small compared to its distance: the inverse square law {good}",)
