"""The vocabulary: one row for each symbol of an input, of a result or of a law.

Options, keywords, results, messages, completions and manual pages are generated from it.  A help
text mentions another symbol as {name}; the command line and the Python API each spell it in their
own way.
"""

import math
from functools import cache
from typing import Any

from radcalc.quantities import (
    EXITANCES,
    GEOMETRIES,
    KIND_NAMES,
    KINDS,
    LUMINOUS,
    OTHERS,
    PHOTON,
    PHOTON_NAMES,
    RADIANT,
    RATIOS,
    base_of,
    in_a_kind,
    in_words,
    kind_of_observer,
    light_dimension,
    of_kind,
    place_of,
    ratio,
    ratio_of,
    with_suffix,
)
from radcalc.tuples import NamedTuple
from radcalc.units import NUMBER, Dimension, Unit
from radcalc.units.compiled import WEIGHTS
from radcalc.units.dimensions import (
    ANGLE,
    AREA,
    COHERENT,
    CURRENT,
    ENERGY,
    ETENDUE,
    FREQUENCY,
    ILLUMINANCE,
    LENGTH,
    LUMINANCE,
    MASS,
    PHOTON_ENERGY,
    PHOTONS,
    POWER,
    RESPONSIVITY,
    SOLID_ANGLE,
    SPECIFIC_HEAT,
    TEMPERATURE,
    TIME,
    WAVENUMBER,
    times,
)

INFINITE = math.inf


class Limits(NamedTuple):
    """The allowed values [SI] of a symbol, and their description."""

    low: float = -INFINITE
    high: float = INFINITE
    said: str = ""
    without_low: bool = False
    without_high: bool = False


ANY = Limits()
POSITIVE = Limits(0.0, said="more than 0", without_low=True)
FROM_ZERO = Limits(0.0, said="0 or more")
PART = Limits(0.0, 1.0, "from 0 to 1, or from 0% to 100%")
BEAM = Limits(0.0, math.pi, "less than 180 deg", without_low=True, without_high=True)
FRACTION = PART._replace(without_low=True)
REFLECTED = Limits(0.0, 1.5, "more than 0, up to 1.5", without_low=True)  # with interreflection
LENS = Limits(0.5, said="0.5 or more, in air")  # 0.5 for a half angle with the sine 1
OFF_AXIS = Limits(0.0, math.pi / 2, "from 0 to less than 90 deg", without_high=True)
TURN = Limits(-math.pi, math.pi, "from 0 to 180 deg")  # on either side
EXPOSURE_VALUE = Limits(-100.0, 100.0, "from -100 to 100")  # far beyond any camera and any light

# Forms of a symbol's value.
QUANTITY, FLAG, CHOICE = "quantity", "flag", "choice"
WEIGHT, RESPONSE, FILTER = "weight", "response", "filter"
SPECTRUM, WAVELENGTHS, INTERVAL = "spectrum", "range of wavelengths", "interval"
POINT, VECTOR, GRID = "point", "vector", "grid"  # a vector has a direction
DIRECTION, DISTRIBUTION = "direction", "distribution"
NUMBERS = "numbers"  # as many as in the example
PAIR = "pair"  # of whole numbers, within the limits
UNIT, WORD = "unit", "word"


class InKinds(tuple[Dimension, ...]):
    """The dimensions of a light quantity or a ratio of kinds; those of weights are in it."""

    __slots__ = ()

    def __contains__(self, dimension: object) -> bool:
        """Return whether a dimension is one of these, or the same quantity in a weighted kind."""
        if super().__contains__(dimension):
            return True
        if not isinstance(dimension, tuple) or not dimension[-1]:
            return False
        if ratio_of(self[0]):
            return ratio_of(dimension) is not None
        return bool(place_of(dimension)) and super().__contains__(in_a_kind(dimension)[0])


class Symbol(NamedTuple):
    """A symbol: its names, its quantity and its allowed values.

    `dimensions` are those in which it can be given, its own first; `measured` are those of its
    units as a result: a wavelength can be given as a frequency, but has no unit of one.  `unit` is
    for display.  A light quantity has a geometry, and a kind if its name fixes the kind.
    """

    name: str
    letter: str
    dimensions: tuple[Dimension, ...]
    example: str = ""
    help: str = ""
    limits: Limits = POSITIVE
    label: str = ""
    unit: str = ""
    takes: str = ""
    form: str = QUANTITY
    choices: tuple[str, ...] = ()
    geometry: tuple[int, int, int] | None = None
    kind: str = ""
    generic: str = ""
    measured: tuple[Dimension, ...] = ()


def article(noun: str) -> str:
    """Return a noun with its article, by pronunciation: an f-number, a utilance."""
    is_vowel = noun[0] in "aeioAEIO" or noun.startswith(("f-", "up"))
    return f"{'an' if is_vowel else 'a'} {noun}"


def _symbol(
    dimension: Dimension,
    name: str,
    letter: str = "",
    example: str = "",
    help_: str = "",
    limits: Limits = POSITIVE,
    *,
    also: tuple[Dimension, ...] = (),
    label: str = "",
    unit: str = "",
    takes: str = "",
) -> Symbol:
    """Return a row; its unit and wording follow from its dimension, unless they are given."""
    if not takes:
        takes = "a number from 0 to 1" if limits is PART else article(OTHERS[dimension][0])
    return Symbol(
        name,
        letter,
        (InKinds if ratio_of(dimension) else tuple)((dimension, *also)),
        example,
        help_,
        limits,
        label or name.replace("-", " "),
        unit or ("deg" if dimension == ANGLE else COHERENT[dimension]),
        takes,
        # the energy of a photon has the same number in J and in J/photon
        measured=(dimension, *(d for d in also if PHOTON_NAMES.get(d) == name)),
    )


def _length(name: str, letter: str, *words: str, **more: str) -> Symbol:
    return _symbol(LENGTH, name, letter, *words, **more)  # type: ignore[arg-type]


def _area(name: str, letter: str, *words: str, **more: str) -> Symbol:
    return _symbol(AREA, name, letter, *words, **more)  # type: ignore[arg-type]


def _text(
    form: str,
    name: str,
    takes: str,
    example: str,
    help_: str,
    choices: tuple[str, ...] = (),
) -> Symbol:
    """Return the symbol of a condition that takes words, not a quantity."""
    return Symbol(
        name,
        "",
        (),
        example,
        help_,
        ANY,
        name,
        takes=takes,
        form=form,
        choices=choices,
    )


