"""The page of conversions; `conversion` has the calculations."""

from radcalc.calculators.page import CONVERSION, Operand, Page
from radcalc.quantities.symbols import LINKS, METER_UNITS, REFINEMENTS

PAGE = Page(
    about="Convert between units, and between quantities under a condition.",
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
        "Detectors and fields": ("responsivity", "electric-field"),
        "Light meters (EV)": ("k", "c"),
        "Time and bandwidth": ("time", "bandwidth"),
    },
    texts={
        "radius": "Radius of a circular area.",
        "diameter": "Diameter of a circular area.",
        "area": "Uniform over that area.",
        "distance": "Straight line from a small source to the receiver.",
        "tilt": "Angle between the normal of a luminous surface and the direction of its light.",
        "incidence": "Angle between the light and the normal of the illuminated surface.",
        "half-angle": "Uniform over a cone of that half angle, from axis to edge.",
        "apex-angle": "Uniform over a cone of that full angle, from edge to edge.",
        "solid-angle": "Uniform over that solid angle.",
        "exponent": "A lobe that falls off as a power of the cosine; 1 is Lambertian.",
        "beam-angle": "A cosine-power lobe of that full angle at half the peak intensity.",
        "reflectance": "A Lambertian reflector, 0 to 1 or in %.",
        "time": "Constant over that time.",
    },
    bare=METER_UNITS,
    mistakes=("beam",),
)
