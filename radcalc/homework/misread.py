"""Inputs misread: half for full, in a neighbour unit, as another angle; and slips of the answer."""

import math
from collections.abc import Iterator

from radcalc.errors import RadcalcError
from radcalc.given import Given
from radcalc.homework.problem import Candidate, Problem
from radcalc.homework.usual import USUAL
from radcalc.spectra.planck import AVOGADRO
from radcalc.units.dimensions import ANGLE, AREA, ENERGY, LENGTH, PHOTON_ENERGY, SOLID_ANGLE, TIME
from radcalc.units.dimensions import TEMPERATURE
from radcalc.units.table import COUNT_AT, NUMBER, Unit, resolve

# The name of a mistake, the value that it gives, and by how much it is rarer than usual.
Wrong = Iterator[tuple[str, float | None] | tuple[str, float | None, float]]
SLIPS = ("power-of-ten", "length-unit", "area-unit")  # that are made beside another mistake
CONES = ("half-angle", "apex-angle", "beam-angle", "field-angle", "within")
PYRAMID = ("horizontal", "vertical")
ROUND = ("radius", "diameter", "receiver-radius", "receiver-diameter", "pupil")
RECTANGLE = ("width", "length")
NORMAL = ("incidence", "tilt", "polar", "elevation", "half-angle")
PARTS = ("reflectance", "absorptance")
FOOT = resolve("ft").factor
EV = resolve("eV").factor
# Units that one unit of an input is taken for, by dimension.
NEIGHBOURS = {
    LENGTH: ("length-unit", ("m", "cm", "mm")),
    AREA: ("area-unit", ("m2", "cm2", "mm2")),
    TIME: ("minutes-for-seconds", ("s", "min", "h", "ms")),
}
LUMINANCES = ("fL", "lambert", "asb", "nit", "stilb")


def find(p: Problem) -> Iterator[Candidate]:
    """Every input misread, and every slip of the whole."""
    for family in (_doubled, _turned, _in_other_units, _parts, _photons, _units, _slips):
        for name, value, *later in family(p):
            if value is not None:
                rank, done, right = USUAL[name]
                yield Candidate(name, rank + sum(later), value, done, right)


def _numbers(p: Problem) -> list[Given]:
    return [one for one in p.given.values() if isinstance(one.value, float)]


def _doubled(p: Problem) -> Wrong:
    for names, mistake in (
        ((*CONES, *PYRAMID), "full-for-half"),
        (ROUND, "diameter-for-radius"),
    ):
        for name in names:
            for factor in (2.0, 0.5):
                value = p.amount(name)
                if name in p.given and value:
                    is_usual = names is not ROUND or (factor == 2) == ("radius" not in name)
                    yield mistake, p.misread(name, factor * value), 0.0 if is_usual else 2.0
    for names in (PYRAMID, RECTANGLE):
        if all(name in p.given for name in names):
            for factor in (2.0, 0.5):
                both = {name: factor * (p.amount(name) or 0.0) for name in names}
                if names == PYRAMID or p.is_of("solid-angle"):
                    yield "full-for-half", p.anew(both)
    if p.asks(*CONES):
        yield from _both("full-for-half", p.right, 2.0)
    if p.asks("radius", "diameter"):
        yield from _both("diameter-for-radius", p.right, 2.0)
    radius, distance = p.radius(), p.amount("distance")
    if p.facts.shape == "sphere" and radius and distance:
        if "distance" in p.given:
            yield "distance-to-surface", p.misread("distance", distance - radius)
            yield "distance-to-surface", p.misread("distance", distance + radius)
        elif p.asks("distance"):
            yield "distance-to-surface", p.right - radius


def _both(name: str, right: float, *factors: float) -> Wrong:
    for factor in factors:
        yield name, right * factor
        yield name, right / factor


def _turned(p: Problem) -> Wrong:
    """Angles from the wrong line, and degrees as radians."""
    for one in _numbers(p):
        if one.dimension != ANGLE:
            continue
        if one.name in ("incidence", "tilt") and one.value:
            yield "cosine-forgotten", p.misread(one.name, 0.0)
        if one.name in NORMAL:
            yield "angle-from-surface", p.misread(one.name, math.pi / 2 - one.value)
        if one.unit_text not in ("1", "rad"):
            number = float(one.number)
            turned = math.fmod(abs(number), 2 * math.pi)
            for angle in (turned, 2 * math.pi - turned):  # the cosine is the same
                yield "degrees-as-radians", p.misread(one.name, angle) or None
            if one.name == "incidence" and math.cos(one.value):
                yield "degrees-as-radians", p.right * math.cos(number) / math.cos(one.value)
    half = p.half_angle()
    degrees = next((p.given[n] for n in ("half-angle", "apex-angle") if n in p.given), None)
    if half and degrees is not None and degrees.unit_text not in ("1", "rad"):
        number = float(degrees.number) * half / degrees.value
        turned = math.acos(math.cos(number))
        for name, size in (
            ("solid-angle", 4 * math.pi * math.sin(turned / 2) ** 2),
            ("projected-solid-angle", math.pi * math.sin(number) ** 2),
        ):
            if name in p.chain.symbols:
                yield "degrees-as-radians", p.chain.after(name, size)
        if p.is_of("lambertian", "etendue"):
            yield "degrees-as-radians", p.right * (math.sin(number) / math.sin(half)) ** 2
    if p.asks("polar", "elevation", "incidence"):
        yield "angle-from-surface", math.pi / 2 - p.right
    if ANGLE in p.target.dimensions:
        yield from _both("degrees-as-radians", p.right, math.degrees(1))