def _interval(name: str, example: str, help_: str) -> Symbol:
    return _symbol(LENGTH, name, "", example, help_, FROM_ZERO)._replace(form=INTERVAL)


def _pair(name: str, example: str, help_: str, limits: Limits) -> Symbol:
    return _text(PAIR, name, "two whole numbers", example, help_)._replace(limits=limits)


WHOLE_SPHERE = LATLONG, MIRROR_BALL, ANGULAR = "latlong", "mirror-ball", "angular"
CIRCLES = FISHEYE, EQUISOLID, ORTHOGRAPHIC, STEREOGRAPHIC = (
    "fisheye", "equisolid", "orthographic", "stereographic"
)  # fmt: skip
RECTANGLES = PERSPECTIVE, CYLINDRICAL = "perspective", "cylindrical"
PROJECTIONS = (*WHOLE_SPHERE, *CIRCLES, *RECTANGLES)
MOST_PIXELS = 1_000_000  # in each direction
DISTRIBUTIONS = ("isotropic", "cone", "lobe")
PROFILES = GAUSSIAN, UNIFORM = "gaussian", "uniform"
SCOTOPIC = kind_of_observer("scotopic")
ALPHA_OPIC = {suffix: row[2].lower() for suffix, row in WEIGHTS.items()
              if row[0] in ("melanopic", "s-cone", "m-cone", "l-cone", "rhodopic")}  # fmt: skip
OBSERVER_NAMES = ("photopic", "scotopic", "cie1964", "judd-vos", "cie2008-2", "cie2008-10")

