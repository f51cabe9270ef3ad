"""The cinematographer's light (uberlight): its attenuation and irradiance at a point.

The light is at the origin; a spot shines along +z.  Its irradiance is E = I a / L^2, with the
attenuation a and the fall-off distance L, where it equals that of an inverse square law.
"""

from functools import partial
from typing import Any

from radcalc.answer import Answer, Formula, Step, format_number, format_value
from radcalc.calculators.page import Operand, Page
from radcalc.calculators.results import value
from radcalc.calculators.solved import Solved, solve
from radcalc.calculators.worksheet import FARTHEST, Placed, Worksheet, place, worksheet
from radcalc.errors import ConditionError, Exclusive, Idle, Unused, mention, option, options, quote
from radcalc.geometry import models as attenuations
from radcalc.geometry.projections import cross, dot, length, times, unit
from radcalc.inputs import Inputs, angle_of
from radcalc.inputs.places import IN_METRES
from radcalc.laws import COSINE, AnyLaw, law
from radcalc.maths import Number, any_true, atan2, hypot, is_array, log, square
from radcalc.quantities.symbols import LINKS, REFINEMENTS, SYMBOLS
from radcalc.units.dimensions import LENGTH

BARZEL = "R. Barzel, J. Graphics Tools 2(1) (1997) 1; the formulas are L. Gritz's, uberlight.sl"
PARTS = ("depth", "superellipse", "beam", "falloff")
OF_SPOTS = ("beam-exponent", "superellipse", "roundness", "shear")
NUMBERS = ("falloff", "falloff-distance", "maximum", "beam-exponent", "roundness")
NEAREST = 1e-100  # [m], the shortest distance to the light
HARDLY_ROUND = 1e-9  # a roundness just above 0
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
        "intensity of an equal source with an inverse square",
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
    ("attenuation", *(f"{part}-attenuation" for part in PARTS), "distance", "incidence", *NUMBERS),
    goal="attenuation",
    results=("x", "y", "z"),
    about='Calculate the light that a cinematographer\'s light ("uberlight") sends to points.',
    operand=Operand("point", "X,Y,Z ..."),
    sections={
        "Light": ("intensity", "irradiance", "omni"),
        "Distance": ("falloff", "falloff-distance", "maximum", "near", "far"),
        "Direction of a spot": ("superellipse", "roundness", "shear", "beam-exponent"),
        "Receiver": ("normal", "incidence"),
        "Radiant, luminous and photon quantities": (*LINKS, *REFINEMENTS),
    },
    texts={"normal": "Normal of the receiver (default: towards the light)."},
    takes_lines=False,
    examples=(
        "0,0,4 intensity=1000cd",
        "0,0,4 intensity=1000cd falloff=1 falloff-distance=2m steps=",
        "0.5m,0m,2m 1m,0m,2m superellipse=0.2,0.2,0.4,0.4 roundness=0.5",
        "1,0,3 illuminance=500lx beam-exponent=8 get=intensity:cd",
        "0,0,1 0,0,1.5 0,0,9 intensity=100cd near=1m:2m far=8m:10m",
        "0.5,0,0 omni= intensity=100cd maximum=4 falloff=0,1,2",
    ),
    remarks="""
    The light is at 0,0,0.  A spot shines along +z, an {omni} light in all directions.  X,Y,Z are
    three lengths (1m,0m,2m), or bare numbers in metres.  The attenuation is the product of four
    factors: depth z ({near}, {far}), superellipse, beam and fall-off ({falloff}, {maximum}).  The
    irradiance is I a cos(theta) / L^2, with the intensity I, the attenuation a and the
    {falloff-distance} L; a fall-off of 2 is the inverse square law, for any L.  intensity-toward is
    the intensity of a source that gives the same irradiance by the inverse square law.  Notes point
    out settings that are not physical.

    The other lights of computer graphics (a spot with a power of the cosine, a spot with a cone,
    a general point source) are point sources:

    \b
      radcalc point-source {intensity} 1000cd {exponent} 20 {height} 3m {offset} 1m {steps}
      radcalc point-source {intensity} 1000cd {half-angle} 20deg {height} 3m {offset} 1m {steps}
      radcalc point-source {distribution} '(100 + 50*cos(theta)) cd' {distance} 2m {steps}
    """,
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
    "fall-off", "{falloff-attenuation} = ({falloff-distance} / {distance})^{falloff}", BARZEL
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


