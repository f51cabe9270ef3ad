"""The vocabulary: one row for each symbol that can be given, follows, or stands in a law.

Options, keywords, results, error texts, completions and the option items of the manual are read
from here.  A help text names another symbol as {name}: the command line and the Python API spell
it in their own ways.
"""

import math
from typing import NamedTuple

from radcalc.quantities.light import (
    EXITANCES,
    GEOMETRIES,
    KIND_NAMES,
    KINDS,
    LUMINOUS,
    OTHERS,
    PHOTON,
    RADIANT,
    RATIOS,
    light_dimension,
)
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
from radcalc.units.unit import NUMBER, Dimension

INFINITE = math.inf


class Limits(NamedTuple):
    """The values [SI] that a symbol can have, and how that is said."""

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
REFLECTED = Limits(0.0, 1.5, "more than 0, up to 1.5", without_low=True)  # and used again
LENS = Limits(0.5, said="0.5 or more, in air")  # where the sine of the half angle is 1
OFF_AXIS = Limits(0.0, math.pi / 2, "from 0 to less than 90 deg", without_high=True)
TURN = Limits(-math.pi, math.pi, "from 0 to 180 deg")  # on either side
EXPOSURE_VALUE = Limits(-100.0, 100.0, "from -100 to 100")  # no camera and no light comes near

# How the value of a symbol is written.
QUANTITY, FLAG, CHOICE = "quantity", "flag", "choice"
SPECTRUM, WAVELENGTHS, INTERVAL = "spectrum", "range of wavelengths", "interval"
POINT, VECTOR, GRID = "point", "vector", "grid"  # a vector has a direction
DIRECTION, DISTRIBUTION = "direction", "distribution"
NUMBERS = "numbers"  # as many as the example has
PAIR = "pair"  # of whole numbers, within the limits
UNIT, WORD = "unit", "word"


