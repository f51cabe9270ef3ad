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


LECTURES = "lecture tables"
IAU = "IAU 2015 resolution B3"
LUX = "Wikipedia, Orders of magnitude (illuminance)"
NITS = "Wikipedia, Orders of magnitude (luminance)"
OVERCAST = "CIE overcast sky: E = 7 pi L/9"
METEOROLOGY = "AMS Glossary of Meteorology"
PHOTOS = "ANSI PH2.7: Wikipedia, Exposure value"
ROOMS = "EN 12464-1"
ROADS = "EN 13201-2:2015"
CHEAT = "lumines-labs.com, Physical Light cheat sheet"
SMITH = "Smith, Modern Optical Engineering, fig. 12.8"
BULBS = "US Department of Energy, lumens of light bulbs"
EFFICACY = "disabled-world.com, Lumens to watts"
TORCHES = "goinggear.com, Lumens vs candela"
BEAMS = "Japan's vehicle inspection (fet-japan.co.jp): 15 kcd each, 225 kcd all"
LASERS = "IEC 60825-1"
APOGEE = "Apogee Instruments, full sunlight"
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
    Typical(SPACE, "133", "klx", "ASTM G173-03: radcalc spectrum AM0"),
    Typical(
        SPACE,
        "2.0e7",
        "W/m2/sr",
        "1361 W/m2 over the disc's 6.794e-5 sr",
        "the 2.3e7 of some texts is a black body of 6000 K, and does not fit 1367 W/m2 either",
    ),
    Typical(SPACE, "2.0e9", "cd/m2", "133 klx over the disc's 6.794e-5 sr"),
    Typical(
        ("sun at the ground, winter noon, direct, facing it", "slunce u země, zimní poledne, přímé",
         "солнце у земли, зимний полдень, прямое"),
        "852", "W/m2", LECTURES, also=SUNLIGHT,
    ),
    Typical(
        ("sun at the ground, winter noon, all light on a horizontal plane",
         "slunce u země, zimní poledne, všechno světlo na vodorovnou plochu",
         "солнце у земли, зимний полдень, весь свет на горизонтальную плоскость"),
        "686", "W/m2", LECTURES, also=SUNLIGHT,
    ),
    Typical(CLEAR, "1000", "W/m2", LECTURES, also=SUNLIGHT),
    Typical(CLEAR, "100 to 110", "klx", f"{LUX}: 110 klx", also=SUNLIGHT),
    Typical(
        ("sun at the ground, full, for plants", "plné slunce u země, pro rostliny",
         "полное солнце у земли, для растений"),
        "2000", "umol/m2/s", APOGEE, also=f"{SUNLIGHT} {PLANT}",
    ),
    Typical(
        ("sun at the ground, a summer day, for plants", "slunce u země, letní den, pro rostliny",
         "солнце у земли, летний день, для растений"),
        "50 to 60", "mol/m2/day", APOGEE, also=f"DLI {PLANT}",
    ),
    Typical(
        ("sun at the ground, winter noon, disc", "slunce u země, zimní poledne, kotouč",
         "солнце у земли, зимний полдень, диск"),
        "1.25e7", "W/m2/sr", "852 W/m2 over the disc's 6.794e-5 sr",
        "the 1.4e7 of lecture tables implies 951 W/m2, not the 852 W/m2 in the same tables",
    ),
    Typical(
        ("sun at the ground, disc at noon", "slunce u země, kotouč v poledne",
         "солнце у земли, диск в полдень"),
        "1.6e9", "cd/m2", NITS, also="sunlight glare oslnění ослепление",
    ),
    Typical(
        ("sun at the ground, disc at the horizon", "slunce u země, kotouč u obzoru",
         "солнце у земли, диск у горизонта"),
        "6e5", "cd/m2", NITS, also="sunset sunrise západ východ закат восход",
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
        ("shade under a clear sky, noon", "stín pod jasnou oblohou, poledne",
         "тень под ясным небом, полдень"),
        "20", "klx", LUX, also="blue modrá синее",
    ),
    Typical(
        ("overcast day", "zatažený den", "пасмурный день"), "10000", "lx", LECTURES,
        "the 300 cd/m2 of the same tables is the sky of a darker day, of 733 lx", CLOUDED,
    ),
    Typical(
        ("overcast day, noon", "zatažený den, poledne", "пасмурный день, полдень"),
        "10 to 25", "klx", LUX, also=CLOUDED,
    ),
    Typical(
        ("overcast sky that gives 10 klx, its zenith", "zatažená obloha, která dává 10 klx, zenit",
         "пасмурное небо, дающее 10 клк, зенит"),
        "4093", "cd/m2", OVERCAST, also=CLOUDED,
    ),
    Typical(
        ("overcast sky, average", "zatažená obloha, průměr", "пасмурное небо, среднее"),
        "2000", "cd/m2", NITS, also=CLOUDED,
    ),
    Typical(
        ("overcast sky, dark, its zenith", "zatažená obloha, tmavá, zenit",
         "пасмурное небо, тёмное, зенит"),
        "300", "cd/m2", LECTURES,
        "gives 733 lx, not the 10 klx of an overcast day in the same tables", CLOUDED,
    ),
    Typical(
        ("darkest storm clouds, noon, at most", "nejtmavší bouřkové mraky, poledne, nejvýše",
         "самые тёмные грозовые тучи, полдень, не более"),
        "200", "lx", LUX, also=CLOUDED,
    ),
    Typical(
        ("sunlit cloud", "osluněný mrak", "освещённое солнцем облако"), "30000", "cd/m2", LECTURES
    ),
    Typical(
        ("clear sky", "jasná obloha", "ясное небо"),
        "3000 to 7000", "cd/m2", f"{LECTURES}: 3000; {NITS}: 7000", also="blue modrá синее голубое",
    ),
    # dusk and night
    Typical(
        ("sunset or sunrise, clear", "západ nebo východ slunce, jasno",
         "закат или восход солнца, ясно"),
        "410 to 585", "lx", METEOROLOGY, also=DUSK,
    ),
    Typical(
        ("sunset or sunrise, overcast", "západ nebo východ slunce, zataženo",
         "закат или восход солнца, пасмурно"),
        "40", "lx", LUX, also=f"{DUSK} {CLOUDED}",
    ),
    Typical(
        ("civil twilight, its end", "občanský soumrak, konec", "гражданские сумерки, конец"),
        "2 to 3.5", "lx", METEOROLOGY, also=DUSK,
    ),
    Typical(
        ("nautical twilight, its end", "námořní soumrak, konec", "навигационные сумерки, конец"),
        "0.008", "lx", METEOROLOGY, also=f"nautický {DUSK}",
    ),
    Typical(
        ("full moon", "měsíc v úplňku", "полная луна"), "0.1 to 0.3", "lx", f"{LUX}: 0.25 lx",
        "the 0.02 lx of lecture notes is ten times too low",
        "moonlight night měsíční svit noc úplněk лунный свет ночь полнолуние",
    ),
    Typical(
        ("quarter moon", "měsíc ve čtvrti", "луна в четверти"), "0.01", "lx", LUX,
        also="half moonlight night měsíční svit noc лунный свет ночь",
    ),
    Typical(
        ("starlight, clear night without moon", "svit hvězd, jasná noc bez měsíce",
         "свет звёзд, ясная ночь без луны"),
        "0.0002 to 0.002", "lx", LUX, also="stars hvězdy звёзды",
    ),
    Typical(
        ("overcast night without moon", "zatažená noc bez měsíce", "пасмурная ночь без луны"),
        "0.0001", "lx", LUX, also=CLOUDED,
    ),
    Typical(
        MOON, "2500 to 5000", "cd/m2", f"{NITS}: 2500 cd/m2",
        "the 0.03 cd/m2 of lecture notes is a white wall in moonlight",
    ),
    Typical(MOON, "6.418e-5", "sr", "radius 1737.4 km from 384400 km"),
    Typical(
        ("night sky", "noční obloha", "ночное небо"), "0.0004 to 0.001", "cd/m2", NITS,
        also="dark tmavá тёмное",
    ),
    # rooms
    Typical(
        ("at a window by day", "u okna ve dne", "у окна днём"), "1000", "lx", LECTURES, also=WORK
    ),
    Typical(
        ("office desk, reading and writing", "kancelářský stůl, čtení a psaní",
         "стол в офисе, чтение и письмо"),
        "500", "lx", ROOMS, also=f"kancelář кабинет work book práce kniha работа {WORK}",
    ),
    Typical(
        ("white paper on an office desk", "bílý papír na kancelářském stole",
         "белая бумага на столе в офисе"),
        "127", "cd/m2", "500 lx and a reflectance of 0.8: L = rho E/pi", also=WORK,
    ),
    Typical(
        ("classroom", "učebna", "учебный класс"), "300", "lx", ROOMS,
        "500 lx on the board", f"school škola třída школа {WORK}",
    ),
    Typical(
        ("canteen, cloakroom, bath", "jídelna, šatna, koupelna", "столовая, гардероб, ванная"),
        "200", "lx", ROOMS, also=WORK,
    ),
    Typical(
        ("corridor", "chodba", "коридор"), "100", "lx", ROOMS, also=f"hallway schodiště {WORK}"
    ),
    Typical(
        ("least light to work by", "nejmenší světlo k práci", "наименьший свет для работы"),
        "100", "lx", LECTURES, also=WORK,
    ),
    Typical(("kitchen", "kuchyně", "кухня"), "300 to 750", "lx", CHEAT, also=HOME),
    Typical(("bedroom", "ložnice", "спальня"), "150 to 300", "lx", CHEAT, also=HOME),
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
        ("street lamp", "pouliční lampa", "уличный фонарь"), "1000 to 40000", "lm", CHEAT,
        also=STREET,
    ),
    Typical(
        ("floodlit building", "osvětlená budova", "подсвеченное здание"), "2", "cd/m2", NITS,
        also="night noc ночь",
    ),
    # exposure values
    Typical(
        ("sunlit snow or sand, ISO 100", "osluněný sníh nebo písek, ISO 100",
         "снег или песок на солнце, ISO 100"),
        "16", "EV", PHOTOS, also=f"{CAMERA} {SUNLIGHT}",
    ),
    Typical(
        ("sunlit scene, ISO 100", "osluněná scéna, ISO 100", "сцена на солнце, ISO 100"),
        "15", "EV", PHOTOS, also=f"{CAMERA} {SUNLIGHT}",
    ),
    Typical(
        ("scene under heavy clouds, ISO 100", "scéna pod hustými mraky, ISO 100",
         "сцена под густыми облаками, ISO 100"),
        "12", "EV", PHOTOS, also=f"{CAMERA} overcast {CLOUDED}",
    ),
    Typical(
        ("street and shop windows at night, ISO 100", "ulice a výlohy v noci, ISO 100",
         "улица и витрины ночью, ISO 100"),
        "7 to 8", "EV", PHOTOS, also=f"{CAMERA} {STREET}",
    ),
    Typical(
        ("office, ISO 100", "kancelář, ISO 100", "офис, ISO 100"), "7 to 8", "EV", PHOTOS,
        also=f"{CAMERA} {WORK}",
    ),
    Typical(
        ("home at night, ISO 100", "byt večer, ISO 100", "дом вечером, ISO 100"),
        "5 to 7", "EV", PHOTOS, also=f"{CAMERA} {HOME}",
    ),
    Typical(
        ("scene under a full moon, ISO 100", "scéna za úplňku, ISO 100",
         "сцена в полнолуние, ISO 100"),
        "-3 to -2", "EV", PHOTOS, also=f"{CAMERA} moonlight měsíc луна",
    ),
    # lamps
    Typical(("candle", "svíčka", "свеча"), "1", "cd", "Wikipedia, Candela", also=CANDLE),
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
        ("tungsten lamp, gas-filled, 100 W", "wolframová žárovka s plynem, 100 W",
         "вольфрамовая газонаполненная лампа, 100 Вт"),
        "82", "W", LECTURES, also=BULB,
    ),
    Typical(
        ("incandescent bulb", "žárovka", "лампа накаливания"), "12 to 18", "lm/W", EFFICACY,
        also=BULB,
    ),
    Typical(
        ("incandescent bulb, frosted", "žárovka, matná", "лампа накаливания, матовая"),
        "1.3e5", "cd/m2", NITS, also=BULB,
    ),
    Typical(
        ("filament of a clear incandescent bulb", "vlákno čiré žárovky",
         "нить прозрачной лампы накаливания"),
        "7e6", "cd/m2", NITS, also=BULB,
    ),
    Typical(
        ("LED bulb replacing 60 W", "LED žárovka místo 60 W", "светодиодная лампа вместо 60 Вт"),
        "800", "lm", BULBS, also=BULB,
    ),
    Typical(
        ("LED bulb", "LED žárovka", "светодиодная лампа"), "75 to 110", "lm/W", EFFICACY, also=BULB
    ),
    Typical(
        ("fluorescent lamp, 40 W", "zářivka, 40 W", "люминесцентная лампа, 40 Вт"),
        "23.2", "W", LECTURES, also=TUBE,
    ),
    Typical(
        ("fluorescent tube", "zářivková trubice", "люминесцентная трубка"), "12000", "cd/m2", NITS,
        also=TUBE,
    ),
    Typical(
        ("headlight bulb, H1 halogen", "halogenová žárovka světlometu, H1",
         "галогенная лампа фары, H1"),
        "1550", "lm", "UN R37: Wikipedia, List of automotive light bulb types", also=HEADLIGHT,
    ),
    Typical(
        ("headlight, high beam", "světlomet, dálkové světlo", "фара, дальний свет"),
        "15000 to 112500", "cd", BEAMS, also=HEADLIGHT,
    ),
    Typical(
        ("headlight, high beam, 25 m away", "světlomet, dálkové světlo, 25 m daleko",
         "фара, дальний свет, на расстоянии 25 м"),
        "24 to 180", "lx", "15 to 112.5 kcd: E = I/d^2", also=HEADLIGHT,
    ),
    Typical(
        ("headlight, low beam, above its cut-off, 25 m away, at most",
         "světlomet, potkávací světlo, nad rozhraním, 25 m daleko, nejvýše",
         "фара, ближний свет, над границей, на расстоянии 25 м, не более"),
        "1", "lx", "euromotor.org, low beam", also=f"glare oslnění ослепление {HEADLIGHT}",
    ),
    Typical(("torch", "svítilna", "фонарик"), "100 to 300", "lm", TORCHES, also=TORCH),
    Typical(
        ("torch of a phone", "svítilna telefonu", "фонарик телефона"), "20 to 50", "lm", TORCHES,
        also=TORCH,
    ),
    Typical(
        ("torch, where its beam ends", "svítilna, kde končí dosvit", "фонарик, где кончается луч"),
        "0.25", "lx", "ANSI FL1: ledlenser.com", also=TORCH,
    ),
    Typical(
        ("laser pointer, class 2, at most", "laserové ukazovátko, třída 2, nejvýše",
         "лазерная указка, класс 2, не более"),
        "1", "mW", LASERS,
    ),
    Typical(
        ("laser pointer, class 3R, at most", "laserové ukazovátko, třída 3R, nejvýše",
         "лазерная указка, класс 3R, не более"),
        "5", "mW", LASERS,
    ),
    Typical(
        ("He-Ne laser, 632.8 nm", "laser He-Ne, 632,8 nm", "лазер He-Ne, 632,8 нм"),
        "5", "mW", "a common rating",
    ),
    Typical(
        ("He-Ne laser, 632.8 nm, of 5 mW", "laser He-Ne, 632,8 nm, 5 mW",
         "лазер He-Ne, 632,8 нм, 5 мВт"),
        "0.81", "lm", "Km V(λ), CIE 018:2019",
    ),
    # screens
    Typical(
        ("cinema screen, white", "filmové plátno, bílá", "киноэкран, белый"),
        "48", "cd/m2", "ISO 26431-1", "14 fL", f"film projector kino projektor кино {SCREEN}",
    ),
    Typical(
        ("monitor, sRGB white", "monitor, bílá sRGB", "монитор, белый sRGB"), "80", "cd/m2", NITS,
        also=f"computer screen počítač компьютер {SCREEN}",
    ),
    Typical(
        ("monitor, LCD, at most", "monitor LCD, nejvýše", "монитор ЖК, не более"),
        "250", "cd/m2", NITS, also=f"computer screen počítač компьютер {SCREEN}",
    ),
    Typical(
        ("HDR display, highlights, at least", "displej HDR, světla, nejméně",
         "дисплей HDR, блики, не менее"),
        "1000", "cd/m2", "ITU-R BT.2100-0: ICC registry", also=f"television TV televize {SCREEN}",
    ),
    Typical(
        ("phone screen in the sun", "obrazovka telefonu na slunci", "экран телефона на солнце"),
        "400 to 1400", "cd/m2", "mi.com: 400 cd/m2; community.iqoo.com: 1400 cd/m2",
        also=f"smartphone mobil смартфон {SCREEN}",
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
        ("vision, its threshold", "vidění, práh", "зрение, порог"), "1e-6", "cd/m2", NITS, also=EYE
    ),
    Typical(
        ("vision at dusk, mesopic", "vidění za šera, mezopické", "сумеречное зрение"),
        "0.005 to 5", "cd/m2", "CIE 191:2010", also=EYE,
    ),
    Typical(
        ("vision, harm is possible", "vidění, možné poškození", "зрение, возможен вред"),
        "1e8", "cd/m2", NITS, also=f"glare retina sítnice сетчатка {EYE}",
    ),
)  # fmt: skip
