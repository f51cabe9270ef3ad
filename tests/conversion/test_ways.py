"""The table of ways between geometries, against a search for every way there could be.

A way multiplies by some conditions and divides by others.  What each of them does to the powers
of 1/area and 1/solid angle is known, so that every set of exponents can be tried.
"""

from itertools import permutations, product

import pytest

from radcalc.conversion import ways
from radcalc.conversion.conditions import AREA, CONE, DISTANCE, REFLECTANCE
from radcalc.conversion.ways import DISC, FLUX, INTENSITY, IRRADIANCE, RADIANCE, WAYS, ways_between

Geometry = tuple[int, int]
GEOMETRIES = (FLUX, INTENSITY, IRRADIANCE, RADIANCE)
# What multiplying by each condition does to the powers of 1/area and 1/solid angle.
DOES = {AREA: (-1, 0), CONE: (0, -1), DISTANCE: (1, -1), REFLECTANCE: (0, 1)}
SEEN_DISC = (0, -1)  # a disc seen from its axis is a solid angle
# The conditions that somebody who gave none thinks of first.
PLAIN = ({CONE}, {REFLECTANCE}, {AREA}, {DISTANCE}, {AREA, REFLECTANCE}, {DISTANCE, REFLECTANCE})


def searched(start: Geometry, end: Geometry) -> list[dict[str, int]]:
    """Return every plausible set of exponents that leads from one geometry to another."""
    wanted = (end[0] - start[0], end[1] - start[1])
    # a reflector turns irradiance into radiance, whatever else has that dimension
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
    """Whether the conditions mean together what their dimensions say.

    An area and a distance are a far field: of a source between radiance and irradiance, of a
    receiver between intensity and flux, and nothing else.  A cone and a distance are a lamp's:
    between radiance and intensity the one would be exact and the other a far field.
    """
    radiance = RADIANCE in ends
    if {AREA, DISTANCE} <= slots:
        return (radiance or ends == {FLUX, INTENSITY}) and len(slots) == 2
    return not (radiance and {CONE, DISTANCE} <= slots and REFLECTANCE not in slots)


@pytest.mark.parametrize(("start", "end"), list(permutations(GEOMETRIES, 2)))
def test_the_table_has_exactly_the_ways_that_a_search_finds(start, end):
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
def test_a_cone_is_projected_beside_a_radiance_unless_a_reflector_makes_it(pair):
    for row in WAYS[pair]:
        slots = set(row.powers)
        projected = RADIANCE in pair and REFLECTANCE not in slots
        cone = ways._projected_cone if projected else ways._cone
        assert CONE not in slots or row.supply[CONE] is cone
        if {AREA, DISTANCE} <= slots:
            area = ways._far_area if RADIANCE in pair else ways._aperture
        else:
            seen = pair == (INTENSITY, RADIANCE) and slots == {AREA}
            area = ways._front_area if seen else ways._area
        assert AREA not in slots or row.supply[AREA] is area


@pytest.mark.parametrize("pair", WAYS)
def test_the_ways_that_people_think_of_are_suggested(pair):
    both = {AREA, CONE} if RADIANCE in pair else {CONE, DISTANCE}
    far = {AREA, DISTANCE} if RADIANCE in pair or pair == (FLUX, INTENSITY) else both
    for row in WAYS[pair]:
        assert row.is_suggested == (set(row.powers) in (*PLAIN, both))
        assert row.extends == (set(row.powers) in (*PLAIN, both, far))
