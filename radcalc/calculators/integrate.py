"""The integral of an expression over a part of the sphere."""

import math

from radcalc.answer import Answer, Step, Value
from radcalc.conversion.conditions import show
from radcalc.errors import ConditionError, quote
from radcalc.geometry.numerics.cubature import FIRST, POINTS, of_constant, over_directions
from radcalc.geometry.numerics.expression import Expression
from radcalc.geometry.solid import check_zone, zone
from radcalc.quantities.light import SOLID_ANGLE

Interval = tuple[float, float]
TURN = 2 * math.pi
FINEST, COARSEST = 1e-13, 0.1  # accuracies that can be asked for


def integrate(
    text: str, polar: Interval, azimuth: Interval = (0.0, TURN), accuracy: float = 1e-9
) -> Answer:
    """Integrate an expression in theta, phi, x, y, z over intervals of two angles [rad]."""
    check_zone(*polar, azimuth[1] - azimuth[0])
    if not FINEST <= accuracy <= COARSEST:
        raise ConditionError(
            f"an accuracy of {accuracy:g} is not possible", f"from {FINEST:g} to {COARSEST:g}"
        )
    expression = Expression(text)
    if expression.uses:
        found = over_directions(expression, polar, azimuth, accuracy)
    else:
        found = of_constant(expression, zone(*polar, azimuth[1] - azimuth[0]))
    width, turn = (math.degrees(end - start) for start, end in (polar, azimuth))
    values = [
        Value("integral", "integral", "∫f dΩ", found.value, (SOLID_ANGLE,), ("sr",)),
        Value("error", "estimate of the error", "", found.error, (SOLID_ANGLE,), ("sr",)),
    ]
    points = [2 * n * POINTS for n in FIRST]
    said = [
        "theta is the polar angle from +z, phi the azimuth from +x, in radians (from "
        f"{show(azimuth[0])} to {show(azimuth[1])}); x, y, z the unit vector",
        f"peaks narrower than {show(width / points[0])} deg in theta or {show(turn / points[1])} "
        "deg in phi may be missed",
    ]
    (t0, t1), (p0, p1) = ([math.degrees(x) for x in ends] for ends in (polar, azimuth))
    step = Step(
        "integral over directions",
        "I = integral of f(theta, phi) sin(theta) dtheta dphi",
        f"f = {quote(text)}, theta from {show(t0)} to {show(t1)} deg, phi from {show(p0)} to "
        f"{show(p1)} deg; I = {show(found.value)} sr, from {found.cells} cells of "
        f"{POINTS} x {POINTS} points of Gauss and Legendre",
    )
    return values, said, [], [step]
