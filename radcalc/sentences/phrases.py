"""The phrases of sentences: patterns of words and amounts, and the symbols that they fill.

A pattern is a sequence of words, of which `a|b` are alternatives, and of amounts in braces.  The
dimension of an amount decides whether a phrase fits.  The manual's table is made of `PHRASES`.
"""

from radcalc.quantities.names import data_rows
from radcalc.quantities.search import comparable
from radcalc.tuples import NamedTuple
from radcalc.units import NUMBER, dimensions

# Amounts of a pattern, and their dimensions; a wavelength may also be a length.  A size may be in
# a unit of wavelengths.
AMOUNTS = {
    "length": (dimensions.LENGTH,),
    "size": (dimensions.LENGTH,),
    "angle": (dimensions.ANGLE,),
    "area": (dimensions.AREA,),
    "time": (dimensions.TIME,),
    "number": (NUMBER,),  # of iso 100 lx, whose unit is asked for
    "ratio": (NUMBER,),  # with no unit after it
    "percent": (NUMBER,),
    "power": (dimensions.POWER,),
    "temperature": (dimensions.TEMPERATURE,),
    "solid-angle": (dimensions.SOLID_ANGLE,),
    "wavelength": (
        dimensions.LENGTH,
        dimensions.FREQUENCY,
        dimensions.WAVENUMBER,
        dimensions.ENERGY,
        dimensions.PHOTON_ENERGY,
    ),
}
# Places that are not symbols; an unknown phrase is refused.
SHAPE, FILTER, TARGET, UNKNOWN = "shape", "filter", "target", "unknown"
COMMAND = "command"  # of a thing: the light on a sensor
PERIOD, PER_DAY = "by", "day"  # of the answers to a log: each day, or each hour

FROM_SURFACE = "90deg-{}"  # the incidence is measured from the normal


class Phrase(NamedTuple):
    """A phrase: its pattern, and the symbol that it fills, or several for several readings.

    `form` is the text of the value, with the text of the amount in place of {}; "" is a flag.
    """

    pattern: str
    fills: tuple[str, ...] = ()
    form: str = "{}"
    group: str = ""


def _group(title: str, *rows: tuple[str, ...]) -> tuple[Phrase, ...]:
    """Return phrases from rows of a pattern, symbols joined by `or`, and possibly a form."""
    return tuple(
        [Phrase(row[0], tuple(row[1].split(" or ")), (*row, "{}")[2], title) for row in rows]
    )


