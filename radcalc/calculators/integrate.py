"""The integral of an expression over a part of the sphere."""

import math
import re
from typing import NamedTuple

from radcalc.answer import Answer
from radcalc.calculators.results import value
from radcalc.derivation import Formula, format_angle, format_number
from radcalc.errors import ConditionError, MissingInput, listed, mention, quote
from radcalc.geometry.directions import TURN
from radcalc.geometry.numerics.cubature import POINTS, narrowest, of_constant, over_directions
from radcalc.geometry.numerics.expression import Expression
from radcalc.geometry.solid import check_zone, zone
from radcalc.given import Inputs
from radcalc.quantities.light import NONE, PHOTON, coherent_unit, describe
from radcalc.quantities.light import read as read_light
from radcalc.quantities.units import composed
from radcalc.units.dimensions import SOLID_ANGLE, times
from radcalc.units.table import NUMBER, Dimension, resolve

FINEST, COARSEST = 1e-13, 0.1  # accuracies that can be asked for
USUAL = 1e-9
DIRECTIONS = ("sphere", "hemisphere", "half-angle", "polar")
SINE = "sin(theta) of the solid angle is included: that in the expression comes on top of it"
INTEGRAL = Formula(
    "integral over directions", "I = integral of f(theta, phi) sin(theta) dtheta dphi"
)


WITH_SINE = re.compile(r"\bsin\((theta|[θϑ])\)")


class Integrand(NamedTuple):
    """What an expression is in, and what its integral over solid angle then is.

    `factor` makes coherent SI of the expression; `dimension` and `unit` are those of the integral.
    """

    factor: float = 1.0
    dimension: Dimension = SOLID_ANGLE
    unit: str = "sr"
    said: str = ""


BARE = Integrand()


def integrand(text: str) -> Integrand:
    """Read the unit of an expression: an intensity, a radiance or 1/sr."""
    unit = resolve(text)
    reading = read_light(unit)
    if unit.dimension == times(NUMBER, SOLID_ANGLE, -1):
        return Integrand(unit.factor, NUMBER, "1")
    if reading is None or reading.retinal or not reading.solid_angle:
        raise ConditionError(
            f"{describe(unit)} is nothing per solid angle, to be integrated over it",
            "an intensity or a radiance: cd, W/sr, cd/m2, W/m2/sr; or 1/sr",
        )
    whole = resolve(f"({text}).sr")
    is_customary = reading.kind == PHOTON or reading.axis != NONE
    shown = composed(whole)[0] if is_customary else coherent_unit(whole)
    said = f"the expression is in {quote(text)}"
    if reading.area:
        said += (
            ": with the factor cos(theta) its integral is the irradiance of a plane whose normal "
            "is +z, without one that on the cross section of a small sphere (spherical irradiance)"
        )
    return Integrand(unit.factor, whole.dimension, shown, said)


def integrate(text: str, given: Inputs, of: Integrand = BARE) -> Answer:
    """Integrate an expression in theta, phi, x, y, z over a part of the sphere.

    `given` has one of `DIRECTIONS`, and may have an azimuth and an accuracy; `of` is what the
    expression is in.
    """
    polar, azimuth = directions(given)
    accuracy = given["accuracy"].value if "accuracy" in given else USUAL
    check_zone(*polar, azimuth[1] - azimuth[0])
    if not FINEST <= accuracy <= COARSEST:
        raise ConditionError(
            f"an accuracy of {accuracy:g} is not possible", f"from {FINEST:g} to {COARSEST:g}"
        )
    expression = Expression(text)
    if expression.uses:
        found = over_directions(
            expression,
            polar,
            azimuth,
            accuracy,
            expression.cost,
            expression.is_axial,
            steps=expression.steps(polar, azimuth),
        )
    else:
        found = of_constant(expression, zone(*polar, azimuth[1] - azimuth[0]))
    values = [
        value(name, size * of.factor, of.unit)._replace(dimensions=(of.dimension,))
        for name, size in (("integral", found.value), ("error", found.error))
    ]
    narrow = [
        f"{format_angle(width)} in {name}"
        for name, width in zip(
            ("theta", "phi"), narrowest(polar, azimuth, expression.is_axial), strict=True
        )
        if width
    ]
    said = [
        "theta is the polar angle from +z, phi the azimuth from +x, in radians (from "
        f"{format_number(azimuth[0])} to {format_number(azimuth[1])}); x, y, z the unit vector",
        f"peaks narrower than {' or '.join(narrow)} may be missed",
    ]
    if of.said:
        said.append(of.said)
    if expression.comparisons:
        said.append(f"1 where it holds, 0 elsewhere: {listed(expression.comparisons)}")
    (t0, t1), (p0, p1) = ([math.degrees(x) for x in ends] for ends in (polar, azimuth))
    points = f"{POINTS}" if expression.is_axial else f"{POINTS} x {POINTS}"
    integral = format_number(found.value * of.factor)
    step = INTEGRAL.told(
        f"f = {quote(text)}, theta from {format_number(t0)} to {format_number(t1)} deg, phi from "
        f"{format_number(p0)} to {format_number(p1)} deg; I = {integral} {of.unit}, "
        f"from {found.cells} cells of {points} points of Gauss and Legendre"
    )
    notes = [SINE] if WITH_SINE.search(text) else []
    return Answer(values, said, notes, [step])


def directions(given: Inputs) -> tuple[tuple[float, float], tuple[float, float]]:
    """The polar angles and the azimuths [rad] to integrate over."""
    return _polar(given), given["azimuth"].value if "azimuth" in given else (0.0, TURN)


def _polar(given: Inputs) -> tuple[float, float]:
    """The polar angles [rad] to integrate over."""
    where = [name for name in DIRECTIONS if name in given]
    ways = mention("{sphere}, {hemisphere}, {half-angle=30deg} or {polar=30deg:60deg}")
    if not where:
        raise MissingInput("the directions to integrate over are missing", ways)
    if len(where) > 1:
        raise ConditionError("the directions to integrate over are given twice", f"one of {ways}")
    if where[0] == "polar":
        low, high = given["polar"].value
        return low, high
    if where[0] == "half-angle":
        return 0.0, given["half-angle"].value
    return 0.0, math.pi if where[0] == "sphere" else math.pi / 2
