"""A direction, or what a mirror makes of it, in spherical coordinates and as a unit vector."""

import math
from typing import Any

from radcalc.answer import Answer, Step, Value
from radcalc.calculators.results import known, value
from radcalc.calculators.worksheet import refuse_foreign
from radcalc.derivation import Formula, format_angle, format_number
from radcalc.errors import ConditionError, Exclusive, option, quote
from radcalc.geometry.directions import cartesian, mirror_normal, reflected, spherical
from radcalc.geometry.numerics.vectors import cross, dot, length, unit
from radcalc.geometry.projections import direction_at, is_outside, place_of
from radcalc.given import Given, Inputs, Point, one_of
from radcalc.maths import SLACK, atan2, cos, hypot, sin, sqrt
from radcalc.quantities.symbols import MIRROR_BALL
from radcalc.units.dimensions import LENGTH
from radcalc.units.table import NUMBER

ANGLES, MIRRORS = ("polar", "elevation", "azimuth"), ("reflect-at", "reflect-to")
ON_BALL = ("mirror-ball-u", "mirror-ball-v", "mirror-ball-w")
CONVENTION = "polar angle from +z, azimuth from +x towards +y (ISO 80000-2)"
UNIT = "x, y and z are those of the unit vector"
AWAY = "the direction d and its reflection r point away from the mirror"
BALL_AXES = (
    "a mirror ball seen along -z, from far away: x to the right, y up, z towards the camera; "
    "u, v and w are x, y and z of its normal there"
)
POLAR = Formula("polar angle", "theta = atan2(sqrt(x^2 + y^2), z)")
AZIMUTH = Formula("azimuth", "phi = atan2(y, x)")
UNIT_VECTOR = Formula(
    "unit vector", "x = sin(theta) cos(phi), y = sin(theta) sin(phi), z = cos(theta)"
)
REFLECTION = Formula("reflection", "r = 2 (n.d) / (n.n) n - d")
BISECTOR = Formula("normal of the mirror", "n = d/|d| + r/|r|, over its length")
BALL = Formula("mirror ball", "(x, y, z) = (2 u w, 2 v w, 2 w^2 - 1), w = sqrt(1 - u^2 - v^2)")
POLE = "at a pole every azimuth is right"
LEAST = 2**-53  # of a unit vector's coordinate: below it is what the angle's rounding makes of 0


def direction(
    given: Inputs, vector: Point | None = None, unit: str = "", with_ball: bool = False
) -> Answer:
    """The answer to a direction that is given by its coordinates, its angles or a mirror ball.

    `given` are the angles or the place on the ball, and the mirror that reflects it; a `vector`
    is in SI units where its coordinates had a `unit`.  `with_ball` adds the place on a mirror
    ball that shows what is found.
    """
    refuse_foreign(given, (*ANGLES, *MIRRORS, "mirror-ball"), "a direction")
    if "mirror-ball" in given:
        for name in (*ANGLES, *MIRRORS):
            if name in given:
                raise Exclusive(("mirror-ball", name))
        return _of_ball(given["mirror-ball"])
    if all(name in given for name in MIRRORS):
        raise Exclusive(MIRRORS)
    if any(name in given for name in MIRRORS):
        answer = _mirrored(given, vector, unit)
    elif vector:
        answer = of_vector(*vector, unit)
    else:
        answer = of_angles(given)
    return _on_ball(answer) if with_ball else answer


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
    return Answer(rows, [CONVENTION, UNIT], notes, steps)


def of_angles(given: Inputs) -> Answer:
    """The unit vector of a polar angle or an elevation, and an azimuth."""
    polar, azimuth, vector, step = _from_angles(given)
    rows = [*_rows(polar, azimuth, vector, given), _length(1.0)]
    notes = [] if any(vector[:2]) else [POLE]
    return Answer(rows, [CONVENTION], notes, [step])


def _from_angles(given: Inputs) -> tuple[float, float, Point, Step]:
    """Polar angle, azimuth and unit vector, with its derivation."""
    one = one_of(given, "the polar angle or the elevation", "polar", "elevation")
    azimuth = one_of(given, "the azimuth", "azimuth").value
    polar = one.value if one.name == "polar" else math.pi / 2 - one.value
    x, y, z = cartesian(polar, azimuth)
    if one.name == "elevation":
        z = sin(one.value)  # without the rounding of a right angle
        x, y = cos(one.value) * cos(azimuth), cos(one.value) * sin(azimuth)
    x, y, z = _without_rounding((x, y, z), LEAST)
    numbers = f"theta = {format_angle(polar)}, phi = {format_angle(azimuth)}; "
    numbers += f"x = {format_number(x)}, y = {format_number(y)}, z = {format_number(z)}"
    return polar, azimuth, (x, y, z), UNIT_VECTOR.told(numbers)