PHRASES = (
    *_group(
        "place",
        ("at|from|z|na|ve|v|od|на|в|от|aus {length}", "distance"),
        ("at a|the distance of {length}", "distance"),
        ("ve vzdálenosti {length}", "distance"),
        ("ve výšce {length}", "distance or height"),
        ("на высоте {length}", "distance or height"),
        ("на расстоянии {length}", "distance"),
        ("{length} away|distance|distant", "distance"),
        ("{length} away from", "distance"),
        ("at|from {length} away|distance", "distance"),
        ("{length} below|under|above|beneath|down|directly-below", "distance or height"),
        ("{length} away below|above", "distance or height"),
        ("at|from? {length} height", "height"),
        ("over|into|onto|across a? {size}", UNKNOWN, ""),
        ("throw at? {length}", "distance"),
        ("at? {length} throw", "distance"),
        ("hung|mounted|mounting at? {length} above?", "distance or height"),
        ("at|under {angle}", "incidence"),
        ("at|under {angle} incidence", "incidence"),
        ("at|under an? angle of {angle}", "incidence"),
        ("angle {angle}", "incidence or half-angle or apex-angle"),
        ("incidence angle {angle}", "incidence"),
        ("tilted|inclined by? {angle}", "incidence"),
        ("angle of incidence {angle}", "incidence"),
        ("{angle} incidence|from-normal", "incidence"),
        ("{angle} off|from the? normal", "incidence"),
        (
            "at? {angle} from|to|off|above the? surface|wall|floor|ground|plane|desk|table",
            "incidence",
            "90deg-{}",
        ),
        ("at? {angle} above the? horizon|horizontal", "incidence", FROM_SURFACE),
        ("pod úhlem {angle}", "incidence"),
        ("под углом {angle}", "incidence"),
    ),
    *_group(
        "directions",
        ("isotropic|isotropically|omnidirectional|izotropní|изотропный", "isotropic", ""),
        ("in|into all directions uniformly?", "isotropic", ""),
        ("over|into {solid-angle}", "solid-angle"),
        ("in|into|over|to? a? hemisphere|half-sphere", "hemisphere", ""),
        ("lambertian source|emitter|chip", "exponent", "1"),
        ("{angle} lobe|fwhm", "beam-angle"),
        ("beam angle fwhm {angle}", "beam-angle"),
        ("{angle} full cone|angle", "apex-angle"),
        ("full angle|cone {angle}", "apex-angle"),
        ("{angle} half cone|angle", "half-angle"),
        ("cone half angle {angle}", "half-angle"),
        ("cone full|apex angle {angle}", "apex-angle"),
        ("half angle|cone {angle}", "half-angle"),
        ("{angle} beam", "apex-angle or beam-angle"),
        ("beam {angle}", "apex-angle or beam-angle"),
        ("beam angle {angle}", "apex-angle or beam-angle"),
        ("{angle} beam|viewing angle", "apex-angle or beam-angle"),
        ("viewing angle {angle}", "apex-angle or beam-angle"),
        ("cone {angle}", "apex-angle or half-angle"),
        ("cone {angle} half angle", "half-angle"),
        ("cone {angle} full|apex angle", "apex-angle"),
        ("full|apex angle of|is {angle}", "apex-angle"),
        ("{angle} cone", "apex-angle or half-angle"),
        ("{angle} across", "apex-angle"),
        ("angular diameter|size of|is? {angle}", "apex-angle"),
        ("na {number}", "na"),
        ("{ratio} na", "na"),
        (
            "at|under|with a? {angle} beam|cone|lobe|spot|flood|across|field|full|half|viewing",
            UNKNOWN,
            "",
        ),
        ("sphere|ball|globe|koule|шар", SHAPE, "sphere"),
        ("disc|disk|kotouč|диск", SHAPE, "disc"),
        ("rectangle|rectangular", SHAPE, "rectangle"),
        ("hemispherical dome", SHAPE, "hemisphere"),
    ),
    *_group(
        "surface",
        ("over|on|onto|across|of|for|per {area}", "area"),
        ("mean|average over|on|across {area}", "area"),
        ("on|onto a|an? {area}", "area"),
        ("{area} screen|area|surface|panel|room|office|table", "area"),
        ("{size} wide|width", "width"),
        ("{size} tall|long|length", "length"),
        ("{size} wide pool|circle|spot|disc|beam", "diameter"),
        ("beam|pool|spot|circle|disc|disk|hole {size} wide|across", "diameter"),
        ("{length} diagonal|screen|tv|monitor|display|television", "diagonal"),
        ("{size} diameter|dia|beam|spot|disc|disk|circle", "diameter"),
        ("through|into|in a? {size} pinhole|aperture|iris", "receiver-diameter"),
        ("{size} beam|spot|diameter diameter|spot|beam", "diameter"),
        ("beam|spot diameter? {size}", "diameter"),
        ("diameter|dia {size}", "diameter"),
        ("{size} radius", "radius"),
        ("w0= {size}", "diameter", "2*{}"),
        ("into a? {length} pupil", "pupil or diameter"),
        ("{length} pupil", "pupil or diameter"),
        ("minus|less {number} stop|stops of? nd?", FILTER, "-{} stops"),
        ("plus {number} stop|stops", FILTER, "{} stops"),
        ("od {ratio} filter|goggles?", FILTER, "{} OD"),
        ("through? od {ratio} filter|goggles?", FILTER, "{} OD"),
        ("through|behind|after nd {ratio} filter?", FILTER, "{} OD"),
        ("through? {number} od filter|goggles?", FILTER, "{} OD"),
        ("reflectance|reflectivity|albedo of? {number}", "reflectance"),
        ("{number} reflectance|reflective|reflecting", "reflectance"),
        ("{percent}", "reflectance"),
        ("{number} gain", "gain"),
        ("{number} white|grey|gray surface|paper|wall|board|card", "reflectance"),
        ("on|onto white|grey|gray|black surface|paper|wall|board|card?", "reflectance", ""),
        ("white|grey|gray|black surface|paper|wall|board|card", "reflectance", ""),
        (
            "white|grey|gray|black diffuse|matte|matt|lambertian surface|wall|card",
            "reflectance",
            "",
        ),
        ("matte|matt|diffuse|lambertian surface|wall|paper|card", "reflectance", ""),
        ("matte|matt white surface|wall|paper|card", "reflectance", ""),
    ),
    *_group(
        "time",
        ("for|over|during|in|after {time}", "time"),
        ("{time} of light", "time"),
        ("for? {time} a|per|each|every day", "time"),
        ("{time} photoperiod|exposure|pulse|day", "time"),
        ("photoperiod|daylength of? {number}", "time", "{}h"),
        ("by|per|each|every day", PERIOD, PER_DAY),
        ("daily", PERIOD, PER_DAY),
        ("by|per|each|every hour", PERIOD, "hour"),
        ("hourly", PERIOD, "hour"),
    ),
    *_group(
        "camera",
        ("f/ {number}", "f-number"),
        ("on|at the? sensor|film|chip", COMMAND, "sensor"),
        ("iso {number}", "iso"),
        ("nd {ratio} filter", "nd"),
        ("ev {number}", "ev100 or ev"),
        ("ev100 {number}", "ev100"),
        ("shutter {time}", "time"),
        ("{number} stop|stops nd|filter?", "stops"),
        ("{number} stop|stops under|over|below|above|brighter|darker|up|down", UNKNOWN, ""),
        ("gn {number}", "guide-number"),
        ("gn {length}", "guide-number"),
        ("k= {number}", "k"),
        ("c= {number}", "c"),
    ),
    *_group(
        "light",
        ("at|of|with|λ {wavelength}", "wavelength"),
        ("{wavelength} light|laser|led|line|photon", "wavelength"),
        ("{wavelength} linewidth|bandwidth|fwhm", "bandwidth or fwhm"),
        ("{wavelength} line|band|spectral width", "bandwidth or fwhm"),
        ("linewidth|bandwidth|fwhm of|is? {wavelength}", "bandwidth or fwhm"),
        ("{temperature} blackbody|planckian", "spectrum", "blackbody:{}"),
        ("{temperature} black body", "spectrum", "blackbody:{}"),
        ("blackbody|planckian|wien|planck at? {temperature}", "spectrum", "blackbody:{}"),
        ("black body at? {temperature}", "spectrum", "blackbody:{}"),
        ("fluorescent t5|t8|t12? tube|tubes|lamp|light?", "spectrum", ""),
        ("t5|t8|t12 fluorescent|tube|tubes|lamp", "spectrum", ""),
        ("t5|t12", "spectrum", ""),
        ("{temperature} daylight", "spectrum", "daylight:{}"),
        ("{temperature} halogen|tungsten|incandescent|filament", "spectrum", "blackbody:{}"),
        ("gaussian beam|profile?", "profile", "gaussian"),
        ("top hat|top-hat beam|profile?", "profile", "uniform"),
        ("flat top|flat-top beam|profile|spot?", "profile", "uniform"),
        ("{power} led|lamp|bulb|light|luminaire|fixture", "flux or input-power"),
        ("led|lamp|bulb|luminaire|fixture panel|light? {power}", "flux or input-power"),
        ("solar|pv|photovoltaic panel|panels|module|modules|cell|cells", UNKNOWN, ""),
    ),
    *_group(
        "question",
        ("how far away?", TARGET, "distance"),
        (
            "how-many? lamps|luminaires|fixtures|panels|lights|downlights|fittings|bulbs",
            TARGET,
            "luminaires",
        ),
        ("nohd", TARGET, "hazard-distance"),
        ("how long", TARGET, "time"),
        ("how wide", TARGET, "width"),
        ("how wide|big is? the? pool|beam|spot|circle", TARGET, "beam-diameter"),
        ("pool|spot diameter|width|size", TARGET, "beam-diameter"),
        ("f-stop|fstop|f-number", TARGET, "f-number"),
        ("incident lux|light|illuminance", TARGET, "illuminance"),
        ("horizontal illuminance|lux", TARGET, "illuminance"),
        ("wien peak?", TARGET, "peak-wavelength"),
        ("exposure|irradiation time", TARGET, "time"),
        ("color|colour temperature", TARGET, "cct"),
        ("peak wavelength", TARGET, "peak-wavelength"),
        ("fraction|share of? light? in|over|between?", TARGET, "range-fraction"),
        ("stefan boltzmann|boltzmann's", TARGET, "radiant-exitance"),
    ),
)