def _in_other_units(p: Problem) -> Wrong:
    """The number typed, in another unit."""
    for one in _numbers(p):
        if one.dimension in NEIGHBOURS and one.unit and one.name not in ("wavelength", "bandwidth"):
            mistake, units = NEIGHBOURS[one.dimension]
            factors = {resolve(text).factor for text in units} - {one.unit.factor}
            if one.dimension == AREA:  # as a length is
                factors.add(one.unit.factor**0.5)
            for factor in sorted(factors):
                later = 0.0 if factor == 1 else 0.5
                yield mistake, p.misread(one.name, float(one.number) * factor), later
        if one.dimension == TEMPERATURE:
            for shift in (273.15, -273.15):
                yield "kelvin-for-celsius", p.misread(one.name, one.value + shift)
    source = p.given["spectrum"].value if "spectrum" in p.given else None
    temperature = getattr(source, "temperature", None)
    if temperature and source is not None:
        for shift in (273.15, -273.15):
            if temperature + shift > 0:
                yield "kelvin-for-celsius", p.anew({"spectrum": type(source)(temperature + shift)})


def _parts(p: Problem) -> Wrong:
    """What is lost for what is left; the other sign of the film's speed."""
    for name in PARTS:
        part = p.amount(name)
        if part and part < 1 and name in p.chain.symbols:
            yield "absorbed-for-reflected", p.chain.after(name, 1 - part)


def _photons(p: Problem) -> Wrong:
    """Energies and wavelengths in the wrong unit, and moles."""
    wave = p.given.get("wavelength")
    if wave is not None:
        if wave.dimension in (ENERGY, PHOTON_ENERGY) and p.right and wave.value:
            for factor in (EV, 1 / EV):
                yield "joules-for-electronvolts", p.anew({"wavelength": wave.value * factor})
        is_link = not p.light or {"photon-energy", "J"} & set(p.chain.symbols)
        if wave.dimension == LENGTH and is_link:
            yield from _both("nanometres-for-metres", p.right, 1e9, 1e7, 1e2)
    if PHOTON_ENERGY in p.target.dimensions:
        yield from _both("joules-for-electronvolts", p.right, EV)
    dimensions = (*p.target.dimensions, *(one.dimension for one in p.given.values()))
    if any(d[COUNT_AT] for d in dimensions) or (wave is not None and p.light):
        yield from _both("avogadro", p.right, AVOGADRO, AVOGADRO * 1e-6)


def _units(p: Problem) -> Wrong:
    """The units of a conversion mixed up with their neighbours, or the factor turned round."""
    if p.facts.number:
        yield "jacobian-forgotten", p.facts.unchanged if p.facts.jacobian else None
    if p.facts.per_pi:
        yield from _both("pi-forgotten", p.right, math.pi)
        yield from _both("two-pi-for-pi", p.right, 2.0)
        yield from _both("pi-upside-down", p.right, math.pi**2)
    plan = p.plan
    if plan is None:
        return
    if not plan.links and p.facts.number and math.log10(plan.factor) % 1:
        yield "unit-upside-down", p.facts.number / plan.factor * plan.target.factor
    for unit, sign in ((plan.source, 1), (plan.target, -1)):
        for text in LUMINANCES:
            other: Unit = resolve(text)
            if other.dimension == unit.dimension and unit.text != text:
                yield "neighbour-unit", p.right * (other.factor / unit.factor) ** sign


def _slips(p: Problem) -> Wrong:
    if p.light and p.light.area:
        yield from _both("feet-for-metres", p.right, FOOT**2, FOOT)
    if SOLID_ANGLE in p.target.dimensions:
        yield from _both("deg2-for-sr", p.right, math.degrees(1) ** 2, math.degrees(1))
    yield from _both("power-of-ten", p.right, *(10.0**power for power in (1, 2, 3, 4, 6, 9)))
