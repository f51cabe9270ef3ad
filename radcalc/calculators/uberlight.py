"""The cinematographer's light: how it is attenuated at a point, and what arrives there.

The light stands at the origin; a spot shines along +z.  With an inverse square in place of its
own fall-off, and nothing else to attenuate it, its irradiance is that of its intensity; at the
fall-off distance L both agree, so that E = I a / L^2.
"""

from typing import Any

from radcalc.answer import Answer, Step
from radcalc.calculators.results import value
from radcalc.calculators.worksheet import FARTHEST, Page, Worksheet
from radcalc.derivation import Formula, format_number, format_value
from radcalc.errors import (
    ConditionError,
    Exclusive,
    Idle,
    Unused,
    mention,
    option,
    options,
    quote,
)
from radcalc.geometry import uberlight as attenuations
from radcalc.geometry.numerics.vectors import cross, dot, length, times, unit
from radcalc.given import IN_METRES, Inputs, angle_of
from radcalc.laws.law import AnyLaw, law
from radcalc.laws.point import COSINE
from radcalc.maths import Number, any_true, atan2, hypot, is_array, log
from radcalc.quantities.symbols import SYMBOLS
from radcalc.units.dimensions import LENGTH

BARZEL = "R. Barzel, J. Graphics Tools 2(1) (1997) 1; the formulas are L. Gritz's, uberlight.sl"
PARTS = ("depth", "superellipse", "beam", "falloff")
OF_SPOTS = ("beam-exponent", "superellipse", "roundness", "shear")
NUMBERS = ("falloff", "falloff-distance", "maximum", "beam-exponent", "roundness")
NEAREST = 1e-100  # [m] to the light
HARDLY_ROUND = 1e-9  # a roundness next to 0
LAWS: list[AnyLaw] = [
    COSINE,
    law(
        "attenuation",
        "{attenuation} = " + " ".join(f"{{{part}-attenuation}}" for part in PARTS),
        BARZEL,
    ),
    law(
        "irradiance of an attenuated light",
        "{irradiance} = {intensity} {attenuation} {cosine} Omega0 / {falloff-distance}^2",
    ),
    law(
        "intensity that an inverse square would take",
        "{intensity-toward} = {intensity} {attenuation} {distance}^2 / {falloff-distance}^2",
    ),
]
PAGE = Page(
    "a spot",
    (
        *("intensity", "irradiance", "point", "omni", "near", "far"),
        *(*NUMBERS, "superellipse", "shear", "normal", "incidence"),
    ),
    ("intensity", "irradiance", "intensity-toward"),
    (
        "attenuation",
        *(f"{part}-attenuation" for part in PARTS),
        "distance",
        "incidence",
        *NUMBERS,
    ),
    goal="attenuation",
)
SMOOTHSTEP = Step(
    "smooth step",
    "smoothstep(a, b, x) = t^2 (3 - 2 t), t = (x - a) / (b - a)",
    "0 where x < a, 1 from b on",
    BARZEL,
)
FRONT = Formula("depth clip", "{depth-attenuation} = 1 where z > 0, else 0", BARZEL)
SUPERELLIPSE = Formula(
    "superellipse",
    "{superellipse-attenuation} = 1 - smoothstep(q, r, 1), "
    "q = a b / ((b u)^(2/{roundness}) + (a v)^(2/{roundness}))^({roundness}/2), r so of A and B, "
    "u = |x/z - X|, v = |y/z - Y|",
    BARZEL,
)
RECTANGLE = Formula(
    "rectangle",
    "{superellipse-attenuation} = (1 - smoothstep(a, A, u)) (1 - smoothstep(b, B, v)), "
    "u = |x/z - X|, v = |y/z - Y|",
    BARZEL,
)
BEAM = Formula("beam", "{beam-attenuation} = (z / {distance})^{beam-exponent}", BARZEL)
FALLOFF = Formula(
    "fall-off",
    "{falloff-attenuation} = ({falloff-distance} / {distance})^{falloff}",
    BARZEL,
)
HELD = Formula(
    "fall-off, held to its maximum",
    "{falloff-attenuation} = {maximum} exp(s ({distance} / {falloff-distance})^beta), "
    "s = ln(1/{maximum}), beta = -{falloff} / s",
    BARZEL,
)
WITHIN = Formula(
    "fall-off, held to a maximum of 1", "{falloff-attenuation} = 1 within {falloff-distance}"
)


