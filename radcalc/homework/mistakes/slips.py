"""Slips: units of time, length, area and solid angle, and powers of ten."""

import math
from collections.abc import Iterator

from radcalc.homework.catalogue import Problem, mistake, mistake_factor
from radcalc.units.dimensions import AREA, LENGTH, SOLID_ANGLE, TIME
from radcalc.units.table import resolve

SLIPS = ("power-of-ten", "length-unit", "area-unit")  # that are made beside another mistake
FOOT = resolve("ft").factor


@mistake(
    "minutes-for-seconds",
    3,
    "hours or minutes were used as seconds",
    "a watt is a joule per second",
)
def _minutes_for_seconds(p: Problem) -> Iterator[float]:
    for one in p.given_of(TIME):
        number = p.number(one.name)
        if number is not None:
            yield from p.anew({one.name: number})


@mistake(
    "length-unit",
    3,
    "a length was used in another unit (cm or mm for m, feet for metres)",
    "lengths go into the formula in one unit",
)
def _length_unit(p: Problem) -> Iterator[float]:
    names = [one.name for one in p.given_of(LENGTH) if one.name != "wavelength"]
    yield from p.scaled(names, 1e2, 1e3, FOOT)


@mistake("area-unit", 3, "an area was converted as a length is", "1 m2 is 10 000 cm2, 1 m = 100 cm")
def _area_unit(p: Problem) -> Iterator[float]:
    names = [one.name for one in p.given_of(AREA)]
    yield from p.scaled(names, 1e2, 1e3, 1e4, 1e6)
    if names:  # where the patch would be too large for its law
        yield from p.both(1e2, 1e4)


@mistake_factor(
    "feet-for-metres", 4, "feet and metres were mixed up", "1 ft = 0.3048 m, and 1 fc = 10.764 lx"
)
def _feet_for_metres(p: Problem) -> Iterator[float]:
    if p.light and p.light.area:
        yield from (FOOT**2, FOOT)


@mistake_factor(
    "power-of-ten",
    4,
    "the answer is off by a power of ten: a slip of a prefix",
    "m is 1e-3, u is 1e-6, k is 1e3",
)
def _power_of_ten(p: Problem) -> Iterator[float]:
    yield from (10.0**power for power in (1, 2, 3, 4, 6, 9))


@mistake_factor(
    "deg2-for-sr",
    3,
    "square degrees and steradians were mixed up",
    "1 sr = (180/pi)^2 deg2 = 3282.81 deg2",
)
def _deg2_for_sr(p: Problem) -> Iterator[float]:
    if SOLID_ANGLE in p.target.dimensions:
        yield from (math.degrees(1) ** 2, math.degrees(1))
