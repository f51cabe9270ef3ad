"""Typical values: light of the sun, the sky, lamps and screens, and recommended light levels.

Numbers have the digits of their source.  Where common lecture tables are wrong, the value here is
the corrected one, and a note describes the error.
"""

from typing import NamedTuple

from radcalc.quantities.language import LANGUAGES
from radcalc.quantities.light import name_of
from radcalc.units.scales import resolve_any
from radcalc.units.unit import Unit


class Typical(NamedTuple):
    """A value in a unit: a number, or a range such as `0.1 to 0.3`.

    `names` are those of its subject in English, Czech and Russian; `also` has other search words.
    """

    names: tuple[str, str, str]
    value: str
    unit: str
    source: str
    note: str = ""
    also: str = ""

    @property
    def what(self) -> str:
        return self.names[0]

    def name(self, language: str) -> str:
        return self.names[LANGUAGES.index(language)]

    @property
    def low(self) -> float:
        return float(self.value.partition(" to ")[0])

    @property
    def high(self) -> float:
        return float(self.value.rpartition(" to ")[2])

    @property
    def measured(self) -> Unit:
        return resolve_any(self.unit)

    @property
    def quantity(self) -> str:
        """The English name of the quantity of its unit."""
        return name_of(self.measured)


IAU = "IAU 2015 resolution B3"
ASTM = "ASTM G173-03: radcalc spectrum {}"
HAURWITZ = "Haurwitz 1945, J. Meteorology 2: 1098 cos z exp(-0.059/cos z) at air mass 1.5"
SMITH = "Smith, Modern Optical Engineering, 4th ed. (2008), fig. 12.8"
NATURE = "Smith, Modern Optical Engineering, 4th ed. (2008), fig. 12.9: {} fc"
NAVY = "Janiczek and DeYoung 1987, USNO Circular 171: {}"
OVERCAST = "Moon and Spencer 1942, CIE overcast sky: {}"
METEOROLOGY = "American Meteorological Society, Glossary of Meteorology, {} twilight"
KODAK = "Kodak BW400CN, data sheet F-4036: {} at ISO 400"
ROOMS = "ISO 8995-1:2002 (CIE S 008), section 5, general building areas"
WORK_PLACES = "EN 12464-1:2011"
ROADS = "EN 13201-2:2015"
BULBS = "US Department of Energy, Lumens and the Lighting Facts Label"
LAMPS = "US Department of Energy, CALiPER Snapshot Report, LED A lamps (2013)"
BEAM = "UN Regulation 112 (OJ L 250, 2014), 6.2: {}"
LASERS = "IEC 60825-1:2014, class {}"
APOGEE = "Apogee Instruments, conversion of PPF to daily PPF"
UV = "CIE e-ILV 17-26-073: 40 m2/W"
DAYS_16 = "{} mol/m2 over 16 h"

SPACE = ("sun outside the atmosphere", "slunce nad atmosférou", "солнце за атмосферой")
SUNLIGHT = "sunlight sunshine daylight denní světlo sluneční svit солнечный свет дневной свет"
MOON = ("moon's disc", "kotouč měsíce", "диск луны")
DISC = ("sun's disc", "kotouč slunce", "диск солнца")
CLEAR = ("sun at the ground, clear, at most", "slunce u země, jasno, nejvýše",
         "солнце у земли, ясно, не более")  # fmt: skip
CLOUDED = "cloudy clouds oblačno zataženo oblačná obloha облачно пасмурно"
CANDLE = "candlelight flame svíčka svíčky plamen свеча свечи пламя"
BULB = "lamp light bulb tungsten žárovka žárovky lampa лампочка лампа накаливания"
TUBE = "lamp strip light zářivka lampa лампа люминесцентная"
SCREEN = "display brightness obrazovka displej экран дисплей"
EYE = "eye seeing threshold zrak oko práh зрение глаз порог"
ULTRAVIOLET = "sun erythemal ultraviolet slunce ultrafialové солнце ультрафиолет"
DUSK = "twilight dusk dawn soumrak svítání сумерки рассвет"
CAMERA = "photo camera exposure fotografie expozice съёмка экспозиция"
PLANT = "plants growing grow light greenhouse PPFD PAR rostliny skleník растения теплица"
HEADLIGHT = "headlamp car vehicle reflektor světlomet auto фара автомобиль"
TORCH = "flashlight svítilna baterka фонарик фонарь"
STREET = "streetlight lamp road night ulice silnice pouliční lampa улица дорога фонарь"
HOME = "interior room house home indoors interiér pokoj byt интерьер комната дом"
WORK = "interior room indoors interiér místnost интерьер помещение"