# Readings that count only in a sentence with another symbol, unless that has the value here.
BESIDE = {"height": ("incidence", "0deg"), "ev": ("iso", "100")}

# Things whose words ask for more than a sentence without them has: the angle of a beam; whether
# watts of a lamp are electrical, unless they are of light; whether a meter is before a filter or
# behind it; whether an angle of the sun is its height.
BEAM, LAMP, LIGHT, METER, SUN, LASER = "beam", "lamp", "light", "meter", "sun", "laser"
# Things that are lit: a length next to one of these may be its size, not a distance.
OBJECT, SOURCE = "object", "source"
# Colours, which add nothing where a wavelength is given; air beside light, a shift beside mireds.
LINE, AIR, SHIFT = "line", "air", "shift"
WORDS = data_rows("words", "sentences")  # word, language, role, what it is of
OF_THINGS: dict[str, set[str]] = {}  # the words of each role and thing, as `comparable` writes them
for _word, _, _role, _things in WORDS:
    for _thing in (_role, *_things.split()):
        OF_THINGS.setdefault(_thing, set()).add(comparable(_word))
# Words that add nothing to a phrase, and those that change an amount or its meaning.
FILLERS, MEANINGFUL = OF_THINGS["nothing"], OF_THINGS["changes"]
MORE_NEEDED = {thing: OF_THINGS[thing] for thing in (BEAM, LAMP, LIGHT, METER, SUN, LASER)}
THINGS, NOUNS = OF_THINGS[OBJECT], OF_THINGS[OBJECT] | OF_THINGS[SOURCE]
# Words before a target: `to fc`, `in lux`, `as ppfd`.
MARKS = frozenset(["to", "in", "into", "as", "->", "→", "=", "into", "na", "v", "do", "в"])
# Words before the name of a spectrum of one letter: `with A`.
LONE = frozenset(["with", "using", "under", "illuminant", "spectrum"])
