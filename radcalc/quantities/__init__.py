"""Quantities, their names and their symbols.

This module has the quantity of a unit: geometry and kind, derived from its dimension.  A kind is
that of watts, of lumens, of photons, or of a weight of one of these: its suffix (`mel`).
"""

from operator import sub

from radcalc.errors import quote
from radcalc.tuples import NamedTuple
from radcalc.units import FIELD_STRENGTH, NUMBER, WEIGHT_AT, Dimension, Unit, dimensions
from radcalc.units.compiled import PREFIX_NAMES, QUANTITIES, WEIGHTS
from radcalc.units.dimensions import weight_of, weighted, weights_of

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
PAIRS = {dimension: pair for pair, dimension in RATIOS.items()}


def base_of(kind: str) -> str:
    """Return the light that a kind is a weight of: watts, lumens or photons."""
    return WEIGHTS[kind][1] if kind in WEIGHTS else kind


def of_kind(dimension: Dimension, kind: str) -> Dimension:
    """Return a dimension of the base of a kind in the kind itself."""
    place = dimensions.SUFFIXES.index(kind) if kind in WEIGHTS else -1
    return weighted(dimension, place) if place >= 0 else dimension


def in_a_kind(dimension: Dimension) -> tuple[Dimension, str]:
    """Return a dimension without its one weight, and the weight's suffix; '' if it has none."""
    suffix = weight_of(dimension) if dimension[WEIGHT_AT] else ""
    return ((*dimension[:WEIGHT_AT], 0), suffix) if suffix else (dimension, "")


def ratio(over: str, under: str) -> Dimension:
    """Return the dimension of an amount of one kind per amount of another."""
    plain = dimensions.times(FLUX[base_of(over)], FLUX[base_of(under)], -1)
    inverse = tuple([-power for power in of_kind(NUMBER, under)])
    return dimensions.times(of_kind(plain, over), inverse)


def ratio_of(dimension: Dimension) -> tuple[str, str] | None:
    """Return the two kinds of a ratio, over and under; None for other dimensions."""
    if not dimension[WEIGHT_AT]:
        return PAIRS.get(dimension)
    weights = weights_of(dimension)
    if sorted(weights.values()) not in ([1], [-1], [-1, 1]):
        return None
    named = {power: dimensions.SUFFIXES[place] for place, power in weights.items()}
    over, under = (
        [named[power]] if power in named else [kind for kind in FLUX if kind not in named.values()]
        for power in (1, -1)
    )
    pairs = [(top, bottom) for top in over for bottom in under if ratio(top, bottom) == dimension]
    return pairs[0] if pairs else None


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
KIND_NAMES.update({suffix: row[2] for suffix, row in WEIGHTS.items()})
OBSERVERS = {row[0]: suffix for suffix, row in WEIGHTS.items() if row[1] == LUMINOUS}


def kind_of_observer(name: str) -> str:
    """Return the kind of the lumens of an observer; those of the photopic one are luminous."""
    return OBSERVERS.get(name, LUMINOUS)


def in_words(kind: str, names: tuple[str, ...]) -> str:
    """Return the name of a quantity in a kind: irradiance of melanopic watts."""
    if kind in FLUX:
        return names[KINDS.index(kind)]
    return f"{KIND_NAMES[kind]} {names[KINDS.index(base_of(kind))]}"


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
        name = in_words(self.kind, GEOMETRIES[self.geometry][0])
        return f"spectral {name} ({DENSITY_NAMES[self.axis]})" if self.axis else name

    @property
    def symbol(self) -> str:
        if self.retinal:
            return OTHERS[dimensions.RETINAL_ILLUMINANCE][1]
        return f"{GEOMETRIES[self.geometry][1]}_{self.kind}{DENSITY_SYMBOLS[self.axis]}"


def light_dimension(kind: str, geometry: tuple[int, int, int], axis: str) -> Dimension:
    """Return the dimension of a light quantity."""
    if kind in FLUX:
        return _DIMENSIONS[kind, geometry, axis]
    return of_kind(_DIMENSIONS[base_of(kind), geometry, axis], kind)


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


