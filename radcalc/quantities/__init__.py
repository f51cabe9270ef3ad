"""Quantities, their names and their symbols.

This module has the quantity of a unit: geometry and kind, derived from its dimension.
"""

from operator import sub

from radcalc.errors import quote
from radcalc.tuples import NamedTuple
from radcalc.units import FIELD_STRENGTH, NUMBER, Dimension, Unit, dimensions

RADIANT, LUMINOUS, PHOTON = "e", "v", "p"
NONE, PER_WAVELENGTH, PER_FREQUENCY, PER_WAVENUMBER = "", "lambda", "nu", "sigma"
PER_ENERGY = "Q"  # of a photon
DENSITY_NAMES = {
    PER_WAVELENGTH: "per wavelength",
    PER_FREQUENCY: "per frequency",
    PER_WAVENUMBER: "per wavenumber",
    PER_ENERGY: "per photon energy",
}
DENSITY_SYMBOLS = {
    NONE: "",
    PER_WAVELENGTH: ",λ",
    PER_FREQUENCY: ",ν",
    PER_WAVENUMBER: ",σ",
    PER_ENERGY: ",Q",
}
# Units of incident light only; lm/m2 is also a unit of exitance.
INCIDENT_UNITS = ("lux", "footcandle", "metre_candle", "nox", "phot")


FLUX = {
    RADIANT: dimensions.POWER,
    LUMINOUS: dimensions.LUMINOUS_FLUX,
    PHOTON: dimensions.PHOTON_FLUX,
}
AXIS = {
    NONE: NUMBER,
    PER_WAVELENGTH: dimensions.LENGTH,
    PER_FREQUENCY: dimensions.FREQUENCY,
    PER_WAVENUMBER: dimensions.WAVENUMBER,
}
RATIOS = {
    (over, under): dimensions.times(FLUX[over], FLUX[under], -1)
    for over in FLUX
    for under in FLUX
    if over != under
}

# (time, area, solid angle) relative to flux: names of the kinds e, v, p; symbol.
GEOMETRIES = {
    (1, 0, 0): (("radiant energy", "luminous energy", "photon number"), "Q"),
    (0, 0, 0): (("radiant flux", "luminous flux", "photon flux"), "Φ"),
    (0, 0, 1): (("radiant intensity", "luminous intensity", "photon intensity"), "I"),
    (0, 1, 0): (("irradiance", "illuminance", "photon irradiance"), "E"),
    (0, 1, 1): (("radiance", "luminance", "photon radiance"), "L"),
    (1, 1, 0): (("radiant exposure", "luminous exposure", "photon exposure"), "H"),
    (1, 0, 1): (
        (
            "time-integrated radiant intensity",
            "time-integrated luminous intensity",
            "time-integrated photon intensity",
        ),
        "∫I dt",
    ),
    (1, 1, 1): (
        (
            "time-integrated radiance",
            "time-integrated luminance",
            "time-integrated photon radiance",
        ),
        "∫L dt",
    ),
}
KINDS = (RADIANT, LUMINOUS, PHOTON)  # the order of names, units and results
EXITANCES = ("radiant exitance", "luminous exitance", "photon exitance")
KIND_NAMES = {RADIANT: "radiant", LUMINOUS: "luminous", PHOTON: "photon"}

