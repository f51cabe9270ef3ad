"""The names of the quantities of light in English, Czech and Russian.

The names of the grid are those of the CIE's vocabulary (ILV, IEC 60050-845) and ISO 80000-7 and
of their Czech and Russian usage; where no settled name is known the place is empty, and English
serves.  Of several names the first is the one to use.  The definitions are radcalc's own words.
"""

from typing import NamedTuple


class Quantity(NamedTuple):
    """A quantity: symbol, unit, its names parted by commas, and what it is in one line."""

    symbol: str
    unit: str
    en: str
    cs: str
    ru: str
    definition: str

    def names(self, language: str) -> list[str]:
        """The names in one language, the first to be preferred."""
        text: str = getattr(self, language)
        return text.split(", ") if text else []

    def name(self, language: str) -> str:
        """The name to use in a language; the English one where it has none."""
        return (self.names(language) or self.names("en"))[0]


# Radiometric beside photometric beside photon, then spectral densities, then the rest.
# fmt: off
_ROWS = (
    ("Q_e", "J", "radiant energy", "zářivá energie", "энергия излучения",
     "Energy sent out, carried or received as radiation."),
    ("Q_v", "lm s", "luminous energy, quantity of light", "světelné množství",
     "световая энергия",
     "Luminous flux summed over time."),
    ("Q_p", "photon", "photon number", "počet fotonů", "число фотонов",
     "How many photons are sent out, carried or received."),
    ("Φ_e", "W", "radiant flux, radiant power", "zářivý tok", "поток излучения",
     "Power of radiation: radiant energy per time."),
    ("Φ_v", "lm", "luminous flux", "světelný tok", "световой поток",
     "Radiant flux as the eye weighs it: each wavelength by Km V(λ)."),
    ("Φ_p", "photon/s", "photon flux", "fotonový tok", "поток фотонов",
     "Photons per time."),
    ("I_e", "W/sr", "radiant intensity", "zářivost", "сила излучения",
     "Radiant flux of a source per solid angle, in one direction."),
    ("I_v", "cd", "luminous intensity", "svítivost", "сила света",
     "Luminous flux of a source per solid angle, in one direction."),
    ("I_p", "photon/s/sr", "photon intensity", "fotonová zářivost", "сила излучения фотонов",
     "Photon flux of a source per solid angle, in one direction."),
    ("E_e", "W/m2", "irradiance", "ozářenost", "энергетическая освещённость, облучённость",
     "Radiant flux that falls on a surface, per area."),
    ("E_v", "lx", "illuminance", "osvětlenost", "освещённость",
     "Luminous flux that falls on a surface, per area."),
    ("E_p", "photon/m2/s", "photon irradiance", "fotonová ozářenost", "облучённость фотонов",
     "Photon flux that falls on a surface, per area."),
    ("M_e", "W/m2", "radiant exitance, radiosity", "intenzita vyzařování",
     "энергетическая светимость",
     "Radiant flux that leaves a surface in all directions, per area."),
    ("M_v", "lm/m2", "luminous exitance", "světlení", "светимость",
     "Luminous flux that leaves a surface in all directions, per area."),
    ("M_p", "photon/m2/s", "photon exitance", "", "",
     "Photon flux that leaves a surface in all directions, per area."),
    ("L_e", "W/m2/sr", "radiance", "zář", "энергетическая яркость",
     "Radiant flux per solid angle and per area as that direction sees it."),
    ("L_v", "cd/m2", "luminance", "jas", "яркость",
     "Luminous flux per solid angle and per area as that direction sees it."),
    ("L_p", "photon/m2/s/sr", "photon radiance", "fotonová zář", "яркость фотонов",
     "Photon flux per solid angle and per area as that direction sees it."),
    ("H_e", "J/m2", "radiant exposure", "ozáření, dávka", "энергетическая экспозиция",
     "Radiant energy that a surface has received, per area."),
    ("H_v", "lx s", "luminous exposure", "osvit", "световая экспозиция",
     "Luminous energy that a surface has received, per area."),
    ("H_p", "photon/m2", "photon exposure", "", "",
     "Photons that a surface has received, per area."),
    ("Φ_e,λ", "W/nm", "spectral radiant flux", "spektrální zářivý tok",
     "спектральная плотность потока излучения",
     "Radiant flux per wavelength."),
    ("I_e,λ", "W/sr/nm", "spectral radiant intensity", "spektrální zářivost",
     "спектральная плотность силы излучения",
     "Radiant intensity per wavelength."),
    ("E_e,λ", "W/m2/nm", "spectral irradiance", "spektrální ozářenost",
     "спектральная плотность энергетической освещённости",
     "Irradiance per wavelength."),
    ("M_e,λ", "W/m2/nm", "spectral radiant exitance", "spektrální intenzita vyzařování",
     "спектральная плотность энергетической светимости",
     "Radiant exitance per wavelength."),
    ("L_e,λ", "W/m2/sr/nm", "spectral radiance", "spektrální zář",
     "спектральная плотность энергетической яркости",
     "Radiance per wavelength."),
    ("K", "lm/W", "luminous efficacy, luminous efficacy of radiation",
     "světelná účinnost záření", "световая эффективность излучения",
     "Luminous flux of a radiation over its radiant flux."),
    ("η_v", "lm/W", "luminous efficacy of a source", "měrný výkon", "световая отдача",
     "Luminous flux of a lamp over the power that it takes from the mains."),
    ("V(λ)", "1", "luminous efficiency", "poměrná světelná účinnost",
     "относительная световая эффективность",
     "Luminous efficacy at a wavelength over its maximum."),
    ("Ω", "sr", "solid angle", "prostorový úhel", "телесный угол",
     "Area that a cone cuts from a sphere about its tip, over the radius squared."),
    ("Ω_p", "sr", "projected solid angle", "průmět prostorového úhlu",
     "проекция телесного угла",
     "Solid angle, each direction weighed by its cosine to a surface's normal."),
    ("G", "m2 sr", "etendue, optical extent", "étendue", "геометрический фактор",
     "Area of a beam times its projected solid angle."),
    ("E_T", "td", "retinal illuminance", "osvětlenost sítnice", "освещённость сетчатки",
     "Luminance times the area of the pupil through which it is seen."),
)
# fmt: on
QUANTITIES = tuple(Quantity(*row) for row in _ROWS)