def place_of(dimension: Dimension) -> tuple[str, int, int, int, str] | None:
    """Return the facts of a light quantity from its dimension; None for any other."""
    if not dimension[WEIGHT_AT]:
        return GRID.get(dimension)
    plain, kind = in_a_kind(dimension)
    facts = GRID.get(plain)
    if not kind or facts is None:
        return facts
    return (kind, *facts[1:]) if facts[0] == base_of(kind) else None


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
    if not unit.dimension[WEIGHT_AT]:
        facts, plain, kind = GRID.get(unit.dimension), unit.dimension, ""
    else:
        facts = place_of(unit.dimension)
        plain, kind = in_a_kind(unit.dimension)
    if plain in _BY_ENERGY and _is_per_energy(unit):
        facts = (kind or _BY_ENERGY[plain][0], *_BY_ENERGY[plain][1:])
    return Reading(*facts) if facts else None


def _is_per_energy(unit: Unit) -> bool:
    """Return whether a unit is divided by a photon energy; umol/J and lm.s/J are efficacies."""
    for name, power in unit.atoms:
        if power == -1 and name.endswith(("electronvolt", "joule", "erg")):
            plain, _ = in_a_kind(unit.dimension)
            return name.endswith("electronvolt") or plain not in OTHERS
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
        return OTHERS.get(unit.dimension, ("", ""))[0] or _name_of_ratio(unit.dimension)
    if is_per_length(unit):
        plain = Reading(reading.kind, *reading.geometry, NONE)
        return f"{plain.name} per length"
    if unit.is_exitance:
        return in_words(reading.kind, EXITANCES)
    return own_name(unit) or reading.name


def own_name(unit: Unit) -> str:
    """Return the name of a quantity with a unit of its own: UV index; '' for other units."""
    if len(unit.atoms) != 1 or not unit.dimension[WEIGHT_AT] or unit.atoms[0][1] != 1:
        return ""
    (name, _), *_ = unit.atoms
    owns = (own for own in QUANTITIES if name.removesuffix(own) in ("", *PREFIX_NAMES))
    return next((QUANTITIES[own] for own in owns if name.endswith(own)), "")


def _name_of_ratio(dimension: Dimension) -> str:
    """Return the name of a ratio with a weight: melanopic per luminous; '' for others."""
    pair = ratio_of(dimension) if dimension[WEIGHT_AT] else None
    return " per ".join([KIND_NAMES[kind] for kind in pair]) if pair else ""


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


def with_suffix(text: str, kind: str) -> str:
    """Return the text of a unit in a weighted kind (lx_scot/sr, photon_ypf/s) or in another."""
    if kind not in WEIGHTS:
        return text
    end = next((k for k, c in enumerate(text) if not c.isalpha()), len(text))
    return f"{text[:end]}_{kind}{text[end:]}"


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
    return with_suffix(_plain_text(reading._replace(kind=base_of(reading.kind))), reading.kind)


def _plain_text(reading: Reading) -> str:
    area = "/m2" if reading.area else ""
    if reading.kind == LUMINOUS and reading.solid_angle and not reading.time:
        return f"cd{area}{COHERENT_AXES[reading.axis]}"
    head = COHERENT_HEADS[reading.kind, reading.time]
    if head + area == "lm/m2":
        head, area = "lx", ""
    per_angle = "/sr" if reading.solid_angle else ""
    return f"{head}{area}{per_angle}{COHERENT_AXES[reading.axis]}"


RATIO_UNITS = {RADIANT: "W", LUMINOUS: "lm", PHOTON: "photon"}


def ratio_unit(over: str, under: str) -> str:
    """Return the coherent unit of a ratio of two kinds: lm/W, photon/J, W_mel/lm."""
    rates = base_of(over) == PHOTON, base_of(under) == PHOTON
    heads = [with_suffix(RATIO_UNITS[base_of(kind)], kind) for kind in (over, under)]
    if rates[0] != rates[1]:  # photons, and the energy of the other kind
        k = rates.index(False)
        is_watt = base_of((over, under)[k]) == RADIANT
        heads[k] = with_suffix("J", (over, under)[k]) if is_watt else f"{heads[k]} s"
    if " " in heads[1]:
        heads[1] = f"({heads[1]})"
    return "/".join(heads)


def describe(unit: Unit) -> str:
    """Return a unit for a message: 'luminous flux (lm)', or 'kg.m' if the quantity has no name."""
    name = name_of(unit)
    text = quote(unit.text)
    return f"{name} ({text})" if name else f"'{text}'"