OTHERS = {
    NUMBER: ("number", ""),
    dimensions.LENGTH: ("length", "l"),
    dimensions.AREA: ("area", "A"),
    dimensions.VOLUME: ("volume", "V"),
    dimensions.MASS: ("mass", "m"),
    dimensions.TIME: ("time", "t"),
    dimensions.TEMPERATURE: ("temperature", "T"),
    dimensions.RECIPROCAL_TEMPERATURE: ("reciprocal temperature", "1/T"),
    dimensions.ANGLE: ("angle", "α"),
    dimensions.SOLID_ANGLE: ("solid angle", "Ω"),
    dimensions.CYCLES: ("number of cycles", ""),
    dimensions.FREQUENCY: ("frequency", "ν"),
    dimensions.WAVENUMBER: ("wavenumber", "σ"),
    dimensions.ETENDUE: ("etendue", "G"),
    dimensions.RETINAL_ILLUMINANCE: ("retinal illuminance", "E_T"),
    dimensions.PHOTON_ENERGY: ("photon energy", "Q"),
    RATIOS[LUMINOUS, RADIANT]: ("luminous efficacy", "K"),
    RATIOS[PHOTON, RADIANT]: ("photon efficacy", "K_p"),
    RATIOS[LUMINOUS, PHOTON]: ("luminous efficacy per photon", ""),
    RATIOS[RADIANT, LUMINOUS]: ("radiant flux per luminous flux", ""),
    RATIOS[PHOTON, LUMINOUS]: ("photons per luminous energy", ""),
    dimensions.CURRENT: ("electric current", "I"),
    dimensions.CHARGE: ("electric charge", "q"),
    FIELD_STRENGTH: ("electric field strength", "E"),
    dimensions.RESPONSIVITY: ("responsivity", "s"),
    dimensions.SPEED: ("speed", "v"),
    dimensions.SPECIFIC_HEAT: ("specific heat capacity", "c"),
}

# The symbols that characterise a photon; each determines the others.
PHOTON_NAMES = {
    dimensions.LENGTH: "wavelength",
    dimensions.FREQUENCY: "frequency",
    dimensions.WAVENUMBER: "wavenumber",
    dimensions.ENERGY: "photon-energy",
    dimensions.PHOTON_ENERGY: "photon-energy",
}


class Reading(NamedTuple):
    """The facts of a light quantity: kind, geometry, axis of density; `retinal` for the troland."""

    kind: str
    time: int
    area: int
    solid_angle: int
    axis: str
    retinal: bool = False

    @property
    def geometry(self) -> tuple[int, int, int]:
        """The powers of time, 1/area and 1/solid angle relative to flux."""
        return self.time, self.area, self.solid_angle

    @property
    def is_count(self) -> bool:
        """Return whether it is a number of photons, which growers and loggers write for a PPFD."""
        return (self.kind, self.geometry) == (PHOTON, (1, 0, 0))

    @property
    def is_radiance(self) -> bool:
        """Return whether it is per projected solid angle: a radiance, a luminance, a troland."""
        return bool(self.area and self.solid_angle)

    @property
    def name(self) -> str:
        if self.retinal:
            return OTHERS[dimensions.RETINAL_ILLUMINANCE][0]
        name = GEOMETRIES[self.geometry][0][KINDS.index(self.kind)]
        return f"spectral {name} ({DENSITY_NAMES[self.axis]})" if self.axis else name

    @property
    def symbol(self) -> str:
        if self.retinal:
            return OTHERS[dimensions.RETINAL_ILLUMINANCE][1]
        return f"{GEOMETRIES[self.geometry][1]}_{self.kind}{DENSITY_SYMBOLS[self.axis]}"


def light_dimension(kind: str, geometry: tuple[int, int, int], axis: str) -> Dimension:
    """Return the dimension of a light quantity."""
    return _DIMENSIONS[kind, geometry, axis]


def _below_flux(geometry: tuple[int, int, int], axis: str) -> Dimension:
    time, area, solid_angle = geometry
    parts = zip(dimensions.TIME, dimensions.AREA, dimensions.SOLID_ANGLE, AXIS[axis], strict=True)
    return tuple([area * a + solid_angle * s + x - time * t for t, a, s, x in parts])


_DIMENSIONS = {
    (kind, geometry, axis): tuple(map(sub, flux, below))
    for geometry in GEOMETRIES
    for axis in AXIS
    for below in [_below_flux(geometry, axis)]
    for kind, flux in FLUX.items()
}
GRID = {
    dimension: (kind, *geometry, axis) for (kind, geometry, axis), dimension in _DIMENSIONS.items()
}
# W/m2/eV has the dimension of 1/(m2 s), and photon/eV that of an efficacy: the units decide.
_BY_ENERGY = {
    tuple(map(sub, dimension, dimensions.ENERGY)): (*facts[:-1], PER_ENERGY)
    for dimension, facts in GRID.items()
    if facts[-1] == NONE
}


