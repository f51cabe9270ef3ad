"""Mistakes in formulas that no edit of a law gives: formulas of other things, and integrals."""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from radcalc import geometry
from radcalc.answer import format_number
from radcalc.geometry.numerics import integral
from radcalc.homework.chain import FAILURES, Worked
from radcalc.homework.edits import text_of
from radcalc.homework.question import Candidate, Problem, usual
from radcalc.laws import AnyLaw, At
from radcalc.maths import cos, sin

PI = math.pi
Function = Callable[[At], Any]  # of the values of a law's symbols


class Row(NamedTuple):
    """A mistake in a law, and a function that gives the wrong value of a symbol.

    `right` is a part of the law's formula, and `wrong` is what a learner writes in its place; both
    are empty if the wrong step is not shown.
    """

    law: str
    symbol: str
    mistake: str
    function: Callable[[Any], float]
    right: str = ""
    wrong: str = ""


def find_siblings(p: Problem) -> Iterator[Candidate]:
    """Yield the wrong values from a similar function or a wrong symbol in a law."""
    for law, target in p.chain.steps:
        for row, value in _wrong_values(p, law, target):
            if isinstance(value, Worked) and row.right and row.right in law.template:
                edited = law._replace(template=law.template.replace(row.right, row.wrong))
                value = p.chain.by(edited, target, value.wrong[target])
            if candidate := usual(row.mistake, value, right=text_of(law)):
                yield candidate


def _wrong_values(p: Problem, law: AnyLaw, target: str) -> Iterator[tuple[Row, float | None]]:
    """Yield the rows for a law that is solved for a symbol, with the results that they lead to."""
    for row in FORMULAS:
        if (row.law, row.symbol) == (law.name, target):
            yield row, p.chain.solved(target, row.function)
    for row in SYMBOLS_CHANGED:
        if row.law == law.name and row.symbol != target:
            changed = row.function(p.chain.values[row.symbol])
            at = {**p.chain.values, row.symbol: changed}.__getitem__
            yield row, p.chain.solved(target, lambda _, at=at: law.solve(target, at))  # type: ignore[misc]


Cap = tuple[str, Callable[[float], float], str, str]  # of the half angle, and as in `Row`
WHOLE, HALVED = "sin^2({half-angle})", "sin^2({half-angle}/2)"
FLAT: tuple[Cap, ...] = (  # of a cone, projected or not
    ("one-forgotten", lambda half: 2 * PI * math.cos(half), "", ""),
    ("sine-not-squared", lambda half: PI * math.sin(half), WHOLE, "sin({half-angle})"),
    ("flat-disc-for-cap", lambda half: PI * math.tan(half) ** 2 if half < PI / 2 else math.nan,
        WHOLE, "tan({half-angle})^2"),
    ("flat-disc-for-cap", lambda half: PI * half**2 if half < PI / 2 else math.nan,
        HALVED, "({half-angle} / 2)^2"),
)  # fmt: skip
PROJECTED: tuple[Cap, ...] = (("solid-for-projected", geometry.cone, "", ""), *FLAT)
PLAIN: tuple[Cap, ...] = (
    ("solid-for-projected", geometry.projected_cone, "", ""),
    ("wrong-sphere", lambda half: 2 * geometry.cone(half), "", ""),
    *FLAT,
)
CONE, LOBE = "solid angle of a cone", "flux of a lobe divided by its peak intensity"


def _of_cones(law: str, symbol: str, caps: Sequence[Cap]) -> Iterator[Row]:
    """Yield the rows of a law of cones; an etendue is the area times the solid angle."""
    for mistake, wrong, *texts in caps:

        def function(at: At, wrong: Callable[[float], float] = wrong) -> float:
            return wrong(at("half-angle")) * (at("area") if symbol == "etendue" else 1.0)

        yield Row(law, symbol, mistake, function, *texts)