HUE_BINS = (  # of TM-30, each in 16 bins
    ("rf", "R_f", "1", "local colour fidelity"),
    ("rcs", "R_cs", "%", "local chroma shift"),
    ("rhs", "R_hs", "1", "local hue shift"),
)
_ROWS = (
    # The light, and the links between its kinds.
    _symbol(LENGTH, "wavelength", "λ", "555nm",
        "Light of one wavelength (or frequency, wavenumber, photon energy).",
        also=(FREQUENCY, WAVENUMBER, ENERGY, PHOTON_ENERGY), unit="nm",
        takes="a wavelength, frequency, wavenumber or photon energy"),
    _text(SPECTRUM, "spectrum", "a spectrum", "D65",
        "Light with this spectrum: a name, blackbody:2856K, line:632.8nm, a file ..."),
    _symbol(RATIOS[LUMINOUS, RADIANT], "efficacy", "K", "93lm/W",
        "Ratio of two kinds of quantity: luminous to radiant (93lm/W), photon to radiant "
        "(2.1umol/J) or luminous to photon (54lm.s/umol).",
        also=tuple(RATIOS[pair] for pair in RATIOS if pair != (LUMINOUS, RADIANT)), unit="lm/W",
        takes="a ratio of two kinds"),
    _text(CHOICE, "observer", "an observer", "photopic",
        "Observer (eye response) for {wavelength}, {spectrum} or {efficacy}.", OBSERVER_NAMES),
    _text(WAVELENGTHS, "range", "two wavelengths", "380nm:780nm",
        "Radiant quantities of {spectrum} include only these wavelengths."),
    _text(WAVELENGTHS, "photon-range", "two wavelengths", "400nm:700nm",
        "Photon quantities of {spectrum} include only these wavelengths (default 400nm:700nm)."),
    _text(WEIGHT, "weight", "a weight", "melanopic",
        "Weigh the light: a name (melanopic, erythema, blue-light, ypf ...), or a file."),
    _text(FILTER, "filter", "a file", "yellow.csv",
        "Put filters before {spectrum}: a file of a transmittance, or several with commas."),
    _text(RESPONSE, "response", "a file", "silicon.csv",
        "Detector's responsivity over wavelength: a file in A/W, or of a quantum efficiency."),
    _text(FLAG, "dark-outside", "", "",
        "Take {spectrum} as dark where its data do not cover a weight."),
    _symbol(LENGTH, "bandwidth", "B", "10nm",
        "Width of a band of constant spectral density.",
        also=(FREQUENCY, WAVENUMBER, ENERGY, PHOTON_ENERGY),
        takes="a width in wavelength, frequency, wavenumber or photon energy"),
    # Sizes and places.
    _length("radius", "R", "10cm", "Radius of the source."),
    _length("diameter", "D", "20cm", "Diameter of the source."),
    _length("width", "w", "2m", "Width of the source, along x."),
    _length("length", "l", "1m", "Length of the source, along y."),
    _area("area", "A", "1m2", "Area of the source."),
    _length("distance", "d", "2m", "Straight-line distance to the centre of the source."),
    _length("height", "h", "50cm", "Distance from the source's plane, along its axis."),
    _symbol(LENGTH, "offset", "x", "20cm",
        "Sideways distance from the source's axis, along x (with {height}).", ANY),
    _symbol(LENGTH, "offset-y", "y", "20cm",
        "Sideways distance from the source's axis, along y (with {height}).", ANY,
        label="offset along y"),
    _symbol(ANGLE, "tilt", "θ_s", "60deg",
        "Angle between the source's axis and the line of sight.", TURN),
    _symbol(ANGLE, "incidence", "θ", "45deg", "Angle between the light and the receiver's normal.",
        TURN),
    _area("receiver-area", "A_r", "4cm2", "Area of the receiver."),
    _length("receiver-radius", "R_r", "1m", "Radius of the receiver."),
    _length("receiver-diameter", "D_r", "2m", "Diameter of the receiver."),
    # Cones and lobes.
    _symbol(ANGLE, "half-angle", "α", "30deg", "Half angle of a cone, from its axis to its edge.",
        Limits(0.0, math.pi, "at most 180 deg", without_low=True)),
    _symbol(ANGLE, "apex-angle", "2α", "60deg", "Full angle of a cone, from edge to edge.",
        Limits(0.0, 2 * math.pi, "at most 360 deg", without_low=True)),
    _symbol(SOLID_ANGLE, "solid-angle", "Ω", "1sr", "Solid angle.",
        Limits(0.0, 4 * math.pi, "at most 4pi sr", without_low=True)),
    _symbol(SOLID_ANGLE, "projected-solid-angle", "Ω_p", "1sr",
        "Solid angle projected along the cone's axis.",
        Limits(0.0, math.pi, "at most pi sr, a hemisphere", without_low=True)),
    _text(FLAG, "isotropic", "", "", "Light uniform in all directions, over 4 pi sr."),
    _text(FLAG, "hemisphere", "", "", "Light uniform over a hemisphere."),
    _text(FLAG, "sphere", "", "", "All directions."),
    _symbol(NUMBER, "configuration-factor", "F", "0.1", "Configuration factor."),
    _symbol(NUMBER, "sphere-fraction", "Ω/4π", label="fraction of the sphere"),
    _symbol(NUMBER, "exponent", "n", "1", "Exponent of a cosine-power lobe.", FROM_ZERO),
    _symbol(ANGLE, "beam-angle", "FWHM", "30deg",
        "Full beam angle, between the directions at half of the peak.", BEAM),
    _symbol(ANGLE, "field-angle", "FWTM", "60deg",
        "Full field angle, between the directions at a tenth of the peak.", BEAM),
    _symbol(ANGLE, "off-axis-angle", "θ", "20deg",
        "Angle between the lens's axis and the direction of the scene (default 0).", OFF_AXIS,
        label="angle off the lens's axis"),
    _symbol(ANGLE, "within", "β", "45deg",
        "Half angle of a cone; the result flux-within is the flux inside it.",
        Limits(0.0, math.pi, "from 0 to 180 deg", without_low=True),
        label="half angle of the cone"),
    _symbol(ANGLE, "off-axis", "γ", "20deg", "Angle between the source's axis and the light.",
        label="angle off the axis"),
    _symbol(ANGLE, "beam-angle-90", "FWHM_90", label="beam angle in C90-C270"),
    _symbol(ANGLE, "field-angle-90", "FWTM_90", label="field angle in C90-C270"),
    _length("beam-diameter", "D_b"),
    _symbol(ANGLE, "peak-polar", "γ_max", label="polar angle of the peak"),
    _symbol(ANGLE, "peak-azimuth", "C_max", label="azimuth of the peak"),
    _symbol(NUMBER, "output-ratio", "LOR", label="light output ratio"),
    _symbol(POWER, "input-power", "P", takes="a power"),
    _symbol(RATIOS[LUMINOUS, RADIANT], "source-efficacy", "η_v",
        label="luminous efficacy of the source", unit="lm/W"),
    # Surfaces between two media.
    _symbol(NUMBER, "index", "n", "1.52",
        "Refractive index after the surface, relative to the one before it.",
        label="refractive index"),
    _symbol(ANGLE, "refraction-angle", "θ_t", "30deg",
        "Angle between the refracted light and the normal.",
        Limits(0.0, math.pi / 2, "from 0 to 90 deg"), label="angle of refraction"),
    _symbol(ANGLE, "brewster-angle", "θ_B", "56.7deg",
        "Angle of incidence at which p-polarised light is not reflected.", OFF_AXIS,
        label="Brewster's angle"),
    _symbol(ANGLE, "critical-angle", "θ_c", "41.1deg",
        "Smallest angle of total reflection, in the denser medium.",
        Limits(0.0, math.pi / 2, "more than 0, up to 90 deg", without_low=True)),
    _symbol(NUMBER, "reflectance-s", "ρ_s", label="reflectance, s-polarised"),
    _symbol(NUMBER, "reflectance-p", "ρ_p", label="reflectance, p-polarised"),
    _symbol(NUMBER, "slab-transmittance", "τ_slab", label="transmittance of a slab"),
    # Directions and shapes.
    _symbol(ANGLE, "polar", "θ", "45deg", "Polar angle, from +z.",
        Limits(0.0, math.pi, "from 0 to 180 deg")),
    _symbol(ANGLE, "azimuth", "φ", "30deg", "Azimuth, from +x towards +y.", ANY),
    _symbol(ANGLE, "elevation", "h", "45deg", "Elevation above the plane of x and y.",
        Limits(-math.pi / 2, math.pi / 2, "from -90 to 90 deg")),
    _symbol(ANGLE, "horizontal", "a", "60deg",
        "Full angle between the left and right faces of the pyramid."),
    _symbol(ANGLE, "vertical", "b", "40deg",
        "Full angle between the upper and lower faces of the pyramid."),
    # Etendues.
    _symbol(ETENDUE, "etendue", "G", "1mm2.sr", "Etendue of the beam.", unit="m2 sr"),
    _symbol(ETENDUE, "far-field-etendue", "G_ff", label="far-field etendue", unit="m2 sr"),
    _symbol(NUMBER, "na", "NA", "0.22", "Numerical aperture, in air.",
        Limits(0.0, 1.0, "at most 1, in air", without_low=True), label="numerical aperture"),
    _symbol(NUMBER, "f-number", "N", "2.4", "F-number of the lens.", LENS,
        label="f-number"),
    # Surfaces, eyes, meters, bodies.
    _length("diagonal", "c", "100in", "Diagonal of the picture."),
    _symbol(NUMBER, "aspect", "a", "16/9", "Aspect ratio of the picture, width to height."),
    _symbol(NUMBER, "gain", "g", "1",
        "Gain of the screen, relative to a perfect diffuser (default 1)."),
    _symbol(NUMBER, "reflectance", "ρ", "0.8", "Reflectance of the reflector, 0 to 1 or in %.",
        PART),
    _symbol(NUMBER, "emissivity", "ε", "0.9",
        "Emissivity of a hot body, 0 to 1 or in % (default 1, a black body).", FRACTION),
    _text(FLAG, "corner", "", "", "Place the receiver under a corner of the rectangle."),
    _text(FLAG, "perpendicular", "", "",
        "Turn the receiver's normal parallel to the rectangle's length."),
    _text(DISTRIBUTION, "distribution", "a distribution", "lobe",
        "Distribution of the light: isotropic (the default without options of a cone or "
        "a lobe), cone, lobe, a file (IES, EULUMDAT, CSV), or 'EXPRESSION cd' in theta and phi.",
        DISTRIBUTIONS),
    _text(DIRECTION, "toward", "a direction", "60deg,90deg",
        "Direction from the source to the receiver, as POLAR (from the source's axis), "
        "POLAR,AZIMUTH or X,Y,Z (Z along the axis)."),
    _text(VECTOR, "aim", "a direction", "X,Y,Z",
        "Direction of the source's axis; 0,0,-1 is straight down."),
    _symbol(ANGLE, "rotate", "ψ", "90deg",
        "Rotation of the source about its axis before it is aimed: C0 turns from +x towards +y.",
        ANY),
    _text(POINT, "viewpoint", "a point", "X,Y,Z",
        "Point from which the polygon is seen (default 0,0,0)."),
    _text(VECTOR, "normal", "a direction", "X,Y,Z", "Normal of the plane of projection."),
    _symbol(NUMBER, "uniformity", "U_o", label="uniformity, minimum over mean"),
    _symbol(NUMBER, "minimum-to-maximum", "U_d", label="minimum over maximum"),
    _length("pupil", "d", "3mm", "Diameter of the eye's pupil."),
    _symbol(TIME, "time", "t", "1h", "Duration of the constant light."),
    _symbol(TIME, "photoperiod", "t", "16h",
        "Time of light in a day, for a daily light integral (dli).",
        Limits(0.0, 86400.0, "more than 0, up to 24 h", without_low=True)),
    _symbol(TIME, "max-gap", "", "10min", "Longest step between samples that is not a gap.",
        label="longest step"),
    _symbol(TIME, "duration", "T", unit="h"),
    _symbol(TIME, "covered-time", "t", unit="h"),
    _symbol(TIME, "time-of-maximum", "t_max", unit="h", label="time of the maximum"),
    _symbol(NUMBER, "samples", "n", label="number of samples"),
    _symbol(NUMBER, "gaps", "", label="number of gaps"),
    _symbol(TIME, "gap-time", "", unit="h", label="time in gaps"),
    _symbol(TIME, "longest-gap", "", unit="h"),
    _symbol(NUMBER, "ev", "EV", "12", "Exposure value, from f-number and time.", EXPOSURE_VALUE,
        label="exposure value"),
    _symbol(NUMBER, "ev100", "EV100", "15", "Exposure value of the light at ISO 100.",
        EXPOSURE_VALUE, label="exposure value at ISO 100"),
    _symbol(NUMBER, "iso", "S", "100", "ISO speed of the film or sensor (default 100).",
        label="ISO speed"),
    _symbol(NUMBER, "nd", "D", "0.9",
        "Optical density of a neutral filter on the lens: 0.9, or ND8 for a factor of 8.",
        FROM_ZERO, label="density of the filter"),
    _symbol(NUMBER, "stops", "n", "3", "Stops of light that the filter absorbs.", FROM_ZERO,
        label="stops of the filter"),
    _symbol(TIME, "unfiltered-time", "t0", "1/60s", "Exposure time without the filter.",
        label="exposure time without the filter", unit="s"),
    _length("guide-number", "GN", "40m", "Guide number of a flash, at ISO 100.",
        label="guide number"),
    _symbol(times(LUMINANCE, TIME), "k", "K", "12.5cd.s/m2",
        "Meter constant for reflected light (default 12.5 cd s/m2).", label="meter constant K",
        takes="a luminance times a time"),
    _symbol(times(ILLUMINANCE, TIME), "c", "C", "250lx.s",
        "Meter constant for incident light (default 250 lx s).", label="meter constant C",
        takes="an illuminance times a time"),
    _symbol(LUMINANCE, "saturation-luminance", "L_sat", "4000cd/m2",
        "Luminance at which the sensor saturates.", takes="a luminance"),
    _symbol(MASS, "mass", "m", "10g", "Mass of the heated body."),
    _symbol(SPECIFIC_HEAT, "specific-heat", "c", "385J/kg/K",
        "Specific heat capacity of the body."),
    _symbol(TEMPERATURE, "temperature-rise", "ΔT", "2K", "Temperature rise of the body.",
        takes="a temperature difference"),
    _symbol(ENERGY, "heat", "Q_h", "10J", "Heat absorbed by the body.", takes="a heat"),
    _symbol(NUMBER, "absorptance", "α", "0.95", "Absorptance of the body (default 1).",
        FRACTION, takes="a number from 0 to 1"),
    # Rooms.
    _symbol(NUMBER, "luminaires", "n", "12", "Number of luminaires.",
        label="number of luminaires"),
    _symbol(NUMBER, "luminaires-to-install", "n_i", label="luminaires to install"),
    _symbol(NUMBER, "room-index", "k", "2.5",
        "Area of the room, divided by half the area of its walls between the working plane and the "
        "luminaires."),
    _symbol(NUMBER, "utilance", "U", "0.6",
        "Utilance: fraction of the luminaires' flux that reaches the working plane, directly or "
        "after reflections.  If {flux} is that of the bare lamps, give the utilization factor "
        "here.", REFLECTED,
        takes="a number up to 1.5"),
    _symbol(NUMBER, "maintenance", "MF", "0.8",
        "Maintenance factor: fraction of the light that remains after ageing and soiling (default "
        "1).",
        FRACTION,
        label="maintenance factor", takes="a number from 0 to 1"),
    # Lasers.
    _text(CHOICE, "profile", "a profile", "gaussian",
        "Profile of the beam: Gaussian, with diameters at 1/e^2 of the peak (default), or uniform.",
        PROFILES),
    _symbol(ANGLE, "divergence", "φ", "1mrad", "Full divergence angle of the beam.",
        Limits(0.0, 0.25, "less than 0.25 rad, for a narrow beam", True, True), unit="mrad"),
    _length("spot-diameter", "D_s", "5mm", "Diameter of the spot at {distance}.", unit="mm"),
    _length("hazard-distance", "d_h", "50m",
        "Distance beyond which the peak irradiance is below the limit."),
    # Detectors.
    _symbol(NUMBER, "working-f-number", "N_w", "5.6",
        "Effective f-number at the given {magnification}.", LENS, label="working f-number"),
    _symbol(NUMBER, "magnification", "m", "0.5",
        "Size of the image relative to the scene (default 0).",
        FROM_ZERO),
    _symbol(NUMBER, "transmittance", "τ", "0.9", "Transmittance of the lens (default 1).",
        FRACTION, takes="a number from 0 to 1"),
    _length("pixel-pitch", "p", "3.45um", "Width and height of a square pixel.", unit="um"),
    _area("pixel-area", "A_p", "12um2", "Light-collecting area of a pixel or other detector.",
        unit="um2"),
    _symbol(PHOTONS, "photons", "N_p", "10000photon", "Photons on a pixel.",
        takes="a number of photons"),
    _symbol(NUMBER, "electrons", "N_e", "5000", "Electrons released by the photons."),
    _symbol(NUMBER, "quantum-efficiency", "η", "0.6", "Electrons per photon.", FRACTION,
        takes="a number from 0 to 1"),
    _symbol(NUMBER, "snr", "SNR", "100",
        "Signal-to-shot-noise ratio: the square root of the number of electrons.",
        label="signal-to-noise ratio"),
    _symbol(RESPONSIVITY, "responsivity", "s", "0.4A/W",
        "Current of the detector per watt of incident light."),
    _text(CHOICE, "electric-field", "a choice", "rms",
        "Convert to or from the electric field: its peak or its root mean square.",
        ("peak", "rms")),
    _symbol(CURRENT, "current", "i", "1uA", "Photocurrent of the detector.",
        takes="a current"),
    _symbol(NUMBER, "accuracy", "", "1e-9", "Relative accuracy of the integration (default 1e-9)."),
    # The sky.
    _symbol(ANGLE, "sun-elevation", "γ_s", "40deg", "Elevation of the sun above the horizon.",
        Limits(0.0, math.pi / 2, "from 0 to 90 deg, above the horizon")),
    _symbol(ANGLE, "sun-azimuth", "α_s", "180deg", "Azimuth of the sun, from +x towards +y.", ANY),
    _text(WORD, "place", "a latitude and a longitude", "50.1N,14.4E",
        "Latitude and longitude, whose sun is taken (with {when})."),
    _text(WORD, "when", "a date and a time", "2026-06-21T12:00+02:00",
        "Date and time of the sun (with {place}), with the offset from UTC."),
    _symbol(ANGLE, "sun-radius", "r_s", "0.2666deg",
        "Angular radius of the sun's disc (default 0.2666 deg).",
        Limits(0.0, math.pi / 2, "less than 90 deg", without_low=True, without_high=True),
        label="angular radius of the sun"),
    _symbol(NUMBER, "daylight-share", "D_n",
        label="daylight share of the plane"),
    # The surroundings of a place.
    _text(UNIT, "unit", "a unit of radiance", "cd/m2",
        "Unit of the map's values: cd/m2, W/m2/sr ...; 1 for relative values."),
    _text(WORD, "channel", "the name of a channel", "Y",
        "Channel or layer of the map to use (default: the luminance of R, G, B)."),
    _symbol(NUMBER, "coverage", "", label="covered share of the sphere"),
    # The cinematographer's light.
    _text(POINT, "point", "a point", "X,Y,Z", ""),
    _text(GRID, "grid", "a grid of points", "X0:X1:N,Y0:Y1:N,Z",
        "Grid of points: N along x from X0 to X1, N along y, at Z."),
    _text(FLAG, "omni", "", "",
        "Light in all directions; depths are then distances from the light."),
    _interval("near", "1m:2m",
        "Near cut A:B: dark up to the depth A, full light from B, smooth in between."),
    _interval("far", "5m:8m",
        "Far cut C:D: full light up to the depth C, dark from D, smooth in between."),
    _symbol(NUMBER, "falloff", "N", "2",
        "Exponent N of the fall-off (L/d)^N with the distance d (default 2, the inverse square).",
        FROM_ZERO,
        label="fall-off exponent"),
    _length("falloff-distance", "L", "1m", "Distance L at which the fall-off is 1 (default 1 m).",
        label="fall-off distance"),
    _symbol(NUMBER, "maximum", "M", "4",
        "Upper limit of the fall-off, relative to its value at {falloff-distance} (default: none).",
        Limits(1.0, said="1 or more"), label="maximum of the fall-off"),
    _symbol(NUMBER, "beam-exponent", "n", "1",
        "Exponent n of the factor (z/d)^n for directions off the axis (default 0).", FROM_ZERO),
    _text(NUMBERS, "superellipse", "four numbers", "0.4,0.3,0.5,0.4",
        "Half widths and half heights, divided by z: a,b of the fully lit area, A,B of the whole "
        "lit area."),
    _symbol(NUMBER, "roundness", "R", "1",
        "Roundness of {superellipse}, from 0 (rectangle) to 1 (ellipse, the default).", PART),
    _text(NUMBERS, "shear", "two numbers", "0.1,0",
        "Sideways shift X,Y of the superellipse's centre, divided by z (default 0,0)."),
    _symbol(NUMBER, "attenuation", "a"),
    _symbol(NUMBER, "depth-attenuation", "a_z", label="attenuation by depth"),
    _symbol(NUMBER, "superellipse-attenuation", "a_s", label="attenuation by the superellipse"),
    _symbol(NUMBER, "beam-attenuation", "a_b", label="attenuation by the beam"),
    _symbol(NUMBER, "falloff-attenuation", "a_d", label="attenuation by the fall-off"),
    # Maps of the sphere.
    _text(CHOICE, "projection", "a projection", "latlong",
        "Projection of a map: latlong (2:1 image), mirror-ball or angular (square images); with "
        "{field}: fisheye (equidistant), equisolid, orthographic, stereographic, perspective or "
        "cylindrical.",
        PROJECTIONS),
    _symbol(ANGLE, "field", "", "180deg",
        "Full angle that a picture shows: across the circle of a fisheye picture, or across the "
        "width.", Limits(0.0, 2 * math.pi, "at most 360 deg", without_low=True),
        label="field of view"),
    _text(NUMBERS, "mirror-ball", "two numbers", "0.6,0",
        "Point on a mirror ball: U to the right, V up, both divided by the radius."),
    _text(VECTOR, "reflect-at", "a direction", "X,Y,Z",
        "Reflect the direction at a mirror with this normal."),
    _text(VECTOR, "reflect-to", "a direction", "X,Y,Z",
        "Find the normal of the mirror that reflects the direction to this one."),
    *(_symbol(NUMBER, f"mirror-ball-{axis}", axis, limits=ANY, label=f"{axis} on a mirror ball")
      for axis in "uvw"),
    _pair("size", "1024x512", "Width and height of a map, in pixels.",
        Limits(1, MOST_PIXELS, f"from 1 to {MOST_PIXELS} pixels each way")),
    _pair("pixel", "0,0", "COLUMN,ROW of a pixel of a map, with 0,0 at the top left.",
        Limits(0, MOST_PIXELS - 1, f"from 0 to {MOST_PIXELS - 1} in column and row")),
    # Photons, spectra and eye responses.
    _symbol(FREQUENCY, "frequency", "ν", unit="THz"),
    _symbol(WAVENUMBER, "wavenumber", "σ", unit="cm-1"),
    _symbol(PHOTON_ENERGY, "photon-energy", "Q", also=(ENERGY,), unit="eV"),
    _symbol(NUMBER, "luminous-efficiency", "V"),
    _symbol(RATIOS[LUMINOUS, RADIANT], "luminous-efficacy", "K", unit="lm/W"),
    _symbol(NUMBER, "scotopic-luminous-efficiency", "V'"),
    _symbol(ratio(SCOTOPIC, RADIANT), "scotopic-luminous-efficacy", "K'", unit="lm_scot/W",
        takes="a scotopic luminous efficacy"),
    _symbol(NUMBER, "sp-ratio", "S/P", "2", "Scotopic/photopic ratio of the light.",
        Limits(0.0, 73.0, "more than 0, up to 73", without_low=True),
        label="scotopic/photopic ratio"),
    _symbol(RATIOS[PHOTON, RADIANT], "photon-efficacy", "K_p", unit="umol/J"),
    _symbol(RATIOS[LUMINOUS, PHOTON], "lux-per-ppfd", "", label="lux per PPFD", unit="lm.s/umol"),
    # Weights of a spectrum.
    *(_symbol(ratio(kind, LUMINOUS), f"{name}-elr", f"K_{kind},v", unit=f"mW_{kind}/lm",
              label=f"{name} efficacy of luminous radiation", takes="an efficacy")
      for kind, name in ALPHA_OPIC.items()),
    *(_symbol(NUMBER, f"{name}-der", f"γ_{kind},D65", label=f"{name} daylight efficacy ratio")
      for kind, name in ALPHA_OPIC.items()),
    *(_symbol(light_dimension(kind, (0, 1, 0), ""), f"{name}-edi", f"E_{kind},D65",
              unit=f"lx_{kind}", label=f"{name} EDI", takes="an irradiance")
      for kind, name in ALPHA_OPIC.items()),
    _symbol(light_dimension("ery", (0, 1, 0), ""), "uv-index", "UVI", unit="UVI",
        label="UV index", takes="an irradiance"),
    _symbol(ratio("act", LUMINOUS), "actinic-uv-elr", "K_act,v", unit="mW_act/klm",
        label="actinic UV per luminous flux", takes="an efficacy"),
    _symbol(ratio("blh", LUMINOUS), "blue-light-elr", "K_B,v", unit="mW_blh/lm",
        label="blue-light hazard efficacy of luminous radiation", takes="an efficacy"),
    _symbol(NUMBER, "mismatch", "M", label="spectral mismatch"),
    _symbol(NUMBER, "r-fr-smith10", "R:FR", label="red to far-red, 655-665 nm to 725-735 nm"),
    _symbol(ratio("mel", RADIANT), "per-watt", "", unit="W_mel/W", takes="an efficacy",
        label="weighted light per watt"),
    _symbol(ratio("mel", LUMINOUS), "per-lumen", "", unit="W_mel/lm", takes="an efficacy",
        label="weighted light per lumen"),
    _symbol(LENGTH, "peak-wavelength", "λ_p", unit="nm"),
    _symbol(LENGTH, "centroid-wavelength", "λ_c", unit="nm"),
    _symbol(LENGTH, "fwhm", "Δλ", label="full width at half maximum", unit="nm"),
    _symbol(LENGTH, "range-start", "λ_1", label="start of range", unit="nm"),
    _symbol(LENGTH, "range-end", "λ_2", label="end of range", unit="nm"),
    _symbol(NUMBER, "range-fraction", "", label="fraction in range", unit="%"),
    _symbol(NUMBER, "x", "x", limits=ANY, label="chromaticity x"),
    _symbol(NUMBER, "y", "y", limits=ANY, label="chromaticity y"),
    _symbol(NUMBER, "z", "z", limits=ANY),
    _symbol(TEMPERATURE, "cct", "T_cp", label="correlated colour temperature"),
    _symbol(NUMBER, "duv", "Duv", limits=ANY, label="distance from the Planckian"),
    _symbol(NUMBER, "cri", "R_a", limits=ANY, label="colour rendering index"),
    *(_symbol(NUMBER, f"r{k}", f"R_{k}", limits=ANY, label=f"colour rendering index R{k}")
      for k in range(1, 15)),
    _symbol(NUMBER, "rf", "R_f", limits=ANY, label="colour fidelity index"),
    _symbol(NUMBER, "rg", "R_g", limits=ANY, label="gamut index"),
    *(_symbol(NUMBER, f"{name}-h{k}", f"{letter},h{k}", limits=ANY, unit=unit,
              label=f"{label} in hue bin {k}")
      for name, letter, unit, label in HUE_BINS for k in range(1, 17)),
    _symbol(NUMBER, "ssi", "SSI", limits=ANY, label="spectral similarity index"),
    _text(SPECTRUM, "reference", "a spectrum", "D55",
        "Spectrum that ssi compares with (default: a black body or daylight of its colour "
        "temperature), or the reference of mismatch."),
    _symbol(LENGTH, "dominant-wavelength", "λ_d", unit="nm"),
    _symbol(LENGTH, "complementary-wavelength", "λ_c", unit="nm"),
    _symbol(NUMBER, "excitation-purity", "p_e", limits=ANY, unit="%"),
    *(_symbol(NUMBER, f"srgb-{name}", name[0].upper(), limits=ANY, label=f"sRGB {name}")
      for name in ("red", "green", "blue")),
    _symbol(TEMPERATURE, "temperature", "T"),
    _symbol(LUMINANCE, "mesopic-luminance", "L_mes", "0.1cd/m2",
        "Luminance for the eye response at mesopic adaptation.", takes="a luminance"),
    _symbol(of_kind(LUMINANCE, SCOTOPIC), "scotopic-luminance", "L'", "0.2cd_scot/m2",
        "Luminance for the eye response at dark adaptation, also in cd/m2.", takes="a luminance",
        also=(LUMINANCE,), unit="cd_scot/m2"),
    _symbol(NUMBER, "adaptation", "m", limits=ANY, label="adaptation coefficient"),
    _symbol(SOLID_ANGLE, "integral", "∫f dΩ", limits=ANY),
    _symbol(SOLID_ANGLE, "error", "", limits=ANY, label="estimate of the error"),
)  # fmt: skip
# Symbols of laws that are neither inputs nor results.
_INNER = (
    _symbol(NUMBER, "cosine", "cos(theta)"),
    _symbol(NUMBER, "cosine-of-source", "cos(theta_s)"),
    _symbol(NUMBER, "cosine-off-axis", "cos(theta)"),
    _symbol(NUMBER, "relative-intensity", "f"),
    _symbol(NUMBER, "part", "k"),
    _symbol(NUMBER, "beam-part", "k_b"),
    _symbol(NUMBER, "upward-part", "k_up"),
    _symbol(NUMBER, "relative-axial-intensity", "f_0"),
    _symbol(NUMBER, "relative-peak-intensity", "f_max"),
    _symbol(SOLID_ANGLE, "weighted-solid-angle", "Ω_f"),
    _symbol(SOLID_ANGLE, "received-solid-angle", "Ω_r"),
    _symbol(LENGTH, "lateral", "x"),
    _symbol(AREA, "apparent-area", "A_p"),
    _symbol(FREQUENCY, "exposure-setting", "b", unit="Hz"),
    _symbol(LENGTH, "extent", "s"),
    _symbol(LENGTH, "limit-diameter", "D_lim"),
    _symbol(SOLID_ANGLE, "horizontal-sky", "Ω_h"),
    _symbol(SOLID_ANGLE, "plane-sky", "Ω_n"),
    _symbol(NUMBER, "sun-height", "sin(γ_s)"),
    _symbol(NUMBER, "relative-radiance", "l_w"),
)
# Numbers that are not a part of a whole: a colour rendering index of 80 is not 8000 %.
NUMBERS_ALONE = frozenset(
    [
        *("ev", "ev100", "iso", "nd", "stops", "f-number", "working-f-number", "index", "exponent"),
        *("luminaires", "luminaires-to-install", "room-index", "samples", "gaps", "electrons"),
        *("beam-exponent", "falloff", "snr"),
        *("duv", "cri", "rf", "rg", "ssi", "srgb-red", "srgb-green", "srgb-blue"),
        *(f"r{k}" for k in range(1, 15)),
        *(f"{name}-h{k}" for name in ("rf", "rhs") for k in range(1, 17)),
    ]
)
# Numbers that are readings of scales, first their own, with the sizes of the steps; a filter's are
# losses.
STOP = math.log10(2)  # in densities
READINGS = {
    "ev": {"EV": 1.0},
    "ev100": {"EV": 1.0, "EV100": 1.0},
    "stops": {"stops": 1.0, "stop": 1.0, "OD": 1 / STOP, "dB": 0.1 / STOP},
    "nd": {"OD": 1.0, "stops": STOP, "stop": STOP, "dB": 0.1},
}


