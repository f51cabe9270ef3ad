"""What the calculators can be given, and how each of it is read.

An input is an option of a calculator's command (`--radius 2m`); a value of it is read by
`conditions.read`, as a condition of a conversion is.
"""

import math
from typing import Any

from radcalc.answer import Value
from radcalc.conversion.conditions import (
    ANGLE,
    ENERGY,
    LENGTH,
    TEMPERATURE,
    Given,
    Option,
    positive,
    read,
    require,
)
from radcalc.errors import ConditionError, NumberError, UsageError, quote
from radcalc.maths import any_true
from radcalc.quantities.light import (
    AREA,
    DURATION,
    LUMINOUS,
    SOLID_ANGLE,
    light_dimension,
    powers,
    times,
)
from radcalc.units.grammar import parse_number
from radcalc.units.table import NUMBER, Dimension

LUMINANCE = light_dimension(LUMINOUS, (0, 1, 1), "")
ILLUMINANCE = light_dimension(LUMINOUS, (0, 1, 0), "")
SPECIFIC_HEAT = powers(length=2, time=-2, temperature=-1)


def _option(
    name: str, dimension: Dimension, takes: str, example: str, help_: str
) -> tuple[str, Option]:
    return name, Option(name, "", (dimension,), takes, example, help_)


def _length(name: str, example: str, help_: str) -> tuple[str, Option]:
    return _option(name, LENGTH, "a length", example, help_)


def _angle(name: str, example: str, help_: str) -> tuple[str, Option]:
    return _option(name, ANGLE, "an angle", example, help_)