Settings = dict[str, Any]  # the settings and the point, by symbols


def uberlight(given: Inputs) -> Answer:
    """Return the light that a cinematographer's light sends to a point."""
    is_omni = "omni" in given
    _refuse_useless(given, is_omni)
    sheet, placed = worksheet(PAGE, given, defaults=("incidence",)), Placed()
    x, y, z = sheet.given["point"].value
    distance = hypot(hypot(x, y), z)
    if any_true(distance < NEAREST):
        raise ConditionError("the point is at the light", "another point")
    placed.add("distance", distance)
    _assume(sheet, placed, is_omni)
    settings = {name: known.value for name, known in sheet.known_with(placed).items()}
    ratio = distance / settings["falloff-distance"]
    if any_true((ratio > FARTHEST) | (ratio < 1 / FARTHEST)):
        raise ConditionError(
            mention(
                "the ratio of the point's distance to {falloff-distance} is too large or too small"
            ),
            "less extreme values",
        )
    _turn_receiver(sheet, placed)
    placed.merge(place(sheet, partial(_attenuate, settings)))
    solved = solve(sheet, LAWS, placed)
    _judge(solved)
    places = zip("xyz", (x, y, z), strict=True)
    first = [
        value(name, size, "m", label=name)._replace(dimensions=(LENGTH,), given=size)
        for name, size in places
    ]
    return solved.answer(first)


def _refuse_useless(given: Inputs, is_omni: bool) -> None:
    """Refuse inputs that do not apply, and a superellipse without area or inside out."""
    useless = [name for name in OF_SPOTS if name in given]
    if is_omni and useless:
        raise Unused(useless, "to a light that shines everywhere", mention("leave out {omni}"))
    if "superellipse" not in given:
        useless = [name for name in ("roundness", "shear") if name in given]
        if useless:
            hint = option("superellipse", SYMBOLS["superellipse"].example)
            raise Unused(useless, mention("without {superellipse}"), hint)
        return
    given_shape = given["superellipse"]
    a, b, outer_a, outer_b = given_shape.value
    option_text = f"{option('superellipse', quote(given_shape.text))}, a,b,A,B,"
    if min(a, b) < NEAREST:
        raise ConditionError(
            f"{option_text} has no area inside",
            mention("a and b above 0, as in {superellipse=0.4,0.3,0.5,0.4}"),
        )
    if a > outer_a or b > outer_b:
        texts = [format_number(size) for size in (*_sorted(a, outer_a), *_sorted(b, outer_b))]
        turned = ",".join(texts[i] for i in (0, 2, 1, 3))
        raise ConditionError(
            f"{option_text} is larger inside than outside", option("superellipse", turned)
        )


def _sorted(first: float, second: float) -> tuple[float, float]:
    return min(first, second), max(first, second)


def _assume(sheet: Worksheet, placed: Placed, is_omni: bool) -> None:
    """Add the position of the light, and the usual values of settings that are not given."""
    given = sheet.given
    aim = "shines everywhere" if is_omni else "shines along +z"
    placed.assume(f"the light is at 0,0,0 and {aim}")
    if given["point"].unit is None:
        placed.assume(IN_METRES)
    if "falloff" not in given:
        placed.add("falloff", 2.0)
        placed.assume(mention("the inverse square, a fall-off of 2 ({falloff})"))
    if "falloff-distance" not in given:
        placed.add("falloff-distance", 1.0)
        placed.assume(mention("a fall-off distance of 1 m ({falloff-distance})"))
    if "superellipse" in given and "roundness" not in given:
        placed.add("roundness", 1.0)
        placed.assume(mention("an ellipse, with a roundness of 1 ({roundness})"))
    if sheet.lit.values:
        bare = "without attenuation, the irradiance is I / L^2 at the fall-off distance"
        placed.assume(bare, of=["intensity", "irradiance"])


