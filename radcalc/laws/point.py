"""Small sources: the laws of each distribution, and those of all.

The light is uniform in all directions, or within a cone, or falls off from its axis as a power of
the cosine (a lobe), up to 90 degrees.  I is the intensity on the axis, f the relative one at the
angle gamma off the axis.  The distance d is at least five times the size of the source; a round
receiver may have any size and distance, and its solid angle is weighted with f.

- `LAWS`: flux and share of each distribution; `WIDTHS`: those that contain only its angles
- `ANY_LAWS`: those of all distributions
- `FLOOR`, `AXIS`, `FLAT`, `ASIDE`, `SPOT`: a place on the floor, at the distance x from the foot of
  the axis of a source at the height h; up to two heights, or exponents of a lobe, fit

Lengths [m], angles [rad]; light in coherent SI of one kind.
"""

import math
from collections.abc import Callable
from typing import Any

from radcalc import geometry, maths
from radcalc.answer import format_number
from radcalc.errors import add, leave_out, option
from radcalc.laws import (
    APEX,
    CONE,
    COSINE,
    ENERGY,
    EXPOSURE,
    AnyLaw,
    At,
    Relation,
    Several,
    law,
    refuse_arrays,
    relation,
)
from radcalc.quantities.symbols import DISTRIBUTIONS

ISOTROPIC, CONICAL, LOBED = DISTRIBUTIONS


def _exponent_of(solid_angle: Any) -> Any:
    exponent = 2 * math.pi / solid_angle - 1
    geometry.refuse(
        exponent < -1e-9,
        "no lobe has that flux and that intensity: it would fill more than a hemisphere",
        f"more intensity or less flux, or {option('distribution', 'cone')}",
        [add("distribution", "cone"), leave_out("intensity"), leave_out("flux")],
    )
    return maths.piecewise(exponent < 0, lambda n: 0.0 * n, lambda n: n, exponent)


LOBE = relation(
    "flux of a lobe divided by its peak intensity",
    "{solid-angle} = 2 pi Omega0 / ({exponent} + 1)",
    {
        "solid-angle": lambda at: geometry.lobe(at("exponent")),
        "exponent": lambda at: _exponent_of(at("solid-angle")),
    },
)
BEAM_ANGLE = relation(
    "beam angle of a lobe",
    "{exponent} = ln(1/2) / ln cos({beam-angle}/2)",
    {
        "exponent": lambda at: geometry.lobe_exponent(at("beam-angle"), 0.5),
        "beam-angle": lambda at: geometry.lobe_angle(at("exponent"), 0.5),
    },
)
FIELD_ANGLE = relation(
    "field angle of a lobe",
    "{exponent} = ln(1/10) / ln cos({field-angle}/2)",
    {
        "exponent": lambda at: geometry.lobe_exponent(at("field-angle"), 0.1),
        "field-angle": lambda at: geometry.lobe_angle(at("exponent"), 0.1),
    },
)


def beam_of_cone(away: str) -> Relation:
    """Make the law of the width of a cone's light at a distance along its axis.

    Parameters
    ----------
    away : str
        Symbol of that distance: `height` or `distance`.

    Returns
    -------
    Relation
        Between `beam-diameter`, that symbol and the half angle, which must be below pi/2.

    Examples
    --------
    >>> width = beam_of_cone("height")
    >>> round(width.solve("beam-diameter", {"height": 3.0, "half-angle": math.pi / 4}.get), 9)
    6.0
    """
    return _beam_diameter("diameter of a cone's light", away, "half-angle", 1)


def beam_of_lobe(away: str) -> Relation:
    """Make the law of the width of a lobe's beam at a distance along its axis.

    Parameters
    ----------
    away : str
        Symbol of that distance: `height` or `distance`.

    Returns
    -------
    Relation
        Between `beam-diameter`, that symbol and the beam angle, which must be below pi.

    Examples
    --------
    >>> width = beam_of_lobe("height")
    >>> round(width.solve("beam-diameter", {"height": 3.0, "beam-angle": math.pi / 2}.get), 9)
    6.0
    """
    return _beam_diameter("diameter of a lobe's beam", away, "beam-angle", 2)


def _beam_diameter(name: str, away: str, angle: str, parts: int) -> Relation:
    part = f"{{{angle}}}/{parts}" if parts > 1 else f"{{{angle}}}"
    return relation(
        name,
        f"{{beam-diameter}} = 2 {{{away}}} tan({part})",
        {
            "beam-diameter": lambda at: 2 * at(away) * maths.tan(at(angle) / parts),
            away: lambda at: at("beam-diameter") / (2 * maths.tan(at(angle) / parts)),
            angle: lambda at: parts * maths.atan(at("beam-diameter") / (2 * at(away))),
        },
    )


