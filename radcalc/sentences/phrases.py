"""The phrases of sentences: patterns of words and amounts, and the symbols that they fill.

A pattern is a sequence of words, of which `a|b` are alternatives, and of amounts in braces.  The
dimension of an amount decides whether a phrase fits.  The manual's table is made of `PHRASES`.
"""

from radcalc.quantities.search import comparable
from radcalc.tuples import NamedTuple
from radcalc.units.dimensions import (
    ANGLE,
    AREA,
    ENERGY,
    FREQUENCY,
    LENGTH,
    PHOTON_ENERGY,
    POWER,
    SOLID_ANGLE,
    TEMPERATURE,
    TIME,
    WAVENUMBER,
)
from radcalc.units.unit import NUMBER

# Amounts of a pattern, and their dimensions; a wavelength may also be a length.  A size may be in
# a unit of wavelengths.
AMOUNTS = {
    "length": (LENGTH,),
    "size": (LENGTH,),
    "angle": (ANGLE,),
    "area": (AREA,),
    "time": (TIME,),
    "number": (NUMBER,),
    "power": (POWER,),
    "temperature": (TEMPERATURE,),
    "solid-angle": (SOLID_ANGLE,),
    "wavelength": (LENGTH, FREQUENCY, WAVENUMBER, ENERGY, PHOTON_ENERGY),
}
# Places that are not symbols; an unknown phrase is refused.
SHAPE, FILTER, TARGET, UNKNOWN = "shape", "filter", "target", "unknown"


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
        ("{length} up|high", "height"),
        ("{length} aside|sideways|off-axis|horizontally", "offset"),
        ("{length} to the side", "offset"),
        ("at|from {length} away|distance", "distance"),
        ("{length} below|under|above|beneath|down|directly-below", "distance or height"),
        ("{length} away below|above", "distance or height"),
        ("throw at? {length}", "distance"),
        ("at? {length} throw", "distance"),
        ("hung|mounted|mounting at? {length}", "distance or height"),
        ("at|under {angle}", "incidence"),
        ("at|under {angle} incidence", "incidence"),
        ("at|under an? angle of {angle}", "incidence"),
        ("angle {angle}", "incidence or half-angle or apex-angle"),
        ("incidence angle {angle}", "incidence"),
        ("angle of incidence {angle}", "incidence"),
        ("{angle} incidence|from-normal", "incidence"),
        ("{angle} off|from the? normal|axis|vertical", "incidence"),
        (
            "tilted|inclined|slanted by? {angle} from|off|away? the|from? normal|vertical?",
            "incidence",
        ),
        ("pod úhlem {angle}", "incidence"),
        ("под углом {angle}", "incidence"),
    ),
    *_group(
        "directions",
        ("isotropic|isotropically|omnidirectional|izotropní|изотропный", "isotropic", ""),
        ("in|into all directions uniformly?", "isotropic", ""),
        ("over|into {solid-angle}", "solid-angle"),
        ("into|over a? hemisphere|half-sphere", "hemisphere", ""),
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
        ("{angle} cone", "apex-angle or half-angle"),
        ("{angle} across", "apex-angle"),
        ("angular diameter|size of|is? {angle}", "apex-angle"),
        ("na {number}", "na"),
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
        ("{length} diagonal|screen", "diagonal"),
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
        ("od {number} filter|goggles?", FILTER, "{} OD"),
        ("through? od {number} filter|goggles?", FILTER, "{} OD"),
        ("through? {number} od filter|goggles?", FILTER, "{} OD"),
        ("reflectance|reflectivity|albedo of? {number}", "reflectance"),
        ("{number} reflectance|reflective|reflecting", "reflectance"),
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
        ("{time} photoperiod|exposure|pulse|day", "time"),
    ),
    *_group(
        "camera",
        ("f/ {number}", "f-number"),
        ("iso {number}", "iso"),
        ("{number} iso", "iso"),
        ("nd {number} filter", "nd"),
        ("ev {number}", "ev100 or ev"),
        ("ev100 {number}", "ev100"),
        ("shutter {time}", "time"),
        ("{number} stop|stops nd|filter?", "stops"),
        ("gn {number}", "guide-number"),
        ("gn {length}", "guide-number"),
        ("k= {number}", "k"),
        ("c= {number}", "c"),
    ),
    *_group(
        "light",
        ("at|of|with|λ {wavelength}", "wavelength"),
        ("{wavelength} light|laser|led|line|photon", "wavelength"),
        ("{temperature} blackbody|planckian", "spectrum", "blackbody:{}"),
        ("{temperature} black body", "spectrum", "blackbody:{}"),
        ("blackbody|planckian|wien|planck at? {temperature}", "spectrum", "blackbody:{}"),
        ("black body at? {temperature}", "spectrum", "blackbody:{}"),
        ("{temperature} daylight", "spectrum", "daylight:{}"),
        ("{temperature} halogen|tungsten|incandescent|filament", "spectrum", "blackbody:{}"),
        ("gaussian beam|profile?", "profile", "gaussian"),
        ("top hat|top-hat beam|profile?", "profile", "uniform"),
        ("flat top|flat-top beam|profile|spot?", "profile", "uniform"),
        ("{power} led|lamp|bulb|light|luminaire|fixture", "flux or input-power"),
        ("solar|pv|photovoltaic panel|panels|module|modules|cell|cells", UNKNOWN, ""),
    ),
    *_group(
        "question",
        ("how far away?", TARGET, "distance"),
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
        ("stefan boltzmann|boltzmann's", TARGET, "radiant-exitance"),
    ),
)

