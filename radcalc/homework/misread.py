"""Mistakes in inputs (half for full, wrong reference, wrong unit), and slips in the answer."""

import math
from collections.abc import Iterator
from contextlib import suppress
from itertools import product

from radcalc.errors import RadcalcError
from radcalc.homework.question import Candidate, Problem, both, usual
from radcalc.homework.wording import Translatable
from radcalc.inputs import Input
from radcalc.spectra.observers import AVOGADRO
from radcalc.units import COUNT_AT, FIELD_STRENGTH, NUMBER
from radcalc.units.dimensions import (
    ANGLE,
    AREA,
    ENERGY,
    LENGTH,
    PHOTON_ENERGY,
    SOLID_ANGLE,
    TEMPERATURE,
    TIME,
)
from radcalc.units.table import resolve
from radcalc.units.values import ScaleUnit

LN10, LN2, LB10 = math.log(10), math.log(2), math.log2(10)
READINGS = (  # mistakes of a reading on a scale, and the factors of the reading
    ("log-base", (LN10, 1 / LN10, LN2, 1 / LN2, LB10, 1 / LB10)),
    ("twice-the-level", (2.0, 0.5)),
    ("level-sign", (-1.0,)),
    ("level-factor", (10.0, 0.1)),
)
TWO_READINGS = (  # two mistakes of a reading together
    ("twice-the-level", "log-base"),
    ("log-base", "level-sign"),
    ("level-factor", "level-sign"),
)
Found = Iterator[Candidate | None]
SLIPS = ("power-of-ten", "length-unit", "area-unit")  # these also come with another mistake
CONES = (
    *("half-angle", "apex-angle", "beam-angle", "field-angle"),
    *("off-axis-angle", "within", "divergence"),
)
PAIRS = (("horizontal", "vertical"), ("width", "length"))  # both inputs are misread together
SIZES = ("radius", "diameter", "receiver-radius", "receiver-diameter", "pupil")
FROM_NORMAL = ("incidence", "tilt", "polar", "elevation", "sun-elevation", "half-angle")
FOOT, EV = resolve("ft").factor, resolve("eV").factor
# Units [SI] mixed up with the SI unit, by dimension: centimetres are used as metres, or metres
# are converted to centimetres and used as metres.
NEIGHBOURS = {
    LENGTH: ("length-unit", (1e-2, 1e-3)),
    AREA: ("area-unit", (1e-2, 1e-4, 1e-6)),
    TIME: ("minutes-for-seconds", (60.0, 3600.0)),
}
LUMINANCES = ("fL", "lambert", "asb", "nit", "stilb")  # units that are mixed up
PER_PI = ("lambert", "apostilb", "skot", "blondel")  # units with a factor 1/pi
CARRIES_PI = "lambert, foot-lambert, apostilb and skot contain 1/pi, nit and stilb do not"
CELSIUS = 273.15
SHIFTS = (CELSIUS, -CELSIUS, 273.0, -273.0)


def find(p: Problem) -> Iterator[Candidate]:
    """Yield the wrong values from misread inputs and from slips."""
    inputs = (_halves, _angles, _in_radians, _in_other_units, _to_surface, _absorbed)
    for family in (*inputs, _photons, _fields, _units, _slips):
        yield from filter(None, family(p))


def _multiples(name: str, right: float, *factors: float) -> Found:
    for factor in factors:
        yield usual(name, right * factor)
        yield usual(name, right / factor)


def _numbers(p: Problem) -> list[Input]:
    return [quantity for quantity in p.given.values() if isinstance(quantity.value, float)]


def _halves(p: Problem) -> Found:
    """Confuse full and half angles, diameters and radii."""
    for quantity in _numbers(p):
        for factor in (2.0, 0.5):
            if quantity.name in (*CONES, *PAIRS[0]):
                yield usual("full-for-half", p.misread(quantity.name, factor * quantity.value))
            if quantity.name in SIZES:
                is_usual = (factor == 2) == ("radius" not in quantity.name)
                value = p.misread(quantity.name, factor * quantity.value)
                yield usual("diameter-for-radius", value, later=0.0 if is_usual else 2.0)
    for names in PAIRS:
        if p.lists("pair of full angles") and p.given.keys() >= {*names}:
            for factor in (2.0, 0.5):
                changed = {name: factor * p.given[name].value for name in names}
                yield usual("full-for-half", p.anew(changed))
    if p.asks(*CONES):
        yield from _multiples("full-for-half", p.right, 2.0)


