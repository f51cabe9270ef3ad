"""The page of conversions; `conversion` has the calculations."""

from radcalc.calculators.page import CHECKS, CONVERSION, OF_LINES, Operand, Page
from radcalc.quantities.symbols import LINKS, METER_UNITS, REFINEMENTS

PAGE = Page(
    about="Convert between units, and between quantities that a condition links.",
    operand=Operand("words", "VALUE UNIT [to] TARGET", CONVERSION),
    sections={
        "Light": (*LINKS, *REFINEMENTS),
        "Directions": (
            "solid-angle",
            "half-angle",
            "apex-angle",
            "isotropic",
            "hemisphere",
            "exponent",
            "beam-angle",
        ),
        "Distance and surfaces": (
            "distance",
            "incidence",
            "tilt",
            "area",
            "radius",
            "diameter",
            "reflectance",
            "pupil",
        ),
        "Detectors, fields and heat": ("responsivity", "response", "electric-field", "emissivity"),
        "Light meters (EV)": ("k", "c"),
        "Time and bandwidth": ("time", "photoperiod", "bandwidth"),
        "Homework": CHECKS,
        "Streams (with - as VALUE)": OF_LINES,
    },
    calculates=False,
    texts={
        "radius": "Radius of a circular area.",
        "diameter": "Diameter of a circular area.",
        "area": "Light uniform over this area.",
        "distance": "Straight line from a small source to the receiver.",
        "tilt": "Angle between the normal of a luminous surface and the direction of its light.",
        "incidence": "Angle between the light and the normal of the illuminated surface.",
        "half-angle": "Light uniform over a cone with this half angle, from axis to edge.",
        "apex-angle": "Light uniform over a cone with this full angle, from edge to edge.",
        "solid-angle": "Light uniform over this solid angle.",
        "exponent": "Lobe with this power of the cosine (1: Lambertian).",
        "beam-angle": "Cosine-power lobe with this full angle at half of the peak intensity.",
        "reflectance": "Lambertian reflector with this reflectance, 0 to 1 or in %.",
        "time": "Light constant over this time.",
    },
    bare=METER_UNITS,
    mistakes=("beam",),
)
