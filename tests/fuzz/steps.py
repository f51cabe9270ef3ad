"""Conversions in one step and in two, by any unit between, under the same conditions.

The two ways must agree, or one of them is refused.  A cone counts as a plain solid angle for a
uniform intensity and as a projected one for a uniform radiance; the two ways may differ in this
only if the conversion begins or ends with a radiance.  An incidence belongs to a distance or a
cone, if there is one, and otherwise turns the lit surface.
"""

import math
import random
from collections.abc import Iterator
from functools import cache
from itertools import combinations, permutations, product

from radcalc.conversion import Plan
from radcalc.conversion.plan import plan
from radcalc.errors import RadcalcError
from radcalc.inputs.reading import read
from radcalc.quantities import read as facts
from radcalc.units.table import resolve

SHORT, LONG = 20, 2_000

UNITS = (
    "lm", "cd", "lx", "lm/m2", "radlux", "cd/m2", "td", "lm.s", "lx.s", "cd.s", "cd.s/m2",
    "lm/nm", "lx/nm", "cd/nm", "cd/m2/nm", "lx/THz", "W", "W/sr", "W/m2", "W/m2/sr", "J",
    "J/m2", "J/sr", "W/nm", "W/m2/nm", "W/m2/sr/nm", "W/m2/Hz", "W/m2/cm-1", "J/m2/nm",
    "umol/s", "umol/m2/s", "umol/m2", "umol/sr/s", "umol/m2/sr/s", "umol/m2/s/nm", "photon",
    "photon/s/m2/sr/Hz", "nm", "GHz", "kayser",
)  # fmt: skip
# Small compared with the distance; the band is narrow, so that nanometres and hertz are equivalent.
CONDITIONS = {
    "wavelength": "555nm", "efficacy": "93lm/W", "spectrum": "D65", "time": "2h", "area": "3m2",
    "radius": "10cm", "solid-angle": "0.02sr", "half-angle": "30deg", "apex-angle": "40deg",
    "isotropic": True, "hemisphere": True, "exponent": "3", "beam-angle": "50deg",
    "distance": "2km", "incidence": "60deg", "bandwidth": "10nm", "reflectance": "0.7",
    "pupil": "3mm", "observer": "scotopic", "tilt": "40deg",
}  # fmt: skip
GIVEN = {name: read(name, value) for name, value in CONDITIONS.items()}
Names = frozenset[str]


@cache
def planned(source: str, target: str, names: Names) -> Plan | None:
    """Return the plan, or None if it is refused."""
    try:
        return plan(resolve(source), resolve(target), [GIVEN[name] for name in sorted(names)])
    except RadcalcError:
        return None


def cones(*plans: Plan) -> set[str]:
    """Return the cones of a plan: plain or projected solid angles."""
    letters = {factor.letter for made in plans for factor, _ in made.links}
    return letters & {"Omega", "Omega_p"}


def turns(*plans: Plan) -> int:
    """Count the rotations of a surface that a given irradiance lights."""
    return sum(factor.letter == "cos(theta)" for made in plans for factor, _ in made.links)


def same_light(direct: Plan, first: Plan, second: Plan) -> bool:
    """Return whether two steps have the kinds of light of one step, and meet in one."""
    pairs = (
        (first.source, direct.source),
        (first.target, second.source),
        (second.target, direct.target),
    )
    return all(one.dimension == other.dimension for one, other in pairs)


def splits(names: Names) -> Iterator[tuple[Names, Names]]:
    """Yield all ways to give each condition to the first step, the second, or both."""
    for parts in product((1, 2, 3), repeat=len(names)):
        given = list(zip(sorted(names), parts, strict=True))
        yield tuple(frozenset(n for n, part in given if part & step) for step in (1, 2))  # type: ignore[misc]


def compare(source: str, target: str, names: Names) -> int:
    """Compare two steps by any other unit with one step; return the number of pairs."""
    direct = planned(source, target, names)
    if direct is None:
        return 0
    ends = [facts(resolve(unit)) for unit in (source, target)]
    at_radiance = any(end and end.is_radiance for end in ends)
    compared = 0
    for between, (one, two) in product(UNITS, splits(names)):
        first, second = planned(source, between, one), planned(between, target, two)
        if between in (source, target) or first is None or second is None:
            continue
        if not same_light(direct, first, second):
            continue  # an observer of one step has lumens of its own
        if at_radiance and cones(direct) != cones(first, second):
            continue
        if turns(direct) != turns(first, second):
            continue  # the incidence of a distance or a cone is a different one
        compared += 1
        case = (source, between, target, sorted(names), sorted(one), sorted(two))
        together = first.factor * second.factor
        assert math.isclose(direct.factor, together, rel_tol=1e-7, abs_tol=0.0), case
    return compared


def sweep(count: int, seed: int) -> str:
    """Draw pairs of units; try all pairs of conditions, and some sets of three."""
    draw = random.Random(seed)
    pairs = list(permutations(UNITS, 2))
    draw.shuffle(pairs)
    sets = [frozenset(names) for size in range(3) for names in combinations(CONDITIONS, size)]
    compared = 0
    for source, target in pairs[:count]:
        triples = [frozenset(draw.sample(list(CONDITIONS), 3)) for _ in range(20)]
        compared += sum(compare(source, target, names) for names in (*sets, *triples))
    return f"{min(count, len(pairs))} pairs of units; {compared} conversions agree in two steps"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