def _turn_receiver(sheet: Worksheet, placed: Placed) -> None:
    """Add the incidence: as given, by the normal, or 0 for a receiver that faces the light."""
    given = sheet.given
    if "normal" in given and "incidence" in given:
        raise Exclusive(("normal", "incidence"), "both give the incidence")
    if "incidence" in given:
        placed.add("incidence", angle_of(given, "incidence"), given["incidence"])
    elif "normal" in given:
        if not sheet.lit.values:
            raise Idle(
                f"{option('normal', given['normal'].text)} needs further inputs",
                f"add {options(('intensity', 'irradiance'))}",
            )
        normal = unit(given["normal"].value)
        to_light = times(given["point"].value, -1 / placed.known["distance"].value)
        across = length(cross(normal, to_light))
        placed.add("incidence", atan2(across, dot(normal, to_light)))
    elif sheet.lit.values:
        placed.add("incidence", 0.0)
        placed.assume("the receiver faces the light", of=["incidence", "irradiance"])


def _attenuate(settings: Settings, sheet: Worksheet) -> Placed:
    at = {**settings, **{name: item.value for name, item in sheet.given.items()}}
    placed = Placed()
    placed.use(*NUMBERS)
    if {"near", "far", "superellipse"} & at.keys():
        placed.steps.append(SMOOTHSTEP)
    _by_depth(at, placed)
    _by_superellipse(at, placed)
    _by_beam(at, placed)
    _by_falloff(at, placed)
    return placed


def _by_depth(at: Settings, placed: Placed) -> None:
    """Add the attenuation by depth, between near and far limits if given, with its step."""
    near, far = at.get("near"), at.get("far")
    letter, depth = ("d", at["distance"]) if "omni" in at else ("z", at["point"][2])
    clip = attenuations.depth_clip(depth, near, far)
    placed.add("depth-attenuation", clip)
    size = format_value(depth, "m")
    terms, factors = [], []
    for limits, letters, form in (
        (near, "A, B", "smoothstep({}, {})"),
        (far, "C, D", "(1 - smoothstep({}, {}))"),
    ):
        if limits:
            terms.append(form.format(letters, letter))
            factors.append(
                form.format(", ".join(format_value(limit, "m") for limit in limits), size)
            )
    if terms:
        formula = Formula("depth clip", f"{{depth-attenuation}} = {' '.join(terms)}", BARZEL)
        placed.steps.append(
            formula.with_numbers(f"a_z = {' '.join(factors)} = {format_number(clip)}")
        )
    elif "omni" not in at:
        placed.steps.append(FRONT.with_numbers(f"z = {size}; a_z = {format_number(clip)}"))


def _by_superellipse(at: Settings, placed: Placed) -> None:
    """Add the attenuation by the superellipse with its step, or 1 without a superellipse."""
    if "superellipse" not in at:
        placed.add("superellipse-attenuation", 1.0)
        return
    roundness = at["roundness"]
    clip = _clip(at, roundness)
    placed.add("superellipse-attenuation", clip)
    u, v = _section(at)
    a, b, outer_a, outer_b = map(format_number, at["superellipse"])
    numbers = f"u = {format_number(u)}, v = {format_number(v)}; "
    formula = SUPERELLIPSE
    if not any_true(roundness > 0):
        formula = RECTANGLE
        numbers += f"(1 - smoothstep({a}, {outer_a}, u)) (1 - smoothstep({b}, {outer_b}, v))"
    elif any_true((u + v == 0) | (roundness == 0)):  # q and r have no end
        numbers += "a_s"
    else:
        q, r = (
            format_number(1 / attenuations.superellipse_scale(u, v, *sizes, roundness))
            for sizes in _sizes(at)
        )
        numbers += f"a = {a}, b = {b}: q = {q}; A = {outer_a}, B = {outer_b}: r = {r}; "
        numbers += f"1 - smoothstep({q}, {r}, 1)"
    placed.steps.append(formula.with_numbers(f"{numbers} = {format_number(clip)}"))


def _sizes(at: Settings) -> tuple[tuple[float, float], tuple[float, float]]:
    a, b, outer_a, outer_b = at["superellipse"]
    return (a, b), (outer_a, outer_b)


def _clip(at: Settings, roundness: Any) -> Any:
    x, y = _section(at)
    return attenuations.superellipse_clip(x, y, *_sizes(at), roundness)


def _section(at: Settings) -> tuple[Number, Number]:
    x, y, z = at["point"]
    return attenuations.cross_section(x, y, z, at.get("shear", (0.0, 0.0)))