# Other quantities in the tables of the commands: English, then Czech and Russian.
LABELS = {
    "per wavelength": ("podle vlnové délky", "по длине волны"),
    "per frequency": ("podle frekvence", "по частоте"),
    "per wavenumber": ("podle vlnočtu", "по волновому числу"),
    "length": ("délka", "длина"),
    "width": ("šířka", "ширина"),
    "height": ("výška", "высота"),
    "distance": ("vzdálenost", "расстояние"),
    "radius": ("poloměr", "радиус"),
    "diameter": ("průměr", "диаметр"),
    "area": ("plocha", "площадь"),
    "volume": ("objem", "объём"),
    "mass": ("hmotnost", "масса"),
    "time": ("čas", "время"),
    "speed": ("rychlost", "скорость"),
    "temperature": ("teplota", "температура"),
    "specific heat": ("měrná tepelná kapacita", "удельная теплоёмкость"),
    "specific heat capacity": ("měrná tepelná kapacita", "удельная теплоёмкость"),
    "angle": ("úhel", "угол"),
    "polar angle": ("polární úhel", "полярный угол"),
    "azimuth": ("azimut", "азимут"),
    "apex angle": ("vrcholový úhel", "угол при вершине"),
    "half angle": ("poloviční vrcholový úhel", "половина угла при вершине"),
    "incidence": ("úhel dopadu", "угол падения"),
    "frequency": ("frekvence", "частота"),
    "wavelength": ("vlnová délka", "длина волны"),
    "wavenumber": ("vlnočet", "волновое число"),
    "photon energy": ("energie fotonu", "энергия фотона"),
    "mean photon energy": ("střední energie fotonu", "средняя энергия фотона"),
    "reflectance": ("činitel odrazu", "коэффициент отражения"),
    "absorptance": ("činitel pohlcení", "коэффициент поглощения"),
    "numerical aperture": ("numerická apertura", "числовая апертура"),
    "f-number": ("clonové číslo", "диафрагменное число"),
    "correlated colour temperature": (
        "náhradní teplota chromatičnosti",
        "коррелированная цветовая температура",
    ),
    "mesopic luminance": ("mezopický jas", "мезопическая яркость"),
    "scotopic luminance": ("skotopický jas", "скотопическая яркость"),
}

# What people say instead: the terms, then the quantity that is meant by its symbol, and why.
MISNOMERS = (
    (
        ("svítivost",),
        "L_v",
        "luminance (jas, cd/m2) is sometimes called svítivost, which is luminous intensity (cd)",
    ),
    (
        ("luminosity",),
        "M_v",
        "luminous exitance (lm/m2) is sometimes called luminosity in lecture notes",
    ),
    (
        ("luminosity",),
        "Φ_e",
        "luminosity is an astronomer's word for all the power of a star, a radiant flux (W)",
    ),
    (
        ("radiosity",),
        "M_e",
        "radiosity is a heat engineer's word for radiant exitance, reflected light included",
    ),
    (
        ("intensity", "light intensity", "intenzita", "intenzita záření", "интенсивность"),
        "E_e",
        "the intensity of physics, in W/m2, is irradiance; radiant intensity is in W/sr",
    ),
    (
        ("light intensity", "intenzita světla", "интенсивность света"),
        "I_v",
        "a light's intensity is its luminous intensity (cd); what falls on a surface is in lx",
    ),
    (
        ("light intensity", "light level", "illumination", "intenzita osvětlení", "osvětlení"),
        "E_v",
        "what falls on a surface, in lx, is illuminance (osvětlenost)",
    ),
    (
        ("intenzita ozáření", "insolation", "flux density"),
        "E_e",
        "what falls on a surface, in W/m2, is irradiance (ozářenost)",
    ),
    (
        ("brightness", "jasnost"),
        "L_v",
        "brightness is what is felt; what is measured, in cd/m2, is luminance",
    ),
    (
        ("power", "optical power", "zářivý výkon", "мощность излучения"),
        "Φ_e",
        "the power of radiation is its radiant flux",
    ),
    (("emittance", "radiant emittance"), "M_e", "radiant exitance was once called emittance"),
    (
        ("emittance", "luminous emittance"),
        "M_v",
        "luminous exitance was once called luminous emittance",
    ),
    (
        ("dose", "fluence", "доза"),
        "H_e",
        "of a beam that meets a surface squarely the fluence, or dose, is its radiant exposure",
    ),
    (
        ("ppfd", "photosynthetic photon flux density", "par"),
        "E_p",
        "PPFD is the photon irradiance from 400 nm to 700 nm, mostly in umol/m2/s",
    ),
    (("ppf",), "Φ_p", "PPF is the photon flux from 400 nm to 700 nm, mostly in umol/s"),
    (("throughput", "geometrical extent"), "G", "that is the etendue of a beam"),
    (
        ("W m-1 sr-1", "W/m/sr", "Вт м-1 ср-1", "Вт/м/ср"),
        "L_e",
        "a radiance is per area: W/m2/sr, not W/m/sr",
    ),
    (("Ст",), "Ω", "Ст is the stokes, a unit of viscosity; the steradian is ср, or sr"),
)
