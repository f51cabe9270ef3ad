"""A direction, in spherical coordinates and as a unit vector."""

import math
from typing import Any

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import inputs as i
from radcalc.calculators.inputs import Inputs
from radcalc.conversion.conditions import LENGTH, degrees, require, show
from radcalc.geometry.directions import cartesian, spherical
from radcalc.units.table import NUMBER

CONVENTION = "polar angle from +z, azimuth from +x towards +y (ISO 80000-2)"
POLE = "at a pole every azimuth is right"
LEAST = 2**-53  # of a unit vector's coordinate: below it is what the angle's rounding makes of 0


def of_vector(x: float, y: float, z: float, unit: str = "") -> Answer:
    """The direction of a vector; its coordinates in SI units where they had a unit."""
    polar, azimuth, length = spherical(x, y, z)
    unit_vector = (x / length, y / length, z / length)
    notes = []
    if not (x or y):
        notes = [f"{POLE}, and 0 is given"]
    shown = unit or "1"
    dimension = LENGTH if unit else NUMBER
    rows = [*_rows(polar, azimuth, unit_vector, {})]
    rows.append(Value("length", "length", "r", length, (dimension,), (shown,)))
    steps = [
        Step(
            "polar angle",
            "theta = atan2(sqrt(x^2 + y^2), z)",
            f"theta = atan2({show(math.hypot(x, y))}, {show(z)}) = {degrees(polar)}",
        ),
        Step(
            "azimuth",
            "phi = atan2(y, x)",
            f"phi = atan2({show(y)}, {show(x)}) = {degrees(azimuth)}",
        ),
    ]
    said = [CONVENTION, "x, y and z are those of the unit vector"]
    return rows, said, notes, steps


def of_angles(given: Inputs) -> Answer:
    """The unit vector of a polar angle or an elevation, and an azimuth."""
    i.only(given, ("polar", "elevation", "azimuth"), "a direction")
    one = i.one_of(given, "the polar angle or the elevation", "polar", "elevation")
    azimuth = i.one_of(given, "the azimuth", "azimuth").value
    if one.option.name == "elevation":
        require(one, abs(one.value) <= math.pi / 2 * (1 + 1e-12), "from -90 to 90 deg")
    else:
        require(one, 0 <= one.value <= math.pi * (1 + 1e-12), "from 0 to 180 deg")
    polar = one.value if one.option.name == "polar" else math.pi / 2 - one.value
    x, y, z = cartesian(polar, azimuth)
    if one.option.name == "elevation":
        z = math.sin(one.value)  # without the rounding of a right angle
        x, y = math.cos(one.value) * math.cos(azimuth), math.cos(one.value) * math.sin(azimuth)
    x, y, z = (0.0 if abs(size) < LEAST else size for size in (x, y, z))
    step = Step(
        "unit vector",
        "x = sin(theta) cos(phi), y = sin(theta) sin(phi), z = cos(theta)",
        f"theta = {degrees(polar)}, phi = {degrees(azimuth)}; "
        f"x = {show(x)}, y = {show(y)}, z = {show(z)}",
    )
    rows = _rows(polar, azimuth, (x, y, z), given)
    rows.append(Value("length", "length", "r", 1.0, (NUMBER,), ("1",)))
    notes = [POLE] if not (x or y) else []
    return rows, [CONVENTION], notes, [step]


def _rows(
    polar: Any, azimuth: Any, vector: tuple[float, float, float], given: Inputs
) -> list[Value]:
    """The results that both have; an angle that was given as it was given."""
    x, y, z = vector
    found = {"polar": polar, "azimuth": azimuth, "elevation": math.atan2(z, math.hypot(x, y))}
    rows = [
        i.known(given[name]) if name in given else i.value(name, angle, "deg")
        for name, angle in found.items()
    ]
    rows += [
        Value(name, name, name, size, (NUMBER,), ("1",))
        for name, size in zip("xyz", vector, strict=True)
    ]
    return rows
