"""A source that is small beside its distance: flux, intensity, irradiance, and what gives them.

The intensity is that on the source's axis.  The light is spread evenly over all directions, or
over a cone, or falls off as a power of the cosine (a lobe).
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

from radcalc.conditions import positive, require, show
from radcalc.errors import ConditionError, UsageError
from radcalc.geometry import solid
from radcalc.laws import inputs as i
from radcalc.laws import light as q
from radcalc.laws.inputs import Inputs
from radcalc.laws.law import (
    AnyLaw,
    Contradiction,
    Known,
    Law,
    Naming,
    Relation,
    Values,
    rounding,
    solve,
    steps,
    would_do,
)
from radcalc.maths import acos, any_true, asin, atan2, exp, expm1, hypot, log1p, piecewise, sin
from radcalc.result import Answer, Step, Value

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
        Law("all directions", "{solid-angle} = 4 pi Omega0", "solid-angle", (), 4 * math.pi, "sr"),
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
ANY_LAWS: list[AnyLaw] = [
    Law(
        "inverse square law",
        "{irradiance} = {intensity} {share} {cosine} Omega0 / {distance}^2",
        "irradiance",
        (("intensity", 1), ("share", 1), ("cosine", 1), ("distance", -2)),
        1.0,
        "sr",
        "ISO 80000-7, intensity and irradiance",
    ),
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
    Law(
        "exposure", "{exposure} = {irradiance} {time}", "exposure", (("irradiance", 1), ("time", 1))
    ),
    Law("energy", "{energy} = {flux} {time}", "energy", (("flux", 1), ("time", 1))),
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


def point_source(
    typed: Inputs, given: Inputs, light: Inputs, distribution: str | None = None
) -> Answer:
    """Everything that follows for a point source.

    `typed` are its light quantities, by whichever name; `given` its lengths, angles, numbers and
    times; `light` what links the kinds; `distribution` one of `DISTRIBUTIONS`.
    """
    lit = q.read_light(typed, light)
    shape = _distribution(given, distribution)
    said = list(lit.assumptions)
    if shape == ISOTROPIC:
        said.append("isotropic: the same intensity in all directions")
    elif shape == CONICAL:
        said.append("the same intensity everywhere in the cone, none outside")
    else:
        said.append("intensity I0 cos^n(theta) from the axis, of which I0 is given here")
    known = _known(lit, given)
    placed = _position(given, known, shape, said)
    laws = [*LAWS[shape], *ANY_LAWS, *placed]
    if not lit.amounts:
        raise UsageError("a light quantity is missing", "--flux, --intensity or --irradiance")
    naming = _naming(lit.kind)
    try:
        solution = solve(laws, known)
        if _is_placed(solution.values) and "incidence" not in solution.values:
            said.append("light along the receiver's normal")
            known["incidence"] = Known(0.0)
            solution = solve(laws, known)
    except Contradiction as error:
        raise _contradiction(error, lit, given, naming) from None
    values = solution.values
    _refuse_idle(laws, known, values, lit, given)
    _refuse_near(given, values)
    notes = list(lit.notes)
    if any_true(values["cosine"].value == 0) if "cosine" in values else False:
        notes.append("light from the side or behind does not reach the receiver")
    if shape == CONICAL and "share" in values and any_true(values["share"].value == 0):
        notes.append("the receiver is outside the cone")
    found: dict[str, Any] = {
        name: values[name].value
        for name in (
            "intensity",
            "flux",
            "irradiance",
            "exposure",
            "energy",
            "received-flux",
            "flux-within",
            "beam-flux",
        )
        if name in values
    }
    shown = q.show_light(lit, found)
    rows = [row for name in found for row in shown.values[name]]
    rows += _others(given, values, shape)
    rows += _missing(laws, known, values, lit)
    derivation: list[Step] = [*lit.steps, *steps(solution, naming), *shown.steps]
    return rows, [*said, *shown.assumptions], [*notes, *shown.notes], derivation


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


def _known(lit: q.Lit, given: Inputs) -> Values:
    """What is given, as the laws take it."""
    known = {
        name: Known(amount, rounding(lit.values[name].text), lit.values[name].text)
        for name, amount in lit.amounts.items()
    }
    for name, one in lit.values.items():
        positive(one) if name != "irradiance" else require(
            one, not any_true(one.value <= 0), "more than 0"
        )
    limits = {
        "beam-angle": math.pi,
        "field-angle": math.pi,
        "half-angle": math.pi,
        "within": math.pi,
    }
    for name, one in given.items():
        if name in ("offset", "offset-y", "incidence"):
            continue
        if name == "exponent":
            require(one, not any_true(one.value < 0), "0 or more")
        else:
            positive(one)
        if name in limits:
            top = limits[name] * (1 + 1e-12)
            bad = one.value > top if name in ("half-angle", "within") else one.value >= math.pi
            require(
                one, not any_true(bad), "less than 180 deg" if name in LOBE else "up to 180 deg"
            )
        known[name] = Known(one.value, rounding(one.text), one.text)
    return known


def _position(given: Inputs, known: Values, shape: str, said: list[str]) -> list[AnyLaw]:
    """What the receiver's place adds: known values, and laws for a place off the axis."""
    if "incidence" in given:
        one = given["incidence"]
        require(one, not any_true(abs(one.value) > math.pi), "0 to 180 deg")
        known["incidence"] = Known(abs(one.value), rounding(one.text), one.text)
    lateral = [given[name] for name in ("offset", "offset-y") if name in given]
    if not lateral:
        known["share"] = Known(1.0)
        if "height" in given:
            known["lateral"] = Known(0.0)
            _level(given, known, said)
        return []
    if "height" not in given:
        raise UsageError(
            "--height is missing beside --offset", "--height 6m, along the source's axis"
        )
    sideways = (
        hypot(*(one.value for one in lateral)) if len(lateral) == 2 else abs(lateral[0].value)
    )
    known["lateral"] = Known(sideways, max(rounding(one.text) for one in lateral))
    off = atan2(sideways, positive(given["height"]))
    known["off-axis"] = Known(off)
    _level(given, known, said, off)
    said.append("the source points straight down its axis")
    if shape == ISOTROPIC:
        known["share"] = Known(1.0)
        return []
    if shape == CONICAL:
        return [
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
            )
        ]
    return [
        Relation(
            "fall of a lobe",
            "{share} = cos({off-axis})^{exponent}",
            ("share", "off-axis", "exponent"),
            {"share": lambda at: exp(at("exponent") * _ln_cos(at("off-axis")))},
        )
    ]