def _without_rounding(vector: Point, least: float) -> Point:
    x, y, z = (0.0 if abs(size) < least else size for size in vector)
    return x, y, z


def _mirrored(given: Inputs, vector: Point | None, unit: str) -> Answer:
    """The reflection of a direction, or the normal of the mirror that reflects it."""
    steps = []
    if vector is None:
        *_, vector, step = _from_angles(given)
        steps.append(step)
    size = spherical(*vector)[2]
    told = f"d = {_told(vector)}"
    if "reflect-at" in given:
        normal = given["reflect-at"].value
        incidence = _angle(vector, normal)
        _refuse_behind(given["reflect-at"], incidence)
        found = _without_rounding(reflected(vector, normal), 4 * LEAST * size)
        told += f", n = {_told(normal)}; r = {_told(found)}"
        steps.append(REFLECTION.told(told))
        meant = "the results are those of the reflection"
    else:
        to = given["reflect-to"].value
        found, unit = _without_rounding(mirror_normal(vector, to), 4 * LEAST), ""
        incidence = _angle(vector, found)
        steps.append(BISECTOR.told(f"{told}, r = {_told(to)}; n = {_told(found)}"))
        meant = "the results are those of the mirror's normal"
    answer = of_vector(*found, unit)
    return answer._replace(
        values=[*answer.values, value("incidence", incidence)],
        assumptions=[*answer.assumptions, f"{AWAY}; {meant}"],
        steps=[*steps, *answer.steps],
    )


def _angle(one: Point, other: Point) -> float:
    """The angle between two vectors, to all digits."""
    a, b = unit(one), unit(other)
    return math.atan2(length(cross(a, b)), dot(a, b))


def _refuse_behind(normal: Given, incidence: float) -> None:
    """Refuse a direction from which only the back of a mirror is seen."""
    if incidence > math.pi / 2 * (1 + SLACK):
        turned = ",".join(format_number(-one, 15) for one in normal.value)
        raise ConditionError(
            f"{option('reflect-at', quote(normal.text))}: the direction is behind the mirror, "
            f"{format_angle(incidence)} from its normal",
            f"{option('reflect-at', turned)} for its other side",
        )


def _told(vector: Point) -> str:
    return f"({', '.join(map(format_number, vector))})"


def _of_ball(place: Given) -> Answer:
    """The direction that a mirror ball shows at a place."""
    u, v = place.value
    if is_outside(MIRROR_BALL, u, v):
        aside = format_number(hypot(u, v))
        raise ConditionError(
            f"{option('mirror-ball', quote(place.text))} is beside the ball, {aside} times its "
            "radius from the middle",
            "u and v with u^2 + v^2 of at most 1",
        )
    z, x, y = direction_at(MIRROR_BALL, u, v)  # whose x is towards the camera
    answer = _on_ball(of_vector(x, y, z), (u, v))
    w = next(one.si for one in answer.values if one.name == "mirror-ball-w")
    told = f"u = {format_number(u)}, v = {format_number(v)}, w = {format_number(w)}; "
    step = BALL.told(f"{told}(x, y, z) = {_told((x, y, z))}")
    notes = ["at its rim the ball shows what is behind it"] if w == 0 else []
    return answer._replace(
        assumptions=[CONVENTION, BALL_AXES],
        notes=[*notes, *answer.notes],
        steps=[step, *answer.steps],
    )


def _on_ball(answer: Answer, given: tuple[float, float] | None = None) -> Answer:
    """An answer with the place on a mirror ball that shows its direction, and the normal there."""
    found = {one.name: one.si for one in answer.values}
    x, y, z = (found[name] for name in "xyz")
    u, v = given or place_of(MIRROR_BALL, z, x, y)
    # 1 + z, next to -z without losing digits
    w = sqrt((1 + z) / 2) if z > 0 else hypot(x, y) / sqrt(2 * (1 - z))
    rows = [value(name, size) for name, size in zip(ON_BALL, (u, v, w), strict=True)]
    if given:
        rows[:2] = [row._replace(given=row.si) for row in rows[:2]]
    return answer._replace(
        values=[*answer.values, *rows], assumptions=[*answer.assumptions, BALL_AXES]
    )


def _length(length: Any, unit: str = "") -> Value:
    """The length of the vector, in the unit of its coordinates if they have one."""
    dimension = LENGTH if unit else NUMBER
    found = value("length", length, unit or "1", letter="r")
    return found._replace(dimensions=(dimension,))


def _rows(polar: Any, azimuth: Any, vector: Point, given: Inputs) -> list[Value]:
    """The results that both have; an angle that was given as it was given."""
    x, y, z = vector
    found = {"polar": polar, "azimuth": azimuth, "elevation": atan2(z, hypot(x, y))}
    rows = [
        known(given[name]) if name in given else value(name, angle) for name, angle in found.items()
    ]
    rows += [value(name, size, label=name) for name, size in zip("xyz", vector, strict=True)]
    return rows
