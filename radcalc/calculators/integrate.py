"""The integral of an expression over a part of the sphere."""

import math
import re
from typing import NamedTuple

from radcalc.answer import Answer, Formula, format_angle, format_number
from radcalc.calculators.page import Operand, Page, text
from radcalc.calculators.results import value
from radcalc.errors import ConditionError, MissingInput, add, listed, mention, one_of, quote
from radcalc.geometry.numerics.cubature import POINTS, narrowest, of_constant, over_directions
from radcalc.geometry.numerics.expression import Expression
from radcalc.geometry.projections import TURN
from radcalc.geometry.solid import check_zone, zone
from radcalc.inputs import Inputs
from radcalc.quantities import NONE, PHOTON, coherent_unit, describe
from radcalc.quantities import read as read_light
from radcalc.quantities.names import composed
from radcalc.units import NUMBER, Dimension
from radcalc.units.dimensions import SOLID_ANGLE, times
from radcalc.units.table import resolve

FINEST, COARSEST = 1e-13, 0.1  # the range of accuracies
USUAL = 1e-9
DIRECTIONS = ("sphere", "hemisphere", "half-angle", "polar")
SINE = "the integral includes sin(theta) of the solid angle, in addition to that in the expression"
INTEGRAL = Formula(
    "integral over directions", "I = integral of f(theta, phi) sin(theta) dtheta dphi"
)


WITH_SINE = re.compile(r"\bsin\((theta|[θϑ])\)")

PAGE = Page(
    about="Integrate a function of direction over a part of the sphere.",
    operand=Operand("expression", "EXPRESSION"),
    sections={
        "Directions": ("sphere", "hemisphere", "half-angle", "polar", "azimuth"),
        "Results": (
            text("unit", "cd", "Unit of the expression: a unit of intensity or radiance, or 1/sr."),
            "accuracy",
        ),
    },
    texts={
        "half-angle": "Cone with this half angle about +z.",
        "hemisphere": "Hemisphere about +z.",
        "polar": ("30deg:60deg", "Zone between two polar angles."),
        "azimuth": ("0deg:90deg", "Range of azimuths (default: all)."),
    },
    draws=True,
    takes_lines=False,
    examples=(
        "cos(theta) hemisphere=",
        "100*cos(theta)**10 polar=0deg:45deg",
        "'max(x, 0)' sphere= accuracy=1e-6",
        "(theta<30*deg)*100 sphere= unit=cd",
        "cos(theta)**2 hemisphere= plot=",
        "exp(-(theta/(10*deg))**2) half-angle=60deg get=integral:deg2",
    ),
    remarks="""
    EXPRESSION is made of theta (polar angle) and phi (azimuth), x, y, z (the unit vector),
    numbers, pi, e, the units deg and rad, + - * / **, brackets, sin cos tan asin acos atan atan2
    sinh cosh tanh exp ln log10 log2 sqrt abs min max, and comparisons with < <= > >= (1 if true,
    0 if false).  An angle needs a unit: cos(45 deg), (theta<0.5*rad).  An expression that starts
    with a minus needs brackets: '(-x)'.  The integral is over solid angle: the factor sin(theta)
    is supplied; do not write it.  An integral that does not converge is refused.

    With {unit} the integral of an intensity is a flux.  The integral of a radiance is the
    irradiance of a plane with the normal +z only if the expression has the factor cos(theta).
    """,
)


class Integrand(NamedTuple):
    """The unit of an expression, and that of its integral over solid angle.

    `factor` converts the expression to coherent SI; `dimension` and `unit` are the integral's.
    """

    factor: float = 1.0
    dimension: Dimension = SOLID_ANGLE
    unit: str = "sr"
    assumption: str = ""


BARE = Integrand()