def uberlight(given: Inputs) -> Answer:
    """What a cinematographer's light sends to a point.

    `given` are the point, the settings of the light, its intensity or the irradiance that it
    gives, how the receiver is turned, and what links the kinds.
    """
    is_omni = "omni" in given
    _refuse_useless(given, is_omni)
    sheet = Worksheet(PAGE, given)
    sheet.defaults.add("incidence")
    x, y, z = sheet.given["point"].value
    distance = hypot(hypot(x, y), z)
    if any_true(distance < NEAREST):
        raise ConditionError("the point is at the light", "a point aside of it")
    sheet.know("distance", distance)
    _assume(sheet, is_omni)
    ratio = distance / sheet.known["falloff-distance"].value
    if any_true((ratio > FARTHEST) | (ratio < 1 / FARTHEST)):
        raise ConditionError(
            mention(
                "the point's distance beside {falloff-distance} is beyond what radcalc reckons with"
            ),
            "less extreme values",
        )
    _turn_receiver(sheet)
    sheet.place(_attenuate)
    sheet.solve(LAWS)
    _judge(sheet)
    places = zip("xyz", (x, y, z), strict=True)
    first = [
        value(name, size, "m", label=name)._replace(dimensions=(LENGTH,), given=size)
        for name, size in places
    ]
    return sheet.answer(LAWS, first)


def _refuse_useless(given: Inputs, is_omni: bool) -> None:
    """Refuse settings that others leave without use, and those that cannot be."""
    useless = [name for name in OF_SPOTS if name in given]
    if is_omni and useless:
        raise Unused(
            useless, "with a light that shines everywhere", mention("the same without {omni}")
        )
    if "superellipse" not in given:
        useless = [name for name in ("roundness", "shear") if name in given]
        if useless:
            hint = option("superellipse", SYMBOLS["superellipse"].example)
            raise Unused(useless, mention("without {superellipse}"), hint)
        return
    one = given["superellipse"]
    a, b, outer_a, outer_b = one.value
    told = f"{option('superellipse', quote(one.text))}, a,b,A,B,"
    if min(a, b) < NEAREST:
        raise ConditionError(
            f"{told} has no inside",
            mention("a and b above 0, as in {superellipse=0.4,0.3,0.5,0.4}"),
        )
    if a > outer_a or b > outer_b:
        texts = [format_number(size) for size in (*_sorted(a, outer_a), *_sorted(b, outer_b))]
        turned = ",".join(texts[i] for i in (0, 2, 1, 3))
        raise ConditionError(
            f"{told} is larger inside than outside", option("superellipse", turned)
        )


def _sorted(one: float, other: float) -> tuple[float, float]:
    return min(one, other), max(one, other)


def _assume(sheet: Worksheet, is_omni: bool) -> None:
    """Enter what goes without saying, and say it."""
    given = sheet.given
    aim = "shines everywhere" if is_omni else "shines along +z"
    sheet.assume(f"the light is at 0,0,0 and {aim}")
    if given["point"].unit is None:
        sheet.assume(IN_METRES)
    if "falloff" not in given:
        sheet.know("falloff", 2.0)
        sheet.assume(mention("the inverse square, a fall-off of 2 ({falloff})"))
    if "falloff-distance" not in given:
        sheet.know("falloff-distance", 1.0)
        sheet.assume(mention("a fall-off distance of 1 m ({falloff-distance})"))
    if "superellipse" in given and "roundness" not in given:
        sheet.know("roundness", 1.0)
        sheet.assume(mention("an ellipse, with a roundness of 1 ({roundness})"))
    if sheet.lit.values:
        sheet.assume("the full light has the irradiance I / L^2 at the fall-off distance")


def _turn_receiver(sheet: Worksheet) -> None:
    """Enter the incidence, of which the normal may tell."""
    given = sheet.given
    if "normal" in given and "incidence" in given:
        raise Exclusive(("normal", "incidence"), "both give the incidence")
    if "incidence" in given:
        sheet.know("incidence", angle_of(given, "incidence"), given["incidence"])
    elif "normal" in given:
        if not sheet.lit.values:
            raise Idle(
                f"nothing follows from {option('normal', given['normal'].text)}",
                f"with it, {options(('intensity', 'irradiance'))}",
            )
        normal = unit(given["normal"].value)
        to_light = times(given["point"].value, -1 / sheet.known["distance"].value)
        across = length(cross(normal, to_light))
        sheet.know("incidence", atan2(across, dot(normal, to_light)))
    elif sheet.lit.values:
        sheet.know("incidence", 0.0)
        sheet.assume("the receiver faces the light")


