"""The calculators in the order of the help, each with its line there.

Each of them has a page, `PAGE` of the module of the same name, which is imported when it is asked
for.
"""

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from radcalc.calculators.page import Page

SUMMARIES = {
    "convert": "Convert units, and quantities under a condition.",
    "solid-angle": "Solid angles of shapes, plain and projected.",
    "direction": "Spherical coordinates and unit vectors.",
    "etendue": "Etendues, and the flux of a radiance.",
    "point-source": "Sources that are small beside their distance.",
    "environment": "What surrounds a place: maps, skies, expressions.",
    "scene": "Many sources, summed at points or over a grid.",
    "lambertian": "Diffuse sources and reflectors.",
    "sky": "The light of the sky, and of the sun beside it.",
    "uberlight": "The cinematographer's light of computer graphics.",
    "ev": "Exposure values and the light meter.",
    "calorimeter": "Radiant flux from the heat it leaves.",
    "screen": "The picture on a projection screen.",
    "dose": "What samples of light in time add up to.",
    "sensor": "Sensors: light, photons, electrons and current.",
    "laser": "Laser beams: the spot and the hazard distance.",
    "refraction": "Surfaces between media: angles and reflectances.",
    "room": "The luminaires that light a room.",
    "integrate": "Integrals over directions.",
    "photon": "Wavelength, frequency and energy of a photon.",
    "spectrum": "Peak, efficacies and colour of a spectrum.",
    "mesopic": "Mesopic luminance by CIE 191:2010.",
}


def page_of(name: str) -> "Page":
    """Import the page of a calculator."""
    from importlib import import_module

    page: Page = import_module(f"radcalc.calculators.{name.replace('-', '_')}").PAGE
    return page
