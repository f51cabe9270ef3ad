"""Mistakes in an integral over directions: the element of solid angle, a cosine, the limits.

The result, or a symbol that it depends on, is the integral of f(theta, phi) sin(theta) dtheta dphi.
It is computed again with each edit.
"""

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from radcalc.derivation import format_number
from radcalc.geometry.numerics.quadrature import integral
from radcalc.homework.chain import FAILURES, Worked
from radcalc.homework.problem import Candidate, Problem, usual
from radcalc.maths import cos, sin

Function = Callable[[Any], Any]  # of the polar angle
Over = Callable[[float, float, Function], float]  # an integral between polar angles
PI = math.pi
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
    function: Function | None
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

    def over(self, low: float, high: float, weight: Function = sin) -> float:
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


def find(p: Problem) -> Iterator[Candidate]:
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


def _found(over: Over, low: float, high: float, weight: Function = sin) -> float | None:
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

    def over(low: float, high: float, weight: Function) -> float:
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
    from radcalc.geometry.sky import relative_luminance, sky_type

    sky = sky_type(p.question.shape or "overcast")
    if sky.follows_sun:
        return None

    def received(theta: float) -> float:
        return float(relative_luminance(sky, theta, 0.0)) * math.cos(theta)

    return Integral("horizontal-sky", received, 0.0, PI / 2, has_cosine=True)
