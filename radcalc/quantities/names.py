"""The names of the quantities of light in English, Czech and Russian, and their units.

The names are those of the CIE's vocabulary (ILV, IEC 60050-845) and ISO 80000-7, and their Czech
and Russian equivalents; an empty name means that no settled one is known, and the English one is
used.  The first of several names is preferred; the others are also in use: "iradiance" and
"radiozita" in Czech lecture notes on computer graphics, "hustota zářivého toku" in Czech Wikipedia
("Intenzita záření", which distinguishes radiozita from intenzita vyzařování), "ozáření" for W/m2
in WikiSkripta ("Radiometrické veličiny"), "poměrná spektrální světelná účinnost" in Světlopedia
("Světelná účinnost") and "intenzita ozařování" in Reichl's Encyklopedie fyziky.
The definitions are radcalc's own.  The tables are in `data`.

The units of a quantity are those for `convert` without a target, for `units` and for completion.
"""

import os
from typing import Any, NamedTuple

from radcalc.errors import ConditionError, UnitError, quote
from radcalc.quantities import (
    KIND_NAMES,
    LUMINOUS,
    NONE,
    PER_ENERGY,
    PER_FREQUENCY,
    PER_WAVELENGTH,
    PER_WAVENUMBER,
    PHOTON,
    RADIANT,
    base_of,
    coherent_text,
    is_per_length,
    name_of,
    of_kind,
    own_name,
    ratio_of,
    read,
    with_suffix,
)
from radcalc.units import WEIGHT_AT, Dimension, Unit
from radcalc.units.compiled import NAMES, PREFIX_SYMBOLS, SYMBOLS, UNITS, WEIGHTS
from radcalc.units.dimensions import SUFFIXES, UNITS_OF_BASES
from radcalc.units.table import resolve, unit_of


class Quantity(NamedTuple):
    """A quantity: symbol, unit, names separated by commas, and a definition in one line."""

    symbol: str
    unit: str
    en: str
    cs: str
    ru: str
    definition: str

    def names(self, language: str) -> list[str]:
        text: str = getattr(self, language)
        return text.split(", ") if text else []

    def name(self, language: str) -> str:
        return (self.names(language) or self.names("en"))[0]


def data_rows(
    name: str, folder: str = "quantities/data", *, with_titles: bool = False
) -> list[list[str]]:
    """Return the rows of a table of the package, below remarks and titles, with all their cells."""
    path = os.path.join(os.path.dirname(os.path.dirname(__file__)), folder, f"{name}.tsv")
    with open(path, encoding="utf-8") as file:
        lines = [line.rstrip("\n") for line in file if line[0] != "#"]
    count = lines[0].count("\t")
    rows = lines if with_titles else lines[1:]
    return [(line + "\t" * (count - line.count("\t"))).split("\t") for line in rows]


QUANTITIES = tuple([Quantity(*row) for row in data_rows("quantities")])
# Labels of other quantities in the tables of the commands: English, then Czech and Russian.
LABELS = {row[0]: (row[1], row[2]) for row in data_rows("labels")}
# Words before, inside or after the name of a quantity: mean illuminance, luminous flux within.
PARTS = {
    "mean": ("průměrná {}", "средняя {}"),
    "minimum": ("minimální {}", "минимальная {}"),
    "maximum": ("maximální {}", "максимальная {}"),
    "peak": ("maximální {}", "максимальная {}"),
    "toward": ("{} v daném směru", "{} в заданном направлении"),
    "upward": ("{} do horního poloprostoru", "{} в верхнюю полусферу"),
    "downward": ("{} do dolního poloprostoru", "{} в нижнюю полусферу"),
    "received": ("{} dopadající na přijímač", "{}, падающий на приёмник"),
    "within": ("{} v daném kuželu", "{} в заданном конусе"),
    "beam": ("{} ve svazku", "{} в пучке"),
    "incident": ("{} odrazné plochy", "{} отражающей поверхности"),
    "far field": ("{} v dalekém poli", "{} в дальней зоне"),
    "zenith": ("{} v zenitu", "{} в зените"),
    "horizontal": ("horizontální {}", "горизонтальная {}"),
    "global": ("globální {}", "суммарная {}"),
    "diffuse": ("difuzní {}", "рассеянная {}"),
    "direct": ("přímá {}", "прямая {}"),
    "installed": ("{} po montáži", "{} после установки"),
    "limit": ("mez: {}", "предел: {}"),
    "relative": ("poměrná {}", "относительная {}"),
    "sun": ("{} od Slunce", "{} от Солнца"),
}

