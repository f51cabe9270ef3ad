"""A source that is small beside its distance: flux, intensity, irradiance, and what gives them.

The intensity is that on the source's axis.  The light is spread evenly over all directions, or
over a cone, or falls off as a power of the cosine (a lobe).
"""

import math
from collections.abc import Callable
from typing import Any

from radcalc.conditions import positive, require, show
from radcalc.errors import ConditionError, UsageError
from radcalc.geometry import solid
from radcalc.laws import inputs as i
from radcalc.laws import light as q
from radcalc.laws.inputs import Inputs
from radcalc.laws.law import AnyLaw, Law, Relation
from radcalc.laws.sheet import OVER_TIME, Sheet
from radcalc.maths import acos, any_true, asin, atan2, exp, expm1, hypot, log1p, piecewise, sin
from radcalc.result import Answer

QUANTITIES = ("flux", "intensity", "irradiance", "exposure", "energy")
POSITION = ("distance", "height", "offset", "offset-y", "incidence")
CONE = ("half-angle", "apex-angle", "solid-angle")
LOBE = ("exponent", "beam-angle", "field-angle")
INPUTS = (*CONE, *LOBE, *POSITION, "within", "time", "receiver-area")
ISOTROPIC, CONICAL, LOBED = "isotropic", "cone", "lobe"
DISTRIBUTIONS = (ISOTROPIC, CONICAL, LOBED)
RIGHT = math.pi / 2
At = Callable[[str], Any]


def _ln_cos(angle: Any) -> Any:
    """ln cos(angle), to full precision for small angles."""
    return log1p(-2 * sin(angle / 2) ** 2)


def lobe_exponent(full_angle: Any, share: float) -> Any:
    """The exponent of a lobe that is down to a share of its peak at half of a full angle."""
    return math.log(share) / _ln_cos(full_angle / 2)


def lobe_angle(exponent: Any, share: float) -> Any:
    """The full angle [rad] at whose edge a lobe is down to a share of its peak."""
    fall = piecewise(
        exponent > 0, lambda n: expm1(math.log(share) / n), lambda n: n - 1.0, exponent
    )
    return 4 * asin((-fall / 2) ** 0.5)  # 1 - cos(x) = 2 sin^2(x/2)


def lobe_part(exponent: Any, within: Any) -> Any:
    """The part of a lobe's flux within an angle from its axis: 1 - cos^(n+1)."""
    return piecewise(
        within < RIGHT,
        lambda w, n: -expm1((n + 1) * _ln_cos(w)),
        lambda w, n: 1.0 + 0 * (w + n),
        within,
        exponent,
    )


def _exponent_of(solid_angle: Any) -> Any:
    found = 2 * math.pi / solid_angle - 1
    solid.refuse(
        found < -1e-9,
        "no lobe sends that flux at that intensity: it would fill more than a hemisphere",
        "more intensity or less flux, or --distribution cone",
    )
    return piecewise(found < 0, lambda n: 0.0 * n, lambda n: n, found)