# The angles of a distribution, which do not depend on the amount of light.
WIDTHS: dict[str, list[AnyLaw]] = {
    ISOTROPIC: [],
    CONICAL: [CONE, APEX],
    LOBED: [BEAM_ANGLE, FIELD_ANGLE],
}
LAWS: dict[str, list[AnyLaw]] = {
    ISOTROPIC: [
        law("isotropic source", "{flux} = 4 pi Omega0 {intensity}", "ISO 80000-7, intensity"),
        relation(
            "part of an isotropic source",
            "{part} = sin^2({within}/2)",
            {"part": lambda at: maths.square(maths.sin(at("within") / 2))},
        ),
    ],
    CONICAL: [
        law("uniform cone", "{flux} = {intensity} {solid-angle}", "ISO 80000-7, intensity"),
        *WIDTHS[CONICAL],
        relation(
            "part of a cone",
            "{part} = sin^2({within}/2) / sin^2({half-angle}/2), at most 1",
            {
                "part": lambda at: maths.piecewise(
                    at("within") < at("half-angle"),
                    lambda w, a: maths.square(maths.sin(w / 2) / maths.sin(a / 2)),
                    lambda w, a: 1.0 + 0 * (w + a),
                    at("within"),
                    at("half-angle"),
                )
            },
        ),
    ],
    LOBED: [
        law("flux of a lobe", "{flux} = {intensity} {solid-angle}"),
        LOBE,
        *WIDTHS[LOBED],
        relation(
            "part of a lobe's flux within an angle",
            "{part} = 1 - cos({within})^({exponent} + 1)",
            {"part": lambda at: geometry.lobe_part(at("exponent"), at("within"))},
        ),
        relation(
            "part of a lobe's flux in its beam",
            "{beam-part} = 1 - cos({beam-angle}/2)^({exponent} + 1)",
            {"beam-part": lambda at: geometry.lobe_part(at("exponent"), at("beam-angle") / 2)},
        ),
        law("flux in the beam", "{beam-flux} = {flux} {beam-part}"),
    ],
}
INVERSE_SQUARE = law(
    "inverse square law",
    "{irradiance} = {intensity} {cosine} Omega0 / {distance}^2",
    "ISO 80000-7, intensity and irradiance",
)
ISOTROPIC_ENERGY = law("isotropic energy", "{exposure} = {energy} {cosine} / (4 pi {distance}^2)")
INVERSE_SQUARE_OF_ENERGY = law(
    "inverse square law, of an energy",
    "{exposure} = {energy} {cosine} Omega0 / ({solid-angle} {distance}^2)",
)
OFF_AXIS_OF_ENERGY = law(
    "inverse square law, of an energy, off the source's axis",
    "{exposure} = {energy} {relative-intensity} {cosine} Omega0 / ({solid-angle} {distance}^2)",
)
ENERGIES = (ISOTROPIC_ENERGY, INVERSE_SQUARE_OF_ENERGY, OFF_AXIS_OF_ENERGY)
OFF_AXIS = law(
    "inverse square law, off the source's axis",
    "{irradiance} = {intensity} {relative-intensity} {cosine} Omega0 / {distance}^2",
    "ISO 80000-7, intensity and irradiance",
)
STRAIGHT = relation(
    "straight line to the source",
    "{distance}^2 = {height}^2 + {lateral}^2",
    {
        "distance": lambda at: maths.hypot(at("height"), at("lateral")),
        "height": lambda at: _height_or_offset(at("distance"), at("lateral"), "offset"),
        "lateral": lambda at: _height_or_offset(at("distance"), at("height"), "height"),
    },
)
WITHIN = law("flux within", "{flux-within} = {flux} {part}")
ANY_LAWS: list[AnyLaw] = [
    COSINE,
    STRAIGHT,
    WITHIN,
    EXPOSURE,
    ENERGY,
    law("flux on a receiver", "{received-flux} = {intensity} {received-solid-angle}"),
]


def _height_or_offset(distance: Any, other: Any, name: str) -> Any:
    geometry.refuse(
        distance < other,
        f"the distance is less than the {name}",
        f"a {option('distance')} of at least the {option(name)}: it is "
        "the straight line to the source",
    )
    return maths.power(distance - other, 0.5) * maths.power(distance + other, 0.5)