INPUTS = dict(
    (
        _length("radius", "10cm", "Radius of the source."),
        _length("diameter", "20cm", "Diameter of the source."),
        _length("width", "2m", "Width of the source, along x."),
        _length("length", "1m", "Length of the source, along y."),
        _option("area", AREA, "an area", "1cm2", "Area of the source."),
        _length("distance", "2m", "Straight line to the centre of what is seen."),
        _length("height", "50cm", "Height above the source's plane, along its axis."),
        _length("offset", "20cm", "How far aside of the source's axis, along x (with --height)."),
        _length("offset-y", "20cm", "How far aside of it along y (with --height)."),
        _angle("tilt", "60deg", "Angle by which the source is turned from the line of sight."),
        _angle("incidence", "30deg", "Angle between the light and the receiver's normal."),
        _angle("half-angle", "30deg", "Half angle of a cone, from its axis to its edge."),
        _angle("apex-angle", "60deg", "Full angle of a cone, from edge to edge."),
        _option("solid-angle", SOLID_ANGLE, "a solid angle", "1sr", "Solid angle."),
        _option(
            "projected-solid-angle",
            SOLID_ANGLE,
            "a solid angle",
            "1sr",
            "Solid angle projected along the cone's axis.",
        ),
        _option("configuration-factor", NUMBER, "a number", "0.1", "Configuration factor."),
        _angle("horizontal", "60deg", "Full angle between the pyramid's left and right face."),
        _angle("vertical", "40deg", "Full angle between its upper and lower face."),
        _angle("polar", "45deg", "Polar angle, from +z."),
        _angle("azimuth", "30deg", "Azimuth, from +x towards +y."),
        _angle("elevation", "45deg", "Elevation above the plane of x and y."),
        _option("receiver-area", AREA, "an area", "4cm2", "Area of the receiver."),
        _length("receiver-radius", "1m", "Radius of the receiver."),
        _length("receiver-diameter", "2m", "Diameter of the receiver."),
        _option("accuracy", NUMBER, "a number", "1e-9", "Relative, at which to stop (1e-9)."),
        _option("na", NUMBER, "a number", "0.22", "Numerical aperture, in air."),
        _option("f-number", NUMBER, "a number", "2.4", "The lens's f-number."),
        _option("time", DURATION, "a time", "1h", "How long the light is constant."),
        _option("reflectance", NUMBER, "a number from 0 to 1", "0.8", "Of the reflector, 0 to 1."),
        _option("ev", NUMBER, "a number", "12", "Exposure value, of f-number and time."),
        _option("ev100", NUMBER, "a number", "15", "Exposure value at ISO 100, of the light."),
        _option("iso", NUMBER, "a number", "100", "Speed of the film or sensor (100)."),
        _option(
            "k",
            times(LUMINANCE, DURATION),
            "a luminance times a time",
            "12.5cd.s/m2",
            "The meter's constant for reflected light (12.5 cd s/m2).",
        ),
        _option(
            "c",
            times(ILLUMINANCE, DURATION),
            "an illuminance times a time",
            "250lx.s",
            "The meter's constant for incident light (250 lx s).",
        ),
        _option("luminance", LUMINANCE, "a luminance", "1000cd/m2", "Luminance of the scene."),
        _option("illuminance", ILLUMINANCE, "an illuminance", "10klx", "Illuminance on the scene."),
        _option(
            "saturation-luminance",
            LUMINANCE,
            "a luminance",
            "4000cd/m2",
            "Luminance at which the sensor saturates.",
        ),
        _option("mass", powers(mass=1), "a mass", "10g", "Mass of the body that is heated."),
        _option(
            "specific-heat",
            SPECIFIC_HEAT,
            "a specific heat capacity",
            "385J/kg/K",
            "Its specific heat capacity.",
        ),
        _option(
            "temperature-rise",
            TEMPERATURE,
            "a temperature difference",
            "2K",
            "How much warmer it gets.",
        ),
        _option("heat", ENERGY, "a heat", "10J", "Heat that the body takes up."),
        _option(
            "absorptance",
            NUMBER,
            "a number from 0 to 1",
            "0.95",
            "The part of the light that it absorbs (1).",
        ),
        _option("exponent", NUMBER, "a number", "3", "Exponent of a cosine-power lobe."),
        _angle("beam-angle", "30deg", "Full angle of a lobe, where half the peak is left."),
        _angle("field-angle", "60deg", "Full angle of a lobe, where a tenth of it is left."),
        _angle("within", "45deg", "Half angle within which the flux is wanted."),
        _angle("off-axis", "20deg", "Angle between the source's axis and the light."),
    )
)
SYMBOLS = {
    "radius": "R",
    "diameter": "D",
    "width": "w",
    "length": "l",
    "area": "A",
    "distance": "d",
    "height": "h",
    "offset": "x",
    "offset-y": "y",
    "tilt": "θ_s",
    "incidence": "θ",
    "half-angle": "α",
    "apex-angle": "2α",
    "solid-angle": "Ω",
    "projected-solid-angle": "Ω_p",
    "configuration-factor": "F",
    "horizontal": "a",
    "vertical": "b",
    "polar": "θ",
    "azimuth": "φ",
    "elevation": "h",
    "receiver-area": "A_r",
    "receiver-radius": "R_r",
    "receiver-diameter": "D_r",
    "na": "NA",
    "f-number": "N",
    "time": "t",
    "reflectance": "ρ",
    "ev": "EV",
    "ev100": "EV100",
    "iso": "S",
    "k": "K",
    "c": "C",
    "luminance": "L_v",
    "illuminance": "E_v",
    "saturation-luminance": "L_sat",
    "mass": "m",
    "specific-heat": "c",
    "temperature-rise": "ΔT",
    "absorptance": "α",
    "heat": "Q_h",
    "exponent": "n",
    "beam-angle": "FWHM",
    "field-angle": "FWTM",
    "within": "β",
    "off-axis": "γ",
}

# The coherent unit of each, as a derivation shows it.
_COHERENT = {
    LENGTH: "m",
    ANGLE: "rad",
    AREA: "m2",
    SOLID_ANGLE: "sr",
    DURATION: "s",
    NUMBER: "1",
    LUMINANCE: "cd/m2",
    ILLUMINANCE: "lx",
    times(LUMINANCE, DURATION): "cd s/m2",
    times(ILLUMINANCE, DURATION): "lx s",
    powers(mass=1): "kg",
    TEMPERATURE: "K",
    ENERGY: "J",
    SPECIFIC_HEAT: "J/kg/K",
}
COHERENT = {name: _COHERENT[option.dimensions[0]] for name, option in INPUTS.items()}
COHERENT |= {"lateral": "m", "apparent-area": "m2"}
LABELS = {
    "na": "numerical aperture",
    "f-number": "f-number",
    "offset-y": "offset along y",
    "within": "half angle of the part",
    "off-axis": "angle off the axis",
    "ev": "exposure value",
    "ev100": "exposure value at ISO 100",
    "iso": "ISO speed",
    "k": "meter constant K",
    "c": "meter constant C",
}

Inputs = dict[str, Given]


