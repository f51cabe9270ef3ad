"""The table of ways between geometries, compared with a search for all possible ways.

A way multiplies by some conditions and divides by others.  The change of the powers of 1/area
and 1/solid angle by each condition is known, so all sets of exponents can be tried.
"""

from itertools import permutations, product

import pytest

from radcalc.conversion import geometric
from radcalc.conversion.geometric import (
    AREA,
    CONE,
    DISC,
    DISTANCE,
    FLUX,
    INTENSITY,
    IRRADIANCE,
    RADIANCE,
    REFLECTANCE,
    WAYS,
    ways_between,
)

Geometry = tuple[int, int]
GEOMETRIES = (FLUX, INTENSITY, IRRADIANCE, RADIANCE)
# Change of the powers of 1/area and 1/solid angle when multiplied by each condition.
DOES = {AREA: (-1, 0), CONE: (0, -1), DISTANCE: (1, -1), REFLECTANCE: (0, 1)}
SEEN_DISC = (0, -1)  # a disc seen from its axis is a solid angle
# The most obvious conditions, for a call without any.
PLAIN = ({CONE}, {REFLECTANCE}, {AREA}, {DISTANCE}, {AREA, REFLECTANCE}, {DISTANCE, REFLECTANCE})


def searched(start: Geometry, end: Geometry) -> list[dict[str, int]]:
    """Return every plausible set of exponents that leads from one geometry to another."""
    wanted = (end[0] - start[0], end[1] - start[1])
    # only a reflector turns irradiance into radiance, although other conditions have the dimension
    reflects = (end == RADIANCE) - (start == RADIANCE)
    found = []
    for exponents in product((0, 1, -1), repeat=len(DOES)):
        way = {slot: power for slot, power in zip(DOES, exponents, strict=True) if power}
        moved = tuple(sum(power * DOES[slot][i] for slot, power in way.items()) for i in (0, 1))
        fits = moved == wanted and way.get(REFLECTANCE, reflects) == reflects
        if fits and is_physical(set(way), {start, end}):
            found.append(way)
    return sorted(found, key=len)


def is_physical(slots: set[str], ends: set[Geometry]) -> bool:
    """Return whether the conditions together have the meaning of their dimensions.

    An area and a distance describe a far field only: of a source between radiance and irradiance,
    of a receiver between intensity and flux.  A cone and a distance describe a lamp: with a
    radiance, the cone would be exact but the distance a far field.
    """
    radiance = RADIANCE in ends
    if {AREA, DISTANCE} <= slots:
        return (radiance or ends == {FLUX, INTENSITY}) and len(slots) == 2
    return not (radiance and {CONE, DISTANCE} <= slots and REFLECTANCE not in slots)


@pytest.mark.parametrize(("start", "end"), list(permutations(GEOMETRIES, 2)))
def test_the_table_has_exactly_the_ways_found_by_the_search(start, end):
    rows, sign = ways_between(start, end)
    signed = [{slot: sign * power for slot, power in row.powers.items()} for row in rows]
    assert signed == searched(start, end)


def test_there_are_sixteen_ways_with_the_disc():
    assert sum(map(len, WAYS.values())) + 1 == 16
    assert {frozenset(pair) for pair in WAYS} == {
        frozenset(pair) for pair in permutations(GEOMETRIES, 2)
    }


def test_a_disc_leads_from_irradiance_to_radiance():
    (power,) = DISC.powers.values()
    moved = tuple(power * step for step in SEEN_DISC)
    assert moved == (RADIANCE[0] - IRRADIANCE[0], RADIANCE[1] - IRRADIANCE[1])


@pytest.mark.parametrize("pair", WAYS)
def test_a_cone_is_projected_with_a_radiance_that_is_not_reflected(pair):
    for row in WAYS[pair]:
        slots = set(row.powers)
        projected = RADIANCE in pair and REFLECTANCE not in slots
        cone = geometric._projected_cone if projected else geometric._cone
        assert CONE not in slots or row.supply[CONE] is cone
        if {AREA, DISTANCE} <= slots:
            area = geometric._far_area if RADIANCE in pair else geometric._aperture
        else:
            seen = pair == (INTENSITY, RADIANCE) and slots == {AREA}
            area = geometric._front_area if seen else geometric._area
        assert AREA not in slots or row.supply[AREA] is area


@pytest.mark.parametrize("pair", WAYS)
def test_obvious_ways_are_suggested(pair):
    both = {AREA, CONE} if RADIANCE in pair else {CONE, DISTANCE}
    far = {AREA, DISTANCE} if RADIANCE in pair or pair == (FLUX, INTENSITY) else both
    for row in WAYS[pair]:
        assert row.is_suggested == (set(row.powers) in (*PLAIN, both))
        assert row.extends == (set(row.powers) in (*PLAIN, both, far))
