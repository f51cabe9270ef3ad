"""The names of the quantities of light in English, Czech and Russian.

The names of the grid are those of the CIE's vocabulary (ILV, IEC 60050-845) and ISO 80000-7 and
of their Czech and Russian usage; where no settled name is known the place is empty, and English
serves.  Of several names the first is the one to use; the others are found in use, as "iradiance"
and "radiozita" are in Czech lecture notes on computer graphics, "hustota zářivého toku" in Czech
Wikipedia ("Intenzita záření", which tells radiozita from intenzita vyzařování), "ozáření" for W/m2
in WikiSkripta ("Radiometrické veličiny") and "poměrná spektrální světelná účinnost" in Světlopedia
("Světelná účinnost").  The definitions are radcalc's own words.
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
    ("Q_v", "lm s", "luminous energy, quantity of light", "světelné množství, světelná energie",
     "световая энергия",
     "Luminous flux summed over time."),
    ("Q_p", "photon", "photon number", "počet fotonů", "число фотонов",
     "How many photons are sent out, carried or received."),
    ("Φ_e", "W", "radiant flux, radiant power", "zářivý tok",
     "поток излучения, лучистый поток, энергетический поток",
     "Power of radiation: radiant energy per time."),
    ("Φ_v", "lm", "luminous flux, luminous power", "světelný tok, světelný výkon", "световой поток",
     "Radiant flux as the eye weighs it: each wavelength by Km V(λ)."),
    ("Φ_p", "photon/s", "photon flux", "fotonový tok", "поток фотонов",
     "Photons per time."),
    ("I_e", "W/sr", "radiant intensity", "zářivost",
     "сила излучения, энергетическая сила света, энергетическая сила излучения",
     "Radiant flux of a source per solid angle, in one direction."),
    ("I_v", "cd", "luminous intensity", "svítivost", "сила света",
     "Luminous flux of a source per solid angle, in one direction."),
    ("I_p", "photon/s/sr", "photon intensity", "fotonová zářivost", "сила излучения фотонов",
     "Photon flux of a source per solid angle, in one direction."),
    ("E_e", "W/m2", "irradiance", "ozářenost, iradiance",
     "энергетическая освещённость, облучённость",
     "Radiant flux that falls on a surface, per area."),
    ("E_v", "lx", "illuminance", "osvětlenost", "освещённость, световая освещённость",
     "Luminous flux that falls on a surface, per area."),
    ("E_p", "photon/m2/s", "photon irradiance", "fotonová ozářenost", "облучённость фотонов",
     "Photon flux that falls on a surface, per area."),
    ("M_e", "W/m2", "radiant exitance, radiosity",
     "intenzita vyzařování, intenzita vyzáření, zářivá exitance, radiozita",
     "энергетическая светимость",
     "Radiant flux that leaves a surface in all directions, per area."),
    ("M_v", "lm/m2", "luminous exitance", "světlení", "светимость",
     "Luminous flux that leaves a surface in all directions, per area."),
    ("M_p", "photon/m2/s", "photon exitance", "", "",
     "Photon flux that leaves a surface in all directions, per area."),
    ("L_e", "W/m2/sr", "radiance", "zář", "энергетическая яркость",
     "Radiant flux per solid angle and per area as that direction sees it."),
    ("L_v", "cd/m2", "luminance", "jas", "яркость, световая яркость",
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
    ("V(λ)", "1", "luminous efficiency",
     "poměrná světelná účinnost, poměrná spektrální světelná účinnost",
     "относительная световая эффективность",
     "Luminous efficacy at a wavelength over its maximum."),
    ("Ω", "sr", "solid angle", "prostorový úhel", "телесный угол",
     "Area that a cone cuts from a sphere about its tip, over the radius squared."),
    ("Ω_p", "sr", "projected solid angle",
     "průmět prostorového úhlu, promítnutý prostorový úhel",
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
    "u on a mirror ball": ("u na zrcadlové kouli", "u на зеркальном шаре"),
    "v on a mirror ball": ("v na zrcadlové kouli", "v на зеркальном шаре"),
    "w on a mirror ball": ("w na zrcadlové kouli", "w на зеркальном шаре"),
    "incidence": ("úhel dopadu", "угол падения"),
    "frequency": ("frekvence", "частота"),
    "wavelength": ("vlnová délka", "длина волны"),
    "wavenumber": ("vlnočet", "волновое число"),
    "photon energy": ("energie fotonu", "энергия фотона"),
    "mean photon energy": ("střední energie fotonu", "средняя энергия фотона"),
    "reflectance": ("činitel odrazu", "коэффициент отражения"),
    "absorptance": ("činitel pohlcení", "коэффициент поглощения"),
    "responsivity": ("citlivost detektoru", "чувствительность приёмника"),
    "current": ("proud", "ток"),
    "electric current": ("elektrický proud", "электрический ток"),
    "numerical aperture": ("numerická apertura", "числовая апертура"),
    "f-number": ("clonové číslo", "диафрагменное число"),
    "correlated colour temperature": (
        "náhradní teplota chromatičnosti",
        "коррелированная цветовая температура",
    ),
    "mesopic luminance": ("mezopický jas", "мезопическая яркость"),
    "scotopic luminance": ("skotopický jas", "скотопическая яркость"),
    "flux": ("tok", "поток"),
    "bandwidth": ("šířka pásma", "ширина полосы"),
    "efficacy": ("poměr veličin", "отношение величин"),
    "offset": ("odsazení od osy", "смещение от оси"),
    "offset along y": ("odsazení ve směru y", "смещение вдоль y"),
    "tilt": ("sklon", "наклон"),
    "rotate": ("otočení", "поворот"),
    "receiver area": ("plocha přijímače", "площадь приёмника"),
    "receiver radius": ("poloměr přijímače", "радиус приёмника"),
    "receiver diameter": ("průměr přijímače", "диаметр приёмника"),
    "configuration factor": ("úhlový součinitel", "угловой коэффициент"),
    "fraction of the sphere": ("část plného prostorového úhlu", "доля полного телесного угла"),
    "apex angle of the equal cone": (
        "vrcholový úhel stejného kužele",
        "угол при вершине равного конуса",
    ),
    "half angle of the equal cone": (
        "poloviční vrcholový úhel stejného kužele",
        "половина угла при вершине равного конуса",
    ),
    "exponent": ("exponent", "показатель степени"),
    "beam angle": ("úhel vyzařování", "угол излучения"),
    "field angle": ("úhel vyzařování při 10 %", "угол излучения по уровню 10 %"),
    "beam angle in C90-C270": ("úhel vyzařování v C90-C270", "угол излучения в C90-C270"),
    "field angle in C90-C270": (
        "úhel vyzařování při 10 % v C90-C270",
        "угол излучения по уровню 10 % в C90-C270",
    ),
    "half angle of the part": ("poloviční vrcholový úhel části", "половина угла при вершине части"),
    "angle off the axis": ("úhel od osy", "угол от оси"),
    "beam diameter": ("průměr svazku", "диаметр пучка"),
    "polar angle of the peak": ("polární úhel maxima", "полярный угол максимума"),
    "azimuth of the peak": ("azimut maxima", "азимут максимума"),
    "light output ratio": ("účinnost svítidla", "КПД светильника"),
    "input power": ("příkon", "потребляемая мощность"),
    "luminous efficacy of the source": ("měrný výkon zdroje", "световая отдача источника"),
    "polar": ("polární úhel", "полярный угол"),
    "elevation": ("výškový úhel", "угол возвышения"),
    "horizontal": ("vodorovný úhel", "горизонтальный угол"),
    "vertical": ("svislý úhel", "вертикальный угол"),
    "far-field etendue": ("étendue v dalekém poli", "геометрический фактор в дальней зоне"),
    "diagonal": ("úhlopříčka", "диагональ"),
    "aspect": ("poměr stran", "соотношение сторон"),
    "gain": ("činitel zisku plátna", "коэффициент усиления экрана"),
    "uniformity, minimum over mean": (
        "rovnoměrnost osvětlení, minimum ku průměru",
        "равномерность освещённости, минимум к среднему",
    ),
    "minimum over maximum": ("minimum ku maximu", "минимум к максимуму"),
    "pupil": ("průměr zornice", "диаметр зрачка"),
    "exposure value": ("expoziční hodnota", "экспозиционное число"),
    "exposure value at ISO 100": (
        "expoziční hodnota při ISO 100",
        "экспозиционное число при ISO 100",
    ),
    "ISO speed": ("citlivost ISO", "светочувствительность ISO"),
    "meter constant K": ("konstanta expozimetru K", "постоянная экспонометра K"),
    "meter constant C": ("konstanta expozimetru C", "постоянная экспонометра C"),
    "saturation luminance": ("jas nasycení", "яркость насыщения"),
    "temperature rise": ("oteplení", "повышение температуры"),
    "heat": ("teplo", "теплота"),
    "accuracy": ("přesnost", "точность"),
    "sun elevation": ("výška Slunce", "высота Солнца"),
    "sun azimuth": ("azimut Slunce", "азимут Солнца"),
    "angular radius of the sun": ("úhlový poloměr Slunce", "угловой радиус Солнца"),
    "daylight share of the plane": (
        "podíl denního světla na rovině",
        "доля дневного света на плоскости",
    ),
    "sun luminance": ("jas Slunce", "яркость Солнца"),
    "sun radiance": ("zář Slunce", "энергетическая яркость Солнца"),
    "sun photon radiance": ("fotonová zář Slunce", "яркость фотонов Солнца"),
    "covered share of the sphere": ("pokrytá část koule", "охваченная доля сферы"),
    "fall-off exponent": ("exponent poklesu", "показатель спада"),
    "fall-off distance": ("vzdálenost poklesu", "расстояние спада"),
    "maximum of the fall-off": ("maximum poklesu", "максимум спада"),
    "beam exponent": ("exponent svazku", "показатель пучка"),
    "roundness": ("zaoblení", "закруглённость"),
    "attenuation": ("zeslabení", "ослабление"),
    "attenuation by depth": ("zeslabení hloubkou", "ослабление по глубине"),
    "attenuation by the superellipse": ("zeslabení superelipsou", "ослабление суперэллипсом"),
    "attenuation by the beam": ("zeslabení svazkem", "ослабление пучком"),
    "attenuation by the fall-off": ("zeslabení poklesem", "ослабление спадом"),
    "scotopic luminous efficiency": (
        "poměrná skotopická světelná účinnost",
        "относительная скотопическая световая эффективность",
    ),
    "scotopic luminous efficacy": (
        "skotopická světelná účinnost záření",
        "скотопическая световая эффективность излучения",
    ),
    "scotopic/photopic ratio": ("poměr S/P", "отношение S/P"),
    "photon efficacy": ("fotonová účinnost", "фотонная эффективность"),
    "lux per PPFD": ("luxy na PPFD", "люксы на PPFD"),
    "peak wavelength": ("vlnová délka maxima", "длина волны максимума"),
    "centroid wavelength": ("těžišťová vlnová délka", "центроидная длина волны"),
    "full width at half maximum": ("šířka v polovině maxima", "ширина на полувысоте"),
    "start of range": ("začátek rozsahu", "начало диапазона"),
    "end of range": ("konec rozsahu", "конец диапазона"),
    "fraction in range": ("podíl v rozsahu", "доля в диапазоне"),
    "chromaticity x": ("trichromatická souřadnice x", "координата цветности x"),
    "chromaticity y": ("trichromatická souřadnice y", "координата цветности y"),
    "distance from the Planckian": ("vzdálenost od Planckovy čáry", "расстояние от линии Планка"),
    "colour rendering index": ("index podání barev", "индекс цветопередачи"),
    "adaptation coefficient": ("koeficient adaptace", "коэффициент адаптации"),
    "integral": ("integrál", "интеграл"),
    "estimate of the error": ("odhad chyby", "оценка погрешности"),
    "estimate of the flux's error": ("odhad chyby toku", "оценка погрешности потока"),
}
# Words before, in or behind the name of a quantity: mean illuminance, luminous flux within.
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
    "relative": ("poměrná {}", "относительная {}"),
    "sun": ("{} od Slunce", "{} от Солнца"),
}

PPFD, PPF = ("ppfd", "photosynthetic photon flux density", "par"), ("ppf",)
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
        ("radiosity", "radiozita"),
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
        ("intenzita ozáření", "insolation"),
        "E_e",
        "what falls on a surface, in W/m2, is irradiance (ozářenost)",
    ),
    (
        ("brightness", "jasnost"),
        "L_v",
        "brightness is what is felt; what is measured, in cd/m2, is luminance",
    ),
    (
        ("power", "optical power", "zářivý výkon", "výkon", "мощность излучения", "мощность"),
        "Φ_e",
        "the power of radiation is its radiant flux; what a lamp takes from the mains is another",
    ),
    (
        ("ozáření",),
        "E_e",
        "ozáření is radiant exposure (J/m2), but irradiance (W/m2) in some courses",
    ),
    (
        ("flux density", "hustota toku", "hustota zářivého toku", "плотность потока"),
        "E_e",
        "the flux density of what falls on a surface, in W/m2, is irradiance",
    ),
    (
        ("flux density", "hustota toku", "hustota zářivého toku", "плотность потока"),
        "M_e",
        "the flux density of what leaves a surface, in W/m2, is radiant exitance",
    ),
    (
        ("flux density", "hustota toku", "hustota světelného toku", "плотность потока"),
        "E_v",
        "the flux density of light that falls on a surface, in lx, is illuminance",
    ),
    (
        ("hustota světelného toku",),
        "M_v",
        "the flux density of light that leaves a surface, in lm/m2, is luminous exitance",
    ),
    (
        ("spektrální světelná účinnost",),
        "V(λ)",
        "relative to its maximum, 1 at 555 nm, it is the luminous efficiency V(λ)",
    ),
    (
        ("spektrální světelná účinnost",),
        "K",
        "in lm/W it is the luminous efficacy of one wavelength, K(λ)",
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
        PPFD,
        "E_p",
        "PPFD is the photon irradiance from 400 nm to 700 nm, mostly in umol/m2/s",
    ),
    (PPF, "Φ_p", "PPF is the photon flux from 400 nm to 700 nm, mostly in umol/s"),
    (("throughput", "geometrical extent"), "G", "that is the etendue of a beam"),
    (
        ("W m-1 sr-1", "W/m/sr", "Вт м-1 ср-1", "Вт/м/ср"),
        "L_e",
        "a radiance is per area: W/m2/sr, not W/m/sr",
    ),
    (("Ст",), "Ω", "Ст is the stokes, a unit of viscosity; the steradian is ср, or sr"),
)
