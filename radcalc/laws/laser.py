"""A laser beam with its full divergence and its diameter at the exit.

A Gaussian beam has its waist at the exit, and diameters at 1/e^2 of the peak; it follows from
w(z)^2 = w_0^2 + (phi z / 2)^2.  The peak of a uniform beam, 1.27 Phi / D_s^2, is also that of a
Gaussian beam with diameters at 1/e of the peak.  The limit is the peak irradiance at the hazard
distance, beyond which it is less.  A receiver is a round aperture on the axis.

A divergence is small: phi d is within 0.6 % of 2 d tan(phi/2) up to 0.25 rad.
"""

import operator
from typing import Any

from radcalc.geometry import cones
from radcalc.laws.common import ENERGY, EXPOSURE
from radcalc.laws.law import AnyLaw, At, Relation, law, relation
from radcalc.maths import expm1, hypot, larger, log1p, smaller, sqrt, square
from radcalc.quantities.symbols import GAUSSIAN, UNIFORM
from radcalc.units.numbers import EXACT

WAIST = "Gaussian beam with its waist at the exit"
PROFILE = "Gaussian beam: E(r) = E_0 exp(-8 r^2 / D_s^2)"
RANGE = "range equation of laser safety"
WIDER = "a wider spot, or less of the diameter, the divergence or the distance"
HAZARD, DISTANCE = "hazard-distance", "distance"
EXIT = law("spot at the laser's exit", "{spot-diameter} = {diameter}")


def _leg(whole: Any, part: Any) -> Any:
    return sqrt((whole - part) * (whole + part))


def _widened(far: Any, near: Any) -> Any:
    cones.refuse(far < near, "the beam would become narrower with distance", WIDER)
    return far


SPREADS = {  # sum and difference of diameters, template of the formula, and its reference
    GAUSSIAN: (hypot, _leg, "sqrt({diameter}^2 + ({divergence} {%s})^2)", WAIST),
    UNIFORM: (operator.add, operator.sub, "{diameter} + {divergence} {%s}", RANGE),
}


def _spread(profile: str, spot: str, distance: str) -> Relation:
    """Return the law of a beam's diameter; beams wider than their limit have it at the exit."""
    add, take, template, reference = SPREADS[profile]

    def widening(at: At) -> Any:
        return at("divergence") * at(distance)

    def remaining(at: At, part: Any) -> Any:
        return take(_widened(at(spot), part), part)

    def before(at: At) -> Any:
        problem = "the divergence alone makes such a wide spot, even of a beam without width"
        is_all = at(spot) <= widening(at) * (1 + EXACT)
        cones.refuse(is_all, problem, WIDER)
        return take(at(spot), widening(at))

    def away(at: At) -> Any:
        if distance == HAZARD:
            return take(larger(at(spot), at("diameter")), at("diameter"))
        return remaining(at, at("diameter"))

    return relation(
        f"spread of a {profile} beam",
        f"{{{spot}}} = {template % distance}",
        {
            spot: lambda at: add(at("diameter"), widening(at)),
            "diameter": before,
            "divergence": lambda at: remaining(at, at("diameter")) / at(distance),
            distance: lambda at: away(at) / at("divergence"),
        },
        reference,
    )


def _received_share(at: At) -> Any:
    part = at("received-flux") / at("flux")
    cones.refuse(part >= 1, "the received flux is not less than the beam's", "less of it")
    return part


def _gaussian_share(at: At) -> Any:
    return -expm1(-2 * square(at("receiver-diameter") / at("spot-diameter")))


def _uniform_share(at: At) -> Any:
    return square(smaller(1.0, at("receiver-diameter") / at("spot-diameter")))


def _aperture_over_spot(at: At) -> Any:
    return sqrt(-log1p(-_received_share(at)) / 2)


RECEIVED = {
    GAUSSIAN: relation(
        "flux of a gaussian beam through an aperture",
        "{received-flux} = {flux} (1 - exp(-2 {receiver-diameter}^2 / {spot-diameter}^2))",
        {
            "received-flux": lambda at: at("flux") * _gaussian_share(at),
            "flux": lambda at: at("received-flux") / _gaussian_share(at),
            "receiver-diameter": lambda at: at("spot-diameter") * _aperture_over_spot(at),
            "spot-diameter": lambda at: at("receiver-diameter") / _aperture_over_spot(at),
        },
        PROFILE,
    ),
    UNIFORM: relation(
        "flux of a uniform beam through an aperture",
        "{received-flux} = {flux} min(1, {receiver-diameter}^2 / {spot-diameter}^2)",
        {
            "received-flux": lambda at: at("flux") * _uniform_share(at),
            "flux": lambda at: at("received-flux") / _uniform_share(at),
            "receiver-diameter": lambda at: at("spot-diameter") * sqrt(_received_share(at)),
            "spot-diameter": lambda at: at("receiver-diameter") / sqrt(_received_share(at)),
        },
    ),
}
SPOT = [
    law("mean irradiance of a spot", "{irradiance} = 4 {flux} / (pi {spot-diameter}^2)"),
    law("mean exposure of a spot", "{exposure} = 4 {energy} / (pi {spot-diameter}^2)"),
    ENERGY,
    EXPOSURE,
]
PEAKS = {
    GAUSSIAN: [
        law(
            "peak of a gaussian beam",
            "{peak-irradiance} = 8 {flux} / (pi {spot-diameter}^2)",
            PROFILE,
        ),
        law("peak over the mean of a gaussian beam", "{peak-irradiance} = 2 {irradiance}", PROFILE),
        law(
            "limit of a gaussian beam's peak",
            "{limit} = 8 {flux} / (pi {limit-diameter}^2)",
            PROFILE,
        ),
    ],
    UNIFORM: [
        law("peak of a uniform beam", "{peak-irradiance} = 4 {flux} / (pi {spot-diameter}^2)"),
        law("peak and mean of a uniform beam", "{peak-irradiance} = {irradiance}"),
        law("limit of a uniform beam", "{limit} = 4 {flux} / (pi {limit-diameter}^2)", RANGE),
    ],
}
SPREAD = {profile: _spread(profile, "spot-diameter", DISTANCE) for profile in SPREADS}
REACH = {profile: _spread(profile, "limit-diameter", HAZARD) for profile in SPREADS}


def laws_of(profile: str, with_distance: bool) -> list[AnyLaw]:
    """Choose the laws of a beam.

    Parameters
    ----------
    profile : {"gaussian", "uniform"}
        Profile of its irradiance.
    with_distance : bool
        Whether the spot is at a distance, not at the laser's exit.

    Returns
    -------
    list of Law or Relation
        Laws of the spot, its peak, its limit and a receiver.

    Examples
    --------
    >>> laws_of("uniform", with_distance=False)[0].template
    '{spot-diameter} = {diameter}'
    """
    spread = SPREAD[profile] if with_distance else EXIT
    return [spread, *SPOT, *PEAKS[profile], REACH[profile], RECEIVED[profile]]