def halves_of(p: Problem) -> Iterator[tuple[Candidate, Problem]]:
    """Yield the mistakes in a size or an angle, each with the problem that it leads to."""
    for quantity in _numbers(p):
        name = "full-for-half" if quantity.name in CONES else "diameter-for-radius"
        if quantity.name not in (*CONES, *SIZES):
            continue
        for factor in (2.0, 0.5):
            other = p.changed({quantity.name: factor * quantity.value})
            if other and (first := usual(name, other.right)):
                yield first, other


def _angles(p: Problem) -> Found:
    """Measure angles from the surface, not from its normal."""
    for quantity in _numbers(p):
        if quantity.name in FROM_NORMAL:
            yield usual(
                "angle-from-surface", p.misread(quantity.name, abs(math.pi / 2 - quantity.value))
            )
    if p.asks("polar", "elevation", "incidence"):
        yield usual("angle-from-surface", math.pi / 2 - p.right)


def _in_radians(p: Problem) -> Found:
    """Use degrees as radians, in an input or in the result."""
    name = "degrees-as-radians"
    for quantity in _numbers(p):
        if quantity.dimension != ANGLE or quantity.unit_text == "rad":
            continue
        number = float(quantity.number)
        turned = math.fmod(abs(number), 2 * math.pi)
        for angle in (turned, 2 * math.pi - turned):  # the cosine is the same
            value = p.misread(quantity.name, angle)
            yield usual(name, value or None)  # 0: the light comes from below the surface
        if quantity.name == "incidence" and math.cos(quantity.value):
            yield usual(name, p.right * math.cos(number) / math.cos(quantity.value))
        if quantity.name in ("half-angle", "apex-angle"):
            parts = 2 if quantity.name == "apex-angle" else 1
            number, half = number / parts, quantity.value / parts
            yield usual(name, p.chain.after("solid-angle", 2 * math.pi * (1 - math.cos(number))))
            if p.lists("projected cone") and not p.asks("solid-angle"):
                yield usual(name, p.right * (math.sin(number) / math.sin(half)) ** 2)
    if ANGLE in p.target.dimensions:
        yield usual(name, p.right * math.degrees(1))
        in_radians = "the number is that in radians"
        bare = usual(name, p.right / math.degrees(1), in_radians)
        yield bare and bare._replace(
            right="pi/4 rad is 45 deg; an answer without a unit is in degrees"
        )


def _in_other_units(p: Problem) -> Found:
    """Use lengths, areas, times and temperatures in another unit."""
    for quantity in _numbers(p):
        if quantity.name not in ("wavelength", "bandwidth"):
            yield from _in_neighbouring_units(p, quantity)
        if quantity.dimension == TEMPERATURE:
            for shift in SHIFTS:
                yield usual("kelvin-for-celsius", p.misread(quantity.name, quantity.value + shift))
    temperature = p.chain.values.get("temperature")
    if temperature and "temperature" not in p.given:
        for shifted in (temperature + shift for shift in SHIFTS):
            if shifted > 0:
                yield usual("kelvin-for-celsius", p.chain.after("temperature", shifted))


def _in_neighbouring_units(p: Problem, quantity: Input) -> Found:
    if quantity.dimension not in NEIGHBOURS or not quantity.unit:
        return
    mistake, other_units = NEIGHBOURS[quantity.dimension]
    typed_factor = quantity.unit.factor
    factors = {1 / other for other in other_units} if typed_factor == 1 else {1.0, *other_units}
    if quantity.dimension == AREA:  # converted like a length
        factors.add(typed_factor**0.5)
    for factor in sorted(factors - {typed_factor}):
        value = p.misread(quantity.name, float(quantity.number) * factor)
        yield usual(mistake, value, later=0.0 if factor == 1 else 0.5)


def _to_surface(p: Problem) -> Found:
    """Confuse the distances to the surface and to the centre of a sphere."""
    radius, distance = p.radius(), p.amount("distance")
    if p.question.shape == "sphere" and radius and distance:
        for other in (distance - radius, distance + radius) if "distance" in p.given else ():
            yield usual("distance-to-surface", p.misread("distance", other))
        if p.asks("distance"):
            yield usual("distance-to-surface", p.right - radius)


def _absorbed(p: Problem) -> Found:
    """Confuse the absorbed and the reflected light."""
    for name in ("reflectance", "absorptance"):
        part = p.amount(name)
        if part and part < 1 and name in p.chain.symbols:
            yield usual("absorbed-for-reflected", p.chain.after(name, 1 - part))