def read(unit: Unit) -> Reading | None:
    """Return the facts of a light quantity from a unit; None for any other quantity."""
    if unit.dimension == dimensions.RETINAL_ILLUMINANCE:
        return Reading(LUMINOUS, 0, 1, 1, NONE, retinal=True)
    facts = GRID.get(unit.dimension)
    if unit.dimension in _BY_ENERGY and _is_per_energy(unit):
        facts = _BY_ENERGY[unit.dimension]
    return Reading(*facts) if facts else None


def _is_per_energy(unit: Unit) -> bool:
    """Return whether a unit is divided by a photon energy; umol/J and lm.s/J are efficacies."""
    for name, power in unit.atoms:
        if power == -1 and name.endswith(("electronvolt", "joule", "erg")):
            return name.endswith("electronvolt") or unit.dimension not in OTHERS
    return False


def is_per_length(unit: Unit) -> bool:
    """Return whether a density per length has no unit of wavelength: the lm/m of a strip."""
    reading = read(unit)
    if reading is None or reading.axis != PER_WAVELENGTH:
        return False
    if any(name.endswith("flick") for name, _ in unit.atoms):
        return False
    return not unit.has_wavelength


def is_incident(unit: Unit) -> bool:
    """Return whether the unit is of incident light only: the lux, the foot-candle, the phot."""
    return not unit.is_exitance and any(name.endswith(INCIDENT_UNITS) for name, _ in unit.atoms)


def name_of(unit: Unit) -> str:
    """Return the name of the quantity of a unit; '' if it has none."""
    reading = read(unit)
    if reading is None:
        return OTHERS.get(unit.dimension, ("", ""))[0]
    if is_per_length(unit):
        plain = Reading(reading.kind, *reading.geometry, NONE)
        return f"{plain.name} per length"
    if unit.is_exitance:
        return EXITANCES[KINDS.index(reading.kind)]
    return reading.name


def result_name(unit: Unit) -> str:
    """Return the name of the result of a conversion to a unit, as used by `--get`."""
    name = name_of(unit).replace("(", "").replace(")", "")
    return name.replace(" ", "-") or "value"


def symbol_of(unit: Unit) -> str:
    """Return the symbol of the quantity of a unit; '' if it has none."""
    reading = read(unit)
    if reading is None:
        return OTHERS.get(unit.dimension, ("", ""))[1]
    if is_per_length(unit):
        return ""
    if unit.is_exitance:
        return f"M_{reading.kind}"
    return reading.symbol


COHERENT_HEADS = {
    (RADIANT, 0): "W",
    (RADIANT, 1): "J",
    (LUMINOUS, 0): "lm",
    (LUMINOUS, 1): "lm s",
    (PHOTON, 0): "photon/s",
    (PHOTON, 1): "photon",
}
COHERENT_AXES = {
    NONE: "",
    PER_WAVELENGTH: "/m",
    PER_FREQUENCY: "/Hz",
    PER_WAVENUMBER: "/(cycle/m)",
    PER_ENERGY: "/J",
}


def coherent_unit(unit: Unit) -> str:
    """Return the coherent SI unit of a light quantity."""
    reading = read(unit)
    if reading is None:
        return dimensions.COHERENT.get(unit.dimension, unit.text)
    return coherent_text(reading)


def coherent_text(reading: Reading) -> str:
    """Return the coherent SI unit of a light quantity as text."""
    if reading.retinal:
        return "td"
    area = "/m2" if reading.area else ""
    if reading.kind == LUMINOUS and reading.solid_angle and not reading.time:
        return f"cd{area}{COHERENT_AXES[reading.axis]}"
    head = COHERENT_HEADS[reading.kind, reading.time]
    if head + area == "lm/m2":
        head, area = "lx", ""
    per_angle = "/sr" if reading.solid_angle else ""
    return f"{head}{area}{per_angle}{COHERENT_AXES[reading.axis]}"


def describe(unit: Unit) -> str:
    """Return a unit for a message: 'luminous flux (lm)', or 'kg.m' if the quantity has no name."""
    name = name_of(unit)
    text = quote(unit.text)
    return f"{name} ({text})" if name else f"'{text}'"
