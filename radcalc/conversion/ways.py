"""The spatial conditions that lead from one geometry to another."""

from collections.abc import Callable

from radcalc.conversion import geometric
from radcalc.conversion.conditions import AREA, CONE, DISTANCE, REFLECTANCE, Conditions, Factor
from radcalc.tuples import NamedTuple

Supply = dict[str, Callable[[Conditions], Factor]]


class Way(NamedTuple):
    """The powers of the conditions that lead from one geometry to another.

    `supply` gives the factor of each.
    """

    powers: dict[str, int]
    supply: Supply
    is_suggested: bool = True
    extends: bool = True  # whether it is suggested if part of it is given
    is_tilted: bool = False  # whether the source may be seen obliquely


def _area(conditions: Conditions) -> Factor:
    return geometric.area(conditions.take(AREA))


def _front_area(conditions: Conditions) -> Factor:
    factor = geometric.area(conditions.take(AREA))
    if "tilt" in conditions.given:
        return factor
    return factor._replace(assumption=f"{factor.assumption}, seen along its normal")


def _far_area(conditions: Conditions) -> Factor:
    area, given = conditions.take(AREA), conditions.given
    return geometric.far_area(area, given[DISTANCE], given.get("incidence"), given.get("tilt"))


def _aperture(conditions: Conditions) -> Factor:
    area, given = conditions.take(AREA), conditions.given
    return geometric.aperture(area, given[DISTANCE], given.get("incidence"))


def _cone(conditions: Conditions) -> Factor:
    return geometric.solid_angle(conditions.take(CONE))


def _projected_cone(conditions: Conditions) -> Factor:
    turn = conditions.use("tilt") or conditions.use("incidence")
    return geometric.projected_solid_angle(conditions.take(CONE), turn)


def _inverse_square(conditions: Conditions) -> Factor:
    return geometric.inverse_square(conditions.take(DISTANCE), conditions.use("incidence"))


def _reflector(conditions: Conditions) -> Factor:
    return geometric.reflector(conditions.take(REFLECTANCE))


def _disc(conditions: Conditions) -> Factor:
    source, distance = conditions.take(AREA), conditions.take(DISTANCE)
    return geometric.disc(source, distance, conditions.use("incidence"))


PLAIN: Supply = {AREA: _area, CONE: _cone, DISTANCE: _inverse_square, REFLECTANCE: _reflector}
AT_RADIANCE: Supply = {**PLAIN, CONE: _projected_cone}  # with a reflector, the cone of the lamp
IN_FRONT: Supply = {**PLAIN, AREA: _front_area}
FAR: Supply = {**PLAIN, AREA: _far_area}
RECEIVED: Supply = {**PLAIN, AREA: _aperture}
REFLECTED = Way({REFLECTANCE: 1}, {REFLECTANCE: lambda c: geometric.reflected(c.take(REFLECTANCE))})
DISC = Way({DISTANCE: -1}, {DISTANCE: _disc})  # exact, of a radius or diameter

FLUX, INTENSITY, IRRADIANCE, RADIANCE = (0, 0), (0, 1), (1, 0), (1, 1)
# From the first geometry (powers of 1/area and 1/solid angle) to the second; in reverse, the powers
# change sign.  Of the ways that begin with the given conditions, the first two are suggested.
WAYS = {
    (FLUX, INTENSITY): (Way({CONE: -1}, PLAIN), Way({AREA: -1, DISTANCE: -1}, RECEIVED, False)),
    (FLUX, IRRADIANCE): (Way({AREA: -1}, PLAIN), Way({CONE: -1, DISTANCE: 1}, PLAIN)),
    (FLUX, RADIANCE): (
        Way({AREA: -1, REFLECTANCE: 1}, PLAIN),
        Way({AREA: -1, CONE: -1}, AT_RADIANCE),
        Way({CONE: -1, DISTANCE: 1, REFLECTANCE: 1}, PLAIN, False, False),
    ),
    (INTENSITY, IRRADIANCE): (
        Way({DISTANCE: 1}, PLAIN),
        Way({AREA: -1, CONE: 1}, PLAIN, False, False),
    ),
    (INTENSITY, RADIANCE): (
        Way({AREA: -1}, IN_FRONT, is_tilted=True),
        Way({DISTANCE: 1, REFLECTANCE: 1}, PLAIN),
        Way({AREA: -1, CONE: 1, REFLECTANCE: 1}, PLAIN, False, False),
    ),
    (IRRADIANCE, RADIANCE): (
        Way({REFLECTANCE: 1}, PLAIN),
        Way({CONE: -1}, AT_RADIANCE),
        Way({AREA: -1, DISTANCE: -1}, FAR, False, is_tilted=True),
    ),
}


def ways_between(start: tuple[int, int], end: tuple[int, int]) -> tuple[tuple[Way, ...], int]:
    """Return the ways between two geometries, and the sign of their powers in that direction."""
    if (start, end) in WAYS:
        return WAYS[start, end], 1
    return WAYS.get((end, start), ()), -1