def _level(given: Inputs, known: Values, said: list[str], off: Any = 0.0) -> None:
    """A receiver under a height lies in a plane across the source's axis, unless told."""
    if "incidence" not in given:
        known["incidence"] = Known(off)
        said.append("the receiver lies in a plane across the source's axis (a floor)")


def _is_placed(values: Values) -> bool:
    return bool({"distance", "irradiance", "exposure", "received-flux"} & set(values))


def _refuse_idle(
    laws: Sequence[AnyLaw], known: Values, values: Values, lit: q.Lit, given: Inputs
) -> None:
    """Refuse what is given and used by no law, and what nothing follows from."""
    live = {name for law in laws if all(n in values for n in law.names) for name in law.names}
    inputs = (*QUANTITIES, *INPUTS)
    for name, one in {**lit.values, **given}.items():
        own = "lateral" if name in ("offset", "offset-y") else name
        if own in live or (name == "incidence" and "irradiance" in values):
            continue
        useful = [
            n
            for n in inputs
            if n not in known
            and _makes_live(laws, set(known) | {n}, own)
            and n not in ("incidence", "offset", "offset-y", "within")
        ]
        raise ConditionError(
            f"{one.flag} {one.text}: nothing follows from it yet",
            f"with it, {' or '.join(f'--{n}' for n in useful[:4])}" if useful else "without it",
        )
    del given


def _makes_live(laws: Sequence[AnyLaw], known: set[str], name: str) -> bool:
    """Whether some law of a symbol would have all its symbols."""
    from radcalc.laws.law import reached

    values = reached(laws, known | {"incidence"})
    return any(name in law.names and all(n in values for n in law.names) for law in laws)


def _refuse_near(given: Inputs, values: Values) -> None:
    """Refuse a receiver so large beside its distance that its irradiance is not uniform."""
    if "receiver-area" in given and "distance" in values and "irradiance" in values:
        size = 2 * (given["receiver-area"].value / math.pi) ** 0.5
        if any_true(values["distance"].value < 5 * size * (1 - 1e-12)):
            raise ConditionError(
                f"--receiver-area {given['receiver-area'].text} is too large for its distance: "
                "the irradiance on it is not uniform",
                f"a distance of {show(5 * size)} m or more",
            )