def is_alone(name: str, unit: Unit) -> bool:
    """Return whether a symbol is a number alone, and a unit a part of a whole: %, ppm."""
    is_part = unit.dimension == NUMBER and unit.factor != 1
    return is_part and name in NUMBERS_ALONE and unit.text not in READINGS.get(name, ())


INNER = frozenset({*(symbol.name for symbol in _INNER), "scale"})

# Light quantities by generic names, which serve every kind: geometry, letter, help, and the pattern
# of the name in one kind.
_LIGHT = (
    ("flux", (0, 0, 0), "Φ", "Total flux", "{}"),
    ("intensity", (0, 0, 1), "I", "Intensity on the source's axis", "{}"),
    ("peak-intensity", (0, 0, 1), "I_max", "Greatest intensity in any direction", "peak-{}"),
    ("intensity-toward", (0, 0, 1), "I_γ", "", "{}-toward"),
    ("upward-flux", (0, 0, 0), "Φ_up", "", "upward-{}"),
    ("downward-flux", (0, 0, 0), "Φ_down", "", "downward-{}"),
    ("irradiance", (0, 1, 0), "E", "Irradiance on the receiver", "{}"),
    ("exitance", (0, 1, 0), "M", "Exitance of the source", "{}"),
    ("radiance", (0, 1, 1), "L", "Uniform radiance of the source", "{}"),
    ("exposure", (1, 1, 0), "H",
     "Exposure of the receiver; {time} relates it to the irradiance", "{}"),
    ("energy", (1, 0, 0), "Q", "Total energy; {time} relates it to the flux", "{}"),
    ("incident-irradiance", (0, 1, 0), "E_i",
     "Irradiance on the reflector; {reflectance} relates it to the exitance", "incident-{}"),
    ("received-flux", (0, 0, 0), "Φ_r", "", "received-{}"),
    ("flux-within", (0, 0, 0), "Φ_w", "", "{}-within"),
    ("beam-flux", (0, 0, 0), "Φ_b", "", ""),
    ("mean-flux", (0, 0, 0), "Φ_mean", "", "mean-{}"),
    ("maximum-flux", (0, 0, 0), "Φ_max", "", "maximum-{}"),
    ("far-field-irradiance", (0, 1, 0), "E_ff", "", "far-field-{}"),
    ("mean-irradiance", (0, 1, 0), "E_mean", "", "mean-{}"),
    ("minimum-irradiance", (0, 1, 0), "E_min", "", "minimum-{}"),
    ("maximum-irradiance", (0, 1, 0), "E_max", "", "maximum-{}"),
    ("peak-irradiance", (0, 1, 0), "E_0", "Peak irradiance, on the axis",
     "peak-{}"),
    ("limit", (0, 1, 0), "E_lim",
     "Exposure limit as an irradiance, from the standard (with {hazard-distance})", "{}-limit"),
    ("installed-irradiance", (0, 1, 0), "E_i", "", "installed-{}"),
    ("zenith-radiance", (0, 1, 1), "L_z", "Radiance of the sky's zenith", "zenith-{}"),
    ("horizontal-irradiance", (0, 1, 0), "E_h",
     "Irradiance on the ground from the sky, without the sun", "horizontal-{}"),
    ("global-irradiance", (0, 1, 0), "E_g", "Irradiance on the ground from sky and sun",
     "global-{}"),
    ("sun-irradiance", (0, 1, 0), "E_s", "Irradiance from the sun, perpendicular to its rays",
     "sun-{}"),
    ("sun-radiance", (0, 1, 1), "L_s", "Radiance of the sun's disc", "sun-{}"),
    ("radiance-toward", (0, 1, 1), "L_w", "Radiance in the direction {toward}",
     "{}-toward"),
    ("diffuse-irradiance", (0, 1, 0), "E_d", "", "diffuse-{}"),
    ("direct-irradiance", (0, 1, 0), "E_b", "", "direct-{}"),
    ("mean-radiance", (0, 1, 1), "L_mean", "", "mean-{}"),
    ("peak-radiance", (0, 1, 1), "L_max", "", "peak-{}"),
)  # fmt: skip
# geometry -> units of display of each kind, and coherent units of derivations
LIGHT_UNITS = {
    (0, 0, 0): (("W", "lm", "umol/s"), ("W", "lm", "photon/s")),
    (0, 0, 1): (("W/sr", "cd", "umol/s/sr"), ("W/sr", "cd", "photon/s/sr")),
    (0, 1, 0): (("W/m2", "lx", "umol/m2/s"), ("W/m2", "lx", "photon/m2/s")),
    (0, 1, 1): (("W/m2/sr", "cd/m2", "umol/m2/s/sr"), ("W/m2/sr", "cd/m2", "photon/m2/s/sr")),
    (1, 1, 0): (("J/m2", "lx s", "umol/m2"), ("J/m2", "lx s", "photon/m2")),
    (1, 0, 0): (("J", "lm s", "umol"), ("J", "lm s", "photon")),
}