LAWS: dict[str, list[AnyLaw]] = {
    ISOTROPIC: [
        Law(
            "isotropic source",
            "{flux} = 4 pi Omega0 {intensity}",
            "flux",
            (("intensity", 1),),
            4 * math.pi,
            "sr",
            "ISO 80000-7, intensity",
        ),
        Relation(
            "part of an isotropic source",
            "{part} = sin^2({within}/2)",
            ("part", "within"),
            {"part": lambda at: sin(at("within") / 2) ** 2},
        ),
    ],
    CONICAL: [
        Law(
            "uniform cone",
            "{flux} = {intensity} {solid-angle}",
            "flux",
            (("intensity", 1), ("solid-angle", 1)),
            reference="ISO 80000-7, intensity",
        ),
        Relation(
            "solid angle of a cone",
            "{solid-angle} = 4 pi sin^2({half-angle}/2) Omega0",
            ("solid-angle", "half-angle"),
            {
                "solid-angle": lambda at: solid.cone(at("half-angle")),
                "half-angle": lambda at: solid.cone_of(at("solid-angle")),
            },
            "ISO 80000-3, solid angle",
        ),
        Law("apex angle", "{apex-angle} = 2 {half-angle}", "apex-angle", (("half-angle", 1),), 2.0),
        Relation(
            "part of a cone",
            "{part} = sin^2({within}/2) / sin^2({half-angle}/2), at most 1",
            ("part", "within", "half-angle"),
            {
                "part": lambda at: piecewise(
                    at("within") < at("half-angle"),
                    lambda w, a: (sin(w / 2) / sin(a / 2)) ** 2,
                    lambda w, a: 1.0 + 0 * (w + a),
                    at("within"),
                    at("half-angle"),
                )
            },
        ),
    ],
    LOBED: [
        Law(
            "flux of a lobe",
            "{flux} = {intensity} {solid-angle}",
            "flux",
            (("intensity", 1), ("solid-angle", 1)),
        ),
        Relation(
            "flux of a lobe over its peak",
            "{solid-angle} = 2 pi Omega0 / ({exponent} + 1)",
            ("solid-angle", "exponent"),
            {
                "solid-angle": lambda at: 2 * math.pi / (at("exponent") + 1),
                "exponent": lambda at: _exponent_of(at("solid-angle")),
            },
        ),
        Relation(
            "beam angle of a lobe",
            "{exponent} = ln(1/2) / ln cos({beam-angle}/2)",
            ("exponent", "beam-angle"),
            {
                "exponent": lambda at: lobe_exponent(at("beam-angle"), 0.5),
                "beam-angle": lambda at: lobe_angle(at("exponent"), 0.5),
            },
        ),
        Relation(
            "field angle of a lobe",
            "{exponent} = ln(1/10) / ln cos({field-angle}/2)",
            ("exponent", "field-angle"),
            {
                "exponent": lambda at: lobe_exponent(at("field-angle"), 0.1),
                "field-angle": lambda at: lobe_angle(at("exponent"), 0.1),
            },
        ),
        Relation(
            "part of a lobe",
            "{part} = 1 - cos({within})^({exponent} + 1)",
            ("part", "within", "exponent"),
            {"part": lambda at: lobe_part(at("exponent"), at("within"))},
        ),
        Relation(
            "part of a lobe in its beam",
            "{beam-part} = 1 - cos({beam-angle}/2)^({exponent} + 1)",
            ("beam-part", "beam-angle", "exponent"),
            {"beam-part": lambda at: lobe_part(at("exponent"), at("beam-angle") / 2)},
        ),
        Law(
            "flux in the beam",
            "{beam-flux} = {flux} {beam-part}",
            "beam-flux",
            (("flux", 1), ("beam-part", 1)),
        ),
    ],
}
INVERSE_SQUARE = Law(
    "inverse square law",
    "{irradiance} = {intensity} {cosine} Omega0 / {distance}^2",
    "irradiance",
    (("intensity", 1), ("cosine", 1), ("distance", -2)),
    1.0,
    "sr",
    "ISO 80000-7, intensity and irradiance",
)
OFF_AXIS = Law(
    "inverse square law, off the source's axis",
    "{irradiance} = {intensity} {share} {cosine} Omega0 / {distance}^2",
    "irradiance",
    (("intensity", 1), ("share", 1), ("cosine", 1), ("distance", -2)),
    1.0,
    "sr",
    "ISO 80000-7, intensity and irradiance",
)
ANY_LAWS: list[AnyLaw] = [
    Relation(
        "cosine of the incidence",
        "{cosine} = cos({incidence})",
        ("cosine", "incidence"),
        {
            "cosine": lambda at: solid.facing(at("incidence")),
            "incidence": lambda at: _incidence_of(at("cosine")),
        },
    ),
    Relation(
        "straight line to the source",
        "{distance}^2 = {height}^2 + {lateral}^2",
        ("distance", "height", "lateral"),
        {
            "distance": lambda at: hypot(at("height"), at("lateral")),
            "height": lambda at: _height_of(at("distance"), at("lateral")),
        },
    ),
    Law("flux within", "{flux-within} = {flux} {part}", "flux-within", (("flux", 1), ("part", 1))),
    *OVER_TIME,
    Law(
        "flux on a receiver",
        "{received-flux} = {irradiance} {receiver-area}",
        "received-flux",
        (("irradiance", 1), ("receiver-area", 1)),
    ),
]


def _incidence_of(cosine: Any) -> Any:
    solid.refuse(
        cosine > 1 + 1e-9,
        f"more light than that intensity sends to that distance (the cosine of the incidence "
        f"would be {show(cosine)})",
        "another irradiance, intensity or distance",
    )
    return acos(piecewise(cosine > 1, lambda c: 1.0 + 0 * c, lambda c: c, cosine))


def _height_of(distance: Any, lateral: Any) -> Any:
    solid.refuse(
        distance <= lateral,
        "the distance is less than the offset",
        "--distance is the straight line to the source",
    )
    return (distance - lateral) ** 0.5 * (distance + lateral) ** 0.5