def _attenuate(sheet: Worksheet) -> None:
    """Enter the four attenuations, which are no laws, with a step each."""
    sheet.use(*NUMBERS)
    if {"near", "far", "superellipse"} & set(sheet.given):
        sheet.placed.append(SMOOTHSTEP)
    _by_depth(sheet)
    _by_superellipse(sheet)
    _by_beam(sheet)
    _by_falloff(sheet)


def _number(sheet: Worksheet, name: str) -> Any:
    """A setting: as it was given, or as it goes without saying."""
    return sheet.given[name].value if name in sheet.given else sheet.known[name].value


def _by_depth(sheet: Worksheet) -> None:
    given = sheet.given
    near, far = (given[name].value if name in given else None for name in ("near", "far"))
    letter, depth = "z", given["point"].value[2]
    if "omni" in given:
        letter, depth = "d", sheet.known["distance"].value
    clip = attenuations.depth_clip(depth, near, far)
    sheet.know("depth-attenuation", clip)
    size = format_value(depth, "m")
    terms, factors = [], []
    for limits, letters, form in (
        (near, "A, B", "smoothstep({}, {})"),
        (far, "C, D", "(1 - smoothstep({}, {}))"),
    ):
        if limits:
            terms.append(form.format(letters, letter))
            factors.append(form.format(", ".join(format_value(one, "m") for one in limits), size))
    if terms:
        formula = Formula("depth clip", f"{{depth-attenuation}} = {' '.join(terms)}", BARZEL)
        sheet.placed.append(formula.told(f"a_z = {' '.join(factors)} = {format_number(clip)}"))
    elif "omni" not in given:
        sheet.placed.append(FRONT.told(f"z = {size}; a_z = {format_number(clip)}"))


def _by_superellipse(sheet: Worksheet) -> None:
    """Enter the attenuation by the cross-section."""
    if "superellipse" not in sheet.given:
        sheet.know("superellipse-attenuation", 1.0)
        return
    roundness = _number(sheet, "roundness")
    clip = _clip(sheet, roundness)
    sheet.know("superellipse-attenuation", clip)
    u, v = _section(sheet)
    a, b, outer_a, outer_b = map(format_number, sheet.given["superellipse"].value)
    told = f"u = {format_number(u)}, v = {format_number(v)}; "
    formula = SUPERELLIPSE
    if not any_true(roundness > 0):
        formula = RECTANGLE
        told += f"(1 - smoothstep({a}, {outer_a}, u)) (1 - smoothstep({b}, {outer_b}, v))"
    elif any_true((u + v == 0) | (roundness == 0)):  # q and r have no end
        told += "a_s"
    else:
        q, r = (
            format_number(1 / attenuations.superellipse_scale(u, v, *sizes, roundness))
            for sizes in _sizes(sheet)
        )
        told += f"a = {a}, b = {b}: q = {q}; A = {outer_a}, B = {outer_b}: r = {r}; "
        told += f"1 - smoothstep({q}, {r}, 1)"
    sheet.placed.append(formula.told(f"{told} = {format_number(clip)}"))


def _sizes(sheet: Worksheet) -> tuple[tuple[float, float], tuple[float, float]]:
    """The half axes of the inner and of the outer superellipse."""
    a, b, outer_a, outer_b = sheet.given["superellipse"].value
    return (a, b), (outer_a, outer_b)


def _clip(sheet: Worksheet, roundness: Any) -> Any:
    x, y = _section(sheet)
    return attenuations.superellipse_clip(x, y, *_sizes(sheet), roundness)


def _section(sheet: Worksheet) -> tuple[Number, Number]:
    shear = sheet.given["shear"].value if "shear" in sheet.given else (0.0, 0.0)
    x, y, z = sheet.given["point"].value
    return attenuations.cross_section(x, y, z, shear)


def _by_beam(sheet: Worksheet) -> None:
    """Enter the attenuation by the angle off the axis."""
    if "beam-exponent" not in sheet.given:
        sheet.know("beam-attenuation", 1.0)
        return
    exponent = sheet.given["beam-exponent"].value
    x, y, z = sheet.given["point"].value
    part = attenuations.beam(x, y, z, exponent)
    sheet.know("beam-attenuation", part)
    at = {"distance": sheet.known["distance"].value, "beam-exponent": exponent}
    step = BEAM.step(at, format_number(part))
    sheet.placed.append(step._replace(numbers=f"z = {format_value(z, 'm')}; {step.numbers}"))