def light_unit(name: str, kind: str, coherent: bool = False) -> str:
    """Return the unit of display, or the coherent unit, of a light quantity with a generic name."""
    if kind in WEIGHTS:
        return with_suffix(light_unit(name, base_of(kind), coherent), kind)
    text = LIGHT_UNITS[_LIGHT_ROWS[name][1]][coherent][KINDS.index(kind)]
    return "lm/m2" if text == "lx" and name == "exitance" else text


def _of_light(
    name: str, generic: str, kind: str, row: tuple[str, tuple[int, int, int], str, str, str]
) -> Symbol:
    """Return the row of a light quantity, by its generic name (no kind) or its name of one kind."""
    _, geometry, letter, help_, _ = row
    unit = light_unit(generic, kind or LUMINOUS)
    own = [light_dimension(k, geometry, "") for k in ((kind,) if kind else KINDS)]
    dimensions = tuple(own) if kind else InKinds(own)
    label = name.replace("-", " ")
    if kind and help_:
        what, mark, more = help_.partition(";")
        help_ = f"{what}, as {label}{mark}{more}"
    return Symbol(
        name,
        letter if "_" in letter or not kind else f"{letter}_{kind}",
        dimensions,
        _EXAMPLES.get(name, f"100{unit}".replace(" ", ".")),
        f"{help_}." if help_ else "",
        POSITIVE,
        label,
        unit,
        article(label),
        geometry=geometry,
        kind=kind,
        generic=generic,
        measured=dimensions[:1],
    )