# Names in German (DIN 5031, dtv) and Polish (PN-EN 12665), for searches only.
ELSEWHERE = {
    "Q_e": "Strahlungsenergie, energia promieniowania",
    "Q_v": "Lichtmenge, ilość światła",
    "Φ_e": "Strahlungsleistung, Strahlungsfluss, strumień energetyczny, moc promieniowania",
    "Φ_v": "Lichtstrom, strumień świetlny",
    "I_e": "Strahlstärke, natężenie promieniowania",
    "I_v": "Lichtstärke, światłość",
    "E_e": "Bestrahlungsstärke, natężenie napromienienia",
    "E_v": "Beleuchtungsstärke, natężenie oświetlenia",
    "M_e": "spezifische Ausstrahlung, egzytancja energetyczna",
    "M_v": "spezifische Lichtausstrahlung, egzytancja świetlna",
    "L_e": "Strahldichte, luminancja energetyczna",
    "L_v": "Leuchtdichte, luminancja",
    "H_e": "Bestrahlung, napromienienie",
    "H_v": "Belichtung, naświetlenie",
    "η_v": "Lichtausbeute, skuteczność świetlna",
    "Ω": "Raumwinkel, kąt bryłowy",
}
# Other names of the quantities of `LABELS`, in all languages, for searches only.
OTHER_NAMES = {
    "reflectance": "albedo, odrazivost, Reflexionsgrad, współczynnik odbicia",
    "transmittance": "propustnost, Transmissionsgrad, współczynnik przepuszczania",
    "absorptance": "pohltivost, Absorptionsgrad",
    "wavelength": "Wellenlänge, długość fali",
    "frequency": "kmitočet, Frequenz, częstotliwość",
    "wavenumber": "Wellenzahl, liczba falowa",
    "polar": "polar angle, zenith angle, zenitový úhel, зенитный угол",
    "correlated colour temperature": "CCT, цветовая температура, teplota chromatičnosti",
    "azimuth": "azimuth angle, azimutální úhel, азимутальный угол",
    "refractive index": "index of refraction, Brechungsindex, współczynnik załamania",
    "emissivity": "Emissionsgrad, степень черноты, emisyjność",
}

PPFD, PPF = ("ppfd", "photosynthetic photon flux density", "par"), ("ppf",)
SOLAR = ("ghi", "dni", "dhi", "gti", "poa")  # irradiances of the sun and the sky
DLI = ("dli", "daily light integral")
# Misnomers: the terms, then the symbol of the quantity that is meant, and an explanation.
MISNOMERS = tuple([(tuple(row[0].split(" | ")), row[1], row[2]) for row in data_rows("misnomers")])


