"""Dimensions: exponents of the base quantities, and their names."""

from radcalc.units import BASES, NUMBER, WEIGHT_AT, WEIGHT_BASE, Dimension
from radcalc.units.compiled import WEIGHTS

SUFFIXES = [*WEIGHTS]  # of the weights, by their places
# The units of the light that a weight is of, with their symbols.
UNITS_OF_BASES = {
    "e": (("W", "watt"), ("J", "joule")),
    "v": (("lm", "lumen"), ("lx", "lux"), ("cd", "candela"), ("fc", "footcandle")),
    "p": (("mol", "mole"), ("photon", "photon")),
}


def powers(**exponents: int) -> Dimension:
    """Return a dimension from exponents of named base quantities."""
    dimension = list(NUMBER)
    for name, exponent in exponents.items():
        dimension[BASES.index(name)] = exponent
    return tuple(dimension)


def times(a: Dimension, b: Dimension, power: int = 1) -> Dimension:
    """Return the dimension of a * b**power."""
    return tuple([x + power * y for x, y in zip(a, b, strict=True)])


def weighted(dimension: Dimension, place: int, power: int = 1) -> Dimension:
    """Return a dimension times a power of the weight at a place."""
    exponent = dimension[WEIGHT_AT] + power * WEIGHT_BASE**place
    return (*dimension[:WEIGHT_AT], exponent)


def weights_of(dimension: Dimension) -> dict[int, int]:
    """Return the exponents of the weights in a dimension, by their places."""
    rest, place, found = dimension[WEIGHT_AT], 0, {}
    while rest:
        rest, digit = divmod(rest + WEIGHT_BASE // 2, WEIGHT_BASE)
        if digit != WEIGHT_BASE // 2:
            found[place] = digit - WEIGHT_BASE // 2
        place += 1
    return found


def weight_of(dimension: Dimension) -> str:
    """Return the suffix of the one weight in a dimension, with the power 1; '' for others."""
    found = weights_of(dimension) if dimension[WEIGHT_AT] else {}
    return "".join([SUFFIXES[place] for place in found]) if [*found.values()] == [1] else ""


LENGTH = powers(length=1)
AREA = powers(length=2)
VOLUME = powers(length=3)
MASS = powers(mass=1)
TIME = powers(time=1)
TEMPERATURE = powers(temperature=1)
RECIPROCAL_TEMPERATURE = powers(temperature=-1)
ANGLE = powers(angle=1)
SOLID_ANGLE = powers(angle=2)
ETENDUE = powers(length=2, angle=2)
CYCLES = powers(cycle=1)
PER_TIME = powers(time=-1)
FREQUENCY = powers(cycle=1, time=-1)
WAVENUMBER = powers(cycle=1, length=-1)
SPEED = powers(length=1, time=-1)
ENERGY = powers(mass=1, length=2, time=-2)
POWER = powers(mass=1, length=2, time=-3)
PHOTON_ENERGY = powers(mass=1, length=2, time=-2, count=-1)
SPECIFIC_HEAT = powers(length=2, time=-2, temperature=-1)
LUMINOUS_FLUX = powers(luminosity=1, angle=2)
PHOTONS = powers(count=1)
PHOTON_FLUX = powers(count=1, time=-1)
CURRENT = powers(current=1)
RESPONSIVITY = times(CURRENT, POWER, -1)
CHARGE = times(CURRENT, TIME)
RETINAL_ILLUMINANCE = powers(retinal_illuminance=1)
ILLUMINANCE = times(LUMINOUS_FLUX, AREA, -1)
LUMINOUS_INTENSITY = times(LUMINOUS_FLUX, SOLID_ANGLE, -1)
LUMINANCE = times(ILLUMINANCE, SOLID_ANGLE, -1)

# The coherent unit of each dimension, in which derivations show values.
COHERENT = {
    NUMBER: "1",
    LENGTH: "m",
    AREA: "m2",
    MASS: "kg",
    TIME: "s",
    TEMPERATURE: "K",
    ANGLE: "rad",
    SOLID_ANGLE: "sr",
    ETENDUE: "m2 sr",
    FREQUENCY: "Hz",
    WAVENUMBER: "cycle/m",
    ENERGY: "J",
    PHOTON_ENERGY: "J",
    SPECIFIC_HEAT: "J/kg/K",
    POWER: "W",
    CURRENT: "A",
    PHOTONS: "photon",
    times(PHOTON_FLUX, POWER, -1): "photon/J",
    RESPONSIVITY: "A/W",
    LUMINOUS_FLUX: "lm",
    LUMINOUS_INTENSITY: "cd",
    ILLUMINANCE: "lx",
    LUMINANCE: "cd/m2",
    times(ILLUMINANCE, TIME): "lx s",
    times(LUMINANCE, TIME): "cd s/m2",
}