_EXAMPLES = {"luminance": "1000cd/m2", "illuminance": "10klx"}


def specific_name(generic: str, kind: str) -> str:
    """Return the name of a light quantity in one kind: flux and luminous give luminous-flux."""
    _, geometry, _, _, pattern = _LIGHT_ROWS[generic]
    if not pattern:
        return generic if kind == RADIANT else _joined(f"{KIND_NAMES[kind]}-{generic}")
    names = EXITANCES if generic == "exitance" else GEOMETRIES[geometry][0]
    return pattern.format(_joined(in_words(kind, names)))


def _joined(name: str) -> str:
    return name.lower().replace(" ", "-")


def generic_name(name: str) -> str:
    """Return the generic name of a light quantity, which any other result has itself."""
    symbol = SYMBOLS.get(name.removeprefix("radiant-"))
    return symbol.generic or symbol.name if symbol else name


class Vocabulary(dict[str, Symbol]):
    """Symbols by name; those of weighted light (melanopic-irradiance) are made when looked up."""

    def __missing__(self, name: str) -> Symbol:
        """Return the symbol of a name in a weighted kind."""
        generic, kind = _weighted_names()[name]
        return _of_light(name, generic, kind, _LIGHT_ROWS[generic])

    def get(self, name: str, default: Any = None) -> Any:
        """Return a symbol, also of weighted light, or the default."""
        return self[name] if name in self or name in _weighted_names() else default


