"""A direction, in spherical coordinates and as a unit vector."""

import math
from typing import Any

from radcalc.answer import Answer, Value
from radcalc.calculators.results import known, value
from radcalc.calculators.worksheet import refuse_foreign
from radcalc.derivation import Formula, format_angle, format_number
from radcalc.geometry.directions import cartesian, spherical
from radcalc.given import Inputs, one_of
from radcalc.units.dimensions import LENGTH
from radcalc.units.table import NUMBER

CONVENTION = "polar angle from +z, azimuth from +x towards +y (ISO 80000-2)"
POLAR = Formula("polar angle", "theta = atan2(sqrt(x^2 + y^2), z)")
AZIMUTH = Formula("azimuth", "phi = atan2(y, x)")
UNIT_VECTOR = Formula(
    "unit vector", "x = sin(theta) cos(phi), y = sin(theta) sin(phi), z = cos(theta)"
)
POLE = "at a pole every azimuth is right"
LEAST = 2**-53  # of a unit vector's coordinate: below it is what the angle's rounding makes of 0


def of_vector(x: float, y: float, z: float, unit: str = "") -> Answer:
    """The direction of a vector; its coordinates in SI units where they had a unit."""
    polar, azimuth, length = spherical(x, y, z)
    unit_vector = (x / length, y / length, z / length)
    notes = []
    if not (x or y):
        notes = [f"{POLE}, and 0 is given"]
    aside, far = format_number(math.hypot(x, y)), format_number(z)
    steps = [
        POLAR.told(f"theta = atan2({aside}, {far}) = {format_angle(polar)}"),
        AZIMUTH.told(
            f"phi = atan2({format_number(y)}, {format_number(x)}) = {format_angle(azimuth)}"
        ),
    ]
    rows = [*_rows(polar, azimuth, unit_vector, {}), _length(length, unit)]
    assumed = [CONVENTION, "x, y and z are those of the unit vector"]
    return Answer(rows, assumed, notes, steps)


def of_angles(given: Inputs) -> Answer:
    """The unit vector of a polar angle or an elevation, and an azimuth."""
    refuse_foreign(given, ("polar", "elevation", "azimuth"), "a direction")
    one = one_of(given, "the polar angle or the elevation", "polar", "elevation")
    azimuth = one_of(given, "the azimuth", "azimuth").value
    polar = one.value if one.name == "polar" else math.pi / 2 - one.value
    x, y, z = cartesian(polar, azimuth)
    if one.name == "elevation":
        z = math.sin(one.value)  # without the rounding of a right angle
        x, y = math.cos(one.value) * math.cos(azimuth), math.cos(one.value) * math.sin(azimuth)
    x, y, z = (0.0 if abs(size) < LEAST else size for size in (x, y, z))
    numbers = f"theta = {format_angle(polar)}, phi = {format_angle(azimuth)}; "
    numbers += f"x = {format_number(x)}, y = {format_number(y)}, z = {format_number(z)}"
    rows = [*_rows(polar, azimuth, (x, y, z), given), _length(1.0)]
    notes = [POLE] if not (x or y) else []
    return Answer(rows, [CONVENTION], notes, [UNIT_VECTOR.told(numbers)])


def _length(length: Any, unit: str = "") -> Value:
    """The length of the vector, in the unit of its coordinates if they have one."""
    dimension = LENGTH if unit else NUMBER
    found = value("length", length, unit or "1", letter="r")
    return found._replace(dimensions=(dimension,))


def _rows(
    polar: Any, azimuth: Any, vector: tuple[float, float, float], given: Inputs
) -> list[Value]:
    """The results that both have; an angle that was given as it was given."""
    x, y, z = vector
    found = {"polar": polar, "azimuth": azimuth, "elevation": math.atan2(z, math.hypot(x, y))}
    rows = [
        known(given[name]) if name in given else value(name, angle) for name, angle in found.items()
    ]
    rows += [value(name, size, label=name) for name, size in zip("xyz", vector, strict=True)]
    return rows
