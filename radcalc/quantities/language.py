"""The user's language, labels in it, and other words for symbols and options."""

import os
from collections.abc import Sequence

ENGLISH = "en"
LANGUAGES = (ENGLISH, "cs", "ru")


def language() -> str:
    """Return the language of the locale's messages; English if it is not in `LANGUAGES`."""
    for variable in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if locale := os.environ.get(variable):
            spoken = locale.replace(".", "_").replace("@", "_").partition("_")[0]
            return spoken if spoken in LANGUAGES else ENGLISH
    return ENGLISH


def translate(label: str, language: str) -> str:
    """Return a quantity's English name in a language; unchanged if there is no translation.

    The text in brackets is translated separately; so is the quantity in labels of a mean or a part.
    """
    if language == ENGLISH:
        return label
    stem, bracket, rest = label.partition(" (")
    if bracket:
        return f"{translate(stem, language)} ({translate(rest.removesuffix(')'), language)})"
    from radcalc.quantities.names import LABELS, PARTS, QUANTITIES

    place = LANGUAGES.index(language) - 1
    if label in LABELS:
        return LABELS[label][place]
    for part, names in PARTS.items():
        whole = f" {label} ".replace(f" {part} ", " ").strip()
        if whole != label and (name := translate(whole, language)) != whole:
            return names[place].format(name)
    return next((q.name(language) for q in QUANTITIES if q.name(ENGLISH) == label), label)


# Symbols, and names of options, with other words for them.
SYNONYMS = {
    "photon-energy": "energy-of-a-photon energy-of-one-photon",
    "distance": "dist range separation throw",
    "f-number": "aperture f-stop fstop stop",
    "limit": "mpe el",
    "time": "shutter shutter-speed exposure-time duration hours photoperiod daylength",
    "iso": "asa sensitivity film-speed",
    "luminous-flux": "lumen lumens",
    "radiant-flux": "watt watts power",
    "illuminance": "lux illumination footcandles",
    "luminous-intensity": "candela candelas candlepower",
    "luminance": "nit nits brightness",
    "half-angle": "angle beam cone cap theta",
    "polar": "theta zenith-angle",
    "azimuth": "phi",
    "apex-angle": "angle cone",
    "beam-angle": "angle beam spread",
    "off-axis-angle": "field-angle off-axis angle",
    "reflectance": "albedo reflectivity",
    "wavelength": "lambda",
    "spectrum": "illuminant lamp spd source",
    "distribution": "ies ldt file luminaire photometry",
    "precision": "digits decimals",
    "format": "output",
    "steps": "derivation explain verbose",
    "quiet": "silent",
    "utilance": "uf cu utilisation utilization utilisation-factor utilization-factor",
    "maintenance": "mf llf maintenance-factor light-loss-factor",
    "luminaires": "fixtures lamps count",
    "quantum-efficiency": "qe",
    "current": "photocurrent",
    "peak-intensity": "max-candela peak-candela maximum-candela maximum-intensity max-intensity",
    "transmittance": "transmission",
    "peak-irradiance": "peak-intensity",
    "na": "numerical-aperture",
    "sp-ratio": "sp s/p",
    "incidence": "aoi incidence-angle angle-of-incidence",
    "sun-elevation": "elevation altitude sun-altitude solar-altitude solar-elevation",
    "sun-azimuth": "solar-azimuth",
    "tilt": "inclination slope",
    "temperature-rise": "temperature dt delta-t",
    "specific-heat": "heat-capacity",
    "receiver-area": "detector-area sensor-area target-area",
    "receiver-diameter": "detector-diameter pupil-diameter",
    "pixel-pitch": "pixel pixel-size pitch",
    "height": "mounting-height",
    "fwhm": "linewidth bandwidth line-width band-width spectral-width",
    "divergence": "full-divergence spread",
    "beam-diameter": "pool spot-size",
    "rf": "tm-30 tm30 fidelity",
    "rg": "tm-30 tm30 gamut",
}


def names_meant(typed: str, known: Sequence[str]) -> list[str]:
    """Return the known names that begin with a word, or else those that it is a synonym of."""
    if begun := [name for name in known if typed and name.startswith(typed)]:
        return begun
    word = typed.lower()
    return [name for name, words in SYNONYMS.items() if word in words.split() and name in known]