@cache
def _weighted_names() -> dict[str, tuple[str, str]]:
    names = [(specific_name(generic, kind), generic, kind)
             for kind in WEIGHTS for generic in _LIGHT_ROWS]  # fmt: skip
    return {name: (generic, kind) for name, generic, kind in names}


def forget_weights() -> None:
    """Forget the names of weighted light, before a weight is added."""
    _weighted_names.cache_clear()


def weighted_generic(name: str) -> str:
    """Return the generic name of weighted light; '' for another name."""
    return _weighted_names().get(name, ("", ""))[0]


_LIGHT_ROWS = {row[0]: row for row in _LIGHT}
SYMBOLS: dict[str, Symbol] = Vocabulary({symbol.name: symbol for symbol in (*_ROWS, *_INNER)})
# The intensity that corresponds to 1 in a relative distribution.
SYMBOLS["scale"] = _of_light("intensity", "intensity", "", _LIGHT_ROWS["intensity"])._replace(
    name="scale", letter="I_1", help="", label="scale"
)
SPECIFIC: dict[str, tuple[str, str]] = {}  # name of one kind -> generic name and kind
for _name, _row in _LIGHT_ROWS.items():
    SYMBOLS[_name] = _of_light(_name, _name, "", _row)
    for _kind in KINDS:
        _own = specific_name(_name, _kind)
        if _own != _name:
            SPECIFIC[_own] = (_name, _kind)
            SYMBOLS[_own] = _of_light(_own, _name, _kind, _row)


def in_kind(name: str, kind: str) -> str:
    """Return a name in a kind of light: irradiance of lumens is illuminance."""
    symbol = SYMBOLS.get(name)
    if kind != LUMINOUS or symbol is None or "radiance" not in symbol.generic:
        return name
    return specific_name(symbol.generic, kind)


METER_UNITS = {"k": "cd.s/m2", "c": "lx.s"}  # units of bare light meter constants
LINKS = ("wavelength", "spectrum", "efficacy")  # links between the kinds of light
EFFICACIES = (  # the ratios of two kinds: name, the kind over, the kind under
    ("luminous-efficacy", LUMINOUS, RADIANT),
    ("photon-efficacy", PHOTON, RADIANT),
    ("lux-per-ppfd", LUMINOUS, PHOTON),
)
REFINEMENTS = ("observer", "weight", "range", "photon-range", "filter", "dark-outside")


def names_of_kinds(generic: str) -> tuple[str, ...]:
    """Return the names of one kind that correspond to a generic name."""
    return tuple(name for name, (generic_name, _) in SPECIFIC.items() if generic_name == generic)