# Derived units without a name are products: a head for kind and time, and divisors.  The candela
# is already per steradian.
HEADS = {
    (RADIANT, 0): ("W", "kW", "mW", "uW"),
    (RADIANT, 1): ("J", "kJ", "mJ", "uJ"),
    (LUMINOUS, 0): ("lm", "klm"),
    (LUMINOUS, 1): ("lm.s", "lm.h"),
    (PHOTON, 0): ("umol", "mol", "photon"),
    (PHOTON, 1): ("umol", "mol", "photon"),
}
CANDELAS = {0: ("cd", "kcd", "mcd"), 1: ("cd.s",)}
AREAS = {0: ("",), 1: ("/m2", "/cm2")}
CUSTOMARY_AREAS = {0: (), 1: ("/ft2", "/in2")}
AXES = {
    NONE: ("",),
    PER_WAVELENGTH: ("/nm", "/um"),
    PER_FREQUENCY: ("/Hz", "/THz"),
    PER_WAVENUMBER: ("/cm-1",),
    PER_ENERGY: ("/eV",),
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
    reading = read(unit)
    if reading is None or reading.retinal:
        return list(COMPOSED.get(name_of(unit), ()))
    base = base_of(reading.kind)
    heads: tuple[str, ...] = HEADS[base, reading.time]
    per_angle = "/sr" if reading.solid_angle else ""
    per_time = "/s" if base == PHOTON and not reading.time else ""
    if base == LUMINOUS and reading.solid_angle:
        heads, per_angle = CANDELAS[reading.time], ""
    areas = [(head, area) for head in heads for area in AREAS[reading.area]]
    areas += [(heads[0], area) for area in CUSTOMARY_AREAS[reading.area]]
    axes = PER_LENGTH if is_per_length(unit) else AXES[reading.axis]
    products = [head + area + per_angle + per_time + axis for head, area in areas for axis in axes]
    return [with_suffix(text, reading.kind) for text in products]


def units_of(unit: Unit) -> list[str]:
    """Return the spellings of every unit that measures the quantity of `unit`."""
    from radcalc.units.catalogue import CATALOGUE

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
    """Return `units_of` in the order of use: symbols, products, names without a symbol.

    Symbols of a quantity with a name of its own (UVI) are after the products of a weight.
    """

    def place(text: str) -> int:
        is_own = bool(unit.dimension[WEIGHT_AT]) and bool(own_name(resolve(text)))
        return 2 if text in NAMES else "/" in text or "." in text or is_own

    return sorted(units_of(unit), key=place)


def full_name(unit: Unit) -> str:
    """Return the name of a unit (footcandle), or the quantity of a product (irradiance)."""
    if len(unit.atoms) == 1 and unit.atoms[0][1] == 1:
        return unit.atoms[0][0].replace("_", " ")
    return name_of(unit)


# Units in the kind of light of an observer or a weight: lumens of scotopic eyes, lm_scot.


def kind_of(unit: Unit) -> str:
    """Return the kind of light of a unit; '' for another quantity."""
    reading = None if unit.is_scale else read(unit)
    return reading.kind if reading else ""


def as_seen(unit: Unit, kind: str) -> Unit:
    """Return a unit of lumens, or of a ratio of them, as that of an observer's kind."""
    if kind == LUMINOUS or unit.is_scale:
        return unit
    pair = ratio_of(unit.dimension)
    if kind_of(unit) == LUMINOUS or (pair and LUMINOUS in pair):
        return _in_kind(unit, kind)
    return unit


def is_seen(unit: Unit, kind: str) -> bool:
    """Return whether a unit is of the lumens of an observer's kind, or a ratio of them."""
    pair = None if unit.is_scale else ratio_of(unit.dimension)
    return kind in (kind_of(unit), *(pair or ()))


def weighted(unit: Unit, kind: str) -> Unit:
    """Return a unit as that of a weight: W/m2 as W_mel/m2; as it is, if it is of a weight.

    Raises UnitError if the light has no such unit in the kind.
    """
    own = kind_of(unit)
    return unit if own in WEIGHTS or not own else _in_kind(unit, kind)


def _in_kind(unit: Unit, kind: str) -> Unit:
    """Return a unit in a weighted kind: with the suffix of the kind at its light."""
    texts = [f"{WEIGHTS[kind][3]}_{unit.text.lower()}"]
    for start, c in enumerate(unit.text):
        if c.isalpha() and not unit.text[max(start - 1, 0) : start].isalpha():
            texts.append(unit.text[:start] + with_suffix(unit.text[start:], kind))
    for text in texts:
        if (found := unit_of(text)) and is_seen(found, kind):
            return found.of_class(type(unit)) if unit.is_exitance else found
    raise UnitError(
        f"'{quote(unit.text)}' is not a unit of {KIND_NAMES[kind]} light", _usual(unit, kind)
    )


def _usual(unit: Unit, kind: str) -> str:
    reading = read(unit)
    if reading is None or reading.retinal:
        return "a unit of watts, lumens or photons"
    return f"the amount in {coherent_text(reading._replace(kind=kind))}"


MOST_WEIGHTS = 200  # of files


def add_weight(name: str, base: str, source: str) -> str:
    """Add a weight of a file to the tables of kinds and units; return its kind.

    The kind is the name in letters, with more of them if it is that of another weight or unit.
    """
    kind = "".join([c for c in name.lower() if "a" <= c <= "z"]) or "own"
    while kind in WEIGHTS or any(unit_of(f"{s}_{kind}") for s, _ in UNITS_OF_BASES[base]):
        kind += "x"
    if len(WEIGHTS) > MOST_WEIGHTS:
        raise ConditionError(f"more than {MOST_WEIGHTS} weights", "fewer files")
    from radcalc.quantities.symbols import forget_weights
    from radcalc.units.catalogue import CATALOGUE

    WEIGHTS[kind] = (name, base, name, kind)
    SUFFIXES.append(kind)
    KIND_NAMES[kind] = name
    for symbol, plain in UNITS_OF_BASES[base]:
        top, bottom, dimension, prefixes = UNITS[plain]
        spelled, full = f"{symbol}_{kind}", f"{kind}_{plain}"
        row: Any = (top, bottom, of_kind(dimension, kind), prefixes)
        UNITS[full] = row
        SYMBOLS[spelled], NAMES[full] = full, full
        CATALOGUE[full] = ((spelled,), (full,), f"{plain} of {name}", source)
    forget_weights()
    return kind
