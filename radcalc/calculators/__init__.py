"""Calculators, one module each: inputs, laws and assumptions.

This module has the calculators in the order of proposals, each with its summary.  The page of a
calculator is `PAGE` in the module of the same name, imported on demand.
"""

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from radcalc.calculators.page import Page


SUMMARIES = {
    "convert": "Convert between units, and between quantities that a condition links.",
    "solid-angle": "Solid angle and projected solid angle of a shape.",
    "direction": "Spherical coordinates and unit vectors.",
    "etendue": "Etendue of a beam, and its flux from a radiance.",
    "point-source": "Small sources, luminaires (.ies, .ldt): flux, lux, distance.",
    "environment": "Light from all around: maps (.hdr, .exr), skies, expressions.",
    "scene": "Light of many sources together, at points or on a grid.",
    "lambertian": "Diffuse sources and reflectors.",
    "sky": "The light of the sky and the sun.",
    "uberlight": "Uberlight, a light model of computer graphics.",
    "ev": "Exposure values and the light meter.",
    "calorimeter": "Radiant flux from the heat that it produces.",
    "screen": "The picture on a projection screen.",
    "dose": "Exposure or energy from the log of a meter (CSV, also PAR).",
    "sensor": "Sensors: light, photons, electrons and current.",
    "laser": "Laser beams: the spot and the hazard distance.",
    "refraction": "Surfaces between two media: angles and reflectances.",
    "room": "The number of luminaires for a room (lumen method).",
    "integrate": "Integrals over directions.",
    "photon": "Wavelength, frequency and energy of a photon.",
    "spectrum": "Peak, efficacies and colour of a spectrum.",
    "mesopic": "Mesopic luminance by CIE 191:2010.",
}

COMMANDS = {
    **SUMMARIES,
    "mark": "Marks and points for the answers of students to a sheet.",
    "columns": "Columns of a table (CSV): units, extremes, means.",
    "units": "Units, their definitions and sources.",
    "quantities": "Names of quantities in three languages.",
    "typical": "Typical values: sun, sky, rooms, lamps, screens.",
    "examples": "Tasks with their commands, answers and explanations.",
    "manual": "Pages of the manual.",
    "help": "Help for a command, or a search for words.",
    "prompt": "Interactive prompt, with ans and variables.",
}
# Words for the subjects of commands, if unlike the command's name.
SUBJECTS = {
    "ev": "camera aperture f-number iso shutter exposure meter lightmeter photography lens",
    "point-source": "point lamp led bulb spot spotlight beam inverse-square cosine candela",
    "scene": "room lights luminaires layout isolux uniformity",
    "mark": "grade grades marking homework students exam sheet",
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


def page_of(name: str) -> "Page":
    """Import the page of a command."""
    from importlib import import_module

    if name not in SUMMARIES:
        from radcalc.calculators.lists import PAGES

        return PAGES[name]
    page: Page = import_module(f"radcalc.calculators.{name.replace('-', '_')}").PAGE
    return page