INSIDE = relation(
    "inside the cone",
    "{relative-intensity} = 1 where {off-axis} is within {half-angle}, else 0",
    {
        "relative-intensity": lambda at: maths.piecewise(
            at("off-axis") <= at("half-angle") * (1 + maths.SLACK),
            lambda a, b: 1.0 + 0 * (a + b),
            lambda a, b: 0.0 * (a + b),
            at("off-axis"),
            at("half-angle"),
        )
    },
)
FALL = relation(
    "fall of a lobe",
    "{relative-intensity} = cos({off-axis})^{exponent}",
    {
        "relative-intensity": lambda at: maths.exp(
            at("exponent") * geometry.ln_cos(at("off-axis"))
        ),
        "exponent": lambda at: _exponent_at(at("relative-intensity"), at("off-axis")),
    },
)


AXIS = relation(
    "angle off the source's axis",
    "{off-axis} = atan({lateral} / {height})",
    {"off-axis": lambda at: maths.atan2(at("lateral"), at("height"))},
)
FLAT = law("a receiver that lies flat", "{incidence} = {off-axis}")
ASIDE = relation(
    "place of a receiver that lies flat, by its incidence",
    "{lateral} = {height} tan({incidence})",
    {"lateral": lambda at: at("height") * maths.tan(at("incidence"))},
)


def _floor(shape: str, of_energy: bool) -> Relation:
    """Return the law of the light at a place on the floor, solved for the place."""
    exponent = (lambda at: at("exponent")) if shape == LOBED else (lambda at: 0.0)
    height, distance = "{height}", "({height}^2 + {lateral}^2)^(3/2)"
    if shape == LOBED:
        height, distance = "{height}^({exponent} + 1)", f"{distance[:-6]}^(({{exponent}} + 3)/2)"
    left, right = "{irradiance}", f"{{intensity}} {height} Omega0 / {distance}"
    if of_energy:
        whole = "4 pi" if shape == ISOTROPIC else "{solid-angle}"
        left, right = "{exposure}", f"{{energy}} {height} Omega0 / ({whole} {distance})"

    def part(at: At) -> Any:
        if not of_energy:
            return at("irradiance") / at("intensity")
        whole = 4 * math.pi if shape == ISOTROPIC else at("solid-angle")
        return at("exposure") * whole / at("energy")

    return relation(
        "exposure of a floor" if of_energy else "illuminance of a floor",
        f"{left} = {right}",
        {
            "lateral": lambda at: _lateral_of(
                part(at) * maths.square(at("height")), at("height"), exponent(at)
            ),
            "height": lambda at: _heights_of(part(at), at("lateral"), exponent(at)),
        },
    )


def _lateral_of(part: Any, height: Any, exponent: Any) -> Any:
    """Return the offset at which the irradiance is a part of that under the source: cos^(n + 3)."""
    geometry.refuse(
        (part > 1) | (part <= 0),
        f"more light than that intensity sends to that height ({format_number(part)} times it)",
        "another irradiance, intensity or height",
    )
    return height * maths.sqrt(maths.expm1(-2 * maths.log(part) / (exponent + 3)))


def _heights_of(part: Any, lateral: Any, exponent: Any) -> Any:
    """Return the one or two heights with E / I = (cos^(n + 1) sin^2)(gamma) / x^2 = `part`."""
    refuse_arrays("heights", part, lateral, exponent)
    if lateral == 0:
        return maths.sqrt(1 / part)

    wanted = maths.log(part) + 2 * maths.log(lateral)

    def excess(slope: float) -> float:  # ln(tan(gamma)), which is precise at both ends
        dimming = math.log1p(math.exp(-2 * abs(slope))) + 2 * max(slope, 0.0)  # -2 ln(cos(gamma))
        return float(2 * slope - (exponent + 3) / 2 * dimming - wanted)

    brightest = maths.log(2 / (exponent + 1)) / 2
    low, high = wanted / 2, -wanted / (exponent + 1)  # with the cosine or the sine as 1
    ends = min(low, brightest) - 1, max(high, brightest) + 1
    slopes = _both_sides(excess, ends[0], brightest, ends[1], "height")
    return Several(lateral * maths.exp(-slope) for slope in slopes)


ROUNDING = 1e-12  # [1] of the light at the brightest place
SAME = 4e-15  # [1] of it: with less than this to spare, two places are one


def _both_sides(
    excess: Callable[[float], float], low: float, top: float, high: float, what: str
) -> tuple[float, ...]:
    """Return the zeros of a function that rises up to its top and falls after it."""
    most = excess(top)
    geometry.refuse(
        most < -ROUNDING,
        f"more light than any {what} gives there",
        "less irradiance, or more flux or intensity",
    )
    if most <= SAME:
        return (top,)
    ends = [end for end in (low, high) if excess(end) < 0]
    return tuple(maths.limit(lambda at: excess(at) >= 0, end, top) for end in ends)