def _photons(p: Problem) -> Found:
    """Use photon energies and wavelengths in the wrong unit, or Avogadro's number wrongly."""
    wavelength = p.given.get("wavelength")
    dimensions = (*p.target.dimensions, *(item.dimension for item in p.given.values()))
    if wavelength is not None and wavelength.dimension in (ENERGY, PHOTON_ENERGY):
        for factor in (EV, 1 / EV):
            yield usual(
                "joules-for-electronvolts", p.anew({"wavelength": wavelength.value * factor})
            )
    if PHOTON_ENERGY in p.target.dimensions:
        # 3.7e-19 J is also written as 3.7 eV
        yield from _multiples("joules-for-electronvolts", p.right, EV, EV**2, EV * 1e19)
    if wavelength is not None and (
        not p.light or not p.chain.symbols.isdisjoint(("photon-energy", "J"))
    ):
        yield from _multiples("nanometres-for-metres", p.right, 1e9, 1e7, 1e2)
    if any(dimension[COUNT_AT] for dimension in dimensions) or (wavelength is not None and p.light):
        yield from _multiples("avogadro", p.right, AVOGADRO, AVOGADRO * 1e-6)


def _fields(p: Problem) -> Found:
    """Confuse the peak and the root mean square of a field."""
    if "electric-field" in p.given:
        factor = math.sqrt(2) if FIELD_STRENGTH in p.target.dimensions else 2.0
        yield from _multiples("peak-for-rms", p.right, factor)
    plan = p.question.plan
    if plan and FIELD_STRENGTH in p.target.dimensions and p.right:
        irradiance = p.question.number * plan.source.factor
        for factor in (1.0, 2.0):
            yield usual("impedance-upside-down", factor * irradiance / p.right)


def _units(p: Problem) -> Found:
    """Mix up the units of a conversion with similar units, or invert its factor."""
    plan = p.question.plan
    if plan is None:
        return
    if "J" in p.chain.symbols:
        yield usual("jacobian-forgotten", p.question.number * plan.target.factor)
    units = ((plan.source, 1), (plan.target, -1))
    if any(word in name for unit, _ in units for name, _ in unit.atoms for word in PER_PI):
        for name, size in (("pi-forgotten", math.pi), ("pi-upside-down", math.pi**2)):
            for value in (p.right * size, p.right / size):
                yield usual(name, value, right=CARRIES_PI)
    if plan.is_linear and not plan.links:
        is_prefix = not math.log10(plan.factor) % 1
        yield usual("unit-upside-down", p.right / plan.factor**2, later=2.5 * is_prefix)
    number, right = p.question.number, p.right / plan.target.factor
    if plan.is_linear and plan.links and right:
        yield usual("factor-upside-down", number**2 / right * plan.target.factor)
    if not plan.is_linear:
        yield from _readings(p)
    for unit, sign in units:
        for text in LUMINANCES:
            other = resolve(text)
            if other.dimension == unit.dimension and other.factor != unit.factor:
                value = p.right * (other.factor / unit.factor) ** sign
                yield usual(
                    "neighbour-unit", value, Translatable("{0} was used as {1}", unit.text, text)
                )


def readings() -> Iterator[tuple[tuple[str, ...], float]]:
    """Yield the mistakes of a reading on a scale, and two together, with their factors."""
    factors = dict(READINGS)
    for name, several in READINGS:
        yield from (((name,), factor) for factor in several)
    for first, second in TWO_READINGS:
        for one, other in product(factors[first], factors[second]):
            yield (first, second), one * other


def misread(names: tuple[str, ...], value: float) -> Candidate | None:
    """Return the mistake or the two mistakes of a reading."""
    first, *second = [usual(name, value) for name in names]
    if first and second and second[0]:
        return both(first, second[0])
    return first


def _readings(p: Problem) -> Found:
    """Misread a number on a scale: its sign, the base of its logarithm, 10 for 20 in a decibel."""
    plan, number = p.question.plan, p.question.number
    if plan is None or not isinstance(getattr(plan, "ends", (None,))[0], ScaleUnit):
        return
    for names, factor in readings():
        with suppress(RadcalcError, ArithmeticError):
            yield misread(names, float(plan.quantity(number * factor)) * plan.target.factor)
    if p.target.dimensions[0] == NUMBER and 0 < p.right < 1:
        yield usual("absorbed-for-reflected", 1 - p.right)


def _slips(p: Problem) -> Found:
    """Mix up feet and metres, square degrees and steradians, or prefixes in the answer."""
    if p.light and p.light.area:
        yield from _multiples("feet-for-metres", p.right, FOOT**2, FOOT)
    if SOLID_ANGLE in p.target.dimensions:
        yield from _multiples("deg2-for-sr", p.right, math.degrees(1) ** 2, math.degrees(1))
    yield from _multiples("power-of-ten", p.right, *(10.0**power for power in (1, 2, 3, 4, 6, 9)))
