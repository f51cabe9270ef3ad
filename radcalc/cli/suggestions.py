"""Suggestions for a word that is not a command."""

from radcalc.cli.help import COMMANDS
from radcalc.errors import command as call_of
from radcalc.errors import manual as help_of
from radcalc.errors import nearest, quote

# Words for the subjects of commands, if unlike the command's name.
MEANT = {
    "ev": "camera aperture f-number iso shutter exposure meter lightmeter photography lens",
    "point-source": "point lamp led bulb spot spotlight beam inverse-square cosine candela",
    "scene": "room lights luminaires layout isolux uniformity",
    "lambertian": "diffuse diffuser reflector panel wall surface luminaire reflectance",
    "spectrum": "blackbody illuminant cct cri colour color spectra daylight",
    "photon": "wavelength frequency wavenumber laser",
    "mesopic": "scotopic photopic purkinje",
    "direction": "vector angle angles spherical azimuth elevation",
    "integrate": "integral",
    "calorimeter": "heat thermometer",
    "units": "unit",
    "screen": "projector cinema",
    "solid-angle": "steradian steradians omega",
    "uberlight": "cinematography renderman barzel superellipse barndoor falloff",
}


def meant(args: list[str]) -> str:
    """Return the hint for a word that is not a command."""
    word = args[0].lower()
    if near := nearest(word, COMMANDS, 1, 0.75):
        return f"{near[0]} (see radcalc --help)"
    from radcalc.calculators.solid_angle import NAMES

    if word in NAMES:
        return f"{call_of('solid-angle', word)} (see {help_of('solid-angle')})"
    names = [name for name, synonyms in MEANT.items() if word in synonyms.split()]
    if names:
        return f"{names[0]} (see {help_of(names[0])})"
    return _looked_up(args[0]) or _looked_up(" ".join(args)) or "radcalc --help"


def _looked_up(word: str) -> str:
    """Return the call that explains a unit, a quantity or a spectrum; '' for other words."""
    from radcalc.quantities.targets import is_name
    from radcalc.spectra.sources import find_named
    from radcalc.units.scales import find
    from radcalc.units.table import unit_of

    if unit_of(word) or find(word):
        return call_of("units", quote(word))
    if is_name(word):
        return call_of("quantities", quote(word))
    return call_of("spectrum", quote(word)) if find_named(word) else ""