FLOOR = {
    shape: [_floor(shape, of_energy) for of_energy in (False, True)]
    for shape in (ISOTROPIC, CONICAL, LOBED)
}
# Near 90 deg an angle has fewer digits than a height.
COSINE_BELOW = relation(
    "cosine of the incidence, below a source",
    "{cosine} = {height} / {distance}",
    {"cosine": lambda at: at("height") / at("distance")},
)
FALL_BELOW = relation(
    "fall of a lobe, below its source",
    "{relative-intensity} = ({height} / {distance})^{exponent}",
    {"relative-intensity": lambda at: maths.power(at("height") / at("distance"), at("exponent"))},
)


def _exponents_of(at: At) -> Any:
    """Return the one or two exponents that give (n + 1) cos(gamma)^n the value of the inputs."""
    part = 2 * math.pi * at("irradiance") * maths.square(at("distance")) / at("flux") / at("cosine")
    fall = -geometry.ln_cos(at("off-axis"))
    refuse_arrays("exponents", part, fall)
    if fall == 0:
        return _exponent_of(2 * math.pi / part)

    def excess(exponent: float) -> float:
        return float(maths.log(exponent + 1) - exponent * fall - maths.log(part))

    brightest = max(1 / fall - 1, 0.0)
    high = 2 * brightest + 1
    while excess(high) >= 0:
        high *= 2
    return Several(_both_sides(excess, 0.0, brightest, high, "exponent"))


SPOT = relation(
    "lobe of a flux, off its axis",
    "{irradiance} = {flux} ({exponent} + 1) / (2 pi) cos({off-axis})^{exponent} {cosine} "
    "/ {distance}^2",
    {"exponent": _exponents_of},
)


def _exponent_at(share: Any, off_axis: Any) -> Any:
    geometry.refuse(
        (share > 1 + 1e-9) | (share <= 0),
        "no lobe has that irradiance there: it is 0, or more than the peak would give",
        "another intensity or irradiance",
    )
    return abs(maths.log(share) / geometry.ln_cos(off_axis))


def _received(shape: str, aside: bool = False, turned: bool = True) -> Relation:
    """Return the law of the light on a round receiver, on or off the axis and tilted or not."""
    parameters, texts = _INTEGRANDS[shape]
    places = [name for name, is_one in (("off-axis", aside), ("incidence", turned)) if is_one]
    names = {"off-axis": "{off-axis} off the axis", "incidence": "turned by {incidence}"}
    where = ", ".join(["a disc of {receiver-area} at {distance}", *map(names.__getitem__, places)])

    def solve(at: At) -> Any:
        from radcalc.geometry import receivers

        radius = maths.sqrt(at("receiver-area") / math.pi)
        place = {name.replace("-", "_"): at(name) for name in places}
        return getattr(receivers, shape)(*map(at, parameters), radius, at("distance"), **place)

    title = f"solid angle of a receiver lit by {LIT_BY[shape]}"
    if aside:
        title += f", off the axis{', turned' if turned else ''}"
    return relation(
        title,
        f"{{received-solid-angle}} = integral of {texts}, over {where}",
        {"received-solid-angle": solve},
    )


LIT_BY = {ISOTROPIC: "an isotropic source", CONICAL: "a cone", LOBED: "a lobe"}
# The symbols of a distribution's shape, and its integrand over a receiver.
_INTEGRANDS: dict[str, tuple[tuple[str, ...], str]] = {
    ISOTROPIC: ((), "cos(theta) / r^2"),
    CONICAL: (("half-angle",), "cos(theta) / r^2 within {half-angle}"),
    LOBED: (("exponent",), "cos(gamma)^{exponent} cos(theta) / r^2"),
}
RECEIVER_ON_AXIS = {shape: _received(shape) for shape in _INTEGRANDS}
RECEIVER_FLAT = {
    shape: _received(shape, shape != ISOTROPIC, shape == ISOTROPIC) for shape in _INTEGRANDS
}
RECEIVER_TURNED = {shape: _received(shape, shape != ISOTROPIC) for shape in _INTEGRANDS}
RECEIVERS = {
    shape: [of[shape] for of in (RECEIVER_ON_AXIS, RECEIVER_FLAT, RECEIVER_TURNED)]
    for shape in _INTEGRANDS
}