def _by_falloff(sheet: Worksheet) -> None:
    """Enter the attenuation by the distance."""
    at = {name: _number(sheet, name) for name in ("distance", "falloff", "falloff-distance")}
    maximum = sheet.given["maximum"].value if "maximum" in sheet.given else None
    distance, exponent, reference = at.values()
    part = attenuations.falloff(distance, exponent, reference, maximum)
    sheet.know("falloff-attenuation", part)
    found = format_number(part)
    if maximum is None or not any_true(distance < reference):
        sheet.placed.append(FALLOFF.step(at, found))
    elif any_true(maximum == 1):
        sheet.placed.append(WITHIN.step(at, found))
    else:
        s = -log(maximum)
        told = f"s = {format_number(s)}, beta = {format_number(-exponent / s)}; "
        step = HELD.step({**at, "maximum": maximum}, found)
        sheet.placed.append(step._replace(numbers=told + step.numbers))


def _judge(sheet: Worksheet) -> None:
    """Say what is no physics, and why a point is dark."""
    given = sheet.given
    if "near" in given:
        sheet.notes.append(
            mention("{near} is no physics: dark up to A and lit from B on, light is created")
        )
    if "far" in given:
        sheet.notes.append(
            mention("{far} is no physics: nothing stops the light between C and D, and it is lost")
        )
    _judge_falloff(sheet)
    shaping = ["superellipse"] if "superellipse" in given else []
    if "beam-exponent" in given and any_true(given["beam-exponent"].value > 0):
        shaping.append("beam-exponent")
    if shaping:
        sheet.notes.append(
            f"{options(shaping, ' and ')} only shape{'s' if len(shaping) == 1 else ''} the "
            "directions: the fall-off along each is kept, and the flux is less than 4 pi times the "
            "intensity"
        )
    _judge_corner(sheet)
    _judge_dark(sheet)


def _judge_falloff(sheet: Worksheet) -> None:
    """Compare the fall-off with an inverse square from the same intensity."""
    distance, reference = sheet.known["distance"].value, sheet.known["falloff-distance"].value
    exponent = _number(sheet, "falloff")
    breaking = []
    if any_true(exponent != 2):
        breaking.append(option("falloff", format_number(exponent)))
    if "maximum" in sheet.given and any_true(distance < reference):
        breaking.append(option("maximum", quote(sheet.given["maximum"].text)))
    if not breaking:
        return
    several = len(breaking) > 1
    told = f"{' and '.join(breaking)} {'are' if several else 'is'} no inverse square"
    ratio = sheet.known["falloff-attenuation"].value * (distance / reference) ** 2
    if is_array(ratio):
        told += ": light is created or lost"
    elif abs(ratio - 1) > 1e-9:
        told += (
            f": {'they give' if several else 'it gives'} {format_number(ratio)} times the light "
            f"of one here, so light is {'created' if ratio > 1 else 'lost'}"
        )
    sheet.notes.append(told)


def _judge_corner(sheet: Worksheet) -> None:
    """Say what a hair of roundness would make of a rectangle's soft edge."""
    if "superellipse" not in sheet.given or not any_true(_number(sheet, "roundness") == 0):
        return
    clip = sheet.known["superellipse-attenuation"].value
    rounded = _clip(sheet, HARDLY_ROUND)
    if any_true(abs(rounded - clip) > 1e-12):
        told = "" if is_array(rounded) else f" and gives {format_number(rounded)} here"
        sheet.notes.append(
            mention(
                "{roundness} of 0 multiplies the steps of x and y, as the published shader does; "
                f"just above 0 the formula for rounded corners is another{told}"
            )
        )


def _judge_dark(sheet: Worksheet) -> None:
    """Say why no light arrives."""
    known, z = sheet.known, sheet.given["point"].value[2]
    if "omni" not in sheet.given and any_true(z <= 0):
        sheet.notes.append("a spot has no light where z is 0 or less")
    elif any_true(known["depth-attenuation"].value == 0):
        limits = [name for name in ("near", "far") if name in sheet.given]
        sheet.notes.append(f"no light: the point is outside {options(limits, ' and ')}")
    elif any_true(known["superellipse-attenuation"].value == 0):
        sheet.notes.append(mention("no light: the point is outside {superellipse}"))
    sheet.note_behind()
