"""Dimensions: exponents of the base quantities, and their names."""

from radcalc.units import BASES, NUMBER, Dimension


def powers(**exponents: int) -> Dimension:
    """Return a dimension from exponents of named base quantities."""
    dimension = list(NUMBER)
    for name, exponent in exponents.items():
        dimension[BASES.index(name)] = exponent
    return tuple(dimension)


def times(a: Dimension, b: Dimension, power: int = 1) -> Dimension:
    """Return the dimension of a * b**power."""
    return tuple([x + power * y for x, y in zip(a, b, strict=True)])


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