VALUES = (
    # the sun
    Typical(SPACE, "1361", "W/m2", IAU, "older texts have 1367 W/m2", SUNLIGHT),
    Typical(SPACE, "133", "klx", ASTM.format("AM0")),
    Typical(
        SPACE,
        "2.0e7",
        "W/m2/sr",
        "1361 W/m2 over the disc's 6.794e-5 sr",
        "the 2.3e7 of some texts is a black body of 6000 K, and does not fit 1367 W/m2 either",
    ),
    Typical(SPACE, "2.0e9", "cd/m2", "133 klx over the disc's 6.794e-5 sr"),
    Typical(
        ("sun at the ground, air mass 1.5, direct, facing it",
         "slunce u země, vzdušná hmota 1,5, přímé", "солнце у земли, воздушная масса 1,5, прямое"),
        "900", "W/m2", ASTM.format("AM1.5D"), "852 W/m2 in lecture tables, at a winter noon",
        SUNLIGHT,
    ),
    Typical(
        ("sun at the ground, air mass 1.5, all light on a horizontal plane",
         "slunce u země, vzdušná hmota 1,5, vše na vodorovné ploše",
         "солнце у земли, воздушная масса 1,5, всё на горизонтальной плоскости"),
        "670", "W/m2", HAURWITZ, "686 W/m2 in lecture tables, at a winter noon", SUNLIGHT,
    ),
    Typical(CLEAR, "1000", "W/m2", ASTM.format("AM1.5G"), also=SUNLIGHT),
    Typical(
        CLEAR, "100 to 110", "klx", f"{ASTM.format('AM1.5G')}; {NATURE.format('10,000')}",
        also=SUNLIGHT,
    ),
    Typical(
        ("sun at the ground, full, for plants", "plné slunce u země, pro rostliny",
         "полное солнце у земли, для растений"),
        "1980", "umol/m2/s", ASTM.format("AM1.5G"), also=f"{SUNLIGHT} {PLANT}",
    ),
    Typical(
        ("sun at the ground, a summer day, for plants", "slunce u země, letní den, pro rostliny",
         "солнце у земли, летний день, для растений"),
        "50 to 60", "mol/m2/day", APOGEE, also=f"DLI {PLANT}",
    ),
    Typical(
        ("sun at the ground, air mass 1.5, disc", "slunce u země, vzdušná hmota 1,5, kotouč",
         "солнце у земли, воздушная масса 1,5, диск"),
        "1.32e7", "W/m2/sr", "900 W/m2 over the disc's 6.794e-5 sr",
        "the 1.4e7 of lecture tables implies 951 W/m2, not the 852 W/m2 in the same tables",
    ),
    Typical(
        ("sun at the ground, disc at noon", "slunce u země, kotouč v poledne",
         "солнце у земли, диск в полдень"),
        "1.6e9", "cd/m2", SMITH, also="sunlight glare oslnění ослепление",
    ),
    Typical(
        ("sun at the ground, disc at the horizon", "slunce u země, kotouč u obzoru",
         "солнце у земли, диск у горизонта"),
        "6e6", "cd/m2", SMITH, also="sunset sunrise západ východ закат восход",
    ),
    Typical(DISC, "6.794e-5", "sr", "radius 695700 km (IAU 2015) from 1 au"),
    Typical(
        ("UV index 1, weighted for sunburn", "UV index 1, vážený pro zarudnutí kůže",
         "УФ-индекс 1, взвешенный по эритеме"),
        "25", "mW/m2", UV, also=ULTRAVIOLET,
    ),
    Typical(
        ("UV index 11, weighted for sunburn", "UV index 11, vážený pro zarudnutí kůže",
         "УФ-индекс 11, взвешенный по эритеме"),
        "275", "mW/m2", UV, also=ULTRAVIOLET,
    ),
    # the sky by day
    Typical(
        ("open shade under a clear sky", "stín pod jasnou oblohou", "тень под ясным небом"),
        "10.8", "klx", NATURE.format("1,000"), also="blue modrá синее",
    ),
    Typical(
        ("overcast day", "zatažený den", "пасмурный день"), "10000", "lx",
        NAVY.format("sun 60 deg high, dark stratus"),
        "the 300 cd/m2 of lecture tables is the sky of a darker day, of 733 lx", CLOUDED,
    ),
    Typical(
        ("overcast day, noon", "zatažený den, poledne", "пасмурный день, полдень"),
        "10 to 34", "klx", NAVY.format("sun 60 deg high, dark stratus to average clouds"),
        also=CLOUDED,
    ),
    Typical(
        ("overcast sky that gives 10 klx, its zenith", "zatažená obloha, která dává 10 klx, zenit",
         "пасмурное небо, дающее 10 клк, зенит"),
        "4093", "cd/m2", OVERCAST.format("E = 7 pi L/9"), also=CLOUDED,
    ),
    Typical(
        ("overcast sky that gives 10 klx, average",
         "zatažená obloha, která dává 10 klx, průměr", "пасмурное небо, дающее 10 клк, среднее"),
        "2730", "cd/m2", OVERCAST.format("2/3 of the zenith"), also=CLOUDED,
    ),
    Typical(
        ("overcast sky, dark", "zatažená obloha, tmavá", "пасмурное небо, тёмное"),
        "40", "cd/m2", SMITH,
        "the 300 cd/m2 of lecture tables gives 733 lx, not their 10 klx of an overcast day",
        CLOUDED,
    ),
    Typical(
        ("dark overcast day", "tmavý zatažený den", "тёмный пасмурный день"),
        "108 to 1080", "lx", NATURE.format("10 to 100"), also=CLOUDED,
    ),
    Typical(
        ("sunlit snow", "osluněný sníh", "снег на солнце"), "29000", "cd/m2",
        f"{NATURE.format('10,000')}, reflectance 0.85: L = rho E/pi",
        "30000 cd/m2 in lecture tables, for a sunlit cloud", f"{SUNLIGHT} cloud mrak облако",
    ),
    Typical(
        ("clear sky", "jasná obloha", "ясное небо"),
        "8000", "cd/m2", SMITH, "3000 cd/m2 in lecture tables", "blue modrá синее голубое",
    ),
    # dusk and night
    Typical(
        ("sunset or sunrise, clear", "západ nebo východ slunce, jasno",
         "закат или восход солнца, ясно"),
        "410 to 585", "lx", METEOROLOGY.format("civil"), also=DUSK,
    ),
    Typical(
        ("sunset or sunrise, overcast", "západ nebo východ slunce, zataženo",
         "закат или восход солнца, пасмурно"),
        "44", "lx", NAVY.format("sun 0.83 deg below the horizon, dark stratus"),
        also=f"{DUSK} {CLOUDED}",
    ),
    Typical(
        ("civil twilight, its end", "občanský soumrak, konec", "гражданские сумерки, конец"),
        "2 to 3.5", "lx", METEOROLOGY.format("civil"), also=DUSK,
    ),
    Typical(
        ("nautical twilight, its end", "námořní soumrak, konec", "навигационные сумерки, конец"),
        "0.008", "lx", METEOROLOGY.format("astronomical"), also=f"nautický {DUSK}",
    ),
    Typical(
        ("full moon", "měsíc v úplňku", "полная луна"), "0.1 to 0.3", "lx",
        NAVY.format("moon 30 to 90 deg high, 5 deg from full"),
        "the 0.02 lx of lecture notes is ten times too low",
        "moonlight night měsíční svit noc úplněk лунный свет ночь полнолуние",
    ),
    Typical(
        ("quarter moon", "měsíc ve čtvrti", "луна в четверти"), "0.01 to 0.03", "lx",
        NAVY.format("moon 30 to 90 deg high"),
        also="half moonlight night měsíční svit noc лунный свет ночь",
    ),
    Typical(
        ("starlight, clear night without moon", "svit hvězd, jasná noc bez měsíce",
         "свет звёзд, ясная ночь без луны"),
        "0.0005 to 0.001", "lx", f"{NAVY.format('0.0005 lx')}; {NATURE.format('0.0001')}",
        also="stars hvězdy звёзды",
    ),
    Typical(
        ("overcast night without moon", "zatažená noc bez měsíce", "пасмурная ночь без луны"),
        "0.0001", "lx", NATURE.format("0.00001"), also=CLOUDED,
    ),
    Typical(
        MOON, "2500 to 5000", "cd/m2", f"{SMITH}; p E/pi with NASA's albedo p = 0.12 in 133 klx",
        "the 0.03 cd/m2 of lecture notes is a white wall in moonlight",
    ),
    Typical(MOON, "6.418e-5", "sr", "NASA Moon Fact Sheet: radius 1737.4 km, 384400 km away"),
    Typical(
        ("night sky", "noční obloha", "ночное небо"), "0.00017", "cd/m2",
        "Falchi 2016, Science Advances 2, e1600377",
        also="dark tmavá тёмное",
    ),
    # rooms
    Typical(
        ("office desk, reading and writing", "kancelářský stůl, čtení a psaní",
         "стол в офисе, чтение и письмо"),
        "500", "lx", WORK_PLACES, also=f"kancelář кабинет work book práce kniha работа {WORK}",
    ),
    Typical(
        ("white paper on an office desk", "bílý papír na kancelářském stole",
         "белая бумага на столе в офисе"),
        "127", "cd/m2", "500 lx and a reflectance of 0.8: L = rho E/pi", also=WORK,
    ),
    Typical(
        ("classroom", "učebna", "учебный класс"), "300", "lx", WORK_PLACES,
        "500 lx on the board", f"school škola třída школа {WORK}",
    ),
    Typical(
        ("canteen, lounge", "jídelna, společenská místnost", "столовая, комната отдыха"),
        "200", "lx", ROOMS, also=WORK,
    ),
    Typical(
        ("corridor", "chodba", "коридор"), "100", "lx", ROOMS, also=f"hallway schodiště {WORK}"
    ),
    Typical(
        ("least light to work by, building site", "nejmenší světlo k práci, stavba",
         "наименьший свет для работы, стройка"),
        "54", "lx", "OSHA 29 CFR 1926.56: 5 fc", "100 lx in lecture tables", also=WORK,
    ),
    # streets
    Typical(
        ("main road, classes M6 to M1", "hlavní silnice, třídy M6 až M1",
         "главная дорога, классы M6–M1"),
        "0.3 to 2", "cd/m2", ROADS, also=STREET,
    ),
    Typical(
        ("residential street, classes P6 to P1", "obytná ulice, třídy P6 až P1",
         "жилая улица, классы P6–P1"),
        "2 to 15", "lx", ROADS, also=STREET,
    ),
    Typical(
        ("floodlit building", "osvětlená budova", "подсвеченное здание"), "2", "cd/m2",
        KODAK.format("f/2, 1/15 s"),
        also="night noc ночь",
    ),
    # exposure values
    Typical(
        ("sunlit snow or sand, ISO 100", "osluněný sníh nebo písek, ISO 100",
         "снег или песок на солнце, ISO 100"),
        "16", "EV", KODAK.format("f/22, 1/500 s"), also=f"{CAMERA} {SUNLIGHT}",
    ),
    Typical(
        ("sunlit scene, ISO 100", "osluněná scéna, ISO 100", "сцена на солнце, ISO 100"),
        "15", "EV", KODAK.format("f/16, 1/500 s"), also=f"{CAMERA} {SUNLIGHT}",
    ),
    Typical(
        ("scene under heavy clouds, ISO 100", "scéna pod hustými mraky, ISO 100",
         "сцена под густыми облаками, ISO 100"),
        "12", "EV", KODAK.format("f/5.6, 1/500 s"), also=f"{CAMERA} overcast {CLOUDED}",
    ),
    Typical(
        ("brightly lit street at night, ISO 100", "jasně osvětlená ulice v noci, ISO 100",
         "ярко освещённая улица ночью, ISO 100"),
        "7", "EV", KODAK.format("f/2.8, 1/60 s"), also=f"{CAMERA} {STREET}",
    ),
    Typical(
        ("office, ISO 100", "kancelář, ISO 100", "офис, ISO 100"), "8", "EV",
        KODAK.format("f/4, 1/60 s"),
        also=f"{CAMERA} {WORK}",
    ),
    Typical(
        ("home at night, ISO 100", "byt večer, ISO 100", "дом вечером, ISO 100"),
        "5 to 6", "EV", KODAK.format("f/2 to f/2.8, 1/30 s"), also=f"{CAMERA} {HOME}",
    ),
    Typical(
        ("scene under a full moon, ISO 100", "scéna za úplňku, ISO 100",
         "сцена в полнолуние, ISO 100"),
        "-4.6 to -3.1", "EV", "ISO 2720:1974, C = 250 lx s: 0.1 to 0.3 lx",
        also=f"{CAMERA} moonlight měsíc луна",
    ),
    # lamps
    Typical(("candle", "svíčka", "свеча"), "1", "cd", f"a flame of 1 cm2: {SMITH}", also=CANDLE),
    Typical(("candle", "svíčka", "свеча"), "12.57", "lm", "1 cd into 4 pi sr", also=CANDLE),
    Typical(
        ("candle, 1 m away", "svíčka, 1 m daleko", "свеча на расстоянии 1 м"),
        "1", "lx", "1 cd/(1 m)^2", also=CANDLE,
    ),
    Typical(
        ("flame of a candle", "plamen svíčky", "пламя свечи"), "10000", "cd/m2", SMITH, also=CANDLE
    ),
    Typical(
        ("incandescent bulb, 40 W", "žárovka, 40 W", "лампа накаливания, 40 Вт"),
        "450", "lm", BULBS, also=BULB,
    ),
    Typical(
        ("incandescent bulb, 60 W", "žárovka, 60 W", "лампа накаливания, 60 Вт"),
        "800", "lm", BULBS, also=BULB,
    ),
    Typical(
        ("incandescent bulb, 60 W, 1 m away", "žárovka, 60 W, 1 m daleko",
         "лампа накаливания, 60 Вт, на расстоянии 1 м"),
        "63.7", "lx", "800 lm into 4 pi sr", also=BULB,
    ),
    Typical(
        ("incandescent bulb, 100 W", "žárovka, 100 W", "лампа накаливания, 100 Вт"),
        "1600", "lm", BULBS, also=BULB,
    ),
    Typical(
        ("incandescent bulb", "žárovka", "лампа накаливания"), "11 to 16", "lm/W",
        f"{BULBS}: 40 W to 100 W",
        also=BULB,
    ),
    Typical(
        ("incandescent bulb, opal", "žárovka, opálová",
         "лампа накаливания, опаловая"),
        "22500", "cd/m2", "800 lm from a sphere of 60 mm: L = Phi/(pi D)^2", also=BULB,
    ),
    Typical(
        ("filament of a clear incandescent bulb", "vlákno čiré žárovky",
         "нить прозрачной лампы накаливания"),
        "5e6", "cd/m2", SMITH, also=BULB,
    ),
    Typical(
        ("LED bulb replacing 60 W", "LED žárovka místo 60 W", "светодиодная лампа вместо 60 Вт"),
        "800", "lm", BULBS, also=BULB,
    ),
    Typical(
        ("LED bulb", "LED žárovka", "светодиодная лампа"), "60 to 90", "lm/W", LAMPS, also=BULB
    ),
    Typical(
        ("fluorescent tube", "zářivková trubice", "люминесцентная трубка"), "6000", "cd/m2", SMITH,
        also=TUBE,
    ),
    Typical(
        ("headlight, low beam, on the road, at least",
         "světlomet, potkávací světlo, na silnici, nejméně",
         "фара, ближний свет, на дороге, не менее"),
        "10100", "cd", BEAM.format("class B, 50 R and 75 R"), also=HEADLIGHT,
    ),
    Typical(
        ("headlight, low beam, on the road, 25 m away, at least",
         "světlomet, potkávací světlo, na silnici, 25 m daleko, nejméně",
         "фара, ближний свет, на дороге, на расстоянии 25 м, не менее"),
        "16.2", "lx", "10100 cd: E = I/d^2", also=HEADLIGHT,
    ),
    Typical(
        ("headlight, low beam, above its cut-off, 25 m away, at most",
         "světlomet, potkávací světlo, nad rozhraním, 25 m daleko, nejvýše",
         "фара, ближний свет, над границей, на расстоянии 25 м, не более"),
        "1", "lx", BEAM.format("zone III, 625 cd"), also=f"glare oslnění ослепление {HEADLIGHT}",
    ),
    Typical(
        ("torch, where its beam ends", "svítilna, kde končí dosvit", "фонарик, где кончается луч"),
        "0.25", "lx", "ANSI/NEMA FL 1-2009, beam distance: Ledlenser", also=TORCH,
    ),
    Typical(
        ("laser pointer, class 2, at most", "laserové ukazovátko, třída 2, nejvýše",
         "лазерная указка, класс 2, не более"),
        "1", "mW", LASERS.format("2"),
    ),
    Typical(
        ("laser pointer, class 3R, at most", "laserové ukazovátko, třída 3R, nejvýše",
         "лазерная указка, класс 3R, не более"),
        "5", "mW", LASERS.format("3R"),
    ),
    Typical(
        ("He-Ne laser, 632.8 nm", "laser He-Ne, 632,8 nm", "лазер He-Ne, 632,8 нм"),
        "5", "mW", f"{LASERS.format('3R')}, at most",
    ),
    Typical(
        ("He-Ne laser, 632.8 nm, of 5 mW", "laser He-Ne, 632,8 nm, 5 mW",
         "лазер He-Ne, 632,8 нм, 5 мВт"),
        "0.81", "lm", "Km V(λ), CIE 018:2019",
    ),
    # screens
    Typical(
        ("cinema screen, white", "filmové plátno, bílá", "киноэкран, белый"),
        "48", "cd/m2", "ISO 26431-1:2008", "14 fL", f"film projector kino projektor кино {SCREEN}",
    ),
    Typical(
        ("monitor, sRGB white", "monitor, bílá sRGB", "монитор, белый sRGB"), "80", "cd/m2",
        "IEC 61966-2-1:1999, reference display",
        also=f"computer screen počítač компьютер {SCREEN}",
    ),
    Typical(
        ("HDR display, highlights, at least", "displej HDR, světla, nejméně",
         "дисплей HDR, блики, не менее"),
        "1000", "cd/m2", "ITU-R BT.2100-0 (2016), reference viewing environment",
        also=f"television TV televize {SCREEN}",
    ),
    # plants
    Typical(
        ("lettuce and herbs, a day", "salát a bylinky, za den", "салат и зелень, за день"),
        "12", "mol/m2/day", "Plants 2024, 13, 652", also=f"DLI {PLANT}",
    ),
    Typical(
        ("lettuce and herbs, 16 h a day", "salát a bylinky, 16 h denně",
         "салат и зелень, 16 ч в день"),
        "208", "umol/m2/s", DAYS_16.format(12), also=PLANT,
    ),
    Typical(
        ("tomatoes, a day", "rajčata, za den", "томаты, за день"), "20 to 25", "mol/m2/day",
        "University of Florida, DLI of vegetables", also=f"DLI помидоры fruit {PLANT}",
    ),
    Typical(
        ("tomatoes, 16 h a day", "rajčata, 16 h denně", "томаты, 16 ч в день"),
        "347 to 434", "umol/m2/s", DAYS_16.format("20 to 25"), also=f"помидоры fruit {PLANT}",
    ),
    # the eye
    Typical(
        ("vision, its threshold", "vidění, práh", "зрение, порог"), "5e-7", "cd/m2", SMITH, also=EYE
    ),
    Typical(
        ("vision at dusk, mesopic", "vidění za šera, mezopické", "сумеречное зрение"),
        "0.005 to 5", "cd/m2", "CIE 191:2010", also=EYE,
    ),
)  # fmt: skip