def integrand(text: str) -> Integrand:
    """Read the unit of an expression: an intensity, a radiance or 1/sr."""
    unit = resolve(text)
    reading = read_light(unit)
    if unit.dimension == times(NUMBER, SOLID_ANGLE, -1):
        return Integrand(unit.factor, NUMBER, "1")
    if reading is None or reading.retinal or not reading.solid_angle:
        raise ConditionError(
            f"{describe(unit)} is not a quantity per solid angle",
            "an intensity or a radiance: cd, W/sr, cd/m2, W/m2/sr; or 1/sr",
            [add("unit", f"{text}/sr", "the unit of the expression, not of its integral")],
        )
    integrated = resolve(f"({text}).sr")
    is_customary = reading.kind == PHOTON or reading.axis != NONE
    integral_unit = composed(integrated)[0] if is_customary else coherent_unit(integrated)
    assumption = f"the expression is in {quote(text)}"
    if reading.area:
        assumption += (
            ": with the factor cos(theta) its integral is the irradiance of a plane with the "
            "normal +z, without it the spherical irradiance (on the cross section of a small "
            "sphere)"
        )
    return Integrand(unit.factor, integrated.dimension, integral_unit, assumption)


def integrate(text: str, given: Inputs, of: Integrand = BARE) -> Answer:
    """Integrate an expression in theta, phi, x, y, z over a part of the sphere."""
    polar, azimuth = directions(given)
    accuracy = given["accuracy"].value if "accuracy" in given else USUAL
    check_zone(*polar, azimuth[1] - azimuth[0])
    if not FINEST <= accuracy <= COARSEST:
        limit = f"from {FINEST:g} to {COARSEST:g}"
        message = f"an accuracy of {accuracy:g} is out of range"
        raise ConditionError(message, limit)
    expression = Expression(text)
    if expression.uses:
        integrated = over_directions(
            expression,
            polar,
            azimuth,
            accuracy,
            expression.cost,
            expression.is_axial,
            steps=expression.steps(polar, azimuth),
        )
    else:
        integrated = of_constant(expression, zone(*polar, azimuth[1] - azimuth[0]))
    values = [
        value(name, size * of.factor, of.unit)._replace(dimensions=(of.dimension,))
        for name, size in (("integral", integrated.value), ("error", integrated.error))
    ]
    narrow = [
        f"{format_angle(width)} in {name}"
        for name, width in zip(
            ("theta", "phi"), narrowest(polar, azimuth, expression.is_axial), strict=True
        )
        if width
    ]
    assumptions = [
        "theta is the polar angle from +z, phi the azimuth from +x, in radians (from "
        f"{format_number(azimuth[0])} to {format_number(azimuth[1])}); x, y, z are the unit vector",
        f"peaks narrower than {' or '.join(narrow)} may be missed",
    ]
    if of.assumption:
        assumptions.append(of.assumption)
    if expression.comparisons:
        assumptions.append(
            f"comparisons are 1 where they hold, 0 elsewhere: {listed(expression.comparisons)}"
        )
    (t0, t1), (p0, p1) = ([math.degrees(x) for x in ends] for ends in (polar, azimuth))
    points = f"{POINTS}" if expression.is_axial else f"{POINTS} x {POINTS}"
    integral = format_number(integrated.value * of.factor)
    step = INTEGRAL.with_numbers(
        f"f = {quote(text)}, theta from {format_number(t0)} to {format_number(t1)} deg, phi from "
        f"{format_number(p0)} to {format_number(p1)} deg; I = {integral} {of.unit}, "
        f"from {integrated.cells} cells of {points} Gauss-Legendre points"
    )
    notes = [SINE] if WITH_SINE.search(text) else []
    return Answer(values, assumptions, notes, [step])


def directions(given: Inputs) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the polar angles and the azimuths [rad] to integrate over."""
    return _polar(given), given["azimuth"].value if "azimuth" in given else (0.0, TURN)


def _polar(given: Inputs) -> tuple[float, float]:
    where = [name for name in DIRECTIONS if name in given]
    ways = mention("{sphere}, {hemisphere}, {half-angle=30deg} or {polar=30deg:60deg}")
    if not where:
        raise MissingInput("the directions to integrate over are missing", ways)
    if len(where) > 1:
        raise ConditionError("the directions to integrate over are given twice", one_of(*where))
    if where[0] == "polar":
        low, high = given["polar"].value
        return low, high
    if where[0] == "half-angle":
        return 0.0, given["half-angle"].value
    return 0.0, math.pi if where[0] == "sphere" else math.pi / 2
