"""The names of the quantities of light in English, Czech and Russian.

The names are those of the CIE's vocabulary (ILV, IEC 60050-845) and ISO 80000-7, and their Czech
and Russian equivalents; an empty name means that no settled one is known, and the English one is
used.  The first of several names is preferred; the others are also in use: "iradiance" and
"radiozita" in Czech lecture notes on computer graphics, "hustota zářivého toku" in Czech Wikipedia
("Intenzita záření", which distinguishes radiozita from intenzita vyzařování), "ozáření" for W/m2
in WikiSkripta ("Radiometrické veličiny"), "poměrná spektrální světelná účinnost" in Světlopedia
("Světelná účinnost") and "intenzita ozařování" in Reichl's Encyklopedie fyziky.
The definitions are radcalc's own.  The tables are in `data`.
"""

import os
from typing import NamedTuple


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


def data_rows(name: str, folder: str = "quantities/data") -> list[list[str]]:
    """Return the rows of a table of the package, below remarks and titles, with all their cells."""
    path = os.path.join(os.path.dirname(os.path.dirname(__file__)), folder, f"{name}.tsv")
    with open(path, encoding="utf-8") as file:
        lines = [line.rstrip("\n") for line in file if line[0] != "#"]
    count = lines[0].count("\t")
    return [(line + "\t" * (count - line.count("\t"))).split("\t") for line in lines[1:]]


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