# Readings that count only in a sentence with another symbol, unless that has the value here.
BESIDE = {"height": ("incidence", "0deg"), "ev": ("iso", "100")}

# Words that add nothing to a phrase.
IGNORED = """
    a about an and are at be by calculate can convert corresponds do does equals for from get
    give given gives have how how-many how-much i if in into is it its me my need needed needs
    of on onto over please pls required tell that that's the there this to under using value
    what when which will with would you absorbed allows arrive arrives back below beneath
    collect collects directly directly-underneath down draws emission emit emits equally exactly
    focused focussed gets gets-through gives-off hang hangs has hit hits hitting illuminates
    inside just key landing lands leaves left lights-up lit look looks make makes measured move
    moved number-of only outer outside passes-through peaking peaks produces puts puts-out
    radiated radiates rate rated reach reaches reaching read reads receive receives see seen
    sees shift shine shines shining sits stands still straight subtend subtended subtends takes
    throw turned underneath unit up wants wien above across aimed aiming brightness-of covers
    falling falls front longest lose per-lamp put showing wide-open then reflect reflects
    reflecting square bare cover fills held face-on head-on side alone

    actor air aisle area-light array backdrop backlight bandgap band-gap bar basil bathroom beam
    bedroom bench bulb bulbs camera canopy car ceiling cell center centre classroom collimated
    core corridor crop crops curtain cutoff cut-off dancer desk desks detector dimmer diode
    display dome downlight downlights driver eye face fibre fiber fill film fittings fixture
    flash flashlight flood floodlight floor followspot fresnel garage gallery gel glowing
    goggles greenhouse ground hallway headlamp headlight house image intense key-light kitchen
    lamp lamps laptop laser leaf led leds lens lettuce library light lights line linewidth
    luminaire luminaires meter metre model monitor monochromator moon moving-head museum object
    objective office optics page painting panel panels paper par16 par20 par30 par36 par38 par46
    par56 par64 par-can parcan parking-lot performer person phone photodiode picture plant
    plants point point-light pointer pole pool poster profile projection projector projectors
    pulse pulses pyranometer rack radiation radiometer ray reader road roof room same sample
    scene screen seedlings semiconductor sensor sheet shelf shop silicon singer single sky slide
    small smartphone softbox solar-disc solar-disk source source-four speaker spectrometer
    spectroradiometer spot spotlight stage star street strip studio subject sun-disc sun-disk
    surface table tablet tape target tent theater theatre tomato tomatoes torch tray truss
    tunnel tv umbrella video wall warehouse wash window work-plane workplane

    je jak jaká jaký jaké kolik má při se s o ze pro lampa lampy papír svítidlo svítí svit zdroj
    žárovka žárovky stůl plátno bodový

    если и с со при какая какова какой какое какую сколько равна чему лампа лампы лазер лазера
    источник точечный экран стол бумага
"""  # questions, articles, prepositions; sources and surfaces; Czech; Russian
# Words that change an amount, or its meaning: without one, a sentence means something else.
CHANGES = """
    direct diffuse global reflected transmitted half double twice two three four five many much
    per each every not without than less more through squared times minus plus pi electrical
    melanopic scotopic solar violet blue cyan green yellow orange red infrared ultraviolet uv
"""
MEANINGFUL = frozenset(CHANGES.split())
# Colours and lasers, which add nothing where a wavelength is given.
OF_LINES = "violet blue green yellow orange red infrared HeNe Nd:YAG"
COLOURS = frozenset(comparable(word) for word in OF_LINES.split())
FILLERS = frozenset(comparable(word.replace("-", " ")) for word in IGNORED.split())
# Words before a target: `to fc`, `in lux`, `as ppfd`.
MARKS = frozenset(["to", "in", "into", "as", "->", "→", "=", "into", "na", "v", "do", "в"])
# Words before the name of a spectrum of one letter: `with A`.
LONE = frozenset(["with", "using", "under", "illuminant", "spectrum"])
