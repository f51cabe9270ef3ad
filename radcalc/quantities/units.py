"""The units of a quantity, for `convert` without a target, `units`, and completion."""

from radcalc.quantities import light
from radcalc.units import Dimension, Unit
from radcalc.units.catalogue import CATALOGUE
from radcalc.units.compiled import NAMES, PREFIX_SYMBOLS, UNITS

# Derived units without a name are products: a head for kind and time, and divisors.  The candela
# is already per steradian.
HEADS = {
    (light.RADIANT, 0): ("W", "kW", "mW", "uW"),
    (light.RADIANT, 1): ("J", "kJ", "mJ", "uJ"),
    (light.LUMINOUS, 0): ("lm", "klm"),
    (light.LUMINOUS, 1): ("lm.s", "lm.h"),
    (light.PHOTON, 0): ("umol", "mol", "photon"),
    (light.PHOTON, 1): ("umol", "mol", "photon"),
}
CANDELAS = {0: ("cd", "kcd", "mcd"), 1: ("cd.s",)}
AREAS = {0: ("",), 1: ("/m2", "/cm2")}
CUSTOMARY_AREAS = {0: (), 1: ("/ft2", "/in2")}
AXES = {
    light.NONE: ("",),
    light.PER_WAVELENGTH: ("/nm", "/um"),
    light.PER_FREQUENCY: ("/Hz", "/THz"),
    light.PER_WAVENUMBER: ("/cm-1",),
}
PER_LENGTH = ("/m", "/cm", "/ft")
PREFIXES = "km"
COMPOSED = {
    "length": ("m", "cm", "um", "nm"),
    "area": ("m2", "cm2", "mm2", "ft2", "in2"),
    "volume": ("m3", "cm3", "ft3"),
    "solid angle": ("sr", "msr", "deg2", "arcmin2", "arcsec2"),
    "wavenumber": ("cm-1", "m-1"),
    "etendue": ("m2.sr", "mm2.sr", "cm2.sr"),
    "luminous efficacy": ("lm/W",),
    "photon efficacy": ("umol/J", "mol/J", "photon/J"),
    "luminous efficacy per photon": ("lm.s/umol", "lm.s/photon"),
    "photon energy": ("J/photon", "eV/photon", "kJ/mol"),
    "speed": ("m/s",),
}


def composed(unit: Unit) -> list[str]:
    """Return products of units that measure the quantity of `unit`."""
    reading = light.read(unit)
    if reading is None or reading.retinal:
        return list(COMPOSED.get(light.name_of(unit), ()))
    heads: tuple[str, ...] = HEADS[reading.kind, reading.time]
    per_angle = "/sr" if reading.solid_angle else ""
    per_time = "/s" if reading.kind == light.PHOTON and not reading.time else ""
    if reading.kind == light.LUMINOUS and reading.solid_angle:
        heads, per_angle = CANDELAS[reading.time], ""
    areas = [(head, area) for head in heads for area in AREAS[reading.area]]
    areas += [(heads[0], area) for area in CUSTOMARY_AREAS[reading.area]]
    axes = PER_LENGTH if light.is_per_length(unit) else AXES[reading.axis]
    return [head + area + per_angle + per_time + axis for head, area in areas for axis in axes]


def units_of(unit: Unit) -> list[str]:
    """Return the spellings of every unit that measures the quantity of `unit`."""
    spellings = composed(unit)
    for name in named(unit.dimension):
        symbols = CATALOGUE[name][0]
        spellings.append((symbols or (name,))[0])
        allowed = UNITS[name][3]
        if symbols:
            spellings += [p + symbols[0] for p in PREFIXES if PREFIX_SYMBOLS[p] in allowed]
    return list(dict.fromkeys(spellings))


def named(dimension: Dimension) -> list[str]:
    """Return the named units of a dimension, in the order of the definitions."""
    return [name for name, (_, _, powers, _) in UNITS.items() if powers == dimension]


def offered(unit: Unit) -> list[str]:
    """Return `units_of` in the order of use: symbols, products, names without a symbol."""
    spellings = units_of(unit)
    return sorted(spellings, key=lambda text: 2 if text in NAMES else "/" in text or "." in text)


def full_name(unit: Unit) -> str:
    """Return the name of a unit (footcandle), or the quantity of a product (irradiance)."""
    if len(unit.atoms) == 1 and unit.atoms[0][1] == 1:
        return unit.atoms[0][0].replace("_", " ")
    return light.name_of(unit)