def _by_beam(at: Settings, placed: Placed) -> None:
    if "beam-exponent" not in at:
        placed.add("beam-attenuation", 1.0)
        return
    x, y, z = at["point"]
    part = attenuations.beam(x, y, z, at["beam-exponent"])
    placed.add("beam-attenuation", part)
    numbers = {name: at[name] for name in ("distance", "beam-exponent")}
    step = BEAM.step(numbers, format_number(part))
    placed.steps.append(step._replace(numbers=f"z = {format_value(z, 'm')}; {step.numbers}"))


def _by_falloff(at: Settings, placed: Placed) -> None:
    """Add the attenuation by distance, held to a given maximum, with its step."""
    numbers = {name: at[name] for name in ("distance", "falloff", "falloff-distance")}
    maximum = at.get("maximum")
    distance, exponent, reference = numbers.values()
    part = attenuations.falloff(distance, exponent, reference, maximum)
    placed.add("falloff-attenuation", part)
    size = format_number(part)
    if maximum is None or not any_true(distance < reference):
        placed.steps.append(FALLOFF.step(numbers, size))
    elif any_true(maximum == 1):
        placed.steps.append(WITHIN.step(numbers, size))
    else:
        s = -log(maximum)
        constants = f"s = {format_number(s)}, beta = {format_number(-exponent / s)}; "
        step = HELD.step({**numbers, "maximum": maximum}, size)
        placed.steps.append(step._replace(numbers=constants + step.numbers))


def _judge(solved: Solved) -> None:
    """Note settings that are not physical, and why a point is dark."""
    given = solved.given
    if "near" in given:
        solved.note(mention("{near} is not physical: it is dark up to A and lit from B on"))
    if "far" in given:
        solved.note(mention("{far} is not physical: the light vanishes between C and D"))
    _judge_falloff(solved)
    shaping = ["superellipse"] if "superellipse" in given else []
    if "beam-exponent" in given and any_true(given["beam-exponent"].value > 0):
        shaping.append("beam-exponent")
    if shaping:
        solved.note(
            f"{options(shaping, ' and ')} only shape{'s' if len(shaping) == 1 else ''} the "
            "directions: the fall-off along each is kept, and the flux is less than 4 pi times the "
            "intensity"
        )
    _judge_corner(solved)
    _judge_dark(solved)


def _judge_falloff(solved: Solved) -> None:
    """Compare the fall-off with an inverse square from the same intensity."""
    distance, reference = solved.value("distance"), solved.value("falloff-distance")
    exponent = solved.value("falloff")
    breaking = []
    if any_true(exponent != 2):
        breaking.append(option("falloff", format_number(exponent)))
    if "maximum" in solved.given and any_true(distance < reference):
        breaking.append(option("maximum", quote(solved.given["maximum"].text)))
    if not breaking:
        return
    several = len(breaking) > 1
    note = f"{' and '.join(breaking)} {'are' if several else 'is'} not an inverse square law"
    ratio = solved.value("falloff-attenuation") * square(distance / reference)
    if is_array(ratio):
        note += ": light is created or lost"
    elif abs(ratio - 1) > 1e-9:
        note += (
            f": {'they give' if several else 'it gives'} {format_number(ratio)} times the light of "
            f"that law here, so light is {'created' if ratio > 1 else 'lost'}"
        )
    solved.note(note)


def _judge_corner(solved: Solved) -> None:
    """Note how a roundness just above 0 would change a rectangle's soft edge."""
    if "superellipse" not in solved.given or not any_true(solved.value("roundness") == 0):
        return
    clip = solved.value("superellipse-attenuation")
    rounded = _clip({name: item.value for name, item in solved.given.items()}, HARDLY_ROUND)
    if any_true(abs(rounded - clip) > 1e-12):
        rounded_text = "" if is_array(rounded) else f" and gives {format_number(rounded)} here"
        solved.note(
            mention(
                "{roundness} of 0 multiplies the steps of x and y, as in the published shader; "
                f"just above 0 the formula for rounded corners applies{rounded_text}"
            )
        )


def _judge_dark(solved: Solved) -> None:
    z = solved.given["point"].value[2]
    if "omni" not in solved.given and any_true(z <= 0):
        solved.note("a spot has no light where z is 0 or less")
    elif any_true(solved.value("depth-attenuation") == 0):
        limits = [name for name in ("near", "far") if name in solved.given]
        solved.note(f"no light: the point is outside {options(limits, ' and ')}")
    elif any_true(solved.value("superellipse-attenuation") == 0):
        solved.note(mention("no light: the point is outside {superellipse}"))
    solved.note_behind()