def _others(given: Inputs, values: Values, shape: str) -> list[Value]:
    """The lengths, angles, times and numbers as results."""
    names = ["distance", "height", "offset", "offset-y", "incidence", "off-axis"]
    names += [*CONE] if shape == CONICAL else [*LOBE] if shape == LOBED else []
    names += ["within", "time", "receiver-area"]
    shown = {
        "distance": "m",
        "height": "m",
        "time": "s",
        "receiver-area": "m2",
        "solid-angle": "sr",
        "exponent": "1",
    }
    rows = []
    for name in names:
        if name in given:
            rows.append(i.known(given[name]))
        elif name in values and values[name].value is not None:
            rows.append(i.value(name, values[name].value, shown.get(name, "deg")))
    if shape != CONICAL and "solid-angle" in values:
        quiet = i.value("solid-angle", values["solid-angle"].value, "sr")
        quiet.units = ()
        rows.append(quiet)
    return rows


def _missing(laws: Sequence[AnyLaw], known: Values, values: Values, lit: q.Lit) -> list[Value]:
    """Results that do not follow, which say what they lack when they are asked for."""
    rows = []
    names = (
        "intensity",
        "flux",
        "irradiance",
        "exposure",
        "energy",
        "received-flux",
        "flux-within",
        "beam-flux",
        "distance",
    )
    for name in names:
        if name in values:
            continue
        alone = would_do(laws, known, name, (*QUANTITIES, *INPUTS))

        def fail(name: str = name, alone: list[str] = alone) -> Any:
            raise UsageError(
                f"no {name.replace('-', ' ')} follows from what is given",
                " or ".join(f"--{n}" for n in alone[:5]) or "more of the quantities",
            )

        if name == "distance":
            rows.append(Value(name, name, "d", fail, i.INPUTS[name].dimensions, ()))
        else:
            dims = tuple(q.dimension(name, kind) for kind in q.ORDER)
            rows.append(Value(name, name, "", fail, dims, (), also=q.specific(name, lit.kind)))
    return rows


def _naming(kind: str) -> dict[str, Naming]:
    """How the symbols are written in a derivation."""
    letters = {
        **i.SYMBOLS,
        "apex-angle": "2 alpha",
        "half-angle": "alpha",
        "solid-angle": "Omega",
        "incidence": "theta",
        "within": "beta",
        "off-axis": "gamma",
    }
    units = {
        "distance": "m",
        "height": "m",
        "lateral": "m",
        "time": "s",
        "receiver-area": "m2",
        "solid-angle": "sr",
        "exponent": "1",
    }
    naming = {name: Naming(letter, units.get(name, "rad")) for name, letter in letters.items()}
    naming |= {name: Naming(letter, units.get(name, "1")) for name, letter in INTERNAL.items()}
    ascii_ = {"Φ": "Phi", "Φ_r": "Phi_r", "Φ_w": "Phi_w", "Φ_b": "Phi_b"}
    for name, letter in q.SYMBOLS.items():
        naming[name] = Naming(ascii_.get(letter, letter), q.unit(name, kind, coherent=True))
    return naming


def _contradiction(
    error: Contradiction, lit: q.Lit, given: Inputs, naming: dict[str, Naming]
) -> ConditionError:
    """Both values, with their unit, and the ratio."""
    one = lit.values.get(error.name) or given.get(error.name)
    unit = naming[error.name].unit
    scale = 180 / math.pi if unit == "rad" else 1.0
    shown_unit = "deg" if unit == "rad" else unit
    found = f"{show(error.found * scale)} {shown_unit}".removesuffix(" 1")
    text = one.text if one else f"{show(error.given * scale)} {shown_unit}"
    flag = one.flag if one else error.name
    ratio = f" (ratio {show(error.given / error.found)})" if not any_true(error.found == 0) else ""
    others = [f"--{n}" for n in error.law.names if n in lit.values or n in given]
    return ConditionError(
        f"{flag} {text} contradicts the rest, which gives {found}{ratio}",
        f"without one of {', '.join(others)}",
    )
