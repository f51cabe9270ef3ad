"""Radiometry, photometry, photons and their geometry: a calculator and unit converter.

Values are texts with units, quantities, and lists or arrays of either.  What
is missing, contradictory or impossible is refused, with the call that answers.

>>> import radcalc
>>> print(radcalc.convert("100 lx", "fc"))
9.290304 footcandle
>>> lamp = radcalc.point_source(flux="800 lm", distance="2 m")
>>> print(lamp.illuminance.round(2), "-", lamp.assumptions[0])
15.92 lux - isotropic: the same intensity in all directions

A result has its quantities as attributes, and `assumptions`, `notes`, `steps`,
`to_dict` and `plot`.  Every error is a `RadcalcError` with a `message` and a
`hint`.  The functions and classes are loaded when they are first used.

Functions
---------
convert        Convert a quantity to another unit, or to another quantity
               under conditions.
ask            Answer a sentence, such as ``"20000 cd at 8 m to lx"``.
check          Check an answer against a result, and name the mistakes that
               lead to it.
define         Read the units, constants, reflectances and spectra of a file
               of definitions.
examples       List tasks with the commands that answer them, and how to
               read the answers.
explain        Convert like `convert`, and return the assumptions, notes and
               derivation with the value.
factor         Return the number that multiplies values in one unit to
               convert them to another.
irradiance_map Compute the irradiances of receivers facing every direction,
               as a latlong map.
typical        List typical values: sun, sky, rooms, lamps, screens, plants,
               with sources.

solid_angle    Calculate the solid angle of a shape, and its projected solid
               angle.
direction      Express a direction, or its reflection, in spherical
               coordinates and as a unit vector.
etendue        Calculate the etendue of a beam, and its flux from the
               radiance of the source.
point_source   Calculate the intensity, illuminance, distance or beam of a
               small source of light.
environment    Calculate the light that a receiver gets from a radiance map,
               a sky or an expression.
scene          Add up the light of many sources at points, and compute its
               uniformity.
lambertian     Calculate the luminance, illuminance or size of a diffuse
               source or reflector.
sky            Calculate the radiance of the sky in a direction, and its
               irradiance on the ground and on a plane.
uberlight      Calculate the light that a cinematographer's light
               ("uberlight") sends to points.
ev             Calculate exposure values, and the luminance and illuminance
               that they correspond to.
calorimeter    Calculate the radiant flux that heats a body, or the
               temperature rise from a flux.
screen         Calculate the luminance and the illuminance of the picture on
               a projection screen.
dose           Add up samples of light over time: exposure, energy, daily
               light integral.
sensor         Calculate the light that a lens sends to a sensor, its
               photons, electrons and current.
laser          Calculate the spot and the irradiance of a laser beam, and
               its hazard distance.
refraction     Calculate angles, reflectances and transmittances at a
               surface between two media.
room           Calculate the number of luminaires for a room, or the
               illuminance that they give.
integrate      Integrate a function of direction over a part of the sphere.
photon         Calculate wavelength, frequency, wavenumber, energy and
               luminous efficacy of a photon.
spectrum       Compute the peak, width, efficacies, photons and colour of a
               spectrum.
mesopic        Calculate the mesopic luminance by CIE 191:2010, between
               scotopic and photopic vision.
"""

__all__ = [
    "ConditionError",
    "ConversionError",
    "NumberError",
    "Quantity",
    "RadcalcError",
    "Result",
    "UnitError",
    "UsageError",
    "Verdict",
    "__version__",
    "ask",
    "calorimeter",
    "check",
    "convert",
    "define",
    "direction",
    "dose",
    "environment",
    "etendue",
    "ev",
    "examples",
    "explain",
    "factor",
    "integrate",
    "irradiance_map",
    "lambertian",
    "laser",
    "mesopic",
    "photon",
    "point_source",
    "refraction",
    "room",
    "scene",
    "screen",
    "sensor",
    "sky",
    "solid_angle",
    "spectrum",
    "typical",
    "uberlight",
]


def __getattr__(name: str) -> object:
    if name == "__version__":
        from radcalc import _version

        return _version.__version__
    if name not in __all__:
        raise AttributeError(f"module 'radcalc' has no attribute '{name}'")
    from radcalc.api import public

    return public(name)


def __dir__() -> "list[str]":
    return __all__