def take(name: str, text: str) -> Given:
    """Read one input."""
    return read(INPUTS[name], text)


def known(given: Given) -> Value:
    """An input as a row of the answer, in the unit it was given in."""
    return value(given.option.name, given.value, unit_of(given), given.number)


def value(name: str, si: Any, unit: str, given: Any = None) -> Value:
    """A result that is also an input."""
    label = LABELS.get(name, name.replace("-", " "))
    dimensions = INPUTS[name].dimensions
    return Value(name, label, SYMBOLS[name], si, dimensions, (unit,), given=given)


def unit_of(given: Given) -> str:
    """The unit as it was typed; 1 where there is none."""
    return given.unit.text if given.unit else "1"


def one_of(inputs: Inputs, what: str, *names: str, hint: str = "") -> Given:
    """The one of several inputs that was given."""
    found = [inputs[name] for name in names if name in inputs]
    hint = hint or " or ".join(f"--{name} {INPUTS[name].example}" for name in names)
    if not found:
        raise UsageError(f"{what} is missing", hint)
    if len(found) > 1:
        flags = " and ".join(given.flag for given in found)
        raise ConditionError(f"{flags} contradict each other: both give {what}", "one of them")
    return found[0]


def only(inputs: Inputs, names: tuple[str, ...], what: str) -> None:
    """Refuse inputs that have no use."""
    refuse_unused([given.flag for name, given in inputs.items() if name not in names], what)


def refuse_unused(unused: list[str], what: str) -> None:
    """Refuse options that have no use."""
    if unused:
        raise ConditionError(
            f"{' and '.join(unused)} {'has' if len(unused) == 1 else 'have'} no use with {what}",
            f"the same without {' and '.join(unused)}",
        )


def radius(inputs: Inputs, prefix: str = "", what: str = "the size of the source") -> Any:
    """A radius, from the radius or the diameter."""
    size = one_of(inputs, what, f"{prefix}radius", f"{prefix}diameter")
    return positive(size) / (2 if size.option.name.endswith("diameter") else 1)


def half_angle(given: Given, most: int = 180) -> Any:
    """A half angle, from the half angle or the apex angle, of at most so many degrees."""
    angle = positive(given) / (2 if given.option.name == "apex-angle" else 1)
    top = 2 * most if given.option.name == "apex-angle" else most
    good = not any_true(angle > math.radians(most) * (1 + 1e-12))
    require(given, good, f"at most {top} deg")
    return angle


def tilt(inputs: Inputs, name: str = "tilt") -> Any:
    """An angle from a normal, from 0 to 180 degrees; 0 where none is given."""
    if name not in inputs:
        return 0.0
    given = inputs[name]
    angle = abs(given.value)
    require(given, not any_true(angle > math.pi * (1 + 1e-12)), "from 0 to 180 deg")
    return angle


def read_interval(name: str, text: str) -> tuple[float, float]:
    """Read A:B, two angles [rad]."""
    parts = text.split(":")
    if len(parts) != 2:
        raise ConditionError(
            f"--{name} {quote(text)} is not an interval", f"--{name} 30deg:60deg, from A to B"
        )
    low, high = (take(name, part).value for part in parts)
    if low == high:
        raise ConditionError(f"--{name} {quote(text)} has no width", f"--{name} 30deg:60deg")
    if low > high:
        hint = f"--{name} {parts[1]}:{parts[0]}"
        if name == "azimuth":  # across +x
            hint = f"--{name} {parts[0]}:{math.degrees(high) + 360:.12g}deg"
        raise ConditionError(f"--{name} {quote(text)} ends before it starts", hint)
    return low, high


def read_point(text: str, what: str) -> tuple[float, float, float]:
    """Read X,Y,Z, three bare numbers in any one unit."""
    parts = text.split(",")
    hint = "X,Y,Z, in one unit that is not written: 1,0,0.5"
    if len(parts) != 3:
        count = f"{len(parts)} coordinate{'s' if len(parts) > 1 else ''}"
        raise ConditionError(f"{what} '{quote(text)}' has {count}, not three", hint)
    try:
        x, y, z = (parse_number(part) for part in parts)
    except NumberError as error:
        raise NumberError(f"{what} '{quote(text)}': {error.message}", hint) from None
    if max(abs(x), abs(y), abs(z)) > 1e100:
        raise NumberError(f"{what} '{quote(text)}' is too far away", "coordinates up to 1e100")
    return x, y, z