class Symbol(NamedTuple):
    """A symbol: what it is called, what it measures, and which values it can have.

    `dimensions` are those in which it can be given or asked for, the first is its own; `unit` is
    the one in which it is shown.  A light quantity has its geometry, and its kind where its name
    fixes it.
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


def article(noun: str) -> str:
    """A noun with its article, as it is spoken: an f-number, a utilance."""
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
    """Make a row; its unit and wording follow from its dimension, unless they are given."""
    if not takes:
        takes = "a number from 0 to 1" if limits is PART else article(OTHERS[dimension][0])
    return Symbol(
        name,
        letter,
        (dimension, *also),
        example,
        help_,
        limits,
        label or name.replace("-", " "),
        unit or ("deg" if dimension == ANGLE else COHERENT[dimension]),
        takes,
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
    """A row of what is no quantity."""
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


def _interval(dimension: Dimension, name: str, example: str, help_: str) -> Symbol:
    return _symbol(dimension, name, "", example, help_, FROM_ZERO)._replace(form=INTERVAL)


def _pair(name: str, example: str, help_: str, limits: Limits) -> Symbol:
    return _text(PAIR, name, "two whole numbers", example, help_)._replace(limits=limits)


PROJECTIONS = LATLONG, MIRROR_BALL, ANGULAR = "latlong", "mirror-ball", "angular"
MOST_PIXELS = 1_000_000  # each way
DISTRIBUTIONS = ("isotropic", "cone", "lobe")
PROFILES = GAUSSIAN, UNIFORM = "gaussian", "uniform"
OBSERVER_NAMES = ("photopic", "scotopic", "cie1964", "judd-vos", "cie2008-2", "cie2008-10")

_ROWS = (
    # The light, and what links its kinds.
    _symbol(LENGTH, "wavelength", "λ", "555nm",
        "Light of one wavelength (or frequency, wavenumber, photon energy).",
        also=(FREQUENCY, WAVENUMBER, ENERGY, PHOTON_ENERGY), unit="nm",
        takes="a wavelength, frequency, wavenumber or photon energy"),
    _text(SPECTRUM, "spectrum", "a spectrum", "D65",
        "Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ..."),
    _symbol(RATIOS[LUMINOUS, RADIANT], "efficacy", "K", "93lm/W",
        "A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol.",
        also=tuple(RATIOS[pair] for pair in RATIOS if pair != (LUMINOUS, RADIANT)), unit="lm/W",
        takes="a ratio of two kinds"),
    _text(CHOICE, "observer", "an observer", "photopic",
        "Whose eyes see {wavelength} or {spectrum}.", OBSERVER_NAMES),
    _text(WAVELENGTHS, "range", "two wavelengths", "380nm:780nm",
        "Where the watts of {spectrum} are counted."),
    _text(WAVELENGTHS, "photon-range", "two wavelengths", "400nm:700nm",
        "Where the photons of {spectrum} are counted (default 400nm:700nm)."),
    _symbol(LENGTH, "bandwidth", "B", "10nm",
        "Width of a band in which the spectral density is constant.", also=(FREQUENCY, WAVENUMBER),
        takes="a width in wavelength, frequency or wavenumber"),
    # Sizes and places.
    _length("radius", "R", "10cm", "Radius of the source."),
    _length("diameter", "D", "20cm", "Diameter of the source."),
    _length("width", "w", "2m", "Width of the source, along x."),
    _length("length", "l", "1m", "Length of the source, along y."),
    _area("area", "A", "1m2", "Area of the source."),
    _length("distance", "d", "2m", "Straight line to the centre of what is seen."),
    _length("height", "h", "50cm", "Height above the source's plane, along its axis."),
    _symbol(LENGTH, "offset", "x", "20cm",
        "How far aside of the source's axis, along x (with {height}).", ANY),
    _symbol(LENGTH, "offset-y", "y", "20cm", "How far aside of it along y (with {height}).", ANY,
        label="offset along y"),
    _symbol(ANGLE, "tilt", "θ_s", "60deg",
        "Angle by which the source is turned from the line of sight.", TURN),
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
    _text(FLAG, "isotropic", "", "", "Uniform in all directions, over 4 pi sr."),
    _text(FLAG, "hemisphere", "", "", "Uniform over a hemisphere."),
    _text(FLAG, "sphere", "", "", "All directions."),
    _symbol(NUMBER, "configuration-factor", "F", "0.1", "Configuration factor."),
    _symbol(NUMBER, "sphere-fraction", "Ω/4π", label="fraction of the sphere"),
    _symbol(NUMBER, "exponent", "n", "1", "Exponent of a cosine-power lobe.", FROM_ZERO),
    _symbol(ANGLE, "beam-angle", "FWHM", "30deg",
        "Full angle of a lobe, where half the peak is left.", BEAM),
    _symbol(ANGLE, "field-angle", "FWTM", "60deg",
        "Full angle of a lobe, where a tenth of it is left.", BEAM),
    _symbol(ANGLE, "off-axis-angle", "θ", "20deg",
        "Angle between the lens's axis and what is seen (0).", OFF_AXIS,
        label="angle off the lens's axis"),
    _symbol(ANGLE, "within", "β", "45deg", "Half angle within which the flux is wanted.",
        Limits(0.0, math.pi, "from 0 to 180 deg", without_low=True),
        label="half angle of the part"),
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
        "Refractive index after the surface, over that before it.", label="refractive index"),
    _symbol(ANGLE, "refraction-angle", "θ_t", "30deg",
        "Angle between the refracted light and the normal.",
        Limits(0.0, math.pi / 2, "from 0 to 90 deg"), label="angle of refraction"),
    _symbol(ANGLE, "brewster-angle", "θ_B", "56.7deg",
        "Angle of incidence at which no p-polarised light is reflected.", OFF_AXIS,
        label="Brewster's angle"),
    _symbol(ANGLE, "critical-angle", "θ_c", "41.1deg",
        "Smallest angle at which light in the denser medium is totally reflected.",
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
        "Full angle between the pyramid's left and right face."),
    _symbol(ANGLE, "vertical", "b", "40deg", "Full angle between its upper and lower face."),
    # Etendues.
    _symbol(ETENDUE, "etendue", "G", "1mm2.sr", "Etendue of the beam.", unit="m2 sr"),
    _symbol(ETENDUE, "far-field-etendue", "A1 A2/d²", label="far-field etendue", unit="m2 sr"),
    _symbol(NUMBER, "na", "NA", "0.22", "Numerical aperture, in air.",
        Limits(0.0, 1.0, "at most 1, in air", without_low=True), label="numerical aperture"),
    _symbol(NUMBER, "f-number", "N", "2.4", "The lens's f-number.", LENS,
        label="f-number"),
    # Surfaces, eyes, meters, bodies.
    _length("diagonal", "c", "100in", "Diagonal of the picture."),
    _symbol(NUMBER, "aspect", "a", "16/9", "Width of the picture over its height."),
    _symbol(NUMBER, "gain", "g", "1", "Gain of the screen, over a perfect diffuser (1)."),
    _symbol(NUMBER, "reflectance", "ρ", "0.8", "Reflectance of the reflector, 0 to 1 or in %.",
        PART),
    _text(FLAG, "corner", "", "", "The receiver is under a corner of the rectangle."),
    _text(FLAG, "perpendicular", "", "", "Its normal runs along the rectangle's length."),
    _text(DISTRIBUTION, "distribution", "a distribution", "lobe",
        "How the light is spread: isotropic (unless an option of a cone or a lobe is given), cone, "
        "lobe, a file (IES, EULUMDAT, CSV), or 'EXPRESSION cd' in theta and phi.",
        DISTRIBUTIONS),
    _text(DIRECTION, "toward", "a direction", "60deg,90deg",
        "A direction from the source, in which the receiver is: POLAR from its axis, "
        "POLAR,AZIMUTH, or X,Y,Z with Z along the axis."),
    _text(VECTOR, "aim", "a direction", "X,Y,Z",
        "Where the source's axis points; straight down is 0,0,-1."),
    _symbol(ANGLE, "rotate", "ψ", "90deg",
        "Angle by which the source is turned about its axis, C0 from +x towards +y.", ANY),
    _text(POINT, "viewpoint", "a point", "X,Y,Z", "Where the polygon is seen from (0,0,0)."),
    _text(VECTOR, "normal", "a direction", "X,Y,Z", "Normal of the plane projected onto."),
    _symbol(NUMBER, "uniformity", "U_o", label="uniformity, minimum over mean"),
    _symbol(NUMBER, "minimum-to-maximum", "U_d", label="minimum over maximum"),
    _length("pupil", "d", "3mm", "Diameter of the eye's pupil."),
    _symbol(TIME, "time", "t", "1h", "How long the light is constant."),
    _symbol(TIME, "max-gap", "", "10min", "Bridge no longer step between samples than that.",
        label="longest step"),
    _symbol(TIME, "duration", "T", unit="h"),
    _symbol(TIME, "covered-time", "t", unit="h"),
    _symbol(TIME, "time-of-maximum", "t_max", unit="h", label="time of the maximum"),
    _symbol(NUMBER, "samples", "n", label="number of samples"),
    _symbol(NUMBER, "gaps", "", label="number of gaps"),
    _symbol(TIME, "gap-time", "", unit="h", label="time in gaps"),
    _symbol(TIME, "longest-gap", "", unit="h"),
    _symbol(NUMBER, "ev", "EV", "12", "Exposure value, of f-number and time.", EXPOSURE_VALUE,
        label="exposure value"),
    _symbol(NUMBER, "ev100", "EV100", "15", "Exposure value at ISO 100, of the light.",
        EXPOSURE_VALUE, label="exposure value at ISO 100"),
    _symbol(NUMBER, "iso", "S", "100", "Speed of the film or sensor (100).", label="ISO speed"),
    _symbol(NUMBER, "nd", "D", "0.9",
        "Density of a neutral filter in front of the lens: 0.9, or ND8 for a factor of 8.",
        FROM_ZERO, label="density of the filter"),
    _symbol(NUMBER, "stops", "n", "3", "How many stops the filter takes.", FROM_ZERO,
        label="stops of the filter"),
    _symbol(TIME, "unfiltered-time", "t0", "1/60s", "Exposure time without the filter.",
        label="exposure time without the filter", unit="s"),
    _length("guide-number", "GN", "40m", "Guide number of a flash, at ISO 100.",
        label="guide number"),
    _symbol(times(LUMINANCE, TIME), "k", "K", "12.5cd.s/m2",
        "The meter's constant for reflected light (12.5 cd s/m2).", label="meter constant K",
        takes="a luminance times a time"),
    _symbol(times(ILLUMINANCE, TIME), "c", "C", "250lx.s",
        "The meter's constant for incident light (250 lx s).", label="meter constant C",
        takes="an illuminance times a time"),
    _symbol(LUMINANCE, "saturation-luminance", "L_sat", "4000cd/m2",
        "Luminance at which the sensor saturates.", takes="a luminance"),
    _symbol(MASS, "mass", "m", "10g", "Mass of the body that is heated."),
    _symbol(SPECIFIC_HEAT, "specific-heat", "c", "385J/kg/K", "Its specific heat capacity."),
    _symbol(TEMPERATURE, "temperature-rise", "ΔT", "2K", "How much warmer it gets.",
        takes="a temperature difference"),
    _symbol(ENERGY, "heat", "Q_h", "10J", "Heat that the body takes up.", takes="a heat"),
    _symbol(NUMBER, "absorptance", "α", "0.95", "The part of the light that it absorbs (1).",
        FRACTION, takes="a number from 0 to 1"),
    # Rooms.
    _symbol(NUMBER, "luminaires", "n", "12", "How many luminaires there are.",
        label="number of luminaires"),
    _symbol(NUMBER, "luminaires-to-install", "n_i", label="luminaires to install"),
    _symbol(NUMBER, "room-index", "k", "2.5",
        "The room's area over half its walls' from the working plane up to the luminaires."),
    _symbol(NUMBER, "utilance", "U", "0.6",
        "The part of the luminaires' flux that gets to the working plane, at once or reflected; "
        "with the flux of bare lamps, the utilization factor.", REFLECTED,
        takes="a number up to 1.5"),
    _symbol(NUMBER, "maintenance", "MF", "0.8",
        "Maintenance factor: the part of the light that is left by ageing and dirt (1).", FRACTION,
        label="maintenance factor", takes="a number from 0 to 1"),
    # Lasers.
    _text(CHOICE, "profile", "a profile", "gaussian",
        "Gaussian, with diameters where 1/e^2 of the peak is left (by default), or uniform.",
        PROFILES),
    _symbol(ANGLE, "divergence", "φ", "1mrad", "Full angle by which the beam spreads.",
        Limits(0.0, 0.25, "less than 0.25 rad, for a narrow beam", True, True), unit="mrad"),
    _length("spot-diameter", "D_s", "5mm", "Diameter of the spot at the distance.", unit="mm"),
    _length("hazard-distance", "d_h", "50m",
        "Distance beyond which the peak irradiance is below the limit."),
    # Detectors.
    _symbol(NUMBER, "working-f-number", "N_w", "5.6", "The f-number at the magnification.", LENS,
        label="working f-number"),
    _symbol(NUMBER, "magnification", "m", "0.5", "Size of the image over that of the scene (0).",
        FROM_ZERO),
    _symbol(NUMBER, "transmittance", "τ", "0.9", "The part of the light that the lens lets through "
        "(1).", FRACTION, takes="a number from 0 to 1"),
    _length("pixel-pitch", "p", "3.45um", "Width and height of a square pixel.", unit="um"),
    _area("pixel-area", "A_p", "12um2", "Area of a pixel, or of another detector.", unit="um2"),
    _symbol(PHOTONS, "photons", "N_p", "10000photon", "Photons on a pixel.",
        takes="a number of photons"),
    _symbol(NUMBER, "electrons", "N_e", "5000", "Electrons that the photons set free."),
    _symbol(NUMBER, "quantum-efficiency", "η", "0.6", "Electrons per photon.", FRACTION,
        takes="a number from 0 to 1"),
    _symbol(NUMBER, "snr", "SNR", "100", "Signal over its shot noise, the root of the electrons.",
        label="signal to noise"),
    _symbol(RESPONSIVITY, "responsivity", "s", "0.4A/W",
        "Current that the detector gives per watt of light on it."),
    _text(CHOICE, "electric-field", "a choice", "rms",
        "How the electric field of the light is told: its peak, or its root mean square.",
        ("peak", "rms")),
    _symbol(CURRENT, "current", "i", "1uA", "Current that the light makes in the detector.",
        takes="a current"),
    _symbol(NUMBER, "accuracy", "", "1e-9", "Relative, at which to stop (1e-9)."),
    # The sky.
    _symbol(ANGLE, "sun-elevation", "γ_s", "40deg", "Elevation of the sun above the horizon.",
        Limits(0.0, math.pi / 2, "from 0 to 90 deg, above the horizon")),
    _symbol(ANGLE, "sun-azimuth", "α_s", "180deg", "Azimuth of the sun, from +x towards +y.", ANY),
    _symbol(ANGLE, "sun-radius", "r_s", "0.2666deg",
        "Angular radius of the sun's disc (0.2666 deg).",
        Limits(0.0, math.pi / 2, "less than 90 deg", without_low=True, without_high=True),
        label="angular radius of the sun"),
    _symbol(NUMBER, "daylight-share", "s",
        label="daylight share of the plane"),
    # What surrounds a place.
    _text(UNIT, "unit", "a unit of radiance", "cd/m2",
        "What the map's values are in: cd/m2, W/m2/sr ...; 1 where they are relative."),
    _text(WORD, "channel", "the name of a channel", "Y",
        "One channel of the map alone (by default the luminance of all of them)."),
    _symbol(NUMBER, "coverage", "", label="covered share of the sphere"),
    # The cinematographer's light.
    _text(POINT, "point", "a point", "X,Y,Z", ""),
    _text(GRID, "grid", "a grid of points", "X0:X1:N,Y0:Y1:N,Z",
        "A grid of such points: N along x from X0 to X1, N along y, at Z."),
    _text(FLAG, "omni", "", "", "It shines everywhere, and depths are distances from it."),
    _interval(LENGTH, "near", "1m:2m", "Dark up to A, full from B on, smooth between."),
    _interval(LENGTH, "far", "5m:8m", "Full up to C, dark from D on, smooth between."),
    _symbol(NUMBER, "falloff", "N", "2",
        "How it falls off with the distance d: as (L/d)^N (2, the inverse square).", FROM_ZERO,
        label="fall-off exponent"),
    _length("falloff-distance", "L", "1m", "The distance L at which that is 1 (1 m).",
        label="fall-off distance"),
    _symbol(NUMBER, "maximum", "M", "4",
        "What it is held to next to the light, over that at {falloff-distance} (no maximum).",
        Limits(1.0, said="1 or more"), label="maximum of the fall-off"),
    _symbol(NUMBER, "beam-exponent", "n", "1",
        "Times (z/d)^n: how it falls off aside of the axis (0).", FROM_ZERO),
    _text(NUMBERS, "superellipse", "four numbers", "0.4,0.3,0.5,0.4",
        "a,b,A,B: half width and height, over z, within which it is full, and beyond which dark."),
    _symbol(NUMBER, "roundness", "R", "1",
        "Of {superellipse}: 0 a rectangle, 1 an ellipse (1).", PART),
    _text(NUMBERS, "shear", "two numbers", "0.1,0",
        "X,Y: how far aside its centre is, over z (0,0)."),
    _symbol(NUMBER, "attenuation", "a"),
    _symbol(NUMBER, "depth-attenuation", "a_z", label="attenuation by depth"),
    _symbol(NUMBER, "superellipse-attenuation", "a_s", label="attenuation by the superellipse"),
    _symbol(NUMBER, "beam-attenuation", "a_b", label="attenuation by the beam"),
    _symbol(NUMBER, "falloff-attenuation", "a_d", label="attenuation by the fall-off"),
    # Maps of the sphere.
    _text(CHOICE, "projection", "a projection", "latlong",
        "How a map shows the sphere: latlong (2:1), or mirror-ball or angular, in a square.",
        PROJECTIONS),
    _text(NUMBERS, "mirror-ball", "two numbers", "0.6,0",
        "U,V, to the right and up: what a mirror ball shows there, over its radius."),
    _text(VECTOR, "reflect-at", "a direction", "X,Y,Z",
        "Give the direction's reflection at a mirror of that normal."),
    _text(VECTOR, "reflect-to", "a direction", "X,Y,Z",
        "Give the normal of the mirror that reflects the direction to there."),
    *(_symbol(NUMBER, f"mirror-ball-{axis}", axis, limits=ANY, label=f"{axis} on a mirror ball")
      for axis in "uvw"),
    _pair("size", "1024x512", "Width and height of a map, in pixels.",
        Limits(1, MOST_PIXELS, f"from 1 to {MOST_PIXELS} pixels each way")),
    _pair("pixel", "0,0", "COLUMN,ROW of a pixel of a map; 0,0 is at the top left.",
        Limits(0, MOST_PIXELS - 1, f"from 0 to {MOST_PIXELS - 1} in column and row")),
    # Photons, spectra and what the eye makes of them.
    _symbol(FREQUENCY, "frequency", "ν", unit="THz"),
    _symbol(WAVENUMBER, "wavenumber", "σ", unit="cm-1"),
    _symbol(PHOTON_ENERGY, "photon-energy", "Q", also=(ENERGY,), unit="eV"),
    _symbol(NUMBER, "luminous-efficiency", "V"),
    _symbol(RATIOS[LUMINOUS, RADIANT], "luminous-efficacy", "K", unit="lm/W"),
    _symbol(NUMBER, "scotopic-luminous-efficiency", "V'"),
    _symbol(RATIOS[LUMINOUS, RADIANT], "scotopic-luminous-efficacy", "K'", unit="lm/W"),
    _symbol(NUMBER, "sp-ratio", "S/P", "2", "The light's ratio of scotopic to photopic.",
        Limits(0.0, 73.0, "more than 0, up to 73", without_low=True),
        label="scotopic/photopic ratio"),
    _symbol(RATIOS[PHOTON, RADIANT], "photon-efficacy", "K_p", unit="umol/J"),
    _symbol(RATIOS[LUMINOUS, PHOTON], "lux-per-ppfd", "", label="lux per PPFD", unit="lm.s/umol"),
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
    _symbol(TEMPERATURE, "temperature", "T"),
    _symbol(LUMINANCE, "mesopic-luminance", "L_mes", "0.1cd/m2",
        "The luminance that the half-adapted eye sees.", takes="a luminance"),
    _symbol(LUMINANCE, "scotopic-luminance", "L'", "0.2cd/m2",
        "The luminance as the dark-adapted eye sees it.", takes="a luminance"),
    _symbol(NUMBER, "adaptation", "m", limits=ANY, label="adaptation coefficient"),
    _symbol(SOLID_ANGLE, "integral", "∫f dΩ", limits=ANY),
    _symbol(SOLID_ANGLE, "error", "", limits=ANY, label="estimate of the error"),
)  # fmt: skip
# What stands in laws alone, and is neither given nor shown.
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
INNER = frozenset({*(symbol.name for symbol in _INNER), "scale"})

# Light quantities by generic names, which serve every kind: geometry, letter, help, and how the
# names of one kind are made of those of the grid.
_LIGHT = (
    ("flux", (0, 0, 0), "Φ", "All the flux", "{}"),
    ("intensity", (0, 0, 1), "I", "The intensity on the source's axis", "{}"),
    ("peak-intensity", (0, 0, 1), "I_max", "The greatest intensity in any direction", "peak-{}"),
    ("intensity-toward", (0, 0, 1), "I_γ", "", "{}-toward"),
    ("upward-flux", (0, 0, 0), "Φ_up", "", "upward-{}"),
    ("downward-flux", (0, 0, 0), "Φ_down", "", "downward-{}"),
    ("irradiance", (0, 1, 0), "E", "The irradiance on the receiver", "{}"),
    ("exitance", (0, 1, 0), "M", "The exitance of the source", "{}"),
    ("radiance", (0, 1, 1), "L", "The uniform radiance of the source", "{}"),
    ("exposure", (1, 1, 0), "H", "The exposure of the receiver (with {time})", "{}"),
    ("energy", (1, 0, 0), "Q", "All the energy (with {time})", "{}"),
    ("incident-irradiance", (0, 1, 0), "E_i",
     "The irradiance on the reflector (with {reflectance})", "incident-{}"),
    ("received-flux", (0, 0, 0), "Φ_r", "", "received-{}"),
    ("flux-within", (0, 0, 0), "Φ_w", "", "{}-within"),
    ("beam-flux", (0, 0, 0), "Φ_b", "", ""),
    ("mean-flux", (0, 0, 0), "Φ_mean", "", "mean-{}"),
    ("maximum-flux", (0, 0, 0), "Φ_max", "", "maximum-{}"),
    ("far-field-irradiance", (0, 1, 0), "E_ff", "", "far-field-{}"),
    ("mean-irradiance", (0, 1, 0), "E_mean", "", "mean-{}"),
    ("minimum-irradiance", (0, 1, 0), "E_min", "", "minimum-{}"),
    ("maximum-irradiance", (0, 1, 0), "E_max", "", "maximum-{}"),
    ("peak-irradiance", (0, 1, 0), "E_0", "The irradiance on the axis, where it is greatest",
     "peak-{}"),
    ("limit", (0, 1, 0), "E_lim",
     "A limit of the irradiance, from the standard (with {hazard-distance})", "{}-limit"),
    ("installed-irradiance", (0, 1, 0), "E_i", "", "installed-{}"),
    ("zenith-radiance", (0, 1, 1), "L_z", "The radiance of the sky's zenith", "zenith-{}"),
    ("horizontal-irradiance", (0, 1, 0), "E_h",
     "The irradiance of the ground by the sky, without the sun", "horizontal-{}"),
    ("global-irradiance", (0, 1, 0), "E_g", "The irradiance of the ground by sky and sun",
     "global-{}"),
    ("sun-irradiance", (0, 1, 0), "E_s", "The irradiance by the sun, perpendicular to its rays",
     "sun-{}"),
    ("sun-radiance", (0, 1, 1), "L_s", "The radiance of the sun's disc", "sun-{}"),
    ("radiance-toward", (0, 1, 1), "L_w", "The radiance in a direction (with {toward})",
     "{}-toward"),
    ("diffuse-irradiance", (0, 1, 0), "E_d", "", "diffuse-{}"),
    ("direct-irradiance", (0, 1, 0), "E_b", "", "direct-{}"),
    ("mean-radiance", (0, 1, 1), "L_mean", "", "mean-{}"),
    ("minimum-radiance", (0, 1, 1), "L_min", "", "minimum-{}"),
    ("peak-radiance", (0, 1, 1), "L_max", "", "peak-{}"),
)  # fmt: skip
# geometry -> the unit to show of each kind, and the coherent one of a derivation
LIGHT_UNITS = {
    (0, 0, 0): (("W", "lm", "umol/s"), ("W", "lm", "photon/s")),
    (0, 0, 1): (("W/sr", "cd", "umol/s/sr"), ("W/sr", "cd", "photon/s/sr")),
    (0, 1, 0): (("W/m2", "lx", "umol/m2/s"), ("W/m2", "lx", "photon/m2/s")),
    (0, 1, 1): (("W/m2/sr", "cd/m2", "umol/m2/s/sr"), ("W/m2/sr", "cd/m2", "photon/m2/s/sr")),
    (1, 1, 0): (("J/m2", "lx s", "umol/m2"), ("J/m2", "lx s", "photon/m2")),
    (1, 0, 0): (("J", "lm s", "umol"), ("J", "lm s", "photon")),
}


def light_unit(name: str, kind: str, coherent: bool = False) -> str:
    """Return the unit to show of a light quantity by its generic name, or its coherent one."""
    geometry = _LIGHT_ROWS[name][1]
    text = LIGHT_UNITS[geometry][coherent][KINDS.index(kind)]
    return "lm/m2" if text == "lx" and name == "exitance" else text


def _of_light(
    name: str, generic: str, kind: str, row: tuple[str, tuple[int, int, int], str, str, str]
) -> Symbol:
    """A light quantity, by its generic name (no kind) or by that of one kind."""
    _, geometry, letter, help_, _ = row
    unit = light_unit(generic, kind or LUMINOUS)
    label = name.replace("-", " ")
    if kind and help_:
        help_ = f"{help_}, as {label}"
    return Symbol(
        name,
        letter if "_" in letter or not kind else f"{letter}_{kind}",
        tuple(light_dimension(k, geometry, "") for k in ((kind,) if kind else KINDS)),
        _EXAMPLES.get(name, f"100{unit}".replace(" ", ".")),
        f"{help_}." if help_ else "",
        POSITIVE,
        label,
        unit,
        article(label),
        geometry=geometry,
        kind=kind,
        generic=generic,
    )


_EXAMPLES = {"luminance": "1000cd/m2", "illuminance": "10klx"}


def specific_name(generic: str, kind: str) -> str:
    """Return the name of a light quantity in one kind: flux and luminous give luminous-flux."""
    _, geometry, _, _, pattern = _LIGHT_ROWS[generic]
    if not pattern:
        return generic if kind == RADIANT else f"{KIND_NAMES[kind]}-{generic}"
    names = EXITANCES if generic == "exitance" else GEOMETRIES[geometry][0]
    return pattern.format(names[KINDS.index(kind)].replace(" ", "-"))


_LIGHT_ROWS = {row[0]: row for row in _LIGHT}
SYMBOLS: dict[str, Symbol] = {symbol.name: symbol for symbol in (*_ROWS, *_INNER)}
# The intensity that a 1 of a distribution stands for.
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
METER_UNITS = {"k": "cd.s/m2", "c": "lx.s"}  # of the constants of light meters, written bare
LINKS = ("wavelength", "spectrum", "efficacy")  # what links the kinds of light
EFFICACIES = (  # the ratios of two kinds: name, the kind over, the kind under
    ("luminous-efficacy", LUMINOUS, RADIANT),
    ("photon-efficacy", PHOTON, RADIANT),
    ("lux-per-ppfd", LUMINOUS, PHOTON),
)
REFINEMENTS = ("observer", "range", "photon-range")  # what only refines a link


def names_of_kinds(generic: str) -> tuple[str, ...]:
    """Return the names of one kind that go with a generic name."""
    return tuple(name for name, (generic_name, _) in SPECIFIC.items() if generic_name == generic)