INTERNAL = {
    "cosine": "cos(theta)",
    "share": "f",
    "lateral": "x",
    "part": "k",
    "beam-part": "k_b",
}


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


def point_source(given: Inputs, distribution: str | None = None) -> Answer:
    """Everything that follows for a point source from whatever is known of it.

    `given` are light quantities by whichever name, lengths, angles, times, and what links the
    kinds; `distribution` is one of `DISTRIBUTIONS`.
    """
    quantities, links, rest = q.sort(given)
    i.only(rest, INPUTS, "a point source")
    lit = q.read_light(quantities, links)
    _refuse_foreign(lit)
    shape = _distribution(rest, distribution)
    sheet = Sheet(lit, rest, INTERNAL, "incidence")
    _check_angles(rest)
    laws = [*LAWS[shape], *ANY_LAWS, *_position(rest, sheet, shape)]
    sheet.said.append(SAID[shape])
    _solve(sheet, laws)
    sheet.refuse_idle(laws, (*QUANTITIES, *INPUTS))
    _refuse_near(rest, sheet)
    if sheet.has("cosine") and any_true(sheet.at("cosine") == 0):
        sheet.notes.append("light from the side or behind does not reach the receiver")
    if shape == CONICAL and sheet.has("share") and any_true(sheet.at("share") == 0):
        sheet.notes.append("the receiver is outside the cone")
    rows, shown = sheet.light_rows(RESULTS)
    rows += sheet.input_rows(
        {**UNITS, **SHAPED[shape], "within": "deg", "time": "s", "receiver-area": "m2"}
    )
    rows += sheet.absent_rows(laws, (*RESULTS, "distance"), (*QUANTITIES, *INPUTS))
    return sheet.answer(rows, shown)


def _solve(sheet: Sheet, laws: list[AnyLaw]) -> None:
    """Light comes along the receiver's normal, unless the quantities tell that it does not."""
    if "incidence" in sheet.known or not sheet.has("irradiance", "distance", "exposure"):
        sheet.solve(laws)
        return
    sheet.know("incidence", 0.0)
    try:
        sheet.solve(laws)
        sheet.said.append("light along the receiver's normal")
    except ConditionError as contradiction:
        del sheet.known["incidence"]
        try:
            sheet.solve(laws)
        except ConditionError:
            raise contradiction from None
        sheet.notes.append("less light than head-on: the incidence is what makes up for it")


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
        elif name in ("within", "incidence"):
            i.tilt(given, name)


def _distribution(given: Inputs, chosen: str | None) -> str:
    """The distribution, as it was chosen or as an option of its own tells."""
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
    sheet.know("lateral", sideways, lateral[0])
    off = atan2(sideways, positive(given["height"]))
    sheet.know("off-axis", off)
    _level(given, sheet, off)
    if shape == ISOTROPIC:
        return [INVERSE_SQUARE]
    sheet.said.append("the source points straight down")
    if shape == CONICAL:
        return [
            OFF_AXIS,
            Relation(
                "inside the cone",
                "{share} = 1 where {off-axis} is within {half-angle}, else 0",
                ("share", "off-axis", "half-angle"),
                {
                    "share": lambda at: piecewise(
                        at("off-axis") <= at("half-angle") * (1 + 1e-12),
                        lambda a, b: 1.0 + 0 * (a + b),
                        lambda a, b: 0.0 * (a + b),
                        at("off-axis"),
                        at("half-angle"),
                    )
                },
            ),
        ]
    return [
        OFF_AXIS,
        Relation(
            "fall of a lobe",
            "{share} = cos({off-axis})^{exponent}",
            ("share", "off-axis", "exponent"),
            {"share": lambda at: exp(at("exponent") * _ln_cos(at("off-axis")))},
        ),
    ]


def _level(given: Inputs, sheet: Sheet, off: Any) -> None:
    """A receiver under a height lies in a plane across the source's axis, unless told."""
    if "incidence" not in given:
        sheet.know("incidence", off)
        sheet.said.append("the receiver lies flat, in a plane across the source's axis")


def _refuse_near(given: Inputs, sheet: Sheet) -> None:
    """Refuse a receiver so large beside its distance that its irradiance is not uniform."""
    if "receiver-area" in given and sheet.has("distance"):
        size = 2 * (given["receiver-area"].value / math.pi) ** 0.5
        if any_true(sheet.at("distance") < 5 * size * (1 - 1e-12)):
            raise ConditionError(
                f"--receiver-area {given['receiver-area'].text} is too large for its distance: "
                "the irradiance on it is not uniform",
                f"a distance of {show(5 * size)} m or more",
            )