def _far_discs(rim: str) -> Function:
    """Return the etendue of two discs as if they were far apart, or one of them were small."""

    def etendue(at: At) -> float:
        far = at("distance") ** 2 + (at(rim) ** 2 if rim else 0.0)
        return float(PI**2 * at("radius") ** 2 * at("receiver-radius") ** 2 / far)

    return etendue


def _logarithm(ratio: Function, log: Callable[[float], float]) -> Function:
    return lambda at: log(ratio(at))


def _of_cosines(power: int) -> Function:
    return lambda at: at("irradiance") / at("cosine-off-axis") ** (4 - power)


def _mean_spot(at: At) -> Any:
    """Return the diameter of a spot whose mean is the limit, if the peak is at `limit-diameter`."""
    return at("limit-diameter") / math.sqrt(2)


def _reach(at: At, spot: float) -> Any:
    """Return the distance at which a uniform beam has a spot of a diameter."""
    return (spot - at("diameter")) / at("divergence")


def _reach_of_squares(at: At, spot: float) -> Any:
    """Return the distance at which a Gaussian beam has a spot of a diameter."""
    return math.sqrt(spot**2 - at("diameter") ** 2) / at("divergence")


LOGARITHMS: tuple[tuple[str, str, Function], ...] = (  # to base 2 of these ratios
    ("exposure value", "ev", lambda at: at("exposure-setting")),
    ("reflected light", "ev100", lambda at: at("luminance") * 100 / at("k")),
    ("incident light", "ev100", lambda at: at("illuminance") * 100 / at("c")),
)
# A law, the symbol that it is solved for, a mistake, and the wrong value from the other symbols (or
# from the right value).
FORMULAS: tuple[Row, ...] = (
    *_of_cones(CONE, "solid-angle", PLAIN),
    *_of_cones("projected solid angle of a cone", "projected-solid-angle", PROJECTED),
    *_of_cones("etendue of a cone", "etendue", PROJECTED),
    Row(CONE, "half-angle", "wrong-sphere", lambda at: geometry.cone_of(at("solid-angle") / 2)),
    Row(CONE, "half-angle", "flat-disc-for-cap", lambda at: math.sqrt(at("solid-angle") / PI)),
    Row(CONE, "half-angle", "flat-disc-for-cap",
        lambda at: math.atan(math.sqrt(at("solid-angle") / PI))),
    Row(CONE, "half-angle", "solid-for-projected",
        lambda at: math.asin(math.sqrt(at("solid-angle") / PI))),
    Row(LOBE, "solid-angle", "exponent-upside-down", lambda at: 2 * PI * (at("exponent") + 1)),
    Row("straight line to the source", "distance", "sum-for-difference",
        lambda at: math.sqrt(abs(at("height") ** 2 - at("lateral") ** 2)),
        "+ {lateral}", "- {lateral}"),
    *(Row(law, symbol, "log10-for-log2", _logarithm(ratio, log), "log2", name)
        for law, symbol, ratio in LOGARITHMS
        for name, log in (("log10", math.log10), ("ln", math.log))),
    Row("time behind a filter", "time", "stops-are-doublings",
        lambda at: at("unfiltered-time") * at("stops")),
    Row("time behind a filter", "time", "stops-are-doublings",
        lambda at: at("unfiltered-time") * at("stops") ** 2),
    Row("rectangular pyramid", "solid-angle", "flat-for-curved",
        lambda at: at("horizontal") * at("vertical")),
    Row("rectangular pyramid", "solid-angle", "flat-for-curved",
        lambda at: 4 * math.tan(at("horizontal") / 2) * math.tan(at("vertical") / 2)),
    *(Row("two coaxial discs", "etendue", "far-field-of-extended-source", _far_discs(rim))
        for rim in ("", "radius", "receiver-radius")),
    Row("mesopic luminance", "mesopic-luminance", "scotopic-for-mesopic",
        lambda at: at("luminance") * at("sp-ratio")),
    Row("mesopic luminance", "mesopic-luminance", "scotopic-for-mesopic",
        lambda at: at("luminance")),
    # The diameter of a spot is used as its radius.
    Row("mean irradiance of a spot", "irradiance", "diameter-for-radius",
        lambda at: at("irradiance") / 4),
    Row("mean exposure of a spot", "exposure", "diameter-for-radius",
        lambda at: at("exposure") / 4),
    *(Row(f"peak of a {profile} beam", "peak-irradiance", "diameter-for-radius",
        lambda at: at("peak-irradiance") / 4) for profile in ("gaussian", "uniform")),
    Row("spread of a uniform beam", "spot-diameter", "sum-for-root",
        lambda at: math.hypot(at("diameter"), at("divergence") * at("distance"))),
    Row("spread of a gaussian beam", "spot-diameter", "sum-for-root",
        lambda at: at("diameter") + at("divergence") * at("distance"),
        "sqrt({diameter}^2 + ({divergence} {distance})^2)", "{diameter} + {divergence} {distance}"),
    Row("spread of a gaussian beam", "hazard-distance", "uniform-for-gaussian",
        lambda at: _reach(at, _mean_spot(at))),
    Row("spread of a gaussian beam", "hazard-distance", "mean-for-peak",
        lambda at: _mean_spot(at) / at("divergence")),
    Row("spread of a gaussian beam", "hazard-distance", "sum-for-root",
        lambda at: _reach(at, at("limit-diameter"))),
    Row("spread of a uniform beam", "hazard-distance", "sum-for-root",
        lambda at: _reach_of_squares(at, at("limit-diameter"))),
    Row("spread of a uniform beam", "hazard-distance", "gaussian-for-uniform",
        lambda at: _reach_of_squares(at, math.sqrt(2) * at("limit-diameter"))),
    Row("room index", "room-index", "perimeter-for-sum", lambda at: at("room-index") / 2),
    Row("room index", "room-index", "mean-for-sum", lambda at: at("room-index") * 2),
    Row("luminaires to install", "luminaires-to-install", "rounded-down",
        lambda at: at("luminaires") // 1),
    Row("lumen method", "luminaires", "maintenance-upside-down",
        lambda at: at("luminaires") * at("maintenance") ** 2),
    Row("stops of a filter", "stops", "density-for-stops", lambda at: at("nd")),
    Row("stops of a filter", "nd", "density-for-stops", lambda at: at("stops")),
    *(Row("camera equation", "irradiance", "fewer-cosines", _of_cosines(power))
        for power in (1, 2, 3)),
)  # fmt: skip

# A law, a symbol in it, a mistake, and the value that is used for that of the symbol.
SYMBOLS_CHANGED: tuple[Row, ...] = (
    Row(LOBE, "exponent", "lobe-without-one", lambda n: n - 1,
        "({exponent} + 1)", "{exponent}"),
    Row("working f-number", "magnification", "magnification-forgotten", lambda m: 0.0),
    Row("working f-number", "magnification", "magnification-forgotten",
        lambda m: math.sqrt(1 + m) - 1),
    Row("guide number", "iso", "speed-without-root", lambda iso: iso**2 / 100,
        "sqrt(100 / {iso})", "100 / {iso}"),
    Row("time behind a filter", "stops", "filter-the-wrong-way", lambda stops: -stops),
    Row("exposure value at ISO 100, behind a filter", "stops", "filter-the-wrong-way",
        lambda stops: -stops, "+ {stops}", "- {stops}"),
    Row("spread of a gaussian beam", "diameter", "exit-forgotten", lambda _: 0.0,
        "{diameter}^2 + ", ""),
    Row("spread of a uniform beam", "diameter", "exit-forgotten", lambda _: 0.0,
        "{diameter} + ", ""),
)  # fmt: skip


OfPolar = Callable[[Any], Any]  # of the polar angle
Over = Callable[[float, float, OfPolar], float]  # an integral between polar angles

DEGREES = 180 / PI
SOLID = ("solid-angle", "projected-solid-angle")
POINTS = 64  # of the quadrature over polar angles
ACCURACY = 1e-6
OFF = 1e-3  # relative error of the quadrature, above which its edits say nothing


class Integral(NamedTuple):
    """An integral: its symbol, the integrand, the polar angles and the range of azimuths [rad].

    An integrand that is not axial has a function `by` which it is integrated instead.
    `has_cosine` is true if the cosine is a factor of the integrand.  A solid angle with a cosine is
    the projected one.
    """

    symbol: str
    function: OfPolar | None
    low: float
    high: float
    around: float = 2 * PI
    has_cosine: bool = False
    by: Over | None = None

    def text(self, mistake: str) -> str:
        ends = " to ".join(format_number(math.degrees(end)) for end in (self.low, self.high))
        return f"int {ELEMENTS[mistake]}, theta from {ends} deg"

    @property
    def with_cosine(self) -> str:
        return "cosine-added" if self.symbol not in SOLID else "solid-for-projected"

    @property
    def without_cosine(self) -> str:
        return "integrand-without-cosine" if self.symbol not in SOLID else "solid-for-projected"

    def over(self, low: float, high: float, weight: OfPolar = sin) -> float:
        """Return the integral between polar angles, with a weight of the element of solid angle."""
        if self.function is None:
            assert self.by is not None
            return self.by(low, high, weight)
        function = self.function
        return self.around * integral(lambda t: function(t) * weight(t), low, high, POINTS)


ELEMENTS = {  # wrong integrands, with the element of solid angle
    "sine-forgotten": "f dtheta dphi",
    "sine-twice": "f sin(theta)^2 dtheta dphi",
    "cosine-added": "f cos(theta) sin(theta) dtheta dphi",
    "integrand-without-cosine": "f/cos(theta) sin(theta) dtheta dphi",
    "azimuth-forgotten": "f sin(theta) dtheta",
    "degrees-in-integral": "f dtheta dphi, theta in degrees",
}


def find_integrals(p: Problem) -> Iterator[Candidate]:
    """Yield the wrong values from an edit of the integral that gives the result."""
    for whole in filter(None, (_expression(p), _zone(p), _cone(p), _sky(p))):
        right = p.chain.values.get(whole.symbol, p.right)
        own = _found(whole.over, whole.low, whole.high)
        if not right or not own or abs(own / (right / _unit(right, own)) - 1) > OFF:
            continue
        for name, size in _edits(whole, own):
            if size is None:
                continue
            value = p.chain.after(whole.symbol, right * size / own)
            if value is not None and name in ELEMENTS:
                text = f"{whole.text(name)} = {format_number(size)}"
                value = Worked(value, p.chain, {}, text=text)
            if candidate := usual(name, value):
                yield candidate


def _unit(right: float, own: float) -> float:
    """Return the power of ten between the unit of an integrand and the SI unit."""
    return 10.0 ** round(math.log10(abs(right / own)))


def _found(over: Over, low: float, high: float, weight: OfPolar = sin) -> float | None:
    """Return an integral, or None if it does not converge."""
    try:
        return over(low, high, weight)
    except FAILURES:
        return None


def _edits(i: Integral, whole: float) -> Iterator[tuple[str, float | None]]:
    """Yield the mistakes and the wrong values of an integral with the value `whole`."""
    low, high = i.low, i.high
    yield i.with_cosine, _found(i.over, low, high, lambda t: sin(t) * cos(t))
    if i.has_cosine:
        yield i.without_cosine, _found(i.over, low, high, lambda t: sin(t) / cos(t))
        yield "sine-forgotten", _found(i.over, low, high, lambda t: 1 / cos(t))
    yield "sine-forgotten", _found(i.over, low, high, lambda _: 1.0)
    yield "degrees-in-integral", _found(i.over, low, high, lambda t: DEGREES * sin(t))
    yield "degrees-in-integral", _found(i.over, low, high, lambda _: DEGREES)
    yield "sine-twice", _found(i.over, low, high, lambda t: sin(t) ** 2)
    yield "azimuth-forgotten", whole / i.around
    yield "half-azimuth", whole / 2
    if i.around < 2 * PI:
        yield "azimuth-forgotten", whole / i.around * 2 * PI
    if high == PI and not low:
        yield "whole-for-half", _found(i.over, 0, PI / 2)
        return
    yield from _limits(i, whole)


def _limits(i: Integral, whole: float) -> Iterator[tuple[str, float | None]]:
    """Yield the mistakes in the limits of an integral with the value `whole`."""
    low, high = i.low, i.high
    if high == PI / 2:
        yield "whole-for-half", 2 * whole
        yield "whole-for-half", _found(i.over, low, PI)
    else:
        yield "angle-from-surface", _found(i.over, low, high, cos)
        yield "wrong-limits", _found(i.over, low, PI / 2)
        yield "full-for-half", _found(i.over, low / 2, high / 2)
        yield "full-for-half", _found(i.over, 2 * low, min(2 * high, PI))
    if low:
        if inner := _found(i.over, 0, low):
            for size in (whole + 2 * inner, whole + inner, inner):
                yield "zone-of-caps", size
        yield "zone-of-caps", _found(i.over, 0, high - low)
        if i.symbol == "solid-angle":
            yield "cosines-added", i.around * (math.cos(low) + math.cos(high))


# ---------------------------------------------------------------------------------------------
# The integrals of a problem


def _expression(p: Problem) -> Integral | None:
    """Return the integral of an expression typed by the user."""
    text = p.question.expression
    if not text:
        return None
    from radcalc.calculators.integrate import directions
    from radcalc.geometry.numerics.cubature import over_directions
    from radcalc.geometry.numerics.expression import Expression

    (low, high), azimuth = directions(p.given)
    expression = Expression(text)
    around = azimuth[1] - azimuth[0]
    has_cosine = any(cosine in text for cosine in ("cos(theta)", "z"))
    if not expression.uses:
        size = float(expression({}))
        return Integral("integral", lambda _: size, low, high, around, has_cosine)

    def over(low: float, high: float, weight: OfPolar) -> float:
        def weighted(at: Any) -> Any:
            return expression(at) * weight(at["theta"]) / sin(at["theta"])

        cost, is_axial = expression.cost, expression.is_axial
        return over_directions(
            weighted, (low, high), azimuth, ACCURACY, cost, is_axial, accepted=OFF
        ).value

    return Integral("integral", None, low, high, around, has_cosine, over)


def _zone(p: Problem) -> Integral | None:
    """Return the integral of 1, or of the cosine, over a zone."""
    ends = p.given["polar"].value if "polar" in p.given else None
    if p.question.expression or not isinstance(ends, tuple):
        return None
    around = p.given["azimuth"].value if "azimuth" in p.given else (0.0, 2 * PI)
    if not isinstance(around, tuple):
        return None
    return _of_sphere(p.target.name, ends[0], ends[1], around[1] - around[0])


def _cone(p: Problem) -> Integral | None:
    """Return the integral of 1, or of the cosine, over a cone."""
    half = p.chain.values.get("half-angle")
    names = [name for name in SOLID if name in p.chain.symbols]
    return _of_sphere(names[0], 0.0, half, 2 * PI) if half and names else None


def _of_sphere(symbol: str, low: float, high: float, around: float) -> Integral | None:
    if symbol == "projected-solid-angle":
        return Integral(symbol, lambda t: max(math.cos(t), 0.0), low, high, around, True)
    return Integral("solid-angle", lambda _: 1.0, low, high, around)


def _sky(p: Problem) -> Integral | None:
    """Return the integral of the sky's radiance that the ground receives."""
    if not p.lists("sky") or "horizontal-sky" not in p.chain.symbols:
        return None
    from radcalc.geometry.models import relative_luminance, sky_type

    sky = sky_type(p.question.shape or "overcast")
    if sky.follows_sun:
        return None

    def received(theta: float) -> float:
        return float(relative_luminance(sky, theta, 0.0)) * math.cos(theta)

    return Integral("horizontal-sky", received, 0.0, PI / 2, has_cosine=True)
